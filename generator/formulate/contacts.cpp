#include "formulate/contacts.hpp"

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "formulate/derived.hpp"
#include "model/force_laws.hpp"

namespace treedyn::formulate {

namespace {

Expr depth_of(const Task& task, const model::Plane& plane, const Vec3& p) {
  Graph& graph = task.kinematics.graph();
  return constant(graph, plane.height) - dot(constant(graph, plane.normal), p);
}

/// d^n for multiples of 1/2.
Expr power(Graph& graph, Expr d, const Real& n) {
  const int halves = static_cast<int>(Real(2 * n));
  Expr result = constant(graph, Real(1));
  for (int k = 0; k < halves / 2; ++k) {
    result = result * d;
  }
  return halves % 2 == 0 ? result : result * Expr(graph, graph.sqrt(d.ref()));
}

/// Velocity of the point, and the part of it along the normal.
struct Slip {
  Vec3 velocity;
  Expr normal;
};

Slip slip_of(const Task& task, const SceneForces& forces, const model::GroundContact& c) {
  const Vec3 v = forces.velocity(c.point);
  return {v, dot(constant(task.kinematics.graph(), c.plane.normal), v)};
}

/// The law that presses. \param power_array  d^n where the contact needs_power
Expr law(const Task& task, const SceneForces& forces, const model::GroundContact& c, Expr depth,
         const Slip& slip, int power_array) {
  Graph& graph = task.kinematics.graph();
  return value_of(graph, model::normal_law(c), [&](const model::Variable& v) {
    switch (v.quantity) {
      case model::Quantity::kDepth:
        return depth;
      case model::Quantity::kRaisedDepth:
        return needs_power(c) ? input(task.kinematics.graph(), power_array, 0)
                              : power(graph, depth, c.exponent);
      case model::Quantity::kNormalSpeed:
        return slip.normal;
      default:
        return forces.meaning()(v);
    }
  });
}

Vec3 force(const Task& task, const model::GroundContact& c, Expr press, const Slip& slip) {
  const model::VectorExpression law = model::contact_force(c);
  const Meaning meaning = [&](const model::Variable& v) {
    return v.quantity == model::Quantity::kPress         ? press
           : v.quantity == model::Quantity::kNormalSpeed ? slip.normal
                                                         : slip.velocity[to_index(v.index)];
  };
  return value_of(task.kinematics.graph(), law, meaning);
}

}  // namespace

bool needs_power(const model::GroundContact& contact) {
  const Real halves = 2 * contact.exponent;
  return !contact.law && halves != floor(halves);
}

std::vector<Expr> contact_depths(const Task& task, const SceneForces& forces) {
  return transformed(task.options.scene->contacts, [&](const model::GroundContact& c) {
    return depth_of(task, c.plane, forces.position(c.point));
  });
}

std::vector<Expr> build_contact_press(const Task& task, std::size_t contact) {
  const SceneForces forces(task, {.tau = -1});
  const model::GroundContact& c = task.options.scene->contacts[contact];
  const Slip slip = slip_of(task, forces, c);
  const Expr depth = input(task.kinematics.graph(), kDepthArray, static_cast<int>(contact));
  std::vector<Expr> result = {law(task, forces, c, depth, slip, kForceArray + 1)};
  const Vec3 f = force(task, c, input(task.kinematics.graph(), kNormalArray, 0), slip);
  const std::vector<Expr> Q = build_loaded(
      task, *derived("applied_force"), {{task.options.scene->points[to_index(c.point)]}, {f}, {{}}},
      task.kinematics.variant().way);
  for (int i = 0; i < task.tree.dof(); ++i) {
    result.push_back(input(task.kinematics.graph(), kForceArray, i) + Q[to_index(i)]);
  }
  return result;
}

std::vector<Expr> build_contact_force(const Task& task, std::size_t contact) {
  const SceneForces forces(task, {.tau = -1});
  const model::GroundContact& c = task.options.scene->contacts[contact];
  const Slip slip = slip_of(task, forces, c);
  const Expr depth = input(task.kinematics.graph(), kDepthArray, 0);
  const Vec3 f = force(task, c, input(task.kinematics.graph(), kNormalArray, 0), slip);
  const Expr height = depth_of(task, c.plane, forces.position(c.point));
  return {height, law(task, forces, c, depth, slip, kNormalArray + 1), f[0], f[1], f[2]};
}

}  // namespace treedyn::formulate
