// (3) and (1) as one forward and one backward sweep: D as prefix sum, D^T as subtree sum,
// EQUATIONS.md 7.2.
#pragma once

#include <vector>

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// Velocity and acceleration of a link in its expression frame.
struct Motion {
  Vec3 omega;  ///< angular velocity
  Vec3 alpha;  ///< angular acceleration
  Vec3 a;      ///< acceleration of the origin
  Mat3 Omega;  ///< Lambda(alpha) + Lambda(omega)^2
  Expr xx;     ///< omega_x^2, shared along a run of parallel axes
  Expr yy;     ///< omega_y^2
  Expr xx_zz;  ///< omega_x^2 - omega_z^2 = Omega_xx - Omega_zz
};

/// Motion of a body that moves with `omega`, `alpha` and `a`.
Motion motion(const Vec3& omega, const Vec3& alpha, const Vec3& a);

/// Force and moment about the origin.
struct Wrench {
  Vec3 force;
  Vec3 moment;
};

/// What the limbs and the trunk of a free base need when nothing accelerates: the velocity products
/// alone.
struct TrunkBias {
  std::vector<Expr> tau;  ///< joints of the limbs; the base joints' entries are zero
  Wrench trunk;           ///< on the trunk, at its origin, in its frame
};
/// \param omega angular velocity of the trunk in its frame
TrunkBias trunk_bias(const Kinematics& kinematics, const Vec3& omega);
/// Motions of the trunk and of the limbs of a free base in the same state; those before are empty.
std::vector<Motion> limb_motions(const Kinematics& kinematics, const Vec3& omega);

}  // namespace treedyn::simplify
