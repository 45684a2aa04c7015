// puma560.hpp: dynamics of the model puma560
//
// This file was generated from your model and belongs to you; wherever a licence is needed:
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate puma560.yaml
//
//   joint   link   index  type      unit
//   joint1  link1  0      revolute  rad
//   joint2  link2  1      revolute  rad
//   joint3  link3  2      revolute  rad
//   joint4  link4  3      revolute  rad
//   joint5  link5  4      revolute  rad
//   joint6  link6  5      revolute  rad

#pragma once

namespace puma560 {

/// The only floating-point type in use.
using Scalar = double;
/// Length of q, qd, qdd and tau.
constexpr int kDof = 6;
/// Number of points.
constexpr int kPoints = 0;
/// Of header and source: neither compiles with that of another run.
constexpr unsigned long long kDigest = 0x487de617fc966112ULL;

/// Index of every joint.
namespace joint {
constexpr int joint1 = 0;
constexpr int joint2 = 1;
constexpr int joint3 = 2;
constexpr int joint4 = 3;
constexpr int joint5 = 4;
constexpr int joint6 = 5;
}  // namespace joint

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
/// \param      q  6, rad|m
/// \param[out] A  36, kg m^2|kg m|kg
/// Equation (2). Cost: 64 mul, 52 add, 4 sin, 4 cos.
void mass_matrix(const Scalar q[6], Scalar A[36]) noexcept;

/// Coriolis and centrifugal joint forces B(q, qd), without gravity.
///
/// \param      q   6, rad|m
/// \param      qd  6, rad/s|m/s
/// \param[out] B   6, N m|N
/// Equation (3). Cost: 126 mul, 79 add, 4 sin, 4 cos.
void bias_force(const Scalar q[6], const Scalar qd[6], Scalar B[6]) noexcept;

/// Gravity term G(q) of A qdd + B + G = tau.
///
/// \param      q  6, rad|m
/// \param[out] G  6, N m|N
/// Equation 6.5. Cost: 12 mul, 7 add, 4 sin, 4 cos.
void gravity_force(const Scalar q[6], Scalar G[6]) noexcept;

/// Joint forces tau = A(q) qdd + B(q, qd) + G(q).
///
/// \param      q    6, rad|m
/// \param      qd   6, rad/s|m/s
/// \param      qdd  6, rad/s^2|m/s^2
/// \param[out] tau  6, N m|N
/// Equation (1). Cost: 147 mul, 113 add, 4 sin, 4 cos.
void inverse_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar qdd[6],
                      Scalar tau[6]) noexcept;

/// Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.
///
/// \param      q    6, rad|m
/// \param      qd   6, rad/s|m/s
/// \param      tau  6, N m|N
/// \param[out] qdd  6, rad/s^2|m/s^2
/// Results mean nothing where a divisor is zero, as where A is singular. Equation (1). Cost: 251
/// mul, 180 add, 4 div, 4 sin, 4 cos.
void forward_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar tau[6],
                      Scalar qdd[6]) noexcept;

}  // namespace puma560
