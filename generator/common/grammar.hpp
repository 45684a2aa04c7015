// The grammar of what models, scenes and equations write:
//
//     sum     := product { ("+" | "-") product }
//     product := factor { ("*" | "/") factor }
//     factor  := { "+" | "-" } primary [ "^" factor ]
//     primary := number | name .. | "(" sum ")"
//
// What a name begins is the reader's: calls, indices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/text_error.hpp"

namespace treedyn {

/// Recursive descent over one expression; the reader that derives from it knows what operations do
/// with values.
template <class Value>
class Grammar {
 public:
  struct Limits {
    std::size_t longest = 0;  ///< bytes
    int deepest = 0;          ///< nested parentheses and exponents
  };

  Grammar(std::string_view text, const Limits& limits) : text_(text), limits_(limits) {}
  Grammar(const Grammar&) = delete;
  Grammar& operator=(const Grammar&) = delete;
  virtual ~Grammar() = default;

  /// \throws TextError
  Value whole() {
    if (text_.size() > limits_.longest) {
      fail(0, fmt::format("expression of {} characters is too long; expected at most {}",
                          text_.size(), limits_.longest));
    }
    Value result = sum();
    if (!at_end()) {
      fail(at_, fmt::format("unexpected '{}'; expected an operator or the end", next()));
    }
    return result;
  }

 protected:
  /// Offsets of an operation.
  struct Places {
    std::size_t left = 0;
    std::size_t sign = 0;
    std::size_t right = 0;
  };

  /// \param operation  one of + - * /
  virtual Value combined(char operation, const Value& a, const Value& b, const Places& places) = 0;
  virtual Value power(const Value& base, const Value& exponent, const Places& places) = 0;
  virtual Value negative(const Value& x, std::size_t offset) = 0;
  virtual Value number(std::string_view written, const Real& value, std::size_t offset) = 0;
  /// What the name begins, read to its end.
  virtual Value named(std::string_view name, std::size_t offset) = 0;

  [[noreturn]] static void fail(std::size_t offset, const std::string& message) {
    throw TextError(offset, message);
  }

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::size_t at() const { return at_; }
  void go_to(std::size_t offset) { at_ = offset; }

  /// The next character after spaces, '\0' at the end.
  char peek() { return at_end() ? '\0' : text_[at_]; }
  bool take(char c) {
    const bool found = !at_end() && text_[at_] == c;
    at_ += found ? 1 : 0;
    return found;
  }
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  /// What follows the "(" at `start` up to and with ")".
  Value parenthesis(std::size_t start) {
    enter(start);
    Value inner = sum();
    if (!take(')')) {
      fail(at_end() ? start : at_,
           at_end() ? "'(' is not closed; expected ')'"
                    : fmt::format("unexpected '{}'; expected an operator or ')'", next()));
    }
    --depth_;
    return inner;
  }

 private:
  /// True if nothing but spaces follows, which are skipped.
  bool at_end() {
    while (at_ < text_.size() && is_space(text_[at_])) {
      ++at_;
    }
    return at_ == text_.size();
  }

  /// The next word or character, for messages.
  [[nodiscard]] std::string next() const {
    std::size_t end = at_;
    while (end < text_.size() && is_word_byte(text_[end])) {
      ++end;
    }
    return shown(text_.substr(at_, std::max<std::size_t>(end - at_, 1)));
  }

  void enter(std::size_t place) {
    if (++depth_ > limits_.deepest) {
      fail(place, fmt::format("expression is nested too deeply; expected at most {} levels",
                              limits_.deepest));
    }
  }

  Value sum() { return chain("+-", &Grammar::product); }
  Value product() { return chain("*/", &Grammar::factor); }

  /// Operands with one of the operations between them, from the left.
  Value chain(std::string_view operations, Value (Grammar::*operand)()) {
    const std::size_t start = at_;
    Value left = (this->*operand)();
    while (!at_end() && operations.find(text_[at_]) != std::string_view::npos) {
      const std::size_t sign = at_++;
      left = combined(text_[sign], left, (this->*operand)(), {start, sign, sign + 1});
    }
    return left;
  }

  Value factor() {
    const char first = peek();
    const std::size_t start = at_;
    bool is_negative = false;
    for (char c = first; c == '+' || c == '-'; c = peek()) {
      is_negative = is_negative != (c == '-');
      ++at_;
    }
    Value x = raised();
    return is_negative ? negative(x, start) : x;
  }

  Value raised() {
    peek();
    const std::size_t start = at_;
    Value base = primary();
    if (!take('^')) {
      return base;
    }
    const std::size_t right = at_;
    enter(right);
    const Value exponent = factor();
    --depth_;
    return power(base, exponent, {start, right - 1, right});
  }

  Value primary() {
    const char c = peek();
    const std::size_t start = at_;
    if (at_end()) {
      fail(start, "expression ends too early; expected a number, a name or '('");
    }
    if (is_digit(c) || c == '.') {
      return decimal();
    }
    if (take('(')) {
      return parenthesis(start);
    }
    if (!is_letter(c)) {
      fail(start, fmt::format("unexpected '{}'; expected a number, a name or '('", next()));
    }
    while (at_ < text_.size() && is_word_byte(text_[at_])) {
      ++at_;
    }
    return named(text_.substr(start, at_ - start), start);
  }

  void skip_digits() {
    while (at_ < text_.size() && is_digit(text_[at_])) {
      ++at_;
    }
  }

  /// True if the next character is one of `wanted`, which is skipped.
  bool skip(std::string_view wanted) {
    const bool found = at_ < text_.size() && wanted.find(text_[at_]) != std::string_view::npos;
    at_ += found ? 1 : 0;
    return found;
  }

  Value decimal() {
    const std::size_t start = at_;
    skip_digits();
    if (skip(".")) {
      skip_digits();
    }
    if (skip("eE")) {
      skip("+-");
      skip_digits();
    }
    const std::string_view written = text_.substr(start, at_ - start);
    const Decimal read = read_decimal(written);
    if (read.error == DecimalError::kSyntax) {  // with what follows up to an operator
      const std::size_t end = std::min(text_.find_first_of(" \t\r\n+-*/^()", start), text_.size());
      fail(start, describe(read.error, text_.substr(start, end - start)));
    }
    if (!read) {
      fail(start, describe(read.error, written));
    }
    return number(written, read.value, start);
  }

  std::string_view text_;
  Limits limits_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace treedyn
