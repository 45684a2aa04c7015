// Angles of joints, and rotations about one axis.
#pragma once

#include <utility>
#include <vector>

#include "formulate/frames.hpp"
#include "formulate/spatial.hpp"

namespace treedyn::formulate {

/// A joint angle or a sum of such, plus a constant turn: sum of coefficient * u[coordinate] + turn.
struct Angle {
  std::vector<std::pair<int, Real>> terms;  ///< ascending coordinates, coefficients not zero
  Turn turn;
};
Angle operator+(const Angle& a, const Angle& b);
Angle operator-(const Angle& a, const Angle& b);
Angle constant_angle(const Turn& turn);

/// True if all have the same constant turn, a multiple of pi/2.
bool same_quarter(const std::vector<Angle>& angles);

using CosineAndSine = std::pair<Expr, Expr>;

/// Those of an angle x: cos(x + k pi/2), sin(x + k pi/2), without an operation.
CosineAndSine quarter_turned(const CosineAndSine& of, const Turn& quarter);
/// Those of the sum of two angles, by the addition theorems.
CosineAndSine added(const CosineAndSine& a, const CosineAndSine& b);

/// One plane rotation about the x (axis 0) or z (axis 2) axis.
struct PlaneRotation {
  std::size_t axis = 2;
  Expr c;
  Expr s;

  [[nodiscard]] Vec3 forward(const Vec3& v) const;   ///< R v
  [[nodiscard]] Vec3 backward(const Vec3& v) const;  ///< R^T v
  /// R S R^T for symmetric S with u = s d + 2 c xy, t = s u: 4 multiplications instead of 10.
  [[nodiscard]] Mat3 forward_symmetric(const Mat3& a) const;
  /// R H R^T for general H.
  [[nodiscard]] Mat3 forward_general(const Mat3& h) const;
};

}  // namespace treedyn::formulate
