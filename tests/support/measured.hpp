// A scalar for generated code that keeps, beside every value, a bound of its rounding error, and
// counts the operations. Generated code is compiled with it in place of double or float.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace treedyn::support {

/// Operations since `reset`, in the order of the manifest: add, mul, div, sqrt, sin, cos.
struct Counter {
  static inline std::array<long, 6> operations{};
  static void reset() { operations = {}; }
};

/// Running error analysis (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 3.3):
/// |value - exact| <= bound for the exact inputs and the constants that the literals stand for.
///
/// Every operation adds the unit roundoff times its result to what it inherits; a literal carries
/// the error of its rounding; sin and cos are trusted to the larger of 1 ulp = 2 units (the glibc
/// manual, "Errors in Math Functions", states 1 ulp for both on x86-64) and what generated headers
/// state of their own (lanes/sincos_test holds them to it). The bounds are computed in double; the
/// factor `kSlack` covers their own rounding.
template <class T>
class Measured {
 public:
  static constexpr double kUnit = static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
  static constexpr double kTiny = static_cast<double>(std::numeric_limits<T>::denorm_min());
  static constexpr double kSlack = 1 + 1e-12;
  static constexpr double kSine = sizeof(T) == sizeof(float) ? 1e-7 : 1.7e-16;  ///< absolute

  Measured() = default;
  // A literal of the generated code: implicit, as it is for the built-in types.
  Measured(T literal) : value_(literal), bound_(rounding(literal)) {}  // NOLINT
  static Measured exact(T value) { return Measured(value, 0); }

  [[nodiscard]] T value() const { return value_; }
  [[nodiscard]] double bound() const { return bound_; }

  Measured operator-() const { return Measured(-value_, bound_); }
  Measured operator+() const { return *this; }

  friend Measured operator+(const Measured& a, const Measured& b) { return sum(a, b, 1); }
  friend Measured operator-(const Measured& a, const Measured& b) { return sum(a, b, -1); }
  friend Measured operator*(const Measured& a, const Measured& b) {
    ++Counter::operations[1];
    const T r = a.value_ * b.value_;
    return Measured(r, product_bound(a, b) + rounding(r));
  }
  friend Measured operator/(const Measured& a, const Measured& b) {
    ++Counter::operations[2];
    const T r = a.value_ / b.value_;
    const double divisor = magnitude(b.value_) - b.bound_;
    const double inherited = divisor > 0 ? (a.bound_ + times(magnitude(r), b.bound_)) / divisor
                                         : std::numeric_limits<double>::infinity();
    return Measured(r, inherited + rounding(r));
  }
  Measured& operator+=(const Measured& b) { return *this = *this + b; }
  Measured& operator-=(const Measured& b) { return *this = *this - b; }
  Measured& operator*=(const Measured& b) { return *this = *this * b; }

  // Branches of scene functions: not counted.
  friend bool operator<(const Measured& a, const Measured& b) { return a.value_ < b.value_; }
  friend bool operator>(const Measured& a, const Measured& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Measured& a, const Measured& b) { return a.value_ <= b.value_; }

  friend Measured sqrt(const Measured& a) {
    ++Counter::operations[3];
    const T r = std::sqrt(a.value_);
    const double inherited = a.bound_ == 0 ? 0 : a.bound_ / magnitude(r);
    return Measured(r, inherited + rounding(r));
  }
  friend Measured sin(const Measured& a) {
    ++Counter::operations[4];
    const T r = std::sin(a.value_);
    return Measured(r, a.bound_ + std::max(2 * rounding(r), kSine));
  }
  friend Measured cos(const Measured& a) {
    ++Counter::operations[5];
    const T r = std::cos(a.value_);
    return Measured(r, a.bound_ + std::max(2 * rounding(r), kSine));
  }
  friend Measured fma(const Measured& a, const Measured& b, const Measured& c) {
    ++Counter::operations[0];
    ++Counter::operations[1];
    const T r = std::fma(a.value_, b.value_, c.value_);
    return Measured(r, product_bound(a, b) + c.bound_ + rounding(r));
  }

 private:
  Measured(T value, double bound) : value_(value), bound_(bound * kSlack) {}

  static double magnitude(T x) { return std::fabs(static_cast<double>(x)); }
  static double rounding(T result) { return kUnit * magnitude(result) + kTiny; }
  /// Zero times an unbounded error is zero.
  static double times(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }
  static double product_bound(const Measured& a, const Measured& b) {
    return times(magnitude(a.value_), b.bound_) + times(magnitude(b.value_), a.bound_) +
           times(a.bound_, b.bound_);
  }
  static Measured sum(const Measured& a, const Measured& b, int sign) {
    ++Counter::operations[0];
    const T r = sign > 0 ? a.value_ + b.value_ : a.value_ - b.value_;
    return Measured(r, a.bound_ + b.bound_ + rounding(r));
  }

  T value_ = 0;
  double bound_ = 0;
};

}  // namespace treedyn::support
