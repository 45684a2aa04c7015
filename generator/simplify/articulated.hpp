// Forward dynamics by articulated bodies: the elimination of 7.4 carried out link by link, O(N).
#pragma once

#include <functional>
#include <vector>

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// The 6x6 inertia [M H^T; H I] with which a link resists, its sons free to move, and its bias
/// wrench.
struct ArticulatedInertia {
  Mat3 tensor;    ///< I: moment per angular acceleration
  Mat3 coupling;  ///< H: moment per linear acceleration
  Mat3 mass;      ///< M: force per linear acceleration
  Wrench bias;
};

/// Drive force of joint i along +z of its normal frame.
using JointForce = std::function<Expr(int)>;

/// qdd for q, qd and joint forces. \param ground acceleration of the ground, -g.
std::vector<Expr> articulated_forward_dynamics(const Kinematics& kinematics, const Vec3& ground,
                                               const JointForce& force);

/// The same for the limbs of a free base: folds them into the trunk's inertia and, once the trunk's
/// acceleration is known, finds their joints' accelerations.
class ArticulatedLimbs {
 public:
  /// \param omega angular velocity of the trunk, \param first link that is folded (the trunk is
  /// first - 1); 0: all links, no trunk.
  ArticulatedLimbs(const Kinematics& kinematics, int first, const Vec3& omega,
                   const JointForce& force);
  /// \pre first > 0
  [[nodiscard]] const ArticulatedInertia& trunk() const { return inertia_[index(first_ - 1)]; }
  /// Joint accelerations of the links from `first` on; the others are zero.
  /// \param alpha, a acceleration of the trunk, or of the ground if first = 0
  [[nodiscard]] std::vector<Expr> accelerations(const Vec3& alpha, const Vec3& a) const;

 private:
  /// What the way back needs: u = tau - z.p, the column of the joint axis, 1 / its diagonal entry.
  struct Joint {
    Vec3 moment;
    Vec3 force;
    Expr inverse;
    Expr rest;
  };
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  void start(int i, const Vec3& omega);
  void velocity(int i);
  void fold(int i);
  void project(int i, ArticulatedInertia& projected);
  void add_to_father(int i, const ArticulatedInertia& projected);

  const Kinematics& k_;
  const JointForce& force_;
  int first_;
  std::vector<Vec3> omega_;
  std::vector<Vec3> zeta_angular_;  ///< velocity products of the angular acceleration
  std::vector<Vec3> zeta_linear_;
  std::vector<ArticulatedInertia> inertia_;
  std::vector<Joint> joint_;
};

}  // namespace treedyn::simplify
