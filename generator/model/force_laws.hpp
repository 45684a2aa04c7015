// The laws of the effects that act on one joint, as expressions of q and qd, of springs of points
// and of compliant ground: the only place where they stand. Generated code, its proof and the
// simulator evaluate them.
#pragma once

#include <vector>

#include "model/scene.hpp"

namespace treedyn::model {

/// -stiffness (q - rest) - damping qd, N m or N.
Expression law(const JointSpring& spring);

/// What acts on the joint, N m or N, terms of a sum: the constant force of the scene, every drive,
/// springs and dampers together, dry friction that does not stick. Without what phases add, and
/// without the argument tau.
std::vector<Expression> joint_forces(const Scene& scene, int joint);

/// Along the line from the anchor, N; of the position and the velocity of the point. Not a number
/// at the anchor, but for springs without a length and without damping.
PointLoad law(const PointSpring& spring);

/// What acts at points, N: springs, then forces, in the order of the scene.
std::vector<PointLoad> point_forces(const Scene& scene);

/// What presses the point off the plane below it, N, where it is not negative: k d^n (1 - c vn), or
/// the contact's own law; of (raised) depth and normal speed.
Expression normal_law(const GroundContact& contact);

/// The force on the point, base frame, N: along the normal, and friction -mu f vt / sqrt(vt^2 +
/// vs^2); of the force that presses, the normal speed and the velocity of the point.
VectorExpression contact_force(const GroundContact& contact);

}  // namespace treedyn::model
