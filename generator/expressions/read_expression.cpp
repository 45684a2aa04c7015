#include "expressions/read_expression.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "expressions/exact.hpp"
#include "expressions/parser.hpp"

namespace treedyn::expressions {

namespace {

using model::Expression;

/// Operations of an expression that is differentiated: bounds the size of the derivatives.
constexpr std::size_t kMaxMotionSize = 200;
constexpr int kMaxPower = 1000;
/// Operations of a second derivative.
constexpr double kMaxDerivativeSize = 20'000;

/// A part of an expression with its sign apart and a text by which parts are put in order.
struct Part {
  bool negative = false;
  Expression value;
  std::string key;
};

void sort(std::vector<Part>& parts) {
  std::ranges::sort(parts, [](const Part& a, const Part& b) {
    return std::tie(a.key, a.negative) < std::tie(b.key, b.negative);
  });
}

/// Symbols of one expression and what they stand for.
class Symbols final : public Variables {
 public:
  Symbols(const Constants& constants, const VariableNames& names)
      : at_run_time_(constants.table().at_run_time), names_(names) {}

  [[nodiscard]] std::optional<GiNaC::ex> find(
      std::string_view name, std::optional<std::string_view> index) const override {
    const std::optional<model::Variable> variable = names_.find(name, index);
    if (!variable) {
      return std::nullopt;
    }
    for (const auto& [known, symbol] : known_) {
      if (known == *variable) {
        return symbol;
      }
    }
    known_.emplace_back(*variable, GiNaC::realsymbol());
    return known_.back().second;
  }
  [[nodiscard]] std::string expected() const override { return names_.expected; }
  [[nodiscard]] std::vector<std::string> known() const override { return names_.known; }

  /// A parameter that is known at run time only; nullptr: a variable.
  [[nodiscard]] const Constants::Table::AtRunTime* parameter(const GiNaC::ex& symbol) const {
    const auto found = std::ranges::find_if(
        at_run_time_, [&](const auto& parameter) { return symbol.is_equal(parameter.symbol); });
    if (found == at_run_time_.end()) {
      return nullptr;
    }
    if (!names_.run_time) {
      throw TextError(0, fmt::format("'{}' is known at run time only, which this is not; "
                                     "expected numbers that the scene fixes",
                                     found->name));
    }
    return &*found;
  }
  [[nodiscard]] model::Variable variable(const GiNaC::ex& symbol) const {
    const auto found =
        std::ranges::find_if(known_, [&](const auto& row) { return symbol.is_equal(row.second); });
    TREEDYN_EXPECT(found != known_.end());
    return found->first;
  }

  /// d/dt of an expression of time alone.
  [[nodiscard]] GiNaC::ex rate(const GiNaC::ex& value) const {
    return known_.empty() ? GiNaC::ex(0) : value.diff(known_.front().second);
  }

 private:
  const std::vector<Constants::Table::AtRunTime>& at_run_time_;
  const VariableNames& names_;
  mutable std::vector<std::pair<model::Variable, GiNaC::realsymbol>> known_;
};

/// GiNaC to a program.
class Converter {
 public:
  explicit Converter(const Symbols& symbols) : symbols_(symbols) {}

  [[nodiscard]] Expression convert(const GiNaC::ex& value) const {
    const Part result = part(value);
    return result.negative ? -result.value : result.value;
  }

 private:
  [[nodiscard]] Part part(const GiNaC::ex& value) const {
    if (is_constant(value)) {
      return constant(to_real(value));
    }
    if (GiNaC::is_a<GiNaC::add>(value)) {
      return sum(value);
    }
    if (GiNaC::is_a<GiNaC::mul>(value) || GiNaC::is_a<GiNaC::power>(value)) {
      return product(value);
    }
    if (GiNaC::is_a<GiNaC::symbol>(value)) {
      if (const auto* const parameter = symbols_.parameter(value)) {
        return {false, Expression(parameter->number), "p" + parameter->name};
      }
      const model::Variable variable = symbols_.variable(value);
      return {false, Expression(variable),
              fmt::format("v{:02}_{:06}", static_cast<int>(variable.quantity), variable.index)};
    }
    return call(value);
  }

  static Part constant(const Real& value) {
    return {value < 0, Expression(Real(abs(value))), fmt::format("c{}", Real(abs(value)).str(50))};
  }

  [[nodiscard]] Part call(const GiNaC::ex& value) const {
    TREEDYN_EXPECT(GiNaC::is_a<GiNaC::function>(value));
    const std::string name = GiNaC::ex_to<GiNaC::function>(value).get_name();
    const Part of = part(value.op(0));
    const Expression argument = of.negative ? -of.value : of.value;
    const std::string key = fmt::format("{}({}{})", name, of.negative ? "-" : "", of.key);
    TREEDYN_EXPECT(name == "sin" || name == "cos");
    return {false, name == "sin" ? sin(argument) : cos(argument), key};
  }

  /// The terms of a sum, in order.
  [[nodiscard]] std::vector<Part> terms(const GiNaC::ex& value) const {
    std::vector<Part> parts;
    for (const GiNaC::ex& term : value) {
      parts.push_back(part(term));
    }
    sort(parts);
    return parts;
  }

  static Part joined(std::vector<Part> parts) {
    std::stable_partition(parts.begin(), parts.end(), [](const Part& p) { return !p.negative; });
    Part result = parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k) {
      const bool minus = parts[k].negative != result.negative;
      result.value = minus ? result.value - parts[k].value : result.value + parts[k].value;
      result.key += (minus ? "-" : "+") + parts[k].key;
    }
    result.key = fmt::format("({})", result.key);
    return result;
  }

  [[nodiscard]] Part sum(const GiNaC::ex& value) const { return joined(terms(value)); }

  /// A factor of a product. GiNaC writes (a - b) (c - d) with either sign in each sum, as the order
  /// of the moment makes it; here the first term of a sum is positive.
  [[nodiscard]] Part factor(const GiNaC::ex& value) const {
    if (!GiNaC::is_a<GiNaC::add>(value)) {
      return part(value);
    }
    std::vector<Part> parts = terms(value);
    const bool negative = parts.front().negative;
    for (Part& p : parts) {
      p.negative = p.negative != negative;
    }
    Part result = joined(std::move(parts));
    result.negative = negative;
    return result;
  }

  /// Numerators and denominators of a product or a power.
  [[nodiscard]] Part product(const GiNaC::ex& value) const {
    Part result{false, Expression(1), ""};
    std::vector<Part> above;
    std::vector<Part> below;
    Real coefficient = 1;
    const auto take = [&](const GiNaC::ex& factor) {
      if (is_constant(factor)) {
        coefficient *= to_real(factor);
        return;
      }
      bool inverse = false;
      Part p = power_of(factor, inverse);
      result.negative = result.negative != p.negative;
      (inverse ? below : above).push_back(std::move(p));
    };
    if (GiNaC::is_a<GiNaC::mul>(value)) {
      std::ranges::for_each(value, take);
    } else {
      take(value);
    }
    result.negative = result.negative != (coefficient < 0);
    result.value = Expression(Real(abs(coefficient)));
    multiply(above, result);
    Part divisor{false, Expression(1), ""};
    multiply(below, divisor);
    if (!below.empty()) {
      result.value = result.value / divisor.value;
      result.key += "/" + divisor.key;
    }
    if (abs(coefficient) != 1) {
      result.key += constant(coefficient).key;
    }
    return result;
  }

  static void multiply(std::vector<Part>& parts, Part& result) {
    sort(parts);
    for (const Part& p : parts) {
      result.value = result.value * p.value;
      result.key += (result.key.empty() ? "" : "*") + p.key;  // of -x as of x
    }
  }

  /// A factor; `inverse` if it belongs below the line.
  [[nodiscard]] Part power_of(const GiNaC::ex& value, bool& inverse) const {
    if (!GiNaC::is_a<GiNaC::power>(value)) {
      return factor(value);
    }
    const GiNaC::ex exponent = value.op(1);
    TREEDYN_EXPECT(GiNaC::is_a<GiNaC::numeric>(exponent));
    const auto& e = GiNaC::ex_to<GiNaC::numeric>(exponent);
    inverse = e.is_negative();
    const GiNaC::numeric size = abs(e);
    if (size.denom() > 2 || size.numer() > kMaxPower) {
      throw TextError(0, fmt::format("a power of a variable is too high; expected multiples of "
                                     "1/2 up to {}",
                                     kMaxPower / 2));
    }
    const int times = size.numer().to_int();
    if (size.is_integer()) {
      const Part base = factor(value.op(0));
      return {base.negative && times % 2 != 0, power(base.value, times),
              fmt::format("{}^{}", base.key, times)};
    }
    const Part base = part(value.op(0));
    return {false, power(sqrt(base.negative ? -base.value : base.value), times),
            fmt::format("{}{}^{}/2", base.negative ? "-" : "", base.key, times)};
  }

  const Symbols& symbols_;
};

/// Operations of an expression and of its first two derivatives, before any simplification: an
/// upper bound that costs no differentiation.
struct Sizes {
  double value = 1;
  double rate = 0;
  double second = 0;
};

Sizes sizes_of(const GiNaC::ex& value) {
  if (is_constant(value)) {
    return {};
  }
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    return {1, 1, 0};
  }
  if (!GiNaC::is_a<GiNaC::add>(value) && !GiNaC::is_a<GiNaC::mul>(value)) {
    // f(x)' = f'(x) x', f(x)'' = f''(x) x'^2 + f'(x) x'', also of powers
    const Sizes x = sizes_of(value.op(0));
    return {x.value + 1, x.value + x.rate + 3, 2 * x.value + 2 * x.rate + x.second + 8};
  }
  Sizes sum{0, 0, 0};
  for (const GiNaC::ex& part : value) {
    const Sizes sizes = sizes_of(part);
    sum = {sum.value + sizes.value + 1, sum.rate + sizes.rate + 1, sum.second + sizes.second + 1};
  }
  if (GiNaC::is_a<GiNaC::mul>(value)) {  // (f g ..)' = f' g .. + f g' .. + ..
    const auto n = static_cast<double>(value.nops());
    sum = {sum.value, n * sum.value + sum.rate, n * n * sum.value + 2 * n * sum.rate + sum.second};
  }
  return sum;
}

}  // namespace

Expression read_expression(const Constants& constants, std::string_view text,
                           const VariableNames& variables) {
  const Symbols symbols(constants, variables);
  const Exact exact = parse(text, constants.table().names, &symbols);
  return guarded(text, [&] { return Converter(symbols).convert(exact.value); });
}

std::array<Expression, 3> read_motion(const Constants& constants, std::string_view text,
                                      const VariableNames& variables) {
  const Symbols symbols(constants, variables);
  const Exact exact = parse(text, constants.table().names, &symbols);
  if (exact.size > kMaxMotionSize) {
    throw TextError(0, fmt::format("motion of {} operations is too large; expected at most {}",
                                   exact.size, kMaxMotionSize));
  }
  if (const double size = sizes_of(exact.value).second; size > kMaxDerivativeSize) {
    throw TextError(0, fmt::format("second derivative of this motion may have {:.3g} "
                                   "operations, which are too many; expected at most {}",
                                   size, kMaxDerivativeSize));
  }
  return guarded(text, [&] {
    const Converter converter(symbols);
    const GiNaC::ex rate = symbols.rate(exact.value);
    return std::array{converter.convert(exact.value), converter.convert(rate),
                      converter.convert(symbols.rate(rate))};
  });
}

}  // namespace treedyn::expressions
