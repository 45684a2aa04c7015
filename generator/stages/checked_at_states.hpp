// Programs against the block equations, before anything is written.
#pragma once

#include "program/programs.hpp"
#include "request/read_model.hpp"

namespace treedyn {

/// Stops the program, naming the function, if a formulation differs from the block equations
/// evaluated with 50 digits at pseudo-random states.
void check_at_states(const Model& model, const Request& request, const program::Programs& programs);

}  // namespace treedyn
