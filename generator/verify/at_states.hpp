// Programs against the block equations, before anything is written.
#pragma once

#include <vector>

#include "equations/user.hpp"
#include "model/tree.hpp"
#include "program/function.hpp"

namespace treedyn::verify {

/// Equations of users.
using UserEquations = std::vector<const equations::UserEquation*>;

/// Evaluates every function and its block equation (engine) with 50 digits at fixed pseudo-random
/// states and compares, 1e-35 relative to the largest value, or what cancellation within the
/// program explains. Functions of numbers that are known at run time only are held against the
/// equations of the tree with these numbers: the nominal ones, pseudo-random ones, and zeros (our
/// functions that do not divide by pivots of A).
/// \param update  computes the last argument of such functions; null: there are none
/// \throws std::logic_error naming the function that differs: a mistake of ours.
/// \throws std::range_error if numbers of the model cancel so that no digit would be left in double
void check_at_states(const model::Tree& tree, const std::vector<model::Point>& points,
                     const model::Vector3& gravity, const UserEquations& equations,
                     const std::vector<program::Function>& functions,
                     const program::Function* update = nullptr);

}  // namespace treedyn::verify
