#include "formulate/builders.hpp"

#include "formulate/factored.hpp"
#include "formulate/forward.hpp"
#include "formulate/point_rotations.hpp"

namespace treedyn::formulate {

namespace {

bool by_trunk(const Task& task) {
  return task.kinematics.variant().trunk && has_free_base(task.tree);
}

/// Joint values of the links as values of the coordinates, where every link has its own.
std::vector<Expr> of_coordinates(const Task& task, std::vector<Expr> x) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = task.kinematics.result(static_cast<int>(k), x[k]);
  }
  return x;
}

}  // namespace

/// (1) solved for qdd.
std::vector<Expr> build_forward_dynamics(const Task& task) {
  const Kinematics& k = task.kinematics;
  const bool one_joint_one_coordinate = task.tree.dof() == task.tree.size();
  if (by_trunk(task) && one_joint_one_coordinate) {
    return of_coordinates(
        task, forward_dynamics_by_trunk(task, -k.ground_acceleration(), k.variant().articulated));
  }
  if (k.variant().articulated && one_joint_one_coordinate) {
    const JointForce force = [&k](int i) {
      return k.force(i);
    };
    return of_coordinates(task,
                          articulated_forward_dynamics(task, *derived("forward_dynamics"), force));
  }
  return build_factored(task, "forward_dynamics");
}

std::vector<Expr> build_dynamics_terms(const Task& task) {
  const Kinematics& k = task.kinematics;
  const Kinematics at_rest(k.graph(), task.tree, task.normal, k.variant(), {.q = 0}, k.limbs());
  const std::vector<Expr> bias = build_equation(task, "bias_force");
  const std::vector<Expr> gravity =
      build_equation({task.tree, task.normal, task.options, at_rest}, "inverse_dynamics");
  std::vector<Expr> result = build_equation(task, "mass_matrix");
  result.insert(result.end(), bias.begin(), bias.end());
  result.insert(result.end(), gravity.begin(), gravity.end());
  return result;
}

std::vector<Expr> build_point_rotations(const Task& task) {
  return point_rotations(task.kinematics, task.options.points);
}

}  // namespace treedyn::formulate
