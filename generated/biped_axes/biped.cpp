// biped.cpp: see biped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate biped.yaml --base axes

#include "biped.hpp"

namespace biped {

static_assert(kDigest == 0x36d792ddc01aa864ULL, "header and source are of different runs");
static_assert(sizeof(1.0) == sizeof(double), "not for -fsingle-precision-constant");
// Zeros, where compilers may store neighbours at once.
namespace {

[[gnu::noinline]] void mass_matrix_0(Scalar A[324]) noexcept {
  A[1] = 0.0;
  A[2] = 0.0;
  A[18] = 0.0;
  A[20] = 0.0;
  A[36] = 0.0;
  A[37] = 0.0;
  A[39] = 0.0;
  A[56] = 0.0;
  A[120] = 0.0;
  A[121] = 0.0;
  A[122] = 0.0;
  A[123] = 0.0;
  A[124] = 0.0;
  A[125] = 0.0;
  A[138] = 0.0;
  A[139] = 0.0;
  A[140] = 0.0;
  A[141] = 0.0;
  A[142] = 0.0;
  A[143] = 0.0;
  A[156] = 0.0;
  A[157] = 0.0;
  A[158] = 0.0;
  A[159] = 0.0;
  A[160] = 0.0;
  A[161] = 0.0;
  A[174] = 0.0;
  A[175] = 0.0;
  A[176] = 0.0;
  A[177] = 0.0;
  A[178] = 0.0;
  A[179] = 0.0;
  A[192] = 0.0;
  A[193] = 0.0;
  A[194] = 0.0;
  A[195] = 0.0;
  A[196] = 0.0;
  A[197] = 0.0;
  A[210] = 0.0;
  A[211] = 0.0;
  A[212] = 0.0;
  A[213] = 0.0;
  A[214] = 0.0;
  A[215] = 0.0;
  A[222] = 0.0;
  A[223] = 0.0;
  A[224] = 0.0;
  A[225] = 0.0;
  A[226] = 0.0;
  A[227] = 0.0;
  A[240] = 0.0;
  A[241] = 0.0;
  A[242] = 0.0;
  A[243] = 0.0;
  A[244] = 0.0;
  A[245] = 0.0;
  A[258] = 0.0;
  A[259] = 0.0;
  A[260] = 0.0;
  A[261] = 0.0;
  A[262] = 0.0;
  A[263] = 0.0;
  A[276] = 0.0;
  A[277] = 0.0;
  A[278] = 0.0;
  A[279] = 0.0;
  A[280] = 0.0;
  A[281] = 0.0;
  A[294] = 0.0;
  A[295] = 0.0;
  A[296] = 0.0;
  A[297] = 0.0;
  A[298] = 0.0;
  A[299] = 0.0;
  A[312] = 0.0;
  A[313] = 0.0;
  A[314] = 0.0;
  A[315] = 0.0;
  A[316] = 0.0;
  A[317] = 0.0;
}

[[gnu::noinline]] void force_jacobian_transpose_0(Scalar C[216]) noexcept {
  C[1] = 0.0;
  C[2] = 0.0;
  C[4] = 0.0;
  C[5] = 0.0;
  C[7] = 0.0;
  C[8] = 0.0;
  C[10] = 0.0;
  C[11] = 0.0;
  C[12] = 0.0;
  C[14] = 0.0;
  C[15] = 0.0;
  C[17] = 0.0;
  C[18] = 0.0;
  C[20] = 0.0;
  C[21] = 0.0;
  C[23] = 0.0;
  C[24] = 0.0;
  C[25] = 0.0;
  C[27] = 0.0;
  C[28] = 0.0;
  C[30] = 0.0;
  C[31] = 0.0;
  C[33] = 0.0;
  C[34] = 0.0;
  C[38] = 0.0;
  C[41] = 0.0;
  C[44] = 0.0;
  C[47] = 0.0;
  C[78] = 0.0;
  C[79] = 0.0;
  C[80] = 0.0;
  C[81] = 0.0;
  C[82] = 0.0;
  C[83] = 0.0;
  C[90] = 0.0;
  C[91] = 0.0;
  C[92] = 0.0;
  C[93] = 0.0;
  C[94] = 0.0;
  C[95] = 0.0;
  C[102] = 0.0;
  C[103] = 0.0;
  C[104] = 0.0;
  C[105] = 0.0;
  C[106] = 0.0;
  C[107] = 0.0;
  C[114] = 0.0;
  C[115] = 0.0;
  C[116] = 0.0;
  C[117] = 0.0;
  C[118] = 0.0;
  C[119] = 0.0;
  C[126] = 0.0;
  C[127] = 0.0;
  C[128] = 0.0;
  C[129] = 0.0;
  C[130] = 0.0;
  C[131] = 0.0;
  C[138] = 0.0;
  C[139] = 0.0;
  C[140] = 0.0;
  C[141] = 0.0;
  C[142] = 0.0;
  C[143] = 0.0;
  C[144] = 0.0;
  C[145] = 0.0;
  C[146] = 0.0;
  C[147] = 0.0;
  C[148] = 0.0;
  C[149] = 0.0;
  C[156] = 0.0;
  C[157] = 0.0;
  C[158] = 0.0;
  C[159] = 0.0;
  C[160] = 0.0;
  C[161] = 0.0;
  C[168] = 0.0;
  C[169] = 0.0;
  C[170] = 0.0;
  C[171] = 0.0;
  C[172] = 0.0;
  C[173] = 0.0;
  C[180] = 0.0;
  C[181] = 0.0;
  C[182] = 0.0;
  C[183] = 0.0;
  C[184] = 0.0;
  C[185] = 0.0;
  C[192] = 0.0;
  C[193] = 0.0;
  C[194] = 0.0;
  C[195] = 0.0;
  C[196] = 0.0;
  C[197] = 0.0;
  C[204] = 0.0;
  C[205] = 0.0;
  C[206] = 0.0;
  C[207] = 0.0;
  C[208] = 0.0;
  C[209] = 0.0;
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

// m/s^2: gravity
constexpr double base_g1 = -9.81;

// kg: mass of base_rx to right_foot (13 links)
constexpr double base_rx_m1 = 80.661;
// kg: mass of base_rx, left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; mass, com z
//     of left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr double base_rx_m2 = 63.86479092;
// kg: mass, com y of base_rx; mass, offset y of left_hip_block, right_hip_block; mass of
//     left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; offset z of
//     left_shank, right_shank
constexpr double base_rx_m3 = 5.720071111041666;
// kg: mass, com y of base_rx; offset y of left_hip_block, right_hip_block
constexpr double base_rx_m4 = 51.81132434895834;
// kg m: mass, com y of base_rx
constexpr double base_rx_h1 = 0.0494584755;
// kg m: mass, com z of base_rx; mass, com z, offset z of left_hip_block, right_hip_block; mass,
//     offset z of left_hip_fork, right_hip_fork; mass, offset y of left_thigh, right_thigh; mass of
//     left_shank, left_ankle_cross, left_foot, right_shank, right_ankle_cross, right_foot
constexpr double base_rx_h2 = 8.4556102785;
// kg m: mass, com x of base_rx
constexpr double base_rx_h3 = 0.086212924;
// kg m: mass, com z of base_rx, left_ankle_cross, right_ankle_cross; mass, com z, offset z of
//     left_hip_block, right_hip_block; mass, offset x z of left_hip_fork, right_hip_fork; mass,
//     offset y of left_thigh, right_thigh; mass of left_shank, right_shank; offset z of left_foot,
//     right_foot
constexpr double base_rx_h4 = 8.6714533185;
// kg m: mass, com x of base_rx
constexpr double base_rx_h5 = 0.172425848;
// kg m: mass, com z of base_rx; mass, com z, offset z of left_hip_block, right_hip_block; mass,
//     offset z of left_hip_fork, right_hip_fork; mass, com z, offset y of left_thigh, right_thigh;
//     offset z of left_shank, right_shank
constexpr double base_rx_h6 = 10.37037811362;
// kg m: mass, com y z of base_rx; mass, com z, offset y z of left_hip_block, right_hip_block;
//     offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double base_rx_h7 = 11.74447330271875;
// kg m^2: mass, com y, inertia xx yy zz of base_rx; mass, com y, inertia xx yy zz, offset y of
//     left_hip_block, right_hip_block; mass, com z, inertia xx yy zz, offset x of left_hip_fork,
//     right_hip_fork; mass, com z, inertia xx yy zz of left_thigh, right_thigh; mass, com z,
//     inertia xx yy zz, offset z of left_shank, left_ankle_cross, right_shank, right_ankle_cross;
//     mass, com y z, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double base_rx_I1 = 3.7285933231085773;
// kg m^2: mass, com z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset z of
//     left_hip_block, right_hip_block; mass, com y, inertia xx yy zz, offset z of left_hip_fork,
//     right_hip_fork; mass, com y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com
//     y, inertia xx yy zz of left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass,
//     com y z, inertia xx yy zz of left_foot, right_foot
constexpr double base_rx_I2 = 5.214202433961874;
// kg m^2: mass, com x, inertia xx yy zz of base_rx to right_ankle_cross (9 links); mass, com x,
//     inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x, inertia xx yy zz,
//     offset z of left_foot, right_foot
constexpr double base_rx_I3 = 0.22259776637311807;
// kg m^2: mass, com y z, inertia yz of base_rx
constexpr double base_rx_I4 = 0.0119045769944955;
// kg m^2: mass, com x z, inertia xz of base_rx
constexpr double base_rx_I5 = 0.062513175334862;
// kg m^2: mass, com x y, inertia xy of base_rx
constexpr double base_rx_I6 = -0.001200009986336;
// kg m^2: mass, com y, inertia xx yy zz of base_rx; mass, offset y of left_hip_block,
//     right_hip_block; mass, offset x of left_hip_fork, right_hip_fork; mass of left_thigh,
//     left_shank, right_thigh, right_shank; mass, com z of left_ankle_cross, right_ankle_cross;
//     offset z of left_foot, right_foot
constexpr double base_rx_I7 = 0.7481424035725185;
// kg m^2: mass, com x, inertia xx yy zz of base_rx
constexpr double base_rx_I8 = 0.308644651420672;
// kg m^2: mass, com x, inertia xx yy zz of base_rx
constexpr double base_rx_I9 = 0.154322325710336;
// kg m^2: mass, com z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset z of
//     left_hip_block, right_hip_block; mass, offset x z of left_hip_fork, right_hip_fork; mass,
//     offset y of left_thigh, right_thigh; mass of left_shank, right_shank; mass, com z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double base_rx_I10 = 5.128837528104454;
// kg m^2: mass, com y, inertia xx yy zz of base_rx; mass, offset y of left_hip_block,
//     right_hip_block; mass of left_hip_fork, right_hip_fork; mass, com z of left_thigh,
//     right_thigh; offset z of left_shank, right_shank
constexpr double base_rx_I11 = 0.6512320135077433;
// kg m^2: mass, com z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset z of
//     left_hip_block, right_hip_block; mass, offset z of left_hip_fork, right_hip_fork; mass, com
//     z, offset y of left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr double base_rx_I12 = 4.935160101460775;
// kg m^2: mass, com y z, inertia yz of base_rx; offset z of left_hip_block, left_hip_fork,
//     right_hip_block, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double base_rx_I13 = -0.0175428432014955;
// kg m^2: mass, com x y, inertia zz of base_rx; offset y of left_hip_block, right_hip_block
constexpr double base_rx_I14 = 0.7271729410866306;
// kg m^2: mass, com x y, inertia xx yy of base_rx; offset y of left_hip_block, right_hip_block
constexpr double base_rx_I15 = -0.4185282896659585;
// kg m^2: mass, com y z, inertia xx of base_rx; mass, com y z, inertia xx, offset y z of
//     left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double base_rx_I16 = 5.352785456639811;
// kg m^2: mass, com, inertia yy of base_rx; mass, com x z, inertia yy, offset y z of
//     left_hip_block, right_hip_block; mass, com x y, inertia xx yy zz, offset x z of
//     left_hip_fork, right_hip_fork; mass, com y z, inertia xx yy zz, offset y of left_thigh,
//     right_thigh; mass, com y, inertia xx yy zz, offset z of left_shank, right_shank; mass, com y,
//     inertia xx yy zz of left_ankle_cross, right_ankle_cross; mass, offset z of left_foot,
//     right_foot
constexpr double base_rx_I17 = 4.967815396366181;
// kg m^2: mass, com y z, inertia yy zz of base_rx; mass, com z, inertia xx yy zz, offset y z of
//     left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double base_rx_I18 = 4.205662634527222;
// kg m^2: mass, com, inertia xx zz of base_rx; mass, com z, inertia xx yy zz, offset y z of
//     left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double base_rx_I19 = 4.624190924193181;
// N: gravity; mass of base_rx to right_foot (13 links)
constexpr double base_rx_w1 = -791.28441;

// kg: mass of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; mass, com z of
//     left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr double left_hip_block_m1 = 6.33339546;
// m: offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_l1 = 0.08064;
// m: offset z of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double left_hip_block_l2 = -0.114;
// m: offset z of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double left_hip_block_l3 = -0.228;
// m: offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_l4 = 0.16128;
// kg m: mass, com y of left_hip_block, right_hip_block
constexpr double left_hip_block_h1 = 0.00633696;
// kg m: mass, com x of left_hip_block, right_hip_block; mass, com x, offset x of left_hip_fork,
//     right_hip_fork; mass of left_thigh, left_shank, left_ankle_cross, right_thigh, right_shank,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_hip_block_h2 = 0.14177016;
// kg m: mass, com x of left_hip_block, right_hip_block; mass, com x, offset x of left_hip_fork,
//     right_hip_fork; mass of left_thigh, left_shank, right_thigh, right_shank; mass, com z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_block_h3 = 0.13230336;
// kg m: mass, com x of left_hip_block, right_hip_block; mass, com x, offset x of left_hip_fork,
//     right_hip_fork; mass, com z of left_thigh, right_thigh; offset z of left_shank, left_foot,
//     right_shank, right_foot
constexpr double left_hip_block_h4 = 0.0577891146;
// kg m^2: mass, com x z, offset z of left_hip_block, right_hip_block; mass, com x, offset x z of
//     left_hip_fork, right_hip_fork; mass, offset y of left_thigh, right_thigh; mass of left_shank,
//     left_ankle_cross, right_shank, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_hip_block_I1 = -0.016536471;
// kg m^2: mass, com y z, offset z of left_hip_block, right_hip_block; mass, com y z of
//     left_hip_fork, right_hip_fork
constexpr double left_hip_block_I2 = -0.0005307204;
// kg m^2: mass, com y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com z, inertia xx
//     yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_thigh, right_thigh; mass, com z, inertia xx yy zz, offset z of left_shank,
//     left_ankle_cross, right_shank, right_ankle_cross; mass, com y z, inertia xx yy zz, offset z
//     of left_foot, right_foot
constexpr double left_hip_block_I3 = 1.662442605941911;
// kg m^2: mass, com x y of left_hip_block, right_hip_block
constexpr double left_hip_block_I4 = -0.00013941312;
// kg m^2: mass, com x, inertia xx yy zz of left_hip_block to right_ankle_cross (8 links); mass, com
//     x, inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x, inertia xx yy
//     zz, offset z of left_foot, right_foot
constexpr double left_hip_block_I5 = 0.04027288857824064;
// kg m^2: mass, com x, inertia xx yy zz of left_hip_block, left_thigh, right_hip_block,
//     right_thigh; mass, com x, inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass
//     of left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass, offset z of left_foot,
//     right_foot
constexpr double left_hip_block_I6 = 0.02800255208454144;
// kg m^2: mass, com y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com z, inertia xx
//     yy zz of left_hip_fork, left_thigh, right_hip_fork, right_thigh; mass, offset z of
//     left_shank, right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_hip_block_I7 = 1.305696154009892;
// kg m^2: mass, com x y of left_hip_block, right_hip_block
constexpr double left_hip_block_I8 = -6.970656e-05;
// kg m^2: mass, com x z, offset z of left_hip_block, right_hip_block; mass, com x, offset x z of
//     left_hip_fork, right_hip_fork; mass, offset y of left_thigh, right_thigh; mass of left_shank,
//     right_shank; mass, com z of left_ankle_cross, right_ankle_cross; offset z of left_foot,
//     right_foot
constexpr double left_hip_block_I9 = -0.0154572558;
// kg m^2: mass, com y, inertia xx yy zz of left_hip_block, right_hip_block
constexpr double left_hip_block_I10 = 0.00071079568;
// kg m^2: mass, com y z, offset z of left_hip_block, right_hip_block
constexpr double left_hip_block_I11 = -0.00044992416;
// kg m^2: mass, com x, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia xx
//     yy zz, offset x of left_hip_fork, right_hip_fork; mass of left_thigh, left_shank,
//     right_thigh, right_shank; mass, com z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_hip_block_I12 = 0.00325739064;
// kg m^2: mass, com y, offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_I13 = 0.0005110124544;
// kg m^2: mass, com x, offset y of left_hip_block, right_hip_block; mass, com x, offset x of
//     left_hip_fork, right_hip_fork; mass of left_thigh, left_shank, right_thigh, right_shank;
//     mass, com z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_block_I14 = 0.0106689429504;
// kg m^2: mass, com x z of left_hip_block, right_hip_block; offset z of left_hip_fork,
//     right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_I15 = -0.00037467276;
// kg m^2: mass, com y z of left_hip_block, right_hip_block; offset z of left_hip_fork,
//     right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_I16 = 0.00027248928;
// kg m^2: mass, com x, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia xx
//     yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh;
//     offset z of left_shank, left_foot, right_shank, right_foot
constexpr double left_hip_block_I17 = 0.002512248186;
// kg m^2: mass, com x y, inertia xx yy of left_hip_block, right_hip_block; mass, com x, inertia xx
//     yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh;
//     offset z of left_shank, left_foot, right_shank, right_foot
constexpr double left_hip_block_I18 = 0.001801452506;
// kg m^2: mass, com x y, inertia zz of left_hip_block, right_hip_block; mass, com x z, inertia yy,
//     offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; offset z
//     of left_shank, left_foot, right_shank, right_foot
constexpr double left_hip_block_I19 = 0.003489196186;
// kg m^2: mass, com y z of left_hip_block, right_hip_block; mass, com y z, offset z of
//     left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_I20 = 0.00019169304;
// kg m^2: mass, com x, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x y, inertia
//     zz, offset x z of left_hip_fork, right_hip_fork; mass, com y z, inertia xx yy zz, offset y of
//     left_thigh, right_thigh; mass, com y, inertia xx yy zz, offset z of left_shank, right_shank;
//     mass, com y, inertia xx yy zz of left_ankle_cross, right_ankle_cross; mass, offset z of
//     left_foot, right_foot
constexpr double left_hip_block_I21 = 0.03246757256632736;
// m^2: offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_p1 = 0.0065028096;
// kg^2 m^4: mass, com x z of left_hip_block, right_hip_block; offset z of left_hip_fork,
//     right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_p2 = 1.403796770860176e-07;
// m^2: offset y z of left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork;
//     offset y of left_thigh, right_thigh
constexpr double left_hip_block_p3 = -0.00919296;

// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_l1 = 0.01;
// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_l2 = 0.02;
// m: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_fork_l3 = -0.02;
// kg m: mass, com y, offset z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_h1 = -0.40746668256;
// kg m: mass, com z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_h2 = -0.00475272;
// kg m: mass, com y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_h3 = -0.38853308256;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I1 = -0.00016159248;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_hip_fork_I2 = -0.0042631913856;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xz yz of
//     left_thigh, left_shank, right_thigh, right_shank; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_hip_fork_I3 = -0.03467671360129536;
// kg m^2: mass, com y z, inertia yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y z,
//     inertia yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz, offset z
//     of left_shank, right_shank; mass, com y z, inertia yy zz, offset z of left_ankle_cross,
//     left_foot, right_ankle_cross, right_foot
constexpr double left_hip_fork_I4 = 1.6313524106132014;
// kg m^2: mass, com y z, inertia xx, offset x z of left_hip_fork, right_hip_fork; mass, com y z,
//     inertia xx, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy, offset z of
//     left_shank, right_shank; mass, com y z, inertia xx, offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr double left_hip_fork_I5 = 1.6921112099106208;
// kg m^2: mass, com z, inertia xx yy zz of left_hip_fork, left_thigh, right_hip_fork, right_thigh;
//     mass, offset z of left_shank, right_shank; mass of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr double left_hip_fork_I6 = 1.3049853583298918;
// kg m^2: mass, com y, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass, com y z, inertia xx yy zz
//     of left_foot, right_foot
constexpr double left_hip_fork_I7 = 0.030379399648709733;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I8 = -8.079624e-05;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I9 = 0.0040738553856;
// kg m^2: mass, com z, inertia xx yy zz of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I10 = 0.00026615232;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; offset z of left_foot,
//     right_foot
constexpr double left_hip_fork_I11 = -0.00011406528;
// kg m^2: mass, com y, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I12 = 0.02957665238032736;
// kg m^2: mass, com y z, inertia xx, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I13 = 0.02984280470032736;
// kg m^2: mass, com y z, inertia yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I14 = 0.02931050006032736;
// kg m^2: mass, com y, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I15 = 0.02995532438032736;
// kg m^2: mass, com y z, inertia xx, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I16 = 0.03022147670032736;
// kg m^2: mass, com y z, inertia yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I17 = 0.02968917206032736;
// m^2: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_p1 = 0.0001;

// kg: mass, com z of left_thigh, right_thigh; mass, com z, offset z of left_shank, right_shank;
//     offset z of left_ankle_cross, right_ankle_cross
constexpr double left_thigh_m1 = -5.84786454;
// kg: mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank; mass of
//     left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_m2 = 8.39810454;
// kg: mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank; mass of
//     left_ankle_cross, right_ankle_cross; mass, com y z, inertia xx of left_foot, right_foot
constexpr double left_thigh_m3 = 8.19461557789365;
// kg m: mass, com x of left_thigh, right_thigh
constexpr double left_thigh_h1 = -0.14731530912;
// kg m: mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank; mass of
//     left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_h2 = -3.62798116128;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, left_ankle_cross,
//     right_thigh, right_ankle_cross; mass, offset z of left_shank, right_shank; offset z of
//     left_foot, right_foot
constexpr double left_thigh_h3 = -3.21901540128;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr double left_thigh_I1 = 0.03939173998083072;
// kg m^2: mass, com x z, inertia xx zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_I2 = 1.2800687125653505;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com x y, inertia xy, offset y of
//     left_thigh, right_thigh
constexpr double left_thigh_I3 = 0.00442555309711872;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_thigh_I4 = 0.09232168197063167;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_thigh,
//     right_thigh; mass, com x z, inertia xx yy, offset z of left_shank, right_shank; mass, com x
//     z, inertia yy, offset z of left_ankle_cross, right_ankle_cross; mass, com, inertia yy zz,
//     offset z of left_foot, right_foot
constexpr double left_thigh_I5 = 1.6983864878801518;
// kg m^2: mass, com x z, inertia yy of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_I6 = 1.3293696994544333;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of left_thigh,
//     right_thigh; mass, offset z of left_shank, right_shank; mass, com z of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_thigh_I7 = 1.1033955042453505;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr double left_thigh_I8 = 0.01969586999041536;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_thigh_I9 = 0.08414236677063168;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, offset z of left_shank, right_shank; mass, com z of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_thigh_I10 = 1.1280459976898918;
// kg m^2: mass, com x, inertia xx yy zz of left_thigh, right_thigh
constexpr double left_thigh_I11 = 0.02465049344454144;
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr double left_thigh_I12 = -0.26256865566306814;
// kg m^2: mass, com x z, inertia xx zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr double left_thigh_I13 = 0.2872191491076096;

// kg: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass, com
//     z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_m1 = 1.60356;
// kg: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_m2 = 2.55024;
// kg: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, inertia xx of left_foot, right_foot
constexpr double left_shank_m3 = 2.3467510378936507;
// m: offset z of left_shank, right_shank
constexpr double left_shank_l1 = -0.432;
// kg m: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_h1 = -1.10425392;
// kg m: mass, com x of left_shank, right_shank
constexpr double left_shank_h2 = -0.080309376;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_h3 = -0.69434148;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr double left_shank_I1 = 0.03083291102976;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; mass, offset z of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_I2 = 0.350779421733216;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y, inertia xy of left_shank, right_shank
constexpr double left_shank_I3 = 0.001559822240256;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z, inertia xz yz of left_shank, right_shank; mass, com y, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_I4 = 0.02565802580712;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, left_ankle_cross, left_foot, right_shank,
//     right_ankle_cross, right_foot
constexpr double left_shank_I5 = 0.0122703364936992;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy of left_shank,
//     right_shank; mass, com x z, inertia yy, offset z of left_ankle_cross, right_ankle_cross;
//     mass, com, inertia yy zz, offset z of left_foot, right_foot
constexpr double left_shank_I6 = 0.36901678842571844;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, inertia xx yy zz, offset z of left_ankle_cross, right_ankle_cross;
//     mass, com y z, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_shank_I7 = 0.3567464519320192;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_shank_I8 = 0.173287335213216;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr double left_shank_I9 = 0.01541645551488;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, inertia xz yz of left_shank, right_shank; mass, com y z, offset z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_I10 = 0.01745977700712;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_shank_I11 = 0.178578772764;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, right_shank
constexpr double left_shank_I12 = 0.005291437550784;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I13 = -0.122071088076;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I14 = 0.127362525626784;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_shank_I15 = 0.010552864948912843;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xz yz of left_shank,
//     right_shank; mass, com x z of left_ankle_cross, right_ankle_cross; mass, com x, offset z of
//     left_foot, right_foot
constexpr double left_shank_I16 = 0.01596613269888;

// kg: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_m1 = 0.94668;
// m: offset z of left_ankle_cross, right_ankle_cross
constexpr double left_ankle_cross_l1 = -0.433;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_h1 = 0.0094668;
// kg m: mass, com x of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_ankle_cross_h2 = 0.0550836384;
// kg m: mass, com x of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz of
//     left_foot, right_foot
constexpr double left_ankle_cross_h3 = 0.034208266826926986;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, inertia xx, offset z of left_foot, right_foot
constexpr double left_ankle_cross_h4 = -0.007431910378936505;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y of left_ankle_cross, right_ankle_cross; mass, com x of left_foot, right_foot
constexpr double left_ankle_cross_I1 = -0.001106309568;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com y z, inertia yy zz, offset z of
//     left_foot, right_foot
constexpr double left_ankle_cross_I2 = -0.00016012430367330226;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I3 = 0.001099354368;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I4 = -0.006303306294895972;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia yy zz, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I5 = 0.007654491590934428;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, left_foot, right_ankle_cross,
//     right_foot
constexpr double left_ankle_cross_I6 = 0.0069788989429152;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I7 = 0.000549677184;
// kg m^2: mass, com y z of left_ankle_cross, right_ankle_cross
constexpr double left_ankle_cross_I8 = -6.9552e-06;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_ankle_cross_I9 = 2.40212e-05;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I10 = -0.0069548777429152;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_ankle_cross,
//     right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I11 = 0.0070029201429152;
// kg m^2: mass, com x, offset z of left_ankle_cross, right_ankle_cross; mass, com x of left_foot,
//     right_foot
constexpr double left_ankle_cross_I12 = -0.0238512154272;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I13 = 0.0001186892;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I14 = -0.0001962912;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I15 = 0.007650448025253941;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z
//     of left_foot, right_foot
constexpr double left_ankle_cross_I16 = -6.706794872165769e-05;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I17 = -0.0068602097429152;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com x y of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz, offset z of
//     left_foot, right_foot
constexpr double left_ankle_cross_I18 = -0.0006797311884980576;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, right_ankle_cross; mass, com, inertia
//     xx xy xz yy zz of left_foot, right_foot
constexpr double left_ankle_cross_I19 = 0.005261427398128842;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, right_ankle_cross; mass, com, inertia
//     xx xy xz yy zz of left_foot, right_foot
constexpr double left_ankle_cross_I20 = 0.012240326341044043;

// ratio: com y z of left_foot, right_foot
constexpr double left_foot_k1 = 0.2614691411136524;
// ratio: mass, com y z, inertia xx xy xz of left_foot, right_foot
constexpr double left_foot_k2 = -0.06420257671733756;
// ratio: mass, com, inertia xx xy xz of left_foot, right_foot
constexpr double left_foot_k3 = 1.4775221277222959;
// kg: mass, com y z, inertia xx of left_foot, right_foot
constexpr double left_foot_m1 = 0.20348896210634942;
// m: points of left_foot, right_foot
constexpr double left_foot_l1 = 0.20904;
// m: points of left_foot, right_foot
constexpr double left_foot_l2 = -0.05903;
// m: points of left_foot, right_foot
constexpr double left_foot_l3 = -0.06;
// kg m: mass, com y z of left_foot, right_foot
constexpr double left_foot_h1 = 0.014128635491404699;
// kg m: mass, com y z, inertia xx xy xz of left_foot, right_foot
constexpr double left_foot_h2 = -0.0009070948040482083;
// kg m: mass, com, inertia xx xy xz of left_foot, right_foot
constexpr double left_foot_h3 = 0.020875371573073016;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com y z, inertia xx, offset z of
//     left_foot, right_foot
constexpr double left_foot_h4 = 0.0020348896210634943;
// kg m^2: com y z, inertia xy xz of left_foot, right_foot
constexpr double left_foot_I1 = -6.298136129784905e-05;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_I2 = 0.0014494177603079786;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z of left_foot, right_foot
constexpr double left_foot_I3 = -0.00028257270982809396;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr double left_foot_I4 = 0.00014128635491404698;
// kg m^2: mass, com y z, inertia xx of left_foot, right_foot
constexpr double left_foot_I5 = 0.0009809787164016;
// kg m^2: offset z of left_ankle_cross, right_ankle_cross; mass, com y z of left_foot, right_foot
constexpr double left_foot_I6 = -0.006117699167778235;
// kg m^2: offset z of left_shank, right_shank; mass, com y z of left_foot, right_foot
constexpr double left_foot_I7 = -0.00610357053228683;
// kg m^2: mass, com y z, inertia yy zz of left_foot, right_foot
constexpr double left_foot_I8 = 0.00013282817963685661;
// kg m^2: com y z, inertia yy zz of left_foot, right_foot
constexpr double left_foot_I9 = 7.233379265339546e-05;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr double left_foot_I10 = 0.00028257270982809396;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z of left_foot, right_foot
constexpr double left_foot_I11 = -0.0005651454196561879;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I12 = 0.0005569034480192284;
// kg m^2: com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I13 = 0.0004240752683823717;
// kg m^2: com y z, inertia yy zz of left_foot, right_foot
constexpr double left_foot_I14 = 3.616689632669773e-05;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I15 = -0.00012922325127834232;
// kg m^2: mass, com y z, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I16 = 0.0005528598823387408;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I17 = 0.0017174715447863577;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I18 = 0.0022703314271250983;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I19 = -0.00025844650255668465;
// kg^-1 m^-2: mass, com y z, inertia xx of left_foot, right_foot
constexpr double left_foot_p1 = 1019.3901083482966;
// m^-1: mass, com y z, inertia xx of left_foot, right_foot
constexpr double left_foot_p2 = 14.402591264396625;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

void mass_matrix(const Scalar q[18], Scalar A[324]) noexcept {
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const Scalar angle_left_foot = left_foot_k1 + q[11];
  const Scalar q_q14_q15 = q[14] + q[15];
  const Scalar q_q14_q15_q16 = q_q14_q15 + q[16];
  const Scalar angle_right_foot = left_foot_k1 - q[17];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[3], q[4], q[5], q[6]);
  sines_cosines(sines + 4, cosines + 4, q[7], q[8], q_q8_q9_q10, q_q8_q9);
  sines_cosines(sines + 8, cosines + 8, angle_left_foot, q[12], q[13], q[14]);
  sines_cosines(sines + 12, cosines + 12, q_q14_q15_q16, q_q14_q15, angle_right_foot);
  const Scalar s_base_rz = sines[0];
  const Scalar c_base_rz = cosines[0];
  const Scalar s_base_ry = sines[1];
  const Scalar c_base_ry = cosines[1];
  const Scalar s_base_rx = sines[2];
  const Scalar c_base_rx = cosines[2];
  const Scalar s_left_hip_yaw = sines[3];
  const Scalar c_left_hip_yaw = cosines[3];
  const Scalar s_left_hip_roll = sines[4];
  const Scalar c_left_hip_roll = cosines[4];
  const Scalar s_left_hip_pitch = sines[5];
  const Scalar c_left_hip_pitch = cosines[5];
  const Scalar s_q8_q9_q10 = sines[6];
  const Scalar c_q8_q9_q10 = cosines[6];
  const Scalar s_q8_q9 = sines[7];
  const Scalar c_q8_q9 = cosines[7];
  const Scalar s_left_foot = sines[8];
  const Scalar c_left_foot = cosines[8];
  const Scalar s_right_hip_yaw = sines[9];
  const Scalar c_right_hip_yaw = cosines[9];
  const Scalar s_right_hip_roll = sines[10];
  const Scalar c_right_hip_roll = cosines[10];
  const Scalar s_right_hip_pitch = sines[11];
  const Scalar c_right_hip_pitch = cosines[11];
  const Scalar s_q14_q15_q16 = sines[12];
  const Scalar c_q14_q15_q16 = cosines[12];
  const Scalar s_q14_q15 = sines[13];
  const Scalar c_q14_q15 = cosines[13];
  const Scalar s_right_foot = sines[14];
  const Scalar c_right_foot = cosines[14];
  const Scalar s_left_shank_y = left_shank_l1 * s_left_hip_pitch;
  const Scalar s_left_shank_x = left_shank_l1 * c_left_hip_pitch;
  const Scalar s_left_ankle_cross_y = left_ankle_cross_l1 * s_q8_q9;
  const Scalar s_left_ankle_cross_x = left_ankle_cross_l1 * c_q8_q9;
  const Scalar s_right_shank_y = left_shank_l1 * s_right_hip_pitch;
  const Scalar s_right_shank_x = left_shank_l1 * c_right_hip_pitch;
  const Scalar s_righ_ankl_cros_y = left_ankle_cross_l1 * s_q14_q15;
  // base_ry: Rx, Ry of (2)
  const Scalar Rx_base_ry_y = c_base_rz * c_base_ry;
  const Scalar Ry_base_ry_y = s_base_rz * c_base_ry;
  const Scalar Rx_base_ry_x = c_base_rz * s_base_ry;
  const Scalar Rx_left_hip_block_z = c_base_rx * Rx_base_ry_x + s_base_rz * s_base_rx;
  const Scalar neg_Rx_base_rx_x = s_base_rx * Rx_base_ry_x - s_base_rz * c_base_rx;
  const Scalar Ry_base_ry_x = s_base_rz * s_base_ry;
  const Scalar Ry_left_hip_block_z = c_base_rx * Ry_base_ry_x - c_base_rz * s_base_rx;
  const Scalar neg_Ry_base_rx_x = s_base_rx * Ry_base_ry_x + c_base_rz * c_base_rx;
  const Scalar neg_Rz_base_rx_x = c_base_ry * s_base_rx;
  const Scalar Rz_left_hip_block_z = c_base_ry * c_base_rx;
  // right_foot: first moment h, A of (2)
  const Scalar t_right_foot_1 = left_foot_h1 * c_right_foot;
  const Scalar neg_h_righ_ankl_cros_z = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_2 = left_foot_I8 * s_right_foot + left_foot_I9 * c_right_foot;
  const Scalar t_right_foot_3 = s_right_foot * t_right_foot_2;
  const Scalar neg_A_305 = left_foot_I1 * c_right_foot - left_foot_I2 * s_right_foot;
  A[305] = -neg_A_305;
  A[322] = A[305];
  const Scalar t_right_foot_4 = left_foot_I1 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_5 = left_foot_I4 * s_right_foot;
  // right_ankle_cross: first moment h, A, second moments E of (2)
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_h1 + t_right_foot_1;
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_h2 * s_q14_q15_q16;
  const Scalar t_righ_ankl_cros_2 = t_righ_ankl_cros_1 + c_q14_q15_q16 * h_righ_ankl_cros_x;
  const Scalar neg_h_right_shank_x_1 = t_righ_ankl_cros_2 - left_shank_h1 * c_q14_q15;
  const Scalar neg_h_right_shank_x = neg_h_right_shank_x_1 + left_shank_h2 * s_q14_q15;
  const Scalar t_righ_ankl_cros_3 = left_ankle_cross_h2 * c_q14_q15_q16;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 - s_q14_q15_q16 * h_righ_ankl_cros_x;
  const Scalar h_right_shank_y_1 = t_righ_ankl_cros_4 + left_shank_h1 * s_q14_q15;
  const Scalar h_right_shank_y = h_right_shank_y_1 + left_shank_h2 * c_q14_q15;
  const Scalar neg_E_righ_ankl_cros_yz = left_ankle_cross_I1 + neg_A_305;
  const Scalar t_righ_ankl_cros_5 = t_right_foot_3 - left_foot_I10 * c_right_foot;
  const Scalar t_righ_ankl_cros_6 = c_q14_q15_q16 * t_right_foot_4;
  const Scalar t_righ_ankl_cros_7 = left_ankle_cross_I4 - t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_8 = s_q14_q15_q16 * t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_9 = t_righ_ankl_cros_8 - left_ankle_cross_I3 * c_q14_q15_q16;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_9 - 2.0 * t_righ_ankl_cros_6;
  const Scalar E_righ_ankl_cros_xz_1 = left_ankle_cross_I2 - t_right_foot_5;
  const Scalar E_righ_ankl_cros_xz_2 = left_foot_I3 - t_right_foot_2;
  const Scalar E_righ_ankl_cros_xz = E_righ_ankl_cros_xz_1 + c_right_foot * E_righ_ankl_cros_xz_2;
  const Scalar neg_A_250_1 = c_q14_q15_q16 * neg_E_righ_ankl_cros_yz;
  const Scalar neg_A_250 = neg_A_250_1 - s_q14_q15_q16 * E_righ_ankl_cros_xz;
  A[250] = -neg_A_250;
  A[301] = A[250];
  const Scalar t_righ_ankl_cros_11 = s_q14_q15_q16 * neg_E_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_12 = t_righ_ankl_cros_11 + c_q14_q15_q16 * E_righ_ankl_cros_xz;
  const Scalar t_righ_ankl_cros_13 = left_ankle_cross_l1 * t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_14 = s_q14_q15 * t_righ_ankl_cros_13;
  const Scalar s_righ_ankl_cros_x = left_ankle_cross_l1 * c_q14_q15;
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_2 * s_righ_ankl_cros_x;
  const Scalar A_304 = left_ankle_cross_I5 - t_righ_ankl_cros_5;
  A[304] = A_304;
  const Scalar neg_h_right_thigh_x_1 = neg_h_right_shank_x + left_thigh_h1 * s_right_hip_pitch;
  const Scalar neg_h_right_thigh_x = neg_h_right_thigh_x_1 - left_thigh_h2 * c_right_hip_pitch;
  const Scalar h_right_thigh_y_1 = h_right_shank_y + left_thigh_h2 * s_right_hip_pitch;
  const Scalar h_right_thigh_y = h_right_thigh_y_1 + left_thigh_h1 * c_right_hip_pitch;
  // right_shank: second moments E, A of (2)
  const Scalar t_right_shank_1 = left_thigh_I1 * c_right_hip_pitch;
  const Scalar t_right_shank_2 = t_right_shank_1 + left_thigh_I2 * s_right_hip_pitch;
  const Scalar t_right_shank_3 = s_right_hip_pitch * t_right_shank_2;
  const Scalar t_right_shank_4 = left_shank_I4 - left_foot_I6 * s_right_foot;
  const Scalar t_right_shank_5 = t_righ_ankl_cros_12 + left_shank_I3 * s_q14_q15;
  const Scalar neg_E_right_shank_xz = t_right_shank_5 - c_q14_q15 * t_right_shank_4;
  const Scalar E_right_shank_yz_1 = neg_A_250 + left_shank_I3 * c_q14_q15;
  const Scalar E_right_shank_yz = E_right_shank_yz_1 + s_q14_q15 * t_right_shank_4;
  A[249] = -E_right_shank_yz;
  A[283] = A[249];
  const Scalar t_righ_ankl_cros_16 = left_shank_I1 * c_q14_q15 + left_shank_I2 * s_q14_q15;
  const Scalar t_righ_ankl_cros_17 = s_q14_q15_q16 * t_righ_ankl_cros_10;
  const Scalar t_right_shank_6 = s_q14_q15 * t_righ_ankl_cros_16 + t_righ_ankl_cros_17;
  const Scalar E_right_shank_yy = left_shank_I5 + t_right_shank_6 + 2.0 * t_righ_ankl_cros_14;
  const Scalar t_right_shank_7 = t_right_shank_6 - (left_shank_I7 - t_righ_ankl_cros_5);
  const Scalar neg_E_right_shank_xx = t_right_shank_7 + 2.0 * t_righ_ankl_cros_15;
  const Scalar A_285 = E_right_shank_yy - neg_E_right_shank_xx;
  A[285] = A_285;
  const Scalar t_right_shank_8 = s_right_shank_x * neg_h_right_shank_x;
  const Scalar t_right_shank_9 = s_right_shank_y * h_right_shank_y;
  const Scalar h_right_hip_fork_x = left_hip_fork_h2 - neg_h_right_thigh_x;
  // right_thigh: first moment h, second moments E, A of (2)
  const Scalar neg_h_right_hip_fork_y = left_hip_fork_h1 - neg_h_righ_ankl_cros_z;
  const Scalar t_right_thigh_1 = left_thigh_I4 - left_foot_I7 * s_right_foot;
  const Scalar t_right_thigh_2 = neg_E_right_shank_xz + left_thigh_I3 * s_right_hip_pitch;
  const Scalar neg_E_right_thigh_xz = t_right_thigh_2 - c_right_hip_pitch * t_right_thigh_1;
  const Scalar E_right_thigh_yz_1 = E_right_shank_yz + left_thigh_I3 * c_right_hip_pitch;
  const Scalar E_right_thigh_yz = E_right_thigh_yz_1 + s_right_hip_pitch * t_right_thigh_1;
  A[248] = -E_right_thigh_yz;
  A[265] = A[248];
  const Scalar t_right_thigh_3 = E_right_shank_yy + 2.0 * t_right_shank_9;
  const Scalar t_right_thigh_4 = neg_E_right_shank_xx + 2.0 * t_right_shank_8;
  const Scalar neg_A_266 = t_right_thigh_4 - (left_thigh_I6 + t_right_thigh_3);
  A[266] = -neg_A_266;
  // right_hip_fork: first moment h, second moments E, A of (2)
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * neg_h_right_hip_fork_y;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 - s_right_hip_roll * h_right_hip_fork_x;
  const Scalar neg_h_right_hip_block_x = left_hip_block_h1 - t_right_hip_fork_2;
  const Scalar h_right_hip_block_z_1 = s_right_hip_roll * neg_h_right_hip_fork_y;
  const Scalar h_right_hip_block_z = c_right_hip_roll * h_right_hip_fork_x + h_right_hip_block_z_1;
  const Scalar neg_h_right_hip_block_y = left_hip_block_h2 + h_right_thigh_y;
  const Scalar neg_E_right_hip_fork_yz = left_hip_fork_I2 - t_right_foot_5 + E_right_thigh_yz;
  const Scalar t_right_hip_fork_3 = t_right_shank_3 + t_right_thigh_4;
  const Scalar E_right_hip_fork_xx = left_hip_fork_I6 - t_right_hip_fork_3;
  const Scalar t_right_hip_fork_4 = t_right_foot_3 - left_foot_I11 * s_right_foot;
  const Scalar E_right_hip_fork_yy = left_hip_fork_I7 + t_right_hip_fork_4;
  const Scalar t_right_hip_fork_5 = left_hip_fork_I1 + 2.0 * neg_E_right_thigh_xz;
  const Scalar t_right_hip_fork_6 = E_right_hip_fork_xx - E_right_hip_fork_yy;
  const Scalar t_right_hip_fork_7 = s_right_hip_roll * t_right_hip_fork_5;
  const Scalar t_right_hip_fork_8 = t_right_hip_fork_7 - c_right_hip_roll * t_right_hip_fork_6;
  const Scalar t_right_hip_fork_9 = c_right_hip_roll * t_right_hip_fork_8;
  const Scalar E_right_hip_fork_xz_1 = left_hip_fork_I3 + t_right_foot_4;
  const Scalar E_right_hip_fork_xz_2 = E_right_hip_fork_xz_1 + c_q14_q15_q16 * t_righ_ankl_cros_10;
  const Scalar E_right_hip_fork_xz_3 = t_right_shank_2 + left_shank_l1 * h_right_shank_y;
  const Scalar E_right_hip_fork_xz_4 =
      E_right_hip_fork_xz_2 - left_hip_fork_l1 * neg_h_right_thigh_x;
  const Scalar E_right_hip_fork_xz_5 =
      E_right_hip_fork_xz_4 + c_right_hip_pitch * E_right_hip_fork_xz_3;
  const Scalar E_right_hip_fork_xz_6 = t_righ_ankl_cros_13 + t_righ_ankl_cros_16;
  const Scalar E_right_hip_fork_xz_7 =
      E_right_hip_fork_xz_5 - s_righ_ankl_cros_y * t_righ_ankl_cros_2;
  const Scalar E_right_hip_fork_xz_8 = E_right_hip_fork_xz_7 + c_q14_q15 * E_right_hip_fork_xz_6;
  const Scalar E_right_hip_fork_xz = E_right_hip_fork_xz_8 - s_right_shank_y * neg_h_right_shank_x;
  const Scalar t_right_hip_fork_10 = c_right_hip_roll * neg_E_right_hip_fork_yz;
  const Scalar t_right_hip_fork_11 = t_right_hip_fork_10 - s_right_hip_roll * E_right_hip_fork_xz;
  const Scalar neg_A_229_1 = s_right_hip_roll * neg_E_right_hip_fork_yz;
  const Scalar neg_A_229 = neg_A_229_1 + c_right_hip_roll * E_right_hip_fork_xz;
  A[229] = -neg_A_229;
  A[246] = A[229];
  const Scalar A_247 = E_right_hip_fork_xx + E_right_hip_fork_yy;
  A[247] = A_247;
  // right_hip_block: second moments E, A of (2)
  const Scalar t_right_hip_block_1 = s_right_hip_yaw * neg_h_right_hip_block_x;
  const Scalar t_right_hip_block_2 =
      t_right_hip_block_1 + c_right_hip_yaw * neg_h_right_hip_block_y;
  const Scalar t_right_hip_block_3 = c_right_hip_yaw * neg_h_right_hip_block_x;
  const Scalar t_right_hip_block_4 =
      t_right_hip_block_3 - s_right_hip_yaw * neg_h_right_hip_block_y;
  const Scalar t_right_hip_block_5 = left_hip_block_I2 + neg_E_right_thigh_xz;
  const Scalar t_right_hip_block_6 = t_right_hip_block_5 - left_hip_block_l2 * t_right_hip_fork_2;
  const Scalar neg_E_right_hip_block_xz =
      t_right_hip_block_6 - s_right_hip_roll * t_right_hip_fork_8;
  const Scalar t_right_hip_fork_12 = left_hip_block_l2 * h_right_thigh_y;
  const Scalar neg_E_right_hip_block_yz = left_hip_block_I1 + neg_A_229 + t_right_hip_fork_12;
  const Scalar t_right_hip_block_7 = s_right_hip_yaw * neg_E_right_hip_block_yz;
  const Scalar t_right_hip_block_8 =
      t_right_hip_block_7 - c_right_hip_yaw * neg_E_right_hip_block_xz;
  const Scalar neg_A_102_1 = c_right_hip_yaw * neg_E_right_hip_block_yz;
  const Scalar neg_A_102 = neg_A_102_1 + s_right_hip_yaw * neg_E_right_hip_block_xz;
  A[102] = -neg_A_102;
  A[221] = A[102];
  const Scalar t_right_hip_block_9 = t_right_shank_3 + t_right_thigh_3;
  const Scalar t_right_hip_block_10 = t_right_hip_block_9 + left_hip_fork_l2 * h_right_thigh_y;
  const Scalar E_right_hip_block_yy = left_hip_block_I6 + t_right_hip_block_10;
  const Scalar t_right_hip_block_11 = t_right_hip_fork_3 - t_right_hip_fork_9;
  const Scalar E_right_hip_block_xx = left_hip_block_I7 - t_right_hip_block_11;
  const Scalar A_228 = E_right_hip_block_yy + E_right_hip_block_xx;
  A[228] = A_228;
  const Scalar t_left_foot_1 = left_foot_h1 * c_left_foot;
  const Scalar h_left_ankle_cross_x = left_ankle_cross_h1 + t_left_foot_1;
  const Scalar h_left_ankle_cross_z = left_foot_h1 * s_left_foot;
  // left_foot: A of (2)
  const Scalar t_left_foot_2 = left_foot_I9 * c_left_foot + left_foot_I8 * s_left_foot;
  const Scalar t_left_foot_3 = s_left_foot * t_left_foot_2;
  const Scalar neg_A_191 = left_foot_I2 * s_left_foot - left_foot_I1 * c_left_foot;
  A[191] = -neg_A_191;
  A[208] = A[191];
  const Scalar t_left_foot_4 = left_foot_I2 * c_left_foot + left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_5 = left_foot_I4 * s_left_foot;
  // left_ankle_cross: A, first moment h, second moments E of (2)
  const Scalar t_left_ankle_cross_1 = t_left_foot_3 - left_foot_I10 * c_left_foot;
  const Scalar t_left_ankle_cross_2 = s_q8_q9_q10 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_3 = left_ankle_cross_h2 * c_q8_q9_q10 - t_left_ankle_cross_2;
  const Scalar h_left_shank_y_1 = t_left_ankle_cross_3 + left_shank_h1 * s_q8_q9;
  const Scalar h_left_shank_y = h_left_shank_y_1 + left_shank_h2 * c_q8_q9;
  const Scalar t_left_ankle_cross_4 = c_q8_q9_q10 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_5 = left_ankle_cross_h2 * s_q8_q9_q10 + t_left_ankle_cross_4;
  const Scalar neg_h_left_shank_x_1 = t_left_ankle_cross_5 - left_shank_h1 * c_q8_q9;
  const Scalar neg_h_left_shank_x = neg_h_left_shank_x_1 + left_shank_h2 * s_q8_q9;
  const Scalar E_left_ankle_cross_yz = left_ankle_cross_I1 - neg_A_191;
  const Scalar t_left_ankle_cross_6 = left_ankle_cross_I4 - t_left_ankle_cross_1;
  const Scalar t_left_ankle_cross_7 = left_ankle_cross_I3 + 2.0 * t_left_foot_4;
  const Scalar t_left_ankle_cross_8 = s_q8_q9_q10 * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_8 - c_q8_q9_q10 * t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_10 = left_ankle_cross_I2 - t_left_foot_5;
  const Scalar t_left_ankle_cross_11 = left_foot_I3 - t_left_foot_2;
  const Scalar t_left_ankle_cross_12 = t_left_ankle_cross_10 + c_left_foot * t_left_ankle_cross_11;
  const Scalar neg_A_136_1 = s_q8_q9_q10 * t_left_ankle_cross_12;
  const Scalar neg_A_136 = neg_A_136_1 - c_q8_q9_q10 * E_left_ankle_cross_yz;
  A[136] = -neg_A_136;
  A[187] = A[136];
  const Scalar t_left_ankle_cross_13 = c_q8_q9_q10 * t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_14 = t_left_ankle_cross_13 + s_q8_q9_q10 * E_left_ankle_cross_yz;
  const Scalar t_left_ankle_cross_15 = s_left_ankle_cross_x * t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_16 = left_ankle_cross_l1 * t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_17 = s_q8_q9 * t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_18 = 2.0 * t_left_ankle_cross_17;
  const Scalar A_190 = left_ankle_cross_I5 - t_left_ankle_cross_1;
  A[190] = A_190;
  const Scalar h_left_thigh_y_1 = h_left_shank_y + left_thigh_h1 * c_left_hip_pitch;
  const Scalar h_left_thigh_y = h_left_thigh_y_1 + left_thigh_h2 * s_left_hip_pitch;
  // left_shank: first moment h, second moments E, A of (2)
  const Scalar neg_h_left_thigh_x_1 = neg_h_left_shank_x - left_thigh_h2 * c_left_hip_pitch;
  const Scalar neg_h_left_thigh_x = neg_h_left_thigh_x_1 + left_thigh_h1 * s_left_hip_pitch;
  const Scalar t_left_shank_1 = left_shank_I4 - left_foot_I6 * s_left_foot;
  const Scalar E_left_shank_xz_1 = t_left_ankle_cross_14 + left_shank_I3 * s_q8_q9;
  const Scalar E_left_shank_xz = E_left_shank_xz_1 - c_q8_q9 * t_left_shank_1;
  const Scalar E_left_shank_yz = neg_A_136 - left_shank_I3 * c_q8_q9 - s_q8_q9 * t_left_shank_1;
  A[135] = -E_left_shank_yz;
  A[169] = A[135];
  const Scalar t_left_shank_2 = t_left_ankle_cross_1 + 2.0 * t_left_ankle_cross_15;
  const Scalar neg_A_171 = t_left_shank_2 - (left_shank_I6 + t_left_ankle_cross_18);
  A[171] = -neg_A_171;
  const Scalar t_left_ankle_cross_19 = left_shank_I1 * c_q8_q9 + left_shank_I2 * s_q8_q9;
  const Scalar t_left_shank_3 = left_shank_l1 * h_left_shank_y;
  const Scalar t_left_shank_4 = s_left_hip_pitch * t_left_shank_3;
  const Scalar t_left_shank_5 = s_left_shank_x * neg_h_left_shank_x;
  const Scalar h_left_hip_fork_x = left_hip_fork_h2 - neg_h_left_thigh_x;
  const Scalar h_left_hip_fork_y = left_hip_fork_h1 - h_left_ankle_cross_z;
  // left_thigh: second moments E, A of (2)
  const Scalar t_left_thigh_1 = left_thigh_I4 - left_foot_I7 * s_left_foot;
  const Scalar E_left_thigh_xz_1 = E_left_shank_xz + left_thigh_I3 * s_left_hip_pitch;
  const Scalar E_left_thigh_xz = E_left_thigh_xz_1 - c_left_hip_pitch * t_left_thigh_1;
  const Scalar E_left_thigh_yz_1 = E_left_shank_yz - left_thigh_I3 * c_left_hip_pitch;
  const Scalar E_left_thigh_yz = E_left_thigh_yz_1 - s_left_hip_pitch * t_left_thigh_1;
  A[134] = -E_left_thigh_yz;
  A[151] = A[134];
  const Scalar t_left_thigh_2 = t_left_shank_2 + 2.0 * t_left_shank_5;
  const Scalar t_left_thigh_3 = t_left_ankle_cross_18 + 2.0 * t_left_shank_4;
  const Scalar A_152 = left_thigh_I5 - t_left_thigh_2 + t_left_thigh_3;
  A[152] = A_152;
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * h_left_hip_fork_y;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + s_left_hip_roll * h_left_hip_fork_x;
  const Scalar h_left_hip_block_x = left_hip_block_h1 - t_left_hip_fork_2;
  const Scalar h_left_hip_block_z_1 = c_left_hip_roll * h_left_hip_fork_x;
  const Scalar h_left_hip_block_z = h_left_hip_block_z_1 - s_left_hip_roll * h_left_hip_fork_y;
  const Scalar neg_h_left_hip_block_y = left_hip_block_h2 + h_left_thigh_y;
  const Scalar t_left_shank_6 = left_thigh_I1 * c_left_hip_pitch;
  const Scalar t_left_shank_7 = t_left_shank_6 + left_thigh_I2 * s_left_hip_pitch;
  // left_hip_fork: second moments E, A of (2)
  const Scalar E_left_hip_fork_xz_1 = left_hip_fork_I3 + t_left_foot_4;
  const Scalar E_left_hip_fork_xz_2 = t_left_ankle_cross_16 + t_left_ankle_cross_19;
  const Scalar E_left_hip_fork_xz_3 = E_left_hip_fork_xz_1 - left_hip_fork_l1 * neg_h_left_thigh_x;
  const Scalar E_left_hip_fork_xz_4 = E_left_hip_fork_xz_3 + c_q8_q9 * E_left_hip_fork_xz_2;
  const Scalar E_left_hip_fork_xz_5 = t_left_shank_3 + t_left_shank_7;
  const Scalar E_left_hip_fork_xz_6 =
      E_left_hip_fork_xz_4 + c_left_hip_pitch * E_left_hip_fork_xz_5;
  const Scalar E_left_hip_fork_xz_7 = E_left_hip_fork_xz_6 + c_q8_q9_q10 * t_left_ankle_cross_9;
  const Scalar E_left_hip_fork_xz_8 = E_left_hip_fork_xz_7 - s_left_shank_y * neg_h_left_shank_x;
  const Scalar E_left_hip_fork_xz =
      E_left_hip_fork_xz_8 - s_left_ankle_cross_y * t_left_ankle_cross_5;
  const Scalar neg_E_left_hip_fork_yz = E_left_thigh_yz - (left_hip_fork_I2 - t_left_foot_5);
  const Scalar t_left_shank_8 = s_left_hip_pitch * t_left_shank_7;
  const Scalar t_left_hip_fork_3 = s_q8_q9 * t_left_ankle_cross_19 + t_left_shank_8;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 + s_q8_q9_q10 * t_left_ankle_cross_9;
  const Scalar t_left_hip_fork_5 = t_left_thigh_2 + t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = t_left_foot_3 - left_foot_I11 * s_left_foot;
  const Scalar t_left_hip_fork_7 = left_hip_fork_I4 - t_left_hip_fork_5;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_6 - t_left_hip_fork_7;
  const Scalar t_left_hip_fork_9 = s_left_hip_roll * (left_hip_fork_I1 + 2.0 * E_left_thigh_xz);
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_9 - c_left_hip_roll * t_left_hip_fork_8;
  const Scalar t_left_hip_fork_11 = c_left_hip_roll * t_left_hip_fork_10;
  const Scalar t_left_hip_fork_12 = c_left_hip_roll * neg_E_left_hip_fork_yz;
  const Scalar t_left_hip_fork_13 = t_left_hip_fork_12 - s_left_hip_roll * E_left_hip_fork_xz;
  const Scalar neg_A_115_1 = s_left_hip_roll * neg_E_left_hip_fork_yz;
  const Scalar neg_A_115 = c_left_hip_roll * E_left_hip_fork_xz + neg_A_115_1;
  A[115] = -neg_A_115;
  A[132] = A[115];
  const Scalar A_133 = left_hip_fork_I5 - t_left_hip_fork_5 + t_left_hip_fork_6;
  A[133] = A_133;
  const Scalar t_left_hip_block_1 = c_left_hip_yaw * neg_h_left_hip_block_y;
  const Scalar t_left_hip_block_2 = t_left_hip_block_1 - s_left_hip_yaw * h_left_hip_block_x;
  const Scalar h_base_rx_z = base_rx_h3 + t_right_hip_block_2 + t_left_hip_block_2;
  // left_hip_block: first moment h, second moments E, A of (2)
  const Scalar t_left_hip_block_3 = s_left_hip_yaw * neg_h_left_hip_block_y;
  const Scalar t_left_hip_block_4 = c_left_hip_yaw * h_left_hip_block_x + t_left_hip_block_3;
  const Scalar neg_h_base_rx_x = base_rx_h1 - t_right_hip_block_4 + t_left_hip_block_4;
  const Scalar t_left_hip_block_5 = h_right_hip_block_z + h_left_hip_block_z;
  const Scalar neg_h_base_rx_y = base_rx_h2 + t_left_hip_block_5;
  const Scalar E_left_hip_block_xz_1 = left_hip_block_I2 + E_left_thigh_xz;
  const Scalar E_left_hip_block_xz_2 = E_left_hip_block_xz_1 - s_left_hip_roll * t_left_hip_fork_10;
  const Scalar E_left_hip_block_xz = E_left_hip_block_xz_2 - left_hip_block_l2 * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_14 = left_hip_block_l2 * h_left_thigh_y;
  const Scalar neg_E_left_hip_block_yz = left_hip_block_I1 + neg_A_115 + t_left_hip_fork_14;
  const Scalar t_left_hip_block_6 = t_left_thigh_3 + t_left_hip_fork_4;
  const Scalar t_left_hip_block_7 = t_left_hip_block_6 + left_hip_fork_l2 * h_left_thigh_y;
  const Scalar E_left_hip_block_yy = left_hip_block_I5 + t_left_hip_block_7;
  const Scalar t_left_hip_block_8 = t_left_hip_fork_5 + t_left_hip_fork_11;
  const Scalar E_left_hip_block_xx = left_hip_block_I3 - t_left_hip_block_8;
  const Scalar t_left_hip_block_9 = left_hip_block_I4 + 2.0 * t_left_hip_fork_13;
  const Scalar t_left_hip_block_10 = s_left_hip_yaw * (E_left_hip_block_yy - E_left_hip_block_xx);
  const Scalar t_left_hip_block_11 = c_left_hip_yaw * t_left_hip_block_9 + t_left_hip_block_10;
  const Scalar A_96_1 = c_left_hip_yaw * neg_E_left_hip_block_yz;
  const Scalar A_96 = s_left_hip_yaw * E_left_hip_block_xz - A_96_1;
  A[96] = A_96;
  A[113] = A[96];
  const Scalar t_left_hip_block_12 = s_left_hip_yaw * neg_E_left_hip_block_yz;
  const Scalar t_left_hip_block_13 = t_left_hip_block_12 + c_left_hip_yaw * E_left_hip_block_xz;
  const Scalar A_114 = E_left_hip_block_yy + E_left_hip_block_xx;
  A[114] = A_114;
  // base_rx: second moments E of (2)
  const Scalar E_base_rx_xy_1 = base_rx_I4 + t_right_hip_block_8 + t_left_hip_block_13;
  const Scalar E_base_rx_xy_2 = h_right_hip_block_z - h_left_hip_block_z;
  const Scalar E_base_rx_xy = E_base_rx_xy_1 - left_hip_block_l1 * E_base_rx_xy_2;
  // right_hip_block
  const Scalar t_right_hip_block_12 = left_hip_block_I4 - 2.0 * t_right_hip_fork_11;
  const Scalar t_right_hip_block_13 = E_right_hip_block_yy - E_right_hip_block_xx;
  const Scalar t_right_hip_block_14 = c_right_hip_yaw * t_right_hip_block_12;
  const Scalar t_right_hip_block_15 = t_right_hip_block_14 - s_right_hip_yaw * t_right_hip_block_13;
  // base_rx: second moments E, A of (2)
  const Scalar E_base_rx_xz_1 = t_left_hip_fork_13 - (base_rx_I6 - t_right_hip_fork_11);
  const Scalar E_base_rx_xz_2 = E_base_rx_xz_1 - c_left_hip_yaw * t_left_hip_block_11;
  const Scalar E_base_rx_xz_3 = t_right_hip_block_2 - t_left_hip_block_2;
  const Scalar E_base_rx_xz_4 = E_base_rx_xz_2 + c_right_hip_yaw * t_right_hip_block_15;
  const Scalar E_base_rx_xz = E_base_rx_xz_4 + left_hip_block_l1 * E_base_rx_xz_3;
  const Scalar E_base_rx_yz = A_96 - (base_rx_I5 + neg_A_102);
  const Scalar t_right_hip_block_16 = s_right_hip_yaw * t_right_hip_block_15;
  const Scalar t_base_rx_1 = s_left_hip_yaw * t_left_hip_block_11 - t_right_hip_block_16;
  const Scalar E_base_rx_xx_1 = t_left_hip_block_8 - (base_rx_I1 - t_right_hip_block_11);
  const Scalar E_base_rx_xx_2 = t_right_hip_block_4 + t_left_hip_block_4;
  const Scalar E_base_rx_xx_3 = t_base_rx_1 - E_base_rx_xx_1;
  const Scalar E_base_rx_xx = E_base_rx_xx_3 + left_hip_block_l4 * E_base_rx_xx_2;
  const Scalar E_base_rx_yy_1 = t_right_hip_fork_9 - (base_rx_I2 + t_right_hip_fork_4);
  const Scalar E_base_rx_yy_2 = t_left_hip_fork_6 - E_base_rx_yy_1 + t_left_hip_fork_11;
  const Scalar E_base_rx_yy = E_base_rx_yy_2 + left_hip_block_l3 * t_left_hip_block_5;
  const Scalar A_95 = E_base_rx_xx + E_base_rx_yy;
  A[95] = A_95;
  const Scalar t_right_foot_6 = left_foot_I4 * c_right_foot;
  // right_ankle_cross: A of (2)
  const Scalar t_righ_ankl_cros_18 = c_q14_q15_q16 * neg_h_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_19 = s_q14_q15_q16 * neg_h_righ_ankl_cros_z;
  const Scalar neg_A_287_1 = neg_A_305 - s_righ_ankl_cros_y * t_righ_ankl_cros_18;
  const Scalar neg_A_287 = neg_A_287_1 + s_righ_ankl_cros_x * t_righ_ankl_cros_19;
  A[287] = -neg_A_287;
  A[321] = A[287];
  const Scalar t_right_foot_7 = left_foot_I5 + t_right_foot_6 - left_foot_I3 * s_right_foot;
  // right_shank: A of (2)
  const Scalar A_251_1 = t_right_foot_1 * (s_right_shank_x + s_righ_ankl_cros_x);
  const Scalar A_251_2 = s_q14_q15_q16 * t_right_foot_4 - A_251_1;
  const Scalar A_251 = A_251_2 + c_q14_q15_q16 * t_right_foot_7;
  A[251] = A_251;
  A[319] = A[251];
  const Scalar neg_A_269_1 = neg_A_287 - s_right_shank_y * t_righ_ankl_cros_18;
  const Scalar neg_A_269 = neg_A_269_1 + s_right_shank_x * t_righ_ankl_cros_19;
  A[269] = -neg_A_269;
  A[320] = A[269];
  // right_thigh
  const Scalar t_right_thigh_5 = t_righ_ankl_cros_6 + t_right_foot_6;
  const Scalar t_right_thigh_6 = s_right_shank_y + s_righ_ankl_cros_y;
  const Scalar t_right_thigh_7 = t_right_thigh_5 + t_right_foot_1 * t_right_thigh_6;
  const Scalar t_right_thigh_8 = t_right_thigh_7 - s_q14_q15_q16 * t_right_foot_7;
  const Scalar t_right_thigh_9 = neg_A_269 - left_hip_fork_l1 * t_righ_ankl_cros_18;
  // right_hip_fork: A of (2)
  const Scalar t_right_hip_fork_13 = left_hip_block_l2 * t_righ_ankl_cros_19;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_13 + c_right_hip_roll * t_right_thigh_9;
  const Scalar t_right_hip_fork_15 = t_right_hip_fork_14 + s_right_hip_roll * t_right_thigh_8;
  const Scalar neg_A_233_1 = s_right_hip_roll * t_right_thigh_9;
  const Scalar neg_A_233 = neg_A_233_1 - c_right_hip_roll * t_right_thigh_8;
  A[233] = -neg_A_233;
  A[318] = A[233];
  const Scalar t_right_hip_fork_16 = s_right_hip_roll * t_righ_ankl_cros_18;
  const Scalar t_right_hip_fork_17 = t_right_hip_fork_16 + c_right_hip_roll * t_right_foot_1;
  const Scalar t_right_hip_fork_18 = c_right_hip_roll * t_righ_ankl_cros_18;
  const Scalar t_right_hip_fork_19 = t_right_hip_fork_18 - s_right_hip_roll * t_right_foot_1;
  const Scalar t_right_hip_fork_20 = A_251 - left_hip_block_l2 * t_right_hip_fork_17;
  // right_hip_block: A of (2)
  const Scalar A_107_1 = left_hip_block_l1 * t_right_hip_fork_19;
  const Scalar A_107_2 = A_107_1 + c_right_hip_yaw * t_right_hip_fork_20;
  const Scalar A_107 = A_107_2 + s_right_hip_yaw * t_right_hip_fork_15;
  A[107] = A_107;
  A[311] = A[107];
  const Scalar t_right_hip_block_17 = s_right_hip_yaw * t_right_hip_fork_20;
  const Scalar t_right_hip_block_18 = t_right_hip_block_17 - c_right_hip_yaw * t_right_hip_fork_15;
  const Scalar t_right_hip_block_19 = c_right_hip_yaw * t_righ_ankl_cros_19;
  const Scalar t_right_hip_block_20 = t_right_hip_block_19 + s_right_hip_yaw * t_right_hip_fork_17;
  const Scalar t_right_hip_block_21 = neg_A_233 + left_hip_block_l1 * t_right_hip_block_20;
  const Scalar t_right_hip_block_22 = s_right_hip_yaw * t_righ_ankl_cros_19;
  const Scalar t_right_hip_block_23 = t_right_hip_block_22 - c_right_hip_yaw * t_right_hip_fork_17;
  A[89] = s_base_rx * t_right_hip_block_21 + c_base_rx * t_right_hip_block_18;
  A[310] = A[89];
  // base_rz: A of (2)
  const Scalar A_71_1 = Rz_left_hip_block_z * t_right_hip_block_21;
  A[71] = neg_Rz_base_rx_x * t_right_hip_block_18 - A_71_1 - s_base_ry * A_107;
  A[309] = A[71];
  const Scalar neg_A_17_1 = Rx_left_hip_block_z * t_right_hip_fork_19;
  const Scalar neg_A_17_2 = neg_Rx_base_rx_x * t_right_hip_block_23 + neg_A_17_1;
  A[17] = -(neg_A_17_2 + Rx_base_ry_y * t_right_hip_block_20);
  A[306] = A[17];
  const Scalar neg_A_35_1 = Ry_left_hip_block_z * t_right_hip_fork_19;
  const Scalar neg_A_35_2 = neg_Ry_base_rx_x * t_right_hip_block_23 + neg_A_35_1;
  A[35] = -(neg_A_35_2 + Ry_base_ry_y * t_right_hip_block_20);
  A[307] = A[35];
  const Scalar neg_A_53_1 = Rz_left_hip_block_z * t_right_hip_fork_19;
  const Scalar neg_A_53_2 = neg_A_53_1 - s_base_ry * t_right_hip_block_20;
  A[53] = -(neg_A_53_2 + neg_Rz_base_rx_x * t_right_hip_block_23);
  A[308] = A[53];
  const Scalar A_286 = t_righ_ankl_cros_14 - t_righ_ankl_cros_15 + A_304;
  A[286] = A_286;
  A[303] = A[286];
  const Scalar A_268_1 = A_286 + s_right_shank_y * t_righ_ankl_cros_4;
  const Scalar A_268 = A_268_1 - s_right_shank_x * t_righ_ankl_cros_2;
  A[268] = A_268;
  A[302] = A[268];
  const Scalar t_right_thigh_10 = A_268 + left_hip_fork_l1 * t_righ_ankl_cros_4;
  // right_hip_fork: A of (2)
  const Scalar t_right_hip_fork_21 = left_hip_block_l2 * t_righ_ankl_cros_2;
  const Scalar t_right_hip_fork_22 = t_right_hip_fork_21 - c_right_hip_roll * t_right_thigh_10;
  const Scalar t_right_hip_fork_23 = t_right_hip_fork_22 + s_right_hip_roll * t_righ_ankl_cros_12;
  const Scalar A_232_1 = c_right_hip_roll * t_righ_ankl_cros_12;
  const Scalar A_232 = s_right_hip_roll * t_right_thigh_10 + A_232_1;
  A[232] = A_232;
  A[300] = A[232];
  const Scalar t_right_hip_fork_24 = s_right_hip_roll * t_righ_ankl_cros_4;
  const Scalar t_right_hip_fork_25 = neg_A_250 + left_hip_block_l2 * t_right_hip_fork_24;
  const Scalar t_right_hip_fork_26 = c_right_hip_roll * t_righ_ankl_cros_4;
  // right_hip_block: A of (2)
  const Scalar A_106_1 = left_hip_block_l1 * t_right_hip_fork_26;
  const Scalar A_106_2 = A_106_1 + s_right_hip_yaw * t_right_hip_fork_23;
  const Scalar A_106 = A_106_2 - c_right_hip_yaw * t_right_hip_fork_25;
  A[106] = A_106;
  A[293] = A[106];
  const Scalar t_right_hip_block_24 = s_right_hip_yaw * t_right_hip_fork_24;
  const Scalar t_right_hip_block_25 = t_right_hip_block_24 + c_right_hip_yaw * t_righ_ankl_cros_2;
  const Scalar t_right_hip_block_26 = A_232 - left_hip_block_l1 * t_right_hip_block_25;
  const Scalar t_right_hip_block_27 = c_right_hip_yaw * t_right_hip_fork_24;
  const Scalar t_right_hip_block_28 = t_right_hip_block_27 - s_right_hip_yaw * t_righ_ankl_cros_2;
  const Scalar t_right_hip_block_29 = c_right_hip_yaw * t_right_hip_fork_23;
  const Scalar t_right_hip_block_30 = t_right_hip_block_29 + s_right_hip_yaw * t_right_hip_fork_25;
  A[88] = -(s_base_rx * t_right_hip_block_26 + c_base_rx * t_right_hip_block_30);
  A[292] = A[88];
  // base_rz: A of (2)
  const Scalar neg_A_70_1 = s_base_ry * A_106 - Rz_left_hip_block_z * t_right_hip_block_26;
  A[70] = -(neg_A_70_1 + neg_Rz_base_rx_x * t_right_hip_block_30);
  A[291] = A[70];
  const Scalar neg_A_34_1 = Ry_left_hip_block_z * t_right_hip_fork_26;
  const Scalar neg_A_34_2 = Ry_base_ry_y * t_right_hip_block_25 + neg_A_34_1;
  A[34] = neg_Ry_base_rx_x * t_right_hip_block_28 - neg_A_34_2;
  A[289] = A[34];
  const Scalar neg_A_52_1 = Rz_left_hip_block_z * t_right_hip_fork_26;
  const Scalar neg_A_52_2 = neg_A_52_1 - s_base_ry * t_right_hip_block_25;
  A[52] = neg_Rz_base_rx_x * t_right_hip_block_28 - neg_A_52_2;
  A[290] = A[52];
  const Scalar neg_A_16_1 = Rx_left_hip_block_z * t_right_hip_fork_26;
  const Scalar neg_A_16_2 = Rx_base_ry_y * t_right_hip_block_25 + neg_A_16_1;
  A[16] = neg_Rx_base_rx_x * t_right_hip_block_28 - neg_A_16_2;
  A[288] = A[16];
  const Scalar A_267 = A_285 - t_right_shank_8 + t_right_shank_9;
  A[267] = A_267;
  A[284] = A[267];
  const Scalar t_right_thigh_11 = A_267 + left_hip_fork_l1 * h_right_shank_y;
  // right_hip_fork: A of (2)
  const Scalar A_231_1 = c_right_hip_roll * neg_E_right_shank_xz;
  const Scalar A_231 = A_231_1 + s_right_hip_roll * t_right_thigh_11;
  A[231] = A_231;
  A[282] = A[231];
  const Scalar t_right_hip_fork_27 = s_right_hip_roll * h_right_shank_y;
  const Scalar t_right_hip_fork_28 = E_right_shank_yz + left_hip_block_l2 * t_right_hip_fork_27;
  const Scalar t_right_hip_fork_29 = c_right_hip_roll * h_right_shank_y;
  const Scalar t_right_hip_fork_30 = left_hip_block_l2 * neg_h_right_shank_x;
  const Scalar t_right_hip_fork_31 = t_right_hip_fork_30 - c_right_hip_roll * t_right_thigh_11;
  const Scalar t_right_hip_fork_32 = t_right_hip_fork_31 + s_right_hip_roll * neg_E_right_shank_xz;
  // right_hip_block: A of (2)
  const Scalar A_105_1 = left_hip_block_l1 * t_right_hip_fork_29;
  const Scalar A_105_2 = A_105_1 + s_right_hip_yaw * t_right_hip_fork_32;
  const Scalar A_105 = A_105_2 - c_right_hip_yaw * t_right_hip_fork_28;
  A[105] = A_105;
  A[275] = A[105];
  const Scalar t_right_hip_block_31 = c_right_hip_yaw * t_right_hip_fork_32;
  const Scalar t_right_hip_block_32 = t_right_hip_block_31 + s_right_hip_yaw * t_right_hip_fork_28;
  const Scalar t_right_hip_block_33 = s_right_hip_yaw * t_right_hip_fork_27;
  const Scalar t_right_hip_block_34 = t_right_hip_block_33 + c_right_hip_yaw * neg_h_right_shank_x;
  const Scalar t_right_hip_block_35 = A_231 - left_hip_block_l1 * t_right_hip_block_34;
  const Scalar t_right_hip_block_36 = c_right_hip_yaw * t_right_hip_fork_27;
  const Scalar t_right_hip_block_37 = t_right_hip_block_36 - s_right_hip_yaw * neg_h_right_shank_x;
  A[87] = -(s_base_rx * t_right_hip_block_35 + c_base_rx * t_right_hip_block_32);
  A[274] = A[87];
  // base_rz: A of (2)
  const Scalar neg_A_69_1 = s_base_ry * A_105 - Rz_left_hip_block_z * t_right_hip_block_35;
  A[69] = -(neg_A_69_1 + neg_Rz_base_rx_x * t_right_hip_block_32);
  A[273] = A[69];
  const Scalar A_33_1 = Ry_left_hip_block_z * t_right_hip_fork_29;
  const Scalar A_33_2 = neg_Ry_base_rx_x * t_right_hip_block_37 - A_33_1;
  A[33] = A_33_2 - Ry_base_ry_y * t_right_hip_block_34;
  A[271] = A[33];
  const Scalar neg_A_51_1 = Rz_left_hip_block_z * t_right_hip_fork_29;
  const Scalar neg_A_51_2 = neg_A_51_1 - s_base_ry * t_right_hip_block_34;
  A[51] = neg_Rz_base_rx_x * t_right_hip_block_37 - neg_A_51_2;
  A[272] = A[51];
  const Scalar neg_A_15_1 = Rx_left_hip_block_z * t_right_hip_fork_29;
  const Scalar neg_A_15_2 = neg_A_15_1 - neg_Rx_base_rx_x * t_right_hip_block_37;
  A[15] = -(neg_A_15_2 + Rx_base_ry_y * t_right_hip_block_34);
  A[270] = A[15];
  const Scalar t_right_thigh_12 = neg_A_266 - left_hip_fork_l1 * h_right_thigh_y;
  // right_hip_fork: A of (2)
  const Scalar A_230_1 = c_right_hip_roll * neg_E_right_thigh_xz;
  const Scalar A_230 = A_230_1 - s_right_hip_roll * t_right_thigh_12;
  A[230] = A_230;
  A[264] = A[230];
  const Scalar t_right_hip_fork_33 = E_right_thigh_yz + s_right_hip_roll * t_right_hip_fork_12;
  const Scalar t_right_hip_fork_34 = c_right_hip_roll * h_right_thigh_y;
  const Scalar t_right_hip_fork_35 = left_hip_block_l2 * neg_h_right_thigh_x;
  const Scalar t_right_hip_fork_36 = t_right_hip_fork_35 + c_right_hip_roll * t_right_thigh_12;
  const Scalar t_right_hip_fork_37 = t_right_hip_fork_36 + s_right_hip_roll * neg_E_right_thigh_xz;
  // right_hip_block: A of (2)
  const Scalar A_104_1 = left_hip_block_l1 * t_right_hip_fork_34;
  const Scalar A_104_2 = A_104_1 - c_right_hip_yaw * t_right_hip_fork_33;
  const Scalar A_104 = A_104_2 + s_right_hip_yaw * t_right_hip_fork_37;
  A[104] = A_104;
  A[257] = A[104];
  const Scalar t_right_hip_block_38 = c_right_hip_yaw * t_right_hip_fork_37;
  const Scalar t_right_hip_block_39 = t_right_hip_block_38 + s_right_hip_yaw * t_right_hip_fork_33;
  const Scalar t_right_hip_fork_38 = s_right_hip_roll * h_right_thigh_y;
  const Scalar t_right_hip_block_40 = s_right_hip_yaw * t_right_hip_fork_38;
  const Scalar t_right_hip_block_41 = t_right_hip_block_40 + c_right_hip_yaw * neg_h_right_thigh_x;
  const Scalar t_right_hip_block_42 = A_230 - left_hip_block_l1 * t_right_hip_block_41;
  const Scalar t_right_hip_block_43 = c_right_hip_yaw * t_right_hip_fork_38;
  const Scalar t_right_hip_block_44 = t_right_hip_block_43 - s_right_hip_yaw * neg_h_right_thigh_x;
  A[86] = -(c_base_rx * t_right_hip_block_39 + s_base_rx * t_right_hip_block_42);
  A[256] = A[86];
  // base_rz: A of (2)
  const Scalar neg_A_68_1 = Rz_left_hip_block_z * t_right_hip_block_42;
  A[68] = -(neg_Rz_base_rx_x * t_right_hip_block_39 - neg_A_68_1 + s_base_ry * A_104);
  A[255] = A[68];
  const Scalar neg_A_32_1 = neg_Ry_base_rx_x * t_right_hip_block_44;
  const Scalar neg_A_32_2 = Ry_base_ry_y * t_right_hip_block_41 - neg_A_32_1;
  A[32] = -(neg_A_32_2 + Ry_left_hip_block_z * t_right_hip_fork_34);
  A[253] = A[32];
  const Scalar A_14_1 = Rx_left_hip_block_z * t_right_hip_fork_34;
  const Scalar A_14_2 = neg_Rx_base_rx_x * t_right_hip_block_44 - A_14_1;
  A[14] = A_14_2 - Rx_base_ry_y * t_right_hip_block_41;
  A[252] = A[14];
  const Scalar neg_A_50_1 = Rz_left_hip_block_z * t_right_hip_fork_34;
  const Scalar neg_A_50_2 = neg_A_50_1 - s_base_ry * t_right_hip_block_41;
  A[50] = neg_Rz_base_rx_x * t_right_hip_block_44 - neg_A_50_2;
  A[254] = A[50];
  const Scalar t_right_hip_fork_39 = A_247 + left_hip_block_l2 * h_right_hip_block_z;
  // right_hip_block: A of (2)
  const Scalar A_103_1 = left_hip_block_l1 * t_right_hip_fork_2;
  const Scalar A_103_2 = c_right_hip_yaw * t_right_hip_fork_39 - A_103_1;
  const Scalar A_103 = A_103_2 + s_right_hip_yaw * t_right_hip_fork_11;
  A[103] = A_103;
  A[239] = A[103];
  const Scalar t_right_hip_block_45 = s_right_hip_yaw * t_right_hip_fork_39;
  const Scalar t_right_hip_block_46 = t_right_hip_block_45 - c_right_hip_yaw * t_right_hip_fork_11;
  const Scalar t_right_hip_block_47 = s_right_hip_yaw * h_right_hip_block_z;
  const Scalar t_right_hip_block_48 = neg_A_229 - left_hip_block_l1 * t_right_hip_block_47;
  const Scalar t_right_hip_block_49 = c_right_hip_yaw * h_right_hip_block_z;
  A[85] = s_base_rx * t_right_hip_block_48 + c_base_rx * t_right_hip_block_46;
  A[238] = A[85];
  // base_rz: A of (2)
  const Scalar neg_A_67_1 = Rz_left_hip_block_z * t_right_hip_block_48 + s_base_ry * A_103;
  A[67] = neg_Rz_base_rx_x * t_right_hip_block_46 - neg_A_67_1;
  A[237] = A[67];
  const Scalar A_13_1 = neg_Rx_base_rx_x * t_right_hip_block_49;
  const Scalar A_13_2 = Rx_base_ry_y * t_right_hip_block_47 - A_13_1;
  A[13] = A_13_2 + Rx_left_hip_block_z * t_right_hip_fork_2;
  A[234] = A[13];
  const Scalar A_31_1 = neg_Ry_base_rx_x * t_right_hip_block_49;
  const Scalar A_31_2 = Ry_base_ry_y * t_right_hip_block_47 - A_31_1;
  A[31] = A_31_2 + Ry_left_hip_block_z * t_right_hip_fork_2;
  A[235] = A[31];
  const Scalar neg_A_49_1 = neg_Rz_base_rx_x * t_right_hip_block_49;
  const Scalar neg_A_49_2 = s_base_ry * t_right_hip_block_47 + neg_A_49_1;
  A[49] = Rz_left_hip_block_z * t_right_hip_fork_2 - neg_A_49_2;
  A[236] = A[49];
  const Scalar t_right_hip_block_50 = A_228 + left_hip_block_l1 * t_right_hip_block_4;
  A[84] = -(s_base_rx * t_right_hip_block_50 + c_base_rx * t_right_hip_block_8);
  A[220] = A[84];
  const Scalar A_66_1 = Rz_left_hip_block_z * t_right_hip_block_50;
  A[66] = A_66_1 - neg_Rz_base_rx_x * t_right_hip_block_8 + s_base_ry * neg_A_102;
  A[219] = A[66];
  A[12] = Rx_base_ry_y * t_right_hip_block_4 + neg_Rx_base_rx_x * t_right_hip_block_2;
  A[216] = A[12];
  A[48] = neg_Rz_base_rx_x * t_right_hip_block_2 - s_base_ry * t_right_hip_block_4;
  A[218] = A[48];
  A[30] = neg_Ry_base_rx_x * t_right_hip_block_2 + Ry_base_ry_y * t_right_hip_block_4;
  A[217] = A[30];
  const Scalar t_left_foot_6 = left_foot_I4 * c_left_foot;
  // left_ankle_cross: A of (2)
  const Scalar t_left_ankle_cross_20 = c_q8_q9_q10 * h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_21 = s_q8_q9_q10 * h_left_ankle_cross_z;
  const Scalar neg_A_173_1 = neg_A_191 + s_left_ankle_cross_y * t_left_ankle_cross_20;
  const Scalar neg_A_173 = neg_A_173_1 - s_left_ankle_cross_x * t_left_ankle_cross_21;
  A[173] = -neg_A_173;
  A[207] = A[173];
  const Scalar t_left_foot_7 = left_foot_I5 + t_left_foot_6 - left_foot_I3 * s_left_foot;
  const Scalar A_137_1 = c_q8_q9_q10 * t_left_foot_7 + s_q8_q9_q10 * t_left_foot_4;
  // left_shank: A of (2)
  const Scalar A_137 = A_137_1 - t_left_foot_1 * (s_left_shank_x + s_left_ankle_cross_x);
  A[137] = A_137;
  A[205] = A[137];
  const Scalar neg_A_155_1 = neg_A_173 + s_left_shank_y * t_left_ankle_cross_20;
  const Scalar neg_A_155 = neg_A_155_1 - s_left_shank_x * t_left_ankle_cross_21;
  A[155] = -neg_A_155;
  A[206] = A[155];
  // left_thigh
  const Scalar t_left_thigh_4 = t_left_foot_6 + c_q8_q9_q10 * t_left_foot_4;
  const Scalar t_left_thigh_5 = t_left_thigh_4 - s_q8_q9_q10 * t_left_foot_7;
  const Scalar t_left_thigh_6 = s_left_shank_y + s_left_ankle_cross_y;
  const Scalar t_left_thigh_7 = t_left_thigh_5 + t_left_foot_1 * t_left_thigh_6;
  const Scalar t_left_thigh_8 = neg_A_155 + left_hip_fork_l1 * t_left_ankle_cross_20;
  // left_hip_fork: A of (2)
  const Scalar t_left_hip_fork_15 = left_hip_block_l2 * t_left_ankle_cross_21;
  const Scalar t_left_hip_fork_16 = t_left_hip_fork_15 - c_left_hip_roll * t_left_thigh_8;
  const Scalar t_left_hip_fork_17 = t_left_hip_fork_16 - s_left_hip_roll * t_left_thigh_7;
  const Scalar neg_A_119_1 = s_left_hip_roll * t_left_thigh_8;
  const Scalar neg_A_119 = neg_A_119_1 - c_left_hip_roll * t_left_thigh_7;
  A[119] = -neg_A_119;
  A[204] = A[119];
  const Scalar t_left_hip_fork_18 = s_left_hip_roll * t_left_ankle_cross_20;
  const Scalar t_left_hip_fork_19 = t_left_hip_fork_18 - c_left_hip_roll * t_left_foot_1;
  const Scalar t_left_hip_fork_20 = c_left_hip_roll * t_left_ankle_cross_20;
  const Scalar t_left_hip_fork_21 = t_left_hip_fork_20 + s_left_hip_roll * t_left_foot_1;
  const Scalar t_left_hip_fork_22 = A_137 + left_hip_block_l2 * t_left_hip_fork_19;
  // left_hip_block: A of (2)
  const Scalar A_101_1 = c_left_hip_yaw * t_left_hip_fork_22;
  const Scalar A_101_2 = A_101_1 - s_left_hip_yaw * t_left_hip_fork_17;
  const Scalar A_101 = A_101_2 + left_hip_block_l1 * t_left_hip_fork_21;
  A[101] = A_101;
  A[203] = A[101];
  const Scalar t_left_hip_block_14 = c_left_hip_yaw * t_left_hip_fork_17;
  const Scalar t_left_hip_block_15 = t_left_hip_block_14 + s_left_hip_yaw * t_left_hip_fork_22;
  const Scalar t_left_hip_block_16 = c_left_hip_yaw * t_left_ankle_cross_21;
  const Scalar t_left_hip_block_17 = t_left_hip_block_16 + s_left_hip_yaw * t_left_hip_fork_19;
  const Scalar t_left_hip_block_18 = neg_A_119 + left_hip_block_l1 * t_left_hip_block_17;
  const Scalar t_left_hip_block_19 = s_left_hip_yaw * t_left_ankle_cross_21;
  const Scalar t_left_hip_block_20 = t_left_hip_block_19 - c_left_hip_yaw * t_left_hip_fork_19;
  A[83] = c_base_rx * t_left_hip_block_15 + s_base_rx * t_left_hip_block_18;
  A[202] = A[83];
  // base_rz: A of (2)
  const Scalar A_65_1 = neg_Rz_base_rx_x * t_left_hip_block_15 - s_base_ry * A_101;
  A[65] = A_65_1 - Rz_left_hip_block_z * t_left_hip_block_18;
  A[201] = A[65];
  const Scalar neg_A_47_1 = Rz_left_hip_block_z * t_left_hip_fork_21;
  const Scalar neg_A_47_2 = s_base_ry * t_left_hip_block_17 - neg_A_47_1;
  A[47] = neg_Rz_base_rx_x * t_left_hip_block_20 - neg_A_47_2;
  A[200] = A[47];
  const Scalar A_11_1 = Rx_left_hip_block_z * t_left_hip_fork_21;
  const Scalar A_11_2 = A_11_1 + neg_Rx_base_rx_x * t_left_hip_block_20;
  A[11] = A_11_2 + Rx_base_ry_y * t_left_hip_block_17;
  A[198] = A[11];
  const Scalar A_29_1 = Ry_left_hip_block_z * t_left_hip_fork_21;
  const Scalar A_29_2 = A_29_1 + neg_Ry_base_rx_x * t_left_hip_block_20;
  A[29] = A_29_2 + Ry_base_ry_y * t_left_hip_block_17;
  A[199] = A[29];
  const Scalar A_172 = A_190 - (t_left_ankle_cross_15 - t_left_ankle_cross_17);
  A[172] = A_172;
  A[189] = A[172];
  const Scalar A_154_1 = A_172 - s_left_shank_x * t_left_ankle_cross_5;
  const Scalar A_154 = A_154_1 + s_left_shank_y * t_left_ankle_cross_3;
  A[154] = A_154;
  A[188] = A[154];
  const Scalar t_left_thigh_9 = A_154 + left_hip_fork_l1 * t_left_ankle_cross_3;
  // left_hip_fork: A of (2)
  const Scalar A_118_1 = c_left_hip_roll * t_left_ankle_cross_14;
  const Scalar A_118 = s_left_hip_roll * t_left_thigh_9 - A_118_1;
  A[118] = A_118;
  A[186] = A[118];
  const Scalar t_left_hip_fork_23 = s_left_hip_roll * t_left_ankle_cross_3;
  const Scalar t_left_hip_fork_24 = neg_A_136 + left_hip_block_l2 * t_left_hip_fork_23;
  const Scalar t_left_hip_fork_25 = c_left_hip_roll * t_left_ankle_cross_3;
  const Scalar t_left_hip_fork_26 = left_hip_block_l2 * t_left_ankle_cross_5;
  const Scalar t_left_hip_fork_27 = t_left_hip_fork_26 - c_left_hip_roll * t_left_thigh_9;
  const Scalar t_left_hip_fork_28 = t_left_hip_fork_27 - s_left_hip_roll * t_left_ankle_cross_14;
  // left_hip_block: A of (2)
  const Scalar neg_A_100_1 = left_hip_block_l1 * t_left_hip_fork_25;
  const Scalar neg_A_100_2 = neg_A_100_1 - s_left_hip_yaw * t_left_hip_fork_28;
  const Scalar neg_A_100 = neg_A_100_2 + c_left_hip_yaw * t_left_hip_fork_24;
  A[100] = -neg_A_100;
  A[185] = A[100];
  const Scalar t_left_hip_block_21 = c_left_hip_yaw * t_left_hip_fork_28;
  const Scalar t_left_hip_block_22 = t_left_hip_block_21 + s_left_hip_yaw * t_left_hip_fork_24;
  const Scalar t_left_hip_block_23 = c_left_hip_yaw * t_left_ankle_cross_5;
  const Scalar t_left_hip_block_24 = s_left_hip_yaw * t_left_hip_fork_23 + t_left_hip_block_23;
  const Scalar t_left_hip_block_25 = A_118 + left_hip_block_l1 * t_left_hip_block_24;
  const Scalar t_left_hip_block_26 = s_left_hip_yaw * t_left_ankle_cross_5;
  const Scalar t_left_hip_block_27 = c_left_hip_yaw * t_left_hip_fork_23 - t_left_hip_block_26;
  A[82] = -(c_base_rx * t_left_hip_block_22 + s_base_rx * t_left_hip_block_25);
  A[184] = A[82];
  // base_rz: A of (2)
  const Scalar neg_A_64_1 = Rz_left_hip_block_z * t_left_hip_block_25;
  A[64] = s_base_ry * neg_A_100 - (neg_Rz_base_rx_x * t_left_hip_block_22 - neg_A_64_1);
  A[183] = A[64];
  const Scalar A_28_1 = neg_Ry_base_rx_x * t_left_hip_block_27;
  const Scalar A_28_2 = A_28_1 - Ry_base_ry_y * t_left_hip_block_24;
  A[28] = A_28_2 - Ry_left_hip_block_z * t_left_hip_fork_25;
  A[181] = A[28];
  const Scalar neg_A_10_1 = neg_Rx_base_rx_x * t_left_hip_block_27;
  const Scalar neg_A_10_2 = Rx_base_ry_y * t_left_hip_block_24 - neg_A_10_1;
  A[10] = -(neg_A_10_2 + Rx_left_hip_block_z * t_left_hip_fork_25);
  A[180] = A[10];
  const Scalar neg_A_46_1 = Rz_left_hip_block_z * t_left_hip_fork_25;
  const Scalar neg_A_46_2 = neg_A_46_1 - s_base_ry * t_left_hip_block_24;
  A[46] = neg_Rz_base_rx_x * t_left_hip_block_27 - neg_A_46_2;
  A[182] = A[46];
  const Scalar neg_A_153 = neg_A_171 - t_left_shank_4 + t_left_shank_5;
  A[153] = -neg_A_153;
  A[170] = A[153];
  const Scalar t_left_thigh_10 = neg_A_153 - left_hip_fork_l1 * h_left_shank_y;
  // left_hip_fork: A of (2)
  const Scalar t_left_hip_fork_29 = left_hip_block_l2 * neg_h_left_shank_x;
  const Scalar t_left_hip_fork_30 = t_left_hip_fork_29 - s_left_hip_roll * E_left_shank_xz;
  const Scalar t_left_hip_fork_31 = t_left_hip_fork_30 + c_left_hip_roll * t_left_thigh_10;
  const Scalar neg_A_117 = c_left_hip_roll * E_left_shank_xz + s_left_hip_roll * t_left_thigh_10;
  A[117] = -neg_A_117;
  A[168] = A[117];
  const Scalar t_left_hip_fork_32 = s_left_hip_roll * h_left_shank_y;
  const Scalar t_left_hip_fork_33 = E_left_shank_yz + left_hip_block_l2 * t_left_hip_fork_32;
  const Scalar t_left_hip_fork_34 = c_left_hip_roll * h_left_shank_y;
  // left_hip_block: A of (2)
  const Scalar neg_A_99_1 = left_hip_block_l1 * t_left_hip_fork_34;
  const Scalar neg_A_99_2 = neg_A_99_1 + c_left_hip_yaw * t_left_hip_fork_33;
  const Scalar neg_A_99 = neg_A_99_2 - s_left_hip_yaw * t_left_hip_fork_31;
  A[99] = -neg_A_99;
  A[167] = A[99];
  const Scalar t_left_hip_block_28 = s_left_hip_yaw * t_left_hip_fork_33;
  const Scalar t_left_hip_block_29 = t_left_hip_block_28 + c_left_hip_yaw * t_left_hip_fork_31;
  const Scalar t_left_hip_block_30 = s_left_hip_yaw * t_left_hip_fork_32;
  const Scalar t_left_hip_block_31 = t_left_hip_block_30 + c_left_hip_yaw * neg_h_left_shank_x;
  const Scalar t_left_hip_block_32 = neg_A_117 - left_hip_block_l1 * t_left_hip_block_31;
  const Scalar t_left_hip_block_33 = c_left_hip_yaw * t_left_hip_fork_32;
  const Scalar t_left_hip_block_34 = t_left_hip_block_33 - s_left_hip_yaw * neg_h_left_shank_x;
  A[81] = s_base_rx * t_left_hip_block_32 - c_base_rx * t_left_hip_block_29;
  A[166] = A[81];
  // base_rz: A of (2)
  const Scalar A_63_1 = s_base_ry * neg_A_99 - Rz_left_hip_block_z * t_left_hip_block_32;
  A[63] = A_63_1 - neg_Rz_base_rx_x * t_left_hip_block_29;
  A[165] = A[63];
  const Scalar A_27_1 = Ry_left_hip_block_z * t_left_hip_fork_34;
  const Scalar A_27_2 = neg_Ry_base_rx_x * t_left_hip_block_34 - A_27_1;
  A[27] = A_27_2 - Ry_base_ry_y * t_left_hip_block_31;
  A[163] = A[27];
  const Scalar neg_A_45_1 = Rz_left_hip_block_z * t_left_hip_fork_34;
  const Scalar neg_A_45_2 = neg_A_45_1 - s_base_ry * t_left_hip_block_31;
  A[45] = neg_Rz_base_rx_x * t_left_hip_block_34 - neg_A_45_2;
  A[164] = A[45];
  const Scalar neg_A_9_1 = neg_Rx_base_rx_x * t_left_hip_block_34;
  const Scalar neg_A_9_2 = Rx_base_ry_y * t_left_hip_block_31 - neg_A_9_1;
  A[9] = -(neg_A_9_2 + Rx_left_hip_block_z * t_left_hip_fork_34);
  A[162] = A[9];
  const Scalar t_left_thigh_11 = A_152 + left_hip_fork_l1 * h_left_thigh_y;
  // left_hip_fork: A of (2)
  const Scalar t_left_hip_fork_35 = left_hip_block_l2 * neg_h_left_thigh_x;
  const Scalar t_left_hip_fork_36 = c_left_hip_roll * t_left_thigh_11 - t_left_hip_fork_35;
  const Scalar t_left_hip_fork_37 = t_left_hip_fork_36 + s_left_hip_roll * E_left_thigh_xz;
  const Scalar neg_A_116 = c_left_hip_roll * E_left_thigh_xz - s_left_hip_roll * t_left_thigh_11;
  A[116] = -neg_A_116;
  A[150] = A[116];
  const Scalar t_left_hip_fork_38 = c_left_hip_roll * h_left_thigh_y;
  const Scalar t_left_hip_fork_39 = E_left_thigh_yz + s_left_hip_roll * t_left_hip_fork_14;
  // left_hip_block: A of (2)
  const Scalar neg_A_98_1 = left_hip_block_l1 * t_left_hip_fork_38;
  const Scalar neg_A_98_2 = neg_A_98_1 + s_left_hip_yaw * t_left_hip_fork_37;
  const Scalar neg_A_98 = neg_A_98_2 + c_left_hip_yaw * t_left_hip_fork_39;
  A[98] = -neg_A_98;
  A[149] = A[98];
  const Scalar t_left_hip_block_35 = c_left_hip_yaw * t_left_hip_fork_37;
  const Scalar t_left_hip_block_36 = t_left_hip_block_35 - s_left_hip_yaw * t_left_hip_fork_39;
  const Scalar t_left_hip_fork_40 = s_left_hip_roll * h_left_thigh_y;
  const Scalar t_left_hip_block_37 = s_left_hip_yaw * t_left_hip_fork_40;
  const Scalar t_left_hip_block_38 = t_left_hip_block_37 + c_left_hip_yaw * neg_h_left_thigh_x;
  const Scalar t_left_hip_block_39 = neg_A_116 - left_hip_block_l1 * t_left_hip_block_38;
  const Scalar t_left_hip_block_40 = c_left_hip_yaw * t_left_hip_fork_40;
  const Scalar t_left_hip_block_41 = t_left_hip_block_40 - s_left_hip_yaw * neg_h_left_thigh_x;
  A[80] = c_base_rx * t_left_hip_block_36 + s_base_rx * t_left_hip_block_39;
  A[148] = A[80];
  // base_rz: A of (2)
  const Scalar A_62_1 = s_base_ry * neg_A_98 + neg_Rz_base_rx_x * t_left_hip_block_36;
  A[62] = A_62_1 - Rz_left_hip_block_z * t_left_hip_block_39;
  A[147] = A[62];
  const Scalar A_26_1 = neg_Ry_base_rx_x * t_left_hip_block_41;
  const Scalar A_26_2 = A_26_1 - Ry_base_ry_y * t_left_hip_block_38;
  A[26] = A_26_2 - Ry_left_hip_block_z * t_left_hip_fork_38;
  A[145] = A[26];
  const Scalar neg_A_8_1 = neg_Rx_base_rx_x * t_left_hip_block_41;
  const Scalar neg_A_8_2 = Rx_base_ry_y * t_left_hip_block_38 - neg_A_8_1;
  A[8] = -(neg_A_8_2 + Rx_left_hip_block_z * t_left_hip_fork_38);
  A[144] = A[8];
  const Scalar neg_A_44_1 = Rz_left_hip_block_z * t_left_hip_fork_38;
  const Scalar neg_A_44_2 = neg_A_44_1 - s_base_ry * t_left_hip_block_38;
  A[44] = neg_Rz_base_rx_x * t_left_hip_block_41 - neg_A_44_2;
  A[146] = A[44];
  const Scalar t_left_hip_fork_41 = A_133 + left_hip_block_l2 * h_left_hip_block_z;
  // left_hip_block: A of (2)
  const Scalar A_97_1 = left_hip_block_l1 * t_left_hip_fork_2;
  const Scalar A_97_2 = c_left_hip_yaw * t_left_hip_fork_41 - A_97_1;
  const Scalar A_97 = A_97_2 + s_left_hip_yaw * t_left_hip_fork_13;
  A[97] = A_97;
  A[131] = A[97];
  const Scalar t_left_hip_block_42 = s_left_hip_yaw * t_left_hip_fork_41;
  const Scalar t_left_hip_block_43 = t_left_hip_block_42 - c_left_hip_yaw * t_left_hip_fork_13;
  const Scalar t_left_hip_block_44 = s_left_hip_yaw * h_left_hip_block_z;
  const Scalar t_left_hip_block_45 = neg_A_115 + left_hip_block_l1 * t_left_hip_block_44;
  A[79] = s_base_rx * t_left_hip_block_45 + c_base_rx * t_left_hip_block_43;
  A[130] = A[79];
  const Scalar neg_A_61_1 = s_base_ry * A_97 - neg_Rz_base_rx_x * t_left_hip_block_43;
  A[61] = -(neg_A_61_1 + Rz_left_hip_block_z * t_left_hip_block_45);
  A[129] = A[61];
  const Scalar t_left_hip_block_46 = c_left_hip_yaw * h_left_hip_block_z;
  // base_rz: A of (2)
  const Scalar A_7_1 = neg_Rx_base_rx_x * t_left_hip_block_46;
  const Scalar A_7_2 = Rx_base_ry_y * t_left_hip_block_44 - A_7_1;
  A[7] = A_7_2 - Rx_left_hip_block_z * t_left_hip_fork_2;
  A[126] = A[7];
  const Scalar neg_A_43_1 = neg_Rz_base_rx_x * t_left_hip_block_46;
  const Scalar neg_A_43_2 = s_base_ry * t_left_hip_block_44 + neg_A_43_1;
  A[43] = -(neg_A_43_2 + Rz_left_hip_block_z * t_left_hip_fork_2);
  A[128] = A[43];
  const Scalar A_25_1 = neg_Ry_base_rx_x * t_left_hip_block_46;
  const Scalar A_25_2 = Ry_base_ry_y * t_left_hip_block_44 - A_25_1;
  A[25] = A_25_2 - Ry_left_hip_block_z * t_left_hip_fork_2;
  A[127] = A[25];
  const Scalar t_left_hip_block_47 = A_114 + left_hip_block_l1 * t_left_hip_block_4;
  A[78] = -(s_base_rx * t_left_hip_block_47 + c_base_rx * t_left_hip_block_13);
  A[112] = A[78];
  const Scalar neg_A_60_1 = Rz_left_hip_block_z * t_left_hip_block_47;
  A[60] = -(neg_Rz_base_rx_x * t_left_hip_block_13 - neg_A_60_1 + s_base_ry * A_96);
  A[111] = A[60];
  A[6] = neg_Rx_base_rx_x * t_left_hip_block_2 - Rx_base_ry_y * t_left_hip_block_4;
  A[108] = A[6];
  A[24] = neg_Ry_base_rx_x * t_left_hip_block_2 - Ry_base_ry_y * t_left_hip_block_4;
  A[109] = A[24];
  A[42] = s_base_ry * t_left_hip_block_4 + neg_Rz_base_rx_x * t_left_hip_block_2;
  A[110] = A[42];
  const Scalar t_base_rx_2 = c_base_rx * neg_h_base_rx_y + s_base_rx * neg_h_base_rx_x;
  const Scalar neg_A_77 = s_base_rx * E_base_rx_yz - c_base_rx * E_base_rx_xz;
  A[77] = -neg_A_77;
  A[94] = A[77];
  const Scalar t_base_rz_1 = Rz_left_hip_block_z * E_base_rx_yz;
  const Scalar A_59 = t_base_rz_1 - s_base_ry * A_95 + neg_Rz_base_rx_x * E_base_rx_xz;
  A[59] = A_59;
  A[93] = A[59];
  A[5] = Rx_left_hip_block_z * neg_h_base_rx_x - neg_Rx_base_rx_x * neg_h_base_rx_y;
  A[90] = A[5];
  A[23] = Ry_left_hip_block_z * neg_h_base_rx_x - neg_Ry_base_rx_x * neg_h_base_rx_y;
  A[91] = A[23];
  const Scalar A_41 = Rz_left_hip_block_z * neg_h_base_rx_x - neg_Rz_base_rx_x * neg_h_base_rx_y;
  A[41] = A_41;
  A[92] = A[41];
  const Scalar t_base_ry_1 = c_base_rx * E_base_rx_xy;
  // base_rx: second moments E of (2)
  const Scalar neg_E_base_rx_zz_1 = base_rx_I3 + t_right_hip_block_10 + t_left_hip_block_7;
  const Scalar neg_E_base_rx_zz = t_base_rx_1 - neg_E_base_rx_zz_1;
  const Scalar t_base_rx_3 = E_base_rx_xx - neg_E_base_rx_zz;
  const Scalar t_base_ry_2 = t_base_ry_1 + s_base_rx * t_base_rx_3;
  const Scalar t_base_ry_3 = s_base_rx * E_base_rx_xy;
  const Scalar t_base_rx_4 = E_base_rx_yy - neg_E_base_rx_zz;
  const Scalar t_base_ry_4 = t_base_ry_3 + c_base_rx * t_base_rx_4;
  A[76] = c_base_rx * t_base_ry_4 + s_base_rx * t_base_ry_2;
  const Scalar A_58_1 = s_base_ry * neg_A_77 - Rz_left_hip_block_z * t_base_ry_2;
  A[58] = A_58_1 + neg_Rz_base_rx_x * t_base_ry_4;
  A[75] = A[58];
  const Scalar t_base_ry_5 = s_base_rx * h_base_rx_z;
  const Scalar t_base_ry_6 = c_base_rx * h_base_rx_z;
  // base_rz: A of (2)
  const Scalar neg_A_22_1 = neg_Ry_base_rx_x * t_base_ry_5 - Ry_base_ry_y * t_base_rx_2;
  A[22] = -(neg_A_22_1 + Ry_left_hip_block_z * t_base_ry_6);
  A[73] = A[22];
  const Scalar t_base_rz_2 = c_base_ry * t_base_ry_6;
  const Scalar t_base_rz_3 = neg_Rz_base_rx_x * h_base_rx_z;
  A[40] = -(c_base_rx * t_base_rz_2 + s_base_rx * t_base_rz_3 + s_base_ry * t_base_rx_2);
  A[74] = A[40];
  const Scalar A_4_1 = Rx_base_ry_y * t_base_rx_2 - Rx_left_hip_block_z * t_base_ry_6;
  A[4] = A_4_1 - neg_Rx_base_rx_x * t_base_ry_5;
  A[72] = A[4];
  const Scalar neg_A_57_1 = c_base_ry * (t_base_ry_1 - s_base_rx * t_base_rx_4);
  const Scalar neg_A_57_2 = Rz_left_hip_block_z * (t_base_ry_3 - c_base_rx * t_base_rx_3);
  const Scalar neg_A_57_3 = neg_A_57_1 + s_base_ry * E_base_rx_xz;
  const Scalar neg_A_57_4 = c_base_ry * (s_base_rx * neg_A_57_3 + neg_A_57_2);
  A[57] = -(neg_A_57_4 + s_base_ry * (t_base_rz_1 + A_59));
  const Scalar t_base_rz_4 = t_base_rz_2 + s_base_ry * neg_h_base_rx_y;
  const Scalar t_base_rz_5 = t_base_rz_3 + s_base_ry * neg_h_base_rx_x;
  const Scalar A_21_1 = neg_Ry_base_rx_x * t_base_rz_4 - Ry_base_ry_y * A_41;
  A[21] = A_21_1 - Ry_left_hip_block_z * t_base_rz_5;
  A[55] = A[21];
  const Scalar neg_A_3_1 = Rx_left_hip_block_z * t_base_rz_5;
  A[3] = -(neg_A_3_1 - neg_Rx_base_rx_x * t_base_rz_4 + Rx_base_ry_y * A_41);
  A[54] = A[3];
  A[0] = base_rx_m1;
  A[19] = base_rx_m1;
  A[38] = base_rx_m1;
  A[209] = left_foot_I5;
  A[323] = left_foot_I5;
  mass_matrix_0(A);
}

void bias_force(const Scalar q[18], const Scalar qd[18], Scalar B[18]) noexcept {
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const Scalar q_q15_q16 = q[15] + q[16];
  const Scalar q_q14_q15_q16 = q[14] + q_q15_q16;
  const Scalar angle_left_foot = left_foot_k1 + q[11];
  const Scalar angle_right_foot = left_foot_k1 - q[17];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[3], q[4], q[5], q[6]);
  sines_cosines(sines + 4, cosines + 4, q[7], q_q8_q9_q10, q_q9_q10, q[10]);
  sines_cosines(sines + 8, cosines + 8, q[12], q[13], q_q14_q15_q16, q_q15_q16);
  sines_cosines(sines + 12, cosines + 12, q[16], angle_left_foot, angle_right_foot);
  const Scalar s_base_rz = sines[0];
  const Scalar c_base_rz = cosines[0];
  const Scalar s_base_ry = sines[1];
  const Scalar c_base_ry = cosines[1];
  const Scalar s_base_rx = sines[2];
  const Scalar c_base_rx = cosines[2];
  const Scalar s_left_hip_yaw = sines[3];
  const Scalar c_left_hip_yaw = cosines[3];
  const Scalar s_left_hip_roll = sines[4];
  const Scalar c_left_hip_roll = cosines[4];
  const Scalar s_q8_q9_q10 = sines[5];
  const Scalar c_q8_q9_q10 = cosines[5];
  const Scalar s_q9_q10 = sines[6];
  const Scalar c_q9_q10 = cosines[6];
  const Scalar s_left_ankle_pitch = sines[7];
  const Scalar c_left_ankle_pitch = cosines[7];
  const Scalar s_right_hip_yaw = sines[8];
  const Scalar c_right_hip_yaw = cosines[8];
  const Scalar s_right_hip_roll = sines[9];
  const Scalar c_right_hip_roll = cosines[9];
  const Scalar s_q14_q15_q16 = sines[10];
  const Scalar c_q14_q15_q16 = cosines[10];
  const Scalar s_q15_q16 = sines[11];
  const Scalar c_q15_q16 = cosines[11];
  const Scalar s_right_ankle_pitch = sines[12];
  const Scalar c_right_ankle_pitch = cosines[12];
  const Scalar s_left_foot = sines[13];
  const Scalar c_left_foot = cosines[13];
  const Scalar s_right_foot = sines[14];
  const Scalar c_right_foot = cosines[14];
  const Scalar neg_s_left_shank_x = left_shank_l1 * c_q9_q10;
  const Scalar s_left_shank_y = left_shank_l1 * s_q9_q10;
  const Scalar s_left_ankle_cross_y = left_ankle_cross_l1 * s_left_ankle_pitch;
  const Scalar neg_s_left_ankle_cross_x = left_ankle_cross_l1 * c_left_ankle_pitch;
  const Scalar s_right_shank_y = left_shank_l1 * s_q15_q16;
  const Scalar neg_s_right_shank_x = left_shank_l1 * c_q15_q16;
  const Scalar s_righ_ankl_cros_y = left_ankle_cross_l1 * s_right_ankle_pitch;
  const Scalar neg_s_righ_ankl_cros_x = left_ankle_cross_l1 * c_right_ankle_pitch;
  // base_ry: angular velocity omega, angular acceleration alpha, Omega of (3)
  const Scalar omega_base_ry_y = s_base_ry * qd[3];
  const Scalar neg_omega_base_ry_x = c_base_ry * qd[3];
  const Scalar alpha_base_ry_y = qd[4] * neg_omega_base_ry_x;
  const Scalar alpha_base_ry_x = omega_base_ry_y * qd[4];
  const Scalar neg_Omega_base_ry_xy = omega_base_ry_y * neg_omega_base_ry_x;
  const Scalar Omega_base_ry_zy = 2.0 * alpha_base_ry_x;
  // base_rx: angular velocity omega, Omega of (3)
  const Scalar neg_omega_base_rx_y = c_base_rx * neg_omega_base_ry_x - s_base_rx * qd[4];
  const Scalar neg_omega_base_rx_z = omega_base_ry_y - qd[5];
  const Scalar t_base_rx_1 = c_base_rx * neg_Omega_base_ry_xy;
  const Scalar neg_Omega_base_rx_yz = s_base_rx * Omega_base_ry_zy - t_base_rx_1;
  const Scalar Omega_base_rx_zy_1 = neg_omega_base_rx_y * neg_omega_base_rx_z;
  const Scalar Omega_base_rx_zy = neg_Omega_base_rx_yz + 2.0 * Omega_base_rx_zy_1;
  const Scalar t_base_rx_2 = s_base_rx * neg_omega_base_ry_x;
  const Scalar neg_omega_base_rx_x = t_base_rx_2 + c_base_rx * qd[4];
  const Scalar t_base_rx_3 = neg_omega_base_rx_z * neg_omega_base_rx_x;
  const Scalar Omega_base_rx_xz = c_base_rx * Omega_base_ry_zy + omega_base_ry_y * t_base_rx_2;
  const Scalar alpha_left_hip_block_z = t_base_rx_3 - Omega_base_rx_xz;
  const Scalar Omega_base_rx_zx = t_base_rx_3 + alpha_left_hip_block_z;
  const Scalar t_base_rx_4 = neg_omega_base_rx_x * neg_omega_base_rx_x;
  const Scalar t_base_rx_5 = neg_omega_base_rx_z * neg_omega_base_rx_z;
  const Scalar t_base_rx_6 = t_base_rx_4 - t_base_rx_5;
  const Scalar neg_Omega_base_ry_yy = neg_omega_base_ry_x * neg_omega_base_ry_x + qd[4] * qd[4];
  const Scalar Omega_base_rx_xx = t_base_rx_6 - neg_Omega_base_ry_yy;
  const Scalar t_base_rx_7 = neg_omega_base_rx_y * neg_omega_base_rx_x;
  const Scalar neg_Omega_base_rx_yx = alpha_base_ry_y - t_base_rx_7;
  const Scalar neg_Omega_base_rx_yy = t_base_rx_4 + t_base_rx_5;
  const Scalar Omega_base_rx_xy = alpha_base_ry_y + t_base_rx_7;
  // left_hip_block: angular velocity omega, Omega, acceleration a of (3)
  const Scalar t_left_hip_block_1 = s_left_hip_yaw * neg_omega_base_rx_z;
  const Scalar omega_left_hip_block_x = t_left_hip_block_1 + c_left_hip_yaw * neg_omega_base_rx_x;
  const Scalar omega_left_hip_block_z = neg_omega_base_rx_y + qd[6];
  const Scalar t_left_hip_block_2 = omega_left_hip_block_x * omega_left_hip_block_z;
  const Scalar t_left_hip_block_3 = s_left_hip_yaw * Omega_base_rx_zy;
  const Scalar Omega_left_hip_block_xz = t_left_hip_block_3 + c_left_hip_yaw * Omega_base_rx_xy;
  const Scalar alpha_left_hip_fork_z = t_left_hip_block_2 - Omega_left_hip_block_xz;
  const Scalar Omega_left_hip_block_zx = t_left_hip_block_2 + alpha_left_hip_fork_z;
  const Scalar t_left_hip_block_4 = s_left_hip_yaw * Omega_base_rx_xy;
  const Scalar t_left_hip_block_5 = t_left_hip_block_4 - c_left_hip_yaw * Omega_base_rx_zy;
  const Scalar t_left_hip_block_6 = c_left_hip_yaw * neg_omega_base_rx_z;
  const Scalar omega_left_hip_block_y = t_left_hip_block_6 - s_left_hip_yaw * neg_omega_base_rx_x;
  const Scalar t_left_hip_block_7 = omega_left_hip_block_z * omega_left_hip_block_y;
  const Scalar Omega_left_hip_block_zy = t_left_hip_block_5 + 2.0 * t_left_hip_block_7;
  const Scalar t_left_hip_block_8 = left_hip_block_l1 * Omega_base_rx_zx;
  const Scalar t_left_hip_block_9 = left_hip_block_l1 * Omega_base_rx_xx;
  const Scalar t_left_hip_block_10 = omega_left_hip_block_x * omega_left_hip_block_x;
  const Scalar t_left_hip_block_11 = omega_left_hip_block_z * omega_left_hip_block_z;
  const Scalar t_left_hip_block_12 = t_left_hip_block_10 + t_left_hip_block_11;
  const Scalar t_left_hip_block_13 = omega_left_hip_block_x * omega_left_hip_block_y;
  const Scalar t_left_hip_block_14 = alpha_left_hip_block_z - t_left_hip_block_13;
  const Scalar Omega_left_hip_block_yx = alpha_left_hip_block_z + t_left_hip_block_13;
  const Scalar a_right_hip_block_z = left_hip_block_l1 * neg_Omega_base_rx_yx;
  const Scalar t_left_hip_block_15 = left_hip_block_I13 * neg_Omega_base_rx_yx;
  const Scalar t_left_hip_block_16 = left_hip_block_I14 * neg_Omega_base_rx_yx;
  // left_hip_fork: Omega, angular velocity omega, acceleration a of (3)
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * Omega_left_hip_block_zy;
  const Scalar Omega_left_hip_fork_yz = t_left_hip_fork_1 - c_left_hip_roll * t_left_hip_block_14;
  const Scalar t_left_hip_fork_2 = s_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 + c_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_4 = omega_left_hip_block_y - qd[7];
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_3 * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = Omega_left_hip_fork_yz - 2.0 * t_left_hip_fork_5;
  const Scalar t_left_hip_fork_7 = c_left_hip_roll * Omega_left_hip_block_zy;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_7 + s_left_hip_roll * t_left_hip_block_14;
  const Scalar t_left_hip_fork_9 = s_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_9 - c_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_4 * t_left_hip_fork_10;
  const Scalar alpha_left_thigh_z = t_left_hip_fork_8 + t_left_hip_fork_11;
  const Scalar Omega_left_hip_fork_zx = t_left_hip_fork_11 + alpha_left_thigh_z;
  const Scalar t_left_hip_fork_12 = left_hip_block_l2 * neg_Omega_base_rx_yy;
  const Scalar t_left_hip_fork_13 = a_right_hip_block_z + t_left_hip_fork_12;
  const Scalar a_left_hip_block_x_1 = s_left_hip_yaw * t_left_hip_block_8;
  const Scalar a_left_hip_block_x = a_left_hip_block_x_1 + c_left_hip_yaw * t_left_hip_block_9;
  const Scalar t_left_hip_fork_14 =
      a_left_hip_block_x + left_hip_block_l2 * Omega_left_hip_block_xz;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_3 * t_left_hip_fork_10;
  const Scalar t_left_hip_fork_16 = alpha_left_hip_fork_z - t_left_hip_fork_15;
  const Scalar a_left_hip_block_y_1 = c_left_hip_yaw * t_left_hip_block_8;
  const Scalar a_left_hip_block_y = a_left_hip_block_y_1 - s_left_hip_yaw * t_left_hip_block_9;
  const Scalar neg_a_left_hip_fork_z = a_left_hip_block_y - left_hip_block_l2 * t_left_hip_block_5;
  const Scalar Omega_left_hip_fork_yx = alpha_left_hip_fork_z + t_left_hip_fork_15;
  const Scalar t_left_hip_fork_17 = t_left_hip_fork_10 * t_left_hip_fork_10;
  const Scalar t_left_hip_fork_18 = t_left_hip_fork_4 * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_19 = t_left_hip_fork_17 - t_left_hip_fork_18;
  const Scalar t_left_hip_fork_20 = t_left_hip_fork_17 + t_left_hip_fork_18;
  // left_thigh: Omega, angular velocity omega, acceleration a of (3)
  const Scalar Omega_left_thigh_yz_1 = s_q8_q9_q10 * t_left_hip_fork_16;
  const Scalar Omega_left_thigh_yz = Omega_left_thigh_yz_1 - c_q8_q9_q10 * t_left_hip_fork_6;
  const Scalar omega_left_thigh_y_1 = c_q8_q9_q10 * t_left_hip_fork_4;
  const Scalar omega_left_thigh_y = omega_left_thigh_y_1 - s_q8_q9_q10 * t_left_hip_fork_10;
  const Scalar omega_left_thigh_z = t_left_hip_fork_3 + qd[8];
  const Scalar t_left_thigh_1 = 2.0 * omega_left_thigh_y;
  const Scalar neg_Omega_left_thigh_zy = Omega_left_thigh_yz - omega_left_thigh_z * t_left_thigh_1;
  const Scalar t_left_thigh_2 = c_q8_q9_q10 * t_left_hip_fork_16;
  const Scalar neg_Omega_left_thigh_xz = t_left_thigh_2 + s_q8_q9_q10 * t_left_hip_fork_6;
  const Scalar omega_left_thigh_x_1 = s_q8_q9_q10 * t_left_hip_fork_4;
  const Scalar omega_left_thigh_x = omega_left_thigh_x_1 + c_q8_q9_q10 * t_left_hip_fork_10;
  const Scalar t_left_thigh_3 = 2.0 * omega_left_thigh_x;
  const Scalar Omega_left_thigh_zx = neg_Omega_left_thigh_xz + omega_left_thigh_z * t_left_thigh_3;
  const Scalar t_left_hip_fork_21 = c_left_hip_roll * t_left_hip_fork_13;
  const Scalar neg_a_left_hip_fork_x = t_left_hip_fork_21 + s_left_hip_roll * t_left_hip_fork_14;
  const Scalar t_left_thigh_4 = neg_a_left_hip_fork_x + left_hip_fork_l1 * t_left_hip_fork_8;
  const Scalar t_left_thigh_5 = omega_left_thigh_y * omega_left_thigh_x;
  const Scalar Omega_left_foot_xz = alpha_left_thigh_z - t_left_thigh_5;
  const Scalar a_left_hip_fork_y_1 = s_left_hip_roll * t_left_hip_fork_13;
  const Scalar a_left_hip_fork_y = a_left_hip_fork_y_1 - c_left_hip_roll * t_left_hip_fork_14;
  const Scalar neg_a_left_thigh_z = a_left_hip_fork_y + left_hip_fork_l1 * Omega_left_hip_fork_yz;
  const Scalar Omega_left_thigh_yx = alpha_left_thigh_z + t_left_thigh_5;
  const Scalar t_left_thigh_6 = omega_left_thigh_x * omega_left_thigh_x;
  const Scalar t_left_thigh_7 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_8 = t_left_hip_fork_20 - t_left_thigh_6;
  const Scalar neg_Omega_left_thigh_yy = t_left_thigh_6 + t_left_thigh_7;
  const Scalar t_left_thigh_9 = left_thigh_I1 * c_q9_q10 - left_thigh_I7 * s_q9_q10;
  const Scalar t_left_thigh_10 = left_thigh_I8 - c_q9_q10 * t_left_thigh_9;
  const Scalar t_left_thigh_11 = left_thigh_I3 * c_q9_q10 - left_thigh_I9 * s_q9_q10;
  const Scalar t_left_thigh_12 = s_q9_q10 * t_left_thigh_9;
  const Scalar t_left_thigh_13 = left_thigh_I10 + t_left_thigh_12;
  const Scalar t_left_thigh_14 = left_thigh_I9 * c_q9_q10 + left_thigh_I3 * s_q9_q10;
  const Scalar t_left_thigh_15 = left_thigh_h3 * c_q9_q10 + left_thigh_h1 * s_q9_q10;
  const Scalar t_left_thigh_16 = left_thigh_I11 - t_left_thigh_12;
  const Scalar t_left_thigh_17 = left_thigh_h1 * c_q9_q10 - left_thigh_h3 * s_q9_q10;
  const Scalar neg_Omega_left_thigh_xx = t_left_thigh_7 + t_left_thigh_8;
  // left_shank: moment M, acceleration a, angular velocity omega of (3)
  const Scalar t_left_shank_1 = neg_Omega_left_thigh_yy - neg_Omega_left_thigh_xx;
  const Scalar neg_a_left_shank_z_1 = neg_a_left_thigh_z + s_left_shank_y * neg_Omega_left_thigh_zy;
  const Scalar neg_a_left_shank_z = neg_a_left_shank_z_1 + neg_s_left_shank_x * Omega_left_thigh_zx;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[9];
  const Scalar neg_Omega_left_shank_zy = Omega_left_thigh_yz - t_left_thigh_1 * omega_left_shank_z;
  const Scalar Omega_left_shank_zx = Omega_left_thigh_zx + t_left_thigh_3 * qd[9];
  const Scalar t_left_shank_2 = omega_left_shank_z * omega_left_shank_z;
  const Scalar neg_M_left_thigh_y_1 = t_left_thigh_6 - t_left_shank_2;
  const Scalar neg_Omega_left_shank_xx = t_left_thigh_8 + t_left_shank_2;
  const Scalar neg_Omega_left_shank_yy = t_left_thigh_6 + t_left_shank_2;
  const Scalar t_left_shank_3 = left_shank_h3 * c_left_ankle_pitch;
  const Scalar t_left_shank_4 = t_left_shank_3 + left_shank_h2 * s_left_ankle_pitch;
  const Scalar t_left_shank_5 = left_shank_I1 * c_left_ankle_pitch;
  const Scalar t_left_shank_6 = t_left_shank_5 - left_shank_I8 * s_left_ankle_pitch;
  const Scalar t_left_shank_7 = left_shank_I9 - c_left_ankle_pitch * t_left_shank_6;
  const Scalar t_left_shank_8 = left_shank_I10 * s_left_ankle_pitch;
  const Scalar t_left_shank_9 = t_left_shank_8 - left_shank_I3 * c_left_ankle_pitch;
  const Scalar t_left_shank_10 = s_left_ankle_pitch * t_left_shank_6;
  const Scalar t_left_shank_11 = left_shank_I11 + t_left_shank_10;
  const Scalar t_left_shank_12 = left_shank_I10 * c_left_ankle_pitch;
  const Scalar t_left_shank_13 = t_left_shank_12 + left_shank_I3 * s_left_ankle_pitch;
  const Scalar t_left_shank_14 = left_shank_h2 * c_left_ankle_pitch;
  const Scalar t_left_shank_15 = t_left_shank_14 - left_shank_h3 * s_left_ankle_pitch;
  const Scalar t_left_shank_16 = left_shank_I12 - t_left_shank_10;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[10];
  const Scalar Omega_left_foot_yz = neg_Omega_left_shank_zy - t_left_thigh_1 * qd[10];
  // left_ankle_cross: Omega, acceleration a of (3)
  const Scalar t_left_ankle_cross_1 =
      neg_Omega_left_thigh_xz + t_left_thigh_3 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_2 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_3 = t_left_thigh_6 + t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_4 =
      neg_a_left_shank_z + neg_s_left_ankle_cross_x * Omega_left_shank_zx;
  const Scalar neg_a_left_ankle_cross_z =
      t_left_ankle_cross_4 + s_left_ankle_cross_y * neg_Omega_left_shank_zy;
  // left_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar neg_a_left_foot_y_1 =
      neg_a_left_ankle_cross_z - left_hip_fork_l3 * t_left_hip_fork_20;
  const Scalar neg_a_left_foot_y = neg_a_left_foot_y_1 - left_hip_fork_l1 * t_left_ankle_cross_1;
  const Scalar neg_omega_left_foot_z = omega_left_thigh_y - qd[11];
  const Scalar t_left_foot_1 = 2.0 * neg_omega_left_foot_z;
  const Scalar neg_Omega_left_foot_zy =
      Omega_left_foot_yz + omega_left_ankle_cross_z * t_left_foot_1;
  const Scalar t_left_ankle_cross_5 = t_left_thigh_6 - t_left_ankle_cross_2;
  const Scalar t_left_thigh_18 = neg_a_left_hip_fork_z + left_hip_fork_l1 * t_left_hip_block_12;
  const Scalar a_left_thigh_x = c_q8_q9_q10 * t_left_thigh_4 + s_q8_q9_q10 * t_left_thigh_18;
  const Scalar a_left_shank_x_1 = a_left_thigh_x - s_left_shank_y * Omega_left_foot_xz;
  const Scalar a_left_shank_x = a_left_shank_x_1 + neg_s_left_shank_x * neg_Omega_left_thigh_xx;
  // left_ankle_cross: acceleration a, Omega of (3)
  const Scalar t_left_ankle_cross_6 = a_left_shank_x - s_left_ankle_cross_y * Omega_left_foot_xz;
  const Scalar a_left_ankle_cross_x =
      t_left_ankle_cross_6 + neg_s_left_ankle_cross_x * neg_Omega_left_shank_xx;
  const Scalar a_left_foot_x_1 = t_left_hip_fork_20 - t_left_ankle_cross_5;
  const Scalar a_left_foot_x_2 = a_left_ankle_cross_x - left_hip_fork_l1 * a_left_foot_x_1;
  const Scalar a_left_foot_x = a_left_foot_x_2 + left_hip_fork_l3 * neg_Omega_left_thigh_xz;
  const Scalar a_left_thigh_y = c_q8_q9_q10 * t_left_thigh_18 - s_q8_q9_q10 * t_left_thigh_4;
  const Scalar a_left_shank_y_1 = a_left_thigh_y - neg_s_left_shank_x * Omega_left_thigh_yx;
  const Scalar a_left_shank_y = a_left_shank_y_1 - s_left_shank_y * neg_Omega_left_thigh_yy;
  // left_foot: acceleration a, Omega, moment M of (3)
  const Scalar neg_a_left_foot_z_1 =
      a_left_shank_y - s_left_ankle_cross_y * neg_Omega_left_shank_yy;
  const Scalar neg_a_left_foot_z_2 = left_hip_fork_l1 - neg_s_left_ankle_cross_x;
  const Scalar neg_a_left_foot_z_3 = neg_a_left_foot_z_1 - left_hip_fork_l3 * Omega_left_thigh_yz;
  const Scalar neg_a_left_foot_z = neg_a_left_foot_z_3 + Omega_left_thigh_yx * neg_a_left_foot_z_2;
  const Scalar neg_Omega_left_foot_zx = Omega_left_foot_xz + omega_left_thigh_x * t_left_foot_1;
  const Scalar t_left_foot_2 = neg_omega_left_foot_z * neg_omega_left_foot_z;
  const Scalar t_left_foot_3 = left_foot_h1 * c_left_foot;
  const Scalar t_left_foot_4 = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_5 = left_foot_I9 * c_left_foot + left_foot_I8 * s_left_foot;
  const Scalar t_left_foot_6 = s_left_foot * t_left_foot_5;
  const Scalar t_left_foot_7 = left_foot_I12 - t_left_foot_6;
  const Scalar t_left_foot_8 = left_foot_I2 * c_left_foot + left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_9 = left_foot_I2 * s_left_foot - left_foot_I1 * c_left_foot;
  const Scalar t_left_foot_10 = left_foot_I13 + t_left_foot_6;
  const Scalar t_left_foot_11 = left_foot_I14 - c_left_foot * t_left_foot_5;
  const Scalar M_left_foot_z_1 = t_left_ankle_cross_5 * t_left_foot_11;
  const Scalar M_left_foot_z_2 = Omega_left_foot_yz * t_left_foot_8 + M_left_foot_z_1;
  const Scalar M_left_foot_z_3 = M_left_foot_z_2 - Omega_left_foot_xz * t_left_foot_9;
  const Scalar M_left_foot_z_4 = M_left_foot_z_3 + t_left_ankle_cross_1 * t_left_foot_7;
  const Scalar M_left_foot_z_5 = M_left_foot_z_4 - a_left_foot_x * t_left_foot_4;
  const Scalar M_left_foot_z_6 = M_left_foot_z_5 + neg_Omega_left_thigh_xz * t_left_foot_10;
  const Scalar M_left_foot_z = M_left_foot_z_6 - neg_a_left_foot_y * t_left_foot_3;
  B[11] = M_left_foot_z;
  const Scalar neg_F_left_foot_z_1 = neg_Omega_left_foot_zx * t_left_foot_3;
  const Scalar neg_F_left_foot_z_2 = neg_F_left_foot_z_1 + neg_Omega_left_foot_zy * t_left_foot_4;
  const Scalar neg_F_left_foot_z = neg_F_left_foot_z_2 + left_ankle_cross_m1 * neg_a_left_foot_z;
  const Scalar F_left_foot_x_1 = t_left_foot_3 * (t_left_ankle_cross_2 + t_left_foot_2);
  const Scalar F_left_foot_x_2 = left_ankle_cross_m1 * a_left_foot_x - F_left_foot_x_1;
  const Scalar F_left_foot_x = F_left_foot_x_2 - neg_Omega_left_thigh_xz * t_left_foot_4;
  // right_hip_block: Omega, angular velocity omega, angular acceleration alpha of (3)
  const Scalar t_right_hip_block_1 = c_right_hip_yaw * Omega_base_rx_zy;
  const Scalar Omega_right_hip_block_yz = t_right_hip_block_1 - s_right_hip_yaw * Omega_base_rx_xy;
  const Scalar t_right_hip_block_2 = s_right_hip_yaw * neg_omega_base_rx_x;
  const Scalar t_right_hip_block_3 = t_right_hip_block_2 - c_right_hip_yaw * neg_omega_base_rx_z;
  const Scalar omega_right_hip_block_z = neg_omega_base_rx_y + qd[12];
  const Scalar t_right_hip_block_4 = t_right_hip_block_3 * omega_right_hip_block_z;
  const Scalar t_right_hip_block_5 = Omega_right_hip_block_yz + 2.0 * t_right_hip_block_4;
  const Scalar t_right_hip_block_6 = c_right_hip_yaw * Omega_base_rx_xy;
  const Scalar Omega_right_hip_block_xz = t_right_hip_block_6 + s_right_hip_yaw * Omega_base_rx_zy;
  const Scalar t_right_hip_block_7 = c_right_hip_yaw * neg_omega_base_rx_x;
  const Scalar omega_right_hip_block_x =
      t_right_hip_block_7 + s_right_hip_yaw * neg_omega_base_rx_z;
  const Scalar t_right_hip_block_8 = omega_right_hip_block_z * omega_right_hip_block_x;
  const Scalar alpha_right_hip_block_y = Omega_right_hip_block_xz - t_right_hip_block_8;
  const Scalar Omega_right_hip_block_zx = t_right_hip_block_8 - alpha_right_hip_block_y;
  const Scalar t_right_hip_block_9 = omega_right_hip_block_x * omega_right_hip_block_x;
  const Scalar t_right_hip_block_10 = omega_right_hip_block_z * omega_right_hip_block_z;
  const Scalar t_right_hip_block_11 = t_right_hip_block_3 * omega_right_hip_block_x;
  const Scalar t_right_hip_block_12 = alpha_left_hip_block_z + t_right_hip_block_11;
  const Scalar t_right_hip_block_13 = t_right_hip_block_9 + t_right_hip_block_10;
  const Scalar Omega_right_hip_block_yx = alpha_left_hip_block_z - t_right_hip_block_11;
  // right_hip_fork: Omega, angular velocity omega, angular acceleration alpha of (3)
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * t_right_hip_block_5;
  const Scalar Omega_right_hip_fork_xz =
      t_right_hip_fork_1 - s_right_hip_roll * t_right_hip_block_12;
  const Scalar t_right_hip_fork_2 = s_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 - c_right_hip_roll * omega_right_hip_block_z;
  const Scalar omega_right_hip_fork_z = t_right_hip_block_3 + qd[13];
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_3 * omega_right_hip_fork_z;
  const Scalar alpha_right_hip_fork_y = Omega_right_hip_fork_xz + t_right_hip_fork_4;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_4 + alpha_right_hip_fork_y;
  const Scalar t_right_hip_fork_6 = c_right_hip_roll * t_right_hip_block_12;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_6 + s_right_hip_roll * t_right_hip_block_5;
  const Scalar t_right_hip_fork_8 = s_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_8 + c_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_10 = omega_right_hip_fork_z * t_right_hip_fork_9;
  const Scalar Omega_right_hip_fork_zy = t_right_hip_fork_7 - 2.0 * t_right_hip_fork_10;
  const Scalar t_right_hip_block_14 = s_right_hip_yaw * t_left_hip_block_8;
  const Scalar neg_a_right_hip_block_x =
      t_right_hip_block_14 + c_right_hip_yaw * t_left_hip_block_9;
  const Scalar t_right_hip_fork_11 =
      neg_a_right_hip_block_x - left_hip_block_l2 * Omega_right_hip_block_xz;
  const Scalar t_right_hip_block_15 = c_right_hip_yaw * t_left_hip_block_8;
  const Scalar neg_a_right_hip_block_y =
      t_right_hip_block_15 - s_right_hip_yaw * t_left_hip_block_9;
  const Scalar a_right_hip_fork_z =
      neg_a_right_hip_block_y - left_hip_block_l2 * Omega_right_hip_block_yz;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_3 * t_right_hip_fork_9;
  const Scalar t_right_hip_fork_13 = alpha_right_hip_block_y - t_right_hip_fork_12;
  const Scalar Omega_right_hip_fork_xy = alpha_right_hip_block_y + t_right_hip_fork_12;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_3 * t_right_hip_fork_3;
  const Scalar t_right_hip_fork_15 = omega_right_hip_fork_z * omega_right_hip_fork_z;
  const Scalar t_right_hip_fork_16 = t_right_hip_fork_14 + t_right_hip_fork_15;
  const Scalar Omega_right_foot_xy_1 = s_q14_q15_q16 * Omega_right_hip_fork_zy;
  const Scalar Omega_right_foot_xy =
      Omega_right_foot_xy_1 + c_q14_q15_q16 * Omega_right_hip_fork_xy;
  // right_thigh: angular velocity omega, Omega of (3)
  const Scalar t_right_thigh_1 = s_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar neg_omega_right_thigh_x = t_right_thigh_1 - c_q14_q15_q16 * t_right_hip_fork_3;
  const Scalar omega_right_thigh_z = t_right_hip_fork_9 + qd[14];
  const Scalar t_right_thigh_2 = 2.0 * neg_omega_right_thigh_x;
  const Scalar neg_Omega_right_thigh_zx =
      Omega_right_foot_xy + omega_right_thigh_z * t_right_thigh_2;
  const Scalar t_right_thigh_3 = s_q14_q15_q16 * Omega_right_hip_fork_xy;
  const Scalar neg_Omega_right_thigh_yz = t_right_thigh_3 - c_q14_q15_q16 * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_4 = c_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar neg_omega_right_thigh_y = t_right_thigh_4 + s_q14_q15_q16 * t_right_hip_fork_3;
  const Scalar t_right_thigh_5 = 2.0 * neg_omega_right_thigh_y;
  const Scalar Omega_right_thigh_zy =
      neg_Omega_right_thigh_yz - omega_right_thigh_z * t_right_thigh_5;
  // right_hip_fork: acceleration a of (3)
  const Scalar t_right_hip_fork_17 = a_right_hip_block_z - t_left_hip_fork_12;
  const Scalar a_right_hip_fork_x_1 = c_right_hip_roll * t_right_hip_fork_17;
  const Scalar a_right_hip_fork_x = a_right_hip_fork_x_1 + s_right_hip_roll * t_right_hip_fork_11;
  // right_thigh: acceleration a, Omega, moment M of (3)
  const Scalar t_right_thigh_6 = a_right_hip_fork_x + left_hip_fork_l1 * Omega_right_hip_fork_xz;
  const Scalar t_right_thigh_7 = a_right_hip_fork_z - left_hip_fork_l1 * t_right_hip_block_13;
  const Scalar t_right_thigh_8 = neg_omega_right_thigh_x * neg_omega_right_thigh_y;
  const Scalar neg_Omega_right_thigh_yx = alpha_right_hip_fork_y - t_right_thigh_8;
  const Scalar Omega_right_thigh_xy = alpha_right_hip_fork_y + t_right_thigh_8;
  const Scalar t_right_hip_fork_18 = s_right_hip_roll * t_right_hip_fork_17;
  const Scalar neg_a_right_hip_fork_y =
      t_right_hip_fork_18 - c_right_hip_roll * t_right_hip_fork_11;
  const Scalar a_right_thigh_z = neg_a_right_hip_fork_y + left_hip_fork_l1 * t_right_hip_fork_7;
  const Scalar t_right_thigh_9 = neg_omega_right_thigh_x * neg_omega_right_thigh_x;
  const Scalar t_right_thigh_10 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_11 = t_right_hip_fork_16 - t_right_thigh_9;
  const Scalar neg_Omega_right_thigh_xx = t_right_thigh_10 + t_right_thigh_11;
  const Scalar neg_Omega_right_thigh_yy = t_right_thigh_9 + t_right_thigh_10;
  const Scalar t_right_thigh_12 = left_thigh_I7 * s_q15_q16 - left_thigh_I1 * c_q15_q16;
  const Scalar t_right_thigh_13 = left_thigh_I8 + c_q15_q16 * t_right_thigh_12;
  const Scalar t_right_thigh_14 = left_thigh_I9 * s_q15_q16 - left_thigh_I3 * c_q15_q16;
  const Scalar t_right_thigh_15 = s_q15_q16 * t_right_thigh_12;
  const Scalar t_right_thigh_16 = left_thigh_I10 - t_right_thigh_15;
  const Scalar t_right_thigh_17 = left_thigh_I3 * s_q15_q16 + left_thigh_I9 * c_q15_q16;
  const Scalar t_right_thigh_18 = left_thigh_h1 * s_q15_q16 + left_thigh_h3 * c_q15_q16;
  const Scalar t_right_thigh_19 = left_thigh_I11 + t_right_thigh_15;
  const Scalar t_right_thigh_20 = left_thigh_h3 * s_q15_q16 - left_thigh_h1 * c_q15_q16;
  // right_shank: moment M, acceleration a, angular velocity omega of (3)
  const Scalar t_right_shank_1 = t_right_thigh_9 - t_right_thigh_11;
  const Scalar a_right_shank_z_1 = a_right_thigh_z + neg_s_right_shank_x * neg_Omega_right_thigh_zx;
  const Scalar a_right_shank_z = a_right_shank_z_1 + s_right_shank_y * Omega_right_thigh_zy;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[15];
  const Scalar Omega_right_shank_zy = Omega_right_thigh_zy - t_right_thigh_5 * qd[15];
  const Scalar neg_Omega_right_shank_zx = neg_Omega_right_thigh_zx + t_right_thigh_2 * qd[15];
  const Scalar t_right_shank_2 = omega_right_shank_z * omega_right_shank_z;
  const Scalar neg_Omega_right_shank_xx = t_right_thigh_11 + t_right_shank_2;
  const Scalar neg_Omega_right_shank_yy = t_right_thigh_9 + t_right_shank_2;
  const Scalar t_right_shank_3 = left_shank_h3 * s_right_ankle_pitch;
  const Scalar t_right_shank_4 = t_right_shank_3 - left_shank_h2 * c_right_ankle_pitch;
  const Scalar t_right_shank_5 = left_shank_I8 * s_right_ankle_pitch;
  const Scalar t_right_shank_6 = t_right_shank_5 - left_shank_I1 * c_right_ankle_pitch;
  const Scalar t_right_shank_7 = left_shank_I9 + c_right_ankle_pitch * t_right_shank_6;
  const Scalar t_right_shank_8 = s_right_ankle_pitch * t_right_shank_6;
  const Scalar t_right_shank_9 = left_shank_I12 + t_right_shank_8;
  const Scalar t_right_shank_10 = left_shank_I10 * s_right_ankle_pitch;
  const Scalar t_right_shank_11 = left_shank_I3 * c_right_ankle_pitch - t_right_shank_10;
  const Scalar t_right_shank_12 = left_shank_h3 * c_right_ankle_pitch;
  const Scalar t_right_shank_13 = t_right_shank_12 + left_shank_h2 * s_right_ankle_pitch;
  const Scalar t_right_shank_14 = left_shank_I11 - t_right_shank_8;
  // right_ankle_cross: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[16];
  const Scalar Omega_righ_ankl_cros_zy = Omega_right_shank_zy - t_right_thigh_5 * qd[16];
  const Scalar t_righ_ankl_cros_1 = neg_Omega_right_shank_zx + t_right_thigh_2 * qd[16];
  const Scalar t_righ_ankl_cros_2 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_3 = t_right_thigh_11 + t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_4 = t_right_hip_fork_16 - t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_5 = t_right_thigh_9 + t_righ_ankl_cros_2;
  const Scalar a_righ_ankl_cros_z_1 =
      a_right_shank_z + neg_s_righ_ankl_cros_x * neg_Omega_right_shank_zx;
  const Scalar a_righ_ankl_cros_z =
      a_righ_ankl_cros_z_1 + s_righ_ankl_cros_y * Omega_right_shank_zy;
  // right_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar a_right_foot_y_1 = a_righ_ankl_cros_z - left_hip_fork_l1 * t_righ_ankl_cros_1;
  const Scalar a_right_foot_y = a_right_foot_y_1 - left_hip_fork_l3 * t_right_hip_fork_16;
  const Scalar omega_right_foot_z = neg_omega_right_thigh_y + qd[17];
  const Scalar t_right_foot_1 = 2.0 * omega_right_foot_z;
  const Scalar Omega_right_foot_zy =
      Omega_righ_ankl_cros_zy + omega_righ_ankl_cros_z * t_right_foot_1;
  const Scalar t_right_foot_2 = left_hip_fork_l1 - neg_s_righ_ankl_cros_x;
  const Scalar a_right_thigh_y_1 = s_q14_q15_q16 * t_right_thigh_6;
  const Scalar a_right_thigh_y = a_right_thigh_y_1 - c_q14_q15_q16 * t_right_thigh_7;
  const Scalar a_right_shank_y_1 = a_right_thigh_y + neg_s_right_shank_x * neg_Omega_right_thigh_yx;
  const Scalar a_right_shank_y = a_right_shank_y_1 - s_right_shank_y * neg_Omega_right_thigh_yy;
  const Scalar neg_a_right_foot_z_1 =
      a_right_shank_y - s_righ_ankl_cros_y * neg_Omega_right_shank_yy;
  const Scalar neg_a_right_foot_z_2 =
      neg_a_right_foot_z_1 - left_hip_fork_l3 * neg_Omega_right_thigh_yz;
  const Scalar neg_a_right_foot_z =
      neg_a_right_foot_z_2 - neg_Omega_right_thigh_yx * t_right_foot_2;
  const Scalar neg_a_right_thigh_x_1 = c_q14_q15_q16 * t_right_thigh_6;
  const Scalar neg_a_right_thigh_x = neg_a_right_thigh_x_1 + s_q14_q15_q16 * t_right_thigh_7;
  const Scalar neg_a_right_shank_x_1 =
      neg_a_right_thigh_x - neg_s_right_shank_x * neg_Omega_right_thigh_xx;
  const Scalar neg_a_right_shank_x = neg_a_right_shank_x_1 - s_right_shank_y * Omega_right_thigh_xy;
  const Scalar t_righ_ankl_cros_6 =
      neg_a_right_shank_x - neg_s_righ_ankl_cros_x * neg_Omega_right_shank_xx;
  const Scalar neg_a_righ_ankl_cros_x =
      t_righ_ankl_cros_6 - s_righ_ankl_cros_y * Omega_right_thigh_xy;
  const Scalar neg_a_right_foot_x_1 =
      neg_a_righ_ankl_cros_x + left_hip_fork_l1 * t_righ_ankl_cros_3;
  const Scalar neg_a_right_foot_x = neg_a_right_foot_x_1 - left_hip_fork_l3 * Omega_right_foot_xy;
  const Scalar Omega_right_foot_zx =
      Omega_right_thigh_xy - neg_omega_right_thigh_x * t_right_foot_1;
  const Scalar t_right_foot_3 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_4 = left_foot_h1 * c_right_foot;
  const Scalar t_right_foot_5 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_6 = left_foot_I8 * s_right_foot + left_foot_I9 * c_right_foot;
  const Scalar t_right_foot_7 = s_right_foot * t_right_foot_6;
  const Scalar t_right_foot_8 = left_foot_I12 - t_right_foot_7;
  const Scalar t_right_foot_9 = left_foot_I1 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_10 = left_foot_I1 * c_right_foot - left_foot_I2 * s_right_foot;
  const Scalar t_right_foot_11 = left_foot_I13 + t_right_foot_7;
  const Scalar t_right_foot_12 = left_foot_I14 - c_right_foot * t_right_foot_6;
  const Scalar neg_M_right_foot_z_1 = t_righ_ankl_cros_1 * t_right_foot_8;
  const Scalar neg_M_right_foot_z_2 = neg_a_right_foot_x * t_right_foot_5 + neg_M_right_foot_z_1;
  const Scalar neg_M_right_foot_z_3 = neg_M_right_foot_z_2 + Omega_right_foot_xy * t_right_foot_11;
  const Scalar neg_M_right_foot_z_4 = neg_M_right_foot_z_3 + t_righ_ankl_cros_4 * t_right_foot_12;
  const Scalar neg_M_right_foot_z_5 = neg_M_right_foot_z_4 - a_right_foot_y * t_right_foot_4;
  const Scalar neg_M_right_foot_z_6 =
      neg_M_right_foot_z_5 + Omega_righ_ankl_cros_zy * t_right_foot_9;
  const Scalar neg_M_right_foot_z = neg_M_right_foot_z_6 - Omega_right_thigh_xy * t_right_foot_10;
  B[17] = -neg_M_right_foot_z;
  const Scalar neg_Omega_right_foot_yy = t_right_thigh_9 + t_right_foot_3;
  const Scalar neg_F_right_foot_z_1 = left_ankle_cross_m1 * neg_a_right_foot_z;
  const Scalar neg_F_right_foot_z_2 = neg_F_right_foot_z_1 - Omega_right_foot_zx * t_right_foot_4;
  const Scalar neg_F_right_foot_z = neg_F_right_foot_z_2 + Omega_right_foot_zy * t_right_foot_5;
  const Scalar t_right_foot_13 = t_right_thigh_9 - t_right_foot_3;
  const Scalar neg_F_right_foot_x_1 = left_ankle_cross_m1 * neg_a_right_foot_x;
  const Scalar neg_Omega_right_foot_xx = t_righ_ankl_cros_5 - t_right_foot_13;
  const Scalar neg_F_right_foot_x_2 = neg_F_right_foot_x_1 + Omega_right_foot_xy * t_right_foot_5;
  const Scalar neg_F_right_foot_x = neg_F_right_foot_x_2 + t_right_foot_4 * neg_Omega_right_foot_xx;
  const Scalar M_righ_ankl_cros_z_1 = Omega_right_foot_zy * t_right_foot_12;
  // right_ankle_cross: moment M, force F of (3)
  const Scalar M_righ_ankl_cros_z_2 = left_hip_fork_l1 * neg_F_right_foot_z - M_righ_ankl_cros_z_1;
  const Scalar M_righ_ankl_cros_z_3 = M_righ_ankl_cros_z_2 + left_ankle_cross_I10 * t_right_thigh_8;
  const Scalar M_righ_ankl_cros_z_4 = M_righ_ankl_cros_z_3 - Omega_right_foot_zx * t_right_foot_8;
  const Scalar M_righ_ankl_cros_z_5 = M_righ_ankl_cros_z_4 + t_right_foot_9 * t_right_foot_13;
  const Scalar M_righ_ankl_cros_z_6 = M_righ_ankl_cros_z_5 + neg_a_right_foot_z * t_right_foot_4;
  const Scalar M_righ_ankl_cros_z_7 = left_ankle_cross_I1 + t_right_foot_10;
  const Scalar M_righ_ankl_cros_z_8 =
      M_righ_ankl_cros_z_6 - left_ankle_cross_I11 * alpha_right_hip_fork_y;
  const Scalar M_righ_ankl_cros_z_9 =
      M_righ_ankl_cros_z_8 + Omega_right_foot_xy * M_righ_ankl_cros_z_7;
  const Scalar M_righ_ankl_cros_z_10 =
      M_righ_ankl_cros_z_9 - left_ankle_cross_h2 * neg_a_righ_ankl_cros_x;
  const Scalar M_righ_ankl_cros_z_11 =
      M_righ_ankl_cros_z_10 - left_ankle_cross_I8 * neg_Omega_right_thigh_yz;
  const Scalar M_righ_ankl_cros_z = M_righ_ankl_cros_z_11 + left_ankle_cross_I7 * t_right_shank_1;
  B[16] = M_righ_ankl_cros_z;
  const Scalar F_righ_ankl_cros_y = neg_F_right_foot_z + left_ankle_cross_h2 * t_righ_ankl_cros_5;
  const Scalar neg_F_righ_ankl_cros_x =
      neg_F_right_foot_x + left_ankle_cross_h2 * Omega_right_thigh_xy;
  const Scalar t_right_shank_15 = left_shank_I10 * c_right_ankle_pitch;
  const Scalar t_right_shank_16 = left_shank_I3 * s_right_ankle_pitch + t_right_shank_15;
  const Scalar M_right_shank_z_1 = M_righ_ankl_cros_z - neg_s_righ_ankl_cros_x * F_righ_ankl_cros_y;
  const Scalar M_right_shank_z_2 = M_right_shank_z_1 + s_righ_ankl_cros_y * neg_F_righ_ankl_cros_x;
  // right_shank: moment M of (3)
  const Scalar M_right_shank_z_3 = M_right_shank_z_2 + t_right_shank_4 * neg_a_right_shank_x;
  const Scalar M_right_shank_z_4 = M_right_shank_z_3 - t_right_shank_13 * a_right_shank_y;
  const Scalar M_right_shank_z_5 = M_right_shank_z_4 - Omega_right_thigh_xy * t_right_shank_9;
  const Scalar M_right_shank_z_6 = M_right_shank_z_5 + t_right_shank_1 * t_right_shank_7;
  const Scalar M_right_shank_z_7 = M_right_shank_z_6 + Omega_right_foot_xy * t_right_shank_11;
  const Scalar M_right_shank_z_8 = M_right_shank_z_7 + neg_Omega_right_thigh_yz * t_right_shank_16;
  const Scalar M_right_shank_z = M_right_shank_z_8 - neg_Omega_right_thigh_yx * t_right_shank_14;
  B[15] = M_right_shank_z;
  // right_foot: force F of (3)
  const Scalar F_right_foot_y_1 = t_right_foot_5 * neg_Omega_right_foot_yy;
  const Scalar F_right_foot_y_2 = left_ankle_cross_m1 * a_right_foot_y + F_right_foot_y_1;
  const Scalar F_right_foot_y = F_right_foot_y_2 - t_righ_ankl_cros_1 * t_right_foot_4;
  const Scalar F_righ_ankl_cros_z = F_right_foot_y - left_ankle_cross_h2 * Omega_righ_ankl_cros_zy;
  const Scalar F_right_shank_z_1 = F_righ_ankl_cros_z + Omega_right_shank_zy * t_right_shank_4;
  const Scalar F_right_shank_z = F_right_shank_z_1 + neg_Omega_right_shank_zx * t_right_shank_13;
  const Scalar M_right_thigh_y_1 = t_right_thigh_9 - t_right_thigh_10;
  const Scalar M_right_thigh_y_2 = t_right_hip_fork_16 - neg_Omega_right_shank_xx;
  // right_thigh: moment M of (3)
  const Scalar M_right_thigh_y_3 = neg_M_right_foot_z + left_ankle_cross_I9 * t_righ_ankl_cros_1;
  const Scalar M_right_thigh_y_4 = M_right_thigh_y_3 + neg_s_right_shank_x * F_right_shank_z;
  const Scalar M_right_thigh_y_5 = M_right_thigh_y_4 - left_hip_fork_l3 * neg_F_right_foot_x;
  const Scalar M_right_thigh_y_6 = M_right_thigh_y_5 + Omega_right_thigh_zy * t_right_thigh_13;
  const Scalar M_right_thigh_y_7 = M_right_thigh_y_6 + a_right_shank_z * t_right_shank_13;
  const Scalar M_right_thigh_y_8 = left_ankle_cross_I7 - left_ankle_cross_I12 * c_right_ankle_pitch;
  const Scalar M_right_thigh_y_9 = M_right_thigh_y_7 + neg_Omega_right_shank_zx * t_right_shank_14;
  const Scalar M_right_thigh_y_10 = M_right_thigh_y_9 + Omega_righ_ankl_cros_zy * M_right_thigh_y_8;
  const Scalar M_right_thigh_y_11 = left_ankle_cross_I1 - t_right_thigh_14 + t_right_shank_11;
  const Scalar M_right_thigh_y_12 = M_right_thigh_y_10 + Omega_right_shank_zy * t_right_shank_7;
  const Scalar M_right_thigh_y_13 = M_right_thigh_y_12 - Omega_right_thigh_xy * M_right_thigh_y_11;
  const Scalar M_right_thigh_y_14 = M_right_thigh_y_13 - t_right_foot_2 * F_right_foot_y;
  const Scalar M_right_thigh_y_15 = M_right_thigh_y_14 + a_right_thigh_z * t_right_thigh_18;
  const Scalar M_right_thigh_y_16 = M_right_thigh_y_15 + left_ankle_cross_I8 * t_righ_ankl_cros_4;
  const Scalar M_right_thigh_y_17 =
      M_right_thigh_y_16 + neg_Omega_right_thigh_zx * t_right_thigh_16;
  const Scalar M_right_thigh_y_18 = M_right_thigh_y_17 - t_right_thigh_17 * M_right_thigh_y_1;
  const Scalar M_right_thigh_y = M_right_thigh_y_18 - t_right_shank_16 * M_right_thigh_y_2;
  const Scalar neg_F_right_shank_x_1 =
      neg_F_righ_ankl_cros_x - neg_Omega_right_shank_xx * t_right_shank_13;
  const Scalar neg_F_right_shank_x = neg_F_right_shank_x_1 - Omega_right_thigh_xy * t_right_shank_4;
  // right_shank: force F of (3)
  const Scalar F_right_shank_y_1 = F_righ_ankl_cros_y - neg_Omega_right_shank_yy * t_right_shank_4;
  const Scalar F_right_shank_y = F_right_shank_y_1 + neg_Omega_right_thigh_yx * t_right_shank_13;
  const Scalar M_right_thigh_z_1 = M_right_shank_z + s_right_shank_y * neg_F_right_shank_x;
  const Scalar M_right_thigh_z_2 = M_right_thigh_z_1 - neg_s_right_shank_x * F_right_shank_y;
  // right_thigh: moment M, force F of (3)
  const Scalar M_right_thigh_z_3 = M_right_thigh_z_2 + t_right_thigh_20 * neg_a_right_thigh_x;
  const Scalar M_right_thigh_z_4 = M_right_thigh_z_3 - t_right_thigh_18 * a_right_thigh_y;
  const Scalar M_right_thigh_z_5 = M_right_thigh_z_4 - Omega_right_foot_xy * t_right_thigh_14;
  const Scalar M_right_thigh_z_6 = M_right_thigh_z_5 - Omega_right_thigh_xy * t_right_thigh_19;
  const Scalar M_right_thigh_z_7 = M_right_thigh_z_6 + t_right_thigh_13 * t_right_shank_1;
  const Scalar M_right_thigh_z_8 = M_right_thigh_z_7 - neg_Omega_right_thigh_yx * t_right_thigh_16;
  const Scalar M_right_thigh_z = M_right_thigh_z_8 + neg_Omega_right_thigh_yz * t_right_thigh_17;
  B[14] = M_right_thigh_z;
  const Scalar M_right_thigh_x_1 = left_ankle_cross_I8 - t_right_thigh_17;
  const Scalar M_right_thigh_x_2 = t_right_shank_16 - M_right_thigh_x_1;
  const Scalar M_right_thigh_x_3 = t_right_thigh_11 - t_righ_ankl_cros_2;
  const Scalar M_right_thigh_x_4 = t_righ_ankl_cros_5 - neg_Omega_right_foot_yy;
  const Scalar M_right_thigh_x_5 = Omega_right_foot_zy * t_right_foot_11;
  const Scalar M_right_thigh_x_6 = t_right_hip_fork_16 - neg_Omega_right_shank_yy;
  const Scalar M_right_thigh_x_7 = M_right_thigh_x_5 - left_hip_fork_l3 * neg_F_right_foot_z;
  const Scalar M_right_thigh_x_8 = M_right_thigh_x_7 + t_right_shank_11 * M_right_thigh_x_6;
  const Scalar M_right_thigh_x_9 = left_ankle_cross_I7 + t_right_foot_9;
  const Scalar M_right_thigh_x_10 = M_right_thigh_x_8 + Omega_right_thigh_zy * t_right_thigh_19;
  const Scalar M_right_thigh_x_11 = M_right_thigh_x_10 + t_righ_ankl_cros_1 * M_right_thigh_x_9;
  const Scalar M_right_thigh_x_12 = t_right_hip_fork_16 - neg_Omega_right_thigh_yy;
  const Scalar M_right_thigh_x_13 = M_right_thigh_x_11 + neg_Omega_right_shank_zx * t_right_shank_7;
  const Scalar M_right_thigh_x_14 = M_right_thigh_x_13 - t_right_thigh_14 * M_right_thigh_x_12;
  const Scalar M_right_thigh_x_15 = M_right_thigh_x_14 + s_righ_ankl_cros_y * F_righ_ankl_cros_z;
  const Scalar M_right_thigh_x_16 = M_right_thigh_x_15 + a_right_thigh_z * t_right_thigh_20;
  const Scalar M_right_thigh_x_17 = M_right_thigh_x_16 - left_ankle_cross_h2 * a_righ_ankl_cros_z;
  const Scalar M_right_thigh_x_18 =
      M_right_thigh_x_17 + left_ankle_cross_I6 * Omega_righ_ankl_cros_zy;
  const Scalar M_right_thigh_x_19 =
      M_right_thigh_x_18 + neg_Omega_right_thigh_zx * t_right_thigh_13;
  const Scalar M_right_thigh_x_20 = M_right_thigh_x_19 + Omega_right_shank_zy * t_right_shank_9;
  const Scalar M_right_thigh_x_21 = M_right_thigh_x_20 + s_right_shank_y * F_right_shank_z;
  const Scalar M_right_thigh_x_22 = M_right_thigh_x_21 + left_ankle_cross_I1 * M_right_thigh_x_3;
  const Scalar M_right_thigh_x_23 =
      M_right_thigh_x_22 - neg_Omega_right_thigh_yx * M_right_thigh_x_2;
  const Scalar M_right_thigh_x_24 = M_right_thigh_x_23 + a_right_shank_z * t_right_shank_4;
  const Scalar M_right_thigh_x_25 = M_right_thigh_x_24 + Omega_right_foot_zx * t_right_foot_12;
  const Scalar M_right_thigh_x_26 = M_right_thigh_x_25 - t_right_foot_10 * M_right_thigh_x_4;
  const Scalar M_right_thigh_x = M_right_thigh_x_26 + neg_a_right_foot_z * t_right_foot_5;
  const Scalar F_right_thigh_y_1 = F_right_shank_y - neg_Omega_right_thigh_yy * t_right_thigh_20;
  const Scalar F_right_thigh_y = F_right_thigh_y_1 + neg_Omega_right_thigh_yx * t_right_thigh_18;
  const Scalar neg_F_right_thigh_x_1 =
      neg_F_right_shank_x - neg_Omega_right_thigh_xx * t_right_thigh_18;
  const Scalar neg_F_right_thigh_x =
      neg_F_right_thigh_x_1 - Omega_right_thigh_xy * t_right_thigh_20;
  const Scalar t_right_hip_fork_19 = t_right_hip_block_13 - t_right_hip_fork_16;
  const Scalar F_right_thigh_z_1 = F_right_shank_z + Omega_right_thigh_zy * t_right_thigh_20;
  const Scalar F_right_thigh_z = F_right_thigh_z_1 + neg_Omega_right_thigh_zx * t_right_thigh_18;
  const Scalar M_right_hip_fork_x_1 = s_q14_q15_q16 * M_right_thigh_y;
  const Scalar M_right_hip_fork_x_2 = M_right_hip_fork_x_1 - c_q14_q15_q16 * M_right_thigh_x;
  const Scalar M_right_hip_fork_x_3 = M_right_hip_fork_x_2 + left_hip_fork_l1 * F_right_thigh_z;
  // right_hip_fork: moment M, Omega of (3)
  const Scalar M_right_hip_fork_x_4 =
      M_right_hip_fork_x_3 + left_hip_fork_I11 * t_right_hip_fork_13;
  const Scalar M_right_hip_fork_x_5 = M_right_hip_fork_x_4 - left_hip_fork_I8 * t_right_hip_fork_5;
  const Scalar M_right_hip_fork_x_6 = M_right_hip_fork_x_5 - left_hip_fork_h3 * a_right_hip_fork_z;
  const Scalar M_right_hip_fork_x_7 = M_right_hip_fork_x_6 - left_hip_fork_I9 * t_right_hip_fork_19;
  const Scalar M_right_hip_fork_x =
      M_right_hip_fork_x_7 + left_hip_fork_I12 * Omega_right_hip_fork_zy;
  const Scalar t_right_hip_fork_20 = t_right_hip_fork_14 - t_right_hip_fork_15;
  const Scalar t_right_thigh_21 = c_q14_q15_q16 * M_right_thigh_y;
  const Scalar t_right_thigh_22 = t_right_thigh_21 + s_q14_q15_q16 * M_right_thigh_x;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_19 - t_right_hip_fork_20;
  // right_thigh: moment M of (3)
  const Scalar t_right_thigh_23 = t_right_thigh_22 + left_hip_fork_I12 * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_24 = t_right_thigh_23 - left_hip_fork_I8 * t_right_hip_fork_21;
  const Scalar t_right_thigh_25 = t_right_thigh_24 - left_hip_fork_h3 * a_right_hip_fork_x;
  const Scalar t_right_thigh_26 = t_right_thigh_25 + left_hip_fork_h2 * neg_a_right_hip_fork_y;
  const Scalar t_right_thigh_27 = t_right_thigh_26 + left_hip_fork_I11 * t_right_hip_fork_7;
  const Scalar t_right_thigh_28 = t_right_thigh_27 + left_hip_fork_I10 * t_right_hip_fork_13;
  const Scalar neg_M_right_hip_fork_z =
      t_right_thigh_28 + left_hip_fork_I9 * Omega_right_hip_fork_xz;
  B[13] = -neg_M_right_hip_fork_z;
  const Scalar t_right_thigh_29 = c_q14_q15_q16 * neg_F_right_thigh_x;
  const Scalar t_right_thigh_30 = t_right_thigh_29 + s_q14_q15_q16 * F_right_thigh_y;
  const Scalar t_right_thigh_31 = M_right_thigh_z + left_hip_fork_I8 * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_32 = t_right_thigh_31 - left_hip_fork_l1 * t_right_thigh_30;
  const Scalar t_right_thigh_33 = t_right_thigh_32 + left_hip_fork_h2 * a_right_hip_fork_z;
  const Scalar t_right_thigh_34 = t_right_thigh_33 - left_hip_fork_I11 * t_right_hip_fork_20;
  const Scalar t_right_thigh_35 = t_right_thigh_34 - left_hip_fork_I9 * Omega_right_hip_fork_xy;
  const Scalar neg_M_right_hip_fork_y = t_right_thigh_35 - left_hip_fork_I10 * t_right_hip_fork_5;
  // right_hip_fork: Omega, force F of (3)
  const Scalar F_right_hip_fork_x_1 = t_right_hip_block_13 - t_right_hip_fork_20;
  const Scalar F_right_hip_fork_x_2 = t_right_thigh_30 - left_hip_fork_h2 * F_right_hip_fork_x_1;
  const Scalar F_right_hip_fork_x =
      F_right_hip_fork_x_2 - left_hip_fork_h3 * Omega_right_hip_fork_xy;
  const Scalar F_right_hip_fork_z_1 = s_q14_q15_q16 * neg_F_right_thigh_x;
  const Scalar F_right_hip_fork_z_2 = F_right_hip_fork_z_1 - c_q14_q15_q16 * F_right_thigh_y;
  const Scalar F_right_hip_fork_z_3 =
      F_right_hip_fork_z_2 - left_hip_fork_h3 * Omega_right_hip_fork_zy;
  const Scalar F_right_hip_fork_z = F_right_hip_fork_z_3 - left_hip_fork_h2 * t_right_hip_fork_5;
  // right_hip_block: Omega of (3)
  const Scalar t_right_hip_block_16 = t_right_hip_block_9 - t_right_hip_block_10;
  const Scalar t_right_hip_block_17 = neg_Omega_base_rx_yy - t_right_hip_block_13;
  const Scalar t_right_hip_block_18 = left_hip_block_I9 * Omega_right_hip_block_xz;
  const Scalar t_right_hip_fork_22 =
      left_hip_block_h3 * neg_a_right_hip_block_x - t_right_hip_block_18;
  const Scalar t_right_hip_fork_23 = t_right_hip_fork_22 - c_right_hip_roll * M_right_hip_fork_x;
  const Scalar t_right_hip_block_19 = t_right_hip_block_16 - t_right_hip_block_17;
  // right_hip_fork: moment M, force F of (3)
  const Scalar t_right_hip_fork_24 =
      t_right_hip_fork_23 - s_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar t_right_hip_fork_25 = t_right_hip_fork_24 + left_hip_block_I8 * t_right_hip_block_19;
  const Scalar t_right_hip_fork_26 =
      t_right_hip_fork_25 - left_hip_block_h1 * neg_a_right_hip_block_y;
  const Scalar t_right_hip_fork_27 =
      t_right_hip_fork_26 - left_hip_block_I12 * t_right_hip_block_12;
  const Scalar t_right_hip_fork_28 =
      t_right_hip_fork_27 + left_hip_block_I11 * Omega_right_hip_block_yz;
  const Scalar neg_M_right_hip_block_z =
      t_right_hip_fork_28 - left_hip_block_I10 * Omega_right_hip_block_yx;
  B[12] = -neg_M_right_hip_block_z;
  const Scalar t_right_thigh_36 = F_right_thigh_z + left_hip_fork_h2 * t_right_hip_fork_13;
  const Scalar neg_F_right_hip_fork_y = t_right_thigh_36 - left_hip_fork_h3 * t_right_hip_fork_16;
  const Scalar t_right_hip_fork_29 = c_right_hip_roll * neg_F_right_hip_fork_y;
  const Scalar t_right_hip_fork_30 = s_right_hip_roll * F_right_hip_fork_x - t_right_hip_fork_29;
  const Scalar t_right_hip_block_20 = neg_Omega_base_rx_yy - t_right_hip_block_16;
  const Scalar t_right_hip_fork_31 = t_right_hip_fork_30 - left_hip_block_h3 * t_right_hip_block_12;
  const Scalar neg_F_right_hip_block_x =
      t_right_hip_fork_31 - left_hip_block_h1 * t_right_hip_block_20;
  const Scalar t_right_hip_fork_32 = F_right_hip_fork_z - left_hip_block_h3 * t_right_hip_block_13;
  const Scalar neg_F_right_hip_block_y =
      t_right_hip_fork_32 + left_hip_block_h1 * Omega_right_hip_block_yx;
  // left_ankle_cross: moment M of (3)
  const Scalar t_left_ankle_cross_7 = left_ankle_cross_I11 * alpha_left_thigh_z;
  const Scalar t_left_ankle_cross_8 = left_ankle_cross_I7 * t_left_shank_1 + t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_9 =
      t_left_ankle_cross_8 + left_ankle_cross_h2 * a_left_ankle_cross_x;
  const Scalar t_left_foot_12 = t_left_thigh_6 - t_left_foot_2;
  const Scalar t_left_ankle_cross_10 = left_ankle_cross_I1 - t_left_foot_9;
  const Scalar t_left_ankle_cross_11 = t_left_ankle_cross_9 + t_left_foot_8 * t_left_foot_12;
  const Scalar t_left_ankle_cross_12 =
      t_left_ankle_cross_11 + neg_Omega_left_thigh_xz * t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_13 = t_left_ankle_cross_12 + neg_a_left_foot_z * t_left_foot_3;
  const Scalar t_left_ankle_cross_14 =
      t_left_ankle_cross_13 + left_ankle_cross_I10 * t_left_thigh_5;
  const Scalar t_left_ankle_cross_15 =
      t_left_ankle_cross_14 - neg_Omega_left_foot_zy * t_left_foot_11;
  const Scalar t_left_ankle_cross_16 =
      t_left_ankle_cross_15 - left_ankle_cross_I8 * Omega_left_thigh_yz;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_16 + left_hip_fork_l1 * neg_F_left_foot_z;
  const Scalar M_left_ankle_cross_z =
      t_left_ankle_cross_17 + neg_Omega_left_foot_zx * t_left_foot_7;
  B[10] = M_left_ankle_cross_z;
  // left_foot: Omega, force F of (3)
  const Scalar neg_Omega_left_foot_yy = t_left_thigh_6 + t_left_foot_2;
  const Scalar neg_F_left_foot_y_1 = t_left_foot_4 * neg_Omega_left_foot_yy;
  const Scalar neg_F_left_foot_y_2 = left_ankle_cross_m1 * neg_a_left_foot_y + neg_F_left_foot_y_1;
  const Scalar neg_F_left_foot_y = neg_F_left_foot_y_2 - t_left_ankle_cross_1 * t_left_foot_3;
  const Scalar neg_F_left_ankle_cross_z =
      neg_F_left_foot_y - left_ankle_cross_h2 * Omega_left_foot_yz;
  const Scalar F_left_ankle_cross_x = F_left_foot_x + left_ankle_cross_h2 * Omega_left_foot_xz;
  const Scalar F_left_ankle_cross_y =
      neg_F_left_foot_z + left_ankle_cross_h2 * t_left_ankle_cross_3;
  // left_shank: moment M of (3)
  const Scalar M_left_shank_z_1 = M_left_ankle_cross_z + Omega_left_thigh_yz * t_left_shank_13;
  const Scalar M_left_shank_z_2 = M_left_shank_z_1 + Omega_left_foot_xz * t_left_shank_16;
  const Scalar M_left_shank_z_3 = M_left_shank_z_2 - s_left_ankle_cross_y * F_left_ankle_cross_x;
  const Scalar M_left_shank_z_4 = M_left_shank_z_3 + Omega_left_thigh_yx * t_left_shank_11;
  const Scalar M_left_shank_z_5 = M_left_shank_z_4 - neg_Omega_left_thigh_xz * t_left_shank_9;
  const Scalar M_left_shank_z_6 = M_left_shank_z_5 - t_left_shank_4 * a_left_shank_y;
  const Scalar M_left_shank_z_7 = M_left_shank_z_6 + t_left_shank_15 * a_left_shank_x;
  const Scalar M_left_shank_z_8 = M_left_shank_z_7 + t_left_shank_1 * t_left_shank_7;
  const Scalar M_left_shank_z = M_left_shank_z_8 - neg_s_left_ankle_cross_x * F_left_ankle_cross_y;
  B[9] = M_left_shank_z;
  const Scalar neg_F_left_shank_z_1 =
      neg_F_left_ankle_cross_z + Omega_left_shank_zx * t_left_shank_4;
  const Scalar neg_F_left_shank_z =
      neg_F_left_shank_z_1 - neg_Omega_left_shank_zy * t_left_shank_15;
  const Scalar neg_M_left_thigh_y_2 = left_ankle_cross_I1 + t_left_thigh_11;
  const Scalar neg_M_left_thigh_y_3 = t_left_thigh_6 - t_left_thigh_7;
  const Scalar neg_M_left_thigh_y_4 = M_left_foot_z + neg_a_left_thigh_z * t_left_thigh_15;
  const Scalar neg_M_left_thigh_y_5 = neg_M_left_thigh_y_4 + left_hip_fork_l3 * F_left_foot_x;
  const Scalar neg_M_left_thigh_y_6 = t_left_shank_9 - neg_M_left_thigh_y_2;
  const Scalar neg_M_left_thigh_y_7 = neg_M_left_thigh_y_5 - left_hip_fork_l1 * neg_F_left_foot_y;
  const Scalar neg_M_left_thigh_y_8 =
      neg_M_left_thigh_y_7 - Omega_left_foot_xz * neg_M_left_thigh_y_6;
  const Scalar neg_M_left_thigh_y_9 =
      neg_M_left_thigh_y_8 + neg_Omega_left_shank_zy * t_left_shank_7;
  const Scalar neg_M_left_thigh_y_10 =
      neg_M_left_thigh_y_9 - neg_M_left_thigh_y_1 * t_left_shank_13;
  const Scalar neg_M_left_thigh_y_11 = neg_M_left_thigh_y_10 + neg_a_left_shank_z * t_left_shank_4;
  const Scalar neg_M_left_thigh_y_12 =
      neg_M_left_thigh_y_11 + neg_s_left_shank_x * neg_F_left_shank_z;
  const Scalar neg_M_left_thigh_y_13 =
      neg_M_left_thigh_y_12 + left_ankle_cross_I7 * Omega_left_foot_yz;
  const Scalar neg_M_left_thigh_y_14 =
      neg_M_left_thigh_y_13 + left_ankle_cross_I8 * t_left_ankle_cross_5;
  const Scalar neg_M_left_thigh_y_15 =
      neg_M_left_thigh_y_14 + neg_s_left_ankle_cross_x * neg_F_left_ankle_cross_z;
  const Scalar neg_M_left_thigh_y_16 =
      neg_M_left_thigh_y_15 + left_ankle_cross_I9 * t_left_ankle_cross_1;
  const Scalar neg_M_left_thigh_y_17 =
      neg_M_left_thigh_y_16 + Omega_left_shank_zx * t_left_shank_11;
  const Scalar neg_M_left_thigh_y_18 =
      neg_M_left_thigh_y_17 + Omega_left_thigh_zx * t_left_thigh_13;
  const Scalar neg_M_left_thigh_y_19 =
      neg_M_left_thigh_y_18 + neg_Omega_left_thigh_zy * t_left_thigh_10;
  const Scalar neg_M_left_thigh_y = neg_M_left_thigh_y_19 - t_left_thigh_14 * neg_M_left_thigh_y_3;
  const Scalar M_left_thigh_x_1 = t_left_ankle_cross_3 - neg_Omega_left_foot_yy;
  const Scalar M_left_thigh_x_2 = left_ankle_cross_I7 + t_left_foot_8;
  const Scalar M_left_thigh_x_3 = t_left_shank_13 - (left_ankle_cross_I8 - t_left_thigh_14);
  const Scalar M_left_thigh_x_4 = left_ankle_cross_h2 * neg_a_left_ankle_cross_z;
  const Scalar M_left_thigh_x_5 = M_left_thigh_x_4 + neg_a_left_thigh_z * t_left_thigh_17;
  const Scalar M_left_thigh_x_6 = t_left_thigh_7 - t_left_thigh_8;
  const Scalar M_left_thigh_x_7 = t_left_hip_fork_20 - neg_Omega_left_shank_yy;
  // left_thigh: moment M of (3)
  const Scalar M_left_thigh_x_8 = M_left_thigh_x_5 + t_left_thigh_11 * M_left_thigh_x_6;
  const Scalar M_left_thigh_x_9 = M_left_thigh_x_8 + t_left_shank_9 * M_left_thigh_x_7;
  const Scalar M_left_thigh_x_10 = M_left_thigh_x_9 - Omega_left_shank_zx * t_left_shank_7;
  const Scalar M_left_thigh_x_11 = M_left_thigh_x_10 - neg_Omega_left_foot_zy * t_left_foot_10;
  const Scalar M_left_thigh_x_12 = M_left_thigh_x_11 - s_left_shank_y * neg_F_left_shank_z;
  const Scalar M_left_thigh_x_13 =
      M_left_thigh_x_12 - s_left_ankle_cross_y * neg_F_left_ankle_cross_z;
  const Scalar M_left_thigh_x_14 = M_left_thigh_x_13 - neg_a_left_foot_z * t_left_foot_4;
  const Scalar M_left_thigh_x_15 = t_left_thigh_8 - t_left_ankle_cross_2;
  const Scalar M_left_thigh_x_16 = M_left_thigh_x_14 - left_ankle_cross_I6 * Omega_left_foot_yz;
  const Scalar M_left_thigh_x_17 = M_left_thigh_x_16 - left_ankle_cross_I1 * M_left_thigh_x_15;
  const Scalar M_left_thigh_x_18 = M_left_thigh_x_17 - t_left_foot_9 * M_left_thigh_x_1;
  const Scalar M_left_thigh_x_19 = M_left_thigh_x_18 - neg_Omega_left_shank_zy * t_left_shank_16;
  const Scalar M_left_thigh_x_20 = M_left_thigh_x_19 - t_left_ankle_cross_1 * M_left_thigh_x_2;
  const Scalar M_left_thigh_x_21 = M_left_thigh_x_20 - Omega_left_thigh_zx * t_left_thigh_10;
  const Scalar M_left_thigh_x_22 = M_left_thigh_x_21 + left_hip_fork_l3 * neg_F_left_foot_z;
  const Scalar M_left_thigh_x_23 = M_left_thigh_x_22 + neg_a_left_shank_z * t_left_shank_15;
  const Scalar M_left_thigh_x_24 = M_left_thigh_x_23 - Omega_left_thigh_yx * M_left_thigh_x_3;
  const Scalar M_left_thigh_x_25 = M_left_thigh_x_24 + neg_Omega_left_foot_zx * t_left_foot_11;
  const Scalar M_left_thigh_x = M_left_thigh_x_25 - neg_Omega_left_thigh_zy * t_left_thigh_16;
  // left_shank: force F of (3)
  const Scalar F_left_shank_x_1 = F_left_ankle_cross_x + neg_Omega_left_shank_xx * t_left_shank_4;
  const Scalar F_left_shank_x = F_left_shank_x_1 + Omega_left_foot_xz * t_left_shank_15;
  const Scalar F_left_shank_y_1 = F_left_ankle_cross_y - Omega_left_thigh_yx * t_left_shank_4;
  const Scalar F_left_shank_y = F_left_shank_y_1 + neg_Omega_left_shank_yy * t_left_shank_15;
  // left_thigh: moment M, force F of (3)
  const Scalar M_left_thigh_z_1 = M_left_shank_z + Omega_left_thigh_yz * t_left_thigh_14;
  const Scalar M_left_thigh_z_2 = M_left_thigh_z_1 + Omega_left_thigh_yx * t_left_thigh_13;
  const Scalar M_left_thigh_z_3 = M_left_thigh_z_2 + neg_Omega_left_thigh_xz * t_left_thigh_11;
  const Scalar M_left_thigh_z_4 = M_left_thigh_z_3 + Omega_left_foot_xz * t_left_thigh_16;
  const Scalar M_left_thigh_z_5 = M_left_thigh_z_4 - neg_s_left_shank_x * F_left_shank_y;
  const Scalar M_left_thigh_z_6 = M_left_thigh_z_5 - s_left_shank_y * F_left_shank_x;
  const Scalar M_left_thigh_z_7 = M_left_thigh_z_6 - t_left_thigh_15 * a_left_thigh_y;
  const Scalar M_left_thigh_z_8 = M_left_thigh_z_7 + t_left_thigh_10 * t_left_shank_1;
  const Scalar M_left_thigh_z = M_left_thigh_z_8 + t_left_thigh_17 * a_left_thigh_x;
  B[8] = M_left_thigh_z;
  const Scalar F_left_thigh_y_1 = F_left_shank_y - Omega_left_thigh_yx * t_left_thigh_15;
  const Scalar F_left_thigh_y = F_left_thigh_y_1 + neg_Omega_left_thigh_yy * t_left_thigh_17;
  const Scalar F_left_thigh_x_1 = F_left_shank_x + t_left_thigh_15 * neg_Omega_left_thigh_xx;
  const Scalar F_left_thigh_x = F_left_thigh_x_1 + Omega_left_foot_xz * t_left_thigh_17;
  const Scalar t_left_hip_fork_22 = t_left_hip_block_12 - t_left_hip_fork_19;
  const Scalar M_left_hip_fork_z_1 = c_q8_q9_q10 * neg_M_left_thigh_y;
  const Scalar M_left_hip_fork_z_2 = M_left_hip_fork_z_1 - s_q8_q9_q10 * M_left_thigh_x;
  // left_hip_fork: moment M, force F of (3)
  const Scalar M_left_hip_fork_z_3 = t_left_hip_fork_20 - t_left_hip_fork_22;
  const Scalar M_left_hip_fork_z_4 = M_left_hip_fork_z_2 + left_hip_fork_h2 * a_left_hip_fork_y;
  const Scalar M_left_hip_fork_z_5 = M_left_hip_fork_z_4 + left_hip_fork_I8 * M_left_hip_fork_z_3;
  const Scalar M_left_hip_fork_z_6 = M_left_hip_fork_z_5 - left_hip_fork_I9 * t_left_hip_fork_8;
  const Scalar M_left_hip_fork_z_7 = M_left_hip_fork_z_6 + left_hip_fork_h3 * neg_a_left_hip_fork_x;
  const Scalar M_left_hip_fork_z_8 =
      M_left_hip_fork_z_7 + left_hip_fork_I10 * Omega_left_hip_fork_yx;
  const Scalar M_left_hip_fork_z_9 = M_left_hip_fork_z_8 + left_hip_fork_I12 * t_left_hip_fork_16;
  const Scalar M_left_hip_fork_z = M_left_hip_fork_z_9 + left_hip_fork_I11 * Omega_left_hip_fork_yz;
  B[7] = M_left_hip_fork_z;
  const Scalar t_left_thigh_19 = c_q8_q9_q10 * F_left_thigh_x - s_q8_q9_q10 * F_left_thigh_y;
  const Scalar neg_F_left_thigh_z_1 = neg_F_left_shank_z + Omega_left_thigh_zx * t_left_thigh_15;
  const Scalar neg_F_left_thigh_z =
      neg_F_left_thigh_z_1 - neg_Omega_left_thigh_zy * t_left_thigh_17;
  const Scalar F_left_hip_fork_y_1 = neg_F_left_thigh_z + left_hip_fork_h2 * Omega_left_hip_fork_yx;
  const Scalar F_left_hip_fork_y = F_left_hip_fork_y_1 - left_hip_fork_h3 * t_left_hip_fork_20;
  const Scalar t_left_hip_fork_23 = left_hip_fork_h3 * t_left_hip_fork_6;
  // left_thigh: force F of (3)
  const Scalar t_left_thigh_20 = t_left_hip_fork_23 + s_q8_q9_q10 * F_left_thigh_x;
  const Scalar t_left_thigh_21 = t_left_thigh_20 - left_hip_fork_h2 * Omega_left_hip_fork_zx;
  const Scalar neg_F_left_hip_fork_z = t_left_thigh_21 + c_q8_q9_q10 * F_left_thigh_y;
  // left_hip_block: moment M, Omega of (3)
  const Scalar t_left_hip_block_17 = neg_Omega_base_rx_yy - t_left_hip_block_12;
  const Scalar t_left_hip_block_18 = t_left_hip_block_10 - t_left_hip_block_11;
  const Scalar t_left_hip_block_19 = t_left_hip_block_17 - t_left_hip_block_18;
  // left_thigh: moment M of (3)
  const Scalar t_left_thigh_22 = M_left_thigh_z - left_hip_fork_h2 * neg_a_left_hip_fork_z;
  const Scalar t_left_thigh_23 = t_left_thigh_22 - left_hip_fork_I11 * t_left_hip_fork_19;
  const Scalar t_left_thigh_24 = t_left_thigh_23 + left_hip_fork_l1 * t_left_thigh_19;
  const Scalar t_left_thigh_25 = t_left_thigh_24 + left_hip_fork_I8 * t_left_hip_fork_6;
  const Scalar t_left_thigh_26 = t_left_thigh_25 + left_hip_fork_I10 * Omega_left_hip_fork_zx;
  const Scalar neg_M_left_hip_fork_y = t_left_thigh_26 - left_hip_fork_I9 * t_left_hip_fork_16;
  const Scalar t_left_thigh_27 = s_q8_q9_q10 * neg_M_left_thigh_y + c_q8_q9_q10 * M_left_thigh_x;
  const Scalar t_left_thigh_28 = t_left_thigh_27 + left_hip_fork_h3 * neg_a_left_hip_fork_z;
  const Scalar t_left_thigh_29 = t_left_thigh_28 + left_hip_fork_I12 * t_left_hip_fork_6;
  const Scalar t_left_thigh_30 = t_left_thigh_29 + left_hip_fork_l1 * neg_F_left_thigh_z;
  const Scalar t_left_thigh_31 = t_left_thigh_30 + left_hip_fork_I8 * Omega_left_hip_fork_zx;
  const Scalar t_left_hip_fork_24 = t_left_hip_block_12 - t_left_hip_fork_20;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + left_hip_fork_I11 * Omega_left_hip_fork_yx;
  const Scalar neg_M_left_hip_fork_x = t_left_thigh_32 - left_hip_fork_I9 * t_left_hip_fork_24;
  const Scalar t_left_hip_block_20 = left_hip_block_I8 * t_left_hip_block_19;
  // left_hip_fork: moment M, force F of (3)
  const Scalar t_left_hip_fork_25 = t_left_hip_block_20 - left_hip_block_h3 * a_left_hip_block_x;
  const Scalar t_left_hip_fork_26 = t_left_hip_fork_25 + left_hip_block_I11 * t_left_hip_block_5;
  const Scalar t_left_hip_fork_27 = t_left_hip_fork_26 - s_left_hip_roll * neg_M_left_hip_fork_y;
  const Scalar t_left_hip_fork_28 =
      t_left_hip_fork_27 - left_hip_block_I9 * Omega_left_hip_block_xz;
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_28 + c_left_hip_roll * neg_M_left_hip_fork_x;
  const Scalar t_left_hip_fork_30 = t_left_hip_fork_29 - left_hip_block_h1 * a_left_hip_block_y;
  const Scalar t_left_hip_fork_31 =
      t_left_hip_fork_30 - left_hip_block_I10 * Omega_left_hip_block_yx;
  const Scalar neg_M_left_hip_block_z =
      t_left_hip_fork_31 - left_hip_block_I12 * t_left_hip_block_14;
  B[6] = -neg_M_left_hip_block_z;
  const Scalar t_left_thigh_33 = t_left_thigh_19 + left_hip_fork_h3 * t_left_hip_fork_16;
  const Scalar neg_F_left_hip_fork_x = t_left_thigh_33 + left_hip_fork_h2 * t_left_hip_fork_22;
  const Scalar t_left_hip_fork_32 = s_left_hip_roll * neg_F_left_hip_fork_x;
  const Scalar t_left_hip_fork_33 = c_left_hip_roll * F_left_hip_fork_y - t_left_hip_fork_32;
  const Scalar t_left_hip_block_21 = neg_Omega_base_rx_yy - t_left_hip_block_18;
  const Scalar t_left_hip_fork_34 = t_left_hip_fork_33 - left_hip_block_h3 * t_left_hip_block_14;
  const Scalar neg_F_left_hip_block_x =
      t_left_hip_fork_34 + left_hip_block_h1 * t_left_hip_block_21;
  const Scalar F_left_hip_block_y_1 =
      neg_F_left_hip_fork_z + left_hip_block_h3 * t_left_hip_block_12;
  const Scalar F_left_hip_block_y =
      F_left_hip_block_y_1 + left_hip_block_h1 * Omega_left_hip_block_yx;
  const Scalar t_base_rx_8 = neg_Omega_base_ry_yy - neg_Omega_base_rx_yy;
  // right_hip_block: moment M of (3)
  const Scalar M_right_hip_block_y_1 = t_left_hip_block_15 + neg_M_right_hip_fork_z;
  const Scalar M_right_hip_block_y_2 =
      M_right_hip_block_y_1 - left_hip_block_I10 * Omega_right_hip_block_zx;
  const Scalar M_right_hip_block_y_3 =
      M_right_hip_block_y_2 + left_hip_block_I8 * t_right_hip_block_5;
  const Scalar M_right_hip_block_y_4 =
      M_right_hip_block_y_3 - left_hip_block_l2 * t_right_hip_fork_30;
  const Scalar M_right_hip_block_y_5 =
      M_right_hip_block_y_4 - left_hip_block_I11 * t_right_hip_block_16;
  const Scalar M_right_hip_block_y =
      M_right_hip_block_y_5 + left_hip_block_I9 * t_right_hip_block_12;
  const Scalar M_base_rx_z_1 = t_base_rx_6 - t_base_rx_8;
  // right_hip_fork: moment M of (3)
  const Scalar t_right_hip_fork_33 =
      t_left_hip_block_16 - left_hip_block_I11 * Omega_right_hip_block_yx;
  const Scalar t_right_hip_fork_34 = t_right_hip_fork_33 - left_hip_block_l2 * F_right_hip_fork_z;
  const Scalar t_right_hip_fork_35 =
      t_right_hip_fork_34 - left_hip_block_I8 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_fork_36 = t_right_hip_fork_35 - left_hip_block_I9 * t_right_hip_block_17;
  const Scalar t_right_hip_fork_37 =
      t_right_hip_fork_36 - c_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar t_right_hip_fork_38 = t_right_hip_fork_37 + left_hip_block_I12 * t_right_hip_block_5;
  const Scalar neg_M_right_hip_block_x =
      t_right_hip_fork_38 + s_right_hip_roll * M_right_hip_fork_x;
  // left_hip_block: moment M, force F of (3)
  const Scalar M_left_hip_block_x_1 =
      t_left_hip_block_16 - left_hip_block_l2 * neg_F_left_hip_fork_z;
  const Scalar M_left_hip_block_x_2 =
      M_left_hip_block_x_1 + left_hip_block_I9 * t_left_hip_block_17;
  const Scalar M_left_hip_block_x_3 =
      M_left_hip_block_x_2 + left_hip_block_I12 * Omega_left_hip_block_zy;
  const Scalar M_left_hip_block_x_4 =
      M_left_hip_block_x_3 + c_left_hip_roll * neg_M_left_hip_fork_y;
  const Scalar M_left_hip_block_x_5 =
      M_left_hip_block_x_4 + s_left_hip_roll * neg_M_left_hip_fork_x;
  const Scalar M_left_hip_block_x_6 =
      M_left_hip_block_x_5 - left_hip_block_I11 * Omega_left_hip_block_yx;
  const Scalar M_left_hip_block_x =
      M_left_hip_block_x_6 - left_hip_block_I8 * Omega_left_hip_block_zx;
  const Scalar M_left_hip_block_y_1 = t_left_hip_block_15 - M_left_hip_fork_z;
  const Scalar M_left_hip_block_y_2 =
      M_left_hip_block_y_1 + left_hip_block_I8 * Omega_left_hip_block_zy;
  const Scalar M_left_hip_block_y_3 = M_left_hip_block_y_2 - left_hip_block_l2 * t_left_hip_fork_33;
  const Scalar M_left_hip_block_y_4 =
      M_left_hip_block_y_3 + left_hip_block_I11 * t_left_hip_block_18;
  const Scalar M_left_hip_block_y_5 =
      M_left_hip_block_y_4 + left_hip_block_I9 * t_left_hip_block_14;
  const Scalar M_left_hip_block_y =
      M_left_hip_block_y_5 - left_hip_block_I10 * Omega_left_hip_block_zx;
  const Scalar F_left_hip_block_z_1 = left_hip_block_h1 * Omega_left_hip_block_zx;
  const Scalar F_left_hip_block_z_2 =
      F_left_hip_block_z_1 - left_hip_block_h3 * Omega_left_hip_block_zy;
  const Scalar F_left_hip_block_z_3 = F_left_hip_block_z_2 - s_left_hip_roll * F_left_hip_fork_y;
  const Scalar F_left_hip_block_z = F_left_hip_block_z_3 - c_left_hip_roll * neg_F_left_hip_fork_x;
  const Scalar t_right_hip_block_21 = left_hip_block_h1 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_block_22 =
      t_right_hip_block_21 - left_hip_block_h3 * t_right_hip_block_5;
  const Scalar t_right_hip_fork_39 = t_right_hip_block_22 - c_right_hip_roll * F_right_hip_fork_x;
  const Scalar neg_F_right_hip_block_z =
      t_right_hip_fork_39 - s_right_hip_roll * neg_F_right_hip_fork_y;
  const Scalar M_base_rx_z_2 = s_right_hip_yaw * neg_M_right_hip_block_x;
  // base_rx: moment M of (3)
  const Scalar M_base_rx_z_3 = base_rx_I6 * neg_Omega_base_rx_yz + M_base_rx_z_2;
  const Scalar M_base_rx_z_4 = M_base_rx_z_3 - s_left_hip_yaw * M_left_hip_block_x;
  const Scalar M_base_rx_z_5 = M_base_rx_z_4 + base_rx_I5 * Omega_base_rx_xz;
  const Scalar M_base_rx_z_6 = M_base_rx_z_5 - c_right_hip_yaw * M_right_hip_block_y;
  const Scalar M_base_rx_z_7 = M_base_rx_z_6 - base_rx_I10 * Omega_base_rx_xy;
  const Scalar M_base_rx_z_8 = M_base_rx_z_7 - base_rx_I7 * neg_Omega_base_rx_yx;
  const Scalar M_base_rx_z_9 = M_base_rx_z_8 - c_left_hip_yaw * M_left_hip_block_y;
  const Scalar M_base_rx_z_10 = F_left_hip_block_z + neg_F_right_hip_block_z;
  const Scalar M_base_rx_z_11 = M_base_rx_z_9 - base_rx_I4 * M_base_rx_z_1;
  const Scalar M_base_rx_z = M_base_rx_z_11 + left_hip_block_l1 * M_base_rx_z_10;
  B[5] = M_base_rx_z;
  // right_hip_block
  const Scalar M_base_rx_x_1 = s_right_hip_yaw * M_right_hip_block_y;
  const Scalar M_base_rx_x_2 = M_base_rx_x_1 + base_rx_I5 * t_base_rx_8;
  const Scalar M_base_rx_x_3 = M_base_rx_x_2 + base_rx_I4 * Omega_base_rx_zx;
  const Scalar M_base_rx_x_4 = M_base_rx_x_3 + base_rx_I10 * Omega_base_rx_zy;
  const Scalar M_base_rx_x_5 = M_base_rx_x_4 - base_rx_I6 * neg_Omega_base_rx_yx;
  const Scalar M_base_rx_x_6 = M_base_rx_x_5 + c_right_hip_yaw * neg_M_right_hip_block_x;
  const Scalar M_base_rx_x_7 = M_base_rx_x_6 - c_left_hip_yaw * M_left_hip_block_x;
  const Scalar M_base_rx_x = M_base_rx_x_7 + s_left_hip_yaw * M_left_hip_block_y;
  // left_hip_block: force F of (3)
  const Scalar neg_F_base_rx_y_1 = F_left_hip_block_z - neg_F_right_hip_block_z;
  const Scalar neg_F_base_rx_y_2 = neg_F_base_rx_y_1 - base_rx_h1 * neg_Omega_base_rx_yx;
  const Scalar neg_F_base_rx_y = neg_F_base_rx_y_2 - base_rx_h4 * neg_Omega_base_rx_yy;
  const Scalar t_right_hip_block_23 = s_right_hip_yaw * neg_F_right_hip_block_x;
  const Scalar t_right_hip_block_24 =
      t_right_hip_block_23 + c_right_hip_yaw * neg_F_right_hip_block_y;
  const Scalar t_left_hip_block_22 = s_left_hip_yaw * neg_F_left_hip_block_x;
  const Scalar t_left_hip_block_23 = c_left_hip_yaw * F_left_hip_block_y - t_left_hip_block_22;
  // base_rx: moment M of (3)
  const Scalar M_base_rx_y_1 = neg_M_right_hip_block_z + neg_M_left_hip_block_z;
  const Scalar M_base_rx_y_2 = M_base_rx_y_1 - base_rx_I7 * Omega_base_rx_zx;
  const Scalar M_base_rx_y_3 = M_base_rx_y_2 - base_rx_I5 * Omega_base_rx_xy;
  const Scalar M_base_rx_y_4 = M_base_rx_y_3 - base_rx_I6 * t_base_rx_6;
  const Scalar M_base_rx_y_5 = t_right_hip_block_24 + t_left_hip_block_23;
  const Scalar M_base_rx_y_6 = M_base_rx_y_4 - base_rx_I4 * Omega_base_rx_zy;
  const Scalar M_base_rx_y = M_base_rx_y_6 - left_hip_block_l1 * M_base_rx_y_5;
  B[4] = base_rx_I9 * neg_Omega_base_ry_xy + s_base_rx * M_base_rx_y - c_base_rx * M_base_rx_x;
  // left_hip_block: force F of (3)
  const Scalar neg_F_base_rx_x_1 = s_left_hip_yaw * F_left_hip_block_y;
  const Scalar neg_F_base_rx_x_2 = base_rx_h1 * Omega_base_rx_xx - neg_F_base_rx_x_1;
  const Scalar neg_F_base_rx_x_3 = neg_F_base_rx_x_2 - c_right_hip_yaw * neg_F_right_hip_block_x;
  const Scalar neg_F_base_rx_x_4 = neg_F_base_rx_x_3 + base_rx_h4 * Omega_base_rx_xy;
  const Scalar neg_F_base_rx_x_5 = neg_F_base_rx_x_4 + s_right_hip_yaw * neg_F_right_hip_block_y;
  const Scalar neg_F_base_rx_x = neg_F_base_rx_x_5 - c_left_hip_yaw * neg_F_left_hip_block_x;
  const Scalar M_base_ry_x_1 = base_rx_I8 * alpha_base_ry_x + s_base_rx * M_base_rx_x;
  const Scalar M_base_ry_x = M_base_ry_x_1 + c_base_rx * M_base_rx_y;
  B[3] = -(s_base_ry * M_base_rx_z + c_base_ry * M_base_ry_x);
  // base_rx: force F of (3)
  const Scalar neg_F_base_ry_y_1 = t_right_hip_block_24 - t_left_hip_block_23;
  const Scalar neg_F_base_ry_y_2 = neg_F_base_ry_y_1 - base_rx_h3 * neg_Omega_base_ry_yy;
  const Scalar neg_F_base_ry_y_3 = neg_F_base_ry_y_2 - base_rx_h1 * Omega_base_rx_zx;
  const Scalar neg_F_base_ry_y = neg_F_base_ry_y_3 - base_rx_h4 * Omega_base_rx_zy;
  const Scalar F_base_ry_x_1 = base_rx_h3 * neg_Omega_base_ry_xy - c_base_rx * neg_F_base_rx_y;
  const Scalar F_base_ry_x = F_base_ry_x_1 - s_base_rx * neg_F_base_rx_x;
  B[2] = -(s_base_ry * neg_F_base_ry_y + c_base_ry * F_base_ry_x);
  const Scalar neg_F_base_rz_x = c_base_ry * neg_F_base_ry_y - s_base_ry * F_base_ry_x;
  const Scalar F_base_rz_y_1 = base_rx_h5 * alpha_base_ry_x + s_base_rx * neg_F_base_rx_y;
  const Scalar F_base_rz_y = F_base_rz_y_1 - c_base_rx * neg_F_base_rx_x;
  // base_pz: force F of (3)
  B[0] = s_base_rz * F_base_rz_y + c_base_rz * neg_F_base_rz_x;
  B[1] = s_base_rz * neg_F_base_rz_x - c_base_rz * F_base_rz_y;
}

void gravity_force(const Scalar q[18], Scalar G[18]) noexcept {
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const Scalar q_q14_q15 = q[14] + q[15];
  const Scalar q_q14_q15_q16 = q_q14_q15 + q[16];
  const Scalar angle_right_foot = left_foot_k1 - q[17];
  const Scalar angle_left_foot = left_foot_k1 + q[11];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[4], q[5], q[6], q[7]);
  sines_cosines(sines + 4, cosines + 4, q[8], q_q8_q9, q_q8_q9_q10, q[12]);
  sines_cosines(sines + 8, cosines + 8, q[13], q[14], q_q14_q15, q_q14_q15_q16);
  sines_cosines(sines + 12, cosines + 12, angle_right_foot, angle_left_foot);
  const Scalar s_base_ry = sines[0];
  const Scalar c_base_ry = cosines[0];
  const Scalar s_base_rx = sines[1];
  const Scalar c_base_rx = cosines[1];
  const Scalar s_left_hip_yaw = sines[2];
  const Scalar c_left_hip_yaw = cosines[2];
  const Scalar s_left_hip_roll = sines[3];
  const Scalar c_left_hip_roll = cosines[3];
  const Scalar s_left_hip_pitch = sines[4];
  const Scalar c_left_hip_pitch = cosines[4];
  const Scalar s_q8_q9 = sines[5];
  const Scalar c_q8_q9 = cosines[5];
  const Scalar s_q8_q9_q10 = sines[6];
  const Scalar c_q8_q9_q10 = cosines[6];
  const Scalar s_right_hip_yaw = sines[7];
  const Scalar c_right_hip_yaw = cosines[7];
  const Scalar s_right_hip_roll = sines[8];
  const Scalar c_right_hip_roll = cosines[8];
  const Scalar s_right_hip_pitch = sines[9];
  const Scalar c_right_hip_pitch = cosines[9];
  const Scalar s_q14_q15 = sines[10];
  const Scalar c_q14_q15 = cosines[10];
  const Scalar s_q14_q15_q16 = sines[11];
  const Scalar c_q14_q15_q16 = cosines[11];
  const Scalar s_right_foot = sines[12];
  const Scalar c_right_foot = cosines[12];
  const Scalar s_left_foot = sines[13];
  const Scalar c_left_foot = cosines[13];
  // right_foot: first moment h, G of 6.5
  const Scalar h_right_foot_x = left_foot_h1 * c_right_foot;
  const Scalar neg_h_right_foot_y = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_1 = base_g1 * c_base_ry;
  const Scalar t_right_foot_2 = s_base_rx * t_right_foot_1;
  const Scalar t_right_foot_3 = base_g1 * s_base_ry;
  const Scalar t_right_foot_4 = c_right_hip_yaw * t_right_foot_2;
  const Scalar t_right_foot_5 = t_right_foot_4 + s_right_hip_yaw * t_right_foot_3;
  const Scalar t_right_foot_6 = c_base_rx * t_right_foot_1;
  const Scalar t_right_foot_7 = c_right_hip_roll * t_right_foot_6;
  const Scalar t_right_foot_8 = t_right_foot_7 - s_right_hip_roll * t_right_foot_5;
  const Scalar t_right_foot_9 = s_right_hip_yaw * t_right_foot_2;
  const Scalar t_right_foot_10 = t_right_foot_9 - c_right_hip_yaw * t_right_foot_3;
  const Scalar t_right_foot_11 = s_right_hip_roll * t_right_foot_6;
  const Scalar t_right_foot_12 = t_right_foot_11 + c_right_hip_roll * t_right_foot_5;
  const Scalar G_17_1 = c_q14_q15_q16 * t_right_foot_8 + s_q14_q15_q16 * t_right_foot_10;
  G[17] = neg_h_right_foot_y * G_17_1 - h_right_foot_x * t_right_foot_12;
  const Scalar t_right_foot_13 = left_ankle_cross_h1 + h_right_foot_x;
  const Scalar t_right_foot_14 = left_ankle_cross_h2 * s_q14_q15_q16;
  const Scalar neg_h_righ_ankl_cros_x = t_right_foot_14 + c_q14_q15_q16 * t_right_foot_13;
  const Scalar h_righ_ankl_cros_y_1 = left_ankle_cross_h2 * c_q14_q15_q16;
  // right_ankle_cross: first moment h, G of 6.5
  const Scalar h_righ_ankl_cros_y = h_righ_ankl_cros_y_1 - s_q14_q15_q16 * t_right_foot_13;
  G[16] = t_right_foot_8 * h_righ_ankl_cros_y + t_right_foot_10 * neg_h_righ_ankl_cros_x;
  const Scalar neg_h_right_shank_x_1 = neg_h_righ_ankl_cros_x - left_shank_h1 * c_q14_q15;
  const Scalar neg_h_right_shank_x = neg_h_right_shank_x_1 + left_shank_h2 * s_q14_q15;
  // right_shank: first moment h, G of 6.5
  const Scalar h_right_shank_y_1 = h_righ_ankl_cros_y + left_shank_h1 * s_q14_q15;
  const Scalar h_right_shank_y = h_right_shank_y_1 + left_shank_h2 * c_q14_q15;
  G[15] = t_right_foot_10 * neg_h_right_shank_x + t_right_foot_8 * h_right_shank_y;
  const Scalar neg_h_right_thigh_x_1 = neg_h_right_shank_x + left_thigh_h1 * s_right_hip_pitch;
  const Scalar neg_h_right_thigh_x = neg_h_right_thigh_x_1 - left_thigh_h2 * c_right_hip_pitch;
  const Scalar h_right_hip_fork_x = left_hip_fork_h2 - neg_h_right_thigh_x;
  // right_thigh: first moment h, G of 6.5
  const Scalar neg_h_right_hip_fork_y = left_hip_fork_h1 - neg_h_right_foot_y;
  const Scalar h_right_thigh_y_1 = h_right_shank_y + left_thigh_h2 * s_right_hip_pitch;
  const Scalar h_right_thigh_y = h_right_thigh_y_1 + left_thigh_h1 * c_right_hip_pitch;
  G[14] = t_right_foot_8 * h_right_thigh_y + t_right_foot_10 * neg_h_right_thigh_x;
  // right_hip_fork: first moment h, G of 6.5
  const Scalar t_right_hip_fork_1 = left_hip_block_h1 - c_right_hip_roll * neg_h_right_hip_fork_y;
  const Scalar neg_h_right_hip_block_x = t_right_hip_fork_1 + s_right_hip_roll * h_right_hip_fork_x;
  const Scalar neg_h_right_hip_block_y = left_hip_block_h2 + h_right_thigh_y;
  G[13] = t_right_foot_12 * h_right_hip_fork_x - t_right_foot_8 * neg_h_right_hip_fork_y;
  const Scalar neg_G_12_1 = t_right_foot_5 * neg_h_right_hip_block_y;
  G[12] = -(neg_G_12_1 + t_right_foot_10 * neg_h_right_hip_block_x);
  // left_foot: first moment h, G of 6.5
  const Scalar h_left_foot_x = left_foot_h1 * c_left_foot;
  const Scalar h_left_foot_y = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_1 = c_left_hip_yaw * t_right_foot_2;
  const Scalar t_left_foot_2 = t_left_foot_1 + s_left_hip_yaw * t_right_foot_3;
  const Scalar t_left_foot_3 = c_left_hip_roll * t_right_foot_6;
  const Scalar t_left_foot_4 = t_left_foot_3 - s_left_hip_roll * t_left_foot_2;
  const Scalar t_left_foot_5 = s_left_hip_yaw * t_right_foot_2;
  const Scalar t_left_foot_6 = t_left_foot_5 - c_left_hip_yaw * t_right_foot_3;
  const Scalar t_left_foot_7 = s_left_hip_roll * t_right_foot_6;
  const Scalar t_left_foot_8 = t_left_foot_7 + c_left_hip_roll * t_left_foot_2;
  const Scalar neg_G_11_1 = s_q8_q9_q10 * t_left_foot_6 + c_q8_q9_q10 * t_left_foot_4;
  G[11] = -(h_left_foot_y * neg_G_11_1 + h_left_foot_x * t_left_foot_8);
  // left_ankle_cross: first moment h, G of 6.5
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_h1 + h_left_foot_x;
  const Scalar h_left_ankle_cross_y_1 = s_q8_q9_q10 * t_left_ankle_cross_1;
  const Scalar h_left_ankle_cross_y = left_ankle_cross_h2 * c_q8_q9_q10 - h_left_ankle_cross_y_1;
  const Scalar t_left_foot_9 = c_q8_q9_q10 * t_left_ankle_cross_1;
  const Scalar neg_h_left_ankle_cross_x = left_ankle_cross_h2 * s_q8_q9_q10 + t_left_foot_9;
  G[10] = t_left_foot_4 * h_left_ankle_cross_y + t_left_foot_6 * neg_h_left_ankle_cross_x;
  const Scalar h_left_shank_y_1 = h_left_ankle_cross_y + left_shank_h1 * s_q8_q9;
  const Scalar h_left_shank_y = h_left_shank_y_1 + left_shank_h2 * c_q8_q9;
  const Scalar neg_h_left_shank_x_1 = neg_h_left_ankle_cross_x - left_shank_h1 * c_q8_q9;
  const Scalar neg_h_left_shank_x = neg_h_left_shank_x_1 + left_shank_h2 * s_q8_q9;
  // left_shank: G, first moment h of 6.5
  G[9] = t_left_foot_4 * h_left_shank_y + t_left_foot_6 * neg_h_left_shank_x;
  const Scalar neg_h_left_thigh_x_1 = neg_h_left_shank_x - left_thigh_h2 * c_left_hip_pitch;
  const Scalar neg_h_left_thigh_x = neg_h_left_thigh_x_1 + left_thigh_h1 * s_left_hip_pitch;
  const Scalar h_left_hip_fork_x = left_hip_fork_h2 - neg_h_left_thigh_x;
  const Scalar h_left_hip_fork_y = left_hip_fork_h1 - h_left_foot_y;
  // left_thigh: first moment h, G of 6.5
  const Scalar h_left_thigh_y_1 = h_left_shank_y + left_thigh_h1 * c_left_hip_pitch;
  const Scalar h_left_thigh_y = h_left_thigh_y_1 + left_thigh_h2 * s_left_hip_pitch;
  G[8] = t_left_foot_6 * neg_h_left_thigh_x + t_left_foot_4 * h_left_thigh_y;
  const Scalar h_left_hip_block_x_1 = left_hip_block_h1 - c_left_hip_roll * h_left_hip_fork_y;
  const Scalar h_left_hip_block_x = h_left_hip_block_x_1 - s_left_hip_roll * h_left_hip_fork_x;
  const Scalar neg_h_left_hip_block_y = left_hip_block_h2 + h_left_thigh_y;
  G[7] = t_left_foot_4 * h_left_hip_fork_y + t_left_foot_8 * h_left_hip_fork_x;
  G[6] = t_left_foot_6 * h_left_hip_block_x - t_left_foot_2 * neg_h_left_hip_block_y;
  const Scalar neg_h_base_rx_y_1 = base_rx_h2 + c_right_hip_roll * h_right_hip_fork_x;
  const Scalar neg_h_base_rx_y_2 = neg_h_base_rx_y_1 + s_right_hip_roll * neg_h_right_hip_fork_y;
  // left_hip_block: first moment h of 6.5
  const Scalar neg_h_base_rx_y_3 = neg_h_base_rx_y_2 + c_left_hip_roll * h_left_hip_fork_x;
  const Scalar neg_h_base_rx_y = neg_h_base_rx_y_3 - s_left_hip_roll * h_left_hip_fork_y;
  const Scalar neg_h_base_rx_x_1 = base_rx_h1 + s_right_hip_yaw * neg_h_right_hip_block_y;
  const Scalar neg_h_base_rx_x_2 = neg_h_base_rx_x_1 + s_left_hip_yaw * neg_h_left_hip_block_y;
  const Scalar neg_h_base_rx_x_3 = neg_h_base_rx_x_2 - c_right_hip_yaw * neg_h_right_hip_block_x;
  const Scalar neg_h_base_rx_x = neg_h_base_rx_x_3 + c_left_hip_yaw * h_left_hip_block_x;
  // base_rx: G, first moment h of 6.5
  G[5] = t_right_foot_2 * neg_h_base_rx_y - t_right_foot_6 * neg_h_base_rx_x;
  const Scalar neg_h_base_ry_y_1 = base_rx_h3 - s_left_hip_yaw * h_left_hip_block_x;
  const Scalar neg_h_base_ry_y_2 = neg_h_base_ry_y_1 + c_right_hip_yaw * neg_h_right_hip_block_y;
  const Scalar neg_h_base_ry_y_3 = neg_h_base_ry_y_2 + c_left_hip_yaw * neg_h_left_hip_block_y;
  const Scalar neg_h_base_ry_y = neg_h_base_ry_y_3 + s_right_hip_yaw * neg_h_right_hip_block_x;
  const Scalar neg_h_base_ry_x = c_base_rx * neg_h_base_rx_y + s_base_rx * neg_h_base_rx_x;
  // base_ry: G of 6.5
  G[4] = t_right_foot_1 * neg_h_base_ry_y + t_right_foot_3 * neg_h_base_ry_x;
  G[2] = -base_rx_w1;
  G[0] = 0.0;
  G[1] = 0.0;
  G[3] = 0.0;
}

void inverse_dynamics(const Scalar q[18], const Scalar qd[18], const Scalar qdd[18],
                      Scalar tau[18]) noexcept {
  const Scalar angle_left_foot = left_foot_k1 + q[11];
  const Scalar angle_right_foot = left_foot_k1 - q[17];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[3], q[4], q[5], q[6]);
  sines_cosines(sines + 4, cosines + 4, q[7], q[8], q[9], q[10]);
  sines_cosines(sines + 8, cosines + 8, q[12], q[13], q[14], q[15]);
  sines_cosines(sines + 12, cosines + 12, q[16], angle_left_foot, angle_right_foot);
  const Scalar s_base_rz = sines[0];
  const Scalar c_base_rz = cosines[0];
  const Scalar s_base_ry = sines[1];
  const Scalar c_base_ry = cosines[1];
  const Scalar s_base_rx = sines[2];
  const Scalar c_base_rx = cosines[2];
  const Scalar s_left_hip_yaw = sines[3];
  const Scalar c_left_hip_yaw = cosines[3];
  const Scalar s_left_hip_roll = sines[4];
  const Scalar c_left_hip_roll = cosines[4];
  const Scalar s_left_hip_pitch = sines[5];
  const Scalar c_left_hip_pitch = cosines[5];
  const Scalar s_left_knee = sines[6];
  const Scalar c_left_knee = cosines[6];
  const Scalar s_left_ankle_pitch = sines[7];
  const Scalar c_left_ankle_pitch = cosines[7];
  const Scalar s_right_hip_yaw = sines[8];
  const Scalar c_right_hip_yaw = cosines[8];
  const Scalar s_right_hip_roll = sines[9];
  const Scalar c_right_hip_roll = cosines[9];
  const Scalar s_right_hip_pitch = sines[10];
  const Scalar c_right_hip_pitch = cosines[10];
  const Scalar s_right_knee = sines[11];
  const Scalar c_right_knee = cosines[11];
  const Scalar s_right_ankle_pitch = sines[12];
  const Scalar c_right_ankle_pitch = cosines[12];
  const Scalar s_left_foot = sines[13];
  const Scalar c_left_foot = cosines[13];
  const Scalar s_right_foot = sines[14];
  const Scalar c_right_foot = cosines[14];
  const Scalar neg_a_base_pz_z = base_g1 - qdd[2];
  const Scalar a_base_rz_y = s_base_rz * qdd[0] - c_base_rz * qdd[1];
  const Scalar neg_a_base_rz_x = c_base_rz * qdd[0] + s_base_rz * qdd[1];
  const Scalar a_base_rx_z = s_base_ry * neg_a_base_pz_z + c_base_ry * neg_a_base_rz_x;
  // base_ry: acceleration a, angular velocity omega, Omega of (1)
  const Scalar neg_a_base_ry_x = s_base_ry * neg_a_base_rz_x - c_base_ry * neg_a_base_pz_z;
  const Scalar omega_base_ry_y = s_base_ry * qd[3];
  const Scalar neg_Omega_base_ry_zy = c_base_ry * qdd[3] - omega_base_ry_y * qd[4] * 2.0;
  const Scalar neg_omega_base_ry_x = c_base_ry * qd[3];
  const Scalar neg_Omega_base_ry_xy = qdd[4] + omega_base_ry_y * neg_omega_base_ry_x;
  // base_rx: angular velocity omega, Omega, angular acceleration alpha of (1)
  const Scalar neg_omega_base_rx_y = c_base_rx * neg_omega_base_ry_x - s_base_rx * qd[4];
  const Scalar neg_omega_base_rx_z = omega_base_ry_y - qd[5];
  const Scalar Omega_base_rx_yz_1 = s_base_rx * neg_Omega_base_ry_zy;
  const Scalar Omega_base_rx_yz = Omega_base_rx_yz_1 + c_base_rx * neg_Omega_base_ry_xy;
  const Scalar t_base_rx_1 = neg_omega_base_rx_y * neg_omega_base_rx_z;
  const Scalar neg_Omega_base_rx_zy = Omega_base_rx_yz - 2.0 * t_base_rx_1;
  const Scalar neg_omega_base_rx_x = s_base_rx * neg_omega_base_ry_x + c_base_rx * qd[4];
  const Scalar t_base_rx_2 = neg_omega_base_rx_z * neg_omega_base_rx_x;
  const Scalar Omega_base_rx_xz_1 = s_base_rx * neg_Omega_base_ry_xy;
  const Scalar Omega_base_rx_xz = Omega_base_rx_xz_1 - c_base_rx * neg_Omega_base_ry_zy;
  const Scalar neg_alpha_base_rx_y = t_base_rx_2 - Omega_base_rx_xz;
  const Scalar Omega_base_rx_zx = t_base_rx_2 + neg_alpha_base_rx_y;
  const Scalar t_base_rx_3 = neg_omega_base_rx_x * neg_omega_base_rx_x;
  const Scalar t_base_rx_4 = neg_omega_base_rx_z * neg_omega_base_rx_z;
  const Scalar neg_Omega_base_ry_yy = neg_omega_base_ry_x * neg_omega_base_ry_x + qd[4] * qd[4];
  const Scalar t_base_rx_5 = t_base_rx_3 - t_base_rx_4;
  const Scalar neg_Omega_base_rx_xx = neg_Omega_base_ry_yy - t_base_rx_5;
  const Scalar t_base_rx_6 = neg_omega_base_rx_y * neg_omega_base_rx_x;
  const Scalar alpha_base_rx_z = qdd[5] - qd[4] * neg_omega_base_ry_x - s_base_ry * qdd[3];
  const Scalar Omega_base_rx_xy = t_base_rx_6 - alpha_base_rx_z;
  const Scalar Omega_base_rx_yx = t_base_rx_6 + alpha_base_rx_z;
  const Scalar neg_Omega_base_rx_yy = t_base_rx_3 + t_base_rx_4;
  // left_hip_block: acceleration a, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_left_hip_block_1 = left_hip_block_l1 * Omega_base_rx_zx;
  const Scalar t_left_hip_block_2 = a_base_rx_z + left_hip_block_l2 * neg_Omega_base_rx_zy;
  const Scalar t_left_hip_block_3 = t_left_hip_block_1 - t_left_hip_block_2;
  const Scalar t_left_hip_block_4 = left_hip_block_l1 * neg_Omega_base_rx_xx;
  const Scalar neg_a_base_rx_x = s_base_rx * neg_a_base_ry_x - c_base_rx * a_base_rz_y;
  const Scalar t_left_hip_block_5 = neg_a_base_rx_x + left_hip_block_l2 * Omega_base_rx_xy;
  const Scalar t_left_hip_block_6 = t_left_hip_block_4 - t_left_hip_block_5;
  const Scalar t_left_hip_block_7 = c_left_hip_yaw * t_left_hip_block_6;
  const Scalar neg_a_left_hip_block_x = t_left_hip_block_7 - s_left_hip_yaw * t_left_hip_block_3;
  const Scalar a_left_hip_block_y_1 = s_left_hip_yaw * t_left_hip_block_6;
  const Scalar a_left_hip_block_y = a_left_hip_block_y_1 + c_left_hip_yaw * t_left_hip_block_3;
  const Scalar t_left_hip_block_8 = c_left_hip_yaw * neg_omega_base_rx_x;
  const Scalar omega_left_hip_block_x = t_left_hip_block_8 + s_left_hip_yaw * neg_omega_base_rx_z;
  const Scalar omega_left_hip_block_z = neg_omega_base_rx_y + qd[6];
  const Scalar t_left_hip_block_9 = omega_left_hip_block_x * omega_left_hip_block_z;
  const Scalar t_left_hip_block_10 = s_left_hip_yaw * neg_Omega_base_rx_zy;
  const Scalar Omega_left_hip_block_xz = c_left_hip_yaw * Omega_base_rx_xy - t_left_hip_block_10;
  const Scalar t_left_hip_block_11 = t_left_hip_block_9 - Omega_left_hip_block_xz;
  const Scalar Omega_left_hip_block_zx = t_left_hip_block_9 + t_left_hip_block_11;
  const Scalar t_left_hip_block_12 = c_left_hip_yaw * neg_omega_base_rx_z;
  const Scalar omega_left_hip_block_y = t_left_hip_block_12 - s_left_hip_yaw * neg_omega_base_rx_x;
  const Scalar t_left_hip_block_13 = c_left_hip_yaw * neg_Omega_base_rx_zy;
  const Scalar t_left_hip_block_14 = s_left_hip_yaw * Omega_base_rx_xy + t_left_hip_block_13;
  const Scalar t_left_hip_block_15 = omega_left_hip_block_z * omega_left_hip_block_y;
  const Scalar Omega_left_hip_block_zy = t_left_hip_block_14 + 2.0 * t_left_hip_block_15;
  const Scalar t_left_hip_block_16 = omega_left_hip_block_x * omega_left_hip_block_y;
  const Scalar alpha_left_hip_block_z = neg_alpha_base_rx_y + qdd[6];
  const Scalar Omega_left_hip_block_yx = t_left_hip_block_16 + alpha_left_hip_block_z;
  const Scalar Omega_left_hip_block_xy = t_left_hip_block_16 - alpha_left_hip_block_z;
  const Scalar t_left_hip_block_17 = omega_left_hip_block_x * omega_left_hip_block_x;
  const Scalar t_left_hip_block_18 = omega_left_hip_block_z * omega_left_hip_block_z;
  const Scalar t_left_hip_block_19 = left_hip_block_l1 * Omega_base_rx_yx;
  const Scalar neg_a_base_rx_y = s_base_rx * a_base_rz_y + c_base_rx * neg_a_base_ry_x;
  const Scalar t_left_hip_block_20 = neg_a_base_rx_y - left_hip_block_l2 * neg_Omega_base_rx_yy;
  const Scalar a_left_hip_block_z = t_left_hip_block_19 + t_left_hip_block_20;
  const Scalar t_left_hip_block_21 = t_left_hip_block_17 + t_left_hip_block_18;
  // left_hip_fork: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * Omega_left_hip_block_xy;
  const Scalar Omega_left_hip_fork_yz =
      t_left_hip_fork_1 + s_left_hip_roll * Omega_left_hip_block_zy;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 + s_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_4 = omega_left_hip_block_y - qd[7];
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_3 * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = Omega_left_hip_fork_yz - 2.0 * t_left_hip_fork_5;
  const Scalar t_left_hip_fork_7 = c_left_hip_roll * Omega_left_hip_block_zy;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_7 - s_left_hip_roll * Omega_left_hip_block_xy;
  const Scalar t_left_hip_fork_9 = c_left_hip_roll * omega_left_hip_block_z;
  const Scalar omega_left_hip_fork_x = t_left_hip_fork_9 - s_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_4 * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_8 - t_left_hip_fork_10;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_10 - t_left_hip_fork_11;
  const Scalar t_left_hip_fork_13 = t_left_hip_fork_3 * omega_left_hip_fork_x;
  const Scalar alpha_left_hip_fork_z = t_left_hip_block_11 + qdd[7];
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_13 - alpha_left_hip_fork_z;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_13 + alpha_left_hip_fork_z;
  const Scalar t_left_hip_fork_16 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_17 = t_left_hip_fork_4 * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_18 = t_left_hip_fork_16 + t_left_hip_fork_17;
  // left_thigh: Omega, angular velocity omega, acceleration a of (1)
  const Scalar t_left_thigh_1 = s_left_hip_pitch * t_left_hip_fork_15;
  const Scalar neg_Omega_left_thigh_yz = t_left_thigh_1 - c_left_hip_pitch * t_left_hip_fork_6;
  const Scalar t_left_thigh_2 = s_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar neg_omega_left_thigh_y = t_left_thigh_2 + c_left_hip_pitch * t_left_hip_fork_4;
  const Scalar omega_left_thigh_z = t_left_hip_fork_3 + qd[8];
  const Scalar t_left_thigh_3 = 2.0 * omega_left_thigh_z;
  const Scalar Omega_left_thigh_zy =
      neg_Omega_left_thigh_yz - neg_omega_left_thigh_y * t_left_thigh_3;
  const Scalar Omega_left_thigh_xz_1 = c_left_hip_pitch * t_left_hip_fork_15;
  const Scalar Omega_left_thigh_xz = Omega_left_thigh_xz_1 + s_left_hip_pitch * t_left_hip_fork_6;
  const Scalar omega_left_thigh_x_1 = c_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_x = omega_left_thigh_x_1 - s_left_hip_pitch * t_left_hip_fork_4;
  const Scalar neg_Omega_left_thigh_zx = Omega_left_thigh_xz - t_left_thigh_3 * omega_left_thigh_x;
  const Scalar a_left_hip_fork_x_1 = s_left_hip_roll * neg_a_left_hip_block_x;
  const Scalar a_left_hip_fork_x = a_left_hip_fork_x_1 + c_left_hip_roll * a_left_hip_block_z;
  const Scalar t_left_thigh_4 = a_left_hip_fork_x - left_hip_fork_l1 * t_left_hip_fork_8;
  const Scalar t_left_thigh_5 = a_left_hip_block_y + left_hip_fork_l1 * t_left_hip_block_21;
  const Scalar t_left_thigh_6 = neg_omega_left_thigh_y * omega_left_thigh_x;
  const Scalar alpha_left_thigh_z = t_left_hip_fork_11 + qdd[8];
  const Scalar neg_Omega_left_thigh_yx = t_left_thigh_6 - alpha_left_thigh_z;
  const Scalar neg_Omega_left_thigh_xy = t_left_thigh_6 + alpha_left_thigh_z;
  const Scalar a_left_hip_fork_y_1 = c_left_hip_roll * neg_a_left_hip_block_x;
  const Scalar a_left_hip_fork_y = a_left_hip_fork_y_1 - s_left_hip_roll * a_left_hip_block_z;
  const Scalar neg_a_left_thigh_z = a_left_hip_fork_y + left_hip_fork_l1 * Omega_left_hip_fork_yz;
  const Scalar t_left_thigh_7 = omega_left_thigh_x * omega_left_thigh_x;
  const Scalar t_left_thigh_8 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar neg_Omega_left_thigh_yy = t_left_thigh_7 + t_left_thigh_8;
  // left_shank: Omega, angular velocity omega, acceleration a of (1)
  const Scalar t_left_shank_1 = c_left_knee * neg_Omega_left_thigh_yz;
  const Scalar neg_Omega_left_shank_yz = s_left_knee * Omega_left_thigh_xz + t_left_shank_1;
  const Scalar t_left_shank_2 = c_left_knee * neg_omega_left_thigh_y;
  const Scalar neg_omega_left_shank_y = s_left_knee * omega_left_thigh_x + t_left_shank_2;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[9];
  const Scalar t_left_shank_3 = 2.0 * omega_left_shank_z;
  const Scalar Omega_left_shank_zy =
      neg_Omega_left_shank_yz - neg_omega_left_shank_y * t_left_shank_3;
  const Scalar neg_a_left_shank_z = neg_a_left_thigh_z + left_shank_l1 * neg_Omega_left_thigh_zx;
  const Scalar Omega_left_shank_xz_1 = s_left_knee * neg_Omega_left_thigh_yz;
  const Scalar Omega_left_shank_xz = c_left_knee * Omega_left_thigh_xz - Omega_left_shank_xz_1;
  const Scalar t_left_shank_4 = s_left_knee * neg_omega_left_thigh_y;
  const Scalar neg_omega_left_shank_x = t_left_shank_4 - c_left_knee * omega_left_thigh_x;
  const Scalar neg_Omega_left_shank_zx =
      Omega_left_shank_xz + t_left_shank_3 * neg_omega_left_shank_x;
  // left_thigh: Omega, acceleration a of (1)
  const Scalar t_left_thigh_9 = t_left_thigh_7 - t_left_thigh_8;
  const Scalar neg_Omega_left_thigh_xx = t_left_hip_fork_18 - t_left_thigh_9;
  const Scalar a_left_thigh_x_1 = c_left_hip_pitch * t_left_thigh_4;
  const Scalar a_left_thigh_x = a_left_thigh_x_1 - s_left_hip_pitch * t_left_thigh_5;
  const Scalar t_left_shank_5 = a_left_thigh_x - left_shank_l1 * neg_Omega_left_thigh_xx;
  const Scalar neg_a_left_thigh_y_1 = c_left_hip_pitch * t_left_thigh_5;
  const Scalar neg_a_left_thigh_y = neg_a_left_thigh_y_1 + s_left_hip_pitch * t_left_thigh_4;
  // left_shank: acceleration a, Omega, angular acceleration alpha of (1)
  const Scalar t_left_shank_6 = neg_a_left_thigh_y + left_shank_l1 * neg_Omega_left_thigh_yx;
  const Scalar a_left_shank_x = c_left_knee * t_left_shank_5 - s_left_knee * t_left_shank_6;
  const Scalar t_left_shank_7 = neg_omega_left_shank_y * neg_omega_left_shank_x;
  const Scalar alpha_left_shank_z = alpha_left_thigh_z + qdd[9];
  const Scalar Omega_left_shank_xy = t_left_shank_7 - alpha_left_shank_z;
  const Scalar Omega_left_shank_yx = t_left_shank_7 + alpha_left_shank_z;
  const Scalar t_left_shank_8 = neg_omega_left_shank_x * neg_omega_left_shank_x;
  const Scalar t_left_shank_9 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_10 = t_left_shank_8 - t_left_shank_9;
  // left_ankle_cross: Omega, angular velocity omega, acceleration a of (1)
  const Scalar t_left_ankle_cross_1 = c_left_ankle_pitch * neg_Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_2 =
      t_left_ankle_cross_1 + s_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_3 = c_left_ankle_pitch * neg_omega_left_shank_y;
  const Scalar omega_left_ankle_cross_y =
      t_left_ankle_cross_3 - s_left_ankle_pitch * neg_omega_left_shank_x;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[10];
  const Scalar t_left_foot_1 = 2.0 * omega_left_ankle_cross_z;
  const Scalar Omega_left_foot_yz = t_left_ankle_cross_2 - omega_left_ankle_cross_y * t_left_foot_1;
  const Scalar neg_a_left_ankle_cross_z =
      neg_a_left_shank_z + left_ankle_cross_l1 * neg_Omega_left_shank_zx;
  const Scalar neg_Omega_left_shank_xx = t_left_hip_fork_18 - t_left_shank_10;
  const Scalar t_left_ankle_cross_4 =
      a_left_shank_x - left_ankle_cross_l1 * neg_Omega_left_shank_xx;
  const Scalar neg_a_left_shank_y_1 = c_left_knee * t_left_shank_6;
  const Scalar neg_a_left_shank_y = neg_a_left_shank_y_1 + s_left_knee * t_left_shank_5;
  const Scalar t_left_ankle_cross_5 =
      neg_a_left_shank_y - left_ankle_cross_l1 * Omega_left_shank_yx;
  const Scalar t_left_ankle_cross_6 = s_left_ankle_pitch * neg_Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_7 =
      c_left_ankle_pitch * Omega_left_shank_xz - t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_8 = s_left_ankle_pitch * neg_omega_left_shank_y;
  const Scalar omega_left_ankle_cross_x =
      t_left_ankle_cross_8 + c_left_ankle_pitch * neg_omega_left_shank_x;
  const Scalar t_left_ankle_cross_9 = 2.0 * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_10 = omega_left_ankle_cross_z * t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_11 = t_left_ankle_cross_7 + t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_12 = c_left_ankle_pitch * t_left_ankle_cross_4;
  const Scalar neg_a_left_ankle_cross_x =
      t_left_ankle_cross_12 - s_left_ankle_pitch * t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_13 = omega_left_ankle_cross_y * omega_left_ankle_cross_x;
  const Scalar alpha_left_ankle_cross_z = alpha_left_shank_z + qdd[10];
  const Scalar t_left_ankle_cross_14 = t_left_ankle_cross_13 - alpha_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_15 = t_left_ankle_cross_13 + alpha_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_16 = omega_left_ankle_cross_x * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_17 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_18 = t_left_ankle_cross_16 - t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_19 = t_left_ankle_cross_16 + t_left_ankle_cross_17;
  // left_foot: acceleration a, angular velocity omega, Omega of (1)
  const Scalar neg_a_left_foot_y_1 =
      neg_a_left_ankle_cross_z - left_hip_fork_l1 * t_left_ankle_cross_11;
  const Scalar neg_a_left_foot_y = neg_a_left_foot_y_1 - left_hip_fork_l3 * t_left_hip_fork_18;
  const Scalar neg_omega_left_foot_z = omega_left_ankle_cross_y - qd[11];
  const Scalar neg_Omega_left_foot_zy = t_left_ankle_cross_2 - t_left_foot_1 * qd[11];
  const Scalar neg_Omega_left_foot_xy = t_left_ankle_cross_7 + qdd[11];
  const Scalar Omega_left_foot_yx = t_left_ankle_cross_10 + neg_Omega_left_foot_xy;
  const Scalar t_left_ankle_cross_20 = s_left_ankle_pitch * t_left_ankle_cross_4;
  const Scalar a_left_ankle_cross_y =
      t_left_ankle_cross_20 + c_left_ankle_pitch * t_left_ankle_cross_5;
  const Scalar neg_a_left_foot_z_1 =
      a_left_ankle_cross_y + left_hip_fork_l1 * t_left_ankle_cross_15;
  const Scalar neg_a_left_foot_z = neg_a_left_foot_z_1 - left_hip_fork_l3 * t_left_ankle_cross_2;
  const Scalar neg_a_left_foot_x_1 = t_left_hip_fork_18 - t_left_ankle_cross_18;
  const Scalar neg_a_left_foot_x_2 =
      neg_a_left_ankle_cross_x - left_hip_fork_l3 * t_left_ankle_cross_7;
  const Scalar neg_a_left_foot_x = neg_a_left_foot_x_2 + left_hip_fork_l1 * neg_a_left_foot_x_1;
  const Scalar Omega_left_foot_zx =
      t_left_ankle_cross_14 - t_left_ankle_cross_9 * neg_omega_left_foot_z;
  const Scalar t_left_foot_2 = neg_omega_left_foot_z * neg_omega_left_foot_z;
  const Scalar t_left_foot_3 = left_foot_I9 * c_left_foot + left_foot_I8 * s_left_foot;
  const Scalar t_left_foot_4 = s_left_foot * t_left_foot_3;
  const Scalar t_left_foot_5 = left_foot_I2 * c_left_foot + left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_6 = left_foot_I2 * s_left_foot - left_foot_I1 * c_left_foot;
  const Scalar t_left_foot_7 = left_foot_I14 - c_left_foot * t_left_foot_3;
  const Scalar t_left_foot_8 = left_foot_h1 * c_left_foot;
  const Scalar t_left_foot_9 = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_10 = left_foot_I12 - t_left_foot_4;
  const Scalar t_left_foot_11 = left_foot_I13 + t_left_foot_4;
  const Scalar neg_M_left_foot_z_1 = neg_a_left_foot_y * t_left_foot_8;
  const Scalar neg_M_left_foot_z_2 = neg_M_left_foot_z_1 - neg_a_left_foot_x * t_left_foot_9;
  const Scalar neg_M_left_foot_z_3 = neg_M_left_foot_z_2 - Omega_left_foot_yx * t_left_foot_10;
  const Scalar neg_M_left_foot_z_4 = neg_M_left_foot_z_3 - neg_Omega_left_foot_xy * t_left_foot_11;
  const Scalar neg_M_left_foot_z_5 = neg_M_left_foot_z_4 - t_left_ankle_cross_18 * t_left_foot_7;
  const Scalar neg_M_left_foot_z_6 = neg_M_left_foot_z_5 - Omega_left_foot_yz * t_left_foot_5;
  const Scalar neg_M_left_foot_z = neg_M_left_foot_z_6 - t_left_ankle_cross_14 * t_left_foot_6;
  tau[11] = -neg_M_left_foot_z;
  const Scalar neg_F_left_foot_z_1 = left_ankle_cross_m1 * neg_a_left_foot_z;
  const Scalar neg_F_left_foot_z_2 = neg_F_left_foot_z_1 - Omega_left_foot_zx * t_left_foot_8;
  const Scalar neg_F_left_foot_z = neg_F_left_foot_z_2 + neg_Omega_left_foot_zy * t_left_foot_9;
  const Scalar neg_Omega_left_foot_xx = t_left_ankle_cross_17 + t_left_foot_2;
  const Scalar neg_F_left_foot_x_1 = t_left_foot_8 * neg_Omega_left_foot_xx;
  const Scalar neg_F_left_foot_x_2 = neg_F_left_foot_x_1 + left_ankle_cross_m1 * neg_a_left_foot_x;
  const Scalar neg_F_left_foot_x = neg_F_left_foot_x_2 + neg_Omega_left_foot_xy * t_left_foot_9;
  // right_hip_block: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_right_hip_block_1 = t_left_hip_block_1 + t_left_hip_block_2;
  const Scalar t_right_hip_block_2 = t_left_hip_block_4 + t_left_hip_block_5;
  const Scalar t_right_hip_block_3 = s_right_hip_yaw * t_right_hip_block_1;
  const Scalar neg_a_right_hip_block_x =
      t_right_hip_block_3 - c_right_hip_yaw * t_right_hip_block_2;
  const Scalar a_right_hip_fork_z_1 = c_right_hip_yaw * t_right_hip_block_1;
  const Scalar a_right_hip_fork_z = a_right_hip_fork_z_1 + s_right_hip_yaw * t_right_hip_block_2;
  const Scalar omega_right_hip_block_z = neg_omega_base_rx_y + qd[12];
  const Scalar t_right_hip_block_4 = c_right_hip_yaw * neg_Omega_base_rx_zy;
  const Scalar t_right_hip_block_5 = s_right_hip_yaw * Omega_base_rx_xy + t_right_hip_block_4;
  const Scalar t_right_hip_block_6 = s_right_hip_yaw * neg_omega_base_rx_x;
  const Scalar t_right_hip_block_7 = t_right_hip_block_6 - c_right_hip_yaw * neg_omega_base_rx_z;
  const Scalar t_right_hip_block_8 = omega_right_hip_block_z * t_right_hip_block_7;
  const Scalar Omega_right_hip_block_zy = t_right_hip_block_5 - 2.0 * t_right_hip_block_8;
  const Scalar t_right_hip_block_9 = c_right_hip_yaw * neg_omega_base_rx_x;
  const Scalar omega_right_hip_block_x =
      t_right_hip_block_9 + s_right_hip_yaw * neg_omega_base_rx_z;
  const Scalar t_right_hip_block_10 = omega_right_hip_block_z * omega_right_hip_block_x;
  const Scalar t_right_hip_block_11 = s_right_hip_yaw * neg_Omega_base_rx_zy;
  const Scalar Omega_right_hip_block_xz = c_right_hip_yaw * Omega_base_rx_xy - t_right_hip_block_11;
  const Scalar t_right_hip_block_12 = t_right_hip_block_10 - Omega_right_hip_block_xz;
  const Scalar Omega_right_hip_block_zx = t_right_hip_block_10 + t_right_hip_block_12;
  const Scalar t_right_hip_block_13 = t_right_hip_block_7 * omega_right_hip_block_x;
  const Scalar alpha_right_hip_block_z = neg_alpha_base_rx_y + qdd[12];
  const Scalar t_right_hip_block_14 = t_right_hip_block_13 + alpha_right_hip_block_z;
  const Scalar t_right_hip_block_15 = t_right_hip_block_13 - alpha_right_hip_block_z;
  const Scalar neg_a_right_hip_block_z = t_left_hip_block_19 - t_left_hip_block_20;
  const Scalar t_right_hip_block_16 = omega_right_hip_block_x * omega_right_hip_block_x;
  const Scalar t_right_hip_block_17 = omega_right_hip_block_z * omega_right_hip_block_z;
  const Scalar t_right_hip_block_18 = t_right_hip_block_16 + t_right_hip_block_17;
  // right_hip_fork: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_right_hip_fork_1 = s_right_hip_roll * Omega_right_hip_block_zy;
  const Scalar t_right_hip_fork_2 = c_right_hip_roll * t_right_hip_block_14 - t_right_hip_fork_1;
  const Scalar omega_right_hip_fork_z = t_right_hip_block_7 + qd[13];
  const Scalar t_right_hip_fork_3 = c_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_3 + s_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_5 = omega_right_hip_fork_z * t_right_hip_fork_4;
  const Scalar Omega_right_hip_fork_zy = t_right_hip_fork_2 - 2.0 * t_right_hip_fork_5;
  const Scalar t_right_hip_fork_6 = c_right_hip_roll * Omega_right_hip_block_zy;
  const Scalar t_right_hip_fork_7 = s_right_hip_roll * t_right_hip_block_14 + t_right_hip_fork_6;
  const Scalar t_right_hip_fork_8 = s_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_8 - c_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_10 = omega_right_hip_fork_z * t_right_hip_fork_9;
  const Scalar t_right_hip_fork_11 = t_right_hip_fork_7 - t_right_hip_fork_10;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_10 - t_right_hip_fork_11;
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_4 * t_right_hip_fork_9;
  const Scalar alpha_right_hip_fork_z = t_right_hip_block_12 + qdd[13];
  const Scalar Omega_right_hip_fork_yx = t_right_hip_fork_13 + alpha_right_hip_fork_z;
  const Scalar Omega_right_hip_fork_xy = t_right_hip_fork_13 - alpha_right_hip_fork_z;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_9 * t_right_hip_fork_9;
  const Scalar t_right_hip_fork_15 = omega_right_hip_fork_z * omega_right_hip_fork_z;
  const Scalar t_right_hip_fork_16 = t_right_hip_fork_14 + t_right_hip_fork_15;
  // right_thigh: Omega, angular velocity omega, acceleration a of (1)
  const Scalar t_right_thigh_1 = c_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar neg_Omega_right_thigh_yz =
      t_right_thigh_1 - s_right_hip_pitch * Omega_right_hip_fork_xy;
  const Scalar omega_right_thigh_y_1 = c_right_hip_pitch * omega_right_hip_fork_z;
  const Scalar omega_right_thigh_y = omega_right_thigh_y_1 + s_right_hip_pitch * t_right_hip_fork_9;
  const Scalar omega_right_thigh_z = t_right_hip_fork_4 + qd[14];
  const Scalar t_right_thigh_2 = 2.0 * omega_right_thigh_z;
  const Scalar Omega_right_thigh_zy =
      neg_Omega_right_thigh_yz + omega_right_thigh_y * t_right_thigh_2;
  const Scalar t_right_thigh_3 = s_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar neg_Omega_right_thigh_xz =
      t_right_thigh_3 + c_right_hip_pitch * Omega_right_hip_fork_xy;
  const Scalar omega_right_thigh_x_1 = s_right_hip_pitch * omega_right_hip_fork_z;
  const Scalar omega_right_thigh_x = omega_right_thigh_x_1 - c_right_hip_pitch * t_right_hip_fork_9;
  const Scalar Omega_right_thigh_zx =
      neg_Omega_right_thigh_xz + t_right_thigh_2 * omega_right_thigh_x;
  const Scalar t_right_hip_fork_17 = c_right_hip_roll * neg_a_right_hip_block_z;
  const Scalar neg_a_right_hip_fork_x =
      t_right_hip_fork_17 - s_right_hip_roll * neg_a_right_hip_block_x;
  const Scalar t_right_thigh_4 = neg_a_right_hip_fork_x + left_hip_fork_l1 * t_right_hip_fork_7;
  const Scalar t_right_thigh_5 = a_right_hip_fork_z - left_hip_fork_l1 * t_right_hip_block_18;
  const Scalar alpha_right_thigh_z = t_right_hip_fork_11 + qdd[14];
  const Scalar t_right_thigh_6 = omega_right_thigh_y * omega_right_thigh_x;
  const Scalar neg_Omega_right_thigh_xy = alpha_right_thigh_z - t_right_thigh_6;
  const Scalar Omega_right_thigh_yx = alpha_right_thigh_z + t_right_thigh_6;
  const Scalar a_right_hip_fork_y_1 = s_right_hip_roll * neg_a_right_hip_block_z;
  const Scalar a_right_hip_fork_y =
      a_right_hip_fork_y_1 + c_right_hip_roll * neg_a_right_hip_block_x;
  const Scalar neg_a_right_thigh_z = a_right_hip_fork_y - left_hip_fork_l1 * t_right_hip_fork_2;
  const Scalar t_right_thigh_7 = omega_right_thigh_x * omega_right_thigh_x;
  const Scalar t_right_thigh_8 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar neg_Omega_right_thigh_yy = t_right_thigh_7 + t_right_thigh_8;
  // right_shank: Omega, angular velocity omega, acceleration a of (1)
  const Scalar t_right_shank_1 = c_right_knee * neg_Omega_right_thigh_yz;
  const Scalar neg_Omega_right_shank_yz = t_right_shank_1 - s_right_knee * neg_Omega_right_thigh_xz;
  const Scalar t_right_shank_2 = s_right_knee * omega_right_thigh_x;
  const Scalar neg_omega_right_shank_y = t_right_shank_2 - c_right_knee * omega_right_thigh_y;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[15];
  const Scalar t_right_shank_3 = 2.0 * omega_right_shank_z;
  const Scalar Omega_right_shank_zy =
      neg_Omega_right_shank_yz - neg_omega_right_shank_y * t_right_shank_3;
  const Scalar neg_a_right_shank_z = neg_a_right_thigh_z - left_shank_l1 * Omega_right_thigh_zx;
  const Scalar omega_right_shank_x_1 = c_right_knee * omega_right_thigh_x;
  const Scalar omega_right_shank_x = omega_right_shank_x_1 + s_right_knee * omega_right_thigh_y;
  const Scalar t_right_shank_4 = c_right_knee * neg_Omega_right_thigh_xz;
  const Scalar neg_Omega_right_shank_xz = t_right_shank_4 + s_right_knee * neg_Omega_right_thigh_yz;
  const Scalar Omega_right_shank_zx =
      neg_Omega_right_shank_xz + t_right_shank_3 * omega_right_shank_x;
  const Scalar a_right_thigh_y_1 = c_right_hip_pitch * t_right_thigh_5;
  const Scalar a_right_thigh_y = a_right_thigh_y_1 + s_right_hip_pitch * t_right_thigh_4;
  const Scalar t_right_shank_5 = a_right_thigh_y + left_shank_l1 * Omega_right_thigh_yx;
  // right_thigh: Omega, acceleration a of (1)
  const Scalar t_right_thigh_9 = t_right_thigh_7 - t_right_thigh_8;
  const Scalar a_right_thigh_x_1 = s_right_hip_pitch * t_right_thigh_5;
  const Scalar a_right_thigh_x = a_right_thigh_x_1 - c_right_hip_pitch * t_right_thigh_4;
  const Scalar neg_Omega_right_thigh_xx = t_right_hip_fork_16 - t_right_thigh_9;
  // right_shank: acceleration a, Omega, angular acceleration alpha of (1)
  const Scalar t_right_shank_6 = a_right_thigh_x - left_shank_l1 * neg_Omega_right_thigh_xx;
  const Scalar a_right_shank_x_1 = c_right_knee * t_right_shank_6;
  const Scalar a_right_shank_x = a_right_shank_x_1 + s_right_knee * t_right_shank_5;
  const Scalar t_right_shank_7 = neg_omega_right_shank_y * omega_right_shank_x;
  const Scalar alpha_right_shank_z = alpha_right_thigh_z + qdd[15];
  const Scalar neg_Omega_right_shank_yx = t_right_shank_7 - alpha_right_shank_z;
  const Scalar neg_Omega_right_shank_xy = t_right_shank_7 + alpha_right_shank_z;
  const Scalar t_right_shank_8 = omega_right_shank_x * omega_right_shank_x;
  const Scalar t_right_shank_9 = omega_right_shank_z * omega_right_shank_z;
  const Scalar neg_a_righ_ankl_cros_z =
      neg_a_right_shank_z - left_ankle_cross_l1 * Omega_right_shank_zx;
  const Scalar neg_a_right_shank_y_1 = s_right_knee * t_right_shank_6;
  const Scalar neg_a_right_shank_y = neg_a_right_shank_y_1 - c_right_knee * t_right_shank_5;
  const Scalar t_righ_ankl_cros_1 =
      neg_a_right_shank_y + left_ankle_cross_l1 * neg_Omega_right_shank_yx;
  const Scalar t_right_shank_10 = t_right_shank_8 - t_right_shank_9;
  const Scalar neg_Omega_right_shank_xx = t_right_hip_fork_16 - t_right_shank_10;
  // right_ankle_cross: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_righ_ankl_cros_2 =
      a_right_shank_x - left_ankle_cross_l1 * neg_Omega_right_shank_xx;
  const Scalar a_righ_ankl_cros_x_1 = s_right_ankle_pitch * t_righ_ankl_cros_1;
  const Scalar a_righ_ankl_cros_x = a_righ_ankl_cros_x_1 - c_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_3 = c_right_ankle_pitch * neg_Omega_right_shank_yz;
  const Scalar Omega_righ_ankl_cros_yz =
      t_righ_ankl_cros_3 - s_right_ankle_pitch * neg_Omega_right_shank_xz;
  const Scalar t_righ_ankl_cros_4 = c_right_ankle_pitch * neg_omega_right_shank_y;
  const Scalar omega_righ_ankl_cros_y =
      t_righ_ankl_cros_4 + s_right_ankle_pitch * omega_right_shank_x;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[16];
  const Scalar t_right_foot_1 = 2.0 * omega_righ_ankl_cros_z;
  const Scalar Omega_right_foot_yz =
      Omega_righ_ankl_cros_yz - omega_righ_ankl_cros_y * t_right_foot_1;
  const Scalar t_righ_ankl_cros_5 = s_right_ankle_pitch * neg_Omega_right_shank_yz;
  const Scalar Omega_righ_ankl_cros_xz =
      t_righ_ankl_cros_5 + c_right_ankle_pitch * neg_Omega_right_shank_xz;
  const Scalar t_righ_ankl_cros_6 = s_right_ankle_pitch * neg_omega_right_shank_y;
  const Scalar t_righ_ankl_cros_7 = c_right_ankle_pitch * omega_right_shank_x - t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_8 = 2.0 * t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_9 = omega_righ_ankl_cros_z * t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_10 = Omega_righ_ankl_cros_xz + t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_11 = omega_righ_ankl_cros_y * t_righ_ankl_cros_7;
  const Scalar alpha_righ_ankl_cros_z = alpha_right_shank_z + qdd[16];
  const Scalar t_righ_ankl_cros_12 = t_righ_ankl_cros_11 - alpha_righ_ankl_cros_z;
  const Scalar Omega_right_foot_xz = t_righ_ankl_cros_11 + alpha_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_13 = t_righ_ankl_cros_7 * t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_14 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_13 - t_righ_ankl_cros_14;
  // right_foot: acceleration a, angular velocity omega, Omega of (1)
  const Scalar neg_a_right_foot_y_1 =
      neg_a_righ_ankl_cros_z + left_hip_fork_l3 * t_right_hip_fork_16;
  const Scalar neg_a_right_foot_y = neg_a_right_foot_y_1 + left_hip_fork_l1 * t_righ_ankl_cros_10;
  const Scalar neg_omega_right_foot_z = omega_righ_ankl_cros_y - qd[17];
  const Scalar neg_Omega_right_foot_zy =
      Omega_right_foot_yz + t_right_foot_1 * neg_omega_right_foot_z;
  const Scalar t_righ_ankl_cros_16 = t_right_hip_fork_16 - t_righ_ankl_cros_15;
  const Scalar a_right_foot_x_1 = a_righ_ankl_cros_x - left_hip_fork_l1 * t_righ_ankl_cros_16;
  const Scalar a_right_foot_x = a_right_foot_x_1 + left_hip_fork_l3 * Omega_righ_ankl_cros_xz;
  const Scalar a_righ_ankl_cros_y_1 = c_right_ankle_pitch * t_righ_ankl_cros_1;
  const Scalar a_righ_ankl_cros_y = a_righ_ankl_cros_y_1 + s_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar neg_a_right_foot_z_1 =
      a_righ_ankl_cros_y + left_hip_fork_l3 * Omega_righ_ankl_cros_yz;
  const Scalar neg_a_right_foot_z = neg_a_right_foot_z_1 - left_hip_fork_l1 * t_righ_ankl_cros_12;
  const Scalar Omega_right_foot_xy = Omega_righ_ankl_cros_xz - qdd[17];
  const Scalar neg_Omega_right_foot_yx = t_righ_ankl_cros_9 + Omega_right_foot_xy;
  const Scalar neg_Omega_right_foot_zx =
      Omega_right_foot_xz - t_righ_ankl_cros_8 * neg_omega_right_foot_z;
  const Scalar t_right_foot_2 = neg_omega_right_foot_z * neg_omega_right_foot_z;
  const Scalar t_right_foot_3 = left_foot_I8 * s_right_foot + left_foot_I9 * c_right_foot;
  const Scalar t_right_foot_4 = left_foot_I14 - c_right_foot * t_right_foot_3;
  const Scalar t_right_foot_5 = left_foot_I1 * c_right_foot - left_foot_I2 * s_right_foot;
  const Scalar t_right_foot_6 = s_right_foot * t_right_foot_3;
  const Scalar t_right_foot_7 = left_foot_I1 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_8 = left_foot_h1 * c_right_foot;
  const Scalar t_right_foot_9 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_10 = left_foot_I12 - t_right_foot_6;
  const Scalar t_right_foot_11 = left_foot_I13 + t_right_foot_6;
  const Scalar neg_M_right_foot_z_1 = t_righ_ankl_cros_15 * t_right_foot_4;
  const Scalar neg_M_right_foot_z_2 = neg_M_right_foot_z_1 - a_right_foot_x * t_right_foot_9;
  const Scalar neg_M_right_foot_z_3 = neg_M_right_foot_z_2 + Omega_right_foot_xz * t_right_foot_5;
  const Scalar neg_M_right_foot_z_4 =
      neg_M_right_foot_z_3 + neg_Omega_right_foot_yx * t_right_foot_10;
  const Scalar neg_M_right_foot_z_5 = neg_M_right_foot_z_4 + Omega_right_foot_xy * t_right_foot_11;
  const Scalar neg_M_right_foot_z_6 = neg_M_right_foot_z_5 - Omega_right_foot_yz * t_right_foot_7;
  const Scalar neg_M_right_foot_z = neg_M_right_foot_z_6 + neg_a_right_foot_y * t_right_foot_8;
  tau[17] = -neg_M_right_foot_z;
  const Scalar neg_F_right_foot_z_1 = neg_Omega_right_foot_zy * t_right_foot_9;
  const Scalar neg_F_right_foot_z_2 =
      left_ankle_cross_m1 * neg_a_right_foot_z - neg_F_right_foot_z_1;
  const Scalar neg_F_right_foot_z = neg_F_right_foot_z_2 + neg_Omega_right_foot_zx * t_right_foot_8;
  const Scalar neg_Omega_right_foot_xx = t_righ_ankl_cros_14 + t_right_foot_2;
  const Scalar neg_F_right_foot_x_1 = t_right_foot_8 * neg_Omega_right_foot_xx;
  const Scalar neg_F_right_foot_x_2 = Omega_right_foot_xy * t_right_foot_9 + neg_F_right_foot_x_1;
  const Scalar neg_F_right_foot_x = neg_F_right_foot_x_2 - left_ankle_cross_m1 * a_right_foot_x;
  const Scalar t_righ_ankl_cros_17 = t_righ_ankl_cros_13 + t_righ_ankl_cros_14;
  const Scalar M_righ_ankl_cros_z_1 = neg_Omega_right_foot_zx * t_right_foot_10;
  // right_ankle_cross: moment M, force F of (1)
  const Scalar M_righ_ankl_cros_z_2 = t_righ_ankl_cros_16 - t_righ_ankl_cros_17;
  const Scalar M_righ_ankl_cros_z_3 = left_hip_fork_l1 * neg_F_right_foot_z + M_righ_ankl_cros_z_1;
  const Scalar M_righ_ankl_cros_z_4 =
      M_righ_ankl_cros_z_3 - left_ankle_cross_I7 * M_righ_ankl_cros_z_2;
  const Scalar M_righ_ankl_cros_z_5 =
      M_righ_ankl_cros_z_4 + left_ankle_cross_h2 * a_righ_ankl_cros_x;
  const Scalar M_righ_ankl_cros_z_6 =
      M_righ_ankl_cros_z_5 + left_ankle_cross_I11 * alpha_righ_ankl_cros_z;
  const Scalar M_righ_ankl_cros_z_7 =
      M_righ_ankl_cros_z_6 - left_ankle_cross_I10 * t_righ_ankl_cros_11;
  const Scalar M_righ_ankl_cros_z_8 = t_righ_ankl_cros_13 - t_right_foot_2;
  const Scalar M_righ_ankl_cros_z_9 =
      M_righ_ankl_cros_z_7 + left_ankle_cross_I1 * Omega_righ_ankl_cros_xz;
  const Scalar M_righ_ankl_cros_z_10 = M_righ_ankl_cros_z_9 + t_right_foot_7 * M_righ_ankl_cros_z_8;
  const Scalar M_righ_ankl_cros_z_11 = M_righ_ankl_cros_z_10 + neg_a_right_foot_z * t_right_foot_8;
  const Scalar M_righ_ankl_cros_z_12 =
      M_righ_ankl_cros_z_11 + neg_Omega_right_foot_zy * t_right_foot_4;
  const Scalar M_righ_ankl_cros_z_13 =
      M_righ_ankl_cros_z_12 + left_ankle_cross_I8 * Omega_righ_ankl_cros_yz;
  const Scalar M_righ_ankl_cros_z = M_righ_ankl_cros_z_13 + Omega_right_foot_xy * t_right_foot_5;
  tau[16] = M_righ_ankl_cros_z;
  const Scalar M_righ_ankl_cros_x_1 = t_right_hip_fork_16 - t_righ_ankl_cros_17;
  const Scalar M_righ_ankl_cros_x_2 = left_ankle_cross_I1 * M_righ_ankl_cros_x_1;
  const Scalar M_righ_ankl_cros_x_3 = M_righ_ankl_cros_x_2 - left_hip_fork_l3 * neg_F_right_foot_z;
  const Scalar M_righ_ankl_cros_x_4 =
      M_righ_ankl_cros_x_3 + left_ankle_cross_h2 * neg_a_righ_ankl_cros_z;
  const Scalar M_righ_ankl_cros_x_5 = M_righ_ankl_cros_x_4 + neg_a_right_foot_z * t_right_foot_9;
  const Scalar M_righ_ankl_cros_x_6 =
      M_righ_ankl_cros_x_5 - neg_Omega_right_foot_zy * t_right_foot_11;
  const Scalar M_righ_ankl_cros_x_7 =
      M_righ_ankl_cros_x_6 + left_ankle_cross_I8 * t_righ_ankl_cros_12;
  const Scalar M_righ_ankl_cros_x_8 =
      M_righ_ankl_cros_x_7 + left_ankle_cross_I7 * t_righ_ankl_cros_10;
  const Scalar M_righ_ankl_cros_x_9 =
      M_righ_ankl_cros_x_8 - left_ankle_cross_I6 * Omega_right_foot_yz;
  const Scalar M_righ_ankl_cros_x_10 = t_righ_ankl_cros_14 - t_right_foot_2;
  const Scalar M_righ_ankl_cros_x_11 =
      M_righ_ankl_cros_x_9 - neg_Omega_right_foot_zx * t_right_foot_4;
  const Scalar M_righ_ankl_cros_x_12 =
      M_righ_ankl_cros_x_11 - t_right_foot_5 * M_righ_ankl_cros_x_10;
  const Scalar M_righ_ankl_cros_x =
      M_righ_ankl_cros_x_12 + neg_Omega_right_foot_yx * t_right_foot_7;
  const Scalar F_righ_ankl_cros_y_1 =
      neg_F_right_foot_z + left_ankle_cross_h2 * t_righ_ankl_cros_17;
  const Scalar F_righ_ankl_cros_y = F_righ_ankl_cros_y_1 + left_shank_m1 * a_righ_ankl_cros_y;
  // right_foot: Omega, force F of (1)
  const Scalar neg_Omega_right_foot_yy = t_righ_ankl_cros_13 + t_right_foot_2;
  const Scalar F_right_foot_y_1 = t_right_foot_9 * neg_Omega_right_foot_yy;
  const Scalar F_right_foot_y_2 = F_right_foot_y_1 - left_ankle_cross_m1 * neg_a_right_foot_y;
  const Scalar F_right_foot_y = F_right_foot_y_2 - neg_Omega_right_foot_yx * t_right_foot_8;
  // right_ankle_cross: moment M, force F of (1)
  const Scalar M_righ_ankl_cros_y_1 = neg_M_right_foot_z - left_hip_fork_l3 * neg_F_right_foot_x;
  const Scalar M_righ_ankl_cros_y_2 =
      M_righ_ankl_cros_y_1 + left_ankle_cross_I1 * Omega_right_foot_xz;
  const Scalar M_righ_ankl_cros_y_3 =
      M_righ_ankl_cros_y_2 + left_ankle_cross_I9 * t_righ_ankl_cros_10;
  const Scalar M_righ_ankl_cros_y_4 =
      M_righ_ankl_cros_y_3 + left_ankle_cross_I8 * t_righ_ankl_cros_15;
  const Scalar M_righ_ankl_cros_y_5 = M_righ_ankl_cros_y_4 - left_hip_fork_l1 * F_right_foot_y;
  const Scalar M_righ_ankl_cros_y =
      M_righ_ankl_cros_y_5 - left_ankle_cross_I7 * Omega_right_foot_yz;
  const Scalar t_right_foot_12 = neg_F_right_foot_x - left_shank_m1 * a_righ_ankl_cros_x;
  const Scalar neg_F_righ_ankl_cros_x = t_right_foot_12 - left_ankle_cross_h2 * Omega_right_foot_xz;
  const Scalar neg_Omega_right_shank_yy = t_right_shank_8 + t_right_shank_9;
  const Scalar t_right_shank_11 = t_right_hip_fork_16 - neg_Omega_right_shank_yy;
  const Scalar t_righ_ankl_cros_18 = s_right_ankle_pitch * neg_F_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_19 = c_right_ankle_pitch * F_righ_ankl_cros_y - t_righ_ankl_cros_18;
  const Scalar M_right_shank_z_1 = M_righ_ankl_cros_z - left_ankle_cross_l1 * t_righ_ankl_cros_19;
  // right_shank: moment M, force F of (1)
  const Scalar M_right_shank_z_2 = M_right_shank_z_1 + left_shank_I12 * neg_Omega_right_shank_xy;
  const Scalar M_right_shank_z_3 = M_right_shank_z_2 - left_shank_h2 * a_right_shank_x;
  const Scalar M_right_shank_z_4 = t_right_shank_10 - t_right_shank_11;
  const Scalar M_right_shank_z_5 = M_right_shank_z_3 - left_shank_I9 * M_right_shank_z_4;
  const Scalar M_right_shank_z_6 = M_right_shank_z_5 - left_shank_I10 * neg_Omega_right_shank_yz;
  const Scalar M_right_shank_z_7 = M_right_shank_z_6 - left_shank_I13 * neg_Omega_right_shank_yx;
  const Scalar M_right_shank_z = M_right_shank_z_7 + left_shank_I3 * neg_Omega_right_shank_xz;
  tau[15] = M_right_shank_z;
  const Scalar F_right_shank_x_1 = c_right_ankle_pitch * neg_F_righ_ankl_cros_x;
  const Scalar F_right_shank_x_2 = s_right_ankle_pitch * F_righ_ankl_cros_y + F_right_shank_x_1;
  const Scalar F_right_shank_x_3 = F_right_shank_x_2 - left_thigh_m1 * a_right_shank_x;
  const Scalar F_right_shank_x = F_right_shank_x_3 - left_shank_h2 * neg_Omega_right_shank_xy;
  // right_ankle_cross: force F, moment M of (1)
  const Scalar neg_F_right_shank_y_1 =
      t_righ_ankl_cros_19 + left_shank_h2 * neg_Omega_right_shank_yy;
  const Scalar neg_F_right_shank_y = neg_F_right_shank_y_1 - left_thigh_m1 * neg_a_right_shank_y;
  const Scalar F_righ_ankl_cros_z_1 = F_right_foot_y - left_shank_m1 * neg_a_righ_ankl_cros_z;
  const Scalar F_righ_ankl_cros_z =
      F_righ_ankl_cros_z_1 + left_ankle_cross_h2 * Omega_right_foot_yz;
  const Scalar F_right_shank_z_1 = F_righ_ankl_cros_z + left_shank_h2 * Omega_right_shank_zy;
  const Scalar F_right_shank_z = F_right_shank_z_1 + left_thigh_m1 * neg_a_right_shank_z;
  const Scalar neg_M_right_shank_y_1 = s_right_ankle_pitch * M_righ_ankl_cros_x;
  const Scalar neg_M_right_shank_y_2 =
      neg_M_right_shank_y_1 + left_ankle_cross_l1 * F_righ_ankl_cros_z;
  const Scalar neg_M_right_shank_y_3 = neg_M_right_shank_y_2 - left_shank_I10 * t_right_shank_10;
  const Scalar neg_M_right_shank_y_4 = neg_M_right_shank_y_3 + left_shank_I9 * Omega_right_shank_zy;
  const Scalar neg_M_right_shank_y_5 =
      neg_M_right_shank_y_4 + left_shank_I13 * Omega_right_shank_zx;
  const Scalar neg_M_right_shank_y_6 =
      neg_M_right_shank_y_5 + left_shank_I3 * neg_Omega_right_shank_xy;
  const Scalar neg_M_right_shank_y =
      neg_M_right_shank_y_6 + c_right_ankle_pitch * M_righ_ankl_cros_y;
  const Scalar t_right_thigh_10 = t_right_hip_fork_16 - neg_Omega_right_thigh_yy;
  const Scalar neg_M_right_shank_x_1 = c_right_ankle_pitch * M_righ_ankl_cros_x;
  const Scalar neg_M_right_shank_x_2 = neg_M_right_shank_x_1 + left_shank_I3 * t_right_shank_11;
  const Scalar neg_M_right_shank_x_3 =
      neg_M_right_shank_x_2 - left_shank_I10 * neg_Omega_right_shank_yx;
  const Scalar neg_M_right_shank_x_4 =
      neg_M_right_shank_x_3 - left_shank_I12 * Omega_right_shank_zy;
  const Scalar neg_M_right_shank_x_5 = neg_M_right_shank_x_4 - left_shank_I9 * Omega_right_shank_zx;
  const Scalar neg_M_right_shank_x_6 = neg_M_right_shank_x_5 + left_shank_h2 * neg_a_right_shank_z;
  const Scalar neg_M_right_shank_x =
      neg_M_right_shank_x_6 - s_right_ankle_pitch * M_righ_ankl_cros_y;
  const Scalar neg_M_right_thigh_x_1 = left_thigh_I11 * Omega_right_thigh_zy;
  // right_shank: moment M, force F of (1)
  const Scalar neg_M_right_thigh_x_2 = left_thigh_h1 * neg_a_right_thigh_z - neg_M_right_thigh_x_1;
  const Scalar neg_M_right_thigh_x_3 = neg_M_right_thigh_x_2 + left_thigh_I3 * t_right_thigh_10;
  const Scalar neg_M_right_thigh_x_4 = neg_M_right_thigh_x_3 + left_thigh_I9 * Omega_right_thigh_yx;
  const Scalar neg_M_right_thigh_x_5 = neg_M_right_thigh_x_4 - s_right_knee * neg_M_right_shank_y;
  const Scalar neg_M_right_thigh_x_6 = neg_M_right_thigh_x_5 + c_right_knee * neg_M_right_shank_x;
  const Scalar neg_M_right_thigh_x = neg_M_right_thigh_x_6 - left_thigh_I8 * Omega_right_thigh_zx;
  const Scalar t_right_shank_12 = c_right_knee * neg_F_right_shank_y;
  const Scalar t_right_shank_13 = t_right_shank_12 - s_right_knee * F_right_shank_x;
  // right_thigh: moment M, force F of (1)
  const Scalar M_right_thigh_z_1 = M_right_shank_z - left_thigh_h1 * a_right_thigh_x;
  const Scalar M_right_thigh_z_2 = t_right_thigh_9 - t_right_thigh_10;
  const Scalar M_right_thigh_z_3 = M_right_thigh_z_1 - left_thigh_I8 * M_right_thigh_z_2;
  const Scalar M_right_thigh_z_4 = M_right_thigh_z_3 + left_thigh_I11 * neg_Omega_right_thigh_xy;
  const Scalar M_right_thigh_z_5 = M_right_thigh_z_4 - left_shank_l1 * t_right_shank_13;
  const Scalar M_right_thigh_z_6 = M_right_thigh_z_5 + left_thigh_I3 * neg_Omega_right_thigh_xz;
  const Scalar M_right_thigh_z_7 = M_right_thigh_z_6 - left_thigh_I9 * neg_Omega_right_thigh_yz;
  const Scalar M_right_thigh_z = M_right_thigh_z_7 + left_thigh_I12 * Omega_right_thigh_yx;
  tau[14] = M_right_thigh_z;
  const Scalar neg_F_right_thigh_y = t_right_shank_13 + left_thigh_h1 * neg_Omega_right_thigh_yy;
  const Scalar F_right_thigh_x_1 = left_thigh_h1 * neg_Omega_right_thigh_xy;
  const Scalar F_right_thigh_x_2 = s_right_knee * neg_F_right_shank_y - F_right_thigh_x_1;
  const Scalar F_right_thigh_x = F_right_thigh_x_2 + c_right_knee * F_right_shank_x;
  const Scalar F_right_thigh_z = F_right_shank_z + left_thigh_h1 * Omega_right_thigh_zy;
  const Scalar neg_M_right_thigh_y_1 = left_thigh_I12 * Omega_right_thigh_zx;
  // right_shank: moment M of (1)
  const Scalar neg_M_right_thigh_y_2 = neg_M_right_thigh_y_1 - left_thigh_I9 * t_right_thigh_9;
  const Scalar neg_M_right_thigh_y_3 = neg_M_right_thigh_y_2 + left_shank_l1 * F_right_shank_z;
  const Scalar neg_M_right_thigh_y_4 = neg_M_right_thigh_y_3 + c_right_knee * neg_M_right_shank_y;
  const Scalar neg_M_right_thigh_y_5 = neg_M_right_thigh_y_4 + left_thigh_I8 * Omega_right_thigh_zy;
  const Scalar neg_M_right_thigh_y_6 =
      neg_M_right_thigh_y_5 + left_thigh_I3 * neg_Omega_right_thigh_xy;
  const Scalar neg_M_right_thigh_y = neg_M_right_thigh_y_6 + s_right_knee * neg_M_right_shank_x;
  // right_hip_fork: moment M, Omega of (1)
  const Scalar M_right_hip_fork_x_1 = t_right_hip_block_18 - t_right_hip_fork_16;
  const Scalar M_right_hip_fork_x_2 = left_hip_fork_I12 * Omega_right_hip_fork_zy;
  const Scalar M_right_hip_fork_x_3 =
      M_right_hip_fork_x_2 - left_hip_fork_I9 * M_right_hip_fork_x_1;
  const Scalar M_right_hip_fork_x_4 =
      M_right_hip_fork_x_3 + s_right_hip_pitch * neg_M_right_thigh_y;
  const Scalar M_right_hip_fork_x_5 = M_right_hip_fork_x_4 - left_hip_fork_h3 * a_right_hip_fork_z;
  const Scalar M_right_hip_fork_x_6 =
      M_right_hip_fork_x_5 - left_hip_fork_I11 * Omega_right_hip_fork_yx;
  const Scalar M_right_hip_fork_x_7 = M_right_hip_fork_x_6 + left_hip_fork_l1 * F_right_thigh_z;
  const Scalar M_right_hip_fork_x_8 =
      M_right_hip_fork_x_7 - c_right_hip_pitch * neg_M_right_thigh_x;
  const Scalar M_right_hip_fork_x = M_right_hip_fork_x_8 - left_hip_fork_I8 * t_right_hip_fork_12;
  const Scalar t_right_hip_fork_18 = t_right_hip_fork_14 - t_right_hip_fork_15;
  const Scalar t_right_hip_fork_19 = t_right_hip_block_18 - t_right_hip_fork_18;
  const Scalar t_right_hip_fork_20 = left_hip_fork_h3 * neg_a_right_hip_fork_x;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_16 - t_right_hip_fork_19;
  // right_thigh: moment M, force F of (1)
  const Scalar t_right_thigh_11 = t_right_hip_fork_20 + c_right_hip_pitch * neg_M_right_thigh_y;
  const Scalar t_right_thigh_12 = t_right_thigh_11 + left_hip_fork_I8 * t_right_hip_fork_21;
  const Scalar t_right_thigh_13 = t_right_thigh_12 + left_hip_fork_I12 * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_14 = t_right_thigh_13 + s_right_hip_pitch * neg_M_right_thigh_x;
  const Scalar t_right_thigh_15 = t_right_thigh_14 - left_hip_fork_I10 * Omega_right_hip_fork_yx;
  const Scalar t_right_thigh_16 = t_right_thigh_15 + left_hip_fork_I11 * t_right_hip_fork_2;
  const Scalar t_right_thigh_17 = t_right_thigh_16 - left_hip_fork_h2 * a_right_hip_fork_y;
  const Scalar neg_M_right_hip_fork_z = t_right_thigh_17 - left_hip_fork_I9 * t_right_hip_fork_7;
  tau[13] = -neg_M_right_hip_fork_z;
  const Scalar t_right_thigh_18 = s_right_hip_pitch * neg_F_right_thigh_y;
  const Scalar t_right_thigh_19 = c_right_hip_pitch * F_right_thigh_x + t_right_thigh_18;
  const Scalar t_right_thigh_20 = F_right_thigh_z - left_hip_fork_h3 * t_right_hip_fork_16;
  const Scalar neg_F_right_hip_fork_y =
      t_right_thigh_20 - left_hip_fork_h2 * Omega_right_hip_fork_yx;
  const Scalar t_right_hip_block_19 = t_right_hip_block_16 - t_right_hip_block_17;
  const Scalar t_right_hip_block_20 = neg_Omega_base_rx_yy - t_right_hip_block_19;
  const Scalar t_right_thigh_21 = M_right_thigh_z + left_hip_fork_I8 * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_22 = t_right_thigh_21 - left_hip_fork_l1 * t_right_thigh_19;
  const Scalar t_right_thigh_23 = t_right_thigh_22 - left_hip_fork_I9 * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_24 = t_right_thigh_23 - left_hip_fork_I11 * t_right_hip_fork_18;
  const Scalar t_right_thigh_25 = t_right_thigh_24 + left_hip_fork_h2 * a_right_hip_fork_z;
  const Scalar neg_M_right_hip_fork_y = t_right_thigh_25 - left_hip_fork_I10 * t_right_hip_fork_12;
  const Scalar t_right_hip_block_21 = t_right_hip_block_18 - t_right_hip_block_20;
  const Scalar t_right_hip_block_22 = left_hip_block_I8 * t_right_hip_block_21;
  // right_hip_fork: moment M of (1)
  const Scalar t_right_hip_fork_22 =
      t_right_hip_block_22 - s_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar t_right_hip_fork_23 =
      t_right_hip_fork_22 + left_hip_block_h4 * neg_a_right_hip_block_x;
  const Scalar t_right_hip_fork_24 =
      t_right_hip_fork_23 - left_hip_block_I17 * t_right_hip_block_14;
  const Scalar t_right_hip_fork_25 = t_right_hip_fork_24 - c_right_hip_roll * M_right_hip_fork_x;
  const Scalar t_right_hip_fork_26 = t_right_hip_fork_25 - left_hip_block_I16 * t_right_hip_block_5;
  const Scalar t_right_hip_fork_27 =
      t_right_hip_fork_26 + left_hip_block_I10 * t_right_hip_block_15;
  const Scalar t_right_hip_fork_28 = t_right_hip_fork_27 - left_hip_block_h1 * a_right_hip_fork_z;
  const Scalar neg_M_right_hip_block_z =
      t_right_hip_fork_28 - left_hip_block_I15 * Omega_right_hip_block_xz;
  tau[12] = -neg_M_right_hip_block_z;
  // right_hip_block: moment M of (1)
  const Scalar M_right_hip_block_y_1 =
      neg_M_right_hip_fork_z - left_hip_block_I10 * Omega_right_hip_block_zx;
  const Scalar M_right_hip_block_y_2 =
      M_right_hip_block_y_1 - left_hip_block_I16 * t_right_hip_block_19;
  const Scalar M_right_hip_block_y_3 =
      M_right_hip_block_y_2 - left_hip_block_h1 * neg_a_right_hip_block_z;
  const Scalar M_right_hip_block_y_4 =
      M_right_hip_block_y_3 - left_hip_block_I8 * Omega_right_hip_block_zy;
  const Scalar M_right_hip_block_y =
      M_right_hip_block_y_4 + left_hip_block_I15 * t_right_hip_block_14;
  // right_hip_fork: force F of (1)
  const Scalar F_right_hip_fork_x_1 = t_right_thigh_19 - left_hip_fork_h3 * Omega_right_hip_fork_xy;
  const Scalar F_right_hip_fork_x = F_right_hip_fork_x_1 - left_hip_fork_h2 * t_right_hip_fork_19;
  const Scalar t_right_hip_fork_29 = c_right_hip_roll * neg_F_right_hip_fork_y;
  const Scalar t_right_hip_fork_30 = s_right_hip_roll * F_right_hip_fork_x - t_right_hip_fork_29;
  const Scalar t_right_hip_fork_31 = t_right_hip_fork_30 - left_hip_block_h1 * t_right_hip_block_20;
  const Scalar neg_F_right_hip_block_x =
      t_right_hip_fork_31 - left_hip_block_h4 * t_right_hip_block_14;
  const Scalar F_right_hip_block_y_1 = left_hip_fork_h3 * Omega_right_hip_fork_zy;
  // right_hip_block: force F of (1)
  const Scalar F_right_hip_block_y_2 =
      F_right_hip_block_y_1 + left_hip_block_h1 * t_right_hip_block_15;
  const Scalar F_right_hip_block_y_3 =
      F_right_hip_block_y_2 + left_hip_fork_h2 * t_right_hip_fork_12;
  const Scalar F_right_hip_block_y_4 =
      F_right_hip_block_y_3 + c_right_hip_pitch * neg_F_right_thigh_y;
  const Scalar F_right_hip_block_y_5 =
      F_right_hip_block_y_4 + left_hip_block_h4 * t_right_hip_block_18;
  const Scalar F_right_hip_block_y = F_right_hip_block_y_5 - s_right_hip_pitch * F_right_thigh_x;
  const Scalar t_left_ankle_cross_21 = t_left_hip_fork_18 - t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_22 = left_ankle_cross_h2 * neg_a_left_ankle_cross_x;
  // left_foot: moment M, Omega, force F of (1)
  const Scalar t_left_foot_12 = left_ankle_cross_I8 * t_left_ankle_cross_2 + t_left_ankle_cross_22;
  const Scalar t_left_foot_13 = t_left_foot_12 + neg_Omega_left_foot_zy * t_left_foot_7;
  const Scalar t_left_foot_14 = t_left_foot_13 + left_ankle_cross_I6 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_23 = t_left_ankle_cross_18 - t_left_ankle_cross_21;
  const Scalar t_left_foot_15 = t_left_foot_14 - neg_a_left_foot_z * t_left_foot_8;
  const Scalar t_left_foot_16 = t_left_foot_15 - left_ankle_cross_I7 * t_left_ankle_cross_23;
  const Scalar t_left_foot_17 = t_left_foot_16 - left_ankle_cross_I9 * t_left_ankle_cross_15;
  const Scalar t_left_foot_18 = t_left_foot_17 - left_hip_fork_l1 * neg_F_left_foot_z;
  const Scalar t_left_foot_19 = t_left_foot_18 + neg_Omega_left_foot_xy * t_left_foot_6;
  const Scalar t_left_foot_20 = t_left_ankle_cross_16 - t_left_foot_2;
  const Scalar t_left_foot_21 = t_left_foot_19 - t_left_foot_5 * t_left_foot_20;
  const Scalar t_left_foot_22 = t_left_foot_21 + Omega_left_foot_zx * t_left_foot_10;
  const Scalar neg_M_left_ankle_cross_z =
      t_left_foot_22 - left_ankle_cross_I1 * t_left_ankle_cross_7;
  tau[10] = -neg_M_left_ankle_cross_z;
  const Scalar neg_Omega_left_foot_yy = t_left_ankle_cross_16 + t_left_foot_2;
  const Scalar t_left_ankle_cross_24 = left_ankle_cross_h2 * neg_a_left_ankle_cross_z;
  const Scalar t_left_foot_23 = neg_a_left_foot_z * t_left_foot_9 - t_left_ankle_cross_24;
  const Scalar t_left_foot_24 = t_left_foot_23 - left_hip_fork_l3 * neg_F_left_foot_z;
  const Scalar t_left_foot_25 = t_left_foot_24 + Omega_left_foot_yx * t_left_foot_5;
  const Scalar t_left_foot_26 = t_left_foot_25 - left_ankle_cross_I8 * t_left_ankle_cross_15;
  const Scalar t_left_foot_27 = t_left_ankle_cross_19 - neg_Omega_left_foot_yy;
  const Scalar t_left_foot_28 = t_left_foot_26 + left_ankle_cross_I7 * t_left_ankle_cross_11;
  const Scalar t_left_foot_29 = t_left_foot_28 + t_left_foot_6 * t_left_foot_27;
  const Scalar t_left_foot_30 = t_left_foot_29 + neg_Omega_left_foot_zy * t_left_foot_11;
  const Scalar t_left_foot_31 = t_left_foot_30 + left_ankle_cross_I1 * t_left_ankle_cross_21;
  const Scalar t_left_foot_32 = t_left_foot_31 + Omega_left_foot_zx * t_left_foot_7;
  const Scalar neg_M_left_ankle_cross_x = t_left_foot_32 + left_ankle_cross_I6 * Omega_left_foot_yz;
  const Scalar t_left_ankle_cross_25 = neg_F_left_foot_z + left_shank_m1 * a_left_ankle_cross_y;
  const Scalar F_left_ankle_cross_y =
      t_left_ankle_cross_25 + left_ankle_cross_h2 * t_left_ankle_cross_19;
  const Scalar neg_F_left_foot_y_1 = t_left_foot_9 * neg_Omega_left_foot_yy;
  const Scalar neg_F_left_foot_y_2 = left_ankle_cross_m1 * neg_a_left_foot_y + neg_F_left_foot_y_1;
  const Scalar neg_F_left_foot_y = neg_F_left_foot_y_2 - Omega_left_foot_yx * t_left_foot_8;
  const Scalar t_left_foot_33 = neg_F_left_foot_y - left_ankle_cross_h2 * Omega_left_foot_yz;
  const Scalar neg_F_left_ankle_cross_z = t_left_foot_33 + left_shank_m1 * neg_a_left_ankle_cross_z;
  const Scalar t_left_foot_34 = neg_F_left_foot_x + left_ankle_cross_h2 * t_left_ankle_cross_14;
  const Scalar neg_F_left_ankle_cross_x = t_left_foot_34 + left_shank_m1 * neg_a_left_ankle_cross_x;
  // left_ankle_cross: moment M of (1)
  const Scalar t_left_ankle_cross_26 = neg_M_left_foot_z + left_hip_fork_l3 * neg_F_left_foot_x;
  const Scalar t_left_ankle_cross_27 =
      t_left_ankle_cross_26 - left_ankle_cross_I9 * t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_28 = t_left_ankle_cross_27 + left_hip_fork_l1 * neg_F_left_foot_y;
  const Scalar t_left_ankle_cross_29 =
      t_left_ankle_cross_28 - left_ankle_cross_I8 * t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_30 =
      t_left_ankle_cross_29 + left_ankle_cross_I1 * t_left_ankle_cross_14;
  const Scalar M_left_ankle_cross_y =
      t_left_ankle_cross_30 - left_ankle_cross_I7 * Omega_left_foot_yz;
  const Scalar M_left_shank_y_1 = left_ankle_cross_l1 * neg_F_left_ankle_cross_z;
  // left_shank: moment M, Omega of (1)
  const Scalar M_left_shank_y_2 = s_left_ankle_pitch * neg_M_left_ankle_cross_x + M_left_shank_y_1;
  const Scalar M_left_shank_y_3 = M_left_shank_y_2 - left_shank_I9 * Omega_left_shank_zy;
  const Scalar M_left_shank_y_4 = M_left_shank_y_3 - c_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar M_left_shank_y_5 = M_left_shank_y_4 - left_shank_I10 * t_left_shank_10;
  const Scalar M_left_shank_y_6 = M_left_shank_y_5 - left_shank_I3 * Omega_left_shank_xy;
  const Scalar M_left_shank_y = M_left_shank_y_6 + left_shank_I13 * neg_Omega_left_shank_zx;
  const Scalar neg_Omega_left_shank_yy = t_left_shank_8 + t_left_shank_9;
  const Scalar M_left_shank_x_1 = c_left_ankle_pitch * neg_M_left_ankle_cross_x;
  const Scalar M_left_shank_x_2 = M_left_shank_x_1 + s_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar M_left_shank_x_3 = t_left_hip_fork_18 - neg_Omega_left_shank_yy;
  const Scalar M_left_shank_x_4 = M_left_shank_x_2 - left_shank_h2 * neg_a_left_shank_z;
  const Scalar M_left_shank_x_5 = M_left_shank_x_4 + left_shank_I3 * M_left_shank_x_3;
  const Scalar M_left_shank_x_6 = M_left_shank_x_5 + left_shank_I10 * Omega_left_shank_yx;
  const Scalar M_left_shank_x_7 = M_left_shank_x_6 + left_shank_I12 * Omega_left_shank_zy;
  const Scalar M_left_shank_x = M_left_shank_x_7 - left_shank_I9 * neg_Omega_left_shank_zx;
  const Scalar t_left_ankle_cross_31 = s_left_ankle_pitch * neg_F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_32 =
      t_left_ankle_cross_31 - c_left_ankle_pitch * F_left_ankle_cross_y;
  const Scalar neg_M_left_shank_z_1 = neg_Omega_left_shank_xx - neg_Omega_left_shank_yy;
  // left_ankle_cross: moment M, force F of (1)
  const Scalar neg_M_left_shank_z_2 =
      neg_M_left_ankle_cross_z - left_shank_I13 * Omega_left_shank_yx;
  const Scalar neg_M_left_shank_z_3 = neg_M_left_shank_z_2 - left_shank_I9 * neg_M_left_shank_z_1;
  const Scalar neg_M_left_shank_z_4 = neg_M_left_shank_z_3 + left_shank_h2 * a_left_shank_x;
  const Scalar neg_M_left_shank_z_5 = neg_M_left_shank_z_4 - left_shank_I3 * Omega_left_shank_xz;
  const Scalar neg_M_left_shank_z_6 =
      neg_M_left_shank_z_5 - left_ankle_cross_l1 * t_left_ankle_cross_32;
  const Scalar neg_M_left_shank_z_7 = neg_M_left_shank_z_6 + left_shank_I12 * Omega_left_shank_xy;
  const Scalar neg_M_left_shank_z = neg_M_left_shank_z_7 - left_shank_I10 * neg_Omega_left_shank_yz;
  tau[9] = -neg_M_left_shank_z;
  const Scalar neg_F_left_shank_x_1 = c_left_ankle_pitch * neg_F_left_ankle_cross_x;
  const Scalar neg_F_left_shank_x_2 = left_thigh_m1 * a_left_shank_x - neg_F_left_shank_x_1;
  const Scalar neg_F_left_shank_x_3 =
      neg_F_left_shank_x_2 - s_left_ankle_pitch * F_left_ankle_cross_y;
  const Scalar neg_F_left_shank_x = neg_F_left_shank_x_3 - left_shank_h2 * Omega_left_shank_xy;
  const Scalar F_left_shank_y_1 = t_left_ankle_cross_32 + left_thigh_m1 * neg_a_left_shank_y;
  const Scalar F_left_shank_y = F_left_shank_y_1 - left_shank_h2 * neg_Omega_left_shank_yy;
  const Scalar neg_F_left_shank_z_1 =
      neg_F_left_ankle_cross_z - left_shank_h2 * Omega_left_shank_zy;
  const Scalar neg_F_left_shank_z = neg_F_left_shank_z_1 - left_thigh_m1 * neg_a_left_shank_z;
  // left_thigh
  const Scalar neg_M_left_thigh_x_1 = left_thigh_I11 * Omega_left_thigh_zy;
  const Scalar neg_M_left_thigh_x_2 = left_thigh_h1 * neg_a_left_thigh_z - neg_M_left_thigh_x_1;
  const Scalar neg_M_left_thigh_x_3 =
      neg_M_left_thigh_x_2 + left_thigh_I8 * neg_Omega_left_thigh_zx;
  const Scalar neg_M_left_thigh_x_4 = t_left_hip_fork_18 - neg_Omega_left_thigh_yy;
  const Scalar neg_M_left_thigh_x_5 =
      neg_M_left_thigh_x_3 + left_thigh_I9 * neg_Omega_left_thigh_yx;
  const Scalar neg_M_left_thigh_x_6 = neg_M_left_thigh_x_5 - left_thigh_I3 * neg_M_left_thigh_x_4;
  // left_shank: moment M, force F of (1)
  const Scalar neg_M_left_thigh_x_7 = neg_M_left_thigh_x_6 - c_left_knee * M_left_shank_x;
  const Scalar neg_M_left_thigh_x = neg_M_left_thigh_x_7 + s_left_knee * M_left_shank_y;
  const Scalar t_left_shank_11 = c_left_knee * F_left_shank_y - s_left_knee * neg_F_left_shank_x;
  const Scalar neg_M_left_thigh_z_1 = neg_M_left_shank_z + left_thigh_h1 * a_left_thigh_x;
  const Scalar neg_M_left_thigh_z_2 =
      neg_M_left_thigh_z_1 + left_thigh_I12 * neg_Omega_left_thigh_yx;
  const Scalar neg_M_left_thigh_z_3 = neg_M_left_thigh_z_2 - left_shank_l1 * t_left_shank_11;
  const Scalar neg_M_left_thigh_z_4 = neg_Omega_left_thigh_yy - neg_Omega_left_thigh_xx;
  const Scalar neg_M_left_thigh_z_5 =
      neg_M_left_thigh_z_3 - left_thigh_I11 * neg_Omega_left_thigh_xy;
  const Scalar neg_M_left_thigh_z_6 = neg_M_left_thigh_z_5 + left_thigh_I8 * neg_M_left_thigh_z_4;
  const Scalar neg_M_left_thigh_z_7 =
      neg_M_left_thigh_z_6 - left_thigh_I9 * neg_Omega_left_thigh_yz;
  const Scalar neg_M_left_thigh_z = neg_M_left_thigh_z_7 - left_thigh_I3 * Omega_left_thigh_xz;
  tau[8] = -neg_M_left_thigh_z;
  const Scalar F_left_thigh_y = t_left_shank_11 - left_thigh_h1 * neg_Omega_left_thigh_yy;
  const Scalar neg_F_left_thigh_z = neg_F_left_shank_z - left_thigh_h1 * Omega_left_thigh_zy;
  const Scalar t_left_hip_fork_19 = t_left_hip_fork_16 - t_left_hip_fork_17;
  const Scalar t_left_hip_fork_20 = t_left_hip_block_21 - t_left_hip_fork_19;
  // left_thigh: moment M of (1)
  const Scalar M_left_thigh_y_1 = left_thigh_I12 * neg_Omega_left_thigh_zx;
  const Scalar M_left_thigh_y_2 = M_left_thigh_y_1 + c_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_y_3 = M_left_thigh_y_2 - left_thigh_I9 * t_left_thigh_9;
  const Scalar M_left_thigh_y_4 = M_left_thigh_y_3 + left_shank_l1 * neg_F_left_shank_z;
  const Scalar M_left_thigh_y_5 = M_left_thigh_y_4 + left_thigh_I3 * neg_Omega_left_thigh_xy;
  const Scalar M_left_thigh_y_6 = M_left_thigh_y_5 + s_left_knee * M_left_shank_x;
  const Scalar M_left_thigh_y = M_left_thigh_y_6 - left_thigh_I8 * Omega_left_thigh_zy;
  const Scalar t_left_hip_fork_21 = t_left_hip_fork_18 - t_left_hip_fork_20;
  const Scalar t_left_hip_fork_22 = left_hip_fork_I8 * t_left_hip_fork_21;
  const Scalar t_left_thigh_10 = left_hip_fork_h3 * a_left_hip_fork_x - t_left_hip_fork_22;
  const Scalar t_left_thigh_11 = t_left_thigh_10 - left_hip_fork_I13 * alpha_left_hip_fork_z;
  const Scalar t_left_thigh_12 = t_left_thigh_11 - left_hip_fork_h2 * a_left_hip_fork_y;
  const Scalar t_left_thigh_13 = t_left_thigh_12 - left_hip_fork_I14 * t_left_hip_fork_13;
  const Scalar t_left_thigh_14 = t_left_thigh_13 - c_left_hip_pitch * M_left_thigh_y;
  const Scalar t_left_thigh_15 = t_left_thigh_14 - left_hip_fork_I11 * Omega_left_hip_fork_yz;
  const Scalar t_left_thigh_16 = t_left_thigh_15 + s_left_hip_pitch * neg_M_left_thigh_x;
  const Scalar neg_M_left_hip_fork_z = t_left_thigh_16 + left_hip_fork_I9 * t_left_hip_fork_8;
  tau[7] = -neg_M_left_hip_fork_z;
  const Scalar F_left_hip_fork_y_1 = neg_F_left_thigh_z - left_hip_fork_h2 * t_left_hip_fork_14;
  const Scalar F_left_hip_fork_y = F_left_hip_fork_y_1 - left_hip_fork_h3 * t_left_hip_fork_18;
  // left_hip_block: Omega of (1)
  const Scalar t_left_hip_block_22 = t_left_hip_block_17 - t_left_hip_block_18;
  const Scalar t_left_hip_block_23 = neg_Omega_base_rx_yy - t_left_hip_block_22;
  const Scalar t_left_hip_block_24 = t_left_hip_block_21 - t_left_hip_block_23;
  const Scalar neg_F_left_thigh_x_1 = left_thigh_h1 * neg_Omega_left_thigh_xy;
  const Scalar neg_F_left_thigh_x_2 = neg_F_left_thigh_x_1 + s_left_knee * F_left_shank_y;
  const Scalar neg_F_left_thigh_x = neg_F_left_thigh_x_2 + c_left_knee * neg_F_left_shank_x;
  const Scalar t_left_thigh_17 = c_left_hip_pitch * neg_F_left_thigh_x;
  const Scalar t_left_thigh_18 = t_left_thigh_17 + s_left_hip_pitch * F_left_thigh_y;
  const Scalar t_left_hip_fork_23 = left_hip_fork_I11 * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_24 = t_left_hip_block_21 - t_left_hip_fork_18;
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_19 = left_hip_fork_l1 * neg_F_left_thigh_z - t_left_hip_fork_23;
  const Scalar t_left_thigh_20 = t_left_thigh_19 - left_hip_fork_I9 * t_left_hip_fork_24;
  const Scalar t_left_thigh_21 = t_left_thigh_20 + s_left_hip_pitch * M_left_thigh_y;
  const Scalar t_left_thigh_22 = t_left_thigh_21 + c_left_hip_pitch * neg_M_left_thigh_x;
  const Scalar t_left_thigh_23 = t_left_thigh_22 + left_hip_fork_I12 * t_left_hip_fork_6;
  const Scalar t_left_thigh_24 = t_left_thigh_23 - left_hip_fork_I8 * t_left_hip_fork_12;
  const Scalar neg_M_left_hip_fork_x = t_left_thigh_24 + left_hip_fork_h3 * a_left_hip_block_y;
  // left_hip_fork: moment M of (1)
  const Scalar M_left_hip_fork_y_1 = neg_M_left_thigh_z + left_hip_fork_I9 * t_left_hip_fork_15;
  const Scalar M_left_hip_fork_y_2 = M_left_hip_fork_y_1 + left_hip_fork_I10 * t_left_hip_fork_12;
  const Scalar M_left_hip_fork_y_3 = M_left_hip_fork_y_2 + left_hip_fork_I11 * t_left_hip_fork_19;
  const Scalar M_left_hip_fork_y_4 = M_left_hip_fork_y_3 - left_hip_fork_l1 * t_left_thigh_18;
  const Scalar M_left_hip_fork_y_5 = M_left_hip_fork_y_4 + left_hip_fork_h2 * a_left_hip_block_y;
  const Scalar M_left_hip_fork_y = M_left_hip_fork_y_5 - left_hip_fork_I8 * t_left_hip_fork_6;
  const Scalar t_left_hip_block_25 = left_hip_block_h4 * neg_a_left_hip_block_x;
  const Scalar t_left_hip_fork_25 = t_left_hip_block_25 - left_hip_block_I8 * t_left_hip_block_24;
  const Scalar t_left_hip_fork_26 = t_left_hip_fork_25 + left_hip_block_I16 * t_left_hip_block_14;
  const Scalar t_left_hip_fork_27 =
      t_left_hip_fork_26 + left_hip_block_I17 * Omega_left_hip_block_xy;
  const Scalar t_left_hip_fork_28 =
      t_left_hip_fork_27 - left_hip_block_I10 * Omega_left_hip_block_yx;
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_28 + c_left_hip_roll * neg_M_left_hip_fork_x;
  const Scalar t_left_hip_fork_30 =
      t_left_hip_fork_29 - left_hip_block_I15 * Omega_left_hip_block_xz;
  const Scalar t_left_hip_fork_31 = t_left_hip_fork_30 + s_left_hip_roll * M_left_hip_fork_y;
  const Scalar neg_M_left_hip_block_z = t_left_hip_fork_31 - left_hip_block_h1 * a_left_hip_block_y;
  tau[6] = -neg_M_left_hip_block_z;
  const Scalar t_left_thigh_25 = t_left_thigh_18 + left_hip_fork_h2 * t_left_hip_fork_20;
  const Scalar neg_F_left_hip_fork_x = t_left_thigh_25 + left_hip_fork_h3 * t_left_hip_fork_15;
  // left_hip_block: force F of (1)
  const Scalar F_left_hip_block_y_1 = left_hip_block_h1 * Omega_left_hip_block_yx;
  const Scalar F_left_hip_block_y_2 =
      left_hip_block_h4 * t_left_hip_block_21 + F_left_hip_block_y_1;
  const Scalar F_left_hip_block_y_3 = F_left_hip_block_y_2 - c_left_hip_pitch * F_left_thigh_y;
  const Scalar F_left_hip_block_y_4 = F_left_hip_block_y_3 + s_left_hip_pitch * neg_F_left_thigh_x;
  const Scalar F_left_hip_block_y_5 = F_left_hip_block_y_4 + left_hip_fork_h2 * t_left_hip_fork_12;
  const Scalar F_left_hip_block_y = F_left_hip_block_y_5 + left_hip_fork_h3 * t_left_hip_fork_6;
  const Scalar t_base_rx_7 = neg_Omega_base_ry_yy - neg_Omega_base_rx_yy;
  const Scalar M_base_ry_y_1 = t_base_rx_5 - t_base_rx_7;
  const Scalar t_left_hip_block_26 = neg_Omega_base_rx_yy - t_left_hip_block_21;
  const Scalar t_left_hip_block_27 = left_hip_block_I8 * Omega_left_hip_block_zx;
  // left_hip_fork: moment M of (1)
  const Scalar t_left_hip_fork_32 = t_left_hip_block_27 - left_hip_block_I15 * t_left_hip_block_26;
  const Scalar t_left_hip_fork_33 = t_left_hip_fork_32 - s_left_hip_roll * neg_M_left_hip_fork_x;
  const Scalar t_left_hip_fork_34 =
      t_left_hip_fork_33 - left_hip_block_I17 * Omega_left_hip_block_zy;
  const Scalar t_left_hip_fork_35 = t_left_hip_fork_34 + left_hip_block_h4 * a_left_hip_block_z;
  const Scalar t_left_hip_fork_36 =
      t_left_hip_fork_35 + left_hip_block_I16 * Omega_left_hip_block_yx;
  const Scalar neg_M_left_hip_block_x = t_left_hip_fork_36 + c_left_hip_roll * M_left_hip_fork_y;
  // left_hip_block: force F of (1)
  const Scalar F_left_hip_block_z_1 = left_hip_block_h1 * Omega_left_hip_block_zx;
  const Scalar F_left_hip_block_z_2 =
      F_left_hip_block_z_1 - c_left_hip_roll * neg_F_left_hip_fork_x;
  const Scalar F_left_hip_block_z_3 =
      F_left_hip_block_z_2 - left_hip_block_h4 * Omega_left_hip_block_zy;
  const Scalar F_left_hip_block_z = F_left_hip_block_z_3 - s_left_hip_roll * F_left_hip_fork_y;
  const Scalar F_right_hip_block_z_1 = s_right_hip_roll * neg_F_right_hip_fork_y;
  const Scalar F_right_hip_block_z_2 =
      F_right_hip_block_z_1 + c_right_hip_roll * F_right_hip_fork_x;
  const Scalar F_right_hip_block_z_3 =
      F_right_hip_block_z_2 - left_hip_block_h1 * Omega_right_hip_block_zx;
  const Scalar F_right_hip_block_z =
      F_right_hip_block_z_3 - left_hip_block_h4 * Omega_right_hip_block_zy;
  const Scalar F_left_hip_block_x_1 = s_left_hip_roll * neg_F_left_hip_fork_x;
  const Scalar F_left_hip_block_x_2 = F_left_hip_block_x_1 - c_left_hip_roll * F_left_hip_fork_y;
  const Scalar F_left_hip_block_x_3 =
      F_left_hip_block_x_2 - left_hip_block_h1 * t_left_hip_block_23;
  const Scalar F_left_hip_block_x =
      F_left_hip_block_x_3 - left_hip_block_h4 * Omega_left_hip_block_xy;
  const Scalar t_right_hip_block_23 = c_right_hip_yaw * neg_F_right_hip_block_x;
  const Scalar t_right_hip_block_24 = s_right_hip_yaw * F_right_hip_block_y + t_right_hip_block_23;
  const Scalar t_base_ry_1 = t_right_hip_block_24 + s_left_hip_yaw * F_left_hip_block_y;
  const Scalar t_base_ry_2 = t_base_ry_1 - c_left_hip_yaw * F_left_hip_block_x;
  const Scalar t_right_hip_block_25 = left_hip_block_I8 * Omega_right_hip_block_zx;
  // right_hip_fork: moment M of (1)
  const Scalar t_right_hip_fork_32 =
      left_hip_block_I16 * t_right_hip_block_15 - t_right_hip_block_25;
  const Scalar t_right_hip_fork_33 =
      t_right_hip_fork_32 - c_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar t_right_hip_fork_34 = t_right_hip_fork_33 + s_right_hip_roll * M_right_hip_fork_x;
  const Scalar t_right_hip_block_26 = neg_Omega_base_rx_yy - t_right_hip_block_18;
  const Scalar t_right_hip_fork_35 =
      t_right_hip_fork_34 - left_hip_block_h4 * neg_a_right_hip_block_z;
  const Scalar t_right_hip_fork_36 =
      t_right_hip_fork_35 - left_hip_block_I15 * t_right_hip_block_26;
  const Scalar neg_M_right_hip_block_x =
      t_right_hip_fork_36 - left_hip_block_I17 * Omega_right_hip_block_zy;
  // left_hip_block: moment M of (1)
  const Scalar M_left_hip_block_y_1 =
      neg_M_left_hip_fork_z - left_hip_block_h1 * a_left_hip_block_z;
  const Scalar M_left_hip_block_y_2 =
      M_left_hip_block_y_1 - left_hip_block_I15 * Omega_left_hip_block_xy;
  const Scalar M_left_hip_block_y_3 =
      M_left_hip_block_y_2 + left_hip_block_I16 * t_left_hip_block_22;
  const Scalar M_left_hip_block_y_4 =
      M_left_hip_block_y_3 - left_hip_block_I10 * Omega_left_hip_block_zx;
  const Scalar M_left_hip_block_y =
      M_left_hip_block_y_4 + left_hip_block_I8 * Omega_left_hip_block_zy;
  // base_ry: moment M of (1)
  const Scalar M_base_ry_y_2 = base_rx_I4 * M_base_ry_y_1 - base_rx_h1 * neg_a_base_rx_y;
  const Scalar M_base_ry_y_3 = M_base_ry_y_2 + base_rx_h6 * neg_a_base_rx_x;
  const Scalar M_base_ry_y_4 = M_base_ry_y_3 - s_left_hip_yaw * neg_M_left_hip_block_x;
  const Scalar M_base_ry_y_5 = M_base_ry_y_4 + c_right_hip_yaw * M_right_hip_block_y;
  const Scalar M_base_ry_y_6 = F_left_hip_block_z - F_right_hip_block_z;
  const Scalar M_base_ry_y_7 = M_base_ry_y_5 - left_hip_block_l1 * M_base_ry_y_6;
  const Scalar M_base_ry_y_8 = M_base_ry_y_7 - left_hip_block_l2 * t_base_ry_2;
  const Scalar M_base_ry_y_9 = M_base_ry_y_8 + c_left_hip_yaw * M_left_hip_block_y;
  const Scalar M_base_ry_y_10 = M_base_ry_y_9 + base_rx_I12 * Omega_base_rx_xy;
  const Scalar M_base_ry_y_11 = M_base_ry_y_10 - s_right_hip_yaw * neg_M_right_hip_block_x;
  const Scalar M_base_ry_y_12 = M_base_ry_y_11 - base_rx_I5 * Omega_base_rx_xz;
  const Scalar M_base_ry_y_13 = M_base_ry_y_12 - base_rx_I11 * Omega_base_rx_yx;
  const Scalar M_base_ry_y = M_base_ry_y_13 + base_rx_I6 * Omega_base_rx_yz;
  tau[5] = -M_base_ry_y;
  const Scalar t_left_hip_block_28 = s_left_hip_yaw * F_left_hip_block_x;
  const Scalar t_left_hip_block_29 = t_left_hip_block_28 + c_left_hip_yaw * F_left_hip_block_y;
  const Scalar t_right_hip_block_27 = s_right_hip_yaw * neg_F_right_hip_block_x;
  const Scalar t_right_hip_block_28 = c_right_hip_yaw * F_right_hip_block_y - t_right_hip_block_27;
  // base_rx: moment M, force F of (1)
  const Scalar t_base_rx_8 = t_left_hip_block_29 + t_right_hip_block_28;
  const Scalar M_base_rx_x_1 = base_rx_I5 * t_base_rx_7 + base_rx_I6 * Omega_base_rx_yx;
  const Scalar M_base_rx_x_2 = M_base_rx_x_1 + s_right_hip_yaw * M_right_hip_block_y;
  const Scalar M_base_rx_x_3 = M_base_rx_x_2 + s_left_hip_yaw * M_left_hip_block_y;
  const Scalar M_base_rx_x_4 = M_base_rx_x_3 + c_left_hip_yaw * neg_M_left_hip_block_x;
  const Scalar M_base_rx_x_5 = M_base_rx_x_4 - base_rx_h6 * a_base_rx_z;
  const Scalar M_base_rx_x_6 = M_base_rx_x_5 + left_hip_block_l2 * t_base_rx_8;
  const Scalar M_base_rx_x_7 = M_base_rx_x_6 - base_rx_I12 * neg_Omega_base_rx_zy;
  const Scalar M_base_rx_x_8 = M_base_rx_x_7 + base_rx_I4 * Omega_base_rx_zx;
  const Scalar M_base_rx_x = M_base_rx_x_8 + c_right_hip_yaw * neg_M_right_hip_block_x;
  const Scalar M_base_rx_y_1 = neg_M_right_hip_block_z + neg_M_left_hip_block_z;
  const Scalar M_base_rx_y_2 = M_base_rx_y_1 - base_rx_I5 * Omega_base_rx_xy;
  const Scalar M_base_rx_y_3 = M_base_rx_y_2 + base_rx_h1 * a_base_rx_z;
  const Scalar M_base_rx_y_4 = M_base_rx_y_3 - base_rx_I11 * Omega_base_rx_zx;
  const Scalar M_base_rx_y_5 = M_base_rx_y_4 - base_rx_I6 * t_base_rx_5;
  const Scalar M_base_rx_y_6 = t_left_hip_block_29 - t_right_hip_block_28;
  const Scalar M_base_rx_y_7 = M_base_rx_y_5 + base_rx_I4 * neg_Omega_base_rx_zy;
  const Scalar M_base_rx_y = M_base_rx_y_7 - left_hip_block_l1 * M_base_rx_y_6;
  const Scalar F_base_rx_x_1 = t_base_ry_2 - base_rx_h6 * Omega_base_rx_xy;
  const Scalar F_base_rx_x = F_base_rx_x_1 + base_rx_h1 * neg_Omega_base_rx_xx;
  const Scalar M_base_rz_y_1 = c_base_rx * M_base_rx_x + base_rx_h3 * neg_a_base_ry_x;
  tau[4] = base_rx_I9 * neg_Omega_base_ry_xy - (M_base_rz_y_1 - s_base_rx * M_base_rx_y);
  // left_hip_block: force F of (1)
  const Scalar neg_F_base_rx_y_1 = F_left_hip_block_z + F_right_hip_block_z;
  const Scalar neg_F_base_rx_y_2 = neg_F_base_rx_y_1 - base_rx_h6 * neg_Omega_base_rx_yy;
  const Scalar neg_F_base_rx_y = neg_F_base_rx_y_2 + base_rx_h1 * Omega_base_rx_yx;
  const Scalar F_base_rz_y_1 = c_base_rx * F_base_rx_x + s_base_rx * neg_F_base_rx_y;
  const Scalar F_base_rz_y = F_base_rz_y_1 - base_rx_h3 * neg_Omega_base_ry_zy;
  // base_ry: moment M, force F of (1)
  const Scalar M_base_ry_x_1 = base_rx_h3 * a_base_rz_y + s_base_rx * M_base_rx_x;
  const Scalar M_base_ry_x_2 = M_base_ry_x_1 - base_rx_I9 * neg_Omega_base_ry_zy;
  const Scalar M_base_ry_x = M_base_ry_x_2 + c_base_rx * M_base_rx_y;
  tau[3] = s_base_ry * M_base_ry_y - c_base_ry * M_base_ry_x;
  const Scalar F_base_ry_x_1 = s_base_rx * F_base_rx_x - c_base_rx * neg_F_base_rx_y;
  const Scalar F_base_ry_x = F_base_ry_x_1 + base_rx_h3 * neg_Omega_base_ry_xy;
  const Scalar F_base_ry_y_1 = t_base_rx_8 + base_rx_h3 * neg_Omega_base_ry_yy;
  const Scalar F_base_ry_y_2 = F_base_ry_y_1 + base_rx_h1 * Omega_base_rx_zx;
  const Scalar F_base_ry_y = F_base_ry_y_2 - base_rx_h6 * neg_Omega_base_rx_zy;
  const Scalar F_base_rz_x = s_base_ry * F_base_ry_x + c_base_ry * F_base_ry_y;
  // base_pz: force F of (1)
  tau[1] = base_rx_m2 * qdd[1] - s_base_rz * F_base_rz_x - c_base_rz * F_base_rz_y;
  tau[0] = base_rx_m2 * qdd[0] + s_base_rz * F_base_rz_y - c_base_rz * F_base_rz_x;
  tau[2] = -(base_rx_m2 * neg_a_base_pz_z - s_base_ry * F_base_ry_y + c_base_ry * F_base_ry_x);
}

namespace {

[[gnu::noinline]] void forward_dynamics_1(const Scalar q[18], const Scalar qd[18],
                                          const Scalar tau[18], Scalar w[266]) noexcept {
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const Scalar angle_left_foot = left_foot_k1 + q[11];
  const Scalar q_q15_q16 = q[15] + q[16];
  const Scalar q_q14_q15_q16 = q[14] + q_q15_q16;
  const Scalar angle_right_foot = left_foot_k1 - q[17];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[3], q[4], q[5], q[6]);
  sines_cosines(sines + 4, cosines + 4, q[7], q_q8_q9_q10, q_q9_q10, q[10]);
  sines_cosines(sines + 8, cosines + 8, angle_left_foot, q[12], q[13], q_q14_q15_q16);
  sines_cosines(sines + 12, cosines + 12, q_q15_q16, q[16], angle_right_foot);
  const Scalar s_base_rz = sines[0];
  const Scalar c_base_rz = cosines[0];
  const Scalar s_base_ry = sines[1];
  const Scalar c_base_ry = cosines[1];
  const Scalar s_base_rx = sines[2];
  const Scalar c_base_rx = cosines[2];
  const Scalar s_left_hip_yaw = sines[3];
  const Scalar c_left_hip_yaw = cosines[3];
  const Scalar s_left_hip_roll = sines[4];
  const Scalar c_left_hip_roll = cosines[4];
  const Scalar s_q8_q9_q10 = sines[5];
  const Scalar c_q8_q9_q10 = cosines[5];
  const Scalar s_q9_q10 = sines[6];
  const Scalar c_q9_q10 = cosines[6];
  const Scalar s_left_ankle_pitch = sines[7];
  const Scalar c_left_ankle_pitch = cosines[7];
  const Scalar s_left_foot = sines[8];
  const Scalar c_left_foot = cosines[8];
  const Scalar s_right_hip_yaw = sines[9];
  const Scalar c_right_hip_yaw = cosines[9];
  const Scalar s_right_hip_roll = sines[10];
  const Scalar c_right_hip_roll = cosines[10];
  const Scalar s_q14_q15_q16 = sines[11];
  const Scalar c_q14_q15_q16 = cosines[11];
  const Scalar s_q15_q16 = sines[12];
  const Scalar c_q15_q16 = cosines[12];
  const Scalar s_right_ankle_pitch = sines[13];
  const Scalar c_right_ankle_pitch = cosines[13];
  const Scalar s_right_foot = sines[14];
  const Scalar c_right_foot = cosines[14];
  w[0] = s_base_rz;
  w[1] = c_base_rz;
  w[2] = s_base_ry;
  w[3] = c_base_ry;
  w[4] = s_base_rx;
  w[5] = c_base_rx;
  w[6] = s_left_hip_yaw;
  w[7] = c_left_hip_yaw;
  w[8] = s_left_hip_roll;
  w[9] = c_left_hip_roll;
  w[10] = s_q8_q9_q10;
  w[11] = c_q8_q9_q10;
  w[12] = s_left_foot;
  w[13] = c_left_foot;
  w[14] = s_right_hip_yaw;
  w[15] = c_right_hip_yaw;
  w[16] = s_right_hip_roll;
  w[17] = c_right_hip_roll;
  w[18] = s_q14_q15_q16;
  w[19] = c_q14_q15_q16;
  w[20] = s_q15_q16;
  w[21] = c_q15_q16;
  w[22] = s_right_ankle_pitch;
  w[23] = c_right_ankle_pitch;
  w[24] = s_right_foot;
  w[25] = c_right_foot;
  const Scalar neg_s_left_shank_x = left_shank_l1 * c_q9_q10;
  w[26] = neg_s_left_shank_x;
  const Scalar s_left_shank_y = left_shank_l1 * s_q9_q10;
  w[27] = s_left_shank_y;
  const Scalar s_left_ankle_cross_y = left_ankle_cross_l1 * s_left_ankle_pitch;
  w[28] = s_left_ankle_cross_y;
  const Scalar neg_s_left_ankle_cross_x = left_ankle_cross_l1 * c_left_ankle_pitch;
  w[29] = neg_s_left_ankle_cross_x;
  const Scalar s_right_shank_y = left_shank_l1 * s_q15_q16;
  w[30] = s_right_shank_y;
  const Scalar neg_s_right_shank_x = left_shank_l1 * c_q15_q16;
  w[31] = neg_s_right_shank_x;
  const Scalar s_righ_ankl_cros_y = left_ankle_cross_l1 * s_right_ankle_pitch;
  w[32] = s_righ_ankl_cros_y;
  const Scalar neg_s_righ_ankl_cros_x = left_ankle_cross_l1 * c_right_ankle_pitch;
  w[33] = neg_s_righ_ankl_cros_x;
  // base_rx: angular velocity omega, 1/cosine of (1)
  const Scalar neg_omega_base_ry_x = c_base_ry * qd[3];
  w[34] = neg_omega_base_ry_x;
  const Scalar neg_omega_base_rx_y = c_base_rx * neg_omega_base_ry_x - s_base_rx * qd[4];
  w[35] = neg_omega_base_rx_y;
  const Scalar neg_omega_base_rx_x = s_base_rx * neg_omega_base_ry_x + c_base_rx * qd[4];
  w[36] = neg_omega_base_rx_x;
  const Scalar omega_base_ry_y = s_base_ry * qd[3];
  w[37] = omega_base_ry_y;
  const Scalar neg_omega_base_rx_z = omega_base_ry_y - qd[5];
  const Scalar t_base_rx_1 = c_base_rz * tau[0] + s_base_rz * tau[1];
  w[38] = t_base_rx_1;
  const Scalar t_base_rx_2 = c_base_ry * tau[2] + s_base_ry * t_base_rx_1;
  w[39] = t_base_rx_2;
  const Scalar t_base_rx_3 = s_base_rz * tau[0] - c_base_rz * tau[1];
  w[40] = t_base_rx_3;
  const Scalar t_base_rx_4 = 1.0 / c_base_ry;
  w[41] = t_base_rx_4;
  const Scalar t_base_rx_5 = t_base_rx_4 * (tau[3] + s_base_ry * tau[5]);
  w[42] = t_base_rx_5;
  // base_px
  const Scalar t_base_px_1 = neg_omega_base_rx_y * neg_omega_base_rx_y;
  w[43] = t_base_px_1;
  const Scalar t_base_px_2 = neg_omega_base_rx_x * neg_omega_base_rx_x;
  const Scalar t_base_px_3 = t_base_px_1 + t_base_px_2;
  w[44] = t_base_px_3;
  const Scalar t_base_px_4 = neg_omega_base_rx_z * neg_omega_base_rx_z;
  w[45] = t_base_px_4;
  const Scalar t_base_px_5 = t_base_px_2 + t_base_px_4;
  w[46] = t_base_px_5;
  const Scalar t_base_px_6 = neg_omega_base_rx_x * neg_omega_base_rx_z;
  w[47] = t_base_px_6;
  const Scalar t_base_px_7 = neg_omega_base_rx_y * neg_omega_base_rx_z;
  w[48] = t_base_px_7;
  const Scalar t_base_px_8 = neg_omega_base_rx_y * neg_omega_base_rx_x;
  w[49] = t_base_px_8;
  const Scalar t_base_px_9 = t_base_px_1 + t_base_px_4;
  w[50] = t_base_px_9;
  // left_hip_block: zeta, angular velocity omega, qdd of (1)
  const Scalar t_left_hip_block_1 = left_hip_block_l1 * t_base_px_9;
  const Scalar t_left_hip_block_2 = left_hip_block_l2 * t_base_px_8;
  const Scalar t_left_hip_block_3 = t_left_hip_block_1 - t_left_hip_block_2;
  const Scalar t_left_hip_block_4 = left_hip_block_l2 * t_base_px_7;
  const Scalar t_left_hip_block_5 = left_hip_block_l1 * t_base_px_6;
  const Scalar t_left_hip_block_6 = t_left_hip_block_4 + t_left_hip_block_5;
  const Scalar t_left_hip_block_7 = c_left_hip_yaw * t_left_hip_block_3;
  const Scalar t_left_hip_block_8 = t_left_hip_block_7 - s_left_hip_yaw * t_left_hip_block_6;
  w[51] = t_left_hip_block_8;
  const Scalar t_left_hip_block_9 = c_left_hip_yaw * t_left_hip_block_6;
  const Scalar zeta_left_hip_block_y = t_left_hip_block_9 + s_left_hip_yaw * t_left_hip_block_3;
  w[52] = zeta_left_hip_block_y;
  const Scalar t_left_hip_block_10 = left_hip_block_l2 * t_base_px_5;
  const Scalar t_left_hip_block_11 = left_hip_block_l1 * t_base_px_8;
  const Scalar t_left_hip_block_12 = t_left_hip_block_10 - t_left_hip_block_11;
  w[53] = t_left_hip_block_12;
  const Scalar t_left_hip_block_13 = c_left_hip_yaw * neg_omega_base_rx_z;
  const Scalar omega_left_hip_block_y = t_left_hip_block_13 - s_left_hip_yaw * neg_omega_base_rx_x;
  const Scalar t_left_hip_block_14 = omega_left_hip_block_y * qd[6];
  w[54] = t_left_hip_block_14;
  const Scalar t_left_hip_block_15 = c_left_hip_yaw * neg_omega_base_rx_x;
  const Scalar omega_left_hip_block_x = t_left_hip_block_15 + s_left_hip_yaw * neg_omega_base_rx_z;
  const Scalar t_left_hip_block_16 = qd[6] * omega_left_hip_block_x;
  w[55] = t_left_hip_block_16;
  const Scalar omega_left_hip_block_z = neg_omega_base_rx_y + qd[6];
  // left_hip_fork: angular velocity omega, joint force u of (1)
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + c_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_4 = s_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_4 - c_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_5 * t_left_hip_fork_5;
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_3 + t_left_hip_fork_6;
  w[56] = t_left_hip_fork_7;
  // left_hip_block: joint force u of (1)
  const Scalar t_left_hip_block_17 = omega_left_hip_block_y * omega_left_hip_block_x;
  w[57] = t_left_hip_block_17;
  const Scalar t_left_hip_block_18 = omega_left_hip_block_y * omega_left_hip_block_z;
  w[58] = t_left_hip_block_18;
  const Scalar t_left_hip_block_19 = omega_left_hip_block_z * omega_left_hip_block_z;
  const Scalar t_left_hip_block_20 =
      t_left_hip_block_19 + omega_left_hip_block_y * omega_left_hip_block_y;
  w[59] = t_left_hip_block_20;
  const Scalar t_left_hip_block_21 = omega_left_hip_block_x * omega_left_hip_block_z;
  w[60] = t_left_hip_block_21;
  // left_hip_fork: qdd, angular velocity omega, joint force u of (1)
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_5 * qd[7];
  w[61] = t_left_hip_fork_8;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_2 * qd[7];
  w[62] = t_left_hip_fork_9;
  const Scalar t_left_hip_fork_10 = omega_left_hip_block_y - qd[7];
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_10 * t_left_hip_fork_10;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_3 + t_left_hip_fork_11;
  w[63] = t_left_hip_fork_12;
  const Scalar t_left_hip_fork_13 = t_left_hip_fork_2 * t_left_hip_fork_5;
  w[64] = t_left_hip_fork_13;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_5 * t_left_hip_fork_10;
  w[65] = t_left_hip_fork_14;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_6 + t_left_hip_fork_11;
  w[66] = t_left_hip_fork_15;
  const Scalar t_left_hip_fork_16 = t_left_hip_fork_2 * t_left_hip_fork_10;
  w[67] = t_left_hip_fork_16;
  // left_thigh: zeta, angular velocity omega, qdd of (1)
  const Scalar t_left_thigh_1 = left_hip_fork_l1 * t_left_hip_fork_7;
  const Scalar t_left_thigh_2 = left_hip_fork_l1 * t_left_hip_fork_14;
  const Scalar zeta_left_thigh_y_1 = c_q8_q9_q10 * t_left_thigh_1;
  const Scalar zeta_left_thigh_y = zeta_left_thigh_y_1 + s_q8_q9_q10 * t_left_thigh_2;
  w[68] = zeta_left_thigh_y;
  const Scalar zeta_left_thigh_x_1 = s_q8_q9_q10 * t_left_thigh_1;
  const Scalar zeta_left_thigh_x = zeta_left_thigh_x_1 - c_q8_q9_q10 * t_left_thigh_2;
  w[69] = zeta_left_thigh_x;
  const Scalar omega_left_thigh_x_1 = c_q8_q9_q10 * t_left_hip_fork_5;
  const Scalar omega_left_thigh_x = omega_left_thigh_x_1 + s_q8_q9_q10 * t_left_hip_fork_10;
  const Scalar t_left_thigh_3 = omega_left_thigh_x * qd[8];
  w[70] = t_left_thigh_3;
  const Scalar omega_left_thigh_y_1 = c_q8_q9_q10 * t_left_hip_fork_10;
  const Scalar omega_left_thigh_y = omega_left_thigh_y_1 - s_q8_q9_q10 * t_left_hip_fork_5;
  const Scalar t_left_thigh_4 = qd[8] * omega_left_thigh_y;
  w[71] = t_left_thigh_4;
  const Scalar neg_zeta_left_thigh_z = left_hip_fork_l1 * t_left_hip_fork_16;
  w[72] = neg_zeta_left_thigh_z;
  const Scalar omega_left_thigh_z = t_left_hip_fork_2 + qd[8];
  const Scalar t_left_thigh_5 = omega_left_thigh_y * omega_left_thigh_y;
  w[73] = t_left_thigh_5;
  const Scalar t_left_thigh_6 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_7 = t_left_thigh_5 + t_left_thigh_6;
  w[74] = t_left_thigh_7;
  const Scalar t_left_thigh_8 = left_thigh_I1 * c_q9_q10 + left_thigh_I13 * s_q9_q10;
  const Scalar t_left_thigh_9 = left_thigh_I8 - c_q9_q10 * t_left_thigh_8;
  w[75] = t_left_thigh_9;
  const Scalar t_left_thigh_10 = omega_left_thigh_x * omega_left_thigh_y;
  w[76] = t_left_thigh_10;
  const Scalar t_left_thigh_11 = s_q9_q10 * t_left_thigh_8;
  const Scalar t_left_thigh_12 = left_thigh_I11 - t_left_thigh_11;
  w[77] = t_left_thigh_12;
  const Scalar t_left_thigh_13 = omega_left_thigh_x * omega_left_thigh_z;
  w[78] = t_left_thigh_13;
  const Scalar t_left_thigh_14 = left_thigh_I3 * c_q9_q10 - left_thigh_I4 * s_q9_q10;
  w[79] = t_left_thigh_14;
  const Scalar t_left_thigh_15 = omega_left_thigh_x * omega_left_thigh_x;
  w[80] = t_left_thigh_15;
  const Scalar t_left_thigh_16 = t_left_thigh_6 + t_left_thigh_15;
  w[81] = t_left_thigh_16;
  const Scalar t_left_thigh_17 = left_thigh_I12 + t_left_thigh_11;
  w[82] = t_left_thigh_17;
  const Scalar t_left_thigh_18 = omega_left_thigh_y * omega_left_thigh_z;
  w[83] = t_left_thigh_18;
  const Scalar t_left_thigh_19 = left_thigh_I4 * c_q9_q10 + left_thigh_I3 * s_q9_q10;
  w[84] = t_left_thigh_19;
  const Scalar t_left_thigh_20 = left_thigh_h1 * s_q9_q10;
  w[85] = t_left_thigh_20;
  const Scalar t_left_thigh_21 = left_thigh_h1 * c_q9_q10;
  w[86] = t_left_thigh_21;
  // left_shank: zeta, joint force u, angular velocity omega of (1)
  const Scalar t_left_shank_1 = neg_s_left_shank_x * t_left_thigh_10;
  const Scalar neg_zeta_left_shank_y = t_left_shank_1 + s_left_shank_y * t_left_thigh_16;
  w[87] = neg_zeta_left_shank_y;
  const Scalar zeta_left_shank_x_1 = neg_s_left_shank_x * t_left_thigh_7;
  const Scalar zeta_left_shank_x = s_left_shank_y * t_left_thigh_10 + zeta_left_shank_x_1;
  w[88] = zeta_left_shank_x;
  const Scalar t_left_shank_2 = neg_s_left_shank_x * t_left_thigh_13;
  const Scalar neg_zeta_left_shank_z = t_left_shank_2 - s_left_shank_y * t_left_thigh_18;
  w[89] = neg_zeta_left_shank_z;
  const Scalar t_left_shank_3 = omega_left_thigh_y * qd[9];
  w[90] = t_left_shank_3;
  const Scalar t_left_shank_4 = omega_left_thigh_x * qd[9];
  w[91] = t_left_shank_4;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[9];
  const Scalar t_left_shank_5 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_6 = t_left_thigh_15 + t_left_shank_5;
  w[92] = t_left_shank_6;
  const Scalar t_left_shank_7 = left_shank_I14 * s_left_ankle_pitch;
  const Scalar t_left_shank_8 = left_shank_I1 * c_left_ankle_pitch + t_left_shank_7;
  const Scalar t_left_shank_9 = c_left_ankle_pitch * t_left_shank_8;
  w[93] = t_left_shank_9;
  const Scalar u_left_shank_1 = left_shank_I9 - t_left_shank_9;
  w[94] = u_left_shank_1;
  const Scalar t_left_shank_10 = s_left_ankle_pitch * t_left_shank_8;
  w[95] = t_left_shank_10;
  const Scalar t_left_shank_11 = left_shank_I13 + t_left_shank_10;
  w[96] = t_left_shank_11;
  const Scalar t_left_shank_12 = t_left_thigh_18 + t_left_shank_3;
  w[97] = t_left_shank_12;
  const Scalar t_left_shank_13 = left_shank_I4 * c_left_ankle_pitch;
  const Scalar t_left_shank_14 = t_left_shank_13 + left_shank_I3 * s_left_ankle_pitch;
  w[98] = t_left_shank_14;
  const Scalar t_left_shank_15 = t_left_thigh_5 + t_left_shank_5;
  w[99] = t_left_shank_15;
  const Scalar t_left_shank_16 = left_shank_I12 - t_left_shank_10;
  w[100] = t_left_shank_16;
  const Scalar t_left_shank_17 = t_left_thigh_13 + t_left_shank_4;
  w[101] = t_left_shank_17;
  const Scalar t_left_shank_18 = left_shank_I4 * s_left_ankle_pitch;
  const Scalar t_left_shank_19 = t_left_shank_18 - left_shank_I3 * c_left_ankle_pitch;
  w[102] = t_left_shank_19;
  const Scalar t_left_shank_20 = left_shank_h2 * c_left_ankle_pitch;
  w[103] = t_left_shank_20;
  const Scalar t_left_shank_21 = left_shank_h2 * s_left_ankle_pitch;
  w[104] = t_left_shank_21;
  // left_ankle_cross: zeta, joint force u, angular velocity omega of (1)
  const Scalar t_left_ankle_cross_1 = neg_s_left_ankle_cross_x * t_left_thigh_10;
  const Scalar t_left_ankle_cross_2 = t_left_ankle_cross_1 + s_left_ankle_cross_y * t_left_shank_6;
  w[105] = t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_3 = neg_s_left_ankle_cross_x * t_left_shank_15;
  const Scalar zeta_left_ankle_cross_x =
      s_left_ankle_cross_y * t_left_thigh_10 + t_left_ankle_cross_3;
  w[106] = zeta_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = neg_s_left_ankle_cross_x * t_left_shank_17;
  const Scalar zeta_left_ankle_cross_z =
      s_left_ankle_cross_y * t_left_shank_12 - t_left_ankle_cross_4;
  w[107] = zeta_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_5 = omega_left_thigh_y * qd[10];
  w[108] = t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_6 = omega_left_thigh_x * qd[10];
  w[109] = t_left_ankle_cross_6;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[10];
  const Scalar t_left_ankle_cross_7 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_8 = t_left_thigh_5 + t_left_ankle_cross_7;
  w[110] = t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_9 = t_left_shank_17 + t_left_ankle_cross_6;
  w[111] = t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_10 = t_left_thigh_15 + t_left_ankle_cross_7;
  w[112] = t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_11 = t_left_shank_12 + t_left_ankle_cross_5;
  w[113] = t_left_ankle_cross_11;
  // left_foot: zeta, angular velocity omega, qdd of (1)
  const Scalar zeta_left_foot_y_1 = left_hip_fork_l3 * t_left_ankle_cross_9;
  const Scalar zeta_left_foot_y_2 = left_hip_fork_l1 * t_left_ankle_cross_9;
  const Scalar zeta_left_foot_y_3 = zeta_left_foot_y_1 + left_hip_fork_l1 * t_left_ankle_cross_8;
  const Scalar zeta_left_foot_y_4 = left_hip_fork_l3 * t_left_hip_fork_15 + zeta_left_foot_y_2;
  const Scalar zeta_left_foot_y_5 = s_left_foot * zeta_left_foot_y_3;
  const Scalar zeta_left_foot_y = zeta_left_foot_y_5 + c_left_foot * zeta_left_foot_y_4;
  w[114] = zeta_left_foot_y;
  const Scalar omega_left_foot_x_1 = s_left_foot * omega_left_ankle_cross_z;
  const Scalar omega_left_foot_x = omega_left_foot_x_1 + c_left_foot * omega_left_thigh_x;
  const Scalar t_left_foot_1 = omega_left_foot_x * qd[11];
  w[115] = t_left_foot_1;
  const Scalar omega_left_foot_y_1 = c_left_foot * omega_left_ankle_cross_z;
  const Scalar omega_left_foot_y = omega_left_foot_y_1 - s_left_foot * omega_left_thigh_x;
  const Scalar t_left_foot_2 = qd[11] * omega_left_foot_y;
  w[116] = t_left_foot_2;
  const Scalar neg_omega_left_foot_z = omega_left_thigh_y - qd[11];
  const Scalar t_left_foot_3 = neg_omega_left_foot_z * neg_omega_left_foot_z;
  w[117] = t_left_foot_3;
  const Scalar t_left_foot_4 = omega_left_foot_y * omega_left_foot_y;
  w[118] = t_left_foot_4;
  const Scalar t_left_foot_5 = t_left_foot_3 + t_left_foot_4;
  w[119] = t_left_foot_5;
  const Scalar t_left_foot_6 = omega_left_foot_x * omega_left_foot_y;
  w[120] = t_left_foot_6;
  const Scalar t_left_foot_7 = omega_left_foot_x * neg_omega_left_foot_z;
  w[121] = t_left_foot_7;
  const Scalar t_left_foot_8 = omega_left_foot_y * neg_omega_left_foot_z;
  w[122] = t_left_foot_8;
  // right_hip_block: zeta, angular velocity omega, qdd of (1)
  const Scalar t_right_hip_block_1 = t_left_hip_block_1 + t_left_hip_block_2;
  const Scalar t_right_hip_block_2 = t_left_hip_block_4 - t_left_hip_block_5;
  const Scalar t_right_hip_block_3 = c_right_hip_yaw * t_right_hip_block_2;
  const Scalar zeta_right_hip_block_y = t_right_hip_block_3 - s_right_hip_yaw * t_right_hip_block_1;
  w[123] = zeta_right_hip_block_y;
  const Scalar t_right_hip_block_4 = s_right_hip_yaw * t_right_hip_block_2;
  const Scalar zeta_right_hip_block_x = t_right_hip_block_4 + c_right_hip_yaw * t_right_hip_block_1;
  w[124] = zeta_right_hip_block_x;
  const Scalar t_right_hip_block_5 = t_left_hip_block_10 + t_left_hip_block_11;
  w[125] = t_right_hip_block_5;
  const Scalar t_right_hip_block_6 = c_right_hip_yaw * neg_omega_base_rx_x;
  const Scalar omega_right_hip_block_x =
      t_right_hip_block_6 + s_right_hip_yaw * neg_omega_base_rx_z;
  const Scalar t_right_hip_block_7 = omega_right_hip_block_x * qd[12];
  w[126] = t_right_hip_block_7;
  const Scalar t_right_hip_block_8 = s_right_hip_yaw * neg_omega_base_rx_x;
  const Scalar t_right_hip_block_9 = t_right_hip_block_8 - c_right_hip_yaw * neg_omega_base_rx_z;
  const Scalar t_right_hip_block_10 = qd[12] * t_right_hip_block_9;
  w[127] = t_right_hip_block_10;
  const Scalar omega_right_hip_block_z = neg_omega_base_rx_y + qd[12];
  const Scalar t_right_hip_block_11 = omega_right_hip_block_z * omega_right_hip_block_z;
  const Scalar t_right_hip_block_12 =
      t_right_hip_block_11 + t_right_hip_block_9 * t_right_hip_block_9;
  w[128] = t_right_hip_block_12;
  const Scalar t_right_hip_block_13 = omega_right_hip_block_x * t_right_hip_block_9;
  w[129] = t_right_hip_block_13;
  const Scalar t_right_hip_block_14 = omega_right_hip_block_x * omega_right_hip_block_z;
  w[130] = t_right_hip_block_14;
  // right_hip_fork: angular velocity omega, joint force u, qdd of (1)
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 + s_right_hip_roll * omega_right_hip_block_z;
  w[131] = t_right_hip_fork_2;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 * t_right_hip_fork_2;
  w[132] = t_right_hip_fork_3;
  const Scalar t_right_hip_fork_4 = c_right_hip_roll * omega_right_hip_block_z;
  const Scalar omega_right_hip_fork_x =
      t_right_hip_fork_4 - s_right_hip_roll * omega_right_hip_block_x;
  w[133] = omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_5 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_block_15 = t_right_hip_fork_3 + t_right_hip_fork_5;
  w[134] = t_right_hip_block_15;
  const Scalar t_right_hip_block_16 = t_right_hip_block_9 * omega_right_hip_block_z;
  w[135] = t_right_hip_block_16;
  const Scalar t_right_hip_fork_6 = omega_right_hip_fork_x * qd[13];
  w[136] = t_right_hip_fork_6;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_2 * qd[13];
  w[137] = t_right_hip_fork_7;
  const Scalar omega_right_hip_fork_z = t_right_hip_block_9 + qd[13];
  w[138] = omega_right_hip_fork_z;
  const Scalar t_right_hip_fork_8 = omega_right_hip_fork_z * omega_right_hip_fork_z;
  w[139] = t_right_hip_fork_8;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_3 + t_right_hip_fork_8;
  w[140] = t_right_hip_fork_9;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_2 * omega_right_hip_fork_x;
  w[141] = t_right_hip_fork_10;
  const Scalar t_right_hip_fork_11 = omega_right_hip_fork_x * omega_right_hip_fork_z;
  w[142] = t_right_hip_fork_11;
  const Scalar t_right_thigh_1 = t_right_hip_fork_5 + t_right_hip_fork_8;
  w[143] = t_right_thigh_1;
}

[[gnu::noinline]] void forward_dynamics_2(const Scalar qd[18], const Scalar tau[18],
                                          Scalar w[266]) noexcept {
  const Scalar t_right_hip_fork_2 = w[131];
  const Scalar omega_right_hip_fork_z = w[138];
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_2 * omega_right_hip_fork_z;
  w[144] = t_right_hip_fork_12;
  // right_thigh: zeta, angular velocity omega, qdd of (1)
  const Scalar t_right_hip_block_15 = w[134];
  const Scalar t_right_thigh_2 = left_hip_fork_l1 * t_right_hip_block_15;
  const Scalar t_right_hip_fork_11 = w[142];
  const Scalar t_right_thigh_3 = left_hip_fork_l1 * t_right_hip_fork_11;
  const Scalar s_q14_q15_q16 = w[18];
  const Scalar zeta_right_thigh_x_1 = s_q14_q15_q16 * t_right_thigh_2;
  const Scalar c_q14_q15_q16 = w[19];
  const Scalar zeta_right_thigh_x = zeta_right_thigh_x_1 - c_q14_q15_q16 * t_right_thigh_3;
  w[145] = zeta_right_thigh_x;
  const Scalar zeta_right_thigh_y_1 = c_q14_q15_q16 * t_right_thigh_2;
  const Scalar zeta_right_thigh_y = zeta_right_thigh_y_1 + s_q14_q15_q16 * t_right_thigh_3;
  w[146] = zeta_right_thigh_y;
  const Scalar t_right_thigh_4 = c_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar omega_right_hip_fork_x = w[133];
  const Scalar neg_omega_right_thigh_y = t_right_thigh_4 - s_q14_q15_q16 * omega_right_hip_fork_x;
  const Scalar t_right_thigh_5 = neg_omega_right_thigh_y * qd[14];
  w[147] = t_right_thigh_5;
  const Scalar t_right_thigh_6 = s_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar neg_omega_right_thigh_x = t_right_thigh_6 + c_q14_q15_q16 * omega_right_hip_fork_x;
  const Scalar t_right_thigh_7 = qd[14] * neg_omega_right_thigh_x;
  w[148] = t_right_thigh_7;
  const Scalar zeta_right_thigh_z = left_hip_fork_l1 * t_right_hip_fork_12;
  w[149] = zeta_right_thigh_z;
  const Scalar omega_right_thigh_z = t_right_hip_fork_2 + qd[14];
  const Scalar t_right_thigh_8 = neg_omega_right_thigh_x * neg_omega_right_thigh_x;
  const Scalar t_right_thigh_9 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_10 = t_right_thigh_8 + t_right_thigh_9;
  w[150] = t_right_thigh_10;
  const Scalar t_right_thigh_11 = neg_omega_right_thigh_y * neg_omega_right_thigh_x;
  w[151] = t_right_thigh_11;
  const Scalar c_q15_q16 = w[21];
  const Scalar s_q15_q16 = w[20];
  const Scalar t_right_thigh_12 = left_thigh_I1 * c_q15_q16 + left_thigh_I13 * s_q15_q16;
  w[152] = t_right_thigh_12;
  const Scalar t_right_thigh_13 = s_q15_q16 * t_right_thigh_12;
  const Scalar t_right_thigh_14 = left_thigh_I12 + t_right_thigh_13;
  w[153] = t_right_thigh_14;
  const Scalar t_right_thigh_15 = neg_omega_right_thigh_y * omega_right_thigh_z;
  w[154] = t_right_thigh_15;
  const Scalar t_right_thigh_16 = left_thigh_I4 * c_q15_q16 + left_thigh_I3 * s_q15_q16;
  w[155] = t_right_thigh_16;
  const Scalar t_right_thigh_17 = neg_omega_right_thigh_y * neg_omega_right_thigh_y;
  const Scalar t_right_thigh_18 = t_right_thigh_9 + t_right_thigh_17;
  w[156] = t_right_thigh_18;
  const Scalar t_right_thigh_19 = left_thigh_I11 - t_right_thigh_13;
  w[157] = t_right_thigh_19;
  const Scalar t_right_thigh_20 = neg_omega_right_thigh_x * omega_right_thigh_z;
  w[158] = t_right_thigh_20;
  const Scalar t_right_thigh_21 = left_thigh_I4 * s_q15_q16 - left_thigh_I3 * c_q15_q16;
  w[159] = t_right_thigh_21;
  const Scalar t_right_thigh_22 = left_thigh_h1 * s_q15_q16;
  w[160] = t_right_thigh_22;
  const Scalar t_right_thigh_23 = left_thigh_h1 * c_q15_q16;
  w[161] = t_right_thigh_23;
  // right_shank: zeta, joint force u, angular velocity omega of (1)
  const Scalar neg_s_right_shank_x = w[31];
  const Scalar zeta_right_shank_x_1 = neg_s_right_shank_x * t_right_thigh_18;
  const Scalar s_right_shank_y = w[30];
  const Scalar zeta_right_shank_x = s_right_shank_y * t_right_thigh_11 + zeta_right_shank_x_1;
  w[162] = zeta_right_shank_x;
  const Scalar t_right_shank_1 = neg_s_right_shank_x * t_right_thigh_11;
  const Scalar neg_zeta_right_shank_y = t_right_shank_1 + s_right_shank_y * t_right_thigh_10;
  w[163] = neg_zeta_right_shank_y;
  const Scalar t_right_shank_2 = neg_s_right_shank_x * t_right_thigh_20;
  const Scalar neg_zeta_right_shank_z = s_right_shank_y * t_right_thigh_15 - t_right_shank_2;
  w[164] = neg_zeta_right_shank_z;
  const Scalar t_right_shank_3 = neg_omega_right_thigh_y * qd[15];
  w[165] = t_right_shank_3;
  const Scalar t_right_shank_4 = neg_omega_right_thigh_x * qd[15];
  w[166] = t_right_shank_4;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[15];
  const Scalar t_right_shank_5 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_6 = t_right_thigh_8 + t_right_shank_5;
  w[167] = t_right_shank_6;
  const Scalar s_right_ankle_pitch = w[22];
  const Scalar t_right_shank_7 = left_shank_I14 * s_right_ankle_pitch;
  const Scalar c_right_ankle_pitch = w[23];
  const Scalar t_right_shank_8 = t_right_shank_7 + left_shank_I1 * c_right_ankle_pitch;
  const Scalar t_right_shank_9 = c_right_ankle_pitch * t_right_shank_8;
  w[168] = t_right_shank_9;
  const Scalar t_right_shank_10 = left_shank_I9 - t_right_shank_9;
  w[169] = t_right_shank_10;
  const Scalar t_right_shank_11 = s_right_ankle_pitch * t_right_shank_8;
  const Scalar t_right_shank_12 = left_shank_I13 + t_right_shank_11;
  w[170] = t_right_shank_12;
  const Scalar t_right_shank_13 = t_right_thigh_15 + t_right_shank_3;
  w[171] = t_right_shank_13;
  const Scalar t_right_shank_14 = left_shank_I4 * c_right_ankle_pitch;
  const Scalar t_right_shank_15 = t_right_shank_14 + left_shank_I3 * s_right_ankle_pitch;
  w[172] = t_right_shank_15;
  const Scalar t_right_shank_16 = t_right_thigh_17 + t_right_shank_5;
  w[173] = t_right_shank_16;
  const Scalar t_right_shank_17 = left_shank_I12 - t_right_shank_11;
  w[174] = t_right_shank_17;
  const Scalar t_right_shank_18 = t_right_thigh_20 + t_right_shank_4;
  w[175] = t_right_shank_18;
  const Scalar t_right_shank_19 = left_shank_I3 * c_right_ankle_pitch;
  const Scalar t_right_shank_20 = t_right_shank_19 - left_shank_I4 * s_right_ankle_pitch;
  w[176] = t_right_shank_20;
  const Scalar t_right_shank_21 = left_shank_h2 * s_right_ankle_pitch;
  w[177] = t_right_shank_21;
  const Scalar t_right_shank_22 = left_shank_h2 * c_right_ankle_pitch;
  w[178] = t_right_shank_22;
  // right_ankle_cross: zeta, qdd, joint force u of (1)
  const Scalar neg_s_righ_ankl_cros_x = w[33];
  const Scalar t_righ_ankl_cros_1 = neg_s_righ_ankl_cros_x * t_right_shank_16;
  const Scalar s_righ_ankl_cros_y = w[32];
  const Scalar zeta_righ_ankl_cros_x = s_righ_ankl_cros_y * t_right_thigh_11 + t_righ_ankl_cros_1;
  w[179] = zeta_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_2 = neg_s_righ_ankl_cros_x * t_right_thigh_11;
  const Scalar t_righ_ankl_cros_3 = t_righ_ankl_cros_2 + s_righ_ankl_cros_y * t_right_shank_6;
  w[180] = t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_4 = neg_s_righ_ankl_cros_x * t_right_shank_18;
  const Scalar t_righ_ankl_cros_5 = s_righ_ankl_cros_y * t_right_shank_13 - t_righ_ankl_cros_4;
  w[181] = t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_6 = neg_omega_right_thigh_y * qd[16];
  w[182] = t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_7 = neg_omega_right_thigh_x * qd[16];
  w[183] = t_righ_ankl_cros_7;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[16];
  const Scalar t_righ_ankl_cros_8 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_9 = t_right_thigh_17 + t_righ_ankl_cros_8;
  w[184] = t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_10 = t_right_shank_18 + t_righ_ankl_cros_7;
  w[185] = t_righ_ankl_cros_10;
  const Scalar t_righ_ankl_cros_11 = t_right_thigh_8 + t_righ_ankl_cros_8;
  w[186] = t_righ_ankl_cros_11;
  const Scalar t_righ_ankl_cros_12 = neg_omega_right_thigh_y * omega_righ_ankl_cros_z;
  w[187] = t_righ_ankl_cros_12;
  // right_foot: zeta, angular velocity omega, qdd of (1)
  const Scalar t_right_foot_1 = left_hip_fork_l3 * t_righ_ankl_cros_10;
  const Scalar t_right_foot_2 = left_hip_fork_l1 * t_righ_ankl_cros_10;
  const Scalar t_right_foot_3 = t_right_foot_1 + left_hip_fork_l1 * t_righ_ankl_cros_9;
  const Scalar t_right_thigh_1 = w[143];
  const Scalar t_right_foot_4 = t_right_foot_2 + left_hip_fork_l3 * t_right_thigh_1;
  const Scalar s_right_foot = w[24];
  const Scalar t_right_foot_5 = s_right_foot * t_right_foot_3;
  const Scalar c_right_foot = w[25];
  const Scalar neg_zeta_right_foot_y = t_right_foot_5 + c_right_foot * t_right_foot_4;
  w[188] = neg_zeta_right_foot_y;
  const Scalar t_right_foot_6 = c_right_foot * neg_omega_right_thigh_x;
  const Scalar neg_omega_right_foot_x = t_right_foot_6 + s_right_foot * omega_righ_ankl_cros_z;
  const Scalar t_right_foot_7 = neg_omega_right_foot_x * qd[17];
  w[189] = t_right_foot_7;
  const Scalar omega_right_foot_y_1 = s_right_foot * neg_omega_right_thigh_x;
  const Scalar omega_right_foot_y = c_right_foot * omega_righ_ankl_cros_z - omega_right_foot_y_1;
  const Scalar t_right_foot_8 = qd[17] * omega_right_foot_y;
  w[190] = t_right_foot_8;
  const Scalar omega_right_foot_z = neg_omega_right_thigh_y + qd[17];
  const Scalar t_right_foot_9 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_10 = neg_omega_right_foot_x * omega_right_foot_y;
  const Scalar t_right_foot_11 = omega_right_foot_y * omega_right_foot_z;
  const Scalar t_right_foot_12 = t_right_foot_9 + omega_right_foot_y * omega_right_foot_y;
  const Scalar t_right_foot_13 = neg_omega_right_foot_x * omega_right_foot_z;
  const Scalar t_right_foot_14 = t_right_foot_9 + neg_omega_right_foot_x * neg_omega_right_foot_x;
  const Scalar u_right_foot_1 = tau[17] - left_foot_I2 * t_right_foot_11;
  const Scalar u_right_foot_2 = u_right_foot_1 - left_foot_I1 * t_right_foot_13;
  const Scalar u_right_foot_3 = u_right_foot_2 + left_foot_I8 * t_right_foot_10;
  const Scalar u_right_foot_4 = t_right_foot_12 - t_right_foot_14;
  const Scalar u_right_foot = u_right_foot_3 + left_foot_I14 * u_right_foot_4;
  w[191] = u_right_foot;
  const Scalar t_right_foot_15 = left_foot_h1 * t_right_foot_10;
  const Scalar t_right_foot_16 = t_right_foot_15 - left_foot_h2 * t_right_foot_7;
  const Scalar t_right_foot_17 = t_right_foot_16 - left_foot_h3 * t_right_foot_8;
  const Scalar t_right_foot_18 = t_right_foot_17 - left_foot_m1 * neg_zeta_right_foot_y;
  const Scalar t_right_foot_19 = t_right_foot_18 - left_foot_p2 * u_right_foot;
  const Scalar t_right_foot_20 = left_foot_h1 * t_right_foot_12;
  const Scalar t_right_foot_21 = c_right_foot * t_right_foot_20;
  const Scalar t_right_foot_22 = t_right_foot_21 + s_right_foot * t_right_foot_19;
  w[192] = t_right_foot_22;
  const Scalar t_right_foot_23 = left_foot_I12 * t_right_foot_13;
  const Scalar t_right_foot_24 = t_right_foot_23 + left_foot_I14 * t_right_foot_11;
  const Scalar t_right_foot_25 = t_right_foot_24 - left_foot_I1 * t_right_foot_10;
  const Scalar t_right_foot_26 = t_right_foot_25 - left_foot_k2 * u_right_foot;
  const Scalar t_right_foot_27 = t_right_foot_26 - left_foot_I3 * t_righ_ankl_cros_12;
  const Scalar t_right_foot_28 = t_right_foot_27 + left_foot_I4 * t_right_thigh_11;
  const Scalar t_right_foot_29 = t_right_foot_28 - left_foot_I15 * t_right_foot_8;
  const Scalar t_right_foot_30 = t_right_foot_29 + left_foot_I16 * t_right_foot_7;
  const Scalar t_right_foot_31 = t_right_foot_30 - left_foot_h2 * neg_zeta_right_foot_y;
  const Scalar t_right_foot_32 = t_righ_ankl_cros_11 - t_right_foot_12;
  const Scalar t_right_foot_33 = t_right_foot_31 + left_foot_I2 * t_right_foot_32;
  w[193] = t_right_foot_33;
  const Scalar t_right_foot_34 = left_foot_I13 * t_right_foot_11;
  const Scalar t_right_foot_35 = left_foot_I2 * t_right_foot_10 + t_right_foot_34;
  const Scalar t_right_foot_36 = t_right_foot_35 + left_foot_I14 * t_right_foot_13;
  const Scalar t_right_foot_37 = t_right_foot_36 - left_foot_k3 * u_right_foot;
  const Scalar t_right_foot_38 = t_right_foot_37 - left_foot_I15 * t_right_foot_7;
  const Scalar t_right_foot_39 = t_right_foot_38 - left_foot_I17 * t_right_foot_8;
  const Scalar t_right_foot_40 = t_right_foot_39 - left_foot_h3 * neg_zeta_right_foot_y;
  const Scalar t_right_foot_41 = t_righ_ankl_cros_11 - t_right_foot_14;
  const Scalar t_right_foot_42 = t_right_foot_40 - left_foot_I1 * t_right_foot_41;
  w[194] = t_right_foot_42;
  const Scalar t_right_foot_43 = t_right_foot_7 + t_right_foot_13;
  w[195] = t_right_foot_43;
  const Scalar t_right_foot_44 = left_foot_m1 * s_right_foot;
  const Scalar t_right_foot_45 = s_right_foot * t_right_foot_44;
  const Scalar t_right_foot_46 = c_right_foot * t_right_foot_44;
  const Scalar t_right_foot_47 = left_foot_h4 - left_hip_fork_l1 * t_right_foot_45;
  const Scalar t_right_foot_48 = t_right_foot_47 - left_hip_fork_l3 * t_right_foot_46;
  w[196] = t_right_foot_48;
  const Scalar t_right_foot_49 = left_hip_fork_l1 * t_right_foot_46;
  const Scalar t_right_foot_50 = t_right_foot_49 - left_hip_fork_l3 * t_right_foot_45;
  w[197] = t_right_foot_50;
  const Scalar t_right_foot_51 = left_foot_h2 * s_right_foot + left_foot_h3 * c_right_foot;
  const Scalar t_right_foot_52 = s_right_foot * t_right_foot_51;
  w[198] = t_right_foot_52;
  const Scalar t_right_foot_53 = left_foot_h2 - t_right_foot_52;
  const Scalar t_right_foot_54 = c_right_foot * t_right_foot_51;
  w[199] = t_right_foot_54;
  const Scalar t_right_foot_55 = left_ankle_cross_I18 + left_hip_fork_l1 * t_right_foot_52;
  const Scalar t_right_foot_56 = t_right_foot_55 + left_hip_fork_l3 * t_right_foot_54;
  w[200] = t_right_foot_56;
  const Scalar t_right_foot_57 = left_foot_I18 * s_right_foot - left_foot_I19 * c_right_foot;
  const Scalar t_right_foot_58 = s_right_foot * t_right_foot_57;
  w[201] = t_right_foot_58;
  const Scalar t_right_foot_59 = left_ankle_cross_I15 - t_right_foot_58;
  const Scalar t_right_foot_60 = t_right_foot_59 + left_foot_I10 * c_right_foot;
  w[202] = t_right_foot_60;
  const Scalar t_right_foot_61 = left_ankle_cross_I16 - left_foot_I4 * s_right_foot;
  const Scalar t_right_foot_62 = left_foot_I3 - t_right_foot_57;
  const Scalar t_right_foot_63 = t_right_foot_61 + c_right_foot * t_right_foot_62;
  w[203] = t_right_foot_63;
  const Scalar t_right_foot_64 = left_ankle_cross_h3 + t_right_foot_54;
  const Scalar t_right_foot_65 = left_ankle_cross_h1 + left_foot_h1 * c_right_foot;
  w[204] = t_right_foot_65;
  // right_ankle_cross: joint force u, 1/pivot, qdd of (1)
  const Scalar t_righ_ankl_cros_13 = t_righ_ankl_cros_9 - t_righ_ankl_cros_11;
  w[205] = t_righ_ankl_cros_13;
  const Scalar u_righ_ankl_cros_1 = tau[16] + left_ankle_cross_I14 * t_righ_ankl_cros_12;
  const Scalar u_righ_ankl_cros_2 = u_righ_ankl_cros_1 - c_right_foot * t_right_foot_33;
  const Scalar u_righ_ankl_cros_3 = u_righ_ankl_cros_2 - left_ankle_cross_I17 * t_right_thigh_11;
  const Scalar u_righ_ankl_cros_4 = u_righ_ankl_cros_3 + s_right_foot * t_right_foot_42;
  const Scalar u_righ_ankl_cros_5 = u_righ_ankl_cros_4 - left_foot_I4 * t_right_foot_43;
  const Scalar u_righ_ankl_cros_6 = u_righ_ankl_cros_5 + left_ankle_cross_I1 * t_righ_ankl_cros_10;
  const Scalar u_righ_ankl_cros = u_righ_ankl_cros_6 + left_ankle_cross_I7 * t_righ_ankl_cros_13;
  w[206] = u_righ_ankl_cros;
  const Scalar t_righ_ankl_cros_14 = 1.0 / t_right_foot_60;
  w[207] = t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_15 = t_right_foot_64 * t_righ_ankl_cros_14;
  w[208] = t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_16 = t_right_foot_65 * t_righ_ankl_cros_14;
  w[209] = t_righ_ankl_cros_16;
  const Scalar t_righ_ankl_cros_17 = t_right_foot_64 * t_righ_ankl_cros_16;
  w[210] = t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_18 = t_right_foot_45 + t_right_foot_64 * t_righ_ankl_cros_15;
  w[211] = t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_19 = left_shank_m2 - t_righ_ankl_cros_18;
  w[212] = t_righ_ankl_cros_19;
  const Scalar t_righ_ankl_cros_20 = t_right_foot_53 * t_righ_ankl_cros_14;
  w[213] = t_righ_ankl_cros_20;
  const Scalar t_righ_ankl_cros_21 = t_right_foot_46 + t_right_foot_64 * t_righ_ankl_cros_20;
  w[214] = t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_22 = t_right_foot_56 * t_righ_ankl_cros_14;
  w[215] = t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_23 = t_right_foot_50 - t_right_foot_64 * t_righ_ankl_cros_22;
  w[216] = t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_24 = t_right_foot_63 * t_righ_ankl_cros_14;
  w[217] = t_righ_ankl_cros_24;
  const Scalar t_righ_ankl_cros_25 = t_right_foot_52 + t_right_foot_64 * t_righ_ankl_cros_24;
  w[218] = t_righ_ankl_cros_25;
  const Scalar t_right_foot_66 = t_right_foot_22 + left_ankle_cross_h2 * t_right_thigh_11;
  const Scalar t_right_foot_67 = t_right_foot_66 + left_ankle_cross_h1 * t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_26 = t_right_foot_67 - t_righ_ankl_cros_7 * t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_27 =
      t_righ_ankl_cros_26 - zeta_righ_ankl_cros_x * t_righ_ankl_cros_19;
  const Scalar t_righ_ankl_cros_28 = t_righ_ankl_cros_27 + t_righ_ankl_cros_6 * t_righ_ankl_cros_25;
  const Scalar t_righ_ankl_cros_29 = t_righ_ankl_cros_28 - t_righ_ankl_cros_3 * t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_30 = t_righ_ankl_cros_29 - u_righ_ankl_cros * t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_31 = t_righ_ankl_cros_30 - t_righ_ankl_cros_5 * t_righ_ankl_cros_21;
  w[219] = t_righ_ankl_cros_31;
  const Scalar t_righ_ankl_cros_32 = t_right_foot_65 * t_righ_ankl_cros_16;
  w[220] = t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_33 = left_shank_m2 - t_righ_ankl_cros_32;
  w[221] = t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_34 = t_right_foot_53 * t_righ_ankl_cros_16;
  w[222] = t_righ_ankl_cros_34;
  const Scalar t_righ_ankl_cros_35 = t_right_foot_65 * t_righ_ankl_cros_24;
  const Scalar t_righ_ankl_cros_36 = left_foot_h1 * s_right_foot + t_righ_ankl_cros_35;
  w[223] = t_righ_ankl_cros_36;
  const Scalar t_righ_ankl_cros_37 = t_right_foot_56 * t_righ_ankl_cros_16;
  w[224] = t_righ_ankl_cros_37;
  const Scalar t_righ_ankl_cros_38 = u_righ_ankl_cros - zeta_righ_ankl_cros_x * t_right_foot_64;
  w[225] = t_righ_ankl_cros_38;
  const Scalar t_righ_ankl_cros_39 = t_right_foot_45 - t_right_foot_53 * t_righ_ankl_cros_20;
  w[226] = t_righ_ankl_cros_39;
  const Scalar t_righ_ankl_cros_40 = left_shank_m3 + t_righ_ankl_cros_39;
  const Scalar t_right_foot_68 = left_ankle_cross_h1 - t_right_foot_48;
  const Scalar t_righ_ankl_cros_41 = t_right_foot_68 + t_right_foot_53 * t_righ_ankl_cros_22;
  w[227] = t_righ_ankl_cros_41;
  const Scalar t_right_foot_69 = left_ankle_cross_h2 - t_right_foot_54;
  const Scalar t_righ_ankl_cros_42 = t_right_foot_69 - t_right_foot_53 * t_righ_ankl_cros_24;
  w[228] = t_righ_ankl_cros_42;
  // right_foot
  const Scalar t_right_foot_70 = s_right_foot * t_right_foot_20;
  const Scalar t_right_foot_71 = t_right_foot_70 - c_right_foot * t_right_foot_19;
  w[229] = t_right_foot_71;
  const Scalar t_right_foot_72 = t_right_foot_71 - left_ankle_cross_h1 * t_righ_ankl_cros_10;
  const Scalar t_right_foot_73 = t_right_foot_72 + left_ankle_cross_h2 * t_righ_ankl_cros_12;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_43 = t_right_foot_73 + t_righ_ankl_cros_3 * t_righ_ankl_cros_34;
  const Scalar t_righ_ankl_cros_44 = t_righ_ankl_cros_43 - t_righ_ankl_cros_7 * t_righ_ankl_cros_41;
  const Scalar t_righ_ankl_cros_45 = t_righ_ankl_cros_44 + t_righ_ankl_cros_6 * t_righ_ankl_cros_42;
  const Scalar t_righ_ankl_cros_46 = t_righ_ankl_cros_45 + u_righ_ankl_cros * t_righ_ankl_cros_20;
  const Scalar t_righ_ankl_cros_47 = t_righ_ankl_cros_46 - t_righ_ankl_cros_5 * t_righ_ankl_cros_40;
  const Scalar t_righ_ankl_cros_48 =
      t_righ_ankl_cros_47 - zeta_righ_ankl_cros_x * t_righ_ankl_cros_21;
  w[230] = t_righ_ankl_cros_48;
  const Scalar t_righ_ankl_cros_49 =
      t_righ_ankl_cros_41 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_40;
  w[231] = t_righ_ankl_cros_49;
  const Scalar t_righ_ankl_cros_50 = t_righ_ankl_cros_42 - s_righ_ankl_cros_y * t_righ_ankl_cros_40;
  w[232] = t_righ_ankl_cros_50;
}

[[gnu::noinline]] void forward_dynamics_3(const Scalar tau[18], Scalar w[266]) noexcept {
  // right_ankle_cross
  const Scalar neg_s_righ_ankl_cros_x = w[33];
  const Scalar t_righ_ankl_cros_34 = w[222];
  const Scalar t_righ_ankl_cros_51 = neg_s_righ_ankl_cros_x * t_righ_ankl_cros_34;
  const Scalar t_righ_ankl_cros_37 = w[224];
  const Scalar t_righ_ankl_cros_52 = t_righ_ankl_cros_37 + t_righ_ankl_cros_51;
  const Scalar t_righ_ankl_cros_23 = w[216];
  const Scalar t_righ_ankl_cros_21 = w[214];
  const Scalar t_righ_ankl_cros_53 =
      t_righ_ankl_cros_23 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_21;
  const Scalar t_right_shank_20 = w[176];
  const Scalar t_righ_ankl_cros_54 =
      t_right_shank_20 + neg_s_righ_ankl_cros_x * t_righ_ankl_cros_52;
  const Scalar s_righ_ankl_cros_y = w[32];
  const Scalar t_righ_ankl_cros_55 = t_righ_ankl_cros_54 - s_righ_ankl_cros_y * t_righ_ankl_cros_53;
  w[20] = t_righ_ankl_cros_55;
  const Scalar t_righ_ankl_cros_56 = s_righ_ankl_cros_y * t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_25 = w[218];
  const Scalar t_righ_ankl_cros_57 = t_righ_ankl_cros_25 - t_righ_ankl_cros_56;
  const Scalar t_righ_ankl_cros_36 = w[223];
  const Scalar t_righ_ankl_cros_58 = t_righ_ankl_cros_36 - s_righ_ankl_cros_y * t_righ_ankl_cros_34;
  const Scalar t_right_shank_15 = w[172];
  const Scalar t_righ_ankl_cros_59 =
      t_right_shank_15 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_58;
  const Scalar t_righ_ankl_cros_60 = t_righ_ankl_cros_59 - s_righ_ankl_cros_y * t_righ_ankl_cros_57;
  w[22] = t_righ_ankl_cros_60;
  const Scalar t_righ_ankl_cros_17 = w[210];
  const Scalar t_righ_ankl_cros_61 = neg_s_righ_ankl_cros_x * t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_19 = w[212];
  const Scalar t_righ_ankl_cros_62 = s_righ_ankl_cros_y * t_righ_ankl_cros_19 - t_righ_ankl_cros_61;
  const Scalar t_righ_ankl_cros_33 = w[221];
  const Scalar t_righ_ankl_cros_63 = neg_s_righ_ankl_cros_x * t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_64 = t_righ_ankl_cros_63 - s_righ_ankl_cros_y * t_righ_ankl_cros_17;
  const Scalar t_right_shank_12 = w[170];
  const Scalar t_right_shank_17 = w[174];
  const Scalar t_left_shank_22 = t_right_shank_12 + t_right_shank_17;
  const Scalar t_righ_ankl_cros_65 = t_left_shank_22 + neg_s_righ_ankl_cros_x * t_righ_ankl_cros_64;
  const Scalar t_righ_ankl_cros_66 = t_righ_ankl_cros_65 + s_righ_ankl_cros_y * t_righ_ankl_cros_62;
  w[23] = t_righ_ankl_cros_66;
  const Scalar t_right_shank_22 = w[178];
  const Scalar t_righ_ankl_cros_67 = t_right_shank_22 - t_righ_ankl_cros_62;
  w[131] = t_righ_ankl_cros_67;
  const Scalar t_right_shank_21 = w[177];
  const Scalar t_righ_ankl_cros_68 = t_right_shank_21 + t_righ_ankl_cros_64;
  w[133] = t_righ_ankl_cros_68;
  const Scalar t_righ_ankl_cros_69 = t_righ_ankl_cros_51 + t_righ_ankl_cros_56;
  w[138] = t_righ_ankl_cros_69;
  const Scalar t_righ_ankl_cros_7 = w[183];
  const Scalar t_righ_ankl_cros_70 = t_righ_ankl_cros_7 * t_righ_ankl_cros_37;
  const Scalar t_right_thigh_11 = w[151];
  const Scalar t_righ_ankl_cros_71 = left_ankle_cross_h1 * t_right_thigh_11 - t_righ_ankl_cros_70;
  const Scalar t_righ_ankl_cros_16 = w[209];
  const Scalar t_righ_ankl_cros_38 = w[225];
  const Scalar t_righ_ankl_cros_72 =
      t_righ_ankl_cros_71 + t_righ_ankl_cros_16 * t_righ_ankl_cros_38;
  const Scalar t_righ_ankl_cros_6 = w[182];
  const Scalar t_righ_ankl_cros_73 = t_righ_ankl_cros_72 - t_righ_ankl_cros_6 * t_righ_ankl_cros_36;
  const Scalar t_righ_ankl_cros_11 = w[186];
  const Scalar t_righ_ankl_cros_74 =
      t_righ_ankl_cros_73 + left_ankle_cross_h2 * t_righ_ankl_cros_11;
  const Scalar t_right_foot_43 = w[195];
  const Scalar t_righ_ankl_cros_75 = t_righ_ankl_cros_74 + left_foot_h1 * t_right_foot_43;
  const Scalar t_righ_ankl_cros_3 = w[180];
  const Scalar t_righ_ankl_cros_76 = t_righ_ankl_cros_75 - t_righ_ankl_cros_3 * t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_5 = w[181];
  const Scalar t_righ_ankl_cros_77 = t_righ_ankl_cros_76 + t_righ_ankl_cros_5 * t_righ_ankl_cros_34;
  // right_shank: joint force u, 1/pivot of (1)
  const Scalar t_righ_ankl_cros_31 = w[219];
  const Scalar u_right_shank_1 = tau[15] - tau[16] - s_righ_ankl_cros_y * t_righ_ankl_cros_31;
  const Scalar t_right_shank_13 = w[171];
  const Scalar u_right_shank_2 = u_right_shank_1 - t_right_shank_13 * t_right_shank_15;
  const Scalar u_right_shank_3 = u_right_shank_2 + neg_s_righ_ankl_cros_x * t_righ_ankl_cros_77;
  const Scalar u_right_shank_4 = t_right_shank_12 - t_right_shank_17;
  const Scalar u_right_shank_5 = u_right_shank_3 - t_right_thigh_11 * u_right_shank_4;
  const Scalar t_right_shank_10 = w[169];
  const Scalar t_righ_ankl_cros_13 = w[205];
  const Scalar u_right_shank_6 = u_right_shank_5 + t_right_shank_10 * t_righ_ankl_cros_13;
  const Scalar t_right_shank_18 = w[175];
  const Scalar u_right_shank = u_right_shank_6 + t_right_shank_18 * t_right_shank_20;
  w[233] = u_right_shank;
  const Scalar t_right_shank_23 = 1.0 / t_righ_ankl_cros_66;
  w[234] = t_right_shank_23;
  const Scalar t_right_shank_24 = t_righ_ankl_cros_68 * t_right_shank_23;
  const Scalar t_righ_ankl_cros_32 = w[220];
  const Scalar t_righ_ankl_cros_78 = left_thigh_m2 - t_righ_ankl_cros_32;
  const Scalar t_right_shank_25 = t_righ_ankl_cros_78 - t_righ_ankl_cros_68 * t_right_shank_24;
  const Scalar t_right_shank_26 = t_righ_ankl_cros_67 * t_right_shank_23;
  const Scalar t_right_shank_27 = t_righ_ankl_cros_17 - t_righ_ankl_cros_67 * t_right_shank_24;
  const Scalar t_right_shank_28 = t_righ_ankl_cros_69 * t_right_shank_23;
  const Scalar t_right_shank_29 = t_righ_ankl_cros_34 - t_righ_ankl_cros_69 * t_right_shank_24;
  const Scalar t_right_shank_30 = t_righ_ankl_cros_55 * t_right_shank_23;
  const Scalar t_right_shank_31 = t_righ_ankl_cros_52 - t_righ_ankl_cros_68 * t_right_shank_30;
  const Scalar t_right_shank_32 = t_righ_ankl_cros_60 * t_right_shank_23;
  const Scalar t_right_shank_33 = t_righ_ankl_cros_58 + t_righ_ankl_cros_68 * t_right_shank_32;
  const Scalar t_right_shank_34 = t_righ_ankl_cros_77 - t_right_thigh_11 * t_right_shank_21;
  const Scalar t_right_shank_3 = w[165];
  const Scalar t_right_shank_35 = t_right_shank_34 - t_right_shank_3 * t_right_shank_33;
  const Scalar zeta_right_shank_x = w[162];
  const Scalar t_right_shank_36 = t_right_shank_35 - zeta_right_shank_x * t_right_shank_27;
  const Scalar neg_zeta_right_shank_z = w[164];
  const Scalar t_right_shank_37 = t_right_shank_36 + neg_zeta_right_shank_z * t_right_shank_29;
  const Scalar t_right_shank_38 = t_right_shank_37 - u_right_shank * t_right_shank_24;
  const Scalar t_right_shank_6 = w[167];
  const Scalar t_right_shank_39 = t_right_shank_38 + t_right_shank_6 * t_right_shank_22;
  const Scalar t_right_shank_4 = w[166];
  const Scalar t_right_shank_40 = t_right_shank_39 - t_right_shank_4 * t_right_shank_31;
  const Scalar neg_zeta_right_shank_y = w[163];
  const Scalar t_right_shank_41 = t_right_shank_40 - neg_zeta_right_shank_y * t_right_shank_25;
  const Scalar t_righ_ankl_cros_18 = w[211];
  const Scalar t_righ_ankl_cros_79 = left_thigh_m2 - t_righ_ankl_cros_18;
  const Scalar t_right_shank_42 = t_righ_ankl_cros_79 - t_righ_ankl_cros_67 * t_right_shank_26;
  const Scalar t_right_shank_43 = t_righ_ankl_cros_21 + t_righ_ankl_cros_69 * t_right_shank_26;
  const Scalar t_right_shank_44 = t_righ_ankl_cros_53 - t_righ_ankl_cros_67 * t_right_shank_30;
  const Scalar t_right_shank_45 = t_righ_ankl_cros_57 - t_righ_ankl_cros_60 * t_right_shank_26;
  const Scalar t_right_shank_46 = t_righ_ankl_cros_31 + t_right_thigh_11 * t_right_shank_22;
  const Scalar t_right_shank_47 = t_right_shank_46 - zeta_right_shank_x * t_right_shank_42;
  const Scalar t_right_shank_48 = t_right_shank_47 + t_right_shank_3 * t_right_shank_45;
  const Scalar t_right_shank_49 = t_right_shank_48 - neg_zeta_right_shank_z * t_right_shank_43;
  const Scalar t_right_shank_50 = t_right_shank_49 - u_right_shank * t_right_shank_26;
  const Scalar t_right_shank_16 = w[173];
  const Scalar t_right_shank_51 = t_right_shank_50 - t_right_shank_16 * t_right_shank_21;
  const Scalar t_right_shank_52 = t_right_shank_51 - t_right_shank_4 * t_right_shank_44;
  const Scalar t_right_shank_53 = t_right_shank_52 - neg_zeta_right_shank_y * t_right_shank_27;
  const Scalar t_righ_ankl_cros_39 = w[226];
  const Scalar t_righ_ankl_cros_80 = left_thigh_m3 + t_righ_ankl_cros_39;
  const Scalar t_right_shank_54 = t_righ_ankl_cros_80 - t_righ_ankl_cros_69 * t_right_shank_28;
  const Scalar t_righ_ankl_cros_49 = w[231];
  const Scalar t_righ_ankl_cros_81 = t_right_shank_21 - t_righ_ankl_cros_49;
  const Scalar t_right_shank_55 = t_righ_ankl_cros_81 - t_righ_ankl_cros_55 * t_right_shank_28;
  const Scalar t_righ_ankl_cros_50 = w[232];
  const Scalar t_righ_ankl_cros_82 = t_right_shank_22 + t_righ_ankl_cros_50;
  const Scalar t_right_shank_56 = t_righ_ankl_cros_82 + t_righ_ankl_cros_69 * t_right_shank_32;
  const Scalar t_righ_ankl_cros_48 = w[230];
  const Scalar t_right_shank_57 = t_righ_ankl_cros_48 - neg_zeta_right_shank_z * t_right_shank_54;
  const Scalar t_right_shank_58 = t_right_shank_57 + t_right_shank_4 * t_right_shank_55;
  const Scalar t_right_shank_59 = t_right_shank_58 + neg_zeta_right_shank_y * t_right_shank_29;
  const Scalar t_right_shank_60 = t_right_shank_59 + u_right_shank * t_right_shank_28;
  const Scalar t_right_shank_61 = t_right_shank_60 - zeta_right_shank_x * t_right_shank_43;
  const Scalar t_right_shank_62 = t_right_shank_61 + t_right_shank_3 * t_right_shank_56;
  const Scalar t_right_shank_63 = t_right_shank_62 + t_right_shank_18 * t_right_shank_21;
  const Scalar t_right_shank_64 = t_right_shank_63 + t_right_shank_13 * t_right_shank_22;
  const Scalar t_right_foot_58 = w[201];
  const Scalar t_right_foot_74 = left_ankle_cross_I19 + t_right_foot_58;
  const Scalar s_right_foot = w[24];
  const Scalar t_right_foot_75 = t_right_foot_74 - left_foot_I11 * s_right_foot;
  // right_ankle_cross
  const Scalar t_right_foot_63 = w[203];
  const Scalar t_righ_ankl_cros_24 = w[217];
  const Scalar t_righ_ankl_cros_83 = t_right_foot_75 - t_right_foot_63 * t_righ_ankl_cros_24;
  const Scalar t_righ_ankl_cros_42 = w[228];
  const Scalar t_righ_ankl_cros_84 = t_righ_ankl_cros_42 + t_righ_ankl_cros_50;
  const Scalar t_righ_ankl_cros_85 = t_righ_ankl_cros_83 - s_righ_ankl_cros_y * t_righ_ankl_cros_84;
  const Scalar t_right_thigh_24 = t_righ_ankl_cros_85 - t_righ_ankl_cros_60 * t_right_shank_32;
  const Scalar t_right_foot_52 = w[198];
  const Scalar t_right_foot_76 = left_hip_fork_l3 * t_right_foot_52;
  const Scalar t_right_foot_54 = w[199];
  const Scalar t_right_foot_77 = t_right_foot_76 - left_hip_fork_l1 * t_right_foot_54;
  const Scalar t_righ_ankl_cros_22 = w[215];
  const Scalar t_righ_ankl_cros_86 = t_right_foot_77 + t_right_foot_63 * t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_87 = left_ankle_cross_I7 + t_righ_ankl_cros_86;
  // right_shank
  const Scalar t_righ_ankl_cros_41 = w[227];
  const Scalar t_right_shank_65 = t_righ_ankl_cros_87 - s_righ_ankl_cros_y * t_righ_ankl_cros_41;
  const Scalar t_right_shank_66 = t_right_shank_65 - t_righ_ankl_cros_60 * t_right_shank_30;
  const Scalar t_right_shank_67 = t_right_shank_66 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_50;
  const Scalar t_right_shank_68 = t_right_shank_10 + t_right_shank_67;
  const Scalar t_righ_ankl_cros_88 = t_righ_ankl_cros_41 + t_righ_ankl_cros_49;
  const Scalar neg_s_right_shank_x = w[31];
  const Scalar t_right_shank_69 = t_right_shank_55 + neg_s_right_shank_x * t_right_shank_54;
  const Scalar s_right_shank_y = w[30];
  const Scalar t_right_shank_70 = t_right_shank_56 - s_right_shank_y * t_right_shank_54;
  const Scalar t_right_shank_71 = neg_s_right_shank_x * t_right_shank_27;
  const Scalar t_right_shank_72 = s_right_shank_y * t_right_shank_42 - t_right_shank_71;
  const Scalar t_right_shank_73 = neg_s_right_shank_x * t_right_shank_25;
  const Scalar t_right_shank_74 = t_right_shank_73 - s_right_shank_y * t_right_shank_27;
  const Scalar t_right_thigh_14 = w[153];
  const Scalar t_right_thigh_19 = w[157];
  const Scalar t_right_thigh_25 = t_right_thigh_14 + t_right_thigh_19;
  const Scalar t_right_shank_75 = t_right_thigh_25 + neg_s_right_shank_x * t_right_shank_74;
  const Scalar t_right_shank_76 = t_right_shank_75 + s_right_shank_y * t_right_shank_72;
  w[235] = t_right_shank_76;
  const Scalar t_right_shank_77 = neg_s_right_shank_x * t_right_shank_29;
  const Scalar t_right_shank_78 = t_right_shank_31 + t_right_shank_77;
  const Scalar t_right_shank_79 = t_right_shank_44 - neg_s_right_shank_x * t_right_shank_43;
  const Scalar t_right_thigh_21 = w[159];
  const Scalar t_right_shank_80 = t_right_thigh_21 - neg_s_right_shank_x * t_right_shank_78;
  const Scalar t_right_shank_81 = t_right_shank_80 + s_right_shank_y * t_right_shank_79;
  const Scalar t_right_shank_82 = s_right_shank_y * t_right_shank_43;
  const Scalar t_right_shank_83 = t_right_shank_33 - s_right_shank_y * t_right_shank_29;
  const Scalar t_right_shank_84 = t_right_shank_45 - t_right_shank_82;
  const Scalar t_right_thigh_16 = w[155];
  const Scalar t_right_shank_85 = t_right_thigh_16 - neg_s_right_shank_x * t_right_shank_83;
  const Scalar t_right_shank_86 = t_right_shank_85 - s_right_shank_y * t_right_shank_84;
  w[236] = t_right_shank_86;
  const Scalar t_right_thigh_23 = w[161];
  const Scalar t_right_shank_87 = t_right_thigh_23 - t_right_shank_72;
  const Scalar t_right_thigh_22 = w[160];
  const Scalar t_right_shank_88 = t_right_thigh_22 + t_right_shank_74;
  const Scalar t_right_shank_89 = t_right_shank_77 + t_right_shank_82;
  w[237] = t_right_shank_89;
  // right_thigh: joint force u, 1/pivot, qdd of (1)
  const Scalar c_q15_q16 = w[21];
  const Scalar t_right_thigh_12 = w[152];
  const Scalar t_right_thigh_26 = left_thigh_I8 - c_q15_q16 * t_right_thigh_12;
  const Scalar t_right_thigh_20 = w[158];
  const Scalar u_right_thigh_1 = tau[14] - tau[15] - t_right_thigh_20 * t_right_thigh_21;
  const Scalar u_right_thigh_2 = u_right_thigh_1 + neg_s_right_shank_x * t_right_shank_41;
  const Scalar u_right_thigh_3 = u_right_thigh_2 - s_right_shank_y * t_right_shank_53;
  const Scalar u_right_thigh_4 = u_right_thigh_3 + t_righ_ankl_cros_13 * t_right_thigh_26;
  const Scalar u_right_thigh_5 = t_right_thigh_14 - t_right_thigh_19;
  const Scalar u_right_thigh_6 = u_right_thigh_4 - t_right_thigh_11 * u_right_thigh_5;
  const Scalar t_right_thigh_15 = w[154];
  const Scalar u_right_thigh = u_right_thigh_6 - t_right_thigh_15 * t_right_thigh_16;
  w[238] = u_right_thigh;
  const Scalar t_right_thigh_27 = 1.0 / t_right_shank_76;
  w[239] = t_right_thigh_27;
  const Scalar t_right_thigh_28 = t_right_shank_87 * t_right_thigh_27;
  w[240] = t_right_thigh_28;
  const Scalar t_right_thigh_29 = t_right_shank_88 * t_right_thigh_27;
  w[241] = t_right_thigh_29;
  const Scalar t_right_thigh_30 = t_right_shank_27 - t_right_shank_88 * t_right_thigh_28;
  w[242] = t_right_thigh_30;
  const Scalar t_right_thigh_31 = t_right_shank_42 - t_right_shank_87 * t_right_thigh_28;
  w[243] = t_right_thigh_31;
  const Scalar t_right_thigh_32 = t_right_shank_89 * t_right_thigh_27;
  const Scalar t_right_thigh_33 = t_right_shank_43 + t_right_shank_89 * t_right_thigh_28;
  w[244] = t_right_thigh_33;
  const Scalar t_right_thigh_34 = t_right_shank_86 * t_right_thigh_27;
  const Scalar t_right_thigh_35 = t_right_shank_84 - t_right_shank_87 * t_right_thigh_34;
  w[245] = t_right_thigh_35;
  const Scalar t_right_thigh_36 = t_right_shank_81 * t_right_thigh_27;
  w[246] = t_right_thigh_36;
  const Scalar t_right_thigh_37 = t_right_shank_79 + t_right_shank_87 * t_right_thigh_36;
  w[247] = t_right_thigh_37;
  const Scalar t_right_thigh_38 = t_right_shank_53 + t_right_thigh_11 * t_right_thigh_23;
  const Scalar zeta_right_thigh_z = w[149];
  const Scalar t_right_thigh_39 = t_right_thigh_38 + zeta_right_thigh_z * t_right_thigh_33;
  const Scalar t_right_thigh_7 = w[148];
  const Scalar t_right_thigh_40 = t_right_thigh_39 - t_right_thigh_7 * t_right_thigh_37;
  const Scalar t_right_thigh_41 = t_right_thigh_40 - u_right_thigh * t_right_thigh_28;
  const Scalar zeta_right_thigh_x = w[145];
  const Scalar t_right_thigh_42 = t_right_thigh_41 - zeta_right_thigh_x * t_right_thigh_31;
  const Scalar t_right_thigh_5 = w[147];
  const Scalar t_right_thigh_43 = t_right_thigh_42 + t_right_thigh_5 * t_right_thigh_35;
  const Scalar t_right_thigh_18 = w[156];
  const Scalar t_right_thigh_44 = t_right_thigh_43 - t_right_thigh_18 * t_right_thigh_22;
  const Scalar zeta_right_thigh_y = w[146];
  const Scalar t_right_thigh_45 = t_right_thigh_44 + zeta_right_thigh_y * t_right_thigh_30;
  w[248] = t_right_thigh_45;
  const Scalar t_right_thigh_46 = t_right_shank_25 - t_right_shank_88 * t_right_thigh_29;
  w[249] = t_right_thigh_46;
  const Scalar t_right_thigh_47 = t_right_shank_29 - t_right_shank_88 * t_right_thigh_32;
  w[250] = t_right_thigh_47;
  const Scalar t_right_thigh_48 = t_right_shank_78 + t_right_shank_88 * t_right_thigh_36;
  w[251] = t_right_thigh_48;
  const Scalar t_right_thigh_49 = t_right_shank_83 + t_right_shank_86 * t_right_thigh_29;
  w[252] = t_right_thigh_49;
  const Scalar t_right_thigh_50 = t_right_shank_41 - t_right_thigh_11 * t_right_thigh_22;
  const Scalar t_right_thigh_51 = t_right_thigh_50 - zeta_right_thigh_z * t_right_thigh_47;
  const Scalar t_right_thigh_52 = t_right_thigh_51 + zeta_right_thigh_y * t_right_thigh_46;
  const Scalar t_right_thigh_53 = t_right_thigh_52 - zeta_right_thigh_x * t_right_thigh_30;
  const Scalar t_right_thigh_10 = w[150];
  const Scalar t_right_thigh_54 = t_right_thigh_53 + t_right_thigh_10 * t_right_thigh_23;
  const Scalar t_right_thigh_55 = t_right_thigh_54 - t_right_thigh_5 * t_right_thigh_49;
  const Scalar t_right_thigh_56 = t_right_thigh_55 - t_right_thigh_7 * t_right_thigh_48;
  const Scalar t_right_thigh_57 = t_right_thigh_56 - u_right_thigh * t_right_thigh_29;
  w[253] = t_right_thigh_57;
  const Scalar t_right_shank_90 = t_right_thigh_22 + t_right_shank_69;
  const Scalar t_right_thigh_58 = t_right_shank_90 + t_right_shank_89 * t_right_thigh_36;
  w[254] = t_right_thigh_58;
  const Scalar t_right_thigh_59 = t_right_shank_10 + t_right_thigh_26;
  const Scalar t_right_thigh_60 = t_right_shank_67 + t_right_thigh_59;
  const Scalar t_right_thigh_61 = t_right_thigh_60 + s_right_shank_y * t_right_shank_55;
  const Scalar t_right_thigh_62 = t_right_thigh_61 + t_right_shank_86 * t_right_thigh_36;
  const Scalar t_right_thigh_63 = t_right_thigh_62 - neg_s_right_shank_x * t_right_shank_70;
  w[255] = t_right_thigh_63;
  const Scalar t_right_foot_48 = w[196];
  const Scalar t_right_foot_78 = left_ankle_cross_I13 - left_hip_fork_l1 * t_right_foot_48;
  const Scalar t_right_foot_50 = w[197];
  const Scalar t_right_foot_79 = t_right_foot_78 + left_hip_fork_l3 * t_right_foot_50;
  const Scalar t_right_foot_56 = w[200];
  const Scalar t_righ_ankl_cros_89 = t_right_foot_79 - t_right_foot_56 * t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_90 =
      t_righ_ankl_cros_89 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_88;
  const Scalar t_right_thigh_64 = t_righ_ankl_cros_90 - t_righ_ankl_cros_55 * t_right_shank_30;
  const Scalar t_right_thigh_65 = t_right_thigh_14 + t_right_shank_12;
  const Scalar t_right_thigh_66 = t_right_thigh_64 + t_right_thigh_65;
  const Scalar t_right_thigh_67 = t_right_thigh_66 - t_right_shank_81 * t_right_thigh_36;
  const Scalar t_right_shank_91 = t_right_shank_55 + t_right_shank_69;
  const Scalar t_right_thigh_68 = t_right_thigh_67 + neg_s_right_shank_x * t_right_shank_91;
  w[256] = t_right_thigh_68;
  const Scalar t_right_thigh_69 = t_right_thigh_64 + 2.0 * t_right_shank_12;
  const Scalar t_right_thigh_70 = t_right_shank_10 + t_right_shank_68;
  const Scalar u_righ_ankl_cros = w[206];
  const Scalar t_right_foot_65 = w[204];
  const Scalar t_right_thigh_71 = u_righ_ankl_cros + t_righ_ankl_cros_3 * t_right_foot_65;
  w[257] = t_right_thigh_71;
  const Scalar t_right_thigh_72 = left_ankle_cross_I1 - t_right_thigh_21 + t_right_shank_20;
  const Scalar t_right_thigh_73 = left_ankle_cross_I14 - t_right_thigh_16;
  const Scalar t_right_thigh_74 = t_right_shank_15 - t_right_thigh_73;
  const Scalar t_right_foot_71 = w[229];
  const Scalar t_right_hip_fork_12 = w[144];
  const Scalar t_right_thigh_75 = t_right_foot_71 - t_right_hip_fork_12 * t_right_thigh_58;
  const Scalar t_righ_ankl_cros_12 = w[187];
  const Scalar t_right_thigh_76 = tau[17] + left_ankle_cross_I7 * t_righ_ankl_cros_12;
  const Scalar t_right_foot_22 = w[192];
  const Scalar t_right_thigh_77 = t_right_thigh_76 + left_hip_fork_l3 * t_right_foot_22;
  const Scalar t_right_thigh_78 = t_right_thigh_77 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_48;
  const Scalar t_right_thigh_79 = t_right_thigh_78 - neg_s_right_shank_x * t_right_shank_64;
  const Scalar t_right_thigh_80 = t_right_thigh_79 + neg_zeta_right_shank_z * t_right_shank_55;
  const Scalar t_right_thigh_81 = t_right_thigh_80 - t_righ_ankl_cros_7 * t_righ_ankl_cros_89;
  const Scalar t_right_thigh_82 = t_right_thigh_81 - zeta_right_shank_x * t_right_shank_44;
  const Scalar t_right_thigh_83 = t_right_thigh_82 - t_right_thigh_20 * t_right_thigh_65;
  const Scalar t_right_thigh_84 = t_right_thigh_83 - t_right_shank_4 * t_right_thigh_69;
  const Scalar t_right_thigh_85 = t_right_thigh_84 - t_righ_ankl_cros_5 * t_righ_ankl_cros_41;
  const Scalar t_righ_ankl_cros_10 = w[185];
  const Scalar t_right_thigh_86 = t_right_thigh_85 - left_ankle_cross_I13 * t_righ_ankl_cros_10;
  const Scalar t_right_thigh_87 = t_right_thigh_86 + t_right_shank_3 * t_right_thigh_70;
  const Scalar t_right_thigh_88 = t_right_thigh_87 + t_right_thigh_15 * t_right_thigh_59;
  const Scalar t_right_thigh_89 = t_right_thigh_88 - u_right_shank * t_right_shank_30;
  const Scalar t_right_thigh_90 = t_right_thigh_89 - neg_zeta_right_shank_y * t_right_shank_31;
  const Scalar t_right_thigh_91 = t_right_thigh_90 - t_righ_ankl_cros_22 * t_right_thigh_71;
  const Scalar t_right_thigh_92 = t_right_thigh_91 + t_right_thigh_5 * t_right_thigh_63;
  const Scalar t_righ_ankl_cros_9 = w[184];
  const Scalar t_right_thigh_93 = t_right_thigh_92 + left_ankle_cross_I14 * t_righ_ankl_cros_9;
  const Scalar t_right_thigh_94 = t_right_thigh_93 - t_right_shank_15 * t_right_shank_16;
  const Scalar t_right_thigh_95 = t_right_thigh_94 - t_right_thigh_16 * t_right_thigh_18;
  const Scalar t_right_thigh_96 = t_right_thigh_95 + zeta_right_thigh_y * t_right_thigh_48;
  const Scalar t_right_thigh_97 = t_right_thigh_96 - zeta_right_thigh_x * t_right_thigh_37;
  const Scalar t_right_thigh_98 = t_right_thigh_97 + left_hip_fork_l1 * t_right_thigh_75;
  const Scalar zeta_righ_ankl_cros_x = w[179];
  const Scalar t_right_thigh_99 = t_right_thigh_98 - zeta_righ_ankl_cros_x * t_righ_ankl_cros_23;
  const Scalar t_right_thigh_100 = t_right_thigh_99 + u_right_thigh * t_right_thigh_36;
  const Scalar t_right_thigh_101 = t_right_thigh_100 - t_right_thigh_7 * t_right_thigh_68;
  const Scalar t_right_thigh_102 = t_right_thigh_101 + t_righ_ankl_cros_6 * t_righ_ankl_cros_87;
  const Scalar t_right_thigh_1 = w[143];
  const Scalar t_right_thigh_103 = t_right_thigh_102 + t_right_thigh_1 * t_right_thigh_74;
  const Scalar t_right_thigh_104 = t_right_thigh_103 + t_right_thigh_11 * t_right_thigh_72;
  w[258] = t_right_thigh_104;
  const Scalar t_right_shank_92 = t_right_thigh_23 + t_right_shank_70;
  const Scalar t_right_thigh_105 = t_right_shank_92 + t_right_shank_86 * t_right_thigh_32;
  w[259] = t_right_thigh_105;
  const Scalar t_right_thigh_106 = t_right_thigh_19 + t_right_shank_17;
  const Scalar t_right_thigh_107 = t_right_thigh_24 + t_right_thigh_106;
  const Scalar t_right_thigh_108 = t_right_thigh_107 - t_right_shank_86 * t_right_thigh_34;
  const Scalar t_right_shank_93 = t_right_shank_56 + t_right_shank_70;
  const Scalar t_right_thigh_109 = t_right_thigh_108 - s_right_shank_y * t_right_shank_93;
  w[260] = t_right_thigh_109;
  const Scalar t_right_shank_9 = w[168];
  const Scalar t_right_thigh_110 = t_right_shank_9 - left_shank_I16;
  const Scalar t_right_thigh_111 = t_right_thigh_24 + 2.0 * t_right_shank_17;
  const Scalar t_right_thigh_112 = t_right_thigh_26 - t_right_thigh_110;
  const Scalar t_right_thigh_113 = left_ankle_cross_I3 + t_righ_ankl_cros_86;
  const Scalar t_righ_ankl_cros_91 = left_ankle_cross_I6 * t_righ_ankl_cros_12;
  const Scalar t_right_foot_33 = w[193];
  const Scalar t_right_thigh_114 = t_righ_ankl_cros_91 - s_right_foot * t_right_foot_33;
  const Scalar t_right_thigh_115 = t_right_thigh_114 - s_righ_ankl_cros_y * t_righ_ankl_cros_48;
  const Scalar t_right_thigh_116 = t_right_thigh_115 - s_right_shank_y * t_right_shank_64;
  const Scalar t_right_thigh_117 = t_right_thigh_116 + zeta_right_thigh_z * t_right_thigh_105;
  const Scalar c_right_foot = w[25];
  const Scalar t_right_foot_42 = w[194];
  const Scalar t_right_thigh_118 = t_right_thigh_117 - c_right_foot * t_right_foot_42;
  const Scalar t_right_thigh_119 = t_right_thigh_118 - t_right_thigh_7 * t_right_thigh_63;
  const Scalar t_right_thigh_120 = t_right_thigh_119 + t_right_thigh_15 * t_right_thigh_106;
  const Scalar t_right_thigh_121 = t_right_thigh_120 - zeta_right_shank_x * t_right_shank_45;
  const Scalar t_right_thigh_122 = t_right_shank_68 - t_right_thigh_110;
  const Scalar t_right_thigh_123 = t_right_thigh_121 - t_right_shank_4 * t_right_thigh_122;
  const Scalar t_right_thigh_124 = t_right_thigh_123 + t_righ_ankl_cros_3 * t_righ_ankl_cros_36;
  const Scalar t_right_thigh_125 = t_right_thigh_124 - zeta_right_thigh_y * t_right_thigh_49;
  const Scalar t_right_thigh_126 = t_right_thigh_125 - zeta_right_thigh_x * t_right_thigh_35;
  const Scalar t_right_thigh_127 = t_right_thigh_126 - t_right_thigh_10 * t_right_thigh_21;
  const Scalar t_right_thigh_128 = t_right_thigh_127 + neg_zeta_right_shank_y * t_right_shank_33;
  const Scalar t_right_thigh_129 = t_right_thigh_128 - t_right_thigh_20 * t_right_thigh_112;
  const Scalar t_right_thigh_130 = t_right_thigh_129 - u_right_shank * t_right_shank_32;
  const Scalar t_right_thigh_131 = t_right_thigh_130 - u_right_thigh * t_right_thigh_34;
  const Scalar t_right_thigh_132 = t_right_thigh_131 + t_right_shank_3 * t_right_thigh_111;
  const Scalar t_right_thigh_133 = t_right_thigh_132 + t_righ_ankl_cros_6 * t_righ_ankl_cros_83;
  const Scalar t_right_thigh_134 = t_right_thigh_133 + t_right_thigh_5 * t_right_thigh_109;
  const Scalar t_right_thigh_135 = t_right_thigh_134 + left_foot_I3 * t_right_foot_43;
  const Scalar t_right_thigh_136 = t_right_thigh_135 + left_ankle_cross_I1 * t_righ_ankl_cros_11;
  const Scalar t_right_thigh_137 = t_right_thigh_136 - t_righ_ankl_cros_7 * t_right_thigh_113;
  const Scalar t_right_thigh_138 = t_right_thigh_137 + u_righ_ankl_cros * t_righ_ankl_cros_24;
  const Scalar t_right_thigh_139 = t_right_thigh_138 - neg_zeta_right_shank_z * t_right_shank_56;
  const Scalar t_right_thigh_140 = t_right_thigh_139 - zeta_righ_ankl_cros_x * t_righ_ankl_cros_25;
  const Scalar t_right_thigh_141 = t_right_thigh_140 - t_right_thigh_11 * t_right_thigh_74;
  const Scalar t_right_thigh_142 = t_right_thigh_141 - t_right_thigh_1 * t_right_thigh_72;
  const Scalar t_right_thigh_143 = t_right_thigh_142 + t_right_shank_6 * t_right_shank_20;
  const Scalar t_right_thigh_144 = t_right_thigh_143 - t_righ_ankl_cros_5 * t_righ_ankl_cros_42;
  w[261] = t_right_thigh_144;
  const Scalar t_right_thigh_145 = t_right_shank_54 - t_right_shank_89 * t_right_thigh_32;
  w[262] = t_right_thigh_145;
  const Scalar t_right_thigh_146 = left_hip_fork_l1 * t_right_thigh_145;
  w[263] = t_right_thigh_146;
  const Scalar t_right_shank_94 = t_right_shank_64 + t_right_thigh_20 * t_right_thigh_22;
  const Scalar t_right_shank_95 = t_right_shank_94 + t_right_thigh_15 * t_right_thigh_23;
  const Scalar t_right_thigh_147 = t_right_shank_95 + t_right_thigh_7 * t_right_thigh_58;
  const Scalar t_right_thigh_148 = t_right_thigh_147 + u_right_thigh * t_right_thigh_32;
  w[264] = t_right_thigh_148;
}

[[gnu::noinline]] void forward_dynamics_4(const Scalar tau[18], Scalar w[266]) noexcept {
  // right_thigh
  const Scalar t_right_thigh_148 = w[264];
  const Scalar t_right_hip_fork_12 = w[144];
  const Scalar t_right_thigh_146 = w[263];
  const Scalar t_right_thigh_149 = t_right_thigh_148 + t_right_hip_fork_12 * t_right_thigh_146;
  const Scalar t_right_thigh_5 = w[147];
  const Scalar t_right_thigh_105 = w[259];
  const Scalar t_right_thigh_150 = t_right_thigh_149 + t_right_thigh_5 * t_right_thigh_105;
  const Scalar zeta_right_thigh_x = w[145];
  const Scalar t_right_thigh_33 = w[244];
  const Scalar t_right_thigh_151 = t_right_thigh_150 - zeta_right_thigh_x * t_right_thigh_33;
  const Scalar zeta_right_thigh_y = w[146];
  const Scalar t_right_thigh_47 = w[250];
  const Scalar t_right_thigh_152 = t_right_thigh_151 - zeta_right_thigh_y * t_right_thigh_47;
  const Scalar c_q14_q15_q16 = w[19];
  const Scalar t_right_thigh_37 = w[247];
  const Scalar t_right_thigh_49 = w[252];
  const Scalar t_right_thigh_153 = c_q14_q15_q16 * (t_right_thigh_37 + t_right_thigh_49);
  const Scalar t_right_thigh_35 = w[245];
  const Scalar t_right_thigh_48 = w[251];
  const Scalar t_right_thigh_154 = t_right_thigh_35 + t_right_thigh_48;
  const Scalar s_q14_q15_q16 = w[18];
  const Scalar t_right_thigh_155 = t_right_thigh_153 + s_q14_q15_q16 * t_right_thigh_154;
  const Scalar t_right_thigh_156 = s_q14_q15_q16 * t_right_thigh_155;
  const Scalar t_right_thigh_157 = s_q14_q15_q16 * t_right_thigh_47;
  const Scalar t_right_thigh_158 = t_right_thigh_157 - c_q14_q15_q16 * t_right_thigh_33;
  const Scalar t_right_thigh_159 = left_hip_fork_l1 * t_right_thigh_158;
  const Scalar t_right_thigh_160 = t_right_thigh_159 - (t_right_thigh_35 - t_right_thigh_156);
  const Scalar t_right_thigh_161 = c_q14_q15_q16 * t_right_thigh_155;
  const Scalar t_right_thigh_162 = t_right_thigh_49 - t_right_thigh_161;
  const Scalar t_right_thigh_163 = left_hip_fork_I2 - left_hip_fork_l1 * t_right_thigh_162;
  const Scalar t_right_thigh_164 = 2.0 * c_q14_q15_q16;
  const Scalar t_right_thigh_68 = w[256];
  const Scalar t_right_thigh_109 = w[260];
  const Scalar t_right_thigh_165 = s_q14_q15_q16 * (t_right_thigh_68 - t_right_thigh_109);
  const Scalar t_right_thigh_63 = w[255];
  const Scalar t_right_thigh_166 = t_right_thigh_165 - t_right_thigh_63 * t_right_thigh_164;
  const Scalar t_right_thigh_167 = s_q14_q15_q16 * t_right_thigh_105;
  const Scalar t_right_thigh_58 = w[254];
  const Scalar t_right_thigh_168 = t_right_thigh_167 - c_q14_q15_q16 * t_right_thigh_58;
  const Scalar t_right_thigh_169 = left_hip_fork_I11 + t_right_thigh_63;
  const Scalar t_right_thigh_170 = t_right_thigh_169 - left_hip_fork_l1 * t_right_thigh_168;
  const Scalar t_right_thigh_171 = t_right_thigh_170 + c_q14_q15_q16 * t_right_thigh_166;
  w[21] = t_right_thigh_171;
  const Scalar t_right_thigh_31 = w[243];
  const Scalar t_right_thigh_46 = w[249];
  const Scalar t_right_thigh_172 = s_q14_q15_q16 * (t_right_thigh_31 - t_right_thigh_46);
  const Scalar t_right_thigh_30 = w[242];
  const Scalar t_right_thigh_173 = t_right_thigh_30 * t_right_thigh_164 - t_right_thigh_172;
  const Scalar t_right_thigh_174 = t_right_thigh_30 - c_q14_q15_q16 * t_right_thigh_173;
  const Scalar t_right_thigh_175 = s_q14_q15_q16 * t_right_thigh_173;
  const Scalar t_right_thigh_176 = t_right_thigh_31 + t_right_thigh_175;
  const Scalar t_right_thigh_177 = s_q14_q15_q16 * t_right_thigh_166;
  const Scalar t_right_thigh_178 = c_q14_q15_q16 * t_right_thigh_105;
  const Scalar t_right_thigh_179 = t_right_thigh_178 + s_q14_q15_q16 * t_right_thigh_58;
  const Scalar t_right_thigh_180 = t_right_thigh_146 + t_right_thigh_179;
  const Scalar t_right_thigh_181 = t_right_thigh_177 - (left_hip_fork_I16 + t_right_thigh_68);
  w[150] = t_right_thigh_181;
  const Scalar t_right_thigh_182 = left_hip_fork_h1 - t_right_thigh_162;
  w[151] = t_right_thigh_182;
  const Scalar t_right_thigh_183 = t_right_thigh_48 - t_right_thigh_156;
  w[152] = t_right_thigh_183;
  const Scalar t_right_thigh_184 = left_hip_fork_h2 - t_right_thigh_168;
  w[153] = t_right_thigh_184;
  // right_hip_fork: joint force u, 1/pivot, qdd of (1)
  const Scalar t_right_hip_fork_11 = w[142];
  const Scalar u_right_hip_fork_1 = tau[13] - left_hip_fork_I2 * t_right_hip_fork_11;
  const Scalar u_right_hip_fork_2 = u_right_hip_fork_1 + left_hip_fork_I11 * t_right_hip_fork_12;
  const Scalar t_right_thigh_144 = w[261];
  const Scalar u_right_hip_fork_3 = u_right_hip_fork_2 - s_q14_q15_q16 * t_right_thigh_144;
  const Scalar t_right_thigh_104 = w[258];
  const Scalar u_right_hip_fork_4 = u_right_hip_fork_3 - c_q14_q15_q16 * t_right_thigh_104;
  const Scalar t_right_hip_fork_9 = w[140];
  const Scalar t_right_thigh_1 = w[143];
  const Scalar u_right_hip_fork_5 = t_right_hip_fork_9 - t_right_thigh_1;
  const Scalar t_right_hip_fork_10 = w[141];
  const Scalar u_right_hip_fork_6 = u_right_hip_fork_4 - left_hip_fork_I17 * t_right_hip_fork_10;
  const Scalar u_right_hip_fork = u_right_hip_fork_6 - left_hip_fork_I8 * u_right_hip_fork_5;
  w[154] = u_right_hip_fork;
  const Scalar t_right_hip_fork_13 = 1.0 / t_right_thigh_181;
  w[155] = t_right_hip_fork_13;
  const Scalar t_right_hip_fork_14 = t_right_thigh_184 * t_right_hip_fork_13;
  const Scalar t_right_hip_fork_15 = t_right_thigh_163 * t_right_hip_fork_13;
  w[156] = t_right_hip_fork_15;
  const Scalar t_right_hip_fork_16 = t_right_thigh_159 + t_right_thigh_184 * t_right_hip_fork_15;
  const Scalar t_right_hip_fork_17 = t_right_thigh_171 * t_right_hip_fork_13;
  const Scalar t_right_hip_fork_18 = t_right_thigh_180 + t_right_thigh_184 * t_right_hip_fork_17;
  const Scalar t_right_hip_fork_19 = t_right_thigh_152 + left_hip_fork_h2 * t_right_hip_fork_10;
  const Scalar t_right_hip_fork_6 = w[136];
  const Scalar t_right_hip_fork_20 = t_right_hip_fork_19 + t_right_hip_fork_6 * t_right_hip_fork_16;
  const Scalar t_right_hip_fork_7 = w[137];
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_20 - t_right_hip_fork_7 * t_right_hip_fork_18;
  const Scalar t_right_hip_fork_22 = t_right_hip_fork_21 - left_hip_fork_h1 * t_right_thigh_1;
  const Scalar t_right_hip_fork_23 = t_right_hip_fork_22 + u_right_hip_fork * t_right_hip_fork_14;
  w[157] = t_right_hip_fork_23;
  const Scalar t_right_hip_fork_24 = t_right_thigh_182 * t_right_hip_fork_13;
  const Scalar t_right_hip_fork_25 = t_right_thigh_160 + t_right_thigh_171 * t_right_hip_fork_24;
  const Scalar t_right_hip_fork_26 = t_right_thigh_163 * t_right_hip_fork_24;
  const Scalar t_right_hip_fork_27 = t_right_hip_fork_26 + left_hip_fork_l1 * t_right_thigh_176;
  // right_thigh
  const Scalar t_right_thigh_45 = w[248];
  const Scalar t_right_thigh_185 = c_q14_q15_q16 * t_right_thigh_45;
  const Scalar t_right_thigh_57 = w[253];
  const Scalar t_right_thigh_186 = t_right_thigh_185 + s_q14_q15_q16 * t_right_thigh_57;
  const Scalar t_right_thigh_187 = t_right_thigh_186 - left_hip_fork_h2 * t_right_hip_fork_9;
  const Scalar t_right_thigh_188 = t_right_thigh_187 + left_hip_fork_h1 * t_right_hip_fork_10;
  // right_hip_fork
  const Scalar t_right_hip_fork_28 = t_right_thigh_188 + t_right_hip_fork_7 * t_right_hip_fork_25;
  const Scalar t_right_hip_fork_29 = t_right_hip_fork_28 - t_right_hip_fork_6 * t_right_hip_fork_27;
  const Scalar t_right_hip_fork_30 = t_right_hip_fork_29 - u_right_hip_fork * t_right_hip_fork_24;
  w[158] = t_right_hip_fork_30;
  const Scalar t_right_hip_fork_31 = t_right_thigh_171 * t_right_hip_fork_15;
  const Scalar t_right_hip_fork_32 = left_hip_fork_l1 * t_right_thigh_160 + t_right_hip_fork_31;
  const Scalar t_right_hip_fork_33 = left_hip_fork_I8 + t_right_hip_fork_32;
  // right_thigh
  const Scalar t_right_thigh_189 = left_hip_fork_I15 + t_right_thigh_109 + t_right_thigh_177;
  const Scalar t_right_thigh_190 = t_right_thigh_179 + t_right_thigh_180;
  const Scalar t_right_thigh_191 = t_right_thigh_189 + left_hip_fork_l1 * t_right_thigh_190;
  // right_hip_fork
  const Scalar t_right_hip_fork_34 = t_right_thigh_191 + t_right_thigh_171 * t_right_hip_fork_17;
  const Scalar t_right_hip_fork_35 = left_hip_fork_I15 * t_right_hip_fork_12;
  const Scalar t_right_hip_fork_36 = t_right_hip_fork_35 - left_hip_fork_I8 * t_right_hip_fork_11;
  // right_thigh
  const Scalar t_right_thigh_192 = t_right_hip_fork_36 - left_hip_fork_I11 * t_right_hip_fork_10;
  const Scalar t_right_thigh_193 = t_right_thigh_192 + s_q14_q15_q16 * t_right_thigh_104;
  const Scalar t_right_thigh_194 = t_right_thigh_193 - c_q14_q15_q16 * t_right_thigh_144;
  const Scalar t_right_hip_fork_3 = w[132];
  const Scalar t_right_hip_fork_8 = w[139];
  const Scalar t_right_thigh_195 = t_right_hip_fork_3 - t_right_hip_fork_8;
  const Scalar t_right_thigh_196 = t_right_thigh_194 - left_hip_fork_l1 * t_right_thigh_152;
  const Scalar t_right_thigh_197 = t_right_thigh_196 - left_hip_fork_I2 * t_right_thigh_195;
  // right_hip_fork
  const Scalar t_right_hip_fork_37 = t_right_thigh_197 - t_right_hip_fork_6 * t_right_hip_fork_33;
  const Scalar t_right_hip_fork_38 = t_right_hip_fork_37 + t_right_hip_fork_7 * t_right_hip_fork_34;
  const Scalar t_right_hip_fork_39 = t_right_hip_fork_38 - u_right_hip_fork * t_right_hip_fork_17;
  const Scalar t_right_hip_fork_40 = t_right_thigh_163 * t_right_hip_fork_15;
  const Scalar t_right_hip_fork_41 = left_hip_fork_p1 * t_right_thigh_176 + t_right_hip_fork_40;
  const Scalar t_right_hip_fork_42 = left_hip_fork_I10 + t_right_hip_fork_41;
  const Scalar t_right_hip_fork_43 = tau[14] - left_hip_fork_I2 * t_right_hip_fork_10;
  const Scalar t_right_hip_fork_44 = t_right_hip_fork_43 + left_hip_fork_I10 * t_right_hip_fork_11;
  const Scalar t_right_hip_fork_45 = t_right_hip_fork_44 - left_hip_fork_I8 * t_right_hip_fork_12;
  const Scalar t_right_hip_fork_46 = t_right_hip_fork_45 - t_right_hip_fork_7 * t_right_hip_fork_33;
  const Scalar t_right_hip_block_15 = w[134];
  const Scalar t_right_hip_fork_47 = t_right_hip_block_15 - t_right_hip_fork_9;
  const Scalar t_right_hip_fork_48 = t_right_hip_fork_46 - left_hip_fork_l1 * t_right_thigh_186;
  const Scalar t_right_hip_fork_49 = t_right_hip_fork_48 - left_hip_fork_I11 * t_right_hip_fork_47;
  const Scalar t_right_hip_fork_50 = t_right_hip_fork_49 + t_right_hip_fork_6 * t_right_hip_fork_42;
  const Scalar t_right_hip_fork_51 = t_right_hip_fork_50 + u_right_hip_fork * t_right_hip_fork_15;
  const Scalar t_right_hip_fork_52 = t_right_thigh_183 * t_right_hip_fork_13;
  const Scalar t_right_thigh_198 = left_hip_fork_h2 - left_hip_fork_l1 * t_right_thigh_174;
  const Scalar t_right_hip_fork_53 = t_right_thigh_198 + t_right_thigh_163 * t_right_hip_fork_52;
  const Scalar t_right_thigh_199 = c_q14_q15_q16 * t_right_thigh_47;
  const Scalar t_right_thigh_200 = t_right_thigh_199 + s_q14_q15_q16 * t_right_thigh_33;
  const Scalar t_right_hip_fork_54 = t_right_thigh_161 - (left_hip_fork_h1 + t_right_thigh_37);
  const Scalar t_right_hip_fork_55 = t_right_hip_fork_54 + t_right_thigh_171 * t_right_hip_fork_52;
  const Scalar t_right_hip_fork_56 = t_right_hip_fork_55 + left_hip_fork_l1 * t_right_thigh_200;
  const Scalar t_right_hip_fork_57 = t_right_hip_fork_18 - t_right_hip_fork_27;
  const Scalar t_right_hip_fork_58 = t_right_hip_fork_16 + t_right_hip_fork_25;
  const Scalar s_right_hip_roll = w[16];
  const Scalar t_right_hip_fork_59 = s_right_hip_roll * t_right_hip_fork_57;
  const Scalar c_right_hip_roll = w[17];
  const Scalar t_right_hip_fork_60 = t_right_hip_fork_59 - c_right_hip_roll * t_right_hip_fork_58;
  const Scalar t_right_hip_fork_61 = s_right_hip_roll * t_right_hip_fork_60;
  const Scalar t_right_hip_fork_62 = left_hip_block_h4 + t_right_hip_fork_18;
  const Scalar t_right_hip_fork_63 = t_right_hip_fork_61 - t_right_hip_fork_62;
  w[159] = t_right_hip_fork_63;
  const Scalar t_right_hip_fork_64 = 2.0 * s_right_hip_roll;
  const Scalar t_right_hip_fork_65 = t_right_hip_fork_34 - t_right_hip_fork_42;
  const Scalar t_right_hip_fork_66 = t_right_hip_fork_33 * t_right_hip_fork_64;
  const Scalar t_right_hip_fork_67 = c_right_hip_roll * t_right_hip_fork_65 + t_right_hip_fork_66;
  const Scalar t_right_hip_fork_68 = c_right_hip_roll * t_right_hip_fork_67;
  const Scalar t_right_hip_fork_69 = left_hip_block_I19 + t_right_hip_fork_41;
  const Scalar t_right_hip_fork_70 = t_right_hip_fork_68 + t_right_hip_fork_69;
  w[160] = t_right_hip_fork_70;
  const Scalar t_right_hip_fork_71 = t_right_thigh_158 + t_right_thigh_184 * t_right_hip_fork_24;
  const Scalar t_right_thigh_145 = w[262];
  const Scalar t_right_hip_fork_72 = t_right_thigh_145 + t_right_thigh_184 * t_right_hip_fork_14;
  const Scalar t_right_hip_fork_73 = t_right_thigh_176 + t_right_thigh_182 * t_right_hip_fork_24;
  const Scalar t_right_hip_fork_74 = t_right_hip_fork_72 - t_right_hip_fork_73;
  const Scalar t_right_hip_fork_75 = t_right_hip_fork_64 * t_right_hip_fork_71;
  const Scalar t_right_hip_fork_76 = t_right_hip_fork_75 + c_right_hip_roll * t_right_hip_fork_74;
  const Scalar t_right_hip_fork_77 = c_right_hip_roll * t_right_hip_fork_76;
  const Scalar t_right_hip_fork_78 = left_hip_block_I20 + t_right_hip_fork_32;
  const Scalar t_right_hip_fork_79 = t_right_hip_fork_78 - s_right_hip_roll * t_right_hip_fork_67;
  w[161] = t_right_hip_fork_79;
  const Scalar t_right_hip_fork_80 = c_right_hip_roll * t_right_hip_fork_60;
  const Scalar t_right_hip_fork_81 = t_right_hip_fork_16 + t_right_hip_fork_80;
  w[167] = t_right_hip_fork_81;
  const Scalar t_right_hip_fork_82 = left_hip_block_h1 + s_right_hip_roll * t_right_hip_fork_53;
  const Scalar t_right_hip_fork_83 = t_right_hip_fork_82 + c_right_hip_roll * t_right_hip_fork_56;
  w[168] = t_right_hip_fork_83;
  const Scalar t_right_hip_fork_84 = t_right_thigh_174 - t_right_thigh_182 * t_right_hip_fork_52;
  const Scalar t_right_hip_fork_85 = t_right_thigh_200 + t_right_thigh_184 * t_right_hip_fork_52;
  // right_hip_block: joint force u, 1/pivot, qdd of (1)
  const Scalar t_right_hip_block_14 = w[130];
  const Scalar u_right_hip_block_1 = tau[12] - left_hip_block_I15 * t_right_hip_block_14;
  const Scalar t_right_hip_block_16 = w[135];
  const Scalar u_right_hip_block_2 =
      u_right_hip_block_1 - left_hip_block_I16 * t_right_hip_block_16;
  const Scalar u_right_hip_block_3 = u_right_hip_block_2 + c_right_hip_roll * t_right_hip_fork_39;
  const Scalar t_right_hip_block_12 = w[128];
  const Scalar u_right_hip_block_4 = t_right_hip_block_12 - t_right_hip_block_15;
  const Scalar u_right_hip_block_5 = u_right_hip_block_3 - s_right_hip_roll * t_right_hip_fork_51;
  const Scalar u_right_hip_block_6 = u_right_hip_block_5 - left_hip_block_I8 * u_right_hip_block_4;
  const Scalar t_right_hip_block_13 = w[129];
  const Scalar u_right_hip_block = u_right_hip_block_6 - left_hip_block_I18 * t_right_hip_block_13;
  const Scalar t_right_hip_block_17 = 1.0 / t_right_hip_fork_70;
  w[169] = t_right_hip_block_17;
  const Scalar t_right_hip_block_18 = t_right_hip_fork_63 * t_right_hip_block_17;
  const Scalar t_right_hip_block_19 = t_right_hip_fork_83 * t_right_hip_block_17;
  const Scalar t_right_hip_block_20 = t_right_hip_fork_63 * t_right_hip_block_19;
  const Scalar t_right_hip_block_21 = t_right_hip_block_20 - s_right_hip_roll * t_right_hip_fork_84;
  const Scalar t_right_hip_block_22 = t_right_hip_block_21 + c_right_hip_roll * t_right_hip_fork_85;
  w[170] = t_right_hip_block_22;
  const Scalar t_right_hip_fork_86 = base_rx_m3 + t_right_hip_fork_73 + t_right_hip_fork_77;
  const Scalar t_right_hip_block_23 =
      t_right_hip_fork_86 - t_right_hip_fork_63 * t_right_hip_block_18;
  w[171] = t_right_hip_block_23;
  const Scalar t_right_hip_block_24 = t_right_hip_fork_81 * t_right_hip_block_17;
  const Scalar t_right_hip_fork_87 = t_right_hip_fork_71 - s_right_hip_roll * t_right_hip_fork_76;
  const Scalar t_right_hip_block_25 =
      t_right_hip_fork_87 - t_right_hip_fork_81 * t_right_hip_block_18;
  w[172] = t_right_hip_block_25;
  const Scalar t_right_hip_block_26 = t_right_hip_fork_79 * t_right_hip_block_17;
  const Scalar t_right_hip_fork_88 = t_right_hip_fork_25 + t_right_hip_fork_80;
  const Scalar t_right_hip_block_27 =
      t_right_hip_fork_88 - t_right_hip_fork_63 * t_right_hip_block_26;
  w[173] = t_right_hip_block_27;
  const Scalar t_right_hip_block_28 = left_hip_block_I15 * t_right_hip_block_18;
  w[174] = t_right_hip_block_28;
  const Scalar t_right_hip_block_7 = w[126];
  const Scalar t_right_hip_block_29 = u_right_hip_block + left_hip_block_I15 * t_right_hip_block_7;
  const Scalar t_right_hip_block_30 = left_hip_block_h4 * t_right_hip_block_13;
  const Scalar t_right_hip_block_31 = t_right_hip_block_30 - s_right_hip_roll * t_right_hip_fork_30;
  const Scalar t_right_hip_block_32 =
      t_right_hip_block_31 - t_right_hip_block_18 * t_right_hip_block_29;
  const Scalar zeta_right_hip_block_x = w[124];
  const Scalar t_right_hip_block_33 =
      t_right_hip_block_32 + zeta_right_hip_block_x * t_right_hip_block_23;
  const Scalar t_right_hip_block_10 = w[127];
  const Scalar t_right_hip_block_34 =
      t_right_hip_block_33 + t_right_hip_block_10 * t_right_hip_block_27;
  const Scalar zeta_right_hip_block_y = w[123];
  const Scalar t_right_hip_block_35 =
      t_right_hip_block_34 - zeta_right_hip_block_y * t_right_hip_block_22;
  const Scalar t_right_hip_block_36 = t_right_hip_block_35 + c_right_hip_roll * t_right_hip_fork_23;
  const Scalar t_right_hip_block_37 =
      t_right_hip_block_36 + left_hip_block_h1 * t_right_hip_block_12;
  const Scalar t_right_hip_block_5 = w[125];
  const Scalar t_right_hip_block_38 =
      t_right_hip_block_37 + t_right_hip_block_5 * t_right_hip_block_25;
  w[175] = t_right_hip_block_38;
  const Scalar t_right_hip_fork_89 = c_right_hip_roll * t_right_hip_fork_84;
  const Scalar t_right_hip_fork_90 = t_right_hip_fork_89 + s_right_hip_roll * t_right_hip_fork_85;
  const Scalar t_right_hip_block_39 =
      t_right_hip_fork_90 - t_right_hip_fork_83 * t_right_hip_block_24;
  w[176] = t_right_hip_block_39;
  const Scalar t_right_hip_block_40 = t_right_hip_fork_79 * t_right_hip_block_19;
  const Scalar t_right_hip_block_41 = s_right_hip_roll * t_right_hip_fork_56 + t_right_hip_block_40;
  const Scalar t_right_hip_block_42 = t_right_hip_block_41 - c_right_hip_roll * t_right_hip_fork_53;
  w[177] = t_right_hip_block_42;
  const Scalar t_right_hip_block_43 = left_hip_block_I15 * t_right_hip_block_19;
  w[178] = t_right_hip_block_43;
  const Scalar t_right_hip_fork_91 = t_right_thigh_175 - (base_rx_m3 + t_right_thigh_46);
  const Scalar t_right_hip_fork_92 = t_right_hip_fork_91 - t_right_thigh_183 * t_right_hip_fork_52;
  const Scalar t_right_hip_block_44 =
      t_right_hip_fork_92 + t_right_hip_fork_83 * t_right_hip_block_19;
  w[180] = t_right_hip_block_44;
  const Scalar t_right_hip_block_45 = left_hip_block_h1 * t_right_hip_block_13;
  const Scalar t_right_hip_block_46 = t_right_hip_block_45 - left_hip_fork_h1 * t_right_hip_fork_12;
  const Scalar t_right_hip_block_47 = t_right_hip_block_46 - left_hip_fork_h2 * t_right_hip_fork_11;
  const Scalar t_right_hip_block_48 = t_right_hip_block_47 + c_q14_q15_q16 * t_right_thigh_57;
  const Scalar t_right_hip_block_49 = t_right_hip_block_48 - s_q14_q15_q16 * t_right_thigh_45;
  const Scalar t_right_hip_block_50 =
      t_right_hip_block_49 - zeta_right_hip_block_y * t_right_hip_block_44;
  const Scalar t_right_hip_block_51 =
      t_right_hip_block_50 + left_hip_block_h4 * t_right_hip_block_15;
  const Scalar t_right_hip_block_52 =
      t_right_hip_block_51 + t_right_hip_block_5 * t_right_hip_block_39;
  const Scalar t_right_hip_block_53 =
      t_right_hip_block_52 - t_right_hip_fork_6 * t_right_hip_fork_53;
  const Scalar t_right_hip_block_54 =
      t_right_hip_block_53 - zeta_right_hip_block_x * t_right_hip_block_22;
  const Scalar t_right_hip_block_55 =
      t_right_hip_block_54 - t_right_hip_block_10 * t_right_hip_block_42;
  const Scalar t_right_hip_block_56 =
      t_right_hip_block_55 - t_right_hip_block_19 * t_right_hip_block_29;
  const Scalar t_right_hip_block_57 = t_right_hip_block_56 - u_right_hip_fork * t_right_hip_fork_52;
  const Scalar t_right_hip_block_58 =
      t_right_hip_block_57 + t_right_hip_fork_7 * t_right_hip_fork_56;
  w[184] = t_right_hip_block_58;
  const Scalar t_right_hip_fork_93 = t_right_hip_fork_72 - t_right_hip_fork_77;
  const Scalar t_right_hip_block_59 =
      t_right_hip_fork_93 - t_right_hip_fork_81 * t_right_hip_block_24;
  w[185] = t_right_hip_block_59;
  const Scalar t_right_hip_block_60 = base_rx_m3 + t_right_hip_block_59;
  w[186] = t_right_hip_block_60;
  const Scalar t_right_hip_fork_94 = left_hip_block_h4 + t_right_hip_fork_27;
  const Scalar t_right_hip_fork_95 = t_right_hip_fork_61 + t_right_hip_fork_94;
  const Scalar t_right_hip_block_61 =
      t_right_hip_fork_95 + t_right_hip_fork_79 * t_right_hip_block_24;
  w[187] = t_right_hip_block_61;
  const Scalar t_right_hip_block_62 = left_hip_block_h1 - left_hip_block_I15 * t_right_hip_block_24;
  w[192] = t_right_hip_block_62;
  const Scalar t_right_hip_block_63 = left_hip_block_I15 * t_right_hip_block_26;
  w[193] = t_right_hip_block_63;
  const Scalar t_right_hip_block_64 = left_hip_block_I8 + t_right_hip_block_63;
  w[194] = t_right_hip_block_64;
  const Scalar t_right_hip_block_65 = left_hip_block_p2 * t_right_hip_block_17;
  w[195] = t_right_hip_block_65;
  const Scalar t_right_hip_block_66 = left_hip_block_I10 - t_right_hip_block_65;
  w[196] = t_right_hip_block_66;
  const Scalar t_right_hip_block_67 = u_right_hip_block * t_right_hip_block_17;
  w[197] = t_right_hip_block_67;
  const Scalar t_right_hip_block_68 = t_right_hip_block_13 + t_right_hip_block_67;
  const Scalar t_right_hip_block_69 =
      t_right_hip_block_68 + zeta_right_hip_block_x * t_right_hip_block_18;
  const Scalar t_right_hip_block_70 = tau[13] - left_hip_block_I8 * t_right_hip_block_16;
  const Scalar t_right_hip_block_71 =
      t_right_hip_block_70 + left_hip_block_I10 * t_right_hip_block_14;
  const Scalar t_base_px_5 = w[46];
  const Scalar t_right_hip_block_72 = t_base_px_5 - t_right_hip_block_12;
  const Scalar t_right_hip_block_73 =
      t_right_hip_block_71 + t_right_hip_block_7 * t_right_hip_block_66;
  const Scalar t_right_hip_block_74 =
      t_right_hip_block_73 + left_hip_block_I16 * t_right_hip_block_72;
  const Scalar t_right_hip_block_75 =
      t_right_hip_block_69 + zeta_right_hip_block_y * t_right_hip_block_19;
  const Scalar t_right_hip_block_76 =
      t_right_hip_block_74 - t_right_hip_block_10 * t_right_hip_block_64;
  const Scalar t_right_hip_block_77 =
      t_right_hip_block_76 - left_hip_block_I15 * t_right_hip_block_75;
  const Scalar t_right_hip_block_78 =
      t_right_hip_block_77 + t_right_hip_block_5 * t_right_hip_block_62;
  w[198] = t_right_hip_block_78;
  const Scalar t_right_hip_fork_96 = t_right_hip_fork_34 - t_right_hip_fork_68;
  const Scalar t_right_hip_block_79 =
      t_right_hip_fork_96 - t_right_hip_fork_79 * t_right_hip_block_26;
  w[199] = t_right_hip_block_79;
  const Scalar t_right_hip_block_80 = left_hip_block_I17 + t_right_hip_block_79;
  w[201] = t_right_hip_block_80;
  const Scalar t_right_hip_block_81 = left_hip_block_I17 * t_right_hip_block_16;
  const Scalar t_right_hip_block_82 =
      left_hip_block_I8 * t_right_hip_block_14 - t_right_hip_block_81;
  const Scalar t_right_hip_block_83 =
      t_right_hip_block_82 - left_hip_block_I16 * t_right_hip_block_13;
  const Scalar t_right_hip_block_84 = t_right_hip_block_83 + s_right_hip_roll * t_right_hip_fork_39;
  const Scalar t_right_hip_block_85 = t_right_hip_block_84 + c_right_hip_roll * t_right_hip_fork_51;
  const Scalar t_right_hip_block_86 =
      t_right_hip_block_85 + t_right_hip_block_7 * t_right_hip_block_64;
  const Scalar t_right_hip_block_87 = t_base_px_5 - t_right_hip_block_15;
  const Scalar t_right_hip_block_88 =
      t_right_hip_block_86 - t_right_hip_block_10 * t_right_hip_block_80;
  const Scalar t_right_hip_block_89 =
      t_right_hip_block_88 + left_hip_block_I15 * t_right_hip_block_87;
  w[205] = t_right_hip_block_89;
}

[[gnu::noinline]] void forward_dynamics_5(const Scalar tau[18], Scalar w[266]) noexcept {
  // right_hip_block
  const Scalar t_right_hip_block_89 = w[205];
  const Scalar t_right_hip_fork_79 = w[161];
  const Scalar t_right_hip_block_67 = w[197];
  const Scalar t_right_hip_block_90 =
      t_right_hip_block_89 + t_right_hip_fork_79 * t_right_hip_block_67;
  const Scalar t_right_hip_block_5 = w[125];
  const Scalar t_right_hip_block_61 = w[187];
  const Scalar t_right_hip_block_91 =
      t_right_hip_block_90 + t_right_hip_block_5 * t_right_hip_block_61;
  const Scalar zeta_right_hip_block_y = w[123];
  const Scalar t_right_hip_block_42 = w[177];
  const Scalar t_right_hip_block_92 =
      t_right_hip_block_91 + zeta_right_hip_block_y * t_right_hip_block_42;
  const Scalar zeta_right_hip_block_x = w[124];
  const Scalar t_right_hip_block_27 = w[173];
  const Scalar t_right_hip_block_93 =
      t_right_hip_block_92 - zeta_right_hip_block_x * t_right_hip_block_27;
  w[128] = t_right_hip_block_93;
  const Scalar c_right_hip_yaw = w[15];
  const Scalar t_right_hip_block_94 = 2.0 * c_right_hip_yaw;
  const Scalar t_right_hip_block_23 = w[171];
  const Scalar t_right_hip_block_44 = w[180];
  const Scalar t_right_hip_block_95 = t_right_hip_block_23 + t_right_hip_block_44;
  const Scalar t_right_hip_block_22 = w[170];
  const Scalar t_right_hip_block_96 = t_right_hip_block_22 * t_right_hip_block_94;
  const Scalar s_right_hip_yaw = w[14];
  const Scalar t_right_hip_block_97 = t_right_hip_block_96 - s_right_hip_yaw * t_right_hip_block_95;
  w[129] = t_right_hip_block_97;
  const Scalar t_right_hip_block_98 = s_right_hip_yaw * t_right_hip_block_97;
  w[132] = t_right_hip_block_98;
  const Scalar t_right_hip_block_43 = w[178];
  const Scalar t_right_hip_block_99 = t_right_hip_block_27 + t_right_hip_block_43;
  const Scalar t_right_hip_block_28 = w[174];
  const Scalar t_right_hip_block_100 = t_right_hip_block_28 + t_right_hip_block_42;
  const Scalar t_right_hip_block_101 = s_right_hip_yaw * t_right_hip_block_99;
  const Scalar t_right_hip_block_102 =
      t_right_hip_block_101 - c_right_hip_yaw * t_right_hip_block_100;
  const Scalar t_right_hip_block_103 = c_right_hip_yaw * t_right_hip_block_102;
  w[134] = t_right_hip_block_103;
  const Scalar t_right_hip_block_25 = w[172];
  const Scalar t_right_hip_block_104 = c_right_hip_yaw * t_right_hip_block_25;
  const Scalar t_right_hip_block_39 = w[176];
  const Scalar t_right_hip_block_105 =
      t_right_hip_block_104 - s_right_hip_yaw * t_right_hip_block_39;
  w[139] = t_right_hip_block_105;
  const Scalar t_right_hip_block_62 = w[192];
  const Scalar t_right_hip_block_106 = c_right_hip_yaw * t_right_hip_block_62;
  const Scalar t_right_hip_block_107 =
      t_right_hip_block_106 - s_right_hip_yaw * t_right_hip_block_61;
  w[140] = t_right_hip_block_107;
  const Scalar t_right_hip_block_60 = w[186];
  const Scalar t_right_hip_block_108 =
      t_right_hip_block_107 + left_hip_block_l1 * t_right_hip_block_60;
  const Scalar t_right_hip_block_109 =
      t_right_hip_block_108 - left_hip_block_l2 * t_right_hip_block_105;
  w[141] = t_right_hip_block_109;
  const Scalar t_right_hip_block_66 = w[196];
  const Scalar t_right_hip_block_80 = w[201];
  const Scalar t_right_hip_block_110 = t_right_hip_block_66 - t_right_hip_block_80;
  const Scalar t_right_hip_block_64 = w[194];
  const Scalar t_right_hip_block_111 = t_right_hip_block_64 * t_right_hip_block_94;
  const Scalar t_right_hip_block_112 =
      s_right_hip_yaw * t_right_hip_block_110 + t_right_hip_block_111;
  w[142] = t_right_hip_block_112;
  const Scalar t_right_hip_block_113 = s_right_hip_yaw * t_right_hip_block_102;
  w[143] = t_right_hip_block_113;
  const Scalar t_right_hip_block_114 = t_right_hip_block_44 + t_right_hip_block_98;
  w[144] = t_right_hip_block_114;
  // left_foot: joint force u of (1)
  const Scalar t_left_foot_3 = w[117];
  const Scalar t_left_foot_4 = w[118];
  const Scalar t_left_foot_9 = t_left_foot_3 - t_left_foot_4;
  const Scalar t_left_ankle_cross_10 = w[112];
  const Scalar t_left_foot_5 = w[119];
  const Scalar t_left_foot_10 = t_left_ankle_cross_10 - t_left_foot_5;
  const Scalar t_left_foot_7 = w[121];
  const Scalar u_left_foot_1 = tau[11] + left_foot_I1 * t_left_foot_7;
  const Scalar t_left_foot_8 = w[122];
  const Scalar u_left_foot_2 = u_left_foot_1 + left_foot_I2 * t_left_foot_8;
  const Scalar u_left_foot_3 = t_left_foot_9 + t_left_foot_10;
  const Scalar u_left_foot_4 = u_left_foot_2 + left_foot_I14 * u_left_foot_3;
  const Scalar t_left_foot_6 = w[120];
  const Scalar u_left_foot = u_left_foot_4 - left_foot_I8 * t_left_foot_6;
  w[206] = u_left_foot;
  const Scalar t_left_foot_11 = left_foot_h1 * t_left_foot_6 + left_foot_p2 * u_left_foot;
  const Scalar t_left_foot_2 = w[116];
  const Scalar t_left_foot_12 = t_left_foot_11 + left_foot_h3 * t_left_foot_2;
  const Scalar t_left_foot_1 = w[115];
  const Scalar t_left_foot_13 = t_left_foot_12 + left_foot_h2 * t_left_foot_1;
  const Scalar zeta_left_foot_y = w[114];
  const Scalar t_left_foot_14 = t_left_foot_13 - left_foot_m1 * zeta_left_foot_y;
  const Scalar t_left_foot_15 = left_foot_h1 * t_left_foot_5;
  const Scalar c_left_foot = w[13];
  const Scalar s_left_foot = w[12];
  const Scalar t_left_foot_16 = c_left_foot * t_left_foot_15 + s_left_foot * t_left_foot_14;
  const Scalar t_left_foot_17 = left_foot_I13 * t_left_foot_8;
  const Scalar t_left_foot_18 = left_foot_I2 * t_left_foot_6 + t_left_foot_17;
  const Scalar t_left_foot_19 = t_left_foot_18 + left_foot_I14 * t_left_foot_7;
  const Scalar t_left_foot_20 = t_left_foot_19 + left_foot_k3 * u_left_foot;
  const Scalar t_left_foot_21 = t_left_foot_20 + left_foot_I17 * t_left_foot_2;
  const Scalar t_left_foot_22 = t_left_foot_21 + left_foot_I15 * t_left_foot_1;
  const Scalar t_left_foot_23 = t_left_foot_22 + left_foot_I1 * t_left_foot_9;
  const Scalar t_left_foot_24 = t_left_foot_23 - left_foot_h3 * zeta_left_foot_y;
  const Scalar t_left_foot_25 = left_foot_I14 * t_left_foot_8;
  const Scalar t_left_foot_26 = left_foot_I1 * t_left_foot_6 - t_left_foot_25;
  const Scalar t_left_foot_27 = t_left_foot_26 - left_foot_I12 * t_left_foot_7;
  const Scalar t_left_thigh_10 = w[76];
  const Scalar t_left_foot_28 = t_left_foot_27 - left_foot_I4 * t_left_thigh_10;
  const Scalar t_left_foot_29 = t_left_foot_28 + left_foot_I16 * t_left_foot_1;
  const Scalar t_left_foot_30 = t_left_foot_29 - left_foot_I15 * t_left_foot_2;
  const Scalar t_left_foot_31 = t_left_foot_30 - left_foot_k2 * u_left_foot;
  const Scalar t_left_ankle_cross_11 = w[113];
  const Scalar t_left_foot_32 = t_left_foot_31 + left_foot_I3 * t_left_ankle_cross_11;
  const Scalar t_left_foot_33 = t_left_foot_32 + left_foot_h2 * zeta_left_foot_y;
  const Scalar t_left_foot_34 = t_left_foot_33 - left_foot_I2 * t_left_foot_10;
  const Scalar t_left_foot_35 = t_left_foot_1 - t_left_foot_7;
  const Scalar t_left_foot_36 = left_foot_m1 * s_left_foot;
  const Scalar t_left_foot_37 = s_left_foot * t_left_foot_36;
  const Scalar t_left_foot_38 = c_left_foot * t_left_foot_36;
  const Scalar t_left_foot_39 = left_hip_fork_l1 * t_left_foot_37;
  const Scalar t_left_foot_40 = t_left_foot_39 + left_hip_fork_l3 * t_left_foot_38;
  const Scalar t_left_foot_41 = left_foot_h4 - t_left_foot_40;
  const Scalar t_left_foot_42 = left_hip_fork_l3 * t_left_foot_37;
  const Scalar t_left_foot_43 = t_left_foot_42 - left_hip_fork_l1 * t_left_foot_38;
  const Scalar t_left_foot_44 = left_foot_h3 * c_left_foot + left_foot_h2 * s_left_foot;
  const Scalar t_left_foot_45 = c_left_foot * t_left_foot_44;
  const Scalar t_left_foot_46 = s_left_foot * t_left_foot_44;
  const Scalar t_left_foot_47 = left_foot_h2 - t_left_foot_46;
  w[209] = t_left_foot_47;
  const Scalar t_left_foot_48 = left_ankle_cross_I18 + left_hip_fork_l3 * t_left_foot_45;
  const Scalar t_left_foot_49 = t_left_foot_48 + left_hip_fork_l1 * t_left_foot_46;
  w[210] = t_left_foot_49;
  const Scalar t_left_foot_50 = left_foot_I19 * c_left_foot - left_foot_I18 * s_left_foot;
  const Scalar t_left_foot_51 = left_ankle_cross_I16 - left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_52 = left_foot_I3 + t_left_foot_50;
  const Scalar t_left_foot_53 = t_left_foot_51 + c_left_foot * t_left_foot_52;
  w[211] = t_left_foot_53;
  const Scalar t_left_foot_54 = s_left_foot * t_left_foot_50;
  const Scalar t_left_foot_55 = left_ankle_cross_I15 + t_left_foot_54;
  const Scalar t_left_foot_56 = t_left_foot_55 + left_foot_I10 * c_left_foot;
  w[212] = t_left_foot_56;
  const Scalar t_left_foot_57 = left_ankle_cross_h3 + t_left_foot_45;
  w[214] = t_left_foot_57;
  const Scalar t_left_foot_58 = left_ankle_cross_h1 + left_foot_h1 * c_left_foot;
  w[215] = t_left_foot_58;
  // left_ankle_cross: joint force u, 1/pivot of (1)
  const Scalar t_left_thigh_5 = w[73];
  const Scalar t_left_thigh_15 = w[80];
  const Scalar t_left_ankle_cross_12 = t_left_thigh_5 - t_left_thigh_15;
  const Scalar u_left_ankle_cross_1 = tau[10] + c_left_foot * t_left_foot_34;
  const Scalar u_left_ankle_cross_2 = u_left_ankle_cross_1 + s_left_foot * t_left_foot_24;
  const Scalar u_left_ankle_cross_3 =
      u_left_ankle_cross_2 + left_ankle_cross_I14 * t_left_ankle_cross_11;
  const Scalar u_left_ankle_cross_4 = u_left_ankle_cross_3 - left_ankle_cross_I17 * t_left_thigh_10;
  const Scalar t_left_ankle_cross_9 = w[111];
  const Scalar u_left_ankle_cross_5 =
      u_left_ankle_cross_4 + left_ankle_cross_I1 * t_left_ankle_cross_9;
  const Scalar u_left_ankle_cross_6 =
      u_left_ankle_cross_5 + left_ankle_cross_I7 * t_left_ankle_cross_12;
  const Scalar u_left_ankle_cross = u_left_ankle_cross_6 + left_foot_I4 * t_left_foot_35;
  w[216] = u_left_ankle_cross;
  const Scalar t_left_ankle_cross_13 = 1.0 / t_left_foot_56;
  w[217] = t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_14 = t_left_foot_58 * t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_15 = t_left_foot_57 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_16 = t_left_foot_58 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_17 = left_shank_m2 - t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_18 = t_left_foot_47 * t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_19 = t_left_foot_47 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_20 = t_left_foot_53 * t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_21 = t_left_foot_58 * t_left_ankle_cross_20;
  const Scalar t_left_ankle_cross_22 = left_foot_h1 * s_left_foot + t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_23 = t_left_foot_49 * t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_24 = t_left_foot_58 * t_left_ankle_cross_23;
  const Scalar t_left_ankle_cross_6 = w[109];
  const Scalar t_left_ankle_cross_25 = t_left_ankle_cross_6 * t_left_ankle_cross_24;
  const Scalar t_left_ankle_cross_26 =
      left_ankle_cross_h1 * t_left_thigh_10 - t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_5 = w[108];
  const Scalar t_left_ankle_cross_27 =
      t_left_ankle_cross_26 - t_left_ankle_cross_5 * t_left_ankle_cross_22;
  const Scalar t_left_ankle_cross_28 =
      t_left_ankle_cross_27 + left_ankle_cross_h2 * t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_2 = w[105];
  const Scalar t_left_ankle_cross_29 =
      t_left_ankle_cross_28 - t_left_ankle_cross_2 * t_left_ankle_cross_17;
  const Scalar zeta_left_ankle_cross_z = w[107];
  const Scalar t_left_ankle_cross_30 =
      t_left_ankle_cross_29 + zeta_left_ankle_cross_z * t_left_ankle_cross_19;
  const Scalar zeta_left_ankle_cross_x = w[106];
  const Scalar t_left_ankle_cross_31 =
      u_left_ankle_cross - zeta_left_ankle_cross_x * t_left_foot_57;
  const Scalar t_left_ankle_cross_32 = t_left_ankle_cross_30 - left_foot_h1 * t_left_foot_35;
  const Scalar t_left_ankle_cross_33 =
      t_left_ankle_cross_32 + t_left_ankle_cross_14 * t_left_ankle_cross_31;
  const Scalar t_left_ankle_cross_34 = t_left_foot_57 * t_left_ankle_cross_13;
  const Scalar t_left_foot_59 = left_shank_m2 - t_left_foot_37;
  const Scalar t_left_ankle_cross_35 = t_left_foot_59 - t_left_foot_57 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_36 = t_left_foot_38 + t_left_foot_57 * t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_37 = t_left_foot_46 + t_left_foot_53 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_38 = t_left_foot_43 + t_left_foot_57 * t_left_ankle_cross_23;
  const Scalar t_left_foot_60 = t_left_foot_16 + left_ankle_cross_h2 * t_left_thigh_10;
  const Scalar t_left_ankle_cross_8 = w[110];
  const Scalar t_left_foot_61 = t_left_foot_60 + left_ankle_cross_h1 * t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_39 =
      t_left_foot_61 - zeta_left_ankle_cross_x * t_left_ankle_cross_35;
  const Scalar t_left_ankle_cross_40 =
      t_left_ankle_cross_39 + t_left_ankle_cross_5 * t_left_ankle_cross_37;
  const Scalar t_left_ankle_cross_41 =
      t_left_ankle_cross_40 - t_left_ankle_cross_2 * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_42 =
      t_left_ankle_cross_41 - zeta_left_ankle_cross_z * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_43 =
      t_left_ankle_cross_42 + t_left_ankle_cross_6 * t_left_ankle_cross_38;
  const Scalar t_left_ankle_cross_44 =
      t_left_ankle_cross_43 - u_left_ankle_cross * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_45 = t_left_foot_37 - t_left_foot_47 * t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_46 = left_shank_m3 + t_left_ankle_cross_45;
  const Scalar t_left_foot_62 = left_ankle_cross_h2 - t_left_foot_45;
  const Scalar t_left_ankle_cross_47 = t_left_foot_62 - t_left_foot_47 * t_left_ankle_cross_20;
  const Scalar t_left_foot_63 = left_ankle_cross_h4 - t_left_foot_40;
  const Scalar t_left_ankle_cross_48 = t_left_foot_63 - t_left_foot_49 * t_left_ankle_cross_18;
  // left_foot
  const Scalar t_left_foot_64 = s_left_foot * t_left_foot_15 - c_left_foot * t_left_foot_14;
  const Scalar t_left_foot_65 = t_left_foot_64 - left_ankle_cross_h1 * t_left_ankle_cross_9;
  const Scalar t_left_foot_66 = t_left_foot_65 + left_ankle_cross_h2 * t_left_ankle_cross_11;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_49 =
      t_left_foot_66 - zeta_left_ankle_cross_z * t_left_ankle_cross_46;
  const Scalar t_left_ankle_cross_50 =
      t_left_ankle_cross_49 - zeta_left_ankle_cross_x * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_51 = u_left_ankle_cross + t_left_ankle_cross_2 * t_left_foot_58;
  const Scalar t_left_ankle_cross_52 =
      t_left_ankle_cross_50 + t_left_ankle_cross_5 * t_left_ankle_cross_47;
  const Scalar t_left_ankle_cross_53 =
      t_left_ankle_cross_52 + t_left_ankle_cross_18 * t_left_ankle_cross_51;
  const Scalar t_left_ankle_cross_54 =
      t_left_ankle_cross_53 + t_left_ankle_cross_6 * t_left_ankle_cross_48;
  const Scalar neg_s_left_ankle_cross_x = w[29];
  const Scalar t_left_ankle_cross_55 =
      t_left_ankle_cross_48 + neg_s_left_ankle_cross_x * t_left_ankle_cross_46;
  const Scalar s_left_ankle_cross_y = w[28];
  const Scalar t_left_ankle_cross_56 =
      t_left_ankle_cross_47 - s_left_ankle_cross_y * t_left_ankle_cross_46;
  const Scalar t_left_ankle_cross_57 = s_left_ankle_cross_y * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_58 = t_left_ankle_cross_37 - t_left_ankle_cross_57;
  const Scalar t_left_ankle_cross_59 =
      t_left_ankle_cross_22 - s_left_ankle_cross_y * t_left_ankle_cross_19;
  const Scalar t_left_shank_14 = w[98];
  const Scalar t_left_ankle_cross_60 =
      t_left_shank_14 - neg_s_left_ankle_cross_x * t_left_ankle_cross_59;
  const Scalar t_left_ankle_cross_61 =
      t_left_ankle_cross_60 - s_left_ankle_cross_y * t_left_ankle_cross_58;
  w[218] = t_left_ankle_cross_61;
  const Scalar t_left_ankle_cross_62 = neg_s_left_ankle_cross_x * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_63 = t_left_ankle_cross_24 + t_left_ankle_cross_62;
  const Scalar t_left_ankle_cross_64 =
      t_left_ankle_cross_38 + neg_s_left_ankle_cross_x * t_left_ankle_cross_36;
  const Scalar t_left_shank_19 = w[102];
  const Scalar t_left_ankle_cross_65 =
      t_left_shank_19 - s_left_ankle_cross_y * t_left_ankle_cross_64;
  const Scalar t_left_ankle_cross_66 =
      t_left_ankle_cross_65 - neg_s_left_ankle_cross_x * t_left_ankle_cross_63;
  w[219] = t_left_ankle_cross_66;
  const Scalar t_left_ankle_cross_67 = neg_s_left_ankle_cross_x * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_68 =
      s_left_ankle_cross_y * t_left_ankle_cross_35 - t_left_ankle_cross_67;
  const Scalar t_left_ankle_cross_69 = neg_s_left_ankle_cross_x * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_70 =
      t_left_ankle_cross_69 - s_left_ankle_cross_y * t_left_ankle_cross_15;
  const Scalar t_left_shank_11 = w[96];
  const Scalar t_left_shank_16 = w[100];
  const Scalar t_left_shank_23 = t_left_shank_11 + t_left_shank_16;
  const Scalar t_left_ankle_cross_71 =
      t_left_shank_23 + neg_s_left_ankle_cross_x * t_left_ankle_cross_70;
  const Scalar t_left_ankle_cross_72 =
      t_left_ankle_cross_71 + s_left_ankle_cross_y * t_left_ankle_cross_68;
  w[220] = t_left_ankle_cross_72;
  const Scalar t_left_shank_21 = w[104];
  const Scalar t_left_ankle_cross_73 = t_left_shank_21 + t_left_ankle_cross_70;
  w[221] = t_left_ankle_cross_73;
  const Scalar t_left_shank_20 = w[103];
  const Scalar t_left_ankle_cross_74 = t_left_shank_20 - t_left_ankle_cross_68;
  w[222] = t_left_ankle_cross_74;
  const Scalar t_left_ankle_cross_75 = t_left_ankle_cross_57 + t_left_ankle_cross_62;
  w[223] = t_left_ankle_cross_75;
  // left_shank: joint force u, 1/pivot of (1)
  const Scalar t_left_shank_12 = w[97];
  const Scalar u_left_shank_2 = tau[9] - tau[10] - t_left_shank_12 * t_left_shank_14;
  const Scalar u_left_shank_3 = u_left_shank_2 - s_left_ankle_cross_y * t_left_ankle_cross_44;
  const Scalar u_left_shank_1 = w[94];
  const Scalar u_left_shank_4 = u_left_shank_3 + u_left_shank_1 * t_left_ankle_cross_12;
  const Scalar u_left_shank_5 = t_left_shank_11 - t_left_shank_16;
  const Scalar u_left_shank_6 = u_left_shank_4 - t_left_thigh_10 * u_left_shank_5;
  const Scalar u_left_shank_7 = u_left_shank_6 + neg_s_left_ankle_cross_x * t_left_ankle_cross_33;
  const Scalar t_left_shank_17 = w[101];
  const Scalar u_left_shank = u_left_shank_7 - t_left_shank_17 * t_left_shank_19;
  w[224] = u_left_shank;
  const Scalar inverse_pivot_left_shank = 1.0 / t_left_ankle_cross_72;
  w[225] = inverse_pivot_left_shank;
  const Scalar t_left_shank_24 = t_left_ankle_cross_74 * inverse_pivot_left_shank;
  const Scalar t_left_shank_25 = t_left_ankle_cross_73 * inverse_pivot_left_shank;
  const Scalar t_left_shank_26 = t_left_ankle_cross_15 - t_left_ankle_cross_74 * t_left_shank_25;
  const Scalar t_left_ankle_cross_76 = left_thigh_m1 - t_left_ankle_cross_35;
  const Scalar t_left_shank_27 = t_left_ankle_cross_76 + t_left_ankle_cross_74 * t_left_shank_24;
  const Scalar t_left_shank_28 = t_left_ankle_cross_75 * inverse_pivot_left_shank;
  const Scalar t_left_shank_29 = t_left_ankle_cross_36 + t_left_ankle_cross_74 * t_left_shank_28;
  const Scalar t_left_shank_30 = t_left_ankle_cross_58 - t_left_ankle_cross_61 * t_left_shank_24;
  const Scalar t_left_shank_31 = t_left_ankle_cross_66 * inverse_pivot_left_shank;
  const Scalar t_left_shank_32 = t_left_ankle_cross_64 - t_left_ankle_cross_66 * t_left_shank_24;
  const Scalar t_left_shank_33 = t_left_ankle_cross_44 + t_left_thigh_10 * t_left_shank_20;
  const Scalar t_left_shank_3 = w[90];
  const Scalar t_left_shank_34 = t_left_shank_33 + t_left_shank_3 * t_left_shank_30;
  const Scalar t_left_shank_4 = w[91];
  const Scalar t_left_shank_35 = t_left_shank_34 + t_left_shank_4 * t_left_shank_32;
  const Scalar zeta_left_shank_x = w[88];
  const Scalar t_left_shank_36 = t_left_shank_35 + zeta_left_shank_x * t_left_shank_27;
  const Scalar t_left_shank_15 = w[99];
  const Scalar t_left_shank_37 = t_left_shank_36 - t_left_shank_15 * t_left_shank_21;
  const Scalar t_left_shank_38 = t_left_shank_37 - u_left_shank * t_left_shank_24;
  const Scalar neg_zeta_left_shank_y = w[87];
  const Scalar t_left_shank_39 = t_left_shank_38 - neg_zeta_left_shank_y * t_left_shank_26;
  const Scalar neg_zeta_left_shank_z = w[89];
  const Scalar t_left_shank_40 = t_left_shank_39 + neg_zeta_left_shank_z * t_left_shank_29;
  const Scalar t_left_ankle_cross_77 = left_thigh_m2 - t_left_ankle_cross_16;
  const Scalar t_left_shank_41 = t_left_ankle_cross_77 - t_left_ankle_cross_73 * t_left_shank_25;
  const Scalar t_left_shank_42 = t_left_ankle_cross_19 - t_left_ankle_cross_75 * t_left_shank_25;
  const Scalar t_left_shank_43 = t_left_ankle_cross_63 + t_left_ankle_cross_66 * t_left_shank_25;
  const Scalar t_left_shank_44 = t_left_ankle_cross_59 + t_left_ankle_cross_61 * t_left_shank_25;
  const Scalar t_left_shank_6 = w[92];
  const Scalar t_left_ankle_cross_78 = t_left_ankle_cross_33 + t_left_shank_6 * t_left_shank_20;
  const Scalar t_left_ankle_cross_79 = t_left_ankle_cross_78 - t_left_thigh_10 * t_left_shank_21;
  const Scalar t_left_shank_45 = t_left_ankle_cross_79 - t_left_shank_4 * t_left_shank_43;
  const Scalar t_left_shank_46 = t_left_shank_45 - neg_zeta_left_shank_y * t_left_shank_41;
  const Scalar t_left_shank_47 = t_left_shank_46 - u_left_shank * t_left_shank_25;
  const Scalar t_left_shank_48 = t_left_shank_47 - t_left_shank_3 * t_left_shank_44;
  const Scalar t_left_shank_49 = t_left_shank_48 - zeta_left_shank_x * t_left_shank_26;
  const Scalar t_left_shank_50 = t_left_shank_49 - neg_zeta_left_shank_z * t_left_shank_42;
  const Scalar t_left_ankle_cross_80 = left_thigh_m3 + t_left_ankle_cross_45;
  const Scalar t_left_shank_51 = t_left_ankle_cross_80 - t_left_ankle_cross_75 * t_left_shank_28;
  const Scalar t_left_ankle_cross_81 = t_left_shank_20 + t_left_ankle_cross_56;
  const Scalar t_left_shank_52 = t_left_ankle_cross_81 + t_left_ankle_cross_61 * t_left_shank_28;
  const Scalar t_left_ankle_cross_82 = t_left_shank_21 + t_left_ankle_cross_55;
  const Scalar t_left_shank_53 = t_left_ankle_cross_82 + t_left_ankle_cross_66 * t_left_shank_28;
  const Scalar t_left_shank_54 = t_left_ankle_cross_54 + t_left_shank_17 * t_left_shank_21;
  const Scalar t_left_shank_55 = t_left_shank_54 - zeta_left_shank_x * t_left_shank_29;
  const Scalar t_left_shank_56 = t_left_shank_55 + t_left_shank_12 * t_left_shank_20;
  const Scalar t_left_shank_57 = t_left_shank_56 + u_left_shank * t_left_shank_28;
  const Scalar t_left_shank_58 = t_left_shank_57 + t_left_shank_4 * t_left_shank_53;
  const Scalar t_left_shank_59 = t_left_shank_58 + neg_zeta_left_shank_z * t_left_shank_51;
  const Scalar t_left_shank_60 = t_left_shank_59 + neg_zeta_left_shank_y * t_left_shank_42;
  const Scalar t_left_shank_61 = t_left_shank_60 + t_left_shank_3 * t_left_shank_52;
  const Scalar t_left_shank_9 = w[93];
  const Scalar t_left_shank_62 = t_left_shank_9 - left_shank_I16;
  const Scalar t_left_foot_67 = left_hip_fork_l1 * t_left_foot_45;
  const Scalar t_left_foot_68 = t_left_foot_67 - left_hip_fork_l3 * t_left_foot_46;
  const Scalar t_left_shank_63 = t_left_foot_68 - t_left_foot_49 * t_left_ankle_cross_20;
  const Scalar t_left_shank_64 = t_left_shank_62 + t_left_shank_63;
  const Scalar t_left_shank_65 = t_left_shank_64 - s_left_ankle_cross_y * t_left_ankle_cross_48;
  const Scalar t_left_shank_66 = t_left_shank_65 - t_left_ankle_cross_61 * t_left_shank_31;
  const Scalar t_left_shank_67 = t_left_shank_66 + neg_s_left_ankle_cross_x * t_left_ankle_cross_56;
  const Scalar t_left_shank_68 = t_left_ankle_cross_61 * inverse_pivot_left_shank;
  const Scalar s_left_shank_y = w[27];
  const Scalar t_left_shank_69 = t_left_shank_52 - s_left_shank_y * t_left_shank_51;
  const Scalar t_left_shank_70 = s_left_shank_y * t_left_shank_29;
  const Scalar t_left_shank_71 = t_left_shank_44 - s_left_shank_y * t_left_shank_42;
  const Scalar t_left_shank_72 = t_left_shank_30 - t_left_shank_70;
  const Scalar t_left_thigh_19 = w[84];
  const Scalar neg_s_left_shank_x = w[26];
  const Scalar t_left_shank_73 = t_left_thigh_19 - neg_s_left_shank_x * t_left_shank_71;
  const Scalar t_left_shank_74 = t_left_shank_73 - s_left_shank_y * t_left_shank_72;
  w[226] = t_left_shank_74;
  const Scalar t_left_shank_75 = neg_s_left_shank_x * t_left_shank_26;
  const Scalar t_left_shank_76 = s_left_shank_y * t_left_shank_27 + t_left_shank_75;
  const Scalar t_left_shank_77 = neg_s_left_shank_x * t_left_shank_41;
  const Scalar t_left_shank_78 = t_left_shank_77 - s_left_shank_y * t_left_shank_26;
  const Scalar t_left_thigh_12 = w[77];
  const Scalar t_left_thigh_17 = w[82];
  const Scalar t_right_thigh_201 = t_left_thigh_12 + t_left_thigh_17;
  const Scalar t_left_shank_79 = t_right_thigh_201 + neg_s_left_shank_x * t_left_shank_78;
  const Scalar t_left_shank_80 = t_left_shank_79 - s_left_shank_y * t_left_shank_76;
  w[227] = t_left_shank_80;
  const Scalar t_left_shank_81 = neg_s_left_shank_x * t_left_shank_42;
  const Scalar t_left_shank_82 = t_left_shank_43 + t_left_shank_81;
  const Scalar t_left_shank_83 = t_left_shank_32 + neg_s_left_shank_x * t_left_shank_29;
  const Scalar t_left_thigh_14 = w[79];
  const Scalar t_left_shank_84 = t_left_thigh_14 + s_left_shank_y * t_left_shank_83;
  const Scalar t_left_shank_85 = t_left_shank_84 + neg_s_left_shank_x * t_left_shank_82;
  w[228] = t_left_shank_85;
  const Scalar t_left_thigh_20 = w[85];
  const Scalar t_left_shank_86 = t_left_thigh_20 + t_left_shank_78;
  w[229] = t_left_shank_86;
  const Scalar t_left_thigh_21 = w[86];
  const Scalar t_left_shank_87 = t_left_thigh_21 + t_left_shank_76;
  w[230] = t_left_shank_87;
  const Scalar t_left_shank_88 = t_left_shank_70 + t_left_shank_81;
  w[231] = t_left_shank_88;
  // left_thigh: joint force u, 1/pivot of (1)
  const Scalar u_left_thigh_1 = tau[8] - tau[9] - s_left_shank_y * t_left_shank_40;
  const Scalar u_left_thigh_2 = u_left_thigh_1 + neg_s_left_shank_x * t_left_shank_50;
  const Scalar t_left_thigh_18 = w[83];
  const Scalar u_left_thigh_3 = u_left_thigh_2 - t_left_thigh_18 * t_left_thigh_19;
  const Scalar u_left_thigh_4 = t_left_thigh_12 - t_left_thigh_17;
  const Scalar u_left_thigh_5 = u_left_thigh_3 + t_left_thigh_10 * u_left_thigh_4;
  const Scalar t_left_thigh_9 = w[75];
  const Scalar u_left_thigh_6 = u_left_thigh_5 + t_left_thigh_9 * t_left_ankle_cross_12;
  const Scalar t_left_thigh_13 = w[78];
  const Scalar u_left_thigh = u_left_thigh_6 + t_left_thigh_13 * t_left_thigh_14;
  w[232] = u_left_thigh;
  const Scalar inverse_pivot_left_thigh = 1.0 / t_left_shank_80;
  w[242] = inverse_pivot_left_thigh;
  const Scalar t_left_thigh_22 = t_left_shank_86 * inverse_pivot_left_thigh;
  const Scalar t_left_thigh_23 = t_left_shank_26 - t_left_shank_87 * t_left_thigh_22;
  w[243] = t_left_thigh_23;
  const Scalar t_left_thigh_24 = t_left_shank_41 - t_left_shank_86 * t_left_thigh_22;
  w[244] = t_left_thigh_24;
  const Scalar t_left_thigh_25 = t_left_shank_88 * inverse_pivot_left_thigh;
  const Scalar t_left_thigh_26 = t_left_shank_42 - t_left_shank_88 * t_left_thigh_22;
  w[245] = t_left_thigh_26;
  const Scalar t_left_thigh_27 = t_left_shank_85 * inverse_pivot_left_thigh;
  const Scalar t_left_thigh_28 = t_left_shank_82 - t_left_shank_86 * t_left_thigh_27;
  w[247] = t_left_thigh_28;
  const Scalar t_left_thigh_29 = t_left_shank_74 * inverse_pivot_left_thigh;
  const Scalar t_left_thigh_30 = t_left_shank_71 + t_left_shank_86 * t_left_thigh_29;
  w[248] = t_left_thigh_30;
  const Scalar t_left_shank_89 = t_left_shank_50 - t_left_thigh_10 * t_left_thigh_20;
  const Scalar t_left_thigh_16 = w[81];
  const Scalar t_left_shank_90 = t_left_shank_89 + t_left_thigh_16 * t_left_thigh_21;
  const Scalar neg_zeta_left_thigh_z = w[72];
  const Scalar t_left_thigh_31 = t_left_shank_90 - neg_zeta_left_thigh_z * t_left_thigh_26;
  const Scalar t_left_thigh_4 = w[71];
  const Scalar t_left_thigh_32 = t_left_thigh_31 - t_left_thigh_4 * t_left_thigh_30;
  const Scalar zeta_left_thigh_y = w[68];
  const Scalar t_left_thigh_33 = t_left_thigh_32 + zeta_left_thigh_y * t_left_thigh_24;
  const Scalar t_left_thigh_3 = w[70];
  const Scalar t_left_thigh_34 = t_left_thigh_33 - t_left_thigh_3 * t_left_thigh_28;
  const Scalar t_left_thigh_35 = t_left_thigh_34 - u_left_thigh * t_left_thigh_22;
  const Scalar zeta_left_thigh_x = w[69];
  const Scalar t_left_thigh_36 = t_left_thigh_35 - zeta_left_thigh_x * t_left_thigh_23;
  w[249] = t_left_thigh_36;
  const Scalar t_left_thigh_37 = t_left_shank_87 * inverse_pivot_left_thigh;
  const Scalar t_left_thigh_38 = t_left_shank_27 + t_left_shank_87 * t_left_thigh_37;
  w[250] = t_left_thigh_38;
  const Scalar t_left_thigh_39 = t_left_shank_29 + t_left_shank_88 * t_left_thigh_37;
  w[251] = t_left_thigh_39;
  const Scalar t_left_thigh_40 = t_left_shank_83 + t_left_shank_87 * t_left_thigh_27;
  w[252] = t_left_thigh_40;
  const Scalar t_left_thigh_41 = t_left_shank_72 - t_left_shank_87 * t_left_thigh_29;
  w[253] = t_left_thigh_41;
  const Scalar t_left_thigh_42 = t_left_shank_40 + t_left_thigh_10 * t_left_thigh_21;
  const Scalar t_left_thigh_43 = t_left_thigh_42 + zeta_left_thigh_x * t_left_thigh_38;
  const Scalar t_left_thigh_44 = t_left_thigh_43 + t_left_thigh_4 * t_left_thigh_41;
  const Scalar t_left_thigh_45 = t_left_thigh_44 + neg_zeta_left_thigh_z * t_left_thigh_39;
  const Scalar t_left_thigh_7 = w[74];
  const Scalar t_left_thigh_46 = t_left_thigh_45 - t_left_thigh_7 * t_left_thigh_20;
  const Scalar t_left_thigh_47 = t_left_thigh_46 + zeta_left_thigh_y * t_left_thigh_23;
  const Scalar t_left_thigh_48 = t_left_thigh_47 - u_left_thigh * t_left_thigh_37;
  const Scalar t_left_thigh_49 = t_left_thigh_48 + t_left_thigh_3 * t_left_thigh_40;
  w[254] = t_left_thigh_49;
  const Scalar t_left_shank_91 = t_left_thigh_21 + t_left_shank_69;
  const Scalar t_left_thigh_50 = t_left_shank_91 + t_left_shank_74 * t_left_thigh_25;
  w[255] = t_left_thigh_50;
  const Scalar t_left_thigh_51 = t_left_thigh_9 - t_left_shank_67;
  const Scalar t_left_thigh_52 = t_left_thigh_51 - t_left_shank_74 * t_left_thigh_27;
  const Scalar t_left_thigh_53 = t_left_thigh_52 - neg_s_left_shank_x * t_left_shank_69;
  const Scalar t_left_thigh_54 = t_left_thigh_53 + s_left_shank_y * t_left_shank_53;
  w[256] = t_left_thigh_54;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_83 = t_left_foot_54 + left_foot_I11 * s_left_foot;
  const Scalar t_left_ankle_cross_84 =
      t_left_ankle_cross_83 + t_left_foot_53 * t_left_ankle_cross_20;
  const Scalar t_left_shank_10 = w[95];
  const Scalar t_left_ankle_cross_85 = left_shank_I15 - t_left_shank_10;
  const Scalar t_left_ankle_cross_86 = t_left_ankle_cross_47 + t_left_ankle_cross_56;
  const Scalar t_left_ankle_cross_87 = t_left_ankle_cross_84 - t_left_ankle_cross_85;
  const Scalar t_left_ankle_cross_88 =
      t_left_ankle_cross_87 + s_left_ankle_cross_y * t_left_ankle_cross_86;
  const Scalar t_left_shank_92 = t_left_ankle_cross_88 + t_left_ankle_cross_61 * t_left_shank_68;
  const Scalar t_left_thigh_55 = t_left_thigh_12 - t_left_shank_92;
  const Scalar t_left_thigh_56 = t_left_thigh_55 - t_left_shank_74 * t_left_thigh_29;
  const Scalar t_left_shank_93 = t_left_shank_52 + t_left_shank_69;
  // left_thigh
  const Scalar t_left_thigh_57 = t_left_thigh_56 - s_left_shank_y * t_left_shank_93;
  w[258] = t_left_thigh_57;
  const Scalar t_left_thigh_58 = t_left_shank_14 - (left_ankle_cross_I14 - t_left_thigh_19);
  const Scalar t_left_thigh_59 = left_ankle_cross_I3 - t_left_shank_63;
  const Scalar t_left_thigh_60 = t_left_shank_19 - (left_ankle_cross_I1 + t_left_thigh_14);
  const Scalar t_left_shank_94 = s_left_shank_y * t_left_shank_61;
  const Scalar t_left_thigh_61 = s_left_foot * t_left_foot_34 - t_left_shank_94;
  const Scalar t_left_thigh_62 = t_left_thigh_61 - t_left_shank_6 * t_left_shank_19;
  const Scalar t_left_thigh_63 = left_ankle_cross_I20 - t_left_ankle_cross_84;
  const Scalar t_left_thigh_64 = t_left_thigh_62 + t_left_ankle_cross_2 * t_left_ankle_cross_22;
  const Scalar t_left_thigh_65 = t_left_thigh_64 + t_left_ankle_cross_5 * t_left_thigh_63;
  const Scalar t_left_thigh_66 = t_left_thigh_65 - left_foot_I3 * t_left_foot_35;
  const Scalar t_left_thigh_67 = t_left_thigh_66 + left_ankle_cross_I1 * t_left_ankle_cross_10;
  const Scalar t_left_thigh_68 = t_left_thigh_67 - u_left_shank * t_left_shank_68;
  const Scalar t_left_thigh_69 = t_left_shank_10 - left_shank_I5;
  const Scalar t_left_thigh_70 = t_left_thigh_68 - t_left_shank_12 * t_left_thigh_69;
  const Scalar t_left_thigh_71 = t_left_thigh_70 + t_left_shank_4 * t_left_shank_67;
  const Scalar t_left_thigh_72 = t_left_thigh_71 + t_left_shank_17 * t_left_shank_62;
  const Scalar t_left_thigh_73 = t_left_thigh_72 - c_left_foot * t_left_foot_24;
  const Scalar t_left_thigh_74 = t_left_thigh_73 - zeta_left_thigh_y * t_left_thigh_30;
  const Scalar t_left_thigh_75 = t_left_thigh_74 + u_left_ankle_cross * t_left_ankle_cross_20;
  const Scalar t_left_thigh_76 = t_left_thigh_75 - zeta_left_shank_x * t_left_shank_30;
  const Scalar t_left_hip_fork_15 = w[66];
  const Scalar t_left_thigh_77 = t_left_thigh_76 + t_left_hip_fork_15 * t_left_thigh_60;
  const Scalar t_left_thigh_78 = t_left_thigh_77 - s_left_ankle_cross_y * t_left_ankle_cross_54;
  const Scalar t_left_thigh_79 = t_left_thigh_78 + t_left_thigh_12 * t_left_thigh_18;
  const Scalar t_left_thigh_80 = t_left_thigh_79 - t_left_ankle_cross_6 * t_left_thigh_59;
  const Scalar t_left_thigh_81 = t_left_thigh_80 - t_left_thigh_9 * t_left_thigh_13;
  const Scalar t_left_thigh_82 = t_left_thigh_81 - zeta_left_ankle_cross_x * t_left_ankle_cross_37;
  const Scalar t_left_thigh_83 = t_left_thigh_82 - t_left_thigh_10 * t_left_thigh_58;
  const Scalar t_left_thigh_84 = t_left_thigh_83 + neg_zeta_left_shank_y * t_left_shank_44;
  const Scalar t_left_thigh_85 = t_left_thigh_84 + neg_zeta_left_shank_z * t_left_shank_52;
  const Scalar t_left_thigh_86 = t_left_thigh_85 + neg_zeta_left_thigh_z * t_left_thigh_50;
  const Scalar t_left_thigh_87 = t_left_thigh_86 + t_left_thigh_14 * t_left_thigh_16;
  const Scalar t_left_thigh_88 = t_left_thigh_87 - t_left_thigh_3 * t_left_thigh_54;
  const Scalar t_left_thigh_89 = t_left_thigh_88 - zeta_left_ankle_cross_z * t_left_ankle_cross_47;
  const Scalar t_left_thigh_90 = t_left_thigh_89 - t_left_shank_3 * t_left_shank_92;
  const Scalar t_left_thigh_91 = t_left_thigh_90 + t_left_thigh_4 * t_left_thigh_57;
  const Scalar t_left_thigh_92 = t_left_thigh_91 - zeta_left_thigh_x * t_left_thigh_41;
  const Scalar t_left_thigh_93 = t_left_thigh_92 - u_left_thigh * t_left_thigh_29;
  w[259] = t_left_thigh_93;
  const Scalar t_left_shank_95 = t_left_shank_53 + neg_s_left_shank_x * t_left_shank_51;
  const Scalar t_left_shank_96 = t_left_thigh_20 + t_left_shank_95;
  const Scalar t_left_thigh_94 = t_left_shank_96 - t_left_shank_85 * t_left_thigh_25;
  w[260] = t_left_thigh_94;
  const Scalar t_left_foot_69 = left_ankle_cross_I13 - left_hip_fork_l1 * t_left_foot_41;
  const Scalar t_left_foot_70 = t_left_foot_69 - left_hip_fork_l3 * t_left_foot_43;
  const Scalar t_left_ankle_cross_89 = t_left_foot_70 - t_left_foot_49 * t_left_ankle_cross_23;
  const Scalar t_left_shank_97 = t_left_shank_11 + t_left_ankle_cross_89;
  const Scalar t_left_ankle_cross_90 = t_left_ankle_cross_48 + t_left_ankle_cross_55;
  // left_shank
  const Scalar t_left_shank_98 = t_left_shank_97 - t_left_ankle_cross_66 * t_left_shank_31;
  const Scalar t_left_shank_99 = t_left_shank_98 + neg_s_left_ankle_cross_x * t_left_ankle_cross_90;
  const Scalar t_left_shank_100 = t_left_thigh_17 + t_left_shank_99;
  const Scalar t_left_shank_101 = t_left_shank_53 + t_left_shank_95;
  const Scalar t_left_shank_102 = t_left_shank_100 + neg_s_left_shank_x * t_left_shank_101;
  // left_thigh
  const Scalar t_left_thigh_95 = t_left_shank_102 - t_left_shank_85 * t_left_thigh_27;
  w[261] = t_left_thigh_95;
  const Scalar t_left_thigh_96 = tau[11] + left_ankle_cross_I13 * t_left_ankle_cross_9;
  const Scalar t_left_thigh_97 = t_left_thigh_96 + neg_s_left_shank_x * t_left_shank_61;
  const Scalar t_left_thigh_98 = t_left_thigh_97 + t_left_shank_14 * t_left_shank_15;
  const Scalar t_left_hip_fork_16 = w[67];
  const Scalar t_left_thigh_99 = t_left_foot_64 - t_left_hip_fork_16 * t_left_thigh_94;
  const Scalar t_left_thigh_100 = t_left_thigh_98 - left_ankle_cross_I14 * t_left_ankle_cross_8;
  const Scalar t_left_thigh_101 = t_left_thigh_100 - left_hip_fork_l1 * t_left_thigh_99;
  const Scalar t_left_thigh_102 = t_left_thigh_101 + t_left_shank_11 * t_left_shank_17;
  const Scalar t_left_thigh_103 =
      t_left_thigh_102 - zeta_left_ankle_cross_x * t_left_ankle_cross_38;
  const Scalar t_left_thigh_104 = t_left_thigh_103 + t_left_thigh_7 * t_left_thigh_19;
  const Scalar t_left_thigh_105 = t_left_thigh_104 + t_left_ankle_cross_2 * t_left_ankle_cross_24;
  const Scalar t_left_thigh_106 = t_left_thigh_105 + neg_zeta_left_shank_y * t_left_shank_43;
  const Scalar t_left_thigh_107 = t_left_thigh_106 + u_left_ankle_cross * t_left_ankle_cross_23;
  const Scalar t_left_thigh_108 = t_left_thigh_107 + t_left_ankle_cross_6 * t_left_ankle_cross_89;
  const Scalar t_left_thigh_109 = t_left_thigh_108 - u_left_shank * t_left_shank_31;
  const Scalar t_left_thigh_110 = t_left_thigh_109 - t_left_ankle_cross_5 * t_left_thigh_59;
  const Scalar t_left_thigh_111 = t_left_thigh_110 + t_left_shank_4 * t_left_shank_99;
  const Scalar t_left_thigh_112 = t_left_thigh_111 - left_hip_fork_l3 * t_left_foot_16;
  const Scalar t_left_thigh_113 = t_left_thigh_112 + neg_zeta_left_shank_z * t_left_shank_53;
  const Scalar t_left_thigh_114 = t_left_thigh_113 + t_left_shank_12 * t_left_shank_62;
  const Scalar t_left_thigh_115 = t_left_thigh_114 + t_left_shank_3 * t_left_shank_67;
  const Scalar t_left_thigh_116 = t_left_thigh_115 - t_left_thigh_4 * t_left_thigh_54;
  const Scalar t_left_thigh_117 = t_left_thigh_116 - t_left_thigh_9 * t_left_thigh_18;
  const Scalar t_left_thigh_118 = t_left_thigh_117 + t_left_thigh_3 * t_left_thigh_95;
  const Scalar t_left_thigh_119 = t_left_thigh_118 - zeta_left_shank_x * t_left_shank_32;
  const Scalar t_left_thigh_120 = t_left_thigh_119 + t_left_thigh_13 * t_left_thigh_17;
  const Scalar t_left_thigh_121 = t_left_thigh_120 - zeta_left_thigh_x * t_left_thigh_40;
  const Scalar t_left_thigh_122 = t_left_thigh_121 - zeta_left_thigh_y * t_left_thigh_28;
  const Scalar t_left_thigh_123 = t_left_thigh_122 + u_left_thigh * t_left_thigh_27;
  const Scalar t_left_thigh_124 = t_left_thigh_123 + t_left_thigh_10 * t_left_thigh_60;
  const Scalar t_left_thigh_125 = t_left_thigh_124 - t_left_hip_fork_15 * t_left_thigh_58;
  const Scalar t_left_thigh_126 =
      t_left_thigh_125 + neg_s_left_ankle_cross_x * t_left_ankle_cross_54;
  const Scalar t_left_thigh_127 =
      t_left_thigh_126 - zeta_left_ankle_cross_z * t_left_ankle_cross_48;
  w[262] = t_left_thigh_127;
  const Scalar t_left_thigh_128 = t_left_shank_51 - t_left_shank_88 * t_left_thigh_25;
  w[263] = t_left_thigh_128;
  const Scalar t_left_shank_103 = t_left_shank_61 + t_left_thigh_13 * t_left_thigh_20;
  const Scalar t_left_shank_104 = t_left_shank_103 + t_left_thigh_18 * t_left_thigh_21;
  const Scalar t_left_thigh_129 = t_left_shank_104 + neg_zeta_left_thigh_z * t_left_thigh_128;
  const Scalar t_left_thigh_130 = t_left_thigh_129 + t_left_thigh_3 * t_left_thigh_94;
  const Scalar t_left_thigh_131 = t_left_thigh_130 - zeta_left_thigh_y * t_left_thigh_26;
  const Scalar t_left_thigh_132 = t_left_thigh_131 + t_left_thigh_4 * t_left_thigh_50;
  const Scalar t_left_thigh_133 = t_left_thigh_132 - zeta_left_thigh_x * t_left_thigh_39;
  const Scalar t_left_thigh_134 = t_left_thigh_133 + u_left_thigh * t_left_thigh_25;
  w[264] = t_left_thigh_134;
}

[[gnu::noinline]] void forward_dynamics_6(const Scalar tau[18], Scalar w[266]) noexcept {
  // left_thigh
  const Scalar s_q8_q9_q10 = w[10];
  const Scalar t_left_thigh_28 = w[247];
  const Scalar t_left_thigh_41 = w[253];
  const Scalar t_left_thigh_135 = s_q8_q9_q10 * (t_left_thigh_28 + t_left_thigh_41);
  const Scalar t_left_thigh_30 = w[248];
  const Scalar t_left_thigh_40 = w[252];
  const Scalar t_left_thigh_136 = t_left_thigh_30 - t_left_thigh_40;
  const Scalar c_q8_q9_q10 = w[11];
  const Scalar t_left_thigh_137 = t_left_thigh_135 + c_q8_q9_q10 * t_left_thigh_136;
  const Scalar t_left_thigh_138 = s_q8_q9_q10 * t_left_thigh_137;
  const Scalar t_left_thigh_39 = w[251];
  const Scalar t_left_thigh_139 = c_q8_q9_q10 * t_left_thigh_39;
  const Scalar t_left_thigh_26 = w[245];
  const Scalar t_left_thigh_140 = t_left_thigh_139 - s_q8_q9_q10 * t_left_thigh_26;
  const Scalar t_left_thigh_141 = left_hip_fork_l1 * t_left_thigh_140;
  const Scalar t_left_thigh_142 = t_left_thigh_41 - t_left_thigh_138 + t_left_thigh_141;
  const Scalar t_left_thigh_143 = 2.0 * c_q8_q9_q10;
  const Scalar t_left_thigh_24 = w[244];
  const Scalar t_left_thigh_38 = w[250];
  const Scalar t_left_thigh_144 = s_q8_q9_q10 * (t_left_thigh_24 + t_left_thigh_38);
  const Scalar t_left_thigh_23 = w[243];
  const Scalar t_left_thigh_145 = t_left_thigh_144 + t_left_thigh_23 * t_left_thigh_143;
  const Scalar t_left_thigh_146 = t_left_thigh_23 - c_q8_q9_q10 * t_left_thigh_145;
  const Scalar t_left_thigh_147 = s_q8_q9_q10 * t_left_thigh_145;
  const Scalar t_left_thigh_148 = t_left_thigh_38 - t_left_thigh_147;
  const Scalar t_left_thigh_57 = w[258];
  const Scalar t_left_thigh_95 = w[261];
  const Scalar t_left_thigh_149 = s_q8_q9_q10 * (t_left_thigh_57 - t_left_thigh_95);
  const Scalar t_left_thigh_54 = w[256];
  const Scalar t_left_thigh_150 = t_left_thigh_149 + t_left_thigh_54 * t_left_thigh_143;
  const Scalar t_left_thigh_151 = s_q8_q9_q10 * t_left_thigh_150;
  const Scalar t_left_thigh_94 = w[260];
  const Scalar t_left_thigh_152 = c_q8_q9_q10 * t_left_thigh_94;
  const Scalar t_left_thigh_50 = w[255];
  const Scalar t_left_thigh_153 = t_left_thigh_152 - s_q8_q9_q10 * t_left_thigh_50;
  const Scalar t_left_thigh_154 = left_hip_fork_I11 + t_left_thigh_54;
  const Scalar t_left_thigh_155 = t_left_thigh_154 - c_q8_q9_q10 * t_left_thigh_150;
  const Scalar t_left_thigh_156 = t_left_thigh_155 + left_hip_fork_l1 * t_left_thigh_153;
  const Scalar t_left_thigh_157 = c_q8_q9_q10 * t_left_thigh_137;
  const Scalar t_left_thigh_158 = s_q8_q9_q10 * t_left_thigh_39;
  const Scalar t_left_thigh_159 = t_left_thigh_158 + c_q8_q9_q10 * t_left_thigh_26;
  const Scalar t_left_thigh_160 = t_left_thigh_30 - t_left_thigh_157;
  const Scalar t_left_thigh_161 = left_hip_fork_I2 - left_hip_fork_l1 * t_left_thigh_160;
  const Scalar t_left_thigh_162 = left_hip_fork_I16 + t_left_thigh_95 + t_left_thigh_151;
  w[73] = t_left_thigh_162;
  const Scalar t_left_thigh_163 = left_hip_fork_h1 - t_left_thigh_160;
  w[74] = t_left_thigh_163;
  const Scalar t_left_thigh_164 = t_left_thigh_28 - t_left_thigh_138;
  const Scalar t_left_thigh_165 = left_hip_fork_h2 + t_left_thigh_153;
  // left_hip_fork: joint force u, 1/pivot, qdd of (1)
  const Scalar t_left_hip_fork_14 = w[65];
  const Scalar u_left_hip_fork_1 = tau[7] + left_hip_fork_I2 * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_16 = w[67];
  const Scalar u_left_hip_fork_2 = u_left_hip_fork_1 - left_hip_fork_I11 * t_left_hip_fork_16;
  const Scalar t_left_thigh_127 = w[262];
  const Scalar u_left_hip_fork_3 = u_left_hip_fork_2 - c_q8_q9_q10 * t_left_thigh_127;
  const Scalar t_left_hip_fork_12 = w[63];
  const Scalar t_left_hip_fork_15 = w[66];
  const Scalar u_left_hip_fork_4 = t_left_hip_fork_12 - t_left_hip_fork_15;
  const Scalar t_left_thigh_93 = w[259];
  const Scalar u_left_hip_fork_5 = u_left_hip_fork_3 + s_q8_q9_q10 * t_left_thigh_93;
  const Scalar u_left_hip_fork_6 = u_left_hip_fork_5 + left_hip_fork_I8 * u_left_hip_fork_4;
  const Scalar t_left_hip_fork_13 = w[64];
  const Scalar u_left_hip_fork = u_left_hip_fork_6 + left_hip_fork_I17 * t_left_hip_fork_13;
  w[75] = u_left_hip_fork;
  const Scalar t_left_hip_fork_17 = 1.0 / t_left_thigh_162;
  w[76] = t_left_hip_fork_17;
  const Scalar t_left_hip_fork_18 = t_left_thigh_156 * t_left_hip_fork_17;
  w[77] = t_left_hip_fork_18;
  const Scalar t_left_hip_fork_19 = t_left_thigh_161 * t_left_hip_fork_17;
  w[78] = t_left_hip_fork_19;
  const Scalar t_left_hip_fork_20 = t_left_thigh_161 * t_left_hip_fork_18;
  const Scalar t_left_hip_fork_21 = left_hip_fork_l1 * t_left_thigh_142 + t_left_hip_fork_20;
  const Scalar t_left_hip_fork_22 = left_hip_fork_I8 - t_left_hip_fork_21;
  // left_thigh
  const Scalar t_left_thigh_166 = s_q8_q9_q10 * t_left_thigh_94;
  const Scalar t_left_thigh_167 = t_left_thigh_166 + c_q8_q9_q10 * t_left_thigh_50;
  const Scalar t_left_thigh_128 = w[263];
  const Scalar t_left_thigh_168 = t_left_thigh_167 + left_hip_fork_l1 * t_left_thigh_128;
  const Scalar t_left_thigh_169 = t_left_thigh_57 - t_left_thigh_151;
  const Scalar t_left_thigh_170 = t_left_thigh_167 + t_left_thigh_168;
  const Scalar t_left_thigh_171 = t_left_thigh_169 + left_hip_fork_l1 * t_left_thigh_170;
  // left_hip_fork
  const Scalar t_left_hip_fork_23 = t_left_thigh_171 - t_left_thigh_156 * t_left_hip_fork_18;
  const Scalar t_left_hip_fork_24 = left_hip_fork_I15 + t_left_hip_fork_23;
  const Scalar t_left_hip_fork_25 = left_hip_fork_I11 * t_left_hip_fork_13;
  const Scalar t_left_hip_fork_26 = t_left_hip_fork_25 + left_hip_fork_I8 * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_27 = t_left_hip_fork_26 - left_hip_fork_I15 * t_left_hip_fork_16;
  const Scalar t_left_hip_fork_28 = t_left_hip_fork_27 + c_q8_q9_q10 * t_left_thigh_93;
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_28 + s_q8_q9_q10 * t_left_thigh_127;
  const Scalar t_left_thigh_134 = w[264];
  const Scalar t_left_hip_fork_30 = t_left_hip_fork_29 + left_hip_fork_l1 * t_left_thigh_134;
  const Scalar t_left_hip_fork_9 = w[62];
  const Scalar t_left_hip_fork_31 = t_left_hip_fork_30 + t_left_hip_fork_9 * t_left_hip_fork_24;
  const Scalar t_left_hip_fork_8 = w[61];
  const Scalar t_left_hip_fork_32 = t_left_hip_fork_31 - t_left_hip_fork_8 * t_left_hip_fork_22;
  const Scalar t_left_hip_fork_7 = w[56];
  const Scalar t_left_hip_fork_33 = t_left_hip_fork_7 - t_left_hip_fork_15;
  const Scalar t_left_hip_fork_34 = t_left_hip_fork_32 + u_left_hip_fork * t_left_hip_fork_18;
  const Scalar t_left_hip_fork_35 = t_left_hip_fork_34 + left_hip_fork_I2 * t_left_hip_fork_33;
  const Scalar t_left_hip_fork_36 = t_left_thigh_161 * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_37 = t_left_hip_fork_36 + left_hip_fork_p1 * t_left_thigh_148;
  const Scalar t_left_hip_fork_38 = left_hip_fork_I10 - t_left_hip_fork_37;
  // left_thigh
  const Scalar t_left_thigh_36 = w[249];
  const Scalar t_left_thigh_172 = s_q8_q9_q10 * t_left_thigh_36;
  const Scalar t_left_thigh_49 = w[254];
  const Scalar t_left_thigh_173 = t_left_thigh_172 + c_q8_q9_q10 * t_left_thigh_49;
  const Scalar t_left_thigh_174 = tau[8] - left_hip_fork_I8 * t_left_hip_fork_16;
  const Scalar t_left_thigh_175 = t_left_thigh_174 + left_hip_fork_I10 * t_left_hip_fork_14;
  const Scalar t_left_thigh_176 = t_left_thigh_175 - left_hip_fork_I2 * t_left_hip_fork_13;
  const Scalar t_left_thigh_177 = t_left_hip_fork_7 - t_left_hip_fork_12;
  const Scalar t_left_thigh_178 = t_left_thigh_176 - left_hip_fork_l1 * t_left_thigh_173;
  const Scalar t_left_thigh_179 = t_left_thigh_178 - left_hip_fork_I11 * t_left_thigh_177;
  // left_hip_fork: qdd of (1)
  const Scalar t_left_hip_fork_39 = t_left_thigh_179 - t_left_hip_fork_8 * t_left_hip_fork_38;
  const Scalar t_left_hip_fork_40 = t_left_hip_fork_39 + t_left_hip_fork_9 * t_left_hip_fork_22;
  const Scalar t_left_hip_fork_41 = t_left_hip_fork_40 + u_left_hip_fork * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_42 = t_left_thigh_163 * t_left_hip_fork_17;
  const Scalar t_left_hip_fork_43 = t_left_thigh_163 * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_44 = left_hip_fork_l1 * t_left_thigh_148 + t_left_hip_fork_43;
  const Scalar t_left_hip_fork_45 = t_left_thigh_142 + t_left_thigh_156 * t_left_hip_fork_42;
  const Scalar t_left_thigh_180 = t_left_thigh_173 - left_hip_fork_h2 * t_left_hip_fork_12;
  const Scalar t_left_thigh_181 = t_left_thigh_180 + left_hip_fork_h1 * t_left_hip_fork_13;
  const Scalar t_left_hip_fork_46 = t_left_thigh_181 - u_left_hip_fork * t_left_hip_fork_42;
  const Scalar t_left_hip_fork_47 = t_left_hip_fork_46 + t_left_hip_fork_9 * t_left_hip_fork_45;
  const Scalar t_left_hip_fork_48 = t_left_hip_fork_47 - t_left_hip_fork_8 * t_left_hip_fork_44;
  const Scalar t_left_hip_fork_49 = t_left_thigh_165 * t_left_hip_fork_17;
  w[79] = t_left_hip_fork_49;
  const Scalar t_left_hip_fork_50 = t_left_thigh_141 + t_left_thigh_165 * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_51 = t_left_thigh_168 - t_left_thigh_156 * t_left_hip_fork_49;
  const Scalar t_left_hip_fork_52 = t_left_thigh_134 + left_hip_fork_h2 * t_left_hip_fork_13;
  const Scalar t_left_hip_fork_53 = t_left_hip_fork_52 + t_left_hip_fork_8 * t_left_hip_fork_50;
  const Scalar t_left_hip_fork_54 = t_left_hip_fork_53 + u_left_hip_fork * t_left_hip_fork_49;
  const Scalar t_left_hip_fork_55 = t_left_hip_fork_54 - left_hip_fork_h1 * t_left_hip_fork_15;
  const Scalar t_left_hip_fork_56 = t_left_hip_fork_55 + t_left_hip_fork_9 * t_left_hip_fork_51;
  const Scalar t_left_hip_fork_57 = t_left_thigh_164 * t_left_hip_fork_17;
  w[80] = t_left_hip_fork_57;
  const Scalar t_left_thigh_182 = left_hip_fork_h2 - left_hip_fork_l1 * t_left_thigh_146;
  const Scalar t_left_hip_fork_58 = t_left_thigh_182 - t_left_thigh_164 * t_left_hip_fork_19;
  const Scalar t_left_thigh_183 = t_left_thigh_157 - (left_hip_fork_h1 - t_left_thigh_40);
  const Scalar t_left_thigh_184 = t_left_thigh_183 + left_hip_fork_l1 * t_left_thigh_159;
  const Scalar t_left_hip_fork_59 = t_left_thigh_184 - t_left_thigh_164 * t_left_hip_fork_18;
  const Scalar s_left_hip_roll = w[8];
  const Scalar t_left_hip_fork_60 = 2.0 * s_left_hip_roll;
  const Scalar t_left_hip_fork_61 = t_left_hip_fork_24 - t_left_hip_fork_38;
  const Scalar t_left_hip_fork_62 = t_left_hip_fork_22 * t_left_hip_fork_60;
  const Scalar c_left_hip_roll = w[9];
  const Scalar t_left_hip_fork_63 = t_left_hip_fork_62 - c_left_hip_roll * t_left_hip_fork_61;
  const Scalar t_left_hip_fork_64 = left_hip_block_I20 - t_left_hip_fork_21;
  const Scalar t_left_hip_fork_65 = t_left_hip_fork_64 - s_left_hip_roll * t_left_hip_fork_63;
  w[81] = t_left_hip_fork_65;
  const Scalar t_left_hip_fork_66 = c_left_hip_roll * t_left_hip_fork_63;
  const Scalar t_left_hip_fork_67 = t_left_thigh_128 - t_left_thigh_165 * t_left_hip_fork_49;
  const Scalar t_left_hip_fork_68 = t_left_thigh_148 + t_left_thigh_163 * t_left_hip_fork_42;
  const Scalar t_left_hip_fork_69 = t_left_thigh_140 + t_left_thigh_163 * t_left_hip_fork_49;
  const Scalar t_left_hip_fork_70 = t_left_hip_fork_67 + t_left_hip_fork_68;
  const Scalar t_left_hip_fork_71 = t_left_hip_fork_60 * t_left_hip_fork_69;
  const Scalar t_left_hip_fork_72 = c_left_hip_roll * t_left_hip_fork_70 + t_left_hip_fork_71;
  const Scalar t_left_hip_fork_73 = c_left_hip_roll * t_left_hip_fork_72;
  const Scalar t_left_hip_fork_74 = t_left_hip_fork_45 + t_left_hip_fork_50;
  const Scalar t_left_hip_fork_75 = t_left_hip_fork_44 + t_left_hip_fork_51;
  const Scalar t_left_hip_fork_76 = c_left_hip_roll * t_left_hip_fork_74;
  const Scalar t_left_hip_fork_77 = t_left_hip_fork_76 - s_left_hip_roll * t_left_hip_fork_75;
  const Scalar t_left_hip_fork_78 = s_left_hip_roll * t_left_hip_fork_77;
  const Scalar t_left_hip_fork_79 = left_hip_block_h4 + t_left_hip_fork_51;
  const Scalar t_left_hip_fork_80 = t_left_hip_fork_78 + t_left_hip_fork_79;
  w[82] = t_left_hip_fork_80;
  const Scalar t_left_hip_fork_81 = left_hip_block_I19 - t_left_hip_fork_37;
  const Scalar t_left_hip_fork_82 = t_left_hip_fork_66 - t_left_hip_fork_81;
  w[83] = t_left_hip_fork_82;
  const Scalar t_left_hip_fork_83 = c_left_hip_roll * t_left_hip_fork_77;
  const Scalar t_left_hip_fork_84 = t_left_hip_fork_50 - t_left_hip_fork_83;
  w[84] = t_left_hip_fork_84;
  const Scalar t_left_hip_fork_85 = left_hip_block_h1 + c_left_hip_roll * t_left_hip_fork_59;
  const Scalar t_left_hip_fork_86 = t_left_hip_fork_85 - s_left_hip_roll * t_left_hip_fork_58;
  w[85] = t_left_hip_fork_86;
  const Scalar t_left_hip_fork_87 = t_left_thigh_159 - t_left_thigh_165 * t_left_hip_fork_57;
  // left_hip_block: joint force u, 1/pivot of (1)
  const Scalar t_left_hip_block_18 = w[58];
  const Scalar u_left_hip_block_1 = tau[6] - left_hip_block_I16 * t_left_hip_block_18;
  const Scalar t_left_hip_block_21 = w[60];
  const Scalar u_left_hip_block_2 = u_left_hip_block_1 - left_hip_block_I15 * t_left_hip_block_21;
  const Scalar u_left_hip_block_3 = u_left_hip_block_2 + c_left_hip_roll * t_left_hip_fork_35;
  const Scalar u_left_hip_block_4 = u_left_hip_block_3 - s_left_hip_roll * t_left_hip_fork_41;
  const Scalar t_left_hip_block_20 = w[59];
  const Scalar u_left_hip_block_5 = t_left_hip_fork_7 - t_left_hip_block_20;
  const Scalar t_left_hip_block_17 = w[57];
  const Scalar u_left_hip_block_6 = u_left_hip_block_4 + left_hip_block_I18 * t_left_hip_block_17;
  const Scalar u_left_hip_block = u_left_hip_block_6 - left_hip_block_I8 * u_left_hip_block_5;
  const Scalar t_left_hip_block_22 = 1.0 / t_left_hip_fork_82;
  w[86] = t_left_hip_block_22;
  const Scalar t_left_hip_block_23 = t_left_hip_fork_80 * t_left_hip_block_22;
  const Scalar t_left_hip_block_24 = t_left_hip_fork_86 * t_left_hip_block_22;
  // left_hip_fork
  const Scalar t_left_hip_fork_88 = t_left_thigh_146 + t_left_thigh_163 * t_left_hip_fork_57;
  const Scalar t_left_hip_fork_89 = s_left_hip_roll * t_left_hip_fork_88;
  const Scalar t_left_hip_fork_90 = t_left_hip_fork_89 + c_left_hip_roll * t_left_hip_fork_87;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_25 = t_left_hip_fork_90 + t_left_hip_fork_80 * t_left_hip_block_24;
  const Scalar t_left_hip_block_26 = t_left_hip_fork_84 * t_left_hip_block_22;
  const Scalar t_left_hip_block_27 = t_left_hip_fork_69 - t_left_hip_fork_80 * t_left_hip_block_26;
  const Scalar t_left_hip_block_28 = t_left_hip_block_27 - s_left_hip_roll * t_left_hip_fork_72;
  const Scalar t_left_hip_fork_91 = t_left_hip_fork_45 - t_left_hip_fork_83;
  const Scalar t_left_hip_block_29 = t_left_hip_fork_91 + t_left_hip_fork_65 * t_left_hip_block_23;
  const Scalar t_left_hip_block_30 = left_hip_block_I15 * t_left_hip_block_23;
  w[92] = t_left_hip_block_30;
  const Scalar t_left_hip_block_16 = w[55];
  const Scalar t_left_hip_block_31 = u_left_hip_block + left_hip_block_I15 * t_left_hip_block_16;
  const Scalar t_left_hip_fork_92 = left_hip_block_m1 - t_left_hip_fork_68;
  const Scalar t_left_hip_fork_93 = t_left_hip_fork_73 + t_left_hip_fork_92;
  const Scalar t_left_hip_block_32 = t_left_hip_fork_93 + t_left_hip_fork_80 * t_left_hip_block_23;
  const Scalar t_left_hip_block_33 = left_hip_block_h4 * t_left_hip_block_17;
  const Scalar t_left_hip_block_34 = t_left_hip_block_33 + left_hip_block_h1 * t_left_hip_block_20;
  const Scalar t_left_hip_block_35 =
      t_left_hip_block_34 + t_left_hip_block_23 * t_left_hip_block_31;
  const Scalar t_left_hip_block_8 = w[51];
  const Scalar t_left_hip_block_36 = t_left_hip_block_35 + t_left_hip_block_8 * t_left_hip_block_32;
  const Scalar t_left_hip_block_37 = t_left_hip_block_36 + c_left_hip_roll * t_left_hip_fork_56;
  const Scalar t_left_hip_block_38 = t_left_hip_block_37 + s_left_hip_roll * t_left_hip_fork_48;
  const Scalar t_left_hip_block_14 = w[54];
  const Scalar t_left_hip_block_39 =
      t_left_hip_block_38 + t_left_hip_block_14 * t_left_hip_block_29;
  const Scalar zeta_left_hip_block_y = w[52];
  const Scalar t_left_hip_block_40 =
      t_left_hip_block_39 - zeta_left_hip_block_y * t_left_hip_block_25;
  const Scalar t_left_hip_block_12 = w[53];
  const Scalar t_left_hip_block_41 =
      t_left_hip_block_40 - t_left_hip_block_12 * t_left_hip_block_28;
  w[93] = t_left_hip_block_41;
  const Scalar t_left_hip_block_42 = t_left_thigh_147 - (left_hip_block_m1 + t_left_thigh_24);
  const Scalar t_left_hip_block_43 = t_left_hip_block_42 - t_left_hip_fork_86 * t_left_hip_block_24;
  const Scalar t_left_hip_block_44 = t_left_hip_block_43 + t_left_thigh_164 * t_left_hip_fork_57;
  const Scalar t_left_hip_fork_94 = s_left_hip_roll * t_left_hip_fork_87;
  const Scalar t_left_hip_fork_95 = t_left_hip_fork_94 - c_left_hip_roll * t_left_hip_fork_88;
  const Scalar t_left_hip_block_45 = t_left_hip_fork_95 + t_left_hip_fork_86 * t_left_hip_block_26;
  const Scalar t_left_hip_block_46 = t_left_hip_fork_65 * t_left_hip_block_24;
  const Scalar t_left_hip_block_47 = c_left_hip_roll * t_left_hip_fork_58 + t_left_hip_block_46;
  const Scalar t_left_hip_block_48 = t_left_hip_block_47 + s_left_hip_roll * t_left_hip_fork_59;
  const Scalar t_left_hip_block_49 = left_hip_block_I15 * t_left_hip_block_24;
  const Scalar t_left_hip_block_50 = left_hip_block_h1 * t_left_hip_block_17;
  const Scalar t_left_hip_block_51 = t_left_hip_block_50 - left_hip_fork_h2 * t_left_hip_fork_14;
  const Scalar t_left_hip_block_52 = t_left_hip_block_51 - left_hip_fork_h1 * t_left_hip_fork_16;
  const Scalar t_left_hip_block_53 = t_left_hip_block_52 - s_q8_q9_q10 * t_left_thigh_49;
  const Scalar t_left_hip_block_54 = t_left_hip_block_53 + c_q8_q9_q10 * t_left_thigh_36;
  const Scalar t_left_hip_block_55 = t_left_hip_block_54 + t_left_hip_fork_8 * t_left_hip_fork_58;
  const Scalar t_left_hip_block_56 =
      t_left_hip_block_55 - t_left_hip_block_24 * t_left_hip_block_31;
  const Scalar t_left_hip_block_57 = t_left_hip_block_56 + left_hip_block_h4 * t_left_hip_fork_7;
  const Scalar t_left_hip_block_58 = t_left_hip_block_57 - t_left_hip_fork_9 * t_left_hip_fork_59;
  const Scalar t_left_hip_block_59 =
      t_left_hip_block_58 - zeta_left_hip_block_y * t_left_hip_block_44;
  const Scalar t_left_hip_block_60 = t_left_hip_block_59 - u_left_hip_fork * t_left_hip_fork_57;
  const Scalar t_left_hip_block_61 =
      t_left_hip_block_60 - t_left_hip_block_12 * t_left_hip_block_45;
  const Scalar t_left_hip_block_62 =
      t_left_hip_block_61 - t_left_hip_block_14 * t_left_hip_block_48;
  const Scalar t_left_hip_block_63 = t_left_hip_block_62 - t_left_hip_block_8 * t_left_hip_block_25;
  w[94] = t_left_hip_block_63;
  const Scalar t_left_hip_fork_96 = t_left_hip_fork_67 - t_left_hip_fork_73;
  const Scalar t_left_hip_block_64 = t_left_hip_fork_96 + t_left_hip_fork_84 * t_left_hip_block_26;
  w[95] = t_left_hip_block_64;
  const Scalar t_left_hip_block_65 = left_hip_block_m1 + t_left_hip_block_64;
  const Scalar t_left_hip_block_66 = left_hip_block_I15 * t_left_hip_block_22;
  const Scalar t_left_hip_block_67 = left_hip_block_h1 - t_left_hip_fork_84 * t_left_hip_block_66;
  const Scalar t_left_hip_fork_97 = left_hip_block_h4 - t_left_hip_fork_44;
  const Scalar t_left_hip_fork_98 = t_left_hip_fork_78 - t_left_hip_fork_97;
  const Scalar t_left_hip_block_68 = t_left_hip_fork_98 - t_left_hip_fork_65 * t_left_hip_block_26;
  const Scalar t_left_hip_block_69 = u_left_hip_block * t_left_hip_block_22;
  w[96] = t_left_hip_block_69;
  const Scalar t_left_hip_block_70 = t_left_hip_fork_65 * t_left_hip_block_66;
  const Scalar t_left_hip_block_71 = left_hip_block_I8 - t_left_hip_block_70;
  const Scalar t_left_hip_block_72 = left_hip_block_p2 * t_left_hip_block_22;
  const Scalar t_left_hip_block_73 = left_hip_block_I10 + t_left_hip_block_72;
  const Scalar t_left_hip_block_74 = t_left_hip_block_17 + t_left_hip_block_69;
  const Scalar t_left_hip_block_75 =
      t_left_hip_block_74 - zeta_left_hip_block_y * t_left_hip_block_24;
  const Scalar t_left_hip_block_76 = tau[7] - left_hip_block_I8 * t_left_hip_block_18;
  const Scalar t_left_hip_block_77 = t_left_hip_block_76 + left_hip_block_I10 * t_left_hip_block_21;
  const Scalar t_base_px_5 = w[46];
  const Scalar t_left_hip_block_78 = t_base_px_5 - t_left_hip_block_20;
  const Scalar t_left_hip_block_79 =
      t_left_hip_block_77 + t_left_hip_block_16 * t_left_hip_block_73;
  const Scalar t_left_hip_block_80 = t_left_hip_block_75 + t_left_hip_block_8 * t_left_hip_block_23;
  const Scalar t_left_hip_block_81 = t_left_hip_block_79 - left_hip_block_I16 * t_left_hip_block_78;
  const Scalar t_left_hip_block_82 = t_left_hip_block_81 + left_hip_block_I15 * t_left_hip_block_80;
  const Scalar t_left_hip_block_83 =
      t_left_hip_block_82 - t_left_hip_block_14 * t_left_hip_block_71;
  const Scalar t_left_hip_block_84 =
      t_left_hip_block_83 - t_left_hip_block_12 * t_left_hip_block_67;
  w[97] = t_left_hip_block_84;
  const Scalar t_left_hip_block_85 = t_left_hip_fork_65 * t_left_hip_fork_65;
  const Scalar t_left_hip_block_86 = t_left_hip_fork_23 + t_left_hip_fork_66;
  const Scalar t_left_hip_block_87 =
      t_left_hip_block_86 + t_left_hip_block_22 * t_left_hip_block_85;
  w[98] = t_left_hip_block_87;
  const Scalar t_left_hip_block_88 = left_hip_block_I21 + t_left_hip_block_87;
  const Scalar t_left_hip_block_89 = left_hip_block_I17 * t_left_hip_block_18;
  const Scalar t_left_hip_block_90 = left_hip_block_I8 * t_left_hip_block_21 - t_left_hip_block_89;
  // left_hip_fork
  const Scalar t_left_hip_fork_99 = t_left_hip_block_90 + left_hip_block_I16 * t_left_hip_block_17;
  const Scalar t_left_hip_fork_100 = t_left_hip_fork_99 - s_left_hip_roll * t_left_hip_fork_35;
  const Scalar t_left_hip_fork_101 = t_left_hip_fork_100 - c_left_hip_roll * t_left_hip_fork_41;
  const Scalar t_left_hip_fork_102 = t_base_px_5 - t_left_hip_fork_7;
  const Scalar t_left_hip_fork_103 = t_left_hip_fork_101 - left_hip_block_I15 * t_left_hip_fork_102;
  // left_hip_block
  const Scalar t_left_hip_block_91 = t_left_hip_fork_103 - t_left_hip_fork_65 * t_left_hip_block_69;
  const Scalar t_left_hip_block_92 =
      t_left_hip_block_91 + t_left_hip_block_16 * t_left_hip_block_71;
  const Scalar t_left_hip_block_93 =
      t_left_hip_block_92 + zeta_left_hip_block_y * t_left_hip_block_48;
  const Scalar t_left_hip_block_94 = t_left_hip_block_93 - t_left_hip_block_8 * t_left_hip_block_29;
  const Scalar t_left_hip_block_95 =
      t_left_hip_block_94 - t_left_hip_block_14 * t_left_hip_block_88;
  const Scalar t_left_hip_block_96 =
      t_left_hip_block_95 + t_left_hip_block_12 * t_left_hip_block_68;
  w[99] = t_left_hip_block_96;
  const Scalar c_left_hip_yaw = w[7];
  const Scalar t_left_hip_block_97 = 2.0 * c_left_hip_yaw;
  const Scalar t_left_hip_block_98 = t_left_hip_block_32 + t_left_hip_block_44;
  const Scalar t_left_hip_block_99 = t_left_hip_block_25 * t_left_hip_block_97;
  const Scalar s_left_hip_yaw = w[6];
  const Scalar t_left_hip_block_100 = t_left_hip_block_99 + s_left_hip_yaw * t_left_hip_block_98;
  const Scalar t_left_hip_block_101 = s_left_hip_yaw * t_left_hip_block_100;
  const Scalar t_left_hip_block_102 = c_left_hip_yaw * t_left_hip_block_28;
  const Scalar t_left_hip_block_103 = t_left_hip_block_102 + s_left_hip_yaw * t_left_hip_block_45;
  w[100] = t_left_hip_block_103;
  const Scalar t_left_hip_block_104 = t_left_hip_block_29 + t_left_hip_block_49;
  const Scalar t_left_hip_block_105 = t_left_hip_block_30 - t_left_hip_block_48;
  const Scalar t_left_hip_block_106 = s_left_hip_yaw * t_left_hip_block_104;
  const Scalar t_left_hip_block_107 = t_left_hip_block_106 - c_left_hip_yaw * t_left_hip_block_105;
  const Scalar t_left_hip_block_108 = c_left_hip_yaw * t_left_hip_block_107;
  w[101] = t_left_hip_block_108;
  const Scalar t_left_hip_block_109 = c_left_hip_yaw * t_left_hip_block_67;
  const Scalar t_left_hip_block_110 = t_left_hip_block_109 - s_left_hip_yaw * t_left_hip_block_68;
  const Scalar t_left_hip_block_111 =
      t_left_hip_block_110 + left_hip_block_l1 * t_left_hip_block_65;
  const Scalar t_left_hip_block_112 =
      t_left_hip_block_111 + left_hip_block_l2 * t_left_hip_block_103;
  const Scalar t_left_hip_block_113 = t_left_hip_block_73 - t_left_hip_block_88;
  const Scalar t_left_hip_block_114 = t_left_hip_block_71 * t_left_hip_block_97;
  const Scalar t_left_hip_block_115 = s_left_hip_yaw * t_left_hip_block_113 - t_left_hip_block_114;
  const Scalar t_right_hip_block_23 = w[171];
  const Scalar t_right_hip_block_98 = w[132];
  const Scalar t_right_hip_block_115 = t_right_hip_block_23 + t_right_hip_block_98;
  const Scalar t_left_hip_block_116 = t_left_hip_block_32 + t_right_hip_block_115;
  const Scalar t_left_hip_block_117 = t_left_hip_block_101 - t_left_hip_block_116;
  w[102] = t_left_hip_block_117;
  const Scalar s_right_hip_yaw = w[14];
  const Scalar t_right_hip_block_112 = w[142];
  const Scalar t_right_hip_block_116 = s_right_hip_yaw * t_right_hip_block_112;
  const Scalar t_left_hip_block_118 = s_left_hip_yaw * t_left_hip_block_115 + t_right_hip_block_116;
  w[103] = t_left_hip_block_118;
  const Scalar t_right_hip_block_42 = w[177];
  const Scalar t_right_hip_block_103 = w[134];
  const Scalar t_right_hip_block_117 = t_right_hip_block_42 + t_right_hip_block_103;
  const Scalar t_left_hip_block_119 = t_left_hip_block_48 - t_right_hip_block_117;
  const Scalar t_left_hip_block_120 = t_left_hip_block_108 - t_left_hip_block_119;
  const Scalar t_right_hip_block_105 = w[139];
  const Scalar t_left_hip_block_121 = t_right_hip_block_105 - t_left_hip_block_103;
  const Scalar t_left_hip_block_122 =
      t_left_hip_block_120 + left_hip_block_l1 * t_left_hip_block_121;
  const Scalar t_left_hip_block_123 =
      t_left_hip_block_122 + left_hip_block_l2 * t_left_hip_block_117;
  const Scalar t_right_hip_block_107 = w[140];
  const Scalar t_right_hip_block_109 = w[141];
  const Scalar t_left_hip_block_124 = t_right_hip_block_107 + t_right_hip_block_109;
  const Scalar t_left_hip_block_125 = t_left_hip_block_110 + t_left_hip_block_124;
  const Scalar t_right_hip_block_65 = w[195];
  const Scalar t_left_hip_block_126 = base_rx_I16 - t_right_hip_block_65 + t_left_hip_block_72;
  const Scalar t_left_hip_block_127 = t_left_hip_block_120 + t_left_hip_block_123;
  const Scalar t_left_hip_block_128 = t_left_hip_block_118 - t_left_hip_block_126;
  const Scalar t_left_hip_block_129 = t_left_hip_block_112 + t_left_hip_block_125;
  const Scalar t_left_hip_block_130 =
      t_left_hip_block_128 + left_hip_block_l2 * t_left_hip_block_127;
  const Scalar t_left_hip_block_131 =
      t_left_hip_block_130 - left_hip_block_l1 * t_left_hip_block_129;
  w[104] = t_left_hip_block_131;
  const Scalar t_left_hip_block_132 = s_left_hip_yaw * t_left_hip_block_107;
  const Scalar t_right_hip_block_22 = w[170];
  const Scalar c_right_hip_yaw = w[15];
  const Scalar t_right_hip_block_97 = w[129];
  const Scalar t_right_hip_block_118 =
      t_right_hip_block_22 - c_right_hip_yaw * t_right_hip_block_97;
  const Scalar t_left_hip_block_133 = t_left_hip_block_25 - c_left_hip_yaw * t_left_hip_block_100;
  const Scalar t_left_hip_block_134 = t_right_hip_block_118 - t_left_hip_block_133;
  w[110] = t_left_hip_block_134;
  const Scalar t_left_hip_block_135 = c_left_hip_yaw * t_left_hip_block_45;
  const Scalar t_left_hip_block_136 = t_left_hip_block_135 - s_left_hip_yaw * t_left_hip_block_28;
  // right_hip_block
  const Scalar t_right_hip_block_39 = w[176];
  const Scalar t_right_hip_block_119 = c_right_hip_yaw * t_right_hip_block_39;
  const Scalar t_right_hip_block_25 = w[172];
  const Scalar t_right_hip_block_120 =
      t_right_hip_block_119 + s_right_hip_yaw * t_right_hip_block_25;
  const Scalar t_right_hip_block_62 = w[192];
  const Scalar t_right_hip_block_121 = s_right_hip_yaw * t_right_hip_block_62;
  const Scalar t_right_hip_block_61 = w[187];
  const Scalar t_right_hip_block_122 =
      t_right_hip_block_121 + c_right_hip_yaw * t_right_hip_block_61;
  const Scalar t_right_hip_block_123 =
      t_right_hip_block_122 - left_hip_block_l2 * t_right_hip_block_120;
  w[111] = t_right_hip_block_123;
  // left_hip_block
  const Scalar t_left_hip_block_137 = left_hip_block_l2 * t_left_hip_block_136;
  const Scalar t_left_hip_block_138 = c_left_hip_yaw * t_left_hip_block_68 - t_left_hip_block_137;
  const Scalar t_left_hip_block_139 = t_left_hip_block_138 + s_left_hip_yaw * t_left_hip_block_67;
  w[112] = t_left_hip_block_139;
  const Scalar t_right_hip_block_27 = w[173];
  const Scalar t_right_hip_block_113 = w[143];
  const Scalar t_right_hip_block_124 = t_right_hip_block_27 - t_right_hip_block_113;
  const Scalar t_left_hip_block_140 = t_left_hip_block_29 + t_right_hip_block_124;
  const Scalar t_left_hip_block_141 = t_left_hip_block_132 - t_left_hip_block_140;
  w[113] = t_left_hip_block_141;
  const Scalar t_right_hip_block_43 = w[178];
  const Scalar t_right_hip_block_125 = t_right_hip_block_43 - t_right_hip_block_113;
  const Scalar t_left_hip_block_142 = t_left_hip_block_49 - t_left_hip_block_132;
  const Scalar t_left_hip_block_143 = left_hip_block_l2 * t_left_hip_block_134;
  w[117] = t_left_hip_block_143;
  const Scalar t_left_hip_block_144 = t_right_hip_block_125 + t_left_hip_block_142;
  const Scalar t_left_hip_block_145 = t_left_hip_block_143 + t_left_hip_block_144;
  const Scalar t_right_hip_block_63 = w[193];
  const Scalar t_left_hip_block_146 = base_rx_I6 + t_right_hip_block_63 + t_left_hip_block_70;
  const Scalar t_left_hip_block_147 = t_right_hip_block_123 + t_left_hip_block_139;
  const Scalar t_left_hip_block_148 = t_left_hip_block_146 - c_left_hip_yaw * t_left_hip_block_115;
  const Scalar t_left_hip_block_149 =
      t_left_hip_block_148 - left_hip_block_l1 * t_left_hip_block_147;
  const Scalar t_left_hip_block_150 = t_left_hip_block_141 - t_left_hip_block_145;
  const Scalar t_left_hip_block_151 =
      t_left_hip_block_149 - c_right_hip_yaw * t_right_hip_block_112;
  const Scalar t_left_hip_block_152 =
      t_left_hip_block_151 + left_hip_block_l2 * t_left_hip_block_150;
  w[118] = t_left_hip_block_152;
  const Scalar t_left_hip_block_153 = t_left_hip_block_44 - t_left_hip_block_101;
  w[119] = t_left_hip_block_153;
  const Scalar t_left_hip_block_154 = base_rx_h7 - t_left_hip_block_123;
  w[120] = t_left_hip_block_154;
  const Scalar t_left_hip_block_155 = t_right_hip_block_118 + t_left_hip_block_133;
  w[121] = t_left_hip_block_155;
  const Scalar t_left_hip_block_156 = t_left_hip_block_136 - t_right_hip_block_120;
  w[122] = t_left_hip_block_156;
  const Scalar t_left_hip_block_157 = t_right_hip_block_125 - t_left_hip_block_142;
  const Scalar t_left_hip_block_158 = base_rx_I5 - left_hip_block_l1 * t_left_hip_block_157;
  const Scalar t_left_hip_block_159 =
      t_left_hip_block_158 - left_hip_block_p3 * t_left_hip_block_155;
  const Scalar t_left_hip_block_160 =
      t_left_hip_block_159 - left_hip_block_p1 * t_left_hip_block_156;
  w[180] = t_left_hip_block_160;
  const Scalar t_left_hip_block_161 = t_left_hip_block_136 + t_right_hip_block_120;
  const Scalar t_left_hip_block_162 = left_hip_block_l1 * t_left_hip_block_161;
  w[194] = t_left_hip_block_162;
  const Scalar t_left_hip_block_163 = t_left_hip_block_145 - t_left_hip_block_162;
  w[196] = t_left_hip_block_163;
  const Scalar t_left_hip_block_164 = t_right_hip_block_109 - t_left_hip_block_112;
  w[201] = t_left_hip_block_164;
  // right_hip_block
  const Scalar t_right_hip_block_14 = w[130];
  const Scalar t_right_hip_block_126 = left_hip_block_h1 * t_right_hip_block_14;
  const Scalar t_right_hip_block_16 = w[135];
  const Scalar t_right_hip_block_127 =
      t_right_hip_block_126 - left_hip_block_h4 * t_right_hip_block_16;
  const Scalar t_right_hip_block_7 = w[126];
  const Scalar t_right_hip_block_128 =
      t_right_hip_block_127 + t_right_hip_block_7 * t_right_hip_block_62;
  const Scalar s_right_hip_roll = w[16];
  const Scalar t_right_hip_fork_23 = w[157];
  const Scalar t_right_hip_block_129 =
      t_right_hip_block_128 - s_right_hip_roll * t_right_hip_fork_23;
  const Scalar t_right_hip_block_5 = w[125];
  const Scalar t_right_hip_block_60 = w[186];
  const Scalar t_right_hip_block_130 =
      t_right_hip_block_129 + t_right_hip_block_5 * t_right_hip_block_60;
  const Scalar zeta_right_hip_block_x = w[124];
  const Scalar t_right_hip_block_131 =
      t_right_hip_block_130 + zeta_right_hip_block_x * t_right_hip_block_25;
  const Scalar zeta_right_hip_block_y = w[123];
  const Scalar t_right_hip_block_132 =
      t_right_hip_block_131 + zeta_right_hip_block_y * t_right_hip_block_39;
  const Scalar c_right_hip_roll = w[17];
  const Scalar t_right_hip_fork_30 = w[158];
  const Scalar t_right_hip_block_133 =
      t_right_hip_block_132 - c_right_hip_roll * t_right_hip_fork_30;
  const Scalar t_right_hip_block_10 = w[127];
  const Scalar t_right_hip_block_134 =
      t_right_hip_block_133 - t_right_hip_block_10 * t_right_hip_block_61;
  const Scalar t_right_hip_fork_81 = w[167];
  const Scalar t_right_hip_block_67 = w[197];
  const Scalar t_right_hip_block_135 =
      t_right_hip_block_134 - t_right_hip_fork_81 * t_right_hip_block_67;
  w[205] = t_right_hip_block_135;
  const Scalar t_left_hip_block_165 = left_hip_block_h1 * t_left_hip_block_21;
  const Scalar t_left_hip_block_166 =
      t_left_hip_block_165 - left_hip_block_h4 * t_left_hip_block_18;
  const Scalar t_left_hip_fork_104 = t_left_hip_block_166 + c_left_hip_roll * t_left_hip_fork_48;
  const Scalar t_left_hip_fork_105 = t_left_hip_fork_104 - s_left_hip_roll * t_left_hip_fork_56;
  // left_hip_block
  const Scalar t_left_hip_block_167 = t_left_hip_fork_105 - u_left_hip_block * t_left_hip_block_26;
  const Scalar t_left_hip_block_168 =
      t_left_hip_block_167 + zeta_left_hip_block_y * t_left_hip_block_45;
  const Scalar t_left_hip_block_169 =
      t_left_hip_block_168 + t_left_hip_block_16 * t_left_hip_block_67;
  const Scalar t_left_hip_block_170 =
      t_left_hip_block_169 + t_left_hip_block_8 * t_left_hip_block_28;
  const Scalar t_left_hip_block_171 =
      t_left_hip_block_170 - t_left_hip_block_12 * t_left_hip_block_65;
  const Scalar t_left_hip_block_172 =
      t_left_hip_block_171 + t_left_hip_block_14 * t_left_hip_block_68;
  w[265] = t_left_hip_block_172;
}

[[gnu::noinline]] void forward_dynamics_7(const Scalar qd[18], const Scalar tau[18], Scalar qdd[18],
                                          Scalar w[266]) noexcept {
  const Scalar c_right_hip_yaw = w[15];
  const Scalar t_right_hip_block_38 = w[175];
  const Scalar t_right_hip_block_136 = c_right_hip_yaw * t_right_hip_block_38;
  const Scalar s_right_hip_yaw = w[14];
  const Scalar t_right_hip_block_58 = w[184];
  const Scalar t_right_hip_block_137 =
      t_right_hip_block_136 - s_right_hip_yaw * t_right_hip_block_58;
  // base_rx: joint force u, 1/pivot of (1)
  const Scalar c_left_hip_yaw = w[7];
  const Scalar t_left_hip_block_41 = w[93];
  const Scalar t_base_rx_6 = t_right_hip_block_137 - c_left_hip_yaw * t_left_hip_block_41;
  const Scalar s_left_hip_yaw = w[6];
  const Scalar t_left_hip_block_63 = w[94];
  const Scalar t_base_rx_7 = t_base_rx_6 - s_left_hip_yaw * t_left_hip_block_63;
  const Scalar t_base_px_6 = w[47];
  const Scalar t_base_px_7 = w[48];
  const Scalar u_base_rx_1 = tau[5] - base_rx_I5 * t_base_px_6 + base_rx_I6 * t_base_px_7;
  const Scalar t_right_hip_block_93 = w[128];
  const Scalar u_base_rx_2 = u_base_rx_1 + s_right_hip_yaw * t_right_hip_block_93;
  const Scalar t_left_hip_block_84 = w[97];
  const Scalar u_base_rx_3 = u_base_rx_2 - c_left_hip_yaw * t_left_hip_block_84;
  const Scalar t_left_hip_block_96 = w[99];
  const Scalar u_base_rx_4 = u_base_rx_3 - s_left_hip_yaw * t_left_hip_block_96;
  const Scalar t_base_px_8 = w[49];
  const Scalar u_base_rx_5 = u_base_rx_4 + base_rx_I18 * t_base_px_8;
  const Scalar t_right_hip_block_78 = w[198];
  const Scalar u_base_rx_6 = u_base_rx_5 - c_right_hip_yaw * t_right_hip_block_78;
  const Scalar u_base_rx_7 = u_base_rx_6 + left_hip_block_l2 * t_base_rx_7;
  const Scalar t_right_hip_block_135 = w[205];
  const Scalar t_left_hip_block_172 = w[265];
  const Scalar u_base_rx_8 = t_right_hip_block_135 + t_left_hip_block_172;
  const Scalar t_base_px_5 = w[46];
  const Scalar t_base_px_9 = w[50];
  const Scalar u_base_rx_9 = u_base_rx_7 - base_rx_I13 * (t_base_px_5 - t_base_px_9);
  const Scalar u_base_rx = u_base_rx_9 - left_hip_block_l1 * u_base_rx_8;
  const Scalar t_left_hip_block_131 = w[104];
  const Scalar t_base_rx_8 = 1.0 / t_left_hip_block_131;
  const Scalar t_left_hip_block_160 = w[180];
  const Scalar t_base_rx_9 = t_left_hip_block_160 * t_base_rx_8;
  const Scalar t_left_hip_block_163 = w[196];
  const Scalar t_base_rx_10 = t_left_hip_block_163 * t_base_rx_8;
  const Scalar t_left_hip_block_164 = w[201];
  const Scalar t_base_rx_11 = t_left_hip_block_164 * t_base_rx_8;
  const Scalar t_left_hip_block_154 = w[120];
  const Scalar t_base_rx_12 = t_left_hip_block_154 * t_base_rx_8;
  const Scalar t_left_hip_block_152 = w[118];
  const Scalar t_base_rx_13 = t_left_hip_block_152 * t_base_rx_8;
  const Scalar t_left_hip_block_30 = w[92];
  const Scalar t_left_hip_block_108 = w[101];
  const Scalar t_left_hip_block_173 = t_left_hip_block_30 + t_left_hip_block_108;
  const Scalar t_left_hip_block_153 = w[119];
  const Scalar t_left_hip_block_174 =
      t_left_hip_block_173 - left_hip_block_l2 * t_left_hip_block_153;
  const Scalar t_right_hip_block_28 = w[174];
  const Scalar t_right_hip_block_103 = w[134];
  const Scalar t_right_hip_block_138 = t_right_hip_block_28 + t_right_hip_block_103;
  const Scalar t_right_hip_block_114 = w[144];
  const Scalar t_right_hip_block_139 =
      t_right_hip_block_138 - left_hip_block_l2 * t_right_hip_block_114;
  const Scalar t_left_hip_block_175 = t_left_hip_block_174 - t_right_hip_block_139;
  const Scalar t_left_hip_block_176 = base_rx_I13 - left_hip_block_l1 * t_left_hip_block_175;
  const Scalar t_base_rx_14 = t_left_hip_block_176 + t_left_hip_block_160 * t_base_rx_13;
  const Scalar t_left_hip_block_177 = t_right_hip_block_114 - t_left_hip_block_153;
  const Scalar t_left_hip_block_178 = left_hip_block_l1 * t_left_hip_block_177;
  const Scalar t_base_rx_15 = t_left_hip_block_160 * t_base_rx_10 + t_left_hip_block_178;
  const Scalar t_base_rx_16 = t_right_hip_block_114 + t_left_hip_block_153;
  const Scalar t_base_rx_17 = base_rx_I14 + t_left_hip_block_160 * t_base_rx_9;
  const Scalar t_base_rx_18 = t_base_rx_17 - left_hip_block_p1 * t_base_rx_16;
  const Scalar t_left_hip_block_162 = w[194];
  const Scalar t_base_rx_19 = t_left_hip_block_162 + t_left_hip_block_160 * t_base_rx_11;
  const Scalar t_left_hip_block_155 = w[121];
  const Scalar t_left_hip_block_179 = base_rx_h3 - left_hip_block_l1 * t_left_hip_block_155;
  const Scalar t_base_rx_20 = t_left_hip_block_179 + t_left_hip_block_160 * t_base_rx_12;
  const Scalar t_right_hip_block_140 = c_right_hip_yaw * t_right_hip_block_58;
  const Scalar t_right_hip_block_141 =
      t_right_hip_block_140 + s_right_hip_yaw * t_right_hip_block_38;
  const Scalar t_left_hip_block_180 = c_left_hip_yaw * t_left_hip_block_63;
  const Scalar t_left_hip_block_181 = t_left_hip_block_180 - s_left_hip_yaw * t_left_hip_block_41;
  // base_ry: joint force u, 1/pivot of (1)
  const Scalar c_base_rx = w[5];
  const Scalar t_base_rx_5 = w[42];
  const Scalar s_base_rx = w[4];
  const Scalar u_base_ry_1 = tau[6] + tau[12] - c_base_rx * t_base_rx_5 + s_base_rx * tau[4];
  const Scalar u_base_ry_2 = u_base_ry_1 + base_rx_I5 * t_base_px_8;
  const Scalar u_base_ry_3 = u_base_ry_2 - base_rx_I13 * t_base_px_7;
  const Scalar u_base_ry_4 = u_base_ry_3 + u_base_rx * t_base_rx_9;
  const Scalar u_base_ry_5 = t_right_hip_block_141 - t_left_hip_block_181;
  const Scalar u_base_ry_6 = u_base_ry_4 - base_rx_I15 * t_base_px_6;
  const Scalar u_base_ry_7 = u_base_ry_6 - left_hip_block_l1 * u_base_ry_5;
  const Scalar t_base_px_3 = w[44];
  const Scalar u_base_ry = u_base_ry_7 + base_rx_I6 * (t_base_px_3 - t_base_px_9);
  const Scalar inverse_pivot_base_ry = 1.0 / t_base_rx_18;
  const Scalar t_base_ry_1 = t_base_rx_15 * inverse_pivot_base_ry;
  const Scalar t_base_ry_2 = t_base_rx_19 * inverse_pivot_base_ry;
  const Scalar t_base_ry_3 = t_base_rx_20 * inverse_pivot_base_ry;
  const Scalar t_base_ry_4 = t_base_rx_14 * inverse_pivot_base_ry;
  const Scalar t_left_hip_block_141 = w[113];
  const Scalar t_left_hip_block_143 = w[117];
  const Scalar t_left_hip_block_182 = t_left_hip_block_141 - t_left_hip_block_143;
  const Scalar t_base_ry_5 = t_left_hip_block_182 - t_base_rx_14 * t_base_ry_3;
  const Scalar t_base_ry_6 = t_base_ry_5 + t_left_hip_block_154 * t_base_rx_13;
  // left_hip_block
  const Scalar t_left_hip_block_183 = t_left_hip_block_174 + t_right_hip_block_139;
  const Scalar t_left_hip_block_184 = t_left_hip_block_173 + t_right_hip_block_138;
  const Scalar t_left_hip_block_87 = w[98];
  const Scalar t_right_hip_block_79 = w[199];
  const Scalar t_left_hip_block_185 = base_rx_I17 + t_right_hip_block_79 + t_left_hip_block_87;
  const Scalar t_left_hip_block_186 = t_left_hip_block_183 + t_left_hip_block_184;
  const Scalar t_left_hip_block_118 = w[103];
  const Scalar t_left_hip_block_187 = t_left_hip_block_118 + t_left_hip_block_185;
  const Scalar t_left_hip_block_188 =
      t_left_hip_block_187 + left_hip_block_l2 * t_left_hip_block_186;
  const Scalar t_base_ry_7 = t_left_hip_block_188 - t_base_rx_14 * t_base_ry_4;
  const Scalar t_base_ry_8 = t_base_ry_7 + t_left_hip_block_152 * t_base_rx_13;
  const Scalar t_right_hip_block_123 = w[111];
  const Scalar t_right_hip_block_142 = base_rx_h3 + t_right_hip_block_123;
  const Scalar t_left_hip_block_139 = w[112];
  const Scalar t_left_hip_block_189 = t_left_hip_block_139 - t_right_hip_block_142;
  const Scalar t_base_ry_9 = t_left_hip_block_189 - t_base_rx_14 * t_base_ry_2;
  const Scalar t_base_ry_10 = t_base_ry_9 + t_left_hip_block_152 * t_base_rx_11;
  const Scalar t_left_hip_block_190 = base_rx_h7 + t_left_hip_block_183;
  const Scalar t_base_rx_21 = t_left_hip_block_190 - t_left_hip_block_152 * t_base_rx_10;
  const Scalar t_base_ry_11 = t_base_rx_21 + t_base_rx_15 * t_base_ry_4;
  const Scalar t_base_rz_1 = t_right_hip_block_141 + t_left_hip_block_181;
  const Scalar neg_u_base_rz_1 = s_base_rx * t_base_rx_5 + c_base_rx * tau[4];
  // base_rz: joint force u, 1/pivot of (1)
  const Scalar neg_u_base_rz_2 = neg_u_base_rz_1 + base_rx_I6 * t_base_px_8;
  const Scalar neg_u_base_rz_3 = neg_u_base_rz_2 - base_rx_I13 * t_base_px_6;
  const Scalar neg_u_base_rz_4 = neg_u_base_rz_3 - c_right_hip_yaw * t_right_hip_block_93;
  const Scalar neg_u_base_rz_5 = neg_u_base_rz_4 + c_left_hip_yaw * t_left_hip_block_96;
  const Scalar neg_u_base_rz_6 = neg_u_base_rz_5 - s_left_hip_yaw * t_left_hip_block_84;
  const Scalar neg_u_base_rz_7 = neg_u_base_rz_6 - u_base_rx * t_base_rx_13;
  const Scalar neg_u_base_rz_8 = neg_u_base_rz_7 + u_base_ry * t_base_ry_4;
  const Scalar neg_u_base_rz_9 = neg_u_base_rz_8 + left_hip_block_l2 * t_base_rz_1;
  const Scalar neg_u_base_rz_10 = neg_u_base_rz_9 - s_right_hip_yaw * t_right_hip_block_78;
  const Scalar t_base_px_1 = w[43];
  const Scalar t_base_px_4 = w[45];
  const Scalar neg_u_base_rz_11 = t_base_px_1 - t_base_px_4;
  const Scalar neg_u_base_rz_12 = neg_u_base_rz_10 + base_rx_I5 * neg_u_base_rz_11;
  const Scalar neg_u_base_rz = neg_u_base_rz_12 + base_rx_I19 * t_base_px_7;
  const Scalar inverse_pivot_base_rz = 1.0 / t_base_ry_8;
  const Scalar t_base_rz_2 = t_base_ry_6 * inverse_pivot_base_rz;
  const Scalar t_base_rz_3 = t_base_ry_10 * inverse_pivot_base_rz;
  const Scalar t_base_rz_4 = t_base_ry_11 * inverse_pivot_base_rz;
  const Scalar t_left_hip_block_134 = w[110];
  const Scalar t_base_rx_22 = t_left_hip_block_134 + t_left_hip_block_163 * t_base_rx_12;
  const Scalar t_base_rz_5 = t_base_rx_22 + t_base_ry_6 * t_base_rz_4;
  const Scalar t_base_rz_6 = t_base_rz_5 - t_base_rx_15 * t_base_ry_3;
  const Scalar t_left_hip_block_156 = w[122];
  const Scalar t_base_rz_7 = t_left_hip_block_156 + t_base_ry_11 * t_base_rz_3;
  const Scalar t_base_rz_8 = t_base_rz_7 - t_base_rx_19 * t_base_ry_1;
  const Scalar t_base_rz_9 = t_base_rz_8 + t_left_hip_block_163 * t_base_rx_11;
  const Scalar t_left_hip_block_191 = base_rx_m4 - t_base_rx_16;
  const Scalar t_base_rx_23 = t_left_hip_block_191 + t_left_hip_block_163 * t_base_rx_10;
  const Scalar t_base_ry_12 = t_base_rx_23 - t_base_rx_15 * t_base_ry_1;
  // base_pz: joint force u, 1/pivot of (1)
  const Scalar s_base_ry = w[2];
  const Scalar u_base_pz_1 = t_base_rz_1 - s_base_ry * tau[2] + base_rx_h7 * t_base_px_7;
  const Scalar u_base_pz_2 = u_base_pz_1 + u_base_rx * t_base_rx_10;
  const Scalar u_base_pz_3 = u_base_pz_2 - u_base_ry * t_base_ry_1;
  const Scalar u_base_pz_4 = u_base_pz_3 - neg_u_base_rz * t_base_rz_4;
  const Scalar u_base_pz_5 = u_base_pz_4 + base_rx_h3 * t_base_px_3;
  const Scalar c_base_ry = w[3];
  const Scalar t_base_rx_1 = w[38];
  const Scalar u_base_pz = u_base_pz_5 + c_base_ry * t_base_rx_1;
  const Scalar inverse_pivot_base_pz = 1.0 / (t_base_ry_12 - t_base_ry_11 * t_base_rz_4);
  const Scalar t_base_pz_1 = t_base_rz_6 * inverse_pivot_base_pz;
  const Scalar t_right_hip_block_105 = w[139];
  const Scalar t_left_hip_block_103 = w[100];
  const Scalar t_left_hip_block_192 = t_right_hip_block_105 + t_left_hip_block_103;
  const Scalar t_base_pz_2 = t_left_hip_block_192 + t_base_rx_19 * t_base_ry_3;
  const Scalar t_base_pz_3 = t_base_pz_2 + t_base_rz_9 * t_base_pz_1;
  const Scalar t_base_pz_4 = t_base_pz_3 - t_left_hip_block_154 * t_base_rx_11;
  const Scalar t_base_pz_5 = t_base_pz_4 + t_base_ry_6 * t_base_rz_3;
  const Scalar t_base_pz_6 = t_base_rz_9 * inverse_pivot_base_pz;
  const Scalar t_left_hip_block_64 = w[95];
  const Scalar t_right_hip_block_59 = w[185];
  const Scalar t_left_hip_block_193 = base_rx_m2 + t_right_hip_block_59 + t_left_hip_block_64;
  const Scalar t_base_pz_7 = t_left_hip_block_193 - t_base_rz_9 * t_base_pz_6;
  const Scalar t_base_pz_8 = t_base_pz_7 - t_base_rx_19 * t_base_ry_2;
  const Scalar t_base_pz_9 = t_base_pz_8 - t_base_ry_10 * t_base_rz_3;
  const Scalar t_base_pz_10 = t_base_pz_9 + t_left_hip_block_164 * t_base_rx_11;
  // base_py: 1/pivot, joint force u of (1)
  const Scalar inverse_pivot_base_py = 1.0 / t_base_pz_10;
  const Scalar neg_u_base_py_1 = t_right_hip_block_135 - t_left_hip_block_172;
  const Scalar neg_u_base_py_2 = neg_u_base_py_1 + base_rx_h3 * t_base_px_7;
  const Scalar neg_u_base_py_3 = neg_u_base_py_2 - u_base_rx * t_base_rx_11;
  const Scalar neg_u_base_py_4 = neg_u_base_py_3 + u_base_ry * t_base_ry_2;
  const Scalar neg_u_base_py_5 = neg_u_base_py_4 - neg_u_base_rz * t_base_rz_3;
  const Scalar t_base_rx_3 = w[40];
  const Scalar neg_u_base_py_6 = neg_u_base_py_5 + s_base_rx * t_base_rx_3;
  const Scalar neg_u_base_py_7 = neg_u_base_py_6 + u_base_pz * t_base_pz_6;
  const Scalar t_base_rx_2 = w[39];
  const Scalar neg_u_base_py_8 = neg_u_base_py_7 + c_base_rx * t_base_rx_2;
  const Scalar neg_u_base_py = neg_u_base_py_8 + base_rx_h7 * t_base_px_5;
  const Scalar t_base_py_1 = t_base_pz_5 * inverse_pivot_base_py;
  const Scalar t_left_hip_block_117 = w[102];
  const Scalar t_left_hip_block_194 = base_rx_m4 - t_left_hip_block_117;
  const Scalar t_base_py_2 = t_left_hip_block_194 - t_base_rz_6 * t_base_pz_1;
  const Scalar t_base_py_3 = t_base_py_2 + t_left_hip_block_154 * t_base_rx_12;
  const Scalar t_base_py_4 = t_base_py_3 - t_base_rx_20 * t_base_ry_3;
  const Scalar t_base_py_5 = t_base_py_4 - t_base_pz_5 * t_base_py_1;
  const Scalar inverse_pivot_base_px = 1.0 / (t_base_py_5 - t_base_ry_6 * t_base_rz_2);
  const Scalar u_base_px_1 = t_base_rx_7 + base_rx_h7 * t_base_px_8;
  const Scalar u_base_px_2 = u_base_px_1 - base_rx_h3 * t_base_px_6;
  const Scalar u_base_px_3 = u_base_px_2 + u_base_rx * t_base_rx_12;
  const Scalar u_base_px_4 = u_base_px_3 - u_base_ry * t_base_ry_3;
  const Scalar u_base_px_5 = u_base_px_4 + neg_u_base_rz * t_base_rz_2;
  // base_px: joint force u of (1)
  const Scalar u_base_px_6 = u_base_px_5 - neg_u_base_py * t_base_py_1;
  const Scalar u_base_px_7 = u_base_px_6 + c_base_rx * t_base_rx_3;
  const Scalar u_base_px = u_base_px_7 - u_base_pz * t_base_pz_1 - s_base_rx * t_base_rx_2;
  const Scalar t_base_px_10 = inverse_pivot_base_px * u_base_px;
  const Scalar t_base_py_6 = neg_u_base_py - t_base_pz_5 * t_base_px_10;
  const Scalar t_base_py_7 = inverse_pivot_base_py * t_base_py_6;
  // base_pz
  const Scalar t_base_pz_11 = u_base_pz - t_base_rz_6 * t_base_px_10;
  const Scalar t_base_pz_12 = t_base_pz_11 + t_base_rz_9 * t_base_py_7;
  const Scalar t_base_pz_13 = inverse_pivot_base_pz * t_base_pz_12;
  // base_rz
  const Scalar t_base_rz_10 = neg_u_base_rz - t_base_ry_11 * t_base_pz_13;
  const Scalar t_base_rz_11 = t_base_rz_10 - t_base_ry_10 * t_base_py_7;
  const Scalar t_base_rz_12 = inverse_pivot_base_rz * t_base_rz_11;
  const Scalar t_base_rz_13 = t_base_rz_2 * t_base_px_10 + t_base_rz_12;
  // base_ry
  const Scalar t_base_ry_13 = u_base_ry - t_base_rx_15 * t_base_pz_13;
  const Scalar t_base_ry_14 = t_base_ry_13 + t_base_rx_14 * t_base_rz_13;
  const Scalar t_base_ry_15 = t_base_ry_14 + t_base_rx_19 * t_base_py_7;
  const Scalar t_base_ry_16 = t_base_ry_15 - t_base_rx_20 * t_base_px_10;
  const Scalar t_base_ry_17 = inverse_pivot_base_ry * t_base_ry_16;
  // base_rx: qdd of (1)
  const Scalar t_base_rx_24 = u_base_rx - t_left_hip_block_160 * t_base_ry_17;
  const Scalar t_base_rx_25 = t_base_rx_24 + t_left_hip_block_152 * t_base_rz_13;
  const Scalar t_base_rx_26 = t_base_rx_25 - t_left_hip_block_154 * t_base_px_10;
  const Scalar t_base_rx_27 = t_base_rx_26 + t_left_hip_block_164 * t_base_py_7;
  const Scalar t_base_rx_28 = t_base_rx_27 - t_left_hip_block_163 * t_base_pz_13;
  const Scalar t_base_rx_29 = t_base_rx_8 * t_base_rx_28;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_195 = t_base_px_10 - left_hip_block_l2 * t_base_rx_29;
  const Scalar t_left_hip_block_196 = left_hip_block_l1 * t_base_ry_17;
  const Scalar t_left_hip_block_197 = t_base_pz_13 + left_hip_block_l2 * t_base_rz_13;
  const Scalar t_left_hip_block_198 = t_left_hip_block_196 + t_left_hip_block_197;
  const Scalar t_left_hip_block_8 = w[51];
  const Scalar t_left_hip_block_199 = t_left_hip_block_8 + c_left_hip_yaw * t_left_hip_block_195;
  const Scalar t_left_hip_block_200 = t_left_hip_block_199 + s_left_hip_yaw * t_left_hip_block_198;
  const Scalar zeta_left_hip_block_y = w[52];
  const Scalar t_left_hip_block_201 = zeta_left_hip_block_y + s_left_hip_yaw * t_left_hip_block_195;
  const Scalar t_left_hip_block_202 = t_left_hip_block_201 - c_left_hip_yaw * t_left_hip_block_198;
  const Scalar t_left_hip_block_203 = left_hip_block_l1 * t_base_rx_29;
  const Scalar t_left_hip_block_12 = w[53];
  const Scalar t_left_hip_block_204 = t_left_hip_block_12 - t_base_py_7;
  const Scalar t_left_hip_block_205 = t_left_hip_block_203 + t_left_hip_block_204;
  const Scalar t_left_hip_block_14 = w[54];
  const Scalar t_left_hip_block_206 = t_left_hip_block_14 + s_left_hip_yaw * t_base_rx_29;
  const Scalar t_left_hip_block_207 = t_left_hip_block_206 + c_left_hip_yaw * t_base_rz_13;
  const Scalar t_left_hip_block_16 = w[55];
  const Scalar t_left_hip_block_208 = t_left_hip_block_16 - c_left_hip_yaw * t_base_rx_29;
  const Scalar t_left_hip_block_209 = t_left_hip_block_208 + s_left_hip_yaw * t_base_rz_13;
  const Scalar t_left_hip_fork_86 = w[85];
  const Scalar neg_qdd_6_1 = t_left_hip_fork_86 * t_left_hip_block_202;
  const Scalar neg_qdd_6_2 = left_hip_block_I15 * t_left_hip_block_209 - neg_qdd_6_1;
  const Scalar t_left_hip_fork_82 = w[83];
  const Scalar neg_qdd_6_3 = neg_qdd_6_2 - t_left_hip_fork_82 * t_base_ry_17;
  const Scalar t_left_hip_fork_65 = w[81];
  const Scalar neg_qdd_6_4 = neg_qdd_6_3 + t_left_hip_fork_65 * t_left_hip_block_207;
  const Scalar t_left_hip_fork_84 = w[84];
  const Scalar neg_qdd_6_5 = neg_qdd_6_4 + t_left_hip_fork_84 * t_left_hip_block_205;
  const Scalar t_left_hip_fork_80 = w[82];
  const Scalar neg_qdd_6_6 = neg_qdd_6_5 + t_left_hip_fork_80 * t_left_hip_block_200;
  const Scalar t_left_hip_block_69 = w[96];
  const Scalar t_left_hip_block_22 = w[86];
  const Scalar neg_qdd_6 = t_left_hip_block_69 + t_left_hip_block_22 * neg_qdd_6_6;
  qdd[6] = -neg_qdd_6;
  const Scalar t_left_hip_block_210 = t_base_ry_17 + neg_qdd_6;
  // left_hip_fork: qdd of (1)
  const Scalar t_left_hip_fork_9 = w[62];
  const Scalar c_left_hip_roll = w[9];
  const Scalar t_left_hip_fork_106 = t_left_hip_fork_9 + c_left_hip_roll * t_left_hip_block_210;
  const Scalar s_left_hip_roll = w[8];
  const Scalar t_left_hip_fork_107 = t_left_hip_fork_106 + s_left_hip_roll * t_left_hip_block_207;
  const Scalar t_left_hip_fork_8 = w[61];
  const Scalar t_left_hip_fork_108 = t_left_hip_fork_8 - c_left_hip_roll * t_left_hip_block_207;
  const Scalar t_left_hip_fork_109 = t_left_hip_fork_108 + s_left_hip_roll * t_left_hip_block_210;
  const Scalar t_left_hip_fork_110 = s_left_hip_roll * t_left_hip_block_205;
  const Scalar t_left_hip_fork_111 = t_left_hip_fork_110 + c_left_hip_roll * t_left_hip_block_200;
  const Scalar t_left_hip_fork_112 = s_left_hip_roll * t_left_hip_block_200;
  const Scalar t_left_hip_fork_113 = t_left_hip_fork_112 - c_left_hip_roll * t_left_hip_block_205;
  const Scalar u_left_hip_fork = w[75];
  const Scalar t_left_thigh_162 = w[73];
  const Scalar neg_qdd_7_1 = u_left_hip_fork - t_left_thigh_162 * t_left_hip_block_209;
  const Scalar t_left_hip_fork_18 = w[77];
  const Scalar neg_qdd_7_2 = t_left_hip_fork_18 * t_left_hip_fork_107;
  const Scalar t_left_hip_fork_49 = w[79];
  const Scalar neg_qdd_7_3 = neg_qdd_7_2 + t_left_hip_fork_49 * t_left_hip_fork_111;
  const Scalar t_left_thigh_163 = w[74];
  const Scalar neg_qdd_7_4 = neg_qdd_7_1 + t_left_thigh_163 * t_left_hip_fork_113;
  const Scalar t_left_hip_fork_57 = w[80];
  const Scalar neg_qdd_7_5 = neg_qdd_7_3 - t_left_hip_fork_57 * t_left_hip_block_202;
  const Scalar t_left_hip_fork_17 = w[76];
  const Scalar neg_qdd_7_6 = neg_qdd_7_5 - t_left_hip_fork_17 * neg_qdd_7_4;
  const Scalar t_left_hip_fork_19 = w[78];
  const Scalar neg_qdd_7 = neg_qdd_7_6 - t_left_hip_fork_19 * t_left_hip_fork_109;
  qdd[7] = -neg_qdd_7;
  const Scalar t_left_hip_fork_114 = t_left_hip_block_209 - neg_qdd_7;
  // left_thigh: qdd of (1)
  const Scalar t_left_thigh_3 = w[70];
  const Scalar c_q8_q9_q10 = w[11];
  const Scalar t_left_thigh_185 = t_left_thigh_3 + c_q8_q9_q10 * t_left_hip_fork_114;
  const Scalar s_q8_q9_q10 = w[10];
  const Scalar t_left_thigh_186 = t_left_thigh_185 + s_q8_q9_q10 * t_left_hip_fork_107;
  const Scalar t_left_thigh_4 = w[71];
  const Scalar t_left_thigh_187 = t_left_thigh_4 - s_q8_q9_q10 * t_left_hip_fork_114;
  const Scalar t_left_thigh_188 = t_left_thigh_187 + c_q8_q9_q10 * t_left_hip_fork_107;
  const Scalar t_left_thigh_189 = t_left_hip_fork_113 + left_hip_fork_l1 * t_left_hip_fork_109;
  const Scalar zeta_left_thigh_x = w[69];
  const Scalar t_left_thigh_190 = zeta_left_thigh_x - c_q8_q9_q10 * t_left_thigh_189;
  const Scalar t_left_thigh_191 = t_left_thigh_190 + s_q8_q9_q10 * t_left_hip_block_202;
  const Scalar neg_zeta_left_thigh_z = w[72];
  const Scalar t_left_thigh_192 = neg_zeta_left_thigh_z + t_left_hip_fork_111;
  const Scalar t_left_thigh_193 = t_left_thigh_192 + left_hip_fork_l1 * t_left_hip_fork_107;
  const Scalar zeta_left_thigh_y = w[68];
  const Scalar t_left_thigh_194 = zeta_left_thigh_y + c_q8_q9_q10 * t_left_hip_block_202;
  const Scalar t_left_thigh_195 = t_left_thigh_194 + s_q8_q9_q10 * t_left_thigh_189;
  const Scalar u_left_thigh = w[232];
  const Scalar t_left_shank_86 = w[229];
  const Scalar qdd_8_1 = u_left_thigh + t_left_shank_86 * t_left_thigh_195;
  const Scalar t_left_shank_85 = w[228];
  const Scalar qdd_8_2 = qdd_8_1 - t_left_shank_85 * t_left_thigh_186;
  const Scalar t_left_shank_87 = w[230];
  const Scalar qdd_8_3 = qdd_8_2 - t_left_shank_87 * t_left_thigh_191;
  const Scalar t_left_shank_74 = w[226];
  const Scalar qdd_8_4 = qdd_8_3 + t_left_shank_74 * t_left_thigh_188;
  const Scalar t_left_shank_80 = w[227];
  const Scalar qdd_8_5 = qdd_8_4 + t_left_shank_80 * t_left_hip_fork_109;
  const Scalar t_left_shank_88 = w[231];
  const Scalar qdd_8_6 = qdd_8_5 - t_left_shank_88 * t_left_thigh_193;
  const Scalar inverse_pivot_left_thigh = w[242];
  const Scalar qdd_8 = inverse_pivot_left_thigh * qdd_8_6;
  qdd[8] = qdd_8;
  const Scalar t_left_thigh_196 = t_left_hip_fork_109 - qdd_8;
  // left_shank: qdd of (1)
  const Scalar t_left_shank_4 = w[91];
  const Scalar t_left_shank_105 = t_left_shank_4 + t_left_thigh_186;
  const Scalar t_left_shank_3 = w[90];
  const Scalar t_left_shank_106 = t_left_shank_3 + t_left_thigh_188;
  const Scalar zeta_left_shank_x = w[88];
  const Scalar t_left_shank_107 = zeta_left_shank_x + t_left_thigh_191;
  const Scalar s_left_shank_y = w[27];
  const Scalar t_left_shank_108 = t_left_shank_107 + s_left_shank_y * t_left_thigh_196;
  const Scalar neg_zeta_left_shank_y = w[87];
  const Scalar t_left_shank_109 = neg_zeta_left_shank_y - t_left_thigh_195;
  const Scalar neg_s_left_shank_x = w[26];
  const Scalar t_left_shank_110 = t_left_shank_109 - neg_s_left_shank_x * t_left_thigh_196;
  const Scalar neg_zeta_left_shank_z = w[89];
  const Scalar t_left_shank_111 = neg_zeta_left_shank_z + t_left_thigh_193;
  const Scalar t_left_shank_112 = t_left_shank_111 - s_left_shank_y * t_left_thigh_188;
  const Scalar t_left_shank_113 = t_left_shank_112 + neg_s_left_shank_x * t_left_thigh_186;
  const Scalar u_left_shank = w[224];
  const Scalar t_left_ankle_cross_61 = w[218];
  const Scalar qdd_9_1 = u_left_shank + t_left_ankle_cross_61 * t_left_shank_106;
  const Scalar t_left_ankle_cross_73 = w[221];
  const Scalar qdd_9_2 = qdd_9_1 - t_left_ankle_cross_73 * t_left_shank_110;
  const Scalar t_left_ankle_cross_75 = w[223];
  const Scalar qdd_9_3 = qdd_9_2 - t_left_ankle_cross_75 * t_left_shank_113;
  const Scalar t_left_ankle_cross_74 = w[222];
  const Scalar qdd_9_4 = qdd_9_3 - t_left_ankle_cross_74 * t_left_shank_108;
  const Scalar t_left_ankle_cross_66 = w[219];
  const Scalar qdd_9_5 = qdd_9_4 + t_left_ankle_cross_66 * t_left_shank_105;
  const Scalar t_left_ankle_cross_72 = w[220];
  const Scalar qdd_9_6 = qdd_9_5 + t_left_ankle_cross_72 * t_left_thigh_196;
  const Scalar inverse_pivot_left_shank = w[225];
  const Scalar qdd_9 = inverse_pivot_left_shank * qdd_9_6;
  qdd[9] = qdd_9;
  const Scalar t_left_shank_114 = t_left_thigh_196 - qdd_9;
  // left_ankle_cross: qdd of (1)
  const Scalar t_left_ankle_cross_5 = w[108];
  const Scalar t_left_ankle_cross_91 = t_left_ankle_cross_5 + t_left_shank_106;
  const Scalar t_left_ankle_cross_6 = w[109];
  const Scalar t_left_ankle_cross_92 = t_left_ankle_cross_6 + t_left_shank_105;
  const Scalar zeta_left_ankle_cross_z = w[107];
  const Scalar t_left_ankle_cross_93 = zeta_left_ankle_cross_z - t_left_shank_113;
  const Scalar s_left_ankle_cross_y = w[28];
  const Scalar t_left_ankle_cross_94 =
      t_left_ankle_cross_93 + s_left_ankle_cross_y * t_left_shank_106;
  const Scalar neg_s_left_ankle_cross_x = w[29];
  const Scalar t_left_ankle_cross_95 =
      t_left_ankle_cross_94 - neg_s_left_ankle_cross_x * t_left_shank_105;
  const Scalar zeta_left_ankle_cross_x = w[106];
  const Scalar t_left_ankle_cross_96 = zeta_left_ankle_cross_x + t_left_shank_108;
  const Scalar t_left_ankle_cross_97 =
      t_left_ankle_cross_96 + s_left_ankle_cross_y * t_left_shank_114;
  const Scalar t_left_ankle_cross_2 = w[105];
  const Scalar qdd_10_1 = t_left_ankle_cross_2 + t_left_shank_110;
  const Scalar qdd_10_2 = qdd_10_1 - neg_s_left_ankle_cross_x * t_left_shank_114;
  const Scalar u_left_ankle_cross = w[216];
  const Scalar t_left_foot_58 = w[215];
  const Scalar qdd_10_3 = u_left_ankle_cross + t_left_foot_58 * qdd_10_2;
  const Scalar t_left_foot_47 = w[209];
  const Scalar qdd_10_4 = qdd_10_3 + t_left_foot_47 * t_left_ankle_cross_95;
  const Scalar t_left_foot_49 = w[210];
  const Scalar qdd_10_5 = qdd_10_4 - t_left_foot_49 * t_left_ankle_cross_92;
  const Scalar t_left_foot_57 = w[214];
  const Scalar qdd_10_6 = qdd_10_5 - t_left_foot_57 * t_left_ankle_cross_97;
  const Scalar t_left_foot_56 = w[212];
  const Scalar qdd_10_7 = qdd_10_6 + t_left_foot_56 * t_left_shank_114;
  const Scalar t_left_foot_53 = w[211];
  const Scalar qdd_10_8 = qdd_10_7 - t_left_foot_53 * t_left_ankle_cross_91;
  const Scalar t_left_ankle_cross_13 = w[217];
  const Scalar qdd_10 = t_left_ankle_cross_13 * qdd_10_8;
  qdd[10] = qdd_10;
  const Scalar neg_qdd_11_1 = t_left_shank_114 - qdd_10;
  // left_foot: qdd of (1)
  const Scalar neg_qdd_11_2 = t_left_ankle_cross_95 + left_hip_fork_l1 * t_left_ankle_cross_92;
  const Scalar neg_qdd_11_3 = t_left_ankle_cross_97 + left_hip_fork_l3 * t_left_ankle_cross_92;
  const Scalar zeta_left_foot_y = w[114];
  const Scalar c_left_foot = w[13];
  const Scalar neg_qdd_11_4 = zeta_left_foot_y + c_left_foot * neg_qdd_11_2;
  const Scalar t_left_foot_2 = w[116];
  const Scalar neg_qdd_11_5 = t_left_foot_2 + c_left_foot * t_left_ankle_cross_91;
  const Scalar t_left_foot_1 = w[115];
  const Scalar neg_qdd_11_6 = t_left_foot_1 + c_left_foot * neg_qdd_11_1;
  const Scalar s_left_foot = w[12];
  const Scalar neg_qdd_11_7 = neg_qdd_11_4 - s_left_foot * neg_qdd_11_3;
  const Scalar neg_qdd_11_8 = t_left_ankle_cross_92 + left_foot_p2 * neg_qdd_11_7;
  const Scalar u_left_foot = w[206];
  const Scalar neg_qdd_11_9 = neg_qdd_11_8 - left_foot_p1 * u_left_foot;
  const Scalar neg_qdd_11_10 = neg_qdd_11_5 - s_left_foot * neg_qdd_11_1;
  const Scalar neg_qdd_11_11 = neg_qdd_11_6 + s_left_foot * t_left_ankle_cross_91;
  qdd[11] = left_foot_k2 * neg_qdd_11_11 - (neg_qdd_11_9 - left_foot_k3 * neg_qdd_11_10);
  // right_hip_block: qdd of (1)
  const Scalar t_right_hip_block_143 = t_left_hip_block_196 - t_left_hip_block_197;
  const Scalar zeta_right_hip_block_y = w[123];
  const Scalar t_right_hip_block_144 =
      zeta_right_hip_block_y + c_right_hip_yaw * t_right_hip_block_143;
  const Scalar t_right_hip_block_145 =
      t_right_hip_block_144 + s_right_hip_yaw * t_left_hip_block_195;
  const Scalar zeta_right_hip_block_x = w[124];
  const Scalar t_right_hip_block_146 =
      zeta_right_hip_block_x + s_right_hip_yaw * t_right_hip_block_143;
  const Scalar t_right_hip_block_147 =
      t_right_hip_block_146 - c_right_hip_yaw * t_left_hip_block_195;
  const Scalar t_right_hip_block_5 = w[125];
  const Scalar t_right_hip_block_148 = t_right_hip_block_5 - t_base_py_7;
  const Scalar t_right_hip_block_149 = t_left_hip_block_203 - t_right_hip_block_148;
  const Scalar t_right_hip_block_10 = w[127];
  const Scalar t_right_hip_block_150 = t_right_hip_block_10 - s_right_hip_yaw * t_base_rx_29;
  const Scalar t_right_hip_block_151 = t_right_hip_block_150 - c_right_hip_yaw * t_base_rz_13;
  const Scalar t_right_hip_block_7 = w[126];
  const Scalar t_right_hip_block_152 = t_right_hip_block_7 - c_right_hip_yaw * t_base_rx_29;
  const Scalar t_right_hip_block_153 = t_right_hip_block_152 + s_right_hip_yaw * t_base_rz_13;
  const Scalar t_right_hip_fork_63 = w[159];
  const Scalar qdd_12_1 = t_right_hip_fork_63 * t_right_hip_block_147;
  const Scalar qdd_12_2 = left_hip_block_I15 * t_right_hip_block_153 + qdd_12_1;
  const Scalar t_right_hip_fork_79 = w[161];
  const Scalar qdd_12_3 = qdd_12_2 + t_right_hip_fork_79 * t_right_hip_block_151;
  const Scalar t_right_hip_fork_70 = w[160];
  const Scalar qdd_12_4 = qdd_12_3 + t_right_hip_fork_70 * t_base_ry_17;
  const Scalar t_right_hip_fork_83 = w[168];
  const Scalar qdd_12_5 = qdd_12_4 + t_right_hip_fork_83 * t_right_hip_block_145;
  const Scalar t_right_hip_fork_81 = w[167];
  const Scalar qdd_12_6 = qdd_12_5 - t_right_hip_fork_81 * t_right_hip_block_149;
  const Scalar t_right_hip_block_67 = w[197];
  const Scalar t_right_hip_block_17 = w[169];
  const Scalar qdd_12 = t_right_hip_block_67 + t_right_hip_block_17 * qdd_12_6;
  qdd[12] = qdd_12;
  const Scalar t_right_hip_block_154 = t_base_ry_17 - qdd_12;
  // right_hip_fork: qdd of (1)
  const Scalar t_right_hip_fork_7 = w[137];
  const Scalar c_right_hip_roll = w[17];
  const Scalar t_right_hip_fork_97 = t_right_hip_fork_7 + c_right_hip_roll * t_right_hip_block_154;
  const Scalar s_right_hip_roll = w[16];
  const Scalar t_right_hip_fork_98 = t_right_hip_fork_97 - s_right_hip_roll * t_right_hip_block_151;
  const Scalar t_right_hip_fork_6 = w[136];
  const Scalar t_right_hip_fork_99 = t_right_hip_fork_6 - s_right_hip_roll * t_right_hip_block_154;
  const Scalar t_right_hip_fork_100 =
      t_right_hip_fork_99 - c_right_hip_roll * t_right_hip_block_151;
  const Scalar t_right_hip_fork_101 = s_right_hip_roll * t_right_hip_block_147;
  const Scalar t_right_hip_fork_102 =
      t_right_hip_fork_101 - c_right_hip_roll * t_right_hip_block_149;
  const Scalar t_right_hip_fork_103 = c_right_hip_roll * t_right_hip_block_147;
  const Scalar t_right_hip_fork_104 =
      t_right_hip_fork_103 + s_right_hip_roll * t_right_hip_block_149;
  const Scalar u_right_hip_fork = w[154];
  const Scalar t_right_thigh_184 = w[153];
  const Scalar neg_qdd_13_1 = u_right_hip_fork + t_right_thigh_184 * t_right_hip_fork_104;
  const Scalar t_right_thigh_181 = w[150];
  const Scalar neg_qdd_13_2 = neg_qdd_13_1 + t_right_thigh_181 * t_right_hip_block_153;
  const Scalar t_right_thigh_182 = w[151];
  const Scalar neg_qdd_13_3 = neg_qdd_13_2 + t_right_thigh_182 * t_right_hip_fork_102;
  const Scalar t_right_thigh_183 = w[152];
  const Scalar neg_qdd_13_4 = neg_qdd_13_3 - t_right_thigh_183 * t_right_hip_block_145;
  const Scalar t_right_thigh_171 = w[21];
  const Scalar neg_qdd_13_5 = neg_qdd_13_4 - t_right_thigh_171 * t_right_hip_fork_98;
  const Scalar t_right_hip_fork_15 = w[156];
  const Scalar neg_qdd_13_6 = t_right_hip_fork_15 * t_right_hip_fork_100;
  const Scalar t_right_hip_fork_13 = w[155];
  const Scalar neg_qdd_13 = t_right_hip_fork_13 * neg_qdd_13_5 + neg_qdd_13_6;
  qdd[13] = -neg_qdd_13;
  const Scalar t_right_hip_fork_105 = t_right_hip_block_153 - neg_qdd_13;
  // right_thigh: qdd of (1)
  const Scalar t_right_thigh_5 = w[147];
  const Scalar c_q14_q15_q16 = w[19];
  const Scalar t_right_thigh_202 = t_right_thigh_5 - c_q14_q15_q16 * t_right_hip_fork_98;
  const Scalar s_q14_q15_q16 = w[18];
  const Scalar t_right_thigh_203 = t_right_thigh_202 + s_q14_q15_q16 * t_right_hip_fork_105;
  const Scalar t_right_thigh_7 = w[148];
  const Scalar t_right_thigh_204 = t_right_thigh_7 - s_q14_q15_q16 * t_right_hip_fork_98;
  const Scalar t_right_thigh_205 = t_right_thigh_204 - c_q14_q15_q16 * t_right_hip_fork_105;
  const Scalar t_right_thigh_206 = t_right_hip_fork_102 + left_hip_fork_l1 * t_right_hip_fork_100;
  const Scalar zeta_right_thigh_z = w[149];
  const Scalar t_right_thigh_207 = zeta_right_thigh_z + t_right_hip_fork_104;
  const Scalar t_right_thigh_208 = t_right_thigh_207 - left_hip_fork_l1 * t_right_hip_fork_98;
  const Scalar zeta_right_thigh_y = w[146];
  const Scalar t_right_thigh_209 = zeta_right_thigh_y - s_q14_q15_q16 * t_right_thigh_206;
  const Scalar t_right_thigh_210 = t_right_thigh_209 + c_q14_q15_q16 * t_right_hip_block_145;
  const Scalar u_right_thigh = w[238];
  const Scalar t_right_shank_89 = w[237];
  const Scalar qdd_14_1 = u_right_thigh - t_right_shank_89 * t_right_thigh_208;
  const Scalar t_right_shank_76 = w[235];
  const Scalar qdd_14_2 = qdd_14_1 - t_right_shank_76 * t_right_hip_fork_100;
  const Scalar zeta_right_thigh_x = w[145];
  const Scalar t_right_thigh_211 = zeta_right_thigh_x + c_q14_q15_q16 * t_right_thigh_206;
  const Scalar t_right_thigh_212 = t_right_thigh_211 + s_q14_q15_q16 * t_right_hip_block_145;
  const Scalar t_right_shank_86 = w[236];
  const Scalar qdd_14_3 = qdd_14_2 + t_right_shank_86 * t_right_thigh_203;
  const Scalar t_right_thigh_29 = w[241];
  const Scalar qdd_14_4 = t_right_thigh_29 * t_right_thigh_210;
  const Scalar t_right_thigh_27 = w[239];
  const Scalar qdd_14_5 = qdd_14_4 + t_right_thigh_27 * qdd_14_3;
  const Scalar t_right_thigh_36 = w[246];
  const Scalar qdd_14_6 = qdd_14_5 + t_right_thigh_36 * t_right_thigh_205;
  const Scalar t_right_thigh_28 = w[240];
  const Scalar qdd_14 = qdd_14_6 - t_right_thigh_28 * t_right_thigh_212;
  qdd[14] = qdd_14;
  const Scalar t_right_thigh_213 = t_right_hip_fork_100 + qdd_14;
  // right_shank: qdd of (1)
  const Scalar zeta_right_shank_x = w[162];
  const Scalar t_right_shank_96 = zeta_right_shank_x + t_right_thigh_212;
  const Scalar s_right_shank_y = w[30];
  const Scalar t_right_shank_97 = t_right_shank_96 - s_right_shank_y * t_right_thigh_213;
  const Scalar t_right_shank_4 = w[166];
  const Scalar t_right_shank_98 = t_right_shank_4 + t_right_thigh_205;
  const Scalar neg_zeta_right_shank_z = w[164];
  const Scalar t_right_shank_99 = neg_zeta_right_shank_z - t_right_thigh_208;
  const Scalar t_right_shank_100 = t_right_shank_99 + s_right_shank_y * t_right_thigh_203;
  const Scalar neg_s_right_shank_x = w[31];
  const Scalar t_right_shank_101 = t_right_shank_100 - neg_s_right_shank_x * t_right_thigh_205;
  const Scalar t_right_shank_3 = w[165];
  const Scalar t_right_shank_102 = t_right_shank_3 + t_right_thigh_203;
  const Scalar neg_zeta_right_shank_y = w[163];
  const Scalar t_right_shank_103 = neg_zeta_right_shank_y - t_right_thigh_210;
  const Scalar t_right_shank_104 = t_right_shank_103 + neg_s_right_shank_x * t_right_thigh_213;
  const Scalar u_right_shank = w[233];
  const Scalar t_righ_ankl_cros_60 = w[22];
  const Scalar qdd_15_1 = u_right_shank + t_righ_ankl_cros_60 * t_right_shank_102;
  const Scalar t_righ_ankl_cros_69 = w[138];
  const Scalar qdd_15_2 = qdd_15_1 + t_righ_ankl_cros_69 * t_right_shank_101;
  const Scalar t_righ_ankl_cros_55 = w[20];
  const Scalar qdd_15_3 = qdd_15_2 - t_righ_ankl_cros_55 * t_right_shank_98;
  const Scalar t_righ_ankl_cros_67 = w[131];
  const Scalar qdd_15_4 = qdd_15_3 - t_righ_ankl_cros_67 * t_right_shank_97;
  const Scalar t_righ_ankl_cros_68 = w[133];
  const Scalar qdd_15_5 = qdd_15_4 - t_righ_ankl_cros_68 * t_right_shank_104;
  const Scalar t_righ_ankl_cros_66 = w[23];
  const Scalar qdd_15_6 = qdd_15_5 - t_righ_ankl_cros_66 * t_right_thigh_213;
  const Scalar t_right_shank_23 = w[234];
  const Scalar qdd_15 = t_right_shank_23 * qdd_15_6;
  qdd[15] = qdd_15;
  const Scalar t_right_shank_105 = t_right_thigh_213 + qdd_15;
  // right_ankle_cross: qdd of (1)
  const Scalar zeta_righ_ankl_cros_x = w[179];
  const Scalar t_righ_ankl_cros_92 = zeta_righ_ankl_cros_x + t_right_shank_97;
  const Scalar s_righ_ankl_cros_y = w[32];
  const Scalar t_righ_ankl_cros_93 = t_righ_ankl_cros_92 - s_righ_ankl_cros_y * t_right_shank_105;
  const Scalar t_righ_ankl_cros_6 = w[182];
  const Scalar t_righ_ankl_cros_94 = t_righ_ankl_cros_6 + t_right_shank_102;
  const Scalar t_righ_ankl_cros_7 = w[183];
  const Scalar t_righ_ankl_cros_95 = t_righ_ankl_cros_7 + t_right_shank_98;
  const Scalar t_righ_ankl_cros_5 = w[181];
  const Scalar t_righ_ankl_cros_96 = t_righ_ankl_cros_5 + t_right_shank_101;
  const Scalar neg_s_righ_ankl_cros_x = w[33];
  const Scalar t_righ_ankl_cros_97 =
      t_righ_ankl_cros_96 - neg_s_righ_ankl_cros_x * t_right_shank_98;
  const Scalar t_righ_ankl_cros_98 = t_righ_ankl_cros_97 + s_righ_ankl_cros_y * t_right_shank_102;
  const Scalar t_right_thigh_71 = w[257];
  const Scalar t_right_foot_60 = w[202];
  const Scalar qdd_16_1 = t_right_thigh_71 - t_right_foot_60 * t_right_shank_105;
  const Scalar qdd_16_2 = t_right_shank_104 + neg_s_righ_ankl_cros_x * t_right_shank_105;
  const Scalar t_right_foot_63 = w[203];
  const Scalar qdd_16_3 = qdd_16_1 - t_right_foot_63 * t_righ_ankl_cros_94;
  const Scalar t_right_foot_65 = w[204];
  const Scalar qdd_16_4 = qdd_16_3 + t_right_foot_65 * qdd_16_2;
  const Scalar t_right_foot_56 = w[200];
  const Scalar qdd_16_5 = qdd_16_4 - t_right_foot_56 * t_righ_ankl_cros_95;
  const Scalar t_righ_ankl_cros_20 = w[213];
  const Scalar qdd_16_6 = t_righ_ankl_cros_20 * t_righ_ankl_cros_98;
  const Scalar t_righ_ankl_cros_14 = w[207];
  const Scalar qdd_16_7 = qdd_16_6 + t_righ_ankl_cros_14 * qdd_16_5;
  const Scalar t_righ_ankl_cros_15 = w[208];
  const Scalar qdd_16 = qdd_16_7 - t_righ_ankl_cros_15 * t_righ_ankl_cros_93;
  qdd[16] = qdd_16;
  const Scalar qdd_17_1 = t_right_shank_105 + qdd_16;
  // right_foot: qdd of (1)
  const Scalar qdd_17_2 = t_righ_ankl_cros_98 + left_hip_fork_l1 * t_righ_ankl_cros_95;
  const Scalar qdd_17_3 = t_righ_ankl_cros_93 + left_hip_fork_l3 * t_righ_ankl_cros_95;
  const Scalar neg_zeta_right_foot_y = w[188];
  const Scalar c_right_foot = w[25];
  const Scalar qdd_17_4 = neg_zeta_right_foot_y + c_right_foot * qdd_17_2;
  const Scalar t_right_foot_8 = w[190];
  const Scalar qdd_17_5 = t_right_foot_8 - c_right_foot * t_righ_ankl_cros_94;
  const Scalar t_right_foot_7 = w[189];
  const Scalar s_right_foot = w[24];
  const Scalar qdd_17_6 = t_right_foot_7 - s_right_foot * t_righ_ankl_cros_94;
  const Scalar u_right_foot = w[191];
  const Scalar qdd_17_7 = t_righ_ankl_cros_95 + left_foot_p1 * u_right_foot;
  const Scalar qdd_17_8 = qdd_17_5 - s_right_foot * qdd_17_1;
  const Scalar qdd_17_9 = qdd_17_7 + left_foot_k3 * qdd_17_8;
  const Scalar qdd_17_10 = qdd_17_4 - s_right_foot * qdd_17_3;
  const Scalar qdd_17_11 = qdd_17_9 + left_foot_p2 * qdd_17_10;
  qdd[17] = qdd_17_11 + left_foot_k2 * (qdd_17_6 + c_right_foot * qdd_17_1);
  const Scalar omega_base_ry_y = w[37];
  const Scalar t_base_ry_18 = qd[4] * omega_base_ry_y;
  // base_rx: qdd of (1)
  const Scalar t_base_rx_30 = c_base_rx * t_base_py_7 - s_base_rx * t_base_px_10;
  const Scalar t_base_rx_31 = c_base_ry * t_base_pz_13 + s_base_ry * t_base_rx_30;
  const Scalar t_base_rx_32 = s_base_rx * t_base_py_7 + c_base_rx * t_base_px_10;
  const Scalar s_base_rz = w[0];
  const Scalar c_base_rz = w[1];
  qdd[0] = s_base_rz * t_base_rx_32 + c_base_rz * t_base_rx_31;
  qdd[1] = s_base_rz * t_base_rx_31 - c_base_rz * t_base_rx_32;
  qdd[2] = base_g1 - s_base_ry * t_base_pz_13 + c_base_ry * t_base_rx_30;
  const Scalar neg_omega_base_rx_x = w[36];
  const Scalar t_base_rx_33 = t_base_ry_17 - neg_omega_base_rx_x * qd[5];
  const Scalar t_base_rx_34 = t_base_rx_33 - c_base_rx * t_base_ry_18;
  const Scalar t_base_rx_35 = t_base_rz_13 + s_base_rx * t_base_ry_18;
  const Scalar neg_omega_base_rx_y = w[35];
  const Scalar t_base_rx_36 = t_base_rx_35 - neg_omega_base_rx_y * qd[5];
  qdd[4] = s_base_rx * t_base_rx_34 + c_base_rx * t_base_rx_36;
  const Scalar neg_qdd_3_1 = c_base_rx * t_base_rx_34 - s_base_rx * t_base_rx_36;
  const Scalar t_base_rx_4 = w[41];
  const Scalar neg_qdd_3 = t_base_rx_4 * neg_qdd_3_1;
  qdd[3] = -neg_qdd_3;
  const Scalar neg_omega_base_ry_x = w[34];
  qdd[5] = -(t_base_rx_29 - neg_omega_base_ry_x * qd[4] + s_base_ry * neg_qdd_3);
}

}  // namespace

void forward_dynamics(const Scalar q[18], const Scalar qd[18], const Scalar tau[18],
                      Scalar qdd[18]) noexcept {
  Scalar w[266];
  forward_dynamics_1(q, qd, tau, w);
  forward_dynamics_2(qd, tau, w);
  forward_dynamics_3(tau, w);
  forward_dynamics_4(tau, w);
  forward_dynamics_5(tau, w);
  forward_dynamics_6(tau, w);
  forward_dynamics_7(qd, tau, qdd, w);
}

void point_positions(const Scalar q[18], Scalar p[12]) noexcept {
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const Scalar q_q14_q15 = q[14] + q[15];
  const Scalar q_q14_q15_q16 = q_q14_q15 + q[16];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[3], q[4], q[5], q[6]);
  sines_cosines(sines + 4, cosines + 4, q[7], q[8], q_q8_q9_q10, q_q8_q9);
  sines_cosines(sines + 8, cosines + 8, q[11], q[12], q[13], q[14]);
  sines_cosines(sines + 12, cosines + 12, q_q14_q15_q16, q_q14_q15, q[17]);
  const Scalar s_base_rz = sines[0];
  const Scalar c_base_rz = cosines[0];
  const Scalar s_base_ry = sines[1];
  const Scalar c_base_ry = cosines[1];
  const Scalar s_base_rx = sines[2];
  const Scalar c_base_rx = cosines[2];
  const Scalar s_left_hip_yaw = sines[3];
  const Scalar c_left_hip_yaw = cosines[3];
  const Scalar s_left_hip_roll = sines[4];
  const Scalar c_left_hip_roll = cosines[4];
  const Scalar s_left_hip_pitch = sines[5];
  const Scalar c_left_hip_pitch = cosines[5];
  const Scalar s_q8_q9_q10 = sines[6];
  const Scalar c_q8_q9_q10 = cosines[6];
  const Scalar s_q8_q9 = sines[7];
  const Scalar c_q8_q9 = cosines[7];
  const Scalar s_left_ankle_roll = sines[8];
  const Scalar c_left_ankle_roll = cosines[8];
  const Scalar s_right_hip_yaw = sines[9];
  const Scalar c_right_hip_yaw = cosines[9];
  const Scalar s_right_hip_roll = sines[10];
  const Scalar c_right_hip_roll = cosines[10];
  const Scalar s_right_hip_pitch = sines[11];
  const Scalar c_right_hip_pitch = cosines[11];
  const Scalar s_q14_q15_q16 = sines[12];
  const Scalar c_q14_q15_q16 = cosines[12];
  const Scalar s_q14_q15 = sines[13];
  const Scalar c_q14_q15 = cosines[13];
  const Scalar s_right_ankle_roll = sines[14];
  const Scalar c_right_ankle_roll = cosines[14];
  const Scalar t_left_thigh_1 = left_hip_fork_l3 + left_foot_l2 * s_left_ankle_roll;
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * t_left_thigh_1;
  const Scalar t_left_foot_1 = left_hip_fork_l1 - left_foot_l2 * c_left_ankle_roll;
  // left_hip_fork
  const Scalar t_left_hip_fork_2 = left_hip_fork_l1 + left_shank_l1 * s_left_hip_pitch;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 + left_ankle_cross_l1 * s_q8_q9;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 - s_q8_q9_q10 * t_left_foot_1;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_4 + left_foot_l3 * c_q8_q9_q10;
  // left_shank
  const Scalar t_left_shank_1 = left_shank_l1 * c_left_hip_pitch + left_ankle_cross_l1 * c_q8_q9;
  const Scalar t_left_shank_2 = t_left_shank_1 - c_q8_q9_q10 * t_left_foot_1;
  const Scalar t_left_shank_3 = t_left_shank_2 - left_foot_l3 * s_q8_q9_q10;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_1 + s_left_hip_roll * t_left_shank_3;
  // left_hip_block
  const Scalar t_left_hip_block_1 = left_hip_block_l1 + s_left_hip_yaw * t_left_hip_fork_5;
  const Scalar t_left_hip_block_2 = t_left_hip_block_1 - c_left_hip_yaw * t_left_hip_fork_6;
  const Scalar t_left_hip_block_3 = left_hip_block_l2 - s_left_hip_roll * t_left_thigh_1;
  const Scalar t_left_hip_block_4 = t_left_hip_block_3 + c_left_hip_roll * t_left_shank_3;
  const Scalar t_base_rx_1 = s_base_rx * t_left_hip_block_2 + c_base_rx * t_left_hip_block_4;
  const Scalar t_left_hip_block_5 = c_left_hip_yaw * t_left_hip_fork_5;
  const Scalar t_left_hip_block_6 = t_left_hip_block_5 + s_left_hip_yaw * t_left_hip_fork_6;
  p[2] = q[2] + c_base_ry * t_base_rx_1 - s_base_ry * t_left_hip_block_6;
  const Scalar t_base_ry_1 = c_base_ry * t_left_hip_block_6 + s_base_ry * t_base_rx_1;
  const Scalar t_base_rx_2 = s_base_rx * t_left_hip_block_4 - c_base_rx * t_left_hip_block_2;
  p[1] = q[1] + s_base_rz * t_base_ry_1 - c_base_rz * t_base_rx_2;
  p[0] = q[0] + s_base_rz * t_base_rx_2 + c_base_rz * t_base_ry_1;
  const Scalar t_left_shank_4 = t_left_shank_2 - left_foot_l1 * s_q8_q9_q10;
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_1 + s_left_hip_roll * t_left_shank_4;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_4 + left_foot_l1 * c_q8_q9_q10;
  const Scalar t_left_hip_block_7 = s_left_hip_yaw * t_left_hip_fork_7;
  const Scalar t_left_hip_block_8 = t_left_hip_block_7 + c_left_hip_yaw * t_left_hip_fork_8;
  const Scalar t_left_hip_block_9 = left_hip_block_l1 - c_left_hip_yaw * t_left_hip_fork_7;
  const Scalar t_left_hip_block_10 = t_left_hip_block_9 + s_left_hip_yaw * t_left_hip_fork_8;
  const Scalar t_left_hip_block_11 = t_left_hip_block_3 + c_left_hip_roll * t_left_shank_4;
  const Scalar t_base_rx_3 = s_base_rx * t_left_hip_block_10 + c_base_rx * t_left_hip_block_11;
  p[5] = q[2] - s_base_ry * t_left_hip_block_8 + c_base_ry * t_base_rx_3;
  const Scalar t_base_ry_2 = c_base_ry * t_left_hip_block_8 + s_base_ry * t_base_rx_3;
  const Scalar t_base_rx_4 = s_base_rx * t_left_hip_block_11 - c_base_rx * t_left_hip_block_10;
  p[4] = q[1] + s_base_rz * t_base_ry_2 - c_base_rz * t_base_rx_4;
  p[3] = q[0] + s_base_rz * t_base_rx_4 + c_base_rz * t_base_ry_2;
  const Scalar t_right_thigh_1 = left_hip_fork_l3 - left_foot_l2 * s_right_ankle_roll;
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * t_right_thigh_1;
  const Scalar t_right_foot_1 = left_hip_fork_l1 - left_foot_l2 * c_right_ankle_roll;
  // right_shank: way s to the joint of 1.2
  const Scalar s_right_shank_x = left_shank_l1 * c_right_hip_pitch;
  const Scalar t_right_shank_1 = s_right_shank_x + left_ankle_cross_l1 * c_q14_q15;
  const Scalar t_right_shank_2 = t_right_shank_1 - c_q14_q15_q16 * t_right_foot_1;
  const Scalar t_right_shank_3 = t_right_shank_2 - left_foot_l3 * s_q14_q15_q16;
  // right_hip_fork
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 - s_right_hip_roll * t_right_shank_3;
  const Scalar t_right_hip_fork_3 = left_hip_fork_l1 + left_shank_l1 * s_right_hip_pitch;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_3 + left_ankle_cross_l1 * s_q14_q15;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_4 - s_q14_q15_q16 * t_right_foot_1;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_5 + left_foot_l3 * c_q14_q15_q16;
  // right_hip_block
  const Scalar t_right_hip_block_1 = s_right_hip_yaw * t_right_hip_fork_2;
  const Scalar t_right_hip_block_2 = t_right_hip_block_1 - c_right_hip_yaw * t_right_hip_fork_6;
  const Scalar t_right_hip_block_3 = left_hip_block_l2 + s_right_hip_roll * t_right_thigh_1;
  const Scalar t_right_hip_block_4 = t_right_hip_block_3 + c_right_hip_roll * t_right_shank_3;
  const Scalar t_right_hip_block_5 = left_hip_block_l1 - s_right_hip_yaw * t_right_hip_fork_6;
  const Scalar t_right_hip_block_6 = t_right_hip_block_5 - c_right_hip_yaw * t_right_hip_fork_2;
  const Scalar t_base_rx_5 = c_base_rx * t_right_hip_block_4;
  const Scalar t_base_rx_6 = t_base_rx_5 - s_base_rx * t_right_hip_block_6;
  p[8] = q[2] + s_base_ry * t_right_hip_block_2 + c_base_ry * t_base_rx_6;
  const Scalar t_base_ry_3 = c_base_ry * t_right_hip_block_2 - s_base_ry * t_base_rx_6;
  const Scalar t_base_rx_7 = s_base_rx * t_right_hip_block_4;
  const Scalar t_base_rx_8 = t_base_rx_7 + c_base_rx * t_right_hip_block_6;
  p[7] = q[1] - s_base_rz * t_base_ry_3 - c_base_rz * t_base_rx_8;
  p[6] = q[0] + s_base_rz * t_base_rx_8 - c_base_rz * t_base_ry_3;
  const Scalar t_right_shank_4 = t_right_shank_2 - left_foot_l1 * s_q14_q15_q16;
  const Scalar t_right_hip_block_7 = t_right_hip_block_3 + c_right_hip_roll * t_right_shank_4;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_5 + left_foot_l1 * c_q14_q15_q16;
  const Scalar t_right_hip_fork_8 = t_right_hip_fork_1 - s_right_hip_roll * t_right_shank_4;
  const Scalar t_right_hip_block_8 = left_hip_block_l1 - s_right_hip_yaw * t_right_hip_fork_7;
  const Scalar t_right_hip_block_9 = t_right_hip_block_8 - c_right_hip_yaw * t_right_hip_fork_8;
  const Scalar t_base_rx_9 = c_base_rx * t_right_hip_block_7;
  const Scalar t_base_rx_10 = t_base_rx_9 - s_base_rx * t_right_hip_block_9;
  const Scalar t_right_hip_block_10 = c_right_hip_yaw * t_right_hip_fork_7;
  const Scalar t_right_hip_block_11 = t_right_hip_block_10 - s_right_hip_yaw * t_right_hip_fork_8;
  p[11] = q[2] + c_base_ry * t_base_rx_10 - s_base_ry * t_right_hip_block_11;
  const Scalar t_base_rx_11 = s_base_rx * t_right_hip_block_7;
  const Scalar t_base_rx_12 = t_base_rx_11 + c_base_rx * t_right_hip_block_9;
  const Scalar t_base_ry_4 = s_base_ry * t_base_rx_10 + c_base_ry * t_right_hip_block_11;
  p[10] = q[1] - c_base_rz * t_base_rx_12 + s_base_rz * t_base_ry_4;
  // base_px: p of 1.2
  p[9] = q[0] + s_base_rz * t_base_rx_12 + c_base_rz * t_base_ry_4;
}

void force_jacobian_transpose(const Scalar q[18], Scalar C[216]) noexcept {
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const Scalar q_q15_q16 = q[15] + q[16];
  const Scalar q_q14_q15_q16 = q[14] + q_q15_q16;
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[3], q[5], q[4], q[6]);
  sines_cosines(sines + 4, cosines + 4, q[7], q_q8_q9_q10, q_q9_q10, q[10]);
  sines_cosines(sines + 8, cosines + 8, q[12], q[13], q_q14_q15_q16, q_q15_q16);
  sines_cosines(sines + 12, cosines + 12, q[16], q[11], q[17]);
  const Scalar s_base_rz = sines[0];
  const Scalar c_base_rz = cosines[0];
  const Scalar s_base_rx = sines[1];
  const Scalar c_base_rx = cosines[1];
  const Scalar s_base_ry = sines[2];
  const Scalar c_base_ry = cosines[2];
  const Scalar s_left_hip_yaw = sines[3];
  const Scalar c_left_hip_yaw = cosines[3];
  const Scalar s_left_hip_roll = sines[4];
  const Scalar c_left_hip_roll = cosines[4];
  const Scalar s_q8_q9_q10 = sines[5];
  const Scalar c_q8_q9_q10 = cosines[5];
  const Scalar s_q9_q10 = sines[6];
  const Scalar c_q9_q10 = cosines[6];
  const Scalar s_left_ankle_pitch = sines[7];
  const Scalar c_left_ankle_pitch = cosines[7];
  const Scalar s_right_hip_yaw = sines[8];
  const Scalar c_right_hip_yaw = cosines[8];
  const Scalar s_right_hip_roll = sines[9];
  const Scalar c_right_hip_roll = cosines[9];
  const Scalar s_q14_q15_q16 = sines[10];
  const Scalar c_q14_q15_q16 = cosines[10];
  const Scalar s_q15_q16 = sines[11];
  const Scalar c_q15_q16 = cosines[11];
  const Scalar s_right_ankle_pitch = sines[12];
  const Scalar c_right_ankle_pitch = cosines[12];
  const Scalar s_left_ankle_roll = sines[13];
  const Scalar c_left_ankle_roll = cosines[13];
  const Scalar s_right_ankle_roll = sines[14];
  const Scalar c_right_ankle_roll = cosines[14];
  const Scalar neg_s_left_shank_y = left_shank_l1 * s_q9_q10;
  const Scalar neg_s_left_ankle_cross_y = left_ankle_cross_l1 * s_left_ankle_pitch;
  const Scalar neg_s_right_shank_y = left_shank_l1 * s_q15_q16;
  const Scalar neg_s_righ_ankl_cros_y = left_ankle_cross_l1 * s_right_ankle_pitch;
  // base_rx: Rx, Ry, Rz of (9)
  const Scalar t_base_rx_1 = c_base_rz * c_base_rx;
  const Scalar t_base_rx_2 = s_base_rz * s_base_rx;
  const Scalar Rx_base_rx_y = t_base_rx_2 + s_base_ry * t_base_rx_1;
  const Scalar t_base_rx_3 = c_base_rz * s_base_rx;
  const Scalar t_base_rx_4 = s_base_rz * c_base_rx;
  const Scalar neg_Rx_base_rx_x = t_base_rx_4 - s_base_ry * t_base_rx_3;
  const Scalar neg_Ry_base_rx_y = t_base_rx_3 - s_base_ry * t_base_rx_4;
  const Scalar Ry_base_rx_x = t_base_rx_1 + s_base_ry * t_base_rx_2;
  const Scalar Ry_base_rx_z = s_base_rz * c_base_ry;
  const Scalar Rz_base_rx_x = c_base_ry * s_base_rx;
  const Scalar Rz_base_rx_y = c_base_rx * c_base_ry;
  const Scalar Rx_base_rx_z = c_base_rz * c_base_ry;
  // left_hip_block: Rx, Ry, Rz of (9)
  const Scalar t_left_hip_block_1 = c_left_hip_yaw * neg_Rx_base_rx_x;
  const Scalar neg_Rx_left_hip_block_y = s_left_hip_yaw * Rx_base_rx_z + t_left_hip_block_1;
  const Scalar Rx_left_hip_block_x_1 = s_left_hip_yaw * neg_Rx_base_rx_x;
  const Scalar Rx_left_hip_block_x = c_left_hip_yaw * Rx_base_rx_z - Rx_left_hip_block_x_1;
  const Scalar t_left_hip_block_2 = s_left_hip_yaw * Ry_base_rx_z;
  const Scalar neg_Ry_left_hip_block_y = t_left_hip_block_2 - c_left_hip_yaw * Ry_base_rx_x;
  const Scalar Ry_left_hip_block_x = c_left_hip_yaw * Ry_base_rx_z + s_left_hip_yaw * Ry_base_rx_x;
  const Scalar Rz_left_hip_block_x = s_left_hip_yaw * Rz_base_rx_x - s_base_ry * c_left_hip_yaw;
  const Scalar Rz_left_hip_block_y = c_left_hip_yaw * Rz_base_rx_x + s_base_ry * s_left_hip_yaw;
  // left_hip_fork: Rx, Ry, Rz of (9)
  const Scalar Rx_left_hip_fork_y_1 = s_left_hip_roll * neg_Rx_left_hip_block_y;
  const Scalar Rx_left_hip_fork_y = Rx_left_hip_fork_y_1 + c_left_hip_roll * Rx_base_rx_y;
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * neg_Rx_left_hip_block_y;
  const Scalar neg_Rx_left_hip_fork_x = t_left_hip_fork_1 - s_left_hip_roll * Rx_base_rx_y;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * neg_Ry_left_hip_block_y;
  const Scalar neg_Ry_left_hip_fork_x = t_left_hip_fork_2 + s_left_hip_roll * neg_Ry_base_rx_y;
  const Scalar Ry_left_hip_fork_y_1 = s_left_hip_roll * neg_Ry_left_hip_block_y;
  const Scalar Ry_left_hip_fork_y = Ry_left_hip_fork_y_1 - c_left_hip_roll * neg_Ry_base_rx_y;
  const Scalar Rz_left_hip_fork_y_1 = s_left_hip_roll * Rz_left_hip_block_y;
  const Scalar Rz_left_hip_fork_y = c_left_hip_roll * Rz_base_rx_y - Rz_left_hip_fork_y_1;
  const Scalar Rz_left_hip_fork_x_1 = c_left_hip_roll * Rz_left_hip_block_y;
  const Scalar Rz_left_hip_fork_x = s_left_hip_roll * Rz_base_rx_y + Rz_left_hip_fork_x_1;
  // left_thigh: Rx, Ry, Rz of (9)
  const Scalar Rx_left_thigh_x_1 = s_q8_q9_q10 * Rx_left_hip_block_x;
  const Scalar Rx_left_thigh_x = Rx_left_thigh_x_1 + c_q8_q9_q10 * Rx_left_hip_fork_y;
  const Scalar neg_Rx_left_thigh_y_1 = c_q8_q9_q10 * Rx_left_hip_block_x;
  const Scalar neg_Rx_left_thigh_y = s_q8_q9_q10 * Rx_left_hip_fork_y - neg_Rx_left_thigh_y_1;
  const Scalar Ry_left_thigh_x_1 = s_q8_q9_q10 * Ry_left_hip_block_x;
  const Scalar Ry_left_thigh_x = Ry_left_thigh_x_1 + c_q8_q9_q10 * Ry_left_hip_fork_y;
  const Scalar Ry_left_thigh_y_1 = c_q8_q9_q10 * Ry_left_hip_block_x;
  const Scalar Ry_left_thigh_y = Ry_left_thigh_y_1 - s_q8_q9_q10 * Ry_left_hip_fork_y;
  const Scalar neg_Rz_left_thigh_y_1 = c_q8_q9_q10 * Rz_left_hip_block_x;
  const Scalar neg_Rz_left_thigh_y = s_q8_q9_q10 * Rz_left_hip_fork_y - neg_Rz_left_thigh_y_1;
  const Scalar Rz_left_thigh_x_1 = s_q8_q9_q10 * Rz_left_hip_block_x;
  const Scalar Rz_left_thigh_x = Rz_left_thigh_x_1 + c_q8_q9_q10 * Rz_left_hip_fork_y;
  // right_hip_block: Rx, Ry, Rz of (9)
  const Scalar Rx_right_hip_block_x_1 = s_right_hip_yaw * neg_Rx_base_rx_x;
  const Scalar Rx_right_hip_block_x = c_right_hip_yaw * Rx_base_rx_z - Rx_right_hip_block_x_1;
  const Scalar t_right_hip_block_1 = c_right_hip_yaw * neg_Rx_base_rx_x;
  const Scalar neg_Rx_right_hip_block_y = s_right_hip_yaw * Rx_base_rx_z + t_right_hip_block_1;
  const Scalar t_right_hip_block_2 = s_right_hip_yaw * Ry_base_rx_z;
  const Scalar neg_Ry_right_hip_block_y = t_right_hip_block_2 - c_right_hip_yaw * Ry_base_rx_x;
  const Scalar Ry_right_hip_block_x_1 = c_right_hip_yaw * Ry_base_rx_z;
  const Scalar Ry_right_hip_block_x = Ry_right_hip_block_x_1 + s_right_hip_yaw * Ry_base_rx_x;
  const Scalar Rz_right_hip_block_y = c_right_hip_yaw * Rz_base_rx_x + s_base_ry * s_right_hip_yaw;
  const Scalar Rz_right_hip_block_x = s_right_hip_yaw * Rz_base_rx_x - s_base_ry * c_right_hip_yaw;
  // right_hip_fork: Rx, Ry, Rz of (9)
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * neg_Rx_right_hip_block_y;
  const Scalar neg_Rx_right_hip_fork_x = t_right_hip_fork_1 - s_right_hip_roll * Rx_base_rx_y;
  const Scalar Rx_right_hip_fork_y_1 = s_right_hip_roll * neg_Rx_right_hip_block_y;
  const Scalar Rx_right_hip_fork_y = Rx_right_hip_fork_y_1 + c_right_hip_roll * Rx_base_rx_y;
  const Scalar Ry_right_hip_fork_y_1 = s_right_hip_roll * neg_Ry_right_hip_block_y;
  const Scalar Ry_right_hip_fork_y = Ry_right_hip_fork_y_1 - c_right_hip_roll * neg_Ry_base_rx_y;
  const Scalar t_right_hip_fork_2 = c_right_hip_roll * neg_Ry_right_hip_block_y;
  const Scalar neg_Ry_right_hip_fork_x = t_right_hip_fork_2 + s_right_hip_roll * neg_Ry_base_rx_y;
  const Scalar Rz_right_hip_fork_x_1 = c_right_hip_roll * Rz_right_hip_block_y;
  const Scalar Rz_right_hip_fork_x = s_right_hip_roll * Rz_base_rx_y + Rz_right_hip_fork_x_1;
  const Scalar Rz_right_hip_fork_y_1 = s_right_hip_roll * Rz_right_hip_block_y;
  const Scalar Rz_right_hip_fork_y = c_right_hip_roll * Rz_base_rx_y - Rz_right_hip_fork_y_1;
  // right_thigh: Rx, Ry, Rz of (9)
  const Scalar Rx_right_thigh_x_1 = s_q14_q15_q16 * Rx_right_hip_block_x;
  const Scalar Rx_right_thigh_x = c_q14_q15_q16 * Rx_right_hip_fork_y + Rx_right_thigh_x_1;
  const Scalar Rx_right_thigh_y_1 = c_q14_q15_q16 * Rx_right_hip_block_x;
  const Scalar Rx_right_thigh_y = Rx_right_thigh_y_1 - s_q14_q15_q16 * Rx_right_hip_fork_y;
  const Scalar Ry_right_thigh_y_1 = c_q14_q15_q16 * Ry_right_hip_block_x;
  const Scalar Ry_right_thigh_y = Ry_right_thigh_y_1 - s_q14_q15_q16 * Ry_right_hip_fork_y;
  const Scalar Ry_right_thigh_x_1 = s_q14_q15_q16 * Ry_right_hip_block_x;
  const Scalar Ry_right_thigh_x = Ry_right_thigh_x_1 + c_q14_q15_q16 * Ry_right_hip_fork_y;
  const Scalar Rz_right_thigh_x_1 = s_q14_q15_q16 * Rz_right_hip_block_x;
  const Scalar Rz_right_thigh_x = Rz_right_thigh_x_1 + c_q14_q15_q16 * Rz_right_hip_fork_y;
  const Scalar neg_Rz_right_thigh_y_1 = c_q14_q15_q16 * Rz_right_hip_block_x;
  const Scalar neg_Rz_right_thigh_y = s_q14_q15_q16 * Rz_right_hip_fork_y - neg_Rz_right_thigh_y_1;
  // base_px: r of (9)
  const Scalar neg_r_left_foot_y = left_foot_l2 * s_left_ankle_roll;
  const Scalar neg_r_left_foot_x = left_foot_l2 * c_left_ankle_roll;
  const Scalar neg_r_right_foot_y = left_foot_l2 * s_right_ankle_roll;
  const Scalar neg_r_right_foot_x = left_foot_l2 * c_right_ankle_roll;
  const Scalar neg_r_left_ankle_cross_x = left_hip_fork_l1 - neg_r_left_foot_x;
  const Scalar neg_r_left_shank_x =
      neg_r_left_ankle_cross_x - left_ankle_cross_l1 * c_left_ankle_pitch;
  // left_shank: r of (9)
  const Scalar r_left_shank_y = left_foot_l3 - neg_s_left_ankle_cross_y;
  const Scalar neg_r_left_thigh_x = neg_r_left_shank_x - left_shank_l1 * c_q9_q10;
  const Scalar neg_r_left_thigh_y = neg_s_left_shank_y - r_left_shank_y;
  // left_thigh: r of (9)
  const Scalar t_left_thigh_1 = c_q8_q9_q10 * neg_r_left_thigh_x;
  const Scalar neg_r_left_hip_fork_y = t_left_thigh_1 - s_q8_q9_q10 * neg_r_left_thigh_y;
  const Scalar neg_r_left_hip_fork_x = left_hip_fork_l3 + neg_r_left_foot_y;
  const Scalar t_left_hip_fork_3 = c_left_hip_roll * neg_r_left_hip_fork_x;
  const Scalar neg_r_left_hip_block_y = t_left_hip_fork_3 - s_left_hip_roll * neg_r_left_hip_fork_y;
  const Scalar t_left_hip_block_3 = left_hip_fork_l1 - s_q8_q9_q10 * neg_r_left_thigh_x;
  const Scalar r_left_hip_block_x = t_left_hip_block_3 - c_q8_q9_q10 * neg_r_left_thigh_y;
  const Scalar r_base_rx_x_1 = left_hip_block_l1 - c_left_hip_yaw * neg_r_left_hip_block_y;
  const Scalar r_base_rx_x = r_base_rx_x_1 + s_left_hip_yaw * r_left_hip_block_x;
  const Scalar r_base_rx_z_1 = s_left_hip_yaw * neg_r_left_hip_block_y;
  // base_rx: r of (9)
  const Scalar r_base_rx_z = c_left_hip_yaw * r_left_hip_block_x + r_base_rx_z_1;
  const Scalar t_base_rx_5 = left_hip_block_l2 - s_left_hip_roll * neg_r_left_hip_fork_x;
  const Scalar r_base_rx_y = t_base_rx_5 - c_left_hip_roll * neg_r_left_hip_fork_y;
  const Scalar t_base_rx_6 = s_base_rx * r_base_rx_x + c_base_rx * r_base_rx_y;
  const Scalar r_base_rz_x = s_base_ry * t_base_rx_6 + c_base_ry * r_base_rx_z;
  C[50] = -r_base_rz_x;
  const Scalar r_base_ry_z = c_base_rx * r_base_rx_x - s_base_rx * r_base_rx_y;
  C[36] = -(c_base_rz * r_base_ry_z + s_base_rz * r_base_rz_x);
  C[37] = c_base_rz * r_base_rz_x - s_base_rz * r_base_ry_z;
  const Scalar neg_r_base_ry_y = s_base_ry * r_base_rx_z - c_base_ry * t_base_rx_6;
  // base_px: C of (9)
  C[48] = -c_base_rz * neg_r_base_ry_y;
  C[49] = -s_base_rz * neg_r_base_ry_y;
  C[61] = -(Ry_base_rx_x * r_base_rx_y + neg_Ry_base_rx_y * r_base_rx_x);
  C[62] = c_base_ry * r_base_ry_z;
  C[60] = Rx_base_rx_y * r_base_rx_x + neg_Rx_base_rx_x * r_base_rx_y;
  const Scalar t_base_px_1 = Ry_left_thigh_y * neg_r_left_ankle_cross_x;
  C[121] = -(t_base_px_1 + left_foot_l3 * Ry_left_thigh_x);
  C[133] = neg_Ry_left_hip_fork_x * neg_r_left_foot_x - Ry_left_thigh_x * neg_r_left_foot_y;
  C[136] = C[133];
  const Scalar t_base_px_2 = neg_Rx_left_thigh_y * neg_r_left_shank_x;
  C[108] = t_base_px_2 - Rx_left_thigh_x * r_left_shank_y;
  const Scalar t_base_px_3 = Ry_left_thigh_y * neg_r_left_thigh_x;
  C[97] = Ry_left_thigh_x * neg_r_left_thigh_y - t_base_px_3;
  C[132] = neg_Rx_left_hip_fork_x * neg_r_left_foot_x - Rx_left_thigh_x * neg_r_left_foot_y;
  C[135] = C[132];
  const Scalar t_base_px_4 = neg_Rx_left_thigh_y * neg_r_left_ankle_cross_x;
  C[120] = t_base_px_4 - left_foot_l3 * Rx_left_thigh_x;
  const Scalar t_base_px_5 = Ry_left_thigh_y * neg_r_left_shank_x;
  C[109] = -(t_base_px_5 + Ry_left_thigh_x * r_left_shank_y);
  const Scalar t_base_px_6 = neg_Rx_left_thigh_y * neg_r_left_thigh_x;
  C[96] = t_base_px_6 + Rx_left_thigh_x * neg_r_left_thigh_y;
  const Scalar C_72_1 = Rx_left_hip_block_x * neg_r_left_hip_block_y;
  C[72] = C_72_1 - neg_Rx_left_hip_block_y * r_left_hip_block_x;
  const Scalar C_74_1 = Rz_left_hip_block_x * neg_r_left_hip_block_y;
  C[74] = C_74_1 + Rz_left_hip_block_y * r_left_hip_block_x;
  const Scalar C_73_1 = Ry_left_hip_block_x * neg_r_left_hip_block_y;
  C[73] = C_73_1 - neg_Ry_left_hip_block_y * r_left_hip_block_x;
  const Scalar t_base_px_7 = neg_Rz_left_thigh_y * neg_r_left_thigh_x;
  C[98] = t_base_px_7 + Rz_left_thigh_x * neg_r_left_thigh_y;
  const Scalar t_base_px_8 = left_foot_l3 * Rz_left_thigh_x;
  const Scalar t_base_px_9 = neg_s_left_ankle_cross_y * Rz_left_thigh_x;
  const Scalar t_base_px_10 = t_base_px_9 + neg_Rz_left_thigh_y * neg_r_left_shank_x;
  C[110] = t_base_px_10 - t_base_px_8;
  const Scalar t_base_px_11 = Rx_left_hip_fork_y * neg_r_left_hip_fork_x;
  C[84] = -(t_base_px_11 + neg_Rx_left_hip_fork_x * neg_r_left_hip_fork_y);
  C[134] = -(Rz_left_thigh_x * neg_r_left_foot_y + Rz_left_hip_fork_x * neg_r_left_foot_x);
  C[137] = C[134];
  const Scalar t_base_px_12 = neg_Rz_left_thigh_y * neg_r_left_ankle_cross_x;
  C[122] = t_base_px_12 - t_base_px_8;
  const Scalar t_base_px_13 = Ry_left_hip_fork_y * neg_r_left_hip_fork_x;
  C[85] = -(t_base_px_13 + neg_Ry_left_hip_fork_x * neg_r_left_hip_fork_y);
  const Scalar t_base_px_14 = Rz_left_hip_fork_y * neg_r_left_hip_fork_x;
  C[86] = Rz_left_hip_fork_x * neg_r_left_hip_fork_y - t_base_px_14;
  const Scalar r_left_shank_y_2 = left_foot_l1 - neg_s_left_ankle_cross_y;
  const Scalar neg_r_left_thigh_y_2 = neg_s_left_shank_y - r_left_shank_y_2;
  const Scalar neg_r_left_hip_fork_y_2 = t_left_thigh_1 - s_q8_q9_q10 * neg_r_left_thigh_y_2;
  const Scalar neg_r_left_hip_block_y_2 =
      t_left_hip_fork_3 - s_left_hip_roll * neg_r_left_hip_fork_y_2;
  const Scalar r_left_hip_block_x_2 = t_left_hip_block_3 - c_q8_q9_q10 * neg_r_left_thigh_y_2;
  const Scalar r_base_rx_x_2_1 = left_hip_block_l1 - c_left_hip_yaw * neg_r_left_hip_block_y_2;
  const Scalar r_base_rx_x_2 = r_base_rx_x_2_1 + s_left_hip_yaw * r_left_hip_block_x_2;
  const Scalar r_base_rx_z_2_1 = s_left_hip_yaw * neg_r_left_hip_block_y_2;
  // base_rx: r of (9)
  const Scalar r_base_rx_z_2 = c_left_hip_yaw * r_left_hip_block_x_2 + r_base_rx_z_2_1;
  const Scalar r_base_rx_y_2 = t_base_rx_5 - c_left_hip_roll * neg_r_left_hip_fork_y_2;
  const Scalar t_base_rx_7 = c_base_rx * r_base_rx_y_2 + s_base_rx * r_base_rx_x_2;
  const Scalar r_base_rz_x_2 = c_base_ry * r_base_rx_z_2 + s_base_ry * t_base_rx_7;
  C[53] = -r_base_rz_x_2;
  const Scalar neg_r_base_ry_y_2 = s_base_ry * r_base_rx_z_2 - c_base_ry * t_base_rx_7;
  const Scalar r_base_ry_z_2 = c_base_rx * r_base_rx_x_2 - s_base_rx * r_base_rx_y_2;
  C[40] = c_base_rz * r_base_rz_x_2 - s_base_rz * r_base_ry_z_2;
  C[39] = -(s_base_rz * r_base_rz_x_2 + c_base_rz * r_base_ry_z_2);
  // base_px: C of (9)
  C[51] = -c_base_rz * neg_r_base_ry_y_2;
  C[52] = -s_base_rz * neg_r_base_ry_y_2;
  C[65] = c_base_ry * r_base_ry_z_2;
  C[64] = -(Ry_base_rx_x * r_base_rx_y_2 + neg_Ry_base_rx_y * r_base_rx_x_2);
  C[63] = Rx_base_rx_y * r_base_rx_x_2 + neg_Rx_base_rx_x * r_base_rx_y_2;
  C[99] = t_base_px_6 + Rx_left_thigh_x * neg_r_left_thigh_y_2;
  C[112] = -(t_base_px_5 + Ry_left_thigh_x * r_left_shank_y_2);
  C[111] = t_base_px_2 - Rx_left_thigh_x * r_left_shank_y_2;
  C[100] = Ry_left_thigh_x * neg_r_left_thigh_y_2 - t_base_px_3;
  C[124] = -(t_base_px_1 + left_foot_l1 * Ry_left_thigh_x);
  C[123] = t_base_px_4 - left_foot_l1 * Rx_left_thigh_x;
  const Scalar C_75_1 = Rx_left_hip_block_x * neg_r_left_hip_block_y_2;
  C[75] = C_75_1 - neg_Rx_left_hip_block_y * r_left_hip_block_x_2;
  const Scalar neg_C_76_1 = neg_Ry_left_hip_block_y * r_left_hip_block_x_2;
  C[76] = Ry_left_hip_block_x * neg_r_left_hip_block_y_2 - neg_C_76_1;
  const Scalar C_77_1 = Rz_left_hip_block_x * neg_r_left_hip_block_y_2;
  C[77] = Rz_left_hip_block_y * r_left_hip_block_x_2 + C_77_1;
  C[101] = t_base_px_7 + Rz_left_thigh_x * neg_r_left_thigh_y_2;
  const Scalar t_base_px_15 = left_foot_l1 * Rz_left_thigh_x;
  C[113] = t_base_px_10 - t_base_px_15;
  C[88] = -(t_base_px_13 + neg_Ry_left_hip_fork_x * neg_r_left_hip_fork_y_2);
  C[125] = t_base_px_12 - t_base_px_15;
  C[87] = -(t_base_px_11 + neg_Rx_left_hip_fork_x * neg_r_left_hip_fork_y_2);
  C[89] = Rz_left_hip_fork_x * neg_r_left_hip_fork_y_2 - t_base_px_14;
  const Scalar neg_r_righ_ankl_cros_x = left_hip_fork_l1 - neg_r_right_foot_x;
  const Scalar neg_r_right_shank_x =
      neg_r_righ_ankl_cros_x - left_ankle_cross_l1 * c_right_ankle_pitch;
  // right_shank: r of (9)
  const Scalar r_right_shank_y = left_foot_l3 - neg_s_righ_ankl_cros_y;
  const Scalar neg_r_right_thigh_x = neg_r_right_shank_x - left_shank_l1 * c_q15_q16;
  const Scalar neg_r_right_thigh_y = neg_s_right_shank_y - r_right_shank_y;
  const Scalar t_right_thigh_1 = c_q14_q15_q16 * neg_r_right_thigh_x;
  const Scalar neg_r_right_hip_fork_y = t_right_thigh_1 - s_q14_q15_q16 * neg_r_right_thigh_y;
  const Scalar r_right_hip_fork_x = left_hip_fork_l3 - neg_r_right_foot_y;
  const Scalar t_right_hip_fork_3 = c_right_hip_roll * r_right_hip_fork_x;
  // right_hip_block: r of (9)
  const Scalar r_right_hip_block_y = t_right_hip_fork_3 + s_right_hip_roll * neg_r_right_hip_fork_y;
  const Scalar t_right_hip_block_3 = left_hip_fork_l1 - s_q14_q15_q16 * neg_r_right_thigh_x;
  const Scalar r_right_hip_block_x = t_right_hip_block_3 - c_q14_q15_q16 * neg_r_right_thigh_y;
  const Scalar neg_r_base_rx_x_1 = left_hip_block_l1 - s_right_hip_yaw * r_right_hip_block_x;
  const Scalar neg_r_base_rx_x = neg_r_base_rx_x_1 - c_right_hip_yaw * r_right_hip_block_y;
  // base_rx: r of (9)
  const Scalar t_base_rx_8 = left_hip_block_l2 + s_right_hip_roll * r_right_hip_fork_x;
  const Scalar r_base_rx_y_3 = t_base_rx_8 - c_right_hip_roll * neg_r_right_hip_fork_y;
  const Scalar t_base_rx_9 = s_base_rx * neg_r_base_rx_x - c_base_rx * r_base_rx_y_3;
  const Scalar r_base_rx_z_3_1 = c_right_hip_yaw * r_right_hip_block_x;
  const Scalar r_base_rx_z_3 = r_base_rx_z_3_1 - s_right_hip_yaw * r_right_hip_block_y;
  const Scalar r_base_rz_x_3 = c_base_ry * r_base_rx_z_3 - s_base_ry * t_base_rx_9;
  C[56] = -r_base_rz_x_3;
  const Scalar neg_r_base_ry_z = c_base_rx * neg_r_base_rx_x + s_base_rx * r_base_rx_y_3;
  C[43] = c_base_rz * r_base_rz_x_3 + s_base_rz * neg_r_base_ry_z;
  C[42] = c_base_rz * neg_r_base_ry_z - s_base_rz * r_base_rz_x_3;
  const Scalar neg_r_base_ry_y_3 = s_base_ry * r_base_rx_z_3 + c_base_ry * t_base_rx_9;
  // base_px: C of (9)
  C[55] = -s_base_rz * neg_r_base_ry_y_3;
  C[54] = -c_base_rz * neg_r_base_ry_y_3;
  C[68] = -c_base_ry * neg_r_base_ry_z;
  C[66] = neg_Rx_base_rx_x * r_base_rx_y_3 - Rx_base_rx_y * neg_r_base_rx_x;
  C[67] = neg_Ry_base_rx_y * neg_r_base_rx_x - Ry_base_rx_x * r_base_rx_y_3;
  const Scalar t_base_px_16 = Rx_right_thigh_x * r_right_shank_y;
  const Scalar t_base_px_17 = Rx_right_thigh_y * neg_r_right_thigh_x;
  const Scalar t_base_px_18 = t_base_px_17 - neg_s_right_shank_y * Rx_right_thigh_x;
  C[174] = -(t_base_px_16 + t_base_px_18);
  const Scalar t_base_px_19 = Ry_right_thigh_y * neg_r_righ_ankl_cros_x;
  C[199] = -(t_base_px_19 + left_foot_l3 * Ry_right_thigh_x);
  const Scalar t_base_px_20 = Rx_right_thigh_y * neg_r_right_shank_x;
  C[186] = -(t_base_px_16 + t_base_px_20);
  const Scalar t_base_px_21 = Ry_right_thigh_y * neg_r_right_shank_x;
  C[187] = -(t_base_px_21 + Ry_right_thigh_x * r_right_shank_y);
  C[210] = neg_Rx_right_hip_fork_x * neg_r_right_foot_x - Rx_right_thigh_x * neg_r_right_foot_y;
  C[213] = C[210];
  const Scalar t_base_px_22 = Rx_right_thigh_y * neg_r_righ_ankl_cros_x;
  C[198] = -(t_base_px_22 + left_foot_l3 * Rx_right_thigh_x);
  C[211] = neg_Ry_right_hip_fork_x * neg_r_right_foot_x - Ry_right_thigh_x * neg_r_right_foot_y;
  C[214] = C[211];
  const Scalar t_base_px_23 = Ry_right_thigh_y * neg_r_right_thigh_x;
  C[175] = Ry_right_thigh_x * neg_r_right_thigh_y - t_base_px_23;
  const Scalar neg_C_150_1 = neg_Rx_right_hip_block_y * r_right_hip_block_x;
  C[150] = -(neg_C_150_1 + Rx_right_hip_block_x * r_right_hip_block_y);
  const Scalar neg_C_151_1 = neg_Ry_right_hip_block_y * r_right_hip_block_x;
  C[151] = -(Ry_right_hip_block_x * r_right_hip_block_y + neg_C_151_1);
  const Scalar C_152_1 = Rz_right_hip_block_y * r_right_hip_block_x;
  C[152] = C_152_1 - Rz_right_hip_block_x * r_right_hip_block_y;
  const Scalar t_base_px_24 = neg_Rz_right_thigh_y * neg_r_right_shank_x;
  C[188] = t_base_px_24 - Rz_right_thigh_x * r_right_shank_y;
  C[212] = -(Rz_right_hip_fork_x * neg_r_right_foot_x + Rz_right_thigh_x * neg_r_right_foot_y);
  C[215] = C[212];
  const Scalar t_base_px_25 = neg_Rz_right_thigh_y * neg_r_righ_ankl_cros_x;
  C[200] = t_base_px_25 - left_foot_l3 * Rz_right_thigh_x;
  const Scalar t_base_px_26 = Ry_right_hip_fork_y * r_right_hip_fork_x;
  C[163] = t_base_px_26 - neg_Ry_right_hip_fork_x * neg_r_right_hip_fork_y;
  const Scalar t_base_px_27 = neg_Rz_right_thigh_y * neg_r_right_thigh_x;
  C[176] = t_base_px_27 + Rz_right_thigh_x * neg_r_right_thigh_y;
  const Scalar t_base_px_28 = Rx_right_hip_fork_y * r_right_hip_fork_x;
  C[162] = t_base_px_28 - neg_Rx_right_hip_fork_x * neg_r_right_hip_fork_y;
  const Scalar t_base_px_29 = Rz_right_hip_fork_y * r_right_hip_fork_x;
  C[164] = t_base_px_29 + Rz_right_hip_fork_x * neg_r_right_hip_fork_y;
  const Scalar r_right_shank_y_2 = left_foot_l1 - neg_s_righ_ankl_cros_y;
  const Scalar neg_r_right_thigh_y_2 = neg_s_right_shank_y - r_right_shank_y_2;
  const Scalar neg_r_right_hip_fork_y_2 = t_right_thigh_1 - s_q14_q15_q16 * neg_r_right_thigh_y_2;
  // right_hip_block: r of (9)
  const Scalar r_right_hip_block_y_2 =
      t_right_hip_fork_3 + s_right_hip_roll * neg_r_right_hip_fork_y_2;
  const Scalar r_right_hip_block_x_2 = t_right_hip_block_3 - c_q14_q15_q16 * neg_r_right_thigh_y_2;
  const Scalar neg_r_base_rx_x_2_1 = left_hip_block_l1 - c_right_hip_yaw * r_right_hip_block_y_2;
  const Scalar neg_r_base_rx_x_2 = neg_r_base_rx_x_2_1 - s_right_hip_yaw * r_right_hip_block_x_2;
  const Scalar r_base_rx_y_4 = t_base_rx_8 - c_right_hip_roll * neg_r_right_hip_fork_y_2;
  const Scalar t_base_rx_10 = s_base_rx * neg_r_base_rx_x_2 - c_base_rx * r_base_rx_y_4;
  const Scalar neg_r_base_rx_z_1 = s_right_hip_yaw * r_right_hip_block_y_2;
  const Scalar neg_r_base_rx_z = neg_r_base_rx_z_1 - c_right_hip_yaw * r_right_hip_block_x_2;
  const Scalar r_base_ry_x = c_base_ry * neg_r_base_rx_z + s_base_ry * t_base_rx_10;
  C[59] = r_base_ry_x;
  const Scalar neg_r_base_ry_z_2 = s_base_rx * r_base_rx_y_4 + c_base_rx * neg_r_base_rx_x_2;
  C[45] = c_base_rz * neg_r_base_ry_z_2 + s_base_rz * r_base_ry_x;
  C[46] = s_base_rz * neg_r_base_ry_z_2 - c_base_rz * r_base_ry_x;
  const Scalar neg_r_base_ry_y_4 = c_base_ry * t_base_rx_10 - s_base_ry * neg_r_base_rx_z;
  // base_px: C of (9)
  C[57] = -c_base_rz * neg_r_base_ry_y_4;
  C[58] = -s_base_rz * neg_r_base_ry_y_4;
  C[69] = neg_Rx_base_rx_x * r_base_rx_y_4 - Rx_base_rx_y * neg_r_base_rx_x_2;
  C[70] = neg_Ry_base_rx_y * neg_r_base_rx_x_2 - Ry_base_rx_x * r_base_rx_y_4;
  C[71] = -c_base_ry * neg_r_base_ry_z_2;
  C[202] = -(t_base_px_19 + left_foot_l1 * Ry_right_thigh_x);
  const Scalar t_base_px_30 = Rx_right_thigh_x * r_right_shank_y_2;
  C[177] = -(t_base_px_18 + t_base_px_30);
  C[178] = Ry_right_thigh_x * neg_r_right_thigh_y_2 - t_base_px_23;
  C[190] = -(t_base_px_21 + Ry_right_thigh_x * r_right_shank_y_2);
  C[201] = -(t_base_px_22 + left_foot_l1 * Rx_right_thigh_x);
  C[189] = -(t_base_px_20 + t_base_px_30);
  const Scalar neg_C_155_1 = Rz_right_hip_block_x * r_right_hip_block_y_2;
  C[155] = Rz_right_hip_block_y * r_right_hip_block_x_2 - neg_C_155_1;
  const Scalar neg_C_153_1 = neg_Rx_right_hip_block_y * r_right_hip_block_x_2;
  C[153] = -(neg_C_153_1 + Rx_right_hip_block_x * r_right_hip_block_y_2);
  const Scalar neg_C_154_1 = neg_Ry_right_hip_block_y * r_right_hip_block_x_2;
  C[154] = -(neg_C_154_1 + Ry_right_hip_block_x * r_right_hip_block_y_2);
  C[166] = t_base_px_26 - neg_Ry_right_hip_fork_x * neg_r_right_hip_fork_y_2;
  C[179] = t_base_px_27 + Rz_right_thigh_x * neg_r_right_thigh_y_2;
  C[203] = t_base_px_25 - left_foot_l1 * Rz_right_thigh_x;
  C[191] = t_base_px_24 - Rz_right_thigh_x * r_right_shank_y_2;
  C[165] = t_base_px_28 - neg_Rx_right_hip_fork_x * neg_r_right_hip_fork_y_2;
  C[167] = t_base_px_29 + Rz_right_hip_fork_x * neg_r_right_hip_fork_y_2;
  C[0] = 1.0;
  C[3] = 1.0;
  C[6] = 1.0;
  C[9] = 1.0;
  C[13] = 1.0;
  C[16] = 1.0;
  C[19] = 1.0;
  C[22] = 1.0;
  C[26] = 1.0;
  C[29] = 1.0;
  C[32] = 1.0;
  C[35] = 1.0;
  force_jacobian_transpose_0(C);
}

}  // namespace biped
