// The expressions of every generated function, one builder each, in the independent coordinates.
#pragma once

#include <vector>

#include "simplify/functions.hpp"

namespace treedyn::simplify {

std::vector<Expr> build_forward_dynamics(const Task& task);
std::vector<Expr> build_dynamics_terms(const Task& task);
std::vector<Expr> build_point_rotations(const Task& task);

}  // namespace treedyn::simplify
