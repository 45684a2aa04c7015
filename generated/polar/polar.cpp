// polar.cpp: see polar.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate polar.yaml

#include "polar.hpp"

namespace polar {

static_assert(kDigest == 0x6b14b87dcd17fcbfULL, "header and source are of different runs");
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

namespace {

// The numbers that functions take from the model, under the first link whose inertia is in them;
// above each the numbers of the model that it is made of, but for those that are exactly 0 or 1,
// behind its unit, which a length or mass of exactly 1 hides. Other literals are numbers of the
// equations.

// m/s^2: gravity
constexpr double base_g1 = -9.81;

// kg m^2: inertia yy of shoulder_link; mass, com z, inertia xx yy of boom
constexpr double shoulder_I1 = 2.528;

// kg: mass of boom
constexpr double boom_m1 = 4.25;
// kg: mass of boom
constexpr double boom_m2 = 8.5;
// m: com z of boom
constexpr double boom_l1 = -0.6447;
// m: offset y of boom
constexpr double boom_l2 = 0.154;
// kg m: mass, com z of boom
constexpr double boom_h1 = -5.47995;
// kg m: mass, com z of boom
constexpr double boom_h2 = -2.739975;
// N: gravity; mass of boom
constexpr double boom_w1 = -41.6925;
// N m: gravity; mass, com z of boom
constexpr double boom_G1 = 26.87915475;
// kg^-1: mass of boom
constexpr double boom_p1 = 0.23529411764705882;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

void mass_matrix(const Scalar q[2], Scalar A[4]) noexcept {
  // shoulder_link: A of (2)
  A[0] = shoulder_I1 + q[1] * (boom_h1 + boom_m1 * q[1]);
  A[3] = boom_m1;
  A[1] = 0.0;
  A[2] = 0.0;
}

void bias_force(const Scalar q[2], const Scalar qd[2], Scalar B[2]) noexcept {
  const Scalar t_shoulder_1 = qd[0] * (boom_h1 + boom_m2 * q[1]);
  B[1] = -qd[0] * t_shoulder_1 * 0.5;
  // shoulder_link: moment M of (3)
  B[0] = qd[1] * t_shoulder_1;
}

void gravity_force(const Scalar q[2], Scalar G[2]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  G[1] = -boom_w1 * c_shoulder;
  // shoulder_link: G of 6.5
  G[0] = s_shoulder * (boom_G1 + boom_w1 * q[1]);
}

void inverse_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar qdd[2],
                      Scalar tau[2]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  const Scalar t_shoulder_1 = boom_m1 * q[1];
  const Scalar t_shoulder_2 = boom_h2 + t_shoulder_1;
  tau[1] = -(boom_w1 * c_shoulder - boom_m1 * qdd[1] + qd[0] * qd[0] * t_shoulder_2);
  // shoulder_link: moment M of (1)
  const Scalar M_shoulder_z_1 = t_shoulder_2 * (qd[0] * qd[1] * 2.0 + base_g1 * s_shoulder);
  tau[0] = qdd[0] * (shoulder_I1 + q[1] * (boom_h1 + t_shoulder_1)) + M_shoulder_z_1;
}

void forward_dynamics(const Scalar q[2], const Scalar qd[2], const Scalar tau[2],
                      Scalar qdd[2]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  // shoulder_link: 1/pivot, qdd of (1)
  const Scalar inverse_pivot_shoulder = 1.0 / (shoulder_I1 + q[1] * (boom_h1 + boom_m1 * q[1]));
  const Scalar t_shoulder_1 = boom_l1 + q[1];
  const Scalar qdd_0_1 = tau[0] - t_shoulder_1 * (boom_w1 * s_shoulder + qd[0] * qd[1] * boom_m2);
  qdd[0] = inverse_pivot_shoulder * qdd_0_1;
  // boom: qdd of (1)
  qdd[1] = base_g1 * c_shoulder + boom_p1 * tau[1] + qd[0] * qd[0] * t_shoulder_1;
}

void point_positions(const Scalar q[2], Scalar p[3]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  // shoulder_link: p of 1.2
  p[0] = s_shoulder * q[1];
  p[2] = c_shoulder * q[1];
  p[1] = boom_l2;
}

void force_jacobian_transpose(const Scalar q[2], Scalar C[6]) noexcept {
  const auto p_s_shoulder = sine_cosine(q[0]);
  const Scalar& s_shoulder = p_s_shoulder.sine;
  const Scalar& c_shoulder = p_s_shoulder.cosine;
  C[5] = c_shoulder;
  C[3] = s_shoulder;
  // shoulder_link: C of (9)
  C[2] = -s_shoulder * q[1];
  C[0] = c_shoulder * q[1];
  C[1] = 0.0;
  C[4] = 0.0;
}

}  // namespace polar
