// Lagrange's equations from 4x4 poses alone, as polynomials: no angular velocity, no cross product,
// no Jacobian formula, nothing from block/ or equations/. T = 1/2 Σ tr(Ẋ_i S_i Ẋ_i^T),
// EQUATIONS.md 5.
#pragma once

#include <array>
#include <vector>

#include "expansion/expansion.hpp"
#include "model/tree.hpp"

namespace treedyn::expansion {

class Lagrange {
 public:
  using Matrix4 = std::array<Expanded, 16>;  // row-major

  /// The variables are those of `expansion`.
  Lagrange(const model::Tree& tree, const std::vector<model::Point>& points,
           const model::Vector3& gravity, const Expansion& expansion);

  [[nodiscard]] std::vector<Expanded> A() const;        ///< N N
  [[nodiscard]] std::vector<Expanded> B() const;        ///< N, from Christoffel symbols of A
  [[nodiscard]] std::vector<Expanded> G() const;        ///< N, ∂U/∂q
  [[nodiscard]] std::vector<Expanded> C() const;        ///< N 3P
  [[nodiscard]] std::vector<Expanded> H() const;        ///< N 3P
  [[nodiscard]] std::vector<Expanded> gamma_f() const;  ///< 3P
  [[nodiscard]] std::vector<Expanded> gamma_n() const;  ///< 3P

 private:
  [[nodiscard]] Expanded slope(const Expanded& value, std::size_t joint) const;
  [[nodiscard]] Matrix4 slope(const Matrix4& pose, std::size_t joint) const;
  [[nodiscard]] std::vector<Expanded> curvature(const std::vector<Expanded>& slopes) const;
  [[nodiscard]] Matrix4 joint_pose(const model::Link& link, std::size_t i) const;
  [[nodiscard]] Matrix4 pseudo_inertia(const model::Link& link) const;
  [[nodiscard]] Expanded constant(const Real& value) const;

  const Expansion& expansion_;
  std::vector<Matrix4> poses_;           // per link
  std::vector<Matrix4> pseudo_inertia_;  // per link
  std::vector<Matrix4> point_poses_;     // per point, of its link
  std::vector<std::array<Expanded, 4>> points_;
  std::vector<std::array<Expanded, 4>> first_moments_;  // m (c, 1) per link
  std::array<Expanded, 3> gravity_;
  std::vector<bool> revolute_;
};

}  // namespace treedyn::expansion
