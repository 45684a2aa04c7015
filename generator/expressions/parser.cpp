#include "expressions/parser.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/grammar.hpp"
#include "common/index.hpp"
#include "expressions/exact.hpp"

namespace treedyn::expressions {

namespace {

constexpr std::size_t kMaxLength = 1000;  // characters of an expression
constexpr std::size_t kMaxDigits = 100;   // of a number in it
constexpr int kMaxDepth = 50;             // nested parentheses, functions and exponents
constexpr std::size_t kMaxSize = 5000;    // operations after substitution of parameters
constexpr std::size_t kMaxBits = 8000;    // numerator or denominator of an exact rational
constexpr int kMaxExponent = 64;          // numerator or denominator of an exponent

class Parser : public Grammar<Exact> {
 public:
  Parser(std::string_view text, const Names& names, const Variables* variables)
      : Grammar(text, {kMaxLength, kMaxDepth}), names_(names), variables_(variables) {}

 private:
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
      if (to_index(std::max(x.numer().int_length(), x.denom().int_length())) > kMaxBits) {
        fail(start, "exact value has too many digits; expected at most 2400");
      }
    }
    return {value, size};
  }

  Exact combined(char operation, const Exact& a, const Exact& b, const Places& places) override {
    if (operation == '/') {
      expect_not_zero(places.right, b.value);
    }
    const GiNaC::ex value = operation == '+'   ? a.value + b.value
                            : operation == '-' ? a.value - b.value
                            : operation == '*' ? a.value * b.value
                                               : a.value / b.value;
    return checked(places.left, value, a.size + b.size + 1);
  }

  static void expect_not_zero(std::size_t start, const GiNaC::ex& divisor) {
    if (divisor.is_zero() || (is_constant(divisor) && to_real(divisor) == 0)) {
      fail(start, "division by zero; expected a divisor that is not zero");
    }
  }

  Exact negative(const Exact& x, std::size_t /*offset*/) override { return {-x.value, x.size}; }

  Exact power(const Exact& base, const Exact& exponent, const Places& places) override {
    const bool constant = is_constant(base.value);
    const GiNaC::ex value = constant ? tidied(base.value) : base.value;
    expect_power(places.left, places.right, value, exponent.value);
    const std::size_t times = constant ? 1 : expect_variable_power(places.right, exponent.value);
    const std::size_t size = base.size * times + exponent.size + 1;
    check_size(places.left, size);
    return checked(places.left, GiNaC::pow(value, exponent.value), size);
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
    if (value != 0 && abs(log(abs(value)) * e.to_double()) > 300 * log(Real(10))) {
      fail(start, "power is out of range; expected a magnitude from 1e-300 to 1e300");
    }
  }

  /// Of a base with variables. \return |exponent| rounded up
  static std::size_t expect_variable_power(std::size_t place, const GiNaC::ex& exponent) {
    const auto& e = GiNaC::ex_to<GiNaC::numeric>(exponent);
    if (e.denom() > 2) {
      fail(place, "exponent of a variable is no multiple of 1/2; expected one such as -1, 1/2, 2");
    }
    return to_index(abs(e.numer()).to_int()) + 1;
  }

  Exact number(std::string_view written, const Real& value, std::size_t offset) override {
    if (written.size() > kMaxDigits) {
      fail(offset, fmt::format("number of {} characters is too long; expected at most {}",
                               written.size(), kMaxDigits));
    }
    return {value == 0 ? GiNaC::ex(0) : exact_decimal(written), 1};
  }

  Exact named(std::string_view word, std::size_t start) override {
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
    if (at() < text().size() && text()[at()] == '[') {
      const std::size_t end = text().find(']', at());
      if (end == std::string_view::npos) {
        fail(at(), "'[' is not closed; expected ']'");
      }
      index = text().substr(at() + 1, end - at() - 1);
      go_to(end + 1);
    }
    const std::optional<GiNaC::ex> found = variables_->find(word, index);
    if (!found) {
      const std::string_view written = text().substr(start, at() - start);
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
    Exact argument = parenthesis(at() - 1);
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

  const Names& names_;
  const Variables* variables_;
};

}  // namespace

bool is_constant(const GiNaC::ex& value) {
  return std::none_of(value.preorder_begin(), value.preorder_end(),
                      [](const GiNaC::ex& part) { return GiNaC::is_a<GiNaC::symbol>(part); });
}

Exact parse(std::string_view text, const Names& names, const Variables* variables) {
  return guarded(text, [&] { return Parser(text, names, variables).whole(); });
}

TextError unreadable(std::string_view text, const std::exception& problem) {
  return TextError(0, fmt::format("'{}' cannot be evaluated ({})", shown(text), problem.what()));
}

}  // namespace treedyn::expressions
