// What a scene has to be for what is generated of it: its step, its impacts.
#pragma once

#include <string>

#include "request/read_model.hpp"

namespace treedyn {

/// Friction that sticks is told by phases, which only steps change. \throws InputError
void check_scene(const model::Scene& scene, const Location& where);

/// A step that was asked for needs an integrator whose steps are of a fixed length, and counts as
/// many of them as an int does. \throws InputError at `stepping`; at `of_scene` where there is none
void check_step(const Model& model, const Location& of_scene);

/// Options of a step that is not generated would change nothing. \throws InputError
void refuse_step_options(const StepChoice& choice, const model::Scene& scene,
                         const std::string& file);

/// Generated impacts bring rows to rest, or let them rebound: they do not know of speeds of curves.
/// \throws InputError
void check_impacts(const Model& model, const Location& where);

/// \throws InputError if the scene of a model has no generated `step`
void require_step(const Model& model, const Location& where);

}  // namespace treedyn
