// Constant vectors, rotations and plane turns with 50 digits.
#pragma once

#include <span>

#include "model/tree.hpp"

namespace treedyn::formulate {

using model::Matrix3;
using model::Vector3;

Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator*(const Real& s, const Vector3& a);
Real dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
Vector3 multiply(const Matrix3& m, const Vector3& v);
Vector3 multiply_transposed(const Matrix3& m, const Vector3& v);
Matrix3 multiply(const Matrix3& a, const Matrix3& b);
Matrix3 transpose(const Matrix3& a);
/// R S R^T.
Matrix3 congruence(const Matrix3& rotation, const Matrix3& s);
Matrix3 identity();
/// a b^T.
Matrix3 outer(const Vector3& a, const Vector3& b);
Matrix3 operator+(const Matrix3& a, const Matrix3& b);
Matrix3 operator-(const Matrix3& a, const Matrix3& b);
Matrix3 operator*(const Real& s, const Matrix3& a);
/// tr(I)/2 - I, the second moments of the body whose inertia tensor is I.
Matrix3 second_moments(const Matrix3& tensor);

/// True if the numbers are the same at run time.
bool is_fixed(std::span<const Real> numbers);
/// The numbers themselves, without stand-ins.
Vector3 plain(const Vector3& v);

/// Makes entries exact that rounding left next to -1, 0 or 1.
Matrix3 clean(Matrix3 rotation);

/// A plane rotation by a constant angle, kept as cosine and sine so that right angles stay exact.
struct Turn {
  Real c = 1;
  Real s = 0;

  [[nodiscard]] bool is_identity() const { return s == 0 && c == 1; }
  /// Multiple of pi/2.
  [[nodiscard]] bool is_quarter() const {
    return s == 0 ? c == 1 || c == -1 : c == 0 && (s == 1 || s == -1);
  }
  [[nodiscard]] Turn inverse() const { return {c, -s}; }
};

/// Rotation from the direction (x, y), which need not have unit length; identity for (0, 0).
Turn turn_to(const Real& x, const Real& y);
Turn turn_by(const Real& angle);
/// The right angle that `turn` is seen as, if it is.
Turn with_right_angles(const Turn& turn);
Turn operator*(const Turn& a, const Turn& b);
Real angle_of(const Turn& turn);
Matrix3 about_z(const Turn& turn);

/// R = Rz(gamma) Rx(alpha) Rz(epsilon), alpha in [0, pi].
struct EulerZxz {
  Turn gamma;
  Turn alpha;
  Turn epsilon;
};
EulerZxz euler_zxz(const Matrix3& rotation);

}  // namespace treedyn::formulate
