// compass_walker.cpp: see compass_walker.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate compass_walker.yaml

#include "compass_walker.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace compass_walker {

static_assert(kDigest == 0x8b5e97520dfd1b5bULL, "header and source are of different runs");

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

inline double sin(double x) noexcept { return sine_cosine(x).sine; }

}  // namespace

namespace {

// The numbers that functions take from the model, under the first link whose inertia is in them;
// above each its unit and the numbers of the model that it is made of, but for those that are
// exactly 0 or 1. Other literals are numbers of the equations.

// gravity
constexpr double base_p1 = 9.81;

// mass of hip, left_leg, right_leg
constexpr double hip_p1 = 20.0;
// gravity; mass of hip, left_leg, right_leg
constexpr double hip_p2 = 196.2;
// mass of hip; mass, com z of left_leg, right_leg
constexpr double hip_p3 = 10.0;

// mass, com z of left_leg, right_leg
constexpr double left_leg_p1 = 2.5;
// mass, com z of left_leg, right_leg
constexpr double left_leg_p2 = 1.25;
// gravity; mass, com z of left_leg, right_leg
constexpr double left_leg_p3 = 24.525;
// mass, com z of left_leg, right_leg
constexpr double left_leg_p4 = 0.8;
// mass, com z of left_leg, right_leg
constexpr double left_leg_p5 = 2.0;
// mass, com z of left_leg, right_leg
constexpr double left_leg_p6 = 5.0;
// gravity; mass, com z of left_leg, right_leg
constexpr double left_leg_p7 = 19.62;

}  // namespace

void mass_matrix(const Scalar q[4], Scalar A[16]) noexcept {
  const auto p_s_left_hip = sine_cosine(q[2]);
  const Scalar& s_left_hip = p_s_left_hip.sine;
  const Scalar& c_left_hip = p_s_left_hip.cosine;
  // right_leg: A of (2)
  const auto p_s_right_hip = sine_cosine(q[3]);
  const Scalar& s_right_hip = p_s_right_hip.sine;
  const Scalar& c_right_hip = p_s_right_hip.cosine;
  A[7] = left_leg_p1 * s_right_hip;
  A[13] = A[7];
  A[3] = -left_leg_p1 * c_right_hip;
  A[12] = A[3];
  // left_leg: A of (2)
  A[2] = -left_leg_p1 * c_left_hip;
  A[8] = A[2];
  A[6] = left_leg_p1 * s_left_hip;
  A[9] = A[6];
  A[0] = hip_p1;
  A[5] = hip_p1;
  A[10] = left_leg_p2;
  A[15] = left_leg_p2;
  A[1] = 0.0;
  A[4] = 0.0;
  A[11] = 0.0;
  A[14] = 0.0;
}

void bias_force(const Scalar q[4], const Scalar qd[4], Scalar B[4]) noexcept {
  const auto p_s_left_hip = sine_cosine(q[2]);
  const Scalar& s_left_hip = p_s_left_hip.sine;
  const Scalar& c_left_hip = p_s_left_hip.cosine;
  const auto p_s_right_hip = sine_cosine(q[3]);
  const Scalar& s_right_hip = p_s_right_hip.sine;
  const Scalar& c_right_hip = p_s_right_hip.cosine;
  const Scalar neg_Omega_right_leg_xx = qd[3] * qd[3];
  const Scalar neg_Omega_left_leg_xx = qd[2] * qd[2];
  // hip: force F of (3)
  const Scalar F_hip_z_1 = c_right_hip * neg_Omega_right_leg_xx;
  B[1] = left_leg_p1 * (F_hip_z_1 + c_left_hip * neg_Omega_left_leg_xx);
  const Scalar F_hip_x_1 = s_right_hip * neg_Omega_right_leg_xx;
  B[0] = left_leg_p1 * (F_hip_x_1 + s_left_hip * neg_Omega_left_leg_xx);
  B[2] = 0.0;
  B[3] = 0.0;
}

void gravity_force(const Scalar q[4], Scalar G[4]) noexcept {
  const Scalar s_left_hip = sin(q[2]);
  const Scalar s_right_hip = sin(q[3]);
  G[3] = left_leg_p3 * s_right_hip;
  // left_leg: G of 6.5
  G[2] = left_leg_p3 * s_left_hip;
  G[1] = hip_p2;
  G[0] = 0.0;
}

void inverse_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar qdd[4],
                      Scalar tau[4]) noexcept {
  const Scalar a_hip_z = base_p1 + qdd[1];
  // left_leg: moment M, Omega of (1)
  const auto p_s_left_hip = sine_cosine(q[2]);
  const Scalar& s_left_hip = p_s_left_hip.sine;
  const Scalar& c_left_hip = p_s_left_hip.cosine;
  const Scalar t_left_leg_1 = left_leg_p1 * c_left_hip;
  const Scalar t_left_leg_2 = left_leg_p1 * s_left_hip;
  tau[2] = left_leg_p2 * qdd[2] - (qdd[0] * t_left_leg_1 - a_hip_z * t_left_leg_2);
  const Scalar neg_Omega_left_leg_xx = qd[2] * qd[2];
  // right_leg: moment M, Omega of (1)
  const auto p_s_right_hip = sine_cosine(q[3]);
  const Scalar& s_right_hip = p_s_right_hip.sine;
  const Scalar& c_right_hip = p_s_right_hip.cosine;
  const Scalar t_right_leg_1 = left_leg_p1 * c_right_hip;
  const Scalar t_right_leg_2 = left_leg_p1 * s_right_hip;
  tau[3] = left_leg_p2 * qdd[3] - (qdd[0] * t_right_leg_1 - a_hip_z * t_right_leg_2);
  const Scalar neg_Omega_right_leg_xx = qd[3] * qd[3];
  // hip: force F of (1)
  const Scalar F_hip_z_1 = hip_p1 * a_hip_z + qdd[2] * t_left_leg_2;
  const Scalar F_hip_z_2 = F_hip_z_1 + t_left_leg_1 * neg_Omega_left_leg_xx;
  tau[1] = F_hip_z_2 + t_right_leg_1 * neg_Omega_right_leg_xx + qdd[3] * t_right_leg_2;
  const Scalar F_hip_x_1 = hip_p1 * qdd[0] + t_left_leg_2 * neg_Omega_left_leg_xx;
  const Scalar F_hip_x_2 = F_hip_x_1 - qdd[2] * t_left_leg_1 - qdd[3] * t_right_leg_1;
  tau[0] = F_hip_x_2 + t_right_leg_2 * neg_Omega_right_leg_xx;
}

void forward_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar tau[4],
                      Scalar qdd[4]) noexcept {
  const auto p_s_left_hip = sine_cosine(q[2]);
  const Scalar& s_left_hip = p_s_left_hip.sine;
  const Scalar& c_left_hip = p_s_left_hip.cosine;
  const auto p_s_right_hip = sine_cosine(q[3]);
  const Scalar& s_right_hip = p_s_right_hip.sine;
  const Scalar& c_right_hip = p_s_right_hip.cosine;
  const Scalar t_left_leg_1 = left_leg_p6 * (c_right_hip * c_right_hip + c_left_hip * c_left_hip);
  const Scalar t_left_leg_2 = hip_p3 + t_left_leg_1;
  const Scalar inverse_pivot_hip = 1.0 / t_left_leg_2;
  const Scalar t_left_leg_3 = left_leg_p6 * (c_right_hip * s_right_hip + c_left_hip * s_left_hip);
  const Scalar t_hip_1 = inverse_pivot_hip * t_left_leg_3;
  const Scalar inverse_pivot_slide = 1.0 / (hip_p1 - t_left_leg_1 - t_left_leg_3 * t_hip_1);
  const Scalar t_right_leg_1 = qd[3] * qd[3];
  const Scalar t_left_leg_4 = qd[2] * qd[2];
  // hip: joint force u of (1)
  const Scalar u_hip_1 = left_leg_p1 * (c_right_hip * t_right_leg_1 + c_left_hip * t_left_leg_4);
  const Scalar u_hip_2 = left_leg_p5 * (s_right_hip * tau[3] + s_left_hip * tau[2]);
  const Scalar u_hip = tau[1] - u_hip_1 - u_hip_2;
  // slide: joint force u, qdd of (1)
  const Scalar u_slide_1 = s_right_hip * t_right_leg_1 + s_left_hip * t_left_leg_4;
  const Scalar u_slide_2 = left_leg_p5 * (c_right_hip * tau[3] + c_left_hip * tau[2]);
  const Scalar u_slide = tau[0] - left_leg_p1 * u_slide_1 - t_hip_1 * u_hip + u_slide_2;
  const Scalar qdd_0 = inverse_pivot_slide * u_slide;
  qdd[0] = qdd_0;
  const Scalar qdd_1_1 = u_hip - t_left_leg_3 * qdd_0 - base_p1 * t_left_leg_2;
  const Scalar qdd_1 = inverse_pivot_hip * qdd_1_1;
  qdd[1] = qdd_1;
  // left_leg: qdd of (1)
  const Scalar t_left_leg_5 = left_leg_p5 * qdd_0;
  const Scalar t_left_leg_6 = left_leg_p7 + left_leg_p5 * qdd_1;
  qdd[2] = left_leg_p4 * tau[2] + c_left_hip * t_left_leg_5 - s_left_hip * t_left_leg_6;
  // right_leg: qdd of (1)
  qdd[3] = left_leg_p4 * tau[3] + c_right_hip * t_left_leg_5 - s_right_hip * t_left_leg_6;
}

void point_positions(const Scalar q[4], Scalar p[6]) noexcept {
  const auto p_s_left_hip = sine_cosine(q[2]);
  const Scalar& s_left_hip = p_s_left_hip.sine;
  const Scalar& c_left_hip = p_s_left_hip.cosine;
  const auto p_s_right_hip = sine_cosine(q[3]);
  const Scalar& s_right_hip = p_s_right_hip.sine;
  const Scalar& c_right_hip = p_s_right_hip.cosine;
  p[2] = q[1] - c_left_hip;
  p[0] = q[0] - s_left_hip;
  p[5] = q[1] - c_right_hip;
  // slide: p of 1.2
  p[3] = q[0] - s_right_hip;
  p[1] = 0.0;
  p[4] = 0.0;
}

void force_jacobian_transpose(const Scalar q[4], Scalar C[24]) noexcept {
  const auto p_s_left_hip = sine_cosine(q[2]);
  const Scalar& s_left_hip = p_s_left_hip.sine;
  const Scalar& c_left_hip = p_s_left_hip.cosine;
  C[12] = -c_left_hip;
  C[14] = s_left_hip;
  // right_leg
  const auto p_s_right_hip = sine_cosine(q[3]);
  const Scalar& s_right_hip = p_s_right_hip.sine;
  const Scalar& c_right_hip = p_s_right_hip.cosine;
  C[21] = -c_right_hip;
  C[23] = s_right_hip;
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
