// puma560.cpp: see puma560.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate puma560.yaml

#include "puma560.hpp"

namespace puma560 {

static_assert(kDigest == 0x487de617fc966112ULL, "header and source are of different runs");
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

// m/s^2: gravity
constexpr double base_g1 = -9.81;

// kg m^2: inertia zz of link1; mass, com x z, inertia yy, offset y of link2; mass, com y z, inertia
//     xx zz, offset x z of link3; mass, com z, inertia xx yy, offset y of link4; mass, inertia xx
//     yy of link5; mass, com z, inertia xx yy of link6
constexpr double link1_I1 = 3.453599449;
// kg m^2: inertia zz of link1; mass, com x z, inertia yy, offset y of link2; mass, com z, inertia
//     xx yy zz, offset x z of link3
constexpr double link1_I2 = 2.88549059;
// kg m^2: inertia zz of link1; mass, com x z, inertia yy, offset y of link2; mass, com z, inertia
//     xx yy zz, offset x z of link3; mass, inertia xx yy zz, offset x of link4; mass, inertia xx yy
//     of link5; mass, inertia xx yy zz of link6
constexpr double link1_I3 = 3.155122265;

// ratio: offset y of link2; offset z of link3; offset x of link4
constexpr double link2_k1 = -14.788177339901479;
// ratio: offset y of link2; offset z of link3; offset x of link4
constexpr double link2_k2 = -7.394088669950739;
// m: offset y of link2; offset z of link3
constexpr double link2_l1 = 0.1501;
// m: offset y of link2; offset z of link3
constexpr double link2_l2 = 0.3002;
// kg m^2: mass, com y z, offset y of link2
constexpr double link2_I1 = 0.023751;
// kg m^2: mass, com x y of link2
constexpr double link2_I2 = 0.0141984;
// kg m^2: mass, com x y, inertia xx yy of link2; mass, offset x of link3; mass of link4, link5,
//     link6
constexpr double link2_I3 = 1.601861202;
// kg m^2: mass, com x z, offset y of link2; mass, com z, offset x z of link3; mass of link4, link5,
//     link6
constexpr double link2_I4 = 0.690314699;
// kg m^2: mass, com x y, inertia zz of link2; mass, com y, inertia xx zz, offset x of link3; mass,
//     com z, inertia xx yy, offset x y of link4; mass, inertia xx yy zz of link5; mass, com z,
//     inertia xx yy of link6
constexpr double link2_I5 = 2.061861411;
// kg m^2: mass, com x y of link2
constexpr double link2_I6 = 0.0070992;
// kg m^2: mass, com x y, inertia xx yy of link2; mass, offset x of link3
constexpr double link2_I7 = 1.368797152;
// kg m^2: mass, com x z, offset y of link2; mass, com z, offset x z of link3
constexpr double link2_I8 = 0.609298224;
// kg m^2: mass, com x y, inertia zz of link2; mass, offset x of link3
constexpr double link2_I9 = 1.515049952;
// N m: gravity; mass, com x of link2; mass, offset x of link3; mass of link4, link5, link6
constexpr double link2_G1 = -37.2347379;
// N m: gravity; mass, com y of link2
constexpr double link2_G2 = -1.024164;
// N m: gravity; mass, com x of link2; mass, offset x of link3
constexpr double link2_G3 = -31.9397904;

// ratio: offset x of link3, link4
constexpr double link3_k1 = -21.27093596059113;
// m: offset x of link3
constexpr double link3_l1 = 0.4318;
// kg m: mass, com y of link3; mass, com z, offset y of link4; mass of link5, link6
constexpr double link3_h1 = -0.861795;
// kg m: mass, com y of link3; mass, com z of link4
constexpr double link3_h2 = 0.32042;
// kg m^2: mass, com y, inertia xx zz of link3; mass, com z, inertia xx yy, offset x y of link4;
//     mass, inertia xx yy zz of link5; mass, com z, inertia xx yy of link6
constexpr double link3_I1 = 0.313747409;
// kg m^2: mass, com y of link3; mass, com z, offset x y of link4; mass of link5, link6
constexpr double link3_I2 = 0.0174944385;
// kg m^2: mass, com y z of link3
constexpr double link3_I3 = -0.004704;
// kg m^2: mass, com y, inertia xx yy zz of link3; mass, com z, inertia xx yy zz, offset x y of
//     link4; mass, inertia xx yy of link5; mass, com z, inertia xx yy zz of link6
constexpr double link3_I4 = 0.298477184;
// kg m^2: mass, com y, inertia xx yy zz of link3; mass, com z, inertia xx yy, offset x y of link4;
//     mass of link5, link6
constexpr double link3_I5 = -0.299575024;
// kg m^2: inertia xx yy zz of link3
constexpr double link3_I6 = 0.00625;
// kg m^2: mass, com y, inertia xx yy zz of link3; mass, com z, inertia xx yy, offset y of link4
constexpr double link3_I7 = 0.071870624;
// kg m^2: mass, com y, inertia xx yy zz of link3; mass, com z, inertia xx yy, offset y of link4
constexpr double link3_I8 = -0.065620624;
// kg m^2: mass, com y, inertia xx zz of link3; mass, com z, inertia xx yy, offset y of link4
constexpr double link3_I9 = 0.078120624;
// N m: gravity; mass, com y of link3; mass, com z, offset y of link4; mass of link5, link6
constexpr double link3_G1 = 8.45420895;

// kg: mass of link4, link5, link6
constexpr double link4_m1 = 1.25;
// m: offset x of link4
constexpr double link4_l1 = -0.0203;
// m: offset y of link4
constexpr double link4_l2 = -0.4331;
// kg m: mass, offset x of link4; mass of link5, link6
constexpr double link4_h1 = -0.025375;
// kg m^2: mass, com z, offset x y of link4; mass of link5, link6
constexpr double link4_I1 = 0.021347277;
// kg m^2: inertia xx yy zz of link4, link6; inertia xx yy of link5
constexpr double link4_I2 = 0.00164;
// kg m^2: inertia xx yy of link4, link6; inertia xx yy zz of link5
constexpr double link4_I3 = -0.0001;
// kg m^2: mass, offset x of link4; mass of link5, link6
constexpr double link4_I4 = 0.0005151125;
// kg m^2: inertia xx yy zz of link4
constexpr double link4_I5 = 0.0013;
// kg m^2: mass, com z, offset x y of link4; mass of link5, link6
constexpr double link4_I6 = 0.0106736385;
// kg m^2: mass, com z, offset x of link4
constexpr double link4_I7 = 0.000316274;
// kg m^2: inertia xx yy zz of link4; inertia xx yy of link5; mass, com z, inertia xx yy zz of link6
constexpr double link4_I8 = -0.00109784;
// N m: gravity; mass, offset x of link4; mass of link5, link6
constexpr double link4_G1 = 0.24892875;

// kg m^2: inertia xx yy zz of link5; mass, com z, inertia xx yy of link6
constexpr double link5_I1 = 0.00064216;
// kg m^2: inertia xx yy of link5; mass, com z, inertia xx yy zz of link6
constexpr double link5_I2 = 0.00020216;
// kg m^2: inertia xx yy of link5
constexpr double link5_I3 = 0.0003;
// kg m^2: inertia xx yy of link5; mass, com z, inertia xx yy of link6
constexpr double link5_I4 = 0.00024216;
// kg m^2: inertia xx yy of link5; mass, com z, inertia xx yy of link6
constexpr double link5_I5 = 0.00054216;
// kg m^2: inertia xx yy zz of link5; mass, com z, inertia xx yy of link6
constexpr double link5_I6 = 0.00034216;
// kg^-1 m^-2: inertia xx yy zz of link5; mass, com z, inertia xx yy of link6
constexpr double link5_p1 = 1557.2443004858603;

// kg m: mass, com z of link6
constexpr double link6_h1 = 0.00288;
// kg m^2: inertia xx yy zz of link6
constexpr double link6_I1 = 4e-05;
// kg m^2: offset y of link4; mass, com z of link6
constexpr double link6_I2 = -0.001247328;
// kg m^2: offset x of link4; mass, com z of link6
constexpr double link6_I3 = -5.8464e-05;
// kg m^2: offset y of link4; mass, com z of link6
constexpr double link6_I4 = -0.002494656;
// N m: gravity; mass, com z of link6
constexpr double link6_G1 = -0.0282528;
// kg^-1 m^-2: inertia xx yy zz of link6
constexpr double link6_p1 = 25000.0;
// m^-1: mass, com z, inertia xx yy zz of link6
constexpr double link6_p2 = 72.0;
// m^-1: mass, com z, inertia xx yy zz of link6
constexpr double link6_p3 = 144.0;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = -0.0203 m
// Names: vectors h_ in kg m^2/L, s_ in L; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void mass_matrix(const Scalar q[6], Scalar A[36]) noexcept {
  const Scalar q_joint2_joint3 = q[1] + q[2];
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q_joint2_joint3, q[1], q[3], q[4]);
  const Scalar s_joint2_joint3 = sines[0];
  const Scalar c_joint2_joint3 = cosines[0];
  const Scalar s_joint2 = sines[1];
  const Scalar c_joint2 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar neg_s_link3_x = link3_k1 * c_joint2;
  const Scalar neg_h_link4_x = link6_I3 * s_joint5;
  const Scalar h_link4_z = link6_I3 * c_joint5;
  const Scalar t_link5_1 = s_joint5 * s_joint5 * link5_I2;
  const Scalar t_link5_2 = link6_I4 * c_joint5;
  const Scalar t_link4_1 = c_joint4 * neg_h_link4_x;
  const Scalar h_link3_z = s_joint4 * neg_h_link4_x;
  // link4: inertia I, A of (2)
  const Scalar I_link4_zz = link4_I2 + t_link5_1;
  A[21] = I_link4_zz;
  const Scalar t_link4_2 = s_joint4 * (link4_I3 - t_link5_1);
  const Scalar t_link4_3 = s_joint4 * t_link4_2;
  const Scalar neg_I_link4_xz = s_joint5 * (link6_I2 - link5_I2 * c_joint5);
  const Scalar A_15 = s_joint4 * neg_I_link4_xz;
  A[15] = A_15;
  A[20] = A[15];
  const Scalar t_link4_4 = c_joint4 * neg_I_link4_xz;
  const Scalar t_link4_5 = 2.0 * t_link4_1;
  // link3: inertia I, A, first moment h of (2)
  const Scalar t_link3_1 = t_link4_5 - (t_link5_2 - t_link4_3);
  const Scalar I_link3_zz = link3_I1 + t_link3_1;
  A[14] = I_link3_zz;
  const Scalar neg_I_link1_zz_1 = h_link4_z - t_link4_4;
  const Scalar neg_h_link3_y = link4_I4 + t_link4_1;
  const Scalar t_link3_2 = c_joint2_joint3 * neg_s_link3_x;
  const Scalar h_link3_x = link3_I2 - h_link4_z;
  const Scalar t_link3_3 = s_joint2_joint3 * neg_s_link3_x;
  const Scalar t_link3_4 = h_link3_x * t_link3_3 - neg_h_link3_y * t_link3_2;
  const Scalar t_link3_5 = 2.0 * t_link3_4;
  const Scalar neg_s_link3_y = link3_k1 * s_joint2;
  const Scalar t_link3_6 = s_joint2_joint3 * neg_h_link3_y + c_joint2_joint3 * h_link3_x;
  const Scalar t_link3_7 = neg_s_link3_y * t_link3_6;
  const Scalar I_link3_yz = h_link3_z - c_joint4 * t_link4_2;
  const Scalar A_2_1 = c_joint2_joint3 * (link3_I3 + A_15) + s_joint2_joint3 * I_link3_yz;
  const Scalar A_2 = A_2_1 + link2_k2 * t_link3_6;
  A[2] = A_2;
  A[12] = A[2];
  A[1] = A_2 + link2_I1 * c_joint2 + s_joint2 * (link2_I4 + link3_k1 * h_link3_z);
  A[6] = A[1];
  A[7] = 2.0 * t_link3_7 - (t_link3_5 - (link2_I5 + t_link3_1));
  const Scalar neg_I_link1_zz_2 = t_link5_1 + t_link5_2 + t_link4_3;
  const Scalar neg_I_link1_zz_3 = t_link4_5 - (link3_I4 - t_link5_1) + neg_I_link1_zz_2;
  const Scalar neg_I_link1_zz_4 = s_joint2_joint3 * (link4_I1 - 2.0 * neg_I_link1_zz_1);
  const Scalar neg_I_link1_zz_5 = neg_I_link1_zz_2 - (link1_I1 - t_link3_5);
  const Scalar neg_I_link1_zz_6 = neg_I_link1_zz_4 - c_joint2_joint3 * neg_I_link1_zz_3;
  // link1: inertia I of (2)
  const Scalar neg_I_link1_zz_7 = neg_I_link1_zz_5 - link2_k1 * h_link3_z;
  const Scalar neg_I_link1_zz_8 = neg_I_link1_zz_7 + c_joint2_joint3 * neg_I_link1_zz_6;
  A[0] = -(neg_I_link1_zz_8 + s_joint2 * (link2_I2 * c_joint2 + link2_I3 * s_joint2));
  const Scalar A_23 = link6_I1 * c_joint5;
  A[23] = A_23;
  A[33] = A[23];
  const Scalar t_link5_3 = link6_I1 * s_joint5;
  A[11] = s_joint4 * t_link5_3;
  A[17] = A[11];
  A[31] = A[11];
  A[32] = A[11];
  A[5] = c_joint2_joint3 * A_23 - s_joint2_joint3 * c_joint4 * t_link5_3;
  A[30] = A[5];
  const Scalar t_link5_4 = link5_I1 - link6_I2 * c_joint5;
  const Scalar A_16 = neg_h_link4_x + c_joint4 * t_link5_4;
  A[16] = A_16;
  A[26] = A[16];
  const Scalar t_link4_6 = c_joint4 * h_link4_z;
  // link3: A of (2)
  const Scalar t_link3_8 = c_joint2_joint3 * t_link4_6 - s_joint2_joint3 * neg_h_link4_x;
  const Scalar A_10_1 = A_16 + t_link3_3 * t_link4_6 + neg_h_link4_x * t_link3_2;
  A[10] = A_10_1 - neg_s_link3_y * t_link3_8;
  A[25] = A[10];
  const Scalar t_link3_9 = c_joint2_joint3 + neg_s_link3_x;
  const Scalar neg_A_4_1 = s_joint4 * (s_joint2_joint3 * t_link5_4 + h_link4_z * t_link3_9);
  A[4] = neg_A_4_1 - link2_k2 * t_link3_8;
  A[24] = A[4];
  const Scalar neg_A_3_1 = s_joint2_joint3 * t_link4_4 - t_link4_1 * t_link3_9;
  A[3] = c_joint2_joint3 * (I_link4_zz + link2_k2 * h_link3_z) - neg_A_3_1;
  A[18] = A[3];
  A[9] = A_15 - h_link3_z * (t_link3_3 - c_joint2_joint3 * neg_s_link3_y);
  A[19] = A[9];
  A[8] = I_link3_zz - t_link3_4 + t_link3_7;
  A[13] = A[8];
  A[28] = link5_I1;
  A[35] = link6_I1;
  A[22] = 0.0;
  A[27] = 0.0;
  A[29] = 0.0;
  A[34] = 0.0;
}

void bias_force(const Scalar q[6], const Scalar qd[6], Scalar B[6]) noexcept {
  const Scalar q_joint2_joint3 = q[1] + q[2];
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[1], q_joint2_joint3, q[3], q[4]);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint2_joint3 = sines[1];
  const Scalar c_joint2_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar neg_s_link3_y = link3_l1 * s_joint2;
  const Scalar neg_s_link3_x = link3_l1 * c_joint2;
  const Scalar neg_s_link4_y = link4_l2 * c_joint2_joint3 + link4_l1 * s_joint2_joint3;
  const Scalar neg_Omega_link1_xx = qd[0] * qd[0];
  // link2: Omega of (3)
  const Scalar neg_Omega_link2_yy = qd[1] * qd[1];
  const Scalar t_link2_1 = 2.0 * qd[0];
  const Scalar Omega_link2_zy = qd[1] * t_link2_1;
  // link3: angular velocity omega, Omega, moment M of (3)
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar neg_Omega_link3_yy = omega_link3_z * omega_link3_z;
  const Scalar t_link3_1 = link3_h1 * s_joint2_joint3 - link4_h1 * c_joint2_joint3;
  // link4: angular velocity omega, angular acceleration alpha, acceleration a of (3)
  const Scalar t_link4_1 = s_joint2_joint3 * qd[0];
  const Scalar t_link4_2 = c_joint4 * omega_link3_z;
  const Scalar t_link4_3 = c_joint2_joint3 * qd[0];
  const Scalar t_link4_4 = s_joint4 * omega_link3_z;
  const Scalar omega_link4_x = t_link4_4 - c_joint4 * t_link4_1;
  const Scalar omega_link4_z = qd[3] + t_link4_3;
  const Scalar neg_alpha_link4_z = omega_link3_z * t_link4_1;
  const Scalar neg_omega_link5_y = c_joint5 * omega_link4_z + s_joint5 * omega_link4_x;
  const Scalar omega_link4_y = t_link4_2 + s_joint4 * t_link4_1;
  const Scalar omega_link5_z = qd[4] + omega_link4_y;
  const Scalar omega_link5_x = c_joint5 * omega_link4_x - s_joint5 * omega_link4_z;
  const Scalar neg_alpha_link4_x = t_link4_2 * t_link4_3 - qd[3] * omega_link4_y;
  const Scalar alpha_link5_y_1 = c_joint5 * neg_alpha_link4_z - qd[4] * omega_link5_x;
  const Scalar alpha_link5_y = alpha_link5_y_1 + s_joint5 * neg_alpha_link4_x;
  const Scalar neg_M_link6_z = link6_I1 * alpha_link5_y;
  B[5] = -neg_M_link6_z;
  const Scalar neg_a_link3_z = neg_s_link3_y * Omega_link2_zy + link2_l1 * neg_Omega_link1_xx;
  const Scalar Omega_link3_zy = t_link2_1 * omega_link3_z;
  const Scalar t_link4_5 = neg_a_link3_z + neg_s_link4_y * Omega_link3_zy;
  const Scalar a_link3_y = neg_s_link3_y * neg_Omega_link2_yy;
  const Scalar t_link4_6 = a_link3_y + neg_s_link4_y * neg_Omega_link3_yy;
  const Scalar neg_Omega_link3_xx = neg_Omega_link1_xx + neg_Omega_link3_yy;
  const Scalar neg_s_link4_x = link4_l1 * c_joint2_joint3 - link4_l2 * s_joint2_joint3;
  const Scalar a_link3_x = neg_s_link3_x * (neg_Omega_link1_xx + neg_Omega_link2_yy);
  const Scalar t_link4_7 = a_link3_x + neg_Omega_link3_xx * neg_s_link4_x;
  const Scalar t_link4_8 = s_joint2_joint3 * t_link4_6 + c_joint2_joint3 * t_link4_7;
  const Scalar alpha_link4_y = t_link4_3 * t_link4_4 - qd[3] * omega_link4_x;
  const Scalar omega_link6_z = neg_omega_link5_y + qd[5];
  const Scalar t_link5_1 = link6_I1 * omega_link6_z;
  const Scalar neg_a_link4_z = s_joint2_joint3 * t_link4_7 - c_joint2_joint3 * t_link4_6;
  // link5: acceleration a, moment M, angular acceleration alpha of (3)
  const Scalar neg_a_link5_x_1 = c_joint5 * (s_joint4 * t_link4_5 + c_joint4 * t_link4_8);
  const Scalar M_link5_z_1 = omega_link5_x * (t_link5_1 - link5_I4 * neg_omega_link5_y);
  const Scalar M_link5_z_2 = link5_I1 * alpha_link4_y - M_link5_z_1;
  const Scalar neg_a_link5_x = neg_a_link5_x_1 - s_joint5 * neg_a_link4_z;
  const Scalar M_link5_z = M_link5_z_2 - link6_h1 * neg_a_link5_x;
  B[4] = M_link5_z;
  const Scalar a_link4_y = s_joint4 * t_link4_8 - c_joint4 * t_link4_5;
  const Scalar alpha_link5_x_1 = s_joint5 * neg_alpha_link4_z - c_joint5 * neg_alpha_link4_x;
  const Scalar alpha_link5_x = alpha_link5_x_1 - neg_omega_link5_y * qd[4];
  // link6: moment M of (3)
  const Scalar neg_M_link5_x_1 = link6_h1 * a_link4_y - link5_I5 * alpha_link5_x;
  const Scalar neg_M_link5_x_2 = t_link5_1 - link5_I6 * neg_omega_link5_y;
  const Scalar neg_M_link5_x = neg_M_link5_x_1 - omega_link5_z * neg_M_link5_x_2;
  // link5: moment M, Omega of (3)
  const Scalar M_link5_y_1 = neg_M_link6_z + link5_I3 * alpha_link5_y;
  const Scalar M_link5_y = M_link5_y_1 + omega_link5_z * omega_link5_x * link4_I3;
  const Scalar neg_M_link4_z_1 = link4_I5 * neg_alpha_link4_z - s_joint5 * neg_M_link5_x;
  const Scalar neg_M_link4_z = neg_M_link4_z_1 + c_joint5 * M_link5_y;
  B[3] = -neg_M_link4_z;
  const Scalar Omega_link6_xz = alpha_link4_y + neg_omega_link5_y * omega_link5_x;
  const Scalar neg_Omega_link5_yy = omega_link5_x * omega_link5_x + omega_link5_z * omega_link5_z;
  const Scalar t_link4_9 = c_joint5 * Omega_link6_xz - s_joint5 * neg_Omega_link5_yy;
  const Scalar Omega_link5_zy = alpha_link5_x - neg_omega_link5_y * omega_link5_z;
  // link4: force F, moment M of (3)
  const Scalar t_link4_10 = s_joint4 * Omega_link5_zy + c_joint4 * t_link4_9;
  const Scalar t_link4_11 = s_joint5 * Omega_link6_xz + c_joint5 * neg_Omega_link5_yy;
  const Scalar t_link4_12 = c_joint2_joint3 * t_link4_11 + s_joint2_joint3 * t_link4_10;
  const Scalar t_link4_13 = link6_h1 * t_link4_12;
  const Scalar t_link4_14 = link4_I5 * omega_link4_z;
  const Scalar M_link4_y = M_link5_z - omega_link4_x * t_link4_14;
  const Scalar neg_M_link4_x_1 = s_joint5 * M_link5_y + c_joint5 * neg_M_link5_x;
  const Scalar neg_M_link4_x = neg_M_link4_x_1 - omega_link4_y * t_link4_14;
  const Scalar t_link4_15 = c_joint2_joint3 * t_link4_10 - s_joint2_joint3 * t_link4_11;
  const Scalar t_link4_16 = link6_h1 * t_link4_15;
  // link3: moment M of (3)
  const Scalar t_link3_2 = link3_h1 * c_joint2_joint3 + link4_h1 * s_joint2_joint3;
  const Scalar t_link3_3 = neg_s_link3_x * t_link3_2;
  const Scalar t_link3_4 = link3_I5 * c_joint2_joint3 - link4_I1 * s_joint2_joint3;
  const Scalar t_link3_5 = link4_I6 + t_link3_3 + s_joint2_joint3 * t_link3_4;
  // link4
  const Scalar M_link3_z_1 = neg_s_link4_x * t_link4_13 + c_joint4 * M_link4_y;
  const Scalar M_link3_z_2 = M_link3_z_1 - s_joint4 * neg_M_link4_x;
  const Scalar M_link3_z_3 = M_link3_z_2 - neg_s_link4_y * t_link4_16;
  // link3: moment M of (3)
  const Scalar M_link3_z_4 = M_link3_z_3 + neg_Omega_link1_xx * t_link3_5;
  const Scalar M_link3_z_5 = t_link3_3 + neg_s_link3_y * t_link3_1;
  const Scalar M_link3_z = M_link3_z_4 + neg_Omega_link2_yy * M_link3_z_5;
  B[2] = M_link3_z;
  const Scalar t_link2_2 = link2_I6 - c_joint2 * (link2_I2 * c_joint2 + link2_I3 * s_joint2);
  const Scalar neg_F_link3_x = t_link4_16 + t_link3_1 * neg_Omega_link3_xx;
  const Scalar neg_M_link2_y_1 = s_joint4 * M_link4_y - link3_I3 * neg_Omega_link3_yy;
  const Scalar neg_M_link2_y_2 = s_joint4 * t_link4_9 - c_joint4 * Omega_link5_zy;
  const Scalar neg_M_link2_y_3 = c_joint2_joint3 * neg_M_link4_z - Omega_link2_zy * t_link2_2;
  const Scalar neg_M_link2_y_4 = neg_M_link2_y_2 * (neg_s_link3_x + neg_s_link4_x);
  const Scalar neg_M_link2_y_5 = neg_M_link2_y_3 - link6_h1 * neg_M_link2_y_4;
  const Scalar neg_M_link2_y_6 = neg_M_link2_y_5 - t_link3_1 * neg_a_link3_z;
  const Scalar neg_M_link2_y_7 = neg_M_link2_y_6 + link2_l1 * neg_F_link3_x;
  const Scalar neg_M_link2_y_8 = neg_M_link2_y_1 + c_joint4 * neg_M_link4_x;
  const Scalar neg_M_link2_y_9 = neg_M_link2_y_7 - s_joint2_joint3 * neg_M_link2_y_8;
  const Scalar neg_M_link2_y_10 = link2_I4 * c_joint2 - link2_I1 * s_joint2;
  const Scalar neg_M_link2_y_11 = neg_M_link2_y_9 - neg_Omega_link2_yy * neg_M_link2_y_10;
  B[0] = -(neg_M_link2_y_11 + Omega_link3_zy * t_link3_5);
  const Scalar M_link2_z_1 = M_link3_z - neg_Omega_link1_xx * t_link2_2;
  const Scalar neg_F_link3_y = t_link4_13 - neg_Omega_link3_yy * t_link3_2;
  // link2: moment M of (3)
  B[1] = M_link2_z_1 + neg_s_link3_x * neg_F_link3_y - neg_s_link3_y * neg_F_link3_x;
}

void gravity_force(const Scalar q[6], Scalar G[6]) noexcept {
  const Scalar q_joint2_joint3 = q[1] + q[2];
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[1], q_joint2_joint3, q[3], q[4]);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint2_joint3 = sines[1];
  const Scalar c_joint2_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  // link5: G of 6.5
  const Scalar t_link5_1 = s_joint2_joint3 * c_joint5 * link6_G1;
  const Scalar t_link5_2 = link6_G1 * s_joint5;
  G[4] = c_joint4 * t_link5_1 + c_joint2_joint3 * t_link5_2;
  G[3] = -s_joint2_joint3 * s_joint4 * t_link5_2;
  const Scalar G_2_1 = t_link5_1 - link3_G1 * s_joint2_joint3;
  const Scalar G_2 = G_2_1 + c_joint2_joint3 * (link4_G1 + c_joint4 * t_link5_2);
  G[2] = G_2;
  // link2: G of 6.5
  G[1] = G_2 + link2_G1 * c_joint2 - link2_G2 * s_joint2;
  G[0] = 0.0;
  G[5] = 0.0;
}

void inverse_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar qdd[6],
                      Scalar tau[6]) noexcept {
  const Scalar q_joint2_joint3 = q[1] + q[2];
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q_joint2_joint3, q[1], q[4], q[3]);
  const Scalar s_joint2_joint3 = sines[0];
  const Scalar c_joint2_joint3 = cosines[0];
  const Scalar s_joint2 = sines[1];
  const Scalar c_joint2 = cosines[1];
  const Scalar s_joint5 = sines[2];
  const Scalar c_joint5 = cosines[2];
  const Scalar s_joint4 = sines[3];
  const Scalar c_joint4 = cosines[3];
  const Scalar neg_s_link3_x = link3_l1 * c_joint2;
  const Scalar neg_Omega_link1_xx = qd[0] * qd[0];
  const Scalar neg_Omega_link2_yy = qd[1] * qd[1];
  const Scalar neg_s_link3_y = link3_l1 * s_joint2;
  const Scalar t_link3_1 = qdd[1] * neg_s_link3_y + link2_l1 * qdd[0];
  const Scalar neg_Omega_link2_xx = neg_Omega_link1_xx + neg_Omega_link2_yy;
  // link3: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_link3_2 = t_link3_1 + neg_s_link3_x * neg_Omega_link2_xx;
  const Scalar neg_omega_link3_x = c_joint2_joint3 * qd[0];
  const Scalar t_link3_3 = neg_omega_link3_x * neg_omega_link3_x;
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar t_link3_4 = omega_link3_z * omega_link3_z;
  // link4: Omega of (1)
  const Scalar t_link4_1 = 2.0 * qd[0];
  const Scalar Omega_link4_yz_1 = c_joint2_joint3 * omega_link3_z * t_link4_1;
  const Scalar Omega_link4_yz = s_joint2_joint3 * qdd[0] + Omega_link4_yz_1;
  // link3: angular velocity omega, angular acceleration alpha, Omega of (1)
  const Scalar omega_link3_y = s_joint2_joint3 * qd[0];
  const Scalar t_link3_5 = omega_link3_z * omega_link3_y;
  const Scalar Omega_link3_yz = c_joint2_joint3 * qdd[0];
  const Scalar alpha_link3_x = t_link3_5 - Omega_link3_yz;
  const Scalar Omega_link3_zy = t_link3_5 + alpha_link3_x;
  const Scalar Omega_link2_zy = qd[1] * t_link4_1;
  const Scalar t_link3_6 = neg_omega_link3_x * omega_link3_y;
  const Scalar alpha_link3_z = qdd[1] + qdd[2];
  const Scalar neg_Omega_link3_yx = t_link3_6 - alpha_link3_z;
  const Scalar neg_a_link3_z_1 = neg_s_link3_y * Omega_link2_zy - neg_s_link3_x * qdd[0];
  const Scalar neg_a_link3_z = neg_a_link3_z_1 + link2_l1 * neg_Omega_link1_xx;
  const Scalar neg_a_link4_y_1 = neg_a_link3_z + link4_l1 * Omega_link3_zy;
  const Scalar neg_a_link4_y = neg_a_link4_y_1 + link4_l2 * Omega_link4_yz;
  const Scalar t_link3_7 = t_link3_3 - t_link3_4;
  const Scalar neg_Omega_link3_xx = neg_Omega_link1_xx - t_link3_7;
  const Scalar t_link3_8 = base_g1 + neg_s_link3_x * qdd[1] - neg_Omega_link2_yy * neg_s_link3_y;
  // link4: acceleration a, angular velocity omega, angular acceleration alpha of (1)
  const Scalar neg_a_link4_z_1 = link4_l1 * (t_link3_6 + alpha_link3_z);
  const Scalar neg_a_link4_z_2 = s_joint2_joint3 * t_link3_2 + neg_a_link4_z_1;
  const Scalar neg_a_link4_z_3 = neg_a_link4_z_2 - link4_l2 * neg_Omega_link3_xx;
  const Scalar neg_a_link4_z = neg_a_link4_z_3 + c_joint2_joint3 * t_link3_8;
  const Scalar neg_a_link3_y = s_joint2_joint3 * t_link3_8 - c_joint2_joint3 * t_link3_2;
  const Scalar neg_Omega_link3_yy = t_link3_3 + t_link3_4;
  const Scalar a_link4_x_1 = neg_a_link3_y + link4_l2 * neg_Omega_link3_yx;
  const Scalar a_link4_x = a_link4_x_1 - link4_l1 * neg_Omega_link3_yy;
  const Scalar omega_link4_z = neg_omega_link3_x + qd[3];
  const Scalar t_link4_2 = omega_link3_z * omega_link4_z;
  const Scalar neg_alpha_link4_z = alpha_link3_x - qdd[3];
  const Scalar t_link4_3 = omega_link3_y * omega_link4_z;
  // link5: angular velocity omega, angular acceleration alpha, acceleration a of (1)
  const Scalar t_link5_1 = c_joint4 * omega_link3_y - s_joint4 * omega_link3_z;
  const Scalar omega_link5_y = s_joint5 * t_link5_1 - c_joint5 * omega_link4_z;
  const Scalar omega_link5_z = qd[4] + s_joint4 * omega_link3_y + c_joint4 * omega_link3_z;
  const Scalar neg_omega_link5_x = c_joint5 * t_link5_1 + s_joint5 * omega_link4_z;
  const Scalar neg_alpha_link4_x = Omega_link4_yz - t_link4_2;
  const Scalar neg_alpha_link4_y = neg_Omega_link3_yx - t_link4_3;
  const Scalar t_link5_2 = c_joint4 * neg_alpha_link4_x + s_joint4 * neg_alpha_link4_y;
  const Scalar alpha_link5_y_1 = c_joint5 * neg_alpha_link4_z + qd[4] * neg_omega_link5_x;
  const Scalar alpha_link5_y = alpha_link5_y_1 + s_joint5 * t_link5_2;
  const Scalar alpha_link6_z = qdd[5] - alpha_link5_y;
  const Scalar M_link6_z = link6_I1 * alpha_link6_z;
  tau[5] = M_link6_z;
  const Scalar a_link5_x_1 = c_joint5 * (s_joint4 * neg_a_link4_y - c_joint4 * a_link4_x);
  const Scalar a_link5_x = s_joint5 * neg_a_link4_z - a_link5_x_1;
  const Scalar alpha_link5_z = qdd[4] + s_joint4 * neg_alpha_link4_x - c_joint4 * neg_alpha_link4_y;
  const Scalar t_link5_3 = link6_I1 * (omega_link5_y - qd[5]);
  const Scalar M_link5_z_1 = link6_h1 * a_link5_x + link5_I1 * alpha_link5_z;
  const Scalar M_link5_z_2 = t_link5_3 - link5_I4 * omega_link5_y;
  const Scalar M_link5_z = M_link5_z_1 - neg_omega_link5_x * M_link5_z_2;
  tau[4] = M_link5_z;
  const Scalar neg_M_link5_y_1 = M_link6_z + omega_link5_z * neg_omega_link5_x * link4_I3;
  const Scalar neg_M_link5_y = neg_M_link5_y_1 - link5_I3 * alpha_link5_y;
  const Scalar t_link5_4 = link6_h1 * s_joint4;
  const Scalar alpha_link5_x_1 = s_joint5 * neg_alpha_link4_z + omega_link5_y * qd[4];
  const Scalar alpha_link5_x = alpha_link5_x_1 - c_joint5 * t_link5_2;
  const Scalar t_link5_5 = link6_h1 * c_joint4;
  const Scalar M_link5_x_1 = a_link4_x * t_link5_4 + link5_I5 * alpha_link5_x;
  const Scalar M_link5_x_2 = M_link5_x_1 + neg_a_link4_y * t_link5_5;
  const Scalar M_link5_x = M_link5_x_2 - omega_link5_z * (t_link5_3 - link5_I6 * omega_link5_y);
  const Scalar neg_M_link4_z_1 = link4_I5 * neg_alpha_link4_z - c_joint5 * neg_M_link5_y;
  const Scalar neg_M_link4_z = neg_M_link4_z_1 + s_joint5 * M_link5_x;
  tau[3] = -neg_M_link4_z;
  const Scalar Omega_link6_xz = alpha_link5_z + omega_link5_y * neg_omega_link5_x;
  const Scalar neg_Omega_link5_yy_1 = neg_omega_link5_x * neg_omega_link5_x;
  const Scalar neg_Omega_link5_yy = omega_link5_z * omega_link5_z + neg_Omega_link5_yy_1;
  const Scalar t_link5_6 = c_joint5 * Omega_link6_xz - s_joint5 * neg_Omega_link5_yy;
  const Scalar Omega_link5_zy = alpha_link5_x + omega_link5_y * omega_link5_z;
  const Scalar neg_F_link4_y_1 = link4_m1 * neg_a_link4_y - t_link5_4 * t_link5_6;
  const Scalar neg_F_link4_y = neg_F_link4_y_1 + t_link5_5 * Omega_link5_zy;
  const Scalar neg_F_link4_z_1 = c_joint5 * neg_Omega_link5_yy + s_joint5 * Omega_link6_xz;
  const Scalar neg_F_link4_z = link4_m1 * neg_a_link4_z + link6_h1 * neg_F_link4_z_1;
  const Scalar F_link4_x_1 = link4_m1 * a_link4_x + t_link5_4 * Omega_link5_zy;
  const Scalar F_link4_x = F_link4_x_1 + t_link5_5 * t_link5_6;
  const Scalar t_link5_7 = s_joint5 * neg_M_link5_y + c_joint5 * M_link5_x;
  // link3: moment M, force F of (1)
  const Scalar M_link3_z_1 = link3_I3 * Omega_link3_yz + link4_I5 * t_link4_3;
  const Scalar M_link3_z_2 = M_link3_z_1 - link4_l2 * F_link4_x + link3_I8 * t_link3_6;
  const Scalar M_link3_z_3 = M_link3_z_2 + c_joint4 * M_link5_z + link4_l1 * neg_F_link4_z;
  const Scalar M_link3_z_4 = M_link3_z_3 + link4_I7 * (neg_Omega_link3_xx - neg_Omega_link3_yy);
  const Scalar M_link3_z_5 = M_link3_z_4 + link3_I9 * alpha_link3_z + s_joint4 * t_link5_7;
  const Scalar M_link3_z = M_link3_z_5 + link3_h2 * neg_a_link3_y;
  tau[2] = M_link3_z;
  const Scalar neg_F_link3_y = F_link4_x - link3_h2 * neg_Omega_link3_yx;
  const Scalar F_link3_x = neg_F_link4_z + link3_h2 * neg_Omega_link3_xx;
  const Scalar t_link3_9 = c_joint2_joint3 * neg_F_link3_y - s_joint2_joint3 * F_link3_x;
  const Scalar M_link2_z_1 = c_joint2_joint3 * F_link3_x + s_joint2_joint3 * neg_F_link3_y;
  // link2: moment M of (1)
  const Scalar t_link2_1 = link2_I7 * s_joint2 + link2_I2 * c_joint2;
  const Scalar t_link2_2 = link2_I6 - c_joint2 * t_link2_1;
  const Scalar t_link2_3 = link2_I8 * s_joint2 + link2_I1 * c_joint2;
  const Scalar M_link2_z_2 = M_link3_z + link2_I9 * qdd[1];
  const Scalar M_link2_z_3 = M_link2_z_2 - s_joint2 * (link2_G2 + link3_l1 * t_link3_9);
  const Scalar M_link2_z_4 = M_link2_z_3 + c_joint2 * (link2_G3 + link3_l1 * M_link2_z_1);
  tau[1] = M_link2_z_4 - neg_Omega_link1_xx * t_link2_2 + qdd[0] * t_link2_3;
  const Scalar M_link1_z_1 = link2_I8 * c_joint2 - link2_I1 * s_joint2;
  // link3: moment M of (1)
  const Scalar M_link3_x_1 = neg_M_link4_z + link3_I6 * Omega_link3_zy + link4_l1 * neg_F_link4_y;
  const Scalar M_link3_x_2 = M_link3_x_1 - link4_I7 * Omega_link4_yz;
  const Scalar M_link3_x = M_link3_x_2 + link3_I3 * neg_Omega_link3_yx;
  // link4: moment M of (1)
  const Scalar neg_M_link3_y_1 = link4_I5 * t_link4_2 + link4_I7 * Omega_link3_zy;
  const Scalar neg_M_link3_y_2 = neg_M_link3_y_1 - link3_I3 * t_link3_7;
  const Scalar neg_M_link3_y_3 = neg_M_link3_y_2 + link3_h2 * neg_a_link3_z;
  const Scalar neg_M_link3_y_4 = neg_M_link3_y_3 - link3_I7 * Omega_link4_yz;
  const Scalar neg_M_link3_y_5 = neg_M_link3_y_4 - link4_l2 * neg_F_link4_y;
  const Scalar M_link1_z_2 = neg_Omega_link2_yy * M_link1_z_1 + Omega_link2_zy * t_link2_2;
  const Scalar neg_M_link3_y = neg_M_link3_y_5 + c_joint4 * t_link5_7 - s_joint4 * M_link5_z;
  // link1: moment M of (1)
  const Scalar M_link1_z_3 = M_link1_z_2 - c_joint2_joint3 * M_link3_x;
  const Scalar M_link1_z_4 = M_link1_z_3 - s_joint2_joint3 * neg_M_link3_y;
  const Scalar M_link1_z_5 = M_link1_z_4 - link2_l1 * t_link3_9 + qdd[1] * t_link2_3;
  const Scalar M_link1_z_6 = M_link1_z_5 + qdd[0] * (link1_I2 - s_joint2 * t_link2_1);
  tau[0] = M_link1_z_6 - neg_s_link3_x * (neg_F_link4_y - link3_h2 * Omega_link4_yz);
}

void forward_dynamics(const Scalar q[6], const Scalar qd[6], const Scalar tau[6],
                      Scalar qdd[6]) noexcept {
  const Scalar q_joint2_joint3 = q[1] + q[2];
  Scalar sines[4];
  Scalar cosines[4];
  sines_cosines(sines, cosines, q[1], q_joint2_joint3, q[3], q[4]);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint2_joint3 = sines[1];
  const Scalar c_joint2_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar neg_s_link3_y = link3_l1 * s_joint2;
  const Scalar neg_s_link3_x = link3_l1 * c_joint2;
  const Scalar neg_s_link4_x = link4_l1 * c_joint2_joint3 - link4_l2 * s_joint2_joint3;
  const Scalar neg_s_link4_y = link4_l2 * c_joint2_joint3 + link4_l1 * s_joint2_joint3;
  const Scalar neg_Omega_link1_xx = qd[0] * qd[0];
  // link2: Omega of (1)
  const Scalar neg_Omega_link2_yy = qd[1] * qd[1];
  const Scalar t_link2_1 = link2_I2 * c_joint2 + link2_I3 * s_joint2;
  const Scalar t_link2_2 = link2_I6 - c_joint2 * t_link2_1;
  const Scalar t_link2_3 = 2.0 * qd[0];
  const Scalar Omega_link2_zy = qd[1] * t_link2_3;
  // link3: angular velocity omega, Omega, force F of (1)
  const Scalar omega_link3_z = qd[1] + qd[2];
  const Scalar neg_Omega_link3_yy = omega_link3_z * omega_link3_z;
  const Scalar neg_Omega_link3_xx = neg_Omega_link1_xx + neg_Omega_link3_yy;
  const Scalar t_link3_1 = link3_h1 * s_joint2_joint3 - link4_h1 * c_joint2_joint3;
  const Scalar neg_a_link3_y = base_g1 - neg_s_link3_y * neg_Omega_link2_yy;
  const Scalar t_link4_1 = neg_a_link3_y - neg_s_link4_y * neg_Omega_link3_yy;
  const Scalar a_link3_x = neg_s_link3_x * (neg_Omega_link1_xx + neg_Omega_link2_yy);
  // link4: acceleration a, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_link4_2 = a_link3_x + neg_s_link4_x * neg_Omega_link3_xx;
  const Scalar t_link4_3 = s_joint2_joint3 * t_link4_1 - c_joint2_joint3 * t_link4_2;
  const Scalar t_link4_4 = s_joint2_joint3 * qd[0];
  const Scalar t_link4_5 = c_joint4 * omega_link3_z;
  const Scalar omega_link4_y = t_link4_5 + s_joint4 * t_link4_4;
  const Scalar t_link4_6 = c_joint2_joint3 * qd[0];
  const Scalar t_link4_7 = s_joint4 * omega_link3_z;
  const Scalar omega_link4_x = t_link4_7 - c_joint4 * t_link4_4;
  const Scalar omega_link4_z = qd[3] + t_link4_6;
  const Scalar neg_alpha_link4_z = omega_link3_z * t_link4_4;
  // link5: angular velocity omega, angular acceleration alpha of (1)
  const Scalar neg_omega_link5_y = s_joint5 * omega_link4_x + c_joint5 * omega_link4_z;
  const Scalar omega_link5_z = omega_link4_y + qd[4];
  const Scalar neg_omega_link5_x = s_joint5 * omega_link4_z - c_joint5 * omega_link4_x;
  const Scalar neg_alpha_link4_x = t_link4_5 * t_link4_6 - omega_link4_y * qd[3];
  const Scalar alpha_link5_y_1 = c_joint5 * neg_alpha_link4_z + s_joint5 * neg_alpha_link4_x;
  const Scalar alpha_link5_y = alpha_link5_y_1 + qd[4] * neg_omega_link5_x;
  const Scalar neg_M_link6_z = link6_I1 * alpha_link5_y;
  const Scalar neg_a_link3_z = neg_s_link3_y * Omega_link2_zy + link2_l1 * neg_Omega_link1_xx;
  const Scalar Omega_link3_zy = t_link2_3 * omega_link3_z;
  // link4: acceleration a, first moment h, angular acceleration alpha of (1)
  const Scalar t_link4_8 = neg_a_link3_z + neg_s_link4_y * Omega_link3_zy;
  const Scalar h_link4_x = link6_h1 * s_joint5;
  const Scalar t_link4_9 = c_joint2_joint3 * h_link4_x;
  const Scalar h_link4_z = link6_h1 * c_joint5;
  const Scalar t_link4_10 = s_joint2_joint3 * h_link4_x;
  const Scalar alpha_link4_y = t_link4_6 * t_link4_7 - qd[3] * omega_link4_x;
  // link5: Omega, force F, angular acceleration alpha of (1)
  const Scalar neg_Omega_link5_xy = alpha_link4_y - neg_omega_link5_y * neg_omega_link5_x;
  const Scalar neg_Omega_link5_yy_1 = neg_omega_link5_x * neg_omega_link5_x;
  const Scalar neg_Omega_link5_yy = neg_Omega_link5_yy_1 + omega_link5_z * omega_link5_z;
  const Scalar F_link4_x = h_link4_z * neg_Omega_link5_xy - h_link4_x * neg_Omega_link5_yy;
  const Scalar neg_F_link4_z = h_link4_z * neg_Omega_link5_yy + h_link4_x * neg_Omega_link5_xy;
  const Scalar alpha_link5_x_1 = s_joint5 * neg_alpha_link4_z - c_joint5 * neg_alpha_link4_x;
  const Scalar alpha_link5_x = alpha_link5_x_1 - neg_omega_link5_y * qd[4];
  const Scalar Omega_link5_zy = alpha_link5_x - neg_omega_link5_y * omega_link5_z;
  const Scalar neg_F_link5_z = link6_h1 * Omega_link5_zy;
  const Scalar t_link4_11 = s_joint4 * neg_F_link5_z + c_joint4 * F_link4_x;
  const Scalar t_link4_12 = s_joint2_joint3 * neg_F_link4_z - c_joint2_joint3 * t_link4_11;
  const Scalar F_link3_x = t_link4_12 - neg_Omega_link3_xx * t_link3_1;
  const Scalar omega_link6_z = neg_omega_link5_y + qd[5];
  const Scalar t_link5_1 = link6_I1 * omega_link6_z;
  const Scalar a_link4_x = c_joint4 * t_link4_3 - s_joint4 * t_link4_8;
  const Scalar M_link5_z_1 = neg_omega_link5_x * (t_link5_1 - link5_I4 * neg_omega_link5_y);
  const Scalar M_link5_z_2 = link5_I1 * alpha_link4_y + M_link5_z_1 + h_link4_z * a_link4_x;
  const Scalar M_link5_z = M_link5_z_2 + t_link4_1 * t_link4_9 + t_link4_2 * t_link4_10;
  const Scalar t_link1_1 = tau[4] - M_link5_z;
  const Scalar t_link1_2 = neg_M_link6_z + tau[5];
  const Scalar t_link5_2 = link5_I2 * s_joint5;
  const Scalar t_link5_3 = s_joint5 * t_link5_2;
  const Scalar t_link4_13 = s_joint2_joint3 * h_link4_z;
  const Scalar t_link5_4 = link6_I1 * c_joint5;
  const Scalar t_link4_14 = s_joint2_joint3 * c_joint4;
  const Scalar t_link5_5 = link6_I1 * s_joint5;
  const Scalar t_link4_15 = c_joint2_joint3 * t_link5_4 - t_link4_14 * t_link5_5;
  const Scalar t_link3_2 = link3_h1 * c_joint2_joint3 + link4_h1 * s_joint2_joint3;
  // link4: first moment h of (1)
  const Scalar neg_h_link3_y = t_link3_2 - link6_p2 * t_link4_15;
  const Scalar t_link4_16 = s_joint4 * (link4_I3 - t_link5_3);
  const Scalar t_link4_17 = s_joint4 * t_link4_16;
  const Scalar t_link4_18 = s_joint4 * c_joint5;
  const Scalar t_link4_19 = t_link5_2 * t_link4_18;
  const Scalar t_link4_20 = t_link4_13 + c_joint4 * t_link4_9;
  const Scalar t_link4_21 = neg_s_link4_x * t_link4_20 * 2.0;
  // link3: first moment h of (1)
  const Scalar t_link3_3 = neg_s_link3_y * neg_h_link3_y;
  const Scalar h_link3_x = t_link3_1 - t_link4_20;
  const Scalar t_link3_4 = neg_s_link3_x * h_link3_x;
  const Scalar t_link3_5 = 2.0 * t_link3_4;
  const Scalar h_link3_z = s_joint4 * h_link4_x;
  // link4
  const Scalar t_link4_22 = t_link4_10 - c_joint2_joint3 * c_joint4 * h_link4_z;
  const Scalar t_link4_23 = t_link4_9 + c_joint4 * t_link4_13;
  const Scalar t_link4_24 = link5_I1 * c_joint4 + neg_s_link4_x * t_link4_23;
  const Scalar t_link4_25 = t_link4_24 + neg_s_link4_y * t_link4_22;
  // link3
  const Scalar t_link3_6 = neg_s_link3_y * t_link4_22 + neg_s_link3_x * t_link4_23;
  const Scalar t_link3_7 = t_link4_25 + t_link3_6;
  const Scalar t_link3_8 = neg_s_link3_x + neg_s_link4_x;
  const Scalar t_link3_9 = s_joint4 * (link5_I1 * s_joint2_joint3 + h_link4_z * t_link3_8);
  const Scalar t_link3_10 = t_link3_9 + link2_l1 * t_link4_22;
  const Scalar t_link4_26 = s_joint4 * t_link5_5;
  const Scalar t_link6_1 = link6_p1 * t_link4_26;
  const Scalar t_link3_11 = neg_s_link3_x * s_joint2_joint3 - neg_s_link3_y * c_joint2_joint3;
  const Scalar t_link3_12 = h_link3_z * t_link3_11;
  // link6
  const Scalar t_link6_2 = t_link4_19 + t_link5_5 * t_link4_18 - link4_l2 * h_link3_z;
  const Scalar t_link6_3 = t_link3_12 + t_link6_2;
  const Scalar t_link6_4 = t_link5_2 * t_link4_14;
  const Scalar I_link4_zz = link4_I2 + t_link5_3;
  const Scalar t_link6_5 = c_joint5 * (t_link4_15 - t_link6_4);
  const Scalar t_link6_6 = t_link6_5 - c_joint4 * h_link4_x * t_link3_8;
  const Scalar t_link6_7 = t_link6_6 - c_joint2_joint3 * (I_link4_zz + link2_l1 * h_link3_z);
  const Scalar inverse_pivot_link4 = 1.0 / (I_link4_zz - c_joint5 * t_link5_4);
  const Scalar t_link5_6 = link5_p1 * t_link4_25;
  const Scalar t_link4_27 = t_link6_2 * inverse_pivot_link4;
  const Scalar t_link6_8 = t_link4_17 + t_link4_21 - t_link4_26 * t_link6_1;
  const Scalar t_link6_9 = t_link6_8 - neg_s_link4_y * t_link4_15 * link6_p3;
  // link4
  const Scalar t_link4_28 = link3_I1 + t_link6_9 - t_link6_2 * t_link4_27;
  const Scalar t_link4_29 = t_link4_28 - t_link4_25 * t_link5_6;
  const Scalar t_link4_30 = t_link3_3 - t_link3_4 + t_link4_29 - t_link3_12 * t_link4_27;
  const Scalar t_link4_31 = t_link4_30 - t_link3_6 * t_link5_6;
  const Scalar t_link6_10 = link6_p1 * t_link4_15;
  const Scalar t_link4_32 = t_link6_7 * inverse_pivot_link4;
  const Scalar t_link5_7 = link5_p1 * t_link3_10;
  const Scalar t_link3_13 = t_link4_14 * t_link4_16 - c_joint2_joint3 * (link3_I3 - t_link4_19);
  const Scalar t_link4_33 = t_link3_13 + t_link4_26 * t_link6_10 + t_link6_2 * t_link4_32;
  const Scalar t_link4_34 = t_link4_33 - neg_s_link4_y * h_link3_z + t_link4_25 * t_link5_7;
  const Scalar t_link4_35 = t_link4_34 - link2_l1 * neg_h_link3_y;
  const Scalar inverse_pivot_link3 = 1.0 / t_link4_29;
  const Scalar t_link4_36 = t_link6_3 * inverse_pivot_link4;
  const Scalar t_link3_14 = t_link4_31 * inverse_pivot_link3;
  const Scalar t_link5_8 = link5_p1 * t_link3_7;
  const Scalar inverse_pivot_link2_1 = link2_I5 - t_link3_5 + t_link6_9 + 2.0 * t_link3_3;
  // link3
  const Scalar inverse_pivot_link2_2 = inverse_pivot_link2_1 - t_link4_31 * t_link3_14;
  const Scalar inverse_pivot_link2_3 = inverse_pivot_link2_2 - t_link3_7 * t_link5_8;
  const Scalar t_link3_15 = t_link4_35 * inverse_pivot_link3;
  const Scalar t_link3_16 = t_link4_35 - link2_I1 * c_joint2 + t_link3_12 * t_link4_32;
  const Scalar t_link3_17 = t_link3_16 - s_joint2 * (link2_I4 + link3_l1 * h_link3_z);
  const Scalar t_link3_18 = t_link3_17 - t_link4_31 * t_link3_15 + t_link3_6 * t_link5_7;
  const Scalar inverse_pivot_link2 = 1.0 / (inverse_pivot_link2_3 - t_link6_3 * t_link4_36);
  const Scalar t_link3_19 = link4_I1 * c_joint2_joint3 + link3_I5 * s_joint2_joint3;
  const Scalar t_link4_37 = link4_I8 - t_link4_17 - 2.0 * t_link5_3;
  // link2
  const Scalar t_link2_4 = t_link3_18 * inverse_pivot_link2;
  const Scalar t_link2_5 = t_link3_5 - (link1_I3 + t_link5_3 + t_link4_21);
  const Scalar t_link2_6 = t_link2_5 - link2_l2 * h_link3_z;
  const Scalar t_link2_7 = t_link2_6 - c_joint2_joint3 * c_joint5 * t_link6_4 * 2.0;
  const Scalar t_link2_8 = t_link2_7 + t_link6_7 * t_link4_32;
  const Scalar t_link2_9 = t_link3_19 - s_joint2_joint3 * t_link4_37;
  const Scalar t_link2_10 = t_link2_8 + s_joint2_joint3 * t_link2_9;
  const Scalar t_link2_11 = t_link2_10 + t_link4_15 * t_link6_10 + t_link3_10 * t_link5_7;
  const Scalar t_link2_12 = t_link2_11 + t_link3_18 * t_link2_4 + t_link4_35 * t_link3_15;
  const Scalar neg_inverse_pivot_link1 = 1.0 / (t_link2_12 + s_joint2 * t_link2_1);
  const Scalar M_link5_y_1 = neg_M_link6_z + link5_I3 * alpha_link5_y;
  const Scalar M_link5_y = M_link5_y_1 - omega_link5_z * neg_omega_link5_x * link4_I3;
  const Scalar t_link4_38 = link4_I5 * omega_link4_z;
  // link1: qdd of (1)
  const Scalar t_link1_3 = link6_p1 * t_link1_2;
  const Scalar t_link1_4 = neg_s_link3_x * t_link3_2;
  const Scalar t_link1_5 = link4_I6 - t_link1_4 - c_joint2_joint3 * t_link3_19;
  // link5: moment M of (1)
  const Scalar M_link5_x_1 = link6_h1 * (s_joint4 * t_link4_3 + c_joint4 * t_link4_8);
  const Scalar M_link5_x_2 = link5_I5 * alpha_link5_x + M_link5_x_1;
  const Scalar M_link5_x_3 = t_link5_1 - link5_I6 * neg_omega_link5_y;
  const Scalar M_link5_x = M_link5_x_2 + omega_link5_z * M_link5_x_3;
  const Scalar neg_M_link4_z_1 = link4_I5 * neg_alpha_link4_z + s_joint5 * M_link5_x;
  const Scalar neg_M_link4_z = neg_M_link4_z_1 + c_joint5 * M_link5_y;
  const Scalar t_link1_6 = tau[3] + neg_M_link4_z - c_joint5 * t_link1_2;
  const Scalar t_link1_7 = inverse_pivot_link4 * t_link1_6;
  const Scalar M_link4_y = M_link5_z - omega_link4_x * t_link4_38;
  const Scalar neg_M_link4_x_1 = s_joint5 * M_link5_y - omega_link4_y * t_link4_38;
  const Scalar neg_M_link4_x = neg_M_link4_x_1 - c_joint5 * M_link5_x;
  const Scalar t_link4_39 = c_joint2_joint3 * neg_F_link4_z + s_joint2_joint3 * t_link4_11;
  const Scalar t_link1_8 = link2_G1 + link3_l1 * (t_link4_39 - neg_Omega_link3_yy * t_link3_2);
  const Scalar neg_qdd_0_1 = link2_I4 * c_joint2 - link2_I1 * s_joint2;
  const Scalar neg_qdd_0_2 = c_joint4 * neg_F_link5_z - s_joint4 * F_link4_x;
  // link1: qdd of (1)
  const Scalar neg_qdd_0_3 = link3_I3 * neg_Omega_link3_yy - c_joint4 * neg_M_link4_x;
  const Scalar neg_qdd_0_4 = neg_qdd_0_3 - s_joint4 * M_link4_y;
  const Scalar t_link1_9 = s_joint4 * (neg_M_link4_x - t_link5_5 * t_link1_3);
  const Scalar t_link1_10 = neg_Omega_link2_yy * t_link1_4 - t_link1_9;
  const Scalar t_link1_11 = t_link1_10 + neg_s_link4_x * t_link4_39;
  const Scalar t_link1_12 = t_link1_11 - neg_Omega_link1_xx * t_link1_5;
  const Scalar t_link1_13 = t_link1_12 - t_link3_1 * neg_a_link3_y;
  const Scalar t_link1_14 = t_link1_13 + neg_s_link4_y * t_link4_12 + c_joint4 * M_link4_y;
  const Scalar t_link1_15 = t_link1_14 - t_link4_27 * t_link1_6;
  const Scalar t_link1_16 = tau[2] - t_link1_15 - t_link1_1 * t_link5_6;
  const Scalar t_link1_17 = tau[1] - t_link1_15 + s_joint2 * (link2_G2 - link3_l1 * F_link3_x);
  const Scalar t_link1_18 = t_link1_17 - c_joint2 * t_link1_8;
  const Scalar t_link1_19 = t_link1_18 + neg_Omega_link1_xx * t_link2_2;
  const Scalar t_link1_20 = t_link1_19 + t_link3_12 * t_link1_7 - t_link3_14 * t_link1_16;
  const Scalar t_link1_21 = t_link1_20 - t_link1_1 * t_link5_8;
  const Scalar neg_qdd_0_5 = tau[0] - neg_Omega_link2_yy * neg_qdd_0_1;
  const Scalar neg_qdd_0_6 = neg_qdd_0_5 - t_link2_2 * Omega_link2_zy;
  const Scalar neg_qdd_0_7 = neg_qdd_0_6 - t_link3_1 * neg_a_link3_z;
  const Scalar neg_qdd_0_8 = neg_qdd_0_7 + c_joint2_joint3 * neg_M_link4_z;
  const Scalar neg_qdd_0_9 = neg_qdd_0_8 + t_link4_32 * t_link1_6;
  const Scalar neg_qdd_0_10 = neg_qdd_0_9 - t_link1_2 * t_link6_10;
  const Scalar neg_qdd_0_11 = neg_qdd_0_10 - Omega_link3_zy * t_link1_5;
  const Scalar neg_qdd_0_12 = neg_qdd_0_11 + s_joint2_joint3 * neg_qdd_0_4;
  const Scalar neg_qdd_0_13 = neg_qdd_0_12 + t_link3_8 * neg_qdd_0_2;
  const Scalar neg_qdd_0_14 = neg_qdd_0_13 - t_link1_1 * t_link5_7 - link2_l1 * F_link3_x;
  const Scalar neg_qdd_0_15 = neg_qdd_0_14 + t_link2_4 * t_link1_21;
  const Scalar neg_qdd_0 = neg_inverse_pivot_link1 * (neg_qdd_0_15 + t_link3_15 * t_link1_16);
  qdd[0] = -neg_qdd_0;
  const Scalar qdd_1 = inverse_pivot_link2 * (t_link1_21 - t_link3_18 * neg_qdd_0);
  qdd[1] = qdd_1;
  const Scalar qdd_2_1 = inverse_pivot_link3 * t_link1_16 - t_link3_15 * neg_qdd_0;
  const Scalar qdd_2 = qdd_2_1 - t_link3_14 * qdd_1;
  qdd[2] = qdd_2;
  const Scalar qdd_3_1 = t_link1_7 + t_link4_36 * qdd_1 - t_link4_32 * neg_qdd_0;
  const Scalar qdd_3 = qdd_3_1 + t_link4_27 * qdd_2;
  qdd[3] = qdd_3;
  const Scalar qdd_5_1 = t_link1_3 - t_link6_1 * (qdd_1 + qdd_2) + t_link6_10 * neg_qdd_0;
  qdd[5] = qdd_5_1 - c_joint5 * qdd_3;
  const Scalar qdd_4_1 = link5_p1 * (t_link1_1 - t_link3_7 * qdd_1) - t_link5_6 * qdd_2;
  qdd[4] = qdd_4_1 + t_link5_7 * neg_qdd_0;
}

}  // namespace puma560
