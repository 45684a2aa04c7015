#include "formulate/scene_guards.hpp"

#include <algorithm>

#include "common/index.hpp"
#include "formulate/geometry.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

using model::Event;
using model::EventKind;

namespace {

/// normal . (sum of lambda_k d_k) over the rows of a constraint, and the height.
Expr pull(const Task& task, const Event& event, int lambda) {
  Graph& graph = task.kinematics.graph();
  const model::Scene& scene = *task.options.scene;
  int row = 0;
  Expr sum = event.plane.height == 0 ? Expr() : constant(graph, event.plane.height);
  for (const int c : task.options.active) {
    const model::Constraint& constraint = scene.constraints[to_index(c)];
    for (std::size_t k = 0; c == event.constraint && k < constraint.directions.size(); ++k) {
      const Expr reaction = input(graph, lambda, row + static_cast<int>(k));
      sum += constant(graph, dot(event.plane.normal, constraint.directions[k])) * reaction;
    }
    if (c == event.constraint && constraint.kind == model::ConstraintKind::kJoint) {
      const Expr reaction = input(graph, lambda, row);
      sum += constant(graph, event.plane.normal[0]) * reaction;
    }
    row += static_cast<int>(constraint.rows());
  }
  return sum;
}

}  // namespace

GuardArrays guard_arrays(const std::vector<Event>& events) {
  GuardArrays arrays;
  int next = 2;
  const auto uses_time = [](const Event& event) {
    return event.kind == EventKind::kExpression && event.value.uses(model::Quantity::kTime);
  };
  if (std::ranges::any_of(events, uses_time)) {
    arrays.t = next++;
  }
  if (std::ranges::any_of(events,
                          [](const Event& event) { return event.kind == EventKind::kReaction; })) {
    arrays.lambda = next;
  }
  return arrays;
}

std::vector<Expr> build_guards(const Task& task) {
  Graph& graph = task.kinematics.graph();
  const GuardArrays arrays = guard_arrays(task.options.events);
  const SceneForces forces(task, {.tau = -1, .t = arrays.t});
  std::vector<Expr> result;
  for (const Event& event : task.options.events) {
    if (event.kind == EventKind::kReaction) {
      result.push_back(pull(task, event, arrays.lambda));
    } else if (event.kind == EventKind::kExpression) {
      result.push_back(value_of(graph, event.value, forces.meaning()));
    } else {
      const Vec3 p = forces.position(event.point);
      const Expr along = dot(constant(graph, event.plane.normal), p);
      result.push_back(along - constant(graph, event.plane.height));
    }
  }
  return result;
}

std::vector<Expr> build_approaches(const Task& task) {
  const SceneForces forces(task, {.tau = -1});
  std::vector<Expr> result;
  for (const Event& event : task.options.events) {
    const Vec3 v = forces.velocity(event.point);
    result.push_back(dot(constant(task.kinematics.graph(), event.plane.normal), v));
  }
  return result;
}

bool anchors_use_time(const model::Scene& scene) {
  for (int c = 0; c < static_cast<int>(scene.constraints.size()); ++c) {
    if (anchor_size(scene, c) > 0 &&
        depends_on_time(scene.constraints[to_index(c)].curve.position)) {
      return true;
    }
  }
  return false;
}

}  // namespace treedyn::formulate
