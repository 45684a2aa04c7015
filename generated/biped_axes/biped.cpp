// biped.cpp: see biped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate biped.yaml --base axes

#include "biped.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace biped {

static_assert(kDigest == 0xd486b522afeddd1dULL, "header and source are of different runs");

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

namespace {

// The numbers that functions take from the model, under the first link whose inertia is in them;
// above each its unit and the numbers of the model that it is made of, but for those that are
// exactly 0 or 1. Other literals are numbers of the equations.

// m/s^2: gravity
constexpr double base_g1 = 9.81;

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
// kg m: mass, com y of base_rx; mass, offset y of left_hip_block, right_hip_block; mass of
//     left_hip_fork to right_foot (10 links)
constexpr double base_rx_h1 = 0.0494584755;
// kg m: mass, com x of base_rx
constexpr double base_rx_h2 = 0.086212924;
// kg m: mass, com z of base_rx; mass, com z, offset z of left_hip_block, right_hip_block; mass,
//     offset z of left_hip_fork, right_hip_fork; mass, offset y of left_thigh, right_thigh; mass of
//     left_shank, left_ankle_cross, left_foot, right_shank, right_ankle_cross, right_foot
constexpr double base_rx_h3 = 8.4556102785;
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
// kg m^2: mass, com x z, inertia xz of base_rx
constexpr double base_rx_I1 = 0.062513175334862;
// kg m^2: mass, com x, inertia xx yy zz of base_rx to right_ankle_cross (9 links); mass, com x,
//     inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x, inertia xx yy zz,
//     offset z of left_foot, right_foot
constexpr double base_rx_I2 = 0.23486810286681728;
// kg m^2: mass, com y, inertia xx yy zz of base_rx; mass, com y, inertia xx yy zz, offset y of
//     left_hip_block, right_hip_block; mass of left_hip_fork to right_foot (10 links)
constexpr double base_rx_I3 = 0.7618761545167745;
// kg m^2: mass, com z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset z of
//     left_hip_block, right_hip_block; mass, com y, inertia xx yy zz, offset z of left_hip_fork,
//     right_hip_fork; mass, com y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com
//     y, inertia xx yy zz of left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass,
//     com y z, inertia xx yy zz of left_foot, right_foot
constexpr double base_rx_I4 = 5.214202433961874;
// kg m^2: mass, com x y, inertia xy of base_rx
constexpr double base_rx_I5 = 0.001200009986336;
// kg m^2: mass, com y z, inertia yz of base_rx; mass, offset y z of left_hip_block,
//     right_hip_block; mass of left_hip_fork to right_foot (10 links)
constexpr double base_rx_I6 = 0.0119045769944955;
// kg m^2: mass, com z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset z of
//     left_hip_block, right_hip_block; mass, offset x z of left_hip_fork, right_hip_fork; mass,
//     offset y of left_thigh, right_thigh; mass of left_shank, right_shank; mass, com z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double base_rx_I7 = 5.128837528104454;
// kg m^2: mass, com x, inertia xx yy zz of base_rx
constexpr double base_rx_I8 = 0.154322325710336;
// kg m^2: mass, com x, inertia xx yy zz of base_rx
constexpr double base_rx_I9 = 0.308644651420672;
// kg m^2: mass, com y, inertia xx yy zz of base_rx; mass, offset y of left_hip_block,
//     right_hip_block; mass, offset x of left_hip_fork, right_hip_fork; mass of left_thigh,
//     left_shank, right_thigh, right_shank; mass, com z of left_ankle_cross, right_ankle_cross;
//     offset z of left_foot, right_foot
constexpr double base_rx_I10 = 0.7481424035725185;
// kg m^2: mass, com y z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset y z of
//     left_hip_block, right_hip_block; mass, offset z of left_hip_fork, right_hip_fork; mass, com
//     z, offset y of left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr double base_rx_I11 = 5.586392114968517;
// kg m^2: mass, com y z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset y z of
//     left_hip_block, right_hip_block; mass, offset z of left_hip_fork, right_hip_fork; mass, com
//     z, offset y of left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr double base_rx_I12 = 4.283928087953031;
// kg m^2: mass, com y, inertia xx yy zz of base_rx; mass, offset y of left_hip_block,
//     right_hip_block; mass of left_hip_fork, right_hip_fork; mass, com z of left_thigh,
//     right_thigh; offset z of left_shank, right_shank
constexpr double base_rx_I13 = 0.6512320135077433;
// kg m^2: mass, com z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset z of
//     left_hip_block, right_hip_block; mass, offset z of left_hip_fork, right_hip_fork; mass, com
//     z, offset y of left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr double base_rx_I14 = 4.935160101460775;
// kg m^2: mass, com y z, inertia yz of base_rx; mass, com z, offset y z of left_hip_block,
//     right_hip_block; offset z of left_hip_fork, right_hip_fork; offset y of left_thigh,
//     right_thigh
constexpr double base_rx_I15 = 0.0175428432014955;
// kg m^2: mass, com, inertia xx yy zz of base_rx; mass, com x z, inertia xx yy zz, offset y z of
//     left_hip_block, right_hip_block; mass, com x, inertia xx yy zz, offset x z of left_hip_fork,
//     right_hip_fork; mass, com z, offset y of left_thigh, right_thigh; offset z of left_shank,
//     left_foot, right_shank, right_foot
constexpr double base_rx_I16 = 4.937860071985853;
// kg m^2: mass, com, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset y z of
//     left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double base_rx_I17 = 4.624190924193181;
// kg m^2: mass, com y z, inertia xx yy zz of base_rx; mass, com z, inertia xx yy zz, offset y z of
//     left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double base_rx_I18 = 4.205662634527222;
// kg m^2: mass, com x y, inertia xx yy zz of base_rx; offset y of left_hip_block, right_hip_block
constexpr double base_rx_I19 = 0.7271729410866306;
// kg m^2: mass, com x y, inertia xx yy zz of base_rx; offset y of left_hip_block, right_hip_block
constexpr double base_rx_I20 = 0.4185282896659585;
// kg m^2: mass, com y z, inertia xx yy zz of base_rx; mass, com y z, inertia xx yy zz, offset y z
//     of left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double base_rx_I21 = 5.352785456639811;
// N: gravity; mass of base_rx to right_foot (13 links)
constexpr double base_rx_w1 = 791.28441;

// kg: mass of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; mass, com z of
//     left_thigh, right_thigh; offset z of left_shank, right_shank
constexpr double left_hip_block_m1 = 6.33339546;
// m: offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_l1 = 0.08064;
// m: offset z of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double left_hip_block_l2 = 0.114;
// m: offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_l3 = 0.16128;
// m: offset z of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double left_hip_block_l4 = 0.228;
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
// kg m^2: mass, com y z, offset z of left_hip_block, right_hip_block; mass, com y z of
//     left_hip_fork, right_hip_fork
constexpr double left_hip_block_I1 = 0.0005307204;
// kg m^2: mass, com x z, offset z of left_hip_block, right_hip_block; mass, com x, offset x z of
//     left_hip_fork, right_hip_fork; mass, offset y of left_thigh, right_thigh; mass of left_shank,
//     left_ankle_cross, right_shank, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_hip_block_I2 = 0.016536471;
// kg m^2: mass, com x y of left_hip_block, right_hip_block
constexpr double left_hip_block_I3 = 0.00013941312;
// kg m^2: mass, com x, inertia xx yy zz of left_hip_block to right_ankle_cross (8 links); mass, com
//     x, inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x, inertia xx yy
//     zz, offset z of left_foot, right_foot
constexpr double left_hip_block_I4 = 0.04027288857824064;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia
//     xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x, inertia xx yy zz of
//     left_thigh, left_shank, left_ankle_cross, right_thigh, right_shank, right_ankle_cross; mass,
//     com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_hip_block_I5 = 0.03956209289824064;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia
//     xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x, inertia xx yy zz of
//     left_thigh, left_shank, left_ankle_cross, right_thigh, right_shank, right_ankle_cross; mass,
//     com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_hip_block_I6 = 0.04098368425824064;
// kg m^2: mass, com y, inertia xx yy zz of left_hip_block, right_hip_block
constexpr double left_hip_block_I7 = 0.00071079568;
// kg m^2: mass, com x y of left_hip_block, right_hip_block
constexpr double left_hip_block_I8 = 6.970656e-05;
// kg m^2: mass, com x z, offset z of left_hip_block, right_hip_block; mass, com x, offset x z of
//     left_hip_fork, right_hip_fork; mass, offset y of left_thigh, right_thigh; mass of left_shank,
//     right_shank; mass, com z of left_ankle_cross, right_ankle_cross; offset z of left_foot,
//     right_foot
constexpr double left_hip_block_I9 = 0.0154572558;
// kg m^2: mass, com y z, offset z of left_hip_block, right_hip_block
constexpr double left_hip_block_I10 = 0.00044992416;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia
//     xx yy zz, offset x of left_hip_fork, right_hip_fork; mass of left_thigh, left_shank,
//     right_thigh, right_shank; mass, com z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_hip_block_I11 = 0.00254659496;
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
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia
//     xx yy zz, offset x of left_hip_fork, right_hip_fork; mass of left_thigh, left_shank,
//     right_thigh, right_shank; mass, com z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_hip_block_I15 = 0.00396818632;
// kg m^2: mass, com x, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia xx
//     yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh;
//     offset z of left_shank, left_foot, right_shank, right_foot
constexpr double left_hip_block_I16 = 0.002512248186;
// kg m^2: mass, com y z of left_hip_block, right_hip_block; offset z of left_hip_fork,
//     right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_I17 = 0.00027248928;
// kg m^2: mass, com x z of left_hip_block, right_hip_block; offset z of left_hip_fork,
//     right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_I18 = 0.00037467276;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia
//     xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh;
//     offset z of left_shank, left_foot, right_shank, right_foot
constexpr double left_hip_block_I19 = 0.001801452506;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x z,
//     inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh,
//     right_thigh; offset z of left_shank, left_foot, right_shank, right_foot
constexpr double left_hip_block_I20 = 0.003489196186;
// kg m^2: mass, com y z of left_hip_block, right_hip_block; mass, com y z, offset z of
//     left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_I21 = 0.00019169304;
// kg^2 m^4: mass, com x z of left_hip_block, right_hip_block; offset z of left_hip_fork,
//     right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_block_p1 = 1.403796770860176e-07;
// m^2: offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_p2 = 0.0065028096;
// m^2: offset y z of left_hip_block, right_hip_block; offset z of left_hip_fork, right_hip_fork;
//     offset y of left_thigh, right_thigh
constexpr double left_hip_block_p3 = 0.00919296;

// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_l1 = 0.01;
// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_l2 = 0.02;
// m: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_fork_l3 = 0.02;
// kg m: mass, com z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_h1 = 0.00475272;
// kg m: mass, com y, offset z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_h2 = 0.40746668256;
// kg m: mass, com y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_h3 = 0.38853308256;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I1 = 0.00016159248;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xz yz of
//     left_thigh, left_shank, right_thigh, right_shank; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_hip_fork_I2 = 0.03467671360129536;
// kg m^2: mass, com z, inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z,
//     inertia xx yy zz of left_thigh, right_thigh; mass, com z, inertia xx yy zz, offset z of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass, com y z, inertia xx yy
//     zz, offset z of left_foot, right_foot
constexpr double left_hip_fork_I3 = 1.661731810261911;
// kg m^2: mass, com y, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass, com y z, inertia xx yy zz
//     of left_foot, right_foot
constexpr double left_hip_fork_I4 = 0.030379399648709733;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_hip_fork_I5 = 0.0042631913856;
// kg m^2: mass, com y, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I6 = 0.02957665238032736;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I7 = 8.079624e-05;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; offset z of left_foot,
//     right_foot
constexpr double left_hip_fork_I8 = 0.00011406528;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I9 = 0.0040738553856;
// kg m^2: mass, com z, inertia xx yy zz of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I10 = 0.00026615232;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I11 = 0.02984280470032736;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I12 = 0.02931050006032736;
// kg m^2: mass, com y, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I13 = 0.02995532438032736;
// kg m^2: mass, com x y of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I14 = 0.00018852456;
// kg m^2: mass, com x z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I15 = 6.653808e-05;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I16 = 0.03022147670032736;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I17 = 0.02968917206032736;
// kg^2 m^4: mass, com x y of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_p1 = 3.55415097231936e-08;

// kg: mass, com z of left_thigh, right_thigh; mass, com z, offset z of left_shank, right_shank;
//     offset z of left_ankle_cross, right_ankle_cross
constexpr double left_thigh_m1 = 5.84786454;
// kg: mass, com z of left_thigh, right_thigh; mass, com z, offset z of left_shank, right_shank;
//     mass, offset z of left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_thigh_m2 = 8.39810454;
// kg: mass, com z of left_thigh, right_thigh; mass, com z, offset z of left_shank, right_shank;
//     mass, offset z of left_ankle_cross, right_ankle_cross; mass, com y z, inertia xx yy zz of
//     left_foot, right_foot
constexpr double left_thigh_m3 = 8.19461557789365;
// kg m: mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank; mass of
//     left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_h1 = 3.62798116128;
// kg m: mass, com x of left_thigh, right_thigh
constexpr double left_thigh_h2 = 0.14731530912;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, left_ankle_cross,
//     right_thigh, right_ankle_cross; mass, offset z of left_shank, right_shank; offset z of
//     left_foot, right_foot
constexpr double left_thigh_h3 = 3.21901540128;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_I1 = 1.2800687125653505;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr double left_thigh_I2 = 0.03939173998083072;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_thigh_I3 = 0.09232168197063167;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com x y, inertia xy, offset y of
//     left_thigh, right_thigh
constexpr double left_thigh_I4 = 0.00442555309711872;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, com x z, inertia xx yy zz, offset z of left_shank, left_ankle_cross,
//     right_shank, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_thigh_I5 = 1.6983864878801518;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, offset z of left_shank, right_shank; mass, com z of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_thigh_I6 = 1.1033955042453505;
// kg m^2: mass, com x, inertia xx yy zz of left_thigh, right_thigh
constexpr double left_thigh_I7 = 0.02465049344454144;
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
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr double left_thigh_I11 = 0.26256865566306814;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr double left_thigh_I12 = 0.2872191491076096;

// kg: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass, com
//     z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_m1 = 1.60356;
// kg: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_m2 = 2.55024;
// kg: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_shank_m3 = 2.3467510378936507;
// m: offset z of left_shank, right_shank
constexpr double left_shank_l1 = 0.432;
// kg m: mass, com x of left_shank, right_shank
constexpr double left_shank_h1 = 0.080309376;
// kg m: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_h2 = 1.10425392;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_h3 = 0.69434148;
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
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com x z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_shank_I5 = 0.36901678842571844;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_shank_I6 = 0.173287335213216;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr double left_shank_I7 = 0.01541645551488;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, right_shank
constexpr double left_shank_I8 = 0.005291437550784;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, inertia xz yz of left_shank, right_shank; mass, com y z, offset z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_I9 = 0.01745977700712;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_shank_I10 = 0.178578772764;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I11 = 0.122071088076;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I12 = 0.127362525626784;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I13 = 0.116779650525216;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, inertia xx yy zz, offset z of left_ankle_cross, right_ankle_cross;
//     mass, offset z of left_foot, right_foot
constexpr double left_shank_I14 = 0.121952398876;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xz yz of left_shank,
//     right_shank; mass, com x z of left_ankle_cross, right_ankle_cross; mass, com x, offset z of
//     left_foot, right_foot
constexpr double left_shank_I15 = 0.01596613269888;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, left_ankle_cross, left_foot, right_shank,
//     right_ankle_cross, right_foot
constexpr double left_shank_I16 = 0.0122703364936992;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_shank_I17 = 0.010552864948912843;

// kg: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_m1 = 0.94668;
// m: offset z of left_ankle_cross, right_ankle_cross
constexpr double left_ankle_cross_l1 = 0.433;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_h1 = 0.0094668;
// kg m: mass, com x of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_ankle_cross_h2 = 0.0550836384;
// kg m: mass, com x of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz yy zz of
//     left_foot, right_foot
constexpr double left_ankle_cross_h3 = 0.034208266826926986;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_ankle_cross_h4 = 0.007431910378936505;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y of left_ankle_cross, right_ankle_cross; mass, com x of left_foot, right_foot
constexpr double left_ankle_cross_I1 = 0.001106309568;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com y z, inertia xx yy zz, offset z of
//     left_foot, right_foot
constexpr double left_ankle_cross_I2 = 0.00016012430367330226;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I3 = 0.006303306294895972;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I4 = 0.007654491590934428;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I5 = 0.001099354368;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I6 = 0.000549677184;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, left_foot, right_ankle_cross,
//     right_foot
constexpr double left_ankle_cross_I7 = 0.0069788989429152;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z of left_ankle_cross, right_ankle_cross
constexpr double left_ankle_cross_I8 = 6.9552e-06;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_ankle_cross_I9 = 2.40212e-05;
// kg m^2: mass, com x, offset z of left_ankle_cross, right_ankle_cross; mass, com x of left_foot,
//     right_foot
constexpr double left_ankle_cross_I10 = 0.0238512154272;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I11 = 0.0001962912;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z
//     of left_foot, right_foot
constexpr double left_ankle_cross_I12 = 6.706794872165769e-05;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z of
//     left_foot, right_foot
constexpr double left_ankle_cross_I13 = 0.007650448025253941;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I14 = 0.0068602097429152;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I15 = 0.0002373784;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com x y of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z
//     of left_foot, right_foot
constexpr double left_ankle_cross_I16 = 0.0006797311884980576;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, right_ankle_cross; mass, com, inertia
//     xx xy xz yy zz of left_foot, right_foot
constexpr double left_ankle_cross_I17 = 0.005261427398128842;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, right_ankle_cross; mass, com, inertia
//     xx xy xz yy zz of left_foot, right_foot
constexpr double left_ankle_cross_I18 = 0.012240326341044043;

// ratio: mass, com y z of left_foot, right_foot
constexpr double left_foot_k1 = 0.2614691411136524;
// ratio: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_k2 = 0.06420257671733756;
// ratio: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_k3 = 1.4775221277222959;
// kg: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_m1 = 0.20348896210634942;
// m: points of left_foot, right_foot
constexpr double left_foot_l1 = 0.05903;
// m: points of left_foot, right_foot
constexpr double left_foot_l2 = 0.06;
// m: points of left_foot, right_foot
constexpr double left_foot_l3 = 0.20904;
// kg m: mass, com y z of left_foot, right_foot
constexpr double left_foot_h1 = 0.014128635491404699;
// kg m: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_h2 = 0.020875371573073016;
// kg m: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_h3 = 0.0009070948040482083;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com y z, inertia xx yy zz, offset z of
//     left_foot, right_foot
constexpr double left_foot_h4 = 0.0020348896210634943;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_I1 = 6.298136129784905e-05;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_I2 = 0.0014494177603079786;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I3 = 7.233379265339546e-05;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I4 = 0.00013282817963685661;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr double left_foot_I5 = 0.00028257270982809396;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr double left_foot_I6 = 0.00014128635491404698;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z of left_foot, right_foot
constexpr double left_foot_I7 = 0.00028257270982809396;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I8 = 0.0009809787164016;
// kg m^2: offset z of left_ankle_cross, right_ankle_cross; mass, com y z of left_foot, right_foot
constexpr double left_foot_I9 = 0.006117699167778235;
// kg m^2: offset z of left_shank, right_shank; mass, com y z of left_foot, right_foot
constexpr double left_foot_I10 = 0.00610357053228683;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     y z of left_foot, right_foot
constexpr double left_foot_I11 = 0.0005651454196561879;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I12 = 0.0005569034480192284;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I13 = 0.0004240752683823717;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I14 = 3.616689632669773e-05;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I15 = 0.0005528598823387408;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I16 = 0.00012922325127834232;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I17 = 0.0017174715447863577;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I18 = 0.00025844650255668465;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I19 = 0.0022703314271250983;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I20 = 0.002565622081551101;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I21 = 5.688945862494685e-05;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I22 = 0.001253161185709451;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I23 = 7.150927269120863e-05;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I24 = 0.0005609470136997158;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, inertia xx yy zz, offset z of
//     left_foot, right_foot
constexpr double left_foot_I25 = 2.0348896210634942e-05;
// kg^-1 m^-2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_p1 = 1019.3901083482966;
// m^-1: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_p2 = 14.402591264396625;

}  // namespace

void mass_matrix(const Scalar q[18], Scalar A[324]) noexcept {
  const auto [s_base_rz, c_base_rz] = sine_cosine(q[3]);
  const auto [s_base_ry, c_base_ry] = sine_cosine(q[4]);
  const auto [s_base_rx, c_base_rx] = sine_cosine(q[5]);
  const auto [s_left_hip_yaw, c_left_hip_yaw] = sine_cosine(q[6]);
  const auto [s_left_hip_roll, c_left_hip_roll] = sine_cosine(q[7]);
  // left_shank
  const auto [s_left_hip_pitch, c_left_hip_pitch] = sine_cosine(q[8]);
  const Scalar t_left_shank_1 = left_shank_l1 * c_left_hip_pitch;
  const Scalar t_left_shank_2 = left_shank_l1 * s_left_hip_pitch;
  // left_ankle_cross
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const auto [s_q8_q9_q10, c_q8_q9_q10] = sine_cosine(q_q8_q9_q10);
  const auto [s_q8_q9, c_q8_q9] = sine_cosine(q_q8_q9);
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_l1 * s_q8_q9;
  const Scalar t_left_ankle_cross_2 = left_ankle_cross_l1 * c_q8_q9;
  const Scalar t_left_foot_1 = left_foot_k1 + q[11];
  const auto [s_left_foot, c_left_foot] = sine_cosine(t_left_foot_1);
  const auto [s_right_hip_yaw, c_right_hip_yaw] = sine_cosine(q[12]);
  const auto [s_right_hip_roll, c_right_hip_roll] = sine_cosine(q[13]);
  // right_shank
  const auto [s_right_hip_pitch, c_right_hip_pitch] = sine_cosine(q[14]);
  const Scalar t_right_shank_1 = left_shank_l1 * c_right_hip_pitch;
  const Scalar t_right_shank_2 = left_shank_l1 * s_right_hip_pitch;
  // right_ankle_cross
  const Scalar q_q14_q15 = q[14] + q[15];
  const Scalar q_q14_q15_q16 = q_q14_q15 + q[16];
  const auto [s_q14_q15_q16, c_q14_q15_q16] = sine_cosine(q_q14_q15_q16);
  const auto [s_q14_q15, c_q14_q15] = sine_cosine(q_q14_q15);
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_l1 * c_q14_q15;
  const Scalar t_righ_ankl_cros_2 = left_ankle_cross_l1 * s_q14_q15;
  const Scalar t_right_foot_1 = left_foot_k1 - q[17];
  const auto [s_right_foot, c_right_foot] = sine_cosine(t_right_foot_1);
  // base_ry
  const Scalar Rx_base_ry_y = c_base_rz * c_base_ry;
  const Scalar Ry_base_ry_y = s_base_rz * c_base_ry;
  const Scalar Rx_base_ry_x = c_base_rz * s_base_ry;
  const Scalar t_base_rx_1 = s_base_rz * s_base_rx;
  const Scalar Rx_left_hip_block_z = t_base_rx_1 + c_base_rx * Rx_base_ry_x;
  const Scalar t_base_rx_2 = s_base_rz * c_base_rx;
  const Scalar Rx_base_rx_x = t_base_rx_2 - s_base_rx * Rx_base_ry_x;
  const Scalar Ry_left_hip_block_z = s_base_ry * t_base_rx_2 - c_base_rz * s_base_rx;
  const Scalar t_base_rx_3 = s_base_ry * t_base_rx_1 + c_base_rz * c_base_rx;
  const Scalar t_base_rx_4 = c_base_ry * s_base_rx;
  const Scalar Rz_left_hip_block_z = c_base_ry * c_base_rx;
  const Scalar t_right_foot_2 = left_foot_h1 * c_right_foot;
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_h1 + t_right_foot_2;
  // right_foot
  const Scalar t_right_foot_3 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_4 = left_foot_I3 * c_right_foot + left_foot_I4 * s_right_foot;
  const Scalar t_right_foot_5 = s_right_foot * t_right_foot_4;
  const Scalar t_right_foot_6 = left_foot_I1 * c_right_foot + left_foot_I2 * s_right_foot;
  A[305] = t_right_foot_6;
  A[322] = A[305];
  const Scalar t_right_foot_7 = left_foot_I2 * c_right_foot - left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_8 = left_foot_I6 * s_right_foot;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_3 = t_right_foot_5 - left_foot_I5 * c_right_foot;
  const Scalar t_righ_ankl_cros_4 = left_ankle_cross_h2 * c_q14_q15_q16;
  const Scalar t_righ_ankl_cros_5 = t_righ_ankl_cros_4 - s_q14_q15_q16 * h_righ_ankl_cros_x;
  const Scalar t_right_shank_3 = t_righ_ankl_cros_5 - left_shank_h1 * c_q14_q15;
  const Scalar h_right_shank_y = t_right_shank_3 - left_shank_h2 * s_q14_q15;
  const Scalar t_righ_ankl_cros_6 = left_ankle_cross_h2 * s_q14_q15_q16;
  const Scalar t_righ_ankl_cros_7 = t_righ_ankl_cros_6 + c_q14_q15_q16 * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_7 - left_shank_h1 * s_q14_q15;
  const Scalar t_righ_ankl_cros_9 = t_righ_ankl_cros_8 + left_shank_h2 * c_q14_q15;
  const Scalar t_righ_ankl_cros_10 = c_right_foot * (left_foot_I7 + t_right_foot_4);
  const Scalar t_righ_ankl_cros_11 = left_ankle_cross_I2 + t_right_foot_8;
  const Scalar t_righ_ankl_cros_12 = t_righ_ankl_cros_11 + t_righ_ankl_cros_10;
  const Scalar E_righ_ankl_cros_yz = left_ankle_cross_I1 + t_right_foot_6;
  const Scalar t_righ_ankl_cros_13 = s_q14_q15_q16 * t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_14 = t_righ_ankl_cros_13 - c_q14_q15_q16 * E_righ_ankl_cros_yz;
  A[250] = -t_righ_ankl_cros_14;
  A[301] = A[250];
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_1 * t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_16 = left_ankle_cross_l1 * t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_17 = s_q14_q15 * t_righ_ankl_cros_16;
  const Scalar t_righ_ankl_cros_18 = 2.0 * t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_19 = left_ankle_cross_I4 - t_righ_ankl_cros_3;
  A[304] = t_righ_ankl_cros_19;
  const Scalar t_right_thigh_1 = h_right_shank_y - left_thigh_h1 * s_right_hip_pitch;
  const Scalar h_right_thigh_y = t_right_thigh_1 - left_thigh_h2 * c_right_hip_pitch;
  // right_shank
  const Scalar t_right_shank_4 = t_righ_ankl_cros_9 - left_thigh_h2 * s_right_hip_pitch;
  const Scalar t_right_shank_5 = t_right_shank_4 + left_thigh_h1 * c_right_hip_pitch;
  const Scalar t_right_shank_6 = left_shank_I4 + left_foot_I9 * s_right_foot;
  const Scalar t_righ_ankl_cros_20 = c_q14_q15_q16 * t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_21 = t_righ_ankl_cros_20 + s_q14_q15_q16 * E_righ_ankl_cros_yz;
  const Scalar t_right_shank_7 = t_righ_ankl_cros_21 - left_shank_I3 * s_q14_q15;
  const Scalar E_right_shank_xz = t_right_shank_7 + c_q14_q15 * t_right_shank_6;
  const Scalar t_right_shank_8 = t_righ_ankl_cros_14 + left_shank_I3 * c_q14_q15;
  const Scalar E_right_shank_yz = t_right_shank_8 + s_q14_q15 * t_right_shank_6;
  A[249] = -E_right_shank_yz;
  A[283] = A[249];
  const Scalar t_right_shank_9 = t_righ_ankl_cros_3 - 2.0 * t_righ_ankl_cros_15;
  const Scalar t_right_shank_10 = t_right_shank_9 - (left_shank_I5 - t_righ_ankl_cros_18);
  A[285] = -t_right_shank_10;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_22 = left_ankle_cross_I5 + 2.0 * t_right_foot_7;
  const Scalar t_righ_ankl_cros_23 = left_ankle_cross_I3 + t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_24 = c_q14_q15_q16 * t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_25 = s_q14_q15_q16 * t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_26 = t_righ_ankl_cros_24 + t_righ_ankl_cros_25;
  // right_shank
  const Scalar t_right_shank_11 = t_right_shank_1 * t_righ_ankl_cros_9;
  const Scalar t_right_shank_12 = left_shank_l1 * h_right_shank_y;
  const Scalar t_right_shank_13 = s_right_hip_pitch * t_right_shank_12;
  const Scalar t_right_thigh_2 = left_hip_fork_h1 + t_right_shank_5;
  const Scalar h_right_hip_fork_y = left_hip_fork_h2 + t_right_foot_3;
  // right_thigh
  const Scalar t_right_thigh_3 = left_thigh_I3 + left_foot_I10 * s_right_foot;
  const Scalar t_right_thigh_4 = E_right_shank_xz - left_thigh_I4 * s_right_hip_pitch;
  const Scalar E_right_thigh_xz = t_right_thigh_4 + c_right_hip_pitch * t_right_thigh_3;
  const Scalar t_right_thigh_5 = E_right_shank_yz + left_thigh_I4 * c_right_hip_pitch;
  const Scalar E_right_thigh_yz = t_right_thigh_5 + s_right_hip_pitch * t_right_thigh_3;
  A[248] = -E_right_thigh_yz;
  A[265] = A[248];
  const Scalar t_right_thigh_6 = t_righ_ankl_cros_18 + 2.0 * t_right_shank_13;
  const Scalar t_right_thigh_7 = t_right_shank_9 - 2.0 * t_right_shank_11;
  const Scalar t_right_thigh_8 = t_right_thigh_7 - (left_thigh_I5 - t_right_thigh_6);
  A[266] = -t_right_thigh_8;
  const Scalar t_right_shank_14 = left_thigh_I1 * s_right_hip_pitch;
  const Scalar t_right_shank_15 = t_right_shank_14 + left_thigh_I2 * c_right_hip_pitch;
  const Scalar t_righ_ankl_cros_27 = left_shank_I1 * c_q14_q15 + left_shank_I2 * s_q14_q15;
  // right_hip_fork
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * h_right_hip_fork_y;
  const Scalar t_right_hip_fork_2 = s_right_hip_roll * t_right_thigh_2;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_1 - t_right_hip_fork_2;
  const Scalar t_right_hip_fork_4 = left_hip_block_h1 + t_right_hip_fork_3;
  const Scalar t_right_hip_fork_5 = s_right_hip_roll * h_right_hip_fork_y;
  const Scalar t_right_hip_fork_6 = c_right_hip_roll * t_right_thigh_2;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_5 + t_right_hip_fork_6;
  const Scalar t_right_hip_fork_8 = left_hip_block_h2 + h_right_thigh_y;
  const Scalar t_right_shank_16 = s_right_hip_pitch * t_right_shank_15;
  const Scalar t_right_hip_fork_9 = t_right_shank_16 + s_q14_q15 * t_righ_ankl_cros_27;
  const Scalar t_righ_ankl_cros_28 = s_q14_q15_q16 * t_righ_ankl_cros_26;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_9 - t_righ_ankl_cros_28;
  const Scalar t_right_hip_fork_11 = left_hip_fork_I3 - t_right_thigh_7;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_10 - t_right_hip_fork_11;
  const Scalar t_right_hip_fork_13 = t_right_foot_5 + left_foot_I11 * s_right_foot;
  const Scalar E_right_hip_fork_yy = left_hip_fork_I4 + t_right_hip_fork_13;
  const Scalar t_right_hip_fork_14 = left_hip_fork_I1 + 2.0 * E_right_thigh_xz;
  const Scalar t_right_hip_fork_15 = t_right_hip_fork_12 + E_right_hip_fork_yy;
  const Scalar t_right_hip_fork_16 = s_right_hip_roll * t_right_hip_fork_14;
  const Scalar t_right_hip_fork_17 = c_right_hip_roll * t_right_hip_fork_15;
  const Scalar t_right_hip_fork_18 = t_right_hip_fork_16 - t_right_hip_fork_17;
  const Scalar t_right_hip_fork_19 = c_right_hip_roll * t_right_hip_fork_18;
  const Scalar t_right_hip_fork_20 = E_right_thigh_yz - (left_hip_fork_I5 + t_right_foot_8);
  const Scalar t_righ_ankl_cros_29 = c_q14_q15_q16 * t_righ_ankl_cros_26;
  const Scalar t_right_hip_fork_21 = t_right_shank_12 - t_right_shank_15;
  const Scalar t_right_hip_fork_22 = left_hip_fork_I2 - t_right_foot_7 + t_righ_ankl_cros_29;
  const Scalar t_right_hip_fork_23 = c_right_hip_pitch * t_right_hip_fork_21;
  const Scalar t_right_hip_fork_24 = t_right_hip_fork_22 + t_right_hip_fork_23;
  const Scalar t_right_thigh_9 = left_hip_fork_l1 * t_right_shank_5;
  const Scalar t_righ_ankl_cros_30 = t_righ_ankl_cros_2 * t_righ_ankl_cros_7;
  const Scalar t_right_hip_fork_25 = t_right_hip_fork_24 + t_right_thigh_9;
  const Scalar t_right_hip_fork_26 = t_right_hip_fork_25 - t_righ_ankl_cros_30;
  const Scalar t_right_shank_17 = t_right_shank_2 * t_righ_ankl_cros_9;
  const Scalar t_right_hip_fork_27 = c_q14_q15 * (t_righ_ankl_cros_16 - t_righ_ankl_cros_27);
  const Scalar t_right_hip_fork_28 = t_right_hip_fork_26 - t_right_shank_17;
  const Scalar t_right_hip_fork_29 = t_right_hip_fork_28 + t_right_hip_fork_27;
  const Scalar t_right_hip_fork_30 = s_right_hip_roll * t_right_hip_fork_20;
  const Scalar t_right_hip_fork_31 = c_right_hip_roll * t_right_hip_fork_29;
  const Scalar t_right_hip_fork_32 = t_right_hip_fork_30 - t_right_hip_fork_31;
  A[229] = -t_right_hip_fork_32;
  A[246] = A[229];
  const Scalar t_right_hip_fork_33 = t_right_hip_fork_12 - E_right_hip_fork_yy;
  A[247] = -t_right_hip_fork_33;
  // right_hip_block
  const Scalar t_right_hip_block_1 = c_right_hip_yaw * t_right_hip_fork_8;
  const Scalar t_right_hip_block_2 = s_right_hip_yaw * t_right_hip_fork_4;
  const Scalar t_right_hip_block_3 = t_right_hip_block_1 + t_right_hip_block_2;
  const Scalar t_right_hip_block_4 = c_right_hip_yaw * t_right_hip_fork_4;
  const Scalar t_right_hip_block_5 = s_right_hip_yaw * t_right_hip_fork_8;
  const Scalar t_right_hip_block_6 = t_right_hip_block_4 - t_right_hip_block_5;
  const Scalar t_right_hip_fork_34 = left_hip_block_l2 * t_right_hip_fork_3;
  const Scalar t_right_hip_block_7 = left_hip_block_I1 + E_right_thigh_xz;
  const Scalar t_right_hip_block_8 = t_right_hip_block_7 + t_right_hip_fork_34;
  const Scalar t_right_hip_fork_35 = s_right_hip_roll * t_right_hip_fork_18;
  const Scalar E_right_hip_block_xz = t_right_hip_block_8 - t_right_hip_fork_35;
  const Scalar t_right_hip_block_9 = left_hip_block_I2 - t_right_hip_fork_32;
  const Scalar E_right_hip_block_yz = t_right_hip_block_9 + left_hip_block_l2 * h_right_thigh_y;
  // right_hip_fork
  const Scalar t_right_hip_fork_36 = s_right_hip_roll * t_right_hip_fork_29;
  const Scalar t_right_hip_fork_37 = c_right_hip_roll * t_right_hip_fork_20;
  const Scalar t_right_hip_fork_38 = t_right_hip_fork_36 + t_right_hip_fork_37;
  // right_hip_block
  const Scalar t_right_hip_block_10 = c_right_hip_yaw * E_right_hip_block_yz;
  const Scalar t_right_hip_block_11 = s_right_hip_yaw * E_right_hip_block_xz;
  const Scalar t_right_hip_block_12 = t_right_hip_block_10 + t_right_hip_block_11;
  A[102] = t_right_hip_block_12;
  A[221] = A[102];
  const Scalar t_right_hip_fork_39 = t_right_hip_fork_12 + t_right_hip_fork_19;
  const Scalar E_right_hip_block_xx = left_hip_block_I7 - t_right_hip_fork_39;
  const Scalar t_right_hip_block_13 = t_right_thigh_6 - t_right_hip_fork_10;
  const Scalar t_right_hip_block_14 = t_right_hip_block_13 - left_hip_fork_l2 * h_right_thigh_y;
  const Scalar E_right_hip_block_yy = left_hip_block_I4 - t_right_hip_block_14;
  const Scalar t_right_hip_block_15 = E_right_hip_block_xx + E_right_hip_block_yy;
  A[228] = t_right_hip_block_15;
  const Scalar t_left_foot_2 = left_foot_h1 * c_left_foot;
  const Scalar h_left_ankle_cross_z = left_foot_h1 * s_left_foot;
  // left_foot
  const Scalar t_left_foot_3 = left_foot_I3 * c_left_foot + left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_4 = s_left_foot * t_left_foot_3;
  const Scalar t_left_foot_5 = left_foot_I1 * c_left_foot + left_foot_I2 * s_left_foot;
  A[191] = -t_left_foot_5;
  A[208] = A[191];
  const Scalar t_left_foot_6 = left_foot_I2 * c_left_foot - left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_7 = left_foot_I6 * s_left_foot;
  // left_ankle_cross
  const Scalar h_left_ankle_cross_x = left_ankle_cross_h1 + t_left_foot_2;
  const Scalar t_left_ankle_cross_3 = s_q8_q9_q10 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = left_ankle_cross_h2 * c_q8_q9_q10;
  const Scalar t_left_ankle_cross_5 = t_left_ankle_cross_4 - t_left_ankle_cross_3;
  const Scalar t_left_shank_3 = t_left_ankle_cross_5 - left_shank_h2 * s_q8_q9;
  const Scalar h_left_shank_y = t_left_shank_3 - left_shank_h1 * c_q8_q9;
  const Scalar t_left_ankle_cross_6 = c_q8_q9_q10 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_7 = left_ankle_cross_h2 * s_q8_q9_q10;
  const Scalar t_left_ankle_cross_8 = t_left_ankle_cross_7 + t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_8 - left_shank_h1 * s_q8_q9;
  const Scalar t_left_ankle_cross_10 = t_left_ankle_cross_9 + left_shank_h2 * c_q8_q9;
  const Scalar t_left_ankle_cross_11 = c_left_foot * (left_foot_I7 + t_left_foot_3);
  const Scalar t_left_ankle_cross_12 = left_ankle_cross_I2 + t_left_foot_7;
  const Scalar E_left_ankle_cross_xz = t_left_ankle_cross_12 + t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_13 = left_ankle_cross_I1 + t_left_foot_5;
  const Scalar t_left_ankle_cross_14 = t_left_foot_4 - left_foot_I5 * c_left_foot;
  const Scalar t_left_ankle_cross_15 = left_ankle_cross_I3 + t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_16 = left_ankle_cross_I5 + 2.0 * t_left_foot_6;
  const Scalar t_left_ankle_cross_17 = s_q8_q9_q10 * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_18 = c_q8_q9_q10 * t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_19 = t_left_ankle_cross_17 + t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_20 = c_q8_q9_q10 * t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_21 = s_q8_q9_q10 * E_left_ankle_cross_xz;
  const Scalar t_left_ankle_cross_22 = t_left_ankle_cross_20 - t_left_ankle_cross_21;
  A[136] = -t_left_ankle_cross_22;
  A[187] = A[136];
  const Scalar t_left_ankle_cross_23 = t_left_ankle_cross_2 * t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_24 = left_ankle_cross_l1 * t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_25 = s_q8_q9 * t_left_ankle_cross_24;
  const Scalar t_left_ankle_cross_26 = 2.0 * t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_27 = left_ankle_cross_I4 - t_left_ankle_cross_14;
  A[190] = t_left_ankle_cross_27;
  const Scalar t_left_ankle_cross_28 = t_left_ankle_cross_1 * h_left_ankle_cross_z;
  const Scalar t_left_shank_4 = t_left_ankle_cross_10 - left_thigh_h2 * s_left_hip_pitch;
  const Scalar t_left_shank_5 = t_left_shank_4 + left_thigh_h1 * c_left_hip_pitch;
  const Scalar t_left_thigh_1 = h_left_shank_y - left_thigh_h2 * c_left_hip_pitch;
  const Scalar h_left_thigh_y = t_left_thigh_1 - left_thigh_h1 * s_left_hip_pitch;
  const Scalar t_left_ankle_cross_29 = s_q8_q9_q10 * t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_30 = c_q8_q9_q10 * E_left_ankle_cross_xz;
  const Scalar t_left_ankle_cross_31 = t_left_ankle_cross_29 + t_left_ankle_cross_30;
  // left_shank
  const Scalar t_left_shank_6 = c_q8_q9 * (left_shank_I4 + left_foot_I9 * s_left_foot);
  const Scalar t_left_shank_7 = t_left_ankle_cross_31 - left_shank_I3 * s_q8_q9;
  const Scalar t_left_shank_8 = t_left_shank_7 + t_left_shank_6;
  const Scalar t_left_shank_9 = t_left_ankle_cross_22 - t_left_ankle_cross_28;
  const Scalar t_left_shank_10 = t_left_shank_9 - left_shank_I4 * s_q8_q9;
  const Scalar E_left_shank_yz = t_left_shank_10 - left_shank_I3 * c_q8_q9;
  A[135] = -E_left_shank_yz;
  A[169] = A[135];
  const Scalar t_left_shank_11 = t_left_ankle_cross_14 - 2.0 * t_left_ankle_cross_23;
  const Scalar t_left_shank_12 = t_left_shank_11 - (left_shank_I5 - t_left_ankle_cross_26);
  A[171] = -t_left_shank_12;
  const Scalar t_left_shank_13 = t_left_shank_1 * t_left_ankle_cross_10;
  const Scalar t_left_shank_14 = left_shank_l1 * h_left_shank_y;
  const Scalar t_left_shank_15 = s_left_hip_pitch * t_left_shank_14;
  // left_thigh
  const Scalar t_left_thigh_2 = left_hip_fork_h1 + t_left_shank_5;
  const Scalar t_left_thigh_3 = left_hip_fork_h2 + h_left_ankle_cross_z;
  const Scalar t_left_thigh_4 = left_thigh_I3 + left_foot_I10 * s_left_foot;
  const Scalar t_left_thigh_5 = t_left_shank_8 - left_thigh_I4 * s_left_hip_pitch;
  const Scalar t_left_thigh_6 = t_left_thigh_5 + c_left_hip_pitch * t_left_thigh_4;
  const Scalar t_left_thigh_7 = E_left_shank_yz - left_thigh_I4 * c_left_hip_pitch;
  const Scalar E_left_thigh_yz = t_left_thigh_7 - s_left_hip_pitch * t_left_thigh_4;
  A[134] = -E_left_thigh_yz;
  A[151] = A[134];
  const Scalar t_left_ankle_cross_32 = left_shank_I1 * c_q8_q9 + left_shank_I2 * s_q8_q9;
  // left_shank
  const Scalar t_left_shank_16 = left_thigh_I2 * c_left_hip_pitch;
  const Scalar t_left_shank_17 = t_left_shank_16 + left_thigh_I1 * s_left_hip_pitch;
  const Scalar t_left_shank_18 = s_left_hip_pitch * t_left_shank_17;
  // left_thigh
  const Scalar t_left_thigh_8 = s_q8_q9 * t_left_ankle_cross_32 + t_left_shank_18;
  const Scalar t_left_thigh_9 = t_left_thigh_8 - s_q8_q9_q10 * t_left_ankle_cross_19;
  const Scalar t_left_thigh_10 = t_left_ankle_cross_26 - t_left_thigh_9;
  const Scalar t_left_thigh_11 = t_left_thigh_10 + 2.0 * t_left_shank_15;
  const Scalar t_left_thigh_12 = t_left_shank_11 + t_left_thigh_9 - 2.0 * t_left_shank_13;
  const Scalar t_left_thigh_13 = t_left_thigh_12 - (left_thigh_I5 - t_left_thigh_11);
  A[152] = -t_left_thigh_13;
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * t_left_thigh_3;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + s_left_hip_roll * t_left_thigh_2;
  const Scalar h_left_hip_block_x = left_hip_block_h1 + t_left_hip_fork_2;
  // left_hip_fork
  const Scalar t_left_hip_fork_3 = c_left_hip_roll * t_left_thigh_2;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 - s_left_hip_roll * t_left_thigh_3;
  const Scalar t_left_hip_fork_5 = left_hip_block_h2 + h_left_thigh_y;
  const Scalar t_left_hip_fork_6 = left_hip_fork_I5 + t_left_foot_7 + E_left_thigh_yz;
  const Scalar t_left_shank_19 = t_left_shank_2 * t_left_ankle_cross_10;
  const Scalar t_left_hip_fork_7 = left_hip_fork_I2 - t_left_foot_6 - t_left_shank_19;
  const Scalar t_left_ankle_cross_33 = t_left_ankle_cross_1 * t_left_ankle_cross_8;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_7 - t_left_ankle_cross_33;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_8 + left_hip_fork_l1 * t_left_shank_5;
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_9 + c_q8_q9_q10 * t_left_ankle_cross_19;
  const Scalar t_left_hip_fork_11 = c_left_hip_pitch * (t_left_shank_14 - t_left_shank_17);
  const Scalar t_left_hip_fork_12 = c_q8_q9 * (t_left_ankle_cross_24 - t_left_ankle_cross_32);
  const Scalar t_left_hip_fork_13 = t_left_hip_fork_10 + t_left_hip_fork_11;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_13 + t_left_hip_fork_12;
  const Scalar t_left_hip_fork_15 = c_left_hip_roll * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_16 = t_left_hip_fork_15 - s_left_hip_roll * t_left_hip_fork_6;
  A[115] = t_left_hip_fork_16;
  A[132] = A[115];
  const Scalar E_left_hip_fork_xx = left_hip_fork_I3 - t_left_thigh_12;
  const Scalar t_left_hip_fork_17 = t_left_foot_4 + left_foot_I11 * s_left_foot;
  const Scalar E_left_hip_fork_yy = left_hip_fork_I4 + t_left_hip_fork_17;
  const Scalar t_left_hip_fork_18 = left_hip_fork_I1 + 2.0 * t_left_thigh_6;
  const Scalar t_left_hip_fork_19 = c_left_hip_roll * (E_left_hip_fork_xx - E_left_hip_fork_yy);
  const Scalar t_left_hip_fork_20 = s_left_hip_roll * t_left_hip_fork_18 - t_left_hip_fork_19;
  const Scalar t_left_hip_fork_21 = c_left_hip_roll * t_left_hip_fork_20;
  const Scalar t_left_hip_fork_22 = s_left_hip_roll * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_23 = t_left_hip_fork_22 + c_left_hip_roll * t_left_hip_fork_6;
  const Scalar t_left_hip_fork_24 = E_left_hip_fork_xx + E_left_hip_fork_yy;
  A[133] = t_left_hip_fork_24;
  // left_hip_block
  const Scalar t_left_hip_block_1 = c_left_hip_yaw * t_left_hip_fork_5;
  const Scalar t_left_hip_block_2 = s_left_hip_yaw * h_left_hip_block_x - t_left_hip_block_1;
  const Scalar t_left_hip_block_3 = s_left_hip_yaw * t_left_hip_fork_5;
  const Scalar t_left_hip_block_4 = c_left_hip_yaw * h_left_hip_block_x + t_left_hip_block_3;
  const Scalar t_left_hip_block_5 = base_rx_h1 - t_right_hip_block_6 + t_left_hip_block_4;
  const Scalar t_base_rx_5 = t_right_hip_fork_7 + t_left_hip_fork_4;
  const Scalar t_left_hip_block_6 = base_rx_h3 - t_base_rx_5;
  const Scalar t_left_hip_fork_25 = left_hip_block_l2 * t_left_hip_fork_2;
  const Scalar t_left_hip_block_7 = left_hip_block_I1 + t_left_thigh_6 + t_left_hip_fork_25;
  const Scalar t_left_hip_fork_26 = s_left_hip_roll * t_left_hip_fork_20;
  const Scalar t_left_hip_block_8 = t_left_hip_block_7 - t_left_hip_fork_26;
  const Scalar t_left_hip_block_9 = left_hip_block_I2 + t_left_hip_fork_16;
  const Scalar E_left_hip_block_yz = t_left_hip_block_9 + left_hip_block_l2 * h_left_thigh_y;
  const Scalar t_left_hip_block_10 = t_left_thigh_11 - left_hip_fork_l2 * h_left_thigh_y;
  const Scalar t_left_hip_fork_27 = E_left_hip_fork_xx + t_left_hip_fork_21;
  const Scalar t_left_hip_block_11 = left_hip_block_I5 - t_left_hip_block_10;
  const Scalar t_left_hip_block_12 = left_hip_block_I3 - 2.0 * t_left_hip_fork_23;
  const Scalar t_left_hip_block_13 = t_left_hip_fork_27 - t_left_hip_block_11;
  const Scalar t_left_hip_block_14 = c_left_hip_yaw * t_left_hip_block_12;
  const Scalar t_left_hip_block_15 = s_left_hip_yaw * t_left_hip_block_13;
  const Scalar t_left_hip_block_16 = t_left_hip_block_14 + t_left_hip_block_15;
  const Scalar t_left_hip_block_17 = s_left_hip_yaw * t_left_hip_block_8;
  const Scalar t_left_hip_block_18 = c_left_hip_yaw * E_left_hip_block_yz - t_left_hip_block_17;
  A[96] = t_left_hip_block_18;
  A[113] = A[96];
  const Scalar t_left_hip_block_19 = c_left_hip_yaw * t_left_hip_block_8;
  const Scalar t_left_hip_block_20 = t_left_hip_block_19 + s_left_hip_yaw * E_left_hip_block_yz;
  const Scalar t_left_hip_block_21 = left_hip_block_I6 - t_left_hip_block_10;
  const Scalar t_left_hip_block_22 = t_left_hip_fork_27 + t_left_hip_block_21;
  A[114] = t_left_hip_block_22;
  // right_hip_block
  const Scalar t_right_hip_block_16 = s_right_hip_yaw * E_right_hip_block_yz;
  const Scalar t_right_hip_block_17 = c_right_hip_yaw * E_right_hip_block_xz;
  const Scalar t_right_hip_block_18 = t_right_hip_block_16 - t_right_hip_block_17;
  // base_rx
  const Scalar t_base_rx_6 = left_hip_block_l1 * (t_right_hip_fork_7 - t_left_hip_fork_4);
  const Scalar t_base_rx_7 = t_right_hip_block_18 - (base_rx_I6 - t_left_hip_block_20);
  const Scalar t_base_rx_8 = t_base_rx_7 - t_base_rx_6;
  // right_hip_block
  const Scalar t_right_hip_block_19 = left_hip_block_I3 + 2.0 * t_right_hip_fork_38;
  const Scalar t_right_hip_block_20 = E_right_hip_block_xx - E_right_hip_block_yy;
  const Scalar t_right_hip_block_21 = c_right_hip_yaw * t_right_hip_block_19;
  const Scalar t_right_hip_block_22 = s_right_hip_yaw * t_right_hip_block_20;
  const Scalar t_right_hip_block_23 = t_right_hip_block_21 - t_right_hip_block_22;
  // base_rx
  const Scalar t_base_rx_9 = base_rx_I5 + t_right_hip_fork_38 + t_left_hip_fork_23;
  const Scalar t_base_rx_10 = t_base_rx_9 + c_left_hip_yaw * t_left_hip_block_16;
  const Scalar t_base_rx_11 = t_right_hip_block_3 + t_left_hip_block_2;
  const Scalar t_base_rx_12 = t_base_rx_10 - c_right_hip_yaw * t_right_hip_block_23;
  const Scalar E_base_rx_xz = t_base_rx_12 + left_hip_block_l1 * t_base_rx_11;
  const Scalar E_base_rx_yz = t_left_hip_block_18 - (base_rx_I1 - t_right_hip_block_12);
  const Scalar t_right_hip_block_24 = s_right_hip_yaw * t_right_hip_block_23;
  const Scalar t_base_rx_13 = t_right_hip_block_24 - s_left_hip_yaw * t_left_hip_block_16;
  const Scalar t_base_rx_14 = base_rx_I3 - t_right_hip_fork_39 + t_left_hip_fork_27;
  const Scalar t_base_rx_15 = t_right_hip_block_6 + t_left_hip_block_4;
  const Scalar E_base_rx_xx = t_base_rx_13 + t_base_rx_14 + left_hip_block_l3 * t_base_rx_15;
  const Scalar t_base_rx_16 = base_rx_I4 + t_right_hip_fork_13 + t_right_hip_fork_19;
  const Scalar t_base_rx_17 = t_left_hip_fork_21 - (t_left_hip_fork_17 + t_base_rx_16);
  const Scalar t_base_rx_18 = t_base_rx_17 - left_hip_block_l4 * t_base_rx_5;
  const Scalar t_base_rx_19 = E_base_rx_xx - t_base_rx_18;
  A[95] = t_base_rx_19;
  const Scalar t_base_rx_20 = t_left_hip_block_10 - (base_rx_I2 - t_right_hip_block_14);
  const Scalar t_base_rx_21 = t_base_rx_13 + t_base_rx_20;
  const Scalar t_base_rx_22 = E_base_rx_xx - t_base_rx_21;
  const Scalar t_base_rx_23 = t_base_rx_18 + t_base_rx_21;
  const Scalar t_right_foot_9 = left_foot_I6 * c_right_foot;
  const Scalar t_right_foot_10 = left_foot_I8 + t_right_foot_9 + left_foot_I7 * s_right_foot;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_31 = c_q14_q15_q16 * t_right_foot_3;
  const Scalar t_righ_ankl_cros_32 = s_q14_q15_q16 * t_right_foot_3;
  const Scalar t_righ_ankl_cros_33 = t_righ_ankl_cros_2 * t_righ_ankl_cros_31;
  const Scalar t_righ_ankl_cros_34 = t_righ_ankl_cros_1 * t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_35 = t_right_foot_6 - t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_36 = t_righ_ankl_cros_35 + t_righ_ankl_cros_34;
  A[287] = t_righ_ankl_cros_36;
  A[321] = A[287];
  const Scalar t_righ_ankl_cros_37 = c_q14_q15_q16 * t_right_foot_10;
  const Scalar t_right_shank_18 = t_right_shank_1 + t_righ_ankl_cros_1;
  const Scalar t_righ_ankl_cros_38 = t_righ_ankl_cros_37 + s_q14_q15_q16 * t_right_foot_7;
  // right_shank
  const Scalar t_right_shank_19 = t_righ_ankl_cros_38 + t_right_foot_2 * t_right_shank_18;
  A[251] = t_right_shank_19;
  A[319] = A[251];
  const Scalar t_right_shank_20 = t_right_shank_2 * t_righ_ankl_cros_31;
  const Scalar t_right_shank_21 = t_righ_ankl_cros_36 - t_right_shank_20;
  const Scalar t_right_shank_22 = t_right_shank_21 + t_right_shank_1 * t_righ_ankl_cros_32;
  A[269] = t_right_shank_22;
  A[320] = A[269];
  // right_thigh
  const Scalar t_right_thigh_10 = t_right_shank_2 + t_righ_ankl_cros_2;
  const Scalar t_right_thigh_11 = t_right_foot_9 - s_q14_q15_q16 * t_right_foot_10;
  const Scalar t_right_thigh_12 = t_right_thigh_11 - t_right_foot_2 * t_right_thigh_10;
  const Scalar t_right_thigh_13 = t_right_thigh_12 + c_q14_q15_q16 * t_right_foot_7;
  const Scalar t_right_thigh_14 = t_right_shank_22 + left_hip_fork_l1 * t_righ_ankl_cros_31;
  // right_hip_fork
  const Scalar t_right_hip_fork_40 = left_hip_block_l2 * t_righ_ankl_cros_32;
  const Scalar t_right_hip_fork_41 = c_right_hip_roll * t_right_thigh_14;
  const Scalar t_right_hip_fork_42 = t_right_hip_fork_40 + t_right_hip_fork_41;
  const Scalar t_right_hip_fork_43 = s_right_hip_roll * t_right_thigh_13;
  const Scalar t_right_hip_fork_44 = t_right_hip_fork_42 - t_right_hip_fork_43;
  const Scalar t_right_hip_fork_45 = s_right_hip_roll * t_right_thigh_14;
  const Scalar t_right_hip_fork_46 = c_right_hip_roll * t_right_thigh_13;
  const Scalar t_right_hip_fork_47 = t_right_hip_fork_45 + t_right_hip_fork_46;
  A[233] = t_right_hip_fork_47;
  A[318] = A[233];
  const Scalar t_right_hip_fork_48 = s_right_hip_roll * t_righ_ankl_cros_31;
  const Scalar t_right_hip_fork_49 = t_right_hip_fork_48 + c_right_hip_roll * t_right_foot_2;
  const Scalar t_right_hip_fork_50 = left_hip_block_l2 * t_right_hip_fork_49;
  const Scalar t_right_hip_fork_51 = t_right_shank_19 + t_right_hip_fork_50;
  const Scalar t_right_hip_fork_52 = c_right_hip_roll * t_righ_ankl_cros_31;
  const Scalar t_right_hip_fork_53 = t_right_hip_fork_52 - s_right_hip_roll * t_right_foot_2;
  // right_hip_block
  const Scalar t_right_hip_block_25 = left_hip_block_l1 * t_right_hip_fork_53;
  const Scalar t_right_hip_block_26 = c_right_hip_yaw * t_right_hip_fork_51;
  const Scalar t_right_hip_block_27 = t_right_hip_block_25 + t_right_hip_block_26;
  const Scalar t_right_hip_block_28 = s_right_hip_yaw * t_right_hip_fork_44;
  const Scalar t_right_hip_block_29 = t_right_hip_block_27 - t_right_hip_block_28;
  A[107] = t_right_hip_block_29;
  A[311] = A[107];
  const Scalar t_right_hip_block_30 = c_right_hip_yaw * t_right_hip_fork_44;
  const Scalar t_right_hip_block_31 = s_right_hip_yaw * t_right_hip_fork_51;
  const Scalar t_right_hip_block_32 = t_right_hip_block_30 + t_right_hip_block_31;
  const Scalar t_right_hip_block_33 = c_right_hip_yaw * t_righ_ankl_cros_32;
  const Scalar t_right_hip_block_34 = s_right_hip_yaw * t_right_hip_fork_49;
  const Scalar t_right_hip_block_35 = t_right_hip_block_33 + t_right_hip_block_34;
  const Scalar t_right_hip_block_36 = left_hip_block_l1 * t_right_hip_block_35;
  const Scalar t_right_hip_block_37 = t_right_hip_fork_47 - t_right_hip_block_36;
  const Scalar t_right_hip_block_38 = s_right_hip_yaw * t_righ_ankl_cros_32;
  const Scalar t_right_hip_block_39 = c_right_hip_yaw * t_right_hip_fork_49;
  const Scalar t_right_hip_block_40 = t_right_hip_block_38 - t_right_hip_block_39;
  A[89] = c_base_rx * t_right_hip_block_32 - s_base_rx * t_right_hip_block_37;
  A[310] = A[89];
  // base_rz
  const Scalar t_base_rz_1 = Rz_left_hip_block_z * t_right_hip_block_37;
  const Scalar t_base_rz_2 = t_base_rz_1 - s_base_ry * t_right_hip_block_29;
  A[71] = t_base_rz_2 + t_base_rx_4 * t_right_hip_block_32;
  A[309] = A[71];
  const Scalar t_base_rz_3 = Ry_left_hip_block_z * t_right_hip_fork_53;
  const Scalar t_base_rz_4 = t_base_rz_3 + Ry_base_ry_y * t_right_hip_block_35;
  A[35] = -(t_base_rz_4 + t_base_rx_3 * t_right_hip_block_40);
  A[307] = A[35];
  const Scalar t_base_rz_5 = Rx_left_hip_block_z * t_right_hip_fork_53;
  const Scalar t_base_rz_6 = t_base_rz_5 - Rx_base_rx_x * t_right_hip_block_40;
  A[17] = -(t_base_rz_6 + Rx_base_ry_y * t_right_hip_block_35);
  A[306] = A[17];
  const Scalar t_base_rz_7 = Rz_left_hip_block_z * t_right_hip_fork_53;
  const Scalar t_base_rz_8 = s_base_ry * t_right_hip_block_35 - t_base_rz_7;
  A[53] = t_base_rz_8 - t_base_rx_4 * t_right_hip_block_40;
  A[308] = A[53];
  const Scalar t_righ_ankl_cros_39 = t_righ_ankl_cros_15 - t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_40 = t_righ_ankl_cros_19 + t_righ_ankl_cros_39;
  A[286] = t_righ_ankl_cros_40;
  A[303] = A[286];
  // right_shank
  const Scalar t_right_shank_23 = t_right_shank_2 * t_righ_ankl_cros_5;
  const Scalar t_right_shank_24 = t_righ_ankl_cros_40 - t_right_shank_23;
  const Scalar t_right_shank_25 = t_right_shank_24 + t_right_shank_1 * t_righ_ankl_cros_7;
  A[268] = t_right_shank_25;
  A[302] = A[268];
  const Scalar t_right_thigh_15 = t_right_shank_25 + left_hip_fork_l1 * t_righ_ankl_cros_5;
  // right_hip_fork
  const Scalar t_right_hip_fork_54 = s_right_hip_roll * t_righ_ankl_cros_21;
  const Scalar t_right_hip_fork_55 = c_right_hip_roll * t_right_thigh_15;
  const Scalar t_right_hip_fork_56 = t_right_hip_fork_54 + t_right_hip_fork_55;
  const Scalar t_right_hip_fork_57 = left_hip_block_l2 * t_righ_ankl_cros_7;
  const Scalar t_right_hip_fork_58 = t_right_hip_fork_56 + t_right_hip_fork_57;
  const Scalar t_right_hip_fork_59 = c_right_hip_roll * t_righ_ankl_cros_21;
  const Scalar t_right_hip_fork_60 = s_right_hip_roll * t_right_thigh_15;
  const Scalar t_right_hip_fork_61 = t_right_hip_fork_59 - t_right_hip_fork_60;
  A[232] = -t_right_hip_fork_61;
  A[300] = A[232];
  const Scalar t_right_hip_fork_62 = s_right_hip_roll * t_righ_ankl_cros_5;
  const Scalar t_right_hip_fork_63 = left_hip_block_l2 * t_right_hip_fork_62;
  const Scalar t_right_hip_fork_64 = t_righ_ankl_cros_14 - t_right_hip_fork_63;
  const Scalar t_right_hip_fork_65 = c_right_hip_roll * t_righ_ankl_cros_5;
  // right_hip_block
  const Scalar t_right_hip_block_41 = left_hip_block_l1 * t_right_hip_fork_65;
  const Scalar t_right_hip_block_42 = s_right_hip_yaw * t_right_hip_fork_58;
  const Scalar t_right_hip_block_43 = t_right_hip_block_41 - t_right_hip_block_42;
  const Scalar t_right_hip_block_44 = c_right_hip_yaw * t_right_hip_fork_64;
  const Scalar t_right_hip_block_45 = t_right_hip_block_43 - t_right_hip_block_44;
  A[106] = t_right_hip_block_45;
  A[293] = A[106];
  const Scalar t_right_hip_block_46 = s_right_hip_yaw * t_right_hip_fork_62;
  const Scalar t_right_hip_block_47 = c_right_hip_yaw * t_righ_ankl_cros_7;
  const Scalar t_right_hip_block_48 = t_right_hip_block_46 + t_right_hip_block_47;
  const Scalar t_right_hip_block_49 = left_hip_block_l1 * t_right_hip_block_48;
  const Scalar t_right_hip_block_50 = t_right_hip_fork_61 + t_right_hip_block_49;
  const Scalar t_right_hip_block_51 = c_right_hip_yaw * t_right_hip_fork_62;
  const Scalar t_right_hip_block_52 = s_right_hip_yaw * t_righ_ankl_cros_7;
  const Scalar t_right_hip_block_53 = t_right_hip_block_51 - t_right_hip_block_52;
  const Scalar t_right_hip_block_54 = c_right_hip_yaw * t_right_hip_fork_58;
  const Scalar t_right_hip_block_55 = s_right_hip_yaw * t_right_hip_fork_64;
  const Scalar t_right_hip_block_56 = t_right_hip_block_54 - t_right_hip_block_55;
  A[88] = c_base_rx * t_right_hip_block_56 + s_base_rx * t_right_hip_block_50;
  A[292] = A[88];
  // base_rz
  const Scalar t_base_rz_9 = Rz_left_hip_block_z * t_right_hip_block_50;
  const Scalar t_base_rz_10 = t_base_rz_9 + s_base_ry * t_right_hip_block_45;
  A[70] = t_base_rx_4 * t_right_hip_block_56 - t_base_rz_10;
  A[291] = A[70];
  const Scalar t_base_rz_11 = Rx_left_hip_block_z * t_right_hip_fork_65;
  const Scalar t_base_rz_12 = t_base_rz_11 + Rx_base_ry_y * t_right_hip_block_48;
  A[16] = -(t_base_rz_12 + Rx_base_rx_x * t_right_hip_block_53);
  A[288] = A[16];
  const Scalar t_base_rz_13 = Rz_left_hip_block_z * t_right_hip_fork_65;
  const Scalar t_base_rz_14 = t_base_rz_13 - s_base_ry * t_right_hip_block_48;
  A[52] = t_base_rx_4 * t_right_hip_block_53 - t_base_rz_14;
  A[290] = A[52];
  const Scalar t_base_rz_15 = Ry_left_hip_block_z * t_right_hip_fork_65;
  const Scalar t_base_rz_16 = t_base_rz_15 + Ry_base_ry_y * t_right_hip_block_48;
  A[34] = t_base_rx_3 * t_right_hip_block_53 - t_base_rz_16;
  A[289] = A[34];
  const Scalar t_right_shank_26 = t_right_shank_10 - t_right_shank_11 + t_right_shank_13;
  A[267] = -t_right_shank_26;
  A[284] = A[267];
  const Scalar t_right_thigh_16 = t_right_shank_26 - left_hip_fork_l1 * h_right_shank_y;
  // right_hip_fork
  const Scalar t_right_hip_fork_66 = left_hip_block_l2 * t_righ_ankl_cros_9;
  const Scalar t_right_hip_fork_67 = c_right_hip_roll * t_right_thigh_16;
  const Scalar t_right_hip_fork_68 = t_right_hip_fork_67 - t_right_hip_fork_66;
  const Scalar t_right_hip_fork_69 = t_right_hip_fork_68 - s_right_hip_roll * E_right_shank_xz;
  const Scalar t_right_hip_fork_70 = s_right_hip_roll * t_right_thigh_16;
  const Scalar t_right_hip_fork_71 = t_right_hip_fork_70 + c_right_hip_roll * E_right_shank_xz;
  A[231] = -t_right_hip_fork_71;
  A[282] = A[231];
  const Scalar t_right_hip_fork_72 = s_right_hip_roll * h_right_shank_y;
  const Scalar t_right_hip_fork_73 = E_right_shank_yz - left_hip_block_l2 * t_right_hip_fork_72;
  const Scalar t_right_hip_fork_74 = c_right_hip_roll * h_right_shank_y;
  // right_hip_block
  const Scalar t_right_hip_block_57 = left_hip_block_l1 * t_right_hip_fork_74;
  const Scalar t_right_hip_block_58 = s_right_hip_yaw * t_right_hip_fork_69;
  const Scalar t_right_hip_block_59 = t_right_hip_block_57 + t_right_hip_block_58;
  const Scalar t_right_hip_block_60 = c_right_hip_yaw * t_right_hip_fork_73;
  const Scalar t_right_hip_block_61 = t_right_hip_block_59 - t_right_hip_block_60;
  A[105] = t_right_hip_block_61;
  A[275] = A[105];
  const Scalar t_right_hip_block_62 = c_right_hip_yaw * t_right_hip_fork_69;
  const Scalar t_right_hip_block_63 = s_right_hip_yaw * t_right_hip_fork_73;
  const Scalar t_right_hip_block_64 = t_right_hip_block_62 + t_right_hip_block_63;
  const Scalar t_right_hip_block_65 = s_right_hip_yaw * t_right_hip_fork_72;
  const Scalar t_right_hip_block_66 = c_right_hip_yaw * t_righ_ankl_cros_9;
  const Scalar t_right_hip_block_67 = t_right_hip_block_65 + t_right_hip_block_66;
  const Scalar t_right_hip_block_68 = left_hip_block_l1 * t_right_hip_block_67;
  const Scalar t_right_hip_block_69 = t_right_hip_fork_71 + t_right_hip_block_68;
  const Scalar t_right_hip_block_70 = c_right_hip_yaw * t_right_hip_fork_72;
  const Scalar t_right_hip_block_71 = s_right_hip_yaw * t_righ_ankl_cros_9;
  const Scalar t_right_hip_block_72 = t_right_hip_block_70 - t_right_hip_block_71;
  A[87] = s_base_rx * t_right_hip_block_69 - c_base_rx * t_right_hip_block_64;
  A[274] = A[87];
  // base_rz
  const Scalar t_base_rz_17 = Rz_left_hip_block_z * t_right_hip_block_69;
  const Scalar t_base_rz_18 = s_base_ry * t_right_hip_block_61 + t_base_rz_17;
  A[69] = -(t_base_rz_18 + t_base_rx_4 * t_right_hip_block_64);
  A[273] = A[69];
  const Scalar t_base_rz_19 = Rz_left_hip_block_z * t_right_hip_fork_74;
  const Scalar t_base_rz_20 = t_base_rz_19 - s_base_ry * t_right_hip_block_67;
  A[51] = t_base_rx_4 * t_right_hip_block_72 - t_base_rz_20;
  A[272] = A[51];
  const Scalar t_base_rz_21 = Rx_left_hip_block_z * t_right_hip_fork_74;
  const Scalar t_base_rz_22 = t_base_rz_21 + Rx_base_rx_x * t_right_hip_block_72;
  A[15] = -(t_base_rz_22 + Rx_base_ry_y * t_right_hip_block_67);
  A[270] = A[15];
  const Scalar t_base_rz_23 = Ry_left_hip_block_z * t_right_hip_fork_74;
  const Scalar t_base_rz_24 = t_base_rz_23 - t_base_rx_3 * t_right_hip_block_72;
  A[33] = -(t_base_rz_24 + Ry_base_ry_y * t_right_hip_block_67);
  A[271] = A[33];
  const Scalar t_right_thigh_17 = t_right_thigh_8 - left_hip_fork_l1 * h_right_thigh_y;
  // right_hip_fork
  const Scalar t_right_hip_fork_75 = c_right_hip_roll * t_right_thigh_17;
  const Scalar t_right_hip_fork_76 = s_right_hip_roll * E_right_thigh_xz - t_right_hip_fork_75;
  const Scalar t_right_hip_fork_77 = left_hip_block_l2 * t_right_shank_5;
  const Scalar t_right_hip_fork_78 = t_right_hip_fork_76 + t_right_hip_fork_77;
  const Scalar t_right_hip_fork_79 = s_right_hip_roll * t_right_thigh_17;
  const Scalar t_right_hip_fork_80 = t_right_hip_fork_79 + c_right_hip_roll * E_right_thigh_xz;
  A[230] = -t_right_hip_fork_80;
  A[264] = A[230];
  const Scalar t_right_hip_fork_81 = s_right_hip_roll * h_right_thigh_y;
  const Scalar t_right_hip_fork_82 = E_right_thigh_yz - left_hip_block_l2 * t_right_hip_fork_81;
  const Scalar t_right_hip_fork_83 = c_right_hip_roll * h_right_thigh_y;
  // right_hip_block
  const Scalar t_right_hip_block_73 = left_hip_block_l1 * t_right_hip_fork_83;
  const Scalar t_right_hip_block_74 = c_right_hip_yaw * t_right_hip_fork_82;
  const Scalar t_right_hip_block_75 = t_right_hip_block_73 - t_right_hip_block_74;
  const Scalar t_right_hip_block_76 = s_right_hip_yaw * t_right_hip_fork_78;
  const Scalar t_right_hip_block_77 = t_right_hip_block_75 - t_right_hip_block_76;
  A[104] = t_right_hip_block_77;
  A[257] = A[104];
  const Scalar t_right_hip_block_78 = c_right_hip_yaw * t_right_hip_fork_78;
  const Scalar t_right_hip_block_79 = s_right_hip_yaw * t_right_hip_fork_82;
  const Scalar t_right_hip_block_80 = t_right_hip_block_78 - t_right_hip_block_79;
  const Scalar t_right_hip_block_81 = s_right_hip_yaw * t_right_hip_fork_81;
  const Scalar t_right_hip_block_82 = c_right_hip_yaw * t_right_shank_5;
  const Scalar t_right_hip_block_83 = t_right_hip_block_81 + t_right_hip_block_82;
  const Scalar t_right_hip_block_84 = left_hip_block_l1 * t_right_hip_block_83;
  const Scalar t_right_hip_block_85 = t_right_hip_fork_80 + t_right_hip_block_84;
  const Scalar t_right_hip_block_86 = c_right_hip_yaw * t_right_hip_fork_81;
  const Scalar t_right_hip_block_87 = s_right_hip_yaw * t_right_shank_5;
  const Scalar t_right_hip_block_88 = t_right_hip_block_86 - t_right_hip_block_87;
  A[86] = s_base_rx * t_right_hip_block_85 + c_base_rx * t_right_hip_block_80;
  A[256] = A[86];
  // base_rz
  const Scalar t_base_rz_25 = Rz_left_hip_block_z * t_right_hip_block_85;
  const Scalar t_base_rz_26 = t_base_rz_25 + s_base_ry * t_right_hip_block_77;
  A[68] = t_base_rx_4 * t_right_hip_block_80 - t_base_rz_26;
  A[255] = A[68];
  const Scalar t_base_rz_27 = Rz_left_hip_block_z * t_right_hip_fork_83;
  const Scalar t_base_rz_28 = t_base_rz_27 - s_base_ry * t_right_hip_block_83;
  A[50] = t_base_rx_4 * t_right_hip_block_88 - t_base_rz_28;
  A[254] = A[50];
  const Scalar t_base_rz_29 = Rx_base_rx_x * t_right_hip_block_88;
  const Scalar t_base_rz_30 = t_base_rz_29 + Rx_base_ry_y * t_right_hip_block_83;
  A[14] = -(t_base_rz_30 + Rx_left_hip_block_z * t_right_hip_fork_83);
  A[252] = A[14];
  const Scalar t_base_rz_31 = t_base_rx_3 * t_right_hip_block_88;
  const Scalar t_base_rz_32 = Ry_base_ry_y * t_right_hip_block_83 - t_base_rz_31;
  A[32] = -(t_base_rz_32 + Ry_left_hip_block_z * t_right_hip_fork_83);
  A[253] = A[32];
  const Scalar t_right_hip_fork_84 = left_hip_block_l2 * t_right_hip_fork_7;
  const Scalar t_right_hip_fork_85 = t_right_hip_fork_33 - t_right_hip_fork_84;
  // right_hip_block
  const Scalar t_right_hip_block_89 = left_hip_block_l1 * t_right_hip_fork_3;
  const Scalar t_right_hip_block_90 = c_right_hip_yaw * t_right_hip_fork_85;
  const Scalar t_right_hip_block_91 = t_right_hip_block_89 - t_right_hip_block_90;
  const Scalar t_right_hip_block_92 = s_right_hip_yaw * t_right_hip_fork_38;
  const Scalar t_right_hip_block_93 = t_right_hip_block_91 + t_right_hip_block_92;
  A[103] = t_right_hip_block_93;
  A[239] = A[103];
  const Scalar t_right_hip_block_94 = c_right_hip_yaw * t_right_hip_fork_38;
  const Scalar t_right_hip_block_95 = s_right_hip_yaw * t_right_hip_fork_85;
  const Scalar t_right_hip_block_96 = t_right_hip_block_94 + t_right_hip_block_95;
  const Scalar t_right_hip_block_97 = s_right_hip_yaw * t_right_hip_fork_7;
  const Scalar t_right_hip_block_98 = left_hip_block_l1 * t_right_hip_block_97;
  const Scalar t_right_hip_block_99 = t_right_hip_fork_32 + t_right_hip_block_98;
  A[85] = s_base_rx * t_right_hip_block_99 - c_base_rx * t_right_hip_block_96;
  A[238] = A[85];
  // base_rz
  const Scalar t_base_rz_33 = Rz_left_hip_block_z * t_right_hip_block_99;
  const Scalar t_base_rz_34 = t_base_rz_33 + s_base_ry * t_right_hip_block_93;
  A[67] = -(t_base_rz_34 + t_base_rx_4 * t_right_hip_block_96);
  A[237] = A[67];
  const Scalar t_right_hip_block_100 = c_right_hip_yaw * t_right_hip_fork_7;
  const Scalar t_base_rz_35 = t_base_rx_4 * t_right_hip_block_100;
  const Scalar t_base_rz_36 = s_base_ry * t_right_hip_block_97 + t_base_rz_35;
  A[49] = t_base_rz_36 - Rz_left_hip_block_z * t_right_hip_fork_3;
  A[236] = A[49];
  const Scalar t_base_rz_37 = Ry_left_hip_block_z * t_right_hip_fork_3;
  const Scalar t_base_rz_38 = Ry_base_ry_y * t_right_hip_block_97 + t_base_rz_37;
  A[31] = t_base_rx_3 * t_right_hip_block_100 - t_base_rz_38;
  A[235] = A[31];
  const Scalar t_base_rz_39 = Rx_left_hip_block_z * t_right_hip_fork_3;
  const Scalar t_base_rz_40 = Rx_base_ry_y * t_right_hip_block_97 + t_base_rz_39;
  A[13] = -(t_base_rz_40 + Rx_base_rx_x * t_right_hip_block_100);
  A[234] = A[13];
  const Scalar t_right_hip_block_101 = left_hip_block_l1 * t_right_hip_block_6;
  const Scalar t_right_hip_block_102 = t_right_hip_block_15 + t_right_hip_block_101;
  A[84] = c_base_rx * t_right_hip_block_18 - s_base_rx * t_right_hip_block_102;
  A[220] = A[84];
  const Scalar t_base_rz_41 = Rz_left_hip_block_z * t_right_hip_block_102;
  const Scalar t_base_rz_42 = s_base_ry * t_right_hip_block_12 - t_base_rz_41;
  A[66] = t_base_rx_4 * t_right_hip_block_18 - t_base_rz_42;
  A[219] = A[66];
  A[12] = Rx_base_ry_y * t_right_hip_block_6 - Rx_base_rx_x * t_right_hip_block_3;
  A[216] = A[12];
  A[30] = Ry_base_ry_y * t_right_hip_block_6 + t_base_rx_3 * t_right_hip_block_3;
  A[217] = A[30];
  A[48] = t_base_rx_4 * t_right_hip_block_3 - s_base_ry * t_right_hip_block_6;
  A[218] = A[48];
  const Scalar t_left_foot_8 = left_foot_I6 * c_left_foot;
  const Scalar t_left_foot_9 = left_foot_I8 + t_left_foot_8 + left_foot_I7 * s_left_foot;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_34 = c_q8_q9_q10 * h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_35 = s_q8_q9_q10 * h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_36 = t_left_foot_5 - c_q8_q9_q10 * t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_37 = t_left_ankle_cross_2 * t_left_ankle_cross_35;
  const Scalar t_left_ankle_cross_38 = t_left_ankle_cross_36 + t_left_ankle_cross_37;
  A[173] = -t_left_ankle_cross_38;
  A[207] = A[173];
  // left_shank
  const Scalar t_left_shank_20 = t_left_foot_2 * (t_left_shank_1 + t_left_ankle_cross_2);
  const Scalar t_left_shank_21 = c_q8_q9_q10 * t_left_foot_9 + t_left_shank_20;
  const Scalar t_left_shank_22 = t_left_shank_21 + s_q8_q9_q10 * t_left_foot_6;
  A[137] = t_left_shank_22;
  A[205] = A[137];
  const Scalar t_left_shank_23 = t_left_shank_1 * t_left_ankle_cross_35;
  const Scalar t_left_shank_24 = t_left_ankle_cross_38 + t_left_shank_23;
  const Scalar t_left_shank_25 = t_left_shank_24 - t_left_shank_2 * t_left_ankle_cross_34;
  A[155] = -t_left_shank_25;
  A[206] = A[155];
  // left_thigh
  const Scalar t_left_thigh_14 = t_left_foot_8 + c_q8_q9_q10 * t_left_foot_6;
  const Scalar t_left_thigh_15 = t_left_foot_2 * (t_left_shank_2 + t_left_ankle_cross_1);
  const Scalar t_left_thigh_16 = t_left_thigh_14 - s_q8_q9_q10 * t_left_foot_9;
  const Scalar t_left_thigh_17 = t_left_thigh_16 - t_left_thigh_15;
  const Scalar t_left_thigh_18 = t_left_shank_25 + left_hip_fork_l1 * t_left_ankle_cross_34;
  // left_hip_fork
  const Scalar t_left_hip_fork_28 = left_hip_block_l2 * t_left_ankle_cross_35;
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_28 + c_left_hip_roll * t_left_thigh_18;
  const Scalar t_left_hip_fork_30 = t_left_hip_fork_29 + s_left_hip_roll * t_left_thigh_17;
  const Scalar t_left_hip_fork_31 = s_left_hip_roll * t_left_thigh_18;
  const Scalar t_left_hip_fork_32 = t_left_hip_fork_31 - c_left_hip_roll * t_left_thigh_17;
  A[119] = -t_left_hip_fork_32;
  A[204] = A[119];
  const Scalar t_left_hip_fork_33 = s_left_hip_roll * t_left_ankle_cross_34;
  const Scalar t_left_hip_fork_34 = t_left_hip_fork_33 - c_left_hip_roll * t_left_foot_2;
  const Scalar t_left_hip_fork_35 = t_left_shank_22 - left_hip_block_l2 * t_left_hip_fork_34;
  const Scalar t_left_hip_fork_36 = c_left_hip_roll * t_left_ankle_cross_34;
  const Scalar t_left_hip_fork_37 = t_left_hip_fork_36 + s_left_hip_roll * t_left_foot_2;
  // left_hip_block
  const Scalar t_left_hip_block_23 = c_left_hip_yaw * t_left_hip_fork_35;
  const Scalar t_left_hip_block_24 = s_left_hip_yaw * t_left_hip_fork_30;
  const Scalar t_left_hip_block_25 = t_left_hip_block_23 + t_left_hip_block_24;
  const Scalar t_left_hip_block_26 = left_hip_block_l1 * t_left_hip_fork_37;
  const Scalar t_left_hip_block_27 = t_left_hip_block_25 + t_left_hip_block_26;
  A[101] = t_left_hip_block_27;
  A[203] = A[101];
  const Scalar t_left_hip_block_28 = c_left_hip_yaw * t_left_hip_fork_30;
  const Scalar t_left_hip_block_29 = s_left_hip_yaw * t_left_hip_fork_35;
  const Scalar t_left_hip_block_30 = t_left_hip_block_28 - t_left_hip_block_29;
  const Scalar t_left_hip_block_31 = c_left_hip_yaw * t_left_ankle_cross_35;
  const Scalar t_left_hip_block_32 = s_left_hip_yaw * t_left_hip_fork_34;
  const Scalar t_left_hip_block_33 = t_left_hip_block_31 + t_left_hip_block_32;
  const Scalar t_left_hip_block_34 = left_hip_block_l1 * t_left_hip_block_33;
  const Scalar t_left_hip_block_35 = t_left_hip_fork_32 + t_left_hip_block_34;
  const Scalar t_left_hip_block_36 = s_left_hip_yaw * t_left_ankle_cross_35;
  const Scalar t_left_hip_block_37 = c_left_hip_yaw * t_left_hip_fork_34;
  const Scalar t_left_hip_block_38 = t_left_hip_block_36 - t_left_hip_block_37;
  A[83] = s_base_rx * t_left_hip_block_35 - c_base_rx * t_left_hip_block_30;
  A[202] = A[83];
  // base_rz
  const Scalar t_base_rz_43 = Rz_left_hip_block_z * t_left_hip_block_35;
  const Scalar t_base_rz_44 = s_base_ry * t_left_hip_block_27 + t_base_rz_43;
  A[65] = -(t_base_rz_44 + t_base_rx_4 * t_left_hip_block_30);
  A[201] = A[65];
  const Scalar t_base_rz_45 = Rx_left_hip_block_z * t_left_hip_fork_37;
  const Scalar t_base_rz_46 = Rx_base_ry_y * t_left_hip_block_33 + t_base_rz_45;
  A[11] = t_base_rz_46 - Rx_base_rx_x * t_left_hip_block_38;
  A[198] = A[11];
  const Scalar t_base_rz_47 = Rz_left_hip_block_z * t_left_hip_fork_37;
  const Scalar t_base_rz_48 = s_base_ry * t_left_hip_block_33 - t_base_rz_47;
  A[47] = t_base_rx_4 * t_left_hip_block_38 - t_base_rz_48;
  A[200] = A[47];
  const Scalar t_base_rz_49 = t_base_rx_3 * t_left_hip_block_38;
  const Scalar t_base_rz_50 = Ry_base_ry_y * t_left_hip_block_33 + t_base_rz_49;
  A[29] = t_base_rz_50 + Ry_left_hip_block_z * t_left_hip_fork_37;
  A[199] = A[29];
  const Scalar t_left_ankle_cross_39 = t_left_ankle_cross_23 - t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_40 = t_left_ankle_cross_27 + t_left_ankle_cross_39;
  A[172] = t_left_ankle_cross_40;
  A[189] = A[172];
  // left_shank
  const Scalar t_left_shank_26 = t_left_shank_1 * t_left_ankle_cross_8;
  const Scalar t_left_shank_27 = t_left_ankle_cross_40 + t_left_shank_26;
  const Scalar t_left_shank_28 = t_left_shank_27 - t_left_shank_2 * t_left_ankle_cross_5;
  A[154] = t_left_shank_28;
  A[188] = A[154];
  const Scalar t_left_thigh_19 = t_left_shank_28 + left_hip_fork_l1 * t_left_ankle_cross_5;
  // left_hip_fork
  const Scalar t_left_hip_fork_38 = left_hip_block_l2 * t_left_ankle_cross_8;
  const Scalar t_left_hip_fork_39 = t_left_hip_fork_38 + c_left_hip_roll * t_left_thigh_19;
  const Scalar t_left_hip_fork_40 = s_left_hip_roll * t_left_ankle_cross_31;
  const Scalar t_left_hip_fork_41 = t_left_hip_fork_39 - t_left_hip_fork_40;
  const Scalar t_left_hip_fork_42 = c_left_hip_roll * t_left_ankle_cross_31;
  const Scalar t_left_hip_fork_43 = s_left_hip_roll * t_left_thigh_19 + t_left_hip_fork_42;
  A[118] = t_left_hip_fork_43;
  A[186] = A[118];
  const Scalar t_left_hip_fork_44 = s_left_hip_roll * t_left_ankle_cross_5;
  const Scalar t_left_hip_fork_45 = left_hip_block_l2 * t_left_hip_fork_44;
  const Scalar t_left_hip_fork_46 = t_left_ankle_cross_22 - t_left_hip_fork_45;
  const Scalar t_left_hip_fork_47 = c_left_hip_roll * t_left_ankle_cross_5;
  // left_hip_block
  const Scalar t_left_hip_block_39 = left_hip_block_l1 * t_left_hip_fork_47;
  const Scalar t_left_hip_block_40 = s_left_hip_yaw * t_left_hip_fork_41;
  const Scalar t_left_hip_block_41 = t_left_hip_block_39 + t_left_hip_block_40;
  const Scalar t_left_hip_block_42 = c_left_hip_yaw * t_left_hip_fork_46;
  const Scalar t_left_hip_block_43 = t_left_hip_block_41 + t_left_hip_block_42;
  A[100] = -t_left_hip_block_43;
  A[185] = A[100];
  const Scalar t_left_hip_block_44 = c_left_hip_yaw * t_left_hip_fork_41;
  const Scalar t_left_hip_block_45 = s_left_hip_yaw * t_left_hip_fork_46;
  const Scalar t_left_hip_block_46 = t_left_hip_block_44 - t_left_hip_block_45;
  const Scalar t_left_hip_block_47 = c_left_hip_yaw * t_left_ankle_cross_8;
  const Scalar t_left_hip_block_48 = s_left_hip_yaw * t_left_hip_fork_44;
  const Scalar t_left_hip_block_49 = t_left_hip_block_48 + t_left_hip_block_47;
  const Scalar t_left_hip_block_50 = left_hip_block_l1 * t_left_hip_block_49;
  const Scalar t_left_hip_block_51 = t_left_hip_fork_43 + t_left_hip_block_50;
  const Scalar t_left_hip_block_52 = s_left_hip_yaw * t_left_ankle_cross_8;
  const Scalar t_left_hip_block_53 = c_left_hip_yaw * t_left_hip_fork_44;
  const Scalar t_left_hip_block_54 = t_left_hip_block_53 - t_left_hip_block_52;
  A[82] = c_base_rx * t_left_hip_block_46 - s_base_rx * t_left_hip_block_51;
  A[184] = A[82];
  // base_rz
  const Scalar t_base_rz_51 = Rz_left_hip_block_z * t_left_hip_block_51;
  const Scalar t_base_rz_52 = s_base_ry * t_left_hip_block_43 + t_base_rz_51;
  A[64] = t_base_rz_52 + t_base_rx_4 * t_left_hip_block_46;
  A[183] = A[64];
  const Scalar t_base_rz_53 = Rz_left_hip_block_z * t_left_hip_fork_47;
  const Scalar t_base_rz_54 = t_base_rz_53 - s_base_ry * t_left_hip_block_49;
  A[46] = t_base_rx_4 * t_left_hip_block_54 - t_base_rz_54;
  A[182] = A[46];
  const Scalar t_base_rz_55 = Rx_left_hip_block_z * t_left_hip_fork_47;
  const Scalar t_base_rz_56 = Rx_base_ry_y * t_left_hip_block_49 + t_base_rz_55;
  A[10] = -(t_base_rz_56 + Rx_base_rx_x * t_left_hip_block_54);
  A[180] = A[10];
  const Scalar t_base_rz_57 = t_base_rx_3 * t_left_hip_block_54;
  const Scalar t_base_rz_58 = t_base_rz_57 - Ry_base_ry_y * t_left_hip_block_49;
  A[28] = t_base_rz_58 - Ry_left_hip_block_z * t_left_hip_fork_47;
  A[181] = A[28];
  const Scalar t_left_shank_29 = t_left_shank_12 - t_left_shank_13 + t_left_shank_15;
  A[153] = -t_left_shank_29;
  A[170] = A[153];
  const Scalar t_left_thigh_20 = t_left_shank_29 - left_hip_fork_l1 * h_left_shank_y;
  // left_hip_fork
  const Scalar t_left_hip_fork_48 = s_left_hip_roll * t_left_shank_8;
  const Scalar t_left_hip_fork_49 = t_left_hip_fork_48 + c_left_hip_roll * t_left_thigh_20;
  const Scalar t_left_hip_fork_50 = left_hip_block_l2 * t_left_ankle_cross_10;
  const Scalar t_left_hip_fork_51 = t_left_hip_fork_49 - t_left_hip_fork_50;
  const Scalar t_left_hip_fork_52 = s_left_hip_roll * t_left_thigh_20;
  const Scalar t_left_hip_fork_53 = t_left_hip_fork_52 - c_left_hip_roll * t_left_shank_8;
  A[117] = -t_left_hip_fork_53;
  A[168] = A[117];
  const Scalar t_left_hip_fork_54 = s_left_hip_roll * h_left_shank_y;
  const Scalar t_left_hip_fork_55 = E_left_shank_yz - left_hip_block_l2 * t_left_hip_fork_54;
  const Scalar t_left_hip_fork_56 = c_left_hip_roll * h_left_shank_y;
  // left_hip_block
  const Scalar t_left_hip_block_55 = left_hip_block_l1 * t_left_hip_fork_56;
  const Scalar t_left_hip_block_56 = s_left_hip_yaw * t_left_hip_fork_51;
  const Scalar t_left_hip_block_57 = t_left_hip_block_55 - t_left_hip_block_56;
  const Scalar t_left_hip_block_58 = c_left_hip_yaw * t_left_hip_fork_55;
  const Scalar t_left_hip_block_59 = t_left_hip_block_57 + t_left_hip_block_58;
  A[99] = -t_left_hip_block_59;
  A[167] = A[99];
  const Scalar t_left_hip_block_60 = c_left_hip_yaw * t_left_ankle_cross_10;
  const Scalar t_left_hip_block_61 = s_left_hip_yaw * t_left_hip_fork_54;
  const Scalar t_left_hip_block_62 = t_left_hip_block_61 + t_left_hip_block_60;
  const Scalar t_left_hip_block_63 = left_hip_block_l1 * t_left_hip_block_62;
  const Scalar t_left_hip_block_64 = t_left_hip_fork_53 - t_left_hip_block_63;
  const Scalar t_left_hip_block_65 = s_left_hip_yaw * t_left_ankle_cross_10;
  const Scalar t_left_hip_block_66 = c_left_hip_yaw * t_left_hip_fork_54;
  const Scalar t_left_hip_block_67 = t_left_hip_block_66 - t_left_hip_block_65;
  const Scalar t_left_hip_block_68 = c_left_hip_yaw * t_left_hip_fork_51;
  const Scalar t_left_hip_block_69 = s_left_hip_yaw * t_left_hip_fork_55;
  const Scalar t_left_hip_block_70 = t_left_hip_block_68 + t_left_hip_block_69;
  A[81] = s_base_rx * t_left_hip_block_64 - c_base_rx * t_left_hip_block_70;
  A[166] = A[81];
  // base_rz
  const Scalar t_base_rz_59 = Rz_left_hip_block_z * t_left_hip_block_64;
  const Scalar t_base_rz_60 = s_base_ry * t_left_hip_block_59 - t_base_rz_59;
  A[63] = t_base_rz_60 - t_base_rx_4 * t_left_hip_block_70;
  A[165] = A[63];
  const Scalar t_base_rz_61 = Ry_left_hip_block_z * t_left_hip_fork_56;
  const Scalar t_base_rz_62 = Ry_base_ry_y * t_left_hip_block_62 + t_base_rz_61;
  A[27] = t_base_rx_3 * t_left_hip_block_67 - t_base_rz_62;
  A[163] = A[27];
  const Scalar t_base_rz_63 = Rz_left_hip_block_z * t_left_hip_fork_56;
  const Scalar t_base_rz_64 = t_base_rz_63 - t_base_rx_4 * t_left_hip_block_67;
  A[45] = s_base_ry * t_left_hip_block_62 - t_base_rz_64;
  A[164] = A[45];
  const Scalar t_base_rz_65 = Rx_base_ry_y * t_left_hip_block_62;
  const Scalar t_base_rz_66 = t_base_rz_65 + Rx_base_rx_x * t_left_hip_block_67;
  A[9] = -(t_base_rz_66 + Rx_left_hip_block_z * t_left_hip_fork_56);
  A[162] = A[9];
  const Scalar t_left_thigh_21 = t_left_thigh_13 - left_hip_fork_l1 * h_left_thigh_y;
  // left_hip_fork
  const Scalar t_left_hip_fork_57 = c_left_hip_roll * t_left_thigh_21;
  const Scalar t_left_hip_fork_58 = t_left_hip_fork_57 + s_left_hip_roll * t_left_thigh_6;
  const Scalar t_left_hip_fork_59 = t_left_hip_fork_58 - left_hip_block_l2 * t_left_shank_5;
  const Scalar t_left_hip_fork_60 = s_left_hip_roll * t_left_thigh_21;
  const Scalar t_left_hip_fork_61 = t_left_hip_fork_60 - c_left_hip_roll * t_left_thigh_6;
  A[116] = -t_left_hip_fork_61;
  A[150] = A[116];
  const Scalar t_left_hip_fork_62 = s_left_hip_roll * h_left_thigh_y;
  const Scalar t_left_hip_fork_63 = E_left_thigh_yz - left_hip_block_l2 * t_left_hip_fork_62;
  const Scalar t_left_hip_fork_64 = c_left_hip_roll * h_left_thigh_y;
  // left_hip_block
  const Scalar t_left_hip_block_71 = left_hip_block_l1 * t_left_hip_fork_64;
  const Scalar t_left_hip_block_72 = s_left_hip_yaw * t_left_hip_fork_59;
  const Scalar t_left_hip_block_73 = t_left_hip_block_71 - t_left_hip_block_72;
  const Scalar t_left_hip_block_74 = c_left_hip_yaw * t_left_hip_fork_63;
  const Scalar t_left_hip_block_75 = t_left_hip_block_73 + t_left_hip_block_74;
  A[98] = -t_left_hip_block_75;
  A[149] = A[98];
  const Scalar t_left_hip_block_76 = c_left_hip_yaw * t_left_hip_fork_59;
  const Scalar t_left_hip_block_77 = s_left_hip_yaw * t_left_hip_fork_63;
  const Scalar t_left_hip_block_78 = t_left_hip_block_76 + t_left_hip_block_77;
  const Scalar t_left_hip_block_79 = s_left_hip_yaw * t_left_hip_fork_62;
  const Scalar t_left_hip_block_80 = t_left_hip_block_79 + c_left_hip_yaw * t_left_shank_5;
  const Scalar t_left_hip_block_81 = left_hip_block_l1 * t_left_hip_block_80;
  const Scalar t_left_hip_block_82 = t_left_hip_fork_61 - t_left_hip_block_81;
  const Scalar t_left_hip_block_83 = c_left_hip_yaw * t_left_hip_fork_62;
  const Scalar t_left_hip_block_84 = t_left_hip_block_83 - s_left_hip_yaw * t_left_shank_5;
  A[80] = s_base_rx * t_left_hip_block_82 - c_base_rx * t_left_hip_block_78;
  A[148] = A[80];
  // base_rz
  const Scalar t_base_rz_67 = Rz_left_hip_block_z * t_left_hip_block_82;
  const Scalar t_base_rz_68 = t_base_rz_67 - s_base_ry * t_left_hip_block_75;
  A[62] = -(t_base_rz_68 + t_base_rx_4 * t_left_hip_block_78);
  A[147] = A[62];
  const Scalar t_base_rz_69 = t_base_rx_3 * t_left_hip_block_84;
  const Scalar t_base_rz_70 = t_base_rz_69 - Ry_base_ry_y * t_left_hip_block_80;
  A[26] = t_base_rz_70 - Ry_left_hip_block_z * t_left_hip_fork_64;
  A[145] = A[26];
  const Scalar t_base_rz_71 = Rx_left_hip_block_z * t_left_hip_fork_64;
  const Scalar t_base_rz_72 = t_base_rz_71 + Rx_base_ry_y * t_left_hip_block_80;
  A[8] = -(t_base_rz_72 + Rx_base_rx_x * t_left_hip_block_84);
  A[144] = A[8];
  const Scalar t_base_rz_73 = Rz_left_hip_block_z * t_left_hip_fork_64;
  const Scalar t_base_rz_74 = t_base_rz_73 - s_base_ry * t_left_hip_block_80;
  A[44] = t_base_rx_4 * t_left_hip_block_84 - t_base_rz_74;
  A[146] = A[44];
  const Scalar t_left_hip_fork_65 = left_hip_block_l2 * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_66 = t_left_hip_fork_24 + t_left_hip_fork_65;
  // left_hip_block
  const Scalar t_left_hip_block_85 = left_hip_block_l1 * t_left_hip_fork_2;
  const Scalar t_left_hip_block_86 = c_left_hip_yaw * t_left_hip_fork_66;
  const Scalar t_left_hip_block_87 = t_left_hip_block_86 + t_left_hip_block_85;
  const Scalar t_left_hip_block_88 = s_left_hip_yaw * t_left_hip_fork_23;
  const Scalar t_left_hip_block_89 = t_left_hip_block_87 + t_left_hip_block_88;
  A[97] = t_left_hip_block_89;
  A[131] = A[97];
  const Scalar t_left_hip_block_90 = s_left_hip_yaw * t_left_hip_fork_66;
  const Scalar t_left_hip_block_91 = c_left_hip_yaw * t_left_hip_fork_23;
  const Scalar t_left_hip_block_92 = t_left_hip_block_90 - t_left_hip_block_91;
  const Scalar t_left_hip_block_93 = s_left_hip_yaw * t_left_hip_fork_4;
  const Scalar t_left_hip_block_94 = left_hip_block_l1 * t_left_hip_block_93;
  const Scalar t_left_hip_block_95 = t_left_hip_fork_16 + t_left_hip_block_94;
  A[79] = c_base_rx * t_left_hip_block_92 - s_base_rx * t_left_hip_block_95;
  A[130] = A[79];
  // base_rz
  const Scalar t_base_rz_75 = t_base_rx_4 * t_left_hip_block_92;
  const Scalar t_base_rz_76 = s_base_ry * t_left_hip_block_89 - t_base_rz_75;
  A[61] = Rz_left_hip_block_z * t_left_hip_block_95 - t_base_rz_76;
  A[129] = A[61];
  const Scalar t_left_hip_block_96 = c_left_hip_yaw * t_left_hip_fork_4;
  const Scalar t_base_rz_77 = Rx_left_hip_block_z * t_left_hip_fork_2;
  const Scalar t_base_rz_78 = Rx_base_ry_y * t_left_hip_block_93 - t_base_rz_77;
  A[7] = -(t_base_rz_78 + Rx_base_rx_x * t_left_hip_block_96);
  A[126] = A[7];
  const Scalar t_base_rz_79 = t_base_rx_3 * t_left_hip_block_96;
  const Scalar t_base_rz_80 = Ry_base_ry_y * t_left_hip_block_93 - t_base_rz_79;
  A[25] = Ry_left_hip_block_z * t_left_hip_fork_2 - t_base_rz_80;
  A[127] = A[25];
  const Scalar t_base_rz_81 = t_base_rx_4 * t_left_hip_block_96;
  const Scalar t_base_rz_82 = s_base_ry * t_left_hip_block_93 + t_base_rz_81;
  A[43] = t_base_rz_82 + Rz_left_hip_block_z * t_left_hip_fork_2;
  A[128] = A[43];
  const Scalar t_left_hip_block_97 = left_hip_block_l1 * t_left_hip_block_4;
  const Scalar t_left_hip_block_98 = t_left_hip_block_22 + t_left_hip_block_97;
  A[78] = c_base_rx * t_left_hip_block_20 - s_base_rx * t_left_hip_block_98;
  A[112] = A[78];
  const Scalar t_base_rz_83 = Rz_left_hip_block_z * t_left_hip_block_98;
  const Scalar t_base_rz_84 = s_base_ry * t_left_hip_block_18 - t_base_rz_83;
  A[60] = t_base_rx_4 * t_left_hip_block_20 - t_base_rz_84;
  A[111] = A[60];
  A[6] = Rx_base_rx_x * t_left_hip_block_2 - Rx_base_ry_y * t_left_hip_block_4;
  A[108] = A[6];
  A[24] = -(Ry_base_ry_y * t_left_hip_block_4 + t_base_rx_3 * t_left_hip_block_2);
  A[109] = A[24];
  A[42] = s_base_ry * t_left_hip_block_4 - t_base_rx_4 * t_left_hip_block_2;
  A[110] = A[42];
  const Scalar t_base_rx_24 = c_base_rx * t_left_hip_block_6;
  const Scalar t_base_rx_25 = t_base_rx_24 + s_base_rx * t_left_hip_block_5;
  const Scalar t_base_ry_1 = s_base_rx * E_base_rx_yz - c_base_rx * E_base_rx_xz;
  A[77] = -t_base_ry_1;
  A[94] = A[77];
  const Scalar t_base_rz_85 = t_base_rx_4 * E_base_rx_xz;
  const Scalar t_base_rz_86 = t_base_rz_85 - s_base_ry * t_base_rx_19;
  const Scalar t_base_rz_87 = t_base_rz_86 + Rz_left_hip_block_z * E_base_rx_yz;
  A[59] = t_base_rz_87;
  A[93] = A[59];
  A[5] = Rx_base_rx_x * t_left_hip_block_6 + Rx_left_hip_block_z * t_left_hip_block_5;
  A[90] = A[5];
  A[23] = Ry_left_hip_block_z * t_left_hip_block_5 - t_base_rx_3 * t_left_hip_block_6;
  A[91] = A[23];
  const Scalar t_base_rz_88 = Rz_left_hip_block_z * t_left_hip_block_5;
  const Scalar t_base_rz_89 = t_base_rz_88 - t_base_rx_4 * t_left_hip_block_6;
  A[41] = t_base_rz_89;
  A[92] = A[41];
  const Scalar t_base_ry_2 = s_base_rx * t_base_rx_8;
  const Scalar t_base_ry_3 = t_base_ry_2 + c_base_rx * t_base_rx_23;
  const Scalar t_right_hip_block_103 = base_rx_h2 + t_right_hip_block_3;
  const Scalar t_left_hip_block_99 = t_left_hip_block_2 - t_right_hip_block_103;
  const Scalar t_base_ry_4 = s_base_rx * t_base_rx_22 - c_base_rx * t_base_rx_8;
  A[76] = s_base_rx * t_base_ry_4 - c_base_rx * t_base_ry_3;
  const Scalar t_base_rz_90 = s_base_ry * t_base_ry_1 - Rz_left_hip_block_z * t_base_ry_4;
  A[58] = t_base_rz_90 - t_base_rx_4 * t_base_ry_3;
  A[75] = A[58];
  const Scalar t_base_ry_5 = c_base_rx * t_left_hip_block_99;
  const Scalar t_base_ry_6 = s_base_rx * t_left_hip_block_99;
  const Scalar t_base_rz_91 = Ry_base_ry_y * t_base_rx_25 + t_base_rx_3 * t_base_ry_6;
  A[22] = t_base_rz_91 + Ry_left_hip_block_z * t_base_ry_5;
  A[73] = A[22];
  const Scalar t_base_rz_92 = Rx_base_ry_y * t_base_rx_25 - Rx_base_rx_x * t_base_ry_6;
  A[4] = t_base_rz_92 + Rx_left_hip_block_z * t_base_ry_5;
  A[72] = A[4];
  const Scalar t_base_rz_93 = c_base_ry * t_base_ry_5;
  const Scalar t_base_rz_94 = t_base_rx_4 * t_left_hip_block_99;
  A[40] = c_base_rx * t_base_rz_93 + s_base_rx * t_base_rz_94 - s_base_ry * t_base_rx_25;
  A[74] = A[40];
  const Scalar t_base_rz_95 = Rz_left_hip_block_z * t_base_rx_22;
  const Scalar t_base_rz_96 = c_base_ry * t_base_ry_2 * 2.0 + t_base_rz_95;
  const Scalar t_base_rz_97 = t_base_rx_4 * t_base_rx_4 * t_base_rx_23;
  const Scalar t_base_rz_98 = Rz_left_hip_block_z * (t_base_rz_96 - s_base_ry * E_base_rx_yz);
  A[57] = t_base_rz_98 - (s_base_ry * (t_base_rz_85 + t_base_rz_87) + t_base_rz_97);
  const Scalar t_base_rz_99 = t_base_rz_93 - s_base_ry * t_left_hip_block_6;
  const Scalar t_base_rz_100 = t_base_rz_94 - s_base_ry * t_left_hip_block_5;
  const Scalar t_base_rz_101 = Rx_left_hip_block_z * t_base_rz_100;
  A[3] = t_base_rz_101 + Rx_base_rx_x * t_base_rz_99 - Rx_base_ry_y * t_base_rz_89;
  A[54] = A[3];
  const Scalar t_base_rz_102 = Ry_left_hip_block_z * t_base_rz_100;
  A[21] = -(Ry_base_ry_y * t_base_rz_89 - t_base_rz_102 + t_base_rx_3 * t_base_rz_99);
  A[55] = A[21];
  A[0] = base_rx_m1;
  A[19] = base_rx_m1;
  A[38] = base_rx_m1;
  A[209] = left_foot_I8;
  A[323] = left_foot_I8;
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

void bias_force(const Scalar q[18], const Scalar qd[18], Scalar B[18]) noexcept {
  const auto [s_base_rz, c_base_rz] = sine_cosine(q[3]);
  const auto [s_base_ry, c_base_ry] = sine_cosine(q[4]);
  const auto [s_base_rx, c_base_rx] = sine_cosine(q[5]);
  const auto [s_left_hip_yaw, c_left_hip_yaw] = sine_cosine(q[6]);
  const auto [s_left_hip_roll, c_left_hip_roll] = sine_cosine(q[7]);
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const auto [s_q8_q9_q10, c_q8_q9_q10] = sine_cosine(q_q8_q9_q10);
  // left_shank
  const auto [s_q9_q10, c_q9_q10] = sine_cosine(q_q9_q10);
  const Scalar s_left_shank_x = left_shank_l1 * c_q9_q10;
  const Scalar t_left_shank_1 = left_shank_l1 * s_q9_q10;
  // left_ankle_cross
  const auto [s_left_ankle_pitch, c_left_ankle_pitch] = sine_cosine(q[10]);
  const Scalar s_left_ankle_cross_x = left_ankle_cross_l1 * c_left_ankle_pitch;
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_l1 * s_left_ankle_pitch;
  const auto [s_right_hip_yaw, c_right_hip_yaw] = sine_cosine(q[12]);
  const auto [s_right_hip_roll, c_right_hip_roll] = sine_cosine(q[13]);
  const Scalar q_q15_q16 = q[15] + q[16];
  const Scalar q_q14_q15_q16 = q[14] + q_q15_q16;
  const auto [s_q14_q15_q16, c_q14_q15_q16] = sine_cosine(q_q14_q15_q16);
  // right_shank
  const auto [s_q15_q16, c_q15_q16] = sine_cosine(q_q15_q16);
  const Scalar s_right_shank_x = left_shank_l1 * c_q15_q16;
  const Scalar t_right_shank_1 = left_shank_l1 * s_q15_q16;
  // right_ankle_cross
  const auto [s_right_ankle_pitch, c_right_ankle_pitch] = sine_cosine(q[16]);
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_l1 * s_right_ankle_pitch;
  const Scalar s_righ_ankl_cros_x = left_ankle_cross_l1 * c_right_ankle_pitch;
  // base_ry
  const Scalar omega_base_ry_y = s_base_ry * qd[3];
  const Scalar t_base_ry_1 = c_base_ry * qd[3];
  const Scalar alpha_base_ry_y = qd[4] * t_base_ry_1;
  const Scalar alpha_base_ry_x = omega_base_ry_y * qd[4];
  const Scalar t_base_ry_2 = omega_base_ry_y * t_base_ry_1;
  const Scalar Omega_base_ry_zy = 2.0 * alpha_base_ry_x;
  // base_rx
  const Scalar t_base_rx_1 = c_base_rx * t_base_ry_1 - s_base_rx * qd[4];
  const Scalar t_base_rx_2 = omega_base_ry_y - qd[5];
  const Scalar t_base_rx_3 = s_base_rx * Omega_base_ry_zy - c_base_rx * t_base_ry_2;
  const Scalar Omega_base_rx_zy = t_base_rx_3 + t_base_rx_1 * t_base_rx_2 * 2.0;
  const Scalar t_base_rx_4 = s_base_rx * t_base_ry_1 + c_base_rx * qd[4];
  const Scalar t_base_rx_5 = t_base_rx_2 * t_base_rx_4;
  const Scalar Omega_base_rx_xz = c_base_rx * Omega_base_ry_zy + s_base_rx * t_base_ry_2;
  const Scalar alpha_left_hip_block_z = t_base_rx_5 - Omega_base_rx_xz;
  const Scalar Omega_base_rx_zx = t_base_rx_5 + alpha_left_hip_block_z;
  const Scalar t_base_rx_6 = t_base_rx_4 * t_base_rx_4;
  const Scalar t_base_rx_7 = t_base_rx_2 * t_base_rx_2;
  const Scalar t_base_rx_8 = t_base_rx_6 - t_base_rx_7;
  const Scalar t_base_ry_3 = t_base_ry_1 * t_base_ry_1 + qd[4] * qd[4];
  const Scalar Omega_base_rx_xx = t_base_rx_8 - t_base_ry_3;
  const Scalar t_base_rx_9 = t_base_rx_1 * t_base_rx_4;
  const Scalar t_base_rx_10 = alpha_base_ry_y - t_base_rx_9;
  const Scalar t_base_rx_11 = t_base_rx_6 + t_base_rx_7;
  const Scalar Omega_base_rx_xy = alpha_base_ry_y + t_base_rx_9;
  // left_hip_block
  const Scalar t_left_hip_block_1 = s_left_hip_yaw * Omega_base_rx_zy;
  const Scalar Omega_left_hip_block_xz = t_left_hip_block_1 + c_left_hip_yaw * Omega_base_rx_xy;
  const Scalar t_left_hip_block_2 = s_left_hip_yaw * t_base_rx_2;
  const Scalar omega_left_hip_block_x = t_left_hip_block_2 + c_left_hip_yaw * t_base_rx_4;
  const Scalar omega_left_hip_block_z = t_base_rx_1 + qd[6];
  const Scalar t_left_hip_block_3 = omega_left_hip_block_x * omega_left_hip_block_z;
  const Scalar alpha_left_hip_block_y = Omega_left_hip_block_xz - t_left_hip_block_3;
  const Scalar Omega_left_hip_block_zx = t_left_hip_block_3 - alpha_left_hip_block_y;
  const Scalar t_left_hip_block_4 = c_left_hip_yaw * t_base_rx_2;
  const Scalar omega_left_hip_block_y = t_left_hip_block_4 - s_left_hip_yaw * t_base_rx_4;
  const Scalar t_left_hip_block_5 = c_left_hip_yaw * Omega_base_rx_zy;
  const Scalar Omega_left_hip_block_yz = t_left_hip_block_5 - s_left_hip_yaw * Omega_base_rx_xy;
  const Scalar t_left_hip_block_6 = omega_left_hip_block_z * omega_left_hip_block_y * 2.0;
  const Scalar t_left_hip_block_7 = Omega_left_hip_block_yz - t_left_hip_block_6;
  const Scalar t_left_hip_block_8 = left_hip_block_l1 * Omega_base_rx_zx;
  const Scalar t_left_hip_block_9 = left_hip_block_l1 * Omega_base_rx_xx;
  const Scalar t_left_hip_block_10 = omega_left_hip_block_x * omega_left_hip_block_x;
  const Scalar t_left_hip_block_11 = omega_left_hip_block_z * omega_left_hip_block_z;
  const Scalar t_left_hip_block_12 = t_left_hip_block_10 + t_left_hip_block_11;
  const Scalar t_left_hip_block_13 = omega_left_hip_block_x * omega_left_hip_block_y;
  const Scalar t_left_hip_block_14 = alpha_left_hip_block_z - t_left_hip_block_13;
  const Scalar Omega_left_hip_block_yx = alpha_left_hip_block_z + t_left_hip_block_13;
  const Scalar a_right_hip_block_z = left_hip_block_l1 * t_base_rx_10;
  const Scalar t_left_hip_block_15 = left_hip_block_I13 * t_base_rx_10;
  const Scalar t_left_hip_block_16 = left_hip_block_I14 * t_base_rx_10;
  const Scalar t_left_hip_block_17 = t_left_hip_block_10 - t_left_hip_block_11;
  // left_hip_fork
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * t_left_hip_block_7;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * t_left_hip_block_14;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_1 + t_left_hip_fork_2;
  const Scalar t_left_hip_fork_4 = s_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_5 = c_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_4 + t_left_hip_fork_5;
  const Scalar t_left_hip_fork_7 = omega_left_hip_block_y - qd[7];
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_6 * t_left_hip_fork_7 * 2.0;
  const Scalar Omega_left_hip_fork_zy = t_left_hip_fork_3 + t_left_hip_fork_8;
  const Scalar t_left_hip_fork_9 = s_left_hip_roll * t_left_hip_block_14;
  const Scalar t_left_hip_fork_10 = c_left_hip_roll * t_left_hip_block_7;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_9 - t_left_hip_fork_10;
  const Scalar t_left_hip_fork_12 = c_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_13 = s_left_hip_roll * omega_left_hip_block_x;
  const Scalar omega_left_hip_fork_x = t_left_hip_fork_12 - t_left_hip_fork_13;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_7 * omega_left_hip_fork_x;
  const Scalar alpha_left_thigh_z = t_left_hip_fork_11 - t_left_hip_fork_14;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_14 - alpha_left_thigh_z;
  const Scalar t_left_hip_block_18 = s_left_hip_yaw * t_left_hip_block_8;
  const Scalar a_left_hip_block_x = t_left_hip_block_18 + c_left_hip_yaw * t_left_hip_block_9;
  const Scalar t_left_hip_fork_16 = left_hip_block_l2 * Omega_left_hip_block_xz;
  const Scalar t_left_hip_fork_17 = a_left_hip_block_x - t_left_hip_fork_16;
  const Scalar t_left_hip_fork_18 = left_hip_block_l2 * t_base_rx_11;
  const Scalar t_left_hip_fork_19 = a_right_hip_block_z - t_left_hip_fork_18;
  const Scalar t_left_hip_block_19 = c_left_hip_yaw * t_left_hip_block_8;
  const Scalar a_left_hip_block_y = t_left_hip_block_19 - s_left_hip_yaw * t_left_hip_block_9;
  const Scalar t_left_hip_fork_20 = left_hip_block_l2 * Omega_left_hip_block_yz;
  const Scalar t_left_hip_fork_21 = a_left_hip_block_y - t_left_hip_fork_20;
  const Scalar t_left_hip_fork_22 = t_left_hip_fork_6 * omega_left_hip_fork_x;
  const Scalar Omega_left_hip_fork_xy = alpha_left_hip_block_y - t_left_hip_fork_22;
  const Scalar t_left_hip_fork_23 = alpha_left_hip_block_y + t_left_hip_fork_22;
  const Scalar t_left_hip_fork_24 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  const Scalar t_left_hip_fork_25 = t_left_hip_fork_7 * t_left_hip_fork_7;
  const Scalar t_left_hip_fork_26 = t_left_hip_fork_24 + t_left_hip_fork_25;
  // left_thigh
  const Scalar t_left_thigh_1 = s_q8_q9_q10 * Omega_left_hip_fork_xy;
  const Scalar t_left_thigh_2 = t_left_thigh_1 - c_q8_q9_q10 * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_3 = s_q8_q9_q10 * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_y = c_q8_q9_q10 * t_left_hip_fork_7 + t_left_thigh_3;
  const Scalar omega_left_thigh_z = t_left_hip_fork_6 + qd[8];
  const Scalar t_left_thigh_4 = 2.0 * omega_left_thigh_y;
  const Scalar Omega_left_thigh_zy = t_left_thigh_2 + omega_left_thigh_z * t_left_thigh_4;
  const Scalar t_left_thigh_5 = s_q8_q9_q10 * Omega_left_hip_fork_zy;
  const Scalar Omega_left_foot_xy = t_left_thigh_5 + c_q8_q9_q10 * Omega_left_hip_fork_xy;
  const Scalar t_left_thigh_6 = c_q8_q9_q10 * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_x = s_q8_q9_q10 * t_left_hip_fork_7 - t_left_thigh_6;
  const Scalar t_left_thigh_7 = 2.0 * omega_left_thigh_x;
  const Scalar t_left_thigh_8 = Omega_left_foot_xy - omega_left_thigh_z * t_left_thigh_7;
  const Scalar t_left_hip_fork_27 = c_left_hip_roll * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_28 = t_left_hip_fork_27 + s_left_hip_roll * t_left_hip_fork_17;
  const Scalar t_left_thigh_9 = t_left_hip_fork_28 + left_hip_fork_l1 * t_left_hip_fork_11;
  const Scalar t_left_thigh_10 = t_left_hip_fork_21 + left_hip_fork_l1 * t_left_hip_block_12;
  const Scalar t_left_thigh_11 = omega_left_thigh_y * omega_left_thigh_x;
  const Scalar Omega_left_foot_xz = alpha_left_thigh_z - t_left_thigh_11;
  const Scalar t_left_hip_fork_29 = s_left_hip_roll * t_left_hip_fork_19;
  const Scalar a_left_hip_fork_y = t_left_hip_fork_29 - c_left_hip_roll * t_left_hip_fork_17;
  const Scalar t_left_thigh_12 = a_left_hip_fork_y - left_hip_fork_l1 * t_left_hip_fork_3;
  const Scalar Omega_left_thigh_yx = alpha_left_thigh_z + t_left_thigh_11;
  const Scalar t_left_thigh_13 = omega_left_thigh_x * omega_left_thigh_x;
  const Scalar t_left_thigh_14 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_15 = t_left_thigh_13 - t_left_thigh_14;
  const Scalar t_left_thigh_16 = t_left_hip_fork_26 - t_left_thigh_15;
  const Scalar t_left_thigh_17 = t_left_thigh_13 + t_left_thigh_14;
  const Scalar t_left_thigh_18 = left_thigh_I2 * c_q9_q10 - left_thigh_I6 * s_q9_q10;
  const Scalar t_left_thigh_19 = s_q9_q10 * t_left_thigh_18;
  const Scalar t_left_thigh_20 = left_thigh_I8 - c_q9_q10 * t_left_thigh_18;
  const Scalar t_left_thigh_21 = left_thigh_I9 * s_q9_q10 - left_thigh_I4 * c_q9_q10;
  const Scalar t_left_thigh_22 = left_thigh_h2 * c_q9_q10 - left_thigh_h3 * s_q9_q10;
  const Scalar t_left_thigh_23 = left_thigh_I10 + t_left_thigh_19;
  const Scalar t_left_thigh_24 = left_thigh_h2 * s_q9_q10 + left_thigh_h3 * c_q9_q10;
  // left_shank
  const Scalar t_left_shank_2 = t_left_thigh_16 - t_left_thigh_17;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[9];
  const Scalar Omega_left_shank_zy = Omega_left_thigh_zy + t_left_thigh_4 * qd[9];
  const Scalar t_left_shank_3 = t_left_thigh_8 - t_left_thigh_7 * qd[9];
  const Scalar t_left_shank_4 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_5 = t_left_thigh_13 - t_left_shank_4;
  const Scalar t_left_shank_6 = t_left_hip_fork_26 - t_left_shank_5;
  const Scalar t_left_shank_7 = left_shank_h1 * c_left_ankle_pitch;
  const Scalar t_left_shank_8 = t_left_shank_7 - left_shank_h3 * s_left_ankle_pitch;
  const Scalar t_left_shank_9 = left_shank_I1 * c_left_ankle_pitch;
  const Scalar t_left_shank_10 = t_left_shank_9 - left_shank_I6 * s_left_ankle_pitch;
  const Scalar t_left_shank_11 = left_shank_I7 - c_left_ankle_pitch * t_left_shank_10;
  const Scalar t_left_shank_12 = s_left_ankle_pitch * t_left_shank_10;
  const Scalar t_left_shank_13 = left_shank_I8 - t_left_shank_12;
  const Scalar t_left_shank_14 = left_shank_I9 * c_left_ankle_pitch;
  const Scalar t_left_shank_15 = t_left_shank_14 + left_shank_I3 * s_left_ankle_pitch;
  const Scalar t_left_shank_16 = left_shank_I9 * s_left_ankle_pitch;
  const Scalar t_left_shank_17 = t_left_shank_16 - left_shank_I3 * c_left_ankle_pitch;
  const Scalar t_left_shank_18 = left_shank_h1 * s_left_ankle_pitch;
  const Scalar t_left_shank_19 = t_left_shank_18 + left_shank_h3 * c_left_ankle_pitch;
  const Scalar t_left_shank_20 = left_shank_I10 + t_left_shank_12;
  // left_ankle_cross
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[10];
  const Scalar t_left_ankle_cross_2 = t_left_thigh_4 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_3 = t_left_thigh_2 + t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_4 = t_left_shank_3 - t_left_thigh_7 * qd[10];
  const Scalar t_left_ankle_cross_5 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_6 = t_left_thigh_13 - t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_7 = t_left_thigh_13 + t_left_ankle_cross_5;
  const Scalar t_left_shank_21 = t_left_thigh_12 + t_left_shank_1 * Omega_left_thigh_zy;
  const Scalar t_left_shank_22 = t_left_shank_21 + s_left_shank_x * t_left_thigh_8;
  const Scalar t_left_ankle_cross_8 = s_left_ankle_cross_x * t_left_shank_3;
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_1 * Omega_left_shank_zy;
  const Scalar t_left_ankle_cross_10 = t_left_shank_22 + t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_11 = t_left_ankle_cross_10 + t_left_ankle_cross_9;
  // left_foot
  const Scalar t_left_foot_1 = t_left_ankle_cross_11 + left_hip_fork_l3 * t_left_hip_fork_26;
  const Scalar t_left_foot_2 = t_left_foot_1 + left_hip_fork_l1 * t_left_ankle_cross_4;
  const Scalar t_left_foot_3 = omega_left_thigh_y - qd[11];
  const Scalar t_left_foot_4 = 2.0 * t_left_foot_3;
  const Scalar t_left_foot_5 = omega_left_ankle_cross_z * t_left_foot_4;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_3 - t_left_foot_5;
  const Scalar t_left_shank_23 = t_left_thigh_13 + t_left_shank_4;
  const Scalar t_left_thigh_25 = s_q8_q9_q10 * t_left_thigh_9;
  const Scalar t_left_thigh_26 = t_left_thigh_25 - c_q8_q9_q10 * t_left_thigh_10;
  const Scalar t_left_shank_24 = t_left_thigh_26 - t_left_shank_1 * t_left_thigh_17;
  const Scalar t_left_shank_25 = t_left_shank_24 - s_left_shank_x * Omega_left_thigh_yx;
  const Scalar t_left_foot_6 = left_hip_fork_l1 + s_left_ankle_cross_x;
  const Scalar t_left_foot_7 = t_left_shank_25 + left_hip_fork_l3 * t_left_thigh_2;
  const Scalar t_left_foot_8 = t_left_foot_7 - t_left_ankle_cross_1 * t_left_shank_23;
  const Scalar a_left_foot_z = t_left_foot_8 - Omega_left_thigh_yx * t_left_foot_6;
  const Scalar a_left_thigh_x = c_q8_q9_q10 * t_left_thigh_9 + s_q8_q9_q10 * t_left_thigh_10;
  const Scalar t_left_shank_26 = a_left_thigh_x + t_left_shank_1 * Omega_left_foot_xz;
  const Scalar a_left_shank_x = t_left_shank_26 - s_left_shank_x * t_left_thigh_16;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_12 = a_left_shank_x - s_left_ankle_cross_x * t_left_shank_6;
  const Scalar t_left_ankle_cross_13 = t_left_ankle_cross_1 * Omega_left_foot_xz;
  const Scalar a_left_ankle_cross_x = t_left_ankle_cross_12 + t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_14 = t_left_hip_fork_26 - t_left_ankle_cross_6;
  // left_foot
  const Scalar t_left_foot_9 = a_left_ankle_cross_x + left_hip_fork_l3 * Omega_left_foot_xy;
  const Scalar a_left_foot_x = t_left_foot_9 - left_hip_fork_l1 * t_left_ankle_cross_14;
  const Scalar t_left_foot_10 = Omega_left_foot_xz + omega_left_thigh_x * t_left_foot_4;
  const Scalar t_left_foot_11 = t_left_foot_3 * t_left_foot_3;
  const Scalar t_left_foot_12 = left_foot_k1 + q[11];
  const auto [s_left_foot, c_left_foot] = sine_cosine(t_left_foot_12);
  const Scalar t_left_foot_13 = left_foot_h1 * c_left_foot;
  const Scalar t_left_foot_14 = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_15 = left_foot_I3 * c_left_foot + left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_16 = s_left_foot * t_left_foot_15;
  const Scalar t_left_foot_17 = left_foot_I1 * c_left_foot + left_foot_I2 * s_left_foot;
  const Scalar t_left_foot_18 = left_foot_I14 - c_left_foot * t_left_foot_15;
  const Scalar t_left_foot_19 = left_foot_I2 * c_left_foot - left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_20 = left_foot_I13 + t_left_foot_16;
  const Scalar t_left_foot_21 = left_foot_I12 - t_left_foot_16;
  const Scalar t_left_foot_22 = t_left_ankle_cross_4 * t_left_foot_21;
  const Scalar t_left_foot_23 = t_left_foot_2 * t_left_foot_13 + t_left_foot_22;
  const Scalar t_left_foot_24 = t_left_foot_23 + t_left_ankle_cross_3 * t_left_foot_19;
  const Scalar t_left_foot_25 = t_left_foot_24 + Omega_left_foot_xz * t_left_foot_17;
  const Scalar t_left_foot_26 = t_left_foot_25 - t_left_ankle_cross_6 * t_left_foot_18;
  const Scalar t_left_foot_27 = t_left_foot_26 + a_left_foot_x * t_left_foot_14;
  const Scalar t_left_foot_28 = t_left_foot_27 + Omega_left_foot_xy * t_left_foot_20;
  B[11] = -t_left_foot_28;
  const Scalar t_left_foot_29 = Omega_left_foot_zy * t_left_foot_14;
  const Scalar t_left_foot_30 = left_ankle_cross_m1 * a_left_foot_z + t_left_foot_29;
  const Scalar F_left_foot_z = t_left_foot_30 - t_left_foot_10 * t_left_foot_13;
  const Scalar t_left_foot_31 = Omega_left_foot_xy * t_left_foot_14;
  const Scalar t_left_foot_32 = t_left_foot_13 * (t_left_ankle_cross_5 + t_left_foot_11);
  const Scalar t_left_foot_33 = left_ankle_cross_m1 * a_left_foot_x + t_left_foot_31;
  const Scalar F_left_foot_x = t_left_foot_33 - t_left_foot_32;
  // right_hip_block
  const Scalar t_right_hip_block_1 = c_right_hip_yaw * Omega_base_rx_zy;
  const Scalar t_right_hip_block_2 = s_right_hip_yaw * Omega_base_rx_xy;
  const Scalar Omega_right_hip_block_yz = t_right_hip_block_1 - t_right_hip_block_2;
  const Scalar omega_right_hip_block_z = t_base_rx_1 + qd[12];
  const Scalar t_right_hip_block_3 = s_right_hip_yaw * t_base_rx_4;
  const Scalar t_right_hip_block_4 = t_right_hip_block_3 - c_right_hip_yaw * t_base_rx_2;
  const Scalar t_right_hip_block_5 = omega_right_hip_block_z * t_right_hip_block_4 * 2.0;
  const Scalar t_right_hip_block_6 = Omega_right_hip_block_yz + t_right_hip_block_5;
  const Scalar t_right_hip_block_7 = s_right_hip_yaw * Omega_base_rx_zy;
  const Scalar t_right_hip_block_8 = c_right_hip_yaw * Omega_base_rx_xy;
  const Scalar Omega_right_hip_block_xz = t_right_hip_block_7 + t_right_hip_block_8;
  const Scalar t_right_hip_block_9 = c_right_hip_yaw * t_base_rx_4;
  const Scalar omega_right_hip_block_x = t_right_hip_block_9 + s_right_hip_yaw * t_base_rx_2;
  const Scalar t_right_hip_block_10 = omega_right_hip_block_z * omega_right_hip_block_x;
  const Scalar alpha_right_hip_block_y = Omega_right_hip_block_xz - t_right_hip_block_10;
  const Scalar Omega_right_hip_block_zx = t_right_hip_block_10 - alpha_right_hip_block_y;
  const Scalar t_right_hip_block_11 = omega_right_hip_block_x * omega_right_hip_block_x;
  const Scalar t_right_hip_block_12 = omega_right_hip_block_z * omega_right_hip_block_z;
  const Scalar t_right_hip_block_13 = t_right_hip_block_4 * omega_right_hip_block_x;
  const Scalar t_right_hip_block_14 = alpha_left_hip_block_z + t_right_hip_block_13;
  const Scalar t_right_hip_block_15 = t_right_hip_block_11 + t_right_hip_block_12;
  // right_hip_fork
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * t_right_hip_block_6;
  const Scalar t_right_hip_fork_2 = s_right_hip_roll * t_right_hip_block_14;
  const Scalar Omega_right_hip_fork_xz = t_right_hip_fork_1 - t_right_hip_fork_2;
  const Scalar t_right_hip_fork_3 = s_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_4 = c_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_3 - t_right_hip_fork_4;
  const Scalar omega_right_hip_fork_z = t_right_hip_block_4 + qd[13];
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_5 * omega_right_hip_fork_z;
  const Scalar alpha_right_hip_fork_y = Omega_right_hip_fork_xz + t_right_hip_fork_6;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_6 + alpha_right_hip_fork_y;
  const Scalar t_right_hip_fork_8 = c_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_9 = s_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_8 + t_right_hip_fork_9;
  const Scalar t_right_hip_fork_11 = c_right_hip_roll * t_right_hip_block_14;
  const Scalar t_right_hip_fork_12 = s_right_hip_roll * t_right_hip_block_6;
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_11 + t_right_hip_fork_12;
  const Scalar t_right_hip_fork_14 = omega_right_hip_fork_z * t_right_hip_fork_10 * 2.0;
  const Scalar Omega_right_hip_fork_zy = t_right_hip_fork_13 - t_right_hip_fork_14;
  // right_hip_block
  const Scalar t_right_hip_block_16 = s_right_hip_yaw * t_left_hip_block_8;
  const Scalar t_right_hip_block_17 = c_right_hip_yaw * t_left_hip_block_9;
  const Scalar t_right_hip_block_18 = t_right_hip_block_16 + t_right_hip_block_17;
  // right_hip_fork
  const Scalar t_right_hip_fork_15 = left_hip_block_l2 * Omega_right_hip_block_xz;
  const Scalar t_right_hip_fork_16 = t_right_hip_block_18 + t_right_hip_fork_15;
  const Scalar t_right_hip_fork_17 = a_right_hip_block_z + t_left_hip_fork_18;
  const Scalar t_right_hip_fork_18 = t_right_hip_fork_5 * t_right_hip_fork_10;
  // right_hip_block
  const Scalar t_right_hip_block_19 = c_right_hip_yaw * t_left_hip_block_8;
  const Scalar t_right_hip_block_20 = s_right_hip_yaw * t_left_hip_block_9;
  const Scalar t_right_hip_block_21 = t_right_hip_block_19 - t_right_hip_block_20;
  // right_hip_fork
  const Scalar t_right_hip_fork_19 = left_hip_block_l2 * Omega_right_hip_block_yz;
  const Scalar a_right_hip_fork_z = t_right_hip_block_21 + t_right_hip_fork_19;
  const Scalar Omega_right_hip_fork_xy = alpha_right_hip_block_y + t_right_hip_fork_18;
  const Scalar t_right_hip_fork_20 = t_right_hip_fork_5 * t_right_hip_fork_5;
  const Scalar t_right_hip_fork_21 = omega_right_hip_fork_z * omega_right_hip_fork_z;
  const Scalar t_right_hip_fork_22 = t_right_hip_fork_20 + t_right_hip_fork_21;
  const Scalar t_right_thigh_1 = s_q14_q15_q16 * Omega_right_hip_fork_zy;
  const Scalar Omega_right_foot_xy = t_right_thigh_1 + c_q14_q15_q16 * Omega_right_hip_fork_xy;
  // right_thigh
  const Scalar t_right_thigh_2 = s_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar t_right_thigh_3 = t_right_thigh_2 - c_q14_q15_q16 * t_right_hip_fork_5;
  const Scalar omega_right_thigh_z = t_right_hip_fork_10 + qd[14];
  const Scalar t_right_thigh_4 = 2.0 * t_right_thigh_3;
  const Scalar t_right_thigh_5 = Omega_right_foot_xy + omega_right_thigh_z * t_right_thigh_4;
  const Scalar t_right_thigh_6 = s_q14_q15_q16 * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_7 = t_right_thigh_6 - c_q14_q15_q16 * Omega_right_hip_fork_zy;
  const Scalar t_right_thigh_8 = c_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar t_right_thigh_9 = s_q14_q15_q16 * t_right_hip_fork_5 + t_right_thigh_8;
  const Scalar t_right_thigh_10 = 2.0 * t_right_thigh_9;
  const Scalar Omega_right_thigh_zy = t_right_thigh_7 - omega_right_thigh_z * t_right_thigh_10;
  // right_hip_fork
  const Scalar t_right_hip_fork_23 = c_right_hip_roll * t_right_hip_fork_17;
  const Scalar t_right_hip_fork_24 = s_right_hip_roll * t_right_hip_fork_16;
  const Scalar a_right_hip_fork_x = t_right_hip_fork_23 + t_right_hip_fork_24;
  // right_thigh
  const Scalar t_right_thigh_11 = a_right_hip_fork_x + left_hip_fork_l1 * Omega_right_hip_fork_xz;
  const Scalar t_right_thigh_12 = a_right_hip_fork_z - left_hip_fork_l1 * t_right_hip_block_15;
  const Scalar t_right_thigh_13 = t_right_thigh_3 * t_right_thigh_9;
  const Scalar t_right_thigh_14 = alpha_right_hip_fork_y - t_right_thigh_13;
  const Scalar Omega_right_thigh_xy = alpha_right_hip_fork_y + t_right_thigh_13;
  // right_hip_fork
  const Scalar t_right_hip_fork_25 = s_right_hip_roll * t_right_hip_fork_17;
  const Scalar t_right_hip_fork_26 = c_right_hip_roll * t_right_hip_fork_16;
  const Scalar t_right_hip_fork_27 = t_right_hip_fork_25 - t_right_hip_fork_26;
  // right_thigh
  const Scalar t_right_thigh_15 = t_right_thigh_3 * t_right_thigh_3;
  const Scalar t_right_thigh_16 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_17 = t_right_hip_fork_22 - t_right_thigh_15;
  const Scalar t_right_thigh_18 = t_right_thigh_16 + t_right_thigh_17;
  const Scalar t_right_thigh_19 = t_right_thigh_15 + t_right_thigh_16;
  const Scalar t_right_thigh_20 = left_thigh_I6 * s_q15_q16 - left_thigh_I2 * c_q15_q16;
  const Scalar t_right_thigh_21 = left_thigh_I8 + c_q15_q16 * t_right_thigh_20;
  const Scalar t_right_thigh_22 = left_thigh_I4 * c_q15_q16 - left_thigh_I9 * s_q15_q16;
  const Scalar t_right_thigh_23 = s_q15_q16 * t_right_thigh_20;
  const Scalar t_right_thigh_24 = left_thigh_I10 - t_right_thigh_23;
  const Scalar t_right_thigh_25 = left_thigh_I9 * c_q15_q16 + left_thigh_I4 * s_q15_q16;
  const Scalar t_right_thigh_26 = left_thigh_h2 * s_q15_q16 + left_thigh_h3 * c_q15_q16;
  const Scalar t_right_thigh_27 = left_thigh_I7 + t_right_thigh_23;
  const Scalar t_right_thigh_28 = left_thigh_h3 * s_q15_q16 - left_thigh_h2 * c_q15_q16;
  // right_shank
  const Scalar t_right_shank_2 = t_right_thigh_18 - t_right_thigh_19;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[15];
  const Scalar Omega_right_shank_zy = Omega_right_thigh_zy - t_right_thigh_10 * qd[15];
  const Scalar t_right_shank_3 = t_right_thigh_5 + t_right_thigh_4 * qd[15];
  const Scalar t_right_shank_4 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_5 = t_right_thigh_17 + t_right_shank_4;
  const Scalar t_right_shank_6 = t_right_thigh_15 + t_right_shank_4;
  const Scalar t_right_shank_7 = left_shank_h1 * c_right_ankle_pitch;
  const Scalar t_right_shank_8 = t_right_shank_7 - left_shank_h3 * s_right_ankle_pitch;
  const Scalar t_right_shank_9 = left_shank_I1 * c_right_ankle_pitch;
  const Scalar t_right_shank_10 = t_right_shank_9 - left_shank_I6 * s_right_ankle_pitch;
  const Scalar t_right_shank_11 = left_shank_I7 - c_right_ankle_pitch * t_right_shank_10;
  const Scalar t_right_shank_12 = s_right_ankle_pitch * t_right_shank_10;
  const Scalar t_right_shank_13 = left_shank_I3 * s_right_ankle_pitch;
  const Scalar t_right_shank_14 = t_right_shank_13 + left_shank_I9 * c_right_ankle_pitch;
  const Scalar t_right_shank_15 = left_shank_h3 * c_right_ankle_pitch;
  const Scalar t_right_shank_16 = t_right_shank_15 + left_shank_h1 * s_right_ankle_pitch;
  const Scalar t_right_shank_17 = left_shank_I10 + t_right_shank_12;
  // right_ankle_cross
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[16];
  const Scalar Omega_righ_ankl_cros_zy = Omega_right_shank_zy - t_right_thigh_10 * qd[16];
  const Scalar t_righ_ankl_cros_2 = t_right_thigh_4 * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_3 = Omega_right_foot_xy + t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_4 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_5 = t_right_thigh_15 - t_righ_ankl_cros_4;
  const Scalar a_right_thigh_z = t_right_hip_fork_27 + left_hip_fork_l1 * t_right_hip_fork_13;
  const Scalar t_right_shank_18 = a_right_thigh_z - t_right_shank_1 * Omega_right_thigh_zy;
  const Scalar a_right_shank_z = t_right_shank_18 - s_right_shank_x * t_right_thigh_5;
  const Scalar t_righ_ankl_cros_6 = a_right_shank_z - s_righ_ankl_cros_x * t_right_shank_3;
  const Scalar t_righ_ankl_cros_7 = t_righ_ankl_cros_1 * Omega_right_shank_zy;
  const Scalar a_righ_ankl_cros_z = t_righ_ankl_cros_6 - t_righ_ankl_cros_7;
  // right_foot
  const Scalar t_right_foot_1 = a_righ_ankl_cros_z + left_hip_fork_l3 * t_right_hip_fork_22;
  const Scalar a_right_foot_y = t_right_foot_1 - left_hip_fork_l1 * t_righ_ankl_cros_3;
  const Scalar omega_right_foot_z = t_right_thigh_9 + qd[17];
  const Scalar t_right_foot_2 = 2.0 * omega_right_foot_z;
  const Scalar t_right_foot_3 = omega_righ_ankl_cros_z * t_right_foot_2;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy + t_right_foot_3;
  const Scalar t_right_foot_4 = left_hip_fork_l1 + s_righ_ankl_cros_x;
  const Scalar t_right_thigh_29 = s_q14_q15_q16 * t_right_thigh_11;
  const Scalar a_right_thigh_y = t_right_thigh_29 - c_q14_q15_q16 * t_right_thigh_12;
  const Scalar t_right_shank_19 = a_right_thigh_y + t_right_shank_1 * t_right_thigh_19;
  const Scalar a_right_shank_y = t_right_shank_19 - s_right_shank_x * t_right_thigh_14;
  const Scalar t_right_foot_5 = a_right_shank_y + t_righ_ankl_cros_1 * t_right_shank_6;
  const Scalar t_right_foot_6 = t_right_foot_5 + left_hip_fork_l3 * t_right_thigh_7;
  const Scalar t_right_foot_7 = t_right_foot_6 - t_right_thigh_14 * t_right_foot_4;
  const Scalar Omega_right_foot_zx = Omega_right_thigh_xy - t_right_thigh_3 * t_right_foot_2;
  const Scalar t_right_foot_8 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_9 = left_foot_k1 - q[17];
  const auto [s_right_foot, c_right_foot] = sine_cosine(t_right_foot_9);
  const Scalar t_right_foot_10 = left_foot_h1 * c_right_foot;
  const Scalar t_right_foot_11 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_12 = left_foot_I3 * c_right_foot + left_foot_I4 * s_right_foot;
  const Scalar t_right_foot_13 = s_right_foot * t_right_foot_12;
  const Scalar t_right_foot_14 = left_foot_I12 - t_right_foot_13;
  const Scalar t_right_foot_15 = left_foot_I2 * c_right_foot - left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_16 = left_foot_I1 * c_right_foot + left_foot_I2 * s_right_foot;
  const Scalar t_right_foot_17 = left_foot_I14 - c_right_foot * t_right_foot_12;
  const Scalar t_right_thigh_30 = c_q14_q15_q16 * t_right_thigh_11;
  const Scalar t_right_thigh_31 = t_right_thigh_30 + s_q14_q15_q16 * t_right_thigh_12;
  const Scalar t_right_foot_18 = left_foot_I13 + t_right_foot_13;
  const Scalar t_right_shank_20 = t_right_thigh_31 + s_right_shank_x * t_right_thigh_18;
  const Scalar t_right_shank_21 = t_right_shank_20 + t_right_shank_1 * Omega_right_thigh_xy;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_1 * Omega_right_thigh_xy;
  const Scalar t_righ_ankl_cros_9 = t_right_shank_21 + t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_10 = s_righ_ankl_cros_x * t_right_shank_5;
  const Scalar t_righ_ankl_cros_11 = t_righ_ankl_cros_9 + t_righ_ankl_cros_10;
  // right_foot
  const Scalar t_right_foot_19 = left_hip_fork_l1 * (t_right_thigh_17 + t_righ_ankl_cros_4);
  const Scalar t_right_foot_20 = t_righ_ankl_cros_11 + t_right_foot_19;
  const Scalar t_right_foot_21 = t_right_foot_20 + left_hip_fork_l3 * Omega_right_foot_xy;
  const Scalar t_right_foot_22 = t_righ_ankl_cros_5 * t_right_foot_17;
  const Scalar t_right_foot_23 = Omega_right_thigh_xy * t_right_foot_16 + t_right_foot_22;
  const Scalar t_right_foot_24 = t_right_foot_23 + Omega_righ_ankl_cros_zy * t_right_foot_15;
  const Scalar t_right_foot_25 = t_right_foot_24 + t_right_foot_11 * t_right_foot_21;
  const Scalar t_right_foot_26 = t_right_foot_25 + Omega_right_foot_xy * t_right_foot_18;
  const Scalar t_right_foot_27 = t_right_foot_26 + t_righ_ankl_cros_3 * t_right_foot_14;
  const Scalar t_right_foot_28 = t_right_foot_27 - a_right_foot_y * t_right_foot_10;
  B[17] = -t_right_foot_28;
  const Scalar t_right_foot_29 = Omega_right_foot_zx * t_right_foot_10;
  const Scalar t_right_foot_30 = t_right_foot_29 - Omega_right_foot_zy * t_right_foot_11;
  const Scalar F_right_foot_z = t_right_foot_30 - left_ankle_cross_m1 * t_right_foot_7;
  const Scalar t_righ_ankl_cros_12 = t_right_thigh_15 + t_righ_ankl_cros_4;
  const Scalar t_right_foot_31 = t_right_thigh_15 - t_right_foot_8;
  const Scalar t_right_foot_32 = t_right_foot_10 * (t_righ_ankl_cros_12 - t_right_foot_31);
  const Scalar t_right_foot_33 = t_right_foot_32 + left_ankle_cross_m1 * t_right_foot_21;
  const Scalar t_right_foot_34 = t_right_foot_33 + Omega_right_foot_xy * t_right_foot_11;
  const Scalar t_righ_ankl_cros_13 = left_ankle_cross_I7 * Omega_right_thigh_xy;
  const Scalar t_right_foot_35 = t_right_foot_15 * t_right_foot_31;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_14 = t_right_foot_35 - t_righ_ankl_cros_13;
  const Scalar t_righ_ankl_cros_15 = left_ankle_cross_I9 * t_right_thigh_14;
  const Scalar t_righ_ankl_cros_16 = t_righ_ankl_cros_14 - t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_17 = left_ankle_cross_h2 * t_righ_ankl_cros_11;
  const Scalar t_righ_ankl_cros_18 = t_righ_ankl_cros_16 - t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_19 = t_righ_ankl_cros_18 - left_hip_fork_l1 * F_right_foot_z;
  const Scalar t_right_foot_36 = Omega_right_foot_zy * t_right_foot_17;
  const Scalar t_righ_ankl_cros_20 = t_righ_ankl_cros_19 - t_right_foot_36;
  const Scalar t_righ_ankl_cros_21 = left_ankle_cross_I8 * t_right_thigh_7;
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_20 + t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_23 = left_ankle_cross_I6 * t_right_shank_2;
  const Scalar t_righ_ankl_cros_24 = left_ankle_cross_I1 + t_right_foot_16;
  const Scalar t_righ_ankl_cros_25 = t_righ_ankl_cros_22 - t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_26 = Omega_right_foot_xy * t_righ_ankl_cros_24;
  const Scalar t_righ_ankl_cros_27 = t_righ_ankl_cros_25 - t_righ_ankl_cros_26;
  const Scalar t_right_foot_37 = t_right_foot_7 * t_right_foot_10;
  const Scalar t_righ_ankl_cros_28 = t_righ_ankl_cros_27 + t_right_foot_37;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_28 - Omega_right_foot_zx * t_right_foot_14;
  B[16] = M_righ_ankl_cros_z;
  // right_foot
  const Scalar t_right_foot_38 = t_righ_ankl_cros_3 * t_right_foot_10;
  const Scalar t_right_foot_39 = t_right_foot_11 * (t_right_thigh_15 + t_right_foot_8);
  const Scalar t_right_foot_40 = t_right_foot_38 - left_ankle_cross_m1 * a_right_foot_y;
  const Scalar t_right_foot_41 = t_right_foot_40 - t_right_foot_39;
  const Scalar t_righ_ankl_cros_29 = left_ankle_cross_h2 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_foot_42 = t_right_foot_41 + t_righ_ankl_cros_29;
  const Scalar t_right_foot_43 = t_right_foot_34 + left_ankle_cross_h2 * Omega_right_thigh_xy;
  const Scalar t_right_shank_22 = left_shank_I8 - t_right_shank_12;
  const Scalar t_right_foot_44 = F_right_foot_z - left_ankle_cross_h2 * t_righ_ankl_cros_12;
  // right_shank
  const Scalar t_right_shank_23 = left_shank_I9 * s_right_ankle_pitch;
  const Scalar t_right_shank_24 = t_right_shank_23 - left_shank_I3 * c_right_ankle_pitch;
  const Scalar t_right_shank_25 = M_righ_ankl_cros_z - t_righ_ankl_cros_1 * t_right_foot_43;
  const Scalar t_right_shank_26 = t_right_shank_25 - Omega_right_thigh_xy * t_right_shank_22;
  const Scalar t_right_shank_27 = t_right_shank_26 - s_righ_ankl_cros_x * t_right_foot_44;
  const Scalar t_right_shank_28 = t_right_shank_27 - t_right_thigh_14 * t_right_shank_17;
  const Scalar t_right_shank_29 = t_right_shank_28 + t_right_shank_8 * t_right_shank_21;
  const Scalar t_right_shank_30 = t_right_shank_29 - t_right_shank_2 * t_right_shank_11;
  const Scalar t_right_shank_31 = t_right_shank_30 + t_right_thigh_7 * t_right_shank_14;
  const Scalar t_right_shank_32 = t_right_shank_31 + t_right_shank_16 * a_right_shank_y;
  const Scalar M_right_shank_z = t_right_shank_32 - Omega_right_foot_xy * t_right_shank_24;
  B[15] = M_right_shank_z;
  const Scalar t_right_shank_33 = Omega_right_shank_zy * t_right_shank_8;
  const Scalar t_right_shank_34 = t_right_shank_3 * t_right_shank_16;
  const Scalar t_righ_ankl_cros_30 = t_right_foot_42 - t_right_shank_33 + t_right_shank_34;
  // right_thigh
  const Scalar t_right_thigh_32 = left_ankle_cross_I10 * c_right_ankle_pitch;
  const Scalar t_right_thigh_33 = t_right_thigh_25 * (t_right_thigh_15 - t_right_thigh_16);
  const Scalar t_right_thigh_34 = t_right_foot_28 + left_hip_fork_l3 * t_right_foot_34;
  const Scalar t_righ_ankl_cros_31 = left_ankle_cross_I8 * t_righ_ankl_cros_5;
  const Scalar t_right_shank_35 = t_right_hip_fork_22 - t_right_shank_5;
  const Scalar t_right_thigh_35 = t_right_thigh_34 - t_right_thigh_33 - t_righ_ankl_cros_31;
  const Scalar t_right_thigh_36 = left_ankle_cross_I6 + t_right_thigh_32;
  const Scalar t_right_thigh_37 = t_right_thigh_35 - t_right_shank_14 * t_right_shank_35;
  const Scalar t_right_thigh_38 = Omega_righ_ankl_cros_zy * t_right_thigh_36;
  const Scalar t_right_thigh_39 = t_right_thigh_37 + t_right_thigh_38;
  const Scalar t_right_thigh_40 = t_right_thigh_39 + t_right_shank_3 * t_right_shank_17;
  const Scalar t_right_thigh_41 = t_right_thigh_40 + Omega_right_thigh_zy * t_right_thigh_21;
  const Scalar t_right_thigh_42 = t_right_thigh_41 + Omega_right_shank_zy * t_right_shank_11;
  const Scalar t_right_thigh_43 = left_ankle_cross_I1 - t_right_thigh_22 + t_right_shank_24;
  const Scalar t_right_thigh_44 = t_right_thigh_42 - t_right_thigh_26 * a_right_thigh_z;
  const Scalar t_right_thigh_45 = t_right_thigh_44 + Omega_right_thigh_xy * t_right_thigh_43;
  const Scalar t_right_thigh_46 = t_right_thigh_45 - t_right_shank_16 * a_right_shank_z;
  const Scalar t_right_thigh_47 = t_right_thigh_46 + s_right_shank_x * t_righ_ankl_cros_30;
  const Scalar t_right_thigh_48 = t_right_thigh_47 + t_right_foot_4 * t_right_foot_41;
  const Scalar t_righ_ankl_cros_32 = left_ankle_cross_I9 * t_righ_ankl_cros_3;
  const Scalar t_right_thigh_49 = t_right_thigh_48 + t_righ_ankl_cros_32;
  const Scalar M_right_thigh_y = t_right_thigh_49 + t_right_thigh_5 * t_right_thigh_24;
  const Scalar t_right_thigh_50 = t_right_thigh_16 - t_right_thigh_17;
  // right_shank
  const Scalar t_right_shank_36 = left_ankle_cross_I6 + t_right_foot_15;
  const Scalar t_right_shank_37 = left_ankle_cross_I8 + t_right_thigh_25 + t_right_shank_14;
  const Scalar t_right_shank_38 = t_right_hip_fork_22 - t_right_shank_6;
  const Scalar t_right_shank_39 = t_right_thigh_14 * t_right_shank_37;
  const Scalar t_righ_ankl_cros_33 = t_right_thigh_17 - t_righ_ankl_cros_4;
  const Scalar t_right_shank_40 = t_right_shank_39 + t_right_shank_24 * t_right_shank_38;
  const Scalar t_righ_ankl_cros_34 = left_ankle_cross_I1 * t_righ_ankl_cros_33;
  const Scalar t_right_foot_45 = t_right_foot_16 * (t_righ_ankl_cros_4 - t_right_foot_8);
  const Scalar t_right_shank_41 = t_right_shank_40 + t_righ_ankl_cros_34 - t_right_foot_45;
  const Scalar t_right_shank_42 = t_right_shank_41 - t_right_shank_1 * t_righ_ankl_cros_30;
  const Scalar t_right_shank_43 = t_right_shank_42 + left_ankle_cross_h2 * a_righ_ankl_cros_z;
  const Scalar t_right_shank_44 = t_right_shank_43 - t_righ_ankl_cros_1 * t_right_foot_42;
  const Scalar t_right_shank_45 = t_right_shank_44 - Omega_right_foot_zy * t_right_foot_18;
  const Scalar t_right_shank_46 = t_right_shank_45 + left_hip_fork_l3 * F_right_foot_z;
  const Scalar t_right_shank_47 = t_right_shank_46 - Omega_right_foot_zx * t_right_foot_17;
  const Scalar t_righ_ankl_cros_35 = left_ankle_cross_I7 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_shank_48 = t_right_shank_47 - t_righ_ankl_cros_35;
  const Scalar t_right_shank_49 = t_right_shank_48 - Omega_right_shank_zy * t_right_shank_22;
  const Scalar t_right_shank_50 = t_right_shank_49 - Omega_right_thigh_zy * t_right_thigh_27;
  const Scalar t_right_shank_51 = t_right_shank_50 - t_right_shank_8 * a_right_shank_z;
  const Scalar t_right_shank_52 = t_right_shank_51 + t_right_thigh_22 * t_right_thigh_50;
  const Scalar t_right_shank_53 = t_right_shank_52 - t_right_foot_7 * t_right_foot_11;
  const Scalar t_right_shank_54 = t_right_shank_53 - t_right_shank_3 * t_right_shank_11;
  const Scalar t_right_shank_55 = t_right_shank_54 + t_right_thigh_28 * a_right_thigh_z;
  const Scalar t_right_shank_56 = t_right_shank_55 - t_right_thigh_5 * t_right_thigh_21;
  const Scalar t_right_shank_57 = t_right_shank_56 - t_righ_ankl_cros_3 * t_right_shank_36;
  const Scalar t_right_shank_58 = Omega_right_thigh_xy * t_right_shank_8;
  const Scalar t_right_shank_59 = t_right_shank_5 * t_right_shank_16;
  const Scalar t_righ_ankl_cros_36 = t_right_foot_43 - t_right_shank_58 + t_right_shank_59;
  const Scalar t_righ_ankl_cros_37 = t_right_foot_44 + t_right_thigh_14 * t_right_shank_16;
  const Scalar t_right_shank_60 = t_right_shank_6 * t_right_shank_8;
  const Scalar t_righ_ankl_cros_38 = t_righ_ankl_cros_37 + t_right_shank_60;
  // right_thigh
  const Scalar t_right_thigh_51 = M_right_shank_z + t_right_thigh_7 * t_right_thigh_25;
  const Scalar t_right_thigh_52 = t_right_thigh_51 - t_right_thigh_21 * t_right_shank_2;
  const Scalar t_right_thigh_53 = t_right_thigh_52 - t_right_thigh_28 * t_right_thigh_31;
  const Scalar t_right_thigh_54 = t_right_thigh_53 - Omega_right_thigh_xy * t_right_thigh_27;
  const Scalar t_right_thigh_55 = t_right_thigh_54 - s_right_shank_x * t_righ_ankl_cros_38;
  const Scalar t_right_thigh_56 = t_right_thigh_55 + t_right_thigh_26 * a_right_thigh_y;
  const Scalar t_right_thigh_57 = t_right_thigh_56 + Omega_right_foot_xy * t_right_thigh_22;
  const Scalar t_right_thigh_58 = t_right_thigh_57 - t_right_shank_1 * t_righ_ankl_cros_36;
  const Scalar M_right_thigh_z = t_right_thigh_58 - t_right_thigh_14 * t_right_thigh_24;
  B[14] = M_right_thigh_z;
  // right_shank
  const Scalar t_right_shank_61 = t_righ_ankl_cros_38 - t_right_thigh_19 * t_right_thigh_28;
  const Scalar t_right_shank_62 = t_right_shank_61 + t_right_thigh_14 * t_right_thigh_26;
  const Scalar t_right_shank_63 = t_righ_ankl_cros_36 + t_right_thigh_18 * t_right_thigh_26;
  const Scalar t_right_shank_64 = t_right_shank_63 + Omega_right_thigh_xy * t_right_thigh_28;
  // right_hip_fork
  const Scalar t_right_hip_fork_28 = alpha_right_hip_block_y - t_right_hip_fork_18;
  const Scalar t_right_hip_fork_29 = t_right_hip_fork_20 - t_right_hip_fork_21;
  const Scalar t_right_hip_fork_30 = t_right_hip_block_15 - t_right_hip_fork_29;
  // right_thigh
  const Scalar t_right_thigh_59 = s_q14_q15_q16 * t_right_shank_57;
  const Scalar t_right_thigh_60 = c_q14_q15_q16 * M_right_thigh_y - t_right_thigh_59;
  const Scalar t_right_thigh_61 = left_hip_fork_I11 * alpha_right_hip_block_y;
  const Scalar t_right_hip_fork_31 = left_hip_fork_I9 * Omega_right_hip_fork_xz;
  const Scalar t_right_thigh_62 = t_right_thigh_60 + t_right_thigh_61 + t_right_hip_fork_31;
  const Scalar t_right_hip_fork_32 = t_right_hip_fork_22 - t_right_hip_fork_30;
  const Scalar t_right_thigh_63 = t_right_thigh_62 + left_hip_fork_h3 * a_right_hip_fork_x;
  const Scalar t_right_thigh_64 = t_right_thigh_63 - left_hip_fork_I7 * t_right_hip_fork_32;
  const Scalar t_right_thigh_65 = t_right_thigh_64 - left_hip_fork_h1 * t_right_hip_fork_27;
  const Scalar t_right_thigh_66 = t_right_thigh_65 + left_hip_fork_I12 * t_right_hip_fork_18;
  const Scalar t_right_thigh_67 = t_right_thigh_66 - left_hip_fork_I8 * t_right_hip_fork_13;
  B[13] = -t_right_thigh_67;
  const Scalar t_right_thigh_68 = c_q14_q15_q16 * t_right_shank_62;
  const Scalar t_right_thigh_69 = t_right_thigh_68 + s_q14_q15_q16 * t_right_shank_64;
  // right_hip_fork
  const Scalar t_right_hip_fork_33 = left_hip_fork_h3 * Omega_right_hip_fork_zy;
  const Scalar t_right_hip_fork_34 = t_right_thigh_69 + t_right_hip_fork_33;
  const Scalar t_right_hip_fork_35 = left_hip_fork_h1 * t_right_hip_fork_7;
  const Scalar F_right_hip_fork_z = t_right_hip_fork_34 + t_right_hip_fork_35;
  const Scalar t_right_thigh_70 = c_q14_q15_q16 * t_right_shank_64;
  const Scalar t_right_thigh_71 = t_right_thigh_70 - s_q14_q15_q16 * t_right_shank_62;
  const Scalar t_right_shank_65 = t_righ_ankl_cros_30 + t_right_thigh_5 * t_right_thigh_26;
  const Scalar t_right_shank_66 = t_right_shank_65 + Omega_right_thigh_zy * t_right_thigh_28;
  const Scalar t_right_thigh_72 = c_q14_q15_q16 * t_right_shank_57;
  const Scalar t_right_thigh_73 = s_q14_q15_q16 * M_right_thigh_y + t_right_thigh_72;
  const Scalar t_right_hip_fork_36 = t_right_thigh_73 + left_hip_fork_h3 * a_right_hip_fork_z;
  const Scalar t_right_thigh_74 = left_hip_fork_l1 * t_right_shank_66;
  const Scalar t_right_hip_fork_37 = t_right_hip_fork_36 - t_right_thigh_74;
  const Scalar t_right_hip_fork_38 = left_hip_fork_I8 * t_right_hip_fork_28;
  const Scalar t_right_hip_fork_39 = t_right_hip_fork_37 - t_right_hip_fork_38;
  const Scalar t_right_hip_fork_40 = left_hip_fork_I6 * Omega_right_hip_fork_zy;
  const Scalar t_right_hip_fork_41 = t_right_hip_block_15 - t_right_hip_fork_22;
  const Scalar t_right_hip_fork_42 = t_right_hip_fork_39 + t_right_hip_fork_40;
  const Scalar t_right_hip_fork_43 = left_hip_fork_I9 * t_right_hip_fork_41;
  const Scalar t_right_hip_fork_44 = t_right_hip_fork_42 - t_right_hip_fork_43;
  const Scalar t_right_hip_fork_45 = left_hip_fork_I7 * t_right_hip_fork_7;
  const Scalar M_right_hip_fork_x = t_right_hip_fork_44 + t_right_hip_fork_45;
  // right_thigh
  const Scalar t_right_thigh_75 = M_right_thigh_z - left_hip_fork_l1 * t_right_thigh_71;
  const Scalar t_right_thigh_76 = t_right_thigh_75 - left_hip_fork_h1 * a_right_hip_fork_z;
  const Scalar t_right_thigh_77 = t_right_thigh_76 - left_hip_fork_I10 * t_right_hip_fork_7;
  const Scalar t_right_thigh_78 = t_right_thigh_77 - left_hip_fork_I9 * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_79 = t_right_thigh_78 + left_hip_fork_I8 * t_right_hip_fork_29;
  const Scalar t_right_thigh_80 = t_right_thigh_79 - left_hip_fork_I7 * Omega_right_hip_fork_zy;
  const Scalar Omega_right_hip_block_yx = alpha_left_hip_block_z - t_right_hip_block_13;
  const Scalar t_right_hip_block_22 = t_base_rx_11 - t_right_hip_block_15;
  const Scalar t_right_hip_fork_46 = left_hip_block_l2 * F_right_hip_fork_z;
  const Scalar t_right_hip_block_23 = t_left_hip_block_16 + t_right_hip_fork_46;
  const Scalar t_right_hip_fork_47 = s_right_hip_roll * M_right_hip_fork_x;
  const Scalar t_right_hip_block_24 = t_right_hip_block_23 + t_right_hip_fork_47;
  const Scalar t_right_hip_fork_48 = c_right_hip_roll * t_right_thigh_80;
  // right_hip_block
  const Scalar t_right_hip_block_25 = t_right_hip_block_24 - t_right_hip_fork_48;
  const Scalar t_right_hip_block_26 = left_hip_block_I8 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_block_27 = t_right_hip_block_25 + t_right_hip_block_26;
  const Scalar t_right_hip_block_28 = left_hip_block_I10 * Omega_right_hip_block_yx;
  const Scalar t_right_hip_block_29 = t_right_hip_block_27 + t_right_hip_block_28;
  const Scalar t_right_hip_block_30 = left_hip_block_I9 * t_right_hip_block_22;
  const Scalar t_right_hip_block_31 = t_right_hip_block_29 + t_right_hip_block_30;
  const Scalar t_right_hip_block_32 = left_hip_block_I12 * t_right_hip_block_6;
  const Scalar t_right_hip_fork_49 = t_right_hip_block_31 + t_right_hip_block_32;
  const Scalar t_right_hip_block_33 = t_right_hip_block_11 - t_right_hip_block_12;
  const Scalar t_right_hip_block_34 = left_hip_block_I15 * alpha_left_hip_block_z;
  const Scalar t_right_hip_block_35 = left_hip_block_I10 * Omega_right_hip_block_yz;
  const Scalar t_right_hip_block_36 = t_right_hip_block_34 + t_right_hip_block_35;
  const Scalar t_right_hip_fork_50 = c_right_hip_roll * M_right_hip_fork_x;
  const Scalar t_right_hip_block_37 = t_right_hip_block_36 + t_right_hip_fork_50;
  const Scalar t_right_hip_block_38 = left_hip_block_h3 * t_right_hip_block_18;
  const Scalar t_right_hip_block_39 = t_right_hip_block_37 - t_right_hip_block_38;
  const Scalar t_right_hip_block_40 = left_hip_block_I11 * t_right_hip_block_13;
  const Scalar t_right_hip_block_41 = t_right_hip_block_39 + t_right_hip_block_40;
  const Scalar t_right_hip_block_42 = left_hip_block_h1 * t_right_hip_block_21;
  const Scalar t_right_hip_block_43 = t_right_hip_block_41 + t_right_hip_block_42;
  const Scalar t_right_hip_fork_51 = s_right_hip_roll * t_right_thigh_80;
  const Scalar t_right_hip_block_44 = t_right_hip_block_43 + t_right_hip_fork_51;
  const Scalar t_right_hip_block_45 = left_hip_block_I9 * Omega_right_hip_block_xz;
  const Scalar t_right_hip_block_46 = t_right_hip_block_22 - t_right_hip_block_33;
  const Scalar t_right_hip_block_47 = t_right_hip_block_44 - t_right_hip_block_45;
  const Scalar t_right_hip_block_48 = left_hip_block_I8 * t_right_hip_block_46;
  const Scalar M_right_hip_block_z = t_right_hip_block_47 - t_right_hip_block_48;
  B[12] = M_right_hip_block_z;
  const Scalar t_right_hip_block_49 = t_base_rx_11 - t_right_hip_block_33;
  // right_hip_fork
  const Scalar t_right_hip_fork_52 = left_hip_fork_h3 * t_right_hip_fork_22;
  const Scalar t_right_hip_fork_53 = t_right_shank_66 - t_right_hip_fork_52;
  const Scalar t_right_hip_fork_54 = left_hip_fork_h1 * t_right_hip_fork_28;
  const Scalar F_right_hip_fork_y = t_right_hip_fork_53 + t_right_hip_fork_54;
  const Scalar t_right_hip_fork_55 = left_hip_fork_h1 * t_right_hip_fork_30;
  const Scalar t_right_hip_fork_56 = t_right_thigh_71 + t_right_hip_fork_55;
  const Scalar t_right_hip_fork_57 = left_hip_fork_h3 * Omega_right_hip_fork_xy;
  const Scalar F_right_hip_fork_x = t_right_hip_fork_56 + t_right_hip_fork_57;
  const Scalar t_left_ankle_cross_15 = left_ankle_cross_I6 * t_left_shank_2;
  const Scalar t_left_foot_34 = left_hip_fork_l1 * F_left_foot_z + t_left_ankle_cross_15;
  const Scalar t_left_foot_35 = t_left_foot_19 * (t_left_thigh_13 - t_left_foot_11);
  const Scalar t_left_ankle_cross_16 = left_ankle_cross_h2 * a_left_ankle_cross_x;
  // left_foot
  const Scalar t_left_foot_36 = t_left_foot_34 - t_left_foot_35 - t_left_ankle_cross_16;
  const Scalar t_left_foot_37 = Omega_left_foot_xy * (left_ankle_cross_I1 + t_left_foot_17);
  const Scalar t_left_foot_38 = Omega_left_foot_zy * t_left_foot_18;
  const Scalar t_left_foot_39 = t_left_foot_36 - t_left_foot_37 - t_left_foot_38;
  const Scalar t_left_foot_40 = t_left_foot_39 - t_left_foot_10 * t_left_foot_21;
  const Scalar t_left_foot_41 = t_left_foot_40 - left_ankle_cross_I9 * Omega_left_thigh_yx;
  const Scalar t_left_foot_42 = t_left_foot_41 - left_ankle_cross_I7 * Omega_left_foot_xz;
  const Scalar t_left_foot_43 = t_left_foot_42 + a_left_foot_z * t_left_foot_13;
  const Scalar t_left_foot_44 = t_left_foot_43 + left_ankle_cross_I8 * t_left_thigh_2;
  B[10] = -t_left_foot_44;
  const Scalar F_left_ankle_cross_x = F_left_foot_x + left_ankle_cross_h2 * Omega_left_foot_xz;
  const Scalar t_left_foot_45 = F_left_foot_z - left_ankle_cross_h2 * t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_17 = t_left_foot_44 + t_left_shank_2 * t_left_shank_11;
  const Scalar t_left_shank_27 = Omega_left_thigh_yx * t_left_shank_20;
  const Scalar t_left_ankle_cross_18 = t_left_ankle_cross_17 - t_left_shank_27;
  const Scalar t_left_shank_28 = Omega_left_foot_xy * t_left_shank_17;
  const Scalar t_left_ankle_cross_19 = t_left_ankle_cross_18 - t_left_shank_28;
  const Scalar t_left_shank_29 = Omega_left_foot_xz * t_left_shank_13;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_20 = t_left_ankle_cross_1 * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_21 = t_left_ankle_cross_19 - t_left_shank_29;
  const Scalar t_left_ankle_cross_22 = t_left_ankle_cross_21 - t_left_ankle_cross_20;
  const Scalar t_left_ankle_cross_23 = s_left_ankle_cross_x * t_left_foot_45;
  const Scalar t_left_ankle_cross_24 = t_left_ankle_cross_22 + t_left_ankle_cross_23;
  const Scalar t_left_shank_30 = t_left_thigh_2 * t_left_shank_15;
  const Scalar t_left_ankle_cross_25 = t_left_ankle_cross_24 + t_left_shank_30;
  const Scalar t_left_shank_31 = t_left_shank_19 * t_left_shank_25;
  const Scalar t_left_ankle_cross_26 = t_left_ankle_cross_25 + t_left_shank_31;
  const Scalar t_left_shank_32 = t_left_shank_8 * a_left_shank_x;
  const Scalar t_left_ankle_cross_27 = t_left_ankle_cross_26 + t_left_shank_32;
  B[9] = -t_left_ankle_cross_27;
  // left_foot
  const Scalar t_left_foot_46 = t_left_foot_14 * (t_left_thigh_13 + t_left_foot_11);
  const Scalar t_left_foot_47 = left_ankle_cross_m1 * t_left_foot_2 + t_left_foot_46;
  const Scalar t_left_foot_48 = t_left_foot_47 + t_left_ankle_cross_4 * t_left_foot_13;
  const Scalar t_left_foot_49 = t_left_foot_48 + left_ankle_cross_h2 * t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_28 = t_left_foot_49 + t_left_shank_3 * t_left_shank_19;
  const Scalar t_left_shank_33 = Omega_left_shank_zy * t_left_shank_8;
  const Scalar t_left_ankle_cross_29 = t_left_ankle_cross_28 - t_left_shank_33;
  const Scalar t_left_thigh_27 = left_thigh_I9 * c_q9_q10 + left_thigh_I4 * s_q9_q10;
  const Scalar t_left_thigh_28 = t_left_foot_28 + left_hip_fork_l3 * F_left_foot_x;
  const Scalar t_left_ankle_cross_30 = left_ankle_cross_I9 * t_left_ankle_cross_4;
  // left_thigh
  const Scalar t_left_thigh_29 = left_ankle_cross_I6 + left_ankle_cross_I10 * c_left_ankle_pitch;
  const Scalar t_left_thigh_30 = t_left_thigh_28 + t_left_ankle_cross_30;
  const Scalar t_left_thigh_31 = t_left_thigh_30 + t_left_ankle_cross_3 * t_left_thigh_29;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + t_left_thigh_8 * t_left_thigh_23;
  const Scalar t_left_thigh_33 = t_left_thigh_32 + t_left_shank_3 * t_left_shank_20;
  const Scalar t_left_thigh_34 = t_left_thigh_33 + t_left_thigh_15 * t_left_thigh_27;
  const Scalar t_left_ankle_cross_31 = left_ankle_cross_I8 * t_left_ankle_cross_6;
  const Scalar t_left_thigh_35 = left_ankle_cross_I1 + t_left_thigh_21 + t_left_shank_17;
  const Scalar t_left_thigh_36 = t_left_thigh_34 + t_left_ankle_cross_31;
  const Scalar t_left_thigh_37 = t_left_thigh_36 + Omega_left_foot_xz * t_left_thigh_35;
  const Scalar t_left_thigh_38 = t_left_thigh_37 + t_left_shank_5 * t_left_shank_15;
  const Scalar t_left_thigh_39 = t_left_thigh_38 + Omega_left_shank_zy * t_left_shank_11;
  const Scalar t_left_thigh_40 = t_left_thigh_39 + t_left_foot_6 * t_left_foot_48;
  const Scalar t_left_thigh_41 = t_left_thigh_40 + s_left_shank_x * t_left_ankle_cross_29;
  const Scalar t_left_thigh_42 = t_left_thigh_41 + t_left_shank_19 * t_left_shank_22;
  const Scalar t_left_thigh_43 = t_left_thigh_42 + t_left_thigh_12 * t_left_thigh_24;
  const Scalar M_left_thigh_y = t_left_thigh_43 + Omega_left_thigh_zy * t_left_thigh_20;
  const Scalar t_left_shank_34 = F_left_ankle_cross_x - Omega_left_foot_xz * t_left_shank_8;
  const Scalar F_left_shank_x = t_left_shank_34 - t_left_shank_6 * t_left_shank_19;
  const Scalar t_left_ankle_cross_32 = t_left_foot_45 - Omega_left_thigh_yx * t_left_shank_19;
  const Scalar t_left_shank_35 = t_left_shank_8 * t_left_shank_23;
  const Scalar t_left_ankle_cross_33 = t_left_ankle_cross_32 + t_left_shank_35;
  const Scalar t_left_thigh_44 = left_thigh_I7 - t_left_thigh_19;
  const Scalar t_left_thigh_45 = Omega_left_thigh_yx * t_left_thigh_23;
  // left_shank
  const Scalar t_left_shank_36 = t_left_ankle_cross_27 - t_left_thigh_45;
  const Scalar t_left_shank_37 = t_left_shank_36 - t_left_shank_1 * F_left_shank_x;
  const Scalar t_left_shank_38 = t_left_shank_37 - Omega_left_foot_xz * t_left_thigh_44;
  const Scalar t_left_shank_39 = t_left_shank_38 + t_left_thigh_20 * t_left_shank_2;
  const Scalar t_left_shank_40 = t_left_shank_39 + t_left_thigh_22 * a_left_thigh_x;
  const Scalar t_left_shank_41 = t_left_shank_40 + s_left_shank_x * t_left_ankle_cross_33;
  const Scalar t_left_shank_42 = t_left_shank_41 + t_left_thigh_2 * t_left_thigh_27;
  const Scalar t_left_shank_43 = t_left_shank_42 + t_left_thigh_24 * t_left_thigh_26;
  const Scalar t_left_shank_44 = t_left_shank_43 - Omega_left_foot_xy * t_left_thigh_21;
  B[8] = -t_left_shank_44;
  const Scalar t_left_thigh_46 = left_ankle_cross_I8 + t_left_shank_15 + t_left_thigh_27;
  const Scalar t_left_thigh_47 = t_left_thigh_21 * (t_left_hip_fork_26 - t_left_thigh_17);
  const Scalar t_left_ankle_cross_34 = t_left_hip_fork_26 - t_left_ankle_cross_7;
  const Scalar t_left_thigh_48 = t_left_thigh_47 + left_hip_fork_l3 * F_left_foot_z;
  const Scalar t_left_ankle_cross_35 = left_ankle_cross_I1 * t_left_ankle_cross_34;
  const Scalar t_left_foot_50 = t_left_foot_17 * (t_left_ankle_cross_5 - t_left_foot_11);
  // left_thigh
  const Scalar t_left_thigh_49 = t_left_thigh_48 + t_left_ankle_cross_35 - t_left_foot_50;
  const Scalar t_left_thigh_50 = t_left_thigh_49 + a_left_foot_z * t_left_foot_14;
  const Scalar t_left_thigh_51 = t_left_thigh_50 + Omega_left_foot_zy * t_left_foot_20;
  const Scalar t_left_thigh_52 = t_left_thigh_51 + t_left_foot_10 * t_left_foot_18;
  const Scalar t_left_thigh_53 = t_left_thigh_52 + t_left_ankle_cross_1 * t_left_foot_49;
  const Scalar t_left_ankle_cross_36 = left_ankle_cross_h2 * t_left_ankle_cross_11;
  const Scalar t_left_thigh_54 = t_left_thigh_53 + t_left_ankle_cross_36;
  const Scalar t_left_thigh_55 = t_left_thigh_54 + t_left_shank_1 * t_left_ankle_cross_29;
  const Scalar t_left_shank_45 = t_left_shank_17 * (t_left_hip_fork_26 - t_left_shank_23);
  const Scalar t_left_thigh_56 = left_ankle_cross_I6 + t_left_foot_19;
  const Scalar t_left_thigh_57 = t_left_ankle_cross_4 * t_left_thigh_56;
  const Scalar t_left_thigh_58 = t_left_thigh_55 + t_left_shank_45 + t_left_thigh_57;
  const Scalar t_left_thigh_59 = t_left_thigh_58 + Omega_left_thigh_zy * t_left_thigh_44;
  const Scalar t_left_thigh_60 = t_left_thigh_59 - t_left_thigh_12 * t_left_thigh_22;
  const Scalar t_left_thigh_61 = t_left_thigh_60 - Omega_left_thigh_yx * t_left_thigh_46;
  const Scalar t_left_ankle_cross_37 = left_ankle_cross_I7 * t_left_ankle_cross_3;
  const Scalar t_left_thigh_62 = t_left_thigh_61 + t_left_ankle_cross_37;
  const Scalar t_left_thigh_63 = t_left_thigh_62 - t_left_shank_8 * t_left_shank_22;
  const Scalar t_left_thigh_64 = t_left_thigh_63 + t_left_thigh_8 * t_left_thigh_20;
  const Scalar t_left_thigh_65 = t_left_thigh_64 + t_left_shank_3 * t_left_shank_11;
  const Scalar M_left_thigh_x = t_left_thigh_65 + Omega_left_shank_zy * t_left_shank_13;
  const Scalar t_left_thigh_66 = Omega_left_thigh_yx * t_left_thigh_24;
  const Scalar t_left_shank_46 = t_left_ankle_cross_33 - t_left_thigh_66;
  const Scalar t_left_shank_47 = t_left_shank_46 + t_left_thigh_17 * t_left_thigh_22;
  const Scalar t_left_thigh_67 = F_left_shank_x - t_left_thigh_16 * t_left_thigh_24;
  const Scalar F_left_thigh_x = t_left_thigh_67 - Omega_left_foot_xz * t_left_thigh_22;
  const Scalar t_left_shank_48 = t_left_ankle_cross_29 + t_left_thigh_8 * t_left_thigh_24;
  const Scalar t_left_shank_49 = t_left_shank_48 - Omega_left_thigh_zy * t_left_thigh_22;
  const Scalar t_left_hip_fork_30 = t_left_hip_block_12 - t_left_hip_fork_26;
  const Scalar t_left_thigh_68 = s_q8_q9_q10 * M_left_thigh_y - c_q8_q9_q10 * M_left_thigh_x;
  // left_hip_fork
  const Scalar t_left_hip_fork_31 = t_left_thigh_68 + left_hip_fork_h3 * t_left_hip_fork_21;
  const Scalar t_left_hip_fork_32 = t_left_hip_fork_31 - left_hip_fork_l1 * t_left_shank_49;
  const Scalar t_left_hip_fork_33 = left_hip_fork_I8 * t_left_hip_fork_23;
  const Scalar t_left_hip_fork_34 = t_left_hip_fork_32 - t_left_hip_fork_33;
  const Scalar t_left_hip_fork_35 = left_hip_fork_I9 * t_left_hip_fork_30;
  const Scalar t_left_hip_fork_36 = t_left_hip_fork_34 + t_left_hip_fork_35;
  const Scalar t_left_hip_fork_37 = left_hip_fork_I7 * t_left_hip_fork_15;
  const Scalar t_left_hip_fork_38 = t_left_hip_fork_36 - t_left_hip_fork_37;
  const Scalar M_left_hip_fork_x = t_left_hip_fork_38 + left_hip_fork_I6 * Omega_left_hip_fork_zy;
  const Scalar t_left_hip_fork_39 = t_left_hip_fork_24 - t_left_hip_fork_25;
  const Scalar t_left_hip_fork_40 = t_left_hip_block_12 - t_left_hip_fork_39;
  const Scalar t_left_hip_fork_41 = t_left_hip_fork_30 - t_left_hip_fork_39;
  // left_thigh
  const Scalar t_left_thigh_69 = c_q8_q9_q10 * M_left_thigh_y + s_q8_q9_q10 * M_left_thigh_x;
  const Scalar t_left_thigh_70 = t_left_thigh_69 - left_hip_fork_I7 * t_left_hip_fork_41;
  const Scalar t_left_thigh_71 = t_left_thigh_70 + left_hip_fork_h3 * t_left_hip_fork_28;
  const Scalar t_left_thigh_72 = t_left_thigh_71 + left_hip_fork_I6 * Omega_left_hip_fork_xy;
  const Scalar t_left_thigh_73 = t_left_thigh_72 + left_hip_fork_I10 * t_left_hip_fork_23;
  const Scalar t_left_thigh_74 = t_left_thigh_73 + left_hip_fork_h1 * a_left_hip_fork_y;
  const Scalar t_left_thigh_75 = t_left_thigh_74 + left_hip_fork_I9 * t_left_hip_fork_11;
  const Scalar t_left_thigh_76 = t_left_thigh_75 - left_hip_fork_I8 * t_left_hip_fork_3;
  B[7] = -t_left_thigh_76;
  const Scalar t_left_thigh_77 = c_q8_q9_q10 * F_left_thigh_x + s_q8_q9_q10 * t_left_shank_47;
  // left_hip_fork
  const Scalar t_left_hip_fork_42 = t_left_shank_44 - left_hip_fork_h1 * t_left_hip_fork_21;
  const Scalar t_left_hip_fork_43 = t_left_hip_fork_42 - left_hip_fork_l1 * t_left_thigh_77;
  const Scalar t_left_hip_fork_44 = left_hip_fork_I8 * t_left_hip_fork_39;
  const Scalar t_left_hip_fork_45 = t_left_hip_fork_43 - t_left_hip_fork_44;
  const Scalar t_left_hip_fork_46 = left_hip_fork_I7 * Omega_left_hip_fork_zy;
  const Scalar t_left_hip_fork_47 = t_left_hip_fork_45 - t_left_hip_fork_46;
  const Scalar t_left_hip_fork_48 = left_hip_fork_I10 * t_left_hip_fork_15;
  const Scalar t_left_hip_fork_49 = t_left_hip_fork_47 + t_left_hip_fork_48;
  const Scalar M_left_hip_fork_y = t_left_hip_fork_49 - left_hip_fork_I9 * Omega_left_hip_fork_xy;
  const Scalar t_left_thigh_78 = t_left_thigh_77 - left_hip_fork_h1 * t_left_hip_fork_40;
  const Scalar t_left_thigh_79 = t_left_thigh_78 + left_hip_fork_h3 * Omega_left_hip_fork_xy;
  const Scalar t_left_hip_fork_50 = left_hip_fork_h1 * t_left_hip_fork_15;
  const Scalar t_left_hip_fork_51 = t_left_hip_fork_50 - s_q8_q9_q10 * F_left_thigh_x;
  const Scalar t_left_hip_fork_52 = t_left_hip_fork_51 + c_q8_q9_q10 * t_left_shank_47;
  const Scalar F_left_hip_fork_z = t_left_hip_fork_52 - left_hip_fork_h3 * Omega_left_hip_fork_zy;
  const Scalar t_left_hip_fork_53 = t_left_shank_49 + left_hip_fork_h3 * t_left_hip_fork_26;
  const Scalar F_left_hip_fork_y = t_left_hip_fork_53 + left_hip_fork_h1 * t_left_hip_fork_23;
  // left_hip_block
  const Scalar t_left_hip_block_20 = t_base_rx_11 - t_left_hip_block_17;
  const Scalar t_left_hip_block_21 = t_left_hip_block_12 - t_left_hip_block_20;
  const Scalar t_left_hip_block_22 = left_hip_block_I8 * t_left_hip_block_21;
  const Scalar t_left_hip_block_23 = t_right_hip_block_34 - t_left_hip_block_22;
  const Scalar t_left_hip_block_24 = left_hip_block_I11 * t_left_hip_block_13;
  const Scalar t_left_hip_block_25 = t_left_hip_block_23 - t_left_hip_block_24;
  const Scalar t_left_hip_block_26 = left_hip_block_h3 * a_left_hip_block_x;
  const Scalar t_left_hip_block_27 = t_left_hip_block_25 + t_left_hip_block_26;
  const Scalar t_left_hip_block_28 = left_hip_block_h1 * a_left_hip_block_y;
  const Scalar t_left_hip_block_29 = t_left_hip_block_27 + t_left_hip_block_28;
  const Scalar t_left_hip_block_30 = t_left_hip_block_29 - s_left_hip_roll * M_left_hip_fork_y;
  const Scalar t_left_hip_block_31 = left_hip_block_I10 * Omega_left_hip_block_yz;
  const Scalar t_left_hip_block_32 = t_left_hip_block_30 - t_left_hip_block_31;
  const Scalar t_left_hip_block_33 = t_left_hip_block_32 + c_left_hip_roll * M_left_hip_fork_x;
  const Scalar t_left_hip_block_34 = left_hip_block_I9 * Omega_left_hip_block_xz;
  const Scalar M_left_hip_block_z = t_left_hip_block_33 - t_left_hip_block_34;
  B[6] = M_left_hip_block_z;
  const Scalar t_left_hip_block_35 = left_hip_block_h1 * Omega_left_hip_block_yx;
  const Scalar t_left_hip_fork_54 = F_left_hip_fork_z - t_left_hip_block_35;
  const Scalar t_left_hip_block_36 = left_hip_block_h3 * t_left_hip_block_12;
  const Scalar t_left_hip_fork_55 = t_left_hip_fork_54 - t_left_hip_block_36;
  // right_hip_fork
  const Scalar t_right_hip_fork_58 = s_right_hip_roll * F_right_hip_fork_x;
  const Scalar t_right_hip_fork_59 = c_right_hip_roll * F_right_hip_fork_y;
  const Scalar t_right_hip_fork_60 = t_right_hip_fork_58 + t_right_hip_fork_59;
  const Scalar t_right_hip_fork_61 = s_right_hip_roll * F_right_hip_fork_y;
  const Scalar t_right_hip_fork_62 = c_right_hip_roll * F_right_hip_fork_x;
  const Scalar t_right_hip_fork_63 = t_right_hip_fork_61 - t_right_hip_fork_62;
  const Scalar t_right_hip_block_50 = left_hip_block_h3 * t_right_hip_block_6;
  const Scalar t_right_hip_fork_64 = t_right_hip_fork_63 - t_right_hip_block_50;
  const Scalar t_right_hip_block_51 = left_hip_block_h1 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_fork_65 = t_right_hip_fork_64 + t_right_hip_block_51;
  const Scalar t_left_hip_fork_56 = c_left_hip_roll * t_left_thigh_79;
  const Scalar t_left_hip_fork_57 = t_left_hip_fork_56 + s_left_hip_roll * F_left_hip_fork_y;
  const Scalar t_left_hip_block_37 = left_hip_block_h3 * t_left_hip_block_7;
  const Scalar t_left_hip_fork_58 = t_left_hip_fork_57 - t_left_hip_block_37;
  const Scalar t_left_hip_block_38 = left_hip_block_h1 * Omega_left_hip_block_zx;
  const Scalar t_left_hip_fork_59 = t_left_hip_fork_58 - t_left_hip_block_38;
  const Scalar t_base_rx_12 = t_right_hip_fork_65 - t_left_hip_fork_59;
  // right_hip_block
  const Scalar t_right_hip_block_52 = left_hip_block_I10 * t_right_hip_block_33;
  const Scalar t_right_hip_block_53 = t_left_hip_block_15 + t_right_thigh_67;
  const Scalar t_right_hip_block_54 = t_right_hip_block_53 + t_right_hip_block_52;
  const Scalar t_right_hip_fork_66 = left_hip_block_l2 * t_right_hip_fork_60;
  const Scalar t_right_hip_block_55 = t_right_hip_block_54 + t_right_hip_fork_66;
  const Scalar t_right_hip_block_56 = left_hip_block_I8 * t_right_hip_block_6;
  const Scalar t_right_hip_block_57 = t_right_hip_block_55 - t_right_hip_block_56;
  const Scalar t_right_hip_block_58 = left_hip_block_I7 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_block_59 = t_right_hip_block_57 - t_right_hip_block_58;
  const Scalar t_right_hip_block_60 = left_hip_block_I9 * t_right_hip_block_14;
  const Scalar M_right_hip_block_y = t_right_hip_block_59 - t_right_hip_block_60;
  const Scalar t_base_rx_13 = t_base_ry_3 - t_base_rx_11;
  const Scalar t_base_rx_14 = t_base_rx_8 - t_base_rx_13;
  const Scalar t_left_hip_fork_60 = c_left_hip_roll * F_left_hip_fork_y;
  const Scalar t_left_hip_fork_61 = t_left_hip_fork_60 - s_left_hip_roll * t_left_thigh_79;
  const Scalar t_left_hip_block_39 = t_left_hip_block_15 + t_left_thigh_76;
  const Scalar t_left_hip_fork_62 = left_hip_block_l2 * t_left_hip_fork_61;
  // left_hip_block
  const Scalar t_left_hip_block_40 = t_left_hip_block_39 + t_left_hip_fork_62;
  const Scalar t_left_hip_block_41 = left_hip_block_I9 * t_left_hip_block_14;
  const Scalar t_left_hip_block_42 = t_left_hip_block_40 - t_left_hip_block_41;
  const Scalar t_left_hip_block_43 = left_hip_block_I7 * Omega_left_hip_block_zx;
  const Scalar t_left_hip_block_44 = t_left_hip_block_42 - t_left_hip_block_43;
  const Scalar t_left_hip_block_45 = left_hip_block_I8 * t_left_hip_block_7;
  const Scalar t_left_hip_block_46 = t_left_hip_block_44 + t_left_hip_block_45;
  const Scalar t_left_hip_block_47 = left_hip_block_I10 * t_left_hip_block_17;
  const Scalar M_left_hip_block_y = t_left_hip_block_46 - t_left_hip_block_47;
  const Scalar t_left_hip_fork_63 = t_left_hip_block_16 - left_hip_block_l2 * F_left_hip_fork_z;
  const Scalar t_left_hip_fork_64 = t_left_hip_fork_63 - c_left_hip_roll * M_left_hip_fork_y;
  const Scalar t_left_hip_block_48 = left_hip_block_I8 * Omega_left_hip_block_zx;
  const Scalar t_left_hip_fork_65 = t_left_hip_fork_64 + t_left_hip_block_48;
  const Scalar t_left_hip_block_49 = left_hip_block_I10 * Omega_left_hip_block_yx;
  const Scalar t_left_hip_fork_66 = t_left_hip_fork_65 + t_left_hip_block_49;
  const Scalar t_left_hip_block_50 = left_hip_block_I12 * t_left_hip_block_7;
  const Scalar t_left_hip_fork_67 = t_left_hip_fork_66 - t_left_hip_block_50;
  const Scalar t_left_hip_block_51 = left_hip_block_I9 * (t_base_rx_11 - t_left_hip_block_12);
  const Scalar t_left_hip_fork_68 = t_left_hip_fork_67 - s_left_hip_roll * M_left_hip_fork_x;
  const Scalar M_left_hip_block_x = t_left_hip_fork_68 - t_left_hip_block_51;
  // base_rx
  const Scalar t_base_rx_15 = base_rx_I1 * Omega_base_rx_xz + left_hip_block_l1 * t_base_rx_12;
  const Scalar t_base_rx_16 = t_base_rx_15 - c_right_hip_yaw * M_right_hip_block_y;
  const Scalar t_base_rx_17 = t_base_rx_16 - base_rx_I6 * t_base_rx_14;
  const Scalar t_base_rx_18 = t_base_rx_17 + s_right_hip_yaw * t_right_hip_fork_49;
  const Scalar t_base_rx_19 = t_base_rx_18 - base_rx_I7 * Omega_base_rx_xy;
  const Scalar t_base_rx_20 = t_base_rx_19 - c_left_hip_yaw * M_left_hip_block_y;
  const Scalar t_base_rx_21 = t_base_rx_20 - base_rx_I5 * t_base_rx_3;
  const Scalar t_base_rx_22 = t_base_rx_21 - base_rx_I10 * t_base_rx_10;
  const Scalar M_base_rx_z = t_base_rx_22 - s_left_hip_yaw * M_left_hip_block_x;
  B[5] = M_base_rx_z;
  const Scalar t_right_hip_block_61 = left_hip_block_h3 * t_right_hip_block_15;
  const Scalar t_right_hip_block_62 = left_hip_block_h1 * Omega_right_hip_block_yx;
  const Scalar t_right_hip_fork_67 = F_right_hip_fork_z - t_right_hip_block_61;
  const Scalar t_right_hip_fork_68 = t_right_hip_fork_67 + t_right_hip_block_62;
  const Scalar t_right_hip_block_63 = left_hip_block_h1 * t_right_hip_block_49;
  const Scalar t_right_hip_fork_69 = t_right_hip_fork_60 - t_right_hip_block_63;
  const Scalar t_right_hip_block_64 = left_hip_block_h3 * t_right_hip_block_14;
  const Scalar t_right_hip_fork_70 = t_right_hip_fork_69 - t_right_hip_block_64;
  // right_hip_block
  const Scalar t_right_hip_block_65 = s_right_hip_yaw * t_right_hip_fork_70;
  const Scalar t_right_hip_block_66 = c_right_hip_yaw * t_right_hip_fork_68;
  const Scalar t_right_hip_block_67 = t_right_hip_block_65 + t_right_hip_block_66;
  const Scalar t_left_hip_block_52 = left_hip_block_h3 * t_left_hip_block_14;
  const Scalar t_left_hip_fork_69 = t_left_hip_fork_61 - t_left_hip_block_52;
  const Scalar t_left_hip_block_53 = left_hip_block_h1 * t_left_hip_block_20;
  const Scalar t_left_hip_fork_70 = t_left_hip_fork_69 + t_left_hip_block_53;
  // left_hip_block
  const Scalar t_left_hip_block_54 = c_left_hip_yaw * t_left_hip_fork_55;
  const Scalar t_left_hip_block_55 = s_left_hip_yaw * t_left_hip_fork_70;
  const Scalar t_left_hip_block_56 = t_left_hip_block_54 + t_left_hip_block_55;
  const Scalar t_left_hip_block_57 = M_right_hip_block_z + M_left_hip_block_z;
  const Scalar t_left_hip_block_58 = t_right_hip_block_67 - t_left_hip_block_56;
  const Scalar t_left_hip_block_59 = t_left_hip_block_57 - base_rx_I5 * t_base_rx_8;
  const Scalar t_left_hip_block_60 = left_hip_block_l1 * t_left_hip_block_58;
  const Scalar t_left_hip_block_61 = t_left_hip_block_59 + t_left_hip_block_60;
  const Scalar t_left_hip_block_62 = t_left_hip_block_61 + base_rx_I6 * Omega_base_rx_zy;
  const Scalar t_left_hip_block_63 = t_left_hip_block_62 + base_rx_I1 * Omega_base_rx_xy;
  const Scalar t_left_hip_block_64 = t_left_hip_block_63 + base_rx_I10 * Omega_base_rx_zx;
  // base_rx
  const Scalar t_base_rx_23 = s_right_hip_yaw * M_right_hip_block_y + base_rx_I5 * t_base_rx_10;
  const Scalar t_base_rx_24 = t_base_rx_23 + c_right_hip_yaw * t_right_hip_fork_49;
  const Scalar t_base_rx_25 = t_base_rx_24 + s_left_hip_yaw * M_left_hip_block_y;
  const Scalar t_base_rx_26 = t_base_rx_25 + base_rx_I6 * Omega_base_rx_zx;
  const Scalar t_base_rx_27 = t_base_rx_26 + base_rx_I7 * Omega_base_rx_zy;
  const Scalar t_base_rx_28 = t_base_rx_27 + base_rx_I1 * t_base_rx_13;
  const Scalar M_base_rx_x = t_base_rx_28 - c_left_hip_yaw * M_left_hip_block_x;
  const Scalar t_base_ry_4 = base_rx_I8 * t_base_ry_2 - s_base_rx * t_left_hip_block_64;
  B[4] = t_base_ry_4 - c_base_rx * M_base_rx_x;
  const Scalar t_right_hip_block_68 = s_right_hip_yaw * t_right_hip_fork_68;
  const Scalar t_left_hip_block_65 = s_left_hip_yaw * t_left_hip_fork_55;
  const Scalar t_left_hip_block_66 = t_right_hip_block_68 + t_left_hip_block_65;
  const Scalar t_right_hip_block_69 = c_right_hip_yaw * t_right_hip_fork_70;
  // left_hip_block
  const Scalar t_left_hip_block_67 = t_left_hip_block_66 - t_right_hip_block_69;
  const Scalar t_left_hip_block_68 = t_left_hip_block_67 + base_rx_h4 * Omega_base_rx_xy;
  const Scalar t_left_hip_block_69 = t_left_hip_block_68 + base_rx_h1 * Omega_base_rx_xx;
  const Scalar t_left_hip_block_70 = c_left_hip_yaw * t_left_hip_fork_70;
  const Scalar t_left_hip_block_71 = t_left_hip_block_69 - t_left_hip_block_70;
  // base_rx
  const Scalar t_base_rx_29 = t_right_hip_fork_65 + t_left_hip_fork_59;
  const Scalar t_base_rx_30 = t_base_rx_29 + base_rx_h1 * t_base_rx_10;
  const Scalar F_base_rx_y = t_base_rx_30 + base_rx_h4 * t_base_rx_11;
  const Scalar t_base_rz_1 = base_rx_h5 * alpha_base_ry_x - c_base_rx * t_left_hip_block_71;
  const Scalar F_base_rz_y = t_base_rz_1 - s_base_rx * F_base_rx_y;
  const Scalar t_base_ry_5 = s_base_rx * M_base_rx_x + base_rx_I9 * alpha_base_ry_x;
  const Scalar M_base_ry_x = t_base_ry_5 - c_base_rx * t_left_hip_block_64;
  B[3] = -(s_base_ry * M_base_rx_z + c_base_ry * M_base_ry_x);
  const Scalar t_base_ry_6 = base_rx_h2 * t_base_ry_2 + c_base_rx * F_base_rx_y;
  const Scalar F_base_ry_x = t_base_ry_6 - s_base_rx * t_left_hip_block_71;
  const Scalar t_base_rx_31 = t_right_hip_block_67 + t_left_hip_block_56;
  const Scalar t_base_rx_32 = t_base_rx_31 - base_rx_h2 * t_base_ry_3;
  const Scalar t_base_rx_33 = t_base_rx_32 - base_rx_h1 * Omega_base_rx_zx;
  const Scalar t_base_rx_34 = t_base_rx_33 - base_rx_h4 * Omega_base_rx_zy;
  B[2] = -(c_base_ry * F_base_ry_x + s_base_ry * t_base_rx_34);
  const Scalar F_base_rz_x = s_base_ry * F_base_ry_x - c_base_ry * t_base_rx_34;
  // base_pz
  B[1] = -(c_base_rz * F_base_rz_y + s_base_rz * F_base_rz_x);
  B[0] = s_base_rz * F_base_rz_y - c_base_rz * F_base_rz_x;
}

void gravity_force(const Scalar q[18], Scalar G[18]) noexcept {
  const auto [s_base_ry, c_base_ry] = sine_cosine(q[4]);
  const auto [s_base_rx, c_base_rx] = sine_cosine(q[5]);
  const auto [s_left_hip_yaw, c_left_hip_yaw] = sine_cosine(q[6]);
  const auto [s_left_hip_roll, c_left_hip_roll] = sine_cosine(q[7]);
  const auto [s_left_hip_pitch, c_left_hip_pitch] = sine_cosine(q[8]);
  const Scalar q_q8_q9 = q[8] + q[9];
  const auto [s_q8_q9, c_q8_q9] = sine_cosine(q_q8_q9);
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const auto [s_q8_q9_q10, c_q8_q9_q10] = sine_cosine(q_q8_q9_q10);
  const auto [s_right_hip_yaw, c_right_hip_yaw] = sine_cosine(q[12]);
  const auto [s_right_hip_roll, c_right_hip_roll] = sine_cosine(q[13]);
  const auto [s_right_hip_pitch, c_right_hip_pitch] = sine_cosine(q[14]);
  const Scalar q_q14_q15 = q[14] + q[15];
  const auto [s_q14_q15, c_q14_q15] = sine_cosine(q_q14_q15);
  // right_foot
  const Scalar q_q14_q15_q16 = q_q14_q15 + q[16];
  const auto [s_q14_q15_q16, c_q14_q15_q16] = sine_cosine(q_q14_q15_q16);
  const Scalar t_right_foot_1 = left_foot_k1 - q[17];
  const auto [s_right_foot, c_right_foot] = sine_cosine(t_right_foot_1);
  const Scalar h_right_foot_x = left_foot_h1 * c_right_foot;
  const Scalar t_right_foot_2 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_3 = base_g1 * c_base_ry;
  const Scalar t_right_foot_4 = s_base_rx * t_right_foot_3;
  const Scalar t_right_foot_5 = base_g1 * s_base_ry;
  const Scalar t_right_foot_6 = c_right_hip_yaw * t_right_foot_4;
  const Scalar t_right_foot_7 = t_right_foot_6 + s_right_hip_yaw * t_right_foot_5;
  const Scalar t_right_foot_8 = c_base_rx * t_right_foot_3;
  const Scalar t_right_foot_9 = c_right_hip_roll * t_right_foot_8;
  const Scalar t_right_foot_10 = t_right_foot_9 - s_right_hip_roll * t_right_foot_7;
  const Scalar t_right_foot_11 = s_right_hip_yaw * t_right_foot_4;
  const Scalar t_right_foot_12 = t_right_foot_11 - c_right_hip_yaw * t_right_foot_5;
  const Scalar t_right_foot_13 = s_right_hip_roll * t_right_foot_8;
  const Scalar t_right_foot_14 = t_right_foot_13 + c_right_hip_roll * t_right_foot_7;
  const Scalar t_right_foot_15 = c_q14_q15_q16 * t_right_foot_10;
  const Scalar t_right_foot_16 = t_right_foot_15 + s_q14_q15_q16 * t_right_foot_12;
  G[17] = h_right_foot_x * t_right_foot_14 - t_right_foot_2 * t_right_foot_16;
  const Scalar t_right_foot_17 = left_ankle_cross_h1 + h_right_foot_x;
  const Scalar t_right_foot_18 = left_ankle_cross_h2 * s_q14_q15_q16;
  const Scalar t_right_foot_19 = t_right_foot_18 + c_q14_q15_q16 * t_right_foot_17;
  const Scalar t_right_foot_20 = left_ankle_cross_h2 * c_q14_q15_q16;
  const Scalar h_righ_ankl_cros_y = t_right_foot_20 - s_q14_q15_q16 * t_right_foot_17;
  G[16] = -(t_right_foot_12 * t_right_foot_19 + t_right_foot_10 * h_righ_ankl_cros_y);
  const Scalar t_right_shank_1 = h_righ_ankl_cros_y - left_shank_h1 * c_q14_q15;
  const Scalar h_right_shank_y = t_right_shank_1 - left_shank_h2 * s_q14_q15;
  const Scalar t_righ_ankl_cros_1 = t_right_foot_19 - left_shank_h1 * s_q14_q15;
  const Scalar t_righ_ankl_cros_2 = t_righ_ankl_cros_1 + left_shank_h2 * c_q14_q15;
  // right_shank
  G[15] = -(t_right_foot_12 * t_righ_ankl_cros_2 + t_right_foot_10 * h_right_shank_y);
  const Scalar t_right_shank_2 = t_righ_ankl_cros_2 - left_thigh_h2 * s_right_hip_pitch;
  const Scalar t_right_shank_3 = t_right_shank_2 + left_thigh_h1 * c_right_hip_pitch;
  const Scalar t_right_thigh_1 = left_hip_fork_h1 + t_right_shank_3;
  const Scalar h_right_hip_fork_y = left_hip_fork_h2 + t_right_foot_2;
  // right_thigh
  const Scalar t_right_thigh_2 = h_right_shank_y - left_thigh_h1 * s_right_hip_pitch;
  const Scalar h_right_thigh_y = t_right_thigh_2 - left_thigh_h2 * c_right_hip_pitch;
  G[14] = -(t_right_foot_10 * h_right_thigh_y + t_right_foot_12 * t_right_shank_3);
  // right_hip_fork
  const Scalar t_right_hip_fork_1 = left_hip_block_h2 + h_right_thigh_y;
  G[13] = t_right_foot_14 * t_right_thigh_1 - t_right_foot_10 * h_right_hip_fork_y;
  const Scalar t_right_hip_fork_2 = left_hip_block_h1 - s_right_hip_roll * t_right_thigh_1;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 + c_right_hip_roll * h_right_hip_fork_y;
  G[12] = t_right_foot_7 * t_right_hip_fork_1 + t_right_foot_12 * t_right_hip_fork_3;
  // left_foot
  const Scalar t_left_foot_1 = left_foot_k1 + q[11];
  const auto [s_left_foot, c_left_foot] = sine_cosine(t_left_foot_1);
  const Scalar h_left_foot_x = left_foot_h1 * c_left_foot;
  const Scalar h_left_foot_y = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_2 = c_left_hip_yaw * t_right_foot_4;
  const Scalar t_left_foot_3 = t_left_foot_2 + s_left_hip_yaw * t_right_foot_5;
  const Scalar t_left_foot_4 = c_left_hip_roll * t_right_foot_8;
  const Scalar t_left_foot_5 = t_left_foot_4 - s_left_hip_roll * t_left_foot_3;
  const Scalar t_left_foot_6 = s_left_hip_yaw * t_right_foot_4;
  const Scalar t_left_foot_7 = t_left_foot_6 - c_left_hip_yaw * t_right_foot_5;
  const Scalar t_left_foot_8 = s_left_hip_roll * t_right_foot_8;
  const Scalar t_left_foot_9 = t_left_foot_8 + c_left_hip_roll * t_left_foot_3;
  const Scalar t_left_foot_10 = c_q8_q9_q10 * t_left_foot_5 + s_q8_q9_q10 * t_left_foot_7;
  G[11] = h_left_foot_x * t_left_foot_9 + h_left_foot_y * t_left_foot_10;
  const Scalar t_left_foot_11 = left_ankle_cross_h1 + h_left_foot_x;
  const Scalar t_left_foot_12 = left_ankle_cross_h2 * s_q8_q9_q10 + c_q8_q9_q10 * t_left_foot_11;
  const Scalar t_left_foot_13 = left_ankle_cross_h2 * c_q8_q9_q10;
  const Scalar h_left_ankle_cross_y = t_left_foot_13 - s_q8_q9_q10 * t_left_foot_11;
  G[10] = -(t_left_foot_7 * t_left_foot_12 + t_left_foot_5 * h_left_ankle_cross_y);
  const Scalar t_left_shank_1 = h_left_ankle_cross_y - left_shank_h2 * s_q8_q9;
  const Scalar h_left_shank_y = t_left_shank_1 - left_shank_h1 * c_q8_q9;
  const Scalar t_left_ankle_cross_1 = t_left_foot_12 - left_shank_h1 * s_q8_q9;
  const Scalar t_left_ankle_cross_2 = t_left_ankle_cross_1 + left_shank_h2 * c_q8_q9;
  // left_shank
  G[9] = -(t_left_foot_5 * h_left_shank_y + t_left_foot_7 * t_left_ankle_cross_2);
  const Scalar t_left_shank_2 = t_left_ankle_cross_2 - left_thigh_h2 * s_left_hip_pitch;
  const Scalar t_left_shank_3 = t_left_shank_2 + left_thigh_h1 * c_left_hip_pitch;
  // left_thigh
  const Scalar t_left_thigh_1 = left_hip_fork_h1 + t_left_shank_3;
  const Scalar t_left_thigh_2 = left_hip_fork_h2 + h_left_foot_y;
  const Scalar t_left_thigh_3 = h_left_shank_y - left_thigh_h2 * c_left_hip_pitch;
  const Scalar h_left_thigh_y = t_left_thigh_3 - left_thigh_h1 * s_left_hip_pitch;
  G[8] = -(t_left_foot_7 * t_left_shank_3 + t_left_foot_5 * h_left_thigh_y);
  const Scalar t_left_hip_block_1 = left_hip_block_h1 + s_left_hip_roll * t_left_thigh_1;
  const Scalar h_left_hip_block_x = t_left_hip_block_1 + c_left_hip_roll * t_left_thigh_2;
  const Scalar t_left_hip_fork_1 = left_hip_block_h2 + h_left_thigh_y;
  G[7] = t_left_foot_5 * t_left_thigh_2 + t_left_foot_9 * t_left_thigh_1;
  G[6] = t_left_foot_3 * t_left_hip_fork_1 - t_left_foot_7 * h_left_hip_block_x;
  // base_rx
  const Scalar t_base_rx_1 = base_rx_h3 - c_right_hip_roll * t_right_thigh_1;
  const Scalar t_base_rx_2 = t_base_rx_1 + s_left_hip_roll * t_left_thigh_2;
  const Scalar t_base_rx_3 = t_base_rx_2 - s_right_hip_roll * h_right_hip_fork_y;
  // left_hip_block
  const Scalar t_left_hip_block_2 = t_base_rx_3 - c_left_hip_roll * t_left_thigh_1;
  const Scalar t_left_hip_block_3 = base_rx_h1 + s_right_hip_yaw * t_right_hip_fork_1;
  const Scalar t_left_hip_block_4 = t_left_hip_block_3 + c_left_hip_yaw * h_left_hip_block_x;
  const Scalar t_left_hip_block_5 = t_left_hip_block_4 + s_left_hip_yaw * t_left_hip_fork_1;
  const Scalar t_left_hip_block_6 = t_left_hip_block_5 - c_right_hip_yaw * t_right_hip_fork_3;
  // base_rx
  G[5] = t_right_foot_8 * t_left_hip_block_6 - t_right_foot_4 * t_left_hip_block_2;
  const Scalar t_base_rx_4 = base_rx_h2 + c_right_hip_yaw * t_right_hip_fork_1;
  const Scalar t_base_rx_5 = t_base_rx_4 + s_right_hip_yaw * t_right_hip_fork_3;
  const Scalar t_base_rx_6 = t_base_rx_5 - s_left_hip_yaw * h_left_hip_block_x;
  const Scalar t_base_rx_7 = t_base_rx_6 + c_left_hip_yaw * t_left_hip_fork_1;
  const Scalar t_base_rx_8 = c_base_rx * t_left_hip_block_2 + s_base_rx * t_left_hip_block_6;
  // base_ry
  G[4] = -(t_right_foot_3 * t_base_rx_7 + t_right_foot_5 * t_base_rx_8);
  G[2] = base_rx_w1;
  G[0] = 0.0;
  G[1] = 0.0;
  G[3] = 0.0;
}

void inverse_dynamics(const Scalar q[18], const Scalar qd[18], const Scalar qdd[18],
                      Scalar tau[18]) noexcept {
  const auto [s_base_rz, c_base_rz] = sine_cosine(q[3]);
  const auto [s_base_ry, c_base_ry] = sine_cosine(q[4]);
  const auto [s_base_rx, c_base_rx] = sine_cosine(q[5]);
  const auto [s_left_hip_yaw, c_left_hip_yaw] = sine_cosine(q[6]);
  const auto [s_left_hip_roll, c_left_hip_roll] = sine_cosine(q[7]);
  const auto [s_left_hip_pitch, c_left_hip_pitch] = sine_cosine(q[8]);
  const auto [s_left_knee, c_left_knee] = sine_cosine(q[9]);
  const auto [s_left_ankle_pitch, c_left_ankle_pitch] = sine_cosine(q[10]);
  const auto [s_right_hip_yaw, c_right_hip_yaw] = sine_cosine(q[12]);
  const auto [s_right_hip_roll, c_right_hip_roll] = sine_cosine(q[13]);
  const auto [s_right_hip_pitch, c_right_hip_pitch] = sine_cosine(q[14]);
  const auto [s_right_knee, c_right_knee] = sine_cosine(q[15]);
  const auto [s_right_ankle_pitch, c_right_ankle_pitch] = sine_cosine(q[16]);
  const Scalar a_base_pz_z = base_g1 + qdd[2];
  const Scalar a_base_rz_y = s_base_rz * qdd[0] - c_base_rz * qdd[1];
  const Scalar t_base_rz_1 = c_base_rz * qdd[0] + s_base_rz * qdd[1];
  // base_ry
  const Scalar a_base_ry_y = s_base_ry * a_base_pz_z - c_base_ry * t_base_rz_1;
  const Scalar omega_base_ry_y = s_base_ry * qd[3];
  const Scalar t_base_ry_1 = c_base_ry * qdd[3] - omega_base_ry_y * qd[4] * 2.0;
  const Scalar t_base_ry_2 = c_base_ry * a_base_pz_z + s_base_ry * t_base_rz_1;
  const Scalar t_base_ry_3 = c_base_ry * qd[3];
  const Scalar t_base_ry_4 = qdd[4] + omega_base_ry_y * t_base_ry_3;
  // base_rx
  const Scalar t_base_rx_1 = c_base_rx * t_base_ry_3 - s_base_rx * qd[4];
  const Scalar t_base_rx_2 = omega_base_ry_y - qd[5];
  const Scalar Omega_base_rx_yz = s_base_rx * t_base_ry_1 + c_base_rx * t_base_ry_4;
  const Scalar t_base_rx_3 = Omega_base_rx_yz - t_base_rx_1 * t_base_rx_2 * 2.0;
  const Scalar t_base_rx_4 = s_base_rx * t_base_ry_3 + c_base_rx * qd[4];
  const Scalar t_base_rx_5 = t_base_rx_2 * t_base_rx_4;
  const Scalar t_base_rx_6 = c_base_rx * t_base_ry_1 - s_base_rx * t_base_ry_4;
  const Scalar t_base_rx_7 = t_base_rx_5 + t_base_rx_6;
  const Scalar Omega_base_rx_zx = t_base_rx_5 + t_base_rx_7;
  const Scalar t_base_rx_8 = t_base_rx_4 * t_base_rx_4;
  const Scalar t_base_rx_9 = t_base_rx_2 * t_base_rx_2;
  const Scalar t_base_ry_5 = t_base_ry_3 * t_base_ry_3 + qd[4] * qd[4];
  const Scalar t_base_rx_10 = t_base_rx_8 - t_base_rx_9;
  const Scalar t_base_rx_11 = t_base_ry_5 - t_base_rx_10;
  const Scalar t_base_rx_12 = t_base_rx_1 * t_base_rx_4;
  const Scalar alpha_base_rx_z = qdd[5] - qd[4] * t_base_ry_3 - s_base_ry * qdd[3];
  const Scalar Omega_base_rx_xy = t_base_rx_12 - alpha_base_rx_z;
  const Scalar Omega_base_rx_yx = t_base_rx_12 + alpha_base_rx_z;
  const Scalar t_base_rx_13 = t_base_rx_8 + t_base_rx_9;
  // left_hip_block
  const Scalar t_left_hip_block_1 = left_hip_block_l1 * Omega_base_rx_zx;
  const Scalar t_left_hip_block_2 = a_base_ry_y + left_hip_block_l2 * t_base_rx_3;
  const Scalar t_left_hip_block_3 = t_left_hip_block_1 + t_left_hip_block_2;
  const Scalar t_left_hip_block_4 = left_hip_block_l1 * t_base_rx_11;
  const Scalar t_base_rx_14 = s_base_rx * t_base_ry_2 - c_base_rx * a_base_rz_y;
  const Scalar t_left_hip_block_5 = t_base_rx_14 - left_hip_block_l2 * Omega_base_rx_xy;
  const Scalar t_left_hip_block_6 = t_left_hip_block_4 - t_left_hip_block_5;
  const Scalar t_left_hip_block_7 = s_left_hip_yaw * t_left_hip_block_3;
  const Scalar a_left_hip_block_x = t_left_hip_block_7 - c_left_hip_yaw * t_left_hip_block_6;
  const Scalar t_left_hip_block_8 = c_left_hip_yaw * t_left_hip_block_3;
  const Scalar a_left_hip_block_y = t_left_hip_block_8 + s_left_hip_yaw * t_left_hip_block_6;
  const Scalar t_left_hip_block_9 = c_left_hip_yaw * t_base_rx_4;
  const Scalar omega_left_hip_block_x = t_left_hip_block_9 + s_left_hip_yaw * t_base_rx_2;
  const Scalar omega_left_hip_block_z = t_base_rx_1 + qd[6];
  const Scalar t_left_hip_block_10 = omega_left_hip_block_x * omega_left_hip_block_z;
  const Scalar t_left_hip_block_11 = c_left_hip_yaw * Omega_base_rx_xy;
  const Scalar Omega_left_hip_block_xz = t_left_hip_block_11 - s_left_hip_yaw * t_base_rx_3;
  const Scalar t_left_hip_block_12 = t_left_hip_block_10 - Omega_left_hip_block_xz;
  const Scalar Omega_left_hip_block_zx = t_left_hip_block_10 + t_left_hip_block_12;
  const Scalar t_left_hip_block_13 = c_left_hip_yaw * t_base_rx_2;
  const Scalar omega_left_hip_block_y = t_left_hip_block_13 - s_left_hip_yaw * t_base_rx_4;
  const Scalar t_left_hip_block_14 = s_left_hip_yaw * Omega_base_rx_xy;
  const Scalar t_left_hip_block_15 = c_left_hip_yaw * t_base_rx_3 + t_left_hip_block_14;
  const Scalar t_left_hip_block_16 = omega_left_hip_block_z * omega_left_hip_block_y * 2.0;
  const Scalar Omega_left_hip_block_zy = t_left_hip_block_15 + t_left_hip_block_16;
  const Scalar t_left_hip_block_17 = omega_left_hip_block_x * omega_left_hip_block_y;
  const Scalar alpha_left_hip_block_z = t_base_rx_7 + qdd[6];
  const Scalar Omega_left_hip_block_yx = t_left_hip_block_17 + alpha_left_hip_block_z;
  const Scalar Omega_left_hip_block_xy = t_left_hip_block_17 - alpha_left_hip_block_z;
  const Scalar t_left_hip_block_18 = left_hip_block_l1 * Omega_base_rx_yx;
  const Scalar t_base_rx_15 = s_base_rx * a_base_rz_y + c_base_rx * t_base_ry_2;
  const Scalar t_left_hip_block_19 = t_base_rx_15 + left_hip_block_l2 * t_base_rx_13;
  const Scalar a_left_hip_block_z = t_left_hip_block_18 + t_left_hip_block_19;
  const Scalar t_left_hip_block_20 = omega_left_hip_block_x * omega_left_hip_block_x;
  const Scalar t_left_hip_block_21 = omega_left_hip_block_z * omega_left_hip_block_z;
  const Scalar t_left_hip_block_22 = t_left_hip_block_20 + t_left_hip_block_21;
  // left_hip_fork
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * Omega_left_hip_block_zy;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * Omega_left_hip_block_xy;
  const Scalar Omega_left_hip_fork_yz = t_left_hip_fork_1 + t_left_hip_fork_2;
  const Scalar t_left_hip_fork_3 = omega_left_hip_block_y - qd[7];
  const Scalar t_left_hip_fork_4 = s_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_5 = c_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_4 + t_left_hip_fork_5;
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_3 * t_left_hip_fork_6 * 2.0;
  const Scalar t_left_hip_fork_8 = Omega_left_hip_fork_yz - t_left_hip_fork_7;
  const Scalar t_left_hip_fork_9 = c_left_hip_roll * Omega_left_hip_block_zy;
  const Scalar t_left_hip_fork_10 = s_left_hip_roll * Omega_left_hip_block_xy;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_9 - t_left_hip_fork_10;
  const Scalar t_left_hip_fork_12 = s_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_13 = c_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_12 - t_left_hip_fork_13;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_3 * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_16 = t_left_hip_fork_11 + t_left_hip_fork_15;
  const Scalar Omega_left_hip_fork_zx = t_left_hip_fork_15 + t_left_hip_fork_16;
  const Scalar t_left_hip_fork_17 = t_left_hip_fork_6 * t_left_hip_fork_14;
  const Scalar alpha_left_hip_fork_z = t_left_hip_block_12 + qdd[7];
  const Scalar Omega_left_hip_fork_yx = t_left_hip_fork_17 + alpha_left_hip_fork_z;
  const Scalar Omega_left_hip_fork_xy = t_left_hip_fork_17 - alpha_left_hip_fork_z;
  const Scalar t_left_hip_fork_18 = t_left_hip_fork_14 * t_left_hip_fork_14;
  const Scalar t_left_hip_fork_19 = t_left_hip_fork_3 * t_left_hip_fork_3;
  const Scalar t_left_hip_fork_20 = t_left_hip_fork_18 + t_left_hip_fork_19;
  const Scalar t_left_hip_fork_21 = t_left_hip_fork_18 - t_left_hip_fork_19;
  // left_thigh
  const Scalar t_left_thigh_1 = s_left_hip_pitch * Omega_left_hip_fork_xy;
  const Scalar t_left_thigh_2 = t_left_thigh_1 + c_left_hip_pitch * t_left_hip_fork_8;
  const Scalar t_left_thigh_3 = s_left_hip_pitch * t_left_hip_fork_14;
  const Scalar t_left_thigh_4 = t_left_thigh_3 - c_left_hip_pitch * t_left_hip_fork_3;
  const Scalar omega_left_thigh_z = t_left_hip_fork_6 + qd[8];
  const Scalar t_left_thigh_5 = 2.0 * omega_left_thigh_z;
  const Scalar Omega_left_thigh_zy = t_left_thigh_2 - t_left_thigh_4 * t_left_thigh_5;
  const Scalar t_left_thigh_6 = c_left_hip_pitch * Omega_left_hip_fork_xy;
  const Scalar Omega_left_thigh_xz = t_left_thigh_6 - s_left_hip_pitch * t_left_hip_fork_8;
  const Scalar t_left_thigh_7 = s_left_hip_pitch * t_left_hip_fork_3;
  const Scalar omega_left_thigh_x = t_left_thigh_7 + c_left_hip_pitch * t_left_hip_fork_14;
  const Scalar t_left_thigh_8 = Omega_left_thigh_xz - t_left_thigh_5 * omega_left_thigh_x;
  const Scalar t_left_hip_fork_22 = c_left_hip_roll * a_left_hip_block_z;
  const Scalar a_left_hip_fork_x = t_left_hip_fork_22 - s_left_hip_roll * a_left_hip_block_x;
  const Scalar t_left_thigh_9 = a_left_hip_fork_x - left_hip_fork_l1 * t_left_hip_fork_11;
  const Scalar t_left_thigh_10 = a_left_hip_block_y + left_hip_fork_l1 * t_left_hip_block_22;
  const Scalar alpha_left_thigh_z = t_left_hip_fork_16 + qdd[8];
  const Scalar t_left_thigh_11 = t_left_thigh_4 * omega_left_thigh_x;
  const Scalar Omega_left_thigh_yx = alpha_left_thigh_z - t_left_thigh_11;
  const Scalar t_left_thigh_12 = alpha_left_thigh_z + t_left_thigh_11;
  const Scalar t_left_thigh_13 = omega_left_thigh_x * omega_left_thigh_x;
  const Scalar t_left_thigh_14 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_15 = t_left_thigh_13 - t_left_thigh_14;
  const Scalar t_left_hip_fork_23 = c_left_hip_roll * a_left_hip_block_x;
  const Scalar t_left_hip_fork_24 = t_left_hip_fork_23 + s_left_hip_roll * a_left_hip_block_z;
  const Scalar a_left_thigh_z = t_left_hip_fork_24 - left_hip_fork_l1 * Omega_left_hip_fork_yz;
  // left_shank
  const Scalar a_left_shank_z = a_left_thigh_z - left_shank_l1 * t_left_thigh_8;
  const Scalar t_left_shank_1 = s_left_knee * Omega_left_thigh_xz;
  const Scalar t_left_shank_2 = t_left_shank_1 + c_left_knee * t_left_thigh_2;
  const Scalar t_left_shank_3 = s_left_knee * omega_left_thigh_x;
  const Scalar t_left_shank_4 = t_left_shank_3 + c_left_knee * t_left_thigh_4;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[9];
  const Scalar t_left_shank_5 = 2.0 * omega_left_shank_z;
  const Scalar Omega_left_shank_zy = t_left_shank_2 - t_left_shank_4 * t_left_shank_5;
  const Scalar t_left_shank_6 = c_left_knee * Omega_left_thigh_xz;
  const Scalar Omega_left_shank_xz = t_left_shank_6 - s_left_knee * t_left_thigh_2;
  const Scalar t_left_shank_7 = c_left_knee * omega_left_thigh_x;
  const Scalar omega_left_shank_x = t_left_shank_7 - s_left_knee * t_left_thigh_4;
  const Scalar t_left_shank_8 = Omega_left_shank_xz - t_left_shank_5 * omega_left_shank_x;
  const Scalar t_left_thigh_16 = s_left_hip_pitch * t_left_thigh_9;
  const Scalar t_left_shank_9 = left_shank_l1 * Omega_left_thigh_yx + t_left_thigh_16;
  const Scalar t_left_shank_10 = t_left_shank_9 + c_left_hip_pitch * t_left_thigh_10;
  // left_thigh
  const Scalar t_left_thigh_17 = s_left_hip_pitch * t_left_thigh_10;
  const Scalar a_left_thigh_x = t_left_thigh_17 - c_left_hip_pitch * t_left_thigh_9;
  const Scalar t_left_thigh_18 = t_left_hip_fork_20 - t_left_thigh_15;
  // left_shank
  const Scalar t_left_shank_11 = a_left_thigh_x - left_shank_l1 * t_left_thigh_18;
  const Scalar a_left_shank_x = c_left_knee * t_left_shank_11 + s_left_knee * t_left_shank_10;
  const Scalar alpha_left_shank_z = alpha_left_thigh_z + qdd[9];
  const Scalar t_left_shank_12 = t_left_shank_4 * omega_left_shank_x;
  const Scalar t_left_shank_13 = alpha_left_shank_z + t_left_shank_12;
  const Scalar Omega_left_shank_yx = alpha_left_shank_z - t_left_shank_12;
  const Scalar t_left_shank_14 = omega_left_shank_x * omega_left_shank_x;
  const Scalar t_left_shank_15 = omega_left_shank_z * omega_left_shank_z;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_1 = s_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_2 = c_left_ankle_pitch * t_left_shank_2;
  const Scalar t_left_ankle_cross_3 = t_left_ankle_cross_1 + t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_4 = s_left_ankle_pitch * omega_left_shank_x;
  const Scalar t_left_ankle_cross_5 = c_left_ankle_pitch * t_left_shank_4;
  const Scalar t_left_ankle_cross_6 = t_left_ankle_cross_5 + t_left_ankle_cross_4;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[10];
  const Scalar t_left_ankle_cross_7 = 2.0 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_8 = t_left_ankle_cross_6 * t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_3 - t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_10 = c_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_11 = s_left_ankle_pitch * t_left_shank_2;
  const Scalar t_left_ankle_cross_12 = t_left_ankle_cross_10 - t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_13 = c_left_ankle_pitch * omega_left_shank_x;
  const Scalar t_left_ankle_cross_14 = s_left_ankle_pitch * t_left_shank_4;
  const Scalar omega_left_ankle_cross_x = t_left_ankle_cross_13 - t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_15 = t_left_ankle_cross_7 * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_16 = t_left_ankle_cross_12 - t_left_ankle_cross_15;
  const Scalar t_left_shank_16 = t_left_shank_14 - t_left_shank_15;
  const Scalar t_left_shank_17 = t_left_hip_fork_20 - t_left_shank_16;
  const Scalar t_left_ankle_cross_17 = a_left_shank_x - left_ankle_cross_l1 * t_left_shank_17;
  const Scalar t_left_shank_18 = s_left_knee * t_left_shank_11;
  const Scalar t_left_shank_19 = t_left_shank_18 - c_left_knee * t_left_shank_10;
  const Scalar t_left_ankle_cross_18 = left_ankle_cross_l1 * Omega_left_shank_yx;
  const Scalar t_left_ankle_cross_19 = t_left_shank_19 - t_left_ankle_cross_18;
  const Scalar a_left_ankle_cross_z = a_left_shank_z - left_ankle_cross_l1 * t_left_shank_8;
  const Scalar t_left_ankle_cross_20 = t_left_ankle_cross_6 * omega_left_ankle_cross_x;
  const Scalar alpha_left_ankle_cross_z = alpha_left_shank_z + qdd[10];
  const Scalar Omega_left_foot_xz = t_left_ankle_cross_20 + alpha_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_21 = t_left_ankle_cross_20 - alpha_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_22 = omega_left_ankle_cross_x * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_23 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_24 = t_left_ankle_cross_22 - t_left_ankle_cross_23;
  const Scalar t_left_ankle_cross_25 = t_left_ankle_cross_22 + t_left_ankle_cross_23;
  // left_foot
  const Scalar t_left_foot_1 = a_left_ankle_cross_z - left_hip_fork_l1 * t_left_ankle_cross_16;
  const Scalar a_left_foot_y = t_left_foot_1 - left_hip_fork_l3 * t_left_hip_fork_20;
  const Scalar omega_left_foot_z = t_left_ankle_cross_6 + qd[11];
  const Scalar t_left_foot_2 = 2.0 * omega_left_foot_z;
  const Scalar t_left_foot_3 = omega_left_ankle_cross_z * t_left_foot_2;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_9 + t_left_foot_3;
  const Scalar Omega_left_foot_xy = t_left_ankle_cross_12 - qdd[11];
  const Scalar t_left_foot_4 = t_left_ankle_cross_16 - qdd[11];
  // left_ankle_cross
  const Scalar t_left_ankle_cross_26 = t_left_hip_fork_20 - t_left_ankle_cross_24;
  const Scalar t_left_ankle_cross_27 = c_left_ankle_pitch * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_28 = s_left_ankle_pitch * t_left_ankle_cross_19;
  const Scalar a_left_ankle_cross_x = t_left_ankle_cross_27 - t_left_ankle_cross_28;
  const Scalar t_left_foot_5 = a_left_ankle_cross_x - left_hip_fork_l1 * t_left_ankle_cross_26;
  const Scalar a_left_foot_x = t_left_foot_5 + left_hip_fork_l3 * t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_29 = c_left_ankle_pitch * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_30 = s_left_ankle_pitch * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_31 = t_left_ankle_cross_29 + t_left_ankle_cross_30;
  // left_foot
  const Scalar t_left_foot_6 = left_hip_fork_l1 * t_left_ankle_cross_21;
  const Scalar t_left_foot_7 = t_left_ankle_cross_31 + t_left_foot_6;
  const Scalar a_left_foot_z = t_left_foot_7 + left_hip_fork_l3 * t_left_ankle_cross_3;
  const Scalar t_left_foot_8 = Omega_left_foot_xz - omega_left_ankle_cross_x * t_left_foot_2;
  const Scalar t_left_foot_9 = omega_left_foot_z * omega_left_foot_z;
  const Scalar t_left_foot_10 = left_foot_k1 + q[11];
  const auto [s_left_foot, c_left_foot] = sine_cosine(t_left_foot_10);
  const Scalar t_left_foot_11 = left_foot_I3 * c_left_foot + left_foot_I4 * s_left_foot;
  const Scalar t_left_foot_12 = s_left_foot * t_left_foot_11;
  const Scalar t_left_foot_13 = left_foot_I13 + t_left_foot_12;
  const Scalar t_left_foot_14 = left_foot_I14 - c_left_foot * t_left_foot_11;
  const Scalar t_left_foot_15 = left_foot_I2 * c_left_foot - left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_16 = left_foot_I1 * c_left_foot + left_foot_I2 * s_left_foot;
  const Scalar t_left_foot_17 = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_18 = left_foot_I12 - t_left_foot_12;
  const Scalar t_left_foot_19 = left_foot_h1 * c_left_foot;
  const Scalar t_left_foot_20 = Omega_left_foot_xy * t_left_foot_13;
  const Scalar t_left_foot_21 = t_left_foot_4 * t_left_foot_18 + t_left_foot_20;
  const Scalar t_left_foot_22 = t_left_foot_21 + a_left_foot_x * t_left_foot_17;
  const Scalar t_left_foot_23 = t_left_foot_22 - a_left_foot_y * t_left_foot_19;
  const Scalar t_left_foot_24 = t_left_foot_23 - t_left_ankle_cross_24 * t_left_foot_14;
  const Scalar t_left_foot_25 = t_left_foot_24 + Omega_left_foot_xz * t_left_foot_16;
  const Scalar t_left_foot_26 = t_left_foot_25 + t_left_ankle_cross_9 * t_left_foot_15;
  tau[11] = -t_left_foot_26;
  const Scalar t_left_foot_27 = left_ankle_cross_m1 * a_left_foot_y;
  const Scalar t_left_foot_28 = t_left_foot_17 * (t_left_ankle_cross_22 + t_left_foot_9);
  const Scalar t_left_foot_29 = t_left_foot_27 - t_left_foot_4 * t_left_foot_19;
  const Scalar F_left_foot_y = t_left_foot_29 - t_left_foot_28;
  const Scalar t_left_foot_30 = Omega_left_foot_zy * t_left_foot_17;
  const Scalar t_left_foot_31 = left_ankle_cross_m1 * a_left_foot_z + t_left_foot_30;
  const Scalar F_left_foot_z = t_left_foot_31 - t_left_foot_8 * t_left_foot_19;
  // right_hip_block
  const Scalar t_right_hip_block_1 = t_left_hip_block_4 + t_left_hip_block_5;
  const Scalar t_right_hip_block_2 = t_left_hip_block_1 - t_left_hip_block_2;
  const Scalar t_right_hip_block_3 = c_right_hip_yaw * t_right_hip_block_1;
  const Scalar t_right_hip_block_4 = s_right_hip_yaw * t_right_hip_block_2;
  const Scalar a_right_hip_block_x = t_right_hip_block_3 - t_right_hip_block_4;
  const Scalar t_right_hip_block_5 = s_right_hip_yaw * t_right_hip_block_1;
  const Scalar t_right_hip_block_6 = c_right_hip_yaw * t_right_hip_block_2;
  const Scalar a_right_hip_fork_z = t_right_hip_block_5 + t_right_hip_block_6;
  const Scalar t_right_hip_block_7 = c_right_hip_yaw * t_base_rx_2;
  const Scalar omega_right_hip_block_y = t_right_hip_block_7 - s_right_hip_yaw * t_base_rx_4;
  const Scalar omega_right_hip_block_z = t_base_rx_1 + qd[12];
  const Scalar t_right_hip_block_8 = s_right_hip_yaw * Omega_base_rx_xy;
  const Scalar t_right_hip_block_9 = t_right_hip_block_8 + c_right_hip_yaw * t_base_rx_3;
  const Scalar t_right_hip_block_10 = omega_right_hip_block_y * omega_right_hip_block_z * 2.0;
  const Scalar Omega_right_hip_block_zy = t_right_hip_block_9 + t_right_hip_block_10;
  const Scalar t_right_hip_block_11 = s_right_hip_yaw * t_base_rx_2;
  const Scalar omega_right_hip_block_x = t_right_hip_block_11 + c_right_hip_yaw * t_base_rx_4;
  const Scalar t_right_hip_block_12 = omega_right_hip_block_z * omega_right_hip_block_x;
  const Scalar t_right_hip_block_13 = c_right_hip_yaw * Omega_base_rx_xy;
  const Scalar Omega_right_hip_block_xz = t_right_hip_block_13 - s_right_hip_yaw * t_base_rx_3;
  const Scalar t_right_hip_block_14 = t_right_hip_block_12 - Omega_right_hip_block_xz;
  const Scalar Omega_right_hip_block_zx = t_right_hip_block_12 + t_right_hip_block_14;
  const Scalar t_right_hip_block_15 = omega_right_hip_block_y * omega_right_hip_block_x;
  const Scalar alpha_right_hip_block_z = t_base_rx_7 + qdd[12];
  const Scalar Omega_right_hip_block_xy = t_right_hip_block_15 - alpha_right_hip_block_z;
  const Scalar Omega_right_hip_block_yx = t_right_hip_block_15 + alpha_right_hip_block_z;
  const Scalar t_right_hip_block_16 = t_left_hip_block_18 - t_left_hip_block_19;
  const Scalar t_right_hip_block_17 = omega_right_hip_block_x * omega_right_hip_block_x;
  const Scalar t_right_hip_block_18 = omega_right_hip_block_z * omega_right_hip_block_z;
  const Scalar t_right_hip_block_19 = t_right_hip_block_17 + t_right_hip_block_18;
  // right_hip_fork
  const Scalar t_right_hip_fork_1 = s_right_hip_roll * Omega_right_hip_block_zy;
  const Scalar t_right_hip_fork_2 = c_right_hip_roll * Omega_right_hip_block_xy;
  const Scalar Omega_right_hip_fork_yz = t_right_hip_fork_1 + t_right_hip_fork_2;
  const Scalar t_right_hip_fork_3 = c_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_4 = s_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_3 + t_right_hip_fork_4;
  const Scalar t_right_hip_fork_6 = omega_right_hip_block_y - qd[13];
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_5 * t_right_hip_fork_6 * 2.0;
  const Scalar t_right_hip_fork_8 = Omega_right_hip_fork_yz - t_right_hip_fork_7;
  const Scalar t_right_hip_fork_9 = s_right_hip_roll * Omega_right_hip_block_xy;
  const Scalar t_right_hip_fork_10 = c_right_hip_roll * Omega_right_hip_block_zy;
  const Scalar Omega_right_hip_fork_xz = t_right_hip_fork_9 - t_right_hip_fork_10;
  const Scalar t_right_hip_fork_11 = s_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_12 = c_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_11 - t_right_hip_fork_12;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_6 * t_right_hip_fork_13;
  const Scalar alpha_right_hip_fork_y = Omega_right_hip_fork_xz - t_right_hip_fork_14;
  const Scalar t_right_hip_fork_15 = t_right_hip_fork_5 * t_right_hip_fork_13;
  const Scalar alpha_right_hip_fork_z = t_right_hip_block_14 + qdd[13];
  const Scalar Omega_right_hip_fork_yx = t_right_hip_fork_15 + alpha_right_hip_fork_z;
  const Scalar Omega_right_hip_fork_xy = t_right_hip_fork_15 - alpha_right_hip_fork_z;
  const Scalar t_right_hip_fork_16 = t_right_hip_fork_13 * t_right_hip_fork_13;
  const Scalar t_right_hip_fork_17 = t_right_hip_fork_6 * t_right_hip_fork_6;
  const Scalar t_right_hip_fork_18 = t_right_hip_fork_16 + t_right_hip_fork_17;
  // right_thigh
  const Scalar t_right_thigh_1 = s_right_hip_pitch * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_2 = t_right_thigh_1 + c_right_hip_pitch * t_right_hip_fork_8;
  const Scalar t_right_thigh_3 = s_right_hip_pitch * t_right_hip_fork_13;
  const Scalar t_right_thigh_4 = t_right_thigh_3 - c_right_hip_pitch * t_right_hip_fork_6;
  const Scalar omega_right_thigh_z = t_right_hip_fork_5 + qd[14];
  const Scalar t_right_thigh_5 = 2.0 * omega_right_thigh_z;
  const Scalar Omega_right_thigh_zy = t_right_thigh_2 - t_right_thigh_4 * t_right_thigh_5;
  const Scalar t_right_thigh_6 = c_right_hip_pitch * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_7 = s_right_hip_pitch * t_right_hip_fork_8;
  const Scalar Omega_right_thigh_xz = t_right_thigh_6 - t_right_thigh_7;
  const Scalar t_right_thigh_8 = c_right_hip_pitch * t_right_hip_fork_13;
  const Scalar omega_right_thigh_x = t_right_thigh_8 + s_right_hip_pitch * t_right_hip_fork_6;
  const Scalar t_right_thigh_9 = Omega_right_thigh_xz - t_right_thigh_5 * omega_right_thigh_x;
  // right_hip_fork
  const Scalar t_right_hip_fork_19 = c_right_hip_roll * t_right_hip_block_16;
  const Scalar t_right_hip_fork_20 = s_right_hip_roll * a_right_hip_block_x;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_19 + t_right_hip_fork_20;
  // right_thigh
  const Scalar t_right_thigh_10 = a_right_hip_fork_z - left_hip_fork_l1 * t_right_hip_block_19;
  const Scalar t_right_thigh_11 = t_right_thigh_4 * omega_right_thigh_x;
  const Scalar t_right_thigh_12 = alpha_right_hip_fork_y - qdd[14];
  const Scalar t_right_thigh_13 = t_right_thigh_11 - t_right_thigh_12;
  const Scalar t_right_thigh_14 = t_right_thigh_11 + t_right_thigh_12;
  const Scalar t_right_thigh_15 = omega_right_thigh_x * omega_right_thigh_x;
  const Scalar t_right_thigh_16 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_17 = t_right_thigh_15 - t_right_thigh_16;
  // right_shank
  const Scalar t_right_shank_1 = s_right_knee * Omega_right_thigh_xz;
  const Scalar t_right_shank_2 = t_right_shank_1 + c_right_knee * t_right_thigh_2;
  const Scalar t_right_shank_3 = s_right_knee * omega_right_thigh_x;
  const Scalar t_right_shank_4 = t_right_shank_3 + c_right_knee * t_right_thigh_4;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[15];
  const Scalar t_right_shank_5 = 2.0 * omega_right_shank_z;
  const Scalar Omega_right_shank_zy = t_right_shank_2 - t_right_shank_4 * t_right_shank_5;
  const Scalar t_right_hip_fork_22 = s_right_hip_roll * t_right_hip_block_16;
  const Scalar a_right_hip_fork_y = t_right_hip_fork_22 - c_right_hip_roll * a_right_hip_block_x;
  const Scalar t_right_thigh_18 = a_right_hip_fork_y + left_hip_fork_l1 * Omega_right_hip_fork_yz;
  const Scalar t_right_shank_6 = t_right_thigh_18 + left_shank_l1 * t_right_thigh_9;
  const Scalar t_right_shank_7 = c_right_knee * Omega_right_thigh_xz;
  const Scalar t_right_shank_8 = s_right_knee * t_right_thigh_2 - t_right_shank_7;
  const Scalar t_right_shank_9 = c_right_knee * omega_right_thigh_x;
  const Scalar omega_right_shank_x = t_right_shank_9 - s_right_knee * t_right_thigh_4;
  const Scalar Omega_right_shank_zx = t_right_shank_8 + t_right_shank_5 * omega_right_shank_x;
  // right_thigh
  const Scalar t_right_thigh_19 = left_hip_fork_l1 * Omega_right_hip_fork_xz;
  const Scalar t_right_thigh_20 = t_right_hip_fork_21 - t_right_thigh_19;
  const Scalar t_right_thigh_21 = s_right_hip_pitch * t_right_thigh_20;
  const Scalar t_right_shank_10 = left_shank_l1 * t_right_thigh_14 + t_right_thigh_21;
  const Scalar t_right_shank_11 = t_right_shank_10 + c_right_hip_pitch * t_right_thigh_10;
  const Scalar t_right_thigh_22 = c_right_hip_pitch * t_right_thigh_20;
  const Scalar a_right_thigh_x = t_right_thigh_22 - s_right_hip_pitch * t_right_thigh_10;
  // right_shank
  const Scalar t_right_shank_12 = left_shank_l1 * (t_right_hip_fork_18 - t_right_thigh_17);
  const Scalar t_right_shank_13 = a_right_thigh_x - t_right_shank_12;
  const Scalar t_right_shank_14 = s_right_knee * t_right_shank_11;
  const Scalar t_right_shank_15 = t_right_shank_14 - c_right_knee * t_right_shank_13;
  const Scalar t_right_shank_16 = t_right_shank_4 * omega_right_shank_x;
  const Scalar t_right_shank_17 = t_right_thigh_12 - qdd[15];
  const Scalar t_right_shank_18 = t_right_shank_16 + t_right_shank_17;
  const Scalar t_right_shank_19 = t_right_shank_16 - t_right_shank_17;
  const Scalar t_right_shank_20 = omega_right_shank_x * omega_right_shank_x;
  const Scalar t_right_shank_21 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_22 = t_right_shank_20 - t_right_shank_21;
  const Scalar t_right_shank_23 = s_right_knee * t_right_shank_13;
  const Scalar t_right_shank_24 = t_right_shank_23 + c_right_knee * t_right_shank_11;
  const Scalar t_right_shank_25 = t_right_hip_fork_18 - t_right_shank_22;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_l1 * t_right_shank_25;
  const Scalar t_righ_ankl_cros_2 = t_right_shank_15 + t_righ_ankl_cros_1;
  const Scalar t_righ_ankl_cros_3 = left_ankle_cross_l1 * t_right_shank_18;
  const Scalar t_righ_ankl_cros_4 = t_right_shank_24 + t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_5 = s_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_6 = c_right_ankle_pitch * t_righ_ankl_cros_4;
  const Scalar a_righ_ankl_cros_y = t_righ_ankl_cros_5 - t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_7 = c_right_ankle_pitch * t_right_shank_2;
  const Scalar t_righ_ankl_cros_8 = s_right_ankle_pitch * t_right_shank_8;
  const Scalar t_righ_ankl_cros_9 = t_righ_ankl_cros_7 - t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_10 = s_right_ankle_pitch * omega_right_shank_x;
  const Scalar t_righ_ankl_cros_11 = c_right_ankle_pitch * t_right_shank_4;
  const Scalar t_righ_ankl_cros_12 = t_righ_ankl_cros_11 + t_righ_ankl_cros_10;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[16];
  const Scalar t_righ_ankl_cros_13 = 2.0 * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_14 = t_righ_ankl_cros_12 * t_righ_ankl_cros_13;
  const Scalar Omega_righ_ankl_cros_zy = t_righ_ankl_cros_9 - t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_15 = left_ankle_cross_l1 * Omega_right_shank_zx;
  const Scalar t_righ_ankl_cros_16 = t_right_shank_6 - t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_17 = c_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_18 = s_right_ankle_pitch * t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_19 = t_righ_ankl_cros_17 + t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_20 = s_right_ankle_pitch * t_right_shank_2;
  const Scalar t_righ_ankl_cros_21 = c_right_ankle_pitch * t_right_shank_8;
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_20 + t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_23 = c_right_ankle_pitch * omega_right_shank_x;
  const Scalar t_righ_ankl_cros_24 = s_right_ankle_pitch * t_right_shank_4;
  const Scalar omega_righ_ankl_cros_x = t_righ_ankl_cros_23 - t_righ_ankl_cros_24;
  const Scalar t_righ_ankl_cros_25 = 2.0 * omega_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_26 = omega_righ_ankl_cros_z * t_righ_ankl_cros_25;
  const Scalar Omega_righ_ankl_cros_zx = t_righ_ankl_cros_22 + t_righ_ankl_cros_26;
  const Scalar t_righ_ankl_cros_27 = t_righ_ankl_cros_12 * omega_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_28 = t_right_shank_17 - qdd[16];
  const Scalar t_righ_ankl_cros_29 = t_righ_ankl_cros_27 + t_righ_ankl_cros_28;
  const Scalar Omega_right_foot_xz = t_righ_ankl_cros_27 - t_righ_ankl_cros_28;
  const Scalar t_righ_ankl_cros_30 = omega_righ_ankl_cros_x * omega_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_31 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_32 = t_righ_ankl_cros_30 - t_righ_ankl_cros_31;
  const Scalar t_righ_ankl_cros_33 = t_righ_ankl_cros_30 + t_righ_ankl_cros_31;
  // right_foot
  const Scalar t_right_foot_1 = t_righ_ankl_cros_16 - left_hip_fork_l3 * t_right_hip_fork_18;
  const Scalar t_right_foot_2 = t_right_foot_1 - left_hip_fork_l1 * Omega_righ_ankl_cros_zx;
  const Scalar omega_right_foot_z = t_righ_ankl_cros_12 + qd[17];
  const Scalar t_right_foot_3 = t_righ_ankl_cros_13 * omega_right_foot_z;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy + t_right_foot_3;
  const Scalar t_right_foot_4 = a_righ_ankl_cros_y - left_hip_fork_l1 * t_righ_ankl_cros_29;
  const Scalar t_right_foot_5 = t_right_foot_4 + left_hip_fork_l3 * t_righ_ankl_cros_9;
  const Scalar t_right_foot_6 = t_righ_ankl_cros_22 + qdd[17];
  const Scalar Omega_right_foot_yx = Omega_righ_ankl_cros_zx + qdd[17];
  const Scalar t_righ_ankl_cros_34 = t_right_hip_fork_18 - t_righ_ankl_cros_32;
  const Scalar t_right_foot_7 = t_righ_ankl_cros_19 - left_hip_fork_l3 * t_righ_ankl_cros_22;
  const Scalar t_right_foot_8 = t_right_foot_7 + left_hip_fork_l1 * t_righ_ankl_cros_34;
  const Scalar t_right_foot_9 = Omega_right_foot_xz - t_righ_ankl_cros_25 * omega_right_foot_z;
  const Scalar t_right_foot_10 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_11 = left_foot_k1 - q[17];
  const auto [s_right_foot, c_right_foot] = sine_cosine(t_right_foot_11);
  const Scalar t_right_foot_12 = left_foot_I3 * c_right_foot + left_foot_I4 * s_right_foot;
  const Scalar t_right_foot_13 = s_right_foot * t_right_foot_12;
  const Scalar t_right_foot_14 = left_foot_I12 - t_right_foot_13;
  const Scalar t_right_foot_15 = left_foot_I2 * c_right_foot - left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_16 = left_foot_I1 * c_right_foot + left_foot_I2 * s_right_foot;
  const Scalar t_right_foot_17 = left_foot_I14 - c_right_foot * t_right_foot_12;
  const Scalar t_right_foot_18 = left_foot_h1 * c_right_foot;
  const Scalar t_right_foot_19 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_20 = left_foot_I13 + t_right_foot_13;
  const Scalar t_right_foot_21 = t_right_foot_2 * t_right_foot_18;
  const Scalar t_right_foot_22 = t_right_foot_21 + t_right_foot_8 * t_right_foot_19;
  const Scalar t_right_foot_23 = t_right_foot_22 + t_righ_ankl_cros_32 * t_right_foot_17;
  const Scalar t_right_foot_24 = t_right_foot_23 - Omega_right_foot_yx * t_right_foot_14;
  const Scalar t_right_foot_25 = t_right_foot_24 + Omega_righ_ankl_cros_zy * t_right_foot_15;
  const Scalar t_right_foot_26 = t_right_foot_25 - t_right_foot_6 * t_right_foot_20;
  const Scalar t_right_foot_27 = t_right_foot_26 - Omega_right_foot_xz * t_right_foot_16;
  tau[17] = -t_right_foot_27;
  const Scalar t_right_foot_28 = t_righ_ankl_cros_30 + t_right_foot_10;
  const Scalar t_right_foot_29 = left_ankle_cross_m1 * t_right_foot_5;
  const Scalar t_right_foot_30 = t_right_foot_29 + Omega_right_foot_zy * t_right_foot_19;
  const Scalar t_right_foot_31 = t_right_foot_30 + t_right_foot_9 * t_right_foot_18;
  const Scalar t_right_foot_32 = t_righ_ankl_cros_30 - t_right_foot_10;
  const Scalar t_right_foot_33 = left_ankle_cross_m1 * t_right_foot_2;
  const Scalar t_right_foot_34 = t_right_foot_33 - t_right_foot_19 * t_right_foot_28;
  const Scalar t_right_foot_35 = t_right_foot_34 - Omega_right_foot_yx * t_right_foot_18;
  const Scalar t_right_foot_36 = left_ankle_cross_m1 * t_right_foot_8;
  const Scalar t_right_foot_37 = t_right_foot_18 * (t_righ_ankl_cros_33 - t_right_foot_32);
  const Scalar t_right_foot_38 = t_right_foot_36 - t_right_foot_6 * t_right_foot_19;
  const Scalar t_right_foot_39 = t_right_foot_38 + t_right_foot_37;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_35 = t_right_foot_27 + left_hip_fork_l3 * t_right_foot_39;
  const Scalar t_righ_ankl_cros_36 = left_ankle_cross_I8 * t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_37 = t_righ_ankl_cros_35 - t_righ_ankl_cros_36;
  const Scalar t_righ_ankl_cros_38 = t_righ_ankl_cros_37 + left_hip_fork_l1 * t_right_foot_35;
  const Scalar t_righ_ankl_cros_39 = left_ankle_cross_I9 * Omega_righ_ankl_cros_zx;
  const Scalar t_righ_ankl_cros_40 = t_righ_ankl_cros_38 - t_righ_ankl_cros_39;
  const Scalar t_righ_ankl_cros_41 = left_ankle_cross_I1 * Omega_right_foot_xz;
  const Scalar t_righ_ankl_cros_42 = t_righ_ankl_cros_40 - t_righ_ankl_cros_41;
  const Scalar t_righ_ankl_cros_43 = left_ankle_cross_I6 * Omega_righ_ankl_cros_zy;
  const Scalar M_righ_ankl_cros_y = t_righ_ankl_cros_42 + t_righ_ankl_cros_43;
  const Scalar t_righ_ankl_cros_44 = t_right_hip_fork_18 - t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_45 = left_ankle_cross_h2 * t_righ_ankl_cros_16;
  const Scalar t_righ_ankl_cros_46 = left_hip_fork_l3 * t_right_foot_31 + t_righ_ankl_cros_45;
  const Scalar t_right_foot_40 = t_right_foot_5 * t_right_foot_19;
  const Scalar t_righ_ankl_cros_47 = left_ankle_cross_I8 * t_righ_ankl_cros_29;
  const Scalar t_righ_ankl_cros_48 = t_righ_ankl_cros_46 + t_right_foot_40;
  const Scalar t_righ_ankl_cros_49 = t_righ_ankl_cros_48 - t_righ_ankl_cros_47;
  const Scalar t_right_foot_41 = t_right_foot_9 * t_right_foot_17;
  const Scalar t_right_foot_42 = t_right_foot_16 * (t_righ_ankl_cros_33 - t_right_foot_28);
  const Scalar t_righ_ankl_cros_50 = t_righ_ankl_cros_49 - t_right_foot_41;
  const Scalar t_righ_ankl_cros_51 = t_righ_ankl_cros_50 + t_right_foot_42;
  const Scalar t_right_foot_43 = Omega_right_foot_yx * t_right_foot_15;
  const Scalar t_righ_ankl_cros_52 = left_ankle_cross_I1 * t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_53 = t_righ_ankl_cros_51 - t_right_foot_43;
  const Scalar t_righ_ankl_cros_54 = t_righ_ankl_cros_53 - t_righ_ankl_cros_52;
  const Scalar t_righ_ankl_cros_55 = left_ankle_cross_I7 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_56 = t_righ_ankl_cros_54 + t_righ_ankl_cros_55;
  const Scalar t_right_foot_44 = Omega_right_foot_zy * t_right_foot_20;
  const Scalar t_righ_ankl_cros_57 = left_ankle_cross_I6 * Omega_righ_ankl_cros_zx;
  const Scalar t_righ_ankl_cros_58 = t_righ_ankl_cros_56 + t_right_foot_44;
  const Scalar M_righ_ankl_cros_x = t_righ_ankl_cros_58 - t_righ_ankl_cros_57;
  const Scalar t_righ_ankl_cros_59 = left_ankle_cross_h2 * t_righ_ankl_cros_19;
  const Scalar t_righ_ankl_cros_60 = t_righ_ankl_cros_32 - t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_61 = left_hip_fork_l1 * t_right_foot_31 - t_righ_ankl_cros_59;
  const Scalar t_righ_ankl_cros_62 = left_ankle_cross_I6 * t_righ_ankl_cros_60;
  const Scalar t_righ_ankl_cros_63 = t_righ_ankl_cros_61 + t_righ_ankl_cros_62;
  const Scalar t_right_foot_45 = t_right_foot_15 * t_right_foot_32;
  const Scalar t_righ_ankl_cros_64 = t_righ_ankl_cros_63 + t_right_foot_45;
  const Scalar t_righ_ankl_cros_65 = left_ankle_cross_I7 * Omega_right_foot_xz;
  const Scalar t_righ_ankl_cros_66 = t_righ_ankl_cros_64 + t_righ_ankl_cros_65;
  const Scalar t_right_foot_46 = t_right_foot_6 * t_right_foot_16;
  const Scalar t_righ_ankl_cros_67 = t_righ_ankl_cros_66 + t_right_foot_46;
  const Scalar t_right_foot_47 = Omega_right_foot_zy * t_right_foot_17;
  const Scalar t_righ_ankl_cros_68 = left_ankle_cross_I8 * t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_69 = t_righ_ankl_cros_67 - t_right_foot_47;
  const Scalar t_righ_ankl_cros_70 = t_righ_ankl_cros_69 + t_righ_ankl_cros_68;
  const Scalar t_right_foot_48 = t_right_foot_5 * t_right_foot_18;
  const Scalar t_righ_ankl_cros_71 = left_ankle_cross_I9 * t_righ_ankl_cros_29;
  const Scalar t_righ_ankl_cros_72 = t_righ_ankl_cros_70 + t_right_foot_48;
  const Scalar t_righ_ankl_cros_73 = t_righ_ankl_cros_72 - t_righ_ankl_cros_71;
  const Scalar t_righ_ankl_cros_74 = left_ankle_cross_I1 * t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_75 = t_righ_ankl_cros_73 + t_righ_ankl_cros_74;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_75 + t_right_foot_9 * t_right_foot_14;
  tau[16] = M_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_76 = t_right_foot_31 + left_shank_m1 * a_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_77 = left_ankle_cross_h2 * t_righ_ankl_cros_33;
  const Scalar F_righ_ankl_cros_y = t_righ_ankl_cros_76 + t_righ_ankl_cros_77;
  const Scalar t_righ_ankl_cros_78 = left_ankle_cross_h2 * Omega_righ_ankl_cros_zy;
  // right_foot
  const Scalar t_right_foot_49 = t_right_foot_35 + t_righ_ankl_cros_78;
  const Scalar t_right_foot_50 = t_right_foot_49 + left_shank_m1 * t_righ_ankl_cros_16;
  const Scalar t_right_foot_51 = t_right_foot_39 + left_shank_m1 * t_righ_ankl_cros_19;
  const Scalar t_right_foot_52 = t_right_foot_51 - left_ankle_cross_h2 * Omega_right_foot_xz;
  const Scalar t_right_shank_26 = t_right_shank_20 + t_right_shank_21;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_79 = c_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_80 = s_right_ankle_pitch * t_right_foot_52;
  const Scalar t_righ_ankl_cros_81 = t_righ_ankl_cros_79 - t_righ_ankl_cros_80;
  // right_shank
  const Scalar t_right_shank_27 = M_righ_ankl_cros_z - left_shank_I3 * t_right_shank_8;
  const Scalar t_right_shank_28 = t_right_shank_27 + left_shank_h1 * t_right_shank_15;
  const Scalar t_right_shank_29 = t_right_shank_28 + left_shank_I12 * t_right_shank_16;
  const Scalar t_righ_ankl_cros_82 = left_ankle_cross_l1 * t_righ_ankl_cros_81;
  const Scalar t_right_shank_30 = t_right_shank_29 + t_righ_ankl_cros_82;
  const Scalar t_right_shank_31 = t_right_shank_30 + left_shank_I13 * t_right_shank_17;
  const Scalar t_right_shank_32 = left_shank_I7 * (t_right_shank_25 - t_right_shank_26);
  const Scalar t_right_shank_33 = t_right_shank_31 + left_shank_I9 * t_right_shank_2;
  const Scalar M_right_shank_z = t_right_shank_33 + t_right_shank_32;
  tau[15] = M_right_shank_z;
  const Scalar t_right_shank_34 = t_righ_ankl_cros_81 - left_shank_h1 * t_right_shank_26;
  const Scalar F_right_shank_y = t_right_shank_34 - left_thigh_m1 * t_right_shank_24;
  const Scalar t_right_shank_35 = left_thigh_m1 * t_right_shank_15;
  const Scalar t_right_shank_36 = t_right_shank_35 + left_shank_h1 * t_right_shank_19;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_83 = t_right_shank_36 + c_right_ankle_pitch * t_right_foot_52;
  const Scalar t_righ_ankl_cros_84 = s_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_85 = t_righ_ankl_cros_83 + t_righ_ankl_cros_84;
  const Scalar t_righ_ankl_cros_86 = t_right_foot_50 - left_shank_h1 * Omega_right_shank_zy;
  const Scalar t_righ_ankl_cros_87 = t_righ_ankl_cros_86 + left_thigh_m1 * t_right_shank_6;
  const Scalar t_righ_ankl_cros_88 = c_right_ankle_pitch * M_righ_ankl_cros_x;
  // right_shank
  const Scalar t_right_shank_37 = t_righ_ankl_cros_88 - left_shank_I9 * t_right_shank_18;
  const Scalar t_right_shank_38 = t_right_shank_37 - left_shank_h1 * t_right_shank_6;
  const Scalar t_right_shank_39 = left_shank_I3 * (t_right_hip_fork_18 - t_right_shank_26);
  const Scalar t_right_shank_40 = t_right_shank_38 + left_shank_I8 * Omega_right_shank_zy;
  const Scalar t_righ_ankl_cros_89 = s_right_ankle_pitch * M_righ_ankl_cros_y;
  const Scalar t_right_shank_41 = t_right_shank_40 + t_right_shank_39 - t_righ_ankl_cros_89;
  const Scalar M_right_shank_x = t_right_shank_41 + left_shank_I7 * Omega_right_shank_zx;
  const Scalar t_right_thigh_23 = t_right_thigh_15 + t_right_thigh_16;
  const Scalar t_right_thigh_24 = t_right_hip_fork_18 - t_right_thigh_23;
  const Scalar t_right_shank_42 = s_right_knee * t_righ_ankl_cros_85;
  const Scalar t_right_shank_43 = c_right_knee * F_right_shank_y - t_right_shank_42;
  const Scalar t_right_shank_44 = M_right_shank_z + left_shank_l1 * t_right_shank_43;
  // right_thigh
  const Scalar t_right_thigh_25 = t_right_shank_44 - left_thigh_h2 * a_right_thigh_x;
  const Scalar t_right_thigh_26 = t_right_thigh_25 + left_thigh_I9 * t_right_thigh_2;
  const Scalar t_right_thigh_27 = t_right_thigh_26 + left_thigh_I7 * t_right_thigh_13;
  const Scalar t_right_thigh_28 = t_right_thigh_27 + left_thigh_I11 * t_right_thigh_14;
  const Scalar t_right_thigh_29 = t_right_thigh_28 + left_thigh_I4 * Omega_right_thigh_xz;
  const Scalar t_right_thigh_30 = left_thigh_I8 * (t_right_thigh_17 - t_right_thigh_24);
  const Scalar M_right_thigh_z = t_right_thigh_29 - t_right_thigh_30;
  tau[14] = M_right_thigh_z;
  const Scalar t_right_thigh_31 = left_thigh_h2 * t_right_thigh_13;
  const Scalar t_right_shank_45 = s_right_knee * F_right_shank_y + t_right_thigh_31;
  const Scalar t_right_shank_46 = t_right_shank_45 + c_right_knee * t_righ_ankl_cros_85;
  const Scalar F_right_thigh_y = t_right_shank_43 - left_thigh_h2 * t_right_thigh_23;
  const Scalar t_right_shank_47 = t_righ_ankl_cros_87 - left_thigh_h2 * Omega_right_thigh_zy;
  const Scalar t_righ_ankl_cros_90 = s_right_ankle_pitch * M_righ_ankl_cros_x;
  // right_shank
  const Scalar t_right_shank_48 = t_righ_ankl_cros_90 + left_ankle_cross_l1 * t_right_foot_50;
  const Scalar t_right_shank_49 = t_right_shank_48 - left_shank_I7 * Omega_right_shank_zy;
  const Scalar t_right_shank_50 = t_right_shank_49 + left_shank_I3 * t_right_shank_19;
  const Scalar t_right_shank_51 = t_right_shank_50 + c_right_ankle_pitch * M_righ_ankl_cros_y;
  const Scalar t_right_shank_52 = t_right_shank_51 + left_shank_I11 * Omega_right_shank_zx;
  const Scalar M_right_shank_y = t_right_shank_52 - left_shank_I9 * t_right_shank_22;
  // right_thigh
  const Scalar t_right_thigh_32 = left_thigh_h2 * t_right_thigh_18;
  const Scalar t_right_thigh_33 = t_right_thigh_32 - left_thigh_I4 * t_right_thigh_24;
  const Scalar t_right_thigh_34 = t_right_thigh_33 + left_thigh_I9 * t_right_thigh_14;
  const Scalar t_right_thigh_35 = t_right_thigh_34 - left_thigh_I7 * Omega_right_thigh_zy;
  const Scalar t_right_thigh_36 = t_right_thigh_35 + left_thigh_I8 * t_right_thigh_9;
  const Scalar t_right_shank_53 = t_right_thigh_36 - c_right_knee * M_right_shank_x;
  const Scalar t_right_shank_54 = t_right_shank_53 + s_right_knee * M_right_shank_y;
  // right_hip_fork
  const Scalar Omega_right_hip_fork_zx = t_right_hip_fork_14 - alpha_right_hip_fork_y;
  const Scalar t_right_hip_fork_23 = t_right_hip_fork_16 - t_right_hip_fork_17;
  const Scalar t_right_hip_fork_24 = t_right_hip_block_19 - t_right_hip_fork_23;
  const Scalar t_right_hip_fork_25 = t_right_hip_block_19 - t_right_hip_fork_18;
  const Scalar t_right_shank_55 = left_shank_l1 * t_righ_ankl_cros_87;
  // right_thigh
  const Scalar t_right_thigh_37 = t_right_shank_55 + left_thigh_I4 * t_right_thigh_13;
  const Scalar t_right_thigh_38 = t_right_thigh_37 - left_thigh_I11 * t_right_thigh_9;
  const Scalar t_right_thigh_39 = t_right_thigh_38 + s_right_knee * M_right_shank_x;
  const Scalar t_right_thigh_40 = t_right_thigh_39 - left_thigh_I9 * t_right_thigh_17;
  const Scalar t_right_thigh_41 = t_right_thigh_40 - left_thigh_I8 * Omega_right_thigh_zy;
  const Scalar M_right_thigh_y = t_right_thigh_41 + c_right_knee * M_right_shank_y;
  const Scalar t_right_hip_fork_26 = left_hip_fork_I6 * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_42 = left_hip_fork_h1 * a_right_hip_fork_y + t_right_hip_fork_26;
  const Scalar t_right_hip_fork_27 = t_right_hip_fork_23 - t_right_hip_fork_25;
  const Scalar t_right_thigh_43 = t_right_thigh_42 - s_right_hip_pitch * t_right_shank_54;
  const Scalar t_right_thigh_44 = t_right_thigh_43 - left_hip_fork_I7 * t_right_hip_fork_27;
  const Scalar t_right_thigh_45 = t_right_thigh_44 + left_hip_fork_I9 * Omega_right_hip_fork_xz;
  const Scalar t_right_thigh_46 = t_right_thigh_45 + left_hip_fork_I8 * Omega_right_hip_fork_yz;
  const Scalar t_right_thigh_47 = t_right_thigh_46 + c_right_hip_pitch * M_right_thigh_y;
  const Scalar t_right_hip_fork_28 = left_hip_fork_I10 * Omega_right_hip_fork_yx;
  const Scalar t_right_thigh_48 = t_right_thigh_47 - t_right_hip_fork_28;
  const Scalar t_right_thigh_49 = t_right_thigh_48 - left_hip_fork_h3 * t_right_hip_fork_21;
  tau[13] = -t_right_thigh_49;
  const Scalar t_right_thigh_50 = c_right_hip_pitch * t_right_shank_46;
  const Scalar t_right_thigh_51 = t_right_thigh_50 + s_right_hip_pitch * F_right_thigh_y;
  const Scalar t_right_thigh_52 = M_right_thigh_z + left_hip_fork_I10 * Omega_right_hip_fork_zx;
  const Scalar t_right_thigh_53 = t_right_thigh_52 - left_hip_fork_h1 * a_right_hip_fork_z;
  const Scalar t_right_thigh_54 = t_right_thigh_53 - left_hip_fork_I9 * Omega_right_hip_fork_xy;
  const Scalar t_right_thigh_55 = t_right_thigh_54 + left_hip_fork_I7 * t_right_hip_fork_8;
  const Scalar t_right_thigh_56 = t_right_thigh_55 - left_hip_fork_l1 * t_right_thigh_51;
  const Scalar t_right_thigh_57 = t_right_thigh_56 + left_hip_fork_I8 * t_right_hip_fork_23;
  // right_hip_fork
  const Scalar t_right_hip_fork_29 = left_hip_fork_I7 * Omega_right_hip_fork_zx;
  const Scalar t_right_hip_fork_30 = left_hip_fork_I8 * Omega_right_hip_fork_yx;
  const Scalar t_right_hip_fork_31 = t_right_hip_fork_29 - t_right_hip_fork_30;
  const Scalar t_right_hip_fork_32 = left_hip_fork_I6 * t_right_hip_fork_8;
  const Scalar t_right_hip_fork_33 = t_right_hip_fork_31 + t_right_hip_fork_32;
  const Scalar t_right_hip_fork_34 = left_hip_fork_I9 * t_right_hip_fork_25;
  const Scalar t_right_hip_fork_35 = t_right_hip_fork_33 + t_right_hip_fork_34;
  // right_thigh
  const Scalar t_right_thigh_58 = t_right_hip_fork_35 - c_right_hip_pitch * t_right_shank_54;
  const Scalar t_right_thigh_59 = t_right_thigh_58 + left_hip_fork_l1 * t_right_shank_47;
  const Scalar t_right_thigh_60 = t_right_thigh_59 - left_hip_fork_h3 * a_right_hip_fork_z;
  const Scalar t_right_thigh_61 = t_right_thigh_60 - s_right_hip_pitch * M_right_thigh_y;
  // right_hip_block
  const Scalar t_right_hip_block_20 = t_right_hip_block_17 - t_right_hip_block_18;
  const Scalar t_right_hip_block_21 = t_base_rx_13 - t_right_hip_block_19;
  const Scalar t_right_hip_block_22 = left_hip_block_I18 * Omega_right_hip_block_xz;
  const Scalar t_right_hip_block_23 = left_hip_block_h4 * a_right_hip_block_x;
  const Scalar t_right_hip_fork_36 = t_right_hip_block_22 - t_right_hip_block_23;
  const Scalar t_right_hip_block_24 = left_hip_block_h1 * a_right_hip_fork_z;
  const Scalar t_right_hip_fork_37 = t_right_hip_fork_36 - t_right_hip_block_24;
  const Scalar t_right_hip_block_25 = left_hip_block_I17 * t_right_hip_block_9;
  const Scalar t_right_hip_fork_38 = t_right_hip_fork_37 - t_right_hip_block_25;
  const Scalar t_right_hip_block_26 = left_hip_block_I16 * Omega_right_hip_block_xy;
  const Scalar t_right_hip_fork_39 = t_right_hip_fork_38 + t_right_hip_block_26;
  const Scalar t_right_hip_block_27 = left_hip_block_I7 * Omega_right_hip_block_yx;
  // right_hip_fork
  const Scalar t_right_hip_fork_40 = t_right_hip_fork_39 - t_right_hip_block_27;
  const Scalar t_right_hip_fork_41 = s_right_hip_roll * t_right_thigh_57;
  const Scalar t_right_hip_fork_42 = t_right_hip_fork_40 - t_right_hip_fork_41;
  const Scalar t_right_hip_fork_43 = c_right_hip_roll * t_right_thigh_61;
  const Scalar t_right_hip_block_28 = t_right_hip_block_20 - t_right_hip_block_21;
  const Scalar t_right_hip_fork_44 = t_right_hip_fork_42 + t_right_hip_fork_43;
  const Scalar t_right_hip_block_29 = left_hip_block_I8 * t_right_hip_block_28;
  const Scalar t_right_hip_fork_45 = t_right_hip_fork_44 - t_right_hip_block_29;
  tau[12] = -t_right_hip_fork_45;
  const Scalar t_right_hip_block_30 = left_hip_block_I18 * t_right_hip_block_21;
  const Scalar t_right_hip_block_31 = left_hip_block_h4 * t_right_hip_block_16;
  const Scalar t_right_hip_fork_46 = t_right_hip_block_31 - t_right_hip_block_30;
  const Scalar t_right_hip_block_32 = left_hip_block_I16 * Omega_right_hip_block_zy;
  const Scalar t_right_hip_fork_47 = t_right_hip_fork_46 + t_right_hip_block_32;
  const Scalar t_right_hip_block_33 = left_hip_block_I17 * Omega_right_hip_block_yx;
  const Scalar t_right_hip_fork_48 = t_right_hip_fork_47 + t_right_hip_block_33;
  const Scalar t_right_hip_fork_49 = c_right_hip_roll * t_right_thigh_57;
  const Scalar t_right_hip_fork_50 = t_right_hip_fork_48 + t_right_hip_fork_49;
  const Scalar t_right_hip_block_34 = left_hip_block_I8 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_fork_51 = t_right_hip_fork_50 - t_right_hip_block_34;
  // right_hip_block
  const Scalar M_right_hip_block_x = t_right_hip_fork_51 + s_right_hip_roll * t_right_thigh_61;
  const Scalar t_right_hip_block_35 = left_hip_block_I8 * Omega_right_hip_block_zy;
  const Scalar t_right_hip_block_36 = left_hip_block_I18 * Omega_right_hip_block_xy;
  const Scalar t_right_hip_block_37 = t_right_thigh_49 + t_right_hip_block_35;
  const Scalar t_right_hip_block_38 = t_right_hip_block_37 + t_right_hip_block_36;
  const Scalar t_right_hip_block_39 = left_hip_block_I17 * t_right_hip_block_20;
  const Scalar t_right_hip_block_40 = t_right_hip_block_38 - t_right_hip_block_39;
  const Scalar t_right_hip_block_41 = left_hip_block_I7 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_block_42 = t_right_hip_block_40 - t_right_hip_block_41;
  const Scalar t_right_hip_block_43 = left_hip_block_h1 * t_right_hip_block_16;
  const Scalar M_right_hip_block_y = t_right_hip_block_42 - t_right_hip_block_43;
  // right_hip_fork
  const Scalar t_right_hip_fork_52 = left_hip_fork_h1 * Omega_right_hip_fork_yx;
  const Scalar t_right_hip_fork_53 = t_right_shank_47 - t_right_hip_fork_52;
  const Scalar t_right_hip_fork_54 = left_hip_fork_h3 * t_right_hip_fork_18;
  const Scalar F_right_hip_fork_y = t_right_hip_fork_53 - t_right_hip_fork_54;
  const Scalar t_right_hip_fork_55 = left_hip_fork_h3 * Omega_right_hip_fork_xy;
  const Scalar t_right_hip_fork_56 = t_right_thigh_51 + t_right_hip_fork_55;
  const Scalar t_right_hip_fork_57 = left_hip_fork_h1 * t_right_hip_fork_24;
  const Scalar F_right_hip_fork_x = t_right_hip_fork_56 + t_right_hip_fork_57;
  const Scalar t_right_hip_block_44 = t_base_rx_13 - t_right_hip_block_20;
  const Scalar t_right_hip_block_45 = left_hip_block_h1 * t_right_hip_block_44;
  const Scalar t_right_hip_fork_58 = c_right_hip_roll * F_right_hip_fork_y;
  const Scalar t_right_hip_fork_59 = t_right_hip_fork_58 - t_right_hip_block_45;
  const Scalar t_right_hip_fork_60 = s_right_hip_roll * F_right_hip_fork_x;
  const Scalar t_right_hip_fork_61 = t_right_hip_fork_59 + t_right_hip_fork_60;
  const Scalar t_right_hip_block_46 = left_hip_block_h4 * Omega_right_hip_block_xy;
  const Scalar t_right_hip_fork_62 = t_right_hip_fork_61 + t_right_hip_block_46;
  const Scalar t_left_ankle_cross_32 = left_ankle_cross_h2 * a_left_ankle_cross_z;
  const Scalar t_left_foot_32 = t_left_foot_4 * t_left_foot_15;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_33 = t_left_hip_fork_20 - t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_34 = left_ankle_cross_I1 * t_left_ankle_cross_33;
  const Scalar t_left_ankle_cross_35 = t_left_foot_32 - t_left_ankle_cross_32;
  const Scalar t_left_ankle_cross_36 = t_left_ankle_cross_35 + t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_37 = left_ankle_cross_I6 * t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_38 = t_left_ankle_cross_36 + t_left_ankle_cross_37;
  const Scalar t_left_ankle_cross_39 = left_ankle_cross_I8 * t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_40 = t_left_ankle_cross_38 + t_left_ankle_cross_39;
  const Scalar t_left_foot_33 = Omega_left_foot_zy * t_left_foot_13;
  const Scalar t_left_ankle_cross_41 = t_left_ankle_cross_40 + t_left_foot_33;
  const Scalar t_left_foot_34 = t_left_foot_8 * t_left_foot_14;
  const Scalar t_left_ankle_cross_42 = t_left_ankle_cross_41 + t_left_foot_34;
  const Scalar t_left_ankle_cross_43 = t_left_ankle_cross_42 + left_hip_fork_l3 * F_left_foot_z;
  const Scalar t_left_ankle_cross_44 = t_left_ankle_cross_43 + a_left_foot_z * t_left_foot_17;
  const Scalar t_left_ankle_cross_45 = left_ankle_cross_I7 * t_left_ankle_cross_9;
  const Scalar t_left_foot_35 = t_left_foot_16 * (t_left_ankle_cross_23 - t_left_foot_9);
  const Scalar t_left_ankle_cross_46 = t_left_ankle_cross_44 + t_left_ankle_cross_45;
  const Scalar M_left_ankle_cross_x = t_left_ankle_cross_46 - t_left_foot_35;
  // left_foot
  const Scalar t_left_foot_36 = t_left_foot_19 * (t_left_ankle_cross_23 + t_left_foot_9);
  const Scalar t_left_foot_37 = left_ankle_cross_m1 * a_left_foot_x - t_left_foot_36;
  const Scalar F_left_foot_x = t_left_foot_37 + Omega_left_foot_xy * t_left_foot_17;
  const Scalar t_left_foot_38 = t_left_foot_26 - left_hip_fork_l1 * F_left_foot_y;
  const Scalar t_left_foot_39 = t_left_foot_38 + left_hip_fork_l3 * F_left_foot_x;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_47 = left_ankle_cross_I1 * Omega_left_foot_xz;
  const Scalar t_left_ankle_cross_48 = left_ankle_cross_I8 * t_left_ankle_cross_24;
  const Scalar t_left_ankle_cross_49 = t_left_foot_39 + t_left_ankle_cross_47;
  const Scalar t_left_ankle_cross_50 = t_left_ankle_cross_49 + t_left_ankle_cross_48;
  const Scalar t_left_ankle_cross_51 = left_ankle_cross_I9 * t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_52 = t_left_ankle_cross_50 + t_left_ankle_cross_51;
  const Scalar t_left_ankle_cross_53 = left_ankle_cross_I6 * t_left_ankle_cross_9;
  const Scalar M_left_ankle_cross_y = t_left_ankle_cross_52 + t_left_ankle_cross_53;
  const Scalar t_left_ankle_cross_54 = t_left_ankle_cross_25 - t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_55 = left_ankle_cross_I6 * t_left_ankle_cross_54;
  const Scalar t_left_ankle_cross_56 = left_ankle_cross_I1 * t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_57 = t_left_ankle_cross_55 + t_left_ankle_cross_56;
  const Scalar t_left_ankle_cross_58 = left_ankle_cross_h2 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_59 = t_left_ankle_cross_57 + t_left_ankle_cross_58;
  const Scalar t_left_ankle_cross_60 = t_left_ankle_cross_59 - a_left_foot_z * t_left_foot_19;
  const Scalar t_left_ankle_cross_61 = left_ankle_cross_I9 * t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_62 = t_left_ankle_cross_60 - t_left_ankle_cross_61;
  const Scalar t_left_foot_40 = t_left_foot_8 * t_left_foot_18;
  const Scalar t_left_foot_41 = t_left_foot_15 * (t_left_ankle_cross_22 - t_left_foot_9);
  const Scalar t_left_ankle_cross_63 = t_left_ankle_cross_62 + t_left_foot_40;
  const Scalar t_left_ankle_cross_64 = t_left_ankle_cross_63 + t_left_foot_41;
  const Scalar t_left_foot_42 = Omega_left_foot_zy * t_left_foot_14;
  const Scalar t_left_ankle_cross_65 = t_left_ankle_cross_64 + t_left_foot_42;
  const Scalar t_left_ankle_cross_66 = left_ankle_cross_I7 * Omega_left_foot_xz;
  const Scalar t_left_ankle_cross_67 = t_left_ankle_cross_65 + t_left_ankle_cross_66;
  const Scalar t_left_ankle_cross_68 = t_left_ankle_cross_67 - left_hip_fork_l1 * F_left_foot_z;
  const Scalar t_left_ankle_cross_69 = left_ankle_cross_I8 * t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_70 = t_left_ankle_cross_68 - t_left_ankle_cross_69;
  const Scalar t_left_foot_43 = Omega_left_foot_xy * t_left_foot_16;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_70 + t_left_foot_43;
  tau[10] = M_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_71 = F_left_foot_y + left_shank_m1 * a_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_72 = left_ankle_cross_h2 * t_left_ankle_cross_9;
  const Scalar F_left_ankle_cross_z = t_left_ankle_cross_71 - t_left_ankle_cross_72;
  const Scalar t_left_shank_20 = t_left_shank_14 + t_left_shank_15;
  const Scalar t_left_shank_21 = t_left_hip_fork_20 - t_left_shank_20;
  const Scalar t_left_ankle_cross_73 = c_left_ankle_pitch * M_left_ankle_cross_x;
  // left_shank
  const Scalar t_left_shank_22 = t_left_ankle_cross_73 - left_shank_I3 * t_left_shank_21;
  const Scalar t_left_shank_23 = t_left_shank_22 - left_shank_I9 * Omega_left_shank_yx;
  const Scalar t_left_shank_24 = t_left_shank_23 + left_shank_h1 * a_left_shank_z;
  const Scalar t_left_shank_25 = t_left_shank_24 + left_shank_I8 * Omega_left_shank_zy;
  const Scalar t_left_shank_26 = t_left_shank_25 - left_shank_I7 * t_left_shank_8;
  const Scalar M_left_shank_x = t_left_shank_26 - s_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar t_left_foot_44 = F_left_foot_z - left_ankle_cross_h2 * t_left_ankle_cross_25;
  const Scalar t_left_foot_45 = t_left_foot_44 + left_shank_m1 * t_left_ankle_cross_31;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_74 = F_left_foot_x + left_shank_m1 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_75 = left_ankle_cross_h2 * Omega_left_foot_xz;
  const Scalar F_left_ankle_cross_x = t_left_ankle_cross_74 + t_left_ankle_cross_75;
  const Scalar t_left_ankle_cross_76 = s_left_ankle_pitch * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_77 = c_left_ankle_pitch * t_left_foot_45;
  const Scalar t_left_ankle_cross_78 = t_left_ankle_cross_77 - t_left_ankle_cross_76;
  // left_shank
  const Scalar t_left_shank_27 = M_left_ankle_cross_z + left_shank_I12 * t_left_shank_12;
  const Scalar t_left_shank_28 = t_left_shank_27 - left_shank_I3 * Omega_left_shank_xz;
  const Scalar t_left_shank_29 = left_shank_I7 * (t_left_shank_16 - t_left_shank_21);
  const Scalar t_left_shank_30 = t_left_shank_28 - t_left_shank_29;
  const Scalar t_left_shank_31 = t_left_shank_30 - left_shank_I9 * t_left_shank_2;
  const Scalar t_left_shank_32 = t_left_shank_31 - left_shank_I13 * alpha_left_shank_z;
  const Scalar t_left_shank_33 = t_left_shank_32 - left_shank_h1 * a_left_shank_x;
  const Scalar M_left_shank_z = t_left_shank_33 - left_ankle_cross_l1 * t_left_ankle_cross_78;
  tau[9] = M_left_shank_z;
  const Scalar t_left_shank_34 = F_left_ankle_cross_z + left_thigh_m1 * a_left_shank_z;
  const Scalar F_left_shank_z = t_left_shank_34 + left_shank_h1 * Omega_left_shank_zy;
  const Scalar t_left_ankle_cross_79 = s_left_ankle_pitch * M_left_ankle_cross_x;
  const Scalar t_left_shank_35 = t_left_ankle_cross_79 - left_shank_I11 * t_left_shank_8;
  const Scalar t_left_shank_36 = t_left_shank_35 - left_shank_I7 * Omega_left_shank_zy;
  const Scalar t_left_shank_37 = t_left_shank_36 - left_shank_I3 * t_left_shank_13;
  const Scalar t_left_shank_38 = t_left_shank_37 + c_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar t_left_shank_39 = t_left_shank_38 + left_shank_I9 * t_left_shank_16;
  const Scalar M_left_shank_y = t_left_shank_39 - left_ankle_cross_l1 * F_left_ankle_cross_z;
  const Scalar t_left_thigh_19 = left_thigh_I8 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_20 = t_left_thigh_19 + left_thigh_I4 * t_left_thigh_12;
  const Scalar t_left_shank_40 = t_left_thigh_20 - s_left_knee * M_left_shank_x;
  const Scalar t_left_shank_41 = t_left_shank_40 - left_thigh_I9 * t_left_thigh_15;
  const Scalar t_left_shank_42 = t_left_shank_41 + left_thigh_I11 * t_left_thigh_8;
  const Scalar t_left_shank_43 = t_left_shank_42 + left_shank_l1 * F_left_shank_z;
  const Scalar t_left_shank_44 = t_left_shank_43 - c_left_knee * M_left_shank_y;
  const Scalar t_left_shank_45 = left_thigh_m1 * t_left_shank_19;
  const Scalar t_left_ankle_cross_80 = t_left_ankle_cross_78 + t_left_shank_45;
  const Scalar t_left_shank_46 = left_shank_h1 * t_left_shank_20;
  const Scalar t_left_ankle_cross_81 = t_left_ankle_cross_80 + t_left_shank_46;
  const Scalar t_left_ankle_cross_82 = c_left_ankle_pitch * F_left_ankle_cross_x;
  const Scalar t_left_shank_47 = t_left_ankle_cross_82 - left_shank_h1 * t_left_shank_13;
  const Scalar t_left_shank_48 = t_left_shank_47 + s_left_ankle_pitch * t_left_foot_45;
  const Scalar F_left_shank_x = t_left_shank_48 + left_thigh_m1 * a_left_shank_x;
  const Scalar t_left_shank_49 = c_left_knee * t_left_ankle_cross_81;
  const Scalar t_left_shank_50 = t_left_shank_49 - s_left_knee * F_left_shank_x;
  // left_thigh
  const Scalar t_left_thigh_21 = t_left_thigh_13 + t_left_thigh_14;
  const Scalar t_left_thigh_22 = left_thigh_I8 * (t_left_thigh_18 - t_left_thigh_21);
  const Scalar t_left_thigh_23 = left_thigh_I4 * Omega_left_thigh_xz;
  const Scalar t_left_thigh_24 = M_left_shank_z + t_left_thigh_22 - t_left_thigh_23;
  const Scalar t_left_thigh_25 = t_left_thigh_24 - left_shank_l1 * t_left_shank_50;
  const Scalar t_left_thigh_26 = t_left_thigh_25 - left_thigh_I11 * Omega_left_thigh_yx;
  const Scalar t_left_thigh_27 = t_left_thigh_26 - left_thigh_h2 * a_left_thigh_x;
  const Scalar t_left_thigh_28 = t_left_thigh_27 - left_thigh_I9 * t_left_thigh_2;
  const Scalar M_left_thigh_z = t_left_thigh_28 + left_thigh_I7 * t_left_thigh_12;
  tau[8] = M_left_thigh_z;
  const Scalar F_left_thigh_z = F_left_shank_z + left_thigh_h2 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_29 = left_thigh_I7 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_30 = t_left_thigh_29 - left_thigh_I9 * Omega_left_thigh_yx;
  const Scalar t_left_thigh_31 = left_thigh_I4 * (t_left_hip_fork_20 - t_left_thigh_21);
  const Scalar t_left_thigh_32 = t_left_thigh_30 + left_thigh_h2 * a_left_thigh_z;
  const Scalar t_left_thigh_33 = t_left_thigh_32 - t_left_thigh_31;
  const Scalar t_left_thigh_34 = t_left_thigh_33 - left_thigh_I8 * t_left_thigh_8;
  const Scalar t_left_thigh_35 = t_left_thigh_34 - s_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_x = t_left_thigh_35 + c_left_knee * M_left_shank_x;
  // left_hip_fork
  const Scalar t_left_hip_fork_25 = left_hip_fork_I8 * Omega_left_hip_fork_yx;
  const Scalar t_left_hip_fork_26 = t_left_hip_fork_25 + left_hip_fork_h3 * a_left_hip_block_y;
  const Scalar t_left_hip_fork_27 = t_left_hip_fork_26 - c_left_hip_pitch * M_left_thigh_x;
  const Scalar t_left_hip_fork_28 = t_left_hip_fork_27 + left_hip_fork_l1 * F_left_thigh_z;
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_28 - s_left_hip_pitch * t_left_shank_44;
  const Scalar t_left_hip_fork_30 = left_hip_fork_I6 * t_left_hip_fork_8;
  const Scalar t_left_hip_fork_31 = t_left_hip_fork_29 - t_left_hip_fork_30;
  const Scalar t_left_hip_fork_32 = left_hip_fork_I7 * Omega_left_hip_fork_zx;
  const Scalar t_left_hip_fork_33 = t_left_hip_block_22 - t_left_hip_fork_20;
  const Scalar t_left_hip_fork_34 = t_left_hip_fork_31 + t_left_hip_fork_32;
  const Scalar M_left_hip_fork_x = t_left_hip_fork_34 + left_hip_fork_I9 * t_left_hip_fork_33;
  const Scalar t_left_hip_fork_35 = t_left_hip_block_22 - t_left_hip_fork_21;
  const Scalar t_left_hip_fork_36 = t_left_hip_fork_20 - t_left_hip_fork_35;
  // left_thigh
  const Scalar t_left_thigh_36 = left_hip_fork_I12 * t_left_hip_fork_17;
  const Scalar t_left_thigh_37 = t_left_thigh_36 + left_hip_fork_I7 * t_left_hip_fork_36;
  const Scalar t_left_thigh_38 = t_left_thigh_37 + s_left_hip_pitch * M_left_thigh_x;
  const Scalar t_left_thigh_39 = t_left_thigh_38 - c_left_hip_pitch * t_left_shank_44;
  const Scalar t_left_thigh_40 = t_left_thigh_39 - left_hip_fork_I11 * alpha_left_hip_fork_z;
  const Scalar t_left_thigh_41 = t_left_thigh_40 - left_hip_fork_h3 * a_left_hip_fork_x;
  const Scalar t_left_thigh_42 = t_left_thigh_41 + left_hip_fork_I8 * Omega_left_hip_fork_yz;
  const Scalar t_left_thigh_43 = t_left_thigh_42 - left_hip_fork_h1 * t_left_hip_fork_24;
  const Scalar t_left_thigh_44 = t_left_thigh_43 + left_hip_fork_I9 * t_left_hip_fork_11;
  tau[7] = -t_left_thigh_44;
  // left_shank
  const Scalar t_left_shank_51 = t_left_shank_50 + left_thigh_h2 * t_left_thigh_21;
  const Scalar t_left_shank_52 = s_left_knee * t_left_ankle_cross_81;
  const Scalar t_left_shank_53 = c_left_knee * F_left_shank_x + t_left_shank_52;
  // left_thigh
  const Scalar F_left_thigh_x = t_left_shank_53 - left_thigh_h2 * t_left_thigh_12;
  const Scalar t_left_thigh_45 = s_left_hip_pitch * t_left_shank_51;
  const Scalar t_left_thigh_46 = t_left_thigh_45 + c_left_hip_pitch * F_left_thigh_x;
  const Scalar t_left_thigh_47 = M_left_thigh_z + left_hip_fork_l1 * t_left_thigh_46;
  const Scalar t_left_thigh_48 = t_left_thigh_47 + left_hip_fork_I9 * Omega_left_hip_fork_xy;
  const Scalar t_left_thigh_49 = t_left_thigh_48 - left_hip_fork_I7 * t_left_hip_fork_8;
  const Scalar t_left_thigh_50 = t_left_thigh_49 + left_hip_fork_I10 * Omega_left_hip_fork_zx;
  const Scalar t_left_thigh_51 = t_left_thigh_50 + left_hip_fork_h1 * a_left_hip_block_y;
  const Scalar t_left_thigh_52 = t_left_thigh_51 + left_hip_fork_I8 * t_left_hip_fork_21;
  const Scalar t_left_thigh_53 = t_left_thigh_46 + left_hip_fork_h3 * Omega_left_hip_fork_xy;
  const Scalar t_left_thigh_54 = t_left_thigh_53 - left_hip_fork_h1 * t_left_hip_fork_35;
  const Scalar t_left_thigh_55 = F_left_thigh_z + left_hip_fork_h1 * Omega_left_hip_fork_yx;
  const Scalar t_left_thigh_56 = t_left_thigh_55 - left_hip_fork_h3 * t_left_hip_fork_20;
  // left_hip_block
  const Scalar t_left_hip_block_23 = t_left_hip_block_20 - t_left_hip_block_21;
  const Scalar t_left_hip_block_24 = t_base_rx_13 - t_left_hip_block_23;
  const Scalar t_left_hip_block_25 = left_hip_block_I16 * Omega_left_hip_block_xy;
  const Scalar t_left_hip_block_26 = left_hip_block_I17 * t_left_hip_block_15;
  const Scalar t_left_hip_block_27 = t_left_hip_block_22 - t_left_hip_block_24;
  const Scalar t_left_hip_fork_37 = t_left_hip_block_25 + t_left_hip_block_26;
  const Scalar t_left_hip_block_28 = left_hip_block_I8 * t_left_hip_block_27;
  const Scalar t_left_hip_fork_38 = t_left_hip_fork_37 + t_left_hip_block_28;
  const Scalar t_left_hip_block_29 = left_hip_block_I7 * Omega_left_hip_block_yx;
  // left_hip_fork
  const Scalar t_left_hip_fork_39 = t_left_hip_fork_38 - t_left_hip_block_29;
  const Scalar t_left_hip_fork_40 = t_left_hip_fork_39 - left_hip_block_h1 * a_left_hip_block_y;
  const Scalar t_left_hip_fork_41 = t_left_hip_fork_40 - s_left_hip_roll * t_left_thigh_52;
  const Scalar t_left_hip_fork_42 = t_left_hip_fork_41 - c_left_hip_roll * M_left_hip_fork_x;
  const Scalar t_left_hip_fork_43 = t_left_hip_fork_42 - left_hip_block_h4 * a_left_hip_block_x;
  const Scalar t_left_hip_block_30 = left_hip_block_I18 * Omega_left_hip_block_xz;
  const Scalar t_left_hip_fork_44 = t_left_hip_fork_43 + t_left_hip_block_30;
  tau[6] = -t_left_hip_fork_44;
  const Scalar t_left_hip_fork_45 = c_left_hip_roll * t_left_thigh_56;
  const Scalar t_left_hip_fork_46 = t_left_hip_fork_45 + s_left_hip_roll * t_left_thigh_54;
  // left_hip_block
  const Scalar t_left_hip_block_31 = left_hip_block_h1 * t_left_hip_block_24;
  const Scalar t_left_hip_block_32 = t_left_hip_fork_46 - t_left_hip_block_31;
  const Scalar t_left_hip_block_33 = left_hip_block_h4 * Omega_left_hip_block_xy;
  const Scalar F_left_hip_block_x = t_left_hip_block_32 - t_left_hip_block_33;
  const Scalar t_left_hip_block_34 = left_hip_block_h4 * t_left_hip_block_22;
  // left_hip_fork
  const Scalar t_left_hip_fork_47 = t_left_hip_block_34 - c_left_hip_pitch * t_left_shank_51;
  const Scalar t_left_hip_fork_48 = left_hip_fork_h3 * t_left_hip_fork_8;
  const Scalar t_left_hip_fork_49 = t_left_hip_fork_47 - t_left_hip_fork_48;
  const Scalar t_left_hip_fork_50 = left_hip_fork_h1 * Omega_left_hip_fork_zx;
  const Scalar t_left_hip_fork_51 = t_left_hip_fork_49 + t_left_hip_fork_50;
  const Scalar t_left_hip_block_35 = left_hip_block_h1 * Omega_left_hip_block_yx;
  const Scalar t_left_hip_fork_52 = t_left_hip_fork_51 + t_left_hip_block_35;
  const Scalar F_left_hip_block_y = t_left_hip_fork_52 + s_left_hip_pitch * F_left_thigh_x;
  const Scalar t_right_thigh_62 = s_right_hip_pitch * t_right_shank_46;
  const Scalar t_right_thigh_63 = t_right_thigh_62 - c_right_hip_pitch * F_right_thigh_y;
  const Scalar t_right_hip_block_47 = left_hip_block_h4 * t_right_hip_block_19;
  // right_hip_fork
  const Scalar t_right_hip_fork_63 = t_right_thigh_63 - t_right_hip_block_47;
  const Scalar t_right_hip_fork_64 = left_hip_fork_h3 * t_right_hip_fork_8;
  const Scalar t_right_hip_fork_65 = t_right_hip_fork_63 - t_right_hip_fork_64;
  const Scalar t_right_hip_fork_66 = left_hip_fork_h1 * Omega_right_hip_fork_zx;
  const Scalar t_right_hip_fork_67 = t_right_hip_fork_65 - t_right_hip_fork_66;
  const Scalar t_right_hip_block_48 = left_hip_block_h1 * Omega_right_hip_block_yx;
  const Scalar t_right_hip_fork_68 = t_right_hip_fork_67 + t_right_hip_block_48;
  // right_hip_block
  const Scalar t_right_hip_block_49 = c_right_hip_yaw * t_right_hip_fork_68;
  const Scalar t_right_hip_block_50 = s_right_hip_yaw * t_right_hip_fork_62;
  const Scalar t_right_hip_block_51 = t_right_hip_block_49 + t_right_hip_block_50;
  const Scalar t_left_hip_block_36 = s_left_hip_yaw * F_left_hip_block_x;
  const Scalar t_left_hip_block_37 = t_left_hip_block_36 + c_left_hip_yaw * F_left_hip_block_y;
  const Scalar t_base_rx_16 = t_right_hip_block_51 - t_left_hip_block_37;
  // left_hip_block
  const Scalar t_left_hip_block_38 = left_hip_block_I16 * Omega_left_hip_block_zy;
  const Scalar t_left_hip_block_39 = left_hip_block_I8 * Omega_left_hip_block_zx;
  const Scalar t_left_hip_block_40 = t_base_rx_13 - t_left_hip_block_22;
  const Scalar t_left_hip_block_41 = t_left_hip_block_39 + t_left_hip_block_38;
  const Scalar t_left_hip_block_42 = left_hip_block_I18 * t_left_hip_block_40;
  const Scalar t_left_hip_block_43 = t_left_hip_block_41 - t_left_hip_block_42;
  const Scalar t_left_hip_block_44 = left_hip_block_I17 * Omega_left_hip_block_yx;
  const Scalar t_left_hip_block_45 = t_left_hip_block_43 - t_left_hip_block_44;
  const Scalar t_left_hip_block_46 = left_hip_block_h4 * a_left_hip_block_z;
  const Scalar t_left_hip_block_47 = t_left_hip_block_45 - t_left_hip_block_46;
  const Scalar t_left_hip_block_48 = t_left_hip_block_47 + c_left_hip_roll * t_left_thigh_52;
  const Scalar M_left_hip_block_x = t_left_hip_block_48 - s_left_hip_roll * M_left_hip_fork_x;
  const Scalar t_left_hip_block_49 = left_hip_block_I7 * Omega_left_hip_block_zx;
  const Scalar t_left_hip_block_50 = left_hip_block_I8 * Omega_left_hip_block_zy;
  const Scalar t_left_hip_block_51 = t_left_thigh_44 - t_left_hip_block_49;
  const Scalar t_left_hip_block_52 = t_left_hip_block_51 - t_left_hip_block_50;
  const Scalar t_left_hip_block_53 = left_hip_block_h1 * a_left_hip_block_z;
  const Scalar t_left_hip_block_54 = t_left_hip_block_52 - t_left_hip_block_53;
  const Scalar t_left_hip_block_55 = left_hip_block_I17 * t_left_hip_block_23;
  const Scalar t_left_hip_block_56 = t_left_hip_block_54 + t_left_hip_block_55;
  const Scalar t_left_hip_block_57 = left_hip_block_I18 * Omega_left_hip_block_xy;
  const Scalar M_left_hip_block_y = t_left_hip_block_56 + t_left_hip_block_57;
  // base_rx
  const Scalar t_base_rx_17 = base_rx_I6 * Omega_base_rx_zx - c_left_hip_yaw * M_left_hip_block_x;
  const Scalar t_base_rx_18 = t_base_rx_17 + left_hip_block_l2 * t_base_rx_16;
  const Scalar t_base_rx_19 = t_base_rx_18 - base_rx_I5 * Omega_base_rx_yx;
  const Scalar t_base_rx_20 = t_base_rx_19 + s_left_hip_yaw * M_left_hip_block_y;
  const Scalar t_base_rx_21 = t_base_rx_20 + s_right_hip_yaw * M_right_hip_block_y;
  const Scalar t_base_rx_22 = base_rx_I1 * (t_base_ry_5 - t_base_rx_13);
  const Scalar t_base_rx_23 = t_base_rx_21 + base_rx_h6 * a_base_ry_y + t_base_rx_22;
  const Scalar t_base_rx_24 = t_base_rx_23 - base_rx_I14 * t_base_rx_3;
  const Scalar M_base_rx_x = t_base_rx_24 - c_right_hip_yaw * M_right_hip_block_x;
  // right_hip_fork
  const Scalar t_right_hip_fork_69 = c_right_hip_roll * F_right_hip_fork_x;
  const Scalar t_right_hip_fork_70 = s_right_hip_roll * F_right_hip_fork_y;
  const Scalar t_right_hip_fork_71 = t_right_hip_fork_69 - t_right_hip_fork_70;
  // right_hip_block
  const Scalar t_right_hip_block_52 = left_hip_block_h1 * Omega_right_hip_block_zx;
  const Scalar t_right_hip_block_53 = t_right_hip_fork_71 - t_right_hip_block_52;
  const Scalar t_right_hip_block_54 = left_hip_block_h4 * Omega_right_hip_block_zy;
  const Scalar F_right_hip_block_z = t_right_hip_block_53 - t_right_hip_block_54;
  // left_hip_block
  const Scalar t_left_hip_block_58 = left_hip_block_h1 * Omega_left_hip_block_zx;
  const Scalar t_left_hip_block_59 = s_left_hip_roll * t_left_thigh_56 + t_left_hip_block_58;
  const Scalar t_left_hip_block_60 = left_hip_block_h4 * Omega_left_hip_block_zy;
  const Scalar t_left_hip_block_61 = t_left_hip_block_59 - t_left_hip_block_60;
  const Scalar F_left_hip_block_z = t_left_hip_block_61 - c_left_hip_roll * t_left_thigh_54;
  const Scalar t_right_hip_block_55 = c_right_hip_yaw * t_right_hip_fork_62;
  // base_ry
  const Scalar t_base_ry_6 = t_right_hip_block_55 - c_left_hip_yaw * F_left_hip_block_x;
  const Scalar t_base_ry_7 = t_base_ry_6 + s_left_hip_yaw * F_left_hip_block_y;
  const Scalar t_base_ry_8 = t_base_ry_7 - s_right_hip_yaw * t_right_hip_fork_68;
  const Scalar t_base_ry_9 = left_hip_block_l1 * (F_right_hip_block_z - F_left_hip_block_z);
  const Scalar t_base_ry_10 = base_rx_I5 * Omega_base_rx_yz - t_base_ry_9;
  const Scalar t_base_ry_11 = t_base_ry_10 + base_rx_I6 * (t_base_rx_11 - t_base_rx_13);
  const Scalar t_base_ry_12 = t_base_ry_11 + base_rx_h1 * t_base_rx_15;
  const Scalar t_base_ry_13 = t_base_ry_12 - c_left_hip_yaw * M_left_hip_block_y;
  const Scalar t_base_ry_14 = t_base_ry_13 + base_rx_I11 * alpha_base_rx_z;
  const Scalar t_base_ry_15 = t_base_ry_14 - s_left_hip_yaw * M_left_hip_block_x;
  const Scalar t_base_ry_16 = t_base_ry_15 - left_hip_block_l2 * t_base_ry_8;
  const Scalar t_base_ry_17 = t_base_ry_16 - base_rx_I12 * t_base_rx_12;
  const Scalar t_base_ry_18 = t_base_ry_17 - base_rx_h6 * t_base_rx_14;
  const Scalar t_base_ry_19 = t_base_ry_18 - base_rx_I1 * t_base_rx_6;
  const Scalar t_base_ry_20 = t_base_ry_19 - c_right_hip_yaw * M_right_hip_block_y;
  // base_rx
  const Scalar M_base_rx_z = t_base_ry_20 - s_right_hip_yaw * M_right_hip_block_x;
  tau[5] = M_base_rx_z;
  const Scalar t_base_rx_25 = t_base_ry_8 + base_rx_h1 * t_base_rx_11;
  const Scalar F_base_rx_x = t_base_rx_25 - base_rx_h6 * Omega_base_rx_xy;
  // left_hip_block
  const Scalar t_left_hip_block_62 = F_right_hip_block_z + F_left_hip_block_z;
  const Scalar t_left_hip_block_63 = t_left_hip_block_62 + base_rx_h1 * Omega_base_rx_yx;
  const Scalar t_left_hip_block_64 = t_left_hip_block_63 - base_rx_h6 * t_base_rx_13;
  // base_rx
  const Scalar t_base_rx_26 = t_right_hip_block_51 + t_left_hip_block_37;
  const Scalar t_base_rx_27 = t_right_hip_fork_45 + t_left_hip_fork_44;
  const Scalar t_base_rx_28 = t_base_rx_27 - left_hip_block_l1 * t_base_rx_26;
  const Scalar t_base_rx_29 = t_base_rx_28 - base_rx_I1 * Omega_base_rx_xy;
  const Scalar t_base_rx_30 = t_base_rx_29 + base_rx_I5 * t_base_rx_10;
  const Scalar t_base_rx_31 = t_base_rx_30 - base_rx_I13 * Omega_base_rx_zx;
  const Scalar t_base_rx_32 = t_base_rx_31 - base_rx_h1 * a_base_ry_y;
  const Scalar M_base_rx_y = t_base_rx_32 + base_rx_I6 * t_base_rx_3;
  const Scalar t_base_rz_2 = c_base_rx * M_base_rx_x - base_rx_I8 * t_base_ry_4;
  // base_ry
  tau[4] = -(t_base_rz_2 - s_base_rx * M_base_rx_y + base_rx_h2 * t_base_ry_2);
  const Scalar t_base_ry_21 = base_rx_h2 * t_base_ry_1 - c_base_rx * F_base_rx_x;
  const Scalar F_base_ry_z = t_base_ry_21 - s_base_rx * t_left_hip_block_64;
  const Scalar t_base_ry_22 = base_rx_h2 * a_base_rz_y + c_base_rx * M_base_rx_y;
  const Scalar M_base_ry_x = t_base_ry_22 - base_rx_I8 * t_base_ry_1 + s_base_rx * M_base_rx_x;
  tau[3] = -(s_base_ry * M_base_rx_z + c_base_ry * M_base_ry_x);
  // base_rx
  const Scalar t_base_rx_33 = t_base_rx_16 - base_rx_h1 * Omega_base_rx_zx;
  const Scalar F_base_rx_z = t_base_rx_33 + base_rx_h6 * t_base_rx_3;
  const Scalar t_base_rx_34 = F_base_rx_z - base_rx_h2 * t_base_ry_5;
  const Scalar t_base_rx_35 = s_base_rx * F_base_rx_x - c_base_rx * t_left_hip_block_64;
  const Scalar F_base_ry_x = t_base_rx_35 + base_rx_h2 * t_base_ry_4;
  const Scalar t_base_ry_23 = c_base_ry * t_base_rx_34 - s_base_ry * F_base_ry_x;
  // base_pz
  tau[1] = base_rx_m2 * qdd[1] + c_base_rz * F_base_ry_z + s_base_rz * t_base_ry_23;
  tau[0] = base_rx_m2 * qdd[0] + c_base_rz * t_base_ry_23 - s_base_rz * F_base_ry_z;
  tau[2] = base_rx_m2 * a_base_pz_z - c_base_ry * F_base_ry_x - s_base_ry * t_base_rx_34;
}

namespace {

[[gnu::noinline]] void forward_dynamics_1(const Scalar q[18], const Scalar qd[18],
                                          const Scalar tau[18], Scalar w[278]) noexcept {
  const auto [s_base_rz, c_base_rz] = sine_cosine(q[3]);
  const auto [s_base_ry, c_base_ry] = sine_cosine(q[4]);
  w[0] = s_base_ry;
  const auto [s_base_rx, c_base_rx] = sine_cosine(q[5]);
  w[1] = s_base_rx;
  w[2] = c_base_rx;
  const auto [s_left_hip_yaw, c_left_hip_yaw] = sine_cosine(q[6]);
  w[3] = s_left_hip_yaw;
  w[4] = c_left_hip_yaw;
  const auto [s_left_hip_roll, c_left_hip_roll] = sine_cosine(q[7]);
  w[5] = s_left_hip_roll;
  w[6] = c_left_hip_roll;
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const auto [s_q8_q9_q10, c_q8_q9_q10] = sine_cosine(q_q8_q9_q10);
  w[7] = s_q8_q9_q10;
  w[8] = c_q8_q9_q10;
  // left_shank
  const auto [s_q9_q10, c_q9_q10] = sine_cosine(q_q9_q10);
  const Scalar s_left_shank_x = left_shank_l1 * c_q9_q10;
  w[9] = s_left_shank_x;
  const Scalar t_left_shank_1 = left_shank_l1 * s_q9_q10;
  w[10] = t_left_shank_1;
  // left_ankle_cross
  const auto [s_left_ankle_pitch, c_left_ankle_pitch] = sine_cosine(q[10]);
  const Scalar s_left_ankle_cross_x = left_ankle_cross_l1 * c_left_ankle_pitch;
  w[11] = s_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_l1 * s_left_ankle_pitch;
  w[12] = t_left_ankle_cross_1;
  const Scalar t_left_foot_1 = left_foot_k1 + q[11];
  const auto [s_left_foot, c_left_foot] = sine_cosine(t_left_foot_1);
  w[13] = s_left_foot;
  w[14] = c_left_foot;
  const auto [s_right_hip_yaw, c_right_hip_yaw] = sine_cosine(q[12]);
  w[15] = s_right_hip_yaw;
  w[16] = c_right_hip_yaw;
  const auto [s_right_hip_roll, c_right_hip_roll] = sine_cosine(q[13]);
  w[17] = s_right_hip_roll;
  w[18] = c_right_hip_roll;
  const Scalar q_q15_q16 = q[15] + q[16];
  const Scalar q_q14_q15_q16 = q[14] + q_q15_q16;
  const auto [s_q14_q15_q16, c_q14_q15_q16] = sine_cosine(q_q14_q15_q16);
  w[19] = s_q14_q15_q16;
  w[20] = c_q14_q15_q16;
  // right_shank
  const auto [s_q15_q16, c_q15_q16] = sine_cosine(q_q15_q16);
  w[21] = s_q15_q16;
  w[22] = c_q15_q16;
  const Scalar s_right_shank_x = left_shank_l1 * c_q15_q16;
  w[23] = s_right_shank_x;
  const Scalar t_right_shank_1 = left_shank_l1 * s_q15_q16;
  w[24] = t_right_shank_1;
  // right_ankle_cross
  const auto [s_right_ankle_pitch, c_right_ankle_pitch] = sine_cosine(q[16]);
  w[25] = s_right_ankle_pitch;
  w[26] = c_right_ankle_pitch;
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_l1 * s_right_ankle_pitch;
  w[27] = t_righ_ankl_cros_1;
  const Scalar s_righ_ankl_cros_x = left_ankle_cross_l1 * c_right_ankle_pitch;
  w[28] = s_righ_ankl_cros_x;
  const Scalar t_right_foot_1 = left_foot_k1 - q[17];
  const auto [s_right_foot, c_right_foot] = sine_cosine(t_right_foot_1);
  w[29] = s_right_foot;
  w[30] = c_right_foot;
  // base_rx
  const Scalar t_base_rx_1 = c_base_rz * s_base_ry;
  const Scalar t_base_rx_2 = s_base_rz * s_base_rx;
  const Scalar t_base_rx_3 = t_base_rx_2 + c_base_rx * t_base_rx_1;
  w[31] = t_base_rx_3;
  const Scalar t_base_rx_4 = s_base_rz * c_base_rx;
  const Scalar t_base_rx_5 = t_base_rx_4 - s_base_rx * t_base_rx_1;
  w[32] = t_base_rx_5;
  const Scalar t_base_rx_6 = s_base_ry * t_base_rx_4 - c_base_rz * s_base_rx;
  w[33] = t_base_rx_6;
  const Scalar t_base_rx_7 = s_base_ry * t_base_rx_2 + c_base_rz * c_base_rx;
  w[34] = t_base_rx_7;
  const Scalar t_base_rx_8 = 1.0 / c_base_ry;
  w[35] = t_base_rx_8;
  const Scalar t_base_rx_9 = s_base_rz * c_base_ry;
  w[36] = t_base_rx_9;
  const Scalar t_base_rx_10 = c_base_ry * c_base_rx;
  w[37] = t_base_rx_10;
  const Scalar t_base_rx_11 = c_base_ry * s_base_rx;
  w[38] = t_base_rx_11;
  const Scalar t_base_rx_12 = c_base_ry * qd[3];
  w[39] = t_base_rx_12;
  const Scalar t_base_rx_13 = s_base_rx * t_base_rx_12 + c_base_rx * qd[4];
  w[40] = t_base_rx_13;
  const Scalar t_base_rx_14 = s_base_ry * qd[3];
  const Scalar t_base_rx_15 = qd[4] * t_base_rx_14;
  w[41] = t_base_rx_15;
  const Scalar t_base_rx_16 = c_base_rx * t_base_rx_12 - s_base_rx * qd[4];
  w[42] = t_base_rx_16;
  const Scalar t_base_rx_17 = t_base_rx_8 * (tau[3] + s_base_ry * tau[5]);
  w[43] = t_base_rx_17;
  const Scalar t_base_rx_18 = c_base_rz * c_base_ry;
  w[44] = t_base_rx_18;
  const Scalar omega_base_rx_z = qd[5] - t_base_rx_14;
  w[45] = omega_base_rx_z;
  const Scalar t_base_rx_19 = t_base_rx_13 * t_base_rx_13;
  w[46] = t_base_rx_19;
  const Scalar t_base_rx_20 = omega_base_rx_z * omega_base_rx_z;
  const Scalar t_base_rx_21 = t_base_rx_19 + t_base_rx_20;
  w[47] = t_base_rx_21;
  const Scalar t_base_rx_22 = t_base_rx_13 * t_base_rx_16;
  w[48] = t_base_rx_22;
  const Scalar t_base_rx_23 = t_base_rx_16 * omega_base_rx_z;
  w[49] = t_base_rx_23;
  const Scalar t_base_rx_24 = t_base_rx_16 * t_base_rx_16;
  w[50] = t_base_rx_24;
  const Scalar t_base_rx_25 = t_base_rx_13 * omega_base_rx_z;
  w[51] = t_base_rx_25;
  const Scalar t_base_rx_26 = t_base_rx_20 + t_base_rx_24;
  w[52] = t_base_rx_26;
  // left_hip_block
  const Scalar t_left_hip_block_1 = left_hip_block_l1 * t_base_rx_26;
  const Scalar t_left_hip_block_2 = left_hip_block_l2 * t_base_rx_22;
  const Scalar t_left_hip_block_3 = t_left_hip_block_1 + t_left_hip_block_2;
  const Scalar t_left_hip_block_4 = left_hip_block_l2 * t_base_rx_23;
  const Scalar t_left_hip_block_5 = left_hip_block_l1 * t_base_rx_25;
  const Scalar t_left_hip_block_6 = t_left_hip_block_4 - t_left_hip_block_5;
  const Scalar t_left_hip_block_7 = c_left_hip_yaw * t_left_hip_block_3;
  const Scalar t_left_hip_block_8 = s_left_hip_yaw * t_left_hip_block_6;
  const Scalar t_left_hip_block_9 = t_left_hip_block_7 - t_left_hip_block_8;
  w[53] = t_left_hip_block_9;
  const Scalar t_left_hip_block_10 = c_left_hip_yaw * t_left_hip_block_6;
  const Scalar t_left_hip_block_11 = s_left_hip_yaw * t_left_hip_block_3;
  const Scalar zeta_left_hip_block_y = t_left_hip_block_10 + t_left_hip_block_11;
  w[54] = zeta_left_hip_block_y;
  const Scalar t_left_hip_block_12 = left_hip_block_l2 * t_base_rx_21;
  const Scalar t_left_hip_block_13 = left_hip_block_l1 * t_base_rx_22;
  const Scalar zeta_left_hip_block_z = t_left_hip_block_12 + t_left_hip_block_13;
  w[55] = zeta_left_hip_block_z;
  const Scalar t_left_hip_block_14 = c_left_hip_yaw * omega_base_rx_z;
  const Scalar t_left_hip_block_15 = s_left_hip_yaw * t_base_rx_13 + t_left_hip_block_14;
  const Scalar t_left_hip_block_16 = t_left_hip_block_15 * qd[6];
  w[56] = t_left_hip_block_16;
  const Scalar t_left_hip_block_17 = s_left_hip_yaw * omega_base_rx_z;
  const Scalar omega_left_hip_block_x = c_left_hip_yaw * t_base_rx_13 - t_left_hip_block_17;
  const Scalar t_left_hip_block_18 = qd[6] * omega_left_hip_block_x;
  w[57] = t_left_hip_block_18;
  const Scalar omega_left_hip_block_z = t_base_rx_16 + qd[6];
  // left_hip_fork
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * omega_left_hip_block_x;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_1 + t_left_hip_fork_2;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 * t_left_hip_fork_3;
  w[58] = t_left_hip_fork_4;
  const Scalar t_left_hip_fork_5 = c_left_hip_roll * omega_left_hip_block_z;
  const Scalar t_left_hip_fork_6 = s_left_hip_roll * omega_left_hip_block_x;
  const Scalar omega_left_hip_fork_x = t_left_hip_fork_5 - t_left_hip_fork_6;
  const Scalar t_left_hip_fork_7 = omega_left_hip_fork_x * omega_left_hip_fork_x;
  w[59] = t_left_hip_fork_7;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_4 + t_left_hip_fork_7;
  w[60] = t_left_hip_fork_8;
  // left_hip_block
  const Scalar t_left_hip_block_19 = t_left_hip_block_15 * omega_left_hip_block_x;
  w[61] = t_left_hip_block_19;
  const Scalar t_left_hip_block_20 = t_left_hip_block_15 * omega_left_hip_block_z;
  w[62] = t_left_hip_block_20;
  const Scalar t_left_hip_block_21 = omega_left_hip_block_z * omega_left_hip_block_z;
  const Scalar t_left_hip_block_22 = t_left_hip_block_15 * t_left_hip_block_15;
  const Scalar t_left_hip_block_23 = t_left_hip_block_22 + t_left_hip_block_21;
  w[63] = t_left_hip_block_23;
  const Scalar t_left_hip_block_24 = omega_left_hip_block_x * omega_left_hip_block_z;
  w[64] = t_left_hip_block_24;
  // left_hip_fork
  const Scalar t_left_hip_fork_9 = left_hip_fork_l1 * t_left_hip_block_19;
  const Scalar t_left_hip_fork_10 = left_hip_fork_l1 * t_left_hip_block_20;
  const Scalar t_left_hip_fork_11 = c_left_hip_roll * t_left_hip_fork_9;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_11 + s_left_hip_roll * t_left_hip_fork_10;
  w[65] = t_left_hip_fork_12;
  const Scalar t_left_hip_fork_13 = s_left_hip_roll * t_left_hip_fork_9;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_13 - c_left_hip_roll * t_left_hip_fork_10;
  w[66] = t_left_hip_fork_14;
  const Scalar t_left_hip_fork_15 = left_hip_fork_l1 * t_left_hip_fork_8;
  w[67] = t_left_hip_fork_15;
  const Scalar t_left_hip_fork_16 = omega_left_hip_fork_x * qd[7];
  w[68] = t_left_hip_fork_16;
  const Scalar t_left_hip_fork_17 = t_left_hip_fork_3 * qd[7];
  w[69] = t_left_hip_fork_17;
  const Scalar omega_left_hip_fork_z = t_left_hip_block_15 + qd[7];
  const Scalar t_left_hip_fork_18 = omega_left_hip_fork_z * omega_left_hip_fork_z;
  w[70] = t_left_hip_fork_18;
  const Scalar t_left_hip_fork_19 = t_left_hip_fork_3 * omega_left_hip_fork_x;
  w[71] = t_left_hip_fork_19;
  const Scalar t_left_hip_fork_20 = omega_left_hip_fork_x * omega_left_hip_fork_z;
  w[72] = t_left_hip_fork_20;
  const Scalar t_left_hip_fork_21 = t_left_hip_fork_7 + t_left_hip_fork_18;
  w[73] = t_left_hip_fork_21;
  const Scalar t_left_hip_fork_22 = t_left_hip_fork_3 * omega_left_hip_fork_z;
  w[74] = t_left_hip_fork_22;
  // left_thigh
  const Scalar t_left_thigh_1 = s_q8_q9_q10 * omega_left_hip_fork_z;
  const Scalar t_left_thigh_2 = t_left_thigh_1 + c_q8_q9_q10 * omega_left_hip_fork_x;
  const Scalar t_left_thigh_3 = t_left_thigh_2 * qd[8];
  w[75] = t_left_thigh_3;
  const Scalar t_left_thigh_4 = s_q8_q9_q10 * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_y = t_left_thigh_4 - c_q8_q9_q10 * omega_left_hip_fork_z;
  const Scalar t_left_thigh_5 = qd[8] * omega_left_thigh_y;
  w[76] = t_left_thigh_5;
  const Scalar omega_left_thigh_z = t_left_hip_fork_3 + qd[8];
  const Scalar t_left_thigh_6 = omega_left_thigh_y * omega_left_thigh_y;
  const Scalar t_left_thigh_7 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_8 = t_left_thigh_6 + t_left_thigh_7;
  w[77] = t_left_thigh_8;
  const Scalar t_left_thigh_9 = left_thigh_I12 * s_q9_q10 + left_thigh_I2 * c_q9_q10;
  const Scalar t_left_thigh_10 = left_thigh_I8 - c_q9_q10 * t_left_thigh_9;
  w[78] = t_left_thigh_10;
  const Scalar t_left_thigh_11 = t_left_thigh_2 * omega_left_thigh_y;
  w[79] = t_left_thigh_11;
  const Scalar t_left_thigh_12 = s_q9_q10 * t_left_thigh_9;
  const Scalar t_left_thigh_13 = left_thigh_I7 - t_left_thigh_12;
  w[80] = t_left_thigh_13;
  const Scalar t_left_thigh_14 = t_left_thigh_2 * omega_left_thigh_z;
  w[81] = t_left_thigh_14;
  const Scalar t_left_thigh_15 = left_thigh_I3 * s_q9_q10 - left_thigh_I4 * c_q9_q10;
  w[82] = t_left_thigh_15;
  const Scalar t_left_thigh_16 = t_left_thigh_2 * t_left_thigh_2;
  const Scalar t_left_thigh_17 = t_left_thigh_7 + t_left_thigh_16;
  w[83] = t_left_thigh_17;
  const Scalar t_left_thigh_18 = left_thigh_I11 - t_left_thigh_12;
  w[84] = t_left_thigh_18;
  const Scalar t_left_thigh_19 = omega_left_thigh_y * omega_left_thigh_z;
  w[85] = t_left_thigh_19;
  const Scalar t_left_thigh_20 = left_thigh_I3 * c_q9_q10 + left_thigh_I4 * s_q9_q10;
  w[86] = t_left_thigh_20;
  const Scalar t_left_thigh_21 = left_thigh_h2 * c_q9_q10;
  w[87] = t_left_thigh_21;
  const Scalar t_left_thigh_22 = left_thigh_h2 * s_q9_q10;
  w[88] = t_left_thigh_22;
  // left_shank
  const Scalar t_left_shank_2 = t_left_shank_1 * t_left_thigh_17;
  const Scalar t_left_shank_3 = s_left_shank_x * t_left_thigh_11 - t_left_shank_2;
  w[89] = t_left_shank_3;
  const Scalar t_left_shank_4 = t_left_shank_1 * t_left_thigh_11;
  const Scalar zeta_left_shank_x = t_left_shank_4 - s_left_shank_x * t_left_thigh_8;
  w[90] = zeta_left_shank_x;
  const Scalar t_left_shank_5 = t_left_shank_1 * t_left_thigh_19;
  const Scalar t_left_shank_6 = t_left_shank_5 + s_left_shank_x * t_left_thigh_14;
  w[91] = t_left_shank_6;
  const Scalar t_left_shank_7 = omega_left_thigh_y * qd[9];
  w[92] = t_left_shank_7;
  const Scalar t_left_shank_8 = t_left_thigh_2 * qd[9];
  w[93] = t_left_shank_8;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[9];
  const Scalar t_left_shank_9 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_10 = t_left_thigh_6 + t_left_shank_9;
  w[94] = t_left_shank_10;
  const Scalar t_left_shank_11 = left_shank_I12 * s_left_ankle_pitch;
  const Scalar t_left_shank_12 = left_shank_I1 * c_left_ankle_pitch + t_left_shank_11;
  const Scalar t_left_shank_13 = c_left_ankle_pitch * t_left_shank_12;
  w[95] = t_left_shank_13;
  const Scalar t_left_shank_14 = left_shank_I7 - t_left_shank_13;
  w[96] = t_left_shank_14;
  const Scalar t_left_shank_15 = s_left_ankle_pitch * t_left_shank_12;
  w[97] = t_left_shank_15;
  const Scalar t_left_shank_16 = t_left_thigh_14 + t_left_shank_8;
  w[98] = t_left_shank_16;
  const Scalar t_left_shank_17 = left_shank_I3 * c_left_ankle_pitch;
  const Scalar t_left_shank_18 = t_left_shank_17 - left_shank_I4 * s_left_ankle_pitch;
  w[99] = t_left_shank_18;
  const Scalar t_left_shank_19 = t_left_thigh_16 + t_left_shank_9;
  w[100] = t_left_shank_19;
  const Scalar t_left_shank_20 = left_shank_I11 - t_left_shank_15;
  w[101] = t_left_shank_20;
  const Scalar t_left_shank_21 = t_left_thigh_19 + t_left_shank_7;
  w[102] = t_left_shank_21;
  const Scalar t_left_shank_22 = left_shank_I3 * s_left_ankle_pitch;
  const Scalar t_left_shank_23 = t_left_shank_22 + left_shank_I4 * c_left_ankle_pitch;
  w[103] = t_left_shank_23;
  const Scalar t_left_shank_24 = left_shank_h1 * s_left_ankle_pitch;
  w[104] = t_left_shank_24;
  const Scalar t_left_shank_25 = left_shank_h1 * c_left_ankle_pitch;
  w[105] = t_left_shank_25;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_2 = t_left_ankle_cross_1 * t_left_thigh_11;
  const Scalar t_left_ankle_cross_3 = s_left_ankle_cross_x * t_left_shank_10;
  const Scalar zeta_left_ankle_cross_x = t_left_ankle_cross_2 - t_left_ankle_cross_3;
  w[106] = zeta_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = t_left_ankle_cross_1 * t_left_shank_19;
  const Scalar t_left_ankle_cross_5 = s_left_ankle_cross_x * t_left_thigh_11;
  const Scalar t_left_ankle_cross_6 = t_left_ankle_cross_5 - t_left_ankle_cross_4;
  w[107] = t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_7 = t_left_ankle_cross_1 * t_left_shank_21;
  const Scalar t_left_ankle_cross_8 = s_left_ankle_cross_x * t_left_shank_16;
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_7 + t_left_ankle_cross_8;
  w[108] = t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_10 = omega_left_thigh_y * qd[10];
  w[109] = t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_11 = t_left_thigh_2 * qd[10];
  w[110] = t_left_ankle_cross_11;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[10];
  const Scalar t_left_ankle_cross_12 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_13 = t_left_thigh_16 + t_left_ankle_cross_12;
  w[111] = t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_14 = t_left_shank_21 + t_left_ankle_cross_10;
  w[112] = t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_15 = t_left_thigh_6 + t_left_ankle_cross_12;
  w[113] = t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_16 = t_left_shank_16 + t_left_ankle_cross_11;
  w[114] = t_left_ankle_cross_16;
  // left_foot
  const Scalar t_left_foot_2 = left_hip_fork_l1 * t_left_ankle_cross_15;
  const Scalar t_left_foot_3 = left_hip_fork_l1 * t_left_ankle_cross_16;
  const Scalar t_left_foot_4 = t_left_foot_2 + left_hip_fork_l3 * t_left_ankle_cross_16;
  const Scalar t_left_foot_5 = left_hip_fork_l3 * t_left_hip_fork_21 + t_left_foot_3;
  const Scalar zeta_left_foot_y = s_left_foot * t_left_foot_4 - c_left_foot * t_left_foot_5;
  w[115] = zeta_left_foot_y;
  const Scalar t_left_foot_6 = s_left_foot * omega_left_ankle_cross_z;
  const Scalar t_left_foot_7 = c_left_foot * t_left_thigh_2 - t_left_foot_6;
  w[116] = t_left_foot_7;
  const Scalar t_left_foot_8 = t_left_foot_7 * qd[11];
  w[117] = t_left_foot_8;
  const Scalar t_left_foot_9 = c_left_foot * omega_left_ankle_cross_z;
  const Scalar omega_left_foot_y = s_left_foot * t_left_thigh_2 + t_left_foot_9;
  const Scalar t_left_foot_10 = qd[11] * omega_left_foot_y;
  w[118] = t_left_foot_10;
  const Scalar t_left_foot_11 = omega_left_thigh_y - qd[11];
  const Scalar t_left_foot_12 = t_left_foot_11 * t_left_foot_11;
  w[119] = t_left_foot_12;
  const Scalar t_left_foot_13 = t_left_foot_7 * omega_left_foot_y;
  w[120] = t_left_foot_13;
  const Scalar t_left_foot_14 = omega_left_foot_y * t_left_foot_11;
  w[121] = t_left_foot_14;
  const Scalar t_left_foot_15 = t_left_foot_12 + omega_left_foot_y * omega_left_foot_y;
  w[122] = t_left_foot_15;
  const Scalar t_left_foot_16 = t_left_foot_7 * t_left_foot_11;
  w[123] = t_left_foot_16;
  // right_hip_block
  const Scalar t_right_hip_block_1 = t_left_hip_block_1 - t_left_hip_block_2;
  const Scalar t_right_hip_block_2 = t_left_hip_block_4 + t_left_hip_block_5;
  const Scalar t_right_hip_block_3 = c_right_hip_yaw * t_right_hip_block_2;
  const Scalar t_right_hip_block_4 = s_right_hip_yaw * t_right_hip_block_1;
  const Scalar zeta_right_hip_block_y = t_right_hip_block_3 - t_right_hip_block_4;
  w[124] = zeta_right_hip_block_y;
  const Scalar t_right_hip_block_5 = c_right_hip_yaw * t_right_hip_block_1;
  const Scalar t_right_hip_block_6 = s_right_hip_yaw * t_right_hip_block_2;
  const Scalar zeta_right_hip_block_x = t_right_hip_block_5 + t_right_hip_block_6;
  w[125] = zeta_right_hip_block_x;
  const Scalar zeta_right_hip_block_z = t_left_hip_block_12 - t_left_hip_block_13;
  w[126] = zeta_right_hip_block_z;
}

[[gnu::noinline]] void forward_dynamics_2(const Scalar qd[18], const Scalar tau[18],
                                          Scalar w[278]) noexcept {
  // right_hip_block
  const Scalar s_right_hip_yaw = w[15];
  const Scalar omega_base_rx_z = w[45];
  const Scalar t_right_hip_block_7 = s_right_hip_yaw * omega_base_rx_z;
  const Scalar c_right_hip_yaw = w[16];
  const Scalar t_base_rx_13 = w[40];
  const Scalar omega_right_hip_block_x = c_right_hip_yaw * t_base_rx_13 - t_right_hip_block_7;
  const Scalar t_right_hip_block_8 = omega_right_hip_block_x * qd[12];
  w[127] = t_right_hip_block_8;
  const Scalar t_right_hip_block_9 = c_right_hip_yaw * omega_base_rx_z;
  const Scalar t_right_hip_block_10 = t_right_hip_block_9 + s_right_hip_yaw * t_base_rx_13;
  const Scalar t_right_hip_block_11 = qd[12] * t_right_hip_block_10;
  w[128] = t_right_hip_block_11;
  const Scalar t_base_rx_16 = w[42];
  const Scalar omega_right_hip_block_z = t_base_rx_16 + qd[12];
  const Scalar t_right_hip_block_12 = omega_right_hip_block_z * omega_right_hip_block_z;
  const Scalar t_right_hip_block_13 = t_right_hip_block_10 * t_right_hip_block_10;
  const Scalar t_right_hip_block_14 = t_right_hip_block_12 + t_right_hip_block_13;
  w[129] = t_right_hip_block_14;
  const Scalar t_right_hip_block_15 = omega_right_hip_block_x * t_right_hip_block_10;
  w[130] = t_right_hip_block_15;
  const Scalar t_right_hip_block_16 = omega_right_hip_block_x * omega_right_hip_block_z;
  w[131] = t_right_hip_block_16;
  // right_hip_fork
  const Scalar s_right_hip_roll = w[17];
  const Scalar t_right_hip_fork_1 = s_right_hip_roll * omega_right_hip_block_z;
  const Scalar c_right_hip_roll = w[18];
  const Scalar t_right_hip_fork_2 = c_right_hip_roll * omega_right_hip_block_x;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_1 + t_right_hip_fork_2;
  const Scalar t_right_hip_fork_4 = c_right_hip_roll * omega_right_hip_block_z;
  const Scalar t_right_hip_fork_5 = s_right_hip_roll * omega_right_hip_block_x;
  const Scalar omega_right_hip_fork_x = t_right_hip_fork_4 - t_right_hip_fork_5;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_3 * t_right_hip_fork_3;
  const Scalar t_right_hip_fork_7 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_block_17 = t_right_hip_fork_6 + t_right_hip_fork_7;
  w[132] = t_right_hip_block_17;
  const Scalar t_right_hip_block_18 = t_right_hip_block_10 * omega_right_hip_block_z;
  w[133] = t_right_hip_block_18;
  const Scalar t_right_hip_fork_8 = left_hip_fork_l1 * t_right_hip_block_18;
  const Scalar t_right_hip_fork_9 = left_hip_fork_l1 * t_right_hip_block_15;
  const Scalar t_right_hip_fork_10 = s_right_hip_roll * t_right_hip_fork_8;
  const Scalar t_right_hip_fork_11 = c_right_hip_roll * t_right_hip_fork_9;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_10 + t_right_hip_fork_11;
  w[134] = t_right_hip_fork_12;
  const Scalar t_right_hip_fork_13 = c_right_hip_roll * t_right_hip_fork_8;
  const Scalar t_right_hip_fork_14 = s_right_hip_roll * t_right_hip_fork_9;
  const Scalar zeta_right_hip_fork_x = t_right_hip_fork_13 - t_right_hip_fork_14;
  w[135] = zeta_right_hip_fork_x;
  const Scalar t_right_hip_fork_15 = omega_right_hip_fork_x * qd[13];
  w[136] = t_right_hip_fork_15;
  const Scalar t_right_hip_fork_16 = left_hip_fork_l1 * t_right_hip_block_17;
  w[137] = t_right_hip_fork_16;
  const Scalar t_right_hip_fork_17 = t_right_hip_fork_3 * qd[13];
  w[138] = t_right_hip_fork_17;
  const Scalar omega_right_hip_fork_z = t_right_hip_block_10 + qd[13];
  const Scalar t_right_hip_fork_18 = omega_right_hip_fork_z * omega_right_hip_fork_z;
  const Scalar t_right_hip_fork_19 = t_right_hip_fork_6 + t_right_hip_fork_18;
  w[139] = t_right_hip_fork_19;
  const Scalar t_right_hip_fork_20 = t_right_hip_fork_3 * omega_right_hip_fork_x;
  w[140] = t_right_hip_fork_20;
  const Scalar t_right_hip_fork_21 = omega_right_hip_fork_x * omega_right_hip_fork_z;
  w[141] = t_right_hip_fork_21;
  const Scalar t_right_thigh_1 = t_right_hip_fork_7 + t_right_hip_fork_18;
  w[142] = t_right_thigh_1;
  const Scalar t_right_hip_fork_22 = t_right_hip_fork_3 * omega_right_hip_fork_z;
  w[143] = t_right_hip_fork_22;
  // right_thigh
  const Scalar s_q14_q15_q16 = w[19];
  const Scalar t_right_thigh_2 = s_q14_q15_q16 * omega_right_hip_fork_x;
  const Scalar c_q14_q15_q16 = w[20];
  const Scalar omega_right_thigh_y = t_right_thigh_2 - c_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar t_right_thigh_3 = omega_right_thigh_y * qd[14];
  w[144] = t_right_thigh_3;
  const Scalar t_right_thigh_4 = c_q14_q15_q16 * omega_right_hip_fork_x;
  const Scalar t_right_thigh_5 = t_right_thigh_4 + s_q14_q15_q16 * omega_right_hip_fork_z;
  const Scalar t_right_thigh_6 = qd[14] * t_right_thigh_5;
  w[145] = t_right_thigh_6;
  const Scalar omega_right_thigh_z = t_right_hip_fork_3 + qd[14];
  const Scalar t_right_thigh_7 = t_right_thigh_5 * t_right_thigh_5;
  const Scalar t_right_thigh_8 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_9 = t_right_thigh_7 + t_right_thigh_8;
  w[146] = t_right_thigh_9;
  const Scalar s_q15_q16 = w[21];
  const Scalar c_q15_q16 = w[22];
  const Scalar t_right_thigh_10 = left_thigh_I12 * s_q15_q16 + left_thigh_I2 * c_q15_q16;
  const Scalar t_right_thigh_11 = left_thigh_I8 - c_q15_q16 * t_right_thigh_10;
  w[147] = t_right_thigh_11;
  const Scalar t_right_thigh_12 = omega_right_thigh_y * t_right_thigh_5;
  w[148] = t_right_thigh_12;
  const Scalar t_right_thigh_13 = s_q15_q16 * t_right_thigh_10;
  const Scalar t_right_thigh_14 = left_thigh_I11 - t_right_thigh_13;
  w[149] = t_right_thigh_14;
  const Scalar t_right_thigh_15 = omega_right_thigh_y * omega_right_thigh_z;
  w[150] = t_right_thigh_15;
  const Scalar t_right_thigh_16 = left_thigh_I3 * c_q15_q16 + left_thigh_I4 * s_q15_q16;
  w[151] = t_right_thigh_16;
  const Scalar t_right_thigh_17 = omega_right_thigh_y * omega_right_thigh_y;
  const Scalar t_right_thigh_18 = t_right_thigh_8 + t_right_thigh_17;
  w[152] = t_right_thigh_18;
  const Scalar t_right_thigh_19 = left_thigh_I7 - t_right_thigh_13;
  w[153] = t_right_thigh_19;
  const Scalar t_right_thigh_20 = t_right_thigh_5 * omega_right_thigh_z;
  w[154] = t_right_thigh_20;
  const Scalar t_right_thigh_21 = left_thigh_I3 * s_q15_q16 - left_thigh_I4 * c_q15_q16;
  w[155] = t_right_thigh_21;
  const Scalar t_right_thigh_22 = left_thigh_h2 * c_q15_q16;
  w[156] = t_right_thigh_22;
  const Scalar t_right_thigh_23 = left_thigh_h2 * s_q15_q16;
  w[157] = t_right_thigh_23;
  // right_shank
  const Scalar t_right_shank_1 = w[24];
  const Scalar t_right_shank_2 = t_right_shank_1 * t_right_thigh_9;
  const Scalar s_right_shank_x = w[23];
  const Scalar t_right_shank_3 = s_right_shank_x * t_right_thigh_12 - t_right_shank_2;
  w[158] = t_right_shank_3;
  const Scalar t_right_shank_4 = t_right_shank_1 * t_right_thigh_12;
  const Scalar zeta_right_shank_x = t_right_shank_4 - s_right_shank_x * t_right_thigh_18;
  w[159] = zeta_right_shank_x;
  const Scalar t_right_shank_5 = t_right_shank_1 * t_right_thigh_15;
  const Scalar t_right_shank_6 = t_right_shank_5 + s_right_shank_x * t_right_thigh_20;
  w[160] = t_right_shank_6;
  const Scalar t_right_shank_7 = omega_right_thigh_y * qd[15];
  w[161] = t_right_shank_7;
  const Scalar t_right_shank_8 = t_right_thigh_5 * qd[15];
  w[162] = t_right_shank_8;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[15];
  const Scalar t_right_shank_9 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_10 = t_right_thigh_17 + t_right_shank_9;
  w[163] = t_right_shank_10;
  const Scalar s_right_ankle_pitch = w[25];
  const Scalar t_right_shank_11 = left_shank_I12 * s_right_ankle_pitch;
  const Scalar c_right_ankle_pitch = w[26];
  const Scalar t_right_shank_12 = left_shank_I1 * c_right_ankle_pitch + t_right_shank_11;
  const Scalar t_right_shank_13 = c_right_ankle_pitch * t_right_shank_12;
  w[164] = t_right_shank_13;
  const Scalar t_right_shank_14 = left_shank_I7 - t_right_shank_13;
  w[165] = t_right_shank_14;
  const Scalar t_right_shank_15 = s_right_ankle_pitch * t_right_shank_12;
  w[166] = t_right_shank_15;
  const Scalar t_right_shank_16 = left_shank_I8 - t_right_shank_15;
  w[167] = t_right_shank_16;
  const Scalar t_right_shank_17 = t_right_thigh_20 + t_right_shank_8;
  w[168] = t_right_shank_17;
  const Scalar t_right_shank_18 = left_shank_I4 * s_right_ankle_pitch;
  const Scalar t_right_shank_19 = t_right_shank_18 - left_shank_I3 * c_right_ankle_pitch;
  w[169] = t_right_shank_19;
  const Scalar t_right_shank_20 = t_right_thigh_7 + t_right_shank_9;
  w[170] = t_right_shank_20;
  const Scalar t_right_shank_21 = t_right_thigh_15 + t_right_shank_7;
  w[171] = t_right_shank_21;
  const Scalar t_right_shank_22 = left_shank_I3 * s_right_ankle_pitch;
  const Scalar t_right_shank_23 = t_right_shank_22 + left_shank_I4 * c_right_ankle_pitch;
  w[172] = t_right_shank_23;
  const Scalar t_right_shank_24 = left_shank_h1 * c_right_ankle_pitch;
  w[173] = t_right_shank_24;
  const Scalar t_right_shank_25 = left_shank_h1 * s_right_ankle_pitch;
  w[174] = t_right_shank_25;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_1 = w[27];
  const Scalar t_righ_ankl_cros_2 = t_righ_ankl_cros_1 * t_right_shank_20;
  const Scalar s_righ_ankl_cros_x = w[28];
  const Scalar t_righ_ankl_cros_3 = s_righ_ankl_cros_x * t_right_thigh_12;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 - t_righ_ankl_cros_2;
  w[175] = t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_5 = t_righ_ankl_cros_1 * t_right_thigh_12;
  const Scalar t_righ_ankl_cros_6 = s_righ_ankl_cros_x * t_right_shank_10;
  const Scalar t_righ_ankl_cros_7 = t_righ_ankl_cros_6 - t_righ_ankl_cros_5;
  w[176] = t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_1 * t_right_shank_21;
  const Scalar t_righ_ankl_cros_9 = s_righ_ankl_cros_x * t_right_shank_17;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_8 + t_righ_ankl_cros_9;
  w[177] = t_righ_ankl_cros_10;
  const Scalar t_righ_ankl_cros_11 = omega_right_thigh_y * qd[16];
  w[178] = t_righ_ankl_cros_11;
  const Scalar t_righ_ankl_cros_12 = t_right_thigh_5 * qd[16];
  w[179] = t_righ_ankl_cros_12;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[16];
  const Scalar t_righ_ankl_cros_13 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_14 = t_right_thigh_7 + t_righ_ankl_cros_13;
  w[180] = t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_15 = omega_right_thigh_y * omega_righ_ankl_cros_z;
  w[181] = t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_16 = t_right_thigh_17 + t_righ_ankl_cros_13;
  w[182] = t_righ_ankl_cros_16;
  const Scalar t_righ_ankl_cros_17 = t_right_shank_17 + t_righ_ankl_cros_12;
  w[183] = t_righ_ankl_cros_17;
  // right_foot
  const Scalar t_right_foot_2 = left_hip_fork_l1 * t_righ_ankl_cros_17;
  const Scalar t_right_foot_3 = left_hip_fork_l1 * t_righ_ankl_cros_16;
  const Scalar t_right_foot_4 = left_hip_fork_l3 * t_right_thigh_1 - t_right_foot_2;
  const Scalar t_right_foot_5 = t_right_foot_3 - left_hip_fork_l3 * t_righ_ankl_cros_17;
  const Scalar c_right_foot = w[30];
  const Scalar t_right_foot_6 = c_right_foot * t_right_foot_4;
  const Scalar s_right_foot = w[29];
  const Scalar zeta_right_foot_y = t_right_foot_6 - s_right_foot * t_right_foot_5;
  w[184] = zeta_right_foot_y;
  const Scalar t_right_foot_7 = s_right_foot * omega_righ_ankl_cros_z;
  const Scalar t_right_foot_8 = t_right_foot_7 + c_right_foot * t_right_thigh_5;
  const Scalar t_right_foot_9 = t_right_foot_8 * qd[17];
  w[185] = t_right_foot_9;
  const Scalar t_right_foot_10 = c_right_foot * omega_righ_ankl_cros_z;
  const Scalar omega_right_foot_y = t_right_foot_10 - s_right_foot * t_right_thigh_5;
  const Scalar t_right_foot_11 = qd[17] * omega_right_foot_y;
  w[186] = t_right_foot_11;
  const Scalar t_right_foot_12 = left_hip_fork_l3 * t_righ_ankl_cros_15;
  const Scalar zeta_right_foot_z = t_right_foot_12 + left_hip_fork_l1 * t_right_thigh_12;
  const Scalar t_right_foot_13 = omega_right_thigh_y - qd[17];
  const Scalar t_right_foot_14 = t_right_foot_13 * t_right_foot_13;
  const Scalar t_right_foot_15 = t_right_foot_8 * omega_right_foot_y;
  const Scalar t_right_foot_16 = omega_right_foot_y * t_right_foot_13;
  const Scalar t_right_foot_17 = t_right_foot_8 * t_right_foot_13;
  const Scalar t_right_foot_18 = t_right_foot_14 + omega_right_foot_y * omega_right_foot_y;
  const Scalar t_right_foot_19 = t_right_foot_14 + t_right_foot_8 * t_right_foot_8;
  const Scalar t_right_foot_20 = tau[17] + left_foot_I2 * t_right_foot_16;
  const Scalar t_right_foot_21 = t_right_foot_20 - left_foot_I1 * t_right_foot_17;
  const Scalar t_right_foot_22 = left_foot_I14 * (t_right_foot_18 - t_right_foot_19);
  const Scalar t_right_foot_23 = t_right_foot_21 + left_foot_I4 * t_right_foot_15;
  const Scalar u_right_foot = t_right_foot_23 + t_right_foot_22;
  w[187] = u_right_foot;
  const Scalar t_right_foot_24 = left_foot_h1 * t_right_foot_15 - left_foot_p2 * u_right_foot;
  const Scalar t_right_foot_25 = t_right_foot_24 + left_foot_m1 * zeta_right_foot_y;
  const Scalar t_right_foot_26 = t_right_foot_25 - left_foot_h2 * t_right_foot_11;
  const Scalar t_right_foot_27 = t_right_foot_26 + left_foot_h3 * t_right_foot_9;
  w[188] = t_right_foot_27;
  const Scalar t_right_foot_28 = left_foot_h1 * t_right_foot_18;
  w[189] = t_right_foot_28;
  const Scalar t_right_foot_29 = left_foot_I12 * t_right_foot_17;
  const Scalar t_right_foot_30 = left_foot_I1 * t_right_foot_15 - t_right_foot_29;
  const Scalar t_right_foot_31 = t_right_foot_30 - left_foot_I14 * t_right_foot_16;
  const Scalar t_right_foot_32 = t_right_foot_31 + left_foot_k2 * u_right_foot;
  const Scalar t_right_foot_33 = t_right_foot_32 - left_foot_h1 * zeta_right_foot_z;
  const Scalar t_right_foot_34 = t_right_foot_33 + left_foot_I15 * t_right_foot_9;
  const Scalar t_right_foot_35 = left_foot_I2 * (t_righ_ankl_cros_14 - t_right_foot_18);
  const Scalar t_right_foot_36 = t_right_foot_34 + left_foot_I16 * t_right_foot_11;
  const Scalar t_right_foot_37 = t_right_foot_36 + t_right_foot_35;
  const Scalar t_right_foot_38 = t_right_foot_37 - left_foot_h3 * zeta_right_foot_y;
  w[190] = t_right_foot_38;
  const Scalar t_right_foot_39 = left_foot_I13 * t_right_foot_16;
  const Scalar t_right_foot_40 = t_right_foot_39 + left_foot_I14 * t_right_foot_17;
  const Scalar t_right_foot_41 = t_right_foot_40 - left_foot_I2 * t_right_foot_15;
  const Scalar t_right_foot_42 = t_right_foot_41 + left_foot_k3 * u_right_foot;
  const Scalar t_right_foot_43 = t_right_foot_42 + left_foot_I17 * t_right_foot_11;
  const Scalar t_right_foot_44 = left_foot_I1 * (t_righ_ankl_cros_14 - t_right_foot_19);
  const Scalar t_right_foot_45 = t_right_foot_43 - left_foot_I16 * t_right_foot_9;
  const Scalar t_right_foot_46 = t_right_foot_45 - t_right_foot_44;
  const Scalar t_right_foot_47 = t_right_foot_46 - left_foot_h2 * zeta_right_foot_y;
  w[191] = t_right_foot_47;
  const Scalar t_right_foot_48 = t_right_foot_9 - t_right_foot_17;
  w[192] = t_right_foot_48;
  const Scalar t_right_foot_49 = left_foot_m1 * s_right_foot;
  const Scalar t_right_foot_50 = s_right_foot * t_right_foot_49;
  w[193] = t_right_foot_50;
  const Scalar t_right_foot_51 = c_right_foot * t_right_foot_49;
  w[194] = t_right_foot_51;
  const Scalar t_right_foot_52 = left_hip_fork_l1 * t_right_foot_50;
  const Scalar t_right_foot_53 = t_right_foot_52 - left_hip_fork_l3 * t_right_foot_51;
  w[195] = t_right_foot_53;
  const Scalar t_right_foot_54 = left_hip_fork_l3 * t_right_foot_50;
  const Scalar t_right_foot_55 = t_right_foot_54 + left_hip_fork_l1 * t_right_foot_51;
  w[196] = t_right_foot_55;
  const Scalar t_right_foot_56 = left_foot_h3 * s_right_foot - left_foot_h2 * c_right_foot;
  const Scalar t_right_foot_57 = s_right_foot * t_right_foot_56;
  w[197] = t_right_foot_57;
  const Scalar t_right_foot_58 = left_foot_h3 - t_right_foot_57;
  w[198] = t_right_foot_58;
  const Scalar t_right_foot_59 = c_right_foot * t_right_foot_56;
  w[199] = t_right_foot_59;
  const Scalar t_right_foot_60 = left_ankle_cross_I16 + left_hip_fork_l1 * t_right_foot_57;
  const Scalar t_right_foot_61 = t_right_foot_60 - left_hip_fork_l3 * t_right_foot_59;
  w[200] = t_right_foot_61;
  const Scalar t_right_foot_62 = left_foot_I18 * c_right_foot + left_foot_I19 * s_right_foot;
  const Scalar t_right_foot_63 = s_right_foot * t_right_foot_62;
  w[201] = t_right_foot_63;
  const Scalar t_right_foot_64 = left_ankle_cross_I12 + left_foot_I6 * s_right_foot;
  const Scalar t_right_foot_65 = c_right_foot * (left_foot_I7 + t_right_foot_62);
  const Scalar t_right_foot_66 = t_right_foot_64 + t_right_foot_65;
  w[202] = t_right_foot_66;
  const Scalar t_right_foot_67 = left_ankle_cross_I13 - t_right_foot_63;
  const Scalar t_right_foot_68 = t_right_foot_67 + left_foot_I5 * c_right_foot;
  w[203] = t_right_foot_68;
  const Scalar t_right_foot_69 = left_ankle_cross_h3 - t_right_foot_59;
  w[204] = t_right_foot_69;
  const Scalar t_right_foot_70 = left_ankle_cross_h1 + left_foot_h1 * c_right_foot;
  w[205] = t_right_foot_70;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_18 = t_right_thigh_7 - t_right_thigh_17;
  w[206] = t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_19 = tau[16] + left_ankle_cross_I11 * t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_20 = t_righ_ankl_cros_19 - c_right_foot * t_right_foot_38;
  const Scalar t_righ_ankl_cros_21 = left_ankle_cross_I14 * t_right_thigh_12;
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_20 - t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_23 = left_ankle_cross_I1 * t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_24 = t_righ_ankl_cros_22 - t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_25 = left_ankle_cross_I6 * t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_26 = t_righ_ankl_cros_24 - t_righ_ankl_cros_25;
  const Scalar t_righ_ankl_cros_27 = t_righ_ankl_cros_26 - left_foot_I6 * t_right_foot_48;
  const Scalar u_righ_ankl_cros = t_righ_ankl_cros_27 - s_right_foot * t_right_foot_47;
  w[207] = u_righ_ankl_cros;
  const Scalar t_righ_ankl_cros_28 = 1.0 / t_right_foot_68;
  w[208] = t_righ_ankl_cros_28;
  const Scalar t_righ_ankl_cros_29 = t_right_foot_70 * t_righ_ankl_cros_28;
  w[209] = t_righ_ankl_cros_29;
  const Scalar t_righ_ankl_cros_30 = t_right_foot_70 * t_righ_ankl_cros_29;
  w[210] = t_righ_ankl_cros_30;
  const Scalar t_righ_ankl_cros_31 = left_shank_m2 - t_righ_ankl_cros_30;
  w[211] = t_righ_ankl_cros_31;
  const Scalar t_righ_ankl_cros_32 = t_right_foot_69 * t_righ_ankl_cros_28;
  w[212] = t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_33 = t_right_foot_70 * t_righ_ankl_cros_32;
  w[213] = t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_34 = t_right_foot_58 * t_righ_ankl_cros_28;
  w[214] = t_righ_ankl_cros_34;
  const Scalar t_righ_ankl_cros_35 = t_right_foot_70 * t_righ_ankl_cros_34;
  w[215] = t_righ_ankl_cros_35;
  const Scalar t_righ_ankl_cros_36 = t_right_foot_66 * t_righ_ankl_cros_28;
  w[216] = t_righ_ankl_cros_36;
}

[[gnu::noinline]] void forward_dynamics_3(const Scalar tau[18], Scalar w[278]) noexcept {
  // right_ankle_cross
  const Scalar t_right_foot_70 = w[205];
  const Scalar t_righ_ankl_cros_36 = w[216];
  const Scalar t_righ_ankl_cros_37 = t_right_foot_70 * t_righ_ankl_cros_36;
  const Scalar s_right_foot = w[29];
  const Scalar t_righ_ankl_cros_38 = left_foot_h1 * s_right_foot - t_righ_ankl_cros_37;
  const Scalar t_right_foot_61 = w[200];
  const Scalar t_righ_ankl_cros_29 = w[209];
  const Scalar t_righ_ankl_cros_39 = t_right_foot_61 * t_righ_ankl_cros_29;
  const Scalar t_right_foot_69 = w[204];
  const Scalar t_righ_ankl_cros_32 = w[212];
  const Scalar t_righ_ankl_cros_40 = t_right_foot_69 * t_righ_ankl_cros_32;
  const Scalar t_right_foot_50 = w[193];
  const Scalar t_righ_ankl_cros_41 = t_right_foot_50 + t_righ_ankl_cros_40;
  const Scalar t_righ_ankl_cros_42 = left_shank_m2 - t_righ_ankl_cros_41;
  const Scalar t_righ_ankl_cros_34 = w[214];
  const Scalar t_righ_ankl_cros_43 = t_right_foot_69 * t_righ_ankl_cros_34;
  const Scalar t_right_foot_51 = w[194];
  const Scalar t_righ_ankl_cros_44 = t_right_foot_51 - t_righ_ankl_cros_43;
  const Scalar t_righ_ankl_cros_45 = t_right_foot_69 * t_righ_ankl_cros_36;
  const Scalar t_right_foot_57 = w[197];
  const Scalar t_righ_ankl_cros_46 = t_right_foot_57 + t_righ_ankl_cros_45;
  const Scalar t_righ_ankl_cros_47 = t_right_foot_61 * t_righ_ankl_cros_32;
  const Scalar t_right_foot_55 = w[196];
  const Scalar t_righ_ankl_cros_48 = t_right_foot_55 + t_righ_ankl_cros_47;
  const Scalar t_righ_ankl_cros_28 = w[208];
  const Scalar t_righ_ankl_cros_49 = t_right_foot_61 * t_righ_ankl_cros_28;
  w[21] = t_righ_ankl_cros_49;
  // right_foot
  const Scalar c_right_foot = w[30];
  const Scalar t_right_foot_28 = w[189];
  const Scalar t_right_foot_71 = c_right_foot * t_right_foot_28;
  const Scalar t_right_foot_27 = w[188];
  const Scalar t_right_foot_72 = t_right_foot_71 + s_right_foot * t_right_foot_27;
  const Scalar t_right_thigh_12 = w[148];
  const Scalar t_right_foot_73 = t_right_foot_72 - left_ankle_cross_h2 * t_right_thigh_12;
  const Scalar t_righ_ankl_cros_16 = w[182];
  const Scalar t_right_foot_74 = t_right_foot_73 + left_ankle_cross_h1 * t_righ_ankl_cros_16;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_4 = w[175];
  const Scalar t_righ_ankl_cros_33 = w[213];
  const Scalar t_righ_ankl_cros_50 = t_righ_ankl_cros_4 * t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_11 = w[178];
  const Scalar t_righ_ankl_cros_51 = t_righ_ankl_cros_11 * t_righ_ankl_cros_46;
  const Scalar t_righ_ankl_cros_52 = t_right_foot_74 - t_righ_ankl_cros_50;
  const Scalar t_righ_ankl_cros_53 = t_righ_ankl_cros_52 + t_righ_ankl_cros_51;
  const Scalar t_righ_ankl_cros_12 = w[179];
  const Scalar t_righ_ankl_cros_54 = t_righ_ankl_cros_12 * t_righ_ankl_cros_48;
  const Scalar t_righ_ankl_cros_55 = t_righ_ankl_cros_53 - t_righ_ankl_cros_54;
  const Scalar t_righ_ankl_cros_7 = w[176];
  const Scalar t_righ_ankl_cros_56 = t_righ_ankl_cros_7 * t_righ_ankl_cros_42;
  const Scalar t_righ_ankl_cros_57 = t_righ_ankl_cros_55 + t_righ_ankl_cros_56;
  const Scalar u_righ_ankl_cros = w[207];
  const Scalar t_righ_ankl_cros_58 = u_righ_ankl_cros * t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_59 = t_righ_ankl_cros_57 - t_righ_ankl_cros_58;
  const Scalar t_righ_ankl_cros_10 = w[177];
  const Scalar t_righ_ankl_cros_60 = t_righ_ankl_cros_10 * t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_61 = t_righ_ankl_cros_59 - t_righ_ankl_cros_60;
  const Scalar t_right_foot_58 = w[198];
  const Scalar t_righ_ankl_cros_62 = t_right_foot_58 * t_righ_ankl_cros_34;
  const Scalar t_righ_ankl_cros_63 = t_right_foot_50 - t_righ_ankl_cros_62;
  const Scalar t_righ_ankl_cros_64 = left_shank_m3 + t_righ_ankl_cros_63;
  const Scalar t_righ_ankl_cros_65 = t_right_foot_58 * t_righ_ankl_cros_49;
  const Scalar t_right_foot_53 = w[195];
  const Scalar t_right_foot_75 = left_ankle_cross_h4 + t_right_foot_53;
  const Scalar t_righ_ankl_cros_66 = t_right_foot_75 + t_righ_ankl_cros_65;
  const Scalar t_right_foot_66 = w[202];
  const Scalar t_righ_ankl_cros_67 = t_right_foot_66 * t_righ_ankl_cros_34;
  const Scalar t_right_foot_59 = w[199];
  const Scalar t_right_foot_76 = left_ankle_cross_h2 + t_right_foot_59;
  const Scalar t_righ_ankl_cros_68 = t_right_foot_76 - t_righ_ankl_cros_67;
  const Scalar t_righ_ankl_cros_69 = u_righ_ankl_cros + t_righ_ankl_cros_4 * t_right_foot_70;
  w[22] = t_righ_ankl_cros_69;
  const Scalar t_right_foot_77 = s_right_foot * t_right_foot_28;
  const Scalar t_right_foot_78 = t_right_foot_77 - c_right_foot * t_right_foot_27;
  const Scalar t_righ_ankl_cros_15 = w[181];
  const Scalar t_righ_ankl_cros_70 = left_ankle_cross_h2 * t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_71 = t_righ_ankl_cros_12 * t_righ_ankl_cros_66;
  const Scalar t_righ_ankl_cros_72 = t_right_foot_78 - t_righ_ankl_cros_70;
  const Scalar t_righ_ankl_cros_73 = t_righ_ankl_cros_72 - t_righ_ankl_cros_71;
  const Scalar t_righ_ankl_cros_17 = w[183];
  const Scalar t_righ_ankl_cros_74 = left_ankle_cross_h1 * t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_75 = t_righ_ankl_cros_73 - t_righ_ankl_cros_74;
  const Scalar t_righ_ankl_cros_76 = t_righ_ankl_cros_7 * t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_77 = t_righ_ankl_cros_75 + t_righ_ankl_cros_76;
  const Scalar t_righ_ankl_cros_78 = t_righ_ankl_cros_34 * t_righ_ankl_cros_69;
  const Scalar t_righ_ankl_cros_79 = t_righ_ankl_cros_77 - t_righ_ankl_cros_78;
  const Scalar t_righ_ankl_cros_80 = t_righ_ankl_cros_11 * t_righ_ankl_cros_68;
  const Scalar t_righ_ankl_cros_81 = t_righ_ankl_cros_79 - t_righ_ankl_cros_80;
  const Scalar t_righ_ankl_cros_82 = t_righ_ankl_cros_10 * t_righ_ankl_cros_64;
  const Scalar t_righ_ankl_cros_83 = t_righ_ankl_cros_81 - t_righ_ankl_cros_82;
  const Scalar t_right_foot_79 = left_hip_fork_l1 * t_right_foot_59;
  const Scalar t_right_foot_80 = t_right_foot_79 + left_hip_fork_l3 * t_right_foot_57;
  const Scalar t_righ_ankl_cros_84 = t_right_foot_66 * t_righ_ankl_cros_49;
  const Scalar t_righ_ankl_cros_85 = t_right_foot_80 + t_righ_ankl_cros_84;
  const Scalar t_right_foot_63 = w[201];
  const Scalar t_right_foot_81 = left_ankle_cross_I17 + t_right_foot_63;
  const Scalar t_right_foot_82 = t_right_foot_81 + left_foot_I11 * s_right_foot;
  const Scalar t_righ_ankl_cros_86 = t_right_foot_66 * t_righ_ankl_cros_36;
  const Scalar t_righ_ankl_cros_87 = t_right_foot_82 - t_righ_ankl_cros_86;
  const Scalar t_righ_ankl_cros_1 = w[27];
  const Scalar t_righ_ankl_cros_88 = t_righ_ankl_cros_1 * t_righ_ankl_cros_64;
  const Scalar t_righ_ankl_cros_89 = t_righ_ankl_cros_68 + t_righ_ankl_cros_88;
  const Scalar s_righ_ankl_cros_x = w[28];
  const Scalar t_righ_ankl_cros_90 = s_righ_ankl_cros_x * t_righ_ankl_cros_64;
  const Scalar t_righ_ankl_cros_91 = t_righ_ankl_cros_66 + t_righ_ankl_cros_90;
  const Scalar t_righ_ankl_cros_35 = w[215];
  const Scalar t_righ_ankl_cros_92 = s_righ_ankl_cros_x * t_righ_ankl_cros_35;
  const Scalar t_righ_ankl_cros_93 = t_righ_ankl_cros_39 - t_righ_ankl_cros_92;
  const Scalar t_righ_ankl_cros_94 = s_righ_ankl_cros_x * t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_95 = t_righ_ankl_cros_48 + t_righ_ankl_cros_94;
  const Scalar t_righ_ankl_cros_96 = t_righ_ankl_cros_1 * t_righ_ankl_cros_95;
  const Scalar t_right_shank_19 = w[169];
  const Scalar t_righ_ankl_cros_97 = t_right_shank_19 - t_righ_ankl_cros_96;
  const Scalar t_righ_ankl_cros_98 = s_righ_ankl_cros_x * t_righ_ankl_cros_93;
  const Scalar t_righ_ankl_cros_99 = t_righ_ankl_cros_97 - t_righ_ankl_cros_98;
  w[25] = t_righ_ankl_cros_99;
  const Scalar t_righ_ankl_cros_100 = t_righ_ankl_cros_1 * t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_101 = t_righ_ankl_cros_1 * t_righ_ankl_cros_35;
  const Scalar t_righ_ankl_cros_102 = t_righ_ankl_cros_38 - t_righ_ankl_cros_101;
  const Scalar t_righ_ankl_cros_103 = t_righ_ankl_cros_46 - t_righ_ankl_cros_100;
  const Scalar t_righ_ankl_cros_104 = s_righ_ankl_cros_x * t_righ_ankl_cros_102;
  const Scalar t_righ_ankl_cros_105 = t_righ_ankl_cros_1 * t_righ_ankl_cros_103;
  const Scalar t_right_shank_23 = w[172];
  const Scalar t_righ_ankl_cros_106 = t_right_shank_23 + t_righ_ankl_cros_104;
  const Scalar t_righ_ankl_cros_107 = t_righ_ankl_cros_106 - t_righ_ankl_cros_105;
  w[26] = t_righ_ankl_cros_107;
  const Scalar t_righ_ankl_cros_108 = t_righ_ankl_cros_1 * t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_31 = w[211];
  const Scalar t_righ_ankl_cros_109 = s_righ_ankl_cros_x * t_righ_ankl_cros_31;
  const Scalar t_righ_ankl_cros_110 = t_righ_ankl_cros_109 - t_righ_ankl_cros_108;
  const Scalar t_righ_ankl_cros_111 = t_righ_ankl_cros_1 * t_righ_ankl_cros_42;
  const Scalar t_righ_ankl_cros_112 = s_righ_ankl_cros_x * t_righ_ankl_cros_33;
  const Scalar t_righ_ankl_cros_113 = t_righ_ankl_cros_111 - t_righ_ankl_cros_112;
  const Scalar t_right_shank_15 = w[166];
  const Scalar t_right_shank_26 = left_shank_I11 - t_right_shank_15;
  const Scalar t_righ_ankl_cros_114 = s_righ_ankl_cros_x * t_righ_ankl_cros_110;
  const Scalar t_right_shank_16 = w[167];
  const Scalar t_right_shank_27 = t_right_shank_16 - t_right_shank_26;
  const Scalar t_righ_ankl_cros_115 = t_righ_ankl_cros_1 * t_righ_ankl_cros_113;
  const Scalar t_righ_ankl_cros_116 = t_right_shank_27 + t_righ_ankl_cros_114;
  const Scalar t_righ_ankl_cros_117 = t_righ_ankl_cros_116 + t_righ_ankl_cros_115;
  w[45] = t_righ_ankl_cros_117;
  const Scalar t_right_shank_24 = w[173];
  const Scalar t_righ_ankl_cros_118 = t_right_shank_24 - t_righ_ankl_cros_113;
  w[217] = t_righ_ankl_cros_118;
  const Scalar t_right_shank_25 = w[174];
  const Scalar t_righ_ankl_cros_119 = t_right_shank_25 + t_righ_ankl_cros_110;
  w[218] = t_righ_ankl_cros_119;
  const Scalar t_righ_ankl_cros_120 = t_righ_ankl_cros_92 - t_righ_ankl_cros_100;
  w[219] = t_righ_ankl_cros_120;
  const Scalar t_righ_ankl_cros_121 = u_righ_ankl_cros + t_righ_ankl_cros_7 * t_right_foot_69;
  const Scalar t_righ_ankl_cros_122 = t_righ_ankl_cros_12 * t_right_foot_61;
  const Scalar t_righ_ankl_cros_123 = t_righ_ankl_cros_11 * t_righ_ankl_cros_38;
  const Scalar t_righ_ankl_cros_124 = left_ankle_cross_h1 * t_right_thigh_12;
  const Scalar t_righ_ankl_cros_125 = t_righ_ankl_cros_124 - t_righ_ankl_cros_123;
  const Scalar t_righ_ankl_cros_126 = t_righ_ankl_cros_4 * t_righ_ankl_cros_31;
  const Scalar t_righ_ankl_cros_127 = t_righ_ankl_cros_125 + t_righ_ankl_cros_126;
  const Scalar t_righ_ankl_cros_14 = w[180];
  const Scalar t_righ_ankl_cros_128 = left_ankle_cross_h2 * t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_129 = t_righ_ankl_cros_127 - t_righ_ankl_cros_128;
  const Scalar t_right_foot_48 = w[192];
  const Scalar t_righ_ankl_cros_130 = t_righ_ankl_cros_129 - left_foot_h1 * t_right_foot_48;
  const Scalar t_righ_ankl_cros_131 = t_righ_ankl_cros_10 * t_righ_ankl_cros_35;
  const Scalar t_righ_ankl_cros_132 = t_righ_ankl_cros_121 + t_righ_ankl_cros_122;
  const Scalar t_righ_ankl_cros_133 = t_righ_ankl_cros_130 + t_righ_ankl_cros_131;
  const Scalar t_righ_ankl_cros_134 = t_righ_ankl_cros_29 * t_righ_ankl_cros_132;
  const Scalar t_righ_ankl_cros_135 = t_righ_ankl_cros_133 - t_righ_ankl_cros_134;
  const Scalar t_righ_ankl_cros_136 = t_righ_ankl_cros_1 * t_righ_ankl_cros_61;
  // right_shank
  const Scalar t_right_shank_14 = w[165];
  const Scalar t_righ_ankl_cros_18 = w[206];
  const Scalar t_right_shank_28 = t_right_shank_14 * t_righ_ankl_cros_18;
  const Scalar t_right_shank_29 = tau[16] - tau[15] - t_righ_ankl_cros_136 + t_right_shank_28;
  const Scalar t_right_shank_30 = t_right_shank_29 - s_righ_ankl_cros_x * t_righ_ankl_cros_135;
  const Scalar t_right_shank_31 = t_right_thigh_12 * (t_right_shank_16 + t_right_shank_26);
  const Scalar t_right_shank_17 = w[168];
  const Scalar t_right_shank_32 = t_right_shank_30 + t_right_shank_17 * t_right_shank_19;
  const Scalar t_right_shank_33 = t_right_shank_32 + t_right_shank_31;
  const Scalar t_right_shank_21 = w[171];
  const Scalar t_right_shank_34 = t_right_shank_33 - t_right_shank_21 * t_right_shank_23;
  w[220] = t_right_shank_34;
  const Scalar t_right_shank_35 = 1.0 / t_righ_ankl_cros_117;
  w[221] = t_right_shank_35;
  const Scalar t_right_shank_36 = t_righ_ankl_cros_119 * t_right_shank_35;
  const Scalar t_right_shank_37 = t_righ_ankl_cros_118 * t_right_shank_35;
  const Scalar t_right_shank_38 = t_righ_ankl_cros_118 * t_right_shank_36;
  const Scalar t_right_shank_39 = t_righ_ankl_cros_33 - t_right_shank_38;
  w[222] = t_right_shank_39;
  const Scalar t_right_shank_40 = t_righ_ankl_cros_119 * t_right_shank_36;
  const Scalar t_righ_ankl_cros_30 = w[210];
  const Scalar t_right_shank_41 = left_thigh_m2 - t_righ_ankl_cros_30 - t_right_shank_40;
  w[223] = t_right_shank_41;
  const Scalar t_right_shank_42 = t_righ_ankl_cros_120 * t_right_shank_35;
  const Scalar t_right_shank_43 = t_righ_ankl_cros_120 * t_right_shank_36;
  const Scalar t_right_shank_44 = t_righ_ankl_cros_35 - t_right_shank_43;
  w[224] = t_right_shank_44;
  const Scalar t_right_shank_45 = t_righ_ankl_cros_99 * t_right_shank_35;
  const Scalar t_right_shank_46 = t_righ_ankl_cros_119 * t_right_shank_45;
  const Scalar t_right_shank_47 = t_righ_ankl_cros_93 + t_right_shank_46;
  const Scalar t_right_shank_48 = t_righ_ankl_cros_107 * t_right_shank_35;
  const Scalar t_right_shank_49 = t_righ_ankl_cros_119 * t_right_shank_48;
  const Scalar t_right_shank_50 = t_righ_ankl_cros_102 - t_right_shank_49;
  const Scalar t_right_shank_20 = w[170];
  const Scalar t_right_shank_51 = t_right_shank_20 * t_right_shank_24;
  const Scalar t_righ_ankl_cros_137 = t_righ_ankl_cros_135 + t_right_shank_51;
  const Scalar t_right_shank_52 = t_right_thigh_12 * t_right_shank_25;
  const Scalar t_righ_ankl_cros_138 = t_righ_ankl_cros_137 + t_right_shank_52;
  const Scalar t_right_shank_53 = t_righ_ankl_cros_138 + t_right_shank_34 * t_right_shank_36;
  const Scalar t_right_shank_6 = w[160];
  const Scalar t_right_shank_54 = t_right_shank_53 + t_right_shank_6 * t_right_shank_44;
  const Scalar zeta_right_shank_x = w[159];
  const Scalar t_right_shank_55 = t_right_shank_54 + zeta_right_shank_x * t_right_shank_39;
  const Scalar t_right_shank_3 = w[158];
  const Scalar t_right_shank_56 = t_right_shank_55 + t_right_shank_3 * t_right_shank_41;
  const Scalar t_right_shank_8 = w[162];
  const Scalar t_right_shank_57 = t_right_shank_56 - t_right_shank_8 * t_right_shank_47;
  const Scalar t_right_shank_7 = w[161];
  const Scalar t_right_shank_58 = t_right_shank_57 - t_right_shank_7 * t_right_shank_50;
  const Scalar t_right_shank_59 = t_righ_ankl_cros_118 * t_right_shank_37;
  const Scalar t_right_shank_60 = left_thigh_m2 - t_righ_ankl_cros_41 - t_right_shank_59;
  w[225] = t_right_shank_60;
  const Scalar t_right_shank_61 = t_righ_ankl_cros_120 * t_right_shank_37;
  const Scalar t_right_shank_62 = t_righ_ankl_cros_44 - t_right_shank_61;
  w[226] = t_right_shank_62;
  const Scalar t_right_shank_63 = t_righ_ankl_cros_118 * t_right_shank_45;
  const Scalar t_right_shank_64 = t_righ_ankl_cros_95 - t_right_shank_63;
  const Scalar t_right_shank_65 = t_righ_ankl_cros_107 * t_right_shank_37;
  const Scalar t_right_shank_66 = t_righ_ankl_cros_103 - t_right_shank_65;
  const Scalar t_right_shank_67 = t_righ_ankl_cros_61 + t_right_thigh_12 * t_right_shank_24;
  const Scalar t_right_shank_68 = t_right_shank_67 - t_right_shank_34 * t_right_shank_37;
  const Scalar t_right_shank_69 = t_right_shank_68 - zeta_right_shank_x * t_right_shank_60;
  const Scalar t_right_shank_70 = t_right_shank_69 - t_right_shank_6 * t_right_shank_62;
  const Scalar t_right_shank_10 = w[163];
  const Scalar t_right_shank_71 = t_right_shank_70 + t_right_shank_10 * t_right_shank_25;
  const Scalar t_right_shank_72 = t_right_shank_71 + t_right_shank_7 * t_right_shank_66;
  const Scalar t_right_shank_73 = t_right_shank_72 - t_right_shank_8 * t_right_shank_64;
  const Scalar t_right_shank_74 = t_right_shank_73 - t_right_shank_3 * t_right_shank_39;
  const Scalar t_right_shank_75 = t_righ_ankl_cros_120 * t_right_shank_42;
  const Scalar t_right_shank_76 = left_thigh_m3 + t_righ_ankl_cros_63 - t_right_shank_75;
  w[227] = t_right_shank_76;
  const Scalar t_righ_ankl_cros_139 = t_right_shank_25 + t_righ_ankl_cros_91;
  const Scalar t_right_shank_77 = t_righ_ankl_cros_99 * t_right_shank_42;
  const Scalar t_right_shank_78 = t_righ_ankl_cros_139 - t_right_shank_77;
  const Scalar t_righ_ankl_cros_140 = t_right_shank_24 - t_righ_ankl_cros_89;
  const Scalar t_right_shank_79 = t_righ_ankl_cros_120 * t_right_shank_48;
  const Scalar t_right_shank_80 = t_righ_ankl_cros_140 - t_right_shank_79;
  const Scalar t_right_shank_81 = t_righ_ankl_cros_83 - zeta_right_shank_x * t_right_shank_62;
  const Scalar t_right_shank_82 = t_right_shank_81 - t_right_shank_8 * t_right_shank_78;
  const Scalar t_right_shank_83 = t_right_shank_82 - t_right_shank_6 * t_right_shank_76;
  const Scalar t_right_shank_84 = t_right_shank_83 + t_right_shank_7 * t_right_shank_80;
  const Scalar t_right_shank_85 = t_right_shank_84 + t_right_shank_21 * t_right_shank_24;
  const Scalar t_right_shank_86 = t_right_shank_85 - t_right_shank_3 * t_right_shank_44;
  const Scalar t_right_shank_87 = t_right_shank_86 - t_right_shank_34 * t_right_shank_42;
  const Scalar t_right_shank_88 = t_right_shank_87 - t_right_shank_17 * t_right_shank_25;
  w[228] = t_right_shank_88;
  const Scalar t_right_shank_89 = left_shank_I14 - t_right_shank_15;
  const Scalar t_right_foot_83 = left_foot_I25 - left_hip_fork_l1 * t_right_foot_53;
  const Scalar t_right_foot_84 = t_right_foot_83 + left_hip_fork_l3 * t_right_foot_55;
  const Scalar t_right_shank_90 = t_right_foot_84 + t_right_foot_61 * t_righ_ankl_cros_49;
  const Scalar t_right_shank_91 = t_righ_ankl_cros_99 * t_right_shank_45;
  const Scalar t_righ_ankl_cros_141 = t_righ_ankl_cros_66 + t_righ_ankl_cros_91;
  const Scalar t_right_shank_92 = t_right_shank_89 + t_right_shank_90 + t_right_shank_91;
  const Scalar t_right_shank_93 = t_right_shank_92 - s_righ_ankl_cros_x * t_righ_ankl_cros_141;
  const Scalar t_righ_ankl_cros_142 = left_ankle_cross_I6 + t_righ_ankl_cros_85;
  const Scalar t_righ_ankl_cros_143 = t_righ_ankl_cros_1 * t_righ_ankl_cros_66;
  const Scalar t_right_shank_94 = t_righ_ankl_cros_142 + t_righ_ankl_cros_143;
  const Scalar t_right_shank_95 = t_right_shank_94 + t_righ_ankl_cros_99 * t_right_shank_48;
  const Scalar t_right_shank_96 = t_right_shank_95 + s_righ_ankl_cros_x * t_righ_ankl_cros_89;
  const Scalar t_right_shank_97 = t_right_shank_14 + t_right_shank_96;
  const Scalar t_right_shank_1 = w[24];
  const Scalar t_right_shank_98 = t_right_shank_80 - t_right_shank_1 * t_right_shank_76;
  w[229] = t_right_shank_98;
  const Scalar s_right_shank_x = w[23];
  const Scalar t_right_shank_99 = s_right_shank_x * t_right_shank_44;
  const Scalar t_right_shank_100 = t_right_shank_47 - t_right_shank_99;
  const Scalar t_right_shank_101 = t_right_shank_64 + s_right_shank_x * t_right_shank_62;
  const Scalar t_right_thigh_21 = w[155];
  const Scalar t_right_shank_102 = t_right_thigh_21 - t_right_shank_1 * t_right_shank_101;
  const Scalar t_right_shank_103 = t_right_shank_102 - s_right_shank_x * t_right_shank_100;
  w[230] = t_right_shank_103;
  const Scalar t_right_shank_104 = t_right_shank_1 * t_right_shank_62;
  const Scalar t_right_shank_105 = t_right_shank_50 - t_right_shank_1 * t_right_shank_44;
  const Scalar t_right_shank_106 = t_right_shank_66 - t_right_shank_104;
  const Scalar t_right_thigh_16 = w[151];
  const Scalar t_right_shank_107 = t_right_thigh_16 + s_right_shank_x * t_right_shank_105;
  const Scalar t_right_shank_108 = t_right_shank_107 - t_right_shank_1 * t_right_shank_106;
  w[231] = t_right_shank_108;
  const Scalar t_right_shank_109 = t_right_shank_1 * t_right_shank_39;
  const Scalar t_right_shank_110 = s_right_shank_x * t_right_shank_41 - t_right_shank_109;
  const Scalar t_right_shank_111 = t_right_shank_1 * t_right_shank_60;
  const Scalar t_right_shank_112 = t_right_shank_111 - s_right_shank_x * t_right_shank_39;
  const Scalar t_right_thigh_14 = w[149];
  const Scalar t_right_thigh_19 = w[153];
  const Scalar t_right_thigh_24 = t_right_thigh_14 - t_right_thigh_19;
  const Scalar t_right_shank_113 = t_right_thigh_24 - t_right_shank_1 * t_right_shank_112;
  const Scalar t_right_shank_114 = t_right_shank_113 - s_right_shank_x * t_right_shank_110;
  w[232] = t_right_shank_114;
  const Scalar t_right_thigh_23 = w[157];
  const Scalar t_right_shank_115 = t_right_thigh_23 + t_right_shank_110;
  w[233] = t_right_shank_115;
  const Scalar t_right_thigh_22 = w[156];
  const Scalar t_right_shank_116 = t_right_thigh_22 - t_right_shank_112;
  w[234] = t_right_shank_116;
  const Scalar t_right_shank_117 = t_right_shank_99 - t_right_shank_104;
  w[235] = t_right_shank_117;
  // right_thigh
  const Scalar t_right_thigh_20 = w[154];
  const Scalar t_right_thigh_25 = tau[15] - tau[14] + t_right_thigh_20 * t_right_thigh_21;
  const Scalar t_right_thigh_26 = t_right_thigh_25 - s_right_shank_x * t_right_shank_58;
  const Scalar t_right_thigh_27 = t_right_thigh_26 - t_right_shank_1 * t_right_shank_74;
  const Scalar t_right_thigh_15 = w[150];
  const Scalar t_right_thigh_28 = t_right_thigh_27 - t_right_thigh_15 * t_right_thigh_16;
  const Scalar t_right_thigh_11 = w[147];
  const Scalar t_right_thigh_29 = t_right_thigh_28 + t_right_thigh_11 * t_righ_ankl_cros_18;
  const Scalar t_right_thigh_30 = t_right_thigh_12 * (t_right_thigh_14 + t_right_thigh_19);
  const Scalar t_right_thigh_31 = t_right_thigh_29 + t_right_thigh_30;
  w[236] = t_right_thigh_31;
  const Scalar t_right_thigh_32 = 1.0 / t_right_shank_114;
  w[237] = t_right_thigh_32;
  const Scalar t_right_thigh_33 = t_right_shank_103 * t_right_thigh_32;
  const Scalar t_right_shank_118 = t_right_shank_78 + s_right_shank_x * t_right_shank_76;
  w[238] = t_right_shank_118;
  const Scalar t_right_thigh_34 = t_right_thigh_14 + t_right_shank_93;
  const Scalar t_right_thigh_35 = t_right_thigh_34 - t_right_shank_103 * t_right_thigh_33;
  const Scalar t_right_shank_119 = s_right_shank_x * (t_right_shank_78 + t_right_shank_118);
  const Scalar t_right_thigh_36 = t_right_thigh_35 - t_right_shank_119;
  w[239] = t_right_thigh_36;
  const Scalar t_right_thigh_37 = t_right_thigh_11 + t_right_shank_14;
  const Scalar t_right_thigh_38 = t_right_shank_96 + t_right_thigh_37;
  const Scalar t_right_thigh_39 = t_right_thigh_38 - t_right_shank_108 * t_right_thigh_33;
  const Scalar t_right_thigh_40 = t_right_thigh_39 - s_right_shank_x * t_right_shank_98;
  const Scalar t_right_thigh_41 = t_right_thigh_40 + t_right_shank_1 * t_right_shank_78;
  w[240] = t_right_thigh_41;
  const Scalar t_right_thigh_42 = left_ankle_cross_I11 + t_right_thigh_16 + t_right_shank_23;
  const Scalar t_right_thigh_43 = t_right_shank_89 + t_right_shank_93;
  const Scalar t_right_thigh_44 = t_right_thigh_14 + t_right_shank_89;
  const Scalar t_right_thigh_45 = left_ankle_cross_I1 + t_right_thigh_21 + t_right_shank_19;
  const Scalar t_right_thigh_46 = tau[17] - left_ankle_cross_I6 * t_righ_ankl_cros_15;
  const Scalar t_right_thigh_47 = t_right_thigh_46 + s_right_shank_x * t_right_shank_88;
  const Scalar t_righ_ankl_cros_144 = left_ankle_cross_I11 * t_righ_ankl_cros_16;
  const Scalar t_right_thigh_48 = t_right_shank_7 * (t_right_shank_14 + t_right_shank_97);
  const Scalar t_right_thigh_49 = t_right_thigh_47 - t_righ_ankl_cros_144 - t_right_thigh_48;
  const Scalar t_right_thigh_50 = left_ankle_cross_I15 - t_right_shank_90;
  const Scalar t_right_thigh_51 = t_right_thigh_49 - zeta_right_shank_x * t_right_shank_64;
  const Scalar t_right_thigh_52 = t_right_thigh_51 - t_righ_ankl_cros_12 * t_right_thigh_50;
  const Scalar t_righ_ankl_cros_145 = t_righ_ankl_cros_10 * t_righ_ankl_cros_66;
  const Scalar t_right_thigh_53 = t_right_thigh_52 - t_righ_ankl_cros_145;
  const Scalar t_right_thigh_54 = t_right_thigh_53 + u_righ_ankl_cros * t_righ_ankl_cros_49;
  const Scalar t_right_thigh_3 = w[144];
  const Scalar t_right_thigh_55 = t_right_thigh_54 - t_right_thigh_3 * t_right_thigh_41;
  const Scalar t_right_thigh_56 = t_right_thigh_55 + t_right_thigh_31 * t_right_thigh_33;
  const Scalar t_right_thigh_6 = w[145];
  const Scalar t_right_thigh_57 = t_right_thigh_56 + t_right_thigh_6 * t_right_thigh_36;
  const Scalar t_right_thigh_58 = t_right_thigh_57 + t_right_shank_3 * t_right_shank_47;
  const Scalar t_right_thigh_59 = t_right_thigh_58 + left_hip_fork_l1 * t_right_foot_78;
  const Scalar t_right_thigh_60 = t_right_thigh_59 - left_hip_fork_l3 * t_right_foot_72;
  const Scalar t_righ_ankl_cros_146 = t_righ_ankl_cros_11 * t_righ_ankl_cros_142;
  const Scalar t_righ_ankl_cros_147 = t_righ_ankl_cros_4 * t_righ_ankl_cros_39;
  const Scalar t_right_thigh_61 = t_right_thigh_60 - t_righ_ankl_cros_146;
  const Scalar t_righ_ankl_cros_148 = t_righ_ankl_cros_7 * t_righ_ankl_cros_48;
  const Scalar t_right_thigh_62 = t_right_thigh_61 + t_righ_ankl_cros_147;
  const Scalar t_right_thigh_63 = t_right_thigh_62 + t_righ_ankl_cros_148;
  const Scalar t_right_thigh_64 = t_right_thigh_63 + t_right_shank_8 * t_right_thigh_43;
  const Scalar t_right_thigh_18 = w[152];
  const Scalar t_right_thigh_65 = t_right_thigh_64 - t_right_thigh_16 * t_right_thigh_18;
  const Scalar t_right_thigh_66 = t_right_thigh_65 - t_right_shank_6 * t_right_shank_78;
  const Scalar t_right_thigh_67 = t_right_thigh_66 - t_right_shank_34 * t_right_shank_45;
  const Scalar t_right_thigh_68 = t_right_thigh_67 + t_right_thigh_20 * t_right_thigh_44;
  const Scalar t_right_thigh_69 = t_right_thigh_68 - t_right_shank_10 * t_right_shank_23;
  const Scalar t_right_thigh_70 = t_right_thigh_69 + s_righ_ankl_cros_x * t_righ_ankl_cros_83;
  const Scalar t_right_thigh_71 = t_right_thigh_70 - t_right_thigh_15 * t_right_thigh_37;
  const Scalar t_right_thigh_1 = w[142];
  const Scalar t_right_thigh_72 = t_right_thigh_71 + t_right_thigh_1 * t_right_thigh_42;
  const Scalar t_right_thigh_73 = t_right_thigh_72 + t_right_thigh_12 * t_right_thigh_45;
  w[241] = t_right_thigh_73;
  const Scalar t_right_thigh_74 = t_right_shank_108 * t_right_thigh_32;
  w[242] = t_right_thigh_74;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_149 = t_righ_ankl_cros_68 + t_righ_ankl_cros_89;
  const Scalar t_righ_ankl_cros_150 = t_righ_ankl_cros_1 * t_righ_ankl_cros_149;
  const Scalar t_righ_ankl_cros_151 = t_righ_ankl_cros_87 + t_righ_ankl_cros_150;
  const Scalar t_right_shank_120 = t_righ_ankl_cros_107 * t_right_shank_48;
  // right_thigh
  const Scalar t_right_thigh_75 = t_righ_ankl_cros_151 - t_right_shank_120;
  const Scalar t_right_thigh_76 = t_right_thigh_19 + t_right_shank_16;
  const Scalar t_right_thigh_77 = t_right_thigh_75 + t_right_thigh_76;
  const Scalar t_right_shank_121 = t_right_shank_1 * (t_right_shank_80 + t_right_shank_98);
  const Scalar t_right_thigh_78 = t_right_thigh_77 + t_right_shank_108 * t_right_thigh_74;
  const Scalar t_right_thigh_79 = t_right_thigh_78 - t_right_shank_121;
  w[243] = t_right_thigh_79;
  const Scalar t_right_thigh_80 = t_right_thigh_75 + 2.0 * t_right_shank_16;
  const Scalar t_right_shank_13 = w[164];
  const Scalar t_right_thigh_81 = left_shank_I15 - t_right_shank_13;
  const Scalar t_righ_ankl_cros_152 = left_ankle_cross_I7 * t_righ_ankl_cros_15;
  const Scalar t_right_foot_38 = w[190];
  const Scalar t_right_thigh_82 = t_righ_ankl_cros_152 + s_right_foot * t_right_foot_38;
  const Scalar t_right_thigh_83 = t_right_thigh_82 - t_right_shank_1 * t_right_shank_88;
  const Scalar t_right_thigh_84 = t_right_thigh_83 + t_right_thigh_6 * t_right_thigh_41;
  const Scalar t_righ_ankl_cros_153 = t_righ_ankl_cros_4 * t_righ_ankl_cros_38;
  const Scalar t_right_thigh_85 = t_right_thigh_84 - t_righ_ankl_cros_153;
  const Scalar t_right_thigh_86 = t_right_thigh_85 + t_right_shank_19 * t_right_shank_20;
  const Scalar t_righ_ankl_cros_154 = left_ankle_cross_I1 * t_righ_ankl_cros_14;
  const Scalar t_right_thigh_87 = t_right_thigh_86 + t_righ_ankl_cros_154;
  const Scalar t_right_thigh_88 = left_ankle_cross_I5 + t_righ_ankl_cros_85;
  const Scalar t_right_thigh_89 = t_right_thigh_87 + t_right_thigh_3 * t_right_thigh_79;
  const Scalar t_right_thigh_90 = t_right_thigh_89 + t_righ_ankl_cros_12 * t_right_thigh_88;
  const Scalar t_right_thigh_91 = t_right_shank_8 * (t_right_shank_97 + t_right_thigh_81);
  const Scalar t_right_thigh_92 = t_right_thigh_90 + left_foot_I7 * t_right_foot_48;
  const Scalar t_right_thigh_93 = t_right_thigh_20 * (t_right_thigh_11 + t_right_thigh_81);
  const Scalar t_right_thigh_94 = t_right_thigh_92 + t_right_thigh_91 + t_right_thigh_93;
  const Scalar t_right_thigh_95 = t_right_thigh_94 - t_right_shank_34 * t_right_shank_48;
  const Scalar t_right_thigh_96 = t_right_thigh_95 - zeta_right_shank_x * t_right_shank_66;
  const Scalar t_right_thigh_97 = t_right_thigh_96 - t_right_shank_6 * t_right_shank_80;
  const Scalar t_right_thigh_9 = w[146];
  const Scalar t_right_thigh_98 = t_right_thigh_97 + t_right_thigh_9 * t_right_thigh_21;
  const Scalar t_right_thigh_99 = t_right_thigh_98 + t_right_shank_7 * t_right_thigh_80;
  const Scalar t_right_foot_47 = w[191];
  const Scalar t_right_thigh_100 = t_right_thigh_99 - c_right_foot * t_right_foot_47;
  const Scalar t_righ_ankl_cros_155 = t_righ_ankl_cros_7 * t_righ_ankl_cros_46;
  const Scalar t_righ_ankl_cros_156 = t_righ_ankl_cros_11 * t_righ_ankl_cros_87;
  const Scalar t_right_thigh_101 = t_right_thigh_100 + t_righ_ankl_cros_155;
  const Scalar t_right_thigh_102 = t_right_thigh_101 + t_righ_ankl_cros_156;
  const Scalar t_right_thigh_103 = t_right_thigh_102 + u_righ_ankl_cros * t_righ_ankl_cros_36;
  const Scalar t_righ_ankl_cros_157 = t_righ_ankl_cros_10 * t_righ_ankl_cros_68;
  const Scalar t_right_thigh_104 = t_right_thigh_103 + t_righ_ankl_cros_157;
  const Scalar t_right_thigh_105 = t_right_thigh_104 + t_right_thigh_31 * t_right_thigh_74;
  const Scalar t_right_thigh_106 = t_right_thigh_105 - t_right_shank_3 * t_right_shank_50;
  const Scalar t_right_thigh_107 = t_right_thigh_106 - t_right_thigh_12 * t_right_thigh_42;
  const Scalar t_right_thigh_108 = t_right_thigh_107 + t_right_thigh_15 * t_right_thigh_76;
  const Scalar t_right_thigh_109 = t_right_thigh_108 - t_right_thigh_1 * t_right_thigh_45;
  const Scalar t_righ_ankl_cros_158 = t_righ_ankl_cros_1 * t_righ_ankl_cros_83;
  const Scalar t_right_thigh_110 = t_right_thigh_109 - t_righ_ankl_cros_158;
  w[244] = t_right_thigh_110;
  const Scalar t_right_thigh_111 = t_right_shank_115 * t_right_thigh_32;
  w[245] = t_right_thigh_111;
  const Scalar t_right_thigh_112 = t_right_shank_100 - t_right_shank_103 * t_right_thigh_111;
  w[246] = t_right_thigh_112;
  const Scalar t_right_thigh_113 = t_right_shank_105 + t_right_shank_108 * t_right_thigh_111;
  w[247] = t_right_thigh_113;
  const Scalar t_right_shank_122 = t_right_shank_58 + t_right_thigh_9 * t_right_thigh_22;
  const Scalar t_right_shank_123 = t_right_shank_122 + t_right_thigh_12 * t_right_thigh_23;
  const Scalar t_right_thigh_114 = t_right_shank_123 - t_right_thigh_6 * t_right_thigh_112;
  const Scalar t_right_thigh_115 = t_right_thigh_114 - t_right_thigh_3 * t_right_thigh_113;
  const Scalar t_right_thigh_116 = t_right_thigh_115 - t_right_thigh_31 * t_right_thigh_111;
  w[248] = t_right_thigh_116;
  const Scalar t_right_thigh_117 = t_right_shank_116 * t_right_thigh_32;
  w[249] = t_right_thigh_117;
  const Scalar t_right_thigh_118 = t_right_shank_106 + t_right_shank_116 * t_right_thigh_74;
  w[250] = t_right_thigh_118;
  const Scalar t_right_thigh_119 = t_right_shank_101 + t_right_shank_103 * t_right_thigh_117;
  w[251] = t_right_thigh_119;
  const Scalar t_right_thigh_120 = t_right_shank_74 + t_right_thigh_12 * t_right_thigh_22;
  const Scalar t_right_thigh_121 = t_right_thigh_120 - t_right_thigh_6 * t_right_thigh_119;
  const Scalar t_right_thigh_122 = t_right_thigh_121 + t_right_thigh_3 * t_right_thigh_118;
  const Scalar t_right_thigh_123 = t_right_thigh_122 + t_right_thigh_18 * t_right_thigh_23;
  w[252] = t_right_thigh_123;
}

[[gnu::noinline]] void forward_dynamics_4(const Scalar tau[18], Scalar w[278]) noexcept {
  const Scalar t_right_thigh_123 = w[252];
  const Scalar t_right_thigh_31 = w[236];
  const Scalar t_right_thigh_117 = w[249];
  const Scalar t_right_thigh_124 = t_right_thigh_123 + t_right_thigh_31 * t_right_thigh_117;
  w[146] = t_right_thigh_124;
  const Scalar t_right_shank_117 = w[235];
  const Scalar t_right_thigh_32 = w[237];
  const Scalar t_right_thigh_125 = t_right_shank_117 * t_right_thigh_32;
  const Scalar t_right_thigh_22 = w[156];
  const Scalar t_right_shank_98 = w[229];
  const Scalar t_right_shank_124 = t_right_thigh_22 + t_right_shank_98;
  const Scalar t_right_thigh_74 = w[242];
  const Scalar t_right_thigh_126 = t_right_shank_124 + t_right_shank_117 * t_right_thigh_74;
  const Scalar t_right_thigh_23 = w[157];
  const Scalar t_right_shank_118 = w[238];
  const Scalar t_right_shank_125 = t_right_thigh_23 + t_right_shank_118;
  // right_thigh
  const Scalar t_right_shank_103 = w[230];
  const Scalar t_right_thigh_127 = t_right_shank_125 + t_right_shank_103 * t_right_thigh_125;
  const Scalar s_q14_q15_q16 = w[19];
  const Scalar t_right_thigh_112 = w[246];
  const Scalar t_right_thigh_118 = w[250];
  const Scalar t_right_thigh_128 = s_q14_q15_q16 * (t_right_thigh_112 + t_right_thigh_118);
  const Scalar c_q14_q15_q16 = w[20];
  const Scalar t_right_thigh_113 = w[247];
  const Scalar t_right_thigh_119 = w[251];
  const Scalar t_right_thigh_129 = c_q14_q15_q16 * (t_right_thigh_113 + t_right_thigh_119);
  const Scalar t_right_thigh_130 = t_right_thigh_128 - t_right_thigh_129;
  const Scalar t_right_thigh_131 = c_q14_q15_q16 * t_right_thigh_130;
  const Scalar t_right_thigh_132 = 2.0 * c_q14_q15_q16;
  const Scalar t_right_thigh_36 = w[239];
  const Scalar t_right_thigh_79 = w[243];
  const Scalar t_right_thigh_133 = s_q14_q15_q16 * (t_right_thigh_36 + t_right_thigh_79);
  const Scalar t_right_thigh_41 = w[240];
  const Scalar t_right_thigh_134 = t_right_thigh_133 + t_right_thigh_41 * t_right_thigh_132;
  const Scalar t_right_thigh_135 = s_q14_q15_q16 * t_right_thigh_134;
  const Scalar t_right_thigh_136 = left_hip_fork_I15 - t_right_thigh_41;
  const Scalar t_right_thigh_137 = t_right_thigh_136 + c_q14_q15_q16 * t_right_thigh_134;
  w[147] = t_right_thigh_137;
  const Scalar t_right_thigh_138 = left_hip_fork_I16 - t_right_thigh_36 + t_right_thigh_135;
  w[148] = t_right_thigh_138;
  const Scalar t_right_thigh_139 = left_hip_fork_h2 + t_right_thigh_113 + t_right_thigh_131;
  const Scalar t_right_shank_60 = w[225];
  const Scalar t_right_shank_116 = w[234];
  const Scalar t_right_thigh_140 = t_right_shank_60 + t_right_shank_116 * t_right_thigh_117;
  const Scalar t_right_shank_41 = w[223];
  const Scalar t_right_shank_115 = w[233];
  const Scalar t_right_thigh_111 = w[245];
  const Scalar t_right_thigh_141 = t_right_shank_41 + t_right_shank_115 * t_right_thigh_111;
  const Scalar t_right_shank_39 = w[222];
  const Scalar t_right_thigh_142 = t_right_shank_39 + t_right_shank_116 * t_right_thigh_111;
  const Scalar t_right_thigh_143 = s_q14_q15_q16 * (t_right_thigh_140 - t_right_thigh_141);
  const Scalar t_right_thigh_144 = t_right_thigh_143 - t_right_thigh_132 * t_right_thigh_142;
  const Scalar t_right_thigh_145 = s_q14_q15_q16 * t_right_thigh_144;
  const Scalar t_right_thigh_146 = s_q14_q15_q16 * t_right_thigh_130;
  const Scalar t_right_thigh_147 = t_right_thigh_112 - t_right_thigh_146;
  w[149] = t_right_thigh_147;
  const Scalar t_right_thigh_148 = left_hip_fork_h1 - s_q14_q15_q16 * t_right_thigh_126;
  const Scalar t_right_thigh_149 = t_right_thigh_148 + c_q14_q15_q16 * t_right_thigh_127;
  w[151] = t_right_thigh_149;
  const Scalar t_right_shank_44 = w[224];
  const Scalar t_right_thigh_150 = t_right_shank_44 + t_right_shank_117 * t_right_thigh_111;
  const Scalar t_right_shank_62 = w[226];
  const Scalar t_right_thigh_151 = t_right_shank_62 + t_right_shank_116 * t_right_thigh_125;
  // right_hip_fork
  const Scalar t_right_hip_fork_21 = w[141];
  const Scalar t_right_hip_fork_23 = tau[13] + left_hip_fork_I14 * t_right_hip_fork_21;
  const Scalar t_right_hip_fork_22 = w[143];
  const Scalar t_right_hip_fork_24 = left_hip_fork_I15 * t_right_hip_fork_22;
  const Scalar t_right_hip_fork_25 = t_right_hip_fork_23 - t_right_hip_fork_24;
  const Scalar t_right_thigh_73 = w[241];
  const Scalar t_right_hip_fork_26 = t_right_hip_fork_25 - c_q14_q15_q16 * t_right_thigh_73;
  const Scalar t_right_thigh_110 = w[244];
  const Scalar t_right_hip_fork_27 = t_right_hip_fork_26 + s_q14_q15_q16 * t_right_thigh_110;
  const Scalar t_right_hip_fork_20 = w[140];
  const Scalar t_right_hip_fork_28 = left_hip_fork_I17 * t_right_hip_fork_20;
  const Scalar t_right_hip_fork_19 = w[139];
  const Scalar t_right_thigh_1 = w[142];
  const Scalar t_right_hip_fork_29 = t_right_hip_fork_19 - t_right_thigh_1;
  const Scalar t_right_hip_fork_30 = t_right_hip_fork_27 - t_right_hip_fork_28;
  const Scalar u_right_hip_fork = t_right_hip_fork_30 + left_hip_fork_I7 * t_right_hip_fork_29;
  w[152] = u_right_hip_fork;
  const Scalar t_right_hip_fork_31 = 1.0 / t_right_thigh_138;
  w[153] = t_right_hip_fork_31;
  const Scalar t_right_hip_fork_32 = t_right_thigh_139 * t_right_hip_fork_31;
  w[155] = t_right_hip_fork_32;
  const Scalar t_right_hip_fork_33 = t_right_thigh_149 * t_right_hip_fork_31;
  const Scalar t_right_thigh_152 = c_q14_q15_q16 * t_right_thigh_151;
  const Scalar t_right_thigh_153 = t_right_thigh_152 + s_q14_q15_q16 * t_right_thigh_150;
  const Scalar t_right_hip_fork_34 = t_right_thigh_139 * t_right_hip_fork_33;
  const Scalar t_right_hip_fork_35 = t_right_thigh_153 + t_right_hip_fork_34;
  const Scalar t_right_hip_fork_36 = t_right_thigh_139 * t_right_hip_fork_32;
  const Scalar t_right_thigh_154 = t_right_thigh_140 - t_right_thigh_145;
  const Scalar t_right_hip_fork_37 = t_right_thigh_154 - t_right_hip_fork_36;
  const Scalar t_right_hip_fork_38 = t_right_thigh_147 * t_right_hip_fork_31;
  w[163] = t_right_hip_fork_38;
  const Scalar t_right_thigh_155 = t_right_thigh_142 + c_q14_q15_q16 * t_right_thigh_144;
  const Scalar t_right_hip_fork_39 = t_right_thigh_147 * t_right_hip_fork_32;
  const Scalar t_right_hip_fork_40 = t_right_thigh_155 + t_right_hip_fork_39;
  w[164] = t_right_hip_fork_40;
  const Scalar t_right_hip_fork_41 = t_right_thigh_137 * t_right_hip_fork_32;
  const Scalar t_right_thigh_156 = t_right_thigh_118 - t_right_thigh_146;
  const Scalar t_right_hip_fork_42 = t_right_thigh_156 - t_right_hip_fork_41;
  const Scalar t_right_hip_fork_43 = t_right_thigh_137 * t_right_hip_fork_31;
  const Scalar t_right_hip_fork_44 = left_hip_fork_I14 * t_right_hip_fork_32;
  const Scalar t_right_hip_fork_15 = w[136];
  const Scalar t_right_hip_fork_45 = u_right_hip_fork - left_hip_fork_I14 * t_right_hip_fork_15;
  const Scalar t_right_hip_fork_46 = left_hip_fork_h2 * t_right_hip_fork_20;
  const Scalar t_right_hip_fork_47 = left_hip_fork_h1 * t_right_hip_fork_19;
  const Scalar t_right_hip_fork_48 = t_right_hip_fork_46 - t_right_hip_fork_47;
  const Scalar t_right_thigh_157 = t_right_hip_fork_48 - c_q14_q15_q16 * t_right_thigh_124;
  const Scalar t_right_thigh_116 = w[248];
  const Scalar t_right_thigh_158 = t_right_thigh_157 + s_q14_q15_q16 * t_right_thigh_116;
  const Scalar t_right_hip_fork_17 = w[138];
  const Scalar t_right_hip_fork_49 = t_right_hip_fork_17 * t_right_hip_fork_42;
  const Scalar t_right_hip_fork_12 = w[134];
  const Scalar t_right_hip_fork_50 = t_right_hip_fork_12 * t_right_hip_fork_35;
  const Scalar t_right_hip_fork_51 = t_right_thigh_158 - t_right_hip_fork_49;
  const Scalar t_right_hip_fork_52 = t_right_hip_fork_51 - t_right_hip_fork_50;
  const Scalar zeta_right_hip_fork_x = w[135];
  const Scalar t_right_hip_fork_53 = zeta_right_hip_fork_x * t_right_hip_fork_37;
  const Scalar t_right_hip_fork_54 = t_right_hip_fork_52 - t_right_hip_fork_53;
  const Scalar t_right_hip_fork_16 = w[137];
  const Scalar t_right_hip_fork_55 = t_right_hip_fork_16 * t_right_hip_fork_40;
  const Scalar t_right_hip_fork_56 = t_right_hip_fork_54 + t_right_hip_fork_55;
  const Scalar t_right_hip_fork_57 = t_right_hip_fork_32 * t_right_hip_fork_45;
  const Scalar t_right_hip_fork_58 = t_right_hip_fork_56 + t_right_hip_fork_57;
  w[165] = t_right_hip_fork_58;
  const Scalar t_right_hip_fork_59 = t_right_thigh_149 * t_right_hip_fork_33;
  const Scalar t_right_shank_76 = w[227];
  const Scalar t_right_hip_fork_60 = t_right_shank_76 - t_right_hip_fork_59;
  const Scalar t_right_thigh_159 = t_right_shank_117 * t_right_thigh_125;
  const Scalar t_right_hip_fork_61 = t_right_hip_fork_60 + t_right_thigh_159;
  const Scalar t_right_thigh_160 = c_q14_q15_q16 * t_right_thigh_150;
  const Scalar t_right_thigh_161 = t_right_thigh_160 - s_q14_q15_q16 * t_right_thigh_151;
  const Scalar t_right_hip_fork_62 = t_right_thigh_149 * t_right_hip_fork_38;
  const Scalar t_right_hip_fork_63 = t_right_thigh_161 + t_right_hip_fork_62;
  w[166] = t_right_hip_fork_63;
  const Scalar t_right_thigh_162 = c_q14_q15_q16 * t_right_thigh_126;
  const Scalar t_right_thigh_163 = t_right_thigh_162 + s_q14_q15_q16 * t_right_thigh_127;
  const Scalar t_right_hip_fork_64 = t_right_thigh_149 * t_right_hip_fork_43;
  const Scalar t_right_hip_fork_65 = t_right_thigh_163 + t_right_hip_fork_64;
  const Scalar t_right_hip_fork_66 = left_hip_fork_I14 * t_right_hip_fork_33;
  const Scalar t_right_hip_fork_67 = left_hip_fork_h1 * t_right_hip_fork_20;
  const Scalar t_right_shank_88 = w[228];
  const Scalar t_right_hip_fork_68 = t_right_shank_88 - t_right_hip_fork_67;
  const Scalar t_right_thigh_15 = w[150];
  const Scalar t_right_thigh_164 = t_right_thigh_15 * t_right_thigh_22;
  const Scalar t_right_hip_fork_69 = t_right_hip_fork_68 + t_right_thigh_164;
  const Scalar t_right_thigh_20 = w[154];
  const Scalar t_right_thigh_165 = t_right_thigh_20 * t_right_thigh_23;
  const Scalar t_right_hip_fork_70 = t_right_hip_fork_69 - t_right_thigh_165;
  const Scalar t_right_thigh_3 = w[144];
  const Scalar t_right_thigh_166 = t_right_thigh_3 * t_right_thigh_126;
  const Scalar t_right_hip_fork_71 = t_right_hip_fork_16 * t_right_hip_fork_63;
  const Scalar t_right_hip_fork_72 = t_right_hip_fork_70 + t_right_thigh_166;
  const Scalar t_right_hip_fork_73 = t_right_hip_fork_72 + t_right_hip_fork_71;
  const Scalar t_right_hip_fork_74 = left_hip_fork_h2 * t_right_thigh_1;
  const Scalar t_right_hip_fork_75 = t_right_hip_fork_73 + t_right_hip_fork_74;
  const Scalar t_right_thigh_6 = w[145];
  const Scalar t_right_thigh_167 = t_right_thigh_6 * t_right_thigh_127;
  const Scalar t_right_hip_fork_76 = t_right_hip_fork_12 * t_right_hip_fork_61;
  const Scalar t_right_hip_fork_77 = t_right_hip_fork_75 - t_right_thigh_167;
  const Scalar t_right_hip_fork_78 = t_right_hip_fork_77 + t_right_hip_fork_76;
  const Scalar t_right_hip_fork_79 = zeta_right_hip_fork_x * t_right_hip_fork_35;
  const Scalar t_right_hip_fork_80 = t_right_hip_fork_78 + t_right_hip_fork_79;
  const Scalar t_right_hip_fork_81 = t_right_hip_fork_17 * t_right_hip_fork_65;
  const Scalar t_right_hip_fork_82 = t_right_hip_fork_80 + t_right_hip_fork_81;
  const Scalar t_right_hip_fork_83 = t_right_hip_fork_33 * t_right_hip_fork_45;
  const Scalar t_right_hip_fork_84 = t_right_hip_fork_82 + t_right_hip_fork_83;
  const Scalar t_right_thigh_168 = t_right_thigh_31 * t_right_thigh_125;
  const Scalar t_right_hip_fork_85 = t_right_hip_fork_84 + t_right_thigh_168;
  w[167] = t_right_hip_fork_85;
  const Scalar t_right_thigh_169 = t_right_thigh_131 - (left_hip_fork_h2 - t_right_thigh_119);
  const Scalar t_right_hip_fork_86 = t_right_thigh_137 * t_right_hip_fork_38;
  const Scalar t_right_hip_fork_87 = t_right_thigh_169 + t_right_hip_fork_86;
  w[168] = t_right_hip_fork_87;
  const Scalar t_right_thigh_170 = t_right_thigh_135 - (left_hip_fork_I13 + t_right_thigh_79);
  const Scalar t_right_hip_fork_88 = t_right_thigh_137 * t_right_hip_fork_43;
  const Scalar t_right_hip_fork_89 = t_right_thigh_170 + t_right_hip_fork_88;
  w[169] = t_right_hip_fork_89;
  const Scalar t_right_hip_fork_90 = left_hip_fork_I14 * t_right_hip_fork_43;
  const Scalar t_right_hip_fork_91 = left_hip_fork_I7 + t_right_hip_fork_90;
  const Scalar t_right_hip_fork_92 = left_hip_fork_I15 * t_right_hip_fork_20;
  const Scalar t_right_hip_fork_93 = left_hip_fork_I7 * t_right_hip_fork_21;
  const Scalar t_right_hip_fork_94 = t_right_hip_fork_92 + t_right_hip_fork_93;
  const Scalar t_right_hip_fork_95 = left_hip_fork_I13 * t_right_hip_fork_22;
  const Scalar t_right_hip_fork_96 = t_right_hip_fork_94 + t_right_hip_fork_95;
  const Scalar t_right_hip_fork_97 = t_right_hip_fork_96 + s_q14_q15_q16 * t_right_thigh_73;
  const Scalar t_right_hip_fork_98 = t_right_hip_fork_97 + c_q14_q15_q16 * t_right_thigh_110;
  const Scalar t_right_hip_fork_99 = t_right_hip_fork_16 * t_right_hip_fork_87;
  const Scalar t_right_hip_fork_100 = t_right_hip_fork_98 - t_right_hip_fork_99;
  const Scalar t_right_hip_fork_101 = t_right_hip_fork_17 * t_right_hip_fork_89;
  const Scalar t_right_hip_fork_102 = t_right_hip_fork_100 - t_right_hip_fork_101;
  const Scalar t_right_hip_fork_103 = t_right_hip_fork_12 * t_right_hip_fork_65;
  const Scalar t_right_hip_block_17 = w[132];
  const Scalar t_right_hip_fork_104 = t_right_hip_block_17 - t_right_thigh_1;
  const Scalar t_right_hip_fork_105 = t_right_hip_fork_102 + t_right_hip_fork_103;
  const Scalar t_right_hip_fork_106 = left_hip_fork_I14 * t_right_hip_fork_104;
  const Scalar t_right_hip_fork_107 = t_right_hip_fork_105 + t_right_hip_fork_106;
  const Scalar t_right_hip_fork_108 = zeta_right_hip_fork_x * t_right_hip_fork_42;
  const Scalar t_right_hip_fork_109 = t_right_hip_fork_107 + t_right_hip_fork_108;
  const Scalar t_right_hip_fork_110 = t_right_hip_fork_15 * t_right_hip_fork_91;
  const Scalar t_right_hip_fork_111 = t_right_hip_fork_109 + t_right_hip_fork_110;
  const Scalar t_right_hip_fork_112 = u_right_hip_fork * t_right_hip_fork_43;
  const Scalar t_right_hip_fork_113 = t_right_hip_fork_111 - t_right_hip_fork_112;
  w[170] = t_right_hip_fork_113;
  const Scalar t_right_hip_fork_114 = left_hip_fork_h1 + left_hip_fork_I14 * t_right_hip_fork_38;
  w[171] = t_right_hip_fork_114;
  const Scalar t_right_hip_fork_115 = left_hip_fork_p1 * t_right_hip_fork_31;
  const Scalar t_right_hip_fork_116 = left_hip_fork_I10 - t_right_hip_fork_115;
  const Scalar t_right_hip_fork_117 = u_right_hip_fork * t_right_hip_fork_31;
  const Scalar t_right_hip_fork_118 = t_right_hip_fork_20 + t_right_hip_fork_117;
  const Scalar t_right_hip_fork_119 = zeta_right_hip_fork_x * t_right_hip_fork_32;
  const Scalar t_right_hip_fork_120 = tau[14] + left_hip_fork_I10 * t_right_hip_fork_21;
  const Scalar t_right_hip_fork_121 = left_hip_fork_I7 * t_right_hip_fork_22;
  const Scalar t_right_hip_fork_122 = t_right_hip_fork_120 + t_right_hip_fork_121;
  const Scalar t_right_hip_fork_123 = t_right_hip_fork_16 * t_right_hip_fork_114;
  const Scalar t_right_hip_fork_124 = t_right_hip_fork_122 + t_right_hip_fork_123;
  const Scalar t_right_hip_fork_125 = t_right_hip_fork_12 * t_right_hip_fork_66;
  const Scalar t_right_hip_fork_126 = t_right_hip_fork_124 - t_right_hip_fork_125;
  const Scalar t_right_hip_fork_127 = t_right_hip_fork_17 * t_right_hip_fork_91;
  const Scalar t_right_hip_fork_128 = t_right_hip_fork_118 + t_right_hip_fork_119;
  const Scalar t_right_hip_fork_129 = t_right_hip_fork_126 + t_right_hip_fork_127;
  const Scalar t_right_hip_fork_130 = left_hip_fork_I14 * t_right_hip_fork_128;
  const Scalar t_right_hip_fork_131 = t_right_hip_fork_129 + t_right_hip_fork_130;
  const Scalar t_right_hip_fork_132 = t_right_hip_fork_15 * t_right_hip_fork_116;
  const Scalar t_right_hip_fork_133 = t_right_hip_block_17 - t_right_hip_fork_19;
  const Scalar t_right_hip_fork_134 = t_right_hip_fork_131 + t_right_hip_fork_132;
  const Scalar t_right_hip_fork_135 = left_hip_fork_I15 * t_right_hip_fork_133;
  const Scalar t_right_hip_fork_136 = t_right_hip_fork_134 + t_right_hip_fork_135;
  w[172] = t_right_hip_fork_136;
  const Scalar t_right_hip_fork_137 = t_right_thigh_147 * t_right_hip_fork_38;
  const Scalar t_right_thigh_171 = t_right_thigh_141 + t_right_thigh_145;
  const Scalar t_right_hip_fork_138 = t_right_thigh_171 - t_right_hip_fork_137;
  w[173] = t_right_hip_fork_138;
  const Scalar s_right_hip_roll = w[17];
  const Scalar t_right_hip_fork_139 = 2.0 * s_right_hip_roll;
  const Scalar t_right_hip_fork_140 = t_right_hip_fork_37 - t_right_hip_fork_61;
  const Scalar t_right_hip_fork_141 = t_right_hip_fork_35 * t_right_hip_fork_139;
  const Scalar c_right_hip_roll = w[18];
  const Scalar t_right_hip_fork_142 = c_right_hip_roll * t_right_hip_fork_140;
  const Scalar t_right_hip_fork_143 = t_right_hip_fork_142 + t_right_hip_fork_141;
  const Scalar t_right_hip_fork_144 = c_right_hip_roll * t_right_hip_fork_143;
  const Scalar t_right_hip_fork_145 = t_right_hip_fork_37 - t_right_hip_fork_144;
  w[174] = t_right_hip_fork_145;
  const Scalar t_right_hip_fork_146 = t_right_hip_fork_42 - t_right_hip_fork_66;
  const Scalar t_right_hip_fork_147 = t_right_hip_fork_44 - t_right_hip_fork_65;
  const Scalar t_right_hip_fork_148 = c_right_hip_roll * t_right_hip_fork_146;
  const Scalar t_right_hip_fork_149 = s_right_hip_roll * t_right_hip_fork_147;
  const Scalar t_right_hip_fork_150 = t_right_hip_fork_148 - t_right_hip_fork_149;
  const Scalar t_right_hip_fork_151 = s_right_hip_roll * t_right_hip_fork_150;
  const Scalar t_right_hip_fork_152 = t_right_hip_fork_65 - t_right_hip_fork_151;
  const Scalar t_right_hip_fork_153 = left_hip_fork_l1 * t_right_hip_fork_145;
  const Scalar t_right_hip_fork_154 = t_right_hip_fork_152 - t_right_hip_fork_153;
  w[175] = t_right_hip_fork_154;
  const Scalar t_right_hip_fork_155 = t_right_hip_fork_89 + t_right_hip_fork_116;
  const Scalar t_right_hip_fork_156 = t_right_hip_fork_91 * t_right_hip_fork_139;
  const Scalar t_right_hip_fork_157 = c_right_hip_roll * t_right_hip_fork_155;
  const Scalar t_right_hip_fork_158 = t_right_hip_fork_156 + t_right_hip_fork_157;
  const Scalar t_right_hip_fork_159 = c_right_hip_roll * t_right_hip_fork_158;
  w[180] = t_right_hip_fork_159;
  const Scalar t_right_hip_fork_160 = left_hip_block_I20 - t_right_hip_fork_115;
  const Scalar t_right_hip_fork_161 = t_right_hip_fork_152 + t_right_hip_fork_154;
  const Scalar t_right_hip_fork_162 = t_right_hip_fork_159 - t_right_hip_fork_160;
  const Scalar t_right_hip_fork_163 = left_hip_fork_l1 * t_right_hip_fork_161;
  const Scalar t_right_hip_fork_164 = t_right_hip_fork_162 + t_right_hip_fork_163;
  w[181] = t_right_hip_fork_164;
  const Scalar t_right_hip_fork_165 = s_right_hip_roll * t_right_hip_fork_143;
  const Scalar t_right_hip_fork_166 = t_right_hip_fork_35 - t_right_hip_fork_165;
  w[182] = t_right_hip_fork_166;
  const Scalar t_right_hip_fork_167 = left_hip_fork_l1 * t_right_hip_fork_166;
  const Scalar t_right_hip_fork_168 = c_right_hip_roll * t_right_hip_fork_150;
  const Scalar t_right_hip_fork_169 = t_right_hip_fork_66 + t_right_hip_fork_168;
  const Scalar t_right_hip_fork_170 = t_right_hip_fork_42 + t_right_hip_fork_167;
  const Scalar t_right_hip_fork_171 = t_right_hip_fork_168 - t_right_hip_fork_170;
  w[183] = t_right_hip_fork_171;
  const Scalar t_right_hip_fork_172 = left_hip_block_I21 - t_right_hip_fork_90;
  const Scalar t_right_hip_fork_173 = s_right_hip_roll * t_right_hip_fork_158;
  const Scalar t_right_hip_fork_174 = t_right_hip_fork_169 + t_right_hip_fork_171;
  const Scalar t_right_hip_fork_175 = t_right_hip_fork_172 + t_right_hip_fork_173;
  const Scalar t_right_hip_fork_176 = left_hip_fork_l1 * t_right_hip_fork_174;
  const Scalar t_right_hip_fork_177 = t_right_hip_fork_175 + t_right_hip_fork_176;
  w[188] = t_right_hip_fork_177;
  const Scalar t_right_hip_fork_178 = t_right_hip_fork_167 - t_right_hip_fork_169;
  w[189] = t_right_hip_fork_178;
  const Scalar t_right_hip_fork_179 = t_right_hip_fork_61 + t_right_hip_fork_144;
  w[190] = t_right_hip_fork_179;
  const Scalar t_right_hip_fork_180 = t_right_hip_fork_44 + t_right_hip_fork_151;
  w[191] = t_right_hip_fork_180;
}

[[gnu::noinline]] void forward_dynamics_5(const Scalar tau[18], Scalar w[278]) noexcept {
  // right_hip_fork
  const Scalar t_right_hip_fork_179 = w[190];
  const Scalar t_right_hip_fork_181 = left_hip_fork_l1 * t_right_hip_fork_179;
  const Scalar t_right_hip_fork_180 = w[191];
  const Scalar t_right_hip_fork_182 = t_right_hip_fork_180 - t_right_hip_fork_181;
  const Scalar t_right_hip_fork_154 = w[175];
  const Scalar t_right_hip_fork_183 = left_hip_block_h4 - t_right_hip_fork_154;
  w[139] = t_right_hip_fork_183;
  const Scalar c_right_hip_roll = w[18];
  const Scalar t_right_hip_fork_63 = w[166];
  const Scalar t_right_hip_fork_184 = c_right_hip_roll * t_right_hip_fork_63;
  const Scalar s_right_hip_roll = w[17];
  const Scalar t_right_hip_fork_40 = w[164];
  const Scalar t_right_hip_fork_185 = s_right_hip_roll * t_right_hip_fork_40;
  const Scalar t_right_hip_fork_186 = t_right_hip_fork_184 + t_right_hip_fork_185;
  const Scalar t_right_hip_fork_87 = w[168];
  const Scalar t_right_hip_fork_187 = left_hip_block_h1 - c_right_hip_roll * t_right_hip_fork_87;
  const Scalar t_right_hip_fork_188 = left_hip_fork_l1 * t_right_hip_fork_186;
  const Scalar t_right_hip_fork_189 = t_right_hip_fork_187 - t_right_hip_fork_188;
  const Scalar t_right_hip_fork_114 = w[171];
  const Scalar t_right_hip_fork_190 = s_right_hip_roll * t_right_hip_fork_114;
  const Scalar t_right_hip_fork_191 = t_right_hip_fork_189 - t_right_hip_fork_190;
  w[140] = t_right_hip_fork_191;
  const Scalar t_right_hip_fork_192 = c_right_hip_roll * t_right_hip_fork_40;
  const Scalar t_right_hip_fork_193 = s_right_hip_roll * t_right_hip_fork_63;
  const Scalar t_right_hip_fork_194 = t_right_hip_fork_192 - t_right_hip_fork_193;
  const Scalar t_right_hip_fork_58 = w[165];
  const Scalar t_right_hip_fork_195 = s_right_hip_roll * t_right_hip_fork_58;
  const Scalar t_right_hip_fork_85 = w[167];
  const Scalar t_right_hip_fork_196 = c_right_hip_roll * t_right_hip_fork_85;
  const Scalar t_right_hip_fork_197 = t_right_hip_fork_195 + t_right_hip_fork_196;
  // right_hip_block
  const Scalar t_right_hip_block_16 = w[131];
  const Scalar t_right_hip_block_19 = tau[12] + left_hip_block_I18 * t_right_hip_block_16;
  const Scalar t_right_hip_block_18 = w[133];
  const Scalar t_right_hip_block_20 = left_hip_block_I17 * t_right_hip_block_18;
  const Scalar t_right_hip_block_21 = t_right_hip_block_19 - t_right_hip_block_20;
  const Scalar t_right_hip_fork_113 = w[170];
  const Scalar t_right_hip_fork_198 = c_right_hip_roll * t_right_hip_fork_113;
  const Scalar t_right_hip_block_22 = t_right_hip_block_21 + t_right_hip_fork_198;
  const Scalar t_right_hip_fork_136 = w[172];
  const Scalar t_right_hip_fork_199 = s_right_hip_roll * t_right_hip_fork_136;
  const Scalar t_right_hip_block_14 = w[129];
  const Scalar t_right_hip_block_17 = w[132];
  const Scalar t_right_hip_block_23 = t_right_hip_block_14 - t_right_hip_block_17;
  const Scalar t_right_hip_block_24 = t_right_hip_block_22 - t_right_hip_fork_199;
  const Scalar t_right_hip_block_25 = left_hip_block_I8 * t_right_hip_block_23;
  const Scalar t_right_hip_block_26 = t_right_hip_block_24 + t_right_hip_block_25;
  const Scalar t_right_hip_fork_200 = left_hip_fork_l1 * t_right_hip_fork_197;
  const Scalar t_right_hip_block_27 = t_right_hip_block_26 - t_right_hip_fork_200;
  const Scalar t_right_hip_block_15 = w[130];
  const Scalar t_right_hip_block_28 = left_hip_block_I19 * t_right_hip_block_15;
  const Scalar u_right_hip_block = t_right_hip_block_27 - t_right_hip_block_28;
  w[142] = u_right_hip_block;
  const Scalar t_right_hip_fork_164 = w[181];
  const Scalar t_right_hip_block_29 = 1.0 / t_right_hip_fork_164;
  w[150] = t_right_hip_block_29;
  const Scalar t_right_hip_block_30 = t_right_hip_fork_191 * t_right_hip_block_29;
  const Scalar t_right_hip_block_31 = t_right_hip_fork_183 * t_right_hip_block_29;
  const Scalar t_right_hip_block_32 = t_right_hip_fork_191 * t_right_hip_block_31;
  const Scalar t_right_hip_block_33 = t_right_hip_fork_186 - t_right_hip_block_32;
  w[154] = t_right_hip_block_33;
  const Scalar t_right_hip_block_34 = t_right_hip_fork_191 * t_right_hip_block_30;
  const Scalar t_right_hip_fork_138 = w[173];
  const Scalar t_right_hip_block_35 = base_rx_m3 + t_right_hip_fork_138 + t_right_hip_block_34;
  const Scalar t_right_hip_fork_178 = w[189];
  const Scalar t_right_hip_block_36 = t_right_hip_fork_178 * t_right_hip_block_29;
  w[156] = t_right_hip_block_36;
  const Scalar t_right_hip_block_37 = t_right_hip_fork_178 * t_right_hip_block_30;
  const Scalar t_right_hip_block_38 = t_right_hip_fork_194 + t_right_hip_block_37;
  w[157] = t_right_hip_block_38;
  const Scalar t_right_hip_fork_177 = w[188];
  const Scalar t_right_hip_block_39 = t_right_hip_fork_177 * t_right_hip_block_29;
  const Scalar t_right_hip_block_40 = t_right_hip_fork_191 * t_right_hip_block_39;
  const Scalar t_right_hip_fork_201 = c_right_hip_roll * t_right_hip_fork_114;
  const Scalar t_right_hip_block_41 = t_right_hip_fork_201 - t_right_hip_block_40;
  const Scalar t_right_hip_fork_202 = s_right_hip_roll * t_right_hip_fork_87;
  const Scalar t_right_hip_block_42 = t_right_hip_block_41 - t_right_hip_fork_202;
  const Scalar t_right_hip_fork_203 = left_hip_fork_l1 * t_right_hip_fork_194;
  const Scalar t_right_hip_block_43 = t_right_hip_block_42 + t_right_hip_fork_203;
  w[192] = t_right_hip_block_43;
  const Scalar t_right_hip_block_44 = left_hip_block_I18 * t_right_hip_block_30;
  w[193] = t_right_hip_block_44;
  const Scalar t_right_hip_block_45 = left_hip_fork_l1 * t_right_hip_fork_138;
  const Scalar t_right_hip_block_8 = w[127];
  const Scalar t_right_hip_block_46 = left_hip_block_I18 * t_right_hip_block_8;
  const Scalar t_right_hip_block_47 = u_right_hip_block - t_right_hip_block_46;
  const Scalar t_right_hip_block_48 = left_hip_block_h1 * t_right_hip_block_15;
  const Scalar t_right_hip_fork_22 = w[143];
  const Scalar t_right_hip_fork_204 = left_hip_fork_h2 * t_right_hip_fork_22;
  const Scalar t_right_hip_block_49 = t_right_hip_block_48 + t_right_hip_fork_204;
  const Scalar t_right_hip_fork_21 = w[141];
  const Scalar t_right_hip_fork_205 = left_hip_fork_h1 * t_right_hip_fork_21;
  const Scalar t_right_hip_block_50 = t_right_hip_block_49 + t_right_hip_fork_205;
  const Scalar s_q14_q15_q16 = w[19];
  const Scalar t_right_thigh_124 = w[146];
  const Scalar t_right_hip_block_51 = t_right_hip_block_50 - s_q14_q15_q16 * t_right_thigh_124;
  const Scalar t_right_hip_fork_12 = w[134];
  const Scalar t_right_hip_fork_206 = t_right_hip_fork_12 * t_right_hip_fork_63;
  const Scalar t_right_hip_block_52 = t_right_hip_block_51 + t_right_hip_fork_206;
  const Scalar t_right_hip_block_53 = left_hip_block_h4 + t_right_hip_block_45;
  const Scalar c_q14_q15_q16 = w[20];
  const Scalar t_right_thigh_116 = w[248];
  const Scalar t_right_hip_block_54 = t_right_hip_block_52 - c_q14_q15_q16 * t_right_thigh_116;
  const Scalar t_right_hip_block_55 = t_right_hip_block_17 * t_right_hip_block_53;
  const Scalar t_right_hip_block_56 = t_right_hip_block_54 + t_right_hip_block_55;
  const Scalar zeta_right_hip_block_y = w[124];
  const Scalar t_right_hip_block_57 = zeta_right_hip_block_y * t_right_hip_block_35;
  const Scalar t_right_hip_block_58 = t_right_hip_block_56 + t_right_hip_block_57;
  const Scalar t_right_hip_fork_17 = w[138];
  const Scalar t_right_hip_fork_207 = t_right_hip_fork_17 * t_right_hip_fork_87;
  const Scalar zeta_right_hip_block_z = w[126];
  const Scalar t_right_hip_block_59 = zeta_right_hip_block_z * t_right_hip_block_38;
  const Scalar t_right_hip_block_60 = t_right_hip_block_58 - t_right_hip_fork_207;
  const Scalar t_right_hip_block_61 = t_right_hip_block_60 - t_right_hip_block_59;
  const Scalar t_right_hip_fork_15 = w[136];
  const Scalar t_right_hip_fork_208 = t_right_hip_fork_15 * t_right_hip_fork_114;
  const Scalar t_right_hip_block_62 = t_right_hip_block_61 + t_right_hip_fork_208;
  const Scalar zeta_right_hip_fork_x = w[135];
  const Scalar t_right_hip_fork_209 = zeta_right_hip_fork_x * t_right_hip_fork_40;
  const Scalar t_right_hip_block_63 = t_right_hip_block_62 - t_right_hip_fork_209;
  const Scalar u_right_hip_fork = w[152];
  const Scalar t_right_hip_fork_38 = w[163];
  const Scalar t_right_hip_fork_210 = u_right_hip_fork * t_right_hip_fork_38;
  const Scalar t_right_hip_block_64 = t_right_hip_block_30 * t_right_hip_block_47;
  const Scalar t_right_hip_block_65 = t_right_hip_block_63 - t_right_hip_fork_210;
  const Scalar t_right_hip_block_66 = t_right_hip_block_65 + t_right_hip_block_64;
  const Scalar zeta_right_hip_block_x = w[125];
  const Scalar t_right_hip_block_67 = zeta_right_hip_block_x * t_right_hip_block_33;
  const Scalar t_right_hip_block_68 = t_right_hip_block_66 + t_right_hip_block_67;
  const Scalar t_right_hip_block_11 = w[128];
  const Scalar t_right_hip_block_69 = t_right_hip_block_11 * t_right_hip_block_43;
  const Scalar t_right_hip_block_70 = t_right_hip_block_68 - t_right_hip_block_69;
  w[194] = t_right_hip_block_70;
  const Scalar t_right_hip_block_71 = t_right_hip_fork_183 * t_right_hip_block_31;
  const Scalar t_right_hip_fork_145 = w[174];
  const Scalar t_right_hip_block_72 = base_rx_m3 + t_right_hip_fork_145 + t_right_hip_block_71;
  w[195] = t_right_hip_block_72;
  const Scalar t_right_hip_block_73 = t_right_hip_fork_183 * t_right_hip_block_36;
  const Scalar t_right_hip_fork_166 = w[182];
  const Scalar t_right_hip_block_74 = t_right_hip_fork_166 + t_right_hip_block_73;
  w[196] = t_right_hip_block_74;
  const Scalar t_right_hip_block_75 = t_right_hip_fork_177 * t_right_hip_block_31;
  const Scalar t_right_hip_fork_171 = w[183];
  const Scalar t_right_hip_block_76 = t_right_hip_fork_171 + t_right_hip_block_75;
  w[197] = t_right_hip_block_76;
  const Scalar t_right_hip_block_77 = left_hip_block_I18 * t_right_hip_block_31;
  w[199] = t_right_hip_block_77;
  const Scalar t_right_hip_block_78 = left_hip_block_h4 * t_right_hip_block_15;
  const Scalar t_right_hip_block_79 = t_right_hip_block_11 * t_right_hip_block_76;
  const Scalar t_right_hip_block_80 = t_right_hip_fork_197 + t_right_hip_block_78;
  const Scalar t_right_hip_block_81 = t_right_hip_block_80 - t_right_hip_block_79;
  const Scalar t_right_hip_block_82 = zeta_right_hip_block_x * t_right_hip_block_72;
  const Scalar t_right_hip_block_83 = t_right_hip_block_81 + t_right_hip_block_82;
  const Scalar t_right_hip_block_84 = zeta_right_hip_block_y * t_right_hip_block_33;
  const Scalar t_right_hip_block_85 = t_right_hip_block_83 + t_right_hip_block_84;
  const Scalar t_right_hip_block_86 = left_hip_block_h1 * t_right_hip_block_14;
  const Scalar t_right_hip_block_87 = t_right_hip_block_85 + t_right_hip_block_86;
  const Scalar t_right_hip_block_88 = zeta_right_hip_block_z * t_right_hip_block_74;
  const Scalar t_right_hip_block_89 = t_right_hip_block_87 + t_right_hip_block_88;
  const Scalar t_right_hip_block_90 = t_right_hip_block_31 * t_right_hip_block_47;
  const Scalar t_right_hip_block_91 = t_right_hip_block_89 - t_right_hip_block_90;
  w[200] = t_right_hip_block_91;
  const Scalar t_right_hip_block_92 = t_right_hip_fork_178 * t_right_hip_block_36;
  const Scalar t_right_hip_block_93 = t_right_hip_fork_179 + t_right_hip_block_92;
  w[201] = t_right_hip_block_93;
  const Scalar t_right_hip_block_94 = base_rx_m3 + t_right_hip_block_93;
  w[204] = t_right_hip_block_94;
  const Scalar t_right_hip_block_95 = left_hip_block_I18 * t_right_hip_block_36;
  const Scalar t_right_hip_block_96 = left_hip_block_h1 - t_right_hip_block_95;
  w[206] = t_right_hip_block_96;
  const Scalar t_right_hip_block_97 = t_right_hip_fork_178 * t_right_hip_block_39;
  const Scalar t_right_hip_fork_211 = left_hip_block_h4 - t_right_hip_fork_182;
  const Scalar t_right_hip_block_98 = t_right_hip_fork_211 - t_right_hip_block_97;
  w[207] = t_right_hip_block_98;
  const Scalar t_right_hip_block_99 = left_hip_block_I18 * t_right_hip_block_39;
  w[209] = t_right_hip_block_99;
  const Scalar t_right_hip_block_100 = left_hip_block_I8 - t_right_hip_block_99;
  w[210] = t_right_hip_block_100;
  const Scalar t_right_hip_block_101 = left_hip_block_p1 * t_right_hip_block_29;
  w[211] = t_right_hip_block_101;
  // right_hip_fork
  const Scalar t_right_hip_fork_212 = t_right_hip_fork_180 + t_right_hip_fork_182;
  const Scalar t_right_hip_fork_89 = w[169];
  const Scalar t_right_hip_fork_159 = w[180];
  const Scalar t_right_hip_fork_213 = t_right_hip_fork_89 - t_right_hip_fork_159;
  const Scalar t_right_hip_fork_214 = left_hip_fork_l1 * t_right_hip_fork_212;
  const Scalar t_right_hip_block_102 = t_right_hip_fork_177 * t_right_hip_block_39;
  const Scalar t_right_hip_fork_215 = t_right_hip_fork_213 + t_right_hip_fork_214;
  const Scalar t_right_hip_block_103 = t_right_hip_fork_215 - t_right_hip_block_102;
  w[213] = t_right_hip_block_103;
  const Scalar t_right_hip_fork_216 = c_right_hip_roll * t_right_hip_fork_58;
  const Scalar t_right_hip_fork_217 = s_right_hip_roll * t_right_hip_fork_85;
  const Scalar t_right_hip_fork_218 = t_right_hip_fork_216 - t_right_hip_fork_217;
  w[214] = t_right_hip_fork_218;
  // right_hip_block
  const Scalar t_right_hip_block_104 = left_hip_block_I16 - t_right_hip_block_103;
  const Scalar t_right_hip_block_105 = left_hip_block_I16 * t_right_hip_block_18;
  const Scalar t_right_hip_block_106 = left_hip_block_I8 * t_right_hip_block_16;
  const Scalar t_right_hip_block_107 = t_right_hip_block_105 + t_right_hip_block_106;
  const Scalar t_right_hip_block_108 = left_hip_block_I17 * t_right_hip_block_15;
  const Scalar t_right_hip_block_109 = t_right_hip_block_107 + t_right_hip_block_108;
  const Scalar t_right_hip_fork_219 = s_right_hip_roll * t_right_hip_fork_113;
  const Scalar t_right_hip_block_110 = t_right_hip_block_109 - t_right_hip_fork_219;
  const Scalar t_right_hip_fork_220 = c_right_hip_roll * t_right_hip_fork_136;
  const Scalar t_right_hip_block_111 = t_right_hip_block_11 * t_right_hip_block_104;
  const Scalar t_right_hip_block_112 = t_right_hip_block_110 - t_right_hip_fork_220;
  const Scalar t_right_hip_block_113 = t_right_hip_block_112 + t_right_hip_block_111;
  const Scalar t_right_hip_block_114 = t_right_hip_block_8 * t_right_hip_block_100;
  const Scalar t_right_hip_block_115 = t_right_hip_block_113 + t_right_hip_block_114;
  const Scalar t_right_hip_fork_221 = left_hip_fork_l1 * t_right_hip_fork_218;
  const Scalar t_right_hip_block_116 = t_right_hip_block_115 - t_right_hip_fork_221;
  const Scalar t_right_hip_block_117 = u_right_hip_block * t_right_hip_block_39;
  const Scalar t_right_hip_block_118 = t_right_hip_block_116 + t_right_hip_block_117;
  const Scalar t_right_hip_block_119 = zeta_right_hip_block_y * t_right_hip_block_43;
  const Scalar t_base_rx_21 = w[47];
  const Scalar t_right_hip_block_120 = t_base_rx_21 - t_right_hip_block_17;
  const Scalar t_right_hip_block_121 = t_right_hip_block_118 - t_right_hip_block_119;
  const Scalar t_right_hip_block_122 = left_hip_block_I18 * t_right_hip_block_120;
  const Scalar t_right_hip_block_123 = t_right_hip_block_121 + t_right_hip_block_122;
  const Scalar t_right_hip_block_124 = zeta_right_hip_block_x * t_right_hip_block_76;
  const Scalar t_right_hip_block_125 = t_right_hip_block_123 - t_right_hip_block_124;
  const Scalar t_right_hip_block_126 = zeta_right_hip_block_z * t_right_hip_block_98;
  const Scalar t_right_hip_block_127 = t_right_hip_block_125 + t_right_hip_block_126;
  w[215] = t_right_hip_block_127;
  const Scalar c_right_hip_yaw = w[16];
  const Scalar t_right_hip_block_128 = 2.0 * c_right_hip_yaw;
  const Scalar t_right_hip_block_129 = t_right_hip_block_35 - t_right_hip_block_72;
  const Scalar t_right_hip_block_130 = t_right_hip_block_33 * t_right_hip_block_128;
  const Scalar s_right_hip_yaw = w[15];
  const Scalar t_right_hip_block_131 = s_right_hip_yaw * t_right_hip_block_129;
  const Scalar t_right_hip_block_132 = t_right_hip_block_130 - t_right_hip_block_131;
  w[216] = t_right_hip_block_132;
  const Scalar t_right_hip_block_133 = s_right_hip_yaw * t_right_hip_block_132;
  w[222] = t_right_hip_block_133;
  const Scalar t_right_hip_block_134 = c_right_hip_yaw * t_right_hip_block_74;
  const Scalar t_right_hip_block_135 = s_right_hip_yaw * t_right_hip_block_38;
  const Scalar t_right_hip_block_136 = t_right_hip_block_134 + t_right_hip_block_135;
  w[223] = t_right_hip_block_136;
  const Scalar t_right_hip_block_137 = t_right_hip_block_43 - t_right_hip_block_77;
  const Scalar t_right_hip_block_138 = t_right_hip_block_44 - t_right_hip_block_76;
  const Scalar t_right_hip_block_139 = c_right_hip_yaw * t_right_hip_block_137;
  const Scalar t_right_hip_block_140 = s_right_hip_yaw * t_right_hip_block_138;
  const Scalar t_right_hip_block_141 = t_right_hip_block_139 - t_right_hip_block_140;
  const Scalar t_right_hip_block_142 = c_right_hip_yaw * t_right_hip_block_141;
  w[224] = t_right_hip_block_142;
  const Scalar t_right_hip_block_143 = c_right_hip_yaw * t_right_hip_block_96;
  const Scalar t_right_hip_block_144 = s_right_hip_yaw * t_right_hip_block_98;
  const Scalar t_right_hip_block_145 = t_right_hip_block_143 - t_right_hip_block_144;
  w[225] = t_right_hip_block_145;
  const Scalar t_right_hip_block_146 = left_hip_block_l1 * t_right_hip_block_94;
  const Scalar t_right_hip_block_147 = t_right_hip_block_145 + t_right_hip_block_146;
  const Scalar t_right_hip_block_148 = left_hip_block_l2 * t_right_hip_block_136;
  const Scalar t_right_hip_block_149 = t_right_hip_block_147 - t_right_hip_block_148;
  w[226] = t_right_hip_block_149;
  const Scalar t_right_hip_block_150 = left_hip_block_I7 + t_right_hip_block_101;
  w[227] = t_right_hip_block_150;
  const Scalar t_right_hip_block_151 = t_right_hip_block_104 - t_right_hip_block_150;
  const Scalar t_right_hip_block_152 = t_right_hip_block_100 * t_right_hip_block_128;
  const Scalar t_right_hip_block_153 = s_right_hip_yaw * t_right_hip_block_151;
  const Scalar t_right_hip_block_154 = t_right_hip_block_153 + t_right_hip_block_152;
  w[228] = t_right_hip_block_154;
  const Scalar t_right_hip_block_155 = s_right_hip_yaw * t_right_hip_block_141;
  w[229] = t_right_hip_block_155;
  const Scalar t_right_hip_block_156 = s_right_hip_yaw * t_right_hip_block_74;
  const Scalar t_right_hip_block_157 = c_right_hip_yaw * t_right_hip_block_38;
  const Scalar t_right_hip_block_158 = t_right_hip_block_156 - t_right_hip_block_157;
  w[238] = t_right_hip_block_158;
  const Scalar t_right_hip_block_159 = t_right_hip_block_35 + t_right_hip_block_133;
  w[239] = t_right_hip_block_159;
  // left_foot
  const Scalar t_left_foot_12 = w[119];
  const Scalar t_left_foot_7 = w[116];
  const Scalar t_left_foot_17 = t_left_foot_12 + t_left_foot_7 * t_left_foot_7;
  const Scalar t_left_foot_15 = w[122];
  const Scalar t_left_foot_18 = tau[11] - left_foot_I14 * (t_left_foot_15 - t_left_foot_17);
  const Scalar t_left_foot_14 = w[121];
  const Scalar t_left_foot_19 = t_left_foot_18 + left_foot_I2 * t_left_foot_14;
  const Scalar t_left_foot_16 = w[123];
  const Scalar t_left_foot_20 = t_left_foot_19 + left_foot_I1 * t_left_foot_16;
  const Scalar t_left_foot_13 = w[120];
  const Scalar u_left_foot = t_left_foot_20 + left_foot_I4 * t_left_foot_13;
  w[240] = u_left_foot;
  const Scalar t_left_foot_21 = left_foot_h1 * t_left_foot_13 - left_foot_p2 * u_left_foot;
  const Scalar t_left_foot_8 = w[117];
  const Scalar t_left_foot_22 = t_left_foot_21 - left_foot_h3 * t_left_foot_8;
  const Scalar t_left_foot_10 = w[118];
  const Scalar t_left_foot_23 = t_left_foot_22 - left_foot_h2 * t_left_foot_10;
  const Scalar zeta_left_foot_y = w[115];
  const Scalar t_left_foot_24 = t_left_foot_23 + left_foot_m1 * zeta_left_foot_y;
  w[241] = t_left_foot_24;
  const Scalar t_left_foot_25 = left_foot_h1 * t_left_foot_15;
  w[242] = t_left_foot_25;
  const Scalar t_left_foot_26 = left_foot_I16 * t_left_foot_8;
  const Scalar t_left_ankle_cross_13 = w[111];
  const Scalar t_left_foot_27 = left_foot_I1 * (t_left_ankle_cross_13 - t_left_foot_17);
  const Scalar t_left_foot_28 = t_left_foot_26 + left_foot_I17 * t_left_foot_10;
  const Scalar t_left_foot_29 = t_left_foot_28 + t_left_foot_27;
  const Scalar t_left_foot_30 = t_left_foot_29 + left_foot_k3 * t_left_foot_18;
  const Scalar t_left_foot_31 = t_left_foot_30 + left_foot_I20 * t_left_foot_14;
  const Scalar t_left_foot_32 = t_left_foot_31 + left_foot_I21 * t_left_foot_16;
  const Scalar t_left_foot_33 = t_left_foot_32 - left_foot_I22 * t_left_foot_13;
  const Scalar t_left_foot_34 = t_left_foot_33 - left_foot_h2 * zeta_left_foot_y;
  w[243] = t_left_foot_34;
  const Scalar t_left_thigh_11 = w[79];
  const Scalar t_left_foot_35 = left_foot_I6 * t_left_thigh_11;
  const Scalar t_left_foot_36 = t_left_foot_35 + left_foot_I16 * t_left_foot_10;
  const Scalar t_left_foot_37 = left_foot_I2 * (t_left_ankle_cross_13 - t_left_foot_15);
  const Scalar t_left_foot_38 = t_left_foot_36 - left_foot_I15 * t_left_foot_8;
  const Scalar t_left_ankle_cross_14 = w[112];
  const Scalar t_left_foot_39 = left_foot_I7 * t_left_ankle_cross_14;
  const Scalar t_left_foot_40 = t_left_foot_38 - t_left_foot_37 - t_left_foot_39;
  const Scalar t_left_foot_41 = t_left_foot_40 + left_foot_I23 * t_left_foot_13;
  const Scalar t_left_foot_42 = t_left_foot_41 + left_foot_I21 * t_left_foot_14;
  const Scalar t_left_foot_43 = t_left_foot_42 + left_foot_I24 * t_left_foot_16;
  const Scalar t_left_foot_44 = t_left_foot_43 + left_foot_k2 * t_left_foot_18;
  w[244] = t_left_foot_44;
}

[[gnu::noinline]] void forward_dynamics_6(const Scalar tau[18], Scalar w[278]) noexcept {
  // left_foot
  const Scalar t_left_foot_44 = w[244];
  const Scalar zeta_left_foot_y = w[115];
  const Scalar t_left_foot_45 = t_left_foot_44 - left_foot_h3 * zeta_left_foot_y;
  const Scalar t_left_foot_8 = w[117];
  const Scalar t_left_foot_16 = w[123];
  const Scalar t_left_foot_46 = t_left_foot_8 - t_left_foot_16;
  const Scalar s_left_foot = w[13];
  const Scalar t_left_foot_47 = left_foot_m1 * s_left_foot;
  const Scalar t_left_foot_48 = s_left_foot * t_left_foot_47;
  const Scalar c_left_foot = w[14];
  const Scalar t_left_foot_49 = c_left_foot * t_left_foot_47;
  const Scalar t_left_foot_50 = left_foot_h4 - left_hip_fork_l1 * t_left_foot_48;
  const Scalar t_left_foot_51 = t_left_foot_50 + left_hip_fork_l3 * t_left_foot_49;
  const Scalar t_left_foot_52 = left_hip_fork_l3 * t_left_foot_48;
  const Scalar t_left_foot_53 = t_left_foot_52 + left_hip_fork_l1 * t_left_foot_49;
  const Scalar t_left_foot_54 = left_foot_h3 * s_left_foot - left_foot_h2 * c_left_foot;
  const Scalar t_left_foot_55 = s_left_foot * t_left_foot_54;
  const Scalar t_left_foot_56 = left_foot_h3 - t_left_foot_55;
  w[116] = t_left_foot_56;
  const Scalar t_left_foot_57 = c_left_foot * t_left_foot_54;
  const Scalar t_left_foot_58 = left_ankle_cross_I16 + left_hip_fork_l1 * t_left_foot_55;
  const Scalar t_left_foot_59 = t_left_foot_58 - left_hip_fork_l3 * t_left_foot_57;
  w[119] = t_left_foot_59;
  const Scalar t_left_foot_60 = left_foot_I19 * s_left_foot + left_foot_I18 * c_left_foot;
  const Scalar t_left_foot_61 = left_ankle_cross_I12 + left_foot_I6 * s_left_foot;
  const Scalar t_left_foot_62 = c_left_foot * (left_foot_I7 + t_left_foot_60);
  const Scalar t_left_foot_63 = t_left_foot_61 + t_left_foot_62;
  w[120] = t_left_foot_63;
  const Scalar t_left_foot_64 = s_left_foot * t_left_foot_60;
  const Scalar t_left_foot_65 = left_ankle_cross_I13 - t_left_foot_64;
  const Scalar t_left_foot_66 = t_left_foot_65 + left_foot_I5 * c_left_foot;
  w[121] = t_left_foot_66;
  const Scalar t_left_foot_67 = left_ankle_cross_h3 - t_left_foot_57;
  const Scalar t_left_foot_68 = left_ankle_cross_h1 + left_foot_h1 * c_left_foot;
  w[122] = t_left_foot_68;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_13 = w[111];
  const Scalar t_left_ankle_cross_15 = w[113];
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_13 - t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_18 = tau[10] + c_left_foot * t_left_foot_45;
  const Scalar t_left_thigh_11 = w[79];
  const Scalar t_left_ankle_cross_19 = left_ankle_cross_I14 * t_left_thigh_11;
  const Scalar t_left_ankle_cross_20 = t_left_ankle_cross_18 - t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_16 = w[114];
  const Scalar t_left_ankle_cross_21 = left_ankle_cross_I1 * t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_22 = t_left_ankle_cross_20 + t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_14 = w[112];
  const Scalar t_left_ankle_cross_23 = left_ankle_cross_I11 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_24 = t_left_ankle_cross_22 - t_left_ankle_cross_23;
  const Scalar t_left_foot_34 = w[243];
  const Scalar t_left_ankle_cross_25 = t_left_ankle_cross_24 + s_left_foot * t_left_foot_34;
  const Scalar t_left_ankle_cross_26 = t_left_ankle_cross_25 - left_foot_I6 * t_left_foot_46;
  const Scalar t_left_ankle_cross_27 = left_ankle_cross_I6 * t_left_ankle_cross_17;
  const Scalar u_left_ankle_cross = t_left_ankle_cross_26 - t_left_ankle_cross_27;
  w[132] = u_left_ankle_cross;
  const Scalar t_left_ankle_cross_28 = 1.0 / t_left_foot_66;
  w[141] = t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_29 = t_left_foot_68 * t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_30 = t_left_foot_68 * t_left_ankle_cross_29;
  const Scalar t_left_ankle_cross_31 = left_shank_m2 - t_left_ankle_cross_30;
  const Scalar t_left_ankle_cross_32 = t_left_foot_67 * t_left_ankle_cross_29;
  const Scalar t_left_ankle_cross_33 = t_left_foot_67 * t_left_ankle_cross_28;
  w[143] = t_left_ankle_cross_33;
  const Scalar t_left_ankle_cross_34 = t_left_foot_56 * t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_35 = t_left_foot_68 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_36 = t_left_foot_63 * t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_37 = t_left_foot_68 * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_38 = left_foot_h1 * s_left_foot - t_left_ankle_cross_37;
  const Scalar t_left_ankle_cross_39 = t_left_foot_59 * t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_40 = t_left_foot_68 * t_left_ankle_cross_39;
  const Scalar t_left_ankle_cross_41 = t_left_foot_67 * t_left_ankle_cross_33;
  const Scalar t_left_ankle_cross_42 = t_left_foot_48 + t_left_ankle_cross_41;
  const Scalar t_left_ankle_cross_43 = left_shank_m2 - t_left_ankle_cross_42;
  const Scalar t_left_ankle_cross_44 = t_left_foot_56 * t_left_ankle_cross_33;
  const Scalar t_left_ankle_cross_45 = t_left_foot_49 - t_left_ankle_cross_44;
  const Scalar t_left_ankle_cross_46 = t_left_foot_67 * t_left_ankle_cross_39;
  const Scalar t_left_ankle_cross_47 = t_left_foot_53 + t_left_ankle_cross_46;
  const Scalar t_left_ankle_cross_48 = t_left_foot_67 * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_49 = t_left_foot_55 + t_left_ankle_cross_48;
  const Scalar t_left_foot_25 = w[242];
  const Scalar t_left_foot_24 = w[241];
  const Scalar t_left_foot_69 = c_left_foot * t_left_foot_25 - s_left_foot * t_left_foot_24;
  const Scalar t_left_ankle_cross_50 = t_left_foot_69 - left_ankle_cross_h2 * t_left_thigh_11;
  const Scalar t_left_ankle_cross_11 = w[110];
  const Scalar t_left_ankle_cross_51 = t_left_ankle_cross_11 * t_left_ankle_cross_47;
  const Scalar t_left_ankle_cross_52 = t_left_ankle_cross_50 + t_left_ankle_cross_51;
  const Scalar t_left_ankle_cross_6 = w[107];
  const Scalar t_left_ankle_cross_53 = t_left_ankle_cross_6 * t_left_ankle_cross_32;
  const Scalar t_left_ankle_cross_54 = t_left_ankle_cross_52 - t_left_ankle_cross_53;
  const Scalar t_left_ankle_cross_9 = w[108];
  const Scalar t_left_ankle_cross_55 = t_left_ankle_cross_9 * t_left_ankle_cross_45;
  const Scalar t_left_ankle_cross_56 = t_left_ankle_cross_54 + t_left_ankle_cross_55;
  const Scalar t_left_ankle_cross_57 = u_left_ankle_cross * t_left_ankle_cross_33;
  const Scalar t_left_ankle_cross_58 = t_left_ankle_cross_56 - t_left_ankle_cross_57;
  const Scalar t_left_ankle_cross_10 = w[109];
  const Scalar t_left_ankle_cross_59 = t_left_ankle_cross_10 * t_left_ankle_cross_49;
  const Scalar t_left_ankle_cross_60 = t_left_ankle_cross_58 - t_left_ankle_cross_59;
  const Scalar t_left_ankle_cross_61 = left_ankle_cross_h1 * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_62 = t_left_ankle_cross_60 + t_left_ankle_cross_61;
  const Scalar zeta_left_ankle_cross_x = w[106];
  const Scalar t_left_ankle_cross_63 = zeta_left_ankle_cross_x * t_left_ankle_cross_43;
  const Scalar t_left_ankle_cross_64 = t_left_ankle_cross_62 - t_left_ankle_cross_63;
  const Scalar t_left_ankle_cross_65 = t_left_foot_56 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_66 = t_left_foot_48 - t_left_ankle_cross_65;
  const Scalar t_left_ankle_cross_67 = left_shank_m3 + t_left_ankle_cross_66;
  const Scalar t_left_ankle_cross_68 = t_left_foot_56 * t_left_ankle_cross_39;
  const Scalar t_left_foot_70 = left_ankle_cross_h1 - t_left_foot_51;
  const Scalar t_left_ankle_cross_69 = t_left_foot_70 + t_left_ankle_cross_68;
  const Scalar t_left_ankle_cross_70 = t_left_foot_63 * t_left_ankle_cross_34;
  const Scalar t_left_foot_71 = left_ankle_cross_h2 + t_left_foot_57;
  const Scalar t_left_ankle_cross_71 = t_left_foot_71 - t_left_ankle_cross_70;
  const Scalar t_left_foot_72 = s_left_foot * t_left_foot_25 + c_left_foot * t_left_foot_24;
  const Scalar t_left_ankle_cross_72 = t_left_ankle_cross_6 * t_left_foot_68;
  const Scalar t_left_ankle_cross_73 = t_left_ankle_cross_11 * t_left_ankle_cross_69;
  const Scalar t_left_ankle_cross_74 = left_ankle_cross_h1 * t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_75 = t_left_foot_72 + t_left_ankle_cross_73;
  const Scalar t_left_ankle_cross_76 = t_left_ankle_cross_75 + t_left_ankle_cross_74;
  const Scalar t_left_ankle_cross_77 = t_left_ankle_cross_10 * t_left_ankle_cross_71;
  const Scalar t_left_ankle_cross_78 = t_left_ankle_cross_76 + t_left_ankle_cross_77;
  const Scalar t_left_ankle_cross_79 = zeta_left_ankle_cross_x * t_left_ankle_cross_45;
  const Scalar t_left_ankle_cross_80 = t_left_ankle_cross_78 - t_left_ankle_cross_79;
  const Scalar t_left_ankle_cross_81 = left_ankle_cross_h2 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_82 = u_left_ankle_cross + t_left_ankle_cross_72;
  const Scalar t_left_ankle_cross_83 = t_left_ankle_cross_80 + t_left_ankle_cross_81;
  const Scalar t_left_ankle_cross_84 = t_left_ankle_cross_34 * t_left_ankle_cross_82;
  const Scalar t_left_ankle_cross_85 = t_left_ankle_cross_83 - t_left_ankle_cross_84;
  const Scalar t_left_ankle_cross_86 = t_left_ankle_cross_9 * t_left_ankle_cross_67;
  const Scalar t_left_ankle_cross_87 = t_left_ankle_cross_85 + t_left_ankle_cross_86;
  const Scalar t_left_ankle_cross_1 = w[12];
  const Scalar t_left_ankle_cross_88 = t_left_ankle_cross_1 * t_left_ankle_cross_67;
  const Scalar t_left_ankle_cross_89 = t_left_ankle_cross_71 + t_left_ankle_cross_88;
  const Scalar s_left_ankle_cross_x = w[11];
  const Scalar t_left_ankle_cross_90 = s_left_ankle_cross_x * t_left_ankle_cross_67;
  const Scalar t_left_ankle_cross_91 = t_left_ankle_cross_69 + t_left_ankle_cross_90;
  const Scalar t_left_shank_15 = w[97];
  const Scalar t_left_shank_26 = left_shank_I8 - t_left_shank_15;
  const Scalar t_left_ankle_cross_92 = t_left_ankle_cross_1 * t_left_ankle_cross_43;
  const Scalar t_left_ankle_cross_93 = s_left_ankle_cross_x * t_left_ankle_cross_32;
  const Scalar t_left_ankle_cross_94 = t_left_ankle_cross_92 - t_left_ankle_cross_93;
  const Scalar t_left_ankle_cross_95 = t_left_ankle_cross_1 * t_left_ankle_cross_32;
  const Scalar t_left_ankle_cross_96 = s_left_ankle_cross_x * t_left_ankle_cross_31;
  const Scalar t_left_ankle_cross_97 = t_left_ankle_cross_96 - t_left_ankle_cross_95;
  const Scalar t_left_ankle_cross_98 = t_left_ankle_cross_1 * t_left_ankle_cross_94;
  const Scalar t_left_shank_20 = w[101];
  const Scalar t_left_shank_27 = t_left_shank_20 - t_left_shank_26;
  const Scalar t_left_ankle_cross_99 = s_left_ankle_cross_x * t_left_ankle_cross_97;
  const Scalar t_left_ankle_cross_100 = t_left_shank_27 - t_left_ankle_cross_98;
  const Scalar t_left_ankle_cross_101 = t_left_ankle_cross_100 - t_left_ankle_cross_99;
  w[146] = t_left_ankle_cross_101;
  const Scalar t_left_ankle_cross_102 = t_left_ankle_cross_1 * t_left_ankle_cross_45;
  const Scalar t_left_ankle_cross_103 = t_left_ankle_cross_49 - t_left_ankle_cross_102;
  const Scalar t_left_ankle_cross_104 = t_left_ankle_cross_1 * t_left_ankle_cross_35;
  const Scalar t_left_ankle_cross_105 = t_left_ankle_cross_38 - t_left_ankle_cross_104;
  const Scalar t_left_ankle_cross_106 = t_left_ankle_cross_1 * t_left_ankle_cross_103;
  const Scalar t_left_ankle_cross_107 = s_left_ankle_cross_x * t_left_ankle_cross_105;
  const Scalar t_left_shank_23 = w[103];
  const Scalar t_left_ankle_cross_108 = t_left_shank_23 - t_left_ankle_cross_106;
  const Scalar t_left_ankle_cross_109 = t_left_ankle_cross_108 + t_left_ankle_cross_107;
  w[163] = t_left_ankle_cross_109;
  const Scalar t_left_ankle_cross_110 = s_left_ankle_cross_x * t_left_ankle_cross_45;
  const Scalar t_left_ankle_cross_111 = t_left_ankle_cross_47 + t_left_ankle_cross_110;
  const Scalar t_left_ankle_cross_112 = s_left_ankle_cross_x * t_left_ankle_cross_35;
  const Scalar t_left_ankle_cross_113 = t_left_ankle_cross_40 - t_left_ankle_cross_112;
  const Scalar t_left_ankle_cross_114 = t_left_ankle_cross_1 * t_left_ankle_cross_111;
  const Scalar t_left_ankle_cross_115 = s_left_ankle_cross_x * t_left_ankle_cross_113;
  const Scalar t_left_shank_18 = w[99];
  const Scalar t_left_ankle_cross_116 = t_left_shank_18 + t_left_ankle_cross_114;
  const Scalar t_left_ankle_cross_117 = t_left_ankle_cross_116 + t_left_ankle_cross_115;
  w[164] = t_left_ankle_cross_117;
  const Scalar t_left_shank_25 = w[105];
  const Scalar t_left_ankle_cross_118 = t_left_shank_25 - t_left_ankle_cross_94;
  w[165] = t_left_ankle_cross_118;
  const Scalar t_left_shank_24 = w[104];
  const Scalar t_left_ankle_cross_119 = t_left_shank_24 + t_left_ankle_cross_97;
  w[166] = t_left_ankle_cross_119;
  const Scalar t_left_ankle_cross_120 = t_left_ankle_cross_102 - t_left_ankle_cross_112;
  w[167] = t_left_ankle_cross_120;
  const Scalar t_left_ankle_cross_121 = t_left_ankle_cross_9 * t_left_foot_56;
  const Scalar t_left_ankle_cross_122 = left_ankle_cross_h2 * t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_123 = left_ankle_cross_h1 * t_left_thigh_11;
  const Scalar t_left_ankle_cross_124 = t_left_ankle_cross_122 - t_left_ankle_cross_123;
  const Scalar t_left_ankle_cross_125 = t_left_ankle_cross_11 * t_left_ankle_cross_40;
  const Scalar t_left_ankle_cross_126 = t_left_ankle_cross_124 - t_left_ankle_cross_125;
  const Scalar t_left_ankle_cross_127 = zeta_left_ankle_cross_x * t_left_ankle_cross_32;
  const Scalar t_left_ankle_cross_128 = t_left_ankle_cross_126 - t_left_ankle_cross_127;
  const Scalar t_left_ankle_cross_129 = t_left_ankle_cross_128 + left_foot_h1 * t_left_foot_46;
  const Scalar t_left_ankle_cross_130 = t_left_ankle_cross_10 * t_left_ankle_cross_38;
  const Scalar t_left_ankle_cross_131 = t_left_ankle_cross_129 - t_left_ankle_cross_130;
  const Scalar t_left_ankle_cross_132 = t_left_ankle_cross_6 * t_left_ankle_cross_31;
  const Scalar t_left_ankle_cross_133 = u_left_ankle_cross + t_left_ankle_cross_121;
  const Scalar t_left_ankle_cross_134 = t_left_ankle_cross_131 - t_left_ankle_cross_132;
  const Scalar t_left_ankle_cross_135 = t_left_ankle_cross_29 * t_left_ankle_cross_133;
  const Scalar t_left_ankle_cross_136 = t_left_ankle_cross_134 + t_left_ankle_cross_135;
  const Scalar t_left_ankle_cross_137 = t_left_ankle_cross_1 * t_left_ankle_cross_64;
  // left_shank
  const Scalar t_left_shank_28 = t_left_thigh_11 * (t_left_shank_20 + t_left_shank_26);
  const Scalar t_left_shank_29 = tau[10] - tau[9] - t_left_ankle_cross_137 + t_left_shank_28;
  const Scalar t_left_shank_16 = w[98];
  const Scalar t_left_shank_30 = t_left_shank_29 + t_left_shank_16 * t_left_shank_18;
  const Scalar t_left_shank_21 = w[102];
  const Scalar t_left_shank_31 = t_left_shank_30 + t_left_shank_21 * t_left_shank_23;
  const Scalar t_left_shank_14 = w[96];
  const Scalar t_left_shank_32 = t_left_shank_31 + t_left_shank_14 * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_138 = s_left_ankle_cross_x * t_left_ankle_cross_136;
  const Scalar t_left_shank_33 = t_left_shank_32 + t_left_ankle_cross_138;
  w[168] = t_left_shank_33;
  const Scalar t_left_shank_34 = 1.0 / t_left_ankle_cross_101;
  w[169] = t_left_shank_34;
  const Scalar t_left_shank_35 = t_left_ankle_cross_119 * t_left_shank_34;
  const Scalar t_left_shank_36 = t_left_ankle_cross_119 * t_left_shank_35;
  const Scalar t_left_shank_37 = left_thigh_m2 - t_left_ankle_cross_30 + t_left_shank_36;
  w[170] = t_left_shank_37;
  const Scalar t_left_shank_38 = t_left_ankle_cross_118 * t_left_shank_34;
  const Scalar t_left_shank_39 = t_left_ankle_cross_119 * t_left_shank_38;
  const Scalar t_left_shank_40 = t_left_ankle_cross_32 + t_left_shank_39;
  w[171] = t_left_shank_40;
  const Scalar t_left_shank_41 = t_left_ankle_cross_120 * t_left_shank_34;
  const Scalar t_left_shank_42 = t_left_ankle_cross_119 * t_left_shank_41;
  const Scalar t_left_shank_43 = t_left_ankle_cross_35 - t_left_shank_42;
  w[172] = t_left_shank_43;
  const Scalar t_left_shank_44 = t_left_ankle_cross_109 * t_left_shank_35;
  const Scalar t_left_shank_45 = t_left_ankle_cross_105 + t_left_shank_44;
  const Scalar t_left_shank_46 = t_left_ankle_cross_117 * t_left_shank_35;
  const Scalar t_left_shank_47 = t_left_ankle_cross_113 + t_left_shank_46;
  const Scalar t_left_shank_48 = t_left_ankle_cross_136 - t_left_thigh_11 * t_left_shank_24;
  const Scalar t_left_shank_6 = w[91];
  const Scalar t_left_shank_49 = t_left_shank_48 + t_left_shank_6 * t_left_shank_43;
  const Scalar t_left_shank_7 = w[92];
  const Scalar t_left_shank_50 = t_left_shank_49 - t_left_shank_7 * t_left_shank_45;
  const Scalar zeta_left_shank_x = w[90];
  const Scalar t_left_shank_51 = t_left_shank_50 - zeta_left_shank_x * t_left_shank_40;
  const Scalar t_left_shank_19 = w[100];
  const Scalar t_left_shank_52 = t_left_shank_51 - t_left_shank_19 * t_left_shank_25;
  const Scalar t_left_shank_53 = t_left_shank_52 + t_left_shank_33 * t_left_shank_35;
  const Scalar t_left_shank_8 = w[93];
  const Scalar t_left_shank_54 = t_left_shank_53 - t_left_shank_8 * t_left_shank_47;
  const Scalar t_left_shank_3 = w[89];
  const Scalar t_left_shank_55 = t_left_shank_54 - t_left_shank_3 * t_left_shank_37;
  const Scalar t_left_shank_56 = t_left_ankle_cross_118 * t_left_shank_38;
  const Scalar t_left_shank_57 = left_thigh_m2 - t_left_ankle_cross_42 + t_left_shank_56;
  w[173] = t_left_shank_57;
  const Scalar t_left_shank_58 = t_left_ankle_cross_118 * t_left_shank_41;
  const Scalar t_left_shank_59 = t_left_ankle_cross_45 - t_left_shank_58;
  w[174] = t_left_shank_59;
  const Scalar t_left_shank_60 = t_left_ankle_cross_109 * t_left_shank_34;
  const Scalar t_left_shank_61 = t_left_ankle_cross_118 * t_left_shank_60;
  const Scalar t_left_shank_62 = t_left_ankle_cross_103 + t_left_shank_61;
  const Scalar t_left_shank_63 = t_left_ankle_cross_117 * t_left_shank_38;
  const Scalar t_left_shank_64 = t_left_ankle_cross_111 - t_left_shank_63;
  const Scalar t_left_shank_10 = w[94];
  const Scalar t_left_shank_65 = t_left_shank_10 * t_left_shank_24;
  const Scalar t_left_ankle_cross_139 = t_left_ankle_cross_64 + t_left_shank_65;
  const Scalar t_left_shank_66 = t_left_thigh_11 * t_left_shank_25;
  const Scalar t_left_ankle_cross_140 = t_left_ankle_cross_139 + t_left_shank_66;
  const Scalar t_left_shank_67 = t_left_ankle_cross_140 - t_left_shank_3 * t_left_shank_40;
  const Scalar t_left_shank_68 = t_left_shank_67 + t_left_shank_6 * t_left_shank_59;
  const Scalar t_left_shank_69 = t_left_shank_68 - zeta_left_shank_x * t_left_shank_57;
  const Scalar t_left_shank_70 = t_left_shank_69 + t_left_shank_33 * t_left_shank_38;
  const Scalar t_left_shank_71 = t_left_shank_70 - t_left_shank_7 * t_left_shank_62;
  const Scalar t_left_shank_72 = t_left_shank_71 + t_left_shank_8 * t_left_shank_64;
  const Scalar t_left_shank_73 = t_left_ankle_cross_120 * t_left_shank_41;
  const Scalar t_left_shank_74 = left_thigh_m3 + t_left_ankle_cross_66 + t_left_shank_73;
  w[175] = t_left_shank_74;
  const Scalar t_left_ankle_cross_141 = t_left_shank_24 + t_left_ankle_cross_91;
  const Scalar t_left_shank_75 = t_left_ankle_cross_117 * t_left_shank_41;
  const Scalar t_left_shank_76 = t_left_ankle_cross_141 + t_left_shank_75;
  const Scalar t_left_ankle_cross_142 = t_left_shank_25 - t_left_ankle_cross_89;
  const Scalar t_left_shank_77 = t_left_ankle_cross_120 * t_left_shank_60;
  const Scalar t_left_shank_78 = t_left_ankle_cross_142 - t_left_shank_77;
  const Scalar t_left_shank_79 = t_left_ankle_cross_87 - t_left_shank_21 * t_left_shank_25;
  const Scalar t_left_shank_80 = t_left_shank_79 - t_left_shank_3 * t_left_shank_43;
  const Scalar t_left_shank_81 = t_left_shank_80 + t_left_shank_8 * t_left_shank_76;
  const Scalar t_left_shank_82 = t_left_shank_81 + t_left_shank_16 * t_left_shank_24;
  const Scalar t_left_shank_83 = t_left_shank_82 - t_left_shank_7 * t_left_shank_78;
  const Scalar t_left_shank_84 = t_left_shank_83 - zeta_left_shank_x * t_left_shank_59;
  const Scalar t_left_shank_85 = t_left_shank_84 - t_left_shank_33 * t_left_shank_41;
  const Scalar t_left_shank_86 = t_left_shank_85 + t_left_shank_6 * t_left_shank_74;
  w[180] = t_left_shank_86;
  const Scalar t_left_shank_87 = t_left_ankle_cross_117 * t_left_shank_34;
  const Scalar t_left_shank_13 = w[95];
  const Scalar t_left_shank_88 = left_shank_I15 - t_left_shank_13;
  const Scalar t_left_foot_73 = left_hip_fork_l3 * t_left_foot_55;
  const Scalar t_left_foot_74 = t_left_foot_73 + left_hip_fork_l1 * t_left_foot_57;
  const Scalar t_left_shank_89 = t_left_foot_74 + t_left_foot_59 * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_143 = t_left_ankle_cross_1 * t_left_ankle_cross_69;
  const Scalar t_left_shank_90 = t_left_shank_88 + t_left_shank_89 + t_left_ankle_cross_143;
  const Scalar t_left_shank_91 = t_left_shank_90 + t_left_ankle_cross_109 * t_left_shank_87;
  const Scalar t_left_ankle_cross_144 = s_left_ankle_cross_x * t_left_ankle_cross_89;
  const Scalar t_left_shank_92 = t_left_shank_91 + t_left_ankle_cross_144;
  const Scalar t_left_shank_1 = w[10];
  const Scalar t_left_shank_93 = t_left_shank_78 - t_left_shank_1 * t_left_shank_74;
  w[182] = t_left_shank_93;
  const Scalar s_left_shank_x = w[9];
  const Scalar t_left_shank_94 = t_left_shank_76 + s_left_shank_x * t_left_shank_74;
  w[183] = t_left_shank_94;
  const Scalar t_left_shank_95 = t_left_shank_64 + s_left_shank_x * t_left_shank_59;
  const Scalar t_left_shank_96 = s_left_shank_x * t_left_shank_43;
  const Scalar t_left_shank_97 = t_left_shank_47 - t_left_shank_96;
  const Scalar t_left_thigh_15 = w[82];
  const Scalar t_left_shank_98 = t_left_thigh_15 - t_left_shank_1 * t_left_shank_95;
  const Scalar t_left_shank_99 = t_left_shank_98 - s_left_shank_x * t_left_shank_97;
  w[190] = t_left_shank_99;
  const Scalar t_left_shank_100 = t_left_shank_1 * t_left_shank_57;
  const Scalar t_left_shank_101 = t_left_shank_100 - s_left_shank_x * t_left_shank_40;
  const Scalar t_left_shank_102 = t_left_shank_1 * t_left_shank_40;
  const Scalar t_left_shank_103 = t_left_shank_102 - s_left_shank_x * t_left_shank_37;
  const Scalar t_left_thigh_13 = w[80];
  const Scalar t_left_thigh_18 = w[84];
  const Scalar t_right_thigh_172 = t_left_thigh_13 - t_left_thigh_18;
  const Scalar t_left_shank_104 = t_right_thigh_172 + t_left_shank_1 * t_left_shank_101;
  const Scalar t_left_shank_105 = t_left_shank_104 - s_left_shank_x * t_left_shank_103;
  w[191] = t_left_shank_105;
  const Scalar t_left_shank_106 = t_left_shank_45 - t_left_shank_1 * t_left_shank_43;
  const Scalar t_left_shank_107 = t_left_shank_1 * t_left_shank_59;
  const Scalar t_left_shank_108 = t_left_shank_62 - t_left_shank_107;
  const Scalar t_left_thigh_20 = w[86];
  const Scalar t_left_shank_109 = t_left_thigh_20 + s_left_shank_x * t_left_shank_106;
  const Scalar t_left_shank_110 = t_left_shank_109 - t_left_shank_1 * t_left_shank_108;
  w[245] = t_left_shank_110;
  const Scalar t_left_thigh_22 = w[88];
  const Scalar t_left_shank_111 = t_left_thigh_22 - t_left_shank_103;
  w[246] = t_left_shank_111;
  const Scalar t_left_thigh_21 = w[87];
  const Scalar t_left_shank_112 = t_left_thigh_21 - t_left_shank_101;
  w[247] = t_left_shank_112;
  const Scalar t_left_shank_113 = t_left_shank_96 - t_left_shank_107;
  w[248] = t_left_shank_113;
  // left_thigh
  const Scalar t_left_thigh_23 = tau[9] - tau[8] + s_left_shank_x * t_left_shank_55;
  const Scalar t_left_thigh_24 = t_left_thigh_23 - t_left_shank_1 * t_left_shank_72;
  const Scalar t_left_thigh_10 = w[78];
  const Scalar t_left_thigh_25 = t_left_thigh_24 + t_left_thigh_10 * t_left_ankle_cross_17;
  const Scalar t_left_thigh_26 = t_left_thigh_11 * (t_left_thigh_13 + t_left_thigh_18);
  const Scalar t_left_thigh_19 = w[85];
  const Scalar t_left_thigh_27 = t_left_thigh_25 + t_left_thigh_19 * t_left_thigh_20;
  const Scalar t_left_thigh_28 = t_left_thigh_27 + t_left_thigh_26;
  const Scalar t_left_thigh_14 = w[81];
  const Scalar t_left_thigh_29 = t_left_thigh_28 - t_left_thigh_14 * t_left_thigh_15;
  w[249] = t_left_thigh_29;
  const Scalar inverse_pivot_left_thigh = 1.0 / t_left_shank_105;
  w[250] = inverse_pivot_left_thigh;
  const Scalar t_left_thigh_30 = t_left_shank_111 * inverse_pivot_left_thigh;
  w[251] = t_left_thigh_30;
  const Scalar t_left_thigh_31 = t_left_shank_97 + t_left_shank_99 * t_left_thigh_30;
  w[252] = t_left_thigh_31;
  const Scalar t_left_thigh_32 = t_left_shank_110 * inverse_pivot_left_thigh;
  w[253] = t_left_thigh_32;
  const Scalar t_left_thigh_33 = t_left_shank_106 - t_left_shank_111 * t_left_thigh_32;
  w[254] = t_left_thigh_33;
  const Scalar t_left_shank_114 = t_left_shank_55 - t_left_thigh_11 * t_left_thigh_22;
  const Scalar t_left_thigh_17 = w[83];
  const Scalar t_left_shank_115 = t_left_shank_114 - t_left_thigh_17 * t_left_thigh_21;
  const Scalar t_left_thigh_5 = w[76];
  const Scalar t_left_thigh_34 = t_left_shank_115 - t_left_thigh_5 * t_left_thigh_33;
  const Scalar t_left_thigh_35 = t_left_thigh_34 - t_left_thigh_29 * t_left_thigh_30;
  const Scalar t_left_thigh_3 = w[75];
  const Scalar t_left_thigh_36 = t_left_thigh_35 - t_left_thigh_3 * t_left_thigh_31;
  w[255] = t_left_thigh_36;
  const Scalar t_left_thigh_37 = t_left_shank_112 * inverse_pivot_left_thigh;
  w[256] = t_left_thigh_37;
  const Scalar t_left_thigh_38 = t_left_shank_108 - t_left_shank_112 * t_left_thigh_32;
  w[257] = t_left_thigh_38;
  const Scalar t_left_thigh_39 = t_left_shank_99 * inverse_pivot_left_thigh;
  const Scalar t_left_thigh_40 = t_left_shank_95 - t_left_shank_112 * t_left_thigh_39;
  w[258] = t_left_thigh_40;
  const Scalar t_left_thigh_8 = w[77];
  const Scalar t_left_shank_116 = t_left_shank_72 + t_left_thigh_8 * t_left_thigh_22;
  const Scalar t_left_shank_117 = t_left_shank_116 + t_left_thigh_11 * t_left_thigh_21;
  const Scalar t_left_thigh_41 = t_left_shank_117 + t_left_thigh_3 * t_left_thigh_40;
  const Scalar t_left_thigh_42 = t_left_thigh_41 - t_left_thigh_5 * t_left_thigh_38;
  const Scalar t_left_thigh_43 = t_left_thigh_42 - t_left_thigh_29 * t_left_thigh_37;
  w[259] = t_left_thigh_43;
  const Scalar t_left_thigh_44 = t_left_thigh_10 + t_left_shank_92;
  const Scalar t_left_thigh_45 = t_left_thigh_44 + t_left_shank_1 * t_left_shank_76;
  const Scalar t_left_thigh_46 = t_left_thigh_45 + t_left_shank_110 * t_left_thigh_39;
  const Scalar t_left_thigh_47 = t_left_thigh_46 - s_left_shank_x * t_left_shank_93;
  w[260] = t_left_thigh_47;
  const Scalar t_left_shank_118 = left_shank_I14 - t_left_shank_15;
  const Scalar t_left_foot_75 = left_hip_fork_l1 * t_left_foot_51;
  const Scalar t_left_foot_76 = t_left_foot_75 + left_hip_fork_l3 * t_left_foot_53;
  const Scalar t_left_shank_119 = t_left_foot_76 + t_left_foot_59 * t_left_ankle_cross_39;
  const Scalar t_left_shank_120 = t_left_ankle_cross_117 * t_left_shank_87;
  const Scalar t_left_ankle_cross_145 = t_left_ankle_cross_69 + t_left_ankle_cross_91;
  const Scalar t_left_shank_121 = t_left_shank_118 + t_left_shank_119 - t_left_shank_120;
  const Scalar t_left_ankle_cross_146 = s_left_ankle_cross_x * t_left_ankle_cross_145;
  const Scalar t_left_shank_122 = t_left_shank_121 - t_left_ankle_cross_146;
  const Scalar t_left_thigh_48 = t_left_thigh_18 + t_left_shank_122;
  const Scalar t_left_thigh_49 = t_left_thigh_48 + t_left_shank_99 * t_left_thigh_39;
  const Scalar t_left_shank_123 = s_left_shank_x * (t_left_shank_76 + t_left_shank_94);
  const Scalar t_left_thigh_50 = t_left_thigh_49 - t_left_shank_123;
  w[261] = t_left_thigh_50;
  const Scalar t_left_thigh_51 = left_ankle_cross_I5 + t_left_shank_89;
  const Scalar t_left_thigh_52 = t_left_shank_118 + t_left_shank_122;
  const Scalar t_left_thigh_53 = left_ankle_cross_I15 - t_left_shank_119;
  const Scalar t_left_thigh_54 = t_left_thigh_18 + t_left_shank_118;
  const Scalar t_left_thigh_55 = left_ankle_cross_I11 + t_left_thigh_20 + t_left_shank_23;
  const Scalar t_left_thigh_56 = t_left_shank_18 - (left_ankle_cross_I1 + t_left_thigh_15);
  const Scalar t_left_thigh_57 = tau[11] - t_left_thigh_10 * t_left_thigh_19;
  const Scalar t_left_ankle_cross_147 = s_left_ankle_cross_x * t_left_ankle_cross_87;
  const Scalar t_left_thigh_58 = t_left_thigh_57 - t_left_ankle_cross_147;
  const Scalar t_left_thigh_59 = t_left_thigh_58 - s_left_shank_x * t_left_shank_86;
  const Scalar t_left_thigh_60 = t_left_thigh_59 - t_left_ankle_cross_10 * t_left_thigh_51;
  const Scalar t_left_ankle_cross_148 = left_ankle_cross_I11 * t_left_ankle_cross_15;
  const Scalar t_left_thigh_61 = t_left_thigh_60 + t_left_ankle_cross_148;
  const Scalar t_left_thigh_62 = t_left_thigh_61 - t_left_shank_21 * t_left_shank_88;
  const Scalar t_left_thigh_63 = t_left_thigh_62 + t_left_thigh_3 * t_left_thigh_50;
  const Scalar t_left_thigh_64 = t_left_thigh_63 - left_hip_fork_l1 * t_left_foot_72;
  const Scalar t_left_thigh_65 = t_left_thigh_64 - t_left_shank_3 * t_left_shank_47;
  const Scalar t_left_thigh_66 = t_left_thigh_65 + t_left_shank_8 * t_left_thigh_52;
  const Scalar t_left_thigh_67 = t_left_thigh_66 + zeta_left_shank_x * t_left_shank_64;
  const Scalar t_left_ankle_cross_149 = t_left_ankle_cross_6 * t_left_ankle_cross_40;
  const Scalar t_left_thigh_68 = t_left_thigh_67 - t_left_ankle_cross_149;
  const Scalar t_left_thigh_69 = t_left_thigh_68 - t_left_ankle_cross_11 * t_left_thigh_53;
  const Scalar t_left_thigh_70 = t_left_thigh_69 - u_left_ankle_cross * t_left_ankle_cross_39;
  const Scalar t_left_thigh_71 = t_left_thigh_70 + t_left_thigh_8 * t_left_thigh_20;
  const Scalar t_left_thigh_72 = t_left_thigh_71 + left_hip_fork_l3 * t_left_foot_69;
  const Scalar t_left_thigh_73 = t_left_thigh_72 + t_left_shank_10 * t_left_shank_23;
  const Scalar t_left_ankle_cross_150 = zeta_left_ankle_cross_x * t_left_ankle_cross_47;
  const Scalar t_left_thigh_74 = t_left_thigh_73 + t_left_ankle_cross_150;
  const Scalar t_left_thigh_75 = t_left_thigh_74 + t_left_thigh_29 * t_left_thigh_39;
  const Scalar t_left_ankle_cross_151 = t_left_ankle_cross_9 * t_left_ankle_cross_69;
  const Scalar t_left_thigh_76 = t_left_thigh_75 - t_left_ankle_cross_151;
  const Scalar t_left_thigh_77 = t_left_thigh_76 + t_left_thigh_14 * t_left_thigh_54;
  const Scalar t_left_hip_fork_21 = w[73];
  const Scalar t_left_thigh_78 = t_left_thigh_77 - t_left_hip_fork_21 * t_left_thigh_55;
  const Scalar t_left_thigh_79 = t_left_thigh_78 + t_left_thigh_11 * t_left_thigh_56;
  const Scalar t_left_thigh_80 = t_left_thigh_79 + t_left_shank_33 * t_left_shank_87;
  const Scalar t_left_thigh_81 = t_left_thigh_80 - t_left_thigh_5 * t_left_thigh_47;
  const Scalar t_left_thigh_82 = t_left_thigh_81 - t_left_shank_7 * t_left_shank_92;
  const Scalar t_left_thigh_83 = t_left_thigh_82 - t_left_shank_6 * t_left_shank_76;
  w[262] = t_left_thigh_83;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_152 = t_left_foot_64 + left_foot_I11 * s_left_foot;
  const Scalar t_left_ankle_cross_153 = t_left_foot_63 * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_154 = t_left_ankle_cross_152 - t_left_ankle_cross_153;
  const Scalar t_left_thigh_84 = t_left_thigh_10 + t_left_shank_88;
  const Scalar t_left_ankle_cross_155 = left_shank_I17 - t_left_shank_15;
  const Scalar t_left_ankle_cross_156 = t_left_ankle_cross_71 + t_left_ankle_cross_89;
  const Scalar t_left_ankle_cross_157 = t_left_ankle_cross_154 + t_left_ankle_cross_155;
  const Scalar t_left_ankle_cross_158 = t_left_ankle_cross_1 * t_left_ankle_cross_156;
  const Scalar t_left_ankle_cross_159 = t_left_ankle_cross_157 + t_left_ankle_cross_158;
  // left_shank
  const Scalar t_left_shank_124 = t_left_ankle_cross_109 * t_left_shank_60;
  const Scalar t_left_shank_125 = t_left_ankle_cross_159 + t_left_shank_124;
  const Scalar t_left_shank_126 = t_left_shank_1 * (t_left_shank_78 + t_left_shank_93);
  const Scalar t_left_shank_127 = t_left_thigh_13 + t_left_shank_125 - t_left_shank_126;
  // left_thigh
  const Scalar t_left_thigh_85 = t_left_shank_127 - t_left_shank_110 * t_left_thigh_32;
  w[263] = t_left_thigh_85;
  const Scalar t_left_thigh_86 = left_ankle_cross_I18 + t_left_ankle_cross_154;
  const Scalar t_left_thigh_87 = t_left_shank_88 + t_left_shank_92;
  const Scalar t_left_thigh_88 = left_shank_I16 - t_left_shank_15;
  const Scalar t_left_thigh_89 = t_left_shank_125 + t_left_thigh_88;
  const Scalar t_left_thigh_90 = t_left_thigh_13 + t_left_thigh_88;
  const Scalar t_left_ankle_cross_160 = t_left_ankle_cross_1 * t_left_ankle_cross_87;
  const Scalar t_left_thigh_91 = s_left_foot * t_left_foot_45 + t_left_ankle_cross_160;
  const Scalar t_left_thigh_92 = t_left_thigh_91 + t_left_shank_1 * t_left_shank_86;
  const Scalar t_left_ankle_cross_161 = left_ankle_cross_I1 * t_left_ankle_cross_13;
  const Scalar t_left_thigh_93 = t_left_thigh_92 - t_left_ankle_cross_161;
  const Scalar t_left_thigh_94 = t_left_thigh_93 + t_left_thigh_11 * t_left_thigh_55;
  const Scalar t_left_thigh_95 = t_left_thigh_94 + t_left_shank_3 * t_left_shank_45;
  const Scalar t_left_thigh_96 = t_left_thigh_95 - t_left_shank_6 * t_left_shank_78;
  const Scalar t_left_thigh_97 = t_left_thigh_96 + t_left_thigh_29 * t_left_thigh_32;
  const Scalar t_left_thigh_98 = t_left_thigh_97 + t_left_thigh_14 * t_left_thigh_84;
  const Scalar t_left_thigh_99 = t_left_thigh_98 - t_left_thigh_15 * t_left_thigh_17;
  const Scalar t_left_thigh_100 = t_left_thigh_99 + t_left_shank_18 * t_left_shank_19;
  const Scalar t_left_thigh_101 = t_left_thigh_100 - t_left_hip_fork_21 * t_left_thigh_56;
  const Scalar t_left_thigh_102 = t_left_thigh_101 + zeta_left_shank_x * t_left_shank_62;
  const Scalar t_left_ankle_cross_162 = t_left_ankle_cross_9 * t_left_ankle_cross_71;
  const Scalar t_left_thigh_103 = t_left_thigh_102 + t_left_ankle_cross_162;
  const Scalar t_left_thigh_104 = t_left_thigh_103 + t_left_ankle_cross_10 * t_left_thigh_86;
  const Scalar t_left_thigh_105 = t_left_thigh_104 + t_left_thigh_5 * t_left_thigh_85;
  const Scalar t_left_thigh_106 = t_left_thigh_105 - left_foot_I7 * t_left_foot_46;
  const Scalar t_left_thigh_107 = t_left_thigh_106 - c_left_foot * t_left_foot_34;
  const Scalar t_left_thigh_108 = t_left_thigh_107 - u_left_ankle_cross * t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_163 = zeta_left_ankle_cross_x * t_left_ankle_cross_49;
  const Scalar t_left_thigh_109 = t_left_thigh_108 + t_left_ankle_cross_163;
  const Scalar t_left_thigh_110 = t_left_thigh_109 + t_left_ankle_cross_11 * t_left_thigh_51;
  const Scalar t_left_ankle_cross_164 = t_left_ankle_cross_6 * t_left_ankle_cross_38;
  const Scalar t_left_thigh_111 = t_left_thigh_110 + t_left_ankle_cross_164;
  const Scalar t_left_thigh_112 = t_left_thigh_111 - t_left_shank_33 * t_left_shank_60;
  const Scalar t_left_thigh_113 = t_left_thigh_112 + t_left_shank_8 * t_left_thigh_87;
  const Scalar t_left_thigh_114 = t_left_thigh_113 + t_left_thigh_3 * t_left_thigh_47;
  const Scalar t_left_thigh_115 = t_left_thigh_114 + t_left_shank_7 * t_left_thigh_89;
  const Scalar t_left_thigh_116 = t_left_thigh_115 + t_left_thigh_19 * t_left_thigh_90;
  w[264] = t_left_thigh_116;
}

[[gnu::noinline]] void forward_dynamics_7(const Scalar tau[18], Scalar w[278]) noexcept {
  const Scalar t_left_shank_113 = w[248];
  const Scalar inverse_pivot_left_thigh = w[250];
  const Scalar t_left_thigh_117 = t_left_shank_113 * inverse_pivot_left_thigh;
  w[77] = t_left_thigh_117;
  const Scalar t_left_thigh_21 = w[87];
  const Scalar t_left_shank_93 = w[182];
  const Scalar t_left_shank_128 = t_left_thigh_21 + t_left_shank_93;
  const Scalar t_left_shank_110 = w[245];
  const Scalar t_left_thigh_118 = t_left_shank_128 - t_left_shank_110 * t_left_thigh_117;
  const Scalar t_left_thigh_22 = w[88];
  const Scalar t_left_shank_94 = w[183];
  const Scalar t_left_shank_129 = t_left_thigh_22 + t_left_shank_94;
  // left_thigh
  const Scalar t_left_shank_99 = w[190];
  const Scalar t_left_thigh_119 = t_left_shank_129 - t_left_shank_99 * t_left_thigh_117;
  const Scalar c_q8_q9_q10 = w[8];
  const Scalar t_left_thigh_120 = 2.0 * c_q8_q9_q10;
  const Scalar s_q8_q9_q10 = w[7];
  const Scalar t_left_thigh_50 = w[261];
  const Scalar t_left_thigh_85 = w[263];
  const Scalar t_left_thigh_121 = s_q8_q9_q10 * (t_left_thigh_50 + t_left_thigh_85);
  const Scalar t_left_thigh_47 = w[260];
  const Scalar t_left_thigh_122 = t_left_thigh_121 + t_left_thigh_47 * t_left_thigh_120;
  const Scalar t_left_thigh_123 = s_q8_q9_q10 * t_left_thigh_122;
  const Scalar t_left_thigh_124 = left_hip_fork_I16 - t_left_thigh_50 + t_left_thigh_123;
  w[78] = t_left_thigh_124;
  const Scalar t_left_thigh_125 = left_hip_fork_I15 - t_left_thigh_47;
  const Scalar t_left_thigh_126 = t_left_thigh_125 + c_q8_q9_q10 * t_left_thigh_122;
  w[79] = t_left_thigh_126;
  const Scalar t_left_thigh_31 = w[252];
  const Scalar t_left_thigh_38 = w[257];
  const Scalar t_left_thigh_127 = s_q8_q9_q10 * (t_left_thigh_31 + t_left_thigh_38);
  const Scalar t_left_thigh_33 = w[254];
  const Scalar t_left_thigh_40 = w[258];
  const Scalar t_left_thigh_128 = c_q8_q9_q10 * (t_left_thigh_33 + t_left_thigh_40);
  const Scalar t_left_thigh_129 = t_left_thigh_127 - t_left_thigh_128;
  const Scalar t_left_thigh_130 = c_q8_q9_q10 * t_left_thigh_129;
  const Scalar t_left_thigh_131 = left_hip_fork_h2 + t_left_thigh_33 + t_left_thigh_130;
  w[80] = t_left_thigh_131;
  const Scalar t_left_shank_57 = w[173];
  const Scalar t_left_shank_112 = w[247];
  const Scalar t_left_thigh_37 = w[256];
  const Scalar t_left_thigh_132 = t_left_shank_57 - t_left_shank_112 * t_left_thigh_37;
  const Scalar t_left_shank_37 = w[170];
  const Scalar t_left_shank_111 = w[246];
  const Scalar t_left_thigh_30 = w[251];
  const Scalar t_left_thigh_133 = t_left_shank_37 - t_left_shank_111 * t_left_thigh_30;
  const Scalar t_left_shank_40 = w[171];
  const Scalar t_left_thigh_134 = t_left_shank_40 - t_left_shank_111 * t_left_thigh_37;
  const Scalar t_left_thigh_135 = s_q8_q9_q10 * (t_left_thigh_132 - t_left_thigh_133);
  const Scalar t_left_thigh_136 = t_left_thigh_135 - t_left_thigh_120 * t_left_thigh_134;
  const Scalar t_left_thigh_137 = s_q8_q9_q10 * t_left_thigh_136;
  const Scalar t_left_thigh_138 = s_q8_q9_q10 * t_left_thigh_129;
  const Scalar t_left_thigh_139 = t_left_thigh_31 - t_left_thigh_138;
  w[82] = t_left_thigh_139;
  const Scalar t_left_thigh_140 = left_hip_fork_h1 + c_q8_q9_q10 * t_left_thigh_119;
  const Scalar t_left_thigh_141 = t_left_thigh_140 - s_q8_q9_q10 * t_left_thigh_118;
  w[83] = t_left_thigh_141;
  const Scalar t_left_shank_59 = w[174];
  const Scalar t_left_thigh_142 = t_left_shank_59 - t_left_shank_113 * t_left_thigh_37;
  // left_hip_fork
  const Scalar t_left_hip_fork_20 = w[72];
  const Scalar t_left_hip_fork_23 = tau[7] - left_hip_fork_I14 * t_left_hip_fork_20;
  const Scalar t_left_hip_fork_22 = w[74];
  const Scalar t_left_hip_fork_24 = left_hip_fork_I15 * t_left_hip_fork_22;
  const Scalar t_left_hip_fork_25 = t_left_hip_fork_23 - t_left_hip_fork_24;
  const Scalar t_left_thigh_83 = w[262];
  const Scalar t_left_hip_fork_26 = t_left_hip_fork_25 - c_q8_q9_q10 * t_left_thigh_83;
  const Scalar t_left_thigh_116 = w[264];
  const Scalar t_left_hip_fork_27 = t_left_hip_fork_26 + s_q8_q9_q10 * t_left_thigh_116;
  const Scalar t_left_hip_fork_19 = w[71];
  const Scalar t_left_hip_fork_28 = left_hip_fork_I17 * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_4 = w[58];
  const Scalar t_left_hip_fork_7 = w[59];
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_4 - t_left_hip_fork_7;
  const Scalar t_left_hip_fork_30 = t_left_hip_fork_27 - t_left_hip_fork_28;
  const Scalar u_left_hip_fork = t_left_hip_fork_30 - left_hip_fork_I7 * t_left_hip_fork_29;
  w[84] = u_left_hip_fork;
  const Scalar t_left_hip_fork_31 = 1.0 / t_left_thigh_124;
  w[86] = t_left_hip_fork_31;
  const Scalar t_left_hip_fork_32 = t_left_thigh_141 * t_left_hip_fork_31;
  const Scalar t_left_hip_fork_33 = u_left_hip_fork * t_left_hip_fork_31;
  const Scalar t_left_hip_fork_34 = t_left_thigh_131 * t_left_hip_fork_31;
  // left_thigh
  const Scalar t_left_shank_43 = w[172];
  const Scalar t_left_thigh_143 = t_left_shank_43 - t_left_shank_111 * t_left_thigh_117;
  const Scalar t_left_thigh_144 = c_q8_q9_q10 * t_left_thigh_142;
  const Scalar t_left_thigh_145 = t_left_thigh_144 + s_q8_q9_q10 * t_left_thigh_143;
  // left_hip_fork
  const Scalar t_left_hip_fork_35 = t_left_thigh_145 + t_left_thigh_141 * t_left_hip_fork_34;
  const Scalar t_left_shank_74 = w[175];
  const Scalar t_left_hip_fork_36 = t_left_shank_74 - t_left_thigh_141 * t_left_hip_fork_32;
  const Scalar t_left_hip_fork_37 = t_left_hip_fork_36 - t_left_shank_113 * t_left_thigh_117;
  const Scalar t_left_hip_fork_38 = t_left_thigh_139 * t_left_hip_fork_31;
  const Scalar t_left_thigh_146 = c_q8_q9_q10 * t_left_thigh_143;
  const Scalar t_left_thigh_147 = t_left_thigh_146 - s_q8_q9_q10 * t_left_thigh_142;
  const Scalar t_left_hip_fork_39 = t_left_thigh_147 + t_left_thigh_141 * t_left_hip_fork_38;
  const Scalar t_left_hip_fork_40 = t_left_thigh_126 * t_left_hip_fork_31;
  const Scalar t_left_thigh_148 = c_q8_q9_q10 * t_left_thigh_118;
  const Scalar t_left_thigh_149 = t_left_thigh_148 + s_q8_q9_q10 * t_left_thigh_119;
  const Scalar t_left_hip_fork_41 = t_left_thigh_149 + t_left_thigh_141 * t_left_hip_fork_40;
  const Scalar t_left_hip_fork_42 = left_hip_fork_I14 * t_left_hip_fork_32;
  const Scalar t_left_shank_86 = w[180];
  const Scalar t_left_hip_fork_43 = t_left_shank_86 + left_hip_fork_h1 * t_left_hip_fork_19;
  const Scalar t_left_thigh_19 = w[85];
  const Scalar t_left_hip_fork_44 = t_left_hip_fork_43 - t_left_thigh_19 * t_left_thigh_21;
  const Scalar t_left_thigh_14 = w[81];
  const Scalar t_left_hip_fork_45 = t_left_hip_fork_44 + t_left_thigh_14 * t_left_thigh_22;
  const Scalar t_left_hip_fork_16 = w[68];
  const Scalar t_left_hip_fork_46 = t_left_hip_fork_16 * t_left_hip_fork_42;
  const Scalar t_left_hip_fork_47 = t_left_hip_fork_45 - t_left_hip_fork_46;
  const Scalar t_left_thigh_3 = w[75];
  const Scalar t_left_hip_fork_48 = t_left_hip_fork_47 + t_left_thigh_3 * t_left_thigh_119;
  const Scalar t_left_hip_fork_21 = w[73];
  const Scalar t_left_hip_fork_49 = left_hip_fork_h2 * t_left_hip_fork_21;
  const Scalar t_left_hip_fork_50 = t_left_hip_fork_48 + t_left_hip_fork_49;
  const Scalar t_left_thigh_5 = w[76];
  const Scalar t_left_hip_fork_51 = t_left_hip_fork_50 - t_left_thigh_5 * t_left_thigh_118;
  const Scalar t_left_hip_fork_15 = w[67];
  const Scalar t_left_hip_fork_52 = t_left_hip_fork_15 * t_left_hip_fork_39;
  const Scalar t_left_hip_fork_53 = t_left_hip_fork_51 + t_left_hip_fork_52;
  const Scalar t_left_thigh_29 = w[249];
  const Scalar t_left_hip_fork_54 = t_left_hip_fork_53 - t_left_thigh_29 * t_left_thigh_117;
  const Scalar t_left_hip_fork_17 = w[69];
  const Scalar t_left_hip_fork_55 = t_left_hip_fork_17 * t_left_hip_fork_41;
  const Scalar t_left_hip_fork_56 = t_left_hip_fork_54 - t_left_hip_fork_55;
  const Scalar t_left_hip_fork_14 = w[66];
  const Scalar t_left_hip_fork_57 = t_left_hip_fork_14 * t_left_hip_fork_35;
  const Scalar t_left_hip_fork_58 = t_left_hip_fork_56 - t_left_hip_fork_57;
  const Scalar t_left_hip_fork_59 = t_left_thigh_141 * t_left_hip_fork_33;
  const Scalar t_left_hip_fork_60 = t_left_hip_fork_58 - t_left_hip_fork_59;
  const Scalar t_left_hip_fork_12 = w[65];
  const Scalar t_left_hip_fork_61 = t_left_hip_fork_12 * t_left_hip_fork_37;
  const Scalar t_left_hip_fork_62 = t_left_hip_fork_60 - t_left_hip_fork_61;
  const Scalar t_left_hip_fork_63 = t_left_thigh_131 * t_left_hip_fork_34;
  const Scalar t_left_hip_fork_64 = t_left_thigh_132 - t_left_thigh_137 - t_left_hip_fork_63;
  const Scalar t_left_thigh_150 = t_left_thigh_134 + c_q8_q9_q10 * t_left_thigh_136;
  const Scalar t_left_hip_fork_65 = t_left_thigh_150 + t_left_thigh_139 * t_left_hip_fork_34;
  const Scalar t_left_hip_fork_66 = t_left_thigh_131 * t_left_hip_fork_40;
  const Scalar t_left_hip_fork_67 = t_left_thigh_38 - t_left_thigh_138 - t_left_hip_fork_66;
  const Scalar t_left_hip_fork_68 = left_hip_fork_I14 * t_left_hip_fork_34;
  const Scalar t_left_hip_fork_69 = t_left_hip_fork_16 * t_left_hip_fork_68;
  const Scalar t_left_hip_fork_70 = left_hip_fork_h2 * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_71 = t_left_hip_fork_70 + t_left_hip_fork_69;
  const Scalar t_left_thigh_43 = w[259];
  const Scalar t_left_hip_fork_72 = t_left_hip_fork_71 + c_q8_q9_q10 * t_left_thigh_43;
  const Scalar t_left_thigh_36 = w[255];
  const Scalar t_left_hip_fork_73 = t_left_hip_fork_72 + s_q8_q9_q10 * t_left_thigh_36;
  const Scalar t_left_hip_fork_74 = t_left_hip_fork_14 * t_left_hip_fork_64;
  const Scalar t_left_hip_fork_18 = w[70];
  const Scalar t_left_hip_fork_75 = t_left_hip_fork_4 + t_left_hip_fork_18;
  const Scalar t_left_hip_fork_76 = t_left_hip_fork_73 - t_left_hip_fork_74;
  const Scalar t_left_hip_fork_77 = left_hip_fork_h1 * t_left_hip_fork_75;
  const Scalar t_left_hip_fork_78 = t_left_hip_fork_76 + t_left_hip_fork_77;
  const Scalar t_left_hip_fork_79 = t_left_hip_fork_15 * t_left_hip_fork_65;
  const Scalar t_left_hip_fork_80 = t_left_hip_fork_78 - t_left_hip_fork_79;
  const Scalar t_left_hip_fork_81 = t_left_thigh_131 * t_left_hip_fork_33;
  const Scalar t_left_hip_fork_82 = t_left_hip_fork_80 + t_left_hip_fork_81;
  const Scalar t_left_hip_fork_83 = t_left_hip_fork_17 * t_left_hip_fork_67;
  const Scalar t_left_hip_fork_84 = t_left_hip_fork_82 - t_left_hip_fork_83;
  const Scalar t_left_hip_fork_85 = t_left_hip_fork_12 * t_left_hip_fork_35;
  const Scalar t_left_hip_fork_86 = t_left_hip_fork_84 - t_left_hip_fork_85;
  const Scalar s_left_hip_roll = w[5];
  const Scalar t_left_hip_fork_87 = s_left_hip_roll * t_left_hip_fork_62;
  const Scalar c_left_hip_roll = w[6];
  const Scalar t_left_hip_fork_88 = t_left_hip_fork_87 - c_left_hip_roll * t_left_hip_fork_86;
  const Scalar t_left_thigh_151 = t_left_thigh_130 - (left_hip_fork_h2 - t_left_thigh_40);
  const Scalar t_left_hip_fork_89 = t_left_thigh_151 + t_left_thigh_126 * t_left_hip_fork_38;
  const Scalar t_left_hip_fork_90 = left_hip_fork_I14 * t_left_hip_fork_40;
  const Scalar t_left_hip_fork_91 = left_hip_fork_I7 + t_left_hip_fork_90;
  const Scalar t_left_thigh_152 = t_left_thigh_123 - (left_hip_fork_I13 + t_left_thigh_85);
  const Scalar t_left_hip_fork_92 = t_left_thigh_152 + t_left_thigh_126 * t_left_hip_fork_40;
  const Scalar t_left_hip_fork_93 = left_hip_fork_I15 * t_left_hip_fork_19;
  const Scalar t_left_hip_fork_94 = left_hip_fork_I13 * t_left_hip_fork_22;
  const Scalar t_left_hip_fork_95 = t_left_hip_fork_93 + t_left_hip_fork_94;
  const Scalar t_left_hip_fork_96 = left_hip_fork_I7 * t_left_hip_fork_20;
  const Scalar t_left_hip_fork_97 = t_left_hip_fork_95 - t_left_hip_fork_96;
  const Scalar t_left_hip_fork_98 = t_left_hip_fork_97 + s_q8_q9_q10 * t_left_thigh_83;
  const Scalar t_left_hip_fork_99 = t_left_hip_fork_98 + c_q8_q9_q10 * t_left_thigh_116;
  const Scalar t_left_hip_fork_100 = t_left_hip_fork_15 * t_left_hip_fork_89;
  const Scalar t_left_hip_fork_8 = w[60];
  const Scalar t_left_hip_fork_101 = t_left_hip_fork_8 - t_left_hip_fork_21;
  const Scalar t_left_hip_fork_102 = t_left_hip_fork_99 + t_left_hip_fork_100;
  const Scalar t_left_hip_fork_103 = left_hip_fork_I14 * t_left_hip_fork_101;
  const Scalar t_left_hip_fork_104 = t_left_hip_fork_102 - t_left_hip_fork_103;
  const Scalar t_left_hip_fork_105 = t_left_hip_fork_14 * t_left_hip_fork_67;
  const Scalar t_left_hip_fork_106 = t_left_hip_fork_104 + t_left_hip_fork_105;
  const Scalar t_left_hip_fork_107 = t_left_hip_fork_106 - u_left_hip_fork * t_left_hip_fork_40;
  const Scalar t_left_hip_fork_108 = t_left_hip_fork_12 * t_left_hip_fork_41;
  const Scalar t_left_hip_fork_109 = t_left_hip_fork_107 + t_left_hip_fork_108;
  const Scalar t_left_hip_fork_110 = t_left_hip_fork_17 * t_left_hip_fork_92;
  const Scalar t_left_hip_fork_111 = t_left_hip_fork_109 - t_left_hip_fork_110;
  const Scalar t_left_hip_fork_112 = t_left_hip_fork_16 * t_left_hip_fork_91;
  const Scalar t_left_hip_fork_113 = t_left_hip_fork_111 - t_left_hip_fork_112;
  const Scalar t_left_hip_fork_114 = left_hip_fork_p1 * t_left_hip_fork_31;
  const Scalar t_left_hip_fork_115 = left_hip_fork_h1 + left_hip_fork_I14 * t_left_hip_fork_38;
  const Scalar t_left_hip_fork_116 = t_left_hip_fork_7 - t_left_hip_fork_18;
  const Scalar t_left_hip_fork_117 = t_left_hip_fork_19 + t_left_hip_fork_33;
  const Scalar t_left_hip_fork_118 = t_left_hip_fork_14 * t_left_hip_fork_34;
  const Scalar t_left_hip_fork_119 = t_left_hip_fork_117 + t_left_hip_fork_118;
  const Scalar t_left_hip_fork_120 = t_left_hip_fork_12 * t_left_hip_fork_32;
  const Scalar t_left_hip_fork_121 = t_left_hip_fork_119 - t_left_hip_fork_120;
  const Scalar t_left_hip_fork_122 = 2.0 * s_left_hip_roll;
  const Scalar t_left_hip_fork_123 = t_left_hip_fork_37 - t_left_hip_fork_64;
  const Scalar t_left_hip_fork_124 = t_left_hip_fork_35 * t_left_hip_fork_122;
  const Scalar t_left_hip_fork_125 = c_left_hip_roll * t_left_hip_fork_123 + t_left_hip_fork_124;
  const Scalar t_left_hip_fork_126 = c_left_hip_roll * t_left_hip_fork_125;
  const Scalar t_left_hip_fork_127 = t_left_hip_fork_37 - t_left_hip_fork_126;
  const Scalar t_left_hip_fork_128 = t_left_hip_fork_42 - t_left_hip_fork_67;
  const Scalar t_left_hip_fork_129 = t_left_hip_fork_41 - t_left_hip_fork_68;
  const Scalar t_left_hip_fork_130 = c_left_hip_roll * t_left_hip_fork_128;
  const Scalar t_left_hip_fork_131 = t_left_hip_fork_130 + s_left_hip_roll * t_left_hip_fork_129;
  const Scalar t_left_hip_fork_132 = s_left_hip_roll * t_left_hip_fork_131;
  const Scalar t_left_hip_fork_133 = t_left_hip_fork_68 + t_left_hip_fork_132;
  const Scalar t_left_hip_fork_134 = left_hip_fork_l1 * t_left_hip_fork_127;
  const Scalar t_left_hip_fork_135 = t_left_hip_fork_133 - t_left_hip_fork_134;
  const Scalar t_left_hip_fork_136 = left_hip_fork_I10 - t_left_hip_fork_114;
  const Scalar t_left_hip_fork_137 = t_left_hip_fork_92 + t_left_hip_fork_136;
  const Scalar t_left_hip_fork_138 = t_left_hip_fork_91 * t_left_hip_fork_122;
  const Scalar t_left_hip_fork_139 = c_left_hip_roll * t_left_hip_fork_137 - t_left_hip_fork_138;
  const Scalar t_left_hip_fork_140 = c_left_hip_roll * t_left_hip_fork_139;
  const Scalar t_left_hip_fork_141 = t_left_hip_fork_35 - s_left_hip_roll * t_left_hip_fork_125;
  const Scalar t_left_hip_fork_142 = left_hip_fork_l1 * t_left_hip_fork_141;
  const Scalar t_left_hip_fork_143 = c_left_hip_roll * t_left_hip_fork_131;
  const Scalar t_left_hip_fork_144 = t_left_hip_fork_67 + t_left_hip_fork_143;
  const Scalar t_left_hip_fork_145 = t_left_hip_fork_42 - t_left_hip_fork_142;
  const Scalar t_left_hip_fork_146 = t_left_hip_fork_143 - t_left_hip_fork_145;
  w[94] = t_left_hip_fork_146;
  const Scalar t_left_hip_fork_147 = left_hip_block_I21 - t_left_hip_fork_90;
  const Scalar t_left_hip_fork_148 = t_left_hip_fork_144 + t_left_hip_fork_146;
  const Scalar t_left_hip_fork_149 = t_left_hip_fork_147 - s_left_hip_roll * t_left_hip_fork_139;
  const Scalar t_left_hip_fork_150 = left_hip_fork_l1 * t_left_hip_fork_148;
  const Scalar t_left_hip_fork_151 = t_left_hip_fork_149 - t_left_hip_fork_150;
  const Scalar t_left_hip_fork_152 = t_left_hip_fork_64 + t_left_hip_fork_126;
  const Scalar t_left_hip_fork_153 = t_left_hip_fork_41 - t_left_hip_fork_132;
  const Scalar t_left_hip_fork_154 = left_hip_fork_l1 * t_left_hip_fork_152;
  const Scalar t_left_hip_fork_155 = t_left_hip_fork_153 - t_left_hip_fork_154;
  const Scalar t_left_hip_fork_156 = left_hip_block_I20 - t_left_hip_fork_114;
  const Scalar t_left_hip_fork_157 = t_left_hip_fork_153 + t_left_hip_fork_155;
  const Scalar t_left_hip_fork_158 = t_left_hip_fork_140 - t_left_hip_fork_156;
  const Scalar t_left_hip_fork_159 = left_hip_fork_l1 * t_left_hip_fork_157;
  const Scalar t_left_hip_fork_160 = t_left_hip_fork_158 + t_left_hip_fork_159;
  w[95] = t_left_hip_fork_160;
  const Scalar t_left_hip_fork_161 = left_hip_block_h4 - t_left_hip_fork_155;
  const Scalar t_left_hip_fork_162 = s_left_hip_roll * t_left_hip_fork_65;
  const Scalar t_left_hip_fork_163 = t_left_hip_fork_162 - c_left_hip_roll * t_left_hip_fork_39;
  const Scalar t_left_hip_fork_164 = left_hip_block_h1 + left_hip_fork_l1 * t_left_hip_fork_163;
  const Scalar t_left_hip_fork_165 = t_left_hip_fork_164 + s_left_hip_roll * t_left_hip_fork_115;
  const Scalar t_left_hip_fork_166 = t_left_hip_fork_165 - c_left_hip_roll * t_left_hip_fork_89;
  const Scalar t_left_hip_fork_167 = s_left_hip_roll * t_left_hip_fork_86;
  const Scalar t_left_hip_fork_168 = t_left_hip_fork_167 + c_left_hip_roll * t_left_hip_fork_62;
  const Scalar t_left_hip_fork_169 = tau[8] - left_hip_fork_I7 * t_left_hip_fork_22;
  const Scalar t_left_hip_fork_170 = left_hip_fork_I10 * t_left_hip_fork_20;
  const Scalar t_left_hip_fork_171 = t_left_hip_fork_169 + t_left_hip_fork_170;
  const Scalar t_left_hip_fork_172 = t_left_hip_fork_15 * t_left_hip_fork_115;
  const Scalar t_left_hip_fork_173 = t_left_hip_fork_171 + t_left_hip_fork_172;
  const Scalar t_left_hip_fork_174 = left_hip_fork_I15 * t_left_hip_fork_116;
  const Scalar t_left_hip_fork_175 = t_left_hip_fork_173 + t_left_hip_fork_174;
  const Scalar t_left_hip_fork_176 = left_hip_fork_I14 * t_left_hip_fork_121;
  const Scalar t_left_hip_fork_177 = t_left_hip_fork_175 - t_left_hip_fork_176;
  const Scalar t_left_hip_fork_178 = t_left_hip_fork_16 * t_left_hip_fork_136;
  const Scalar t_left_hip_fork_179 = t_left_hip_fork_177 + t_left_hip_fork_178;
  const Scalar t_left_hip_fork_180 = t_left_hip_fork_17 * t_left_hip_fork_91;
  const Scalar t_left_hip_fork_181 = t_left_hip_fork_179 - t_left_hip_fork_180;
  // left_hip_block
  const Scalar t_left_hip_block_20 = w[62];
  const Scalar t_left_hip_block_25 = tau[6] + left_hip_block_I17 * t_left_hip_block_20;
  const Scalar t_left_hip_block_24 = w[64];
  const Scalar t_left_hip_block_26 = left_hip_block_I18 * t_left_hip_block_24;
  const Scalar t_left_hip_block_27 = t_left_hip_block_25 + t_left_hip_block_26;
  const Scalar t_left_hip_fork_182 = c_left_hip_roll * t_left_hip_fork_113;
  const Scalar t_left_hip_block_28 = t_left_hip_block_27 + t_left_hip_fork_182;
  const Scalar t_left_hip_fork_183 = left_hip_fork_l1 * t_left_hip_fork_168;
  const Scalar t_left_hip_block_23 = w[63];
  const Scalar t_left_hip_block_29 = t_left_hip_fork_8 - t_left_hip_block_23;
  const Scalar t_left_hip_block_30 = t_left_hip_block_28 + t_left_hip_fork_183;
  const Scalar t_left_hip_block_31 = left_hip_block_I8 * t_left_hip_block_29;
  const Scalar t_left_hip_block_32 = t_left_hip_block_30 + t_left_hip_block_31;
  const Scalar t_left_hip_fork_184 = s_left_hip_roll * t_left_hip_fork_181;
  const Scalar t_left_hip_block_33 = t_left_hip_block_32 - t_left_hip_fork_184;
  const Scalar t_left_hip_block_19 = w[61];
  const Scalar t_left_hip_block_34 = left_hip_block_I19 * t_left_hip_block_19;
  const Scalar u_left_hip_block = t_left_hip_block_33 - t_left_hip_block_34;
  const Scalar t_left_hip_block_35 = 1.0 / t_left_hip_fork_160;
  w[96] = t_left_hip_block_35;
  const Scalar t_left_hip_block_36 = t_left_hip_fork_161 * t_left_hip_block_35;
  w[97] = t_left_hip_block_36;
  const Scalar t_left_hip_block_37 = t_left_hip_fork_166 * t_left_hip_block_35;
  w[98] = t_left_hip_block_37;
  const Scalar t_left_hip_block_38 = t_left_hip_fork_161 * t_left_hip_block_37;
  const Scalar t_left_hip_block_39 = t_left_hip_fork_163 + t_left_hip_block_38;
  w[99] = t_left_hip_block_39;
  const Scalar t_left_hip_block_40 = t_left_hip_fork_161 * t_left_hip_block_36;
  const Scalar t_left_hip_fork_185 = left_hip_block_m1 + t_left_hip_fork_152;
  const Scalar t_left_hip_block_41 = t_left_hip_fork_185 + t_left_hip_block_40;
  w[100] = t_left_hip_block_41;
  const Scalar t_left_hip_block_42 = t_left_hip_fork_146 * t_left_hip_block_35;
  const Scalar t_left_hip_block_43 = t_left_hip_fork_146 * t_left_hip_block_36;
  const Scalar t_left_hip_block_44 = t_left_hip_fork_141 + t_left_hip_block_43;
  w[101] = t_left_hip_block_44;
  const Scalar t_left_hip_block_45 = t_left_hip_fork_151 * t_left_hip_block_35;
  w[102] = t_left_hip_block_45;
  const Scalar t_left_hip_block_46 = t_left_hip_fork_161 * t_left_hip_block_45;
  const Scalar t_left_hip_fork_186 = t_left_hip_fork_142 + t_left_hip_fork_144;
  const Scalar t_left_hip_block_47 = t_left_hip_fork_186 - t_left_hip_block_46;
  w[103] = t_left_hip_block_47;
  const Scalar t_left_hip_block_48 = left_hip_block_I18 * t_left_hip_block_36;
  w[104] = t_left_hip_block_48;
  const Scalar t_left_hip_block_49 = u_left_hip_block * t_left_hip_block_35;
  w[105] = t_left_hip_block_49;
  const Scalar t_left_hip_block_18 = w[57];
  const Scalar t_left_hip_block_50 = left_hip_block_I18 * t_left_hip_block_18;
  const Scalar t_left_hip_block_51 = u_left_hip_block - t_left_hip_block_50;
  const Scalar t_left_hip_block_52 = left_hip_block_h4 * t_left_hip_block_19;
  const Scalar zeta_left_hip_block_z = w[55];
  const Scalar t_left_hip_block_53 = zeta_left_hip_block_z * t_left_hip_block_44;
  const Scalar t_left_hip_block_54 = t_left_hip_fork_168 - t_left_hip_block_52;
  const Scalar t_left_hip_block_55 = t_left_hip_block_54 + t_left_hip_block_53;
  const Scalar zeta_left_hip_block_y = w[54];
  const Scalar t_left_hip_block_56 = zeta_left_hip_block_y * t_left_hip_block_39;
  const Scalar t_left_hip_block_57 = t_left_hip_block_55 - t_left_hip_block_56;
  const Scalar t_left_hip_block_58 = t_left_hip_block_36 * t_left_hip_block_51;
  const Scalar t_left_hip_block_59 = t_left_hip_block_57 + t_left_hip_block_58;
  const Scalar t_left_hip_block_16 = w[56];
  const Scalar t_left_hip_block_60 = t_left_hip_block_16 * t_left_hip_block_47;
  const Scalar t_left_hip_block_61 = t_left_hip_block_59 + t_left_hip_block_60;
  const Scalar t_left_hip_block_9 = w[53];
  const Scalar t_left_hip_block_62 = t_left_hip_block_9 * t_left_hip_block_41;
  const Scalar t_left_hip_block_63 = t_left_hip_block_61 + t_left_hip_block_62;
  const Scalar t_left_hip_block_64 = left_hip_block_h1 * t_left_hip_block_23;
  const Scalar t_left_hip_block_65 = t_left_hip_block_63 + t_left_hip_block_64;
  w[111] = t_left_hip_block_65;
  const Scalar t_left_hip_fork_187 = t_left_thigh_139 * t_left_hip_fork_38;
  const Scalar t_left_hip_fork_188 = t_left_thigh_133 + t_left_thigh_137 - t_left_hip_fork_187;
  const Scalar t_left_hip_block_66 = t_left_hip_fork_166 * t_left_hip_block_37;
  const Scalar t_left_hip_fork_189 = left_hip_block_m1 + t_left_hip_fork_188;
  const Scalar t_left_hip_block_67 = t_left_hip_fork_189 + t_left_hip_block_66;
  w[112] = t_left_hip_block_67;
  const Scalar t_left_hip_fork_190 = s_left_hip_roll * t_left_hip_fork_39;
  const Scalar t_left_hip_fork_191 = t_left_hip_fork_190 + c_left_hip_roll * t_left_hip_fork_65;
  const Scalar t_left_hip_block_68 = t_left_hip_fork_166 * t_left_hip_block_42;
  const Scalar t_left_hip_block_69 = t_left_hip_fork_191 + t_left_hip_block_68;
  w[113] = t_left_hip_block_69;
  // left_hip_fork
  const Scalar t_left_hip_fork_192 = left_hip_fork_l1 * t_left_hip_fork_191;
  const Scalar t_left_hip_fork_193 = t_left_hip_fork_192 + s_left_hip_roll * t_left_hip_fork_89;
  const Scalar t_left_hip_fork_194 = t_left_hip_fork_193 + c_left_hip_roll * t_left_hip_fork_115;
  // left_hip_block
  const Scalar t_left_hip_block_70 = t_left_hip_fork_151 * t_left_hip_block_37;
  const Scalar t_left_hip_block_71 = t_left_hip_fork_194 - t_left_hip_block_70;
  w[114] = t_left_hip_block_71;
  const Scalar t_left_hip_block_72 = left_hip_block_I18 * t_left_hip_block_37;
  w[123] = t_left_hip_block_72;
  const Scalar t_left_hip_block_73 = left_hip_block_h1 * t_left_hip_block_19;
  const Scalar t_left_hip_fork_195 = left_hip_fork_h1 * t_left_hip_fork_20;
  const Scalar t_left_hip_block_74 = t_left_hip_block_73 - t_left_hip_fork_195;
  const Scalar t_left_hip_fork_196 = left_hip_fork_h2 * t_left_hip_fork_22;
  const Scalar t_left_hip_block_75 = t_left_hip_block_74 + t_left_hip_fork_196;
  const Scalar t_left_hip_block_76 = t_left_hip_block_75 + s_q8_q9_q10 * t_left_thigh_43;
  const Scalar t_left_hip_block_77 = t_left_hip_block_16 * t_left_hip_block_71;
  const Scalar t_left_hip_block_78 = left_hip_block_h4 + left_hip_fork_l1 * t_left_hip_fork_188;
  const Scalar t_left_hip_block_79 = t_left_hip_block_76 + t_left_hip_block_77;
  const Scalar t_left_hip_block_80 = t_left_hip_fork_8 * t_left_hip_block_78;
  const Scalar t_left_hip_block_81 = t_left_hip_block_79 - t_left_hip_block_80;
  const Scalar t_left_hip_block_82 = t_left_hip_block_9 * t_left_hip_block_39;
  const Scalar t_left_hip_block_83 = t_left_hip_block_81 + t_left_hip_block_82;
  const Scalar t_left_hip_block_84 = t_left_hip_block_83 - c_q8_q9_q10 * t_left_thigh_36;
  const Scalar t_left_hip_block_85 = zeta_left_hip_block_z * t_left_hip_block_69;
  const Scalar t_left_hip_block_86 = t_left_hip_block_84 + t_left_hip_block_85;
  const Scalar t_left_hip_fork_197 = t_left_hip_fork_16 * t_left_hip_fork_115;
  const Scalar t_left_hip_block_87 = t_left_hip_block_86 - t_left_hip_fork_197;
  const Scalar t_left_hip_fork_198 = t_left_hip_fork_17 * t_left_hip_fork_89;
  const Scalar t_left_hip_block_88 = t_left_hip_block_37 * t_left_hip_block_51;
  const Scalar t_left_hip_block_89 = t_left_hip_block_87 - t_left_hip_fork_198;
  const Scalar t_left_hip_block_90 = t_left_hip_block_89 + t_left_hip_block_88;
  const Scalar t_left_hip_block_91 = zeta_left_hip_block_y * t_left_hip_block_67;
  const Scalar t_left_hip_block_92 = t_left_hip_block_90 - t_left_hip_block_91;
  const Scalar t_left_hip_fork_199 = t_left_hip_fork_14 * t_left_hip_fork_65;
  const Scalar t_left_hip_block_93 = t_left_hip_block_92 - t_left_hip_fork_199;
  const Scalar t_left_hip_fork_200 = t_left_thigh_139 * t_left_hip_fork_33;
  const Scalar t_left_hip_block_94 = t_left_hip_block_93 - t_left_hip_fork_200;
  const Scalar t_left_hip_fork_201 = t_left_hip_fork_12 * t_left_hip_fork_39;
  const Scalar t_left_hip_block_95 = t_left_hip_block_94 + t_left_hip_fork_201;
  w[241] = t_left_hip_block_95;
  const Scalar t_left_hip_block_96 = t_left_hip_fork_146 * t_left_hip_block_42;
  const Scalar t_left_hip_block_97 = t_left_hip_fork_127 + t_left_hip_block_96;
  w[242] = t_left_hip_block_97;
  const Scalar t_left_hip_block_98 = left_hip_block_m1 + t_left_hip_block_97;
  w[243] = t_left_hip_block_98;
  const Scalar t_left_hip_block_99 = t_left_hip_fork_146 * t_left_hip_block_45;
  const Scalar t_left_hip_fork_202 = left_hip_block_h4 - t_left_hip_fork_135;
  const Scalar t_left_hip_block_100 = t_left_hip_fork_202 - t_left_hip_block_99;
  w[244] = t_left_hip_block_100;
  const Scalar t_left_hip_block_101 = left_hip_block_I18 * t_left_hip_block_42;
  const Scalar t_left_hip_block_102 = left_hip_block_h1 - t_left_hip_block_101;
  w[265] = t_left_hip_block_102;
  const Scalar t_left_hip_block_103 = left_hip_block_I18 * t_left_hip_block_45;
  w[266] = t_left_hip_block_103;
  const Scalar t_left_hip_block_104 = left_hip_block_I8 - t_left_hip_block_103;
  w[267] = t_left_hip_block_104;
  const Scalar t_left_hip_block_105 = left_hip_block_p1 * t_left_hip_block_35;
  w[268] = t_left_hip_block_105;
  const Scalar t_left_hip_block_106 = t_left_hip_block_19 - t_left_hip_block_49;
  const Scalar t_left_hip_block_107 = zeta_left_hip_block_y * t_left_hip_block_37;
  const Scalar t_left_hip_block_108 = t_left_hip_block_106 + t_left_hip_block_107;
  const Scalar t_left_hip_block_109 = t_left_hip_block_9 * t_left_hip_block_36;
  const Scalar t_left_hip_block_110 = left_hip_block_I7 + t_left_hip_block_105;
  w[269] = t_left_hip_block_110;
  const Scalar t_left_hip_block_111 = tau[7] - left_hip_block_I8 * t_left_hip_block_20;
  const Scalar t_left_hip_block_112 = left_hip_block_I7 * t_left_hip_block_24;
  const Scalar t_left_hip_block_113 = t_left_hip_block_111 + t_left_hip_block_112;
  const Scalar t_left_hip_block_114 = zeta_left_hip_block_z * t_left_hip_block_102;
  const Scalar t_base_rx_21 = w[47];
  const Scalar t_left_hip_block_115 = t_base_rx_21 - t_left_hip_block_23;
  const Scalar t_left_hip_block_116 = t_left_hip_block_113 + t_left_hip_block_114;
  const Scalar t_left_hip_block_117 = left_hip_block_I17 * t_left_hip_block_115;
  const Scalar t_left_hip_block_118 = t_left_hip_block_108 - t_left_hip_block_109;
  const Scalar t_left_hip_block_119 = t_left_hip_block_116 - t_left_hip_block_117;
  const Scalar t_left_hip_block_120 = left_hip_block_I18 * t_left_hip_block_118;
  const Scalar t_left_hip_block_121 = t_left_hip_block_119 + t_left_hip_block_120;
  const Scalar t_left_hip_block_122 = t_left_hip_block_18 * t_left_hip_block_110;
  const Scalar t_left_hip_block_123 = t_left_hip_block_121 + t_left_hip_block_122;
  const Scalar t_left_hip_block_124 = t_left_hip_block_16 * t_left_hip_block_104;
  const Scalar t_left_hip_block_125 = t_left_hip_block_123 - t_left_hip_block_124;
  w[270] = t_left_hip_block_125;
  // left_hip_fork
  const Scalar t_left_hip_fork_203 = t_left_hip_fork_133 + t_left_hip_fork_135;
  const Scalar t_left_hip_fork_204 = t_left_hip_fork_92 - t_left_hip_fork_140;
  const Scalar t_left_hip_fork_205 = left_hip_fork_l1 * t_left_hip_fork_203;
  const Scalar t_left_hip_block_126 = t_left_hip_fork_151 * t_left_hip_block_45;
  const Scalar t_left_hip_fork_206 = t_left_hip_fork_204 + t_left_hip_fork_205;
  // left_hip_block
  const Scalar t_left_hip_block_127 = t_left_hip_fork_206 - t_left_hip_block_126;
  w[271] = t_left_hip_block_127;
  const Scalar t_left_hip_block_128 = left_hip_block_I16 - t_left_hip_block_127;
  w[272] = t_left_hip_block_128;
  const Scalar t_left_hip_block_129 = left_hip_block_I16 * t_left_hip_block_20;
  const Scalar t_left_hip_block_130 = left_hip_block_I8 * t_left_hip_block_24;
  const Scalar t_left_hip_block_131 = t_left_hip_block_130 - t_left_hip_block_129;
  const Scalar t_left_hip_block_132 = left_hip_block_I17 * t_left_hip_block_19;
  // left_hip_fork
  const Scalar t_left_hip_fork_207 = t_left_hip_block_131 + t_left_hip_block_132;
  const Scalar t_left_hip_fork_208 = left_hip_fork_l1 * t_left_hip_fork_88;
  const Scalar t_left_hip_fork_209 = t_left_hip_fork_207 + t_left_hip_fork_208;
  const Scalar t_left_hip_fork_210 = t_left_hip_fork_209 + s_left_hip_roll * t_left_hip_fork_113;
  const Scalar t_left_hip_fork_211 = left_hip_block_I18 * (t_base_rx_21 - t_left_hip_fork_8);
  const Scalar t_left_hip_fork_212 = t_left_hip_fork_210 - t_left_hip_fork_211;
  const Scalar t_left_hip_fork_213 = t_left_hip_fork_212 + c_left_hip_roll * t_left_hip_fork_181;
  // left_hip_block
  const Scalar t_left_hip_block_133 = t_left_hip_fork_151 * t_left_hip_block_49;
  const Scalar t_left_hip_block_134 = zeta_left_hip_block_z * t_left_hip_block_100;
  const Scalar t_left_hip_block_135 = t_left_hip_fork_213 + t_left_hip_block_133;
  const Scalar t_left_hip_block_136 = t_left_hip_block_135 - t_left_hip_block_134;
  const Scalar t_left_hip_block_137 = t_left_hip_block_16 * t_left_hip_block_128;
  const Scalar t_left_hip_block_138 = t_left_hip_block_136 - t_left_hip_block_137;
  const Scalar t_left_hip_block_139 = t_left_hip_block_18 * t_left_hip_block_104;
  const Scalar t_left_hip_block_140 = t_left_hip_block_138 + t_left_hip_block_139;
  const Scalar t_left_hip_block_141 = zeta_left_hip_block_y * t_left_hip_block_71;
  const Scalar t_left_hip_block_142 = t_left_hip_block_140 + t_left_hip_block_141;
  const Scalar t_left_hip_block_143 = t_left_hip_block_9 * t_left_hip_block_47;
  const Scalar t_left_hip_block_144 = t_left_hip_block_142 - t_left_hip_block_143;
  w[273] = t_left_hip_block_144;
  const Scalar t_base_rx_19 = w[46];
  const Scalar t_base_rx_24 = w[50];
  const Scalar t_left_hip_block_145 = t_base_rx_19 - t_base_rx_24;
  w[274] = t_left_hip_block_145;
  // right_hip_block
  const Scalar zeta_right_hip_block_x = w[125];
  const Scalar t_right_hip_fork_183 = w[139];
  const Scalar t_right_hip_block_160 = zeta_right_hip_block_x * t_right_hip_fork_183;
  const Scalar zeta_right_hip_block_y = w[124];
  const Scalar t_right_hip_fork_191 = w[140];
  const Scalar t_right_hip_block_161 = zeta_right_hip_block_y * t_right_hip_fork_191;
  const Scalar u_right_hip_block = w[142];
  const Scalar t_right_hip_block_162 = u_right_hip_block - t_right_hip_block_160;
  const Scalar t_right_hip_block_163 = t_right_hip_block_162 + t_right_hip_block_161;
  const Scalar t_right_hip_block_29 = w[150];
  const Scalar t_right_hip_block_164 = t_right_hip_block_29 * t_right_hip_block_163;
  const Scalar t_right_hip_block_18 = w[133];
  const Scalar t_right_hip_block_165 = tau[13] + left_hip_block_I8 * t_right_hip_block_18;
  const Scalar t_right_hip_block_16 = w[131];
  const Scalar t_right_hip_block_166 = left_hip_block_I7 * t_right_hip_block_16;
  const Scalar t_right_hip_block_167 = t_right_hip_block_165 + t_right_hip_block_166;
  const Scalar t_right_hip_block_11 = w[128];
  const Scalar t_right_hip_block_100 = w[210];
  const Scalar t_right_hip_block_168 = t_right_hip_block_11 * t_right_hip_block_100;
  const Scalar t_right_hip_block_169 = t_right_hip_block_167 + t_right_hip_block_168;
  const Scalar t_right_hip_block_8 = w[127];
  const Scalar t_right_hip_block_150 = w[227];
  const Scalar t_right_hip_block_170 = t_right_hip_block_8 * t_right_hip_block_150;
  const Scalar t_right_hip_block_15 = w[130];
  const Scalar t_right_hip_block_171 = t_right_hip_block_15 - t_right_hip_block_164;
  const Scalar t_right_hip_block_172 = t_right_hip_block_169 + t_right_hip_block_170;
  const Scalar t_right_hip_block_173 = left_hip_block_I18 * t_right_hip_block_171;
  const Scalar t_right_hip_block_14 = w[129];
  const Scalar t_right_hip_block_174 = t_base_rx_21 - t_right_hip_block_14;
  const Scalar t_right_hip_block_175 = t_right_hip_block_172 + t_right_hip_block_173;
  const Scalar t_right_hip_block_176 = left_hip_block_I17 * t_right_hip_block_174;
  const Scalar t_right_hip_block_177 = t_right_hip_block_175 + t_right_hip_block_176;
  const Scalar zeta_right_hip_block_z = w[126];
  const Scalar t_right_hip_block_96 = w[206];
  const Scalar t_right_hip_block_178 = zeta_right_hip_block_z * t_right_hip_block_96;
  const Scalar t_right_hip_block_179 = t_right_hip_block_177 - t_right_hip_block_178;
  w[275] = t_right_hip_block_179;
  const Scalar t_left_hip_block_146 = left_hip_block_h1 * t_left_hip_block_24;
  const Scalar t_left_hip_fork_214 = t_left_hip_fork_88 - t_left_hip_block_146;
  const Scalar t_left_hip_block_147 = left_hip_block_h4 * t_left_hip_block_20;
  const Scalar t_left_hip_block_148 = t_left_hip_block_9 * t_left_hip_block_44;
  const Scalar t_left_hip_fork_215 = t_left_hip_fork_214 - t_left_hip_block_147;
  // left_hip_block
  const Scalar t_left_hip_block_149 = t_left_hip_fork_215 - t_left_hip_block_148;
  const Scalar t_left_hip_block_150 = u_left_hip_block * t_left_hip_block_42;
  const Scalar t_left_hip_block_151 = t_left_hip_block_149 - t_left_hip_block_150;
  const Scalar t_left_hip_block_152 = zeta_left_hip_block_y * t_left_hip_block_69;
  const Scalar t_left_hip_block_153 = t_left_hip_block_151 + t_left_hip_block_152;
  const Scalar t_left_hip_block_154 = t_left_hip_block_16 * t_left_hip_block_100;
  const Scalar t_left_hip_block_155 = t_left_hip_block_153 - t_left_hip_block_154;
  const Scalar t_left_hip_block_156 = t_left_hip_block_18 * t_left_hip_block_102;
  const Scalar t_left_hip_block_157 = t_left_hip_block_155 - t_left_hip_block_156;
  const Scalar t_left_hip_block_158 = zeta_left_hip_block_z * t_left_hip_block_98;
  const Scalar t_left_hip_block_159 = t_left_hip_block_157 - t_left_hip_block_158;
  w[276] = t_left_hip_block_159;
  const Scalar t_right_hip_block_180 = left_hip_block_h1 * t_right_hip_block_16;
  const Scalar t_right_hip_fork_218 = w[214];
  const Scalar t_right_hip_fork_222 = t_right_hip_fork_218 + t_right_hip_block_180;
  const Scalar t_right_hip_block_181 = left_hip_block_h4 * t_right_hip_block_18;
  const Scalar t_right_hip_block_38 = w[157];
  const Scalar t_right_hip_block_182 = zeta_right_hip_block_y * t_right_hip_block_38;
  const Scalar t_right_hip_fork_223 = t_right_hip_fork_222 - t_right_hip_block_181;
  // right_hip_block
  const Scalar t_right_hip_block_98 = w[207];
  const Scalar t_right_hip_block_183 = t_right_hip_block_11 * t_right_hip_block_98;
  const Scalar t_right_hip_block_184 = t_right_hip_fork_223 + t_right_hip_block_182;
  const Scalar t_right_hip_block_185 = t_right_hip_block_184 - t_right_hip_block_183;
  const Scalar t_right_hip_block_94 = w[204];
  const Scalar t_right_hip_block_186 = zeta_right_hip_block_z * t_right_hip_block_94;
  const Scalar t_right_hip_block_187 = t_right_hip_block_185 - t_right_hip_block_186;
  const Scalar t_right_hip_block_36 = w[156];
  const Scalar t_right_hip_block_188 = u_right_hip_block * t_right_hip_block_36;
  const Scalar t_right_hip_block_189 = t_right_hip_block_187 + t_right_hip_block_188;
  w[277] = t_right_hip_block_189;
}

[[gnu::noinline]] void forward_dynamics_8(const Scalar tau[18], Scalar qdd[18],
                                          Scalar w[278]) noexcept {
  // right_hip_block
  const Scalar zeta_right_hip_block_x = w[125];
  const Scalar t_right_hip_block_74 = w[196];
  const Scalar t_right_hip_block_190 = zeta_right_hip_block_x * t_right_hip_block_74;
  const Scalar t_right_hip_block_189 = w[277];
  const Scalar t_right_hip_block_191 = t_right_hip_block_189 - t_right_hip_block_190;
  const Scalar t_right_hip_block_8 = w[127];
  const Scalar t_right_hip_block_96 = w[206];
  const Scalar t_right_hip_block_192 = t_right_hip_block_8 * t_right_hip_block_96;
  const Scalar t_right_hip_block_193 = t_right_hip_block_191 + t_right_hip_block_192;
  const Scalar t_left_hip_block_159 = w[276];
  const Scalar t_left_hip_block_160 = t_left_hip_block_159 - t_right_hip_block_193;
  const Scalar s_right_hip_yaw = w[15];
  const Scalar t_right_hip_block_70 = w[194];
  const Scalar t_right_hip_block_194 = s_right_hip_yaw * t_right_hip_block_70;
  const Scalar s_left_hip_yaw = w[3];
  const Scalar t_left_hip_block_95 = w[241];
  const Scalar t_left_hip_block_161 = s_left_hip_yaw * t_left_hip_block_95;
  const Scalar t_left_hip_block_162 = t_right_hip_block_194 - t_left_hip_block_161;
  const Scalar c_right_hip_yaw = w[16];
  const Scalar t_right_hip_block_91 = w[200];
  const Scalar t_right_hip_block_195 = c_right_hip_yaw * t_right_hip_block_91;
  // left_hip_block
  const Scalar t_left_hip_block_163 = t_left_hip_block_162 - t_right_hip_block_195;
  const Scalar c_left_hip_yaw = w[4];
  const Scalar t_left_hip_block_65 = w[111];
  const Scalar t_left_hip_block_164 = c_left_hip_yaw * t_left_hip_block_65;
  const Scalar t_left_hip_block_165 = t_left_hip_block_163 + t_left_hip_block_164;
  const Scalar t_base_rx_23 = w[49];
  const Scalar t_left_hip_block_166 = tau[5] + base_rx_I5 * t_base_rx_23;
  const Scalar t_base_rx_25 = w[51];
  const Scalar t_left_hip_block_167 = t_left_hip_block_166 + base_rx_I1 * t_base_rx_25;
  const Scalar t_right_hip_block_127 = w[215];
  const Scalar t_right_hip_block_196 = s_right_hip_yaw * t_right_hip_block_127;
  const Scalar t_left_hip_block_168 = t_left_hip_block_167 - t_right_hip_block_196;
  const Scalar t_left_hip_block_144 = w[273];
  const Scalar t_left_hip_block_169 = s_left_hip_yaw * t_left_hip_block_144;
  const Scalar t_left_hip_block_170 = t_left_hip_block_168 + t_left_hip_block_169;
  const Scalar t_base_rx_22 = w[48];
  const Scalar t_left_hip_block_171 = t_left_hip_block_170 + base_rx_I18 * t_base_rx_22;
  const Scalar t_left_hip_block_172 = left_hip_block_l2 * t_left_hip_block_165;
  const Scalar t_left_hip_block_173 = t_left_hip_block_171 + t_left_hip_block_172;
  const Scalar t_left_hip_block_145 = w[274];
  const Scalar t_left_hip_block_174 = t_left_hip_block_173 + base_rx_I15 * t_left_hip_block_145;
  const Scalar t_right_hip_block_179 = w[275];
  const Scalar t_right_hip_block_197 = c_right_hip_yaw * t_right_hip_block_179;
  const Scalar t_left_hip_block_175 = t_left_hip_block_174 - t_right_hip_block_197;
  const Scalar t_left_hip_block_125 = w[270];
  const Scalar t_left_hip_block_176 = c_left_hip_yaw * t_left_hip_block_125;
  const Scalar t_left_hip_block_177 = t_left_hip_block_175 - t_left_hip_block_176;
  const Scalar t_left_hip_block_178 = left_hip_block_l1 * t_left_hip_block_160;
  const Scalar t_left_hip_block_179 = t_left_hip_block_177 + t_left_hip_block_178;
  const Scalar t_left_hip_block_180 = 2.0 * c_left_hip_yaw;
  const Scalar t_left_hip_block_41 = w[100];
  const Scalar t_left_hip_block_67 = w[112];
  const Scalar t_left_hip_block_181 = t_left_hip_block_41 - t_left_hip_block_67;
  const Scalar t_left_hip_block_39 = w[99];
  const Scalar t_left_hip_block_182 = t_left_hip_block_39 * t_left_hip_block_180;
  const Scalar t_left_hip_block_183 = s_left_hip_yaw * t_left_hip_block_181;
  const Scalar t_left_hip_block_184 = t_left_hip_block_183 + t_left_hip_block_182;
  const Scalar t_left_hip_block_185 = s_left_hip_yaw * t_left_hip_block_184;
  const Scalar t_left_hip_block_44 = w[101];
  const Scalar t_left_hip_block_186 = c_left_hip_yaw * t_left_hip_block_44;
  const Scalar t_left_hip_block_69 = w[113];
  const Scalar t_left_hip_block_187 = s_left_hip_yaw * t_left_hip_block_69;
  const Scalar t_left_hip_block_188 = t_left_hip_block_186 - t_left_hip_block_187;
  const Scalar t_left_hip_block_48 = w[104];
  const Scalar t_left_hip_block_71 = w[114];
  const Scalar t_left_hip_block_189 = t_left_hip_block_48 - t_left_hip_block_71;
  const Scalar t_left_hip_block_47 = w[103];
  const Scalar t_left_hip_block_72 = w[123];
  const Scalar t_left_hip_block_190 = t_left_hip_block_47 + t_left_hip_block_72;
  const Scalar t_left_hip_block_191 = c_left_hip_yaw * t_left_hip_block_189;
  const Scalar t_left_hip_block_192 = s_left_hip_yaw * t_left_hip_block_190;
  const Scalar t_left_hip_block_193 = t_left_hip_block_191 - t_left_hip_block_192;
  const Scalar t_left_hip_block_194 = c_left_hip_yaw * t_left_hip_block_193;
  const Scalar t_left_hip_block_102 = w[265];
  const Scalar t_left_hip_block_195 = c_left_hip_yaw * t_left_hip_block_102;
  const Scalar t_left_hip_block_100 = w[244];
  const Scalar t_left_hip_block_196 = s_left_hip_yaw * t_left_hip_block_100;
  const Scalar t_left_hip_block_197 = t_left_hip_block_195 + t_left_hip_block_196;
  const Scalar t_left_hip_block_98 = w[243];
  const Scalar t_left_hip_block_198 = left_hip_block_l1 * t_left_hip_block_98;
  const Scalar t_left_hip_block_199 = t_left_hip_block_197 + t_left_hip_block_198;
  const Scalar t_left_hip_block_200 = left_hip_block_l2 * t_left_hip_block_188;
  const Scalar t_left_hip_block_201 = t_left_hip_block_199 - t_left_hip_block_200;
  const Scalar t_left_hip_block_110 = w[269];
  const Scalar t_left_hip_block_128 = w[272];
  const Scalar t_left_hip_block_202 = t_left_hip_block_110 - t_left_hip_block_128;
  const Scalar t_left_hip_block_104 = w[267];
  const Scalar t_left_hip_block_203 = t_left_hip_block_104 * t_left_hip_block_180;
  const Scalar t_left_hip_block_204 = s_left_hip_yaw * t_left_hip_block_202;
  const Scalar t_left_hip_block_205 = t_left_hip_block_204 + t_left_hip_block_203;
  const Scalar t_right_hip_block_72 = w[195];
  const Scalar t_right_hip_block_133 = w[222];
  const Scalar t_right_hip_block_198 = t_right_hip_block_72 - t_right_hip_block_133;
  const Scalar t_left_hip_block_206 = t_left_hip_block_41 + t_right_hip_block_198;
  const Scalar t_left_hip_block_207 = t_left_hip_block_185 - t_left_hip_block_206;
  const Scalar t_right_hip_block_43 = w[192];
  const Scalar t_right_hip_block_142 = w[224];
  const Scalar t_right_hip_block_199 = t_right_hip_block_43 - t_right_hip_block_142;
  const Scalar t_left_hip_block_208 = t_left_hip_block_71 + t_right_hip_block_199;
  const Scalar t_left_hip_block_209 = t_left_hip_block_194 + t_left_hip_block_208;
  const Scalar t_left_hip_block_210 = left_hip_block_l2 * t_left_hip_block_207;
  const Scalar t_right_hip_block_136 = w[223];
  const Scalar t_left_hip_block_211 = t_right_hip_block_136 + t_left_hip_block_188;
  const Scalar t_left_hip_block_212 = t_left_hip_block_209 - t_left_hip_block_210;
  const Scalar t_left_hip_block_213 = left_hip_block_l1 * t_left_hip_block_211;
  const Scalar t_left_hip_block_214 = t_left_hip_block_212 - t_left_hip_block_213;
  const Scalar t_right_hip_block_154 = w[228];
  const Scalar t_right_hip_block_200 = s_right_hip_yaw * t_right_hip_block_154;
  const Scalar t_left_hip_block_215 = s_left_hip_yaw * t_left_hip_block_205;
  const Scalar t_left_hip_block_216 = t_left_hip_block_215 - t_right_hip_block_200;
  const Scalar t_right_hip_block_145 = w[225];
  const Scalar t_right_hip_block_149 = w[226];
  const Scalar t_left_hip_block_217 = t_right_hip_block_145 + t_right_hip_block_149;
  const Scalar t_left_hip_block_218 = t_left_hip_block_197 + t_left_hip_block_217;
  const Scalar t_left_hip_block_105 = w[268];
  const Scalar t_right_hip_block_101 = w[211];
  const Scalar t_left_hip_block_219 = base_rx_I21 + t_right_hip_block_101 + t_left_hip_block_105;
  const Scalar t_left_hip_block_220 = t_left_hip_block_209 + t_left_hip_block_214;
  const Scalar t_left_hip_block_221 = t_left_hip_block_216 - t_left_hip_block_219;
  const Scalar t_left_hip_block_222 = left_hip_block_l2 * t_left_hip_block_220;
  const Scalar t_left_hip_block_223 = t_left_hip_block_201 + t_left_hip_block_218;
  const Scalar t_left_hip_block_224 = t_left_hip_block_221 - t_left_hip_block_222;
  const Scalar t_left_hip_block_225 = left_hip_block_l1 * t_left_hip_block_223;
  const Scalar t_left_hip_block_226 = t_left_hip_block_224 - t_left_hip_block_225;
  const Scalar t_left_hip_block_227 = s_left_hip_yaw * t_left_hip_block_193;
  const Scalar t_left_hip_block_228 = s_left_hip_yaw * t_left_hip_block_44;
  const Scalar t_left_hip_block_229 = c_left_hip_yaw * t_left_hip_block_69;
  const Scalar t_left_hip_block_230 = t_left_hip_block_228 + t_left_hip_block_229;
  const Scalar t_left_hip_block_231 = s_left_hip_yaw * t_left_hip_block_102;
  const Scalar t_left_hip_block_232 = c_left_hip_yaw * t_left_hip_block_100;
  const Scalar t_left_hip_block_233 = t_left_hip_block_231 - t_left_hip_block_232;
  const Scalar t_left_hip_block_234 = left_hip_block_l2 * t_left_hip_block_230;
  const Scalar t_left_hip_block_235 = t_left_hip_block_233 - t_left_hip_block_234;
  // right_hip_block
  const Scalar t_right_hip_block_158 = w[238];
  const Scalar t_right_hip_block_201 = left_hip_block_l2 * t_right_hip_block_158;
  const Scalar t_right_hip_block_202 = s_right_hip_yaw * t_right_hip_block_96;
  const Scalar t_right_hip_block_203 = t_right_hip_block_201 - t_right_hip_block_202;
  const Scalar t_right_hip_block_98 = w[207];
  const Scalar t_right_hip_block_204 = c_right_hip_yaw * t_right_hip_block_98;
  const Scalar t_right_hip_block_205 = t_right_hip_block_203 - t_right_hip_block_204;
  const Scalar t_left_hip_block_236 = c_left_hip_yaw * t_left_hip_block_184;
  const Scalar t_left_hip_block_237 = t_left_hip_block_39 - t_left_hip_block_236;
  const Scalar t_right_hip_block_132 = w[216];
  const Scalar t_right_hip_block_206 = c_right_hip_yaw * t_right_hip_block_132;
  const Scalar t_right_hip_block_33 = w[154];
  const Scalar t_right_hip_block_207 = t_right_hip_block_33 - t_right_hip_block_206;
  const Scalar t_left_hip_block_238 = t_left_hip_block_237 + t_right_hip_block_207;
  const Scalar t_left_hip_block_239 = left_hip_block_l2 * t_left_hip_block_238;
  const Scalar t_right_hip_block_76 = w[197];
  const Scalar t_right_hip_block_155 = w[229];
  const Scalar t_right_hip_block_208 = t_right_hip_block_76 - t_right_hip_block_155;
  const Scalar t_left_hip_block_240 = t_left_hip_block_47 + t_right_hip_block_208;
  const Scalar t_left_hip_block_241 = t_left_hip_block_227 + t_left_hip_block_240;
  const Scalar t_right_hip_block_44 = w[193];
  const Scalar t_right_hip_block_209 = t_right_hip_block_44 + t_right_hip_block_155;
  // left_hip_block
  const Scalar t_left_hip_block_242 = t_left_hip_block_72 + t_left_hip_block_227;
  const Scalar t_left_hip_block_243 = t_left_hip_block_239 + t_right_hip_block_209;
  const Scalar t_left_hip_block_244 = t_left_hip_block_242 - t_left_hip_block_243;
  const Scalar t_left_hip_block_103 = w[266];
  const Scalar t_right_hip_block_99 = w[209];
  const Scalar t_left_hip_block_245 = base_rx_I5 - t_right_hip_block_99 + t_left_hip_block_103;
  const Scalar t_right_hip_block_210 = c_right_hip_yaw * t_right_hip_block_154;
  const Scalar t_left_hip_block_246 = t_left_hip_block_235 - t_right_hip_block_205;
  const Scalar t_left_hip_block_247 = t_left_hip_block_245 - t_right_hip_block_210;
  const Scalar t_left_hip_block_248 = left_hip_block_l1 * t_left_hip_block_246;
  const Scalar t_left_hip_block_249 = t_left_hip_block_241 + t_left_hip_block_244;
  const Scalar t_left_hip_block_250 = t_left_hip_block_247 + t_left_hip_block_248;
  const Scalar t_left_hip_block_251 = left_hip_block_l2 * t_left_hip_block_249;
  const Scalar t_left_hip_block_252 = t_left_hip_block_250 + t_left_hip_block_251;
  const Scalar t_left_hip_block_253 = c_left_hip_yaw * t_left_hip_block_205;
  const Scalar t_left_hip_block_254 = t_left_hip_block_252 + t_left_hip_block_253;
  const Scalar t_left_hip_block_255 = t_left_hip_block_67 + t_left_hip_block_185;
  const Scalar t_left_hip_block_256 = base_rx_h7 - t_left_hip_block_214;
  const Scalar t_left_hip_block_257 = t_left_hip_block_237 - t_right_hip_block_207;
  const Scalar t_left_hip_block_258 = t_right_hip_block_158 - t_left_hip_block_230;
  const Scalar t_left_hip_block_259 = base_rx_I1 + left_hip_block_p3 * t_left_hip_block_257;
  const Scalar t_left_hip_block_260 = left_hip_block_p2 * t_left_hip_block_258;
  const Scalar t_left_hip_block_261 = t_right_hip_block_209 + t_left_hip_block_242;
  const Scalar t_left_hip_block_262 = t_left_hip_block_259 - t_left_hip_block_260;
  const Scalar t_left_hip_block_263 = left_hip_block_l1 * t_left_hip_block_261;
  const Scalar t_left_hip_block_264 = t_left_hip_block_262 - t_left_hip_block_263;
  const Scalar t_left_hip_block_265 = t_right_hip_block_158 + t_left_hip_block_230;
  const Scalar t_left_hip_block_266 = left_hip_block_l1 * t_left_hip_block_265;
  const Scalar t_left_hip_block_267 = t_left_hip_block_244 - t_left_hip_block_266;
  const Scalar t_left_hip_block_268 = t_right_hip_block_149 - t_left_hip_block_201;
  // base_rx
  const Scalar t_base_rx_27 = 1.0 / t_left_hip_block_226;
  const Scalar t_base_rx_28 = t_left_hip_block_264 * t_base_rx_27;
  const Scalar t_base_rx_29 = t_left_hip_block_268 * t_base_rx_27;
  const Scalar t_base_rx_30 = t_left_hip_block_266 - t_left_hip_block_264 * t_base_rx_29;
  const Scalar t_base_rx_31 = t_left_hip_block_267 * t_base_rx_27;
  const Scalar t_right_hip_block_159 = w[239];
  const Scalar t_left_hip_block_269 = t_right_hip_block_159 - t_left_hip_block_255;
  const Scalar t_left_hip_block_270 = left_hip_block_l1 * t_left_hip_block_269;
  const Scalar t_base_rx_32 = t_left_hip_block_267 * t_base_rx_28 + t_left_hip_block_270;
  const Scalar t_left_hip_block_271 = base_rx_h2 - left_hip_block_l1 * t_left_hip_block_257;
  const Scalar t_base_rx_33 = t_left_hip_block_271 + t_left_hip_block_256 * t_base_rx_28;
  const Scalar t_base_rx_34 = t_left_hip_block_254 * t_base_rx_27;
  // left_hip_block
  const Scalar t_left_hip_block_272 = t_left_hip_block_48 - t_left_hip_block_194;
  const Scalar t_left_hip_block_273 = left_hip_block_l2 * t_left_hip_block_255;
  const Scalar t_left_hip_block_274 = t_left_hip_block_272 + t_left_hip_block_273;
  // right_hip_block
  const Scalar t_right_hip_block_77 = w[199];
  const Scalar t_right_hip_block_211 = t_right_hip_block_77 + t_right_hip_block_142;
  const Scalar t_right_hip_block_212 = left_hip_block_l2 * t_right_hip_block_159;
  const Scalar t_right_hip_block_213 = t_right_hip_block_211 + t_right_hip_block_212;
  const Scalar t_left_hip_block_275 = t_right_hip_block_159 + t_left_hip_block_255;
  const Scalar t_left_hip_block_276 = base_rx_I19 + left_hip_block_p2 * t_left_hip_block_275;
  const Scalar t_base_rx_35 = t_left_hip_block_276 + t_left_hip_block_264 * t_base_rx_28;
  const Scalar inverse_pivot_base_ry = 1.0 / t_base_rx_35;
  const Scalar t_left_hip_block_277 = t_left_hip_block_274 - t_right_hip_block_213;
  const Scalar t_left_hip_block_278 = base_rx_I15 - left_hip_block_l1 * t_left_hip_block_277;
  const Scalar t_base_rx_36 = t_left_hip_block_278 + t_left_hip_block_264 * t_base_rx_34;
  const Scalar t_base_ry_1 = inverse_pivot_base_ry * t_base_rx_36;
  const Scalar t_left_hip_block_279 = t_left_hip_block_239 - t_left_hip_block_241;
  // base_ry
  const Scalar t_base_ry_2 = t_left_hip_block_279 - t_base_rx_33 * t_base_ry_1;
  const Scalar t_base_ry_3 = t_base_ry_2 + t_left_hip_block_256 * t_base_rx_34;
  const Scalar t_base_ry_4 = t_base_rx_30 * inverse_pivot_base_ry;
  const Scalar t_base_ry_5 = t_base_rx_32 * inverse_pivot_base_ry;
  const Scalar t_left_hip_block_280 = base_rx_h2 - t_left_hip_block_235;
  const Scalar t_left_hip_block_281 = t_right_hip_block_205 - t_left_hip_block_280;
  const Scalar t_base_ry_6 = t_left_hip_block_281 - t_base_rx_36 * t_base_ry_4;
  const Scalar t_base_ry_7 = t_base_ry_6 - t_left_hip_block_268 * t_base_rx_34;
  const Scalar t_left_hip_block_282 = t_left_hip_block_274 + t_right_hip_block_213;
  const Scalar t_base_rx_37 = t_left_hip_block_267 * t_base_rx_34;
  const Scalar t_base_rx_38 = base_rx_h7 - t_left_hip_block_282 - t_base_rx_37;
  const Scalar t_base_ry_8 = t_base_rx_38 + t_base_rx_32 * t_base_ry_1;
  // left_hip_block
  const Scalar t_left_hip_block_283 = t_left_hip_block_272 + t_right_hip_block_211;
  const Scalar t_right_hip_block_103 = w[213];
  const Scalar t_left_hip_block_284 = base_rx_I16 - t_right_hip_block_103;
  const Scalar t_left_hip_block_127 = w[271];
  const Scalar t_left_hip_block_285 = t_left_hip_block_127 - t_left_hip_block_284;
  const Scalar t_left_hip_block_286 = t_left_hip_block_282 + t_left_hip_block_283;
  const Scalar t_left_hip_block_287 = t_left_hip_block_216 - t_left_hip_block_285;
  const Scalar t_left_hip_block_288 = left_hip_block_l2 * t_left_hip_block_286;
  const Scalar t_left_hip_block_289 = t_left_hip_block_287 + t_left_hip_block_288;
  const Scalar t_base_ry_9 = t_left_hip_block_289 - t_base_rx_36 * t_base_ry_1;
  const Scalar t_base_ry_10 = t_base_ry_9 + t_left_hip_block_254 * t_base_rx_34;
  // base_rz
  const Scalar inverse_pivot_base_rz = 1.0 / t_base_ry_10;
  const Scalar t_base_rz_1 = t_base_ry_3 * inverse_pivot_base_rz;
  const Scalar t_base_rz_2 = t_base_ry_8 * inverse_pivot_base_rz;
  const Scalar t_base_rz_3 = t_left_hip_block_258 - t_base_rx_32 * t_base_ry_4;
  const Scalar t_base_rz_4 = t_base_rz_3 + t_base_ry_7 * t_base_rz_2;
  const Scalar t_base_rz_5 = t_base_rz_4 - t_left_hip_block_268 * t_base_rx_31;
  const Scalar t_base_rz_6 = t_base_ry_7 * inverse_pivot_base_rz;
  const Scalar t_left_hip_block_290 = base_rx_m4 + t_left_hip_block_275;
  const Scalar t_base_rz_7 = t_left_hip_block_290 - t_base_ry_8 * t_base_rz_2;
  const Scalar t_base_rz_8 = t_base_rz_7 + t_left_hip_block_267 * t_base_rx_31;
  const Scalar t_base_rx_39 = t_left_hip_block_238 + t_left_hip_block_256 * t_base_rx_31;
  const Scalar t_base_ry_11 = t_base_rx_39 - t_base_rx_33 * t_base_ry_5;
  const Scalar t_base_rz_9 = t_base_ry_11 + t_base_ry_8 * t_base_rz_1;
  const Scalar inverse_pivot_base_pz = 1.0 / (t_base_rz_8 - t_base_rx_32 * t_base_ry_5);
  const Scalar t_base_pz_1 = t_base_rz_5 * inverse_pivot_base_pz;
  const Scalar t_left_hip_block_97 = w[242];
  const Scalar t_right_hip_block_93 = w[201];
  const Scalar t_left_hip_block_291 = base_rx_m2 + t_right_hip_block_93 + t_left_hip_block_97;
  // base_pz
  const Scalar t_base_pz_2 = t_left_hip_block_291 - t_base_rz_5 * t_base_pz_1;
  const Scalar t_base_pz_3 = t_base_pz_2 - t_base_rx_30 * t_base_ry_4;
  const Scalar t_base_pz_4 = t_base_pz_3 - t_base_ry_7 * t_base_rz_6;
  const Scalar t_base_pz_5 = t_base_rz_9 * inverse_pivot_base_pz;
  const Scalar t_base_rx_40 = t_left_hip_block_256 * t_base_rx_27;
  const Scalar t_left_hip_block_292 = t_right_hip_block_136 - t_left_hip_block_188;
  const Scalar t_base_pz_6 = t_left_hip_block_292 + t_base_ry_3 * t_base_rz_6;
  const Scalar t_base_pz_7 = t_base_pz_6 + t_base_rx_33 * t_base_ry_4;
  const Scalar t_base_pz_8 = t_base_pz_7 + t_base_rz_5 * t_base_pz_5;
  const Scalar t_base_pz_9 = t_base_pz_8 + t_left_hip_block_268 * t_base_rx_40;
  const Scalar t_base_pz_10 = t_base_pz_4 + t_left_hip_block_268 * t_base_rx_29;
  const Scalar inverse_pivot_base_py = 1.0 / t_base_pz_10;
  const Scalar t_base_ry_12 = t_base_rx_33 * inverse_pivot_base_ry;
  const Scalar t_base_py_1 = t_base_pz_9 * inverse_pivot_base_py;
  const Scalar t_base_rx_41 = t_left_hip_block_256 * t_base_rx_40;
  const Scalar t_base_rx_42 = base_rx_m4 - t_left_hip_block_207 + t_base_rx_41;
  const Scalar t_base_ry_13 = t_base_rx_42 - t_base_rx_33 * t_base_ry_12;
  const Scalar t_base_py_2 = t_base_ry_13 - t_base_pz_9 * t_base_py_1;
  const Scalar t_base_py_3 = t_base_py_2 - t_base_ry_3 * t_base_rz_1;
  const Scalar inverse_pivot_base_px = 1.0 / (t_base_py_3 - t_base_rz_9 * t_base_pz_5);
  const Scalar t_base_rx_19 = w[46];
  const Scalar t_base_rx_24 = w[50];
  const Scalar t_base_rx_43 = t_base_rx_19 + t_base_rx_24;
  // left_hip_block
  const Scalar t_left_hip_block_293 = c_left_hip_yaw * t_left_hip_block_95;
  const Scalar t_left_hip_block_294 = s_left_hip_yaw * t_left_hip_block_65;
  const Scalar t_left_hip_block_295 = t_left_hip_block_293 + t_left_hip_block_294;
  // right_hip_block
  const Scalar t_right_hip_block_214 = c_right_hip_yaw * t_right_hip_block_70;
  const Scalar t_right_hip_block_215 = s_right_hip_yaw * t_right_hip_block_91;
  const Scalar t_right_hip_block_216 = t_right_hip_block_214 + t_right_hip_block_215;
  // base_px
  const Scalar c_base_rx = w[2];
  const Scalar t_base_rx_17 = w[43];
  const Scalar s_base_rx = w[1];
  const Scalar t_base_px_1 = tau[12] + tau[6] - c_base_rx * t_base_rx_17 + s_base_rx * tau[4];
  const Scalar t_base_px_2 = t_base_px_1 + base_rx_I1 * t_base_rx_22;
  const Scalar t_base_px_3 = t_base_px_2 - base_rx_I15 * t_base_rx_23;
  const Scalar t_base_px_4 = t_base_px_3 + t_left_hip_block_179 * t_base_rx_28;
  const Scalar t_base_rx_26 = w[52];
  const Scalar t_base_px_5 = base_rx_I5 * (t_base_rx_26 - t_base_rx_43);
  const Scalar t_base_px_6 = t_left_hip_block_295 + t_right_hip_block_216;
  const Scalar t_base_px_7 = t_base_px_4 - base_rx_I20 * t_base_rx_25 + t_base_px_5;
  const Scalar t_base_px_8 = t_base_px_7 - left_hip_block_l1 * t_base_px_6;
  const Scalar t_base_px_9 = t_left_hip_block_295 - t_right_hip_block_216;
  const Scalar t_base_rx_44 = s_base_rx * t_base_rx_17 + c_base_rx * tau[4];
  const Scalar t_base_px_10 = t_base_rx_44 - base_rx_I5 * t_base_rx_22;
  const Scalar t_base_px_11 = t_base_px_10 - base_rx_I15 * t_base_rx_25;
  const Scalar t_base_px_12 = t_base_px_11 + c_right_hip_yaw * t_right_hip_block_127;
  const Scalar t_base_px_13 = t_base_px_12 - c_left_hip_yaw * t_left_hip_block_144;
  const Scalar t_base_px_14 = t_base_px_13 - t_base_ry_1 * t_base_px_8;
  const Scalar t_base_px_15 = t_base_px_14 + t_left_hip_block_179 * t_base_rx_34;
  const Scalar t_base_rx_21 = w[47];
  const Scalar t_base_px_16 = t_base_px_15 - base_rx_I1 * (t_base_rx_21 - t_base_rx_43);
  const Scalar t_base_px_17 = t_base_px_16 + left_hip_block_l2 * t_base_px_9;
  const Scalar t_base_px_18 = t_base_px_17 - s_left_hip_yaw * t_left_hip_block_125;
  const Scalar t_base_px_19 = t_base_px_18 - s_right_hip_yaw * t_right_hip_block_179;
  const Scalar t_base_px_20 = t_base_px_19 - base_rx_I17 * t_base_rx_23;
  const Scalar t_base_px_21 = inverse_pivot_base_rz * t_base_px_20;
  const Scalar t_base_rx_9 = w[36];
  const Scalar t_base_rx_18 = w[44];
  const Scalar t_base_px_22 = t_base_px_9 - t_base_rx_9 * tau[1] - tau[0] * t_base_rx_18;
  const Scalar s_base_ry = w[0];
  const Scalar t_base_px_23 = t_base_px_22 + s_base_ry * tau[2] + base_rx_h7 * t_base_rx_23;
  const Scalar t_base_px_24 = t_base_px_23 - t_base_ry_5 * t_base_px_8;
  const Scalar t_base_px_25 = t_base_px_24 + t_left_hip_block_179 * t_base_rx_31;
  const Scalar t_base_px_26 = t_base_px_25 - base_rx_h2 * t_base_rx_43;
  const Scalar t_base_px_27 = t_base_px_26 + t_base_rz_2 * t_base_px_20;
  const Scalar t_base_px_28 = t_left_hip_block_159 + t_right_hip_block_193;
  const Scalar t_base_rx_10 = w[37];
  const Scalar t_base_px_29 = t_base_px_28 + tau[2] * t_base_rx_10;
  const Scalar t_base_px_30 = t_base_px_29 - base_rx_h2 * t_base_rx_23;
  const Scalar t_base_px_31 = t_base_px_30 - t_base_pz_1 * t_base_px_27;
  const Scalar t_base_px_32 = t_base_px_31 - t_base_ry_4 * t_base_px_8;
  const Scalar t_base_px_33 = t_base_px_32 - t_left_hip_block_179 * t_base_rx_29;
  const Scalar t_base_px_34 = t_base_px_33 + base_rx_h7 * t_base_rx_21;
  const Scalar t_base_px_35 = t_base_px_34 - t_base_rz_6 * t_base_px_20;
  const Scalar t_base_rx_3 = w[31];
  const Scalar t_base_rx_6 = w[33];
  const Scalar t_base_px_36 = t_base_px_35 + t_base_rx_3 * tau[0] + t_base_rx_6 * tau[1];
  const Scalar t_base_rx_11 = w[38];
  const Scalar t_base_px_37 = t_left_hip_block_165 + tau[2] * t_base_rx_11;
  const Scalar t_base_px_38 = t_base_px_37 - base_rx_h7 * t_base_rx_22;
  const Scalar t_base_px_39 = t_base_px_38 - base_rx_h2 * t_base_rx_25;
  const Scalar t_base_px_40 = t_base_px_39 - t_base_py_1 * t_base_px_36;
  const Scalar t_base_px_41 = t_base_px_40 + t_base_pz_5 * t_base_px_27;
  const Scalar t_base_px_42 = t_base_px_41 + t_base_ry_12 * t_base_px_8;
  const Scalar t_base_px_43 = t_base_px_42 - t_left_hip_block_179 * t_base_rx_40;
  const Scalar t_base_rx_5 = w[32];
  const Scalar t_base_rx_7 = w[34];
  const Scalar t_base_px_44 = t_base_px_43 - t_base_rx_5 * tau[0] + t_base_rx_7 * tau[1];
  const Scalar t_base_px_45 = t_base_px_44 + t_base_ry_3 * t_base_px_21;
  const Scalar t_base_px_46 = inverse_pivot_base_px * t_base_px_45;
  w[58] = t_base_px_46;
  const Scalar t_base_px_47 = t_base_px_36 - t_base_pz_9 * t_base_px_46;
  const Scalar t_base_px_48 = inverse_pivot_base_py * t_base_px_47;
  w[59] = t_base_px_48;
  const Scalar t_base_px_49 = t_base_px_27 + t_base_rz_9 * t_base_px_46;
  const Scalar t_base_px_50 = t_base_px_49 - t_base_rz_5 * t_base_px_48;
  const Scalar t_base_px_51 = inverse_pivot_base_pz * t_base_px_50;
  w[60] = t_base_px_51;
  const Scalar t_base_px_52 = t_base_px_21 - t_base_rz_6 * t_base_px_48;
  const Scalar t_base_px_53 = t_base_px_52 + t_base_rz_1 * t_base_px_46;
  const Scalar t_base_px_54 = t_base_px_53 + t_base_rz_2 * t_base_px_51;
  w[61] = t_base_px_54;
  const Scalar t_base_px_55 = t_base_px_8 + t_base_rx_33 * t_base_px_46;
  const Scalar t_base_px_56 = t_base_px_55 - t_base_rx_30 * t_base_px_48;
  const Scalar t_base_px_57 = t_base_px_56 - t_base_rx_32 * t_base_px_51;
  const Scalar t_base_px_58 = inverse_pivot_base_ry * t_base_px_57;
  const Scalar t_base_px_59 = t_base_px_58 - t_base_ry_1 * t_base_px_54;
  w[62] = t_base_px_59;
  const Scalar t_base_px_60 = t_left_hip_block_179 + t_left_hip_block_256 * t_base_px_46;
  const Scalar t_base_px_61 = t_base_px_60 - t_left_hip_block_267 * t_base_px_51;
  const Scalar t_base_px_62 = t_base_px_61 + t_left_hip_block_268 * t_base_px_48;
  const Scalar t_base_px_63 = t_base_rx_28 * t_base_px_59 - t_base_rx_27 * t_base_px_62;
  const Scalar t_base_px_64 = t_base_px_63 + t_base_rx_34 * t_base_px_54;
  w[63] = t_base_px_64;
  // left_hip_block
  const Scalar t_left_hip_block_296 = t_base_px_46 + left_hip_block_l2 * t_base_px_64;
  w[64] = t_left_hip_block_296;
  const Scalar t_left_hip_block_297 = left_hip_block_l1 * t_base_px_59;
  w[70] = t_left_hip_block_297;
  const Scalar t_left_hip_block_298 = t_base_px_51 + left_hip_block_l2 * t_base_px_54;
  w[71] = t_left_hip_block_298;
  const Scalar t_left_hip_block_299 = t_left_hip_block_297 - t_left_hip_block_298;
  const Scalar t_left_hip_block_300 = left_hip_block_l1 * t_base_px_64;
  w[72] = t_left_hip_block_300;
  const Scalar t_left_hip_block_16 = w[56];
  const Scalar t_left_hip_block_301 = t_left_hip_block_16 - c_left_hip_yaw * t_base_px_54;
  const Scalar t_left_hip_block_302 = t_left_hip_block_301 + s_left_hip_yaw * t_base_px_64;
  const Scalar t_left_hip_block_18 = w[57];
  const Scalar t_left_hip_block_303 = t_left_hip_block_18 + c_left_hip_yaw * t_base_px_64;
  const Scalar t_left_hip_block_304 = t_left_hip_block_303 + s_left_hip_yaw * t_base_px_54;
  const Scalar t_left_hip_block_305 = c_left_hip_yaw * t_left_hip_block_299;
  const Scalar zeta_left_hip_block_y = w[54];
  const Scalar t_left_hip_block_306 = zeta_left_hip_block_y - t_left_hip_block_305;
  const Scalar t_left_hip_block_307 = s_left_hip_yaw * t_left_hip_block_296;
  const Scalar t_left_hip_block_308 = t_left_hip_block_306 - t_left_hip_block_307;
  const Scalar t_left_hip_block_309 = c_left_hip_yaw * t_left_hip_block_296;
  const Scalar t_left_hip_block_9 = w[53];
  const Scalar t_left_hip_block_310 = t_left_hip_block_9 - t_left_hip_block_309;
  const Scalar t_left_hip_block_311 = s_left_hip_yaw * t_left_hip_block_299;
  const Scalar t_left_hip_block_312 = t_left_hip_block_310 + t_left_hip_block_311;
  const Scalar zeta_left_hip_block_z = w[55];
  const Scalar t_left_hip_block_313 = zeta_left_hip_block_z + t_base_px_48;
  const Scalar t_left_hip_block_314 = t_left_hip_block_300 + t_left_hip_block_313;
  const Scalar t_left_hip_block_315 = left_hip_block_I18 * t_left_hip_block_304;
  const Scalar t_left_hip_fork_160 = w[95];
  const Scalar t_left_hip_block_316 = t_left_hip_fork_160 * t_base_px_59;
  const Scalar t_left_hip_block_317 = t_left_hip_block_316 + t_left_hip_block_315;
  const Scalar t_left_hip_fork_146 = w[94];
  const Scalar t_left_hip_block_318 = t_left_hip_fork_146 * t_left_hip_block_314;
  const Scalar t_left_hip_block_45 = w[102];
  const Scalar t_left_hip_block_319 = t_left_hip_block_45 * t_left_hip_block_302;
  const Scalar t_left_hip_block_49 = w[105];
  const Scalar t_left_hip_block_320 = t_left_hip_block_49 - t_left_hip_block_319;
  const Scalar t_left_hip_block_36 = w[97];
  const Scalar t_left_hip_block_321 = t_left_hip_block_36 * t_left_hip_block_312;
  const Scalar t_left_hip_block_322 = t_left_hip_block_320 + t_left_hip_block_321;
  const Scalar t_left_hip_block_37 = w[98];
  const Scalar t_left_hip_block_323 = t_left_hip_block_37 * t_left_hip_block_308;
  const Scalar t_left_hip_block_324 = t_left_hip_block_317 - t_left_hip_block_318;
  const Scalar t_left_hip_block_325 = t_left_hip_block_322 - t_left_hip_block_323;
  const Scalar t_left_hip_block_35 = w[96];
  const Scalar t_left_hip_block_326 = t_left_hip_block_35 * t_left_hip_block_324;
  const Scalar t_left_hip_block_327 = t_left_hip_block_325 - t_left_hip_block_326;
  qdd[6] = -t_left_hip_block_327;
  const Scalar t_left_hip_block_328 = t_base_px_59 + t_left_hip_block_327;
  // left_hip_fork
  const Scalar t_left_hip_fork_216 = left_hip_fork_l1 * t_left_hip_block_328;
  const Scalar t_left_hip_fork_217 = t_left_hip_block_312 + t_left_hip_fork_216;
  const Scalar t_left_hip_fork_218 = left_hip_fork_l1 * t_left_hip_block_302;
  const Scalar t_left_hip_fork_219 = t_left_hip_block_314 + t_left_hip_fork_218;
  const Scalar t_left_hip_fork_14 = w[66];
  const Scalar c_left_hip_roll = w[6];
  const Scalar t_left_hip_fork_220 = t_left_hip_fork_14 - c_left_hip_roll * t_left_hip_fork_219;
  const Scalar s_left_hip_roll = w[5];
  const Scalar t_left_hip_fork_221 = t_left_hip_fork_220 - s_left_hip_roll * t_left_hip_fork_217;
  const Scalar t_left_hip_fork_12 = w[65];
  const Scalar t_left_hip_fork_222 = t_left_hip_fork_12 + s_left_hip_roll * t_left_hip_fork_219;
  const Scalar t_left_hip_fork_223 = t_left_hip_fork_222 - c_left_hip_roll * t_left_hip_fork_217;
  const Scalar t_left_hip_fork_15 = w[67];
  const Scalar t_left_hip_fork_224 = t_left_hip_fork_15 + t_left_hip_block_308;
  const Scalar t_left_hip_fork_225 = s_left_hip_roll * t_left_hip_block_302;
  const Scalar t_left_hip_fork_17 = w[69];
  const Scalar t_left_hip_fork_226 = t_left_hip_fork_17 - t_left_hip_fork_225;
  const Scalar t_left_hip_fork_227 = c_left_hip_roll * t_left_hip_block_328;
  const Scalar t_left_hip_fork_228 = t_left_hip_fork_226 + t_left_hip_fork_227;
  const Scalar t_left_hip_fork_229 = c_left_hip_roll * t_left_hip_block_302;
  const Scalar t_left_hip_fork_16 = w[68];
  const Scalar t_left_hip_fork_230 = t_left_hip_fork_16 - t_left_hip_fork_229;
  const Scalar t_left_hip_fork_231 = s_left_hip_roll * t_left_hip_block_328;
  const Scalar t_left_hip_fork_232 = t_left_hip_fork_230 - t_left_hip_fork_231;
  const Scalar u_left_hip_fork = w[84];
  const Scalar t_left_hip_fork_233 = u_left_hip_fork + left_hip_fork_I14 * t_left_hip_fork_232;
  const Scalar t_left_thigh_124 = w[78];
  const Scalar t_left_hip_fork_234 = t_left_thigh_124 * t_left_hip_block_304;
  const Scalar t_left_hip_fork_235 = t_left_hip_fork_233 - t_left_hip_fork_234;
  const Scalar t_left_thigh_139 = w[82];
  const Scalar t_left_hip_fork_236 = t_left_thigh_139 * t_left_hip_fork_224;
  const Scalar t_left_hip_fork_237 = t_left_hip_fork_235 - t_left_hip_fork_236;
  const Scalar t_left_thigh_126 = w[79];
  const Scalar t_left_hip_fork_238 = t_left_thigh_126 * t_left_hip_fork_228;
  const Scalar t_left_hip_fork_239 = t_left_hip_fork_237 + t_left_hip_fork_238;
  const Scalar t_left_thigh_131 = w[80];
  const Scalar t_left_hip_fork_240 = t_left_thigh_131 * t_left_hip_fork_221;
  const Scalar t_left_hip_fork_241 = t_left_hip_fork_239 + t_left_hip_fork_240;
  const Scalar t_left_thigh_141 = w[83];
  const Scalar t_left_hip_fork_242 = t_left_thigh_141 * t_left_hip_fork_223;
  const Scalar t_left_hip_fork_243 = t_left_hip_fork_241 - t_left_hip_fork_242;
  const Scalar t_left_hip_fork_31 = w[86];
  const Scalar t_left_hip_fork_244 = t_left_hip_fork_31 * t_left_hip_fork_243;
  qdd[7] = t_left_hip_fork_244;
  const Scalar t_left_hip_fork_245 = t_left_hip_block_304 + t_left_hip_fork_244;
  // left_thigh
  const Scalar t_left_thigh_3 = w[75];
  const Scalar c_q8_q9_q10 = w[8];
  const Scalar t_left_thigh_153 = t_left_thigh_3 - c_q8_q9_q10 * t_left_hip_fork_245;
  const Scalar s_q8_q9_q10 = w[7];
  const Scalar t_left_thigh_154 = t_left_thigh_153 - s_q8_q9_q10 * t_left_hip_fork_228;
  const Scalar t_left_thigh_5 = w[76];
  const Scalar t_left_thigh_155 = t_left_thigh_5 + c_q8_q9_q10 * t_left_hip_fork_228;
  const Scalar t_left_thigh_156 = t_left_thigh_155 - s_q8_q9_q10 * t_left_hip_fork_245;
  const Scalar t_left_thigh_157 = c_q8_q9_q10 * t_left_hip_fork_221;
  const Scalar t_left_thigh_158 = t_left_thigh_157 + s_q8_q9_q10 * t_left_hip_fork_224;
  const Scalar t_left_thigh_159 = c_q8_q9_q10 * t_left_hip_fork_224;
  const Scalar t_left_thigh_160 = t_left_thigh_159 - s_q8_q9_q10 * t_left_hip_fork_221;
  const Scalar t_left_thigh_29 = w[249];
  const Scalar t_left_shank_112 = w[247];
  const Scalar t_left_thigh_161 = t_left_thigh_29 - t_left_shank_112 * t_left_thigh_158;
  const Scalar t_left_shank_99 = w[190];
  const Scalar t_left_thigh_162 = t_left_thigh_161 + t_left_shank_99 * t_left_thigh_154;
  const Scalar t_left_shank_105 = w[191];
  const Scalar t_left_thigh_163 = t_left_thigh_162 + t_left_shank_105 * t_left_hip_fork_232;
  const Scalar t_left_shank_111 = w[246];
  const Scalar t_left_thigh_164 = t_left_thigh_163 + t_left_shank_111 * t_left_thigh_160;
  const Scalar inverse_pivot_left_thigh = w[250];
  const Scalar t_left_thigh_165 = inverse_pivot_left_thigh * t_left_thigh_164;
  const Scalar t_left_thigh_32 = w[253];
  const Scalar t_left_thigh_166 = t_left_thigh_32 * t_left_thigh_156 - t_left_thigh_165;
  const Scalar t_left_thigh_117 = w[77];
  const Scalar t_left_thigh_167 = t_left_thigh_166 + t_left_thigh_117 * t_left_hip_fork_223;
  qdd[8] = t_left_thigh_167;
  const Scalar t_left_thigh_168 = t_left_hip_fork_232 + t_left_thigh_167;
  // left_shank
  const Scalar t_left_shank_7 = w[92];
  const Scalar t_left_shank_130 = t_left_shank_7 + t_left_thigh_156;
  const Scalar t_left_shank_8 = w[93];
  const Scalar t_left_shank_131 = t_left_shank_8 + t_left_thigh_154;
  const Scalar zeta_left_shank_x = w[90];
  const Scalar t_left_shank_132 = zeta_left_shank_x + t_left_thigh_158;
  const Scalar t_left_shank_1 = w[10];
  const Scalar t_left_shank_133 = t_left_shank_132 + t_left_shank_1 * t_left_thigh_168;
  const Scalar t_left_shank_3 = w[89];
  const Scalar t_left_shank_134 = t_left_shank_3 - t_left_thigh_160;
  const Scalar s_left_shank_x = w[9];
  const Scalar t_left_shank_135 = t_left_shank_134 - s_left_shank_x * t_left_thigh_168;
  const Scalar t_left_shank_6 = w[91];
  const Scalar t_left_shank_136 = t_left_shank_6 - t_left_hip_fork_223;
  const Scalar t_left_shank_137 = t_left_shank_136 + t_left_shank_1 * t_left_thigh_156;
  const Scalar t_left_shank_138 = t_left_shank_137 + s_left_shank_x * t_left_thigh_154;
  const Scalar t_left_shank_33 = w[168];
  const Scalar t_left_ankle_cross_119 = w[166];
  const Scalar t_left_shank_139 = t_left_shank_33 - t_left_ankle_cross_119 * t_left_shank_135;
  const Scalar t_left_ankle_cross_101 = w[146];
  const Scalar t_left_shank_140 = t_left_shank_139 - t_left_ankle_cross_101 * t_left_thigh_168;
  const Scalar t_left_ankle_cross_109 = w[163];
  const Scalar t_left_shank_141 = t_left_shank_140 - t_left_ankle_cross_109 * t_left_shank_130;
  const Scalar t_left_ankle_cross_118 = w[165];
  const Scalar t_left_shank_142 = t_left_shank_141 - t_left_ankle_cross_118 * t_left_shank_133;
  const Scalar t_left_ankle_cross_120 = w[167];
  const Scalar t_left_shank_143 = t_left_shank_142 - t_left_ankle_cross_120 * t_left_shank_138;
  const Scalar t_left_ankle_cross_117 = w[164];
  const Scalar t_left_shank_144 = t_left_shank_143 - t_left_ankle_cross_117 * t_left_shank_131;
  const Scalar t_left_shank_34 = w[169];
  const Scalar t_left_shank_145 = t_left_shank_34 * t_left_shank_144;
  qdd[9] = t_left_shank_145;
  const Scalar t_left_shank_146 = t_left_thigh_168 + t_left_shank_145;
  w[73] = t_left_shank_146;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_11 = w[110];
  const Scalar t_left_ankle_cross_165 = t_left_ankle_cross_11 + t_left_shank_131;
  w[74] = t_left_ankle_cross_165;
  const Scalar t_left_ankle_cross_10 = w[109];
  const Scalar t_left_ankle_cross_166 = t_left_ankle_cross_10 + t_left_shank_130;
  w[81] = t_left_ankle_cross_166;
  const Scalar zeta_left_ankle_cross_x = w[106];
  const Scalar t_left_ankle_cross_167 = zeta_left_ankle_cross_x + t_left_shank_133;
  const Scalar t_left_ankle_cross_1 = w[12];
  const Scalar t_left_ankle_cross_168 = t_left_ankle_cross_1 * t_left_shank_146;
  const Scalar t_left_ankle_cross_169 = t_left_ankle_cross_167 + t_left_ankle_cross_168;
  w[85] = t_left_ankle_cross_169;
  const Scalar t_left_ankle_cross_9 = w[108];
  const Scalar t_left_ankle_cross_170 = t_left_ankle_cross_9 + t_left_shank_138;
  const Scalar t_left_ankle_cross_171 = t_left_ankle_cross_1 * t_left_shank_130;
  const Scalar t_left_ankle_cross_172 = t_left_ankle_cross_170 + t_left_ankle_cross_171;
  const Scalar s_left_ankle_cross_x = w[11];
  const Scalar t_left_ankle_cross_173 = s_left_ankle_cross_x * t_left_shank_131;
  const Scalar t_left_ankle_cross_174 = t_left_ankle_cross_172 + t_left_ankle_cross_173;
  w[87] = t_left_ankle_cross_174;
  const Scalar t_left_ankle_cross_6 = w[107];
  const Scalar t_left_ankle_cross_175 = t_left_ankle_cross_6 + t_left_shank_135;
  w[88] = t_left_ankle_cross_175;
  const Scalar t_left_ankle_cross_176 = s_left_ankle_cross_x * t_left_shank_146;
  w[129] = t_left_ankle_cross_176;
  const Scalar u_left_ankle_cross = w[132];
  const Scalar t_left_foot_66 = w[121];
  const Scalar t_left_ankle_cross_177 = u_left_ankle_cross - t_left_foot_66 * t_left_shank_146;
  const Scalar t_left_foot_56 = w[116];
  const Scalar t_left_ankle_cross_178 = t_left_foot_56 * t_left_ankle_cross_174;
  const Scalar t_left_ankle_cross_179 = t_left_ankle_cross_177 + t_left_ankle_cross_178;
  w[130] = t_left_ankle_cross_179;
}

[[gnu::noinline]] void forward_dynamics_9(const Scalar qd[18], Scalar qdd[18],
                                          Scalar w[278]) noexcept {
  // left_ankle_cross
  const Scalar t_left_foot_59 = w[119];
  const Scalar t_left_ankle_cross_165 = w[74];
  const Scalar t_left_ankle_cross_180 = t_left_foot_59 * t_left_ankle_cross_165;
  const Scalar t_left_ankle_cross_179 = w[130];
  const Scalar t_left_ankle_cross_181 = t_left_ankle_cross_179 - t_left_ankle_cross_180;
  const Scalar t_left_foot_63 = w[120];
  const Scalar t_left_ankle_cross_166 = w[81];
  const Scalar t_left_ankle_cross_182 = t_left_foot_63 * t_left_ankle_cross_166;
  const Scalar t_left_ankle_cross_175 = w[88];
  const Scalar t_left_ankle_cross_176 = w[129];
  const Scalar t_left_ankle_cross_183 = t_left_ankle_cross_175 - t_left_ankle_cross_176;
  const Scalar t_left_ankle_cross_184 = t_left_ankle_cross_181 + t_left_ankle_cross_182;
  const Scalar t_left_foot_68 = w[122];
  const Scalar t_left_ankle_cross_185 = t_left_foot_68 * t_left_ankle_cross_183;
  const Scalar t_left_ankle_cross_186 = t_left_ankle_cross_184 + t_left_ankle_cross_185;
  const Scalar t_left_ankle_cross_28 = w[141];
  const Scalar t_left_ankle_cross_187 = t_left_ankle_cross_28 * t_left_ankle_cross_186;
  const Scalar t_left_ankle_cross_33 = w[143];
  const Scalar t_left_ankle_cross_169 = w[85];
  const Scalar t_left_ankle_cross_188 = t_left_ankle_cross_33 * t_left_ankle_cross_169;
  const Scalar t_left_ankle_cross_189 = t_left_ankle_cross_187 - t_left_ankle_cross_188;
  qdd[10] = t_left_ankle_cross_189;
  const Scalar t_left_shank_146 = w[73];
  const Scalar t_left_ankle_cross_190 = t_left_shank_146 + t_left_ankle_cross_189;
  // left_foot
  const Scalar t_left_foot_77 = left_hip_fork_l3 * t_left_ankle_cross_165;
  const Scalar t_left_foot_78 = left_hip_fork_l1 * t_left_ankle_cross_165;
  const Scalar s_left_foot = w[13];
  const Scalar t_left_foot_79 = s_left_foot * (t_left_ankle_cross_169 + t_left_foot_77);
  const Scalar c_left_foot = w[14];
  const Scalar t_left_ankle_cross_174 = w[87];
  const Scalar t_left_foot_80 = c_left_foot * (t_left_ankle_cross_174 + t_left_foot_78);
  const Scalar t_left_foot_10 = w[118];
  const Scalar t_left_foot_81 = t_left_foot_10 + s_left_foot * t_left_ankle_cross_190;
  const Scalar t_left_foot_8 = w[117];
  const Scalar t_left_foot_82 = t_left_foot_8 + c_left_foot * t_left_ankle_cross_190;
  const Scalar zeta_left_foot_y = w[115];
  const Scalar t_left_foot_83 = zeta_left_foot_y - t_left_foot_79 - t_left_foot_80;
  const Scalar t_left_foot_84 = t_left_foot_81 + c_left_foot * t_left_ankle_cross_166;
  const Scalar t_left_foot_85 = t_left_ankle_cross_165 - left_foot_p2 * t_left_foot_83;
  const Scalar t_left_foot_86 = t_left_foot_82 - s_left_foot * t_left_ankle_cross_166;
  const Scalar t_left_foot_87 = t_left_foot_85 + left_foot_k3 * t_left_foot_84;
  const Scalar u_left_foot = w[240];
  qdd[11] = t_left_foot_87 + left_foot_k2 * t_left_foot_86 + left_foot_p1 * u_left_foot;
  // right_hip_block
  const Scalar t_left_hip_block_297 = w[70];
  const Scalar t_left_hip_block_298 = w[71];
  const Scalar t_right_hip_block_217 = t_left_hip_block_297 + t_left_hip_block_298;
  const Scalar s_right_hip_yaw = w[15];
  const Scalar t_left_hip_block_296 = w[64];
  const Scalar t_right_hip_block_218 = s_right_hip_yaw * t_left_hip_block_296;
  const Scalar zeta_right_hip_block_y = w[124];
  const Scalar t_right_hip_block_219 = zeta_right_hip_block_y - t_right_hip_block_218;
  const Scalar c_right_hip_yaw = w[16];
  const Scalar t_right_hip_block_220 = c_right_hip_yaw * t_right_hip_block_217;
  const Scalar t_right_hip_block_221 = t_right_hip_block_219 + t_right_hip_block_220;
  const Scalar t_right_hip_block_222 = c_right_hip_yaw * t_left_hip_block_296;
  const Scalar zeta_right_hip_block_x = w[125];
  const Scalar t_right_hip_block_223 = zeta_right_hip_block_x + t_right_hip_block_222;
  const Scalar t_right_hip_block_224 = s_right_hip_yaw * t_right_hip_block_217;
  const Scalar t_right_hip_block_225 = t_right_hip_block_223 + t_right_hip_block_224;
  const Scalar t_right_hip_block_11 = w[128];
  const Scalar t_base_px_54 = w[61];
  const Scalar t_right_hip_block_226 = t_right_hip_block_11 - c_right_hip_yaw * t_base_px_54;
  const Scalar t_base_px_64 = w[63];
  const Scalar t_right_hip_block_227 = t_right_hip_block_226 + s_right_hip_yaw * t_base_px_64;
  const Scalar t_right_hip_block_8 = w[127];
  const Scalar t_right_hip_block_228 = t_right_hip_block_8 + c_right_hip_yaw * t_base_px_64;
  const Scalar t_right_hip_block_229 = t_right_hip_block_228 + s_right_hip_yaw * t_base_px_54;
  const Scalar zeta_right_hip_block_z = w[126];
  const Scalar t_base_px_48 = w[59];
  const Scalar t_right_hip_block_230 = zeta_right_hip_block_z + t_base_px_48;
  const Scalar t_left_hip_block_300 = w[72];
  const Scalar t_right_hip_block_231 = t_left_hip_block_300 - t_right_hip_block_230;
  const Scalar t_right_hip_block_232 = left_hip_block_I18 * t_right_hip_block_229;
  const Scalar t_right_hip_fork_183 = w[139];
  const Scalar t_right_hip_block_233 = t_right_hip_fork_183 * t_right_hip_block_225;
  const Scalar u_right_hip_block = w[142];
  const Scalar t_right_hip_block_234 = u_right_hip_block - t_right_hip_block_232;
  const Scalar t_right_hip_block_235 = t_right_hip_block_234 - t_right_hip_block_233;
  const Scalar t_right_hip_fork_177 = w[188];
  const Scalar t_right_hip_block_236 = t_right_hip_fork_177 * t_right_hip_block_227;
  const Scalar t_right_hip_block_237 = t_right_hip_block_235 + t_right_hip_block_236;
  const Scalar t_right_hip_fork_164 = w[181];
  const Scalar t_base_px_59 = w[62];
  const Scalar t_right_hip_block_238 = t_right_hip_fork_164 * t_base_px_59;
  const Scalar t_right_hip_block_239 = t_right_hip_block_237 - t_right_hip_block_238;
  const Scalar t_right_hip_fork_191 = w[140];
  const Scalar t_right_hip_block_240 = t_right_hip_fork_191 * t_right_hip_block_221;
  const Scalar t_right_hip_block_241 = t_right_hip_block_239 + t_right_hip_block_240;
  const Scalar t_right_hip_fork_178 = w[189];
  const Scalar t_right_hip_block_242 = t_right_hip_fork_178 * t_right_hip_block_231;
  const Scalar t_right_hip_block_243 = t_right_hip_block_241 + t_right_hip_block_242;
  const Scalar t_right_hip_block_29 = w[150];
  const Scalar t_right_hip_block_244 = t_right_hip_block_29 * t_right_hip_block_243;
  qdd[12] = -t_right_hip_block_244;
  const Scalar t_right_hip_block_245 = t_base_px_59 + t_right_hip_block_244;
  // right_hip_fork
  const Scalar t_right_hip_fork_224 = left_hip_fork_l1 * t_right_hip_block_245;
  const Scalar t_right_hip_fork_225 = t_right_hip_block_225 - t_right_hip_fork_224;
  const Scalar t_right_hip_fork_226 = left_hip_fork_l1 * t_right_hip_block_227;
  const Scalar t_right_hip_fork_227 = t_right_hip_block_231 - t_right_hip_fork_226;
  const Scalar c_right_hip_roll = w[18];
  const Scalar t_right_hip_fork_228 = c_right_hip_roll * t_right_hip_fork_227;
  const Scalar zeta_right_hip_fork_x = w[135];
  const Scalar t_right_hip_fork_229 = zeta_right_hip_fork_x - t_right_hip_fork_228;
  const Scalar s_right_hip_roll = w[17];
  const Scalar t_right_hip_fork_230 = s_right_hip_roll * t_right_hip_fork_225;
  const Scalar t_right_hip_fork_231 = t_right_hip_fork_229 - t_right_hip_fork_230;
  const Scalar t_right_hip_fork_232 = c_right_hip_roll * t_right_hip_fork_225;
  const Scalar t_right_hip_fork_12 = w[134];
  const Scalar t_right_hip_fork_233 = t_right_hip_fork_12 + t_right_hip_fork_232;
  const Scalar t_right_hip_fork_234 = s_right_hip_roll * t_right_hip_fork_227;
  const Scalar t_right_hip_fork_235 = t_right_hip_fork_233 - t_right_hip_fork_234;
  const Scalar t_right_hip_fork_16 = w[137];
  const Scalar t_right_hip_fork_236 = t_right_hip_fork_16 + t_right_hip_block_221;
  const Scalar t_right_hip_fork_237 = s_right_hip_roll * t_right_hip_block_227;
  const Scalar t_right_hip_fork_17 = w[138];
  const Scalar t_right_hip_fork_238 = t_right_hip_fork_17 - t_right_hip_fork_237;
  const Scalar t_right_hip_fork_239 = c_right_hip_roll * t_right_hip_block_245;
  const Scalar t_right_hip_fork_240 = t_right_hip_fork_238 + t_right_hip_fork_239;
  const Scalar t_right_hip_fork_241 = c_right_hip_roll * t_right_hip_block_227;
  const Scalar t_right_hip_fork_15 = w[136];
  const Scalar t_right_hip_fork_242 = t_right_hip_fork_15 - t_right_hip_fork_241;
  const Scalar t_right_hip_fork_243 = s_right_hip_roll * t_right_hip_block_245;
  const Scalar t_right_hip_fork_244 = t_right_hip_fork_242 - t_right_hip_fork_243;
  const Scalar u_right_hip_fork = w[152];
  const Scalar t_right_hip_fork_245 = u_right_hip_fork - left_hip_fork_I14 * t_right_hip_fork_244;
  const Scalar t_right_thigh_138 = w[148];
  const Scalar t_right_hip_fork_246 = t_right_thigh_138 * t_right_hip_block_229;
  const Scalar t_right_hip_fork_247 = t_right_hip_fork_245 - t_right_hip_fork_246;
  const Scalar t_right_thigh_147 = w[149];
  const Scalar t_right_hip_fork_248 = t_right_thigh_147 * t_right_hip_fork_236;
  const Scalar t_right_hip_fork_249 = t_right_hip_fork_247 + t_right_hip_fork_248;
  const Scalar t_right_thigh_137 = w[147];
  const Scalar t_right_hip_fork_250 = t_right_thigh_137 * t_right_hip_fork_240;
  const Scalar t_right_hip_fork_251 = t_right_hip_fork_249 + t_right_hip_fork_250;
  const Scalar t_right_thigh_149 = w[151];
  const Scalar t_right_hip_fork_252 = t_right_thigh_149 * t_right_hip_fork_235;
  const Scalar t_right_hip_fork_253 = t_right_hip_fork_251 - t_right_hip_fork_252;
  const Scalar t_right_hip_fork_32 = w[155];
  const Scalar t_right_hip_fork_254 = t_right_hip_fork_32 * t_right_hip_fork_231;
  const Scalar t_right_hip_fork_31 = w[153];
  const Scalar t_right_hip_fork_255 = t_right_hip_fork_31 * t_right_hip_fork_253;
  const Scalar t_right_hip_fork_256 = t_right_hip_fork_254 + t_right_hip_fork_255;
  qdd[13] = t_right_hip_fork_256;
  const Scalar t_right_hip_fork_257 = t_right_hip_block_229 + t_right_hip_fork_256;
  // right_thigh
  const Scalar t_right_thigh_3 = w[144];
  const Scalar s_q14_q15_q16 = w[19];
  const Scalar t_right_thigh_173 = t_right_thigh_3 - s_q14_q15_q16 * t_right_hip_fork_257;
  const Scalar c_q14_q15_q16 = w[20];
  const Scalar t_right_thigh_174 = t_right_thigh_173 + c_q14_q15_q16 * t_right_hip_fork_240;
  const Scalar t_right_thigh_6 = w[145];
  const Scalar t_right_thigh_175 = t_right_thigh_6 - c_q14_q15_q16 * t_right_hip_fork_257;
  const Scalar t_right_thigh_176 = t_right_thigh_175 - s_q14_q15_q16 * t_right_hip_fork_240;
  const Scalar t_right_thigh_177 = c_q14_q15_q16 * t_right_hip_fork_236;
  const Scalar t_right_thigh_178 = t_right_thigh_177 + s_q14_q15_q16 * t_right_hip_fork_231;
  const Scalar t_right_thigh_179 = c_q14_q15_q16 * t_right_hip_fork_231;
  const Scalar t_right_thigh_180 = t_right_thigh_179 - s_q14_q15_q16 * t_right_hip_fork_236;
  const Scalar t_right_thigh_31 = w[236];
  const Scalar t_right_shank_116 = w[234];
  const Scalar t_right_thigh_181 = t_right_thigh_31 + t_right_shank_116 * t_right_thigh_180;
  const Scalar t_right_shank_103 = w[230];
  const Scalar t_right_thigh_182 = t_right_thigh_181 - t_right_shank_103 * t_right_thigh_176;
  const Scalar t_right_shank_114 = w[232];
  const Scalar t_right_thigh_183 = t_right_thigh_182 - t_right_shank_114 * t_right_hip_fork_244;
  const Scalar t_right_shank_117 = w[235];
  const Scalar t_right_thigh_184 = t_right_thigh_183 + t_right_shank_117 * t_right_hip_fork_235;
  const Scalar t_right_shank_115 = w[233];
  const Scalar t_right_thigh_185 = t_right_thigh_184 + t_right_shank_115 * t_right_thigh_178;
  const Scalar t_right_shank_108 = w[231];
  const Scalar t_right_thigh_186 = t_right_thigh_185 + t_right_shank_108 * t_right_thigh_174;
  const Scalar t_right_thigh_32 = w[237];
  const Scalar t_right_thigh_187 = t_right_thigh_32 * t_right_thigh_186;
  qdd[14] = t_right_thigh_187;
  const Scalar t_right_thigh_188 = t_right_hip_fork_244 + t_right_thigh_187;
  // right_shank
  const Scalar t_right_shank_7 = w[161];
  const Scalar t_right_shank_126 = t_right_shank_7 + t_right_thigh_174;
  const Scalar t_right_shank_8 = w[162];
  const Scalar t_right_shank_127 = t_right_shank_8 + t_right_thigh_176;
  const Scalar zeta_right_shank_x = w[159];
  const Scalar t_right_shank_128 = zeta_right_shank_x - t_right_thigh_180;
  const Scalar t_right_shank_1 = w[24];
  const Scalar t_right_shank_129 = t_right_shank_128 + t_right_shank_1 * t_right_thigh_188;
  const Scalar t_right_shank_6 = w[160];
  const Scalar t_right_shank_130 = t_right_shank_6 - t_right_hip_fork_235;
  const Scalar t_right_shank_131 = t_right_shank_130 + t_right_shank_1 * t_right_thigh_174;
  const Scalar s_right_shank_x = w[23];
  const Scalar t_right_shank_132 = t_right_shank_131 + s_right_shank_x * t_right_thigh_176;
  const Scalar t_right_shank_3 = w[158];
  const Scalar t_right_shank_133 = t_right_shank_3 - t_right_thigh_178;
  const Scalar t_right_shank_134 = t_right_shank_133 - s_right_shank_x * t_right_thigh_188;
  const Scalar t_right_shank_34 = w[220];
  const Scalar t_righ_ankl_cros_107 = w[26];
  const Scalar t_right_shank_135 = t_right_shank_34 + t_righ_ankl_cros_107 * t_right_shank_126;
  const Scalar t_righ_ankl_cros_117 = w[45];
  const Scalar t_right_shank_136 = t_right_shank_135 + t_righ_ankl_cros_117 * t_right_thigh_188;
  const Scalar t_righ_ankl_cros_118 = w[217];
  const Scalar t_right_shank_137 = t_right_shank_136 - t_righ_ankl_cros_118 * t_right_shank_129;
  const Scalar t_righ_ankl_cros_120 = w[219];
  const Scalar t_right_shank_138 = t_right_shank_137 - t_righ_ankl_cros_120 * t_right_shank_132;
  const Scalar t_righ_ankl_cros_119 = w[218];
  const Scalar t_right_shank_139 = t_right_shank_138 - t_righ_ankl_cros_119 * t_right_shank_134;
  const Scalar t_righ_ankl_cros_99 = w[25];
  const Scalar t_right_shank_140 = t_right_shank_139 - t_righ_ankl_cros_99 * t_right_shank_127;
  const Scalar t_right_shank_35 = w[221];
  const Scalar t_right_shank_141 = t_right_shank_35 * t_right_shank_140;
  qdd[15] = -t_right_shank_141;
  const Scalar t_right_shank_142 = t_right_thigh_188 - t_right_shank_141;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_11 = w[178];
  const Scalar t_righ_ankl_cros_159 = t_righ_ankl_cros_11 + t_right_shank_126;
  const Scalar t_righ_ankl_cros_12 = w[179];
  const Scalar t_righ_ankl_cros_160 = t_righ_ankl_cros_12 + t_right_shank_127;
  const Scalar t_righ_ankl_cros_7 = w[176];
  const Scalar t_righ_ankl_cros_161 = t_righ_ankl_cros_7 - t_right_shank_129;
  const Scalar t_righ_ankl_cros_1 = w[27];
  const Scalar t_righ_ankl_cros_162 = t_righ_ankl_cros_1 * t_right_shank_142;
  const Scalar t_righ_ankl_cros_163 = t_righ_ankl_cros_161 - t_righ_ankl_cros_162;
  const Scalar t_righ_ankl_cros_10 = w[177];
  const Scalar t_righ_ankl_cros_164 = t_righ_ankl_cros_10 + t_right_shank_132;
  const Scalar t_righ_ankl_cros_165 = t_righ_ankl_cros_1 * t_right_shank_126;
  const Scalar t_righ_ankl_cros_166 = t_righ_ankl_cros_164 + t_righ_ankl_cros_165;
  const Scalar s_righ_ankl_cros_x = w[28];
  const Scalar t_righ_ankl_cros_167 = s_righ_ankl_cros_x * t_right_shank_127;
  const Scalar t_righ_ankl_cros_168 = t_righ_ankl_cros_166 + t_righ_ankl_cros_167;
  const Scalar t_right_foot_68 = w[203];
  const Scalar t_righ_ankl_cros_169 = t_right_foot_68 * t_right_shank_142;
  const Scalar t_righ_ankl_cros_69 = w[22];
  const Scalar t_righ_ankl_cros_170 = t_righ_ankl_cros_69 - t_righ_ankl_cros_169;
  const Scalar t_right_foot_58 = w[198];
  const Scalar t_righ_ankl_cros_171 = t_right_foot_58 * t_righ_ankl_cros_168;
  const Scalar t_righ_ankl_cros_172 = t_righ_ankl_cros_170 - t_righ_ankl_cros_171;
  const Scalar t_right_foot_66 = w[202];
  const Scalar t_righ_ankl_cros_173 = t_right_foot_66 * t_righ_ankl_cros_159;
  const Scalar t_righ_ankl_cros_174 = t_right_shank_134 - s_righ_ankl_cros_x * t_right_shank_142;
  const Scalar t_righ_ankl_cros_175 = t_righ_ankl_cros_172 - t_righ_ankl_cros_173;
  const Scalar t_right_foot_70 = w[205];
  const Scalar t_righ_ankl_cros_176 = t_right_foot_70 * t_righ_ankl_cros_174;
  const Scalar t_righ_ankl_cros_177 = t_righ_ankl_cros_175 + t_righ_ankl_cros_176;
  const Scalar t_righ_ankl_cros_49 = w[21];
  const Scalar t_righ_ankl_cros_178 = t_righ_ankl_cros_49 * t_righ_ankl_cros_160;
  const Scalar t_righ_ankl_cros_28 = w[208];
  const Scalar t_righ_ankl_cros_179 = t_righ_ankl_cros_28 * t_righ_ankl_cros_177;
  const Scalar t_righ_ankl_cros_180 = t_righ_ankl_cros_178 + t_righ_ankl_cros_179;
  const Scalar t_righ_ankl_cros_32 = w[212];
  const Scalar t_righ_ankl_cros_181 = t_righ_ankl_cros_32 * t_righ_ankl_cros_163;
  const Scalar t_righ_ankl_cros_182 = t_righ_ankl_cros_180 + t_righ_ankl_cros_181;
  qdd[16] = t_righ_ankl_cros_182;
  const Scalar t_righ_ankl_cros_183 = t_right_shank_142 + t_righ_ankl_cros_182;
  // right_foot
  const Scalar t_right_foot_9 = w[185];
  const Scalar c_right_foot = w[30];
  const Scalar t_right_foot_85 = t_right_foot_9 + c_right_foot * t_righ_ankl_cros_183;
  const Scalar t_right_foot_86 = t_righ_ankl_cros_163 + left_hip_fork_l3 * t_righ_ankl_cros_160;
  const Scalar t_right_foot_87 = t_righ_ankl_cros_168 + left_hip_fork_l1 * t_righ_ankl_cros_160;
  const Scalar zeta_right_foot_y = w[184];
  const Scalar s_right_foot = w[29];
  const Scalar t_right_foot_88 = zeta_right_foot_y - s_right_foot * t_right_foot_86;
  const Scalar t_right_foot_11 = w[186];
  const Scalar t_right_foot_89 = t_right_foot_11 - s_right_foot * t_righ_ankl_cros_183;
  const Scalar t_right_foot_90 = t_right_foot_85 + s_right_foot * t_righ_ankl_cros_159;
  const Scalar t_right_foot_91 = t_righ_ankl_cros_160 - left_foot_k2 * t_right_foot_90;
  const Scalar t_right_foot_92 = t_right_foot_88 - c_right_foot * t_right_foot_87;
  const Scalar u_right_foot = w[187];
  const Scalar t_right_foot_93 = t_right_foot_91 + left_foot_p1 * u_right_foot;
  const Scalar t_right_foot_94 = t_right_foot_89 + c_right_foot * t_righ_ankl_cros_159;
  const Scalar t_right_foot_95 = t_right_foot_93 - left_foot_p2 * t_right_foot_92;
  qdd[17] = t_right_foot_95 + left_foot_k3 * t_right_foot_94;
  // base_rx
  const Scalar c_base_rx = w[2];
  const Scalar t_base_rx_15 = w[41];
  const Scalar t_base_rx_45 = t_base_px_59 - c_base_rx * t_base_rx_15;
  const Scalar t_base_rx_13 = w[40];
  const Scalar t_base_rx_46 = t_base_rx_45 - t_base_rx_13 * qd[5];
  const Scalar s_base_rx = w[1];
  const Scalar t_base_rx_47 = t_base_px_54 + s_base_rx * t_base_rx_15;
  const Scalar t_base_rx_16 = w[42];
  const Scalar t_base_rx_48 = t_base_rx_47 - qd[5] * t_base_rx_16;
  const Scalar t_base_rx_49 = s_base_rx * t_base_rx_48 - c_base_rx * t_base_rx_46;
  const Scalar t_base_rx_8 = w[35];
  const Scalar t_base_rx_50 = t_base_rx_8 * t_base_rx_49;
  qdd[3] = t_base_rx_50;
  const Scalar t_base_rx_12 = w[39];
  const Scalar s_base_ry = w[0];
  qdd[5] = t_base_px_64 + t_base_rx_12 * qd[4] + s_base_ry * t_base_rx_50;
  qdd[4] = c_base_rx * t_base_rx_48 + s_base_rx * t_base_rx_46;
  const Scalar t_base_rx_11 = w[38];
  const Scalar t_base_px_46 = w[58];
  const Scalar t_base_rx_51 = base_g1 - t_base_rx_11 * t_base_px_46;
  const Scalar t_base_px_51 = w[60];
  const Scalar t_base_rx_10 = w[37];
  qdd[2] = t_base_rx_10 * t_base_px_48 - (t_base_rx_51 - s_base_ry * t_base_px_51);
  const Scalar t_base_rx_9 = w[36];
  const Scalar t_base_rx_7 = w[34];
  const Scalar t_base_rx_52 = t_base_rx_9 * t_base_px_51 - t_base_rx_7 * t_base_px_46;
  const Scalar t_base_rx_6 = w[33];
  qdd[1] = t_base_rx_6 * t_base_px_48 - t_base_rx_52;
  const Scalar t_base_rx_5 = w[32];
  const Scalar t_base_rx_18 = w[44];
  const Scalar t_base_rx_53 = t_base_rx_5 * t_base_px_46 + t_base_rx_18 * t_base_px_51;
  const Scalar t_base_rx_3 = w[31];
  qdd[0] = t_base_rx_3 * t_base_px_48 - t_base_rx_53;
}

}  // namespace

void forward_dynamics(const Scalar q[18], const Scalar qd[18], const Scalar tau[18],
                      Scalar qdd[18]) noexcept {
  Scalar w[278];
  forward_dynamics_1(q, qd, tau, w);
  forward_dynamics_2(qd, tau, w);
  forward_dynamics_3(tau, w);
  forward_dynamics_4(tau, w);
  forward_dynamics_5(tau, w);
  forward_dynamics_6(tau, w);
  forward_dynamics_7(tau, w);
  forward_dynamics_8(tau, qdd, w);
  forward_dynamics_9(qd, qdd, w);
}

void point_positions(const Scalar q[18], Scalar p[12]) noexcept {
  const auto [s_base_rz, c_base_rz] = sine_cosine(q[3]);
  const auto [s_base_ry, c_base_ry] = sine_cosine(q[4]);
  const auto [s_base_rx, c_base_rx] = sine_cosine(q[5]);
  const auto [s_left_hip_yaw, c_left_hip_yaw] = sine_cosine(q[6]);
  const auto [s_left_hip_roll, c_left_hip_roll] = sine_cosine(q[7]);
  const auto [s_left_hip_pitch, c_left_hip_pitch] = sine_cosine(q[8]);
  // left_ankle_cross
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const auto [s_q8_q9_q10, c_q8_q9_q10] = sine_cosine(q_q8_q9_q10);
  const auto [s_q8_q9, c_q8_q9] = sine_cosine(q_q8_q9);
  const auto [s_left_ankle_roll, c_left_ankle_roll] = sine_cosine(q[11]);
  const auto [s_right_hip_yaw, c_right_hip_yaw] = sine_cosine(q[12]);
  const auto [s_right_hip_roll, c_right_hip_roll] = sine_cosine(q[13]);
  const auto [s_right_hip_pitch, c_right_hip_pitch] = sine_cosine(q[14]);
  // right_ankle_cross
  const Scalar q_q14_q15 = q[14] + q[15];
  const Scalar q_q14_q15_q16 = q_q14_q15 + q[16];
  const auto [s_q14_q15_q16, c_q14_q15_q16] = sine_cosine(q_q14_q15_q16);
  const auto [s_q14_q15, c_q14_q15] = sine_cosine(q_q14_q15);
  const auto [s_right_ankle_roll, c_right_ankle_roll] = sine_cosine(q[17]);
  const Scalar t_left_thigh_1 = left_hip_fork_l3 + left_foot_l1 * s_left_ankle_roll;
  const Scalar t_left_hip_fork_1 = c_left_hip_roll * t_left_thigh_1;
  const Scalar t_left_foot_1 = left_hip_fork_l1 + left_foot_l1 * c_left_ankle_roll;
  // left_hip_fork
  const Scalar t_left_hip_fork_2 = left_hip_fork_l1 - left_shank_l1 * s_left_hip_pitch;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 - left_ankle_cross_l1 * s_q8_q9;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 - s_q8_q9_q10 * t_left_foot_1;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_4 - left_foot_l2 * c_q8_q9_q10;
  // left_shank
  const Scalar t_left_shank_1 = left_shank_l1 * c_left_hip_pitch + left_ankle_cross_l1 * c_q8_q9;
  const Scalar t_left_shank_2 = t_left_shank_1 + c_q8_q9_q10 * t_left_foot_1;
  const Scalar t_left_shank_3 = t_left_shank_2 - left_foot_l2 * s_q8_q9_q10;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_1 + s_left_hip_roll * t_left_shank_3;
  // left_hip_block
  const Scalar t_left_hip_block_1 = left_hip_block_l1 + s_left_hip_yaw * t_left_hip_fork_5;
  const Scalar t_left_hip_block_2 = t_left_hip_block_1 + c_left_hip_yaw * t_left_hip_fork_6;
  const Scalar t_left_hip_block_3 = left_hip_block_l2 - s_left_hip_roll * t_left_thigh_1;
  const Scalar t_left_hip_block_4 = t_left_hip_block_3 + c_left_hip_roll * t_left_shank_3;
  const Scalar t_base_rx_1 = s_base_rx * t_left_hip_block_2 - c_base_rx * t_left_hip_block_4;
  const Scalar t_left_hip_block_5 = c_left_hip_yaw * t_left_hip_fork_5;
  const Scalar t_left_hip_block_6 = t_left_hip_block_5 - s_left_hip_yaw * t_left_hip_fork_6;
  p[2] = q[2] + c_base_ry * t_base_rx_1 - s_base_ry * t_left_hip_block_6;
  const Scalar t_base_ry_1 = c_base_ry * t_left_hip_block_6 + s_base_ry * t_base_rx_1;
  const Scalar t_base_rx_2 = s_base_rx * t_left_hip_block_4 + c_base_rx * t_left_hip_block_2;
  p[1] = q[1] + s_base_rz * t_base_ry_1 + c_base_rz * t_base_rx_2;
  p[0] = q[0] - s_base_rz * t_base_rx_2 + c_base_rz * t_base_ry_1;
  const Scalar t_left_shank_4 = t_left_shank_2 + left_foot_l3 * s_q8_q9_q10;
  const Scalar t_left_hip_fork_7 = t_left_hip_fork_1 + s_left_hip_roll * t_left_shank_4;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_4 + left_foot_l3 * c_q8_q9_q10;
  const Scalar t_left_hip_block_7 = left_hip_block_l1 + c_left_hip_yaw * t_left_hip_fork_7;
  const Scalar t_left_hip_block_8 = t_left_hip_block_7 + s_left_hip_yaw * t_left_hip_fork_8;
  const Scalar t_left_hip_block_9 = t_left_hip_block_3 + c_left_hip_roll * t_left_shank_4;
  const Scalar t_base_rx_3 = s_base_rx * t_left_hip_block_8 - c_base_rx * t_left_hip_block_9;
  const Scalar t_left_hip_block_10 = s_left_hip_yaw * t_left_hip_fork_7;
  const Scalar t_left_hip_block_11 = t_left_hip_block_10 - c_left_hip_yaw * t_left_hip_fork_8;
  p[5] = q[2] + c_base_ry * t_base_rx_3 + s_base_ry * t_left_hip_block_11;
  const Scalar t_base_ry_2 = s_base_ry * t_base_rx_3 - c_base_ry * t_left_hip_block_11;
  const Scalar t_base_rx_4 = c_base_rx * t_left_hip_block_8 + s_base_rx * t_left_hip_block_9;
  p[4] = q[1] + s_base_rz * t_base_ry_2 + c_base_rz * t_base_rx_4;
  p[3] = q[0] + c_base_rz * t_base_ry_2 - s_base_rz * t_base_rx_4;
  const Scalar t_right_thigh_1 = left_hip_fork_l3 - left_foot_l1 * s_right_ankle_roll;
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * t_right_thigh_1;
  const Scalar t_right_foot_1 = left_hip_fork_l1 + left_foot_l1 * c_right_ankle_roll;
  // right_hip_fork
  const Scalar t_right_hip_fork_2 = left_hip_fork_l1 - left_shank_l1 * s_right_hip_pitch;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 - left_ankle_cross_l1 * s_q14_q15;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_3 - s_q14_q15_q16 * t_right_foot_1;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_4 - left_foot_l2 * c_q14_q15_q16;
  // right_shank
  const Scalar t_right_shank_1 = left_shank_l1 * c_right_hip_pitch;
  const Scalar t_right_shank_2 = t_right_shank_1 + left_ankle_cross_l1 * c_q14_q15;
  const Scalar t_right_shank_3 = t_right_shank_2 + c_q14_q15_q16 * t_right_foot_1;
  const Scalar t_right_shank_4 = t_right_shank_3 - left_foot_l2 * s_q14_q15_q16;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_1 - s_right_hip_roll * t_right_shank_4;
  // right_hip_block
  const Scalar t_right_hip_block_1 = left_hip_block_l1 - s_right_hip_yaw * t_right_hip_fork_5;
  const Scalar t_right_hip_block_2 = c_right_hip_yaw * t_right_hip_fork_6;
  const Scalar t_right_hip_block_3 = t_right_hip_block_1 + t_right_hip_block_2;
  const Scalar t_right_hip_block_4 = left_hip_block_l2 + s_right_hip_roll * t_right_thigh_1;
  const Scalar t_right_hip_block_5 = t_right_hip_block_4 + c_right_hip_roll * t_right_shank_4;
  const Scalar t_base_rx_5 = s_base_rx * t_right_hip_block_3;
  const Scalar t_base_rx_6 = t_base_rx_5 + c_base_rx * t_right_hip_block_5;
  const Scalar t_right_hip_block_6 = c_right_hip_yaw * t_right_hip_fork_5;
  const Scalar t_right_hip_block_7 = s_right_hip_yaw * t_right_hip_fork_6;
  const Scalar t_right_hip_block_8 = t_right_hip_block_6 + t_right_hip_block_7;
  p[8] = q[2] - c_base_ry * t_base_rx_6 - s_base_ry * t_right_hip_block_8;
  const Scalar t_base_py_1 = c_base_ry * t_right_hip_block_8 - s_base_ry * t_base_rx_6;
  const Scalar t_base_rx_7 = c_base_rx * t_right_hip_block_3;
  const Scalar t_base_rx_8 = t_base_rx_7 - s_base_rx * t_right_hip_block_5;
  p[7] = q[1] + s_base_rz * t_base_py_1 - c_base_rz * t_base_rx_8;
  p[6] = q[0] + c_base_rz * t_base_py_1 + s_base_rz * t_base_rx_8;
  const Scalar t_right_shank_5 = t_right_shank_3 + left_foot_l3 * s_q14_q15_q16;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_1 - s_right_hip_roll * t_right_shank_5;
  const Scalar t_right_hip_fork_8 = t_right_hip_fork_4 + left_foot_l3 * c_q14_q15_q16;
  const Scalar t_right_hip_block_9 = s_right_hip_yaw * t_right_hip_fork_7;
  const Scalar t_right_hip_block_10 = c_right_hip_yaw * t_right_hip_fork_8;
  const Scalar t_right_hip_block_11 = t_right_hip_block_9 + t_right_hip_block_10;
  const Scalar t_right_hip_block_12 = t_right_hip_block_4 + c_right_hip_roll * t_right_shank_5;
  const Scalar t_right_hip_block_13 = left_hip_block_l1 - s_right_hip_yaw * t_right_hip_fork_8;
  const Scalar t_right_hip_block_14 = c_right_hip_yaw * t_right_hip_fork_7;
  const Scalar t_right_hip_block_15 = t_right_hip_block_13 + t_right_hip_block_14;
  const Scalar t_base_rx_9 = c_base_rx * t_right_hip_block_12;
  const Scalar t_base_rx_10 = t_base_rx_9 + s_base_rx * t_right_hip_block_15;
  p[11] = q[2] - s_base_ry * t_right_hip_block_11 - c_base_ry * t_base_rx_10;
  const Scalar t_base_ry_3 = s_base_ry * t_base_rx_10 - c_base_ry * t_right_hip_block_11;
  const Scalar t_base_rx_11 = c_base_rx * t_right_hip_block_15;
  const Scalar t_base_rx_12 = t_base_rx_11 - s_base_rx * t_right_hip_block_12;
  p[10] = q[1] - s_base_rz * t_base_ry_3 - c_base_rz * t_base_rx_12;
  // base_px
  p[9] = q[0] - c_base_rz * t_base_ry_3 + s_base_rz * t_base_rx_12;
}

void force_jacobian_transpose(const Scalar q[18], Scalar C[216]) noexcept {
  const auto [s_base_rz, c_base_rz] = sine_cosine(q[3]);
  const auto [s_base_rx, c_base_rx] = sine_cosine(q[5]);
  const auto [s_base_ry, c_base_ry] = sine_cosine(q[4]);
  const auto [s_left_hip_yaw, c_left_hip_yaw] = sine_cosine(q[6]);
  const auto [s_left_hip_roll, c_left_hip_roll] = sine_cosine(q[7]);
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const auto [s_q8_q9_q10, c_q8_q9_q10] = sine_cosine(q_q8_q9_q10);
  const auto [s_q9_q10, c_q9_q10] = sine_cosine(q_q9_q10);
  const Scalar s_left_shank_y = left_shank_l1 * s_q9_q10;
  const auto [s_left_ankle_pitch, c_left_ankle_pitch] = sine_cosine(q[10]);
  const Scalar s_left_ankle_cross_y = left_ankle_cross_l1 * s_left_ankle_pitch;
  const auto [s_right_hip_yaw, c_right_hip_yaw] = sine_cosine(q[12]);
  const auto [s_right_hip_roll, c_right_hip_roll] = sine_cosine(q[13]);
  const Scalar q_q15_q16 = q[15] + q[16];
  const Scalar q_q14_q15_q16 = q[14] + q_q15_q16;
  const auto [s_q14_q15_q16, c_q14_q15_q16] = sine_cosine(q_q14_q15_q16);
  const auto [s_q15_q16, c_q15_q16] = sine_cosine(q_q15_q16);
  const Scalar s_right_shank_y = left_shank_l1 * s_q15_q16;
  const auto [s_right_ankle_pitch, c_right_ankle_pitch] = sine_cosine(q[16]);
  const Scalar s_righ_ankl_cros_y = left_ankle_cross_l1 * s_right_ankle_pitch;
  // base_rx
  const Scalar t_base_rx_1 = c_base_rz * c_base_rx;
  const Scalar t_base_rx_2 = s_base_rz * s_base_rx;
  const Scalar Rx_base_rx_y = t_base_rx_2 + s_base_ry * t_base_rx_1;
  const Scalar t_base_rx_3 = c_base_rz * s_base_rx;
  const Scalar t_base_rx_4 = s_base_rz * c_base_rx;
  const Scalar t_base_rx_5 = t_base_rx_4 - s_base_ry * t_base_rx_3;
  const Scalar Rx_base_rx_z = c_base_rz * c_base_ry;
  const Scalar t_base_rx_6 = t_base_rx_3 - s_base_ry * t_base_rx_4;
  const Scalar Ry_base_rx_x = t_base_rx_1 + s_base_ry * t_base_rx_2;
  const Scalar Ry_base_rx_z = s_base_rz * c_base_ry;
  const Scalar Rz_base_rx_x = c_base_ry * s_base_rx;
  const Scalar Rz_base_rx_y = c_base_rx * c_base_ry;
  // left_hip_block
  const Scalar t_left_hip_block_1 = c_left_hip_yaw * t_base_rx_5;
  const Scalar t_left_hip_block_2 = s_left_hip_yaw * Rx_base_rx_z + t_left_hip_block_1;
  const Scalar Rx_left_hip_block_x = c_left_hip_yaw * Rx_base_rx_z - s_left_hip_yaw * t_base_rx_5;
  const Scalar t_left_hip_block_3 = s_left_hip_yaw * Ry_base_rx_z - c_left_hip_yaw * Ry_base_rx_x;
  const Scalar Ry_left_hip_block_x = c_left_hip_yaw * Ry_base_rx_z + s_left_hip_yaw * Ry_base_rx_x;
  const Scalar Rz_left_hip_block_x = s_left_hip_yaw * Rz_base_rx_x - s_base_ry * c_left_hip_yaw;
  const Scalar Rz_left_hip_block_y = c_left_hip_yaw * Rz_base_rx_x + s_base_ry * s_left_hip_yaw;
  // left_hip_fork
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * t_left_hip_block_2;
  const Scalar Rx_left_hip_fork_y = t_left_hip_fork_1 + c_left_hip_roll * Rx_base_rx_y;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * t_left_hip_block_2;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 - s_left_hip_roll * Rx_base_rx_y;
  const Scalar t_left_hip_fork_4 = c_left_hip_roll * t_left_hip_block_3;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_4 + s_left_hip_roll * t_base_rx_6;
  const Scalar t_left_hip_fork_6 = s_left_hip_roll * t_left_hip_block_3;
  const Scalar Ry_left_hip_fork_y = t_left_hip_fork_6 - c_left_hip_roll * t_base_rx_6;
  const Scalar t_left_hip_fork_7 = s_left_hip_roll * Rz_left_hip_block_y;
  const Scalar Rz_left_hip_fork_y = c_left_hip_roll * Rz_base_rx_y - t_left_hip_fork_7;
  const Scalar t_left_hip_fork_8 = c_left_hip_roll * Rz_left_hip_block_y;
  const Scalar Rz_left_hip_fork_x = s_left_hip_roll * Rz_base_rx_y + t_left_hip_fork_8;
  // left_thigh
  const Scalar t_left_thigh_1 = s_q8_q9_q10 * Rx_left_hip_block_x;
  const Scalar Rx_left_thigh_x = t_left_thigh_1 + c_q8_q9_q10 * Rx_left_hip_fork_y;
  const Scalar t_left_thigh_2 = c_q8_q9_q10 * Rx_left_hip_block_x;
  const Scalar t_left_thigh_3 = s_q8_q9_q10 * Rx_left_hip_fork_y - t_left_thigh_2;
  const Scalar t_left_thigh_4 = s_q8_q9_q10 * Ry_left_hip_block_x;
  const Scalar Ry_left_thigh_x = c_q8_q9_q10 * Ry_left_hip_fork_y + t_left_thigh_4;
  const Scalar t_left_thigh_5 = c_q8_q9_q10 * Ry_left_hip_block_x;
  const Scalar t_left_thigh_6 = s_q8_q9_q10 * Ry_left_hip_fork_y - t_left_thigh_5;
  const Scalar t_left_thigh_7 = s_q8_q9_q10 * Rz_left_hip_block_x;
  const Scalar Rz_left_thigh_x = t_left_thigh_7 + c_q8_q9_q10 * Rz_left_hip_fork_y;
  // right_hip_block
  const Scalar t_right_hip_block_1 = s_right_hip_yaw * t_base_rx_5;
  const Scalar Rx_right_hip_block_x = c_right_hip_yaw * Rx_base_rx_z - t_right_hip_block_1;
  const Scalar t_right_hip_block_2 = c_right_hip_yaw * t_base_rx_5;
  const Scalar t_right_hip_block_3 = s_right_hip_yaw * Rx_base_rx_z + t_right_hip_block_2;
  const Scalar t_right_hip_block_4 = s_right_hip_yaw * Ry_base_rx_z;
  const Scalar t_right_hip_block_5 = t_right_hip_block_4 - c_right_hip_yaw * Ry_base_rx_x;
  const Scalar t_right_hip_block_6 = c_right_hip_yaw * Ry_base_rx_z;
  const Scalar Ry_right_hip_block_x = t_right_hip_block_6 + s_right_hip_yaw * Ry_base_rx_x;
  const Scalar Rz_right_hip_block_y = c_right_hip_yaw * Rz_base_rx_x + s_base_ry * s_right_hip_yaw;
  const Scalar Rz_right_hip_block_x = s_right_hip_yaw * Rz_base_rx_x - s_base_ry * c_right_hip_yaw;
  // right_hip_fork
  const Scalar t_right_hip_fork_1 = c_right_hip_roll * t_right_hip_block_3;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 - s_right_hip_roll * Rx_base_rx_y;
  const Scalar t_right_hip_fork_3 = s_right_hip_roll * t_right_hip_block_3;
  const Scalar Rx_right_hip_fork_y = t_right_hip_fork_3 + c_right_hip_roll * Rx_base_rx_y;
  const Scalar t_right_hip_fork_4 = s_right_hip_roll * t_right_hip_block_5;
  const Scalar t_right_hip_fork_5 = c_right_hip_roll * t_base_rx_6 - t_right_hip_fork_4;
  const Scalar t_right_hip_fork_6 = c_right_hip_roll * t_right_hip_block_5;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_6 + s_right_hip_roll * t_base_rx_6;
  const Scalar t_right_hip_fork_8 = c_right_hip_roll * Rz_right_hip_block_y;
  const Scalar Rz_right_hip_fork_x = s_right_hip_roll * Rz_base_rx_y + t_right_hip_fork_8;
  // right_thigh
  const Scalar t_right_thigh_1 = s_q14_q15_q16 * Rx_right_hip_block_x;
  const Scalar Rx_right_thigh_x = t_right_thigh_1 + c_q14_q15_q16 * Rx_right_hip_fork_y;
  const Scalar t_right_thigh_2 = c_q14_q15_q16 * Rx_right_hip_block_x;
  const Scalar Rx_right_thigh_y = t_right_thigh_2 - s_q14_q15_q16 * Rx_right_hip_fork_y;
  const Scalar t_right_thigh_3 = s_q14_q15_q16 * t_right_hip_fork_5;
  const Scalar Ry_right_thigh_y = t_right_thigh_3 + c_q14_q15_q16 * Ry_right_hip_block_x;
  const Scalar t_right_thigh_4 = c_q14_q15_q16 * t_right_hip_fork_5;
  const Scalar Ry_right_foot_x = t_right_thigh_4 - s_q14_q15_q16 * Ry_right_hip_block_x;
  const Scalar t_right_hip_fork_9 = s_right_hip_roll * Rz_right_hip_block_y;
  const Scalar Rz_right_hip_fork_y = c_right_hip_roll * Rz_base_rx_y - t_right_hip_fork_9;
  const Scalar t_right_thigh_5 = s_q14_q15_q16 * Rz_right_hip_block_x;
  const Scalar Rz_right_thigh_x = c_q14_q15_q16 * Rz_right_hip_fork_y + t_right_thigh_5;
  const Scalar t_right_thigh_6 = c_q14_q15_q16 * Rz_right_hip_block_x;
  const Scalar Rz_right_thigh_y = t_right_thigh_6 - s_q14_q15_q16 * Rz_right_hip_fork_y;
  const auto [s_right_ankle_roll, c_right_ankle_roll] = sine_cosine(q[17]);
  const Scalar r_right_foot_x = left_foot_l1 * c_right_ankle_roll;
  const Scalar r_right_foot_y = left_foot_l1 * s_right_ankle_roll;
  const auto [s_left_ankle_roll, c_left_ankle_roll] = sine_cosine(q[11]);
  // left_foot
  const Scalar r_left_foot_y = left_foot_l1 * s_left_ankle_roll;
  const Scalar r_left_foot_x = left_foot_l1 * c_left_ankle_roll;
  const Scalar t_left_foot_1 = left_hip_fork_l1 + r_left_foot_x;
  const Scalar t_left_ankle_cross_1 = t_left_foot_1 + left_ankle_cross_l1 * c_left_ankle_pitch;
  const Scalar t_left_ankle_cross_2 = left_foot_l2 - s_left_ankle_cross_y;
  const Scalar t_left_shank_1 = t_left_ankle_cross_1 + left_shank_l1 * c_q9_q10;
  // left_thigh
  const Scalar r_left_thigh_y = s_left_shank_y - t_left_ankle_cross_2;
  const Scalar t_left_thigh_8 = c_q8_q9_q10 * t_left_shank_1;
  const Scalar t_left_thigh_9 = t_left_thigh_8 + s_q8_q9_q10 * r_left_thigh_y;
  const Scalar r_left_hip_fork_x = left_hip_fork_l3 + r_left_foot_y;
  const Scalar t_left_hip_fork_9 = c_left_hip_roll * r_left_hip_fork_x;
  // left_hip_block
  const Scalar r_left_hip_block_y = t_left_hip_fork_9 + s_left_hip_roll * t_left_thigh_9;
  const Scalar t_left_hip_block_4 = left_hip_fork_l1 - s_q8_q9_q10 * t_left_shank_1;
  const Scalar r_left_hip_block_x = t_left_hip_block_4 + c_q8_q9_q10 * r_left_thigh_y;
  const Scalar t_base_rx_7 = left_hip_block_l1 + s_left_hip_yaw * r_left_hip_block_x;
  const Scalar r_base_rx_x = t_base_rx_7 + c_left_hip_yaw * r_left_hip_block_y;
  const Scalar t_left_hip_block_5 = c_left_hip_yaw * r_left_hip_block_x;
  const Scalar r_base_rx_z = t_left_hip_block_5 - s_left_hip_yaw * r_left_hip_block_y;
  const Scalar t_left_hip_block_6 = left_hip_block_l2 - s_left_hip_roll * r_left_hip_fork_x;
  const Scalar t_left_hip_block_7 = t_left_hip_block_6 + c_left_hip_roll * t_left_thigh_9;
  const Scalar t_base_rx_8 = s_base_rx * r_base_rx_x - c_base_rx * t_left_hip_block_7;
  const Scalar t_base_rx_9 = s_base_ry * r_base_rx_z - c_base_ry * t_base_rx_8;
  const Scalar r_base_rz_x = s_base_ry * t_base_rx_8 + c_base_ry * r_base_rx_z;
  C[50] = -r_base_rz_x;
  const Scalar r_base_ry_z = c_base_rx * r_base_rx_x + s_base_rx * t_left_hip_block_7;
  C[36] = -(s_base_rz * r_base_rz_x + c_base_rz * r_base_ry_z);
  C[37] = c_base_rz * r_base_rz_x - s_base_rz * r_base_ry_z;
  // base_px
  C[49] = -s_base_rz * t_base_rx_9;
  C[48] = -c_base_rz * t_base_rx_9;
  C[60] = Rx_base_rx_y * r_base_rx_x - t_base_rx_5 * t_left_hip_block_7;
  C[62] = c_base_ry * r_base_ry_z;
  C[61] = Ry_base_rx_x * t_left_hip_block_7 - t_base_rx_6 * r_base_rx_x;
  const Scalar t_base_px_1 = t_left_thigh_6 * t_left_foot_1;
  C[121] = t_base_px_1 + left_foot_l2 * Ry_left_thigh_x;
  C[132] = Rx_left_thigh_x * r_left_foot_y - t_left_hip_fork_3 * r_left_foot_x;
  C[135] = C[132];
  C[133] = Ry_left_thigh_x * r_left_foot_y - t_left_hip_fork_5 * r_left_foot_x;
  C[136] = C[133];
  const Scalar t_base_px_2 = t_left_thigh_3 * t_left_foot_1;
  C[120] = t_base_px_2 + left_foot_l2 * Rx_left_thigh_x;
  const Scalar t_base_px_3 = Rx_left_thigh_x * t_left_ankle_cross_2;
  const Scalar t_base_px_4 = t_left_thigh_3 * t_left_shank_1;
  const Scalar t_base_px_5 = s_left_shank_y * Rx_left_thigh_x - t_base_px_4;
  C[96] = t_base_px_3 - t_base_px_5;
  const Scalar t_base_px_6 = t_left_thigh_6 * t_left_ankle_cross_1;
  C[109] = t_base_px_6 + Ry_left_thigh_x * t_left_ankle_cross_2;
  const Scalar t_base_px_7 = t_left_thigh_6 * t_left_shank_1;
  C[97] = t_base_px_7 - Ry_left_thigh_x * r_left_thigh_y;
  const Scalar t_base_px_8 = t_left_thigh_3 * t_left_ankle_cross_1;
  C[108] = t_base_px_3 + t_base_px_8;
  C[73] = -(t_left_hip_block_3 * r_left_hip_block_x + Ry_left_hip_block_x * r_left_hip_block_y);
  C[74] = Rz_left_hip_block_y * r_left_hip_block_x - Rz_left_hip_block_x * r_left_hip_block_y;
  C[72] = -(Rx_left_hip_block_x * r_left_hip_block_y + t_left_hip_block_2 * r_left_hip_block_x);
  const Scalar t_left_thigh_10 = c_q8_q9_q10 * Rz_left_hip_block_x;
  const Scalar t_left_thigh_11 = s_q8_q9_q10 * Rz_left_hip_fork_y - t_left_thigh_10;
  const Scalar t_base_px_9 = t_left_shank_1 * t_left_thigh_11;
  C[98] = t_base_px_9 - Rz_left_thigh_x * r_left_thigh_y;
  const Scalar t_base_px_10 = t_left_foot_1 * t_left_thigh_11;
  C[122] = t_base_px_10 + left_foot_l2 * Rz_left_thigh_x;
  const Scalar t_base_px_11 = t_left_ankle_cross_1 * t_left_thigh_11;
  C[110] = t_base_px_11 + Rz_left_thigh_x * t_left_ankle_cross_2;
  const Scalar t_base_px_12 = Ry_left_hip_fork_y * r_left_hip_fork_x;
  C[85] = t_base_px_12 - t_left_hip_fork_5 * t_left_thigh_9;
  const Scalar t_base_px_13 = Rx_left_hip_fork_y * r_left_hip_fork_x;
  C[84] = t_base_px_13 - t_left_hip_fork_3 * t_left_thigh_9;
  C[134] = Rz_left_thigh_x * r_left_foot_y + Rz_left_hip_fork_x * r_left_foot_x;
  C[137] = C[134];
  const Scalar t_base_px_14 = Rz_left_hip_fork_y * r_left_hip_fork_x;
  C[86] = t_base_px_14 + Rz_left_hip_fork_x * t_left_thigh_9;
  const Scalar r_left_shank_y = left_foot_l3 + s_left_ankle_cross_y;
  const Scalar r_left_thigh_y_2 = s_left_shank_y + r_left_shank_y;
  const Scalar t_left_thigh_12 = t_left_thigh_8 + s_q8_q9_q10 * r_left_thigh_y_2;
  const Scalar r_left_hip_block_y_2 = t_left_hip_fork_9 + s_left_hip_roll * t_left_thigh_12;
  const Scalar r_left_hip_block_x_2 = t_left_hip_block_4 + c_q8_q9_q10 * r_left_thigh_y_2;
  const Scalar t_base_rx_10 = left_hip_block_l1 + c_left_hip_yaw * r_left_hip_block_y_2;
  const Scalar r_base_rx_x_2 = t_base_rx_10 + s_left_hip_yaw * r_left_hip_block_x_2;
  const Scalar t_left_hip_block_8 = t_left_hip_block_6 + c_left_hip_roll * t_left_thigh_12;
  const Scalar t_base_rx_11 = s_base_rx * r_base_rx_x_2 - c_base_rx * t_left_hip_block_8;
  const Scalar t_left_hip_block_9 = c_left_hip_yaw * r_left_hip_block_x_2;
  const Scalar r_base_rx_z_2 = t_left_hip_block_9 - s_left_hip_yaw * r_left_hip_block_y_2;
  const Scalar r_base_rz_x_2 = c_base_ry * r_base_rx_z_2 + s_base_ry * t_base_rx_11;
  C[53] = -r_base_rz_x_2;
  const Scalar r_base_ry_z_2 = s_base_rx * t_left_hip_block_8 + c_base_rx * r_base_rx_x_2;
  C[39] = -(s_base_rz * r_base_rz_x_2 + c_base_rz * r_base_ry_z_2);
  C[40] = c_base_rz * r_base_rz_x_2 - s_base_rz * r_base_ry_z_2;
  const Scalar t_base_rx_12 = s_base_ry * r_base_rx_z_2 - c_base_ry * t_base_rx_11;
  C[51] = -c_base_rz * t_base_rx_12;
  C[52] = -s_base_rz * t_base_rx_12;
  C[63] = Rx_base_rx_y * r_base_rx_x_2 - t_base_rx_5 * t_left_hip_block_8;
  C[65] = c_base_ry * r_base_ry_z_2;
  C[64] = Ry_base_rx_x * t_left_hip_block_8 - t_base_rx_6 * r_base_rx_x_2;
  C[100] = t_base_px_7 - Ry_left_thigh_x * r_left_thigh_y_2;
  C[124] = t_base_px_1 - left_foot_l3 * Ry_left_thigh_x;
  const Scalar t_base_px_15 = Rx_left_thigh_x * r_left_shank_y;
  C[111] = t_base_px_8 - t_base_px_15;
  C[123] = t_base_px_2 - left_foot_l3 * Rx_left_thigh_x;
  C[112] = t_base_px_6 - Ry_left_thigh_x * r_left_shank_y;
  C[99] = -(t_base_px_5 + t_base_px_15);
  const Scalar t_base_px_16 = t_left_hip_block_3 * r_left_hip_block_x_2;
  C[76] = -(Ry_left_hip_block_x * r_left_hip_block_y_2 + t_base_px_16);
  const Scalar t_base_px_17 = t_left_hip_block_2 * r_left_hip_block_x_2;
  C[75] = -(t_base_px_17 + Rx_left_hip_block_x * r_left_hip_block_y_2);
  const Scalar t_base_px_18 = Rz_left_hip_block_y * r_left_hip_block_x_2;
  C[77] = t_base_px_18 - Rz_left_hip_block_x * r_left_hip_block_y_2;
  C[88] = t_base_px_12 - t_left_hip_fork_5 * t_left_thigh_12;
  C[125] = t_base_px_10 - left_foot_l3 * Rz_left_thigh_x;
  C[87] = t_base_px_13 - t_left_hip_fork_3 * t_left_thigh_12;
  C[113] = t_base_px_11 - Rz_left_thigh_x * r_left_shank_y;
  C[101] = t_base_px_9 - Rz_left_thigh_x * r_left_thigh_y_2;
  C[89] = t_base_px_14 + Rz_left_hip_fork_x * t_left_thigh_12;
  const Scalar t_right_foot_1 = left_hip_fork_l1 + r_right_foot_x;
  const Scalar t_righ_ankl_cros_1 = t_right_foot_1 + left_ankle_cross_l1 * c_right_ankle_pitch;
  const Scalar t_righ_ankl_cros_2 = left_foot_l2 - s_righ_ankl_cros_y;
  const Scalar t_right_shank_1 = t_righ_ankl_cros_1 + left_shank_l1 * c_q15_q16;
  // right_thigh
  const Scalar r_right_thigh_y = s_right_shank_y - t_righ_ankl_cros_2;
  const Scalar t_right_thigh_7 = c_q14_q15_q16 * t_right_shank_1;
  const Scalar t_right_thigh_8 = t_right_thigh_7 + s_q14_q15_q16 * r_right_thigh_y;
  const Scalar t_right_thigh_9 = left_hip_fork_l3 - r_right_foot_y;
  const Scalar t_right_hip_fork_10 = c_right_hip_roll * t_right_thigh_9;
  const Scalar t_right_hip_fork_11 = t_right_hip_fork_10 - s_right_hip_roll * t_right_thigh_8;
  // right_hip_block
  const Scalar t_right_hip_block_7 = left_hip_fork_l1 - s_q14_q15_q16 * t_right_shank_1;
  const Scalar r_right_hip_block_x = t_right_hip_block_7 + c_q14_q15_q16 * r_right_thigh_y;
  const Scalar t_right_hip_block_8 = left_hip_block_l1 + c_right_hip_yaw * t_right_hip_fork_11;
  const Scalar t_right_hip_block_9 = s_right_hip_yaw * r_right_hip_block_x;
  const Scalar t_right_hip_block_10 = t_right_hip_block_8 - t_right_hip_block_9;
  const Scalar t_right_hip_block_11 = s_right_hip_yaw * t_right_hip_fork_11;
  const Scalar r_base_rx_z_3 = c_right_hip_yaw * r_right_hip_block_x + t_right_hip_block_11;
  const Scalar t_right_hip_block_12 = left_hip_block_l2 + s_right_hip_roll * t_right_thigh_9;
  const Scalar t_right_hip_block_13 = t_right_hip_block_12 + c_right_hip_roll * t_right_thigh_8;
  // base_rx
  const Scalar t_base_rx_13 = s_base_rx * t_right_hip_block_10;
  const Scalar t_base_rx_14 = t_base_rx_13 + c_base_rx * t_right_hip_block_13;
  const Scalar t_base_rx_15 = s_base_ry * r_base_rx_z_3 + c_base_ry * t_base_rx_14;
  const Scalar r_base_rz_x_3 = c_base_ry * r_base_rx_z_3 - s_base_ry * t_base_rx_14;
  C[56] = -r_base_rz_x_3;
  const Scalar t_base_rx_16 = s_base_rx * t_right_hip_block_13;
  const Scalar r_base_ry_z_3 = t_base_rx_16 - c_base_rx * t_right_hip_block_10;
  C[43] = c_base_rz * r_base_rz_x_3 - s_base_rz * r_base_ry_z_3;
  C[42] = -(c_base_rz * r_base_ry_z_3 + s_base_rz * r_base_rz_x_3);
  // base_px
  C[54] = -c_base_rz * t_base_rx_15;
  C[55] = -s_base_rz * t_base_rx_15;
  C[68] = c_base_ry * r_base_ry_z_3;
  C[66] = -(t_base_rx_5 * t_right_hip_block_13 + Rx_base_rx_y * t_right_hip_block_10);
  C[67] = t_base_rx_6 * t_right_hip_block_10 + Ry_base_rx_x * t_right_hip_block_13;
  const Scalar t_base_px_19 = Ry_right_thigh_y * t_right_shank_1;
  const Scalar t_base_px_20 = s_right_shank_y * Ry_right_foot_x - t_base_px_19;
  const Scalar t_base_px_21 = Ry_right_foot_x * t_righ_ankl_cros_2;
  C[175] = t_base_px_20 - t_base_px_21;
  const Scalar t_base_px_22 = Rx_right_thigh_x * t_righ_ankl_cros_2;
  const Scalar t_base_px_23 = Rx_right_thigh_y * t_right_shank_1;
  const Scalar t_base_px_24 = s_right_shank_y * Rx_right_thigh_x + t_base_px_23;
  C[174] = t_base_px_22 - t_base_px_24;
  const Scalar t_base_px_25 = Rx_right_thigh_y * t_righ_ankl_cros_1;
  C[186] = t_base_px_22 - t_base_px_25;
  C[211] = -(Ry_right_foot_x * r_right_foot_y + t_right_hip_fork_7 * r_right_foot_x);
  C[214] = C[211];
  const Scalar t_base_px_26 = Rx_right_thigh_y * t_right_foot_1;
  C[198] = left_foot_l2 * Rx_right_thigh_x - t_base_px_26;
  const Scalar t_base_px_27 = Ry_right_thigh_y * t_right_foot_1;
  C[199] = -(t_base_px_27 + left_foot_l2 * Ry_right_foot_x);
  const Scalar t_base_px_28 = Ry_right_thigh_y * t_righ_ankl_cros_1;
  C[187] = -(t_base_px_21 + t_base_px_28);
  C[210] = Rx_right_thigh_x * r_right_foot_y - t_right_hip_fork_2 * r_right_foot_x;
  C[213] = C[210];
  const Scalar t_base_px_29 = t_right_hip_block_5 * r_right_hip_block_x;
  C[151] = Ry_right_hip_block_x * t_right_hip_fork_11 - t_base_px_29;
  const Scalar t_base_px_30 = Rz_right_hip_block_x * t_right_hip_fork_11;
  C[152] = Rz_right_hip_block_y * r_right_hip_block_x + t_base_px_30;
  const Scalar t_base_px_31 = t_right_hip_block_3 * r_right_hip_block_x;
  C[150] = Rx_right_hip_block_x * t_right_hip_fork_11 - t_base_px_31;
  const Scalar t_base_px_32 = Rx_right_hip_fork_y * t_right_thigh_9;
  C[162] = -(t_base_px_32 + t_right_hip_fork_2 * t_right_thigh_8);
  C[212] = Rz_right_hip_fork_x * r_right_foot_x + Rz_right_thigh_x * r_right_foot_y;
  C[215] = C[212];
  const Scalar t_base_px_33 = Rz_right_thigh_y * t_right_shank_1;
  C[176] = -(t_base_px_33 + Rz_right_thigh_x * r_right_thigh_y);
  const Scalar t_base_px_34 = Rz_right_thigh_y * t_right_foot_1;
  C[200] = left_foot_l2 * Rz_right_thigh_x - t_base_px_34;
  const Scalar t_base_px_35 = Rz_right_thigh_y * t_righ_ankl_cros_1;
  C[188] = Rz_right_thigh_x * t_righ_ankl_cros_2 - t_base_px_35;
  const Scalar t_base_px_36 = t_right_hip_fork_5 * t_right_thigh_9;
  C[163] = t_base_px_36 - t_right_hip_fork_7 * t_right_thigh_8;
  const Scalar t_base_px_37 = Rz_right_hip_fork_y * t_right_thigh_9;
  C[164] = Rz_right_hip_fork_x * t_right_thigh_8 - t_base_px_37;
  const Scalar r_right_shank_y = left_foot_l3 + s_righ_ankl_cros_y;
  const Scalar r_right_thigh_y_2 = s_right_shank_y + r_right_shank_y;
  const Scalar t_right_thigh_10 = t_right_thigh_7 + s_q14_q15_q16 * r_right_thigh_y_2;
  const Scalar t_right_hip_fork_12 = t_right_hip_fork_10 - s_right_hip_roll * t_right_thigh_10;
  // right_hip_block
  const Scalar r_right_hip_block_x_2 = t_right_hip_block_7 + c_q14_q15_q16 * r_right_thigh_y_2;
  const Scalar t_right_hip_block_14 = left_hip_block_l1 - s_right_hip_yaw * r_right_hip_block_x_2;
  const Scalar t_right_hip_block_15 = c_right_hip_yaw * t_right_hip_fork_12;
  const Scalar t_right_hip_block_16 = t_right_hip_block_14 + t_right_hip_block_15;
  const Scalar t_right_hip_block_17 = c_right_hip_yaw * r_right_hip_block_x_2;
  const Scalar r_base_rx_z_4 = t_right_hip_block_17 + s_right_hip_yaw * t_right_hip_fork_12;
  const Scalar t_right_hip_block_18 = t_right_hip_block_12 + c_right_hip_roll * t_right_thigh_10;
  const Scalar t_base_rx_17 = s_base_rx * t_right_hip_block_16;
  const Scalar t_base_rx_18 = t_base_rx_17 + c_base_rx * t_right_hip_block_18;
  const Scalar r_base_ry_x = s_base_ry * t_base_rx_18 - c_base_ry * r_base_rx_z_4;
  C[59] = r_base_ry_x;
  const Scalar t_base_rx_19 = s_base_rx * t_right_hip_block_18;
  const Scalar r_base_ry_z_4 = t_base_rx_19 - c_base_rx * t_right_hip_block_16;
  C[45] = s_base_rz * r_base_ry_x - c_base_rz * r_base_ry_z_4;
  C[46] = -(s_base_rz * r_base_ry_z_4 + c_base_rz * r_base_ry_x);
  const Scalar t_base_rx_20 = s_base_ry * r_base_rx_z_4 + c_base_ry * t_base_rx_18;
  // base_px
  C[57] = -c_base_rz * t_base_rx_20;
  C[58] = -s_base_rz * t_base_rx_20;
  C[71] = c_base_ry * r_base_ry_z_4;
  C[69] = -(t_base_rx_5 * t_right_hip_block_18 + Rx_base_rx_y * t_right_hip_block_16);
  C[70] = t_base_rx_6 * t_right_hip_block_16 + Ry_base_rx_x * t_right_hip_block_18;
  const Scalar t_base_px_38 = Rx_right_thigh_x * r_right_shank_y;
  C[177] = -(t_base_px_24 + t_base_px_38);
  const Scalar t_base_px_39 = Ry_right_foot_x * r_right_shank_y;
  C[178] = t_base_px_20 + t_base_px_39;
  C[202] = left_foot_l3 * Ry_right_foot_x - t_base_px_27;
  C[201] = -(t_base_px_26 + left_foot_l3 * Rx_right_thigh_x);
  C[190] = t_base_px_39 - t_base_px_28;
  C[189] = -(t_base_px_25 + t_base_px_38);
  const Scalar t_base_px_40 = Rz_right_hip_block_y * r_right_hip_block_x_2;
  C[155] = t_base_px_40 + Rz_right_hip_block_x * t_right_hip_fork_12;
  const Scalar t_base_px_41 = t_right_hip_block_5 * r_right_hip_block_x_2;
  C[154] = Ry_right_hip_block_x * t_right_hip_fork_12 - t_base_px_41;
  const Scalar t_base_px_42 = t_right_hip_block_3 * r_right_hip_block_x_2;
  C[153] = Rx_right_hip_block_x * t_right_hip_fork_12 - t_base_px_42;
  C[165] = -(t_base_px_32 + t_right_hip_fork_2 * t_right_thigh_10);
  C[191] = -(t_base_px_35 + Rz_right_thigh_x * r_right_shank_y);
  C[203] = -(t_base_px_34 + left_foot_l3 * Rz_right_thigh_x);
  C[166] = t_base_px_36 - t_right_hip_fork_7 * t_right_thigh_10;
  C[179] = -(t_base_px_33 + Rz_right_thigh_x * r_right_thigh_y_2);
  C[167] = Rz_right_hip_fork_x * t_right_thigh_10 - t_base_px_37;
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

}  // namespace biped
