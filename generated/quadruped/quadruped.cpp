// quadruped.cpp: see quadruped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate quadruped.yaml

#include "quadruped.hpp"

namespace quadruped {

static_assert(kDigest == 0x749f8c7694de2f85ULL, "header and source are of different runs");
static_assert(sizeof(1.0) == sizeof(double), "not for -fsingle-precision-constant");
// Zeros, where compilers may store neighbours at once.
namespace {

[[gnu::noinline]] void mass_matrix_0(Scalar A[144]) noexcept {
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

[[gnu::noinline]] void force_jacobian_transpose_0(Scalar C[144]) noexcept {
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

// m: offset x of front_left_hip, front_right_hip, hind_left_hip, hind_right_hip
constexpr double front_left_hip_l1 = 0.19;
// m: offset y of front_left_hip, front_right_hip, hind_left_hip, hind_right_hip
constexpr double front_left_hip_l2 = 0.049;
// kg m^2: mass, com y, inertia xx of front_left_hip, front_right_hip, hind_left_hip,
//     hind_right_hip; mass, com y z, inertia xx, offset y of front_left_thigh, front_right_thigh,
//     hind_left_thigh, hind_right_thigh; mass, com z, inertia xx, offset z of front_left_shank,
//     front_right_shank, hind_left_shank, hind_right_shank
constexpr double front_left_hip_I1 = 0.01069944;
// N m: gravity; mass, com y of front_left_hip, front_right_hip, hind_left_hip, hind_right_hip;
//     mass, com y, offset y of front_left_thigh, front_right_thigh, hind_left_thigh,
//     hind_right_thigh; mass of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_hip_G1 = -0.7147566;

// m: offset y of front_left_thigh, front_right_thigh, hind_left_thigh, hind_right_thigh
constexpr double front_left_thigh_l1 = 0.062;
// kg m^2: mass, com z, inertia xx zz of front_left_thigh, front_right_thigh, hind_left_thigh,
//     hind_right_thigh; mass, offset z of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_thigh_I1 = 0.004624184;
// kg m^2: inertia xz of front_left_thigh, front_right_thigh, hind_left_thigh, hind_right_thigh
constexpr double front_left_thigh_I2 = 2.6e-05;
// kg m^2: mass, com y z, inertia yz, offset y of front_left_thigh, front_right_thigh,
//     hind_left_thigh, hind_right_thigh; mass, offset z of front_left_shank, front_right_shank,
//     hind_left_shank, hind_right_shank
constexpr double front_left_thigh_I3 = -0.001819852;
// kg m^2: inertia xy of front_left_thigh, front_right_thigh, hind_left_thigh, hind_right_thigh
constexpr double front_left_thigh_I4 = 0.000245;
// kg m^2: mass, com z, inertia yy of front_left_thigh, front_right_thigh, hind_left_thigh,
//     hind_right_thigh; mass, com z, inertia yy, offset z of front_left_shank, front_right_shank,
//     hind_left_shank, hind_right_shank
constexpr double front_left_thigh_I5 = 0.005638328;
// kg m^2: inertia xz of front_left_thigh, front_right_thigh, hind_left_thigh, hind_right_thigh
constexpr double front_left_thigh_I6 = 1.3e-05;
// kg m^2: mass, com z, inertia yy of front_left_thigh, front_right_thigh, hind_left_thigh,
//     hind_right_thigh; mass, offset z of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_thigh_I7 = 0.005152184;
// N m: gravity; mass, com z of front_left_thigh, front_right_thigh, hind_left_thigh,
//     hind_right_thigh; mass, offset z of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_thigh_G1 = 0.25560936;

// ratio: offset y of front_left_thigh, front_right_thigh, hind_left_thigh, hind_right_thigh; mass,
//     com z, inertia yy of front_left_shank, front_right_shank, hind_left_shank, hind_right_shank
constexpr double front_left_shank_k1 = -0.4978936282253818;
// m: offset z of front_left_shank, front_right_shank, hind_left_shank, hind_right_shank
constexpr double front_left_shank_l1 = -0.209;
// m: points of front_left_shank, front_right_shank, hind_left_shank, hind_right_shank
constexpr double front_left_shank_l2 = -0.175;
// kg m^2: mass, com z, inertia yy of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_I1 = 0.000486144;
// kg m^2: offset y of front_left_thigh, front_right_thigh, hind_left_thigh, hind_right_thigh; mass,
//     com z of front_left_shank, front_right_shank, hind_left_shank, hind_right_shank
constexpr double front_left_shank_I2 = -0.000242048;
// kg m^2: mass, com z, inertia xx zz of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_I3 = 0.000477144;
// kg m^2: mass, com z, offset z of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_I4 = 0.001631872;
// kg m^2: mass, com z, offset z of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_I5 = 0.000815936;
// kg m^2: mass, com z, inertia xx zz of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_I6 = 0.000954288;
// kg m^2: offset y of front_left_thigh, front_right_thigh, hind_left_thigh, hind_right_thigh; mass,
//     com z, inertia xx yy zz of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_I7 = 0.0005976581569246972;
// N m: gravity; mass, com z of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_G1 = 0.03829824;
// kg^-1 m^-2: mass, com z, inertia yy of front_left_shank, front_right_shank, hind_left_shank,
//     hind_right_shank
constexpr double front_left_shank_p1 = 2057.0036861506055;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

void mass_matrix(const Scalar q[12], Scalar A[144]) noexcept {
  const Scalar q_q1_q2 = q[1] + q[2];
  const Scalar q_q4_q5 = q[4] + q[5];
  const Scalar q_q7_q8 = q[7] + q[8];
  // hind_right_shank: A of (2)
  const Scalar q_q10_q11 = q[10] + q[11];
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q_q1_q2, q[1], q_q4_q5, q[4]);
  sines_cosines(sines + 4, cosines + 4, q_q7_q8, q[7], q_q10_q11, q[10]);
  const Scalar s_q1_q2 = sines[0];
  const Scalar c_q1_q2 = cosines[0];
  const Scalar s_front_left_hip = sines[1];
  const Scalar c_front_left_hip = cosines[1];
  const Scalar s_q4_q5 = sines[2];
  const Scalar c_q4_q5 = cosines[2];
  const Scalar s_front_right_hip = sines[3];
  const Scalar c_front_right_hip = cosines[3];
  const Scalar s_q7_q8 = sines[4];
  const Scalar c_q7_q8 = cosines[4];
  const Scalar s_hind_left_hip = sines[5];
  const Scalar c_hind_left_hip = cosines[5];
  const Scalar s_q10_q11 = sines[6];
  const Scalar c_q10_q11 = cosines[6];
  const Scalar s_hind_right_hip = sines[7];
  const Scalar c_hind_right_hip = cosines[7];
  const Scalar t_hind_right_shank_1 = s_q10_q11 * s_hind_right_hip;
  const Scalar t_hind_right_shank_2 = c_q10_q11 * c_hind_right_hip;
  const Scalar t_hind_right_shank_3 = front_left_shank_I4 * t_hind_right_shank_2;
  const Scalar A_119 = front_left_shank_I2 * s_q10_q11;
  A[119] = A_119;
  A[141] = A[119];
  // hind_right_thigh: inertia I of (2)
  const Scalar t_hind_right_thigh_1 = A_119 + front_left_thigh_I3 * s_hind_right_hip;
  A[118] = t_hind_right_thigh_1 + front_left_thigh_I4 * c_hind_right_hip;
  A[129] = A[118];
  const Scalar t_hind_right_thigh_2 = front_left_thigh_I5 + t_hind_right_shank_3;
  A[130] = t_hind_right_thigh_2 + front_left_shank_I4 * t_hind_right_shank_1;
  const Scalar I_hind_right_hip_zz_1 = front_left_thigh_I1 * s_hind_right_hip;
  const Scalar I_hind_right_hip_zz_2 = front_left_hip_I1 + t_hind_right_shank_3;
  const Scalar I_hind_right_hip_zz_3 = s_q10_q11 * s_q10_q11;
  const Scalar I_hind_right_hip_zz_4 =
      I_hind_right_hip_zz_1 + front_left_thigh_I2 * c_hind_right_hip;
  const Scalar I_hind_right_hip_zz_5 =
      I_hind_right_hip_zz_2 - front_left_shank_I3 * I_hind_right_hip_zz_3;
  A[117] = I_hind_right_hip_zz_5 - s_hind_right_hip * I_hind_right_hip_zz_4;
  // hind_left_shank: A of (2)
  const Scalar t_hind_left_shank_1 = s_q7_q8 * s_hind_left_hip;
  const Scalar t_hind_left_shank_2 = c_q7_q8 * c_hind_left_hip;
  const Scalar t_hind_left_shank_3 = front_left_shank_I4 * t_hind_left_shank_2;
  const Scalar neg_A_80 = front_left_shank_I2 * s_q7_q8;
  A[80] = -neg_A_80;
  A[102] = A[80];
  // hind_left_thigh: inertia I of (2)
  const Scalar t_hind_left_thigh_1 = neg_A_80 + front_left_thigh_I4 * c_hind_left_hip;
  A[79] = -(t_hind_left_thigh_1 + front_left_thigh_I3 * s_hind_left_hip);
  A[90] = A[79];
  const Scalar I_hind_left_thigh_zz_1 = front_left_thigh_I5 + t_hind_left_shank_3;
  A[91] = I_hind_left_thigh_zz_1 + front_left_shank_I4 * t_hind_left_shank_1;
  const Scalar I_hind_left_hip_zz_1 = front_left_thigh_I1 * s_hind_left_hip;
  const Scalar I_hind_left_hip_zz_2 = front_left_hip_I1 + t_hind_left_shank_3;
  const Scalar I_hind_left_hip_zz_3 = s_q7_q8 * s_q7_q8;
  const Scalar I_hind_left_hip_zz_4 = I_hind_left_hip_zz_1 + front_left_thigh_I2 * c_hind_left_hip;
  const Scalar I_hind_left_hip_zz_5 =
      I_hind_left_hip_zz_2 - front_left_shank_I3 * I_hind_left_hip_zz_3;
  A[78] = I_hind_left_hip_zz_5 - s_hind_left_hip * I_hind_left_hip_zz_4;
  // front_right_shank: A of (2)
  const Scalar t_fron_righ_shan_1 = c_q4_q5 * c_front_right_hip;
  const Scalar t_fron_righ_shan_2 = front_left_shank_I4 * t_fron_righ_shan_1;
  const Scalar t_fron_righ_shan_3 = s_q4_q5 * s_front_right_hip;
  const Scalar A_41 = front_left_shank_I2 * s_q4_q5;
  A[41] = A_41;
  A[63] = A[41];
  // front_right_thigh: inertia I of (2)
  const Scalar I_fron_righ_thig_yz_1 = A_41 + front_left_thigh_I3 * s_front_right_hip;
  A[40] = I_fron_righ_thig_yz_1 + front_left_thigh_I4 * c_front_right_hip;
  A[51] = A[40];
  const Scalar I_fron_righ_thig_zz_1 = front_left_thigh_I5 + t_fron_righ_shan_2;
  A[52] = I_fron_righ_thig_zz_1 + front_left_shank_I4 * t_fron_righ_shan_3;
  const Scalar I_front_right_hip_zz_1 = front_left_thigh_I2 * c_front_right_hip;
  const Scalar I_front_right_hip_zz_2 = front_left_hip_I1 + t_fron_righ_shan_2;
  const Scalar I_front_right_hip_zz_3 = s_q4_q5 * s_q4_q5;
  const Scalar I_front_right_hip_zz_4 =
      I_front_right_hip_zz_1 + front_left_thigh_I1 * s_front_right_hip;
  const Scalar I_front_right_hip_zz_5 =
      I_front_right_hip_zz_2 - front_left_shank_I3 * I_front_right_hip_zz_3;
  A[39] = I_front_right_hip_zz_5 - s_front_right_hip * I_front_right_hip_zz_4;
  // front_left_shank: A of (2)
  const Scalar t_front_left_shank_1 = s_q1_q2 * s_front_left_hip;
  const Scalar t_front_left_shank_2 = c_q1_q2 * c_front_left_hip;
  const Scalar t_front_left_shank_3 = front_left_shank_I4 * t_front_left_shank_2;
  const Scalar neg_A_2 = front_left_shank_I2 * s_q1_q2;
  A[2] = -neg_A_2;
  A[24] = A[2];
  // front_left_thigh: inertia I of (2)
  const Scalar neg_A_1_1 = neg_A_2 + front_left_thigh_I3 * s_front_left_hip;
  A[1] = -(neg_A_1_1 + front_left_thigh_I4 * c_front_left_hip);
  A[12] = A[1];
  const Scalar t_front_left_thigh_1 = front_left_thigh_I5 + t_front_left_shank_3;
  A[13] = t_front_left_thigh_1 + front_left_shank_I4 * t_front_left_shank_1;
  const Scalar I_front_left_hip_zz_1 = front_left_thigh_I2 * c_front_left_hip;
  const Scalar I_front_left_hip_zz_2 = front_left_hip_I1 + t_front_left_shank_3;
  const Scalar I_front_left_hip_zz_3 = s_q1_q2 * s_q1_q2;
  const Scalar I_front_left_hip_zz_4 =
      I_front_left_hip_zz_1 + front_left_thigh_I1 * s_front_left_hip;
  const Scalar I_front_left_hip_zz_5 =
      I_front_left_hip_zz_2 - front_left_shank_I3 * I_front_left_hip_zz_3;
  A[0] = I_front_left_hip_zz_5 - s_front_left_hip * I_front_left_hip_zz_4;
  const Scalar A_131_1 = t_hind_right_shank_1 + t_hind_right_shank_2;
  A[131] = front_left_shank_I1 + front_left_shank_I5 * A_131_1;
  A[142] = A[131];
  const Scalar A_92_1 = t_hind_left_shank_1 + t_hind_left_shank_2;
  A[92] = front_left_shank_I1 + front_left_shank_I5 * A_92_1;
  A[103] = A[92];
  const Scalar A_53_1 = t_fron_righ_shan_1 + t_fron_righ_shan_3;
  A[53] = front_left_shank_I1 + front_left_shank_I5 * A_53_1;
  A[64] = A[53];
  // front_left_shank: A of (2)
  const Scalar A_14_1 = t_front_left_shank_1 + t_front_left_shank_2;
  A[14] = front_left_shank_I1 + front_left_shank_I5 * A_14_1;
  A[25] = A[14];
  A[26] = front_left_shank_I1;
  A[65] = front_left_shank_I1;
  A[104] = front_left_shank_I1;
  A[143] = front_left_shank_I1;
  mass_matrix_0(A);
}

void bias_force(const Scalar q[12], const Scalar qd[12], Scalar B[12]) noexcept {
  const Scalar q_q1_q2 = q[1] + q[2];
  const Scalar q_q4_q5 = q[4] + q[5];
  const Scalar q_q7_q8 = q[7] + q[8];
  const Scalar q_q10_q11 = q[10] + q[11];
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[1], q[4], q[7], q[10]);
  sines_cosines(sines + 4, cosines + 4, q_q1_q2, q_q4_q5, q_q7_q8, q_q10_q11);
  const Scalar s_front_left_hip = sines[0];
  const Scalar c_front_left_hip = cosines[0];
  const Scalar s_front_right_hip = sines[1];
  const Scalar c_front_right_hip = cosines[1];
  const Scalar s_hind_left_hip = sines[2];
  const Scalar c_hind_left_hip = cosines[2];
  const Scalar s_hind_right_hip = sines[3];
  const Scalar c_hind_right_hip = cosines[3];
  const Scalar s_q1_q2 = sines[4];
  const Scalar c_q1_q2 = cosines[4];
  const Scalar s_q4_q5 = sines[5];
  const Scalar c_q4_q5 = cosines[5];
  const Scalar s_q7_q8 = sines[6];
  const Scalar c_q7_q8 = cosines[6];
  const Scalar s_q10_q11 = sines[7];
  const Scalar c_q10_q11 = cosines[7];
  // front_left_shank: angular velocity omega, Omega, moment M of (3)
  const Scalar omega_front_left_shank_z = qd[1] + qd[2];
  const Scalar t_front_left_shank_1 = omega_front_left_shank_z * omega_front_left_shank_z;
  const Scalar t_front_left_shank_2 = s_front_left_hip * c_q1_q2 * front_left_shank_I5;
  const Scalar t_front_left_shank_3 = c_front_left_hip * s_q1_q2 * front_left_shank_I5;
  const Scalar t_front_left_shank_4 = s_q1_q2 * c_q1_q2;
  const Scalar t_front_left_shank_5 =
      t_front_left_shank_3 + front_left_shank_I3 * t_front_left_shank_4;
  const Scalar t_front_left_hip_1 = qd[0] * qd[0];
  const Scalar t_front_left_shank_6 = t_front_left_shank_2 - t_front_left_shank_3;
  const Scalar t_front_left_thigh_1 = qd[1] * qd[1];
  const Scalar M_front_left_shank_z_1 = t_front_left_shank_6 * t_front_left_thigh_1;
  const Scalar M_front_left_shank_z =
      t_front_left_shank_5 * t_front_left_hip_1 - M_front_left_shank_z_1;
  B[2] = M_front_left_shank_z;
  // front_right_shank: angular velocity omega, Omega, moment M of (3)
  const Scalar omega_fron_righ_shan_z = qd[4] + qd[5];
  const Scalar t_fron_righ_shan_1 = omega_fron_righ_shan_z * omega_fron_righ_shan_z;
  const Scalar t_fron_righ_shan_2 = s_front_right_hip * c_q4_q5 * front_left_shank_I5;
  const Scalar t_fron_righ_shan_3 = c_front_right_hip * s_q4_q5 * front_left_shank_I5;
  const Scalar t_fron_righ_shan_4 = s_q4_q5 * c_q4_q5;
  const Scalar t_fron_righ_shan_5 = t_fron_righ_shan_3 + front_left_shank_I3 * t_fron_righ_shan_4;
  const Scalar t_front_right_hip_1 = qd[3] * qd[3];
  const Scalar t_fron_righ_shan_6 = t_fron_righ_shan_2 - t_fron_righ_shan_3;
  const Scalar t_fron_righ_thig_1 = qd[4] * qd[4];
  const Scalar M_fron_righ_shan_z_1 = t_fron_righ_shan_5 * t_front_right_hip_1;
  const Scalar M_fron_righ_shan_z = M_fron_righ_shan_z_1 - t_fron_righ_shan_6 * t_fron_righ_thig_1;
  B[5] = M_fron_righ_shan_z;
  // hind_left_shank: angular velocity omega, Omega, moment M of (3)
  const Scalar omega_hind_left_shank_z = qd[7] + qd[8];
  const Scalar t_hind_left_shank_1 = omega_hind_left_shank_z * omega_hind_left_shank_z;
  const Scalar t_hind_left_shank_2 = s_hind_left_hip * c_q7_q8 * front_left_shank_I5;
  const Scalar t_hind_left_shank_3 = c_hind_left_hip * s_q7_q8 * front_left_shank_I5;
  const Scalar t_hind_left_shank_4 = s_q7_q8 * c_q7_q8;
  const Scalar t_hind_left_shank_5 =
      t_hind_left_shank_3 + front_left_shank_I3 * t_hind_left_shank_4;
  const Scalar t_hind_left_hip_1 = qd[6] * qd[6];
  const Scalar t_hind_left_shank_6 = t_hind_left_shank_2 - t_hind_left_shank_3;
  const Scalar t_hind_left_thigh_1 = qd[7] * qd[7];
  const Scalar M_hind_left_shank_z_1 = t_hind_left_shank_6 * t_hind_left_thigh_1;
  const Scalar M_hind_left_shank_z =
      t_hind_left_shank_5 * t_hind_left_hip_1 - M_hind_left_shank_z_1;
  B[8] = M_hind_left_shank_z;
  // hind_right_shank: angular velocity omega, Omega, moment M of (3)
  const Scalar omega_hind_right_shank_z = qd[10] + qd[11];
  const Scalar t_hind_right_shank_1 = omega_hind_right_shank_z * omega_hind_right_shank_z;
  const Scalar t_hind_right_shank_2 = s_hind_right_hip * c_q10_q11 * front_left_shank_I5;
  const Scalar t_hind_right_shank_3 = c_hind_right_hip * s_q10_q11 * front_left_shank_I5;
  const Scalar t_hind_right_shank_4 = t_hind_right_shank_2 - t_hind_right_shank_3;
  const Scalar t_hind_right_thigh_1 = qd[10] * qd[10];
  const Scalar t_hind_right_shank_5 = s_q10_q11 * c_q10_q11;
  const Scalar t_hind_right_shank_6 =
      t_hind_right_shank_3 + front_left_shank_I3 * t_hind_right_shank_5;
  const Scalar t_hind_right_hip_1 = qd[9] * qd[9];
  const Scalar t_hind_right_shank_7 = t_hind_right_shank_4 * t_hind_right_thigh_1;
  const Scalar neg_M_hind_right_shank_z =
      t_hind_right_shank_7 - t_hind_right_shank_6 * t_hind_right_hip_1;
  B[11] = -neg_M_hind_right_shank_z;
  // hind_right_thigh: moment M of (3)
  const Scalar t_hind_right_thigh_2 = front_left_thigh_I1 * s_hind_right_hip;
  const Scalar t_hind_right_thigh_3 = t_hind_right_thigh_2 + front_left_thigh_I2 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_4 = front_left_thigh_I6 - t_hind_right_shank_2;
  const Scalar t_hind_right_thigh_5 =
      t_hind_right_thigh_4 - c_hind_right_hip * t_hind_right_thigh_3;
  const Scalar M_hind_right_thigh_y_1 = omega_hind_right_shank_z * t_hind_right_shank_6;
  const Scalar M_hind_right_thigh_y_2 = front_left_thigh_I4 * s_hind_right_hip;
  const Scalar M_hind_right_thigh_y_3 = qd[10] * t_hind_right_thigh_5 - M_hind_right_thigh_y_1;
  const Scalar M_hind_right_thigh_y_4 = c_q10_q11 * t_hind_right_shank_1 * front_left_shank_I2;
  const Scalar M_hind_right_thigh_y_5 = qd[9] * M_hind_right_thigh_y_3;
  const Scalar M_hind_right_thigh_y_6 =
      M_hind_right_thigh_y_2 - front_left_thigh_I3 * c_hind_right_hip;
  const Scalar M_hind_right_thigh_y_7 = M_hind_right_thigh_y_4 + 2.0 * M_hind_right_thigh_y_5;
  B[9] = M_hind_right_thigh_y_7 - t_hind_right_thigh_1 * M_hind_right_thigh_y_6;
  const Scalar t_hind_right_shank_8 =
      neg_M_hind_right_shank_z + t_hind_right_hip_1 * t_hind_right_thigh_5;
  B[10] = t_hind_right_shank_1 * t_hind_right_shank_4 - t_hind_right_shank_8;
  const Scalar t_hind_left_thigh_2 = front_left_thigh_I1 * s_hind_left_hip;
  const Scalar t_hind_left_thigh_3 = t_hind_left_thigh_2 + front_left_thigh_I2 * c_hind_left_hip;
  // hind_left_shank: moment M of (3)
  const Scalar t_hind_left_shank_7 = front_left_thigh_I6 - t_hind_left_shank_2;
  const Scalar t_hind_left_shank_8 = t_hind_left_shank_7 - c_hind_left_hip * t_hind_left_thigh_3;
  const Scalar t_hind_left_shank_9 = omega_hind_left_shank_z * t_hind_left_shank_5;
  const Scalar t_hind_left_thigh_4 = front_left_thigh_I4 * s_hind_left_hip;
  const Scalar t_hind_left_shank_10 = qd[7] * t_hind_left_shank_8 - t_hind_left_shank_9;
  const Scalar t_hind_left_shank_11 = c_q7_q8 * t_hind_left_shank_1 * front_left_shank_I2;
  const Scalar t_hind_left_thigh_5 = t_hind_left_thigh_4 - front_left_thigh_I3 * c_hind_left_hip;
  const Scalar t_hind_left_shank_12 = t_hind_left_shank_11 - qd[6] * t_hind_left_shank_10 * 2.0;
  // hind_left_thigh: moment M of (3)
  B[6] = t_hind_left_thigh_1 * t_hind_left_thigh_5 - t_hind_left_shank_12;
  const Scalar M_hind_left_thigh_z_1 =
      M_hind_left_shank_z + t_hind_left_shank_1 * t_hind_left_shank_6;
  B[7] = M_hind_left_thigh_z_1 - t_hind_left_hip_1 * t_hind_left_shank_8;
  // front_right_thigh: moment M of (3)
  const Scalar t_fron_righ_thig_2 = front_left_thigh_I2 * c_front_right_hip;
  const Scalar t_fron_righ_thig_3 = t_fron_righ_thig_2 + front_left_thigh_I1 * s_front_right_hip;
  const Scalar t_fron_righ_thig_4 = front_left_thigh_I6 - t_fron_righ_shan_2;
  const Scalar t_fron_righ_thig_5 = t_fron_righ_thig_4 - c_front_right_hip * t_fron_righ_thig_3;
  const Scalar M_fron_righ_thig_y_1 = omega_fron_righ_shan_z * t_fron_righ_shan_5;
  const Scalar M_fron_righ_thig_y_2 = front_left_thigh_I4 * s_front_right_hip;
  const Scalar M_fron_righ_thig_y_3 = qd[4] * t_fron_righ_thig_5 - M_fron_righ_thig_y_1;
  const Scalar M_fron_righ_thig_y_4 = c_q4_q5 * t_fron_righ_shan_1 * front_left_shank_I2;
  const Scalar M_fron_righ_thig_y_5 = qd[3] * M_fron_righ_thig_y_3;
  const Scalar M_fron_righ_thig_y_6 =
      M_fron_righ_thig_y_2 - front_left_thigh_I3 * c_front_right_hip;
  const Scalar M_fron_righ_thig_y_7 = M_fron_righ_thig_y_4 + 2.0 * M_fron_righ_thig_y_5;
  B[3] = M_fron_righ_thig_y_7 - t_fron_righ_thig_1 * M_fron_righ_thig_y_6;
  const Scalar M_fron_righ_thig_z_1 = M_fron_righ_shan_z + t_fron_righ_shan_1 * t_fron_righ_shan_6;
  B[4] = M_fron_righ_thig_z_1 - t_front_right_hip_1 * t_fron_righ_thig_5;
  const Scalar t_front_left_thigh_2 = front_left_thigh_I2 * c_front_left_hip;
  const Scalar t_front_left_thigh_3 = t_front_left_thigh_2 + front_left_thigh_I1 * s_front_left_hip;
  // front_left_shank: moment M of (3)
  const Scalar t_front_left_shank_7 = front_left_thigh_I6 - t_front_left_shank_2;
  const Scalar t_front_left_shank_8 =
      t_front_left_shank_7 - c_front_left_hip * t_front_left_thigh_3;
  const Scalar t_front_left_shank_9 = omega_front_left_shank_z * t_front_left_shank_5;
  const Scalar t_front_left_thigh_4 = front_left_thigh_I3 * c_front_left_hip;
  const Scalar t_front_left_shank_10 = t_front_left_shank_9 - qd[1] * t_front_left_shank_8;
  const Scalar t_front_left_shank_11 = c_q1_q2 * t_front_left_shank_1 * front_left_shank_I2;
  const Scalar t_front_left_shank_12 = qd[0] * t_front_left_shank_10;
  const Scalar t_front_left_thigh_5 = t_front_left_thigh_4 - front_left_thigh_I4 * s_front_left_hip;
  const Scalar t_front_left_shank_13 = t_front_left_shank_11 + 2.0 * t_front_left_shank_12;
  // front_left_thigh: moment M of (3)
  B[0] = -(t_front_left_shank_13 + t_front_left_thigh_1 * t_front_left_thigh_5);
  const Scalar M_front_left_thigh_z_1 =
      M_front_left_shank_z - t_front_left_hip_1 * t_front_left_shank_8;
  B[1] = M_front_left_thigh_z_1 + t_front_left_shank_1 * t_front_left_shank_6;
}

void gravity_force(const Scalar q[12], Scalar G[12]) noexcept {
  const Scalar q_q10_q11 = q[10] + q[11];
  const Scalar q_q7_q8 = q[7] + q[8];
  const Scalar q_q4_q5 = q[4] + q[5];
  const Scalar q_q1_q2 = q[1] + q[2];
  Scalar sines[12];
  Scalar cosines[12];
  sines_cosines(sines, cosines, q[0], q[1], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[6], q[7], q[9], q[10]);
  sines_cosines(sines + 8, cosines + 8, q_q10_q11, q_q7_q8, q_q4_q5, q_q1_q2);
  const Scalar s_front_left_abduction = sines[0];
  const Scalar c_front_left_abduction = cosines[0];
  const Scalar s_front_left_hip = sines[1];
  const Scalar c_front_left_hip = cosines[1];
  const Scalar s_front_right_abduction = sines[2];
  const Scalar c_front_right_abduction = cosines[2];
  const Scalar s_front_right_hip = sines[3];
  const Scalar c_front_right_hip = cosines[3];
  const Scalar s_hind_left_abduction = sines[4];
  const Scalar c_hind_left_abduction = cosines[4];
  const Scalar s_hind_left_hip = sines[5];
  const Scalar c_hind_left_hip = cosines[5];
  const Scalar s_hind_right_abduction = sines[6];
  const Scalar c_hind_right_abduction = cosines[6];
  const Scalar s_hind_right_hip = sines[7];
  const Scalar c_hind_right_hip = cosines[7];
  const Scalar s_q10_q11 = sines[8];
  const Scalar c_q10_q11 = cosines[8];
  const Scalar s_q7_q8 = sines[9];
  const Scalar c_q7_q8 = cosines[9];
  const Scalar s_q4_q5 = sines[10];
  const Scalar c_q4_q5 = cosines[10];
  const Scalar s_q1_q2 = sines[11];
  const Scalar c_q1_q2 = cosines[11];
  const Scalar G_11 = c_hind_right_abduction * s_q10_q11 * front_left_shank_G1;
  G[11] = G_11;
  G[10] = G_11 + c_hind_right_abduction * s_hind_right_hip * front_left_thigh_G1;
  const Scalar G_9_1 = front_left_shank_G1 * c_q10_q11 + front_left_thigh_G1 * c_hind_right_hip;
  G[9] = front_left_hip_G1 * c_hind_right_abduction + s_hind_right_abduction * G_9_1;
  const Scalar G_8 = c_hind_left_abduction * s_q7_q8 * front_left_shank_G1;
  G[8] = G_8;
  G[7] = G_8 + c_hind_left_abduction * s_hind_left_hip * front_left_thigh_G1;
  const Scalar neg_G_6_1 = front_left_shank_G1 * c_q7_q8 + front_left_thigh_G1 * c_hind_left_hip;
  G[6] = s_hind_left_abduction * neg_G_6_1 - front_left_hip_G1 * c_hind_left_abduction;
  const Scalar G_5 = c_front_right_abduction * s_q4_q5 * front_left_shank_G1;
  G[5] = G_5;
  G[4] = G_5 + c_front_right_abduction * s_front_right_hip * front_left_thigh_G1;
  const Scalar G_3_1 = front_left_shank_G1 * c_q4_q5 + front_left_thigh_G1 * c_front_right_hip;
  G[3] = front_left_hip_G1 * c_front_right_abduction + s_front_right_abduction * G_3_1;
  const Scalar G_2 = c_front_left_abduction * s_q1_q2 * front_left_shank_G1;
  G[2] = G_2;
  G[1] = G_2 + c_front_left_abduction * s_front_left_hip * front_left_thigh_G1;
  // front_left_hip: G of 6.5
  const Scalar neg_G_0_1 = front_left_shank_G1 * c_q1_q2 + front_left_thigh_G1 * c_front_left_hip;
  G[0] = s_front_left_abduction * neg_G_0_1 - front_left_hip_G1 * c_front_left_abduction;
}

void inverse_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar qdd[12],
                      Scalar tau[12]) noexcept {
  const Scalar q_q1_q2 = q[1] + q[2];
  const Scalar q_q4_q5 = q[4] + q[5];
  const Scalar q_q7_q8 = q[7] + q[8];
  const Scalar q_q10_q11 = q[10] + q[11];
  Scalar sines[12];
  Scalar cosines[12];
  sines_cosines(sines, cosines, q[0], q[1], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[6], q[7], q[9], q[10]);
  sines_cosines(sines + 8, cosines + 8, q_q1_q2, q_q4_q5, q_q7_q8, q_q10_q11);
  const Scalar s_front_left_abduction = sines[0];
  const Scalar c_front_left_abduction = cosines[0];
  const Scalar s_front_left_hip = sines[1];
  const Scalar c_front_left_hip = cosines[1];
  const Scalar s_front_right_abduction = sines[2];
  const Scalar c_front_right_abduction = cosines[2];
  const Scalar s_front_right_hip = sines[3];
  const Scalar c_front_right_hip = cosines[3];
  const Scalar s_hind_left_abduction = sines[4];
  const Scalar c_hind_left_abduction = cosines[4];
  const Scalar s_hind_left_hip = sines[5];
  const Scalar c_hind_left_hip = cosines[5];
  const Scalar s_hind_right_abduction = sines[6];
  const Scalar c_hind_right_abduction = cosines[6];
  const Scalar s_hind_right_hip = sines[7];
  const Scalar c_hind_right_hip = cosines[7];
  const Scalar s_q1_q2 = sines[8];
  const Scalar c_q1_q2 = cosines[8];
  const Scalar s_q4_q5 = sines[9];
  const Scalar c_q4_q5 = cosines[9];
  const Scalar s_q7_q8 = sines[10];
  const Scalar c_q7_q8 = cosines[10];
  const Scalar s_q10_q11 = sines[11];
  const Scalar c_q10_q11 = cosines[11];
  const Scalar t_front_left_thigh_1 = front_left_thigh_I2 * c_front_left_hip;
  const Scalar t_front_left_thigh_2 = t_front_left_thigh_1 + front_left_thigh_I1 * s_front_left_hip;
  // front_left_shank: angular velocity omega, moment M, angular acceleration alpha of (1)
  const Scalar omega_front_left_shank_z = qd[1] + qd[2];
  const Scalar t_front_left_shank_1 = front_left_shank_I3 * s_q1_q2;
  const Scalar t_front_left_shank_2 = front_left_shank_I5 * c_front_left_hip;
  const Scalar t_front_left_shank_3 = c_q1_q2 * t_front_left_shank_2;
  const Scalar t_front_left_shank_4 = qdd[1] * t_front_left_shank_3;
  const Scalar t_front_left_shank_5 = s_q1_q2 * t_front_left_shank_2;
  const Scalar t_front_left_shank_6 = t_front_left_shank_5 + c_q1_q2 * t_front_left_shank_1;
  const Scalar t_front_left_hip_1 = qd[0] * qd[0];
  const Scalar t_front_left_shank_7 = front_left_shank_I5 * s_front_left_hip;
  const Scalar M_front_left_shank_z_1 = front_left_shank_G1 * c_front_left_abduction;
  const Scalar M_front_left_shank_z_2 = M_front_left_shank_z_1 + qdd[1] * t_front_left_shank_7;
  const Scalar alpha_front_left_shank_z = qdd[1] + qdd[2];
  const Scalar t_front_left_shank_8 = c_q1_q2 * t_front_left_shank_7;
  const Scalar t_front_left_thigh_3 = qd[1] * qd[1];
  const Scalar M_front_left_shank_z_3 = M_front_left_shank_z_2 - front_left_shank_I2 * qdd[0];
  const Scalar M_front_left_shank_z_4 =
      t_front_left_shank_4 + t_front_left_shank_6 * t_front_left_hip_1;
  const Scalar M_front_left_shank_z_5 = M_front_left_shank_z_4 + s_q1_q2 * M_front_left_shank_z_3;
  const Scalar M_front_left_shank_z_6 = t_front_left_shank_5 - t_front_left_shank_8;
  const Scalar M_front_left_shank_z_7 =
      M_front_left_shank_z_5 + front_left_shank_I1 * alpha_front_left_shank_z;
  const Scalar M_front_left_shank_z =
      M_front_left_shank_z_7 + M_front_left_shank_z_6 * t_front_left_thigh_3;
  tau[2] = M_front_left_shank_z;
  const Scalar t_front_left_shank_9 = omega_front_left_shank_z * omega_front_left_shank_z;
  // front_right_shank: angular velocity omega, moment M, angular acceleration alpha of (1)
  const Scalar omega_fron_righ_shan_z = qd[4] + qd[5];
  const Scalar t_fron_righ_shan_1 = front_left_shank_I5 * c_front_right_hip;
  const Scalar t_fron_righ_shan_2 = c_q4_q5 * t_fron_righ_shan_1;
  const Scalar alpha_fron_righ_shan_z = qdd[4] + qdd[5];
  const Scalar t_fron_righ_shan_3 = s_q4_q5 * t_fron_righ_shan_1;
  const Scalar t_fron_righ_shan_4 = front_left_shank_I3 * s_q4_q5;
  const Scalar t_fron_righ_shan_5 = t_fron_righ_shan_3 + c_q4_q5 * t_fron_righ_shan_4;
  const Scalar t_front_right_hip_1 = qd[3] * qd[3];
  const Scalar t_fron_righ_shan_6 = front_left_shank_I5 * s_front_right_hip;
  const Scalar t_fron_righ_shan_7 = front_left_shank_G1 * c_front_right_abduction;
  const Scalar t_fron_righ_shan_8 = t_fron_righ_shan_7 + qdd[4] * t_fron_righ_shan_6;
  const Scalar t_fron_righ_thig_1 = qd[4] * qd[4];
  const Scalar t_fron_righ_shan_9 = c_q4_q5 * t_fron_righ_shan_6;
  const Scalar t_fron_righ_shan_10 = front_left_shank_I1 * alpha_fron_righ_shan_z;
  const Scalar t_fron_righ_shan_11 = t_fron_righ_shan_8 + front_left_shank_I2 * qdd[3];
  const Scalar t_fron_righ_shan_12 = t_fron_righ_shan_10 + t_fron_righ_shan_5 * t_front_right_hip_1;
  const Scalar t_fron_righ_shan_13 = t_fron_righ_shan_3 - t_fron_righ_shan_9;
  const Scalar t_fron_righ_shan_14 = t_fron_righ_shan_12 + s_q4_q5 * t_fron_righ_shan_11;
  const Scalar t_fron_righ_shan_15 = t_fron_righ_shan_14 + t_fron_righ_thig_1 * t_fron_righ_shan_13;
  tau[5] = t_fron_righ_shan_15 + qdd[4] * t_fron_righ_shan_2;
  const Scalar t_hind_left_hip_1 = qd[6] * qd[6];
  const Scalar t_hind_left_thigh_1 = qd[7] * qd[7];
  const Scalar omega_hind_left_shank_z = qd[7] + qd[8];
  const Scalar alpha_hind_left_shank_z = qdd[7] + qdd[8];
  const Scalar M_hind_left_shank_z_1 = t_hind_left_hip_1 + t_hind_left_thigh_1;
  // hind_left_shank: moment M of (1)
  const Scalar M_hind_left_shank_z_2 = c_hind_left_hip * M_hind_left_shank_z_1;
  const Scalar M_hind_left_shank_z_3 = front_left_shank_G1 * c_hind_left_abduction;
  const Scalar M_hind_left_shank_z_4 = s_hind_left_hip * qdd[7] + M_hind_left_shank_z_2;
  const Scalar M_hind_left_shank_z_5 = M_hind_left_shank_z_3 - front_left_shank_I2 * qdd[6];
  const Scalar t_hind_left_shank_1 = s_hind_left_hip * t_hind_left_thigh_1;
  const Scalar t_hind_left_shank_2 = front_left_shank_I3 * s_q7_q8;
  const Scalar M_hind_left_shank_z_6 = t_hind_left_shank_1 - c_hind_left_hip * qdd[7];
  const Scalar M_hind_left_shank_z_7 = front_left_shank_I5 * M_hind_left_shank_z_6;
  const Scalar M_hind_left_shank_z_8 =
      M_hind_left_shank_z_5 + front_left_shank_I5 * M_hind_left_shank_z_4;
  const Scalar M_hind_left_shank_z_9 =
      M_hind_left_shank_z_7 - t_hind_left_hip_1 * t_hind_left_shank_2;
  const Scalar M_hind_left_shank_z_10 = s_q7_q8 * M_hind_left_shank_z_8;
  const Scalar M_hind_left_shank_z_11 = M_hind_left_shank_z_10 - c_q7_q8 * M_hind_left_shank_z_9;
  const Scalar M_hind_left_shank_z =
      M_hind_left_shank_z_11 + front_left_shank_I1 * alpha_hind_left_shank_z;
  tau[8] = M_hind_left_shank_z;
  // hind_right_shank: angular velocity omega, angular acceleration alpha, moment M of (1)
  const Scalar omega_hind_right_shank_z = qd[10] + qd[11];
  const Scalar alpha_hind_right_shank_z = qdd[10] + qdd[11];
  const Scalar t_hind_right_shank_1 = front_left_shank_I3 * s_q10_q11;
  const Scalar t_hind_right_shank_2 = front_left_shank_I5 * c_hind_right_hip;
  const Scalar t_hind_right_shank_3 = c_q10_q11 * t_hind_right_shank_2;
  const Scalar t_hind_right_shank_4 = s_q10_q11 * t_hind_right_shank_2;
  const Scalar t_hind_right_shank_5 = t_hind_right_shank_4 + c_q10_q11 * t_hind_right_shank_1;
  const Scalar t_hind_right_hip_1 = qd[9] * qd[9];
  const Scalar t_hind_right_thigh_1 = qd[10] * qd[10];
  const Scalar t_hind_right_shank_6 = front_left_shank_I5 * s_hind_right_hip;
  const Scalar t_hind_right_shank_7 = c_q10_q11 * t_hind_right_shank_6;
  const Scalar M_hind_right_shank_z_1 = front_left_shank_G1 * c_hind_right_abduction;
  const Scalar M_hind_right_shank_z_2 = M_hind_right_shank_z_1 + front_left_shank_I2 * qdd[9];
  const Scalar M_hind_right_shank_z_3 = front_left_shank_I1 * alpha_hind_right_shank_z;
  const Scalar M_hind_right_shank_z_4 = M_hind_right_shank_z_3 + qdd[10] * t_hind_right_shank_3;
  const Scalar M_hind_right_shank_z_5 = t_hind_right_shank_4 - t_hind_right_shank_7;
  const Scalar M_hind_right_shank_z_6 =
      M_hind_right_shank_z_4 + t_hind_right_shank_5 * t_hind_right_hip_1;
  const Scalar M_hind_right_shank_z_7 = M_hind_right_shank_z_2 + qdd[10] * t_hind_right_shank_6;
  const Scalar M_hind_right_shank_z_8 =
      M_hind_right_shank_z_6 + t_hind_right_thigh_1 * M_hind_right_shank_z_5;
  const Scalar M_hind_right_shank_z = M_hind_right_shank_z_8 + s_q10_q11 * M_hind_right_shank_z_7;
  tau[11] = M_hind_right_shank_z;
  const Scalar t_hind_right_shank_8 = omega_hind_right_shank_z * omega_hind_right_shank_z;
  // hind_right_thigh: moment M of (1)
  const Scalar t_hind_right_thigh_2 = front_left_thigh_I3 * s_hind_right_hip;
  const Scalar t_hind_right_thigh_3 = t_hind_right_thigh_2 + front_left_thigh_I4 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_4 = alpha_hind_right_shank_z * s_q10_q11;
  const Scalar t_hind_right_thigh_5 = c_q10_q11 * t_hind_right_shank_8 + t_hind_right_thigh_4;
  const Scalar M_hind_right_thigh_z_1 = front_left_thigh_G1 * c_hind_right_abduction;
  const Scalar t_hind_right_thigh_6 = front_left_thigh_I1 * s_hind_right_hip;
  const Scalar t_hind_right_thigh_7 = t_hind_right_thigh_6 + front_left_thigh_I2 * c_hind_right_hip;
  const Scalar t_hind_right_thigh_8 = front_left_thigh_I6 - t_hind_right_shank_7;
  const Scalar t_hind_right_thigh_9 =
      t_hind_right_thigh_8 - c_hind_right_hip * t_hind_right_thigh_7;
  const Scalar M_hind_right_thigh_z_2 = M_hind_right_shank_z + front_left_thigh_I7 * qdd[10];
  const Scalar M_hind_right_thigh_z_3 =
      M_hind_right_thigh_z_2 - t_hind_right_shank_4 * t_hind_right_shank_8;
  const Scalar M_hind_right_thigh_z_4 =
      M_hind_right_thigh_z_3 + alpha_hind_right_shank_z * t_hind_right_shank_3;
  const Scalar M_hind_right_thigh_z_5 =
      M_hind_right_thigh_z_1 + front_left_shank_I5 * t_hind_right_thigh_5;
  const Scalar M_hind_right_thigh_z_6 = M_hind_right_thigh_z_4 + qdd[9] * t_hind_right_thigh_3;
  const Scalar M_hind_right_thigh_z_7 =
      M_hind_right_thigh_z_6 + s_hind_right_hip * M_hind_right_thigh_z_5;
  tau[10] = M_hind_right_thigh_z_7 - t_hind_right_hip_1 * t_hind_right_thigh_9;
  // hind_right_hip: moment M of (1)
  const Scalar M_hind_right_hip_z_1 = front_left_thigh_G1 * c_hind_right_hip;
  const Scalar M_hind_right_hip_z_2 = front_left_hip_I1 - s_q10_q11 * t_hind_right_shank_1;
  const Scalar M_hind_right_hip_z_3 = M_hind_right_hip_z_2 + 2.0 * t_hind_right_shank_3;
  const Scalar M_hind_right_hip_z_4 = omega_hind_right_shank_z * t_hind_right_shank_5;
  const Scalar M_hind_right_hip_z_5 = front_left_thigh_I4 * s_hind_right_hip;
  const Scalar M_hind_right_hip_z_6 = M_hind_right_hip_z_1 + front_left_shank_G1 * c_q10_q11;
  const Scalar M_hind_right_hip_z_7 = s_hind_right_abduction * M_hind_right_hip_z_6;
  const Scalar M_hind_right_hip_z_8 =
      M_hind_right_hip_z_3 - s_hind_right_hip * t_hind_right_thigh_7;
  const Scalar M_hind_right_hip_z_9 =
      front_left_hip_G1 * c_hind_right_abduction + M_hind_right_hip_z_7;
  const Scalar M_hind_right_hip_z_10 = qd[10] * t_hind_right_thigh_9 - M_hind_right_hip_z_4;
  const Scalar M_hind_right_hip_z_11 = M_hind_right_hip_z_9 + qdd[9] * M_hind_right_hip_z_8;
  const Scalar M_hind_right_hip_z_12 = qd[9] * M_hind_right_hip_z_10;
  const Scalar M_hind_right_hip_z_13 = M_hind_right_hip_z_11 + 2.0 * M_hind_right_hip_z_12;
  const Scalar M_hind_right_hip_z_14 =
      M_hind_right_hip_z_13 + front_left_shank_I2 * t_hind_right_thigh_5;
  const Scalar M_hind_right_hip_z_15 =
      M_hind_right_hip_z_5 - front_left_thigh_I3 * c_hind_right_hip;
  const Scalar M_hind_right_hip_z_16 = M_hind_right_hip_z_14 + qdd[10] * t_hind_right_thigh_3;
  tau[9] = M_hind_right_hip_z_16 - t_hind_right_thigh_1 * M_hind_right_hip_z_15;
  const Scalar t_hind_left_shank_3 = omega_hind_left_shank_z * omega_hind_left_shank_z;
  // hind_left_thigh: moment M, angular acceleration alpha of (1)
  const Scalar t_hind_left_thigh_2 = alpha_hind_left_shank_z * s_q7_q8;
  const Scalar t_hind_left_thigh_3 = c_q7_q8 * t_hind_left_shank_3 + t_hind_left_thigh_2;
  const Scalar M_hind_left_thigh_z_1 = t_hind_left_thigh_3 + t_hind_left_hip_1 * c_q7_q8;
  const Scalar M_hind_left_thigh_z_2 = front_left_shank_I5 * M_hind_left_thigh_z_1;
  const Scalar t_hind_left_thigh_4 = front_left_thigh_I4 * c_hind_left_hip;
  const Scalar t_hind_left_thigh_5 = t_hind_left_thigh_4 + front_left_thigh_I3 * s_hind_left_hip;
  const Scalar M_hind_left_thigh_z_3 = alpha_hind_left_shank_z * c_q7_q8;
  const Scalar t_hind_left_thigh_6 = front_left_thigh_I1 * s_hind_left_hip;
  const Scalar t_hind_left_thigh_7 = t_hind_left_thigh_6 + front_left_thigh_I2 * c_hind_left_hip;
  const Scalar t_hind_left_thigh_8 = front_left_thigh_I6 - c_hind_left_hip * t_hind_left_thigh_7;
  const Scalar M_hind_left_thigh_z_4 =
      front_left_thigh_G1 * c_hind_left_abduction + M_hind_left_thigh_z_2;
  const Scalar M_hind_left_thigh_z_5 = M_hind_left_shank_z + front_left_thigh_I7 * qdd[7];
  const Scalar M_hind_left_thigh_z_6 =
      M_hind_left_thigh_z_5 + s_hind_left_hip * M_hind_left_thigh_z_4;
  const Scalar M_hind_left_thigh_z_7 = s_q7_q8 * t_hind_left_shank_3 - M_hind_left_thigh_z_3;
  const Scalar M_hind_left_thigh_z_8 = c_hind_left_hip * M_hind_left_thigh_z_7;
  const Scalar M_hind_left_thigh_z_9 = M_hind_left_thigh_z_6 - qdd[6] * t_hind_left_thigh_5;
  const Scalar M_hind_left_thigh_z_10 =
      M_hind_left_thigh_z_9 - front_left_shank_I5 * M_hind_left_thigh_z_8;
  tau[7] = M_hind_left_thigh_z_10 - t_hind_left_hip_1 * t_hind_left_thigh_8;
  const Scalar alpha_hind_left_thigh_x = qd[6] * qd[7];
  const Scalar alpha_hind_left_shank_x = qd[6] * omega_hind_left_shank_z;
  const Scalar t_hind_left_thigh_9 = s_q7_q8 * alpha_hind_left_shank_x;
  const Scalar t_hind_left_thigh_10 = front_left_thigh_G1 * s_hind_left_abduction;
  const Scalar t_hind_left_thigh_11 =
      t_hind_left_thigh_10 - front_left_shank_I4 * t_hind_left_thigh_9;
  const Scalar t_hind_left_thigh_12 = s_hind_left_hip * alpha_hind_left_thigh_x;
  const Scalar t_hind_left_thigh_13 = front_left_shank_I6 * t_hind_left_thigh_9;
  const Scalar t_hind_left_thigh_14 = t_hind_left_thigh_12 - c_hind_left_hip * qdd[6];
  const Scalar t_hind_left_thigh_15 =
      t_hind_left_thigh_13 - front_left_shank_G1 * s_hind_left_abduction;
  const Scalar t_hind_left_thigh_16 = front_left_hip_I1 - s_q7_q8 * t_hind_left_shank_2;
  const Scalar t_hind_left_thigh_17 = front_left_thigh_I4 * t_hind_left_shank_1;
  const Scalar t_hind_left_thigh_18 =
      front_left_hip_G1 * c_hind_left_abduction - t_hind_left_thigh_17;
  const Scalar t_hind_left_thigh_19 = t_hind_left_thigh_8 * alpha_hind_left_thigh_x;
  const Scalar t_hind_left_thigh_20 =
      t_hind_left_thigh_11 - front_left_thigh_I3 * t_hind_left_thigh_1;
  const Scalar t_hind_left_thigh_21 = t_hind_left_thigh_18 - 2.0 * t_hind_left_thigh_19;
  const Scalar t_hind_left_thigh_22 = t_hind_left_thigh_21 - c_hind_left_hip * t_hind_left_thigh_20;
  const Scalar t_hind_left_thigh_23 =
      t_hind_left_thigh_15 + front_left_shank_I4 * t_hind_left_thigh_14;
  const Scalar t_hind_left_thigh_24 =
      t_hind_left_thigh_22 + front_left_shank_I2 * t_hind_left_thigh_3;
  const Scalar t_hind_left_thigh_25 = t_hind_left_thigh_16 - s_hind_left_hip * t_hind_left_thigh_7;
  const Scalar t_hind_left_thigh_26 = t_hind_left_thigh_24 + c_q7_q8 * t_hind_left_thigh_23;
  const Scalar t_hind_left_thigh_27 = t_hind_left_thigh_26 - qdd[6] * t_hind_left_thigh_25;
  tau[6] = -(t_hind_left_thigh_27 + qdd[7] * t_hind_left_thigh_5);
  const Scalar t_fron_righ_shan_16 = omega_fron_righ_shan_z * omega_fron_righ_shan_z;
  // front_right_thigh: moment M of (1)
  const Scalar t_fron_righ_thig_2 = front_left_thigh_I2 * c_front_right_hip;
  const Scalar t_fron_righ_thig_3 = t_fron_righ_thig_2 + front_left_thigh_I1 * s_front_right_hip;
  const Scalar t_fron_righ_thig_4 = front_left_thigh_I6 - t_fron_righ_shan_9;
  const Scalar t_fron_righ_thig_5 = t_fron_righ_thig_4 - c_front_right_hip * t_fron_righ_thig_3;
  const Scalar t_fron_righ_thig_6 = 2.0 * t_fron_righ_shan_2;
  const Scalar t_fron_righ_thig_7 = front_left_thigh_I3 * s_front_right_hip;
  const Scalar t_fron_righ_thig_8 = t_fron_righ_thig_7 + front_left_thigh_I4 * c_front_right_hip;
  const Scalar t_fron_righ_thig_9 = s_q4_q5 * alpha_fron_righ_shan_z;
  const Scalar t_fron_righ_thig_10 = c_q4_q5 * t_fron_righ_shan_16 + t_fron_righ_thig_9;
  const Scalar M_fron_righ_thig_z_1 = front_left_thigh_G1 * c_front_right_abduction;
  const Scalar M_fron_righ_thig_z_2 =
      t_fron_righ_shan_15 - t_fron_righ_shan_3 * t_fron_righ_shan_16;
  const Scalar M_fron_righ_thig_z_3 = M_fron_righ_thig_z_2 + qdd[5] * t_fron_righ_shan_2;
  const Scalar M_fron_righ_thig_z_4 =
      M_fron_righ_thig_z_3 - t_front_right_hip_1 * t_fron_righ_thig_5;
  const Scalar M_fron_righ_thig_z_5 = front_left_thigh_I7 + t_fron_righ_thig_6;
  const Scalar M_fron_righ_thig_z_6 = M_fron_righ_thig_z_4 + qdd[4] * M_fron_righ_thig_z_5;
  const Scalar M_fron_righ_thig_z_7 =
      M_fron_righ_thig_z_1 + front_left_shank_I5 * t_fron_righ_thig_10;
  const Scalar M_fron_righ_thig_z_8 = M_fron_righ_thig_z_6 + qdd[3] * t_fron_righ_thig_8;
  tau[4] = M_fron_righ_thig_z_8 + s_front_right_hip * M_fron_righ_thig_z_7;
  const Scalar M_front_right_hip_z_1 = front_left_hip_I1 + t_fron_righ_thig_6;
  const Scalar M_front_right_hip_z_2 = M_front_right_hip_z_1 - s_q4_q5 * t_fron_righ_shan_4;
  const Scalar M_front_right_hip_z_3 = front_left_thigh_I4 * s_front_right_hip;
  // front_right_hip: moment M of (1)
  const Scalar M_front_right_hip_z_4 = omega_fron_righ_shan_z * t_fron_righ_shan_5;
  const Scalar M_front_right_hip_z_5 = front_left_thigh_G1 * c_front_right_hip;
  const Scalar M_front_right_hip_z_6 =
      M_front_right_hip_z_2 - s_front_right_hip * t_fron_righ_thig_3;
  const Scalar M_front_right_hip_z_7 = front_left_hip_G1 * c_front_right_abduction;
  const Scalar M_front_right_hip_z_8 = M_front_right_hip_z_7 + qdd[3] * M_front_right_hip_z_6;
  const Scalar M_front_right_hip_z_9 = M_front_right_hip_z_8 + qdd[4] * t_fron_righ_thig_8;
  const Scalar M_front_right_hip_z_10 =
      M_front_right_hip_z_3 - front_left_thigh_I3 * c_front_right_hip;
  const Scalar M_front_right_hip_z_11 =
      M_front_right_hip_z_9 + front_left_shank_I2 * t_fron_righ_thig_10;
  const Scalar M_front_right_hip_z_12 = qd[4] * t_fron_righ_thig_5 - M_front_right_hip_z_4;
  const Scalar M_front_right_hip_z_13 =
      M_front_right_hip_z_11 - t_fron_righ_thig_1 * M_front_right_hip_z_10;
  const Scalar M_front_right_hip_z_14 = qd[3] * M_front_right_hip_z_12;
  const Scalar M_front_right_hip_z_15 = front_left_shank_G1 * c_q4_q5 + M_front_right_hip_z_5;
  const Scalar M_front_right_hip_z_16 = M_front_right_hip_z_13 + 2.0 * M_front_right_hip_z_14;
  tau[3] = M_front_right_hip_z_16 + s_front_right_abduction * M_front_right_hip_z_15;
  // front_left_thigh: moment M of (1)
  const Scalar t_front_left_thigh_4 = front_left_thigh_I3 * s_front_left_hip;
  const Scalar t_front_left_thigh_5 = t_front_left_thigh_4 + front_left_thigh_I4 * c_front_left_hip;
  const Scalar t_front_left_thigh_6 = s_q1_q2 * alpha_front_left_shank_z;
  const Scalar t_front_left_thigh_7 = c_q1_q2 * t_front_left_shank_9 + t_front_left_thigh_6;
  const Scalar M_front_left_thigh_z_1 = front_left_thigh_G1 * c_front_left_abduction;
  const Scalar t_front_left_thigh_8 = front_left_thigh_I6 - t_front_left_shank_8;
  const Scalar t_front_left_thigh_9 =
      t_front_left_thigh_8 - c_front_left_hip * t_front_left_thigh_2;
  const Scalar M_front_left_thigh_z_2 = t_front_left_shank_4 + M_front_left_shank_z;
  const Scalar M_front_left_thigh_z_3 = M_front_left_thigh_z_2 + front_left_thigh_I7 * qdd[1];
  const Scalar M_front_left_thigh_z_4 =
      M_front_left_thigh_z_3 - t_front_left_shank_5 * t_front_left_shank_9;
  const Scalar M_front_left_thigh_z_5 = M_front_left_thigh_z_4 + qdd[2] * t_front_left_shank_3;
  const Scalar M_front_left_thigh_z_6 =
      M_front_left_thigh_z_1 + front_left_shank_I5 * t_front_left_thigh_7;
  const Scalar M_front_left_thigh_z_7 = M_front_left_thigh_z_5 - qdd[0] * t_front_left_thigh_5;
  const Scalar M_front_left_thigh_z_8 =
      M_front_left_thigh_z_7 + s_front_left_hip * M_front_left_thigh_z_6;
  tau[1] = M_front_left_thigh_z_8 - t_front_left_hip_1 * t_front_left_thigh_9;
  const Scalar t_front_left_thigh_10 = front_left_thigh_G1 * c_front_left_hip;
  const Scalar t_front_left_thigh_11 = front_left_hip_I1 - s_q1_q2 * t_front_left_shank_1;
  const Scalar t_front_left_thigh_12 = t_front_left_thigh_11 + 2.0 * t_front_left_shank_3;
  const Scalar t_front_left_thigh_13 = front_left_thigh_I4 * s_front_left_hip;
  const Scalar t_front_left_thigh_14 = omega_front_left_shank_z * t_front_left_shank_6;
  const Scalar t_front_left_thigh_15 = front_left_shank_G1 * c_q1_q2 + t_front_left_thigh_10;
  const Scalar t_front_left_thigh_16 = s_front_left_abduction * t_front_left_thigh_15;
  const Scalar t_front_left_thigh_17 =
      t_front_left_thigh_12 - s_front_left_hip * t_front_left_thigh_2;
  const Scalar t_front_left_thigh_18 =
      front_left_hip_G1 * c_front_left_abduction - t_front_left_thigh_16;
  const Scalar t_front_left_thigh_19 =
      t_front_left_thigh_13 - front_left_thigh_I3 * c_front_left_hip;
  const Scalar t_front_left_thigh_20 = t_front_left_thigh_18 - qdd[0] * t_front_left_thigh_17;
  const Scalar t_front_left_thigh_21 =
      t_front_left_thigh_20 - t_front_left_thigh_3 * t_front_left_thigh_19;
  const Scalar t_front_left_thigh_22 =
      t_front_left_thigh_21 + front_left_shank_I2 * t_front_left_thigh_7;
  const Scalar t_front_left_thigh_23 = t_front_left_thigh_14 - qd[1] * t_front_left_thigh_9;
  const Scalar t_front_left_thigh_24 = t_front_left_thigh_22 + qdd[1] * t_front_left_thigh_5;
  // front_left_hip: moment M of (1)
  tau[0] = -(t_front_left_thigh_24 + qd[0] * t_front_left_thigh_23 * 2.0);
}

void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept {
  const Scalar q_q1_q2 = q[1] + q[2];
  const Scalar q_q4_q5 = q[4] + q[5];
  const Scalar q_q7_q8 = q[7] + q[8];
  const Scalar q_q10_q11 = q[10] + q[11];
  Scalar sines[12];
  Scalar cosines[12];
  sines_cosines(sines, cosines, q[0], q[1], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[6], q[7], q[9], q[10]);
  sines_cosines(sines + 8, cosines + 8, q_q1_q2, q_q4_q5, q_q7_q8, q_q10_q11);
  const Scalar s_front_left_abduction = sines[0];
  const Scalar c_front_left_abduction = cosines[0];
  const Scalar s_front_left_hip = sines[1];
  const Scalar c_front_left_hip = cosines[1];
  const Scalar s_front_right_abduction = sines[2];
  const Scalar c_front_right_abduction = cosines[2];
  const Scalar s_front_right_hip = sines[3];
  const Scalar c_front_right_hip = cosines[3];
  const Scalar s_hind_left_abduction = sines[4];
  const Scalar c_hind_left_abduction = cosines[4];
  const Scalar s_hind_left_hip = sines[5];
  const Scalar c_hind_left_hip = cosines[5];
  const Scalar s_hind_right_abduction = sines[6];
  const Scalar c_hind_right_abduction = cosines[6];
  const Scalar s_hind_right_hip = sines[7];
  const Scalar c_hind_right_hip = cosines[7];
  const Scalar s_q1_q2 = sines[8];
  const Scalar c_q1_q2 = cosines[8];
  const Scalar s_q4_q5 = sines[9];
  const Scalar c_q4_q5 = cosines[9];
  const Scalar s_q7_q8 = sines[10];
  const Scalar c_q7_q8 = cosines[10];
  const Scalar s_q10_q11 = sines[11];
  const Scalar c_q10_q11 = cosines[11];
  // front_left_shank: angular velocity omega, moment M of (1)
  const Scalar omega_front_left_shank_z = qd[1] + qd[2];
  const Scalar t_front_left_shank_1 = front_left_shank_I5 * c_front_left_hip;
  const Scalar t_front_left_shank_2 = s_q1_q2 * t_front_left_shank_1;
  const Scalar t_front_left_shank_3 = front_left_shank_I5 * s_front_left_hip;
  const Scalar t_front_left_shank_4 = c_q1_q2 * t_front_left_shank_3;
  // front_right_shank: angular velocity omega, moment M of (1)
  const Scalar omega_fron_righ_shan_z = qd[4] + qd[5];
  const Scalar t_fron_righ_shan_1 = front_left_shank_I5 * c_q4_q5;
  const Scalar t_fron_righ_shan_2 = s_front_right_hip * t_fron_righ_shan_1;
  // hind_left_shank: angular velocity omega, moment M of (1)
  const Scalar omega_hind_left_shank_z = qd[7] + qd[8];
  const Scalar t_hind_left_shank_1 = front_left_shank_I5 * c_q7_q8;
  const Scalar t_hind_left_shank_2 = s_hind_left_hip * t_hind_left_shank_1;
  // hind_right_shank: angular velocity omega, moment M of (1)
  const Scalar omega_hind_right_shank_z = qd[10] + qd[11];
  const Scalar t_hind_right_shank_1 = front_left_shank_I5 * s_q10_q11;
  const Scalar t_hind_right_shank_2 = c_hind_right_hip * t_hind_right_shank_1;
  const Scalar t_hind_right_shank_3 = front_left_shank_I5 * c_q10_q11;
  const Scalar t_hind_right_shank_4 = s_hind_right_hip * t_hind_right_shank_3;
  const Scalar t_hind_left_shank_3 = front_left_shank_I5 * s_q7_q8;
  const Scalar t_hind_left_shank_4 = c_hind_left_hip * t_hind_left_shank_3;
  const Scalar t_fron_righ_shan_3 = front_left_shank_I5 * s_q4_q5;
  const Scalar t_fron_righ_shan_4 = c_front_right_hip * t_fron_righ_shan_3;
  // hind_left_shank: moment M, inertia I of (1)
  const Scalar t_hind_left_shank_5 = t_hind_left_shank_2 - t_hind_left_shank_4;
  const Scalar t_hind_left_shank_6 = s_q7_q8 * c_q7_q8;
  const Scalar t_hind_left_shank_7 =
      t_hind_left_shank_4 + front_left_shank_I3 * t_hind_left_shank_6;
  const Scalar t_hind_left_hip_1 = qd[6] * qd[6];
  const Scalar t_hind_left_thigh_1 = qd[7] * qd[7];
  const Scalar M_hind_left_shank_z_1 = c_hind_left_abduction * s_q7_q8 * front_left_shank_G1;
  const Scalar M_hind_left_shank_z_2 =
      M_hind_left_shank_z_1 + t_hind_left_shank_7 * t_hind_left_hip_1;
  const Scalar M_hind_left_shank_z =
      M_hind_left_shank_z_2 - t_hind_left_shank_5 * t_hind_left_thigh_1;
  const Scalar t_front_left_hip_1 = tau[8] - M_hind_left_shank_z;
  // hind_right_shank: moment M, inertia I of (1)
  const Scalar t_hind_right_shank_5 = t_hind_right_shank_2 - t_hind_right_shank_4;
  const Scalar t_hind_right_shank_6 = s_q10_q11 * c_q10_q11;
  const Scalar t_hind_right_shank_7 =
      t_hind_right_shank_2 + front_left_shank_I3 * t_hind_right_shank_6;
  const Scalar t_front_left_shank_5 = t_front_left_shank_2 - t_front_left_shank_4;
  const Scalar t_hind_right_shank_8 = s_hind_right_hip * t_hind_right_shank_1;
  const Scalar t_hind_right_shank_9 = c_hind_right_hip * t_hind_right_shank_3;
  const Scalar t_hind_right_shank_10 = 2.0 * t_hind_right_shank_9;
  // hind_left_shank
  const Scalar t_hind_left_shank_8 = s_hind_left_hip * t_hind_left_shank_3;
  const Scalar t_hind_left_shank_9 = c_hind_left_hip * t_hind_left_shank_1;
  const Scalar t_hind_left_shank_10 = 2.0 * t_hind_left_shank_9;
  // front_right_shank
  const Scalar t_fron_righ_shan_5 = c_front_right_hip * t_fron_righ_shan_1;
  const Scalar t_fron_righ_shan_6 = 2.0 * t_fron_righ_shan_5;
  const Scalar t_fron_righ_shan_7 = s_front_right_hip * t_fron_righ_shan_3;
  // front_left_shank
  const Scalar t_front_left_shank_6 = s_q1_q2 * t_front_left_shank_3;
  const Scalar t_front_left_shank_7 = c_q1_q2 * t_front_left_shank_1;
  const Scalar t_front_left_shank_8 = 2.0 * t_front_left_shank_7;
  const Scalar t_hind_right_shank_11 = t_hind_right_shank_8 + t_hind_right_shank_9;
  const Scalar t_hind_right_shank_12 = front_left_shank_I1 + t_hind_right_shank_11;
  const Scalar t_hind_left_shank_11 = t_hind_left_shank_8 + t_hind_left_shank_9;
  const Scalar t_hind_left_shank_12 = front_left_shank_I1 + t_hind_left_shank_11;
  const Scalar t_front_left_shank_9 = t_front_left_shank_6 + t_front_left_shank_7;
  const Scalar t_hind_right_shank_13 = front_left_shank_p1 * t_hind_right_shank_12;
  const Scalar t_hind_right_thigh_1 = front_left_thigh_I5 + t_hind_right_shank_10;
  const Scalar I_hind_right_thigh_zz = t_hind_right_thigh_1 + 2.0 * t_hind_right_shank_8;
  const Scalar t_hind_right_shank_14 = front_left_shank_k1 * s_q10_q11;
  const Scalar t_hind_right_thigh_2 = front_left_thigh_I3 * s_hind_right_hip;
  const Scalar t_hind_right_thigh_3 = t_hind_right_thigh_2 + front_left_thigh_I4 * c_hind_right_hip;
  const Scalar t_hind_right_shank_15 =
      t_hind_right_thigh_3 - t_hind_right_shank_11 * t_hind_right_shank_14;
  const Scalar t_hind_right_shank_16 =
      I_hind_right_thigh_zz - t_hind_right_shank_12 * t_hind_right_shank_13;
  // hind_right_thigh: 1/pivot of (1)
  const Scalar t_hind_right_thigh_4 = 1.0 / t_hind_right_shank_16;
  const Scalar t_hind_right_thigh_5 = front_left_thigh_I1 * s_hind_right_hip;
  const Scalar t_hind_right_thigh_6 = t_hind_right_thigh_5 + front_left_thigh_I2 * c_hind_right_hip;
  const Scalar qdd_9_1 = t_hind_right_shank_15 * t_hind_right_thigh_4;
  // hind_right_shank
  const Scalar qdd_9_2 = front_left_hip_I1 + t_hind_right_shank_10;
  const Scalar qdd_9_3 = qdd_9_2 - s_q10_q11 * s_q10_q11 * front_left_shank_I7;
  const Scalar qdd_9_4 = qdd_9_3 - s_hind_right_hip * t_hind_right_thigh_6;
  const Scalar qdd_9_5 = 1.0 / (qdd_9_4 - t_hind_right_shank_15 * qdd_9_1);
  const Scalar t_hind_left_shank_13 = front_left_shank_p1 * t_hind_left_shank_12;
  const Scalar I_hind_left_thigh_zz_1 = front_left_thigh_I5 + t_hind_left_shank_10;
  const Scalar I_hind_left_thigh_zz = I_hind_left_thigh_zz_1 + 2.0 * t_hind_left_shank_8;
  const Scalar t_hind_left_shank_14 = front_left_shank_k1 * s_q7_q8;
  const Scalar t_hind_left_thigh_2 = front_left_thigh_I4 * c_hind_left_hip;
  const Scalar t_hind_left_thigh_3 = t_hind_left_thigh_2 + front_left_thigh_I3 * s_hind_left_hip;
  const Scalar t_hind_left_shank_15 =
      t_hind_left_thigh_3 - t_hind_left_shank_11 * t_hind_left_shank_14;
  const Scalar t_hind_left_shank_16 =
      I_hind_left_thigh_zz - t_hind_left_shank_12 * t_hind_left_shank_13;
  // hind_left_thigh: 1/pivot of (1)
  const Scalar t_hind_left_thigh_4 = 1.0 / t_hind_left_shank_16;
  const Scalar t_hind_left_thigh_5 = t_hind_left_shank_15 * t_hind_left_thigh_4;
  const Scalar t_hind_left_thigh_6 = front_left_thigh_I1 * s_hind_left_hip;
  const Scalar t_hind_left_thigh_7 = t_hind_left_thigh_6 + front_left_thigh_I2 * c_hind_left_hip;
  const Scalar qdd_6_1 = front_left_hip_I1 + t_hind_left_shank_10;
  const Scalar qdd_6_2 = qdd_6_1 - s_q7_q8 * s_q7_q8 * front_left_shank_I7;
  const Scalar qdd_6_3 = qdd_6_2 - t_hind_left_shank_15 * t_hind_left_thigh_5;
  const Scalar qdd_6_4 = 1.0 / (qdd_6_3 - s_hind_left_hip * t_hind_left_thigh_7);
  // front_right_shank
  const Scalar t_fron_righ_shan_8 = t_fron_righ_shan_5 + t_fron_righ_shan_7;
  const Scalar t_fron_righ_shan_9 = front_left_shank_I1 + t_fron_righ_shan_8;
  const Scalar t_fron_righ_shan_10 = front_left_shank_p1 * t_fron_righ_shan_9;
  const Scalar I_fron_righ_thig_zz_1 = front_left_thigh_I5 + t_fron_righ_shan_6;
  const Scalar I_fron_righ_thig_zz = I_fron_righ_thig_zz_1 + 2.0 * t_fron_righ_shan_7;
  const Scalar t_fron_righ_shan_11 = I_fron_righ_thig_zz - t_fron_righ_shan_9 * t_fron_righ_shan_10;
  // front_right_thigh: 1/pivot of (1)
  const Scalar t_fron_righ_thig_1 = 1.0 / t_fron_righ_shan_11;
  const Scalar t_fron_righ_thig_2 = front_left_thigh_I2 * c_front_right_hip;
  const Scalar t_fron_righ_thig_3 = t_fron_righ_thig_2 + front_left_thigh_I1 * s_front_right_hip;
  const Scalar t_fron_righ_shan_12 = front_left_shank_k1 * s_q4_q5;
  const Scalar t_fron_righ_thig_4 = front_left_thigh_I3 * s_front_right_hip;
  const Scalar t_fron_righ_thig_5 = t_fron_righ_thig_4 + front_left_thigh_I4 * c_front_right_hip;
  const Scalar t_fron_righ_shan_13 = t_fron_righ_thig_5 - t_fron_righ_shan_8 * t_fron_righ_shan_12;
  const Scalar qdd_3_1 = t_fron_righ_thig_1 * t_fron_righ_shan_13;
  const Scalar qdd_3_2 = front_left_hip_I1 + t_fron_righ_shan_6;
  const Scalar qdd_3_3 = qdd_3_2 - s_q4_q5 * s_q4_q5 * front_left_shank_I7;
  const Scalar qdd_3_4 = qdd_3_3 - t_fron_righ_shan_13 * qdd_3_1;
  const Scalar qdd_3_5 = 1.0 / (qdd_3_4 - s_front_right_hip * t_fron_righ_thig_3);
  // front_left_shank
  const Scalar t_front_left_shank_10 = front_left_shank_p1 * t_front_left_shank_9;
  const Scalar t_front_left_shank_11 = 1.0 + t_front_left_shank_10;
  const Scalar t_front_left_shank_12 = front_left_thigh_I7 + t_front_left_shank_8;
  const Scalar t_front_left_shank_13 = t_front_left_shank_12 + 2.0 * t_front_left_shank_6;
  const Scalar t_front_left_shank_14 = 2.0 + t_front_left_shank_10;
  const Scalar t_front_left_shank_15 = front_left_shank_k1 * s_q1_q2;
  const Scalar t_front_left_thigh_1 = front_left_thigh_I3 * s_front_left_hip;
  const Scalar t_front_left_thigh_2 = t_front_left_thigh_1 + front_left_thigh_I4 * c_front_left_hip;
  const Scalar t_front_left_shank_16 =
      t_front_left_thigh_2 - t_front_left_shank_9 * t_front_left_shank_15;
  const Scalar t_front_left_shank_17 =
      t_front_left_shank_13 - t_front_left_shank_9 * t_front_left_shank_14;
  // front_left_thigh: 1/pivot of (1)
  const Scalar t_front_left_thigh_3 = 1.0 / t_front_left_shank_17;
  const Scalar t_front_left_thigh_4 = front_left_thigh_I2 * c_front_left_hip;
  const Scalar t_front_left_thigh_5 = t_front_left_thigh_4 + front_left_thigh_I1 * s_front_left_hip;
  const Scalar qdd_0_1 = t_front_left_shank_16 * t_front_left_thigh_3;
  // front_left_shank
  const Scalar qdd_0_2 = front_left_hip_I1 + t_front_left_shank_8;
  const Scalar qdd_0_3 = qdd_0_2 - s_q1_q2 * s_q1_q2 * front_left_shank_I7;
  const Scalar qdd_0_4 = qdd_0_3 - s_front_left_hip * t_front_left_thigh_5;
  const Scalar qdd_0_5 = 1.0 / (qdd_0_4 - t_front_left_shank_16 * qdd_0_1);
  const Scalar t_fron_righ_shan_14 = s_q4_q5 * c_q4_q5;
  const Scalar t_fron_righ_shan_15 = t_fron_righ_shan_4 + front_left_shank_I3 * t_fron_righ_shan_14;
  const Scalar t_front_right_hip_1 = qd[3] * qd[3];
  const Scalar t_fron_righ_shan_16 = t_fron_righ_shan_2 - t_fron_righ_shan_4;
  const Scalar t_fron_righ_thig_6 = qd[4] * qd[4];
  // front_right_shank: moment M, Omega of (1)
  const Scalar M_fron_righ_shan_z_1 = c_front_right_abduction * s_q4_q5 * front_left_shank_G1;
  const Scalar M_fron_righ_shan_z_2 =
      M_fron_righ_shan_z_1 + t_fron_righ_shan_15 * t_front_right_hip_1;
  const Scalar M_fron_righ_shan_z = M_fron_righ_shan_z_2 - t_fron_righ_shan_16 * t_fron_righ_thig_6;
  const Scalar t_front_left_hip_2 = tau[5] - M_fron_righ_shan_z;
  const Scalar t_fron_righ_shan_17 = omega_fron_righ_shan_z * omega_fron_righ_shan_z;
  // front_left_hip: qdd of (1)
  const Scalar qdd_3_6 = front_left_shank_G1 * c_q4_q5 + front_left_thigh_G1 * c_front_right_hip;
  const Scalar t_front_left_hip_3 = front_left_thigh_I6 - t_fron_righ_shan_2;
  const Scalar t_front_left_hip_4 = t_front_left_hip_3 - c_front_right_hip * t_fron_righ_thig_3;
  const Scalar qdd_3_7 = omega_fron_righ_shan_z * t_fron_righ_shan_15;
  const Scalar t_fron_righ_thig_7 = c_front_right_abduction * s_front_right_hip;
  const Scalar t_front_left_hip_5 = tau[4] - M_fron_righ_shan_z;
  const Scalar t_front_left_hip_6 = t_front_left_hip_5 - front_left_thigh_G1 * t_fron_righ_thig_7;
  const Scalar t_front_left_hip_7 = t_front_left_hip_6 - t_fron_righ_shan_10 * t_front_left_hip_2;
  const Scalar t_front_left_hip_8 = t_front_left_hip_7 + t_front_right_hip_1 * t_front_left_hip_4;
  const Scalar t_front_left_hip_9 = t_front_left_hip_8 - t_fron_righ_shan_16 * t_fron_righ_shan_17;
  const Scalar qdd_3_8 = front_left_thigh_I4 * s_front_right_hip;
  const Scalar qdd_3_9 = tau[3] - front_left_hip_G1 * c_front_right_abduction;
  const Scalar qdd_3_10 = qdd_3_9 - t_fron_righ_shan_12 * t_front_left_hip_2;
  const Scalar qdd_3_11 = qdd_3_10 - c_q4_q5 * t_fron_righ_shan_17 * front_left_shank_I2;
  const Scalar qdd_3_12 = qdd_3_11 - s_front_right_abduction * qdd_3_6;
  const Scalar qdd_3_13 = qdd_3_12 - qd[3] * (qd[4] * t_front_left_hip_4 - qdd_3_7) * 2.0;
  const Scalar qdd_3_14 = qdd_3_8 - front_left_thigh_I3 * c_front_right_hip;
  const Scalar qdd_3_15 = qdd_3_13 - qdd_3_1 * t_front_left_hip_9;
  const Scalar qdd_3 = qdd_3_5 * (qdd_3_15 + t_fron_righ_thig_6 * qdd_3_14);
  qdd[3] = qdd_3;
  const Scalar qdd_4 = t_fron_righ_thig_1 * (t_front_left_hip_9 - t_fron_righ_shan_13 * qdd_3);
  qdd[4] = qdd_4;
  const Scalar neg_qdd_5_1 = t_front_left_hip_2 - t_fron_righ_shan_9 * qdd_4;
  qdd[5] = front_left_shank_p1 * neg_qdd_5_1 - t_fron_righ_shan_12 * qdd_3;
  const Scalar t_hind_right_thigh_7 = qd[10] * qd[10];
  const Scalar t_hind_right_hip_1 = qd[9] * qd[9];
  // hind_right_shank: moment M, Omega of (1)
  const Scalar M_hind_right_shank_z_1 = c_hind_right_abduction * s_q10_q11 * front_left_shank_G1;
  const Scalar M_hind_right_shank_z_2 =
      M_hind_right_shank_z_1 + t_hind_right_shank_5 * t_hind_right_thigh_7;
  const Scalar M_hind_right_shank_z =
      M_hind_right_shank_z_2 + t_hind_right_shank_7 * t_hind_right_hip_1;
  const Scalar t_hind_right_shank_17 = omega_hind_right_shank_z * omega_hind_right_shank_z;
  // front_left_hip: qdd, Omega of (1)
  const Scalar t_front_left_hip_10 = front_left_thigh_I6 - t_hind_right_shank_4;
  const Scalar t_front_left_hip_11 = t_front_left_hip_10 - c_hind_right_hip * t_hind_right_thigh_6;
  const Scalar t_front_left_hip_12 = tau[11] - M_hind_right_shank_z;
  const Scalar t_hind_right_thigh_8 = c_hind_right_abduction * s_hind_right_hip;
  const Scalar t_front_left_hip_13 = tau[10] - M_hind_right_shank_z;
  const Scalar t_front_left_hip_14 =
      t_front_left_hip_13 - front_left_thigh_G1 * t_hind_right_thigh_8;
  const Scalar t_front_left_hip_15 =
      t_front_left_hip_14 + t_hind_right_shank_5 * t_hind_right_shank_17;
  const Scalar t_front_left_hip_16 = t_front_left_hip_15 + t_hind_right_hip_1 * t_front_left_hip_11;
  const Scalar t_front_left_hip_17 =
      t_front_left_hip_16 - t_hind_right_shank_13 * t_front_left_hip_12;
  const Scalar qdd_9_6 = front_left_thigh_I4 * s_hind_right_hip;
  const Scalar qdd_9_7 = omega_hind_right_shank_z * t_hind_right_shank_7;
  const Scalar qdd_9_8 = front_left_shank_I2 * t_hind_right_shank_17;
  const Scalar qdd_9_9 = tau[9] - front_left_hip_G1 * c_hind_right_abduction;
  const Scalar qdd_9_10 = qdd_9_9 - qdd_9_1 * t_front_left_hip_17;
  const Scalar qdd_9_11 = qdd_9_6 - front_left_thigh_I3 * c_hind_right_hip;
  const Scalar qdd_9_12 = qdd_9_10 - t_hind_right_shank_14 * t_front_left_hip_12;
  const Scalar qdd_9_13 = qdd_9_12 + t_hind_right_thigh_7 * qdd_9_11;
  const Scalar qdd_9_14 = qdd_9_13 - qd[9] * (qd[10] * t_front_left_hip_11 - qdd_9_7) * 2.0;
  const Scalar qdd_9_15 = s_hind_right_abduction * c_hind_right_hip;
  const Scalar qdd_9_16 = qdd_9_14 - front_left_thigh_G1 * qdd_9_15;
  const Scalar qdd_9_17 = qdd_9_8 + front_left_shank_G1 * s_hind_right_abduction;
  const Scalar qdd_9 = qdd_9_5 * (qdd_9_16 - c_q10_q11 * qdd_9_17);
  qdd[9] = qdd_9;
  const Scalar qdd_10_1 = t_front_left_hip_17 - t_hind_right_shank_15 * qdd_9;
  const Scalar qdd_10 = t_hind_right_thigh_4 * qdd_10_1;
  qdd[10] = qdd_10;
  const Scalar neg_qdd_11_1 = t_front_left_hip_12 - t_hind_right_shank_12 * qdd_10;
  qdd[11] = front_left_shank_p1 * neg_qdd_11_1 - t_hind_right_shank_14 * qdd_9;
  const Scalar t_front_left_shank_18 = s_q1_q2 * c_q1_q2;
  const Scalar t_front_left_shank_19 =
      t_front_left_shank_2 + front_left_shank_I3 * t_front_left_shank_18;
  const Scalar t_front_left_hip_18 = qd[0] * qd[0];
  const Scalar t_front_left_thigh_6 = qd[1] * qd[1];
  // front_left_shank: moment M, Omega of (1)
  const Scalar M_front_left_shank_z_1 = c_front_left_abduction * s_q1_q2 * front_left_shank_G1;
  const Scalar M_front_left_shank_z_2 =
      M_front_left_shank_z_1 + t_front_left_shank_19 * t_front_left_hip_18;
  const Scalar M_front_left_shank_z =
      M_front_left_shank_z_2 + t_front_left_shank_5 * t_front_left_thigh_6;
  const Scalar t_front_left_shank_20 = omega_front_left_shank_z * omega_front_left_shank_z;
  // front_left_hip: qdd of (1)
  const Scalar t_front_left_hip_19 = front_left_thigh_I6 - t_front_left_shank_4;
  const Scalar t_front_left_hip_20 = t_front_left_hip_19 - c_front_left_hip * t_front_left_thigh_5;
  const Scalar t_front_left_hip_21 = tau[2] - M_front_left_shank_z;
  const Scalar t_front_left_thigh_7 = c_front_left_abduction * s_front_left_hip;
  const Scalar t_front_left_hip_22 = tau[1] - M_front_left_shank_z;
  const Scalar t_front_left_hip_23 =
      t_front_left_hip_22 - front_left_thigh_G1 * t_front_left_thigh_7;
  const Scalar t_front_left_hip_24 =
      t_front_left_hip_23 + t_front_left_shank_5 * t_front_left_shank_20;
  const Scalar t_front_left_hip_25 =
      t_front_left_hip_24 + t_front_left_hip_18 * t_front_left_hip_20;
  const Scalar t_front_left_hip_26 =
      t_front_left_hip_25 - t_front_left_shank_11 * t_front_left_hip_21;
  const Scalar qdd_0_6 = omega_front_left_shank_z * t_front_left_shank_19;
  const Scalar qdd_0_7 = front_left_thigh_I4 * s_front_left_hip;
  const Scalar qdd_0_8 = front_left_shank_I2 * t_front_left_shank_20;
  const Scalar qdd_0_9 = tau[0] + front_left_hip_G1 * c_front_left_abduction;
  const Scalar qdd_0_10 = qdd_0_9 + qdd_0_1 * t_front_left_hip_26;
  const Scalar qdd_0_11 = qdd_0_10 + qd[0] * (qdd_0_6 - qd[1] * t_front_left_hip_20) * 2.0;
  const Scalar qdd_0_12 = s_front_left_abduction * c_front_left_hip;
  const Scalar qdd_0_13 = qdd_0_7 - front_left_thigh_I3 * c_front_left_hip;
  const Scalar qdd_0_14 = qdd_0_11 - front_left_thigh_G1 * qdd_0_12;
  const Scalar qdd_0_15 = qdd_0_14 - t_front_left_thigh_6 * qdd_0_13;
  const Scalar qdd_0_16 = qdd_0_15 + t_front_left_shank_15 * t_front_left_hip_21;
  const Scalar qdd_0_17 = qdd_0_8 - front_left_shank_G1 * s_front_left_abduction;
  const Scalar qdd_0 = qdd_0_5 * (qdd_0_16 + c_q1_q2 * qdd_0_17);
  qdd[0] = qdd_0;
  const Scalar qdd_1_1 = t_front_left_hip_26 + t_front_left_shank_16 * qdd_0;
  const Scalar qdd_1 = t_front_left_thigh_3 * qdd_1_1;
  qdd[1] = qdd_1;
  const Scalar qdd_2_1 = t_front_left_shank_15 * qdd_0 - t_front_left_shank_11 * qdd_1;
  qdd[2] = qdd_2_1 + front_left_shank_p1 * t_front_left_hip_21;
  const Scalar qdd_6_5 = front_left_thigh_I4 * s_hind_left_hip;
  const Scalar t_front_left_hip_27 = front_left_thigh_I6 - t_hind_left_shank_2;
  const Scalar t_front_left_hip_28 = t_front_left_hip_27 - c_hind_left_hip * t_hind_left_thigh_7;
  const Scalar t_hind_left_shank_17 = omega_hind_left_shank_z * omega_hind_left_shank_z;
  const Scalar t_hind_left_thigh_8 = c_hind_left_abduction * s_hind_left_hip;
  const Scalar t_front_left_hip_29 = tau[7] - M_hind_left_shank_z;
  const Scalar t_front_left_hip_30 =
      t_front_left_hip_29 - front_left_thigh_G1 * t_hind_left_thigh_8;
  const Scalar t_front_left_hip_31 = t_front_left_hip_30 + t_hind_left_hip_1 * t_front_left_hip_28;
  const Scalar t_front_left_hip_32 =
      t_front_left_hip_31 - t_hind_left_shank_5 * t_hind_left_shank_17;
  const Scalar t_front_left_hip_33 =
      t_front_left_hip_32 - t_front_left_hip_1 * t_hind_left_shank_13;
  const Scalar t_front_left_hip_34 = t_hind_left_thigh_4 * t_front_left_hip_33;
  const Scalar qdd_6_6 = front_left_shank_I2 * t_hind_left_shank_17;
  const Scalar qdd_6_7 = omega_hind_left_shank_z * t_hind_left_shank_7;
  const Scalar qdd_6_8 = qdd_6_5 - front_left_thigh_I3 * c_hind_left_hip;
  const Scalar qdd_6_9 = tau[6] + front_left_hip_G1 * c_hind_left_abduction;
  const Scalar qdd_6_10 = qdd_6_9 - t_hind_left_thigh_1 * qdd_6_8;
  const Scalar qdd_6_11 = qdd_6_10 + t_hind_left_shank_15 * t_front_left_hip_34;
  const Scalar qdd_6_12 = qdd_6_11 + t_front_left_hip_1 * t_hind_left_shank_14;
  const Scalar qdd_6_13 = s_hind_left_abduction * c_hind_left_hip;
  const Scalar qdd_6_14 = qdd_6_12 - front_left_thigh_G1 * qdd_6_13;
  const Scalar qdd_6_15 = qdd_6_6 - front_left_shank_G1 * s_hind_left_abduction;
  const Scalar qdd_6_16 = qdd_6_14 + c_q7_q8 * qdd_6_15;
  const Scalar qdd_6_17 = qdd_6_16 + qd[6] * (qdd_6_7 - qd[7] * t_front_left_hip_28) * 2.0;
  const Scalar qdd_6 = qdd_6_4 * qdd_6_17;
  qdd[6] = qdd_6;
  const Scalar qdd_7 = t_front_left_hip_34 + t_hind_left_thigh_5 * qdd_6;
  qdd[7] = qdd_7;
  const Scalar qdd_8_1 = t_front_left_hip_1 - t_hind_left_shank_12 * qdd_7;
  qdd[8] = t_hind_left_shank_14 * qdd_6 + front_left_shank_p1 * qdd_8_1;
}

void point_positions(const Scalar q[12], Scalar p[12]) noexcept {
  const Scalar q_q1_q2 = q[1] + q[2];
  const Scalar q_q4_q5 = q[4] + q[5];
  const Scalar q_q7_q8 = q[7] + q[8];
  const Scalar q_q10_q11 = q[10] + q[11];
  Scalar sines[12];
  Scalar cosines[12];
  sines_cosines(sines, cosines, q[0], q_q1_q2, q[1], q[3]);
  sines_cosines(sines + 4, cosines + 4, q_q4_q5, q[4], q[6], q_q7_q8);
  sines_cosines(sines + 8, cosines + 8, q[7], q[9], q_q10_q11, q[10]);
  const Scalar s_front_left_abduction = sines[0];
  const Scalar c_front_left_abduction = cosines[0];
  const Scalar s_q1_q2 = sines[1];
  const Scalar c_q1_q2 = cosines[1];
  const Scalar s_front_left_hip = sines[2];
  const Scalar c_front_left_hip = cosines[2];
  const Scalar s_front_right_abduction = sines[3];
  const Scalar c_front_right_abduction = cosines[3];
  const Scalar s_q4_q5 = sines[4];
  const Scalar c_q4_q5 = cosines[4];
  const Scalar s_front_right_hip = sines[5];
  const Scalar c_front_right_hip = cosines[5];
  const Scalar s_hind_left_abduction = sines[6];
  const Scalar c_hind_left_abduction = cosines[6];
  const Scalar s_q7_q8 = sines[7];
  const Scalar c_q7_q8 = cosines[7];
  const Scalar s_hind_left_hip = sines[8];
  const Scalar c_hind_left_hip = cosines[8];
  const Scalar s_hind_right_abduction = sines[9];
  const Scalar c_hind_right_abduction = cosines[9];
  const Scalar s_q10_q11 = sines[10];
  const Scalar c_q10_q11 = cosines[10];
  const Scalar s_hind_right_hip = sines[11];
  const Scalar c_hind_right_hip = cosines[11];
  const Scalar neg_s_front_left_shank_x = front_left_shank_l1 * c_front_left_hip;
  const Scalar t_front_left_shank_1 = neg_s_front_left_shank_x + front_left_shank_l2 * c_q1_q2;
  // front_left_hip: p of 1.2
  const Scalar p_1_1 = front_left_hip_l2 + front_left_thigh_l1 * c_front_left_abduction;
  p[1] = p_1_1 - s_front_left_abduction * t_front_left_shank_1;
  const Scalar p_2_1 = c_front_left_abduction * t_front_left_shank_1;
  p[2] = front_left_thigh_l1 * s_front_left_abduction + p_2_1;
  const Scalar p_0_1 = front_left_hip_l1 - front_left_shank_l1 * s_front_left_hip;
  p[0] = p_0_1 - front_left_shank_l2 * s_q1_q2;
  const Scalar neg_s_fron_righ_shan_x = front_left_shank_l1 * c_front_right_hip;
  const Scalar t_fron_righ_shan_1 = neg_s_fron_righ_shan_x + front_left_shank_l2 * c_q4_q5;
  // front_right_hip: p of 1.2
  const Scalar neg_p_4_1 = front_left_hip_l2 + front_left_thigh_l1 * c_front_right_abduction;
  p[4] = -(neg_p_4_1 + s_front_right_abduction * t_fron_righ_shan_1);
  const Scalar neg_p_5_1 = c_front_right_abduction * t_fron_righ_shan_1;
  p[5] = neg_p_5_1 - front_left_thigh_l1 * s_front_right_abduction;
  const Scalar p_3_1 = front_left_hip_l1 - front_left_shank_l1 * s_front_right_hip;
  p[3] = p_3_1 - front_left_shank_l2 * s_q4_q5;
  const Scalar neg_s_hind_left_shank_x = front_left_shank_l1 * c_hind_left_hip;
  const Scalar t_hind_left_shank_1 = neg_s_hind_left_shank_x + front_left_shank_l2 * c_q7_q8;
  // hind_left_hip: p of 1.2
  const Scalar p_7_1 = front_left_hip_l2 + front_left_thigh_l1 * c_hind_left_abduction;
  p[7] = p_7_1 - s_hind_left_abduction * t_hind_left_shank_1;
  const Scalar p_8_1 = c_hind_left_abduction * t_hind_left_shank_1;
  p[8] = front_left_thigh_l1 * s_hind_left_abduction + p_8_1;
  const Scalar neg_p_6_1 = front_left_hip_l1 + front_left_shank_l1 * s_hind_left_hip;
  p[6] = -(neg_p_6_1 + front_left_shank_l2 * s_q7_q8);
  const Scalar neg_s_hind_right_shank_x = front_left_shank_l1 * c_hind_right_hip;
  const Scalar t_hind_right_shank_1 = neg_s_hind_right_shank_x + front_left_shank_l2 * c_q10_q11;
  // hind_right_hip: p of 1.2
  const Scalar neg_p_10_1 = front_left_hip_l2 + front_left_thigh_l1 * c_hind_right_abduction;
  p[10] = -(neg_p_10_1 + s_hind_right_abduction * t_hind_right_shank_1);
  const Scalar neg_p_11_1 = c_hind_right_abduction * t_hind_right_shank_1;
  p[11] = neg_p_11_1 - front_left_thigh_l1 * s_hind_right_abduction;
  const Scalar neg_p_9_1 = front_left_hip_l1 + front_left_shank_l1 * s_hind_right_hip;
  p[9] = -(neg_p_9_1 + front_left_shank_l2 * s_q10_q11);
}

void force_jacobian_transpose(const Scalar q[12], Scalar C[144]) noexcept {
  // front_left_hip: r of (9)
  const Scalar q_q7_q8 = q[7] + q[8];
  const Scalar q_q4_q5 = q[4] + q[5];
  const Scalar q_q1_q2 = q[1] + q[2];
  const Scalar q_q10_q11 = q[10] + q[11];
  Scalar sines[12];
  Scalar cosines[12];
  sines_cosines(sines, cosines, q[0], q[1], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[6], q[7], q[9], q[10]);
  sines_cosines(sines + 8, cosines + 8, q_q7_q8, q_q4_q5, q_q1_q2, q_q10_q11);
  const Scalar s_front_left_abduction = sines[0];
  const Scalar c_front_left_abduction = cosines[0];
  const Scalar s_front_left_hip = sines[1];
  const Scalar c_front_left_hip = cosines[1];
  const Scalar s_front_right_abduction = sines[2];
  const Scalar c_front_right_abduction = cosines[2];
  const Scalar s_front_right_hip = sines[3];
  const Scalar c_front_right_hip = cosines[3];
  const Scalar s_hind_left_abduction = sines[4];
  const Scalar c_hind_left_abduction = cosines[4];
  const Scalar s_hind_left_hip = sines[5];
  const Scalar c_hind_left_hip = cosines[5];
  const Scalar s_hind_right_abduction = sines[6];
  const Scalar c_hind_right_abduction = cosines[6];
  const Scalar s_hind_right_hip = sines[7];
  const Scalar c_hind_right_hip = cosines[7];
  const Scalar s_q7_q8 = sines[8];
  const Scalar c_q7_q8 = cosines[8];
  const Scalar s_q4_q5 = sines[9];
  const Scalar c_q4_q5 = cosines[9];
  const Scalar s_q1_q2 = sines[10];
  const Scalar c_q1_q2 = cosines[10];
  const Scalar s_q10_q11 = sines[11];
  const Scalar c_q10_q11 = cosines[11];
  const Scalar neg_r_hind_left_shank_y = front_left_shank_l2 * s_q7_q8;
  const Scalar neg_r_fron_righ_shan_y = front_left_shank_l2 * s_q4_q5;
  const Scalar neg_r_hind_left_shank_x = front_left_shank_l2 * c_q7_q8;
  C[102] = -neg_r_hind_left_shank_x;
  const Scalar neg_r_front_left_shank_x = front_left_shank_l2 * c_q1_q2;
  C[24] = -neg_r_front_left_shank_x;
  const Scalar neg_r_hind_right_shank_y = front_left_shank_l2 * s_q10_q11;
  const Scalar neg_r_hind_right_shank_x = front_left_shank_l2 * c_q10_q11;
  C[141] = -neg_r_hind_right_shank_x;
  const Scalar neg_r_front_left_shank_y = front_left_shank_l2 * s_q1_q2;
  const Scalar neg_r_fron_righ_shan_x = front_left_shank_l2 * c_q4_q5;
  C[63] = -neg_r_fron_righ_shan_x;
  const Scalar neg_r_front_left_thigh_y =
      neg_r_front_left_shank_y + front_left_shank_l1 * s_front_left_hip;
  const Scalar neg_r_front_left_thigh_x =
      neg_r_front_left_shank_x + front_left_shank_l1 * c_front_left_hip;
  C[12] = -neg_r_front_left_thigh_x;
  // front_left_thigh: r of (9)
  const Scalar r_front_left_hip_y_1 = c_front_left_abduction * neg_r_front_left_thigh_x;
  C[1] = -(front_left_thigh_l1 * s_front_left_abduction + r_front_left_hip_y_1);
  const Scalar r_front_left_hip_x_1 = s_front_left_abduction * neg_r_front_left_thigh_x;
  // front_left_hip: r, C of (9)
  C[2] = front_left_thigh_l1 * c_front_left_abduction - r_front_left_hip_x_1;
  C[14] = -c_front_left_abduction * neg_r_front_left_thigh_y;
  C[13] = s_front_left_abduction * neg_r_front_left_thigh_y;
  C[26] = -c_front_left_abduction * neg_r_front_left_shank_y;
  C[25] = s_front_left_abduction * neg_r_front_left_shank_y;
  const Scalar neg_r_fron_righ_thig_y =
      neg_r_fron_righ_shan_y + front_left_shank_l1 * s_front_right_hip;
  const Scalar neg_r_fron_righ_thig_x =
      neg_r_fron_righ_shan_x + front_left_shank_l1 * c_front_right_hip;
  C[51] = -neg_r_fron_righ_thig_x;
  // front_right_thigh: r of (9)
  const Scalar t_fron_righ_thig_1 = c_front_right_abduction * neg_r_fron_righ_thig_x;
  C[40] = front_left_thigh_l1 * s_front_right_abduction - t_fron_righ_thig_1;
  const Scalar t_fron_righ_thig_2 = s_front_right_abduction * neg_r_fron_righ_thig_x;
  C[41] = -(front_left_thigh_l1 * c_front_right_abduction + t_fron_righ_thig_2);
  // front_left_hip: C of (9)
  C[52] = s_front_right_abduction * neg_r_fron_righ_thig_y;
  C[53] = -c_front_right_abduction * neg_r_fron_righ_thig_y;
  C[64] = s_front_right_abduction * neg_r_fron_righ_shan_y;
  C[65] = -c_front_right_abduction * neg_r_fron_righ_shan_y;
  const Scalar neg_r_hind_left_thigh_x =
      neg_r_hind_left_shank_x + front_left_shank_l1 * c_hind_left_hip;
  C[90] = -neg_r_hind_left_thigh_x;
  const Scalar neg_r_hind_left_thigh_y =
      neg_r_hind_left_shank_y + front_left_shank_l1 * s_hind_left_hip;
  // hind_left_thigh: r of (9)
  const Scalar r_hind_left_hip_y_1 = c_hind_left_abduction * neg_r_hind_left_thigh_x;
  C[79] = -(front_left_thigh_l1 * s_hind_left_abduction + r_hind_left_hip_y_1);
  const Scalar r_hind_left_hip_x_1 = s_hind_left_abduction * neg_r_hind_left_thigh_x;
  C[80] = front_left_thigh_l1 * c_hind_left_abduction - r_hind_left_hip_x_1;
  // front_left_hip: C of (9)
  C[91] = s_hind_left_abduction * neg_r_hind_left_thigh_y;
  C[92] = -c_hind_left_abduction * neg_r_hind_left_thigh_y;
  C[103] = s_hind_left_abduction * neg_r_hind_left_shank_y;
  C[104] = -c_hind_left_abduction * neg_r_hind_left_shank_y;
  const Scalar neg_r_hind_right_thigh_y =
      neg_r_hind_right_shank_y + front_left_shank_l1 * s_hind_right_hip;
  const Scalar neg_r_hind_right_thigh_x =
      neg_r_hind_right_shank_x + front_left_shank_l1 * c_hind_right_hip;
  C[129] = -neg_r_hind_right_thigh_x;
  const Scalar t_hind_right_thigh_1 = s_hind_right_abduction * neg_r_hind_right_thigh_x;
  C[119] = -(front_left_thigh_l1 * c_hind_right_abduction + t_hind_right_thigh_1);
  const Scalar t_hind_right_thigh_2 = c_hind_right_abduction * neg_r_hind_right_thigh_x;
  C[118] = front_left_thigh_l1 * s_hind_right_abduction - t_hind_right_thigh_2;
  C[130] = s_hind_right_abduction * neg_r_hind_right_thigh_y;
  C[131] = -c_hind_right_abduction * neg_r_hind_right_thigh_y;
  C[143] = -c_hind_right_abduction * neg_r_hind_right_shank_y;
  C[142] = s_hind_right_abduction * neg_r_hind_right_shank_y;
  force_jacobian_transpose_0(C);
}

}  // namespace quadruped
