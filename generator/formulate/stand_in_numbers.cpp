#include "formulate/stand_in_numbers.hpp"

#include <algorithm>
#include <optional>

#include "formulate/geometry.hpp"
#include "program/random.hpp"

namespace treedyn::formulate {

using model::Matrix3;
using model::Vector3;

namespace {

/// Stand-ins lie from the first to the second number: a robot of the size of a dog.
constexpr std::array<std::array<double, 2>, kStandIns> kRanges = {
    {{1.2, 4}, {0.1, 0.4}, {0.1, 0.4}, {0.02, 0.08}, {0.2, 0.6}, {8, 12}, {1.2, 4}}};
/// Lengths below this one are rounding of zeros.
constexpr double kShort = 1e-6;
/// Angles below this one are nearly zero: their decades matter.
constexpr double kSmall = 1e-3;
/// Any set of stand-ins does; with this one the models of the repository cost least among a few.
constexpr std::uint64_t kSet = 8;

bool same(const Digits& a, const Digits& b) {
  return abs(a - b) <= (abs(a) + abs(b)) * Digits("1e-38");
}

Digits scale(StandIn quantity, const Digits& magnitude) {
  const bool length = quantity == StandIn::kOffset || quantity == StandIn::kCom;
  if (length && magnitude < kShort) {
    return Digits("1e-8");
  }
  if (quantity == StandIn::kAngle && magnitude < kSmall) {
    return pow(Digits(100), floor(Digits(log10(magnitude) / 2)));
  }
  return 1;
}

using Angles = std::array<Digits, 3>;
using Axes = std::array<std::size_t, 3>;
constexpr std::array<Axes, 6> kOrders = {
    {{2, 1, 0}, {0, 1, 2}, {0, 2, 1}, {2, 0, 1}, {1, 0, 2}, {1, 2, 0}}};

Digits entry(const Matrix3& r, std::size_t row, std::size_t column) {
  return r[3 * row + column].digits();
}

/// a, b, c of R = R_i(a) R_j(b) R_k(c).
Angles angles_of(const Matrix3& r, const Axes& axes) {
  const auto [i, j, k] = axes;
  const int sign = (i + 1) % 3 == j ? 1 : -1;
  const Digits sine = sign * entry(r, i, k);
  const Digits cosine =
      sqrt(Digits(entry(r, i, i) * entry(r, i, i) + entry(r, i, j) * entry(r, i, j)));
  const Digits b = atan2(sine, cosine);
  if (cosine < Digits("1e-40")) {
    return {atan2(Digits(sign * entry(r, k, j)), entry(r, j, j)), b, 0};
  }
  return {atan2(Digits(-sign * entry(r, j, k)), entry(r, k, k)), b,
          atan2(Digits(-sign * entry(r, i, j)), entry(r, i, i))};
}

Matrix3 about(std::size_t axis, const Digits& angle) {
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  const Turn turn = turn_by(angle);
  Matrix3 r = identity();
  r[3 * i + i] = r[3 * j + j] = turn.c;
  r[3 * j + i] = turn.s;
  r[3 * i + j] = -turn.s;
  return r;
}

/// True if the same entries are zero, one, equal and opposite.
template <class Array>
bool same_pattern(const Array& a, const Array& b) {
  const auto is = [](const Real& x, int value) {
    return abs(abs(x) - value) < Real("1e-38");
  };
  for (std::size_t m = 0; m < a.size(); ++m) {
    if (is(a[m], 0) != is(b[m], 0) || is(a[m], 1) != is(b[m], 1)) {
      return false;
    }
    for (std::size_t n = 0; n < m; ++n) {
      if (is(abs(a[m]) - abs(a[n]), 0) != is(abs(b[m]) - abs(b[n]), 0)) {
        return false;
      }
    }
  }
  return true;
}

template <class Array>
Array seen_as(const Array& values, const Array& stand_ins) {
  Array result = values;
  for (std::size_t k = 0; k < values.size(); ++k) {
    result[k] = Real::seen_as(values[k].digits(), stand_ins[k].digits());
  }
  return result;
}

/// True for coordinate axes and for rotations among them.
template <class Array>
bool is_exact(const Array& values) {
  return std::ranges::all_of(values, [](const Real& x) { return x == 0 || x == 1 || x == -1; });
}

bool is_zero(const Digits& x) { return abs(x) < Digits("1e-38"); }

/// A vector in terms of two axes.
struct Along {
  bool parallel = false;
  Real father;          ///< along the father's axis
  Real axis;            ///< along the other one; of parallel axes zero
  Real across;          ///< along the common normal; of parallel axes the distance
  Vector3 direction{};  ///< of `across`
};

/// \param u, w  unit vectors
Along along(const Vector3& d, const Vector3& u, const Vector3& w) {
  Along result;
  const Vector3 normal = cross(u, w);
  const Real square = dot(normal, normal);
  result.parallel = is_zero(square.digits());
  if (result.parallel) {
    result.father = dot(d, u);
    const Vector3 rest = d - result.father * u;
    result.across = sqrt(dot(rest, rest));
    const bool apart = !is_zero(result.across.digits());
    result.direction = apart ? Real(1 / result.across) * rest : rest;
  } else {
    const Real cosine = dot(u, w);
    result.father = (dot(d, u) - cosine * dot(d, w)) / square;
    result.axis = (dot(d, w) - cosine * dot(d, u)) / square;
    result.direction = Real(1 / sqrt(square)) * normal;
    result.across = dot(d, result.direction);
  }
  return result;
}

/// True if something zero is not seen so.
bool is_lost(const Real& x) { return is_zero(x.digits()) && !is_zero(x.seen()); }

}  // namespace

Digits generic(StandIn quantity, int place) {
  const auto q = static_cast<std::size_t>(quantity);
  program::Random random(program::scramble(static_cast<std::uint64_t>(place) + (kSet << 40U)) + q);
  Digits u = 0;
  for (int k = 0; k < 3; ++k) {
    u = ldexp(Digits(u + random.next()), -64);
  }
  return kRanges[q][0] + (kRanges[q][1] - kRanges[q][0]) * u;
}

Real StandInNumbers::number(StandIn quantity, const Real& x) {
  const int place = place_++;
  const Digits magnitude = abs(x.digits());
  if (magnitude == 0 || magnitude == 1) {
    return x;
  }
  return Real::seen_as(x.digits(), of_value(quantity, x.digits(), place));
}

Digits StandInNumbers::of_angle(const Digits& angle, int place, int& changed) {
  const Digits twelfth = pi().digits() / 12;
  if (same(angle / twelfth + 100, round(Digits(angle / twelfth)) + 100)) {
    return angle;
  }
  ++changed;
  const Digits quarters = 6 * twelfth * round(Digits(angle / (6 * twelfth)));
  const Digits rest = angle - quarters;
  return quarters + of_value(StandIn::kAngle, rest, place);
}

Digits StandInNumbers::of_value(StandIn quantity, const Digits& value, int place) {
  std::vector<Known>& known = known_[static_cast<std::size_t>(quantity)];
  const bool of_robot = quantity == StandIn::kAngle || quantity == StandIn::kOffset;
  const int group = of_robot ? 0 : group_;
  for (const Known& k : known) {
    if (k.group == group && same(abs(k.value), abs(value))) {
      return (k.value < 0) == (value < 0) ? k.stand_in : Digits(-k.stand_in);
    }
  }
  known.push_back({group, value, scale(quantity, abs(value)) * generic(quantity, place)});
  return known.back().stand_in;
}

Vector3 StandInNumbers::vector(StandIn quantity, const Vector3& v) {
  const Real x = number(quantity, v[0]);
  const Real y = number(quantity, v[1]);
  return {x, y, number(quantity, v[2])};
}

Vector3 StandInNumbers::offset(const Vector3& d, const Vector3& father_axis, const Vector3& axis) {
  const StandInNumbers before = *this;
  Vector3 seen = vector(StandIn::kOffset, d);
  const Along parts = along(seen, father_axis, axis);
  if (!is_lost(parts.across) && !(parts.parallel && is_lost(parts.father))) {
    return seen;
  }
  *this = before;
  const Along own = along(plain(d), plain(father_axis), plain(axis));
  const auto see = [this](const Real& x) {
    return number(StandIn::kOffset, is_zero(x.digits()) ? Real(0) : x);
  };
  const Vector3 along_father = see(own.father) * father_axis;
  const Vector3 along_axis = see(own.axis) * axis;
  const Real across = see(own.across);
  Vector3 stand_in = along_father + along_axis;
  if (across != 0) {
    stand_in = stand_in + across * parts.direction;  // as it is seen: no value of d decides
  }
  std::ranges::for_each(stand_in, [](Real& x) { x = x.seen(); });
  return seen_as(d, stand_in);
}

Matrix3 StandInNumbers::symmetric(const Matrix3& m) {
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = i; k < 3; ++k) {
      result[3 * i + k] = result[3 * k + i] = number(StandIn::kInertia, m[3 * i + k]);
    }
  }
  return result;
}

Matrix3 StandInNumbers::rotation(const Matrix3& r) {
  const int place = place_;
  place_ += 3;
  if (is_exact(r)) {
    return r;
  }
  StandInNumbers best_numbers = *this;
  std::optional<Matrix3> best;
  int fewest = 4;
  for (const Axes& axes : kOrders) {
    StandInNumbers numbers = *this;
    const Angles angles = angles_of(r, axes);
    Matrix3 stand_in = identity();
    int changed = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      stand_in = multiply(
          stand_in,
          about(axes[n], numbers.of_angle(angles[n], place + static_cast<int>(n), changed)));
    }
    stand_in = clean(stand_in);
    if (changed < fewest && same_pattern(r, stand_in)) {
      fewest = changed;
      best = stand_in;
      best_numbers = numbers;
    }
  }
  if (!best || fewest == 0) {
    return r;
  }
  *this = best_numbers;
  return seen_as(r, *best);
}

Vector3 StandInNumbers::axis(const Vector3& v) {
  const int place = place_;
  place_ += 2;
  if (is_exact(v)) {
    return v;
  }
  StandInNumbers numbers = *this;
  int changed = 0;
  const Digits plane = sqrt(Digits(v[0].digits() * v[0].digits() + v[1].digits() * v[1].digits()));
  const Digits longitude = numbers.of_angle(atan2(v[1].digits(), v[0].digits()), place, changed);
  const Digits latitude = numbers.of_angle(atan2(v[2].digits(), plane), place + 1, changed);
  const Turn up = turn_by(latitude);
  const Turn around = turn_by(longitude);
  const Vector3 stand_in = {up.c * around.c, up.c * around.s, up.s};
  if (changed == 0 || !same_pattern(v, stand_in)) {
    return v;
  }
  *this = numbers;
  return seen_as(v, stand_in);
}

}  // namespace treedyn::formulate
