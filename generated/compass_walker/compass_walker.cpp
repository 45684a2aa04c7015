// compass_walker.cpp: see compass_walker.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate compass_walker.yaml

#include "compass_walker.hpp"

#include <cmath>

namespace compass_walker {

static_assert(kDigest == 0x58f76a10daa49219ULL, "header and source are of different runs");

using std::cos;
using std::sin;

void mass_matrix(const Scalar q[4], Scalar A[16]) noexcept {
  const Scalar c_left_hip = cos(q[2]);
  const Scalar s_left_hip = sin(q[2]);
  // right_leg
  const Scalar c_right_hip = cos(q[3]);
  const Scalar s_right_hip = sin(q[3]);
  A[3] = -2.5 * c_right_hip;
  A[12] = A[3];
  A[7] = 2.5 * s_right_hip;
  A[13] = A[7];
  // left_leg
  A[2] = -2.5 * c_left_hip;
  A[8] = A[2];
  A[6] = 2.5 * s_left_hip;
  A[9] = A[6];
  A[0] = 20.0;
  A[5] = 20.0;
  A[10] = 1.25;
  A[15] = 1.25;
  A[1] = 0.0;
  A[4] = 0.0;
  A[11] = 0.0;
  A[14] = 0.0;
}

void bias_force(const Scalar q[4], const Scalar qd[4], Scalar B[4]) noexcept {
  const Scalar c_left_hip = cos(q[2]);
  const Scalar s_left_hip = sin(q[2]);
  // right_leg
  const Scalar c_right_hip = cos(q[3]);
  const Scalar s_right_hip = sin(q[3]);
  const Scalar t_right_leg_1 = qd[3] * qd[3];
  const Scalar t_left_leg_1 = qd[2] * qd[2];
  // hip
  B[1] = 2.5 * (c_right_hip * t_right_leg_1 + c_left_hip * t_left_leg_1);
  B[0] = 2.5 * (s_right_hip * t_right_leg_1 + s_left_hip * t_left_leg_1);
  B[2] = 0.0;
  B[3] = 0.0;
}

void gravity_force(const Scalar q[4], Scalar G[4]) noexcept {
  const Scalar s_left_hip = sin(q[2]);
  const Scalar s_right_hip = sin(q[3]);
  G[2] = 24.525 * s_left_hip;
  // right_leg
  G[3] = 24.525 * s_right_hip;
  G[1] = 196.2;
  G[0] = 0.0;
}

void inverse_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar qdd[4],
                      Scalar tau[4]) noexcept {
  const Scalar a_hip_z = 9.81 + qdd[1];
  // left_leg
  const Scalar c_left_hip = cos(q[2]);
  const Scalar s_left_hip = sin(q[2]);
  const Scalar t_left_leg_1 = 2.5 * c_left_hip;
  const Scalar t_left_leg_2 = 2.5 * s_left_hip;
  tau[2] = 1.25 * qdd[2] - (qdd[0] * t_left_leg_1 - a_hip_z * t_left_leg_2);
  const Scalar t_left_leg_3 = qd[2] * qd[2];
  // right_leg
  const Scalar c_right_hip = cos(q[3]);
  const Scalar s_right_hip = sin(q[3]);
  const Scalar t_right_leg_1 = 2.5 * s_right_hip;
  const Scalar t_right_leg_2 = 2.5 * c_right_hip;
  tau[3] = a_hip_z * t_right_leg_1 - qdd[0] * t_right_leg_2 + 1.25 * qdd[3];
  const Scalar t_right_leg_3 = qd[3] * qd[3];
  // hip
  const Scalar t_hip_1 = 20.0 * qdd[0] - qdd[2] * t_left_leg_1 + t_left_leg_2 * t_left_leg_3;
  tau[0] = t_hip_1 - qdd[3] * t_right_leg_2 + t_right_leg_1 * t_right_leg_3;
  const Scalar t_hip_2 = 20.0 * a_hip_z + t_left_leg_1 * t_left_leg_3 + qdd[2] * t_left_leg_2;
  tau[1] = t_hip_2 + qdd[3] * t_right_leg_1 + t_right_leg_2 * t_right_leg_3;
}

void forward_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar tau[4],
                      Scalar qdd[4]) noexcept {
  const Scalar c_left_hip = cos(q[2]);
  const Scalar s_left_hip = sin(q[2]);
  const Scalar c_right_hip = cos(q[3]);
  const Scalar s_right_hip = sin(q[3]);
  const Scalar t_left_leg_1 = 5.0 * (c_right_hip * c_right_hip + c_left_hip * c_left_hip);
  const Scalar t_left_leg_2 = 10.0 + t_left_leg_1;
  const Scalar inverse_pivot_hip = 1.0 / t_left_leg_2;
  const Scalar t_left_leg_3 = 5.0 * (c_right_hip * s_right_hip + c_left_hip * s_left_hip);
  const Scalar t_hip_1 = inverse_pivot_hip * t_left_leg_3;
  const Scalar inverse_pivot_slide = 1.0 / (20.0 - t_left_leg_1 - t_left_leg_3 * t_hip_1);
  const Scalar t_right_leg_1 = qd[3] * qd[3];
  const Scalar t_left_leg_4 = qd[2] * qd[2];
  const Scalar t_hip_2 = 2.5 * (c_right_hip * t_right_leg_1 + c_left_hip * t_left_leg_4);
  const Scalar u_hip = tau[1] - t_hip_2 - 2.0 * (s_right_hip * tau[3] + s_left_hip * tau[2]);
  // slide
  const Scalar t_slide_1 = 2.5 * (s_right_hip * t_right_leg_1 + s_left_hip * t_left_leg_4);
  const Scalar t_slide_2 = 2.0 * (c_right_hip * tau[3] + c_left_hip * tau[2]);
  const Scalar u_slide = tau[0] - t_slide_1 - t_hip_1 * u_hip + t_slide_2;
  const Scalar t_slide_3 = inverse_pivot_slide * u_slide;
  qdd[0] = t_slide_3;
  const Scalar t_hip_3 = u_hip - t_left_leg_3 * t_slide_3 - 9.81 * t_left_leg_2;
  const Scalar t_hip_4 = inverse_pivot_hip * t_hip_3;
  qdd[1] = t_hip_4;
  // left_leg
  const Scalar t_left_leg_5 = 2.0 * t_slide_3;
  const Scalar t_left_leg_6 = 19.62 + 2.0 * t_hip_4;
  qdd[2] = 0.8 * tau[2] + c_left_hip * t_left_leg_5 - s_left_hip * t_left_leg_6;
  // right_leg
  qdd[3] = 0.8 * tau[3] + c_right_hip * t_left_leg_5 - s_right_hip * t_left_leg_6;
}

void point_positions(const Scalar q[4], Scalar p[6]) noexcept {
  const Scalar c_left_hip = cos(q[2]);
  const Scalar s_left_hip = sin(q[2]);
  const Scalar c_right_hip = cos(q[3]);
  const Scalar s_right_hip = sin(q[3]);
  // slide
  p[2] = q[1] - c_left_hip;
  p[0] = q[0] - s_left_hip;
  p[5] = q[1] - c_right_hip;
  p[3] = q[0] - s_right_hip;
  p[1] = 0.0;
  p[4] = 0.0;
}

void force_jacobian_transpose(const Scalar q[4], Scalar C[24]) noexcept {
  C[12] = -cos(q[2]);
  C[14] = sin(q[2]);
  // right_leg
  C[21] = -cos(q[3]);
  C[23] = sin(q[3]);
  C[0] = 1.0;
  C[3] = 1.0;
  C[8] = 1.0;
  C[11] = 1.0;
  C[1] = 0.0;
  C[2] = 0.0;
  C[4] = 0.0;
  C[5] = 0.0;
  C[6] = 0.0;
  C[7] = 0.0;
  C[9] = 0.0;
  C[10] = 0.0;
  C[13] = 0.0;
  C[15] = 0.0;
  C[16] = 0.0;
  C[17] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
  C[22] = 0.0;
}

}  // namespace compass_walker
