#include "accuracy/interval.hpp"

#include <numbers>

namespace treedyn::accuracy {

namespace {

/// More than what the C library's sine and cosine are wrong by: below 1 ulp, its manual says; 8
/// here.
constexpr double kLibrary = 0x1p-50;
constexpr Interval kUnit{-1, 1};

/// True if x may contain `first` + 2 pi k for a whole number k. What rounding leaves of the
/// quotients is below the slack.
bool meets(const Interval& x, double first) {
  const double turn = 2 * std::numbers::pi;
  const double slack = 1e-14 * (1 + x.size());
  return std::floor((x.high - first) / turn + slack) >= std::ceil((x.low - first) / turn - slack);
}

/// Of a wave that is 1 at `top` and -1 half a turn later, and the values at both ends of x.
Interval wave(const Interval& x, double top, double a, double b) {
  if (!(x.size() < 1e9)) {
    return kUnit;
  }
  const double low = meets(x, top + std::numbers::pi) ? -1 : std::min(a, b) - kLibrary;
  const double high = meets(x, top) ? 1 : std::max(a, b) + kLibrary;
  return {std::max(low, -1.0), std::min(high, 1.0)};
}

}  // namespace

Interval sqrt(const Interval& x) {
  const Interval root = outwards(std::sqrt(std::max(x.low, 0.0)), std::sqrt(x.high));
  return {std::max(root.low, 0.0), root.high};
}

Interval sin(const Interval& x) {
  return wave(x, std::numbers::pi / 2, std::sin(x.low), std::sin(x.high));
}

Interval cos(const Interval& x) { return wave(x, 0, std::cos(x.low), std::cos(x.high)); }

Interval square(const Interval& x) {
  const double least = x.contains(0) ? 0 : std::min(std::fabs(x.low), std::fabs(x.high));
  const Interval result = outwards(least * least, x.size() * x.size());
  return {std::max(result.low, 0.0), result.high};
}

}  // namespace treedyn::accuracy
