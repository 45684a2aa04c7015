#include "formulate/constrained_inverse.hpp"

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "formulate/constrained.hpp"
#include "formulate/contacts.hpp"
#include "formulate/factored.hpp"
#include "formulate/scene_solution.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

namespace {

/// h = A qdd + B + G less the forces of the scene itself: what drives and reactions have to give.
std::vector<Expr> needed_forces(const Task& task, const SceneForces& forces) {
  const model::Scene& scene = *task.options.scene;
  Graph& graph = task.kinematics.graph();
  const InverseArrays arrays = inverse_arrays(scene, task.options.active);
  std::vector<Expr> h = build_loaded(task, given("constrained_inverse_dynamics", "h"),
                                     forces.loads(), task.kinematics.variant().way);
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

}  // namespace

std::vector<int> joints_without_drive(const model::Scene& scene, const std::vector<int>& active) {
  return rows_of(scene, active) > 0 ? passive_joints(scene) : std::vector<int>();
}

InverseArrays inverse_arrays(const model::Scene& scene, const std::vector<int>& active) {
  InverseArrays arrays;
  int next = arrays.qdd + 1;
  if (!joints_without_drive(scene, active).empty()) {
    arrays.scene.mu = next++;
  }
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
  const model::Scene& scene = *task.options.scene;
  const std::vector<int> passive = joints_without_drive(scene, task.options.active);
  const std::vector<Row> rows = passive.empty() ? std::vector<Row>() : active_rows(task);
  const InverseArrays arrays = inverse_arrays(scene, task.options.active);
  const SceneForces forces(task, arrays.scene);
  const std::vector<Expr> h = needed_forces(task, forces);
  std::vector<Expr> mu;
  for (std::size_t u = 0; u < passive.size(); ++u) {
    mu.push_back(input(graph, arrays.scene.mu, static_cast<int>(u)));
  }
  const SceneSolution solution(
      "constrained_inverse_dynamics", graph, task.tree.dof(), rows,
      [&](const std::string& symbol) { return sparse(symbol == "h" ? h : mu); }, passive);
  std::vector<Expr> result = solution.equations();
  const std::vector<Expr> lambda = solution.x(0);
  const std::vector<Expr> tau = solution.x(1);
  result.insert(result.end(), tau.begin(), tau.end());
  result.insert(result.end(), lambda.begin(), lambda.end());
  const std::vector<Expr> depths = contact_depths(task, forces);
  result.insert(result.end(), depths.begin(), depths.end());
  return result;
}

}  // namespace treedyn::formulate
