// The number type of everything before the printer.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <compare>
#include <concepts>
#include <cstdint>
#include <ios>
#include <limits>
#include <string>
#include <type_traits>

namespace treedyn {

/// 50 significant decimal digits, computed in software.
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;

class Real;
enum class RecipeKind : std::uint8_t;

}  // namespace treedyn

template <>
class std::numeric_limits<treedyn::Real> : public std::numeric_limits<treedyn::Digits> {};

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
///
/// A number that is known at run time only has its nominal value, and a recipe (recipe.hpp): how it
/// is made of run-time parameters. Sums, differences, products, quotients, roots, sines and cosines
/// of such numbers have recipes too.
class Real {
 public:
  Real() = default;
  Real(const Digits& value)  // NOLINT(google-explicit-constructor): numbers are Real
      : value_(value) {}
  template <class T>
  requires std::is_arithmetic_v<T> Real(T value)  // NOLINT(google-explicit-constructor): likewise
      : Real(from(Widest<T>(value))) {}
  explicit Real(const char* text);
  explicit Real(const std::string& text) : Real(text.c_str()) {}
  template <unsigned n>
  explicit Real(const boost::multiprecision::number<boost::multiprecision::cpp_bin_float<n>,
                                                    boost::multiprecision::et_off>& value)
      : value_(value) {}
  /// `value`, seen as `stand_in`.
  static Real seen_as(const Digits& value, const Digits& stand_in);
  /// Run-time parameter `index` with this nominal value, seen as `stand_in`.
  static Real of_parameter(int index, const Digits& value, const Digits& stand_in);

  /// The number itself.
  [[nodiscard]] const Digits& digits() const { return value_; }
  [[nodiscard]] Real plain() const { return value_; }
  /// What decisions look at.
  [[nodiscard]] const Digits& seen() const { return differs_ ? seen_ : value_; }
  /// True if that is another number.
  [[nodiscard]] bool has_stand_in() const { return differs_; }
  /// The number of its recipe; 0: the same number at run time.
  [[nodiscard]] int recipe() const { return recipe_; }

  template <class T>
  requires(!std::same_as<T, Real> && std::constructible_from<T, Digits>) explicit operator T()
      const {
    if constexpr (std::is_arithmetic_v<T>) {
      return convert_to<T>();
    } else {
      return static_cast<T>(value_);
    }
  }
  template <class T>
  [[nodiscard]] T convert_to() const;
  [[nodiscard]] std::string str(std::streamsize digits = 0,
                                std::ios_base::fmtflags flags = {}) const;

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

  Real operator-() const;
  Real operator+() const { return *this; }
  Real& operator+=(const Real& b) { return *this = *this + b; }
  Real& operator-=(const Real& b) { return *this = *this - b; }
  Real& operator*=(const Real& b) { return *this = *this * b; }
  Real& operator/=(const Real& b) { return *this = *this / b; }
  friend Real operator+(const Real& a, const Real& b);
  friend Real operator-(const Real& a, const Real& b);
  friend Real operator*(const Real& a, const Real& b);
  friend Real operator/(const Real& a, const Real& b);
  friend Real sqrt(const Real& x);
  friend Real sin(const Real& x);
  friend Real cos(const Real& x);
  /// True if `predicate` holds of the numbers and of their stand-ins.
  template <class Predicate>
  static bool both(const Real& a, const Real& b, Predicate predicate) {
    return predicate(a.value_, b.value_) &&
           (!(a.differs_ || b.differs_) || predicate(a.seen(), b.seen()));
  }
  friend bool operator==(const Real& a, const Real& b);
  friend std::partial_ordering operator<=>(const Real& a, const Real& b);
  /// The same, without a Real for the small number that most comparisons are with.
  template <std::same_as<int> Integer>
  friend bool operator==(const Real& a, Integer b) {
    return b == 0 ? a.value_.is_zero() && a.seen().is_zero() : a == Real(b);
  }
  template <std::same_as<int> Integer>
  friend std::partial_ordering operator<=>(const Real& a, Integer b) {
    return b == 0 ? a.compared_with_zero() : a <=> Real(b);
  }

 private:
  template <class T>
  using Widest =
      std::conditional_t<std::is_floating_point_v<T>, long double,
                         std::conditional_t<std::is_signed_v<T>, long long, unsigned long long>>;

  [[nodiscard]] std::partial_ordering compared_with_zero() const;
  Real(const Digits& value, const Digits& seen, bool differs, int recipe = 0)
      : value_(value), seen_(seen), differs_(differs), recipe_(recipe) {}
  /// a operation b, with its recipe and source.
  template <class Operation>
  static Real made(RecipeKind kind, const Real& a, const Real& b, Operation operation);
  /// `result` as a function of x, with its recipe and source.
  static Real noted(RecipeKind kind, const Real& x, Real result);
  static Real from(long double value);
  static Real from(long long value);
  static Real from(unsigned long long value);

  Digits value_;
  Digits seen_;
  bool differs_ = false;
  int recipe_ = 0;
};

/// Not negative as it is seen.
Real abs(const Real& x);
inline Real fabs(const Real& x) { return abs(x); }

Real sqrt(const Real& x);
Real sin(const Real& x);
Real cos(const Real& x);
Real tan(const Real& x);
Real log(const Real& x);
Real floor(const Real& x);
Real round(const Real& x);
Real atan2(const Real& y, const Real& x);
Real pow(const Real& x, const Real& y);
Real ldexp(const Real& x, int exponent);
long lround(const Real& x);
bool isfinite(const Real& x);

/// x, whose last bit may be wrong: for tables that are asked often, as the conversion that rounds
/// costs many times as much.
double nearly(const Digits& x);

/// The larger magnitude, of the numbers and of their stand-ins.
Real larger(const Real& a, const Real& b);

/// pi with 50 digits.
const Real& pi();

/// True if `value` is what rounding at 50 digits leaves of a cancellation among terms of size
/// `scale`.
bool negligible(const Real& value, const Real& scale);

/// Equal but for rounding at 50 digits: one number, reached along two ways.
bool identical(const Real& a, const Real& b);

}  // namespace treedyn
