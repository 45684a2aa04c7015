// biped.cpp: see biped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate biped.yaml --effort 1000

#include "biped.hpp"

#include <cmath>

namespace biped {

using std::cos;
using std::sin;

void mass_matrix(const Scalar q[12], Scalar A[144]) noexcept {
  // left_foot
  const Scalar t_left_foot_1 = 0.2614691411136524 + q[5];
  const Scalar c_left_foot = cos(t_left_foot_1);
  const Scalar s_left_foot = sin(t_left_foot_1);
  const Scalar t_left_foot_2 = 0.00013282817963685661 * s_left_foot;
  const Scalar t_left_foot_3 = 7.233379265339546e-05 * c_left_foot + t_left_foot_2;
  const Scalar t_left_foot_4 = s_left_foot * t_left_foot_3;
  const Scalar t_left_foot_5 = 0.00028257270982809396 * c_left_foot;
  const Scalar t_left_foot_6 = 0.0005569034480192284 - t_left_foot_4;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_1 = t_left_foot_5 + t_left_foot_6;
  const Scalar c_left_ankle_pitch = cos(q[4]);
  const Scalar s_left_ankle_pitch = sin(q[4]);
  // right_foot
  const Scalar t_right_foot_1 = 0.350779421733216 * s_left_ankle_pitch;
  const Scalar t_right_foot_2 = 0.03083291102976 * c_left_ankle_pitch - t_right_foot_1;
  const Scalar t_right_foot_3 = s_left_ankle_pitch * t_right_foot_2;
  const Scalar s_left_ankle_cross_x = 43.3 * c_left_ankle_pitch;
  const Scalar t_left_foot_7 = 0.00014128635491404698 * c_left_foot;
  const Scalar h_left_ankle_cross_x = 9.4668e-05 + t_left_foot_7;
  const Scalar t_left_ankle_cross_2 = s_left_ankle_cross_x * h_left_ankle_cross_x;
  // left_shank
  const Scalar t_left_shank_1 = 0.356189548484 + t_right_foot_3 + t_left_ankle_cross_1;
  const Scalar E_left_shank_xx = t_left_shank_1 + 2.0 * t_left_ankle_cross_2;
  const Scalar t_left_shank_2 = q[3] + q[4];
  const Scalar c_left_shank = cos(t_left_shank_2);
  const Scalar s_left_shank = sin(t_left_shank_2);
  // right_foot
  const Scalar t_right_foot_4 = 0.03939173998083072 * c_left_shank;
  const Scalar t_right_foot_5 = t_right_foot_4 - 1.2800687125653505 * s_left_shank;
  const Scalar t_right_foot_6 = s_left_shank * t_right_foot_5;
  // left_shank
  const Scalar t_left_shank_3 = h_left_ankle_cross_x + 0.00080309376 * s_left_ankle_pitch;
  const Scalar h_left_shank_x = t_left_shank_3 + 0.0110425392 * c_left_ankle_pitch;
  const Scalar s_left_shank_x = 43.2 * c_left_shank;
  const Scalar t_left_shank_4 = s_left_shank_x * h_left_shank_x;
  const Scalar t_left_thigh_1 = 1.3047192060098918 + t_right_foot_6 + E_left_shank_xx;
  const Scalar E_left_thigh_xx = t_left_thigh_1 + 2.0 * t_left_shank_4;
  const Scalar t_left_shank_5 = 0.0122703364936992 - t_right_foot_3;
  const Scalar E_left_shank_yy = t_left_shank_5 + 0.0477024308544 * s_left_ankle_pitch;
  const Scalar t_left_shank_6 = 0.000550836384 - 0.00080309376 * c_left_ankle_pitch;
  const Scalar h_left_shank_y = t_left_shank_6 + 0.0110425392 * s_left_ankle_pitch;
  const Scalar s_left_shank_y = 43.2 * s_left_shank;
  const Scalar t_left_shank_7 = s_left_shank_y * h_left_shank_y;
  // left_thigh
  const Scalar t_left_thigh_2 = 0.02465049344454144 - t_right_foot_6 + E_left_shank_yy;
  const Scalar E_left_thigh_yy = t_left_thigh_2 + 2.0 * t_left_shank_7;
  const Scalar t_left_thigh_3 = q[2] + t_left_shank_2;
  const Scalar s_left_thigh = sin(t_left_thigh_3);
  const Scalar c_left_thigh = cos(t_left_thigh_3);
  const Scalar t_left_foot_8 = 6.298136129784905e-05 * s_left_foot;
  const Scalar t_left_foot_9 = t_left_foot_8 - 0.0014494177603079786 * c_left_foot;
  const Scalar t_left_thigh_4 = 0.03566200268929536 - t_left_foot_9;
  const Scalar s_left_ankle_cross_y = 43.3 * s_left_ankle_pitch;
  const Scalar t_left_thigh_5 = t_left_thigh_4 - c_left_shank * t_right_foot_5;
  const Scalar t_left_ankle_cross_3 = s_left_ankle_cross_y * h_left_ankle_cross_x;
  const Scalar t_left_thigh_6 = t_left_thigh_5 + t_left_ankle_cross_3;
  const Scalar t_left_thigh_7 = t_left_thigh_6 + s_left_shank_y * h_left_shank_x;
  const Scalar t_left_thigh_8 = c_left_ankle_pitch * (0.0238512154272 - t_right_foot_2);
  const Scalar t_left_thigh_9 = t_left_thigh_7 + s_left_shank_x * h_left_shank_y;
  const Scalar E_left_thigh_xy = t_left_thigh_9 + t_left_thigh_8;
  const Scalar t_left_thigh_10 = s_left_thigh * (E_left_thigh_xx - E_left_thigh_yy);
  const Scalar t_left_thigh_11 = c_left_thigh * E_left_thigh_xy * 2.0 - t_left_thigh_10;
  const Scalar t_left_thigh_12 = s_left_thigh * t_left_thigh_11;
  const Scalar E_left_hip_fork_xx = 0.00026615232 + E_left_thigh_xx + t_left_thigh_12;
  const Scalar t_left_hip_block_1 = t_left_thigh_12 - (0.00406285432 + E_left_thigh_yy);
  const Scalar t_left_thigh_13 = h_left_shank_y - 0.0014731530912 * c_left_shank;
  const Scalar h_left_thigh_y = t_left_thigh_13 + 0.0362798116128 * s_left_shank;
  const Scalar t_left_thigh_14 = h_left_shank_x + 0.0014731530912 * s_left_shank;
  const Scalar h_left_thigh_x = t_left_thigh_14 + 0.0362798116128 * c_left_shank;
  const Scalar t_left_thigh_15 = c_left_thigh * h_left_thigh_y;
  const Scalar h_left_hip_fork_z = t_left_thigh_15 - s_left_thigh * h_left_thigh_x;
  const Scalar t_left_hip_block_2 = E_left_hip_fork_xx - t_left_hip_block_1;
  const Scalar t_left_hip_block_3 = t_left_hip_block_2 + 2.0 * h_left_hip_fork_z;
  const Scalar t_left_foot_10 = 6.298136129784905e-05 * c_left_foot;
  const Scalar t_left_foot_11 = t_left_foot_10 + 0.0014494177603079786 * s_left_foot;
  A[53] = -t_left_foot_11;
  A[64] = A[53];
  // left_ankle_cross
  const Scalar E_left_ankle_cross_yz = 0.001106309568 + t_left_foot_11;
  const Scalar h_left_ankle_cross_z = 0.00014128635491404698 * s_left_foot;
  const Scalar t_left_ankle_cross_4 = s_left_ankle_cross_y * h_left_ankle_cross_z;
  // left_shank
  const Scalar t_left_shank_8 = E_left_ankle_cross_yz + t_left_ankle_cross_4;
  const Scalar t_left_shank_9 = t_left_shank_8 - 0.001559822240256 * c_left_ankle_pitch;
  const Scalar E_left_shank_yz = t_left_shank_9 + 0.02565802580712 * s_left_ankle_pitch;
  const Scalar t_left_shank_10 = s_left_shank_y * h_left_ankle_cross_z;
  // left_thigh
  const Scalar t_left_thigh_16 = E_left_shank_yz + t_left_shank_10;
  const Scalar t_left_thigh_17 = t_left_thigh_16 - 0.00442555309711872 * c_left_shank;
  const Scalar E_left_thigh_yz = t_left_thigh_17 + 0.09232168197063167 * s_left_shank;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_5 = 0.00016012430367330226 + h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_6 = t_left_foot_5 + t_left_ankle_cross_5;
  const Scalar E_left_ankle_cross_xz = t_left_ankle_cross_6 + c_left_foot * t_left_foot_3;
  const Scalar t_right_foot_7 = 0.001559822240256 * s_left_ankle_pitch;
  const Scalar t_left_shank_11 = E_left_ankle_cross_xz + t_right_foot_7;
  const Scalar t_left_shank_12 = t_left_shank_11 + 0.02565802580712 * c_left_ankle_pitch;
  const Scalar t_left_ankle_cross_7 = s_left_ankle_cross_x * h_left_ankle_cross_z;
  const Scalar E_left_shank_xz = t_left_shank_12 + t_left_ankle_cross_7;
  // left_thigh
  const Scalar t_left_thigh_18 = E_left_shank_xz + 0.00442555309711872 * s_left_shank;
  const Scalar t_left_thigh_19 = t_left_thigh_18 + 0.09232168197063167 * c_left_shank;
  const Scalar E_left_thigh_xz = t_left_thigh_19 + s_left_shank_x * h_left_ankle_cross_z;
  const Scalar t_left_thigh_20 = s_left_thigh * E_left_thigh_yz;
  const Scalar t_left_thigh_21 = t_left_thigh_20 + c_left_thigh * E_left_thigh_xz;
  // left_hip_fork
  const Scalar E_left_hip_fork_xy = 8.079624e-05 + t_left_thigh_21;
  const Scalar s_left_hip_roll = sin(q[1]);
  const Scalar c_left_hip_roll = cos(q[1]);
  const Scalar t_left_hip_fork_1 = 0.030379399648709733 + t_left_foot_4;
  const Scalar E_left_hip_fork_yy = t_left_hip_fork_1 + 0.0005651454196561879 * s_left_foot;
  const Scalar t_left_hip_fork_2 = E_left_hip_fork_xx - E_left_hip_fork_yy;
  const Scalar t_left_hip_fork_3 = s_left_hip_roll * E_left_hip_fork_xy * 2.0;
  const Scalar t_left_hip_fork_4 = c_left_hip_roll * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_3 - t_left_hip_fork_4;
  A[0] = t_left_hip_block_3 + c_left_hip_roll * t_left_hip_fork_5;
  const Scalar t_left_thigh_22 = c_left_thigh * E_left_thigh_yz;
  const Scalar t_left_thigh_23 = t_left_thigh_22 - s_left_thigh * E_left_thigh_xz;
  A[14] = -t_left_thigh_23;
  A[25] = A[14];
  const Scalar E_left_hip_fork_yz = 0.0042631913856 + h_left_ankle_cross_z + t_left_thigh_23;
  const Scalar t_left_hip_fork_6 = 0.00011406528 - E_left_thigh_xy;
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_6 + s_left_thigh * h_left_thigh_y;
  const Scalar t_left_hip_fork_8 = c_left_thigh * (h_left_thigh_x + t_left_thigh_11);
  const Scalar E_left_hip_fork_xz = t_left_hip_fork_7 + t_left_hip_fork_8;
  A[1] = c_left_hip_roll * E_left_hip_fork_xz - s_left_hip_roll * E_left_hip_fork_yz;
  A[12] = A[1];
  const Scalar t_left_thigh_24 = E_left_thigh_xx + E_left_thigh_yy;
  A[26] = t_left_thigh_24;
  const Scalar t_left_hip_fork_9 = s_left_hip_roll * (t_left_thigh_24 + h_left_hip_fork_z);
  A[2] = t_left_hip_fork_9 + c_left_hip_roll * t_left_thigh_21;
  A[24] = A[2];
  const Scalar t_left_thigh_25 = s_left_thigh * E_left_shank_yz;
  const Scalar t_left_thigh_26 = t_left_thigh_25 + c_left_thigh * E_left_shank_xz;
  const Scalar t_left_shank_13 = E_left_shank_xx + E_left_shank_yy;
  A[39] = t_left_shank_13;
  const Scalar t_left_shank_14 = t_left_shank_13 + t_left_shank_4 + t_left_shank_7;
  A[27] = t_left_shank_14;
  A[38] = A[27];
  const Scalar t_left_thigh_27 = t_left_shank_14 - s_left_thigh * h_left_shank_x;
  const Scalar t_left_thigh_28 = t_left_thigh_27 + c_left_thigh * h_left_shank_y;
  A[3] = s_left_hip_roll * t_left_thigh_28 + c_left_hip_roll * t_left_thigh_26;
  A[36] = A[3];
  // left_ankle_cross
  const Scalar t_left_ankle_cross_8 = 0.0070975881429152 + t_left_ankle_cross_1;
  A[52] = t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_8 + t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_10 = 0.0238512154272 * s_left_ankle_pitch;
  const Scalar t_left_ankle_cross_11 = t_left_ankle_cross_9 + t_left_ankle_cross_10;
  A[40] = t_left_ankle_cross_11;
  A[51] = A[40];
  const Scalar t_left_shank_15 = t_left_ankle_cross_11 + 0.0237961317888 * s_left_shank;
  const Scalar t_left_shank_16 = t_left_shank_15 + s_left_shank_x * h_left_ankle_cross_x;
  A[28] = t_left_shank_16;
  A[50] = A[28];
  // left_thigh
  const Scalar t_left_thigh_29 = t_left_shank_16 - s_left_thigh * h_left_ankle_cross_x;
  const Scalar t_left_thigh_30 = t_left_thigh_29 + 0.000550836384 * c_left_thigh;
  const Scalar t_left_thigh_31 = s_left_thigh * E_left_ankle_cross_yz;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + c_left_thigh * E_left_ankle_cross_xz;
  A[4] = s_left_hip_roll * t_left_thigh_30 + c_left_hip_roll * t_left_thigh_32;
  A[48] = A[4];
  const Scalar t_left_ankle_cross_12 = t_left_foot_11 + t_left_ankle_cross_4;
  A[41] = -t_left_ankle_cross_12;
  A[63] = A[41];
  const Scalar t_left_shank_17 = t_left_ankle_cross_12 + t_left_shank_10;
  A[29] = -t_left_shank_17;
  A[62] = A[29];
  const Scalar t_left_thigh_33 = t_left_shank_17 + c_left_thigh * h_left_ankle_cross_z;
  // left_shank
  const Scalar t_left_shank_18 = t_left_foot_7 * (s_left_shank_y + s_left_ankle_cross_y);
  const Scalar t_left_shank_19 = t_left_foot_9 - t_left_shank_18;
  const Scalar t_left_shank_20 = 1.0 + s_left_shank_x + s_left_ankle_cross_x;
  const Scalar t_left_shank_21 = 0.0009809787164016 + 0.00028257270982809396 * s_left_foot;
  const Scalar t_left_shank_22 = t_left_shank_21 + t_left_foot_7 * t_left_shank_20;
  const Scalar t_left_thigh_34 = t_left_foot_7 - s_left_thigh * t_left_shank_22;
  const Scalar t_left_thigh_35 = t_left_thigh_34 - c_left_thigh * t_left_shank_19;
  A[5] = c_left_hip_roll * t_left_thigh_35 - s_left_hip_roll * t_left_thigh_33;
  A[60] = A[5];
  A[13] = E_left_hip_fork_xx + E_left_hip_fork_yy;
  // left_thigh
  A[15] = s_left_thigh * E_left_shank_xz - c_left_thigh * E_left_shank_yz;
  A[37] = A[15];
  A[16] = s_left_thigh * E_left_ankle_cross_xz - c_left_thigh * E_left_ankle_cross_yz;
  A[49] = A[16];
  A[17] = c_left_thigh * t_left_shank_22 - s_left_thigh * t_left_shank_19;
  A[61] = A[17];
  // right_foot
  const Scalar t_right_foot_8 = 0.2614691411136524 - q[11];
  const Scalar c_right_foot = cos(t_right_foot_8);
  const Scalar s_right_foot = sin(t_right_foot_8);
  const Scalar t_right_foot_9 = 0.00013282817963685661 * s_right_foot;
  const Scalar t_right_foot_10 = 7.233379265339546e-05 * c_right_foot + t_right_foot_9;
  const Scalar t_right_foot_11 = s_right_foot * t_right_foot_10;
  const Scalar t_right_foot_12 = 0.00028257270982809396 * c_right_foot;
  const Scalar t_right_foot_13 = 0.0005569034480192284 - t_right_foot_11;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_1 = t_right_foot_12 + t_right_foot_13;
  const Scalar c_right_ankle_pitch = cos(q[10]);
  const Scalar s_right_ankle_pitch = sin(q[10]);
  // right_foot
  const Scalar t_right_foot_14 = 0.350779421733216 * s_right_ankle_pitch;
  const Scalar t_right_foot_15 = 0.03083291102976 * c_right_ankle_pitch - t_right_foot_14;
  const Scalar t_right_foot_16 = s_right_ankle_pitch * t_right_foot_15;
  const Scalar s_righ_ankl_cros_x = 43.3 * c_right_ankle_pitch;
  const Scalar t_right_foot_17 = 0.00014128635491404698 * c_right_foot;
  const Scalar h_righ_ankl_cros_x = 9.4668e-05 + t_right_foot_17;
  const Scalar t_righ_ankl_cros_2 = s_righ_ankl_cros_x * h_righ_ankl_cros_x;
  // right_shank
  const Scalar t_right_shank_1 = 0.356189548484 + t_right_foot_16 + t_righ_ankl_cros_1;
  const Scalar E_right_shank_xx = t_right_shank_1 + 2.0 * t_righ_ankl_cros_2;
  const Scalar t_right_shank_2 = q[9] + q[10];
  const Scalar c_right_shank = cos(t_right_shank_2);
  const Scalar s_right_shank = sin(t_right_shank_2);
  // right_foot
  const Scalar t_right_foot_18 = 0.03939173998083072 * c_right_shank;
  const Scalar t_right_foot_19 = t_right_foot_18 - 1.2800687125653505 * s_right_shank;
  const Scalar t_right_foot_20 = s_right_shank * t_right_foot_19;
  // right_shank
  const Scalar t_right_shank_3 = h_righ_ankl_cros_x + 0.00080309376 * s_right_ankle_pitch;
  const Scalar h_right_shank_x = t_right_shank_3 + 0.0110425392 * c_right_ankle_pitch;
  const Scalar s_right_shank_x = 43.2 * c_right_shank;
  const Scalar t_right_shank_4 = s_right_shank_x * h_right_shank_x;
  const Scalar t_right_thigh_1 = 1.3047192060098918 + t_right_foot_20 + E_right_shank_xx;
  const Scalar E_right_thigh_xx = t_right_thigh_1 + 2.0 * t_right_shank_4;
  const Scalar t_right_shank_5 = 0.0122703364936992 - t_right_foot_16;
  const Scalar E_right_shank_yy = t_right_shank_5 + 0.0477024308544 * s_right_ankle_pitch;
  const Scalar t_right_shank_6 = 0.000550836384 - 0.00080309376 * c_right_ankle_pitch;
  const Scalar h_right_shank_y = t_right_shank_6 + 0.0110425392 * s_right_ankle_pitch;
  const Scalar s_right_shank_y = 43.2 * s_right_shank;
  const Scalar t_right_shank_7 = s_right_shank_y * h_right_shank_y;
  // right_thigh
  const Scalar t_right_thigh_2 = 0.02465049344454144 - t_right_foot_20 + E_right_shank_yy;
  const Scalar E_right_thigh_yy = t_right_thigh_2 + 2.0 * t_right_shank_7;
  const Scalar t_right_thigh_3 = q[8] + t_right_shank_2;
  const Scalar s_right_thigh = sin(t_right_thigh_3);
  const Scalar c_right_thigh = cos(t_right_thigh_3);
  const Scalar t_right_foot_21 = 6.298136129784905e-05 * s_right_foot;
  const Scalar t_right_foot_22 = t_right_foot_21 - 0.0014494177603079786 * c_right_foot;
  const Scalar t_right_thigh_4 = 0.03566200268929536 - t_right_foot_22;
  const Scalar s_righ_ankl_cros_y = 43.3 * s_right_ankle_pitch;
  const Scalar t_right_thigh_5 = t_right_thigh_4 - c_right_shank * t_right_foot_19;
  const Scalar t_righ_ankl_cros_3 = s_righ_ankl_cros_y * h_righ_ankl_cros_x;
  const Scalar t_right_thigh_6 = t_right_thigh_5 + t_righ_ankl_cros_3;
  const Scalar t_right_thigh_7 = t_right_thigh_6 + s_right_shank_y * h_right_shank_x;
  const Scalar t_right_thigh_8 = c_right_ankle_pitch * (0.0238512154272 - t_right_foot_15);
  const Scalar t_right_thigh_9 = t_right_thigh_7 + s_right_shank_x * h_right_shank_y;
  const Scalar E_right_thigh_xy = t_right_thigh_9 + t_right_thigh_8;
  const Scalar t_right_thigh_10 = s_right_thigh * (E_right_thigh_xx - E_right_thigh_yy);
  const Scalar t_right_thigh_11 = c_right_thigh * E_right_thigh_xy * 2.0 - t_right_thigh_10;
  const Scalar t_right_thigh_12 = s_right_thigh * t_right_thigh_11;
  const Scalar E_right_hip_fork_xx = 0.00026615232 + E_right_thigh_xx + t_right_thigh_12;
  const Scalar t_right_hip_block_1 = t_right_thigh_12 - (0.00406285432 + E_right_thigh_yy);
  const Scalar t_right_thigh_13 = h_right_shank_y - 0.0014731530912 * c_right_shank;
  const Scalar h_right_thigh_y = t_right_thigh_13 + 0.0362798116128 * s_right_shank;
  const Scalar t_right_thigh_14 = h_right_shank_x + 0.0014731530912 * s_right_shank;
  const Scalar h_right_thigh_x = t_right_thigh_14 + 0.0362798116128 * c_right_shank;
  const Scalar t_right_thigh_15 = c_right_thigh * h_right_thigh_y;
  const Scalar h_right_hip_fork_z = t_right_thigh_15 - s_right_thigh * h_right_thigh_x;
  const Scalar t_right_hip_block_2 = E_right_hip_fork_xx - t_right_hip_block_1;
  const Scalar t_right_hip_block_3 = t_right_hip_block_2 + 2.0 * h_right_hip_fork_z;
  const Scalar t_right_foot_23 = 6.298136129784905e-05 * c_right_foot;
  const Scalar t_right_foot_24 = t_right_foot_23 + 0.0014494177603079786 * s_right_foot;
  A[131] = t_right_foot_24;
  A[142] = A[131];
  // right_ankle_cross
  const Scalar E_righ_ankl_cros_yz = 0.001106309568 + t_right_foot_24;
  const Scalar h_righ_ankl_cros_z = 0.00014128635491404698 * s_right_foot;
  const Scalar t_righ_ankl_cros_4 = s_righ_ankl_cros_y * h_righ_ankl_cros_z;
  // right_shank
  const Scalar t_right_shank_8 = E_righ_ankl_cros_yz + t_righ_ankl_cros_4;
  const Scalar t_right_shank_9 = t_right_shank_8 - 0.001559822240256 * c_right_ankle_pitch;
  const Scalar E_right_shank_yz = t_right_shank_9 + 0.02565802580712 * s_right_ankle_pitch;
  const Scalar t_right_shank_10 = s_right_shank_y * h_righ_ankl_cros_z;
  // right_thigh
  const Scalar t_right_thigh_16 = E_right_shank_yz + t_right_shank_10;
  const Scalar t_right_thigh_17 = t_right_thigh_16 - 0.00442555309711872 * c_right_shank;
  const Scalar E_right_thigh_yz = t_right_thigh_17 + 0.09232168197063167 * s_right_shank;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_5 = 0.00016012430367330226 + h_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_6 = t_right_foot_12 + t_righ_ankl_cros_5;
  const Scalar E_righ_ankl_cros_xz = t_righ_ankl_cros_6 + c_right_foot * t_right_foot_10;
  const Scalar t_right_foot_25 = 0.001559822240256 * s_right_ankle_pitch;
  // right_shank
  const Scalar t_right_shank_11 = E_righ_ankl_cros_xz + t_right_foot_25;
  const Scalar t_right_shank_12 = t_right_shank_11 + 0.02565802580712 * c_right_ankle_pitch;
  const Scalar E_right_shank_xz = t_right_shank_12 + s_righ_ankl_cros_x * h_righ_ankl_cros_z;
  // right_thigh
  const Scalar t_right_thigh_18 = E_right_shank_xz + 0.00442555309711872 * s_right_shank;
  const Scalar t_right_thigh_19 = t_right_thigh_18 + 0.09232168197063167 * c_right_shank;
  const Scalar E_right_thigh_xz = t_right_thigh_19 + s_right_shank_x * h_righ_ankl_cros_z;
  const Scalar t_right_thigh_20 = s_right_thigh * E_right_thigh_yz;
  const Scalar t_right_thigh_21 = t_right_thigh_20 + c_right_thigh * E_right_thigh_xz;
  // right_hip_fork
  const Scalar E_right_hip_fork_xy = 8.079624e-05 + t_right_thigh_21;
  const Scalar s_right_hip_roll = sin(q[7]);
  const Scalar c_right_hip_roll = cos(q[7]);
  const Scalar t_right_hip_fork_1 = 0.030379399648709733 + t_right_foot_11;
  const Scalar t_right_foot_26 = 0.0005651454196561879 * s_right_foot;
  const Scalar E_right_hip_fork_yy = t_right_hip_fork_1 + t_right_foot_26;
  const Scalar t_right_hip_fork_2 = E_right_hip_fork_xx - E_right_hip_fork_yy;
  const Scalar t_right_hip_fork_3 = s_right_hip_roll * E_right_hip_fork_xy * 2.0;
  const Scalar t_right_hip_fork_4 = c_right_hip_roll * t_right_hip_fork_2;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_3 + t_right_hip_fork_4;
  A[78] = t_right_hip_block_3 - c_right_hip_roll * t_right_hip_fork_5;
  const Scalar t_right_thigh_22 = c_right_thigh * E_right_thigh_yz;
  const Scalar t_right_thigh_23 = t_right_thigh_22 - s_right_thigh * E_right_thigh_xz;
  A[92] = t_right_thigh_23;
  A[103] = A[92];
  const Scalar E_right_hip_fork_yz = 0.0042631913856 + h_righ_ankl_cros_z + t_right_thigh_23;
  const Scalar t_right_thigh_24 = s_right_thigh * h_right_thigh_y;
  const Scalar t_right_hip_fork_6 = c_right_thigh * (h_right_thigh_x + t_right_thigh_11);
  const Scalar t_right_hip_fork_7 = 0.00011406528 - E_right_thigh_xy + t_right_thigh_24;
  const Scalar E_right_hip_fork_xz = t_right_hip_fork_7 + t_right_hip_fork_6;
  const Scalar t_right_hip_fork_8 = s_right_hip_roll * E_right_hip_fork_yz;
  A[79] = t_right_hip_fork_8 + c_right_hip_roll * E_right_hip_fork_xz;
  A[90] = A[79];
  const Scalar t_right_thigh_25 = E_right_thigh_xx + E_right_thigh_yy;
  A[104] = t_right_thigh_25;
  const Scalar t_right_thigh_26 = t_right_thigh_25 + h_right_hip_fork_z;
  A[80] = s_right_hip_roll * t_right_thigh_26 - c_right_hip_roll * t_right_thigh_21;
  A[102] = A[80];
  const Scalar t_right_thigh_27 = s_right_thigh * E_right_shank_yz;
  const Scalar t_right_thigh_28 = t_right_thigh_27 + c_right_thigh * E_right_shank_xz;
  const Scalar t_right_shank_13 = E_right_shank_xx + E_right_shank_yy;
  A[117] = t_right_shank_13;
  const Scalar t_right_shank_14 = t_right_shank_13 + t_right_shank_4 + t_right_shank_7;
  A[105] = t_right_shank_14;
  A[116] = A[105];
  const Scalar t_right_thigh_29 = t_right_shank_14 - s_right_thigh * h_right_shank_x;
  const Scalar t_right_thigh_30 = t_right_thigh_29 + c_right_thigh * h_right_shank_y;
  A[81] = s_right_hip_roll * t_right_thigh_30 - c_right_hip_roll * t_right_thigh_28;
  A[114] = A[81];
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_7 = 0.0070975881429152 + t_righ_ankl_cros_1;
  A[130] = t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_7 + t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_9 = 0.0238512154272 * s_right_ankle_pitch;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_8 + t_righ_ankl_cros_9;
  A[118] = t_righ_ankl_cros_10;
  A[129] = A[118];
  const Scalar t_right_shank_15 = t_righ_ankl_cros_10 + 0.0237961317888 * s_right_shank;
  const Scalar t_right_shank_16 = t_right_shank_15 + s_right_shank_x * h_righ_ankl_cros_x;
  A[106] = t_right_shank_16;
  A[128] = A[106];
  // right_thigh
  const Scalar t_right_thigh_31 = t_right_shank_16 - s_right_thigh * h_righ_ankl_cros_x;
  const Scalar t_right_thigh_32 = t_right_thigh_31 + 0.000550836384 * c_right_thigh;
  const Scalar t_right_thigh_33 = s_right_thigh * E_righ_ankl_cros_yz;
  const Scalar t_right_thigh_34 = t_right_thigh_33 + c_right_thigh * E_righ_ankl_cros_xz;
  A[82] = s_right_hip_roll * t_right_thigh_32 - c_right_hip_roll * t_right_thigh_34;
  A[126] = A[82];
  const Scalar t_righ_ankl_cros_11 = t_right_foot_24 + t_righ_ankl_cros_4;
  A[119] = t_righ_ankl_cros_11;
  A[141] = A[119];
  const Scalar t_right_shank_17 = t_righ_ankl_cros_11 + t_right_shank_10;
  A[107] = t_right_shank_17;
  A[140] = A[107];
  const Scalar t_right_thigh_35 = t_right_shank_17 + c_right_thigh * h_righ_ankl_cros_z;
  // right_shank
  const Scalar t_right_shank_18 = t_right_foot_17 * (s_right_shank_y + s_righ_ankl_cros_y);
  const Scalar t_right_shank_19 = t_right_foot_22 - t_right_shank_18;
  const Scalar t_right_shank_20 = 1.0 + s_right_shank_x + s_righ_ankl_cros_x;
  const Scalar t_right_shank_21 = 0.0009809787164016 + 0.00028257270982809396 * s_right_foot;
  const Scalar t_right_shank_22 = t_right_shank_21 + t_right_foot_17 * t_right_shank_20;
  const Scalar t_right_thigh_36 = t_right_foot_17 - s_right_thigh * t_right_shank_22;
  const Scalar t_right_thigh_37 = t_right_thigh_36 - c_right_thigh * t_right_shank_19;
  A[83] = s_right_hip_roll * t_right_thigh_35 + c_right_hip_roll * t_right_thigh_37;
  A[138] = A[83];
  A[91] = E_right_hip_fork_xx + E_right_hip_fork_yy;
  // right_thigh
  A[93] = c_right_thigh * E_right_shank_yz - s_right_thigh * E_right_shank_xz;
  A[115] = A[93];
  A[94] = c_right_thigh * E_righ_ankl_cros_yz - s_right_thigh * E_righ_ankl_cros_xz;
  A[127] = A[94];
  A[95] = c_right_thigh * t_right_shank_22 - s_right_thigh * t_right_shank_19;
  A[139] = A[95];
  A[65] = 0.0009809787164016;
  A[143] = 0.0009809787164016;
  A[6] = 0.0;
  A[7] = 0.0;
  A[8] = 0.0;
  A[9] = 0.0;
  A[10] = 0.0;
  A[11] = 0.0;
  A[18] = 0.0;
  A[19] = 0.0;
  A[20] = 0.0;
  A[21] = 0.0;
  A[22] = 0.0;
  A[23] = 0.0;
  A[30] = 0.0;
  A[31] = 0.0;
  A[32] = 0.0;
  A[33] = 0.0;
  A[34] = 0.0;
  A[35] = 0.0;
  A[42] = 0.0;
  A[43] = 0.0;
  A[44] = 0.0;
  A[45] = 0.0;
  A[46] = 0.0;
  A[47] = 0.0;
  A[54] = 0.0;
  A[55] = 0.0;
  A[56] = 0.0;
  A[57] = 0.0;
  A[58] = 0.0;
  A[59] = 0.0;
  A[66] = 0.0;
  A[67] = 0.0;
  A[68] = 0.0;
  A[69] = 0.0;
  A[70] = 0.0;
  A[71] = 0.0;
  A[72] = 0.0;
  A[73] = 0.0;
  A[74] = 0.0;
  A[75] = 0.0;
  A[76] = 0.0;
  A[77] = 0.0;
  A[84] = 0.0;
  A[85] = 0.0;
  A[86] = 0.0;
  A[87] = 0.0;
  A[88] = 0.0;
  A[89] = 0.0;
  A[96] = 0.0;
  A[97] = 0.0;
  A[98] = 0.0;
  A[99] = 0.0;
  A[100] = 0.0;
  A[101] = 0.0;
  A[108] = 0.0;
  A[109] = 0.0;
  A[110] = 0.0;
  A[111] = 0.0;
  A[112] = 0.0;
  A[113] = 0.0;
  A[120] = 0.0;
  A[121] = 0.0;
  A[122] = 0.0;
  A[123] = 0.0;
  A[124] = 0.0;
  A[125] = 0.0;
  A[132] = 0.0;
  A[133] = 0.0;
  A[134] = 0.0;
  A[135] = 0.0;
  A[136] = 0.0;
  A[137] = 0.0;
}

namespace {

[[gnu::noinline]] void bias_force_1(const Scalar q[12], const Scalar qd[12],
                                    Scalar B[12]) noexcept {
  const Scalar t_left_shank_1 = q[3] + q[4];
  // left_thigh
  const Scalar t_left_thigh_1 = q[2] + t_left_shank_1;
  const Scalar c_left_thigh = cos(t_left_thigh_1);
  const Scalar s_left_thigh = sin(t_left_thigh_1);
  const Scalar c_left_hip_roll = cos(q[1]);
  const Scalar s_left_hip_roll = sin(q[1]);
  const Scalar t_left_thigh_2 = c_left_hip_roll * qd[0];
  const Scalar omega_left_thigh_x = s_left_thigh * qd[1] + c_left_thigh * t_left_thigh_2;
  const Scalar t_left_thigh_3 = omega_left_thigh_x * omega_left_thigh_x;
  const Scalar omega_left_thigh_y = c_left_thigh * qd[1] - s_left_thigh * t_left_thigh_2;
  // left_foot
  const Scalar omega_left_foot_z = omega_left_thigh_y + qd[5];
  const Scalar t_left_foot_1 = omega_left_foot_z * omega_left_foot_z;
  const Scalar t_left_foot_2 = t_left_thigh_3 - t_left_foot_1;
  const Scalar omega_left_thigh_z = qd[2] + s_left_hip_roll * qd[0];
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  // left_ankle_cross
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_1 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_2 = t_left_thigh_3 + t_left_ankle_cross_1;
  // left_foot
  const Scalar Omega_left_foot_xx = t_left_ankle_cross_2 - t_left_foot_2;
  const Scalar Omega_left_foot_yy = t_left_thigh_3 + t_left_foot_1;
  const Scalar t_left_foot_3 = 0.2614691411136524 + q[5];
  const Scalar c_left_foot = cos(t_left_foot_3);
  const Scalar s_left_foot = sin(t_left_foot_3);
  const Scalar t_left_foot_4 = 0.00013282817963685661 * s_left_foot;
  const Scalar t_left_foot_5 = 7.233379265339546e-05 * c_left_foot + t_left_foot_4;
  const Scalar t_left_foot_6 = 3.616689632669773e-05 - c_left_foot * t_left_foot_5;
  const Scalar t_left_foot_7 = t_left_foot_6 * (Omega_left_foot_xx - Omega_left_foot_yy);
  const Scalar alpha_left_hip_fork_x = qd[0] * qd[1];
  // left_thigh
  const Scalar t_left_thigh_4 = s_left_hip_roll * alpha_left_hip_fork_x;
  const Scalar t_left_thigh_5 = s_left_thigh * t_left_thigh_4;
  const Scalar alpha_left_thigh_y = t_left_thigh_5 - omega_left_thigh_x * qd[2];
  const Scalar t_left_thigh_6 = omega_left_thigh_x * omega_left_thigh_z;
  const Scalar Omega_left_thigh_xz = alpha_left_thigh_y + t_left_thigh_6;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_3 = omega_left_thigh_x * omega_left_ankle_cross_z;
  const Scalar alpha_left_ankle_cross_y = Omega_left_thigh_xz - t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_4 = t_left_ankle_cross_3 - alpha_left_ankle_cross_y;
  const Scalar t_left_foot_8 = s_left_foot * t_left_foot_5;
  const Scalar t_left_foot_9 = 0.0005569034480192284 - t_left_foot_8;
  // left_thigh
  const Scalar t_left_thigh_7 = c_left_thigh * t_left_thigh_4;
  const Scalar alpha_left_thigh_x = t_left_thigh_7 - omega_left_thigh_y * qd[2];
  const Scalar t_left_thigh_8 = omega_left_thigh_y * omega_left_thigh_z;
  const Scalar Omega_left_thigh_yz = alpha_left_thigh_x + t_left_thigh_8;
  const Scalar t_left_shank_2 = 2.0 * omega_left_thigh_y;
  const Scalar t_left_ankle_cross_5 = t_left_shank_2 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_6 = Omega_left_thigh_yz - t_left_ankle_cross_5;
  // left_foot
  const Scalar t_left_foot_10 = 6.298136129784905e-05 * s_left_foot;
  const Scalar t_left_foot_11 = t_left_foot_10 - 0.0014494177603079786 * c_left_foot;
  const Scalar t_left_foot_12 = t_left_ankle_cross_4 * t_left_foot_9;
  // left_thigh
  const Scalar t_left_thigh_9 = omega_left_thigh_x * omega_left_thigh_y;
  const Scalar alpha_left_thigh_z = c_left_hip_roll * alpha_left_hip_fork_x;
  const Scalar Omega_left_thigh_xy = alpha_left_thigh_z - t_left_thigh_9;
  // left_foot
  const Scalar t_left_foot_13 = 6.298136129784905e-05 * c_left_foot;
  const Scalar t_left_foot_14 = t_left_foot_13 + 0.0014494177603079786 * s_left_foot;
  const Scalar t_left_foot_15 = t_left_foot_12 - t_left_ankle_cross_6 * t_left_foot_11;
  const Scalar Omega_left_thigh_xz_2 = t_left_ankle_cross_3 + alpha_left_ankle_cross_y;
  const Scalar t_left_foot_16 = 0.0004240752683823717 + t_left_foot_8;
  const Scalar t_left_foot_17 = t_left_foot_15 + Omega_left_thigh_xy * t_left_foot_14;
  const Scalar t_left_foot_18 = t_left_foot_17 - Omega_left_thigh_xz_2 * t_left_foot_16;
  const Scalar t_left_foot_19 = t_left_foot_18 + t_left_foot_7;
  // left_shank
  const Scalar s_left_shank = sin(t_left_shank_1);
  const Scalar c_left_shank = cos(t_left_shank_1);
  const Scalar s_left_shank_y = 43.2 * s_left_shank;
  const Scalar Omega_left_hip_block_xx = qd[0] * qd[0];
  // left_thigh
  const Scalar a_left_thigh_x = s_left_thigh * Omega_left_hip_block_xx;
  const Scalar t_left_thigh_10 = omega_left_thigh_y * omega_left_thigh_y;
  const Scalar t_left_thigh_11 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar Omega_left_thigh_xx = t_left_thigh_10 + t_left_thigh_11;
  // left_shank
  const Scalar s_left_shank_x = 43.2 * c_left_shank;
  const Scalar t_left_shank_3 = a_left_thigh_x + s_left_shank_y * Omega_left_thigh_xy;
  const Scalar a_left_shank_x = t_left_shank_3 - s_left_shank_x * Omega_left_thigh_xx;
  // left_ankle_cross
  const Scalar s_left_ankle_pitch = sin(q[4]);
  const Scalar c_left_ankle_pitch = cos(q[4]);
  const Scalar s_left_ankle_cross_y = 43.3 * s_left_ankle_pitch;
  const Scalar t_left_ankle_cross_7 = s_left_ankle_cross_y * Omega_left_thigh_xy;
  const Scalar t_left_shank_4 = omega_left_shank_z * omega_left_shank_z;
  const Scalar Omega_left_shank_xx = t_left_thigh_10 + t_left_shank_4;
  const Scalar s_left_ankle_cross_x = 43.3 * c_left_ankle_pitch;
  const Scalar t_left_ankle_cross_8 = s_left_ankle_cross_x * Omega_left_shank_xx;
  const Scalar t_left_ankle_cross_9 = a_left_shank_x + t_left_ankle_cross_7;
  const Scalar a_left_ankle_cross_x = t_left_ankle_cross_9 - t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_10 = t_left_thigh_10 + t_left_ankle_cross_1;
  // left_foot
  const Scalar t_left_foot_20 = a_left_ankle_cross_x - t_left_ankle_cross_10;
  const Scalar a_left_foot_x = t_left_foot_20 - 2.0 * Omega_left_thigh_xz;
  const Scalar t_left_foot_21 = 0.00014128635491404698 * s_left_foot;
  const Scalar Omega_left_thigh_zy = alpha_left_thigh_x - t_left_thigh_8;
  const Scalar Omega_left_thigh_zx = alpha_left_thigh_y - t_left_thigh_6;
  // left_shank
  const Scalar t_left_shank_5 = s_left_shank_y * Omega_left_thigh_zy;
  const Scalar a_left_shank_z = t_left_shank_5 - s_left_shank_x * Omega_left_thigh_zx;
  const Scalar t_left_shank_6 = omega_left_shank_z * t_left_shank_2;
  const Scalar Omega_left_shank_zy = Omega_left_thigh_yz - t_left_shank_6;
  const Scalar t_left_ankle_cross_11 = s_left_ankle_cross_y * Omega_left_shank_zy;
  const Scalar t_left_shank_7 = 2.0 * omega_left_thigh_x;
  const Scalar t_left_shank_8 = omega_left_shank_z * t_left_shank_7;
  const Scalar Omega_left_shank_zx = Omega_left_thigh_xz - t_left_shank_8;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_12 = s_left_ankle_cross_x * Omega_left_shank_zx;
  const Scalar t_left_ankle_cross_13 = a_left_shank_z + t_left_ankle_cross_11;
  const Scalar a_left_ankle_cross_z = t_left_ankle_cross_13 - t_left_ankle_cross_12;
  const Scalar Omega_left_thigh_zz = t_left_thigh_3 + t_left_thigh_10;
  // left_foot
  const Scalar t_left_foot_22 = a_left_ankle_cross_z + t_left_ankle_cross_4;
  const Scalar a_left_foot_y = t_left_foot_22 + 2.0 * Omega_left_thigh_zz;
  const Scalar t_left_foot_23 = 0.00014128635491404698 * c_left_foot;
  const Scalar t_left_foot_24 = t_left_foot_19 + a_left_foot_x * t_left_foot_21;
  const Scalar M_left_foot_z = t_left_foot_24 + a_left_foot_y * t_left_foot_23;
  B[5] = -M_left_foot_z;
  const Scalar t_left_foot_25 = Omega_left_foot_yy * t_left_foot_21;
  const Scalar t_left_foot_26 = 9.4668e-05 * a_left_foot_y + t_left_foot_25;
  const Scalar F_left_foot_y = t_left_foot_26 + t_left_ankle_cross_4 * t_left_foot_23;
  // left_thigh
  const Scalar t_left_thigh_12 = 0.03939173998083072 * c_left_shank;
  const Scalar t_left_thigh_13 = t_left_thigh_12 - 1.1033955042453505 * s_left_shank;
  const Scalar t_left_thigh_14 = 0.01969586999041536 - c_left_shank * t_left_thigh_13;
  const Scalar t_left_thigh_15 = Omega_left_thigh_zy * t_left_thigh_14;
  const Scalar t_left_thigh_16 = s_left_shank * t_left_thigh_13;
  const Scalar t_left_thigh_17 = 1.1280459976898918 + t_left_thigh_16;
  const Scalar t_left_thigh_18 = F_left_foot_y + M_left_foot_z + t_left_thigh_15;
  const Scalar t_left_thigh_19 = 0.00442555309711872 * s_left_shank;
  const Scalar t_left_thigh_20 = t_left_thigh_19 + 0.08414236677063168 * c_left_shank;
  const Scalar t_left_thigh_21 = Omega_left_thigh_xx - Omega_left_thigh_zz;
  const Scalar t_left_thigh_22 = t_left_thigh_18 - Omega_left_thigh_zx * t_left_thigh_17;
  // left_shank
  const Scalar t_left_shank_9 = 0.173287335213216 * s_left_ankle_pitch;
  const Scalar t_left_shank_10 = 0.03083291102976 * c_left_ankle_pitch - t_left_shank_9;
  const Scalar t_left_shank_11 = 0.01541645551488 - c_left_ankle_pitch * t_left_shank_10;
  const Scalar t_left_thigh_23 = t_left_thigh_22 - t_left_thigh_21 * t_left_thigh_20;
  const Scalar t_left_shank_12 = s_left_ankle_pitch * t_left_shank_10;
  const Scalar t_left_shank_13 = 0.178578772764 + t_left_shank_12;
  const Scalar t_left_thigh_24 = t_left_thigh_23 + Omega_left_shank_zy * t_left_shank_11;
  const Scalar t_left_shank_14 = 0.001559822240256 * s_left_ankle_pitch;
  const Scalar t_left_shank_15 = t_left_shank_14 + 0.01745977700712 * c_left_ankle_pitch;
  const Scalar t_left_shank_16 = Omega_left_thigh_zz - Omega_left_shank_xx;
  const Scalar t_left_thigh_25 = t_left_thigh_24 - Omega_left_shank_zx * t_left_shank_13;
  const Scalar t_left_shank_17 = 0.00080309376 * s_left_ankle_pitch;
  const Scalar t_left_shank_18 = t_left_shank_17 + 0.0069434148 * c_left_ankle_pitch;
  // left_thigh
  const Scalar t_left_thigh_26 = t_left_thigh_25 + t_left_shank_16 * t_left_shank_15;
  const Scalar t_left_thigh_27 = t_left_thigh_26 + a_left_shank_z * t_left_shank_18;
  const Scalar t_left_thigh_28 = t_left_thigh_27 + 0.000549677184 * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_14 = Omega_left_thigh_zz - t_left_ankle_cross_10;
  const Scalar t_left_thigh_29 = t_left_thigh_28 + 2.40212e-05 * t_left_ankle_cross_4;
  // left_foot
  const Scalar t_left_foot_27 = Omega_left_thigh_xz_2 * t_left_foot_21;
  const Scalar t_left_foot_28 = 9.4668e-05 * a_left_foot_x - t_left_foot_27;
  const Scalar F_left_foot_x = t_left_foot_28 - Omega_left_foot_xx * t_left_foot_23;
  const Scalar t_left_thigh_30 = t_left_thigh_29 + 6.9552e-06 * t_left_ankle_cross_14;
  const Scalar F_left_ankle_cross_z = F_left_foot_y + 0.000550836384 * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_15 = s_left_ankle_cross_x * F_left_ankle_cross_z;
  const Scalar t_left_thigh_31 = t_left_thigh_30 + 2.0 * F_left_foot_x;
  // left_shank
  const Scalar t_left_shank_19 = 0.00080309376 * c_left_ankle_pitch;
  const Scalar t_left_shank_20 = t_left_shank_19 - 0.0069434148 * s_left_ankle_pitch;
  const Scalar t_left_shank_21 = Omega_left_shank_zy * t_left_shank_20;
  const Scalar t_left_shank_22 = F_left_ankle_cross_z - t_left_shank_21;
  const Scalar F_left_shank_z = t_left_shank_22 - Omega_left_shank_zx * t_left_shank_18;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + t_left_ankle_cross_15;
  const Scalar t_left_shank_23 = 0.001559822240256 * c_left_ankle_pitch;
  const Scalar t_left_shank_24 = t_left_shank_23 - 0.01745977700712 * s_left_ankle_pitch;
  // left_thigh
  const Scalar t_left_thigh_33 = 0.00442555309711872 * c_left_shank;
  const Scalar t_left_thigh_34 = t_left_thigh_33 - 0.08414236677063168 * s_left_shank;
  const Scalar t_left_thigh_35 = t_left_shank_24 - (0.001106309568 - t_left_thigh_34);
  const Scalar t_left_thigh_36 = t_left_thigh_32 + s_left_shank_x * F_left_shank_z;
  const Scalar M_left_thigh_y = t_left_thigh_36 - Omega_left_thigh_xy * t_left_thigh_35;
  const Scalar t_left_thigh_37 = 0.0014731530912 * c_left_shank;
  const Scalar t_left_thigh_38 = t_left_thigh_37 - 0.0321901540128 * s_left_shank;
  const Scalar t_left_thigh_39 = 0.0014731530912 * s_left_shank;
  const Scalar t_left_thigh_40 = t_left_thigh_39 + 0.0321901540128 * c_left_shank;
  const Scalar t_left_thigh_41 = F_left_shank_z - Omega_left_thigh_zy * t_left_thigh_38;
  const Scalar F_left_thigh_z = t_left_thigh_41 - Omega_left_thigh_zx * t_left_thigh_40;
  const Scalar t_left_hip_fork_1 = F_left_thigh_z - s_left_thigh * M_left_thigh_y;
  const Scalar t_left_thigh_42 = 0.02465049344454144 - t_left_thigh_16;
  const Scalar t_left_thigh_43 = Omega_left_thigh_zy * t_left_thigh_42;
  const Scalar Omega_left_thigh_yy = t_left_thigh_3 + t_left_thigh_11;
  const Scalar t_left_thigh_44 = Omega_left_thigh_yy - Omega_left_thigh_zz;
  const Scalar t_left_thigh_45 = t_left_thigh_43 - Omega_left_thigh_zx * t_left_thigh_14;
  const Scalar t_left_shank_25 = 0.005291437550784 - t_left_shank_12;
  const Scalar t_left_thigh_46 = t_left_thigh_45 + t_left_thigh_34 * t_left_thigh_44;
  const Scalar t_left_thigh_47 = t_left_thigh_46 + Omega_left_shank_zy * t_left_shank_25;
  const Scalar Omega_left_shank_yy = t_left_thigh_3 + t_left_shank_4;
  const Scalar t_left_shank_26 = Omega_left_thigh_zz - Omega_left_shank_yy;
  const Scalar t_left_thigh_48 = t_left_thigh_47 - Omega_left_shank_zx * t_left_shank_11;
  const Scalar t_left_thigh_49 = t_left_thigh_48 - t_left_shank_24 * t_left_shank_26;
  const Scalar t_left_thigh_50 = t_left_thigh_49 - a_left_shank_z * t_left_shank_20;
  const Scalar t_left_ankle_cross_16 = 0.0069788989429152 * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_17 = Omega_left_thigh_zz - t_left_ankle_cross_2;
  const Scalar t_left_thigh_51 = t_left_thigh_50 + t_left_ankle_cross_16;
  const Scalar t_left_thigh_52 = t_left_thigh_51 + 0.001106309568 * t_left_ankle_cross_17;
  const Scalar t_left_foot_29 = omega_left_ankle_cross_z * omega_left_foot_z * 2.0;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_6 + t_left_foot_29;
  const Scalar t_left_thigh_53 = t_left_thigh_52 + 0.000550836384 * a_left_ankle_cross_z;
  const Scalar t_left_foot_30 = t_left_shank_7 * omega_left_foot_z;
  const Scalar Omega_left_foot_zx = Omega_left_thigh_xy + t_left_foot_30;
  const Scalar t_left_thigh_54 = t_left_thigh_53 + Omega_left_foot_zy * t_left_foot_16;
  const Scalar t_left_foot_31 = t_left_ankle_cross_2 - Omega_left_foot_yy;
  const Scalar t_left_thigh_55 = t_left_thigh_54 + Omega_left_foot_zx * t_left_foot_6;
  const Scalar a_left_thigh_y = c_left_thigh * Omega_left_hip_block_xx;
  const Scalar Omega_left_thigh_yx = alpha_left_thigh_z + t_left_thigh_9;
  const Scalar t_left_shank_27 = a_left_thigh_y + s_left_shank_y * Omega_left_thigh_yy;
  const Scalar a_left_shank_y = t_left_shank_27 + s_left_shank_x * Omega_left_thigh_yx;
  const Scalar t_left_ankle_cross_18 = s_left_ankle_cross_y * Omega_left_shank_yy;
  const Scalar t_left_foot_32 = Omega_left_thigh_yx + a_left_shank_y;
  const Scalar t_left_ankle_cross_19 = s_left_ankle_cross_x * Omega_left_thigh_yx;
  // left_foot
  const Scalar t_left_foot_33 = t_left_foot_32 + t_left_ankle_cross_18;
  const Scalar t_left_foot_34 = t_left_foot_33 + t_left_ankle_cross_19;
  const Scalar a_left_foot_z = t_left_foot_34 - 2.0 * Omega_left_thigh_yz;
  const Scalar t_left_thigh_56 = t_left_thigh_55 - t_left_foot_14 * t_left_foot_31;
  const Scalar t_left_foot_35 = Omega_left_foot_zy * t_left_foot_21;
  const Scalar t_left_foot_36 = 9.4668e-05 * a_left_foot_z - t_left_foot_35;
  const Scalar F_left_foot_z = t_left_foot_36 + Omega_left_foot_zx * t_left_foot_23;
  const Scalar t_left_thigh_57 = t_left_thigh_56 - a_left_foot_z * t_left_foot_21;
  const Scalar t_left_ankle_cross_20 = s_left_ankle_cross_y * F_left_ankle_cross_z;
  // left_thigh
  const Scalar t_left_thigh_58 = t_left_thigh_57 - 2.0 * F_left_foot_z;
  const Scalar t_left_thigh_59 = t_left_thigh_58 + t_left_ankle_cross_20;
  const Scalar t_left_thigh_60 = 6.9552e-06 + t_left_thigh_20 + t_left_shank_15;
  const Scalar t_left_thigh_61 = t_left_thigh_59 + s_left_shank_y * F_left_shank_z;
  const Scalar t_left_thigh_62 = t_left_thigh_61 - Omega_left_thigh_yx * t_left_thigh_60;
  const Scalar t_left_thigh_63 = t_left_ankle_cross_4 * (0.000549677184 - t_left_foot_11);
  const Scalar M_left_thigh_x = t_left_thigh_62 + t_left_thigh_63;
  // left_hip_fork
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + c_left_thigh * M_left_thigh_x;
  const Scalar t_left_hip_fork_3 = 0.02931050006032736 * c_left_hip_roll;
  const Scalar t_left_hip_fork_4 = 0.00016159248 * s_left_hip_roll + t_left_hip_fork_3;
  const Scalar t_left_hip_fork_5 = 8.079624e-05 - s_left_hip_roll * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = 0.0040738553856 * c_left_hip_roll;
  const Scalar Omega_left_hip_fork_yy = qd[1] * qd[1];
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_6 + 0.00011406528 * s_left_hip_roll;
  const Scalar t_left_hip_fork_8 = alpha_left_hip_fork_x * t_left_hip_fork_5 * 2.0;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_7 * Omega_left_hip_fork_yy;
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_8 - t_left_hip_fork_9;
  const Scalar t_left_hip_fork_11 = c_left_hip_roll * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_10 - t_left_hip_fork_11;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_21 = F_left_foot_z + 2.40212e-05 * Omega_left_thigh_yx;
  const Scalar t_left_ankle_cross_22 = 6.9552e-06 * Omega_left_thigh_yz;
  const Scalar t_left_ankle_cross_23 = t_left_ankle_cross_21 - t_left_ankle_cross_22;
  const Scalar t_left_ankle_cross_24 = 0.001106309568 * Omega_left_thigh_xz;
  const Scalar t_left_ankle_cross_25 = t_left_ankle_cross_23 - t_left_ankle_cross_24;
  const Scalar t_left_ankle_cross_26 = 0.0069788989429152 * Omega_left_thigh_xy;
  const Scalar t_left_thigh_64 = t_left_ankle_cross_10 - t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_27 = t_left_ankle_cross_25 + t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_28 = 0.000549677184 * t_left_thigh_64;
  const Scalar t_left_ankle_cross_29 = t_left_ankle_cross_27 - t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_30 = 0.000550836384 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_31 = t_left_ankle_cross_29 + t_left_ankle_cross_30;
  const Scalar t_left_foot_37 = Omega_left_thigh_xz_2 * t_left_foot_14;
  const Scalar t_left_ankle_cross_32 = t_left_ankle_cross_31 - t_left_foot_37;
  const Scalar t_left_foot_38 = Omega_left_foot_zy * t_left_foot_6;
  const Scalar t_left_ankle_cross_33 = t_left_ankle_cross_32 + t_left_foot_38;
  const Scalar t_left_foot_39 = Omega_left_foot_zx * t_left_foot_9;
  const Scalar t_left_ankle_cross_34 = t_left_ankle_cross_33 + t_left_foot_39;
  const Scalar t_left_foot_40 = t_left_foot_2 * t_left_foot_11;
  const Scalar t_left_ankle_cross_35 = t_left_ankle_cross_34 - t_left_foot_40;
  const Scalar t_left_foot_41 = a_left_foot_z * t_left_foot_23;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_35 + t_left_foot_41;
  B[4] = M_left_ankle_cross_z;
  // left_shank
  const Scalar t_left_shank_28 = Omega_left_thigh_yx * t_left_shank_13;
  const Scalar t_left_shank_29 = M_left_ankle_cross_z + t_left_shank_28;
  const Scalar t_left_shank_30 = t_left_shank_29 - Omega_left_thigh_yz * t_left_shank_15;
  const Scalar t_left_shank_31 = t_left_shank_30 + Omega_left_thigh_xz * t_left_shank_24;
  const Scalar t_left_thigh_65 = Omega_left_shank_xx - Omega_left_shank_yy;
  const Scalar t_left_shank_32 = t_left_shank_31 + Omega_left_thigh_xy * t_left_shank_25;
  const Scalar t_left_shank_33 = t_left_shank_32 - t_left_shank_11 * t_left_thigh_65;
  const Scalar t_left_shank_34 = t_left_shank_33 - a_left_shank_x * t_left_shank_20;
  const Scalar F_left_ankle_cross_x = F_left_foot_x + 0.000550836384 * Omega_left_thigh_xy;
  const Scalar t_left_shank_35 = t_left_shank_34 + a_left_shank_y * t_left_shank_18;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_36 = s_left_ankle_cross_y * F_left_ankle_cross_x;
  const Scalar F_left_ankle_cross_y = F_left_foot_z + 0.000550836384 * t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_37 = s_left_ankle_cross_x * F_left_ankle_cross_y;
  const Scalar t_left_shank_36 = t_left_shank_35 + t_left_ankle_cross_36;
  const Scalar M_left_shank_z = t_left_shank_36 + t_left_ankle_cross_37;
  B[3] = M_left_shank_z;
  // left_thigh
  const Scalar t_left_thigh_66 = M_left_shank_z + Omega_left_thigh_yx * t_left_thigh_17;
  const Scalar t_left_thigh_67 = t_left_thigh_66 - Omega_left_thigh_yz * t_left_thigh_20;
  const Scalar t_left_thigh_68 = t_left_thigh_67 + Omega_left_thigh_xz * t_left_thigh_34;
  const Scalar t_left_thigh_69 = Omega_left_thigh_xx - Omega_left_thigh_yy;
  const Scalar t_left_thigh_70 = t_left_thigh_68 + Omega_left_thigh_xy * t_left_thigh_42;
  const Scalar t_left_thigh_71 = t_left_thigh_70 - t_left_thigh_14 * t_left_thigh_69;
  const Scalar t_left_thigh_72 = t_left_thigh_71 - a_left_thigh_x * t_left_thigh_38;
  // left_shank
  const Scalar t_left_shank_37 = Omega_left_thigh_xy * t_left_shank_20;
  const Scalar t_left_shank_38 = F_left_ankle_cross_x - t_left_shank_37;
  const Scalar F_left_shank_x = t_left_shank_38 - Omega_left_shank_xx * t_left_shank_18;
  const Scalar t_left_thigh_73 = t_left_thigh_72 + a_left_thigh_y * t_left_thigh_40;
  const Scalar t_left_shank_39 = Omega_left_shank_yy * t_left_shank_20;
  const Scalar t_left_shank_40 = F_left_ankle_cross_y - t_left_shank_39;
  const Scalar F_left_shank_y = t_left_shank_40 + Omega_left_thigh_yx * t_left_shank_18;
  // left_thigh
  const Scalar t_left_thigh_74 = t_left_thigh_73 + s_left_shank_y * F_left_shank_x;
  const Scalar M_left_thigh_z = t_left_thigh_74 + s_left_shank_x * F_left_shank_y;
  B[2] = M_left_thigh_z;
  const Scalar t_left_thigh_75 = F_left_shank_y - Omega_left_thigh_yy * t_left_thigh_38;
  const Scalar F_left_thigh_y = t_left_thigh_75 + Omega_left_thigh_yx * t_left_thigh_40;
  const Scalar t_left_thigh_76 = F_left_shank_x - Omega_left_thigh_xy * t_left_thigh_38;
  const Scalar F_left_thigh_x = t_left_thigh_76 - Omega_left_thigh_xx * t_left_thigh_40;
  // left_hip_fork
  const Scalar t_left_hip_fork_13 = M_left_thigh_z - s_left_thigh * F_left_thigh_y;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_13 + c_left_thigh * F_left_thigh_x;
  B[0] = t_left_hip_fork_12 + s_left_hip_roll * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_15 = Omega_left_hip_block_xx * t_left_hip_fork_5;
  const Scalar t_left_hip_fork_16 = t_left_hip_fork_15 + c_left_thigh * M_left_thigh_y;
  B[1] = -(t_left_hip_fork_16 + s_left_thigh * M_left_thigh_x);
}

[[gnu::noinline]] void bias_force_2(const Scalar q[12], const Scalar qd[12],
                                    Scalar B[12]) noexcept {
  const Scalar t_right_shank_1 = q[9] + q[10];
  // right_thigh
  const Scalar t_right_thigh_1 = q[8] + t_right_shank_1;
  const Scalar c_right_thigh = cos(t_right_thigh_1);
  const Scalar s_right_thigh = sin(t_right_thigh_1);
  const Scalar c_right_hip_roll = cos(q[7]);
  const Scalar s_right_hip_roll = sin(q[7]);
  const Scalar t_right_thigh_2 = c_right_hip_roll * qd[6];
  const Scalar t_right_thigh_3 = c_right_thigh * t_right_thigh_2;
  const Scalar omega_right_thigh_x = s_right_thigh * qd[7] + t_right_thigh_3;
  const Scalar t_right_thigh_4 = omega_right_thigh_x * omega_right_thigh_x;
  const Scalar t_right_thigh_5 = s_right_thigh * t_right_thigh_2;
  const Scalar omega_right_thigh_y = c_right_thigh * qd[7] - t_right_thigh_5;
  // right_foot
  const Scalar omega_right_foot_z = omega_right_thigh_y + qd[11];
  const Scalar t_right_foot_1 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_2 = t_right_thigh_4 - t_right_foot_1;
  const Scalar omega_right_thigh_z = qd[8] + s_right_hip_roll * qd[6];
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  // right_ankle_cross
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_1 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_yy = t_right_thigh_4 + t_righ_ankl_cros_1;
  // right_foot
  const Scalar Omega_right_foot_xx = Omega_righ_ankl_cros_yy - t_right_foot_2;
  const Scalar Omega_right_foot_yy = t_right_thigh_4 + t_right_foot_1;
  const Scalar t_right_foot_3 = 0.2614691411136524 - q[11];
  const Scalar c_right_foot = cos(t_right_foot_3);
  const Scalar s_right_foot = sin(t_right_foot_3);
  const Scalar t_right_foot_4 = 0.00013282817963685661 * s_right_foot;
  const Scalar t_right_foot_5 = 7.233379265339546e-05 * c_right_foot + t_right_foot_4;
  const Scalar t_right_foot_6 = 3.616689632669773e-05 - c_right_foot * t_right_foot_5;
  const Scalar t_right_foot_7 = Omega_right_foot_xx - Omega_right_foot_yy;
  const Scalar t_right_foot_8 = t_right_foot_6 * t_right_foot_7;
  const Scalar alpha_right_hip_fork_x = qd[6] * qd[7];
  // right_thigh
  const Scalar t_right_thigh_6 = s_right_hip_roll * alpha_right_hip_fork_x;
  const Scalar t_right_thigh_7 = s_right_thigh * t_right_thigh_6;
  const Scalar alpha_right_thigh_y = t_right_thigh_7 - omega_right_thigh_x * qd[8];
  const Scalar t_right_thigh_8 = omega_right_thigh_x * omega_right_thigh_z;
  const Scalar Omega_right_thigh_xz = alpha_right_thigh_y + t_right_thigh_8;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_2 = omega_right_thigh_x * omega_righ_ankl_cros_z;
  const Scalar alpha_righ_ankl_cros_y = Omega_right_thigh_xz - t_righ_ankl_cros_2;
  const Scalar Omega_righ_ankl_cros_zx = t_righ_ankl_cros_2 - alpha_righ_ankl_cros_y;
  const Scalar t_right_foot_9 = s_right_foot * t_right_foot_5;
  const Scalar t_right_foot_10 = 0.0005569034480192284 - t_right_foot_9;
  // right_thigh
  const Scalar t_right_thigh_9 = c_right_thigh * t_right_thigh_6;
  const Scalar alpha_right_thigh_x = t_right_thigh_9 - omega_right_thigh_y * qd[8];
  const Scalar t_right_thigh_10 = omega_right_thigh_y * omega_right_thigh_z;
  const Scalar Omega_right_thigh_yz = alpha_right_thigh_x + t_right_thigh_10;
  const Scalar t_right_shank_2 = 2.0 * omega_right_thigh_y;
  const Scalar t_righ_ankl_cros_3 = t_right_shank_2 * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_zy = Omega_right_thigh_yz - t_righ_ankl_cros_3;
  // right_foot
  const Scalar t_right_foot_11 = 6.298136129784905e-05 * s_right_foot;
  const Scalar t_right_foot_12 = t_right_foot_11 - 0.0014494177603079786 * c_right_foot;
  const Scalar t_right_foot_13 = Omega_righ_ankl_cros_zx * t_right_foot_10;
  const Scalar t_right_foot_14 = Omega_righ_ankl_cros_zy * t_right_foot_12;
  // right_thigh
  const Scalar t_right_thigh_11 = omega_right_thigh_x * omega_right_thigh_y;
  const Scalar alpha_right_thigh_z = c_right_hip_roll * alpha_right_hip_fork_x;
  const Scalar Omega_right_thigh_xy = alpha_right_thigh_z - t_right_thigh_11;
  // right_foot
  const Scalar t_right_foot_15 = 6.298136129784905e-05 * c_right_foot;
  const Scalar t_right_foot_16 = t_right_foot_15 + 0.0014494177603079786 * s_right_foot;
  const Scalar t_right_foot_17 = Omega_right_thigh_xy * t_right_foot_16;
  const Scalar Omega_right_thigh_xz_2 = t_righ_ankl_cros_2 + alpha_righ_ankl_cros_y;
  const Scalar t_right_foot_18 = 0.0004240752683823717 + t_right_foot_9;
  const Scalar t_right_foot_19 = t_right_foot_13 - t_right_foot_14 - t_right_foot_17;
  const Scalar t_right_foot_20 = Omega_right_thigh_xz_2 * t_right_foot_18;
  const Scalar t_right_foot_21 = t_right_foot_19 - t_right_foot_20 - t_right_foot_8;
  // right_shank
  const Scalar s_right_shank = sin(t_right_shank_1);
  const Scalar c_right_shank = cos(t_right_shank_1);
  const Scalar s_right_shank_y = 43.2 * s_right_shank;
  const Scalar Omega_right_hip_block_xx = qd[6] * qd[6];
  // right_thigh
  const Scalar a_right_thigh_x = s_right_thigh * Omega_right_hip_block_xx;
  const Scalar t_right_thigh_12 = omega_right_thigh_y * omega_right_thigh_y;
  const Scalar t_right_thigh_13 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar Omega_right_thigh_xx = t_right_thigh_12 + t_right_thigh_13;
  // right_shank
  const Scalar s_right_shank_x = 43.2 * c_right_shank;
  const Scalar t_right_shank_3 = a_right_thigh_x + s_right_shank_y * Omega_right_thigh_xy;
  const Scalar a_right_shank_x = t_right_shank_3 - s_right_shank_x * Omega_right_thigh_xx;
  // right_ankle_cross
  const Scalar s_right_ankle_pitch = sin(q[10]);
  const Scalar c_right_ankle_pitch = cos(q[10]);
  const Scalar s_righ_ankl_cros_y = 43.3 * s_right_ankle_pitch;
  const Scalar t_righ_ankl_cros_4 = s_righ_ankl_cros_y * Omega_right_thigh_xy;
  const Scalar t_right_shank_4 = omega_right_shank_z * omega_right_shank_z;
  const Scalar Omega_right_shank_xx = t_right_thigh_12 + t_right_shank_4;
  const Scalar s_righ_ankl_cros_x = 43.3 * c_right_ankle_pitch;
  const Scalar t_righ_ankl_cros_5 = s_righ_ankl_cros_x * Omega_right_shank_xx;
  const Scalar t_righ_ankl_cros_6 = a_right_shank_x + t_righ_ankl_cros_4;
  const Scalar a_righ_ankl_cros_x = t_righ_ankl_cros_6 - t_righ_ankl_cros_5;
  const Scalar Omega_righ_ankl_cros_xx = t_right_thigh_12 + t_righ_ankl_cros_1;
  // right_foot
  const Scalar t_right_foot_22 = a_righ_ankl_cros_x - Omega_righ_ankl_cros_xx;
  const Scalar a_right_foot_x = t_right_foot_22 + 2.0 * Omega_right_thigh_xz;
  const Scalar t_right_foot_23 = 0.00014128635491404698 * s_right_foot;
  const Scalar Omega_right_thigh_zy = alpha_right_thigh_x - t_right_thigh_10;
  const Scalar Omega_right_thigh_zx = alpha_right_thigh_y - t_right_thigh_8;
  // right_shank
  const Scalar t_right_shank_5 = s_right_shank_y * Omega_right_thigh_zy;
  const Scalar a_right_shank_z = t_right_shank_5 - s_right_shank_x * Omega_right_thigh_zx;
  const Scalar t_right_shank_6 = omega_right_shank_z * t_right_shank_2;
  const Scalar Omega_right_shank_zy = Omega_right_thigh_yz - t_right_shank_6;
  const Scalar t_righ_ankl_cros_7 = s_righ_ankl_cros_y * Omega_right_shank_zy;
  const Scalar t_right_shank_7 = 2.0 * omega_right_thigh_x;
  const Scalar t_right_shank_8 = omega_right_shank_z * t_right_shank_7;
  const Scalar Omega_right_shank_zx = Omega_right_thigh_xz - t_right_shank_8;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_8 = s_righ_ankl_cros_x * Omega_right_shank_zx;
  const Scalar t_righ_ankl_cros_9 = a_right_shank_z + t_righ_ankl_cros_7;
  const Scalar a_righ_ankl_cros_z = t_righ_ankl_cros_9 - t_righ_ankl_cros_8;
  const Scalar Omega_right_thigh_zz = t_right_thigh_4 + t_right_thigh_12;
  // right_foot
  const Scalar t_right_foot_24 = a_righ_ankl_cros_z + Omega_righ_ankl_cros_zx;
  const Scalar a_right_foot_y = t_right_foot_24 - 2.0 * Omega_right_thigh_zz;
  const Scalar t_right_foot_25 = 0.00014128635491404698 * c_right_foot;
  const Scalar t_right_foot_26 = t_right_foot_21 - a_right_foot_x * t_right_foot_23;
  const Scalar M_right_foot_z = t_right_foot_26 + a_right_foot_y * t_right_foot_25;
  B[11] = -M_right_foot_z;
  const Scalar t_right_foot_27 = Omega_right_foot_yy * t_right_foot_23;
  const Scalar t_right_foot_28 = 9.4668e-05 * a_right_foot_y - t_right_foot_27;
  const Scalar F_right_foot_y = t_right_foot_28 + Omega_righ_ankl_cros_zx * t_right_foot_25;
  // right_thigh
  const Scalar t_right_thigh_14 = 0.03939173998083072 * c_right_shank;
  const Scalar t_right_thigh_15 = t_right_thigh_14 - 1.1033955042453505 * s_right_shank;
  const Scalar t_right_thigh_16 = 0.01969586999041536 - c_right_shank * t_right_thigh_15;
  const Scalar t_right_thigh_17 = Omega_right_thigh_zy * t_right_thigh_16;
  const Scalar t_right_thigh_18 = s_right_shank * t_right_thigh_15;
  const Scalar t_right_thigh_19 = 1.1280459976898918 + t_right_thigh_18;
  const Scalar t_right_thigh_20 = F_right_foot_y + M_right_foot_z + t_right_thigh_17;
  const Scalar t_right_thigh_21 = Omega_right_thigh_zx * t_right_thigh_19;
  const Scalar t_right_thigh_22 = 0.00442555309711872 * s_right_shank;
  const Scalar t_right_thigh_23 = t_right_thigh_22 + 0.08414236677063168 * c_right_shank;
  const Scalar t_right_thigh_24 = Omega_right_thigh_xx - Omega_right_thigh_zz;
  const Scalar t_right_thigh_25 = t_right_thigh_20 - t_right_thigh_21;
  // right_shank
  const Scalar t_right_shank_9 = 0.173287335213216 * s_right_ankle_pitch;
  const Scalar t_right_shank_10 = 0.03083291102976 * c_right_ankle_pitch - t_right_shank_9;
  const Scalar t_right_shank_11 = 0.01541645551488 - c_right_ankle_pitch * t_right_shank_10;
  const Scalar t_right_thigh_26 = t_right_thigh_25 + t_right_thigh_24 * t_right_thigh_23;
  const Scalar t_right_shank_12 = Omega_right_shank_zy * t_right_shank_11;
  const Scalar t_right_shank_13 = s_right_ankle_pitch * t_right_shank_10;
  const Scalar t_right_shank_14 = 0.178578772764 + t_right_shank_13;
  const Scalar t_right_shank_15 = Omega_right_shank_zx * t_right_shank_14;
  const Scalar t_right_shank_16 = 0.001559822240256 * s_right_ankle_pitch;
  const Scalar t_right_shank_17 = t_right_shank_16 + 0.01745977700712 * c_right_ankle_pitch;
  const Scalar t_right_shank_18 = Omega_right_thigh_zz - Omega_right_shank_xx;
  const Scalar t_right_thigh_27 = t_right_thigh_26 + t_right_shank_12 - t_right_shank_15;
  const Scalar t_right_shank_19 = 0.00080309376 * s_right_ankle_pitch;
  const Scalar t_right_shank_20 = t_right_shank_19 + 0.0069434148 * c_right_ankle_pitch;
  // right_thigh
  const Scalar t_right_thigh_28 = t_right_thigh_27 - t_right_shank_18 * t_right_shank_17;
  const Scalar t_right_thigh_29 = t_right_thigh_28 + a_right_shank_z * t_right_shank_20;
  const Scalar t_right_thigh_30 = t_right_thigh_29 + 0.000549677184 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_foot_29 = Omega_right_thigh_zz - Omega_righ_ankl_cros_xx;
  const Scalar t_right_thigh_31 = t_right_thigh_30 + 2.40212e-05 * Omega_righ_ankl_cros_zx;
  // right_foot
  const Scalar t_right_foot_30 = Omega_right_thigh_xz_2 * t_right_foot_23;
  const Scalar t_right_foot_31 = 9.4668e-05 * a_right_foot_x + t_right_foot_30;
  const Scalar F_right_foot_x = t_right_foot_31 - Omega_right_foot_xx * t_right_foot_25;
  const Scalar t_right_thigh_32 = t_right_thigh_31 - 6.9552e-06 * t_right_foot_29;
  const Scalar F_righ_ankl_cros_z = F_right_foot_y + 0.000550836384 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_thigh_33 = t_right_thigh_32 - 2.0 * F_right_foot_x;
  const Scalar t_righ_ankl_cros_10 = s_righ_ankl_cros_x * F_righ_ankl_cros_z;
  // right_shank
  const Scalar t_right_shank_21 = 0.00080309376 * c_right_ankle_pitch;
  const Scalar t_right_shank_22 = t_right_shank_21 - 0.0069434148 * s_right_ankle_pitch;
  const Scalar t_right_shank_23 = Omega_right_shank_zy * t_right_shank_22;
  const Scalar t_right_shank_24 = Omega_right_shank_zx * t_right_shank_20;
  const Scalar F_right_shank_z = F_righ_ankl_cros_z - t_right_shank_23 - t_right_shank_24;
  const Scalar t_right_thigh_34 = t_right_thigh_33 + t_righ_ankl_cros_10;
  const Scalar t_right_shank_25 = 0.001559822240256 * c_right_ankle_pitch;
  const Scalar t_right_shank_26 = t_right_shank_25 - 0.01745977700712 * s_right_ankle_pitch;
  // right_thigh
  const Scalar t_right_thigh_35 = 0.00442555309711872 * c_right_shank;
  const Scalar t_right_thigh_36 = t_right_thigh_35 - 0.08414236677063168 * s_right_shank;
  const Scalar t_right_thigh_37 = t_right_shank_26 - (0.001106309568 - t_right_thigh_36);
  const Scalar t_right_thigh_38 = t_right_thigh_34 + s_right_shank_x * F_right_shank_z;
  const Scalar M_right_thigh_y = t_right_thigh_38 + Omega_right_thigh_xy * t_right_thigh_37;
  const Scalar t_right_thigh_39 = 0.0014731530912 * c_right_shank;
  const Scalar t_right_thigh_40 = t_right_thigh_39 - 0.0321901540128 * s_right_shank;
  const Scalar t_right_thigh_41 = 0.0014731530912 * s_right_shank;
  const Scalar t_right_thigh_42 = t_right_thigh_41 + 0.0321901540128 * c_right_shank;
  const Scalar t_right_thigh_43 = F_right_shank_z - Omega_right_thigh_zy * t_right_thigh_40;
  const Scalar F_right_thigh_z = t_right_thigh_43 - Omega_right_thigh_zx * t_right_thigh_42;
  const Scalar t_right_hip_fork_1 = F_right_thigh_z - s_right_thigh * M_right_thigh_y;
  const Scalar t_right_thigh_44 = 0.02465049344454144 - t_right_thigh_18;
  const Scalar t_right_thigh_45 = Omega_right_thigh_zy * t_right_thigh_44;
  const Scalar t_right_thigh_46 = Omega_right_thigh_zx * t_right_thigh_16;
  const Scalar Omega_right_thigh_yy = t_right_thigh_4 + t_right_thigh_13;
  const Scalar t_right_thigh_47 = Omega_right_thigh_yy - Omega_right_thigh_zz;
  const Scalar t_right_thigh_48 = t_right_thigh_45 - t_right_thigh_46;
  const Scalar t_right_shank_27 = 0.005291437550784 - t_right_shank_13;
  const Scalar t_right_thigh_49 = t_right_thigh_48 - t_right_thigh_36 * t_right_thigh_47;
  // right_shank
  const Scalar t_right_shank_28 = Omega_right_shank_zy * t_right_shank_27;
  const Scalar t_right_shank_29 = Omega_right_shank_zx * t_right_shank_11;
  const Scalar Omega_right_shank_yy = t_right_thigh_4 + t_right_shank_4;
  const Scalar t_right_shank_30 = Omega_right_thigh_zz - Omega_right_shank_yy;
  // right_thigh
  const Scalar t_right_thigh_50 = t_right_thigh_49 + t_right_shank_28 - t_right_shank_29;
  const Scalar t_right_thigh_51 = t_right_thigh_50 + t_right_shank_26 * t_right_shank_30;
  const Scalar t_right_thigh_52 = t_right_thigh_51 - a_right_shank_z * t_right_shank_22;
  const Scalar t_righ_ankl_cros_11 = 0.0069788989429152 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_12 = Omega_right_thigh_zz - Omega_righ_ankl_cros_yy;
  const Scalar t_right_thigh_53 = t_right_thigh_52 + t_righ_ankl_cros_11;
  const Scalar t_right_thigh_54 = t_right_thigh_53 - 0.001106309568 * t_righ_ankl_cros_12;
  const Scalar t_right_foot_32 = omega_righ_ankl_cros_z * omega_right_foot_z * 2.0;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy + t_right_foot_32;
  const Scalar t_right_thigh_55 = t_right_thigh_54 + 0.000550836384 * a_righ_ankl_cros_z;
  const Scalar t_right_foot_33 = t_right_shank_7 * omega_right_foot_z;
  const Scalar Omega_right_foot_zx = Omega_right_thigh_xy + t_right_foot_33;
  const Scalar t_right_thigh_56 = t_right_thigh_55 + Omega_right_foot_zy * t_right_foot_18;
  const Scalar t_right_foot_34 = Omega_righ_ankl_cros_yy - Omega_right_foot_yy;
  const Scalar t_right_thigh_57 = t_right_thigh_56 - Omega_right_foot_zx * t_right_foot_6;
  const Scalar a_right_thigh_y = c_right_thigh * Omega_right_hip_block_xx;
  const Scalar Omega_right_thigh_yx = alpha_right_thigh_z + t_right_thigh_11;
  const Scalar t_right_shank_31 = a_right_thigh_y + s_right_shank_y * Omega_right_thigh_yy;
  const Scalar a_right_shank_y = t_right_shank_31 + s_right_shank_x * Omega_right_thigh_yx;
  const Scalar t_righ_ankl_cros_13 = s_righ_ankl_cros_y * Omega_right_shank_yy;
  const Scalar t_right_foot_35 = Omega_right_thigh_yx + a_right_shank_y;
  const Scalar t_righ_ankl_cros_14 = s_righ_ankl_cros_x * Omega_right_thigh_yx;
  // right_foot
  const Scalar t_right_foot_36 = t_right_foot_35 + t_righ_ankl_cros_13;
  const Scalar t_right_foot_37 = t_right_foot_36 + t_righ_ankl_cros_14;
  const Scalar a_right_foot_z = t_right_foot_37 + 2.0 * Omega_right_thigh_yz;
  const Scalar t_right_thigh_58 = t_right_thigh_57 + t_right_foot_16 * t_right_foot_34;
  const Scalar t_right_foot_38 = Omega_right_foot_zy * t_right_foot_23;
  const Scalar t_right_foot_39 = 9.4668e-05 * a_right_foot_z + t_right_foot_38;
  const Scalar F_right_foot_z = t_right_foot_39 + Omega_right_foot_zx * t_right_foot_25;
  const Scalar t_right_thigh_59 = t_right_thigh_58 + a_right_foot_z * t_right_foot_23;
  const Scalar t_right_thigh_60 = t_right_thigh_59 + 2.0 * F_right_foot_z;
  const Scalar t_righ_ankl_cros_15 = s_righ_ankl_cros_y * F_righ_ankl_cros_z;
  // right_thigh
  const Scalar t_right_thigh_61 = t_right_thigh_60 + t_righ_ankl_cros_15;
  const Scalar t_right_thigh_62 = 6.9552e-06 + t_right_thigh_23 + t_right_shank_17;
  const Scalar t_right_thigh_63 = t_right_thigh_61 + s_right_shank_y * F_right_shank_z;
  const Scalar t_right_thigh_64 = Omega_right_thigh_yx * t_right_thigh_62;
  const Scalar t_right_thigh_65 = 0.000549677184 - t_right_foot_12;
  const Scalar t_right_thigh_66 = Omega_righ_ankl_cros_zx * t_right_thigh_65;
  const Scalar M_right_thigh_x = t_right_thigh_63 + t_right_thigh_64 + t_right_thigh_66;
  // right_hip_fork
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 + c_right_thigh * M_right_thigh_x;
  const Scalar t_right_hip_fork_3 = 0.02931050006032736 * c_right_hip_roll;
  const Scalar t_right_hip_fork_4 = 0.00016159248 * s_right_hip_roll - t_right_hip_fork_3;
  const Scalar t_right_hip_fork_5 = 8.079624e-05 - s_right_hip_roll * t_right_hip_fork_4;
  const Scalar t_right_hip_fork_6 = 0.0040738553856 * c_right_hip_roll;
  const Scalar Omega_right_hip_fork_yy = qd[7] * qd[7];
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_6 - 0.00011406528 * s_right_hip_roll;
  const Scalar t_right_hip_fork_8 = alpha_right_hip_fork_x * t_right_hip_fork_5 * 2.0;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_7 * Omega_right_hip_fork_yy;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_8 - t_right_hip_fork_9;
  const Scalar t_right_hip_fork_11 = c_right_hip_roll * t_right_hip_fork_2;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_10 + t_right_hip_fork_11;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_16 = F_right_foot_z + 2.40212e-05 * Omega_right_thigh_yx;
  const Scalar t_righ_ankl_cros_17 = t_righ_ankl_cros_16 + 6.9552e-06 * Omega_right_thigh_yz;
  const Scalar t_righ_ankl_cros_18 = 0.001106309568 * Omega_right_thigh_xz;
  const Scalar t_righ_ankl_cros_19 = t_righ_ankl_cros_17 + t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_20 = 0.0069788989429152 * Omega_right_thigh_xy;
  const Scalar t_right_thigh_67 = Omega_righ_ankl_cros_xx - Omega_righ_ankl_cros_yy;
  const Scalar t_righ_ankl_cros_21 = t_righ_ankl_cros_19 + t_righ_ankl_cros_20;
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_21 - 0.000549677184 * t_right_thigh_67;
  const Scalar t_righ_ankl_cros_23 = 0.000550836384 * a_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_24 = t_righ_ankl_cros_22 + t_righ_ankl_cros_23;
  const Scalar t_right_foot_40 = Omega_right_thigh_xz_2 * t_right_foot_16;
  const Scalar t_righ_ankl_cros_25 = t_righ_ankl_cros_24 + t_right_foot_40;
  const Scalar t_right_foot_41 = Omega_right_foot_zy * t_right_foot_6;
  const Scalar t_righ_ankl_cros_26 = t_righ_ankl_cros_25 - t_right_foot_41;
  const Scalar t_right_foot_42 = Omega_right_foot_zx * t_right_foot_10;
  const Scalar t_righ_ankl_cros_27 = t_righ_ankl_cros_26 + t_right_foot_42;
  const Scalar t_right_foot_43 = t_right_foot_2 * t_right_foot_12;
  const Scalar t_righ_ankl_cros_28 = t_righ_ankl_cros_27 - t_right_foot_43;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_28 + a_right_foot_z * t_right_foot_25;
  B[10] = M_righ_ankl_cros_z;
  // right_shank
  const Scalar t_right_shank_32 = Omega_right_thigh_yx * t_right_shank_14;
  const Scalar t_right_shank_33 = Omega_right_thigh_yz * t_right_shank_17;
  const Scalar t_right_shank_34 = M_righ_ankl_cros_z + t_right_shank_32 + t_right_shank_33;
  const Scalar t_right_shank_35 = Omega_right_thigh_xz * t_right_shank_26;
  const Scalar t_right_shank_36 = Omega_right_thigh_xy * t_right_shank_27;
  const Scalar t_right_thigh_68 = Omega_right_shank_xx - Omega_right_shank_yy;
  const Scalar t_right_shank_37 = t_right_shank_34 - t_right_shank_35 + t_right_shank_36;
  const Scalar t_right_shank_38 = t_right_shank_37 - t_right_shank_11 * t_right_thigh_68;
  const Scalar t_right_shank_39 = t_right_shank_38 - a_right_shank_x * t_right_shank_22;
  const Scalar F_righ_ankl_cros_x = F_right_foot_x + 0.000550836384 * Omega_right_thigh_xy;
  const Scalar t_right_shank_40 = t_right_shank_39 + a_right_shank_y * t_right_shank_20;
  const Scalar t_righ_ankl_cros_29 = s_righ_ankl_cros_y * F_righ_ankl_cros_x;
  const Scalar F_righ_ankl_cros_y = F_right_foot_z + 0.000550836384 * Omega_righ_ankl_cros_yy;
  const Scalar t_right_shank_41 = t_right_shank_40 + t_righ_ankl_cros_29;
  const Scalar M_right_shank_z = t_right_shank_41 + s_righ_ankl_cros_x * F_righ_ankl_cros_y;
  B[9] = M_right_shank_z;
  // right_thigh
  const Scalar t_right_thigh_69 = M_right_shank_z + Omega_right_thigh_yx * t_right_thigh_19;
  const Scalar t_right_thigh_70 = Omega_right_thigh_yz * t_right_thigh_23;
  const Scalar t_right_thigh_71 = Omega_right_thigh_xz * t_right_thigh_36;
  const Scalar t_right_thigh_72 = t_right_thigh_69 + t_right_thigh_70 - t_right_thigh_71;
  const Scalar t_right_thigh_73 = Omega_right_thigh_xy * t_right_thigh_44;
  const Scalar t_right_thigh_74 = Omega_right_thigh_xx - Omega_right_thigh_yy;
  const Scalar t_right_thigh_75 = t_right_thigh_72 + t_right_thigh_73;
  const Scalar t_right_thigh_76 = t_right_thigh_75 - t_right_thigh_16 * t_right_thigh_74;
  const Scalar t_right_thigh_77 = t_right_thigh_76 - a_right_thigh_x * t_right_thigh_40;
  // right_shank
  const Scalar t_right_shank_42 = Omega_right_thigh_xy * t_right_shank_22;
  const Scalar t_right_shank_43 = Omega_right_shank_xx * t_right_shank_20;
  const Scalar F_right_shank_x = F_righ_ankl_cros_x - t_right_shank_42 - t_right_shank_43;
  const Scalar t_right_thigh_78 = t_right_thigh_77 + a_right_thigh_y * t_right_thigh_42;
  const Scalar t_right_shank_44 = Omega_right_shank_yy * t_right_shank_22;
  const Scalar t_right_shank_45 = Omega_right_thigh_yx * t_right_shank_20;
  const Scalar F_right_shank_y = F_righ_ankl_cros_y - t_right_shank_44 + t_right_shank_45;
  // right_thigh
  const Scalar t_right_thigh_79 = t_right_thigh_78 + s_right_shank_y * F_right_shank_x;
  const Scalar M_right_thigh_z = t_right_thigh_79 + s_right_shank_x * F_right_shank_y;
  B[8] = M_right_thigh_z;
  const Scalar t_right_thigh_80 = F_right_shank_y - Omega_right_thigh_yy * t_right_thigh_40;
  const Scalar F_right_thigh_y = t_right_thigh_80 + Omega_right_thigh_yx * t_right_thigh_42;
  const Scalar t_right_thigh_81 = F_right_shank_x - Omega_right_thigh_xy * t_right_thigh_40;
  const Scalar F_right_thigh_x = t_right_thigh_81 - Omega_right_thigh_xx * t_right_thigh_42;
  // right_hip_fork
  const Scalar t_right_hip_fork_13 = M_right_thigh_z - s_right_thigh * F_right_thigh_y;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_13 + c_right_thigh * F_right_thigh_x;
  B[6] = s_right_hip_roll * t_right_hip_fork_14 - t_right_hip_fork_12;
  const Scalar t_right_hip_fork_15 = Omega_right_hip_block_xx * t_right_hip_fork_5;
  const Scalar t_right_hip_fork_16 = t_right_hip_fork_15 - c_right_thigh * M_right_thigh_y;
  B[7] = t_right_hip_fork_16 - s_right_thigh * M_right_thigh_x;
}

}  // namespace

void bias_force(const Scalar q[12], const Scalar qd[12], Scalar B[12]) noexcept {
  bias_force_1(q, qd, B);
  bias_force_2(q, qd, B);
}

void gravity_force(const Scalar q[12], Scalar G[12]) noexcept {
  const Scalar t_left_ankle_cross_1 = q[2] + q[3];
  // left_foot
  const Scalar t_left_foot_1 = t_left_ankle_cross_1 + q[4];
  const Scalar c_left_foot = cos(t_left_foot_1);
  const Scalar s_left_foot = sin(t_left_foot_1);
  // left_hip_fork
  const Scalar c_left_hip_roll = cos(q[1]);
  const Scalar s_left_hip_roll = sin(q[1]);
  const Scalar a_left_hip_fork_x = 9.81 * c_left_hip_roll;
  // left_foot
  const Scalar a_left_foot_x = c_left_foot * a_left_hip_fork_x;
  const Scalar t_left_foot_2 = 0.2614691411136524 + q[5];
  const Scalar s_left_foot_2 = sin(t_left_foot_2);
  const Scalar c_left_foot_2 = cos(t_left_foot_2);
  const Scalar t_left_foot_3 = 0.014128635491404699 * s_left_foot_2;
  const Scalar a_left_hip_fork_y = 9.81 * s_left_hip_roll;
  const Scalar t_left_foot_4 = 0.014128635491404699 * c_left_foot_2;
  const Scalar t_left_foot_5 = a_left_hip_fork_y * t_left_foot_4;
  const Scalar M_left_foot_z = t_left_foot_3 * a_left_foot_x + t_left_foot_5;
  G[5] = M_left_foot_z;
  const Scalar a_left_foot_z = s_left_foot * a_left_hip_fork_x;
  const Scalar M_left_foot_x = a_left_foot_z * t_left_foot_3;
  const Scalar c_left_hip_pitch = cos(q[2]);
  const Scalar s_left_hip_pitch = sin(q[2]);
  const Scalar t_left_thigh_1 = 0.14731530912 * c_left_hip_pitch;
  const Scalar t_left_thigh_2 = t_left_thigh_1 + 3.62798116128 * s_left_hip_pitch;
  const Scalar c_left_ankle_cross = cos(t_left_ankle_cross_1);
  const Scalar s_left_ankle_cross = sin(t_left_ankle_cross_1);
  const Scalar t_left_shank_1 = 0.080309376 * c_left_ankle_cross;
  const Scalar t_left_shank_2 = t_left_shank_1 + 1.10425392 * s_left_ankle_cross;
  const Scalar t_left_ankle_cross_2 = 0.0550836384 * c_left_foot - 0.0094668 * s_left_foot;
  const Scalar t_left_thigh_3 = t_left_ankle_cross_2 - (t_left_thigh_2 + t_left_shank_2);
  const Scalar t_left_foot_6 = s_left_foot * M_left_foot_z - c_left_foot * M_left_foot_x;
  const Scalar M_left_thigh_x = t_left_foot_6 - a_left_hip_fork_y * t_left_thigh_3;
  const Scalar t_left_ankle_cross_3 = a_left_hip_fork_x * t_left_ankle_cross_2;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_3 - a_left_foot_z * t_left_foot_4;
  G[4] = -M_left_ankle_cross_z;
  const Scalar M_left_shank_z = M_left_ankle_cross_z - a_left_hip_fork_x * t_left_shank_2;
  G[3] = -M_left_shank_z;
  const Scalar M_left_thigh_z = M_left_shank_z - a_left_hip_fork_x * t_left_thigh_2;
  G[2] = -M_left_thigh_z;
  G[0] = -(s_left_hip_roll * M_left_thigh_z + c_left_hip_roll * M_left_thigh_x);
  // left_hip_fork
  const Scalar t_left_hip_fork_1 = 3.9972481559136 * c_left_hip_roll;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + 0.0466241832 * s_left_hip_roll;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 + c_left_foot * M_left_foot_z;
  const Scalar t_left_thigh_4 = 0.14731530912 * s_left_hip_pitch;
  const Scalar t_left_thigh_5 = t_left_thigh_4 - 3.62798116128 * c_left_hip_pitch;
  const Scalar t_left_hip_fork_4 = t_left_thigh_5 + 0.080309376 * s_left_ankle_cross;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_4 - 1.10425392 * c_left_ankle_cross;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_5 - 0.0550836384 * s_left_foot;
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_6 - 0.0094668 * c_left_foot;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_3 + s_left_foot * M_left_foot_x;
  G[1] = t_left_hip_fork_8 - a_left_hip_fork_y * t_left_hip_fork_7;
  const Scalar t_righ_ankl_cros_1 = q[8] + q[9];
  // right_foot
  const Scalar t_right_foot_1 = t_righ_ankl_cros_1 + q[10];
  const Scalar c_right_foot = cos(t_right_foot_1);
  const Scalar s_right_foot = sin(t_right_foot_1);
  // right_hip_fork
  const Scalar c_right_hip_roll = cos(q[7]);
  const Scalar s_right_hip_roll = sin(q[7]);
  const Scalar a_right_hip_fork_x = 9.81 * c_right_hip_roll;
  // right_foot
  const Scalar a_right_foot_x = c_right_foot * a_right_hip_fork_x;
  const Scalar t_right_foot_2 = 0.2614691411136524 - q[11];
  const Scalar s_right_foot_2 = sin(t_right_foot_2);
  const Scalar c_right_foot_2 = cos(t_right_foot_2);
  const Scalar t_right_foot_3 = 0.014128635491404699 * s_right_foot_2;
  const Scalar a_right_hip_fork_y = 9.81 * s_right_hip_roll;
  const Scalar t_right_foot_4 = 0.014128635491404699 * c_right_foot_2;
  const Scalar t_right_foot_5 = a_right_hip_fork_y * t_right_foot_4;
  const Scalar M_right_foot_z = t_right_foot_3 * a_right_foot_x - t_right_foot_5;
  G[11] = -M_right_foot_z;
  const Scalar a_right_foot_z = s_right_foot * a_right_hip_fork_x;
  const Scalar M_right_foot_x = a_right_foot_z * t_right_foot_3;
  const Scalar c_right_hip_pitch = cos(q[8]);
  const Scalar s_right_hip_pitch = sin(q[8]);
  const Scalar t_right_thigh_1 = 0.14731530912 * c_right_hip_pitch;
  const Scalar t_right_thigh_2 = t_right_thigh_1 + 3.62798116128 * s_right_hip_pitch;
  const Scalar c_righ_ankl_cros = cos(t_righ_ankl_cros_1);
  const Scalar s_righ_ankl_cros = sin(t_righ_ankl_cros_1);
  const Scalar t_right_shank_1 = 0.080309376 * c_righ_ankl_cros + 1.10425392 * s_righ_ankl_cros;
  const Scalar t_righ_ankl_cros_2 = 0.0550836384 * c_right_foot - 0.0094668 * s_right_foot;
  const Scalar t_right_thigh_3 = t_righ_ankl_cros_2 - (t_right_thigh_2 + t_right_shank_1);
  const Scalar t_right_foot_6 = s_right_foot * M_right_foot_z - c_right_foot * M_right_foot_x;
  const Scalar M_right_thigh_x = t_right_foot_6 + a_right_hip_fork_y * t_right_thigh_3;
  const Scalar t_righ_ankl_cros_3 = a_right_hip_fork_x * t_righ_ankl_cros_2;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_3 - a_right_foot_z * t_right_foot_4;
  G[10] = -M_righ_ankl_cros_z;
  const Scalar M_right_shank_z = M_righ_ankl_cros_z - a_right_hip_fork_x * t_right_shank_1;
  G[9] = -M_right_shank_z;
  const Scalar M_right_thigh_z = M_right_shank_z - a_right_hip_fork_x * t_right_thigh_2;
  G[8] = -M_right_thigh_z;
  G[6] = c_right_hip_roll * M_right_thigh_x - s_right_hip_roll * M_right_thigh_z;
  // right_hip_fork
  const Scalar t_right_hip_fork_1 = 3.9972481559136 * c_right_hip_roll;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 - 0.0466241832 * s_right_hip_roll;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 + c_right_foot * M_right_foot_z;
  const Scalar t_right_thigh_4 = 0.14731530912 * s_right_hip_pitch;
  const Scalar t_right_thigh_5 = t_right_thigh_4 - 3.62798116128 * c_right_hip_pitch;
  const Scalar t_right_hip_fork_4 = t_right_thigh_5 + 0.080309376 * s_righ_ankl_cros;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_4 - 1.10425392 * c_righ_ankl_cros;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_5 - 0.0550836384 * s_right_foot;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_6 - 0.0094668 * c_right_foot;
  const Scalar t_right_hip_fork_8 = t_right_hip_fork_3 + s_right_foot * M_right_foot_x;
  G[7] = -(t_right_hip_fork_8 + a_right_hip_fork_y * t_right_hip_fork_7);
}

namespace {

[[gnu::noinline]] void inverse_dynamics_1(const Scalar q[12], const Scalar qd[12],
                                          const Scalar qdd[12], Scalar tau[12]) noexcept {
  const Scalar s_left_hip_pitch = sin(q[2]);
  const Scalar c_left_hip_pitch = cos(q[2]);
  // left_hip_fork
  const Scalar c_left_hip_roll = cos(q[1]);
  const Scalar s_left_hip_roll = sin(q[1]);
  const Scalar omega_left_hip_fork_x = c_left_hip_roll * qd[0];
  const Scalar t_left_thigh_1 = s_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_y = c_left_hip_pitch * qd[1] - t_left_thigh_1;
  const Scalar c_left_knee = cos(q[3]);
  const Scalar s_left_knee = sin(q[3]);
  const Scalar t_left_thigh_2 = c_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_x = s_left_hip_pitch * qd[1] + t_left_thigh_2;
  const Scalar t_left_shank_1 = c_left_knee * omega_left_thigh_y;
  const Scalar omega_left_shank_y = t_left_shank_1 - s_left_knee * omega_left_thigh_x;
  const Scalar s_left_ankle_pitch = sin(q[4]);
  const Scalar c_left_ankle_pitch = cos(q[4]);
  const Scalar t_left_shank_2 = s_left_knee * omega_left_thigh_y;
  const Scalar omega_left_shank_x = t_left_shank_2 + c_left_knee * omega_left_thigh_x;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_1 = s_left_ankle_pitch * omega_left_shank_y;
  const Scalar t_left_ankle_cross_2 = c_left_ankle_pitch * omega_left_shank_x;
  const Scalar omega_left_ankle_cross_x = t_left_ankle_cross_1 + t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_3 = omega_left_ankle_cross_x * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = c_left_ankle_pitch * omega_left_shank_y;
  const Scalar t_left_ankle_cross_5 = s_left_ankle_pitch * omega_left_shank_x;
  const Scalar omega_left_ankle_cross_y = t_left_ankle_cross_4 - t_left_ankle_cross_5;
  // left_foot
  const Scalar omega_left_foot_z = omega_left_ankle_cross_y + qd[5];
  const Scalar t_left_foot_1 = omega_left_foot_z * omega_left_foot_z;
  const Scalar t_left_foot_2 = t_left_ankle_cross_3 - t_left_foot_1;
  const Scalar omega_left_hip_fork_y = s_left_hip_roll * qd[0];
  const Scalar omega_left_thigh_z = omega_left_hip_fork_y + qd[2];
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  // left_ankle_cross
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_6 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_7 = t_left_ankle_cross_6 + t_left_ankle_cross_3;
  // left_foot
  const Scalar Omega_left_foot_xx = t_left_ankle_cross_7 - t_left_foot_2;
  const Scalar Omega_left_foot_yy = t_left_ankle_cross_3 + t_left_foot_1;
  const Scalar t_left_foot_3 = 0.2614691411136524 + q[5];
  const Scalar c_left_foot = cos(t_left_foot_3);
  const Scalar s_left_foot = sin(t_left_foot_3);
  const Scalar t_left_foot_4 = 0.00013282817963685661 * s_left_foot;
  const Scalar t_left_foot_5 = 7.233379265339546e-05 * c_left_foot + t_left_foot_4;
  const Scalar t_left_foot_6 = 3.616689632669773e-05 - c_left_foot * t_left_foot_5;
  const Scalar t_left_foot_7 = t_left_foot_6 * (Omega_left_foot_xx - Omega_left_foot_yy);
  // left_hip_fork
  const Scalar Omega_left_hip_fork_yz = c_left_hip_roll * qdd[0];
  const Scalar t_left_hip_fork_1 = omega_left_hip_fork_y * qd[1] * 2.0;
  const Scalar Omega_left_hip_fork_zy = Omega_left_hip_fork_yz - t_left_hip_fork_1;
  const Scalar t_left_hip_fork_2 = omega_left_hip_fork_x * omega_left_hip_fork_y;
  const Scalar Omega_left_hip_fork_xy = qdd[1] + t_left_hip_fork_2;
  // left_thigh
  const Scalar t_left_thigh_3 = c_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_4 = s_left_hip_pitch * Omega_left_hip_fork_xy;
  const Scalar Omega_left_thigh_yz = t_left_thigh_3 + t_left_thigh_4;
  const Scalar t_left_thigh_5 = s_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_6 = c_left_hip_pitch * Omega_left_hip_fork_xy;
  const Scalar Omega_left_thigh_xz = t_left_thigh_5 - t_left_thigh_6;
  // left_shank
  const Scalar t_left_shank_3 = c_left_knee * Omega_left_thigh_yz;
  const Scalar Omega_left_shank_yz = t_left_shank_3 - s_left_knee * Omega_left_thigh_xz;
  const Scalar t_left_shank_4 = s_left_knee * Omega_left_thigh_yz;
  const Scalar Omega_left_shank_xz = t_left_shank_4 + c_left_knee * Omega_left_thigh_xz;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_8 = s_left_ankle_pitch * Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_9 = c_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_10 = t_left_ankle_cross_8 + t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_11 = omega_left_ankle_cross_x * omega_left_ankle_cross_z;
  const Scalar alpha_left_ankle_cross_y = t_left_ankle_cross_10 + t_left_ankle_cross_11;
  // left_foot
  const Scalar alpha_left_foot_z = alpha_left_ankle_cross_y - qdd[5];
  const Scalar Omega_left_foot_yx = t_left_ankle_cross_11 + alpha_left_foot_z;
  const Scalar t_left_foot_8 = s_left_foot * t_left_foot_5;
  const Scalar t_left_foot_9 = 0.0005569034480192284 - t_left_foot_8;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_12 = c_left_ankle_pitch * Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_13 = s_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_14 = t_left_ankle_cross_12 - t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_15 = 2.0 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_16 = omega_left_ankle_cross_y * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_14 + t_left_ankle_cross_16;
  // left_foot
  const Scalar t_left_foot_10 = 6.298136129784905e-05 * s_left_foot;
  const Scalar t_left_foot_11 = t_left_foot_10 - 0.0014494177603079786 * c_left_foot;
  const Scalar t_left_foot_12 = t_left_ankle_cross_17 * t_left_foot_11;
  const Scalar t_left_ankle_cross_18 = omega_left_ankle_cross_x * omega_left_ankle_cross_y;
  // left_hip_fork
  const Scalar Omega_left_hip_fork_xz = s_left_hip_roll * qdd[0];
  const Scalar t_left_hip_fork_3 = omega_left_hip_fork_x * qd[1];
  const Scalar alpha_left_hip_fork_y = Omega_left_hip_fork_xz + t_left_hip_fork_3;
  const Scalar alpha_left_thigh_z = alpha_left_hip_fork_y + qdd[2];
  const Scalar alpha_left_shank_z = alpha_left_thigh_z + qdd[3];
  const Scalar alpha_left_ankle_cross_z = alpha_left_shank_z + qdd[4];
  const Scalar t_left_ankle_cross_19 = alpha_left_ankle_cross_z - t_left_ankle_cross_18;
  // left_foot
  const Scalar t_left_foot_13 = 6.298136129784905e-05 * c_left_foot;
  const Scalar t_left_foot_14 = t_left_foot_13 + 0.0014494177603079786 * s_left_foot;
  const Scalar t_left_foot_15 = Omega_left_foot_yx * t_left_foot_9 + t_left_foot_12;
  const Scalar Omega_left_foot_xy = t_left_ankle_cross_11 - alpha_left_foot_z;
  const Scalar t_left_foot_16 = 0.0004240752683823717 + t_left_foot_8;
  const Scalar t_left_foot_17 = t_left_foot_15 + t_left_ankle_cross_19 * t_left_foot_14;
  const Scalar t_left_foot_18 = t_left_foot_17 - Omega_left_foot_xy * t_left_foot_16;
  const Scalar t_left_foot_19 = t_left_foot_18 + t_left_foot_7;
  const Scalar Omega_left_hip_block_xx = qd[0] * qd[0];
  // left_thigh
  const Scalar t_left_thigh_7 = Omega_left_hip_fork_xz - 981.0 * c_left_hip_roll;
  const Scalar t_left_thigh_8 = c_left_hip_pitch * Omega_left_hip_block_xx;
  const Scalar a_left_thigh_y = t_left_thigh_8 - s_left_hip_pitch * t_left_thigh_7;
  const Scalar t_left_thigh_9 = omega_left_thigh_x * omega_left_thigh_y;
  const Scalar Omega_left_thigh_yx = alpha_left_thigh_z + t_left_thigh_9;
  const Scalar t_left_shank_5 = a_left_thigh_y + 43.2 * Omega_left_thigh_yx;
  const Scalar t_left_thigh_10 = s_left_hip_pitch * Omega_left_hip_block_xx;
  const Scalar a_left_thigh_x = t_left_thigh_10 + c_left_hip_pitch * t_left_thigh_7;
  const Scalar t_left_thigh_11 = omega_left_thigh_x * omega_left_thigh_x;
  const Scalar t_left_thigh_12 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_13 = t_left_thigh_12 - t_left_thigh_11;
  // left_hip_fork
  const Scalar t_left_hip_fork_4 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_5 = qd[1] * qd[1];
  const Scalar Omega_left_hip_fork_yy = t_left_hip_fork_5 + t_left_hip_fork_4;
  const Scalar Omega_left_thigh_xx = Omega_left_hip_fork_yy + t_left_thigh_13;
  // left_shank
  const Scalar t_left_shank_6 = a_left_thigh_x - 43.2 * Omega_left_thigh_xx;
  const Scalar t_left_shank_7 = c_left_knee * t_left_shank_5;
  const Scalar a_left_shank_y = t_left_shank_7 - s_left_knee * t_left_shank_6;
  const Scalar t_left_shank_8 = omega_left_shank_x * omega_left_shank_y;
  const Scalar Omega_left_shank_yx = alpha_left_shank_z + t_left_shank_8;
  const Scalar t_left_ankle_cross_20 = a_left_shank_y + 43.3 * Omega_left_shank_yx;
  const Scalar t_left_shank_9 = s_left_knee * t_left_shank_5;
  const Scalar a_left_shank_x = t_left_shank_9 + c_left_knee * t_left_shank_6;
  const Scalar t_left_shank_10 = omega_left_shank_x * omega_left_shank_x;
  const Scalar t_left_shank_11 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_12 = t_left_shank_11 - t_left_shank_10;
  const Scalar Omega_left_shank_xx = Omega_left_hip_fork_yy + t_left_shank_12;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_21 = a_left_shank_x - 43.3 * Omega_left_shank_xx;
  const Scalar t_left_ankle_cross_22 = s_left_ankle_pitch * t_left_ankle_cross_20;
  const Scalar t_left_ankle_cross_23 = c_left_ankle_pitch * t_left_ankle_cross_21;
  const Scalar a_left_ankle_cross_x = t_left_ankle_cross_22 + t_left_ankle_cross_23;
  const Scalar t_left_ankle_cross_24 = t_left_ankle_cross_6 - t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_25 = Omega_left_hip_fork_yy + t_left_ankle_cross_24;
  // left_foot
  const Scalar t_left_foot_20 = a_left_ankle_cross_x - t_left_ankle_cross_25;
  const Scalar a_left_foot_x = t_left_foot_20 + 2.0 * t_left_ankle_cross_10;
  const Scalar t_left_foot_21 = 0.00014128635491404698 * s_left_foot;
  const Scalar t_left_ankle_cross_26 = t_left_ankle_cross_11 + alpha_left_ankle_cross_y;
  // left_shank
  const Scalar t_left_shank_13 = 2.0 * omega_left_shank_z;
  const Scalar t_left_shank_14 = omega_left_shank_x * t_left_shank_13;
  const Scalar Omega_left_shank_zx = Omega_left_shank_xz + t_left_shank_14;
  // left_thigh
  const Scalar t_left_thigh_14 = 2.0 * omega_left_thigh_z;
  const Scalar t_left_thigh_15 = omega_left_thigh_x * t_left_thigh_14;
  const Scalar Omega_left_thigh_zx = Omega_left_thigh_xz + t_left_thigh_15;
  const Scalar a_left_thigh_z = Omega_left_hip_fork_yz + 981.0 * s_left_hip_roll;
  const Scalar a_left_shank_z = a_left_thigh_z - 43.2 * Omega_left_thigh_zx;
  const Scalar a_left_ankle_cross_z = a_left_shank_z - 43.3 * Omega_left_shank_zx;
  // left_foot
  const Scalar t_left_foot_22 = a_left_ankle_cross_z - t_left_ankle_cross_26;
  const Scalar a_left_foot_y = t_left_foot_22 - 2.0 * Omega_left_hip_fork_yy;
  const Scalar t_left_foot_23 = 0.00014128635491404698 * c_left_foot;
  const Scalar t_left_foot_24 = t_left_foot_19 + a_left_foot_x * t_left_foot_21;
  const Scalar M_left_foot_z = t_left_foot_24 - a_left_foot_y * t_left_foot_23;
  tau[5] = -M_left_foot_z;
  const Scalar t_left_foot_25 = Omega_left_foot_yy * t_left_foot_21;
  const Scalar t_left_foot_26 = 9.4668e-05 * a_left_foot_y - t_left_foot_25;
  const Scalar F_left_foot_y = t_left_foot_26 - Omega_left_foot_yx * t_left_foot_23;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_27 = 0.001106309568 * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_28 = F_left_foot_y - M_left_foot_z;
  const Scalar t_left_ankle_cross_29 = t_left_ankle_cross_28 - t_left_ankle_cross_27;
  const Scalar t_left_ankle_cross_30 = 0.000549677184 * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_31 = t_left_ankle_cross_29 + t_left_ankle_cross_30;
  const Scalar t_left_ankle_cross_32 = 2.40212e-05 * t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_33 = t_left_ankle_cross_31 - t_left_ankle_cross_32;
  const Scalar t_left_ankle_cross_34 = 6.9552e-06 * t_left_ankle_cross_24;
  // left_foot
  const Scalar t_left_foot_27 = Omega_left_foot_xy * t_left_foot_21;
  const Scalar t_left_foot_28 = 9.4668e-05 * a_left_foot_x - t_left_foot_27;
  const Scalar F_left_foot_x = t_left_foot_28 - Omega_left_foot_xx * t_left_foot_23;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_35 = t_left_ankle_cross_33 + t_left_ankle_cross_34;
  const Scalar M_left_ankle_cross_y = t_left_ankle_cross_35 - 2.0 * F_left_foot_x;
  const Scalar t_left_ankle_cross_36 = F_left_foot_y + 0.000160356 * a_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_37 = 0.000550836384 * t_left_ankle_cross_17;
  const Scalar F_left_ankle_cross_z = t_left_ankle_cross_36 + t_left_ankle_cross_37;
  // left_shank
  const Scalar Omega_left_shank_xy = alpha_left_shank_z - t_left_shank_8;
  const Scalar t_left_shank_15 = omega_left_shank_y * t_left_shank_13;
  const Scalar Omega_left_shank_zy = Omega_left_shank_yz + t_left_shank_15;
  const Scalar t_left_shank_16 = 0.001559822240256 * Omega_left_shank_xy;
  const Scalar t_left_shank_17 = t_left_shank_16 - 0.01541645551488 * Omega_left_shank_zy;
  const Scalar t_left_shank_18 = t_left_shank_17 + 0.122071088076 * Omega_left_shank_zx;
  const Scalar t_left_shank_19 = t_left_shank_18 + 0.01745977700712 * t_left_shank_12;
  const Scalar t_left_shank_20 = t_left_shank_19 + 43.3 * F_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_38 = c_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar t_left_shank_21 = t_left_shank_20 + t_left_ankle_cross_38;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_39 = 0.0069788989429152 * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_40 = 0.000549677184 * t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_41 = alpha_left_ankle_cross_z + t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_42 = t_left_ankle_cross_39 - t_left_ankle_cross_40;
  const Scalar t_left_ankle_cross_43 = 6.9552e-06 * t_left_ankle_cross_41;
  const Scalar t_left_ankle_cross_44 = Omega_left_hip_fork_yy - t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_45 = t_left_ankle_cross_42 + t_left_ankle_cross_43;
  const Scalar t_left_ankle_cross_46 = 0.001106309568 * t_left_ankle_cross_44;
  const Scalar t_left_ankle_cross_47 = t_left_ankle_cross_45 - t_left_ankle_cross_46;
  const Scalar t_left_ankle_cross_48 = 0.000550836384 * a_left_ankle_cross_z;
  const Scalar t_left_foot_29 = t_left_ankle_cross_15 * omega_left_foot_z;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_17 - t_left_foot_29;
  const Scalar t_left_ankle_cross_49 = t_left_ankle_cross_47 + t_left_ankle_cross_48;
  // left_foot
  const Scalar t_left_foot_30 = Omega_left_foot_zy * t_left_foot_16;
  const Scalar t_left_foot_31 = omega_left_ankle_cross_x * omega_left_foot_z * 2.0;
  const Scalar Omega_left_foot_zx = t_left_ankle_cross_19 + t_left_foot_31;
  const Scalar t_left_ankle_cross_50 = t_left_ankle_cross_49 + t_left_foot_30;
  const Scalar t_left_foot_32 = Omega_left_foot_zx * t_left_foot_6;
  const Scalar t_left_ankle_cross_51 = t_left_ankle_cross_50 - t_left_foot_32;
  const Scalar t_left_foot_33 = Omega_left_foot_yx * t_left_foot_11;
  const Scalar t_left_foot_34 = t_left_ankle_cross_7 - Omega_left_foot_yy;
  const Scalar t_left_ankle_cross_52 = t_left_ankle_cross_51 + t_left_foot_33;
  const Scalar t_left_foot_35 = t_left_foot_14 * t_left_foot_34;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_53 = c_left_ankle_pitch * t_left_ankle_cross_20;
  const Scalar t_left_ankle_cross_54 = s_left_ankle_pitch * t_left_ankle_cross_21;
  const Scalar a_left_ankle_cross_y = t_left_ankle_cross_53 - t_left_ankle_cross_54;
  const Scalar t_left_foot_36 = a_left_ankle_cross_y + t_left_ankle_cross_41;
  const Scalar a_left_foot_z = t_left_foot_36 + 2.0 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_55 = t_left_ankle_cross_52 + t_left_foot_35;
  // left_foot
  const Scalar t_left_foot_37 = a_left_foot_z * t_left_foot_21;
  const Scalar t_left_foot_38 = Omega_left_foot_zy * t_left_foot_21;
  const Scalar t_left_foot_39 = 9.4668e-05 * a_left_foot_z + t_left_foot_38;
  const Scalar F_left_foot_z = t_left_foot_39 + Omega_left_foot_zx * t_left_foot_23;
  const Scalar t_left_ankle_cross_56 = t_left_ankle_cross_55 + t_left_foot_37;
  const Scalar M_left_ankle_cross_x = t_left_ankle_cross_56 + 2.0 * F_left_foot_z;
  // left_shank
  const Scalar M_left_shank_y = t_left_shank_21 + s_left_ankle_pitch * M_left_ankle_cross_x;
  const Scalar t_left_shank_22 = F_left_ankle_cross_z + 0.000584786454 * a_left_shank_z;
  const Scalar F_left_shank_z = t_left_shank_22 - 0.00080309376 * Omega_left_shank_zy;
  // left_thigh
  const Scalar Omega_left_thigh_xy = alpha_left_thigh_z - t_left_thigh_9;
  const Scalar t_left_thigh_16 = omega_left_thigh_y * t_left_thigh_14;
  const Scalar Omega_left_thigh_zy = Omega_left_thigh_yz + t_left_thigh_16;
  const Scalar t_left_thigh_17 = 0.00442555309711872 * Omega_left_thigh_xy;
  const Scalar t_left_thigh_18 = t_left_thigh_17 - 0.01969586999041536 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_19 = t_left_thigh_18 + 0.26256865566306814 * Omega_left_thigh_zx;
  const Scalar t_left_thigh_20 = t_left_thigh_19 + 0.08414236677063168 * t_left_thigh_13;
  const Scalar t_left_thigh_21 = t_left_thigh_20 + 43.2 * F_left_shank_z;
  // left_shank
  const Scalar t_left_shank_23 = 0.005291437550784 * Omega_left_shank_zy;
  const Scalar t_left_shank_24 = t_left_shank_23 + 0.01541645551488 * Omega_left_shank_zx;
  const Scalar Omega_left_shank_yy = t_left_shank_11 + t_left_shank_10;
  const Scalar t_left_shank_25 = Omega_left_hip_fork_yy - Omega_left_shank_yy;
  const Scalar t_left_shank_26 = t_left_shank_24 + 0.01745977700712 * Omega_left_shank_yx;
  const Scalar t_left_shank_27 = t_left_shank_26 + 0.001559822240256 * t_left_shank_25;
  const Scalar t_left_shank_28 = t_left_shank_27 - 0.00080309376 * a_left_shank_z;
  const Scalar t_left_ankle_cross_57 = s_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar t_left_shank_29 = t_left_shank_28 - t_left_ankle_cross_57;
  const Scalar M_left_shank_x = t_left_shank_29 + c_left_ankle_pitch * M_left_ankle_cross_x;
  const Scalar t_left_thigh_22 = t_left_thigh_21 + c_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_y = t_left_thigh_22 + s_left_knee * M_left_shank_x;
  // left_hip_fork
  const Scalar t_left_hip_fork_6 = 0.02957665238032736 * Omega_left_hip_fork_zy;
  const Scalar Omega_left_hip_fork_zx = t_left_hip_fork_3 + alpha_left_hip_fork_y;
  const Scalar t_left_hip_fork_7 = F_left_shank_z + t_left_hip_fork_6;
  const Scalar t_left_hip_fork_8 = 8.079624e-05 * Omega_left_hip_fork_zx;
  const Scalar Omega_left_hip_fork_yx = qdd[1] - t_left_hip_fork_2;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_7 + t_left_hip_fork_8;
  const Scalar t_left_hip_fork_10 = 0.00011406528 * Omega_left_hip_fork_yx;
  const Scalar t_left_hip_fork_11 = Omega_left_hip_block_xx - Omega_left_hip_fork_yy;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_9 + t_left_hip_fork_10;
  const Scalar t_left_hip_fork_13 = 0.0040738553856 * t_left_hip_fork_11;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_12 + t_left_hip_fork_13;
  const Scalar t_left_thigh_23 = 0.0014731530912 * Omega_left_thigh_zy;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_14 - t_left_thigh_23;
  // left_thigh
  const Scalar t_left_thigh_24 = 0.02465049344454144 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_25 = t_left_thigh_24 + 0.01969586999041536 * Omega_left_thigh_zx;
  const Scalar Omega_left_thigh_yy = t_left_thigh_12 + t_left_thigh_11;
  const Scalar t_left_thigh_26 = Omega_left_hip_fork_yy - Omega_left_thigh_yy;
  const Scalar t_left_thigh_27 = t_left_thigh_25 + 0.08414236677063168 * Omega_left_thigh_yx;
  const Scalar t_left_thigh_28 = t_left_thigh_27 + 0.00442555309711872 * t_left_thigh_26;
  const Scalar t_left_thigh_29 = t_left_thigh_28 - 0.0014731530912 * a_left_thigh_z;
  const Scalar t_left_thigh_30 = t_left_thigh_29 - s_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_x = t_left_thigh_30 + c_left_knee * M_left_shank_x;
  // left_hip_fork
  const Scalar t_left_hip_fork_16 = t_left_hip_fork_15 - s_left_hip_pitch * M_left_thigh_y;
  const Scalar M_left_hip_fork_x = t_left_hip_fork_16 + c_left_hip_pitch * M_left_thigh_x;
  const Scalar t_left_hip_fork_17 = c_left_hip_roll * M_left_hip_fork_x;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_58 = F_left_foot_z + 0.000160356 * a_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_59 = 0.000550836384 * t_left_ankle_cross_7;
  const Scalar F_left_ankle_cross_y = t_left_ankle_cross_58 + t_left_ankle_cross_59;
  const Scalar t_left_ankle_cross_60 = F_left_foot_x + 0.000160356 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_61 = 0.000550836384 * t_left_ankle_cross_19;
  const Scalar F_left_ankle_cross_x = t_left_ankle_cross_60 + t_left_ankle_cross_61;
  const Scalar t_left_ankle_cross_62 = c_left_ankle_pitch * F_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_63 = s_left_ankle_pitch * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_64 = t_left_ankle_cross_62 + t_left_ankle_cross_63;
  // left_shank
  const Scalar t_left_shank_30 = t_left_ankle_cross_64 + 0.000584786454 * a_left_shank_y;
  const Scalar F_left_shank_y = t_left_shank_30 - 0.00080309376 * Omega_left_shank_yy;
  const Scalar t_left_shank_31 = 0.00080309376 * Omega_left_shank_xy;
  const Scalar t_left_shank_32 = 0.000584786454 * a_left_shank_x - t_left_shank_31;
  const Scalar t_left_ankle_cross_65 = s_left_ankle_pitch * F_left_ankle_cross_y;
  const Scalar t_left_shank_33 = t_left_shank_32 - t_left_ankle_cross_65;
  const Scalar F_left_shank_x = t_left_shank_33 + c_left_ankle_pitch * F_left_ankle_cross_x;
  const Scalar t_left_shank_34 = c_left_knee * F_left_shank_y;
  const Scalar t_left_shank_35 = t_left_shank_34 + s_left_knee * F_left_shank_x;
  const Scalar t_left_shank_36 = 43.2 * t_left_shank_35;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_66 = 43.3 * t_left_ankle_cross_64;
  const Scalar t_left_ankle_cross_67 = F_left_foot_z + 2.40212e-05 * t_left_ankle_cross_41;
  const Scalar t_left_ankle_cross_68 = 6.9552e-06 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_69 = t_left_ankle_cross_67 + t_left_ankle_cross_68;
  const Scalar t_left_ankle_cross_70 = 0.001106309568 * t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_71 = t_left_ankle_cross_69 + t_left_ankle_cross_70;
  const Scalar t_left_ankle_cross_72 = 0.0069788989429152 * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_73 = t_left_ankle_cross_25 - t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_74 = t_left_ankle_cross_71 + t_left_ankle_cross_72;
  const Scalar t_left_ankle_cross_75 = 0.000549677184 * t_left_ankle_cross_73;
  const Scalar t_left_ankle_cross_76 = t_left_ankle_cross_74 - t_left_ankle_cross_75;
  const Scalar t_left_ankle_cross_77 = 0.000550836384 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_78 = t_left_ankle_cross_76 + t_left_ankle_cross_77;
  const Scalar t_left_foot_40 = Omega_left_foot_xy * t_left_foot_14;
  const Scalar t_left_ankle_cross_79 = t_left_ankle_cross_78 - t_left_foot_40;
  const Scalar t_left_foot_41 = Omega_left_foot_zy * t_left_foot_6;
  const Scalar t_left_ankle_cross_80 = t_left_ankle_cross_79 - t_left_foot_41;
  const Scalar t_left_foot_42 = Omega_left_foot_zx * t_left_foot_9;
  const Scalar t_left_ankle_cross_81 = t_left_ankle_cross_80 + t_left_foot_42;
  const Scalar t_left_foot_43 = t_left_foot_2 * t_left_foot_11;
  const Scalar t_left_ankle_cross_82 = t_left_ankle_cross_81 - t_left_foot_43;
  const Scalar t_left_foot_44 = a_left_foot_z * t_left_foot_23;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_82 + t_left_foot_44;
  tau[4] = M_left_ankle_cross_z;
  // left_shank
  const Scalar t_left_shank_37 = M_left_ankle_cross_z - 0.122071088076 * Omega_left_shank_yx;
  const Scalar t_left_shank_38 = t_left_shank_37 + 0.01745977700712 * Omega_left_shank_yz;
  const Scalar t_left_shank_39 = t_left_shank_38 - 0.001559822240256 * Omega_left_shank_xz;
  const Scalar t_left_shank_40 = Omega_left_shank_xx - Omega_left_shank_yy;
  const Scalar t_left_shank_41 = t_left_shank_39 + 0.005291437550784 * Omega_left_shank_xy;
  const Scalar t_left_shank_42 = t_left_shank_41 + 0.01541645551488 * t_left_shank_40;
  const Scalar t_left_shank_43 = t_left_shank_42 - 0.00080309376 * a_left_shank_x;
  const Scalar M_left_shank_z = t_left_shank_43 + t_left_ankle_cross_66;
  tau[3] = M_left_shank_z;
  // left_thigh
  const Scalar t_left_thigh_31 = M_left_shank_z - 0.26256865566306814 * Omega_left_thigh_yx;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + 0.08414236677063168 * Omega_left_thigh_yz;
  const Scalar t_left_thigh_33 = t_left_thigh_32 - 0.00442555309711872 * Omega_left_thigh_xz;
  const Scalar t_left_thigh_34 = Omega_left_thigh_xx - Omega_left_thigh_yy;
  const Scalar t_left_thigh_35 = t_left_thigh_33 + 0.02465049344454144 * Omega_left_thigh_xy;
  const Scalar t_left_thigh_36 = t_left_thigh_35 + 0.01969586999041536 * t_left_thigh_34;
  const Scalar t_left_thigh_37 = t_left_thigh_36 - 0.0014731530912 * a_left_thigh_x;
  const Scalar M_left_thigh_z = t_left_thigh_37 + t_left_shank_36;
  tau[2] = M_left_thigh_z;
  // left_hip_fork
  const Scalar t_left_hip_fork_18 = M_left_thigh_z - 0.0040738553856 * Omega_left_hip_fork_xy;
  const Scalar t_left_hip_fork_19 = 8.079624e-05 * Omega_left_hip_fork_zy;
  const Scalar t_left_hip_fork_20 = t_left_hip_fork_18 + t_left_hip_fork_19;
  const Scalar t_left_hip_fork_21 = 0.00026615232 * Omega_left_hip_fork_zx;
  const Scalar t_left_hip_fork_22 = t_left_hip_fork_5 - t_left_hip_fork_4;
  const Scalar t_left_hip_fork_23 = t_left_hip_fork_20 + t_left_hip_fork_21;
  const Scalar F_left_thigh_y = t_left_shank_35 - 0.0014731530912 * Omega_left_thigh_yy;
  const Scalar t_left_hip_fork_24 = t_left_hip_fork_23 - 0.00011406528 * t_left_hip_fork_22;
  // left_thigh
  const Scalar t_left_thigh_38 = 0.0014731530912 * Omega_left_thigh_xy;
  const Scalar t_left_thigh_39 = t_left_thigh_38 + s_left_knee * F_left_shank_y;
  const Scalar F_left_thigh_x = t_left_thigh_39 - c_left_knee * F_left_shank_x;
  // left_hip_fork
  const Scalar t_left_hip_fork_25 = t_left_hip_fork_24 - s_left_hip_pitch * F_left_thigh_y;
  const Scalar M_left_hip_fork_y = t_left_hip_fork_25 - c_left_hip_pitch * F_left_thigh_x;
  const Scalar t_left_hip_fork_26 = s_left_hip_roll * M_left_hip_fork_y;
  tau[0] = 0.003223043866 * qdd[0] + t_left_hip_fork_26 + t_left_hip_fork_17;
  const Scalar t_left_hip_fork_27 = 0.00026615232 * Omega_left_hip_fork_yx;
  const Scalar t_left_hip_fork_28 = 0.00011406528 * Omega_left_hip_fork_yz;
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_27 + t_left_hip_fork_28;
  const Scalar t_left_hip_fork_30 = 0.0040738553856 * Omega_left_hip_fork_xz;
  const Scalar t_left_hip_fork_31 = 0.02957665238032736 * Omega_left_hip_fork_xy;
  const Scalar t_left_hip_fork_32 = t_left_hip_fork_29 - t_left_hip_fork_30;
  const Scalar t_left_hip_fork_33 = 8.079624e-05 * (t_left_hip_fork_22 + t_left_hip_fork_11);
  const Scalar t_left_hip_fork_34 = t_left_hip_fork_32 + t_left_hip_fork_31;
  const Scalar t_left_hip_fork_35 = t_left_hip_fork_34 + t_left_hip_fork_33;
  const Scalar t_left_hip_fork_36 = t_left_hip_fork_35 + 3.8115095399136 * c_left_hip_roll;
  const Scalar t_left_hip_fork_37 = t_left_hip_fork_36 + 0.0466241832 * s_left_hip_roll;
  const Scalar t_left_hip_fork_38 = t_left_hip_fork_37 + c_left_hip_pitch * M_left_thigh_y;
  tau[1] = t_left_hip_fork_38 + s_left_hip_pitch * M_left_thigh_x;
}

[[gnu::noinline]] void inverse_dynamics_2(const Scalar q[12], const Scalar qd[12],
                                          const Scalar qdd[12], Scalar tau[12]) noexcept {
  const Scalar s_right_hip_pitch = sin(q[8]);
  const Scalar c_right_hip_pitch = cos(q[8]);
  // right_hip_fork
  const Scalar c_right_hip_roll = cos(q[7]);
  const Scalar s_right_hip_roll = sin(q[7]);
  const Scalar omega_right_hip_fork_x = c_right_hip_roll * qd[6];
  const Scalar t_right_thigh_1 = s_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar omega_right_thigh_y = c_right_hip_pitch * qd[7] - t_right_thigh_1;
  const Scalar c_right_knee = cos(q[9]);
  const Scalar s_right_knee = sin(q[9]);
  const Scalar t_right_thigh_2 = c_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar omega_right_thigh_x = s_right_hip_pitch * qd[7] + t_right_thigh_2;
  const Scalar t_right_shank_1 = c_right_knee * omega_right_thigh_y;
  const Scalar omega_right_shank_y = t_right_shank_1 - s_right_knee * omega_right_thigh_x;
  const Scalar s_right_ankle_pitch = sin(q[10]);
  const Scalar c_right_ankle_pitch = cos(q[10]);
  const Scalar t_right_shank_2 = s_right_knee * omega_right_thigh_y;
  const Scalar omega_right_shank_x = t_right_shank_2 + c_right_knee * omega_right_thigh_x;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_1 = s_right_ankle_pitch * omega_right_shank_y;
  const Scalar t_righ_ankl_cros_2 = c_right_ankle_pitch * omega_right_shank_x;
  const Scalar omega_righ_ankl_cros_x = t_righ_ankl_cros_1 + t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_3 = omega_righ_ankl_cros_x * omega_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_4 = c_right_ankle_pitch * omega_right_shank_y;
  const Scalar t_righ_ankl_cros_5 = s_right_ankle_pitch * omega_right_shank_x;
  const Scalar omega_righ_ankl_cros_y = t_righ_ankl_cros_4 - t_righ_ankl_cros_5;
  // right_foot
  const Scalar omega_right_foot_z = omega_righ_ankl_cros_y + qd[11];
  const Scalar t_right_foot_1 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_2 = t_righ_ankl_cros_3 - t_right_foot_1;
  const Scalar omega_right_hip_fork_y = s_right_hip_roll * qd[6];
  const Scalar omega_right_thigh_z = omega_right_hip_fork_y + qd[8];
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  // right_ankle_cross
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_6 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_yy = t_righ_ankl_cros_6 + t_righ_ankl_cros_3;
  // right_foot
  const Scalar Omega_right_foot_xx = Omega_righ_ankl_cros_yy - t_right_foot_2;
  const Scalar Omega_right_foot_yy = t_righ_ankl_cros_3 + t_right_foot_1;
  const Scalar t_right_foot_3 = 0.2614691411136524 - q[11];
  const Scalar c_right_foot = cos(t_right_foot_3);
  const Scalar s_right_foot = sin(t_right_foot_3);
  const Scalar t_right_foot_4 = 0.00013282817963685661 * s_right_foot;
  const Scalar t_right_foot_5 = 7.233379265339546e-05 * c_right_foot + t_right_foot_4;
  const Scalar t_right_foot_6 = 3.616689632669773e-05 - c_right_foot * t_right_foot_5;
  const Scalar t_right_foot_7 = Omega_right_foot_xx - Omega_right_foot_yy;
  const Scalar t_right_foot_8 = t_right_foot_6 * t_right_foot_7;
  // right_hip_fork
  const Scalar Omega_right_hip_fork_yz = c_right_hip_roll * qdd[6];
  const Scalar t_right_hip_fork_1 = omega_right_hip_fork_y * qd[7] * 2.0;
  const Scalar Omega_right_hip_fork_zy = Omega_right_hip_fork_yz - t_right_hip_fork_1;
  const Scalar t_right_hip_fork_2 = omega_right_hip_fork_x * omega_right_hip_fork_y;
  const Scalar Omega_right_hip_fork_xy = qdd[7] + t_right_hip_fork_2;
  // right_thigh
  const Scalar t_right_thigh_3 = c_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_4 = s_right_hip_pitch * Omega_right_hip_fork_xy;
  const Scalar Omega_right_thigh_yz = t_right_thigh_3 + t_right_thigh_4;
  const Scalar t_right_thigh_5 = s_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_6 = c_right_hip_pitch * Omega_right_hip_fork_xy;
  const Scalar Omega_right_thigh_xz = t_right_thigh_5 - t_right_thigh_6;
  // right_shank
  const Scalar t_right_shank_3 = c_right_knee * Omega_right_thigh_yz;
  const Scalar Omega_right_shank_yz = t_right_shank_3 - s_right_knee * Omega_right_thigh_xz;
  const Scalar t_right_shank_4 = s_right_knee * Omega_right_thigh_yz;
  const Scalar Omega_right_shank_xz = t_right_shank_4 + c_right_knee * Omega_right_thigh_xz;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_7 = s_right_ankle_pitch * Omega_right_shank_yz;
  const Scalar t_righ_ankl_cros_8 = c_right_ankle_pitch * Omega_right_shank_xz;
  const Scalar Omega_righ_ankl_cros_xz = t_righ_ankl_cros_7 + t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_9 = omega_righ_ankl_cros_x * omega_righ_ankl_cros_z;
  const Scalar alpha_righ_ankl_cros_y = Omega_righ_ankl_cros_xz + t_righ_ankl_cros_9;
  // right_foot
  const Scalar alpha_right_foot_z = alpha_righ_ankl_cros_y - qdd[11];
  const Scalar Omega_right_foot_yx = t_righ_ankl_cros_9 + alpha_right_foot_z;
  const Scalar t_right_foot_9 = s_right_foot * t_right_foot_5;
  const Scalar t_right_foot_10 = 0.0005569034480192284 - t_right_foot_9;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_10 = c_right_ankle_pitch * Omega_right_shank_yz;
  const Scalar t_righ_ankl_cros_11 = s_right_ankle_pitch * Omega_right_shank_xz;
  const Scalar Omega_righ_ankl_cros_yz = t_righ_ankl_cros_10 - t_righ_ankl_cros_11;
  const Scalar t_righ_ankl_cros_12 = 2.0 * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_13 = omega_righ_ankl_cros_y * t_righ_ankl_cros_12;
  const Scalar Omega_righ_ankl_cros_zy = Omega_righ_ankl_cros_yz + t_righ_ankl_cros_13;
  // right_foot
  const Scalar t_right_foot_11 = 6.298136129784905e-05 * s_right_foot;
  const Scalar t_right_foot_12 = t_right_foot_11 - 0.0014494177603079786 * c_right_foot;
  const Scalar t_right_foot_13 = Omega_righ_ankl_cros_zy * t_right_foot_12;
  const Scalar t_righ_ankl_cros_14 = omega_righ_ankl_cros_x * omega_righ_ankl_cros_y;
  // right_hip_fork
  const Scalar Omega_right_hip_fork_xz = s_right_hip_roll * qdd[6];
  const Scalar t_right_hip_fork_3 = omega_right_hip_fork_x * qd[7];
  const Scalar alpha_right_hip_fork_y = Omega_right_hip_fork_xz + t_right_hip_fork_3;
  const Scalar alpha_right_thigh_z = alpha_right_hip_fork_y + qdd[8];
  const Scalar alpha_right_shank_z = alpha_right_thigh_z + qdd[9];
  const Scalar alpha_righ_ankl_cros_z = alpha_right_shank_z + qdd[10];
  const Scalar Omega_righ_ankl_cros_xy = alpha_righ_ankl_cros_z - t_righ_ankl_cros_14;
  // right_foot
  const Scalar t_right_foot_14 = 6.298136129784905e-05 * c_right_foot;
  const Scalar t_right_foot_15 = t_right_foot_14 + 0.0014494177603079786 * s_right_foot;
  const Scalar t_right_foot_16 = Omega_right_foot_yx * t_right_foot_10 + t_right_foot_13;
  const Scalar t_right_foot_17 = Omega_righ_ankl_cros_xy * t_right_foot_15;
  const Scalar Omega_right_foot_xy = t_righ_ankl_cros_9 - alpha_right_foot_z;
  const Scalar t_right_foot_18 = 0.0004240752683823717 + t_right_foot_9;
  const Scalar t_right_foot_19 = Omega_right_foot_xy * t_right_foot_18;
  const Scalar t_right_foot_20 = t_right_foot_16 - t_right_foot_17 - t_right_foot_19;
  const Scalar t_right_foot_21 = t_right_foot_20 - t_right_foot_8;
  const Scalar Omega_right_hip_block_xx = qd[6] * qd[6];
  // right_thigh
  const Scalar t_right_thigh_7 = Omega_right_hip_fork_xz - 981.0 * c_right_hip_roll;
  const Scalar t_right_thigh_8 = c_right_hip_pitch * Omega_right_hip_block_xx;
  const Scalar a_right_thigh_y = t_right_thigh_8 - s_right_hip_pitch * t_right_thigh_7;
  const Scalar t_right_thigh_9 = omega_right_thigh_x * omega_right_thigh_y;
  const Scalar Omega_right_thigh_yx = alpha_right_thigh_z + t_right_thigh_9;
  const Scalar t_right_shank_5 = a_right_thigh_y + 43.2 * Omega_right_thigh_yx;
  const Scalar t_right_thigh_10 = s_right_hip_pitch * Omega_right_hip_block_xx;
  const Scalar a_right_thigh_x = t_right_thigh_10 + c_right_hip_pitch * t_right_thigh_7;
  const Scalar t_right_thigh_11 = omega_right_thigh_x * omega_right_thigh_x;
  const Scalar t_right_thigh_12 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_13 = t_right_thigh_12 - t_right_thigh_11;
  // right_hip_fork
  const Scalar t_right_hip_fork_4 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_5 = qd[7] * qd[7];
  const Scalar Omega_right_hip_fork_yy = t_right_hip_fork_5 + t_right_hip_fork_4;
  const Scalar Omega_right_thigh_xx = Omega_right_hip_fork_yy + t_right_thigh_13;
  // right_shank
  const Scalar t_right_shank_6 = a_right_thigh_x - 43.2 * Omega_right_thigh_xx;
  const Scalar t_right_shank_7 = c_right_knee * t_right_shank_5;
  const Scalar a_right_shank_y = t_right_shank_7 - s_right_knee * t_right_shank_6;
  const Scalar t_right_shank_8 = omega_right_shank_x * omega_right_shank_y;
  const Scalar Omega_right_shank_yx = alpha_right_shank_z + t_right_shank_8;
  const Scalar t_righ_ankl_cros_15 = a_right_shank_y + 43.3 * Omega_right_shank_yx;
  const Scalar t_right_shank_9 = s_right_knee * t_right_shank_5;
  const Scalar a_right_shank_x = t_right_shank_9 + c_right_knee * t_right_shank_6;
  const Scalar t_right_shank_10 = omega_right_shank_x * omega_right_shank_x;
  const Scalar t_right_shank_11 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_12 = t_right_shank_11 - t_right_shank_10;
  const Scalar Omega_right_shank_xx = Omega_right_hip_fork_yy + t_right_shank_12;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_16 = a_right_shank_x - 43.3 * Omega_right_shank_xx;
  const Scalar t_righ_ankl_cros_17 = s_right_ankle_pitch * t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_18 = c_right_ankle_pitch * t_righ_ankl_cros_16;
  const Scalar a_righ_ankl_cros_x = t_righ_ankl_cros_17 + t_righ_ankl_cros_18;
  const Scalar t_right_foot_22 = t_righ_ankl_cros_6 - t_righ_ankl_cros_3;
  const Scalar Omega_righ_ankl_cros_xx = Omega_right_hip_fork_yy + t_right_foot_22;
  // right_foot
  const Scalar t_right_foot_23 = a_righ_ankl_cros_x - Omega_righ_ankl_cros_xx;
  const Scalar a_right_foot_x = t_right_foot_23 - 2.0 * Omega_righ_ankl_cros_xz;
  const Scalar t_right_foot_24 = 0.00014128635491404698 * s_right_foot;
  const Scalar Omega_righ_ankl_cros_zx = t_righ_ankl_cros_9 + alpha_righ_ankl_cros_y;
  // right_shank
  const Scalar t_right_shank_13 = 2.0 * omega_right_shank_z;
  const Scalar t_right_shank_14 = omega_right_shank_x * t_right_shank_13;
  const Scalar Omega_right_shank_zx = Omega_right_shank_xz + t_right_shank_14;
  // right_thigh
  const Scalar t_right_thigh_14 = 2.0 * omega_right_thigh_z;
  const Scalar t_right_thigh_15 = omega_right_thigh_x * t_right_thigh_14;
  const Scalar Omega_right_thigh_zx = Omega_right_thigh_xz + t_right_thigh_15;
  const Scalar a_right_thigh_z = Omega_right_hip_fork_yz + 981.0 * s_right_hip_roll;
  const Scalar a_right_shank_z = a_right_thigh_z - 43.2 * Omega_right_thigh_zx;
  const Scalar a_righ_ankl_cros_z = a_right_shank_z - 43.3 * Omega_right_shank_zx;
  // right_foot
  const Scalar t_right_foot_25 = a_righ_ankl_cros_z - Omega_righ_ankl_cros_zx;
  const Scalar a_right_foot_y = t_right_foot_25 + 2.0 * Omega_right_hip_fork_yy;
  const Scalar t_right_foot_26 = 0.00014128635491404698 * c_right_foot;
  const Scalar t_right_foot_27 = t_right_foot_21 - a_right_foot_x * t_right_foot_24;
  const Scalar M_right_foot_z = t_right_foot_27 - a_right_foot_y * t_right_foot_26;
  tau[11] = -M_right_foot_z;
  const Scalar t_right_foot_28 = Omega_right_foot_yy * t_right_foot_24;
  const Scalar t_right_foot_29 = 9.4668e-05 * a_right_foot_y + t_right_foot_28;
  const Scalar F_right_foot_y = t_right_foot_29 - Omega_right_foot_yx * t_right_foot_26;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_19 = 0.001106309568 * Omega_righ_ankl_cros_xy;
  const Scalar t_righ_ankl_cros_20 = F_right_foot_y - M_right_foot_z + t_righ_ankl_cros_19;
  const Scalar t_righ_ankl_cros_21 = 0.000549677184 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_20 + t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_23 = 2.40212e-05 * Omega_righ_ankl_cros_zx;
  const Scalar t_righ_ankl_cros_24 = t_righ_ankl_cros_22 - t_righ_ankl_cros_23;
  // right_foot
  const Scalar t_right_foot_30 = Omega_right_foot_xy * t_right_foot_24;
  const Scalar t_right_foot_31 = 9.4668e-05 * a_right_foot_x + t_right_foot_30;
  const Scalar F_right_foot_x = t_right_foot_31 - Omega_right_foot_xx * t_right_foot_26;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_25 = t_righ_ankl_cros_24 - 6.9552e-06 * t_right_foot_22;
  const Scalar M_righ_ankl_cros_y = t_righ_ankl_cros_25 + 2.0 * F_right_foot_x;
  const Scalar t_righ_ankl_cros_26 = F_right_foot_y + 0.000160356 * a_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_27 = 0.000550836384 * Omega_righ_ankl_cros_zy;
  const Scalar F_righ_ankl_cros_z = t_righ_ankl_cros_26 + t_righ_ankl_cros_27;
  // right_shank
  const Scalar Omega_right_shank_xy = alpha_right_shank_z - t_right_shank_8;
  const Scalar t_right_shank_15 = omega_right_shank_y * t_right_shank_13;
  const Scalar Omega_right_shank_zy = Omega_right_shank_yz + t_right_shank_15;
  const Scalar t_right_shank_16 = 0.001559822240256 * Omega_right_shank_xy;
  const Scalar t_right_shank_17 = t_right_shank_16 + 0.01541645551488 * Omega_right_shank_zy;
  const Scalar t_right_shank_18 = t_right_shank_17 - 0.122071088076 * Omega_right_shank_zx;
  const Scalar t_right_shank_19 = t_right_shank_18 + 0.01745977700712 * t_right_shank_12;
  const Scalar t_right_shank_20 = t_right_shank_19 - 43.3 * F_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_28 = c_right_ankle_pitch * M_righ_ankl_cros_y;
  const Scalar t_right_shank_21 = t_right_shank_20 - t_righ_ankl_cros_28;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_29 = 0.0069788989429152 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_30 = 0.000549677184 * Omega_righ_ankl_cros_zx;
  const Scalar Omega_righ_ankl_cros_yx = alpha_righ_ankl_cros_z + t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_31 = t_righ_ankl_cros_29 - t_righ_ankl_cros_30;
  const Scalar t_righ_ankl_cros_32 = 6.9552e-06 * Omega_righ_ankl_cros_yx;
  const Scalar t_righ_ankl_cros_33 = Omega_right_hip_fork_yy - Omega_righ_ankl_cros_yy;
  const Scalar t_righ_ankl_cros_34 = t_righ_ankl_cros_31 - t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_35 = 0.001106309568 * t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_36 = t_righ_ankl_cros_34 + t_righ_ankl_cros_35;
  const Scalar t_righ_ankl_cros_37 = 0.000550836384 * a_righ_ankl_cros_z;
  const Scalar t_right_foot_32 = t_righ_ankl_cros_12 * omega_right_foot_z;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy - t_right_foot_32;
  const Scalar t_righ_ankl_cros_38 = t_righ_ankl_cros_36 + t_righ_ankl_cros_37;
  // right_foot
  const Scalar t_right_foot_33 = Omega_right_foot_zy * t_right_foot_18;
  const Scalar t_right_foot_34 = omega_righ_ankl_cros_x * omega_right_foot_z * 2.0;
  const Scalar Omega_right_foot_zx = Omega_righ_ankl_cros_xy + t_right_foot_34;
  const Scalar t_righ_ankl_cros_39 = t_righ_ankl_cros_38 + t_right_foot_33;
  const Scalar t_right_foot_35 = Omega_right_foot_zx * t_right_foot_6;
  const Scalar t_righ_ankl_cros_40 = t_righ_ankl_cros_39 + t_right_foot_35;
  const Scalar t_right_foot_36 = Omega_right_foot_yx * t_right_foot_12;
  const Scalar t_right_foot_37 = Omega_righ_ankl_cros_yy - Omega_right_foot_yy;
  const Scalar t_righ_ankl_cros_41 = t_righ_ankl_cros_40 + t_right_foot_36;
  const Scalar t_right_foot_38 = t_right_foot_15 * t_right_foot_37;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_42 = c_right_ankle_pitch * t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_43 = s_right_ankle_pitch * t_righ_ankl_cros_16;
  const Scalar a_righ_ankl_cros_y = t_righ_ankl_cros_42 - t_righ_ankl_cros_43;
  const Scalar t_right_foot_39 = a_righ_ankl_cros_y + Omega_righ_ankl_cros_yx;
  const Scalar a_right_foot_z = t_right_foot_39 - 2.0 * Omega_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_44 = t_righ_ankl_cros_41 - t_right_foot_38;
  // right_foot
  const Scalar t_right_foot_40 = a_right_foot_z * t_right_foot_24;
  const Scalar t_right_foot_41 = Omega_right_foot_zy * t_right_foot_24;
  const Scalar t_right_foot_42 = 9.4668e-05 * a_right_foot_z - t_right_foot_41;
  const Scalar F_right_foot_z = t_right_foot_42 + Omega_right_foot_zx * t_right_foot_26;
  const Scalar t_righ_ankl_cros_45 = t_righ_ankl_cros_44 - t_right_foot_40;
  const Scalar M_righ_ankl_cros_x = t_righ_ankl_cros_45 - 2.0 * F_right_foot_z;
  // right_shank
  const Scalar M_right_shank_y = t_right_shank_21 - s_right_ankle_pitch * M_righ_ankl_cros_x;
  const Scalar t_right_shank_22 = F_righ_ankl_cros_z + 0.000584786454 * a_right_shank_z;
  const Scalar F_right_shank_z = t_right_shank_22 - 0.00080309376 * Omega_right_shank_zy;
  // right_thigh
  const Scalar Omega_right_thigh_xy = alpha_right_thigh_z - t_right_thigh_9;
  const Scalar t_right_thigh_16 = omega_right_thigh_y * t_right_thigh_14;
  const Scalar Omega_right_thigh_zy = Omega_right_thigh_yz + t_right_thigh_16;
  const Scalar t_right_thigh_17 = 0.00442555309711872 * Omega_right_thigh_xy;
  const Scalar t_right_thigh_18 = 0.01969586999041536 * Omega_right_thigh_zy;
  const Scalar t_right_thigh_19 = 0.26256865566306814 * Omega_right_thigh_zx;
  const Scalar t_right_thigh_20 = t_right_thigh_17 + t_right_thigh_18 - t_right_thigh_19;
  const Scalar t_right_thigh_21 = t_right_thigh_20 + 0.08414236677063168 * t_right_thigh_13;
  const Scalar t_right_thigh_22 = t_right_thigh_21 - 43.2 * F_right_shank_z;
  // right_shank
  const Scalar t_right_shank_23 = 0.005291437550784 * Omega_right_shank_zy;
  const Scalar t_right_shank_24 = t_right_shank_23 + 0.01541645551488 * Omega_right_shank_zx;
  const Scalar Omega_right_shank_yy = t_right_shank_11 + t_right_shank_10;
  const Scalar t_right_shank_25 = Omega_right_hip_fork_yy - Omega_right_shank_yy;
  const Scalar t_right_shank_26 = t_right_shank_24 - 0.01745977700712 * Omega_right_shank_yx;
  const Scalar t_right_shank_27 = t_right_shank_26 - 0.001559822240256 * t_right_shank_25;
  const Scalar t_right_shank_28 = t_right_shank_27 - 0.00080309376 * a_right_shank_z;
  const Scalar t_righ_ankl_cros_46 = s_right_ankle_pitch * M_righ_ankl_cros_y;
  const Scalar t_right_shank_29 = t_right_shank_28 - t_righ_ankl_cros_46;
  const Scalar M_right_shank_x = t_right_shank_29 + c_right_ankle_pitch * M_righ_ankl_cros_x;
  const Scalar t_right_thigh_23 = t_right_thigh_22 + c_right_knee * M_right_shank_y;
  const Scalar M_right_thigh_y = t_right_thigh_23 - s_right_knee * M_right_shank_x;
  // right_hip_fork
  const Scalar t_right_hip_fork_6 = 0.02957665238032736 * Omega_right_hip_fork_zy;
  const Scalar Omega_right_hip_fork_zx = t_right_hip_fork_3 + alpha_right_hip_fork_y;
  const Scalar t_right_hip_fork_7 = F_right_shank_z + t_right_hip_fork_6;
  const Scalar t_right_hip_fork_8 = 8.079624e-05 * Omega_right_hip_fork_zx;
  const Scalar Omega_right_hip_fork_yx = qdd[7] - t_right_hip_fork_2;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_7 - t_right_hip_fork_8;
  const Scalar t_right_hip_fork_10 = 0.00011406528 * Omega_right_hip_fork_yx;
  const Scalar t_right_hip_fork_11 = Omega_right_hip_block_xx - Omega_right_hip_fork_yy;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_9 + t_right_hip_fork_10;
  const Scalar t_right_hip_fork_13 = 0.0040738553856 * t_right_hip_fork_11;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_12 - t_right_hip_fork_13;
  const Scalar t_right_thigh_24 = 0.0014731530912 * Omega_right_thigh_zy;
  const Scalar t_right_hip_fork_15 = t_right_hip_fork_14 - t_right_thigh_24;
  // right_thigh
  const Scalar t_right_thigh_25 = s_right_hip_pitch * M_right_thigh_y;
  const Scalar t_right_thigh_26 = 0.02465049344454144 * Omega_right_thigh_zy;
  const Scalar t_right_thigh_27 = 0.01969586999041536 * Omega_right_thigh_zx;
  const Scalar t_right_thigh_28 = 0.08414236677063168 * Omega_right_thigh_yx;
  const Scalar Omega_right_thigh_yy = t_right_thigh_12 + t_right_thigh_11;
  const Scalar t_right_thigh_29 = Omega_right_hip_fork_yy - Omega_right_thigh_yy;
  const Scalar t_right_thigh_30 = t_right_thigh_26 + t_right_thigh_27 - t_right_thigh_28;
  const Scalar t_right_thigh_31 = t_right_thigh_30 - 0.00442555309711872 * t_right_thigh_29;
  const Scalar t_right_thigh_32 = t_right_thigh_31 - 0.0014731530912 * a_right_thigh_z;
  const Scalar t_right_thigh_33 = t_right_thigh_32 + s_right_knee * M_right_shank_y;
  const Scalar M_right_thigh_x = t_right_thigh_33 + c_right_knee * M_right_shank_x;
  const Scalar t_right_hip_fork_16 = t_right_hip_fork_15 + t_right_thigh_25;
  const Scalar t_right_thigh_34 = c_right_hip_pitch * M_right_thigh_x;
  const Scalar M_right_hip_fork_x = t_right_hip_fork_16 + t_right_thigh_34;
  const Scalar t_right_hip_fork_17 = c_right_hip_roll * M_right_hip_fork_x;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_47 = F_right_foot_z + 0.000160356 * a_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_48 = 0.000550836384 * Omega_righ_ankl_cros_yy;
  const Scalar F_righ_ankl_cros_y = t_righ_ankl_cros_47 + t_righ_ankl_cros_48;
  const Scalar t_righ_ankl_cros_49 = F_right_foot_x + 0.000160356 * a_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_50 = 0.000550836384 * Omega_righ_ankl_cros_xy;
  const Scalar F_righ_ankl_cros_x = t_righ_ankl_cros_49 + t_righ_ankl_cros_50;
  const Scalar t_righ_ankl_cros_51 = c_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_52 = s_right_ankle_pitch * F_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_53 = t_righ_ankl_cros_51 + t_righ_ankl_cros_52;
  // right_shank
  const Scalar t_right_shank_30 = t_righ_ankl_cros_53 + 0.000584786454 * a_right_shank_y;
  const Scalar F_right_shank_y = t_right_shank_30 - 0.00080309376 * Omega_right_shank_yy;
  const Scalar t_right_shank_31 = 0.00080309376 * Omega_right_shank_xy;
  const Scalar t_right_shank_32 = 0.000584786454 * a_right_shank_x - t_right_shank_31;
  const Scalar t_righ_ankl_cros_54 = s_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar t_right_shank_33 = t_right_shank_32 - t_righ_ankl_cros_54;
  const Scalar F_right_shank_x = t_right_shank_33 + c_right_ankle_pitch * F_righ_ankl_cros_x;
  const Scalar t_right_shank_34 = c_right_knee * F_right_shank_y;
  const Scalar t_right_shank_35 = t_right_shank_34 + s_right_knee * F_right_shank_x;
  const Scalar t_right_shank_36 = 43.2 * t_right_shank_35;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_55 = 43.3 * t_righ_ankl_cros_53;
  const Scalar t_righ_ankl_cros_56 = F_right_foot_z + 2.40212e-05 * Omega_righ_ankl_cros_yx;
  const Scalar t_righ_ankl_cros_57 = 6.9552e-06 * Omega_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_58 = t_righ_ankl_cros_56 - t_righ_ankl_cros_57;
  const Scalar t_righ_ankl_cros_59 = 0.001106309568 * Omega_righ_ankl_cros_xz;
  const Scalar t_righ_ankl_cros_60 = t_righ_ankl_cros_58 - t_righ_ankl_cros_59;
  const Scalar t_righ_ankl_cros_61 = 0.0069788989429152 * Omega_righ_ankl_cros_xy;
  const Scalar t_righ_ankl_cros_62 = Omega_righ_ankl_cros_xx - Omega_righ_ankl_cros_yy;
  const Scalar t_righ_ankl_cros_63 = t_righ_ankl_cros_60 + t_righ_ankl_cros_61;
  const Scalar t_righ_ankl_cros_64 = 0.000549677184 * t_righ_ankl_cros_62;
  const Scalar t_righ_ankl_cros_65 = t_righ_ankl_cros_63 - t_righ_ankl_cros_64;
  const Scalar t_righ_ankl_cros_66 = 0.000550836384 * a_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_67 = t_righ_ankl_cros_65 + t_righ_ankl_cros_66;
  const Scalar t_right_foot_43 = Omega_right_foot_xy * t_right_foot_15;
  const Scalar t_righ_ankl_cros_68 = t_righ_ankl_cros_67 + t_right_foot_43;
  const Scalar t_right_foot_44 = Omega_right_foot_zy * t_right_foot_6;
  const Scalar t_righ_ankl_cros_69 = t_righ_ankl_cros_68 + t_right_foot_44;
  const Scalar t_right_foot_45 = Omega_right_foot_zx * t_right_foot_10;
  const Scalar t_righ_ankl_cros_70 = t_righ_ankl_cros_69 + t_right_foot_45;
  const Scalar t_right_foot_46 = t_right_foot_2 * t_right_foot_12;
  const Scalar t_righ_ankl_cros_71 = t_righ_ankl_cros_70 - t_right_foot_46;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_71 + a_right_foot_z * t_right_foot_26;
  tau[10] = M_righ_ankl_cros_z;
  // right_shank
  const Scalar t_right_shank_37 = M_righ_ankl_cros_z - 0.122071088076 * Omega_right_shank_yx;
  const Scalar t_right_shank_38 = t_right_shank_37 - 0.01745977700712 * Omega_right_shank_yz;
  const Scalar t_right_shank_39 = t_right_shank_38 + 0.001559822240256 * Omega_right_shank_xz;
  const Scalar t_right_shank_40 = Omega_right_shank_xx - Omega_right_shank_yy;
  const Scalar t_right_shank_41 = t_right_shank_39 + 0.005291437550784 * Omega_right_shank_xy;
  const Scalar t_right_shank_42 = t_right_shank_41 + 0.01541645551488 * t_right_shank_40;
  const Scalar t_right_shank_43 = t_right_shank_42 - 0.00080309376 * a_right_shank_x;
  const Scalar M_right_shank_z = t_right_shank_43 + t_righ_ankl_cros_55;
  tau[9] = M_right_shank_z;
  // right_thigh
  const Scalar t_right_thigh_35 = M_right_shank_z - 0.26256865566306814 * Omega_right_thigh_yx;
  const Scalar t_right_thigh_36 = 0.08414236677063168 * Omega_right_thigh_yz;
  const Scalar t_right_thigh_37 = 0.00442555309711872 * Omega_right_thigh_xz;
  const Scalar t_right_thigh_38 = t_right_thigh_35 - t_right_thigh_36 + t_right_thigh_37;
  const Scalar t_right_thigh_39 = 0.02465049344454144 * Omega_right_thigh_xy;
  const Scalar t_right_thigh_40 = Omega_right_thigh_xx - Omega_right_thigh_yy;
  const Scalar t_right_thigh_41 = t_right_thigh_38 + t_right_thigh_39;
  const Scalar t_right_thigh_42 = t_right_thigh_41 + 0.01969586999041536 * t_right_thigh_40;
  const Scalar t_right_thigh_43 = t_right_thigh_42 - 0.0014731530912 * a_right_thigh_x;
  const Scalar M_right_thigh_z = t_right_thigh_43 + t_right_shank_36;
  tau[8] = M_right_thigh_z;
  // right_hip_fork
  const Scalar t_right_hip_fork_18 = 0.0040738553856 * Omega_right_hip_fork_xy;
  const Scalar t_right_hip_fork_19 = M_right_thigh_z + t_right_hip_fork_18;
  const Scalar t_right_hip_fork_20 = 8.079624e-05 * Omega_right_hip_fork_zy;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_19 - t_right_hip_fork_20;
  const Scalar t_right_hip_fork_22 = 0.00026615232 * Omega_right_hip_fork_zx;
  const Scalar t_right_hip_fork_23 = t_right_hip_fork_5 - t_right_hip_fork_4;
  const Scalar t_right_hip_fork_24 = t_right_hip_fork_21 + t_right_hip_fork_22;
  const Scalar t_right_hip_fork_25 = 0.00011406528 * t_right_hip_fork_23;
  const Scalar F_right_thigh_y = t_right_shank_35 - 0.0014731530912 * Omega_right_thigh_yy;
  const Scalar t_right_hip_fork_26 = t_right_hip_fork_24 - t_right_hip_fork_25;
  // right_thigh
  const Scalar t_right_thigh_44 = s_right_hip_pitch * F_right_thigh_y;
  const Scalar t_right_thigh_45 = 0.0014731530912 * Omega_right_thigh_xy;
  const Scalar t_right_thigh_46 = t_right_thigh_45 + s_right_knee * F_right_shank_y;
  const Scalar F_right_thigh_x = t_right_thigh_46 - c_right_knee * F_right_shank_x;
  const Scalar t_right_hip_fork_27 = t_right_hip_fork_26 - t_right_thigh_44;
  const Scalar t_right_thigh_47 = c_right_hip_pitch * F_right_thigh_x;
  const Scalar M_right_hip_fork_y = t_right_hip_fork_27 - t_right_thigh_47;
  const Scalar t_right_hip_fork_28 = s_right_hip_roll * M_right_hip_fork_y;
  tau[6] = 0.003223043866 * qdd[6] + t_right_hip_fork_28 + t_right_hip_fork_17;
  // right_hip_fork
  const Scalar t_right_hip_fork_29 = 0.00026615232 * Omega_right_hip_fork_yx;
  const Scalar t_right_hip_fork_30 = 0.00011406528 * Omega_right_hip_fork_yz;
  const Scalar t_right_hip_fork_31 = t_right_hip_fork_29 + t_right_hip_fork_30;
  const Scalar t_right_hip_fork_32 = 0.0040738553856 * Omega_right_hip_fork_xz;
  const Scalar t_right_hip_fork_33 = t_right_hip_fork_31 + t_right_hip_fork_32;
  const Scalar t_right_hip_fork_34 = 0.02957665238032736 * Omega_right_hip_fork_xy;
  const Scalar t_right_hip_fork_35 = t_right_hip_fork_23 + t_right_hip_fork_11;
  const Scalar t_right_hip_fork_36 = t_right_hip_fork_33 + t_right_hip_fork_34;
  const Scalar t_right_hip_fork_37 = 8.079624e-05 * t_right_hip_fork_35;
  const Scalar t_right_hip_fork_38 = t_right_hip_fork_36 - t_right_hip_fork_37;
  const Scalar t_right_hip_fork_39 = t_right_hip_fork_38 - 3.8115095399136 * c_right_hip_roll;
  const Scalar t_right_hip_fork_40 = t_right_hip_fork_39 + 0.0466241832 * s_right_hip_roll;
  const Scalar t_right_thigh_48 = c_right_hip_pitch * M_right_thigh_y;
  const Scalar t_right_hip_fork_41 = t_right_hip_fork_40 - t_right_thigh_48;
  tau[7] = t_right_hip_fork_41 + s_right_hip_pitch * M_right_thigh_x;
}

}  // namespace

void inverse_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar qdd[12],
                      Scalar tau[12]) noexcept {
  inverse_dynamics_1(q, qd, qdd, tau);
  inverse_dynamics_2(q, qd, qdd, tau);
}

namespace {

struct ForwardDynamicsWorkspace {
  Scalar E_left_foot_xx;
  Scalar t_right_foot_7;
  Scalar s_left_ankle_cross_x;
  Scalar h_left_foot_x;
  Scalar t_right_foot_11;
  Scalar t_right_foot_13;
  Scalar s_left_shank_x;
  Scalar t_right_foot_14;
  Scalar t_right_foot_16;
  Scalar s_left_shank_y;
  Scalar s_left_thigh;
  Scalar c_left_thigh;
  Scalar t_right_foot_17;
  Scalar t_right_foot_18;
  Scalar E_left_foot_xz;
  Scalar E_left_ankle_cross_xy;
  Scalar s_left_ankle_cross_y;
  Scalar t_right_foot_21;
  Scalar t_right_foot_23;
  Scalar t_right_foot_25;
  Scalar E_left_foot_yz;
  Scalar h_left_foot_y;
  Scalar t_right_foot_28;
  Scalar t_right_foot_30;
  Scalar E_left_foot_xy;
  Scalar t_right_foot_32;
  Scalar s_left_hip_roll;
  Scalar c_left_hip_roll;
  Scalar E_left_foot_yy;
  Scalar inverse_pivot_right_foot;
  Scalar t_left_foot_2;
  Scalar t_left_foot_5;
  Scalar t_left_ankle_cross_11;
  Scalar t_left_ankle_cross_12;
  Scalar t_left_foot_9;
  Scalar t_left_ankle_cross_15;
  Scalar inverse_pivot_left_shank;
  Scalar t_left_shank_19;
  Scalar t_left_shank_22;
  Scalar t_left_foot_18;
  Scalar t_left_ankle_cross_21;
  Scalar inverse_pivot_left_thigh;
  Scalar t_left_thigh_29;
  Scalar t_left_thigh_30;
  Scalar t_left_thigh_39;
  Scalar t_left_shank_28;
  Scalar t_left_foot_25;
  Scalar t_left_ankle_cross_30;
  Scalar t_left_thigh_40;
  Scalar t_left_thigh_41;
  Scalar E_right_foot_xx;
  Scalar t_right_foot_43;
  Scalar s_righ_ankl_cros_x;
  Scalar h_right_foot_x;
  Scalar t_right_foot_47;
  Scalar t_right_foot_49;
  Scalar s_right_shank_x;
  Scalar t_right_foot_50;
  Scalar t_right_foot_52;
  Scalar s_right_shank_y;
  Scalar s_right_thigh;
  Scalar c_right_thigh;
  Scalar t_right_foot_53;
  Scalar t_right_foot_54;
  Scalar E_right_foot_xz;
  Scalar E_righ_ankl_cros_xy;
  Scalar s_righ_ankl_cros_y;
  Scalar t_right_foot_57;
  Scalar t_right_foot_59;
  Scalar t_right_foot_61;
  Scalar E_right_foot_yz;
  Scalar h_right_foot_y;
  Scalar t_right_foot_64;
  Scalar t_right_foot_66;
  Scalar E_right_foot_xy;
  Scalar t_right_foot_68;
  Scalar s_right_hip_roll;
  Scalar c_right_hip_roll;
  Scalar E_right_foot_yy;
  Scalar t_right_foot_71;
  Scalar t_right_foot_72;
  Scalar t_right_foot_75;
  Scalar t_righ_ankl_cros_11;
  Scalar t_righ_ankl_cros_12;
  Scalar t_right_foot_79;
  Scalar t_righ_ankl_cros_15;
  Scalar t_right_shank_20;
  Scalar t_right_shank_21;
  Scalar t_right_shank_24;
  Scalar t_right_foot_90;
  Scalar t_righ_ankl_cros_21;
  Scalar t_right_thigh_30;
  Scalar t_right_thigh_31;
  Scalar t_right_thigh_33;
  Scalar t_right_thigh_42;
  Scalar t_right_shank_30;
  Scalar t_right_foot_101;
  Scalar t_righ_ankl_cros_30;
  Scalar t_right_thigh_45;
  Scalar t_right_hip_fork_25;
};

[[gnu::noinline]] void forward_dynamics_1(const Scalar q[12],
                                          ForwardDynamicsWorkspace& w) noexcept {
  // right_foot
  const Scalar t_right_foot_1 = 0.2614691411136524 + q[5];
  const Scalar c_right_foot = cos(t_right_foot_1);
  const Scalar s_right_foot = sin(t_right_foot_1);
  const Scalar t_right_foot_2 = 0.00013282817963685661 * s_right_foot;
  const Scalar t_right_foot_3 = 7.233379265339546e-05 * c_right_foot + t_right_foot_2;
  const Scalar t_right_foot_4 = s_right_foot * t_right_foot_3;
  const Scalar E_left_foot_xx = 0.0005569034480192284 - t_right_foot_4;
  w.E_left_foot_xx = E_left_foot_xx;
  const Scalar t_left_foot_1 = 0.00028257270982809396 * c_right_foot;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_1 = E_left_foot_xx + t_left_foot_1;
  const Scalar c_left_ankle_pitch = cos(q[4]);
  const Scalar s_left_ankle_pitch = sin(q[4]);
  // right_foot
  const Scalar t_right_foot_5 = 0.350779421733216 * s_left_ankle_pitch;
  const Scalar t_right_foot_6 = 0.03083291102976 * c_left_ankle_pitch - t_right_foot_5;
  const Scalar t_right_foot_7 = s_left_ankle_pitch * t_right_foot_6;
  w.t_right_foot_7 = t_right_foot_7;
  const Scalar s_left_ankle_cross_x = 43.3 * c_left_ankle_pitch;
  w.s_left_ankle_cross_x = s_left_ankle_cross_x;
  const Scalar h_left_foot_x = 0.00014128635491404698 * c_right_foot;
  w.h_left_foot_x = h_left_foot_x;
  const Scalar h_left_ankle_cross_x = 9.4668e-05 + h_left_foot_x;
  const Scalar t_left_ankle_cross_2 = s_left_ankle_cross_x * h_left_ankle_cross_x;
  // left_shank
  const Scalar t_left_shank_1 = t_right_foot_7 + 0.356189548484 + t_left_ankle_cross_1;
  const Scalar E_left_shank_xx = t_left_shank_1 + 2.0 * t_left_ankle_cross_2;
  const Scalar t_left_shank_2 = q[3] + q[4];
  const Scalar c_left_shank = cos(t_left_shank_2);
  const Scalar s_left_shank = sin(t_left_shank_2);
  // right_foot
  const Scalar t_right_foot_8 = 0.03939173998083072 * c_left_shank;
  const Scalar t_right_foot_9 = t_right_foot_8 - 1.2800687125653505 * s_left_shank;
  const Scalar t_right_foot_10 = s_left_shank * t_right_foot_9;
  const Scalar t_right_foot_11 = 1.3047192060098918 + t_right_foot_10;
  w.t_right_foot_11 = t_right_foot_11;
  const Scalar t_right_foot_12 = 0.00080309376 * s_left_ankle_pitch;
  const Scalar t_right_foot_13 = t_right_foot_12 + 0.0110425392 * c_left_ankle_pitch;
  w.t_right_foot_13 = t_right_foot_13;
  // left_shank
  const Scalar h_left_shank_x = t_right_foot_13 + h_left_ankle_cross_x;
  const Scalar s_left_shank_x = 43.2 * c_left_shank;
  w.s_left_shank_x = s_left_shank_x;
  const Scalar t_left_shank_3 = s_left_shank_x * h_left_shank_x;
  const Scalar t_left_thigh_1 = t_right_foot_11 + E_left_shank_xx;
  const Scalar E_left_thigh_xx = t_left_thigh_1 + 2.0 * t_left_shank_3;
  const Scalar t_right_foot_14 = 0.02465049344454144 - t_right_foot_10;
  w.t_right_foot_14 = t_right_foot_14;
  const Scalar t_left_shank_4 = t_right_foot_7 - 0.0122703364936992;
  const Scalar E_left_shank_yy = t_left_shank_4 - 0.0477024308544 * s_left_ankle_pitch;
  const Scalar t_right_foot_15 = 0.00080309376 * c_left_ankle_pitch;
  const Scalar t_right_foot_16 = t_right_foot_15 - 0.0110425392 * s_left_ankle_pitch;
  w.t_right_foot_16 = t_right_foot_16;
  const Scalar h_left_shank_y = 0.000550836384 - t_right_foot_16;
  const Scalar s_left_shank_y = 43.2 * s_left_shank;
  w.s_left_shank_y = s_left_shank_y;
  const Scalar t_left_shank_5 = s_left_shank_y * h_left_shank_y;
  // left_thigh
  const Scalar t_left_thigh_2 = t_right_foot_14 - E_left_shank_yy;
  const Scalar E_left_thigh_yy = t_left_thigh_2 + 2.0 * t_left_shank_5;
  const Scalar t_left_thigh_3 = q[2] + t_left_shank_2;
  const Scalar s_left_thigh = sin(t_left_thigh_3);
  w.s_left_thigh = s_left_thigh;
  const Scalar c_left_thigh = cos(t_left_thigh_3);
  w.c_left_thigh = c_left_thigh;
  // right_foot
  const Scalar t_right_foot_17 = 0.01969586999041536 - c_left_shank * t_right_foot_9;
  w.t_right_foot_17 = t_right_foot_17;
  const Scalar t_right_foot_18 = 0.01541645551488 - c_left_ankle_pitch * t_right_foot_6;
  w.t_right_foot_18 = t_right_foot_18;
  const Scalar t_right_foot_19 = 6.298136129784905e-05 * s_right_foot;
  const Scalar E_left_foot_xz = t_right_foot_19 - 0.0014494177603079786 * c_right_foot;
  w.E_left_foot_xz = E_left_foot_xz;
  const Scalar E_left_ankle_cross_xy = 0.000549677184 - E_left_foot_xz;
  w.E_left_ankle_cross_xy = E_left_ankle_cross_xy;
  const Scalar t_left_thigh_4 = t_right_foot_17 + t_right_foot_18;
  const Scalar s_left_ankle_cross_y = 43.3 * s_left_ankle_pitch;
  w.s_left_ankle_cross_y = s_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_3 = s_left_ankle_cross_y * h_left_ankle_cross_x;
  // left_thigh
  const Scalar t_left_thigh_5 = E_left_ankle_cross_xy + t_left_thigh_4;
  const Scalar t_left_thigh_6 = t_left_thigh_5 + t_left_ankle_cross_3;
  const Scalar t_left_thigh_7 = t_left_thigh_6 + 0.0238512154272 * c_left_ankle_pitch;
  const Scalar t_left_thigh_8 = t_left_thigh_7 + s_left_shank_y * h_left_shank_x;
  const Scalar E_left_thigh_xy = t_left_thigh_8 + s_left_shank_x * h_left_shank_y;
  const Scalar t_left_thigh_9 = s_left_thigh * (E_left_thigh_xx - E_left_thigh_yy);
  const Scalar t_left_thigh_10 = c_left_thigh * E_left_thigh_xy * 2.0 - t_left_thigh_9;
  const Scalar t_left_thigh_11 = s_left_thigh * t_left_thigh_10;
  const Scalar E_left_hip_fork_xx = 0.00026615232 + E_left_thigh_xx + t_left_thigh_11;
  const Scalar t_left_hip_block_1 = t_left_thigh_11 - (0.00406285432 + E_left_thigh_yy);
  const Scalar t_right_foot_20 = 0.0014731530912 * c_left_shank;
  const Scalar t_right_foot_21 = t_right_foot_20 - 0.0362798116128 * s_left_shank;
  w.t_right_foot_21 = t_right_foot_21;
  const Scalar h_left_thigh_y = t_right_foot_21 - h_left_shank_y;
  const Scalar t_right_foot_22 = 0.0014731530912 * s_left_shank;
  const Scalar t_right_foot_23 = t_right_foot_22 + 0.0362798116128 * c_left_shank;
  w.t_right_foot_23 = t_right_foot_23;
  const Scalar h_left_thigh_x = t_right_foot_23 + h_left_shank_x;
  const Scalar t_left_thigh_12 = c_left_thigh * h_left_thigh_y;
  const Scalar h_left_hip_fork_z = t_left_thigh_12 + s_left_thigh * h_left_thigh_x;
  const Scalar t_left_hip_block_2 = E_left_hip_fork_xx - t_left_hip_block_1;
  const Scalar t_left_hip_block_3 = t_left_hip_block_2 - 2.0 * h_left_hip_fork_z;
  // right_foot
  const Scalar t_right_foot_24 = 0.001559822240256 * c_left_ankle_pitch;
  const Scalar t_right_foot_25 = t_right_foot_24 - 0.02565802580712 * s_left_ankle_pitch;
  w.t_right_foot_25 = t_right_foot_25;
  const Scalar t_right_foot_26 = 6.298136129784905e-05 * c_right_foot;
  const Scalar E_left_foot_yz = t_right_foot_26 + 0.0014494177603079786 * s_right_foot;
  w.E_left_foot_yz = E_left_foot_yz;
  const Scalar E_left_ankle_cross_yz = 0.001106309568 + E_left_foot_yz;
  const Scalar h_left_foot_y = 0.00014128635491404698 * s_right_foot;
  w.h_left_foot_y = h_left_foot_y;
  const Scalar t_left_ankle_cross_4 = s_left_ankle_cross_y * h_left_foot_y;
  const Scalar t_left_shank_6 = t_right_foot_25 - E_left_ankle_cross_yz;
  const Scalar E_left_shank_yz = t_left_ankle_cross_4 - t_left_shank_6;
  const Scalar t_right_foot_27 = 0.00442555309711872 * c_left_shank;
  const Scalar t_right_foot_28 = t_right_foot_27 - 0.09232168197063167 * s_left_shank;
  w.t_right_foot_28 = t_right_foot_28;
  const Scalar t_left_shank_7 = s_left_shank_y * h_left_foot_y;
  const Scalar E_left_thigh_yz = t_left_shank_7 - (t_right_foot_28 - E_left_shank_yz);
  const Scalar t_right_foot_29 = 0.001559822240256 * s_left_ankle_pitch;
  const Scalar t_right_foot_30 = t_right_foot_29 + 0.02565802580712 * c_left_ankle_pitch;
  w.t_right_foot_30 = t_right_foot_30;
  const Scalar E_left_foot_xy = 3.616689632669773e-05 - c_right_foot * t_right_foot_3;
  w.E_left_foot_xy = E_left_foot_xy;
  const Scalar t_left_ankle_cross_5 = E_left_foot_xy - (0.0001962912 + h_left_foot_y);
  const Scalar E_left_ankle_cross_xz = t_left_foot_1 - t_left_ankle_cross_5;
  const Scalar t_left_shank_8 = t_right_foot_30 + E_left_ankle_cross_xz;
  const Scalar E_left_shank_xz = t_left_shank_8 + s_left_ankle_cross_x * h_left_foot_y;
  const Scalar t_right_foot_31 = 0.00442555309711872 * s_left_shank;
  const Scalar t_right_foot_32 = t_right_foot_31 + 0.09232168197063167 * c_left_shank;
  w.t_right_foot_32 = t_right_foot_32;
  // left_thigh
  const Scalar t_left_thigh_13 = t_right_foot_32 + E_left_shank_xz;
  const Scalar E_left_thigh_xz = t_left_thigh_13 + s_left_shank_x * h_left_foot_y;
  const Scalar t_left_thigh_14 = s_left_thigh * E_left_thigh_yz;
  const Scalar t_left_thigh_15 = t_left_thigh_14 + c_left_thigh * E_left_thigh_xz;
  // left_hip_fork
  const Scalar E_left_hip_fork_xy = 8.079624e-05 + t_left_thigh_15;
  const Scalar s_left_hip_roll = sin(q[1]);
  w.s_left_hip_roll = s_left_hip_roll;
  const Scalar c_left_hip_roll = cos(q[1]);
  w.c_left_hip_roll = c_left_hip_roll;
  const Scalar t_left_hip_fork_1 = t_right_foot_4 + 0.030379399648709733;
  const Scalar E_left_hip_fork_yy = t_left_hip_fork_1 + 0.0005651454196561879 * s_right_foot;
  const Scalar t_left_hip_fork_2 = E_left_hip_fork_xx - E_left_hip_fork_yy;
  const Scalar t_left_hip_fork_3 = s_left_hip_roll * E_left_hip_fork_xy * 2.0;
  const Scalar t_left_hip_fork_4 = c_left_hip_roll * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_3 - t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = c_left_hip_roll * t_left_hip_fork_5;
  const Scalar t_left_hip_block_4 = t_left_hip_block_3 + t_left_hip_fork_6;
  const Scalar E_left_foot_yy = 0.0004240752683823717 + t_right_foot_4;
  w.E_left_foot_yy = E_left_foot_yy;
  const Scalar t_right_foot_33 = E_left_foot_xx + E_left_foot_yy;
  // left_shank
  const Scalar t_left_shank_9 = 1.0 + s_left_shank_x + s_left_ankle_cross_x;
  const Scalar t_left_shank_10 = t_right_foot_33 + 0.00028257270982809396 * s_right_foot;
  const Scalar t_left_shank_11 = t_left_shank_10 + h_left_foot_x * t_left_shank_9;
  const Scalar t_left_shank_12 = h_left_foot_x * (s_left_shank_y + s_left_ankle_cross_y);
  const Scalar t_left_shank_13 = E_left_foot_xz - t_left_shank_12;
  const Scalar t_left_thigh_16 = h_left_foot_x - s_left_thigh * t_left_shank_11;
  const Scalar t_left_thigh_17 = t_left_thigh_16 - c_left_thigh * t_left_shank_13;
  const Scalar t_left_ankle_cross_6 = E_left_foot_yz + t_left_ankle_cross_4;
  const Scalar t_left_shank_14 = t_left_ankle_cross_6 + t_left_shank_7;
  const Scalar t_left_thigh_18 = t_left_shank_14 + c_left_thigh * h_left_foot_y;
  // left_hip_fork
  const Scalar t_left_hip_fork_7 = s_left_hip_roll * t_left_thigh_18;
  const Scalar t_left_hip_fork_8 = c_left_hip_roll * t_left_thigh_17;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_7 - t_left_hip_fork_8;
  const Scalar inverse_pivot_right_foot = 1.0 / t_right_foot_33;
  w.inverse_pivot_right_foot = inverse_pivot_right_foot;
  // left_foot
  const Scalar t_left_foot_2 = t_left_hip_fork_9 * inverse_pivot_right_foot;
  w.t_left_foot_2 = t_left_foot_2;
  const Scalar t_left_foot_3 = t_left_hip_fork_9 * t_left_foot_2;
  const Scalar t_left_foot_4 = t_left_hip_block_4 - t_left_foot_3;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_7 = 0.0070975881429152 + t_left_ankle_cross_1;
  const Scalar t_left_ankle_cross_8 = t_left_ankle_cross_7 + t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_9 = 0.0238512154272 * s_left_ankle_pitch;
  const Scalar t_left_ankle_cross_10 = t_left_ankle_cross_8 + t_left_ankle_cross_9;
  const Scalar t_left_shank_15 = t_left_ankle_cross_10 + 0.0237961317888 * s_left_shank;
  const Scalar t_left_shank_16 = t_left_shank_15 + s_left_shank_x * h_left_ankle_cross_x;
  // left_thigh
  const Scalar t_left_thigh_19 = t_left_shank_16 - s_left_thigh * h_left_ankle_cross_x;
  const Scalar t_left_thigh_20 = t_left_thigh_19 + 0.000550836384 * c_left_thigh;
  const Scalar t_left_thigh_21 = s_left_thigh * E_left_ankle_cross_yz;
  const Scalar t_left_thigh_22 = t_left_thigh_21 + c_left_thigh * E_left_ankle_cross_xz;
  const Scalar t_left_hip_fork_10 = s_left_hip_roll * t_left_thigh_20;
  const Scalar t_left_hip_fork_11 = c_left_hip_roll * t_left_thigh_22;
  const Scalar t_left_foot_5 = E_left_foot_yz * inverse_pivot_right_foot;
  w.t_left_foot_5 = t_left_foot_5;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_10 + t_left_hip_fork_11;
  // left_foot
  const Scalar t_left_foot_6 = t_left_hip_fork_9 * t_left_foot_5;
  const Scalar t_left_foot_7 = t_left_hip_fork_12 - t_left_foot_6;
  const Scalar t_left_foot_8 = t_left_ankle_cross_7 - E_left_foot_yz * t_left_foot_5;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_11 = 1.0 / t_left_foot_8;
  w.t_left_ankle_cross_11 = t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_12 = t_left_foot_7 * t_left_ankle_cross_11;
  w.t_left_ankle_cross_12 = t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_13 = t_left_foot_7 * t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_14 = t_left_foot_4 - t_left_ankle_cross_13;
  const Scalar t_left_foot_9 = t_left_ankle_cross_6 * inverse_pivot_right_foot;
  w.t_left_foot_9 = t_left_foot_9;
  const Scalar t_left_thigh_23 = s_left_thigh * E_left_shank_yz;
  const Scalar t_left_thigh_24 = t_left_thigh_23 + c_left_thigh * E_left_shank_xz;
  const Scalar t_left_shank_17 = E_left_shank_xx - E_left_shank_yy;
  const Scalar t_left_shank_18 = t_left_shank_17 + t_left_shank_3 + t_left_shank_5;
  const Scalar t_left_thigh_25 = t_left_shank_18 - s_left_thigh * h_left_shank_x;
  const Scalar t_left_thigh_26 = t_left_thigh_25 + c_left_thigh * h_left_shank_y;
  // left_hip_fork
  const Scalar t_left_hip_fork_13 = s_left_hip_roll * t_left_thigh_26;
  const Scalar t_left_hip_fork_14 = c_left_hip_roll * t_left_thigh_24;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_13 + t_left_hip_fork_14;
  // left_foot
  const Scalar t_left_foot_10 = t_left_hip_fork_9 * t_left_foot_9;
  const Scalar t_left_foot_11 = t_left_ankle_cross_6 * t_left_foot_5;
  const Scalar t_left_foot_12 = t_left_ankle_cross_10 - t_left_foot_11;
  const Scalar t_left_ankle_cross_15 = t_left_foot_12 * t_left_ankle_cross_11;
  w.t_left_ankle_cross_15 = t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_16 = t_left_foot_7 * t_left_ankle_cross_15;
  const Scalar t_left_foot_13 = t_left_hip_fork_15 - t_left_foot_10;
  const Scalar t_left_ankle_cross_17 = t_left_foot_13 - t_left_ankle_cross_16;
  const Scalar t_left_foot_14 = t_left_ankle_cross_6 * t_left_foot_9;
  const Scalar t_left_ankle_cross_18 = t_left_foot_12 * t_left_ankle_cross_15;
  const Scalar t_left_foot_15 = t_left_shank_17 - t_left_foot_14;
  // left_shank
  const Scalar inverse_pivot_left_shank = 1.0 / (t_left_foot_15 - t_left_ankle_cross_18);
  w.inverse_pivot_left_shank = inverse_pivot_left_shank;
  const Scalar t_left_shank_19 = t_left_ankle_cross_17 * inverse_pivot_left_shank;
  w.t_left_shank_19 = t_left_shank_19;
  const Scalar t_left_shank_20 = t_left_ankle_cross_17 * t_left_shank_19;
  const Scalar t_left_shank_21 = t_left_ankle_cross_14 - t_left_shank_20;
  const Scalar t_left_foot_16 = t_left_shank_16 - t_left_shank_14 * t_left_foot_5;
  const Scalar t_left_foot_17 = t_left_shank_18 - t_left_shank_14 * t_left_foot_9;
  const Scalar t_left_ankle_cross_19 = t_left_foot_16 * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_20 = t_left_foot_17 - t_left_ankle_cross_19;
  const Scalar t_left_shank_22 = t_left_ankle_cross_20 * inverse_pivot_left_shank;
  w.t_left_shank_22 = t_left_shank_22;
  const Scalar t_left_thigh_27 = E_left_thigh_xx + E_left_thigh_yy;
  const Scalar t_left_thigh_28 = t_left_thigh_27 - h_left_hip_fork_z;
  const Scalar t_left_hip_fork_16 = s_left_hip_roll * t_left_thigh_28;
  const Scalar t_left_hip_fork_17 = c_left_hip_roll * t_left_thigh_15;
  const Scalar t_left_foot_18 = t_left_shank_14 * inverse_pivot_right_foot;
  w.t_left_foot_18 = t_left_foot_18;
  const Scalar t_left_hip_fork_18 = t_left_hip_fork_16 + t_left_hip_fork_17;
  const Scalar t_left_foot_19 = t_left_hip_fork_9 * t_left_foot_18;
  const Scalar t_left_ankle_cross_21 = t_left_foot_16 * t_left_ankle_cross_11;
  w.t_left_ankle_cross_21 = t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_22 = t_left_foot_7 * t_left_ankle_cross_21;
  const Scalar t_left_foot_20 = t_left_hip_fork_18 - t_left_foot_19;
  const Scalar t_left_shank_23 = t_left_ankle_cross_17 * t_left_shank_22;
  const Scalar t_left_ankle_cross_23 = t_left_foot_20 - t_left_ankle_cross_22;
  const Scalar t_left_shank_24 = t_left_ankle_cross_23 - t_left_shank_23;
  const Scalar t_left_foot_21 = t_left_thigh_27 - t_left_shank_14 * t_left_foot_18;
  const Scalar t_left_ankle_cross_24 = t_left_foot_16 * t_left_ankle_cross_21;
  const Scalar t_left_shank_25 = t_left_ankle_cross_20 * t_left_shank_22;
  const Scalar t_left_ankle_cross_25 = t_left_foot_21 - t_left_ankle_cross_24;
  // left_thigh
  const Scalar inverse_pivot_left_thigh = 1.0 / (t_left_ankle_cross_25 - t_left_shank_25);
  w.inverse_pivot_left_thigh = inverse_pivot_left_thigh;
  const Scalar t_left_thigh_29 = t_left_shank_24 * inverse_pivot_left_thigh;
  w.t_left_thigh_29 = t_left_thigh_29;
  const Scalar t_left_thigh_30 = t_left_shank_21 - t_left_shank_24 * t_left_thigh_29;
  w.t_left_thigh_30 = t_left_thigh_30;
  const Scalar t_left_thigh_31 = c_left_thigh * t_left_shank_11;
  const Scalar t_left_thigh_32 = t_left_thigh_31 - s_left_thigh * t_left_shank_13;
  const Scalar t_left_thigh_33 = c_left_thigh * E_left_shank_yz;
  const Scalar t_left_thigh_34 = t_left_thigh_33 - s_left_thigh * E_left_shank_xz;
  const Scalar t_left_thigh_35 = c_left_thigh * E_left_ankle_cross_yz;
  const Scalar t_left_thigh_36 = t_left_thigh_35 - s_left_thigh * E_left_ankle_cross_xz;
  const Scalar t_left_foot_22 = t_left_thigh_36 - t_left_thigh_32 * t_left_foot_5;
  const Scalar t_left_foot_23 = t_left_thigh_34 - t_left_thigh_32 * t_left_foot_9;
  const Scalar t_left_ankle_cross_26 = t_left_foot_22 * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_27 = t_left_foot_23 - t_left_ankle_cross_26;
  const Scalar t_left_thigh_37 = c_left_thigh * E_left_thigh_yz;
  const Scalar t_left_thigh_38 = t_left_thigh_37 - s_left_thigh * E_left_thigh_xz;
  const Scalar t_left_foot_24 = t_left_thigh_38 - t_left_thigh_32 * t_left_foot_18;
  const Scalar t_left_ankle_cross_28 = t_left_foot_22 * t_left_ankle_cross_21;
  const Scalar t_left_shank_26 = t_left_ankle_cross_27 * t_left_shank_22;
  const Scalar t_left_ankle_cross_29 = t_left_foot_24 - t_left_ankle_cross_28;
  const Scalar t_left_shank_27 = t_left_ankle_cross_29 - t_left_shank_26;
  const Scalar t_left_thigh_39 = t_left_shank_27 * inverse_pivot_left_thigh;
  w.t_left_thigh_39 = t_left_thigh_39;
  const Scalar t_left_shank_28 = t_left_ankle_cross_27 * inverse_pivot_left_shank;
  w.t_left_shank_28 = t_left_shank_28;
  // left_hip_fork
  const Scalar t_left_hip_fork_19 = 0.00011406528 - E_left_thigh_xy;
  const Scalar t_left_hip_fork_20 = t_left_hip_fork_19 - s_left_thigh * h_left_thigh_y;
  const Scalar t_left_hip_fork_21 = c_left_thigh * (h_left_thigh_x + t_left_thigh_10);
  const Scalar E_left_hip_fork_xz = t_left_hip_fork_20 + t_left_hip_fork_21;
  const Scalar E_left_hip_fork_yz = 0.0042631913856 + h_left_foot_y + t_left_thigh_38;
  const Scalar t_left_hip_fork_22 = s_left_hip_roll * E_left_hip_fork_yz;
  const Scalar t_left_hip_fork_23 = c_left_hip_roll * E_left_hip_fork_xz;
  const Scalar t_left_foot_25 = t_left_thigh_32 * inverse_pivot_right_foot;
  w.t_left_foot_25 = t_left_foot_25;
  const Scalar t_left_hip_fork_24 = t_left_hip_fork_22 - t_left_hip_fork_23;
  const Scalar t_left_foot_26 = t_left_hip_fork_9 * t_left_foot_25;
  const Scalar t_left_ankle_cross_30 = t_left_foot_22 * t_left_ankle_cross_11;
  w.t_left_ankle_cross_30 = t_left_ankle_cross_30;
  const Scalar t_left_ankle_cross_31 = t_left_foot_7 * t_left_ankle_cross_30;
  const Scalar t_left_foot_27 = t_left_hip_fork_24 - t_left_foot_26;
  const Scalar t_left_shank_29 = t_left_ankle_cross_17 * t_left_shank_28;
  const Scalar t_left_ankle_cross_32 = t_left_foot_27 - t_left_ankle_cross_31;
  const Scalar t_left_shank_30 = t_left_ankle_cross_32 - t_left_shank_29;
  const Scalar t_left_thigh_40 = t_left_shank_30 - t_left_shank_24 * t_left_thigh_39;
  w.t_left_thigh_40 = t_left_thigh_40;
  const Scalar t_left_hip_fork_25 = E_left_hip_fork_xx + E_left_hip_fork_yy;
  const Scalar t_left_foot_28 = t_left_hip_fork_25 - t_left_thigh_32 * t_left_foot_25;
  const Scalar t_left_ankle_cross_33 = t_left_foot_22 * t_left_ankle_cross_30;
  const Scalar t_left_shank_31 = t_left_ankle_cross_27 * t_left_shank_28;
  const Scalar t_left_ankle_cross_34 = t_left_foot_28 - t_left_ankle_cross_33;
  const Scalar t_left_shank_32 = t_left_ankle_cross_34 - t_left_shank_31;
  const Scalar t_left_thigh_41 = t_left_shank_32 - t_left_shank_27 * t_left_thigh_39;
  w.t_left_thigh_41 = t_left_thigh_41;
}

[[gnu::noinline]] void forward_dynamics_2(const Scalar qd[12], const Scalar tau[12], Scalar qdd[12],
                                          ForwardDynamicsWorkspace& w) noexcept {
  // left_hip_fork
  const Scalar t_left_hip_fork_26 = 1.0 / w.t_left_thigh_41;
  const Scalar t_left_hip_fork_27 = w.t_left_thigh_40 * t_left_hip_fork_26;
  const Scalar t_left_hip_fork_28 = w.t_left_thigh_40 * t_left_hip_fork_27;
  const Scalar t_left_hip_block_5 = 1.0 / (w.t_left_thigh_30 - t_left_hip_fork_28);
  const Scalar omega_left_hip_fork_x = w.c_left_hip_roll * qd[0];
  // left_thigh
  const Scalar t_left_thigh_42 = w.c_left_thigh * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_x = w.s_left_thigh * qd[1] + t_left_thigh_42;
  const Scalar t_left_thigh_43 = w.s_left_thigh * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_y = w.c_left_thigh * qd[1] - t_left_thigh_43;
  const Scalar t_left_thigh_44 = omega_left_thigh_x * omega_left_thigh_y;
  const Scalar alpha_left_hip_fork_y = omega_left_hip_fork_x * qd[1];
  const Scalar Omega_left_thigh_xy = alpha_left_hip_fork_y - t_left_thigh_44;
  const Scalar t_left_thigh_45 = 2.0 * omega_left_thigh_x;
  // left_foot
  const Scalar omega_left_foot_z = omega_left_thigh_y + qd[5];
  const Scalar t_left_foot_29 = t_left_thigh_45 * omega_left_foot_z;
  const Scalar Omega_left_foot_zx = Omega_left_thigh_xy + t_left_foot_29;
  // left_hip_fork
  const Scalar omega_left_hip_fork_y = w.s_left_hip_roll * qd[0];
  const Scalar alpha_left_hip_fork_x = omega_left_hip_fork_y * qd[1];
  const Scalar Omega_left_hip_fork_zy = 2.0 * alpha_left_hip_fork_x;
  const Scalar Omega_left_hip_fork_xy = omega_left_hip_fork_x * omega_left_hip_fork_y;
  // left_thigh
  const Scalar t_left_thigh_46 = w.c_left_thigh * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_47 = w.s_left_thigh * Omega_left_hip_fork_xy;
  const Scalar Omega_left_thigh_yz = t_left_thigh_46 - t_left_thigh_47;
  const Scalar t_left_thigh_48 = 2.0 * omega_left_thigh_y;
  const Scalar omega_left_thigh_z = omega_left_hip_fork_y + qd[2];
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  // left_ankle_cross
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_35 = t_left_thigh_48 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_36 = Omega_left_thigh_yz - t_left_ankle_cross_35;
  // left_foot
  const Scalar t_left_foot_30 = omega_left_ankle_cross_z * omega_left_foot_z * 2.0;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_36 + t_left_foot_30;
  const Scalar t_left_foot_31 = w.h_left_foot_y * Omega_left_foot_zy;
  const Scalar F_left_foot_z = t_left_foot_31 - w.h_left_foot_x * Omega_left_foot_zx;
  const Scalar Omega_left_thigh_yx = alpha_left_hip_fork_y + t_left_thigh_44;
  const Scalar t_left_ankle_cross_37 = F_left_foot_z - 0.0001186892 * Omega_left_thigh_yx;
  const Scalar t_left_ankle_cross_38 = 0.0001962912 * Omega_left_thigh_yz;
  // left_thigh
  const Scalar t_left_thigh_49 = w.s_left_thigh * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_50 = w.c_left_thigh * Omega_left_hip_fork_xy;
  const Scalar Omega_left_thigh_xz = t_left_thigh_49 + t_left_thigh_50;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_39 = t_left_ankle_cross_37 + t_left_ankle_cross_38;
  const Scalar t_left_ankle_cross_40 = 0.001106309568 * Omega_left_thigh_xz;
  const Scalar t_left_ankle_cross_41 = t_left_ankle_cross_39 + t_left_ankle_cross_40;
  const Scalar t_left_ankle_cross_42 = 0.0069788989429152 * Omega_left_thigh_xy;
  const Scalar t_left_thigh_51 = omega_left_thigh_x * omega_left_thigh_x;
  // left_hip_fork
  const Scalar t_left_hip_fork_29 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_30 = qd[1] * qd[1];
  const Scalar Omega_left_hip_fork_yy = t_left_hip_fork_30 + t_left_hip_fork_29;
  const Scalar t_left_thigh_52 = Omega_left_hip_fork_yy - t_left_thigh_51;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_43 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_44 = t_left_thigh_52 + t_left_ankle_cross_43;
  const Scalar t_left_ankle_cross_45 = t_left_thigh_51 + t_left_ankle_cross_43;
  const Scalar t_left_thigh_53 = t_left_ankle_cross_44 - t_left_ankle_cross_45;
  const Scalar t_left_ankle_cross_46 = t_left_ankle_cross_41 - t_left_ankle_cross_42;
  const Scalar t_left_ankle_cross_47 = 0.000549677184 * t_left_thigh_53;
  const Scalar Omega_left_hip_block_xx = qd[0] * qd[0];
  const Scalar a_left_hip_fork_x = 981.0 * w.c_left_hip_roll;
  // left_thigh
  const Scalar t_left_thigh_54 = w.s_left_thigh * Omega_left_hip_block_xx;
  const Scalar a_left_thigh_x = t_left_thigh_54 - w.c_left_thigh * a_left_hip_fork_x;
  const Scalar t_left_thigh_55 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_56 = t_left_thigh_55 - t_left_thigh_51;
  const Scalar Omega_left_thigh_xx = Omega_left_hip_fork_yy + t_left_thigh_56;
  const Scalar t_left_shank_33 = a_left_thigh_x + w.s_left_shank_y * Omega_left_thigh_xy;
  const Scalar a_left_shank_x = t_left_shank_33 - w.s_left_shank_x * Omega_left_thigh_xx;
  const Scalar t_left_ankle_cross_48 = w.s_left_ankle_cross_y * Omega_left_thigh_xy;
  const Scalar t_left_shank_34 = omega_left_shank_z * omega_left_shank_z;
  const Scalar Omega_left_shank_xx = t_left_thigh_52 + t_left_shank_34;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_49 = w.s_left_ankle_cross_x * Omega_left_shank_xx;
  const Scalar t_left_ankle_cross_50 = a_left_shank_x + t_left_ankle_cross_48;
  const Scalar a_left_ankle_cross_x = t_left_ankle_cross_50 - t_left_ankle_cross_49;
  const Scalar t_left_ankle_cross_51 = t_left_ankle_cross_46 + t_left_ankle_cross_47;
  const Scalar t_left_ankle_cross_52 = 0.000550836384 * a_left_ankle_cross_x;
  // left_thigh
  const Scalar t_left_thigh_57 = w.c_left_thigh * Omega_left_hip_block_xx;
  const Scalar a_left_thigh_y = t_left_thigh_57 + w.s_left_thigh * a_left_hip_fork_x;
  const Scalar Omega_left_thigh_yy = t_left_thigh_55 + t_left_thigh_51;
  // left_shank
  const Scalar t_left_shank_35 = a_left_thigh_y + w.s_left_shank_y * Omega_left_thigh_yy;
  const Scalar a_left_shank_y = t_left_shank_35 + w.s_left_shank_x * Omega_left_thigh_yx;
  const Scalar Omega_left_shank_yy = t_left_thigh_51 + t_left_shank_34;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_53 = w.s_left_ankle_cross_y * Omega_left_shank_yy;
  const Scalar t_left_ankle_cross_54 = w.s_left_ankle_cross_x * Omega_left_thigh_yx;
  const Scalar t_left_ankle_cross_55 = a_left_shank_y + t_left_ankle_cross_53;
  const Scalar a_left_ankle_cross_y = t_left_ankle_cross_55 + t_left_ankle_cross_54;
  const Scalar t_left_ankle_cross_56 = t_left_ankle_cross_51 - t_left_ankle_cross_52;
  const Scalar t_left_ankle_cross_57 = 9.4668e-05 * a_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_58 = omega_left_thigh_x * omega_left_ankle_cross_z;
  const Scalar alpha_left_ankle_cross_y = Omega_left_thigh_xz - t_left_ankle_cross_58;
  const Scalar Omega_left_thigh_xz_2 = t_left_ankle_cross_58 + alpha_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_59 = t_left_ankle_cross_56 - t_left_ankle_cross_57;
  const Scalar t_left_foot_32 = w.E_left_foot_yz * Omega_left_thigh_xz_2;
  const Scalar t_left_ankle_cross_60 = t_left_ankle_cross_59 + t_left_foot_32;
  const Scalar t_left_foot_33 = w.E_left_foot_xy * Omega_left_foot_zy;
  const Scalar t_left_ankle_cross_61 = t_left_ankle_cross_60 - t_left_foot_33;
  // left_foot
  const Scalar t_left_foot_34 = w.E_left_foot_xx * Omega_left_foot_zx;
  const Scalar t_left_foot_35 = omega_left_foot_z * omega_left_foot_z;
  const Scalar t_left_foot_36 = t_left_thigh_51 - t_left_foot_35;
  const Scalar t_left_ankle_cross_62 = t_left_ankle_cross_61 - t_left_foot_34;
  const Scalar t_left_foot_37 = w.E_left_foot_xz * t_left_foot_36;
  const Scalar t_left_foot_38 = Omega_left_thigh_yx + a_left_ankle_cross_y;
  const Scalar a_left_foot_z = t_left_foot_38 - 2.0 * Omega_left_thigh_yz;
  const Scalar t_left_ankle_cross_63 = t_left_ankle_cross_62 + t_left_foot_37;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_63 - w.h_left_foot_x * a_left_foot_z;
  const Scalar t_right_foot_34 = 0.356070859284 + w.t_right_foot_7;
  // left_shank
  const Scalar t_left_shank_36 = t_right_foot_34 * Omega_left_thigh_yx;
  const Scalar t_left_shank_37 = M_left_ankle_cross_z - t_left_shank_36;
  const Scalar t_left_shank_38 = w.t_right_foot_30 * Omega_left_thigh_yz;
  const Scalar t_left_shank_39 = w.t_right_foot_25 * Omega_left_thigh_xz;
  const Scalar t_right_foot_35 = 0.005291437550784 - w.t_right_foot_7;
  const Scalar t_left_shank_40 = t_left_shank_37 + t_left_shank_38 - t_left_shank_39;
  const Scalar t_left_shank_41 = t_right_foot_35 * Omega_left_thigh_xy;
  const Scalar t_left_thigh_58 = Omega_left_shank_xx - Omega_left_shank_yy;
  const Scalar t_left_shank_42 = t_left_shank_40 - t_left_shank_41;
  const Scalar t_left_shank_43 = t_left_shank_42 + w.t_right_foot_18 * t_left_thigh_58;
  const Scalar t_left_shank_44 = t_left_shank_43 + w.t_right_foot_16 * a_left_shank_x;
  // left_foot
  const Scalar Omega_left_foot_xx = t_left_ankle_cross_45 - t_left_foot_36;
  const Scalar t_left_foot_39 = w.h_left_foot_y * Omega_left_thigh_xz_2;
  const Scalar F_left_foot_x = t_left_foot_39 + w.h_left_foot_x * Omega_left_foot_xx;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_64 = F_left_foot_x - 0.000550836384 * Omega_left_thigh_xy;
  const Scalar t_left_ankle_cross_65 = 9.4668e-05 * t_left_ankle_cross_44;
  const Scalar F_left_ankle_cross_x = t_left_ankle_cross_64 + t_left_ankle_cross_65;
  const Scalar t_left_shank_45 = t_left_shank_44 - w.t_right_foot_13 * a_left_shank_y;
  const Scalar t_left_ankle_cross_66 = w.s_left_ankle_cross_y * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_67 = 0.000550836384 * t_left_ankle_cross_45;
  const Scalar t_left_ankle_cross_68 = F_left_foot_z - t_left_ankle_cross_67;
  const Scalar t_left_ankle_cross_69 = 9.4668e-05 * Omega_left_thigh_yx;
  const Scalar F_left_ankle_cross_y = t_left_ankle_cross_68 - t_left_ankle_cross_69;
  const Scalar t_left_shank_46 = t_left_shank_45 + t_left_ankle_cross_66;
  const Scalar t_left_ankle_cross_70 = w.s_left_ankle_cross_x * F_left_ankle_cross_y;
  const Scalar M_left_shank_z = t_left_shank_46 + t_left_ankle_cross_70;
  // left_thigh
  const Scalar t_left_thigh_59 = M_left_shank_z - w.t_right_foot_11 * Omega_left_thigh_yx;
  const Scalar t_left_thigh_60 = w.t_right_foot_32 * Omega_left_thigh_yz;
  const Scalar t_left_thigh_61 = w.t_right_foot_28 * Omega_left_thigh_xz;
  const Scalar t_left_thigh_62 = t_left_thigh_59 + t_left_thigh_60 - t_left_thigh_61;
  const Scalar t_left_thigh_63 = w.t_right_foot_14 * Omega_left_thigh_xy;
  const Scalar t_left_thigh_64 = Omega_left_thigh_xx - Omega_left_thigh_yy;
  const Scalar t_left_thigh_65 = t_left_thigh_62 - t_left_thigh_63;
  const Scalar t_left_thigh_66 = t_left_thigh_65 + w.t_right_foot_17 * t_left_thigh_64;
  const Scalar t_left_thigh_67 = t_left_thigh_66 + w.t_right_foot_21 * a_left_thigh_x;
  // left_shank
  const Scalar t_left_shank_47 = w.t_right_foot_16 * Omega_left_thigh_xy;
  const Scalar t_left_shank_48 = F_left_ankle_cross_x + t_left_shank_47;
  const Scalar F_left_shank_x = t_left_shank_48 + w.t_right_foot_13 * Omega_left_shank_xx;
  const Scalar t_left_thigh_68 = t_left_thigh_67 - w.t_right_foot_23 * a_left_thigh_y;
  const Scalar t_left_shank_49 = w.t_right_foot_16 * Omega_left_shank_yy;
  const Scalar t_left_shank_50 = F_left_ankle_cross_y + t_left_shank_49;
  const Scalar F_left_shank_y = t_left_shank_50 - w.t_right_foot_13 * Omega_left_thigh_yx;
  const Scalar t_left_thigh_69 = t_left_thigh_68 + w.s_left_shank_y * F_left_shank_x;
  const Scalar M_left_thigh_z = t_left_thigh_69 + w.s_left_shank_x * F_left_shank_y;
  const Scalar t_left_hip_block_6 = M_left_thigh_z + tau[2];
  const Scalar Omega_left_foot_yy = t_left_thigh_51 + t_left_foot_35;
  const Scalar t_left_ankle_cross_71 = t_left_ankle_cross_58 - alpha_left_ankle_cross_y;
  // left_foot
  const Scalar t_left_foot_40 = w.E_left_foot_xx * t_left_ankle_cross_71;
  const Scalar t_left_foot_41 = t_left_foot_40 - w.E_left_foot_xz * t_left_ankle_cross_36;
  const Scalar t_left_foot_42 = t_left_foot_41 + w.E_left_foot_yz * Omega_left_thigh_xy;
  const Scalar t_left_foot_43 = w.E_left_foot_xy * (Omega_left_foot_xx - Omega_left_foot_yy);
  const Scalar t_left_foot_44 = t_left_foot_42 - w.E_left_foot_yy * Omega_left_thigh_xz_2;
  const Scalar t_left_foot_45 = a_left_ankle_cross_x - t_left_ankle_cross_44;
  const Scalar a_left_foot_x = t_left_foot_45 - 2.0 * Omega_left_thigh_xz;
  const Scalar t_left_foot_46 = t_left_foot_44 + t_left_foot_43;
  const Scalar t_left_thigh_70 = omega_left_thigh_z * t_left_thigh_48;
  const Scalar Omega_left_thigh_zy = Omega_left_thigh_yz - t_left_thigh_70;
  const Scalar a_left_hip_fork_y = 981.0 * w.s_left_hip_roll;
  const Scalar t_left_thigh_71 = omega_left_thigh_z * t_left_thigh_45;
  const Scalar Omega_left_thigh_zx = Omega_left_thigh_xz - t_left_thigh_71;
  // left_shank
  const Scalar t_left_shank_51 = a_left_hip_fork_y - w.s_left_shank_y * Omega_left_thigh_zy;
  const Scalar a_left_shank_z = t_left_shank_51 + w.s_left_shank_x * Omega_left_thigh_zx;
  const Scalar t_left_shank_52 = t_left_thigh_48 * omega_left_shank_z;
  const Scalar Omega_left_shank_zy = Omega_left_thigh_yz - t_left_shank_52;
  const Scalar t_left_ankle_cross_72 = w.s_left_ankle_cross_y * Omega_left_shank_zy;
  const Scalar t_left_shank_53 = t_left_thigh_45 * omega_left_shank_z;
  const Scalar Omega_left_shank_zx = Omega_left_thigh_xz - t_left_shank_53;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_73 = w.s_left_ankle_cross_x * Omega_left_shank_zx;
  const Scalar t_left_ankle_cross_74 = a_left_shank_z - t_left_ankle_cross_72;
  const Scalar a_left_ankle_cross_z = t_left_ankle_cross_74 + t_left_ankle_cross_73;
  // left_foot
  const Scalar t_left_foot_47 = a_left_ankle_cross_z - t_left_ankle_cross_71;
  const Scalar a_left_foot_y = t_left_foot_47 - 2.0 * Omega_left_hip_fork_yy;
  const Scalar t_left_foot_48 = t_left_foot_46 + w.h_left_foot_y * a_left_foot_x;
  const Scalar M_left_foot_z = t_left_foot_48 - w.h_left_foot_x * a_left_foot_y;
  // left_hip_block
  const Scalar t_left_hip_block_7 = M_left_foot_z + tau[5];
  const Scalar t_left_hip_block_8 = t_left_hip_block_7 * w.t_left_foot_18;
  const Scalar t_left_hip_block_9 = t_left_hip_block_7 * w.t_left_foot_5;
  const Scalar t_left_hip_block_10 = M_left_ankle_cross_z + tau[4] + t_left_hip_block_9;
  const Scalar t_left_hip_block_11 = w.t_left_ankle_cross_21 * t_left_hip_block_10;
  const Scalar t_left_hip_block_12 = t_left_hip_block_6 + t_left_hip_block_8;
  const Scalar t_left_hip_block_13 = t_left_hip_block_7 * w.t_left_foot_9;
  const Scalar t_left_hip_block_14 = M_left_shank_z + tau[3] + t_left_hip_block_13;
  const Scalar t_left_hip_block_15 = w.t_left_ankle_cross_15 * t_left_hip_block_10;
  const Scalar t_left_hip_block_16 = t_left_hip_block_14 - t_left_hip_block_15;
  const Scalar t_left_hip_block_17 = t_left_hip_block_12 - t_left_hip_block_11;
  const Scalar t_left_hip_block_18 = w.t_left_shank_22 * t_left_hip_block_16;
  const Scalar t_left_hip_block_19 = t_left_hip_block_17 - t_left_hip_block_18;
  const Scalar t_left_hip_block_20 = w.t_left_thigh_39 * t_left_hip_block_19;
  const Scalar t_left_foot_49 = w.h_left_foot_x * t_left_ankle_cross_71;
  const Scalar F_left_foot_y = w.h_left_foot_y * Omega_left_foot_yy + t_left_foot_49;
  // left_thigh
  const Scalar t_left_thigh_72 = w.t_right_foot_17 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_73 = F_left_foot_y + M_left_foot_z + t_left_thigh_72;
  const Scalar t_left_thigh_74 = w.t_right_foot_11 * Omega_left_thigh_zx;
  const Scalar t_left_thigh_75 = t_left_thigh_73 - t_left_thigh_74;
  const Scalar t_left_thigh_76 = t_left_thigh_75 - w.t_right_foot_32 * t_left_thigh_56;
  const Scalar t_left_thigh_77 = t_left_thigh_76 - w.t_right_foot_23 * a_left_hip_fork_y;
  // left_shank
  const Scalar t_left_shank_54 = w.t_right_foot_18 * Omega_left_shank_zy;
  const Scalar t_left_shank_55 = t_right_foot_34 * Omega_left_shank_zx;
  const Scalar t_left_shank_56 = Omega_left_hip_fork_yy - Omega_left_shank_xx;
  // left_thigh
  const Scalar t_left_thigh_78 = t_left_thigh_77 + t_left_shank_54 - t_left_shank_55;
  const Scalar t_left_thigh_79 = t_left_thigh_78 + w.t_right_foot_30 * t_left_shank_56;
  const Scalar t_left_thigh_80 = t_left_thigh_79 - w.t_right_foot_13 * a_left_shank_z;
  const Scalar t_left_thigh_81 = t_left_thigh_80 + 0.000549677184 * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_75 = Omega_left_hip_fork_yy - t_left_ankle_cross_44;
  const Scalar t_left_thigh_82 = t_left_thigh_81 + 0.0001186892 * t_left_ankle_cross_71;
  const Scalar t_left_thigh_83 = t_left_thigh_82 + 0.0001962912 * t_left_ankle_cross_75;
  const Scalar t_left_thigh_84 = t_left_thigh_83 - 9.4668e-05 * a_left_ankle_cross_z;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_76 = 0.000550836384 * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_77 = F_left_foot_y + t_left_ankle_cross_76;
  const Scalar t_left_ankle_cross_78 = 9.4668e-05 * t_left_ankle_cross_71;
  const Scalar F_left_ankle_cross_z = t_left_ankle_cross_77 + t_left_ankle_cross_78;
  const Scalar t_left_ankle_cross_79 = w.s_left_ankle_cross_x * F_left_ankle_cross_z;
  const Scalar t_left_thigh_85 = t_left_thigh_84 - 2.0 * F_left_foot_x;
  // left_shank
  const Scalar t_left_shank_57 = w.t_right_foot_16 * Omega_left_shank_zy;
  const Scalar t_left_shank_58 = F_left_ankle_cross_z - t_left_shank_57;
  const Scalar F_left_shank_z = t_left_shank_58 - w.t_right_foot_13 * Omega_left_shank_zx;
  // left_thigh
  const Scalar t_left_thigh_86 = t_left_thigh_85 + t_left_ankle_cross_79;
  const Scalar t_left_thigh_87 = w.t_right_foot_25 - (0.001106309568 - w.t_right_foot_28);
  const Scalar t_left_thigh_88 = t_left_thigh_86 + w.s_left_shank_x * F_left_shank_z;
  const Scalar M_left_thigh_y = t_left_thigh_88 - Omega_left_thigh_xy * t_left_thigh_87;
  // left_hip_fork
  const Scalar t_left_hip_fork_31 = t_left_hip_fork_30 - t_left_hip_fork_29;
  const Scalar t_left_hip_fork_32 = Omega_left_hip_block_xx - Omega_left_hip_fork_yy;
  const Scalar t_left_hip_fork_33 = t_left_hip_fork_31 + t_left_hip_fork_32;
  const Scalar t_left_hip_block_21 = tau[1] - 8.079624e-05 * t_left_hip_fork_33;
  const Scalar t_left_hip_fork_34 = 3.9972481559136 * w.c_left_hip_roll;
  // left_hip_block
  const Scalar t_left_hip_block_22 = t_left_hip_block_21 - t_left_hip_fork_34;
  const Scalar t_left_hip_block_23 = t_left_hip_block_22 - 0.0466241832 * w.s_left_hip_roll;
  const Scalar t_left_hip_block_24 = t_left_hip_block_23 + w.c_left_thigh * M_left_thigh_y;
  // left_thigh
  const Scalar t_left_thigh_89 = w.t_right_foot_14 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_90 = w.t_right_foot_17 * Omega_left_thigh_zx;
  const Scalar t_left_thigh_91 = Omega_left_hip_fork_yy - Omega_left_thigh_yy;
  const Scalar t_left_thigh_92 = t_left_thigh_89 - t_left_thigh_90;
  const Scalar t_left_thigh_93 = t_left_thigh_92 - w.t_right_foot_28 * t_left_thigh_91;
  const Scalar t_left_thigh_94 = t_left_thigh_93 + w.t_right_foot_21 * a_left_hip_fork_y;
  // left_shank
  const Scalar t_left_shank_59 = t_right_foot_35 * Omega_left_shank_zy;
  const Scalar t_left_shank_60 = w.t_right_foot_18 * Omega_left_shank_zx;
  const Scalar t_left_shank_61 = Omega_left_hip_fork_yy - Omega_left_shank_yy;
  // left_thigh
  const Scalar t_left_thigh_95 = t_left_thigh_94 + t_left_shank_59 - t_left_shank_60;
  const Scalar t_left_thigh_96 = t_left_thigh_95 - w.t_right_foot_25 * t_left_shank_61;
  const Scalar t_left_thigh_97 = t_left_thigh_96 + w.t_right_foot_16 * a_left_shank_z;
  const Scalar t_left_ankle_cross_80 = 0.0069788989429152 * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_81 = Omega_left_hip_fork_yy - t_left_ankle_cross_45;
  const Scalar t_left_thigh_98 = t_left_thigh_97 + t_left_ankle_cross_80;
  const Scalar t_left_thigh_99 = t_left_thigh_98 + 0.001106309568 * t_left_ankle_cross_81;
  const Scalar t_left_thigh_100 = t_left_thigh_99 - 0.000550836384 * a_left_ankle_cross_z;
  const Scalar t_left_thigh_101 = t_left_thigh_100 + w.E_left_foot_yy * Omega_left_foot_zy;
  const Scalar t_left_foot_50 = t_left_ankle_cross_45 - Omega_left_foot_yy;
  const Scalar t_left_thigh_102 = t_left_thigh_101 + w.E_left_foot_xy * Omega_left_foot_zx;
  const Scalar t_left_thigh_103 = t_left_thigh_102 - w.E_left_foot_yz * t_left_foot_50;
  const Scalar t_left_thigh_104 = t_left_thigh_103 - w.h_left_foot_y * a_left_foot_z;
  const Scalar t_left_ankle_cross_82 = w.s_left_ankle_cross_y * F_left_ankle_cross_z;
  const Scalar t_left_thigh_105 = t_left_thigh_104 + 2.0 * F_left_foot_z;
  const Scalar t_left_thigh_106 = t_left_thigh_105 + t_left_ankle_cross_82;
  const Scalar t_left_thigh_107 = 0.0001962912 + w.t_right_foot_32 + w.t_right_foot_30;
  const Scalar t_left_thigh_108 = t_left_thigh_106 + w.s_left_shank_y * F_left_shank_z;
  const Scalar t_left_thigh_109 = Omega_left_thigh_yx * t_left_thigh_107;
  const Scalar t_left_thigh_110 = w.E_left_ankle_cross_xy * t_left_ankle_cross_71;
  const Scalar M_left_thigh_x = t_left_thigh_108 - t_left_thigh_109 + t_left_thigh_110;
  // left_hip_block
  const Scalar t_left_hip_block_25 = t_left_hip_block_24 + w.s_left_thigh * M_left_thigh_x;
  const Scalar t_left_hip_block_26 = t_left_hip_block_7 * w.t_left_foot_25;
  const Scalar t_left_hip_block_27 = w.t_left_ankle_cross_30 * t_left_hip_block_10;
  const Scalar t_left_hip_block_28 = t_left_hip_block_25 - t_left_hip_block_26;
  const Scalar t_left_hip_block_29 = t_left_hip_block_28 + t_left_hip_block_27;
  const Scalar t_left_hip_block_30 = w.t_left_shank_28 * t_left_hip_block_16;
  const Scalar t_left_hip_block_31 = t_left_hip_block_29 + t_left_hip_block_30;
  const Scalar t_left_hip_block_32 = t_left_hip_block_31 + t_left_hip_block_20;
  const Scalar t_left_hip_fork_35 = 0.02968917206032736 * Omega_left_hip_fork_xy;
  const Scalar t_left_hip_block_33 = t_left_hip_block_32 - t_left_hip_fork_35;
  const Scalar t_left_hip_block_34 = t_left_hip_fork_27 * t_left_hip_block_33;
  const Scalar t_left_hip_block_35 = w.t_left_thigh_29 * t_left_hip_block_19;
  // left_hip_fork
  const Scalar t_left_hip_fork_36 = 0.05991064876065472 * alpha_left_hip_fork_x;
  const Scalar t_left_hip_fork_37 = F_left_shank_z + t_left_hip_fork_36;
  const Scalar t_left_hip_fork_38 = 0.00016159248 * alpha_left_hip_fork_y;
  const Scalar t_left_hip_fork_39 = t_left_hip_fork_37 - t_left_hip_fork_38;
  const Scalar t_left_hip_fork_40 = 0.00011406528 * Omega_left_hip_fork_xy;
  const Scalar t_left_hip_fork_41 = t_left_hip_fork_39 + t_left_hip_fork_40;
  const Scalar t_left_hip_fork_42 = 0.0042631913856 * t_left_hip_fork_32;
  const Scalar t_left_hip_fork_43 = t_left_hip_fork_41 - t_left_hip_fork_42;
  const Scalar t_left_thigh_111 = w.t_right_foot_21 * Omega_left_thigh_zy;
  const Scalar t_left_hip_fork_44 = t_left_hip_fork_43 - t_left_thigh_111;
  const Scalar t_left_thigh_112 = w.t_right_foot_23 * Omega_left_thigh_zx;
  const Scalar t_left_hip_fork_45 = t_left_hip_fork_44 - t_left_thigh_112;
  const Scalar t_left_hip_fork_46 = t_left_hip_fork_45 - w.s_left_thigh * M_left_thigh_y;
  const Scalar M_left_hip_fork_x = t_left_hip_fork_46 + w.c_left_thigh * M_left_thigh_x;
  const Scalar t_left_hip_fork_47 = M_left_thigh_z + 0.0042631913856 * Omega_left_hip_fork_xy;
  const Scalar t_left_hip_fork_48 = 0.00016159248 * alpha_left_hip_fork_x;
  const Scalar t_left_hip_fork_49 = t_left_hip_fork_47 + t_left_hip_fork_48;
  const Scalar t_left_hip_fork_50 = 0.00053230464 * alpha_left_hip_fork_y;
  const Scalar t_left_hip_fork_51 = t_left_hip_fork_49 - t_left_hip_fork_50;
  const Scalar t_left_hip_fork_52 = 0.00011406528 * t_left_hip_fork_31;
  const Scalar t_left_thigh_113 = F_left_shank_y + w.t_right_foot_21 * Omega_left_thigh_yy;
  const Scalar F_left_thigh_y = t_left_thigh_113 - w.t_right_foot_23 * Omega_left_thigh_yx;
  const Scalar t_left_hip_fork_53 = t_left_hip_fork_51 + t_left_hip_fork_52;
  const Scalar t_left_thigh_114 = F_left_shank_x + w.t_right_foot_21 * Omega_left_thigh_xy;
  const Scalar F_left_thigh_x = t_left_thigh_114 + w.t_right_foot_23 * Omega_left_thigh_xx;
  const Scalar t_left_hip_fork_54 = t_left_hip_fork_53 - w.s_left_thigh * F_left_thigh_y;
  const Scalar M_left_hip_fork_y = t_left_hip_fork_54 + w.c_left_thigh * F_left_thigh_x;
  const Scalar t_left_hip_block_36 = tau[0] + w.s_left_hip_roll * M_left_hip_fork_y;
  const Scalar t_left_hip_fork_55 = w.c_left_hip_roll * M_left_hip_fork_x;
  // left_hip_block
  const Scalar t_left_hip_block_37 = t_left_hip_block_36 + t_left_hip_fork_55;
  const Scalar t_left_hip_block_38 = t_left_hip_block_7 * w.t_left_foot_2;
  const Scalar t_left_hip_block_39 = w.t_left_ankle_cross_12 * t_left_hip_block_10;
  const Scalar t_left_hip_block_40 = t_left_hip_block_37 + t_left_hip_block_38;
  const Scalar t_left_hip_block_41 = t_left_hip_block_40 - t_left_hip_block_39;
  const Scalar t_left_hip_block_42 = w.t_left_shank_19 * t_left_hip_block_16;
  const Scalar t_left_hip_block_43 = t_left_hip_block_41 - t_left_hip_block_42;
  const Scalar t_left_hip_block_44 = t_left_hip_block_43 - t_left_hip_block_35;
  const Scalar t_left_hip_block_45 = t_left_hip_block_44 + t_left_hip_block_34;
  const Scalar t_left_hip_block_46 = t_left_hip_block_5 * t_left_hip_block_45;
  qdd[0] = t_left_hip_block_46;
  const Scalar t_left_hip_block_47 = t_left_hip_fork_26 * t_left_hip_block_33;
  const Scalar t_left_hip_block_48 = t_left_hip_fork_27 * t_left_hip_block_46;
  const Scalar t_left_hip_block_49 = t_left_hip_block_47 + t_left_hip_block_48;
  qdd[1] = t_left_hip_block_49;
  const Scalar t_left_hip_block_50 = w.inverse_pivot_left_thigh * t_left_hip_block_19;
  const Scalar t_left_hip_block_51 = w.t_left_thigh_39 * t_left_hip_block_49;
  const Scalar t_left_hip_block_52 = t_left_hip_block_50 + t_left_hip_block_51;
  const Scalar t_left_hip_block_53 = w.t_left_thigh_29 * t_left_hip_block_46;
  const Scalar t_left_hip_block_54 = t_left_hip_block_52 - t_left_hip_block_53;
  qdd[2] = t_left_hip_block_54;
  const Scalar t_left_hip_block_55 = w.inverse_pivot_left_shank * t_left_hip_block_16;
  const Scalar t_left_hip_block_56 = w.t_left_shank_22 * t_left_hip_block_54;
  const Scalar t_left_hip_block_57 = t_left_hip_block_55 - t_left_hip_block_56;
  const Scalar t_left_hip_block_58 = w.t_left_shank_28 * t_left_hip_block_49;
  const Scalar t_left_hip_block_59 = t_left_hip_block_57 + t_left_hip_block_58;
  const Scalar t_left_hip_block_60 = w.t_left_shank_19 * t_left_hip_block_46;
  const Scalar t_left_hip_block_61 = t_left_hip_block_59 - t_left_hip_block_60;
  qdd[3] = t_left_hip_block_61;
  const Scalar t_left_hip_block_62 = w.t_left_ankle_cross_11 * t_left_hip_block_10;
  const Scalar t_left_hip_block_63 = w.t_left_ankle_cross_15 * t_left_hip_block_61;
  const Scalar t_left_hip_block_64 = w.t_left_ankle_cross_21 * t_left_hip_block_54;
  const Scalar t_left_hip_block_65 = t_left_hip_block_62 - t_left_hip_block_63;
  const Scalar t_left_hip_block_66 = w.t_left_ankle_cross_30 * t_left_hip_block_49;
  const Scalar t_left_hip_block_67 = t_left_hip_block_65 - t_left_hip_block_64;
  const Scalar t_left_hip_block_68 = w.t_left_ankle_cross_12 * t_left_hip_block_46;
  const Scalar t_left_hip_block_69 = t_left_hip_block_67 + t_left_hip_block_66;
  const Scalar t_left_hip_block_70 = t_left_hip_block_69 - t_left_hip_block_68;
  qdd[4] = t_left_hip_block_70;
  const Scalar t_left_hip_block_71 = t_left_hip_block_7 * w.inverse_pivot_right_foot;
  const Scalar t_left_hip_block_72 = w.t_left_foot_5 * t_left_hip_block_70;
  const Scalar t_left_hip_block_73 = t_left_hip_block_71 + t_left_hip_block_72;
  const Scalar t_left_hip_block_74 = w.t_left_foot_9 * t_left_hip_block_61;
  const Scalar t_left_hip_block_75 = t_left_hip_block_73 + t_left_hip_block_74;
  const Scalar t_left_hip_block_76 = w.t_left_foot_18 * t_left_hip_block_54;
  const Scalar t_left_hip_block_77 = t_left_hip_block_75 + t_left_hip_block_76;
  const Scalar t_left_hip_block_78 = w.t_left_foot_25 * t_left_hip_block_49;
  const Scalar t_left_hip_block_79 = t_left_hip_block_77 - t_left_hip_block_78;
  qdd[5] = t_left_hip_block_79 + w.t_left_foot_2 * t_left_hip_block_46;
}

[[gnu::noinline]] void forward_dynamics_3(const Scalar q[12],
                                          ForwardDynamicsWorkspace& w) noexcept {
  // right_foot
  const Scalar t_right_foot_36 = 0.2614691411136524 - q[11];
  const Scalar c_right_foot_2 = cos(t_right_foot_36);
  const Scalar s_right_foot_2 = sin(t_right_foot_36);
  const Scalar t_right_foot_37 = 0.00013282817963685661 * s_right_foot_2;
  const Scalar t_right_foot_38 = 7.233379265339546e-05 * c_right_foot_2 + t_right_foot_37;
  const Scalar t_right_foot_39 = s_right_foot_2 * t_right_foot_38;
  const Scalar E_right_foot_xx = 0.0005569034480192284 - t_right_foot_39;
  w.E_right_foot_xx = E_right_foot_xx;
  const Scalar t_right_foot_40 = 0.00028257270982809396 * c_right_foot_2;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_1 = E_right_foot_xx + t_right_foot_40;
  const Scalar c_right_ankle_pitch = cos(q[10]);
  const Scalar s_right_ankle_pitch = sin(q[10]);
  // right_foot
  const Scalar t_right_foot_41 = 0.350779421733216 * s_right_ankle_pitch;
  const Scalar t_right_foot_42 = 0.03083291102976 * c_right_ankle_pitch - t_right_foot_41;
  const Scalar t_right_foot_43 = s_right_ankle_pitch * t_right_foot_42;
  w.t_right_foot_43 = t_right_foot_43;
  const Scalar s_righ_ankl_cros_x = 43.3 * c_right_ankle_pitch;
  w.s_righ_ankl_cros_x = s_righ_ankl_cros_x;
  const Scalar h_right_foot_x = 0.00014128635491404698 * c_right_foot_2;
  w.h_right_foot_x = h_right_foot_x;
  const Scalar h_righ_ankl_cros_x = 9.4668e-05 + h_right_foot_x;
  const Scalar t_righ_ankl_cros_2 = s_righ_ankl_cros_x * h_righ_ankl_cros_x;
  // right_shank
  const Scalar t_right_shank_1 = t_right_foot_43 + 0.356189548484 + t_righ_ankl_cros_1;
  const Scalar E_right_shank_xx = t_right_shank_1 + 2.0 * t_righ_ankl_cros_2;
  const Scalar t_right_shank_2 = q[9] + q[10];
  const Scalar c_right_shank = cos(t_right_shank_2);
  const Scalar s_right_shank = sin(t_right_shank_2);
  // right_foot
  const Scalar t_right_foot_44 = 0.03939173998083072 * c_right_shank;
  const Scalar t_right_foot_45 = t_right_foot_44 - 1.2800687125653505 * s_right_shank;
  const Scalar t_right_foot_46 = s_right_shank * t_right_foot_45;
  const Scalar t_right_foot_47 = 1.3047192060098918 + t_right_foot_46;
  w.t_right_foot_47 = t_right_foot_47;
  const Scalar t_right_foot_48 = 0.00080309376 * s_right_ankle_pitch;
  const Scalar t_right_foot_49 = t_right_foot_48 + 0.0110425392 * c_right_ankle_pitch;
  w.t_right_foot_49 = t_right_foot_49;
  // right_shank
  const Scalar h_right_shank_x = t_right_foot_49 + h_righ_ankl_cros_x;
  const Scalar s_right_shank_x = 43.2 * c_right_shank;
  w.s_right_shank_x = s_right_shank_x;
  const Scalar t_right_shank_3 = s_right_shank_x * h_right_shank_x;
  const Scalar t_right_thigh_1 = t_right_foot_47 + E_right_shank_xx;
  const Scalar E_right_thigh_xx = t_right_thigh_1 + 2.0 * t_right_shank_3;
  const Scalar t_right_foot_50 = 0.02465049344454144 - t_right_foot_46;
  w.t_right_foot_50 = t_right_foot_50;
  const Scalar t_right_shank_4 = t_right_foot_43 - 0.0122703364936992;
  const Scalar E_right_shank_yy = t_right_shank_4 - 0.0477024308544 * s_right_ankle_pitch;
  const Scalar t_right_foot_51 = 0.00080309376 * c_right_ankle_pitch;
  const Scalar t_right_foot_52 = t_right_foot_51 - 0.0110425392 * s_right_ankle_pitch;
  w.t_right_foot_52 = t_right_foot_52;
  const Scalar h_right_shank_y = 0.000550836384 - t_right_foot_52;
  const Scalar s_right_shank_y = 43.2 * s_right_shank;
  w.s_right_shank_y = s_right_shank_y;
  const Scalar t_right_shank_5 = s_right_shank_y * h_right_shank_y;
  // right_thigh
  const Scalar t_right_thigh_2 = t_right_foot_50 - E_right_shank_yy;
  const Scalar E_right_thigh_yy = t_right_thigh_2 + 2.0 * t_right_shank_5;
  const Scalar t_right_thigh_3 = q[8] + t_right_shank_2;
  const Scalar s_right_thigh = sin(t_right_thigh_3);
  w.s_right_thigh = s_right_thigh;
  const Scalar c_right_thigh = cos(t_right_thigh_3);
  w.c_right_thigh = c_right_thigh;
  // right_foot
  const Scalar t_right_foot_53 = 0.01969586999041536 - c_right_shank * t_right_foot_45;
  w.t_right_foot_53 = t_right_foot_53;
  const Scalar t_right_foot_54 = 0.01541645551488 - c_right_ankle_pitch * t_right_foot_42;
  w.t_right_foot_54 = t_right_foot_54;
  const Scalar t_right_foot_55 = 6.298136129784905e-05 * s_right_foot_2;
  const Scalar E_right_foot_xz = t_right_foot_55 - 0.0014494177603079786 * c_right_foot_2;
  w.E_right_foot_xz = E_right_foot_xz;
  const Scalar E_righ_ankl_cros_xy = 0.000549677184 - E_right_foot_xz;
  w.E_righ_ankl_cros_xy = E_righ_ankl_cros_xy;
  const Scalar t_right_thigh_4 = t_right_foot_53 + t_right_foot_54;
  const Scalar s_righ_ankl_cros_y = 43.3 * s_right_ankle_pitch;
  w.s_righ_ankl_cros_y = s_righ_ankl_cros_y;
  const Scalar t_right_thigh_5 = E_righ_ankl_cros_xy + t_right_thigh_4;
  const Scalar t_righ_ankl_cros_3 = s_righ_ankl_cros_y * h_righ_ankl_cros_x;
  // right_thigh
  const Scalar t_right_thigh_6 = t_right_thigh_5 + t_righ_ankl_cros_3;
  const Scalar t_right_thigh_7 = t_right_thigh_6 + 0.0238512154272 * c_right_ankle_pitch;
  const Scalar t_right_thigh_8 = t_right_thigh_7 + s_right_shank_y * h_right_shank_x;
  const Scalar E_right_thigh_xy = t_right_thigh_8 + s_right_shank_x * h_right_shank_y;
  const Scalar t_right_thigh_9 = s_right_thigh * (E_right_thigh_xx - E_right_thigh_yy);
  const Scalar t_right_thigh_10 = c_right_thigh * E_right_thigh_xy * 2.0;
  const Scalar t_right_thigh_11 = t_right_thigh_10 - t_right_thigh_9;
  const Scalar t_right_thigh_12 = s_right_thigh * t_right_thigh_11;
  const Scalar E_right_hip_fork_xx = 0.00026615232 + E_right_thigh_xx + t_right_thigh_12;
  const Scalar t_right_hip_block_1 = t_right_thigh_12 - (0.00406285432 + E_right_thigh_yy);
  const Scalar t_right_foot_56 = 0.0014731530912 * c_right_shank;
  const Scalar t_right_foot_57 = t_right_foot_56 - 0.0362798116128 * s_right_shank;
  w.t_right_foot_57 = t_right_foot_57;
  const Scalar h_right_thigh_y = t_right_foot_57 - h_right_shank_y;
  const Scalar t_right_foot_58 = 0.0014731530912 * s_right_shank;
  const Scalar t_right_foot_59 = t_right_foot_58 + 0.0362798116128 * c_right_shank;
  w.t_right_foot_59 = t_right_foot_59;
  const Scalar h_right_thigh_x = t_right_foot_59 + h_right_shank_x;
  const Scalar t_right_thigh_13 = c_right_thigh * h_right_thigh_y;
  const Scalar h_right_hip_fork_z = t_right_thigh_13 + s_right_thigh * h_right_thigh_x;
  const Scalar t_right_hip_block_2 = E_right_hip_fork_xx - t_right_hip_block_1;
  const Scalar t_right_hip_block_3 = t_right_hip_block_2 - 2.0 * h_right_hip_fork_z;
  // right_foot
  const Scalar t_right_foot_60 = 0.001559822240256 * c_right_ankle_pitch;
  const Scalar t_right_foot_61 = t_right_foot_60 - 0.02565802580712 * s_right_ankle_pitch;
  w.t_right_foot_61 = t_right_foot_61;
  const Scalar t_right_foot_62 = 6.298136129784905e-05 * c_right_foot_2;
  const Scalar E_right_foot_yz = t_right_foot_62 + 0.0014494177603079786 * s_right_foot_2;
  w.E_right_foot_yz = E_right_foot_yz;
  const Scalar E_righ_ankl_cros_yz = 0.001106309568 + E_right_foot_yz;
  const Scalar h_right_foot_y = 0.00014128635491404698 * s_right_foot_2;
  w.h_right_foot_y = h_right_foot_y;
  const Scalar t_righ_ankl_cros_4 = s_righ_ankl_cros_y * h_right_foot_y;
  const Scalar t_right_shank_6 = t_right_foot_61 - E_righ_ankl_cros_yz;
  const Scalar E_right_shank_yz = t_righ_ankl_cros_4 - t_right_shank_6;
  const Scalar t_right_foot_63 = 0.00442555309711872 * c_right_shank;
  const Scalar t_right_foot_64 = t_right_foot_63 - 0.09232168197063167 * s_right_shank;
  w.t_right_foot_64 = t_right_foot_64;
  const Scalar t_right_shank_7 = s_right_shank_y * h_right_foot_y;
  const Scalar E_right_thigh_yz = t_right_shank_7 - (t_right_foot_64 - E_right_shank_yz);
  const Scalar t_right_foot_65 = 0.001559822240256 * s_right_ankle_pitch;
  const Scalar t_right_foot_66 = t_right_foot_65 + 0.02565802580712 * c_right_ankle_pitch;
  w.t_right_foot_66 = t_right_foot_66;
  const Scalar E_right_foot_xy = 3.616689632669773e-05 - c_right_foot_2 * t_right_foot_38;
  w.E_right_foot_xy = E_right_foot_xy;
  const Scalar t_righ_ankl_cros_5 = E_right_foot_xy - (0.0001962912 + h_right_foot_y);
  const Scalar E_righ_ankl_cros_xz = t_right_foot_40 - t_righ_ankl_cros_5;
  const Scalar t_right_shank_8 = t_right_foot_66 + E_righ_ankl_cros_xz;
  const Scalar E_right_shank_xz = t_right_shank_8 + s_righ_ankl_cros_x * h_right_foot_y;
  const Scalar t_right_foot_67 = 0.00442555309711872 * s_right_shank;
  const Scalar t_right_foot_68 = t_right_foot_67 + 0.09232168197063167 * c_right_shank;
  w.t_right_foot_68 = t_right_foot_68;
  // right_thigh
  const Scalar t_right_thigh_14 = t_right_foot_68 + E_right_shank_xz;
  const Scalar E_right_thigh_xz = t_right_thigh_14 + s_right_shank_x * h_right_foot_y;
  const Scalar t_right_thigh_15 = s_right_thigh * E_right_thigh_yz;
  const Scalar t_right_thigh_16 = t_right_thigh_15 + c_right_thigh * E_right_thigh_xz;
  // right_hip_fork
  const Scalar E_right_hip_fork_xy = 8.079624e-05 + t_right_thigh_16;
  const Scalar s_right_hip_roll = sin(q[7]);
  w.s_right_hip_roll = s_right_hip_roll;
  const Scalar c_right_hip_roll = cos(q[7]);
  w.c_right_hip_roll = c_right_hip_roll;
  const Scalar t_right_hip_fork_1 = t_right_foot_39 + 0.030379399648709733;
  const Scalar t_right_foot_69 = 0.0005651454196561879 * s_right_foot_2;
  const Scalar E_right_hip_fork_yy = t_right_hip_fork_1 + t_right_foot_69;
  const Scalar t_right_hip_fork_2 = E_right_hip_fork_xx - E_right_hip_fork_yy;
  const Scalar t_right_hip_fork_3 = s_right_hip_roll * E_right_hip_fork_xy * 2.0;
  const Scalar t_right_hip_fork_4 = c_right_hip_roll * t_right_hip_fork_2;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_3 + t_right_hip_fork_4;
  const Scalar t_right_hip_fork_6 = c_right_hip_roll * t_right_hip_fork_5;
  const Scalar t_right_hip_block_4 = t_right_hip_block_3 - t_right_hip_fork_6;
  const Scalar E_right_foot_yy = 0.0004240752683823717 + t_right_foot_39;
  w.E_right_foot_yy = E_right_foot_yy;
  const Scalar t_right_foot_70 = E_right_foot_xx + E_right_foot_yy;
  // right_shank
  const Scalar t_right_shank_9 = 1.0 + s_right_shank_x + s_righ_ankl_cros_x;
  const Scalar t_right_shank_10 = t_right_foot_70 + 0.00028257270982809396 * s_right_foot_2;
  const Scalar t_right_shank_11 = t_right_shank_10 + h_right_foot_x * t_right_shank_9;
  const Scalar t_right_shank_12 = h_right_foot_x * (s_right_shank_y + s_righ_ankl_cros_y);
  const Scalar t_right_shank_13 = E_right_foot_xz - t_right_shank_12;
  const Scalar t_right_thigh_17 = h_right_foot_x - s_right_thigh * t_right_shank_11;
  const Scalar t_right_thigh_18 = t_right_thigh_17 - c_right_thigh * t_right_shank_13;
  const Scalar t_righ_ankl_cros_6 = E_right_foot_yz + t_righ_ankl_cros_4;
  const Scalar t_right_shank_14 = t_righ_ankl_cros_6 + t_right_shank_7;
  const Scalar t_right_thigh_19 = t_right_shank_14 + c_right_thigh * h_right_foot_y;
  // right_hip_fork
  const Scalar t_right_hip_fork_7 = s_right_hip_roll * t_right_thigh_19;
  const Scalar t_right_hip_fork_8 = c_right_hip_roll * t_right_thigh_18;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_7 + t_right_hip_fork_8;
  // right_foot
  const Scalar t_right_foot_71 = 1.0 / t_right_foot_70;
  w.t_right_foot_71 = t_right_foot_71;
  const Scalar t_right_foot_72 = t_right_hip_fork_9 * t_right_foot_71;
  w.t_right_foot_72 = t_right_foot_72;
  const Scalar t_right_foot_73 = t_right_hip_fork_9 * t_right_foot_72;
  const Scalar t_right_foot_74 = t_right_hip_block_4 - t_right_foot_73;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_7 = 0.0070975881429152 + t_righ_ankl_cros_1;
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_7 + t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_9 = 0.0238512154272 * s_right_ankle_pitch;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_8 + t_righ_ankl_cros_9;
  const Scalar t_right_shank_15 = t_righ_ankl_cros_10 + 0.0237961317888 * s_right_shank;
  const Scalar t_right_shank_16 = t_right_shank_15 + s_right_shank_x * h_righ_ankl_cros_x;
  // right_thigh
  const Scalar t_right_thigh_20 = t_right_shank_16 - s_right_thigh * h_righ_ankl_cros_x;
  const Scalar t_right_thigh_21 = t_right_thigh_20 + 0.000550836384 * c_right_thigh;
  const Scalar t_right_thigh_22 = s_right_thigh * E_righ_ankl_cros_yz;
  const Scalar t_right_thigh_23 = t_right_thigh_22 + c_right_thigh * E_righ_ankl_cros_xz;
  const Scalar t_right_hip_fork_10 = s_right_hip_roll * t_right_thigh_21;
  const Scalar t_right_hip_fork_11 = c_right_hip_roll * t_right_thigh_23;
  const Scalar t_right_foot_75 = E_right_foot_yz * t_right_foot_71;
  w.t_right_foot_75 = t_right_foot_75;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_10 - t_right_hip_fork_11;
  // right_foot
  const Scalar t_right_foot_76 = t_right_hip_fork_9 * t_right_foot_75;
  const Scalar t_right_foot_77 = t_right_hip_fork_12 - t_right_foot_76;
  const Scalar t_right_foot_78 = E_right_foot_yz * t_right_foot_75;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_11 = 1.0 / (t_righ_ankl_cros_7 - t_right_foot_78);
  w.t_righ_ankl_cros_11 = t_righ_ankl_cros_11;
  const Scalar t_righ_ankl_cros_12 = t_right_foot_77 * t_righ_ankl_cros_11;
  w.t_righ_ankl_cros_12 = t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_13 = t_right_foot_77 * t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_14 = t_right_foot_74 - t_righ_ankl_cros_13;
  const Scalar t_right_foot_79 = t_righ_ankl_cros_6 * t_right_foot_71;
  w.t_right_foot_79 = t_right_foot_79;
  const Scalar t_right_thigh_24 = s_right_thigh * E_right_shank_yz;
  const Scalar t_right_thigh_25 = t_right_thigh_24 + c_right_thigh * E_right_shank_xz;
  // right_shank
  const Scalar t_right_shank_17 = E_right_shank_xx - E_right_shank_yy;
  const Scalar t_right_shank_18 = t_right_shank_17 + t_right_shank_3;
  const Scalar t_right_shank_19 = t_right_shank_5 + t_right_shank_18;
  const Scalar t_right_thigh_26 = t_right_shank_19 - s_right_thigh * h_right_shank_x;
  const Scalar t_right_thigh_27 = t_right_thigh_26 + c_right_thigh * h_right_shank_y;
  // right_hip_fork
  const Scalar t_right_hip_fork_13 = s_right_hip_roll * t_right_thigh_27;
  const Scalar t_right_hip_fork_14 = c_right_hip_roll * t_right_thigh_25;
  const Scalar t_right_hip_fork_15 = t_right_hip_fork_13 - t_right_hip_fork_14;
  // right_foot
  const Scalar t_right_foot_80 = t_right_hip_fork_9 * t_right_foot_79;
  const Scalar t_right_foot_81 = t_righ_ankl_cros_6 * t_right_foot_75;
  const Scalar t_right_foot_82 = t_righ_ankl_cros_10 - t_right_foot_81;
  const Scalar t_righ_ankl_cros_15 = t_right_foot_82 * t_righ_ankl_cros_11;
  w.t_righ_ankl_cros_15 = t_righ_ankl_cros_15;
  const Scalar t_right_foot_83 = t_right_hip_fork_15 - t_right_foot_80;
  const Scalar t_righ_ankl_cros_16 = t_right_foot_77 * t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_17 = t_right_foot_83 - t_righ_ankl_cros_16;
  const Scalar t_right_foot_84 = t_righ_ankl_cros_6 * t_right_foot_79;
  const Scalar t_righ_ankl_cros_18 = t_right_foot_82 * t_righ_ankl_cros_15;
  const Scalar t_right_foot_85 = t_right_shank_17 - t_right_foot_84;
  // right_shank
  const Scalar t_right_shank_20 = 1.0 / (t_right_foot_85 - t_righ_ankl_cros_18);
  w.t_right_shank_20 = t_right_shank_20;
  const Scalar t_right_shank_21 = t_righ_ankl_cros_17 * t_right_shank_20;
  w.t_right_shank_21 = t_right_shank_21;
  const Scalar t_right_shank_22 = t_righ_ankl_cros_17 * t_right_shank_21;
  const Scalar t_right_shank_23 = t_righ_ankl_cros_14 - t_right_shank_22;
  // right_foot
  const Scalar t_right_foot_86 = t_right_shank_14 * t_right_foot_75;
  const Scalar t_right_foot_87 = t_right_shank_16 - t_right_foot_86;
  const Scalar t_right_foot_88 = t_right_shank_14 * t_right_foot_79;
  const Scalar t_righ_ankl_cros_19 = t_right_foot_87 * t_righ_ankl_cros_15;
  const Scalar t_right_foot_89 = t_right_shank_19 - t_right_foot_88;
  const Scalar t_righ_ankl_cros_20 = t_right_foot_89 - t_righ_ankl_cros_19;
  const Scalar t_right_shank_24 = t_righ_ankl_cros_20 * t_right_shank_20;
  w.t_right_shank_24 = t_right_shank_24;
  const Scalar t_right_thigh_28 = E_right_thigh_xx + E_right_thigh_yy;
  const Scalar t_right_thigh_29 = t_right_thigh_28 - h_right_hip_fork_z;
  const Scalar t_right_hip_fork_16 = s_right_hip_roll * t_right_thigh_29;
  const Scalar t_right_hip_fork_17 = c_right_hip_roll * t_right_thigh_16;
  const Scalar t_right_foot_90 = t_right_shank_14 * t_right_foot_71;
  w.t_right_foot_90 = t_right_foot_90;
  const Scalar t_right_hip_fork_18 = t_right_hip_fork_16 - t_right_hip_fork_17;
  const Scalar t_right_foot_91 = t_right_hip_fork_9 * t_right_foot_90;
  const Scalar t_righ_ankl_cros_21 = t_right_foot_87 * t_righ_ankl_cros_11;
  w.t_righ_ankl_cros_21 = t_righ_ankl_cros_21;
  const Scalar t_right_foot_92 = t_right_hip_fork_18 - t_right_foot_91;
  const Scalar t_righ_ankl_cros_22 = t_right_foot_77 * t_righ_ankl_cros_21;
  const Scalar t_right_shank_25 = t_righ_ankl_cros_17 * t_right_shank_24;
  const Scalar t_righ_ankl_cros_23 = t_right_foot_92 - t_righ_ankl_cros_22;
  const Scalar t_right_shank_26 = t_righ_ankl_cros_23 - t_right_shank_25;
  const Scalar t_right_foot_93 = t_right_shank_14 * t_right_foot_90;
  const Scalar t_righ_ankl_cros_24 = t_right_foot_87 * t_righ_ankl_cros_21;
  const Scalar t_right_foot_94 = t_right_thigh_28 - t_right_foot_93;
  const Scalar t_right_shank_27 = t_righ_ankl_cros_20 * t_right_shank_24;
  const Scalar t_righ_ankl_cros_25 = t_right_foot_94 - t_righ_ankl_cros_24;
  // right_thigh
  const Scalar t_right_thigh_30 = 1.0 / (t_righ_ankl_cros_25 - t_right_shank_27);
  w.t_right_thigh_30 = t_right_thigh_30;
  const Scalar t_right_thigh_31 = t_right_shank_26 * t_right_thigh_30;
  w.t_right_thigh_31 = t_right_thigh_31;
  const Scalar t_right_thigh_32 = t_right_shank_26 * t_right_thigh_31;
  const Scalar t_right_thigh_33 = t_right_shank_23 - t_right_thigh_32;
  w.t_right_thigh_33 = t_right_thigh_33;
  const Scalar t_right_thigh_34 = c_right_thigh * t_right_shank_11;
  const Scalar t_right_thigh_35 = t_right_thigh_34 - s_right_thigh * t_right_shank_13;
  const Scalar t_right_thigh_36 = c_right_thigh * E_right_shank_yz;
  const Scalar t_right_thigh_37 = t_right_thigh_36 - s_right_thigh * E_right_shank_xz;
  const Scalar t_right_foot_95 = t_right_thigh_35 * t_right_foot_79;
  const Scalar t_right_thigh_38 = c_right_thigh * E_righ_ankl_cros_yz;
  const Scalar t_right_thigh_39 = t_right_thigh_38 - s_right_thigh * E_righ_ankl_cros_xz;
  const Scalar t_right_foot_96 = t_right_thigh_35 * t_right_foot_75;
  const Scalar t_right_foot_97 = t_right_thigh_39 - t_right_foot_96;
  const Scalar t_righ_ankl_cros_26 = t_right_foot_97 * t_righ_ankl_cros_15;
  const Scalar t_right_foot_98 = t_right_thigh_37 - t_right_foot_95;
  const Scalar t_righ_ankl_cros_27 = t_right_foot_98 - t_righ_ankl_cros_26;
  const Scalar t_right_thigh_40 = c_right_thigh * E_right_thigh_yz;
  const Scalar t_right_thigh_41 = t_right_thigh_40 - s_right_thigh * E_right_thigh_xz;
  const Scalar t_right_foot_99 = t_right_thigh_35 * t_right_foot_90;
  const Scalar t_righ_ankl_cros_28 = t_right_foot_97 * t_righ_ankl_cros_21;
  const Scalar t_right_foot_100 = t_right_thigh_41 - t_right_foot_99;
  const Scalar t_right_shank_28 = t_righ_ankl_cros_27 * t_right_shank_24;
  const Scalar t_righ_ankl_cros_29 = t_right_foot_100 - t_righ_ankl_cros_28;
  const Scalar t_right_shank_29 = t_righ_ankl_cros_29 - t_right_shank_28;
  const Scalar t_right_thigh_42 = t_right_shank_29 * t_right_thigh_30;
  w.t_right_thigh_42 = t_right_thigh_42;
  const Scalar t_right_shank_30 = t_righ_ankl_cros_27 * t_right_shank_20;
  w.t_right_shank_30 = t_right_shank_30;
  const Scalar t_right_thigh_43 = s_right_thigh * h_right_thigh_y;
  // right_hip_fork
  const Scalar t_right_hip_fork_19 = c_right_thigh * (h_right_thigh_x + t_right_thigh_11);
  const Scalar t_right_hip_fork_20 = 0.00011406528 - E_right_thigh_xy - t_right_thigh_43;
  const Scalar E_right_hip_fork_xz = t_right_hip_fork_20 + t_right_hip_fork_19;
  const Scalar E_right_hip_fork_yz = 0.0042631913856 + h_right_foot_y + t_right_thigh_41;
  const Scalar t_right_hip_fork_21 = s_right_hip_roll * E_right_hip_fork_yz;
  const Scalar t_right_hip_fork_22 = c_right_hip_roll * E_right_hip_fork_xz;
  const Scalar t_right_foot_101 = t_right_thigh_35 * t_right_foot_71;
  w.t_right_foot_101 = t_right_foot_101;
  const Scalar t_right_hip_fork_23 = t_right_hip_fork_21 + t_right_hip_fork_22;
  const Scalar t_right_foot_102 = t_right_hip_fork_9 * t_right_foot_101;
  const Scalar t_righ_ankl_cros_30 = t_right_foot_97 * t_righ_ankl_cros_11;
  w.t_righ_ankl_cros_30 = t_righ_ankl_cros_30;
  const Scalar t_right_foot_103 = t_right_hip_fork_23 - t_right_foot_102;
  const Scalar t_righ_ankl_cros_31 = t_right_foot_77 * t_righ_ankl_cros_30;
  const Scalar t_right_shank_31 = t_righ_ankl_cros_17 * t_right_shank_30;
  const Scalar t_righ_ankl_cros_32 = t_right_foot_103 - t_righ_ankl_cros_31;
  const Scalar t_right_shank_32 = t_righ_ankl_cros_32 - t_right_shank_31;
  const Scalar t_right_thigh_44 = t_right_shank_26 * t_right_thigh_42;
  const Scalar t_right_thigh_45 = t_right_shank_32 - t_right_thigh_44;
  w.t_right_thigh_45 = t_right_thigh_45;
  const Scalar t_right_hip_fork_24 = E_right_hip_fork_xx + E_right_hip_fork_yy;
  const Scalar t_right_foot_104 = t_right_thigh_35 * t_right_foot_101;
  const Scalar t_right_foot_105 = t_right_hip_fork_24 - t_right_foot_104;
  const Scalar t_righ_ankl_cros_33 = t_right_foot_97 * t_righ_ankl_cros_30;
  const Scalar t_right_shank_33 = t_righ_ankl_cros_27 * t_right_shank_30;
  const Scalar t_righ_ankl_cros_34 = t_right_foot_105 - t_righ_ankl_cros_33;
  const Scalar t_right_shank_34 = t_righ_ankl_cros_34 - t_right_shank_33;
  const Scalar t_right_thigh_46 = t_right_shank_29 * t_right_thigh_42;
  const Scalar t_right_hip_fork_25 = 1.0 / (t_right_shank_34 - t_right_thigh_46);
  w.t_right_hip_fork_25 = t_right_hip_fork_25;
}

[[gnu::noinline]] void forward_dynamics_4(const Scalar qd[12], const Scalar tau[12], Scalar qdd[12],
                                          ForwardDynamicsWorkspace& w) noexcept {
  const Scalar t_right_hip_fork_26 = w.t_right_thigh_45 * w.t_right_hip_fork_25;
  const Scalar t_right_hip_fork_27 = w.t_right_thigh_45 * t_right_hip_fork_26;
  const Scalar t_right_hip_block_5 = 1.0 / (w.t_right_thigh_33 - t_right_hip_fork_27);
  const Scalar omega_right_hip_fork_x = w.c_right_hip_roll * qd[6];
  // right_thigh
  const Scalar t_right_thigh_47 = w.c_right_thigh * omega_right_hip_fork_x;
  const Scalar omega_right_thigh_x = w.s_right_thigh * qd[7] + t_right_thigh_47;
  const Scalar t_right_thigh_48 = w.s_right_thigh * omega_right_hip_fork_x;
  const Scalar omega_right_thigh_y = w.c_right_thigh * qd[7] - t_right_thigh_48;
  const Scalar t_right_thigh_49 = omega_right_thigh_x * omega_right_thigh_y;
  const Scalar alpha_right_hip_fork_y = omega_right_hip_fork_x * qd[7];
  const Scalar Omega_right_thigh_xy = alpha_right_hip_fork_y - t_right_thigh_49;
  const Scalar t_right_thigh_50 = 2.0 * omega_right_thigh_x;
  // right_foot
  const Scalar omega_right_foot_z = omega_right_thigh_y + qd[11];
  const Scalar t_right_foot_106 = t_right_thigh_50 * omega_right_foot_z;
  const Scalar Omega_right_foot_zx = Omega_right_thigh_xy + t_right_foot_106;
  // right_hip_fork
  const Scalar omega_right_hip_fork_y = w.s_right_hip_roll * qd[6];
  const Scalar alpha_right_hip_fork_x = omega_right_hip_fork_y * qd[7];
  const Scalar Omega_right_hip_fork_zy = 2.0 * alpha_right_hip_fork_x;
  const Scalar Omega_right_hip_fork_xy = omega_right_hip_fork_x * omega_right_hip_fork_y;
  // right_thigh
  const Scalar t_right_thigh_51 = w.c_right_thigh * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_52 = w.s_right_thigh * Omega_right_hip_fork_xy;
  const Scalar Omega_right_thigh_yz = t_right_thigh_51 - t_right_thigh_52;
  const Scalar t_right_thigh_53 = 2.0 * omega_right_thigh_y;
  const Scalar omega_right_thigh_z = omega_right_hip_fork_y + qd[8];
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  // right_ankle_cross
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_35 = t_right_thigh_53 * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_zy = Omega_right_thigh_yz - t_righ_ankl_cros_35;
  // right_foot
  const Scalar t_right_foot_107 = omega_righ_ankl_cros_z * omega_right_foot_z * 2.0;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy + t_right_foot_107;
  const Scalar t_right_foot_108 = w.h_right_foot_y * Omega_right_foot_zy;
  const Scalar F_right_foot_z = t_right_foot_108 + w.h_right_foot_x * Omega_right_foot_zx;
  const Scalar Omega_right_thigh_yx = alpha_right_hip_fork_y + t_right_thigh_49;
  const Scalar t_righ_ankl_cros_36 = F_right_foot_z + 0.0001186892 * Omega_right_thigh_yx;
  const Scalar t_righ_ankl_cros_37 = 0.0001962912 * Omega_right_thigh_yz;
  // right_thigh
  const Scalar t_right_thigh_54 = w.s_right_thigh * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_55 = w.c_right_thigh * Omega_right_hip_fork_xy;
  const Scalar Omega_right_thigh_xz = t_right_thigh_54 + t_right_thigh_55;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_38 = t_righ_ankl_cros_36 + t_righ_ankl_cros_37;
  const Scalar t_righ_ankl_cros_39 = 0.001106309568 * Omega_right_thigh_xz;
  const Scalar t_righ_ankl_cros_40 = t_righ_ankl_cros_38 + t_righ_ankl_cros_39;
  const Scalar t_righ_ankl_cros_41 = 0.0069788989429152 * Omega_right_thigh_xy;
  const Scalar t_right_thigh_56 = omega_right_thigh_x * omega_right_thigh_x;
  // right_hip_fork
  const Scalar t_right_hip_fork_28 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_29 = qd[7] * qd[7];
  const Scalar Omega_right_hip_fork_yy = t_right_hip_fork_29 + t_right_hip_fork_28;
  const Scalar t_right_thigh_57 = Omega_right_hip_fork_yy - t_right_thigh_56;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_42 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_xx = t_right_thigh_57 + t_righ_ankl_cros_42;
  const Scalar Omega_righ_ankl_cros_yy = t_right_thigh_56 + t_righ_ankl_cros_42;
  const Scalar t_right_shank_35 = Omega_righ_ankl_cros_xx - Omega_righ_ankl_cros_yy;
  const Scalar t_righ_ankl_cros_43 = t_righ_ankl_cros_40 + t_righ_ankl_cros_41;
  const Scalar t_righ_ankl_cros_44 = 0.000549677184 * t_right_shank_35;
  const Scalar Omega_right_hip_block_xx = qd[6] * qd[6];
  const Scalar a_right_hip_fork_x = 981.0 * w.c_right_hip_roll;
  // right_thigh
  const Scalar t_right_thigh_58 = w.s_right_thigh * Omega_right_hip_block_xx;
  const Scalar a_right_thigh_x = t_right_thigh_58 - w.c_right_thigh * a_right_hip_fork_x;
  const Scalar t_right_thigh_59 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_60 = t_right_thigh_59 - t_right_thigh_56;
  const Scalar Omega_right_thigh_xx = Omega_right_hip_fork_yy + t_right_thigh_60;
  const Scalar t_right_shank_36 = a_right_thigh_x + w.s_right_shank_y * Omega_right_thigh_xy;
  const Scalar a_right_shank_x = t_right_shank_36 - w.s_right_shank_x * Omega_right_thigh_xx;
  const Scalar t_righ_ankl_cros_45 = w.s_righ_ankl_cros_y * Omega_right_thigh_xy;
  const Scalar t_right_shank_37 = omega_right_shank_z * omega_right_shank_z;
  const Scalar Omega_right_shank_xx = t_right_thigh_57 + t_right_shank_37;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_46 = w.s_righ_ankl_cros_x * Omega_right_shank_xx;
  const Scalar t_righ_ankl_cros_47 = a_right_shank_x + t_righ_ankl_cros_45;
  const Scalar a_righ_ankl_cros_x = t_righ_ankl_cros_47 - t_righ_ankl_cros_46;
  const Scalar t_righ_ankl_cros_48 = t_righ_ankl_cros_43 - t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_49 = 0.000550836384 * a_righ_ankl_cros_x;
  // right_thigh
  const Scalar t_right_thigh_61 = w.c_right_thigh * Omega_right_hip_block_xx;
  const Scalar a_right_thigh_y = t_right_thigh_61 + w.s_right_thigh * a_right_hip_fork_x;
  const Scalar Omega_right_thigh_yy = t_right_thigh_59 + t_right_thigh_56;
  // right_shank
  const Scalar t_right_shank_38 = a_right_thigh_y + w.s_right_shank_y * Omega_right_thigh_yy;
  const Scalar a_right_shank_y = t_right_shank_38 + w.s_right_shank_x * Omega_right_thigh_yx;
  const Scalar Omega_right_shank_yy = t_right_thigh_56 + t_right_shank_37;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_50 = w.s_righ_ankl_cros_y * Omega_right_shank_yy;
  const Scalar t_righ_ankl_cros_51 = w.s_righ_ankl_cros_x * Omega_right_thigh_yx;
  const Scalar t_righ_ankl_cros_52 = a_right_shank_y + t_righ_ankl_cros_50;
  const Scalar a_righ_ankl_cros_y = t_righ_ankl_cros_52 + t_righ_ankl_cros_51;
  const Scalar t_righ_ankl_cros_53 = t_righ_ankl_cros_48 + t_righ_ankl_cros_49;
  const Scalar t_righ_ankl_cros_54 = omega_right_thigh_x * omega_righ_ankl_cros_z;
  const Scalar alpha_righ_ankl_cros_y = Omega_right_thigh_xz - t_righ_ankl_cros_54;
  const Scalar Omega_right_thigh_xz_2 = t_righ_ankl_cros_54 + alpha_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_55 = t_righ_ankl_cros_53 + 9.4668e-05 * a_righ_ankl_cros_y;
  const Scalar t_right_foot_109 = w.E_right_foot_yz * Omega_right_thigh_xz_2;
  const Scalar t_righ_ankl_cros_56 = t_righ_ankl_cros_55 + t_right_foot_109;
  const Scalar t_right_foot_110 = w.E_right_foot_xy * Omega_right_foot_zy;
  const Scalar t_righ_ankl_cros_57 = t_righ_ankl_cros_56 - t_right_foot_110;
  // right_foot
  const Scalar t_right_foot_111 = w.E_right_foot_xx * Omega_right_foot_zx;
  const Scalar t_right_foot_112 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_113 = t_right_thigh_56 - t_right_foot_112;
  const Scalar t_righ_ankl_cros_58 = t_righ_ankl_cros_57 + t_right_foot_111;
  const Scalar t_right_foot_114 = w.E_right_foot_xz * t_right_foot_113;
  const Scalar t_right_foot_115 = Omega_right_thigh_yx + a_righ_ankl_cros_y;
  const Scalar a_right_foot_z = t_right_foot_115 + 2.0 * Omega_right_thigh_yz;
  const Scalar t_righ_ankl_cros_59 = t_righ_ankl_cros_58 - t_right_foot_114;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_59 + w.h_right_foot_x * a_right_foot_z;
  const Scalar t_right_foot_116 = 0.356070859284 + w.t_right_foot_43;
  // right_shank
  const Scalar t_right_shank_39 = t_right_foot_116 * Omega_right_thigh_yx;
  const Scalar t_right_shank_40 = w.t_right_foot_66 * Omega_right_thigh_yz;
  const Scalar t_right_shank_41 = M_righ_ankl_cros_z + t_right_shank_39;
  const Scalar t_right_shank_42 = w.t_right_foot_61 * Omega_right_thigh_xz;
  const Scalar t_right_shank_43 = t_right_shank_41 + t_right_shank_40;
  const Scalar t_right_foot_117 = 0.005291437550784 - w.t_right_foot_43;
  const Scalar t_right_shank_44 = t_right_foot_117 * Omega_right_thigh_xy;
  const Scalar t_right_shank_45 = t_right_shank_43 - t_right_shank_42;
  const Scalar t_right_shank_46 = Omega_right_shank_xx - Omega_right_shank_yy;
  const Scalar t_right_shank_47 = t_right_shank_45 + t_right_shank_44;
  const Scalar t_right_shank_48 = w.t_right_foot_54 * t_right_shank_46;
  const Scalar t_right_shank_49 = t_right_shank_47 - t_right_shank_48;
  const Scalar t_right_shank_50 = t_right_shank_49 - w.t_right_foot_52 * a_right_shank_x;
  // right_foot
  const Scalar Omega_right_foot_xx = Omega_righ_ankl_cros_yy - t_right_foot_113;
  const Scalar t_right_foot_118 = w.h_right_foot_y * Omega_right_thigh_xz_2;
  const Scalar F_right_foot_x = t_right_foot_118 - w.h_right_foot_x * Omega_right_foot_xx;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_60 = F_right_foot_x + 0.000550836384 * Omega_right_thigh_xy;
  const Scalar t_righ_ankl_cros_61 = 9.4668e-05 * Omega_righ_ankl_cros_xx;
  const Scalar F_righ_ankl_cros_x = t_righ_ankl_cros_60 - t_righ_ankl_cros_61;
  const Scalar t_right_shank_51 = t_right_shank_50 + w.t_right_foot_49 * a_right_shank_y;
  const Scalar t_righ_ankl_cros_62 = w.s_righ_ankl_cros_y * F_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_63 = 0.000550836384 * Omega_righ_ankl_cros_yy;
  const Scalar t_righ_ankl_cros_64 = F_right_foot_z + t_righ_ankl_cros_63;
  const Scalar F_righ_ankl_cros_y = t_righ_ankl_cros_64 + 9.4668e-05 * Omega_right_thigh_yx;
  const Scalar t_right_shank_52 = t_right_shank_51 + t_righ_ankl_cros_62;
  const Scalar M_right_shank_z = t_right_shank_52 + w.s_righ_ankl_cros_x * F_righ_ankl_cros_y;
  // right_thigh
  const Scalar t_right_thigh_62 = w.t_right_foot_47 * Omega_right_thigh_yx;
  const Scalar t_right_thigh_63 = w.t_right_foot_68 * Omega_right_thigh_yz;
  const Scalar t_right_thigh_64 = M_right_shank_z + t_right_thigh_62 + t_right_thigh_63;
  const Scalar t_right_thigh_65 = w.t_right_foot_64 * Omega_right_thigh_xz;
  const Scalar t_right_thigh_66 = w.t_right_foot_50 * Omega_right_thigh_xy;
  const Scalar t_right_thigh_67 = t_right_thigh_64 - t_right_thigh_65;
  const Scalar t_right_shank_53 = Omega_right_thigh_xx - Omega_right_thigh_yy;
  const Scalar t_right_thigh_68 = t_right_thigh_67 + t_right_thigh_66;
  const Scalar t_right_thigh_69 = w.t_right_foot_53 * t_right_shank_53;
  const Scalar t_right_thigh_70 = t_right_thigh_68 - t_right_thigh_69;
  const Scalar t_right_thigh_71 = t_right_thigh_70 - w.t_right_foot_57 * a_right_thigh_x;
  // right_shank
  const Scalar t_right_shank_54 = w.t_right_foot_52 * Omega_right_thigh_xy;
  const Scalar t_right_shank_55 = w.t_right_foot_49 * Omega_right_shank_xx;
  const Scalar F_right_shank_x = F_righ_ankl_cros_x - t_right_shank_54 - t_right_shank_55;
  const Scalar t_right_thigh_72 = t_right_thigh_71 + w.t_right_foot_59 * a_right_thigh_y;
  const Scalar t_right_shank_56 = w.t_right_foot_52 * Omega_right_shank_yy;
  const Scalar t_right_shank_57 = w.t_right_foot_49 * Omega_right_thigh_yx;
  const Scalar F_right_shank_y = F_righ_ankl_cros_y - t_right_shank_56 + t_right_shank_57;
  const Scalar t_right_thigh_73 = t_right_thigh_72 + w.s_right_shank_y * F_right_shank_x;
  const Scalar M_right_thigh_z = t_right_thigh_73 + w.s_right_shank_x * F_right_shank_y;
  const Scalar t_left_hip_block_80 = M_right_thigh_z - tau[8];
  const Scalar Omega_right_foot_yy = t_right_thigh_56 + t_right_foot_112;
  const Scalar t_right_foot_119 = Omega_right_foot_xx - Omega_right_foot_yy;
  const Scalar Omega_righ_ankl_cros_zx = t_righ_ankl_cros_54 - alpha_righ_ankl_cros_y;
  // right_foot
  const Scalar t_right_foot_120 = w.E_right_foot_xx * Omega_righ_ankl_cros_zx;
  const Scalar t_right_foot_121 = w.E_right_foot_xz * Omega_righ_ankl_cros_zy;
  const Scalar t_right_foot_122 = w.E_right_foot_yz * Omega_right_thigh_xy;
  const Scalar t_right_foot_123 = t_right_foot_120 - t_right_foot_121 - t_right_foot_122;
  const Scalar t_right_foot_124 = w.E_right_foot_yy * Omega_right_thigh_xz_2;
  const Scalar t_right_foot_125 = t_right_foot_123 - t_right_foot_124;
  const Scalar t_right_foot_126 = a_righ_ankl_cros_x - Omega_righ_ankl_cros_xx;
  const Scalar a_right_foot_x = t_right_foot_126 + 2.0 * Omega_right_thigh_xz;
  const Scalar t_right_foot_127 = t_right_foot_125 - w.E_right_foot_xy * t_right_foot_119;
  const Scalar t_right_thigh_74 = omega_right_thigh_z * t_right_thigh_53;
  const Scalar Omega_right_thigh_zy = Omega_right_thigh_yz - t_right_thigh_74;
  const Scalar a_right_hip_fork_y = 981.0 * w.s_right_hip_roll;
  const Scalar t_right_shank_58 = w.s_right_shank_y * Omega_right_thigh_zy;
  const Scalar t_right_thigh_75 = omega_right_thigh_z * t_right_thigh_50;
  const Scalar Omega_right_thigh_zx = Omega_right_thigh_xz - t_right_thigh_75;
  // right_shank
  const Scalar t_right_shank_59 = a_right_hip_fork_y - t_right_shank_58;
  const Scalar a_right_shank_z = t_right_shank_59 + w.s_right_shank_x * Omega_right_thigh_zx;
  const Scalar t_right_shank_60 = t_right_thigh_53 * omega_right_shank_z;
  const Scalar Omega_right_shank_zy = Omega_right_thigh_yz - t_right_shank_60;
  const Scalar t_righ_ankl_cros_65 = w.s_righ_ankl_cros_y * Omega_right_shank_zy;
  const Scalar t_right_shank_61 = t_right_thigh_50 * omega_right_shank_z;
  const Scalar Omega_right_shank_zx = Omega_right_thigh_xz - t_right_shank_61;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_66 = w.s_righ_ankl_cros_x * Omega_right_shank_zx;
  const Scalar t_righ_ankl_cros_67 = a_right_shank_z - t_righ_ankl_cros_65;
  const Scalar a_righ_ankl_cros_z = t_righ_ankl_cros_67 + t_righ_ankl_cros_66;
  // right_foot
  const Scalar t_right_foot_128 = a_righ_ankl_cros_z - Omega_righ_ankl_cros_zx;
  const Scalar a_right_foot_y = t_right_foot_128 + 2.0 * Omega_right_hip_fork_yy;
  const Scalar t_right_foot_129 = t_right_foot_127 - w.h_right_foot_y * a_right_foot_x;
  const Scalar M_right_foot_z = t_right_foot_129 - w.h_right_foot_x * a_right_foot_y;
  // left_hip_block
  const Scalar t_left_hip_block_81 = M_right_foot_z + tau[11];
  const Scalar t_left_hip_block_82 = t_left_hip_block_81 * w.t_right_foot_90;
  const Scalar t_left_hip_block_83 = t_left_hip_block_81 * w.t_right_foot_75;
  const Scalar t_left_hip_block_84 = M_righ_ankl_cros_z - tau[10] + t_left_hip_block_83;
  const Scalar t_left_hip_block_85 = t_left_hip_block_80 + t_left_hip_block_82;
  const Scalar t_left_hip_block_86 = w.t_righ_ankl_cros_21 * t_left_hip_block_84;
  const Scalar t_left_hip_block_87 = t_left_hip_block_81 * w.t_right_foot_79;
  const Scalar t_left_hip_block_88 = M_right_shank_z - tau[9] + t_left_hip_block_87;
  const Scalar t_left_hip_block_89 = w.t_righ_ankl_cros_15 * t_left_hip_block_84;
  const Scalar t_left_hip_block_90 = t_left_hip_block_88 - t_left_hip_block_89;
  const Scalar t_left_hip_block_91 = t_left_hip_block_85 - t_left_hip_block_86;
  const Scalar t_left_hip_block_92 = w.t_right_shank_24 * t_left_hip_block_90;
  const Scalar t_left_hip_block_93 = t_left_hip_block_91 - t_left_hip_block_92;
  const Scalar t_left_hip_block_94 = w.t_right_thigh_42 * t_left_hip_block_93;
  const Scalar t_right_foot_130 = w.h_right_foot_x * Omega_righ_ankl_cros_zx;
  const Scalar F_right_foot_y = w.h_right_foot_y * Omega_right_foot_yy - t_right_foot_130;
  // right_thigh
  const Scalar t_right_thigh_76 = w.t_right_foot_53 * Omega_right_thigh_zy;
  const Scalar t_right_thigh_77 = F_right_foot_y - M_right_foot_z - t_right_thigh_76;
  const Scalar t_right_thigh_78 = w.t_right_foot_47 * Omega_right_thigh_zx;
  const Scalar t_right_thigh_79 = t_right_thigh_77 + t_right_thigh_78;
  const Scalar t_right_thigh_80 = w.t_right_foot_68 * t_right_thigh_60;
  const Scalar t_right_thigh_81 = t_right_thigh_79 - t_right_thigh_80;
  const Scalar t_right_thigh_82 = w.t_right_foot_59 * a_right_hip_fork_y;
  const Scalar t_right_shank_62 = w.t_right_foot_54 * Omega_right_shank_zy;
  const Scalar t_right_thigh_83 = t_right_thigh_81 + t_right_thigh_82;
  const Scalar t_right_shank_63 = t_right_foot_116 * Omega_right_shank_zx;
  const Scalar t_right_thigh_84 = t_right_thigh_83 - t_right_shank_62;
  const Scalar t_right_shank_64 = Omega_right_hip_fork_yy - Omega_right_shank_xx;
  const Scalar t_right_thigh_85 = t_right_thigh_84 + t_right_shank_63;
  const Scalar t_right_shank_65 = w.t_right_foot_66 * t_right_shank_64;
  const Scalar t_right_thigh_86 = t_right_thigh_85 + t_right_shank_65;
  const Scalar t_right_thigh_87 = t_right_thigh_86 + w.t_right_foot_49 * a_right_shank_z;
  const Scalar t_righ_ankl_cros_68 = 0.000549677184 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_thigh_88 = t_right_thigh_87 - t_righ_ankl_cros_68;
  const Scalar t_right_foot_131 = Omega_right_hip_fork_yy - Omega_righ_ankl_cros_xx;
  const Scalar t_right_thigh_89 = t_right_thigh_88 - 0.0001186892 * Omega_righ_ankl_cros_zx;
  const Scalar t_right_thigh_90 = t_right_thigh_89 + 0.0001962912 * t_right_foot_131;
  const Scalar t_right_thigh_91 = t_right_thigh_90 + 9.4668e-05 * a_righ_ankl_cros_z;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_69 = 0.000550836384 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_70 = F_right_foot_y - t_righ_ankl_cros_69;
  const Scalar t_righ_ankl_cros_71 = 9.4668e-05 * Omega_righ_ankl_cros_zx;
  const Scalar F_righ_ankl_cros_z = t_righ_ankl_cros_70 - t_righ_ankl_cros_71;
  const Scalar t_right_thigh_92 = t_right_thigh_91 + 2.0 * F_right_foot_x;
  const Scalar t_righ_ankl_cros_72 = w.s_righ_ankl_cros_x * F_righ_ankl_cros_z;
  // right_shank
  const Scalar t_right_shank_66 = w.t_right_foot_52 * Omega_right_shank_zy;
  const Scalar t_right_shank_67 = w.t_right_foot_49 * Omega_right_shank_zx;
  const Scalar F_right_shank_z = F_righ_ankl_cros_z + t_right_shank_66 + t_right_shank_67;
  // right_thigh
  const Scalar t_right_thigh_93 = t_right_thigh_92 + t_righ_ankl_cros_72;
  const Scalar t_right_thigh_94 = w.t_right_foot_61 - (0.001106309568 - w.t_right_foot_64);
  const Scalar t_right_thigh_95 = t_right_thigh_93 + w.s_right_shank_x * F_right_shank_z;
  const Scalar t_right_thigh_96 = Omega_right_thigh_xy * t_right_thigh_94;
  const Scalar M_right_thigh_y = t_right_thigh_95 - t_right_thigh_96;
  // right_hip_fork
  const Scalar t_right_hip_fork_30 = t_right_hip_fork_29 - t_right_hip_fork_28;
  const Scalar t_right_hip_fork_31 = Omega_right_hip_block_xx - Omega_right_hip_fork_yy;
  const Scalar t_right_hip_fork_32 = t_right_hip_fork_30 + t_right_hip_fork_31;
  const Scalar t_left_hip_block_95 = tau[7] + 8.079624e-05 * t_right_hip_fork_32;
  const Scalar t_right_hip_fork_33 = 3.9972481559136 * w.c_right_hip_roll;
  const Scalar t_left_hip_block_96 = t_left_hip_block_95 + t_right_hip_fork_33;
  const Scalar t_left_hip_block_97 = t_left_hip_block_96 - 0.0466241832 * w.s_right_hip_roll;
  const Scalar t_right_thigh_97 = w.c_right_thigh * M_right_thigh_y;
  const Scalar t_left_hip_block_98 = t_left_hip_block_97 - t_right_thigh_97;
  // right_thigh
  const Scalar t_right_thigh_98 = w.t_right_foot_50 * Omega_right_thigh_zy;
  const Scalar t_right_thigh_99 = w.t_right_foot_53 * Omega_right_thigh_zx;
  const Scalar t_right_thigh_100 = Omega_right_hip_fork_yy - Omega_right_thigh_yy;
  const Scalar t_right_thigh_101 = t_right_thigh_98 - t_right_thigh_99;
  const Scalar t_right_thigh_102 = w.t_right_foot_64 * t_right_thigh_100;
  const Scalar t_right_thigh_103 = t_right_thigh_101 + t_right_thigh_102;
  const Scalar t_right_thigh_104 = w.t_right_foot_57 * a_right_hip_fork_y;
  const Scalar t_right_shank_68 = t_right_foot_117 * Omega_right_shank_zy;
  const Scalar t_right_thigh_105 = t_right_thigh_103 + t_right_thigh_104;
  const Scalar t_right_shank_69 = w.t_right_foot_54 * Omega_right_shank_zx;
  const Scalar t_right_thigh_106 = t_right_thigh_105 + t_right_shank_68;
  const Scalar t_right_shank_70 = Omega_right_hip_fork_yy - Omega_right_shank_yy;
  const Scalar t_right_thigh_107 = t_right_thigh_106 - t_right_shank_69;
  const Scalar t_right_shank_71 = w.t_right_foot_61 * t_right_shank_70;
  const Scalar t_right_thigh_108 = t_right_thigh_107 + t_right_shank_71;
  const Scalar t_right_thigh_109 = t_right_thigh_108 + w.t_right_foot_52 * a_right_shank_z;
  const Scalar t_righ_ankl_cros_73 = 0.0069788989429152 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_74 = Omega_right_hip_fork_yy - Omega_righ_ankl_cros_yy;
  const Scalar t_right_thigh_110 = t_right_thigh_109 + t_righ_ankl_cros_73;
  const Scalar t_right_thigh_111 = t_right_thigh_110 - 0.001106309568 * t_righ_ankl_cros_74;
  const Scalar t_right_thigh_112 = t_right_thigh_111 - 0.000550836384 * a_righ_ankl_cros_z;
  const Scalar t_right_foot_132 = w.E_right_foot_yy * Omega_right_foot_zy;
  const Scalar t_right_thigh_113 = t_right_thigh_112 + t_right_foot_132;
  const Scalar t_right_foot_133 = w.E_right_foot_xy * Omega_right_foot_zx;
  const Scalar t_right_foot_134 = Omega_righ_ankl_cros_yy - Omega_right_foot_yy;
  const Scalar t_right_thigh_114 = t_right_thigh_113 - t_right_foot_133;
  const Scalar t_right_thigh_115 = t_right_thigh_114 + w.E_right_foot_yz * t_right_foot_134;
  const Scalar t_right_thigh_116 = t_right_thigh_115 + w.h_right_foot_y * a_right_foot_z;
  const Scalar t_right_thigh_117 = t_right_thigh_116 + 2.0 * F_right_foot_z;
  const Scalar t_righ_ankl_cros_75 = w.s_righ_ankl_cros_y * F_righ_ankl_cros_z;
  const Scalar t_right_thigh_118 = t_right_thigh_117 - t_righ_ankl_cros_75;
  const Scalar t_right_thigh_119 = 0.0001962912 + w.t_right_foot_68 + w.t_right_foot_66;
  const Scalar t_right_thigh_120 = t_right_thigh_118 - w.s_right_shank_y * F_right_shank_z;
  const Scalar t_right_thigh_121 = Omega_right_thigh_yx * t_right_thigh_119;
  const Scalar t_right_thigh_122 = w.E_righ_ankl_cros_xy * Omega_righ_ankl_cros_zx;
  const Scalar M_right_thigh_x = t_right_thigh_120 + t_right_thigh_121 + t_right_thigh_122;
  const Scalar t_right_thigh_123 = w.s_right_thigh * M_right_thigh_x;
  // left_hip_block
  const Scalar t_left_hip_block_99 = t_left_hip_block_98 + t_right_thigh_123;
  const Scalar t_left_hip_block_100 = t_left_hip_block_81 * w.t_right_foot_101;
  const Scalar t_left_hip_block_101 = t_left_hip_block_99 - t_left_hip_block_100;
  const Scalar t_left_hip_block_102 = w.t_righ_ankl_cros_30 * t_left_hip_block_84;
  const Scalar t_left_hip_block_103 = t_left_hip_block_101 + t_left_hip_block_102;
  const Scalar t_left_hip_block_104 = w.t_right_shank_30 * t_left_hip_block_90;
  const Scalar t_left_hip_block_105 = t_left_hip_block_103 + t_left_hip_block_104;
  const Scalar t_left_hip_block_106 = t_left_hip_block_105 + t_left_hip_block_94;
  const Scalar t_right_hip_fork_34 = 0.02968917206032736 * Omega_right_hip_fork_xy;
  const Scalar t_left_hip_block_107 = t_left_hip_block_106 - t_right_hip_fork_34;
  const Scalar t_left_hip_block_108 = t_right_hip_fork_26 * t_left_hip_block_107;
  const Scalar t_left_hip_block_109 = w.t_right_thigh_31 * t_left_hip_block_93;
  // right_hip_fork
  const Scalar t_right_hip_fork_35 = 0.05991064876065472 * alpha_right_hip_fork_x;
  const Scalar t_right_hip_fork_36 = F_right_shank_z - t_right_hip_fork_35;
  const Scalar t_right_hip_fork_37 = 0.00016159248 * alpha_right_hip_fork_y;
  const Scalar t_right_hip_fork_38 = t_right_hip_fork_36 - t_right_hip_fork_37;
  const Scalar t_right_hip_fork_39 = 0.00011406528 * Omega_right_hip_fork_xy;
  const Scalar t_right_hip_fork_40 = t_right_hip_fork_38 - t_right_hip_fork_39;
  const Scalar t_right_hip_fork_41 = 0.0042631913856 * t_right_hip_fork_31;
  const Scalar t_right_hip_fork_42 = t_right_hip_fork_40 - t_right_hip_fork_41;
  const Scalar t_right_thigh_124 = w.t_right_foot_57 * Omega_right_thigh_zy;
  const Scalar t_right_hip_fork_43 = t_right_hip_fork_42 + t_right_thigh_124;
  const Scalar t_right_thigh_125 = w.t_right_foot_59 * Omega_right_thigh_zx;
  const Scalar t_right_hip_fork_44 = t_right_hip_fork_43 + t_right_thigh_125;
  const Scalar t_right_thigh_126 = w.s_right_thigh * M_right_thigh_y;
  const Scalar t_right_hip_fork_45 = t_right_hip_fork_44 - t_right_thigh_126;
  const Scalar M_right_hip_fork_x = t_right_hip_fork_45 - w.c_right_thigh * M_right_thigh_x;
  const Scalar t_right_hip_fork_46 = 0.0042631913856 * Omega_right_hip_fork_xy;
  const Scalar t_right_hip_fork_47 = M_right_thigh_z + t_right_hip_fork_46;
  const Scalar t_right_hip_fork_48 = 0.00016159248 * alpha_right_hip_fork_x;
  const Scalar t_right_hip_fork_49 = t_right_hip_fork_47 + t_right_hip_fork_48;
  const Scalar t_right_hip_fork_50 = 0.00053230464 * alpha_right_hip_fork_y;
  const Scalar t_right_hip_fork_51 = t_right_hip_fork_49 + t_right_hip_fork_50;
  const Scalar t_right_hip_fork_52 = 0.00011406528 * t_right_hip_fork_30;
  // right_thigh
  const Scalar t_right_thigh_127 = w.t_right_foot_57 * Omega_right_thigh_yy;
  const Scalar t_right_thigh_128 = w.t_right_foot_59 * Omega_right_thigh_yx;
  const Scalar F_right_thigh_y = F_right_shank_y - t_right_thigh_127 + t_right_thigh_128;
  const Scalar t_right_hip_fork_53 = t_right_hip_fork_51 - t_right_hip_fork_52;
  const Scalar t_right_thigh_129 = w.s_right_thigh * F_right_thigh_y;
  const Scalar t_right_thigh_130 = w.t_right_foot_57 * Omega_right_thigh_xy;
  const Scalar t_right_thigh_131 = w.t_right_foot_59 * Omega_right_thigh_xx;
  const Scalar F_right_thigh_x = F_right_shank_x - t_right_thigh_130 - t_right_thigh_131;
  const Scalar t_right_hip_fork_54 = t_right_hip_fork_53 - t_right_thigh_129;
  const Scalar M_right_hip_fork_y = t_right_hip_fork_54 + w.c_right_thigh * F_right_thigh_x;
  const Scalar t_left_hip_block_110 = tau[6] - w.s_right_hip_roll * M_right_hip_fork_y;
  const Scalar t_right_hip_fork_55 = w.c_right_hip_roll * M_right_hip_fork_x;
  // left_hip_block
  const Scalar t_left_hip_block_111 = t_left_hip_block_110 - t_right_hip_fork_55;
  const Scalar t_left_hip_block_112 = t_left_hip_block_81 * w.t_right_foot_72;
  const Scalar t_left_hip_block_113 = t_left_hip_block_111 - t_left_hip_block_112;
  const Scalar t_left_hip_block_114 = w.t_righ_ankl_cros_12 * t_left_hip_block_84;
  const Scalar t_left_hip_block_115 = t_left_hip_block_113 + t_left_hip_block_114;
  const Scalar t_left_hip_block_116 = w.t_right_shank_21 * t_left_hip_block_90;
  const Scalar t_left_hip_block_117 = t_left_hip_block_115 + t_left_hip_block_116;
  const Scalar t_left_hip_block_118 = t_left_hip_block_117 + t_left_hip_block_109;
  const Scalar t_left_hip_block_119 = t_left_hip_block_118 - t_left_hip_block_108;
  const Scalar t_left_hip_block_120 = t_right_hip_block_5 * t_left_hip_block_119;
  qdd[6] = t_left_hip_block_120;
  const Scalar t_left_hip_block_121 = w.t_right_hip_fork_25 * t_left_hip_block_107;
  const Scalar t_left_hip_block_122 = t_right_hip_fork_26 * t_left_hip_block_120;
  const Scalar t_left_hip_block_123 = t_left_hip_block_121 - t_left_hip_block_122;
  qdd[7] = t_left_hip_block_123;
  const Scalar t_left_hip_block_124 = w.t_right_thigh_30 * t_left_hip_block_93;
  const Scalar t_left_hip_block_125 = w.t_right_thigh_42 * t_left_hip_block_123;
  const Scalar t_left_hip_block_126 = t_left_hip_block_124 + t_left_hip_block_125;
  const Scalar t_left_hip_block_127 = w.t_right_thigh_31 * t_left_hip_block_120;
  const Scalar t_left_hip_block_128 = t_left_hip_block_126 + t_left_hip_block_127;
  qdd[8] = -t_left_hip_block_128;
  const Scalar t_left_hip_block_129 = w.t_right_shank_20 * t_left_hip_block_90;
  const Scalar t_left_hip_block_130 = w.t_right_shank_24 * t_left_hip_block_128;
  const Scalar t_left_hip_block_131 = t_left_hip_block_129 - t_left_hip_block_130;
  const Scalar t_left_hip_block_132 = w.t_right_shank_30 * t_left_hip_block_123;
  const Scalar t_left_hip_block_133 = t_left_hip_block_131 + t_left_hip_block_132;
  const Scalar t_left_hip_block_134 = w.t_right_shank_21 * t_left_hip_block_120;
  const Scalar t_left_hip_block_135 = t_left_hip_block_133 + t_left_hip_block_134;
  qdd[9] = -t_left_hip_block_135;
  const Scalar t_left_hip_block_136 = w.t_righ_ankl_cros_11 * t_left_hip_block_84;
  const Scalar t_left_hip_block_137 = w.t_righ_ankl_cros_15 * t_left_hip_block_135;
  const Scalar t_left_hip_block_138 = t_left_hip_block_136 - t_left_hip_block_137;
  const Scalar t_left_hip_block_139 = w.t_righ_ankl_cros_21 * t_left_hip_block_128;
  const Scalar t_left_hip_block_140 = t_left_hip_block_138 - t_left_hip_block_139;
  const Scalar t_left_hip_block_141 = w.t_righ_ankl_cros_30 * t_left_hip_block_123;
  const Scalar t_left_hip_block_142 = t_left_hip_block_140 + t_left_hip_block_141;
  const Scalar t_left_hip_block_143 = w.t_righ_ankl_cros_12 * t_left_hip_block_120;
  const Scalar t_left_hip_block_144 = t_left_hip_block_142 + t_left_hip_block_143;
  qdd[10] = -t_left_hip_block_144;
  const Scalar t_left_hip_block_145 = t_left_hip_block_81 * w.t_right_foot_71;
  const Scalar t_left_hip_block_146 = w.t_right_foot_75 * t_left_hip_block_144;
  const Scalar t_left_hip_block_147 = t_left_hip_block_145 + t_left_hip_block_146;
  const Scalar t_left_hip_block_148 = w.t_right_foot_79 * t_left_hip_block_135;
  const Scalar t_left_hip_block_149 = t_left_hip_block_147 + t_left_hip_block_148;
  const Scalar t_left_hip_block_150 = w.t_right_foot_90 * t_left_hip_block_128;
  const Scalar t_left_hip_block_151 = t_left_hip_block_149 + t_left_hip_block_150;
  const Scalar t_left_hip_block_152 = w.t_right_foot_101 * t_left_hip_block_123;
  const Scalar t_left_hip_block_153 = t_left_hip_block_151 - t_left_hip_block_152;
  qdd[11] = t_left_hip_block_153 - w.t_right_foot_72 * t_left_hip_block_120;
}

}  // namespace

void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept {
  ForwardDynamicsWorkspace w;
  forward_dynamics_1(q, w);
  forward_dynamics_2(qd, tau, qdd, w);
  forward_dynamics_3(q, w);
  forward_dynamics_4(qd, tau, qdd, w);
}

void point_positions(const Scalar q[12], Scalar p[12]) noexcept {
  // left_shank
  const Scalar t_left_shank_1 = q[3] + q[4];
  const Scalar c_left_shank = cos(t_left_shank_1);
  const Scalar s_left_shank = sin(t_left_shank_1);
  const Scalar c_left_ankle_pitch = cos(q[4]);
  const Scalar s_left_ankle_pitch = sin(q[4]);
  // left_foot
  const Scalar t_left_foot_1 = 0.2614691411136524 + q[5];
  const Scalar s_left_foot = sin(t_left_foot_1);
  const Scalar c_left_foot = cos(t_left_foot_1);
  // left_thigh
  const Scalar t_left_thigh_1 = 0.01 + 0.432 * c_left_shank + 0.433 * c_left_ankle_pitch;
  const Scalar t_left_thigh_2 = t_left_thigh_1 + 0.015259257195442398 * s_left_foot;
  const Scalar r_left_thigh_x = t_left_thigh_2 + 0.057023643954445244 * c_left_foot;
  const Scalar t_left_thigh_3 = q[2] + t_left_shank_1;
  const Scalar s_left_thigh = sin(t_left_thigh_3);
  const Scalar c_left_thigh = cos(t_left_thigh_3);
  const Scalar t_left_hip_fork_1 = 0.01 - s_left_thigh * r_left_thigh_x;
  const Scalar t_left_thigh_4 = 0.432 * s_left_shank + 0.433 * s_left_ankle_pitch;
  const Scalar r_left_thigh_y = 0.06 - t_left_thigh_4;
  const Scalar r_left_hip_fork_z = t_left_hip_fork_1 - c_left_thigh * r_left_thigh_y;
  const Scalar c_left_hip_yaw = cos(q[0]);
  const Scalar s_left_hip_yaw = sin(q[0]);
  const Scalar t_left_thigh_5 = c_left_thigh * r_left_thigh_x;
  // left_hip_fork
  const Scalar r_left_hip_fork_x = t_left_thigh_5 - s_left_thigh * r_left_thigh_y;
  const Scalar s_left_hip_roll = sin(q[1]);
  const Scalar c_left_hip_roll = cos(q[1]);
  const Scalar t_left_ankle_cross_1 = 0.02 - 0.015259257195442398 * c_left_foot;
  const Scalar r_left_ankle_cross_z = t_left_ankle_cross_1 + 0.057023643954445244 * s_left_foot;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * r_left_ankle_cross_z;
  const Scalar r_left_hip_block_x = t_left_hip_fork_2 + s_left_hip_roll * r_left_hip_fork_x;
  p[0] = c_left_hip_yaw * r_left_hip_fork_z - s_left_hip_yaw * r_left_hip_block_x;
  p[1] = 0.08064 + s_left_hip_yaw * r_left_hip_fork_z + c_left_hip_yaw * r_left_hip_block_x;
  const Scalar t_1 = 0.114 - s_left_hip_roll * r_left_ankle_cross_z;
  p[2] = -(t_1 + c_left_hip_roll * r_left_hip_fork_x);
  const Scalar r_left_thigh_y_2 = 0.20904 + t_left_thigh_4;
  const Scalar r_left_hip_fork_z_2 = t_left_hip_fork_1 + c_left_thigh * r_left_thigh_y_2;
  const Scalar r_left_hip_fork_x_2 = t_left_thigh_5 + s_left_thigh * r_left_thigh_y_2;
  const Scalar r_left_hip_block_x_2 = t_left_hip_fork_2 + s_left_hip_roll * r_left_hip_fork_x_2;
  p[3] = c_left_hip_yaw * r_left_hip_fork_z_2 - s_left_hip_yaw * r_left_hip_block_x_2;
  p[4] = 0.08064 + s_left_hip_yaw * r_left_hip_fork_z_2 + c_left_hip_yaw * r_left_hip_block_x_2;
  p[5] = -(t_1 + c_left_hip_roll * r_left_hip_fork_x_2);
  // right_shank
  const Scalar t_right_shank_1 = q[9] + q[10];
  const Scalar c_right_shank = cos(t_right_shank_1);
  const Scalar s_right_shank = sin(t_right_shank_1);
  const Scalar c_right_ankle_pitch = cos(q[10]);
  const Scalar s_right_ankle_pitch = sin(q[10]);
  // right_foot
  const Scalar t_right_foot_1 = 0.2614691411136524 - q[11];
  const Scalar s_right_foot = sin(t_right_foot_1);
  const Scalar c_right_foot = cos(t_right_foot_1);
  // right_thigh
  const Scalar t_right_thigh_1 = 0.01 + 0.432 * c_right_shank + 0.433 * c_right_ankle_pitch;
  const Scalar t_right_thigh_2 = t_right_thigh_1 + 0.015259257195442398 * s_right_foot;
  const Scalar r_right_thigh_x = t_right_thigh_2 + 0.057023643954445244 * c_right_foot;
  const Scalar t_right_thigh_3 = q[8] + t_right_shank_1;
  const Scalar s_right_thigh = sin(t_right_thigh_3);
  const Scalar c_right_thigh = cos(t_right_thigh_3);
  const Scalar t_right_hip_fork_1 = 0.01 - s_right_thigh * r_right_thigh_x;
  const Scalar t_right_thigh_4 = 0.432 * s_right_shank + 0.433 * s_right_ankle_pitch;
  const Scalar r_right_thigh_y = 0.06 - t_right_thigh_4;
  const Scalar r_right_hip_fork_z = t_right_hip_fork_1 - c_right_thigh * r_right_thigh_y;
  const Scalar c_right_hip_yaw = cos(q[6]);
  const Scalar s_right_hip_yaw = sin(q[6]);
  const Scalar t_right_thigh_5 = c_right_thigh * r_right_thigh_x;
  // right_hip_fork
  const Scalar r_right_hip_fork_x = t_right_thigh_5 - s_right_thigh * r_right_thigh_y;
  const Scalar s_right_hip_roll = sin(q[7]);
  const Scalar c_right_hip_roll = cos(q[7]);
  const Scalar t_righ_ankl_cros_1 = 0.02 - 0.015259257195442398 * c_right_foot;
  const Scalar r_righ_ankl_cros_z = t_righ_ankl_cros_1 + 0.057023643954445244 * s_right_foot;
  const Scalar t_right_hip_fork_2 = c_right_hip_roll * r_righ_ankl_cros_z;
  const Scalar r_right_hip_block_x = t_right_hip_fork_2 - s_right_hip_roll * r_right_hip_fork_x;
  p[6] = c_right_hip_yaw * r_right_hip_fork_z + s_right_hip_yaw * r_right_hip_block_x;
  p[7] = -(0.08064 - s_right_hip_yaw * r_right_hip_fork_z + c_right_hip_yaw * r_right_hip_block_x);
  const Scalar t_2 = 0.114 + s_right_hip_roll * r_righ_ankl_cros_z;
  p[8] = -(t_2 + c_right_hip_roll * r_right_hip_fork_x);
  const Scalar r_right_thigh_y_2 = 0.20904 + t_right_thigh_4;
  const Scalar r_right_hip_fork_z_2 = t_right_hip_fork_1 + c_right_thigh * r_right_thigh_y_2;
  const Scalar r_right_hip_fork_x_2 = t_right_thigh_5 + s_right_thigh * r_right_thigh_y_2;
  const Scalar t_right_hip_fork_3 = s_right_hip_roll * r_right_hip_fork_x_2;
  // right_hip_block
  const Scalar r_right_hip_block_x_2 = t_right_hip_fork_2 - t_right_hip_fork_3;
  p[9] = c_right_hip_yaw * r_right_hip_fork_z_2 + s_right_hip_yaw * r_right_hip_block_x_2;
  const Scalar t_3 = 0.08064 - s_right_hip_yaw * r_right_hip_fork_z_2;
  p[10] = -(t_3 + c_right_hip_yaw * r_right_hip_block_x_2);
  p[11] = -(t_2 + c_right_hip_roll * r_right_hip_fork_x_2);
}

void force_jacobian_transpose(const Scalar q[12], Scalar C[144]) noexcept {
  // right_foot
  const Scalar t_right_foot_1 = 0.2614691411136524 + q[5];
  const Scalar c_right_foot = cos(t_right_foot_1);
  const Scalar s_right_foot = sin(t_right_foot_1);
  const Scalar t_right_foot_2 = 0.015259257195442398 * c_right_foot;
  const Scalar t_right_foot_3 = t_right_foot_2 - 0.057023643954445244 * s_right_foot;
  const Scalar r_left_ankle_cross_z = 0.02 - t_right_foot_3;
  // left_thigh
  const Scalar c_left_hip_roll = cos(q[1]);
  const Scalar s_left_hip_roll = sin(q[1]);
  const Scalar t_left_thigh_1 = c_left_hip_roll * r_left_ankle_cross_z;
  const Scalar t_right_foot_4 = 0.015259257195442398 * s_right_foot;
  const Scalar t_right_foot_5 = t_right_foot_4 + 0.057023643954445244 * c_right_foot;
  const Scalar t_left_ankle_cross_1 = 0.01 + t_right_foot_5;
  const Scalar t_left_ankle_cross_2 = q[2] + q[3];
  // left_foot
  const Scalar t_left_foot_1 = t_left_ankle_cross_2 + q[4];
  const Scalar c_left_foot = cos(t_left_foot_1);
  const Scalar s_left_foot = sin(t_left_foot_1);
  // left_ankle_cross
  const Scalar t_left_ankle_cross_3 = c_left_foot * t_left_ankle_cross_1;
  const Scalar r_left_ankle_cross_x = t_left_ankle_cross_3 - 0.06 * s_left_foot;
  const Scalar c_left_ankle_cross = cos(t_left_ankle_cross_2);
  const Scalar s_left_ankle_cross = sin(t_left_ankle_cross_2);
  const Scalar s_left_ankle_cross_x = 0.433 * c_left_ankle_cross;
  // left_shank
  const Scalar r_left_shank_x = s_left_ankle_cross_x + r_left_ankle_cross_x;
  const Scalar c_left_hip_pitch = cos(q[2]);
  const Scalar s_left_hip_pitch = sin(q[2]);
  const Scalar s_left_shank_x = 0.432 * c_left_hip_pitch;
  const Scalar r_left_thigh_x = s_left_shank_x + r_left_shank_x;
  const Scalar r_left_hip_fork_x = t_left_thigh_1 + s_left_hip_roll * r_left_thigh_x;
  C[14] = r_left_hip_fork_x;
  const Scalar c_left_hip_yaw = cos(q[0]);
  const Scalar s_left_hip_yaw = sin(q[0]);
  // left_ankle_cross
  const Scalar t_left_ankle_cross_4 = s_left_foot * t_left_ankle_cross_1;
  const Scalar r_left_ankle_cross_y = t_left_ankle_cross_4 + 0.06 * c_left_foot;
  const Scalar s_left_ankle_cross_y = 0.433 * s_left_ankle_cross;
  const Scalar r_left_shank_y = s_left_ankle_cross_y + r_left_ankle_cross_y;
  const Scalar s_left_shank_y = 0.432 * s_left_hip_pitch;
  const Scalar r_left_thigh_y = s_left_shank_y + r_left_shank_y;
  const Scalar r_left_hip_fork_z = 0.01 - r_left_thigh_y;
  C[0] = -(c_left_hip_yaw * r_left_hip_fork_x + s_left_hip_yaw * r_left_hip_fork_z);
  C[1] = c_left_hip_yaw * r_left_hip_fork_z - s_left_hip_yaw * r_left_hip_fork_x;
  const Scalar r_left_ankle_cross_x_2 = t_left_ankle_cross_3 + 0.20904 * s_left_foot;
  const Scalar r_left_shank_x_2 = s_left_ankle_cross_x + r_left_ankle_cross_x_2;
  const Scalar r_left_thigh_x_2 = s_left_shank_x + r_left_shank_x_2;
  const Scalar r_left_hip_fork_x_2 = t_left_thigh_1 + s_left_hip_roll * r_left_thigh_x_2;
  C[17] = r_left_hip_fork_x_2;
  const Scalar r_left_ankle_cross_y_2 = t_left_ankle_cross_4 - 0.20904 * c_left_foot;
  const Scalar r_left_shank_y_2 = s_left_ankle_cross_y + r_left_ankle_cross_y_2;
  const Scalar r_left_thigh_y_2 = s_left_shank_y + r_left_shank_y_2;
  const Scalar r_left_hip_fork_z_2 = 0.01 - r_left_thigh_y_2;
  C[3] = -(c_left_hip_yaw * r_left_hip_fork_x_2 + s_left_hip_yaw * r_left_hip_fork_z_2);
  C[4] = c_left_hip_yaw * r_left_hip_fork_z_2 - s_left_hip_yaw * r_left_hip_fork_x_2;
  const Scalar t_left_thigh_2 = s_left_hip_roll * r_left_ankle_cross_z;
  // left_hip_fork
  const Scalar r_left_hip_fork_y = t_left_thigh_2 - c_left_hip_roll * r_left_thigh_x;
  C[12] = s_left_hip_yaw * r_left_hip_fork_y;
  C[13] = -c_left_hip_yaw * r_left_hip_fork_y;
  const Scalar r_left_hip_fork_y_2 = t_left_thigh_2 - c_left_hip_roll * r_left_thigh_x_2;
  C[15] = s_left_hip_yaw * r_left_hip_fork_y_2;
  C[16] = -c_left_hip_yaw * r_left_hip_fork_y_2;
  // left_thigh
  const Scalar Rx_left_thigh_x = s_left_hip_yaw * s_left_hip_roll;
  C[24] = Rx_left_thigh_x * r_left_thigh_y - c_left_hip_yaw * r_left_thigh_x;
  const Scalar Ry_left_thigh_x = c_left_hip_yaw * s_left_hip_roll;
  C[25] = -(s_left_hip_yaw * r_left_thigh_x + Ry_left_thigh_x * r_left_thigh_y);
  C[26] = c_left_hip_roll * r_left_thigh_y;
  C[27] = Rx_left_thigh_x * r_left_thigh_y_2 - c_left_hip_yaw * r_left_thigh_x_2;
  C[28] = -(s_left_hip_yaw * r_left_thigh_x_2 + Ry_left_thigh_x * r_left_thigh_y_2);
  C[29] = c_left_hip_roll * r_left_thigh_y_2;
  // left_shank
  C[36] = Rx_left_thigh_x * r_left_shank_y - c_left_hip_yaw * r_left_shank_x;
  C[37] = -(s_left_hip_yaw * r_left_shank_x + Ry_left_thigh_x * r_left_shank_y);
  C[38] = c_left_hip_roll * r_left_shank_y;
  C[39] = Rx_left_thigh_x * r_left_shank_y_2 - c_left_hip_yaw * r_left_shank_x_2;
  C[40] = -(s_left_hip_yaw * r_left_shank_x_2 + Ry_left_thigh_x * r_left_shank_y_2);
  C[41] = c_left_hip_roll * r_left_shank_y_2;
  // left_ankle_cross
  C[48] = Rx_left_thigh_x * r_left_ankle_cross_y - c_left_hip_yaw * r_left_ankle_cross_x;
  C[49] = -(s_left_hip_yaw * r_left_ankle_cross_x + Ry_left_thigh_x * r_left_ankle_cross_y);
  C[50] = c_left_hip_roll * r_left_ankle_cross_y;
  C[51] = Rx_left_thigh_x * r_left_ankle_cross_y_2 - c_left_hip_yaw * r_left_ankle_cross_x_2;
  C[52] = -(s_left_hip_yaw * r_left_ankle_cross_x_2 + Ry_left_thigh_x * r_left_ankle_cross_y_2);
  C[53] = c_left_hip_roll * r_left_ankle_cross_y_2;
  // left_foot
  const Scalar Rx_left_foot_x = c_left_hip_yaw * s_left_foot + c_left_foot * Rx_left_thigh_x;
  const Scalar t_left_foot_2 = c_left_hip_roll * t_right_foot_5;
  C[60] = -(s_left_hip_yaw * t_left_foot_2 + Rx_left_foot_x * t_right_foot_3);
  C[63] = C[60];
  const Scalar Ry_left_foot_x = s_left_hip_yaw * s_left_foot - c_left_foot * Ry_left_thigh_x;
  C[61] = c_left_hip_yaw * t_left_foot_2 - Ry_left_foot_x * t_right_foot_3;
  C[64] = C[61];
  const Scalar Rz_left_foot_x = c_left_hip_roll * c_left_foot;
  C[62] = s_left_hip_roll * t_right_foot_5 - t_right_foot_3 * Rz_left_foot_x;
  C[65] = C[62];
  // left_hip_block
  const Scalar t_left_hip_block_1 = 0.2614691411136524 - q[11];
  const Scalar c_left_hip_block = cos(t_left_hip_block_1);
  const Scalar s_left_hip_block = sin(t_left_hip_block_1);
  const Scalar t_left_hip_block_2 = 0.015259257195442398 * c_left_hip_block;
  const Scalar t_left_hip_block_3 = 0.057023643954445244 * s_left_hip_block;
  const Scalar t_left_hip_block_4 = t_left_hip_block_2 - t_left_hip_block_3;
  const Scalar r_righ_ankl_cros_z = 0.02 - t_left_hip_block_4;
  // right_thigh
  const Scalar c_right_hip_roll = cos(q[7]);
  const Scalar s_right_hip_roll = sin(q[7]);
  const Scalar t_right_thigh_1 = c_right_hip_roll * r_righ_ankl_cros_z;
  // left_hip_block
  const Scalar t_left_hip_block_5 = 0.015259257195442398 * s_left_hip_block;
  const Scalar t_left_hip_block_6 = 0.057023643954445244 * c_left_hip_block;
  const Scalar t_left_hip_block_7 = t_left_hip_block_5 + t_left_hip_block_6;
  const Scalar t_righ_ankl_cros_1 = 0.01 + t_left_hip_block_7;
  const Scalar t_righ_ankl_cros_2 = q[8] + q[9];
  // right_foot
  const Scalar t_right_foot_6 = t_righ_ankl_cros_2 + q[10];
  const Scalar c_right_foot_2 = cos(t_right_foot_6);
  const Scalar s_right_foot_2 = sin(t_right_foot_6);
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_3 = c_right_foot_2 * t_righ_ankl_cros_1;
  const Scalar r_righ_ankl_cros_x = t_righ_ankl_cros_3 - 0.06 * s_right_foot_2;
  const Scalar c_righ_ankl_cros = cos(t_righ_ankl_cros_2);
  const Scalar s_righ_ankl_cros = sin(t_righ_ankl_cros_2);
  const Scalar s_righ_ankl_cros_x = 0.433 * c_righ_ankl_cros;
  // right_shank
  const Scalar r_right_shank_x = s_righ_ankl_cros_x + r_righ_ankl_cros_x;
  const Scalar c_right_hip_pitch = cos(q[8]);
  const Scalar s_right_hip_pitch = sin(q[8]);
  const Scalar s_right_shank_x = 0.432 * c_right_hip_pitch;
  const Scalar r_right_thigh_x = s_right_shank_x + r_right_shank_x;
  const Scalar r_right_hip_fork_x = t_right_thigh_1 - s_right_hip_roll * r_right_thigh_x;
  C[92] = -r_right_hip_fork_x;
  const Scalar c_right_hip_yaw = cos(q[6]);
  const Scalar s_right_hip_yaw = sin(q[6]);
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_4 = s_right_foot_2 * t_righ_ankl_cros_1;
  const Scalar r_righ_ankl_cros_y = t_righ_ankl_cros_4 + 0.06 * c_right_foot_2;
  const Scalar s_righ_ankl_cros_y = 0.433 * s_righ_ankl_cros;
  const Scalar r_right_shank_y = s_righ_ankl_cros_y + r_righ_ankl_cros_y;
  const Scalar s_right_shank_y = 0.432 * s_right_hip_pitch;
  const Scalar r_right_thigh_y = s_right_shank_y + r_right_shank_y;
  const Scalar r_right_hip_fork_z = 0.01 - r_right_thigh_y;
  C[78] = c_right_hip_yaw * r_right_hip_fork_x - s_right_hip_yaw * r_right_hip_fork_z;
  C[79] = s_right_hip_yaw * r_right_hip_fork_x + c_right_hip_yaw * r_right_hip_fork_z;
  const Scalar r_righ_ankl_cros_x_2 = t_righ_ankl_cros_3 + 0.20904 * s_right_foot_2;
  const Scalar r_right_shank_x_2 = s_righ_ankl_cros_x + r_righ_ankl_cros_x_2;
  const Scalar r_right_thigh_x_2 = s_right_shank_x + r_right_shank_x_2;
  const Scalar r_right_hip_fork_x_2 = t_right_thigh_1 - s_right_hip_roll * r_right_thigh_x_2;
  C[95] = -r_right_hip_fork_x_2;
  const Scalar r_righ_ankl_cros_y_2 = t_righ_ankl_cros_4 - 0.20904 * c_right_foot_2;
  const Scalar r_right_shank_y_2 = s_righ_ankl_cros_y + r_righ_ankl_cros_y_2;
  const Scalar r_right_thigh_y_2 = s_right_shank_y + r_right_shank_y_2;
  const Scalar r_right_hip_fork_z_2 = 0.01 - r_right_thigh_y_2;
  C[81] = c_right_hip_yaw * r_right_hip_fork_x_2 - s_right_hip_yaw * r_right_hip_fork_z_2;
  C[82] = s_right_hip_yaw * r_right_hip_fork_x_2 + c_right_hip_yaw * r_right_hip_fork_z_2;
  const Scalar t_right_thigh_2 = s_right_hip_roll * r_righ_ankl_cros_z;
  // right_hip_fork
  const Scalar r_right_hip_fork_y = t_right_thigh_2 + c_right_hip_roll * r_right_thigh_x;
  C[90] = -s_right_hip_yaw * r_right_hip_fork_y;
  C[91] = c_right_hip_yaw * r_right_hip_fork_y;
  const Scalar r_right_hip_fork_y_2 = t_right_thigh_2 + c_right_hip_roll * r_right_thigh_x_2;
  C[93] = -s_right_hip_yaw * r_right_hip_fork_y_2;
  C[94] = c_right_hip_yaw * r_right_hip_fork_y_2;
  // right_thigh
  const Scalar Rx_right_thigh_x = s_right_hip_yaw * s_right_hip_roll;
  C[102] = Rx_right_thigh_x * r_right_thigh_y - c_right_hip_yaw * r_right_thigh_x;
  const Scalar Ry_right_thigh_x = c_right_hip_yaw * s_right_hip_roll;
  C[103] = -(s_right_hip_yaw * r_right_thigh_x + Ry_right_thigh_x * r_right_thigh_y);
  C[104] = c_right_hip_roll * r_right_thigh_y;
  C[105] = Rx_right_thigh_x * r_right_thigh_y_2 - c_right_hip_yaw * r_right_thigh_x_2;
  C[106] = -(s_right_hip_yaw * r_right_thigh_x_2 + Ry_right_thigh_x * r_right_thigh_y_2);
  C[107] = c_right_hip_roll * r_right_thigh_y_2;
  // right_shank
  C[114] = Rx_right_thigh_x * r_right_shank_y - c_right_hip_yaw * r_right_shank_x;
  C[115] = -(s_right_hip_yaw * r_right_shank_x + Ry_right_thigh_x * r_right_shank_y);
  C[116] = c_right_hip_roll * r_right_shank_y;
  C[117] = Rx_right_thigh_x * r_right_shank_y_2 - c_right_hip_yaw * r_right_shank_x_2;
  C[118] = -(s_right_hip_yaw * r_right_shank_x_2 + Ry_right_thigh_x * r_right_shank_y_2);
  C[119] = c_right_hip_roll * r_right_shank_y_2;
  // right_ankle_cross
  C[126] = Rx_right_thigh_x * r_righ_ankl_cros_y - c_right_hip_yaw * r_righ_ankl_cros_x;
  C[127] = -(s_right_hip_yaw * r_righ_ankl_cros_x + Ry_right_thigh_x * r_righ_ankl_cros_y);
  C[128] = c_right_hip_roll * r_righ_ankl_cros_y;
  C[129] = Rx_right_thigh_x * r_righ_ankl_cros_y_2 - c_right_hip_yaw * r_righ_ankl_cros_x_2;
  C[130] = -(s_right_hip_yaw * r_righ_ankl_cros_x_2 + Ry_right_thigh_x * r_righ_ankl_cros_y_2);
  C[131] = c_right_hip_roll * r_righ_ankl_cros_y_2;
  // right_foot
  const Scalar t_right_foot_7 = c_right_foot_2 * Rx_right_thigh_x;
  const Scalar Rx_right_foot_x = c_right_hip_yaw * s_right_foot_2 + t_right_foot_7;
  const Scalar t_right_foot_8 = c_right_hip_roll * t_left_hip_block_7;
  C[138] = Rx_right_foot_x * t_left_hip_block_4 - s_right_hip_yaw * t_right_foot_8;
  C[141] = C[138];
  const Scalar t_right_foot_9 = c_right_foot_2 * Ry_right_thigh_x;
  const Scalar Ry_right_foot_x = s_right_hip_yaw * s_right_foot_2 - t_right_foot_9;
  C[139] = c_right_hip_yaw * t_right_foot_8 + Ry_right_foot_x * t_left_hip_block_4;
  C[142] = C[139];
  const Scalar Rz_right_foot_x = c_right_hip_roll * c_right_foot_2;
  C[140] = s_right_hip_roll * t_left_hip_block_7 + t_left_hip_block_4 * Rz_right_foot_x;
  C[143] = C[140];
  C[2] = 0.0;
  C[5] = 0.0;
  C[6] = 0.0;
  C[7] = 0.0;
  C[8] = 0.0;
  C[9] = 0.0;
  C[10] = 0.0;
  C[11] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
  C[21] = 0.0;
  C[22] = 0.0;
  C[23] = 0.0;
  C[30] = 0.0;
  C[31] = 0.0;
  C[32] = 0.0;
  C[33] = 0.0;
  C[34] = 0.0;
  C[35] = 0.0;
  C[42] = 0.0;
  C[43] = 0.0;
  C[44] = 0.0;
  C[45] = 0.0;
  C[46] = 0.0;
  C[47] = 0.0;
  C[54] = 0.0;
  C[55] = 0.0;
  C[56] = 0.0;
  C[57] = 0.0;
  C[58] = 0.0;
  C[59] = 0.0;
  C[66] = 0.0;
  C[67] = 0.0;
  C[68] = 0.0;
  C[69] = 0.0;
  C[70] = 0.0;
  C[71] = 0.0;
  C[72] = 0.0;
  C[73] = 0.0;
  C[74] = 0.0;
  C[75] = 0.0;
  C[76] = 0.0;
  C[77] = 0.0;
  C[80] = 0.0;
  C[83] = 0.0;
  C[84] = 0.0;
  C[85] = 0.0;
  C[86] = 0.0;
  C[87] = 0.0;
  C[88] = 0.0;
  C[89] = 0.0;
  C[96] = 0.0;
  C[97] = 0.0;
  C[98] = 0.0;
  C[99] = 0.0;
  C[100] = 0.0;
  C[101] = 0.0;
  C[108] = 0.0;
  C[109] = 0.0;
  C[110] = 0.0;
  C[111] = 0.0;
  C[112] = 0.0;
  C[113] = 0.0;
  C[120] = 0.0;
  C[121] = 0.0;
  C[122] = 0.0;
  C[123] = 0.0;
  C[124] = 0.0;
  C[125] = 0.0;
  C[132] = 0.0;
  C[133] = 0.0;
  C[134] = 0.0;
  C[135] = 0.0;
  C[136] = 0.0;
  C[137] = 0.0;
}

}  // namespace biped
