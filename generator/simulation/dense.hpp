// The state inside a step.
#pragma once

#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

/// Positions and velocities as polynomials of the part of the step that has gone by, both by
/// Hermite's interpolation, so that short steps lose no digits.
class Dense {
 public:
  /// Positions of order 3, velocities of order 2.
  /// \param y, next  (q; qd), h s apart \param qdd  at the beginning
  void set(double h, const Vector& y, const Vector& qdd, const Vector& next);
  /// Positions of order 5, velocities of order 3.
  void set(double h, const Vector& y, const Vector& qdd, const Vector& next,
           const Vector& qdd_next);
  /// (q; qd). \param s  0 at the beginning, 1 at the end
  [[nodiscard]] const Vector& at(double s);

 private:
  Eigen::MatrixXd q_;  ///< N x 6, powers of s
  Eigen::MatrixXd v_;  ///< N x 4
  Vector y_;
};

}  // namespace treedyn::simulation
