// The laws of the effects that act on one joint, as expressions of q and qd: the only place where
// they stand. Generated code, its proof and the simulator evaluate them.
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

}  // namespace treedyn::model
