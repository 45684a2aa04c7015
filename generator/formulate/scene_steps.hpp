// `step`: the phases of a scene as those that its integrator goes through.
#pragma once

#include <vector>

#include "formulate/formulate.hpp"
#include "formulate/scene_names.hpp"
#include "formulate/scene_phases.hpp"
#include "program/stepper.hpp"

namespace treedyn::formulate {

/// `step` by the dynamics of the states and the impacts.
/// \param dynamics  constrained_dynamics of every state
/// \param impacts   the functions of impacts_of(scene)
program::Stepper make_stepper(const model::Scene& scene, const Options& options,
                              const std::vector<PhaseState>& states,
                              const std::vector<program::Staged>& dynamics,
                              const std::vector<program::Staged>& impacts);

/// The anchors of all constraints as they are now: arrays q and, if a curve has an anchor, t.
program::Function anchor_function(const model::Scene& scene);

}  // namespace treedyn::formulate
