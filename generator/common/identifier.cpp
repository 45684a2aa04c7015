#include "common/identifier.hpp"

#include <algorithm>

namespace treedyn {

namespace {

bool is_identifier_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::string to_identifier(std::string_view name) {
  std::string result(name);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return !is_identifier_byte(c); }, '_');
  if (result.empty() || result.front() == '_' || (result.front() >= '0' && result.front() <= '9')) {
    result.insert(result.begin(), 'n');
  }
  return is_reserved_word(result) ? result + "_" : result;
}

}  // namespace treedyn
