// panda.cpp: see panda.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate panda.yaml --effort 1000

#include "panda.hpp"

#include <cmath>

namespace panda {

using std::cos;
using std::sin;

void mass_matrix(const Scalar q[7], Scalar A[49]) noexcept {
  const Scalar c_joint2 = cos(q[1]);
  const Scalar s_joint2 = sin(q[1]);
  const Scalar c_joint3 = cos(q[2]);
  const Scalar s_joint3 = sin(q[2]);
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar c_joint6 = cos(q[5]);
  const Scalar s_joint6 = sin(q[5]);
  // link7
  const Scalar t_link7_1 = 0.3842058806066518 - q[6];
  const Scalar c_link7 = cos(t_link7_1);
  const Scalar s_link7 = sin(t_link7_1);
  const Scalar t_link7_2 = 0.0006883615516358103 * c_link7;
  const Scalar h_link6_z = 0.0006883615516358103 * s_link7;
  const Scalar t_link7_3 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_4 = s_link7 * t_link7_3;
  const Scalar t_link7_5 = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  const Scalar t_link7_6 = 0.00113526676062776 * c_link7 - 0.0013450149983408877 * s_link7;
  A[41] = -t_link7_6;
  A[47] = A[41];
  const Scalar t_link7_7 = 0.004909651967360946 + 0.0007342523217448644 * c_link7;
  // link6
  const Scalar h_link6_x = 0.0136098230973375 + t_link7_2;
  const Scalar t_link6_1 = 0.0013098798160415795 - t_link7_4 + 0.0014685046434897288 * c_link7;
  const Scalar E_link6_xy = 0.005511034382675315 + t_link7_5;
  const Scalar t_link6_2 = 0.0006609405457638925 - c_link7 * t_link7_3;
  const Scalar E_link6_xz = t_link6_2 - 0.0007342523217448644 * s_link7;
  const Scalar E_link6_yz = 9.3569097314605e-05 + t_link7_6;
  const Scalar t_link6_3 = 0.02914515311624745 + t_link6_1;
  A[40] = t_link6_3;
  const Scalar t_link6_4 = 0.0056786982094425 * s_joint6 + c_joint6 * h_link6_x;
  const Scalar h_link5_z = 0.0056786982094425 * c_joint6 - s_joint6 * h_link6_x;
  const Scalar t_link6_5 = s_joint6 * (0.002128477624927662 + t_link6_1);
  const Scalar t_link6_6 = c_joint6 * E_link6_xy * 2.0 - t_link6_5;
  const Scalar t_link6_7 = s_joint6 * t_link6_6;
  const Scalar t_link6_8 = s_joint6 * E_link6_yz + c_joint6 * E_link6_xz;
  const Scalar t_link6_9 = c_joint6 * E_link6_yz - s_joint6 * E_link6_xz;
  A[33] = t_link6_9;
  A[39] = A[33];
  const Scalar t_link6_10 = c_joint6 * h_link6_z;
  const Scalar t_link6_11 = s_joint6 * h_link6_z;
  const Scalar t_link6_12 = c_joint6 * t_link7_7 + s_joint6 * t_link7_5;
  A[34] = -t_link6_12;
  A[46] = A[34];
  const Scalar t_link6_13 = 0.0032040101312503172 * c_link7 + s_joint6 * t_link7_7;
  const Scalar t_link6_14 = t_link6_13 - c_joint6 * t_link7_5;
  const Scalar t_link6_15 = t_link7_6 + 4.654545454545454 * t_link6_10;
  const Scalar t_link6_16 = t_link6_3 - 4.654545454545454 * h_link5_z;
  // link5
  const Scalar h_link5_x = 0.001208932934385 - t_link6_4;
  const Scalar E_link5_xx = 0.017087971435614267 + t_link6_1 + t_link6_7;
  const Scalar E_link5_xy = 0.00151524447332703 - t_link6_8;
  const Scalar t_link5_1 = t_link7_5 + 0.004484246605646421 - c_joint6 * t_link6_6;
  const Scalar E_link5_xz = t_link5_1 + 4.654545454545454 * t_link6_4;
  const Scalar h_link5_y = 0.0055993270925625 + h_link6_z;
  const Scalar E_link5_yy = 0.013644959979640612 + t_link7_4;
  const Scalar E_link5_yz = 0.02389827041510187 + t_link6_9 + 0.0032040101312503172 * s_link7;
  const Scalar t_link5_2 = E_link5_xx + E_link5_yy;
  A[32] = t_link5_2;
  const Scalar t_link5_3 = s_joint5 * h_link5_y + c_joint5 * h_link5_x;
  const Scalar h_link4_z = c_joint5 * h_link5_y - s_joint5 * h_link5_x;
  const Scalar t_link5_4 = c_joint5 * E_link5_xy * 2.0 + s_joint5 * (E_link5_xx - E_link5_yy);
  const Scalar t_link5_5 = s_joint5 * t_link5_4;
  const Scalar t_link5_6 = s_joint5 * E_link5_yz - c_joint5 * E_link5_xz;
  const Scalar t_link5_7 = c_joint5 * E_link5_yz + s_joint5 * E_link5_xz;
  A[25] = t_link5_7;
  A[31] = A[25];
  const Scalar t_link5_8 = s_joint5 * t_link7_2 + c_joint5 * t_link6_10;
  const Scalar t_link5_9 = c_joint5 * t_link7_2 - s_joint5 * t_link6_10;
  const Scalar t_link5_10 = s_joint5 * t_link6_15 - c_joint5 * t_link6_14;
  const Scalar t_link5_11 = t_link6_12 - t_link5_9;
  const Scalar t_link5_12 = t_link6_11 + c_joint5 * t_link6_15 + s_joint5 * t_link6_14;
  A[27] = -t_link5_12;
  A[45] = A[27];
  const Scalar t_link5_13 = c_joint5 * h_link5_z;
  const Scalar t_link5_14 = s_joint5 * h_link5_z;
  const Scalar t_link5_15 = s_joint5 * t_link6_16 - c_joint5 * t_link6_8;
  const Scalar t_link5_16 = t_link6_9 - t_link5_14;
  const Scalar t_link5_17 = t_link6_4 - c_joint5 * t_link6_16 - s_joint5 * t_link6_8;
  A[26] = -t_link5_17;
  A[38] = A[26];
  const Scalar t_link5_18 = t_link5_2 + t_link5_3;
  // link4
  const Scalar h_link4_x = 0.040431622658625 + t_link5_3;
  const Scalar E_link4_xx = t_link5_5 - (0.0458473861568155 + E_link5_xx) - 2.0 * t_link5_3;
  const Scalar E_link4_xy = 0.13876407268546084 - h_link5_z + t_link5_6;
  const Scalar t_link4_1 = h_link4_z - (t_link6_8 + 0.00239011055294907);
  const Scalar E_link4_xz = t_link4_1 - c_joint5 * t_link5_4;
  const Scalar h_link4_y = 0.1419563931722475 - h_link5_z;
  const Scalar E_link4_yy = 0.5987338527766317 - t_link6_7 - 9.309090909090909 * h_link5_z;
  const Scalar E_link4_yz = 0.00164448757736927 - t_link5_7;
  const Scalar t_link4_2 = E_link4_xx - E_link4_yy;
  A[24] = -t_link4_2;
  const Scalar t_link4_3 = s_joint4 * h_link4_y + c_joint4 * h_link4_x;
  const Scalar h_link3_z = c_joint4 * h_link4_y - s_joint4 * h_link4_x;
  const Scalar t_link4_4 = c_joint4 * E_link4_xy * 2.0 + s_joint4 * (E_link4_xx + E_link4_yy);
  const Scalar t_link4_5 = s_joint4 * t_link4_4;
  const Scalar t_link4_6 = s_joint4 * E_link4_yz - c_joint4 * E_link4_xz;
  const Scalar t_link4_7 = c_joint4 * E_link4_yz + s_joint4 * E_link4_xz;
  A[17] = -t_link4_7;
  A[23] = A[17];
  const Scalar t_link4_8 = 3.83030303030303 * t_link5_9 + s_joint4 * t_link5_11;
  const Scalar t_link4_9 = t_link4_8 - c_joint4 * t_link5_10;
  const Scalar t_link4_10 = 3.83030303030303 * (s_joint4 * t_link6_11 - c_joint4 * t_link5_8);
  const Scalar t_link4_11 = t_link5_12 - c_joint4 * t_link6_11 - s_joint4 * t_link5_8;
  const Scalar t_link4_12 = t_link4_11 - t_link4_10;
  const Scalar t_link4_13 = t_link5_9 + c_joint4 * t_link5_11 + s_joint4 * t_link5_10;
  A[20] = -t_link4_13;
  A[44] = A[20];
  const Scalar t_link4_14 = 3.83030303030303 * t_link5_14 + s_joint4 * t_link5_16;
  const Scalar t_link4_15 = t_link4_14 - c_joint4 * t_link5_15;
  const Scalar t_link4_16 = 3.83030303030303 * (s_joint4 * t_link6_4 - c_joint4 * t_link5_13);
  const Scalar t_link4_17 = t_link5_17 - c_joint4 * t_link6_4 - s_joint4 * t_link5_13;
  const Scalar t_link4_18 = t_link4_17 - t_link4_16;
  const Scalar t_link4_19 = t_link5_14 + c_joint4 * t_link5_16 + s_joint4 * t_link5_15;
  A[19] = t_link4_19;
  A[37] = A[19];
  const Scalar t_link4_20 = 3.83030303030303 * t_link5_3 - s_joint4 * t_link5_18;
  const Scalar t_link4_21 = t_link4_20 + c_joint4 * t_link5_6;
  const Scalar t_link4_22 = t_link5_7 - h_link4_z * (s_joint4 - 3.83030303030303 * c_joint4);
  const Scalar t_link4_23 = t_link5_3 - c_joint4 * t_link5_18 - s_joint4 * t_link5_6;
  A[18] = -t_link4_23;
  A[30] = A[18];
  const Scalar t_link4_24 = t_link4_2 + t_link4_3 - 3.83030303030303 * h_link3_z;
  // link3
  const Scalar E_link3_xx = 0.0564296710265277 - E_link4_xx + t_link4_5 - 2.0 * t_link4_3;
  const Scalar E_link3_xy = 0.000121912420950744 + h_link4_z + t_link4_6;
  const Scalar t_link3_1 = 0.22168156342611425 + E_link4_xy + h_link3_z - c_joint4 * t_link4_4;
  const Scalar E_link3_xz = t_link3_1 - 3.83030303030303 * t_link4_3;
  const Scalar E_link3_yy = t_link7_4 + 0.035823108944518844 + t_link5_5;
  const Scalar E_link3_yz = 0.013297019103287584 - t_link4_7 + 3.83030303030303 * h_link4_z;
  const Scalar t_link3_2 = E_link3_xx + E_link3_yy;
  A[16] = t_link3_2;
  const Scalar t_link3_3 = c_joint3 * E_link3_xy * 2.0 + s_joint3 * (E_link3_xx - E_link3_yy);
  const Scalar t_link3_4 = s_joint3 * t_link3_3;
  const Scalar t_link3_5 = s_joint3 * E_link3_yz - c_joint3 * E_link3_xz;
  const Scalar t_link3_6 = c_joint3 * E_link3_yz + s_joint3 * E_link3_xz;
  A[9] = -t_link3_6;
  A[15] = A[9];
  const Scalar t_link3_7 = s_joint3 * t_link4_12 - c_joint3 * t_link4_9;
  A[13] = c_joint3 * t_link4_12 + s_joint3 * t_link4_9;
  A[43] = A[13];
  const Scalar t_link3_8 = s_joint3 * t_link4_18 + c_joint3 * t_link4_15;
  A[12] = c_joint3 * t_link4_18 - s_joint3 * t_link4_15;
  A[36] = A[12];
  const Scalar t_link3_9 = s_joint3 * t_link4_22 + c_joint3 * t_link4_21;
  A[11] = s_joint3 * t_link4_21 - c_joint3 * t_link4_22;
  A[29] = A[11];
  const Scalar t_link3_10 = s_joint3 * t_link4_24 - c_joint3 * t_link4_6;
  A[10] = c_joint3 * t_link4_24 + s_joint3 * t_link4_6;
  A[22] = A[10];
  // link2
  const Scalar E_link2_xx = t_link3_4 - (0.023077882494931805 + E_link3_xx);
  const Scalar E_link2_xy = 0.00398335888393552 + t_link3_5;
  const Scalar E_link2_xz = 0.01026110182100817 + E_link3_xy - c_joint3 * t_link3_3;
  const Scalar t_link2_1 = t_link4_5 - (0.9562715012318808 + E_link4_yy);
  const Scalar E_link2_yy = t_link2_1 - 7.66060606060606 * h_link3_z;
  const Scalar E_link2_yz = 0.0007689361029464 + t_link3_6;
  A[8] = -(E_link2_xx + E_link2_yy);
  A[1] = -(c_joint2 * E_link2_yz + s_joint2 * E_link2_xz);
  A[7] = A[1];
  A[6] = s_joint2 * t_link3_7 - c_joint2 * t_link4_13;
  A[42] = A[6];
  A[5] = c_joint2 * t_link4_19 + s_joint2 * t_link3_8;
  A[35] = A[5];
  A[4] = -(c_joint2 * t_link4_23 + s_joint2 * t_link3_9);
  A[28] = A[4];
  A[3] = s_joint2 * t_link3_10 - c_joint2 * t_link4_7;
  A[21] = A[3];
  A[2] = c_joint2 * t_link3_2 - s_joint2 * t_link3_5;
  A[14] = A[2];
  const Scalar t_link2_2 = c_joint2 * E_link2_xy * 2.0 - s_joint2 * (E_link2_xx - E_link2_yy);
  // link1
  A[0] = -(E_link2_xx - (0.014259565994474374 + E_link3_yy + t_link3_4) + s_joint2 * t_link2_2);
  A[48] = 0.004909651967360946;
}

void bias_force(const Scalar q[7], const Scalar qd[7], Scalar B[7]) noexcept {
  const Scalar c_joint2 = cos(q[1]);
  const Scalar s_joint2 = sin(q[1]);
  const Scalar alpha_link2_x = qd[0] * qd[1];
  // link3
  const Scalar t_link3_1 = c_joint2 * alpha_link2_x;
  const Scalar c_joint3 = cos(q[2]);
  const Scalar s_joint3 = sin(q[2]);
  const Scalar t_link3_2 = s_joint2 * qd[0];
  const Scalar omega_link3_y = c_joint3 * qd[1] + s_joint3 * t_link3_2;
  const Scalar alpha_link3_x = c_joint3 * t_link3_1 - omega_link3_y * qd[2];
  const Scalar omega_link3_z = qd[2] + c_joint2 * qd[0];
  const Scalar t_link3_3 = omega_link3_y * omega_link3_z;
  const Scalar Omega_link3_zy = alpha_link3_x - t_link3_3;
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar omega_link3_x = s_joint3 * qd[1] - c_joint3 * t_link3_2;
  const Scalar t_link3_4 = omega_link3_x * omega_link3_y;
  const Scalar alpha_link3_z = s_joint2 * alpha_link2_x;
  const Scalar Omega_link3_xy = alpha_link3_z + t_link3_4;
  // link4
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy + s_joint4 * Omega_link3_xy;
  const Scalar omega_link4_y = c_joint4 * omega_link3_z - s_joint4 * omega_link3_x;
  const Scalar omega_link4_z = omega_link3_y - qd[3];
  const Scalar Omega_link4_zy = Omega_link4_yz + omega_link4_y * omega_link4_z * 2.0;
  const Scalar s_joint5 = sin(q[4]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar omega_link4_x = s_joint4 * omega_link3_z + c_joint4 * omega_link3_x;
  const Scalar t_link4_1 = omega_link4_x * omega_link4_y;
  const Scalar alpha_link3_y = s_joint3 * t_link3_1 - omega_link3_x * qd[2];
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_1;
  // link5
  const Scalar Omega_link5_xz = s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar omega_link5_x = s_joint5 * omega_link4_z + c_joint5 * omega_link4_x;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar t_link5_1 = omega_link5_x * omega_link5_z;
  const Scalar alpha_link5_y = Omega_link5_xz - t_link5_1;
  // link6
  const Scalar s_joint6 = sin(q[5]);
  const Scalar c_joint6 = cos(q[5]);
  const Scalar omega_link6_x = s_joint6 * omega_link5_z + c_joint6 * omega_link5_x;
  const Scalar omega_link6_y = c_joint6 * omega_link5_z - s_joint6 * omega_link5_x;
  const Scalar t_link6_1 = omega_link6_x * omega_link6_y;
  const Scalar Omega_link6_yx = alpha_link5_y - t_link6_1;
  // link5
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar omega_link5_y = c_joint5 * omega_link4_z - s_joint5 * omega_link4_x;
  const Scalar Omega_link5_zy = Omega_link5_yz - omega_link5_y * omega_link5_z * 2.0;
  // link4
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy - c_joint4 * Omega_link3_xy;
  const Scalar t_link4_2 = omega_link4_x * omega_link4_z;
  const Scalar alpha_link4_y = Omega_link4_xz + t_link4_2;
  const Scalar t_link5_2 = omega_link5_x * omega_link5_y;
  const Scalar Omega_link5_xy = alpha_link4_y - t_link5_2;
  // link6
  const Scalar Omega_link6_yz = c_joint6 * Omega_link5_zy - s_joint6 * Omega_link5_xy;
  const Scalar t_link6_2 = 0.001119670733427555 * Omega_link6_yx;
  const Scalar Omega_link6_xz = s_joint6 * Omega_link5_zy + c_joint6 * Omega_link5_xy;
  const Scalar t_link6_3 = t_link6_2 - 0.000103758917218685 * Omega_link6_yz;
  const Scalar Omega_link6_xy = alpha_link5_y + t_link6_1;
  const Scalar t_link6_4 = t_link6_3 - 9.3569097314605e-05 * Omega_link6_xz;
  // link5
  const Scalar t_link5_3 = omega_link5_z * omega_link5_z;
  const Scalar t_link5_4 = omega_link5_x * omega_link5_x;
  const Scalar Omega_link5_yy = t_link5_3 + t_link5_4;
  // link6
  const Scalar t_link6_5 = omega_link6_x * omega_link6_x;
  const Scalar omega_link6_z = omega_link5_y - qd[5];
  const Scalar t_link6_6 = omega_link6_z * omega_link6_z;
  const Scalar t_link6_7 = t_link6_6 - t_link6_5;
  const Scalar Omega_link6_xx = Omega_link5_yy + t_link6_7;
  const Scalar Omega_link6_yy = t_link6_6 + t_link6_5;
  const Scalar t_link6_8 = 0.005511034382675315 * (Omega_link6_xx - Omega_link6_yy);
  const Scalar t_link6_9 = t_link6_4 + 0.013508337745659894 * Omega_link6_xy + t_link6_8;
  const Scalar Omega_link3_yx = alpha_link3_z - t_link3_4;
  const Scalar Omega_link3_yz = alpha_link3_x + t_link3_3;
  const Scalar a_link4_z = Omega_link3_yx - 3.83030303030303 * Omega_link3_yz;
  const Scalar Omega_link4_zx = t_link4_2 + alpha_link4_y;
  const Scalar t_link5_5 = a_link4_z + Omega_link4_zx;
  // link3
  const Scalar t_link3_5 = omega_link3_x * omega_link3_x;
  const Scalar t_link3_6 = omega_link3_y * omega_link3_y;
  const Scalar Omega_link3_zz = t_link3_5 + t_link3_6;
  const Scalar t_link3_7 = omega_link3_x * omega_link3_z;
  const Scalar Omega_link3_zx = alpha_link3_y - t_link3_7;
  const Scalar t_link4_3 = Omega_link3_zx + 3.83030303030303 * Omega_link3_zz;
  const Scalar t_link3_8 = omega_link3_z * omega_link3_z;
  const Scalar Omega_link3_xx = t_link3_6 + t_link3_8;
  const Scalar Omega_link3_xz = alpha_link3_y + t_link3_7;
  // link4
  const Scalar t_link4_4 = Omega_link3_xx - 3.83030303030303 * Omega_link3_xz;
  const Scalar a_link4_x = s_joint4 * t_link4_3 + c_joint4 * t_link4_4;
  const Scalar t_link4_5 = omega_link4_x * omega_link4_x;
  const Scalar t_link4_6 = omega_link4_z * omega_link4_z;
  const Scalar t_link4_7 = t_link4_6 - t_link4_5;
  const Scalar Omega_link3_yy = t_link3_5 + t_link3_8;
  const Scalar Omega_link4_xx = Omega_link3_yy + t_link4_7;
  const Scalar t_link5_6 = a_link4_x - Omega_link4_xx;
  const Scalar a_link5_x = s_joint5 * t_link5_5 + c_joint5 * t_link5_6;
  const Scalar t_link6_10 = a_link5_x - 4.654545454545454 * Omega_link5_xz;
  const Scalar Omega_link4_yx = alpha_link3_y - t_link4_1;
  const Scalar a_link5_z = Omega_link4_yx - c_joint4 * t_link4_3 + s_joint4 * t_link4_4;
  const Scalar Omega_link4_yy = t_link4_6 + t_link4_5;
  // link6
  const Scalar t_link6_11 = a_link5_z - 4.654545454545454 * Omega_link4_yy;
  const Scalar a_link6_x = s_joint6 * t_link6_11 - c_joint6 * t_link6_10;
  const Scalar t_link6_12 = omega_link6_x * omega_link6_z;
  const Scalar alpha_link6_y = Omega_link6_xz + t_link6_12;
  const Scalar Omega_link6_xz_2 = t_link6_12 - alpha_link6_y;
  // link7
  const Scalar t_link7_1 = 0.3842058806066518 - q[6];
  const Scalar c_link7 = cos(t_link7_1);
  const Scalar s_link7 = sin(t_link7_1);
  const Scalar t_link7_2 = 0.00113526676062776 * c_link7 - 0.0013450149983408877 * s_link7;
  // link6
  const Scalar t_link6_13 = t_link6_9 - 0.0056786982094425 * a_link6_x;
  const Scalar t_link6_14 = 2.0 * omega_link6_z;
  const Scalar Omega_link6_zy = Omega_link6_yz + omega_link6_y * t_link6_14;
  // link7
  const Scalar omega_link7_z = omega_link6_y - qd[6];
  const Scalar Omega_link7_zy = Omega_link6_zy - t_link6_14 * omega_link7_z;
  const Scalar t_link7_3 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_4 = 0.0005571816285452074 - c_link7 * t_link7_3;
  const Scalar t_link6_15 = t_link6_13 + Omega_link6_xz_2 * t_link7_2;
  const Scalar Omega_link7_zx = Omega_link6_xy - omega_link6_x * omega_link7_z * 2.0;
  const Scalar t_link7_5 = s_link7 * t_link7_3;
  const Scalar t_link7_6 = 0.0013098798160415795 - t_link7_5;
  const Scalar t_link6_16 = t_link6_15 - Omega_link7_zy * t_link7_4;
  const Scalar t_link7_7 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_8 = t_link6_5 - t_link7_7;
  const Scalar t_link7_9 = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  const Scalar a_link6_y = c_joint6 * t_link6_11 + s_joint6 * t_link6_10;
  const Scalar a_link7_z = a_link6_y - 1.0666666666666667 * Omega_link6_yx;
  const Scalar t_link7_10 = 0.0006883615516358103 * c_link7;
  const Scalar t_link6_17 = t_link6_16 + Omega_link7_zx * t_link7_6 - t_link7_8 * t_link7_9;
  const Scalar t_link7_11 = 0.0006883615516358103 * s_link7;
  const Scalar t_link7_12 = 0.012759209153753906 * a_link7_z - Omega_link7_zy * t_link7_11;
  const Scalar F_link7_z = t_link7_12 - Omega_link7_zx * t_link7_10;
  const Scalar M_link6_z = t_link6_17 - a_link7_z * t_link7_10 - 1.0666666666666667 * F_link7_z;
  B[5] = -M_link6_z;
  // link5
  const Scalar t_link5_7 = M_link6_z - 0.02389827041510187 * Omega_link5_xy;
  const Scalar Omega_link5_zx = t_link5_1 - alpha_link5_y;
  const Scalar t_link5_8 = t_link5_7 + 0.00151524447332703 * Omega_link5_zy;
  const Scalar t_link5_9 = t_link5_3 - t_link5_4;
  const Scalar t_link5_10 = t_link5_8 - 0.001451156065026714 * Omega_link5_zx;
  const Scalar t_link5_11 = t_link5_10 + 0.001026787777028894 * t_link5_9;
  const Scalar F_link6_y = F_link7_z + 0.0056786982094425 * Omega_link6_yy;
  const Scalar a_link7_x = a_link6_x - 1.0666666666666667 * Omega_link6_xx;
  const Scalar t_link6_18 = 0.0056786982094425 * Omega_link6_xy - 0.012759209153753906 * a_link7_x;
  const Scalar Omega_link7_xx = Omega_link6_yy - t_link7_8;
  // link6
  const Scalar t_link6_19 = t_link6_18 - Omega_link6_xz_2 * t_link7_11;
  const Scalar F_link6_x = t_link6_19 + Omega_link7_xx * t_link7_10;
  const Scalar t_link6_20 = s_joint6 * F_link6_y + c_joint6 * F_link6_x;
  // link5
  const Scalar t_link5_12 = t_link5_11 + 0.001208932934385 * a_link5_z;
  const Scalar M_link5_y = t_link5_12 - 4.654545454545454 * t_link6_20;
  const Scalar t_link5_13 = 0.027672413504871093 * a_link5_z - 0.0055993270925625 * Omega_link5_zy;
  const Scalar t_link5_14 = t_link5_13 - 0.001208932934385 * Omega_link5_zx;
  const Scalar F_link5_z = t_link5_14 + c_joint6 * F_link6_y - s_joint6 * F_link6_x;
  // link4
  const Scalar t_link4_8 = F_link5_z + 0.0054157634981905 * Omega_link4_yx;
  const Scalar t_link4_9 = t_link4_8 + 0.0039053550262761 * Omega_link4_yz;
  const Scalar t_link4_10 = t_link4_9 + 0.00164448757736927 * Omega_link4_xz;
  const Scalar t_link4_11 = 0.07937575371526084 * (Omega_link4_xx - Omega_link4_yy);
  const Scalar t_link4_12 = t_link4_10 + 0.3087998849151318 * Omega_link4_xy + t_link4_11;
  const Scalar t_link4_13 = t_link4_12 - 0.0825680742020475 * a_link4_x + c_joint5 * M_link5_y;
  const Scalar Omega_link6_zx = t_link6_12 + alpha_link6_y;
  // link7
  const Scalar t_link7_13 = Omega_link6_zx * t_link7_6 - Omega_link6_zy * t_link7_9;
  const Scalar t_link7_14 = 0.0035997721513193665 + t_link7_5;
  const Scalar t_link7_15 = t_link7_13 - Omega_link6_xy * t_link7_2;
  const Scalar Omega_link7_yy = t_link6_5 + t_link7_7;
  const Scalar t_link7_16 = t_link7_4 * (Omega_link7_xx - Omega_link7_yy);
  const Scalar t_link7_17 = t_link7_15 - Omega_link6_xz_2 * t_link7_14 - t_link7_16;
  const Scalar a_link5_y = c_joint5 * t_link5_5 - s_joint5 * t_link5_6;
  const Scalar a_link6_z = a_link5_y - 4.654545454545454 * Omega_link5_yz;
  const Scalar a_link7_y = a_link6_z - 1.0666666666666667 * Omega_link6_zx;
  const Scalar M_link7_z = t_link7_17 - a_link7_x * t_link7_11 - a_link7_y * t_link7_10;
  B[6] = -M_link7_z;
  // link6
  const Scalar t_link6_21 = M_link7_z - 9.3569097314605e-05 * Omega_link6_xy;
  const Scalar t_link6_22 = t_link6_21 - 0.005511034382675315 * Omega_link6_zy;
  const Scalar t_link6_23 = t_link6_22 + 0.001119670733427555 * Omega_link6_zx;
  const Scalar t_link7_18 = 0.012759209153753906 * a_link7_y + Omega_link7_yy * t_link7_11;
  const Scalar F_link7_y = t_link7_18 - Omega_link6_zx * t_link7_10;
  const Scalar t_link6_24 = t_link6_23 - 0.000103758917218685 * t_link6_7;
  const Scalar M_link6_y = t_link6_24 - 1.0666666666666667 * F_link7_y;
  const Scalar F_link6_z = F_link7_y + 0.0056786982094425 * Omega_link6_zy;
  // link5
  const Scalar t_link5_15 = 0.010045187828321245 * Omega_link5_zy;
  const Scalar Omega_link5_yx = alpha_link4_y + t_link5_2;
  const Scalar t_link5_16 = t_link5_15 - 0.00151524447332703 * Omega_link5_zx;
  const Scalar t_link5_17 = 0.02389827041510187 * (Omega_link4_yy - Omega_link5_yy);
  const Scalar t_link5_18 = t_link5_16 - 0.001026787777028894 * Omega_link5_yx + t_link5_17;
  const Scalar t_link5_19 = t_link5_18 - 0.0055993270925625 * a_link5_z;
  // link6
  const Scalar t_link6_25 = 0.013508337745659894 * Omega_link6_zy;
  const Scalar t_link6_26 = 9.3569097314605e-05 * (Omega_link5_yy - Omega_link6_yy);
  const Scalar t_link6_27 = t_link6_25 - 0.000103758917218685 * Omega_link6_yx - t_link6_26;
  const Scalar t_link6_28 = t_link6_27 + 0.0056786982094425 * a_link6_z;
  const Scalar t_link6_29 = t_link6_28 + Omega_link7_zy * t_link7_14;
  const Scalar t_link7_19 = t_link7_2 * (Omega_link6_yy - Omega_link7_yy);
  const Scalar t_link6_30 = t_link6_29 - Omega_link7_zx * t_link7_4 + t_link7_19;
  const Scalar t_link6_31 = Omega_link6_zx * (0.005511034382675315 + t_link7_9);
  const Scalar M_link6_x = t_link6_30 - a_link7_z * t_link7_11 - t_link6_31;
  const Scalar t_link5_20 = t_link5_19 - 4.654545454545454 * F_link6_z + s_joint6 * M_link6_y;
  const Scalar M_link5_x = t_link5_20 + c_joint6 * M_link6_x;
  const Scalar M_link4_z = t_link4_13 - s_joint5 * M_link5_x;
  B[3] = -M_link4_z;
  // link3
  const Scalar t_link3_9 = M_link4_z + 0.013297019103287584 * Omega_link3_xy;
  const Scalar t_link3_10 = t_link3_9 + 0.000121912420950744 * Omega_link3_zy;
  const Scalar t_link3_11 = 0.06681619663671426 * (Omega_link3_xx - Omega_link3_zz);
  const Scalar F_link4_y = F_link5_z - 0.0825680742020475 * Omega_link4_yy;
  const Scalar t_link3_12 = t_link3_10 + 0.015998048367902695 * Omega_link3_zx - t_link3_11;
  // link5
  const Scalar t_link5_21 = t_link6_20 + 0.027672413504871093 * a_link5_x;
  const Scalar Omega_link5_xx = Omega_link4_yy + t_link5_9;
  const Scalar t_link5_22 = t_link5_21 + 0.0055993270925625 * Omega_link5_xy;
  const Scalar F_link5_x = t_link5_22 - 0.001208932934385 * Omega_link5_xx;
  const Scalar t_link5_23 = F_link6_z + 0.027672413504871093 * a_link5_y;
  const Scalar t_link5_24 = t_link5_23 + 0.0055993270925625 * Omega_link5_yy;
  const Scalar F_link5_y = t_link5_24 + 0.001208932934385 * Omega_link5_yx;
  // link4
  const Scalar t_link4_14 = 0.0825680742020475 * Omega_link4_xy + s_joint5 * F_link5_y;
  const Scalar F_link4_x = t_link4_14 - c_joint5 * F_link5_x;
  const Scalar t_link4_15 = 3.83030303030303 * (s_joint4 * F_link4_y - c_joint4 * F_link4_x);
  const Scalar M_link3_y = t_link3_12 - c_joint4 * F_link4_y - s_joint4 * F_link4_x - t_link4_15;
  const Scalar t_link3_13 = s_joint3 * M_link3_y;
  const Scalar t_link4_16 = 0.07937575371526084 * Omega_link4_zx;
  const Scalar t_link4_17 = 0.3087998849151318 * Omega_link4_zy - t_link4_16;
  const Scalar t_link4_18 = 0.00164448757736927 * (Omega_link3_yy - Omega_link4_yy);
  const Scalar t_link4_19 = t_link4_17 + 0.0039053550262761 * Omega_link4_yx + t_link4_18;
  const Scalar t_link4_20 = t_link4_19 - 0.0825680742020475 * a_link4_z + s_joint5 * M_link5_y;
  const Scalar M_link4_x = t_link4_20 + c_joint5 * M_link5_x;
  const Scalar t_link4_21 = c_joint4 * M_link4_x;
  // link5
  const Scalar t_link5_25 = 0.001451156065026714 * Omega_link5_yx;
  const Scalar t_link5_26 = t_link5_25 - 0.001026787777028894 * Omega_link5_yz;
  const Scalar t_link5_27 = t_link5_26 - 0.02389827041510187 * Omega_link5_xz;
  const Scalar t_link5_28 = 0.00151524447332703 * (Omega_link5_xx - Omega_link5_yy);
  const Scalar t_link5_29 = t_link5_27 + 0.010045187828321245 * Omega_link5_xy + t_link5_28;
  const Scalar t_link5_30 = t_link5_29 + 0.0055993270925625 * a_link5_x;
  const Scalar t_link5_31 = t_link5_30 + 0.001208932934385 * a_link5_y + c_joint6 * M_link6_y;
  const Scalar M_link5_z = t_link5_31 - s_joint6 * M_link6_x;
  B[4] = M_link5_z;
  const Scalar t_link5_32 = c_joint5 * F_link5_y + s_joint5 * F_link5_x;
  // link4
  const Scalar t_link4_22 = M_link5_z + t_link5_32 + 0.00164448757736927 * Omega_link4_xy;
  const Scalar t_link4_23 = t_link4_22 - 0.07937575371526084 * Omega_link4_zy;
  const Scalar t_link4_24 = t_link4_23 + 0.0054157634981905 * Omega_link4_zx;
  const Scalar M_link4_y = t_link4_24 + 0.0039053550262761 * t_link4_7;
  const Scalar F_link4_z = t_link5_32 - 0.0825680742020475 * Omega_link4_zy;
  // link3
  const Scalar t_link3_14 = 0.022178148964878235 * Omega_link3_zy;
  const Scalar t_link3_15 = t_link3_14 + 0.000121912420950744 * Omega_link3_zx;
  const Scalar t_link3_16 = 0.013297019103287584 * (Omega_link3_yy - Omega_link3_zz);
  const Scalar t_link3_17 = t_link3_15 - 0.06681619663671426 * Omega_link3_yx - t_link3_16;
  const Scalar t_link3_18 = t_link3_17 - 3.83030303030303 * F_link4_z + s_joint4 * M_link4_y;
  const Scalar M_link3_x = t_link3_18 + t_link4_21;
  const Scalar t_link3_19 = s_joint2 * (t_link3_13 + c_joint3 * M_link3_x);
  const Scalar t_link3_20 = F_link4_z + 0.015998048367902695 * Omega_link3_yx;
  const Scalar t_link3_21 = t_link3_20 - 0.06681619663671426 * Omega_link3_yz;
  const Scalar t_link3_22 = t_link3_21 + 0.013297019103287584 * Omega_link3_xz;
  const Scalar t_link3_23 = 0.000121912420950744 * (Omega_link3_xx - Omega_link3_yy);
  const Scalar t_link3_24 = t_link3_22 + 0.022178148964878235 * Omega_link3_xy - t_link3_23;
  const Scalar M_link3_z = t_link3_24 - c_joint4 * M_link4_y + s_joint4 * M_link4_x;
  B[2] = -M_link3_z;
  // link2
  const Scalar t_link2_1 = 0.00796671776787104 * c_joint2 - 0.34001233503451994 * s_joint2;
  const Scalar t_link2_2 = 0.00398335888393552 - c_joint2 * t_link2_1;
  const Scalar Omega_link2_yy = qd[1] * qd[1];
  const Scalar t_link2_3 = 0.0007689361029464 * s_joint2 - 0.01026110182100817 * c_joint2;
  const Scalar t_link2_4 = alpha_link2_x * t_link2_2 * 2.0 + t_link2_3 * Omega_link2_yy;
  B[0] = t_link2_4 - c_joint2 * M_link3_z + t_link3_19;
  const Scalar Omega_link1_xx = qd[0] * qd[0];
  B[1] = -(t_link2_2 * Omega_link1_xx - c_joint3 * M_link3_y + s_joint3 * M_link3_x);
}

void gravity_force(const Scalar q[7], Scalar G[7]) noexcept {
  const Scalar c_joint2 = cos(q[1]);
  const Scalar s_joint2 = sin(q[1]);
  const Scalar c_joint3 = cos(q[2]);
  const Scalar s_joint3 = sin(q[2]);
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar c_joint6 = cos(q[5]);
  const Scalar s_joint6 = sin(q[5]);
  const Scalar a_link2_x = 9.81 * s_joint2;
  const Scalar a_link2_y = 9.81 * c_joint2;
  const Scalar a_link3_x = c_joint3 * a_link2_x;
  const Scalar a_link3_y = s_joint3 * a_link2_x;
  const Scalar a_link4_x = s_joint4 * a_link2_y - c_joint4 * a_link3_x;
  const Scalar a_link4_y = c_joint4 * a_link2_y + s_joint4 * a_link3_x;
  const Scalar a_link5_x = s_joint5 * a_link3_y + c_joint5 * a_link4_x;
  const Scalar a_link5_y = c_joint5 * a_link3_y - s_joint5 * a_link4_x;
  const Scalar a_link6_x = s_joint6 * a_link4_y + c_joint6 * a_link5_x;
  const Scalar a_link6_y = c_joint6 * a_link4_y - s_joint6 * a_link5_x;
  // link7
  const Scalar t_link7_1 = 0.3842058806066518 - q[6];
  const Scalar c_link7 = cos(t_link7_1);
  const Scalar s_link7 = sin(t_link7_1);
  const Scalar t_link7_2 = 0.008343776383464369 * c_link7;
  const Scalar t_link7_3 = 0.008343776383464369 * s_link7;
  const Scalar M_link7_z = a_link6_x * t_link7_3 - a_link5_y * t_link7_2;
  G[6] = M_link7_z;
  // link6
  const Scalar M_link6_x = 0.068832705569 * a_link5_y + a_link6_y * t_link7_3;
  const Scalar M_link6_y = M_link7_z - 0.164967552695 * a_link5_y;
  const Scalar M_link6_z = 0.068832705569 * a_link6_x + a_link6_y * (0.164967552695 + t_link7_2);
  G[5] = M_link6_z;
  // link5
  const Scalar M_link5_x = 0.067870631425 * a_link4_y + s_joint6 * M_link6_y + c_joint6 * M_link6_x;
  const Scalar M_link5_y = M_link6_z - 0.014653732538 * a_link4_y;
  const Scalar t_link5_1 = 0.067870631425 * a_link5_x + 0.014653732538 * a_link5_y;
  const Scalar M_link5_z = t_link5_1 + c_joint6 * M_link6_y - s_joint6 * M_link6_x;
  G[4] = -M_link5_z;
  // link4
  const Scalar M_link4_x = 1.720683553603 * a_link3_y - s_joint5 * M_link5_y - c_joint5 * M_link5_x;
  const Scalar M_link4_y = M_link5_z + 0.49008027465 * a_link3_y;
  const Scalar t_link4_1 = 1.720683553603 * a_link4_x + 0.49008027465 * a_link4_y;
  const Scalar M_link4_z = t_link4_1 - c_joint5 * M_link5_y + s_joint5 * M_link5_x;
  G[3] = -M_link4_z;
  // link3
  const Scalar t_link3_1 = 0.27690780075318 * c_joint2 + s_joint4 * M_link4_y;
  const Scalar M_link3_x = t_link3_1 - c_joint4 * M_link4_x;
  const Scalar M_link3_y = M_link4_z - 6.71158958634432 * c_joint2;
  const Scalar t_link3_2 = 0.028227094878 * a_link3_x + 0.684157959872 * a_link3_y;
  const Scalar M_link3_z = t_link3_2 - c_joint4 * M_link4_y - s_joint4 * M_link4_x;
  G[2] = M_link3_z;
  // link2
  const Scalar M_link2_x = s_joint3 * M_link3_y - c_joint3 * M_link3_x;
  const Scalar t_link2_1 = 30.45357582685272 * s_joint2 - 0.01993386669246 * c_joint2;
  G[1] = s_joint3 * M_link3_x - (t_link2_1 - c_joint3 * M_link3_y);
  G[0] = c_joint2 * M_link3_z + s_joint2 * M_link2_x;
}

void inverse_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar qdd[7],
                      Scalar tau[7]) noexcept {
  // link2
  const Scalar s_joint2 = sin(q[1]);
  const Scalar c_joint2 = cos(q[1]);
  const Scalar Omega_link2_yz = s_joint2 * qdd[0];
  const Scalar omega_link2_y = c_joint2 * qd[0];
  const Scalar Omega_link2_zy = Omega_link2_yz + omega_link2_y * qd[1] * 2.0;
  const Scalar c_joint3 = cos(q[2]);
  const Scalar s_joint3 = sin(q[2]);
  const Scalar omega_link2_x = s_joint2 * qd[0];
  const Scalar t_link2_1 = omega_link2_x * omega_link2_y;
  const Scalar Omega_link2_xy = qdd[1] - t_link2_1;
  // link3
  const Scalar Omega_link3_yz = c_joint3 * Omega_link2_zy - s_joint3 * Omega_link2_xy;
  const Scalar omega_link3_y = c_joint3 * qd[1] + s_joint3 * omega_link2_x;
  const Scalar omega_link3_z = omega_link2_y + qd[2];
  const Scalar Omega_link3_zy = Omega_link3_yz - omega_link3_y * omega_link3_z * 2.0;
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  const Scalar omega_link3_x = s_joint3 * qd[1] - c_joint3 * omega_link2_x;
  const Scalar t_link3_1 = omega_link3_x * omega_link3_y;
  // link2
  const Scalar Omega_link2_xz = c_joint2 * qdd[0];
  const Scalar t_link2_2 = omega_link2_x * qd[1];
  const Scalar alpha_link2_y = Omega_link2_xz - t_link2_2;
  const Scalar alpha_link3_z = alpha_link2_y + qdd[2];
  const Scalar Omega_link3_xy = alpha_link3_z - t_link3_1;
  // link4
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy - s_joint4 * Omega_link3_xy;
  const Scalar omega_link4_y = c_joint4 * omega_link3_z - s_joint4 * omega_link3_x;
  const Scalar omega_link4_z = omega_link3_y - qd[3];
  const Scalar Omega_link4_zy = Omega_link4_yz + omega_link4_y * omega_link4_z * 2.0;
  const Scalar s_joint5 = sin(q[4]);
  const Scalar c_joint5 = cos(q[4]);
  const Scalar omega_link4_x = s_joint4 * omega_link3_z + c_joint4 * omega_link3_x;
  const Scalar t_link4_1 = omega_link4_x * omega_link4_y;
  // link3
  const Scalar Omega_link3_xz = s_joint3 * Omega_link2_zy + c_joint3 * Omega_link2_xy;
  const Scalar t_link3_2 = omega_link3_x * omega_link3_z;
  const Scalar alpha_link3_y = Omega_link3_xz - t_link3_2;
  const Scalar alpha_link4_z = alpha_link3_y - qdd[3];
  const Scalar Omega_link4_xy = alpha_link4_z + t_link4_1;
  // link5
  const Scalar Omega_link5_xz = s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar omega_link5_x = s_joint5 * omega_link4_z + c_joint5 * omega_link4_x;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar t_link5_1 = omega_link5_x * omega_link5_z;
  const Scalar alpha_link5_y = Omega_link5_xz - t_link5_1;
  // link6
  const Scalar alpha_link6_z = alpha_link5_y - qdd[5];
  const Scalar s_joint6 = sin(q[5]);
  const Scalar c_joint6 = cos(q[5]);
  const Scalar omega_link6_x = s_joint6 * omega_link5_z + c_joint6 * omega_link5_x;
  const Scalar omega_link6_y = c_joint6 * omega_link5_z - s_joint6 * omega_link5_x;
  const Scalar t_link6_1 = omega_link6_x * omega_link6_y;
  const Scalar Omega_link6_yx = alpha_link6_z - t_link6_1;
  // link5
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar omega_link5_y = c_joint5 * omega_link4_z - s_joint5 * omega_link4_x;
  const Scalar Omega_link5_zy = Omega_link5_yz - omega_link5_y * omega_link5_z * 2.0;
  // link4
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy + c_joint4 * Omega_link3_xy;
  const Scalar t_link4_2 = omega_link4_x * omega_link4_z;
  const Scalar alpha_link4_y = Omega_link4_xz + t_link4_2;
  // link5
  const Scalar alpha_link5_z = alpha_link4_y + qdd[4];
  const Scalar t_link5_2 = omega_link5_x * omega_link5_y;
  const Scalar Omega_link5_xy = alpha_link5_z - t_link5_2;
  // link6
  const Scalar Omega_link6_yz = c_joint6 * Omega_link5_zy - s_joint6 * Omega_link5_xy;
  const Scalar t_link6_2 = 0.001119670733427555 * Omega_link6_yx;
  const Scalar Omega_link6_xz = s_joint6 * Omega_link5_zy + c_joint6 * Omega_link5_xy;
  const Scalar t_link6_3 = t_link6_2 - 0.000103758917218685 * Omega_link6_yz;
  const Scalar Omega_link6_xy = alpha_link6_z + t_link6_1;
  const Scalar t_link6_4 = t_link6_3 - 9.3569097314605e-05 * Omega_link6_xz;
  // link5
  const Scalar t_link5_3 = omega_link5_z * omega_link5_z;
  const Scalar t_link5_4 = omega_link5_x * omega_link5_x;
  const Scalar Omega_link5_yy = t_link5_3 + t_link5_4;
  // link6
  const Scalar t_link6_5 = omega_link6_x * omega_link6_x;
  const Scalar omega_link6_z = omega_link5_y - qd[5];
  const Scalar t_link6_6 = omega_link6_z * omega_link6_z;
  const Scalar t_link6_7 = t_link6_6 - t_link6_5;
  const Scalar Omega_link6_xx = Omega_link5_yy + t_link6_7;
  const Scalar Omega_link6_yy = t_link6_6 + t_link6_5;
  const Scalar t_link6_8 = 0.005511034382675315 * (Omega_link6_xx - Omega_link6_yy);
  const Scalar t_link6_9 = t_link6_4 + 0.013508337745659894 * Omega_link6_xy;
  const Scalar t_link6_10 = t_link6_9 + t_link6_8;
  const Scalar Omega_link3_yx = alpha_link3_z + t_link3_1;
  const Scalar a_link2_x = 118.9090909090909 * s_joint2;
  const Scalar a_link3_y = s_joint3 * a_link2_x;
  const Scalar a_link4_z = a_link3_y + Omega_link3_yx + 3.83030303030303 * Omega_link3_yz;
  const Scalar Omega_link4_zx = t_link4_2 + alpha_link4_y;
  const Scalar t_link5_5 = a_link4_z - Omega_link4_zx;
  const Scalar t_link5_6 = s_joint5 * t_link5_5;
  // link3
  const Scalar t_link3_3 = omega_link3_x * omega_link3_x;
  const Scalar t_link3_4 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_5 = t_link3_4 - t_link3_3;
  // link2
  const Scalar t_link2_3 = omega_link2_x * omega_link2_x;
  const Scalar t_link2_4 = qd[1] * qd[1];
  const Scalar Omega_link2_yy = t_link2_4 + t_link2_3;
  const Scalar Omega_link3_xx = Omega_link2_yy + t_link3_5;
  const Scalar a_link3_x = c_joint3 * a_link2_x;
  const Scalar t_link4_3 = a_link3_x + Omega_link3_xx - 3.83030303030303 * Omega_link3_xz;
  const Scalar Omega_link3_zx = t_link3_2 - alpha_link3_y;
  // link4
  const Scalar t_link4_4 = Omega_link3_zx + 118.9090909090909 * c_joint2;
  const Scalar t_link4_5 = t_link4_4 - 3.83030303030303 * Omega_link2_yy;
  const Scalar a_link4_x = s_joint4 * t_link4_5 - c_joint4 * t_link4_3;
  const Scalar t_link4_6 = omega_link4_x * omega_link4_x;
  const Scalar t_link4_7 = omega_link4_z * omega_link4_z;
  const Scalar t_link4_8 = t_link4_7 - t_link4_6;
  const Scalar Omega_link3_yy = t_link3_4 + t_link3_3;
  const Scalar Omega_link4_xx = Omega_link3_yy + t_link4_8;
  const Scalar t_link5_7 = a_link4_x + Omega_link4_xx;
  const Scalar a_link5_x = t_link5_6 + c_joint5 * t_link5_7;
  const Scalar t_link6_11 = a_link5_x + 4.654545454545454 * Omega_link5_xz;
  const Scalar Omega_link4_yx = alpha_link4_z - t_link4_1;
  const Scalar t_link5_8 = Omega_link4_yx + c_joint4 * t_link4_5;
  const Scalar a_link5_z = t_link5_8 + s_joint4 * t_link4_3;
  const Scalar Omega_link4_yy = t_link4_7 + t_link4_6;
  // link6
  const Scalar t_link6_12 = a_link5_z - 4.654545454545454 * Omega_link4_yy;
  const Scalar a_link6_x = s_joint6 * t_link6_12 + c_joint6 * t_link6_11;
  const Scalar t_link6_13 = omega_link6_x * omega_link6_z;
  const Scalar alpha_link6_y = Omega_link6_xz + t_link6_13;
  // link7
  const Scalar alpha_link7_z = alpha_link6_y - qdd[6];
  const Scalar Omega_link7_xy = t_link6_13 - alpha_link7_z;
  const Scalar t_link7_1 = 0.3842058806066518 - q[6];
  const Scalar c_link7 = cos(t_link7_1);
  const Scalar s_link7 = sin(t_link7_1);
  const Scalar t_link7_2 = 0.00113526676062776 * c_link7 - 0.0013450149983408877 * s_link7;
  // link6
  const Scalar t_link6_14 = t_link6_10 - 0.0056786982094425 * a_link6_x;
  const Scalar t_link6_15 = 2.0 * omega_link6_z;
  const Scalar Omega_link6_zy = Omega_link6_yz + omega_link6_y * t_link6_15;
  // link7
  const Scalar omega_link7_z = omega_link6_y - qd[6];
  const Scalar Omega_link7_zy = Omega_link6_zy - t_link6_15 * omega_link7_z;
  const Scalar t_link7_3 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_4 = 0.0005571816285452074 - c_link7 * t_link7_3;
  const Scalar t_link6_16 = t_link6_14 + Omega_link7_xy * t_link7_2;
  const Scalar Omega_link7_zx = Omega_link6_xy - omega_link6_x * omega_link7_z * 2.0;
  const Scalar t_link7_5 = s_link7 * t_link7_3;
  const Scalar t_link7_6 = 0.0013098798160415795 - t_link7_5;
  const Scalar t_link6_17 = t_link6_16 - Omega_link7_zy * t_link7_4;
  const Scalar t_link7_7 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_8 = t_link6_5 - t_link7_7;
  const Scalar t_link7_9 = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  const Scalar t_link6_18 = t_link6_17 + Omega_link7_zx * t_link7_6;
  const Scalar a_link6_y = c_joint6 * t_link6_12 - s_joint6 * t_link6_11;
  const Scalar a_link7_z = a_link6_y - 1.0666666666666667 * Omega_link6_yx;
  const Scalar t_link7_10 = 0.0006883615516358103 * c_link7;
  const Scalar t_link6_19 = t_link6_18 - t_link7_8 * t_link7_9;
  const Scalar t_link7_11 = 0.0006883615516358103 * s_link7;
  const Scalar t_link7_12 = 0.012759209153753906 * a_link7_z - Omega_link7_zy * t_link7_11;
  const Scalar F_link7_z = t_link7_12 - Omega_link7_zx * t_link7_10;
  const Scalar t_link6_20 = t_link6_19 - a_link7_z * t_link7_10;
  const Scalar M_link6_z = t_link6_20 - 1.0666666666666667 * F_link7_z;
  tau[5] = -M_link6_z;
  // link5
  const Scalar t_link5_9 = M_link6_z - 0.02389827041510187 * Omega_link5_xy;
  const Scalar Omega_link5_zx = t_link5_1 - alpha_link5_y;
  const Scalar t_link5_10 = t_link5_9 + 0.00151524447332703 * Omega_link5_zy;
  const Scalar t_link5_11 = t_link5_3 - t_link5_4;
  const Scalar t_link5_12 = t_link5_10 - 0.001451156065026714 * Omega_link5_zx;
  const Scalar t_link5_13 = t_link5_12 + 0.001026787777028894 * t_link5_11;
  const Scalar F_link6_y = F_link7_z + 0.0056786982094425 * Omega_link6_yy;
  const Scalar a_link7_x = a_link6_x - 1.0666666666666667 * Omega_link6_xx;
  const Scalar t_link6_21 = 0.0056786982094425 * Omega_link6_xy;
  const Scalar t_link6_22 = t_link6_21 - 0.012759209153753906 * a_link7_x;
  const Scalar Omega_link7_xx = Omega_link6_yy - t_link7_8;
  // link6
  const Scalar t_link6_23 = t_link6_22 - Omega_link7_xy * t_link7_11;
  const Scalar F_link6_x = t_link6_23 + Omega_link7_xx * t_link7_10;
  const Scalar t_link6_24 = s_joint6 * F_link6_y + c_joint6 * F_link6_x;
  // link5
  const Scalar t_link5_14 = t_link5_13 + 0.001208932934385 * a_link5_z;
  const Scalar M_link5_y = t_link5_14 - 4.654545454545454 * t_link6_24;
  const Scalar t_link5_15 = 0.0055993270925625 * Omega_link5_zy;
  const Scalar t_link5_16 = 0.027672413504871093 * a_link5_z - t_link5_15;
  const Scalar t_link5_17 = t_link5_16 - 0.001208932934385 * Omega_link5_zx;
  const Scalar F_link5_z = t_link5_17 + c_joint6 * F_link6_y - s_joint6 * F_link6_x;
  // link4
  const Scalar t_link4_9 = F_link5_z + 0.0054157634981905 * Omega_link4_yx;
  const Scalar t_link4_10 = t_link4_9 + 0.0039053550262761 * Omega_link4_yz;
  const Scalar t_link4_11 = t_link4_10 + 0.00164448757736927 * Omega_link4_xz;
  const Scalar t_link4_12 = 0.07937575371526084 * (Omega_link4_xx - Omega_link4_yy);
  const Scalar t_link4_13 = t_link4_11 + 0.3087998849151318 * Omega_link4_xy + t_link4_12;
  const Scalar t_link4_14 = t_link4_13 + 0.0825680742020475 * a_link4_x;
  const Scalar t_link4_15 = t_link4_14 + c_joint5 * M_link5_y;
  // link7
  const Scalar Omega_link7_yx = t_link6_13 + alpha_link7_z;
  const Scalar t_link7_13 = Omega_link7_yx * t_link7_6 - Omega_link6_zy * t_link7_9;
  const Scalar t_link7_14 = 0.0035997721513193665 + t_link7_5;
  const Scalar t_link7_15 = t_link7_13 - Omega_link6_xy * t_link7_2;
  const Scalar Omega_link7_yy = t_link6_5 + t_link7_7;
  const Scalar t_link7_16 = t_link7_4 * (Omega_link7_xx - Omega_link7_yy);
  const Scalar t_link7_17 = t_link7_15 - Omega_link7_xy * t_link7_14 - t_link7_16;
  const Scalar a_link5_y = c_joint5 * t_link5_5 - s_joint5 * t_link5_7;
  const Scalar a_link6_z = a_link5_y + 4.654545454545454 * Omega_link5_yz;
  const Scalar Omega_link6_zx = t_link6_13 + alpha_link6_y;
  const Scalar a_link7_y = a_link6_z + 1.0666666666666667 * Omega_link6_zx;
  const Scalar t_link7_18 = t_link7_17 - a_link7_x * t_link7_11;
  const Scalar M_link7_z = t_link7_18 + a_link7_y * t_link7_10;
  tau[6] = -M_link7_z;
  // link6
  const Scalar t_link6_25 = M_link7_z - 9.3569097314605e-05 * Omega_link6_xy;
  const Scalar t_link6_26 = t_link6_25 - 0.005511034382675315 * Omega_link6_zy;
  const Scalar t_link6_27 = t_link6_26 + 0.001119670733427555 * Omega_link6_zx;
  const Scalar t_link7_19 = 0.012759209153753906 * a_link7_y - Omega_link7_yy * t_link7_11;
  const Scalar F_link7_y = t_link7_19 + Omega_link7_yx * t_link7_10;
  const Scalar t_link6_28 = t_link6_27 - 0.000103758917218685 * t_link6_7;
  const Scalar M_link6_y = t_link6_28 + 1.0666666666666667 * F_link7_y;
  const Scalar F_link6_z = F_link7_y - 0.0056786982094425 * Omega_link6_zy;
  // link5
  const Scalar t_link5_18 = 0.010045187828321245 * Omega_link5_zy;
  const Scalar Omega_link5_yx = alpha_link5_z + t_link5_2;
  const Scalar t_link5_19 = t_link5_18 - 0.00151524447332703 * Omega_link5_zx;
  const Scalar t_link5_20 = 0.02389827041510187 * (Omega_link4_yy - Omega_link5_yy);
  const Scalar t_link5_21 = t_link5_19 - 0.001026787777028894 * Omega_link5_yx;
  const Scalar t_link5_22 = t_link5_21 + t_link5_20 - 0.0055993270925625 * a_link5_z;
  const Scalar t_link5_23 = t_link5_22 + 4.654545454545454 * F_link6_z;
  // link6
  const Scalar t_link6_29 = 0.013508337745659894 * Omega_link6_zy;
  const Scalar t_link6_30 = t_link6_29 - 0.005511034382675315 * Omega_link6_zx;
  const Scalar t_link6_31 = 9.3569097314605e-05 * (Omega_link5_yy - Omega_link6_yy);
  const Scalar t_link6_32 = t_link6_30 - 0.000103758917218685 * Omega_link6_yx;
  const Scalar t_link6_33 = t_link6_32 - t_link6_31 - 0.0056786982094425 * a_link6_z;
  const Scalar t_link6_34 = t_link6_33 + Omega_link7_zy * t_link7_14;
  const Scalar t_link6_35 = t_link6_34 - Omega_link7_zx * t_link7_4;
  const Scalar t_link7_20 = t_link7_2 * (Omega_link6_yy - Omega_link7_yy);
  const Scalar t_link6_36 = t_link6_35 - Omega_link7_yx * t_link7_9 + t_link7_20;
  const Scalar M_link6_x = t_link6_36 - a_link7_z * t_link7_11;
  const Scalar M_link5_x = t_link5_23 + s_joint6 * M_link6_y + c_joint6 * M_link6_x;
  const Scalar M_link4_z = t_link4_15 - s_joint5 * M_link5_x;
  tau[3] = -M_link4_z;
  // link3
  const Scalar t_link3_6 = M_link4_z - 0.013297019103287584 * Omega_link3_xy;
  const Scalar t_link3_7 = t_link3_6 + 0.000121912420950744 * Omega_link3_zy;
  const Scalar t_link3_8 = t_link3_7 - 0.015998048367902695 * Omega_link3_zx;
  const Scalar t_link3_9 = t_link3_8 - 0.06681619663671426 * t_link3_5;
  const Scalar F_link4_y = F_link5_z - 0.0825680742020475 * Omega_link4_yy;
  const Scalar t_link3_10 = t_link3_9 - 1.90390209202782 * c_joint2;
  // link5
  const Scalar t_link5_24 = t_link6_24 - 0.027672413504871093 * a_link5_x;
  const Scalar Omega_link5_xx = Omega_link4_yy + t_link5_11;
  const Scalar t_link5_25 = t_link5_24 + 0.0055993270925625 * Omega_link5_xy;
  const Scalar F_link5_x = t_link5_25 - 0.001208932934385 * Omega_link5_xx;
  const Scalar t_link5_26 = F_link6_z + 0.027672413504871093 * a_link5_y;
  const Scalar t_link5_27 = t_link5_26 - 0.0055993270925625 * Omega_link5_yy;
  const Scalar F_link5_y = t_link5_27 - 0.001208932934385 * Omega_link5_yx;
  // link4
  const Scalar t_link4_16 = 0.0825680742020475 * Omega_link4_xy - s_joint5 * F_link5_y;
  const Scalar F_link4_x = t_link4_16 - c_joint5 * F_link5_x;
  const Scalar t_link4_17 = s_joint4 * F_link4_y - c_joint4 * F_link4_x;
  const Scalar t_link3_11 = t_link3_10 - c_joint4 * F_link4_y - s_joint4 * F_link4_x;
  const Scalar M_link3_y = t_link3_11 - 3.83030303030303 * t_link4_17;
  // link2
  const Scalar Omega_link2_zx = t_link2_2 - alpha_link2_y;
  const Scalar t_link2_5 = 0.00398335888393552 * Omega_link2_zx;
  const Scalar Omega_link2_yx = qdd[1] + t_link2_1;
  const Scalar t_link2_6 = 0.3630902175294517 * Omega_link2_zy + t_link2_5;
  const Scalar t_link2_7 = Omega_link2_yy - qd[0] * qd[0];
  const Scalar t_link2_8 = t_link2_6 - 0.01026110182100817 * Omega_link2_yx;
  const Scalar t_link2_9 = t_link2_8 + 0.0007689361029464 * t_link2_7;
  const Scalar t_link2_10 = t_link2_9 + s_joint3 * M_link3_y;
  // link4
  const Scalar t_link4_18 = 0.07937575371526084 * Omega_link4_zx;
  const Scalar t_link4_19 = 0.3087998849151318 * Omega_link4_zy - t_link4_18;
  const Scalar t_link4_20 = 0.00164448757736927 * (Omega_link3_yy - Omega_link4_yy);
  const Scalar t_link4_21 = t_link4_19 + 0.0039053550262761 * Omega_link4_yx + t_link4_20;
  const Scalar t_link4_22 = t_link4_21 + 0.0825680742020475 * a_link4_z;
  const Scalar M_link4_x = t_link4_22 + s_joint5 * M_link5_y + c_joint5 * M_link5_x;
  const Scalar t_link4_23 = c_joint4 * M_link4_x;
  // link5
  const Scalar t_link5_28 = 0.001451156065026714 * Omega_link5_yx;
  const Scalar t_link5_29 = t_link5_28 - 0.001026787777028894 * Omega_link5_yz;
  const Scalar t_link5_30 = t_link5_29 - 0.02389827041510187 * Omega_link5_xz;
  const Scalar t_link5_31 = 0.00151524447332703 * (Omega_link5_xx - Omega_link5_yy);
  const Scalar t_link5_32 = t_link5_30 + 0.010045187828321245 * Omega_link5_xy;
  const Scalar t_link5_33 = t_link5_32 + t_link5_31 - 0.0055993270925625 * a_link5_x;
  const Scalar t_link5_34 = t_link5_33 - 0.001208932934385 * a_link5_y;
  const Scalar M_link5_z = t_link5_34 + c_joint6 * M_link6_y - s_joint6 * M_link6_x;
  tau[4] = M_link5_z;
  const Scalar t_link5_35 = c_joint5 * F_link5_y - s_joint5 * F_link5_x;
  // link4
  const Scalar t_link4_24 = M_link5_z - t_link5_35 + 0.00164448757736927 * Omega_link4_xy;
  const Scalar t_link4_25 = t_link4_24 - 0.07937575371526084 * Omega_link4_zy;
  const Scalar t_link4_26 = t_link4_25 + 0.0054157634981905 * Omega_link4_zx;
  const Scalar M_link4_y = t_link4_26 + 0.0039053550262761 * t_link4_8;
  const Scalar F_link4_z = t_link5_35 + 0.0825680742020475 * Omega_link4_zy;
  // link3
  const Scalar t_link3_12 = 0.022178148964878235 * Omega_link3_zy;
  const Scalar t_link3_13 = t_link3_12 - 0.000121912420950744 * Omega_link3_zx;
  const Scalar t_link3_14 = 0.013297019103287584 * (Omega_link2_yy - Omega_link3_yy);
  const Scalar t_link3_15 = t_link3_13 + 0.06681619663671426 * Omega_link3_yx + t_link3_14;
  const Scalar t_link3_16 = t_link3_15 - 0.27690780075318 * c_joint2;
  const Scalar t_link3_17 = t_link3_16 + 3.83030303030303 * F_link4_z;
  const Scalar M_link3_x = t_link3_17 + s_joint4 * M_link4_y + t_link4_23;
  const Scalar M_link2_x = t_link2_10 + c_joint3 * M_link3_x;
  const Scalar t_link2_11 = s_joint2 * M_link2_x;
  const Scalar t_link3_18 = F_link4_z + 0.015998048367902695 * Omega_link3_yx;
  const Scalar t_link3_19 = t_link3_18 + 0.06681619663671426 * Omega_link3_yz;
  const Scalar t_link3_20 = t_link3_19 - 0.013297019103287584 * Omega_link3_xz;
  const Scalar t_link3_21 = 0.000121912420950744 * (Omega_link3_xx - Omega_link3_yy);
  const Scalar t_link3_22 = t_link3_20 + 0.022178148964878235 * Omega_link3_xy;
  const Scalar t_link3_23 = t_link3_22 + t_link3_21 + 0.002328735327435 * a_link3_x;
  const Scalar t_link3_24 = t_link3_23 + 0.016011409030815 * a_link3_y;
  const Scalar M_link3_z = t_link3_24 + c_joint4 * M_link4_y - s_joint4 * M_link4_x;
  tau[2] = M_link3_z;
  // link2
  const Scalar t_link2_12 = M_link3_z - 0.0007689361029464 * Omega_link2_xy;
  const Scalar t_link2_13 = t_link2_12 - 0.00398335888393552 * Omega_link2_zy;
  const Scalar t_link2_14 = t_link2_4 - t_link2_3;
  const Scalar t_link2_15 = t_link2_13 - 0.023077882494931805 * Omega_link2_zx;
  const Scalar M_link2_y = t_link2_15 - 0.01026110182100817 * t_link2_14;
  tau[0] = 0.014259565994474374 * qdd[0] + c_joint2 * M_link2_y + t_link2_11;
  const Scalar t_link2_16 = 0.023077882494931805 * Omega_link2_yx;
  const Scalar t_link2_17 = t_link2_16 - 0.01026110182100817 * Omega_link2_yz;
  const Scalar t_link2_18 = t_link2_17 - 0.0007689361029464 * Omega_link2_xz;
  const Scalar t_link2_19 = t_link2_18 + 0.3630902175294517 * Omega_link2_xy;
  const Scalar t_link2_20 = t_link2_19 + 0.00398335888393552 * (t_link2_14 - t_link2_7);
  const Scalar t_link2_21 = t_link2_20 - 12.038675848622248 * s_joint2;
  const Scalar t_link2_22 = t_link2_21 + 0.01993386669246 * c_joint2;
  tau[1] = t_link2_22 + c_joint3 * M_link3_y - s_joint3 * M_link3_x;
}

namespace {

struct ForwardDynamicsWorkspace {
  Scalar c_joint2;
  Scalar s_joint2;
  Scalar alpha_link2_x;
  Scalar c_joint3;
  Scalar s_joint3;
  Scalar c_joint4;
  Scalar s_joint4;
  Scalar s_joint5;
  Scalar c_joint5;
  Scalar s_joint6;
  Scalar c_joint6;
  Scalar c_link7;
  Scalar s_link7;
  Scalar I_link7_yz;
  Scalar t_link7_3;
  Scalar t_link7_4;
  Scalar I_link7_xz;
  Scalar h_link7_x;
  Scalar h_link7_y;
  Scalar M_link6_z;
  Scalar M_link7_z;
  Scalar I_link6_xy;
  Scalar M_link4_z;
  Scalar M_link3_y;
  Scalar M_link5_z;
  Scalar M_link3_x;
  Scalar t_link3_23;
  Scalar M_link3_z;
};

[[gnu::noinline]] void forward_dynamics_1(const Scalar q[7], const Scalar qd[7],
                                          ForwardDynamicsWorkspace& w) noexcept {
  const Scalar c_joint2 = cos(q[1]);
  w.c_joint2 = c_joint2;
  const Scalar s_joint2 = sin(q[1]);
  w.s_joint2 = s_joint2;
  const Scalar alpha_link2_x = qd[0] * qd[1];
  w.alpha_link2_x = alpha_link2_x;
  // link3
  const Scalar t_link3_1 = c_joint2 * alpha_link2_x;
  const Scalar c_joint3 = cos(q[2]);
  w.c_joint3 = c_joint3;
  const Scalar s_joint3 = sin(q[2]);
  w.s_joint3 = s_joint3;
  const Scalar t_link3_2 = s_joint2 * qd[0];
  const Scalar omega_link3_y = c_joint3 * qd[1] + s_joint3 * t_link3_2;
  const Scalar alpha_link3_x = c_joint3 * t_link3_1 - omega_link3_y * qd[2];
  const Scalar omega_link3_z = qd[2] + c_joint2 * qd[0];
  const Scalar t_link3_3 = omega_link3_y * omega_link3_z;
  const Scalar Omega_link3_zy = alpha_link3_x - t_link3_3;
  const Scalar c_joint4 = cos(q[3]);
  w.c_joint4 = c_joint4;
  const Scalar s_joint4 = sin(q[3]);
  w.s_joint4 = s_joint4;
  const Scalar omega_link3_x = s_joint3 * qd[1] - c_joint3 * t_link3_2;
  const Scalar t_link3_4 = omega_link3_x * omega_link3_y;
  const Scalar alpha_link3_z = s_joint2 * alpha_link2_x;
  const Scalar Omega_link3_xy = alpha_link3_z + t_link3_4;
  // link4
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy + s_joint4 * Omega_link3_xy;
  const Scalar omega_link4_y = c_joint4 * omega_link3_z - s_joint4 * omega_link3_x;
  const Scalar omega_link4_z = omega_link3_y - qd[3];
  const Scalar Omega_link4_zy = Omega_link4_yz + omega_link4_y * omega_link4_z * 2.0;
  const Scalar s_joint5 = sin(q[4]);
  w.s_joint5 = s_joint5;
  const Scalar c_joint5 = cos(q[4]);
  w.c_joint5 = c_joint5;
  const Scalar omega_link4_x = s_joint4 * omega_link3_z + c_joint4 * omega_link3_x;
  const Scalar t_link4_1 = omega_link4_x * omega_link4_y;
  const Scalar alpha_link3_y = s_joint3 * t_link3_1 - omega_link3_x * qd[2];
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_1;
  // link5
  const Scalar Omega_link5_xz = s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar omega_link5_x = s_joint5 * omega_link4_z + c_joint5 * omega_link4_x;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar t_link5_1 = omega_link5_x * omega_link5_z;
  const Scalar alpha_link5_y = Omega_link5_xz - t_link5_1;
  // link6
  const Scalar s_joint6 = sin(q[5]);
  w.s_joint6 = s_joint6;
  const Scalar c_joint6 = cos(q[5]);
  w.c_joint6 = c_joint6;
  const Scalar omega_link6_x = s_joint6 * omega_link5_z + c_joint6 * omega_link5_x;
  const Scalar omega_link6_y = c_joint6 * omega_link5_z - s_joint6 * omega_link5_x;
  const Scalar t_link6_1 = omega_link6_x * omega_link6_y;
  const Scalar Omega_link6_yx = alpha_link5_y - t_link6_1;
  // link5
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar omega_link5_y = c_joint5 * omega_link4_z - s_joint5 * omega_link4_x;
  const Scalar Omega_link5_zy = Omega_link5_yz - omega_link5_y * omega_link5_z * 2.0;
  // link4
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy - c_joint4 * Omega_link3_xy;
  const Scalar t_link4_2 = omega_link4_x * omega_link4_z;
  const Scalar alpha_link4_y = Omega_link4_xz + t_link4_2;
  const Scalar t_link5_2 = omega_link5_x * omega_link5_y;
  const Scalar Omega_link5_xy = alpha_link4_y - t_link5_2;
  // link6
  const Scalar Omega_link6_yz = c_joint6 * Omega_link5_zy - s_joint6 * Omega_link5_xy;
  const Scalar t_link6_2 = 0.001119670733427555 * Omega_link6_yx;
  const Scalar Omega_link6_xz = s_joint6 * Omega_link5_zy + c_joint6 * Omega_link5_xy;
  const Scalar t_link6_3 = t_link6_2 - 0.000103758917218685 * Omega_link6_yz;
  const Scalar Omega_link6_xy = alpha_link5_y + t_link6_1;
  const Scalar t_link6_4 = t_link6_3 - 9.3569097314605e-05 * Omega_link6_xz;
  // link5
  const Scalar t_link5_3 = omega_link5_z * omega_link5_z;
  const Scalar t_link5_4 = omega_link5_x * omega_link5_x;
  const Scalar Omega_link5_yy = t_link5_3 + t_link5_4;
  // link6
  const Scalar t_link6_5 = omega_link6_x * omega_link6_x;
  const Scalar omega_link6_z = omega_link5_y - qd[5];
  const Scalar t_link6_6 = omega_link6_z * omega_link6_z;
  const Scalar t_link6_7 = t_link6_6 - t_link6_5;
  const Scalar Omega_link6_xx = Omega_link5_yy + t_link6_7;
  const Scalar Omega_link6_yy = t_link6_6 + t_link6_5;
  const Scalar t_link6_8 = 0.005511034382675315 * (Omega_link6_xx - Omega_link6_yy);
  const Scalar t_link6_9 = t_link6_4 + 0.013508337745659894 * Omega_link6_xy;
  const Scalar t_link6_10 = t_link6_9 + t_link6_8;
  // link3
  const Scalar Omega_link3_yx = alpha_link3_z - t_link3_4;
  const Scalar t_link3_5 = 118.9090909090909 * s_joint2;
  const Scalar a_link3_y = s_joint3 * t_link3_5;
  const Scalar Omega_link3_yz = alpha_link3_x + t_link3_3;
  const Scalar a_link4_z = a_link3_y - Omega_link3_yx + 3.83030303030303 * Omega_link3_yz;
  const Scalar Omega_link4_zx = t_link4_2 + alpha_link4_y;
  const Scalar t_link5_5 = a_link4_z - Omega_link4_zx;
  const Scalar t_link5_6 = s_joint5 * t_link5_5;
  const Scalar t_link3_6 = omega_link3_x * omega_link3_x;
  const Scalar t_link3_7 = omega_link3_y * omega_link3_y;
  const Scalar Omega_link3_zz = t_link3_6 + t_link3_7;
  const Scalar t_link3_8 = omega_link3_x * omega_link3_z;
  const Scalar Omega_link3_zx = alpha_link3_y - t_link3_8;
  const Scalar t_link4_3 = Omega_link3_zx - 118.9090909090909 * c_joint2;
  const Scalar t_link4_4 = t_link4_3 + 3.83030303030303 * Omega_link3_zz;
  const Scalar t_link3_9 = omega_link3_z * omega_link3_z;
  const Scalar Omega_link3_xx = t_link3_7 + t_link3_9;
  const Scalar a_link3_x = c_joint3 * t_link3_5;
  const Scalar Omega_link3_xz = alpha_link3_y + t_link3_8;
  // link4
  const Scalar t_link4_5 = a_link3_x + Omega_link3_xx - 3.83030303030303 * Omega_link3_xz;
  const Scalar a_link4_x = s_joint4 * t_link4_4 + c_joint4 * t_link4_5;
  const Scalar t_link4_6 = omega_link4_x * omega_link4_x;
  const Scalar t_link4_7 = omega_link4_z * omega_link4_z;
  const Scalar t_link4_8 = t_link4_7 - t_link4_6;
  const Scalar Omega_link3_yy = t_link3_6 + t_link3_9;
  const Scalar Omega_link4_xx = Omega_link3_yy + t_link4_8;
  const Scalar t_link5_7 = a_link4_x - Omega_link4_xx;
  const Scalar a_link5_x = t_link5_6 - c_joint5 * t_link5_7;
  const Scalar t_link6_11 = a_link5_x + 4.654545454545454 * Omega_link5_xz;
  const Scalar Omega_link4_yx = alpha_link3_y - t_link4_1;
  const Scalar t_link5_8 = Omega_link4_yx - c_joint4 * t_link4_4;
  const Scalar a_link5_z = t_link5_8 + s_joint4 * t_link4_5;
  const Scalar Omega_link4_yy = t_link4_7 + t_link4_6;
  // link6
  const Scalar t_link6_12 = a_link5_z - 4.654545454545454 * Omega_link4_yy;
  const Scalar a_link6_x = s_joint6 * t_link6_12 + c_joint6 * t_link6_11;
  const Scalar t_link6_13 = omega_link6_x * omega_link6_z;
  const Scalar alpha_link6_y = Omega_link6_xz + t_link6_13;
  const Scalar Omega_link6_xz_2 = t_link6_13 - alpha_link6_y;
  // link7
  const Scalar t_link7_1 = 0.3842058806066518 - q[6];
  const Scalar c_link7 = cos(t_link7_1);
  w.c_link7 = c_link7;
  const Scalar s_link7 = sin(t_link7_1);
  w.s_link7 = s_link7;
  const Scalar I_link7_yz = 0.00113526676062776 * c_link7 - 0.0013450149983408877 * s_link7;
  w.I_link7_yz = I_link7_yz;
  // link6
  const Scalar t_link6_14 = t_link6_10 - 0.0056786982094425 * a_link6_x;
  const Scalar t_link6_15 = 2.0 * omega_link6_z;
  const Scalar Omega_link6_zy = Omega_link6_yz + omega_link6_y * t_link6_15;
  // link7
  const Scalar omega_link7_z = omega_link6_y - qd[6];
  const Scalar Omega_link7_zy = Omega_link6_zy - t_link6_15 * omega_link7_z;
  const Scalar t_link7_2 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_3 = c_link7 * t_link7_2;
  w.t_link7_3 = t_link7_3;
  const Scalar I_link7_xy = 0.0005571816285452074 - t_link7_3;
  const Scalar t_link6_16 = t_link6_14 + I_link7_yz * Omega_link6_xz_2;
  const Scalar Omega_link7_zx = Omega_link6_xy - omega_link6_x * omega_link7_z * 2.0;
  const Scalar t_link7_4 = s_link7 * t_link7_2;
  w.t_link7_4 = t_link7_4;
  const Scalar I_link7_yy = 0.0013098798160415795 - t_link7_4;
  const Scalar t_link6_17 = t_link6_16 - I_link7_xy * Omega_link7_zy;
  const Scalar t_link7_5 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_6 = t_link6_5 - t_link7_5;
  const Scalar I_link7_xz = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  w.I_link7_xz = I_link7_xz;
  const Scalar t_link6_18 = t_link6_17 + I_link7_yy * Omega_link7_zx;
  const Scalar a_link6_y = c_joint6 * t_link6_12 - s_joint6 * t_link6_11;
  const Scalar a_link7_z = a_link6_y - 1.0666666666666667 * Omega_link6_yx;
  const Scalar h_link7_x = 0.0006883615516358103 * c_link7;
  w.h_link7_x = h_link7_x;
  const Scalar t_link6_19 = t_link6_18 - I_link7_xz * t_link7_6;
  const Scalar h_link7_y = 0.0006883615516358103 * s_link7;
  w.h_link7_y = h_link7_y;
  const Scalar t_link7_7 = 0.012759209153753906 * a_link7_z - h_link7_y * Omega_link7_zy;
  const Scalar F_link7_z = t_link7_7 - h_link7_x * Omega_link7_zx;
  const Scalar t_link6_20 = t_link6_19 - h_link7_x * a_link7_z;
  const Scalar M_link6_z = t_link6_20 - 1.0666666666666667 * F_link7_z;
  w.M_link6_z = M_link6_z;
  // link5
  const Scalar t_link5_9 = M_link6_z - 0.02389827041510187 * Omega_link5_xy;
  const Scalar Omega_link5_zx = t_link5_1 - alpha_link5_y;
  const Scalar t_link5_10 = t_link5_9 + 0.00151524447332703 * Omega_link5_zy;
  const Scalar t_link5_11 = t_link5_3 - t_link5_4;
  const Scalar t_link5_12 = t_link5_10 - 0.001451156065026714 * Omega_link5_zx;
  const Scalar t_link5_13 = t_link5_12 + 0.001026787777028894 * t_link5_11;
  const Scalar F_link6_y = F_link7_z + 0.0056786982094425 * Omega_link6_yy;
  const Scalar a_link7_x = a_link6_x - 1.0666666666666667 * Omega_link6_xx;
  const Scalar t_link6_21 = 0.0056786982094425 * Omega_link6_xy;
  const Scalar t_link6_22 = t_link6_21 - 0.012759209153753906 * a_link7_x;
  const Scalar Omega_link7_xx = Omega_link6_yy - t_link7_6;
  // link6
  const Scalar t_link6_23 = t_link6_22 - h_link7_y * Omega_link6_xz_2;
  const Scalar F_link6_x = t_link6_23 + h_link7_x * Omega_link7_xx;
  const Scalar t_link6_24 = s_joint6 * F_link6_y + c_joint6 * F_link6_x;
  // link5
  const Scalar t_link5_14 = t_link5_13 + 0.001208932934385 * a_link5_z;
  const Scalar M_link5_y = t_link5_14 - 4.654545454545454 * t_link6_24;
  const Scalar t_link5_15 = 0.0055993270925625 * Omega_link5_zy;
  const Scalar t_link5_16 = 0.027672413504871093 * a_link5_z - t_link5_15;
  const Scalar t_link5_17 = t_link5_16 - 0.001208932934385 * Omega_link5_zx;
  const Scalar F_link5_z = t_link5_17 + c_joint6 * F_link6_y - s_joint6 * F_link6_x;
  // link4
  const Scalar t_link4_9 = F_link5_z + 0.0054157634981905 * Omega_link4_yx;
  const Scalar t_link4_10 = t_link4_9 + 0.0039053550262761 * Omega_link4_yz;
  const Scalar t_link4_11 = t_link4_10 + 0.00164448757736927 * Omega_link4_xz;
  const Scalar t_link4_12 = 0.07937575371526084 * (Omega_link4_xx - Omega_link4_yy);
  const Scalar t_link4_13 = t_link4_11 + 0.3087998849151318 * Omega_link4_xy;
  const Scalar t_link4_14 = t_link4_13 + t_link4_12 - 0.0825680742020475 * a_link4_x;
  const Scalar t_link4_15 = t_link4_14 + c_joint5 * M_link5_y;
  const Scalar Omega_link6_zx = t_link6_13 + alpha_link6_y;
  // link7
  const Scalar t_link7_8 = I_link7_yy * Omega_link6_zx - I_link7_xz * Omega_link6_zy;
  const Scalar I_link7_xx = 0.0035997721513193665 + t_link7_4;
  const Scalar t_link7_9 = t_link7_8 - I_link7_yz * Omega_link6_xy;
  const Scalar Omega_link7_yy = t_link6_5 + t_link7_5;
  const Scalar t_link7_10 = I_link7_xy * (Omega_link7_xx - Omega_link7_yy);
  const Scalar t_link7_11 = t_link7_9 - I_link7_xx * Omega_link6_xz_2 - t_link7_10;
  const Scalar a_link5_y = c_joint5 * t_link5_5 + s_joint5 * t_link5_7;
  const Scalar a_link6_z = a_link5_y + 4.654545454545454 * Omega_link5_yz;
  const Scalar a_link7_y = a_link6_z + 1.0666666666666667 * Omega_link6_zx;
  const Scalar M_link7_z = t_link7_11 - h_link7_y * a_link7_x + h_link7_x * a_link7_y;
  w.M_link7_z = M_link7_z;
  // link6
  const Scalar t_link6_25 = M_link7_z - 9.3569097314605e-05 * Omega_link6_xy;
  const Scalar t_link6_26 = t_link6_25 - 0.005511034382675315 * Omega_link6_zy;
  const Scalar t_link6_27 = t_link6_26 + 0.001119670733427555 * Omega_link6_zx;
  const Scalar t_link7_12 = 0.012759209153753906 * a_link7_y - h_link7_y * Omega_link7_yy;
  const Scalar F_link7_y = t_link7_12 + h_link7_x * Omega_link6_zx;
  const Scalar t_link6_28 = t_link6_27 - 0.000103758917218685 * t_link6_7;
  const Scalar M_link6_y = t_link6_28 + 1.0666666666666667 * F_link7_y;
  const Scalar F_link6_z = F_link7_y - 0.0056786982094425 * Omega_link6_zy;
  // link5
  const Scalar t_link5_18 = 0.010045187828321245 * Omega_link5_zy;
  const Scalar Omega_link5_yx = alpha_link4_y + t_link5_2;
  const Scalar t_link5_19 = t_link5_18 - 0.00151524447332703 * Omega_link5_zx;
  const Scalar t_link5_20 = 0.02389827041510187 * (Omega_link4_yy - Omega_link5_yy);
  const Scalar t_link5_21 = t_link5_19 - 0.001026787777028894 * Omega_link5_yx;
  const Scalar t_link5_22 = t_link5_21 + t_link5_20 - 0.0055993270925625 * a_link5_z;
  const Scalar t_link5_23 = t_link5_22 + 4.654545454545454 * F_link6_z;
  // link6
  const Scalar t_link6_29 = 0.013508337745659894 * Omega_link6_zy;
  const Scalar t_link6_30 = 9.3569097314605e-05 * (Omega_link5_yy - Omega_link6_yy);
  const Scalar t_link6_31 = t_link6_29 - 0.000103758917218685 * Omega_link6_yx;
  const Scalar t_link6_32 = t_link6_31 - t_link6_30 - 0.0056786982094425 * a_link6_z;
  const Scalar t_link6_33 = t_link6_32 + I_link7_xx * Omega_link7_zy;
  const Scalar t_link7_13 = I_link7_yz * (Omega_link6_yy - Omega_link7_yy);
  const Scalar t_link6_34 = t_link6_33 - I_link7_xy * Omega_link7_zx + t_link7_13;
  const Scalar I_link6_xy = 0.005511034382675315 + I_link7_xz;
  w.I_link6_xy = I_link6_xy;
  const Scalar t_link6_35 = t_link6_34 - h_link7_y * a_link7_z;
  const Scalar M_link6_x = t_link6_35 - I_link6_xy * Omega_link6_zx;
  const Scalar M_link5_x = t_link5_23 + s_joint6 * M_link6_y + c_joint6 * M_link6_x;
  const Scalar M_link4_z = t_link4_15 - s_joint5 * M_link5_x;
  w.M_link4_z = M_link4_z;
  // link3
  const Scalar t_link3_10 = M_link4_z + 0.013297019103287584 * Omega_link3_xy;
  const Scalar t_link3_11 = t_link3_10 + 0.000121912420950744 * Omega_link3_zy;
  const Scalar t_link3_12 = 0.06681619663671426 * (Omega_link3_xx - Omega_link3_zz);
  const Scalar t_link3_13 = t_link3_11 + 0.015998048367902695 * Omega_link3_zx;
  const Scalar F_link4_y = F_link5_z - 0.0825680742020475 * Omega_link4_yy;
  const Scalar t_link3_14 = t_link3_13 - t_link3_12 - 1.90390209202782 * c_joint2;
  // link5
  const Scalar t_link5_24 = t_link6_24 - 0.027672413504871093 * a_link5_x;
  const Scalar Omega_link5_xx = Omega_link4_yy + t_link5_11;
  const Scalar t_link5_25 = t_link5_24 + 0.0055993270925625 * Omega_link5_xy;
  const Scalar F_link5_x = t_link5_25 - 0.001208932934385 * Omega_link5_xx;
  const Scalar t_link5_26 = F_link6_z + 0.027672413504871093 * a_link5_y;
  const Scalar t_link5_27 = t_link5_26 - 0.0055993270925625 * Omega_link5_yy;
  const Scalar F_link5_y = t_link5_27 - 0.001208932934385 * Omega_link5_yx;
  // link4
  const Scalar t_link4_16 = 0.0825680742020475 * Omega_link4_xy - s_joint5 * F_link5_y;
  const Scalar F_link4_x = t_link4_16 - c_joint5 * F_link5_x;
  const Scalar t_link4_17 = s_joint4 * F_link4_y - c_joint4 * F_link4_x;
  // link3
  const Scalar t_link3_15 = t_link3_14 - c_joint4 * F_link4_y - s_joint4 * F_link4_x;
  const Scalar M_link3_y = t_link3_15 - 3.83030303030303 * t_link4_17;
  w.M_link3_y = M_link3_y;
  const Scalar t_link3_16 = s_joint3 * M_link3_y;
  // link4
  const Scalar t_link4_18 = 0.07937575371526084 * Omega_link4_zx;
  const Scalar t_link4_19 = 0.3087998849151318 * Omega_link4_zy - t_link4_18;
  const Scalar t_link4_20 = 0.00164448757736927 * (Omega_link3_yy - Omega_link4_yy);
  const Scalar t_link4_21 = t_link4_19 + 0.0039053550262761 * Omega_link4_yx;
  const Scalar t_link4_22 = t_link4_21 + t_link4_20 + 0.0825680742020475 * a_link4_z;
  const Scalar M_link4_x = t_link4_22 + s_joint5 * M_link5_y + c_joint5 * M_link5_x;
  const Scalar t_link4_23 = c_joint4 * M_link4_x;
  // link5
  const Scalar t_link5_28 = 0.001451156065026714 * Omega_link5_yx;
  const Scalar t_link5_29 = t_link5_28 - 0.001026787777028894 * Omega_link5_yz;
  const Scalar t_link5_30 = t_link5_29 - 0.02389827041510187 * Omega_link5_xz;
  const Scalar t_link5_31 = 0.00151524447332703 * (Omega_link5_xx - Omega_link5_yy);
  const Scalar t_link5_32 = t_link5_30 + 0.010045187828321245 * Omega_link5_xy;
  const Scalar t_link5_33 = t_link5_32 + t_link5_31 - 0.0055993270925625 * a_link5_x;
  const Scalar t_link5_34 = t_link5_33 - 0.001208932934385 * a_link5_y;
  const Scalar M_link5_z = t_link5_34 + c_joint6 * M_link6_y - s_joint6 * M_link6_x;
  w.M_link5_z = M_link5_z;
  const Scalar t_link5_35 = c_joint5 * F_link5_y - s_joint5 * F_link5_x;
  // link4
  const Scalar t_link4_24 = M_link5_z - t_link5_35 + 0.00164448757736927 * Omega_link4_xy;
  const Scalar t_link4_25 = t_link4_24 - 0.07937575371526084 * Omega_link4_zy;
  const Scalar t_link4_26 = t_link4_25 + 0.0054157634981905 * Omega_link4_zx;
  const Scalar M_link4_y = t_link4_26 + 0.0039053550262761 * t_link4_8;
  const Scalar F_link4_z = t_link5_35 + 0.0825680742020475 * Omega_link4_zy;
  // link3
  const Scalar t_link3_17 = 0.022178148964878235 * Omega_link3_zy;
  const Scalar t_link3_18 = t_link3_17 + 0.000121912420950744 * Omega_link3_zx;
  const Scalar t_link3_19 = 0.013297019103287584 * (Omega_link3_yy - Omega_link3_zz);
  const Scalar t_link3_20 = t_link3_18 - 0.06681619663671426 * Omega_link3_yx;
  const Scalar t_link3_21 = t_link3_20 - t_link3_19 - 0.27690780075318 * c_joint2;
  const Scalar t_link3_22 = t_link3_21 + 3.83030303030303 * F_link4_z;
  const Scalar M_link3_x = t_link3_22 + s_joint4 * M_link4_y + t_link4_23;
  w.M_link3_x = M_link3_x;
  const Scalar t_link3_23 = s_joint2 * (t_link3_16 + c_joint3 * M_link3_x);
  w.t_link3_23 = t_link3_23;
  const Scalar t_link3_24 = F_link4_z - 0.015998048367902695 * Omega_link3_yx;
  const Scalar t_link3_25 = t_link3_24 + 0.06681619663671426 * Omega_link3_yz;
  const Scalar t_link3_26 = t_link3_25 - 0.013297019103287584 * Omega_link3_xz;
  const Scalar t_link3_27 = 0.000121912420950744 * (Omega_link3_xx - Omega_link3_yy);
  const Scalar t_link3_28 = t_link3_26 - 0.022178148964878235 * Omega_link3_xy;
  const Scalar t_link3_29 = t_link3_28 + t_link3_27 + 0.002328735327435 * a_link3_x;
  const Scalar t_link3_30 = t_link3_29 + 0.016011409030815 * a_link3_y;
  const Scalar M_link3_z = t_link3_30 + c_joint4 * M_link4_y - s_joint4 * M_link4_x;
  w.M_link3_z = M_link3_z;
}

[[gnu::noinline]] void forward_dynamics_2(const Scalar qd[7], const Scalar tau[7], Scalar qdd[7],
                                          ForwardDynamicsWorkspace& w) noexcept {
  // link7
  const Scalar t_link7_14 = 0.00796671776787104 * w.c_joint2 - 0.34001233503451994 * w.s_joint2;
  const Scalar t_link7_15 = 0.00398335888393552 - w.c_joint2 * t_link7_14;
  const Scalar t_link7_16 = 0.0007689361029464 * w.s_joint2 - 0.01026110182100817 * w.c_joint2;
  // link1
  const Scalar t_link1_1 = tau[0] - t_link7_15 * w.alpha_link2_x * 2.0;
  const Scalar t_link1_2 = t_link1_1 - t_link7_16 * qd[1] * qd[1];
  const Scalar t_link1_3 = t_link1_2 - w.c_joint2 * w.M_link3_z - w.t_link3_23;
  const Scalar t_link1_4 = w.M_link7_z + tau[6];
  const Scalar t_link7_17 = 0.004909651967360946 + 0.0007342523217448644 * w.c_link7;
  const Scalar t_link6_36 = w.c_joint6 * t_link7_17 + w.s_joint6 * w.I_link7_xz;
  const Scalar t_link6_37 = w.c_joint6 * w.h_link7_y;
  const Scalar t_link5_36 = w.c_joint5 * w.h_link7_x - w.s_joint5 * t_link6_37;
  const Scalar t_link5_37 = t_link6_36 - t_link5_36;
  // link6
  const Scalar t_link6_38 = w.I_link7_yz + 4.654545454545454 * t_link6_37;
  const Scalar t_link6_39 = 0.0032040101312503172 * w.c_link7 + w.s_joint6 * t_link7_17;
  const Scalar t_link6_40 = t_link6_39 - w.c_joint6 * w.I_link7_xz;
  const Scalar t_link5_38 = w.s_joint5 * t_link6_38 - w.c_joint5 * t_link6_40;
  const Scalar t_link4_27 = t_link5_36 + w.c_joint4 * t_link5_37;
  const Scalar t_link4_28 = t_link4_27 + w.s_joint4 * t_link5_38;
  const Scalar t_link3_31 = w.c_joint2 * t_link4_28;
  const Scalar t_link4_29 = 3.83030303030303 * t_link5_36 + w.s_joint4 * t_link5_37;
  const Scalar t_link4_30 = t_link4_29 - w.c_joint4 * t_link5_38;
  const Scalar t_link6_41 = w.s_joint6 * w.h_link7_y;
  // link5
  const Scalar t_link5_39 = t_link6_41 + w.c_joint5 * t_link6_38;
  const Scalar t_link5_40 = t_link5_39 + w.s_joint5 * t_link6_40;
  const Scalar t_link5_41 = w.s_joint5 * w.h_link7_x + w.c_joint5 * t_link6_37;
  // link4
  const Scalar t_link4_31 = t_link5_40 - w.c_joint4 * t_link6_41;
  const Scalar t_link4_32 = w.s_joint4 * t_link6_41 - w.c_joint4 * t_link5_41;
  const Scalar t_link4_33 = t_link4_31 - w.s_joint4 * t_link5_41;
  const Scalar t_link4_34 = t_link4_33 - 3.83030303030303 * t_link4_32;
  const Scalar t_link3_32 = w.s_joint3 * t_link4_34 - w.c_joint3 * t_link4_30;
  const Scalar t_link3_33 = t_link3_31 - w.s_joint2 * t_link3_32;
  const Scalar t_link7_18 = 203.68042513969144 * t_link3_33;
  const Scalar t_link1_5 = t_link1_3 + t_link1_4 * t_link7_18;
  const Scalar t_link7_19 = 203.68042513969144 * w.I_link7_yz;
  const Scalar t_link1_6 = w.M_link6_z + tau[5] + t_link1_4 * t_link7_19;
  const Scalar t_link7_20 = t_link3_33 * t_link7_19;
  const Scalar t_link7_21 = 0.0014685046434897288 * w.c_link7;
  // link6
  const Scalar I_link6_zz = t_link7_21 - (w.t_link7_4 - 0.030455032932289027);
  const Scalar h_link6_x = 0.0136098230973375 + w.h_link7_x;
  const Scalar t_link6_42 = 0.0056786982094425 * w.c_joint6 - w.s_joint6 * h_link6_x;
  const Scalar t_link6_43 = I_link6_zz - 4.654545454545454 * t_link6_42;
  const Scalar t_link6_44 = 0.0056786982094425 * w.s_joint6 + w.c_joint6 * h_link6_x;
  const Scalar I_link6_yz = 9.3569097314605e-05 + w.I_link7_yz;
  const Scalar t_link6_45 = w.t_link7_3 - 0.0006609405457638925;
  const Scalar I_link6_xz = t_link6_45 + 0.0007342523217448644 * w.s_link7;
  const Scalar t_link6_46 = w.s_joint6 * I_link6_yz - w.c_joint6 * I_link6_xz;
  // link5
  const Scalar t_link5_42 = t_link6_44 - w.c_joint5 * t_link6_43;
  const Scalar t_link5_43 = t_link5_42 - w.s_joint5 * t_link6_46;
  const Scalar t_link5_44 = w.c_joint5 * t_link6_42;
  // link4
  const Scalar t_link4_35 = t_link5_43 - w.c_joint4 * t_link6_44;
  const Scalar t_link4_36 = w.s_joint4 * t_link6_44 - w.c_joint4 * t_link5_44;
  const Scalar t_link4_37 = t_link4_35 - w.s_joint4 * t_link5_44;
  const Scalar t_link4_38 = t_link4_37 - 3.83030303030303 * t_link4_36;
  const Scalar t_link5_45 = w.s_joint5 * t_link6_43 - w.c_joint5 * t_link6_46;
  const Scalar t_link6_47 = w.c_joint6 * I_link6_yz + w.s_joint6 * I_link6_xz;
  const Scalar t_link5_46 = w.s_joint5 * t_link6_42;
  const Scalar t_link5_47 = t_link6_47 - t_link5_46;
  const Scalar t_link4_39 = 3.83030303030303 * t_link5_46 + w.s_joint4 * t_link5_47;
  const Scalar t_link4_40 = t_link4_39 - w.c_joint4 * t_link5_45;
  const Scalar t_link3_34 = w.s_joint3 * t_link4_38 + w.c_joint3 * t_link4_40;
  const Scalar t_link4_41 = t_link5_46 + w.c_joint4 * t_link5_47;
  const Scalar t_link4_42 = t_link4_41 + w.s_joint4 * t_link5_45;
  const Scalar t_link3_35 = w.c_joint2 * t_link4_42 + w.s_joint2 * t_link3_34;
  const Scalar t_link7_22 = t_link3_35 - t_link7_20;
  const Scalar inverse_pivot_link6 = 1.0 / (I_link6_zz - w.I_link7_yz * t_link7_19);
  const Scalar t_link6_48 = t_link7_22 * inverse_pivot_link6;
  const Scalar t_link1_7 = t_link1_5 - t_link6_48 * t_link1_6;
  const Scalar t_link7_23 = 203.68042513969144 * t_link6_36;
  const Scalar t_link7_24 = t_link6_47 - t_link6_36 * t_link7_19;
  const Scalar t_link6_49 = t_link7_24 * inverse_pivot_link6;
  const Scalar t_link1_8 = w.M_link5_z - tau[4] - t_link1_4 * t_link7_23;
  const Scalar t_link1_9 = t_link1_8 + t_link6_49 * t_link1_6;
  // link6
  const Scalar I_link6_xx = 0.017108109896979258 + w.t_link7_4;
  const Scalar I_link6_yy = 0.0205464673379485 + t_link7_21;
  const Scalar t_link6_50 = w.s_joint6 * (I_link6_xx - I_link6_yy);
  const Scalar t_link6_51 = w.c_joint6 * w.I_link6_xy * 2.0 + t_link6_50;
  const Scalar t_link6_52 = w.s_joint6 * t_link6_51;
  // link5
  const Scalar I_link5_zz = t_link7_21 + 0.03204281123129646 + t_link6_52;
  const Scalar h_link5_y = 0.0055993270925625 + w.h_link7_y;
  const Scalar h_link5_x = 0.001208932934385 - t_link6_44;
  const Scalar t_link5_48 = w.s_joint5 * h_link5_y + w.c_joint5 * h_link5_x;
  const Scalar t_link5_49 = I_link5_zz + t_link5_48;
  const Scalar t_link5_50 = 0.02389827041510187 + t_link6_47;
  const Scalar I_link5_yz = t_link5_50 + 0.0032040101312503172 * w.s_link7;
  const Scalar t_link5_51 = w.I_link7_xz + 0.004484246605646421 - w.c_joint6 * t_link6_51;
  const Scalar I_link5_xz = t_link5_51 + 4.654545454545454 * t_link6_44;
  const Scalar t_link5_52 = w.s_joint5 * I_link5_yz - w.c_joint5 * I_link5_xz;
  // link4
  const Scalar t_link4_43 = t_link5_48 - w.c_joint4 * t_link5_49;
  const Scalar t_link4_44 = t_link4_43 - w.s_joint4 * t_link5_52;
  const Scalar t_link4_45 = 3.83030303030303 * t_link5_48 - w.s_joint4 * t_link5_49;
  const Scalar t_link4_46 = t_link4_45 + w.c_joint4 * t_link5_52;
  const Scalar t_link5_53 = w.c_joint5 * I_link5_yz + w.s_joint5 * I_link5_xz;
  const Scalar h_link4_z = w.c_joint5 * h_link5_y - w.s_joint5 * h_link5_x;
  const Scalar t_link4_47 = h_link4_z * (w.s_joint4 - 3.83030303030303 * w.c_joint4);
  const Scalar t_link4_48 = t_link5_53 - t_link4_47;
  const Scalar t_link3_36 = w.s_joint3 * t_link4_48 + w.c_joint3 * t_link4_46;
  const Scalar t_link3_37 = w.c_joint2 * t_link4_44 + w.s_joint2 * t_link3_36;
  const Scalar t_link7_25 = t_link3_37 + t_link3_33 * t_link7_23;
  const Scalar t_link6_53 = t_link7_25 + t_link7_22 * t_link6_49;
  const Scalar t_link7_26 = I_link5_zz - t_link6_36 * t_link7_23;
  const Scalar inverse_pivot_link5 = 1.0 / (t_link7_26 - t_link7_24 * t_link6_49);
  const Scalar t_link5_54 = t_link6_53 * inverse_pivot_link5;
  const Scalar t_link1_10 = t_link1_7 - t_link5_54 * t_link1_9;
  const Scalar t_link7_27 = 203.68042513969144 * t_link5_40;
  const Scalar t_link7_28 = t_link5_43 + t_link5_40 * t_link7_19;
  const Scalar t_link6_54 = t_link7_28 * inverse_pivot_link6;
  const Scalar t_link1_11 = w.M_link4_z + tau[3] + t_link1_4 * t_link7_27;
  const Scalar t_link7_29 = t_link5_53 - t_link5_40 * t_link7_23;
  const Scalar t_link6_55 = t_link7_29 + t_link7_28 * t_link6_49;
  const Scalar t_link5_55 = t_link6_55 * inverse_pivot_link5;
  const Scalar t_link1_12 = t_link1_11 + t_link6_54 * t_link1_6;
  const Scalar t_link1_13 = t_link1_12 + t_link5_55 * t_link1_9;
  const Scalar t_link6_56 = 9.309090909090909 * t_link6_42;
  // link5
  const Scalar I_link5_xx = t_link6_52 - (w.t_link7_4 + 0.3035789278411405) + t_link6_56;
  const Scalar I_link5_yy = t_link6_56 - (0.2778767861808667 + I_link6_zz);
  const Scalar I_link5_xy = 0.00151524447332703 - t_link6_46;
  const Scalar t_link5_56 = w.s_joint5 * (I_link5_xx - I_link5_yy);
  const Scalar t_link5_57 = w.c_joint5 * I_link5_xy * 2.0 + t_link5_56;
  // link4
  const Scalar t_link4_49 = h_link4_z - (t_link6_46 + 0.00239011055294907);
  const Scalar I_link4_xz = t_link4_49 - w.c_joint5 * t_link5_57;
  const Scalar I_link4_yz = 0.00164448757736927 - t_link5_53;
  const Scalar t_link4_50 = w.c_joint4 * I_link4_yz + w.s_joint4 * I_link4_xz;
  const Scalar t_link4_51 = w.s_joint4 * I_link4_yz - w.c_joint4 * I_link4_xz;
  const Scalar t_link5_58 = w.s_joint5 * t_link5_57;
  const Scalar t_link5_59 = 2.0 * t_link5_48;
  const Scalar t_link4_52 = t_link5_58 - (0.35464727107194727 - I_link5_yy);
  const Scalar I_link4_zz = t_link5_59 - t_link4_52;
  const Scalar h_link4_x = 0.040431622658625 + t_link5_48;
  const Scalar h_link4_y = 0.1419563931722475 - t_link6_42;
  const Scalar t_link4_53 = w.s_joint4 * h_link4_y + w.c_joint4 * h_link4_x;
  const Scalar t_link4_54 = w.c_joint4 * h_link4_y - w.s_joint4 * h_link4_x;
  const Scalar t_link4_55 = I_link4_zz - t_link4_53 + 3.83030303030303 * t_link4_54;
  const Scalar t_link3_38 = w.s_joint3 * t_link4_55 + w.c_joint3 * t_link4_51;
  const Scalar t_link3_39 = w.c_joint2 * t_link4_50 + w.s_joint2 * t_link3_38;
  const Scalar t_link7_30 = t_link3_39 + t_link3_33 * t_link7_27;
  const Scalar t_link6_57 = t_link7_30 - t_link7_22 * t_link6_54;
  const Scalar t_link5_60 = t_link6_57 - t_link6_53 * t_link5_55;
  const Scalar t_link7_31 = I_link4_zz - t_link5_40 * t_link7_27;
  const Scalar t_link6_58 = t_link7_31 - t_link7_28 * t_link6_54;
  const Scalar inverse_pivot_link4 = 1.0 / (t_link6_58 - t_link6_55 * t_link5_55);
  const Scalar t_link4_56 = t_link5_60 * inverse_pivot_link4;
  const Scalar t_link1_14 = t_link1_10 + t_link4_56 * t_link1_13;
  const Scalar t_link7_32 = 203.68042513969144 * t_link4_28;
  const Scalar t_link7_33 = t_link4_42 - t_link4_28 * t_link7_19;
  const Scalar t_link6_59 = t_link7_33 * inverse_pivot_link6;
  const Scalar t_link1_15 = w.M_link3_z - tau[2] - t_link1_4 * t_link7_32;
  const Scalar t_link7_34 = t_link4_44 + t_link4_28 * t_link7_23;
  const Scalar t_link6_60 = t_link7_34 + t_link7_33 * t_link6_49;
  const Scalar t_link5_61 = t_link6_60 * inverse_pivot_link5;
  const Scalar t_link1_16 = t_link1_15 + t_link6_59 * t_link1_6;
  const Scalar t_link7_35 = t_link4_50 + t_link4_28 * t_link7_27;
  const Scalar t_link6_61 = t_link7_35 - t_link7_33 * t_link6_54;
  const Scalar t_link5_62 = t_link6_61 - t_link6_60 * t_link5_55;
  const Scalar t_link4_57 = t_link5_62 * inverse_pivot_link4;
  const Scalar t_link1_17 = t_link1_16 + t_link5_61 * t_link1_9;
  const Scalar t_link1_18 = t_link1_17 - t_link4_57 * t_link1_13;
  const Scalar t_link4_58 = t_link5_60 * t_link4_57;
  const Scalar I_link3_yz = 0.013297019103287584 - t_link4_50 + 3.83030303030303 * h_link4_z;
  const Scalar I_link4_xx = 0.3087998849151318 - I_link5_xx + t_link5_58;
  const Scalar I_link4_yy = 0.0458473861568155 + I_link5_zz + t_link5_59;
  const Scalar I_link4_xy = 0.13876407268546084 - t_link6_42 + t_link5_52;
  const Scalar t_link4_59 = w.s_joint4 * (I_link4_xx - I_link4_yy);
  const Scalar t_link4_60 = w.c_joint4 * I_link4_xy * 2.0 + t_link4_59;
  // link3
  const Scalar t_link3_40 = 0.22168156342611425 + I_link4_xy + t_link4_54;
  const Scalar t_link3_41 = t_link3_40 - w.c_joint4 * t_link4_60;
  const Scalar I_link3_xz = t_link3_41 - 3.83030303030303 * t_link4_53;
  const Scalar t_link3_42 = w.s_joint3 * I_link3_yz - w.c_joint3 * I_link3_xz;
  const Scalar t_link4_61 = w.s_joint4 * t_link4_60;
  const Scalar t_link4_62 = 2.0 * t_link4_53;
  const Scalar I_link3_zz = t_link4_62 - (0.07860781999140594 + I_link4_yy + t_link4_61);
  const Scalar t_link3_43 = w.c_joint2 * I_link3_zz + w.s_joint2 * t_link3_42;
  const Scalar t_link7_36 = t_link3_43 + t_link3_33 * t_link7_32;
  const Scalar t_link6_62 = t_link7_36 + t_link7_22 * t_link6_59;
  const Scalar t_link4_63 = t_link6_62 + t_link6_53 * t_link5_61 + t_link4_58;
  const Scalar t_link7_37 = I_link3_zz + t_link4_28 * t_link7_32;
  const Scalar t_link6_63 = t_link7_37 + t_link7_33 * t_link6_59;
  const Scalar t_link5_63 = t_link6_63 + t_link6_60 * t_link5_61;
  const Scalar inverse_pivot_link3 = 1.0 / (t_link5_63 + t_link5_62 * t_link4_57);
  const Scalar t_link3_44 = t_link4_63 * inverse_pivot_link3;
  const Scalar t_link1_19 = t_link1_14 + t_link3_44 * t_link1_18;
  const Scalar t_link7_38 = 0.10124268680034 * w.s_joint2 - 0.000167639551695 * w.c_joint2;
  const Scalar t_link1_20 = tau[1] + t_link7_15 * qd[0] * qd[0];
  const Scalar t_link1_21 = t_link1_20 + 118.9090909090909 * t_link7_38;
  const Scalar t_link3_45 = w.c_joint3 * t_link4_34 + w.s_joint3 * t_link4_30;
  const Scalar t_link7_39 = 203.68042513969144 * t_link3_45;
  const Scalar t_link1_22 = t_link1_21 - w.c_joint3 * w.M_link3_y + w.s_joint3 * w.M_link3_x;
  const Scalar t_link3_46 = w.c_joint3 * t_link4_38 - w.s_joint3 * t_link4_40;
  const Scalar t_link7_40 = t_link3_46 + t_link3_45 * t_link7_19;
  const Scalar t_link6_64 = t_link7_40 * inverse_pivot_link6;
  const Scalar t_link1_23 = t_link1_22 - t_link1_4 * t_link7_39;
  const Scalar t_link3_47 = w.c_joint3 * t_link4_48 - w.s_joint3 * t_link4_46;
  const Scalar t_link7_41 = t_link3_47 - t_link3_45 * t_link7_23;
  const Scalar t_link6_65 = t_link7_41 + t_link7_40 * t_link6_49;
  const Scalar t_link5_64 = t_link6_65 * inverse_pivot_link5;
  const Scalar t_link1_24 = t_link1_23 - t_link6_64 * t_link1_6;
  const Scalar t_link3_48 = w.c_joint3 * t_link4_55 - w.s_joint3 * t_link4_51;
  const Scalar t_link7_42 = t_link3_48 - t_link3_45 * t_link7_27;
  const Scalar t_link6_66 = t_link7_42 - t_link7_40 * t_link6_54;
  const Scalar t_link5_65 = t_link6_66 - t_link6_65 * t_link5_55;
  const Scalar t_link4_64 = t_link5_65 * inverse_pivot_link4;
  const Scalar t_link1_25 = t_link1_24 - t_link5_64 * t_link1_9;
  const Scalar t_link3_49 = w.c_joint3 * I_link3_yz + w.s_joint3 * I_link3_xz;
  const Scalar t_link7_43 = t_link3_49 - t_link3_45 * t_link7_32;
  const Scalar t_link6_67 = t_link7_43 + t_link7_40 * t_link6_59;
  const Scalar t_link5_66 = t_link6_67 + t_link6_65 * t_link5_61;
  const Scalar t_link4_65 = t_link5_66 + t_link5_65 * t_link4_57;
  const Scalar t_link3_50 = t_link4_65 * inverse_pivot_link3;
  const Scalar t_link1_26 = t_link1_25 + t_link4_64 * t_link1_13;
  const Scalar t_link1_27 = t_link1_26 + t_link3_50 * t_link1_18;
  const Scalar I_link3_xy = 0.000121912420950744 + h_link4_z + t_link4_51;
  const Scalar t_link4_66 = 7.66060606060606 * t_link4_54;
  const Scalar I_link3_xx = t_link4_66 - (t_link4_61 - (0.6153594326673073 + I_link4_xx));
  const Scalar I_link3_yy = t_link4_66 - (t_link4_62 - (0.6496109547289568 + I_link4_zz));
  const Scalar t_link3_51 = w.s_joint3 * (I_link3_xx - I_link3_yy);
  const Scalar t_link3_52 = w.c_joint3 * I_link3_xy * 2.0 - t_link3_51;
  const Scalar t_link3_53 = w.s_joint3 * t_link3_52;
  const Scalar I_link2_zz = t_link3_53 - (0.3861681000243835 + I_link3_yy);
  const Scalar t_link7_44 = I_link2_zz + t_link3_45 * t_link7_39;
  const Scalar t_link6_68 = t_link7_44 + t_link7_40 * t_link6_64;
  const Scalar t_link5_67 = t_link6_68 + t_link6_65 * t_link5_64;
  const Scalar t_link4_67 = t_link5_67 + t_link5_65 * t_link4_64;
  const Scalar inverse_pivot_link2 = 1.0 / (t_link4_67 - t_link4_65 * t_link3_50);
  const Scalar t_link3_54 = t_link3_33 * t_link7_39 - t_link7_22 * t_link6_64;
  const Scalar t_link3_55 = t_link3_54 - t_link6_53 * t_link5_64;
  const Scalar t_link3_56 = t_link3_55 - t_link5_60 * t_link4_64;
  const Scalar t_link3_57 = w.c_joint2 * (0.0007689361029464 + t_link3_49);
  const Scalar t_link3_58 = 0.01026110182100817 + I_link3_xy - w.c_joint3 * t_link3_52;
  const Scalar t_link3_59 = t_link3_56 + t_link4_63 * t_link3_50 - t_link3_57;
  const Scalar t_link3_60 = t_link3_59 - w.s_joint2 * t_link3_58;
  // link2
  const Scalar t_link2_1 = t_link3_60 * inverse_pivot_link2;
  const Scalar t_link2_2 = 0.03733744848940618 - I_link3_zz - t_link3_33 * t_link7_18;
  const Scalar t_link2_3 = t_link2_2 - t_link7_22 * t_link6_48;
  const Scalar t_link2_4 = t_link2_3 - t_link6_53 * t_link5_54;
  const Scalar t_link2_5 = t_link2_4 - t_link5_60 * t_link4_56;
  const Scalar t_link2_6 = t_link2_5 + t_link4_63 * t_link3_44;
  const Scalar t_link3_61 = w.s_joint2 * (I_link3_xx + I_link3_zz + t_link3_53);
  const Scalar t_link2_7 = t_link7_14 + w.c_joint2 * t_link3_42 * 2.0 - t_link3_61;
  const Scalar t_link2_8 = t_link2_6 + t_link3_60 * t_link2_1;
  // link1
  const Scalar inverse_pivot_link1 = 1.0 / (t_link2_8 - w.s_joint2 * t_link2_7);
  const Scalar t_link1_28 = t_link1_19 + t_link2_1 * t_link1_27;
  const Scalar t_link1_29 = inverse_pivot_link1 * t_link1_28;
  qdd[0] = t_link1_29;
  const Scalar t_link1_30 = inverse_pivot_link2 * t_link1_27;
  const Scalar t_link1_31 = t_link1_30 - t_link2_1 * t_link1_29;
  qdd[1] = -t_link1_31;
  const Scalar t_link1_32 = inverse_pivot_link3 * t_link1_18;
  const Scalar t_link1_33 = t_link1_32 + t_link3_50 * t_link1_31;
  const Scalar t_link1_34 = t_link1_33 - t_link3_44 * t_link1_29;
  qdd[2] = t_link1_34;
  const Scalar t_link1_35 = inverse_pivot_link4 * t_link1_13;
  const Scalar t_link1_36 = t_link1_35 + t_link4_57 * t_link1_34;
  const Scalar t_link1_37 = t_link1_36 - t_link4_64 * t_link1_31;
  const Scalar t_link1_38 = t_link1_37 + t_link4_56 * t_link1_29;
  qdd[3] = t_link1_38;
  const Scalar t_link1_39 = inverse_pivot_link5 * t_link1_9;
  const Scalar t_link1_40 = t_link1_39 + t_link5_55 * t_link1_38;
  const Scalar t_link1_41 = t_link1_40 - t_link5_61 * t_link1_34;
  const Scalar t_link1_42 = t_link1_41 + t_link5_64 * t_link1_31;
  const Scalar t_link1_43 = t_link1_42 - t_link5_54 * t_link1_29;
  qdd[4] = -t_link1_43;
  const Scalar t_link1_44 = inverse_pivot_link6 * t_link1_6;
  const Scalar t_link1_45 = t_link1_44 + t_link6_49 * t_link1_43;
  const Scalar t_link1_46 = t_link1_45 + t_link6_54 * t_link1_38;
  const Scalar t_link1_47 = t_link1_46 - t_link6_59 * t_link1_34;
  const Scalar t_link1_48 = t_link1_47 + t_link6_64 * t_link1_31;
  const Scalar t_link1_49 = t_link1_48 - t_link6_48 * t_link1_29;
  qdd[5] = t_link1_49;
  const Scalar t_link1_50 = 203.68042513969144 * t_link1_4 + t_link7_19 * t_link1_49;
  const Scalar t_link1_51 = t_link1_50 - t_link7_23 * t_link1_43;
  const Scalar t_link1_52 = t_link1_51 + t_link7_27 * t_link1_38;
  const Scalar t_link1_53 = t_link1_52 + t_link7_32 * t_link1_34;
  qdd[6] = t_link1_53 + t_link7_39 * t_link1_31 + t_link7_18 * t_link1_29;
}

}  // namespace

void forward_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar tau[7],
                      Scalar qdd[7]) noexcept {
  ForwardDynamicsWorkspace w;
  forward_dynamics_1(q, qd, w);
  forward_dynamics_2(qd, tau, qdd, w);
}

void point_positions(const Scalar q[7], Scalar p[3]) noexcept {
  const Scalar c_joint6 = cos(q[5]);
  const Scalar s_joint6 = sin(q[5]);
  const Scalar r_link5_z = 0.384 - 0.107 * c_joint6 + 0.088 * s_joint6;
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  // link5
  const Scalar r_link5_x = 0.107 * s_joint6 + 0.088 * c_joint6;
  const Scalar c_joint5 = cos(q[4]);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar r_link4_x = 0.0825 - c_joint5 * r_link5_x;
  const Scalar r_link3_z = 0.316 + c_joint4 * r_link5_z - s_joint4 * r_link4_x;
  const Scalar s_joint2 = sin(q[1]);
  const Scalar c_joint2 = cos(q[1]);
  // link3
  const Scalar r_link3_x = 0.0825 - s_joint4 * r_link5_z - c_joint4 * r_link4_x;
  const Scalar c_joint3 = cos(q[2]);
  const Scalar s_joint3 = sin(q[2]);
  const Scalar r_link4_z = s_joint5 * r_link5_x;
  const Scalar r_link2_x = s_joint3 * r_link4_z - c_joint3 * r_link3_x;
  // link1
  const Scalar r_link1_x = s_joint2 * r_link3_z - c_joint2 * r_link2_x;
  const Scalar c_joint1 = cos(q[0]);
  const Scalar s_joint1 = sin(q[0]);
  // link2
  const Scalar r_link2_z = c_joint3 * r_link4_z + s_joint3 * r_link3_x;
  p[0] = c_joint1 * r_link1_x - s_joint1 * r_link2_z;
  p[1] = c_joint1 * r_link2_z + s_joint1 * r_link1_x;
  p[2] = 0.333 + c_joint2 * r_link3_z + s_joint2 * r_link2_x;
}

void force_jacobian_transpose(const Scalar q[7], Scalar C[21]) noexcept {
  const Scalar s_joint6 = sin(q[5]);
  const Scalar c_joint6 = cos(q[5]);
  const Scalar r_link6_y = 0.088 * s_joint6 - 0.107 * c_joint6;
  const Scalar r_link5_z = 0.384 + r_link6_y;
  const Scalar c_joint4 = cos(q[3]);
  const Scalar s_joint4 = sin(q[3]);
  // link6
  const Scalar r_link6_x = 0.088 * c_joint6 + 0.107 * s_joint6;
  const Scalar c_joint5 = cos(q[4]);
  const Scalar s_joint5 = sin(q[4]);
  const Scalar r_link5_x = c_joint5 * r_link6_x;
  const Scalar r_link4_x = 0.0825 - r_link5_x;
  // link3
  const Scalar r_link3_z = 0.316 + c_joint4 * r_link5_z - s_joint4 * r_link4_x;
  const Scalar s_joint2 = sin(q[1]);
  const Scalar c_joint2 = cos(q[1]);
  const Scalar r_link3_x = 0.0825 - s_joint4 * r_link5_z - c_joint4 * r_link4_x;
  const Scalar c_joint3 = cos(q[2]);
  const Scalar s_joint3 = sin(q[2]);
  const Scalar r_link5_y = s_joint5 * r_link6_x;
  const Scalar t_link3_1 = s_joint3 * r_link5_y - c_joint3 * r_link3_x;
  const Scalar r_link2_x = s_joint2 * r_link3_z - c_joint2 * t_link3_1;
  C[5] = -r_link2_x;
  const Scalar s_joint1 = sin(q[0]);
  const Scalar c_joint1 = cos(q[0]);
  // link2
  const Scalar r_link2_z = c_joint3 * r_link5_y + s_joint3 * r_link3_x;
  C[0] = -(s_joint1 * r_link2_x + c_joint1 * r_link2_z);
  C[1] = c_joint1 * r_link2_x - s_joint1 * r_link2_z;
  const Scalar r_link2_y = c_joint2 * r_link3_z + s_joint2 * t_link3_1;
  C[3] = c_joint1 * r_link2_y;
  C[4] = s_joint1 * r_link2_y;
  // link3
  const Scalar t_link3_2 = c_joint1 * c_joint2;
  const Scalar Rx_link3_y = s_joint1 * c_joint3 + s_joint3 * t_link3_2;
  const Scalar Rx_link3_x = s_joint1 * s_joint3 - c_joint3 * t_link3_2;
  C[6] = Rx_link3_x * r_link5_y - Rx_link3_y * r_link3_x;
  const Scalar t_link3_3 = s_joint1 * c_joint2;
  const Scalar Ry_link3_y = c_joint1 * c_joint3 - s_joint3 * t_link3_3;
  const Scalar Ry_link3_x = c_joint1 * s_joint3 + c_joint3 * t_link3_3;
  C[7] = Ry_link3_y * r_link3_x - Ry_link3_x * r_link5_y;
  const Scalar Rz_link3_y = s_joint2 * s_joint3;
  const Scalar Rz_link3_x = s_joint2 * c_joint3;
  C[8] = Rz_link3_y * r_link3_x + Rz_link3_x * r_link5_y;
  const Scalar Rx_link3_z = c_joint1 * s_joint2;
  // link4
  const Scalar Rx_link4_y = c_joint4 * Rx_link3_z + s_joint4 * Rx_link3_x;
  const Scalar Rx_link4_x = s_joint4 * Rx_link3_z - c_joint4 * Rx_link3_x;
  C[9] = -(Rx_link4_y * r_link4_x + Rx_link4_x * r_link5_z);
  const Scalar Ry_link3_z = s_joint1 * s_joint2;
  const Scalar Ry_link4_y = c_joint4 * Ry_link3_z - s_joint4 * Ry_link3_x;
  const Scalar Ry_link4_x = s_joint4 * Ry_link3_z + c_joint4 * Ry_link3_x;
  C[10] = -(Ry_link4_y * r_link4_x + Ry_link4_x * r_link5_z);
  const Scalar Rz_link4_y = c_joint2 * c_joint4 + s_joint4 * Rz_link3_x;
  const Scalar Rz_link4_x = c_joint2 * s_joint4 - c_joint4 * Rz_link3_x;
  C[11] = -(Rz_link4_y * r_link4_x + Rz_link4_x * r_link5_z);
  // link5
  C[12] = -(Rx_link3_y * r_link5_x + Rx_link4_x * r_link5_y);
  C[13] = Ry_link3_y * r_link5_x - Ry_link4_x * r_link5_y;
  C[14] = Rz_link3_y * r_link5_x - Rz_link4_x * r_link5_y;
  // link6
  const Scalar Rx_link6_x = s_joint5 * Rx_link3_y - c_joint5 * Rx_link4_x;
  C[15] = Rx_link4_y * r_link6_x + Rx_link6_x * r_link6_y;
  const Scalar Ry_link6_x = s_joint5 * Ry_link3_y + c_joint5 * Ry_link4_x;
  C[16] = Ry_link4_y * r_link6_x - Ry_link6_x * r_link6_y;
  const Scalar Rz_link6_x = s_joint5 * Rz_link3_y + c_joint5 * Rz_link4_x;
  C[17] = Rz_link4_y * r_link6_x - Rz_link6_x * r_link6_y;
  C[2] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
}

}  // namespace panda
