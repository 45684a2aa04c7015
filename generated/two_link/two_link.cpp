// two_link.cpp: see two_link.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate two_link.yaml

#include "two_link.hpp"

#include <cmath>

namespace two_link {

static_assert(kDigest == 0xedf71ab4dab2da34ULL, "header and source are of different runs");

using std::cos;
using std::sin;

void mass_matrix(const Scalar q[2], Scalar A[4]) noexcept {
  const Scalar c_elbow = cos(q[1]);
  A[1] = 22.5 + 25.0 * c_elbow;
  A[2] = A[1];
  // upper_arm
  A[0] = 95.0 + 50.0 * c_elbow;
  A[3] = 22.5;
}

void bias_force(const Scalar q[2], const Scalar qd[2], Scalar B[2]) noexcept {
  // forearm
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar s_elbow = sin(q[1]);
  const Scalar t_forearm_1 = 25.0 * s_elbow;
  const Scalar M_forearm_z = qd[0] * qd[0] * t_forearm_1;
  B[1] = M_forearm_z;
  // upper_arm
  B[0] = M_forearm_z - omega_forearm_z * omega_forearm_z * t_forearm_1;
}

void gravity_force(const Scalar q[2], Scalar G[2]) noexcept {
  // forearm
  const Scalar t_forearm_1 = q[0] + q[1];
  const Scalar c_forearm = cos(t_forearm_1);
  const Scalar c_shoulder = cos(q[0]);
  const Scalar M_forearm_z = 245.25 * c_forearm;
  G[1] = M_forearm_z;
  // upper_arm
  G[0] = M_forearm_z + 735.75 * c_shoulder;
}

void inverse_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar qdd[2],
                      Scalar tau[2]) noexcept {
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  // forearm
  const Scalar c_elbow = cos(q[1]);
  const Scalar s_elbow = sin(q[1]);
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar alpha_forearm_z = qdd[0] + qdd[1];
  const Scalar t_forearm_1 = s_elbow * (9.81 * s_shoulder - qd[0] * qd[0]);
  const Scalar a_forearm_y = c_elbow * (qdd[0] + 9.81 * c_shoulder) - t_forearm_1;
  const Scalar M_forearm_z = 22.5 * alpha_forearm_z + 25.0 * a_forearm_y;
  tau[1] = M_forearm_z;
  const Scalar t_forearm_2 = s_elbow * omega_forearm_z * omega_forearm_z;
  // upper_arm
  const Scalar t_upper_arm_1 = M_forearm_z + 735.75 * c_shoulder + 72.5 * qdd[0];
  tau[0] = t_upper_arm_1 + 25.0 * (c_elbow * alpha_forearm_z - t_forearm_2);
}

void forward_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar tau[2],
                      Scalar qdd[2]) noexcept {
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  // forearm
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar s_elbow = sin(q[1]);
  const Scalar c_elbow = cos(q[1]);
  const Scalar t_forearm_1 = c_elbow * c_elbow * 27.77777777777778;
  const Scalar inverse_pivot_upper_arm = 1.0 / (72.5 - t_forearm_1);
  const Scalar t_upper_arm_1 = 9.81 * c_shoulder;
  const Scalar t_forearm_2 = 25.0 * s_elbow;
  const Scalar t_forearm_3 = 1.1111111111111112 * c_elbow;
  const Scalar t_upper_arm_2 = tau[1] - t_forearm_2 * (qd[0] * qd[0] - 9.81 * s_shoulder);
  const Scalar t_upper_arm_3 = tau[1] - tau[0] + (75.0 - t_forearm_1) * t_upper_arm_1;
  const Scalar t_forearm_4 = omega_forearm_z * omega_forearm_z * t_forearm_2;
  const Scalar t_upper_arm_4 = t_upper_arm_3 + t_forearm_3 * t_upper_arm_2 - t_forearm_4;
  const Scalar t_upper_arm_5 = inverse_pivot_upper_arm * t_upper_arm_4;
  qdd[0] = -t_upper_arm_5;
  const Scalar t_forearm_5 = t_upper_arm_5 + 0.044444444444444446 * t_upper_arm_2;
  qdd[1] = t_forearm_5 - t_forearm_3 * (t_upper_arm_1 - t_upper_arm_5);
}

void point_positions(const Scalar q[2], Scalar p[3]) noexcept {
  // forearm
  const Scalar t_forearm_1 = q[0] + q[1];
  const Scalar c_forearm = cos(t_forearm_1);
  const Scalar s_forearm = sin(t_forearm_1);
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  // upper_arm
  p[0] = c_forearm + c_shoulder;
  p[2] = s_forearm + s_shoulder;
  p[1] = 0.0;
}

void force_jacobian_transpose(const Scalar q[2], Scalar C[6]) noexcept {
  // forearm
  const Scalar c_shoulder = cos(q[0]);
  const Scalar s_shoulder = sin(q[0]);
  const Scalar t_forearm_1 = q[0] + q[1];
  const Scalar c_forearm = cos(t_forearm_1);
  C[5] = c_forearm;
  const Scalar s_forearm = sin(t_forearm_1);
  C[3] = -s_forearm;
  C[2] = c_shoulder + c_forearm;
  C[0] = -(s_shoulder + s_forearm);
  C[1] = 0.0;
  C[4] = 0.0;
}

}  // namespace two_link
