#include "formulate/constrained.hpp"

#include <numeric>

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "formulate/contacts.hpp"
#include "formulate/scene_drift.hpp"
#include "formulate/scene_solution.hpp"
#include "formulate/scene_system.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

namespace {

std::vector<Expr> inputs(Graph& graph, int array, int count) {
  std::vector<Expr> result;
  for (int k = 0; k < count; ++k) {
    result.push_back(input(graph, array, k));
  }
  return result;
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

/// Of a scene without rows: qdd and the depths of contacts.
std::vector<Expr> articulated_dynamics(const Task& task, const SceneArrays& arrays) {
  const SceneForces forces(task, arrays);
  std::vector<Expr> result = articulated_accelerations(task, forces);
  const std::vector<Expr> depths = contact_depths(task, forces);
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
  const SceneRows::Correction correction = [&](int constraint) {
    return is_stabilised(*task.options.scene, constraint)
               ? drift_corrections(task, system.forces(), constraint, arrays.anchor)
               : std::vector<Expr>();
  };
  const SceneRows rows(*task.options.scene, active, system.frame(), graph, system.meaning(),
                       correction);
  const std::vector<Expr> mu = inputs(graph, arrays.mu, rows.size());
  const SceneSolution solution("constrained_dynamics", graph, system.dof(), rows.rows(),
                               [&](const std::string& symbol) {
                                 return symbol == "A" ? sparse(system.dof(), system.inertia())
                                                      : sparse(symbol == "τ"       ? system.tau()
                                                               : symbol == "h"     ? system.h()
                                                               : symbol == "a_des" ? rows.wanted()
                                                               : symbol == "γ"     ? rows.gamma()
                                                                                   : mu);
                               });
  std::vector<Expr> result = solution.equations();
  const std::vector<Expr> qdd = system.accelerations(solution.x());
  result.insert(result.end(), qdd.begin(), qdd.end());
  const std::vector<Expr> lambda = system.reactions(rows.reactions(mu));
  result.insert(result.end(), lambda.begin(), lambda.end());
  const std::vector<Expr> depths = contact_depths(task, system.forces());
  result.insert(result.end(), depths.begin(), depths.end());
  return result;
}

namespace {

/// 1 + e of every row, 0 where it is led through the impact.
std::vector<Expr> rebounds(const model::Scene& scene, const Options& options, Graph& graph) {
  std::vector<Expr> result;
  for (const int c : options.active) {
    const bool held = std::ranges::binary_search(options.held, c);
    result.insert(result.end(), scene.constraints[to_index(c)].rows(),
                  held ? Expr() : constant(graph, 1 + options.restitution));
  }
  return result;
}

}  // namespace

std::vector<Expr> build_impact(const Task& task) {
  Graph& graph = task.kinematics.graph();
  const model::Scene& scene = *task.options.scene;
  const SceneArrays arrays = {.qd = 1, .tau = -1, .mu = 2};  // q, qd_minus, mu
  const SceneSystem system(task, arrays, false);
  const Meaning nothing = [&](const model::Variable&) {  // what rows want takes no part
    return constant(graph, Real(1));
  };
  const SceneRows rows(scene, task.options.active, system.frame(), graph, nothing);
  const std::vector<Expr> qd = inputs(graph, arrays.qd, task.tree.dof());
  const std::vector<Expr> velocity = system.velocities(qd);
  const std::vector<Expr> rebound = rebounds(scene, task.options, graph);
  std::vector<Expr> v;
  for (const Row& row : rows.rows()) {
    Expr speed;
    for (const auto& [k, value] : row.columns) {
      speed += value * velocity[to_index(k)];
    }
    v.push_back(rebound[v.size()] * speed);
  }
  const std::vector<Expr> mu = inputs(graph, arrays.mu, rows.size());
  const SceneSolution solution("impact", graph, system.dof(), rows.rows(),
                               [&](const std::string& symbol) {
                                 return symbol == "A" ? sparse(system.dof(), system.inertia())
                                                      : sparse(symbol == "v" ? v : mu);
                               });
  std::vector<Expr> result = solution.equations();
  const std::vector<Expr> change = system.joint_velocities(solution.x());
  for (std::size_t i = 0; i < qd.size(); ++i) {
    result.push_back(qd[i] + change[i]);
  }
  const std::vector<Expr> P = system.reactions(rows.reactions(mu));
  result.insert(result.end(), P.begin(), P.end());
  return result;
}

std::vector<Expr> build_reaction_jacobian(const Task& task) {
  const SceneFrame frame(task, false);
  const std::vector<Row> rows = base_rows(*task.options.scene, frame, task.kinematics.graph());
  std::vector<Expr> result(to_index(task.tree.dof()) * rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const auto& [k, value] : rows[r].columns) {
      result[to_index(k) * rows.size() + r] = value;
    }
  }
  return result;
}

std::vector<Expr> build_reaction_bias(const Task& task) {
  const SceneFrame frame(task, task.options.scene->velocity_products);
  std::vector<Expr> result;
  for (const Row& row : base_rows(*task.options.scene, frame, task.kinematics.graph())) {
    result.push_back(row.gamma);
  }
  return result;
}

}  // namespace treedyn::formulate
