// Rotations of points.
#pragma once

#include <vector>

#include "formulate/link_kinematics.hpp"

namespace treedyn::formulate {

/// The points of a function in the order of its arrays.
using Points = std::vector<model::Point>;

/// Link frame -> base frame, row-major, 9 P.
std::vector<Expr> point_rotations(const Kinematics& kinematics, const Points& points);

}  // namespace treedyn::formulate
