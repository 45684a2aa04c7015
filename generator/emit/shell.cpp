#include "emit/shell.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "common/utf8.hpp"

namespace treedyn::emit {

namespace {

bool is_plain(char c) {
  constexpr std::string_view kPlain = "-.,:=/+%@";
  return is_word_byte(c) || kPlain.find(c) != std::string_view::npos;
}

bool needs_no_quotes(const std::string& word) {
  return !word.empty() && std::ranges::all_of(word, is_plain);
}

/// Escapes for every byte that is not plain.
std::string with_octal_escapes(const std::string& word) {
  std::string result = "$'";
  for (const char c : word) {
    result += is_plain(c) || c == ' ' ? std::string(1, c)
                                      : fmt::format("\\{:03o}", static_cast<std::uint8_t>(c));
  }
  return result + "'";
}

/// True for UTF-8 without control characters, those beyond ASCII (U+0080 to U+009F) as well.
bool is_printable(std::string_view text) {
  while (!text.empty()) {
    const auto byte = static_cast<std::uint8_t>(text.front());
    const std::size_t length = utf8_length(text);
    const bool control =
        byte < 0x20U || byte == 0x7fU ||
        (byte == 0xc2U && length == 2 && static_cast<std::uint8_t>(text[1]) < 0xa0U);
    if (length == 0 || control) {
      return false;
    }
    text.remove_prefix(length);
  }
  return true;
}

std::string for_terminal(const std::string& word) {
  if (needs_no_quotes(word)) {
    return word;
  }
  if (!is_printable(word)) {
    return with_octal_escapes(word);
  }
  std::string result = "'";
  for (const char c : word) {
    result += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return result + "'";
}

/// Trigraphs and what could end a comment or a line are escaped.
std::string word_in_comment(const std::string& word) {
  if (needs_no_quotes(word)) {
    return word;
  }
  const bool simple =
      std::ranges::all_of(word, [](char c) { return is_plain(c) || c == ' ' || c == '('; });
  return simple ? "'" + word + "'" : with_octal_escapes(word);
}

std::string line_of(const std::vector<std::string>& words,
                    std::string (*quoted)(const std::string&)) {
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "" : " ";
    line += quoted(word);
  }
  return line;
}

}  // namespace

std::string shell_line(const std::vector<std::string>& words) {
  return line_of(words, for_terminal);
}

std::string shell_comment(const std::vector<std::string>& words) {
  return line_of(words, word_in_comment);
}

}  // namespace treedyn::emit
