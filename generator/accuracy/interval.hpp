// Ranges of numbers, rounded outwards.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace treedyn::accuracy {

/// low <= x <= high. What operations return contains every result of numbers of their operands: the
/// ends are computed in double, to nearest, and moved outwards by at least a unit in the last
/// place. No end is NaN: where one would be, the range is that of all numbers.
struct Interval {
  double low = 0;
  double high = 0;

  [[nodiscard]] double size() const { return std::max(-low, high); }
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double middle() const { return low / 2 + high / 2; }
  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
};

inline double below(double x) {
  return x - (std::fabs(x) * 0x1p-52 + std::numeric_limits<double>::denorm_min());
}
inline double above(double x) { return -below(-x); }

/// Around two computed ends.
inline Interval outwards(double low, double high) {
  const double infinity = std::numeric_limits<double>::infinity();
  return low <= high && low > -infinity && high < infinity ? Interval{below(low), above(high)}
                                                           : Interval{-infinity, infinity};
}

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return outwards(a.low + b.low, a.high + b.high);
}
inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.low * b.low;
  const double q = a.low * b.high;
  const double r = a.high * b.low;
  const double s = a.high * b.high;
  if (std::isnan(p + q + r + s)) {
    return outwards(1, 0);
  }
  return outwards(std::min(std::min(p, q), std::min(r, s)),
                  std::max(std::max(p, q), std::max(r, s)));
}
/// All numbers if b contains zero.
inline Interval operator/(const Interval& a, const Interval& b) {
  return b.contains(0) ? outwards(1, 0) : a * outwards(1 / b.high, 1 / b.low);
}

/// x - r to x + r. \pre r >= 0
inline Interval around(const Interval& x, double r) { return outwards(x.low - r, x.high + r); }

inline Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// \pre x.low >= 0
Interval sqrt(const Interval& x);
Interval sin(const Interval& x);
Interval cos(const Interval& x);
/// x^2, no negative number.
Interval square(const Interval& x);

}  // namespace treedyn::accuracy
