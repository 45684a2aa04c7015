#include "simplify/scene_system.hpp"

#include <algorithm>

#include "simplify/builders.hpp"

namespace treedyn::simplify {

namespace {

constexpr int kBaseJoints = 6;

}  // namespace

SceneSystem::SceneSystem(const Task& task, const SceneArrays& arrays)
    : task_(task), scene_(*task.options.scene), arrays_(arrays) {
  meaning_ = [this](const model::Variable& v) {
    switch (v.quantity) {
      case model::Quantity::kPosition:
        return input(arrays_.q, v.index);
      case model::Quantity::kVelocity:
        return input(arrays_.qd, v.index);
      default:
        TREEDYN_EXPECT(v.quantity == model::Quantity::kTime);
        return input(arrays_.t, 0);
    }
  };
  const bool by_trunk = task.kinematics.variant().trunk && can_use_trunk();
  add_equations(by_trunk);
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

Expr SceneSystem::input(int array, int element) const {
  TREEDYN_EXPECT(array >= 0);
  Graph& graph = task_.kinematics.graph();
  return {graph, graph.input(array, element)};
}

Expr SceneSystem::joint_force(int joint) const { return input(arrays_.tau, joint); }

void SceneSystem::add_equations(bool by_trunk) {
  const Kinematics& k = task_.kinematics;
  frame_.emplace(task_, by_trunk, scene_.velocity_products);
  if (by_trunk) {
    trunk_ = trunk_system(k, [&](int i) {
      const Expr force = joint_force(i);
      return k.link(i).sign > 0 ? force : -force;
    });
    a_ = trunk_->a;
    right_ = trunk_->right;
    return;
  }
  const int n = task_.tree.dof();
  const std::vector<Expr> a = build_mass_matrix(task_);
  const std::vector<Expr> bias = build_with_gravity(task_);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      a_[{i, j}] = a[static_cast<std::size_t>(i * n + j)];
    }
    right_.push_back(joint_force(i) - bias[static_cast<std::size_t>(i)]);
  }
}

std::vector<Expr> SceneSystem::accelerations(const std::vector<Expr>& x) const {
  const Kinematics& k = task_.kinematics;
  return trunk_
             ? joint_accelerations(k, trunk_->gimbal, trunk_->velocity, -k.ground_acceleration(), x)
             : x;
}

}  // namespace treedyn::simplify
