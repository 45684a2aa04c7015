// Functions of a scene against the block equations, before anything is written.
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "program/programs.hpp"

namespace treedyn::verify {

/// Evaluates the functions of a scene with 50 digits at a fixed pseudo-random state, nearer to the
/// scene's start if an expression has no value there, and holds them
/// against (8), (10) and 6.1 as the engine evaluates them: A qdd + B + G - J^T lambda = tau, and
/// J qdd + gamma = a_des where the rows have full rank (where not, up to the part that no motion
/// can reach).
/// \param derived  what functions take of run-time parameters that have the scene's values
/// \throws std::logic_error naming the function that differs: a mistake of ours.
/// \throws std::domain_error if an expression of the scene has no value at its start
void check_scene_at_states(const model::Scene& scene, const program::Programs& programs,
                           const std::vector<Real>& derived = {});

}  // namespace treedyn::verify
