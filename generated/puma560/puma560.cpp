// puma560.cpp: see puma560.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate puma560.yaml --effort 1000

#include "puma560.hpp"

#include <cmath>

namespace puma560 {

using std::cos;
using std::sin;

void mass_matrix(const Scalar q[6], Scalar A[36]) noexcept {
  // link3
  const Scalar t_link3_1 = q[1] + q[2];
  const Scalar s_link3 = sin(t_link3_1);
  const Scalar c_link3 = cos(t_link3_1);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar h_link4_z = 5.8464e-05 * c_joint5;
  const Scalar h_link3_y = 0.0174944385 + h_link4_z;
  // link4
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar h_link4_x = 5.8464e-05 * s_joint5;
  const Scalar t_link4_1 = c_joint4 * h_link4_x;
  // link3
  const Scalar h_link3_x = 0.0005151125 - t_link4_1;
  const Scalar c_joint2 = cos(q[1]);
  const Scalar s_joint2 = sin(q[1]);
  const Scalar s_link3_x = 21.27093596059113 * c_joint2;
  const Scalar t_link3_2 = s_link3_x * (s_link3 * h_link3_y - c_link3 * h_link3_x);
  const Scalar t_link3_3 = 2.0 * t_link3_2;
  const Scalar t_link5_1 = 0.00020216 * s_joint5;
  const Scalar t_link5_2 = s_joint5 * t_link5_1;
  const Scalar I_link4_zz = 0.00164 + t_link5_2;
  A[21] = I_link4_zz;
  const Scalar t_link4_2 = 2.0 * t_link4_1;
  const Scalar I_link3_yy = I_link4_zz - t_link4_2;
  const Scalar t_link6_1 = s_joint2 * (0.0141984 * c_joint2 + 1.601861202 * s_joint2);
  const Scalar t_link5_3 = 0.002494656 * c_joint5;
  // link4
  const Scalar I_link4_xx = 0.00054216 - t_link5_2 + t_link5_3;
  const Scalar I_link4_yy = 0.00064216 + t_link5_3;
  const Scalar t_link4_3 = s_joint4 * (I_link4_xx - I_link4_yy);
  const Scalar t_link4_4 = s_joint4 * t_link4_3;
  const Scalar I_link3_xx = t_link4_4 - (0.299575024 + I_link4_xx);
  const Scalar I_link4_xz = c_joint5 * t_link5_1 + 0.001247328 * s_joint5;
  const Scalar t_link4_5 = c_joint4 * I_link4_xz;
  const Scalar I_link3_xy = t_link4_5 - (0.0106736385 + h_link4_z);
  const Scalar t_link3_4 = c_link3 * I_link3_xy * 2.0 - s_link3 * (I_link3_yy + I_link3_xx);
  const Scalar t_link1_1 = 3.153482265 + I_link3_yy + t_link3_3 - t_link6_1;
  const Scalar h_link3_z = s_joint4 * h_link4_x;
  A[0] = t_link1_1 + s_link3 * t_link3_4 + 14.788177339901479 * h_link3_z;
  const Scalar I_link3_xz = h_link3_z + c_joint4 * t_link4_3;
  const Scalar t_link4_6 = s_joint4 * I_link4_xz;
  A[15] = -t_link4_6;
  A[20] = A[15];
  // link3
  const Scalar I_link3_yz = 0.004704 + t_link4_6;
  const Scalar t_link3_5 = c_link3 * h_link3_y + s_link3 * h_link3_x;
  const Scalar t_link3_6 = c_link3 * I_link3_yz + s_link3 * I_link3_xz;
  const Scalar t_link3_7 = t_link3_6 + 7.394088669950739 * t_link3_5;
  A[2] = -t_link3_7;
  A[12] = A[2];
  const Scalar s_link3_y = 21.27093596059113 * s_joint2;
  A[1] = s_link3_y * h_link3_z - (t_link3_7 - 0.023751 * c_joint2 - 0.690314699 * s_joint2);
  A[6] = A[1];
  const Scalar t_link3_8 = c_link3 * h_link3_z;
  const Scalar t_link3_9 = s_link3_x * t_link4_1 + 7.394088669950739 * t_link3_8;
  A[3] = t_link3_9 + c_link3 * (I_link4_zz - t_link4_1) + s_link3 * t_link4_5;
  A[18] = A[3];
  const Scalar t_link4_7 = c_joint4 * h_link4_z;
  const Scalar t_link3_10 = s_link3 * h_link4_x - c_link3 * t_link4_7;
  const Scalar t_link5_4 = 0.00064216 + 0.001247328 * c_joint5;
  const Scalar t_link3_11 = s_joint4 * (s_link3 * t_link5_4 + h_link4_z * (s_link3_x - c_link3));
  A[4] = 7.394088669950739 * t_link3_10 + t_link3_11;
  A[24] = A[4];
  const Scalar t_link5_5 = 4e-05 * c_joint5;
  A[23] = t_link5_5;
  A[33] = A[23];
  const Scalar t_link5_6 = 4e-05 * s_joint5;
  A[5] = c_link3 * t_link5_5 - s_link3 * c_joint4 * t_link5_6;
  A[30] = A[5];
  const Scalar I_link3_zz = t_link4_2 - (t_link5_3 + 0.313747409 + t_link4_4);
  A[14] = -I_link3_zz;
  const Scalar t_link3_12 = s_link3_y * t_link3_5;
  A[7] = 1.748114002 - I_link3_zz + t_link3_3 - 2.0 * t_link3_12;
  A[8] = -(I_link3_zz - t_link3_2 + t_link3_12);
  A[13] = A[8];
  A[9] = -(t_link4_6 - s_link3_y * t_link3_8 + s_link3_x * s_link3 * h_link3_z);
  A[19] = A[9];
  const Scalar t_link4_8 = h_link4_x - c_joint4 * t_link5_4;
  A[16] = -t_link4_8;
  A[26] = A[16];
  const Scalar t_link3_13 = s_link3_x * (c_link3 * h_link4_x + s_link3 * t_link4_7);
  A[10] = t_link3_13 - (t_link4_8 - s_link3_y * t_link3_10);
  A[25] = A[10];
  // link4
  A[11] = s_joint4 * t_link5_6;
  A[17] = A[11];
  A[31] = A[11];
  A[32] = A[11];
  A[28] = 0.00064216;
  A[35] = 4e-05;
  A[22] = 0.0;
  A[27] = 0.0;
  A[29] = 0.0;
  A[34] = 0.0;
}

void bias_force(const Scalar q[6], const Scalar qd[6], Scalar B[6]) noexcept {
  // link3
  const Scalar c_joint2 = cos(q[1]);
  const Scalar s_joint2 = sin(q[1]);
  const Scalar s_link3_x = 0.9969983837450935 * c_joint2;
  const Scalar s_link3_y = 0.9969983837450935 * s_joint2;
  const Scalar t_link3_1 = q[1] + q[2];
  const Scalar c_link3 = cos(t_link3_1);
  const Scalar s_link3 = sin(t_link3_1);
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar Omega_link1_xx = qd[0] * qd[0];
  // link2
  const Scalar Omega_link2_yy = qd[1] * qd[1];
  const Scalar Omega_link2_xx = Omega_link1_xx + Omega_link2_yy;
  const Scalar t_link2_1 = 0.0070992 - c_joint2 * (0.0141984 * c_joint2 + 1.368797152 * s_joint2);
  const Scalar t_link2_2 = 0.023751 * s_joint2 - 0.609298224 * c_joint2;
  const Scalar alpha_link2_x = qd[0] * qd[1];
  const Scalar Omega_link2_zy = 2.0 * alpha_link2_x;
  // link3
  const Scalar t_link3_2 = s_link3_x * Omega_link2_xx;
  const Scalar t_link3_3 = s_link3_y * Omega_link2_yy;
  const Scalar a_link3_z = 0.3465712306626645 * Omega_link1_xx + s_link3_y * Omega_link2_zy;
  const Scalar a_link3_x = s_link3 * t_link3_3 + c_link3 * t_link3_2;
  const Scalar omega_link3_x = s_link3 * qd[0];
  const Scalar omega_link3_y = c_link3 * qd[0];
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar Omega_link3_xy = omega_link3_x * omega_link3_y;
  const Scalar alpha_link3_y = omega_link3_x * omega_link3_z;
  const Scalar alpha_link3_x = omega_link3_y * omega_link3_z;
  const Scalar t_link3_4 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_5 = omega_link3_x * omega_link3_x;
  const Scalar Omega_link3_xx = t_link3_5 - (Omega_link1_xx + t_link3_4);
  const Scalar Omega_link3_yy = t_link3_4 + t_link3_5;
  const Scalar t_link3_6 = Omega_link1_xx - Omega_link3_yy;
  const Scalar t_link3_7 = Omega_link3_xx + Omega_link3_yy;
  const Scalar t_link4_1 = a_link3_x + 0.04687139228815516 * Omega_link3_xx;
  const Scalar a_link3_y = c_link3 * t_link3_3 - s_link3 * t_link3_2;
  // link4
  const Scalar a_link4_z = a_link3_y + 0.04687139228815516 * Omega_link3_xy;
  const Scalar t_link4_2 = a_link3_z - 0.09374278457631031 * alpha_link3_y;
  const Scalar a_link4_x = s_joint4 * t_link4_2 + c_joint4 * t_link4_1;
  const Scalar a_link4_y = c_joint4 * t_link4_2 - s_joint4 * t_link4_1;
  const Scalar omega_link4_x = s_joint4 * omega_link3_z - c_joint4 * omega_link3_x;
  const Scalar omega_link4_y = c_joint4 * omega_link3_z + s_joint4 * omega_link3_x;
  const Scalar omega_link4_z = omega_link3_y + qd[3];
  const Scalar Omega_link3_zy = 2.0 * alpha_link3_x;
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy - c_joint4 * Omega_link3_xy;
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy + s_joint4 * Omega_link3_xy;
  const Scalar t_link4_3 = omega_link4_x * omega_link4_y;
  const Scalar t_link4_4 = omega_link4_x * omega_link4_z;
  const Scalar alpha_link4_y = Omega_link4_xz - t_link4_4;
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_3;
  const Scalar Omega_link4_yx = alpha_link3_y - t_link4_3;
  const Scalar Omega_link4_zx = t_link4_4 - alpha_link4_y;
  const Scalar Omega_link4_zy = Omega_link4_yz - omega_link4_y * omega_link4_z * 2.0;
  // link5
  const Scalar a_link5_z = a_link4_y - Omega_link4_yz;
  const Scalar t_link5_1 = s_joint5 * (Omega_link3_yy - a_link4_z);
  const Scalar a_link5_x = t_link5_1 - c_joint5 * (a_link4_x - Omega_link4_xz);
  const Scalar omega_link5_x = s_joint5 * omega_link4_z - c_joint5 * omega_link4_x;
  const Scalar omega_link5_y = c_joint5 * omega_link4_z + s_joint5 * omega_link4_x;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar t_link5_2 = omega_link5_x * omega_link5_y;
  const Scalar t_link5_3 = omega_link5_x * omega_link5_z;
  const Scalar alpha_link5_y = t_link5_3 + s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar Omega_link5_xy = alpha_link4_y - t_link5_2;
  const Scalar Omega_link5_yy = omega_link5_z * omega_link5_z + omega_link5_x * omega_link5_x;
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar Omega_link5_zy = Omega_link5_yz + omega_link5_y * omega_link5_z * 2.0;
  const Scalar F_link5_x = 0.001247328 * Omega_link5_xy;
  const Scalar F_link5_y = 0.001247328 * Omega_link5_yy;
  const Scalar F_link5_z = 0.001247328 * Omega_link5_zy;
  // link6
  const Scalar omega_link6_z = omega_link5_y + qd[5];
  const Scalar t_link6_1 = 4e-05 * omega_link6_z;
  const Scalar M_link6_z = 4e-05 * alpha_link5_y;
  B[5] = -M_link6_z;
  // link5
  const Scalar t_link5_4 = 0.001247328 * a_link5_z + omega_link5_z * t_link6_1;
  const Scalar M_link5_x = t_link5_4 - 0.00044216 * Omega_link5_zy;
  const Scalar M_link5_y = M_link6_z + 0.0002 * (t_link5_3 + alpha_link5_y);
  const Scalar t_link5_5 = 0.00064216 * alpha_link4_y - 0.00024216 * t_link5_2;
  const Scalar M_link5_z = t_link5_5 + 0.001247328 * a_link5_x + omega_link5_x * t_link6_1;
  B[4] = M_link5_z;
  const Scalar t_link5_6 = s_joint5 * F_link5_y - c_joint5 * F_link5_x;
  // link4
  const Scalar F_link4_x = t_link5_6 + 0.2344695125 * a_link4_x;
  const Scalar F_link4_y = F_link5_z - 0.2344695125 * a_link4_y;
  const Scalar F_link4_z = 0.2344695125 * a_link4_z - c_joint5 * F_link5_y - s_joint5 * F_link5_x;
  const Scalar t_link4_5 = F_link5_z + 0.00075 * Omega_link4_zy + s_joint5 * M_link5_y;
  const Scalar M_link4_x = t_link4_5 - c_joint5 * M_link5_x;
  const Scalar M_link4_y = M_link5_z - t_link5_6 - 0.00065 * Omega_link4_zx;
  const Scalar t_link4_6 = 0.00065 * Omega_link4_yx + 0.00075 * Omega_link4_xy;
  const Scalar M_link4_z = t_link4_6 + c_joint5 * M_link5_y + s_joint5 * M_link5_x;
  B[3] = -M_link4_z;
  const Scalar t_link4_7 = c_joint4 * F_link4_y - s_joint4 * F_link4_x;
  // link3
  const Scalar t_link3_8 = 0.3732434145 * Omega_link3_xy + s_joint4 * F_link4_y;
  const Scalar F_link3_x = t_link3_8 + c_joint4 * F_link4_x;
  const Scalar F_link3_y = F_link4_z - 0.3732434145 * Omega_link3_yy;
  const Scalar F_link3_z = t_link4_7 + 0.746486829 * alpha_link3_x;
  const Scalar t_link3_9 = 0.611380273 * alpha_link3_x + 0.021347277 * alpha_link3_y;
  const Scalar t_link3_10 = t_link3_9 - 0.004704 * t_link3_6 - 0.3732434145 * a_link3_z;
  const Scalar M_link3_x = t_link3_10 + s_joint4 * M_link4_y + c_joint4 * M_link4_x;
  const Scalar t_link3_11 = M_link4_z - 0.004704 * Omega_link3_xy + 0.021347277 * alpha_link3_x;
  const Scalar M_link3_y = t_link3_11 + 0.0125 * alpha_link3_y + 0.04687139228815516 * t_link4_7;
  const Scalar t_link3_12 = 0.0106736385 * t_link3_7 + 0.3732434145 * a_link3_x;
  const Scalar t_link3_13 = t_link3_12 - 0.04687139228815516 * F_link4_z - c_joint4 * M_link4_y;
  const Scalar M_link3_z = t_link3_13 + s_joint4 * M_link4_x + 0.2994401365 * Omega_link3_xy;
  B[2] = -M_link3_z;
  const Scalar t_link3_14 = s_link3 * F_link3_y - c_link3 * F_link3_x;
  // link2
  const Scalar t_link2_3 = t_link2_1 * Omega_link2_zy - Omega_link2_yy * t_link2_2;
  const Scalar t_link2_4 = t_link2_3 + s_link3_x * F_link3_z - 0.3465712306626645 * t_link3_14;
  B[0] = t_link2_4 - c_link3 * M_link3_y + s_link3 * M_link3_x;
  const Scalar t_link2_5 = M_link3_z + Omega_link1_xx * t_link2_1 + s_link3_y * t_link3_14;
  B[1] = -(t_link2_5 + s_link3_x * (c_link3 * F_link3_y + s_link3 * F_link3_x));
}

void gravity_force(const Scalar q[6], Scalar G[6]) noexcept {
  // link4
  const Scalar t_link4_1 = q[1] + q[2];
  const Scalar c_link4 = cos(t_link4_1);
  const Scalar s_link4 = sin(t_link4_1);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar t_link4_2 = 9.81 * s_link4;
  const Scalar a_link5_x = c_link4 * s_joint5 * 9.81 + c_joint4 * c_joint5 * t_link4_2;
  const Scalar M_link5_z = 0.00288 * a_link5_x;
  G[4] = -M_link5_z;
  const Scalar a_link4_y = s_joint4 * t_link4_2;
  const Scalar M_link5_x = 0.00288 * a_link4_y;
  const Scalar M_link4_x = c_joint5 * M_link5_x;
  const Scalar M_link4_z = s_joint5 * M_link5_x;
  G[3] = M_link4_z;
  G[0] = c_link4 * M_link4_z - s_link4 * (s_joint4 * M_link5_z - c_joint4 * M_link4_x);
  // link3
  const Scalar t_link3_1 = 9.81 * (0.861795 * s_link4 - 0.025375 * c_link4) + c_joint4 * M_link5_z;
  const Scalar M_link3_z = t_link3_1 + s_joint4 * M_link4_x;
  G[2] = -M_link3_z;
  const Scalar s_joint2 = sin(q[1]);
  const Scalar c_joint2 = cos(q[1]);
  // link2
  G[1] = -(M_link3_z - 1.024164 * s_joint2 + 37.2347379 * c_joint2);
  G[5] = 0.0;
}

void inverse_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar qdd[6],
                      Scalar tau[6]) noexcept {
  // link3
  const Scalar c_joint2 = cos(q[1]);
  const Scalar s_joint2 = sin(q[1]);
  const Scalar s_link3_x = 21.27093596059113 * c_joint2;
  const Scalar s_link3_y = 21.27093596059113 * s_joint2;
  const Scalar t_link3_1 = q[1] + q[2];
  const Scalar c_link3 = cos(t_link3_1);
  const Scalar s_link3 = sin(t_link3_1);
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar Omega_link1_xx = qd[0] * qd[0];
  // link2
  const Scalar Omega_link2_yy = qd[1] * qd[1];
  const Scalar Omega_link2_xx = Omega_link1_xx + Omega_link2_yy;
  const Scalar t_link2_1 = 0.00211932 * s_joint2 - 0.066093552 * c_joint2;
  const Scalar t_link2_2 = 0.0141984 * c_joint2 + 1.368797152 * s_joint2;
  const Scalar t_link2_3 = s_joint2 * t_link2_2;
  const Scalar t_link2_4 = 0.0070992 - c_joint2 * t_link2_2;
  const Scalar t_link2_5 = 0.023751 * s_joint2 - 0.609298224 * c_joint2;
  const Scalar t_link2_6 = 0.023751 * c_joint2 + 0.609298224 * s_joint2;
  const Scalar t_link2_7 = 1.441923552 - t_link2_3 + (0.0731264 + t_link2_3);
  const Scalar alpha_link2_x = qd[0] * qd[1];
  const Scalar Omega_link2_zy = 2.0 * alpha_link2_x;
  // link3
  const Scalar t_link3_2 = 7.394088669950739 * qdd[0] + s_link3_y * qdd[1];
  const Scalar t_link3_3 = t_link3_2 + s_link3_x * Omega_link2_xx;
  const Scalar t_link3_4 = 7.394088669950739 * Omega_link1_xx + s_link3_y * Omega_link2_zy;
  const Scalar a_link3_z = t_link3_4 - s_link3_x * qdd[0];
  const Scalar t_link3_5 = 483.2512315270936 + s_link3_y * Omega_link2_yy - s_link3_x * qdd[1];
  const Scalar a_link3_x = s_link3 * t_link3_5 + c_link3 * t_link3_3;
  const Scalar omega_link3_x = s_link3 * qd[0];
  const Scalar omega_link3_y = c_link3 * qd[0];
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar Omega_link3_xz = c_link3 * qdd[0];
  const Scalar alpha_link3_z = qdd[1] + qdd[2];
  const Scalar t_link3_6 = omega_link3_x * omega_link3_y;
  const Scalar t_link3_7 = omega_link3_x * omega_link3_z;
  const Scalar t_link3_8 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_9 = omega_link3_x * omega_link3_x;
  const Scalar Omega_link3_xx = t_link3_9 - (Omega_link1_xx + t_link3_8);
  const Scalar alpha_link3_y = Omega_link3_xz - t_link3_7;
  const Scalar Omega_link3_xy = alpha_link3_z - t_link3_6;
  const Scalar Omega_link3_yx = alpha_link3_z + t_link3_6;
  const Scalar Omega_link3_yy = t_link3_8 + t_link3_9;
  const Scalar Omega_link3_zx = t_link3_7 - alpha_link3_y;
  const Scalar Omega_link3_zy = s_link3 * qdd[0] + omega_link3_y * omega_link3_z * 2.0;
  const Scalar t_link3_10 = Omega_link1_xx - Omega_link3_yy;
  const Scalar t_link3_11 = Omega_link3_xx + Omega_link3_yy;
  // link4
  const Scalar t_link4_1 = a_link3_x + Omega_link3_xx;
  const Scalar a_link4_z = Omega_link3_yx + c_link3 * t_link3_5 - s_link3 * t_link3_3;
  const Scalar t_link4_2 = a_link3_z - Omega_link3_zx;
  const Scalar a_link4_x = s_joint4 * t_link4_2 + c_joint4 * t_link4_1;
  const Scalar a_link4_y = c_joint4 * t_link4_2 - s_joint4 * t_link4_1;
  const Scalar omega_link4_x = s_joint4 * omega_link3_z - c_joint4 * omega_link3_x;
  const Scalar omega_link4_y = c_joint4 * omega_link3_z + s_joint4 * omega_link3_x;
  const Scalar omega_link4_z = omega_link3_y + qd[3];
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy + c_joint4 * Omega_link3_xy;
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy - s_joint4 * Omega_link3_xy;
  const Scalar alpha_link4_z = alpha_link3_y + qdd[3];
  const Scalar t_link4_3 = omega_link4_x * omega_link4_y;
  const Scalar t_link4_4 = omega_link4_x * omega_link4_z;
  const Scalar alpha_link4_y = Omega_link4_xz - t_link4_4;
  const Scalar Omega_link4_xy = alpha_link4_z - t_link4_3;
  const Scalar Omega_link4_yx = alpha_link4_z + t_link4_3;
  const Scalar Omega_link4_zx = t_link4_4 - alpha_link4_y;
  const Scalar Omega_link4_zy = Omega_link4_yz - omega_link4_y * omega_link4_z * 2.0;
  // link5
  const Scalar a_link5_z = a_link4_y - 21.334975369458128 * Omega_link4_yz;
  const Scalar t_link5_1 = s_joint5 * (a_link4_z - 21.334975369458128 * Omega_link3_yy);
  const Scalar t_link5_2 = c_joint5 * (a_link4_x - 21.334975369458128 * Omega_link4_xz);
  const Scalar a_link5_x = t_link5_1 + t_link5_2;
  const Scalar omega_link5_x = s_joint5 * omega_link4_z - c_joint5 * omega_link4_x;
  const Scalar omega_link5_y = c_joint5 * omega_link4_z + s_joint5 * omega_link4_x;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar alpha_link5_z = alpha_link4_y + qdd[4];
  const Scalar t_link5_3 = omega_link5_x * omega_link5_y;
  const Scalar t_link5_4 = omega_link5_x * omega_link5_z;
  const Scalar alpha_link5_y = t_link5_4 + s_joint5 * Omega_link4_zy - c_joint5 * Omega_link4_xy;
  const Scalar Omega_link5_xy = alpha_link5_z - t_link5_3;
  const Scalar Omega_link5_yy = omega_link5_z * omega_link5_z + omega_link5_x * omega_link5_x;
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy + s_joint5 * Omega_link4_xy;
  const Scalar Omega_link5_zy = Omega_link5_yz + omega_link5_y * omega_link5_z * 2.0;
  const Scalar F_link5_x = 5.8464e-05 * Omega_link5_xy;
  const Scalar F_link5_y = 5.8464e-05 * Omega_link5_yy;
  // link6
  const Scalar omega_link6_z = omega_link5_y + qd[5];
  const Scalar alpha_link6_z = alpha_link5_y - qdd[5];
  const Scalar t_link6_1 = 4e-05 * omega_link6_z;
  const Scalar M_link6_z = 4e-05 * alpha_link6_z;
  tau[5] = -M_link6_z;
  // link5
  const Scalar t_link5_5 = 5.8464e-05 * a_link5_z + omega_link5_z * t_link6_1;
  const Scalar M_link5_x = t_link5_5 - 0.00044216 * Omega_link5_zy;
  const Scalar M_link5_y = M_link6_z + 0.0002 * (t_link5_4 + alpha_link5_y);
  const Scalar t_link5_6 = 0.00064216 * alpha_link5_z - 0.00024216 * t_link5_3;
  const Scalar M_link5_z = t_link5_6 - 5.8464e-05 * a_link5_x + omega_link5_x * t_link6_1;
  tau[4] = M_link5_z;
  const Scalar t_link5_7 = s_joint5 * F_link5_y - c_joint5 * F_link5_x;
  // link4
  const Scalar F_link4_x = t_link5_7 + 0.0005151125 * a_link4_x;
  const Scalar F_link4_y = 0.0005151125 * a_link4_y - 5.8464e-05 * Omega_link5_zy;
  const Scalar F_link4_z = 0.0005151125 * a_link4_z - c_joint5 * F_link5_y - s_joint5 * F_link5_x;
  const Scalar t_link4_5 = 0.00075 * Omega_link4_zy + 0.001247328 * Omega_link5_zy;
  const Scalar M_link4_x = t_link4_5 + s_joint5 * M_link5_y - c_joint5 * M_link5_x;
  const Scalar M_link4_y = M_link5_z - 0.00065 * Omega_link4_zx - 21.334975369458128 * t_link5_7;
  const Scalar t_link4_6 = 0.00065 * Omega_link4_yx + 0.00075 * Omega_link4_xy;
  const Scalar M_link4_z = t_link4_6 - c_joint5 * M_link5_y - s_joint5 * M_link5_x;
  tau[3] = M_link4_z;
  const Scalar t_link4_7 = c_joint4 * F_link4_y + s_joint4 * F_link4_x;
  // link3
  const Scalar t_link3_12 = 0.0174944385 * Omega_link3_xy + s_joint4 * F_link4_y;
  const Scalar F_link3_x = t_link3_12 - c_joint4 * F_link4_x;
  const Scalar F_link3_y = F_link4_z - 0.0174944385 * Omega_link3_yy;
  const Scalar F_link3_z = t_link4_7 - 0.0174944385 * Omega_link3_zy;
  const Scalar t_link3_13 = 0.3056901365 * Omega_link3_zy + 0.0106736385 * Omega_link3_zx;
  const Scalar t_link3_14 = t_link3_13 - 0.004704 * t_link3_10 - 0.0174944385 * a_link3_z;
  const Scalar M_link3_x = t_link3_14 + s_joint4 * M_link4_y + c_joint4 * M_link4_x;
  const Scalar t_link3_15 = M_link4_z + t_link4_7 - 0.004704 * Omega_link3_xy;
  const Scalar M_link3_y = t_link3_15 - 0.0106736385 * Omega_link3_zy - 0.00625 * Omega_link3_zx;
  const Scalar t_link3_16 = F_link4_z + 0.00625 * Omega_link3_yx - 0.004704 * Omega_link3_xz;
  const Scalar t_link3_17 = t_link3_16 + 0.3056901365 * Omega_link3_xy;
  const Scalar t_link3_18 = t_link3_17 - 0.0106736385 * t_link3_11 - 0.0174944385 * a_link3_x;
  const Scalar M_link3_z = t_link3_18 + c_joint4 * M_link4_y - s_joint4 * M_link4_x;
  tau[2] = M_link3_z;
  const Scalar t_link3_19 = s_link3 * F_link3_y + c_link3 * F_link3_x;
  // link2
  const Scalar t_link2_8 = M_link3_z + qdd[1] * t_link2_7 + qdd[0] * t_link2_6;
  const Scalar t_link2_9 = t_link2_8 - Omega_link1_xx * t_link2_4;
  const Scalar t_link2_10 = t_link2_9 + 483.2512315270936 * t_link2_1;
  const Scalar t_link3_20 = s_link3_x * (c_link3 * F_link3_y - s_link3 * F_link3_x);
  tau[1] = t_link2_10 - s_link3_y * t_link3_19 - t_link3_20;
  // link1
  const Scalar t_link1_1 = t_link2_4 * Omega_link2_zy + qdd[1] * t_link2_6;
  const Scalar t_link1_2 = t_link1_1 - Omega_link2_yy * t_link2_5 - s_link3_x * F_link3_z;
  const Scalar t_link1_3 = t_link1_2 - 7.394088669950739 * t_link3_19 + c_link3 * M_link3_y;
  tau[0] = t_link1_3 + s_link3 * M_link3_x - qdd[0] * (t_link2_3 - 2.88549059);
}

void forward_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar tau[6],
                      Scalar qdd[6]) noexcept {
  const Scalar s_joint4 = sin(q[3]);
  const Scalar c_joint4 = cos(q[3]);
  // link3
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar t_link3_1 = q[1] + q[2];
  const Scalar s_link3 = sin(t_link3_1);
  const Scalar c_link3 = cos(t_link3_1);
  const Scalar omega_link3_y = s_link3 * qd[0];
  // link4
  const Scalar omega_link4_x = s_joint4 * omega_link3_z - c_joint4 * omega_link3_y;
  const Scalar omega_link4_y = c_joint4 * omega_link3_z + s_joint4 * omega_link3_y;
  const Scalar t_link4_1 = omega_link4_x * omega_link4_y;
  const Scalar alpha_link3_x = omega_link3_y * omega_link3_z;
  const Scalar Omega_link4_xy = alpha_link3_x + t_link4_1;
  const Scalar s_joint5 = sin(q[4]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar omega_link3_x = c_link3 * qd[0];
  const Scalar omega_link4_z = omega_link3_x + qd[3];
  const Scalar alpha_link3_y = omega_link3_x * omega_link3_z;
  const Scalar Omega_link4_zy = c_joint4 * alpha_link3_y - omega_link4_y * (qd[3] + omega_link4_z);
  // link5
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar omega_link5_y = c_joint5 * omega_link4_z + s_joint5 * omega_link4_x;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar Omega_link5_zy = Omega_link5_yz + omega_link5_y * omega_link5_z * 2.0;
  const Scalar F_link5_z = 5.8464e-05 * Omega_link5_zy;
  const Scalar omega_link5_x = s_joint5 * omega_link4_z - c_joint5 * omega_link4_x;
  const Scalar Omega_link5_yy = omega_link5_z * omega_link5_z + omega_link5_x * omega_link5_x;
  const Scalar F_link5_y = 5.8464e-05 * Omega_link5_yy;
  const Scalar t_link5_1 = omega_link5_x * omega_link5_y;
  const Scalar alpha_link4_y = s_joint4 * alpha_link3_y - omega_link4_x * qd[3];
  const Scalar Omega_link5_xy = alpha_link4_y - t_link5_1;
  const Scalar F_link5_x = 5.8464e-05 * Omega_link5_xy;
  const Scalar F_link4_x = s_joint5 * F_link5_y - c_joint5 * F_link5_x;
  const Scalar t_link4_2 = c_joint4 * F_link5_z - s_joint4 * F_link4_x;
  // link3
  const Scalar F_link3_z = t_link4_2 + 0.001030225 * alpha_link3_x + 0.034988877 * alpha_link3_y;
  const Scalar c_joint2 = cos(q[1]);
  const Scalar s_joint2 = sin(q[1]);
  const Scalar s_link3_x = 21.27093596059113 * c_joint2;
  const Scalar t_link6_1 = 0.0141984 * c_joint2 + 1.601861202 * s_joint2;
  const Scalar t_link6_2 = 0.0070992 - c_joint2 * t_link6_1;
  // link2
  const Scalar alpha_link2_x = qd[0] * qd[1];
  const Scalar Omega_link2_zy = 2.0 * alpha_link2_x;
  const Scalar Omega_link2_yy = qd[1] * qd[1];
  const Scalar t_link2_1 = (0.023751 * s_joint2 - 0.690314699 * c_joint2) * Omega_link2_yy;
  const Scalar t_link1_1 = tau[0] - t_link6_2 * Omega_link2_zy + t_link2_1;
  const Scalar t_link1_2 = t_link1_1 - s_link3_x * F_link3_z;
  const Scalar t_link4_3 = s_joint4 * F_link5_z + c_joint4 * F_link4_x;
  // link3
  const Scalar t_link3_2 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_3 = omega_link3_x * omega_link3_x;
  const Scalar Omega_link3_yy = t_link3_2 + t_link3_3;
  const Scalar Omega_link3_xy = omega_link3_x * omega_link3_y;
  const Scalar t_link3_4 = t_link4_3 - 0.0005151125 * Omega_link3_yy;
  const Scalar F_link3_y = t_link3_4 + 0.0174944385 * Omega_link3_xy;
  const Scalar F_link4_z = c_joint5 * F_link5_y + s_joint5 * F_link5_x;
  const Scalar t_link3_5 = t_link3_2 - t_link3_3;
  const Scalar Omega_link1_xx = qd[0] * qd[0];
  const Scalar Omega_link3_xx = Omega_link1_xx + t_link3_5;
  const Scalar t_link3_6 = F_link4_z - 0.0005151125 * Omega_link3_xy;
  const Scalar F_link3_x = t_link3_6 + 0.0174944385 * Omega_link3_xx;
  const Scalar t_link3_7 = c_link3 * F_link3_y + s_link3 * F_link3_x;
  const Scalar t_link1_3 = t_link1_2 - 7.394088669950739 * t_link3_7;
  const Scalar t_link5_2 = omega_link5_x * omega_link5_z;
  const Scalar alpha_link5_y = t_link5_2 + s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar M_link6_z = 4e-05 * alpha_link5_y;
  const Scalar M_link5_y = M_link6_z + 0.0002 * (t_link5_2 + alpha_link5_y);
  const Scalar t_link4_4 = 0.00075 * Omega_link4_zy + s_joint5 * M_link5_y;
  const Scalar s_link3_y = 21.27093596059113 * s_joint2;
  const Scalar t_link3_8 = 483.2512315270936 + s_link3_y * Omega_link2_yy;
  const Scalar Omega_link2_xx = Omega_link1_xx + Omega_link2_yy;
  const Scalar t_link3_9 = s_link3_x * Omega_link2_xx;
  const Scalar a_link3_y = s_link3 * t_link3_8 + c_link3 * t_link3_9;
  const Scalar t_link4_5 = a_link3_y - Omega_link3_yy + 21.334975369458128 * Omega_link3_xy;
  const Scalar a_link3_z = 7.394088669950739 * Omega_link1_xx + s_link3_y * Omega_link2_zy;
  const Scalar t_link4_6 = a_link3_z - 42.669950738916256 * alpha_link3_y - 2.0 * alpha_link3_x;
  const Scalar a_link4_y = c_joint4 * t_link4_6 - s_joint4 * t_link4_5;
  const Scalar omega_link6_z = omega_link5_y + qd[5];
  const Scalar t_link6_3 = 4e-05 * omega_link6_z;
  const Scalar t_link5_3 = 5.8464e-05 * a_link4_y + omega_link5_z * t_link6_3;
  const Scalar M_link5_x = t_link5_3 - 0.00044216 * Omega_link5_zy;
  const Scalar M_link4_x = t_link4_4 - c_joint5 * M_link5_x;
  const Scalar t_link4_7 = c_joint4 * M_link4_x;
  const Scalar t_link3_10 = 0.021347277 * alpha_link3_x + 0.611380273 * alpha_link3_y;
  const Scalar t_link3_11 = t_link3_10 + 0.004704 * t_link3_5 - 0.0174944385 * a_link3_z;
  const Scalar t_link3_12 = t_link3_11 + 21.334975369458128 * t_link4_2;
  const Scalar a_link3_x = c_link3 * t_link3_8 - s_link3 * t_link3_9;
  const Scalar a_link4_z = a_link3_x + Omega_link3_xy - 21.334975369458128 * Omega_link3_xx;
  const Scalar a_link4_x = s_joint4 * t_link4_6 + c_joint4 * t_link4_5;
  // link5
  const Scalar a_link5_x = s_joint5 * a_link4_z + c_joint5 * a_link4_x;
  const Scalar t_link5_4 = 0.00064216 * alpha_link4_y - 0.00024216 * t_link5_1;
  const Scalar M_link5_z = t_link5_4 - 5.8464e-05 * a_link5_x + omega_link5_x * t_link6_3;
  const Scalar Omega_link4_zx = alpha_link4_y - omega_link4_x * omega_link4_z;
  const Scalar M_link4_y = M_link5_z + 0.00065 * Omega_link4_zx;
  const Scalar M_link3_y = t_link3_12 + s_joint4 * M_link4_y + t_link4_7;
  // link4
  const Scalar Omega_link4_yx = alpha_link3_x - t_link4_1;
  const Scalar t_link4_8 = 0.00065 * Omega_link4_yx + 0.00075 * Omega_link4_xy;
  const Scalar M_link4_z = t_link4_8 + c_joint5 * M_link5_y + s_joint5 * M_link5_x;
  // link3
  const Scalar t_link3_13 = M_link4_z + t_link4_2 + 0.013530225 * alpha_link3_x;
  const Scalar t_link3_14 = t_link3_13 + 0.021347277 * alpha_link3_y - 0.004704 * Omega_link3_xy;
  const Scalar M_link3_x = t_link3_14 - 0.0005151125 * a_link3_z;
  const Scalar t_link1_4 = M_link6_z + tau[5];
  const Scalar t_link5_5 = 4e-05 * s_joint5;
  const Scalar t_link5_6 = 4e-05 * c_joint5;
  const Scalar t_link3_15 = s_link3 * c_joint4 * t_link5_5 - c_link3 * t_link5_6;
  const Scalar t_link6_4 = 25000.0 * t_link3_15;
  const Scalar t_link1_5 = t_link1_3 - s_link3 * M_link3_y + c_link3 * M_link3_x;
  const Scalar t_link1_6 = M_link5_z - tau[4];
  // link4
  const Scalar h_link4_z = 5.8464e-05 * c_joint5;
  const Scalar t_link4_9 = c_joint4 * h_link4_z;
  const Scalar h_link4_x = 5.8464e-05 * s_joint5;
  const Scalar t_link3_16 = c_link3 * t_link4_9 - s_link3 * h_link4_x;
  const Scalar t_link4_10 = s_joint4 * h_link4_z;
  // link3
  const Scalar t_link3_17 = s_link3 * (21.334975369458128 * t_link4_10 + 0.00064216 * s_joint4);
  const Scalar t_link3_18 = 7.394088669950739 * t_link3_16 - t_link3_17;
  const Scalar t_link3_19 = t_link3_18 - t_link4_10 * (s_link3_x - c_link3);
  const Scalar t_link5_7 = 1557.2443004858603 * t_link3_19;
  const Scalar t_link1_7 = t_link1_5 + t_link1_4 * t_link6_4 - t_link1_6 * t_link5_7;
  const Scalar t_link1_8 = M_link4_z + tau[3] - c_joint5 * t_link1_4;
  const Scalar t_link4_11 = c_joint4 * h_link4_x;
  const Scalar h_link3_z = s_joint4 * h_link4_x;
  const Scalar t_link3_20 = c_link3 * h_link3_z;
  const Scalar t_link5_8 = 0.00020216 * s_joint5;
  const Scalar I_link4_xz = c_joint5 * t_link5_8;
  const Scalar t_link4_12 = c_joint4 * I_link4_xz + 21.334975369458128 * t_link4_11;
  const Scalar t_link3_21 = s_link3_x * t_link4_11 + 7.394088669950739 * t_link3_20;
  const Scalar t_link5_9 = s_joint5 * t_link5_8;
  const Scalar I_link4_zz = 0.00164 + t_link5_9;
  const Scalar t_link3_22 = c_link3 * (I_link4_zz - t_link4_11);
  const Scalar t_link3_23 = t_link3_21 + s_link3 * t_link4_12 + t_link3_22;
  const Scalar t_link6_5 = t_link3_23 + c_joint5 * t_link3_15;
  const Scalar inverse_pivot_link4 = 1.0 / (I_link4_zz - c_joint5 * t_link5_6);
  const Scalar t_link4_13 = t_link6_5 * inverse_pivot_link4;
  const Scalar t_link1_9 = t_link1_7 - t_link4_13 * t_link1_8;
  const Scalar t_link3_24 = F_link4_z + 0.0106736385 * (Omega_link3_xx - Omega_link3_yy);
  const Scalar t_link3_25 = t_link3_24 - 0.0005151125 * a_link3_x + 0.0174944385 * a_link3_y;
  const Scalar t_link3_26 = t_link3_25 + 21.334975369458128 * t_link4_3 - c_joint4 * M_link4_y;
  const Scalar M_link3_z = t_link3_26 + s_joint4 * M_link4_x + 0.298925024 * Omega_link3_xy;
  const Scalar t_link4_14 = s_joint4 * t_link5_5;
  const Scalar t_link6_6 = 25000.0 * t_link4_14;
  const Scalar t_link1_10 = M_link3_z - t_link1_4 * t_link6_6;
  const Scalar t_link4_15 = h_link4_x - 21.334975369458128 * t_link4_9 - 0.00064216 * c_joint4;
  const Scalar t_link5_10 = 1557.2443004858603 * t_link4_15;
  const Scalar t_link4_16 = s_joint4 * I_link4_xz + 21.334975369458128 * h_link3_z;
  const Scalar t_link6_7 = t_link4_16 + c_joint5 * t_link4_14;
  const Scalar t_link4_17 = t_link6_7 * inverse_pivot_link4;
  const Scalar t_link1_11 = tau[2] + t_link1_10 - t_link1_6 * t_link5_10;
  const Scalar t_link1_12 = t_link1_11 + t_link4_17 * t_link1_8;
  const Scalar t_link4_18 = s_joint4 * (0.0001 + t_link5_9);
  const Scalar I_link3_yz = h_link3_z - c_joint4 * t_link4_18;
  const Scalar I_link3_xz = 0.004704 + t_link4_16;
  const Scalar h_link3_y = 0.0005151125 - t_link4_11;
  const Scalar h_link3_x = 0.0174944385 + h_link4_z;
  const Scalar t_link3_27 = s_link3 * h_link3_y + c_link3 * h_link3_x;
  const Scalar t_link3_28 = s_link3 * I_link3_yz + c_link3 * I_link3_xz;
  const Scalar t_link3_29 = t_link3_28 + 7.394088669950739 * t_link3_27;
  const Scalar t_link6_8 = t_link3_29 - t_link3_15 * t_link6_6;
  // link4
  const Scalar t_link4_19 = t_link6_8 + t_link3_19 * t_link5_10 - t_link6_5 * t_link4_17;
  const Scalar t_link4_20 = 2.0 * t_link4_11;
  const Scalar t_link4_21 = s_joint4 * t_link4_18;
  const Scalar t_link4_22 = 0.002494656 * c_joint5;
  const Scalar I_link3_zz = t_link4_20 - (0.313747409 - t_link4_21 + t_link4_22);
  const Scalar t_link6_9 = I_link3_zz + t_link4_14 * t_link6_6;
  const Scalar t_link4_23 = t_link6_9 + t_link4_15 * t_link5_10 + t_link6_7 * t_link4_17;
  const Scalar inverse_pivot_link3 = 1.0 / t_link4_23;
  const Scalar t_link3_30 = t_link4_19 * inverse_pivot_link3;
  const Scalar t_link1_13 = t_link1_9 - t_link3_30 * t_link1_12;
  const Scalar t_link2_2 = 483.2512315270936 * (0.00211932 * s_joint2 - 0.077050477 * c_joint2);
  const Scalar t_link1_14 = tau[1] + t_link1_10 + t_link6_2 * Omega_link1_xx - t_link2_2;
  // link3
  const Scalar t_link3_31 = s_link3_x * (s_link3 * F_link3_y - c_link3 * F_link3_x);
  const Scalar t_link3_32 = s_link3_x * (s_link3 * t_link4_9 + c_link3 * h_link4_x);
  const Scalar t_link3_33 = t_link4_15 + s_link3_y * t_link3_16 - t_link3_32;
  const Scalar t_link5_11 = 1557.2443004858603 * t_link3_33;
  const Scalar t_link1_15 = t_link1_14 - s_link3_y * t_link3_7 + t_link3_31;
  const Scalar t_link6_10 = t_link6_7 - s_link3_y * t_link3_20;
  const Scalar t_link6_11 = t_link6_10 + s_link3_x * s_link3 * h_link3_z;
  const Scalar t_link4_24 = t_link6_11 * inverse_pivot_link4;
  const Scalar t_link3_34 = s_link3_x * (c_link3 * h_link3_y - s_link3 * h_link3_x);
  const Scalar t_link3_35 = s_link3_y * t_link3_27;
  const Scalar t_link5_12 = t_link3_34 + t_link3_35 + t_link6_9 + t_link3_33 * t_link5_10;
  const Scalar t_link4_25 = t_link5_12 + t_link6_11 * t_link4_17;
  const Scalar t_link3_36 = t_link4_25 * inverse_pivot_link3;
  const Scalar t_link1_16 = t_link1_15 - t_link1_6 * t_link5_11 + t_link4_24 * t_link1_8;
  const Scalar t_link1_17 = t_link1_16 - t_link3_36 * t_link1_12;
  const Scalar t_link6_12 = t_link6_8 - 0.023751 * c_joint2 - 0.690314699 * s_joint2;
  const Scalar t_link5_13 = t_link6_12 - s_link3_y * h_link3_z + t_link3_19 * t_link5_11;
  const Scalar t_link3_37 = t_link5_13 - t_link6_5 * t_link4_24 - t_link4_19 * t_link3_36;
  const Scalar t_link3_38 = 2.0 * t_link3_34;
  const Scalar t_link6_13 = t_link6_9 - (1.748114002 - t_link3_38) + 2.0 * t_link3_35;
  const Scalar t_link4_26 = t_link6_13 + t_link3_33 * t_link5_11 + t_link6_11 * t_link4_24;
  const Scalar inverse_pivot_link2 = 1.0 / (t_link4_26 - t_link4_25 * t_link3_36);
  const Scalar t_link2_3 = t_link3_37 * inverse_pivot_link2;
  const Scalar t_link1_18 = t_link1_13 - t_link2_3 * t_link1_17;
  const Scalar t_link2_4 = t_link3_37 * t_link2_3;
  const Scalar t_link3_39 = t_link4_19 * t_link3_30;
  const Scalar I_link3_yy = 0.300117184 - t_link5_9 + t_link4_21 + t_link4_22;
  const Scalar I_link3_xx = I_link4_zz - t_link4_20;
  const Scalar I_link3_xy = t_link4_12 - (0.0106736385 + h_link4_z);
  const Scalar t_link3_40 = s_link3 * I_link3_xy * 2.0 - c_link3 * (I_link3_yy - I_link3_xx);
  const Scalar t_link1_19 = t_link3_38 - (3.153482265 + I_link3_yy) + s_joint2 * t_link6_1;
  const Scalar I_link1_zz = t_link1_19 - c_link3 * t_link3_40 - 14.788177339901479 * h_link3_z;
  const Scalar t_link5_14 = I_link1_zz + t_link3_15 * t_link6_4 + t_link3_19 * t_link5_7;
  const Scalar t_link2_5 = t_link5_14 + t_link6_5 * t_link4_13 - t_link3_39 - t_link2_4;
  // link1
  const Scalar inverse_pivot_link1 = 1.0 / t_link2_5;
  const Scalar t_link1_20 = inverse_pivot_link1 * t_link1_18;
  qdd[0] = -t_link1_20;
  const Scalar t_link1_21 = inverse_pivot_link2 * t_link1_17 - t_link2_3 * t_link1_20;
  qdd[1] = -t_link1_21;
  const Scalar t_link1_22 = inverse_pivot_link3 * t_link1_12 - t_link3_36 * t_link1_21;
  const Scalar t_link1_23 = t_link1_22 - t_link3_30 * t_link1_20;
  qdd[2] = -t_link1_23;
  const Scalar t_link1_24 = inverse_pivot_link4 * t_link1_8 - t_link4_17 * t_link1_23;
  const Scalar t_link1_25 = t_link1_24 - t_link4_24 * t_link1_21 + t_link4_13 * t_link1_20;
  qdd[3] = t_link1_25;
  const Scalar t_link1_26 = 1557.2443004858603 * t_link1_6 + t_link5_10 * t_link1_23;
  qdd[4] = -(t_link1_26 + t_link5_11 * t_link1_21 + t_link5_7 * t_link1_20);
  const Scalar t_link1_27 = 25000.0 * t_link1_4 - c_joint5 * t_link1_25;
  qdd[5] = t_link1_27 - t_link6_4 * t_link1_20 + t_link6_6 * (t_link1_21 + t_link1_23);
}

}  // namespace puma560
