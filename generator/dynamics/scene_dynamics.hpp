// From a scene to the dynamics that a simulation steps.
#pragma once

#include <memory>

#include "model/scene.hpp"
#include "program/function.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn {

/// The terms of the equations of motion and, of q alone, what places the points.
struct ScenePrograms {
  program::Function terms;     ///< the arrays of simulation::Terms, those that are needed
  program::Function geometry;  ///< p, C, R, H, those that are needed
};
ScenePrograms scene_programs(const model::Scene& scene);

/// The scene's own straight-line programs, interpreted.
std::unique_ptr<simulation::Dynamics> program_dynamics(const model::Scene& scene);

/// The same programs as C++, compiled and loaded. \throws InputError without a compiler
std::unique_ptr<simulation::Dynamics> compiled_dynamics(const model::Scene& scene);

/// The generic engine, for comparison.
std::unique_ptr<simulation::Dynamics> engine_dynamics(const model::Scene& scene);

}  // namespace treedyn
