#include "formulate/stand_ins.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "formulate/find_limbs.hpp"
#include "formulate/geometry.hpp"
#include "formulate/origins.hpp"
#include "model/parameters.hpp"
#include "program/random.hpp"

namespace treedyn::formulate {

namespace {

enum class Quantity : std::uint8_t { kMass, kOffset, kCom, kInertia, kAngle, kGravity };
constexpr std::size_t kQuantities = 6;
/// Stand-ins lie from the first to the second number: a robot of the size of a dog.
constexpr std::array<std::array<double, 2>, kQuantities> kRanges = {
    {{1.2, 4}, {0.1, 0.4}, {0.1, 0.4}, {0.02, 0.08}, {0.2, 0.6}, {8, 12}}};
/// Lengths below this one are rounding of zeros.
constexpr double kShort = 1e-6;
/// Angles below this one are nearly zero: their decades matter.
constexpr double kSmall = 1e-3;
/// Any set of stand-ins does; with this one the models of the repository cost least among a few.
constexpr std::uint64_t kSet = 3;
/// Beyond the places of links and points.
constexpr int kParameterPlaces = 1 << 24;

bool same(const Digits& a, const Digits& b) {
  return abs(a - b) <= (abs(a) + abs(b)) * Digits("1e-38");
}

/// A number with 50 digits that nothing but its place decides.
Digits generic(Quantity quantity, int place) {
  const auto q = static_cast<std::size_t>(quantity);
  program::Random random(program::scramble(static_cast<std::uint64_t>(place) + (kSet << 40U)) + q);
  Digits u = 0;
  for (int k = 0; k < 3; ++k) {
    u = ldexp(Digits(u + random.next()), -64);
  }
  return kRanges[q][0] + (kRanges[q][1] - kRanges[q][0]) * u;
}

/// What all numbers of one quantity and magnitude are seen as. Equal numbers of links that are not
/// alike are no structure, but for angles and distances of joints.
class Numbers {
 public:
  /// Links that are alike have one.
  void set_group(int group) { group_ = group; }

  Real of(Quantity quantity, const Real& x, int place) {
    const Digits magnitude = abs(x.digits());
    if (magnitude == 0 || magnitude == 1) {
      return x;
    }
    const Digits stand_in = of_magnitude(quantity, magnitude, place);
    return Real::seen_as(x.digits(), x.digits() < 0 ? Digits(-stand_in) : stand_in);
  }

  /// An angle: multiples of pi/12 are seen as such, the others in their eighth of a turn.
  Digits of_angle(const Digits& angle, int place, int& changed) {
    const Digits twelfth = pi().digits() / 12;
    if (same(angle / twelfth + 100, round(Digits(angle / twelfth)) + 100)) {
      return angle;
    }
    ++changed;
    const Digits quarters = 6 * twelfth * round(Digits(angle / (6 * twelfth)));
    const Digits rest = angle - quarters;
    const Digits stand_in = of_magnitude(Quantity::kAngle, abs(rest), place);
    return rest < 0 ? quarters - stand_in : quarters + stand_in;
  }

 private:
  struct Known {
    int group;
    Digits magnitude;
    Digits stand_in;
  };

  Digits of_magnitude(Quantity quantity, const Digits& magnitude, int place) {
    std::vector<Known>& known = known_[static_cast<std::size_t>(quantity)];
    const bool of_robot = quantity == Quantity::kAngle || quantity == Quantity::kOffset;
    const int group = of_robot ? 0 : group_;
    for (const Known& k : known) {
      if (k.group == group && same(k.magnitude, magnitude)) {
        return k.stand_in;
      }
    }
    known.push_back({group, magnitude, scale(quantity, magnitude) * generic(quantity, place)});
    return known.back().stand_in;
  }

  static Digits scale(Quantity quantity, const Digits& magnitude) {
    const bool length = quantity == Quantity::kOffset || quantity == Quantity::kCom;
    if (length && magnitude < kShort) {
      return Digits("1e-8");
    }
    if (quantity == Quantity::kAngle && magnitude < kSmall) {
      return pow(Digits(100), floor(Digits(log10(magnitude) / 2)));
    }
    return 1;
  }

  std::array<std::vector<Known>, kQuantities> known_;
  int group_ = 0;
};

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

class StandIns {
 public:
  Seen run(const model::Tree& tree, const Options& options);

 private:
  /// The next place: each link begins a row of its own.
  int next() { return place_++; }
  void row(int i, int group) {
    place_ = kRow * i;
    numbers_.set_group(group);
  }
  Real number(Quantity quantity, const Real& x) { return numbers_.of(quantity, x, next()); }
  Vector3 vector(Quantity quantity, const Vector3& v) {
    const Real x = number(quantity, v[0]);
    const Real y = number(quantity, v[1]);
    return {x, y, number(quantity, v[2])};
  }
  Matrix3 symmetric(const Matrix3& m);
  Matrix3 rotation(const Matrix3& r);
  Vector3 axis(const Vector3& v);
  void see(model::Link& link);
  void see(model::Point& point);

  static constexpr int kRow = 64;
  Numbers numbers_;
  int place_ = 0;
};

Matrix3 StandIns::symmetric(const Matrix3& m) {
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = i; k < 3; ++k) {
      result[3 * i + k] = result[3 * k + i] = number(Quantity::kInertia, m[3 * i + k]);
    }
  }
  return result;
}

/// By the three angles of which most are exact and which keep its pattern.
Matrix3 StandIns::rotation(const Matrix3& r) {
  const int place = place_;
  place_ += 3;
  if (is_exact(r)) {
    return r;
  }
  Numbers best_numbers = numbers_;
  std::optional<Matrix3> best;
  int fewest = 4;
  for (const Axes& axes : kOrders) {
    Numbers numbers = numbers_;
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
  numbers_ = best_numbers;
  return seen_as(r, *best);
}

/// A unit vector by longitude and latitude.
Vector3 StandIns::axis(const Vector3& v) {
  const int place = place_;
  place_ += 2;
  if (is_exact(v)) {
    return v;
  }
  Numbers numbers = numbers_;
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
  numbers_ = numbers;
  return seen_as(v, stand_in);
}

void StandIns::see(model::Link& link) {
  link.joint.axis = axis(link.joint.axis);
  link.joint.rotation = rotation(link.joint.rotation);
  link.joint.offset = vector(Quantity::kOffset, link.joint.offset);
  link.inertia.mass = number(Quantity::kMass, link.inertia.mass);
  link.inertia.com = vector(Quantity::kCom, link.inertia.com);
  link.inertia.about_com = symmetric(link.inertia.about_com);
}

void StandIns::see(model::Point& point) {
  point.at = vector(Quantity::kOffset, point.at);
  point.rotation = rotation(point.rotation);
}

/// For every link the group of links that are alike.
std::vector<int> groups_of(const model::Tree& tree) {
  std::vector<int> groups(tree.links.size());
  int group = 0;
  for (const std::vector<int>& links : similar_links(tree)) {
    ++group;
    for (const int i : links) {
      groups[static_cast<std::size_t>(i)] = group;
    }
  }
  return groups;
}

Seen StandIns::run(const model::Tree& tree, const Options& options) {
  Seen seen{tree, options};
  const std::vector<int> groups = groups_of(tree);
  int rows = 0;
  for (model::Link& link : seen.tree.links) {
    row(rows, groups[static_cast<std::size_t>(rows)]);
    see(link);
    ++rows;
  }
  for (model::Frame& frame : seen.tree.frames) {
    row(rows++, 0);
    frame.rotation = rotation(frame.rotation);
    frame.origin = vector(Quantity::kOffset, frame.origin);
  }
  for (std::vector<model::Point>* points : {&seen.tree.points, &seen.options.points}) {
    for (model::Point& point : *points) {
      row(rows++, -1);
      see(point);
    }
  }
  row(rows, 0);
  seen.options.gravity = vector(Quantity::kGravity, options.gravity);
  return seen;
}

/// Numbers that are known at run time only are like no other number, zeros and ones as well.
void see_parameters(Seen& seen) {
  constexpr std::array<Quantity, 4> kParts = {Quantity::kMass, Quantity::kCom, Quantity::kInertia,
                                              Quantity::kGravity};
  int index = 0;
  for (const model::Parameter& parameter : seen.tree.parameters) {
    const Quantity quantity = kParts[static_cast<std::size_t>(parameter.quantity)];
    const Digits stand_in = generic(quantity, kParameterPlaces + index);
    const Real nominal = model::nominal(seen.tree, seen.options.gravity, parameter);
    model::set(seen.tree, seen.options.gravity, parameter,
               Real::of_parameter(index, nominal.digits(), stand_in));
    ++index;
  }
}

void forget(Real& number) {
  number = number.recipe() == 0 ? Real(number.seen())
                                : Real::of_parameter(-1, number.seen(), number.seen());
}

template <class... Arrays>
void forget_numbers(Arrays&... arrays) {
  (std::ranges::for_each(arrays, [](Real& number) { forget(number); }), ...);
}

}  // namespace

Seen with_stand_ins(const model::Tree& tree, const Options& options) {
  Seen seen = StandIns().run(tree, options);
  see_parameters(seen);
  note_provenance(seen);
  return seen;
}

Seen with_parameters(const model::Tree& tree, const Options& options) {
  Seen seen{tree, options};
  see_parameters(seen);
  return seen;
}

Seen stand_ins_alone(const model::Tree& tree, const Options& options) {
  Seen seen{tree, options};
  for (model::Link& link : seen.tree.links) {
    forget_numbers(link.joint.axis, link.joint.rotation, link.joint.offset, link.inertia.com,
                   link.inertia.about_com);
    forget(link.inertia.mass);
  }
  for (model::Frame& frame : seen.tree.frames) {
    forget_numbers(frame.rotation, frame.origin);
  }
  for (std::vector<model::Point>* points : {&seen.tree.points, &seen.options.points}) {
    for (model::Point& point : *points) {
      forget_numbers(point.at, point.rotation);
    }
  }
  forget_numbers(seen.options.gravity);
  return seen;
}

}  // namespace treedyn::formulate
