#include "emit/json.hpp"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "common/transformed.hpp"
#include "common/utf8.hpp"

namespace treedyn::emit {

namespace {

std::string escaped(char c) {
  switch (c) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return static_cast<std::uint8_t>(c) < 0x20U || c == '\x7f'
                 ? fmt::format("\\u{:04x}", static_cast<std::uint8_t>(c))
                 : std::string(1, c);
  }
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string result = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      result += "\\ufffd";
    } else if (length == 1) {
      result += escaped(text.front());
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result + "\"";
}

std::vector<std::string> json_strings(const std::vector<std::string>& texts) {
  return transformed(texts, json_string);
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string json_object(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string result = "{";
  for (const auto& [key, value] : members) {
    result += fmt::format("{}{}: {}", result.size() > 1 ? ", " : "", json_string(key), value);
  }
  return result + "}";
}

std::string json_list(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string json_lines(const std::vector<std::string>& values, int indentation) {
  std::string result = "[";
  for (const std::string& value : values) {
    result += fmt::format("{}\n{:{}}{}", result.size() > 1 ? "," : "", "", indentation, value);
  }
  return result + "]";
}

}  // namespace treedyn::emit
