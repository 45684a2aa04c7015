#include "formulate/constrained_inverse.hpp"

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "equations/equations.hpp"
#include "formulate/contacts.hpp"
#include "formulate/derived.hpp"
#include "formulate/scene_rows.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

namespace {

/// h = A qdd + B + G less the forces of the scene itself: what drives and reactions have to give.
std::vector<Expr> needed_forces(const Task& task, const SceneForces& forces) {
  const model::Scene& scene = *task.options.scene;
  Graph& graph = task.kinematics.graph();
  const InverseArrays arrays = inverse_arrays(scene);
  static const std::shared_ptr<const Derived> needed =
      derived_part("inverse_dynamics", equations::loaded_dynamics());
  std::vector<Expr> h = build_loaded(task, *needed, forces.loads(), task.kinematics.variant().way);
  for (int i = 0; i < task.tree.dof(); ++i) {
    h[to_index(i)] -= forces.joint(i);
    if (arrays.force >= 0) {
      h[to_index(i)] -= input(graph, arrays.force, i);
    }
  }
  for (const model::Armature& armature : scene.armatures) {
    const Expr qdd = input(graph, arrays.qdd, armature.joint);
    h[to_index(armature.joint)] += constant(graph, armature.inertia) * qdd;
  }
  return h;
}

/// J of the active constraints, row by row.
std::vector<Row> active_rows(const Task& task) {
  model::Scene scene = *task.options.scene;
  scene.constraints =
      transformed(task.options.active, [&](int c) { return scene.constraints[to_index(c)]; });
  return base_rows(scene, SceneFrame(task, false), task.kinematics.graph());
}

Expr entry(const Row& row, int joint) {
  const auto found = row.columns.find(joint);
  return found == row.columns.end() ? Expr() : found->second;
}

/// Entry (i, j) of J^T J.
Expr product_of_joints(const std::vector<Row>& rows, int i, int j) {
  Expr sum;
  for (const Row& row : rows) {
    sum += entry(row, i) * entry(row, j);
  }
  return sum;
}

/// lambda = J mu, of one row.
Expr reaction_of_row(const Row& row, const std::vector<int>& passive, const std::vector<Expr>& mu) {
  Expr sum;
  for (std::size_t u = 0; u < passive.size(); ++u) {
    sum += entry(row, passive[u]) * mu[u];
  }
  return sum;
}

}  // namespace

InverseArrays inverse_arrays(const model::Scene& scene) {
  InverseArrays arrays;
  int next = arrays.scene.mu + 1;
  if (!scene.contacts.empty()) {
    arrays.force = next++;
  }
  if (uses_time(scene, {})) {
    arrays.scene.t = next;
  }
  return arrays;
}

std::vector<Expr> build_constrained_inverse(const Task& task) {
  Graph& graph = task.kinematics.graph();
  const std::vector<int> passive = passive_joints(*task.options.scene);
  const std::vector<Row> rows = active_rows(task);
  const InverseArrays arrays = inverse_arrays(*task.options.scene);
  const SceneForces forces(task, arrays.scene);
  const std::vector<Expr> h = needed_forces(task, forces);
  std::vector<Expr> result;
  std::vector<Expr> mu;
  for (std::size_t u = 0; u < passive.size(); ++u) {
    for (std::size_t v = 0; v <= u; ++v) {
      result.push_back(product_of_joints(rows, passive[u], passive[v]));
    }
    mu.push_back(input(graph, arrays.scene.mu, static_cast<int>(u)));
  }
  for (const int u : passive) {
    result.push_back(h[to_index(u)]);
  }
  const std::vector<Expr> lambda =
      transformed(rows, [&](const Row& row) { return reaction_of_row(row, passive, mu); });
  for (int i = 0; i < task.tree.dof(); ++i) {
    Expr tau = h[to_index(i)];
    for (std::size_t r = 0; r < rows.size(); ++r) {
      tau -= entry(rows[r], i) * lambda[r];
    }
    result.push_back(tau);
  }
  result.insert(result.end(), lambda.begin(), lambda.end());
  const std::vector<Expr> depths = contact_depths(*task.options.scene, task, forces);
  result.insert(result.end(), depths.begin(), depths.end());
  return result;
}

}  // namespace treedyn::formulate
