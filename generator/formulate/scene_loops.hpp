// Redundant closed loops, which the steps of a scene draw together where nothing else is said.
#pragma once

#include "model/scene.hpp"

namespace treedyn::formulate {

/// Notes, for a scene with a generated step that asks for no stabilisation of its own, where
/// constraints of closed loops with more rows than rank have their place: Constraint::loop. Drift
/// off such a loop is not only an error of position: the spare rows begin to act, or their choice
/// changes.
void settle_loops(model::Scene& scene);

}  // namespace treedyn::formulate
