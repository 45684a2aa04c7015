// The number type of everything before the printer.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <compare>
#include <concepts>
#include <ios>
#include <limits>
#include <string>
#include <type_traits>

namespace treedyn {

/// 50 significant decimal digits, computed in software.
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;

class Real;

}  // namespace treedyn

template <>
class std::numeric_limits<treedyn::Real> : public std::numeric_limits<treedyn::Digits> {
 public:
  static treedyn::Real min();
  static treedyn::Real max();
  static treedyn::Real lowest();
  static treedyn::Real epsilon();
  static treedyn::Real infinity();
  static treedyn::Real quiet_NaN();
};

namespace treedyn {

/// A real number with 50 significant decimal digits: the same bits on every machine, compiler and
/// locale. Decimals, pi and roots of a model file enter with 50 digits and stay so until
/// `emit/literal` prints them; a cancellation of exact zeros is recognised by `negligible`.
///
/// A number may be *seen as* another one, its stand-in. Orders, magnitudes and keys, all that
/// chooses a form of the equations, look at the stand-in; operations act on both alike. What
/// rewrites an equation, that numbers are equal, zero or one, has to hold of both (`==`, `both`):
/// so the form depends on what the stand-ins have in common and on no value, and no stand-in makes
/// it wrong. Conversions and `plain` give the number itself. Without a stand-in there is one
/// number, at its price.
class Real {
 public:
  Real() = default;
  Real(const Digits& value) : value_(value) {}
  template <class T>
  requires std::is_arithmetic_v<T> Real(T value) : value_(value) {}
  explicit Real(const char* text) : value_(text) {}
  explicit Real(const std::string& text) : value_(text) {}
  template <unsigned n>
  explicit Real(const boost::multiprecision::number<boost::multiprecision::cpp_bin_float<n>,
                                                    boost::multiprecision::et_off>& value)
      : value_(value) {}
  /// `value`, seen as `stand_in`.
  static Real seen_as(const Digits& value, const Digits& stand_in) {
    return {value, stand_in, value != stand_in};
  }

  /// The number itself.
  [[nodiscard]] const Digits& digits() const { return value_; }
  [[nodiscard]] Real plain() const { return value_; }
  /// What decisions look at.
  [[nodiscard]] const Digits& seen() const { return differs_ ? seen_ : value_; }

  template <class T>
  requires(!std::same_as<T, Real> && std::constructible_from<T, Digits>) explicit operator T()
      const {
    return static_cast<T>(value_);
  }
  template <class T>
  [[nodiscard]] T convert_to() const {
    return value_.convert_to<T>();
  }
  [[nodiscard]] std::string str(std::streamsize digits = 0,
                                std::ios_base::fmtflags flags = {}) const {
    return value_.str(digits, flags);
  }

  /// The function of a number, or of two.
  template <class Function>
  static Real map(const Real& a, Function function) {
    return a.differs_ ? seen_as(function(a.value_), function(a.seen_)) : Real(function(a.value_));
  }
  template <class Function>
  static Real map(const Real& a, const Real& b, Function function) {
    return a.differs_ || b.differs_
               ? seen_as(function(a.value_, b.value_), function(a.seen(), b.seen()))
               : Real(function(a.value_, b.value_));
  }

  Real operator-() const { return {-value_, -seen_, differs_}; }
  Real operator+() const { return *this; }
  Real& operator+=(const Real& b) { return *this = *this + b; }
  Real& operator-=(const Real& b) { return *this = *this - b; }
  Real& operator*=(const Real& b) { return *this = *this * b; }
  Real& operator/=(const Real& b) { return *this = *this / b; }
  friend Real operator+(const Real& a, const Real& b) {
    return map(a, b, [](const Digits& x, const Digits& y) { return Digits(x + y); });
  }
  friend Real operator-(const Real& a, const Real& b) {
    return map(a, b, [](const Digits& x, const Digits& y) { return Digits(x - y); });
  }
  friend Real operator*(const Real& a, const Real& b) {
    return map(a, b, [](const Digits& x, const Digits& y) { return Digits(x * y); });
  }
  friend Real operator/(const Real& a, const Real& b) {
    return map(a, b, [](const Digits& x, const Digits& y) { return Digits(x / y); });
  }
  /// True if `predicate` holds of the numbers and of their stand-ins.
  template <class Predicate>
  static bool both(const Real& a, const Real& b, Predicate predicate) {
    return predicate(a.value_, b.value_) &&
           (!(a.differs_ || b.differs_) || predicate(a.seen(), b.seen()));
  }
  friend bool operator==(const Real& a, const Real& b) {
    return both(a, b, [](const Digits& x, const Digits& y) { return x == y; });
  }
  friend std::partial_ordering operator<=>(const Real& a, const Real& b) {
    const Digits& x = a.seen();
    const Digits& y = b.seen();
    return x < y    ? std::partial_ordering::less
           : x > y  ? std::partial_ordering::greater
           : x == y ? std::partial_ordering::equivalent
                    : std::partial_ordering::unordered;
  }

 private:
  Real(const Digits& value, const Digits& seen, bool differs)
      : value_(value), seen_(seen), differs_(differs) {}

  Digits value_ = 0;
  Digits seen_ = 0;
  bool differs_ = false;
};

/// Not negative as it is seen.
inline Real abs(const Real& x) { return x.seen() < 0 ? -x : x; }
inline Real fabs(const Real& x) { return abs(x); }

inline Real sqrt(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(sqrt(a)); });
}
inline Real sin(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(sin(a)); });
}
inline Real cos(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(cos(a)); });
}
inline Real tan(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(tan(a)); });
}
inline Real asin(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(asin(a)); });
}
inline Real acos(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(acos(a)); });
}
inline Real atan(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(atan(a)); });
}
inline Real exp(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(exp(a)); });
}
inline Real log(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(log(a)); });
}
inline Real floor(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(floor(a)); });
}
inline Real ceil(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(ceil(a)); });
}
inline Real round(const Real& x) {
  return Real::map(x, [](const Digits& a) { return Digits(round(a)); });
}
inline Real atan2(const Real& y, const Real& x) {
  return Real::map(y, x, [](const Digits& a, const Digits& b) { return Digits(atan2(a, b)); });
}
inline Real pow(const Real& x, const Real& y) {
  return Real::map(x, y, [](const Digits& a, const Digits& b) { return Digits(pow(a, b)); });
}
inline Real ldexp(const Real& x, int exponent) {
  return Real::map(x, [exponent](const Digits& a) { return Digits(ldexp(a, exponent)); });
}
inline long lround(const Real& x) { return lround(x.digits()); }
inline bool isfinite(const Real& x) { return isfinite(x.digits()) && isfinite(x.seen()); }
inline bool isnan(const Real& x) { return isnan(x.digits()); }

/// The larger magnitude, of the numbers and of their stand-ins.
inline Real larger(const Real& a, const Real& b) {
  return Real::map(a, b, [](const Digits& x, const Digits& y) {
    const Digits p = abs(x);
    const Digits q = abs(y);
    return p < q ? q : p;
  });
}

/// pi with 50 digits.
const Real& pi();

/// True if `value` is what rounding at 50 digits leaves of a cancellation among terms of size
/// `scale`.
inline bool negligible(const Real& value, const Real& scale) {
  return Real::both(value, scale, [](const Digits& x, const Digits& of) {
    static const Digits rounding(1e-40);
    return x.is_zero() || abs(x) <= abs(of) * rounding;
  });
}

/// Equal but for rounding at 50 digits: one number, reached along two ways.
inline bool identical(const Real& a, const Real& b) {
  return Real::both(a, b, [](const Digits& x, const Digits& y) {
    static const Digits same(1e-38);
    return x == y || abs(x - y) <= abs(y) * same;
  });
}

}  // namespace treedyn

inline treedyn::Real std::numeric_limits<treedyn::Real>::min() {
  return std::numeric_limits<treedyn::Digits>::min();
}
inline treedyn::Real std::numeric_limits<treedyn::Real>::max() {
  return std::numeric_limits<treedyn::Digits>::max();
}
inline treedyn::Real std::numeric_limits<treedyn::Real>::lowest() {
  return std::numeric_limits<treedyn::Digits>::lowest();
}
inline treedyn::Real std::numeric_limits<treedyn::Real>::epsilon() {
  return std::numeric_limits<treedyn::Digits>::epsilon();
}
inline treedyn::Real std::numeric_limits<treedyn::Real>::infinity() {
  return std::numeric_limits<treedyn::Digits>::infinity();
}
inline treedyn::Real std::numeric_limits<treedyn::Real>::quiet_NaN() {
  return std::numeric_limits<treedyn::Digits>::quiet_NaN();
}
