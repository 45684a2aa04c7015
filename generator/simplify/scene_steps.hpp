// `step`: the phases of a scene as those that its integrator goes through.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/stepper.hpp"
#include "simplify/formulate.hpp"
#include "simplify/scene_names.hpp"
#include "simplify/scene_phases.hpp"

namespace treedyn::simplify {

/// The scene's integrator if there is code for a step of it.
std::optional<program::StepMethod> step_method(const model::Scene& scene);
/// Names of the integrators for which there is.
std::vector<std::string> step_method_names();

/// `step` by the dynamics of the states and the impacts.
/// \param dynamics  constrained_dynamics of every state
/// \param impacts   the functions of impacts_of(scene)
program::Stepper make_stepper(const model::Scene& scene, const Options& options,
                              const std::vector<PhaseState>& states,
                              const std::vector<program::Staged>& dynamics,
                              const std::vector<program::Staged>& impacts);

/// The anchors of all constraints as they are now: arrays q and, if a curve has an anchor, t.
program::Function anchor_function(const model::Scene& scene);

}  // namespace treedyn::simplify
