#include "formulate/geometry.hpp"

#include <algorithm>

#include "common/provenance.hpp"

namespace treedyn::formulate {

namespace {

const Real kTiny("1e-40");

bool is_close(const Real& x, int exact) {
  return Real::both(x, x, [exact](const Digits& value, const Digits&) {
    return abs(value - exact) < kTiny.digits();
  });
}

Real cleaned(const Real& x) {
  for (const int exact : {0, 1, -1}) {
    if (is_close(x, exact)) {
      return exact;
    }
  }
  return x;
}

Turn cleaned(const Turn& turn) { return {cleaned(turn.c), cleaned(turn.s)}; }

/// Zero where the numbers cancel but for rounding, which would be a constant of the code else.
Real sum_or_zero(const Real& a, const Real& b) {
  if (a.recipe() == 0 && b.recipe() == 0 && (a == 0 || b == 0)) {
    return a != 0 ? a : b != 0 ? b : Real(0);
  }
  const Real total = a + b;
  return negligible(total, larger(a, b)) ? Real(0) : total;
}

template <class Array, class Operation>
Array map(const Array& a, const Array& b, Operation operation) {
  Array result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result[i] = operation(a[i], b[i]);
  }
  return result;
}

}  // namespace

Vector3 operator+(const Vector3& a, const Vector3& b) { return map(a, b, sum_or_zero); }
Vector3 operator-(const Vector3& a, const Vector3& b) {
  return map(a, b, [](const Real& x, const Real& y) { return sum_or_zero(x, -y); });
}
Vector3 operator*(const Real& s, const Vector3& a) { return {s * a[0], s * a[1], s * a[2]}; }
Real dot(const Vector3& a, const Vector3& b) {
  return sum_or_zero(sum_or_zero(a[0] * b[0], a[1] * b[1]), a[2] * b[2]);
}
Vector3 cross(const Vector3& a, const Vector3& b) {
  const auto component = [&](std::size_t i, std::size_t k) {
    return sum_or_zero(a[i] * b[k], -(a[k] * b[i]));
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

Vector3 multiply(const Matrix3& m, const Vector3& v) {
  return {dot({m[0], m[1], m[2]}, v), dot({m[3], m[4], m[5]}, v), dot({m[6], m[7], m[8]}, v)};
}

Vector3 multiply_transposed(const Matrix3& m, const Vector3& v) {
  return multiply(transpose(m), v);
}

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result[3 * i + k] = dot({a[3 * i], a[3 * i + 1], a[3 * i + 2]}, {b[k], b[3 + k], b[6 + k]});
    }
  }
  return result;
}

Matrix3 transpose(const Matrix3& a) {
  return {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]};
}
Matrix3 congruence(const Matrix3& rotation, const Matrix3& s) {
  return multiply(multiply(rotation, s), transpose(rotation));
}
Matrix3 identity() { return {1, 0, 0, 0, 1, 0, 0, 0, 1}; }

Matrix3 outer(const Vector3& a, const Vector3& b) {
  Matrix3 result;
  for (std::size_t i = 0; i < 9; ++i) {
    result[i] = a[i / 3] * b[i % 3];
  }
  return result;
}

Matrix3 operator+(const Matrix3& a, const Matrix3& b) { return map(a, b, sum_or_zero); }
Matrix3 operator-(const Matrix3& a, const Matrix3& b) {
  return map(a, b, [](const Real& x, const Real& y) { return sum_or_zero(x, -y); });
}
Matrix3 operator*(const Real& s, const Matrix3& a) {
  return map(a, a, [&](const Real& x, const Real&) { return Real(s * x); });
}

Matrix3 second_moments(const Matrix3& tensor) {
  return Real((tensor[0] + tensor[4] + tensor[8]) / 2) * identity() - tensor;
}

bool is_fixed(std::span<const Real> numbers) {
  return std::ranges::all_of(numbers, [](const Real& x) { return x.recipe() == 0; });
}

Vector3 plain(const Vector3& v) { return {v[0].plain(), v[1].plain(), v[2].plain()}; }

Matrix3 clean(Matrix3 rotation) {
  for (Real& entry : rotation) {
    entry = cleaned(entry);
  }
  return rotation;
}

Turn turn_to(const Real& x, const Real& y) {
  const Real length = sqrt(x * x + y * y);
  const auto part = [&](const Real& of, int else_) {
    return Real::map(of, length, [else_](const Digits& a, const Digits& b) {
      return b == 0 ? Digits(else_) : Digits(a / b);
    });
  };
  const Turn turn = {part(x, 1), part(y, 0)};
  note_result(RecipeKind::kDivide, x, length, turn.c);
  note_result(RecipeKind::kDivide, y, length, turn.s);
  return cleaned(turn);
}

Turn turn_by(const Real& angle) { return cleaned(Turn{cos(angle), sin(angle)}); }
Turn with_right_angles(const Turn& turn) {
  const Turn seen = cleaned(Turn{turn.c.seen(), turn.s.seen()});
  return seen.is_quarter() ? seen : turn;
}
Turn operator*(const Turn& a, const Turn& b) {
  return cleaned(Turn{a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s});
}
Real angle_of(const Turn& turn) { return atan2(turn.s, turn.c); }
Matrix3 about_z(const Turn& turn) { return {turn.c, -turn.s, 0, turn.s, turn.c, 0, 0, 0, 1}; }

namespace {

/// Of numbers without stand-ins.
EulerZxz angles_of(const Matrix3& r) {
  const Real sine = sqrt(r[2] * r[2] + r[5] * r[5]);
  if (sine < kTiny) {  // axes parallel: one turn says all
    return {turn_to(r[0], r[3]), {r[8] > 0 ? 1 : -1, 0}, {}};
  }
  const Turn gamma = turn_to(-r[5], r[2]);
  // of the first row of Rz(-gamma) R: where the axes are nearly parallel, r[7] and r[6] are
  // rounding
  const Turn epsilon = turn_to(gamma.c * r[0] + gamma.s * r[3], -(gamma.c * r[1] + gamma.s * r[4]));
  return {gamma, turn_to(r[8], sine), epsilon};
}

/// Of a rotation.
Turn seen_as(const Turn& a, const Turn& stand_in, const Matrix3& rotation) {
  Turn turn = {Real::seen_as(a.c.digits(), stand_in.c.digits()),
               Real::seen_as(a.s.digits(), stand_in.s.digits())};
  note_ratio(rotation, turn.c);
  note_ratio(rotation, turn.s);
  return turn;
}

}  // namespace

EulerZxz euler_zxz(const Matrix3& r) {
  Matrix3 own;
  Matrix3 seen;
  std::ranges::transform(r, own.begin(), [](const Real& x) { return x.plain(); });
  std::ranges::transform(r, seen.begin(), [](const Real& x) { return Real(x.seen()); });
  const EulerZxz angles = angles_of(own);
  const bool differ = std::ranges::any_of(r, [](const Real& x) { return x.has_stand_in(); });
  const EulerZxz stand_ins = differ ? angles_of(seen) : angles;
  return {seen_as(angles.gamma, stand_ins.gamma, r), seen_as(angles.alpha, stand_ins.alpha, r),
          seen_as(angles.epsilon, stand_ins.epsilon, r)};
}

}  // namespace treedyn::formulate
