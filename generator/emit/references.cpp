#include "emit/references.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "common/identifier.hpp"

namespace treedyn::emit {

namespace {

/// The word at a place of code, empty where none begins.
std::string_view word_at(std::string_view code, std::size_t at) {
  std::size_t end = at;
  while (end < code.size() && is_word_byte(code[end])) {
    ++end;
  }
  return at > 0 && is_word_byte(code[at - 1]) ? std::string_view{} : code.substr(at, end - at);
}

/// Where the argument that begins at a place ends: at a comma or the bracket.
std::size_t end_of_argument(const std::string& code, std::size_t at) {
  for (int depth = 0; at < code.size(); ++at) {
    if (depth == 0 && (code[at] == ',' || code[at] == ')')) {
      break;
    }
    depth += code[at] == '(' || code[at] == '[' ? 1 : code[at] == ')' || code[at] == ']' ? -1 : 0;
  }
  return at;
}

}  // namespace

std::string with_addresses(std::string body, const ReferencePlaces& by_reference) {
  for (std::size_t at = 0; at < body.size(); ++at) {
    const auto called = by_reference.find(std::string(word_at(body, at)));
    if (called == by_reference.end() || body[at + called->first.size()] != '(') {
      continue;
    }
    std::size_t argument = at + called->first.size() + 1;
    for (std::ptrdiff_t place = 0; body[argument - 1] != ')'; ++place) {
      argument = std::min(body.find_first_not_of(" \n", argument), body.size());
      if (called->second.contains(place)) {
        body.insert(argument, 1, '&');
      }
      argument = end_of_argument(body, argument) + 1;
    }
  }
  return body;
}

std::string with_pointers(const std::string& body, const std::set<std::string>& references) {
  std::string result;
  for (std::size_t at = 0; at < body.size();) {
    if (body.compare(at, 2, "//") == 0) {
      const std::size_t end = std::min(body.find('\n', at), body.size());
      result += body.substr(at, end - at);
      at = end;
      continue;
    }
    const std::string word(word_at(body, at));
    const bool is_member = at > 0 && body[at - 1] == '.';
    if (word.empty() || is_member || !references.contains(word)) {
      result += word.empty() ? std::string(1, body[at]) : word;
      at += std::max<std::size_t>(word.size(), 1);
      continue;
    }
    at += word.size();
    if (body.compare(at, 1, ".") == 0) {
      result += word + "->";
      ++at;
    } else if (result.ends_with('&') && !result.ends_with("&&")) {
      result.back() = word.front();
      result += word.substr(1);
    } else {
      result += fmt::format("(*{})", word);
    }
  }
  return result;
}

}  // namespace treedyn::emit
