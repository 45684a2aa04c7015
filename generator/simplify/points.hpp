// Points: rotations, accelerations of 6.1.
#pragma once

#include <vector>

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// The points of a function in the order of its arrays.
using Points = std::vector<model::Point>;

/// gamma_f = d/dt(J) qd of 6.1 in the base frame, 3 P.
std::vector<Expr> point_bias_acceleration(const Kinematics& kinematics, const Points& points);
/// Link frame -> base frame, row-major, 9 P.
std::vector<Expr> point_rotations(const Kinematics& kinematics, const Points& points);

}  // namespace treedyn::simplify
