// Vectors and 3x3 tensors whose components are expressions, with the operators of the equations.
#pragma once

#include <array>
#include <vector>

#include "model/tree.hpp"
#include "program/graph.hpp"

namespace treedyn::formulate {

using program::Expr;
using program::Graph;

using Vec3 = std::array<Expr, 3>;
using Mat3 = std::array<std::array<Expr, 3>, 3>;  ///< row by row

inline constexpr std::size_t kSize = 3;

/// The three values as a vector.
inline Vec3 triple(const std::vector<Expr>& values) { return {values[0], values[1], values[2]}; }

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator-(const Vec3& a) { return {-a[0], -a[1], -a[2]}; }
inline Vec3 operator*(Expr s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }

inline Expr dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec3 column(const Mat3& a, std::size_t k) { return {a[0][k], a[1][k], a[2][k]}; }
inline Vec3 operator*(const Mat3& a, const Vec3& b) {
  return {dot(a[0], b), dot(a[1], b), dot(a[2], b)};
}

/// a b, both general.
inline Mat3 operator*(const Mat3& a, const Mat3& b) {
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result[i][k] = dot(a[i], column(b, k));
    }
  }
  return result;
}

/// Λ(a).
inline Mat3 skew(const Vec3& a) {
  return {{{Expr(), -a[2], a[1]}, {a[2], Expr(), -a[0]}, {-a[1], a[0], Expr()}}};
}

/// Lambda(w)^2 for the angular velocity w: the centrifugal part of Omega in EQUATIONS.md 7.2.
inline Mat3 skew_squared(const Vec3& w) {
  const Expr xx = w[0] * w[0];
  const Expr yy = w[1] * w[1];
  const Expr zz = w[2] * w[2];
  const Expr xy = w[0] * w[1];
  const Expr xz = w[0] * w[2];
  const Expr yz = w[1] * w[2];
  return {{{-(yy + zz), xy, xz}, {xy, -(xx + zz), yz}, {xz, yz, -(xx + yy)}}};
}

inline Expr constant(Graph& graph, const Real& value) { return Expr(graph, graph.constant(value)); }
inline Vec3 constant(Graph& graph, const model::Vector3& v) {
  return {constant(graph, v[0]), constant(graph, v[1]), constant(graph, v[2])};
}
inline Mat3 constant(Graph& graph, const model::Matrix3& m) {
  Mat3 result;
  for (std::size_t i = 0; i < 9; ++i) {
    result[i / 3][i % 3] = constant(graph, m[i]);
  }
  return result;
}

/// I = tr(Ψ) E_3 - Ψ.
Mat3 inertia_tensor(const Mat3& Psi);
/// Ψ of it.
Mat3 second_moments_of(Graph& graph, Mat3 I);

/// A sum whose constant terms are added last, as one number.
Expr sum(const std::vector<Expr>& terms);

/// Names the components for the reader of the generated code.
void name(Graph& graph, const Vec3& v, const char* symbol, int body);

}  // namespace treedyn::formulate
