// The linear regressor of inverse dynamics.
#pragma once

#include <vector>

#include "formulate/functions.hpp"

namespace treedyn::formulate {

/// Y of tau = Y theta, N x 10 N, row-major. tau is linear in the mass, the first moment and the
/// inertia tensor about its origin of every link, so a column is (1) of a robot that has nothing
/// but a unit of that parameter. All columns share the kinematics.
/// \pre every link has a coordinate of its own
std::vector<Expr> build_regressor(const Task& task);

}  // namespace treedyn::formulate
