#include "description/vectors.hpp"

#include <algorithm>

namespace treedyn::description {

Matrix3 identity() { return {1, 0, 0, 0, 1, 0, 0, 0, 1}; }

Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector3 operator*(const Real& s, const Vector3& a) { return {s * a[0], s * a[1], s * a[2]}; }

Matrix3 operator+(const Matrix3& a, const Matrix3& b) {
  Matrix3 result;
  std::ranges::transform(a, b, result.begin(),
                         [](const Real& x, const Real& y) { return Real(x + y); });
  return result;
}

Vector3 operator*(const Matrix3& a, const Vector3& x) {
  return {a[0] * x[0] + a[1] * x[1] + a[2] * x[2], a[3] * x[0] + a[4] * x[1] + a[5] * x[2],
          a[6] * x[0] + a[7] * x[1] + a[8] * x[2]};
}

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  Matrix3 result;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      result[3 * k + l] = a[3 * k] * b[l] + a[3 * k + 1] * b[3 + l] + a[3 * k + 2] * b[6 + l];
    }
  }
  return result;
}

Matrix3 transposed(const Matrix3& a) {
  return {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]};
}

Real dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real norm(const Vector3& a) { return sqrt(dot(a, a)); }

Real determinant(const Matrix3& a) {
  return dot({a[0], a[1], a[2]}, cross({a[3], a[4], a[5]}, {a[6], a[7], a[8]}));
}

Real distance(const Matrix3& a, const Matrix3& b) {
  Real largest = 0;
  for (std::size_t k = 0; k < 9; ++k) {
    largest = std::max(largest, Real(abs(a[k] - b[k])));
  }
  return largest;
}

Matrix3 point_inertia(const Real& m, const Vector3& d) {
  const Vector3 h = m * d;
  return {h[1] * d[1] + h[2] * d[2], -h[0] * d[1], -h[0] * d[2], -h[0] * d[1],
          h[0] * d[0] + h[2] * d[2], -h[1] * d[2], -h[0] * d[2], -h[1] * d[2],
          h[0] * d[0] + h[1] * d[1]};
}

namespace {

/// One Jacobi rotation in the plane (p, q): makes a_pq zero (Golub, Van Loan: Matrix
/// Computations, 8.5.2).
void rotate(Matrix3& a, std::size_t p, std::size_t q) {
  if (a[3 * p + q] == 0) {
    return;
  }
  const Real theta = (a[4 * q] - a[4 * p]) / (2 * a[3 * p + q]);
  const Real t = (theta < 0 ? Real(-1) : Real(1)) / (abs(theta) + sqrt(theta * theta + 1));
  const Real c = 1 / sqrt(t * t + 1);
  const Real s = t * c;
  Matrix3 turn = identity();
  turn[4 * p] = turn[4 * q] = c;
  turn[3 * p + q] = s;
  turn[3 * q + p] = -s;
  a = transposed(turn) * a * turn;
}

}  // namespace

Vector3 eigenvalues(const Matrix3& a) {
  Matrix3 rest = a;
  const auto off_diagonal = [&rest] {
    return abs(rest[1]) + abs(rest[2]) + abs(rest[5]);
  };
  const Real enough = off_diagonal() * Real("1e-25");  // the eigenvalues are off by its square
  for (int sweep = 0; sweep < 12 && off_diagonal() > enough; ++sweep) {
    rotate(rest, 0, 1);
    rotate(rest, 0, 2);
    rotate(rest, 1, 2);
  }
  Vector3 result = {rest[0], rest[4], rest[8]};
  std::ranges::sort(result);
  return result;
}

}  // namespace treedyn::description
