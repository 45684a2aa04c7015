// The laws of the effects that act on one joint, as expressions of q and qd, of springs of points
// and of compliant ground: the only place where they stand. Generated code, its proof and the
// simulator evaluate them.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "model/scene.hpp"

namespace treedyn::model {

/// -stiffness (q - rest) - damping qd; stores stiffness/2 (q - rest)^2.
JointLaw joint_spring(int joint, const Real& stiffness, const Real& damping, const Real& rest);

/// -coefficient qd, N m s or N s/m.
JointLaw viscous_friction(int joint, const Real& coefficient);

/// -force qd / sqrt(qd^2 + slip_speed^2), which creeps instead of sticking.
/// \param slip_speed  rad/s or m/s, positive
JointLaw coulomb_friction(int joint, const Real& force, const Real& slip_speed);

/// -(force + (static_force - force) / (1 + (qd/stribeck_speed)^2)) qd / sqrt(qd^2 + slip_speed^2).
/// \param force  at high speed, N m or N
/// \param static_force  at low speed
/// \param stribeck_speed, slip_speed  rad/s or m/s, positive
JointLaw stribeck_friction(int joint, const Real& force, const Real& static_force,
                           const Real& stribeck_speed, const Real& slip_speed);

/// A torque (force) of t, q, qd; controllers are expressions.
JointLaw drive(int joint, const Expression& torque);

/// The laws of one effect, in the order of the scene.
template <class Law>
std::vector<Law> laws_of(const std::vector<Law>& laws, std::string_view effect) {
  std::vector<Law> result;
  std::ranges::copy_if(laws, std::back_inserter(result),
                       [&](const Law& law) { return law.effect == effect; });
  return result;
}

/// Effects whose forces a motion shows joint by joint, in this order, and the names of their
/// columns.
inline constexpr std::array<std::pair<const char*, const char*>, 2> kShownOfJoints = {
    {{"drive", "drive"}, {"joint_spring", "spring"}}};

/// What acts on the joint, N m or N, terms of a sum: the constant force of the scene and its laws.
/// Without dry friction that sticks, what phases add, and the argument tau.
std::vector<Expression> joint_forces(const Scene& scene, int joint);

/// -stiffness (l - rest_length) - damping l' along the line from the anchor, l long; stores
/// stiffness/2 (l - rest_length)^2. Not a number at the anchor, but for springs without a length
/// and without damping.
PointLaw point_spring(int point, const Vector3& anchor, const Real& stiffness, const Real& damping,
                      const Real& rest_length);

/// What the scene says, base frame.
PointLaw point_force(int point, const VectorExpression& value);
PointLaw moment(int point, const VectorExpression& value);

/// True if a moment acts on a link.
bool has_moments(const Scene& scene);

/// What presses the point off the plane below it, N, where it is not negative: k d^n (1 - c vn), or
/// the contact's own law; of (raised) depth and normal speed.
Expression normal_law(const GroundContact& contact);

/// The force on the point, base frame, N: along the normal, and friction -mu f vt / sqrt(vt^2 +
/// vs^2); of the force that presses, the normal speed and the velocity of the point.
VectorExpression contact_force(const GroundContact& contact);

}  // namespace treedyn::model
