// Strings and lists in JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/transformed.hpp"

namespace treedyn::emit {

/// `text` in quotes: control characters escaped, bytes that are no UTF-8 replaced by U+FFFD.
std::string json_string(std::string_view text);

/// Every text as such.
std::vector<std::string> json_strings(const std::vector<std::string>& texts);

/// Shortest digits; JSON has no word for what is not finite: null.
std::string json_number(double value);

/// `{"key": value, ...}` on one line; the values are JSON already.
std::string json_object(const std::vector<std::pair<std::string, std::string>>& members);

/// `[value, ...]` on one line.
std::string json_list(const std::vector<std::string>& values);

template <class List>
std::string json_numbers(const List& values) {
  return json_list(transformed(values, json_number));
}

/// The same, one value a line at the given indentation; "[]" if there is none.
std::string json_lines(const std::vector<std::string>& values, int indentation);

}  // namespace treedyn::emit
