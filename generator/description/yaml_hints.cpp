#include "description/yaml_hints.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/index.hpp"

namespace treedyn::description {

namespace {

/// A line of the text, counted from 1; empty beyond the end.
std::string_view line_of(std::string_view text, int number) {
  for (int k = 1; k < number; ++k) {
    const std::size_t end = text.find('\n');
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The word before `end`: "q" of "-5*q[elbow]".
std::string_view word_before(std::string_view line, std::size_t end) {
  std::size_t start = end;
  while (start > 0 && is_word_byte(line[start - 1])) {
    --start;
  }
  return line.substr(start, end - start);
}

/// "name" of a line "  -name: a"; empty otherwise.
std::string_view word_behind_dash(std::string_view line) {
  const std::size_t dash = line.find_first_not_of(' ');
  if (dash == std::string_view::npos || line[dash] != '-') {
    return {};
  }
  std::size_t end = dash + 1;
  while (end < line.size() && is_word_byte(line[end])) {
    ++end;
  }
  const bool key = end > dash + 1 && end < line.size() && line[end] == ':';
  return key ? line.substr(dash + 1, end - dash - 1) : std::string_view();
}

}  // namespace

std::string yaml_message(const std::string& text, const Place& where, const std::string& problem) {
  const std::string_view line = line_of(text, where.line);
  const std::size_t at = std::min(to_index(std::max(where.column - 1, 0)), line.size());
  if (contains(problem, "tab character") || (at < line.size() && line[at] == '\t')) {
    return "line is indented by a tab; expected spaces";
  }
  const std::string_view word = at < line.size() && line[at] == '[' ? word_before(line, at) : "";
  if (!word.empty() && contains(problem, "did not find expected ','")) {
    return fmt::format(
        "'{}[' inside of {{ }} or [ ] begins a list; expected quotes around an "
        "expression with brackets, \"{}[..]\"",
        shown(word), shown(word));
  }
  for (const int number : {where.line, where.line - 1}) {
    if (const std::string_view key = word_behind_dash(line_of(text, number)); !key.empty()) {
      return fmt::format("'-{0}' has no space behind '-'; expected '- {0}'", shown(key));
    }
  }
  if (contains(problem, "could not find expected ':'")) {
    return "line has no key and value; expected 'key: value', with a space behind ':'";
  }
  if (contains(problem, "mapping values are not allowed") && contains(line.substr(0, at), ": ")) {
    return "second ':' in one line; expected quotes around a text with ': '";
  }
  if (contains(problem, "mapping values are not allowed") ||
      contains(problem, "expected '-' indicator") || contains(problem, "expected key")) {
    return "indentation does not fit the lines before; expected entries of one list or mapping in "
           "one column";
  }
  return fmt::format("{}; expected YAML or JSON", problem);
}

}  // namespace treedyn::description
