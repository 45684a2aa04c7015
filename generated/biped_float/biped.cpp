// biped.cpp: see biped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate biped.yaml --scalar float

#include "biped.hpp"

namespace biped {

static_assert(kDigest == 0x59c833741b302c85ULL, "header and source are of different runs");

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

// Orders of sums other than those that are written would cancel the rounding, and so would numbers
// that are wider in registers than in memory (methods 0 and 16: none is, 1: float is).
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__i386__) && !defined(__SSE__))
#error "sine_cosine rounds by adding and subtracting: not for -ffast-math or x87; --sincos libm is"
#elif defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ & ~16) != 0
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
// above each the numbers of the model that it is made of, but for those that are exactly 0 or 1,
// behind its unit, which a length or mass of exactly 1 hides. Other literals are numbers of the
// equations.

// m: offset y of left_hip_block, right_hip_block
constexpr float left_hip_block_l1 = 0.08064f;
// m: offset z of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr float left_hip_block_l2 = -0.114f;
// kg m^2: mass, com x y, inertia zz of left_hip_block, right_hip_block; mass, com x z, inertia yy,
//     offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_thigh,
//     right_thigh; mass, com x z, inertia xx yy, offset z of left_shank, right_shank; mass, com x
//     z, inertia yy, offset z of left_ankle_cross, right_ankle_cross; mass, com, inertia yy zz,
//     offset z of left_foot, right_foot
constexpr float left_hip_block_I1 = 1.7027155f;
// kg m^2: mass, com x y, inertia zz of left_hip_block, right_hip_block; mass, com x, inertia xx yy
//     zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; offset
//     z of left_shank, left_foot, right_shank, right_foot
constexpr float left_hip_block_I2 = 0.0032230439f;
// kg m^2: mass, com x y, inertia zz of left_hip_block, right_hip_block; mass, com x z, inertia yy,
//     offset x of left_hip_fork, right_hip_fork; mass of left_thigh, left_shank, left_ankle_cross,
//     right_thigh, right_shank, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_hip_block_I3 = 0.0043290067f;

// ratio: offset x of left_hip_fork, right_hip_fork; offset z of left_shank, left_foot, right_shank,
//     right_foot
constexpr float left_hip_fork_k1 = -43.2f;
// ratio: offset x of left_hip_fork, right_hip_fork; offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr float left_hip_fork_k2 = -43.3f;
// ratio: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; offset z
//     of left_foot, right_foot
constexpr float left_hip_fork_k3 = -2.0f;
// m: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr float left_hip_fork_l1 = -0.02f;
// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr float left_hip_fork_l2 = 0.01f;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_hip_fork_I1 = -0.0042631915f;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_I2 = -0.00016159248f;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xz yz of
//     left_thigh, left_shank, right_thigh, right_shank; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr float left_hip_fork_I3 = -0.034676712f;
// kg m^2: mass, com y z, inertia xx, offset x z of left_hip_fork, right_hip_fork; mass, com y z,
//     inertia xx, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy, offset z of
//     left_shank, right_shank; mass, com y z, inertia xx, offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr float left_hip_fork_I4 = 1.6921113f;
// kg m^2: mass, com y z, inertia yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y z,
//     inertia yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz, offset z
//     of left_shank, right_shank; mass, com y z, inertia yy zz, offset z of left_ankle_cross,
//     left_foot, right_ankle_cross, right_foot
constexpr float left_hip_fork_I5 = 1.6313524f;
// kg m^2: mass, com y z, inertia yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_I6 = 0.0293105f;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_I7 = -8.079624e-05f;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_I8 = 0.0040738555f;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; offset z of left_foot,
//     right_foot
constexpr float left_hip_fork_I9 = -0.00011406528f;
// kg m^2: mass, com z, inertia xx yy zz of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_I10 = 0.00026615232f;
// kg m^2: mass, com y, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_I11 = 0.029576652f;
// kg m^2: mass, com y z, inertia xx, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_hip_fork_I12 = 0.029842805f;
// kg m^2: mass, com y, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_hip_fork_I13 = 0.059910648f;
// kg m^2: mass, com z, inertia xx yy zz of left_hip_fork, right_hip_fork
constexpr float left_hip_fork_I14 = 0.00053230464f;
// kg m^2: mass, com y z, inertia yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_hip_fork_I15 = 0.029689172f;
// kg m^2: mass, com y z, inertia xx, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy of
//     left_shank, right_shank; mass, com y z, inertia xx, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_hip_fork_I16 = 0.3868351f;
// kg m^2: mass, com y z, inertia yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_hip_fork_I17 = 0.3260763f;
// kg m^2: mass, com z, inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z,
//     inertia xx yy zz of left_shank, right_shank; mass, com z, inertia xx yy zz, offset z of
//     left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_hip_fork_I18 = 0.3564557f;
// kg m^2: mass, com y, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass, com y z, inertia xx yy zz
//     of left_foot, right_foot
constexpr float left_hip_fork_I19 = 0.0303794f;
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
constexpr float left_hip_fork_p1 = -981.0f;

// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; mass,
//     offset z of left_shank, left_foot, right_shank, right_foot; mass of left_ankle_cross,
//     right_ankle_cross
constexpr float left_thigh_I1 = -0.036279812f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_thigh, right_thigh; offset
//     z of left_foot, right_foot
constexpr float left_thigh_I2 = -0.0014731531f;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr float left_thigh_I3 = 0.03939174f;
// kg m^2: mass, com x z, inertia xx zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_thigh_I4 = 1.2800688f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_thigh_I5 = 0.09232168f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com x y, inertia xy, offset y of
//     left_thigh, right_thigh
constexpr float left_thigh_I6 = 0.004425553f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_thigh,
//     right_thigh; mass, com x z, inertia xx yy, offset z of left_shank, right_shank; mass, com x
//     z, inertia yy, offset z of left_ankle_cross, right_ankle_cross; mass, com, inertia yy zz,
//     offset z of left_foot, right_foot
constexpr float left_thigh_I7 = 1.6983864f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_thigh_I8 = 0.084142365f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of left_thigh,
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
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, left_ankle_cross,
//     right_thigh, right_ankle_cross; mass, offset z of left_shank, right_shank; offset z of
//     left_foot, right_foot
constexpr float left_thigh_I13 = -0.032190155f;
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr float left_thigh_I14 = -0.26256865f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; mass,
//     com z, offset z of left_shank, right_shank; offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr float left_thigh_I15 = 0.00058478647f;
// kg m^2: mass, com x z, inertia xx zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr float left_thigh_I16 = 0.28721914f;
// kg m^2: mass, com x z, inertia yy of left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr float left_thigh_I17 = -0.23791817f;
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_thigh_I18 = 1.3047192f;
// N m: gravity; mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank;
//     mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_thigh_G1 = 35.590496f;
// N m: gravity; mass, com x of left_thigh, right_thigh
constexpr float left_thigh_G2 = 1.4451631f;

// m: offset z of left_shank, right_shank
constexpr float left_shank_l1 = -0.432f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     offset z of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_shank_I1 = -0.011042539f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_shank, right_shank; offset
//     z of left_foot, right_foot
constexpr float left_shank_I2 = -0.0008030938f;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; mass, offset z of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_I3 = 0.3507794f;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr float left_shank_I4 = -0.03083291f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z, inertia xz yz of left_shank, right_shank; mass, com y, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_I5 = 0.025658026f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y, inertia xy of left_shank, right_shank
constexpr float left_shank_I6 = 0.0015598222f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy of left_shank,
//     right_shank; mass, com x z, inertia yy, offset z of left_ankle_cross, right_ankle_cross;
//     mass, com, inertia yy zz, offset z of left_foot, right_foot
constexpr float left_shank_I7 = 0.3690168f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr float left_shank_I8 = 0.17328733f;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr float left_shank_I9 = -0.015416455f;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, right_shank
constexpr float left_shank_I10 = 0.0052914377f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, inertia xz yz of left_shank, right_shank; mass, com y z, offset z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_shank_I11 = 0.017459776f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_shank_I12 = -0.006943415f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr float left_shank_I13 = 0.17857878f;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr float left_shank_I14 = 0.12207109f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_shank_I15 = 0.000160356f;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr float left_shank_I16 = 0.12736252f;
// kg m^2: mass, com x z, inertia xx yy of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr float left_shank_I17 = -0.11677965f;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; mass, offset z of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_I18 = 0.35607085f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com x z, inertia xx zz, offset z of left_ankle_cross, right_ankle_cross;
//     mass, com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_shank_I19 = 0.34391922f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy of left_shank,
//     right_shank; mass, com x z, inertia yy, offset z of left_ankle_cross, right_ankle_cross;
//     mass, com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_shank_I20 = 0.36845988f;
// N m: gravity; mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr float left_shank_G1 = 10.832731f;
// N m: gravity; mass, com x of left_shank, right_shank
constexpr float left_shank_G2 = 0.787835f;

// m: offset z of left_ankle_cross, right_ankle_cross
constexpr float left_ankle_cross_l1 = -0.433f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I1 = 9.4668e-05f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y of left_ankle_cross, right_ankle_cross; mass, com x of left_foot, right_foot
constexpr float left_ankle_cross_I2 = -0.0011063096f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I3 = 0.0005508364f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com y z, inertia yy zz, offset z of
//     left_foot, right_foot
constexpr float left_ankle_cross_I4 = -0.0001601243f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I5 = 0.006303306f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia yy zz, offset z of left_foot, right_foot
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
constexpr float left_ankle_cross_I10 = -6.9552e-06f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr float left_ankle_cross_I11 = 2.40212e-05f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I12 = 0.0069548776f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_ankle_cross,
//     right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I13 = 0.00700292f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr float left_ankle_cross_I14 = 0.0068602096f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia yy of left_ankle_cross,
//     right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I15 = 0.007097588f;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I16 = -0.0001962912f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_I17 = 0.0001186892f;
// kg m^2: mass, com x, offset z of left_ankle_cross, right_ankle_cross; mass, com x of left_foot,
//     right_foot
constexpr float left_ankle_cross_I18 = -0.023851216f;
// kg m^2: mass, com x, offset z of left_ankle_cross, right_ankle_cross; mass, com x of left_foot,
//     right_foot
constexpr float left_ankle_cross_I19 = -0.04770243f;
// N m: gravity; mass, com x of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr float left_ankle_cross_G1 = -0.54037046f;
// N m: gravity; offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr float left_ankle_cross_G2 = -0.09286931f;

// ratio: com y z of left_foot, right_foot
constexpr float left_foot_k1 = 0.26146916f;
// m: points of left_foot, right_foot
constexpr float left_foot_l1 = -0.06f;
// m: points of left_foot, right_foot
constexpr float left_foot_l2 = -0.05903f;
// m: points of left_foot, right_foot
constexpr float left_foot_l3 = 0.20904f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr float left_foot_I1 = 0.00014128635f;
// kg m^2: com y z, inertia xy xz of left_foot, right_foot
constexpr float left_foot_I2 = 6.298136e-05f;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr float left_foot_I3 = 0.0014494178f;
// kg m^2: mass, com y z, inertia yy zz of left_foot, right_foot
constexpr float left_foot_I4 = 0.00013282818f;
// kg m^2: com y z, inertia yy zz of left_foot, right_foot
constexpr float left_foot_I5 = -7.2333794e-05f;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr float left_foot_I6 = 0.0002825727f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z of left_foot, right_foot
constexpr float left_foot_I7 = -0.0005651454f;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z of left_foot, right_foot
constexpr float left_foot_I8 = -0.0002825727f;
// kg m^2: mass, com y z, inertia xx of left_foot, right_foot
constexpr float left_foot_I9 = 0.0009809787f;
// kg m^2: offset z of left_ankle_cross, right_ankle_cross; mass, com y z of left_foot, right_foot
constexpr float left_foot_I10 = -0.006117699f;
// kg m^2: offset z of left_shank, right_shank; mass, com y z of left_foot, right_foot
constexpr float left_foot_I11 = -0.0061035706f;
// kg m^2: com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I12 = 0.00042407526f;
// kg m^2: com y z, inertia yy zz of left_foot, right_foot
constexpr float left_foot_I13 = -3.6166897e-05f;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr float left_foot_I14 = 0.0005569034f;
// N m: gravity; mass, com y z of left_foot, right_foot
constexpr float left_foot_G1 = -0.13860191f;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

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
  const Scalar s_left_shank_y = left_hip_fork_k1 * s_left_hip_pitch;
  const Scalar s_left_shank_x = left_hip_fork_k1 * c_left_hip_pitch;
  const Scalar s_left_ankle_cross_x = left_hip_fork_k2 * c_q2_q3;
  const Scalar s_left_ankle_cross_y = left_hip_fork_k2 * s_q2_q3;
  const Scalar s_right_shank_y = left_hip_fork_k1 * s_right_hip_pitch;
  const Scalar s_right_shank_x = left_hip_fork_k1 * c_right_hip_pitch;
  const Scalar s_righ_ankl_cros_x = left_hip_fork_k2 * c_q8_q9;
  const Scalar s_righ_ankl_cros_y = left_hip_fork_k2 * s_q8_q9;
  // right_foot: first moment h, A of (2)
  const Scalar t_right_foot_1 = left_foot_I1 * c_right_foot;
  const Scalar neg_h_righ_ankl_cros_z = left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_2 = left_foot_I4 * s_right_foot - left_foot_I5 * c_right_foot;
  const Scalar t_right_foot_3 = s_right_foot * t_right_foot_2;
  const Scalar t_right_foot_4 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar A_131 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  A[131] = A_131;
  A[142] = A[131];
  // right_ankle_cross: first moment h, A, second moments E of (2)
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_I1 + t_right_foot_1;
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_I3 * s_q8_q9_q10;
  const Scalar t_righ_ankl_cros_2 = t_righ_ankl_cros_1 + c_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_3 = left_ankle_cross_I3 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 - s_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar h_right_shank_y_1 = t_righ_ankl_cros_4 + left_shank_I1 * s_q8_q9;
  const Scalar h_right_shank_y = h_right_shank_y_1 + left_shank_I2 * c_q8_q9;
  const Scalar E_righ_ankl_cros_xz_1 = left_ankle_cross_I4 - neg_h_righ_ankl_cros_z;
  const Scalar E_righ_ankl_cros_xz_2 = left_foot_I8 - t_right_foot_2;
  const Scalar E_righ_ankl_cros_xz = E_righ_ankl_cros_xz_1 + c_right_foot * E_righ_ankl_cros_xz_2;
  const Scalar neg_E_righ_ankl_cros_yz = left_ankle_cross_I2 - A_131;
  const Scalar neg_A_94 = c_q8_q9_q10 * neg_E_righ_ankl_cros_yz - s_q8_q9_q10 * E_righ_ankl_cros_xz;
  A[94] = -neg_A_94;
  A[127] = A[94];
  const Scalar t_righ_ankl_cros_5 = s_righ_ankl_cros_x * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_6 = s_righ_ankl_cros_y * t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_7 = 2.0f * t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_8 = t_right_foot_3 - left_foot_I6 * c_right_foot;
  const Scalar A_130 = left_ankle_cross_I6 - t_righ_ankl_cros_8;
  A[130] = A_130;
  // right_shank: second moments E, A of (2)
  const Scalar t_right_shank_1 = left_foot_I10 * s_right_foot;
  const Scalar t_right_shank_2 = left_shank_I5 - t_right_shank_1;
  const Scalar E_right_shank_yz = neg_A_94 + left_shank_I6 * c_q8_q9 + s_q8_q9 * t_right_shank_2;
  A[93] = -E_right_shank_yz;
  A[115] = A[93];
  const Scalar t_right_shank_3 = t_righ_ankl_cros_8 + 2.0f * t_righ_ankl_cros_5;
  const Scalar neg_A_117 = t_right_shank_3 - (left_shank_I7 + t_righ_ankl_cros_7);
  A[117] = -neg_A_117;
  const Scalar neg_h_right_shank_x_1 = t_righ_ankl_cros_2 - left_shank_I1 * c_q8_q9;
  const Scalar neg_h_right_shank_x = neg_h_right_shank_x_1 + left_shank_I2 * s_q8_q9;
  const Scalar t_right_shank_4 = s_right_shank_x * neg_h_right_shank_x;
  const Scalar t_right_shank_5 = s_right_shank_y * h_right_shank_y;
  const Scalar t_right_shank_6 = s_right_shank_x * neg_h_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_9 = s_q8_q9_q10 * neg_E_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_10 = c_q8_q9_q10 * E_righ_ankl_cros_xz + t_righ_ankl_cros_9;
  const Scalar neg_E_right_shank_xz_1 = t_righ_ankl_cros_10 + left_shank_I6 * s_q8_q9;
  const Scalar neg_E_right_shank_xz = neg_E_right_shank_xz_1 - c_q8_q9 * t_right_shank_2;
  // right_thigh: second moments E, A of (2)
  const Scalar neg_E_right_thigh_xz_1 = t_right_shank_6 + neg_E_right_shank_xz;
  const Scalar neg_E_right_thigh_xz_2 = neg_E_right_thigh_xz_1 - left_thigh_I5 * c_right_hip_pitch;
  const Scalar neg_E_right_thigh_xz = neg_E_right_thigh_xz_2 + left_thigh_I6 * s_right_hip_pitch;
  const Scalar E_right_thigh_yz_1 = left_thigh_I5 - left_foot_I11 * s_right_foot;
  const Scalar E_right_thigh_yz_2 = E_right_shank_yz + left_thigh_I6 * c_right_hip_pitch;
  const Scalar E_right_thigh_yz = E_right_thigh_yz_2 + s_right_hip_pitch * E_right_thigh_yz_1;
  A[92] = -E_right_thigh_yz;
  A[103] = A[92];
  const Scalar t_right_thigh_1 = t_right_shank_3 + 2.0f * t_right_shank_4;
  const Scalar t_right_thigh_2 = t_righ_ankl_cros_7 - t_right_thigh_1;
  const Scalar t_right_thigh_3 = t_right_thigh_2 + 2.0f * t_right_shank_5;
  const Scalar A_104 = left_thigh_I7 + t_right_thigh_3;
  A[104] = A_104;
  const Scalar t_righ_ankl_cros_11 = left_shank_I3 * s_q8_q9 - left_shank_I4 * c_q8_q9;
  const Scalar t_right_shank_7 = left_thigh_I3 * c_right_hip_pitch;
  const Scalar t_right_shank_8 = t_right_shank_7 + left_thigh_I4 * s_right_hip_pitch;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_12 = c_q8_q9_q10 * (left_ankle_cross_I7 - 2.0f * t_right_foot_4);
  const Scalar t_righ_ankl_cros_13 = left_ankle_cross_I5 + t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_14 = t_righ_ankl_cros_12 + s_q8_q9_q10 * t_righ_ankl_cros_13;
  // right_hip_fork: second moments E, A of (2)
  const Scalar t_right_hip_fork_1 = left_thigh_I1 + t_right_shank_8;
  const Scalar t_right_hip_fork_2 = left_hip_fork_I1 - neg_h_righ_ankl_cros_z;
  const Scalar t_right_hip_fork_3 = t_righ_ankl_cros_11 + left_hip_fork_k2 * t_righ_ankl_cros_4;
  const Scalar t_right_hip_fork_4 = neg_h_right_shank_x - (left_hip_fork_I3 - t_right_foot_4);
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_4 - c_q8_q9 * t_right_hip_fork_3;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_1 + left_hip_fork_k1 * h_right_shank_y;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_5 + c_q8_q9_q10 * t_righ_ankl_cros_14;
  const Scalar t_right_hip_fork_8 = left_thigh_I2 + left_hip_fork_k1 * neg_h_right_shank_x;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_7 - c_right_hip_pitch * t_right_hip_fork_6;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_9 + s_right_hip_pitch * t_right_hip_fork_8;
  const Scalar neg_E_right_hip_fork_xz =
      t_right_hip_fork_10 + s_righ_ankl_cros_y * t_righ_ankl_cros_2;
  const Scalar neg_A_79_1 = s_right_hip_roll * (E_right_thigh_yz + t_right_hip_fork_2);
  A[79] = c_right_hip_roll * neg_E_right_hip_fork_xz - neg_A_79_1;
  A[90] = A[79];
  const Scalar t_right_hip_fork_11 = t_right_thigh_1 + s_q8_q9 * t_righ_ankl_cros_11;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_11 + s_right_hip_pitch * t_right_shank_8;
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_12 - s_q8_q9_q10 * t_righ_ankl_cros_14;
  const Scalar t_right_hip_fork_14 = t_right_foot_3 - left_foot_I7 * s_right_foot;
  A[91] = left_hip_fork_I4 - t_right_hip_fork_13 + t_right_hip_fork_14;
  const Scalar A_78_1 = t_right_hip_fork_14 - (left_hip_fork_I5 - t_right_hip_fork_13);
  const Scalar A_78_2 = s_right_hip_roll * (left_hip_fork_I2 + 2.0f * neg_E_right_thigh_xz);
  const Scalar h_right_thigh_y_1 = h_right_shank_y + left_thigh_I1 * s_right_hip_pitch;
  const Scalar h_right_thigh_y = h_right_thigh_y_1 + left_thigh_I2 * c_right_hip_pitch;
  const Scalar A_78_3 = left_hip_block_I1 + t_right_thigh_3 + 2.0f * h_right_thigh_y;
  A[78] = A_78_3 + c_right_hip_roll * (A_78_2 + c_right_hip_roll * A_78_1);
  const Scalar t_left_foot_1 = left_foot_I1 * c_left_foot;
  const Scalar h_left_ankle_cross_x = left_ankle_cross_I1 + t_left_foot_1;
  const Scalar h_left_ankle_cross_z = left_foot_I1 * s_left_foot;
  // left_foot: A of (2)
  const Scalar t_left_foot_2 = left_foot_I5 * c_left_foot - left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_3 = s_left_foot * t_left_foot_2;
  const Scalar t_left_foot_4 = left_foot_I2 * s_left_foot - left_foot_I3 * c_left_foot;
  const Scalar neg_A_53 = left_foot_I3 * s_left_foot + left_foot_I2 * c_left_foot;
  A[53] = -neg_A_53;
  A[64] = A[53];
  const Scalar t_left_ankle_cross_1 = s_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_2 = left_ankle_cross_I3 * c_q2_q3_q4 - t_left_ankle_cross_1;
  const Scalar h_left_shank_y_1 = t_left_ankle_cross_2 + left_shank_I2 * c_q2_q3;
  const Scalar h_left_shank_y = h_left_shank_y_1 + left_shank_I1 * s_q2_q3;
  // left_ankle_cross: A, second moments E of (2)
  const Scalar t_left_ankle_cross_3 = c_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = left_ankle_cross_I3 * s_q2_q3_q4 + t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_5 = left_ankle_cross_I4 - h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_6 = left_foot_I8 + t_left_foot_2;
  const Scalar t_left_ankle_cross_7 = t_left_ankle_cross_5 + c_left_foot * t_left_ankle_cross_6;
  const Scalar E_left_ankle_cross_yz = left_ankle_cross_I2 - neg_A_53;
  const Scalar A_16 = c_q2_q3_q4 * E_left_ankle_cross_yz - s_q2_q3_q4 * t_left_ankle_cross_7;
  A[16] = A_16;
  A[49] = A[16];
  const Scalar t_left_ankle_cross_8 = left_hip_fork_k2 * t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_9 = s_q2_q3 * t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_10 = 2.0f * t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_11 = s_left_ankle_cross_x * t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_12 = t_left_foot_3 + left_foot_I6 * c_left_foot;
  const Scalar A_52 = left_ankle_cross_I6 + t_left_ankle_cross_12;
  A[52] = A_52;
  // left_shank: second moments E, A of (2)
  const Scalar t_left_shank_1 = left_foot_I10 * s_left_foot;
  const Scalar t_left_shank_2 = left_shank_I5 - t_left_shank_1;
  const Scalar neg_E_left_shank_yz = A_16 + left_shank_I6 * c_q2_q3 + s_q2_q3 * t_left_shank_2;
  A[15] = neg_E_left_shank_yz;
  A[37] = A[15];
  const Scalar t_left_shank_3 = t_left_ankle_cross_12 - 2.0f * t_left_ankle_cross_11;
  const Scalar A_39 = left_shank_I7 + t_left_ankle_cross_10 + t_left_shank_3;
  A[39] = A_39;
  const Scalar t_left_shank_4 = s_left_shank_y * h_left_shank_y;
  const Scalar neg_h_left_shank_x_1 = t_left_ankle_cross_4 + left_shank_I2 * s_q2_q3;
  const Scalar neg_h_left_shank_x = neg_h_left_shank_x_1 - left_shank_I1 * c_q2_q3;
  const Scalar t_left_shank_5 = left_hip_fork_k1 * neg_h_left_shank_x;
  const Scalar t_left_shank_6 = c_left_hip_pitch * t_left_shank_5;
  const Scalar t_left_shank_7 = left_foot_I11 * s_left_foot;
  const Scalar t_left_shank_8 = c_left_hip_pitch * t_left_shank_7;
  // left_thigh: second moments E, A of (2)
  const Scalar neg_E_left_thigh_yz_1 = neg_E_left_shank_yz + left_thigh_I6 * c_left_hip_pitch;
  const Scalar neg_E_left_thigh_yz_2 = left_thigh_I5 - t_left_shank_7;
  const Scalar neg_E_left_thigh_yz =
      neg_E_left_thigh_yz_1 + s_left_hip_pitch * neg_E_left_thigh_yz_2;
  A[14] = neg_E_left_thigh_yz;
  A[25] = A[14];
  const Scalar t_left_thigh_1 = t_left_shank_3 - 2.0f * t_left_shank_6;
  const Scalar t_left_thigh_2 = t_left_ankle_cross_10 + t_left_thigh_1;
  const Scalar t_left_thigh_3 = t_left_thigh_2 + 2.0f * t_left_shank_4;
  const Scalar A_26 = left_thigh_I7 + t_left_thigh_3;
  A[26] = A_26;
  const Scalar t_left_ankle_cross_13 = c_q2_q3_q4 * t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_14 = t_left_ankle_cross_13 + s_q2_q3_q4 * E_left_ankle_cross_yz;
  const Scalar E_left_shank_xz_1 = t_left_ankle_cross_14 + left_shank_I6 * s_q2_q3;
  const Scalar E_left_shank_xz = E_left_shank_xz_1 - c_q2_q3 * t_left_shank_2;
  const Scalar E_left_thigh_xz_1 = t_left_shank_8 + E_left_shank_xz;
  const Scalar E_left_thigh_xz_2 = E_left_thigh_xz_1 + left_thigh_I6 * s_left_hip_pitch;
  const Scalar E_left_thigh_xz = E_left_thigh_xz_2 - left_thigh_I5 * c_left_hip_pitch;
  const Scalar t_left_ankle_cross_15 = left_shank_I4 * c_q2_q3 - left_shank_I3 * s_q2_q3;
  const Scalar t_left_shank_9 = left_thigh_I4 * s_left_hip_pitch;
  const Scalar t_left_shank_10 = t_left_shank_9 + left_thigh_I3 * c_left_hip_pitch;
  const Scalar t_left_hip_fork_1 = left_thigh_I1 + t_left_shank_10;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_16 = c_q2_q3_q4 * (left_ankle_cross_I7 - 2.0f * t_left_foot_4);
  const Scalar t_left_ankle_cross_17 = left_ankle_cross_I5 - t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_18 = t_left_ankle_cross_16 + s_q2_q3_q4 * t_left_ankle_cross_17;
  // left_hip_fork: second moments E, A of (2)
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + left_hip_fork_k1 * h_left_shank_y;
  const Scalar t_left_hip_fork_3 = neg_h_left_shank_x - (left_hip_fork_I3 - t_left_foot_4);
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 - c_left_hip_pitch * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_5 = t_left_ankle_cross_8 - t_left_ankle_cross_15;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_4 - c_q2_q3 * t_left_hip_fork_5;
  const Scalar t_left_hip_fork_7 = left_thigh_I2 + t_left_shank_5;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_6 + s_left_hip_pitch * t_left_hip_fork_7;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_8 + s_left_ankle_cross_y * t_left_ankle_cross_4;
  const Scalar E_left_hip_fork_yz = left_hip_fork_I1 - h_left_ankle_cross_z + neg_E_left_thigh_yz;
  const Scalar neg_E_left_hip_fork_xz = t_left_hip_fork_9 + c_q2_q3_q4 * t_left_ankle_cross_18;
  A[1] = c_left_hip_roll * neg_E_left_hip_fork_xz + s_left_hip_roll * E_left_hip_fork_yz;
  A[12] = A[1];
  const Scalar t_left_hip_fork_10 = t_left_thigh_1 - s_left_hip_pitch * t_left_shank_10;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_10 + s_q2_q3 * t_left_ankle_cross_15;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_11 + s_q2_q3_q4 * t_left_ankle_cross_18;
  const Scalar t_left_hip_fork_13 = t_left_foot_3 + left_foot_I7 * s_left_foot;
  A[13] = left_hip_fork_I4 + t_left_hip_fork_12 - t_left_hip_fork_13;
  const Scalar h_left_thigh_y_1 = h_left_shank_y + left_thigh_I2 * c_left_hip_pitch;
  const Scalar h_left_thigh_y = h_left_thigh_y_1 + left_thigh_I1 * s_left_hip_pitch;
  const Scalar A_0_1 = left_hip_fork_I5 + t_left_hip_fork_12 + t_left_hip_fork_13;
  const Scalar A_0_2 = s_left_hip_roll * (left_hip_fork_I2 + 2.0f * E_left_thigh_xz);
  const Scalar A_0_3 = left_hip_block_I1 + t_left_thigh_3 + 2.0f * h_left_thigh_y;
  A[0] = A_0_3 - c_left_hip_roll * (A_0_2 + c_left_hip_roll * A_0_1);
  const Scalar t_right_foot_5 = left_foot_I9 + t_right_foot_1 - left_foot_I8 * s_right_foot;
  // right_ankle_cross: A of (2)
  const Scalar t_righ_ankl_cros_15 = c_q8_q9_q10 * neg_h_righ_ankl_cros_z;
  const Scalar A_119_1 = A_131 - s_q8_q9_q10 * c_q8_q9 * t_right_shank_1;
  const Scalar A_119 = A_119_1 + s_righ_ankl_cros_y * t_righ_ankl_cros_15;
  A[119] = A_119;
  A[141] = A[119];
  // right_shank: A of (2)
  const Scalar A_95_1 = t_right_foot_1 * (s_right_shank_x + s_righ_ankl_cros_x);
  A[95] = c_q8_q9_q10 * t_right_foot_5 - A_95_1 - s_q8_q9_q10 * t_right_foot_4;
  A[139] = A[95];
  const Scalar A_107_1 = A_119 + s_right_shank_y * t_righ_ankl_cros_15;
  const Scalar A_107 = A_107_1 - s_q8_q9_q10 * t_right_shank_6;
  A[107] = A_107;
  A[140] = A[107];
  const Scalar A_83_1 = s_q8_q9_q10 * t_right_foot_5 + c_q8_q9_q10 * t_right_foot_4;
  const Scalar A_83_2 = 1.0f + s_right_shank_y + s_righ_ankl_cros_y;
  const Scalar A_83_3 = c_right_hip_roll * (A_83_1 - t_right_foot_1 * A_83_2);
  A[83] = s_right_hip_roll * (t_righ_ankl_cros_15 + A_107) - A_83_3;
  A[138] = A[83];
  const Scalar A_118 = A_130 - (t_righ_ankl_cros_5 - t_righ_ankl_cros_6);
  A[118] = A_118;
  A[129] = A[118];
  const Scalar A_106_1 = A_118 - s_right_shank_x * t_righ_ankl_cros_2;
  const Scalar A_106 = A_106_1 + s_right_shank_y * t_righ_ankl_cros_4;
  A[106] = A_106;
  A[128] = A[106];
  const Scalar A_82_1 = s_right_hip_roll * (t_righ_ankl_cros_4 + A_106);
  A[82] = c_right_hip_roll * t_righ_ankl_cros_10 + A_82_1;
  A[126] = A[82];
  const Scalar A_105 = t_right_shank_5 - (neg_A_117 + t_right_shank_4);
  A[105] = A_105;
  A[116] = A[105];
  A[81] = c_right_hip_roll * neg_E_right_shank_xz + s_right_hip_roll * (h_right_shank_y + A_105);
  A[114] = A[81];
  A[80] = s_right_hip_roll * (A_104 + h_right_thigh_y) + c_right_hip_roll * neg_E_right_thigh_xz;
  A[102] = A[80];
  // left_ankle_cross: A of (2)
  const Scalar t_left_ankle_cross_19 = c_q2_q3_q4 * h_left_ankle_cross_z;
  const Scalar neg_A_41_1 = neg_A_53 + s_left_ankle_cross_y * t_left_ankle_cross_19;
  const Scalar neg_A_41 = neg_A_41_1 - s_q2_q3_q4 * c_q2_q3 * t_left_shank_1;
  A[41] = -neg_A_41;
  A[63] = A[41];
  const Scalar t_left_foot_5 = left_foot_I9 + t_left_foot_1 - left_foot_I8 * s_left_foot;
  const Scalar A_17_1 = c_q2_q3_q4 * t_left_foot_5 - s_q2_q3_q4 * t_left_foot_4;
  // left_shank: A of (2)
  A[17] = A_17_1 - t_left_foot_1 * (s_left_shank_x + s_left_ankle_cross_x);
  A[61] = A[17];
  const Scalar neg_A_29_1 = neg_A_41 + s_left_shank_y * t_left_ankle_cross_19;
  const Scalar neg_A_29 = neg_A_29_1 - s_q2_q3_q4 * t_left_shank_8;
  A[29] = -neg_A_29;
  A[62] = A[29];
  const Scalar neg_A_5_1 = t_left_foot_1 * (1.0f + s_left_shank_y + s_left_ankle_cross_y);
  const Scalar neg_A_5_2 = s_q2_q3_q4 * t_left_foot_5 - neg_A_5_1;
  const Scalar neg_A_5_3 = c_left_hip_roll * (neg_A_5_2 + c_q2_q3_q4 * t_left_foot_4);
  A[5] = -(neg_A_5_3 + s_left_hip_roll * (t_left_ankle_cross_19 + neg_A_29));
  A[60] = A[5];
  const Scalar A_40 = t_left_ankle_cross_9 - t_left_ankle_cross_11 + A_52;
  A[40] = A_40;
  A[51] = A[40];
  const Scalar A_28_1 = A_40 + s_left_shank_y * t_left_ankle_cross_2;
  const Scalar A_28 = A_28_1 - s_left_shank_x * t_left_ankle_cross_4;
  A[28] = A_28;
  A[50] = A[28];
  const Scalar A_4_1 = s_left_hip_roll * (t_left_ankle_cross_2 + A_28);
  A[4] = A_4_1 - c_left_hip_roll * t_left_ankle_cross_14;
  A[48] = A[4];
  const Scalar neg_A_27 = t_left_shank_6 - (A_39 + t_left_shank_4);
  A[27] = -neg_A_27;
  A[38] = A[27];
  // left_hip_fork: A of (2)
  A[3] = s_left_hip_roll * (h_left_shank_y - neg_A_27) - c_left_hip_roll * E_left_shank_xz;
  A[36] = A[3];
  A[2] = s_left_hip_roll * (A_26 + h_left_thigh_y) - c_left_hip_roll * E_left_thigh_xz;
  A[24] = A[2];
  A[65] = left_foot_I9;
  A[143] = left_foot_I9;
  mass_matrix_0(A);
}

// Lengths inside are in units of L, a distance between left_hip_roll and left_hip_pitch:
//   L = 0.01 m
// Names: vectors F_ in N m/L, a_ in L/s^2, s_ in L; all others are of values in SI units; numbered
// ones (t_) by what they are made of. Arguments and results are in SI units.
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
  const Scalar s_left_shank_y = left_hip_fork_k1 * s_q3_q4;
  const Scalar neg_s_left_shank_x = left_hip_fork_k1 * c_q3_q4;
  const Scalar neg_s_left_ankle_cross_x = left_hip_fork_k2 * c_left_ankle_pitch;
  const Scalar s_left_ankle_cross_y = left_hip_fork_k2 * s_left_ankle_pitch;
  const Scalar s_right_shank_y = left_hip_fork_k1 * s_q9_q10;
  const Scalar neg_s_right_shank_x = left_hip_fork_k1 * c_q9_q10;
  const Scalar neg_s_righ_ankl_cros_x = left_hip_fork_k2 * c_right_ankle_pitch;
  const Scalar s_righ_ankl_cros_y = left_hip_fork_k2 * s_right_ankle_pitch;
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
  const Scalar neg_Omega_left_thigh_yy = t_left_thigh_3 + t_left_thigh_7;
  const Scalar t_left_hip_block_1 = qd[0] * qd[0];
  const Scalar a_left_thigh_y = c_q2_q3_q4 * t_left_hip_block_1;
  const Scalar a_left_thigh_x = s_q2_q3_q4 * t_left_hip_block_1;
  const Scalar t_left_thigh_12 = left_thigh_I6 * s_q3_q4 + left_thigh_I8 * c_q3_q4;
  const Scalar t_left_thigh_13 = left_thigh_I9 * s_q3_q4 - left_thigh_I3 * c_q3_q4;
  const Scalar t_left_thigh_14 = s_q3_q4 * t_left_thigh_13;
  const Scalar t_left_thigh_15 = left_thigh_I10 - t_left_thigh_14;
  const Scalar t_left_thigh_16 = left_thigh_I8 * s_q3_q4 - left_thigh_I6 * c_q3_q4;
  const Scalar t_left_thigh_17 = neg_Omega_left_thigh_xx - neg_Omega_left_thigh_yy;
  const Scalar t_left_thigh_18 = left_thigh_I12 + c_q3_q4 * t_left_thigh_13;
  const Scalar t_left_thigh_19 = left_thigh_I2 * c_q3_q4 - left_thigh_I13 * s_q3_q4;
  const Scalar t_left_thigh_20 = left_thigh_I2 * s_q3_q4 + left_thigh_I13 * c_q3_q4;
  // left_shank: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_1 = 2.0f * neg_omega_left_thigh_y;
  const Scalar Omega_left_shank_zy = neg_Omega_left_thigh_yz - omega_left_shank_z * t_left_shank_1;
  const Scalar t_left_shank_2 = 2.0f * neg_omega_left_thigh_x;
  const Scalar Omega_left_shank_zx = neg_Omega_left_foot_xy - omega_left_shank_z * t_left_shank_2;
  const Scalar a_left_shank_z_1 = neg_s_left_shank_x * neg_Omega_left_thigh_zx;
  const Scalar a_left_shank_z = a_left_shank_z_1 - s_left_shank_y * neg_Omega_left_thigh_zy;
  const Scalar t_left_shank_3 = omega_left_shank_z * omega_left_shank_z;
  const Scalar neg_Omega_left_shank_xx = t_left_thigh_5 + t_left_shank_3;
  const Scalar neg_Omega_left_shank_yy = t_left_thigh_3 + t_left_shank_3;
  const Scalar t_left_shank_4 = left_shank_I8 * s_left_ankle_pitch;
  const Scalar t_left_shank_5 = t_left_shank_4 + left_shank_I4 * c_left_ankle_pitch;
  const Scalar t_left_shank_6 = left_shank_I9 - c_left_ankle_pitch * t_left_shank_5;
  const Scalar t_left_shank_7 = s_left_ankle_pitch * t_left_shank_5;
  const Scalar t_left_shank_8 = left_shank_I10 + t_left_shank_7;
  const Scalar t_left_shank_9 = left_shank_I11 * c_left_ankle_pitch;
  const Scalar t_left_shank_10 = t_left_shank_9 + left_shank_I6 * s_left_ankle_pitch;
  const Scalar t_left_shank_11 = left_shank_I11 * s_left_ankle_pitch;
  const Scalar t_left_shank_12 = t_left_shank_11 - left_shank_I6 * c_left_ankle_pitch;
  const Scalar t_left_shank_13 = left_shank_I12 * s_left_ankle_pitch;
  const Scalar t_left_shank_14 = left_shank_I2 * c_left_ankle_pitch - t_left_shank_13;
  const Scalar t_left_shank_15 = left_shank_I13 - t_left_shank_7;
  const Scalar t_left_shank_16 = left_shank_I12 * c_left_ankle_pitch;
  const Scalar t_left_shank_17 = left_shank_I2 * s_left_ankle_pitch + t_left_shank_16;
  // left_ankle_cross: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_1 = Omega_left_shank_zy - t_left_shank_1 * qd[4];
  const Scalar t_left_ankle_cross_2 = Omega_left_shank_zx - t_left_shank_2 * qd[4];
  const Scalar t_left_ankle_cross_3 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_4 = t_left_thigh_3 - t_left_ankle_cross_3;
  const Scalar a_left_ankle_cross_z_1 = a_left_shank_z + s_left_ankle_cross_y * Omega_left_shank_zy;
  const Scalar a_left_ankle_cross_z =
      a_left_ankle_cross_z_1 - neg_s_left_ankle_cross_x * Omega_left_shank_zx;
  // left_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar a_left_foot_y_1 = t_left_ankle_cross_2 + a_left_ankle_cross_z;
  const Scalar a_left_foot_y = a_left_foot_y_1 + left_hip_fork_k3 * neg_Omega_left_thigh_zz;
  const Scalar omega_left_foot_z = neg_omega_left_thigh_y + qd[5];
  const Scalar Omega_left_foot_zy_1 = omega_left_ankle_cross_z * omega_left_foot_z;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_1 + 2.0f * Omega_left_foot_zy_1;
  const Scalar a_left_shank_x_1 = a_left_thigh_x + s_left_shank_y * Omega_left_thigh_xy;
  const Scalar a_left_shank_x = a_left_shank_x_1 + neg_s_left_shank_x * neg_Omega_left_thigh_xx;
  // left_ankle_cross: acceleration a, Omega of (3)
  const Scalar a_left_ankle_cross_x_1 = a_left_shank_x + s_left_ankle_cross_y * Omega_left_thigh_xy;
  const Scalar a_left_ankle_cross_x =
      a_left_ankle_cross_x_1 + neg_s_left_ankle_cross_x * neg_Omega_left_shank_xx;
  const Scalar a_left_foot_x_1 = t_left_thigh_5 + t_left_ankle_cross_3;
  const Scalar a_left_foot_x_2 = a_left_ankle_cross_x - a_left_foot_x_1;
  const Scalar a_left_foot_x = a_left_foot_x_2 + left_hip_fork_k3 * neg_Omega_left_foot_xy;
  const Scalar a_left_shank_y_1 = a_left_thigh_y - neg_s_left_shank_x * Omega_left_thigh_yx;
  const Scalar a_left_shank_y = a_left_shank_y_1 - s_left_shank_y * neg_Omega_left_thigh_yy;
  // left_foot: acceleration a, moment M, Omega of (3)
  const Scalar neg_a_left_foot_z_1 = Omega_left_thigh_yx + a_left_shank_y;
  const Scalar neg_a_left_foot_z_2 =
      neg_a_left_foot_z_1 + left_hip_fork_k3 * neg_Omega_left_thigh_yz;
  const Scalar neg_a_left_foot_z_3 =
      neg_a_left_foot_z_2 - neg_s_left_ankle_cross_x * Omega_left_thigh_yx;
  const Scalar neg_a_left_foot_z =
      neg_a_left_foot_z_3 - s_left_ankle_cross_y * neg_Omega_left_shank_yy;
  const Scalar t_left_foot_1 = omega_left_foot_z * omega_left_foot_z;
  const Scalar Omega_left_foot_zx = Omega_left_thigh_xy - t_left_shank_2 * omega_left_foot_z;
  const Scalar t_left_foot_2 = left_foot_I5 * c_left_foot - left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_3 = s_left_foot * t_left_foot_2;
  const Scalar t_left_foot_4 = left_foot_I13 - c_left_foot * t_left_foot_2;
  const Scalar t_left_foot_5 = left_foot_I2 * s_left_foot - left_foot_I3 * c_left_foot;
  const Scalar t_left_foot_6 = left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_7 = left_foot_I14 + t_left_foot_3;
  const Scalar t_left_foot_8 = left_foot_I1 * c_left_foot;
  const Scalar t_left_foot_9 = left_foot_I12 - t_left_foot_3;
  const Scalar t_left_foot_10 = left_foot_I3 * s_left_foot + left_foot_I2 * c_left_foot;
  const Scalar neg_M_left_foot_z_1 = t_left_ankle_cross_4 * t_left_foot_4;
  const Scalar neg_M_left_foot_z_2 = neg_M_left_foot_z_1 - a_left_foot_y * t_left_foot_8;
  const Scalar neg_M_left_foot_z_3 = neg_M_left_foot_z_2 - t_left_ankle_cross_1 * t_left_foot_5;
  const Scalar neg_M_left_foot_z_4 = neg_M_left_foot_z_3 - neg_Omega_left_foot_xy * t_left_foot_9;
  const Scalar neg_M_left_foot_z_5 = neg_M_left_foot_z_4 + a_left_foot_x * t_left_foot_6;
  const Scalar neg_M_left_foot_z_6 = neg_M_left_foot_z_5 - Omega_left_thigh_xy * t_left_foot_10;
  const Scalar neg_M_left_foot_z = neg_M_left_foot_z_6 - t_left_ankle_cross_2 * t_left_foot_7;
  B[5] = -neg_M_left_foot_z;
  const Scalar t_right_hip_block_1 = qd[6] * qd[6];
  // right_hip_fork: moment M, angular acceleration alpha of (3)
  const Scalar t_right_hip_fork_1 = left_hip_fork_I6 * c_right_hip_roll;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 + left_hip_fork_I2 * s_right_hip_roll;
  const Scalar t_right_hip_fork_3 = left_hip_fork_I7 - s_right_hip_roll * t_right_hip_fork_2;
  const Scalar alpha_right_hip_fork_x = qd[6] * qd[7];
  // right_thigh: angular velocity omega, angular acceleration alpha, Omega of (3)
  const Scalar t_right_thigh_1 = c_right_hip_roll * qd[6];
  const Scalar neg_omega_right_thigh_x = s_q8_q9_q10 * qd[7] + c_q8_q9_q10 * t_right_thigh_1;
  const Scalar t_right_thigh_2 = s_right_hip_roll * alpha_right_hip_fork_x;
  const Scalar omega_right_thigh_z = qd[8] + s_right_hip_roll * qd[6];
  const Scalar t_right_thigh_3 = neg_omega_right_thigh_x * omega_right_thigh_z;
  const Scalar t_right_thigh_4 = s_q8_q9_q10 * t_right_thigh_2;
  const Scalar neg_alpha_right_thigh_y = t_right_thigh_4 - neg_omega_right_thigh_x * qd[8];
  const Scalar neg_Omega_right_foot_xy = t_right_thigh_3 + neg_alpha_right_thigh_y;
  const Scalar omega_right_thigh_y = s_q8_q9_q10 * t_right_thigh_1 - c_q8_q9_q10 * qd[7];
  const Scalar t_right_thigh_5 = omega_right_thigh_z * omega_right_thigh_y;
  const Scalar alpha_right_thigh_x = c_q8_q9_q10 * t_right_thigh_2 + qd[8] * omega_right_thigh_y;
  const Scalar Omega_right_thigh_yz = t_right_thigh_5 - alpha_right_thigh_x;
  const Scalar t_right_thigh_6 = omega_right_thigh_y * omega_right_thigh_y;
  const Scalar t_right_thigh_7 = neg_omega_right_thigh_x * neg_omega_right_thigh_x;
  const Scalar neg_Omega_right_thigh_zz = t_right_thigh_6 + t_right_thigh_7;
  const Scalar t_right_thigh_8 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar neg_Omega_right_thigh_xx = t_right_thigh_6 + t_right_thigh_8;
  const Scalar neg_Omega_right_thigh_zx = t_right_thigh_3 - neg_alpha_right_thigh_y;
  const Scalar Omega_right_thigh_zy = t_right_thigh_5 + alpha_right_thigh_x;
  const Scalar neg_Omega_right_thigh_yy = t_right_thigh_7 + t_right_thigh_8;
  const Scalar t_right_thigh_9 = neg_omega_right_thigh_x * omega_right_thigh_y;
  const Scalar alpha_right_thigh_z = qd[7] * t_right_thigh_1;
  const Scalar Omega_right_foot_xz = t_right_thigh_9 + alpha_right_thigh_z;
  const Scalar neg_Omega_right_thigh_yx = t_right_thigh_9 - alpha_right_thigh_z;
  const Scalar a_right_thigh_y = c_q8_q9_q10 * t_right_hip_block_1;
  const Scalar a_right_thigh_x = s_q8_q9_q10 * t_right_hip_block_1;
  const Scalar t_right_thigh_10 = left_thigh_I8 * c_q9_q10 + left_thigh_I6 * s_q9_q10;
  const Scalar t_right_thigh_11 = left_thigh_I9 * s_q9_q10 - left_thigh_I3 * c_q9_q10;
  const Scalar t_right_thigh_12 = s_q9_q10 * t_right_thigh_11;
  const Scalar t_right_thigh_13 = left_thigh_I10 - t_right_thigh_12;
  const Scalar t_right_thigh_14 = left_thigh_I8 * s_q9_q10 - left_thigh_I6 * c_q9_q10;
  const Scalar t_right_shank_1 = neg_Omega_right_thigh_xx - neg_Omega_right_thigh_yy;
  const Scalar t_right_thigh_15 = left_thigh_I12 + c_q9_q10 * t_right_thigh_11;
  const Scalar t_right_thigh_16 = left_thigh_I13 * s_q9_q10 - left_thigh_I2 * c_q9_q10;
  const Scalar t_right_thigh_17 = left_thigh_I13 * c_q9_q10 + left_thigh_I2 * s_q9_q10;
  // right_shank: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar t_right_shank_2 = 2.0f * omega_right_thigh_y;
  const Scalar neg_Omega_right_shank_zy =
      Omega_right_thigh_yz - omega_right_shank_z * t_right_shank_2;
  const Scalar a_right_shank_z_1 = neg_s_right_shank_x * neg_Omega_right_thigh_zx;
  const Scalar a_right_shank_z = a_right_shank_z_1 + s_right_shank_y * Omega_right_thigh_zy;
  const Scalar t_right_shank_3 = 2.0f * neg_omega_right_thigh_x;
  const Scalar Omega_right_shank_zx =
      neg_Omega_right_foot_xy - omega_right_shank_z * t_right_shank_3;
  const Scalar t_right_shank_4 = omega_right_shank_z * omega_right_shank_z;
  const Scalar neg_Omega_right_shank_xx = t_right_thigh_6 + t_right_shank_4;
  const Scalar neg_Omega_right_shank_yy = t_right_thigh_7 + t_right_shank_4;
  const Scalar t_right_shank_5 = left_shank_I4 * c_right_ankle_pitch;
  const Scalar t_right_shank_6 = t_right_shank_5 + left_shank_I8 * s_right_ankle_pitch;
  const Scalar t_right_shank_7 = left_shank_I9 - c_right_ankle_pitch * t_right_shank_6;
  const Scalar t_right_shank_8 = left_shank_I11 * s_right_ankle_pitch;
  const Scalar t_right_shank_9 = t_right_shank_8 - left_shank_I6 * c_right_ankle_pitch;
  const Scalar t_right_shank_10 = s_right_ankle_pitch * t_right_shank_6;
  const Scalar t_right_shank_11 = left_shank_I11 * c_right_ankle_pitch;
  const Scalar t_right_shank_12 = left_shank_I6 * s_right_ankle_pitch + t_right_shank_11;
  const Scalar t_right_shank_13 = left_shank_I12 * c_right_ankle_pitch;
  const Scalar t_right_shank_14 = left_shank_I2 * s_right_ankle_pitch + t_right_shank_13;
  const Scalar t_right_shank_15 = left_shank_I12 * s_right_ankle_pitch;
  const Scalar t_right_shank_16 = left_shank_I2 * c_right_ankle_pitch - t_right_shank_15;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar Omega_right_foot_yz = neg_Omega_right_shank_zy - t_right_shank_2 * qd[10];
  // right_ankle_cross: Omega, acceleration a of (3)
  const Scalar Omega_righ_ankl_cros_zx = Omega_right_shank_zx - t_right_shank_3 * qd[10];
  const Scalar t_righ_ankl_cros_1 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar a_righ_ankl_cros_z_1 =
      a_right_shank_z - s_righ_ankl_cros_y * neg_Omega_right_shank_zy;
  const Scalar a_righ_ankl_cros_z =
      a_righ_ankl_cros_z_1 - neg_s_righ_ankl_cros_x * Omega_right_shank_zx;
  const Scalar a_right_foot_y_1 = Omega_righ_ankl_cros_zx + a_righ_ankl_cros_z;
  const Scalar a_right_foot_y = a_right_foot_y_1 - left_hip_fork_k3 * neg_Omega_right_thigh_zz;
  const Scalar a_right_shank_y_1 = a_right_thigh_y + neg_s_right_shank_x * neg_Omega_right_thigh_yx;
  const Scalar a_right_shank_y = a_right_shank_y_1 - s_right_shank_y * neg_Omega_right_thigh_yy;
  // right_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar a_right_foot_z_1 = neg_Omega_right_thigh_yx - a_right_shank_y;
  const Scalar a_right_foot_z_2 =
      a_right_foot_z_1 - neg_s_righ_ankl_cros_x * neg_Omega_right_thigh_yx;
  const Scalar a_right_foot_z_3 = a_right_foot_z_2 - left_hip_fork_k3 * Omega_right_thigh_yz;
  const Scalar a_right_foot_z = a_right_foot_z_3 + s_righ_ankl_cros_y * neg_Omega_right_shank_yy;
  const Scalar t_righ_ankl_cros_2 = t_right_thigh_6 + t_righ_ankl_cros_1;
  const Scalar a_right_shank_x_1 = a_right_thigh_x + neg_s_right_shank_x * neg_Omega_right_thigh_xx;
  const Scalar a_right_shank_x = a_right_shank_x_1 - s_right_shank_y * Omega_right_foot_xz;
  const Scalar a_righ_ankl_cros_x_1 = a_right_shank_x - s_righ_ankl_cros_y * Omega_right_foot_xz;
  const Scalar a_righ_ankl_cros_x =
      a_righ_ankl_cros_x_1 + neg_s_righ_ankl_cros_x * neg_Omega_right_shank_xx;
  const Scalar neg_a_right_foot_x_1 = t_righ_ankl_cros_2 - a_righ_ankl_cros_x;
  const Scalar neg_a_right_foot_x =
      neg_a_right_foot_x_1 + left_hip_fork_k3 * neg_Omega_right_foot_xy;
  const Scalar neg_omega_right_foot_z = omega_right_thigh_y - qd[11];
  const Scalar t_right_foot_1 = 2.0f * neg_omega_right_foot_z;
  const Scalar neg_Omega_right_foot_zy =
      Omega_right_foot_yz + omega_righ_ankl_cros_z * t_right_foot_1;
  const Scalar t_right_foot_2 = neg_omega_right_foot_z * neg_omega_right_foot_z;
  const Scalar t_right_foot_3 = left_foot_I1 * c_right_foot;
  const Scalar t_right_foot_4 = left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_5 = left_foot_I4 * s_right_foot - left_foot_I5 * c_right_foot;
  const Scalar t_right_foot_6 = s_right_foot * t_right_foot_5;
  const Scalar t_right_foot_7 = left_foot_I14 - t_right_foot_6;
  const Scalar t_right_foot_8 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_9 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_10 = left_foot_I12 + t_right_foot_6;
  const Scalar t_right_foot_11 = left_foot_I13 + c_right_foot * t_right_foot_5;
  const Scalar t_righ_ankl_cros_3 = neg_Omega_right_thigh_zz - t_righ_ankl_cros_2;
  const Scalar M_right_foot_z_1 = Omega_righ_ankl_cros_zx * t_right_foot_7;
  const Scalar M_right_foot_z_2 = a_right_foot_y * t_right_foot_3 + M_right_foot_z_1;
  const Scalar M_right_foot_z_3 = M_right_foot_z_2 + Omega_right_foot_xz * t_right_foot_9;
  const Scalar M_right_foot_z_4 = M_right_foot_z_3 - Omega_right_foot_yz * t_right_foot_8;
  const Scalar M_right_foot_z_5 = M_right_foot_z_4 + neg_Omega_right_foot_xy * t_right_foot_10;
  const Scalar M_right_foot_z_6 = M_right_foot_z_5 + t_right_foot_11 * t_righ_ankl_cros_3;
  const Scalar M_right_foot_z = M_right_foot_z_6 - neg_a_right_foot_x * t_right_foot_4;
  B[11] = M_right_foot_z;
  const Scalar neg_Omega_right_foot_zx =
      Omega_right_foot_xz - neg_omega_right_thigh_x * t_right_foot_1;
  const Scalar neg_F_right_foot_z_1 = t_right_foot_3 * neg_Omega_right_foot_zx;
  const Scalar neg_F_right_foot_z_2 = neg_F_right_foot_z_1 - left_ankle_cross_I1 * a_right_foot_z;
  const Scalar neg_F_right_foot_z = neg_F_right_foot_z_2 - neg_Omega_right_foot_zy * t_right_foot_4;
  const Scalar neg_Omega_right_foot_xx = t_righ_ankl_cros_1 + t_right_foot_2;
  const Scalar neg_F_right_foot_x_1 = t_right_foot_3 * neg_Omega_right_foot_xx;
  const Scalar neg_F_right_foot_x_2 =
      left_ankle_cross_I1 * neg_a_right_foot_x + neg_F_right_foot_x_1;
  const Scalar neg_F_right_foot_x = neg_F_right_foot_x_2 - neg_Omega_right_foot_xy * t_right_foot_4;
  // right_ankle_cross: moment M of (3)
  const Scalar M_righ_ankl_cros_z_1 =
      neg_F_right_foot_z + left_ankle_cross_I13 * alpha_right_thigh_z;
  const Scalar M_righ_ankl_cros_z_2 =
      M_righ_ankl_cros_z_1 - neg_Omega_right_foot_zy * t_right_foot_11;
  const Scalar M_righ_ankl_cros_z_3 =
      M_righ_ankl_cros_z_2 + left_ankle_cross_I10 * Omega_right_thigh_yz;
  const Scalar M_righ_ankl_cros_z_4 =
      M_righ_ankl_cros_z_3 + left_ankle_cross_I3 * a_righ_ankl_cros_x;
  const Scalar M_righ_ankl_cros_z_5 = M_righ_ankl_cros_z_4 - left_ankle_cross_I8 * t_right_shank_1;
  const Scalar M_righ_ankl_cros_z_6 = M_righ_ankl_cros_z_5 + left_ankle_cross_I12 * t_right_thigh_9;
  const Scalar M_righ_ankl_cros_z_7 = t_right_thigh_7 - t_right_foot_2;
  const Scalar M_righ_ankl_cros_z_8 = M_righ_ankl_cros_z_6 - t_right_foot_8 * M_righ_ankl_cros_z_7;
  const Scalar M_righ_ankl_cros_z_9 =
      M_righ_ankl_cros_z_8 + t_right_foot_7 * neg_Omega_right_foot_zx;
  const Scalar M_righ_ankl_cros_z_10 = left_ankle_cross_I2 - t_right_foot_9;
  const Scalar M_righ_ankl_cros_z_11 = M_righ_ankl_cros_z_9 - a_right_foot_z * t_right_foot_3;
  const Scalar M_righ_ankl_cros_z =
      M_righ_ankl_cros_z_11 - neg_Omega_right_foot_xy * M_righ_ankl_cros_z_10;
  B[10] = M_righ_ankl_cros_z;
  // right_foot: force F, Omega of (3)
  const Scalar F_right_foot_y_1 = Omega_righ_ankl_cros_zx * t_right_foot_3;
  const Scalar F_right_foot_y_2 = F_right_foot_y_1 + left_ankle_cross_I1 * a_right_foot_y;
  const Scalar neg_Omega_right_foot_yy = t_right_thigh_7 + t_right_foot_2;
  const Scalar F_right_foot_y = F_right_foot_y_2 + t_right_foot_4 * neg_Omega_right_foot_yy;
  // right_ankle_cross: force F, Omega of (3)
  const Scalar F_righ_ankl_cros_z = F_right_foot_y + left_ankle_cross_I3 * Omega_right_foot_yz;
  const Scalar F_righ_ankl_cros_y_1 = t_right_thigh_7 + t_righ_ankl_cros_1;
  const Scalar F_righ_ankl_cros_y = neg_F_right_foot_z + left_ankle_cross_I3 * F_righ_ankl_cros_y_1;
  const Scalar neg_F_righ_ankl_cros_x =
      neg_F_right_foot_x - left_ankle_cross_I3 * Omega_right_foot_xz;
  // right_shank: moment M, force F of (3)
  const Scalar t_right_shank_17 = left_shank_I10 + t_right_shank_10;
  const Scalar t_right_shank_18 = left_shank_I13 - t_right_shank_10;
  const Scalar M_right_shank_z_1 = M_righ_ankl_cros_z - t_right_shank_14 * a_right_shank_y;
  const Scalar M_right_shank_z_2 = M_right_shank_z_1 + t_right_shank_1 * t_right_shank_7;
  const Scalar M_right_shank_z_3 = M_right_shank_z_2 + t_right_shank_16 * a_right_shank_x;
  const Scalar M_right_shank_z_4 = M_right_shank_z_3 - neg_s_righ_ankl_cros_x * F_righ_ankl_cros_y;
  const Scalar M_right_shank_z_5 = M_right_shank_z_4 - Omega_right_thigh_yz * t_right_shank_12;
  const Scalar M_right_shank_z_6 = M_right_shank_z_5 + s_righ_ankl_cros_y * neg_F_righ_ankl_cros_x;
  const Scalar M_right_shank_z_7 = M_right_shank_z_6 + neg_Omega_right_foot_xy * t_right_shank_9;
  const Scalar M_right_shank_z_8 = M_right_shank_z_7 + Omega_right_foot_xz * t_right_shank_17;
  const Scalar M_right_shank_z = M_right_shank_z_8 - neg_Omega_right_thigh_yx * t_right_shank_18;
  B[9] = M_right_shank_z;
  const Scalar neg_M_right_thigh_y_1 = neg_Omega_right_thigh_zz - neg_Omega_right_shank_xx;
  const Scalar F_right_shank_z_1 = F_righ_ankl_cros_z - Omega_right_shank_zx * t_right_shank_14;
  const Scalar F_right_shank_z = F_right_shank_z_1 + neg_Omega_right_shank_zy * t_right_shank_16;
  const Scalar neg_M_right_thigh_y_2 = left_ankle_cross_I2 - t_right_thigh_14;
  const Scalar neg_M_right_thigh_y_3 = t_right_thigh_7 - t_right_thigh_8;
  const Scalar neg_M_right_thigh_y_4 = M_right_foot_z + F_right_foot_y;
  const Scalar neg_M_right_thigh_y_5 =
      neg_M_right_thigh_y_4 - neg_Omega_right_shank_zy * t_right_shank_7;
  const Scalar neg_M_right_thigh_y_6 =
      neg_M_right_thigh_y_5 + left_ankle_cross_I8 * Omega_right_foot_yz;
  const Scalar neg_M_right_thigh_y_7 =
      neg_M_right_thigh_y_6 + left_ankle_cross_I11 * Omega_righ_ankl_cros_zx;
  const Scalar neg_M_right_thigh_y_8 =
      neg_M_right_thigh_y_7 - neg_s_right_shank_x * F_right_shank_z;
  const Scalar neg_M_right_thigh_y_9 =
      neg_M_right_thigh_y_8 - left_ankle_cross_I10 * t_righ_ankl_cros_3;
  const Scalar neg_M_right_thigh_y_10 =
      neg_M_right_thigh_y_9 + left_hip_fork_k3 * neg_F_right_foot_x;
  const Scalar neg_M_right_thigh_y_11 =
      neg_M_right_thigh_y_10 - neg_Omega_right_thigh_zx * t_right_thigh_13;
  const Scalar neg_M_right_thigh_y_12 =
      neg_M_right_thigh_y_11 - Omega_right_thigh_zy * t_right_thigh_15;
  const Scalar neg_M_right_thigh_y_13 = t_right_shank_9 - neg_M_right_thigh_y_2;
  const Scalar neg_M_right_thigh_y_14 = neg_M_right_thigh_y_12 - a_right_shank_z * t_right_shank_14;
  const Scalar neg_M_right_thigh_y_15 =
      neg_M_right_thigh_y_14 + Omega_right_foot_xz * neg_M_right_thigh_y_13;
  const Scalar neg_M_right_thigh_y_16 =
      neg_M_right_thigh_y_15 + t_right_shank_12 * neg_M_right_thigh_y_1;
  const Scalar neg_M_right_thigh_y_17 =
      neg_M_right_thigh_y_16 + Omega_right_shank_zx * t_right_shank_18;
  const Scalar neg_M_right_thigh_y_18 =
      neg_M_right_thigh_y_17 + t_right_thigh_10 * neg_M_right_thigh_y_3;
  const Scalar neg_M_right_thigh_y =
      neg_M_right_thigh_y_18 - neg_s_righ_ankl_cros_x * F_righ_ankl_cros_z;
  const Scalar neg_M_right_thigh_x_1 = left_ankle_cross_I10 - t_right_thigh_10;
  const Scalar neg_M_right_thigh_x_2 = neg_Omega_right_thigh_zz - neg_Omega_right_shank_yy;
  const Scalar t_right_thigh_18 = left_thigh_I11 + t_right_thigh_12;
  const Scalar neg_M_right_thigh_x_3 = t_right_thigh_6 - t_right_thigh_8;
  const Scalar neg_M_right_thigh_x_4 = t_righ_ankl_cros_1 - t_right_foot_2;
  const Scalar neg_M_right_thigh_x_5 = left_ankle_cross_I9 * Omega_right_foot_yz;
  const Scalar neg_M_right_thigh_x_6 = left_ankle_cross_I8 - t_right_foot_8;
  const Scalar neg_M_right_thigh_x_7 =
      left_hip_fork_k3 * neg_F_right_foot_z + neg_M_right_thigh_x_5;
  const Scalar neg_M_right_thigh_x_8 =
      neg_M_right_thigh_x_7 + Omega_righ_ankl_cros_zx * neg_M_right_thigh_x_6;
  const Scalar neg_M_right_thigh_x_9 = t_right_shank_12 - neg_M_right_thigh_x_1;
  const Scalar neg_M_right_thigh_x_10 = neg_M_right_thigh_x_8 + a_right_shank_z * t_right_shank_16;
  const Scalar neg_M_right_thigh_x_11 =
      neg_M_right_thigh_x_10 + neg_Omega_right_thigh_yx * neg_M_right_thigh_x_9;
  const Scalar neg_M_right_thigh_x_12 =
      neg_M_right_thigh_x_11 + neg_Omega_right_foot_zy * t_right_foot_10;
  const Scalar neg_M_right_thigh_x_13 = t_right_thigh_6 - t_righ_ankl_cros_1;
  const Scalar neg_M_right_thigh_x_14 =
      neg_M_right_thigh_x_12 - Omega_right_thigh_zy * t_right_thigh_18;
  const Scalar neg_M_right_thigh_x_15 =
      neg_M_right_thigh_x_14 - left_ankle_cross_I2 * neg_M_right_thigh_x_13;
  const Scalar neg_M_right_thigh_x_16 =
      neg_M_right_thigh_x_15 - t_right_foot_11 * neg_Omega_right_foot_zx;
  const Scalar neg_M_right_thigh_x_17 =
      neg_M_right_thigh_x_16 + neg_Omega_right_shank_zy * t_right_shank_17;
  const Scalar neg_M_right_thigh_x_18 =
      neg_M_right_thigh_x_17 - neg_Omega_right_thigh_zx * t_right_thigh_15;
  const Scalar neg_M_right_thigh_x_19 =
      neg_M_right_thigh_x_18 + t_right_shank_9 * neg_M_right_thigh_x_2;
  const Scalar neg_M_right_thigh_x_20 =
      neg_M_right_thigh_x_19 + left_ankle_cross_I3 * a_righ_ankl_cros_z;
  const Scalar neg_M_right_thigh_x_21 = neg_M_right_thigh_x_20 - s_right_shank_y * F_right_shank_z;
  const Scalar neg_M_right_thigh_x_22 =
      neg_M_right_thigh_x_21 - Omega_right_shank_zx * t_right_shank_7;
  const Scalar neg_M_right_thigh_x_23 =
      neg_M_right_thigh_x_22 - s_righ_ankl_cros_y * F_righ_ankl_cros_z;
  const Scalar neg_M_right_thigh_x_24 = neg_M_right_thigh_x_23 + a_right_foot_z * t_right_foot_4;
  const Scalar neg_M_right_thigh_x_25 =
      neg_M_right_thigh_x_24 + t_right_thigh_14 * neg_M_right_thigh_x_3;
  const Scalar neg_M_right_thigh_x =
      neg_M_right_thigh_x_25 - t_right_foot_9 * neg_M_right_thigh_x_4;
  const Scalar neg_F_right_shank_x_1 =
      neg_F_righ_ankl_cros_x - neg_Omega_right_shank_xx * t_right_shank_14;
  const Scalar neg_F_right_shank_x = neg_F_right_shank_x_1 - Omega_right_foot_xz * t_right_shank_16;
  const Scalar F_right_shank_y_1 = F_righ_ankl_cros_y + neg_Omega_right_thigh_yx * t_right_shank_14;
  const Scalar F_right_shank_y = F_right_shank_y_1 + neg_Omega_right_shank_yy * t_right_shank_16;
  // right_thigh: moment M, force F of (3)
  const Scalar M_right_thigh_z_1 = M_right_shank_z - neg_s_right_shank_x * F_right_shank_y;
  const Scalar M_right_thigh_z_2 = M_right_thigh_z_1 - t_right_shank_1 * t_right_thigh_15;
  const Scalar M_right_thigh_z_3 = M_right_thigh_z_2 - neg_Omega_right_thigh_yx * t_right_thigh_13;
  const Scalar M_right_thigh_z_4 = M_right_thigh_z_3 + s_right_shank_y * neg_F_right_shank_x;
  const Scalar M_right_thigh_z_5 = M_right_thigh_z_4 + Omega_right_foot_xz * t_right_thigh_18;
  const Scalar M_right_thigh_z_6 = M_right_thigh_z_5 - a_right_thigh_x * t_right_thigh_16;
  const Scalar M_right_thigh_z_7 = M_right_thigh_z_6 - a_right_thigh_y * t_right_thigh_17;
  const Scalar M_right_thigh_z_8 = M_right_thigh_z_7 - Omega_right_thigh_yz * t_right_thigh_10;
  const Scalar M_right_thigh_z = M_right_thigh_z_8 + neg_Omega_right_foot_xy * t_right_thigh_14;
  B[8] = M_right_thigh_z;
  const Scalar F_right_thigh_y_1 = F_right_shank_y + neg_Omega_right_thigh_yx * t_right_thigh_17;
  const Scalar F_right_thigh_y = F_right_thigh_y_1 - neg_Omega_right_thigh_yy * t_right_thigh_16;
  const Scalar M_right_hip_fork_y_1 = qd[7] * qd[7];
  const Scalar neg_F_right_thigh_x_1 = neg_F_right_shank_x + Omega_right_foot_xz * t_right_thigh_16;
  const Scalar neg_F_right_thigh_x =
      neg_F_right_thigh_x_1 - neg_Omega_right_thigh_xx * t_right_thigh_17;
  // right_hip_fork: moment M of (3)
  const Scalar M_right_hip_fork_y_2 = M_right_thigh_z + left_hip_fork_I9 * M_right_hip_fork_y_1;
  const Scalar M_right_hip_fork_y_3 = M_right_hip_fork_y_2 - c_q8_q9_q10 * neg_F_right_thigh_x;
  const Scalar M_right_hip_fork_y_4 = F_right_shank_z + left_hip_fork_I8 * M_right_hip_fork_y_1;
  const Scalar M_right_hip_fork_y_5 = M_right_hip_fork_y_4 + c_q8_q9_q10 * neg_M_right_thigh_x;
  const Scalar M_right_hip_fork_y_6 =
      M_right_hip_fork_y_5 + Omega_right_thigh_zy * t_right_thigh_16;
  const Scalar M_right_hip_fork_y_7 = M_right_hip_fork_y_6 - s_q8_q9_q10 * neg_M_right_thigh_y;
  const Scalar M_right_hip_fork_y_8 = M_right_hip_fork_y_3 - s_q8_q9_q10 * F_right_thigh_y;
  const Scalar M_right_hip_fork_y_9 = t_right_hip_fork_3 * alpha_right_hip_fork_x * 2.0f;
  const Scalar M_right_hip_fork_y_10 =
      M_right_hip_fork_y_7 + neg_Omega_right_thigh_zx * t_right_thigh_17;
  const Scalar M_right_hip_fork_y_11 =
      M_right_hip_fork_y_9 + s_right_hip_roll * M_right_hip_fork_y_8;
  B[6] = M_right_hip_fork_y_11 + c_right_hip_roll * M_right_hip_fork_y_10;
  const Scalar M_right_hip_fork_z_1 = c_q8_q9_q10 * neg_M_right_thigh_y;
  const Scalar M_right_hip_fork_z_2 = M_right_hip_fork_z_1 + s_q8_q9_q10 * neg_M_right_thigh_x;
  B[7] = M_right_hip_fork_z_2 - t_right_hip_block_1 * t_right_hip_fork_3;
  // left_foot: force F, moment M, Omega of (3)
  const Scalar F_left_foot_z_1 = left_ankle_cross_I1 * neg_a_left_foot_z;
  const Scalar F_left_foot_z_2 = Omega_left_foot_zx * t_left_foot_8 - F_left_foot_z_1;
  const Scalar F_left_foot_z = F_left_foot_z_2 + Omega_left_foot_zy * t_left_foot_6;
  const Scalar t_left_foot_11 = F_left_foot_z - left_ankle_cross_I13 * alpha_left_thigh_z;
  const Scalar t_left_foot_12 = t_left_foot_11 - left_ankle_cross_I10 * neg_Omega_left_thigh_yz;
  const Scalar t_left_foot_13 = t_left_foot_12 + left_ankle_cross_I12 * t_left_thigh_11;
  const Scalar t_left_foot_14 = t_left_foot_13 - neg_a_left_foot_z * t_left_foot_8;
  const Scalar t_left_foot_15 = t_left_foot_14 + Omega_left_foot_zy * t_left_foot_4;
  const Scalar t_left_foot_16 = t_left_thigh_3 - t_left_foot_1;
  const Scalar t_left_foot_17 = t_left_foot_15 + t_left_foot_5 * t_left_foot_16;
  const Scalar t_left_foot_18 = t_left_foot_17 + left_ankle_cross_I8 * t_left_thigh_17;
  const Scalar t_left_foot_19 = left_ankle_cross_I2 - t_left_foot_10;
  const Scalar t_left_foot_20 = t_left_foot_18 - neg_Omega_left_foot_xy * t_left_foot_19;
  const Scalar t_left_foot_21 = t_left_foot_20 + Omega_left_foot_zx * t_left_foot_7;
  const Scalar neg_M_left_ankle_cross_z =
      t_left_foot_21 - left_ankle_cross_I3 * a_left_ankle_cross_x;
  B[4] = -neg_M_left_ankle_cross_z;
  const Scalar neg_F_left_foot_y_1 = t_left_foot_6 * (t_left_thigh_3 + t_left_foot_1);
  const Scalar neg_F_left_foot_y_2 = neg_F_left_foot_y_1 - left_ankle_cross_I1 * a_left_foot_y;
  const Scalar neg_F_left_foot_y = neg_F_left_foot_y_2 - t_left_ankle_cross_2 * t_left_foot_8;
  const Scalar neg_F_left_ankle_cross_z =
      neg_F_left_foot_y + left_ankle_cross_I3 * t_left_ankle_cross_1;
  const Scalar neg_F_left_foot_x_1 = neg_Omega_left_foot_xy * t_left_foot_6;
  const Scalar neg_F_left_foot_x_2 = neg_F_left_foot_x_1 - left_ankle_cross_I1 * a_left_foot_x;
  const Scalar neg_Omega_left_foot_xx = t_left_ankle_cross_3 + t_left_foot_1;
  const Scalar neg_F_left_foot_x = neg_F_left_foot_x_2 + t_left_foot_8 * neg_Omega_left_foot_xx;
  const Scalar neg_F_left_ankle_cross_x =
      neg_F_left_foot_x + left_ankle_cross_I3 * Omega_left_thigh_xy;
  const Scalar t_left_ankle_cross_5 = t_left_thigh_3 + t_left_ankle_cross_3;
  const Scalar neg_F_left_ankle_cross_y =
      F_left_foot_z - left_ankle_cross_I3 * t_left_ankle_cross_5;
  // left_ankle_cross: moment M, force F of (3)
  const Scalar neg_M_left_shank_z_1 = neg_M_left_ankle_cross_z - t_left_thigh_17 * t_left_shank_6;
  const Scalar neg_M_left_shank_z_2 =
      neg_M_left_shank_z_1 - s_left_ankle_cross_y * neg_F_left_ankle_cross_x;
  const Scalar neg_M_left_shank_z_3 =
      neg_M_left_shank_z_2 + neg_Omega_left_foot_xy * t_left_shank_12;
  const Scalar neg_M_left_shank_z_4 = neg_M_left_shank_z_3 - Omega_left_thigh_yx * t_left_shank_15;
  const Scalar neg_M_left_shank_z_5 =
      neg_M_left_shank_z_4 + neg_Omega_left_thigh_yz * t_left_shank_10;
  const Scalar neg_M_left_shank_z_6 = neg_M_left_shank_z_5 + t_left_shank_17 * a_left_shank_y;
  const Scalar neg_M_left_shank_z_7 = neg_M_left_shank_z_6 + Omega_left_thigh_xy * t_left_shank_8;
  const Scalar neg_M_left_shank_z_8 = neg_M_left_shank_z_7 - t_left_shank_14 * a_left_shank_x;
  const Scalar neg_M_left_shank_z =
      neg_M_left_shank_z_8 - neg_s_left_ankle_cross_x * neg_F_left_ankle_cross_y;
  B[3] = -neg_M_left_shank_z;
  const Scalar neg_F_left_shank_z_1 =
      neg_F_left_ankle_cross_z + Omega_left_shank_zy * t_left_shank_14;
  const Scalar neg_F_left_shank_z = neg_F_left_shank_z_1 + Omega_left_shank_zx * t_left_shank_17;
  const Scalar t_left_thigh_21 = left_thigh_I11 + t_left_thigh_14;
  const Scalar M_left_thigh_x_1 = t_left_ankle_cross_3 - t_left_foot_1;
  const Scalar M_left_thigh_x_2 = left_ankle_cross_I8 - t_left_foot_5;
  const Scalar M_left_thigh_x_3 = neg_Omega_left_thigh_zz - neg_Omega_left_shank_yy;
  const Scalar M_left_thigh_x_4 = neg_Omega_left_thigh_zz - t_left_ankle_cross_5;
  const Scalar M_left_thigh_x_5 = left_ankle_cross_I9 * t_left_ankle_cross_1;
  // left_thigh: moment M of (3)
  const Scalar M_left_thigh_x_6 = M_left_thigh_x_5 + Omega_left_foot_zy * t_left_foot_9;
  const Scalar M_left_thigh_x_7 = M_left_thigh_x_6 - left_hip_fork_k3 * F_left_foot_z;
  const Scalar M_left_thigh_x_8 = t_left_thigh_5 - t_left_thigh_7;
  const Scalar M_left_thigh_x_9 = M_left_thigh_x_7 + t_left_thigh_16 * M_left_thigh_x_8;
  const Scalar M_left_thigh_x_10 = M_left_thigh_x_9 + Omega_left_foot_zx * t_left_foot_4;
  const Scalar M_left_thigh_x_11 = M_left_thigh_x_10 + neg_Omega_left_thigh_zx * t_left_thigh_18;
  const Scalar M_left_thigh_x_12 =
      M_left_thigh_x_11 - s_left_ankle_cross_y * neg_F_left_ankle_cross_z;
  const Scalar M_left_thigh_x_13 = M_left_thigh_x_12 - s_left_shank_y * neg_F_left_shank_z;
  const Scalar M_left_thigh_x_14 = t_left_shank_10 - (left_ankle_cross_I10 - t_left_thigh_12);
  const Scalar M_left_thigh_x_15 = M_left_thigh_x_13 - neg_Omega_left_thigh_zy * t_left_thigh_21;
  const Scalar M_left_thigh_x_16 = M_left_thigh_x_15 - Omega_left_thigh_yx * M_left_thigh_x_14;
  const Scalar M_left_thigh_x_17 = M_left_thigh_x_16 + Omega_left_shank_zx * t_left_shank_6;
  const Scalar M_left_thigh_x_18 = M_left_thigh_x_17 - t_left_foot_10 * M_left_thigh_x_1;
  const Scalar M_left_thigh_x_19 = M_left_thigh_x_18 - t_left_ankle_cross_2 * M_left_thigh_x_2;
  const Scalar M_left_thigh_x_20 = M_left_thigh_x_19 - neg_a_left_foot_z * t_left_foot_6;
  const Scalar M_left_thigh_x_21 = M_left_thigh_x_20 - left_ankle_cross_I3 * a_left_ankle_cross_z;
  const Scalar M_left_thigh_x_22 = M_left_thigh_x_21 + Omega_left_shank_zy * t_left_shank_8;
  const Scalar M_left_thigh_x_23 = M_left_thigh_x_22 - a_left_shank_z * t_left_shank_14;
  const Scalar M_left_thigh_x_24 = M_left_thigh_x_23 + t_left_shank_12 * M_left_thigh_x_3;
  const Scalar M_left_thigh_x = M_left_thigh_x_24 - left_ankle_cross_I2 * M_left_thigh_x_4;
  // left_ankle_cross: force F of (3)
  const Scalar neg_F_left_shank_y_1 =
      neg_F_left_ankle_cross_y + Omega_left_thigh_yx * t_left_shank_17;
  const Scalar neg_F_left_shank_y =
      neg_F_left_shank_y_1 - neg_Omega_left_shank_yy * t_left_shank_14;
  const Scalar neg_F_left_shank_x_1 =
      neg_F_left_ankle_cross_x - neg_Omega_left_shank_xx * t_left_shank_17;
  const Scalar neg_F_left_shank_x = neg_F_left_shank_x_1 + Omega_left_thigh_xy * t_left_shank_14;
  // left_shank: moment M of (3)
  const Scalar neg_M_left_thigh_z_1 =
      neg_M_left_shank_z + neg_Omega_left_thigh_yz * t_left_thigh_12;
  const Scalar neg_M_left_thigh_z_2 = neg_M_left_thigh_z_1 - Omega_left_thigh_yx * t_left_thigh_15;
  const Scalar neg_M_left_thigh_z_3 =
      neg_M_left_thigh_z_2 + neg_Omega_left_foot_xy * t_left_thigh_16;
  const Scalar neg_M_left_thigh_z_4 = neg_M_left_thigh_z_3 - a_left_thigh_x * t_left_thigh_19;
  const Scalar neg_M_left_thigh_z_5 = neg_M_left_thigh_z_4 + a_left_thigh_y * t_left_thigh_20;
  const Scalar neg_M_left_thigh_z_6 = neg_M_left_thigh_z_5 - s_left_shank_y * neg_F_left_shank_x;
  const Scalar neg_M_left_thigh_z_7 = neg_M_left_thigh_z_6 + Omega_left_thigh_xy * t_left_thigh_21;
  const Scalar neg_M_left_thigh_z_8 =
      neg_M_left_thigh_z_7 - neg_s_left_shank_x * neg_F_left_shank_y;
  const Scalar neg_M_left_thigh_z = neg_M_left_thigh_z_8 + t_left_thigh_17 * t_left_thigh_18;
  B[2] = -neg_M_left_thigh_z;
  // left_thigh: moment M of (3)
  const Scalar M_left_thigh_y_1 = neg_M_left_foot_z + neg_F_left_foot_y;
  const Scalar M_left_thigh_y_2 = M_left_thigh_y_1 + left_ankle_cross_I8 * t_left_ankle_cross_1;
  const Scalar M_left_thigh_y_3 = M_left_thigh_y_2 - left_ankle_cross_I10 * t_left_ankle_cross_4;
  const Scalar M_left_thigh_y_4 = M_left_thigh_y_3 + left_hip_fork_k3 * neg_F_left_foot_x;
  const Scalar M_left_thigh_y_5 = t_left_shank_12 - (left_ankle_cross_I2 - t_left_thigh_16);
  const Scalar M_left_thigh_y_6 = M_left_thigh_y_4 + neg_Omega_left_thigh_zx * t_left_thigh_15;
  const Scalar M_left_thigh_y_7 = M_left_thigh_y_6 - Omega_left_thigh_xy * M_left_thigh_y_5;
  const Scalar M_left_thigh_y_8 = M_left_thigh_y_7 - neg_Omega_left_thigh_zy * t_left_thigh_18;
  const Scalar M_left_thigh_y_9 = M_left_thigh_y_8 - Omega_left_shank_zy * t_left_shank_6;
  const Scalar M_left_thigh_y_10 = t_left_thigh_3 - t_left_shank_3;
  const Scalar M_left_thigh_y_11 = M_left_thigh_y_9 + t_left_shank_10 * M_left_thigh_y_10;
  const Scalar M_left_thigh_y_12 = neg_Omega_left_thigh_zz - neg_Omega_left_thigh_xx;
  const Scalar M_left_thigh_y_13 = M_left_thigh_y_11 - left_ankle_cross_I11 * t_left_ankle_cross_2;
  const Scalar M_left_thigh_y_14 = M_left_thigh_y_13 + t_left_thigh_12 * M_left_thigh_y_12;
  const Scalar M_left_thigh_y_15 = M_left_thigh_y_14 - Omega_left_shank_zx * t_left_shank_15;
  const Scalar M_left_thigh_y_16 = M_left_thigh_y_15 + a_left_shank_z * t_left_shank_17;
  const Scalar M_left_thigh_y_17 = M_left_thigh_y_16 - neg_s_left_shank_x * neg_F_left_shank_z;
  const Scalar M_left_thigh_y =
      M_left_thigh_y_17 - neg_s_left_ankle_cross_x * neg_F_left_ankle_cross_z;
  // left_hip_fork
  const Scalar t_left_hip_fork_1 = left_hip_fork_I8 * c_left_hip_roll;
  const Scalar t_left_hip_fork_2 = left_hip_fork_I2 * s_left_hip_roll;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 - left_hip_fork_I6 * c_left_hip_roll;
  const Scalar t_left_hip_fork_4 = left_hip_fork_I7 - s_left_hip_roll * t_left_hip_fork_3;
  const Scalar t_left_hip_fork_5 = qd[0] * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_1 - left_hip_fork_I9 * s_left_hip_roll;
  // left_shank: force F of (3)
  const Scalar neg_F_left_thigh_y_1 =
      neg_F_left_shank_y - neg_Omega_left_thigh_yy * t_left_thigh_19;
  const Scalar neg_F_left_thigh_x_1 = neg_F_left_shank_x + Omega_left_thigh_xy * t_left_thigh_19;
  const Scalar neg_F_left_thigh_y = neg_F_left_thigh_y_1 + Omega_left_thigh_yx * t_left_thigh_20;
  const Scalar neg_F_left_thigh_x =
      neg_F_left_thigh_x_1 - neg_Omega_left_thigh_xx * t_left_thigh_20;
  const Scalar t_left_thigh_22 = neg_M_left_thigh_z - s_q2_q3_q4 * neg_F_left_thigh_y;
  const Scalar neg_F_left_thigh_z_1 =
      neg_F_left_shank_z - neg_Omega_left_thigh_zy * t_left_thigh_19;
  const Scalar neg_F_left_thigh_z =
      neg_F_left_thigh_z_1 - neg_Omega_left_thigh_zx * t_left_thigh_20;
  const Scalar t_left_thigh_23 = neg_F_left_thigh_z - s_q2_q3_q4 * M_left_thigh_y;
  const Scalar t_left_hip_fork_7 = qd[1] * t_left_hip_fork_6 + 2.0f * t_left_hip_fork_5;
  // left_thigh: moment M of (3)
  const Scalar t_left_thigh_24 = t_left_thigh_22 + c_q2_q3_q4 * neg_F_left_thigh_x;
  const Scalar t_left_thigh_25 = t_left_thigh_23 + c_q2_q3_q4 * M_left_thigh_x;
  const Scalar t_left_thigh_26 = qd[1] * t_left_hip_fork_7 + s_left_hip_roll * t_left_thigh_24;
  // left_hip_fork: moment M of (3)
  B[0] = -(t_left_thigh_26 + c_left_hip_roll * t_left_thigh_25);
  B[1] = qd[0] * t_left_hip_fork_5 - (s_q2_q3_q4 * M_left_thigh_x + c_q2_q3_q4 * M_left_thigh_y);
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
  const Scalar G_11_1 = c_right_hip_roll * c_q8_q9_q10 * t_right_foot_1;
  G[11] = G_11_1 - s_right_hip_roll * t_right_foot_2;
  // right_ankle_cross: G of 6.5
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_G2 + t_right_foot_2;
  const Scalar G_10_1 = left_ankle_cross_G1 * c_q8_q9_q10 - s_q8_q9_q10 * t_righ_ankl_cros_1;
  const Scalar G_10 = c_right_hip_roll * G_10_1;
  G[10] = G_10;
  const Scalar G_9 = G_10 + c_right_hip_roll * (left_shank_G1 * s_q8_q9 + left_shank_G2 * c_q8_q9);
  G[9] = G_9;
  const Scalar G_8_1 = left_thigh_G1 * s_right_hip_pitch + left_thigh_G2 * c_right_hip_pitch;
  G[8] = G_9 + c_right_hip_roll * G_8_1;
  // right_hip_fork: G of 6.5
  const Scalar neg_G_7_1 = left_hip_fork_G2 - left_ankle_cross_G1 * s_q8_q9_q10;
  const Scalar neg_G_7_2 = neg_G_7_1 - left_shank_G2 * s_q8_q9 + left_shank_G1 * c_q8_q9;
  const Scalar neg_G_7_3 = neg_G_7_2 - left_thigh_G2 * s_right_hip_pitch;
  const Scalar neg_G_7_4 = neg_G_7_3 + left_thigh_G1 * c_right_hip_pitch;
  const Scalar neg_G_7_5 = s_right_hip_roll * (neg_G_7_4 - c_q8_q9_q10 * t_righ_ankl_cros_1);
  G[7] = neg_G_7_5 - c_right_hip_roll * (left_hip_fork_G1 - t_right_foot_1);
  // left_foot: G of 6.5
  const Scalar t_left_foot_1 = left_foot_G1 * s_left_foot;
  const Scalar t_left_foot_2 = left_foot_G1 * c_left_foot;
  G[5] = -(c_left_hip_roll * c_q2_q3_q4 * t_left_foot_1 + s_left_hip_roll * t_left_foot_2);
  // left_ankle_cross: G of 6.5
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_G2 + t_left_foot_2;
  const Scalar neg_G_4_1 = s_q2_q3_q4 * t_left_ankle_cross_1 - left_ankle_cross_G1 * c_q2_q3_q4;
  const Scalar neg_G_4 = c_left_hip_roll * neg_G_4_1;
  G[4] = -neg_G_4;
  const Scalar neg_G_3_1 = left_shank_G2 * c_q2_q3 + left_shank_G1 * s_q2_q3;
  const Scalar neg_G_3 = neg_G_4 - c_left_hip_roll * neg_G_3_1;
  G[3] = -neg_G_3;
  const Scalar neg_G_2_1 = left_thigh_G1 * s_left_hip_pitch + left_thigh_G2 * c_left_hip_pitch;
  G[2] = c_left_hip_roll * neg_G_2_1 - neg_G_3;
  // left_hip_fork: G of 6.5
  const Scalar G_1_1 = left_hip_fork_G2 - left_ankle_cross_G1 * s_q2_q3_q4;
  const Scalar G_1_2 = G_1_1 + left_shank_G1 * c_q2_q3 - left_shank_G2 * s_q2_q3;
  const Scalar G_1_3 = G_1_2 - left_thigh_G2 * s_left_hip_pitch;
  const Scalar G_1_4 = G_1_3 + left_thigh_G1 * c_left_hip_pitch;
  const Scalar G_1_5 = s_left_hip_roll * (G_1_4 - c_q2_q3_q4 * t_left_ankle_cross_1);
  G[1] = G_1_5 + c_left_hip_roll * (left_hip_fork_G1 - t_left_foot_1);
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
  const Scalar Omega_left_hip_fork_zx = t_left_hip_fork_1 + t_left_hip_fork_3;
  const Scalar t_left_hip_fork_4 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_5 = qd[1] * qd[1];
  const Scalar t_left_hip_fork_6 = s_left_hip_roll * qd[0];
  const Scalar t_left_hip_fork_7 = c_left_hip_roll * qdd[0];
  const Scalar Omega_left_hip_fork_zy = t_left_hip_fork_7 - qd[1] * t_left_hip_fork_6 * 2.0f;
  const Scalar t_left_hip_fork_8 = omega_left_hip_fork_x * t_left_hip_fork_6;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_8 + qdd[1];
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_4 + t_left_hip_fork_5;
  // left_thigh: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_left_thigh_1 = s_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar neg_Omega_left_thigh_xz = t_left_thigh_1 - c_left_hip_pitch * t_left_hip_fork_9;
  const Scalar omega_left_thigh_x_1 = c_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_x = omega_left_thigh_x_1 + s_left_hip_pitch * qd[1];
  const Scalar omega_left_thigh_z = t_left_hip_fork_6 + qd[2];
  const Scalar t_left_thigh_2 = 2.0f * omega_left_thigh_z;
  const Scalar Omega_left_thigh_zx = neg_Omega_left_thigh_xz + omega_left_thigh_x * t_left_thigh_2;
  const Scalar t_left_thigh_3 = c_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar neg_Omega_left_thigh_yz = t_left_thigh_3 + s_left_hip_pitch * t_left_hip_fork_9;
  const Scalar t_left_thigh_4 = s_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar neg_omega_left_thigh_y = t_left_thigh_4 - c_left_hip_pitch * qd[1];
  const Scalar Omega_left_thigh_zy =
      neg_Omega_left_thigh_yz - t_left_thigh_2 * neg_omega_left_thigh_y;
  const Scalar t_left_thigh_5 = omega_left_thigh_x * omega_left_thigh_x;
  const Scalar t_left_thigh_6 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_7 = omega_left_thigh_x * neg_omega_left_thigh_y;
  const Scalar alpha_left_thigh_z = t_left_hip_fork_3 + qdd[2];
  const Scalar neg_Omega_left_thigh_xy = t_left_thigh_7 + alpha_left_thigh_z;
  const Scalar neg_Omega_left_thigh_yx = t_left_thigh_7 - alpha_left_thigh_z;
  const Scalar t_left_thigh_8 = t_left_hip_fork_2 + left_hip_fork_p1 * c_left_hip_roll;
  // left_shank: Omega, angular velocity omega of (1)
  const Scalar t_left_shank_1 = c_left_knee * neg_Omega_left_thigh_yz;
  const Scalar neg_Omega_left_shank_yz = t_left_shank_1 - s_left_knee * neg_Omega_left_thigh_xz;
  const Scalar t_left_shank_2 = c_left_knee * neg_omega_left_thigh_y;
  const Scalar neg_omega_left_shank_y = t_left_shank_2 + s_left_knee * omega_left_thigh_x;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_3 = 2.0f * omega_left_shank_z;
  const Scalar Omega_left_shank_zy =
      neg_Omega_left_shank_yz - neg_omega_left_shank_y * t_left_shank_3;
  const Scalar t_left_shank_4 = c_left_knee * neg_Omega_left_thigh_xz;
  const Scalar neg_Omega_left_shank_xz = t_left_shank_4 + s_left_knee * neg_Omega_left_thigh_yz;
  const Scalar t_left_shank_5 = s_left_knee * neg_omega_left_thigh_y;
  const Scalar neg_omega_left_shank_x = t_left_shank_5 - c_left_knee * omega_left_thigh_x;
  const Scalar Omega_left_shank_zx =
      neg_Omega_left_shank_xz - t_left_shank_3 * neg_omega_left_shank_x;
  // left_thigh: acceleration a, Omega of (1)
  const Scalar neg_a_left_thigh_x_1 = s_left_hip_pitch * t_left_hip_block_1;
  const Scalar neg_a_left_thigh_x = neg_a_left_thigh_x_1 + c_left_hip_pitch * t_left_thigh_8;
  const Scalar t_left_thigh_9 = t_left_thigh_5 - t_left_thigh_6;
  const Scalar neg_Omega_left_thigh_xx = t_left_hip_fork_10 - t_left_thigh_9;
  const Scalar t_left_shank_6 = neg_a_left_thigh_x + left_hip_fork_k1 * neg_Omega_left_thigh_xx;
  const Scalar neg_a_left_thigh_y_1 = c_left_hip_pitch * t_left_hip_block_1;
  const Scalar neg_a_left_thigh_y = neg_a_left_thigh_y_1 - s_left_hip_pitch * t_left_thigh_8;
  const Scalar t_left_shank_7 = neg_a_left_thigh_y + left_hip_fork_k1 * neg_Omega_left_thigh_yx;
  const Scalar a_left_thigh_z = t_left_hip_fork_7 - left_hip_fork_p1 * s_left_hip_roll;
  // left_shank: acceleration a, Omega, angular acceleration alpha of (1)
  const Scalar a_left_shank_z = a_left_thigh_z + left_hip_fork_k1 * Omega_left_thigh_zx;
  const Scalar neg_a_left_shank_x = c_left_knee * t_left_shank_6 + s_left_knee * t_left_shank_7;
  const Scalar t_left_shank_8 = neg_omega_left_shank_x * neg_omega_left_shank_x;
  const Scalar t_left_shank_9 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_10 = neg_omega_left_shank_y * neg_omega_left_shank_x;
  const Scalar alpha_left_shank_z = alpha_left_thigh_z + qdd[3];
  const Scalar Omega_left_shank_xy = t_left_shank_10 - alpha_left_shank_z;
  const Scalar Omega_left_shank_yx = t_left_shank_10 + alpha_left_shank_z;
  const Scalar neg_a_left_shank_y = c_left_knee * t_left_shank_7 - s_left_knee * t_left_shank_6;
  const Scalar t_left_ankle_cross_1 = neg_a_left_shank_y - left_hip_fork_k2 * Omega_left_shank_yx;
  const Scalar t_left_shank_11 = t_left_shank_8 - t_left_shank_9;
  const Scalar neg_Omega_left_shank_xx = t_left_hip_fork_10 - t_left_shank_11;
  // left_ankle_cross: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_left_ankle_cross_2 =
      neg_a_left_shank_x + left_hip_fork_k2 * neg_Omega_left_shank_xx;
  const Scalar a_left_ankle_cross_x_1 = c_left_ankle_pitch * t_left_ankle_cross_2;
  const Scalar a_left_ankle_cross_x =
      a_left_ankle_cross_x_1 + s_left_ankle_pitch * t_left_ankle_cross_1;
  const Scalar t_left_ankle_cross_3 = c_left_ankle_pitch * neg_omega_left_shank_y;
  const Scalar omega_left_ankle_cross_y =
      t_left_ankle_cross_3 - s_left_ankle_pitch * neg_omega_left_shank_x;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_4 = 2.0f * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_5 = s_left_ankle_pitch * neg_Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_6 =
      t_left_ankle_cross_5 - c_left_ankle_pitch * neg_Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_7 =
      t_left_ankle_cross_6 + omega_left_ankle_cross_y * t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_8 = c_left_ankle_pitch * neg_Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_9 =
      t_left_ankle_cross_8 + s_left_ankle_pitch * neg_Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_10 = s_left_ankle_pitch * neg_omega_left_shank_y;
  const Scalar omega_left_ankle_cross_x =
      t_left_ankle_cross_10 + c_left_ankle_pitch * neg_omega_left_shank_x;
  const Scalar t_left_ankle_cross_11 =
      t_left_ankle_cross_9 - t_left_ankle_cross_4 * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_12 = omega_left_ankle_cross_x * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_13 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_14 = t_left_ankle_cross_12 - t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_15 = omega_left_ankle_cross_y * omega_left_ankle_cross_x;
  const Scalar alpha_left_ankle_cross_z = alpha_left_shank_z + qdd[4];
  const Scalar t_left_ankle_cross_16 = t_left_ankle_cross_15 - alpha_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_15 + alpha_left_ankle_cross_z;
  const Scalar neg_omega_left_foot_z = omega_left_ankle_cross_y - qd[5];
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_6 + t_left_ankle_cross_4 * qd[5];
  const Scalar a_left_ankle_cross_z = a_left_shank_z + left_hip_fork_k2 * Omega_left_shank_zx;
  const Scalar neg_a_left_foot_y_1 = t_left_ankle_cross_11 - a_left_ankle_cross_z;
  const Scalar neg_a_left_foot_y = neg_a_left_foot_y_1 - left_hip_fork_k3 * t_left_hip_fork_10;
  const Scalar t_left_ankle_cross_18 = s_left_ankle_pitch * t_left_ankle_cross_2;
  const Scalar neg_a_left_ankle_cross_y =
      t_left_ankle_cross_18 - c_left_ankle_pitch * t_left_ankle_cross_1;
  const Scalar neg_a_left_foot_z_1 = t_left_ankle_cross_17 - neg_a_left_ankle_cross_y;
  const Scalar neg_a_left_foot_z = neg_a_left_foot_z_1 + left_hip_fork_k3 * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_19 = t_left_hip_fork_10 - t_left_ankle_cross_14;
  // left_foot: acceleration a, Omega, moment M of (1)
  const Scalar a_left_foot_x_1 = a_left_ankle_cross_x - t_left_ankle_cross_19;
  const Scalar a_left_foot_x = a_left_foot_x_1 - left_hip_fork_k3 * t_left_ankle_cross_9;
  const Scalar Omega_left_foot_xy = t_left_ankle_cross_9 - qdd[5];
  const Scalar Omega_left_foot_zx_1 = omega_left_ankle_cross_x * neg_omega_left_foot_z;
  const Scalar Omega_left_foot_zx = t_left_ankle_cross_16 - 2.0f * Omega_left_foot_zx_1;
  const Scalar t_left_foot_1 = neg_omega_left_foot_z * neg_omega_left_foot_z;
  const Scalar t_left_foot_2 = left_foot_I5 * c_left_foot - left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_3 = s_left_foot * t_left_foot_2;
  const Scalar t_left_foot_4 = left_foot_I14 + t_left_foot_3;
  const Scalar t_left_foot_5 = left_foot_I2 * s_left_foot - left_foot_I3 * c_left_foot;
  const Scalar t_left_foot_6 = left_foot_I3 * s_left_foot + left_foot_I2 * c_left_foot;
  const Scalar t_left_foot_7 = left_foot_I13 - c_left_foot * t_left_foot_2;
  const Scalar t_left_foot_8 = left_foot_I1 * c_left_foot;
  const Scalar t_left_foot_9 = left_foot_I1 * s_left_foot;
  const Scalar neg_Omega_left_foot_yx = t_left_ankle_cross_11 - qdd[5];
  const Scalar t_left_foot_10 = left_foot_I12 - t_left_foot_3;
  const Scalar neg_M_left_foot_z_1 = t_left_foot_4 * neg_Omega_left_foot_yx;
  const Scalar neg_M_left_foot_z_2 = neg_M_left_foot_z_1 + a_left_foot_x * t_left_foot_9;
  const Scalar neg_M_left_foot_z_3 = neg_M_left_foot_z_2 + Omega_left_foot_xy * t_left_foot_10;
  const Scalar neg_M_left_foot_z_4 = neg_M_left_foot_z_3 + neg_a_left_foot_y * t_left_foot_8;
  const Scalar neg_M_left_foot_z_5 = neg_M_left_foot_z_4 - t_left_ankle_cross_7 * t_left_foot_5;
  const Scalar neg_M_left_foot_z_6 = neg_M_left_foot_z_5 - t_left_ankle_cross_16 * t_left_foot_6;
  const Scalar neg_M_left_foot_z = neg_M_left_foot_z_6 + t_left_ankle_cross_14 * t_left_foot_7;
  tau[5] = -neg_M_left_foot_z;
  const Scalar F_left_foot_z_1 = Omega_left_foot_zy * t_left_foot_9;
  const Scalar F_left_foot_z_2 = F_left_foot_z_1 + Omega_left_foot_zx * t_left_foot_8;
  const Scalar F_left_foot_z = F_left_foot_z_2 - left_ankle_cross_I1 * neg_a_left_foot_z;
  const Scalar t_right_hip_block_1 = qd[6] * qd[6];
  // right_hip_fork: angular velocity omega, angular acceleration alpha, Omega of (1)
  const Scalar omega_right_hip_fork_x = c_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_1 = omega_right_hip_fork_x * qd[7];
  const Scalar t_right_hip_fork_2 = s_right_hip_roll * qdd[6];
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_1 + t_right_hip_fork_2;
  const Scalar Omega_right_hip_fork_zx = t_right_hip_fork_1 + t_right_hip_fork_3;
  const Scalar t_right_hip_fork_4 = s_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_5 = c_right_hip_roll * qdd[6];
  const Scalar Omega_right_hip_fork_zy = t_right_hip_fork_5 - qd[7] * t_right_hip_fork_4 * 2.0f;
  const Scalar t_right_hip_fork_6 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_7 = qd[7] * qd[7];
  const Scalar t_right_hip_fork_8 = omega_right_hip_fork_x * t_right_hip_fork_4;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_8 + qdd[7];
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_6 + t_right_hip_fork_7;
  // right_thigh: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_right_thigh_1 = s_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar neg_Omega_right_thigh_xz = t_right_thigh_1 - c_right_hip_pitch * t_right_hip_fork_9;
  const Scalar omega_right_thigh_x_1 = c_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar omega_right_thigh_x = omega_right_thigh_x_1 + s_right_hip_pitch * qd[7];
  const Scalar omega_right_thigh_z = t_right_hip_fork_4 + qd[8];
  const Scalar t_right_thigh_2 = 2.0f * omega_right_thigh_z;
  const Scalar Omega_right_thigh_zx =
      neg_Omega_right_thigh_xz + omega_right_thigh_x * t_right_thigh_2;
  const Scalar t_right_thigh_3 = c_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar neg_Omega_right_thigh_yz = t_right_thigh_3 + s_right_hip_pitch * t_right_hip_fork_9;
  const Scalar t_right_thigh_4 = s_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar neg_omega_right_thigh_y = t_right_thigh_4 - c_right_hip_pitch * qd[7];
  const Scalar Omega_right_thigh_zy =
      neg_Omega_right_thigh_yz - t_right_thigh_2 * neg_omega_right_thigh_y;
  const Scalar t_right_thigh_5 = omega_right_thigh_x * omega_right_thigh_x;
  const Scalar t_right_thigh_6 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_7 = omega_right_thigh_x * neg_omega_right_thigh_y;
  const Scalar alpha_right_thigh_z = t_right_hip_fork_3 + qdd[8];
  const Scalar neg_Omega_right_thigh_yx = t_right_thigh_7 - alpha_right_thigh_z;
  const Scalar neg_Omega_right_thigh_xy = t_right_thigh_7 + alpha_right_thigh_z;
  const Scalar t_right_thigh_8 = t_right_hip_fork_2 + left_hip_fork_p1 * c_right_hip_roll;
  const Scalar t_right_thigh_9 = t_right_thigh_5 - t_right_thigh_6;
  const Scalar neg_a_right_thigh_x_1 = s_right_hip_pitch * t_right_hip_block_1;
  const Scalar neg_a_right_thigh_x = neg_a_right_thigh_x_1 + c_right_hip_pitch * t_right_thigh_8;
  const Scalar neg_Omega_right_thigh_xx = t_right_hip_fork_10 - t_right_thigh_9;
  // right_shank: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_right_shank_1 = neg_a_right_thigh_x + left_hip_fork_k1 * neg_Omega_right_thigh_xx;
  const Scalar t_right_shank_2 = left_hip_fork_k1 * neg_Omega_right_thigh_yx;
  const Scalar t_right_shank_3 = c_right_hip_pitch * t_right_hip_block_1 + t_right_shank_2;
  const Scalar t_right_shank_4 = t_right_shank_3 - s_right_hip_pitch * t_right_thigh_8;
  const Scalar t_right_shank_5 = c_right_knee * neg_Omega_right_thigh_yz;
  const Scalar neg_Omega_right_shank_yz = t_right_shank_5 - s_right_knee * neg_Omega_right_thigh_xz;
  const Scalar t_right_shank_6 = c_right_knee * neg_omega_right_thigh_y;
  const Scalar neg_omega_right_shank_y = s_right_knee * omega_right_thigh_x + t_right_shank_6;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar t_right_shank_7 = 2.0f * omega_right_shank_z;
  const Scalar Omega_right_shank_zy =
      neg_Omega_right_shank_yz - neg_omega_right_shank_y * t_right_shank_7;
  const Scalar t_right_shank_8 = s_right_knee * neg_Omega_right_thigh_yz;
  const Scalar neg_Omega_right_shank_xz = t_right_shank_8 + c_right_knee * neg_Omega_right_thigh_xz;
  const Scalar omega_right_shank_x_1 = s_right_knee * neg_omega_right_thigh_y;
  const Scalar omega_right_shank_x = c_right_knee * omega_right_thigh_x - omega_right_shank_x_1;
  const Scalar Omega_right_shank_zx =
      neg_Omega_right_shank_xz + t_right_shank_7 * omega_right_shank_x;
  const Scalar a_right_thigh_z = t_right_hip_fork_5 - left_hip_fork_p1 * s_right_hip_roll;
  const Scalar a_right_shank_z = a_right_thigh_z + left_hip_fork_k1 * Omega_right_thigh_zx;
  const Scalar t_right_shank_9 = omega_right_shank_x * omega_right_shank_x;
  const Scalar t_right_shank_10 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_11 = neg_omega_right_shank_y * omega_right_shank_x;
  const Scalar alpha_right_shank_z = alpha_right_thigh_z + qdd[9];
  const Scalar neg_Omega_right_shank_xy = t_right_shank_11 + alpha_right_shank_z;
  const Scalar neg_Omega_right_shank_yx = t_right_shank_11 - alpha_right_shank_z;
  const Scalar t_right_shank_12 = t_right_shank_9 - t_right_shank_10;
  const Scalar neg_a_right_shank_x_1 = c_right_knee * t_right_shank_1;
  const Scalar neg_a_right_shank_x = neg_a_right_shank_x_1 + s_right_knee * t_right_shank_4;
  const Scalar neg_Omega_right_shank_xx = t_right_hip_fork_10 - t_right_shank_12;
  const Scalar t_righ_ankl_cros_1 =
      neg_a_right_shank_x + left_hip_fork_k2 * neg_Omega_right_shank_xx;
  const Scalar a_right_shank_y_1 = s_right_knee * t_right_shank_1;
  const Scalar a_right_shank_y = a_right_shank_y_1 - c_right_knee * t_right_shank_4;
  // right_ankle_cross: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_righ_ankl_cros_2 = a_right_shank_y - left_hip_fork_k2 * neg_Omega_right_shank_yx;
  const Scalar a_righ_ankl_cros_x_1 = c_right_ankle_pitch * t_righ_ankl_cros_1;
  const Scalar a_righ_ankl_cros_x = a_righ_ankl_cros_x_1 - s_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_3 = s_right_ankle_pitch * neg_Omega_right_shank_yz;
  const Scalar Omega_righ_ankl_cros_xz =
      t_righ_ankl_cros_3 + c_right_ankle_pitch * neg_Omega_right_shank_xz;
  const Scalar t_righ_ankl_cros_4 = s_right_ankle_pitch * neg_omega_right_shank_y;
  const Scalar t_righ_ankl_cros_5 = c_right_ankle_pitch * omega_right_shank_x - t_righ_ankl_cros_4;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_6 = 2.0f * t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_7 = omega_righ_ankl_cros_z * t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_8 = Omega_righ_ankl_cros_xz + t_righ_ankl_cros_7;
  const Scalar a_righ_ankl_cros_z = a_right_shank_z + left_hip_fork_k2 * Omega_right_shank_zx;
  const Scalar t_righ_ankl_cros_9 = s_right_ankle_pitch * neg_Omega_right_shank_xz;
  const Scalar t_righ_ankl_cros_10 =
      t_righ_ankl_cros_9 - c_right_ankle_pitch * neg_Omega_right_shank_yz;
  const Scalar t_righ_ankl_cros_11 = c_right_ankle_pitch * neg_omega_right_shank_y;
  const Scalar omega_righ_ankl_cros_y =
      t_righ_ankl_cros_11 + s_right_ankle_pitch * omega_right_shank_x;
  const Scalar t_righ_ankl_cros_12 = 2.0f * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_zy =
      t_righ_ankl_cros_10 + omega_righ_ankl_cros_y * t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_13 = t_righ_ankl_cros_5 * t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_14 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_13 - t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_16 = t_righ_ankl_cros_5 * omega_righ_ankl_cros_y;
  const Scalar alpha_righ_ankl_cros_z = alpha_right_shank_z + qdd[10];
  // right_foot: Omega, angular velocity omega, acceleration a of (1)
  const Scalar Omega_right_foot_xz = t_righ_ankl_cros_16 + alpha_righ_ankl_cros_z;
  const Scalar neg_omega_right_foot_z = omega_righ_ankl_cros_y - qd[11];
  const Scalar Omega_right_foot_zy =
      Omega_righ_ankl_cros_zy - t_righ_ankl_cros_12 * neg_omega_right_foot_z;
  const Scalar neg_a_right_foot_y_1 = t_righ_ankl_cros_8 - a_righ_ankl_cros_z;
  const Scalar neg_a_right_foot_y = neg_a_right_foot_y_1 + left_hip_fork_k3 * t_right_hip_fork_10;
  // right_ankle_cross: Omega, acceleration a of (1)
  const Scalar t_righ_ankl_cros_17 = t_righ_ankl_cros_16 - alpha_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_18 = c_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar neg_a_righ_ankl_cros_y =
      t_righ_ankl_cros_18 + s_right_ankle_pitch * t_righ_ankl_cros_1;
  const Scalar a_right_foot_z_1 = t_righ_ankl_cros_17 + neg_a_righ_ankl_cros_y;
  const Scalar a_right_foot_z = a_right_foot_z_1 + left_hip_fork_k3 * t_righ_ankl_cros_10;
  const Scalar t_righ_ankl_cros_19 = t_right_hip_fork_10 - t_righ_ankl_cros_15;
  // right_foot: acceleration a, Omega, moment M of (1)
  const Scalar a_right_foot_x_1 = a_righ_ankl_cros_x - t_righ_ankl_cros_19;
  const Scalar a_right_foot_x = a_right_foot_x_1 + left_hip_fork_k3 * Omega_righ_ankl_cros_xz;
  const Scalar Omega_right_foot_xy = Omega_righ_ankl_cros_xz - qdd[11];
  const Scalar neg_Omega_right_foot_yx = t_righ_ankl_cros_7 + Omega_right_foot_xy;
  const Scalar t_right_foot_1 = neg_omega_right_foot_z * neg_omega_right_foot_z;
  const Scalar neg_Omega_right_foot_zx =
      Omega_right_foot_xz - t_righ_ankl_cros_6 * neg_omega_right_foot_z;
  const Scalar t_right_foot_2 = left_foot_I4 * s_right_foot - left_foot_I5 * c_right_foot;
  const Scalar t_right_foot_3 = s_right_foot * t_right_foot_2;
  const Scalar t_right_foot_4 = left_foot_I12 + t_right_foot_3;
  const Scalar t_right_foot_5 = left_foot_I13 + c_right_foot * t_right_foot_2;
  const Scalar t_right_foot_6 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_7 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_8 = left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_9 = left_foot_I14 - t_right_foot_3;
  const Scalar t_right_foot_10 = left_foot_I1 * c_right_foot;
  const Scalar M_right_foot_z_1 = neg_Omega_right_foot_yx * t_right_foot_9;
  const Scalar M_right_foot_z_2 = Omega_right_foot_xz * t_right_foot_7 - M_right_foot_z_1;
  const Scalar M_right_foot_z_3 = M_right_foot_z_2 + a_right_foot_x * t_right_foot_8;
  const Scalar M_right_foot_z_4 = M_right_foot_z_3 - Omega_right_foot_xy * t_right_foot_4;
  const Scalar M_right_foot_z_5 = M_right_foot_z_4 - neg_a_right_foot_y * t_right_foot_10;
  const Scalar M_right_foot_z_6 = M_right_foot_z_5 + t_righ_ankl_cros_15 * t_right_foot_5;
  const Scalar M_right_foot_z = M_right_foot_z_6 + Omega_righ_ankl_cros_zy * t_right_foot_6;
  tau[11] = M_right_foot_z;
  const Scalar neg_F_right_foot_z_1 = Omega_right_foot_zy * t_right_foot_8;
  const Scalar neg_F_right_foot_z_2 = neg_F_right_foot_z_1 - left_ankle_cross_I1 * a_right_foot_z;
  const Scalar neg_F_right_foot_z =
      neg_F_right_foot_z_2 + neg_Omega_right_foot_zx * t_right_foot_10;
  const Scalar neg_F_right_foot_x_1 = Omega_right_foot_xy * t_right_foot_8;
  const Scalar neg_Omega_right_foot_xx = t_righ_ankl_cros_14 + t_right_foot_1;
  const Scalar neg_F_right_foot_x_2 = neg_F_right_foot_x_1 - left_ankle_cross_I1 * a_right_foot_x;
  const Scalar neg_F_right_foot_x =
      neg_F_right_foot_x_2 + t_right_foot_10 * neg_Omega_right_foot_xx;
  const Scalar t_righ_ankl_cros_20 = t_righ_ankl_cros_13 + t_righ_ankl_cros_14;
  const Scalar M_righ_ankl_cros_x_1 = left_ankle_cross_I10 * t_righ_ankl_cros_17;
  const Scalar M_righ_ankl_cros_x_2 = t_righ_ankl_cros_14 - t_right_foot_1;
  // right_ankle_cross: moment M, force F of (1)
  const Scalar M_righ_ankl_cros_x_3 = M_righ_ankl_cros_x_1 - left_hip_fork_k3 * neg_F_right_foot_z;
  const Scalar M_righ_ankl_cros_x_4 = t_right_hip_fork_10 - t_righ_ankl_cros_20;
  const Scalar M_righ_ankl_cros_x_5 = M_righ_ankl_cros_x_3 + t_right_foot_7 * M_righ_ankl_cros_x_2;
  const Scalar M_righ_ankl_cros_x_6 =
      M_righ_ankl_cros_x_5 + left_ankle_cross_I2 * M_righ_ankl_cros_x_4;
  const Scalar M_righ_ankl_cros_x_7 =
      M_righ_ankl_cros_x_6 + left_ankle_cross_I8 * t_righ_ankl_cros_8;
  const Scalar M_righ_ankl_cros_x_8 =
      M_righ_ankl_cros_x_7 - left_ankle_cross_I3 * a_righ_ankl_cros_z;
  const Scalar M_righ_ankl_cros_x_9 =
      M_righ_ankl_cros_x_8 + left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar M_righ_ankl_cros_x_10 = M_righ_ankl_cros_x_9 + Omega_right_foot_zy * t_right_foot_4;
  const Scalar M_righ_ankl_cros_x_11 = M_righ_ankl_cros_x_10 - a_right_foot_z * t_right_foot_8;
  const Scalar M_righ_ankl_cros_x_12 =
      M_righ_ankl_cros_x_11 - neg_Omega_right_foot_yx * t_right_foot_6;
  const Scalar M_righ_ankl_cros_x =
      M_righ_ankl_cros_x_12 + neg_Omega_right_foot_zx * t_right_foot_5;
  const Scalar M_righ_ankl_cros_z_1 = neg_F_right_foot_z + left_ankle_cross_I3 * a_righ_ankl_cros_x;
  const Scalar M_righ_ankl_cros_z_2 = t_righ_ankl_cros_19 - t_righ_ankl_cros_20;
  const Scalar M_righ_ankl_cros_z_3 = M_righ_ankl_cros_z_1 - Omega_right_foot_xy * t_right_foot_7;
  const Scalar M_righ_ankl_cros_z_4 =
      M_righ_ankl_cros_z_3 - left_ankle_cross_I8 * M_righ_ankl_cros_z_2;
  const Scalar M_righ_ankl_cros_z_5 =
      M_righ_ankl_cros_z_4 + left_ankle_cross_I12 * t_righ_ankl_cros_16;
  const Scalar M_righ_ankl_cros_z_6 =
      M_righ_ankl_cros_z_5 - left_ankle_cross_I10 * t_righ_ankl_cros_10;
  const Scalar M_righ_ankl_cros_z_7 = M_righ_ankl_cros_z_6 + Omega_right_foot_zy * t_right_foot_5;
  const Scalar M_righ_ankl_cros_z_8 =
      M_righ_ankl_cros_z_7 + left_ankle_cross_I13 * alpha_righ_ankl_cros_z;
  const Scalar M_righ_ankl_cros_z_9 = t_righ_ankl_cros_13 - t_right_foot_1;
  const Scalar M_righ_ankl_cros_z_10 =
      M_righ_ankl_cros_z_8 + left_ankle_cross_I2 * Omega_righ_ankl_cros_xz;
  const Scalar M_righ_ankl_cros_z_11 =
      M_righ_ankl_cros_z_10 - t_right_foot_6 * M_righ_ankl_cros_z_9;
  const Scalar M_righ_ankl_cros_z_12 = M_righ_ankl_cros_z_11 - a_right_foot_z * t_right_foot_10;
  const Scalar M_righ_ankl_cros_z =
      M_righ_ankl_cros_z_12 + neg_Omega_right_foot_zx * t_right_foot_9;
  tau[10] = M_righ_ankl_cros_z;
  const Scalar F_righ_ankl_cros_y_1 =
      neg_F_right_foot_z + left_ankle_cross_I3 * t_righ_ankl_cros_20;
  const Scalar F_righ_ankl_cros_y = F_righ_ankl_cros_y_1 - left_shank_I15 * neg_a_righ_ankl_cros_y;
  // right_foot: force F, Omega, moment M of (1)
  const Scalar t_right_foot_11 = neg_F_right_foot_x - left_ankle_cross_I3 * Omega_right_foot_xz;
  const Scalar neg_F_righ_ankl_cros_x = t_right_foot_11 - left_shank_I15 * a_righ_ankl_cros_x;
  const Scalar neg_Omega_right_foot_yy = t_righ_ankl_cros_13 + t_right_foot_1;
  const Scalar neg_F_right_foot_y_1 = t_right_foot_8 * neg_Omega_right_foot_yy;
  const Scalar neg_F_right_foot_y_2 =
      left_ankle_cross_I1 * neg_a_right_foot_y - neg_F_right_foot_y_1;
  const Scalar neg_F_right_foot_y =
      neg_F_right_foot_y_2 + neg_Omega_right_foot_yx * t_right_foot_10;
  const Scalar t_right_foot_12 = M_right_foot_z - neg_F_right_foot_y;
  const Scalar t_right_foot_13 = t_right_foot_12 + left_hip_fork_k3 * neg_F_right_foot_x;
  const Scalar t_right_foot_14 = t_right_foot_13 - left_ankle_cross_I11 * t_righ_ankl_cros_8;
  const Scalar t_right_foot_15 = t_right_foot_14 - left_ankle_cross_I2 * Omega_right_foot_xz;
  const Scalar t_right_foot_16 = t_right_foot_15 - left_ankle_cross_I10 * t_righ_ankl_cros_15;
  const Scalar neg_M_righ_ankl_cros_y =
      t_right_foot_16 - left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar neg_Omega_right_shank_yy = t_right_shank_9 + t_right_shank_10;
  const Scalar t_right_shank_13 = t_right_hip_fork_10 - neg_Omega_right_shank_yy;
  // right_ankle_cross: moment M, force F of (1)
  const Scalar neg_M_right_shank_x_1 = c_right_ankle_pitch * M_righ_ankl_cros_x;
  const Scalar neg_M_right_shank_x_2 =
      neg_M_right_shank_x_1 - left_shank_I10 * Omega_right_shank_zy;
  const Scalar neg_M_right_shank_x_3 =
      neg_M_right_shank_x_2 + s_right_ankle_pitch * neg_M_righ_ankl_cros_y;
  const Scalar neg_M_right_shank_x_4 = neg_M_right_shank_x_3 - left_shank_I2 * a_right_shank_z;
  const Scalar neg_M_right_shank_x_5 = neg_M_right_shank_x_4 + left_shank_I6 * t_right_shank_13;
  const Scalar neg_M_right_shank_x_6 =
      neg_M_right_shank_x_5 - left_shank_I11 * neg_Omega_right_shank_yx;
  const Scalar neg_M_right_shank_x = neg_M_right_shank_x_6 + left_shank_I9 * Omega_right_shank_zx;
  const Scalar t_righ_ankl_cros_21 = s_right_ankle_pitch * neg_F_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_22 = c_right_ankle_pitch * F_righ_ankl_cros_y - t_righ_ankl_cros_21;
  // right_shank: moment M of (1)
  const Scalar M_right_shank_z_1 = t_right_shank_12 - t_right_shank_13;
  const Scalar M_right_shank_z_2 = M_righ_ankl_cros_z + left_shank_I9 * M_right_shank_z_1;
  const Scalar M_right_shank_z_3 = M_right_shank_z_2 - left_shank_I11 * neg_Omega_right_shank_yz;
  const Scalar M_right_shank_z_4 = M_right_shank_z_3 + left_shank_I2 * neg_a_right_shank_x;
  const Scalar M_right_shank_z_5 = M_right_shank_z_4 + left_shank_I6 * neg_Omega_right_shank_xz;
  const Scalar M_right_shank_z_6 = M_right_shank_z_5 + left_shank_I10 * neg_Omega_right_shank_xy;
  const Scalar M_right_shank_z_7 = M_right_shank_z_6 + left_shank_I14 * neg_Omega_right_shank_yx;
  const Scalar M_right_shank_z = M_right_shank_z_7 - left_hip_fork_k2 * t_righ_ankl_cros_22;
  tau[9] = M_right_shank_z;
  const Scalar neg_F_right_shank_y_1 =
      t_righ_ankl_cros_22 + left_shank_I2 * neg_Omega_right_shank_yy;
  const Scalar neg_F_right_shank_y = neg_F_right_shank_y_1 - left_thigh_I15 * a_right_shank_y;
  const Scalar t_right_foot_17 = neg_F_right_foot_y - left_shank_I15 * a_righ_ankl_cros_z;
  const Scalar neg_F_righ_ankl_cros_z =
      t_right_foot_17 + left_ankle_cross_I3 * Omega_righ_ankl_cros_zy;
  // right_ankle_cross: moment M, force F of (1)
  const Scalar neg_M_right_shank_y_1 = left_hip_fork_k2 * neg_F_righ_ankl_cros_z;
  const Scalar neg_M_right_shank_y_2 =
      s_right_ankle_pitch * M_righ_ankl_cros_x - neg_M_right_shank_y_1;
  const Scalar neg_M_right_shank_y_3 =
      neg_M_right_shank_y_2 - c_right_ankle_pitch * neg_M_righ_ankl_cros_y;
  const Scalar neg_M_right_shank_y_4 =
      neg_M_right_shank_y_3 + left_shank_I6 * neg_Omega_right_shank_xy;
  const Scalar neg_M_right_shank_y_5 = neg_M_right_shank_y_4 - left_shank_I9 * Omega_right_shank_zy;
  const Scalar neg_M_right_shank_y_6 =
      neg_M_right_shank_y_5 - left_shank_I14 * Omega_right_shank_zx;
  const Scalar neg_M_right_shank_y = neg_M_right_shank_y_6 - left_shank_I11 * t_right_shank_12;
  const Scalar neg_Omega_right_thigh_yy = t_right_thigh_5 + t_right_thigh_6;
  const Scalar neg_F_right_shank_x_1 = left_shank_I2 * neg_Omega_right_shank_xy;
  const Scalar neg_F_right_shank_x_2 =
      neg_F_right_shank_x_1 - s_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar neg_F_right_shank_x_3 =
      neg_F_right_shank_x_2 - c_right_ankle_pitch * neg_F_righ_ankl_cros_x;
  const Scalar neg_F_right_shank_x = neg_F_right_shank_x_3 + left_thigh_I15 * neg_a_right_shank_x;
  const Scalar t_right_shank_14 = c_right_knee * neg_F_right_shank_y;
  const Scalar t_right_shank_15 = t_right_shank_14 + s_right_knee * neg_F_right_shank_x;
  // right_thigh: moment M of (1)
  const Scalar M_right_thigh_z_1 = M_right_shank_z + left_thigh_I16 * t_right_thigh_7;
  const Scalar M_right_thigh_z_2 = M_right_thigh_z_1 + left_thigh_I6 * neg_Omega_right_thigh_xz;
  const Scalar M_right_thigh_z_3 = neg_Omega_right_thigh_xx - neg_Omega_right_thigh_yy;
  const Scalar M_right_thigh_z_4 = M_right_thigh_z_2 - left_thigh_I8 * neg_Omega_right_thigh_yz;
  const Scalar M_right_thigh_z_5 = M_right_thigh_z_4 + left_thigh_I12 * M_right_thigh_z_3;
  const Scalar M_right_thigh_z_6 = M_right_thigh_z_5 + left_thigh_I2 * neg_a_right_thigh_x;
  const Scalar M_right_thigh_z_7 = M_right_thigh_z_6 + left_thigh_I17 * alpha_right_thigh_z;
  const Scalar M_right_thigh_z = M_right_thigh_z_7 - left_hip_fork_k1 * t_right_shank_15;
  tau[8] = M_right_thigh_z;
  const Scalar M_right_hip_fork_z_1 = left_hip_fork_G2 + left_hip_fork_I8 * qdd[6];
  const Scalar M_right_thigh_x_1 = s_right_knee * neg_M_right_shank_y;
  const Scalar M_right_thigh_x_2 = t_right_hip_fork_10 - neg_Omega_right_thigh_yy;
  const Scalar M_right_thigh_x_3 = left_thigh_I2 * a_right_thigh_z + M_right_thigh_x_1;
  const Scalar M_right_thigh_x_4 = M_right_thigh_x_3 - left_thigh_I6 * M_right_thigh_x_2;
  const Scalar M_right_thigh_x_5 = M_right_thigh_x_4 + left_thigh_I8 * neg_Omega_right_thigh_yx;
  const Scalar M_right_thigh_x_6 = M_right_thigh_x_5 - c_right_knee * neg_M_right_shank_x;
  const Scalar M_right_thigh_x_7 = M_right_thigh_x_6 + left_thigh_I11 * Omega_right_thigh_zy;
  const Scalar M_right_thigh_x = M_right_thigh_x_7 + left_thigh_I12 * Omega_right_thigh_zx;
  const Scalar M_right_hip_fork_z_2 = left_hip_fork_G3 + left_hip_fork_I9 * qdd[6];
  const Scalar t_right_hip_fork_11 = t_right_hip_fork_8 - qdd[7];
  const Scalar neg_F_right_shank_z_1 = neg_F_righ_ankl_cros_z - left_thigh_I15 * a_right_shank_z;
  const Scalar neg_F_right_shank_z = neg_F_right_shank_z_1 - left_shank_I2 * Omega_right_shank_zy;
  const Scalar M_right_thigh_y_1 = left_hip_fork_k1 * neg_F_right_shank_z;
  const Scalar M_right_thigh_y_2 = M_right_thigh_y_1 + left_thigh_I8 * t_right_thigh_9;
  const Scalar M_right_thigh_y_3 = M_right_thigh_y_2 - left_thigh_I12 * Omega_right_thigh_zy;
  const Scalar M_right_thigh_y_4 = M_right_thigh_y_3 - left_thigh_I6 * neg_Omega_right_thigh_xy;
  const Scalar M_right_thigh_y_5 = M_right_thigh_y_4 - c_right_knee * neg_M_right_shank_y;
  const Scalar M_right_thigh_y_6 = M_right_thigh_y_5 - s_right_knee * neg_M_right_shank_x;
  const Scalar M_right_thigh_y = M_right_thigh_y_6 - left_thigh_I14 * Omega_right_thigh_zx;
  // right_hip_fork: moment M of (1)
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_6 - t_right_hip_fork_7;
  const Scalar t_right_hip_fork_13 = t_right_hip_block_1 - t_right_hip_fork_10;
  const Scalar M_right_hip_fork_z_3 = s_right_hip_roll * M_right_hip_fork_z_1;
  const Scalar M_right_hip_fork_z_4 = M_right_hip_fork_z_3 + s_right_hip_pitch * M_right_thigh_x;
  const Scalar M_right_hip_fork_z_5 =
      M_right_hip_fork_z_4 - c_right_hip_roll * M_right_hip_fork_z_2;
  const Scalar M_right_hip_fork_z_6 = M_right_hip_fork_z_5 + left_hip_fork_I11 * t_right_hip_fork_9;
  const Scalar M_right_hip_fork_z_7 =
      M_right_hip_fork_z_6 - left_hip_fork_I10 * t_right_hip_fork_11;
  const Scalar M_right_hip_fork_z_8 = t_right_hip_fork_12 - t_right_hip_fork_13;
  const Scalar M_right_hip_fork_z_9 = M_right_hip_fork_z_7 + c_right_hip_pitch * M_right_thigh_y;
  tau[7] = M_right_hip_fork_z_9 - left_hip_fork_I7 * M_right_hip_fork_z_8;
  const Scalar neg_F_right_thigh_x_1 = left_thigh_I2 * neg_Omega_right_thigh_xy;
  const Scalar neg_F_right_thigh_x_2 = neg_F_right_thigh_x_1 - s_right_knee * neg_F_right_shank_y;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_10 = M_right_thigh_z + left_hip_fork_I10 * Omega_right_hip_fork_zx;
  const Scalar t_right_thigh_11 = t_right_thigh_10 + left_hip_fork_I7 * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_12 = t_right_thigh_11 + left_hip_fork_I8 * t_right_hip_fork_9;
  const Scalar neg_F_right_thigh_x = neg_F_right_thigh_x_2 + c_right_knee * neg_F_right_shank_x;
  const Scalar t_right_thigh_13 = t_right_thigh_12 - left_hip_fork_I9 * t_right_hip_fork_12;
  const Scalar neg_F_right_thigh_y = t_right_shank_15 + left_thigh_I2 * neg_Omega_right_thigh_yy;
  const Scalar t_right_thigh_14 = t_right_thigh_13 + c_right_hip_pitch * neg_F_right_thigh_x;
  const Scalar t_right_thigh_15 = neg_F_right_shank_z + s_right_hip_pitch * M_right_thigh_y;
  const Scalar t_right_thigh_16 = t_right_thigh_15 + left_hip_fork_I8 * t_right_hip_fork_13;
  const Scalar t_right_thigh_17 = t_right_thigh_16 - left_hip_fork_I11 * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_18 = t_right_thigh_17 - c_right_hip_pitch * M_right_thigh_x;
  const Scalar t_right_thigh_19 = t_right_thigh_18 - left_thigh_I2 * Omega_right_thigh_zy;
  const Scalar t_right_thigh_20 = t_right_thigh_19 - left_hip_fork_I9 * t_right_hip_fork_11;
  const Scalar neg_M_right_hip_fork_y = t_right_thigh_14 - s_right_hip_pitch * neg_F_right_thigh_y;
  const Scalar M_right_hip_block_z_1 = s_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar neg_M_right_hip_fork_x =
      t_right_thigh_20 - left_hip_fork_I7 * Omega_right_hip_fork_zx;
  const Scalar M_right_hip_block_z_2 = left_hip_block_I2 * qdd[6] + M_right_hip_block_z_1;
  tau[6] = M_right_hip_block_z_2 - c_right_hip_roll * neg_M_right_hip_fork_x;
  // left_foot: force F of (1)
  const Scalar neg_F_left_foot_x_1 = t_left_foot_8 * (t_left_ankle_cross_13 + t_left_foot_1);
  const Scalar neg_F_left_foot_x_2 = neg_F_left_foot_x_1 - Omega_left_foot_xy * t_left_foot_9;
  const Scalar neg_F_left_foot_x = neg_F_left_foot_x_2 - left_ankle_cross_I1 * a_left_foot_x;
  const Scalar neg_F_left_foot_y_1 = t_left_foot_9 * (t_left_ankle_cross_12 + t_left_foot_1);
  const Scalar neg_F_left_foot_y_2 = neg_F_left_foot_y_1 + t_left_foot_8 * neg_Omega_left_foot_yx;
  const Scalar neg_F_left_foot_y = neg_F_left_foot_y_2 + left_ankle_cross_I1 * neg_a_left_foot_y;
  // left_ankle_cross: moment M, Omega of (1)
  const Scalar M_left_ankle_cross_y_1 = neg_M_left_foot_z + neg_F_left_foot_y;
  const Scalar M_left_ankle_cross_y_2 =
      M_left_ankle_cross_y_1 + left_ankle_cross_I8 * t_left_ankle_cross_7;
  const Scalar M_left_ankle_cross_y_3 =
      M_left_ankle_cross_y_2 + left_ankle_cross_I2 * t_left_ankle_cross_16;
  const Scalar M_left_ankle_cross_y_4 =
      M_left_ankle_cross_y_3 + left_hip_fork_k3 * neg_F_left_foot_x;
  const Scalar M_left_ankle_cross_y_5 =
      M_left_ankle_cross_y_4 + left_ankle_cross_I11 * t_left_ankle_cross_11;
  const Scalar M_left_ankle_cross_y =
      M_left_ankle_cross_y_5 - left_ankle_cross_I10 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_20 = t_left_ankle_cross_12 + t_left_ankle_cross_13;
  // left_foot: moment M, force F of (1)
  const Scalar t_left_foot_11 = F_left_foot_z - left_ankle_cross_I10 * t_left_ankle_cross_6;
  const Scalar t_left_foot_12 = t_left_foot_11 + Omega_left_foot_zy * t_left_foot_7;
  const Scalar t_left_foot_13 = t_left_foot_12 - neg_a_left_foot_z * t_left_foot_8;
  const Scalar t_left_foot_14 = t_left_foot_13 + Omega_left_foot_zx * t_left_foot_4;
  const Scalar t_left_foot_15 = t_left_foot_14 + left_ankle_cross_I9 * t_left_ankle_cross_16;
  const Scalar t_left_foot_16 = t_left_foot_15 - left_ankle_cross_I3 * a_left_ankle_cross_x;
  const Scalar t_left_foot_17 = t_left_ankle_cross_12 - t_left_foot_1;
  const Scalar t_left_foot_18 = t_left_foot_16 + t_left_foot_5 * t_left_foot_17;
  const Scalar t_left_foot_19 = t_left_foot_18 + left_ankle_cross_I2 * t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_21 = t_left_ankle_cross_19 - t_left_ankle_cross_20;
  const Scalar t_left_foot_20 = t_left_foot_19 - Omega_left_foot_xy * t_left_foot_6;
  const Scalar t_left_foot_21 = t_left_foot_20 + left_ankle_cross_I8 * t_left_ankle_cross_21;
  const Scalar neg_M_left_ankle_cross_z =
      t_left_foot_21 - left_ankle_cross_I11 * t_left_ankle_cross_17;
  tau[4] = -neg_M_left_ankle_cross_z;
  const Scalar t_left_foot_22 = t_left_foot_6 * (t_left_ankle_cross_13 - t_left_foot_1);
  const Scalar t_left_foot_23 = t_left_foot_22 - left_ankle_cross_I8 * t_left_ankle_cross_11;
  const Scalar t_left_foot_24 = t_left_foot_23 - Omega_left_foot_zx * t_left_foot_7;
  const Scalar t_left_foot_25 = t_left_foot_24 + neg_a_left_foot_z * t_left_foot_9;
  const Scalar t_left_foot_26 = t_left_foot_25 + t_left_foot_5 * neg_Omega_left_foot_yx;
  const Scalar t_left_foot_27 = t_left_foot_26 + left_hip_fork_k3 * F_left_foot_z;
  const Scalar t_left_foot_28 = t_left_foot_27 - left_ankle_cross_I9 * t_left_ankle_cross_7;
  const Scalar t_left_foot_29 = t_left_foot_28 - left_ankle_cross_I10 * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_22 = t_left_hip_fork_10 - t_left_ankle_cross_20;
  const Scalar t_left_foot_30 = t_left_foot_29 - Omega_left_foot_zy * t_left_foot_10;
  const Scalar t_left_foot_31 = t_left_foot_30 + left_ankle_cross_I2 * t_left_ankle_cross_22;
  const Scalar neg_M_left_ankle_cross_x =
      t_left_foot_31 + left_ankle_cross_I3 * a_left_ankle_cross_z;
  const Scalar t_left_foot_32 = F_left_foot_z + left_shank_I15 * neg_a_left_ankle_cross_y;
  const Scalar neg_F_left_ankle_cross_y =
      t_left_foot_32 - left_ankle_cross_I3 * t_left_ankle_cross_20;
  const Scalar t_left_foot_33 = neg_F_left_foot_x + left_ankle_cross_I3 * t_left_ankle_cross_16;
  const Scalar neg_F_left_ankle_cross_x = t_left_foot_33 - left_shank_I15 * a_left_ankle_cross_x;
  const Scalar t_left_foot_34 = neg_F_left_foot_y + left_ankle_cross_I3 * t_left_ankle_cross_7;
  const Scalar neg_F_left_ankle_cross_z = t_left_foot_34 - left_shank_I15 * a_left_ankle_cross_z;
  const Scalar M_left_shank_y_1 = s_left_ankle_pitch * neg_M_left_ankle_cross_x;
  // left_shank: moment M, Omega of (1)
  const Scalar M_left_shank_y_2 = M_left_shank_y_1 - left_shank_I6 * Omega_left_shank_xy;
  const Scalar M_left_shank_y_3 = M_left_shank_y_2 - c_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar M_left_shank_y_4 = M_left_shank_y_3 - left_shank_I11 * t_left_shank_11;
  const Scalar M_left_shank_y_5 = M_left_shank_y_4 + left_shank_I14 * Omega_left_shank_zx;
  const Scalar M_left_shank_y_6 = M_left_shank_y_5 + left_shank_I9 * Omega_left_shank_zy;
  const Scalar M_left_shank_y = M_left_shank_y_6 + left_hip_fork_k2 * neg_F_left_ankle_cross_z;
  const Scalar neg_Omega_left_shank_yy = t_left_shank_8 + t_left_shank_9;
  const Scalar M_left_shank_x_1 = c_left_ankle_pitch * neg_M_left_ankle_cross_x;
  const Scalar M_left_shank_x_2 = M_left_shank_x_1 + left_shank_I11 * Omega_left_shank_yx;
  const Scalar M_left_shank_x_3 = M_left_shank_x_2 + s_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar M_left_shank_x_4 = t_left_hip_fork_10 - neg_Omega_left_shank_yy;
  const Scalar M_left_shank_x_5 = M_left_shank_x_3 + left_shank_I6 * M_left_shank_x_4;
  const Scalar M_left_shank_x_6 = M_left_shank_x_5 + left_shank_I2 * a_left_shank_z;
  const Scalar M_left_shank_x_7 = M_left_shank_x_6 + left_shank_I10 * Omega_left_shank_zy;
  const Scalar M_left_shank_x = M_left_shank_x_7 - left_shank_I9 * Omega_left_shank_zx;
  // left_ankle_cross: moment M, force F of (1)
  const Scalar t_left_ankle_cross_23 = s_left_ankle_pitch * neg_F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_24 =
      t_left_ankle_cross_23 + c_left_ankle_pitch * neg_F_left_ankle_cross_y;
  const Scalar neg_M_left_shank_z_1 = neg_M_left_ankle_cross_z + left_shank_I16 * t_left_shank_10;
  const Scalar neg_M_left_shank_z_2 = neg_Omega_left_shank_xx - neg_Omega_left_shank_yy;
  const Scalar neg_M_left_shank_z_3 =
      neg_M_left_shank_z_1 - left_shank_I11 * neg_Omega_left_shank_yz;
  const Scalar neg_M_left_shank_z_4 = neg_M_left_shank_z_3 + left_shank_I9 * neg_M_left_shank_z_2;
  const Scalar neg_M_left_shank_z_5 =
      neg_M_left_shank_z_4 + left_shank_I6 * neg_Omega_left_shank_xz;
  const Scalar neg_M_left_shank_z_6 = neg_M_left_shank_z_5 - left_shank_I17 * alpha_left_shank_z;
  const Scalar neg_M_left_shank_z_7 =
      neg_M_left_shank_z_6 - left_hip_fork_k2 * t_left_ankle_cross_24;
  const Scalar neg_M_left_shank_z = neg_M_left_shank_z_7 - left_shank_I2 * neg_a_left_shank_x;
  tau[3] = -neg_M_left_shank_z;
  const Scalar neg_F_left_shank_x_1 = left_thigh_I15 * neg_a_left_shank_x;
  const Scalar neg_F_left_shank_x_2 = neg_F_left_shank_x_1 - left_shank_I2 * Omega_left_shank_xy;
  const Scalar neg_F_left_shank_x_3 =
      neg_F_left_shank_x_2 + s_left_ankle_pitch * neg_F_left_ankle_cross_y;
  const Scalar neg_F_left_shank_x =
      neg_F_left_shank_x_3 - c_left_ankle_pitch * neg_F_left_ankle_cross_x;
  const Scalar F_left_shank_y_1 = t_left_ankle_cross_24 - left_shank_I2 * neg_Omega_left_shank_yy;
  const Scalar F_left_shank_y = F_left_shank_y_1 - left_thigh_I15 * neg_a_left_shank_y;
  const Scalar neg_Omega_left_thigh_yy = t_left_thigh_5 + t_left_thigh_6;
  const Scalar t_left_thigh_10 = t_left_hip_fork_10 - neg_Omega_left_thigh_yy;
  const Scalar t_left_shank_12 = s_left_knee * neg_F_left_shank_x - c_left_knee * F_left_shank_y;
  const Scalar neg_M_left_thigh_z_1 = neg_M_left_shank_z - left_thigh_I2 * neg_a_left_thigh_x;
  const Scalar neg_M_left_thigh_z_2 = t_left_thigh_9 - t_left_thigh_10;
  // left_shank: moment M of (1)
  const Scalar neg_M_left_thigh_z_3 = neg_M_left_thigh_z_1 + left_thigh_I12 * neg_M_left_thigh_z_2;
  const Scalar neg_M_left_thigh_z_4 =
      neg_M_left_thigh_z_3 + left_thigh_I14 * neg_Omega_left_thigh_yx;
  const Scalar neg_M_left_thigh_z_5 = neg_M_left_thigh_z_4 + left_hip_fork_k1 * t_left_shank_12;
  const Scalar neg_M_left_thigh_z_6 =
      neg_M_left_thigh_z_5 + left_thigh_I6 * neg_Omega_left_thigh_xz;
  const Scalar neg_M_left_thigh_z_7 =
      neg_M_left_thigh_z_6 - left_thigh_I11 * neg_Omega_left_thigh_xy;
  const Scalar neg_M_left_thigh_z = neg_M_left_thigh_z_7 - left_thigh_I8 * neg_Omega_left_thigh_yz;
  tau[2] = -neg_M_left_thigh_z;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_4 - t_left_hip_fork_5;
  const Scalar neg_F_left_shank_z_1 = neg_F_left_ankle_cross_z - left_thigh_I15 * a_left_shank_z;
  const Scalar neg_F_left_shank_z = neg_F_left_shank_z_1 - left_shank_I2 * Omega_left_shank_zy;
  // left_thigh: moment M of (1)
  const Scalar M_left_thigh_y_1 = left_thigh_I6 * neg_Omega_left_thigh_xy;
  const Scalar M_left_thigh_y_2 = s_left_knee * M_left_shank_x + M_left_thigh_y_1;
  const Scalar M_left_thigh_y_3 = M_left_thigh_y_2 + c_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_y_4 = M_left_thigh_y_3 + left_hip_fork_k1 * neg_F_left_shank_z;
  const Scalar M_left_thigh_y_5 = M_left_thigh_y_4 - left_thigh_I12 * Omega_left_thigh_zy;
  const Scalar M_left_thigh_y_6 = M_left_thigh_y_5 - left_thigh_I8 * t_left_thigh_9;
  const Scalar M_left_thigh_y = M_left_thigh_y_6 - left_thigh_I14 * Omega_left_thigh_zx;
  const Scalar M_left_thigh_x_1 = left_thigh_I2 * a_left_thigh_z - s_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_x_2 = M_left_thigh_x_1 + left_thigh_I6 * t_left_thigh_10;
  const Scalar M_left_thigh_x_3 = M_left_thigh_x_2 - left_thigh_I8 * neg_Omega_left_thigh_yx;
  const Scalar M_left_thigh_x_4 = M_left_thigh_x_3 + left_thigh_I11 * Omega_left_thigh_zy;
  const Scalar M_left_thigh_x_5 = M_left_thigh_x_4 + c_left_knee * M_left_shank_x;
  const Scalar M_left_thigh_x = M_left_thigh_x_5 + left_thigh_I12 * Omega_left_thigh_zx;
  // left_hip_fork: moment M, Omega of (1)
  const Scalar t_left_hip_fork_12 = t_left_hip_block_1 - t_left_hip_fork_10;
  const Scalar M_left_hip_fork_z_1 = left_hip_fork_I6 * t_left_hip_fork_8;
  const Scalar M_left_hip_fork_z_2 = left_hip_fork_I12 * qdd[1] + M_left_hip_fork_z_1;
  const Scalar M_left_hip_fork_z_3 = M_left_hip_fork_z_2 + c_left_hip_pitch * M_left_thigh_y;
  const Scalar M_left_hip_fork_z_4 = left_hip_fork_G3 - left_hip_fork_I9 * qdd[0];
  const Scalar M_left_hip_fork_z_5 = M_left_hip_fork_z_3 + s_left_hip_pitch * M_left_thigh_x;
  const Scalar M_left_hip_fork_z_6 = left_hip_fork_G2 - left_hip_fork_I8 * qdd[0];
  const Scalar M_left_hip_fork_z_7 = M_left_hip_fork_z_5 + c_left_hip_roll * M_left_hip_fork_z_4;
  const Scalar M_left_hip_fork_z_8 = t_left_hip_fork_11 - t_left_hip_fork_12;
  const Scalar M_left_hip_fork_z_9 = M_left_hip_fork_z_7 + s_left_hip_roll * M_left_hip_fork_z_6;
  tau[1] = M_left_hip_fork_z_9 + left_hip_fork_I7 * M_left_hip_fork_z_8;
  const Scalar neg_F_left_thigh_x_1 = left_thigh_I2 * neg_Omega_left_thigh_xy;
  const Scalar neg_F_left_thigh_x_2 = neg_F_left_thigh_x_1 + s_left_knee * F_left_shank_y;
  const Scalar neg_F_left_thigh_x = neg_F_left_thigh_x_2 + c_left_knee * neg_F_left_shank_x;
  const Scalar M_left_hip_fork_y_1 =
      neg_M_left_thigh_z - left_hip_fork_I10 * Omega_left_hip_fork_zx;
  const Scalar neg_F_left_thigh_y = t_left_shank_12 + left_thigh_I2 * neg_Omega_left_thigh_yy;
  const Scalar M_left_hip_fork_y_2 = M_left_hip_fork_y_1 - c_left_hip_pitch * neg_F_left_thigh_x;
  const Scalar M_left_hip_fork_y_3 = M_left_hip_fork_y_2 + s_left_hip_pitch * neg_F_left_thigh_y;
  const Scalar M_left_hip_fork_y_4 = M_left_hip_fork_y_3 + left_hip_fork_I9 * t_left_hip_fork_11;
  const Scalar M_left_hip_fork_y_5 =
      M_left_hip_fork_y_4 + left_hip_fork_I7 * Omega_left_hip_fork_zy;
  const Scalar M_left_hip_fork_y = M_left_hip_fork_y_5 + left_hip_fork_I8 * t_left_hip_fork_9;
  const Scalar t_left_hip_fork_13 = t_left_hip_fork_8 - qdd[1];
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_11 = neg_F_left_shank_z - left_hip_fork_I9 * t_left_hip_fork_13;
  const Scalar t_left_thigh_12 = t_left_thigh_11 - left_thigh_I2 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_13 = t_left_thigh_12 + left_hip_fork_I7 * Omega_left_hip_fork_zx;
  const Scalar t_left_thigh_14 = t_left_thigh_13 - left_hip_fork_I11 * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_15 = t_left_thigh_14 + s_left_hip_pitch * M_left_thigh_y;
  const Scalar t_left_thigh_16 = t_left_thigh_15 - c_left_hip_pitch * M_left_thigh_x;
  const Scalar M_left_hip_block_z_1 = s_left_hip_roll * M_left_hip_fork_y;
  const Scalar neg_M_left_hip_fork_x = t_left_thigh_16 - left_hip_fork_I8 * t_left_hip_fork_12;
  // left_hip_block: moment M of (1)
  const Scalar M_left_hip_block_z_2 = left_hip_block_I2 * qdd[0] - M_left_hip_block_z_1;
  tau[0] = M_left_hip_block_z_2 - c_left_hip_roll * neg_M_left_hip_fork_x;
}

// Lengths inside are in units of L, a distance between left_hip_roll and left_hip_pitch:
//   L = 0.01 m
// Names: vectors F_ in N m/L, a_ in L/s^2, h_ in kg m^2/L, s_ in L; all others are of values in SI
// units; numbered ones (t_) by what they are made of. Arguments and results are in SI units.
void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept {
  const Scalar q_q2_q3_q4 = q[2] + q[3] + q[4];
  const Scalar q_q8_q9_q10 = q[8] + q[9] + q[10];
  const Scalar angle_left_foot = left_foot_k1 + q[5];
  const Scalar angle_right_foot = left_foot_k1 - q[11];
  Scalar sines[16];
  Scalar cosines[16];
  sines_cosines(sines, cosines, q[1], q_q2_q3_q4, q[2], q[4], q[7], q_q8_q9_q10, q[8], q[10]);
  sines_cosines(sines + 8, cosines + 8, angle_left_foot, angle_right_foot);
  const Scalar s_left_hip_roll = sines[0];
  const Scalar c_left_hip_roll = cosines[0];
  const Scalar s_q2_q3_q4 = sines[1];
  const Scalar c_q2_q3_q4 = cosines[1];
  const Scalar s_left_hip_pitch = sines[2];
  const Scalar c_left_hip_pitch = cosines[2];
  const Scalar s_left_ankle_pitch = sines[3];
  const Scalar c_left_ankle_pitch = cosines[3];
  const Scalar s_right_hip_roll = sines[4];
  const Scalar c_right_hip_roll = cosines[4];
  const Scalar s_q8_q9_q10 = sines[5];
  const Scalar c_q8_q9_q10 = cosines[5];
  const Scalar s_right_hip_pitch = sines[6];
  const Scalar c_right_hip_pitch = cosines[6];
  const Scalar s_right_ankle_pitch = sines[7];
  const Scalar c_right_ankle_pitch = cosines[7];
  const Scalar s_left_foot = sines[8];
  const Scalar c_left_foot = cosines[8];
  const Scalar s_right_foot = sines[9];
  const Scalar c_right_foot = cosines[9];
  const Scalar s_left_shank_y = left_hip_fork_k1 * s_left_hip_pitch;
  const Scalar s_left_shank_x = left_hip_fork_k1 * c_left_hip_pitch;
  const Scalar neg_s_left_ankle_cross_x = left_hip_fork_k2 * c_left_ankle_pitch;
  const Scalar s_left_ankle_cross_y = left_hip_fork_k2 * s_left_ankle_pitch;
  const Scalar s_right_shank_y = left_hip_fork_k1 * s_right_hip_pitch;
  const Scalar s_right_shank_x = left_hip_fork_k1 * c_right_hip_pitch;
  const Scalar neg_s_righ_ankl_cros_x = left_hip_fork_k2 * c_right_ankle_pitch;
  const Scalar s_righ_ankl_cros_y = left_hip_fork_k2 * s_right_ankle_pitch;
  const Scalar t_left_hip_block_1 = qd[0] * qd[0];
  // left_hip_fork: angular velocity omega, moment M, Omega of (1)
  const Scalar omega_left_hip_fork_x = c_left_hip_roll * qd[0];
  const Scalar t_left_hip_fork_1 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_2 = qd[1] * qd[1];
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_1 - t_left_hip_fork_2;
  const Scalar t_left_hip_fork_4 = s_left_hip_roll * qd[0];
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_1 + t_left_hip_fork_2;
  const Scalar alpha_left_thigh_z = omega_left_hip_fork_x * qd[1];
  const Scalar Omega_left_thigh_xz = omega_left_hip_fork_x * t_left_hip_fork_4;
  const Scalar neg_a_left_hip_fork_x = left_hip_fork_p1 * c_left_hip_roll;
  const Scalar a_left_hip_fork_y = left_hip_fork_p1 * s_left_hip_roll;
  const Scalar t_left_hip_fork_6 = qd[1] * t_left_hip_fork_4;
  // left_thigh: angular velocity omega, Omega, moment M of (1)
  const Scalar omega_left_thigh_z = t_left_hip_fork_4 + qd[2];
  const Scalar Omega_left_thigh_yz = 2.0f * t_left_hip_fork_6;
  const Scalar t_left_thigh_1 = 2.0f * omega_left_thigh_z;
  const Scalar neg_Omega_left_thigh_zy = Omega_left_thigh_yz - qd[1] * t_left_thigh_1;
  const Scalar t_left_thigh_2 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_3 = t_left_hip_fork_1 - t_left_thigh_2;
  const Scalar neg_Omega_left_thigh_xx = t_left_hip_fork_5 - t_left_thigh_3;
  const Scalar neg_Omega_left_thigh_zx =
      Omega_left_thigh_xz - omega_left_hip_fork_x * t_left_thigh_1;
  const Scalar t_left_thigh_4 = left_thigh_I4 * s_left_hip_pitch;
  const Scalar t_left_thigh_5 = t_left_thigh_4 + left_thigh_I3 * c_left_hip_pitch;
  const Scalar t_left_thigh_6 = left_thigh_I12 - c_left_hip_pitch * t_left_thigh_5;
  const Scalar t_left_thigh_7 = s_left_hip_pitch * t_left_thigh_5;
  const Scalar t_left_thigh_8 = left_thigh_I6 * s_left_hip_pitch;
  const Scalar t_left_thigh_9 = t_left_thigh_8 - left_thigh_I5 * c_left_hip_pitch;
  const Scalar neg_Omega_left_thigh_yy = t_left_hip_fork_1 + t_left_thigh_2;
  const Scalar t_left_thigh_10 = left_thigh_I6 * c_left_hip_pitch;
  const Scalar t_left_thigh_11 = t_left_thigh_10 + left_thigh_I5 * s_left_hip_pitch;
  const Scalar t_left_thigh_12 = left_thigh_I2 * c_left_hip_pitch;
  const Scalar t_left_thigh_13 = t_left_thigh_12 + left_thigh_I1 * s_left_hip_pitch;
  const Scalar t_left_thigh_14 = left_thigh_I18 - t_left_thigh_7;
  const Scalar t_left_thigh_15 = left_thigh_I2 * s_left_hip_pitch;
  const Scalar t_left_thigh_16 = t_left_thigh_15 - left_thigh_I1 * c_left_hip_pitch;
  const Scalar t_left_shank_1 = neg_a_left_hip_fork_x + s_left_shank_x * neg_Omega_left_thigh_xx;
  const Scalar Omega_left_hip_fork_zx = 2.0f * alpha_left_thigh_z;
  // left_shank: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_left_shank_2 = t_left_hip_block_1 - s_left_shank_x * Omega_left_hip_fork_zx;
  const Scalar t_left_shank_3 = t_left_shank_2 + s_left_shank_y * neg_Omega_left_thigh_yy;
  const Scalar t_left_shank_4 = s_q2_q3_q4 * omega_left_hip_fork_x;
  const Scalar omega_left_shank_y = t_left_shank_4 - c_q2_q3_q4 * qd[1];
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_5 = t_left_hip_fork_4 * t_left_shank_4;
  const Scalar neg_Omega_left_shank_yz = c_q2_q3_q4 * Omega_left_thigh_yz - t_left_shank_5;
  const Scalar t_left_shank_6 = 2.0f * omega_left_shank_y;
  const Scalar Omega_left_shank_zy = neg_Omega_left_shank_yz + omega_left_shank_z * t_left_shank_6;
  const Scalar neg_omega_left_shank_x = s_q2_q3_q4 * qd[1] + c_q2_q3_q4 * omega_left_hip_fork_x;
  const Scalar t_left_shank_7 = s_q2_q3_q4 * Omega_left_thigh_yz;
  const Scalar neg_Omega_left_shank_xz = t_left_shank_7 + c_q2_q3_q4 * Omega_left_thigh_xz;
  const Scalar t_left_shank_8 = 2.0f * neg_omega_left_shank_x;
  const Scalar Omega_left_shank_zx = neg_Omega_left_shank_xz - omega_left_shank_z * t_left_shank_8;
  const Scalar t_left_shank_9 = neg_omega_left_shank_x * neg_omega_left_shank_x;
  const Scalar t_left_shank_10 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_11 = t_left_hip_fork_5 - t_left_shank_9;
  const Scalar t_left_shank_12 = omega_left_shank_y * neg_omega_left_shank_x;
  const Scalar Omega_left_shank_yx = alpha_left_thigh_z - t_left_shank_12;
  const Scalar Omega_left_foot_xz = alpha_left_thigh_z + t_left_shank_12;
  const Scalar neg_Omega_left_shank_yy = t_left_shank_9 + t_left_shank_10;
  const Scalar t_left_shank_13 = left_shank_I3 * s_left_ankle_pitch;
  const Scalar t_left_shank_14 = t_left_shank_13 + left_shank_I4 * c_left_ankle_pitch;
  const Scalar t_left_shank_15 = s_left_ankle_pitch * t_left_shank_14;
  const Scalar t_left_shank_16 = left_shank_I5 * c_left_ankle_pitch;
  const Scalar t_left_shank_17 = t_left_shank_16 + left_shank_I6 * s_left_ankle_pitch;
  const Scalar t_left_shank_18 = left_shank_I5 * s_left_ankle_pitch;
  const Scalar t_left_shank_19 = t_left_shank_18 - left_shank_I6 * c_left_ankle_pitch;
  const Scalar t_left_shank_20 = left_shank_I10 + t_left_shank_15;
  const Scalar t_left_shank_21 = left_shank_I9 - c_left_ankle_pitch * t_left_shank_14;
  const Scalar t_left_shank_22 = left_shank_I2 * c_left_ankle_pitch;
  const Scalar t_left_shank_23 = t_left_shank_22 - left_shank_I1 * s_left_ankle_pitch;
  const Scalar t_left_shank_24 = left_shank_I2 * s_left_ankle_pitch;
  const Scalar t_left_shank_25 = t_left_shank_24 + left_shank_I1 * c_left_ankle_pitch;
  const Scalar neg_a_left_shank_z_1 = a_left_hip_fork_y + s_left_shank_y * neg_Omega_left_thigh_zy;
  const Scalar neg_a_left_shank_z = neg_a_left_shank_z_1 + s_left_shank_x * neg_Omega_left_thigh_zx;
  // left_ankle_cross: acceleration a, angular velocity omega, moment M of (1)
  const Scalar t_left_ankle_cross_1 =
      neg_a_left_shank_z + neg_s_left_ankle_cross_x * Omega_left_shank_zx;
  const Scalar neg_a_left_ankle_cross_z =
      t_left_ankle_cross_1 - s_left_ankle_cross_y * Omega_left_shank_zy;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_2 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_3 = t_left_shank_9 - t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_4 = Omega_left_shank_zy + t_left_shank_6 * qd[4];
  const Scalar t_left_ankle_cross_5 = t_left_shank_8 * qd[4];
  const Scalar t_left_ankle_cross_6 = Omega_left_shank_zx - t_left_ankle_cross_5;
  const Scalar a_left_shank_y = c_q2_q3_q4 * t_left_shank_3 - s_q2_q3_q4 * t_left_shank_1;
  const Scalar t_left_ankle_cross_7 =
      a_left_shank_y - neg_s_left_ankle_cross_x * Omega_left_shank_yx;
  const Scalar a_left_ankle_cross_y =
      t_left_ankle_cross_7 - s_left_ankle_cross_y * neg_Omega_left_shank_yy;
  // left_foot: acceleration a, angular velocity omega, Omega of (1)
  const Scalar neg_a_left_foot_z_1 = Omega_left_shank_yx + a_left_ankle_cross_y;
  const Scalar neg_a_left_foot_z = neg_a_left_foot_z_1 + left_hip_fork_k3 * neg_Omega_left_shank_yz;
  const Scalar neg_omega_left_foot_z = omega_left_shank_y - qd[5];
  const Scalar Omega_left_foot_zy_1 = omega_left_ankle_cross_z * neg_omega_left_foot_z;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_4 - 2.0f * Omega_left_foot_zy_1;
  const Scalar t_left_foot_1 = neg_omega_left_foot_z * neg_omega_left_foot_z;
  const Scalar neg_Omega_left_foot_zx = Omega_left_foot_xz - t_left_shank_8 * neg_omega_left_foot_z;
  const Scalar h_left_foot_x = left_foot_I1 * c_left_foot;
  const Scalar t_left_foot_2 = t_left_ankle_cross_6 * h_left_foot_x;
  const Scalar h_left_foot_y = left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_3 = left_foot_I5 * c_left_foot - left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_4 = s_left_foot * t_left_foot_3;
  const Scalar E_left_foot_xx = left_foot_I14 + t_left_foot_4;
  const Scalar neg_E_left_foot_xz = left_foot_I2 * s_left_foot - left_foot_I3 * c_left_foot;
  const Scalar E_left_foot_yz = left_foot_I3 * s_left_foot + left_foot_I2 * c_left_foot;
  const Scalar E_left_foot_yy = left_foot_I12 - t_left_foot_4;
  const Scalar t_left_foot_5 = c_left_foot * t_left_foot_3;
  const Scalar E_left_foot_xy = left_foot_I13 - t_left_foot_5;
  const Scalar neg_M_left_shank_y_1 = t_left_shank_9 - t_left_shank_10;
  const Scalar neg_Omega_left_shank_xx = t_left_shank_10 + t_left_shank_11;
  const Scalar neg_F_left_foot_z_1 = neg_Omega_left_foot_zx * h_left_foot_x;
  const Scalar neg_F_left_foot_z = neg_F_left_foot_z_1 - Omega_left_foot_zy * h_left_foot_y;
  const Scalar t_right_hip_block_1 = qd[6] * qd[6];
  // right_hip_fork: angular velocity omega, Omega, angular acceleration alpha of (1)
  const Scalar omega_right_hip_fork_x = c_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_1 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_2 = qd[7] * qd[7];
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_1 - t_right_hip_fork_2;
  const Scalar alpha_right_thigh_z = omega_right_hip_fork_x * qd[7];
  const Scalar t_right_hip_fork_4 = s_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_5 = qd[7] * t_right_hip_fork_4;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_1 + t_right_hip_fork_2;
  const Scalar Omega_right_thigh_xz = omega_right_hip_fork_x * t_right_hip_fork_4;
  const Scalar neg_a_right_hip_fork_x = left_hip_fork_p1 * c_right_hip_roll;
  const Scalar a_right_hip_fork_y = left_hip_fork_p1 * s_right_hip_roll;
  // right_thigh: angular velocity omega, Omega, moment M of (1)
  const Scalar omega_right_thigh_z = t_right_hip_fork_4 + qd[8];
  const Scalar t_right_thigh_1 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_2 = 2.0f * omega_right_thigh_z;
  const Scalar neg_Omega_right_thigh_zx =
      Omega_right_thigh_xz - omega_right_hip_fork_x * t_right_thigh_2;
  const Scalar Omega_right_thigh_yz = 2.0f * t_right_hip_fork_5;
  const Scalar neg_Omega_right_thigh_zy = Omega_right_thigh_yz - qd[7] * t_right_thigh_2;
  const Scalar t_right_thigh_3 = left_thigh_I3 * c_right_hip_pitch;
  const Scalar t_right_thigh_4 = t_right_thigh_3 + left_thigh_I4 * s_right_hip_pitch;
  const Scalar t_right_thigh_5 = s_right_hip_pitch * t_right_thigh_4;
  const Scalar t_right_thigh_6 = left_thigh_I12 - c_right_hip_pitch * t_right_thigh_4;
  const Scalar t_right_thigh_7 = left_thigh_I5 * c_right_hip_pitch;
  const Scalar t_right_thigh_8 = t_right_thigh_7 - left_thigh_I6 * s_right_hip_pitch;
  const Scalar t_right_thigh_9 = left_thigh_I18 - t_right_thigh_5;
  const Scalar t_right_thigh_10 = left_thigh_I1 * c_right_hip_pitch;
  const Scalar t_right_thigh_11 = t_right_thigh_10 - left_thigh_I2 * s_right_hip_pitch;
  const Scalar Omega_right_hip_fork_zx = 2.0f * alpha_right_thigh_z;
  const Scalar t_right_shank_1 = t_right_hip_block_1 - s_right_shank_x * Omega_right_hip_fork_zx;
  const Scalar neg_Omega_right_thigh_yy = t_right_hip_fork_1 + t_right_thigh_1;
  const Scalar t_right_shank_2 = t_right_shank_1 + s_right_shank_y * neg_Omega_right_thigh_yy;
  const Scalar t_right_thigh_12 = t_right_hip_fork_1 - t_right_thigh_1;
  const Scalar neg_Omega_right_thigh_xx = t_right_hip_fork_6 - t_right_thigh_12;
  // right_shank: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_right_shank_3 =
      neg_a_right_hip_fork_x + s_right_shank_x * neg_Omega_right_thigh_xx;
  const Scalar neg_a_right_shank_z_1 =
      a_right_hip_fork_y + s_right_shank_x * neg_Omega_right_thigh_zx;
  const Scalar neg_a_right_shank_z =
      neg_a_right_shank_z_1 + s_right_shank_y * neg_Omega_right_thigh_zy;
  const Scalar omega_right_shank_y = s_q8_q9_q10 * omega_right_hip_fork_x - c_q8_q9_q10 * qd[7];
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar t_right_shank_4 = c_q8_q9_q10 * Omega_right_thigh_yz;
  const Scalar neg_Omega_right_shank_yz = t_right_shank_4 - s_q8_q9_q10 * Omega_right_thigh_xz;
  const Scalar t_right_shank_5 = 2.0f * omega_right_shank_z;
  const Scalar Omega_right_shank_zy =
      neg_Omega_right_shank_yz + omega_right_shank_y * t_right_shank_5;
  const Scalar t_right_shank_6 = c_q8_q9_q10 * omega_right_hip_fork_x;
  const Scalar neg_omega_right_shank_x = t_right_shank_6 + s_q8_q9_q10 * qd[7];
  const Scalar t_right_shank_7 = neg_omega_right_shank_x * neg_omega_right_shank_x;
  const Scalar t_right_shank_8 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_9 = t_right_hip_fork_4 * t_right_shank_6;
  const Scalar neg_Omega_right_foot_xy = s_q8_q9_q10 * Omega_right_thigh_yz + t_right_shank_9;
  const Scalar Omega_right_shank_zx =
      neg_Omega_right_foot_xy - t_right_shank_5 * neg_omega_right_shank_x;
  const Scalar t_right_shank_10 = omega_right_shank_y * neg_omega_right_shank_x;
  const Scalar Omega_right_shank_yx = alpha_right_thigh_z - t_right_shank_10;
  const Scalar neg_Omega_right_shank_yy = t_right_shank_7 + t_right_shank_8;
  const Scalar Omega_right_foot_xz = alpha_right_thigh_z + t_right_shank_10;
  const Scalar t_right_shank_11 = left_shank_I4 * c_right_ankle_pitch;
  const Scalar t_right_shank_12 = t_right_shank_11 + left_shank_I3 * s_right_ankle_pitch;
  const Scalar t_right_shank_13 = left_shank_I9 - c_right_ankle_pitch * t_right_shank_12;
  const Scalar t_right_shank_14 = s_right_ankle_pitch * t_right_shank_12;
  const Scalar t_right_shank_15 = left_shank_I6 * s_right_ankle_pitch;
  const Scalar t_right_shank_16 = t_right_shank_15 + left_shank_I5 * c_right_ankle_pitch;
  const Scalar t_right_shank_17 = left_shank_I5 * s_right_ankle_pitch;
  const Scalar t_right_shank_18 = t_right_shank_17 - left_shank_I6 * c_right_ankle_pitch;
  const Scalar t_right_shank_19 = left_shank_I1 * s_right_ankle_pitch;
  const Scalar t_right_shank_20 = t_right_shank_19 - left_shank_I2 * c_right_ankle_pitch;
  const Scalar t_right_shank_21 = left_shank_I18 - t_right_shank_14;
  const Scalar t_right_shank_22 = t_right_shank_7 - t_right_shank_8;
  const Scalar neg_Omega_right_shank_xx = t_right_hip_fork_6 - t_right_shank_22;
  const Scalar t_right_shank_23 = t_right_hip_fork_6 - neg_Omega_right_shank_yy;
  const Scalar t_righ_ankl_cros_1 = t_right_shank_22 - t_right_shank_23;
  const Scalar t_right_shank_24 = left_shank_I1 * c_right_ankle_pitch;
  const Scalar t_right_shank_25 = t_right_shank_24 + left_shank_I2 * s_right_ankle_pitch;
  const Scalar t_righ_ankl_cros_2 = neg_a_right_shank_z - s_righ_ankl_cros_y * Omega_right_shank_zy;
  const Scalar neg_a_righ_ankl_cros_z =
      t_righ_ankl_cros_2 + neg_s_righ_ankl_cros_x * Omega_right_shank_zx;
  const Scalar a_right_shank_x_1 = c_q8_q9_q10 * t_right_shank_3;
  const Scalar a_right_shank_x = a_right_shank_x_1 + s_q8_q9_q10 * t_right_shank_2;
  // right_ankle_cross: angular velocity omega, Omega of (1)
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_3 = 2.0f * omega_righ_ankl_cros_z;
  const Scalar Omega_righ_ankl_cros_zx =
      neg_Omega_right_foot_xy - neg_omega_right_shank_x * t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_4 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_5 = t_right_shank_7 - t_righ_ankl_cros_4;
  const Scalar Omega_righ_ankl_cros_zy =
      neg_Omega_right_shank_yz + omega_right_shank_y * t_righ_ankl_cros_3;
  // right_foot: angular velocity omega, Omega, first moment h of (1)
  const Scalar neg_omega_right_foot_z = omega_right_shank_y - qd[11];
  const Scalar Omega_right_foot_zy =
      Omega_righ_ankl_cros_zy - t_righ_ankl_cros_3 * neg_omega_right_foot_z;
  const Scalar t_right_foot_1 = neg_omega_right_foot_z * neg_omega_right_foot_z;
  const Scalar t_right_foot_2 = neg_omega_right_shank_x * neg_omega_right_foot_z;
  const Scalar neg_Omega_right_foot_zx = Omega_right_foot_xz - 2.0f * t_right_foot_2;
  const Scalar h_right_foot_x = left_foot_I1 * c_right_foot;
  const Scalar t_right_foot_3 = Omega_righ_ankl_cros_zx * h_right_foot_x;
  const Scalar neg_h_right_foot_y = left_foot_I1 * s_right_foot;
  const Scalar neg_E_right_foot_xz = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_4 = left_foot_I4 * s_right_foot - left_foot_I5 * c_right_foot;
  const Scalar t_right_foot_5 = s_right_foot * t_right_foot_4;
  const Scalar E_right_foot_xx = left_foot_I14 - t_right_foot_5;
  const Scalar neg_E_right_foot_yz = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_6 = c_right_foot * t_right_foot_4;
  const Scalar neg_E_right_foot_xy = left_foot_I13 + t_right_foot_6;
  const Scalar neg_F_right_foot_z_1 = Omega_right_foot_zy * neg_h_right_foot_y;
  const Scalar neg_F_right_foot_z = neg_F_right_foot_z_1 + neg_Omega_right_foot_zx * h_right_foot_x;
  const Scalar neg_E_righ_ankl_cros_yz = left_ankle_cross_I2 - neg_E_right_foot_yz;
  const Scalar t_righ_ankl_cros_6 = t_right_shank_7 + t_righ_ankl_cros_4;
  const Scalar t_right_foot_7 = t_right_shank_7 - t_right_foot_1;
  const Scalar F_right_foot_x_1 = h_right_foot_x * (t_righ_ankl_cros_6 - t_right_foot_7);
  const Scalar F_right_foot_x = neg_Omega_right_foot_xy * neg_h_right_foot_y - F_right_foot_x_1;
  const Scalar neg_Omega_right_foot_yy = t_right_shank_7 + t_right_foot_1;
  const Scalar F_right_foot_y = t_right_foot_3 + neg_h_right_foot_y * neg_Omega_right_foot_yy;
  const Scalar F_righ_ankl_cros_z_1 =
      F_right_foot_y + left_ankle_cross_I1 * Omega_righ_ankl_cros_zx;
  const Scalar F_righ_ankl_cros_z =
      F_righ_ankl_cros_z_1 - left_ankle_cross_I3 * Omega_righ_ankl_cros_zy;
  const Scalar a_right_shank_y_1 = c_q8_q9_q10 * t_right_shank_2;
  const Scalar a_right_shank_y = a_right_shank_y_1 - s_q8_q9_q10 * t_right_shank_3;
  const Scalar a_righ_ankl_cros_y_1 =
      a_right_shank_y - neg_s_righ_ankl_cros_x * Omega_right_shank_yx;
  const Scalar a_righ_ankl_cros_y =
      a_righ_ankl_cros_y_1 - s_righ_ankl_cros_y * neg_Omega_right_shank_yy;
  const Scalar neg_a_right_foot_z_1 = Omega_right_shank_yx + a_righ_ankl_cros_y;
  const Scalar neg_a_right_foot_z =
      neg_a_right_foot_z_1 - left_hip_fork_k3 * neg_Omega_right_shank_yz;
  const Scalar t_right_shank_26 = left_shank_I10 + t_right_shank_14;
  const Scalar neg_E_righ_ankl_cros_xy = left_ankle_cross_I8 - neg_E_right_foot_xz;
  const Scalar E_right_foot_yy = left_foot_I12 + t_right_foot_5;
  // right_ankle_cross: moment M, acceleration a, Omega of (1)
  const Scalar neg_M_right_shank_x_1 = left_ankle_cross_I16 - t_right_shank_16;
  const Scalar neg_M_right_shank_x_2 = Omega_right_shank_yx * neg_M_right_shank_x_1;
  const Scalar neg_M_right_shank_x_3 = t_right_hip_fork_6 - t_righ_ankl_cros_6;
  const Scalar neg_M_right_shank_x_4 =
      left_hip_fork_k3 * neg_F_right_foot_z + neg_M_right_shank_x_2;
  const Scalar neg_M_right_shank_x_5 =
      neg_M_right_shank_x_4 - left_ankle_cross_I2 * neg_M_right_shank_x_3;
  const Scalar neg_M_right_shank_x_6 =
      neg_M_right_shank_x_5 - Omega_right_foot_zy * E_right_foot_yy;
  const Scalar neg_M_right_shank_x_7 =
      neg_M_right_shank_x_6 - left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar neg_M_right_shank_x_8 = neg_M_right_shank_x_7 + t_right_shank_18 * t_right_shank_23;
  const Scalar neg_M_right_shank_x_9 = t_righ_ankl_cros_4 - t_right_foot_1;
  const Scalar neg_M_right_shank_x_10 =
      neg_M_right_shank_x_8 - neg_h_right_foot_y * neg_a_right_foot_z;
  const Scalar neg_M_right_shank_x_11 =
      neg_M_right_shank_x_10 - neg_E_right_foot_yz * neg_M_right_shank_x_9;
  const Scalar neg_M_right_shank_x_12 =
      neg_M_right_shank_x_11 - Omega_right_shank_zx * t_right_shank_13;
  const Scalar neg_M_right_shank_x_13 =
      neg_M_right_shank_x_12 + Omega_righ_ankl_cros_zx * neg_E_righ_ankl_cros_xy;
  const Scalar neg_M_right_shank_x_14 =
      neg_M_right_shank_x_13 - s_righ_ankl_cros_y * F_righ_ankl_cros_z;
  const Scalar neg_M_right_shank_x_15 =
      neg_M_right_shank_x_14 - neg_Omega_right_foot_zx * neg_E_right_foot_xy;
  const Scalar neg_M_right_shank_x_16 =
      neg_M_right_shank_x_15 - Omega_right_shank_zy * t_right_shank_26;
  const Scalar neg_M_right_shank_x_17 =
      neg_M_right_shank_x_16 - left_ankle_cross_I3 * neg_a_righ_ankl_cros_z;
  const Scalar neg_M_right_shank_x =
      neg_M_right_shank_x_17 + neg_a_right_shank_z * t_right_shank_20;
  const Scalar a_righ_ankl_cros_x_1 = a_right_shank_x - s_righ_ankl_cros_y * Omega_right_foot_xz;
  const Scalar a_righ_ankl_cros_x =
      a_righ_ankl_cros_x_1 + neg_s_righ_ankl_cros_x * neg_Omega_right_shank_xx;
  const Scalar t_righ_ankl_cros_7 = t_right_hip_fork_6 - t_righ_ankl_cros_5;
  // right_foot: acceleration a, moment M of (1)
  const Scalar a_right_foot_x_1 = a_righ_ankl_cros_x - t_righ_ankl_cros_7;
  const Scalar a_right_foot_x = a_right_foot_x_1 - left_hip_fork_k3 * neg_Omega_right_foot_xy;
  const Scalar M_right_foot_z_1 = t_right_foot_3 + Omega_right_foot_xz * neg_E_right_foot_yz;
  const Scalar M_right_foot_z_2 = neg_a_righ_ankl_cros_z + left_hip_fork_k3 * t_right_hip_fork_6;
  const Scalar M_right_foot_z_3 = M_right_foot_z_1 + Omega_righ_ankl_cros_zy * neg_E_right_foot_xz;
  const Scalar M_right_foot_z_4 = M_right_foot_z_3 - h_right_foot_x * M_right_foot_z_2;
  const Scalar M_right_foot_z_5 = M_right_foot_z_4 + Omega_righ_ankl_cros_zx * E_right_foot_xx;
  const Scalar M_right_foot_z_6 = M_right_foot_z_5 + neg_Omega_right_foot_xy * E_right_foot_yy;
  const Scalar M_right_foot_z_7 = M_right_foot_z_6 + neg_h_right_foot_y * a_right_foot_x;
  const Scalar M_right_foot_z = M_right_foot_z_7 + t_righ_ankl_cros_5 * neg_E_right_foot_xy;
  // right_ankle_cross: moment M, force F of (1)
  const Scalar t_righ_ankl_cros_8 = left_ankle_cross_I2 - t_right_shank_18;
  const Scalar neg_M_right_shank_y_1 = F_right_foot_y + M_right_foot_z;
  const Scalar neg_M_right_shank_y_2 =
      neg_M_right_shank_y_1 - left_ankle_cross_I1 * neg_a_righ_ankl_cros_z;
  const Scalar neg_M_right_shank_y_3 = neg_M_right_shank_y_2 - left_hip_fork_k3 * F_right_foot_x;
  const Scalar neg_M_right_shank_y_4 =
      neg_M_right_shank_y_3 - Omega_right_foot_xz * t_righ_ankl_cros_8;
  const Scalar neg_M_right_shank_y_5 =
      neg_M_right_shank_y_4 - left_ankle_cross_I16 * t_righ_ankl_cros_5;
  const Scalar neg_M_right_shank_y_6 =
      neg_M_right_shank_y_5 + neg_a_right_shank_z * t_right_shank_25;
  const Scalar neg_M_right_shank_y_7 =
      neg_M_right_shank_y_6 - left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar neg_M_right_shank_y_8 =
      neg_M_right_shank_y_7 + Omega_right_shank_zx * t_right_shank_21;
  const Scalar neg_M_right_shank_y_9 =
      neg_M_right_shank_y_8 + Omega_right_shank_zy * t_right_shank_13;
  const Scalar neg_M_right_shank_y_10 =
      neg_M_right_shank_y_9 - neg_s_righ_ankl_cros_x * F_righ_ankl_cros_z;
  const Scalar neg_M_right_shank_y_11 =
      neg_M_right_shank_y_10 + t_right_shank_16 * t_right_shank_22;
  const Scalar neg_M_right_shank_y =
      neg_M_right_shank_y_11 + left_ankle_cross_I17 * Omega_righ_ankl_cros_zx;
  const Scalar F_righ_ankl_cros_y_1 =
      neg_F_right_foot_z + left_ankle_cross_I1 * Omega_right_shank_yx;
  const Scalar F_righ_ankl_cros_y = F_righ_ankl_cros_y_1 + left_ankle_cross_I3 * t_righ_ankl_cros_6;
  const Scalar F_right_shank_y_1 = F_righ_ankl_cros_y - neg_Omega_right_shank_yy * t_right_shank_20;
  const Scalar F_right_shank_y = F_right_shank_y_1 - Omega_right_shank_yx * t_right_shank_25;
  const Scalar F_righ_ankl_cros_x_1 = F_right_foot_x + left_ankle_cross_I3 * Omega_right_foot_xz;
  const Scalar F_righ_ankl_cros_x = F_righ_ankl_cros_x_1 - left_ankle_cross_I1 * t_righ_ankl_cros_7;
  const Scalar F_right_shank_x_1 = F_righ_ankl_cros_x - Omega_right_foot_xz * t_right_shank_20;
  const Scalar F_right_shank_x = F_right_shank_x_1 + neg_Omega_right_shank_xx * t_right_shank_25;
  // right_thigh: first moment h, second moments E of (1)
  const Scalar t_right_thigh_13 = left_thigh_I11 + t_right_thigh_5;
  const Scalar t_right_thigh_14 = left_thigh_I1 * s_right_hip_pitch;
  const Scalar t_right_thigh_15 = t_right_thigh_14 + left_thigh_I2 * c_right_hip_pitch;
  const Scalar M_right_hip_fork_x_1 = t_right_thigh_13 + t_right_thigh_15;
  const Scalar t_right_hip_fork_7 = t_right_thigh_6 - t_right_thigh_11;
  const Scalar t_right_thigh_16 = left_thigh_I6 * c_right_hip_pitch;
  const Scalar t_right_thigh_17 = t_right_thigh_16 + left_thigh_I5 * s_right_hip_pitch;
  const Scalar t_right_hip_fork_8 = t_right_hip_block_1 - t_right_hip_fork_6;
  const Scalar F_right_shank_z_1 = F_righ_ankl_cros_z + Omega_right_shank_zy * t_right_shank_20;
  const Scalar F_right_shank_z = F_right_shank_z_1 - Omega_right_shank_zx * t_right_shank_25;
  // right_hip_fork: moment M of (1)
  const Scalar M_right_hip_fork_x_2 = F_right_shank_z - left_hip_fork_I13 * t_right_hip_fork_5;
  const Scalar M_right_hip_fork_x_3 =
      M_right_hip_fork_x_2 + left_hip_fork_I9 * Omega_right_thigh_xz;
  const Scalar M_right_hip_fork_x_4 = M_right_hip_fork_x_3 - s_q8_q9_q10 * neg_M_right_shank_y;
  const Scalar M_right_hip_fork_x_5 = M_right_hip_fork_x_4 + c_q8_q9_q10 * neg_M_right_shank_x;
  const Scalar M_right_hip_fork_x_6 =
      M_right_hip_fork_x_5 - t_right_thigh_8 * Omega_right_hip_fork_zx;
  const Scalar M_right_hip_fork_x_7 = M_right_hip_fork_x_6 - a_right_hip_fork_y * t_right_thigh_15;
  const Scalar M_right_hip_fork_x_8 = M_right_hip_fork_x_7 + left_hip_fork_I2 * alpha_right_thigh_z;
  const Scalar M_right_hip_fork_x_9 = t_right_hip_fork_2 - t_right_thigh_1;
  const Scalar M_right_hip_fork_x_10 = M_right_hip_fork_x_8 + left_hip_fork_I1 * t_right_hip_fork_8;
  const Scalar M_right_hip_fork_x_11 =
      M_right_hip_fork_x_10 - t_right_thigh_17 * M_right_hip_fork_x_9;
  const Scalar M_right_hip_fork_x_12 =
      M_right_hip_fork_x_11 + neg_Omega_right_thigh_zx * t_right_hip_fork_7;
  const Scalar M_right_hip_fork_x_13 =
      M_right_hip_fork_x_12 - neg_Omega_right_thigh_zy * M_right_hip_fork_x_1;
  const Scalar M_right_hip_fork_x = M_right_hip_fork_x_13 + s_right_shank_y * F_right_shank_z;
  const Scalar E_left_ankle_cross_yz = left_ankle_cross_I2 - E_left_foot_yz;
  const Scalar neg_Omega_left_foot_yy = t_left_shank_9 + t_left_foot_1;
  const Scalar t_left_ankle_cross_8 = t_left_shank_9 + t_left_ankle_cross_2;
  const Scalar F_left_foot_y = t_left_foot_2 - h_left_foot_y * neg_Omega_left_foot_yy;
  // left_ankle_cross: force F, second moments E of (1)
  const Scalar t_left_ankle_cross_9 = F_left_foot_y + left_ankle_cross_I1 * t_left_ankle_cross_6;
  const Scalar F_left_ankle_cross_z =
      t_left_ankle_cross_9 - left_ankle_cross_I3 * t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_10 = left_ankle_cross_I8 - neg_E_left_foot_xz;
  const Scalar t_left_shank_26 = t_left_shank_21 - t_left_ankle_cross_10;
  const Scalar M_left_shank_x_1 = neg_Omega_left_foot_yy - t_left_ankle_cross_8;
  const Scalar M_left_shank_x_2 = E_left_foot_yz * M_left_shank_x_1;
  const Scalar M_left_shank_x_3 = M_left_shank_x_2 + left_hip_fork_k3 * neg_F_left_foot_z;
  const Scalar M_left_shank_x_4 = t_left_shank_11 - t_left_ankle_cross_2;
  // left_shank: moment M, acceleration a of (1)
  const Scalar M_left_shank_x_5 = M_left_shank_x_3 + left_ankle_cross_I3 * neg_a_left_ankle_cross_z;
  const Scalar M_left_shank_x_6 = left_ankle_cross_I16 - t_left_shank_17;
  const Scalar M_left_shank_x_7 = M_left_shank_x_5 - left_ankle_cross_I2 * M_left_shank_x_4;
  const Scalar M_left_shank_x_8 = M_left_shank_x_7 + Omega_left_shank_yx * M_left_shank_x_6;
  const Scalar M_left_shank_x_9 = M_left_shank_x_8 - neg_a_left_foot_z * h_left_foot_y;
  const Scalar M_left_shank_x_10 = t_left_shank_10 - t_left_shank_11;
  const Scalar M_left_shank_x_11 = M_left_shank_x_9 - t_left_shank_19 * M_left_shank_x_10;
  const Scalar M_left_shank_x_12 = M_left_shank_x_11 + t_left_shank_23 * neg_a_left_shank_z;
  const Scalar M_left_shank_x_13 = M_left_shank_x_12 + left_ankle_cross_I9 * t_left_ankle_cross_4;
  const Scalar M_left_shank_x_14 = M_left_shank_x_13 + Omega_left_foot_zy * E_left_foot_yy;
  const Scalar M_left_shank_x_15 = M_left_shank_x_14 + Omega_left_shank_zy * t_left_shank_20;
  const Scalar M_left_shank_x_16 = M_left_shank_x_15 - neg_Omega_left_foot_zx * E_left_foot_xy;
  const Scalar M_left_shank_x_17 = M_left_shank_x_16 + s_left_ankle_cross_y * F_left_ankle_cross_z;
  const Scalar M_left_shank_x_18 = M_left_shank_x_17 + t_left_ankle_cross_5 * t_left_ankle_cross_10;
  const Scalar M_left_shank_x = M_left_shank_x_18 + Omega_left_shank_zx * t_left_shank_26;
  const Scalar a_left_shank_x = c_q2_q3_q4 * t_left_shank_1 + s_q2_q3_q4 * t_left_shank_3;
  // left_ankle_cross: acceleration a, moment M of (1)
  const Scalar t_left_ankle_cross_11 =
      a_left_shank_x + neg_s_left_ankle_cross_x * neg_Omega_left_shank_xx;
  const Scalar a_left_ankle_cross_x =
      t_left_ankle_cross_11 - s_left_ankle_cross_y * Omega_left_foot_xz;
  const Scalar t_left_ankle_cross_12 = left_ankle_cross_I2 - t_left_shank_19;
  // left_foot: Omega, force F, acceleration a of (1)
  const Scalar neg_Omega_left_foot_xx = t_left_ankle_cross_2 + t_left_foot_1;
  const Scalar neg_F_left_foot_x_1 = neg_Omega_left_shank_xz * h_left_foot_y;
  const Scalar neg_F_left_foot_x = h_left_foot_x * neg_Omega_left_foot_xx + neg_F_left_foot_x_1;
  const Scalar t_left_shank_27 = left_shank_I18 - t_left_shank_15;
  const Scalar t_left_ankle_cross_13 = t_left_shank_11 + t_left_ankle_cross_2;
  const Scalar a_left_foot_x_1 = a_left_ankle_cross_x - t_left_ankle_cross_13;
  const Scalar a_left_foot_x = a_left_foot_x_1 + left_hip_fork_k3 * neg_Omega_left_shank_xz;
  const Scalar M_left_foot_z_1 = neg_a_left_ankle_cross_z - left_hip_fork_k3 * t_left_hip_fork_5;
  const Scalar M_left_foot_z_2 = t_left_foot_2 - h_left_foot_x * M_left_foot_z_1;
  const Scalar M_left_foot_z_3 = M_left_foot_z_2 + t_left_ankle_cross_4 * neg_E_left_foot_xz;
  const Scalar M_left_foot_z_4 = M_left_foot_z_3 + t_left_ankle_cross_6 * E_left_foot_xx;
  const Scalar M_left_foot_z_5 = M_left_foot_z_4 - Omega_left_foot_xz * E_left_foot_yz;
  const Scalar M_left_foot_z_6 = M_left_foot_z_5 - t_left_ankle_cross_3 * E_left_foot_xy;
  const Scalar M_left_foot_z_7 = M_left_foot_z_6 - h_left_foot_y * a_left_foot_x;
  const Scalar M_left_foot_z = M_left_foot_z_7 + neg_Omega_left_shank_xz * E_left_foot_yy;
  // left_ankle_cross: moment M, force F of (1)
  const Scalar neg_M_left_shank_y_2 = F_left_foot_y + M_left_foot_z;
  const Scalar neg_M_left_shank_y_3 =
      neg_M_left_shank_y_2 - left_ankle_cross_I1 * neg_a_left_ankle_cross_z;
  const Scalar neg_M_left_shank_y_4 =
      neg_M_left_shank_y_3 + left_ankle_cross_I17 * t_left_ankle_cross_6;
  const Scalar neg_M_left_shank_y_5 = neg_M_left_shank_y_4 - t_left_shank_17 * neg_M_left_shank_y_1;
  const Scalar neg_M_left_shank_y_6 = neg_M_left_shank_y_5 - left_hip_fork_k3 * neg_F_left_foot_x;
  const Scalar neg_M_left_shank_y_7 =
      neg_M_left_shank_y_6 - left_ankle_cross_I8 * t_left_ankle_cross_4;
  const Scalar neg_M_left_shank_y_8 =
      neg_M_left_shank_y_7 + Omega_left_foot_xz * t_left_ankle_cross_12;
  const Scalar neg_M_left_shank_y_9 = neg_M_left_shank_y_8 + Omega_left_shank_zy * t_left_shank_21;
  const Scalar neg_M_left_shank_y_10 =
      neg_M_left_shank_y_9 - neg_s_left_ankle_cross_x * F_left_ankle_cross_z;
  const Scalar neg_M_left_shank_y_11 = neg_M_left_shank_y_10 + t_left_shank_25 * neg_a_left_shank_z;
  const Scalar neg_M_left_shank_y_12 =
      neg_M_left_shank_y_11 + Omega_left_shank_zx * t_left_shank_27;
  const Scalar neg_M_left_shank_y =
      neg_M_left_shank_y_12 + left_ankle_cross_I16 * t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_14 =
      neg_F_left_foot_z + left_ankle_cross_I3 * t_left_ankle_cross_8;
  const Scalar F_left_ankle_cross_y =
      t_left_ankle_cross_14 + left_ankle_cross_I1 * Omega_left_shank_yx;
  const Scalar F_left_shank_y_1 = F_left_ankle_cross_y + neg_Omega_left_shank_yy * t_left_shank_23;
  const Scalar F_left_shank_y = F_left_shank_y_1 - Omega_left_shank_yx * t_left_shank_25;
  const Scalar t_left_foot_6 = neg_F_left_foot_x + left_ankle_cross_I1 * t_left_ankle_cross_13;
  const Scalar neg_F_left_ankle_cross_x = t_left_foot_6 - left_ankle_cross_I3 * Omega_left_foot_xz;
  const Scalar neg_F_left_shank_x_1 =
      neg_F_left_ankle_cross_x - t_left_shank_25 * neg_Omega_left_shank_xx;
  const Scalar neg_F_left_shank_x = neg_F_left_shank_x_1 - Omega_left_foot_xz * t_left_shank_23;
  const Scalar t_left_hip_fork_7 = t_left_thigh_6 + t_left_thigh_16;
  const Scalar t_left_hip_fork_8 = t_left_hip_block_1 - t_left_hip_fork_5;
  const Scalar F_left_shank_z_1 = F_left_ankle_cross_z - Omega_left_shank_zx * t_left_shank_25;
  const Scalar F_left_shank_z = F_left_shank_z_1 - Omega_left_shank_zy * t_left_shank_23;
  const Scalar t_left_thigh_17 = left_thigh_I11 + t_left_thigh_7;
  // left_hip_fork: moment M of (1)
  const Scalar M_left_hip_fork_x_1 = F_left_shank_z - left_hip_fork_I13 * t_left_hip_fork_6;
  const Scalar M_left_hip_fork_x_2 = M_left_hip_fork_x_1 + left_hip_fork_I9 * Omega_left_thigh_xz;
  const Scalar M_left_hip_fork_x_3 = M_left_hip_fork_x_2 - c_q2_q3_q4 * M_left_shank_x;
  const Scalar M_left_hip_fork_x_4 = t_left_hip_fork_5 - neg_Omega_left_thigh_yy;
  const Scalar M_left_hip_fork_x_5 = M_left_hip_fork_x_3 - s_q2_q3_q4 * neg_M_left_shank_y;
  const Scalar M_left_hip_fork_x_6 = M_left_hip_fork_x_5 + t_left_thigh_11 * M_left_hip_fork_x_4;
  const Scalar M_left_hip_fork_x_7 = M_left_hip_fork_x_6 - left_hip_fork_I1 * t_left_hip_fork_8;
  const Scalar M_left_hip_fork_x_8 = left_hip_fork_I2 + 2.0f * t_left_thigh_9;
  const Scalar M_left_hip_fork_x_9 = M_left_hip_fork_x_7 + s_left_shank_y * F_left_shank_z;
  const Scalar M_left_hip_fork_x_10 =
      M_left_hip_fork_x_9 - alpha_left_thigh_z * M_left_hip_fork_x_8;
  const Scalar M_left_hip_fork_x_11 = t_left_thigh_13 + t_left_thigh_17;
  const Scalar M_left_hip_fork_x_12 = M_left_hip_fork_x_10 - a_left_hip_fork_y * t_left_thigh_13;
  const Scalar M_left_hip_fork_x_13 =
      M_left_hip_fork_x_12 - neg_Omega_left_thigh_zy * M_left_hip_fork_x_11;
  const Scalar M_left_hip_fork_x =
      M_left_hip_fork_x_13 + neg_Omega_left_thigh_zx * t_left_hip_fork_7;
  const Scalar t_left_hip_block_2 = M_right_foot_z - tau[11];
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_I1 + h_right_foot_x;
  const Scalar t_right_foot_8 = E_right_foot_xx + E_right_foot_yy;
  // right_ankle_cross: first moment h, second moments E of (1)
  const Scalar neg_h_right_shank_x = t_right_shank_25 - h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_9 = left_ankle_cross_I4 - neg_h_right_foot_y;
  const Scalar t_righ_ankl_cros_10 = t_right_foot_6 - t_righ_ankl_cros_9;
  const Scalar neg_E_righ_ankl_cros_xz = t_righ_ankl_cros_10 - left_foot_I8 * c_right_foot;
  const Scalar t_righ_ankl_cros_11 = neg_s_righ_ankl_cros_x * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_12 = left_ankle_cross_I19 * s_right_ankle_pitch;
  const Scalar neg_h_right_shank_y = left_ankle_cross_I3 - t_right_shank_20;
  // right_shank: second moments E of (1)
  const Scalar t_right_shank_27 = s_q8_q9_q10 * neg_h_right_shank_y;
  const Scalar t_right_shank_28 = t_right_shank_27 - c_q8_q9_q10 * neg_h_right_shank_x;
  const Scalar t_right_shank_29 = s_q8_q9_q10 * neg_h_right_shank_x;
  const Scalar t_right_shank_30 = t_right_shank_29 + c_q8_q9_q10 * neg_h_right_shank_y;
  const Scalar t_right_shank_31 = t_right_shank_16 + neg_E_righ_ankl_cros_xz;
  const Scalar neg_E_right_shank_xz =
      t_right_shank_31 - neg_s_righ_ankl_cros_x * neg_h_right_foot_y;
  const Scalar t_righ_ankl_cros_13 = neg_E_right_foot_yz - s_righ_ankl_cros_y * neg_h_right_foot_y;
  const Scalar neg_E_right_shank_yz = t_righ_ankl_cros_8 - t_righ_ankl_cros_13;
  const Scalar t_righ_ankl_cros_14 = E_right_foot_xx + left_foot_I6 * c_right_foot;
  const Scalar t_right_shank_32 = t_righ_ankl_cros_14 - 2.0f * t_righ_ankl_cros_11;
  const Scalar t_right_shank_33 = t_right_shank_14 - t_right_shank_32;
  const Scalar E_right_shank_xy_1 = t_right_shank_13 - neg_E_righ_ankl_cros_xy;
  const Scalar E_right_shank_xy_2 = E_right_shank_xy_1 + left_ankle_cross_I18 * c_right_ankle_pitch;
  const Scalar E_right_shank_xy = E_right_shank_xy_2 + s_righ_ankl_cros_y * h_righ_ankl_cros_x;
  const Scalar t_right_shank_34 = s_right_shank_y * t_right_shank_30;
  const Scalar t_right_shank_35 = s_right_shank_x * t_right_shank_28;
  const Scalar t_right_shank_36 = s_right_shank_x * neg_h_right_foot_y;
  const Scalar t_right_shank_37 = s_right_shank_y * neg_h_right_foot_y;
  const Scalar t_right_shank_38 = s_q8_q9_q10 * neg_E_right_shank_yz;
  const Scalar t_right_shank_39 = t_right_shank_38 - c_q8_q9_q10 * neg_E_right_shank_xz;
  const Scalar t_right_thigh_18 = t_right_thigh_8 - t_right_shank_36;
  const Scalar neg_E_right_thigh_xz = t_right_shank_39 - t_right_thigh_18;
  const Scalar qdd_6_1 = left_hip_fork_I2 + 2.0f * neg_E_right_thigh_xz;
  // left_ankle_cross: first moment h, second moments E of (1)
  const Scalar h_left_ankle_cross_x = left_ankle_cross_I1 + h_left_foot_x;
  const Scalar neg_h_left_shank_y = left_ankle_cross_I3 + t_left_shank_23;
  const Scalar t_left_ankle_cross_15 = left_ankle_cross_I4 - h_left_foot_y + t_left_foot_5;
  const Scalar t_left_ankle_cross_16 = t_left_ankle_cross_15 + left_foot_I8 * c_left_foot;
  const Scalar t_left_ankle_cross_17 = neg_s_left_ankle_cross_x * h_left_ankle_cross_x;
  const Scalar neg_h_left_shank_x = t_left_shank_25 - h_left_ankle_cross_x;
  // left_shank: second moments E of (1)
  const Scalar t_left_shank_28 = s_q2_q3_q4 * neg_h_left_shank_y;
  const Scalar t_left_shank_29 = t_left_shank_28 - c_q2_q3_q4 * neg_h_left_shank_x;
  const Scalar t_left_shank_30 = c_q2_q3_q4 * neg_h_left_shank_y;
  const Scalar t_left_shank_31 = t_left_shank_30 + s_q2_q3_q4 * neg_h_left_shank_x;
  const Scalar E_left_shank_xz_1 = t_left_shank_17 - t_left_ankle_cross_16;
  const Scalar E_left_shank_xz = E_left_shank_xz_1 - neg_s_left_ankle_cross_x * h_left_foot_y;
  const Scalar t_left_ankle_cross_18 = E_left_foot_yz - s_left_ankle_cross_y * h_left_foot_y;
  const Scalar E_left_shank_yz = t_left_ankle_cross_12 - t_left_ankle_cross_18;
  const Scalar E_left_shank_xy_1 = t_left_shank_26 + s_left_ankle_cross_y * h_left_ankle_cross_x;
  const Scalar E_left_shank_xy = E_left_shank_xy_1 + left_ankle_cross_I18 * c_left_ankle_pitch;
  const Scalar t_left_ankle_cross_19 = E_left_foot_xx + left_foot_I6 * c_left_foot;
  const Scalar t_left_shank_32 = t_left_shank_15 - t_left_ankle_cross_19;
  const Scalar t_left_shank_33 = t_left_shank_32 + 2.0f * t_left_ankle_cross_17;
  const Scalar t_left_shank_34 = t_left_shank_15 - left_ankle_cross_I19 * s_left_ankle_pitch;
  const Scalar t_left_shank_35 = t_left_shank_34 - (left_shank_I19 - t_left_shank_33);
  const Scalar t_left_shank_36 = c_q2_q3_q4 * E_left_shank_xy * 2.0f;
  const Scalar t_left_shank_37 = t_left_shank_36 - s_q2_q3_q4 * t_left_shank_35;
  const Scalar t_left_shank_38 = s_left_shank_y * t_left_shank_31;
  const Scalar t_left_shank_39 = s_left_shank_x * t_left_shank_29;
  const Scalar t_left_shank_40 = s_left_shank_y * h_left_foot_y;
  const Scalar t_left_shank_41 = s_left_shank_x * h_left_foot_y;
  const Scalar t_left_shank_42 = c_q2_q3_q4 * E_left_shank_xz - s_q2_q3_q4 * E_left_shank_yz;
  const Scalar neg_E_left_thigh_xz = t_left_shank_42 - (t_left_thigh_9 + t_left_shank_41);
  // left_hip_fork: second moments E of (1)
  const Scalar E_left_hip_fork_yy_1 = left_hip_fork_I19 - t_left_foot_4;
  const Scalar E_left_hip_fork_yy = E_left_hip_fork_yy_1 - left_foot_I7 * s_left_foot;
  const Scalar t_left_hip_fork_9 = t_left_thigh_14 - t_left_shank_33;
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_9 - 2.0f * t_left_shank_39;
  const Scalar E_left_hip_fork_xx_1 = left_hip_fork_I18 + t_left_hip_fork_10;
  const Scalar E_left_hip_fork_xx = E_left_hip_fork_xx_1 - s_q2_q3_q4 * t_left_shank_37;
  const Scalar qdd_0_1 = E_left_hip_fork_yy - E_left_hip_fork_xx;
  const Scalar t_right_foot_9 = h_right_foot_x + t_right_foot_8 - left_foot_I8 * s_right_foot;
  const Scalar t_righ_ankl_cros_15 = t_right_foot_9 - neg_s_righ_ankl_cros_x * h_right_foot_x;
  const Scalar t_righ_ankl_cros_16 = neg_E_right_foot_xz + s_righ_ankl_cros_y * h_right_foot_x;
  // right_shank
  const Scalar t_right_shank_40 = c_q8_q9_q10 * t_righ_ankl_cros_15;
  const Scalar t_right_shank_41 = s_right_shank_x * h_right_foot_x - t_right_shank_40;
  const Scalar t_right_shank_42 = t_right_shank_41 + s_q8_q9_q10 * t_righ_ankl_cros_16;
  const Scalar t_right_shank_43 = t_righ_ankl_cros_13 + c_q8_q9_q10 * t_right_shank_37;
  const Scalar t_right_shank_44 = t_right_shank_43 - s_q8_q9_q10 * t_right_shank_36;
  // right_thigh
  const Scalar t_right_thigh_19 = h_right_foot_x - c_q8_q9_q10 * t_righ_ankl_cros_16;
  const Scalar t_right_thigh_20 = t_right_thigh_19 + s_right_shank_y * h_right_foot_x;
  const Scalar t_right_thigh_21 = t_right_shank_44 + c_q8_q9_q10 * neg_h_right_foot_y;
  const Scalar t_right_thigh_22 = t_right_thigh_20 - s_q8_q9_q10 * t_righ_ankl_cros_15;
  const Scalar t_right_hip_fork_9 = s_right_hip_roll * t_right_thigh_21;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_9 + c_right_hip_roll * t_right_thigh_22;
  const Scalar t_left_ankle_cross_20 = neg_E_left_foot_xz + s_left_ankle_cross_y * h_left_foot_x;
  const Scalar t_left_foot_7 = h_left_foot_x + t_right_foot_8 - left_foot_I8 * s_left_foot;
  const Scalar t_left_ankle_cross_21 = t_left_foot_7 - neg_s_left_ankle_cross_x * h_left_foot_x;
  // left_shank
  const Scalar t_left_shank_43 = s_q2_q3_q4 * t_left_ankle_cross_20;
  const Scalar t_left_shank_44 = s_left_shank_x * h_left_foot_x + t_left_shank_43;
  const Scalar t_left_shank_45 = t_left_shank_44 - c_q2_q3_q4 * t_left_ankle_cross_21;
  const Scalar t_left_shank_46 = t_left_ankle_cross_18 + c_q2_q3_q4 * t_left_shank_40;
  const Scalar t_left_shank_47 = t_left_shank_46 - s_q2_q3_q4 * t_left_shank_41;
  // left_thigh
  const Scalar t_left_thigh_18 = h_left_foot_x - c_q2_q3_q4 * t_left_ankle_cross_20;
  const Scalar t_left_thigh_19 = t_left_thigh_18 + s_left_shank_y * h_left_foot_x;
  const Scalar t_left_thigh_20 = t_left_thigh_19 - s_q2_q3_q4 * t_left_ankle_cross_21;
  const Scalar t_left_thigh_21 = t_left_shank_47 + c_q2_q3_q4 * h_left_foot_y;
  const Scalar t_left_hip_fork_11 = c_left_hip_roll * t_left_thigh_20;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_11 - s_left_hip_roll * t_left_thigh_21;
  const Scalar t_left_shank_48 = s_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_shank_49 = left_ankle_cross_I3 * c_q2_q3_q4 - t_left_shank_48;
  const Scalar t_left_ankle_cross_22 = left_ankle_cross_I15 + t_left_ankle_cross_19;
  const Scalar t_left_shank_50 = c_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_shank_51 = left_ankle_cross_I3 * s_q2_q3_q4 + t_left_shank_50;
  // right_foot: 1/pivot of (1)
  const Scalar inverse_pivot_right_foot = 1.0f / t_right_foot_8;
  const Scalar t_right_foot_10 = t_right_hip_fork_10 * inverse_pivot_right_foot;
  const Scalar t_right_foot_11 = neg_E_right_foot_yz * inverse_pivot_right_foot;
  // right_shank
  const Scalar t_right_shank_45 = c_q8_q9_q10 * neg_E_righ_ankl_cros_xz;
  const Scalar t_right_shank_46 = left_ankle_cross_I3 * c_q8_q9_q10;
  const Scalar t_right_shank_47 = t_right_shank_46 - s_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_right_shank_48 = left_ankle_cross_I3 * s_q8_q9_q10;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_17 = left_ankle_cross_I15 + t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_18 = t_righ_ankl_cros_11 - t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_19 =
      t_righ_ankl_cros_18 + left_ankle_cross_I18 * s_right_ankle_pitch;
  // right_shank
  const Scalar t_right_shank_49 = t_right_shank_48 + c_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_right_shank_50 = t_righ_ankl_cros_19 + s_right_shank_x * t_right_shank_49;
  const Scalar t_right_shank_51 = t_right_shank_50 - s_right_shank_y * t_right_shank_47;
  const Scalar t_right_shank_52 = t_right_shank_45 - s_q8_q9_q10 * neg_E_righ_ankl_cros_yz;
  const Scalar t_right_hip_fork_11 = s_right_hip_roll * (t_right_shank_47 - t_right_shank_51);
  const Scalar t_right_hip_fork_12 = c_right_hip_roll * t_right_shank_52 - t_right_hip_fork_11;
  // right_foot
  const Scalar t_right_foot_12 = t_right_hip_fork_12 + t_right_hip_fork_10 * t_right_foot_11;
  const Scalar t_right_foot_13 = t_righ_ankl_cros_13 * inverse_pivot_right_foot;
  const Scalar t_right_foot_14 = t_right_shank_42 * inverse_pivot_right_foot;
  const Scalar t_right_shank_53 = c_q8_q9_q10 * neg_E_righ_ankl_cros_yz;
  const Scalar t_right_shank_54 = t_right_shank_53 + s_q8_q9_q10 * neg_E_righ_ankl_cros_xz;
  const Scalar t_right_foot_15 = t_right_shank_54 - t_right_shank_42 * t_right_foot_11;
  const Scalar t_right_foot_16 = t_righ_ankl_cros_19 + t_righ_ankl_cros_13 * t_right_foot_11;
  const Scalar t_right_foot_17 = t_right_shank_44 * inverse_pivot_right_foot;
  const Scalar t_right_foot_18 = t_right_shank_51 + t_right_shank_44 * t_right_foot_11;
  const Scalar t_right_foot_19 = t_righ_ankl_cros_17 - neg_E_right_foot_yz * t_right_foot_11;
  // right_ankle_cross: 1/pivot of (1)
  const Scalar t_righ_ankl_cros_20 = 1.0f / t_right_foot_19;
  const Scalar t_righ_ankl_cros_21 = t_right_foot_15 * t_righ_ankl_cros_20;
  const Scalar t_righ_ankl_cros_22 = t_right_foot_16 * t_righ_ankl_cros_20;
  const Scalar t_right_shank_55 = left_shank_I20 - t_righ_ankl_cros_12 + t_right_shank_32;
  const Scalar t_right_shank_56 = t_right_shank_34 - t_right_shank_35 + t_right_shank_55;
  const Scalar t_righ_ankl_cros_23 = t_right_foot_12 * t_righ_ankl_cros_20;
  const Scalar t_right_hip_fork_13 = s_right_hip_roll * (t_right_shank_30 + t_right_shank_56);
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_13 + c_right_hip_roll * t_right_shank_39;
  const Scalar t_right_foot_20 = t_right_hip_fork_14 - t_righ_ankl_cros_13 * t_right_foot_10;
  const Scalar t_righ_ankl_cros_24 = t_right_foot_20 - t_right_foot_12 * t_righ_ankl_cros_22;
  const Scalar t_right_shank_57 = c_q8_q9_q10 * neg_E_right_shank_yz;
  const Scalar t_right_shank_58 = t_right_shank_57 + s_q8_q9_q10 * neg_E_right_shank_xz;
  const Scalar t_righ_ankl_cros_25 = t_right_shank_58 + t_right_foot_15 * t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_26 = t_righ_ankl_cros_25 - t_right_shank_42 * t_right_foot_13;
  const Scalar t_righ_ankl_cros_27 = t_right_shank_56 - t_right_foot_18 * t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_28 = t_righ_ankl_cros_27 - t_righ_ankl_cros_13 * t_right_foot_17;
  const Scalar t_right_foot_21 = t_right_shank_55 - t_righ_ankl_cros_13 * t_right_foot_13;
  const Scalar t_righ_ankl_cros_29 = t_right_foot_21 - t_right_foot_16 * t_righ_ankl_cros_22;
  const Scalar t_right_shank_59 = 1.0f / t_righ_ankl_cros_29;
  const Scalar t_right_shank_60 = t_righ_ankl_cros_28 * t_right_shank_59;
  // right_thigh: first moment h of (1)
  const Scalar h_right_thigh_y = t_right_thigh_15 + t_right_shank_30;
  const Scalar t_right_thigh_23 = t_right_thigh_9 - 2.0f * t_right_shank_35;
  const Scalar t_right_thigh_24 = t_right_thigh_13 + t_right_shank_55 + t_right_thigh_23;
  const Scalar t_right_thigh_25 = t_right_thigh_24 + 2.0f * t_right_shank_34;
  const Scalar t_right_hip_fork_15 = s_right_hip_roll * (h_right_thigh_y + t_right_thigh_25);
  const Scalar t_right_hip_fork_16 = c_right_hip_roll * neg_E_right_thigh_xz + t_right_hip_fork_15;
  const Scalar t_right_foot_22 = t_right_hip_fork_16 - t_right_hip_fork_10 * t_right_foot_17;
  const Scalar t_righ_ankl_cros_30 = t_right_foot_22 - t_right_foot_18 * t_righ_ankl_cros_23;
  const Scalar t_right_shank_61 = t_righ_ankl_cros_30 - t_righ_ankl_cros_24 * t_right_shank_60;
  const Scalar t_righ_ankl_cros_31 = t_right_foot_18 * t_righ_ankl_cros_20;
  // right_shank
  const Scalar t_right_shank_62 = t_right_thigh_25 - t_righ_ankl_cros_28 * t_right_shank_60;
  const Scalar t_right_shank_63 = t_right_shank_62 - t_right_shank_44 * t_right_foot_17;
  const Scalar t_right_shank_64 = t_righ_ankl_cros_26 * t_right_shank_59;
  const Scalar E_right_thigh_yz = t_right_thigh_17 - t_right_shank_37 + t_right_shank_58;
  const Scalar t_right_shank_65 = E_right_thigh_yz + t_right_foot_18 * t_righ_ankl_cros_21;
  const Scalar t_right_shank_66 = t_right_shank_65 - t_righ_ankl_cros_28 * t_right_shank_64;
  const Scalar t_right_shank_67 = t_right_shank_66 - t_right_shank_44 * t_right_foot_14;
  const Scalar t_right_shank_68 = t_right_shank_63 - t_right_foot_18 * t_righ_ankl_cros_31;
  const Scalar t_right_thigh_26 = 1.0f / t_right_shank_68;
  const Scalar t_right_thigh_27 = t_right_shank_67 * t_right_thigh_26;
  const Scalar t_right_shank_69 = left_shank_I19 - t_right_shank_14 + t_righ_ankl_cros_12;
  const Scalar t_right_shank_70 = s_q8_q9_q10 * (t_right_shank_33 - t_right_shank_69);
  const Scalar t_right_shank_71 = c_q8_q9_q10 * E_right_shank_xy * 2.0f - t_right_shank_70;
  // right_hip_fork: second moments E of (1)
  const Scalar t_right_hip_fork_17 = left_hip_fork_I9 - t_right_hip_fork_7;
  const Scalar t_right_hip_fork_18 = t_right_shank_28 - t_right_hip_fork_17;
  const Scalar t_right_hip_fork_19 = E_right_shank_xy + t_right_hip_fork_18;
  const Scalar t_right_hip_fork_20 = t_right_hip_fork_19 - s_right_shank_x * t_right_shank_30;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_20 - c_q8_q9_q10 * t_right_shank_71;
  const Scalar t_right_thigh_28 = t_right_shank_61 * t_right_thigh_26;
  const Scalar neg_E_right_hip_fork_xz = t_right_hip_fork_21 + s_right_shank_y * t_right_shank_28;
  const Scalar t_right_hip_fork_22 = c_right_hip_roll * neg_E_right_hip_fork_xz;
  const Scalar neg_E_right_hip_fork_yz = left_hip_fork_I1 - neg_h_right_foot_y + E_right_thigh_yz;
  const Scalar t_right_foot_23 = t_right_hip_fork_22 + t_right_shank_42 * t_right_foot_10;
  const Scalar t_right_foot_24 = t_right_foot_23 - s_right_hip_roll * neg_E_right_hip_fork_yz;
  // right_thigh
  const Scalar t_right_thigh_29 = t_right_foot_24 + t_right_shank_67 * t_right_thigh_28;
  const Scalar t_right_thigh_30 = t_right_thigh_29 - t_right_foot_15 * t_righ_ankl_cros_23;
  const Scalar t_right_thigh_31 = t_right_thigh_30 + t_righ_ankl_cros_24 * t_right_shank_64;
  // right_hip_fork
  const Scalar t_right_hip_fork_23 = t_right_foot_5 - left_foot_I7 * s_right_foot;
  const Scalar t_right_hip_fork_24 = t_right_shank_33 - t_right_thigh_23;
  const Scalar t_right_hip_fork_25 = t_right_hip_fork_24 + s_q8_q9_q10 * t_right_shank_71;
  const Scalar t_right_hip_fork_26 = left_hip_fork_I16 + t_right_hip_fork_23;
  const Scalar t_right_hip_fork_27 = t_right_hip_fork_25 - t_right_hip_fork_26;
  // right_thigh
  const Scalar t_right_thigh_32 = t_right_hip_fork_27 + t_right_foot_15 * t_righ_ankl_cros_21;
  const Scalar t_right_thigh_33 = t_right_thigh_32 + t_right_shank_67 * t_right_thigh_27;
  const Scalar t_right_thigh_34 = t_right_thigh_33 + t_righ_ankl_cros_26 * t_right_shank_64;
  const Scalar t_right_thigh_35 = t_right_thigh_34 + t_right_shank_42 * t_right_foot_14;
  // right_hip_fork: 1/pivot of (1)
  const Scalar t_right_hip_fork_28 = 1.0f / t_right_thigh_35;
  const Scalar qdd_6_2 = t_right_hip_fork_25 - (left_hip_fork_I17 - t_right_hip_fork_23);
  const Scalar t_right_hip_fork_29 = t_right_thigh_31 * t_right_hip_fork_28;
  const Scalar t_right_shank_72 = t_righ_ankl_cros_24 * t_right_shank_59;
  const Scalar qdd_6_3 = s_right_hip_roll * qdd_6_1 + c_right_hip_roll * qdd_6_2;
  const Scalar qdd_6_4 = left_hip_block_I3 + t_right_thigh_25 + c_right_hip_roll * qdd_6_3;
  const Scalar qdd_6_5 = qdd_6_4 + 2.0f * h_right_thigh_y;
  const Scalar qdd_6_6 = qdd_6_5 - t_right_foot_12 * t_righ_ankl_cros_23;
  const Scalar qdd_6_7 = qdd_6_6 - t_right_hip_fork_10 * t_right_foot_10;
  const Scalar qdd_6_8 = qdd_6_7 + t_right_thigh_31 * t_right_hip_fork_29;
  const Scalar qdd_6_9 = qdd_6_8 - t_righ_ankl_cros_24 * t_right_shank_72;
  const Scalar qdd_6_10 = 1.0f / (qdd_6_9 - t_right_shank_61 * t_right_thigh_28);
  const Scalar t_left_foot_8 = t_left_shank_45 * inverse_pivot_right_foot;
  const Scalar t_left_foot_9 = t_left_shank_47 * inverse_pivot_right_foot;
  const Scalar t_left_ankle_cross_23 = t_left_ankle_cross_17 - t_left_ankle_cross_22;
  const Scalar t_left_ankle_cross_24 =
      t_left_ankle_cross_23 + left_ankle_cross_I18 * s_left_ankle_pitch;
  const Scalar t_left_shank_52 = t_left_ankle_cross_24 - s_left_shank_y * t_left_shank_49;
  const Scalar t_left_shank_53 = t_left_shank_52 + s_left_shank_x * t_left_shank_51;
  const Scalar t_left_foot_10 = E_left_foot_yz * inverse_pivot_right_foot;
  const Scalar t_left_foot_11 = t_left_hip_fork_12 * inverse_pivot_right_foot;
  const Scalar t_left_shank_54 = c_q2_q3_q4 * t_left_ankle_cross_16;
  const Scalar t_left_hip_fork_13 = s_left_hip_roll * (t_left_shank_49 - t_left_shank_53);
  const Scalar t_left_shank_55 = t_left_shank_54 + s_q2_q3_q4 * E_left_ankle_cross_yz;
  // left_foot
  const Scalar t_left_foot_12 = t_left_hip_fork_13 + t_left_hip_fork_12 * t_left_foot_10;
  const Scalar t_left_foot_13 = t_left_foot_12 - c_left_hip_roll * t_left_shank_55;
  const Scalar t_left_foot_14 = t_left_ankle_cross_18 * inverse_pivot_right_foot;
  const Scalar t_left_shank_56 = s_q2_q3_q4 * t_left_ankle_cross_16;
  const Scalar t_left_shank_57 = t_left_shank_56 - c_q2_q3_q4 * E_left_ankle_cross_yz;
  const Scalar t_left_foot_15 = t_left_shank_57 + E_left_foot_yz * t_left_foot_8;
  const Scalar t_left_foot_16 = t_left_shank_53 + E_left_foot_yz * t_left_foot_9;
  const Scalar t_left_foot_17 = t_left_ankle_cross_24 + E_left_foot_yz * t_left_foot_14;
  const Scalar t_left_foot_18 = t_left_ankle_cross_22 - E_left_foot_yz * t_left_foot_10;
  const Scalar t_left_ankle_cross_25 = 1.0f / t_left_foot_18;
  const Scalar t_left_ankle_cross_26 = t_left_foot_16 * t_left_ankle_cross_25;
  // left_shank
  const Scalar t_left_shank_58 = left_shank_I20 + t_left_shank_34;
  const Scalar t_left_shank_59 = t_left_shank_33 - t_left_shank_58;
  const Scalar t_left_shank_60 = t_left_shank_59 - (t_left_shank_38 - t_left_shank_39);
  const Scalar t_left_ankle_cross_27 = t_left_foot_17 * t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_28 = t_left_foot_13 * t_left_ankle_cross_25;
  const Scalar t_left_hip_fork_14 = s_left_hip_roll * (t_left_shank_31 - t_left_shank_60);
  const Scalar t_left_hip_fork_15 = c_left_hip_roll * t_left_shank_42 + t_left_hip_fork_14;
  const Scalar t_left_foot_19 = t_left_hip_fork_15 + t_left_ankle_cross_18 * t_left_foot_11;
  const Scalar t_left_ankle_cross_29 = t_left_foot_19 + t_left_foot_13 * t_left_ankle_cross_27;
  const Scalar t_left_shank_61 = s_q2_q3_q4 * E_left_shank_xz + c_q2_q3_q4 * E_left_shank_yz;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_30 = t_left_shank_61 - t_left_foot_15 * t_left_ankle_cross_27;
  const Scalar t_left_ankle_cross_31 = t_left_ankle_cross_30 - t_left_shank_45 * t_left_foot_14;
  const Scalar t_left_ankle_cross_32 = t_left_foot_15 * t_left_ankle_cross_25;
  const Scalar t_left_foot_20 = t_left_shank_59 + t_left_ankle_cross_18 * t_left_foot_14;
  const Scalar t_left_foot_21 = t_left_shank_60 + t_left_shank_47 * t_left_foot_14;
  const Scalar t_left_ankle_cross_33 = t_left_foot_21 + t_left_foot_16 * t_left_ankle_cross_27;
  const Scalar t_left_ankle_cross_34 = t_left_foot_20 + t_left_foot_17 * t_left_ankle_cross_27;
  // left_shank: 1/pivot of (1)
  const Scalar t_left_shank_62 = 1.0f / t_left_ankle_cross_34;
  const Scalar t_left_shank_63 = t_left_ankle_cross_29 * t_left_shank_62;
  const Scalar t_left_shank_64 = t_left_ankle_cross_33 * t_left_shank_62;
  // left_thigh: first moment h, second moments E of (1)
  const Scalar h_left_thigh_y = t_left_thigh_13 + t_left_shank_31;
  const Scalar t_left_thigh_22 = t_left_thigh_17 + t_left_hip_fork_10 + t_left_shank_58;
  const Scalar t_left_thigh_23 = t_left_thigh_22 + 2.0f * t_left_shank_38;
  const Scalar t_left_hip_fork_16 = s_left_hip_roll * (h_left_thigh_y + t_left_thigh_23);
  const Scalar t_left_hip_fork_17 = c_left_hip_roll * neg_E_left_thigh_xz + t_left_hip_fork_16;
  const Scalar t_left_foot_22 = t_left_hip_fork_17 + t_left_hip_fork_12 * t_left_foot_9;
  const Scalar t_left_shank_65 = t_left_foot_22 - t_left_ankle_cross_29 * t_left_shank_64;
  const Scalar t_left_shank_66 = t_left_shank_65 + t_left_foot_13 * t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_35 = t_left_thigh_23 - t_left_foot_16 * t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_36 = t_left_ankle_cross_35 - t_left_shank_47 * t_left_foot_9;
  const Scalar neg_E_left_thigh_yz = t_left_thigh_11 - t_left_shank_40 + t_left_shank_61;
  // left_shank
  const Scalar t_left_shank_67 = neg_E_left_thigh_yz - t_left_ankle_cross_31 * t_left_shank_64;
  const Scalar t_left_shank_68 = t_left_shank_67 - t_left_foot_16 * t_left_ankle_cross_32;
  const Scalar t_left_shank_69 = t_left_shank_68 - t_left_shank_45 * t_left_foot_9;
  const Scalar t_left_shank_70 = t_left_ankle_cross_36 + t_left_ankle_cross_33 * t_left_shank_64;
  const Scalar inverse_pivot_left_thigh = 1.0f / t_left_shank_70;
  const Scalar t_left_thigh_24 = t_left_shank_69 * inverse_pivot_left_thigh;
  // left_hip_fork: second moments E of (1)
  const Scalar E_left_hip_fork_yz = left_hip_fork_I1 - h_left_foot_y + neg_E_left_thigh_yz;
  const Scalar t_left_hip_fork_18 = t_left_shank_29 - (left_hip_fork_I9 - t_left_hip_fork_7);
  const Scalar t_left_hip_fork_19 = E_left_shank_xy + t_left_hip_fork_18;
  const Scalar t_left_hip_fork_20 = t_left_hip_fork_19 - c_q2_q3_q4 * t_left_shank_37;
  const Scalar t_left_hip_fork_21 = t_left_hip_fork_20 - s_left_shank_x * t_left_shank_31;
  // left_thigh
  const Scalar t_left_thigh_25 = t_left_shank_66 * t_left_thigh_24;
  const Scalar t_left_thigh_26 = s_left_hip_roll * E_left_hip_fork_yz - t_left_thigh_25;
  const Scalar t_left_thigh_27 = t_left_thigh_26 + t_left_foot_15 * t_left_ankle_cross_28;
  const Scalar t_left_thigh_28 = t_left_thigh_27 + t_left_shank_45 * t_left_foot_11;
  const Scalar neg_E_left_hip_fork_xz = t_left_hip_fork_21 + s_left_shank_y * t_left_shank_29;
  const Scalar t_left_thigh_29 = t_left_thigh_28 + t_left_ankle_cross_31 * t_left_shank_63;
  const Scalar t_left_thigh_30 = t_left_thigh_29 + c_left_hip_roll * neg_E_left_hip_fork_xz;
  const Scalar t_left_shank_71 = t_left_ankle_cross_31 * t_left_shank_62;
  const Scalar t_left_hip_fork_22 = E_left_hip_fork_yy + E_left_hip_fork_xx;
  const Scalar t_left_thigh_31 = t_left_hip_fork_22 - t_left_foot_15 * t_left_ankle_cross_32;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + t_left_ankle_cross_31 * t_left_shank_71;
  const Scalar t_left_thigh_33 = t_left_thigh_32 - t_left_shank_69 * t_left_thigh_24;
  const Scalar t_left_thigh_34 = t_left_thigh_33 - t_left_shank_45 * t_left_foot_8;
  const Scalar t_left_hip_fork_23 = 1.0f / t_left_thigh_34;
  const Scalar t_left_hip_fork_24 = t_left_thigh_30 * t_left_hip_fork_23;
  const Scalar t_left_thigh_35 = t_left_shank_66 * inverse_pivot_left_thigh;
  // left_hip_fork
  const Scalar qdd_0_2 = s_left_hip_roll * (left_hip_fork_I2 - 2.0f * neg_E_left_thigh_xz);
  const Scalar qdd_0_3 = left_hip_block_I3 + t_left_thigh_23 + 2.0f * h_left_thigh_y;
  const Scalar qdd_0_4 = qdd_0_3 - t_left_thigh_30 * t_left_hip_fork_24;
  const Scalar qdd_0_5 = qdd_0_4 - t_left_hip_fork_12 * t_left_foot_11;
  const Scalar qdd_0_6 = qdd_0_5 + t_left_ankle_cross_29 * t_left_shank_63;
  const Scalar qdd_0_7 = qdd_0_6 - t_left_foot_13 * t_left_ankle_cross_28;
  const Scalar qdd_0_8 = qdd_0_7 - t_left_shank_66 * t_left_thigh_35;
  const Scalar qdd_0_9 = c_left_hip_roll * qdd_0_1 - qdd_0_2;
  const Scalar qdd_0_10 = 1.0f / (qdd_0_8 + c_left_hip_roll * qdd_0_9);
  // right_ankle_cross: moment M of (1)
  const Scalar M_righ_ankl_cros_z_1 = neg_F_right_foot_z + left_ankle_cross_I14 * t_right_shank_10;
  const Scalar M_righ_ankl_cros_z_2 =
      M_righ_ankl_cros_z_1 + left_ankle_cross_I15 * alpha_right_thigh_z;
  const Scalar M_righ_ankl_cros_z_3 =
      M_righ_ankl_cros_z_2 + left_ankle_cross_I3 * a_righ_ankl_cros_x;
  const Scalar M_righ_ankl_cros_z_4 =
      M_righ_ankl_cros_z_3 - neg_Omega_right_foot_xy * neg_E_righ_ankl_cros_yz;
  const Scalar M_righ_ankl_cros_z_5 = M_righ_ankl_cros_z_4 + h_right_foot_x * neg_a_right_foot_z;
  const Scalar M_righ_ankl_cros_z_6 =
      M_righ_ankl_cros_z_5 + left_ankle_cross_I8 * t_righ_ankl_cros_1;
  const Scalar M_righ_ankl_cros_z_7 =
      M_righ_ankl_cros_z_6 + left_ankle_cross_I1 * a_righ_ankl_cros_y;
  const Scalar M_righ_ankl_cros_z_8 =
      M_righ_ankl_cros_z_7 + neg_Omega_right_foot_zx * E_right_foot_xx;
  const Scalar M_righ_ankl_cros_z_9 = M_righ_ankl_cros_z_8 - neg_E_right_foot_xz * t_right_foot_7;
  const Scalar M_righ_ankl_cros_z_10 =
      M_righ_ankl_cros_z_9 - left_ankle_cross_I16 * neg_Omega_right_shank_yz;
  const Scalar M_righ_ankl_cros_z =
      M_righ_ankl_cros_z_10 + Omega_right_foot_zy * neg_E_right_foot_xy;
  const Scalar t_left_hip_block_3 = tau[10] - M_righ_ankl_cros_z;
  const Scalar t_left_hip_block_4 = t_left_hip_block_3 + t_left_hip_block_2 * t_right_foot_11;
  // right_shank: moment M of (1)
  const Scalar M_right_shank_z_1 = M_righ_ankl_cros_z - t_right_shank_20 * a_right_shank_x;
  const Scalar M_right_shank_z_2 = M_right_shank_z_1 + neg_Omega_right_foot_xy * t_right_shank_18;
  const Scalar M_right_shank_z_3 = M_right_shank_z_2 - neg_s_righ_ankl_cros_x * F_righ_ankl_cros_y;
  const Scalar M_right_shank_z_4 = M_right_shank_z_3 + neg_Omega_right_shank_yz * t_right_shank_16;
  const Scalar M_right_shank_z_5 = M_right_shank_z_4 + Omega_right_foot_xz * t_right_shank_26;
  const Scalar M_right_shank_z_6 = M_right_shank_z_5 + Omega_right_shank_yx * t_right_shank_21;
  const Scalar M_right_shank_z_7 = M_right_shank_z_6 - t_right_shank_25 * a_right_shank_y;
  const Scalar M_right_shank_z_8 = M_right_shank_z_7 - s_righ_ankl_cros_y * F_righ_ankl_cros_x;
  const Scalar M_right_shank_z = M_right_shank_z_8 - t_right_shank_13 * t_righ_ankl_cros_1;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_5 = tau[9] - M_right_shank_z;
  const Scalar t_left_hip_block_6 = t_left_hip_block_5 + t_righ_ankl_cros_22 * t_left_hip_block_4;
  const Scalar t_left_hip_block_7 = t_left_hip_block_6 + t_left_hip_block_2 * t_right_foot_13;
  const Scalar t_left_hip_block_8 = t_righ_ankl_cros_20 * t_left_hip_block_4;
  const Scalar t_right_shank_73 = c_q8_q9_q10 * F_right_shank_x - s_q8_q9_q10 * F_right_shank_y;
  const Scalar M_right_thigh_z_1 = c_q8_q9_q10 * F_right_shank_y + s_q8_q9_q10 * F_right_shank_x;
  // right_thigh: moment M of (1)
  const Scalar M_right_thigh_z_2 = M_right_shank_z + Omega_right_thigh_yz * t_right_thigh_8;
  const Scalar M_right_thigh_z_3 = M_right_thigh_z_2 - s_right_shank_x * M_right_thigh_z_1;
  const Scalar M_right_thigh_z_4 = M_right_thigh_z_3 - t_right_hip_block_1 * t_right_thigh_11;
  const Scalar M_right_thigh_z_5 = M_right_thigh_z_4 + t_right_hip_fork_3 * t_right_thigh_6;
  const Scalar M_right_thigh_z_6 = M_right_thigh_z_5 + t_right_thigh_9 * Omega_right_hip_fork_zx;
  const Scalar M_right_thigh_z_7 = M_right_thigh_z_6 - Omega_right_thigh_xz * t_right_thigh_17;
  const Scalar M_right_thigh_z_8 = M_right_thigh_z_7 + neg_a_right_hip_fork_x * t_right_thigh_15;
  const Scalar M_right_thigh_z = M_right_thigh_z_8 + s_right_shank_y * t_right_shank_73;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_9 = tau[8] - M_right_thigh_z;
  const Scalar t_left_hip_block_10 = t_left_hip_block_9 + t_right_foot_18 * t_left_hip_block_8;
  const Scalar t_left_hip_block_11 = t_left_hip_block_10 - t_right_shank_60 * t_left_hip_block_7;
  const Scalar t_left_hip_block_12 = t_left_hip_block_11 + t_left_hip_block_2 * t_right_foot_17;
  const Scalar t_left_hip_block_13 = t_right_shank_59 * t_left_hip_block_7;
  const Scalar t_left_hip_block_14 = tau[7] + left_hip_fork_G1 * c_right_hip_roll;
  const Scalar t_left_hip_block_15 = t_left_hip_block_14 - s_q8_q9_q10 * neg_M_right_shank_x;
  const Scalar t_left_hip_block_16 = t_left_hip_block_15 - c_q8_q9_q10 * neg_M_right_shank_y;
  const Scalar t_right_hip_fork_30 = t_right_hip_fork_3 - t_right_hip_fork_8;
  const Scalar t_left_hip_block_17 = t_left_hip_block_16 - left_hip_fork_I15 * Omega_right_thigh_xz;
  const Scalar t_left_hip_block_18 = t_left_hip_block_17 + left_hip_fork_I7 * t_right_hip_fork_30;
  const Scalar t_left_hip_block_19 = t_left_hip_block_18 + t_right_thigh_27 * t_left_hip_block_12;
  const Scalar t_left_hip_block_20 = t_left_hip_block_19 - t_left_hip_block_2 * t_right_foot_14;
  const Scalar t_left_hip_block_21 =
      t_left_hip_block_20 + neg_Omega_right_thigh_zy * t_right_thigh_6;
  const Scalar t_left_hip_block_22 =
      t_left_hip_block_21 + t_righ_ankl_cros_26 * t_left_hip_block_13;
  const Scalar t_left_hip_block_23 = left_hip_fork_G2 + left_hip_fork_p1 * t_right_thigh_11;
  const Scalar t_left_hip_block_24 = t_left_hip_block_22 - t_right_thigh_8 * t_right_thigh_12;
  const Scalar t_left_hip_block_25 = t_left_hip_block_24 - s_right_hip_roll * t_left_hip_block_23;
  const Scalar t_left_hip_block_26 = t_left_hip_block_25 + t_right_foot_15 * t_left_hip_block_8;
  const Scalar t_left_hip_block_27 = t_left_hip_block_26 + s_right_shank_x * F_right_shank_z;
  const Scalar t_left_hip_block_28 =
      t_left_hip_block_27 - neg_Omega_right_thigh_zx * t_right_thigh_9;
  const Scalar t_left_hip_block_29 = t_right_hip_fork_28 * t_left_hip_block_28;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_36 = t_right_shank_73 + M_right_thigh_z;
  const Scalar t_right_thigh_37 = t_right_thigh_36 - left_hip_fork_I1 * Omega_right_thigh_xz;
  const Scalar t_right_thigh_38 = t_right_thigh_37 + left_hip_fork_I14 * alpha_right_thigh_z;
  const Scalar t_right_thigh_39 = t_right_thigh_38 - left_hip_fork_I2 * t_right_hip_fork_5;
  const Scalar t_right_thigh_40 = t_right_thigh_39 - left_hip_fork_I9 * t_right_hip_fork_3;
  // left_hip_block: qdd of (1)
  const Scalar qdd_6_11 = tau[6] - c_right_hip_roll * M_right_hip_fork_x;
  const Scalar qdd_6_12 = qdd_6_11 + t_right_thigh_31 * t_left_hip_block_29;
  const Scalar qdd_6_13 = qdd_6_12 - t_right_thigh_28 * t_left_hip_block_12;
  const Scalar qdd_6_14 = qdd_6_13 - t_righ_ankl_cros_24 * t_left_hip_block_13;
  const Scalar neg_M_right_hip_fork_y =
      t_right_thigh_40 + t_right_thigh_11 * neg_Omega_right_thigh_xx;
  const Scalar qdd_6_15 = qdd_6_14 + t_right_foot_12 * t_left_hip_block_8;
  const Scalar qdd_6_16 = qdd_6_15 - s_right_hip_roll * neg_M_right_hip_fork_y;
  const Scalar qdd_6 = qdd_6_10 * (qdd_6_16 + t_left_hip_block_2 * t_right_foot_10);
  qdd[6] = qdd_6;
  const Scalar neg_qdd_7 = t_left_hip_block_29 - t_right_hip_fork_29 * qdd_6;
  qdd[7] = -neg_qdd_7;
  const Scalar qdd_8_1 = t_left_hip_block_12 - t_right_shank_61 * qdd_6;
  const Scalar qdd_8 = t_right_thigh_26 * qdd_8_1 - t_right_thigh_27 * neg_qdd_7;
  qdd[8] = qdd_8;
  const Scalar qdd_9_1 = t_left_hip_block_13 - t_right_shank_72 * qdd_6;
  const Scalar qdd_9 = qdd_9_1 - t_right_shank_64 * neg_qdd_7 - t_right_shank_60 * qdd_8;
  qdd[9] = qdd_9;
  const Scalar qdd_10_1 = t_left_hip_block_8 + t_righ_ankl_cros_23 * qdd_6;
  const Scalar qdd_10_2 = qdd_10_1 - t_righ_ankl_cros_21 * neg_qdd_7;
  const Scalar qdd_10 = qdd_10_2 + t_righ_ankl_cros_22 * qdd_9 + t_righ_ankl_cros_31 * qdd_8;
  qdd[10] = qdd_10;
  const Scalar neg_qdd_11_1 = t_left_hip_block_2 + t_righ_ankl_cros_13 * qdd_9;
  const Scalar neg_qdd_11_2 = neg_qdd_11_1 + t_right_hip_fork_10 * qdd_6;
  const Scalar neg_qdd_11_3 = neg_qdd_11_2 + t_right_shank_42 * neg_qdd_7;
  const Scalar neg_qdd_11_4 = neg_qdd_11_3 + t_right_shank_44 * qdd_8;
  qdd[11] = -inverse_pivot_right_foot * (neg_qdd_11_4 + neg_E_right_foot_yz * qdd_10);
  const Scalar t_left_hip_block_30 = M_left_foot_z - tau[5];
  const Scalar t_left_hip_block_31 = inverse_pivot_right_foot * t_left_hip_block_30;
  // left_ankle_cross: moment M of (1)
  const Scalar t_left_ankle_cross_37 = t_left_shank_9 - t_left_shank_11;
  const Scalar t_left_ankle_cross_38 = neg_F_left_foot_z + left_ankle_cross_I14 * t_left_shank_12;
  const Scalar t_left_ankle_cross_39 =
      t_left_ankle_cross_38 + left_ankle_cross_I15 * alpha_left_thigh_z;
  const Scalar t_left_ankle_cross_40 =
      t_left_ankle_cross_39 + left_ankle_cross_I1 * a_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_41 =
      t_left_ankle_cross_40 + left_ankle_cross_I3 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_42 =
      t_left_ankle_cross_41 + neg_Omega_left_foot_zx * E_left_foot_xx;
  const Scalar t_left_ankle_cross_43 = t_left_ankle_cross_42 - Omega_left_foot_zy * E_left_foot_xy;
  const Scalar t_left_ankle_cross_44 =
      t_left_ankle_cross_43 + left_ankle_cross_I16 * neg_Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_45 =
      t_left_ankle_cross_44 + left_ankle_cross_I8 * t_left_ankle_cross_37;
  const Scalar t_left_ankle_cross_46 =
      t_left_ankle_cross_45 + neg_Omega_left_shank_xz * E_left_ankle_cross_yz;
  const Scalar t_left_foot_23 = t_left_shank_9 - t_left_foot_1;
  const Scalar t_left_ankle_cross_47 = t_left_ankle_cross_46 - neg_E_left_foot_xz * t_left_foot_23;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_47 + neg_a_left_foot_z * h_left_foot_x;
  const Scalar t_left_hip_block_32 = tau[4] - M_left_ankle_cross_z;
  const Scalar t_left_hip_block_33 = t_left_hip_block_32 - E_left_foot_yz * t_left_hip_block_31;
  // left_shank: moment M of (1)
  const Scalar M_left_shank_z_1 = M_left_ankle_cross_z - neg_Omega_left_shank_xz * t_left_shank_19;
  const Scalar M_left_shank_z_2 = M_left_shank_z_1 - t_left_shank_25 * a_left_shank_y;
  const Scalar M_left_shank_z_3 = M_left_shank_z_2 - t_left_shank_21 * t_left_ankle_cross_37;
  const Scalar M_left_shank_z_4 =
      M_left_shank_z_3 - neg_s_left_ankle_cross_x * F_left_ankle_cross_y;
  const Scalar M_left_shank_z_5 = M_left_shank_z_4 + Omega_left_foot_xz * t_left_shank_20;
  const Scalar M_left_shank_z_6 =
      M_left_shank_z_5 + s_left_ankle_cross_y * neg_F_left_ankle_cross_x;
  const Scalar M_left_shank_z_7 = M_left_shank_z_6 + Omega_left_shank_yx * t_left_shank_27;
  const Scalar M_left_shank_z_8 = M_left_shank_z_7 - neg_Omega_left_shank_yz * t_left_shank_17;
  const Scalar M_left_shank_z = M_left_shank_z_8 + t_left_shank_23 * a_left_shank_x;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_34 = tau[3] - M_left_shank_z;
  const Scalar t_left_hip_block_35 =
      t_left_hip_block_34 + t_left_ankle_cross_27 * t_left_hip_block_33;
  const Scalar t_left_hip_block_36 = t_left_hip_block_35 - t_left_foot_14 * t_left_hip_block_30;
  const Scalar t_left_shank_72 = s_q2_q3_q4 * F_left_shank_y + c_q2_q3_q4 * neg_F_left_shank_x;
  // left_thigh: moment M of (1)
  const Scalar M_left_thigh_z_1 = M_left_shank_z + t_left_hip_block_1 * t_left_thigh_16;
  const Scalar M_left_thigh_z_2 = M_left_thigh_z_1 + neg_a_left_hip_fork_x * t_left_thigh_13;
  const Scalar M_left_thigh_z_3 = M_left_thigh_z_2 + Omega_left_thigh_xz * t_left_thigh_11;
  const Scalar M_left_thigh_z_4 = M_left_thigh_z_3 + Omega_left_thigh_yz * t_left_thigh_9;
  const Scalar M_left_thigh_z_5 = c_q2_q3_q4 * F_left_shank_y - s_q2_q3_q4 * neg_F_left_shank_x;
  const Scalar M_left_thigh_z_6 = M_left_thigh_z_4 + t_left_hip_fork_3 * t_left_thigh_6;
  const Scalar M_left_thigh_z_7 = M_left_thigh_z_6 - s_left_shank_x * M_left_thigh_z_5;
  const Scalar M_left_thigh_z_8 = M_left_thigh_z_7 - s_left_shank_y * t_left_shank_72;
  const Scalar M_left_thigh_z = M_left_thigh_z_8 + t_left_thigh_14 * Omega_left_hip_fork_zx;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_37 = tau[2] - M_left_thigh_z;
  const Scalar t_left_hip_block_38 =
      t_left_hip_block_37 + t_left_ankle_cross_26 * t_left_hip_block_33;
  const Scalar t_left_hip_block_39 = t_left_hip_block_38 - t_left_shank_64 * t_left_hip_block_36;
  const Scalar t_left_hip_block_40 = t_left_hip_block_39 - t_left_foot_9 * t_left_hip_block_30;
  const Scalar t_left_hip_block_41 = left_hip_fork_G2 - left_hip_fork_p1 * t_left_thigh_16;
  const Scalar t_left_hip_block_42 = tau[1] - left_hip_fork_G1 * c_left_hip_roll;
  const Scalar t_left_hip_block_43 = t_left_hip_block_42 + s_q2_q3_q4 * M_left_shank_x;
  const Scalar t_left_hip_fork_25 = t_left_hip_fork_3 - t_left_hip_fork_8;
  const Scalar t_left_hip_block_44 = t_left_hip_block_43 - c_q2_q3_q4 * neg_M_left_shank_y;
  const Scalar t_left_hip_block_45 = t_left_hip_block_44 - left_hip_fork_I7 * t_left_hip_fork_25;
  const Scalar t_left_hip_block_46 = t_left_hip_block_45 - left_hip_fork_I15 * Omega_left_thigh_xz;
  const Scalar t_left_hip_block_47 =
      t_left_hip_block_46 - neg_Omega_left_thigh_zx * t_left_thigh_14;
  const Scalar t_left_hip_block_48 = t_left_hip_block_47 + t_left_shank_71 * t_left_hip_block_36;
  const Scalar t_left_hip_block_49 =
      t_left_hip_block_48 + t_left_ankle_cross_32 * t_left_hip_block_33;
  const Scalar t_left_hip_block_50 = t_left_hip_block_49 + neg_Omega_left_thigh_zy * t_left_thigh_6;
  const Scalar t_left_hip_block_51 = t_left_hip_block_50 - t_left_thigh_3 * t_left_thigh_9;
  const Scalar t_left_hip_block_52 = t_left_hip_block_51 - t_left_thigh_24 * t_left_hip_block_40;
  const Scalar t_left_hip_block_53 = t_left_hip_block_52 + s_left_shank_x * F_left_shank_z;
  const Scalar t_left_hip_block_54 = t_left_hip_block_53 - s_left_hip_roll * t_left_hip_block_41;
  const Scalar t_left_hip_block_55 = t_left_hip_block_54 - t_left_foot_8 * t_left_hip_block_30;
  // left_hip_fork: moment M of (1)
  const Scalar M_left_hip_fork_y_1 = t_left_shank_72 - M_left_thigh_z;
  const Scalar M_left_hip_fork_y_2 = M_left_hip_fork_y_1 + left_hip_fork_I9 * t_left_hip_fork_3;
  const Scalar M_left_hip_fork_y_3 = M_left_hip_fork_y_2 - left_hip_fork_I14 * alpha_left_thigh_z;
  const Scalar M_left_hip_fork_y_4 =
      M_left_hip_fork_y_3 + neg_Omega_left_thigh_xx * t_left_thigh_16;
  const Scalar M_left_hip_fork_y_5 = M_left_hip_fork_y_4 - left_hip_fork_I2 * t_left_hip_fork_6;
  const Scalar M_left_hip_fork_y = M_left_hip_fork_y_5 - left_hip_fork_I1 * Omega_left_thigh_xz;
  // left_hip_block: qdd of (1)
  const Scalar qdd_0_11 = tau[0] + s_left_hip_roll * M_left_hip_fork_y;
  const Scalar qdd_0_12 = qdd_0_11 - t_left_ankle_cross_28 * t_left_hip_block_33;
  const Scalar qdd_0_13 = qdd_0_12 - t_left_thigh_35 * t_left_hip_block_40;
  const Scalar qdd_0_14 = qdd_0_13 + t_left_shank_63 * t_left_hip_block_36;
  const Scalar qdd_0_15 = qdd_0_14 - c_left_hip_roll * M_left_hip_fork_x;
  const Scalar qdd_0_16 = qdd_0_15 + t_left_foot_11 * t_left_hip_block_30;
  const Scalar qdd_0 = qdd_0_10 * (qdd_0_16 - t_left_hip_fork_24 * t_left_hip_block_55);
  qdd[0] = qdd_0;
  const Scalar qdd_1 = t_left_hip_fork_23 * t_left_hip_block_55 - t_left_hip_fork_24 * qdd_0;
  qdd[1] = qdd_1;
  const Scalar neg_qdd_2_1 = t_left_thigh_24 * qdd_1 + t_left_thigh_35 * qdd_0;
  const Scalar neg_qdd_2 = neg_qdd_2_1 - inverse_pivot_left_thigh * t_left_hip_block_40;
  qdd[2] = -neg_qdd_2;
  const Scalar neg_qdd_3_1 = t_left_shank_62 * t_left_hip_block_36;
  const Scalar neg_qdd_3_2 = neg_qdd_3_1 - t_left_shank_71 * qdd_1;
  const Scalar neg_qdd_3_3 = neg_qdd_3_2 - t_left_shank_64 * neg_qdd_2;
  const Scalar neg_qdd_3 = neg_qdd_3_3 - t_left_shank_63 * qdd_0;
  qdd[3] = -neg_qdd_3;
  const Scalar neg_qdd_4_1 = t_left_hip_block_33 - t_left_foot_13 * qdd_0;
  const Scalar neg_qdd_4_2 = t_left_ankle_cross_26 * neg_qdd_2;
  const Scalar neg_qdd_4_3 = neg_qdd_4_1 + t_left_foot_15 * qdd_1;
  const Scalar neg_qdd_4_4 = neg_qdd_4_2 + t_left_ankle_cross_27 * neg_qdd_3;
  const Scalar neg_qdd_4 = neg_qdd_4_4 - t_left_ankle_cross_25 * neg_qdd_4_3;
  qdd[4] = -neg_qdd_4;
  const Scalar neg_qdd_5_1 = t_left_hip_block_31 + t_left_foot_11 * qdd_0;
  const Scalar neg_qdd_5_2 = neg_qdd_5_1 + t_left_foot_9 * neg_qdd_2;
  const Scalar neg_qdd_5_3 = neg_qdd_5_2 - t_left_foot_8 * qdd_1;
  qdd[5] = -(neg_qdd_5_3 + t_left_foot_10 * neg_qdd_4 + t_left_foot_14 * neg_qdd_3);
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
  const Scalar t_left_shank_1 = left_hip_fork_l2 - left_shank_l1 * c_q3_q4;
  const Scalar t_left_shank_2 = t_left_shank_1 - left_ankle_cross_l1 * c_left_ankle_pitch;
  const Scalar t_left_shank_3 = t_left_shank_2 - left_foot_l2 * c_left_ankle_roll;
  const Scalar t_left_thigh_1 = c_q2_q3_q4 * t_left_shank_3;
  const Scalar t_left_thigh_2 = left_hip_fork_l1 + left_foot_l2 * s_left_ankle_roll;
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * t_left_thigh_2;
  const Scalar neg_s_left_ankle_cross_y = left_ankle_cross_l1 * s_left_ankle_pitch;
  const Scalar t_left_shank_4 = left_shank_l1 * s_q3_q4 + neg_s_left_ankle_cross_y;
  const Scalar t_left_shank_5 = left_foot_l1 - t_left_shank_4;
  const Scalar t_left_hip_fork_2 = left_hip_fork_l2 - s_q2_q3_q4 * t_left_shank_3;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 + c_q2_q3_q4 * t_left_shank_5;
  const Scalar t_left_thigh_3 = t_left_thigh_1 + s_q2_q3_q4 * t_left_shank_5;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_1 - s_left_hip_roll * t_left_thigh_3;
  // left_hip_block: p of 1.2
  const Scalar p_1_1 = left_hip_block_l1 + s_left_hip_yaw * t_left_hip_fork_3;
  p[1] = p_1_1 - c_left_hip_yaw * t_left_hip_fork_4;
  p[0] = c_left_hip_yaw * t_left_hip_fork_3 + s_left_hip_yaw * t_left_hip_fork_4;
  const Scalar t_left_hip_block_1 = left_hip_block_l2 - s_left_hip_roll * t_left_thigh_2;
  p[2] = t_left_hip_block_1 - c_left_hip_roll * t_left_thigh_3;
  const Scalar t_left_shank_6 = left_foot_l3 - t_left_shank_4;
  const Scalar t_left_thigh_4 = t_left_thigh_1 + s_q2_q3_q4 * t_left_shank_6;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_1 - s_left_hip_roll * t_left_thigh_4;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_2 + c_q2_q3_q4 * t_left_shank_6;
  const Scalar p_4_1 = left_hip_block_l1 - c_left_hip_yaw * t_left_hip_fork_5;
  p[4] = p_4_1 + s_left_hip_yaw * t_left_hip_fork_6;
  p[3] = c_left_hip_yaw * t_left_hip_fork_6 + s_left_hip_yaw * t_left_hip_fork_5;
  p[5] = t_left_hip_block_1 - c_left_hip_roll * t_left_thigh_4;
  // right_shank
  const Scalar t_right_shank_1 = left_hip_fork_l2 - left_shank_l1 * c_q9_q10;
  const Scalar t_right_shank_2 = t_right_shank_1 - left_ankle_cross_l1 * c_right_ankle_pitch;
  const Scalar t_right_shank_3 = t_right_shank_2 - left_foot_l2 * c_right_ankle_roll;
  const Scalar t_right_thigh_1 = c_q8_q9_q10 * t_right_shank_3;
  const Scalar t_right_thigh_2 = left_hip_fork_l1 - left_foot_l2 * s_right_ankle_roll;
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * t_right_thigh_2;
  const Scalar neg_s_righ_ankl_cros_y = left_ankle_cross_l1 * s_right_ankle_pitch;
  const Scalar t_right_shank_4 = left_shank_l1 * s_q9_q10 + neg_s_righ_ankl_cros_y;
  const Scalar t_right_shank_5 = left_foot_l1 - t_right_shank_4;
  const Scalar t_right_thigh_3 = t_right_thigh_1 + s_q8_q9_q10 * t_right_shank_5;
  // right_hip_fork
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 + s_right_hip_roll * t_right_thigh_3;
  const Scalar t_right_hip_fork_3 = left_hip_fork_l2 - s_q8_q9_q10 * t_right_shank_3;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_3 + c_q8_q9_q10 * t_right_shank_5;
  // right_hip_block: p of 1.2
  const Scalar neg_p_7_1 = left_hip_block_l1 - c_right_hip_yaw * t_right_hip_fork_2;
  p[7] = s_right_hip_yaw * t_right_hip_fork_4 - neg_p_7_1;
  p[6] = c_right_hip_yaw * t_right_hip_fork_4 - s_right_hip_yaw * t_right_hip_fork_2;
  const Scalar t_right_hip_block_1 = left_hip_block_l2 + s_right_hip_roll * t_right_thigh_2;
  p[8] = t_right_hip_block_1 - c_right_hip_roll * t_right_thigh_3;
  const Scalar t_right_shank_6 = left_foot_l3 - t_right_shank_4;
  const Scalar t_right_thigh_4 = t_right_thigh_1 + s_q8_q9_q10 * t_right_shank_6;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_1 + s_right_hip_roll * t_right_thigh_4;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_3 + c_q8_q9_q10 * t_right_shank_6;
  const Scalar neg_p_10_1 = left_hip_block_l1 - c_right_hip_yaw * t_right_hip_fork_5;
  p[10] = s_right_hip_yaw * t_right_hip_fork_6 - neg_p_10_1;
  p[9] = c_right_hip_yaw * t_right_hip_fork_6 - s_right_hip_yaw * t_right_hip_fork_5;
  p[11] = t_right_hip_block_1 - c_right_hip_roll * t_right_thigh_4;
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
  const Scalar s_left_ankle_cross_x = left_ankle_cross_l1 * c_q2_q3;
  const Scalar s_left_ankle_cross_y = left_ankle_cross_l1 * s_q2_q3;
  const Scalar s_right_shank_y = left_shank_l1 * s_right_hip_pitch;
  const Scalar s_right_shank_x = left_shank_l1 * c_right_hip_pitch;
  const Scalar s_righ_ankl_cros_x = left_ankle_cross_l1 * c_q8_q9;
  const Scalar s_righ_ankl_cros_y = left_ankle_cross_l1 * s_q8_q9;
  // left_hip_block: r of (9)
  const Scalar neg_r_right_foot_y = left_foot_l2 * s_right_ankle_roll;
  const Scalar neg_r_left_foot_y = left_foot_l2 * s_left_ankle_roll;
  const Scalar neg_r_right_foot_x = left_foot_l2 * c_right_ankle_roll;
  const Scalar neg_r_left_foot_x = left_foot_l2 * c_left_ankle_roll;
  const Scalar neg_r_left_ankle_cross_x = left_hip_fork_l2 - neg_r_left_foot_x;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_1 = c_q2_q3_q4 * neg_r_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_2 = s_q2_q3_q4 * neg_r_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_3 = t_left_ankle_cross_2 - left_foot_l1 * c_q2_q3_q4;
  const Scalar t_left_ankle_cross_4 = t_left_ankle_cross_1 + left_foot_l1 * s_q2_q3_q4;
  // left_shank: r of (9)
  const Scalar t_left_shank_1 = s_left_ankle_cross_x + left_shank_l1 * c_left_hip_pitch;
  const Scalar neg_r_left_thigh_x = t_left_ankle_cross_4 - t_left_shank_1;
  const Scalar t_left_shank_2 = s_left_ankle_cross_y + left_shank_l1 * s_left_hip_pitch;
  const Scalar neg_r_left_thigh_y = t_left_ankle_cross_3 - t_left_shank_2;
  const Scalar neg_r_left_hip_fork_x = left_hip_fork_l1 + neg_r_left_foot_y;
  // left_hip_fork: r of (9)
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * neg_r_left_hip_fork_x;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * neg_r_left_hip_fork_x;
  const Scalar neg_r_left_hip_block_y = t_left_hip_fork_2 - s_left_hip_roll * neg_r_left_thigh_x;
  C[14] = -neg_r_left_hip_block_y;
  // left_hip_block: r, C of (9)
  const Scalar r_left_hip_block_x = left_hip_fork_l2 - neg_r_left_thigh_y;
  C[1] = s_left_hip_yaw * neg_r_left_hip_block_y + c_left_hip_yaw * r_left_hip_block_x;
  C[0] = c_left_hip_yaw * neg_r_left_hip_block_y - s_left_hip_yaw * r_left_hip_block_x;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_1 + c_left_hip_roll * neg_r_left_thigh_x;
  C[13] = c_left_hip_yaw * t_left_hip_fork_3;
  C[12] = -s_left_hip_yaw * t_left_hip_fork_3;
  const Scalar t_left_hip_block_1 = c_left_hip_yaw * s_left_hip_roll;
  C[25] = -(s_left_hip_yaw * neg_r_left_thigh_x + neg_r_left_thigh_y * t_left_hip_block_1);
  const Scalar t_left_hip_block_2 = s_left_hip_yaw * s_left_hip_roll;
  C[24] = neg_r_left_thigh_y * t_left_hip_block_2 - c_left_hip_yaw * neg_r_left_thigh_x;
  const Scalar C_48_1 = t_left_ankle_cross_3 * t_left_hip_block_2;
  const Scalar C_48 = C_48_1 - c_left_hip_yaw * t_left_ankle_cross_4;
  C[48] = C_48;
  const Scalar t_left_hip_block_3 = s_left_ankle_cross_y * t_left_hip_block_2;
  const Scalar t_left_hip_block_4 = t_left_hip_block_3 - c_left_hip_yaw * s_left_ankle_cross_x;
  C[36] = C_48 - t_left_hip_block_4;
  const Scalar neg_C_49_1 = t_left_ankle_cross_3 * t_left_hip_block_1;
  const Scalar neg_C_49 = neg_C_49_1 + s_left_hip_yaw * t_left_ankle_cross_4;
  C[49] = -neg_C_49;
  const Scalar t_left_hip_block_5 = s_left_ankle_cross_y * t_left_hip_block_1;
  const Scalar t_left_hip_block_6 = t_left_hip_block_5 + s_left_hip_yaw * s_left_ankle_cross_x;
  C[37] = t_left_hip_block_6 - neg_C_49;
  C[26] = c_left_hip_roll * neg_r_left_thigh_y;
  const Scalar t_left_hip_block_7 = c_q2_q3_q4 * neg_r_left_foot_y;
  const Scalar t_left_hip_block_8 = s_q2_q3_q4 * neg_r_left_foot_y;
  const Scalar t_left_hip_block_9 = s_left_hip_roll * t_left_hip_block_7;
  const Scalar t_left_hip_block_10 = t_left_hip_block_9 - c_left_hip_roll * neg_r_left_foot_x;
  C[61] = c_left_hip_yaw * t_left_hip_block_10 - s_left_hip_yaw * t_left_hip_block_8;
  C[64] = C[61];
  C[60] = -(c_left_hip_yaw * t_left_hip_block_8 + s_left_hip_yaw * t_left_hip_block_10);
  C[63] = C[60];
  const Scalar C_50 = c_left_hip_roll * t_left_ankle_cross_3;
  C[50] = C_50;
  const Scalar t_left_hip_block_11 = c_left_hip_roll * s_left_ankle_cross_y;
  C[38] = C_50 - t_left_hip_block_11;
  C[62] = -(c_left_hip_roll * t_left_hip_block_7 + s_left_hip_roll * neg_r_left_foot_x);
  C[65] = C[62];
  const Scalar t_left_ankle_cross_5 = t_left_ankle_cross_1 + left_foot_l3 * s_q2_q3_q4;
  const Scalar t_left_ankle_cross_6 = t_left_ankle_cross_2 - left_foot_l3 * c_q2_q3_q4;
  const Scalar r_left_thigh_x = t_left_shank_1 - t_left_ankle_cross_5;
  const Scalar r_left_thigh_y = t_left_shank_2 - t_left_ankle_cross_6;
  const Scalar neg_r_left_hip_block_y_2 = t_left_hip_fork_2 + s_left_hip_roll * r_left_thigh_x;
  C[17] = -neg_r_left_hip_block_y_2;
  const Scalar r_left_hip_block_x_2 = left_hip_fork_l2 + r_left_thigh_y;
  C[3] = c_left_hip_yaw * neg_r_left_hip_block_y_2 - s_left_hip_yaw * r_left_hip_block_x_2;
  C[4] = s_left_hip_yaw * neg_r_left_hip_block_y_2 + c_left_hip_yaw * r_left_hip_block_x_2;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_1 - c_left_hip_roll * r_left_thigh_x;
  C[15] = -s_left_hip_yaw * t_left_hip_fork_4;
  C[16] = c_left_hip_yaw * t_left_hip_fork_4;
  C[28] = s_left_hip_yaw * r_left_thigh_x + t_left_hip_block_1 * r_left_thigh_y;
  C[27] = c_left_hip_yaw * r_left_thigh_x - t_left_hip_block_2 * r_left_thigh_y;
  const Scalar neg_C_52_1 = t_left_hip_block_1 * t_left_ankle_cross_6;
  const Scalar neg_C_52 = neg_C_52_1 + s_left_hip_yaw * t_left_ankle_cross_5;
  C[52] = -neg_C_52;
  C[40] = t_left_hip_block_6 - neg_C_52;
  const Scalar neg_C_51_1 = t_left_hip_block_2 * t_left_ankle_cross_6;
  const Scalar neg_C_51 = c_left_hip_yaw * t_left_ankle_cross_5 - neg_C_51_1;
  C[51] = -neg_C_51;
  C[39] = -(t_left_hip_block_4 + neg_C_51);
  C[29] = -c_left_hip_roll * r_left_thigh_y;
  const Scalar C_53 = c_left_hip_roll * t_left_ankle_cross_6;
  C[53] = C_53;
  C[41] = C_53 - t_left_hip_block_11;
  const Scalar neg_r_righ_ankl_cros_x = left_hip_fork_l2 - neg_r_right_foot_x;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_1 = c_q8_q9_q10 * neg_r_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_2 = s_q8_q9_q10 * neg_r_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_3 = t_righ_ankl_cros_2 - left_foot_l1 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_1 + left_foot_l1 * s_q8_q9_q10;
  // right_shank: r of (9)
  const Scalar t_right_shank_1 = s_right_shank_x + s_righ_ankl_cros_x;
  const Scalar neg_r_right_thigh_x = t_righ_ankl_cros_4 - t_right_shank_1;
  const Scalar t_right_shank_2 = s_right_shank_y + s_righ_ankl_cros_y;
  const Scalar neg_r_right_thigh_y = t_righ_ankl_cros_3 - t_right_shank_2;
  const Scalar r_right_hip_fork_x = left_hip_fork_l1 - neg_r_right_foot_y;
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * r_right_hip_fork_x;
  const Scalar r_right_hip_block_y = t_right_hip_fork_1 + s_right_hip_roll * neg_r_right_thigh_x;
  C[92] = r_right_hip_block_y;
  const Scalar t_right_hip_fork_2 = s_right_hip_roll * r_right_hip_fork_x;
  const Scalar r_right_hip_block_x = left_hip_fork_l2 - neg_r_right_thigh_y;
  C[78] = -(c_right_hip_yaw * r_right_hip_block_y + s_right_hip_yaw * r_right_hip_block_x);
  C[79] = c_right_hip_yaw * r_right_hip_block_x - s_right_hip_yaw * r_right_hip_block_y;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 - c_right_hip_roll * neg_r_right_thigh_x;
  // left_hip_block: C of (9)
  C[90] = s_right_hip_yaw * t_right_hip_fork_3;
  C[91] = -c_right_hip_yaw * t_right_hip_fork_3;
  const Scalar t_left_hip_block_12 = s_right_hip_yaw * s_right_hip_roll;
  C[102] = neg_r_right_thigh_y * t_left_hip_block_12 - c_right_hip_yaw * neg_r_right_thigh_x;
  const Scalar t_left_hip_block_13 = c_right_hip_yaw * s_right_hip_roll;
  const Scalar neg_C_127_1 = t_righ_ankl_cros_3 * t_left_hip_block_13;
  const Scalar neg_C_127 = s_right_hip_yaw * t_righ_ankl_cros_4 + neg_C_127_1;
  C[127] = -neg_C_127;
  const Scalar t_left_hip_block_14 = s_righ_ankl_cros_y * t_left_hip_block_13;
  const Scalar t_left_hip_block_15 = s_right_hip_yaw * s_righ_ankl_cros_x + t_left_hip_block_14;
  const Scalar neg_C_115 = neg_C_127 - t_left_hip_block_15;
  C[115] = -neg_C_115;
  const Scalar t_left_hip_block_16 = s_right_shank_y * t_left_hip_block_13;
  const Scalar t_left_hip_block_17 = t_left_hip_block_16 + s_right_hip_yaw * s_right_shank_x;
  C[103] = t_left_hip_block_17 - neg_C_115;
  const Scalar C_126_1 = t_righ_ankl_cros_3 * t_left_hip_block_12;
  const Scalar C_126 = C_126_1 - c_right_hip_yaw * t_righ_ankl_cros_4;
  C[126] = C_126;
  const Scalar t_left_hip_block_18 = s_righ_ankl_cros_y * t_left_hip_block_12;
  const Scalar t_left_hip_block_19 = t_left_hip_block_18 - c_right_hip_yaw * s_righ_ankl_cros_x;
  C[114] = C_126 - t_left_hip_block_19;
  C[104] = c_right_hip_roll * neg_r_right_thigh_y;
  const Scalar t_left_hip_block_20 = c_q8_q9_q10 * neg_r_right_foot_y;
  const Scalar t_left_hip_block_21 = s_q8_q9_q10 * neg_r_right_foot_y;
  const Scalar t_left_hip_block_22 = s_right_hip_roll * t_left_hip_block_20;
  const Scalar t_left_hip_block_23 = t_left_hip_block_22 - c_right_hip_roll * neg_r_right_foot_x;
  C[139] = c_right_hip_yaw * t_left_hip_block_23 - s_right_hip_yaw * t_left_hip_block_21;
  C[142] = C[139];
  C[138] = -(c_right_hip_yaw * t_left_hip_block_21 + s_right_hip_yaw * t_left_hip_block_23);
  C[141] = C[138];
  const Scalar C_128 = c_right_hip_roll * t_righ_ankl_cros_3;
  C[128] = C_128;
  const Scalar t_left_hip_block_24 = c_right_hip_roll * s_righ_ankl_cros_y;
  C[116] = C_128 - t_left_hip_block_24;
  C[140] = -(c_right_hip_roll * t_left_hip_block_20 + s_right_hip_roll * neg_r_right_foot_x);
  C[143] = C[140];
  const Scalar t_righ_ankl_cros_5 = t_righ_ankl_cros_1 + left_foot_l3 * s_q8_q9_q10;
  const Scalar r_right_thigh_x = t_right_shank_1 - t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_6 = t_righ_ankl_cros_2 - left_foot_l3 * c_q8_q9_q10;
  const Scalar r_right_thigh_y = t_right_shank_2 - t_righ_ankl_cros_6;
  const Scalar r_right_hip_block_y_2 = t_right_hip_fork_1 - s_right_hip_roll * r_right_thigh_x;
  C[95] = r_right_hip_block_y_2;
  const Scalar r_right_hip_block_x_2 = left_hip_fork_l2 + r_right_thigh_y;
  C[82] = c_right_hip_yaw * r_right_hip_block_x_2 - s_right_hip_yaw * r_right_hip_block_y_2;
  C[81] = -(c_right_hip_yaw * r_right_hip_block_y_2 + s_right_hip_yaw * r_right_hip_block_x_2);
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_2 + c_right_hip_roll * r_right_thigh_x;
  C[94] = -c_right_hip_yaw * t_right_hip_fork_4;
  C[93] = s_right_hip_yaw * t_right_hip_fork_4;
  const Scalar neg_C_130_1 = t_left_hip_block_13 * t_righ_ankl_cros_6;
  const Scalar neg_C_130 = s_right_hip_yaw * t_righ_ankl_cros_5 + neg_C_130_1;
  C[130] = -neg_C_130;
  const Scalar C_118 = t_left_hip_block_15 - neg_C_130;
  C[118] = C_118;
  C[106] = t_left_hip_block_17 + C_118;
  C[105] = c_right_hip_yaw * r_right_thigh_x - t_left_hip_block_12 * r_right_thigh_y;
  const Scalar C_129_1 = t_left_hip_block_12 * t_righ_ankl_cros_6;
  const Scalar C_129 = C_129_1 - c_right_hip_yaw * t_righ_ankl_cros_5;
  C[129] = C_129;
  C[117] = C_129 - t_left_hip_block_19;
  C[107] = -c_right_hip_roll * r_right_thigh_y;
  const Scalar C_131 = c_right_hip_roll * t_righ_ankl_cros_6;
  C[131] = C_131;
  C[119] = C_131 - t_left_hip_block_24;
  force_jacobian_transpose_0(C);
}

}  // namespace biped
