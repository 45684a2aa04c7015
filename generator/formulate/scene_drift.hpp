// What stabilisation adds to the rows of a scene: errors of position and velocity, Baumgarte
// (1972).
#pragma once

#include <vector>

#include "formulate/scene_forces.hpp"

namespace treedyn::formulate {

/// The anchors of all constraints as they are now. Input arrays: q, and t if a curve has an anchor.
std::vector<Expr> build_anchors(const Task& task);

/// For every row of a held constraint -2 alpha (J qd - c') - alpha^2 phi with its position error
/// phi, 6.2; base frame, along its directions.
/// \param anchor  number of the input array
/// \pre the constraint is_stabilised
std::vector<Expr> drift_corrections(const Task& task, const SceneForces& forces, int constraint,
                                    int anchor);

}  // namespace treedyn::formulate
