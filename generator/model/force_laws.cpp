#include "model/force_laws.hpp"

#include <algorithm>
#include <iterator>

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

/// Springs and dampers of one joint act as one.
struct Elastic {
  Real at_zero = 0;  ///< its force at q = 0 at rest
  Real stiffness = 0;
  Real damping = 0;

  void add(const JointSpring& spring) {
    at_zero += spring.stiffness * spring.rest;
    stiffness += spring.stiffness;
    damping += spring.damping;
  }
  [[nodiscard]] Expression law(int joint) const {
    return at_zero - stiffness * position(joint) - damping * velocity(joint);
  }
};

/// -force qd / sqrt(qd^2 + slip_speed^2).
Expression regularised(const Expression& force, const Real& slip_speed, int joint) {
  const Expression qd = velocity(joint);
  return -(force * qd / sqrt(qd * qd + Real(slip_speed * slip_speed)));
}

Expression law(const StribeckFriction& friction) {
  const Expression ratio = velocity(friction.joint) * Real(1 / friction.stribeck_speed);
  const Expression more = Real(friction.static_force - friction.force) / (Real(1) + ratio * ratio);
  return regularised(friction.force + more, friction.slip_speed, friction.joint);
}

}  // namespace

Expression law(const JointSpring& spring) {
  Elastic alone;
  alone.add(spring);
  return alone.law(spring.joint);
}

/// -(k (l - rest) + c l') along the unit vector from the anchor, l l' = u . v with u = p - anchor.
PointLoad law(const PointSpring& spring) {
  VectorExpression u = of_point(Quantity::kPointPosition);
  for (std::size_t n = 0; n < 3; ++n) {
    u[n] = u[n] - spring.anchor[n];
  }
  const Expression squared = dot(u, u);
  Expression factor = spring.stiffness;
  if (spring.rest_length != 0) {
    factor = factor - Real(spring.stiffness * spring.rest_length) / sqrt(squared);
  }
  if (spring.damping != 0) {
    factor = factor + spring.damping * dot(u, of_point(Quantity::kPointVelocity)) / squared;
  }
  return {spring.point, {-(factor * u[0]), -(factor * u[1]), -(factor * u[2])}};
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

std::vector<PointLoad> point_forces(const Scene& scene) {
  std::vector<PointLoad> result;
  std::ranges::transform(scene.point_springs, std::back_inserter(result),
                         [](const PointSpring& spring) { return law(spring); });
  result.insert(result.end(), scene.forces.begin(), scene.forces.end());
  return result;
}

std::vector<Expression> joint_forces(const Scene& scene, int joint) {
  std::vector<Expression> result;
  const auto add = [&](const Expression& force) {
    if (!force.is_zero()) {
      result.push_back(force);
    }
  };
  if (!scene.tau.empty()) {
    add(scene.tau[to_index(joint)]);
  }
  for (const Motor& motor : scene.motors) {
    add(motor.joint == joint ? motor.torque : Expression());
  }
  Elastic elastic;
  for (const JointSpring& spring : scene.joint_springs) {
    if (spring.joint == joint) {
      elastic.add(spring);
    }
  }
  for (const ViscousFriction& friction : scene.viscous_frictions) {
    elastic.damping += friction.joint == joint ? friction.coefficient : Real(0);
  }
  add(elastic.law(joint));
  Expression dry;
  for (const JointFriction& friction : scene.frictions) {
    if (friction.joint == joint && friction.slip_speed > 0) {
      dry = dry + regularised(friction.force, friction.slip_speed, joint);
    }
  }
  for (const StribeckFriction& friction : scene.stribeck_frictions) {
    dry = friction.joint == joint ? dry + law(friction) : dry;
  }
  add(dry);
  return result;
}

}  // namespace treedyn::model
