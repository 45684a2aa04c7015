#include "model/force_laws.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace treedyn::model {

namespace {

Expression position(int joint) { return Expression(Variable{Quantity::kPosition, joint}); }
Expression velocity(int joint) { return Expression(Variable{Quantity::kVelocity, joint}); }

/// x, y, z of the point.
VectorExpression of_point(Quantity quantity) {
  return {Expression({quantity, 0}), Expression({quantity, 1}), Expression({quantity, 2})};
}

Expression dot(const VectorExpression& a, const VectorExpression& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// -force qd / sqrt(qd^2 + slip_speed^2).
Expression regularised(const Expression& force, const Real& slip_speed, int joint) {
  const Expression qd = velocity(joint);
  const Expression least(slip_speed, SceneNumber::kSlipSpeed);
  return -(force * qd / sqrt(qd * qd + least * least));
}

}  // namespace

JointLaw joint_spring(int joint, const Real& stiffness, const Real& damping, const Real& rest) {
  const Expression k(stiffness, SceneNumber::kStiffness);
  const Expression at(rest, SceneNumber::kRest);
  const Expression q = position(joint);
  const Expression d(damping, SceneNumber::kDamping);
  const Expression stretch = q - at;
  return {"joint_spring", joint, k * at - k * q - d * velocity(joint),
          Real(0.5) * k * stretch * stretch};
}

JointLaw viscous_friction(int joint, const Real& coefficient) {
  const Expression d(coefficient, SceneNumber::kViscousFriction);
  return {"viscous_friction", joint, -(d * velocity(joint)), {}};
}

JointLaw coulomb_friction(int joint, const Real& force, const Real& slip_speed) {
  const Expression f(force, SceneNumber::kDryFriction);
  return {"coulomb_friction", joint, regularised(f, slip_speed, joint), {}};
}

JointLaw stribeck_friction(int joint, const Real& force, const Real& static_force,
                           const Real& stribeck_speed, const Real& slip_speed) {
  const Expression f(force, SceneNumber::kDryFriction);
  const Expression ratio =
      velocity(joint) / Expression(stribeck_speed, SceneNumber::kStribeckSpeed);
  const Expression more = Expression(static_force, SceneNumber::kStaticFriction) - f;
  return {"stribeck_friction",
          joint,
          regularised(f + more / (Real(1) + ratio * ratio), slip_speed, joint),
          {}};
}

JointLaw drive(int joint, const Expression& torque) { return {"drive", joint, torque, {}}; }

/// -(k (l - rest) + c l') along the unit vector from the anchor, l l' = u . v with u = p - anchor.
PointLaw point_spring(int point, const Vector3& anchor, const Real& stiffness, const Real& damping,
                      const Real& rest_length) {
  const Expression k(stiffness, SceneNumber::kStiffness);
  const Expression c(damping, SceneNumber::kDamping);
  const Expression rest(rest_length, SceneNumber::kRest);
  VectorExpression u = of_point(Quantity::kPointPosition);
  for (std::size_t n = 0; n < 3; ++n) {
    u[n] = u[n] - Expression(anchor[n], SceneNumber::kAnchor);
  }
  const Expression squared = dot(u, u);
  const Expression length = sqrt(squared);
  const Expression approach = c * dot(u, of_point(Quantity::kPointVelocity));
  const Expression factor = k - k * rest / length + approach / squared;
  const Expression stretch = length - rest;
  PointLaw law{"point_spring",
               point,
               false,
               {},
               Real(0.5) * k * stretch * stretch,
               k * stretch + approach / length};
  for (std::size_t n = 0; n < 3; ++n) {
    law.value[n] = -(factor * u[n]);
  }
  if (rest.is_zero()) {  // without a root, which has no rate at the anchor
    law.energy = Real(0.5) * k * squared;
  }
  return law;
}

PointLaw point_force(int point, const VectorExpression& value) {
  return {"force", point, false, value, {}, {}};
}

PointLaw moment(int point, const VectorExpression& value) {
  return {"moment", point, true, value, {}, {}};
}

bool has_moments(const Scene& scene) {
  return std::ranges::any_of(scene.point_laws, &PointLaw::is_moment);
}

Expression normal_law(const GroundContact& contact) {
  if (contact.law) {
    return *contact.law;
  }
  const Expression elastic = contact.stiffness * Expression({Quantity::kRaisedDepth});
  return contact.dissipation == 0
             ? elastic
             : elastic * (Real(1) - contact.dissipation * Expression({Quantity::kNormalSpeed}));
}

VectorExpression contact_force(const GroundContact& contact) {
  const Expression press({Quantity::kPress});
  const model::Vector3& normal = contact.plane.normal;
  VectorExpression slip = of_point(Quantity::kPointVelocity);
  for (std::size_t n = 0; n < 3; ++n) {
    slip[n] = slip[n] - Expression({Quantity::kNormalSpeed}) * normal[n];
  }
  const Real least(contact.slip_speed * contact.slip_speed);
  const Expression factor = contact.friction == 0
                                ? Expression()
                                : contact.friction * press / sqrt(dot(slip, slip) + least);
  VectorExpression force;
  for (std::size_t n = 0; n < 3; ++n) {
    force[n] = press * normal[n] - factor * slip[n];
  }
  return force;
}

std::vector<Expression> joint_forces(const Scene& scene, int joint) {
  std::vector<Expression> result;
  if (!scene.tau.empty() && scene.tau[to_index(joint)] != 0) {
    result.emplace_back(scene.tau[to_index(joint)]);
  }
  for (const JointLaw& law : scene.joint_laws) {
    if (law.joint == joint && !law.force.is_zero()) {
      result.push_back(law.force);
    }
  }
  return result;
}

}  // namespace treedyn::model
