// Sums over joints, in which joints that move together count one by one.
#pragma once

#include "block/block.hpp"

namespace treedyn::equations {

/// True if something other than the motion of all joints (q̇, q̈) multiplies what counts joints: the
/// rows of forces on joints, the columns for their motions. Those of T(at(j)) * A are then not
/// those of the coordinates of a robot in which some joints move others.
bool picks_joints(const block::Expression& e);

}  // namespace treedyn::equations
