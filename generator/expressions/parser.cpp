#include "expressions/parser.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "expressions/exact.hpp"

namespace treedyn::expressions {

namespace {

constexpr std::size_t kMaxLength = 1000;  // characters of an expression
constexpr std::size_t kMaxDigits = 100;   // of a number in it
constexpr int kMaxDepth = 50;             // nested parentheses, functions and exponents
constexpr std::size_t kMaxSize = 5000;    // operations after substitution of parameters
constexpr std::size_t kMaxBits = 8000;    // numerator or denominator of an exact rational
constexpr int kMaxExponent = 64;          // numerator or denominator of an exponent

/// Recursive descent over one expression; the grammar is in constant.hpp.
class Parser {
 public:
  Parser(std::string_view text, const Names& names, const Variables* variables)
      : text_(text), names_(names), variables_(variables) {}

  Exact whole() {
    Exact result = sum();
    skip_spaces();
    if (at_ < text_.size()) {
      fail(at_, fmt::format("unexpected '{}'; expected an operator or the end", rest()));
    }
    return result;
  }

 private:
  [[noreturn]] static void fail(std::size_t offset, const std::string& message) {
    throw ConstantError(offset, message);
  }

  /// The next word or character, for messages.
  [[nodiscard]] std::string rest() const {
    std::size_t end = at_;
    while (end < text_.size() && is_word_byte(text_[end])) {
      ++end;
    }
    return shown(text_.substr(at_, std::max<std::size_t>(end - at_, 1)));
  }

  /// The text from `start` up to a space, an operator or a parenthesis.
  [[nodiscard]] std::string_view word(std::size_t start) const {
    return text_.substr(start,
                        std::min(text_.find_first_of(" \t+-*/^()", start), text_.size()) - start);
  }

  void skip_spaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) {
      ++at_;
    }
  }

  bool take(char c) {
    skip_spaces();
    const bool found = at_ < text_.size() && text_[at_] == c;
    if (found) {
      ++at_;
    }
    return found;
  }

  static void check_size(std::size_t start, std::size_t size) {
    if (size > kMaxSize) {
      fail(start, fmt::format("expression of {} operations is too large; expected at most {}", size,
                              kMaxSize));
    }
  }

  static Exact checked(std::size_t start, const GiNaC::ex& value, std::size_t size) {
    check_size(start, size);
    if (GiNaC::is_a<GiNaC::numeric>(value)) {
      const auto& x = GiNaC::ex_to<GiNaC::numeric>(value);
      if (static_cast<std::size_t>(std::max(x.numer().int_length(), x.denom().int_length())) >
          kMaxBits) {
        fail(start, "exact value has too many digits; expected at most 2400");
      }
    }
    return {value, size};
  }

  Exact sum() {
    const std::size_t start = at_;
    Exact left = product();
    while (true) {
      if (take('+')) {
        const Exact right = product();
        left = checked(start, left.value + right.value, left.size + right.size + 1);
      } else if (take('-')) {
        const Exact right = product();
        left = checked(start, left.value - right.value, left.size + right.size + 1);
      } else {
        return left;
      }
    }
  }

  Exact product() {
    const std::size_t start = at_;
    Exact left = factor();
    while (true) {
      if (take('*')) {
        const Exact right = factor();
        left = checked(start, left.value * right.value, left.size + right.size + 1);
      } else if (take('/')) {
        const std::size_t divisor = at_;
        const Exact right = factor();
        expect_not_zero(divisor, right.value);
        left = checked(start, left.value / right.value, left.size + right.size + 1);
      } else {
        return left;
      }
    }
  }

  static void expect_not_zero(std::size_t start, const GiNaC::ex& divisor) {
    if (divisor.is_zero() || (is_constant(divisor) && to_real(divisor) == 0)) {
      fail(start, "division by zero; expected a divisor that is not zero");
    }
  }

  Exact factor() {
    bool negative = false;
    while (true) {
      if (take('-')) {
        negative = !negative;
      } else if (!take('+')) {
        break;
      }
    }
    Exact result = power();
    if (negative) {
      result.value = -result.value;
    }
    return result;
  }

  Exact power() {
    const std::size_t start = at_;
    Exact base = primary();
    if (!take('^')) {
      return base;
    }
    if (is_constant(base.value)) {
      base.value = tidied(base.value);
    }
    const std::size_t place = at_;
    enter(place);
    const Exact exponent = factor();
    --depth_;
    expect_power(start, place, base.value, exponent.value);
    const std::size_t times =
        is_constant(base.value) ? 1 : expect_variable_power(place, exponent.value);
    check_size(start, base.size * times + exponent.size + 1);
    return checked(start, GiNaC::pow(base.value, exponent.value),
                   base.size * times + exponent.size + 1);
  }

  static void expect_power(std::size_t start, std::size_t place, const GiNaC::ex& base,
                           const GiNaC::ex& exponent) {
    const bool rational = GiNaC::is_a<GiNaC::numeric>(exponent) &&
                          GiNaC::ex_to<GiNaC::numeric>(exponent).is_rational();
    const GiNaC::numeric e = rational ? GiNaC::ex_to<GiNaC::numeric>(exponent) : GiNaC::numeric(0);
    if (!rational || abs(e.numer()) > kMaxExponent || e.denom() > kMaxExponent) {
      fail(place, fmt::format("exponent is not simple; expected a ratio of integers up to {}",
                              kMaxExponent));
    }
    if (!is_constant(base)) {
      return;
    }
    const Real value = to_real(base);
    if (value == 0 && !e.is_positive()) {
      fail(start, "division by zero; expected a base that is not zero");
    }
    if (value < 0 && !e.is_integer()) {
      fail(start, "negative base with a fractional exponent; expected a base that is not negative");
    }
    if (value != 0 && abs(Real(log10(abs(value).digits())) * Real(e.to_double())) > 300) {
      fail(start, "power is out of range; expected a magnitude from 1e-300 to 1e300");
    }
  }

  /// Of a base with variables. \return |exponent| rounded up
  static std::size_t expect_variable_power(std::size_t place, const GiNaC::ex& exponent) {
    const auto& e = GiNaC::ex_to<GiNaC::numeric>(exponent);
    if (e.denom() > 2) {
      fail(place, "exponent of a variable is no multiple of 1/2; expected an integer or a root");
    }
    return static_cast<std::size_t>(abs(e.numer()).to_int()) + 1;
  }

  void enter(std::size_t place) {
    if (++depth_ > kMaxDepth) {
      fail(place,
           fmt::format("expression is nested too deeply; expected at most {} levels", kMaxDepth));
    }
  }

  Exact primary() {
    skip_spaces();
    const std::size_t start = at_;
    if (at_ == text_.size()) {
      fail(start, "expression ends too early; expected a number, a name or '('");
    }
    if (is_digit(text_[at_]) || text_[at_] == '.') {
      return number();
    }
    if (is_letter(text_[at_])) {
      return name();
    }
    if (take('(')) {
      return parenthesis(start);
    }
    fail(start, fmt::format("unexpected '{}'; expected a number, a name or '('", rest()));
  }

  /// What follows '(' up to and with ')'.
  Exact parenthesis(std::size_t start) {
    enter(start);
    Exact inner = sum();
    if (!take(')')) {
      fail(start, "'(' is not closed; expected ')'");
    }
    --depth_;
    return inner;
  }

  Exact number() {
    const std::size_t start = at_;
    const auto digits = [this] {
      while (at_ < text_.size() && is_digit(text_[at_])) {
        ++at_;
      }
    };
    digits();
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      digits();
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) {
        ++at_;
      }
      digits();
    }
    const std::string_view written = text_.substr(start, at_ - start);
    const Decimal decimal = read_decimal(written);
    if (!decimal) {
      fail(start,
           describe(decimal.error, decimal.error == DecimalError::kSyntax ? word(start) : written));
    }
    if (written.size() > kMaxDigits) {
      fail(start, fmt::format("number of {} characters is too long; expected at most {}",
                              written.size(), kMaxDigits));
    }
    return {decimal.value == 0 ? GiNaC::ex(0) : exact_decimal(written), 1};
  }

  Exact name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_word_byte(text_[at_])) {
      ++at_;
    }
    const std::string_view word = text_.substr(start, at_ - start);
    if (const FunctionRow* function = find_function(word)) {
      return call(*function, start);
    }
    if (word == "pi") {
      return {GiNaC::Pi, 1};
    }
    if (const auto known = names_.find(word); known != names_.end()) {
      return known->second;
    }
    if (variables_ != nullptr) {
      return variable(start, word);
    }
    fail(start, fmt::format("'{}' is unknown{}; expected a parameter, pi or one of sqrt, sin, cos, "
                            "tan, asin, acos, atan",
                            shown(word), hint(word)));
  }

  /// A name, or a name with an index in brackets.
  Exact variable(std::size_t start, std::string_view word) {
    std::optional<std::string_view> index;
    if (at_ < text_.size() && text_[at_] == '[') {
      const std::size_t end = text_.find(']', at_);
      if (end == std::string_view::npos) {
        fail(at_, "'[' is not closed; expected ']'");
      }
      index = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
    }
    const std::optional<GiNaC::ex> found = variables_->find(word, index);
    if (!found) {
      const std::string_view written = text_.substr(start, at_ - start);
      fail(start, fmt::format("'{}' is unknown{}; expected a parameter, pi, sqrt, sin, cos, tan{}",
                              shown(written), hint(written), variables_->expected()));
    }
    return {*found, 1};
  }

  /// What a typo may have meant.
  [[nodiscard]] std::string hint(std::string_view written) const {
    const std::vector<std::string> variables =
        variables_ == nullptr ? std::vector<std::string>{} : variables_->known();
    std::vector<std::string_view> known(variables.begin(), variables.end());
    for (const auto& [name, value] : names_) {
      known.emplace_back(name);
    }
    for (const FunctionRow& row : functions()) {
      known.push_back(row.name);
    }
    return did_you_mean(written, known);
  }

  Exact call(const FunctionRow& function, std::size_t start) {
    if (!take('(')) {
      fail(start, fmt::format("'{}' has no argument; expected '('", function.name));
    }
    Exact argument = parenthesis(at_ - 1);
    if (!is_constant(argument.value)) {
      if (!function.of_variables) {
        fail(start, fmt::format("{} of a variable is not available; expected sqrt, sin, cos or tan",
                                function.name));
      }
      const std::size_t size = function.name == "tan" ? 2 * argument.size + 3 : argument.size + 1;
      check_size(start, size);  // tan x is sin x / cos x
      return checked(start, function.apply(argument.value), size);
    }
    argument.value = tidied(argument.value);
    if (!function.accepts(to_real(argument.value))) {
      fail(start, fmt::format("{} of {} is not defined; expected {}", function.name,
                              to_real(argument.value).str(6), function.domain));
    }
    return checked(start, function.apply(argument.value), argument.size + 1);
  }

  std::string_view text_;
  const Names& names_;
  const Variables* variables_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

bool is_constant(const GiNaC::ex& value) {
  return std::none_of(value.preorder_begin(), value.preorder_end(),
                      [](const GiNaC::ex& part) { return GiNaC::is_a<GiNaC::symbol>(part); });
}

Exact parse(std::string_view text, const Names& names, const Variables* variables) {
  if (text.size() > kMaxLength) {
    throw ConstantError(
        0, fmt::format("expression of {} characters is too long; expected at most {}", text.size(),
                       kMaxLength));
  }
  const Precision precision;
  try {
    return Parser(text, names, variables).whole();
  } catch (const ConstantError&) {
    throw;
  } catch (const std::exception& problem) {  // GiNaC: poles; CLN: overflow
    throw unreadable(text, problem);
  }
}

ConstantError unreadable(std::string_view text, const std::exception& problem) {
  return ConstantError(0,
                       fmt::format("'{}' cannot be evaluated ({})", shown(text), problem.what()));
}

}  // namespace treedyn::expressions
