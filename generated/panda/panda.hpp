// panda.hpp: dynamics of the model panda
//
// This file was generated from your model and belongs to you; wherever a licence is needed:
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate panda.yaml
//
//   joint   link   index  type      unit
//   joint1  link1  0      revolute  rad
//   joint2  link2  1      revolute  rad
//   joint3  link3  2      revolute  rad
//   joint4  link4  3      revolute  rad
//   joint5  link5  4      revolute  rad
//   joint6  link6  5      revolute  rad
//   joint7  link7  6      revolute  rad
//
//   point   link    index  at (link frame, m)
//   flange  flange  0      0, 0, 0

#pragma once

namespace panda {

/// The only floating-point type in use.
using Scalar = double;
/// Length of q, qd, qdd and tau.
constexpr int kDof = 7;
/// Number of points.
constexpr int kPoints = 1;
/// Of header and source: neither compiles with that of another run.
constexpr unsigned long long kDigest = 0x6913a05fe1687387ULL;

/// Index of every joint.
namespace joint {
constexpr int joint1 = 0;
constexpr int joint2 = 1;
constexpr int joint3 = 2;
constexpr int joint4 = 3;
constexpr int joint5 = 4;
constexpr int joint6 = 5;
constexpr int joint7 = 6;
}  // namespace joint

/// Index of every point.
namespace point {
constexpr int flange = 0;
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
/// \param      q  7, rad|m
/// \param[out] A  49, kg m^2|kg m|kg
/// Equation (2). Cost: 147 mul, 139 add, 6 sin, 6 cos.
void mass_matrix(const Scalar q[7], Scalar A[49]) noexcept;

/// Coriolis and centrifugal joint forces B(q, qd), without gravity.
///
/// \param      q   7, rad|m
/// \param      qd  7, rad/s|m/s
/// \param[out] B   7, N m|N
/// Equation (3). Cost: 238 mul, 219 add, 6 sin, 6 cos.
void bias_force(const Scalar q[7], const Scalar qd[7], Scalar B[7]) noexcept;

/// Gravity term G(q) of A qdd + B + G = tau.
///
/// \param      q  7, rad|m
/// \param[out] G  7, N m|N
/// Equation 6.5. Cost: 42 mul, 28 add, 6 sin, 6 cos.
void gravity_force(const Scalar q[7], Scalar G[7]) noexcept;

/// Joint forces tau = A(q) qdd + B(q, qd) + G(q).
///
/// \param      q    7, rad|m
/// \param      qd   7, rad/s|m/s
/// \param      qdd  7, rad/s^2|m/s^2
/// \param[out] tau  7, N m|N
/// Equation (1). Cost: 262 mul, 249 add, 6 sin, 6 cos.
void inverse_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar qdd[7],
                      Scalar tau[7]) noexcept;

/// Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.
///
/// \param      q    7, rad|m
/// \param      qd   7, rad/s|m/s
/// \param      tau  7, N m|N
/// \param[out] qdd  7, rad/s^2|m/s^2
/// Results mean nothing where a divisor is zero, as where A is singular. Equation (1). Cost: 511
/// mul, 468 add, 6 div, 6 sin, 6 cos.
void forward_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar tau[7],
                      Scalar qdd[7]) noexcept;

/// Positions of the points, base frame.
///
/// \param      q  7, rad|m
/// \param[out] p  3, m
/// Equation 1.2. Cost: 22 mul, 15 add, 6 sin, 6 cos.
void point_positions(const Scalar q[7], Scalar p[3]) noexcept;

/// C of the points, transposed Jacobian; N x 3P, row-major.
///
/// \param      q  7, rad|m
/// \param[out] C  21, m|1
/// Equation (9). Cost: 70 mul, 34 add, 6 sin, 6 cos.
void force_jacobian_transpose(const Scalar q[7], Scalar C[21]) noexcept;

}  // namespace panda
