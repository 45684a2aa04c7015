// two_link.cpp: see two_link.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate two_link.yaml

#include "two_link.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace two_link {

static_assert(kDigest == 0x6238398664f77ed0ULL, "header and source are of different runs");

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
inline double cos(double x) noexcept { return sine_cosine(x).cosine; }

}  // namespace

namespace {

// The numbers that functions take from the model, under the first link whose inertia is in them;
// above each its unit and the numbers of the model that it is made of, but for those that are
// exactly 0 or 1. Other literals are numbers of the equations.

// gravity
constexpr double base_p1 = 9.81;

// mass, com x, inertia yy zz of upper_arm, forearm
constexpr double upper_arm_p1 = 95.0;
// gravity; mass, com x of upper_arm; mass of forearm
constexpr double upper_arm_p2 = 735.75;
// mass, com x, inertia yy zz of upper_arm; mass of forearm
constexpr double upper_arm_p3 = 72.5;
// mass, com x of upper_arm; mass of forearm
constexpr double upper_arm_p4 = 75.0;

// mass, com x, inertia yy zz of forearm
constexpr double forearm_p1 = 22.5;
// mass, com x of forearm
constexpr double forearm_p2 = 25.0;
// mass, com x of forearm
constexpr double forearm_p3 = 50.0;
// gravity; mass, com x of forearm
constexpr double forearm_p4 = 245.25;
// mass, com x, inertia yy zz of forearm
constexpr double forearm_p5 = 0.044444444444444446;
// mass, com x, inertia yy zz of forearm
constexpr double forearm_p6 = 1.1111111111111112;
// mass, com x, inertia yy zz of forearm
constexpr double forearm_p7 = 27.77777777777778;

}  // namespace

void mass_matrix(const Scalar q[2], Scalar A[4]) noexcept {
  const Scalar c_elbow = cos(q[1]);
  A[0] = upper_arm_p1 + forearm_p3 * c_elbow;
  // forearm: A of (2)
  A[1] = forearm_p1 + forearm_p2 * c_elbow;
  A[2] = A[1];
  A[3] = forearm_p1;
}

void bias_force(const Scalar q[2], const Scalar qd[2], Scalar B[2]) noexcept {
  // forearm: angular velocity omega, moment M of (3)
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar s_elbow = sin(q[1]);
  const Scalar t_forearm_1 = forearm_p2 * s_elbow;
  const Scalar M_forearm_z = qd[0] * qd[0] * t_forearm_1;
  B[1] = M_forearm_z;
  // upper_arm: moment M of (3)
  B[0] = M_forearm_z - omega_forearm_z * omega_forearm_z * t_forearm_1;
}

void gravity_force(const Scalar q[2], Scalar G[2]) noexcept {
  // forearm: G of 6.5
  const Scalar c_shoulder = cos(q[0]);
  const Scalar q_shoulder_elbow = q[0] + q[1];
  const Scalar c_shoulder_elbow = cos(q_shoulder_elbow);
  const Scalar G_1 = forearm_p4 * c_shoulder_elbow;
  G[1] = G_1;
  // upper_arm: G of 6.5
  G[0] = G_1 + upper_arm_p2 * c_shoulder;
}

void inverse_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar qdd[2],
                      Scalar tau[2]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  // forearm: angular velocity omega, angular acceleration alpha, acceleration a of (1)
  const auto p_s_elbow = sine_cosine(q[1]);
  const Scalar& s_elbow = p_s_elbow.sine;
  const Scalar& c_elbow = p_s_elbow.cosine;
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar alpha_forearm_z = qdd[0] + qdd[1];
  const Scalar a_forearm_y_1 = s_elbow * (base_p1 * s_shoulder - qd[0] * qd[0]);
  const Scalar a_forearm_y = c_elbow * (qdd[0] + base_p1 * c_shoulder) - a_forearm_y_1;
  const Scalar M_forearm_z = forearm_p1 * alpha_forearm_z + forearm_p2 * a_forearm_y;
  tau[1] = M_forearm_z;
  const Scalar M_upper_arm_z_1 = s_elbow * omega_forearm_z * omega_forearm_z;
  // upper_arm: moment M of (1)
  const Scalar M_upper_arm_z_2 = M_forearm_z + upper_arm_p2 * c_shoulder + upper_arm_p3 * qdd[0];
  tau[0] = M_upper_arm_z_2 + forearm_p2 * (c_elbow * alpha_forearm_z - M_upper_arm_z_1);
}

void forward_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar tau[2],
                      Scalar qdd[2]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  // forearm: angular velocity omega, qdd of (1)
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const auto p_s_elbow = sine_cosine(q[1]);
  const Scalar& s_elbow = p_s_elbow.sine;
  const Scalar& c_elbow = p_s_elbow.cosine;
  const Scalar t_forearm_1 = c_elbow * c_elbow * forearm_p7;
  const Scalar inverse_pivot_upper_arm = 1.0 / (upper_arm_p3 - t_forearm_1);
  const Scalar t_upper_arm_1 = base_p1 * c_shoulder;
  const Scalar t_forearm_2 = forearm_p2 * s_elbow;
  const Scalar t_forearm_3 = forearm_p6 * c_elbow;
  const Scalar t_upper_arm_2 = tau[1] - t_forearm_2 * (qd[0] * qd[0] - base_p1 * s_shoulder);
  const Scalar neg_qdd_0_1 = tau[1] - tau[0] + (upper_arm_p4 - t_forearm_1) * t_upper_arm_1;
  const Scalar neg_qdd_0_2 = omega_forearm_z * omega_forearm_z * t_forearm_2;
  const Scalar neg_qdd_0_3 = neg_qdd_0_1 + t_forearm_3 * t_upper_arm_2 - neg_qdd_0_2;
  const Scalar neg_qdd_0 = inverse_pivot_upper_arm * neg_qdd_0_3;
  qdd[0] = -neg_qdd_0;
  qdd[1] = neg_qdd_0 + forearm_p5 * t_upper_arm_2 - t_forearm_3 * (t_upper_arm_1 - neg_qdd_0);
}

void point_positions(const Scalar q[2], Scalar p[3]) noexcept {
  // forearm: p of 1.2
  const Scalar q_shoulder_elbow = q[0] + q[1];
  const auto p_s_shoulder_elbow = sine_cosine(q_shoulder_elbow);
  const Scalar& s_shoulder_elbow = p_s_shoulder_elbow.sine;
  const Scalar& c_shoulder_elbow = p_s_shoulder_elbow.cosine;
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  p[0] = c_shoulder_elbow + c_shoulder;
  p[2] = s_shoulder_elbow + s_shoulder;
  p[1] = 0.0;
}

void force_jacobian_transpose(const Scalar q[2], Scalar C[6]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  const Scalar q_shoulder_elbow = q[0] + q[1];
  const auto p_s_shoulder_elbow = sine_cosine(q_shoulder_elbow);
  const Scalar& s_shoulder_elbow = p_s_shoulder_elbow.sine;
  const Scalar& c_shoulder_elbow = p_s_shoulder_elbow.cosine;
  C[5] = c_shoulder_elbow;
  C[3] = -s_shoulder_elbow;
  C[2] = c_shoulder + c_shoulder_elbow;
  // forearm: r of (9)
  C[0] = -(s_shoulder + s_shoulder_elbow);
  C[1] = 0.0;
  C[4] = 0.0;
}

}  // namespace two_link
