#include "formulate/scene_system.hpp"

#include <algorithm>

#include "equations/equations.hpp"
#include "formulate/derived.hpp"
#include "formulate/factored.hpp"
#include "model/mass_unit.hpp"

namespace treedyn::formulate {

namespace {

Expr divided(Graph& graph, const Expr& force, const Real& unit) {
  return unit == 1 ? force : force * constant(graph, 1 / unit);
}

/// Those of a scene in a frame and a unit of mass.
PointLoads loads_in(const SceneFrame& frame, const SceneForces& forces, Graph& graph,
                    const Real& unit) {
  PointLoads loads = forces.loads();
  for (std::vector<Vec3>* const values : {&loads.f, &loads.n}) {
    for (Vec3& value : *values) {
      value = frame.direction(value);
      std::ranges::for_each(value, [&](Expr& x) { x = divided(graph, x, unit); });
    }
  }
  return loads;
}

/// (8) without reactions, solved for the accelerations.
const Derived& articulated() {
  static const Derived function =
      solved(*derived_part("forward_dynamics", equations::free_dynamics()), "q̈");
  return function;
}

/// R13 acts: there is nothing but drive forces on the base's own joints and links.
bool can_use_trunk(const Task& task) {
  const model::Scene& scene = *task.options.scene;
  const auto in_base = [](int link) {
    return link != model::kGround && link < kTrunkLink;
  };
  const bool plain =
      std::ranges::none_of(scene.points, [&](const model::Point& p) { return in_base(p.link); }) &&
      std::ranges::none_of(scene.constraints,
                           [](const model::Constraint& c) {
                             return c.kind == model::ConstraintKind::kJoint &&
                                    c.joint <= kTrunkLink;
                           }) &&
      std::ranges::none_of(scene.armatures,
                           [](const model::Armature& a) { return a.joint <= kTrunkLink; });
  return plain && task.kinematics.variant().trunk && has_trunk(task.tree) &&
         task.tree.mimics() == 0;
}

}  // namespace

SceneSystem::SceneSystem(const Task& task, const SceneArrays& arrays, bool forces)
    : task_(task),
      scene_(*task.options.scene),
      unit_(model::mass_unit(scene_.tree)),
      forces_(task, arrays) {
  add_equations(forces);
  add_armatures();
}

void SceneSystem::add_armatures() {
  for (const model::Armature& armature : scene_.armatures) {
    a_[{armature.joint, armature.joint}] +=
        constant(task_.kinematics.graph(), armature.inertia / unit_);
  }
}

std::vector<Expr> SceneSystem::reactions(std::vector<Expr> of_unit) const {
  for (Expr& reaction : of_unit) {
    reaction = divided(task_.kinematics.graph(), reaction, 1 / unit_);
  }
  return of_unit;
}

void SceneSystem::add_equations(bool forces) {
  if (can_use_trunk(task_)) {
    trunk_.emplace(task_, scene_.constraints.empty() ? Way::kToRoot : Way::kInBase);
  }
  frame_.emplace(task_, forces && scene_.velocity_products, trunk_ ? &*trunk_ : nullptr);
  const Task& task = trunk_ ? trunk_->seen() : task_;
  const int n = task_.tree.dof();
  const std::vector<Expr> a = build_equation(task, "mass_matrix");
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      a_[{i, j}] = a[static_cast<std::size_t>(i * n + j)];
    }
  }
  if (!forces) {
    return;
  }
  Graph& graph = task.kinematics.graph();
  h_ = build_loaded(task, given("constrained_dynamics", "h"),
                    loads_in(*frame_, forces_, graph, unit_), task.kinematics.variant().way);
  for (int i = 0; i < n; ++i) {
    tau_.push_back(divided(graph, forces_.joint(i), unit_));
  }
  tau_ = trunk_ ? trunk_->forces(tau_) : tau_;
}

std::vector<Expr> SceneSystem::accelerations(const std::vector<Expr>& x) const {
  return trunk_ ? trunk_->joint_accelerations(x) : x;
}

std::vector<Expr> SceneSystem::velocities(const std::vector<Expr>& qd) const {
  return trunk_ ? trunk_->velocities(qd) : qd;
}

std::vector<Expr> SceneSystem::joint_velocities(const std::vector<Expr>& x) const {
  return trunk_ ? trunk_->joint_velocities(x) : x;
}

bool can_be_articulated(const model::Scene& scene) {
  return scene.armatures.empty() && scene.tree.mimics() == 0;
}

std::vector<Expr> articulated_accelerations(const Task& task, const SceneForces& forces) {
  const model::Scene& scene = *task.options.scene;
  const Real unit = model::mass_unit(scene.tree);
  std::optional<Trunk> trunk;
  if (can_use_trunk(task)) {
    trunk.emplace(task);
  }
  std::vector<Expr> applied;
  for (int i = 0; i < scene.tree.dof(); ++i) {
    applied.push_back(forces.joint(i));
  }
  applied = trunk ? trunk->forces(applied) : applied;
  Graph& graph = task.kinematics.graph();
  for (Expr& force : applied) {
    force = divided(graph, force, unit);
  }
  const SceneFrame frame(task, false, trunk ? &*trunk : nullptr);
  const Kinematics k = (trunk ? trunk->seen() : task).kinematics.with_forces(applied);
  const std::vector<Expr> x = build_loaded({task.tree, task.normal, task.options, k}, articulated(),
                                           loads_in(frame, forces, graph, unit), Way::kToRoot);
  return trunk ? trunk->joint_accelerations(x) : x;
}

}  // namespace treedyn::formulate
