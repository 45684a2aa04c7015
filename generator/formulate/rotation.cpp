#include "formulate/rotation.hpp"

#include <algorithm>
#include <map>

namespace treedyn::formulate {

namespace {

Angle combine(const Angle& a, const Angle& b, int sign) {
  std::map<int, Real> terms(a.terms.begin(), a.terms.end());
  for (const auto& [coordinate, coefficient] : b.terms) {
    terms[coordinate] += sign * coefficient;
  }
  Angle result;
  for (const auto& [coordinate, coefficient] : terms) {
    if (coefficient != 0) {
      result.terms.emplace_back(coordinate, coefficient);
    }
  }
  result.turn = a.turn * (sign > 0 ? b.turn : b.turn.inverse());
  return result;
}

}  // namespace

Angle operator+(const Angle& a, const Angle& b) { return combine(a, b, 1); }
Angle operator-(const Angle& a, const Angle& b) { return combine(a, b, -1); }

Angle constant_angle(const Turn& turn) { return {{}, turn}; }

CosineAndSine quarter_turned(const CosineAndSine& of, const Turn& quarter) {
  const auto& [c, s] = of;
  if (quarter.s == 0) {
    return quarter.c > 0 ? std::pair(c, s) : std::pair(-c, -s);
  }
  return quarter.s > 0 ? std::pair(-s, c) : std::pair(s, -c);
}

bool same_quarter(const std::vector<Angle>& angles) {
  const Turn& first = angles.front().turn;
  return first.is_quarter() && std::ranges::all_of(angles, [&](const Angle& a) {
           return a.turn.c == first.c && a.turn.s == first.s;
         });
}

CosineAndSine added(const CosineAndSine& a, const CosineAndSine& b) {
  return {a.first * b.first - a.second * b.second, a.second * b.first + a.first * b.second};
}

Vec3 PlaneRotation::forward(const Vec3& v) const {
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  Vec3 r = v;
  r[i] = c * v[i] - s * v[j];
  r[j] = s * v[i] + c * v[j];
  return r;
}

Vec3 PlaneRotation::backward(const Vec3& v) const { return PlaneRotation{axis, c, -s}.forward(v); }

Mat3 PlaneRotation::forward_symmetric(const Mat3& a) const {
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  Mat3 r = a;
  const Expr xx = a[i][i];
  const Expr yy = a[j][j];
  const Expr xy = a[i][j];
  if (s.is_zero()) {
    // a half turn leaves the block as it is
  } else if (c.is_zero()) {
    r[i][i] = yy;
    r[j][j] = xx;
    r[i][j] = r[j][i] = -xy;
  } else {
    const Expr two_c_xy = xy.is_fixed() ? c * (xy + xy) : (c + c) * xy;
    const Expr u = s * (xx - yy) + two_c_xy;
    const Expr t = s * u;
    r[i][i] = xx - t;
    r[j][j] = yy + t;
    r[i][j] = r[j][i] = c * u - xy;
  }
  const Vec3 off = forward(column(a, axis));
  r[i][axis] = r[axis][i] = off[i];
  r[j][axis] = r[axis][j] = off[j];
  return r;
}

Mat3 PlaneRotation::forward_general(const Mat3& h) const {
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  Mat3 r = h;
  if (c.is_zero()) {
    r[i][i] = h[j][j];
    r[j][j] = h[i][i];
    r[i][j] = -h[j][i];
    r[j][i] = -h[i][j];
  } else if (!s.is_zero()) {
    const Expr u = s * (h[i][i] - h[j][j]) + c * (h[i][j] + h[j][i]);
    const Expr t = s * u;
    const Expr cu = c * u;
    r[i][i] = h[i][i] - t;
    r[j][j] = h[j][j] + t;
    r[i][j] = cu - h[j][i];
    r[j][i] = cu - h[i][j];
  }
  const Vec3 last_column = forward(column(h, axis));
  const Vec3 last_row = forward(h[axis]);
  for (const std::size_t k : {i, j}) {
    r[k][axis] = last_column[k];
    r[axis][k] = last_row[k];
  }
  return r;
}

}  // namespace treedyn::formulate
