#include "model/joint_forces.hpp"

#include "common/index.hpp"

namespace treedyn::model {

namespace {

Expression position(int joint) { return Expression(Variable{Quantity::kPosition, joint}); }
Expression velocity(int joint) { return Expression(Variable{Quantity::kVelocity, joint}); }

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
