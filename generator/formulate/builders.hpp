// The expressions of every generated function, one builder each, in the independent coordinates.
#pragma once

#include <vector>

#include "formulate/functions.hpp"

namespace treedyn::formulate {

std::vector<Expr> build_forward_dynamics(const Task& task);
std::vector<Expr> build_dynamics_terms(const Task& task);
std::vector<Expr> build_point_rotations(const Task& task);

}  // namespace treedyn::formulate
