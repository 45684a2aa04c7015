// puma560.cpp: see puma560.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate puma560.yaml

#include "puma560.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace puma560 {

static_assert(kDigest == 0x47a8b5d43b3f4cc9ULL, "header and source are of different runs");

#if defined(__FAST_MATH__) || (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 2)
#error "sine_cosine rounds by adding and subtracting: not for -ffast-math or x87; --sincos libm is"
#endif

namespace {

template <class Number>
struct SineCosine {
  Number sine;
  Number cosine;
};

/// Sine and cosine of x without a library and without a branch: x less the nearest multiple of
/// pi/2, k pi/2, part by part; polynomials on [-pi/4, pi/4]; sine and cosine of k pi/2 from k
/// modulo 4; the addition theorem, with factors 0, 1 and -1. Absolute errors below 1.7e-16 for
/// |x| < 1.3e7; not a number for |x| > 1.32e7 and where x is none.
[[gnu::noinline]] SineCosine<double> sine_cosine(double x) noexcept {
  const double k = (x * 0.6366197723675814 + 6755399441055744.0) - 6755399441055744.0;
  const double t = k * 2.1430172143725346e+301;  // infinite beyond the range
  const double r_1 = x - t * 7.32983532344312e-302;
  const double r = r_1 + k * 8.705515695504166e-10;
  const double z = r * r;
  const double s_1 = 1.58969099521155e-10 * z - 2.5050760253406863e-08;
  const double s_2 = s_1 * z + 2.7557313707070068e-06;
  const double s_3 = s_2 * z - 0.0001984126982985795;
  const double s_4 = s_3 * z + 0.00833333333332249;
  const double s_5 = s_4 * z - 0.16666666666666632;
  const double c_1 = -1.1359647557788195e-11 * z + 2.087572321298175e-09;
  const double c_2 = c_1 * z - 2.7557314351390663e-07;
  const double c_3 = c_2 * z + 2.480158728947673e-05;
  const double c_4 = c_3 * z - 0.001388888888887411;
  const double c_5 = c_4 * z + 0.0416666666666666;
  const double sine = r + r * z * s_5;
  const double cosine = 1.0 - z * (0.5 - z * c_5);

  // k modulo 4: -2 to 2, not a number where t is infinite
  const double l = t * 4.6663180925160944e-302;
  const double m = l - ((l + 2.7021597764222976e+16) - 2.7021597764222976e+16);
  const double n = 4.0 - m * m;
  // sine and cosine of m pi/2: 0, 1 or -1
  const double s = m * (n * 0.3333333333333333);
  const double c = 0.5 * (n - s * s) - 1.0;
  return {c * sine + s * cosine, c * cosine - s * sine};
}

/// For other types that stand for Scalar, such as one that counts operations: their own functions.
template <class Number>
SineCosine<Number> sine_cosine(const Number& x) noexcept {
  return {sin(x), cos(x)};
}

}  // namespace

void mass_matrix(const Scalar q[6], Scalar A[36]) noexcept {
  // link3
  const Scalar t_link3_1 = q[1] + q[2];
  const auto [s_link3, c_link3] = sine_cosine(t_link3_1);
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const Scalar t_link3_2 = 21.27093596059113 * c_joint2;
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const Scalar h_link4_z = 5.8464e-05 * c_joint5;
  const Scalar h_link4_x = 5.8464e-05 * s_joint5;
  // link5
  const Scalar t_link5_1 = s_joint5 * s_joint5;
  const Scalar t_link5_2 = 0.00020216 * t_link5_1;
  const Scalar t_link5_3 = 0.002494656 * c_joint5;
  const Scalar t_link4_1 = c_joint4 * h_link4_x;
  const Scalar h_link3_z = s_joint4 * h_link4_x;
  // link4
  const Scalar I_link4_zz = 0.00164 + t_link5_2;
  A[21] = I_link4_zz;
  const Scalar t_link4_2 = s_joint4 * (0.0001 + t_link5_2);
  const Scalar t_link4_3 = 0.001247328 + 0.00020216 * c_joint5;
  const Scalar t_link4_4 = s_joint5 * t_link4_3;
  const Scalar t_link4_5 = c_joint4 * t_link4_4;
  const Scalar t_link4_6 = s_joint4 * t_link4_4;
  A[15] = -t_link4_6;
  A[20] = A[15];
  const Scalar t_link4_7 = 2.0 * t_link4_1;
  // link3
  const Scalar t_link3_3 = t_link4_7 + s_joint4 * t_link4_2;
  const Scalar t_link3_4 = t_link5_3 - t_link3_3;
  const Scalar I_link3_zz = 0.313747409 + t_link3_4;
  A[14] = I_link3_zz;
  const Scalar t_link4_8 = 0.0005151125 - t_link4_1;
  const Scalar t_link4_9 = 0.0174944385 + h_link4_z;
  const Scalar t_link3_5 = 21.27093596059113 * s_joint2;
  const Scalar t_link3_6 = s_link3 * t_link4_8 + c_link3 * t_link4_9;
  const Scalar t_link3_7 = t_link3_5 * t_link3_6;
  const Scalar t_link3_8 = s_link3 * t_link3_2;
  const Scalar t_link3_9 = c_link3 * t_link3_2;
  const Scalar t_link3_10 = t_link4_9 * t_link3_8 - t_link4_8 * t_link3_9;
  const Scalar t_link3_11 = 2.0 * t_link3_10;
  const Scalar I_link3_yz = 0.004704 + t_link4_6;
  const Scalar I_link3_xz = h_link3_z - c_joint4 * t_link4_2;
  const Scalar t_link3_12 = c_link3 * I_link3_yz + 7.394088669950739 * t_link3_6;
  const Scalar t_link3_13 = t_link3_12 + s_link3 * I_link3_xz;
  A[2] = -t_link3_13;
  A[12] = A[2];
  // link2
  const Scalar t_link2_1 = t_link3_13 - 0.023751 * c_joint2;
  A[1] = h_link3_z * t_link3_5 - (t_link2_1 - 0.690314699 * s_joint2);
  A[6] = A[1];
  A[7] = 2.061861411 + t_link3_4 + t_link3_11 - 2.0 * t_link3_7;
  // link3
  const Scalar t_link3_14 = 0.298477184 + t_link5_3 + t_link3_3;
  const Scalar t_link3_15 = c_link3 * (0.021347277 + 2.0 * (h_link4_z - t_link4_5));
  const Scalar t_link3_16 = s_link3 * (t_link3_14 - 0.00040432 * t_link5_1);
  const Scalar t_link3_17 = 0.0141984 * c_joint2;
  const Scalar t_link1_1 = t_link3_11 - (t_link4_7 - (3.155122265 + t_link5_2));
  const Scalar t_link1_2 = t_link1_1 + 14.788177339901479 * h_link3_z;
  const Scalar t_link3_18 = s_joint2 * (t_link3_17 + 1.601861202 * s_joint2);
  A[0] = t_link1_2 + s_link3 * (t_link3_16 - t_link3_15) - t_link3_18;
  const Scalar t_link5_4 = 4e-05 * c_joint5;
  A[23] = t_link5_4;
  A[33] = A[23];
  const Scalar t_link5_5 = 4e-05 * s_joint5;
  A[11] = s_joint4 * t_link5_5;
  A[17] = A[11];
  A[31] = A[11];
  A[32] = A[11];
  A[5] = c_link3 * t_link5_4 - s_link3 * c_joint4 * t_link5_5;
  A[30] = A[5];
  const Scalar t_link5_6 = 0.00064216 + 0.001247328 * c_joint5;
  const Scalar t_link4_10 = h_link4_x - c_joint4 * t_link5_6;
  A[16] = -t_link4_10;
  A[26] = A[16];
  const Scalar t_link4_11 = c_joint4 * h_link4_z;
  const Scalar t_link3_19 = c_link3 - t_link3_2;
  const Scalar t_link3_20 = c_link3 * t_link4_11 - s_link3 * h_link4_x;
  const Scalar t_link3_21 = s_joint4 * (s_link3 * t_link5_6 - h_link4_z * t_link3_19);
  A[4] = t_link3_21 - 7.394088669950739 * t_link3_20;
  A[24] = A[4];
  const Scalar t_link3_22 = t_link4_10 - t_link3_8 * t_link4_11 - h_link4_x * t_link3_9;
  A[10] = -(t_link3_22 + t_link3_5 * t_link3_20);
  A[25] = A[10];
  const Scalar t_link3_23 = c_link3 * (I_link4_zz + 7.394088669950739 * h_link3_z);
  A[3] = s_link3 * t_link4_5 - t_link4_1 * t_link3_19 + t_link3_23;
  A[18] = A[3];
  A[9] = -(t_link4_6 + h_link3_z * (t_link3_8 - c_link3 * t_link3_5));
  A[19] = A[9];
  A[8] = I_link3_zz - t_link3_7 + t_link3_10;
  A[13] = A[8];
  A[28] = 0.00064216;
  A[35] = 4e-05;
  A[22] = 0.0;
  A[27] = 0.0;
  A[29] = 0.0;
  A[34] = 0.0;
}

void bias_force(const Scalar q[6], const Scalar qd[6], Scalar B[6]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  // link4
  const Scalar t_link4_1 = q[1] + q[2];
  const auto [s_link4, c_link4] = sine_cosine(t_link4_1);
  const Scalar s_link4_y = s_link4 + 21.334975369458128 * c_link4;
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const Scalar t_link1_1 = qd[0] * qd[0];
  // link2
  const Scalar t_link2_1 = qd[1] * qd[1];
  const Scalar t_link2_2 = 2.0 * qd[0];
  const Scalar Omega_link2_zy = qd[1] * t_link2_2;
  // link3
  const Scalar t_link3_1 = 21.27093596059113 * s_joint2;
  const Scalar t_link3_2 = 21.27093596059113 * c_joint2;
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar t_link3_3 = omega_link3_z * omega_link3_z;
  // link4
  const Scalar t_link4_2 = s_link4 * qd[0];
  const Scalar t_link4_3 = c_joint4 * omega_link3_z;
  const Scalar omega_link4_y = t_link4_3 + s_joint4 * t_link4_2;
  const Scalar t_link4_4 = c_link4 * qd[0];
  const Scalar t_link4_5 = s_joint4 * omega_link3_z;
  const Scalar omega_link4_x = t_link4_5 - c_joint4 * t_link4_2;
  const Scalar omega_link4_z = qd[3] + t_link4_4;
  const Scalar t_link4_6 = omega_link3_z * t_link4_2;
  // link5
  const Scalar t_link5_1 = c_joint5 * omega_link4_z + s_joint5 * omega_link4_x;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar t_link5_2 = s_joint5 * omega_link4_z - c_joint5 * omega_link4_x;
  const Scalar t_link4_7 = t_link4_3 * t_link4_4 - omega_link4_y * qd[3];
  const Scalar t_link5_3 = c_joint5 * t_link4_6 + s_joint5 * t_link4_7;
  const Scalar alpha_link5_y = t_link5_3 + qd[4] * t_link5_2;
  const Scalar t_link6_1 = 4e-05 * alpha_link5_y;
  B[5] = -t_link6_1;
  const Scalar t_link3_4 = Omega_link2_zy * t_link3_1 + 7.394088669950739 * t_link1_1;
  const Scalar Omega_link3_zy = t_link2_2 * omega_link3_z;
  // link4
  const Scalar t_link4_8 = t_link3_4 - s_link4_y * Omega_link3_zy;
  const Scalar t_link4_9 = t_link2_1 * t_link3_1 - s_link4_y * t_link3_3;
  const Scalar s_link4_x = c_link4 - 21.334975369458128 * s_link4;
  const Scalar t_link3_5 = t_link1_1 + t_link3_3;
  const Scalar t_link4_10 = s_link4_x * t_link3_5 - t_link3_2 * (t_link1_1 + t_link2_1);
  const Scalar t_link4_11 = s_link4 * t_link4_9 - c_link4 * t_link4_10;
  const Scalar alpha_link4_y = t_link4_4 * t_link4_5 - qd[3] * omega_link4_x;
  const Scalar a_link4_z = s_link4 * t_link4_10 + c_link4 * t_link4_9;
  const Scalar t_link5_4 = c_joint5 * (s_joint4 * t_link4_8 + c_joint4 * t_link4_11);
  const Scalar omega_link6_z = t_link5_1 + qd[5];
  // link5
  const Scalar t_link5_5 = 4e-05 * omega_link6_z;
  const Scalar t_link5_6 = 5.8464e-05 * (s_joint5 * a_link4_z + t_link5_4);
  const Scalar t_link5_7 = t_link5_2 * (t_link5_5 - 0.00024216 * t_link5_1);
  const Scalar M_link5_z = 0.00064216 * alpha_link4_y - t_link5_6 + t_link5_7;
  B[4] = M_link5_z;
  const Scalar t_link5_8 = t_link6_1 + omega_link5_z * t_link5_2 * 0.0001;
  const Scalar M_link5_y = t_link5_8 + 0.0003 * alpha_link5_y;
  const Scalar a_link4_y = s_joint4 * t_link4_11 - c_joint4 * t_link4_8;
  const Scalar t_link5_9 = t_link5_1 * omega_link5_z;
  const Scalar t_link5_10 = s_joint5 * t_link4_6 - c_joint5 * t_link4_7;
  const Scalar alpha_link5_x = t_link5_10 - t_link5_1 * qd[4];
  const Scalar t_link5_11 = 0.00034216 * t_link5_9;
  // link6
  const Scalar t_link6_2 = t_link5_11 + 5.8464e-05 * a_link4_y;
  const Scalar t_link6_3 = t_link6_2 - omega_link5_z * t_link5_5;
  const Scalar t_link6_4 = t_link6_3 - 0.00054216 * alpha_link5_x;
  const Scalar t_link5_12 = 0.0013 * t_link4_6 + c_joint5 * M_link5_y;
  const Scalar t_link5_13 = t_link5_12 - s_joint5 * t_link6_4;
  B[3] = -t_link5_13;
  const Scalar Omega_link6_xz = alpha_link4_y - t_link5_1 * t_link5_2;
  const Scalar Omega_link6_yz = t_link5_9 - alpha_link5_x;
  // link5
  const Scalar t_link5_14 = t_link5_2 * t_link5_2 + omega_link5_z * omega_link5_z;
  const Scalar t_link5_15 = s_joint5 * Omega_link6_xz + c_joint5 * t_link5_14;
  const Scalar t_link5_16 = 5.8464e-05 * t_link5_15;
  // link4
  const Scalar t_link4_12 = c_joint5 * Omega_link6_xz - s_joint5 * t_link5_14;
  const Scalar t_link4_13 = c_joint4 * t_link4_12 - s_joint4 * Omega_link6_yz;
  const Scalar t_link4_14 = 5.8464e-05 * t_link4_13;
  const Scalar t_link4_15 = 0.0013 * omega_link4_z;
  const Scalar M_link4_y = M_link5_z - omega_link4_x * t_link4_15;
  const Scalar t_link4_16 = omega_link4_y * t_link4_15 - c_joint5 * t_link6_4;
  const Scalar M_link4_x = t_link4_16 - s_joint5 * M_link5_y;
  // link3
  const Scalar t_link3_6 = 0.010956925 * s_link4 + 0.372123081 * c_link4;
  const Scalar t_link3_7 = c_joint2 * t_link3_6;
  const Scalar t_link3_8 = 0.021347277 * s_link4 + 0.299575024 * c_link4;
  const Scalar t_link3_9 = 0.0106736385 - t_link3_7 - s_link4 * t_link3_8;
  const Scalar t_link3_10 = 0.0005151125 * c_link4 - 0.0174944385 * s_link4;
  // link4
  const Scalar t_link4_17 = s_link4 * t_link5_16 - c_link4 * t_link4_14;
  const Scalar t_link4_18 = c_link4 * t_link5_16 + s_link4 * t_link4_14;
  const Scalar t_link4_19 = c_joint4 * M_link4_y + s_joint4 * M_link4_x;
  // link3
  const Scalar t_link3_11 = t_link2_1 * (t_link3_7 - t_link3_1 * t_link3_10);
  const Scalar t_link3_12 = t_link4_19 + t_link1_1 * t_link3_9 - t_link3_11;
  const Scalar M_link3_z = t_link3_12 - s_link4_y * t_link4_17 - s_link4_x * t_link4_18;
  B[2] = M_link3_z;
  // link2
  const Scalar t_link2_3 = s_joint4 * t_link4_12 + c_joint4 * Omega_link6_yz;
  const Scalar t_link2_4 = 0.0141984 * c_joint2;
  const Scalar t_link2_5 = c_joint2 * (t_link2_4 + 1.601861202 * s_joint2);
  const Scalar t_link2_6 = 0.0070992 - t_link2_5;
  const Scalar t_link2_7 = 0.023751 * s_joint2;
  const Scalar t_link4_20 = s_joint4 * M_link4_y - c_joint4 * M_link4_x;
  const Scalar F_link3_x = t_link4_17 - t_link3_5 * t_link3_10;
  const Scalar t_link2_8 = t_link2_1 * (t_link2_7 - 0.690314699 * c_joint2);
  const Scalar t_link2_9 = s_link4 * (t_link4_20 + 0.004704 * t_link3_3);
  const Scalar t_link2_10 = Omega_link2_zy * t_link2_6 - t_link2_8 + t_link2_9;
  const Scalar t_link2_11 = t_link2_3 * (t_link3_2 - s_link4_x) * 5.8464e-05;
  const Scalar t_link2_12 = t_link2_10 + t_link3_4 * t_link3_10 - c_link4 * t_link5_13;
  const Scalar t_link2_13 = t_link2_12 + t_link2_11 - Omega_link3_zy * t_link3_9;
  B[0] = t_link2_13 + 7.394088669950739 * F_link3_x;
  const Scalar t_link2_14 = M_link3_z + t_link3_2 * t_link4_18 + t_link3_3 * t_link3_7;
  B[1] = t_link2_14 - t_link1_1 * t_link2_6 + t_link3_1 * F_link3_x;
}

void gravity_force(const Scalar q[6], Scalar G[6]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const Scalar t_link4_1 = q[1] + q[2];
  const auto [s_link4, c_link4] = sine_cosine(t_link4_1);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  // link5
  const Scalar t_link5_1 = s_link4 * c_joint5 * 0.0282528;
  const Scalar t_link5_2 = 0.0282528 * s_joint5;
  const Scalar t_link5_3 = c_link4 * t_link5_2;
  G[4] = -(t_link5_3 + c_joint4 * t_link5_1);
  G[3] = s_link4 * s_joint4 * t_link5_2;
  const Scalar t_link3_1 = t_link5_1 + 8.45420895 * s_link4;
  const Scalar t_link3_2 = t_link3_1 - 0.24892875 * c_link4 + c_joint4 * t_link5_3;
  G[2] = -t_link3_2;
  // link2
  G[1] = 1.024164 * s_joint2 - (t_link3_2 + 37.2347379 * c_joint2);
  G[0] = 0.0;
  G[5] = 0.0;
}

void inverse_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar qdd[6],
                      Scalar tau[6]) noexcept {
  // link3
  const Scalar t_link3_1 = q[1] + q[2];
  const auto [s_link3, c_link3] = sine_cosine(t_link3_1);
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const Scalar t_link3_2 = 0.9969983837450935 * c_joint2;
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const Scalar t_link1_1 = qd[0] * qd[0];
  const Scalar t_link2_1 = qd[1] * qd[1];
  const Scalar t_link3_3 = 0.9969983837450935 * s_joint2;
  const Scalar omega_link3_x = c_link3 * qd[0];
  const Scalar t_link3_4 = omega_link3_x * omega_link3_x;
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar t_link3_5 = omega_link3_z * omega_link3_z;
  const Scalar Omega_link3_zx = s_link3 * qdd[0] + omega_link3_x * omega_link3_z * 2.0;
  const Scalar t_link3_6 = s_link3 * qd[0];
  const Scalar t_link3_7 = omega_link3_z * t_link3_6;
  const Scalar t_link3_8 = c_link3 * qdd[0];
  const Scalar t_link3_9 = t_link3_7 - t_link3_8;
  const Scalar t_link3_10 = t_link3_7 + t_link3_9;
  const Scalar t_link3_11 = omega_link3_x * t_link3_6;
  const Scalar alpha_link3_z = qdd[1] + qdd[2];
  const Scalar t_link3_12 = t_link3_11 - alpha_link3_z;
  const Scalar alpha_link2_x = qd[0] * qd[1];
  const Scalar Omega_link2_zy = 2.0 * alpha_link2_x;
  const Scalar t_link3_13 = qdd[1] * t_link3_3 + 0.3465712306626645 * qdd[0];
  const Scalar t_link3_14 = t_link3_13 + t_link3_2 * (t_link1_1 + t_link2_1);
  const Scalar t_link3_15 = 22.650658046640498 + t_link2_1 * t_link3_3;
  const Scalar t_link3_16 = t_link3_15 - t_link3_2 * qdd[1];
  const Scalar t_link3_17 = s_link3 * t_link3_16 + c_link3 * t_link3_14;
  const Scalar t_link3_18 = t_link3_4 + t_link3_5;
  const Scalar t_link4_1 = t_link3_12 + t_link3_17 - 0.04687139228815516 * t_link3_18;
  const Scalar t_link3_19 = t_link3_3 * Omega_link2_zy - t_link3_2 * qdd[0];
  const Scalar t_link3_20 = t_link3_19 + 0.3465712306626645 * t_link1_1;
  // link4
  const Scalar t_link4_2 = Omega_link3_zx - t_link3_20 + 0.04687139228815516 * t_link3_10;
  const Scalar omega_link4_z = omega_link3_x + qd[3];
  const Scalar t_link4_3 = c_joint4 * t_link3_6 - s_joint4 * omega_link3_z;
  const Scalar t_link4_4 = omega_link4_z * t_link4_3;
  const Scalar t_link3_21 = t_link3_4 - t_link3_5;
  const Scalar t_link3_22 = t_link1_1 - t_link3_21;
  const Scalar t_link4_5 = t_link3_22 - 0.04687139228815516 * (t_link3_11 + alpha_link3_z);
  const Scalar t_link4_6 = t_link4_5 + s_link3 * t_link3_14 - c_link3 * t_link3_16;
  const Scalar omega_link4_y = s_joint4 * t_link3_6 + c_joint4 * omega_link3_z;
  const Scalar t_link4_7 = omega_link4_z * omega_link4_y;
  // link5
  const Scalar t_link5_1 = c_joint5 * omega_link4_z - s_joint5 * t_link4_3;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar t_link5_2 = s_joint5 * omega_link4_z + c_joint5 * t_link4_3;
  const Scalar t_link4_8 = t_link3_9 - qdd[3];
  const Scalar alpha_link4_x = t_link4_7 - c_joint4 * Omega_link3_zx - s_joint4 * t_link3_12;
  const Scalar t_link5_3 = c_joint5 * t_link4_8 + qd[4] * t_link5_2;
  const Scalar alpha_link5_y = t_link5_3 - s_joint5 * alpha_link4_x;
  // link6
  const Scalar alpha_link6_z = qdd[5] - alpha_link5_y;
  const Scalar M_link6_z = 4e-05 * alpha_link6_z;
  tau[5] = M_link6_z;
  const Scalar omega_link6_z = t_link5_1 + qd[5];
  const Scalar t_link5_4 = 4e-05 * omega_link6_z;
  const Scalar t_link4_9 = c_joint4 * t_link4_1 - s_joint4 * t_link4_2;
  // link5
  const Scalar t_link5_5 = t_link4_4 + qdd[4] + s_joint4 * Omega_link3_zx;
  const Scalar alpha_link5_z = t_link5_5 - c_joint4 * t_link3_12;
  const Scalar t_link5_6 = 0.001247328 * c_joint5;
  const Scalar t_link5_7 = 0.001247328 * s_joint5;
  const Scalar t_link5_8 = 0.00064216 * alpha_link5_z - t_link4_9 * t_link5_6;
  const Scalar t_link5_9 = t_link5_2 * (t_link5_4 - 0.00024216 * t_link5_1);
  const Scalar M_link5_z = t_link5_8 + t_link4_6 * t_link5_7 + t_link5_9;
  tau[4] = M_link5_z;
  const Scalar t_link5_10 = omega_link5_z * t_link5_2 * 0.0001;
  const Scalar t_link6_1 = M_link6_z - 0.0003 * alpha_link5_y - t_link5_10;
  const Scalar a_link4_y = s_joint4 * t_link4_1 + c_joint4 * t_link4_2;
  const Scalar t_link5_11 = s_joint5 * t_link4_8 - t_link5_1 * qd[4];
  const Scalar alpha_link5_x = t_link5_11 + c_joint5 * alpha_link4_x;
  const Scalar t_link5_12 = 0.00054216 * alpha_link5_x;
  const Scalar t_link6_2 = omega_link5_z * (t_link5_4 - 0.00034216 * t_link5_1);
  const Scalar t_link6_3 = 0.001247328 * a_link4_y - t_link5_12 - t_link6_2;
  const Scalar t_link4_10 = s_joint5 * t_link6_3 - 0.0013 * t_link4_8;
  const Scalar M_link4_z = t_link4_10 + c_joint5 * t_link6_1;
  tau[3] = M_link4_z;
  const Scalar Omega_link5_zy = alpha_link5_x - t_link5_1 * omega_link5_z;
  const Scalar t_link5_13 = 0.001247328 * Omega_link5_zy;
  const Scalar F_link4_y = 0.2344695125 * a_link4_y - t_link5_13;
  const Scalar t_link5_14 = t_link5_2 * t_link5_2 + omega_link5_z * omega_link5_z;
  const Scalar t_link5_15 = alpha_link5_z - t_link5_1 * t_link5_2;
  const Scalar t_link5_16 = t_link5_7 * t_link5_14 - t_link5_6 * t_link5_15;
  const Scalar t_link5_17 = t_link5_16 + 0.2344695125 * t_link4_9;
  const Scalar t_link4_11 = c_joint4 * t_link5_17 + s_joint4 * F_link4_y;
  const Scalar t_link5_18 = t_link5_6 * t_link5_14 + 0.2344695125 * t_link4_6;
  const Scalar t_link5_19 = t_link5_18 + t_link5_7 * t_link5_15;
  // link4
  const Scalar t_link4_12 = 0.0013 * t_link4_7 - c_joint5 * t_link6_3;
  const Scalar M_link4_x = t_link4_12 + s_joint5 * t_link6_1;
  const Scalar M_link4_y = M_link5_z + 0.0013 * t_link4_4;
  const Scalar t_link4_13 = t_link4_11 + 0.004704 * t_link3_8;
  const Scalar t_link4_14 = t_link4_13 + 0.04687139228815516 * t_link5_19;
  const Scalar t_link4_15 = t_link4_14 + 0.065620624 * t_link3_11;
  const Scalar t_link4_16 = t_link4_15 - 0.078120624 * alpha_link3_z;
  const Scalar t_link3_23 = 0.000316274 * (t_link3_18 - t_link3_22);
  const Scalar t_link4_17 = t_link4_16 + 0.138773902 * t_link3_17 + t_link3_23;
  const Scalar t_link4_18 = t_link4_17 - s_joint4 * M_link4_x - c_joint4 * M_link4_y;
  tau[2] = -t_link4_18;
  const Scalar t_link4_19 = t_link4_11 + 0.138773902 * t_link3_12;
  const Scalar t_link4_20 = t_link5_19 + 0.138773902 * t_link3_22;
  // link2
  const Scalar t_link2_2 = 1.368797152 * s_joint2;
  const Scalar t_link2_3 = t_link2_2 + 0.0141984 * c_joint2;
  const Scalar t_link2_4 = 0.0070992 - c_joint2 * t_link2_3;
  const Scalar t_link3_24 = c_link3 * t_link4_19 + s_link3 * t_link4_20;
  const Scalar t_link2_5 = 0.609298224 * s_joint2;
  const Scalar t_link2_6 = t_link2_5 + 0.023751 * c_joint2;
  // link3
  const Scalar t_link3_25 = t_link4_18 - 1.515049952 * qdd[1];
  const Scalar t_link3_26 = t_link3_2 * (s_link3 * t_link4_19 - c_link3 * t_link4_20);
  const Scalar t_link3_27 = t_link3_25 + 31.9397904 * c_joint2 + t_link3_26;
  const Scalar t_link3_28 = 1.024164 + 0.9969983837450935 * t_link3_24;
  const Scalar t_link3_29 = t_link3_27 + t_link1_1 * t_link2_4 - s_joint2 * t_link3_28;
  // link2
  tau[1] = qdd[0] * t_link2_6 - t_link3_29;
  const Scalar t_link2_7 = 0.609298224 * c_joint2;
  const Scalar t_link2_8 = t_link2_7 - 0.023751 * s_joint2;
  const Scalar t_link4_21 = c_joint4 * F_link4_y - s_joint4 * t_link5_17;
  // link3
  const Scalar t_link3_30 = M_link4_z + 0.000316274 * Omega_link3_zx;
  const Scalar t_link3_31 = t_link3_30 + 0.004704 * t_link3_12;
  const Scalar t_link3_32 = t_link3_31 - 0.00625 * t_link3_10;
  const Scalar M_link3_x = t_link3_32 - 0.04687139228815516 * t_link4_21;
  // link4
  const Scalar t_link4_22 = t_link4_21 - 0.004704 * t_link3_21;
  const Scalar t_link4_23 = t_link4_22 - 0.000316274 * t_link3_10;
  const Scalar t_link4_24 = t_link4_23 + 0.071870624 * Omega_link3_zx;
  const Scalar t_link4_25 = t_link4_24 + s_joint4 * M_link4_y - c_joint4 * M_link4_x;
  const Scalar F_link3_z = t_link4_21 + 0.138773902 * Omega_link3_zx;
  // link2
  const Scalar t_link2_9 = qdd[1] * t_link2_6 + t_link2_1 * t_link2_8;
  const Scalar t_link2_10 = t_link2_9 + 0.3465712306626645 * t_link3_24;
  const Scalar t_link2_11 = t_link2_10 + Omega_link2_zy * t_link2_4 + c_link3 * M_link3_x;
  const Scalar t_link2_12 = qdd[0] * (2.88549059 - s_joint2 * t_link2_3);
  const Scalar t_link3_33 = s_link3 * (t_link4_25 - 0.138773902 * t_link3_20);
  // link1
  tau[0] = t_link2_11 + t_link2_12 + t_link3_33 + t_link3_2 * F_link3_z;
}

void forward_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar tau[6],
                      Scalar qdd[6]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  // link4
  const Scalar t_link4_1 = q[1] + q[2];
  const auto [s_link4, c_link4] = sine_cosine(t_link4_1);
  const Scalar t_link4_2 = 1.0030106530801297 * s_link4 - 0.04701250578971746 * c_link4;
  const Scalar s_link4_y = 0.04701250578971746 * s_link4 + 1.0030106530801297 * c_link4;
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const Scalar t_link1_1 = qd[0] * qd[0];
  // link2
  const Scalar t_link2_1 = qd[1] * qd[1];
  const Scalar t_link2_2 = 0.0141984 * c_joint2;
  const Scalar t_link2_3 = t_link2_2 + 1.601861202 * s_joint2;
  const Scalar t_link2_4 = 0.0070992 - c_joint2 * t_link2_3;
  const Scalar t_link2_5 = 2.0 * qd[0];
  const Scalar Omega_link2_zy = qd[1] * t_link2_5;
  // link3
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar t_link3_1 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_2 = 0.010956925 * c_link4 - 0.372123081 * s_link4;
  const Scalar t_link3_3 = 0.010956925 * s_link4 + 0.372123081 * c_link4;
  const Scalar t_link3_4 = t_link1_1 + t_link3_1;
  const Scalar t_link4_3 = c_joint2 * (t_link1_1 + t_link2_1) + t_link4_2 * t_link3_4;
  const Scalar a_link3_y = 22.71885132005558 + s_joint2 * t_link2_1;
  // link4
  const Scalar t_link4_4 = a_link3_y - s_link4_y * t_link3_1;
  const Scalar t_link4_5 = c_link4 * t_link4_3 + s_link4 * t_link4_4;
  const Scalar t_link4_6 = s_link4 * qd[0];
  const Scalar t_link4_7 = c_joint4 * omega_link3_z;
  const Scalar t_link4_8 = t_link4_7 + s_joint4 * t_link4_6;
  const Scalar t_link4_9 = c_link4 * qd[0];
  const Scalar t_link4_10 = s_joint4 * omega_link3_z;
  const Scalar t_link4_11 = t_link4_10 - c_joint4 * t_link4_6;
  const Scalar omega_link4_z = qd[3] + t_link4_9;
  const Scalar t_link4_12 = omega_link3_z * t_link4_6;
  // link5
  const Scalar t_link5_1 = c_joint5 * omega_link4_z + s_joint5 * t_link4_11;
  const Scalar omega_link5_z = t_link4_8 + qd[4];
  const Scalar t_link5_2 = s_joint5 * omega_link4_z - c_joint5 * t_link4_11;
  const Scalar alpha_link5_z = t_link4_9 * t_link4_10 - qd[3] * t_link4_11;
  const Scalar t_link5_3 = t_link5_1 * t_link5_2;
  const Scalar t_link5_4 = alpha_link5_z - t_link5_3;
  const Scalar alpha_link4_x = t_link4_7 * t_link4_9 - t_link4_8 * qd[3];
  const Scalar t_link5_5 = c_joint5 * t_link4_12 + qd[4] * t_link5_2;
  const Scalar alpha_link5_y = t_link5_5 + s_joint5 * alpha_link4_x;
  const Scalar t_link6_1 = 4e-05 * alpha_link5_y;
  const Scalar omega_link6_z = t_link5_1 + qd[5];
  const Scalar t_link5_6 = 4e-05 * omega_link6_z;
  const Scalar t_link5_7 = t_link5_6 - 0.00034216 * t_link5_1;
  const Scalar Omega_link3_zy = t_link2_5 * omega_link3_z;
  const Scalar t_link3_5 = s_joint2 * Omega_link2_zy + 0.3476146364057434 * t_link1_1;
  const Scalar t_link4_13 = t_link3_5 - s_link4_y * Omega_link3_zy;
  const Scalar t_link5_8 = s_joint5 * t_link4_12 - c_joint5 * alpha_link4_x;
  const Scalar alpha_link5_x = t_link5_8 - t_link5_1 * qd[4];
  const Scalar h_link4_z = 0.001243584 * c_joint5;
  const Scalar t_link5_9 = 0.001243584 * s_joint5;
  const Scalar t_link5_10 = t_link5_2 * t_link5_2 + omega_link5_z * omega_link5_z;
  const Scalar Omega_link5_zy = alpha_link5_x - t_link5_1 * omega_link5_z;
  // link4
  const Scalar F_link4_y = 0.001243584 * Omega_link5_zy;
  const Scalar t_link4_14 = c_link4 * t_link5_9;
  const Scalar a_link4_x = c_joint4 * t_link4_5 + s_joint4 * t_link4_13;
  const Scalar t_link4_15 = s_link4 * t_link5_9;
  const Scalar t_link1_2 = t_link6_1 + tau[5];
  // link5
  const Scalar t_link5_11 = 0.00020216 * s_joint5;
  const Scalar t_link5_12 = s_joint5 * t_link5_11;
  const Scalar t_link5_13 = 4e-05 * c_joint5;
  const Scalar t_link5_14 = 4e-05 * s_joint5;
  const Scalar t_link4_16 = s_link4 * c_joint4;
  const Scalar t_link4_17 = c_link4 * t_link5_13 - t_link5_14 * t_link4_16;
  const Scalar h_link3_y = t_link3_3 + 31.0896 * t_link4_17;
  const Scalar t_link4_18 = c_joint4 * t_link5_9;
  const Scalar t_link4_19 = s_link4 * h_link4_z;
  const Scalar h_link3_z = s_joint4 * t_link5_9;
  // link4
  const Scalar t_link4_20 = s_joint4 * (0.0001 + t_link5_12);
  const Scalar t_link4_21 = s_joint4 * t_link4_20;
  const Scalar I_link4_xz = c_joint5 * t_link5_11;
  const Scalar t_link4_22 = s_joint4 * I_link4_xz;
  const Scalar t_link4_23 = t_link4_19 + c_link4 * t_link4_18;
  const Scalar t_link4_24 = t_link4_2 * t_link4_23 * 2.0;
  // link3
  const Scalar t_link3_6 = s_joint2 * h_link3_y;
  const Scalar h_link3_x = t_link3_2 - t_link4_23;
  const Scalar t_link3_7 = c_joint2 * h_link3_x;
  const Scalar t_link3_8 = 2.0 * t_link3_7;
  // link4
  const Scalar t_link4_25 = s_joint4 * t_link5_14;
  const Scalar t_link4_26 = c_link4 * c_joint4;
  const Scalar t_link4_27 = t_link4_15 - h_link4_z * t_link4_26;
  const Scalar t_link4_28 = t_link4_14 + c_joint4 * t_link4_19;
  const Scalar t_link4_29 = 0.00064216 * c_joint4 - s_link4_y * t_link4_27;
  const Scalar t_link4_30 = t_link4_29 + t_link4_2 * t_link4_28;
  // link3
  const Scalar t_link3_9 = c_joint2 * t_link4_28 + s_joint2 * t_link4_27;
  const Scalar t_link3_10 = t_link4_30 + t_link3_9;
  const Scalar t_link3_11 = c_joint2 + t_link4_2;
  const Scalar t_link3_12 = 0.00064216 * s_link4 + h_link4_z * t_link3_11;
  const Scalar t_link3_13 = s_joint4 * t_link3_12 + 0.3476146364057434 * t_link4_27;
  const Scalar I_link4_zz = 0.00164 + t_link5_12;
  // link6
  const Scalar t_link6_2 = c_link4 * (I_link4_zz + 0.3476146364057434 * h_link3_z);
  const Scalar t_link6_3 = c_joint5 * (t_link4_17 - t_link5_11 * t_link4_16);
  const Scalar t_link6_4 = t_link4_18 * t_link3_11 + t_link6_2 - t_link6_3;
  const Scalar t_link3_14 = h_link3_z * (c_joint2 * s_link4 - s_joint2 * c_link4);
  const Scalar t_link6_5 = t_link4_22 + c_joint5 * t_link4_25;
  const Scalar t_link6_6 = t_link6_5 + 1.0030106530801297 * h_link3_z;
  const Scalar t_link6_7 = t_link3_14 + t_link6_6;
  const Scalar inverse_pivot_link4 = 1.0 / (I_link4_zz - c_joint5 * t_link5_13);
  const Scalar t_link5_15 = 1557.2443004858603 * t_link4_30;
  const Scalar t_link4_31 = t_link6_6 * inverse_pivot_link4;
  const Scalar t_link6_8 = t_link4_25 * t_link4_25 * 25000.0;
  const Scalar t_link4_32 = s_link4_y * t_link4_17 * 62.1792;
  const Scalar t_link6_9 = t_link4_21 - t_link4_24 + t_link6_8 - t_link4_32;
  const Scalar t_link5_16 = 0.313747409 - t_link6_9 - t_link4_30 * t_link5_15;
  // link4
  const Scalar t_link4_33 = t_link5_16 - t_link6_6 * t_link4_31;
  const Scalar t_link4_34 = t_link4_33 - (t_link3_6 + t_link3_7) - t_link3_14 * t_link4_31;
  const Scalar t_link4_35 = t_link4_34 - t_link3_9 * t_link5_15;
  const Scalar t_link5_17 = 1557.2443004858603 * t_link3_13;
  const Scalar t_link6_10 = 25000.0 * t_link4_17;
  const Scalar t_link4_36 = t_link6_4 * inverse_pivot_link4;
  const Scalar t_link3_15 = c_link4 * (0.004704 + t_link4_22);
  const Scalar I_link3_yz = t_link4_16 * t_link4_20 - t_link3_15 - s_link4_y * h_link3_z;
  const Scalar t_link4_37 = I_link3_yz - t_link4_25 * t_link6_10 - t_link3_13 * t_link5_15;
  const Scalar t_link4_38 = t_link4_37 + t_link6_6 * t_link4_36;
  const Scalar t_link4_39 = t_link4_38 - 0.3476146364057434 * h_link3_y;
  const Scalar inverse_pivot_link3 = 1.0 / t_link4_33;
  const Scalar t_link5_18 = 1557.2443004858603 * t_link3_10;
  const Scalar t_link3_16 = t_link4_35 * inverse_pivot_link3;
  const Scalar t_link4_40 = t_link6_7 * inverse_pivot_link4;
  const Scalar t_link6_11 = t_link6_9 - (2.061861411 - t_link3_8);
  const Scalar t_link5_19 = t_link6_11 + 2.0 * t_link3_6 + t_link3_10 * t_link5_18;
  const Scalar t_link3_17 = t_link5_19 + t_link6_7 * t_link4_40 + t_link4_35 * t_link3_16;
  const Scalar t_link2_6 = 1.0 / t_link3_17;
  const Scalar t_link3_18 = 0.021347277 * c_link4 - 0.299575024 * s_link4;
  const Scalar t_link4_41 = s_link4 * (0.00109784 - t_link4_21 + 2.0 * t_link5_12);
  // link3
  const Scalar t_link3_19 = t_link4_39 * inverse_pivot_link3;
  const Scalar t_link3_20 = t_link4_39 + 0.023751 * c_joint2;
  const Scalar t_link3_21 = t_link3_20 - t_link3_9 * t_link5_17 + t_link3_14 * t_link4_36;
  const Scalar t_link3_22 = s_joint2 * (0.690314699 + h_link3_z);
  const Scalar t_link3_23 = t_link3_21 - t_link4_39 * t_link3_16 + t_link3_22;
  // link2
  const Scalar t_link2_7 = t_link2_6 * t_link3_23;
  const Scalar t_link2_8 = t_link3_8 - (3.155122265 + t_link5_12 + t_link4_24);
  const Scalar t_link2_9 = t_link2_8 - 0.6952292728114868 * h_link3_z;
  const Scalar t_link2_10 = s_link4 * (t_link3_18 - I_link4_xz * t_link4_26 * 2.0 + t_link4_41);
  const Scalar t_link2_11 = t_link2_9 + t_link3_13 * t_link5_17 + s_joint2 * t_link2_3;
  const Scalar t_link2_12 = t_link2_11 + t_link2_10 - t_link3_23 * t_link2_7;
  const Scalar t_link2_13 = t_link2_12 + t_link6_4 * t_link4_36 + t_link4_39 * t_link3_19;
  const Scalar t_link1_3 = 1.0 / (t_link2_13 + t_link4_17 * t_link6_10);
  const Scalar a_link4_y = c_joint4 * t_link4_13 - s_joint4 * t_link4_5;
  // link5
  const Scalar t_link5_20 = 0.00054216 * alpha_link5_x;
  const Scalar t_link5_21 = t_link5_20 + 0.001243584 * a_link4_y;
  const Scalar M_link5_x = t_link5_21 + omega_link5_z * t_link5_7;
  const Scalar t_link5_22 = t_link6_1 + 0.0003 * alpha_link5_y;
  const Scalar M_link5_y = t_link5_22 + omega_link5_z * t_link5_2 * 0.0001;
  const Scalar t_link5_23 = 0.0013 * t_link4_12 + s_joint5 * M_link5_x;
  const Scalar t_link5_24 = t_link5_23 + c_joint5 * M_link5_y;
  const Scalar t_link1_4 = tau[3] + t_link5_24 - c_joint5 * t_link1_2;
  const Scalar t_link1_5 = c_joint2 * t_link3_3;
  const Scalar t_link5_25 = t_link5_4 * t_link5_9 + h_link4_z * t_link5_10;
  const Scalar t_link5_26 = t_link5_4 * h_link4_z - t_link5_9 * t_link5_10;
  const Scalar t_link4_42 = s_joint4 * F_link4_y + c_joint4 * t_link5_26;
  const Scalar t_link1_6 = 0.0106736385 + t_link1_5 - c_link4 * t_link3_18;
  // link6
  const Scalar t_link6_12 = h_link4_z * a_link4_x - 0.00064216 * alpha_link5_z;
  const Scalar t_link6_13 = t_link6_12 - t_link4_3 * t_link4_15;
  const Scalar t_link6_14 = t_link6_13 + 0.00024216 * t_link5_3;
  const Scalar t_link6_15 = t_link6_14 - t_link5_2 * t_link5_6 + t_link4_4 * t_link4_14;
  const Scalar t_link1_7 = tau[4] + t_link6_15;
  const Scalar t_link1_8 = 1557.2443004858603 * t_link1_7;
  // link4
  const Scalar t_link4_43 = 0.0013 * omega_link4_z;
  const Scalar M_link4_y = t_link6_15 + t_link4_11 * t_link4_43;
  const Scalar t_link4_44 = c_link4 * t_link5_25 + s_link4 * t_link4_42;
  const Scalar M_link4_x = s_joint5 * M_link5_y - c_joint5 * M_link5_x - t_link4_8 * t_link4_43;
  const Scalar t_link4_45 = c_link4 * t_link4_42 - s_link4 * t_link5_25;
  const Scalar t_link4_46 = t_link4_45 + t_link3_2 * t_link3_4;
  // link1
  const Scalar t_link1_9 = 1.024164 - t_link4_46;
  const Scalar t_link1_10 = 37.2347379 - t_link4_44 - t_link3_1 * t_link3_3;
  const Scalar t_link1_11 = s_joint4 * (M_link4_x - s_joint5 * t_link1_2);
  const Scalar t_link1_12 = t_link2_1 * t_link1_5 + t_link1_11 - t_link4_2 * t_link4_44;
  const Scalar t_link1_13 = t_link1_12 + t_link1_1 * t_link1_6 - s_link4_y * t_link4_45;
  const Scalar t_link1_14 = t_link1_13 - t_link4_30 * t_link1_8 + c_joint4 * M_link4_y;
  const Scalar t_link1_15 = t_link1_14 - t_link3_2 * a_link3_y;
  const Scalar t_link1_16 = tau[2] + t_link1_15 + t_link4_31 * t_link1_4;
  const Scalar t_link1_17 = inverse_pivot_link4 * t_link1_4;
  const Scalar t_link4_47 = c_joint4 * F_link4_y - s_joint4 * t_link5_26;
  const Scalar t_link1_18 = tau[1] + t_link1_15 - s_joint2 * t_link1_9 + c_joint2 * t_link1_10;
  const Scalar t_link1_19 = t_link1_18 - t_link3_9 * t_link1_8 + t_link1_1 * t_link2_4;
  const Scalar t_link2_14 = 0.023751 * s_joint2;
  const Scalar t_link1_20 = t_link1_19 - t_link3_16 * t_link1_16 + t_link4_40 * t_link1_4;
  const Scalar t_link1_21 = t_link2_6 * t_link1_20;
  const Scalar t_link1_22 = c_joint4 * M_link4_x + 0.004704 * t_link3_1;
  const Scalar t_link1_23 = tau[0] - t_link3_2 * t_link3_5 - t_link5_17 * t_link1_7;
  const Scalar t_link1_24 = t_link1_23 - t_link2_4 * Omega_link2_zy + t_link3_23 * t_link1_21;
  const Scalar t_link1_25 = t_link1_24 + t_link3_11 * t_link4_47 - t_link6_4 * t_link1_17;
  const Scalar t_link2_15 = t_link2_1 * (t_link2_14 - 0.690314699 * c_joint2);
  const Scalar t_link1_26 = t_link1_25 + c_link4 * t_link5_24 - t_link1_2 * t_link6_10;
  const Scalar t_link1_27 = t_link1_26 + t_link2_15 + 0.3476146364057434 * t_link4_46;
  const Scalar t_link1_28 = s_link4 * (t_link1_22 - s_joint4 * M_link4_y);
  const Scalar t_link1_29 = t_link1_27 - Omega_link3_zy * t_link1_6 - t_link1_28;
  const Scalar t_link1_30 = t_link1_3 * (t_link1_29 - t_link3_19 * t_link1_16);
  qdd[0] = -t_link1_30;
  const Scalar t_link1_31 = t_link1_21 + t_link2_7 * t_link1_30;
  qdd[1] = -t_link1_31;
  const Scalar t_link1_32 = inverse_pivot_link3 * t_link1_16 + t_link3_19 * t_link1_30;
  const Scalar t_link1_33 = t_link1_32 + t_link3_16 * t_link1_31;
  qdd[2] = t_link1_33;
  const Scalar t_link1_34 = t_link1_17 + t_link4_31 * t_link1_33 + t_link4_36 * t_link1_30;
  const Scalar t_link1_35 = t_link1_34 - t_link4_40 * t_link1_31;
  qdd[3] = t_link1_35;
  const Scalar t_link1_36 = t_link4_25 * (t_link1_31 - t_link1_33);
  const Scalar t_link1_37 = t_link1_2 + t_link4_17 * t_link1_30 + t_link1_36;
  qdd[5] = 25000.0 * t_link1_37 - c_joint5 * t_link1_35;
  const Scalar t_link1_38 = t_link1_8 - t_link5_15 * t_link1_33 + t_link5_17 * t_link1_30;
  qdd[4] = t_link1_38 + t_link5_18 * t_link1_31;
}

}  // namespace puma560
