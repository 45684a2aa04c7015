// Base parameters of a robot: what of its masses, first moments and inertias motions and joint
// forces can tell.
#pragma once

#include <string>

#include "request/read_model.hpp"

namespace treedyn {

/// The columns of Y (inverse_dynamics_regressor) that are independent, each with the combination of
/// parameters that stands in theta for it when the others are left out. Rank of Y at random states
/// with 50 digits, O(N^4) for N joints.
/// \param json  as JSON instead of lines
/// \throws InputError where joints follow others
std::string base_parameters_text(const Model& model, const Request& request, bool json);

}  // namespace treedyn
