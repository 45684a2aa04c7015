// polar.cpp: see polar.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate polar.yaml

#include "polar.hpp"

#include <cmath>

namespace polar {

static_assert(kDigest == 0xad88fe10cc61b0ebULL, "header and source are of different runs");

using std::cos;
using std::sin;

void mass_matrix(const Scalar q[2], Scalar A[4]) noexcept {
  // shoulder_link
  A[0] = 2.528 - q[1] * (5.47995 - 4.25 * q[1]);
  A[3] = 4.25;
  A[1] = 0.0;
  A[2] = 0.0;
}

void bias_force(const Scalar q[2], const Scalar qd[2], Scalar B[2]) noexcept {
  const Scalar t_boom_1 = qd[0] * (5.47995 - 8.5 * q[1]);
  B[1] = qd[0] * t_boom_1 * 0.5;
  // shoulder_link
  B[0] = -qd[1] * t_boom_1;
}

void gravity_force(const Scalar q[2], Scalar G[2]) noexcept {
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  G[1] = 41.6925 * c_shoulder;
  // shoulder_link
  G[0] = s_shoulder * (26.87915475 - 41.6925 * q[1]);
}

void inverse_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar qdd[2],
                      Scalar tau[2]) noexcept {
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  // boom
  const Scalar t_boom_1 = 4.25 * q[1];
  const Scalar t_boom_2 = 2.739975 - t_boom_1;
  tau[1] = 41.6925 * c_shoulder + 4.25 * qdd[1] + qd[0] * qd[0] * t_boom_2;
  // shoulder_link
  const Scalar t_shoulder_1 = t_boom_2 * (9.81 * s_shoulder - qd[0] * qd[1] * 2.0);
  tau[0] = qdd[0] * (2.528 - q[1] * (5.47995 - t_boom_1)) + t_shoulder_1;
}

void forward_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar tau[2],
                      Scalar qdd[2]) noexcept {
  // shoulder_link
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  const Scalar inverse_pivot_shoulder = 1.0 / (2.528 - q[1] * (5.47995 - 4.25 * q[1]));
  const Scalar t_boom_1 = 0.6447 - q[1];
  const Scalar t_boom_2 = qd[0] * t_boom_1;
  const Scalar t_shoulder_1 = tau[0] - s_shoulder * t_boom_1 * 41.6925 + qd[1] * t_boom_2 * 8.5;
  qdd[0] = inverse_pivot_shoulder * t_shoulder_1;
  // boom
  qdd[1] = -(9.81 * c_shoulder - 0.23529411764705882 * tau[1] + qd[0] * t_boom_2);
}

void point_positions(const Scalar q[2], Scalar p[3]) noexcept {
  // shoulder_link
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  p[0] = s_shoulder * q[1];
  p[2] = c_shoulder * q[1];
  p[1] = 0.154;
}

void force_jacobian_transpose(const Scalar q[2], Scalar C[6]) noexcept {
  const Scalar c_shoulder = cos(q[0]);
  C[5] = c_shoulder;
  const Scalar s_shoulder = sin(q[0]);
  C[3] = s_shoulder;
  // shoulder_link
  C[2] = -s_shoulder * q[1];
  C[0] = c_shoulder * q[1];
  C[1] = 0.0;
  C[4] = 0.0;
}

}  // namespace polar
