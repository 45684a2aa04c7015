#include "formulate/scene_forces.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/index.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"
#include "formulate/derived.hpp"
#include "model/force_laws.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

using model::Quantity;

namespace {

bool depends_on_time(const model::Expression& e) { return e.uses(Quantity::kTime); }

/// ω = H^T q̇ of the links of points.
const Derived& angular_velocities() {
  static const Derived function = *derived_part(
      "ω",
      block::transpose(equations::moment_jacobian_transpose(equations::points())) * equations::qd);
  return function;
}

bool any_depends_on_time(std::span<const model::Expression> all) {
  return std::ranges::any_of(all, [](const model::Expression& e) { return depends_on_time(e); });
}

}  // namespace

bool depends_on_time(const model::VectorExpression& v) { return any_depends_on_time(v); }

SceneForces::SceneForces(const Task& task, const SceneArrays& arrays)
    : task_(task), scene_(*task.options.scene), arrays_(arrays) {
  meaning_ = [this](const model::Variable& v) {
    switch (v.quantity) {
      case Quantity::kPosition:
        return input(arrays_.q, v.index);
      case Quantity::kVelocity:
        return input(arrays_.qd, v.index);
      default:
        TREEDYN_EXPECT(v.quantity == Quantity::kTime);
        return input(arrays_.t, 0);
    }
  };
  if (!scene_.velocity_products && arrays.qd >= 0) {
    const Kinematics& k = task.kinematics;
    moving_ = std::make_unique<Kinematics>(k.graph(), task.tree, task.normal, k.variant(),
                                           Inputs{.q = arrays.q, .qd = arrays.qd});
  }
}

Expr SceneForces::input(int array, int element) const {
  TREEDYN_EXPECT(array >= 0);
  return program::input(task_.kinematics.graph(), array, element);
}

Expr SceneForces::joint(int joint) const {
  Graph& graph = task_.kinematics.graph();
  Expr sum = arrays_.tau >= 0 ? input(arrays_.tau, joint) : Expr();
  for (const model::JointForce& own : task_.options.phase_forces) {
    sum += own.joint == joint ? constant(graph, own.force) : Expr();
  }
  for (const model::Expression& force : model::joint_forces(scene_, joint)) {
    sum += value_of(graph, force, meaning_);
  }
  return sum;
}

Vec3 SceneForces::position(int point) const {
  return triple(
      values_at(task_, "point_positions", {scene_.points[to_index(point)]}, Way::kToRoot));
}

Vec3 SceneForces::velocity(int point) const {
  const Kinematics& k = moving_ ? *moving_ : task_.kinematics;
  return triple(values_at({task_.tree, task_.normal, task_.options, k}, "point_velocities",
                          {scene_.points[to_index(point)]}, Way::kToRoot));
}

Vec3 SceneForces::angular_velocity(int point) const {
  Options options = task_.options;
  options.points = {scene_.points[to_index(point)]};
  const Kinematics& k = moving_ ? *moving_ : task_.kinematics;
  return triple(build_derived({task_.tree, task_.normal, options, k}, angular_velocities(),
                              moving_ ? Way::kToRoot : Way::kInLinks));
}

Vec3 SceneForces::load(const model::PointLaw& law) const {
  const Meaning meaning = [&](const model::Variable& v) {
    switch (v.quantity) {
      case Quantity::kPointPosition:
        return position(law.point)[to_index(v.index)];
      case Quantity::kPointVelocity:
        return velocity(law.point)[to_index(v.index)];
      default:
        return meaning_(v);
    }
  };
  try {
    return value_of(task_.kinematics.graph(), law.value, meaning);
  } catch (const InputError& error) {
    throw InputError({}, fmt::format("force at point '{}': {}",
                                     scene_.points[to_index(law.point)].name, error.message()));
  }
}

PointLoads SceneForces::loads() const {
  PointLoads result;
  for (const model::PointLaw& law : scene_.point_laws) {
    const Vec3 value = load(law);
    result.points.push_back(scene_.points[to_index(law.point)]);
    result.f.push_back(law.is_moment ? Vec3{} : value);
    result.n.push_back(law.is_moment ? value : Vec3{});
  }
  return result;
}

bool uses_time(const model::Scene& scene, const std::vector<int>& active) {
  const auto row_uses = [&](int c) {
    const model::Constraint& constraint = scene.constraints[to_index(c)];
    const bool stabilised = is_stabilised(scene, c);
    return constraint.accelerations.empty()
               ? depends_on_time(constraint.curve.acceleration) ||
                     (stabilised && depends_on_time(constraint.curve.position))
               : any_depends_on_time(constraint.accelerations);
  };
  return std::ranges::any_of(active, row_uses) ||
         std::ranges::any_of(
             scene.joint_laws,
             [](const model::JointLaw& law) { return depends_on_time(law.force); }) ||
         std::ranges::any_of(scene.point_laws,
                             [](const model::PointLaw& law) { return depends_on_time(law.value); });
}

}  // namespace treedyn::formulate
