// panda.cpp: see panda.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate panda.yaml

#include "panda.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace panda {

static_assert(kDigest == 0x5232e515870b3e94ULL, "header and source are of different runs");

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

void mass_matrix(const Scalar q[7], Scalar A[49]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const auto [s_joint3, c_joint3] = sine_cosine(q[2]);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const auto [s_joint6, c_joint6] = sine_cosine(q[5]);
  // link7
  const Scalar t_link7_1 = 0.3842058806066518 - q[6];
  const auto [s_link7, c_link7] = sine_cosine(t_link7_1);
  const Scalar t_link7_2 = 0.0006883615516358103 * c_link7;
  const Scalar h_link6_x = 0.0136098230973375 + t_link7_2;
  const Scalar t_link7_3 = 0.0006883615516358103 * s_link7;
  const Scalar t_link7_4 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_5 = s_link7 * t_link7_4;
  const Scalar t_link7_6 = 0.0013450149983408877 * s_link7 - 0.00113526676062776 * c_link7;
  A[41] = t_link7_6;
  A[47] = A[41];
  const Scalar t_link7_7 = 0.0014685046434897288 * c_link7;
  const Scalar t_link6_1 = 0.0056786982094425 * s_joint6 + c_joint6 * h_link6_x;
  const Scalar t_link6_2 = 0.0056786982094425 * c_joint6 - s_joint6 * h_link6_x;
  const Scalar t_link7_8 = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  // link6
  const Scalar t_link6_3 = t_link7_5 - t_link7_7;
  const Scalar t_link6_4 = c_joint6 * (0.01102206876535063 + 2.0 * t_link7_8);
  const Scalar t_link6_5 = t_link6_4 - s_joint6 * (0.0034383574409692415 - t_link6_3);
  const Scalar t_link6_6 = s_joint6 * t_link6_5;
  const Scalar t_link6_7 = 0.0006609405457638925 - 0.0007342523217448644 * s_link7;
  const Scalar E_link6_xz = t_link6_7 - c_link7 * t_link7_4;
  const Scalar t_link6_8 = 9.3569097314605e-05 - t_link7_6;
  const Scalar t_link6_9 = s_joint6 * t_link6_8 + c_joint6 * E_link6_xz;
  const Scalar t_link6_10 = c_joint6 * t_link6_8 - s_joint6 * E_link6_xz;
  A[33] = t_link6_10;
  A[39] = A[33];
  const Scalar t_link6_11 = 0.030455032932289027 - t_link6_3;
  A[40] = t_link6_11;
  const Scalar t_link6_12 = 0.0032040101312503172 * s_link7;
  const Scalar t_link6_13 = 0.001208932934385 - t_link6_1;
  const Scalar h_link5_y = 0.0055993270925625 + t_link7_3;
  const Scalar t_link5_1 = c_joint5 * t_link6_13 + s_joint5 * h_link5_y;
  const Scalar h_link4_z = s_joint5 * t_link6_13 - c_joint5 * h_link5_y;
  // link5
  const Scalar E_link5_yz = 0.02389827041510187 + t_link6_10 + t_link6_12;
  const Scalar t_link5_2 = 0.004484246605646421 + t_link7_8 - c_joint6 * t_link6_5;
  const Scalar E_link5_xz = t_link5_2 + 4.654545454545454 * t_link6_1;
  const Scalar t_link5_3 = s_joint5 * E_link5_xz + c_joint5 * E_link5_yz;
  A[25] = t_link5_3;
  A[31] = A[25];
  const Scalar t_link5_4 = t_link7_7 + t_link6_6;
  const Scalar t_link5_5 = 0.03204281123129646 + t_link5_4;
  A[32] = t_link5_5;
  const Scalar t_link5_6 = 0.1419563931722475 - t_link6_2;
  const Scalar h_link4_x = 0.040431622658625 + t_link5_1;
  const Scalar t_link5_7 = c_joint5 * t_link6_9;
  const Scalar t_link5_8 = s_joint5 * (0.004752891272015237 + t_link5_4 - 2.0 * t_link7_5);
  const Scalar t_link5_9 = 0.00303048894665406 * c_joint5 + t_link5_8 - 2.0 * t_link5_7;
  // link4
  const Scalar t_link4_1 = t_link5_4 + 2.0 * t_link5_1;
  const Scalar t_link4_2 = t_link7_5 + s_joint5 * t_link5_9;
  const Scalar t_link4_3 = t_link4_2 - (0.06424523740847135 + t_link4_1);
  const Scalar t_link4_4 = t_link6_6 + 9.309090909090909 * t_link6_2;
  const Scalar E_link4_yy = 0.5987338527766317 - t_link4_4;
  const Scalar t_link5_10 = s_joint5 * E_link5_yz - c_joint5 * E_link5_xz;
  const Scalar t_link4_5 = t_link6_2 - t_link5_10;
  const Scalar t_link4_6 = c_joint4 * (0.2775281453709217 - 2.0 * t_link4_5);
  const Scalar t_link4_7 = s_joint4 * (t_link4_3 + E_link4_yy) + t_link4_6;
  const Scalar t_link4_8 = s_joint4 * t_link4_7;
  const Scalar t_link4_9 = 0.00164448757736927 - t_link5_3;
  const Scalar t_link4_10 = 0.00239011055294907 + t_link6_9 + h_link4_z;
  const Scalar E_link4_xz = t_link4_10 + c_joint5 * t_link5_9;
  const Scalar t_link4_11 = s_joint4 * t_link4_9 + c_joint4 * E_link4_xz;
  const Scalar t_link4_12 = c_joint4 * t_link4_9 - s_joint4 * E_link4_xz;
  A[17] = -t_link4_12;
  A[23] = A[17];
  const Scalar t_link4_13 = t_link4_3 - E_link4_yy;
  A[24] = -t_link4_13;
  const Scalar t_link3_1 = 0.013297019103287584 - t_link4_12;
  const Scalar E_link3_yz = t_link3_1 - 3.83030303030303 * h_link4_z;
  const Scalar t_link4_14 = s_joint4 * h_link4_x - c_joint4 * t_link5_6;
  const Scalar t_link4_15 = c_joint4 * h_link4_x + s_joint4 * t_link5_6;
  const Scalar t_link3_2 = t_link4_14 - (0.3604456361115751 - t_link4_5);
  const Scalar t_link4_16 = 3.83030303030303 * t_link4_15;
  // link3
  const Scalar t_link3_3 = t_link3_2 + c_joint4 * t_link4_7 + t_link4_16;
  const Scalar t_link3_4 = c_joint3 * E_link3_yz - s_joint3 * t_link3_3;
  A[9] = -t_link3_4;
  A[15] = A[9];
  const Scalar t_link3_5 = t_link4_8 - 2.0 * t_link4_15;
  const Scalar t_link3_6 = t_link4_1 + t_link3_5;
  const Scalar t_link3_7 = 0.15649801737951788 + t_link3_6;
  A[16] = t_link3_7;
  const Scalar t_link3_8 = h_link4_z - t_link4_11;
  const Scalar t_link3_9 = t_link4_3 - t_link3_5;
  const Scalar t_link3_10 = s_joint3 * (t_link3_9 - (0.02060656208200885 - t_link4_2));
  const Scalar t_link3_11 = t_link3_10 - c_joint3 * (0.000243824841901488 - 2.0 * t_link3_8);
  // link2
  const Scalar t_link2_1 = 0.010383014241958914 - t_link3_8 + c_joint3 * t_link3_11;
  A[1] = -(s_joint2 * t_link2_1 + c_joint2 * (0.0007689361029464 + t_link3_4));
  A[7] = A[1];
  const Scalar t_link2_2 = t_link3_9 - s_joint3 * t_link3_11;
  const Scalar t_link2_3 = t_link4_4 + t_link4_8 + 7.66060606060606 * t_link4_14;
  A[8] = 1.634512907529972 - t_link2_2 - t_link2_3;
  const Scalar t_link3_12 = s_joint3 * E_link3_yz + c_joint3 * t_link3_3;
  const Scalar t_link2_4 = s_joint2 * (t_link2_3 - (1.475497800487053 + t_link2_2));
  const Scalar t_link2_5 = c_joint2 * (0.00796671776787104 + 2.0 * t_link3_12) + t_link2_4;
  A[0] = 0.19383546586892408 + t_link3_6 - s_joint2 * t_link2_5;
  const Scalar t_link7_9 = 0.004909651967360946 + 0.0007342523217448644 * c_link7;
  // link6
  const Scalar t_link6_14 = s_joint6 * t_link7_8 + c_joint6 * t_link7_9;
  A[34] = -t_link6_14;
  A[46] = A[34];
  const Scalar t_link6_15 = s_joint6 * t_link7_3;
  const Scalar t_link6_16 = t_link7_6 - c_joint6 * t_link6_12;
  const Scalar t_link6_17 = 0.0032040101312503172 * c_link7 - c_joint6 * t_link7_8;
  const Scalar t_link6_18 = t_link6_17 + s_joint6 * t_link7_9;
  const Scalar t_link5_11 = t_link6_15 - c_joint5 * t_link6_16 + s_joint5 * t_link6_18;
  A[27] = -t_link5_11;
  A[45] = A[27];
  const Scalar t_link6_19 = c_joint6 * t_link7_3;
  // link5
  const Scalar t_link5_12 = s_joint5 * t_link6_16 + c_joint5 * t_link6_18;
  const Scalar t_link5_13 = s_joint5 * t_link6_19 - c_joint5 * t_link7_2;
  const Scalar t_link5_14 = t_link6_14 + t_link5_13;
  // link4
  const Scalar t_link4_17 = t_link5_13 + s_joint4 * t_link5_12 - c_joint4 * t_link5_14;
  A[20] = t_link4_17;
  A[44] = A[20];
  const Scalar t_link4_18 = c_joint4 + 3.83030303030303 * s_joint4;
  const Scalar t_link4_19 = s_joint4 - 3.83030303030303 * c_joint4;
  const Scalar t_link4_20 = (c_joint5 * t_link6_19 + s_joint5 * t_link7_2) * t_link4_19;
  const Scalar t_link4_21 = t_link5_11 - t_link6_15 * t_link4_18 - t_link4_20;
  const Scalar t_link4_22 = c_joint4 * t_link5_12 + s_joint4 * t_link5_14;
  const Scalar t_link4_23 = t_link4_22 - 3.83030303030303 * t_link5_13;
  A[13] = c_joint3 * t_link4_21 + s_joint3 * t_link4_23;
  A[43] = A[13];
  A[6] = c_joint2 * t_link4_17 - s_joint2 * (c_joint3 * t_link4_23 - s_joint3 * t_link4_21);
  A[42] = A[6];
  const Scalar t_link6_20 = t_link6_11 - 4.654545454545454 * t_link6_2;
  // link5
  const Scalar t_link5_15 = t_link6_1 - c_joint5 * t_link6_20 - s_joint5 * t_link6_9;
  A[26] = -t_link5_15;
  A[38] = A[26];
  const Scalar t_link5_16 = s_joint5 * t_link6_2;
  const Scalar t_link5_17 = t_link6_10 - t_link5_16;
  const Scalar t_link5_18 = t_link5_7 - s_joint5 * t_link6_20;
  // link4
  const Scalar t_link4_24 = t_link5_16 + c_joint4 * t_link5_17 - s_joint4 * t_link5_18;
  A[19] = t_link4_24;
  A[37] = A[19];
  const Scalar t_link4_25 = t_link5_15 - c_joint5 * t_link6_2 * t_link4_19;
  const Scalar t_link4_26 = t_link4_25 - t_link6_1 * t_link4_18;
  const Scalar t_link4_27 = 3.83030303030303 * t_link5_16 + s_joint4 * t_link5_17;
  const Scalar t_link4_28 = t_link4_27 + c_joint4 * t_link5_18;
  A[12] = c_joint3 * t_link4_26 - s_joint3 * t_link4_28;
  A[36] = A[12];
  A[5] = s_joint2 * (c_joint3 * t_link4_28 + s_joint3 * t_link4_26) + c_joint2 * t_link4_24;
  A[35] = A[5];
  const Scalar t_link5_19 = t_link5_1 + t_link5_5;
  const Scalar t_link4_29 = t_link5_1 - c_joint4 * t_link5_19 - s_joint4 * t_link5_10;
  A[18] = -t_link4_29;
  A[30] = A[18];
  const Scalar t_link4_30 = s_joint4 * t_link5_19 - 3.83030303030303 * t_link5_1;
  const Scalar t_link4_31 = t_link4_30 - c_joint4 * t_link5_10;
  const Scalar t_link4_32 = t_link5_3 + h_link4_z * t_link4_19;
  A[11] = -(s_joint3 * t_link4_31 + c_joint3 * t_link4_32);
  A[29] = A[11];
  A[4] = -(s_joint2 * (s_joint3 * t_link4_32 - c_joint3 * t_link4_31) + c_joint2 * t_link4_29);
  A[28] = A[4];
  const Scalar t_link4_33 = t_link4_13 + t_link4_15 + 3.83030303030303 * t_link4_14;
  A[10] = c_joint3 * t_link4_33 + s_joint3 * t_link4_11;
  A[22] = A[10];
  // link2
  A[3] = -(c_joint2 * t_link4_12 + s_joint2 * (c_joint3 * t_link4_11 - s_joint3 * t_link4_33));
  A[21] = A[3];
  A[2] = c_joint2 * t_link3_7 - s_joint2 * t_link3_12;
  A[14] = A[2];
  A[48] = 0.004909651967360946;
}

void bias_force(const Scalar q[7], const Scalar qd[7], Scalar B[7]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const auto [s_joint3, c_joint3] = sine_cosine(q[2]);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const auto [s_joint6, c_joint6] = sine_cosine(q[5]);
  // link2
  const Scalar t_link2_1 = 0.00796671776787104 * c_joint2;
  const Scalar t_link2_2 = c_joint2 * (t_link2_1 - 0.34001233503451994 * s_joint2);
  const Scalar t_link2_3 = qd[0] * (0.00398335888393552 - t_link2_2);
  // link3
  const Scalar t_link3_1 = s_joint2 * qd[0];
  const Scalar t_link3_2 = c_joint3 * qd[1];
  const Scalar omega_link3_y = t_link3_2 + s_joint3 * t_link3_1;
  const Scalar t_link3_3 = c_joint2 * qd[0];
  const Scalar omega_link3_z = qd[2] + t_link3_3;
  const Scalar t_link3_4 = omega_link3_y * omega_link3_z;
  const Scalar t_link3_5 = t_link3_2 * t_link3_3 - omega_link3_y * qd[2];
  const Scalar Omega_link3_zy = t_link3_4 - t_link3_5;
  const Scalar t_link3_6 = s_joint3 * qd[1];
  const Scalar omega_link3_x = t_link3_6 - c_joint3 * t_link3_1;
  const Scalar t_link3_7 = omega_link3_x * omega_link3_x;
  const Scalar t_link3_8 = omega_link3_y * omega_link3_y;
  const Scalar t_link3_9 = omega_link3_z * omega_link3_z;
  const Scalar alpha_link3_y = t_link3_3 * t_link3_6 - qd[2] * omega_link3_x;
  const Scalar t_link3_10 = omega_link3_z * omega_link3_x;
  const Scalar t_link3_11 = alpha_link3_y - t_link3_10;
  const Scalar t_link3_12 = omega_link3_y * omega_link3_x;
  const Scalar t_link3_13 = qd[1] * t_link3_1;
  const Scalar Omega_link3_xy = t_link3_12 + t_link3_13;
  // link4
  const Scalar t_link4_1 = c_joint4 * omega_link3_z - s_joint4 * omega_link3_x;
  const Scalar t_link4_2 = omega_link3_y - qd[3];
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy - s_joint4 * Omega_link3_xy;
  const Scalar t_link4_3 = Omega_link4_yz - t_link4_1 * t_link4_2 * 2.0;
  const Scalar Omega_link3_xz = alpha_link3_y + t_link3_10;
  const Scalar t_link4_4 = t_link3_8 + t_link3_9 - 3.83030303030303 * Omega_link3_xz;
  const Scalar t_link4_5 = s_joint4 * omega_link3_z + c_joint4 * omega_link3_x;
  const Scalar t_link4_6 = t_link4_2 * t_link4_5;
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy + c_joint4 * Omega_link3_xy;
  const Scalar alpha_link5_z = t_link4_6 - Omega_link4_xz;
  const Scalar Omega_link4_zx = t_link4_6 + alpha_link5_z;
  const Scalar t_link4_7 = t_link4_5 * t_link4_5;
  const Scalar t_link4_8 = t_link4_2 * t_link4_2;
  const Scalar Omega_link3_yz = t_link3_4 + t_link3_5;
  const Scalar Omega_link3_yx = t_link3_12 - t_link3_13;
  const Scalar t_link4_9 = Omega_link3_yx + 3.83030303030303 * Omega_link3_yz;
  const Scalar t_link4_10 = t_link4_7 + t_link4_8;
  const Scalar t_link4_11 = t_link4_1 * t_link4_5;
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_11;
  // link5
  const Scalar omega_link5_z = t_link4_1 + qd[4];
  const Scalar t_link5_1 = s_joint5 * Omega_link4_xy + c_joint5 * t_link4_3;
  const Scalar t_link5_2 = s_joint5 * t_link4_5 - c_joint5 * t_link4_2;
  const Scalar Omega_link5_zy = t_link5_1 - omega_link5_z * t_link5_2 * 2.0;
  const Scalar t_link5_3 = s_joint5 * t_link4_3 - c_joint5 * Omega_link4_xy;
  const Scalar omega_link5_x = s_joint5 * t_link4_2 + c_joint5 * t_link4_5;
  const Scalar t_link5_4 = omega_link5_z * omega_link5_x;
  const Scalar alpha_link6_z = t_link5_3 + t_link5_4;
  const Scalar Omega_link5_zx = t_link5_4 + alpha_link6_z;
  // link4
  const Scalar t_link4_12 = t_link3_11 + 3.83030303030303 * (t_link3_7 + t_link3_8);
  const Scalar t_link4_13 = t_link4_7 - t_link4_8;
  const Scalar a_link4_x = c_joint4 * t_link4_4 + s_joint4 * t_link4_12;
  const Scalar t_link3_14 = t_link3_7 + t_link3_9;
  const Scalar Omega_link4_xx = t_link4_13 - t_link3_14;
  const Scalar t_link5_5 = a_link4_x + Omega_link4_xx;
  const Scalar t_link4_14 = alpha_link3_y - t_link4_11;
  // link5
  const Scalar a_link5_z = t_link4_14 - c_joint4 * t_link4_12 + s_joint4 * t_link4_4;
  const Scalar t_link5_6 = t_link5_2 * omega_link5_x;
  const Scalar t_link5_7 = alpha_link5_z + t_link5_6;
  const Scalar t_link5_8 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_9 = omega_link5_z * omega_link5_z;
  const Scalar t_link5_10 = t_link5_8 + t_link5_9;
  const Scalar Omega_link7_xy = c_joint6 * t_link5_7 - s_joint6 * Omega_link5_zy;
  // link6
  const Scalar omega_link6_x = c_joint6 * omega_link5_x + s_joint6 * omega_link5_z;
  const Scalar omega_link6_z = t_link5_2 + qd[5];
  const Scalar t_link6_1 = 2.0 * omega_link6_z;
  const Scalar t_link6_2 = Omega_link7_xy - omega_link6_x * t_link6_1;
  const Scalar omega_link6_y = c_joint6 * omega_link5_z - s_joint6 * omega_link5_x;
  const Scalar t_link6_3 = c_joint6 * Omega_link5_zy + s_joint6 * t_link5_7;
  const Scalar Omega_link6_zy = t_link6_3 + t_link6_1 * omega_link6_y;
  const Scalar t_link6_4 = omega_link6_x * omega_link6_y;
  const Scalar Omega_link7_xz = alpha_link6_z - t_link6_4;
  const Scalar t_link5_11 = Omega_link4_zx - t_link4_9;
  const Scalar a_link5_y = s_joint5 * t_link5_5 - c_joint5 * t_link5_11;
  const Scalar t_link6_5 = a_link5_y - 4.654545454545454 * t_link5_1;
  const Scalar Omega_link6_yx = alpha_link6_z + t_link6_4;
  const Scalar t_link6_6 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_7 = omega_link6_z * omega_link6_z;
  const Scalar t_link6_8 = t_link6_6 + t_link6_7;
  // link7
  const Scalar t_link7_1 = omega_link6_y - qd[6];
  const Scalar t_link7_2 = 2.0 * t_link7_1;
  const Scalar Omega_link7_zy = Omega_link6_zy - omega_link6_z * t_link7_2;
  const Scalar t_link6_9 = a_link5_z - 4.654545454545454 * t_link4_10;
  const Scalar t_link5_12 = s_joint5 * t_link5_11 + c_joint5 * t_link5_5;
  const Scalar t_link6_10 = t_link5_12 + 4.654545454545454 * t_link5_3;
  const Scalar t_link7_3 = 1.0666666666666667 * Omega_link6_yx + c_joint6 * t_link6_9;
  const Scalar t_link7_4 = t_link7_3 + s_joint6 * t_link6_10;
  const Scalar t_link6_11 = t_link6_6 - t_link6_7;
  const Scalar t_link7_5 = Omega_link7_xz + omega_link6_x * t_link7_2;
  const Scalar t_link7_6 = t_link7_1 * t_link7_1;
  const Scalar t_link7_7 = 0.3842058806066518 - q[6];
  const auto [s_link7, c_link7] = sine_cosine(t_link7_7);
  const Scalar t_link7_8 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_9 = 0.0005571816285452074 - c_link7 * t_link7_8;
  const Scalar t_link7_10 = s_link7 * t_link7_8;
  const Scalar t_link7_11 = 0.0013098798160415795 - t_link7_10;
  const Scalar t_link7_12 = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  const Scalar t_link7_13 = 0.0006883615516358103 * c_link7;
  const Scalar t_link7_14 = 0.0006883615516358103 * s_link7;
  const Scalar a_link6_x = s_joint6 * t_link6_9 - c_joint6 * t_link6_10;
  const Scalar t_link7_15 = 0.0035997721513193665 + t_link7_10;
  const Scalar t_link7_16 = t_link6_5 + 1.0666666666666667 * t_link6_2;
  const Scalar t_link7_17 = 0.0013450149983408877 * s_link7 - 0.00113526676062776 * c_link7;
  const Scalar t_link6_12 = t_link5_10 - t_link6_11;
  const Scalar a_link7_x = a_link6_x - 1.0666666666666667 * t_link6_12;
  const Scalar t_link7_18 = t_link6_11 * t_link7_9 + t_link7_13 * t_link7_16;
  const Scalar t_link7_19 = t_link7_18 - Omega_link7_xz * t_link7_17 - t_link7_14 * a_link7_x;
  const Scalar t_link7_20 = t_link7_19 + Omega_link6_zy * t_link7_12 + t_link6_2 * t_link7_11;
  const Scalar t_link7_21 = t_link7_20 + Omega_link7_xy * t_link7_15;
  B[6] = -t_link7_21;
  const Scalar t_link7_22 = 0.012759209153753906 * t_link7_4 + Omega_link7_zy * t_link7_14;
  const Scalar t_link7_23 = t_link7_22 + t_link7_5 * t_link7_13;
  const Scalar t_link7_24 = 1.0666666666666667 * t_link7_23;
  // link6
  const Scalar t_link6_13 = t_link7_24 - 0.012388667012232337 * t_link6_4;
  const Scalar t_link6_14 = 0.005511034382675315 * (t_link6_8 - t_link6_12);
  const Scalar t_link6_15 = t_link6_13 - 0.000103758917218685 * t_link6_3 + t_link6_14;
  const Scalar t_link6_16 = t_link6_15 + 0.0056786982094425 * a_link6_x;
  const Scalar t_link6_17 = Omega_link7_xy * (9.3569097314605e-05 - t_link7_17);
  const Scalar t_link6_18 = t_link6_16 + 0.014628008479087448 * alpha_link6_z + t_link6_17;
  const Scalar t_link6_19 = t_link6_18 + t_link7_12 * (t_link6_6 - t_link7_6);
  const Scalar t_link6_20 = t_link6_19 + t_link7_5 * t_link7_11 - Omega_link7_zy * t_link7_9;
  const Scalar M_link6_z = t_link6_20 + t_link7_4 * t_link7_13;
  B[5] = M_link6_z;
  // link7
  const Scalar t_link7_25 = t_link6_6 + t_link7_6;
  const Scalar t_link7_26 = 0.012759209153753906 * t_link7_16 + t_link6_2 * t_link7_13;
  const Scalar t_link7_27 = t_link7_26 - t_link7_14 * t_link7_25;
  const Scalar t_link7_28 = t_link7_21 + 1.0666666666666667 * t_link7_27;
  const Scalar t_link7_29 = t_link7_28 + 0.005511034382675315 * Omega_link6_zy;
  const Scalar t_link7_30 = t_link7_29 + 9.3569097314605e-05 * Omega_link7_xz;
  const Scalar t_link7_31 = t_link7_30 + 0.001119670733427555 * t_link6_2;
  // link6
  const Scalar M_link6_y = t_link7_31 + 0.000103758917218685 * t_link6_11;
  const Scalar t_link6_21 = 9.3569097314605e-05 * (t_link5_10 - t_link6_8);
  const Scalar t_link6_22 = 0.0056786982094425 * t_link6_5 + t_link6_21;
  const Scalar t_link6_23 = t_link6_22 + Omega_link7_zy * t_link7_15;
  const Scalar t_link6_24 = t_link6_23 - 0.000103758917218685 * Omega_link6_yx;
  const Scalar t_link6_25 = t_link6_24 + 0.013508337745659894 * Omega_link6_zy;
  const Scalar t_link7_32 = t_link7_17 * (t_link6_8 - t_link7_25);
  const Scalar t_link6_26 = t_link6_25 + t_link7_4 * t_link7_14 + t_link7_32;
  const Scalar t_link6_27 = t_link6_26 + t_link6_2 * (0.005511034382675315 + t_link7_12);
  const Scalar M_link6_x = t_link6_27 - t_link7_5 * t_link7_9;
  const Scalar t_link6_28 = 0.0056786982094425 * Omega_link7_xz;
  const Scalar t_link6_29 = t_link6_28 + 0.012759209153753906 * a_link7_x;
  const Scalar t_link6_30 = t_link6_29 - Omega_link7_xy * t_link7_14;
  const Scalar F_link6_x = t_link6_30 - t_link7_13 * (t_link6_7 + t_link7_6);
  // link5
  const Scalar t_link5_13 = t_link5_8 - t_link5_9;
  const Scalar t_link5_14 = t_link4_10 - t_link5_10;
  const Scalar t_link5_15 = s_joint6 * M_link6_x + 0.00859403176329453 * t_link5_6;
  const Scalar t_link5_16 = t_link5_15 + 0.02389827041510187 * t_link5_3;
  const Scalar t_link5_17 = 0.00151524447332703 * (t_link5_13 - t_link5_14);
  const Scalar t_link5_18 = t_link5_16 + 0.0055993270925625 * t_link5_12 - t_link5_17;
  const Scalar t_link5_19 = t_link5_18 + 0.011496343893347959 * alpha_link5_z;
  const Scalar t_link5_20 = t_link5_19 - 0.001208932934385 * a_link5_y;
  const Scalar t_link5_21 = t_link5_20 + 0.001026787777028894 * t_link5_1;
  const Scalar M_link5_z = t_link5_21 + c_joint6 * M_link6_y;
  B[4] = M_link5_z;
  const Scalar F_link6_y = t_link7_23 + 0.0056786982094425 * t_link6_8;
  const Scalar t_link6_31 = s_joint6 * F_link6_y - c_joint6 * F_link6_x;
  const Scalar t_link5_22 = 0.001208932934385 * (t_link4_10 - t_link5_13);
  const Scalar t_link6_32 = t_link6_31 + 0.027672413504871093 * t_link5_12 - t_link5_22;
  const Scalar t_link6_33 = t_link6_32 + 0.0055993270925625 * t_link5_7;
  const Scalar t_link7_33 = t_link7_27 + 0.0056786982094425 * Omega_link6_zy;
  const Scalar Omega_link5_yx = alpha_link5_z - t_link5_6;
  const Scalar t_link5_23 = c_joint6 * M_link6_x - 0.02389827041510187 * t_link5_14;
  const Scalar t_link5_24 = t_link5_23 + 0.001026787777028894 * Omega_link5_yx;
  const Scalar t_link5_25 = t_link5_24 + 0.010045187828321245 * Omega_link5_zy;
  const Scalar t_link5_26 = t_link5_25 + 0.00151524447332703 * Omega_link5_zx;
  const Scalar t_link5_27 = t_link5_26 + 0.0055993270925625 * a_link5_z;
  const Scalar t_link5_28 = t_link5_27 - 4.654545454545454 * t_link7_33;
  const Scalar M_link5_x = t_link5_28 - s_joint6 * M_link6_y;
  // link6
  const Scalar t_link6_34 = M_link6_z + 0.02389827041510187 * t_link5_7;
  const Scalar t_link6_35 = t_link6_34 + 0.00151524447332703 * Omega_link5_zy;
  const Scalar t_link6_36 = t_link6_35 + 4.654545454545454 * t_link6_31;
  const Scalar t_link6_37 = t_link6_36 - 0.001208932934385 * a_link5_z;
  const Scalar t_link6_38 = t_link6_37 + 0.001026787777028894 * t_link5_13;
  const Scalar t_link6_39 = t_link6_38 + 0.001451156065026714 * Omega_link5_zx;
  // link5
  const Scalar t_link5_29 = 0.0055993270925625 * Omega_link5_zy;
  const Scalar t_link5_30 = t_link5_29 + 0.027672413504871093 * a_link5_z;
  const Scalar t_link5_31 = t_link5_30 - 0.001208932934385 * Omega_link5_zx;
  const Scalar F_link5_z = t_link5_31 + s_joint6 * F_link6_x + c_joint6 * F_link6_y;
  const Scalar t_link5_32 = F_link5_z + 0.30338412141694127 * t_link4_11;
  const Scalar t_link4_15 = 0.0039053550262761 * Omega_link4_yz;
  const Scalar t_link4_16 = 0.07937575371526084 * (t_link4_10 + Omega_link4_xx);
  const Scalar t_link5_33 = t_link5_32 + s_joint5 * M_link5_x - t_link4_15 - t_link4_16;
  const Scalar t_link5_34 = t_link5_33 + 0.3142156484133223 * alpha_link3_y;
  const Scalar t_link5_35 = t_link5_34 - 0.00164448757736927 * Omega_link4_xz;
  const Scalar t_link5_36 = t_link5_35 - 0.0825680742020475 * a_link4_x;
  const Scalar t_link5_37 = t_link5_36 - c_joint5 * t_link6_39;
  B[3] = -t_link5_37;
  const Scalar t_link5_38 = t_link7_33 - 0.001208932934385 * Omega_link5_yx;
  const Scalar t_link5_39 = t_link5_38 + 0.027672413504871093 * a_link5_y;
  const Scalar F_link5_y = t_link5_39 - 0.0055993270925625 * t_link5_10;
  const Scalar t_link5_40 = c_joint5 * F_link5_y - s_joint5 * t_link6_33;
  const Scalar t_link5_41 = t_link5_40 - 0.0825680742020475 * t_link4_3;
  const Scalar t_link5_42 = M_link5_z - t_link5_40 + 0.0054157634981905 * Omega_link4_zx;
  const Scalar t_link5_43 = t_link5_42 + 0.07937575371526084 * t_link4_3;
  const Scalar t_link5_44 = t_link5_43 - 0.0039053550262761 * t_link4_13;
  const Scalar t_link5_45 = t_link5_44 + 0.00164448757736927 * Omega_link4_xy;
  // link4
  const Scalar t_link4_17 = 0.00164448757736927 * (t_link4_10 - t_link3_14);
  const Scalar t_link4_18 = 0.07937575371526084 * Omega_link4_zx + t_link4_17;
  const Scalar t_link4_19 = t_link4_18 + 0.3087998849151318 * t_link4_3;
  const Scalar t_link4_20 = t_link4_19 - 0.0039053550262761 * t_link4_14;
  const Scalar t_link5_46 = t_link4_20 + s_joint5 * t_link6_39 + c_joint5 * M_link5_x;
  const Scalar t_link5_47 = t_link5_46 - 0.0825680742020475 * t_link4_9;
  // link3
  const Scalar t_link3_15 = t_link5_41 + 0.06681619663671426 * Omega_link3_yz;
  const Scalar t_link3_16 = t_link3_15 - 0.03817619733278093 * t_link3_13;
  const Scalar t_link3_17 = t_link3_16 + s_joint4 * t_link5_47 + c_joint4 * t_link5_45;
  const Scalar t_link3_18 = 0.000121912420950744 * (t_link3_7 - t_link3_8);
  const Scalar t_link3_19 = t_link3_17 - 0.00618010059697554 * t_link3_12 - t_link3_18;
  const Scalar M_link3_z = t_link3_19 - 0.013297019103287584 * Omega_link3_xz;
  B[2] = M_link3_z;
  const Scalar t_link2_4 = qd[1] * qd[1];
  const Scalar t_link2_5 = M_link3_z - 0.01026110182100817 * t_link2_4;
  const Scalar t_link4_21 = 3.83030303030303 * t_link5_41 - c_joint4 * t_link5_47;
  const Scalar t_link4_22 = t_link4_21 + 0.013297019103287584 * (t_link3_8 - t_link3_9);
  const Scalar t_link3_20 = 0.06681619663671426 * Omega_link3_yx;
  // link4
  const Scalar t_link4_23 = t_link4_22 + s_joint4 * t_link5_45 + t_link3_20;
  const Scalar t_link4_24 = t_link4_23 - 0.022178148964878235 * Omega_link3_zy;
  const Scalar t_link4_25 = t_link4_24 + 0.000121912420950744 * t_link3_11;
  const Scalar t_link5_48 = 0.0825680742020475 * Omega_link4_xy - s_joint5 * F_link5_y;
  // link3
  const Scalar t_link3_21 = t_link5_37 - 0.000121912420950744 * Omega_link3_zy;
  const Scalar t_link3_22 = s_joint4 - 3.83030303030303 * c_joint4;
  const Scalar t_link3_23 = t_link3_21 + 0.06681619663671426 * (t_link3_7 - t_link3_9);
  const Scalar t_link5_49 = F_link5_z - 0.0825680742020475 * t_link4_10;
  const Scalar t_link3_24 = t_link3_23 - (t_link5_48 - c_joint5 * t_link6_33) * t_link3_22;
  const Scalar t_link3_25 = (c_joint4 + 3.83030303030303 * s_joint4) * t_link5_49;
  const Scalar t_link3_26 = t_link3_24 - t_link3_25 + 0.013297019103287584 * Omega_link3_xy;
  const Scalar M_link3_y = t_link3_26 + 0.015998048367902695 * t_link3_11;
  // link2
  const Scalar t_link2_6 = 0.0007689361029464 * t_link2_4 + c_joint3 * t_link4_25;
  const Scalar t_link2_7 = qd[1] * t_link2_3 * 2.0 + c_joint2 * t_link2_5;
  B[0] = t_link2_7 + s_joint2 * (t_link2_6 + s_joint3 * M_link3_y);
  B[1] = c_joint3 * M_link3_y - (qd[0] * t_link2_3 + s_joint3 * t_link4_25);
}

void gravity_force(const Scalar q[7], Scalar G[7]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const auto [s_joint3, c_joint3] = sine_cosine(q[2]);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  // link7
  const auto [s_joint6, c_joint6] = sine_cosine(q[5]);
  const Scalar t_link7_1 = 0.3842058806066518 - q[6];
  const auto [s_link7, c_link7] = sine_cosine(t_link7_1);
  const Scalar h_link7_x = 0.008343776383464369 * c_link7;
  const Scalar t_link7_2 = 0.008343776383464369 * s_link7;
  const Scalar t_link7_3 = 9.81 * s_joint2;
  const Scalar t_link7_4 = c_joint3 * t_link7_3;
  const Scalar t_link7_5 = 9.81 * c_joint2;
  const Scalar t_link7_6 = c_joint4 * t_link7_4 - s_joint4 * t_link7_5;
  const Scalar t_link7_7 = s_joint3 * t_link7_3;
  const Scalar t_link7_8 = s_joint5 * t_link7_7 - c_joint5 * t_link7_6;
  const Scalar t_link7_9 = s_joint4 * t_link7_4 + c_joint4 * t_link7_5;
  const Scalar t_link7_10 = c_joint5 * t_link7_7 + s_joint5 * t_link7_6;
  const Scalar t_link7_11 = t_link7_2 * (c_joint6 * t_link7_8 + s_joint6 * t_link7_9);
  G[6] = t_link7_11 - h_link7_x * t_link7_10;
  // link6
  const Scalar t_link6_1 = 0.164967552695 + h_link7_x;
  const Scalar h_link6_x = 0.068832705569 * s_joint6 + c_joint6 * t_link6_1;
  const Scalar t_link6_2 = 0.014653732538 - h_link6_x;
  const Scalar h_link5_y = 0.067870631425 + t_link7_2;
  const Scalar t_link7_12 = 0.068832705569 * c_joint6 - s_joint6 * t_link6_1;
  G[5] = t_link7_8 * t_link7_12 + t_link7_9 * h_link6_x;
  const Scalar h_link4_x = 0.49008027465 + s_joint5 * h_link5_y + c_joint5 * t_link6_2;
  const Scalar t_link5_1 = 1.720683553603 - t_link7_12;
  G[4] = -(t_link7_8 * h_link5_y + t_link7_10 * t_link6_2);
  G[3] = t_link7_6 * t_link5_1 - t_link7_9 * h_link4_x;
  // link3
  const Scalar h_link3_y = 0.028227094878 + c_joint5 * h_link5_y - s_joint5 * t_link6_2;
  const Scalar h_link3_x = 0.684157959872 - c_joint4 * h_link4_x - s_joint4 * t_link5_1;
  const Scalar t_link3_1 = 3.104340043512 + c_joint4 * t_link5_1;
  G[2] = t_link7_7 * h_link3_x + t_link7_4 * h_link3_y;
  const Scalar t_link3_2 = 0.002031994566 + s_joint3 * h_link3_y - c_joint3 * h_link3_x;
  // link2
  G[1] = t_link7_5 * t_link3_2 - t_link7_3 * (t_link3_1 - s_joint4 * h_link4_x);
  G[0] = 0.0;
}

void inverse_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar qdd[7],
                      Scalar tau[7]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const auto [s_joint3, c_joint3] = sine_cosine(q[2]);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const auto [s_joint6, c_joint6] = sine_cosine(q[5]);
  // link2
  const Scalar t_link2_1 = s_joint2 * qd[0];
  const Scalar t_link2_2 = t_link2_1 * t_link2_1;
  const Scalar t_link2_3 = qd[1] * qd[1];
  const Scalar t_link2_4 = c_joint2 * qd[0];
  const Scalar t_link2_5 = s_joint2 * qdd[0] + qd[1] * t_link2_4 * 2.0;
  const Scalar t_link2_6 = t_link2_1 * qd[1];
  const Scalar alpha_link2_y = t_link2_6 - c_joint2 * qdd[0];
  const Scalar t_link2_7 = t_link2_1 * t_link2_4;
  const Scalar Omega_link2_xy = t_link2_7 - qdd[1];
  // link3
  const Scalar Omega_link3_yz = c_joint3 * t_link2_5 + s_joint3 * Omega_link2_xy;
  const Scalar omega_link3_y = s_joint3 * t_link2_1 + c_joint3 * qd[1];
  const Scalar omega_link3_z = t_link2_4 + qd[2];
  const Scalar t_link3_1 = 2.0 * omega_link3_z;
  const Scalar t_link3_2 = Omega_link3_yz - omega_link3_y * t_link3_1;
  const Scalar t_link3_3 = c_joint3 * t_link2_1 - s_joint3 * qd[1];
  const Scalar t_link3_4 = t_link3_3 * t_link3_3;
  const Scalar t_link3_5 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_6 = omega_link3_y * t_link3_3;
  const Scalar t_link3_7 = alpha_link2_y - qdd[2];
  const Scalar t_link3_8 = t_link3_6 - t_link3_7;
  const Scalar t_link2_8 = 118.9090909090909 * s_joint2;
  const Scalar t_link3_9 = c_joint3 * t_link2_8;
  const Scalar a_link3_y = s_joint3 * t_link2_8;
  // link4
  const Scalar t_link4_1 = omega_link3_y - qd[3];
  const Scalar Omega_link4_yz = s_joint4 * t_link3_8 - c_joint4 * t_link3_2;
  const Scalar t_link4_2 = c_joint4 * omega_link3_z + s_joint4 * t_link3_3;
  const Scalar t_link4_3 = Omega_link4_yz - t_link4_1 * t_link4_2 * 2.0;
  const Scalar t_link2_9 = t_link2_2 + t_link2_3;
  // link3
  const Scalar Omega_link3_xz = s_joint3 * t_link2_5 - c_joint3 * Omega_link2_xy;
  const Scalar t_link3_10 = Omega_link3_xz + t_link3_1 * t_link3_3;
  const Scalar t_link3_11 = t_link3_4 - t_link3_5;
  // link4
  const Scalar t_link4_4 = t_link3_11 - (t_link3_9 + t_link2_9);
  const Scalar t_link4_5 = t_link4_4 + 3.83030303030303 * Omega_link3_xz;
  const Scalar t_link4_6 = s_joint4 * omega_link3_z - c_joint4 * t_link3_3;
  const Scalar t_link4_7 = t_link4_1 * t_link4_6;
  const Scalar t_link4_8 = c_joint4 * t_link3_8 + s_joint4 * t_link3_2;
  const Scalar t_link4_9 = t_link4_7 + t_link4_8;
  const Scalar Omega_link4_zx = t_link4_7 + t_link4_9;
  const Scalar t_link4_10 = t_link4_2 * t_link4_6;
  const Scalar t_link4_11 = Omega_link3_xz - qdd[3] + omega_link3_z * t_link3_3;
  const Scalar Omega_link4_xy = t_link4_10 + t_link4_11;
  const Scalar Omega_link4_yx = t_link4_10 - t_link4_11;
  const Scalar t_link4_12 = t_link4_6 * t_link4_6;
  const Scalar t_link4_13 = t_link4_1 * t_link4_1;
  const Scalar t_link4_14 = t_link4_12 + t_link4_13;
  // link5
  const Scalar t_link5_1 = s_joint5 * Omega_link4_xy + c_joint5 * t_link4_3;
  const Scalar omega_link5_y = c_joint5 * t_link4_1 - s_joint5 * t_link4_6;
  const Scalar omega_link5_z = t_link4_2 + qd[4];
  const Scalar Omega_link5_zy = t_link5_1 + omega_link5_y * omega_link5_z * 2.0;
  const Scalar t_link5_2 = s_joint5 * t_link4_3 - c_joint5 * Omega_link4_xy;
  const Scalar omega_link5_x = s_joint5 * t_link4_1 + c_joint5 * t_link4_6;
  const Scalar t_link5_3 = omega_link5_z * omega_link5_x;
  const Scalar t_link5_4 = t_link5_2 + t_link5_3;
  const Scalar Omega_link5_zx = t_link5_3 + t_link5_4;
  const Scalar t_link3_12 = t_link3_6 + t_link3_7;
  const Scalar t_link4_15 = a_link3_y - t_link3_12 + 3.83030303030303 * Omega_link3_yz;
  const Scalar t_link5_5 = Omega_link4_zx - t_link4_15;
  // link4
  const Scalar t_link4_16 = t_link3_10 - 118.9090909090909 * c_joint2;
  const Scalar t_link4_17 = t_link4_16 + 3.83030303030303 * t_link2_9;
  const Scalar a_link4_x = s_joint4 * t_link4_17 - c_joint4 * t_link4_5;
  const Scalar t_link4_18 = t_link4_12 - t_link4_13;
  const Scalar t_link3_13 = t_link3_4 + t_link3_5;
  // link5
  const Scalar t_link5_6 = t_link3_13 - (a_link4_x + t_link4_18);
  const Scalar t_link5_7 = s_joint5 * t_link5_5 - c_joint5 * t_link5_6;
  const Scalar t_link5_8 = s_joint5 * t_link5_6 + c_joint5 * t_link5_5;
  const Scalar t_link5_9 = omega_link5_y * omega_link5_x;
  const Scalar alpha_link5_z = t_link4_9 + qdd[4];
  const Scalar Omega_link5_yx = t_link5_9 + alpha_link5_z;
  const Scalar t_link5_10 = Omega_link4_yx + c_joint4 * t_link4_17 + s_joint4 * t_link4_5;
  const Scalar Omega_link5_xy = t_link5_9 - alpha_link5_z;
  const Scalar t_link5_11 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_12 = omega_link5_z * omega_link5_z;
  const Scalar t_link5_13 = t_link5_11 + t_link5_12;
  // link6
  const Scalar omega_link6_y = c_joint6 * omega_link5_z - s_joint6 * omega_link5_x;
  const Scalar t_link6_1 = omega_link5_y - qd[5];
  const Scalar t_link6_2 = 2.0 * t_link6_1;
  const Scalar t_link6_3 = c_joint6 * Omega_link5_zy - s_joint6 * Omega_link5_xy;
  const Scalar Omega_link6_zy = t_link6_3 - omega_link6_y * t_link6_2;
  const Scalar t_link6_4 = c_joint6 * Omega_link5_xy + s_joint6 * Omega_link5_zy;
  const Scalar omega_link6_x = s_joint6 * omega_link5_z + c_joint6 * omega_link5_x;
  const Scalar Omega_link6_zx = t_link6_4 - t_link6_2 * omega_link6_x;
  const Scalar t_link6_5 = omega_link6_y * omega_link6_x;
  const Scalar alpha_link6_z = t_link5_4 + qdd[5];
  const Scalar Omega_link6_xy = t_link6_5 - alpha_link6_z;
  const Scalar t_link6_6 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_7 = t_link6_1 * t_link6_1;
  const Scalar t_link6_8 = t_link6_6 - t_link6_7;
  const Scalar t_link6_9 = t_link6_6 + t_link6_7;
  const Scalar a_link6_z = t_link5_8 + 4.654545454545454 * t_link5_1;
  // link7
  const Scalar a_link7_y = a_link6_z + 1.0666666666666667 * Omega_link6_zx;
  const Scalar t_link7_1 = omega_link6_y - qd[6];
  const Scalar Omega_link7_zy = Omega_link6_zy + t_link6_2 * t_link7_1;
  const Scalar t_link7_2 = t_link6_4 + qdd[6];
  const Scalar Omega_link7_yx = Omega_link6_zx + qdd[6];
  // link6
  const Scalar t_link6_10 = t_link5_13 - t_link6_8;
  const Scalar t_link6_11 = t_link5_10 + 4.654545454545454 * t_link4_14;
  const Scalar t_link6_12 = t_link5_7 + 4.654545454545454 * t_link5_2;
  const Scalar t_link6_13 = s_joint6 * t_link6_11 + c_joint6 * t_link6_12;
  const Scalar t_link7_3 = t_link6_13 + 1.0666666666666667 * t_link6_10;
  const Scalar Omega_link7_zx = Omega_link6_xy - omega_link6_x * t_link7_1 * 2.0;
  const Scalar Omega_link6_yx = t_link6_5 + alpha_link6_z;
  // link7
  const Scalar t_link7_4 = 1.0666666666666667 * Omega_link6_yx - c_joint6 * t_link6_11;
  const Scalar t_link7_5 = t_link7_4 + s_joint6 * t_link6_12;
  const Scalar t_link7_6 = t_link7_1 * t_link7_1;
  const Scalar t_link7_7 = 0.3842058806066518 - q[6];
  const auto [s_link7, c_link7] = sine_cosine(t_link7_7);
  const Scalar t_link7_8 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_9 = s_link7 * t_link7_8;
  const Scalar t_link7_10 = 0.0035997721513193665 + t_link7_9;
  const Scalar t_link7_11 = 0.0005571816285452074 - c_link7 * t_link7_8;
  const Scalar t_link7_12 = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  const Scalar t_link7_13 = 0.0013450149983408877 * s_link7 - 0.00113526676062776 * c_link7;
  const Scalar t_link7_14 = 0.0006883615516358103 * s_link7;
  const Scalar t_link7_15 = 0.0006883615516358103 * c_link7;
  const Scalar t_link7_16 = 0.0013098798160415795 - t_link7_9;
  const Scalar t_link7_17 = a_link7_y * t_link7_15 + Omega_link7_yx * t_link7_16;
  const Scalar t_link7_18 = t_link7_17 - t_link6_8 * t_link7_11 - t_link7_3 * t_link7_14;
  const Scalar t_link7_19 = t_link7_18 + t_link7_2 * t_link7_10 - Omega_link6_xy * t_link7_13;
  const Scalar M_link7_z = t_link7_19 - Omega_link6_zy * t_link7_12;
  tau[6] = M_link7_z;
  const Scalar t_link7_20 = Omega_link7_zy * t_link7_14 + 0.012759209153753906 * t_link7_5;
  const Scalar t_link7_21 = t_link7_20 - Omega_link7_zx * t_link7_15;
  const Scalar t_link7_22 = t_link6_6 - t_link7_6;
  const Scalar t_link7_23 = 0.012388667012232337 * t_link6_5 + Omega_link7_zx * t_link7_16;
  const Scalar t_link6_14 = 0.005511034382675315 * (t_link6_9 - t_link6_10);
  const Scalar t_link7_24 = t_link7_23 - t_link7_2 * t_link7_13 - t_link6_14;
  const Scalar t_link7_25 = t_link7_24 + 0.000103758917218685 * t_link6_3;
  const Scalar t_link7_26 = t_link7_25 + 9.3569097314605e-05 * t_link6_4;
  const Scalar t_link7_27 = t_link7_26 - 1.0666666666666667 * t_link7_21;
  const Scalar t_link7_28 = t_link7_27 + 0.0056786982094425 * t_link6_13;
  const Scalar t_link7_29 = t_link7_28 - t_link7_5 * t_link7_15 - t_link7_12 * t_link7_22;
  const Scalar t_link7_30 = t_link7_29 - 0.014628008479087448 * alpha_link6_z;
  const Scalar t_link7_31 = t_link7_30 + Omega_link7_zy * t_link7_11;
  tau[5] = -t_link7_31;
  const Scalar t_link6_15 = 9.3569097314605e-05 * (t_link5_13 - t_link6_9);
  const Scalar t_link7_32 = 0.0056786982094425 * a_link6_z - t_link6_15;
  const Scalar t_link7_33 = t_link7_32 + Omega_link7_yx * t_link7_12;
  const Scalar t_link7_34 = t_link7_33 + 0.005511034382675315 * Omega_link6_zx;
  const Scalar t_link7_35 = t_link7_34 + 0.000103758917218685 * Omega_link6_yx;
  const Scalar t_link7_36 = t_link7_13 * (t_link6_7 - t_link7_6);
  const Scalar t_link7_37 = t_link7_35 - t_link7_5 * t_link7_14 - t_link7_36;
  const Scalar t_link7_38 = t_link7_37 - Omega_link7_zx * t_link7_11;
  const Scalar t_link7_39 = t_link7_38 - 0.013508337745659894 * Omega_link6_zy;
  const Scalar t_link7_40 = t_link7_39 - Omega_link7_zy * t_link7_10;
  const Scalar t_link7_41 = 0.012759209153753906 * t_link7_3 - t_link7_2 * t_link7_14;
  const Scalar t_link7_42 = t_link7_41 + 0.0056786982094425 * Omega_link6_xy;
  const Scalar t_link7_43 = t_link7_42 + t_link7_15 * (t_link6_9 - t_link7_22);
  const Scalar t_link7_44 = 0.012759209153753906 * a_link7_y + Omega_link7_yx * t_link7_15;
  const Scalar F_link7_y = t_link7_44 + t_link7_14 * (t_link6_6 + t_link7_6);
  const Scalar t_link5_14 = t_link5_11 - t_link5_12;
  const Scalar t_link7_45 = M_link7_z + 1.0666666666666667 * F_link7_y;
  const Scalar t_link7_46 = t_link7_45 - 0.000103758917218685 * t_link6_8;
  const Scalar t_link7_47 = t_link7_46 + 9.3569097314605e-05 * Omega_link6_xy;
  const Scalar t_link7_48 = t_link7_47 + 0.001119670733427555 * Omega_link6_zx;
  const Scalar t_link7_49 = t_link7_48 - 0.005511034382675315 * Omega_link6_zy;
  const Scalar t_link5_15 = t_link4_14 - t_link5_13;
  const Scalar t_link5_16 = 0.00151524447332703 * (t_link5_14 - t_link5_15);
  // link6
  const Scalar t_link6_16 = 0.00859403176329453 * t_link5_9;
  const Scalar t_link6_17 = s_joint6 * t_link7_40 + t_link5_16 + t_link6_16;
  const Scalar t_link6_18 = t_link6_17 - 0.001208932934385 * t_link5_8;
  const Scalar t_link6_19 = t_link6_18 - 0.02389827041510187 * t_link5_2;
  const Scalar t_link6_20 = t_link6_19 - 0.0055993270925625 * t_link5_7;
  const Scalar t_link6_21 = 0.011496343893347959 * alpha_link5_z;
  const Scalar t_link6_22 = t_link6_20 + c_joint6 * t_link7_49 - t_link6_21;
  const Scalar t_link6_23 = t_link6_22 - 0.001026787777028894 * t_link5_1;
  tau[4] = -t_link6_23;
  const Scalar F_link6_y = t_link7_21 + 0.0056786982094425 * t_link6_9;
  const Scalar t_link6_24 = c_joint6 * t_link7_43 + s_joint6 * F_link6_y;
  const Scalar t_link6_25 = t_link6_24 - 0.0055993270925625 * Omega_link5_xy;
  const Scalar t_link5_17 = 0.001208932934385 * (t_link4_14 - t_link5_14);
  const Scalar t_link6_26 = t_link6_25 + 0.027672413504871093 * t_link5_7 - t_link5_17;
  const Scalar F_link6_z = F_link7_y - 0.0056786982094425 * Omega_link6_zy;
  const Scalar t_link6_27 = F_link6_z + 0.0055993270925625 * t_link5_13;
  const Scalar t_link6_28 = t_link6_27 + 0.001208932934385 * Omega_link5_yx;
  const Scalar t_link6_29 = t_link6_28 + 0.027672413504871093 * t_link5_8;
  const Scalar t_link4_19 = t_link4_14 - t_link3_13;
  const Scalar t_link4_20 = t_link4_18 + t_link4_19;
  // link5
  const Scalar t_link5_18 = t_link7_31 - 0.001026787777028894 * t_link5_14;
  const Scalar t_link5_19 = t_link5_18 - 0.00151524447332703 * Omega_link5_zy;
  const Scalar t_link5_20 = t_link5_19 - 0.001208932934385 * t_link5_10;
  const Scalar t_link5_21 = t_link5_20 - 4.654545454545454 * t_link6_24;
  const Scalar t_link5_22 = t_link5_21 + 0.02389827041510187 * Omega_link5_xy;
  const Scalar M_link5_y = t_link5_22 - 0.001451156065026714 * Omega_link5_zx;
  // link6
  const Scalar t_link6_30 = s_joint6 * t_link7_43 - c_joint6 * F_link6_y;
  const Scalar t_link6_31 = t_link6_30 + 0.027672413504871093 * t_link5_10;
  const Scalar t_link6_32 = t_link6_31 - 0.0055993270925625 * Omega_link5_zy;
  const Scalar t_link6_33 = t_link6_32 + 0.001208932934385 * Omega_link5_zx;
  const Scalar t_link6_34 = c_joint6 * t_link7_40 + 0.02389827041510187 * t_link5_15;
  const Scalar t_link6_35 = t_link6_34 - 4.654545454545454 * F_link6_z;
  const Scalar t_link5_23 = 0.0055993270925625 * t_link5_10;
  const Scalar t_link6_36 = t_link6_35 - s_joint6 * t_link7_49 + t_link5_23;
  const Scalar t_link6_37 = t_link6_36 - 0.010045187828321245 * Omega_link5_zy;
  const Scalar t_link6_38 = t_link6_37 - 0.00151524447332703 * Omega_link5_zx;
  const Scalar t_link6_39 = t_link6_38 - 0.001026787777028894 * Omega_link5_yx;
  // link4
  const Scalar t_link4_21 = t_link6_33 + 0.0039053550262761 * Omega_link4_yz;
  const Scalar t_link4_22 = 0.3087998849151318 * Omega_link4_xy;
  const Scalar t_link4_23 = t_link4_21 - c_joint5 * M_link5_y - t_link4_22;
  const Scalar t_link4_24 = t_link4_23 + 0.0825680742020475 * a_link4_x;
  const Scalar t_link4_25 = t_link4_24 + 0.07937575371526084 * t_link4_20;
  const Scalar t_link4_26 = t_link4_25 - 0.00164448757736927 * t_link4_8;
  const Scalar t_link4_27 = t_link4_26 + 0.0054157634981905 * Omega_link4_yx;
  const Scalar M_link4_z = t_link4_27 + s_joint5 * t_link6_39;
  tau[3] = M_link4_z;
  const Scalar t_link5_24 = c_joint5 * t_link6_29 + s_joint5 * t_link6_26;
  const Scalar t_link4_28 = t_link6_23 - t_link5_24 - 0.0054157634981905 * Omega_link4_zx;
  const Scalar t_link4_29 = t_link4_28 - 0.07937575371526084 * t_link4_3;
  const Scalar t_link4_30 = t_link4_29 + 0.0039053550262761 * t_link4_18;
  const Scalar M_link4_y = t_link4_30 - 0.00164448757736927 * Omega_link4_xy;
  const Scalar t_link4_31 = 0.00164448757736927 * t_link4_19;
  const Scalar t_link4_32 = t_link4_31 - 0.0825680742020475 * t_link4_15;
  const Scalar t_link4_33 = t_link4_32 + 0.3087998849151318 * t_link4_3;
  const Scalar t_link4_34 = t_link4_33 + 0.07937575371526084 * Omega_link4_zx;
  const Scalar t_link4_35 = t_link4_34 + 0.0039053550262761 * Omega_link4_yx;
  const Scalar t_link5_25 = t_link4_35 - c_joint5 * t_link6_39 - s_joint5 * M_link5_y;
  const Scalar t_link3_14 = t_link2_9 - t_link3_13;
  const Scalar F_link4_z = t_link5_24 + 0.0825680742020475 * t_link4_3;
  const Scalar t_link4_36 = F_link4_z - 0.016011409030815 * a_link3_y;
  const Scalar t_link4_37 = t_link4_36 - 0.002328735327435 * t_link3_9;
  const Scalar t_link4_38 = t_link4_37 + 0.03817619733278093 * t_link3_7;
  const Scalar t_link3_15 = 0.06681619663671426 * Omega_link3_yz;
  const Scalar t_link4_39 = t_link4_38 - s_joint4 * t_link5_25 - t_link3_15;
  const Scalar t_link4_40 = 0.00618010059697554 * t_link3_6;
  const Scalar t_link3_16 = 0.000121912420950744 * (t_link3_11 - t_link3_14);
  const Scalar t_link4_41 = t_link4_39 + c_joint4 * M_link4_y - t_link4_40 + t_link3_16;
  const Scalar t_link4_42 = t_link4_41 + 0.013297019103287584 * Omega_link3_xz;
  tau[2] = -t_link4_42;
  const Scalar t_link2_10 = 12.038675848622248 + 0.01026110182100817 * qdd[0];
  const Scalar F_link4_y = t_link6_33 + 0.0825680742020475 * t_link4_14;
  // link2
  const Scalar t_link2_11 = 0.01993386669246 - 0.0007689361029464 * qdd[0];
  const Scalar t_link2_12 = t_link2_2 - t_link2_3;
  const Scalar t_link2_13 = t_link2_9 - qd[0] * qd[0];
  const Scalar t_link2_14 = t_link2_12 + t_link2_13;
  const Scalar t_link5_26 = s_joint5 * t_link6_29 - c_joint5 * t_link6_26;
  // link4
  const Scalar t_link4_43 = (c_joint4 + 3.83030303030303 * s_joint4) * F_link4_y;
  const Scalar t_link4_44 = M_link4_z + 1.90390209202782 * c_joint2 - t_link4_43;
  const Scalar t_link4_45 = t_link4_44 + 0.013297019103287584 * t_link3_8;
  const Scalar t_link5_27 = t_link5_26 + 0.0825680742020475 * Omega_link4_xy;
  const Scalar t_link4_46 = (s_joint4 - 3.83030303030303 * c_joint4) * t_link5_27;
  const Scalar t_link4_47 = t_link4_45 - 0.015998048367902695 * t_link3_10 + t_link4_46;
  const Scalar t_link4_48 = t_link4_47 - 0.000121912420950744 * t_link3_2;
  const Scalar t_link4_49 = t_link4_48 - 0.06681619663671426 * t_link3_11;
  const Scalar t_link4_50 = 3.83030303030303 * F_link4_z;
  // link3
  const Scalar t_link3_17 = 0.27690780075318 * c_joint2 + t_link4_50;
  const Scalar t_link3_18 = 0.022178148964878235 * t_link3_2;
  const Scalar t_link3_19 = t_link3_17 + s_joint4 * M_link4_y - t_link3_18;
  const Scalar t_link3_20 = 0.013297019103287584 * t_link3_14;
  const Scalar t_link3_21 = t_link3_19 + c_joint4 * t_link5_25 - t_link3_20;
  const Scalar t_link3_22 = t_link3_21 - 0.000121912420950744 * t_link3_10;
  const Scalar M_link3_x = t_link3_22 + 0.06681619663671426 * t_link3_12;
  // link2
  const Scalar Omega_link2_yx = t_link2_7 + qdd[1];
  const Scalar t_link2_15 = c_joint2 * t_link2_11 - s_joint2 * t_link2_10;
  const Scalar t_link2_16 = t_link2_15 - 0.00398335888393552 * t_link2_14;
  const Scalar t_link2_17 = 0.3630902175294517 * Omega_link2_xy;
  const Scalar t_link2_18 = t_link2_16 - c_joint3 * t_link4_49 - t_link2_17;
  tau[1] = t_link2_18 + s_joint3 * M_link3_x + 0.023077882494931805 * Omega_link2_yx;
  const Scalar t_link2_19 = t_link2_6 + alpha_link2_y;
  const Scalar t_link2_20 = t_link4_42 + 0.00398335888393552 * t_link2_5;
  const Scalar t_link2_21 = t_link2_20 - 0.0007689361029464 * Omega_link2_xy;
  const Scalar t_link2_22 = t_link2_21 + 0.023077882494931805 * t_link2_19;
  const Scalar M_link2_y = t_link2_22 - 0.01026110182100817 * t_link2_12;
  const Scalar t_link2_23 = 0.3630902175294517 * t_link2_5;
  const Scalar t_link3_23 = t_link2_23 + 0.0007689361029464 * t_link2_13;
  const Scalar t_link2_24 = 0.01026110182100817 * Omega_link2_yx;
  const Scalar t_link3_24 = t_link3_23 - c_joint3 * M_link3_x - t_link2_24;
  const Scalar t_link2_25 = 0.00398335888393552 * t_link2_19;
  const Scalar t_link2_26 = s_joint2 * (t_link3_24 - s_joint3 * t_link4_49 + t_link2_25);
  // link1
  tau[0] = 0.014259565994474374 * qdd[0] - c_joint2 * M_link2_y + t_link2_26;
}

void forward_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar tau[7],
                      Scalar qdd[7]) noexcept {
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const auto [s_joint3, c_joint3] = sine_cosine(q[2]);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const auto [s_joint6, c_joint6] = sine_cosine(q[5]);
  // link2
  const Scalar t_link2_1 = 0.00796671776787104 * c_joint2;
  const Scalar t_link2_2 = t_link2_1 - 0.34001233503451994 * s_joint2;
  const Scalar t_link2_3 = qd[0] * (0.00398335888393552 - c_joint2 * t_link2_2);
  // link3
  const Scalar t_link3_1 = s_joint2 * qd[0];
  const Scalar omega_link3_y = s_joint3 * t_link3_1 + c_joint3 * qd[1];
  const Scalar t_link3_2 = c_joint2 * qd[0];
  const Scalar t_link3_3 = qd[1] * t_link3_2;
  const Scalar omega_link3_z = qd[2] + t_link3_2;
  const Scalar t_link3_4 = omega_link3_y * omega_link3_z;
  const Scalar t_link3_5 = c_joint3 * t_link3_3 - omega_link3_y * qd[2];
  const Scalar Omega_link3_yz = t_link3_4 + t_link3_5;
  const Scalar Omega_link3_zy = t_link3_4 - t_link3_5;
  const Scalar t_link3_6 = c_joint3 * t_link3_1 - s_joint3 * qd[1];
  const Scalar t_link3_7 = t_link3_6 * t_link3_6;
  const Scalar t_link3_8 = omega_link3_y * omega_link3_y;
  const Scalar t_link3_9 = t_link3_7 + t_link3_8;
  const Scalar t_link3_10 = omega_link3_z * omega_link3_z;
  const Scalar alpha_link3_y = s_joint3 * t_link3_3 + qd[2] * t_link3_6;
  const Scalar t_link3_11 = omega_link3_z * t_link3_6;
  const Scalar Omega_link3_xz = alpha_link3_y - t_link3_11;
  const Scalar t_link3_12 = alpha_link3_y + t_link3_11;
  const Scalar t_link3_13 = omega_link3_y * t_link3_6;
  const Scalar t_link3_14 = qd[1] * t_link3_1;
  const Scalar t_link3_15 = t_link3_13 - t_link3_14;
  const Scalar t_link3_16 = t_link3_13 + t_link3_14;
  const Scalar t_link3_17 = 118.9090909090909 * s_joint2;
  const Scalar t_link3_18 = c_joint3 * t_link3_17;
  const Scalar a_link3_y = s_joint3 * t_link3_17;
  const Scalar t_link3_19 = t_link3_8 + t_link3_10;
  // link4
  const Scalar t_link4_1 = 3.83030303030303 * Omega_link3_xz;
  const Scalar t_link4_2 = t_link3_18 + t_link3_19 - t_link4_1;
  const Scalar t_link4_3 = omega_link3_y - qd[3];
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy + s_joint4 * t_link3_15;
  const Scalar t_link4_4 = c_joint4 * omega_link3_z + s_joint4 * t_link3_6;
  const Scalar t_link4_5 = Omega_link4_yz - t_link4_3 * t_link4_4 * 2.0;
  const Scalar t_link4_6 = s_joint4 * omega_link3_z - c_joint4 * t_link3_6;
  const Scalar t_link4_7 = t_link4_3 * t_link4_6;
  const Scalar t_link4_8 = c_joint4 * t_link3_15 - s_joint4 * Omega_link3_zy;
  const Scalar alpha_link5_z = t_link4_7 + t_link4_8;
  const Scalar Omega_link4_zx = t_link4_7 + alpha_link5_z;
  const Scalar a_link4_z = t_link3_16 - a_link3_y - 3.83030303030303 * Omega_link3_yz;
  const Scalar t_link4_9 = t_link4_6 * t_link4_6;
  const Scalar t_link4_10 = t_link4_3 * t_link4_3;
  const Scalar t_link4_11 = t_link4_9 + t_link4_10;
  const Scalar t_link4_12 = t_link4_4 * t_link4_6;
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_12;
  // link5
  const Scalar t_link5_1 = s_joint5 * Omega_link4_xy + c_joint5 * t_link4_5;
  const Scalar omega_link5_y = c_joint5 * t_link4_3 - s_joint5 * t_link4_6;
  const Scalar omega_link5_z = t_link4_4 + qd[4];
  const Scalar Omega_link5_zy = t_link5_1 + omega_link5_y * omega_link5_z * 2.0;
  const Scalar omega_link5_x = s_joint5 * t_link4_3 + c_joint5 * t_link4_6;
  const Scalar t_link5_2 = omega_link5_z * omega_link5_x;
  const Scalar t_link5_3 = s_joint5 * t_link4_5 - c_joint5 * Omega_link4_xy;
  const Scalar alpha_link6_z = t_link5_2 + t_link5_3;
  const Scalar Omega_link5_zx = t_link5_2 + alpha_link6_z;
  // link4
  const Scalar t_link4_13 = t_link3_12 - 118.9090909090909 * c_joint2;
  const Scalar t_link4_14 = t_link4_13 + 3.83030303030303 * t_link3_9;
  const Scalar a_link4_x = s_joint4 * t_link4_14 + c_joint4 * t_link4_2;
  const Scalar t_link3_20 = t_link3_7 + t_link3_10;
  const Scalar t_link4_15 = t_link4_9 - t_link4_10;
  const Scalar t_link4_16 = t_link3_20 - t_link4_15;
  // link5
  const Scalar t_link5_4 = a_link4_x - t_link4_16;
  const Scalar t_link5_5 = Omega_link4_zx + a_link4_z;
  const Scalar t_link5_6 = c_joint5 * t_link5_4 + s_joint5 * t_link5_5;
  const Scalar t_link5_7 = c_joint5 * t_link5_5 - s_joint5 * t_link5_4;
  const Scalar t_link4_17 = alpha_link3_y - t_link4_12;
  const Scalar a_link5_z = t_link4_17 + s_joint4 * t_link4_2 - c_joint4 * t_link4_14;
  const Scalar t_link5_8 = omega_link5_y * omega_link5_x;
  const Scalar t_link5_9 = alpha_link5_z - t_link5_8;
  const Scalar t_link5_10 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_11 = omega_link5_z * omega_link5_z;
  const Scalar Omega_link5_yx = alpha_link5_z + t_link5_8;
  const Scalar t_link5_12 = t_link5_10 + t_link5_11;
  // link6
  const Scalar t_link6_1 = s_joint6 * Omega_link5_zy - c_joint6 * t_link5_9;
  const Scalar omega_link6_x = c_joint6 * omega_link5_x + s_joint6 * omega_link5_z;
  const Scalar t_link6_2 = omega_link5_y - qd[5];
  const Scalar t_link6_3 = 2.0 * t_link6_2;
  const Scalar Omega_link6_zx = t_link6_1 - omega_link6_x * t_link6_3;
  const Scalar t_link6_4 = s_joint6 * t_link5_9 + c_joint6 * Omega_link5_zy;
  const Scalar t_link6_5 = s_joint6 * omega_link5_x - c_joint6 * omega_link5_z;
  const Scalar Omega_link6_zy = t_link6_4 + t_link6_3 * t_link6_5;
  const Scalar t_link6_6 = t_link5_6 + 4.654545454545454 * t_link5_3;
  const Scalar t_link6_7 = a_link5_z - 4.654545454545454 * t_link4_11;
  const Scalar a_link6_z = t_link5_7 + 4.654545454545454 * t_link5_1;
  const Scalar t_link6_8 = omega_link6_x * t_link6_5;
  const Scalar Omega_link7_xz = alpha_link6_z + t_link6_8;
  const Scalar Omega_link6_yx = alpha_link6_z - t_link6_8;
  const Scalar t_link6_9 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_10 = t_link6_2 * t_link6_2;
  const Scalar t_link6_11 = t_link6_9 - t_link6_10;
  const Scalar t_link6_12 = t_link6_9 + t_link6_10;
  const Scalar omega_link7_z = t_link6_5 + qd[6];
  const Scalar Omega_link7_zy = Omega_link6_zy - t_link6_3 * omega_link7_z;
  const Scalar a_link6_y = c_joint6 * t_link6_7 + s_joint6 * t_link6_6;
  const Scalar t_link7_1 = a_link6_y + 1.0666666666666667 * Omega_link6_yx;
  const Scalar a_link6_x = s_joint6 * t_link6_7 - c_joint6 * t_link6_6;
  const Scalar t_link6_13 = t_link5_12 - t_link6_11;
  // link7
  const Scalar a_link7_x = a_link6_x - 1.0666666666666667 * t_link6_13;
  const Scalar t_link7_2 = Omega_link7_xz - omega_link6_x * omega_link7_z * 2.0;
  const Scalar t_link7_3 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_4 = 0.3842058806066518 - q[6];
  const auto [s_link7, c_link7] = sine_cosine(t_link7_4);
  const Scalar t_link7_5 = 0.0011143632570904149 * c_link7 - 0.0022898923352777873 * s_link7;
  const Scalar t_link7_6 = c_link7 * t_link7_5;
  const Scalar t_link7_7 = 0.0005571816285452074 - t_link7_6;
  const Scalar I_link7_yz = 0.0013450149983408877 * s_link7 - 0.00113526676062776 * c_link7;
  const Scalar t_link7_8 = s_link7 * t_link7_5;
  const Scalar t_link7_9 = 0.00113526676062776 * s_link7 + 0.0013450149983408877 * c_link7;
  const Scalar h_link7_x = 0.0006883615516358103 * c_link7;
  const Scalar t_link7_10 = 0.0006883615516358103 * s_link7;
  const Scalar t_link7_11 = t_link6_9 + t_link7_3;
  const Scalar h_link6_x = 0.0136098230973375 + h_link7_x;
  const Scalar t_link7_12 = 0.012759209153753906 * a_link6_z + Omega_link6_zx * h_link6_x;
  const Scalar F_link7_y = t_link7_12 + t_link7_10 * t_link7_11;
  const Scalar I_link6_yz = 9.3569097314605e-05 - I_link7_yz;
  const Scalar t_link7_13 = 0.0007342523217448644 * c_link7;
  const Scalar I_link6_xy = 0.005511034382675315 + t_link7_9;
  const Scalar I_link7_xx = 0.0035997721513193665 + t_link7_8;
  const Scalar t_link6_14 = 0.000103758917218685 * Omega_link6_yx;
  const Scalar t_link7_14 = 0.0056786982094425 * a_link6_z + t_link6_14;
  const Scalar t_link6_15 = 9.3569097314605e-05 * (t_link5_12 - t_link6_12);
  const Scalar t_link7_15 = t_link7_14 + Omega_link6_zx * I_link6_xy - t_link6_15;
  const Scalar t_link7_16 = t_link7_15 - 0.013508337745659894 * Omega_link6_zy;
  const Scalar t_link7_17 = t_link7_16 - Omega_link7_zy * I_link7_xx;
  const Scalar t_link7_18 = t_link7_17 - t_link7_1 * t_link7_10;
  const Scalar t_link7_19 = t_link7_18 + t_link7_2 * t_link7_7;
  const Scalar t_link7_20 = t_link7_19 - I_link7_yz * (t_link6_12 - t_link7_11);
  const Scalar t_link7_21 = 0.012759209153753906 * t_link7_1 + t_link7_2 * h_link7_x;
  const Scalar t_link7_22 = t_link7_21 + Omega_link7_zy * t_link7_10;
  const Scalar F_link6_y = t_link7_22 + 0.0056786982094425 * t_link6_12;
  const Scalar I_link7_yy = 0.0013098798160415795 - t_link7_8;
  const Scalar t_link7_23 = a_link6_z * h_link7_x + a_link7_x * t_link7_10;
  const Scalar t_link7_24 = Omega_link6_zx * (t_link7_13 + I_link7_yy);
  const Scalar t_link7_25 = t_link7_23 - t_link6_11 * t_link7_7 + t_link7_24;
  const Scalar t_link7_26 = t_link7_25 - Omega_link6_zy * t_link7_9;
  const Scalar M_link7_z = t_link7_26 + Omega_link7_xz * I_link7_yz + t_link6_1 * I_link7_xx;
  const Scalar t_link7_27 = M_link7_z + 1.0666666666666667 * F_link7_y;
  const Scalar t_link7_28 = t_link7_27 - 0.005511034382675315 * Omega_link6_zy;
  const Scalar t_link7_29 = t_link7_28 + 0.001119670733427555 * Omega_link6_zx;
  const Scalar t_link7_30 = t_link7_29 - 0.000103758917218685 * t_link6_11;
  const Scalar t_link7_31 = t_link7_30 - 9.3569097314605e-05 * Omega_link7_xz;
  // link6
  const Scalar F_link6_z = F_link7_y - 0.0056786982094425 * Omega_link6_zy;
  const Scalar t_link6_16 = F_link6_z + 0.001208932934385 * Omega_link5_yx;
  const Scalar t_link6_17 = t_link6_16 + 0.027672413504871093 * t_link5_7;
  const Scalar t_link6_18 = t_link6_17 + 0.0055993270925625 * t_link5_12;
  const Scalar t_link6_19 = 0.0056786982094425 * Omega_link7_xz;
  const Scalar t_link6_20 = t_link6_1 * t_link7_10 + t_link6_19;
  const Scalar t_link6_21 = t_link6_20 - h_link7_x * (t_link6_10 + t_link7_3);
  const Scalar F_link6_x = t_link6_21 + 0.012759209153753906 * a_link7_x;
  const Scalar t_link6_22 = s_joint6 * F_link6_y - c_joint6 * F_link6_x;
  const Scalar t_link5_13 = t_link5_10 - t_link5_11;
  const Scalar t_link6_23 = 0.012388667012232337 * t_link6_8;
  const Scalar t_link6_24 = t_link6_23 + 0.0056786982094425 * a_link6_x;
  const Scalar t_link6_25 = t_link6_24 - 0.000103758917218685 * t_link6_4;
  const Scalar t_link6_26 = 0.005511034382675315 * (t_link6_12 - t_link6_13);
  const Scalar t_link6_27 = t_link6_25 + 1.0666666666666667 * t_link7_22 + t_link6_26;
  const Scalar t_link6_28 = t_link6_27 + t_link7_1 * h_link7_x;
  const Scalar t_link6_29 = t_link6_28 + 0.014628008479087448 * alpha_link6_z;
  const Scalar t_link6_30 = t_link6_29 - Omega_link7_zy * t_link7_7;
  const Scalar t_link7_32 = t_link7_9 * (t_link6_9 - t_link7_3);
  const Scalar t_link6_31 = t_link6_30 + t_link7_2 * I_link7_yy + t_link7_32;
  const Scalar M_link6_z = t_link6_31 - t_link6_1 * I_link6_yz;
  const Scalar t_link6_32 = M_link6_z + 4.654545454545454 * t_link6_22;
  const Scalar t_link6_33 = t_link6_32 - 0.001208932934385 * a_link5_z;
  const Scalar t_link6_34 = t_link6_33 + 0.001026787777028894 * t_link5_13;
  const Scalar t_link6_35 = t_link6_34 + 0.00151524447332703 * Omega_link5_zy;
  const Scalar t_link6_36 = t_link6_35 + 0.001451156065026714 * Omega_link5_zx;
  const Scalar t_link6_37 = t_link6_36 + 0.02389827041510187 * t_link5_9;
  const Scalar t_link6_38 = c_joint6 * t_link7_20 - 0.001026787777028894 * Omega_link5_yx;
  const Scalar t_link5_14 = 0.02389827041510187 * (t_link4_11 - t_link5_12);
  const Scalar t_link6_39 = t_link6_38 + t_link5_14 - s_joint6 * t_link7_31;
  const Scalar t_link6_40 = t_link6_39 - 0.010045187828321245 * Omega_link5_zy;
  const Scalar t_link6_41 = t_link6_40 - 0.0055993270925625 * a_link5_z;
  const Scalar t_link6_42 = t_link6_41 - 4.654545454545454 * F_link6_z;
  const Scalar t_link6_43 = t_link6_42 - 0.00151524447332703 * Omega_link5_zx;
  const Scalar t_link5_15 = t_link4_11 - t_link5_13;
  const Scalar t_link6_44 = t_link6_22 - 0.001208932934385 * t_link5_15;
  const Scalar t_link6_45 = t_link6_44 + 0.027672413504871093 * t_link5_6;
  const Scalar t_link6_46 = t_link6_45 + 0.0055993270925625 * t_link5_9;
  const Scalar t_link5_16 = c_joint5 * t_link6_18 + s_joint5 * t_link6_46;
  const Scalar t_link6_47 = s_joint6 * t_link7_20 - 0.02389827041510187 * t_link5_3;
  const Scalar t_link6_48 = t_link6_47 - 0.0055993270925625 * t_link5_6;
  const Scalar t_link6_49 = t_link6_48 - 0.001026787777028894 * t_link5_1;
  const Scalar t_link5_17 = 0.00151524447332703 * (t_link5_12 - t_link5_15);
  const Scalar t_link6_50 = t_link6_49 - 0.010045187828321245 * t_link5_9 + t_link5_17;
  const Scalar t_link6_51 = t_link6_50 - 0.001208932934385 * t_link5_7;
  const Scalar t_link6_52 = t_link6_51 - 0.001451156065026714 * Omega_link5_yx;
  const Scalar t_link6_53 = t_link6_52 + c_joint6 * t_link7_31;
  const Scalar t_link4_18 = 0.00164448757736927 * Omega_link4_xy;
  // link5
  const Scalar t_link5_18 = t_link5_16 - t_link6_53 + t_link4_18;
  const Scalar t_link5_19 = t_link5_18 + 0.0054157634981905 * Omega_link4_zx;
  const Scalar t_link5_20 = t_link5_19 + 0.07937575371526084 * t_link4_5;
  const Scalar t_link5_21 = t_link5_20 - 0.0039053550262761 * t_link4_15;
  const Scalar t_link5_22 = s_joint5 * t_link6_18 + 0.0825680742020475 * Omega_link4_xy;
  const Scalar t_link5_23 = t_link5_22 - c_joint5 * t_link6_46;
  const Scalar t_link5_24 = 0.027672413504871093 * a_link5_z + c_joint6 * F_link6_y;
  const Scalar t_link5_25 = t_link5_24 + 0.0055993270925625 * Omega_link5_zy;
  const Scalar t_link5_26 = t_link5_25 - 0.001208932934385 * Omega_link5_zx;
  const Scalar F_link5_z = t_link5_26 + s_joint6 * F_link6_x;
  const Scalar t_link5_27 = F_link5_z - 0.0825680742020475 * t_link4_11;
  // link4
  const Scalar F_link4_z = t_link5_16 + 0.0825680742020475 * t_link4_5;
  const Scalar t_link4_19 = 0.00164448757736927 * (t_link4_11 - t_link3_20);
  const Scalar t_link4_20 = t_link4_19 + 0.0825680742020475 * a_link4_z;
  const Scalar t_link4_21 = t_link4_20 - 0.0039053550262761 * t_link4_17;
  const Scalar t_link4_22 = t_link4_21 + 0.07937575371526084 * Omega_link4_zx;
  const Scalar t_link4_23 = t_link4_22 + 0.3087998849151318 * t_link4_5;
  const Scalar t_link5_28 = t_link4_23 + s_joint5 * t_link6_37 - c_joint5 * t_link6_43;
  const Scalar t_link1_1 = M_link7_z - tau[6];
  const Scalar t_link7_33 = 0.0014685046434897288 * c_link7;
  // link6
  const Scalar t_link6_54 = 0.0056786982094425 * s_joint6 + c_joint6 * h_link6_x;
  const Scalar t_link6_55 = 0.001208932934385 - t_link6_54;
  const Scalar t_link6_56 = 0.0056786982094425 * c_joint6 - s_joint6 * h_link6_x;
  const Scalar h_link5_y = 0.0055993270925625 + t_link7_10;
  const Scalar t_link6_57 = 0.0006609405457638925 - t_link7_6;
  const Scalar t_link6_58 = t_link6_57 - 0.0007342523217448644 * s_link7;
  const Scalar t_link6_59 = t_link7_8 - t_link7_33;
  const Scalar t_link6_60 = s_joint6 * (0.0034383574409692415 - t_link6_59);
  const Scalar t_link6_61 = c_joint6 * I_link6_xy * 2.0 - t_link6_60;
  const Scalar t_link6_62 = s_joint6 * t_link6_61;
  const Scalar t_link6_63 = s_joint6 * I_link6_yz + c_joint6 * t_link6_58;
  const Scalar t_link6_64 = 9.309090909090909 * t_link6_56;
  const Scalar t_link5_29 = c_joint5 * t_link6_55 + s_joint5 * h_link5_y;
  const Scalar h_link4_x = 0.040431622658625 + t_link5_29;
  const Scalar h_link4_z = s_joint5 * t_link6_55 - c_joint5 * h_link5_y;
  const Scalar t_link5_30 = 0.1419563931722475 - t_link6_56;
  const Scalar t_link6_65 = c_joint6 * I_link6_yz - s_joint6 * t_link6_58;
  // link5
  const Scalar t_link5_31 = 0.02389827041510187 + t_link6_65;
  const Scalar t_link5_32 = t_link5_31 + 0.0032040101312503172 * s_link7;
  const Scalar t_link5_33 = t_link7_8 - t_link6_62;
  const Scalar t_link5_34 = s_joint5 * (t_link5_33 - (0.004752891272015237 - t_link6_59));
  const Scalar t_link5_35 = c_joint5 * (0.00303048894665406 - 2.0 * t_link6_63);
  const Scalar t_link5_36 = t_link5_34 - t_link5_35;
  const Scalar t_link5_37 = s_joint5 * t_link5_36;
  const Scalar t_link5_38 = 0.004484246605646421 + t_link7_9;
  const Scalar t_link5_39 = t_link5_38 + 4.654545454545454 * t_link6_54;
  const Scalar t_link5_40 = t_link5_39 - c_joint6 * t_link6_61;
  const Scalar t_link5_41 = c_joint5 * t_link5_32 + s_joint5 * t_link5_40;
  const Scalar t_link5_42 = s_joint5 * t_link5_32 - c_joint5 * t_link5_40;
  const Scalar t_link5_43 = 2.0 * t_link5_29;
  // link4
  const Scalar t_link4_24 = c_joint4 * t_link5_30 - s_joint4 * h_link4_x;
  const Scalar t_link4_25 = c_joint4 * h_link4_x + s_joint4 * t_link5_30;
  const Scalar t_link4_26 = 0.00239011055294907 + t_link6_63 + h_link4_z;
  const Scalar t_link4_27 = t_link4_26 - c_joint5 * t_link5_36;
  const Scalar I_link4_yz = 0.00164448757736927 - t_link5_41;
  const Scalar t_link4_28 = t_link6_56 - t_link5_42;
  const Scalar t_link4_29 = t_link6_64 - t_link5_33 + t_link5_37;
  const Scalar I_link5_zz = 0.03204281123129646 + t_link7_33 + t_link6_62;
  const Scalar t_link4_30 = t_link5_43 + I_link5_zz;
  const Scalar t_link4_31 = s_joint4 * (t_link4_30 - (0.5665314265994568 - t_link4_29));
  const Scalar t_link4_32 = c_joint4 * (0.2775281453709217 - 2.0 * t_link4_28);
  const Scalar t_link4_33 = t_link4_32 - t_link4_31;
  const Scalar t_link4_34 = s_joint4 * t_link4_33;
  const Scalar t_link4_35 = s_joint4 * I_link4_yz + c_joint4 * t_link4_27;
  const Scalar t_link4_36 = c_joint4 * I_link4_yz - s_joint4 * t_link4_27;
  const Scalar t_link4_37 = 7.66060606060606 * t_link4_24;
  const Scalar t_link4_38 = 2.0 * t_link4_25;
  // link3
  const Scalar t_link3_21 = t_link4_28 - (0.3604456361115751 + t_link4_24);
  const Scalar t_link3_22 = t_link3_21 + 3.83030303030303 * t_link4_25;
  const Scalar I_link3_xz = t_link3_22 + c_joint4 * t_link4_33;
  const Scalar t_link3_23 = h_link4_z - t_link4_35;
  const Scalar t_link3_24 = t_link4_29 + t_link4_34;
  const Scalar t_link3_25 = t_link5_37 - (t_link6_59 + t_link6_64) + t_link5_43;
  const Scalar t_link3_26 = t_link4_38 - t_link3_25;
  const Scalar t_link3_27 = s_joint3 * (t_link3_26 - (0.0848517994904802 + t_link3_24));
  const Scalar t_link3_28 = c_joint3 * (0.000243824841901488 - 2.0 * t_link3_23);
  const Scalar t_link3_29 = t_link3_28 - t_link3_27;
  const Scalar t_link3_30 = s_joint3 * t_link3_29;
  const Scalar t_link7_34 = 0.004909651967360946 + t_link7_13;
  // link6
  const Scalar t_link6_66 = 0.0032040101312503172 * c_link7 - c_joint6 * t_link7_9;
  const Scalar t_link6_67 = t_link6_66 + s_joint6 * t_link7_34;
  const Scalar t_link6_68 = c_joint6 * t_link7_10;
  const Scalar t_link6_69 = I_link7_yz - 4.654545454545454 * t_link6_68;
  const Scalar t_link6_70 = c_joint6 * t_link7_34 + s_joint6 * t_link7_9;
  const Scalar t_link6_71 = s_joint6 * t_link7_10;
  // link5
  const Scalar t_link5_44 = t_link6_71 - c_joint5 * t_link6_69 + s_joint5 * t_link6_67;
  const Scalar t_link5_45 = c_joint5 * t_link6_67 + s_joint5 * t_link6_69;
  const Scalar t_link5_46 = s_joint5 * t_link6_68 - c_joint5 * h_link7_x;
  const Scalar t_link5_47 = t_link6_70 + t_link5_46;
  const Scalar t_link4_39 = t_link5_46 + s_joint4 * t_link5_45 - c_joint4 * t_link5_47;
  const Scalar t_link5_48 = c_joint5 * t_link6_68 + s_joint5 * h_link7_x;
  // link4
  const Scalar t_link4_40 = 3.83030303030303 * t_link5_46 - s_joint4 * t_link5_47;
  const Scalar t_link4_41 = t_link4_40 - c_joint4 * t_link5_45;
  const Scalar t_link4_42 = s_joint4 * (t_link5_48 + 3.83030303030303 * t_link6_71);
  const Scalar t_link4_43 = c_joint4 * (t_link6_71 - 3.83030303030303 * t_link5_48);
  const Scalar t_link4_44 = t_link5_44 - t_link4_42 - t_link4_43;
  // link3
  const Scalar t_link3_31 = s_joint2 * (c_joint3 * t_link4_41 + s_joint3 * t_link4_44);
  const Scalar t_link3_32 = t_link3_31 + c_joint2 * t_link4_39;
  const Scalar t_link3_33 = s_joint3 * t_link4_41 - c_joint3 * t_link4_44;
  const Scalar I_link6_zz = 0.030455032932289027 - t_link6_59;
  const Scalar t_link6_72 = I_link6_zz - 4.654545454545454 * t_link6_56;
  // link5
  const Scalar t_link5_49 = s_joint5 * t_link6_72 - c_joint5 * t_link6_63;
  const Scalar t_link5_50 = s_joint5 * t_link6_56;
  const Scalar t_link5_51 = t_link6_65 - t_link5_50;
  const Scalar t_link4_45 = 3.83030303030303 * t_link5_50 - c_joint4 * t_link5_49;
  const Scalar t_link4_46 = t_link4_45 + s_joint4 * t_link5_51;
  const Scalar t_link5_52 = t_link6_54 - c_joint5 * t_link6_72 - s_joint5 * t_link6_63;
  // link4
  const Scalar t_link4_47 = s_joint4 - 3.83030303030303 * c_joint4;
  const Scalar t_link4_48 = t_link6_54 * (c_joint4 + 3.83030303030303 * s_joint4);
  const Scalar t_link4_49 = t_link5_52 - t_link4_48 - c_joint5 * t_link6_56 * t_link4_47;
  const Scalar t_link5_53 = t_link5_29 + I_link5_zz;
  const Scalar t_link4_50 = s_joint4 * t_link5_53 - 3.83030303030303 * t_link5_29;
  const Scalar t_link4_51 = t_link4_50 - c_joint4 * t_link5_42;
  const Scalar t_link4_52 = t_link5_41 + h_link4_z * t_link4_47;
  const Scalar I_link4_zz = 0.662979090185103 + t_link3_25;
  const Scalar t_link4_53 = t_link4_25 - I_link4_zz - 3.83030303030303 * t_link4_24;
  // link7
  const Scalar t_link7_35 = 203.68042513969144 * t_link3_33;
  const Scalar t_link7_36 = 203.68042513969144 * t_link4_39;
  const Scalar t_link7_37 = 203.68042513969144 * t_link6_70;
  const Scalar t_link7_38 = 203.68042513969144 * I_link7_yz;
  const Scalar t_link4_54 = t_link5_50 + s_joint4 * t_link5_49 + c_joint4 * t_link5_51;
  const Scalar t_link3_34 = s_joint2 * (c_joint3 * t_link4_46 + s_joint3 * t_link4_49);
  const Scalar t_link7_39 = t_link3_32 * t_link7_38 - c_joint2 * t_link4_54 - t_link3_34;
  const Scalar t_link7_40 = 203.68042513969144 * t_link3_32;
  const Scalar t_link7_41 = I_link7_yz * t_link7_35 + c_joint3 * t_link4_49;
  const Scalar t_link7_42 = t_link7_41 - s_joint3 * t_link4_46;
  const Scalar t_link7_43 = t_link4_54 - t_link4_39 * t_link7_38;
  const Scalar t_link7_44 = 203.68042513969144 * t_link5_44;
  const Scalar t_link7_45 = t_link5_52 - I_link7_yz * t_link7_44;
  const Scalar t_link7_46 = t_link6_65 + I_link7_yz * t_link7_37;
  // link6
  const Scalar inverse_pivot_link6 = 1.0 / (I_link6_zz - I_link7_yz * t_link7_38);
  const Scalar t_link6_73 = t_link7_42 * inverse_pivot_link6;
  const Scalar t_link6_74 = t_link7_43 * inverse_pivot_link6;
  const Scalar t_link6_75 = t_link7_39 * inverse_pivot_link6;
  const Scalar t_link4_55 = t_link5_29 - s_joint4 * t_link5_42 - c_joint4 * t_link5_53;
  const Scalar t_link6_76 = t_link7_46 * inverse_pivot_link6;
  const Scalar t_link6_77 = c_joint2 * t_link4_55 - t_link6_70 * t_link7_40;
  const Scalar t_link3_35 = s_joint2 * (c_joint3 * t_link4_51 - s_joint3 * t_link4_52);
  const Scalar t_link6_78 = t_link6_77 - t_link7_46 * t_link6_75 - t_link3_35;
  const Scalar t_link3_36 = s_joint3 * t_link4_51 + c_joint3 * t_link4_52;
  const Scalar t_link7_47 = t_link3_36 + t_link6_70 * t_link7_35;
  const Scalar t_link6_79 = t_link7_47 + t_link7_42 * t_link6_76;
  const Scalar t_link7_48 = t_link4_55 - t_link4_39 * t_link7_37;
  const Scalar t_link6_80 = t_link7_48 + t_link7_46 * t_link6_74;
  const Scalar t_link6_81 = t_link7_45 * inverse_pivot_link6;
  const Scalar t_link6_82 = t_link5_41 + t_link7_46 * t_link6_81;
  const Scalar t_link6_83 = t_link6_82 - t_link6_70 * t_link7_44;
  const Scalar t_link7_49 = I_link5_zz - t_link6_70 * t_link7_37;
  // link5
  const Scalar inverse_pivot_link5 = 1.0 / (t_link7_49 - t_link7_46 * t_link6_76);
  const Scalar t_link5_54 = t_link6_79 * inverse_pivot_link5;
  const Scalar t_link5_55 = t_link6_80 * inverse_pivot_link5;
  const Scalar t_link5_56 = t_link6_83 * inverse_pivot_link5;
  const Scalar t_link3_37 = s_joint2 * (s_joint3 * t_link4_53 - c_joint3 * t_link4_35);
  const Scalar t_link7_50 = t_link3_37 + t_link3_32 * t_link7_44 - c_joint2 * t_link4_36;
  const Scalar t_link6_84 = t_link7_50 - t_link7_39 * t_link6_81;
  const Scalar t_link5_57 = t_link6_84 + t_link6_78 * t_link5_56;
  const Scalar t_link5_58 = t_link7_45 * t_link6_73 + s_joint3 * t_link4_35;
  const Scalar t_link5_59 = t_link5_58 + t_link6_79 * t_link5_56;
  const Scalar t_link5_60 = t_link5_59 - t_link3_33 * t_link7_44 + c_joint3 * t_link4_53;
  const Scalar t_link6_85 = t_link4_36 - t_link7_43 * t_link6_81;
  const Scalar t_link6_86 = t_link6_85 - t_link4_39 * t_link7_44;
  const Scalar t_link5_61 = t_link6_86 - t_link6_80 * t_link5_56;
  const Scalar t_link7_51 = I_link4_zz - t_link5_44 * t_link7_44;
  const Scalar t_link6_87 = t_link7_51 - t_link7_45 * t_link6_81;
  const Scalar inverse_pivot_link4 = 1.0 / (t_link6_87 - t_link6_83 * t_link5_56);
  // link3
  const Scalar t_link3_38 = t_link4_38 - (t_link4_30 + t_link4_34);
  const Scalar I_link3_zz = 0.12445520614822143 - t_link3_38;
  const Scalar t_link3_39 = 0.013297019103287584 - t_link4_36;
  const Scalar t_link3_40 = t_link3_39 - 3.83030303030303 * h_link4_z;
  const Scalar t_link3_41 = s_joint2 * (s_joint3 * t_link3_40 + c_joint3 * I_link3_xz);
  // link4
  const Scalar t_link4_56 = t_link5_61 * inverse_pivot_link4;
  const Scalar t_link4_57 = t_link3_41 - c_joint2 * I_link3_zz + t_link6_78 * t_link5_55;
  const Scalar t_link4_58 = t_link4_57 + t_link4_39 * t_link7_40;
  const Scalar t_link4_59 = t_link4_58 - t_link5_57 * t_link4_56;
  const Scalar t_link4_60 = t_link4_59 - t_link7_39 * t_link6_74;
  const Scalar t_link3_42 = s_joint3 * I_link3_xz - c_joint3 * t_link3_40;
  const Scalar t_link4_61 = t_link5_60 * inverse_pivot_link4;
  const Scalar t_link7_52 = t_link3_42 + t_link3_33 * t_link7_36;
  const Scalar t_link6_88 = t_link7_52 - t_link7_43 * t_link6_73;
  const Scalar t_link5_62 = t_link6_88 - t_link6_79 * t_link5_55;
  const Scalar t_link4_62 = t_link5_62 + t_link5_60 * t_link4_56;
  const Scalar t_link4_63 = I_link3_zz - t_link7_43 * t_link6_74;
  const Scalar t_link4_64 = t_link4_63 - t_link5_61 * t_link4_56;
  const Scalar t_link4_65 = t_link4_64 - t_link4_39 * t_link7_36;
  // link3
  const Scalar inverse_pivot_link3 = 1.0 / (t_link4_65 - t_link6_80 * t_link5_55);
  const Scalar t_link3_43 = t_link4_62 * inverse_pivot_link3;
  const Scalar t_link3_44 = t_link4_60 * inverse_pivot_link3;
  // link4
  const Scalar t_link4_66 = c_joint2 * (0.0007689361029464 - t_link3_42);
  const Scalar t_link4_67 = 0.010383014241958914 - t_link3_23 - c_joint3 * t_link3_29;
  const Scalar t_link4_68 = t_link4_66 + t_link5_57 * t_link4_61 + s_joint2 * t_link4_67;
  const Scalar t_link4_69 = t_link4_68 + t_link6_78 * t_link5_54;
  const Scalar t_link4_70 = t_link4_69 - t_link7_42 * t_link6_75;
  const Scalar t_link4_71 = t_link4_70 - t_link3_33 * t_link7_40;
  const Scalar t_link3_45 = t_link4_71 - t_link4_62 * t_link3_44;
  const Scalar t_link2_4 = t_link3_26 - (1.6987581449384432 + t_link4_37);
  const Scalar t_link7_53 = t_link3_30 + t_link2_4 + t_link3_33 * t_link7_35;
  const Scalar t_link6_89 = t_link7_53 + t_link7_42 * t_link6_73;
  const Scalar t_link4_72 = t_link6_89 + t_link5_60 * t_link4_61;
  const Scalar t_link4_73 = t_link4_72 + t_link6_79 * t_link5_54;
  const Scalar t_link2_5 = 1.0 / (t_link4_73 + t_link4_62 * t_link3_43);
  const Scalar t_link4_74 = t_link5_57 * inverse_pivot_link4;
  const Scalar t_link2_6 = t_link3_45 * t_link2_5;
  const Scalar t_link3_46 = t_link3_24 - (1.103283039275358 + t_link4_37);
  const Scalar t_link3_47 = s_joint2 * (t_link3_30 - t_link3_46 + t_link3_38);
  const Scalar t_link5_63 = t_link6_78 * inverse_pivot_link5;
  // link2
  const Scalar t_link2_7 = 0.16179265463762763 - t_link3_38;
  const Scalar t_link2_8 = t_link2_7 - c_joint2 * t_link3_41 * 2.0;
  const Scalar t_link2_9 = t_link2_8 - t_link7_39 * t_link6_75;
  const Scalar t_link2_10 = t_link2_9 - t_link4_60 * t_link3_44;
  const Scalar t_link2_11 = t_link2_10 + t_link3_45 * t_link2_6;
  const Scalar t_link2_12 = t_link2_11 - t_link5_57 * t_link4_74;
  const Scalar t_link2_13 = t_link2_12 - s_joint2 * (t_link2_2 - t_link3_47);
  const Scalar t_link2_14 = t_link2_13 - t_link3_32 * t_link7_40;
  // link1
  const Scalar inverse_pivot_link1 = 1.0 / (t_link2_14 - t_link6_78 * t_link5_63);
  const Scalar t_link1_2 = M_link6_z - tau[5] - t_link1_1 * t_link7_38;
  const Scalar t_link1_3 = t_link6_53 + tau[4] - t_link1_1 * t_link7_37;
  const Scalar t_link1_4 = t_link1_3 + t_link6_76 * t_link1_2;
  // link5
  const Scalar t_link5_64 = F_link5_z + 0.30338412141694127 * t_link4_12;
  const Scalar t_link5_65 = t_link5_64 - 0.0825680742020475 * a_link4_x;
  const Scalar t_link5_66 = t_link5_65 - 0.0039053550262761 * Omega_link4_yz;
  const Scalar t_link4_75 = 0.07937575371526084 * (t_link4_11 - t_link4_16);
  const Scalar t_link5_67 = t_link5_66 - t_link4_75 + 0.3142156484133223 * alpha_link3_y;
  const Scalar t_link5_68 = t_link5_67 + 0.00164448757736927 * t_link4_8;
  const Scalar t_link5_69 = t_link5_68 - s_joint5 * t_link6_43 - c_joint5 * t_link6_37;
  // link1
  const Scalar t_link1_5 = tau[3] + t_link5_69 - t_link1_1 * t_link7_44;
  const Scalar t_link1_6 = t_link1_5 - t_link6_81 * t_link1_2;
  const Scalar t_link1_7 = t_link1_6 - t_link5_56 * t_link1_4;
  // link3
  const Scalar t_link3_48 = t_link3_19 - t_link3_20;
  const Scalar t_link3_49 = t_link3_9 - t_link3_20;
  const Scalar t_link3_50 = t_link5_69 - 1.90390209202782 * c_joint2;
  const Scalar t_link3_51 = 0.06681619663671426 * (t_link3_9 - t_link3_19);
  const Scalar t_link3_52 = t_link3_50 + 0.015998048367902695 * t_link3_12 + t_link3_51;
  const Scalar t_link3_53 = c_joint4 * (t_link5_27 - 3.83030303030303 * t_link5_23);
  const Scalar t_link3_54 = s_joint4 * (t_link5_23 + 3.83030303030303 * t_link5_27);
  const Scalar t_link3_55 = t_link3_52 - t_link3_53 - t_link3_54;
  const Scalar t_link3_56 = t_link3_55 - 0.000121912420950744 * Omega_link3_zy;
  const Scalar M_link3_y = t_link3_56 - 0.013297019103287584 * t_link3_15;
  // link4
  const Scalar t_link4_76 = F_link4_z - 0.016011409030815 * a_link3_y;
  const Scalar t_link4_77 = t_link4_76 - 0.002328735327435 * t_link3_18;
  const Scalar t_link4_78 = t_link4_77 - 0.022178148964878235 * t_link3_15;
  const Scalar t_link4_79 = t_link4_78 + 0.013297019103287584 * Omega_link3_xz;
  const Scalar t_link4_80 = t_link4_79 - 0.000121912420950744 * t_link3_48;
  const Scalar t_link4_81 = t_link4_80 + 0.015998048367902695 * t_link3_16;
  const Scalar t_link3_57 = 0.06681619663671426 * Omega_link3_yz;
  const Scalar t_link4_82 = t_link4_81 - s_joint4 * t_link5_28 - t_link3_57;
  const Scalar t_link4_83 = t_link4_82 - c_joint4 * t_link5_21;
  // link1
  const Scalar t_link1_8 = tau[2] + t_link4_83 + t_link6_74 * t_link1_2;
  const Scalar t_link1_9 = t_link1_8 + t_link4_56 * t_link1_7;
  const Scalar t_link1_10 = t_link1_9 + t_link5_55 * t_link1_4;
  const Scalar t_link1_11 = t_link1_10 + t_link1_1 * t_link7_36;
  const Scalar t_link4_84 = 3.83030303030303 * F_link4_z;
  // link3
  const Scalar t_link3_58 = 0.27690780075318 * c_joint2 + t_link4_84;
  const Scalar t_link3_59 = t_link3_58 + 0.022178148964878235 * Omega_link3_zy;
  const Scalar t_link3_60 = t_link3_59 + c_joint4 * t_link5_28;
  const Scalar t_link3_61 = t_link3_60 - 0.013297019103287584 * t_link3_49;
  const Scalar t_link3_62 = t_link3_61 + 0.06681619663671426 * t_link3_16;
  const Scalar t_link3_63 = t_link3_62 - s_joint4 * t_link5_21;
  const Scalar M_link3_x = t_link3_63 - 0.000121912420950744 * t_link3_12;
  // link1
  const Scalar t_link1_12 = inverse_pivot_link5 * t_link1_4;
  const Scalar t_link1_13 = tau[1] + 12.038675848622248 * s_joint2;
  const Scalar t_link1_14 = t_link1_13 - 0.01993386669246 * c_joint2;
  const Scalar t_link1_15 = t_link1_14 + qd[0] * t_link2_3 - s_joint3 * M_link3_x;
  const Scalar t_link1_16 = t_link1_15 - t_link3_43 * t_link1_11;
  const Scalar t_link1_17 = t_link1_16 + t_link6_79 * t_link1_12 - c_joint3 * M_link3_y;
  const Scalar t_link1_18 = t_link1_17 - t_link4_61 * t_link1_7;
  const Scalar t_link1_19 = t_link1_18 + t_link6_73 * t_link1_2;
  const Scalar t_link1_20 = t_link1_19 - t_link1_1 * t_link7_35;
  const Scalar t_link2_15 = qd[1] * qd[1];
  const Scalar t_link1_21 = 0.0007689361029464 * t_link2_15 - c_joint3 * M_link3_x;
  const Scalar t_link1_22 = tau[0] - qd[1] * t_link2_3 * 2.0 - t_link2_6 * t_link1_20;
  const Scalar t_link1_23 = t_link1_22 - s_joint2 * (t_link1_21 + s_joint3 * M_link3_y);
  const Scalar t_link1_24 = t_link1_23 + t_link1_1 * t_link7_40;
  const Scalar t_link1_25 = t_link1_24 - t_link4_74 * t_link1_7;
  const Scalar t_link1_26 = c_joint2 * (t_link4_83 + 0.01026110182100817 * t_link2_15);
  const Scalar t_link1_27 = t_link1_25 + t_link3_44 * t_link1_11 + t_link1_26;
  const Scalar t_link1_28 = t_link1_27 + t_link5_63 * t_link1_4;
  const Scalar t_link1_29 = inverse_pivot_link1 * (t_link1_28 - t_link6_75 * t_link1_2);
  qdd[0] = t_link1_29;
  const Scalar t_link1_30 = t_link2_5 * (t_link1_20 + t_link3_45 * t_link1_29);
  qdd[1] = -t_link1_30;
  const Scalar t_link1_31 = t_link1_11 + t_link4_62 * t_link1_30;
  const Scalar t_link1_32 = inverse_pivot_link3 * (t_link1_31 + t_link4_60 * t_link1_29);
  qdd[2] = t_link1_32;
  const Scalar t_link1_33 = t_link1_7 + t_link5_61 * t_link1_32;
  const Scalar t_link1_34 = t_link1_33 + t_link5_60 * t_link1_30;
  const Scalar t_link1_35 = inverse_pivot_link4 * (t_link1_34 - t_link5_57 * t_link1_29);
  qdd[3] = t_link1_35;
  const Scalar t_link1_36 = t_link1_12 + t_link5_55 * t_link1_32;
  const Scalar t_link1_37 = t_link1_36 - t_link5_56 * t_link1_35;
  const Scalar t_link1_38 = t_link1_37 - t_link5_54 * t_link1_30;
  const Scalar t_link1_39 = t_link1_38 + t_link5_63 * t_link1_29;
  qdd[4] = t_link1_39;
  const Scalar t_link1_40 = t_link1_2 - t_link7_42 * t_link1_30;
  const Scalar t_link1_41 = t_link1_40 - t_link7_39 * t_link1_29;
  const Scalar t_link1_42 = inverse_pivot_link6 * (t_link1_41 + t_link7_43 * t_link1_32);
  const Scalar t_link1_43 = t_link6_81 * t_link1_35 - t_link6_76 * t_link1_39;
  const Scalar t_link1_44 = t_link1_43 - t_link1_42;
  qdd[5] = t_link1_44;
  const Scalar t_link1_45 = t_link1_1 + t_link3_33 * t_link1_30;
  const Scalar t_link1_46 = t_link1_45 - t_link6_70 * t_link1_39;
  const Scalar t_link1_47 = t_link1_46 + t_link3_32 * t_link1_29;
  const Scalar t_link1_48 = t_link1_47 - t_link5_44 * t_link1_35;
  const Scalar t_link1_49 = t_link1_48 + t_link4_39 * t_link1_32;
  qdd[6] = -203.68042513969144 * (t_link1_49 + I_link7_yz * t_link1_44);
}

void point_positions(const Scalar q[7], Scalar p[3]) noexcept {
  const auto [s_joint1, c_joint1] = sine_cosine(q[0]);
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const auto [s_joint3, c_joint3] = sine_cosine(q[2]);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const auto [s_joint6, c_joint6] = sine_cosine(q[5]);
  const Scalar t_link6_1 = 0.088 * c_joint6 + 0.107 * s_joint6;
  const Scalar t_link5_1 = s_joint5 * t_link6_1;
  const Scalar t_link5_2 = 0.0825 - c_joint5 * t_link6_1;
  const Scalar t_link6_2 = 0.384 + 0.088 * s_joint6;
  const Scalar t_link6_3 = t_link6_2 - 0.107 * c_joint6;
  const Scalar t_link4_1 = 0.0825 - c_joint4 * t_link5_2 - s_joint4 * t_link6_3;
  const Scalar t_link3_1 = c_joint3 * t_link5_1 + s_joint3 * t_link4_1;
  const Scalar t_link3_2 = s_joint3 * t_link5_1 - c_joint3 * t_link4_1;
  const Scalar t_link4_2 = 0.316 - s_joint4 * t_link5_2 + c_joint4 * t_link6_3;
  const Scalar t_link2_1 = s_joint2 * t_link4_2 - c_joint2 * t_link3_2;
  // link1
  p[0] = c_joint1 * t_link2_1 - s_joint1 * t_link3_1;
  p[1] = c_joint1 * t_link3_1 + s_joint1 * t_link2_1;
  p[2] = 0.333 + s_joint2 * t_link3_2 + c_joint2 * t_link4_2;
}

void force_jacobian_transpose(const Scalar q[7], Scalar C[21]) noexcept {
  const auto [s_joint1, c_joint1] = sine_cosine(q[0]);
  const auto [s_joint2, c_joint2] = sine_cosine(q[1]);
  const auto [s_joint3, c_joint3] = sine_cosine(q[2]);
  const auto [s_joint4, c_joint4] = sine_cosine(q[3]);
  const auto [s_joint5, c_joint5] = sine_cosine(q[4]);
  const auto [s_joint6, c_joint6] = sine_cosine(q[5]);
  // link6
  const Scalar r_link6_x = 0.088 * c_joint6 + 0.107 * s_joint6;
  const Scalar t_link6_1 = c_joint5 * r_link6_x;
  const Scalar r_link6_y = 0.088 * s_joint6 - 0.107 * c_joint6;
  const Scalar r_link5_z = 0.384 + r_link6_y;
  const Scalar r_link4_x = 0.0825 - t_link6_1;
  const Scalar t_link4_1 = s_joint4 * r_link5_z + c_joint4 * r_link4_x;
  // link3
  const Scalar r_link3_y = s_joint5 * r_link6_x;
  const Scalar t_link3_1 = s_joint3 * r_link3_y;
  const Scalar r_link3_x = 0.0825 - t_link4_1;
  const Scalar t_link3_2 = t_link3_1 - c_joint3 * r_link3_x;
  const Scalar t_link4_2 = c_joint4 * r_link5_z - s_joint4 * r_link4_x;
  const Scalar r_link3_z = 0.316 + t_link4_2;
  const Scalar r_link2_x = c_joint2 * t_link3_2 - s_joint2 * r_link3_z;
  C[5] = r_link2_x;
  const Scalar t_link3_3 = c_joint3 * r_link3_y;
  // link2
  const Scalar r_link2_z = t_link3_3 + s_joint3 * r_link3_x;
  const Scalar t_link2_1 = s_joint1 * r_link2_z;
  C[1] = -(t_link2_1 + c_joint1 * r_link2_x);
  const Scalar t_link2_2 = c_joint1 * r_link2_z;
  C[0] = s_joint1 * r_link2_x - t_link2_2;
  const Scalar r_link2_y = s_joint2 * t_link3_2 + c_joint2 * r_link3_z;
  // link1
  C[3] = c_joint1 * r_link2_y;
  C[4] = s_joint1 * r_link2_y;
  C[7] = -(c_joint2 * t_link2_1 + c_joint1 * t_link3_2);
  C[6] = s_joint1 * t_link3_2 - c_joint2 * t_link2_2;
  const Scalar t_link1_1 = c_joint5 * r_link6_y;
  const Scalar t_link1_2 = s_joint5 * r_link6_y;
  const Scalar t_link1_3 = s_joint4 * r_link6_x;
  const Scalar t_link1_4 = t_link1_3 + c_joint4 * t_link1_1;
  const Scalar t_link1_5 = c_joint3 * t_link1_2 + s_joint3 * t_link1_4;
  const Scalar t_link1_6 = s_joint3 * t_link1_2 - c_joint3 * t_link1_4;
  const Scalar t_link1_7 = s_joint4 * t_link1_1 - c_joint4 * r_link6_x;
  const Scalar t_link1_8 = c_joint2 * t_link1_6 - s_joint2 * t_link1_7;
  C[15] = s_joint1 * t_link1_5 + c_joint1 * t_link1_8;
  const Scalar t_link1_9 = c_joint3 * t_link4_2;
  const Scalar t_link1_10 = s_joint3 * t_link4_2;
  const Scalar t_link1_11 = c_joint2 * t_link1_9 + s_joint2 * t_link4_1;
  C[9] = s_joint1 * t_link1_10 - c_joint1 * t_link1_11;
  C[10] = -(c_joint1 * t_link1_10 + s_joint1 * t_link1_11);
  C[16] = s_joint1 * t_link1_8 - c_joint1 * t_link1_5;
  C[8] = s_joint2 * r_link2_z;
  const Scalar t_link1_12 = s_joint5 * t_link1_3;
  const Scalar t_link1_13 = c_joint4 * t_link3_3 + s_joint3 * t_link6_1;
  const Scalar t_link1_14 = s_joint2 * t_link1_12 + c_joint2 * t_link1_13;
  const Scalar t_link1_15 = c_joint4 * t_link3_1 - c_joint3 * t_link6_1;
  C[13] = -(s_joint1 * t_link1_14 + c_joint1 * t_link1_15);
  C[12] = s_joint1 * t_link1_15 - c_joint1 * t_link1_14;
  C[17] = -(s_joint2 * t_link1_6 + c_joint2 * t_link1_7);
  C[11] = s_joint2 * t_link1_9 - c_joint2 * t_link4_1;
  C[14] = s_joint2 * t_link1_13 - c_joint2 * t_link1_12;
  C[2] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
}

}  // namespace panda
