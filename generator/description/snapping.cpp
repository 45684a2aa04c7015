#include "description/snapping.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::description {

namespace {

const Real& rounding_limit() {
  static const Real value("1e-40");
  return value;
}
const Real& miss_limit() {
  static const Real value("1e-4");
  return value;
}
const Real& rotation_limit() {
  static const Real value("1e-9");
  return value;
}

struct Exact {
  Real value;
  std::string text;
};

/// sin(k pi/12), k = 0..6.
const std::array<Exact, 7>& sines() {
  static const std::array<Exact, 7> values = {{
      {Real(0), "0"},
      {Real((sqrt(Real(6)) - sqrt(Real(2))) / 4), "(sqrt(6)-sqrt(2))/4"},
      {Real(0.5), "1/2"},
      {Real(sqrt(Real(2)) / 2), "sqrt(2)/2"},
      {Real(sqrt(Real(3)) / 2), "sqrt(3)/2"},
      {Real((sqrt(Real(6)) + sqrt(Real(2))) / 4), "(sqrt(6)+sqrt(2))/4"},
      {Real(1), "1"},
  }};
  return values;
}

/// sin(k pi/12) for any k.
Real exact_sine(long k) {
  const long turn = ((k % 24) + 24) % 24;
  const long half = turn % 12;
  const Real& value = sines()[static_cast<std::size_t>(half <= 6 ? half : 12 - half)].value;
  return turn < 12 ? value : Real(-value);
}

/// "pi/2", "-5*pi/12", "0".
std::string angle_text(long k) {
  if (k == 0) {
    return "0";
  }
  const long divisor = std::gcd(k, 12L);
  const long numerator = std::abs(k) / divisor;
  return fmt::format("{}{}pi{}", k < 0 ? "-" : "",
                     numerator == 1 ? "" : fmt::format("{}*", numerator),
                     divisor == 12 ? "" : fmt::format("/{}", 12 / divisor));
}

/// True for pi/2 as 1.57 or 1.570000, pi/4 as 0.785: a multiple k of pi/12, rounded or cut off to a
/// few digits.
bool has_few_digits_of(const Real& exact, long k, const Real& angle, std::string text) {
  const Real change = abs(angle - exact);
  if (k == 0 || change > 0.01) {
    return false;
  }
  if (text.find('.') != std::string::npos && text.find_first_of("eE") == std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
  }
  if (!read_decimal(text)) {  // but an expression
    return false;
  }
  const Real half_unit = half_unit_of_last_digit(text);
  const bool telling = half_unit < (k % 6 == 0 ? 0.0051 : 0.00051);
  return telling && change <= (abs(angle) < abs(exact) ? 2 : 1) * half_unit;
}

/// The exact value next to `entry`.
Exact nearest_exact(const Real& entry) {
  const Real size = abs(entry);
  const auto* const best = std::ranges::min_element(sines(), [&](const Exact& a, const Exact& b) {
    return abs(a.value - size) < abs(b.value - size);
  });
  const bool negative = entry < 0 && best->value != 0;
  return {negative ? Real(-best->value) : best->value,
          fmt::format("{}{}", negative ? "-" : "", best->text)};
}

Real tidied_entry(const Real& entry) {
  const Exact exact = nearest_exact(entry);
  return abs(entry - exact.value) <= rounding_limit() ? exact.value : entry;
}

/// Entries that differ from 0, +-1/2, +-sqrt(2)/2 .. +-1 by rounding at 50 digits made exact.
Matrix3 tidied(const Matrix3& rotation) {
  Matrix3 result;
  std::ranges::transform(rotation, result.begin(), tidied_entry);
  return result;
}

/// The rotation next to M in the sense of least squares: Newton's iteration M <- (M + M^-T)/2 for
/// the polar factor (Higham: Functions of Matrices, 8.3). \pre M is regular and close to a
/// rotation.
Matrix3 nearest_rotation(Matrix3 m) {
  for (int step = 0; step < 12; ++step) {
    const Vector3 x{m[0], m[1], m[2]};
    const Vector3 y{m[3], m[4], m[5]};
    const Vector3 z{m[6], m[7], m[8]};
    const Vector3 yz = cross(y, z);
    const Vector3 zx = cross(z, x);
    const Vector3 xy = cross(x, y);
    const Real det = dot(x, yz);
    const Matrix3 cofactors = {yz[0], yz[1], yz[2], zx[0], zx[1], zx[2], xy[0], xy[1], xy[2]};
    Matrix3 next;
    std::ranges::transform(m, cofactors, next.begin(),
                           [&](const Real& a, const Real& c) { return Real((a + c / det) / 2); });
    const Real change = distance(m, next);
    m = next;
    if (change <= Real("1e-30")) {  // quadratic: the next change is below 1e-50
      break;
    }
  }
  return m;
}

/// An entry of a rotation or axis, the exact value next to it, and whether it takes that value.
struct Entry {
  Real value;
  Exact exact;
  bool snaps = false;
};

/// Normalises the entries with the snapping ones exact; those that do not stay exact snap no more.
/// \return true if all stayed exact
template <std::size_t size, typename Project>
bool settled(std::array<Entry, size>& entries, const Project& project,
             std::array<Real, size>& result) {
  std::ranges::transform(entries, result.begin(), [](const Entry& entry) {
    return entry.snaps ? entry.exact.value : entry.value;
  });
  result = project(result);
  bool all = true;
  for (std::size_t k = 0; k < size; ++k) {
    if (entries[k].snaps && abs(result[k] - entries[k].exact.value) > rounding_limit()) {
      entries[k].snaps = all = false;
    }
  }
  return all;
}

std::string element(const std::string& what, std::size_t index) {
  return fmt::format("{}[{}]", what, index);
}

std::string list_text(const Numbers& written) {
  std::string result;
  for (const Text& text : written.values) {
    result += fmt::format("{}{}", result.empty() ? "" : ", ", shown(text.text));
  }
  return fmt::format("[{}]", result);
}

}  // namespace

void Snapper::record(const Real& given, const Real& exact, const std::string& exact_text,
                     const Text& written, const std::string& what, bool few_digits) {
  const Real change = abs(given - exact);
  const Place& where = written.where;
  if (change > rounding_limit() && change <= tolerance_) {
    log_.snaps.push_back({location(raw_, where), what, written.text, exact_text, change});
  } else if (change > rounding_limit() && (change <= miss_limit() || few_digits)) {
    log_.misses.push_back(
        {location(raw_, where),
         fmt::format("{} {} is {:.3g} away from {}; not changed", what, shown(written.text),
                     change.convert_to<double>(), exact_text)});
  }
}

Snapper::SinCos Snapper::sin_cos(const Real& angle, const Text& written, const std::string& what) {
  if (abs(angle) > 1000) {  // also keeps k in range
    return {sin(angle), cos(angle)};
  }
  const Real step = pi() / 12;
  const long k = lround(Real(angle / step));
  const Real exact = Real(k) * step;
  record(angle, exact, angle_text(k), written, what,
         has_few_digits_of(exact, k, angle, written.text));
  if (abs(angle - exact) <= std::max(tolerance_, rounding_limit())) {
    return {exact_sine(k), exact_sine(k + 6)};
  }
  return {sin(angle), cos(angle)};
}

Matrix3 Snapper::from_rpy(const Vector3& rpy, const Numbers& written, const std::string& what) {
  const auto [sr, cr] = sin_cos(rpy[0], written.values[0], element(what, 0));
  const auto [sp, cp] = sin_cos(rpy[1], written.values[1], element(what, 1));
  const auto [sy, cy] = sin_cos(rpy[2], written.values[2], element(what, 2));
  return tidied({cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
                 sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,  //
                 -sp, cp * sr, cp * cr});
}

/// Replaces entries by exact values, as many as stay exact when `project` normalises the whole.
template <std::size_t size, typename Project>
std::array<Real, size> Snapper::snap_entries(const std::array<Real, size>& given,
                                             const Numbers& written, const std::string& what,
                                             const Project& project) {
  std::array<Entry, size> entries;
  std::ranges::transform(given, entries.begin(), [this](const Real& value) {
    const Exact exact = nearest_exact(value);
    const bool near = abs(value - exact.value) <= std::max(tolerance_, rounding_limit());
    return Entry{value, exact, near};
  });
  std::array<Real, size> result;
  while (!settled(entries, project, result)) {
  }
  for (std::size_t k = 0; k < size; ++k) {
    const Entry& entry = entries[k];
    result[k] = tidied_entry(result[k]);
    const bool telling = abs(entry.exact.value) != 1;  // the others in its row tell more
    if (entry.snaps || (telling && abs(entry.value - entry.exact.value) > tolerance_)) {
      record(entry.value, entry.exact.value, entry.exact.text, written.values[k], element(what, k));
    }
  }
  return result;
}

Matrix3 Snapper::from_matrix(const Matrix3& matrix, const Numbers& written,
                             const std::string& what) {
  const Real off = distance(matrix * transposed(matrix), identity());
  const bool close = off < Real(0.01) && determinant(matrix) > 0;
  const Real error = close ? distance(matrix, nearest_rotation(matrix)) : Real(1);
  if (error > rotation_limit()) {
    const bool mirrored = off < Real(0.01) && determinant(matrix) < 0;
    throw InputError(
        location(raw_, written.where),
        fmt::format("{} {} is {}; expected one within 1e-9", what, list_text(written),
                    mirrored ? "mirrored, its determinant is -1, and no rotation" : "no rotation"));
  }
  return snap_entries(matrix, written, what, nearest_rotation);
}

Matrix3 Snapper::composed(const Matrix3& product, const Place& where, const std::string& what) {
  Numbers entries{{}, where};
  for (const Real& entry : product) {
    entries.values.push_back({fmt::format("{:.17g}", entry.convert_to<double>()), where});
  }
  return snap_entries(product, entries, what, nearest_rotation);
}

Vector3 Snapper::unit_axis(const Vector3& axis, const Numbers& written, const std::string& what) {
  const Real length = norm(axis);
  if (length == 0) {
    throw InputError(
        location(raw_, written.where),
        fmt::format("{} {} has zero length; expected a non-zero vector", what, list_text(written)));
  }
  const auto normalised = [](const Vector3& v) {
    return Real(1 / norm(v)) * v;
  };
  return snap_entries(normalised(axis), written, what, normalised);
}

}  // namespace treedyn::description
