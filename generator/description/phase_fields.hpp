// The phases of a scene file and the events that end them.
#pragma once

#include "description/scene_effects.hpp"

namespace treedyn::description {

/// Fills `phases` and `start_phase` of the scene, whose constraints are complete. Without phases
/// there is one in which everything acts; constraints that no phase lists act in all.
/// \throws InputError
void read_phases(SceneContext& context, const SceneEffects& effects, const SceneFields& root);

}  // namespace treedyn::description
