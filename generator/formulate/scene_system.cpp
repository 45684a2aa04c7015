#include "formulate/scene_system.hpp"

#include <algorithm>

#include "formulate/builders.hpp"
#include "formulate/derived.hpp"
#include "model/mass_unit.hpp"

namespace treedyn::formulate {

namespace {

constexpr int kBaseJoints = 6;

Expr divided(Graph& graph, const Expr& force, const Real& unit) {
  return unit == 1 ? force : force * constant(graph, 1 / unit);
}

/// Calls `add(k, force)` for every coordinate k that a load moves: C f + H n.
template <class Add>
void each_load(const model::Scene& scene, const SceneForces& forces, const SceneFrame& frame,
               Add add) {
  for (const AppliedLoad& load : forces.loads()) {
    const model::Point& point = scene.points[static_cast<std::size_t>(load.point)];
    const MotionMap map = load.is_moment ? frame.turning(point) : frame.point(point);
    const Vec3 value = frame.direction(load.value);
    for (const auto& [k, column] : map.columns) {
      add(static_cast<std::size_t>(k), dot(column, value));
    }
  }
}

}  // namespace

SceneSystem::SceneSystem(const Task& task, const SceneArrays& arrays, bool forces)
    : task_(task),
      scene_(*task.options.scene),
      unit_(model::mass_unit(scene_.tree)),
      forces_(task, arrays) {
  add_equations(task.kinematics.variant().trunk && can_use_trunk(), forces);
  add_armatures();
  if (forces) {
    add_loads();
  }
}

/// The trunk as one body: nothing may act on the base's own joints and links but drive forces.
bool SceneSystem::can_use_trunk() const {
  const auto in_base = [](int link) {
    return link != model::kGround && link < kBaseJoints - 1;
  };
  const bool plain =
      std::none_of(scene_.points.begin(), scene_.points.end(),
                   [&](const model::Point& p) { return in_base(p.link); }) &&
      std::none_of(scene_.constraints.begin(), scene_.constraints.end(),
                   [](const model::Constraint& c) {
                     return c.kind == model::ConstraintKind::kJoint && c.joint < kBaseJoints;
                   }) &&
      std::none_of(scene_.armatures.begin(), scene_.armatures.end(),
                   [](const model::Armature& a) { return a.joint < kBaseJoints; });
  return plain && has_free_base(task_.tree) && task_.tree.dof() == task_.tree.size();
}

void SceneSystem::add_armatures() {
  for (const model::Armature& armature : scene_.armatures) {
    const int k = task_.tree.drives[static_cast<std::size_t>(armature.joint)].coordinate;
    a_[{k, k}] += constant(task_.kinematics.graph(), armature.inertia / unit_);
  }
}

void SceneSystem::add_loads() {
  each_load(scene_, forces_, *frame_,
            [&](std::size_t k, const Expr& force) { right_[k] += in_unit(force); });
}

Expr SceneSystem::in_unit(const Expr& force) const {
  return divided(task_.kinematics.graph(), force, unit_);
}

std::vector<Expr> SceneSystem::reactions(std::vector<Expr> of_unit) const {
  for (Expr& reaction : of_unit) {
    reaction = divided(task_.kinematics.graph(), reaction, 1 / unit_);
  }
  return of_unit;
}

void SceneSystem::add_equations(bool by_trunk, bool forces) {
  const Kinematics& k = task_.kinematics;
  frame_.emplace(task_, by_trunk, forces && scene_.velocity_products);
  if (by_trunk) {
    trunk_ = trunk_system(task_, [&](int i) {
      const Expr force = forces ? in_unit(forces_.joint(i)) : Expr();
      return k.link(i).sign > 0 ? force : -force;
    });
    a_ = trunk_->a;
    right_ = trunk_->right;
    return;
  }
  const int n = task_.tree.dof();
  const std::vector<Expr> a = build_equation(task_, "mass_matrix");
  const std::vector<Expr> bias = build_equation(task_, "inverse_dynamics");
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      a_[{i, j}] = a[static_cast<std::size_t>(i * n + j)];
    }
    right_.push_back(forces ? in_unit(forces_.joint(i)) - bias[static_cast<std::size_t>(i)]
                            : Expr());
  }
}

std::vector<Expr> SceneSystem::accelerations(const std::vector<Expr>& x) const {
  const Kinematics& k = task_.kinematics;
  return trunk_
             ? joint_accelerations(k, trunk_->gimbal, trunk_->velocity, -k.ground_acceleration(), x)
             : x;
}

std::vector<Expr> SceneSystem::velocities(const std::vector<Expr>& qd) const {
  if (!trunk_) {
    return qd;
  }
  const Kinematics& k = task_.kinematics;
  const auto along = [&](int i) {
    const Expr speed = qd[static_cast<std::size_t>(i)];
    return k.link(i).sign > 0 ? speed : -speed;
  };
  const BaseAxes& axes = trunk_->gimbal.axes;
  Vec3 linear;
  for (int i = 0; i < 3; ++i) {
    linear = linear + along(i) * axes.sliding[static_cast<std::size_t>(i)];
  }
  const Vec3 first = along(3) * axes.first;
  Vec3 omega = first + along(4) * axes.second;
  omega[2] += along(5);
  std::vector<Expr> x = qd;
  std::copy(linear.begin(), linear.end(), x.begin());
  std::copy(omega.begin(), omega.end(), x.begin() + 3);
  return x;
}

std::vector<Expr> SceneSystem::joint_velocities(const std::vector<Expr>& x) const {
  return trunk_ ? joint_accelerations(task_.kinematics, trunk_->gimbal, {}, {}, x) : x;
}

bool can_be_articulated(const model::Scene& scene) {
  return scene.armatures.empty() && scene.tree.dof() == scene.tree.size();
}

std::vector<Expr> articulated_accelerations(const Task& task, const SceneForces& forces) {
  const model::Scene& scene = *task.options.scene;
  const Kinematics& k = task.kinematics;
  const Real unit = model::mass_unit(scene.tree);
  const SceneFrame frame(task, false, scene.velocity_products);
  std::vector<Expr> applied;
  for (int i = 0; i < scene.tree.dof(); ++i) {
    applied.push_back(forces.joint(i));
  }
  each_load(scene, forces, frame, [&](std::size_t i, const Expr& force) { applied[i] += force; });
  const JointForce along = [&](int i) {
    const Expr force = divided(k.graph(), applied[static_cast<std::size_t>(i)], unit);
    return k.link(i).sign > 0 ? force : -force;
  };
  return articulated_forward_dynamics(task, *derived("forward_dynamics"), along);
}

}  // namespace treedyn::formulate
