// From a scene to the dynamics that a simulation steps.
#pragma once

#include <memory>

#include "model/scene.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn {

/// What the effects of a scene ask of its points.
simulation::Needs needs_of(const model::Scene& scene);

/// The scene's own straight-line programs, interpreted.
std::unique_ptr<simulation::Dynamics> program_dynamics(const model::Scene& scene);

/// The generic engine, for comparison.
std::unique_ptr<simulation::Dynamics> engine_dynamics(const model::Scene& scene);

}  // namespace treedyn
