// Constrained inverse dynamics: drives and reactions that make a given motion.
#pragma once

#include <vector>

#include "simplify/scene_system.hpp"

namespace treedyn::simplify {

/// Joints without a drive: where the scene names drives, all joints but theirs; else the six joints
/// of a free base.
std::vector<int> passive_joints(const model::Scene& scene);

/// Input arrays of build_constrained_inverse: q, qd, qdd, mu, t.
inline constexpr SceneArrays kInverseArrays = {.qd = 1, .tau = -1, .mu = 3, .t = 4};
inline constexpr int kInverseAcceleration = 2;

/// Values for p passive joints and the r rows of task.options.active: K (p(p+1)/2), b (p), tau (N),
/// lambda (r). With J_u the columns of J that belong to passive joints and h = A qdd + B + G less
/// the scene's own forces:
/// K = J_u^T J_u, K mu = b = h_u, lambda = J_u mu, tau = h - J^T lambda.
/// Of all reactions that leave the passive joints without a drive lambda has the least norm; what
/// no reaction can give is left in tau of the passive joints.
std::vector<Expr> build_constrained_inverse(const Task& task);

}  // namespace treedyn::simplify
