// biped.hpp: dynamics of the model biped
//
// This file was generated from your model and belongs to you; wherever a licence is needed:
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate biped.yaml --base axes
//
//   joint              link               index  type       unit
//   base_px            base_px            0      prismatic  m
//   base_py            base_py            1      prismatic  m
//   base_pz            base_pz            2      prismatic  m
//   base_rz            base_rz            3      revolute   rad
//   base_ry            base_ry            4      revolute   rad
//   base_rx            base_rx            5      revolute   rad
//   left_hip_yaw       left_hip_block     6      revolute   rad
//   left_hip_roll      left_hip_fork      7      revolute   rad
//   left_hip_pitch     left_thigh         8      revolute   rad
//   left_knee          left_shank         9      revolute   rad
//   left_ankle_pitch   left_ankle_cross   10     revolute   rad
//   left_ankle_roll    left_foot          11     revolute   rad
//   right_hip_yaw      right_hip_block    12     revolute   rad
//   right_hip_roll     right_hip_fork     13     revolute   rad
//   right_hip_pitch    right_thigh        14     revolute   rad
//   right_knee         right_shank        15     revolute   rad
//   right_ankle_pitch  right_ankle_cross  16     revolute   rad
//   right_ankle_roll   right_foot         17     revolute   rad
//
//   point       link        index  at (link frame, m)
//   left_heel   left_foot   0      -0.06, 0, -0.05903
//   left_toe    left_foot   1      0.20904, 0, -0.05903
//   right_heel  right_foot  2      -0.06, 0, -0.05903
//   right_toe   right_foot  3      0.20904, 0, -0.05903

#pragma once

namespace biped {

/// The only floating-point type in use.
using Scalar = double;
/// Length of q, qd, qdd and tau.
constexpr int kDof = 18;
/// Number of points.
constexpr int kPoints = 4;
/// Of header and source: neither compiles with that of another run.
constexpr unsigned long long kDigest = 0x36d792ddc01aa864ULL;

/// Index of every joint.
namespace joint {
constexpr int base_px = 0;
constexpr int base_py = 1;
constexpr int base_pz = 2;
constexpr int base_rz = 3;
constexpr int base_ry = 4;
constexpr int base_rx = 5;
constexpr int left_hip_yaw = 6;
constexpr int left_hip_roll = 7;
constexpr int left_hip_pitch = 8;
constexpr int left_knee = 9;
constexpr int left_ankle_pitch = 10;
constexpr int left_ankle_roll = 11;
constexpr int right_hip_yaw = 12;
constexpr int right_hip_roll = 13;
constexpr int right_hip_pitch = 14;
constexpr int right_knee = 15;
constexpr int right_ankle_pitch = 16;
constexpr int right_ankle_roll = 17;
}  // namespace joint

/// Index of every point.
namespace point {
constexpr int left_heel = 0;
constexpr int left_toe = 1;
constexpr int right_heel = 2;
constexpr int right_toe = 3;
}  // namespace point

// Arrays are dense, matrices row-major; SI units and radians, a|b by joints that are
// revolute|prismatic. The base frame is the ground's; gravity in it is 0, 0, -9.81 m/s^2. Equations
// have the numbers of treedyn's EQUATIONS.md. Outputs are written completely and must not overlap
// inputs. Nothing is allocated, thrown or kept between calls. Sines and cosines, without
// contraction the same bits everywhere, have errors below 1.7e-16 for arguments below 1.3e7 rad
// where results are rounded to nearest, the default of all processors; they are not a number beyond
// 1.32e7 rad. Arguments are angles, alone or, rounded, in sums with constant ones and those of
// parallel axes.

/// Joint-space inertia matrix A(q); N x N, row-major, symmetric.
///
/// \param      q  18, rad|m
/// \param[out] A  324, kg m^2|kg m|kg
/// Equation (2). Cost: 635 mul, 503 add, 15 sin, 15 cos.
void mass_matrix(const Scalar q[18], Scalar A[324]) noexcept;

/// Coriolis and centrifugal joint forces B(q, qd), without gravity.
///
/// \param      q   18, rad|m
/// \param      qd  18, rad/s|m/s
/// \param[out] B   18, N m|N
/// Equation (3). Cost: 658 mul, 617 add, 15 sin, 15 cos.
void bias_force(const Scalar q[18], const Scalar qd[18], Scalar B[18]) noexcept;

/// Gravity term G(q) of A qdd + B + G = tau.
///
/// \param      q  18, rad|m
/// \param[out] G  18, N m|N
/// Equation 6.5. Cost: 98 mul, 75 add, 14 sin, 14 cos.
void gravity_force(const Scalar q[18], Scalar G[18]) noexcept;

/// Joint forces tau = A(q) qdd + B(q, qd) + G(q).
///
/// \param      q    18, rad|m
/// \param      qd   18, rad/s|m/s
/// \param      qdd  18, rad/s^2|m/s^2
/// \param[out] tau  18, N m|N
/// Equation (1). Cost: 699 mul, 638 add, 15 sin, 15 cos.
void inverse_dynamics(const Scalar q[18], const Scalar qd[18], const Scalar qdd[18],
                      Scalar tau[18]) noexcept;

/// Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.
///
/// \param      q    18, rad|m
/// \param      qd   18, rad/s|m/s
/// \param      tau  18, N m|N
/// \param[out] qdd  18, rad/s^2|m/s^2
/// Results mean nothing where a divisor is zero, as where A is singular. Equation (1). Cost: 1635
/// mul, 1589 add, 17 div, 15 sin, 15 cos.
void forward_dynamics(const Scalar q[18], const Scalar qd[18], const Scalar tau[18],
                      Scalar qdd[18]) noexcept;

/// Positions of the points, base frame.
///
/// \param      q  18, rad|m
/// \param[out] p  12, m
/// Equation 1.2. Cost: 100 mul, 84 add, 15 sin, 15 cos.
void point_positions(const Scalar q[18], Scalar p[12]) noexcept;

/// C of the points, transposed Jacobian; N x 3P, row-major.
///
/// \param      q  18, rad|m
/// \param[out] C  216, m|1
/// Equation (9). Cost: 318 mul, 192 add, 15 sin, 15 cos.
void force_jacobian_transpose(const Scalar q[18], Scalar C[216]) noexcept;

}  // namespace biped
