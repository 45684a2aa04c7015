// two_link.cpp: see two_link.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate two_link.yaml

#include "two_link.hpp"

namespace two_link {

static_assert(kDigest == 0x8515c25e456eb37bULL, "header and source are of different runs");
static_assert(sizeof(1.0) == sizeof(double), "not for -fsingle-precision-constant");
// g++ would gather scalars into vectors, which makes nothing faster and some functions slower.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

#if defined(__SIZEOF_DOUBLE__) && __SIZEOF_DOUBLE__ != 8
#error "sine_cosine takes a double of 64 bits: --scalar float is for this compiler"
#endif
// Orders of sums other than those that are written would cancel the rounding, and so would numbers
// that are wider in registers than in memory (methods 0 and 16: none is, 1: float is).
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__i386__) && !defined(__SSE2__))
#error "sine_cosine rounds by adding and subtracting: not for -ffast-math or x87; --sincos libm is"
#elif defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ & ~17) != 0
#error "sine_cosine rounds by adding and subtracting: not for -ffast-math or x87; --sincos libm is"
#elif defined(__clang__) && __clang_major__ > 12
#pragma clang fp reassociate(off)
#elif defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-associative-math")
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
template <class Angle>
[[gnu::always_inline]] inline SineCosine<Angle> pair_of(Angle x) noexcept {
  const Angle k = (x * 0.6366197723675814 + 6755399441055744.0) - 6755399441055744.0;
  const Angle t = k * 2.1430172143725346e+301;  // infinite beyond the range
  const Angle r_1 = x - t * 7.32983532344312e-302;
  const Angle r = r_1 + k * 8.705515695504166e-10;
  const Angle z = r * r;
  const Angle s_1 = 1.58969099521155e-10 * z - 2.5050760253406863e-08;
  const Angle s_2 = s_1 * z + 2.7557313707070068e-06;
  const Angle s_3 = s_2 * z - 0.0001984126982985795;
  const Angle s_4 = s_3 * z + 0.00833333333332249;
  const Angle s_5 = s_4 * z - 0.16666666666666632;
  const Angle c_1 = -1.1359647557788195e-11 * z + 2.087572321298175e-09;
  const Angle c_2 = c_1 * z - 2.7557314351390663e-07;
  const Angle c_3 = c_2 * z + 2.480158728947673e-05;
  const Angle c_4 = c_3 * z - 0.001388888888887411;
  const Angle c_5 = c_4 * z + 0.0416666666666666;
  const Angle sine = r + r * z * s_5;
  const Angle cosine = 1.0 - z * (0.5 - z * c_5);

  // k modulo 4: -2 to 2, not a number where t is infinite
  const Angle l = t * 4.6663180925160944e-302;
  const Angle m = l - ((l + 2.7021597764222976e+16) - 2.7021597764222976e+16);
  const Angle n = 4.0 - m * m;
  // sine and cosine of m pi/2: 0, 1 or -1
  const Angle s = m * (n * 0.3333333333333333);
  const Angle c = 0.5 * (n - s * s) - 1.0;
  return {c * sine + s * cosine, c * cosine - s * sine};
}

[[gnu::noinline, gnu::unused]] SineCosine<double> sine_cosine(double x) noexcept {
  return pair_of(x);
}

/// For other types that stand for Scalar, such as one that counts operations: their own functions.
template <class Number>
SineCosine<Number> sine_cosine(const Number& x) noexcept {
  return {sin(x), cos(x)};
}

inline double sin(double x) noexcept { return sine_cosine(x).sine; }
inline double cos(double x) noexcept { return sine_cosine(x).cosine; }
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
// As many angles as a register holds.
#if defined(__AVX__)
using Angles [[gnu::vector_size(32)]] = double;
#else
using Angles [[gnu::vector_size(16)]] = double;
#endif
constexpr unsigned kAngles = sizeof(Angles) / sizeof(double);

/// The pairs of a vector of angles, which come one by one: a load would wait for all to be stored,
/// and of a vector that crosses a call g++ leaves the upper halves of registers in use, with which
/// code for SSE is slow.
template <class... Angle>
[[gnu::noinline]] void store_sines_cosines(double* sines, double* cosines, Angle... x) noexcept {
  const SineCosine<Angles> pairs = pair_of(Angles{x...});
  __builtin_memcpy(sines, &pairs.sine, sizeof(Angles));
  __builtin_memcpy(cosines, &pairs.cosine, sizeof(Angles));
}

/// Those of the numbers from x on.
[[gnu::always_inline]] inline void store(const double* x, double* sines, double* cosines) noexcept {
#if defined(__AVX__)
  store_sines_cosines(sines, cosines, x[0], x[1], x[2], x[3]);
#else
  store_sines_cosines(sines, cosines, x[0], x[1]);
#endif
}

/// Sines and cosines of 4 angles or fewer, as many at once as the processor can; writes whole
/// vectors.
template <class... Angle>
[[gnu::always_inline]] inline void sines_cosines(double* sines, double* cosines, double first,
                                                 Angle... more) noexcept {
  const double x[] = {first, more..., first, first, first};
  store(x, sines, cosines);
  sizeof...(more) >= kAngles ? store(x + kAngles, sines + kAngles, cosines + kAngles) : void();
}
#endif

/// One by one: on processors without vectors, and of other types that stand for Scalar.
template <class Number, class... Angle>
[[gnu::always_inline]] inline void sines_cosines(Number* sines, Number* cosines,
                                                 const Angle&... angle) noexcept {
  SineCosine<Number> pair;
  const int done[] = {
      (pair = sine_cosine(Number(angle)), *sines++ = pair.sine, *cosines++ = pair.cosine, 0)...};
  static_cast<void>(done);
}

}  // namespace

namespace {

// The numbers that functions take from the model, under the first link whose inertia is in them;
// above each the numbers of the model that it is made of, but for those that are exactly 0 or 1,
// behind its unit, which a length or mass of exactly 1 hides. Other literals are numbers of the
// equations.

// gravity
constexpr double base_p1 = -9.81;

// mass, com x, inertia yy zz of upper_arm, forearm
constexpr double upper_arm_p1 = 95.0;
// gravity; mass, com x of upper_arm; mass of forearm
constexpr double upper_arm_p2 = -735.75;
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
constexpr double forearm_p4 = -245.25;
// mass, com x, inertia yy zz of forearm
constexpr double forearm_p5 = 0.044444444444444446;
// mass, com x, inertia yy zz of forearm
constexpr double forearm_p6 = 1.1111111111111112;
// mass, com x, inertia yy zz of forearm
constexpr double forearm_p7 = 27.77777777777778;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

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
  const Scalar s_elbow = sin(q[1]);
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar t_forearm_1 = forearm_p2 * s_elbow;
  const Scalar M_forearm_z = qd[0] * qd[0] * t_forearm_1;
  B[1] = M_forearm_z;
  // upper_arm: moment M of (3)
  B[0] = M_forearm_z - omega_forearm_z * omega_forearm_z * t_forearm_1;
}

void gravity_force(const Scalar q[2], Scalar G[2]) noexcept {
  // forearm: G of 6.5
  const Scalar q_shoulder_elbow = q[0] + q[1];
  const Scalar c_shoulder = cos(q[0]);
  const Scalar c_shoulder_elbow = cos(q_shoulder_elbow);
  const Scalar neg_G_1 = forearm_p4 * c_shoulder_elbow;
  G[1] = -neg_G_1;
  // upper_arm: G of 6.5
  G[0] = -(neg_G_1 + upper_arm_p2 * c_shoulder);
}

void inverse_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar qdd[2],
                      Scalar tau[2]) noexcept {
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[0], q[1]);
  const Scalar s_shoulder = sines[0];
  const Scalar c_shoulder = cosines[0];
  const Scalar s_elbow = sines[1];
  const Scalar c_elbow = cosines[1];
  // forearm: angular velocity omega, angular acceleration alpha, acceleration a of (1)
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar alpha_forearm_z = qdd[0] + qdd[1];
  const Scalar a_forearm_y_1 = s_elbow * (base_p1 * s_shoulder + qd[0] * qd[0]);
  const Scalar a_forearm_y = a_forearm_y_1 + c_elbow * (qdd[0] - base_p1 * c_shoulder);
  const Scalar M_forearm_z = forearm_p2 * a_forearm_y + forearm_p1 * alpha_forearm_z;
  tau[1] = M_forearm_z;
  const Scalar M_upper_arm_z_1 = s_elbow * omega_forearm_z * omega_forearm_z;
  // upper_arm: moment M of (1)
  const Scalar M_upper_arm_z_2 = M_forearm_z - upper_arm_p2 * c_shoulder + upper_arm_p3 * qdd[0];
  tau[0] = M_upper_arm_z_2 - forearm_p2 * (M_upper_arm_z_1 - c_elbow * alpha_forearm_z);
}

void forward_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar tau[2],
                      Scalar qdd[2]) noexcept {
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[0], q[1]);
  const Scalar s_shoulder = sines[0];
  const Scalar c_shoulder = cosines[0];
  const Scalar s_elbow = sines[1];
  const Scalar c_elbow = cosines[1];
  const Scalar omega_forearm_z = qd[0] + qd[1];
  const Scalar t_forearm_1 = c_elbow * c_elbow * forearm_p7;
  const Scalar inverse_pivot_upper_arm = 1.0 / (upper_arm_p3 - t_forearm_1);
  const Scalar t_forearm_2 = forearm_p2 * s_elbow;
  const Scalar t_upper_arm_1 = tau[1] - t_forearm_2 * (qd[0] * qd[0] + base_p1 * s_shoulder);
  const Scalar t_upper_arm_2 = base_p1 * c_shoulder;
  const Scalar t_forearm_3 = forearm_p6 * c_elbow;
  // upper_arm: qdd of (1)
  const Scalar neg_qdd_0_1 = tau[1] - tau[0] + t_upper_arm_1 * t_forearm_3;
  const Scalar neg_qdd_0_2 = neg_qdd_0_1 - (upper_arm_p4 - t_forearm_1) * t_upper_arm_2;
  const Scalar neg_qdd_0_3 = neg_qdd_0_2 - omega_forearm_z * omega_forearm_z * t_forearm_2;
  const Scalar neg_qdd_0 = inverse_pivot_upper_arm * neg_qdd_0_3;
  qdd[0] = -neg_qdd_0;
  // forearm: qdd of (1)
  qdd[1] = neg_qdd_0 + forearm_p5 * t_upper_arm_1 + t_forearm_3 * (t_upper_arm_2 + neg_qdd_0);
}

void point_positions(const Scalar q[2], Scalar p[3]) noexcept {
  // forearm: p of 1.2
  const Scalar q_shoulder_elbow = q[0] + q[1];
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q_shoulder_elbow, q[0]);
  const Scalar s_shoulder_elbow = sines[0];
  const Scalar c_shoulder_elbow = cosines[0];
  const Scalar s_shoulder = sines[1];
  const Scalar c_shoulder = cosines[1];
  p[0] = c_shoulder_elbow + c_shoulder;
  p[2] = s_shoulder_elbow + s_shoulder;
  p[1] = 0.0;
}

void force_jacobian_transpose(const Scalar q[2], Scalar C[6]) noexcept {
  const Scalar q_shoulder_elbow = q[0] + q[1];
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[0], q_shoulder_elbow);
  const Scalar s_shoulder = sines[0];
  const Scalar c_shoulder = cosines[0];
  const Scalar s_shoulder_elbow = sines[1];
  const Scalar c_shoulder_elbow = cosines[1];
  C[5] = c_shoulder_elbow;
  C[3] = -s_shoulder_elbow;
  C[2] = c_shoulder + c_shoulder_elbow;
  // forearm: r of (9)
  C[0] = -(s_shoulder + s_shoulder_elbow);
  C[1] = 0.0;
  C[4] = 0.0;
}

}  // namespace two_link
