// Points: positions, velocities, accelerations and Jacobians; (6), (7), (9), (11) and 6.1.
#pragma once

#include <vector>

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// Velocity of a link in its expression frame.
struct Velocity {
  Vec3 omega;
  Vec3 origin;
};
/// Of all links, fathers first: D as prefix sum.
std::vector<Velocity> velocities(const Kinematics& kinematics);

/// The points of a function in the order of its arrays.
using Points = std::vector<model::Point>;

/// Positions in the base frame, 3 P.
std::vector<Expr> point_positions(const Kinematics& kinematics, const Points& points);
/// Velocities in the base frame, 3 P.
std::vector<Expr> point_velocities(const Kinematics& kinematics, const Points& points);
/// gamma_f = d/dt(J) qd of 6.1 in the base frame, 3 P.
std::vector<Expr> point_bias_acceleration(const Kinematics& kinematics, const Points& points);
/// gamma_n of 6.1 in the base frame, 3 P.
std::vector<Expr> angular_bias_acceleration(const Kinematics& kinematics, const Points& points);
/// Link frame -> base frame, row-major, 9 P.
std::vector<Expr> point_rotations(const Kinematics& kinematics, const Points& points);

/// A 1x3 block of C or H: joint, point, and the vector in the base frame.
struct JacobianBlock {
  int joint = 0;
  int point = 0;
  Vec3 value;
};
/// C of (9): z_k x (p - P_k) for revolute, z_k for prismatic joints. Blocks that are structurally
/// zero are absent.
std::vector<JacobianBlock> force_jacobian_transpose(const Kinematics& kinematics,
                                                    const Points& points);
/// H of (11): z_k for revolute joints.
std::vector<JacobianBlock> moment_jacobian_transpose(const Kinematics& kinematics,
                                                     const Points& points);

/// Q = C f + H n of (8) without C and H: D^T as subtree sum, O(N). Joint order.
/// \param f, n array numbers of the forces and moments, 3 P each, base frame
std::vector<Expr> applied_force(const Kinematics& kinematics, const Points& points, int f, int n);

/// l_D of (6), 3N x N row-major: block (i, j) = O_i - P_j for j on the path of i. Of reduced mimic
/// joints the links of the independent joints remain.
std::vector<Expr> joint_to_link_vectors(const Kinematics& kinematics, const model::Tree& tree);
/// c_fD of (7), 3N x N row-major: the same to the centres of mass.
std::vector<Expr> joint_to_com_vectors(const Kinematics& kinematics, const model::Tree& tree);

}  // namespace treedyn::simplify
