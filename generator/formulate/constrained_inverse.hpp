// Constrained inverse dynamics: drives and reactions that make a given motion.
#pragma once

#include <vector>

#include "formulate/scene_system.hpp"

namespace treedyn::formulate {

/// Input arrays of build_constrained_inverse: q, qd, qdd, then mu, the joint forces of ground
/// contacts and t, those that are needed.
struct InverseArrays {
  SceneArrays scene = {.qd = 1, .tau = -1};
  int qdd = 2;
  int force = -1;
};
InverseArrays inverse_arrays(const model::Scene& scene, const std::vector<int>& active);

/// Joints for whose drives reactions of the active constraints are to stand; none without rows.
std::vector<int> joints_without_drive(const model::Scene& scene, const std::vector<int>& active);

/// Values for p passive joints and the r rows of task.options.active: K (p(p+1)/2), b (p), tau (N),
/// lambda (r), depths of the contacts. With J_u the columns of J that belong to passive joints and
/// h = A qdd + B + G less the scene's own forces and those of closed contacts: K = J_u^T J_u, K mu
/// = b = h_u, lambda = J_u mu, tau = h - J^T lambda. Of all reactions that leave the passive joints
/// without a drive lambda has the least norm; what no reaction can give is left in tau of the
/// passive joints. Without such joints: tau = h and the depths.
std::vector<Expr> build_constrained_inverse(const Task& task);

}  // namespace treedyn::formulate
