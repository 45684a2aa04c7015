// quadruped.cpp: see quadruped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate quadruped.yaml

#include "quadruped.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace quadruped {

static_assert(kDigest == 0xe2edac829e6c7f73ULL, "header and source are of different runs");

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
[[gnu::noinline, maybe_unused]] SineCosine<double> sine_cosine(double x) noexcept {
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

[[maybe_unused]] inline double sin(double x) noexcept { return sine_cosine(x).sine; }
[[maybe_unused]] inline double cos(double x) noexcept { return sine_cosine(x).cosine; }

}  // namespace

void mass_matrix(const Scalar q[12], Scalar A[144]) noexcept {
  const auto [s_front_left_hip, c_front_left_hip] = sine_cosine(q[1]);
  const auto [s_front_right_hip, c_front_right_hip] = sine_cosine(q[4]);
  const auto [s_hind_left_hip, c_hind_left_hip] = sine_cosine(q[7]);
  // hind_right_shank
  const auto [s_hind_right_hip, c_hind_right_hip] = sine_cosine(q[10]);
  const Scalar t_hind_right_shank_1 = q[10] + q[11];
  const auto [s_hind_right_shank, c_hind_right_shank] = sine_cosine(t_hind_right_shank_1);
  const Scalar t_hind_right_shank_2 = s_hind_right_hip * s_hind_right_shank;
  const Scalar t_hind_right_shank_3 = c_hind_right_hip * c_hind_right_shank;
  const Scalar t_hind_right_shank_4 = 0.001631872 * t_hind_right_shank_3;
  const Scalar t_hind_right_shank_5 = 0.000242048 * s_hind_right_shank;
  A[119] = -t_hind_right_shank_5;
  A[141] = A[119];
  A[118] = 0.000245 * c_hind_right_hip - (t_hind_right_shank_5 + 0.001819852 * s_hind_right_hip);
  A[129] = A[118];
  A[130] = 0.005638328 + t_hind_right_shank_4 + 0.001631872 * t_hind_right_shank_2;
  const Scalar t_hind_right_shank_6 = s_hind_right_shank * s_hind_right_shank * 0.000477144;
  const Scalar t_hind_right_shank_7 = 0.004624184 * s_hind_right_hip + 2.6e-05 * c_hind_right_hip;
  const Scalar t_hind_right_hip_1 = 0.01069944 + t_hind_right_shank_4 - t_hind_right_shank_6;
  A[117] = t_hind_right_hip_1 - s_hind_right_hip * t_hind_right_shank_7;
  // hind_left_shank
  const Scalar t_hind_left_shank_1 = q[7] + q[8];
  const auto [s_hind_left_shank, c_hind_left_shank] = sine_cosine(t_hind_left_shank_1);
  const Scalar t_hind_left_shank_2 = c_hind_left_hip * c_hind_left_shank;
  const Scalar t_hind_left_shank_3 = 0.001631872 * t_hind_left_shank_2;
  const Scalar t_hind_left_shank_4 = s_hind_left_hip * s_hind_left_shank;
  const Scalar t_hind_left_shank_5 = 0.000242048 * s_hind_left_shank;
  A[80] = t_hind_left_shank_5;
  A[102] = A[80];
  A[79] = t_hind_left_shank_5 + 0.001819852 * s_hind_left_hip - 0.000245 * c_hind_left_hip;
  A[90] = A[79];
  A[91] = 0.005638328 + t_hind_left_shank_3 + 0.001631872 * t_hind_left_shank_4;
  const Scalar t_hind_left_shank_6 = s_hind_left_shank * s_hind_left_shank * 0.000477144;
  const Scalar t_hind_left_shank_7 = 2.6e-05 * c_hind_left_hip + 0.004624184 * s_hind_left_hip;
  const Scalar t_hind_left_hip_1 = 0.01069944 + t_hind_left_shank_3 - t_hind_left_shank_6;
  A[78] = t_hind_left_hip_1 - s_hind_left_hip * t_hind_left_shank_7;
  // front_right_shank
  const Scalar t_fron_righ_shan_1 = q[4] + q[5];
  const auto [s_fron_righ_shan, c_fron_righ_shan] = sine_cosine(t_fron_righ_shan_1);
  const Scalar t_fron_righ_shan_2 = s_front_right_hip * s_fron_righ_shan;
  const Scalar t_fron_righ_shan_3 = c_front_right_hip * c_fron_righ_shan;
  const Scalar t_fron_righ_shan_4 = 0.001631872 * t_fron_righ_shan_3;
  const Scalar t_fron_righ_shan_5 = 0.000242048 * s_fron_righ_shan;
  A[41] = -t_fron_righ_shan_5;
  A[63] = A[41];
  A[40] = 0.000245 * c_front_right_hip - (t_fron_righ_shan_5 + 0.001819852 * s_front_right_hip);
  A[51] = A[40];
  A[52] = 0.005638328 + t_fron_righ_shan_4 + 0.001631872 * t_fron_righ_shan_2;
  const Scalar t_fron_righ_shan_6 = s_fron_righ_shan * s_fron_righ_shan * 0.000477144;
  const Scalar t_fron_righ_shan_7 = 2.6e-05 * c_front_right_hip + 0.004624184 * s_front_right_hip;
  const Scalar t_front_right_hip_1 = 0.01069944 + t_fron_righ_shan_4 - t_fron_righ_shan_6;
  A[39] = t_front_right_hip_1 - s_front_right_hip * t_fron_righ_shan_7;
  // front_left_shank
  const Scalar t_front_left_shank_1 = q[1] + q[2];
  const auto [s_front_left_shank, c_front_left_shank] = sine_cosine(t_front_left_shank_1);
  const Scalar t_front_left_shank_2 = c_front_left_hip * c_front_left_shank;
  const Scalar t_front_left_shank_3 = 0.001631872 * t_front_left_shank_2;
  const Scalar t_front_left_shank_4 = s_front_left_hip * s_front_left_shank;
  const Scalar t_front_left_shank_5 = 0.000242048 * s_front_left_shank;
  A[2] = t_front_left_shank_5;
  A[24] = A[2];
  A[1] = t_front_left_shank_5 - 0.000245 * c_front_left_hip + 0.001819852 * s_front_left_hip;
  A[12] = A[1];
  A[13] = 0.005638328 + t_front_left_shank_3 + 0.001631872 * t_front_left_shank_4;
  const Scalar t_front_left_shank_6 = s_front_left_shank * s_front_left_shank * 0.000477144;
  const Scalar t_front_left_shank_7 = 2.6e-05 * c_front_left_hip + 0.004624184 * s_front_left_hip;
  const Scalar t_front_left_hip_1 = 0.01069944 + t_front_left_shank_3 - t_front_left_shank_6;
  A[0] = t_front_left_hip_1 - s_front_left_hip * t_front_left_shank_7;
  const Scalar t_hind_right_shank_8 = t_hind_right_shank_2 + t_hind_right_shank_3;
  A[131] = 0.000486144 + 0.000815936 * t_hind_right_shank_8;
  A[142] = A[131];
  const Scalar t_hind_left_shank_8 = t_hind_left_shank_2 + t_hind_left_shank_4;
  A[92] = 0.000486144 + 0.000815936 * t_hind_left_shank_8;
  A[103] = A[92];
  A[53] = 0.000486144 + 0.000815936 * (t_fron_righ_shan_2 + t_fron_righ_shan_3);
  A[64] = A[53];
  const Scalar t_front_left_shank_8 = t_front_left_shank_2 + t_front_left_shank_4;
  A[14] = 0.000486144 + 0.000815936 * t_front_left_shank_8;
  A[25] = A[14];
  A[26] = 0.000486144;
  A[65] = 0.000486144;
  A[104] = 0.000486144;
  A[143] = 0.000486144;
  A[3] = 0.0;
  A[4] = 0.0;
  A[5] = 0.0;
  A[6] = 0.0;
  A[7] = 0.0;
  A[8] = 0.0;
  A[9] = 0.0;
  A[10] = 0.0;
  A[11] = 0.0;
  A[15] = 0.0;
  A[16] = 0.0;
  A[17] = 0.0;
  A[18] = 0.0;
  A[19] = 0.0;
  A[20] = 0.0;
  A[21] = 0.0;
  A[22] = 0.0;
  A[23] = 0.0;
  A[27] = 0.0;
  A[28] = 0.0;
  A[29] = 0.0;
  A[30] = 0.0;
  A[31] = 0.0;
  A[32] = 0.0;
  A[33] = 0.0;
  A[34] = 0.0;
  A[35] = 0.0;
  A[36] = 0.0;
  A[37] = 0.0;
  A[38] = 0.0;
  A[42] = 0.0;
  A[43] = 0.0;
  A[44] = 0.0;
  A[45] = 0.0;
  A[46] = 0.0;
  A[47] = 0.0;
  A[48] = 0.0;
  A[49] = 0.0;
  A[50] = 0.0;
  A[54] = 0.0;
  A[55] = 0.0;
  A[56] = 0.0;
  A[57] = 0.0;
  A[58] = 0.0;
  A[59] = 0.0;
  A[60] = 0.0;
  A[61] = 0.0;
  A[62] = 0.0;
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
  A[81] = 0.0;
  A[82] = 0.0;
  A[83] = 0.0;
  A[84] = 0.0;
  A[85] = 0.0;
  A[86] = 0.0;
  A[87] = 0.0;
  A[88] = 0.0;
  A[89] = 0.0;
  A[93] = 0.0;
  A[94] = 0.0;
  A[95] = 0.0;
  A[96] = 0.0;
  A[97] = 0.0;
  A[98] = 0.0;
  A[99] = 0.0;
  A[100] = 0.0;
  A[101] = 0.0;
  A[105] = 0.0;
  A[106] = 0.0;
  A[107] = 0.0;
  A[108] = 0.0;
  A[109] = 0.0;
  A[110] = 0.0;
  A[111] = 0.0;
  A[112] = 0.0;
  A[113] = 0.0;
  A[114] = 0.0;
  A[115] = 0.0;
  A[116] = 0.0;
  A[120] = 0.0;
  A[121] = 0.0;
  A[122] = 0.0;
  A[123] = 0.0;
  A[124] = 0.0;
  A[125] = 0.0;
  A[126] = 0.0;
  A[127] = 0.0;
  A[128] = 0.0;
  A[132] = 0.0;
  A[133] = 0.0;
  A[134] = 0.0;
  A[135] = 0.0;
  A[136] = 0.0;
  A[137] = 0.0;
  A[138] = 0.0;
  A[139] = 0.0;
  A[140] = 0.0;
}

void bias_force(const Scalar q[12], const Scalar qd[12], Scalar B[12]) noexcept {
  const auto [s_front_left_hip, c_front_left_hip] = sine_cosine(q[1]);
  const auto [s_front_right_hip, c_front_right_hip] = sine_cosine(q[4]);
  const auto [s_hind_left_hip, c_hind_left_hip] = sine_cosine(q[7]);
  const auto [s_hind_right_hip, c_hind_right_hip] = sine_cosine(q[10]);
  // front_left_shank
  const Scalar omega_front_left_shank_z = qd[1] + qd[2];
  const Scalar t_front_left_shank_1 = q[1] + q[2];
  const auto [s_front_left_shank, c_front_left_shank] = sine_cosine(t_front_left_shank_1);
  const Scalar t_front_left_shank_2 = omega_front_left_shank_z * omega_front_left_shank_z;
  const Scalar t_front_left_shank_3 = s_front_left_hip * c_front_left_shank * 0.000815936;
  const Scalar t_front_left_shank_4 = c_front_left_hip * s_front_left_shank * 0.000815936;
  const Scalar t_front_left_shank_5 = s_front_left_shank * c_front_left_shank * 0.000477144;
  const Scalar t_front_left_shank_6 = t_front_left_shank_4 + t_front_left_shank_5;
  const Scalar t_front_left_hip_1 = qd[0] * qd[0];
  const Scalar t_front_left_shank_7 = t_front_left_shank_3 - t_front_left_shank_4;
  const Scalar t_front_left_thigh_1 = qd[1] * qd[1];
  const Scalar t_front_left_shank_8 = t_front_left_shank_7 * t_front_left_thigh_1;
  const Scalar t_front_left_shank_9 = t_front_left_shank_6 * t_front_left_hip_1;
  const Scalar M_front_left_shank_z = t_front_left_shank_9 - t_front_left_shank_8;
  B[2] = M_front_left_shank_z;
  // front_right_shank
  const Scalar omega_fron_righ_shan_z = qd[4] + qd[5];
  const Scalar t_fron_righ_shan_1 = q[4] + q[5];
  const auto [s_fron_righ_shan, c_fron_righ_shan] = sine_cosine(t_fron_righ_shan_1);
  const Scalar t_fron_righ_shan_2 = omega_fron_righ_shan_z * omega_fron_righ_shan_z;
  const Scalar t_fron_righ_shan_3 = s_front_right_hip * c_fron_righ_shan * 0.000815936;
  const Scalar t_fron_righ_shan_4 = c_front_right_hip * s_fron_righ_shan * 0.000815936;
  const Scalar t_fron_righ_shan_5 = t_fron_righ_shan_3 - t_fron_righ_shan_4;
  const Scalar t_fron_righ_thig_1 = qd[4] * qd[4];
  const Scalar t_fron_righ_shan_6 = s_fron_righ_shan * c_fron_righ_shan * 0.000477144;
  const Scalar t_fron_righ_shan_7 = t_fron_righ_shan_4 + t_fron_righ_shan_6;
  const Scalar t_front_right_hip_1 = qd[3] * qd[3];
  const Scalar t_fron_righ_shan_8 = t_fron_righ_shan_7 * t_front_right_hip_1;
  const Scalar t_fron_righ_shan_9 = t_fron_righ_shan_5 * t_fron_righ_thig_1;
  const Scalar t_fron_righ_shan_10 = t_fron_righ_shan_9 - t_fron_righ_shan_8;
  B[5] = -t_fron_righ_shan_10;
  // hind_left_shank
  const Scalar omega_hind_left_shank_z = qd[7] + qd[8];
  const Scalar t_hind_left_shank_1 = q[7] + q[8];
  const auto [s_hind_left_shank, c_hind_left_shank] = sine_cosine(t_hind_left_shank_1);
  const Scalar t_hind_left_shank_2 = omega_hind_left_shank_z * omega_hind_left_shank_z;
  const Scalar t_hind_left_shank_3 = s_hind_left_hip * c_hind_left_shank * 0.000815936;
  const Scalar t_hind_left_shank_4 = c_hind_left_hip * s_hind_left_shank * 0.000815936;
  const Scalar t_hind_left_shank_5 = t_hind_left_shank_3 - t_hind_left_shank_4;
  const Scalar t_hind_left_thigh_1 = qd[7] * qd[7];
  const Scalar t_hind_left_shank_6 = s_hind_left_shank * c_hind_left_shank * 0.000477144;
  const Scalar t_hind_left_shank_7 = t_hind_left_shank_4 + t_hind_left_shank_6;
  const Scalar t_hind_left_hip_1 = qd[6] * qd[6];
  const Scalar t_hind_left_shank_8 = t_hind_left_shank_5 * t_hind_left_thigh_1;
  const Scalar t_hind_left_shank_9 = t_hind_left_shank_7 * t_hind_left_hip_1;
  const Scalar t_hind_left_shank_10 = t_hind_left_shank_8 - t_hind_left_shank_9;
  B[8] = -t_hind_left_shank_10;
  // hind_right_shank
  const Scalar omega_hind_right_shank_z = qd[10] + qd[11];
  const Scalar t_hind_right_shank_1 = q[10] + q[11];
  const auto [s_hind_right_shank, c_hind_right_shank] = sine_cosine(t_hind_right_shank_1);
  const Scalar t_hind_right_shank_2 = omega_hind_right_shank_z * omega_hind_right_shank_z;
  const Scalar t_hind_right_shank_3 = s_hind_right_hip * c_hind_right_shank * 0.000815936;
  const Scalar t_hind_right_shank_4 = c_hind_right_hip * s_hind_right_shank * 0.000815936;
  const Scalar t_hind_right_shank_5 = t_hind_right_shank_3 - t_hind_right_shank_4;
  const Scalar t_hind_right_thigh_1 = qd[10] * qd[10];
  const Scalar t_hind_right_shank_6 = s_hind_right_shank * c_hind_right_shank * 0.000477144;
  const Scalar t_hind_right_shank_7 = t_hind_right_shank_4 + t_hind_right_shank_6;
  const Scalar t_hind_right_hip_1 = qd[9] * qd[9];
  const Scalar t_hind_right_shank_8 = t_hind_right_shank_5 * t_hind_right_thigh_1;
  const Scalar t_hind_right_shank_9 = t_hind_right_shank_7 * t_hind_right_hip_1;
  const Scalar t_hind_right_shank_10 = t_hind_right_shank_8 - t_hind_right_shank_9;
  B[11] = -t_hind_right_shank_10;
  // hind_right_thigh
  const Scalar t_hind_right_thigh_2 = 0.001819852 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_3 = 0.004624184 * s_hind_right_hip + 2.6e-05 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_4 = c_hind_right_hip * t_hind_right_thigh_3;
  const Scalar t_hind_right_shank_11 = 1.3e-05 - t_hind_right_shank_3 - t_hind_right_thigh_4;
  const Scalar t_hind_right_shank_12 = omega_hind_right_shank_z * t_hind_right_shank_7;
  const Scalar t_hind_right_thigh_5 = 0.000245 * s_hind_right_hip + t_hind_right_thigh_2;
  const Scalar t_hind_right_shank_13 = c_hind_right_shank * t_hind_right_shank_2 * 0.000242048;
  const Scalar t_hind_right_thigh_6 = t_hind_right_thigh_1 * t_hind_right_thigh_5;
  const Scalar t_hind_right_shank_14 = qd[10] * t_hind_right_shank_11 - t_hind_right_shank_12;
  B[9] = qd[9] * t_hind_right_shank_14 * 2.0 - (t_hind_right_shank_13 + t_hind_right_thigh_6);
  const Scalar t_hind_right_shank_15 = t_hind_right_hip_1 * t_hind_right_shank_11;
  const Scalar t_hind_right_shank_16 = t_hind_right_shank_10 + t_hind_right_shank_15;
  B[10] = t_hind_right_shank_2 * t_hind_right_shank_5 - t_hind_right_shank_16;
  // hind_left_thigh
  const Scalar t_hind_left_thigh_2 = 2.6e-05 * c_hind_left_hip + 0.004624184 * s_hind_left_hip;
  const Scalar t_hind_left_thigh_3 = c_hind_left_hip * t_hind_left_thigh_2;
  const Scalar t_hind_left_thigh_4 = 1.3e-05 - t_hind_left_shank_3 - t_hind_left_thigh_3;
  const Scalar t_hind_left_thigh_5 = omega_hind_left_shank_z * t_hind_left_shank_7;
  const Scalar t_hind_left_thigh_6 = 0.000245 * s_hind_left_hip + 0.001819852 * c_hind_left_hip;
  const Scalar t_hind_left_shank_11 = c_hind_left_shank * t_hind_left_shank_2 * 0.000242048;
  const Scalar t_hind_left_thigh_7 = t_hind_left_thigh_1 * t_hind_left_thigh_6;
  const Scalar t_hind_left_thigh_8 = qd[7] * t_hind_left_thigh_4 - t_hind_left_thigh_5;
  B[6] = t_hind_left_shank_11 + t_hind_left_thigh_7 + qd[6] * t_hind_left_thigh_8 * 2.0;
  const Scalar t_hind_left_shank_12 = t_hind_left_hip_1 * t_hind_left_thigh_4;
  const Scalar t_hind_left_shank_13 = t_hind_left_shank_10 + t_hind_left_shank_12;
  B[7] = t_hind_left_shank_2 * t_hind_left_shank_5 - t_hind_left_shank_13;
  const Scalar t_fron_righ_thig_2 = 2.6e-05 * c_front_right_hip + 0.004624184 * s_front_right_hip;
  const Scalar t_fron_righ_thig_3 = c_front_right_hip * t_fron_righ_thig_2;
  const Scalar t_fron_righ_shan_11 = 1.3e-05 - t_fron_righ_shan_3 - t_fron_righ_thig_3;
  const Scalar t_fron_righ_shan_12 = omega_fron_righ_shan_z * t_fron_righ_shan_7;
  const Scalar t_fron_righ_thig_4 = 0.001819852 * c_front_right_hip;
  const Scalar t_fron_righ_shan_13 = qd[3] * (t_fron_righ_shan_12 - qd[4] * t_fron_righ_shan_11);
  const Scalar t_fron_righ_shan_14 = c_fron_righ_shan * t_fron_righ_shan_2 * 0.000242048;
  const Scalar t_fron_righ_thig_5 = t_fron_righ_thig_4 + 0.000245 * s_front_right_hip;
  const Scalar t_fron_righ_shan_15 = t_fron_righ_shan_14 + 2.0 * t_fron_righ_shan_13;
  B[3] = -(t_fron_righ_shan_15 + t_fron_righ_thig_1 * t_fron_righ_thig_5);
  const Scalar t_fron_righ_shan_16 = t_fron_righ_shan_2 * t_fron_righ_shan_5;
  const Scalar t_fron_righ_shan_17 = t_front_right_hip_1 * t_fron_righ_shan_11;
  B[4] = -(t_fron_righ_shan_10 - t_fron_righ_shan_16 + t_fron_righ_shan_17);
  // front_left_thigh
  const Scalar t_front_left_thigh_2 = 2.6e-05 * c_front_left_hip + 0.004624184 * s_front_left_hip;
  const Scalar t_front_left_thigh_3 = c_front_left_hip * t_front_left_thigh_2;
  const Scalar t_front_left_thigh_4 = 1.3e-05 - t_front_left_shank_3 - t_front_left_thigh_3;
  const Scalar t_front_left_thigh_5 = omega_front_left_shank_z * t_front_left_shank_6;
  const Scalar t_front_left_thigh_6 = 0.001819852 * c_front_left_hip;
  const Scalar t_front_left_thigh_7 = qd[1] * t_front_left_thigh_4 - t_front_left_thigh_5;
  const Scalar t_front_left_shank_10 = c_front_left_shank * t_front_left_shank_2 * 0.000242048;
  const Scalar t_front_left_thigh_8 = qd[0] * t_front_left_thigh_7 * 2.0;
  const Scalar t_front_left_thigh_9 = 0.000245 * s_front_left_hip + t_front_left_thigh_6;
  const Scalar t_front_left_thigh_10 = t_front_left_shank_10 + t_front_left_thigh_8;
  B[0] = t_front_left_thigh_10 + t_front_left_thigh_1 * t_front_left_thigh_9;
  const Scalar t_front_left_thigh_11 = t_front_left_hip_1 * t_front_left_thigh_4;
  const Scalar t_front_left_thigh_12 = t_front_left_shank_2 * t_front_left_shank_7;
  B[1] = M_front_left_shank_z - t_front_left_thigh_11 + t_front_left_thigh_12;
}

void gravity_force(const Scalar q[12], Scalar G[12]) noexcept {
  const auto [s_front_left_abduction, c_front_left_abduction] = sine_cosine(q[0]);
  const auto [s_front_left_hip, c_front_left_hip] = sine_cosine(q[1]);
  const auto [s_front_right_abduction, c_front_right_abduction] = sine_cosine(q[3]);
  const auto [s_front_right_hip, c_front_right_hip] = sine_cosine(q[4]);
  const auto [s_hind_left_abduction, c_hind_left_abduction] = sine_cosine(q[6]);
  const auto [s_hind_left_hip, c_hind_left_hip] = sine_cosine(q[7]);
  const auto [s_hind_right_abduction, c_hind_right_abduction] = sine_cosine(q[9]);
  // hind_right_shank
  const auto [s_hind_right_hip, c_hind_right_hip] = sine_cosine(q[10]);
  const Scalar t_hind_right_shank_1 = q[10] + q[11];
  const auto [s_hind_right_shank, c_hind_right_shank] = sine_cosine(t_hind_right_shank_1);
  const Scalar t_hind_right_shank_2 = c_hind_right_abduction * s_hind_right_shank * 0.03829824;
  G[11] = t_hind_right_shank_2;
  G[10] = t_hind_right_shank_2 + c_hind_right_abduction * s_hind_right_hip * 0.25560936;
  // hind_right_hip
  const Scalar t_hind_right_hip_1 = 0.03829824 * c_hind_right_shank;
  const Scalar t_hind_right_hip_2 = t_hind_right_hip_1 + 0.25560936 * c_hind_right_hip;
  G[9] = s_hind_right_abduction * t_hind_right_hip_2 - 0.7147566 * c_hind_right_abduction;
  // hind_left_shank
  const Scalar t_hind_left_shank_1 = q[7] + q[8];
  const auto [s_hind_left_shank, c_hind_left_shank] = sine_cosine(t_hind_left_shank_1);
  const Scalar t_hind_left_shank_2 = c_hind_left_abduction * s_hind_left_shank * 0.03829824;
  G[8] = t_hind_left_shank_2;
  G[7] = t_hind_left_shank_2 + c_hind_left_abduction * s_hind_left_hip * 0.25560936;
  const Scalar t_hind_left_hip_1 = 0.03829824 * c_hind_left_shank + 0.25560936 * c_hind_left_hip;
  G[6] = 0.7147566 * c_hind_left_abduction + s_hind_left_abduction * t_hind_left_hip_1;
  // front_right_shank
  const Scalar t_fron_righ_shan_1 = q[4] + q[5];
  const auto [s_fron_righ_shan, c_fron_righ_shan] = sine_cosine(t_fron_righ_shan_1);
  const Scalar t_fron_righ_shan_2 = c_front_right_abduction * s_fron_righ_shan * 0.03829824;
  G[5] = t_fron_righ_shan_2;
  G[4] = t_fron_righ_shan_2 + c_front_right_abduction * s_front_right_hip * 0.25560936;
  // front_right_hip
  const Scalar t_front_right_hip_1 = 0.25560936 * c_front_right_hip;
  const Scalar t_front_right_hip_2 = 0.03829824 * c_fron_righ_shan + t_front_right_hip_1;
  G[3] = s_front_right_abduction * t_front_right_hip_2 - 0.7147566 * c_front_right_abduction;
  // front_left_shank
  const Scalar t_front_left_shank_1 = q[1] + q[2];
  const auto [s_front_left_shank, c_front_left_shank] = sine_cosine(t_front_left_shank_1);
  const Scalar t_front_left_shank_2 = c_front_left_abduction * s_front_left_shank * 0.03829824;
  G[2] = t_front_left_shank_2;
  G[1] = t_front_left_shank_2 + c_front_left_abduction * s_front_left_hip * 0.25560936;
  // front_left_hip
  const Scalar t_front_left_hip_1 = 0.03829824 * c_front_left_shank;
  const Scalar t_front_left_hip_2 = t_front_left_hip_1 + 0.25560936 * c_front_left_hip;
  G[0] = 0.7147566 * c_front_left_abduction + s_front_left_abduction * t_front_left_hip_2;
}

void inverse_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar qdd[12],
                      Scalar tau[12]) noexcept {
  const auto [s_front_left_abduction, c_front_left_abduction] = sine_cosine(q[0]);
  const auto [s_front_left_hip, c_front_left_hip] = sine_cosine(q[1]);
  const auto [s_front_right_abduction, c_front_right_abduction] = sine_cosine(q[3]);
  const auto [s_front_right_hip, c_front_right_hip] = sine_cosine(q[4]);
  const auto [s_hind_left_abduction, c_hind_left_abduction] = sine_cosine(q[6]);
  const auto [s_hind_left_hip, c_hind_left_hip] = sine_cosine(q[7]);
  const auto [s_hind_right_abduction, c_hind_right_abduction] = sine_cosine(q[9]);
  const auto [s_hind_right_hip, c_hind_right_hip] = sine_cosine(q[10]);
  const Scalar t_front_left_thigh_1 = qd[1] * qd[1];
  // front_left_shank
  const Scalar t_front_left_shank_1 = s_front_left_hip * t_front_left_thigh_1;
  const Scalar omega_front_left_shank_z = qd[1] + qd[2];
  const Scalar t_front_left_shank_2 = q[1] + q[2];
  const auto [s_front_left_shank, c_front_left_shank] = sine_cosine(t_front_left_shank_2);
  const Scalar t_front_left_shank_3 = 0.000815936 * c_front_left_shank;
  const Scalar t_front_left_shank_4 = 0.000477144 * s_front_left_shank;
  const Scalar t_front_left_shank_5 = 0.000815936 * s_front_left_shank;
  const Scalar t_front_left_shank_6 = c_front_left_shank * t_front_left_shank_4;
  const Scalar t_front_left_shank_7 = c_front_left_hip * t_front_left_shank_5;
  const Scalar t_front_left_shank_8 = t_front_left_shank_6 + t_front_left_shank_7;
  const Scalar t_front_left_hip_1 = qd[0] * qd[0];
  const Scalar alpha_front_left_shank_z = qdd[1] + qdd[2];
  const Scalar t_front_left_shank_9 = c_front_left_hip * t_front_left_thigh_1;
  const Scalar t_front_left_hip_2 = 46.9377990430622 * c_front_left_abduction;
  const Scalar t_front_left_shank_10 = t_front_left_shank_9 + t_front_left_hip_2;
  const Scalar t_front_left_shank_11 = t_front_left_shank_10 + s_front_left_hip * qdd[1];
  const Scalar t_front_left_shank_12 = t_front_left_shank_1 - c_front_left_hip * qdd[1];
  const Scalar t_front_left_shank_13 = t_front_left_shank_3 * t_front_left_shank_12;
  const Scalar t_front_left_shank_14 = t_front_left_shank_8 * t_front_left_hip_1;
  const Scalar t_front_left_shank_15 = t_front_left_shank_14 - t_front_left_shank_13;
  const Scalar t_front_left_shank_16 = 0.000486144 * alpha_front_left_shank_z;
  const Scalar t_front_left_shank_17 = t_front_left_shank_11 + 0.2966507177033493 * qdd[0];
  const Scalar t_front_left_shank_18 = t_front_left_shank_15 + t_front_left_shank_16;
  const Scalar t_front_left_shank_19 = t_front_left_shank_5 * t_front_left_shank_17;
  const Scalar M_front_left_shank_z = t_front_left_shank_18 + t_front_left_shank_19;
  tau[2] = M_front_left_shank_z;
  const Scalar t_front_right_hip_1 = qd[3] * qd[3];
  const Scalar t_fron_righ_thig_1 = qd[4] * qd[4];
  // front_right_shank
  const Scalar t_fron_righ_shan_1 = s_front_right_hip * t_fron_righ_thig_1;
  const Scalar omega_fron_righ_shan_z = qd[4] + qd[5];
  const Scalar alpha_fron_righ_shan_z = qdd[4] + qdd[5];
  const Scalar t_fron_righ_shan_2 = q[4] + q[5];
  const auto [s_fron_righ_shan, c_fron_righ_shan] = sine_cosine(t_fron_righ_shan_2);
  const Scalar t_fron_righ_shan_3 = 0.000815936 * s_fron_righ_shan;
  const Scalar t_fron_righ_shan_4 = 0.000477144 * s_fron_righ_shan;
  const Scalar t_fron_righ_shan_5 = c_fron_righ_shan * t_fron_righ_shan_4;
  const Scalar t_front_right_hip_2 = 46.9377990430622 * c_front_right_abduction;
  const Scalar t_fron_righ_shan_6 = t_front_right_hip_2 + s_front_right_hip * qdd[4];
  const Scalar t_fron_righ_thig_2 = t_front_right_hip_1 + t_fron_righ_thig_1;
  const Scalar t_fron_righ_shan_7 = t_fron_righ_shan_6 - 0.2966507177033493 * qdd[3];
  const Scalar t_fron_righ_shan_8 = c_front_right_hip * t_fron_righ_thig_2;
  const Scalar t_fron_righ_shan_9 = 0.000815936 * c_fron_righ_shan;
  const Scalar t_fron_righ_shan_10 = t_fron_righ_shan_7 + t_fron_righ_shan_8;
  const Scalar t_fron_righ_shan_11 = t_front_right_hip_1 * t_fron_righ_shan_5;
  const Scalar t_fron_righ_shan_12 = t_fron_righ_shan_3 * t_fron_righ_shan_10;
  const Scalar t_fron_righ_shan_13 = t_fron_righ_shan_1 - c_front_right_hip * qdd[4];
  const Scalar t_fron_righ_shan_14 = t_fron_righ_shan_11 + t_fron_righ_shan_12;
  const Scalar t_fron_righ_shan_15 = t_fron_righ_shan_9 * t_fron_righ_shan_13;
  const Scalar t_fron_righ_shan_16 = t_fron_righ_shan_14 - t_fron_righ_shan_15;
  const Scalar M_fron_righ_shan_z = t_fron_righ_shan_16 + 0.000486144 * alpha_fron_righ_shan_z;
  tau[5] = M_fron_righ_shan_z;
  // hind_left_shank
  const Scalar omega_hind_left_shank_z = qd[7] + qd[8];
  const Scalar t_hind_left_shank_1 = q[7] + q[8];
  const auto [s_hind_left_shank, c_hind_left_shank] = sine_cosine(t_hind_left_shank_1);
  const Scalar t_hind_left_shank_2 = 0.000815936 * c_hind_left_shank;
  const Scalar t_hind_left_shank_3 = c_hind_left_hip * t_hind_left_shank_2;
  const Scalar alpha_hind_left_shank_z = qdd[7] + qdd[8];
  const Scalar t_hind_left_shank_4 = 0.000815936 * s_hind_left_shank;
  const Scalar t_hind_left_hip_1 = 46.9377990430622 * c_hind_left_abduction;
  const Scalar t_hind_left_shank_5 = t_hind_left_hip_1 + s_hind_left_hip * qdd[7];
  const Scalar t_hind_left_thigh_1 = qd[7] * qd[7];
  const Scalar t_hind_left_shank_6 = c_hind_left_hip * t_hind_left_shank_4;
  const Scalar t_hind_left_shank_7 = s_hind_left_hip * t_hind_left_shank_2;
  const Scalar t_hind_left_shank_8 = 0.000477144 * s_hind_left_shank;
  const Scalar t_hind_left_shank_9 = c_hind_left_shank * t_hind_left_shank_8;
  const Scalar t_hind_left_shank_10 = t_hind_left_shank_6 + t_hind_left_shank_9;
  const Scalar t_hind_left_hip_2 = qd[6] * qd[6];
  const Scalar t_hind_left_shank_11 = 0.000486144 * alpha_hind_left_shank_z;
  const Scalar t_hind_left_shank_12 = t_hind_left_shank_5 + 0.2966507177033493 * qdd[6];
  const Scalar t_hind_left_shank_13 = qdd[7] * t_hind_left_shank_3 + t_hind_left_shank_11;
  const Scalar t_hind_left_shank_14 = t_hind_left_shank_4 * t_hind_left_shank_12;
  const Scalar t_hind_left_shank_15 = t_hind_left_shank_6 - t_hind_left_shank_7;
  const Scalar t_hind_left_shank_16 = t_hind_left_shank_13 + t_hind_left_shank_14;
  const Scalar t_hind_left_shank_17 = t_hind_left_thigh_1 * t_hind_left_shank_15;
  const Scalar t_hind_left_shank_18 = t_hind_left_shank_16 + t_hind_left_shank_17;
  const Scalar t_hind_left_shank_19 = t_hind_left_shank_10 * t_hind_left_hip_2;
  const Scalar M_hind_left_shank_z = t_hind_left_shank_18 + t_hind_left_shank_19;
  tau[8] = M_hind_left_shank_z;
  // hind_right_shank
  const Scalar omega_hind_right_shank_z = qd[10] + qd[11];
  const Scalar t_hind_right_shank_1 = q[10] + q[11];
  const auto [s_hind_right_shank, c_hind_right_shank] = sine_cosine(t_hind_right_shank_1);
  const Scalar t_hind_right_shank_2 = 0.000815936 * s_hind_right_shank;
  const Scalar t_hind_right_shank_3 = c_hind_right_hip * t_hind_right_shank_2;
  const Scalar t_hind_right_shank_4 = 0.000477144 * s_hind_right_shank;
  const Scalar t_hind_right_shank_5 = c_hind_right_shank * t_hind_right_shank_4;
  const Scalar t_hind_right_shank_6 = qd[9] * (t_hind_right_shank_3 + t_hind_right_shank_5);
  const Scalar t_hind_right_shank_7 = 0.000815936 * c_hind_right_shank;
  const Scalar t_hind_right_shank_8 = s_hind_right_hip * t_hind_right_shank_7;
  const Scalar t_hind_right_thigh_1 = qd[10] * qd[10];
  const Scalar t_hind_right_shank_9 = c_hind_right_hip * t_hind_right_shank_7;
  const Scalar t_hind_right_shank_10 = s_hind_right_hip * t_hind_right_shank_2;
  const Scalar t_hind_right_shank_11 = 0.000486144 + t_hind_right_shank_9;
  const Scalar t_hind_right_shank_12 = t_hind_right_shank_3 - t_hind_right_shank_8;
  const Scalar t_hind_right_shank_13 = 0.000486144 * qdd[11] + qd[9] * t_hind_right_shank_6;
  const Scalar t_hind_right_shank_14 = t_hind_right_shank_12 * t_hind_right_thigh_1;
  const Scalar t_hind_right_shank_15 = qdd[10] * (t_hind_right_shank_11 + t_hind_right_shank_10);
  const Scalar t_hind_right_shank_16 = t_hind_right_shank_13 + t_hind_right_shank_14;
  const Scalar t_hind_right_shank_17 = 0.03829824 * c_hind_right_abduction - 0.000242048 * qdd[9];
  const Scalar t_hind_right_shank_18 = t_hind_right_shank_16 + t_hind_right_shank_15;
  const Scalar t_hind_right_shank_19 = s_hind_right_shank * t_hind_right_shank_17;
  const Scalar M_hind_right_shank_z = t_hind_right_shank_18 + t_hind_right_shank_19;
  tau[11] = M_hind_right_shank_z;
  const Scalar t_hind_right_shank_20 = omega_hind_right_shank_z * omega_hind_right_shank_z;
  // hind_right_thigh
  const Scalar t_hind_right_thigh_2 = 0.004624184 * s_hind_right_hip + 2.6e-05 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_3 = c_hind_right_hip * t_hind_right_thigh_2;
  const Scalar t_hind_right_thigh_4 = 1.3e-05 - t_hind_right_shank_8 - t_hind_right_thigh_3;
  const Scalar t_hind_right_thigh_5 = qd[9] * t_hind_right_thigh_4;
  const Scalar alpha_hind_right_shank_z = qdd[10] + qdd[11];
  const Scalar t_hind_right_shank_21 = t_hind_right_shank_2 * alpha_hind_right_shank_z;
  const Scalar t_hind_right_thigh_6 = t_hind_right_shank_7 * t_hind_right_shank_20;
  const Scalar t_hind_right_thigh_7 = t_hind_right_thigh_6 + t_hind_right_shank_21;
  const Scalar t_hind_right_thigh_8 = 0.25560936 * c_hind_right_abduction;
  const Scalar t_hind_right_thigh_9 = 0.001819852 * s_hind_right_hip;
  const Scalar t_hind_right_thigh_10 = t_hind_right_thigh_9 - 0.000245 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_11 = t_hind_right_shank_3 * t_hind_right_shank_20;
  const Scalar t_hind_right_thigh_12 = M_hind_right_shank_z + 0.005152184 * qdd[10];
  const Scalar t_hind_right_thigh_13 = t_hind_right_thigh_12 - t_hind_right_thigh_11;
  const Scalar t_hind_right_thigh_14 = t_hind_right_thigh_13 - qd[9] * t_hind_right_thigh_5;
  const Scalar t_hind_right_thigh_15 = t_hind_right_shank_9 * alpha_hind_right_shank_z;
  const Scalar t_hind_right_thigh_16 = t_hind_right_thigh_7 + t_hind_right_thigh_8;
  const Scalar t_hind_right_thigh_17 = t_hind_right_thigh_14 + t_hind_right_thigh_15;
  const Scalar t_hind_right_thigh_18 = s_hind_right_hip * t_hind_right_thigh_16;
  tau[10] = t_hind_right_thigh_17 + t_hind_right_thigh_18 - qdd[9] * t_hind_right_thigh_10;
  const Scalar t_hind_right_thigh_19 = 0.001819852 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_20 = omega_hind_right_shank_z * t_hind_right_shank_6;
  const Scalar t_hind_right_shank_22 = s_hind_right_shank * t_hind_right_shank_4;
  const Scalar t_hind_right_thigh_21 = 0.01069944 + 2.0 * t_hind_right_shank_9;
  const Scalar t_hind_right_thigh_22 = t_hind_right_thigh_21 - t_hind_right_shank_22;
  const Scalar t_hind_right_thigh_23 = s_hind_right_hip * t_hind_right_thigh_2;
  const Scalar t_hind_right_thigh_24 = 0.03829824 * c_hind_right_shank;
  const Scalar t_hind_right_thigh_25 = 0.000245 * s_hind_right_hip + t_hind_right_thigh_19;
  const Scalar t_hind_right_thigh_26 = t_hind_right_thigh_1 * t_hind_right_thigh_25;
  const Scalar t_hind_right_thigh_27 = qd[10] * t_hind_right_thigh_5 - t_hind_right_thigh_20;
  const Scalar t_hind_right_thigh_28 = 0.7147566 * c_hind_right_abduction + t_hind_right_thigh_26;
  const Scalar t_hind_right_thigh_29 = qdd[9] * (t_hind_right_thigh_22 - t_hind_right_thigh_23);
  const Scalar t_hind_right_thigh_30 = t_hind_right_thigh_28 - 2.0 * t_hind_right_thigh_27;
  const Scalar t_hind_right_thigh_31 = t_hind_right_thigh_30 - t_hind_right_thigh_29;
  const Scalar t_hind_right_thigh_32 = 0.2966507177033493 * t_hind_right_thigh_7;
  const Scalar t_hind_right_thigh_33 = t_hind_right_thigh_31 + t_hind_right_thigh_32;
  const Scalar t_hind_right_thigh_34 = 0.25560936 * c_hind_right_hip + t_hind_right_thigh_24;
  const Scalar t_hind_right_thigh_35 = t_hind_right_thigh_33 + qdd[10] * t_hind_right_thigh_10;
  tau[9] = s_hind_right_abduction * t_hind_right_thigh_34 - t_hind_right_thigh_35;
  const Scalar t_hind_left_shank_20 = omega_hind_left_shank_z * omega_hind_left_shank_z;
  // hind_left_thigh
  const Scalar t_hind_left_thigh_2 = 2.6e-05 * c_hind_left_hip + 0.004624184 * s_hind_left_hip;
  const Scalar t_hind_left_thigh_3 = c_hind_left_hip * t_hind_left_thigh_2;
  const Scalar t_hind_left_thigh_4 = 1.3e-05 - t_hind_left_shank_7 - t_hind_left_thigh_3;
  const Scalar t_hind_left_thigh_5 = 0.001819852 * s_hind_left_hip - 0.000245 * c_hind_left_hip;
  const Scalar t_hind_left_shank_21 = alpha_hind_left_shank_z * t_hind_left_shank_4;
  const Scalar t_hind_left_thigh_6 = t_hind_left_shank_2 * t_hind_left_shank_20;
  const Scalar t_hind_left_thigh_7 = t_hind_left_thigh_6 + t_hind_left_shank_21;
  const Scalar t_hind_left_thigh_8 = t_hind_left_shank_6 * t_hind_left_shank_20;
  const Scalar t_hind_left_thigh_9 = M_hind_left_shank_z + 0.005152184 * qdd[7];
  const Scalar t_hind_left_thigh_10 = t_hind_left_shank_3 * alpha_hind_left_shank_z;
  const Scalar t_hind_left_thigh_11 = t_hind_left_thigh_9 - t_hind_left_thigh_8;
  const Scalar t_hind_left_thigh_12 = t_hind_left_thigh_11 + t_hind_left_thigh_10;
  const Scalar t_hind_left_thigh_13 = t_hind_left_hip_2 * t_hind_left_thigh_4;
  const Scalar t_hind_left_thigh_14 = t_hind_left_thigh_12 - t_hind_left_thigh_13;
  const Scalar t_hind_left_thigh_15 = t_hind_left_thigh_7 + 0.25560936 * c_hind_left_abduction;
  const Scalar t_hind_left_thigh_16 = t_hind_left_thigh_14 + qdd[6] * t_hind_left_thigh_5;
  tau[7] = t_hind_left_thigh_16 + s_hind_left_hip * t_hind_left_thigh_15;
  // hind_left_hip
  const Scalar t_hind_left_hip_3 = 0.01069944 - s_hind_left_shank * t_hind_left_shank_8;
  const Scalar t_hind_left_hip_4 = t_hind_left_hip_3 + 2.0 * t_hind_left_shank_3;
  const Scalar t_hind_left_hip_5 = omega_hind_left_shank_z * t_hind_left_shank_10;
  const Scalar t_hind_left_hip_6 = 0.25560936 * c_hind_left_hip + 0.03829824 * c_hind_left_shank;
  const Scalar t_hind_left_hip_7 = s_hind_left_abduction * t_hind_left_hip_6;
  const Scalar t_hind_left_hip_8 = 0.7147566 * c_hind_left_abduction + t_hind_left_hip_7;
  const Scalar t_hind_left_hip_9 = 0.2966507177033493 * t_hind_left_thigh_7;
  const Scalar t_hind_left_thigh_17 = 0.000245 * s_hind_left_hip + 0.001819852 * c_hind_left_hip;
  const Scalar t_hind_left_thigh_18 = t_hind_left_thigh_1 * t_hind_left_thigh_17;
  const Scalar t_hind_left_hip_10 = t_hind_left_hip_8 + t_hind_left_hip_9;
  const Scalar t_hind_left_hip_11 = t_hind_left_hip_4 - s_hind_left_hip * t_hind_left_thigh_2;
  const Scalar t_hind_left_hip_12 = t_hind_left_hip_10 + t_hind_left_thigh_18;
  const Scalar t_hind_left_hip_13 = qd[6] * (qd[7] * t_hind_left_thigh_4 - t_hind_left_hip_5);
  const Scalar t_hind_left_hip_14 = t_hind_left_hip_12 + qdd[6] * t_hind_left_hip_11;
  tau[6] = t_hind_left_hip_14 + 2.0 * t_hind_left_hip_13 + qdd[7] * t_hind_left_thigh_5;
  const Scalar t_fron_righ_shan_17 = omega_fron_righ_shan_z * omega_fron_righ_shan_z;
  const Scalar t_fron_righ_shan_18 = alpha_fron_righ_shan_z * t_fron_righ_shan_3;
  const Scalar t_fron_righ_thig_3 = t_fron_righ_shan_9 * t_fron_righ_shan_17;
  const Scalar t_fron_righ_thig_4 = t_fron_righ_shan_18 + t_fron_righ_thig_3;
  const Scalar t_fron_righ_shan_19 = alpha_fron_righ_shan_z * t_fron_righ_shan_9;
  const Scalar t_fron_righ_shan_20 = t_fron_righ_shan_3 * t_fron_righ_shan_17;
  // front_right_thigh
  const Scalar t_fron_righ_thig_5 = 0.001819852 * s_front_right_hip;
  const Scalar t_fron_righ_thig_6 = t_fron_righ_thig_5 - 0.000245 * c_front_right_hip;
  const Scalar t_fron_righ_thig_7 = 2.6e-05 * c_front_right_hip + 0.004624184 * s_front_right_hip;
  const Scalar t_fron_righ_thig_8 = 1.3e-05 - s_front_right_hip * t_fron_righ_shan_9;
  const Scalar t_fron_righ_thig_9 = c_front_right_hip * t_fron_righ_thig_7;
  const Scalar t_fron_righ_thig_10 = t_fron_righ_thig_8 - t_fron_righ_thig_9;
  const Scalar t_fron_righ_thig_11 = t_fron_righ_thig_4 + 0.25560936 * c_front_right_abduction;
  const Scalar t_fron_righ_thig_12 = M_fron_righ_shan_z + 0.005152184 * qdd[4];
  const Scalar t_fron_righ_thig_13 = s_front_right_hip * t_fron_righ_thig_11;
  const Scalar t_fron_righ_shan_21 = t_fron_righ_shan_20 - t_fron_righ_shan_19;
  const Scalar t_fron_righ_thig_14 = t_fron_righ_thig_12 + t_fron_righ_thig_13;
  const Scalar t_fron_righ_shan_22 = c_front_right_hip * t_fron_righ_shan_21;
  const Scalar t_fron_righ_thig_15 = t_fron_righ_thig_14 - t_fron_righ_shan_22;
  const Scalar t_fron_righ_thig_16 = t_fron_righ_thig_15 - qdd[3] * t_fron_righ_thig_6;
  tau[4] = t_fron_righ_thig_16 - t_front_right_hip_1 * t_fron_righ_thig_10;
  const Scalar t_fron_righ_thig_17 = 0.01069944 - s_fron_righ_shan * t_fron_righ_shan_4;
  const Scalar t_fron_righ_thig_18 = s_front_right_hip * t_fron_righ_thig_7;
  const Scalar t_fron_righ_shan_23 = 2.0 * qd[3];
  const Scalar t_fron_righ_thig_19 = omega_fron_righ_shan_z * t_fron_righ_shan_5;
  const Scalar t_fron_righ_thig_20 = qdd[3] * c_fron_righ_shan * 0.001631872;
  const Scalar t_fron_righ_thig_21 = t_fron_righ_thig_20 - 0.001819852 * t_fron_righ_thig_1;
  const Scalar t_fron_righ_shan_24 = omega_fron_righ_shan_z * t_fron_righ_shan_3;
  const Scalar t_fron_righ_thig_22 = t_fron_righ_thig_21 + 0.25560936 * s_front_right_abduction;
  const Scalar t_fron_righ_shan_25 = t_fron_righ_shan_23 * t_fron_righ_shan_24;
  const Scalar t_front_right_hip_3 = 0.7147566 * c_front_right_abduction;
  const Scalar t_fron_righ_thig_23 = t_front_right_hip_3 + 0.000245 * t_fron_righ_shan_1;
  const Scalar t_fron_righ_thig_24 = s_front_right_abduction * c_fron_righ_shan * 0.03829824;
  const Scalar t_fron_righ_thig_25 = qdd[3] * (t_fron_righ_thig_17 - t_fron_righ_thig_18);
  const Scalar t_fron_righ_thig_26 = t_fron_righ_thig_23 - t_fron_righ_thig_24;
  const Scalar t_fron_righ_thig_27 = t_fron_righ_thig_26 - t_fron_righ_thig_25;
  const Scalar t_fron_righ_thig_28 = 0.2966507177033493 * t_fron_righ_thig_4;
  const Scalar t_fron_righ_thig_29 = t_fron_righ_thig_19 - qd[4] * t_fron_righ_thig_10;
  const Scalar t_fron_righ_thig_30 = t_fron_righ_thig_27 + t_fron_righ_thig_28;
  const Scalar t_fron_righ_thig_31 = t_fron_righ_shan_23 * t_fron_righ_thig_29;
  const Scalar t_fron_righ_thig_32 = t_fron_righ_thig_22 - t_fron_righ_shan_25;
  const Scalar t_fron_righ_thig_33 = t_fron_righ_thig_30 + t_fron_righ_thig_31;
  const Scalar t_fron_righ_thig_34 = c_front_right_hip * t_fron_righ_thig_32;
  tau[3] = -(t_fron_righ_thig_33 - t_fron_righ_thig_34 + qdd[4] * t_fron_righ_thig_6);
  const Scalar t_front_left_thigh_2 = 0.001819852 * s_front_left_hip;
  const Scalar t_front_left_thigh_3 = 0.000245 * c_front_left_hip - t_front_left_thigh_2;
  // front_left_shank
  const Scalar t_front_left_shank_20 = omega_front_left_shank_z * omega_front_left_shank_z;
  const Scalar t_front_left_shank_21 = t_front_left_shank_3 * alpha_front_left_shank_z;
  const Scalar t_front_left_shank_22 = t_front_left_shank_5 * t_front_left_shank_20;
  const Scalar t_front_left_shank_23 = t_front_left_shank_5 * alpha_front_left_shank_z;
  // front_left_thigh
  const Scalar t_front_left_thigh_4 = t_front_left_shank_3 * t_front_left_shank_20;
  const Scalar t_front_left_thigh_5 = t_front_left_thigh_4 + t_front_left_shank_23;
  const Scalar t_front_left_thigh_6 = 0.25560936 * c_front_left_abduction;
  const Scalar t_front_left_thigh_7 = 2.6e-05 * c_front_left_hip + 0.004624184 * s_front_left_hip;
  const Scalar t_front_left_thigh_8 = 1.3e-05 - s_front_left_hip * t_front_left_shank_3;
  const Scalar t_front_left_thigh_9 = c_front_left_hip * t_front_left_thigh_7;
  const Scalar t_front_left_thigh_10 = t_front_left_thigh_8 - t_front_left_thigh_9;
  const Scalar t_front_left_thigh_11 = M_front_left_shank_z + 0.005152184 * qdd[1];
  const Scalar t_front_left_shank_24 = t_front_left_shank_22 - t_front_left_shank_21;
  const Scalar t_front_left_thigh_12 = t_front_left_thigh_11 - qdd[0] * t_front_left_thigh_3;
  const Scalar t_front_left_shank_25 = c_front_left_hip * t_front_left_shank_24;
  const Scalar t_front_left_thigh_13 = t_front_left_thigh_5 + t_front_left_thigh_6;
  const Scalar t_front_left_thigh_14 = t_front_left_thigh_12 - t_front_left_shank_25;
  const Scalar t_front_left_thigh_15 = s_front_left_hip * t_front_left_thigh_13;
  const Scalar t_front_left_thigh_16 = t_front_left_thigh_14 + t_front_left_thigh_15;
  tau[1] = t_front_left_thigh_16 - t_front_left_hip_1 * t_front_left_thigh_10;
  // front_left_hip
  const Scalar t_front_left_hip_3 = 0.01069944 - s_front_left_shank * t_front_left_shank_4;
  const Scalar t_front_left_hip_4 = c_front_left_hip * c_front_left_shank * 0.001631872;
  const Scalar t_front_left_hip_5 = t_front_left_hip_3 + t_front_left_hip_4;
  const Scalar t_front_left_thigh_17 = s_front_left_hip * t_front_left_thigh_7;
  const Scalar t_front_left_hip_6 = 0.03829824 * c_front_left_shank;
  const Scalar t_front_left_hip_7 = omega_front_left_shank_z * t_front_left_shank_8;
  const Scalar t_front_left_hip_8 = 0.7147566 * c_front_left_abduction;
  const Scalar t_front_left_hip_9 = t_front_left_hip_8 + 0.000245 * t_front_left_shank_1;
  const Scalar t_front_left_hip_10 = t_front_left_hip_9 + 0.001819852 * t_front_left_shank_9;
  const Scalar t_front_left_hip_11 = qdd[0] * (t_front_left_hip_5 - t_front_left_thigh_17);
  const Scalar t_front_left_hip_12 = t_front_left_hip_10 - qdd[1] * t_front_left_thigh_3;
  const Scalar t_front_left_hip_13 = t_front_left_hip_12 + t_front_left_hip_11;
  const Scalar t_front_left_hip_14 = 0.2966507177033493 * t_front_left_thigh_5;
  const Scalar t_front_left_hip_15 = t_front_left_hip_6 + 0.25560936 * c_front_left_hip;
  const Scalar t_front_left_hip_16 = s_front_left_abduction * t_front_left_hip_15;
  const Scalar t_front_left_hip_17 = t_front_left_hip_13 + t_front_left_hip_14;
  const Scalar t_front_left_hip_18 = t_front_left_hip_7 - qd[1] * t_front_left_thigh_10;
  tau[0] = t_front_left_hip_17 + t_front_left_hip_16 - qd[0] * t_front_left_hip_18 * 2.0;
}

void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept {
  const auto [s_front_left_abduction, c_front_left_abduction] = sine_cosine(q[0]);
  const auto [s_front_left_hip, c_front_left_hip] = sine_cosine(q[1]);
  const auto [s_front_right_abduction, c_front_right_abduction] = sine_cosine(q[3]);
  const auto [s_front_right_hip, c_front_right_hip] = sine_cosine(q[4]);
  const auto [s_hind_left_abduction, c_hind_left_abduction] = sine_cosine(q[6]);
  const auto [s_hind_left_hip, c_hind_left_hip] = sine_cosine(q[7]);
  const auto [s_hind_right_abduction, c_hind_right_abduction] = sine_cosine(q[9]);
  const auto [s_hind_right_hip, c_hind_right_hip] = sine_cosine(q[10]);
  // front_left_shank
  const Scalar omega_front_left_shank_z = qd[1] + qd[2];
  const Scalar t_front_left_shank_1 = q[1] + q[2];
  const auto [s_front_left_shank, c_front_left_shank] = sine_cosine(t_front_left_shank_1);
  const Scalar h_front_left_shank_y = 0.000815936 * s_front_left_shank;
  const Scalar t_front_left_shank_2 = c_front_left_hip * h_front_left_shank_y;
  const Scalar h_front_left_shank_x = 0.000815936 * c_front_left_shank;
  const Scalar t_front_left_shank_3 = s_front_left_hip * h_front_left_shank_x;
  // front_right_shank
  const Scalar omega_fron_righ_shan_z = qd[4] + qd[5];
  const Scalar t_fron_righ_shan_1 = q[4] + q[5];
  const auto [s_fron_righ_shan, c_fron_righ_shan] = sine_cosine(t_fron_righ_shan_1);
  const Scalar h_fron_righ_shan_x = 0.000815936 * c_fron_righ_shan;
  const Scalar t_fron_righ_shan_2 = s_front_right_hip * h_fron_righ_shan_x;
  const Scalar h_fron_righ_shan_y = 0.000815936 * s_fron_righ_shan;
  const Scalar t_fron_righ_shan_3 = c_front_right_hip * h_fron_righ_shan_y;
  // hind_left_shank
  const Scalar omega_hind_left_shank_z = qd[7] + qd[8];
  const Scalar t_hind_left_shank_1 = q[7] + q[8];
  const auto [s_hind_left_shank, c_hind_left_shank] = sine_cosine(t_hind_left_shank_1);
  const Scalar h_hind_left_shank_x = 0.000815936 * c_hind_left_shank;
  const Scalar t_hind_left_shank_2 = s_hind_left_hip * h_hind_left_shank_x;
  // hind_right_shank
  const Scalar omega_hind_right_shank_z = qd[10] + qd[11];
  const Scalar t_hind_right_shank_1 = q[10] + q[11];
  const auto [s_hind_right_shank, c_hind_right_shank] = sine_cosine(t_hind_right_shank_1);
  const Scalar h_hind_left_shank_y = 0.000815936 * s_hind_left_shank;
  const Scalar t_hind_left_shank_3 = c_hind_left_hip * h_hind_left_shank_y;
  // front_right_shank
  const Scalar t_fron_righ_shan_4 = s_fron_righ_shan * c_fron_righ_shan * 0.000477144;
  const Scalar t_fron_righ_shan_5 = t_fron_righ_shan_3 + t_fron_righ_shan_4;
  const Scalar t_fron_righ_shan_6 = t_fron_righ_shan_2 - t_fron_righ_shan_3;
  const Scalar t_fron_righ_thig_1 = qd[4] * qd[4];
  const Scalar t_front_right_hip_1 = qd[3] * qd[3];
  const Scalar t_fron_righ_shan_7 = c_front_right_abduction * s_fron_righ_shan * 0.03829824;
  const Scalar t_fron_righ_shan_8 = t_fron_righ_shan_6 * t_fron_righ_thig_1;
  const Scalar t_fron_righ_shan_9 = t_fron_righ_shan_5 * t_front_right_hip_1;
  const Scalar t_fron_righ_shan_10 = t_fron_righ_shan_7 - t_fron_righ_shan_8;
  const Scalar M_fron_righ_shan_z = t_fron_righ_shan_10 + t_fron_righ_shan_9;
  const Scalar t_front_left_hip_1 = tau[5] - M_fron_righ_shan_z;
  // hind_right_shank
  const Scalar t_hind_right_shank_2 = 0.000815936 * c_hind_right_hip;
  const Scalar t_hind_right_shank_3 = s_hind_right_shank * t_hind_right_shank_2;
  const Scalar t_hind_right_shank_4 = 0.000815936 * s_hind_right_hip;
  const Scalar t_hind_right_shank_5 = c_hind_right_shank * t_hind_right_shank_4;
  const Scalar t_hind_right_shank_6 = t_hind_right_shank_3 - t_hind_right_shank_5;
  const Scalar t_hind_right_shank_7 = s_hind_right_shank * t_hind_right_shank_4;
  const Scalar t_hind_right_shank_8 = c_hind_right_shank * t_hind_right_shank_2;
  const Scalar t_hind_right_shank_9 = 2.0 * t_hind_right_shank_8;
  // hind_left_shank
  const Scalar t_hind_left_shank_4 = c_hind_left_hip * h_hind_left_shank_x;
  const Scalar t_hind_left_shank_5 = 2.0 * t_hind_left_shank_4;
  const Scalar t_hind_left_shank_6 = s_hind_left_hip * h_hind_left_shank_y;
  // front_right_shank
  const Scalar t_fron_righ_shan_11 = s_front_right_hip * h_fron_righ_shan_y;
  const Scalar t_fron_righ_shan_12 = c_front_right_hip * h_fron_righ_shan_x;
  const Scalar t_fron_righ_shan_13 = 2.0 * t_fron_righ_shan_12;
  // front_left_shank
  const Scalar t_front_left_shank_4 = c_front_left_hip * h_front_left_shank_x;
  const Scalar t_front_left_shank_5 = 2.0 * t_front_left_shank_4;
  const Scalar t_front_left_shank_6 = s_front_left_hip * h_front_left_shank_y;
  const Scalar t_hind_right_shank_10 = t_hind_right_shank_7 + t_hind_right_shank_8;
  const Scalar t_hind_right_shank_11 = 0.000486144 + t_hind_right_shank_10;
  const Scalar t_hind_left_shank_7 = t_hind_left_shank_4 + t_hind_left_shank_6;
  const Scalar t_hind_left_shank_8 = 0.000486144 + t_hind_left_shank_7;
  const Scalar t_fron_righ_shan_14 = t_fron_righ_shan_11 + t_fron_righ_shan_12;
  const Scalar t_fron_righ_shan_15 = 0.000486144 + t_fron_righ_shan_14;
  const Scalar t_front_left_shank_7 = t_front_left_shank_4 + t_front_left_shank_6;
  const Scalar t_front_left_shank_8 = 0.000486144 + t_front_left_shank_7;
  const Scalar t_hind_right_shank_12 = 2057.0036861506055 * t_hind_right_shank_11;
  const Scalar t_hind_right_thigh_1 = 0.005638328 + t_hind_right_shank_9;
  const Scalar I_hind_right_thigh_zz = t_hind_right_thigh_1 + 2.0 * t_hind_right_shank_7;
  const Scalar t_hind_right_shank_13 = t_hind_right_shank_11 * t_hind_right_shank_12;
  const Scalar t_hind_right_thigh_2 = 1.0 / (I_hind_right_thigh_zz - t_hind_right_shank_13);
  const Scalar t_hind_right_shank_14 = 0.4978936282253818 * s_hind_right_shank;
  const Scalar t_hind_right_thigh_3 = 0.001819852 * s_hind_right_hip;
  const Scalar t_hind_right_thigh_4 = t_hind_right_thigh_3 - 0.000245 * c_hind_right_hip;
  const Scalar t_hind_right_shank_15 = t_hind_right_shank_10 * t_hind_right_shank_14;
  const Scalar t_hind_right_shank_16 = t_hind_right_thigh_4 - t_hind_right_shank_15;
  const Scalar t_hind_right_thigh_5 = 0.004624184 * s_hind_right_hip + 2.6e-05 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_6 = t_hind_right_thigh_2 * t_hind_right_shank_16;
  // hind_right_shank
  const Scalar t_hind_right_shank_17 = s_hind_right_shank * s_hind_right_shank;
  const Scalar t_hind_right_shank_18 = 0.0005976581569246972 * t_hind_right_shank_17;
  const Scalar t_hind_right_shank_19 = 0.01069944 + t_hind_right_shank_9;
  const Scalar t_hind_right_shank_20 = t_hind_right_shank_19 - t_hind_right_shank_18;
  const Scalar t_hind_right_thigh_7 = s_hind_right_hip * t_hind_right_thigh_5;
  const Scalar t_hind_right_shank_21 = t_hind_right_shank_20 - t_hind_right_thigh_7;
  const Scalar t_hind_right_thigh_8 = t_hind_right_shank_16 * t_hind_right_thigh_6;
  const Scalar t_hind_right_hip_1 = 1.0 / (t_hind_right_shank_21 - t_hind_right_thigh_8);
  const Scalar t_hind_left_shank_9 = 0.4978936282253818 * s_hind_left_shank;
  const Scalar t_hind_left_thigh_1 = 0.001819852 * s_hind_left_hip - 0.000245 * c_hind_left_hip;
  // hind_left_shank
  const Scalar t_hind_left_shank_10 = t_hind_left_shank_7 * t_hind_left_shank_9;
  const Scalar t_hind_left_shank_11 = t_hind_left_thigh_1 - t_hind_left_shank_10;
  const Scalar t_hind_left_shank_12 = 2057.0036861506055 * t_hind_left_shank_8;
  const Scalar t_hind_left_thigh_2 = 0.005638328 + t_hind_left_shank_5;
  const Scalar I_hind_left_thigh_zz = t_hind_left_thigh_2 + 2.0 * t_hind_left_shank_6;
  const Scalar t_hind_left_shank_13 = t_hind_left_shank_8 * t_hind_left_shank_12;
  // hind_left_thigh
  const Scalar t_hind_left_thigh_3 = 1.0 / (I_hind_left_thigh_zz - t_hind_left_shank_13);
  const Scalar t_hind_left_thigh_4 = 2.6e-05 * c_hind_left_hip + 0.004624184 * s_hind_left_hip;
  const Scalar t_hind_left_thigh_5 = t_hind_left_shank_11 * t_hind_left_thigh_3;
  const Scalar t_hind_left_thigh_6 = s_hind_left_shank * s_hind_left_shank;
  const Scalar t_hind_left_thigh_7 = 0.0005976581569246972 * t_hind_left_thigh_6;
  const Scalar t_hind_left_thigh_8 = 0.01069944 + t_hind_left_shank_5 - t_hind_left_thigh_7;
  const Scalar t_hind_left_thigh_9 = t_hind_left_shank_11 * t_hind_left_thigh_5;
  const Scalar t_hind_left_thigh_10 = t_hind_left_thigh_8 - t_hind_left_thigh_9;
  const Scalar t_hind_left_thigh_11 = s_hind_left_hip * t_hind_left_thigh_4;
  const Scalar t_hind_left_hip_1 = 1.0 / (t_hind_left_thigh_10 - t_hind_left_thigh_11);
  const Scalar t_fron_righ_shan_16 = 2057.0036861506055 * t_fron_righ_shan_15;
  const Scalar t_fron_righ_thig_2 = 0.005638328 + t_fron_righ_shan_13;
  const Scalar I_fron_righ_thig_zz = t_fron_righ_thig_2 + 2.0 * t_fron_righ_shan_11;
  const Scalar t_fron_righ_shan_17 = t_fron_righ_shan_15 * t_fron_righ_shan_16;
  const Scalar t_fron_righ_thig_3 = 1.0 / (I_fron_righ_thig_zz - t_fron_righ_shan_17);
  const Scalar t_fron_righ_thig_4 = 2.6e-05 * c_front_right_hip + 0.004624184 * s_front_right_hip;
  const Scalar t_fron_righ_shan_18 = 0.4978936282253818 * s_fron_righ_shan;
  const Scalar t_fron_righ_thig_5 = 0.001819852 * s_front_right_hip;
  const Scalar t_fron_righ_thig_6 = t_fron_righ_thig_5 - 0.000245 * c_front_right_hip;
  const Scalar t_fron_righ_shan_19 = t_fron_righ_shan_14 * t_fron_righ_shan_18;
  const Scalar t_fron_righ_shan_20 = t_fron_righ_thig_6 - t_fron_righ_shan_19;
  const Scalar t_fron_righ_thig_7 = t_fron_righ_thig_3 * t_fron_righ_shan_20;
  const Scalar t_fron_righ_shan_21 = s_fron_righ_shan * s_fron_righ_shan * 0.0005976581569246972;
  const Scalar t_fron_righ_shan_22 = 0.01069944 + t_fron_righ_shan_13 - t_fron_righ_shan_21;
  const Scalar t_fron_righ_thig_8 = s_front_right_hip * t_fron_righ_thig_4;
  const Scalar t_fron_righ_shan_23 = t_fron_righ_shan_22 - t_fron_righ_thig_8;
  const Scalar t_fron_righ_thig_9 = t_fron_righ_shan_20 * t_fron_righ_thig_7;
  const Scalar t_front_right_hip_2 = 1.0 / (t_fron_righ_shan_23 - t_fron_righ_thig_9);
  const Scalar t_front_left_shank_9 = 2057.0036861506055 * t_front_left_shank_8;
  const Scalar t_front_left_thigh_1 = 0.005638328 + t_front_left_shank_5;
  const Scalar I_front_left_thigh_zz = t_front_left_thigh_1 + 2.0 * t_front_left_shank_6;
  const Scalar t_front_left_shank_10 = t_front_left_shank_8 * t_front_left_shank_9;
  const Scalar t_front_left_thigh_2 = 1.0 / (I_front_left_thigh_zz - t_front_left_shank_10);
  const Scalar t_front_left_thigh_3 = 2.6e-05 * c_front_left_hip + 0.004624184 * s_front_left_hip;
  const Scalar t_front_left_shank_11 = 0.4978936282253818 * s_front_left_shank;
  const Scalar t_front_left_thigh_4 = 0.001819852 * s_front_left_hip;
  const Scalar t_front_left_thigh_5 = 0.000245 * c_front_left_hip - t_front_left_thigh_4;
  const Scalar t_front_left_shank_12 = t_front_left_shank_7 * t_front_left_shank_11;
  const Scalar t_front_left_shank_13 = t_front_left_thigh_5 + t_front_left_shank_12;
  const Scalar t_front_left_thigh_6 = t_front_left_thigh_2 * t_front_left_shank_13;
  // front_left_shank
  const Scalar t_front_left_shank_14 = s_front_left_shank * s_front_left_shank;
  const Scalar t_front_left_shank_15 = 0.0005976581569246972 * t_front_left_shank_14;
  const Scalar t_front_left_shank_16 = 0.01069944 + t_front_left_shank_5;
  const Scalar t_front_left_shank_17 = t_front_left_shank_16 - t_front_left_shank_15;
  const Scalar t_front_left_thigh_7 = s_front_left_hip * t_front_left_thigh_3;
  const Scalar t_front_left_shank_18 = t_front_left_shank_17 - t_front_left_thigh_7;
  const Scalar t_front_left_thigh_8 = t_front_left_shank_13 * t_front_left_thigh_6;
  const Scalar t_front_left_hip_2 = 1.0 / (t_front_left_shank_18 - t_front_left_thigh_8);
  const Scalar t_front_left_shank_19 = s_front_left_shank * c_front_left_shank * 0.000477144;
  const Scalar t_front_left_shank_20 = t_front_left_shank_2 + t_front_left_shank_19;
  const Scalar t_front_left_hip_3 = qd[0] * qd[0];
  const Scalar t_front_left_shank_21 = t_front_left_shank_2 - t_front_left_shank_3;
  const Scalar t_front_left_thigh_9 = qd[1] * qd[1];
  const Scalar t_front_left_shank_22 = c_front_left_abduction * s_front_left_shank * 0.03829824;
  const Scalar t_front_left_shank_23 = t_front_left_shank_20 * t_front_left_hip_3;
  const Scalar t_front_left_shank_24 = t_front_left_shank_22 + t_front_left_shank_23;
  const Scalar t_front_left_shank_25 = t_front_left_shank_21 * t_front_left_thigh_9;
  const Scalar M_front_left_shank_z = t_front_left_shank_24 + t_front_left_shank_25;
  const Scalar t_front_left_hip_4 = tau[2] - M_front_left_shank_z;
  const Scalar t_front_left_shank_26 = omega_front_left_shank_z * omega_front_left_shank_z;
  const Scalar t_front_left_thigh_10 = c_front_left_hip * t_front_left_thigh_3;
  const Scalar t_front_left_hip_5 = 1.3e-05 - t_front_left_shank_3 - t_front_left_thigh_10;
  const Scalar t_front_left_thigh_11 = c_front_left_abduction * s_front_left_hip * 0.25560936;
  // front_left_hip
  const Scalar t_front_left_hip_6 = tau[1] - M_front_left_shank_z - t_front_left_thigh_11;
  const Scalar t_front_left_hip_7 = t_front_left_shank_9 * t_front_left_hip_4;
  const Scalar t_front_left_hip_8 = t_front_left_shank_21 * t_front_left_shank_26;
  const Scalar t_front_left_hip_9 = t_front_left_hip_6 - t_front_left_hip_7;
  const Scalar t_front_left_hip_10 = t_front_left_hip_9 + t_front_left_hip_8;
  const Scalar t_front_left_hip_11 = t_front_left_hip_3 * t_front_left_hip_5;
  const Scalar t_front_left_hip_12 = t_front_left_hip_10 + t_front_left_hip_11;
  const Scalar t_front_left_hip_13 = 0.000242048 * t_front_left_shank_26;
  const Scalar t_front_left_thigh_12 = 0.001819852 * c_front_left_hip;
  const Scalar t_front_left_hip_14 = omega_front_left_shank_z * t_front_left_shank_20;
  const Scalar t_front_left_hip_15 = t_front_left_thigh_6 * t_front_left_hip_12;
  const Scalar t_front_left_hip_16 = tau[0] - 0.7147566 * c_front_left_abduction;
  const Scalar t_front_left_thigh_13 = s_front_left_abduction * c_front_left_hip * 0.25560936;
  const Scalar t_front_left_hip_17 = t_front_left_hip_16 + t_front_left_hip_15;
  const Scalar t_front_left_hip_18 = t_front_left_hip_13 + 0.03829824 * s_front_left_abduction;
  const Scalar t_front_left_hip_19 = t_front_left_hip_17 - t_front_left_thigh_13;
  const Scalar t_front_left_hip_20 = c_front_left_shank * t_front_left_hip_18;
  const Scalar t_front_left_thigh_14 = 0.000245 * s_front_left_hip + t_front_left_thigh_12;
  const Scalar t_front_left_thigh_15 = t_front_left_thigh_9 * t_front_left_thigh_14;
  const Scalar t_front_left_hip_21 = t_front_left_hip_19 - t_front_left_hip_20;
  const Scalar t_front_left_hip_22 = qd[0] * (t_front_left_hip_14 - qd[1] * t_front_left_hip_5);
  const Scalar t_front_left_hip_23 = t_front_left_hip_21 - t_front_left_thigh_15;
  const Scalar t_front_left_hip_24 = t_front_left_hip_23 + 2.0 * t_front_left_hip_22;
  const Scalar t_front_left_hip_25 = t_front_left_shank_11 * t_front_left_hip_4;
  const Scalar t_front_left_hip_26 = t_front_left_hip_24 - t_front_left_hip_25;
  const Scalar t_front_left_hip_27 = t_front_left_hip_2 * t_front_left_hip_26;
  qdd[0] = t_front_left_hip_27;
  const Scalar t_front_left_hip_28 = t_front_left_thigh_2 * t_front_left_hip_12;
  const Scalar t_front_left_hip_29 = t_front_left_thigh_6 * t_front_left_hip_27;
  const Scalar t_front_left_hip_30 = t_front_left_hip_28 + t_front_left_hip_29;
  qdd[1] = t_front_left_hip_30;
  const Scalar t_front_left_hip_31 = t_front_left_shank_8 * t_front_left_hip_30;
  const Scalar t_front_left_hip_32 = t_front_left_hip_4 - t_front_left_hip_31;
  const Scalar t_front_left_hip_33 = t_front_left_shank_11 * t_front_left_hip_27;
  qdd[2] = 2057.0036861506055 * t_front_left_hip_32 - t_front_left_hip_33;
  const Scalar t_hind_right_thigh_9 = qd[10] * qd[10];
  const Scalar t_front_left_hip_34 = 0.001819852 * t_hind_right_thigh_9;
  const Scalar t_front_left_hip_35 = 0.25560936 * s_hind_right_abduction - t_front_left_hip_34;
  const Scalar t_hind_right_shank_22 = s_hind_right_shank * c_hind_right_shank * 0.000477144;
  const Scalar t_hind_right_shank_23 = t_hind_right_shank_3 + t_hind_right_shank_22;
  const Scalar t_hind_right_hip_2 = qd[9] * qd[9];
  // hind_right_shank
  const Scalar t_hind_right_shank_24 = c_hind_right_abduction * s_hind_right_shank * 0.03829824;
  const Scalar t_hind_right_shank_25 = t_hind_right_shank_6 * t_hind_right_thigh_9;
  const Scalar t_hind_right_shank_26 = t_hind_right_shank_24 + t_hind_right_shank_25;
  const Scalar t_hind_right_shank_27 = t_hind_right_shank_23 * t_hind_right_hip_2;
  const Scalar M_hind_right_shank_z = t_hind_right_shank_26 + t_hind_right_shank_27;
  const Scalar t_front_left_hip_36 = tau[11] - M_hind_right_shank_z;
  const Scalar t_hind_right_thigh_10 = c_hind_right_hip * t_hind_right_thigh_5;
  const Scalar t_front_left_hip_37 = 1.3e-05 - t_hind_right_shank_5 - t_hind_right_thigh_10;
  const Scalar t_hind_right_shank_28 = omega_hind_right_shank_z * omega_hind_right_shank_z;
  const Scalar t_hind_right_thigh_11 = c_hind_right_abduction * s_hind_right_hip * 0.25560936;
  // front_left_hip
  const Scalar t_front_left_hip_38 = tau[10] - M_hind_right_shank_z - t_hind_right_thigh_11;
  const Scalar t_front_left_hip_39 = t_hind_right_shank_12 * t_front_left_hip_36;
  const Scalar t_front_left_hip_40 = t_front_left_hip_38 - t_front_left_hip_39;
  const Scalar t_front_left_hip_41 = t_hind_right_hip_2 * t_front_left_hip_37;
  const Scalar t_front_left_hip_42 = t_hind_right_shank_6 * t_hind_right_shank_28;
  const Scalar t_front_left_hip_43 = t_front_left_hip_40 + t_front_left_hip_41;
  const Scalar t_front_left_hip_44 = t_front_left_hip_43 + t_front_left_hip_42;
  const Scalar t_front_left_hip_45 = 0.000242048 * t_hind_right_shank_28;
  const Scalar t_front_left_hip_46 = omega_hind_right_shank_z * t_hind_right_shank_23;
  const Scalar t_front_left_hip_47 = s_hind_right_hip * t_hind_right_thigh_9 * 0.000245;
  const Scalar t_front_left_hip_48 = tau[9] + 0.7147566 * c_hind_right_abduction;
  const Scalar t_front_left_hip_49 = t_front_left_hip_48 + t_front_left_hip_47;
  const Scalar t_front_left_hip_50 = c_hind_right_hip * t_front_left_hip_35;
  const Scalar t_front_left_hip_51 = t_hind_right_thigh_6 * t_front_left_hip_44;
  const Scalar t_front_left_hip_52 = t_front_left_hip_49 - t_front_left_hip_50;
  const Scalar t_front_left_hip_53 = t_hind_right_shank_14 * t_front_left_hip_36;
  const Scalar t_front_left_hip_54 = t_front_left_hip_52 + t_front_left_hip_51;
  const Scalar t_front_left_hip_55 = t_front_left_hip_45 - 0.03829824 * s_hind_right_abduction;
  const Scalar t_front_left_hip_56 = t_front_left_hip_54 + t_front_left_hip_53;
  const Scalar t_front_left_hip_57 = c_hind_right_shank * t_front_left_hip_55;
  const Scalar t_front_left_hip_58 = t_front_left_hip_46 - qd[10] * t_front_left_hip_37;
  const Scalar t_front_left_hip_59 = t_front_left_hip_56 + t_front_left_hip_57;
  const Scalar t_front_left_hip_60 = t_front_left_hip_59 + qd[9] * t_front_left_hip_58 * 2.0;
  const Scalar t_front_left_hip_61 = t_hind_right_hip_1 * t_front_left_hip_60;
  qdd[9] = t_front_left_hip_61;
  const Scalar t_front_left_hip_62 = t_hind_right_thigh_2 * t_front_left_hip_44;
  const Scalar t_front_left_hip_63 = t_hind_right_thigh_6 * t_front_left_hip_61;
  const Scalar t_front_left_hip_64 = t_front_left_hip_62 + t_front_left_hip_63;
  qdd[10] = t_front_left_hip_64;
  const Scalar t_front_left_hip_65 = t_hind_right_shank_14 * t_front_left_hip_61;
  const Scalar t_front_left_hip_66 = t_hind_right_shank_12 * t_front_left_hip_64;
  const Scalar t_front_left_hip_67 = t_front_left_hip_65 - t_front_left_hip_66;
  qdd[11] = t_front_left_hip_67 + 2057.0036861506055 * t_front_left_hip_36;
  const Scalar t_hind_left_shank_14 = s_hind_left_shank * c_hind_left_shank * 0.000477144;
  const Scalar t_hind_left_shank_15 = t_hind_left_shank_3 + t_hind_left_shank_14;
  const Scalar t_hind_left_hip_2 = qd[6] * qd[6];
  const Scalar t_hind_left_shank_16 = t_hind_left_shank_2 - t_hind_left_shank_3;
  const Scalar t_hind_left_thigh_12 = qd[7] * qd[7];
  // hind_left_shank
  const Scalar t_hind_left_shank_17 = c_hind_left_abduction * s_hind_left_shank * 0.03829824;
  const Scalar t_hind_left_shank_18 = t_hind_left_shank_15 * t_hind_left_hip_2;
  const Scalar t_hind_left_shank_19 = t_hind_left_shank_17 + t_hind_left_shank_18;
  const Scalar t_hind_left_shank_20 = t_hind_left_shank_16 * t_hind_left_thigh_12;
  const Scalar M_hind_left_shank_z = t_hind_left_shank_19 - t_hind_left_shank_20;
  const Scalar t_hind_left_thigh_13 = c_hind_left_hip * t_hind_left_thigh_4;
  const Scalar t_front_left_hip_68 = 1.3e-05 - t_hind_left_shank_2 - t_hind_left_thigh_13;
  const Scalar t_hind_left_shank_21 = omega_hind_left_shank_z * omega_hind_left_shank_z;
  const Scalar t_front_left_hip_69 = tau[8] - M_hind_left_shank_z;
  const Scalar t_hind_left_thigh_14 = c_hind_left_abduction * s_hind_left_hip * 0.25560936;
  // front_left_hip
  const Scalar t_front_left_hip_70 = tau[7] - M_hind_left_shank_z - t_hind_left_thigh_14;
  const Scalar t_front_left_hip_71 = t_hind_left_hip_2 * t_front_left_hip_68;
  const Scalar t_front_left_hip_72 = t_hind_left_shank_16 * t_hind_left_shank_21;
  const Scalar t_front_left_hip_73 = t_front_left_hip_70 + t_front_left_hip_71;
  const Scalar t_front_left_hip_74 = t_hind_left_shank_12 * t_front_left_hip_69;
  const Scalar t_front_left_hip_75 = t_front_left_hip_73 - t_front_left_hip_72;
  const Scalar t_front_left_hip_76 = t_front_left_hip_75 - t_front_left_hip_74;
  const Scalar t_front_left_hip_77 = t_hind_left_thigh_3 * t_front_left_hip_76;
  const Scalar t_front_left_hip_78 = 0.000242048 * t_hind_left_shank_21;
  const Scalar t_front_left_hip_79 = omega_hind_left_shank_z * t_hind_left_shank_15;
  const Scalar t_hind_left_thigh_15 = s_hind_left_abduction * c_hind_left_hip * 0.25560936;
  const Scalar t_front_left_hip_80 = tau[6] - 0.7147566 * c_hind_left_abduction;
  const Scalar t_front_left_hip_81 = t_front_left_hip_80 - t_hind_left_thigh_15;
  const Scalar t_front_left_hip_82 = t_hind_left_shank_11 * t_front_left_hip_77;
  const Scalar t_front_left_hip_83 = t_front_left_hip_78 + 0.03829824 * s_hind_left_abduction;
  const Scalar t_front_left_hip_84 = t_front_left_hip_81 - t_front_left_hip_82;
  const Scalar t_front_left_hip_85 = c_hind_left_shank * t_front_left_hip_83;
  const Scalar t_front_left_hip_86 = qd[6] * (qd[7] * t_front_left_hip_68 - t_front_left_hip_79);
  const Scalar t_front_left_hip_87 = t_front_left_hip_84 - t_front_left_hip_85;
  const Scalar t_hind_left_thigh_16 = 0.000245 * s_hind_left_hip + 0.001819852 * c_hind_left_hip;
  const Scalar t_front_left_hip_88 = t_front_left_hip_87 - 2.0 * t_front_left_hip_86;
  const Scalar t_hind_left_thigh_17 = t_hind_left_thigh_12 * t_hind_left_thigh_16;
  const Scalar t_front_left_hip_89 = t_front_left_hip_88 - t_hind_left_thigh_17;
  const Scalar t_front_left_hip_90 = t_hind_left_shank_9 * t_front_left_hip_69;
  const Scalar t_front_left_hip_91 = t_front_left_hip_89 - t_front_left_hip_90;
  const Scalar t_front_left_hip_92 = t_hind_left_hip_1 * t_front_left_hip_91;
  qdd[6] = t_front_left_hip_92;
  const Scalar t_front_left_hip_93 = t_hind_left_thigh_5 * t_front_left_hip_92;
  const Scalar t_front_left_hip_94 = t_front_left_hip_77 - t_front_left_hip_93;
  qdd[7] = t_front_left_hip_94;
  const Scalar t_front_left_hip_95 = t_hind_left_shank_9 * t_front_left_hip_92;
  const Scalar t_front_left_hip_96 = t_hind_left_shank_12 * t_front_left_hip_94;
  const Scalar t_front_left_hip_97 = t_front_left_hip_95 + t_front_left_hip_96;
  qdd[8] = 2057.0036861506055 * t_front_left_hip_69 - t_front_left_hip_97;
  const Scalar t_front_left_hip_98 = 0.25560936 * s_front_right_abduction;
  const Scalar t_front_left_hip_99 = t_front_left_hip_98 - 0.001819852 * t_fron_righ_thig_1;
  const Scalar t_fron_righ_thig_10 = c_front_right_hip * t_fron_righ_thig_4;
  const Scalar t_front_left_hip_100 = 1.3e-05 - t_fron_righ_shan_2 - t_fron_righ_thig_10;
  const Scalar t_front_left_hip_101 = omega_fron_righ_shan_z * t_fron_righ_shan_5;
  const Scalar t_fron_righ_shan_24 = omega_fron_righ_shan_z * omega_fron_righ_shan_z;
  const Scalar t_fron_righ_thig_11 = c_front_right_abduction * s_front_right_hip * 0.25560936;
  const Scalar t_front_left_hip_102 = tau[4] - M_fron_righ_shan_z - t_fron_righ_thig_11;
  const Scalar t_front_left_hip_103 = t_front_left_hip_1 * t_fron_righ_shan_16;
  const Scalar t_front_left_hip_104 = t_front_left_hip_102 - t_front_left_hip_103;
  const Scalar t_front_left_hip_105 = t_fron_righ_shan_6 * t_fron_righ_shan_24;
  const Scalar t_front_left_hip_106 = t_front_right_hip_1 * t_front_left_hip_100;
  const Scalar t_front_left_hip_107 = t_front_left_hip_104 - t_front_left_hip_105;
  const Scalar t_front_left_hip_108 = t_front_left_hip_107 + t_front_left_hip_106;
  const Scalar t_front_left_hip_109 = 0.03829824 * s_front_right_abduction;
  const Scalar t_front_left_hip_110 = s_front_right_hip * t_fron_righ_thig_1 * 0.000245;
  const Scalar t_front_left_hip_111 = tau[3] + 0.7147566 * c_front_right_abduction;
  const Scalar t_front_left_hip_112 = t_front_left_hip_111 + t_front_left_hip_110;
  const Scalar t_front_left_hip_113 = c_front_right_hip * t_front_left_hip_99;
  const Scalar t_front_left_hip_114 = qd[3] * (qd[4] * t_front_left_hip_100 - t_front_left_hip_101);
  const Scalar t_front_left_hip_115 = t_front_left_hip_112 - t_front_left_hip_113;
  const Scalar t_front_left_hip_116 = t_front_left_hip_115 - 2.0 * t_front_left_hip_114;
  const Scalar t_front_left_hip_117 = t_fron_righ_thig_7 * t_front_left_hip_108;
  const Scalar t_front_left_hip_118 = 0.000242048 * t_fron_righ_shan_24 - t_front_left_hip_109;
  const Scalar t_front_left_hip_119 = t_front_left_hip_116 + t_front_left_hip_117;
  const Scalar t_front_left_hip_120 = c_fron_righ_shan * t_front_left_hip_118;
  const Scalar t_front_left_hip_121 = t_front_left_hip_119 + t_front_left_hip_120;
  const Scalar t_front_left_hip_122 = t_front_left_hip_1 * t_fron_righ_shan_18;
  const Scalar t_front_left_hip_123 = t_front_left_hip_121 + t_front_left_hip_122;
  const Scalar t_front_left_hip_124 = t_front_right_hip_2 * t_front_left_hip_123;
  qdd[3] = t_front_left_hip_124;
  const Scalar t_front_left_hip_125 = t_fron_righ_thig_7 * t_front_left_hip_124;
  const Scalar t_front_left_hip_126 = t_fron_righ_thig_3 * t_front_left_hip_108;
  const Scalar t_front_left_hip_127 = t_front_left_hip_125 + t_front_left_hip_126;
  qdd[4] = t_front_left_hip_127;
  const Scalar t_front_left_hip_128 = t_fron_righ_shan_18 * t_front_left_hip_124;
  const Scalar t_front_left_hip_129 = t_fron_righ_shan_16 * t_front_left_hip_127;
  const Scalar t_front_left_hip_130 = t_front_left_hip_128 - t_front_left_hip_129;
  qdd[5] = t_front_left_hip_130 + 2057.0036861506055 * t_front_left_hip_1;
}

void point_positions(const Scalar q[12], Scalar p[12]) noexcept {
  const auto [s_front_left_abduction, c_front_left_abduction] = sine_cosine(q[0]);
  // front_left_shank
  const Scalar t_front_left_shank_1 = q[1] + q[2];
  const auto [s_front_left_shank, c_front_left_shank] = sine_cosine(t_front_left_shank_1);
  const auto [s_front_left_hip, c_front_left_hip] = sine_cosine(q[1]);
  const auto [s_front_right_abduction, c_front_right_abduction] = sine_cosine(q[3]);
  // front_right_shank
  const Scalar t_fron_righ_shan_1 = q[4] + q[5];
  const auto [s_fron_righ_shan, c_fron_righ_shan] = sine_cosine(t_fron_righ_shan_1);
  const auto [s_front_right_hip, c_front_right_hip] = sine_cosine(q[4]);
  const auto [s_hind_left_abduction, c_hind_left_abduction] = sine_cosine(q[6]);
  // hind_left_shank
  const Scalar t_hind_left_shank_1 = q[7] + q[8];
  const auto [s_hind_left_shank, c_hind_left_shank] = sine_cosine(t_hind_left_shank_1);
  const auto [s_hind_left_hip, c_hind_left_hip] = sine_cosine(q[7]);
  const auto [s_hind_right_abduction, c_hind_right_abduction] = sine_cosine(q[9]);
  // hind_right_shank
  const Scalar t_hind_right_shank_1 = q[10] + q[11];
  const auto [s_hind_right_shank, c_hind_right_shank] = sine_cosine(t_hind_right_shank_1);
  const auto [s_hind_right_hip, c_hind_right_hip] = sine_cosine(q[10]);
  const Scalar t_front_left_shank_2 = 0.209 * c_front_left_hip + 0.175 * c_front_left_shank;
  // front_left_hip
  const Scalar t_front_left_hip_1 = s_front_left_abduction * t_front_left_shank_2;
  p[1] = 0.049 + 0.062 * c_front_left_abduction + t_front_left_hip_1;
  p[2] = 0.062 * s_front_left_abduction - c_front_left_abduction * t_front_left_shank_2;
  p[0] = 0.19 + 0.209 * s_front_left_hip + 0.175 * s_front_left_shank;
  const Scalar t_fron_righ_shan_2 = 0.209 * c_front_right_hip + 0.175 * c_fron_righ_shan;
  // front_right_hip
  const Scalar t_front_right_hip_1 = s_front_right_abduction * t_fron_righ_shan_2;
  p[4] = t_front_right_hip_1 - (0.049 + 0.062 * c_front_right_abduction);
  p[5] = -(0.062 * s_front_right_abduction + c_front_right_abduction * t_fron_righ_shan_2);
  p[3] = 0.19 + 0.209 * s_front_right_hip + 0.175 * s_fron_righ_shan;
  const Scalar t_hind_left_shank_2 = 0.209 * c_hind_left_hip + 0.175 * c_hind_left_shank;
  // hind_left_hip
  p[7] = 0.049 + 0.062 * c_hind_left_abduction + s_hind_left_abduction * t_hind_left_shank_2;
  p[8] = 0.062 * s_hind_left_abduction - c_hind_left_abduction * t_hind_left_shank_2;
  p[6] = 0.175 * s_hind_left_shank - (0.19 - 0.209 * s_hind_left_hip);
  const Scalar t_hind_right_shank_2 = 0.209 * c_hind_right_hip + 0.175 * c_hind_right_shank;
  // hind_right_hip
  const Scalar t_hind_right_hip_1 = s_hind_right_abduction * t_hind_right_shank_2;
  p[10] = t_hind_right_hip_1 - (0.049 + 0.062 * c_hind_right_abduction);
  p[11] = -(0.062 * s_hind_right_abduction + c_hind_right_abduction * t_hind_right_shank_2);
  p[9] = 0.175 * s_hind_right_shank - (0.19 - 0.209 * s_hind_right_hip);
}

void force_jacobian_transpose(const Scalar q[12], Scalar C[144]) noexcept {
  const auto [s_front_left_abduction, c_front_left_abduction] = sine_cosine(q[0]);
  const auto [s_front_left_hip, c_front_left_hip] = sine_cosine(q[1]);
  const auto [s_front_right_abduction, c_front_right_abduction] = sine_cosine(q[3]);
  const auto [s_front_right_hip, c_front_right_hip] = sine_cosine(q[4]);
  const auto [s_hind_left_abduction, c_hind_left_abduction] = sine_cosine(q[6]);
  const auto [s_hind_left_hip, c_hind_left_hip] = sine_cosine(q[7]);
  const auto [s_hind_right_abduction, c_hind_right_abduction] = sine_cosine(q[9]);
  const auto [s_hind_right_hip, c_hind_right_hip] = sine_cosine(q[10]);
  const Scalar t_front_left_hip_1 = q[10] + q[11];
  const auto [s_front_left_hip_2, c_front_left_hip_2] = sine_cosine(t_front_left_hip_1);
  const Scalar r_hind_right_shank_x = 0.175 * c_front_left_hip_2;
  C[141] = r_hind_right_shank_x;
  const Scalar t_front_left_hip_2 = q[4] + q[5];
  const auto [s_front_left_hip_3, c_front_left_hip_3] = sine_cosine(t_front_left_hip_2);
  const Scalar r_fron_righ_shan_y = 0.175 * s_front_left_hip_3;
  const Scalar t_front_left_hip_3 = q[1] + q[2];
  const auto [s_front_left_hip_4, c_front_left_hip_4] = sine_cosine(t_front_left_hip_3);
  const Scalar r_front_left_shank_y = 0.175 * s_front_left_hip_4;
  const Scalar r_hind_right_shank_y = 0.175 * s_front_left_hip_2;
  const Scalar t_front_left_hip_4 = q[7] + q[8];
  const auto [s_front_left_hip_5, c_front_left_hip_5] = sine_cosine(t_front_left_hip_4);
  const Scalar r_hind_left_shank_x = 0.175 * c_front_left_hip_5;
  C[102] = r_hind_left_shank_x;
  const Scalar r_hind_left_shank_y = 0.175 * s_front_left_hip_5;
  const Scalar r_front_left_shank_x = 0.175 * c_front_left_hip_4;
  C[24] = r_front_left_shank_x;
  const Scalar r_fron_righ_shan_x = 0.175 * c_front_left_hip_3;
  C[63] = r_fron_righ_shan_x;
  const Scalar r_front_left_thigh_y = r_front_left_shank_y + 0.209 * s_front_left_hip;
  const Scalar r_front_left_thigh_x = r_front_left_shank_x + 0.209 * c_front_left_hip;
  C[12] = r_front_left_thigh_x;
  C[2] = 0.062 * c_front_left_abduction + s_front_left_abduction * r_front_left_thigh_x;
  C[1] = c_front_left_abduction * r_front_left_thigh_x - 0.062 * s_front_left_abduction;
  // front_left_hip
  C[13] = -s_front_left_abduction * r_front_left_thigh_y;
  C[14] = c_front_left_abduction * r_front_left_thigh_y;
  C[26] = c_front_left_abduction * r_front_left_shank_y;
  C[25] = -s_front_left_abduction * r_front_left_shank_y;
  // front_right_thigh
  const Scalar r_fron_righ_thig_x = r_fron_righ_shan_x + 0.209 * c_front_right_hip;
  C[51] = r_fron_righ_thig_x;
  const Scalar r_fron_righ_thig_y = r_fron_righ_shan_y + 0.209 * s_front_right_hip;
  C[40] = 0.062 * s_front_right_abduction + c_front_right_abduction * r_fron_righ_thig_x;
  C[41] = s_front_right_abduction * r_fron_righ_thig_x - 0.062 * c_front_right_abduction;
  // front_left_hip
  C[52] = -s_front_right_abduction * r_fron_righ_thig_y;
  C[53] = c_front_right_abduction * r_fron_righ_thig_y;
  C[65] = c_front_right_abduction * r_fron_righ_shan_y;
  C[64] = -s_front_right_abduction * r_fron_righ_shan_y;
  // hind_left_thigh
  const Scalar r_hind_left_thigh_y = r_hind_left_shank_y + 0.209 * s_hind_left_hip;
  const Scalar r_hind_left_thigh_x = r_hind_left_shank_x + 0.209 * c_hind_left_hip;
  C[90] = r_hind_left_thigh_x;
  C[79] = c_hind_left_abduction * r_hind_left_thigh_x - 0.062 * s_hind_left_abduction;
  C[80] = 0.062 * c_hind_left_abduction + s_hind_left_abduction * r_hind_left_thigh_x;
  // front_left_hip
  C[92] = c_hind_left_abduction * r_hind_left_thigh_y;
  C[91] = -s_hind_left_abduction * r_hind_left_thigh_y;
  C[104] = c_hind_left_abduction * r_hind_left_shank_y;
  C[103] = -s_hind_left_abduction * r_hind_left_shank_y;
  const Scalar r_hind_right_thigh_y = r_hind_right_shank_y + 0.209 * s_hind_right_hip;
  const Scalar r_hind_right_thigh_x = r_hind_right_shank_x + 0.209 * c_hind_right_hip;
  C[129] = r_hind_right_thigh_x;
  C[119] = s_hind_right_abduction * r_hind_right_thigh_x - 0.062 * c_hind_right_abduction;
  C[118] = 0.062 * s_hind_right_abduction + c_hind_right_abduction * r_hind_right_thigh_x;
  C[131] = c_hind_right_abduction * r_hind_right_thigh_y;
  C[130] = -s_hind_right_abduction * r_hind_right_thigh_y;
  C[142] = -s_hind_right_abduction * r_hind_right_shank_y;
  C[143] = c_hind_right_abduction * r_hind_right_shank_y;
  C[0] = 0.0;
  C[3] = 0.0;
  C[4] = 0.0;
  C[5] = 0.0;
  C[6] = 0.0;
  C[7] = 0.0;
  C[8] = 0.0;
  C[9] = 0.0;
  C[10] = 0.0;
  C[11] = 0.0;
  C[15] = 0.0;
  C[16] = 0.0;
  C[17] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
  C[21] = 0.0;
  C[22] = 0.0;
  C[23] = 0.0;
  C[27] = 0.0;
  C[28] = 0.0;
  C[29] = 0.0;
  C[30] = 0.0;
  C[31] = 0.0;
  C[32] = 0.0;
  C[33] = 0.0;
  C[34] = 0.0;
  C[35] = 0.0;
  C[36] = 0.0;
  C[37] = 0.0;
  C[38] = 0.0;
  C[39] = 0.0;
  C[42] = 0.0;
  C[43] = 0.0;
  C[44] = 0.0;
  C[45] = 0.0;
  C[46] = 0.0;
  C[47] = 0.0;
  C[48] = 0.0;
  C[49] = 0.0;
  C[50] = 0.0;
  C[54] = 0.0;
  C[55] = 0.0;
  C[56] = 0.0;
  C[57] = 0.0;
  C[58] = 0.0;
  C[59] = 0.0;
  C[60] = 0.0;
  C[61] = 0.0;
  C[62] = 0.0;
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
  C[78] = 0.0;
  C[81] = 0.0;
  C[82] = 0.0;
  C[83] = 0.0;
  C[84] = 0.0;
  C[85] = 0.0;
  C[86] = 0.0;
  C[87] = 0.0;
  C[88] = 0.0;
  C[89] = 0.0;
  C[93] = 0.0;
  C[94] = 0.0;
  C[95] = 0.0;
  C[96] = 0.0;
  C[97] = 0.0;
  C[98] = 0.0;
  C[99] = 0.0;
  C[100] = 0.0;
  C[101] = 0.0;
  C[105] = 0.0;
  C[106] = 0.0;
  C[107] = 0.0;
  C[108] = 0.0;
  C[109] = 0.0;
  C[110] = 0.0;
  C[111] = 0.0;
  C[112] = 0.0;
  C[113] = 0.0;
  C[114] = 0.0;
  C[115] = 0.0;
  C[116] = 0.0;
  C[117] = 0.0;
  C[120] = 0.0;
  C[121] = 0.0;
  C[122] = 0.0;
  C[123] = 0.0;
  C[124] = 0.0;
  C[125] = 0.0;
  C[126] = 0.0;
  C[127] = 0.0;
  C[128] = 0.0;
  C[132] = 0.0;
  C[133] = 0.0;
  C[134] = 0.0;
  C[135] = 0.0;
  C[136] = 0.0;
  C[137] = 0.0;
  C[138] = 0.0;
  C[139] = 0.0;
  C[140] = 0.0;
}

}  // namespace quadruped
