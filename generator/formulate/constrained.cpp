#include "formulate/constrained.hpp"

#include <numeric>

#include "common/index.hpp"
#include "formulate/contacts.hpp"
#include "formulate/factored.hpp"
#include "formulate/scene_drift.hpp"
#include "formulate/scene_rows.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

namespace {

/// a . b over the places that both have.
Expr product(const SparseRow& a, const SparseRow& b) {
  Expr sum;
  for (const auto& [k, value] : a) {
    const auto other = b.find(k);
    if (other != b.end()) {
      sum += value * other->second;
    }
  }
  return sum;
}

SparseRows transposed(const SparseRow& row, std::size_t size) {
  SparseRows column(size);
  for (const auto& [k, value] : row) {
    column[to_index(k)][0] = value;
  }
  return column;
}

SparseRow transposed(const SparseRows& column) {
  SparseRow row;
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (!column[k].empty()) {
      row[static_cast<int>(k)] = column[k].at(0);
    }
  }
  return row;
}

/// Y, Delta^-1 Y and the right side in the coordinates of L.
struct Reduced {
  std::vector<SparseRow> Y;
  std::vector<SparseRow> scaled;
  std::vector<Expr> free;  ///< Delta^-1 L^-T right
};

Reduced reduce(const Factors& factor, const std::vector<Row>& rows,
               const std::vector<Expr>& right) {
  Reduced r;
  r.free = column_of(factor.to_root(sparse(right)));
  for (std::size_t k = 0; k < right.size(); ++k) {
    r.free[k] = r.free[k] * factor.inverse_pivot(static_cast<int>(k));
  }
  for (const Row& row : rows) {
    r.Y.push_back(transposed(factor.to_root(transposed(row.columns, right.size()))));
    r.scaled.push_back(r.Y.back());
    for (auto& [k, value] : r.scaled.back()) {
      value = value * factor.inverse_pivot(k);
    }
  }
  return r;
}

/// The sum of right_k and the columns of the rows times mu.
std::vector<Expr> with_reactions(const Reduced& r, const std::vector<Expr>& mu) {
  std::vector<Expr> x = r.free;
  for (std::size_t i = 0; i < mu.size(); ++i) {
    for (const auto& [k, value] : r.scaled[i]) {
      const Expr term = value * mu[i];
      x[to_index(k)] += term;
    }
  }
  return x;
}

std::vector<int> all_constraints(const model::Scene& scene) {
  std::vector<int> all(scene.constraints.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

int rows_of(const model::Scene& scene, const std::vector<int>& constraints) {
  return std::accumulate(constraints.begin(), constraints.end(), 0, [&](int sum, int c) {
    return sum + static_cast<int>(scene.constraints[to_index(c)].rows());
  });
}

SceneArrays constrained_arrays(const model::Scene& scene, const std::vector<int>& active) {
  SceneArrays arrays;
  int next = 3;
  if (rows_of(scene, active) > 0) {
    arrays.mu = next++;
  }
  if (uses_time(scene, active)) {
    arrays.t = next++;
  }
  if (has_anchor(scene, active)) {
    arrays.anchor = next;
  }
  return arrays;
}

namespace {

/// The lower half of K = Y^T Delta^-1 Y, row by row.
std::vector<Expr> lower_half(const Reduced& reduced) {
  std::vector<Expr> K;
  for (std::size_t i = 0; i < reduced.Y.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      K.push_back(product(reduced.Y[i], reduced.scaled[j]));
    }
  }
  return K;
}

/// Of a scene without rows: qdd and the depths of contacts.
std::vector<Expr> articulated_dynamics(const Task& task, const SceneArrays& arrays) {
  const SceneForces forces(task, arrays);
  std::vector<Expr> result = articulated_accelerations(task, forces);
  const std::vector<Expr> depths = contact_depths(*task.options.scene, task, forces);
  result.insert(result.end(), depths.begin(), depths.end());
  return result;
}

}  // namespace

std::vector<Expr> build_constrained_dynamics(const Task& task) {
  Graph& graph = task.kinematics.graph();
  const std::vector<int>& active = task.options.active;
  const SceneArrays arrays = constrained_arrays(*task.options.scene, active);
  if (task.kinematics.variant().articulated) {
    return articulated_dynamics(task, arrays);
  }
  const SceneSystem system(task, arrays);
  const Factors factor(graph, task.tree.dof(), system.inertia());
  const SceneRows::Correction correction = [&](int constraint) {
    return is_stabilised(*task.options.scene, constraint)
               ? drift_corrections(task, system.forces(), constraint, arrays.anchor)
               : std::vector<Expr>();
  };
  const SceneRows rows(*task.options.scene, active, system.frame(), graph, system.meaning(),
                       correction);
  const Reduced reduced = reduce(factor, rows.rows(), system.right());

  std::vector<Expr> result = lower_half(reduced);
  std::vector<Expr> mu;
  for (int i = 0; i < rows.size(); ++i) {
    Expr b = rows.rows()[to_index(i)].right;
    for (const auto& [k, value] : reduced.Y[to_index(i)]) {
      b -= value * reduced.free[to_index(k)];
    }
    result.push_back(b);
    mu.push_back(input(graph, arrays.mu, i));
  }
  const std::vector<Expr> x = factor.from_root(with_reactions(reduced, mu));
  const std::vector<Expr> qdd = system.accelerations(x);
  result.insert(result.end(), qdd.begin(), qdd.end());
  const std::vector<Expr> lambda = system.reactions(rows.reactions(mu));
  result.insert(result.end(), lambda.begin(), lambda.end());
  const std::vector<Expr> depths = contact_depths(*task.options.scene, task, system.forces());
  result.insert(result.end(), depths.begin(), depths.end());
  return result;
}

std::vector<Expr> build_impact(const Task& task) {
  Graph& graph = task.kinematics.graph();
  const model::Scene& scene = *task.options.scene;
  const SceneArrays& arrays = kImpactArrays;
  const SceneSystem system(task, arrays, false);
  const Factors factor(graph, task.tree.dof(), system.inertia());
  const Meaning nothing = [&](const model::Variable&) {  // what rows want takes no part
    return constant(graph, Real(1));
  };
  const SceneRows rows(scene, task.options.active, system.frame(), graph, nothing);
  const Reduced reduced = reduce(factor, rows.rows(), system.right());
  std::vector<Expr> qd;
  for (int i = 0; i < task.tree.dof(); ++i) {
    qd.push_back(input(graph, arrays.qd, i));
  }
  const std::vector<Expr> velocity = system.velocities(qd);
  const Expr rebound = constant(graph, 1 + task.options.restitution);
  std::vector<Expr> result = lower_half(reduced);
  std::vector<Expr> mu;
  for (int i = 0; i < rows.size(); ++i) {
    Expr speed;
    for (const auto& [k, value] : rows.rows()[to_index(i)].columns) {
      speed += value * velocity[to_index(k)];
    }
    result.push_back(-(rebound * speed));
    mu.push_back(input(graph, arrays.mu, i));
  }
  const std::vector<Expr> change =
      system.joint_velocities(factor.from_root(with_reactions(reduced, mu)));
  for (std::size_t i = 0; i < qd.size(); ++i) {
    result.push_back(qd[i] + change[i]);
  }
  const std::vector<Expr> P = system.reactions(rows.reactions(mu));
  result.insert(result.end(), P.begin(), P.end());
  return result;
}

std::vector<Expr> build_reaction_jacobian(const Task& task) {
  const SceneFrame frame(task, false);
  const auto n = to_index(task.tree.dof());
  const model::Scene& scene = *task.options.scene;
  const auto r = to_index(rows_of(scene, all_constraints(scene)));
  std::vector<Expr> result(n * r);
  std::size_t row = 0;
  for (const Row& columns : base_rows(scene, frame, task.kinematics.graph())) {
    for (const auto& [k, value] : columns.columns) {
      result[to_index(k) * r + row] = value;
    }
    ++row;
  }
  return result;
}

std::vector<Expr> build_reaction_bias(const Task& task) {
  const SceneFrame frame(task, task.options.scene->velocity_products);
  std::vector<Expr> result;
  for (const Row& row : base_rows(*task.options.scene, frame, task.kinematics.graph())) {
    result.push_back(-row.right);
  }
  return result;
}

}  // namespace treedyn::formulate
