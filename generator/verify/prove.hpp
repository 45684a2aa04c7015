// Programs against the block equations, before anything is written.
#pragma once

#include <vector>

#include "model/tree.hpp"
#include "program/function.hpp"
#include "simplify/derived.hpp"

namespace treedyn {

/// Evaluates every function and its block equation (engine) with 50 digits at fixed pseudo-random
/// states and compares, 1e-35 relative to the largest value, or what cancellation within the
/// program explains.
/// \throws std::logic_error naming the function that differs: a mistake of ours.
/// \throws std::range_error if numbers of the model cancel so that no digit would be left in double
void prove_functions(const model::Tree& tree, const std::vector<model::Point>& points,
                     const model::Vector3& gravity, const simplify::DerivedFunctions& equations,
                     const std::vector<program::Function>& functions);

}  // namespace treedyn
