#include "emit/json.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace treedyn::emit {

namespace {

/// Length of the UTF-8 sequence that begins `text` (RFC 3629), 0 if it is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<std::uint8_t>(text[k]) : std::uint8_t{0};
  };
  const auto continues = [&](std::size_t k) {
    return (byte(k) & 0xC0U) == 0x80U;
  };
  const unsigned first = byte(0);
  const unsigned second = byte(1);
  if (first < 0x80U) {
    return 1;
  }
  if (first >= 0xC2U && first <= 0xDFU) {
    return continues(1) ? 2 : 0;
  }
  if ((first & 0xF0U) == 0xE0U) {
    const bool valid = !(first == 0xE0U && second < 0xA0U) && !(first == 0xEDU && second > 0x9FU);
    return valid && continues(1) && continues(2) ? 3 : 0;
  }
  if (first >= 0xF0U && first <= 0xF4U) {
    const bool valid = !(first == 0xF0U && second < 0x90U) && !(first == 0xF4U && second > 0x8FU);
    return valid && continues(1) && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

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

std::string json_object(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string result = "{";
  for (const auto& [key, value] : members) {
    result += fmt::format("{}{}: {}", result.size() > 1 ? ", " : "", json_string(key), value);
  }
  return result + "}";
}

std::string json_lines(const std::vector<std::string>& values, int indentation) {
  std::string result = "[";
  for (const std::string& value : values) {
    result += fmt::format("{}\n{:{}}{}", result.size() > 1 ? "," : "", "", indentation, value);
  }
  return result + "]";
}

}  // namespace treedyn::emit
