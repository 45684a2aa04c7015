#include "common/identifier.hpp"

#include <algorithm>

namespace treedyn {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_word_byte(char c) { return is_letter(c) || is_digit(c); }

std::string to_identifier(std::string_view name) {
  std::string result(name);
  std::ranges::replace_if(
      result, [](char c) { return !is_word_byte(c); }, '_');
  if (result.empty() || result.front() == '_' || is_digit(result.front())) {
    result.insert(result.begin(), 'n');
  }
  return is_reserved_word(result) ? result + "_" : result;
}

}  // namespace treedyn
