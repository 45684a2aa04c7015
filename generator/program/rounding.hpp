// Bounds of the errors that rounding leaves, carried along with values.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// What a value of this size is rounded by, in unit roundoffs of `Target`: its own size, at least
/// the smallest normal number, infinite where it overflows.
template <class Target>
double rounding_of(double value) {
  const double size = std::abs(value);
  return size > static_cast<double>(std::numeric_limits<Target>::max())
             ? std::numeric_limits<double>::infinity()
             : std::max(size, static_cast<double>(std::numeric_limits<Target>::min()));
}

/// A value and a bound of its error in unit roundoffs of `Target`, to first order. Inputs and
/// constants are rounded once (a measured angle is no better), so is every result; errors are never
/// supposed to cancel.
template <class Value, class Target = double>
struct Rounded {
  Value value = 0;
  double error = 0;

  Rounded() = default;
  Rounded(Value the_value, double the_error) : value(std::move(the_value)), error(the_error) {}
  /// An input or a constant.
  explicit Rounded(Value leaf) : value(std::move(leaf)), error(rounding()) {}

  Rounded operator-() const { return {-value, error}; }
  friend Rounded operator+(const Rounded& a, const Rounded& b) {
    return Rounded{a.value + b.value, a.error + b.error}.rounded();
  }
  friend Rounded operator*(const Rounded& a, const Rounded& b) {
    return Rounded{a.value * b.value, a.size() * b.error + b.size() * a.error}.rounded();
  }
  friend Rounded operator/(const Rounded& a, const Rounded& b) {
    const Value quotient = a.value / b.value;
    const double size = std::abs(static_cast<double>(quotient));
    return Rounded{quotient, (a.error + size * b.error) / b.size()}.rounded();
  }

  /// `result` is this function of `a`.
  static Rounded function(Kind kind, const Rounded& a, const Value& result) {
    const auto y = static_cast<double>(result);
    const double slope =
        kind == Kind::kSqrt ? 0.5 / std::abs(y) : std::sqrt(std::max(0.0, 1 - y * y));
    return Rounded{result, a.error * slope}.rounded();
  }
  [[nodiscard]] double size() const { return std::abs(static_cast<double>(value)); }

 private:
  [[nodiscard]] double rounding() const { return rounding_of<Target>(size()); }
  [[nodiscard]] Rounded rounded() const { return {value, error + rounding()}; }
};

/// How much more rounding may cost in `function` than in `before`, an equivalent function: the
/// quotient of the largest mean error bounds of outputs at some pseudo-random states, or half of
/// the largest quotient of one output; the larger of float and double. O(operations) with 50 digits
/// for each state.
double amplification(const Function& function, const Function& before);

/// True if the results agree to 30 digits of the largest at some pseudo-random states.
/// O(operations) with 50 digits for each state.
bool same_results(const Function& function, const Function& other);

/// What float loses at some pseudo-random states, measured: the largest error as a part of the
/// largest output; infinite where float has no result. Bounds of recursions along many links say
/// nothing. O(operations) with 50 digits for each state.
double float_error(const Function& function);

/// What a function gives at some pseudo-random states, one after the other.
struct KnownAnswers {
  std::vector<std::vector<double>>
      inputs;  ///< by array: elements of the first state, the second ..
  std::vector<std::vector<double>> outputs;  ///< the same, from 50 digits
  /// By output array: twice what eight runs of the same operations in the scalar lose there at
  /// most, half of which are off by a last digit more by chance, and eight unit roundoffs of its
  /// largest value. Other orders of rounding, as of fused operations, are likely to stay within.
  std::vector<double> bounds;
};

/// \param single  float, not double. O(operations) with 50 digits for each state.
KnownAnswers known_answers(const Function& function, int states, bool single);

}  // namespace treedyn::program
