// polar.hpp: dynamics of the model polar
//
// This file was generated from your model and belongs to you; wherever a licence is needed:
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate polar.yaml
//
//   joint     link           index  type       unit
//   shoulder  shoulder_link  0      revolute   rad
//   slide     boom           1      prismatic  m
//
//   point  link  index  at (link frame, m)
//   hand   boom  0      0, 0, 0

#pragma once

namespace polar {

/// The only floating-point type in use.
using Scalar = double;
/// Length of q, qd, qdd and tau.
constexpr int kDof = 2;
/// Number of points.
constexpr int kPoints = 1;
/// Of header and source: neither compiles with that of another run.
constexpr unsigned long long kDigest = 0x6b14b87dcd17fcbfULL;

/// Index of every joint.
namespace joint {
constexpr int shoulder = 0;
constexpr int slide = 1;
}  // namespace joint

/// Index of every point.
namespace point {
constexpr int hand = 0;
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
/// \param      q  2, rad|m
/// \param[out] A  4, kg m^2|kg m|kg
/// Equation (2). Cost: 2 mul, 2 add.
void mass_matrix(const Scalar q[2], Scalar A[4]) noexcept;

/// Coriolis and centrifugal joint forces B(q, qd), without gravity.
///
/// \param      q   2, rad|m
/// \param      qd  2, rad/s|m/s
/// \param[out] B   2, N m|N
/// Equation (3). Cost: 5 mul, 1 add.
void bias_force(const Scalar q[2], const Scalar qd[2], Scalar B[2]) noexcept;

/// Gravity term G(q) of A qdd + B + G = tau.
///
/// \param      q  2, rad|m
/// \param[out] G  2, N m|N
/// Equation 6.5. Cost: 3 mul, 1 add, 1 sin, 1 cos.
void gravity_force(const Scalar q[2], Scalar G[2]) noexcept;

/// Joint forces tau = A(q) qdd + B(q, qd) + G(q).
///
/// \param      q    2, rad|m
/// \param      qd   2, rad/s|m/s
/// \param      qdd  2, rad/s^2|m/s^2
/// \param[out] tau  2, N m|N
/// Equation (1). Cost: 11 mul, 7 add, 1 sin, 1 cos.
void inverse_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar qdd[2],
                      Scalar tau[2]) noexcept;

/// Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.
///
/// \param      q    2, rad|m
/// \param      qd   2, rad/s|m/s
/// \param      tau  2, N m|N
/// \param[out] qdd  2, rad/s^2|m/s^2
/// Results mean nothing where a divisor is zero, as where A is singular. Equation (1). Cost: 11
/// mul, 7 add, 1 div, 1 sin, 1 cos.
void forward_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar tau[2],
                      Scalar qdd[2]) noexcept;

/// Positions of the points, base frame.
///
/// \param      q  2, rad|m
/// \param[out] p  3, m
/// Equation 1.2. Cost: 2 mul, 1 sin, 1 cos.
void point_positions(const Scalar q[2], Scalar p[3]) noexcept;

/// C of the points, transposed Jacobian; N x 3P, row-major.
///
/// \param      q  2, rad|m
/// \param[out] C  6, m|1
/// Equation (9). Cost: 2 mul, 1 sin, 1 cos.
void force_jacobian_transpose(const Scalar q[2], Scalar C[6]) noexcept;

}  // namespace polar
