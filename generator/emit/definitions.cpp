#include "emit/definitions.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "emit/layout.hpp"

namespace treedyn::emit {

namespace {

/// Behind what may stand in front of the type of a function.
std::size_t begin_of_type(std::string_view line) {
  constexpr std::array<std::string_view, 4> kBefore = {"static ", "inline ", "NOINLINE ",
                                                       "[[gnu::noinline]] "};
  std::size_t at = 0;
  for (const std::string_view word : kBefore) {
    at += line.substr(at).starts_with(word) ? word.size() : 0;
  }
  return at;
}

}  // namespace

Lines lines_of(const std::string& text) {
  Lines result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    result.push_back(line);
  }
  return result;
}

std::string gathered(const Lines& lines, std::size_t& at, char end) {
  std::string result = lines[at];
  while (!result.ends_with(end) && at + 1 < lines.size()) {
    const std::string& next = lines[++at];
    result += (result.ends_with('(') ? "" : " ") + next.substr(next.find_first_not_of(' '));
  }
  return result;
}

Declaration declaration_of(const std::string& line) {
  const std::size_t open = line.find('(');
  const std::size_t close = line.rfind(')');
  Declaration result{line.substr(0, open), {}, line.substr(close + 1)};
  std::string list = line.substr(open + 1, close - open - 1);
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(", "), list.size());
    result.arguments.push_back(list.substr(0, end));
    list.erase(0, end + 2);
  }
  return result;
}

bool begins_function(const std::string& line) {
  constexpr std::array<std::string_view, 7> kTypes = {"void ",  "int ",    "bool ",     "Scalar ",
                                                      "float ", "double ", "SineCosine"};
  return line.find('(') != std::string::npos && !line.ends_with(';') &&
         std::ranges::any_of(kTypes, [&](std::string_view type) { return line.starts_with(type); });
}

std::string placed(const std::string& source, const std::string& section) {
  const Lines lines = lines_of(source);
  Lines result;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    const std::size_t type = begin_of_type(lines[at]);
    if (!begins_function(lines[at].substr(type))) {
      result.push_back(lines[at]);
      continue;
    }
    const std::string before = lines[at].substr(0, type) + section + ' ';
    if (lines[at].ends_with('}')) {
      result.push_back(before + lines[at].substr(type));
      continue;
    }
    const Declaration parts = declaration_of(gathered(lines, at, '{').substr(type));
    result.push_back(declaration(before + parts.head, parts.arguments, parts.ending));
  }
  const std::string text = fmt::format("{}\n", fmt::join(result, "\n"));
  const std::size_t include = text.find("#include \"");
  const std::size_t place = text.find('\n', include) + 1;
  return text.substr(0, place) +
         fmt::format(
             "\n#ifndef {0}\n#error \"define {0}, for instance as "
             "__attribute__((section(\\\".ram_code\\\")))\"\n#endif\n",
             section) +
         text.substr(place);
}

}  // namespace treedyn::emit
