// Constrained dynamics: (8) with the rows of 6.1 and 6.2, as straight-line code on both sides of
// the solution of K mu = b.
#pragma once

#include <vector>

#include "formulate/scene_system.hpp"

namespace treedyn::formulate {

/// Values of constrained dynamics with r rows, one behind the other:
/// K (lower half, row by row, r(r+1)/2), b (r), qdd (N), lambda (r), depths of the contacts. qdd
/// and lambda depend on mu, which solves K mu = b; K and b do not. The depths depend on q alone.
///
/// With A = L^T Delta L and L^T Y = J^T (Y has the columns' ancestor paths, 7.4):
/// K = Y^T Delta^-1 Y, b = a_des - gamma - Y^T Delta^-1 L^-T right,
/// x = L^-1 Delta^-1 (L^-T right + Y mu).
std::vector<Expr> build_constrained_dynamics(const Task& task);

/// Values of an impact of the constraints task.options.active with r rows, 6.4: K (r(r+1)/2), b
/// (r), qd_plus (N), P (r). With A (qd_plus - qd_minus) = J^T P and J qd_plus = -e J qd_minus: K mu
/// = b = -(1 + e) J qd_minus. No force takes part, finite as they are.
std::vector<Expr> build_impact(const Task& task);

/// J^T of all rows of the scene, N x r, row-major, base frame directions.
std::vector<Expr> build_reaction_jacobian(const Task& task);
/// gamma of all rows.
std::vector<Expr> build_reaction_bias(const Task& task);

/// Number of rows of some constraints.
int rows_of(const model::Scene& scene, const std::vector<int>& constraints);
/// The input arrays of constrained dynamics.
SceneArrays constrained_arrays(const model::Scene& scene, const std::vector<int>& active);

}  // namespace treedyn::formulate
