// Forward dynamics: qdd = A^-1 (tau - B - G), by factoring A or by articulated bodies.
#pragma once

#include <vector>

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// Forward dynamics of a free base: the trunk's six accelerations are solved for first, in the
/// trunk's frame; the base joints' accelerations follow from them. Singular where the base's second
/// turning angle is pi/2.
std::vector<Expr> forward_dynamics_by_trunk(const Kinematics& kinematics, const Vec3& gravity,
                                            bool articulated);

}  // namespace treedyn::simplify
