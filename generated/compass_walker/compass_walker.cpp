// compass_walker.cpp: see compass_walker.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate compass_walker.yaml

#include "compass_walker.hpp"

namespace compass_walker {

static_assert(kDigest == 0x1b42bfdf664f2333ULL, "header and source are of different runs");
static_assert(sizeof(1.0) == sizeof(double), "not for -fsingle-precision-constant");
// Zeros, where compilers may store neighbours at once.
namespace {

[[gnu::noinline]] void force_jacobian_transpose_0(Scalar C[24]) noexcept {
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

}  // namespace

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

// mass of hip, left_leg, right_leg
constexpr double hip_p1 = 20.0;
// gravity; mass of hip, left_leg, right_leg
constexpr double hip_p2 = -196.2;
// mass of hip
constexpr double hip_p3 = 10.0;

// mass, com z of left_leg, right_leg
constexpr double left_leg_p1 = -2.5;
// mass, com z of left_leg, right_leg
constexpr double left_leg_p2 = 1.25;
// gravity; mass, com z of left_leg, right_leg
constexpr double left_leg_p3 = 24.525;
// mass, com z of left_leg, right_leg
constexpr double left_leg_p4 = 0.8;
// mass of left_leg, right_leg
constexpr double left_leg_p5 = 5.0;
// com z of left_leg, right_leg
constexpr double left_leg_p6 = -2.0;
// gravity; com z of left_leg, right_leg
constexpr double left_leg_p7 = 19.62;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

void mass_matrix(const Scalar q[4], Scalar A[16]) noexcept {
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[2], q[3]);
  const Scalar s_left_hip = sines[0];
  const Scalar c_left_hip = cosines[0];
  const Scalar s_right_hip = sines[1];
  const Scalar c_right_hip = cosines[1];
  A[3] = left_leg_p1 * c_right_hip;
  A[12] = A[3];
  A[7] = -left_leg_p1 * s_right_hip;
  A[13] = A[7];
  // left_leg: A of (2)
  A[6] = -left_leg_p1 * s_left_hip;
  A[9] = A[6];
  A[2] = left_leg_p1 * c_left_hip;
  A[8] = A[2];
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
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[2], q[3]);
  const Scalar s_left_hip = sines[0];
  const Scalar c_left_hip = cosines[0];
  const Scalar s_right_hip = sines[1];
  const Scalar c_right_hip = cosines[1];
  const Scalar neg_Omega_right_leg_xx = qd[3] * qd[3];
  const Scalar neg_Omega_left_leg_xx = qd[2] * qd[2];
  const Scalar neg_F_hip_z_1 = c_right_hip * neg_Omega_right_leg_xx;
  B[1] = -left_leg_p1 * (neg_F_hip_z_1 + c_left_hip * neg_Omega_left_leg_xx);
  const Scalar neg_F_hip_x_1 = s_right_hip * neg_Omega_right_leg_xx;
  // hip: force F of (3)
  B[0] = -left_leg_p1 * (neg_F_hip_x_1 + s_left_hip * neg_Omega_left_leg_xx);
  B[2] = 0.0;
  B[3] = 0.0;
}

void gravity_force(const Scalar q[4], Scalar G[4]) noexcept {
  const Scalar s_left_hip = sin(q[2]);
  const Scalar s_right_hip = sin(q[3]);
  G[3] = left_leg_p3 * s_right_hip;
  // left_leg: G of 6.5
  G[2] = left_leg_p3 * s_left_hip;
  G[1] = -hip_p2;
  G[0] = 0.0;
}

void inverse_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar qdd[4],
                      Scalar tau[4]) noexcept {
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[2], q[3]);
  const Scalar s_left_hip = sines[0];
  const Scalar c_left_hip = cosines[0];
  const Scalar s_right_hip = sines[1];
  const Scalar c_right_hip = cosines[1];
  const Scalar neg_a_hip_z = base_p1 - qdd[1];
  // left_leg: moment M, Omega of (1)
  const Scalar t_left_leg_1 = left_leg_p1 * c_left_hip;
  const Scalar t_left_leg_2 = left_leg_p1 * s_left_hip;
  tau[2] = qdd[0] * t_left_leg_1 + neg_a_hip_z * t_left_leg_2 + left_leg_p2 * qdd[2];
  const Scalar neg_Omega_left_leg_xx = qd[2] * qd[2];
  // right_leg: moment M, Omega of (1)
  const Scalar t_right_leg_1 = left_leg_p1 * c_right_hip;
  const Scalar t_right_leg_2 = left_leg_p1 * s_right_hip;
  tau[3] = qdd[0] * t_right_leg_1 + neg_a_hip_z * t_right_leg_2 + left_leg_p2 * qdd[3];
  const Scalar neg_Omega_right_leg_xx = qd[3] * qd[3];
  // hip: force F of (1)
  const Scalar F_hip_x_1 = hip_p1 * qdd[0] - t_left_leg_2 * neg_Omega_left_leg_xx;
  const Scalar F_hip_x_2 = F_hip_x_1 + qdd[2] * t_left_leg_1;
  tau[0] = F_hip_x_2 - t_right_leg_2 * neg_Omega_right_leg_xx + qdd[3] * t_right_leg_1;
  const Scalar neg_F_hip_z_1 = hip_p1 * neg_a_hip_z + qdd[2] * t_left_leg_2;
  const Scalar neg_F_hip_z_2 = neg_F_hip_z_1 + t_left_leg_1 * neg_Omega_left_leg_xx;
  tau[1] = -(neg_F_hip_z_2 + qdd[3] * t_right_leg_2 + t_right_leg_1 * neg_Omega_right_leg_xx);
}

void forward_dynamics(const Scalar q[4], const Scalar qd[4], const Scalar tau[4],
                      Scalar qdd[4]) noexcept {
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[2], q[3]);
  const Scalar s_left_hip = sines[0];
  const Scalar c_left_hip = cosines[0];
  const Scalar s_right_hip = sines[1];
  const Scalar c_right_hip = cosines[1];
  const Scalar t_right_leg_1 = left_leg_p5 * c_right_hip;
  // left_leg
  const Scalar t_left_leg_1 = left_leg_p5 * c_left_hip;
  const Scalar t_left_leg_2 = c_right_hip * t_right_leg_1 + c_left_hip * t_left_leg_1;
  const Scalar t_left_leg_3 = hip_p3 + t_left_leg_2;
  const Scalar inverse_pivot_hip = 1.0 / t_left_leg_3;
  const Scalar t_left_leg_4 = s_right_hip * t_right_leg_1 + s_left_hip * t_left_leg_1;
  const Scalar t_hip_1 = inverse_pivot_hip * t_left_leg_4;
  const Scalar inverse_pivot_slide = 1.0 / (hip_p1 - t_left_leg_2 - t_left_leg_4 * t_hip_1);
  const Scalar t_right_leg_2 = qd[3] * qd[3];
  const Scalar t_left_leg_5 = qd[2] * qd[2];
  // hip: joint force u of (1)
  const Scalar u_hip_1 = c_right_hip * t_right_leg_2 + c_left_hip * t_left_leg_5;
  const Scalar u_hip_2 = tau[1] + left_leg_p1 * u_hip_1;
  const Scalar u_hip = u_hip_2 + left_leg_p6 * (s_right_hip * tau[3] + s_left_hip * tau[2]);
  // slide: joint force u, qdd of (1)
  const Scalar u_slide_1 = tau[0] - t_hip_1 * u_hip;
  const Scalar u_slide_2 = s_right_hip * t_right_leg_2 + s_left_hip * t_left_leg_5;
  const Scalar u_slide_3 = u_slide_1 - left_leg_p6 * (c_right_hip * tau[3] + c_left_hip * tau[2]);
  const Scalar u_slide = u_slide_3 + left_leg_p1 * u_slide_2;
  const Scalar qdd_0 = inverse_pivot_slide * u_slide;
  qdd[0] = qdd_0;
  const Scalar qdd_1_1 = u_hip + base_p1 * t_left_leg_3 - t_left_leg_4 * qdd_0;
  const Scalar qdd_1 = inverse_pivot_hip * qdd_1_1;
  qdd[1] = qdd_1;
  // left_leg: qdd of (1)
  const Scalar t_left_leg_6 = left_leg_p6 * qdd_0;
  const Scalar t_left_leg_7 = left_leg_p7 - left_leg_p6 * qdd_1;
  qdd[2] = left_leg_p4 * tau[2] - c_left_hip * t_left_leg_6 - s_left_hip * t_left_leg_7;
  // right_leg: qdd of (1)
  qdd[3] = left_leg_p4 * tau[3] - c_right_hip * t_left_leg_6 - s_right_hip * t_left_leg_7;
}

void point_positions(const Scalar q[4], Scalar p[6]) noexcept {
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[2], q[3]);
  const Scalar s_left_hip = sines[0];
  const Scalar c_left_hip = cosines[0];
  const Scalar s_right_hip = sines[1];
  const Scalar c_right_hip = cosines[1];
  p[2] = q[1] - c_left_hip;
  p[0] = q[0] - s_left_hip;
  p[5] = q[1] - c_right_hip;
  // slide: p of 1.2
  p[3] = q[0] - s_right_hip;
  p[1] = 0.0;
  p[4] = 0.0;
}

void force_jacobian_transpose(const Scalar q[4], Scalar C[24]) noexcept {
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[2], q[3]);
  const Scalar s_left_hip = sines[0];
  const Scalar c_left_hip = cosines[0];
  const Scalar s_right_hip = sines[1];
  const Scalar c_right_hip = cosines[1];
  C[12] = -c_left_hip;
  C[14] = s_left_hip;
  C[21] = -c_right_hip;
  C[23] = s_right_hip;
  C[0] = 1.0;
  C[3] = 1.0;
  C[8] = 1.0;
  C[11] = 1.0;
  force_jacobian_transpose_0(C);
}

}  // namespace compass_walker
