// Dry friction that sticks exactly, told by phases: generated steps know no other way to change
// what acts.
#pragma once

#include "model/scene.hpp"

namespace treedyn::formulate {

/// Phases that a scene may have by its joints that stick.
inline constexpr std::size_t kMostStickingPhases = 27;

/// How many phases a scene has once its sticking joints, of friction without slip_speed, are told
/// by phases.
std::size_t sticking_phases(const model::Scene& scene);

/// Makes every phase one of each way in which those joints may stick or slip, 3^k for k of them: a
/// row holds a joint that sticks, until its reaction is beyond the friction; a constant force acts
/// on one that slips, until it stops. \post Scene::sticking
void settle_sticking(model::Scene& scene);
/// The scene before that; names of phases may keep a number.
void forget_sticking(model::Scene& scene);

}  // namespace treedyn::formulate
