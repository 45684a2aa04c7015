// biped.hpp: dynamics of the model biped
//
// This file was generated from your model and belongs to you; wherever a licence is needed:
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate biped.yaml
//
//   joint              link               index  type      unit
//   left_hip_yaw       left_hip_block     0      revolute  rad
//   left_hip_roll      left_hip_fork      1      revolute  rad
//   left_hip_pitch     left_thigh         2      revolute  rad
//   left_knee          left_shank         3      revolute  rad
//   left_ankle_pitch   left_ankle_cross   4      revolute  rad
//   left_ankle_roll    left_foot          5      revolute  rad
//   right_hip_yaw      right_hip_block    6      revolute  rad
//   right_hip_roll     right_hip_fork     7      revolute  rad
//   right_hip_pitch    right_thigh        8      revolute  rad
//   right_knee         right_shank        9      revolute  rad
//   right_ankle_pitch  right_ankle_cross  10     revolute  rad
//   right_ankle_roll   right_foot         11     revolute  rad
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
constexpr int kDof = 12;
/// Number of points.
constexpr int kPoints = 4;
/// Of header and source: neither compiles with that of another run.
constexpr unsigned long long kDigest = 0xe3e261db64de0bdaULL;

/// Index of every joint.
namespace joint {
constexpr int left_hip_yaw = 0;
constexpr int left_hip_roll = 1;
constexpr int left_hip_pitch = 2;
constexpr int left_knee = 3;
constexpr int left_ankle_pitch = 4;
constexpr int left_ankle_roll = 5;
constexpr int right_hip_yaw = 6;
constexpr int right_hip_roll = 7;
constexpr int right_hip_pitch = 8;
constexpr int right_knee = 9;
constexpr int right_ankle_pitch = 10;
constexpr int right_ankle_roll = 11;
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
/// \param      q  12, rad|m
/// \param[out] A  144, kg m^2|kg m|kg
/// Equation (2). Cost: 194 mul, 200 add, 10 sin, 10 cos.
void mass_matrix(const Scalar q[12], Scalar A[144]) noexcept;

/// Coriolis and centrifugal joint forces B(q, qd), without gravity.
///
/// \param      q   12, rad|m
/// \param      qd  12, rad/s|m/s
/// \param[out] B   12, N m|N
/// Equation (3). Cost: 391 mul, 372 add, 10 sin, 10 cos.
void bias_force(const Scalar q[12], const Scalar qd[12], Scalar B[12]) noexcept;

/// Gravity term G(q) of A qdd + B + G = tau.
///
/// \param      q  12, rad|m
/// \param[out] G  12, N m|N
/// Equation 6.5. Cost: 44 mul, 36 add, 10 sin, 10 cos.
void gravity_force(const Scalar q[12], Scalar G[12]) noexcept;

/// Joint forces tau = A(q) qdd + B(q, qd) + G(q).
///
/// \param      q    12, rad|m
/// \param      qd   12, rad/s|m/s
/// \param      qdd  12, rad/s^2|m/s^2
/// \param[out] tau  12, N m|N
/// Equation (1). Cost: 444 mul, 416 add, 10 sin, 10 cos.
void inverse_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar qdd[12],
                      Scalar tau[12]) noexcept;

/// Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.
///
/// \param      q    12, rad|m
/// \param      qd   12, rad/s|m/s
/// \param      tau  12, N m|N
/// \param[out] qdd  12, rad/s^2|m/s^2
/// Results mean nothing where a divisor is zero, as where A is singular. Equation (1). Cost: 724
/// mul, 706 add, 11 div, 10 sin, 10 cos.
void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept;

/// Positions of the points, base frame.
///
/// \param      q  12, rad|m
/// \param[out] p  12, m
/// Equation 1.2. Cost: 52 mul, 50 add, 12 sin, 12 cos.
void point_positions(const Scalar q[12], Scalar p[12]) noexcept;

/// C of the points, transposed Jacobian; N x 3P, row-major.
///
/// \param      q  12, rad|m
/// \param[out] C  144, m|1
/// Equation (9). Cost: 132 mul, 89 add, 12 sin, 12 cos.
void force_jacobian_transpose(const Scalar q[12], Scalar C[144]) noexcept;

}  // namespace biped
