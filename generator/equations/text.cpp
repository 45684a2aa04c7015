#include "equations/text.hpp"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/grammar.hpp"
#include "equations/symbols.hpp"

namespace treedyn::equations {
namespace {

constexpr int kDeepest = 100;            // brackets and exponents
constexpr std::size_t kLongest = 20000;  // bytes
constexpr int kLargest = 1000;  // of a numerator or denominator that is kept: factors multiply

std::optional<block::Ratio> small(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t divisor = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
  if (divisor == 0 || std::abs(numerator / divisor) > kLargest ||
      denominator / divisor > kLargest) {
    return std::nullopt;
  }
  return block::Ratio{static_cast<int>(numerator / divisor),
                      static_cast<int>(denominator / divisor)};
}

Number number(const Real& value) {
  for (const int denominator : {1, 1000}) {
    const Real scaled = value * denominator;
    if (scaled == floor(scaled) && abs(scaled) <= kLargest * kLargest) {
      return {value, small(static_cast<std::int64_t>(scaled), denominator)};
    }
  }
  return {value, std::nullopt};
}

Number operated(char operation, const Number& a, const Number& b) {
  using Wide = std::int64_t;
  const bool exact = a.ratio && b.ratio;
  const Wide p = exact ? a.ratio->numerator : 0;
  const Wide q = exact ? a.ratio->denominator : 0;
  const Wide r = exact ? b.ratio->numerator : 0;
  const Wide s = exact ? b.ratio->denominator : 0;
  switch (operation) {
    case '+':
      return {a.value + b.value, small(p * s + r * q, q * s)};
    case '-':
      return {a.value - b.value, small(p * s - r * q, q * s)};
    case '*':
      return {a.value * b.value, small(p * r, q * s)};
    default:
      return {a.value / b.value, small(p * s, q * r)};
  }
}

/// True for a single number, which multiplies anything.
bool is_single(const Expression& e) { return e.shape() == block::Shape{kOne, kOne}; }

/// A column of ones over what the rows of `e` count.
Expression ones_of(const block::Side& side) {
  return side.set == block::Set::kPoints ? ones_P : ones;
}

/// A single number times a matrix: on the diagonal where the rows are many, so that it multiplies
/// what the matrix derives to.
Expression product(const Expression& a, const Expression& b) {
  if (is_single(a) && b.shape().rows.set != block::Set::kOne) {
    return block::diagb(ones_of(b.shape().rows) * a) * b;
  }
  if (is_single(b) && a.shape().cols.set != block::Set::kOne) {
    return a.shape().rows == kOne ? b * a : product(b, a);
  }
  return a * b;
}

class Parser : public Grammar<Term> {
 public:
  Parser(std::string_view text, const Scope& scope)
      : Grammar(text, {kLongest, kDeepest}), scope_(scope) {}

  Expression run() { return expression(whole(), 0); }

 private:
  /// Runs `make`; what it refuses is a mistake at `offset`.
  template <class Make>
  auto placed(std::size_t offset, const Make& make) {
    try {
      return make();
    } catch (const TextError&) {
      throw;
    } catch (const InputError&) {  // of another equation
      throw;
    } catch (const std::logic_error& error) {  // shapes
      fail(offset, error.what());
    } catch (const std::runtime_error& error) {  // names, units, rates
      fail(offset, error.what());
    }
  }

  Expression expression(const Term& term, std::size_t offset) {
    if (const Expression* e = std::get_if<Expression>(&term)) {
      return *e;
    }
    return placed(offset, [&] { return scope_.number(std::get<Number>(term).value); });
  }
  Term checked(const Expression& e) {
    scope_.check(e);
    return e;
  }

  Term combined(char operation, const Term& a, const Term& b, const Places& places) override {
    switch (operation) {
      case '*':
        return multiply(places.sign, a, b);
      case '/':
        return divide(places.sign, a, b);
      default:
        return add(operation, places.sign, a, b);
    }
  }

  Term negative(const Term& x, std::size_t offset) override {
    return multiply(offset, Number{-1, block::Ratio{-1, 1}}, x);
  }

  Term power(const Term& base, const Term& exponent, const Places& places) override {
    if (!std::holds_alternative<Number>(base) || !std::holds_alternative<Number>(exponent)) {
      fail(places.sign, "raises a block expression to a power; expected constants");
    }
    return finite(places.sign, pow(std::get<Number>(base).value, std::get<Number>(exponent).value));
  }

  Term number(std::string_view /*written*/, const Real& value, std::size_t offset) override {
    return finite(offset, value);
  }

  Term named(std::string_view word, std::size_t offset) override {
    const std::string name(word);
    return peek() == '(' ? call(name, offset) : placed(offset, [&] { return scope_.name(name); });
  }

  Term add(char operation, std::size_t offset, const Term& a, const Term& b) {
    if (std::holds_alternative<Number>(a) && std::holds_alternative<Number>(b)) {
      return in_range(offset, operated(operation, std::get<Number>(a), std::get<Number>(b)));
    }
    return placed(offset, [&] {
      const Expression x = expression(a, offset);
      const Expression y = expression(b, offset);
      const bool begins_with_minus =
          x.kind() == block::Kind::kScaled && x.node().factor == block::Ratio{-1, 1};
      return checked(operation == '-'    ? x - y
                     : begins_with_minus ? y - x.operands().front()
                                         : x + y);
    });
  }

  Term divide(std::size_t offset, const Term& a, const Term& b) {
    if (!std::holds_alternative<Number>(b)) {
      return multiply(offset, a,
                      placed(offset, [&] { return scope_.reciprocal(std::get<Expression>(b)); }));
    }
    if (std::get<Number>(b).value == 0) {
      fail(offset, "divides by zero; expected a divisor that is not zero");
    }
    return multiply(
        offset, a, in_range(offset, operated('/', Number{1, block::Ratio{}}, std::get<Number>(b))));
  }

  Term multiply(std::size_t offset, const Term& a, const Term& b) {
    const Number* const x = std::get_if<Number>(&a);
    const Number* const y = std::get_if<Number>(&b);
    if (x != nullptr && y != nullptr) {
      return in_range(offset, operated('*', *x, *y));
    }
    return placed(offset, [&]() -> Term {
      if (x == nullptr && y == nullptr) {
        return checked(equations::product(std::get<Expression>(a), std::get<Expression>(b)));
      }
      const Number& number = x != nullptr ? *x : *y;
      const Expression& e = std::get<Expression>(x != nullptr ? b : a);
      return checked(number.ratio ? *number.ratio * e
                                  : equations::product(scope_.number(number.value), e));
    });
  }

  static Number in_range(std::size_t offset, const Number& x) {
    if (!isfinite(x.value) || abs(x.value) > Real("1e300")) {
      fail(offset, fmt::format("has a constant that is {}; expected a real number of at most 1e300",
                               x.value.str(6)));
    }
    if (x.value != 0 && abs(x.value) < Real("1e-300")) {
      fail(offset,
           fmt::format("has a constant that is {}; expected 0 or at least 1e-300", x.value.str(6)));
    }
    return x;
  }
  static Term finite(std::size_t offset, const Real& value) {
    return in_range(offset, equations::number(value));
  }

  Term call(const std::string& name, std::size_t offset) {
    for (const char* of : {"at", "under", "above", "at_point", "R"}) {
      if (name == of) {
        return placed(offset, [&] { return Term(scope_.of(name, raw_argument())); });
      }
    }
    take('(');
    const Term argument = parenthesis(at() - 1);
    if (const auto* const number = std::get_if<Number>(&argument)) {
      return of_number(name, *number, offset);
    }
    return placed(offset, [&] { return checked(of_block(name, std::get<Expression>(argument))); });
  }

  /// What stands in the brackets, as it is: names of links may hold any character.
  std::string raw_argument() {
    take('(');
    const bool quoted = peek() == '"';
    const std::size_t begin = at() + (quoted ? 1 : 0);
    const std::size_t end = text().find(quoted ? '"' : ')', begin);
    if (end == std::string_view::npos) {
      fail(begin, fmt::format("found no end of the name; expected '{}'", quoted ? '"' : ')'));
    }
    go_to(end + (quoted ? 1 : 0));
    std::string name(text().substr(begin, end - begin));
    while (!quoted && !name.empty() && is_space(name.back())) {
      name.pop_back();
    }
    if (!take(')')) {
      fail(at(), "unexpected text behind a name in quotes; expected ')'");
    }
    return name;
  }

  Term of_number(const std::string& name, const Number& x, std::size_t offset) {
    const auto result = [&](const Real& value) {
      return finite(offset, value);
    };
    if (name == "sqrt") {
      return result(sqrt(x.value));
    }
    if (name == "sin") {
      return result(sin(x.value));
    }
    if (name == "cos") {
      return result(cos(x.value));
    }
    if (name == "tan") {
      return result(tan(x.value));
    }
    const Expression leaf = placed(offset, [&] { return scope_.number(x.value); });
    return placed(offset, [&] { return checked(of_block(name, leaf)); });
  }

  Expression of_block(const std::string& name, const Expression& x) {
    if (name == "T") {
      return block::transpose(x);
    }
    if (name == "Lam") {
      return block::skew(x);
    }
    if (name == "LamT") {
      return block::skew_transpose(x);
    }
    if (name == "diagb") {
      return block::diagb(x);
    }
    if (name == "dot") {
      return scope_.dot(x);
    }
    if (name == "sqrt" || name == "sin" || name == "cos" || name == "tan") {
      throw std::runtime_error(
          fmt::format("takes '{}' of a block expression; expected a constant there", name));
    }
    throw std::runtime_error(fmt::format(
        "there is no function '{}'; expected T, Lam, LamT, diagb, dot, at, under, above, at_point, "
        "R, or sqrt, sin, cos, tan of a constant",
        name));
  }

  const Scope& scope_;
};

}  // namespace

Expression parse(std::string_view text, const Scope& scope) { return Parser(text, scope).run(); }

}  // namespace treedyn::equations
