#include "simplify/builders.hpp"

#include "simplify/derived.hpp"
#include "simplify/factor.hpp"
#include "simplify/forward.hpp"
#include "simplify/points.hpp"

namespace treedyn::simplify {

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

/// A = L^T Delta L in the independent coordinates.
Factorization factorization(const Task& task) {
  const std::vector<Expr> a = build_equation(task, "mass_matrix");
  const int n = task.tree.dof();
  SparseSymmetric lower;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      lower[{i, j}] = a[static_cast<std::size_t>(i * n + j)];
    }
  }
  return {task.kinematics.graph(), n, lower};
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
  const std::vector<Expr> bias = build_equation(task, "inverse_dynamics");
  std::vector<Expr> right;
  for (int i = 0; i < task.tree.dof(); ++i) {
    right.push_back(k.argument(2, i) - bias[static_cast<std::size_t>(i)]);
  }
  return factorization(task).solve(right);
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

std::vector<Expr> build_mass_matrix_factor(const Task& task) {
  const Factorization factor = factorization(task);
  const auto n = static_cast<std::size_t>(factor.size());
  std::vector<Expr> result(n * n + n);
  for (std::size_t i = 0; i < n; ++i) {
    const int row = static_cast<int>(i);
    for (const auto& [j, l_ij] : factor.row(row)) {
      result[i * n + static_cast<std::size_t>(j)] = l_ij;
    }
    result[i * n + i] = constant(task.kinematics.graph(), Real(1));
    result[n * n + i] = factor.pivot(row);
  }
  return result;
}

std::vector<Expr> build_mass_matrix_solve(const Task& task) {
  std::vector<Expr> right;
  for (int i = 0; i < task.tree.dof(); ++i) {
    right.push_back(task.kinematics.argument(1, i));
  }
  return factorization(task).solve(right);
}

/// A^-1 = L^-1 Delta^-1 L^-T; L^-1 has the zero pattern of D.
std::vector<Expr> build_mass_matrix_inverse(const Task& task) {
  const Factorization factor = factorization(task);
  const std::vector<std::map<int, Expr>> y = factor.inverse_of_lower();
  const std::size_t n = y.size();
  std::vector<Expr> result(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Expr entry;
      for (const auto& [k, y_jk] : y[j]) {
        const auto y_ik = y[i].find(k);
        if (y_ik != y[i].end()) {
          entry += y_ik->second * (y_jk * factor.inverse_pivot(k));
        }
      }
      result[i * n + j] = result[j * n + i] = entry;
    }
  }
  return result;
}

std::vector<Expr> build_point_rotations(const Task& task) {
  return point_rotations(task.kinematics, task.options.points);
}

}  // namespace treedyn::simplify
