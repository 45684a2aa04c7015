// quadruped.hpp: dynamics of the model quadruped
//
// This file was generated from your model and belongs to you; wherever a licence is needed:
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate quadruped.yaml
//
//   joint                  link               index  type      unit
//   front_left_abduction   front_left_hip     0      revolute  rad
//   front_left_hip         front_left_thigh   1      revolute  rad
//   front_left_knee        front_left_shank   2      revolute  rad
//   front_right_abduction  front_right_hip    3      revolute  rad
//   front_right_hip        front_right_thigh  4      revolute  rad
//   front_right_knee       front_right_shank  5      revolute  rad
//   hind_left_abduction    hind_left_hip      6      revolute  rad
//   hind_left_hip          hind_left_thigh    7      revolute  rad
//   hind_left_knee         hind_left_shank    8      revolute  rad
//   hind_right_abduction   hind_right_hip     9      revolute  rad
//   hind_right_hip         hind_right_thigh   10     revolute  rad
//   hind_right_knee        hind_right_shank   11     revolute  rad
//
//   point             link               index  at (link frame, m)
//   front_left_foot   front_left_shank   0      0, 0, -0.175
//   front_right_foot  front_right_shank  1      0, 0, -0.175
//   hind_left_foot    hind_left_shank    2      0, 0, -0.175
//   hind_right_foot   hind_right_shank   3      0, 0, -0.175

#pragma once

namespace quadruped {

/// The only floating-point type in use.
using Scalar = double;
/// Length of q, qd, qdd and tau.
constexpr int kDof = 12;
/// Number of points.
constexpr int kPoints = 4;
/// Of header and source: neither compiles with that of another run.
constexpr unsigned long long kDigest = 0x749f8c7694de2f85ULL;

/// Index of every joint.
namespace joint {
constexpr int front_left_abduction = 0;
constexpr int front_left_hip = 1;
constexpr int front_left_knee = 2;
constexpr int front_right_abduction = 3;
constexpr int front_right_hip = 4;
constexpr int front_right_knee = 5;
constexpr int hind_left_abduction = 6;
constexpr int hind_left_hip = 7;
constexpr int hind_left_knee = 8;
constexpr int hind_right_abduction = 9;
constexpr int hind_right_hip = 10;
constexpr int hind_right_knee = 11;
}  // namespace joint

/// Index of every point.
namespace point {
constexpr int front_left_foot = 0;
constexpr int front_right_foot = 1;
constexpr int hind_left_foot = 2;
constexpr int hind_right_foot = 3;
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
/// Equation (2). Cost: 52 mul, 44 add, 8 sin, 8 cos.
void mass_matrix(const Scalar q[12], Scalar A[144]) noexcept;

/// Coriolis and centrifugal joint forces B(q, qd), without gravity.
///
/// \param      q   12, rad|m
/// \param      qd  12, rad/s|m/s
/// \param[out] B   12, N m|N
/// Equation (3). Cost: 100 mul, 56 add, 8 sin, 8 cos.
void bias_force(const Scalar q[12], const Scalar qd[12], Scalar B[12]) noexcept;

/// Gravity term G(q) of A qdd + B + G = tau.
///
/// \param      q  12, rad|m
/// \param[out] G  12, N m|N
/// Equation 6.5. Cost: 32 mul, 16 add, 12 sin, 12 cos.
void gravity_force(const Scalar q[12], Scalar G[12]) noexcept;

/// Joint forces tau = A(q) qdd + B(q, qd) + G(q).
///
/// \param      q    12, rad|m
/// \param      qd   12, rad/s|m/s
/// \param      qdd  12, rad/s^2|m/s^2
/// \param[out] tau  12, N m|N
/// Equation (1). Cost: 206 mul, 144 add, 12 sin, 12 cos.
void inverse_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar qdd[12],
                      Scalar tau[12]) noexcept;

/// Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.
///
/// \param      q    12, rad|m
/// \param      qd   12, rad/s|m/s
/// \param      tau  12, N m|N
/// \param[out] qdd  12, rad/s^2|m/s^2
/// Results mean nothing where a divisor is zero, as where A is singular. Equation (1). Cost: 228
/// mul, 157 add, 8 div, 12 sin, 12 cos.
void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept;

/// Positions of the points, base frame.
///
/// \param      q  12, rad|m
/// \param[out] p  12, m
/// Equation 1.2. Cost: 32 mul, 28 add, 12 sin, 12 cos.
void point_positions(const Scalar q[12], Scalar p[12]) noexcept;

/// C of the points, transposed Jacobian; N x 3P, row-major.
///
/// \param      q  12, rad|m
/// \param[out] C  144, m|1
/// Equation (9). Cost: 48 mul, 20 add, 12 sin, 12 cos.
void force_jacobian_transpose(const Scalar q[12], Scalar C[144]) noexcept;

}  // namespace quadruped
