// What stabilisation adds to the rows of a scene: errors of position and velocity, Baumgarte
// (1972).
#pragma once

#include <vector>

#include "simplify/scene_forces.hpp"

namespace treedyn::simplify {

/// True if Baumgarte's correction, the one that is part of the equations, acts on a constraint:
/// where the scene asks for it, and, unless it asks for none, on closed loops that a step goes
/// round.
bool is_stabilised(const model::Scene& scene, int constraint);
/// True if it is drawn to where the initial state of the scene has it, Constraint::loop.
bool has_place(const model::Scene& scene, int constraint);
/// Its alpha, 1/s: that of the scene; of loops never more than half of what a step resolves.
Real stabilisation_rate(const model::Scene& scene);

/// Values that say where a constraint began to act: the position of its point (3, base frame, m;
/// less that of a curve), the rotation of the point's link (9, row-major) or the position of its
/// joint (1); 0 if its rows know, or need not know, where they are.
int anchor_size(const model::Scene& scene, int constraint);
/// Where they stand in the array of all constraints; of the number of constraints, its size.
int anchor_offset(const model::Scene& scene, int constraint);
/// True if one of the constraints has an anchor.
bool has_anchor(const model::Scene& scene, const std::vector<int>& constraints);

/// The anchors of all constraints as they are now: values of q, and of t where a curve has an
/// anchor.
std::vector<Expr> anchors_now(const Task& task, const SceneForces& forces);

/// For every row of a held constraint -2 alpha (J qd - c') - alpha^2 phi with its position error
/// phi, 6.2; base frame, along its directions.
/// \param anchor  number of the input array
/// \pre the constraint is_stabilised
std::vector<Expr> drift_corrections(const Task& task, const SceneForces& forces, int constraint,
                                    int anchor);

}  // namespace treedyn::simplify
