// Closed loops of a scene: ways from link to link, by joints and constraints, that come back.
#pragma once

#include "model/scene.hpp"

namespace treedyn::model {

/// True if a constraint between two links, or a link and the ground, closes a loop of the links in
/// a phase in which it acts: two points made one always do; a point or orientation that is held
/// does where joints, or other constraints, lead from its link to the ground. The joints of a free
/// base, which carry links without mass, lead nowhere; several constraints between the same two are
/// one.
bool closes_loop(const Scene& scene, int constraint);

}  // namespace treedyn::model
