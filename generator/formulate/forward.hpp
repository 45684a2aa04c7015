// Forward dynamics: qdd = A^-1 (tau - B - G), by factoring A or by articulated bodies.
#pragma once

#include <vector>

#include "formulate/derived.hpp"
#include "formulate/link_kinematics.hpp"

namespace treedyn::formulate {

/// The base axes of a free base, seen from the trunk.
struct BaseAxes {
  std::array<Vec3, 3> sliding;  ///< axes of joints 0..2
  Vec3 first;                   ///< axis of joint 3
  Vec3 second;                  ///< axis of joint 4
};

/// The base's turning axes in the trunk: a3 = sine z + cosine b, a4, z with b, a4, z orthonormal.
struct Gimbal {
  BaseAxes axes;
  Vec3 b;
  Expr sine;
  Expr inverse_cosine;
};

/// Velocity of the trunk and the part of its angular acceleration that the speeds alone cause.
struct TrunkVelocity {
  Vec3 omega;
  Vec3 zeta;
};
TrunkVelocity trunk_velocity(const Kinematics& kinematics);

/// A x = right of a free base. x: linear acceleration of the trunk's origin minus gravity (0..2)
/// and angular acceleration of the trunk (3..5), both in the trunk's frame; the accelerations of
/// the limbs' joints.
struct TrunkSystem {
  Gimbal gimbal;
  TrunkVelocity velocity;
  SparseSymmetric a;
  std::vector<Expr> right;
};
TrunkSystem trunk_system(const Task& task, const JointForce& force);

/// qdd for the x of a TrunkSystem.
std::vector<Expr> joint_accelerations(const Kinematics& kinematics, const Gimbal& gimbal,
                                      const TrunkVelocity& velocity, const Vec3& gravity,
                                      std::vector<Expr> x);

/// Forward dynamics of a free base: the trunk's six accelerations are solved for first, in the
/// trunk's frame; the base joints' accelerations follow from them. Singular where the base's second
/// turning angle is pi/2.
std::vector<Expr> forward_dynamics_by_trunk(const Task& task, const Vec3& gravity,
                                            bool articulated);

}  // namespace treedyn::formulate
