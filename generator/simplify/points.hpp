// Points: rotations, accelerations of 6.1; velocities of links.
#pragma once

#include <vector>

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// Velocity of a link in its expression frame.
struct Velocity {
  Vec3 omega;
  Vec3 origin;
};
/// Of all links, fathers first: D as prefix sum.
std::vector<Velocity> velocities(const Kinematics& kinematics);

/// The points of a function in the order of its arrays.
using Points = std::vector<model::Point>;

/// gamma_f = d/dt(J) qd of 6.1 in the base frame, 3 P.
std::vector<Expr> point_bias_acceleration(const Kinematics& kinematics, const Points& points);
/// Link frame -> base frame, row-major, 9 P.
std::vector<Expr> point_rotations(const Kinematics& kinematics, const Points& points);

}  // namespace treedyn::simplify
