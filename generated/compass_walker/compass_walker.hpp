// compass_walker.hpp: dynamics of the model compass_walker
//
// This file was generated from your model and belongs to you; wherever a licence is needed:
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate compass_walker.yaml
//
//   joint      link       index  type       unit
//   hip_x      slide      0      prismatic  m
//   hip_z      hip        1      prismatic  m
//   left_hip   left_leg   2      revolute   rad
//   right_hip  right_leg  3      revolute   rad
//
//   point       link       index  at (link frame, m)
//   left_foot   left_leg   0      0, 0, -1
//   right_foot  right_leg  1      0, 0, -1

#pragma once

namespace compass_walker {

/// The only floating-point type in use.
using Scalar = double;
/// Length of q, qd, qdd and tau.
constexpr int kDof = 4;
/// Number of points.
constexpr int kPoints = 2;
/// Of header and source: neither compiles with that of another run.
constexpr unsigned long long kDigest = 0x1b42bfdf664f2333ULL;

/// Index of every joint.
namespace joint {
constexpr int hip_x = 0;
constexpr int hip_z = 1;
constexpr int left_hip = 2;
constexpr int right_hip = 3;
}  // namespace joint

/// Index of every point.
namespace point {
constexpr int left_foot = 0;
constexpr int right_foot = 1;
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
/// \param      q  4, rad|m
/// \param[out] A  16, kg m^2|kg m|kg
/// Equation (2). Cost: 4 mul, 2 sin, 2 cos.
void mass_matrix(const Scalar q[4], Scalar A[16]) noexcept;

/// Coriolis and centrifugal joint forces B(q, qd), without gravity.
///
/// \param      q   4, rad|m
/// \param      qd  4, rad/s|m/s
/// \param[out] B   4, N m|N
/// Equation (3). Cost: 8 mul, 2 add, 2 sin, 2 cos.
void bias_force(const Scalar q[4], const Scalar qd[4], Scalar B[4]) noexcept;

/// Gravity term G(q) of A qdd + B + G = tau.
///
/// \param      q  4, rad|m
/// \param[out] G  4, N m|N
/// Equation 6.5. Cost: 2 mul, 2 sin.
void gravity_force(const Scalar q[4], Scalar G[4]) noexcept;

/// Joint forces tau = A(q) qdd + B(q, qd) + G(q).
///
/// \param      q    4, rad|m
/// \param      qd   4, rad/s|m/s
/// \param      qdd  4, rad/s^2|m/s^2
/// \param[out] tau  4, N m|N
/// Equation (1). Cost: 22 mul, 13 add, 2 sin, 2 cos.
void inverse_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar qdd[4],
                      Scalar tau[4]) noexcept;

/// Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.
///
/// \param      q    4, rad|m
/// \param      qd   4, rad/s|m/s
/// \param      tau  4, N m|N
/// \param[out] qdd  4, rad/s^2|m/s^2
/// Results mean nothing where a divisor is zero, as where A is singular. Equation (1). Cost: 35
/// mul, 21 add, 2 div, 2 sin, 2 cos.
void forward_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar tau[4],
                      Scalar qdd[4]) noexcept;

/// Positions of the points, base frame.
///
/// \param      q  4, rad|m
/// \param[out] p  6, m
/// Equation 1.2. Cost: 4 add, 2 sin, 2 cos.
void point_positions(const Scalar q[4], Scalar p[6]) noexcept;

/// C of the points, transposed Jacobian; N x 3P, row-major.
///
/// \param      q  4, rad|m
/// \param[out] C  24, m|1
/// Equation (9). Cost: 2 sin, 2 cos.
void force_jacobian_transpose(const Scalar q[4], Scalar C[24]) noexcept;

}  // namespace compass_walker
