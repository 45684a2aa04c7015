// `step`: the phases of a scene as those that its integrator goes through.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/stepper.hpp"
#include "simplify/formulate.hpp"
#include "simplify/scene_names.hpp"

namespace treedyn::simplify {

/// A phase with the constraints that act: as the scene has it, or one in which a slow rebound has
/// come to rest.
struct PhaseState {
  int phase = 0;
  std::vector<int> active;  ///< ascending
  std::string ending;       ///< of names of functions: "", "_left", "_at_rest"
  std::string identifier;   ///< left, left_at_rest
};

/// The phases of the scene, and behind them those at rest that a step may reach.
std::vector<PhaseState> phase_states(const model::Scene& scene, bool at_rest);

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

}  // namespace treedyn::simplify
