// biped.cpp: see biped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate biped.yaml --scalar float

#include "biped.hpp"

namespace biped {

static_assert(kDigest == 0x799d15537b5646aeULL, "header and source are of different runs");

// Zeros, where compilers may store neighbours at once.
namespace {

[[gnu::noinline]] void mass_matrix_0(Scalar A[144]) noexcept {
  A[6] = 0.0f;
  A[7] = 0.0f;
  A[8] = 0.0f;
  A[9] = 0.0f;
  A[10] = 0.0f;
  A[11] = 0.0f;
  A[18] = 0.0f;
  A[19] = 0.0f;
  A[20] = 0.0f;
  A[21] = 0.0f;
  A[22] = 0.0f;
  A[23] = 0.0f;
  A[30] = 0.0f;
  A[31] = 0.0f;
  A[32] = 0.0f;
  A[33] = 0.0f;
  A[34] = 0.0f;
  A[35] = 0.0f;
  A[42] = 0.0f;
  A[43] = 0.0f;
  A[44] = 0.0f;
  A[45] = 0.0f;
  A[46] = 0.0f;
  A[47] = 0.0f;
  A[54] = 0.0f;
  A[55] = 0.0f;
  A[56] = 0.0f;
  A[57] = 0.0f;
  A[58] = 0.0f;
  A[59] = 0.0f;
  A[66] = 0.0f;
  A[67] = 0.0f;
  A[68] = 0.0f;
  A[69] = 0.0f;
  A[70] = 0.0f;
  A[71] = 0.0f;
  A[72] = 0.0f;
  A[73] = 0.0f;
  A[74] = 0.0f;
  A[75] = 0.0f;
  A[76] = 0.0f;
  A[77] = 0.0f;
  A[84] = 0.0f;
  A[85] = 0.0f;
  A[86] = 0.0f;
  A[87] = 0.0f;
  A[88] = 0.0f;
  A[89] = 0.0f;
  A[96] = 0.0f;
  A[97] = 0.0f;
  A[98] = 0.0f;
  A[99] = 0.0f;
  A[100] = 0.0f;
  A[101] = 0.0f;
  A[108] = 0.0f;
  A[109] = 0.0f;
  A[110] = 0.0f;
  A[111] = 0.0f;
  A[112] = 0.0f;
  A[113] = 0.0f;
  A[120] = 0.0f;
  A[121] = 0.0f;
  A[122] = 0.0f;
  A[123] = 0.0f;
  A[124] = 0.0f;
  A[125] = 0.0f;
  A[132] = 0.0f;
  A[133] = 0.0f;
  A[134] = 0.0f;
  A[135] = 0.0f;
  A[136] = 0.0f;
  A[137] = 0.0f;
}

[[gnu::noinline]] void force_jacobian_transpose_0(Scalar C[144]) noexcept {
  C[2] = 0.0f;
  C[5] = 0.0f;
  C[6] = 0.0f;
  C[7] = 0.0f;
  C[8] = 0.0f;
  C[9] = 0.0f;
  C[10] = 0.0f;
  C[11] = 0.0f;
  C[18] = 0.0f;
  C[19] = 0.0f;
  C[20] = 0.0f;
  C[21] = 0.0f;
  C[22] = 0.0f;
  C[23] = 0.0f;
  C[30] = 0.0f;
  C[31] = 0.0f;
  C[32] = 0.0f;
  C[33] = 0.0f;
  C[34] = 0.0f;
  C[35] = 0.0f;
  C[42] = 0.0f;
  C[43] = 0.0f;
  C[44] = 0.0f;
  C[45] = 0.0f;
  C[46] = 0.0f;
  C[47] = 0.0f;
  C[54] = 0.0f;
  C[55] = 0.0f;
  C[56] = 0.0f;
  C[57] = 0.0f;
  C[58] = 0.0f;
  C[59] = 0.0f;
  C[66] = 0.0f;
  C[67] = 0.0f;
  C[68] = 0.0f;
  C[69] = 0.0f;
  C[70] = 0.0f;
  C[71] = 0.0f;
  C[72] = 0.0f;
  C[73] = 0.0f;
  C[74] = 0.0f;
  C[75] = 0.0f;
  C[76] = 0.0f;
  C[77] = 0.0f;
  C[80] = 0.0f;
  C[83] = 0.0f;
  C[84] = 0.0f;
  C[85] = 0.0f;
  C[86] = 0.0f;
  C[87] = 0.0f;
  C[88] = 0.0f;
  C[89] = 0.0f;
  C[96] = 0.0f;
  C[97] = 0.0f;
  C[98] = 0.0f;
  C[99] = 0.0f;
  C[100] = 0.0f;
  C[101] = 0.0f;
  C[108] = 0.0f;
  C[109] = 0.0f;
  C[110] = 0.0f;
  C[111] = 0.0f;
  C[112] = 0.0f;
  C[113] = 0.0f;
  C[120] = 0.0f;
  C[121] = 0.0f;
  C[122] = 0.0f;
  C[123] = 0.0f;
  C[124] = 0.0f;
  C[125] = 0.0f;
  C[132] = 0.0f;
  C[133] = 0.0f;
  C[134] = 0.0f;
  C[135] = 0.0f;
  C[136] = 0.0f;
  C[137] = 0.0f;
}

}  // namespace

// g++ would gather scalars into vectors, which makes nothing faster and some functions slower.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

// Orders of sums other than those that are written would cancel the rounding.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 2)
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
/// modulo 4; the addition theorem, with factors 0, 1 and -1. Absolute errors below 1e-7 for
/// |x| < 1e5; not a number for |x| > 1.03e5 and where x is none.
template <class Angle>
[[gnu::always_inline]] inline SineCosine<Angle> pair_of(Angle x) noexcept {
  const Angle k = (x * 0.63661975f + 12582912.0f) - 12582912.0f;
  const Angle t = k * 5.192297e+33f;  // infinite beyond the range
  const Angle r_1 = x - t * 3.0243119e-34f;
  const Angle r_2 = r_1 - k * 0.00048828125f;
  const Angle r = r_2 + k * 4.454455e-06f;
  const Angle z = r * r;
  const Angle s_1 = -0.00019515296f * z + 0.008332161f;
  const Angle s_2 = s_1 * z - 0.16666655f;
  const Angle c_1 = 2.4433157e-05f * z - 0.0013887316f;
  const Angle c_2 = c_1 * z + 0.041666646f;
  const Angle sine = r + r * z * s_2;
  const Angle cosine = 1.0f - z * (0.5f - z * c_2);

  // k modulo 4: -2 to 2, not a number where t is infinite
  const Angle l = t * 1.92593e-34f;
  const Angle m = l - ((l + 50331650.0f) - 50331650.0f);
  const Angle n = 4.0f - m * m;
  // sine and cosine of m pi/2: 0, 1 or -1
  const Angle s = m * (n * 0.33333334f);
  const Angle c = 0.5f * (n - s * s) - 1.0f;
  return {c * sine + s * cosine, c * cosine - s * sine};
}

[[gnu::noinline, gnu::unused]] SineCosine<float> sine_cosine(float x) noexcept {
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
using Angles [[gnu::vector_size(32)]] = float;
#else
using Angles [[gnu::vector_size(16)]] = float;
#endif
constexpr unsigned kAngles = sizeof(Angles) / sizeof(float);

/// The pairs of a vector of angles, which come one by one: a load would wait for all to be stored,
/// and of a vector that crosses a call g++ leaves the upper halves of registers in use, with which
/// code for SSE is slow.
template <class... Angle>
[[gnu::noinline]] void store_sines_cosines(float* sines, float* cosines, Angle... x) noexcept {
  const SineCosine<Angles> pairs = pair_of(Angles{x...});
  __builtin_memcpy(sines, &pairs.sine, sizeof(Angles));
  __builtin_memcpy(cosines, &pairs.cosine, sizeof(Angles));
}

/// Those of the numbers from x on.
[[gnu::always_inline]] inline void store(const float* x, float* sines, float* cosines) noexcept {
#if defined(__AVX__)
  store_sines_cosines(sines, cosines, x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]);
#else
  store_sines_cosines(sines, cosines, x[0], x[1], x[2], x[3]);
#endif
}

/// Sines and cosines of 8 angles or fewer, as many at once as the processor can; writes whole
/// vectors.
template <class... Angle>
[[gnu::always_inline]] inline void sines_cosines(float* sines, float* cosines, float first,
                                                 Angle... more) noexcept {
  const float x[] = {first, more..., first, first, first, first, first, first, first};
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
// above each its unit and the numbers of the model that it is made of, but for those that are
// exactly 0 or 1. Other literals are numbers of the equations.

// m/s^2: gravity
constexpr float base_g1 = 9.81f;

// m: offset y of left_hip_block, right_hip_block
constexpr float left_hip_block_l1 = 0.08064f;
// m: offset z of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr float left_hip_block_l2 = 0.114f;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x z,
//     inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz
//     of left_thigh, right_thigh; mass, com x z, inertia xx yy zz, offset z of left_shank,
//     left_ankle_cross, right_shank, right_ankle_cross; mass, com, inertia xx yy zz, offset z of
//     left_foot, right_foot
constexpr float left_hip_block_I1 = 1.7027155f;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia
//     xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh;
//     offset z of left_shank, left_foot, right_shank, right_foot
constexpr float left_hip_block_I2 = 0.0032230439f;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x z,
//     inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass of left_thigh, left_shank,
//     left_ankle_cross, right_thigh, right_shank, right_ankle_cross; mass, offset z of left_foot,
//     right_foot
constexpr float left_hip_block_I3 = 0.0043290067f;

// ratio: offset x of left_hip_fork, right_hip_fork; offset z of left_shank, left_foot, right_shank,
//     right_foot
constexpr float left_hip_fork_k1 = 43.2f;
// ratio: offset x of left_hip_fork, right_hip_fork; offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr float left_hip_fork_k2 = 43.3f;
// ratio: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; offset z
//     of left_foot, right_foot
constexpr float left_hip_fork_k3 = 2.0f;
// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr float left_hip_fork_l1 = 0.01f;
// m: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr float left_hip_fork_l2 = 0.02f;
// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr float left_hip_fork_l3 = 0.02f;
// m: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr float left_hip_fork_l4 = 0.04f;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_hip_fork_I1 = 0.0042631915f;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xz yz of
//     left_thigh, left_shank, right_thigh, right_shank; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr float left_hip_fork_I2 = 0.034676712f;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_I3 = 0.00016159248f;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz,
//     offset z of left_shank, left_ankle_cross, left_foot, right_shank, right_ankle_cross,
//     right_foot
constexpr float left_hip_fork_I4 = 1.6921113f;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz,
//     offset z of left_shank, right_shank; mass, com, inertia xx yy zz, offset z of
//     left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_hip_fork_I5 = 1.6313524f;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_I6 = 0.0293105f;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_I7 = 8.079624e-05f;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; offset z of left_foot,
//     right_foot
constexpr float left_hip_fork_I8 = 0.00011406528f;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_I9 = 0.0040738555f;
// kg m^2: mass, com z, inertia xx yy zz of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_I10 = 0.00026615232f;
// kg m^2: mass, com y, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_I11 = 0.029576652f;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz,
//     offset z of left_shank, right_shank; mass, com y, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr float left_hip_fork_I12 = 0.00053230464f;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz,
//     offset z of left_shank, right_shank; mass, com y, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr float left_hip_fork_I13 = 0.059910648f;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_hip_fork_I14 = 0.029689172f;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z of left_foot, right_foot
constexpr float left_hip_fork_I15 = 0.3260792f;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z of left_foot, right_foot
constexpr float left_hip_fork_I16 = 0.3868322f;
// N m: gravity; mass, com y, offset z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr float left_hip_fork_G1 = 3.9972482f;
// N m: gravity; mass, com z of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_G2 = 0.046624184f;
// N m: gravity; mass, com y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_G3 = 3.8115096f;
// s^-2: gravity; offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr float left_hip_fork_p1 = 981.0f;

// kg m: mass, com x of left_thigh, right_thigh
constexpr float left_thigh_h1 = 0.14731531f;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, left_ankle_cross,
//     right_thigh, right_ankle_cross; mass, offset z of left_shank, right_shank; offset z of
//     left_foot, right_foot
constexpr float left_thigh_h2 = 3.2190154f;
// kg m: mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank; mass of
//     left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_thigh_h3 = 3.6279812f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; mass,
//     offset z of left_shank, left_foot, right_shank, right_foot; mass of left_ankle_cross,
//     right_ankle_cross
constexpr float left_thigh_I1 = 0.036279812f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_thigh, right_thigh; offset
//     z of left_foot, right_foot
constexpr float left_thigh_I2 = 0.0014731531f;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_thigh_I3 = 1.2800688f;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr float left_thigh_I4 = 0.03939174f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_thigh_I5 = 0.09232168f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com x y, inertia xy, offset y of
//     left_thigh, right_thigh
constexpr float left_thigh_I6 = 0.004425553f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, com x z, inertia xx yy zz, offset z of left_shank, left_ankle_cross,
//     right_shank, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_thigh_I7 = 1.6983864f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_thigh_I8 = 0.084142365f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, offset z of left_shank, right_shank; mass, com z of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_thigh_I9 = 1.1033955f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, offset z of left_shank, right_shank; mass, com z of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_thigh_I10 = 1.128046f;
// kg m^2: mass, com x, inertia xx yy zz of left_thigh, right_thigh
constexpr float left_thigh_I11 = 0.024650494f;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr float left_thigh_I12 = 0.01969587f;
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr float left_thigh_I13 = 0.26256865f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; mass,
//     com z, offset z of left_shank, right_shank; offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr float left_thigh_I14 = 0.00058478647f;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr float left_thigh_I15 = 0.23791817f;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr float left_thigh_I16 = 0.28721914f;
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_thigh_I17 = 1.3047192f;
// N m: gravity; mass, com x of left_thigh, right_thigh
constexpr float left_thigh_G1 = 1.4451631f;
// N m: gravity; mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank;
//     mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_thigh_G2 = 35.590496f;

// m: offset z of left_shank, right_shank
constexpr float left_shank_l1 = 0.432f;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_shank_h1 = 0.6943415f;
// kg m: mass, com x of left_shank, right_shank
constexpr float left_shank_h2 = 0.080309376f;
// kg m: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_h3 = 1.1042539f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_shank, right_shank; offset
//     z of left_foot, right_foot
constexpr float left_shank_I1 = 0.0008030938f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     offset z of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_shank_I2 = 0.011042539f;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr float left_shank_I3 = 0.03083291f;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; mass, offset z of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_I4 = 0.3507794f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, inertia xz yz of left_shank, right_shank; mass, com y, offset z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_shank_I5 = 0.025658026f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y, inertia xy of left_shank, right_shank
constexpr float left_shank_I6 = 0.0015598222f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com x z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_shank_I7 = 0.3690168f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr float left_shank_I8 = 0.17328733f;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr float left_shank_I9 = 0.015416455f;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, right_shank
constexpr float left_shank_I10 = 0.0052914377f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, inertia xz yz of left_shank, right_shank; mass, com y z, offset z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_shank_I11 = 0.017459776f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr float left_shank_I12 = 0.17857878f;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr float left_shank_I13 = 0.12207109f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_shank_I14 = 0.000160356f;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr float left_shank_I15 = 0.12736252f;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr float left_shank_I16 = 0.11677965f;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; mass, offset z of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_I17 = 0.35607085f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com x z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_shank_I18 = 0.36845988f;
// N m: gravity; mass, com x of left_shank, right_shank
constexpr float left_shank_G1 = 0.787835f;
// N m: gravity; mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_G2 = 10.832731f;

// kg: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_m1 = 0.94668f;
// m: offset z of left_ankle_cross, right_ankle_cross
constexpr float left_ankle_cross_l1 = 0.433f;
// kg m: mass, com x of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_ankle_cross_h1 = 0.05508364f;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_h2 = 0.0094668f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I1 = 9.4668e-05f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y of left_ankle_cross, right_ankle_cross; mass, com x of left_foot, right_foot
constexpr float left_ankle_cross_I2 = 0.0011063096f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I3 = 0.0005508364f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com y z, inertia xx yy zz, offset z of
//     left_foot, right_foot
constexpr float left_ankle_cross_I4 = 0.0001601243f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I5 = 0.006303306f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I6 = 0.007654492f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I7 = 0.0010993544f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I8 = 0.0005496772f;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, left_foot, right_ankle_cross,
//     right_foot
constexpr float left_ankle_cross_I9 = 0.006978899f;
// kg m^2: mass, com y z of left_ankle_cross, right_ankle_cross
constexpr float left_ankle_cross_I10 = 6.9552e-06f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_ankle_cross_I11 = 2.40212e-05f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I12 = 0.0069548776f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I13 = 0.00700292f;
// kg m^2: mass, com x, offset z of left_ankle_cross, right_ankle_cross; mass, com x of left_foot,
//     right_foot
constexpr float left_ankle_cross_I14 = 0.023851216f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I15 = 0.0068602096f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I16 = 0.007097588f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I17 = 0.0001962912f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I18 = 0.0001186892f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z
//     of left_foot, right_foot
constexpr float left_ankle_cross_I19 = 0.0001660215f;
// N m: gravity; mass, com x of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_ankle_cross_G1 = 0.54037046f;
// N m: gravity; offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_G2 = 0.09286931f;

// ratio: mass, com y z of left_foot, right_foot
constexpr float left_foot_k1 = 0.26146916f;
// ratio: mass, com, inertia xy xz of left_foot, right_foot
constexpr float left_foot_k2 = 0.3048947f;
// m: points of left_foot, right_foot
constexpr float left_foot_l1 = 0.06f;
// m: points of left_foot, right_foot
constexpr float left_foot_l2 = 0.05903f;
// m: points of left_foot, right_foot
constexpr float left_foot_l3 = 0.20904f;
// kg m: mass, com y z of left_foot, right_foot
constexpr float left_foot_h1 = 0.014128636f;
// kg m: mass, com, inertia xy xz of left_foot, right_foot
constexpr float left_foot_h2 = 0.000613351f;
// kg m: mass, com, inertia xy xz of left_foot, right_foot
constexpr float left_foot_h3 = 0.014115316f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr float left_foot_I1 = 0.00014128635f;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr float left_foot_I2 = 6.298136e-05f;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr float left_foot_I3 = 0.0014494178f;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I4 = 7.2333794e-05f;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I5 = 0.00013282818f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, offset z of left_foot, right_foot
constexpr float left_foot_I6 = 0.0002825727f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, offset z of left_foot, right_foot
constexpr float left_foot_I7 = 0.0005651454f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr float left_foot_I8 = 0.0002825727f;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I9 = 0.0009809787f;
// kg m^2: offset z of left_shank, right_shank; mass, com y z of left_foot, right_foot
constexpr float left_foot_I10 = 0.0061035706f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; offset z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, offset z of left_foot, right_foot
constexpr float left_foot_I11 = 0.006117699f;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I12 = 0.0005569034f;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I13 = 0.00042407526f;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I14 = 3.6166897e-05f;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr float left_foot_I15 = 0.0001386019f;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr float left_foot_I16 = 6.0539376e-05f;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr float left_foot_I17 = 0.0005597903f;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr float left_foot_I18 = 0.0014507854f;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr float left_foot_I19 = 0.00042118842f;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr float left_foot_I20 = 3.0269688e-05f;
// N m: gravity; mass, com y z of left_foot, right_foot
constexpr float left_foot_G1 = 0.13860191f;

}  // namespace

// Lengths inside are in units of L, a distance between left_hip_roll and left_hip_pitch:
//   L = 0.01 m
// Names: vectors h_ in kg m^2/L, s_ in L; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void mass_matrix(const Scalar q[12], Scalar A[144]) noexcept {
  const Scalar q_q2_q3 = q[2] + q[3];
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const Scalar angle_left_foot = left_foot_k1 + q[5];
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const Scalar angle_right_foot = left_foot_k1 - q[11];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[1], q[2], q_q2_q3_q4, q_q2_q3, angle_left_foot, q[7], q[8],
                q_q8_q9_q10);
  sines_cosines(sines + 8, cosines + 8, q_q8_q9, angle_right_foot);
  const Scalar s_left_hip_roll = sines[0];
  const Scalar c_left_hip_roll = cosines[0];
  const Scalar s_left_hip_pitch = sines[1];
  const Scalar c_left_hip_pitch = cosines[1];
  const Scalar s_q2_q3_q4 = sines[2];
  const Scalar c_q2_q3_q4 = cosines[2];
  const Scalar s_q2_q3 = sines[3];
  const Scalar c_q2_q3 = cosines[3];
  const Scalar s_left_foot = sines[4];
  const Scalar c_left_foot = cosines[4];
  const Scalar s_right_hip_roll = sines[5];
  const Scalar c_right_hip_roll = cosines[5];
  const Scalar s_right_hip_pitch = sines[6];
  const Scalar c_right_hip_pitch = cosines[6];
  const Scalar s_q8_q9_q10 = sines[7];
  const Scalar c_q8_q9_q10 = cosines[7];
  const Scalar s_q8_q9 = sines[8];
  const Scalar c_q8_q9 = cosines[8];
  const Scalar s_right_foot = sines[9];
  const Scalar c_right_foot = cosines[9];
  const Scalar neg_s_left_shank_y = left_hip_fork_k1 * s_left_hip_pitch;
  const Scalar neg_s_left_shank_x = left_hip_fork_k1 * c_left_hip_pitch;
  const Scalar neg_s_left_ankle_cross_y = left_hip_fork_k2 * s_q2_q3;
  const Scalar neg_s_left_ankle_cross_x = left_hip_fork_k2 * c_q2_q3;
  const Scalar neg_s_right_shank_x = left_hip_fork_k1 * c_right_hip_pitch;
  const Scalar neg_s_right_shank_y = left_hip_fork_k1 * s_right_hip_pitch;
  const Scalar neg_s_righ_ankl_cros_y = left_hip_fork_k2 * s_q8_q9;
  const Scalar neg_s_righ_ankl_cros_x = left_hip_fork_k2 * c_q8_q9;
  // right_foot: first moment h, A of (2)
  const Scalar t_right_foot_1 = left_foot_I1 * c_right_foot;
  const Scalar neg_h_righ_ankl_cros_z = left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_2 = left_foot_I4 * c_right_foot + left_foot_I5 * s_right_foot;
  const Scalar t_right_foot_3 = s_right_foot * t_right_foot_2;
  const Scalar t_right_foot_4 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar A_131 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  A[131] = A_131;
  A[142] = A[131];
  // right_ankle_cross: first moment h, A, pseudo-inertia E of (2)
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_I1 + t_right_foot_1;
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_I3 * s_q8_q9_q10;
  const Scalar t_righ_ankl_cros_2 = t_righ_ankl_cros_1 + c_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_3 = left_ankle_cross_I3 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 - s_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_5 = left_ankle_cross_I4 + neg_h_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_6 = left_foot_I6 + t_right_foot_2;
  const Scalar neg_E_righ_ankl_cros_xz = t_righ_ankl_cros_5 + c_right_foot * t_righ_ankl_cros_6;
  const Scalar E_righ_ankl_cros_yz = left_ankle_cross_I2 + A_131;
  const Scalar neg_A_94 = s_q8_q9_q10 * neg_E_righ_ankl_cros_xz - c_q8_q9_q10 * E_righ_ankl_cros_yz;
  A[94] = -neg_A_94;
  A[127] = A[94];
  const Scalar t_righ_ankl_cros_7 = neg_s_righ_ankl_cros_x * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_8 = neg_s_righ_ankl_cros_y * t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_9 = 2.0f * t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_10 = t_right_foot_3 - left_foot_I8 * c_right_foot;
  const Scalar A_130 = left_ankle_cross_I6 - t_righ_ankl_cros_10;
  A[130] = A_130;
  // right_shank: pseudo-inertia E, A of (2)
  const Scalar t_right_shank_1 = left_shank_I5 + left_foot_I11 * s_right_foot;
  const Scalar E_right_shank_yz = neg_A_94 + left_shank_I6 * c_q8_q9 + s_q8_q9 * t_right_shank_1;
  A[93] = -E_right_shank_yz;
  A[115] = A[93];
  const Scalar t_right_shank_2 = t_righ_ankl_cros_10 - 2.0f * t_righ_ankl_cros_7;
  const Scalar neg_A_117 = t_right_shank_2 - (left_shank_I7 - t_righ_ankl_cros_9);
  A[117] = -neg_A_117;
  const Scalar neg_h_right_shank_x_1 = t_righ_ankl_cros_2 - left_shank_I1 * s_q8_q9;
  const Scalar neg_h_right_shank_x = neg_h_right_shank_x_1 + left_shank_I2 * c_q8_q9;
  const Scalar t_right_shank_3 = neg_s_right_shank_x * neg_h_right_shank_x;
  const Scalar t_right_thigh_1 = left_thigh_I5 + left_foot_I10 * s_right_foot;
  const Scalar t_righ_ankl_cros_11 = c_q8_q9_q10 * neg_E_righ_ankl_cros_xz;
  const Scalar t_righ_ankl_cros_12 = s_q8_q9_q10 * E_righ_ankl_cros_yz + t_righ_ankl_cros_11;
  const Scalar E_right_shank_xz_1 = t_righ_ankl_cros_12 - left_shank_I6 * s_q8_q9;
  const Scalar E_right_shank_xz = E_right_shank_xz_1 + c_q8_q9 * t_right_shank_1;
  // right_thigh: pseudo-inertia E, A of (2)
  const Scalar E_right_thigh_xz_1 = E_right_shank_xz - left_thigh_I6 * s_right_hip_pitch;
  const Scalar E_right_thigh_xz = E_right_thigh_xz_1 + c_right_hip_pitch * t_right_thigh_1;
  const Scalar E_right_thigh_yz_1 = E_right_shank_yz + left_thigh_I6 * c_right_hip_pitch;
  const Scalar E_right_thigh_yz = E_right_thigh_yz_1 + s_right_hip_pitch * t_right_thigh_1;
  A[92] = -E_right_thigh_yz;
  A[103] = A[92];
  const Scalar t_right_thigh_2 = t_right_shank_2 - 2.0f * t_right_shank_3;
  // right_shank: first moment h, A of (2)
  const Scalar h_right_shank_y_1 = t_righ_ankl_cros_4 - left_shank_I2 * s_q8_q9;
  const Scalar h_right_shank_y = h_right_shank_y_1 - left_shank_I1 * c_q8_q9;
  const Scalar t_right_shank_4 = neg_s_right_shank_y * h_right_shank_y;
  // right_thigh: A of (2)
  const Scalar t_right_thigh_3 = t_righ_ankl_cros_9 + t_right_thigh_2;
  const Scalar t_right_thigh_4 = t_right_thigh_3 + 2.0f * t_right_shank_4;
  const Scalar A_104 = left_thigh_I7 - t_right_thigh_4;
  A[104] = A_104;
  const Scalar t_right_shank_5 = left_thigh_I3 * s_right_hip_pitch;
  const Scalar t_right_shank_6 = t_right_shank_5 + left_thigh_I4 * c_right_hip_pitch;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_13 = c_q8_q9_q10 * t_right_foot_4;
  const Scalar t_righ_ankl_cros_14 = left_ankle_cross_I7 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_14 - 2.0f * t_righ_ankl_cros_13;
  const Scalar t_righ_ankl_cros_16 = left_ankle_cross_I5 + t_righ_ankl_cros_10;
  const Scalar t_righ_ankl_cros_17 = t_righ_ankl_cros_15 + s_q8_q9_q10 * t_righ_ankl_cros_16;
  const Scalar t_right_hip_fork_1 = left_hip_fork_I1 + neg_h_righ_ankl_cros_z;
  const Scalar t_right_hip_fork_2 = left_thigh_I1 - t_right_shank_6;
  const Scalar t_righ_ankl_cros_18 = left_shank_I3 * c_q8_q9 + left_shank_I4 * s_q8_q9;
  // right_hip_fork: pseudo-inertia E, A of (2)
  const Scalar t_right_hip_fork_3 = left_hip_fork_I2 + t_right_foot_4 + neg_h_right_shank_x;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_2 + left_hip_fork_k1 * h_right_shank_y;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_3 + c_q8_q9_q10 * t_righ_ankl_cros_17;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_5 + c_right_hip_pitch * t_right_hip_fork_4;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_6 - c_q8_q9 * t_righ_ankl_cros_18;
  const Scalar t_right_hip_fork_8 = left_thigh_I2 + left_hip_fork_k1 * neg_h_right_shank_x;
  const Scalar t_right_hip_fork_9 =
      t_right_hip_fork_7 + neg_s_righ_ankl_cros_x * t_righ_ankl_cros_4;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_9 - s_right_hip_pitch * t_right_hip_fork_8;
  const Scalar neg_E_right_hip_fork_xz =
      t_right_hip_fork_10 - neg_s_righ_ankl_cros_y * t_righ_ankl_cros_2;
  const Scalar neg_A_79_1 = s_right_hip_roll * (E_right_thigh_yz - t_right_hip_fork_1);
  A[79] = c_right_hip_roll * neg_E_right_hip_fork_xz - neg_A_79_1;
  A[90] = A[79];
  const Scalar t_right_hip_fork_11 = t_right_foot_3 + left_foot_I7 * s_right_foot;
  const Scalar t_right_hip_fork_12 = t_right_thigh_2 - s_q8_q9_q10 * t_righ_ankl_cros_17;
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_12 + s_right_hip_pitch * t_right_shank_6;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_13 + s_q8_q9 * t_righ_ankl_cros_18;
  A[91] = left_hip_fork_I4 + t_right_hip_fork_11 - t_right_hip_fork_14;
  const Scalar A_78_1 = t_right_hip_fork_14 - (left_hip_fork_I5 - t_right_hip_fork_11);
  const Scalar A_78_2 = s_right_hip_roll * (left_hip_fork_I3 + 2.0f * E_right_thigh_xz);
  const Scalar h_right_thigh_y_1 = h_right_shank_y - left_thigh_I1 * s_right_hip_pitch;
  const Scalar h_right_thigh_y = h_right_thigh_y_1 - left_thigh_I2 * c_right_hip_pitch;
  // right_hip_block: A of (2)
  const Scalar A_78_3 = left_hip_block_I1 - t_right_thigh_4;
  const Scalar A_78_4 = A_78_3 + c_right_hip_roll * (c_right_hip_roll * A_78_1 - A_78_2);
  A[78] = A_78_4 + 2.0f * h_right_thigh_y;
  const Scalar t_left_foot_1 = left_foot_I1 * c_left_foot;
  const Scalar h_left_ankle_cross_z = left_foot_I1 * s_left_foot;
  // left_foot: A of (2)
  const Scalar t_left_foot_2 = left_foot_I4 * c_left_foot + left_foot_I5 * s_left_foot;
  const Scalar t_left_foot_3 = s_left_foot * t_left_foot_2;
  const Scalar neg_A_53 = left_foot_I2 * c_left_foot + left_foot_I3 * s_left_foot;
  A[53] = -neg_A_53;
  A[64] = A[53];
  const Scalar t_left_foot_4 = left_foot_I3 * c_left_foot - left_foot_I2 * s_left_foot;
  // left_ankle_cross: first moment h, A, pseudo-inertia E of (2)
  const Scalar h_left_ankle_cross_x = left_ankle_cross_I1 + t_left_foot_1;
  const Scalar t_left_ankle_cross_1 = s_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_2 = left_ankle_cross_I3 * c_q2_q3_q4 - t_left_ankle_cross_1;
  const Scalar t_left_ankle_cross_3 = c_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = left_ankle_cross_I3 * s_q2_q3_q4 + t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_5 = left_ankle_cross_I4 + h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_6 = left_foot_I6 + t_left_foot_2;
  const Scalar E_left_ankle_cross_xz = t_left_ankle_cross_5 + c_left_foot * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_7 = left_ankle_cross_I2 + neg_A_53;
  const Scalar A_16 = s_q2_q3_q4 * E_left_ankle_cross_xz - c_q2_q3_q4 * t_left_ankle_cross_7;
  A[16] = A_16;
  A[49] = A[16];
  const Scalar t_left_ankle_cross_8 = neg_s_left_ankle_cross_y * t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_9 = neg_s_left_ankle_cross_x * t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_10 = t_left_foot_3 - left_foot_I8 * c_left_foot;
  const Scalar A_52 = left_ankle_cross_I6 - t_left_ankle_cross_10;
  A[52] = A_52;
  // left_shank: pseudo-inertia E, A, first moment h of (2)
  const Scalar t_left_shank_1 = left_shank_I5 + left_foot_I11 * s_left_foot;
  const Scalar neg_E_left_shank_yz = A_16 + left_shank_I6 * c_q2_q3 + s_q2_q3 * t_left_shank_1;
  A[15] = neg_E_left_shank_yz;
  A[37] = A[15];
  const Scalar t_left_shank_2 = t_left_ankle_cross_10 - 2.0f * t_left_ankle_cross_9;
  const Scalar t_left_shank_3 = t_left_shank_2 + 2.0f * t_left_ankle_cross_8;
  const Scalar A_39 = left_shank_I7 - t_left_shank_3;
  A[39] = A_39;
  const Scalar neg_h_left_shank_x_1 = t_left_ankle_cross_4 - left_shank_I1 * s_q2_q3;
  const Scalar neg_h_left_shank_x = neg_h_left_shank_x_1 + left_shank_I2 * c_q2_q3;
  const Scalar t_left_shank_4 = neg_s_left_shank_x * neg_h_left_shank_x;
  const Scalar t_left_shank_5 = 2.0f * t_left_shank_4;
  const Scalar h_left_shank_y_1 = t_left_ankle_cross_2 - left_shank_I2 * s_q2_q3;
  const Scalar h_left_shank_y = h_left_shank_y_1 - left_shank_I1 * c_q2_q3;
  const Scalar t_left_shank_6 = neg_s_left_shank_y * h_left_shank_y;
  const Scalar t_left_thigh_1 = left_thigh_I5 + left_foot_I10 * s_left_foot;
  const Scalar t_left_ankle_cross_11 = s_q2_q3_q4 * t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_12 = c_q2_q3_q4 * E_left_ankle_cross_xz + t_left_ankle_cross_11;
  const Scalar neg_E_left_shank_xz_1 = t_left_ankle_cross_12 - left_shank_I6 * s_q2_q3;
  const Scalar neg_E_left_shank_xz = neg_E_left_shank_xz_1 + c_q2_q3 * t_left_shank_1;
  // left_thigh: pseudo-inertia E, A of (2)
  const Scalar neg_E_left_thigh_xz_1 = neg_E_left_shank_xz - left_thigh_I6 * s_left_hip_pitch;
  const Scalar neg_E_left_thigh_xz = neg_E_left_thigh_xz_1 + c_left_hip_pitch * t_left_thigh_1;
  const Scalar neg_E_left_thigh_yz_1 = neg_E_left_shank_yz + left_thigh_I6 * c_left_hip_pitch;
  const Scalar neg_E_left_thigh_yz = neg_E_left_thigh_yz_1 + s_left_hip_pitch * t_left_thigh_1;
  A[14] = neg_E_left_thigh_yz;
  A[25] = A[14];
  const Scalar t_left_thigh_2 = t_left_shank_3 - t_left_shank_5 + 2.0f * t_left_shank_6;
  const Scalar A_26 = left_thigh_I7 - t_left_thigh_2;
  A[26] = A_26;
  const Scalar t_left_ankle_cross_13 = left_shank_I3 * c_q2_q3 + left_shank_I4 * s_q2_q3;
  const Scalar E_left_hip_fork_yz = neg_E_left_thigh_yz - (left_hip_fork_I1 + h_left_ankle_cross_z);
  // left_ankle_cross
  const Scalar t_left_ankle_cross_14 = s_q2_q3_q4 * (left_ankle_cross_I5 + t_left_ankle_cross_10);
  const Scalar t_left_ankle_cross_15 = left_ankle_cross_I7 + 2.0f * t_left_foot_4;
  const Scalar t_left_ankle_cross_16 = t_left_ankle_cross_14 + c_q2_q3_q4 * t_left_ankle_cross_15;
  const Scalar t_left_shank_7 = left_thigh_I4 * c_left_hip_pitch;
  const Scalar t_left_shank_8 = t_left_shank_7 + left_thigh_I3 * s_left_hip_pitch;
  // left_hip_fork: pseudo-inertia E, A of (2)
  const Scalar t_left_hip_fork_1 = left_hip_fork_I2 - t_left_foot_4 + neg_h_left_shank_x;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + c_q2_q3_q4 * t_left_ankle_cross_16;
  const Scalar t_left_hip_fork_3 = left_thigh_I2 + left_hip_fork_k1 * neg_h_left_shank_x;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_2 + neg_s_left_shank_x * h_left_shank_y;
  const Scalar t_left_hip_fork_5 = t_left_ankle_cross_13 - left_hip_fork_k2 * t_left_ankle_cross_2;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_4 - s_left_hip_pitch * t_left_hip_fork_3;
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_6 - c_q2_q3 * t_left_hip_fork_5;
  const Scalar t_left_hip_fork_8 = left_thigh_I1 - t_left_shank_8;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_7 + c_left_hip_pitch * t_left_hip_fork_8;
  const Scalar neg_E_left_hip_fork_xz =
      t_left_hip_fork_9 - neg_s_left_ankle_cross_y * t_left_ankle_cross_4;
  A[1] = s_left_hip_roll * E_left_hip_fork_yz + c_left_hip_roll * neg_E_left_hip_fork_xz;
  A[12] = A[1];
  const Scalar t_left_hip_fork_10 = t_left_foot_3 + left_foot_I7 * s_left_foot;
  const Scalar t_left_hip_fork_11 = t_left_shank_2 - t_left_shank_5;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_11 + s_left_hip_pitch * t_left_shank_8;
  const Scalar t_left_hip_fork_13 = t_left_hip_fork_12 - s_q2_q3_q4 * t_left_ankle_cross_16;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_13 + s_q2_q3 * t_left_ankle_cross_13;
  A[13] = left_hip_fork_I4 + t_left_hip_fork_10 - t_left_hip_fork_14;
  const Scalar h_left_thigh_y_1 = h_left_shank_y - left_thigh_I1 * s_left_hip_pitch;
  const Scalar h_left_thigh_y = h_left_thigh_y_1 - left_thigh_I2 * c_left_hip_pitch;
  const Scalar A_0_1 = t_left_hip_fork_14 - (left_hip_fork_I5 - t_left_hip_fork_10);
  const Scalar A_0_2 = s_left_hip_roll * (left_hip_fork_I3 + 2.0f * neg_E_left_thigh_xz);
  const Scalar A_0_3 = left_hip_block_I1 - t_left_thigh_2 + 2.0f * h_left_thigh_y;
  A[0] = A_0_3 + c_left_hip_roll * (A_0_2 + c_left_hip_roll * A_0_1);
  // right_ankle_cross: A of (2)
  const Scalar t_righ_ankl_cros_19 = c_q8_q9_q10 * neg_h_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_20 = s_q8_q9_q10 * neg_h_righ_ankl_cros_z;
  const Scalar A_119_1 = A_131 - neg_s_righ_ankl_cros_y * t_righ_ankl_cros_19;
  const Scalar A_119 = A_119_1 + neg_s_righ_ankl_cros_x * t_righ_ankl_cros_20;
  A[119] = A_119;
  A[141] = A[119];
  const Scalar t_right_foot_5 = left_foot_I9 + t_right_foot_1 + left_foot_I6 * s_right_foot;
  // right_shank: A of (2)
  const Scalar A_95_1 = t_right_foot_1 * (neg_s_right_shank_x + neg_s_righ_ankl_cros_x);
  A[95] = c_q8_q9_q10 * t_right_foot_5 + A_95_1 - s_q8_q9_q10 * t_right_foot_4;
  A[139] = A[95];
  const Scalar A_107_1 = A_119 + neg_s_right_shank_x * t_righ_ankl_cros_20;
  const Scalar A_107 = A_107_1 - neg_s_right_shank_y * t_righ_ankl_cros_19;
  A[107] = A_107;
  A[140] = A[107];
  const Scalar neg_A_83_1 = neg_s_righ_ankl_cros_y - (1.0f - neg_s_right_shank_y);
  const Scalar neg_A_83_2 = t_righ_ankl_cros_13 + s_q8_q9_q10 * t_right_foot_5;
  const Scalar neg_A_83_3 = c_right_hip_roll * (neg_A_83_2 + t_right_foot_1 * neg_A_83_1);
  A[83] = s_right_hip_roll * (t_righ_ankl_cros_19 + A_107) - neg_A_83_3;
  A[138] = A[83];
  const Scalar A_118 = t_righ_ankl_cros_7 - t_righ_ankl_cros_8 + A_130;
  A[118] = A_118;
  A[129] = A[118];
  const Scalar A_106_1 = A_118 - neg_s_right_shank_y * t_righ_ankl_cros_4;
  const Scalar A_106 = A_106_1 + neg_s_right_shank_x * t_righ_ankl_cros_2;
  A[106] = A_106;
  A[128] = A[106];
  const Scalar neg_A_82_1 = s_right_hip_roll * (t_righ_ankl_cros_4 + A_106);
  A[82] = neg_A_82_1 - c_right_hip_roll * t_righ_ankl_cros_12;
  A[126] = A[82];
  const Scalar neg_A_105 = neg_A_117 - t_right_shank_3 + t_right_shank_4;
  A[105] = -neg_A_105;
  A[116] = A[105];
  A[81] = s_right_hip_roll * (h_right_shank_y - neg_A_105) - c_right_hip_roll * E_right_shank_xz;
  A[114] = A[81];
  A[80] = s_right_hip_roll * (A_104 + h_right_thigh_y) - c_right_hip_roll * E_right_thigh_xz;
  A[102] = A[80];
  // left_ankle_cross: A of (2)
  const Scalar t_left_ankle_cross_17 = s_q2_q3_q4 * h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_18 = c_q2_q3_q4 * h_left_ankle_cross_z;
  const Scalar neg_A_41_1 = neg_A_53 + neg_s_left_ankle_cross_x * t_left_ankle_cross_17;
  const Scalar neg_A_41 = neg_A_41_1 - neg_s_left_ankle_cross_y * t_left_ankle_cross_18;
  A[41] = -neg_A_41;
  A[63] = A[41];
  const Scalar t_left_foot_5 = left_foot_I9 + t_left_foot_1 + left_foot_I6 * s_left_foot;
  const Scalar A_17_1 = c_q2_q3_q4 * t_left_foot_5 + s_q2_q3_q4 * t_left_foot_4;
  // left_shank: A of (2)
  A[17] = A_17_1 + t_left_foot_1 * (neg_s_left_shank_x + neg_s_left_ankle_cross_x);
  A[61] = A[17];
  const Scalar neg_A_29_1 = neg_A_41 - neg_s_left_shank_y * t_left_ankle_cross_18;
  const Scalar neg_A_29 = neg_A_29_1 + neg_s_left_shank_x * t_left_ankle_cross_17;
  A[29] = -neg_A_29;
  A[62] = A[29];
  const Scalar neg_A_5_1 = neg_s_left_ankle_cross_y - (1.0f - neg_s_left_shank_y);
  const Scalar neg_A_5_2 = c_q2_q3_q4 * t_left_foot_4 - s_q2_q3_q4 * t_left_foot_5;
  const Scalar neg_A_5_3 = c_left_hip_roll * (neg_A_5_2 - t_left_foot_1 * neg_A_5_1);
  A[5] = neg_A_5_3 - s_left_hip_roll * (t_left_ankle_cross_18 + neg_A_29);
  A[60] = A[5];
  const Scalar A_40 = A_52 - (t_left_ankle_cross_8 - t_left_ankle_cross_9);
  A[40] = A_40;
  A[51] = A[40];
  const Scalar A_28_1 = A_40 - neg_s_left_shank_y * t_left_ankle_cross_2;
  const Scalar A_28 = A_28_1 + neg_s_left_shank_x * t_left_ankle_cross_4;
  A[28] = A_28;
  A[50] = A[28];
  const Scalar A_4_1 = s_left_hip_roll * (t_left_ankle_cross_2 + A_28);
  A[4] = A_4_1 + c_left_hip_roll * t_left_ankle_cross_12;
  A[48] = A[4];
  const Scalar neg_A_27 = t_left_shank_6 - (A_39 + t_left_shank_4);
  A[27] = -neg_A_27;
  A[38] = A[27];
  // left_hip_fork: A of (2)
  A[3] = c_left_hip_roll * neg_E_left_shank_xz + s_left_hip_roll * (h_left_shank_y - neg_A_27);
  A[36] = A[3];
  A[2] = s_left_hip_roll * (A_26 + h_left_thigh_y) + c_left_hip_roll * neg_E_left_thigh_xz;
  A[24] = A[2];
  A[65] = left_foot_I9;
  A[143] = left_foot_I9;
  mass_matrix_0(A);
}

void bias_force(const Scalar q[12], const Scalar qd[12], Scalar B[12]) noexcept {
  const Scalar q_q3_q4 = q[3] + q[4];
  const Scalar q_q2_q3_q4 = q[2] + q_q3_q4;
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const Scalar angle_left_foot = left_foot_k1 + q[5];
  const Scalar angle_right_foot = left_foot_k1 - q[11];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q_q2_q3_q4, q[1], q_q3_q4, q[4], q_q8_q9_q10, q[7], q_q9_q10,
                q[10]);
  sines_cosines(sines + 8, cosines + 8, angle_left_foot, angle_right_foot);
  const Scalar s_q2_q3_q4 = sines[0];
  const Scalar c_q2_q3_q4 = cosines[0];
  const Scalar s_left_hip_roll = sines[1];
  const Scalar c_left_hip_roll = cosines[1];
  const Scalar s_q3_q4 = sines[2];
  const Scalar c_q3_q4 = cosines[2];
  const Scalar s_left_ankle_pitch = sines[3];
  const Scalar c_left_ankle_pitch = cosines[3];
  const Scalar s_q8_q9_q10 = sines[4];
  const Scalar c_q8_q9_q10 = cosines[4];
  const Scalar s_right_hip_roll = sines[5];
  const Scalar c_right_hip_roll = cosines[5];
  const Scalar s_q9_q10 = sines[6];
  const Scalar c_q9_q10 = cosines[6];
  const Scalar s_right_ankle_pitch = sines[7];
  const Scalar c_right_ankle_pitch = cosines[7];
  const Scalar s_left_foot = sines[8];
  const Scalar c_left_foot = cosines[8];
  const Scalar s_right_foot = sines[9];
  const Scalar c_right_foot = cosines[9];
  const Scalar neg_s_left_shank_y = left_shank_l1 * s_q3_q4;
  const Scalar s_left_shank_x = left_shank_l1 * c_q3_q4;
  const Scalar neg_s_left_ankle_cross_y = left_ankle_cross_l1 * s_left_ankle_pitch;
  const Scalar s_left_ankle_cross_x = left_ankle_cross_l1 * c_left_ankle_pitch;
  const Scalar neg_s_right_shank_y = left_shank_l1 * s_q9_q10;
  const Scalar s_right_shank_x = left_shank_l1 * c_q9_q10;
  const Scalar neg_s_righ_ankl_cros_y = left_ankle_cross_l1 * s_right_ankle_pitch;
  const Scalar s_righ_ankl_cros_x = left_ankle_cross_l1 * c_right_ankle_pitch;
  // left_thigh: angular velocity omega, Omega, angular acceleration alpha of (3)
  const Scalar t_left_thigh_1 = s_q2_q3_q4 * qd[1];
  const Scalar t_left_thigh_2 = c_left_hip_roll * qd[0];
  const Scalar neg_omega_left_thigh_x = t_left_thigh_1 + c_q2_q3_q4 * t_left_thigh_2;
  const Scalar t_left_thigh_3 = neg_omega_left_thigh_x * neg_omega_left_thigh_x;
  const Scalar t_left_thigh_4 = c_q2_q3_q4 * qd[1];
  const Scalar neg_omega_left_thigh_y = t_left_thigh_4 - s_q2_q3_q4 * t_left_thigh_2;
  const Scalar t_left_thigh_5 = neg_omega_left_thigh_y * neg_omega_left_thigh_y;
  const Scalar neg_Omega_left_thigh_zz = t_left_thigh_3 + t_left_thigh_5;
  const Scalar t_left_thigh_6 = s_left_hip_roll * qd[0];
  const Scalar omega_left_thigh_z = t_left_thigh_6 + qd[2];
  const Scalar t_left_thigh_7 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar neg_Omega_left_thigh_xx = t_left_thigh_5 + t_left_thigh_7;
  const Scalar t_left_thigh_8 = neg_omega_left_thigh_y * omega_left_thigh_z;
  const Scalar alpha_left_thigh_x_1 = t_left_thigh_4 * t_left_thigh_6;
  const Scalar alpha_left_thigh_x = alpha_left_thigh_x_1 - neg_omega_left_thigh_y * qd[2];
  const Scalar neg_Omega_left_thigh_zy = t_left_thigh_8 - alpha_left_thigh_x;
  const Scalar t_left_thigh_9 = neg_omega_left_thigh_x * omega_left_thigh_z;
  const Scalar t_left_thigh_10 = t_left_thigh_1 * t_left_thigh_6;
  const Scalar neg_alpha_left_thigh_y = t_left_thigh_10 - neg_omega_left_thigh_x * qd[2];
  const Scalar neg_Omega_left_foot_xy = t_left_thigh_9 + neg_alpha_left_thigh_y;
  const Scalar neg_Omega_left_thigh_zx = t_left_thigh_9 - neg_alpha_left_thigh_y;
  const Scalar neg_Omega_left_thigh_yz = t_left_thigh_8 + alpha_left_thigh_x;
  const Scalar t_left_thigh_11 = neg_omega_left_thigh_x * neg_omega_left_thigh_y;
  const Scalar alpha_left_thigh_z = qd[1] * t_left_thigh_2;
  const Scalar Omega_left_thigh_yx = t_left_thigh_11 + alpha_left_thigh_z;
  const Scalar Omega_left_thigh_xy = t_left_thigh_11 - alpha_left_thigh_z;
  const Scalar t_left_thigh_12 = qd[0] * qd[0] * left_hip_fork_l1;
  const Scalar a_left_thigh_y = c_q2_q3_q4 * t_left_thigh_12;
  const Scalar a_left_thigh_x = s_q2_q3_q4 * t_left_thigh_12;
  const Scalar t_left_thigh_13 = left_thigh_I8 * c_q3_q4 + left_thigh_I6 * s_q3_q4;
  const Scalar t_left_thigh_14 = left_thigh_I9 * s_q3_q4 - left_thigh_I4 * c_q3_q4;
  const Scalar t_left_thigh_15 = s_q3_q4 * t_left_thigh_14;
  const Scalar t_left_thigh_16 = left_thigh_I8 * s_q3_q4 - left_thigh_I6 * c_q3_q4;
  const Scalar t_left_thigh_17 = t_left_thigh_3 - t_left_thigh_5;
  const Scalar t_left_thigh_18 = left_thigh_I12 + c_q3_q4 * t_left_thigh_14;
  const Scalar t_left_thigh_19 = left_thigh_h1 * c_q3_q4 - left_thigh_h2 * s_q3_q4;
  const Scalar t_left_thigh_20 = left_thigh_h2 * c_q3_q4 + left_thigh_h1 * s_q3_q4;
  // left_shank: angular velocity omega, Omega, moment M of (3)
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_1 = 2.0f * neg_omega_left_thigh_y;
  const Scalar Omega_left_shank_zy = neg_Omega_left_thigh_yz - omega_left_shank_z * t_left_shank_1;
  const Scalar t_left_shank_2 = 2.0f * neg_omega_left_thigh_x;
  const Scalar Omega_left_shank_zx = neg_Omega_left_foot_xy - omega_left_shank_z * t_left_shank_2;
  const Scalar t_left_shank_3 = omega_left_shank_z * omega_left_shank_z;
  const Scalar neg_Omega_left_shank_xx = t_left_thigh_5 + t_left_shank_3;
  const Scalar t_left_shank_4 = left_shank_I3 * c_left_ankle_pitch;
  const Scalar t_left_shank_5 = t_left_shank_4 - left_shank_I8 * s_left_ankle_pitch;
  const Scalar t_left_shank_6 = left_shank_I9 - c_left_ankle_pitch * t_left_shank_5;
  const Scalar t_left_shank_7 = s_left_ankle_pitch * t_left_shank_5;
  const Scalar t_left_shank_8 = left_shank_I11 * c_left_ankle_pitch;
  const Scalar t_left_shank_9 = t_left_shank_8 + left_shank_I6 * s_left_ankle_pitch;
  const Scalar t_left_shank_10 = left_shank_I11 * s_left_ankle_pitch;
  const Scalar t_left_shank_11 = t_left_shank_10 - left_shank_I6 * c_left_ankle_pitch;
  const Scalar t_left_shank_12 = left_shank_h1 * s_left_ankle_pitch;
  const Scalar t_left_shank_13 = t_left_shank_12 - left_shank_h2 * c_left_ankle_pitch;
  const Scalar t_left_shank_14 = left_shank_I12 + t_left_shank_7;
  const Scalar t_left_shank_15 = left_shank_h1 * c_left_ankle_pitch;
  const Scalar t_left_shank_16 = t_left_shank_15 + left_shank_h2 * s_left_ankle_pitch;
  // left_ankle_cross: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_1 = Omega_left_shank_zy - t_left_shank_1 * qd[4];
  const Scalar t_left_ankle_cross_2 = Omega_left_shank_zx - t_left_shank_2 * qd[4];
  const Scalar t_left_ankle_cross_3 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar a_left_shank_z_1 = neg_s_left_shank_y * neg_Omega_left_thigh_zy;
  const Scalar a_left_shank_z = a_left_shank_z_1 - s_left_shank_x * neg_Omega_left_thigh_zx;
  const Scalar a_left_ankle_cross_z_1 = a_left_shank_z + s_left_ankle_cross_x * Omega_left_shank_zx;
  const Scalar a_left_ankle_cross_z =
      a_left_ankle_cross_z_1 - neg_s_left_ankle_cross_y * Omega_left_shank_zy;
  const Scalar a_left_foot_y_1 = a_left_ankle_cross_z - left_hip_fork_l2 * neg_Omega_left_thigh_zz;
  const Scalar a_left_foot_y = a_left_foot_y_1 + left_hip_fork_l1 * t_left_ankle_cross_2;
  const Scalar a_left_shank_x_1 = a_left_thigh_x - s_left_shank_x * neg_Omega_left_thigh_xx;
  const Scalar a_left_shank_x = a_left_shank_x_1 - neg_s_left_shank_y * Omega_left_thigh_xy;
  const Scalar a_left_ankle_cross_x_1 =
      a_left_shank_x - s_left_ankle_cross_x * neg_Omega_left_shank_xx;
  const Scalar a_left_ankle_cross_x =
      a_left_ankle_cross_x_1 - neg_s_left_ankle_cross_y * Omega_left_thigh_xy;
  const Scalar a_left_foot_x_1 = a_left_ankle_cross_x - left_hip_fork_l2 * neg_Omega_left_foot_xy;
  const Scalar a_left_foot_x_2 = t_left_thigh_5 + t_left_ankle_cross_3;
  const Scalar a_left_foot_x = a_left_foot_x_1 - left_hip_fork_l1 * a_left_foot_x_2;
  const Scalar neg_Omega_left_thigh_yy = t_left_thigh_3 + t_left_thigh_7;
  const Scalar a_left_shank_y_1 = a_left_thigh_y + neg_s_left_shank_y * neg_Omega_left_thigh_yy;
  const Scalar a_left_shank_y = a_left_shank_y_1 + s_left_shank_x * Omega_left_thigh_yx;
  const Scalar t_left_foot_1 = left_hip_fork_l1 + s_left_ankle_cross_x;
  const Scalar neg_Omega_left_shank_yy = t_left_thigh_3 + t_left_shank_3;
  // left_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar neg_a_left_foot_z_1 = a_left_shank_y - left_hip_fork_l2 * neg_Omega_left_thigh_yz;
  const Scalar neg_a_left_foot_z_2 =
      neg_a_left_foot_z_1 + neg_s_left_ankle_cross_y * neg_Omega_left_shank_yy;
  const Scalar neg_a_left_foot_z = neg_a_left_foot_z_2 + Omega_left_thigh_yx * t_left_foot_1;
  const Scalar omega_left_foot_z = neg_omega_left_thigh_y + qd[5];
  const Scalar Omega_left_foot_zy_1 = omega_left_ankle_cross_z * omega_left_foot_z;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_1 + 2.0f * Omega_left_foot_zy_1;
  const Scalar t_left_foot_2 = omega_left_foot_z * omega_left_foot_z;
  const Scalar Omega_left_foot_zx = Omega_left_thigh_xy - t_left_shank_2 * omega_left_foot_z;
  const Scalar t_left_foot_3 = left_foot_h1 * c_left_foot;
  const Scalar t_left_foot_4 = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_5 = left_foot_I4 * c_left_foot + left_foot_I5 * s_left_foot;
  const Scalar t_left_foot_6 = s_left_foot * t_left_foot_5;
  const Scalar t_left_foot_7 = left_foot_I12 - t_left_foot_6;
  const Scalar t_left_foot_8 = left_foot_I3 * c_left_foot - left_foot_I2 * s_left_foot;
  const Scalar t_left_foot_9 = left_foot_I2 * c_left_foot + left_foot_I3 * s_left_foot;
  const Scalar t_left_foot_10 = left_foot_I13 + t_left_foot_6;
  const Scalar t_left_foot_11 = left_foot_I14 - c_left_foot * t_left_foot_5;
  const Scalar t_left_ankle_cross_4 = t_left_thigh_3 - t_left_ankle_cross_3;
  const Scalar M_left_foot_z_1 = neg_Omega_left_foot_xy * t_left_foot_10;
  const Scalar M_left_foot_z_2 = a_left_foot_y * t_left_foot_3 + M_left_foot_z_1;
  const Scalar M_left_foot_z_3 = M_left_foot_z_2 + t_left_foot_11 * t_left_ankle_cross_4;
  const Scalar M_left_foot_z_4 = M_left_foot_z_3 + Omega_left_thigh_xy * t_left_foot_9;
  const Scalar M_left_foot_z_5 = M_left_foot_z_4 - a_left_foot_x * t_left_foot_4;
  const Scalar M_left_foot_z_6 = M_left_foot_z_5 + t_left_ankle_cross_2 * t_left_foot_7;
  const Scalar M_left_foot_z = M_left_foot_z_6 - t_left_ankle_cross_1 * t_left_foot_8;
  B[5] = M_left_foot_z;
  const Scalar neg_F_left_foot_z_1 = left_ankle_cross_m1 * neg_a_left_foot_z;
  const Scalar neg_F_left_foot_z_2 = neg_F_left_foot_z_1 - Omega_left_foot_zx * t_left_foot_3;
  const Scalar neg_F_left_foot_z = neg_F_left_foot_z_2 - Omega_left_foot_zy * t_left_foot_4;
  const Scalar t_right_hip_fork_1 = left_hip_fork_I6 * c_right_hip_roll;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 - left_hip_fork_I3 * s_right_hip_roll;
  // right_thigh: angular velocity omega, Omega, angular acceleration alpha of (3)
  const Scalar t_right_thigh_1 = s_q8_q9_q10 * qd[7];
  const Scalar t_right_thigh_2 = c_right_hip_roll * qd[6];
  const Scalar neg_omega_right_thigh_x = t_right_thigh_1 + c_q8_q9_q10 * t_right_thigh_2;
  const Scalar t_right_thigh_3 = s_right_hip_roll * qd[6];
  const Scalar omega_right_thigh_z = qd[8] + t_right_thigh_3;
  const Scalar t_right_thigh_4 = neg_omega_right_thigh_x * omega_right_thigh_z;
  const Scalar t_right_thigh_5 = t_right_thigh_1 * t_right_thigh_3;
  const Scalar neg_alpha_right_thigh_y = t_right_thigh_5 - neg_omega_right_thigh_x * qd[8];
  const Scalar neg_Omega_right_foot_xy = t_right_thigh_4 + neg_alpha_right_thigh_y;
  const Scalar t_right_thigh_6 = c_q8_q9_q10 * qd[7];
  const Scalar neg_omega_right_thigh_y = t_right_thigh_6 - s_q8_q9_q10 * t_right_thigh_2;
  const Scalar t_right_thigh_7 = omega_right_thigh_z * neg_omega_right_thigh_y;
  const Scalar alpha_right_thigh_x_1 = t_right_thigh_3 * t_right_thigh_6;
  const Scalar alpha_right_thigh_x = alpha_right_thigh_x_1 - qd[8] * neg_omega_right_thigh_y;
  const Scalar neg_Omega_right_thigh_yz = t_right_thigh_7 + alpha_right_thigh_x;
  const Scalar t_right_thigh_8 = neg_omega_right_thigh_y * neg_omega_right_thigh_y;
  const Scalar t_right_thigh_9 = neg_omega_right_thigh_x * neg_omega_right_thigh_x;
  const Scalar neg_Omega_right_thigh_zz = t_right_thigh_8 + t_right_thigh_9;
  const Scalar t_right_thigh_10 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar neg_Omega_right_thigh_xx = t_right_thigh_8 + t_right_thigh_10;
  const Scalar neg_Omega_right_thigh_zx = t_right_thigh_4 - neg_alpha_right_thigh_y;
  const Scalar neg_Omega_right_thigh_zy = t_right_thigh_7 - alpha_right_thigh_x;
  const Scalar neg_Omega_right_thigh_yy = t_right_thigh_9 + t_right_thigh_10;
  const Scalar t_right_thigh_11 = neg_omega_right_thigh_x * neg_omega_right_thigh_y;
  const Scalar alpha_right_thigh_z = qd[7] * t_right_thigh_2;
  const Scalar Omega_right_thigh_xy = t_right_thigh_11 - alpha_right_thigh_z;
  const Scalar Omega_right_thigh_yx = t_right_thigh_11 + alpha_right_thigh_z;
  const Scalar t_right_thigh_12 = qd[6] * qd[6] * left_hip_fork_l1;
  const Scalar a_right_thigh_x = s_q8_q9_q10 * t_right_thigh_12;
  const Scalar a_right_thigh_y = c_q8_q9_q10 * t_right_thigh_12;
  const Scalar t_right_thigh_13 = left_thigh_I6 * s_q9_q10 + left_thigh_I8 * c_q9_q10;
  const Scalar t_right_thigh_14 = left_thigh_I9 * s_q9_q10 - left_thigh_I4 * c_q9_q10;
  const Scalar t_right_thigh_15 = s_q9_q10 * t_right_thigh_14;
  const Scalar t_right_thigh_16 = left_thigh_I8 * s_q9_q10 - left_thigh_I6 * c_q9_q10;
  const Scalar t_right_thigh_17 = left_thigh_I11 + t_right_thigh_15;
  const Scalar t_right_shank_1 = t_right_thigh_8 - t_right_thigh_9;
  const Scalar t_right_thigh_18 = left_thigh_I12 + c_q9_q10 * t_right_thigh_14;
  const Scalar t_right_thigh_19 = left_thigh_h2 * s_q9_q10 - left_thigh_h1 * c_q9_q10;
  const Scalar t_right_thigh_20 = left_thigh_h2 * c_q9_q10 + left_thigh_h1 * s_q9_q10;
  // right_shank: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar Omega_right_shank_zy_1 = neg_omega_right_thigh_y * omega_right_shank_z;
  const Scalar Omega_right_shank_zy = neg_Omega_right_thigh_yz - 2.0f * Omega_right_shank_zy_1;
  const Scalar t_right_shank_2 = 2.0f * neg_omega_right_thigh_x;
  const Scalar Omega_right_shank_zx =
      neg_Omega_right_foot_xy - omega_right_shank_z * t_right_shank_2;
  const Scalar neg_a_right_shank_z_1 = neg_s_right_shank_y * neg_Omega_right_thigh_zy;
  const Scalar neg_a_right_shank_z =
      s_right_shank_x * neg_Omega_right_thigh_zx - neg_a_right_shank_z_1;
  const Scalar t_right_shank_3 = omega_right_shank_z * omega_right_shank_z;
  const Scalar neg_Omega_right_shank_xx = t_right_thigh_8 + t_right_shank_3;
  const Scalar neg_Omega_right_shank_yy = t_right_thigh_9 + t_right_shank_3;
  const Scalar t_right_shank_4 = left_shank_I8 * s_right_ankle_pitch;
  const Scalar t_right_shank_5 = t_right_shank_4 - left_shank_I3 * c_right_ankle_pitch;
  const Scalar t_right_shank_6 = left_shank_I9 + c_right_ankle_pitch * t_right_shank_5;
  const Scalar t_right_shank_7 = left_shank_I11 * s_right_ankle_pitch;
  const Scalar t_right_shank_8 = t_right_shank_7 - left_shank_I6 * c_right_ankle_pitch;
  const Scalar t_right_shank_9 = s_right_ankle_pitch * t_right_shank_5;
  const Scalar t_right_shank_10 = left_shank_I12 - t_right_shank_9;
  const Scalar t_right_shank_11 = left_shank_I11 * c_right_ankle_pitch;
  const Scalar t_right_shank_12 = t_right_shank_11 + left_shank_I6 * s_right_ankle_pitch;
  const Scalar t_right_shank_13 = left_shank_h2 * s_right_ankle_pitch;
  const Scalar t_right_shank_14 = t_right_shank_13 + left_shank_h1 * c_right_ankle_pitch;
  const Scalar t_right_shank_15 = left_shank_h2 * c_right_ankle_pitch;
  const Scalar t_right_shank_16 = t_right_shank_15 - left_shank_h1 * s_right_ankle_pitch;
  // right_ankle_cross: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_1 = 2.0f * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_zy =
      neg_Omega_right_thigh_yz - neg_omega_right_thigh_y * t_righ_ankl_cros_1;
  const Scalar Omega_righ_ankl_cros_zx = Omega_right_shank_zx - t_right_shank_2 * qd[10];
  const Scalar t_righ_ankl_cros_2 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_3 = t_right_thigh_8 + t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_4 = neg_Omega_right_thigh_zz - t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_5 =
      neg_a_right_shank_z + neg_s_righ_ankl_cros_y * Omega_right_shank_zy;
  const Scalar neg_a_righ_ankl_cros_z =
      t_righ_ankl_cros_5 - s_righ_ankl_cros_x * Omega_right_shank_zx;
  const Scalar neg_a_right_foot_y_1 =
      neg_a_righ_ankl_cros_z - left_hip_fork_l2 * neg_Omega_right_thigh_zz;
  const Scalar neg_a_right_foot_y =
      neg_a_right_foot_y_1 - left_hip_fork_l1 * Omega_righ_ankl_cros_zx;
  const Scalar a_right_shank_x_1 = a_right_thigh_x - neg_s_right_shank_y * Omega_right_thigh_xy;
  const Scalar a_right_shank_x = a_right_shank_x_1 - s_right_shank_x * neg_Omega_right_thigh_xx;
  const Scalar a_righ_ankl_cros_x_1 =
      a_right_shank_x - neg_s_righ_ankl_cros_y * Omega_right_thigh_xy;
  const Scalar a_righ_ankl_cros_x =
      a_righ_ankl_cros_x_1 - s_righ_ankl_cros_x * neg_Omega_right_shank_xx;
  const Scalar a_right_foot_x_1 = a_righ_ankl_cros_x - left_hip_fork_l1 * t_righ_ankl_cros_3;
  const Scalar a_right_foot_x = a_right_foot_x_1 + left_hip_fork_l2 * neg_Omega_right_foot_xy;
  const Scalar a_right_shank_y_1 = a_right_thigh_y + s_right_shank_x * Omega_right_thigh_yx;
  const Scalar a_right_shank_y = a_right_shank_y_1 + neg_s_right_shank_y * neg_Omega_right_thigh_yy;
  // right_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar neg_a_right_foot_z_1 = a_right_shank_y + left_hip_fork_l2 * neg_Omega_right_thigh_yz;
  const Scalar neg_a_right_foot_z_2 = left_hip_fork_l1 + s_righ_ankl_cros_x;
  const Scalar neg_a_right_foot_z_3 =
      neg_a_right_foot_z_1 + neg_s_righ_ankl_cros_y * neg_Omega_right_shank_yy;
  const Scalar neg_a_right_foot_z =
      neg_a_right_foot_z_3 + Omega_right_thigh_yx * neg_a_right_foot_z_2;
  const Scalar omega_right_foot_z = neg_omega_right_thigh_y + qd[11];
  const Scalar Omega_right_foot_zy =
      Omega_righ_ankl_cros_zy + t_righ_ankl_cros_1 * omega_right_foot_z;
  const Scalar t_right_foot_1 = omega_right_foot_z * omega_right_foot_z;
  const Scalar Omega_right_foot_zx = Omega_right_thigh_xy - t_right_shank_2 * omega_right_foot_z;
  const Scalar t_right_foot_2 = left_foot_h1 * c_right_foot;
  const Scalar t_right_foot_3 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_4 = left_foot_I4 * c_right_foot + left_foot_I5 * s_right_foot;
  const Scalar t_right_foot_5 = s_right_foot * t_right_foot_4;
  const Scalar t_right_foot_6 = left_foot_I12 - t_right_foot_5;
  const Scalar t_right_foot_7 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_8 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_9 = left_foot_I13 + t_right_foot_5;
  const Scalar t_right_foot_10 = left_foot_I14 - c_right_foot * t_right_foot_4;
  const Scalar neg_M_right_foot_z_1 = t_righ_ankl_cros_4 * t_right_foot_10;
  const Scalar neg_M_right_foot_z_2 = neg_a_right_foot_y * t_right_foot_2 + neg_M_right_foot_z_1;
  const Scalar neg_M_right_foot_z_3 = neg_M_right_foot_z_2 - a_right_foot_x * t_right_foot_3;
  const Scalar neg_M_right_foot_z_4 = neg_M_right_foot_z_3 + Omega_right_thigh_xy * t_right_foot_8;
  const Scalar neg_M_right_foot_z_5 =
      neg_M_right_foot_z_4 - neg_Omega_right_foot_xy * t_right_foot_9;
  const Scalar neg_M_right_foot_z_6 =
      neg_M_right_foot_z_5 - Omega_righ_ankl_cros_zy * t_right_foot_7;
  const Scalar neg_M_right_foot_z = neg_M_right_foot_z_6 - Omega_righ_ankl_cros_zx * t_right_foot_6;
  B[11] = -neg_M_right_foot_z;
  const Scalar neg_F_right_foot_z_1 = Omega_right_foot_zy * t_right_foot_3;
  const Scalar neg_F_right_foot_z_2 = neg_F_right_foot_z_1 - Omega_right_foot_zx * t_right_foot_2;
  const Scalar neg_F_right_foot_z = neg_F_right_foot_z_2 + left_ankle_cross_m1 * neg_a_right_foot_z;
  const Scalar t_right_foot_11 = left_ankle_cross_I2 + t_right_foot_8;
  const Scalar t_righ_ankl_cros_6 = left_ankle_cross_I8 * t_right_shank_1;
  const Scalar t_right_foot_12 = t_righ_ankl_cros_6 - neg_a_right_foot_z * t_right_foot_2;
  const Scalar t_right_foot_13 = t_right_foot_12 - left_ankle_cross_h1 * a_righ_ankl_cros_x;
  const Scalar t_right_foot_14 = t_right_foot_13 - left_hip_fork_l1 * neg_F_right_foot_z;
  const Scalar t_right_foot_15 = t_right_foot_14 - left_ankle_cross_I10 * neg_Omega_right_thigh_yz;
  const Scalar t_right_foot_16 = t_right_foot_15 + Omega_right_foot_zx * t_right_foot_6;
  const Scalar t_right_foot_17 = t_right_foot_16 - neg_Omega_right_foot_xy * t_right_foot_11;
  const Scalar t_right_foot_18 = t_right_thigh_9 - t_right_foot_1;
  const Scalar t_right_foot_19 = t_right_foot_17 + t_right_foot_7 * t_right_foot_18;
  const Scalar t_right_foot_20 = t_right_foot_19 + left_ankle_cross_I9 * Omega_right_thigh_xy;
  const Scalar t_right_foot_21 = t_right_foot_20 + Omega_right_foot_zy * t_right_foot_10;
  const Scalar neg_M_righ_ankl_cros_z =
      t_right_foot_21 - left_ankle_cross_I11 * Omega_right_thigh_yx;
  B[10] = -neg_M_righ_ankl_cros_z;
  const Scalar neg_Omega_right_foot_yy = t_right_thigh_9 + t_right_foot_1;
  const Scalar neg_F_right_foot_y_1 = Omega_righ_ankl_cros_zx * t_right_foot_2;
  const Scalar neg_F_right_foot_y_2 =
      left_ankle_cross_m1 * neg_a_right_foot_y - neg_F_right_foot_y_1;
  const Scalar neg_F_right_foot_y = neg_F_right_foot_y_2 - t_right_foot_3 * neg_Omega_right_foot_yy;
  const Scalar neg_F_righ_ankl_cros_z =
      neg_F_right_foot_y + left_ankle_cross_h1 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_7 = t_right_thigh_9 + t_righ_ankl_cros_2;
  const Scalar t_right_shank_17 = left_shank_I10 + t_right_shank_9;
  const Scalar F_right_foot_x_1 = t_right_foot_2 * (t_righ_ankl_cros_2 + t_right_foot_1);
  const Scalar F_right_foot_x_2 = left_ankle_cross_m1 * a_right_foot_x - F_right_foot_x_1;
  const Scalar F_right_foot_x = F_right_foot_x_2 + neg_Omega_right_foot_xy * t_right_foot_3;
  // right_ankle_cross: force F, moment M of (3)
  const Scalar F_righ_ankl_cros_x = F_right_foot_x - left_ankle_cross_h1 * Omega_right_thigh_xy;
  const Scalar F_righ_ankl_cros_y = neg_F_right_foot_z + left_ankle_cross_h1 * t_righ_ankl_cros_7;
  const Scalar neg_M_right_shank_z_1 = neg_M_righ_ankl_cros_z + t_right_shank_1 * t_right_shank_6;
  const Scalar neg_M_right_shank_z_2 =
      neg_M_right_shank_z_1 - neg_Omega_right_thigh_yz * t_right_shank_12;
  const Scalar neg_M_right_shank_z_3 =
      neg_M_right_shank_z_2 - neg_s_righ_ankl_cros_y * F_righ_ankl_cros_x;
  const Scalar neg_M_right_shank_z_4 =
      neg_M_right_shank_z_3 - neg_Omega_right_foot_xy * t_right_shank_8;
  const Scalar neg_M_right_shank_z_5 =
      neg_M_right_shank_z_4 + Omega_right_thigh_xy * t_right_shank_17;
  const Scalar neg_M_right_shank_z_6 = neg_M_right_shank_z_5 + t_right_shank_16 * a_right_shank_x;
  const Scalar neg_M_right_shank_z_7 =
      neg_M_right_shank_z_6 - s_righ_ankl_cros_x * F_righ_ankl_cros_y;
  const Scalar neg_M_right_shank_z_8 =
      neg_M_right_shank_z_7 - Omega_right_thigh_yx * t_right_shank_10;
  const Scalar neg_M_right_shank_z = neg_M_right_shank_z_8 - t_right_shank_14 * a_right_shank_y;
  B[9] = -neg_M_right_shank_z;
  const Scalar neg_F_right_shank_z_1 =
      neg_F_righ_ankl_cros_z - Omega_right_shank_zx * t_right_shank_14;
  const Scalar neg_F_right_shank_z =
      neg_F_right_shank_z_1 - Omega_right_shank_zy * t_right_shank_16;
  // right_thigh: moment M of (3)
  const Scalar t_right_thigh_21 = left_ankle_cross_I2 + t_right_thigh_16 + t_right_shank_8;
  const Scalar t_right_thigh_22 = left_thigh_I10 - t_right_thigh_15;
  const Scalar M_right_thigh_y_1 = t_right_thigh_9 - t_right_thigh_10;
  const Scalar M_right_thigh_y_2 =
      neg_M_right_foot_z - left_ankle_cross_I11 * Omega_righ_ankl_cros_zx;
  const Scalar M_right_thigh_y_3 = M_right_thigh_y_2 - left_hip_fork_l2 * F_right_foot_x;
  const Scalar M_right_thigh_y_4 = M_right_thigh_y_3 + left_hip_fork_l1 * neg_F_right_foot_y;
  const Scalar M_right_thigh_y_5 =
      M_right_thigh_y_4 + left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar M_right_thigh_y_6 = M_right_thigh_y_5 - neg_Omega_right_thigh_zy * t_right_thigh_18;
  const Scalar M_right_thigh_y_7 = M_right_thigh_y_6 - left_ankle_cross_I10 * t_righ_ankl_cros_4;
  const Scalar M_right_thigh_y_8 = neg_Omega_right_thigh_zz - neg_Omega_right_shank_xx;
  const Scalar M_right_thigh_y_9 = M_right_thigh_y_7 + neg_Omega_right_thigh_zx * t_right_thigh_22;
  const Scalar M_right_thigh_y_10 = M_right_thigh_y_9 - t_right_shank_12 * M_right_thigh_y_8;
  const Scalar M_right_thigh_y_11 = M_right_thigh_y_10 + Omega_right_thigh_xy * t_right_thigh_21;
  const Scalar M_right_thigh_y_12 = M_right_thigh_y_11 + Omega_right_shank_zy * t_right_shank_6;
  const Scalar M_right_thigh_y_13 = M_right_thigh_y_12 + s_right_shank_x * neg_F_right_shank_z;
  const Scalar M_right_thigh_y_14 =
      M_right_thigh_y_13 + s_righ_ankl_cros_x * neg_F_righ_ankl_cros_z;
  const Scalar M_right_thigh_y_15 = M_right_thigh_y_14 + neg_a_right_shank_z * t_right_shank_14;
  const Scalar M_right_thigh_y_16 = M_right_thigh_y_15 - Omega_right_shank_zx * t_right_shank_10;
  const Scalar M_right_thigh_y = M_right_thigh_y_16 - t_right_thigh_13 * M_right_thigh_y_1;
  const Scalar M_right_thigh_x_1 = left_ankle_cross_I10 + t_right_thigh_13 + t_right_shank_12;
  const Scalar M_right_thigh_x_2 = Omega_right_shank_zy * t_right_shank_17;
  const Scalar M_right_thigh_x_3 = M_right_thigh_x_2 - neg_a_right_shank_z * t_right_shank_16;
  const Scalar M_right_thigh_x_4 = M_right_thigh_x_3 + neg_Omega_right_shank_yy * t_right_shank_8;
  const Scalar M_right_thigh_x_5 = M_right_thigh_x_4 - Omega_right_shank_zx * t_right_shank_6;
  const Scalar M_right_thigh_x_6 = M_right_thigh_x_5 + t_right_foot_11 * t_righ_ankl_cros_7;
  const Scalar M_right_thigh_x_7 =
      M_right_thigh_x_6 + neg_s_righ_ankl_cros_y * neg_F_righ_ankl_cros_z;
  const Scalar M_right_thigh_x_8 = M_right_thigh_x_7 + left_ankle_cross_h1 * neg_a_righ_ankl_cros_z;
  const Scalar M_right_thigh_x_9 = M_right_thigh_x_8 + neg_s_right_shank_y * neg_F_right_shank_z;
  const Scalar M_right_thigh_x_10 = left_ankle_cross_I8 - t_right_foot_7;
  const Scalar M_right_thigh_x_11 = M_right_thigh_x_9 - t_right_foot_8 * neg_Omega_right_foot_yy;
  const Scalar M_right_thigh_x_12 =
      M_right_thigh_x_11 - Omega_righ_ankl_cros_zx * M_right_thigh_x_10;
  const Scalar M_right_thigh_x_13 =
      M_right_thigh_x_12 - neg_Omega_right_thigh_zz * t_right_thigh_21;
  const Scalar M_right_thigh_x_14 =
      M_right_thigh_x_13 + neg_Omega_right_thigh_yy * t_right_thigh_16;
  const Scalar M_right_thigh_x_15 =
      M_right_thigh_x_14 + left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar M_right_thigh_x_16 = M_right_thigh_x_15 + left_hip_fork_l2 * neg_F_right_foot_z;
  const Scalar M_right_thigh_x_17 = M_right_thigh_x_16 + neg_a_right_foot_z * t_right_foot_3;
  const Scalar M_right_thigh_x_18 = M_right_thigh_x_17 + Omega_right_foot_zy * t_right_foot_9;
  const Scalar M_right_thigh_x_19 = M_right_thigh_x_18 + Omega_right_foot_zx * t_right_foot_10;
  const Scalar M_right_thigh_x_20 = M_right_thigh_x_19 + Omega_right_thigh_yx * M_right_thigh_x_1;
  const Scalar M_right_thigh_x_21 =
      M_right_thigh_x_20 + neg_Omega_right_thigh_zx * t_right_thigh_18;
  const Scalar M_right_thigh_x = M_right_thigh_x_21 - neg_Omega_right_thigh_zy * t_right_thigh_17;
  // right_shank: force F, moment M of (3)
  const Scalar F_right_shank_y_1 = F_righ_ankl_cros_y + Omega_right_thigh_yx * t_right_shank_14;
  const Scalar F_right_shank_y = F_right_shank_y_1 - neg_Omega_right_shank_yy * t_right_shank_16;
  const Scalar F_right_shank_x_1 = F_righ_ankl_cros_x - neg_Omega_right_shank_xx * t_right_shank_14;
  const Scalar F_right_shank_x = F_right_shank_x_1 + Omega_right_thigh_xy * t_right_shank_16;
  const Scalar neg_M_right_thigh_z_1 =
      neg_M_right_shank_z - neg_Omega_right_thigh_yz * t_right_thigh_13;
  const Scalar neg_M_right_thigh_z_2 = neg_M_right_thigh_z_1 + t_right_shank_1 * t_right_thigh_18;
  const Scalar neg_M_right_thigh_z_3 = neg_M_right_thigh_z_2 - s_right_shank_x * F_right_shank_y;
  const Scalar neg_M_right_thigh_z_4 = neg_M_right_thigh_z_3 - a_right_thigh_y * t_right_thigh_20;
  const Scalar neg_M_right_thigh_z_5 =
      neg_M_right_thigh_z_4 - neg_Omega_right_foot_xy * t_right_thigh_16;
  const Scalar neg_M_right_thigh_z_6 = neg_M_right_thigh_z_5 - a_right_thigh_x * t_right_thigh_19;
  const Scalar neg_M_right_thigh_z_7 =
      neg_M_right_thigh_z_6 - neg_s_right_shank_y * F_right_shank_x;
  const Scalar neg_M_right_thigh_z_8 =
      neg_M_right_thigh_z_7 - Omega_right_thigh_yx * t_right_thigh_22;
  const Scalar neg_M_right_thigh_z =
      neg_M_right_thigh_z_8 + Omega_right_thigh_xy * t_right_thigh_17;
  B[8] = -neg_M_right_thigh_z;
  // right_hip_fork
  const Scalar t_right_hip_fork_3 = left_hip_fork_I7 + s_right_hip_roll * t_right_hip_fork_2;
  const Scalar t_right_hip_fork_4 = qd[6] * t_right_hip_fork_3;
  const Scalar t_right_hip_fork_5 = left_hip_fork_I9 * c_right_hip_roll;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_5 - left_hip_fork_I8 * s_right_hip_roll;
  const Scalar neg_F_right_thigh_z_1 =
      neg_F_right_shank_z + neg_Omega_right_thigh_zx * t_right_thigh_20;
  const Scalar neg_F_right_thigh_z =
      neg_F_right_thigh_z_1 - neg_Omega_right_thigh_zy * t_right_thigh_19;
  // right_thigh: moment M, force F of (3)
  const Scalar t_right_thigh_23 = left_hip_fork_l1 * neg_F_right_thigh_z;
  const Scalar t_right_thigh_24 = s_q8_q9_q10 * M_right_thigh_y - t_right_thigh_23;
  const Scalar F_right_thigh_x_1 = F_right_shank_x - Omega_right_thigh_xy * t_right_thigh_19;
  const Scalar F_right_thigh_x = F_right_thigh_x_1 - neg_Omega_right_thigh_xx * t_right_thigh_20;
  const Scalar F_right_thigh_y_1 = F_right_shank_y + neg_Omega_right_thigh_yy * t_right_thigh_19;
  const Scalar F_right_thigh_y = F_right_thigh_y_1 + Omega_right_thigh_yx * t_right_thigh_20;
  const Scalar t_right_thigh_25 = c_q8_q9_q10 * F_right_thigh_x - s_q8_q9_q10 * F_right_thigh_y;
  const Scalar t_right_hip_fork_7 = 2.0f * t_right_hip_fork_4 - qd[7] * t_right_hip_fork_6;
  const Scalar t_right_thigh_26 = t_right_thigh_24 - c_q8_q9_q10 * M_right_thigh_x;
  const Scalar t_right_thigh_27 = c_right_hip_roll * t_right_thigh_26;
  const Scalar t_right_thigh_28 = neg_M_right_thigh_z - left_hip_fork_l1 * t_right_thigh_25;
  B[6] = -(qd[7] * t_right_hip_fork_7 - t_right_thigh_27 + s_right_hip_roll * t_right_thigh_28);
  const Scalar t_right_thigh_29 = c_q8_q9_q10 * M_right_thigh_y + s_q8_q9_q10 * M_right_thigh_x;
  B[7] = qd[6] * t_right_hip_fork_4 - t_right_thigh_29;
  const Scalar M_left_ankle_cross_z_1 = t_left_foot_8 * (t_left_thigh_3 - t_left_foot_2);
  // left_ankle_cross: moment M, Omega of (3)
  const Scalar M_left_ankle_cross_z_2 = left_ankle_cross_I2 + t_left_foot_9;
  const Scalar M_left_ankle_cross_z_3 =
      left_hip_fork_l1 * neg_F_left_foot_z + M_left_ankle_cross_z_1;
  const Scalar M_left_ankle_cross_z_4 =
      M_left_ankle_cross_z_3 - neg_Omega_left_foot_xy * M_left_ankle_cross_z_2;
  const Scalar M_left_ankle_cross_z_5 = M_left_ankle_cross_z_4 - Omega_left_foot_zx * t_left_foot_7;
  const Scalar M_left_ankle_cross_z_6 =
      M_left_ankle_cross_z_5 - left_ankle_cross_I12 * t_left_thigh_11;
  const Scalar M_left_ankle_cross_z_7 =
      M_left_ankle_cross_z_6 - left_ankle_cross_I10 * neg_Omega_left_thigh_yz;
  const Scalar M_left_ankle_cross_z_8 = M_left_ankle_cross_z_7 + neg_a_left_foot_z * t_left_foot_3;
  const Scalar M_left_ankle_cross_z_9 =
      M_left_ankle_cross_z_8 + left_ankle_cross_I8 * t_left_thigh_17;
  const Scalar M_left_ankle_cross_z_10 =
      M_left_ankle_cross_z_9 + left_ankle_cross_h1 * a_left_ankle_cross_x;
  const Scalar M_left_ankle_cross_z_11 =
      M_left_ankle_cross_z_10 + left_ankle_cross_I13 * alpha_left_thigh_z;
  const Scalar M_left_ankle_cross_z = M_left_ankle_cross_z_11 + Omega_left_foot_zy * t_left_foot_11;
  B[4] = M_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_5 = t_left_thigh_3 + t_left_ankle_cross_3;
  // left_foot: force F of (3)
  const Scalar F_left_foot_x_1 = t_left_foot_3 * (t_left_ankle_cross_3 + t_left_foot_2);
  const Scalar F_left_foot_x_2 = left_ankle_cross_m1 * a_left_foot_x - F_left_foot_x_1;
  const Scalar F_left_foot_x = F_left_foot_x_2 - neg_Omega_left_foot_xy * t_left_foot_4;
  const Scalar F_left_ankle_cross_x = F_left_foot_x - left_ankle_cross_h1 * Omega_left_thigh_xy;
  const Scalar t_left_shank_17 = left_shank_I10 - t_left_shank_7;
  const Scalar F_left_ankle_cross_y =
      neg_F_left_foot_z + left_ankle_cross_h1 * t_left_ankle_cross_5;
  // left_shank: moment M of (3)
  const Scalar M_left_shank_z_1 =
      M_left_ankle_cross_z + s_left_ankle_cross_x * F_left_ankle_cross_y;
  const Scalar M_left_shank_z_2 = M_left_shank_z_1 + t_left_shank_16 * a_left_shank_y;
  const Scalar M_left_shank_z_3 = M_left_shank_z_2 + t_left_thigh_17 * t_left_shank_6;
  const Scalar M_left_shank_z_4 =
      M_left_shank_z_3 + neg_s_left_ankle_cross_y * F_left_ankle_cross_x;
  const Scalar M_left_shank_z_5 = M_left_shank_z_4 - neg_Omega_left_thigh_yz * t_left_shank_9;
  const Scalar M_left_shank_z_6 = M_left_shank_z_5 + t_left_shank_13 * a_left_shank_x;
  const Scalar M_left_shank_z_7 = M_left_shank_z_6 - neg_Omega_left_foot_xy * t_left_shank_11;
  const Scalar M_left_shank_z_8 = M_left_shank_z_7 - Omega_left_thigh_xy * t_left_shank_17;
  const Scalar M_left_shank_z = M_left_shank_z_8 + Omega_left_thigh_yx * t_left_shank_14;
  B[3] = M_left_shank_z;
  // left_foot: Omega, force F of (3)
  const Scalar neg_Omega_left_foot_yy = t_left_thigh_3 + t_left_foot_2;
  const Scalar F_left_foot_y_1 = t_left_foot_4 * neg_Omega_left_foot_yy;
  const Scalar F_left_foot_y_2 = left_ankle_cross_m1 * a_left_foot_y - F_left_foot_y_1;
  const Scalar F_left_foot_y = F_left_foot_y_2 + t_left_ankle_cross_2 * t_left_foot_3;
  const Scalar F_left_ankle_cross_z = F_left_foot_y - left_ankle_cross_h1 * t_left_ankle_cross_1;
  const Scalar F_left_shank_z_1 = F_left_ankle_cross_z - Omega_left_shank_zy * t_left_shank_13;
  const Scalar F_left_shank_z = F_left_shank_z_1 + Omega_left_shank_zx * t_left_shank_16;
  const Scalar t_left_thigh_21 = left_thigh_I10 - t_left_thigh_15;
  // left_shank: moment M, force F of (3)
  const Scalar neg_M_left_thigh_y_1 =
      left_ankle_cross_I8 + left_ankle_cross_I14 * c_left_ankle_pitch;
  const Scalar neg_M_left_thigh_y_2 = neg_Omega_left_thigh_zz - neg_Omega_left_shank_xx;
  const Scalar neg_M_left_thigh_y_3 = M_left_foot_z - t_left_shank_9 * neg_M_left_thigh_y_2;
  const Scalar neg_M_left_thigh_y_4 = neg_M_left_thigh_y_3 - Omega_left_shank_zy * t_left_shank_6;
  const Scalar neg_M_left_thigh_y_5 =
      neg_M_left_thigh_y_4 + neg_Omega_left_thigh_zy * t_left_thigh_18;
  const Scalar neg_M_left_thigh_y_6 =
      neg_M_left_thigh_y_5 + left_ankle_cross_I11 * t_left_ankle_cross_2;
  const Scalar neg_M_left_thigh_y_7 = left_ankle_cross_I2 + t_left_thigh_16 + t_left_shank_11;
  const Scalar neg_M_left_thigh_y_8 = neg_M_left_thigh_y_6 + Omega_left_shank_zx * t_left_shank_14;
  const Scalar neg_M_left_thigh_y_9 =
      neg_M_left_thigh_y_8 + Omega_left_thigh_xy * neg_M_left_thigh_y_7;
  const Scalar neg_M_left_thigh_y_10 = neg_M_left_thigh_y_9 + t_left_foot_1 * F_left_foot_y;
  const Scalar neg_M_left_thigh_y_11 =
      neg_M_left_thigh_y_10 - neg_Omega_left_thigh_zx * t_left_thigh_21;
  const Scalar neg_M_left_thigh_y_12 = neg_M_left_thigh_y_11 - left_hip_fork_l2 * F_left_foot_x;
  const Scalar neg_M_left_thigh_y_13 = neg_M_left_thigh_y_12 + t_left_shank_16 * a_left_shank_z;
  const Scalar neg_M_left_thigh_y_14 = neg_Omega_left_thigh_zz - neg_Omega_left_thigh_xx;
  const Scalar neg_M_left_thigh_y_15 =
      neg_M_left_thigh_y_13 - left_ankle_cross_I10 * t_left_ankle_cross_4;
  const Scalar neg_M_left_thigh_y_16 =
      neg_M_left_thigh_y_15 - t_left_thigh_13 * neg_M_left_thigh_y_14;
  const Scalar neg_M_left_thigh_y_17 =
      neg_M_left_thigh_y_16 - t_left_ankle_cross_1 * neg_M_left_thigh_y_1;
  const Scalar neg_M_left_thigh_y = neg_M_left_thigh_y_17 + s_left_shank_x * F_left_shank_z;
  const Scalar F_left_shank_y_1 = F_left_ankle_cross_y + t_left_shank_13 * neg_Omega_left_shank_yy;
  const Scalar F_left_shank_y = F_left_shank_y_1 + Omega_left_thigh_yx * t_left_shank_16;
  const Scalar F_left_shank_x_1 = F_left_ankle_cross_x - neg_Omega_left_shank_xx * t_left_shank_16;
  const Scalar F_left_shank_x = F_left_shank_x_1 - Omega_left_thigh_xy * t_left_shank_13;
  // left_thigh: moment M, force F of (3)
  const Scalar t_left_thigh_22 = left_thigh_I11 + t_left_thigh_15;
  const Scalar M_left_thigh_z_1 = M_left_shank_z + neg_s_left_shank_y * F_left_shank_x;
  const Scalar M_left_thigh_z_2 = M_left_thigh_z_1 - neg_Omega_left_thigh_yz * t_left_thigh_13;
  const Scalar M_left_thigh_z_3 = M_left_thigh_z_2 + a_left_thigh_y * t_left_thigh_20;
  const Scalar M_left_thigh_z_4 = M_left_thigh_z_3 + s_left_shank_x * F_left_shank_y;
  const Scalar M_left_thigh_z_5 = M_left_thigh_z_4 + t_left_thigh_17 * t_left_thigh_18;
  const Scalar M_left_thigh_z_6 = M_left_thigh_z_5 - a_left_thigh_x * t_left_thigh_19;
  const Scalar M_left_thigh_z_7 = M_left_thigh_z_6 + Omega_left_thigh_yx * t_left_thigh_21;
  const Scalar M_left_thigh_z_8 = M_left_thigh_z_7 - Omega_left_thigh_xy * t_left_thigh_22;
  const Scalar M_left_thigh_z = M_left_thigh_z_8 - neg_Omega_left_foot_xy * t_left_thigh_16;
  B[2] = M_left_thigh_z;
  const Scalar M_left_thigh_x_1 = t_left_ankle_cross_5 - neg_Omega_left_foot_yy;
  const Scalar M_left_thigh_x_2 = t_left_thigh_5 - t_left_ankle_cross_3;
  const Scalar M_left_thigh_x_3 = left_ankle_cross_I9 * t_left_ankle_cross_1;
  const Scalar M_left_thigh_x_4 = M_left_thigh_x_3 + Omega_left_shank_zy * t_left_shank_17;
  const Scalar M_left_thigh_x_5 = M_left_thigh_x_4 + neg_Omega_left_thigh_zx * t_left_thigh_18;
  const Scalar M_left_thigh_x_6 = t_left_thigh_5 - t_left_thigh_7;
  const Scalar M_left_thigh_x_7 = left_ankle_cross_I10 + t_left_thigh_13 + t_left_shank_9;
  const Scalar M_left_thigh_x_8 = M_left_thigh_x_5 + t_left_thigh_16 * M_left_thigh_x_6;
  const Scalar M_left_thigh_x_9 = neg_Omega_left_thigh_zz - neg_Omega_left_shank_yy;
  const Scalar M_left_thigh_x_10 = M_left_thigh_x_8 - Omega_left_thigh_yx * M_left_thigh_x_7;
  const Scalar M_left_thigh_x_11 = M_left_thigh_x_10 + t_left_shank_11 * M_left_thigh_x_9;
  const Scalar M_left_thigh_x_12 = M_left_thigh_x_11 - neg_Omega_left_thigh_zy * t_left_thigh_22;
  const Scalar M_left_thigh_x_13 = M_left_thigh_x_12 - left_ankle_cross_h1 * a_left_ankle_cross_z;
  const Scalar M_left_thigh_x_14 = M_left_thigh_x_13 - Omega_left_foot_zx * t_left_foot_11;
  const Scalar M_left_thigh_x_15 = left_ankle_cross_I8 + t_left_foot_8;
  const Scalar M_left_thigh_x_16 = M_left_thigh_x_14 - neg_a_left_foot_z * t_left_foot_4;
  const Scalar M_left_thigh_x_17 = M_left_thigh_x_16 - t_left_ankle_cross_2 * M_left_thigh_x_15;
  const Scalar M_left_thigh_x_18 = M_left_thigh_x_17 + Omega_left_foot_zy * t_left_foot_10;
  const Scalar M_left_thigh_x_19 = M_left_thigh_x_18 - t_left_shank_13 * a_left_shank_z;
  const Scalar M_left_thigh_x_20 = M_left_thigh_x_19 - t_left_foot_9 * M_left_thigh_x_1;
  const Scalar M_left_thigh_x_21 = M_left_thigh_x_20 - Omega_left_shank_zx * t_left_shank_6;
  const Scalar M_left_thigh_x_22 = M_left_thigh_x_21 - neg_s_left_shank_y * F_left_shank_z;
  const Scalar M_left_thigh_x_23 = M_left_thigh_x_22 + left_ankle_cross_I2 * M_left_thigh_x_2;
  const Scalar M_left_thigh_x_24 = M_left_thigh_x_23 - left_hip_fork_l2 * neg_F_left_foot_z;
  const Scalar M_left_thigh_x = M_left_thigh_x_24 - neg_s_left_ankle_cross_y * F_left_ankle_cross_z;
  const Scalar t_left_hip_fork_1 = left_hip_fork_I6 * c_left_hip_roll;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + left_hip_fork_I3 * s_left_hip_roll;
  const Scalar F_left_thigh_z_1 = F_left_shank_z - neg_Omega_left_thigh_zx * t_left_thigh_20;
  const Scalar F_left_thigh_z = F_left_thigh_z_1 - neg_Omega_left_thigh_zy * t_left_thigh_19;
  const Scalar F_left_thigh_x_1 = F_left_shank_x - neg_Omega_left_thigh_xx * t_left_thigh_20;
  const Scalar F_left_thigh_x = F_left_thigh_x_1 + Omega_left_thigh_xy * t_left_thigh_19;
  const Scalar F_left_thigh_y_1 = F_left_shank_y + Omega_left_thigh_yx * t_left_thigh_20;
  const Scalar F_left_thigh_y = F_left_thigh_y_1 - t_left_thigh_19 * neg_Omega_left_thigh_yy;
  const Scalar t_left_thigh_23 = c_q2_q3_q4 * F_left_thigh_x - s_q2_q3_q4 * F_left_thigh_y;
  // left_hip_fork: moment M of (3)
  const Scalar t_left_hip_fork_3 = left_hip_fork_I8 * s_left_hip_roll;
  const Scalar t_left_hip_fork_4 = left_hip_fork_I7 - s_left_hip_roll * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_5 = qd[0] * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_3 + left_hip_fork_I9 * c_left_hip_roll;
  const Scalar t_left_thigh_24 = left_hip_fork_l1 * F_left_thigh_z;
  const Scalar t_left_thigh_25 = t_left_thigh_24 - s_q2_q3_q4 * neg_M_left_thigh_y;
  const Scalar t_left_hip_fork_7 = qd[1] * t_left_hip_fork_6 - 2.0f * t_left_hip_fork_5;
  // left_thigh: moment M of (3)
  const Scalar t_left_thigh_26 = M_left_thigh_z + left_hip_fork_l1 * t_left_thigh_23;
  const Scalar t_left_thigh_27 = t_left_thigh_25 - c_q2_q3_q4 * M_left_thigh_x;
  const Scalar t_left_thigh_28 = qd[1] * t_left_hip_fork_7 - s_left_hip_roll * t_left_thigh_26;
  B[0] = c_left_hip_roll * t_left_thigh_27 - t_left_thigh_28;
  const Scalar M_left_hip_fork_z_1 = c_q2_q3_q4 * neg_M_left_thigh_y;
  // left_hip_fork: moment M of (3)
  B[1] = M_left_hip_fork_z_1 - s_q2_q3_q4 * M_left_thigh_x - qd[0] * t_left_hip_fork_5;
}

void gravity_force(const Scalar q[12], Scalar G[12]) noexcept {
  const Scalar q_q2_q3 = q[2] + q[3];
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const Scalar angle_right_foot = left_foot_k1 - q[11];
  const Scalar angle_left_foot = left_foot_k1 + q[5];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[1], q[2], q_q2_q3, q_q2_q3_q4, q[7], q[8], q_q8_q9, q_q8_q9_q10);
  sines_cosines(sines + 8, cosines + 8, angle_right_foot, angle_left_foot);
  const Scalar s_left_hip_roll = sines[0];
  const Scalar c_left_hip_roll = cosines[0];
  const Scalar s_left_hip_pitch = sines[1];
  const Scalar c_left_hip_pitch = cosines[1];
  const Scalar s_q2_q3 = sines[2];
  const Scalar c_q2_q3 = cosines[2];
  const Scalar s_q2_q3_q4 = sines[3];
  const Scalar c_q2_q3_q4 = cosines[3];
  const Scalar s_right_hip_roll = sines[4];
  const Scalar c_right_hip_roll = cosines[4];
  const Scalar s_right_hip_pitch = sines[5];
  const Scalar c_right_hip_pitch = cosines[5];
  const Scalar s_q8_q9 = sines[6];
  const Scalar c_q8_q9 = cosines[6];
  const Scalar s_q8_q9_q10 = sines[7];
  const Scalar c_q8_q9_q10 = cosines[7];
  const Scalar s_right_foot = sines[8];
  const Scalar c_right_foot = cosines[8];
  const Scalar s_left_foot = sines[9];
  const Scalar c_left_foot = cosines[9];
  // right_foot: G of 6.5
  const Scalar t_right_foot_1 = left_foot_G1 * s_right_foot;
  const Scalar t_right_foot_2 = left_foot_G1 * c_right_foot;
  const Scalar neg_G_11_1 = c_right_hip_roll * c_q8_q9_q10 * t_right_foot_1;
  G[11] = s_right_hip_roll * t_right_foot_2 - neg_G_11_1;
  // right_ankle_cross: G of 6.5
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_G2 + t_right_foot_2;
  const Scalar neg_G_10_1 = s_q8_q9_q10 * t_righ_ankl_cros_1;
  const Scalar neg_G_10 = c_right_hip_roll * (left_ankle_cross_G1 * c_q8_q9_q10 - neg_G_10_1);
  G[10] = -neg_G_10;
  const Scalar neg_G_9_1 = left_shank_G1 * c_q8_q9 + left_shank_G2 * s_q8_q9;
  const Scalar neg_G_9 = neg_G_10 - c_right_hip_roll * neg_G_9_1;
  G[9] = -neg_G_9;
  const Scalar neg_G_8_1 = left_thigh_G1 * c_right_hip_pitch + left_thigh_G2 * s_right_hip_pitch;
  G[8] = c_right_hip_roll * neg_G_8_1 - neg_G_9;
  // right_hip_fork: G of 6.5
  const Scalar G_7_1 = left_hip_fork_G2 + left_ankle_cross_G1 * s_q8_q9_q10;
  const Scalar G_7_2 = G_7_1 - left_shank_G1 * s_q8_q9 + left_shank_G2 * c_q8_q9;
  const Scalar G_7_3 = G_7_2 - left_thigh_G1 * s_right_hip_pitch;
  const Scalar G_7_4 = G_7_3 + left_thigh_G2 * c_right_hip_pitch;
  const Scalar G_7_5 = s_right_hip_roll * (G_7_4 + c_q8_q9_q10 * t_righ_ankl_cros_1);
  G[7] = G_7_5 - c_right_hip_roll * (left_hip_fork_G1 + t_right_foot_1);
  // left_foot: G of 6.5
  const Scalar t_left_foot_1 = left_foot_G1 * s_left_foot;
  const Scalar t_left_foot_2 = c_left_hip_roll * c_q2_q3_q4;
  const Scalar t_left_foot_3 = left_foot_G1 * c_left_foot;
  G[5] = t_left_foot_1 * t_left_foot_2 + s_left_hip_roll * t_left_foot_3;
  // left_ankle_cross: G of 6.5
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_G2 + t_left_foot_3;
  const Scalar neg_G_4_1 = c_left_hip_roll * s_q2_q3_q4 * t_left_ankle_cross_1;
  const Scalar neg_G_4 = left_ankle_cross_G1 * t_left_foot_2 - neg_G_4_1;
  G[4] = -neg_G_4;
  const Scalar neg_G_3_1 = left_shank_G1 * c_q2_q3 + left_shank_G2 * s_q2_q3;
  const Scalar neg_G_3 = neg_G_4 - c_left_hip_roll * neg_G_3_1;
  G[3] = -neg_G_3;
  const Scalar neg_G_2_1 = left_thigh_G2 * s_left_hip_pitch + left_thigh_G1 * c_left_hip_pitch;
  G[2] = c_left_hip_roll * neg_G_2_1 - neg_G_3;
  // left_hip_fork: G of 6.5
  const Scalar G_1_1 = left_hip_fork_G2 + left_ankle_cross_G1 * s_q2_q3_q4;
  const Scalar G_1_2 = G_1_1 - left_shank_G1 * s_q2_q3 + left_shank_G2 * c_q2_q3;
  const Scalar G_1_3 = G_1_2 - left_thigh_G1 * s_left_hip_pitch;
  const Scalar G_1_4 = G_1_3 + left_thigh_G2 * c_left_hip_pitch;
  const Scalar G_1_5 = s_left_hip_roll * (G_1_4 + c_q2_q3_q4 * t_left_ankle_cross_1);
  G[1] = c_left_hip_roll * (left_hip_fork_G1 + t_left_foot_1) + G_1_5;
  G[0] = 0.0f;
  G[6] = 0.0f;
}

// Lengths inside are in units of L, a distance between left_hip_roll and left_hip_pitch:
//   L = 0.01 m
// Names: vectors F_ in N m/L, a_ in L/s^2; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void inverse_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar qdd[12],
                      Scalar tau[12]) noexcept {
  const Scalar angle_left_foot = left_foot_k1 + q[5];
  const Scalar angle_right_foot = left_foot_k1 - q[11];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[1], q[2], q[3], q[4], q[7], q[8], q[9], q[10]);
  sines_cosines(sines + 8, cosines + 8, angle_left_foot, angle_right_foot);
  const Scalar s_left_hip_roll = sines[0];
  const Scalar c_left_hip_roll = cosines[0];
  const Scalar s_left_hip_pitch = sines[1];
  const Scalar c_left_hip_pitch = cosines[1];
  const Scalar s_left_knee = sines[2];
  const Scalar c_left_knee = cosines[2];
  const Scalar s_left_ankle_pitch = sines[3];
  const Scalar c_left_ankle_pitch = cosines[3];
  const Scalar s_right_hip_roll = sines[4];
  const Scalar c_right_hip_roll = cosines[4];
  const Scalar s_right_hip_pitch = sines[5];
  const Scalar c_right_hip_pitch = cosines[5];
  const Scalar s_right_knee = sines[6];
  const Scalar c_right_knee = cosines[6];
  const Scalar s_right_ankle_pitch = sines[7];
  const Scalar c_right_ankle_pitch = cosines[7];
  const Scalar s_left_foot = sines[8];
  const Scalar c_left_foot = cosines[8];
  const Scalar s_right_foot = sines[9];
  const Scalar c_right_foot = cosines[9];
  const Scalar t_left_hip_block_1 = qd[0] * qd[0];
  // left_hip_fork: angular velocity omega, angular acceleration alpha, Omega of (1)
  const Scalar omega_left_hip_fork_x = c_left_hip_roll * qd[0];
  const Scalar t_left_hip_fork_1 = omega_left_hip_fork_x * qd[1];
  const Scalar t_left_hip_fork_2 = s_left_hip_roll * qdd[0];
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_1 + t_left_hip_fork_2;
  const Scalar t_left_hip_fork_4 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_5 = qd[1] * qd[1];
  const Scalar t_left_hip_fork_6 = s_left_hip_roll * qd[0];
  const Scalar t_left_hip_fork_7 = c_left_hip_roll * qdd[0];
  const Scalar Omega_left_hip_fork_zy = t_left_hip_fork_7 - qd[1] * t_left_hip_fork_6 * 2.0f;
  const Scalar t_left_hip_fork_8 = omega_left_hip_fork_x * t_left_hip_fork_6;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_8 - qdd[1];
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_8 + qdd[1];
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_4 + t_left_hip_fork_5;
  // left_thigh: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_left_thigh_1 = s_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar neg_Omega_left_thigh_xz = c_left_hip_pitch * t_left_hip_fork_10 - t_left_thigh_1;
  const Scalar t_left_thigh_2 = c_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar neg_omega_left_thigh_x = t_left_thigh_2 + s_left_hip_pitch * qd[1];
  const Scalar omega_left_thigh_z = t_left_hip_fork_6 + qd[2];
  const Scalar t_left_thigh_3 = 2.0f * omega_left_thigh_z;
  const Scalar Omega_left_thigh_zx =
      neg_Omega_left_thigh_xz - neg_omega_left_thigh_x * t_left_thigh_3;
  const Scalar Omega_left_thigh_yz_1 = c_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar Omega_left_thigh_yz = s_left_hip_pitch * t_left_hip_fork_10 + Omega_left_thigh_yz_1;
  const Scalar omega_left_thigh_y_1 = s_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_y = omega_left_thigh_y_1 - c_left_hip_pitch * qd[1];
  const Scalar neg_Omega_left_thigh_zy = Omega_left_thigh_yz - t_left_thigh_3 * omega_left_thigh_y;
  const Scalar t_left_thigh_4 = neg_omega_left_thigh_x * neg_omega_left_thigh_x;
  const Scalar t_left_thigh_5 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_6 = neg_omega_left_thigh_x * omega_left_thigh_y;
  const Scalar alpha_left_thigh_z = t_left_hip_fork_3 + qdd[2];
  const Scalar neg_Omega_left_thigh_yx = t_left_thigh_6 - alpha_left_thigh_z;
  const Scalar t_left_thigh_7 = t_left_hip_fork_2 - left_hip_fork_p1 * c_left_hip_roll;
  const Scalar t_left_thigh_8 = t_left_thigh_4 - t_left_thigh_5;
  const Scalar neg_Omega_left_thigh_xx = t_left_hip_fork_11 - t_left_thigh_8;
  const Scalar a_left_thigh_x_1 = s_left_hip_pitch * t_left_hip_block_1;
  const Scalar a_left_thigh_x = a_left_thigh_x_1 + c_left_hip_pitch * t_left_thigh_7;
  const Scalar a_left_thigh_y_1 = c_left_hip_pitch * t_left_hip_block_1;
  const Scalar a_left_thigh_y = a_left_thigh_y_1 - s_left_hip_pitch * t_left_thigh_7;
  // left_shank: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_left_shank_1 = a_left_thigh_y - left_hip_fork_k1 * neg_Omega_left_thigh_yx;
  const Scalar Omega_left_shank_yz_1 = s_left_knee * neg_Omega_left_thigh_xz;
  const Scalar Omega_left_shank_yz = Omega_left_shank_yz_1 + c_left_knee * Omega_left_thigh_yz;
  const Scalar omega_left_shank_y_1 = s_left_knee * neg_omega_left_thigh_x;
  const Scalar omega_left_shank_y = omega_left_shank_y_1 + c_left_knee * omega_left_thigh_y;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_2 = 2.0f * omega_left_shank_z;
  const Scalar neg_Omega_left_shank_zy = Omega_left_shank_yz - omega_left_shank_y * t_left_shank_2;
  const Scalar Omega_left_shank_xz_1 = c_left_knee * neg_Omega_left_thigh_xz;
  const Scalar Omega_left_shank_xz = s_left_knee * Omega_left_thigh_yz - Omega_left_shank_xz_1;
  const Scalar omega_left_shank_x_1 = c_left_knee * neg_omega_left_thigh_x;
  const Scalar omega_left_shank_x = s_left_knee * omega_left_thigh_y - omega_left_shank_x_1;
  const Scalar neg_Omega_left_shank_zx = Omega_left_shank_xz - t_left_shank_2 * omega_left_shank_x;
  const Scalar a_left_thigh_z = t_left_hip_fork_7 + left_hip_fork_p1 * s_left_hip_roll;
  const Scalar a_left_shank_z = a_left_thigh_z + left_hip_fork_k1 * Omega_left_thigh_zx;
  const Scalar t_left_shank_3 = a_left_thigh_x - left_hip_fork_k1 * neg_Omega_left_thigh_xx;
  const Scalar a_left_shank_x = c_left_knee * t_left_shank_3 + s_left_knee * t_left_shank_1;
  const Scalar t_left_shank_4 = omega_left_shank_x * omega_left_shank_x;
  const Scalar t_left_shank_5 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_6 = omega_left_shank_y * omega_left_shank_x;
  const Scalar alpha_left_shank_z = alpha_left_thigh_z + qdd[3];
  const Scalar Omega_left_shank_xy = t_left_shank_6 - alpha_left_shank_z;
  const Scalar Omega_left_shank_yx = t_left_shank_6 + alpha_left_shank_z;
  const Scalar t_left_shank_7 = t_left_shank_4 - t_left_shank_5;
  const Scalar neg_Omega_left_shank_xx = t_left_hip_fork_11 - t_left_shank_7;
  const Scalar t_left_ankle_cross_1 = a_left_shank_x - left_hip_fork_k2 * neg_Omega_left_shank_xx;
  const Scalar a_left_shank_y = c_left_knee * t_left_shank_1 - s_left_knee * t_left_shank_3;
  // left_ankle_cross: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_left_ankle_cross_2 = a_left_shank_y + left_hip_fork_k2 * Omega_left_shank_yx;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_3 = s_left_ankle_pitch * omega_left_shank_x;
  const Scalar t_left_ankle_cross_4 =
      t_left_ankle_cross_3 - c_left_ankle_pitch * omega_left_shank_y;
  const Scalar t_left_ankle_cross_5 = s_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_6 =
      t_left_ankle_cross_5 - c_left_ankle_pitch * Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_7 = 2.0f * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_8 =
      t_left_ankle_cross_6 - t_left_ankle_cross_4 * t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_9 = c_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_10 =
      t_left_ankle_cross_9 + s_left_ankle_pitch * Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_11 = c_left_ankle_pitch * omega_left_shank_x;
  const Scalar omega_left_ankle_cross_x =
      t_left_ankle_cross_11 + s_left_ankle_pitch * omega_left_shank_y;
  const Scalar t_left_ankle_cross_12 = t_left_ankle_cross_7 * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_13 = t_left_ankle_cross_10 - t_left_ankle_cross_12;
  const Scalar a_left_ankle_cross_z = a_left_shank_z - left_hip_fork_k2 * neg_Omega_left_shank_zx;
  const Scalar t_left_ankle_cross_14 = omega_left_ankle_cross_x * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_15 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_16 = t_left_ankle_cross_14 - t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_4 * omega_left_ankle_cross_x;
  const Scalar alpha_left_ankle_cross_z = alpha_left_shank_z + qdd[4];
  const Scalar Omega_left_foot_xz = t_left_ankle_cross_17 + alpha_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_18 = t_left_ankle_cross_17 - alpha_left_ankle_cross_z;
  // left_foot: angular velocity omega, Omega, acceleration a of (1)
  const Scalar omega_left_foot_z = t_left_ankle_cross_4 + qd[5];
  const Scalar t_left_foot_1 = 2.0f * omega_left_foot_z;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_8 + omega_left_ankle_cross_z * t_left_foot_1;
  const Scalar t_left_ankle_cross_19 = s_left_ankle_pitch * t_left_ankle_cross_1;
  const Scalar neg_a_left_ankle_cross_y =
      t_left_ankle_cross_19 - c_left_ankle_pitch * t_left_ankle_cross_2;
  const Scalar a_left_foot_z_1 = t_left_ankle_cross_18 + neg_a_left_ankle_cross_y;
  const Scalar a_left_foot_z = a_left_foot_z_1 + left_hip_fork_k3 * t_left_ankle_cross_6;
  const Scalar neg_a_left_foot_y_1 = t_left_ankle_cross_13 - a_left_ankle_cross_z;
  const Scalar neg_a_left_foot_y = neg_a_left_foot_y_1 + left_hip_fork_k3 * t_left_hip_fork_11;
  // left_ankle_cross: acceleration a, Omega of (1)
  const Scalar a_left_ankle_cross_x_1 = s_left_ankle_pitch * t_left_ankle_cross_2;
  const Scalar a_left_ankle_cross_x =
      a_left_ankle_cross_x_1 + c_left_ankle_pitch * t_left_ankle_cross_1;
  const Scalar a_left_foot_x_1 = t_left_hip_fork_11 - t_left_ankle_cross_16;
  // left_foot: acceleration a, Omega, moment M of (1)
  const Scalar a_left_foot_x_2 = a_left_ankle_cross_x - a_left_foot_x_1;
  const Scalar a_left_foot_x = a_left_foot_x_2 + left_hip_fork_k3 * t_left_ankle_cross_10;
  const Scalar Omega_left_foot_xy = t_left_ankle_cross_10 - qdd[5];
  const Scalar Omega_left_foot_yx = t_left_ankle_cross_12 - Omega_left_foot_xy;
  const Scalar neg_Omega_left_foot_zx =
      Omega_left_foot_xz - omega_left_ankle_cross_x * t_left_foot_1;
  const Scalar t_left_foot_2 = omega_left_foot_z * omega_left_foot_z;
  const Scalar t_left_foot_3 = left_foot_I4 * c_left_foot + left_foot_I5 * s_left_foot;
  const Scalar t_left_foot_4 = left_foot_I14 - c_left_foot * t_left_foot_3;
  const Scalar t_left_foot_5 = left_foot_I2 * c_left_foot + left_foot_I3 * s_left_foot;
  const Scalar t_left_foot_6 = s_left_foot * t_left_foot_3;
  const Scalar t_left_foot_7 = left_foot_I3 * c_left_foot - left_foot_I2 * s_left_foot;
  const Scalar t_left_foot_8 = left_foot_I1 * c_left_foot;
  const Scalar t_left_foot_9 = left_foot_I13 + t_left_foot_6;
  const Scalar t_left_foot_10 = left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_11 = left_foot_I12 - t_left_foot_6;
  const Scalar neg_M_left_foot_z_1 = t_left_ankle_cross_16 * t_left_foot_4;
  const Scalar neg_M_left_foot_z_2 = a_left_foot_x * t_left_foot_10 - neg_M_left_foot_z_1;
  const Scalar neg_M_left_foot_z_3 = neg_M_left_foot_z_2 + Omega_left_foot_xz * t_left_foot_5;
  const Scalar neg_M_left_foot_z_4 = neg_M_left_foot_z_3 + neg_a_left_foot_y * t_left_foot_8;
  const Scalar neg_M_left_foot_z_5 = neg_M_left_foot_z_4 + Omega_left_foot_xy * t_left_foot_9;
  const Scalar neg_M_left_foot_z_6 = neg_M_left_foot_z_5 + t_left_ankle_cross_8 * t_left_foot_7;
  const Scalar neg_M_left_foot_z = neg_M_left_foot_z_6 - Omega_left_foot_yx * t_left_foot_11;
  tau[5] = -neg_M_left_foot_z;
  const Scalar neg_F_left_foot_z_1 = neg_Omega_left_foot_zx * t_left_foot_8;
  const Scalar neg_F_left_foot_z_2 = neg_F_left_foot_z_1 - left_ankle_cross_I1 * a_left_foot_z;
  const Scalar neg_F_left_foot_z = neg_F_left_foot_z_2 - Omega_left_foot_zy * t_left_foot_10;
  const Scalar F_left_foot_x_1 = Omega_left_foot_xy * t_left_foot_10;
  const Scalar F_left_foot_x_2 = F_left_foot_x_1 + left_ankle_cross_I1 * a_left_foot_x;
  const Scalar neg_Omega_left_foot_xx = t_left_ankle_cross_15 + t_left_foot_2;
  const Scalar F_left_foot_x = F_left_foot_x_2 - t_left_foot_8 * neg_Omega_left_foot_xx;
  const Scalar t_right_hip_block_1 = qd[6] * qd[6];
  // right_hip_fork: angular velocity omega, angular acceleration alpha, Omega of (1)
  const Scalar omega_right_hip_fork_x = c_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_1 = omega_right_hip_fork_x * qd[7];
  const Scalar t_right_hip_fork_2 = s_right_hip_roll * qdd[6];
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_1 + t_right_hip_fork_2;
  const Scalar t_right_hip_fork_4 = s_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_5 = c_right_hip_roll * qdd[6];
  const Scalar Omega_right_hip_fork_zy = t_right_hip_fork_5 - qd[7] * t_right_hip_fork_4 * 2.0f;
  const Scalar t_right_hip_fork_6 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_7 = qd[7] * qd[7];
  const Scalar t_right_hip_fork_8 = omega_right_hip_fork_x * t_right_hip_fork_4;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_8 + qdd[7];
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_6 + t_right_hip_fork_7;
  // right_thigh: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar Omega_right_thigh_xz_1 = s_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar Omega_right_thigh_xz =
      Omega_right_thigh_xz_1 - c_right_hip_pitch * t_right_hip_fork_9;
  const Scalar t_right_thigh_1 = c_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar neg_omega_right_thigh_x = t_right_thigh_1 + s_right_hip_pitch * qd[7];
  const Scalar omega_right_thigh_z = t_right_hip_fork_4 + qd[8];
  const Scalar t_right_thigh_2 = 2.0f * omega_right_thigh_z;
  const Scalar neg_Omega_right_thigh_zx =
      Omega_right_thigh_xz + neg_omega_right_thigh_x * t_right_thigh_2;
  const Scalar Omega_right_thigh_yz_1 = c_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar Omega_right_thigh_yz =
      s_right_hip_pitch * t_right_hip_fork_9 + Omega_right_thigh_yz_1;
  const Scalar omega_right_thigh_y_1 = s_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar omega_right_thigh_y = omega_right_thigh_y_1 - c_right_hip_pitch * qd[7];
  const Scalar neg_Omega_right_thigh_zy =
      Omega_right_thigh_yz - t_right_thigh_2 * omega_right_thigh_y;
  const Scalar t_right_thigh_3 = neg_omega_right_thigh_x * neg_omega_right_thigh_x;
  const Scalar t_right_thigh_4 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_5 = neg_omega_right_thigh_x * omega_right_thigh_y;
  const Scalar alpha_right_thigh_z = t_right_hip_fork_3 + qdd[8];
  const Scalar neg_Omega_right_thigh_yx = t_right_thigh_5 - alpha_right_thigh_z;
  const Scalar neg_Omega_right_thigh_xy = t_right_thigh_5 + alpha_right_thigh_z;
  const Scalar t_right_thigh_6 = t_right_hip_fork_2 - left_hip_fork_p1 * c_right_hip_roll;
  const Scalar a_right_thigh_z = t_right_hip_fork_5 + left_hip_fork_p1 * s_right_hip_roll;
  const Scalar a_right_thigh_y_1 = c_right_hip_pitch * t_right_hip_block_1;
  const Scalar a_right_thigh_y = a_right_thigh_y_1 - s_right_hip_pitch * t_right_thigh_6;
  const Scalar t_right_shank_1 = a_right_thigh_y - left_hip_fork_k1 * neg_Omega_right_thigh_yx;
  const Scalar a_right_thigh_x_1 = s_right_hip_pitch * t_right_hip_block_1;
  const Scalar a_right_thigh_x = a_right_thigh_x_1 + c_right_hip_pitch * t_right_thigh_6;
  const Scalar t_right_thigh_7 = t_right_thigh_3 - t_right_thigh_4;
  const Scalar neg_Omega_right_thigh_xx = t_right_hip_fork_10 - t_right_thigh_7;
  // right_shank: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_right_shank_2 = a_right_thigh_x - left_hip_fork_k1 * neg_Omega_right_thigh_xx;
  const Scalar a_right_shank_x_1 = c_right_knee * t_right_shank_2;
  const Scalar a_right_shank_x = a_right_shank_x_1 + s_right_knee * t_right_shank_1;
  const Scalar t_right_shank_3 = s_right_knee * Omega_right_thigh_xz;
  const Scalar neg_Omega_right_shank_yz = t_right_shank_3 - c_right_knee * Omega_right_thigh_yz;
  const Scalar omega_right_shank_y_1 = s_right_knee * neg_omega_right_thigh_x;
  const Scalar omega_right_shank_y = c_right_knee * omega_right_thigh_y + omega_right_shank_y_1;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar t_right_shank_4 = 2.0f * omega_right_shank_z;
  const Scalar Omega_right_shank_zy =
      neg_Omega_right_shank_yz + omega_right_shank_y * t_right_shank_4;
  const Scalar a_right_shank_z = a_right_thigh_z - left_hip_fork_k1 * neg_Omega_right_thigh_zx;
  const Scalar Omega_right_shank_xz_1 = s_right_knee * Omega_right_thigh_yz;
  const Scalar Omega_right_shank_xz = Omega_right_shank_xz_1 + c_right_knee * Omega_right_thigh_xz;
  const Scalar omega_right_shank_x_1 = c_right_knee * neg_omega_right_thigh_x;
  const Scalar omega_right_shank_x = s_right_knee * omega_right_thigh_y - omega_right_shank_x_1;
  const Scalar t_right_shank_5 = omega_right_shank_x * omega_right_shank_x;
  const Scalar t_right_shank_6 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_7 = omega_right_shank_y * omega_right_shank_x;
  const Scalar alpha_right_shank_z = alpha_right_thigh_z + qdd[9];
  const Scalar Omega_right_shank_xy = t_right_shank_7 - alpha_right_shank_z;
  const Scalar Omega_right_shank_yx = t_right_shank_7 + alpha_right_shank_z;
  const Scalar neg_Omega_right_shank_yy = t_right_shank_5 + t_right_shank_6;
  const Scalar t_right_shank_8 = t_right_shank_5 - t_right_shank_6;
  const Scalar neg_Omega_right_shank_xx = t_right_hip_fork_10 - t_right_shank_8;
  const Scalar t_righ_ankl_cros_1 = a_right_shank_x - left_hip_fork_k2 * neg_Omega_right_shank_xx;
  const Scalar a_right_shank_y_1 = c_right_knee * t_right_shank_1;
  const Scalar a_right_shank_y = a_right_shank_y_1 - s_right_knee * t_right_shank_2;
  // right_ankle_cross: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_righ_ankl_cros_2 = a_right_shank_y + left_hip_fork_k2 * Omega_right_shank_yx;
  const Scalar a_righ_ankl_cros_x_1 = c_right_ankle_pitch * t_righ_ankl_cros_1;
  const Scalar a_righ_ankl_cros_x = a_righ_ankl_cros_x_1 + s_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar neg_Omega_right_shank_zx =
      Omega_right_shank_xz - t_right_shank_4 * omega_right_shank_x;
  const Scalar a_righ_ankl_cros_z = a_right_shank_z - left_hip_fork_k2 * neg_Omega_right_shank_zx;
  const Scalar t_righ_ankl_cros_3 = s_right_ankle_pitch * neg_Omega_right_shank_yz;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 - c_right_ankle_pitch * Omega_right_shank_xz;
  const Scalar t_righ_ankl_cros_5 = c_right_ankle_pitch * omega_right_shank_x;
  const Scalar omega_righ_ankl_cros_x =
      t_righ_ankl_cros_5 + s_right_ankle_pitch * omega_right_shank_y;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_6 = 2.0f * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_7 = omega_righ_ankl_cros_x * t_righ_ankl_cros_6;
  const Scalar Omega_righ_ankl_cros_zx = t_righ_ankl_cros_4 + t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_8 = s_right_ankle_pitch * omega_right_shank_x;
  const Scalar t_righ_ankl_cros_9 = t_righ_ankl_cros_8 - c_right_ankle_pitch * omega_right_shank_y;
  const Scalar t_righ_ankl_cros_10 = c_right_ankle_pitch * neg_Omega_right_shank_yz;
  const Scalar t_righ_ankl_cros_11 =
      t_righ_ankl_cros_10 + s_right_ankle_pitch * Omega_right_shank_xz;
  const Scalar Omega_righ_ankl_cros_zy =
      t_righ_ankl_cros_11 - t_righ_ankl_cros_6 * t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_12 = omega_righ_ankl_cros_x * omega_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_13 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_14 = t_righ_ankl_cros_12 - t_righ_ankl_cros_13;
  const Scalar t_righ_ankl_cros_15 = omega_righ_ankl_cros_x * t_righ_ankl_cros_9;
  const Scalar alpha_righ_ankl_cros_z = alpha_right_shank_z + qdd[10];
  const Scalar Omega_right_foot_xz = t_righ_ankl_cros_15 + alpha_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_16 = t_righ_ankl_cros_15 - alpha_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_17 = s_right_ankle_pitch * t_righ_ankl_cros_1;
  const Scalar neg_a_righ_ankl_cros_y =
      t_righ_ankl_cros_17 - c_right_ankle_pitch * t_righ_ankl_cros_2;
  // right_foot: acceleration a, angular velocity omega, Omega of (1)
  const Scalar a_right_foot_z_1 = t_righ_ankl_cros_16 + neg_a_righ_ankl_cros_y;
  const Scalar a_right_foot_z = a_right_foot_z_1 - left_hip_fork_k3 * t_righ_ankl_cros_11;
  const Scalar a_right_foot_y_1 = a_righ_ankl_cros_z + Omega_righ_ankl_cros_zx;
  const Scalar a_right_foot_y = a_right_foot_y_1 + left_hip_fork_k3 * t_right_hip_fork_10;
  const Scalar omega_right_foot_z = t_righ_ankl_cros_9 + qd[11];
  const Scalar t_right_foot_1 = 2.0f * omega_right_foot_z;
  const Scalar Omega_right_foot_zy =
      Omega_righ_ankl_cros_zy + omega_righ_ankl_cros_z * t_right_foot_1;
  const Scalar a_right_foot_x_1 = t_right_hip_fork_10 - a_righ_ankl_cros_x;
  const Scalar a_right_foot_x_2 = t_righ_ankl_cros_14 - a_right_foot_x_1;
  const Scalar a_right_foot_x = a_right_foot_x_2 + left_hip_fork_k3 * t_righ_ankl_cros_4;
  const Scalar neg_Omega_right_foot_xy = t_righ_ankl_cros_4 + qdd[11];
  const Scalar Omega_right_foot_yx = t_righ_ankl_cros_7 + neg_Omega_right_foot_xy;
  const Scalar t_right_foot_2 = omega_right_foot_z * omega_right_foot_z;
  const Scalar neg_Omega_right_foot_zx =
      Omega_right_foot_xz - omega_righ_ankl_cros_x * t_right_foot_1;
  const Scalar t_right_foot_3 = left_foot_I4 * c_right_foot + left_foot_I5 * s_right_foot;
  const Scalar t_right_foot_4 = s_right_foot * t_right_foot_3;
  const Scalar t_right_foot_5 = left_foot_I14 - c_right_foot * t_right_foot_3;
  const Scalar t_right_foot_6 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_7 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_8 = left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_9 = left_foot_I1 * c_right_foot;
  const Scalar t_right_foot_10 = left_foot_I13 + t_right_foot_4;
  const Scalar t_right_foot_11 = left_foot_I12 - t_right_foot_4;
  const Scalar M_right_foot_z_1 = neg_Omega_right_foot_xy * t_right_foot_10;
  const Scalar M_right_foot_z_2 = M_right_foot_z_1 + a_right_foot_y * t_right_foot_9;
  const Scalar M_right_foot_z_3 = M_right_foot_z_2 + a_right_foot_x * t_right_foot_8;
  const Scalar M_right_foot_z_4 = M_right_foot_z_3 - t_righ_ankl_cros_14 * t_right_foot_5;
  const Scalar M_right_foot_z_5 = M_right_foot_z_4 + Omega_right_foot_yx * t_right_foot_11;
  const Scalar M_right_foot_z_6 = M_right_foot_z_5 + Omega_right_foot_xz * t_right_foot_7;
  const Scalar M_right_foot_z = M_right_foot_z_6 + Omega_righ_ankl_cros_zy * t_right_foot_6;
  tau[11] = M_right_foot_z;
  const Scalar neg_F_right_foot_z_1 = neg_Omega_right_foot_zx * t_right_foot_9;
  const Scalar neg_F_right_foot_z_2 = neg_F_right_foot_z_1 + Omega_right_foot_zy * t_right_foot_8;
  const Scalar neg_F_right_foot_z = neg_F_right_foot_z_2 - left_ankle_cross_I1 * a_right_foot_z;
  const Scalar F_right_foot_x_1 = t_right_foot_9 * (t_righ_ankl_cros_13 + t_right_foot_2);
  const Scalar F_right_foot_x_2 = left_ankle_cross_I1 * a_right_foot_x - F_right_foot_x_1;
  const Scalar F_right_foot_x = F_right_foot_x_2 + neg_Omega_right_foot_xy * t_right_foot_8;
  // right_ankle_cross: Omega, moment M of (1)
  const Scalar t_righ_ankl_cros_18 = t_righ_ankl_cros_12 + t_righ_ankl_cros_13;
  const Scalar t_righ_ankl_cros_19 = t_right_hip_fork_10 - t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_20 = left_ankle_cross_I3 * a_righ_ankl_cros_z;
  // right_foot: moment M of (1)
  const Scalar t_right_foot_12 = t_righ_ankl_cros_20 - Omega_right_foot_yx * t_right_foot_6;
  const Scalar t_right_foot_13 = t_right_foot_12 + left_ankle_cross_I10 * t_righ_ankl_cros_16;
  const Scalar t_right_foot_14 = t_right_foot_13 + a_right_foot_z * t_right_foot_8;
  const Scalar t_right_foot_15 = t_right_foot_14 + left_ankle_cross_I2 * t_righ_ankl_cros_19;
  const Scalar t_right_foot_16 = t_right_foot_15 - left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_foot_17 = t_right_foot_16 - left_hip_fork_k3 * neg_F_right_foot_z;
  const Scalar t_right_foot_18 = t_right_foot_17 - Omega_right_foot_zy * t_right_foot_10;
  const Scalar t_right_foot_19 = t_righ_ankl_cros_13 - t_right_foot_2;
  const Scalar t_right_foot_20 = t_right_foot_18 - t_right_foot_7 * t_right_foot_19;
  const Scalar t_right_foot_21 = t_right_foot_20 + neg_Omega_right_foot_zx * t_right_foot_5;
  const Scalar neg_M_righ_ankl_cros_x =
      t_right_foot_21 + left_ankle_cross_I8 * Omega_righ_ankl_cros_zx;
  const Scalar M_righ_ankl_cros_z_1 =
      neg_F_right_foot_z + left_ankle_cross_I12 * t_righ_ankl_cros_15;
  const Scalar M_righ_ankl_cros_z_2 = t_righ_ankl_cros_12 - t_right_foot_2;
  // right_ankle_cross: moment M of (1)
  const Scalar M_righ_ankl_cros_z_3 =
      M_righ_ankl_cros_z_1 + left_ankle_cross_I3 * a_righ_ankl_cros_x;
  const Scalar M_righ_ankl_cros_z_4 = M_righ_ankl_cros_z_3 - t_right_foot_6 * M_righ_ankl_cros_z_2;
  const Scalar M_righ_ankl_cros_z_5 = M_righ_ankl_cros_z_4 - a_right_foot_z * t_right_foot_9;
  const Scalar M_righ_ankl_cros_z_6 = t_righ_ankl_cros_14 - t_righ_ankl_cros_19;
  const Scalar M_righ_ankl_cros_z_7 =
      M_righ_ankl_cros_z_5 + left_ankle_cross_I2 * t_righ_ankl_cros_4;
  const Scalar M_righ_ankl_cros_z_8 =
      M_righ_ankl_cros_z_7 + left_ankle_cross_I8 * M_righ_ankl_cros_z_6;
  const Scalar M_righ_ankl_cros_z_9 =
      M_righ_ankl_cros_z_8 + neg_Omega_right_foot_xy * t_right_foot_7;
  const Scalar M_righ_ankl_cros_z_10 =
      M_righ_ankl_cros_z_9 + neg_Omega_right_foot_zx * t_right_foot_11;
  const Scalar M_righ_ankl_cros_z_11 =
      M_righ_ankl_cros_z_10 + left_ankle_cross_I10 * t_righ_ankl_cros_11;
  const Scalar M_righ_ankl_cros_z_12 = M_righ_ankl_cros_z_11 - Omega_right_foot_zy * t_right_foot_5;
  const Scalar M_righ_ankl_cros_z =
      M_righ_ankl_cros_z_12 + left_ankle_cross_I13 * alpha_righ_ankl_cros_z;
  tau[10] = M_righ_ankl_cros_z;
  // right_foot: force F of (1)
  const Scalar F_right_foot_y_1 = t_right_foot_8 * (t_righ_ankl_cros_12 + t_right_foot_2);
  const Scalar F_right_foot_y_2 = Omega_right_foot_yx * t_right_foot_9 + F_right_foot_y_1;
  const Scalar F_right_foot_y = F_right_foot_y_2 + left_ankle_cross_I1 * a_right_foot_y;
  // right_ankle_cross: force F of (1)
  const Scalar F_righ_ankl_cros_z_1 = F_right_foot_y + left_shank_I14 * a_righ_ankl_cros_z;
  const Scalar F_righ_ankl_cros_z =
      F_righ_ankl_cros_z_1 - left_ankle_cross_I3 * Omega_righ_ankl_cros_zy;
  const Scalar F_righ_ankl_cros_x_1 = F_right_foot_x + left_shank_I14 * a_righ_ankl_cros_x;
  const Scalar F_righ_ankl_cros_x =
      F_righ_ankl_cros_x_1 + left_ankle_cross_I3 * Omega_right_foot_xz;
  const Scalar F_righ_ankl_cros_y_1 = neg_F_right_foot_z - left_shank_I14 * neg_a_righ_ankl_cros_y;
  const Scalar F_righ_ankl_cros_y =
      F_righ_ankl_cros_y_1 + left_ankle_cross_I3 * t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_21 = s_right_ankle_pitch * F_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_21 + c_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar t_right_shank_9 = t_right_hip_fork_10 - neg_Omega_right_shank_yy;
  const Scalar M_right_shank_z_1 = M_righ_ankl_cros_z + left_hip_fork_k2 * t_righ_ankl_cros_22;
  // right_shank: moment M of (1)
  const Scalar M_right_shank_z_2 = M_right_shank_z_1 + left_shank_I6 * Omega_right_shank_xz;
  const Scalar M_right_shank_z_3 = M_right_shank_z_2 - left_shank_I13 * Omega_right_shank_yx;
  const Scalar M_right_shank_z_4 = M_right_shank_z_3 - left_shank_I1 * a_right_shank_x;
  const Scalar M_right_shank_z_5 = M_right_shank_z_4 - left_shank_I10 * Omega_right_shank_xy;
  const Scalar M_right_shank_z_6 = M_right_shank_z_5 + left_shank_I11 * neg_Omega_right_shank_yz;
  const Scalar M_right_shank_z_7 = t_right_shank_8 - t_right_shank_9;
  const Scalar M_right_shank_z = M_right_shank_z_6 - left_shank_I9 * M_right_shank_z_7;
  tau[9] = M_right_shank_z;
  // right_foot: moment M of (1)
  const Scalar t_right_foot_22 = M_right_foot_z + F_right_foot_y;
  const Scalar t_right_foot_23 = t_right_foot_22 + left_hip_fork_k3 * F_right_foot_x;
  const Scalar t_right_foot_24 = t_right_foot_23 + left_ankle_cross_I11 * Omega_righ_ankl_cros_zx;
  const Scalar t_right_foot_25 = t_right_foot_24 + left_ankle_cross_I10 * t_righ_ankl_cros_14;
  const Scalar t_right_foot_26 = t_right_foot_25 + left_ankle_cross_I2 * Omega_right_foot_xz;
  const Scalar neg_M_righ_ankl_cros_y =
      t_right_foot_26 - left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar F_right_shank_z_1 = F_righ_ankl_cros_z + left_shank_I1 * Omega_right_shank_zy;
  const Scalar F_right_shank_z = F_right_shank_z_1 + left_thigh_I14 * a_right_shank_z;
  // right_ankle_cross: moment M of (1)
  const Scalar neg_M_right_shank_x_1 = c_right_ankle_pitch * neg_M_righ_ankl_cros_x;
  const Scalar neg_M_right_shank_x_2 =
      neg_M_right_shank_x_1 - s_right_ankle_pitch * neg_M_righ_ankl_cros_y;
  const Scalar neg_M_right_shank_x_3 =
      neg_M_right_shank_x_2 - left_shank_I10 * Omega_right_shank_zy;
  const Scalar neg_M_right_shank_x_4 = neg_M_right_shank_x_3 - left_shank_I6 * t_right_shank_9;
  const Scalar neg_M_right_shank_x_5 =
      neg_M_right_shank_x_4 - left_shank_I11 * Omega_right_shank_yx;
  const Scalar neg_M_right_shank_x_6 = neg_M_right_shank_x_5 - left_shank_I1 * a_right_shank_z;
  const Scalar neg_M_right_shank_x =
      neg_M_right_shank_x_6 + left_shank_I9 * neg_Omega_right_shank_zx;
  const Scalar neg_M_right_shank_y_1 = s_right_ankle_pitch * neg_M_righ_ankl_cros_x;
  const Scalar neg_M_right_shank_y_2 = neg_M_right_shank_y_1 + left_shank_I11 * t_right_shank_8;
  const Scalar neg_M_right_shank_y_3 =
      neg_M_right_shank_y_2 + c_right_ankle_pitch * neg_M_righ_ankl_cros_y;
  const Scalar neg_M_right_shank_y_4 = neg_M_right_shank_y_3 + left_shank_I9 * Omega_right_shank_zy;
  const Scalar neg_M_right_shank_y_5 = neg_M_right_shank_y_4 + left_shank_I6 * Omega_right_shank_xy;
  const Scalar neg_M_right_shank_y_6 =
      neg_M_right_shank_y_5 + left_hip_fork_k2 * F_righ_ankl_cros_z;
  const Scalar neg_M_right_shank_y =
      neg_M_right_shank_y_6 + left_shank_I13 * neg_Omega_right_shank_zx;
  // right_thigh: moment M of (1)
  const Scalar M_right_thigh_y_1 = left_thigh_I12 * neg_Omega_right_thigh_zy;
  const Scalar M_right_thigh_y_2 = M_right_thigh_y_1 + left_thigh_I6 * neg_Omega_right_thigh_xy;
  const Scalar M_right_thigh_y_3 = M_right_thigh_y_2 - left_thigh_I13 * neg_Omega_right_thigh_zx;
  const Scalar M_right_thigh_y_4 = M_right_thigh_y_3 - left_hip_fork_k1 * F_right_shank_z;
  const Scalar M_right_thigh_y_5 = M_right_thigh_y_4 - s_right_knee * neg_M_right_shank_x;
  const Scalar M_right_thigh_y_6 = M_right_thigh_y_5 - left_thigh_I8 * t_right_thigh_7;
  const Scalar M_right_thigh_y = M_right_thigh_y_6 - c_right_knee * neg_M_right_shank_y;
  const Scalar F_right_shank_x_1 = c_right_ankle_pitch * F_righ_ankl_cros_x;
  // right_shank: force F of (1)
  const Scalar F_right_shank_x_2 = F_right_shank_x_1 + left_thigh_I14 * a_right_shank_x;
  const Scalar F_right_shank_x_3 = F_right_shank_x_2 + left_shank_I1 * Omega_right_shank_xy;
  const Scalar F_right_shank_x = F_right_shank_x_3 - s_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar F_right_shank_y_1 = t_righ_ankl_cros_22 + left_thigh_I14 * a_right_shank_y;
  const Scalar F_right_shank_y = F_right_shank_y_1 - left_shank_I1 * neg_Omega_right_shank_yy;
  const Scalar t_right_shank_10 = s_right_knee * F_right_shank_x + c_right_knee * F_right_shank_y;
  const Scalar neg_Omega_right_thigh_yy = t_right_thigh_3 + t_right_thigh_4;
  const Scalar M_right_thigh_z_1 = M_right_shank_z + left_hip_fork_k1 * t_right_shank_10;
  // right_thigh: moment M of (1)
  const Scalar M_right_thigh_z_2 = M_right_thigh_z_1 - left_thigh_I2 * a_right_thigh_x;
  const Scalar M_right_thigh_z_3 = M_right_thigh_z_2 - left_thigh_I8 * Omega_right_thigh_yz;
  const Scalar M_right_thigh_z_4 = M_right_thigh_z_3 + left_thigh_I11 * neg_Omega_right_thigh_xy;
  const Scalar M_right_thigh_z_5 = neg_Omega_right_thigh_xx - neg_Omega_right_thigh_yy;
  const Scalar M_right_thigh_z_6 = M_right_thigh_z_4 + left_thigh_I6 * Omega_right_thigh_xz;
  const Scalar M_right_thigh_z_7 = M_right_thigh_z_6 + left_thigh_I12 * M_right_thigh_z_5;
  const Scalar M_right_thigh_z = M_right_thigh_z_7 + left_thigh_I13 * neg_Omega_right_thigh_yx;
  tau[8] = M_right_thigh_z;
  // right_hip_fork: moment M, Omega of (1)
  const Scalar t_right_hip_fork_11 = t_right_hip_fork_6 - t_right_hip_fork_7;
  const Scalar t_right_hip_fork_12 = t_right_hip_block_1 - t_right_hip_fork_10;
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_8 - qdd[7];
  // right_thigh: moment M of (1)
  const Scalar M_right_thigh_x_1 = left_thigh_I11 * neg_Omega_right_thigh_zy;
  const Scalar M_right_thigh_x_2 = left_thigh_I2 * a_right_thigh_z - M_right_thigh_x_1;
  const Scalar M_right_thigh_x_3 = M_right_thigh_x_2 - left_thigh_I12 * neg_Omega_right_thigh_zx;
  const Scalar M_right_thigh_x_4 = M_right_thigh_x_3 - c_right_knee * neg_M_right_shank_x;
  const Scalar M_right_thigh_x_5 = M_right_thigh_x_4 - left_thigh_I8 * neg_Omega_right_thigh_yx;
  const Scalar M_right_thigh_x_6 = t_right_hip_fork_10 - neg_Omega_right_thigh_yy;
  const Scalar M_right_thigh_x_7 = M_right_thigh_x_5 + s_right_knee * neg_M_right_shank_y;
  const Scalar M_right_thigh_x = M_right_thigh_x_7 + left_thigh_I6 * M_right_thigh_x_6;
  const Scalar t_right_thigh_8 = left_hip_fork_G3 - left_hip_fork_I8 * qdd[6];
  const Scalar t_right_thigh_9 = c_right_hip_roll * t_right_thigh_8;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_11 - t_right_hip_fork_12;
  const Scalar t_right_thigh_10 = c_right_hip_pitch * M_right_thigh_y + t_right_thigh_9;
  const Scalar t_right_thigh_11 = t_right_thigh_10 - left_hip_fork_I7 * t_right_hip_fork_14;
  const Scalar t_right_thigh_12 = left_hip_fork_G2 + left_hip_fork_I9 * qdd[6];
  const Scalar t_right_thigh_13 = t_right_thigh_11 + left_hip_fork_I10 * t_right_hip_fork_13;
  const Scalar t_right_thigh_14 = t_right_thigh_13 - s_right_hip_roll * t_right_thigh_12;
  const Scalar t_right_thigh_15 = t_right_thigh_14 - left_hip_fork_I11 * t_right_hip_fork_9;
  // right_hip_fork: moment M, Omega of (1)
  tau[7] = -(t_right_thigh_15 + s_right_hip_pitch * M_right_thigh_x);
  const Scalar Omega_right_hip_fork_zx = t_right_hip_fork_1 + t_right_hip_fork_3;
  const Scalar M_right_hip_fork_x_1 = F_right_shank_z - left_hip_fork_I8 * t_right_hip_fork_13;
  const Scalar M_right_hip_fork_x_2 = M_right_hip_fork_x_1 - left_hip_fork_I9 * t_right_hip_fork_12;
  const Scalar M_right_hip_fork_x_3 =
      M_right_hip_fork_x_2 - left_thigh_I2 * neg_Omega_right_thigh_zy;
  const Scalar M_right_hip_fork_x_4 = M_right_hip_fork_x_3 + s_right_hip_pitch * M_right_thigh_y;
  const Scalar M_right_hip_fork_x_5 =
      M_right_hip_fork_x_4 - left_hip_fork_I7 * Omega_right_hip_fork_zx;
  const Scalar M_right_hip_fork_x_6 = M_right_hip_fork_x_5 - c_right_hip_pitch * M_right_thigh_x;
  const Scalar M_right_hip_fork_x =
      M_right_hip_fork_x_6 + left_hip_fork_I11 * Omega_right_hip_fork_zy;
  const Scalar F_right_thigh_y = t_right_shank_10 - left_thigh_I2 * neg_Omega_right_thigh_yy;
  const Scalar F_right_thigh_x_1 = c_right_knee * F_right_shank_x;
  const Scalar F_right_thigh_x_2 = F_right_thigh_x_1 - s_right_knee * F_right_shank_y;
  // right_thigh: force F, moment M of (1)
  const Scalar F_right_thigh_x = F_right_thigh_x_2 - left_thigh_I2 * neg_Omega_right_thigh_xy;
  const Scalar t_right_thigh_16 = M_right_thigh_z + left_hip_fork_I9 * t_right_hip_fork_9;
  const Scalar t_right_thigh_17 = t_right_thigh_16 - s_right_hip_pitch * F_right_thigh_y;
  const Scalar t_right_thigh_18 = t_right_thigh_17 + c_right_hip_pitch * F_right_thigh_x;
  const Scalar t_right_thigh_19 = t_right_thigh_18 + left_hip_fork_I10 * Omega_right_hip_fork_zx;
  const Scalar t_right_thigh_20 = t_right_thigh_19 + left_hip_fork_I8 * t_right_hip_fork_11;
  const Scalar M_right_hip_block_z_1 = c_right_hip_roll * M_right_hip_fork_x;
  const Scalar neg_M_right_hip_fork_y =
      t_right_thigh_20 - left_hip_fork_I7 * Omega_right_hip_fork_zy;
  const Scalar M_right_hip_block_z_2 = left_hip_block_I2 * qdd[6] + M_right_hip_block_z_1;
  tau[6] = M_right_hip_block_z_2 + s_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar t_left_ankle_cross_20 = t_left_ankle_cross_14 + t_left_ankle_cross_15;
  const Scalar neg_Omega_left_foot_yy = t_left_ankle_cross_14 + t_left_foot_2;
  // left_ankle_cross: moment M of (1)
  const Scalar t_left_ankle_cross_21 = t_left_hip_fork_11 - t_left_ankle_cross_20;
  const Scalar M_left_ankle_cross_x_1 = left_ankle_cross_I10 * t_left_ankle_cross_18;
  const Scalar M_left_ankle_cross_x_2 =
      left_ankle_cross_I8 * t_left_ankle_cross_13 + M_left_ankle_cross_x_1;
  const Scalar M_left_ankle_cross_x_3 =
      M_left_ankle_cross_x_2 + neg_Omega_left_foot_zx * t_left_foot_4;
  const Scalar M_left_ankle_cross_x_4 =
      M_left_ankle_cross_x_3 - left_ankle_cross_I3 * a_left_ankle_cross_z;
  const Scalar M_left_ankle_cross_x_5 =
      M_left_ankle_cross_x_4 - left_hip_fork_k3 * neg_F_left_foot_z;
  const Scalar M_left_ankle_cross_x_6 = t_left_ankle_cross_20 - neg_Omega_left_foot_yy;
  const Scalar M_left_ankle_cross_x_7 = M_left_ankle_cross_x_5 + Omega_left_foot_zy * t_left_foot_9;
  const Scalar M_left_ankle_cross_x_8 =
      M_left_ankle_cross_x_7 - t_left_foot_5 * M_left_ankle_cross_x_6;
  const Scalar M_left_ankle_cross_x_9 = M_left_ankle_cross_x_8 + a_left_foot_z * t_left_foot_10;
  const Scalar M_left_ankle_cross_x_10 =
      M_left_ankle_cross_x_9 + left_ankle_cross_I9 * t_left_ankle_cross_8;
  const Scalar M_left_ankle_cross_x_11 =
      M_left_ankle_cross_x_10 + left_ankle_cross_I2 * t_left_ankle_cross_21;
  const Scalar M_left_ankle_cross_x = M_left_ankle_cross_x_11 - Omega_left_foot_yx * t_left_foot_7;
  // left_foot: force F of (1)
  const Scalar neg_F_left_foot_y_1 = t_left_foot_10 * neg_Omega_left_foot_yy;
  const Scalar neg_F_left_foot_y_2 = neg_F_left_foot_y_1 - Omega_left_foot_yx * t_left_foot_8;
  const Scalar neg_F_left_foot_y = neg_F_left_foot_y_2 + left_ankle_cross_I1 * neg_a_left_foot_y;
  // left_ankle_cross: moment M, force F of (1)
  const Scalar M_left_ankle_cross_y_1 = neg_M_left_foot_z + neg_F_left_foot_y;
  const Scalar M_left_ankle_cross_y_2 =
      M_left_ankle_cross_y_1 + left_ankle_cross_I2 * Omega_left_foot_xz;
  const Scalar M_left_ankle_cross_y_3 =
      M_left_ankle_cross_y_2 + left_ankle_cross_I10 * t_left_ankle_cross_16;
  const Scalar M_left_ankle_cross_y_4 =
      M_left_ankle_cross_y_3 + left_ankle_cross_I11 * t_left_ankle_cross_13;
  const Scalar M_left_ankle_cross_y_5 = M_left_ankle_cross_y_4 + left_hip_fork_k3 * F_left_foot_x;
  const Scalar M_left_ankle_cross_y =
      M_left_ankle_cross_y_5 + left_ankle_cross_I8 * t_left_ankle_cross_8;
  const Scalar M_left_ankle_cross_z_1 =
      neg_F_left_foot_z + left_ankle_cross_I3 * a_left_ankle_cross_x;
  const Scalar M_left_ankle_cross_z_2 =
      M_left_ankle_cross_z_1 + neg_Omega_left_foot_zx * t_left_foot_11;
  const Scalar M_left_ankle_cross_z_3 = M_left_ankle_cross_z_2 - a_left_foot_z * t_left_foot_8;
  const Scalar M_left_ankle_cross_z_4 =
      M_left_ankle_cross_z_3 + left_ankle_cross_I9 * Omega_left_foot_xz;
  const Scalar M_left_ankle_cross_z_5 = t_left_ankle_cross_14 - t_left_foot_2;
  const Scalar M_left_ankle_cross_z_6 =
      M_left_ankle_cross_z_4 - left_ankle_cross_I11 * t_left_ankle_cross_18;
  const Scalar M_left_ankle_cross_z_7 = t_left_ankle_cross_16 - t_left_ankle_cross_21;
  const Scalar M_left_ankle_cross_z_8 =
      M_left_ankle_cross_z_6 + t_left_foot_7 * M_left_ankle_cross_z_5;
  const Scalar M_left_ankle_cross_z_9 =
      M_left_ankle_cross_z_8 + left_ankle_cross_I8 * M_left_ankle_cross_z_7;
  const Scalar M_left_ankle_cross_z_10 =
      M_left_ankle_cross_z_9 + left_ankle_cross_I2 * t_left_ankle_cross_10;
  const Scalar M_left_ankle_cross_z_11 =
      M_left_ankle_cross_z_10 + Omega_left_foot_zy * t_left_foot_4;
  const Scalar M_left_ankle_cross_z_12 =
      M_left_ankle_cross_z_11 - left_ankle_cross_I10 * t_left_ankle_cross_6;
  const Scalar M_left_ankle_cross_z = M_left_ankle_cross_z_12 + Omega_left_foot_xy * t_left_foot_5;
  tau[4] = M_left_ankle_cross_z;
  const Scalar F_left_ankle_cross_y_1 =
      neg_F_left_foot_z - left_shank_I14 * neg_a_left_ankle_cross_y;
  const Scalar F_left_ankle_cross_y =
      F_left_ankle_cross_y_1 + left_ankle_cross_I3 * t_left_ankle_cross_20;
  const Scalar F_left_ankle_cross_x_1 = F_left_foot_x + left_shank_I14 * a_left_ankle_cross_x;
  const Scalar F_left_ankle_cross_x =
      F_left_ankle_cross_x_1 + left_ankle_cross_I3 * Omega_left_foot_xz;
  const Scalar neg_Omega_left_shank_yy = t_left_shank_4 + t_left_shank_5;
  const Scalar t_left_ankle_cross_22 = s_left_ankle_pitch * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_23 =
      t_left_ankle_cross_22 + c_left_ankle_pitch * F_left_ankle_cross_y;
  // left_shank: moment M, force F of (1)
  const Scalar M_left_shank_z_1 = M_left_ankle_cross_z - left_shank_I6 * Omega_left_shank_xz;
  const Scalar M_left_shank_z_2 = M_left_shank_z_1 - left_shank_I15 * t_left_shank_6;
  const Scalar M_left_shank_z_3 = neg_Omega_left_shank_xx - neg_Omega_left_shank_yy;
  const Scalar M_left_shank_z_4 = M_left_shank_z_2 + left_shank_I11 * Omega_left_shank_yz;
  const Scalar M_left_shank_z_5 = M_left_shank_z_4 + left_shank_I9 * M_left_shank_z_3;
  const Scalar M_left_shank_z_6 = M_left_shank_z_5 - left_shank_I16 * alpha_left_shank_z;
  const Scalar M_left_shank_z_7 = M_left_shank_z_6 - left_shank_I1 * a_left_shank_x;
  const Scalar M_left_shank_z = M_left_shank_z_7 + left_hip_fork_k2 * t_left_ankle_cross_23;
  tau[3] = M_left_shank_z;
  const Scalar F_left_shank_y_1 = t_left_ankle_cross_23 - left_shank_I1 * neg_Omega_left_shank_yy;
  const Scalar F_left_shank_y = F_left_shank_y_1 + left_thigh_I14 * a_left_shank_y;
  const Scalar t_left_foot_12 = neg_F_left_foot_y + left_ankle_cross_I3 * t_left_ankle_cross_8;
  const Scalar neg_F_left_ankle_cross_z = t_left_foot_12 - left_shank_I14 * a_left_ankle_cross_z;
  const Scalar neg_Omega_left_thigh_xy = t_left_thigh_6 + alpha_left_thigh_z;
  const Scalar M_left_shank_y_1 = s_left_ankle_pitch * M_left_ankle_cross_x;
  const Scalar M_left_shank_y_2 = M_left_shank_y_1 + left_shank_I6 * Omega_left_shank_xy;
  const Scalar M_left_shank_y_3 = M_left_shank_y_2 + left_shank_I11 * t_left_shank_7;
  const Scalar M_left_shank_y_4 = M_left_shank_y_3 + left_hip_fork_k2 * neg_F_left_ankle_cross_z;
  const Scalar M_left_shank_y_5 = M_left_shank_y_4 - left_shank_I13 * neg_Omega_left_shank_zx;
  const Scalar M_left_shank_y_6 = M_left_shank_y_5 + left_shank_I9 * neg_Omega_left_shank_zy;
  const Scalar M_left_shank_y = M_left_shank_y_6 + c_left_ankle_pitch * M_left_ankle_cross_y;
  // left_ankle_cross: force F of (1)
  const Scalar neg_F_left_shank_z_1 = neg_F_left_ankle_cross_z - left_thigh_I14 * a_left_shank_z;
  const Scalar neg_F_left_shank_z = neg_F_left_shank_z_1 + left_shank_I1 * neg_Omega_left_shank_zy;
  const Scalar M_left_shank_x_1 = c_left_ankle_pitch * M_left_ankle_cross_x;
  // left_shank: moment M of (1)
  const Scalar M_left_shank_x_2 = M_left_shank_x_1 - left_shank_I10 * neg_Omega_left_shank_zy;
  const Scalar M_left_shank_x_3 = t_left_hip_fork_11 - neg_Omega_left_shank_yy;
  const Scalar M_left_shank_x_4 = M_left_shank_x_2 - left_shank_I6 * M_left_shank_x_3;
  const Scalar M_left_shank_x_5 = M_left_shank_x_4 - left_shank_I11 * Omega_left_shank_yx;
  const Scalar M_left_shank_x_6 = M_left_shank_x_5 - left_shank_I9 * neg_Omega_left_shank_zx;
  const Scalar M_left_shank_x_7 = M_left_shank_x_6 + left_shank_I1 * a_left_shank_z;
  const Scalar M_left_shank_x = M_left_shank_x_7 - s_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar neg_M_left_thigh_y_1 = left_thigh_I12 * neg_Omega_left_thigh_zy;
  const Scalar neg_M_left_thigh_y_2 =
      left_thigh_I6 * neg_Omega_left_thigh_xy - neg_M_left_thigh_y_1;
  const Scalar neg_M_left_thigh_y_3 = neg_M_left_thigh_y_2 - c_left_knee * M_left_shank_y;
  const Scalar neg_M_left_thigh_y_4 = neg_M_left_thigh_y_3 - left_thigh_I13 * Omega_left_thigh_zx;
  const Scalar neg_M_left_thigh_y_5 = neg_M_left_thigh_y_4 - left_hip_fork_k1 * neg_F_left_shank_z;
  const Scalar neg_M_left_thigh_y_6 = neg_M_left_thigh_y_5 - left_thigh_I8 * t_left_thigh_8;
  const Scalar neg_M_left_thigh_y = neg_M_left_thigh_y_6 - s_left_knee * M_left_shank_x;
  // left_thigh: Omega, moment M of (1)
  const Scalar neg_Omega_left_thigh_yy = t_left_thigh_4 + t_left_thigh_5;
  const Scalar t_left_thigh_9 = t_left_hip_fork_11 - neg_Omega_left_thigh_yy;
  const Scalar M_left_thigh_x_1 = left_thigh_I6 * t_left_thigh_9;
  const Scalar M_left_thigh_x_2 = left_thigh_I2 * a_left_thigh_z - M_left_thigh_x_1;
  const Scalar M_left_thigh_x_3 = M_left_thigh_x_2 - left_thigh_I11 * neg_Omega_left_thigh_zy;
  const Scalar M_left_thigh_x_4 = M_left_thigh_x_3 + c_left_knee * M_left_shank_x;
  const Scalar M_left_thigh_x_5 = M_left_thigh_x_4 + left_thigh_I12 * Omega_left_thigh_zx;
  const Scalar M_left_thigh_x_6 = M_left_thigh_x_5 - s_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_x = M_left_thigh_x_6 + left_thigh_I8 * neg_Omega_left_thigh_yx;
  const Scalar F_left_shank_x_1 = c_left_ankle_pitch * F_left_ankle_cross_x;
  // left_shank: force F of (1)
  const Scalar F_left_shank_x_2 = left_thigh_I14 * a_left_shank_x + F_left_shank_x_1;
  const Scalar F_left_shank_x_3 = F_left_shank_x_2 - s_left_ankle_pitch * F_left_ankle_cross_y;
  const Scalar F_left_shank_x = F_left_shank_x_3 + left_shank_I1 * Omega_left_shank_xy;
  const Scalar t_left_shank_8 = c_left_knee * F_left_shank_y + s_left_knee * F_left_shank_x;
  // left_thigh: moment M of (1)
  const Scalar M_left_thigh_z_1 = M_left_shank_z + left_thigh_I6 * neg_Omega_left_thigh_xz;
  const Scalar M_left_thigh_z_2 = M_left_thigh_z_1 + left_thigh_I16 * t_left_thigh_6;
  const Scalar M_left_thigh_z_3 = t_left_thigh_8 - t_left_thigh_9;
  const Scalar M_left_thigh_z_4 = M_left_thigh_z_2 - left_thigh_I12 * M_left_thigh_z_3;
  const Scalar M_left_thigh_z_5 = M_left_thigh_z_4 + left_thigh_I8 * Omega_left_thigh_yz;
  const Scalar M_left_thigh_z_6 = M_left_thigh_z_5 + left_hip_fork_k1 * t_left_shank_8;
  const Scalar M_left_thigh_z_7 = M_left_thigh_z_6 - left_thigh_I15 * alpha_left_thigh_z;
  const Scalar M_left_thigh_z = M_left_thigh_z_7 - left_thigh_I2 * a_left_thigh_x;
  tau[2] = M_left_thigh_z;
  // left_hip_fork: moment M, Omega of (1)
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_4 - t_left_hip_fork_5;
  const Scalar t_left_hip_fork_13 = t_left_hip_block_1 - t_left_hip_fork_11;
  const Scalar M_left_hip_fork_z_1 = left_hip_fork_G2 - left_hip_fork_I9 * qdd[0];
  const Scalar M_left_hip_fork_z_2 = s_left_hip_roll * M_left_hip_fork_z_1;
  const Scalar M_left_hip_fork_z_3 = M_left_hip_fork_z_2 + left_hip_fork_I11 * t_left_hip_fork_10;
  const Scalar M_left_hip_fork_z_4 = M_left_hip_fork_z_3 + c_left_hip_pitch * neg_M_left_thigh_y;
  const Scalar M_left_hip_fork_z_5 = t_left_hip_fork_12 - t_left_hip_fork_13;
  const Scalar M_left_hip_fork_z_6 = M_left_hip_fork_z_4 - left_hip_fork_I10 * t_left_hip_fork_9;
  const Scalar M_left_hip_fork_z_7 = left_hip_fork_G3 + left_hip_fork_I8 * qdd[0];
  const Scalar M_left_hip_fork_z_8 = M_left_hip_fork_z_6 - left_hip_fork_I7 * M_left_hip_fork_z_5;
  const Scalar M_left_hip_fork_z_9 = M_left_hip_fork_z_8 + c_left_hip_roll * M_left_hip_fork_z_7;
  tau[1] = M_left_hip_fork_z_9 - s_left_hip_pitch * M_left_thigh_x;
  const Scalar F_left_thigh_y = t_left_shank_8 - left_thigh_I2 * neg_Omega_left_thigh_yy;
  const Scalar neg_F_left_thigh_x_1 = left_thigh_I2 * neg_Omega_left_thigh_xy;
  const Scalar neg_F_left_thigh_x_2 = neg_F_left_thigh_x_1 + s_left_knee * F_left_shank_y;
  const Scalar Omega_left_hip_fork_zx = t_left_hip_fork_1 + t_left_hip_fork_3;
  const Scalar t_left_thigh_10 = M_left_thigh_z + left_hip_fork_I8 * t_left_hip_fork_12;
  const Scalar t_left_thigh_11 = t_left_thigh_10 - s_left_hip_pitch * F_left_thigh_y;
  const Scalar neg_F_left_thigh_x = neg_F_left_thigh_x_2 - c_left_knee * F_left_shank_x;
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_12 = t_left_thigh_11 - left_hip_fork_I9 * t_left_hip_fork_10;
  const Scalar t_left_thigh_13 = t_left_thigh_12 - c_left_hip_pitch * neg_F_left_thigh_x;
  const Scalar t_left_thigh_14 = t_left_thigh_13 + left_hip_fork_I7 * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_15 = neg_F_left_shank_z - left_hip_fork_I9 * t_left_hip_fork_13;
  const Scalar t_left_thigh_16 = t_left_thigh_15 + c_left_hip_pitch * M_left_thigh_x;
  const Scalar t_left_thigh_17 = t_left_thigh_16 + left_hip_fork_I8 * t_left_hip_fork_9;
  const Scalar t_left_thigh_18 = t_left_thigh_17 - left_hip_fork_I11 * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_19 = t_left_thigh_18 - left_hip_fork_I7 * Omega_left_hip_fork_zx;
  const Scalar t_left_thigh_20 = t_left_thigh_19 + left_thigh_I2 * neg_Omega_left_thigh_zy;
  const Scalar neg_M_left_hip_fork_y = t_left_thigh_14 + left_hip_fork_I10 * Omega_left_hip_fork_zx;
  const Scalar M_left_hip_block_z_1 = s_left_hip_roll * neg_M_left_hip_fork_y;
  const Scalar neg_M_left_hip_fork_x = t_left_thigh_20 + s_left_hip_pitch * neg_M_left_thigh_y;
  // left_hip_block: moment M of (1)
  const Scalar M_left_hip_block_z_2 = left_hip_block_I2 * qdd[0] + M_left_hip_block_z_1;
  tau[0] = M_left_hip_block_z_2 - c_left_hip_roll * neg_M_left_hip_fork_x;
}

void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept {
  const Scalar q_q2_q3 = q[2] + q[3];
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const Scalar angle_left_foot = left_foot_k2 + q[5];
  const Scalar angle_right_foot = left_foot_k2 - q[11];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[1], q[2], q_q2_q3_q4, q_q2_q3, q[7], q[8], q_q8_q9_q10, q_q8_q9);
  sines_cosines(sines + 8, cosines + 8, angle_left_foot, angle_right_foot);
  const Scalar s_left_hip_roll = sines[0];
  const Scalar c_left_hip_roll = cosines[0];
  const Scalar s_left_hip_pitch = sines[1];
  const Scalar c_left_hip_pitch = cosines[1];
  const Scalar s_q2_q3_q4 = sines[2];
  const Scalar c_q2_q3_q4 = cosines[2];
  const Scalar s_q2_q3 = sines[3];
  const Scalar c_q2_q3 = cosines[3];
  const Scalar s_right_hip_roll = sines[4];
  const Scalar c_right_hip_roll = cosines[4];
  const Scalar s_right_hip_pitch = sines[5];
  const Scalar c_right_hip_pitch = cosines[5];
  const Scalar s_q8_q9_q10 = sines[6];
  const Scalar c_q8_q9_q10 = cosines[6];
  const Scalar s_q8_q9 = sines[7];
  const Scalar c_q8_q9 = cosines[7];
  const Scalar s_left_foot = sines[8];
  const Scalar c_left_foot = cosines[8];
  const Scalar s_right_foot = sines[9];
  const Scalar c_right_foot = cosines[9];
  const Scalar neg_s_left_shank_x = left_shank_l1 * c_left_hip_pitch;
  const Scalar neg_s_left_shank_y = left_shank_l1 * s_left_hip_pitch;
  const Scalar neg_s_left_ankle_cross_x = left_ankle_cross_l1 * c_q2_q3;
  const Scalar neg_s_left_ankle_cross_y = left_ankle_cross_l1 * s_q2_q3;
  const Scalar neg_s_right_shank_x = left_shank_l1 * c_right_hip_pitch;
  const Scalar neg_s_right_shank_y = left_shank_l1 * s_right_hip_pitch;
  const Scalar neg_s_righ_ankl_cros_x = left_ankle_cross_l1 * c_q8_q9;
  const Scalar neg_s_righ_ankl_cros_y = left_ankle_cross_l1 * s_q8_q9;
  // left_hip_fork: angular velocity omega, Omega of (1)
  const Scalar omega_left_hip_fork_x = c_left_hip_roll * qd[0];
  const Scalar t_left_hip_fork_1 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_2 = s_left_hip_roll * qd[0];
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_4 = qd[1] * qd[1];
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_1 + t_left_hip_fork_4;
  // left_thigh: angular acceleration alpha, Omega, acceleration a of (1)
  const Scalar alpha_left_thigh_z = omega_left_hip_fork_x * qd[1];
  const Scalar Omega_left_thigh_xz = omega_left_hip_fork_x * t_left_hip_fork_2;
  const Scalar a_left_thigh_z = base_g1 * s_left_hip_roll;
  const Scalar a_left_hip_fork_x = base_g1 * c_left_hip_roll;
  const Scalar t_left_shank_1 = t_left_hip_fork_1 - t_left_hip_fork_4;
  const Scalar omega_left_thigh_z = t_left_hip_fork_2 + qd[2];
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_2 * qd[1];
  const Scalar Omega_left_thigh_yz = 2.0f * t_left_hip_fork_6;
  const Scalar t_left_thigh_1 = 2.0f * qd[1];
  const Scalar Omega_left_thigh_zy = qd[2] * t_left_thigh_1;
  const Scalar t_left_thigh_2 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar neg_Omega_left_thigh_xx = t_left_hip_fork_4 + t_left_thigh_2;
  const Scalar t_left_thigh_3 = 2.0f * omega_left_hip_fork_x;
  const Scalar neg_Omega_left_thigh_zx = Omega_left_thigh_xz - omega_left_thigh_z * t_left_thigh_3;
  const Scalar neg_a_left_thigh_y_1 = t_left_hip_fork_1 + t_left_hip_fork_3;
  const Scalar neg_a_left_thigh_y = left_hip_fork_l1 * neg_a_left_thigh_y_1;
  const Scalar t_left_thigh_4 = left_thigh_I4 * c_left_hip_pitch;
  const Scalar t_left_thigh_5 = t_left_thigh_4 + left_thigh_I3 * s_left_hip_pitch;
  const Scalar t_left_thigh_6 = c_left_hip_pitch * t_left_thigh_5;
  const Scalar t_left_thigh_7 = left_thigh_I12 - t_left_thigh_6;
  const Scalar t_left_thigh_8 = s_left_hip_pitch * t_left_thigh_5;
  const Scalar t_left_thigh_9 = left_thigh_I6 * s_left_hip_pitch;
  const Scalar t_left_thigh_10 = t_left_thigh_9 - left_thigh_I5 * c_left_hip_pitch;
  const Scalar Omega_left_hip_fork_zx = qd[1] * t_left_thigh_3;
  const Scalar t_left_thigh_11 = left_thigh_I5 * s_left_hip_pitch;
  const Scalar t_left_thigh_12 = t_left_thigh_11 + left_thigh_I6 * c_left_hip_pitch;
  const Scalar t_left_thigh_13 = left_thigh_h3 * s_left_hip_pitch;
  const Scalar t_left_thigh_14 = t_left_thigh_13 + left_thigh_h1 * c_left_hip_pitch;
  const Scalar t_left_thigh_15 = left_thigh_h1 * s_left_hip_pitch;
  const Scalar t_left_thigh_16 = t_left_thigh_15 - left_thigh_h3 * c_left_hip_pitch;
  const Scalar t_left_thigh_17 = left_thigh_I17 - t_left_thigh_8;
  // left_shank: acceleration a, angular velocity omega, Omega of (1)
  const Scalar a_left_shank_z_1 = a_left_thigh_z - neg_s_left_shank_y * Omega_left_thigh_zy;
  const Scalar a_left_shank_z = a_left_shank_z_1 + neg_s_left_shank_x * neg_Omega_left_thigh_zx;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar neg_Omega_left_shank_zx = neg_Omega_left_thigh_zx - t_left_thigh_3 * qd[3];
  const Scalar neg_Omega_left_shank_zy = Omega_left_thigh_yz - t_left_thigh_1 * omega_left_shank_z;
  const Scalar t_left_shank_2 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_3 = left_shank_I3 * c_q2_q3 + left_shank_I4 * s_q2_q3;
  const Scalar t_left_shank_4 = s_q2_q3 * t_left_shank_3;
  const Scalar t_left_shank_5 = c_q2_q3 * t_left_shank_3;
  const Scalar t_left_shank_6 = left_shank_I9 - t_left_shank_5;
  const Scalar t_left_shank_7 = left_shank_I6 * s_q2_q3 - left_shank_I5 * c_q2_q3;
  const Scalar t_left_shank_8 = left_shank_I6 * c_q2_q3 + left_shank_I5 * s_q2_q3;
  const Scalar t_left_shank_9 = left_shank_h2 * c_q2_q3 + left_shank_h3 * s_q2_q3;
  const Scalar t_left_shank_10 = left_shank_I17 - t_left_shank_4;
  const Scalar t_left_shank_11 = left_shank_h2 * s_q2_q3 - left_shank_h3 * c_q2_q3;
  const Scalar neg_Omega_left_shank_yy = t_left_hip_fork_1 + t_left_shank_2;
  const Scalar neg_Omega_left_thigh_yy = t_left_hip_fork_1 + t_left_thigh_2;
  const Scalar neg_a_left_shank_y_1 =
      neg_a_left_thigh_y + neg_s_left_shank_x * Omega_left_hip_fork_zx;
  const Scalar neg_a_left_shank_y =
      neg_a_left_shank_y_1 - neg_s_left_shank_y * neg_Omega_left_thigh_yy;
  const Scalar t_left_ankle_cross_1 =
      neg_a_left_shank_y + neg_s_left_ankle_cross_x * Omega_left_hip_fork_zx;
  const Scalar t_left_ankle_cross_2 =
      t_left_ankle_cross_1 - neg_s_left_ankle_cross_y * neg_Omega_left_shank_yy;
  const Scalar neg_Omega_left_shank_xx = t_left_hip_fork_4 + t_left_shank_2;
  const Scalar a_left_shank_x = a_left_hip_fork_x + neg_s_left_shank_x * neg_Omega_left_thigh_xx;
  // left_ankle_cross: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_left_ankle_cross_3 =
      a_left_shank_x + neg_s_left_ankle_cross_x * neg_Omega_left_shank_xx;
  const Scalar t_left_ankle_cross_4 =
      a_left_shank_z + neg_s_left_ankle_cross_y * neg_Omega_left_shank_zy;
  const Scalar a_left_ankle_cross_z =
      t_left_ankle_cross_4 + neg_s_left_ankle_cross_x * neg_Omega_left_shank_zx;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_5 = s_q2_q3_q4 * omega_left_hip_fork_x;
  const Scalar omega_left_ankle_cross_y = t_left_ankle_cross_5 - c_q2_q3_q4 * qd[1];
  const Scalar t_left_ankle_cross_6 = t_left_hip_fork_2 * t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_7 = c_q2_q3_q4 * Omega_left_thigh_yz - t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_8 = 2.0f * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_9 =
      t_left_ankle_cross_7 + omega_left_ankle_cross_y * t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_10 = c_q2_q3_q4 * omega_left_hip_fork_x;
  const Scalar t_left_ankle_cross_11 = t_left_ankle_cross_10 + s_q2_q3_q4 * qd[1];
  const Scalar t_left_ankle_cross_12 = t_left_hip_fork_2 * t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_13 = s_q2_q3_q4 * Omega_left_thigh_yz + t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_14 =
      t_left_ankle_cross_13 - t_left_ankle_cross_8 * t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_15 = t_left_ankle_cross_11 * t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_16 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_15 - t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_18 = t_left_hip_fork_5 - t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_19 = omega_left_ankle_cross_y * t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_20 = alpha_left_thigh_z - t_left_ankle_cross_19;
  const Scalar Omega_left_foot_xz = alpha_left_thigh_z + t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_21 = t_left_ankle_cross_15 + t_left_ankle_cross_16;
  // left_foot: angular velocity omega, Omega, first moment h of (1)
  const Scalar neg_omega_left_foot_z = omega_left_ankle_cross_y - qd[5];
  const Scalar Omega_left_foot_zy =
      t_left_ankle_cross_9 - t_left_ankle_cross_8 * neg_omega_left_foot_z;
  const Scalar t_left_foot_1 = neg_omega_left_foot_z * neg_omega_left_foot_z;
  const Scalar t_left_foot_2 = t_left_ankle_cross_11 * neg_omega_left_foot_z;
  const Scalar neg_Omega_left_foot_zx = Omega_left_foot_xz - 2.0f * t_left_foot_2;
  const Scalar neg_h_left_foot_y = left_foot_h2 * c_left_foot - left_foot_h3 * s_left_foot;
  const Scalar h_left_foot_x = left_foot_h3 * c_left_foot + left_foot_h2 * s_left_foot;
  const Scalar t_left_foot_3 = left_foot_I15 * s_left_foot + left_foot_I16 * c_left_foot;
  const Scalar t_left_foot_4 = s_left_foot * t_left_foot_3;
  const Scalar E_left_foot_xx = left_foot_I17 - t_left_foot_4;
  const Scalar E_left_foot_xz = left_foot_I18 * c_left_foot;
  const Scalar E_left_foot_yz = left_foot_I18 * s_left_foot;
  const Scalar t_left_foot_5 = c_left_foot * t_left_foot_3;
  const Scalar neg_E_left_foot_xy = left_foot_I20 - t_left_foot_5;
  const Scalar t_left_foot_6 = left_hip_fork_l2 * neg_h_left_foot_y;
  const Scalar neg_F_left_foot_z_1 = Omega_left_foot_zy * neg_h_left_foot_y;
  const Scalar neg_F_left_foot_z = neg_F_left_foot_z_1 + neg_Omega_left_foot_zx * h_left_foot_x;
  const Scalar omega_right_hip_fork_x = c_right_hip_roll * qd[6];
  const Scalar alpha_right_thigh_z = omega_right_hip_fork_x * qd[7];
  // right_hip_fork: angular velocity omega, Omega, acceleration a of (1)
  const Scalar t_right_hip_fork_1 = s_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 * t_right_hip_fork_1;
  const Scalar t_right_hip_fork_3 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_4 = qd[7] * qd[7];
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_3 + t_right_hip_fork_4;
  const Scalar Omega_right_thigh_xz = omega_right_hip_fork_x * t_right_hip_fork_1;
  const Scalar a_right_hip_fork_x = base_g1 * c_right_hip_roll;
  const Scalar a_right_thigh_z = base_g1 * s_right_hip_roll;
  const Scalar t_right_shank_1 = t_right_hip_fork_3 - t_right_hip_fork_4;
  // right_thigh: angular velocity omega, Omega, acceleration a of (1)
  const Scalar omega_right_thigh_z = t_right_hip_fork_1 + qd[8];
  const Scalar t_right_thigh_1 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_2 = t_right_hip_fork_3 - t_right_thigh_1;
  const Scalar neg_Omega_right_thigh_xx = t_right_hip_fork_4 + t_right_thigh_1;
  const Scalar t_right_thigh_3 = 2.0f * omega_right_hip_fork_x;
  const Scalar neg_Omega_right_thigh_zx =
      Omega_right_thigh_xz - omega_right_thigh_z * t_right_thigh_3;
  const Scalar t_right_hip_fork_6 = qd[7] * t_right_hip_fork_1;
  const Scalar Omega_right_thigh_yz = 2.0f * t_right_hip_fork_6;
  const Scalar t_right_thigh_4 = 2.0f * qd[7];
  const Scalar Omega_right_thigh_zy = qd[8] * t_right_thigh_4;
  const Scalar neg_a_right_thigh_y_1 = t_right_hip_fork_2 + t_right_hip_fork_3;
  const Scalar neg_a_right_thigh_y = left_hip_fork_l1 * neg_a_right_thigh_y_1;
  const Scalar t_right_thigh_5 = left_thigh_I3 * s_right_hip_pitch;
  const Scalar t_right_thigh_6 = t_right_thigh_5 + left_thigh_I4 * c_right_hip_pitch;
  const Scalar t_right_thigh_7 = s_right_hip_pitch * t_right_thigh_6;
  const Scalar t_right_thigh_8 = c_right_hip_pitch * t_right_thigh_6;
  const Scalar t_right_thigh_9 = left_thigh_I12 - t_right_thigh_8;
  const Scalar t_right_thigh_10 = left_thigh_I5 * c_right_hip_pitch;
  const Scalar t_right_thigh_11 = t_right_thigh_10 - left_thigh_I6 * s_right_hip_pitch;
  const Scalar Omega_right_hip_fork_zx = 2.0f * alpha_right_thigh_z;
  const Scalar t_right_thigh_12 = left_thigh_I5 * s_right_hip_pitch;
  const Scalar t_right_thigh_13 = t_right_thigh_12 + left_thigh_I6 * c_right_hip_pitch;
  const Scalar t_right_thigh_14 = left_thigh_h1 * c_right_hip_pitch;
  const Scalar t_right_thigh_15 = t_right_thigh_14 + left_thigh_h3 * s_right_hip_pitch;
  const Scalar t_right_thigh_16 = left_thigh_I17 - t_right_thigh_7;
  const Scalar t_right_thigh_17 = left_thigh_h1 * s_right_hip_pitch;
  const Scalar t_right_thigh_18 = t_right_thigh_17 - left_thigh_h3 * c_right_hip_pitch;
  // right_shank: acceleration a, angular velocity omega, Omega of (1)
  const Scalar a_right_shank_z_1 = a_right_thigh_z - neg_s_right_shank_y * Omega_right_thigh_zy;
  const Scalar a_right_shank_z = a_right_shank_z_1 + neg_s_right_shank_x * neg_Omega_right_thigh_zx;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar neg_Omega_right_shank_zx = neg_Omega_right_thigh_zx - t_right_thigh_3 * qd[9];
  const Scalar neg_Omega_right_shank_zy =
      Omega_right_thigh_yz - t_right_thigh_4 * omega_right_shank_z;
  const Scalar t_right_shank_2 = omega_right_shank_z * omega_right_shank_z;
  const Scalar neg_Omega_right_shank_xx = t_right_hip_fork_4 + t_right_shank_2;
  const Scalar neg_Omega_right_shank_yy = t_right_hip_fork_3 + t_right_shank_2;
  const Scalar t_right_shank_3 = left_shank_I3 * c_q8_q9 + left_shank_I4 * s_q8_q9;
  const Scalar t_right_shank_4 = s_q8_q9 * t_right_shank_3;
  const Scalar t_right_shank_5 = c_q8_q9 * t_right_shank_3;
  const Scalar t_right_shank_6 = left_shank_I9 - t_right_shank_5;
  const Scalar t_right_shank_7 = left_shank_I5 * c_q8_q9 - left_shank_I6 * s_q8_q9;
  const Scalar t_right_shank_8 = left_shank_I6 * c_q8_q9 + left_shank_I5 * s_q8_q9;
  const Scalar t_right_shank_9 = left_shank_h2 * c_q8_q9 + left_shank_h3 * s_q8_q9;
  const Scalar t_right_shank_10 = left_shank_h2 * s_q8_q9 - left_shank_h3 * c_q8_q9;
  const Scalar t_right_shank_11 = left_shank_I17 - t_right_shank_4;
  const Scalar a_right_shank_x =
      a_right_hip_fork_x + neg_s_right_shank_x * neg_Omega_right_thigh_xx;
  const Scalar t_righ_ankl_cros_1 =
      a_right_shank_x + neg_s_righ_ankl_cros_x * neg_Omega_right_shank_xx;
  const Scalar neg_Omega_right_thigh_yy = t_right_hip_fork_3 + t_right_thigh_1;
  const Scalar neg_a_right_shank_y_1 =
      neg_a_right_thigh_y + neg_s_right_shank_x * Omega_right_hip_fork_zx;
  const Scalar neg_a_right_shank_y =
      neg_a_right_shank_y_1 - neg_s_right_shank_y * neg_Omega_right_thigh_yy;
  // right_ankle_cross: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_righ_ankl_cros_2 =
      neg_a_right_shank_y + neg_s_righ_ankl_cros_x * Omega_right_hip_fork_zx;
  const Scalar t_righ_ankl_cros_3 =
      t_righ_ankl_cros_2 - neg_s_righ_ankl_cros_y * neg_Omega_right_shank_yy;
  const Scalar t_righ_ankl_cros_4 = c_q8_q9_q10 * t_righ_ankl_cros_1;
  const Scalar neg_a_righ_ankl_cros_x = t_righ_ankl_cros_4 - s_q8_q9_q10 * t_righ_ankl_cros_3;
  const Scalar a_righ_ankl_cros_z_1 =
      a_right_shank_z + neg_s_righ_ankl_cros_x * neg_Omega_right_shank_zx;
  const Scalar a_righ_ankl_cros_z =
      a_righ_ankl_cros_z_1 + neg_s_righ_ankl_cros_y * neg_Omega_right_shank_zy;
  const Scalar t_righ_ankl_cros_5 = s_q8_q9_q10 * qd[7] + c_q8_q9_q10 * omega_right_hip_fork_x;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_6 = s_q8_q9_q10 * Omega_right_thigh_yz;
  const Scalar neg_Omega_right_foot_xy = t_righ_ankl_cros_6 + c_q8_q9_q10 * Omega_right_thigh_xz;
  const Scalar t_righ_ankl_cros_7 = 2.0f * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_zx =
      neg_Omega_right_foot_xy - t_righ_ankl_cros_5 * t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_5 * t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_9 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_8 - t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_11 = t_right_hip_fork_5 - t_righ_ankl_cros_10;
  const Scalar t_righ_ankl_cros_12 = c_q8_q9_q10 * Omega_right_thigh_yz;
  const Scalar t_righ_ankl_cros_13 = t_righ_ankl_cros_12 - s_q8_q9_q10 * Omega_right_thigh_xz;
  const Scalar omega_righ_ankl_cros_y = s_q8_q9_q10 * omega_right_hip_fork_x - c_q8_q9_q10 * qd[7];
  const Scalar Omega_righ_ankl_cros_zy =
      t_righ_ankl_cros_13 + t_righ_ankl_cros_7 * omega_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_14 = t_righ_ankl_cros_5 * omega_righ_ankl_cros_y;
  const Scalar Omega_righ_ankl_cros_yx = alpha_right_thigh_z - t_righ_ankl_cros_14;
  const Scalar Omega_right_foot_xz = alpha_right_thigh_z + t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_8 + t_righ_ankl_cros_9;
  // right_foot: angular velocity omega, Omega, pseudo-inertia E of (1)
  const Scalar neg_omega_right_foot_z = omega_righ_ankl_cros_y - qd[11];
  const Scalar Omega_right_foot_zy =
      Omega_righ_ankl_cros_zy - t_righ_ankl_cros_7 * neg_omega_right_foot_z;
  const Scalar t_right_foot_1 = neg_omega_right_foot_z * neg_omega_right_foot_z;
  const Scalar t_right_foot_2 = t_righ_ankl_cros_8 - t_right_foot_1;
  const Scalar t_right_foot_3 = t_righ_ankl_cros_5 * neg_omega_right_foot_z;
  const Scalar neg_Omega_right_foot_zx = Omega_right_foot_xz - 2.0f * t_right_foot_3;
  const Scalar t_right_foot_4 = left_foot_I16 * c_right_foot + left_foot_I15 * s_right_foot;
  const Scalar t_right_foot_5 = c_right_foot * t_right_foot_4;
  const Scalar E_right_foot_xy = left_foot_I20 - t_right_foot_5;
  const Scalar neg_E_right_foot_yz = left_foot_I18 * s_right_foot;
  const Scalar t_right_foot_6 = s_right_foot * t_right_foot_4;
  const Scalar E_right_foot_xx = left_foot_I17 - t_right_foot_6;
  const Scalar E_right_foot_xz = left_foot_I18 * c_right_foot;
  const Scalar h_right_foot_x = left_foot_h2 * s_right_foot + left_foot_h3 * c_right_foot;
  const Scalar E_right_foot_yy = left_foot_I19 + t_right_foot_6;
  const Scalar h_right_foot_y = left_foot_h2 * c_right_foot - left_foot_h3 * s_right_foot;
  const Scalar F_right_foot_z_1 = neg_Omega_right_foot_zx * h_right_foot_x;
  const Scalar F_right_foot_z = Omega_right_foot_zy * h_right_foot_y - F_right_foot_z_1;
  const Scalar a_righ_ankl_cros_y_1 = c_q8_q9_q10 * t_righ_ankl_cros_3;
  const Scalar a_righ_ankl_cros_y = a_righ_ankl_cros_y_1 + s_q8_q9_q10 * t_righ_ankl_cros_1;
  const Scalar neg_a_right_foot_z_1 =
      a_righ_ankl_cros_y + left_hip_fork_l1 * Omega_righ_ankl_cros_yx;
  const Scalar neg_a_right_foot_z = neg_a_right_foot_z_1 + left_hip_fork_l2 * t_righ_ankl_cros_13;
  const Scalar neg_E_righ_ankl_cros_xy = left_ankle_cross_I8 + E_right_foot_xz;
  const Scalar t_right_foot_7 = Omega_right_foot_zy * E_right_foot_yy;
  // right_ankle_cross: pseudo-inertia E of (1)
  const Scalar t_righ_ankl_cros_16 = t_right_hip_fork_5 - t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_17 = left_hip_fork_l2 * F_right_foot_z - t_right_foot_7;
  const Scalar t_righ_ankl_cros_18 =
      t_righ_ankl_cros_17 + left_ankle_cross_I2 * t_righ_ankl_cros_16;
  const Scalar t_right_foot_8 = t_righ_ankl_cros_9 - t_right_foot_1;
  const Scalar t_righ_ankl_cros_19 =
      t_righ_ankl_cros_18 + neg_Omega_right_foot_zx * E_right_foot_xy;
  const Scalar t_righ_ankl_cros_20 = t_righ_ankl_cros_19 - neg_E_right_foot_yz * t_right_foot_8;
  const Scalar t_righ_ankl_cros_21 =
      t_righ_ankl_cros_20 - left_ankle_cross_I17 * Omega_righ_ankl_cros_yx;
  const Scalar t_righ_ankl_cros_22 =
      t_righ_ankl_cros_21 - left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_23 = t_righ_ankl_cros_22 + h_right_foot_y * neg_a_right_foot_z;
  const Scalar t_righ_ankl_cros_24 =
      t_righ_ankl_cros_23 + Omega_righ_ankl_cros_zx * neg_E_righ_ankl_cros_xy;
  const Scalar neg_M_righ_ankl_cros_x =
      t_righ_ankl_cros_24 + left_ankle_cross_h1 * a_righ_ankl_cros_z;
  const Scalar t_right_foot_9 = left_hip_fork_l1 * h_right_foot_x;
  const Scalar E_righ_ankl_cros_yz = left_ankle_cross_I2 + neg_E_right_foot_yz;
  const Scalar t_righ_ankl_cros_25 = F_right_foot_z - left_ankle_cross_h2 * Omega_righ_ankl_cros_yx;
  // right_foot: force F, Omega, moment M of (1)
  const Scalar neg_F_righ_ankl_cros_y =
      t_righ_ankl_cros_25 - left_ankle_cross_h1 * t_righ_ankl_cros_15;
  const Scalar neg_Omega_right_foot_xx = t_righ_ankl_cros_15 - t_right_foot_2;
  const Scalar neg_F_right_foot_x_1 = h_right_foot_x * neg_Omega_right_foot_xx;
  const Scalar neg_F_right_foot_x = neg_F_right_foot_x_1 + neg_Omega_right_foot_xy * h_right_foot_y;
  const Scalar t_righ_ankl_cros_26 = neg_F_right_foot_x - left_ankle_cross_h1 * Omega_right_foot_xz;
  const Scalar neg_F_righ_ankl_cros_x =
      t_righ_ankl_cros_26 + left_ankle_cross_h2 * t_righ_ankl_cros_11;
  const Scalar t_righ_ankl_cros_27 = s_q8_q9_q10 * neg_F_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_28 = t_righ_ankl_cros_27 - c_q8_q9_q10 * neg_F_righ_ankl_cros_x;
  const Scalar neg_Omega_right_foot_yy = t_righ_ankl_cros_8 + t_right_foot_1;
  const Scalar neg_F_right_foot_y_1 = h_right_foot_y * neg_Omega_right_foot_yy;
  const Scalar neg_F_right_foot_y = neg_F_right_foot_y_1 - Omega_righ_ankl_cros_zx * h_right_foot_x;
  const Scalar t_righ_ankl_cros_29 =
      neg_F_right_foot_y - left_ankle_cross_h2 * Omega_righ_ankl_cros_zx;
  const Scalar neg_F_righ_ankl_cros_z =
      t_righ_ankl_cros_29 + left_ankle_cross_h1 * Omega_righ_ankl_cros_zy;
  const Scalar neg_F_right_shank_z_1 =
      neg_F_righ_ankl_cros_z + neg_Omega_right_shank_zx * t_right_shank_10;
  const Scalar neg_F_right_shank_z =
      neg_F_right_shank_z_1 - neg_Omega_right_shank_zy * t_right_shank_9;
  const Scalar t_right_thigh_19 = t_right_thigh_11 + t_right_shank_7;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_2 - t_right_hip_fork_4;
  const Scalar neg_F_right_thigh_z_1 =
      neg_F_right_shank_z + Omega_right_thigh_zy * t_right_thigh_15;
  const Scalar neg_F_right_thigh_z =
      neg_F_right_thigh_z_1 + neg_Omega_right_thigh_zx * t_right_thigh_18;
  const Scalar t_right_foot_10 = E_right_foot_xx + t_right_foot_9;
  const Scalar neg_a_right_foot_x_1 =
      neg_a_righ_ankl_cros_x - left_hip_fork_l2 * neg_Omega_right_foot_xy;
  const Scalar M_right_foot_z_1 = neg_Omega_right_foot_xy * E_right_foot_yy;
  const Scalar M_right_foot_z_2 = M_right_foot_z_1 + Omega_right_foot_xz * neg_E_right_foot_yz;
  const Scalar M_right_foot_z_3 = a_righ_ankl_cros_z + left_hip_fork_l2 * t_right_hip_fork_5;
  const Scalar M_right_foot_z_4 = M_right_foot_z_2 - t_righ_ankl_cros_10 * E_right_foot_xy;
  const Scalar M_right_foot_z_5 = M_right_foot_z_4 + h_right_foot_x * M_right_foot_z_3;
  const Scalar M_right_foot_z_6 = M_right_foot_z_5 - Omega_righ_ankl_cros_zy * E_right_foot_xz;
  const Scalar neg_a_right_foot_x = neg_a_right_foot_x_1 + left_hip_fork_l1 * t_righ_ankl_cros_11;
  const Scalar M_right_foot_z_7 = M_right_foot_z_6 + Omega_righ_ankl_cros_zx * t_right_foot_10;
  const Scalar M_right_foot_z = M_right_foot_z_7 + h_right_foot_y * neg_a_right_foot_x;
  const Scalar t_right_foot_11 = M_right_foot_z + left_ankle_cross_I2 * Omega_right_foot_xz;
  const Scalar t_right_foot_12 = t_right_foot_11 + left_ankle_cross_h2 * a_righ_ankl_cros_z;
  const Scalar t_right_foot_13 = t_right_foot_12 + left_ankle_cross_I17 * t_righ_ankl_cros_10;
  const Scalar t_right_foot_14 = t_right_foot_13 - left_hip_fork_l2 * neg_F_right_foot_x;
  const Scalar t_right_foot_15 = t_right_foot_14 - left_hip_fork_l1 * neg_F_right_foot_y;
  const Scalar t_right_foot_16 = t_right_foot_15 + left_ankle_cross_I18 * Omega_righ_ankl_cros_zx;
  const Scalar neg_M_righ_ankl_cros_y =
      t_right_foot_16 - left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_thigh_20 = t_right_hip_fork_5 - neg_Omega_right_thigh_yy;
  const Scalar t_right_shank_12 = t_right_hip_fork_5 - neg_Omega_right_shank_yy;
  const Scalar t_right_thigh_21 = left_thigh_I11 + t_right_thigh_7;
  const Scalar t_right_hip_fork_8 = left_hip_fork_I8 * Omega_right_thigh_xz;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_22 = t_right_hip_fork_8 - c_q8_q9_q10 * neg_M_righ_ankl_cros_x;
  const Scalar t_right_thigh_23 = t_right_thigh_22 + left_hip_fork_I13 * t_right_hip_fork_6;
  const Scalar t_right_thigh_24 = t_right_thigh_23 + left_hip_fork_I1 * t_right_hip_fork_7;
  const Scalar t_right_shank_13 = left_shank_I10 + t_right_shank_4;
  const Scalar t_right_thigh_25 = t_right_thigh_24 - neg_Omega_right_shank_zx * t_right_shank_6;
  const Scalar t_right_thigh_26 = t_right_thigh_25 + neg_Omega_right_shank_zy * t_right_shank_13;
  const Scalar t_right_thigh_27 = t_right_thigh_26 + left_hip_fork_I3 * alpha_right_thigh_z;
  const Scalar t_right_thigh_28 = t_right_thigh_27 + Omega_right_hip_fork_zx * t_right_thigh_19;
  const Scalar t_right_thigh_29 = t_right_thigh_28 + left_hip_fork_l1 * neg_F_right_thigh_z;
  const Scalar t_right_thigh_30 = t_right_thigh_29 + a_right_thigh_z * t_right_thigh_15;
  const Scalar t_right_thigh_31 = t_right_thigh_30 - neg_s_right_shank_y * neg_F_right_shank_z;
  const Scalar t_right_thigh_32 =
      t_right_thigh_31 - neg_s_righ_ankl_cros_y * neg_F_righ_ankl_cros_z;
  const Scalar t_right_thigh_33 = t_right_thigh_32 + s_q8_q9_q10 * neg_M_righ_ankl_cros_y;
  const Scalar t_right_thigh_34 = t_right_thigh_33 + t_right_thigh_13 * t_right_thigh_20;
  const Scalar t_right_thigh_35 = t_right_thigh_34 + t_right_shank_8 * t_right_shank_12;
  const Scalar t_right_thigh_36 = t_right_thigh_35 - neg_Omega_right_thigh_zx * t_right_thigh_9;
  const Scalar t_right_thigh_37 = t_right_thigh_36 - Omega_right_thigh_zy * t_right_thigh_21;
  const Scalar neg_M_right_hip_fork_x = t_right_thigh_37 + a_right_shank_z * t_right_shank_9;
  const Scalar t_left_ankle_cross_22 = s_q2_q3_q4 * t_left_ankle_cross_3;
  const Scalar a_left_ankle_cross_y = t_left_ankle_cross_22 + c_q2_q3_q4 * t_left_ankle_cross_2;
  const Scalar E_left_foot_yy = left_foot_I19 + t_left_foot_4;
  const Scalar t_left_ankle_cross_23 = left_ankle_cross_I8 + E_left_foot_xz;
  const Scalar neg_a_left_foot_z_1 = a_left_ankle_cross_y - left_hip_fork_l2 * t_left_ankle_cross_7;
  const Scalar neg_a_left_foot_z = neg_a_left_foot_z_1 + left_hip_fork_l1 * t_left_ankle_cross_20;
  // left_ankle_cross: moment M, pseudo-inertia E, acceleration a of (1)
  const Scalar t_left_ankle_cross_24 = t_left_hip_fork_5 - t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_25 = left_ankle_cross_I17 * t_left_ankle_cross_20;
  const Scalar t_left_ankle_cross_26 =
      left_ankle_cross_I2 * t_left_ankle_cross_24 - t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_27 =
      t_left_ankle_cross_26 + neg_h_left_foot_y * neg_a_left_foot_z;
  const Scalar t_left_foot_7 = t_left_ankle_cross_16 - t_left_foot_1;
  const Scalar t_left_ankle_cross_28 = t_left_ankle_cross_27 - E_left_foot_yz * t_left_foot_7;
  const Scalar t_left_ankle_cross_29 =
      t_left_ankle_cross_28 + left_ankle_cross_I9 * t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_30 =
      t_left_ankle_cross_29 + neg_Omega_left_foot_zx * neg_E_left_foot_xy;
  const Scalar t_left_ankle_cross_31 = t_left_ankle_cross_30 + Omega_left_foot_zy * E_left_foot_yy;
  const Scalar t_left_ankle_cross_32 =
      t_left_ankle_cross_31 - left_ankle_cross_h1 * a_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_33 =
      t_left_ankle_cross_32 - t_left_ankle_cross_14 * t_left_ankle_cross_23;
  const Scalar M_left_ankle_cross_x = t_left_ankle_cross_33 - left_hip_fork_l2 * neg_F_left_foot_z;
  const Scalar t_left_ankle_cross_34 = left_ankle_cross_I2 + E_left_foot_yz;
  const Scalar t_left_ankle_cross_35 = c_q2_q3_q4 * t_left_ankle_cross_3;
  const Scalar neg_a_left_ankle_cross_x = t_left_ankle_cross_35 - s_q2_q3_q4 * t_left_ankle_cross_2;
  // left_foot: Omega, force F, moment M of (1)
  const Scalar t_left_foot_8 = t_left_ankle_cross_15 - t_left_foot_1;
  const Scalar neg_Omega_left_foot_yy = t_left_ankle_cross_15 + t_left_foot_1;
  const Scalar F_left_foot_y_1 = neg_h_left_foot_y * neg_Omega_left_foot_yy;
  const Scalar F_left_foot_y = t_left_ankle_cross_14 * h_left_foot_x + F_left_foot_y_1;
  const Scalar t_left_foot_9 = left_hip_fork_l2 * h_left_foot_x;
  const Scalar M_left_foot_z_1 = t_left_ankle_cross_13 * (t_left_foot_6 - E_left_foot_yy);
  const Scalar M_left_foot_z_2 =
      neg_a_left_ankle_cross_x + left_hip_fork_l1 * t_left_ankle_cross_18;
  const Scalar M_left_foot_z_3 = t_left_ankle_cross_17 * neg_E_left_foot_xy - M_left_foot_z_1;
  const Scalar M_left_foot_z_4 = M_left_foot_z_3 - neg_h_left_foot_y * M_left_foot_z_2;
  const Scalar M_left_foot_z_5 = M_left_foot_z_4 + t_left_ankle_cross_14 * E_left_foot_xx;
  const Scalar M_left_foot_z_6 = M_left_foot_z_5 - t_left_ankle_cross_9 * E_left_foot_xz;
  const Scalar M_left_foot_z_7 = M_left_foot_z_6 - Omega_left_foot_xz * E_left_foot_yz;
  const Scalar M_left_foot_z_8 = a_left_ankle_cross_z + left_hip_fork_l1 * t_left_ankle_cross_14;
  const Scalar M_left_foot_z_9 = M_left_foot_z_7 - t_left_hip_fork_5 * t_left_foot_9;
  const Scalar M_left_foot_z = M_left_foot_z_9 + h_left_foot_x * M_left_foot_z_8;
  const Scalar F_left_foot_x_1 = h_left_foot_x * (t_left_ankle_cross_21 - t_left_foot_8);
  const Scalar F_left_foot_x = t_left_ankle_cross_13 * neg_h_left_foot_y - F_left_foot_x_1;
  const Scalar t_left_foot_10 = M_left_foot_z - left_ankle_cross_I2 * Omega_left_foot_xz;
  const Scalar t_left_foot_11 = t_left_foot_10 + left_hip_fork_l1 * F_left_foot_y;
  const Scalar t_left_foot_12 = t_left_foot_11 - left_ankle_cross_I8 * t_left_ankle_cross_9;
  const Scalar t_left_foot_13 = t_left_foot_12 + left_ankle_cross_h2 * a_left_ankle_cross_z;
  const Scalar t_left_foot_14 = t_left_foot_13 + left_ankle_cross_I18 * t_left_ankle_cross_14;
  const Scalar t_left_foot_15 = t_left_foot_14 - left_ankle_cross_I17 * t_left_ankle_cross_17;
  const Scalar neg_M_left_ankle_cross_y = t_left_foot_15 - left_hip_fork_l2 * F_left_foot_x;
  const Scalar t_left_foot_16 = neg_F_left_foot_z + left_ankle_cross_h1 * t_left_ankle_cross_21;
  const Scalar F_left_ankle_cross_y = t_left_foot_16 + left_ankle_cross_h2 * t_left_ankle_cross_20;
  const Scalar t_left_foot_17 = F_left_foot_x - left_ankle_cross_h2 * t_left_ankle_cross_18;
  // left_ankle_cross: force F of (1)
  const Scalar F_left_ankle_cross_x = t_left_foot_17 + left_ankle_cross_h1 * Omega_left_foot_xz;
  const Scalar t_left_ankle_cross_36 = F_left_foot_y - left_ankle_cross_h1 * t_left_ankle_cross_9;
  const Scalar F_left_ankle_cross_z =
      t_left_ankle_cross_36 + left_ankle_cross_h2 * t_left_ankle_cross_14;
  const Scalar F_left_shank_z_1 = F_left_ankle_cross_z + neg_Omega_left_shank_zy * t_left_shank_9;
  const Scalar F_left_shank_z = F_left_shank_z_1 - neg_Omega_left_shank_zx * t_left_shank_11;
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_18 = t_left_thigh_10 + t_left_shank_7;
  const Scalar t_left_thigh_19 = left_hip_fork_l1 * t_left_thigh_16;
  const Scalar t_left_thigh_20 = left_hip_fork_l1 - neg_s_left_shank_y;
  const Scalar t_left_shank_12 = t_left_hip_fork_4 - t_left_shank_2;
  const Scalar t_left_thigh_21 = left_hip_fork_I3 - 2.0f * t_left_thigh_18;
  const Scalar t_left_thigh_22 = left_thigh_I11 + t_left_thigh_8;
  const Scalar t_left_shank_13 = left_shank_I10 + t_left_shank_4;
  const Scalar t_left_thigh_23 = t_left_thigh_7 - t_left_thigh_19;
  const Scalar t_left_hip_fork_7 = left_hip_fork_I8 * Omega_left_thigh_xz;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_3 - t_left_hip_fork_4;
  const Scalar t_left_thigh_24 = t_left_hip_fork_7 + c_q2_q3_q4 * M_left_ankle_cross_x;
  const Scalar t_left_thigh_25 = a_left_thigh_z + left_hip_fork_l1 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_26 = t_left_thigh_24 - left_hip_fork_I1 * t_left_hip_fork_8;
  const Scalar t_left_thigh_27 = t_left_thigh_26 + t_left_thigh_14 * t_left_thigh_25;
  const Scalar t_left_thigh_28 = t_left_thigh_27 - F_left_shank_z * t_left_thigh_20;
  const Scalar t_left_thigh_29 = t_left_thigh_28 - Omega_left_thigh_zy * t_left_thigh_22;
  const Scalar t_left_thigh_30 = t_left_thigh_29 - neg_Omega_left_shank_zx * t_left_shank_6;
  const Scalar t_left_thigh_31 = t_left_thigh_30 + neg_s_left_ankle_cross_y * F_left_ankle_cross_z;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + left_hip_fork_I13 * t_left_hip_fork_6;
  const Scalar t_left_thigh_33 = t_left_hip_fork_4 - t_left_thigh_2;
  const Scalar t_left_thigh_34 = t_left_thigh_32 - t_left_thigh_12 * t_left_thigh_33;
  const Scalar t_left_thigh_35 = t_left_thigh_34 - t_left_shank_8 * t_left_shank_12;
  const Scalar t_left_thigh_36 = t_left_thigh_35 - alpha_left_thigh_z * t_left_thigh_21;
  const Scalar t_left_thigh_37 = t_left_thigh_36 + s_q2_q3_q4 * neg_M_left_ankle_cross_y;
  const Scalar t_left_thigh_38 = t_left_thigh_37 + neg_Omega_left_shank_zy * t_left_shank_13;
  const Scalar t_left_thigh_39 = t_left_thigh_38 + a_left_shank_z * t_left_shank_9;
  const Scalar neg_M_left_hip_fork_x = t_left_thigh_39 - neg_Omega_left_thigh_zx * t_left_thigh_23;
  const Scalar t_left_hip_block_1 = M_right_foot_z - tau[11];
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_h2 + h_right_foot_x;
  const Scalar t_right_foot_17 = E_right_foot_xx + E_right_foot_yy;
  const Scalar t_right_foot_18 = left_hip_fork_l1 * h_right_foot_y;
  // right_ankle_cross: first moment h, pseudo-inertia E of (1)
  const Scalar t_righ_ankl_cros_30 = t_right_foot_9 + t_right_foot_10;
  const Scalar t_righ_ankl_cros_31 = left_ankle_cross_h1 * s_q8_q9_q10;
  const Scalar t_righ_ankl_cros_32 = t_righ_ankl_cros_31 + c_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar h_right_shank_x = t_right_shank_10 - t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_33 = left_ankle_cross_h1 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_34 = t_righ_ankl_cros_33 - s_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar neg_h_right_shank_y = t_right_shank_9 - t_righ_ankl_cros_34;
  const Scalar E_righ_ankl_cros_xz_1 = left_ankle_cross_I19 + t_right_foot_5;
  const Scalar E_righ_ankl_cros_xz_2 = t_right_foot_18 - E_righ_ankl_cros_xz_1;
  const Scalar E_righ_ankl_cros_xz = E_righ_ankl_cros_xz_2 - left_hip_fork_l2 * h_right_foot_x;
  const Scalar t_righ_ankl_cros_35 = s_q8_q9_q10 * (left_ankle_cross_I15 - t_righ_ankl_cros_30);
  const Scalar t_righ_ankl_cros_36 = c_q8_q9_q10 * neg_E_righ_ankl_cros_xy;
  const Scalar t_righ_ankl_cros_37 = t_righ_ankl_cros_35 + 2.0f * t_righ_ankl_cros_36;
  const Scalar t_righ_ankl_cros_38 = neg_s_righ_ankl_cros_x * t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_39 = neg_s_righ_ankl_cros_y * t_righ_ankl_cros_34;
  const Scalar t_righ_ankl_cros_40 = neg_s_righ_ankl_cros_y * h_right_foot_y;
  // right_shank: first moment h of (1)
  const Scalar neg_h_right_thigh_y = t_right_thigh_15 + neg_h_right_shank_y;
  const Scalar t_right_shank_14 = neg_s_right_shank_y * neg_h_right_shank_y;
  const Scalar t_right_shank_15 = neg_s_right_shank_x * h_right_shank_x;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_41 = c_q8_q9_q10 * E_righ_ankl_cros_xz;
  const Scalar t_righ_ankl_cros_42 = t_righ_ankl_cros_41 - s_q8_q9_q10 * E_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_43 = neg_s_righ_ankl_cros_x * h_right_foot_y;
  const Scalar t_right_shank_16 = neg_s_right_shank_x * h_right_foot_y;
  const Scalar t_right_shank_17 = t_righ_ankl_cros_30 + 2.0f * t_righ_ankl_cros_38;
  const Scalar t_right_thigh_38 = t_right_thigh_16 - 2.0f * t_right_shank_15;
  const Scalar t_right_shank_18 = left_shank_I18 + t_right_shank_17;
  const Scalar t_right_shank_19 = t_right_shank_18 - 2.0f * t_righ_ankl_cros_39;
  const Scalar t_right_thigh_39 = t_right_thigh_21 + t_right_thigh_38 + t_right_shank_19;
  const Scalar t_right_thigh_40 = t_right_thigh_39 + 2.0f * t_right_shank_14;
  const Scalar t_right_shank_20 = t_right_shank_7 - t_righ_ankl_cros_42;
  const Scalar neg_E_right_shank_xz = t_righ_ankl_cros_43 - t_right_shank_20;
  const Scalar t_right_thigh_41 = t_right_thigh_11 - t_right_shank_16;
  const Scalar neg_E_right_thigh_xz = neg_E_right_shank_xz - t_right_thigh_41;
  // right_hip_fork: pseudo-inertia E of (1)
  const Scalar E_right_hip_fork_xz_1 = left_hip_fork_I2 - t_right_thigh_8;
  const Scalar E_right_hip_fork_xz_2 = t_right_shank_5 - E_right_hip_fork_xz_1;
  const Scalar E_right_hip_fork_xz_3 = E_right_foot_xz + E_right_hip_fork_xz_2;
  const Scalar E_right_hip_fork_xz_4 = left_hip_fork_l1 - neg_s_right_shank_y;
  const Scalar E_right_hip_fork_xz_5 =
      E_right_hip_fork_xz_3 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_34;
  const Scalar E_right_hip_fork_xz_6 =
      E_right_hip_fork_xz_5 + h_right_shank_x * E_right_hip_fork_xz_4;
  const Scalar E_right_hip_fork_xz_7 = E_right_hip_fork_xz_6 + left_hip_fork_l1 * t_right_thigh_18;
  const Scalar E_right_hip_fork_xz_8 = E_right_hip_fork_xz_7 - c_q8_q9_q10 * t_righ_ankl_cros_37;
  const Scalar E_right_hip_fork_xz_9 =
      E_right_hip_fork_xz_8 + neg_s_right_shank_x * neg_h_right_shank_y;
  const Scalar E_right_hip_fork_xz =
      E_right_hip_fork_xz_9 + neg_s_righ_ankl_cros_y * t_righ_ankl_cros_32;
  const Scalar t_right_shank_21 = neg_s_right_shank_y * h_right_foot_y;
  const Scalar h_left_ankle_cross_x = left_ankle_cross_h2 + h_left_foot_x;
  const Scalar t_left_foot_18 = left_hip_fork_l1 * neg_h_left_foot_y;
  // left_ankle_cross: first moment h, pseudo-inertia E of (1)
  const Scalar t_left_ankle_cross_37 = s_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_38 = left_ankle_cross_h1 * c_q2_q3_q4 - t_left_ankle_cross_37;
  const Scalar neg_h_left_shank_y = t_left_shank_9 - t_left_ankle_cross_38;
  const Scalar t_left_ankle_cross_39 = c_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_40 = left_ankle_cross_h1 * s_q2_q3_q4 + t_left_ankle_cross_39;
  const Scalar t_left_ankle_cross_41 = left_ankle_cross_I19 + t_left_foot_5 + t_left_foot_9;
  const Scalar t_left_ankle_cross_42 = t_left_foot_18 - t_left_ankle_cross_41;
  const Scalar t_left_ankle_cross_43 = neg_s_left_ankle_cross_x * t_left_ankle_cross_40;
  const Scalar t_left_ankle_cross_44 = neg_s_left_ankle_cross_y * t_left_ankle_cross_38;
  const Scalar t_left_ankle_cross_45 = neg_s_left_ankle_cross_x * neg_h_left_foot_y;
  const Scalar neg_h_left_thigh_y = t_left_thigh_14 + neg_h_left_shank_y;
  const Scalar t_left_ankle_cross_46 = E_left_foot_xx + left_hip_fork_l3 * h_left_foot_x;
  // left_shank: first moment h, pseudo-inertia E of (1)
  const Scalar t_left_shank_14 = neg_s_left_shank_y * neg_h_left_shank_y;
  const Scalar h_left_shank_x = t_left_shank_11 - t_left_ankle_cross_40;
  const Scalar t_left_shank_15 = neg_s_left_shank_x * h_left_shank_x;
  const Scalar t_left_shank_16 = neg_s_left_shank_x * neg_h_left_foot_y;
  const Scalar t_left_ankle_cross_47 = s_q2_q3_q4 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_48 = t_left_ankle_cross_47 - c_q2_q3_q4 * t_left_ankle_cross_42;
  const Scalar t_left_thigh_40 = t_left_ankle_cross_45 - t_left_ankle_cross_48;
  const Scalar E_left_thigh_xz = t_left_thigh_18 + t_left_shank_16 + t_left_thigh_40;
  const Scalar E_left_shank_xz = t_left_shank_7 + t_left_thigh_40;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_49 = left_ankle_cross_I15 - t_left_ankle_cross_46;
  const Scalar t_left_ankle_cross_50 = c_q2_q3_q4 * t_left_ankle_cross_23 * 2.0f;
  const Scalar t_left_ankle_cross_51 = t_left_ankle_cross_50 + s_q2_q3_q4 * t_left_ankle_cross_49;
  // left_hip_fork: pseudo-inertia E of (1)
  const Scalar E_left_hip_fork_xz_1 = t_left_shank_5 - (left_hip_fork_I2 - t_left_thigh_6);
  const Scalar E_left_hip_fork_xz_2 = E_left_foot_xz + E_left_hip_fork_xz_1;
  const Scalar E_left_hip_fork_xz_3 = t_left_thigh_19 + E_left_hip_fork_xz_2;
  const Scalar E_left_hip_fork_xz_4 = E_left_hip_fork_xz_3 - c_q2_q3_q4 * t_left_ankle_cross_51;
  const Scalar E_left_hip_fork_xz_5 = E_left_hip_fork_xz_4 + t_left_thigh_20 * h_left_shank_x;
  const Scalar E_left_hip_fork_xz_6 =
      E_left_hip_fork_xz_5 + neg_s_left_ankle_cross_y * t_left_ankle_cross_40;
  const Scalar E_left_hip_fork_xz_7 =
      E_left_hip_fork_xz_6 + neg_s_left_shank_x * neg_h_left_shank_y;
  const Scalar E_left_hip_fork_xz =
      E_left_hip_fork_xz_7 - neg_s_left_ankle_cross_x * t_left_ankle_cross_38;
  const Scalar t_left_ankle_cross_52 = neg_s_left_ankle_cross_y * neg_h_left_foot_y;
  const Scalar t_left_shank_17 = neg_s_left_shank_y * neg_h_left_foot_y;
  const Scalar t_right_foot_19 = t_right_foot_9 + t_right_foot_17;
  const Scalar t_right_foot_20 = t_right_foot_19 - left_hip_fork_l2 * h_right_foot_y;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_44 = neg_E_right_foot_yz - s_q8_q9_q10 * t_righ_ankl_cros_43;
  const Scalar t_righ_ankl_cros_45 = t_righ_ankl_cros_44 + c_q8_q9_q10 * t_righ_ankl_cros_40;
  const Scalar t_righ_ankl_cros_46 = c_q8_q9_q10 * t_right_foot_20;
  const Scalar t_righ_ankl_cros_47 = s_q8_q9_q10 * E_right_foot_xz + t_righ_ankl_cros_46;
  // right_shank
  const Scalar t_right_shank_22 = neg_s_right_shank_x + neg_s_righ_ankl_cros_x;
  const Scalar t_right_shank_23 = t_righ_ankl_cros_47 + h_right_foot_x * t_right_shank_22;
  const Scalar t_right_shank_24 = t_righ_ankl_cros_45 + c_q8_q9_q10 * t_right_shank_21;
  const Scalar t_right_shank_25 = t_right_shank_24 - s_q8_q9_q10 * t_right_shank_16;
  // right_thigh
  const Scalar t_right_thigh_42 = t_right_foot_9 - s_q8_q9_q10 * t_right_foot_20;
  const Scalar t_right_thigh_43 = t_right_thigh_42 + c_q8_q9_q10 * E_right_foot_xz;
  const Scalar t_right_thigh_44 = neg_s_right_shank_y + neg_s_righ_ankl_cros_y;
  const Scalar t_right_thigh_45 = t_right_thigh_43 - h_right_foot_x * t_right_thigh_44;
  const Scalar t_right_thigh_46 = t_right_shank_25 - c_q8_q9_q10 * t_right_foot_18;
  const Scalar t_right_hip_fork_9 = c_right_hip_roll * t_right_thigh_45;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_9 + s_right_hip_roll * t_right_thigh_46;
  const Scalar t_left_foot_19 = left_hip_fork_l1 * h_left_foot_x;
  const Scalar t_left_foot_20 = t_left_foot_19 - (t_left_foot_6 - t_right_foot_17);
  const Scalar t_left_ankle_cross_53 = E_left_foot_yz + c_q2_q3_q4 * t_left_ankle_cross_52;
  const Scalar t_left_ankle_cross_54 = t_left_ankle_cross_53 - s_q2_q3_q4 * t_left_ankle_cross_45;
  const Scalar t_left_shank_18 = t_left_ankle_cross_54 - s_q2_q3_q4 * t_left_shank_16;
  const Scalar t_left_shank_19 = t_left_shank_18 + c_q2_q3_q4 * t_left_shank_17;
  // left_thigh
  const Scalar t_left_thigh_41 = t_left_foot_19 + c_q2_q3_q4 * E_left_foot_xz;
  const Scalar t_left_thigh_42 = t_left_thigh_41 - s_q2_q3_q4 * t_left_foot_20;
  const Scalar t_left_thigh_43 = neg_s_left_shank_y + neg_s_left_ankle_cross_y;
  const Scalar t_left_thigh_44 = t_left_shank_19 - c_q2_q3_q4 * t_left_foot_18;
  const Scalar t_left_thigh_45 = t_left_thigh_42 - h_left_foot_x * t_left_thigh_43;
  const Scalar t_left_hip_fork_9 = s_left_hip_roll * t_left_thigh_44;
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_9 - c_left_hip_roll * t_left_thigh_45;
  // right_foot: 1/pivot of (1)
  const Scalar inverse_pivot_right_foot = 1.0f / t_right_foot_17;
  const Scalar t_right_foot_21 = t_right_hip_fork_10 * inverse_pivot_right_foot;
  const Scalar t_right_foot_22 = t_right_shank_25 * inverse_pivot_right_foot;
  const Scalar t_right_foot_23 = neg_E_right_foot_yz * inverse_pivot_right_foot;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_48 = left_ankle_cross_I16 + t_righ_ankl_cros_30;
  const Scalar t_righ_ankl_cros_49 = t_righ_ankl_cros_38 - t_righ_ankl_cros_39;
  const Scalar t_righ_ankl_cros_50 = t_righ_ankl_cros_48 + t_righ_ankl_cros_49;
  const Scalar t_right_shank_26 = t_righ_ankl_cros_50 + neg_s_right_shank_x * t_righ_ankl_cros_32;
  const Scalar t_right_shank_27 = t_right_shank_26 - neg_s_right_shank_y * t_righ_ankl_cros_34;
  const Scalar t_right_thigh_47 = t_right_shank_27 + left_hip_fork_l1 * t_righ_ankl_cros_34;
  const Scalar t_right_hip_fork_11 = c_right_hip_roll * t_righ_ankl_cros_42;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_11 + s_right_hip_roll * t_right_thigh_47;
  const Scalar t_right_foot_24 = t_right_hip_fork_12 - t_right_hip_fork_10 * t_right_foot_23;
  const Scalar t_right_foot_25 = t_right_shank_23 * inverse_pivot_right_foot;
  const Scalar t_righ_ankl_cros_51 = c_q8_q9_q10 * E_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_52 = t_righ_ankl_cros_51 + s_q8_q9_q10 * E_righ_ankl_cros_xz;
  // right_foot
  const Scalar t_right_foot_26 = t_righ_ankl_cros_52 - neg_E_right_foot_yz * t_right_foot_25;
  const Scalar t_right_foot_27 = t_right_shank_27 - neg_E_right_foot_yz * t_right_foot_22;
  const Scalar t_right_foot_28 = t_righ_ankl_cros_45 * inverse_pivot_right_foot;
  const Scalar t_right_foot_29 = t_righ_ankl_cros_50 - t_righ_ankl_cros_45 * t_right_foot_23;
  const Scalar t_right_foot_30 = t_righ_ankl_cros_48 - neg_E_right_foot_yz * t_right_foot_23;
  // right_ankle_cross: 1/pivot of (1)
  const Scalar t_righ_ankl_cros_53 = 1.0f / t_right_foot_30;
  const Scalar t_righ_ankl_cros_54 = t_right_foot_27 * t_righ_ankl_cros_53;
  const Scalar t_righ_ankl_cros_55 = t_right_foot_29 * t_righ_ankl_cros_53;
  const Scalar t_right_shank_28 = t_right_shank_14 - t_right_shank_15 + t_right_shank_19;
  const Scalar t_righ_ankl_cros_56 = t_right_foot_24 * t_righ_ankl_cros_53;
  const Scalar t_right_thigh_48 = t_right_shank_28 - left_hip_fork_l1 * neg_h_right_shank_y;
  const Scalar t_right_hip_fork_13 = c_right_hip_roll * neg_E_right_shank_xz;
  const Scalar t_right_hip_fork_14 = s_right_hip_roll * t_right_thigh_48 + t_right_hip_fork_13;
  const Scalar t_righ_ankl_cros_57 = t_right_hip_fork_14 - t_right_foot_24 * t_righ_ankl_cros_55;
  const Scalar t_righ_ankl_cros_58 = t_righ_ankl_cros_57 - t_righ_ankl_cros_45 * t_right_foot_21;
  const Scalar t_right_foot_31 = t_right_shank_28 - t_right_shank_25 * t_right_foot_28;
  const Scalar t_righ_ankl_cros_59 = t_right_foot_31 - t_right_foot_29 * t_righ_ankl_cros_54;
  const Scalar t_right_foot_32 = t_right_shank_19 - t_righ_ankl_cros_45 * t_right_foot_28;
  const Scalar t_righ_ankl_cros_60 = t_right_foot_26 * t_righ_ankl_cros_53;
  const Scalar t_right_shank_29 = t_right_shank_8 - t_righ_ankl_cros_40;
  const Scalar neg_E_right_shank_yz = t_righ_ankl_cros_52 - t_right_shank_29;
  const Scalar t_right_foot_33 = neg_E_right_shank_yz - t_righ_ankl_cros_45 * t_right_foot_25;
  const Scalar t_righ_ankl_cros_61 = t_right_foot_33 - t_right_foot_29 * t_righ_ankl_cros_60;
  const Scalar t_righ_ankl_cros_62 = t_right_foot_32 - t_right_foot_29 * t_righ_ankl_cros_55;
  const Scalar t_right_shank_30 = 1.0f / t_righ_ankl_cros_62;
  const Scalar t_right_shank_31 = t_righ_ankl_cros_58 * t_right_shank_30;
  const Scalar t_right_hip_fork_15 = c_right_hip_roll * neg_E_right_thigh_xz;
  const Scalar t_right_thigh_49 = t_right_thigh_40 - left_hip_fork_l1 * neg_h_right_thigh_y;
  const Scalar t_right_foot_34 = t_right_hip_fork_15 - t_right_shank_25 * t_right_foot_21;
  const Scalar t_right_foot_35 = t_right_foot_34 + s_right_hip_roll * t_right_thigh_49;
  const Scalar t_righ_ankl_cros_63 = t_right_foot_35 - t_right_foot_24 * t_righ_ankl_cros_54;
  const Scalar t_right_shank_32 = t_righ_ankl_cros_63 - t_righ_ankl_cros_59 * t_right_shank_31;
  const Scalar t_right_shank_33 = t_righ_ankl_cros_59 * t_right_shank_30;
  const Scalar t_right_foot_36 = t_right_thigh_40 - t_right_shank_25 * t_right_foot_22;
  const Scalar t_righ_ankl_cros_64 = t_right_foot_36 - t_right_foot_27 * t_righ_ankl_cros_54;
  const Scalar t_right_thigh_50 = t_right_thigh_13 - t_right_shank_21;
  const Scalar neg_E_right_thigh_yz = neg_E_right_shank_yz - t_right_thigh_50;
  // right_shank
  const Scalar t_right_shank_34 = neg_E_right_thigh_yz - t_righ_ankl_cros_61 * t_right_shank_33;
  const Scalar t_right_shank_35 = t_right_shank_34 - t_right_foot_27 * t_righ_ankl_cros_60;
  const Scalar t_right_shank_36 = t_right_shank_35 - t_right_shank_25 * t_right_foot_25;
  const Scalar t_right_shank_37 = t_righ_ankl_cros_64 - t_righ_ankl_cros_59 * t_right_shank_33;
  const Scalar t_right_thigh_51 = 1.0f / t_right_shank_37;
  const Scalar t_right_thigh_52 = t_right_shank_32 * t_right_thigh_51;
  const Scalar E_right_hip_fork_yz = left_hip_fork_I1 - t_right_foot_18 + neg_E_right_thigh_yz;
  const Scalar t_righ_ankl_cros_65 = t_right_foot_26 * t_righ_ankl_cros_56;
  // right_thigh
  const Scalar t_right_thigh_53 = c_right_hip_roll * E_right_hip_fork_xz + t_righ_ankl_cros_65;
  const Scalar t_right_thigh_54 = t_right_thigh_53 + t_right_hip_fork_10 * t_right_foot_25;
  const Scalar t_right_thigh_55 = t_right_thigh_54 + t_right_shank_36 * t_right_thigh_52;
  const Scalar t_right_thigh_56 = t_right_thigh_55 - s_right_hip_roll * E_right_hip_fork_yz;
  const Scalar t_right_thigh_57 = t_right_thigh_56 + t_righ_ankl_cros_61 * t_right_shank_31;
  const Scalar t_right_shank_38 = t_righ_ankl_cros_61 * t_right_shank_30;
  // right_hip_fork: 1/pivot of (1)
  const Scalar t_right_hip_fork_16 = t_right_foot_6 - left_hip_fork_l4 * h_right_foot_y;
  const Scalar t_right_hip_fork_17 = t_right_shank_4 - t_right_shank_17;
  const Scalar t_right_hip_fork_18 = t_right_thigh_38 - t_right_hip_fork_17;
  const Scalar t_right_hip_fork_19 = t_right_hip_fork_18 + s_q8_q9_q10 * t_righ_ankl_cros_37;
  const Scalar t_right_thigh_58 = t_right_shank_36 * t_right_thigh_51;
  const Scalar t_right_hip_fork_20 = left_hip_fork_I16 + t_right_hip_fork_16;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_19 + t_right_hip_fork_20;
  const Scalar t_right_foot_37 = t_right_hip_fork_21 - t_right_shank_23 * t_right_foot_25;
  const Scalar t_right_shank_39 = t_right_foot_37 - t_righ_ankl_cros_61 * t_right_shank_38;
  const Scalar t_right_shank_40 = t_right_shank_39 - t_right_foot_26 * t_righ_ankl_cros_60;
  const Scalar t_right_thigh_59 = t_right_shank_40 - t_right_shank_36 * t_right_thigh_58;
  const Scalar t_right_hip_fork_22 = 1.0f / t_right_thigh_59;
  const Scalar qdd_6_1 = left_hip_fork_I15 - t_right_hip_fork_16 + t_right_hip_fork_19;
  const Scalar qdd_6_2 = s_right_hip_roll * (left_hip_fork_I3 - 2.0f * neg_E_right_thigh_xz);
  const Scalar t_right_hip_fork_23 = t_right_thigh_57 * t_right_hip_fork_22;
  const Scalar qdd_6_3 = left_hip_block_I3 + t_right_thigh_40;
  const Scalar qdd_6_4 = qdd_6_2 + c_right_hip_roll * qdd_6_1;
  const Scalar qdd_6_5 = qdd_6_3 - c_right_hip_roll * qdd_6_4;
  const Scalar qdd_6_6 = qdd_6_5 - left_hip_fork_l3 * neg_h_right_thigh_y;
  const Scalar qdd_6_7 = qdd_6_6 - t_right_foot_24 * t_righ_ankl_cros_56;
  const Scalar qdd_6_8 = qdd_6_7 - t_right_shank_32 * t_right_thigh_52;
  const Scalar qdd_6_9 = qdd_6_8 - t_right_thigh_57 * t_right_hip_fork_23;
  const Scalar qdd_6_10 = qdd_6_9 - t_righ_ankl_cros_58 * t_right_shank_31;
  const Scalar qdd_6_11 = 1.0f / (qdd_6_10 - t_right_hip_fork_10 * t_right_foot_21);
  const Scalar t_left_ankle_cross_55 = c_q2_q3_q4 * t_left_foot_20;
  const Scalar t_left_ankle_cross_56 = s_q2_q3_q4 * E_left_foot_xz + t_left_ankle_cross_55;
  const Scalar t_left_shank_20 = neg_s_left_shank_x + neg_s_left_ankle_cross_x;
  const Scalar t_left_shank_21 = t_left_ankle_cross_56 + h_left_foot_x * t_left_shank_20;
  // left_foot
  const Scalar t_left_foot_21 = inverse_pivot_right_foot * t_left_shank_21;
  const Scalar t_left_foot_22 = t_left_ankle_cross_54 * inverse_pivot_right_foot;
  const Scalar t_left_foot_23 = E_left_foot_yz * inverse_pivot_right_foot;
  const Scalar t_left_foot_24 = t_left_hip_fork_10 * inverse_pivot_right_foot;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_57 = left_ankle_cross_I16 + t_left_ankle_cross_46;
  const Scalar t_left_ankle_cross_58 = t_left_ankle_cross_43 - t_left_ankle_cross_44;
  const Scalar t_left_ankle_cross_59 = t_left_ankle_cross_57 + t_left_ankle_cross_58;
  const Scalar t_left_shank_22 = t_left_ankle_cross_59 - neg_s_left_shank_y * t_left_ankle_cross_38;
  const Scalar t_left_shank_23 = t_left_shank_22 + neg_s_left_shank_x * t_left_ankle_cross_40;
  const Scalar t_left_hip_fork_11 = c_left_hip_roll * t_left_ankle_cross_48;
  const Scalar t_left_thigh_46 = t_left_shank_23 + left_hip_fork_l1 * t_left_ankle_cross_38;
  const Scalar t_left_foot_25 = t_left_hip_fork_11 - E_left_foot_yz * t_left_foot_24;
  const Scalar t_left_foot_26 = t_left_foot_25 + s_left_hip_roll * t_left_thigh_46;
  const Scalar t_left_ankle_cross_60 = c_q2_q3_q4 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_61 = t_left_ankle_cross_60 + s_q2_q3_q4 * t_left_ankle_cross_42;
  // left_foot
  const Scalar t_left_foot_27 = t_left_ankle_cross_61 - t_left_shank_21 * t_left_foot_23;
  const Scalar t_left_foot_28 = t_left_shank_23 - t_left_shank_19 * t_left_foot_23;
  const Scalar t_left_foot_29 = t_left_ankle_cross_59 - t_left_ankle_cross_54 * t_left_foot_23;
  const Scalar t_left_foot_30 = t_left_ankle_cross_57 - E_left_foot_yz * t_left_foot_23;
  // left_ankle_cross: 1/pivot of (1)
  const Scalar t_left_ankle_cross_62 = 1.0f / t_left_foot_30;
  const Scalar t_left_ankle_cross_63 = t_left_foot_26 * t_left_ankle_cross_62;
  const Scalar t_left_ankle_cross_64 = t_left_foot_28 * t_left_ankle_cross_62;
  // left_shank
  const Scalar t_left_shank_24 = left_shank_I18 - 2.0f * t_left_ankle_cross_44;
  const Scalar t_left_shank_25 = t_left_ankle_cross_46 + 2.0f * t_left_ankle_cross_43;
  const Scalar t_left_shank_26 = t_left_shank_24 + t_left_shank_25;
  const Scalar t_left_shank_27 = t_left_shank_14 - t_left_shank_15 + t_left_shank_26;
  const Scalar t_left_ankle_cross_65 = t_left_foot_29 * t_left_ankle_cross_63;
  const Scalar t_left_thigh_47 = t_left_shank_27 - left_hip_fork_l1 * neg_h_left_shank_y;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_66 = c_left_hip_roll * E_left_shank_xz + t_left_ankle_cross_65;
  const Scalar t_left_ankle_cross_67 = t_left_ankle_cross_66 - s_left_hip_roll * t_left_thigh_47;
  const Scalar t_left_ankle_cross_68 =
      t_left_ankle_cross_67 + t_left_ankle_cross_54 * t_left_foot_24;
  const Scalar t_left_ankle_cross_69 = t_left_shank_27 - t_left_foot_29 * t_left_ankle_cross_64;
  const Scalar t_left_ankle_cross_70 = t_left_ankle_cross_69 - t_left_shank_19 * t_left_foot_22;
  const Scalar t_left_ankle_cross_71 = t_left_foot_29 * t_left_ankle_cross_62;
  const Scalar t_left_foot_31 = t_left_shank_26 - t_left_ankle_cross_54 * t_left_foot_22;
  const Scalar t_left_ankle_cross_72 = t_left_foot_27 * t_left_ankle_cross_62;
  const Scalar E_left_shank_yz_1 = t_left_shank_8 - t_left_ankle_cross_52;
  const Scalar E_left_shank_yz = t_left_ankle_cross_61 - E_left_shank_yz_1;
  const Scalar t_left_foot_32 = E_left_shank_yz - t_left_ankle_cross_54 * t_left_foot_21;
  const Scalar t_left_ankle_cross_73 = t_left_foot_32 - t_left_foot_29 * t_left_ankle_cross_72;
  const Scalar t_left_ankle_cross_74 = t_left_foot_31 - t_left_foot_29 * t_left_ankle_cross_71;
  // left_shank: 1/pivot of (1)
  const Scalar inverse_pivot_left_shank = 1.0f / t_left_ankle_cross_74;
  const Scalar t_left_shank_28 = t_left_ankle_cross_68 * inverse_pivot_left_shank;
  const Scalar t_left_shank_29 = t_left_ankle_cross_70 * inverse_pivot_left_shank;
  // left_thigh
  const Scalar t_left_thigh_48 = t_left_thigh_17 + t_left_shank_25 - 2.0f * t_left_shank_15;
  const Scalar t_left_thigh_49 = t_left_thigh_22 + t_left_shank_24 + t_left_thigh_48;
  const Scalar t_left_thigh_50 = t_left_thigh_49 + 2.0f * t_left_shank_14;
  const Scalar t_left_thigh_51 = t_left_thigh_50 - left_hip_fork_l1 * neg_h_left_thigh_y;
  const Scalar t_left_hip_fork_12 = s_left_hip_roll * t_left_thigh_51;
  const Scalar t_left_hip_fork_13 = c_left_hip_roll * E_left_thigh_xz - t_left_hip_fork_12;
  // left_shank
  const Scalar t_left_shank_30 = t_left_hip_fork_13 + t_left_foot_28 * t_left_ankle_cross_63;
  const Scalar t_left_shank_31 = t_left_shank_30 - t_left_ankle_cross_68 * t_left_shank_29;
  const Scalar t_left_shank_32 = t_left_shank_31 + t_left_shank_19 * t_left_foot_24;
  const Scalar t_left_foot_33 = t_left_shank_19 * inverse_pivot_right_foot;
  const Scalar t_left_shank_33 = t_left_thigh_50 - t_left_foot_28 * t_left_ankle_cross_64;
  const Scalar t_left_shank_34 = t_left_shank_33 - t_left_ankle_cross_70 * t_left_shank_29;
  const Scalar E_left_thigh_yz = E_left_shank_yz - (t_left_thigh_12 - t_left_shank_17);
  const Scalar t_left_shank_35 = E_left_thigh_yz - t_left_ankle_cross_73 * t_left_shank_29;
  const Scalar t_left_shank_36 = t_left_shank_35 - t_left_shank_19 * t_left_foot_21;
  const Scalar t_left_shank_37 = t_left_shank_36 - t_left_foot_27 * t_left_ankle_cross_64;
  const Scalar t_left_shank_38 = t_left_shank_34 - t_left_shank_19 * t_left_foot_33;
  const Scalar inverse_pivot_left_thigh = 1.0f / t_left_shank_38;
  const Scalar t_left_thigh_52 = t_left_shank_32 * inverse_pivot_left_thigh;
  // left_hip_fork: pseudo-inertia E of (1)
  const Scalar neg_E_left_hip_fork_yz = left_hip_fork_I1 - t_left_foot_18 + E_left_thigh_yz;
  const Scalar t_left_hip_fork_14 = s_left_hip_roll * neg_E_left_hip_fork_yz;
  const Scalar t_left_hip_fork_15 = c_left_hip_roll * E_left_hip_fork_xz + t_left_hip_fork_14;
  // left_shank
  const Scalar t_left_shank_39 = t_left_hip_fork_15 - t_left_foot_26 * t_left_ankle_cross_72;
  const Scalar t_left_shank_40 = t_left_shank_39 + t_left_ankle_cross_73 * t_left_shank_28;
  const Scalar t_left_shank_41 = t_left_shank_40 - t_left_hip_fork_10 * t_left_foot_21;
  const Scalar t_left_thigh_53 = t_left_shank_41 + t_left_shank_37 * t_left_thigh_52;
  const Scalar t_left_hip_fork_16 = t_left_foot_4 - left_hip_fork_l4 * neg_h_left_foot_y;
  const Scalar t_left_shank_42 = t_left_ankle_cross_73 * inverse_pivot_left_shank;
  const Scalar t_left_thigh_54 = t_left_shank_37 * inverse_pivot_left_thigh;
  // left_hip_fork
  const Scalar t_left_hip_fork_17 = t_left_shank_4 - t_left_thigh_48;
  const Scalar t_left_hip_fork_18 = t_left_hip_fork_17 - s_q2_q3_q4 * t_left_ankle_cross_51;
  const Scalar t_left_hip_fork_19 = left_hip_fork_I16 + t_left_hip_fork_16;
  const Scalar t_left_hip_fork_20 = t_left_hip_fork_18 - t_left_hip_fork_19;
  // left_thigh
  const Scalar t_left_thigh_55 = t_left_hip_fork_20 + t_left_ankle_cross_73 * t_left_shank_42;
  const Scalar t_left_thigh_56 = t_left_thigh_55 + t_left_shank_21 * t_left_foot_21;
  const Scalar t_left_thigh_57 = t_left_thigh_56 + t_left_shank_37 * t_left_thigh_54;
  const Scalar t_left_thigh_58 = t_left_thigh_57 + t_left_foot_27 * t_left_ankle_cross_72;
  // left_hip_fork: 1/pivot of (1)
  const Scalar t_left_hip_fork_21 = 1.0f / t_left_thigh_58;
  const Scalar t_left_hip_fork_22 = t_left_thigh_53 * t_left_hip_fork_21;
  const Scalar qdd_0_1 = t_left_hip_fork_18 - (left_hip_fork_I15 - t_left_hip_fork_16);
  const Scalar qdd_0_2 = s_left_hip_roll * (left_hip_fork_I3 - 2.0f * E_left_thigh_xz);
  const Scalar qdd_0_3 = left_hip_block_I3 + t_left_thigh_50;
  const Scalar qdd_0_4 = qdd_0_3 - t_left_ankle_cross_68 * t_left_shank_28;
  const Scalar qdd_0_5 = qdd_0_4 - t_left_foot_26 * t_left_ankle_cross_63;
  const Scalar qdd_0_6 = qdd_0_2 + c_left_hip_roll * qdd_0_1;
  const Scalar qdd_0_7 = qdd_0_5 + c_left_hip_roll * qdd_0_6;
  const Scalar qdd_0_8 = qdd_0_7 - t_left_hip_fork_10 * t_left_foot_24;
  const Scalar qdd_0_9 = qdd_0_8 + t_left_thigh_53 * t_left_hip_fork_22;
  const Scalar qdd_0_10 = qdd_0_9 - left_hip_fork_l3 * neg_h_left_thigh_y;
  const Scalar qdd_0_11 = 1.0f / (qdd_0_10 - t_left_shank_32 * t_left_thigh_52);
  const Scalar t_left_hip_block_2 = t_left_hip_block_1 * inverse_pivot_right_foot;
  // right_ankle_cross: moment M of (1)
  const Scalar M_righ_ankl_cros_z_1 = left_ankle_cross_I15 * t_righ_ankl_cros_14;
  const Scalar M_righ_ankl_cros_z_2 =
      M_righ_ankl_cros_z_1 + left_ankle_cross_I16 * alpha_right_thigh_z;
  const Scalar M_righ_ankl_cros_z_3 =
      M_righ_ankl_cros_z_2 + left_ankle_cross_I7 * t_righ_ankl_cros_8;
  const Scalar M_righ_ankl_cros_z_4 =
      M_righ_ankl_cros_z_3 - left_ankle_cross_h1 * neg_a_righ_ankl_cros_x;
  const Scalar M_righ_ankl_cros_z_5 = M_righ_ankl_cros_z_4 - left_hip_fork_l1 * F_right_foot_z;
  const Scalar M_righ_ankl_cros_z_6 =
      M_righ_ankl_cros_z_5 + left_ankle_cross_I17 * t_righ_ankl_cros_13;
  const Scalar M_righ_ankl_cros_z_7 =
      M_righ_ankl_cros_z_6 - left_ankle_cross_I8 * t_right_hip_fork_5;
  const Scalar M_righ_ankl_cros_z_8 = M_righ_ankl_cros_z_7 - Omega_right_foot_zy * E_right_foot_xy;
  const Scalar M_righ_ankl_cros_z_9 =
      M_righ_ankl_cros_z_8 + neg_Omega_right_foot_xy * E_righ_ankl_cros_yz;
  const Scalar M_righ_ankl_cros_z_10 =
      M_righ_ankl_cros_z_9 + neg_Omega_right_foot_zx * E_right_foot_xx;
  const Scalar M_righ_ankl_cros_z_11 =
      M_righ_ankl_cros_z_10 + left_ankle_cross_h2 * a_righ_ankl_cros_y;
  const Scalar M_righ_ankl_cros_z_12 = M_righ_ankl_cros_z_11 + t_right_foot_2 * E_right_foot_xz;
  const Scalar M_righ_ankl_cros_z = M_righ_ankl_cros_z_12 + h_right_foot_x * neg_a_right_foot_z;
  const Scalar t_left_hip_block_3 = tau[10] - M_righ_ankl_cros_z;
  const Scalar t_left_hip_block_4 = t_left_hip_block_3 + neg_E_right_foot_yz * t_left_hip_block_2;
  const Scalar t_righ_ankl_cros_66 = c_q8_q9_q10 * neg_F_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_67 = t_righ_ankl_cros_66 + s_q8_q9_q10 * neg_F_righ_ankl_cros_x;
  // right_shank: moment M of (1)
  const Scalar M_right_shank_z_1 = M_righ_ankl_cros_z + Omega_right_thigh_yz * t_right_shank_7;
  const Scalar M_right_shank_z_2 = M_right_shank_z_1 - neg_s_righ_ankl_cros_x * t_righ_ankl_cros_67;
  const Scalar M_right_shank_z_3 = M_right_shank_z_2 + t_right_shank_1 * t_right_shank_6;
  const Scalar M_right_shank_z_4 = M_right_shank_z_3 - Omega_right_thigh_xz * t_right_shank_8;
  const Scalar M_right_shank_z_5 = M_right_shank_z_4 + Omega_right_hip_fork_zx * t_right_shank_11;
  const Scalar M_right_shank_z_6 = M_right_shank_z_5 - neg_s_righ_ankl_cros_y * t_righ_ankl_cros_28;
  const Scalar M_right_shank_z_7 = M_right_shank_z_6 - t_right_shank_10 * neg_a_right_shank_y;
  const Scalar M_right_shank_z = M_right_shank_z_7 + t_right_shank_9 * a_right_shank_x;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_5 = tau[9] - M_right_shank_z;
  const Scalar t_left_hip_block_6 = t_left_hip_block_5 + t_left_hip_block_1 * t_right_foot_28;
  const Scalar t_left_hip_block_7 = t_left_hip_block_6 - t_righ_ankl_cros_55 * t_left_hip_block_4;
  const Scalar t_right_hip_fork_24 = t_right_hip_fork_2 - t_right_hip_fork_3;
  const Scalar neg_F_right_shank_x =
      t_righ_ankl_cros_28 + neg_Omega_right_shank_xx * t_right_shank_10;
  const Scalar F_right_shank_y_1 = t_righ_ankl_cros_67 + Omega_right_hip_fork_zx * t_right_shank_10;
  const Scalar F_right_shank_y = F_right_shank_y_1 + neg_Omega_right_shank_yy * t_right_shank_9;
  // right_thigh: moment M of (1)
  const Scalar M_right_thigh_z_1 = M_right_shank_z + a_right_hip_fork_x * t_right_thigh_15;
  const Scalar M_right_thigh_z_2 = M_right_thigh_z_1 + Omega_right_thigh_yz * t_right_thigh_11;
  const Scalar M_right_thigh_z_3 = M_right_thigh_z_2 - neg_a_right_thigh_y * t_right_thigh_18;
  const Scalar M_right_thigh_z_4 = M_right_thigh_z_3 - Omega_right_thigh_xz * t_right_thigh_13;
  const Scalar M_right_thigh_z_5 = M_right_thigh_z_4 + t_right_shank_1 * t_right_thigh_9;
  const Scalar M_right_thigh_z_6 = M_right_thigh_z_5 - neg_s_right_shank_x * F_right_shank_y;
  const Scalar M_right_thigh_z_7 = M_right_thigh_z_6 + Omega_right_hip_fork_zx * t_right_thigh_16;
  const Scalar M_right_thigh_z = M_right_thigh_z_7 - neg_s_right_shank_y * neg_F_right_shank_x;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_8 = tau[8] - M_right_thigh_z;
  const Scalar t_left_hip_block_9 = t_left_hip_block_8 - t_right_shank_33 * t_left_hip_block_7;
  const Scalar t_left_hip_block_10 = t_left_hip_block_9 - t_righ_ankl_cros_54 * t_left_hip_block_4;
  const Scalar t_left_hip_block_11 = t_left_hip_block_10 + t_left_hip_block_1 * t_right_foot_22;
  const Scalar t_right_shank_41 = t_right_hip_fork_5 - neg_Omega_right_shank_xx;
  const Scalar t_left_hip_block_12 = tau[7] + left_hip_fork_G1 * c_right_hip_roll;
  const Scalar t_left_hip_block_13 = t_left_hip_block_12 - s_q8_q9_q10 * neg_M_righ_ankl_cros_x;
  const Scalar t_left_hip_block_14 = t_left_hip_block_13 - left_hip_fork_I14 * Omega_right_thigh_xz;
  const Scalar t_left_hip_block_15 =
      t_left_hip_block_14 - neg_Omega_right_shank_zx * t_right_shank_11;
  const Scalar t_left_hip_block_16 = t_left_hip_block_15 + left_hip_fork_I7 * t_right_hip_fork_24;
  const Scalar t_left_hip_block_17 = left_hip_fork_G2 - base_g1 * t_right_thigh_18;
  const Scalar t_left_hip_block_18 = t_left_hip_block_16 - t_right_thigh_2 * t_right_thigh_11;
  const Scalar t_left_hip_block_19 = t_left_hip_block_18 - s_right_hip_roll * t_left_hip_block_17;
  const Scalar t_left_hip_block_20 = t_left_hip_block_19 - t_right_thigh_58 * t_left_hip_block_11;
  const Scalar t_left_hip_block_21 = t_left_hip_block_20 - t_right_shank_38 * t_left_hip_block_7;
  const Scalar t_left_hip_block_22 =
      t_left_hip_block_21 + neg_s_right_shank_x * neg_F_right_shank_z;
  const Scalar t_left_hip_block_23 = t_left_hip_block_22 - Omega_right_thigh_zy * t_right_thigh_9;
  const Scalar t_left_hip_block_24 = t_left_hip_block_23 - c_q8_q9_q10 * neg_M_righ_ankl_cros_y;
  const Scalar t_left_hip_block_25 = t_left_hip_block_24 - t_righ_ankl_cros_60 * t_left_hip_block_4;
  const Scalar t_left_hip_block_26 = t_left_hip_block_25 + t_left_hip_block_1 * t_right_foot_25;
  const Scalar t_left_hip_block_27 =
      t_left_hip_block_26 + neg_Omega_right_shank_zy * t_right_shank_6;
  const Scalar t_left_hip_block_28 = t_left_hip_block_27 + a_right_shank_z * t_right_shank_10;
  const Scalar t_left_hip_block_29 = t_left_hip_block_28 - t_right_shank_7 * t_right_shank_41;
  const Scalar t_left_hip_block_30 =
      t_left_hip_block_29 + neg_s_righ_ankl_cros_x * neg_F_righ_ankl_cros_z;
  const Scalar neg_F_right_thigh_x =
      neg_F_right_shank_x + neg_Omega_right_thigh_xx * t_right_thigh_18;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_60 = M_right_thigh_z + left_hip_fork_I3 * t_right_hip_fork_6;
  const Scalar t_right_thigh_61 = t_right_thigh_60 + left_hip_fork_l1 * neg_F_right_thigh_x;
  const Scalar t_right_thigh_62 = t_right_thigh_61 + left_hip_fork_I8 * t_right_shank_1;
  const Scalar t_right_thigh_63 = t_right_thigh_62 + left_hip_fork_I1 * Omega_right_thigh_xz;
  const Scalar t_left_hip_block_31 =
      t_left_hip_block_30 - neg_Omega_right_thigh_zx * t_right_thigh_16;
  const Scalar t_left_hip_block_32 = t_right_hip_fork_22 * t_left_hip_block_31;
  const Scalar neg_M_right_hip_fork_y = t_right_thigh_63 + left_hip_fork_I12 * alpha_right_thigh_z;
  // left_hip_block: qdd of (1)
  const Scalar qdd_6_12 = tau[6] - s_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar qdd_6_13 = qdd_6_12 - t_right_thigh_52 * t_left_hip_block_11;
  const Scalar qdd_6_14 = qdd_6_13 + t_right_thigh_57 * t_left_hip_block_32;
  const Scalar qdd_6_15 = qdd_6_14 + t_left_hip_block_1 * t_right_foot_21;
  const Scalar qdd_6_16 = qdd_6_15 - t_righ_ankl_cros_56 * t_left_hip_block_4;
  const Scalar qdd_6_17 = qdd_6_16 - t_right_shank_31 * t_left_hip_block_7;
  const Scalar qdd_6 = qdd_6_11 * (qdd_6_17 + c_right_hip_roll * neg_M_right_hip_fork_x);
  qdd[6] = qdd_6;
  const Scalar qdd_7 = t_left_hip_block_32 + t_right_hip_fork_23 * qdd_6;
  qdd[7] = qdd_7;
  const Scalar qdd_8_1 = t_left_hip_block_11 - t_right_shank_32 * qdd_6;
  const Scalar qdd_8 = t_right_thigh_51 * (qdd_8_1 - t_right_shank_36 * qdd_7);
  qdd[8] = qdd_8;
  const Scalar qdd_9_1 = t_left_hip_block_7 - t_righ_ankl_cros_58 * qdd_6;
  const Scalar qdd_9_2 = qdd_9_1 - t_righ_ankl_cros_59 * qdd_8;
  const Scalar qdd_9 = t_right_shank_30 * (qdd_9_2 - t_righ_ankl_cros_61 * qdd_7);
  qdd[9] = qdd_9;
  const Scalar qdd_10_1 = t_left_hip_block_4 - t_right_foot_24 * qdd_6;
  const Scalar qdd_10_2 = qdd_10_1 - t_right_foot_26 * qdd_7 - t_right_foot_27 * qdd_8;
  const Scalar qdd_10 = t_righ_ankl_cros_53 * (qdd_10_2 - t_right_foot_29 * qdd_9);
  qdd[10] = qdd_10;
  const Scalar neg_qdd_11_1 = t_left_hip_block_2 + t_right_foot_21 * qdd_6;
  const Scalar neg_qdd_11_2 = neg_qdd_11_1 + t_right_foot_25 * qdd_7;
  const Scalar neg_qdd_11_3 = neg_qdd_11_2 + t_right_foot_22 * qdd_8;
  qdd[11] = -(neg_qdd_11_3 + t_right_foot_23 * qdd_10 + t_right_foot_28 * qdd_9);
  const Scalar t_left_hip_block_33 = M_left_foot_z - tau[5];
  const Scalar t_left_hip_block_34 = inverse_pivot_right_foot * t_left_hip_block_33;
  // left_ankle_cross: moment M of (1)
  const Scalar t_left_ankle_cross_75 = left_ankle_cross_I15 * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_76 =
      t_left_ankle_cross_75 + left_ankle_cross_I16 * alpha_left_thigh_z;
  const Scalar t_left_ankle_cross_77 =
      t_left_ankle_cross_76 + left_ankle_cross_I7 * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_78 =
      t_left_ankle_cross_77 + left_ankle_cross_h2 * a_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_79 =
      t_left_ankle_cross_78 - left_ankle_cross_h1 * neg_a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_80 =
      t_left_ankle_cross_79 - t_left_ankle_cross_13 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_81 = t_left_ankle_cross_80 + h_left_foot_x * neg_a_left_foot_z;
  const Scalar t_left_ankle_cross_82 = t_left_ankle_cross_81 + E_left_foot_xz * t_left_foot_8;
  const Scalar t_left_ankle_cross_83 =
      t_left_ankle_cross_82 - left_ankle_cross_I17 * t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_84 =
      t_left_ankle_cross_83 - left_ankle_cross_I8 * t_left_hip_fork_5;
  const Scalar t_left_ankle_cross_85 =
      t_left_ankle_cross_84 + Omega_left_foot_zy * neg_E_left_foot_xy;
  const Scalar t_left_ankle_cross_86 =
      t_left_ankle_cross_85 + neg_Omega_left_foot_zx * E_left_foot_xx;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_86 + left_hip_fork_l1 * neg_F_left_foot_z;
  const Scalar t_left_hip_block_35 = tau[4] - M_left_ankle_cross_z;
  const Scalar t_left_hip_block_36 = t_left_hip_block_35 - t_left_foot_23 * t_left_hip_block_33;
  const Scalar t_left_ankle_cross_87 = s_q2_q3_q4 * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_88 = t_left_ankle_cross_87 + c_q2_q3_q4 * F_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_89 = s_q2_q3_q4 * F_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_90 = t_left_ankle_cross_89 - c_q2_q3_q4 * F_left_ankle_cross_x;
  // left_shank: moment M of (1)
  const Scalar M_left_shank_z_1 = M_left_ankle_cross_z + Omega_left_thigh_yz * t_left_shank_7;
  const Scalar M_left_shank_z_2 =
      M_left_shank_z_1 + neg_s_left_ankle_cross_x * t_left_ankle_cross_88;
  const Scalar M_left_shank_z_3 = M_left_shank_z_2 + Omega_left_hip_fork_zx * t_left_shank_10;
  const Scalar M_left_shank_z_4 = M_left_shank_z_3 + Omega_left_thigh_xz * t_left_shank_8;
  const Scalar M_left_shank_z_5 = M_left_shank_z_4 + t_left_shank_9 * a_left_shank_x;
  const Scalar M_left_shank_z_6 =
      M_left_shank_z_5 + neg_s_left_ankle_cross_y * t_left_ankle_cross_90;
  const Scalar M_left_shank_z_7 = M_left_shank_z_6 + t_left_shank_1 * t_left_shank_6;
  const Scalar M_left_shank_z = M_left_shank_z_7 - t_left_shank_11 * neg_a_left_shank_y;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_37 = t_left_ankle_cross_62 * t_left_hip_block_36;
  const Scalar t_left_hip_block_38 = tau[3] - M_left_shank_z;
  const Scalar t_left_hip_block_39 =
      t_left_hip_block_38 - t_left_ankle_cross_54 * t_left_hip_block_34;
  const Scalar t_left_hip_block_40 = t_left_hip_block_39 - t_left_foot_29 * t_left_hip_block_37;
  const Scalar F_left_shank_x = t_left_ankle_cross_90 - t_left_shank_11 * neg_Omega_left_shank_xx;
  const Scalar t_left_hip_fork_23 = t_left_hip_fork_1 - t_left_hip_fork_3;
  const Scalar t_left_hip_block_41 = left_hip_fork_G2 - base_g1 * t_left_thigh_16;
  const Scalar t_left_shank_43 = t_left_hip_fork_1 - t_left_shank_2;
  const Scalar t_left_thigh_59 = t_left_hip_fork_1 - t_left_thigh_2;
  const Scalar neg_F_left_shank_y_1 =
      t_left_ankle_cross_88 - Omega_left_hip_fork_zx * t_left_shank_11;
  // left_thigh: moment M of (1)
  const Scalar M_left_thigh_z_1 = M_left_shank_z - neg_a_left_thigh_y * t_left_thigh_16;
  const Scalar M_left_thigh_z_2 = M_left_thigh_z_1 + t_left_shank_1 * t_left_thigh_7;
  const Scalar M_left_thigh_z_3 = M_left_thigh_z_2 + neg_s_left_shank_y * F_left_shank_x;
  const Scalar M_left_thigh_z_4 = M_left_thigh_z_3 + Omega_left_thigh_xz * t_left_thigh_12;
  const Scalar M_left_thigh_z_5 = M_left_thigh_z_4 + Omega_left_hip_fork_zx * t_left_thigh_17;
  const Scalar M_left_thigh_z_6 = M_left_thigh_z_5 + Omega_left_thigh_yz * t_left_thigh_10;
  const Scalar neg_F_left_shank_y = neg_F_left_shank_y_1 - t_left_shank_9 * neg_Omega_left_shank_yy;
  const Scalar M_left_thigh_z_7 = M_left_thigh_z_6 + a_left_hip_fork_x * t_left_thigh_14;
  const Scalar M_left_thigh_z = M_left_thigh_z_7 + neg_s_left_shank_x * neg_F_left_shank_y;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_42 = tau[2] - M_left_thigh_z;
  const Scalar t_left_hip_block_43 = t_left_hip_block_42 - t_left_foot_33 * t_left_hip_block_33;
  const Scalar t_left_hip_block_44 = t_left_hip_block_43 - t_left_shank_29 * t_left_hip_block_40;
  const Scalar t_left_hip_block_45 =
      t_left_hip_block_44 - t_left_ankle_cross_64 * t_left_hip_block_36;
  const Scalar t_left_hip_block_46 = inverse_pivot_left_thigh * t_left_hip_block_45;
  const Scalar t_left_hip_block_47 = tau[1] - left_hip_fork_G1 * c_left_hip_roll;
  const Scalar t_left_hip_block_48 = t_left_hip_block_47 + s_q2_q3_q4 * M_left_ankle_cross_x;
  const Scalar t_left_hip_block_49 = t_left_hip_block_48 + t_left_foot_21 * t_left_hip_block_33;
  const Scalar t_left_hip_block_50 =
      t_left_hip_block_49 - neg_Omega_left_thigh_zx * t_left_thigh_17;
  const Scalar t_left_hip_block_51 = t_left_hip_block_50 + neg_Omega_left_shank_zy * t_left_shank_6;
  const Scalar t_left_hip_block_52 = t_left_hip_block_51 + left_hip_fork_I7 * t_left_hip_fork_23;
  const Scalar t_left_hip_block_53 = t_left_hip_block_52 + a_left_shank_z * t_left_shank_11;
  const Scalar t_left_hip_block_54 =
      t_left_hip_block_53 - neg_s_left_ankle_cross_x * F_left_ankle_cross_z;
  const Scalar t_left_hip_block_55 = t_left_hip_block_54 - neg_s_left_shank_x * F_left_shank_z;
  const Scalar t_left_hip_block_56 = t_left_hip_block_55 - s_left_hip_roll * t_left_hip_block_41;
  const Scalar t_left_hip_block_57 = t_left_hip_block_56 - t_left_shank_7 * t_left_shank_43;
  const Scalar t_left_hip_block_58 =
      t_left_hip_block_57 - neg_Omega_left_shank_zx * t_left_shank_10;
  const Scalar t_left_hip_block_59 = t_left_hip_block_58 - left_hip_fork_I14 * Omega_left_thigh_xz;
  const Scalar t_left_hip_block_60 = t_left_hip_block_59 - t_left_thigh_10 * t_left_thigh_59;
  const Scalar t_left_hip_block_61 = t_left_hip_block_60 - c_q2_q3_q4 * neg_M_left_ankle_cross_y;
  const Scalar t_left_hip_block_62 = t_left_hip_block_61 + t_left_shank_37 * t_left_hip_block_46;
  const Scalar t_left_hip_block_63 = t_left_hip_block_62 + t_left_shank_42 * t_left_hip_block_40;
  const Scalar t_left_hip_block_64 = t_left_hip_block_63 - Omega_left_thigh_zy * t_left_thigh_7;
  const Scalar t_left_hip_block_65 =
      t_left_hip_block_64 + t_left_ankle_cross_72 * t_left_hip_block_36;
  // left_thigh: force F, moment M of (1)
  const Scalar F_left_thigh_x = F_left_shank_x - neg_Omega_left_thigh_xx * t_left_thigh_16;
  const Scalar t_left_thigh_60 = M_left_thigh_z - left_hip_fork_I3 * t_left_hip_fork_6;
  const Scalar t_left_thigh_61 = t_left_thigh_60 - left_hip_fork_l1 * F_left_thigh_x;
  const Scalar t_left_thigh_62 = t_left_thigh_61 - left_hip_fork_I1 * Omega_left_thigh_xz;
  const Scalar t_left_thigh_63 = t_left_thigh_62 + left_hip_fork_I12 * alpha_left_thigh_z;
  const Scalar neg_M_left_hip_fork_y = t_left_thigh_63 + left_hip_fork_I8 * t_left_shank_1;
  // left_hip_block: qdd of (1)
  const Scalar qdd_0_12 = tau[0] - s_left_hip_roll * neg_M_left_hip_fork_y;
  const Scalar qdd_0_13 = qdd_0_12 + c_left_hip_roll * neg_M_left_hip_fork_x;
  const Scalar qdd_0_14 = qdd_0_13 - t_left_ankle_cross_63 * t_left_hip_block_36;
  const Scalar qdd_0_15 = qdd_0_14 + t_left_thigh_52 * t_left_hip_block_45;
  const Scalar qdd_0_16 = qdd_0_15 - t_left_hip_fork_22 * t_left_hip_block_65;
  const Scalar qdd_0_17 = qdd_0_16 - t_left_foot_24 * t_left_hip_block_33;
  const Scalar qdd_0 = qdd_0_11 * (qdd_0_17 + t_left_shank_28 * t_left_hip_block_40);
  qdd[0] = qdd_0;
  const Scalar neg_qdd_1_1 = t_left_hip_fork_21 * t_left_hip_block_65;
  const Scalar neg_qdd_1 = neg_qdd_1_1 + t_left_hip_fork_22 * qdd_0;
  qdd[1] = -neg_qdd_1;
  const Scalar qdd_2_1 = t_left_hip_block_46 + t_left_thigh_52 * qdd_0;
  const Scalar qdd_2 = qdd_2_1 - t_left_thigh_54 * neg_qdd_1;
  qdd[2] = qdd_2;
  const Scalar neg_qdd_3_1 = t_left_hip_block_40 + t_left_ankle_cross_68 * qdd_0;
  const Scalar neg_qdd_3_2 = neg_qdd_3_1 - t_left_ankle_cross_73 * neg_qdd_1;
  const Scalar neg_qdd_3 = t_left_shank_29 * qdd_2 - inverse_pivot_left_shank * neg_qdd_3_2;
  qdd[3] = -neg_qdd_3;
  const Scalar qdd_4_1 = t_left_hip_block_37 - t_left_ankle_cross_63 * qdd_0;
  const Scalar qdd_4_2 = qdd_4_1 + t_left_ankle_cross_71 * neg_qdd_3;
  const Scalar qdd_4_3 = qdd_4_2 - t_left_ankle_cross_72 * neg_qdd_1;
  const Scalar qdd_4 = qdd_4_3 - t_left_ankle_cross_64 * qdd_2;
  qdd[4] = qdd_4;
  const Scalar neg_qdd_5_1 = t_left_hip_block_34 - t_left_foot_24 * qdd_0;
  const Scalar neg_qdd_5_2 = neg_qdd_5_1 - t_left_foot_21 * neg_qdd_1;
  const Scalar neg_qdd_5_3 = neg_qdd_5_2 + t_left_foot_22 * neg_qdd_3;
  qdd[5] = t_left_foot_23 * qdd_4 - (neg_qdd_5_3 - t_left_foot_33 * qdd_2);
}

void point_positions(const Scalar q[12], Scalar p[12]) noexcept {
  const Scalar q_q3_q4 = q[3] + q[4];
  const Scalar q_q2_q3_q4 = q[2] + q_q3_q4;
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[0], q[1], q_q2_q3_q4, q_q3_q4, q[4], q[5], q[6], q[7]);
  sines_cosines(sines + 8, cosines + 8, q_q8_q9_q10, q_q9_q10, q[10], q[11]);
  const Scalar s_left_hip_yaw = sines[0];
  const Scalar c_left_hip_yaw = cosines[0];
  const Scalar s_left_hip_roll = sines[1];
  const Scalar c_left_hip_roll = cosines[1];
  const Scalar s_q2_q3_q4 = sines[2];
  const Scalar c_q2_q3_q4 = cosines[2];
  const Scalar s_q3_q4 = sines[3];
  const Scalar c_q3_q4 = cosines[3];
  const Scalar s_left_ankle_pitch = sines[4];
  const Scalar c_left_ankle_pitch = cosines[4];
  const Scalar s_left_ankle_roll = sines[5];
  const Scalar c_left_ankle_roll = cosines[5];
  const Scalar s_right_hip_yaw = sines[6];
  const Scalar c_right_hip_yaw = cosines[6];
  const Scalar s_right_hip_roll = sines[7];
  const Scalar c_right_hip_roll = cosines[7];
  const Scalar s_q8_q9_q10 = sines[8];
  const Scalar c_q8_q9_q10 = cosines[8];
  const Scalar s_q9_q10 = sines[9];
  const Scalar c_q9_q10 = cosines[9];
  const Scalar s_right_ankle_pitch = sines[10];
  const Scalar c_right_ankle_pitch = cosines[10];
  const Scalar s_right_ankle_roll = sines[11];
  const Scalar c_right_ankle_roll = cosines[11];
  // left_shank
  const Scalar t_left_shank_1 = left_hip_fork_l1 + left_shank_l1 * c_q3_q4;
  const Scalar t_left_shank_2 = t_left_shank_1 + left_ankle_cross_l1 * c_left_ankle_pitch;
  const Scalar t_left_shank_3 = t_left_shank_2 + left_foot_l2 * c_left_ankle_roll;
  const Scalar t_left_thigh_1 = c_q2_q3_q4 * t_left_shank_3;
  const Scalar t_left_thigh_2 = left_hip_fork_l2 + left_foot_l2 * s_left_ankle_roll;
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * t_left_thigh_2;
  const Scalar s_left_ankle_cross_y = left_ankle_cross_l1 * s_left_ankle_pitch;
  const Scalar t_left_shank_4 = left_shank_l1 * s_q3_q4 + s_left_ankle_cross_y;
  const Scalar t_left_shank_5 = left_foot_l1 - t_left_shank_4;
  const Scalar t_left_thigh_3 = t_left_thigh_1 - s_q2_q3_q4 * t_left_shank_5;
  // left_hip_fork
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + s_left_hip_roll * t_left_thigh_3;
  const Scalar t_left_hip_fork_3 = left_hip_fork_l1 - s_q2_q3_q4 * t_left_shank_3;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 - c_q2_q3_q4 * t_left_shank_5;
  // left_hip_block: p of 1.2
  const Scalar p_1_1 = left_hip_block_l1 + c_left_hip_yaw * t_left_hip_fork_2;
  p[1] = p_1_1 + s_left_hip_yaw * t_left_hip_fork_4;
  p[0] = c_left_hip_yaw * t_left_hip_fork_4 - s_left_hip_yaw * t_left_hip_fork_2;
  const Scalar t_left_hip_block_1 = left_hip_block_l2 - s_left_hip_roll * t_left_thigh_2;
  p[2] = -(t_left_hip_block_1 + c_left_hip_roll * t_left_thigh_3);
  const Scalar t_left_shank_6 = left_foot_l3 + t_left_shank_4;
  const Scalar t_left_thigh_4 = t_left_thigh_1 + s_q2_q3_q4 * t_left_shank_6;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_1 + s_left_hip_roll * t_left_thigh_4;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_3 + c_q2_q3_q4 * t_left_shank_6;
  const Scalar p_4_1 = left_hip_block_l1 + c_left_hip_yaw * t_left_hip_fork_5;
  p[4] = p_4_1 + s_left_hip_yaw * t_left_hip_fork_6;
  p[3] = c_left_hip_yaw * t_left_hip_fork_6 - s_left_hip_yaw * t_left_hip_fork_5;
  p[5] = -(t_left_hip_block_1 + c_left_hip_roll * t_left_thigh_4);
  // right_shank
  const Scalar t_right_shank_1 = left_hip_fork_l1 + left_shank_l1 * c_q9_q10;
  const Scalar t_right_shank_2 = t_right_shank_1 + left_ankle_cross_l1 * c_right_ankle_pitch;
  const Scalar t_right_shank_3 = t_right_shank_2 + left_foot_l2 * c_right_ankle_roll;
  const Scalar t_right_thigh_1 = c_q8_q9_q10 * t_right_shank_3;
  const Scalar t_right_thigh_2 = left_hip_fork_l2 - left_foot_l2 * s_right_ankle_roll;
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * t_right_thigh_2;
  const Scalar t_right_hip_fork_2 = left_hip_fork_l1 - s_q8_q9_q10 * t_right_shank_3;
  const Scalar s_righ_ankl_cros_y = left_ankle_cross_l1 * s_right_ankle_pitch;
  const Scalar t_right_shank_4 = left_shank_l1 * s_q9_q10 + s_righ_ankl_cros_y;
  const Scalar t_right_shank_5 = left_foot_l1 - t_right_shank_4;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 - c_q8_q9_q10 * t_right_shank_5;
  const Scalar t_right_thigh_3 = t_right_thigh_1 - s_q8_q9_q10 * t_right_shank_5;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_1 - s_right_hip_roll * t_right_thigh_3;
  // right_hip_block: p of 1.2
  const Scalar neg_p_7_1 = left_hip_block_l1 - s_right_hip_yaw * t_right_hip_fork_3;
  p[7] = -(neg_p_7_1 + c_right_hip_yaw * t_right_hip_fork_4);
  p[6] = c_right_hip_yaw * t_right_hip_fork_3 + s_right_hip_yaw * t_right_hip_fork_4;
  const Scalar t_right_hip_block_1 = left_hip_block_l2 + s_right_hip_roll * t_right_thigh_2;
  p[8] = -(t_right_hip_block_1 + c_right_hip_roll * t_right_thigh_3);
  const Scalar t_right_shank_6 = left_foot_l3 + t_right_shank_4;
  const Scalar t_right_thigh_4 = t_right_thigh_1 + s_q8_q9_q10 * t_right_shank_6;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_1 - s_right_hip_roll * t_right_thigh_4;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_2 + c_q8_q9_q10 * t_right_shank_6;
  const Scalar neg_p_10_1 = left_hip_block_l1 + c_right_hip_yaw * t_right_hip_fork_5;
  p[10] = s_right_hip_yaw * t_right_hip_fork_6 - neg_p_10_1;
  p[9] = s_right_hip_yaw * t_right_hip_fork_5 + c_right_hip_yaw * t_right_hip_fork_6;
  p[11] = -(t_right_hip_block_1 + c_right_hip_roll * t_right_thigh_4);
}

void force_jacobian_transpose(const Scalar q[12], Scalar C[144]) noexcept {
  const Scalar q_q2_q3 = q[2] + q[3];
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[0], q[1], q[2], q_q2_q3_q4, q_q2_q3, q[6], q[7], q[8]);
  sines_cosines(sines + 8, cosines + 8, q_q8_q9_q10, q_q8_q9, q[11], q[5]);
  const Scalar s_left_hip_yaw = sines[0];
  const Scalar c_left_hip_yaw = cosines[0];
  const Scalar s_left_hip_roll = sines[1];
  const Scalar c_left_hip_roll = cosines[1];
  const Scalar s_left_hip_pitch = sines[2];
  const Scalar c_left_hip_pitch = cosines[2];
  const Scalar s_q2_q3_q4 = sines[3];
  const Scalar c_q2_q3_q4 = cosines[3];
  const Scalar s_q2_q3 = sines[4];
  const Scalar c_q2_q3 = cosines[4];
  const Scalar s_right_hip_yaw = sines[5];
  const Scalar c_right_hip_yaw = cosines[5];
  const Scalar s_right_hip_roll = sines[6];
  const Scalar c_right_hip_roll = cosines[6];
  const Scalar s_right_hip_pitch = sines[7];
  const Scalar c_right_hip_pitch = cosines[7];
  const Scalar s_q8_q9_q10 = sines[8];
  const Scalar c_q8_q9_q10 = cosines[8];
  const Scalar s_q8_q9 = sines[9];
  const Scalar c_q8_q9 = cosines[9];
  const Scalar s_right_ankle_roll = sines[10];
  const Scalar c_right_ankle_roll = cosines[10];
  const Scalar s_left_ankle_roll = sines[11];
  const Scalar c_left_ankle_roll = cosines[11];
  const Scalar neg_s_left_shank_x = left_shank_l1 * c_left_hip_pitch;
  const Scalar neg_s_left_shank_y = left_shank_l1 * s_left_hip_pitch;
  const Scalar neg_s_left_ankle_cross_x = left_ankle_cross_l1 * c_q2_q3;
  const Scalar neg_s_left_ankle_cross_y = left_ankle_cross_l1 * s_q2_q3;
  const Scalar neg_s_right_shank_x = left_shank_l1 * c_right_hip_pitch;
  const Scalar neg_s_right_shank_y = left_shank_l1 * s_right_hip_pitch;
  const Scalar neg_s_righ_ankl_cros_x = left_ankle_cross_l1 * c_q8_q9;
  const Scalar neg_s_righ_ankl_cros_y = left_ankle_cross_l1 * s_q8_q9;
  const Scalar r_right_foot_x = left_foot_l2 * c_right_ankle_roll;
  const Scalar r_left_foot_x = left_foot_l2 * c_left_ankle_roll;
  const Scalar r_right_foot_y = left_foot_l2 * s_right_ankle_roll;
  const Scalar r_left_foot_y = left_foot_l2 * s_left_ankle_roll;
  const Scalar neg_r_left_ankle_cross_x = left_hip_fork_l1 + r_left_foot_x;
  // left_ankle_cross: r of (9)
  const Scalar t_left_ankle_cross_1 = c_q2_q3_q4 * neg_r_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_2 = t_left_ankle_cross_1 - left_foot_l1 * s_q2_q3_q4;
  const Scalar neg_r_left_shank_x = neg_s_left_ankle_cross_x + t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_3 = s_q2_q3_q4 * neg_r_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = t_left_ankle_cross_3 + left_foot_l1 * c_q2_q3_q4;
  const Scalar neg_r_left_shank_y = neg_s_left_ankle_cross_y + t_left_ankle_cross_4;
  const Scalar neg_r_left_thigh_y = neg_s_left_shank_y + neg_r_left_shank_y;
  const Scalar neg_r_left_thigh_x = neg_s_left_shank_x + neg_r_left_shank_x;
  // left_hip_fork: r of (9)
  const Scalar r_left_hip_fork_x = left_hip_fork_l2 + r_left_foot_y;
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * r_left_hip_fork_x;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * r_left_hip_fork_x;
  // left_hip_block: r, C of (9)
  const Scalar r_left_hip_block_y = t_left_hip_fork_2 + s_left_hip_roll * neg_r_left_thigh_x;
  C[14] = r_left_hip_block_y;
  const Scalar r_left_hip_block_x = left_hip_fork_l1 - neg_r_left_thigh_y;
  C[1] = c_left_hip_yaw * r_left_hip_block_x - s_left_hip_yaw * r_left_hip_block_y;
  C[0] = -(c_left_hip_yaw * r_left_hip_block_y + s_left_hip_yaw * r_left_hip_block_x);
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_1 - c_left_hip_roll * neg_r_left_thigh_x;
  C[13] = -c_left_hip_yaw * t_left_hip_fork_3;
  C[12] = s_left_hip_yaw * t_left_hip_fork_3;
  const Scalar t_left_hip_block_1 = s_left_hip_yaw * s_left_hip_roll;
  C[24] = neg_r_left_thigh_y * t_left_hip_block_1 - c_left_hip_yaw * neg_r_left_thigh_x;
  const Scalar t_left_hip_block_2 = c_left_hip_yaw * s_left_hip_roll;
  C[25] = -(s_left_hip_yaw * neg_r_left_thigh_x + neg_r_left_thigh_y * t_left_hip_block_2);
  C[36] = neg_r_left_shank_y * t_left_hip_block_1 - c_left_hip_yaw * neg_r_left_shank_x;
  C[37] = -(neg_r_left_shank_y * t_left_hip_block_2 + s_left_hip_yaw * neg_r_left_shank_x);
  C[26] = c_left_hip_roll * neg_r_left_thigh_y;
  const Scalar C_48_1 = t_left_ankle_cross_4 * t_left_hip_block_1;
  C[48] = C_48_1 - c_left_hip_yaw * t_left_ankle_cross_2;
  const Scalar t_left_hip_block_3 = c_q2_q3_q4 * r_left_foot_y;
  const Scalar t_left_hip_block_4 = s_left_hip_roll * t_left_hip_block_3;
  const Scalar t_left_hip_block_5 = t_left_hip_block_4 - c_left_hip_roll * r_left_foot_x;
  const Scalar t_left_hip_block_6 = s_q2_q3_q4 * r_left_foot_y;
  C[60] = c_left_hip_yaw * t_left_hip_block_6 + s_left_hip_yaw * t_left_hip_block_5;
  C[63] = C[60];
  C[61] = s_left_hip_yaw * t_left_hip_block_6 - c_left_hip_yaw * t_left_hip_block_5;
  C[64] = C[61];
  const Scalar neg_C_49_1 = t_left_ankle_cross_4 * t_left_hip_block_2;
  C[49] = -(neg_C_49_1 + s_left_hip_yaw * t_left_ankle_cross_2);
  C[38] = c_left_hip_roll * neg_r_left_shank_y;
  C[50] = c_left_hip_roll * t_left_ankle_cross_4;
  C[62] = c_left_hip_roll * t_left_hip_block_3 + s_left_hip_roll * r_left_foot_x;
  C[65] = C[62];
  // left_ankle_cross: r of (9)
  const Scalar t_left_ankle_cross_5 = t_left_ankle_cross_3 - left_foot_l3 * c_q2_q3_q4;
  const Scalar neg_r_left_shank_y_2 = neg_s_left_ankle_cross_y + t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_6 = t_left_ankle_cross_1 + left_foot_l3 * s_q2_q3_q4;
  const Scalar neg_r_left_shank_x_2 = neg_s_left_ankle_cross_x + t_left_ankle_cross_6;
  const Scalar neg_r_left_thigh_x_2 = neg_s_left_shank_x + neg_r_left_shank_x_2;
  const Scalar neg_r_left_thigh_y_2 = neg_s_left_shank_y + neg_r_left_shank_y_2;
  // left_hip_block: r, C of (9)
  const Scalar r_left_hip_block_y_2 = t_left_hip_fork_2 + s_left_hip_roll * neg_r_left_thigh_x_2;
  C[17] = r_left_hip_block_y_2;
  const Scalar r_left_hip_block_x_2 = left_hip_fork_l1 - neg_r_left_thigh_y_2;
  C[4] = c_left_hip_yaw * r_left_hip_block_x_2 - s_left_hip_yaw * r_left_hip_block_y_2;
  C[3] = -(c_left_hip_yaw * r_left_hip_block_y_2 + s_left_hip_yaw * r_left_hip_block_x_2);
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_1 - c_left_hip_roll * neg_r_left_thigh_x_2;
  C[15] = s_left_hip_yaw * t_left_hip_fork_4;
  C[16] = -c_left_hip_yaw * t_left_hip_fork_4;
  C[28] = -(s_left_hip_yaw * neg_r_left_thigh_x_2 + t_left_hip_block_2 * neg_r_left_thigh_y_2);
  C[27] = t_left_hip_block_1 * neg_r_left_thigh_y_2 - c_left_hip_yaw * neg_r_left_thigh_x_2;
  C[39] = t_left_hip_block_1 * neg_r_left_shank_y_2 - c_left_hip_yaw * neg_r_left_shank_x_2;
  C[40] = -(t_left_hip_block_2 * neg_r_left_shank_y_2 + s_left_hip_yaw * neg_r_left_shank_x_2);
  C[29] = c_left_hip_roll * neg_r_left_thigh_y_2;
  const Scalar C_51_1 = t_left_hip_block_1 * t_left_ankle_cross_5;
  C[51] = C_51_1 - c_left_hip_yaw * t_left_ankle_cross_6;
  const Scalar neg_C_52_1 = t_left_hip_block_2 * t_left_ankle_cross_5;
  C[52] = -(s_left_hip_yaw * t_left_ankle_cross_6 + neg_C_52_1);
  C[41] = c_left_hip_roll * neg_r_left_shank_y_2;
  C[53] = c_left_hip_roll * t_left_ankle_cross_5;
  const Scalar neg_r_righ_ankl_cros_x = left_hip_fork_l1 + r_right_foot_x;
  // right_ankle_cross: r of (9)
  const Scalar t_righ_ankl_cros_1 = s_q8_q9_q10 * neg_r_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_2 = t_righ_ankl_cros_1 + left_foot_l1 * c_q8_q9_q10;
  const Scalar neg_r_right_shank_y = neg_s_righ_ankl_cros_y + t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_3 = c_q8_q9_q10 * neg_r_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 - left_foot_l1 * s_q8_q9_q10;
  const Scalar neg_r_right_shank_x = neg_s_righ_ankl_cros_x + t_righ_ankl_cros_4;
  const Scalar neg_r_right_thigh_y = neg_s_right_shank_y + neg_r_right_shank_y;
  const Scalar neg_r_right_thigh_x = neg_s_right_shank_x + neg_r_right_shank_x;
  const Scalar neg_r_right_hip_fork_x = left_hip_fork_l2 - r_right_foot_y;
  // right_hip_fork: r of (9)
  const Scalar t_right_hip_fork_1 = s_right_hip_roll * neg_r_right_hip_fork_x;
  const Scalar t_right_hip_fork_2 = c_right_hip_roll * neg_r_right_hip_fork_x;
  const Scalar neg_r_right_hip_block_y =
      t_right_hip_fork_2 - s_right_hip_roll * neg_r_right_thigh_x;
  C[92] = -neg_r_right_hip_block_y;
  const Scalar r_right_hip_block_x = left_hip_fork_l1 - neg_r_right_thigh_y;
  C[79] = c_right_hip_yaw * r_right_hip_block_x + s_right_hip_yaw * neg_r_right_hip_block_y;
  C[78] = c_right_hip_yaw * neg_r_right_hip_block_y - s_right_hip_yaw * r_right_hip_block_x;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_1 + c_right_hip_roll * neg_r_right_thigh_x;
  // left_hip_block: C of (9)
  C[90] = -s_right_hip_yaw * t_right_hip_fork_3;
  C[91] = c_right_hip_yaw * t_right_hip_fork_3;
  const Scalar t_left_hip_block_7 = s_right_hip_yaw * s_right_hip_roll;
  C[102] = neg_r_right_thigh_y * t_left_hip_block_7 - c_right_hip_yaw * neg_r_right_thigh_x;
  const Scalar t_left_hip_block_8 = c_right_hip_yaw * s_right_hip_roll;
  C[103] = -(s_right_hip_yaw * neg_r_right_thigh_x + neg_r_right_thigh_y * t_left_hip_block_8);
  C[115] = -(s_right_hip_yaw * neg_r_right_shank_x + neg_r_right_shank_y * t_left_hip_block_8);
  C[114] = neg_r_right_shank_y * t_left_hip_block_7 - c_right_hip_yaw * neg_r_right_shank_x;
  C[104] = c_right_hip_roll * neg_r_right_thigh_y;
  const Scalar t_left_hip_block_9 = c_q8_q9_q10 * r_right_foot_y;
  const Scalar t_left_hip_block_10 = s_right_hip_roll * t_left_hip_block_9;
  const Scalar t_left_hip_block_11 = t_left_hip_block_10 - c_right_hip_roll * r_right_foot_x;
  const Scalar t_left_hip_block_12 = s_q8_q9_q10 * r_right_foot_y;
  C[139] = s_right_hip_yaw * t_left_hip_block_12 - c_right_hip_yaw * t_left_hip_block_11;
  C[142] = C[139];
  C[126] = t_righ_ankl_cros_2 * t_left_hip_block_7 - c_right_hip_yaw * t_righ_ankl_cros_4;
  C[138] = c_right_hip_yaw * t_left_hip_block_12 + s_right_hip_yaw * t_left_hip_block_11;
  C[141] = C[138];
  C[127] = -(s_right_hip_yaw * t_righ_ankl_cros_4 + t_righ_ankl_cros_2 * t_left_hip_block_8);
  C[116] = c_right_hip_roll * neg_r_right_shank_y;
  C[128] = c_right_hip_roll * t_righ_ankl_cros_2;
  C[140] = c_right_hip_roll * t_left_hip_block_9 + s_right_hip_roll * r_right_foot_x;
  C[143] = C[140];
  // right_ankle_cross: r of (9)
  const Scalar t_righ_ankl_cros_5 = t_righ_ankl_cros_3 + left_foot_l3 * s_q8_q9_q10;
  const Scalar neg_r_right_shank_x_2 = neg_s_righ_ankl_cros_x + t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_6 = t_righ_ankl_cros_1 - left_foot_l3 * c_q8_q9_q10;
  const Scalar neg_r_right_shank_y_2 = neg_s_righ_ankl_cros_y + t_righ_ankl_cros_6;
  const Scalar neg_r_right_thigh_x_2 = neg_s_right_shank_x + neg_r_right_shank_x_2;
  const Scalar neg_r_right_thigh_y_2 = neg_s_right_shank_y + neg_r_right_shank_y_2;
  const Scalar neg_C_95 = t_right_hip_fork_2 - s_right_hip_roll * neg_r_right_thigh_x_2;
  C[95] = -neg_C_95;
  const Scalar r_right_hip_block_x_2 = left_hip_fork_l1 - neg_r_right_thigh_y_2;
  C[81] = c_right_hip_yaw * neg_C_95 - s_right_hip_yaw * r_right_hip_block_x_2;
  C[82] = c_right_hip_yaw * r_right_hip_block_x_2 + s_right_hip_yaw * neg_C_95;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_1 + c_right_hip_roll * neg_r_right_thigh_x_2;
  // left_hip_block: C of (9)
  C[93] = -s_right_hip_yaw * t_right_hip_fork_4;
  C[94] = c_right_hip_yaw * t_right_hip_fork_4;
  const Scalar neg_C_106_1 = t_left_hip_block_8 * neg_r_right_thigh_y_2;
  C[106] = -(neg_C_106_1 + s_right_hip_yaw * neg_r_right_thigh_x_2);
  const Scalar C_105_1 = t_left_hip_block_7 * neg_r_right_thigh_y_2;
  C[105] = C_105_1 - c_right_hip_yaw * neg_r_right_thigh_x_2;
  const Scalar C_117_1 = t_left_hip_block_7 * neg_r_right_shank_y_2;
  C[117] = C_117_1 - c_right_hip_yaw * neg_r_right_shank_x_2;
  const Scalar neg_C_118_1 = t_left_hip_block_8 * neg_r_right_shank_y_2;
  C[118] = -(neg_C_118_1 + s_right_hip_yaw * neg_r_right_shank_x_2);
  C[107] = c_right_hip_roll * neg_r_right_thigh_y_2;
  C[129] = t_left_hip_block_7 * t_righ_ankl_cros_6 - c_right_hip_yaw * t_righ_ankl_cros_5;
  C[130] = -(t_left_hip_block_8 * t_righ_ankl_cros_6 + s_right_hip_yaw * t_righ_ankl_cros_5);
  C[119] = c_right_hip_roll * neg_r_right_shank_y_2;
  C[131] = c_right_hip_roll * t_righ_ankl_cros_6;
  force_jacobian_transpose_0(C);
}

}  // namespace biped
