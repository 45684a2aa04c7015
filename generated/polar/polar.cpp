// polar.cpp: see polar.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate polar.yaml

#include "polar.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace polar {

static_assert(kDigest == 0xc09d068eece18e5aULL, "header and source are of different runs");

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

void mass_matrix(const Scalar q[2], Scalar A[4]) noexcept {
  const Scalar t_boom_1 = q[1] * (5.47995 - 4.25 * q[1]);
  // shoulder_link
  A[0] = 2.528 - t_boom_1;
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
  const auto [s_shoulder, c_shoulder] = sine_cosine(q[0]);
  G[1] = 41.6925 * c_shoulder;
  // shoulder_link
  G[0] = s_shoulder * (26.87915475 - 41.6925 * q[1]);
}

void inverse_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar qdd[2],
                      Scalar tau[2]) noexcept {
  const auto [s_shoulder, c_shoulder] = sine_cosine(q[0]);
  // boom
  const Scalar t_boom_1 = 4.25 * q[1];
  const Scalar t_boom_2 = 2.739975 - t_boom_1;
  const Scalar t_boom_3 = 41.6925 * c_shoulder + 4.25 * qdd[1];
  tau[1] = t_boom_3 + qd[0] * qd[0] * t_boom_2;
  // shoulder_link
  const Scalar t_shoulder_1 = q[1] * (5.47995 - t_boom_1);
  const Scalar t_shoulder_2 = 9.81 * s_shoulder - qd[0] * qd[1] * 2.0;
  tau[0] = qdd[0] * (2.528 - t_shoulder_1) + t_boom_2 * t_shoulder_2;
}

void forward_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar tau[2],
                      Scalar qdd[2]) noexcept {
  const auto [s_shoulder, c_shoulder] = sine_cosine(q[0]);
  const Scalar t_boom_1 = q[1] * (5.47995 - 4.25 * q[1]);
  const Scalar inverse_pivot_shoulder = 1.0 / (2.528 - t_boom_1);
  const Scalar t_boom_2 = 0.6447 - q[1];
  const Scalar t_boom_3 = qd[0] * t_boom_2;
  // shoulder_link
  const Scalar t_shoulder_1 = tau[0] - s_shoulder * t_boom_2 * 41.6925;
  const Scalar t_shoulder_2 = t_shoulder_1 + qd[1] * t_boom_3 * 8.5;
  qdd[0] = inverse_pivot_shoulder * t_shoulder_2;
  // boom
  const Scalar t_boom_4 = 9.81 * c_shoulder - 0.23529411764705882 * tau[1];
  qdd[1] = -(t_boom_4 + qd[0] * t_boom_3);
}

void point_positions(const Scalar q[2], Scalar p[3]) noexcept {
  // shoulder_link
  const auto [s_shoulder, c_shoulder] = sine_cosine(q[0]);
  p[0] = s_shoulder * q[1];
  p[2] = c_shoulder * q[1];
  p[1] = 0.154;
}

void force_jacobian_transpose(const Scalar q[2], Scalar C[6]) noexcept {
  const auto [s_shoulder, c_shoulder] = sine_cosine(q[0]);
  C[5] = c_shoulder;
  C[3] = s_shoulder;
  // shoulder_link
  C[2] = -s_shoulder * q[1];
  C[0] = c_shoulder * q[1];
  C[1] = 0.0;
  C[4] = 0.0;
}

}  // namespace polar
