// biped.cpp: see biped.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate biped.yaml

#include "biped.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace biped {

static_assert(kDigest == 0xb5e842cd159eeab7ULL, "header and source are of different runs");

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

// m: offset y of left_hip_block, right_hip_block
constexpr double left_hip_block_l1 = 0.08064;
// m: offset z of left_hip_block, left_hip_fork, right_hip_block, right_hip_fork; offset y of
//     left_thigh, right_thigh
constexpr double left_hip_block_l2 = 0.114;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x z,
//     inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz
//     of left_thigh, right_thigh; mass, com x z, inertia xx yy zz, offset z of left_shank,
//     left_ankle_cross, right_shank, right_ankle_cross; mass, com, inertia xx yy zz, offset z of
//     left_foot, right_foot
constexpr double left_hip_block_I1 = 1.7027154945201517;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x, inertia
//     xx yy zz, offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh;
//     offset z of left_shank, left_foot, right_shank, right_foot
constexpr double left_hip_block_I2 = 0.003223043866;
// kg m^2: mass, com x y, inertia xx yy zz of left_hip_block, right_hip_block; mass, com x z,
//     inertia xx yy zz, offset x of left_hip_fork, right_hip_fork; mass of left_thigh, left_shank,
//     left_ankle_cross, right_thigh, right_shank, right_ankle_cross; mass, offset z of left_foot,
//     right_foot
constexpr double left_hip_block_I3 = 0.00432900664;

// ratio: offset x of left_hip_fork, right_hip_fork; offset z of left_shank, left_foot, right_shank,
//     right_foot
constexpr double left_hip_fork_k1 = 43.2;
// ratio: offset x of left_hip_fork, right_hip_fork; offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr double left_hip_fork_k2 = 43.3;
// ratio: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; offset z
//     of left_foot, right_foot
constexpr double left_hip_fork_k3 = 2.0;
// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_l1 = 0.01;
// m: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_fork_l2 = 0.02;
// m: offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_l3 = 0.02;
// m: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh
constexpr double left_hip_fork_l4 = 0.04;
// kg m^2: mass, com x y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_hip_fork_I1 = 0.0042631913856;
// kg m^2: mass, com x z, offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xz yz of
//     left_thigh, left_shank, right_thigh, right_shank; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_hip_fork_I2 = 0.03467671360129536;
// kg m^2: mass, com y z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_I3 = 0.00016159248;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz,
//     offset z of left_shank, left_ankle_cross, left_foot, right_shank, right_ankle_cross,
//     right_foot
constexpr double left_hip_fork_I4 = 1.6921112099106208;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz,
//     offset z of left_shank, right_shank; mass, com, inertia xx yy zz, offset z of
//     left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_hip_fork_I5 = 1.6313524106132014;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I6 = 0.02931050006032736;
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
// kg m^2: mass, com y, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_I11 = 0.02957665238032736;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz,
//     offset z of left_shank, right_shank; mass, com y, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I12 = 0.00053230464;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y
//     z, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz,
//     offset z of left_shank, right_shank; mass, com y, inertia xx yy zz of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I13 = 0.05991064876065472;
// kg m^2: mass, com y z, inertia xx yy zz, offset z of left_hip_fork, right_hip_fork; mass, com y,
//     inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y, inertia xx yy zz of
//     left_shank, left_ankle_cross, right_shank, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_I14 = 0.02968917206032736;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z of left_foot, right_foot
constexpr double left_hip_fork_I15 = 0.326079188015558;
// kg m^2: mass, com y z, inertia xx yy zz, offset x z of left_hip_fork, right_hip_fork; mass, com
//     y, inertia xx yy zz, offset y of left_thigh, right_thigh; mass, com y z, inertia xx yy zz of
//     left_shank, right_shank; mass, com y z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z of left_foot, right_foot
constexpr double left_hip_fork_I16 = 0.38683221359244196;
// N m: gravity; mass, com y, offset z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, left_ankle_cross, right_shank,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_hip_fork_G1 = 3.9972481559136;
// N m: gravity; mass, com z of left_hip_fork, right_hip_fork
constexpr double left_hip_fork_G2 = 0.0466241832;
// N m: gravity; mass, com y, offset x z of left_hip_fork, right_hip_fork; mass, com y, offset y of
//     left_thigh, right_thigh; mass, com y of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_hip_fork_G3 = 3.8115095399136;
// s^-2: gravity; offset x of left_hip_fork, right_hip_fork; offset z of left_foot, right_foot
constexpr double left_hip_fork_p1 = 981.0;

// kg m: mass, com x of left_thigh, right_thigh
constexpr double left_thigh_h1 = 0.14731530912;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, left_ankle_cross,
//     right_thigh, right_ankle_cross; mass, offset z of left_shank, right_shank; offset z of
//     left_foot, right_foot
constexpr double left_thigh_h2 = 3.21901540128;
// kg m: mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank; mass of
//     left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_h3 = 3.62798116128;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; mass,
//     offset z of left_shank, left_foot, right_shank, right_foot; mass of left_ankle_cross,
//     right_ankle_cross
constexpr double left_thigh_I1 = 0.0362798116128;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_thigh, right_thigh; offset
//     z of left_foot, right_foot
constexpr double left_thigh_I2 = 0.0014731530912;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_I3 = 1.2800687125653505;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr double left_thigh_I4 = 0.03939173998083072;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_thigh_I5 = 0.09232168197063167;
// kg m^2: offset z of left_hip_fork, right_hip_fork; mass, com x y, inertia xy, offset y of
//     left_thigh, right_thigh
constexpr double left_thigh_I6 = 0.00442555309711872;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, com x z, inertia xx yy zz, offset z of left_shank, left_ankle_cross,
//     right_shank, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_thigh_I7 = 1.6983864878801518;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; mass, com y z, inertia xz yz, offset y of
//     left_thigh, right_thigh; mass, com y, offset z of left_shank, right_shank; mass, com y z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_thigh_I8 = 0.08414236677063168;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, offset z of left_shank, right_shank; mass, com z of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_thigh_I9 = 1.1033955042453505;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_thigh,
//     right_thigh; mass, offset z of left_shank, right_shank; mass, com z of left_ankle_cross,
//     right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_thigh_I10 = 1.1280459976898918;
// kg m^2: mass, com x, inertia xx yy zz of left_thigh, right_thigh
constexpr double left_thigh_I11 = 0.02465049344454144;
// kg m^2: mass, com x z, inertia xz yz of left_thigh, right_thigh
constexpr double left_thigh_I12 = 0.01969586999041536;
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr double left_thigh_I13 = 0.26256865566306814;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_thigh, right_thigh; mass,
//     com z, offset z of left_shank, right_shank; offset z of left_ankle_cross, left_foot,
//     right_ankle_cross, right_foot
constexpr double left_thigh_I14 = 0.000584786454;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr double left_thigh_I15 = 0.2379181622185267;
// kg m^2: mass, com x z, inertia xx yy zz of left_thigh, right_thigh; offset z of left_shank,
//     right_shank
constexpr double left_thigh_I16 = 0.2872191491076096;
// kg m^2: mass, com z, inertia xx yy zz of left_thigh, right_thigh; mass, offset z of left_shank,
//     right_shank; mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_I17 = 1.3047192060098918;
// N m: gravity; mass, com x of left_thigh, right_thigh
constexpr double left_thigh_G1 = 1.4451631824672;
// N m: gravity; mass, com z of left_thigh, right_thigh; mass, offset z of left_shank, right_shank;
//     mass of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_thigh_G2 = 35.5904951921568;

// m: offset z of left_shank, right_shank
constexpr double left_shank_l1 = 0.432;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_h1 = 0.69434148;
// kg m: mass, com x of left_shank, right_shank
constexpr double left_shank_h2 = 0.080309376;
// kg m: mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_h3 = 1.10425392;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_shank, right_shank; offset
//     z of left_foot, right_foot
constexpr double left_shank_I1 = 0.00080309376;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     offset z of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_shank_I2 = 0.0110425392;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr double left_shank_I3 = 0.03083291102976;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; mass, offset z of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_I4 = 0.350779421733216;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, inertia xz yz of left_shank, right_shank; mass, com y, offset z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_shank_I5 = 0.02565802580712;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y, inertia xy of left_shank, right_shank
constexpr double left_shank_I6 = 0.001559822240256;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com x z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_shank_I7 = 0.36901678842571844;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_shank_I8 = 0.173287335213216;
// kg m^2: mass, com x z, inertia xz yz of left_shank, right_shank
constexpr double left_shank_I9 = 0.01541645551488;
// kg m^2: mass, com x, inertia xx yy zz of left_shank, right_shank
constexpr double left_shank_I10 = 0.005291437550784;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, inertia xz yz of left_shank, right_shank; mass, com y z, offset z of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_I11 = 0.01745977700712;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of left_shank,
//     right_shank; mass, com z, offset z of left_ankle_cross, right_ankle_cross; offset z of
//     left_foot, right_foot
constexpr double left_shank_I12 = 0.178578772764;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I13 = 0.122071088076;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_shank, right_shank; mass,
//     com z, offset z of left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_shank_I14 = 0.000160356;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I15 = 0.127362525626784;
// kg m^2: mass, com x z, inertia xx yy zz of left_shank, right_shank; offset z of left_ankle_cross,
//     right_ankle_cross
constexpr double left_shank_I16 = 0.116779650525216;
// kg m^2: mass, com z, inertia xx yy zz of left_shank, right_shank; mass, offset z of
//     left_ankle_cross, right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_I17 = 0.356070859284;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of left_shank,
//     right_shank; mass, com x z, inertia xx yy zz, offset z of left_ankle_cross,
//     right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot, right_foot
constexpr double left_shank_I18 = 0.3684598849776992;
// N m: gravity; mass, com x of left_shank, right_shank
constexpr double left_shank_G1 = 0.78783497856;
// N m: gravity; mass, com z of left_shank, right_shank; mass, offset z of left_ankle_cross,
//     right_ankle_cross; mass of left_foot, right_foot
constexpr double left_shank_G2 = 10.8327309552;

// kg: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_m1 = 0.94668;
// m: offset z of left_ankle_cross, right_ankle_cross
constexpr double left_ankle_cross_l1 = 0.433;
// kg m: mass, com x of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_ankle_cross_h1 = 0.0550836384;
// kg m: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_h2 = 0.0094668;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I1 = 9.4668e-05;
// kg m^2: offset z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass, com
//     x y of left_ankle_cross, right_ankle_cross; mass, com x of left_foot, right_foot
constexpr double left_ankle_cross_I2 = 0.001106309568;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I3 = 0.000550836384;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com y z, inertia xx yy zz, offset z of
//     left_foot, right_foot
constexpr double left_ankle_cross_I4 = 0.00016012430367330226;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I5 = 0.006303306294895972;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I6 = 0.007654491590934428;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I7 = 0.001099354368;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z of left_ankle_cross,
//     right_ankle_cross; mass, com x, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I8 = 0.000549677184;
// kg m^2: mass, com x, inertia xx yy zz of left_ankle_cross, left_foot, right_ankle_cross,
//     right_foot
constexpr double left_ankle_cross_I9 = 0.0069788989429152;
// kg m^2: mass, com y z of left_ankle_cross, right_ankle_cross
constexpr double left_ankle_cross_I10 = 6.9552e-06;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; offset z of left_foot, right_foot
constexpr double left_ankle_cross_I11 = 2.40212e-05;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I12 = 0.0069548777429152;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I13 = 0.0070029201429152;
// kg m^2: mass, com x, offset z of left_ankle_cross, right_ankle_cross; mass, com x of left_foot,
//     right_foot
constexpr double left_ankle_cross_I14 = 0.0238512154272;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I15 = 0.0068602097429152;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com x z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, com x, inertia xx yy zz, offset z of left_foot,
//     right_foot
constexpr double left_ankle_cross_I16 = 0.0070975881429152;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I17 = 0.0001962912;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com z, inertia xx yy zz of
//     left_ankle_cross, right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_I18 = 0.0001186892;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z of left_ankle_cross, right_ankle_cross; mass, com, inertia xx xy xz yy zz, offset z
//     of left_foot, right_foot
constexpr double left_ankle_cross_I19 = 0.00016602151163904981;
// N m: gravity; mass, com x of left_ankle_cross, left_foot, right_ankle_cross, right_foot
constexpr double left_ankle_cross_G1 = 0.540370492704;
// N m: gravity; offset x of left_hip_fork, right_hip_fork; mass, com z of left_ankle_cross,
//     right_ankle_cross; mass, offset z of left_foot, right_foot
constexpr double left_ankle_cross_G2 = 0.092869308;

// ratio: mass, com y z of left_foot, right_foot
constexpr double left_foot_k1 = 0.2614691411136524;
// ratio: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_k2 = 0.3048946933659078;
// m: points of left_foot, right_foot
constexpr double left_foot_l1 = 0.06;
// m: points of left_foot, right_foot
constexpr double left_foot_l2 = 0.05903;
// m: points of left_foot, right_foot
constexpr double left_foot_l3 = 0.20904;
// kg m: mass, com y z of left_foot, right_foot
constexpr double left_foot_h1 = 0.014128635491404699;
// kg m: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_h2 = 0.0006133509823399522;
// kg m: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_h3 = 0.01411531584561405;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr double left_foot_I1 = 0.00014128635491404698;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_I2 = 6.298136129784905e-05;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_I3 = 0.0014494177603079786;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I4 = 7.233379265339546e-05;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I5 = 0.00013282817963685661;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, offset z of left_foot, right_foot
constexpr double left_foot_I6 = 0.00028257270982809396;
// kg m^2: offset x z of left_hip_fork, right_hip_fork; offset y of left_thigh, right_thigh; mass,
//     com y z, offset z of left_foot, right_foot
constexpr double left_foot_I7 = 0.0005651454196561879;
// kg m^2: offset x of left_hip_fork, right_hip_fork; mass, com y z, offset z of left_foot,
//     right_foot
constexpr double left_foot_I8 = 0.00028257270982809396;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I9 = 0.0009809787164016;
// kg m^2: offset z of left_shank, right_shank; mass, com y z of left_foot, right_foot
constexpr double left_foot_I10 = 0.00610357053228683;
// kg m^2: offset x of left_hip_fork, right_hip_fork; offset z of left_ankle_cross,
//     right_ankle_cross; mass, com y z, offset z of left_foot, right_foot
constexpr double left_foot_I11 = 0.006117699167778235;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I12 = 0.0005569034480192284;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I13 = 0.0004240752683823717;
// kg m^2: mass, com y z, inertia xx yy zz of left_foot, right_foot
constexpr double left_foot_I14 = 3.616689632669773e-05;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I15 = 0.0001386019001723616;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I16 = 6.053937672190036e-05;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I17 = 0.0005597903082869808;
// kg m^2: mass, com, inertia xy xz of left_foot, right_foot
constexpr double left_foot_I18 = 0.001450785475446707;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I19 = 0.0004211884081146192;
// kg m^2: mass, com, inertia xx xy xz yy zz of left_foot, right_foot
constexpr double left_foot_I20 = 3.026968836095018e-05;
// N m: gravity; mass, com y z of left_foot, right_foot
constexpr double left_foot_G1 = 0.1386019141706801;

}  // namespace

// Lengths inside are in units of L, a distance between left_hip_roll and left_hip_pitch:
//   L = 0.01 m
// Names: vectors h_ in kg m^2/L, s_ in L; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void mass_matrix(const Scalar q[12], Scalar A[144]) noexcept {
  const auto p_s_left_hip_roll = sine_cosine(q[1]);
  const Scalar& s_left_hip_roll = p_s_left_hip_roll.sine;
  const Scalar& c_left_hip_roll = p_s_left_hip_roll.cosine;
  // left_shank: way s to the joint of (2)
  const auto p_s_left_hip_pitch = sine_cosine(q[2]);
  const Scalar& s_left_hip_pitch = p_s_left_hip_pitch.sine;
  const Scalar& c_left_hip_pitch = p_s_left_hip_pitch.cosine;
  const Scalar t_left_shank_1 = left_hip_fork_k1 * s_left_hip_pitch;
  const Scalar t_left_shank_2 = left_hip_fork_k1 * c_left_hip_pitch;
  // left_ankle_cross: A, way s to the joint of (2)
  const Scalar q_q2_q3 = q[2] + q[3];
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const auto p_s_q2_q3_q4 = sine_cosine(q_q2_q3_q4);
  const Scalar& s_q2_q3_q4 = p_s_q2_q3_q4.sine;
  const Scalar& c_q2_q3_q4 = p_s_q2_q3_q4.cosine;
  const auto p_s_q2_q3 = sine_cosine(q_q2_q3);
  const Scalar& s_q2_q3 = p_s_q2_q3.sine;
  const Scalar& c_q2_q3 = p_s_q2_q3.cosine;
  const Scalar t_left_ankle_cross_1 = left_hip_fork_k2 * s_q2_q3;
  const Scalar t_left_ankle_cross_2 = left_hip_fork_k2 * c_q2_q3;
  const Scalar t_left_foot_1 = left_foot_k1 + q[5];
  const auto p_s_left_foot = sine_cosine(t_left_foot_1);
  const Scalar& s_left_foot = p_s_left_foot.sine;
  const Scalar& c_left_foot = p_s_left_foot.cosine;
  const auto p_s_right_hip_roll = sine_cosine(q[7]);
  const Scalar& s_right_hip_roll = p_s_right_hip_roll.sine;
  const Scalar& c_right_hip_roll = p_s_right_hip_roll.cosine;
  // right_shank: way s to the joint of (2)
  const auto p_s_right_hip_pitch = sine_cosine(q[8]);
  const Scalar& s_right_hip_pitch = p_s_right_hip_pitch.sine;
  const Scalar& c_right_hip_pitch = p_s_right_hip_pitch.cosine;
  const Scalar t_right_shank_1 = left_hip_fork_k1 * c_right_hip_pitch;
  const Scalar t_right_shank_2 = left_hip_fork_k1 * s_right_hip_pitch;
  // right_ankle_cross: A, way s to the joint of (2)
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const auto p_s_q8_q9_q10 = sine_cosine(q_q8_q9_q10);
  const Scalar& s_q8_q9_q10 = p_s_q8_q9_q10.sine;
  const Scalar& c_q8_q9_q10 = p_s_q8_q9_q10.cosine;
  const auto p_s_q8_q9 = sine_cosine(q_q8_q9);
  const Scalar& s_q8_q9 = p_s_q8_q9.sine;
  const Scalar& c_q8_q9 = p_s_q8_q9.cosine;
  const Scalar t_righ_ankl_cros_1 = left_hip_fork_k2 * s_q8_q9;
  const Scalar t_righ_ankl_cros_2 = left_hip_fork_k2 * c_q8_q9;
  // right_foot: A, first moment h of (2)
  const Scalar t_right_foot_1 = left_foot_k1 - q[11];
  const auto p_s_right_foot = sine_cosine(t_right_foot_1);
  const Scalar& s_right_foot = p_s_right_foot.sine;
  const Scalar& c_right_foot = p_s_right_foot.cosine;
  const Scalar t_right_foot_2 = left_foot_I1 * c_right_foot;
  const Scalar t_right_foot_3 = left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_4 = left_foot_I4 * c_right_foot + left_foot_I5 * s_right_foot;
  const Scalar t_right_foot_5 = s_right_foot * t_right_foot_4;
  const Scalar t_right_foot_6 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_7 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  A[131] = t_right_foot_7;
  A[142] = A[131];
  // right_ankle_cross: first moment h, A, pseudo-inertia E of (2)
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_I1 + t_right_foot_2;
  const Scalar t_righ_ankl_cros_3 = left_ankle_cross_I3 * s_q8_q9_q10;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 + c_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_5 = left_ankle_cross_I3 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_6 = t_righ_ankl_cros_5 - s_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_7 = c_right_foot * (left_foot_I6 + t_right_foot_4);
  const Scalar t_righ_ankl_cros_8 = left_ankle_cross_I4 + t_right_foot_3 + t_righ_ankl_cros_7;
  const Scalar E_righ_ankl_cros_yz = left_ankle_cross_I2 + t_right_foot_7;
  const Scalar t_righ_ankl_cros_9 = s_q8_q9_q10 * t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_9 - c_q8_q9_q10 * E_righ_ankl_cros_yz;
  A[94] = -t_righ_ankl_cros_10;
  A[127] = A[94];
  const Scalar t_righ_ankl_cros_11 = t_righ_ankl_cros_2 * t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_12 = t_righ_ankl_cros_1 * t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_13 = 2.0 * t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_14 = t_right_foot_5 - left_foot_I8 * c_right_foot;
  const Scalar t_righ_ankl_cros_15 = left_ankle_cross_I6 - t_righ_ankl_cros_14;
  A[130] = t_righ_ankl_cros_15;
  // right_shank: pseudo-inertia E, A of (2)
  const Scalar t_right_shank_3 = left_shank_I5 + left_foot_I11 * s_right_foot;
  const Scalar t_right_shank_4 = t_righ_ankl_cros_10 + left_shank_I6 * c_q8_q9;
  const Scalar E_right_shank_yz = t_right_shank_4 + s_q8_q9 * t_right_shank_3;
  A[93] = -E_right_shank_yz;
  A[115] = A[93];
  const Scalar t_right_shank_5 = t_righ_ankl_cros_14 - 2.0 * t_righ_ankl_cros_11;
  const Scalar t_right_shank_6 = t_right_shank_5 - (left_shank_I7 - t_righ_ankl_cros_13);
  A[117] = -t_right_shank_6;
  const Scalar t_righ_ankl_cros_16 = t_righ_ankl_cros_4 - left_shank_I1 * s_q8_q9;
  const Scalar t_righ_ankl_cros_17 = t_righ_ankl_cros_16 + left_shank_I2 * c_q8_q9;
  const Scalar t_right_shank_7 = t_right_shank_1 * t_righ_ankl_cros_17;
  const Scalar t_right_thigh_1 = left_thigh_I5 + left_foot_I10 * s_right_foot;
  const Scalar t_righ_ankl_cros_18 = c_q8_q9_q10 * t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_19 = s_q8_q9_q10 * E_righ_ankl_cros_yz + t_righ_ankl_cros_18;
  const Scalar t_right_shank_8 = t_righ_ankl_cros_19 - left_shank_I6 * s_q8_q9;
  const Scalar E_right_shank_xz = t_right_shank_8 + c_q8_q9 * t_right_shank_3;
  // right_thigh: pseudo-inertia E, A of (2)
  const Scalar t_right_thigh_2 = E_right_shank_xz - left_thigh_I6 * s_right_hip_pitch;
  const Scalar E_right_thigh_xz = t_right_thigh_2 + c_right_hip_pitch * t_right_thigh_1;
  const Scalar t_right_thigh_3 = E_right_shank_yz + left_thigh_I6 * c_right_hip_pitch;
  const Scalar E_right_thigh_yz = t_right_thigh_3 + s_right_hip_pitch * t_right_thigh_1;
  A[92] = -E_right_thigh_yz;
  A[103] = A[92];
  const Scalar t_right_thigh_4 = t_right_shank_5 - 2.0 * t_right_shank_7;
  // right_shank: first moment h, A of (2)
  const Scalar t_right_shank_9 = t_righ_ankl_cros_6 - left_shank_I2 * s_q8_q9;
  const Scalar h_right_shank_y = t_right_shank_9 - left_shank_I1 * c_q8_q9;
  const Scalar t_right_shank_10 = t_right_shank_2 * h_right_shank_y;
  // right_thigh: A of (2)
  const Scalar t_right_thigh_5 = t_righ_ankl_cros_13 + t_right_thigh_4;
  const Scalar t_right_thigh_6 = t_right_thigh_5 + 2.0 * t_right_shank_10;
  const Scalar t_right_thigh_7 = left_thigh_I7 - t_right_thigh_6;
  A[104] = t_right_thigh_7;
  const Scalar t_right_shank_11 = left_thigh_I3 * s_right_hip_pitch;
  const Scalar t_right_shank_12 = t_right_shank_11 + left_thigh_I4 * c_right_hip_pitch;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_20 = c_q8_q9_q10 * t_right_foot_6;
  const Scalar t_righ_ankl_cros_21 = left_ankle_cross_I7 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_22 = s_q8_q9_q10 * (left_ankle_cross_I5 + t_righ_ankl_cros_14);
  const Scalar t_righ_ankl_cros_23 = t_righ_ankl_cros_21 - 2.0 * t_righ_ankl_cros_20;
  const Scalar t_righ_ankl_cros_24 = t_righ_ankl_cros_23 + t_righ_ankl_cros_22;
  const Scalar t_right_hip_fork_1 = left_hip_fork_k1 * h_right_shank_y;
  const Scalar t_righ_ankl_cros_25 = left_shank_I3 * c_q8_q9 + left_shank_I4 * s_q8_q9;
  // right_hip_fork: pseudo-inertia E, A of (2)
  const Scalar t_right_hip_fork_2 = left_hip_fork_I2 + t_right_foot_6 + t_righ_ankl_cros_17;
  const Scalar t_right_hip_fork_3 = left_thigh_I1 - t_right_shank_12 + t_right_hip_fork_1;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_2 + c_q8_q9_q10 * t_righ_ankl_cros_24;
  const Scalar t_right_hip_fork_5 = c_right_hip_pitch * t_right_hip_fork_3;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_4 + t_right_hip_fork_5;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_6 - c_q8_q9 * t_righ_ankl_cros_25;
  const Scalar t_righ_ankl_cros_26 = t_righ_ankl_cros_2 * t_righ_ankl_cros_6;
  const Scalar t_right_hip_fork_8 = left_thigh_I2 + left_hip_fork_k1 * t_righ_ankl_cros_17;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_7 + t_righ_ankl_cros_26;
  const Scalar t_right_hip_fork_10 = s_right_hip_pitch * t_right_hip_fork_8;
  const Scalar t_right_hip_fork_11 = t_right_hip_fork_9 - t_right_hip_fork_10;
  const Scalar t_righ_ankl_cros_27 = t_righ_ankl_cros_1 * t_righ_ankl_cros_4;
  const Scalar t_right_hip_fork_12 = E_right_thigh_yz - (left_hip_fork_I1 + t_right_foot_3);
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_11 - t_righ_ankl_cros_27;
  A[79] = c_right_hip_roll * t_right_hip_fork_13 - s_right_hip_roll * t_right_hip_fork_12;
  A[90] = A[79];
  const Scalar t_right_hip_fork_14 = t_right_foot_5 + left_foot_I7 * s_right_foot;
  const Scalar t_right_hip_fork_15 = t_right_thigh_4 - s_q8_q9_q10 * t_righ_ankl_cros_24;
  const Scalar t_right_hip_fork_16 = t_right_hip_fork_15 + s_right_hip_pitch * t_right_shank_12;
  const Scalar t_right_hip_fork_17 = t_right_hip_fork_16 + s_q8_q9 * t_righ_ankl_cros_25;
  A[91] = left_hip_fork_I4 + t_right_hip_fork_14 - t_right_hip_fork_17;
  const Scalar t_right_hip_fork_18 = left_hip_fork_I5 - t_right_hip_fork_14;
  const Scalar t_right_hip_fork_19 = t_right_hip_fork_17 - t_right_hip_fork_18;
  const Scalar t_right_hip_fork_20 = left_hip_fork_I3 + 2.0 * E_right_thigh_xz;
  const Scalar t_right_hip_fork_21 = c_right_hip_roll * t_right_hip_fork_19;
  const Scalar t_right_hip_fork_22 = s_right_hip_roll * t_right_hip_fork_20;
  const Scalar t_right_thigh_8 = h_right_shank_y - left_thigh_I1 * s_right_hip_pitch;
  const Scalar h_right_thigh_y = t_right_thigh_8 - left_thigh_I2 * c_right_hip_pitch;
  const Scalar t_right_hip_fork_23 = t_right_hip_fork_21 - t_right_hip_fork_22;
  const Scalar t_right_hip_fork_24 = c_right_hip_roll * t_right_hip_fork_23;
  A[78] = left_hip_block_I1 - t_right_thigh_6 + t_right_hip_fork_24 + 2.0 * h_right_thigh_y;
  const Scalar t_left_foot_2 = left_foot_I1 * c_left_foot;
  const Scalar h_left_ankle_cross_z = left_foot_I1 * s_left_foot;
  // left_foot: A of (2)
  const Scalar t_left_foot_3 = left_foot_I4 * c_left_foot + left_foot_I5 * s_left_foot;
  const Scalar t_left_foot_4 = s_left_foot * t_left_foot_3;
  const Scalar t_left_foot_5 = left_foot_I2 * c_left_foot + left_foot_I3 * s_left_foot;
  A[53] = -t_left_foot_5;
  A[64] = A[53];
  const Scalar t_left_foot_6 = left_foot_I3 * c_left_foot - left_foot_I2 * s_left_foot;
  // left_ankle_cross: first moment h, A, pseudo-inertia E of (2)
  const Scalar h_left_ankle_cross_x = left_ankle_cross_I1 + t_left_foot_2;
  const Scalar t_left_ankle_cross_3 = s_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_4 = left_ankle_cross_I3 * c_q2_q3_q4 - t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_5 = c_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_6 = left_ankle_cross_I3 * s_q2_q3_q4 + t_left_ankle_cross_5;
  const Scalar t_left_ankle_cross_7 = c_left_foot * (left_foot_I6 + t_left_foot_3);
  const Scalar t_left_ankle_cross_8 = left_ankle_cross_I4 + h_left_ankle_cross_z;
  const Scalar E_left_ankle_cross_xz = t_left_ankle_cross_8 + t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_9 = left_ankle_cross_I2 + t_left_foot_5;
  const Scalar t_left_ankle_cross_10 = c_q2_q3_q4 * t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_11 = s_q2_q3_q4 * E_left_ankle_cross_xz - t_left_ankle_cross_10;
  A[16] = t_left_ankle_cross_11;
  A[49] = A[16];
  const Scalar t_left_ankle_cross_12 = t_left_ankle_cross_1 * t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_13 = t_left_ankle_cross_2 * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_14 = t_left_foot_4 - left_foot_I8 * c_left_foot;
  const Scalar t_left_ankle_cross_15 = left_ankle_cross_I6 - t_left_ankle_cross_14;
  A[52] = t_left_ankle_cross_15;
  // left_shank: pseudo-inertia E, A, first moment h of (2)
  const Scalar t_left_shank_3 = left_shank_I5 + left_foot_I11 * s_left_foot;
  const Scalar t_left_shank_4 = t_left_ankle_cross_11 + left_shank_I6 * c_q2_q3;
  const Scalar t_left_shank_5 = t_left_shank_4 + s_q2_q3 * t_left_shank_3;
  A[15] = t_left_shank_5;
  A[37] = A[15];
  const Scalar t_left_shank_6 = t_left_ankle_cross_14 - 2.0 * t_left_ankle_cross_13;
  const Scalar t_left_shank_7 = t_left_shank_6 + 2.0 * t_left_ankle_cross_12;
  const Scalar t_left_shank_8 = left_shank_I7 - t_left_shank_7;
  A[39] = t_left_shank_8;
  const Scalar t_left_ankle_cross_16 = t_left_ankle_cross_6 - left_shank_I1 * s_q2_q3;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_16 + left_shank_I2 * c_q2_q3;
  const Scalar t_left_shank_9 = t_left_shank_2 * t_left_ankle_cross_17;
  const Scalar t_left_shank_10 = 2.0 * t_left_shank_9;
  const Scalar t_left_shank_11 = t_left_ankle_cross_4 - left_shank_I2 * s_q2_q3;
  const Scalar h_left_shank_y = t_left_shank_11 - left_shank_I1 * c_q2_q3;
  const Scalar t_left_shank_12 = t_left_shank_1 * h_left_shank_y;
  const Scalar t_left_thigh_1 = left_thigh_I5 + left_foot_I10 * s_left_foot;
  const Scalar t_left_ankle_cross_18 = s_q2_q3_q4 * t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_19 = c_q2_q3_q4 * E_left_ankle_cross_xz + t_left_ankle_cross_18;
  const Scalar t_left_shank_13 = t_left_ankle_cross_19 - left_shank_I6 * s_q2_q3;
  const Scalar t_left_shank_14 = t_left_shank_13 + c_q2_q3 * t_left_shank_3;
  // left_thigh: pseudo-inertia E, A of (2)
  const Scalar t_left_thigh_2 = t_left_shank_14 - left_thigh_I6 * s_left_hip_pitch;
  const Scalar t_left_thigh_3 = t_left_thigh_2 + c_left_hip_pitch * t_left_thigh_1;
  const Scalar t_left_thigh_4 = t_left_shank_5 + left_thigh_I6 * c_left_hip_pitch;
  const Scalar t_left_thigh_5 = t_left_thigh_4 + s_left_hip_pitch * t_left_thigh_1;
  A[14] = t_left_thigh_5;
  A[25] = A[14];
  const Scalar t_left_thigh_6 = t_left_shank_7 - t_left_shank_10 + 2.0 * t_left_shank_12;
  const Scalar t_left_thigh_7 = left_thigh_I7 - t_left_thigh_6;
  A[26] = t_left_thigh_7;
  const Scalar t_left_ankle_cross_20 = left_shank_I3 * c_q2_q3 + left_shank_I4 * s_q2_q3;
  const Scalar t_left_hip_fork_1 = left_hip_fork_k2 * t_left_ankle_cross_4;
  const Scalar E_left_hip_fork_yz = t_left_thigh_5 - (left_hip_fork_I1 + h_left_ankle_cross_z);
  // left_ankle_cross
  const Scalar t_left_ankle_cross_21 = s_q2_q3_q4 * (left_ankle_cross_I5 + t_left_ankle_cross_14);
  const Scalar t_left_ankle_cross_22 = c_q2_q3_q4 * (left_ankle_cross_I7 + 2.0 * t_left_foot_6);
  const Scalar t_left_ankle_cross_23 = t_left_ankle_cross_21 + t_left_ankle_cross_22;
  const Scalar t_left_shank_15 = left_thigh_I4 * c_left_hip_pitch;
  const Scalar t_left_shank_16 = t_left_shank_15 + left_thigh_I3 * s_left_hip_pitch;
  // left_hip_fork: pseudo-inertia E, A of (2)
  const Scalar t_left_hip_fork_2 = left_hip_fork_I2 - t_left_foot_6 + t_left_ankle_cross_17;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 + c_q2_q3_q4 * t_left_ankle_cross_23;
  const Scalar t_left_hip_fork_4 = left_thigh_I2 + left_hip_fork_k1 * t_left_ankle_cross_17;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_3 + t_left_shank_2 * h_left_shank_y;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_5 - s_left_hip_pitch * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_7 = c_q2_q3 * (t_left_ankle_cross_20 - t_left_hip_fork_1);
  const Scalar t_left_hip_fork_8 = c_left_hip_pitch * (left_thigh_I1 - t_left_shank_16);
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_6 - t_left_hip_fork_7;
  const Scalar t_left_ankle_cross_24 = t_left_ankle_cross_1 * t_left_ankle_cross_6;
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_9 + t_left_hip_fork_8;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_10 - t_left_ankle_cross_24;
  A[1] = s_left_hip_roll * E_left_hip_fork_yz + c_left_hip_roll * t_left_hip_fork_11;
  A[12] = A[1];
  const Scalar t_left_hip_fork_12 = t_left_foot_4 + left_foot_I7 * s_left_foot;
  const Scalar t_left_hip_fork_13 = t_left_shank_6 - t_left_shank_10;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_13 + s_left_hip_pitch * t_left_shank_16;
  const Scalar t_left_hip_fork_15 = t_left_hip_fork_14 - s_q2_q3_q4 * t_left_ankle_cross_23;
  const Scalar t_left_hip_fork_16 = t_left_hip_fork_15 + s_q2_q3 * t_left_ankle_cross_20;
  A[13] = left_hip_fork_I4 + t_left_hip_fork_12 - t_left_hip_fork_16;
  const Scalar t_left_thigh_8 = h_left_shank_y - left_thigh_I1 * s_left_hip_pitch;
  const Scalar h_left_thigh_y = t_left_thigh_8 - left_thigh_I2 * c_left_hip_pitch;
  const Scalar t_left_hip_fork_17 = t_left_hip_fork_16 - (left_hip_fork_I5 - t_left_hip_fork_12);
  const Scalar t_left_hip_fork_18 = s_left_hip_roll * (left_hip_fork_I3 + 2.0 * t_left_thigh_3);
  const Scalar t_left_hip_fork_19 = t_left_hip_fork_18 + c_left_hip_roll * t_left_hip_fork_17;
  const Scalar t_left_hip_block_1 = left_hip_block_I1 - t_left_thigh_6 + 2.0 * h_left_thigh_y;
  A[0] = t_left_hip_block_1 + c_left_hip_roll * t_left_hip_fork_19;
  // right_ankle_cross: A of (2)
  const Scalar t_righ_ankl_cros_28 = c_q8_q9_q10 * t_right_foot_3;
  const Scalar t_righ_ankl_cros_29 = s_q8_q9_q10 * t_right_foot_3;
  const Scalar t_righ_ankl_cros_30 = t_righ_ankl_cros_1 * t_righ_ankl_cros_28;
  const Scalar t_righ_ankl_cros_31 = t_righ_ankl_cros_2 * t_righ_ankl_cros_29;
  const Scalar t_righ_ankl_cros_32 = t_right_foot_7 - t_righ_ankl_cros_30;
  const Scalar t_righ_ankl_cros_33 = t_righ_ankl_cros_32 + t_righ_ankl_cros_31;
  A[119] = t_righ_ankl_cros_33;
  A[141] = A[119];
  const Scalar t_right_foot_8 = left_foot_I9 + t_right_foot_2 + left_foot_I6 * s_right_foot;
  // right_shank: A of (2)
  const Scalar t_right_shank_13 = t_right_foot_2 * (t_right_shank_1 + t_righ_ankl_cros_2);
  A[95] = c_q8_q9_q10 * t_right_foot_8 + t_right_shank_13 - s_q8_q9_q10 * t_right_foot_6;
  A[139] = A[95];
  const Scalar t_right_shank_14 = t_righ_ankl_cros_33 + t_right_shank_1 * t_righ_ankl_cros_29;
  const Scalar t_right_shank_15 = t_right_shank_14 - t_right_shank_2 * t_righ_ankl_cros_28;
  A[107] = t_right_shank_15;
  A[140] = A[107];
  const Scalar t_right_thigh_9 = t_righ_ankl_cros_1 - (1.0 - t_right_shank_2);
  const Scalar t_righ_ankl_cros_34 = t_righ_ankl_cros_20 + s_q8_q9_q10 * t_right_foot_8;
  const Scalar t_right_thigh_10 = t_righ_ankl_cros_34 + t_right_foot_2 * t_right_thigh_9;
  const Scalar t_right_hip_fork_25 = s_right_hip_roll * (t_righ_ankl_cros_28 + t_right_shank_15);
  A[83] = t_right_hip_fork_25 - c_right_hip_roll * t_right_thigh_10;
  A[138] = A[83];
  const Scalar t_righ_ankl_cros_35 = t_righ_ankl_cros_11 - t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_36 = t_righ_ankl_cros_15 + t_righ_ankl_cros_35;
  A[118] = t_righ_ankl_cros_36;
  A[129] = A[118];
  const Scalar t_right_shank_16 = t_righ_ankl_cros_36 - t_right_shank_2 * t_righ_ankl_cros_6;
  const Scalar t_right_shank_17 = t_right_shank_16 + t_right_shank_1 * t_righ_ankl_cros_4;
  A[106] = t_right_shank_17;
  A[128] = A[106];
  const Scalar t_right_hip_fork_26 = s_right_hip_roll * (t_righ_ankl_cros_6 + t_right_shank_17);
  A[82] = t_right_hip_fork_26 - c_right_hip_roll * t_righ_ankl_cros_19;
  A[126] = A[82];
  const Scalar t_right_shank_18 = t_right_shank_6 - t_right_shank_7 + t_right_shank_10;
  A[105] = -t_right_shank_18;
  A[116] = A[105];
  // right_hip_fork: A of (2)
  const Scalar t_right_hip_fork_27 = s_right_hip_roll * (h_right_shank_y - t_right_shank_18);
  A[81] = t_right_hip_fork_27 - c_right_hip_roll * E_right_shank_xz;
  A[114] = A[81];
  const Scalar t_right_hip_fork_28 = s_right_hip_roll * (t_right_thigh_7 + h_right_thigh_y);
  A[80] = t_right_hip_fork_28 - c_right_hip_roll * E_right_thigh_xz;
  A[102] = A[80];
  // left_ankle_cross: A of (2)
  const Scalar t_left_ankle_cross_25 = s_q2_q3_q4 * h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_26 = c_q2_q3_q4 * h_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_27 = t_left_ankle_cross_2 * t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_28 = t_left_ankle_cross_1 * t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_29 = t_left_foot_5 + t_left_ankle_cross_27;
  const Scalar t_left_ankle_cross_30 = t_left_ankle_cross_29 - t_left_ankle_cross_28;
  A[41] = -t_left_ankle_cross_30;
  A[63] = A[41];
  const Scalar t_left_foot_7 = left_foot_I9 + t_left_foot_2 + left_foot_I6 * s_left_foot;
  // left_shank: A of (2)
  const Scalar t_left_shank_17 = t_left_foot_2 * (t_left_shank_2 + t_left_ankle_cross_2);
  A[17] = c_q2_q3_q4 * t_left_foot_7 + s_q2_q3_q4 * t_left_foot_6 + t_left_shank_17;
  A[61] = A[17];
  const Scalar t_left_shank_18 = t_left_shank_1 * t_left_ankle_cross_26;
  const Scalar t_left_shank_19 = t_left_ankle_cross_30 - t_left_shank_18;
  const Scalar t_left_shank_20 = t_left_shank_19 + t_left_shank_2 * t_left_ankle_cross_25;
  A[29] = -t_left_shank_20;
  A[62] = A[29];
  const Scalar t_left_thigh_9 = t_left_ankle_cross_1 - (1.0 - t_left_shank_1);
  const Scalar t_left_ankle_cross_31 = c_q2_q3_q4 * t_left_foot_6 - s_q2_q3_q4 * t_left_foot_7;
  const Scalar t_left_thigh_10 = t_left_ankle_cross_31 - t_left_foot_2 * t_left_thigh_9;
  const Scalar t_left_hip_fork_20 = s_left_hip_roll * (t_left_ankle_cross_26 + t_left_shank_20);
  A[5] = c_left_hip_roll * t_left_thigh_10 - t_left_hip_fork_20;
  A[60] = A[5];
  const Scalar t_left_ankle_cross_32 = t_left_ankle_cross_12 - t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_33 = t_left_ankle_cross_15 - t_left_ankle_cross_32;
  A[40] = t_left_ankle_cross_33;
  A[51] = A[40];
  const Scalar t_left_shank_21 = t_left_shank_1 * t_left_ankle_cross_4;
  const Scalar t_left_shank_22 = t_left_ankle_cross_33 - t_left_shank_21;
  const Scalar t_left_shank_23 = t_left_shank_22 + t_left_shank_2 * t_left_ankle_cross_6;
  A[28] = t_left_shank_23;
  A[50] = A[28];
  const Scalar t_left_hip_fork_21 = s_left_hip_roll * (t_left_ankle_cross_4 + t_left_shank_23);
  A[4] = t_left_hip_fork_21 + c_left_hip_roll * t_left_ankle_cross_19;
  A[48] = A[4];
  const Scalar t_left_shank_24 = t_left_shank_12 - (t_left_shank_8 + t_left_shank_9);
  A[27] = -t_left_shank_24;
  A[38] = A[27];
  // left_hip_fork: A of (2)
  const Scalar t_left_hip_fork_22 = s_left_hip_roll * (h_left_shank_y - t_left_shank_24);
  A[3] = c_left_hip_roll * t_left_shank_14 + t_left_hip_fork_22;
  A[36] = A[3];
  const Scalar t_left_hip_fork_23 = s_left_hip_roll * (t_left_thigh_7 + h_left_thigh_y);
  A[2] = t_left_hip_fork_23 + c_left_hip_roll * t_left_thigh_3;
  A[24] = A[2];
  A[65] = left_foot_I9;
  A[143] = left_foot_I9;
  A[6] = 0.0;
  A[7] = 0.0;
  A[8] = 0.0;
  A[9] = 0.0;
  A[10] = 0.0;
  A[11] = 0.0;
  A[18] = 0.0;
  A[19] = 0.0;
  A[20] = 0.0;
  A[21] = 0.0;
  A[22] = 0.0;
  A[23] = 0.0;
  A[30] = 0.0;
  A[31] = 0.0;
  A[32] = 0.0;
  A[33] = 0.0;
  A[34] = 0.0;
  A[35] = 0.0;
  A[42] = 0.0;
  A[43] = 0.0;
  A[44] = 0.0;
  A[45] = 0.0;
  A[46] = 0.0;
  A[47] = 0.0;
  A[54] = 0.0;
  A[55] = 0.0;
  A[56] = 0.0;
  A[57] = 0.0;
  A[58] = 0.0;
  A[59] = 0.0;
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
  A[84] = 0.0;
  A[85] = 0.0;
  A[86] = 0.0;
  A[87] = 0.0;
  A[88] = 0.0;
  A[89] = 0.0;
  A[96] = 0.0;
  A[97] = 0.0;
  A[98] = 0.0;
  A[99] = 0.0;
  A[100] = 0.0;
  A[101] = 0.0;
  A[108] = 0.0;
  A[109] = 0.0;
  A[110] = 0.0;
  A[111] = 0.0;
  A[112] = 0.0;
  A[113] = 0.0;
  A[120] = 0.0;
  A[121] = 0.0;
  A[122] = 0.0;
  A[123] = 0.0;
  A[124] = 0.0;
  A[125] = 0.0;
  A[132] = 0.0;
  A[133] = 0.0;
  A[134] = 0.0;
  A[135] = 0.0;
  A[136] = 0.0;
  A[137] = 0.0;
}

void bias_force(const Scalar q[12], const Scalar qd[12], Scalar B[12]) noexcept {
  const Scalar q_q3_q4 = q[3] + q[4];
  // left_thigh: angular velocity omega of (3)
  const Scalar q_q2_q3_q4 = q[2] + q_q3_q4;
  const auto p_s_q2_q3_q4 = sine_cosine(q_q2_q3_q4);
  const Scalar& s_q2_q3_q4 = p_s_q2_q3_q4.sine;
  const Scalar& c_q2_q3_q4 = p_s_q2_q3_q4.cosine;
  const auto p_s_left_hip_roll = sine_cosine(q[1]);
  const Scalar& s_left_hip_roll = p_s_left_hip_roll.sine;
  const Scalar& c_left_hip_roll = p_s_left_hip_roll.cosine;
  // left_shank: way s to the joint of (3)
  const auto p_s_q3_q4 = sine_cosine(q_q3_q4);
  const Scalar& s_q3_q4 = p_s_q3_q4.sine;
  const Scalar& c_q3_q4 = p_s_q3_q4.cosine;
  const Scalar t_left_shank_1 = left_shank_l1 * s_q3_q4;
  const Scalar s_left_shank_x = left_shank_l1 * c_q3_q4;
  // left_ankle_cross: way s to the joint of (3)
  const auto p_s_left_ankle_pitch = sine_cosine(q[4]);
  const Scalar& s_left_ankle_pitch = p_s_left_ankle_pitch.sine;
  const Scalar& c_left_ankle_pitch = p_s_left_ankle_pitch.cosine;
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_l1 * s_left_ankle_pitch;
  const Scalar s_left_ankle_cross_x = left_ankle_cross_l1 * c_left_ankle_pitch;
  const Scalar q_q9_q10 = q[9] + q[10];
  // right_thigh: angular velocity omega of (3)
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const auto p_s_q8_q9_q10 = sine_cosine(q_q8_q9_q10);
  const Scalar& s_q8_q9_q10 = p_s_q8_q9_q10.sine;
  const Scalar& c_q8_q9_q10 = p_s_q8_q9_q10.cosine;
  const auto p_s_right_hip_roll = sine_cosine(q[7]);
  const Scalar& s_right_hip_roll = p_s_right_hip_roll.sine;
  const Scalar& c_right_hip_roll = p_s_right_hip_roll.cosine;
  // right_shank: way s to the joint of (3)
  const auto p_s_q9_q10 = sine_cosine(q_q9_q10);
  const Scalar& s_q9_q10 = p_s_q9_q10.sine;
  const Scalar& c_q9_q10 = p_s_q9_q10.cosine;
  const Scalar t_right_shank_1 = left_shank_l1 * s_q9_q10;
  const Scalar s_right_shank_x = left_shank_l1 * c_q9_q10;
  // right_ankle_cross: way s to the joint of (3)
  const auto p_s_right_ankle_pitch = sine_cosine(q[10]);
  const Scalar& s_right_ankle_pitch = p_s_right_ankle_pitch.sine;
  const Scalar& c_right_ankle_pitch = p_s_right_ankle_pitch.cosine;
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_l1 * s_right_ankle_pitch;
  const Scalar s_righ_ankl_cros_x = left_ankle_cross_l1 * c_right_ankle_pitch;
  // left_thigh: angular velocity omega, Omega, angular acceleration alpha of (3)
  const Scalar t_left_thigh_1 = s_q2_q3_q4 * qd[1];
  const Scalar t_left_thigh_2 = c_left_hip_roll * qd[0];
  const Scalar t_left_thigh_3 = t_left_thigh_1 + c_q2_q3_q4 * t_left_thigh_2;
  const Scalar t_left_thigh_4 = t_left_thigh_3 * t_left_thigh_3;
  const Scalar t_left_thigh_5 = c_q2_q3_q4 * qd[1];
  const Scalar t_left_thigh_6 = t_left_thigh_5 - s_q2_q3_q4 * t_left_thigh_2;
  const Scalar t_left_thigh_7 = t_left_thigh_6 * t_left_thigh_6;
  const Scalar t_left_thigh_8 = t_left_thigh_4 + t_left_thigh_7;
  const Scalar t_left_thigh_9 = s_left_hip_roll * qd[0];
  const Scalar omega_left_thigh_z = t_left_thigh_9 + qd[2];
  const Scalar t_left_thigh_10 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_11 = t_left_thigh_7 + t_left_thigh_10;
  const Scalar t_left_thigh_12 = t_left_thigh_6 * omega_left_thigh_z;
  const Scalar alpha_left_thigh_x = t_left_thigh_5 * t_left_thigh_9 - t_left_thigh_6 * qd[2];
  const Scalar t_left_thigh_13 = t_left_thigh_12 - alpha_left_thigh_x;
  const Scalar t_left_thigh_14 = t_left_thigh_3 * omega_left_thigh_z;
  const Scalar t_left_thigh_15 = t_left_thigh_1 * t_left_thigh_9 - t_left_thigh_3 * qd[2];
  const Scalar t_left_foot_1 = t_left_thigh_14 + t_left_thigh_15;
  const Scalar t_left_thigh_16 = t_left_thigh_14 - t_left_thigh_15;
  const Scalar t_left_thigh_17 = t_left_thigh_12 + alpha_left_thigh_x;
  const Scalar t_left_thigh_18 = t_left_thigh_3 * t_left_thigh_6;
  const Scalar alpha_left_thigh_z = qd[1] * t_left_thigh_2;
  const Scalar Omega_left_thigh_yx = t_left_thigh_18 + alpha_left_thigh_z;
  const Scalar Omega_left_thigh_xy = t_left_thigh_18 - alpha_left_thigh_z;
  const Scalar t_left_thigh_19 = qd[0] * qd[0] * left_hip_fork_l1;
  const Scalar a_left_thigh_y = c_q2_q3_q4 * t_left_thigh_19;
  const Scalar a_left_thigh_x = s_q2_q3_q4 * t_left_thigh_19;
  const Scalar t_left_thigh_20 = left_thigh_I8 * c_q3_q4 + left_thigh_I6 * s_q3_q4;
  const Scalar t_left_thigh_21 = left_thigh_I9 * s_q3_q4 - left_thigh_I4 * c_q3_q4;
  const Scalar t_left_thigh_22 = s_q3_q4 * t_left_thigh_21;
  const Scalar t_left_thigh_23 = left_thigh_I8 * s_q3_q4 - left_thigh_I6 * c_q3_q4;
  const Scalar t_left_thigh_24 = t_left_thigh_4 - t_left_thigh_7;
  const Scalar t_left_thigh_25 = left_thigh_I12 + c_q3_q4 * t_left_thigh_21;
  const Scalar t_left_thigh_26 = left_thigh_h1 * c_q3_q4 - left_thigh_h2 * s_q3_q4;
  const Scalar t_left_thigh_27 = left_thigh_h2 * c_q3_q4 + left_thigh_h1 * s_q3_q4;
  // left_shank: angular velocity omega, Omega, moment M of (3)
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_2 = 2.0 * t_left_thigh_6;
  const Scalar Omega_left_shank_zy = t_left_thigh_17 - omega_left_shank_z * t_left_shank_2;
  const Scalar t_left_shank_3 = 2.0 * t_left_thigh_3;
  const Scalar Omega_left_shank_zx = t_left_foot_1 - omega_left_shank_z * t_left_shank_3;
  const Scalar t_left_shank_4 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_5 = t_left_thigh_7 + t_left_shank_4;
  const Scalar t_left_shank_6 = left_shank_I3 * c_left_ankle_pitch;
  const Scalar t_left_shank_7 = t_left_shank_6 - left_shank_I8 * s_left_ankle_pitch;
  const Scalar t_left_shank_8 = left_shank_I9 - c_left_ankle_pitch * t_left_shank_7;
  const Scalar t_left_shank_9 = s_left_ankle_pitch * t_left_shank_7;
  const Scalar t_left_shank_10 = left_shank_I11 * c_left_ankle_pitch;
  const Scalar t_left_shank_11 = t_left_shank_10 + left_shank_I6 * s_left_ankle_pitch;
  const Scalar t_left_shank_12 = left_shank_I11 * s_left_ankle_pitch;
  const Scalar t_left_shank_13 = t_left_shank_12 - left_shank_I6 * c_left_ankle_pitch;
  const Scalar t_left_shank_14 = left_shank_h1 * s_left_ankle_pitch;
  const Scalar t_left_shank_15 = t_left_shank_14 - left_shank_h2 * c_left_ankle_pitch;
  const Scalar t_left_shank_16 = left_shank_I12 + t_left_shank_9;
  const Scalar t_left_shank_17 = left_shank_h1 * c_left_ankle_pitch;
  const Scalar t_left_shank_18 = t_left_shank_17 + left_shank_h2 * s_left_ankle_pitch;
  // left_ankle_cross: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_2 = Omega_left_shank_zy - t_left_shank_2 * qd[4];
  const Scalar t_left_ankle_cross_3 = Omega_left_shank_zx - t_left_shank_3 * qd[4];
  const Scalar t_left_ankle_cross_4 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_shank_19 = t_left_shank_1 * t_left_thigh_13;
  const Scalar a_left_shank_z = t_left_shank_19 - s_left_shank_x * t_left_thigh_16;
  const Scalar t_left_ankle_cross_5 = a_left_shank_z + s_left_ankle_cross_x * Omega_left_shank_zx;
  const Scalar t_left_ankle_cross_6 = t_left_ankle_cross_1 * Omega_left_shank_zy;
  const Scalar a_left_ankle_cross_z = t_left_ankle_cross_5 - t_left_ankle_cross_6;
  const Scalar t_left_foot_2 = a_left_ankle_cross_z - left_hip_fork_l2 * t_left_thigh_8;
  const Scalar a_left_foot_y = t_left_foot_2 + left_hip_fork_l1 * t_left_ankle_cross_3;
  const Scalar t_left_shank_20 = a_left_thigh_x - s_left_shank_x * t_left_thigh_11;
  const Scalar a_left_shank_x = t_left_shank_20 - t_left_shank_1 * Omega_left_thigh_xy;
  const Scalar t_left_ankle_cross_7 = a_left_shank_x - s_left_ankle_cross_x * t_left_shank_5;
  const Scalar t_left_ankle_cross_8 = t_left_ankle_cross_1 * Omega_left_thigh_xy;
  const Scalar a_left_ankle_cross_x = t_left_ankle_cross_7 - t_left_ankle_cross_8;
  // left_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar t_left_foot_3 = left_hip_fork_l1 * (t_left_thigh_7 + t_left_ankle_cross_4);
  const Scalar t_left_foot_4 = a_left_ankle_cross_x - left_hip_fork_l2 * t_left_foot_1;
  const Scalar a_left_foot_x = t_left_foot_4 - t_left_foot_3;
  const Scalar t_left_thigh_28 = t_left_thigh_4 + t_left_thigh_10;
  const Scalar t_left_shank_21 = a_left_thigh_y + t_left_shank_1 * t_left_thigh_28;
  const Scalar a_left_shank_y = t_left_shank_21 + s_left_shank_x * Omega_left_thigh_yx;
  const Scalar t_left_foot_5 = left_hip_fork_l1 + s_left_ankle_cross_x;
  const Scalar t_left_shank_22 = t_left_thigh_4 + t_left_shank_4;
  const Scalar t_left_foot_6 = a_left_shank_y - left_hip_fork_l2 * t_left_thigh_17;
  const Scalar t_left_foot_7 = t_left_foot_6 + t_left_ankle_cross_1 * t_left_shank_22;
  const Scalar t_left_foot_8 = t_left_foot_7 + Omega_left_thigh_yx * t_left_foot_5;
  const Scalar omega_left_foot_z = t_left_thigh_6 + qd[5];
  const Scalar t_left_foot_9 = omega_left_ankle_cross_z * omega_left_foot_z * 2.0;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_2 + t_left_foot_9;
  const Scalar t_left_foot_10 = omega_left_foot_z * omega_left_foot_z;
  const Scalar Omega_left_foot_zx = Omega_left_thigh_xy - t_left_shank_3 * omega_left_foot_z;
  const Scalar t_left_foot_11 = left_foot_k1 + q[5];
  const auto p_s_left_foot = sine_cosine(t_left_foot_11);
  const Scalar& s_left_foot = p_s_left_foot.sine;
  const Scalar& c_left_foot = p_s_left_foot.cosine;
  const Scalar t_left_foot_12 = left_foot_h1 * c_left_foot;
  const Scalar t_left_foot_13 = left_foot_h1 * s_left_foot;
  const Scalar t_left_foot_14 = left_foot_I4 * c_left_foot + left_foot_I5 * s_left_foot;
  const Scalar t_left_foot_15 = s_left_foot * t_left_foot_14;
  const Scalar t_left_foot_16 = left_foot_I12 - t_left_foot_15;
  const Scalar t_left_foot_17 = left_foot_I3 * c_left_foot - left_foot_I2 * s_left_foot;
  const Scalar t_left_foot_18 = left_foot_I2 * c_left_foot + left_foot_I3 * s_left_foot;
  const Scalar t_left_foot_19 = left_foot_I13 + t_left_foot_15;
  const Scalar t_left_foot_20 = left_foot_I14 - c_left_foot * t_left_foot_14;
  const Scalar t_left_ankle_cross_9 = t_left_thigh_4 - t_left_ankle_cross_4;
  const Scalar t_left_foot_21 = t_left_foot_1 * t_left_foot_19;
  const Scalar t_left_foot_22 = a_left_foot_y * t_left_foot_12 + t_left_foot_21;
  const Scalar t_left_foot_23 = t_left_foot_22 + t_left_foot_20 * t_left_ankle_cross_9;
  const Scalar t_left_foot_24 = t_left_foot_23 + Omega_left_thigh_xy * t_left_foot_18;
  const Scalar t_left_foot_25 = t_left_foot_24 - a_left_foot_x * t_left_foot_13;
  const Scalar t_left_foot_26 = t_left_foot_25 + t_left_ankle_cross_3 * t_left_foot_16;
  const Scalar M_left_foot_z = t_left_foot_26 - t_left_ankle_cross_2 * t_left_foot_17;
  B[5] = M_left_foot_z;
  const Scalar t_left_foot_27 = left_ankle_cross_m1 * t_left_foot_8;
  const Scalar t_left_foot_28 = t_left_foot_27 - Omega_left_foot_zx * t_left_foot_12;
  const Scalar t_left_foot_29 = t_left_foot_28 - Omega_left_foot_zy * t_left_foot_13;
  const Scalar t_right_hip_fork_1 = left_hip_fork_I6 * c_right_hip_roll;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 - left_hip_fork_I3 * s_right_hip_roll;
  // right_thigh: angular velocity omega, Omega, angular acceleration alpha of (3)
  const Scalar t_right_thigh_1 = s_q8_q9_q10 * qd[7];
  const Scalar t_right_thigh_2 = c_right_hip_roll * qd[6];
  const Scalar t_right_thigh_3 = t_right_thigh_1 + c_q8_q9_q10 * t_right_thigh_2;
  const Scalar t_right_thigh_4 = s_right_hip_roll * qd[6];
  const Scalar omega_right_thigh_z = qd[8] + t_right_thigh_4;
  const Scalar t_right_thigh_5 = t_right_thigh_3 * omega_right_thigh_z;
  const Scalar t_right_thigh_6 = t_right_thigh_1 * t_right_thigh_4;
  const Scalar t_right_thigh_7 = t_right_thigh_6 - t_right_thigh_3 * qd[8];
  const Scalar t_right_foot_1 = t_right_thigh_5 + t_right_thigh_7;
  const Scalar t_right_thigh_8 = c_q8_q9_q10 * qd[7];
  const Scalar t_right_thigh_9 = t_right_thigh_8 - s_q8_q9_q10 * t_right_thigh_2;
  const Scalar t_right_thigh_10 = omega_right_thigh_z * t_right_thigh_9;
  const Scalar t_right_thigh_11 = t_right_thigh_4 * t_right_thigh_8;
  const Scalar alpha_right_thigh_x = t_right_thigh_11 - qd[8] * t_right_thigh_9;
  const Scalar t_right_thigh_12 = t_right_thigh_10 + alpha_right_thigh_x;
  const Scalar t_right_thigh_13 = t_right_thigh_9 * t_right_thigh_9;
  const Scalar t_right_thigh_14 = t_right_thigh_3 * t_right_thigh_3;
  const Scalar t_right_thigh_15 = t_right_thigh_13 + t_right_thigh_14;
  const Scalar t_right_thigh_16 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_17 = t_right_thigh_13 + t_right_thigh_16;
  const Scalar t_right_thigh_18 = t_right_thigh_5 - t_right_thigh_7;
  const Scalar t_right_thigh_19 = t_right_thigh_10 - alpha_right_thigh_x;
  const Scalar t_right_thigh_20 = t_right_thigh_14 + t_right_thigh_16;
  const Scalar t_right_thigh_21 = t_right_thigh_3 * t_right_thigh_9;
  const Scalar alpha_right_thigh_z = qd[7] * t_right_thigh_2;
  const Scalar Omega_right_thigh_xy = t_right_thigh_21 - alpha_right_thigh_z;
  const Scalar Omega_right_thigh_yx = t_right_thigh_21 + alpha_right_thigh_z;
  const Scalar t_right_thigh_22 = qd[6] * qd[6] * left_hip_fork_l1;
  const Scalar a_right_thigh_x = s_q8_q9_q10 * t_right_thigh_22;
  const Scalar a_right_thigh_y = c_q8_q9_q10 * t_right_thigh_22;
  const Scalar t_right_thigh_23 = left_thigh_I6 * s_q9_q10 + left_thigh_I8 * c_q9_q10;
  const Scalar t_right_thigh_24 = left_thigh_I9 * s_q9_q10 - left_thigh_I4 * c_q9_q10;
  const Scalar t_right_thigh_25 = s_q9_q10 * t_right_thigh_24;
  const Scalar t_right_thigh_26 = left_thigh_I8 * s_q9_q10 - left_thigh_I6 * c_q9_q10;
  const Scalar t_right_thigh_27 = left_thigh_I11 + t_right_thigh_25;
  const Scalar t_right_shank_2 = t_right_thigh_13 - t_right_thigh_14;
  const Scalar t_right_thigh_28 = left_thigh_I12 + c_q9_q10 * t_right_thigh_24;
  const Scalar t_right_thigh_29 = left_thigh_h2 * s_q9_q10 - left_thigh_h1 * c_q9_q10;
  const Scalar t_right_thigh_30 = left_thigh_h2 * c_q9_q10 + left_thigh_h1 * s_q9_q10;
  // right_shank: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar t_right_shank_3 = t_right_thigh_9 * omega_right_shank_z * 2.0;
  const Scalar Omega_right_shank_zy = t_right_thigh_12 - t_right_shank_3;
  const Scalar t_right_shank_4 = 2.0 * t_right_thigh_3;
  const Scalar Omega_right_shank_zx = t_right_foot_1 - omega_right_shank_z * t_right_shank_4;
  const Scalar t_right_shank_5 = t_right_shank_1 * t_right_thigh_19;
  const Scalar t_right_shank_6 = s_right_shank_x * t_right_thigh_18 - t_right_shank_5;
  const Scalar t_right_shank_7 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_8 = t_right_thigh_13 + t_right_shank_7;
  const Scalar t_right_shank_9 = t_right_thigh_14 + t_right_shank_7;
  const Scalar t_right_shank_10 = left_shank_I8 * s_right_ankle_pitch;
  const Scalar t_right_shank_11 = t_right_shank_10 - left_shank_I3 * c_right_ankle_pitch;
  const Scalar t_right_shank_12 = left_shank_I9 + c_right_ankle_pitch * t_right_shank_11;
  const Scalar t_right_shank_13 = left_shank_I11 * s_right_ankle_pitch;
  const Scalar t_right_shank_14 = t_right_shank_13 - left_shank_I6 * c_right_ankle_pitch;
  const Scalar t_right_shank_15 = s_right_ankle_pitch * t_right_shank_11;
  const Scalar t_right_shank_16 = left_shank_I12 - t_right_shank_15;
  const Scalar t_right_shank_17 = left_shank_I11 * c_right_ankle_pitch;
  const Scalar t_right_shank_18 = t_right_shank_17 + left_shank_I6 * s_right_ankle_pitch;
  const Scalar t_right_shank_19 = left_shank_h2 * s_right_ankle_pitch;
  const Scalar t_right_shank_20 = t_right_shank_19 + left_shank_h1 * c_right_ankle_pitch;
  const Scalar t_right_shank_21 = left_shank_h2 * c_right_ankle_pitch;
  const Scalar t_right_shank_22 = t_right_shank_21 - left_shank_h1 * s_right_ankle_pitch;
  // right_ankle_cross: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_2 = 2.0 * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_3 = t_right_thigh_9 * t_righ_ankl_cros_2;
  const Scalar Omega_righ_ankl_cros_zy = t_right_thigh_12 - t_righ_ankl_cros_3;
  const Scalar Omega_righ_ankl_cros_zx = Omega_right_shank_zx - t_right_shank_4 * qd[10];
  const Scalar t_righ_ankl_cros_4 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_5 = t_right_thigh_13 + t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_6 = t_right_thigh_15 - t_righ_ankl_cros_5;
  const Scalar t_righ_ankl_cros_7 = t_righ_ankl_cros_1 * Omega_right_shank_zy;
  const Scalar t_righ_ankl_cros_8 = s_righ_ankl_cros_x * Omega_right_shank_zx;
  const Scalar t_righ_ankl_cros_9 = t_right_shank_6 + t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_9 - t_righ_ankl_cros_8;
  const Scalar t_right_foot_2 = t_righ_ankl_cros_10 - left_hip_fork_l2 * t_right_thigh_15;
  const Scalar t_right_foot_3 = t_right_foot_2 - left_hip_fork_l1 * Omega_righ_ankl_cros_zx;
  const Scalar t_right_shank_23 = a_right_thigh_x - t_right_shank_1 * Omega_right_thigh_xy;
  const Scalar a_right_shank_x = t_right_shank_23 - s_right_shank_x * t_right_thigh_17;
  const Scalar t_righ_ankl_cros_11 = a_right_shank_x - t_righ_ankl_cros_1 * Omega_right_thigh_xy;
  const Scalar a_righ_ankl_cros_x = t_righ_ankl_cros_11 - s_righ_ankl_cros_x * t_right_shank_8;
  const Scalar t_right_foot_4 = a_righ_ankl_cros_x - left_hip_fork_l1 * t_righ_ankl_cros_5;
  const Scalar a_right_foot_x = t_right_foot_4 + left_hip_fork_l2 * t_right_foot_1;
  const Scalar t_right_shank_24 = a_right_thigh_y + s_right_shank_x * Omega_right_thigh_yx;
  const Scalar a_right_shank_y = t_right_shank_24 + t_right_shank_1 * t_right_thigh_20;
  // right_foot: acceleration a, angular velocity omega, Omega of (3)
  const Scalar t_right_foot_5 = a_right_shank_y + left_hip_fork_l2 * t_right_thigh_12;
  const Scalar t_right_foot_6 = Omega_right_thigh_yx * (left_hip_fork_l1 + s_righ_ankl_cros_x);
  const Scalar t_right_foot_7 = t_right_foot_5 + t_righ_ankl_cros_1 * t_right_shank_9;
  const Scalar t_right_foot_8 = t_right_foot_7 + t_right_foot_6;
  const Scalar omega_right_foot_z = t_right_thigh_9 + qd[11];
  const Scalar t_right_foot_9 = t_righ_ankl_cros_2 * omega_right_foot_z;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy + t_right_foot_9;
  const Scalar t_right_foot_10 = omega_right_foot_z * omega_right_foot_z;
  const Scalar Omega_right_foot_zx = Omega_right_thigh_xy - t_right_shank_4 * omega_right_foot_z;
  const Scalar t_right_foot_11 = left_foot_k1 - q[11];
  const auto p_s_right_foot = sine_cosine(t_right_foot_11);
  const Scalar& s_right_foot = p_s_right_foot.sine;
  const Scalar& c_right_foot = p_s_right_foot.cosine;
  const Scalar t_right_foot_12 = left_foot_h1 * c_right_foot;
  const Scalar t_right_foot_13 = left_foot_h1 * s_right_foot;
  const Scalar t_right_foot_14 = left_foot_I4 * c_right_foot + left_foot_I5 * s_right_foot;
  const Scalar t_right_foot_15 = s_right_foot * t_right_foot_14;
  const Scalar t_right_foot_16 = left_foot_I12 - t_right_foot_15;
  const Scalar t_right_foot_17 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_18 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_19 = left_foot_I13 + t_right_foot_15;
  const Scalar t_right_foot_20 = left_foot_I14 - c_right_foot * t_right_foot_14;
  const Scalar t_right_foot_21 = t_righ_ankl_cros_6 * t_right_foot_20;
  const Scalar t_right_foot_22 = t_right_foot_3 * t_right_foot_12 + t_right_foot_21;
  const Scalar t_right_foot_23 = t_right_foot_22 - a_right_foot_x * t_right_foot_13;
  const Scalar t_right_foot_24 = t_right_foot_23 + Omega_right_thigh_xy * t_right_foot_18;
  const Scalar t_right_foot_25 = t_right_foot_24 - t_right_foot_1 * t_right_foot_19;
  const Scalar t_right_foot_26 = t_right_foot_25 - Omega_righ_ankl_cros_zy * t_right_foot_17;
  const Scalar t_right_foot_27 = t_right_foot_26 - Omega_righ_ankl_cros_zx * t_right_foot_16;
  B[11] = -t_right_foot_27;
  const Scalar t_right_foot_28 = Omega_right_foot_zy * t_right_foot_13;
  const Scalar t_right_foot_29 = t_right_foot_28 - Omega_right_foot_zx * t_right_foot_12;
  const Scalar t_right_foot_30 = t_right_foot_29 + left_ankle_cross_m1 * t_right_foot_8;
  const Scalar t_right_foot_31 = left_ankle_cross_I2 + t_right_foot_18;
  const Scalar t_righ_ankl_cros_12 = left_ankle_cross_I8 * t_right_shank_2;
  const Scalar t_right_foot_32 = t_righ_ankl_cros_12 - t_right_foot_8 * t_right_foot_12;
  const Scalar t_right_foot_33 = t_right_foot_32 - left_ankle_cross_h1 * a_righ_ankl_cros_x;
  const Scalar t_right_foot_34 = t_right_foot_33 - left_hip_fork_l1 * t_right_foot_30;
  const Scalar t_right_foot_35 = t_right_foot_34 - left_ankle_cross_I10 * t_right_thigh_12;
  const Scalar t_right_foot_36 = t_right_foot_35 + Omega_right_foot_zx * t_right_foot_16;
  const Scalar t_right_foot_37 = t_right_foot_17 * (t_right_thigh_14 - t_right_foot_10);
  const Scalar t_right_foot_38 = t_right_foot_36 - t_right_foot_1 * t_right_foot_31;
  const Scalar t_righ_ankl_cros_13 = left_ankle_cross_I9 * Omega_right_thigh_xy;
  const Scalar t_right_foot_39 = t_right_foot_38 + t_right_foot_37 + t_righ_ankl_cros_13;
  const Scalar t_right_foot_40 = t_right_foot_39 + Omega_right_foot_zy * t_right_foot_20;
  const Scalar t_right_foot_41 = t_right_foot_40 - left_ankle_cross_I11 * Omega_right_thigh_yx;
  B[10] = -t_right_foot_41;
  const Scalar t_right_foot_42 = t_right_thigh_14 + t_right_foot_10;
  const Scalar t_right_foot_43 = Omega_righ_ankl_cros_zx * t_right_foot_12;
  const Scalar t_right_foot_44 = left_ankle_cross_m1 * t_right_foot_3 - t_right_foot_43;
  const Scalar t_right_foot_45 = t_right_foot_44 - t_right_foot_13 * t_right_foot_42;
  const Scalar t_right_foot_46 = t_right_foot_45 + left_ankle_cross_h1 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_14 = t_right_thigh_14 + t_righ_ankl_cros_4;
  const Scalar t_right_shank_25 = left_shank_I10 + t_right_shank_15;
  const Scalar t_right_foot_47 = t_right_foot_12 * (t_righ_ankl_cros_4 + t_right_foot_10);
  const Scalar t_right_foot_48 = left_ankle_cross_m1 * a_right_foot_x - t_right_foot_47;
  const Scalar F_right_foot_x = t_right_foot_48 + t_right_foot_1 * t_right_foot_13;
  // right_ankle_cross: force F, moment M of (3)
  const Scalar F_righ_ankl_cros_x = F_right_foot_x - left_ankle_cross_h1 * Omega_right_thigh_xy;
  const Scalar F_righ_ankl_cros_y = t_right_foot_30 + left_ankle_cross_h1 * t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_15 = t_right_foot_41 + t_right_shank_2 * t_right_shank_12;
  const Scalar t_righ_ankl_cros_16 = t_righ_ankl_cros_15 - t_right_thigh_12 * t_right_shank_18;
  const Scalar t_righ_ankl_cros_17 = t_righ_ankl_cros_1 * F_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_18 = t_righ_ankl_cros_16 - t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_19 = t_righ_ankl_cros_18 - t_right_foot_1 * t_right_shank_14;
  const Scalar t_right_shank_26 = Omega_right_thigh_xy * t_right_shank_25;
  const Scalar t_righ_ankl_cros_20 = t_righ_ankl_cros_19 + t_right_shank_26;
  const Scalar t_righ_ankl_cros_21 = t_righ_ankl_cros_20 + t_right_shank_22 * a_right_shank_x;
  const Scalar t_righ_ankl_cros_22 = s_righ_ankl_cros_x * F_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_23 = t_righ_ankl_cros_21 - t_righ_ankl_cros_22;
  const Scalar t_right_shank_27 = Omega_right_thigh_yx * t_right_shank_16;
  const Scalar t_righ_ankl_cros_24 = t_righ_ankl_cros_23 - t_right_shank_27;
  const Scalar t_righ_ankl_cros_25 = t_righ_ankl_cros_24 - t_right_shank_20 * a_right_shank_y;
  B[9] = -t_righ_ankl_cros_25;
  const Scalar t_righ_ankl_cros_26 = t_right_foot_46 - Omega_right_shank_zx * t_right_shank_20;
  const Scalar t_right_shank_28 = Omega_right_shank_zy * t_right_shank_22;
  const Scalar t_righ_ankl_cros_27 = t_righ_ankl_cros_26 - t_right_shank_28;
  // right_thigh: moment M of (3)
  const Scalar t_right_thigh_31 = left_ankle_cross_I2 + t_right_thigh_26 + t_right_shank_14;
  const Scalar t_right_thigh_32 = left_thigh_I10 - t_right_thigh_25;
  const Scalar t_right_thigh_33 = t_right_thigh_14 - t_right_thigh_16;
  const Scalar t_righ_ankl_cros_28 = left_ankle_cross_I11 * Omega_righ_ankl_cros_zx;
  const Scalar t_right_thigh_34 = t_right_foot_27 - t_righ_ankl_cros_28;
  const Scalar t_right_thigh_35 = t_right_thigh_34 - left_hip_fork_l2 * F_right_foot_x;
  const Scalar t_right_thigh_36 = t_right_thigh_35 + left_hip_fork_l1 * t_right_foot_45;
  const Scalar t_righ_ankl_cros_29 = left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_thigh_37 = t_right_thigh_36 + t_righ_ankl_cros_29;
  const Scalar t_right_thigh_38 = t_right_thigh_37 - t_right_thigh_19 * t_right_thigh_28;
  const Scalar t_right_thigh_39 = t_right_thigh_38 - left_ankle_cross_I10 * t_righ_ankl_cros_6;
  const Scalar t_right_shank_29 = t_right_shank_18 * (t_right_thigh_15 - t_right_shank_8);
  const Scalar t_right_thigh_40 = t_right_thigh_39 + t_right_thigh_18 * t_right_thigh_32;
  const Scalar t_right_thigh_41 = Omega_right_thigh_xy * t_right_thigh_31;
  const Scalar t_right_thigh_42 = t_right_thigh_40 - t_right_shank_29 + t_right_thigh_41;
  const Scalar t_right_thigh_43 = t_right_thigh_42 + Omega_right_shank_zy * t_right_shank_12;
  const Scalar t_right_thigh_44 = t_right_thigh_43 + s_right_shank_x * t_righ_ankl_cros_27;
  const Scalar t_right_thigh_45 = t_right_thigh_44 + s_righ_ankl_cros_x * t_right_foot_46;
  const Scalar t_right_thigh_46 = t_right_thigh_45 + t_right_shank_6 * t_right_shank_20;
  const Scalar t_right_thigh_47 = t_right_thigh_46 - Omega_right_shank_zx * t_right_shank_16;
  const Scalar M_right_thigh_y = t_right_thigh_47 - t_right_thigh_23 * t_right_thigh_33;
  const Scalar t_right_thigh_48 = left_ankle_cross_I10 + t_right_thigh_23 + t_right_shank_18;
  const Scalar t_right_shank_30 = Omega_right_shank_zy * t_right_shank_25;
  const Scalar t_right_thigh_49 = t_right_shank_30 - t_right_shank_6 * t_right_shank_22;
  const Scalar t_right_thigh_50 = t_right_thigh_49 + t_right_shank_9 * t_right_shank_14;
  const Scalar t_right_thigh_51 = t_right_thigh_50 - Omega_right_shank_zx * t_right_shank_12;
  const Scalar t_right_thigh_52 = t_right_thigh_51 + t_right_foot_31 * t_righ_ankl_cros_14;
  const Scalar t_right_thigh_53 = t_right_thigh_52 + t_righ_ankl_cros_1 * t_right_foot_46;
  const Scalar t_right_thigh_54 = t_right_thigh_53 + left_ankle_cross_h1 * t_righ_ankl_cros_10;
  const Scalar t_right_thigh_55 = t_right_thigh_54 + t_right_shank_1 * t_righ_ankl_cros_27;
  const Scalar t_right_thigh_56 = left_ankle_cross_I8 - t_right_foot_17;
  const Scalar t_right_thigh_57 = t_right_thigh_55 - t_right_foot_18 * t_right_foot_42;
  const Scalar t_right_thigh_58 = t_right_thigh_57 - Omega_righ_ankl_cros_zx * t_right_thigh_56;
  const Scalar t_right_thigh_59 = t_right_thigh_58 - t_right_thigh_15 * t_right_thigh_31;
  const Scalar t_right_thigh_60 = t_right_thigh_59 + t_right_thigh_20 * t_right_thigh_26;
  const Scalar t_righ_ankl_cros_30 = left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_thigh_61 = t_right_thigh_60 + t_righ_ankl_cros_30;
  const Scalar t_right_thigh_62 = t_right_thigh_61 + left_hip_fork_l2 * t_right_foot_30;
  const Scalar t_right_thigh_63 = t_right_thigh_62 + t_right_foot_8 * t_right_foot_13;
  const Scalar t_right_thigh_64 = t_right_thigh_63 + Omega_right_foot_zy * t_right_foot_19;
  const Scalar t_right_thigh_65 = t_right_thigh_64 + Omega_right_foot_zx * t_right_foot_20;
  const Scalar t_right_thigh_66 = t_right_thigh_65 + Omega_right_thigh_yx * t_right_thigh_48;
  const Scalar t_right_thigh_67 = t_right_thigh_66 + t_right_thigh_18 * t_right_thigh_28;
  const Scalar M_right_thigh_x = t_right_thigh_67 - t_right_thigh_19 * t_right_thigh_27;
  // right_shank: force F, moment M of (3)
  const Scalar t_right_shank_31 = F_righ_ankl_cros_y + Omega_right_thigh_yx * t_right_shank_20;
  const Scalar F_right_shank_y = t_right_shank_31 - t_right_shank_9 * t_right_shank_22;
  const Scalar t_right_shank_32 = F_righ_ankl_cros_x - t_right_shank_8 * t_right_shank_20;
  const Scalar F_right_shank_x = t_right_shank_32 + Omega_right_thigh_xy * t_right_shank_22;
  const Scalar t_right_shank_33 = t_righ_ankl_cros_25 - t_right_thigh_12 * t_right_thigh_23;
  const Scalar t_right_shank_34 = t_right_shank_33 + t_right_shank_2 * t_right_thigh_28;
  const Scalar t_right_shank_35 = t_right_shank_34 - s_right_shank_x * F_right_shank_y;
  const Scalar t_right_shank_36 = t_right_shank_35 - a_right_thigh_y * t_right_thigh_30;
  const Scalar t_right_shank_37 = t_right_shank_36 - t_right_foot_1 * t_right_thigh_26;
  const Scalar t_right_shank_38 = t_right_shank_37 - a_right_thigh_x * t_right_thigh_29;
  const Scalar t_right_shank_39 = t_right_shank_38 - t_right_shank_1 * F_right_shank_x;
  const Scalar t_right_shank_40 = t_right_shank_39 - Omega_right_thigh_yx * t_right_thigh_32;
  const Scalar t_right_shank_41 = t_right_shank_40 + Omega_right_thigh_xy * t_right_thigh_27;
  B[8] = -t_right_shank_41;
  // right_hip_fork
  const Scalar t_right_hip_fork_3 = left_hip_fork_I7 + s_right_hip_roll * t_right_hip_fork_2;
  const Scalar t_right_hip_fork_4 = qd[6] * t_right_hip_fork_3;
  const Scalar t_right_hip_fork_5 = left_hip_fork_I9 * c_right_hip_roll;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_5 - left_hip_fork_I8 * s_right_hip_roll;
  const Scalar t_right_shank_42 = t_righ_ankl_cros_27 + t_right_thigh_18 * t_right_thigh_30;
  const Scalar t_right_shank_43 = t_right_shank_42 - t_right_thigh_19 * t_right_thigh_29;
  // right_thigh: moment M, force F of (3)
  const Scalar t_right_thigh_68 = left_hip_fork_l1 * t_right_shank_43;
  const Scalar t_right_thigh_69 = s_q8_q9_q10 * M_right_thigh_y - t_right_thigh_68;
  const Scalar t_right_thigh_70 = F_right_shank_x - Omega_right_thigh_xy * t_right_thigh_29;
  const Scalar F_right_thigh_x = t_right_thigh_70 - t_right_thigh_17 * t_right_thigh_30;
  const Scalar t_right_thigh_71 = F_right_shank_y + t_right_thigh_20 * t_right_thigh_29;
  const Scalar F_right_thigh_y = t_right_thigh_71 + Omega_right_thigh_yx * t_right_thigh_30;
  const Scalar t_right_thigh_72 = c_q8_q9_q10 * F_right_thigh_x - s_q8_q9_q10 * F_right_thigh_y;
  const Scalar t_right_hip_fork_7 = 2.0 * t_right_hip_fork_4 - qd[7] * t_right_hip_fork_6;
  const Scalar t_right_thigh_73 = t_right_thigh_69 - c_q8_q9_q10 * M_right_thigh_x;
  const Scalar t_right_thigh_74 = c_right_hip_roll * t_right_thigh_73;
  const Scalar t_right_thigh_75 = t_right_shank_41 - left_hip_fork_l1 * t_right_thigh_72;
  B[6] = -(qd[7] * t_right_hip_fork_7 - t_right_thigh_74 + s_right_hip_roll * t_right_thigh_75);
  const Scalar t_right_thigh_76 = c_q8_q9_q10 * M_right_thigh_y + s_q8_q9_q10 * M_right_thigh_x;
  B[7] = qd[6] * t_right_hip_fork_4 - t_right_thigh_76;
  const Scalar t_left_foot_30 = t_left_foot_17 * (t_left_thigh_4 - t_left_foot_10);
  // left_ankle_cross: moment M, Omega of (3)
  const Scalar t_left_ankle_cross_10 = t_left_foot_1 * (left_ankle_cross_I2 + t_left_foot_18);
  const Scalar t_left_ankle_cross_11 = left_hip_fork_l1 * t_left_foot_29 + t_left_foot_30;
  const Scalar t_left_ankle_cross_12 = t_left_ankle_cross_11 - t_left_ankle_cross_10;
  const Scalar t_left_foot_31 = Omega_left_foot_zx * t_left_foot_16;
  const Scalar t_left_ankle_cross_13 = t_left_ankle_cross_12 - t_left_foot_31;
  const Scalar t_left_ankle_cross_14 = left_ankle_cross_I12 * t_left_thigh_18;
  const Scalar t_left_ankle_cross_15 = t_left_ankle_cross_13 - t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_16 = left_ankle_cross_I10 * t_left_thigh_17;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_15 - t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_18 = t_left_ankle_cross_17 + t_left_foot_8 * t_left_foot_12;
  const Scalar t_left_ankle_cross_19 = left_ankle_cross_I8 * t_left_thigh_24;
  const Scalar t_left_ankle_cross_20 = t_left_ankle_cross_18 + t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_21 = left_ankle_cross_h1 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_22 = t_left_ankle_cross_20 + t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_23 = left_ankle_cross_I13 * alpha_left_thigh_z;
  const Scalar t_left_ankle_cross_24 = t_left_ankle_cross_22 + t_left_ankle_cross_23;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_24 + Omega_left_foot_zy * t_left_foot_20;
  B[4] = M_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_25 = t_left_thigh_4 + t_left_ankle_cross_4;
  // left_foot: force F of (3)
  const Scalar t_left_foot_32 = t_left_foot_12 * (t_left_ankle_cross_4 + t_left_foot_10);
  const Scalar t_left_foot_33 = left_ankle_cross_m1 * a_left_foot_x - t_left_foot_32;
  const Scalar F_left_foot_x = t_left_foot_33 - t_left_foot_1 * t_left_foot_13;
  const Scalar F_left_ankle_cross_x = F_left_foot_x - left_ankle_cross_h1 * Omega_left_thigh_xy;
  const Scalar t_left_shank_23 = left_shank_I10 - t_left_shank_9;
  // left_ankle_cross: force F of (3)
  const Scalar t_left_ankle_cross_26 = left_ankle_cross_h1 * t_left_ankle_cross_25;
  const Scalar F_left_ankle_cross_y = t_left_foot_29 + t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_27 = s_left_ankle_cross_x * F_left_ankle_cross_y;
  // left_shank: moment M of (3)
  const Scalar t_left_shank_24 = M_left_ankle_cross_z + t_left_ankle_cross_27;
  const Scalar t_left_shank_25 = t_left_shank_24 + t_left_shank_18 * a_left_shank_y;
  const Scalar t_left_shank_26 = t_left_shank_25 + t_left_thigh_24 * t_left_shank_8;
  const Scalar t_left_shank_27 = t_left_shank_26 + t_left_ankle_cross_1 * F_left_ankle_cross_x;
  const Scalar t_left_shank_28 = t_left_shank_27 - t_left_thigh_17 * t_left_shank_11;
  const Scalar t_left_shank_29 = t_left_shank_28 + t_left_shank_15 * a_left_shank_x;
  const Scalar t_left_shank_30 = t_left_shank_29 - t_left_foot_1 * t_left_shank_13;
  const Scalar t_left_shank_31 = t_left_shank_30 - Omega_left_thigh_xy * t_left_shank_23;
  const Scalar M_left_shank_z = t_left_shank_31 + Omega_left_thigh_yx * t_left_shank_16;
  B[3] = M_left_shank_z;
  // left_foot: Omega, force F of (3)
  const Scalar t_left_foot_34 = t_left_thigh_4 + t_left_foot_10;
  const Scalar t_left_foot_35 = left_ankle_cross_m1 * a_left_foot_y;
  const Scalar t_left_foot_36 = t_left_foot_35 - t_left_foot_13 * t_left_foot_34;
  const Scalar F_left_foot_y = t_left_foot_36 + t_left_ankle_cross_3 * t_left_foot_12;
  const Scalar F_left_ankle_cross_z = F_left_foot_y - left_ankle_cross_h1 * t_left_ankle_cross_2;
  const Scalar t_left_shank_32 = F_left_ankle_cross_z - Omega_left_shank_zy * t_left_shank_15;
  const Scalar F_left_shank_z = t_left_shank_32 + Omega_left_shank_zx * t_left_shank_18;
  const Scalar t_left_thigh_29 = left_thigh_I10 - t_left_thigh_22;
  // left_shank: moment M, force F of (3)
  const Scalar t_left_shank_33 = left_ankle_cross_I8 + left_ankle_cross_I14 * c_left_ankle_pitch;
  const Scalar t_left_shank_34 = t_left_shank_11 * (t_left_thigh_8 - t_left_shank_5);
  const Scalar t_left_shank_35 = Omega_left_shank_zy * t_left_shank_8;
  const Scalar t_left_shank_36 = M_left_foot_z - t_left_shank_34 - t_left_shank_35;
  const Scalar t_left_shank_37 = t_left_shank_36 + t_left_thigh_13 * t_left_thigh_25;
  const Scalar t_left_shank_38 = t_left_shank_37 + left_ankle_cross_I11 * t_left_ankle_cross_3;
  const Scalar t_left_shank_39 = left_ankle_cross_I2 + t_left_thigh_23 + t_left_shank_13;
  const Scalar t_left_shank_40 = t_left_shank_38 + Omega_left_shank_zx * t_left_shank_16;
  const Scalar t_left_shank_41 = t_left_shank_40 + Omega_left_thigh_xy * t_left_shank_39;
  const Scalar t_left_shank_42 = t_left_shank_41 + t_left_foot_5 * F_left_foot_y;
  const Scalar t_left_shank_43 = t_left_shank_42 - t_left_thigh_16 * t_left_thigh_29;
  const Scalar t_left_shank_44 = t_left_shank_43 - left_hip_fork_l2 * F_left_foot_x;
  const Scalar t_left_shank_45 = t_left_shank_44 + t_left_shank_18 * a_left_shank_z;
  const Scalar t_left_shank_46 = t_left_shank_45 - left_ankle_cross_I10 * t_left_ankle_cross_9;
  const Scalar t_left_thigh_30 = t_left_thigh_20 * (t_left_thigh_8 - t_left_thigh_11);
  const Scalar t_left_shank_47 = t_left_ankle_cross_2 * t_left_shank_33;
  const Scalar t_left_shank_48 = t_left_shank_46 - t_left_thigh_30 - t_left_shank_47;
  const Scalar t_left_shank_49 = t_left_shank_48 + s_left_shank_x * F_left_shank_z;
  const Scalar t_left_shank_50 = F_left_ankle_cross_y + t_left_shank_15 * t_left_shank_22;
  const Scalar F_left_shank_y = t_left_shank_50 + Omega_left_thigh_yx * t_left_shank_18;
  const Scalar t_left_shank_51 = F_left_ankle_cross_x - t_left_shank_5 * t_left_shank_18;
  const Scalar F_left_shank_x = t_left_shank_51 - Omega_left_thigh_xy * t_left_shank_15;
  // left_thigh: moment M, force F of (3)
  const Scalar t_left_thigh_31 = left_thigh_I11 + t_left_thigh_22;
  const Scalar t_left_thigh_32 = M_left_shank_z + t_left_shank_1 * F_left_shank_x;
  const Scalar t_left_thigh_33 = t_left_thigh_32 - t_left_thigh_17 * t_left_thigh_20;
  const Scalar t_left_thigh_34 = t_left_thigh_33 + a_left_thigh_y * t_left_thigh_27;
  const Scalar t_left_thigh_35 = t_left_thigh_34 + s_left_shank_x * F_left_shank_y;
  const Scalar t_left_thigh_36 = t_left_thigh_35 + t_left_thigh_24 * t_left_thigh_25;
  const Scalar t_left_thigh_37 = t_left_thigh_36 - a_left_thigh_x * t_left_thigh_26;
  const Scalar t_left_thigh_38 = t_left_thigh_37 + Omega_left_thigh_yx * t_left_thigh_29;
  const Scalar t_left_thigh_39 = t_left_thigh_38 - Omega_left_thigh_xy * t_left_thigh_31;
  const Scalar M_left_thigh_z = t_left_thigh_39 - t_left_foot_1 * t_left_thigh_23;
  B[2] = M_left_thigh_z;
  const Scalar t_left_foot_37 = t_left_ankle_cross_25 - t_left_foot_34;
  const Scalar t_left_ankle_cross_28 = t_left_thigh_7 - t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_29 = left_ankle_cross_I9 * t_left_ankle_cross_2;
  const Scalar t_left_thigh_40 = t_left_ankle_cross_29 + Omega_left_shank_zy * t_left_shank_23;
  const Scalar t_left_thigh_41 = t_left_thigh_23 * (t_left_thigh_7 - t_left_thigh_10);
  const Scalar t_left_thigh_42 = t_left_thigh_40 + t_left_thigh_16 * t_left_thigh_25;
  const Scalar t_left_thigh_43 = left_ankle_cross_I10 + t_left_thigh_20 + t_left_shank_11;
  const Scalar t_left_thigh_44 = Omega_left_thigh_yx * t_left_thigh_43;
  const Scalar t_left_shank_52 = t_left_shank_13 * (t_left_thigh_8 - t_left_shank_22);
  const Scalar t_left_thigh_45 = t_left_thigh_42 + t_left_thigh_41 - t_left_thigh_44;
  const Scalar t_left_thigh_46 = t_left_thigh_45 + t_left_shank_52;
  const Scalar t_left_thigh_47 = t_left_thigh_46 - t_left_thigh_13 * t_left_thigh_31;
  const Scalar t_left_thigh_48 = t_left_thigh_47 - left_ankle_cross_h1 * a_left_ankle_cross_z;
  const Scalar t_left_thigh_49 = t_left_thigh_48 - Omega_left_foot_zx * t_left_foot_20;
  const Scalar t_left_thigh_50 = t_left_ankle_cross_3 * (left_ankle_cross_I8 + t_left_foot_17);
  const Scalar t_left_thigh_51 = t_left_thigh_49 - t_left_foot_8 * t_left_foot_13;
  const Scalar t_left_foot_38 = Omega_left_foot_zy * t_left_foot_19;
  const Scalar t_left_thigh_52 = t_left_thigh_51 - t_left_thigh_50 + t_left_foot_38;
  const Scalar t_left_thigh_53 = t_left_thigh_52 - t_left_shank_15 * a_left_shank_z;
  const Scalar t_left_thigh_54 = t_left_thigh_53 - t_left_foot_18 * t_left_foot_37;
  const Scalar t_left_thigh_55 = t_left_thigh_54 - Omega_left_shank_zx * t_left_shank_8;
  const Scalar t_left_thigh_56 = t_left_thigh_55 - t_left_shank_1 * F_left_shank_z;
  const Scalar t_left_thigh_57 = t_left_thigh_56 + left_ankle_cross_I2 * t_left_ankle_cross_28;
  const Scalar t_left_thigh_58 = t_left_thigh_57 - left_hip_fork_l2 * t_left_foot_29;
  const Scalar M_left_thigh_x = t_left_thigh_58 - t_left_ankle_cross_1 * F_left_ankle_cross_z;
  const Scalar t_left_hip_fork_1 = left_hip_fork_I6 * c_left_hip_roll;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 + left_hip_fork_I3 * s_left_hip_roll;
  const Scalar t_left_thigh_59 = F_left_shank_z - t_left_thigh_16 * t_left_thigh_27;
  const Scalar F_left_thigh_z = t_left_thigh_59 - t_left_thigh_13 * t_left_thigh_26;
  const Scalar t_left_thigh_60 = F_left_shank_x - t_left_thigh_11 * t_left_thigh_27;
  const Scalar F_left_thigh_x = t_left_thigh_60 + Omega_left_thigh_xy * t_left_thigh_26;
  const Scalar t_left_thigh_61 = F_left_shank_y + Omega_left_thigh_yx * t_left_thigh_27;
  const Scalar F_left_thigh_y = t_left_thigh_61 - t_left_thigh_26 * t_left_thigh_28;
  const Scalar t_left_thigh_62 = c_q2_q3_q4 * F_left_thigh_x - s_q2_q3_q4 * F_left_thigh_y;
  // left_hip_fork: moment M of (3)
  const Scalar t_left_hip_fork_3 = left_hip_fork_I8 * s_left_hip_roll;
  const Scalar t_left_hip_fork_4 = left_hip_fork_I7 - s_left_hip_roll * t_left_hip_fork_2;
  const Scalar t_left_hip_fork_5 = qd[0] * t_left_hip_fork_4;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_3 + left_hip_fork_I9 * c_left_hip_roll;
  const Scalar t_left_thigh_63 = left_hip_fork_l1 * F_left_thigh_z - s_q2_q3_q4 * t_left_shank_49;
  const Scalar t_left_hip_fork_7 = qd[1] * t_left_hip_fork_6 - 2.0 * t_left_hip_fork_5;
  // left_thigh: moment M of (3)
  const Scalar t_left_thigh_64 = M_left_thigh_z + left_hip_fork_l1 * t_left_thigh_62;
  const Scalar t_left_thigh_65 = t_left_thigh_63 - c_q2_q3_q4 * M_left_thigh_x;
  const Scalar t_left_thigh_66 = qd[1] * t_left_hip_fork_7 - s_left_hip_roll * t_left_thigh_64;
  B[0] = c_left_hip_roll * t_left_thigh_65 - t_left_thigh_66;
  const Scalar t_left_thigh_67 = c_q2_q3_q4 * t_left_shank_49 - s_q2_q3_q4 * M_left_thigh_x;
  // left_hip_fork: moment M of (3)
  B[1] = t_left_thigh_67 - qd[0] * t_left_hip_fork_5;
}

void gravity_force(const Scalar q[12], Scalar G[12]) noexcept {
  const auto p_s_left_hip_roll = sine_cosine(q[1]);
  const Scalar& s_left_hip_roll = p_s_left_hip_roll.sine;
  const Scalar& c_left_hip_roll = p_s_left_hip_roll.cosine;
  const auto p_s_left_hip_pitch = sine_cosine(q[2]);
  const Scalar& s_left_hip_pitch = p_s_left_hip_pitch.sine;
  const Scalar& c_left_hip_pitch = p_s_left_hip_pitch.cosine;
  const Scalar q_q2_q3 = q[2] + q[3];
  const auto p_s_q2_q3 = sine_cosine(q_q2_q3);
  const Scalar& s_q2_q3 = p_s_q2_q3.sine;
  const Scalar& c_q2_q3 = p_s_q2_q3.cosine;
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const auto p_s_q2_q3_q4 = sine_cosine(q_q2_q3_q4);
  const Scalar& s_q2_q3_q4 = p_s_q2_q3_q4.sine;
  const Scalar& c_q2_q3_q4 = p_s_q2_q3_q4.cosine;
  const auto p_s_right_hip_roll = sine_cosine(q[7]);
  const Scalar& s_right_hip_roll = p_s_right_hip_roll.sine;
  const Scalar& c_right_hip_roll = p_s_right_hip_roll.cosine;
  const auto p_s_right_hip_pitch = sine_cosine(q[8]);
  const Scalar& s_right_hip_pitch = p_s_right_hip_pitch.sine;
  const Scalar& c_right_hip_pitch = p_s_right_hip_pitch.cosine;
  const Scalar q_q8_q9 = q[8] + q[9];
  const auto p_s_q8_q9 = sine_cosine(q_q8_q9);
  const Scalar& s_q8_q9 = p_s_q8_q9.sine;
  const Scalar& c_q8_q9 = p_s_q8_q9.cosine;
  // right_foot: G of 6.5
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const auto p_s_q8_q9_q10 = sine_cosine(q_q8_q9_q10);
  const Scalar& s_q8_q9_q10 = p_s_q8_q9_q10.sine;
  const Scalar& c_q8_q9_q10 = p_s_q8_q9_q10.cosine;
  const Scalar t_right_foot_1 = left_foot_k1 - q[11];
  const auto p_s_right_foot = sine_cosine(t_right_foot_1);
  const Scalar& s_right_foot = p_s_right_foot.sine;
  const Scalar& c_right_foot = p_s_right_foot.cosine;
  const Scalar t_right_foot_2 = left_foot_G1 * s_right_foot;
  const Scalar t_right_foot_3 = left_foot_G1 * c_right_foot;
  const Scalar t_right_foot_4 = c_right_hip_roll * c_q8_q9_q10 * t_right_foot_2;
  G[11] = s_right_hip_roll * t_right_foot_3 - t_right_foot_4;
  // right_ankle_cross: G of 6.5
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_G2 + t_right_foot_3;
  const Scalar t_righ_ankl_cros_2 = s_q8_q9_q10 * t_righ_ankl_cros_1;
  const Scalar t_righ_ankl_cros_3 = left_ankle_cross_G1 * c_q8_q9_q10 - t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_4 = c_right_hip_roll * t_righ_ankl_cros_3;
  G[10] = -t_righ_ankl_cros_4;
  const Scalar t_right_shank_1 = left_shank_G1 * c_q8_q9 + left_shank_G2 * s_q8_q9;
  const Scalar t_right_shank_2 = t_righ_ankl_cros_4 - c_right_hip_roll * t_right_shank_1;
  G[9] = -t_right_shank_2;
  // right_thigh: G of 6.5
  const Scalar t_right_thigh_1 = left_thigh_G1 * c_right_hip_pitch;
  const Scalar t_right_thigh_2 = t_right_thigh_1 + left_thigh_G2 * s_right_hip_pitch;
  G[8] = c_right_hip_roll * t_right_thigh_2 - t_right_shank_2;
  // right_hip_fork: G of 6.5
  const Scalar t_right_hip_fork_1 = left_hip_fork_G2 + left_ankle_cross_G1 * s_q8_q9_q10;
  const Scalar t_right_hip_fork_2 = t_right_hip_fork_1 - left_shank_G1 * s_q8_q9;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 + left_shank_G2 * c_q8_q9;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_3 - left_thigh_G1 * s_right_hip_pitch;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_4 + left_thigh_G2 * c_right_hip_pitch;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_5 + c_q8_q9_q10 * t_righ_ankl_cros_1;
  const Scalar t_right_hip_fork_7 = c_right_hip_roll * (left_hip_fork_G1 + t_right_foot_2);
  G[7] = s_right_hip_roll * t_right_hip_fork_6 - t_right_hip_fork_7;
  // left_foot: G of 6.5
  const Scalar t_left_foot_1 = left_foot_k1 + q[5];
  const auto p_s_left_foot = sine_cosine(t_left_foot_1);
  const Scalar& s_left_foot = p_s_left_foot.sine;
  const Scalar& c_left_foot = p_s_left_foot.cosine;
  const Scalar t_left_foot_2 = left_foot_G1 * s_left_foot;
  const Scalar t_left_foot_3 = c_left_hip_roll * c_q2_q3_q4;
  const Scalar t_left_foot_4 = left_foot_G1 * c_left_foot;
  G[5] = t_left_foot_2 * t_left_foot_3 + s_left_hip_roll * t_left_foot_4;
  // left_ankle_cross: G of 6.5
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_G2 + t_left_foot_4;
  const Scalar t_left_ankle_cross_2 = c_left_hip_roll * s_q2_q3_q4 * t_left_ankle_cross_1;
  const Scalar t_left_ankle_cross_3 = left_ankle_cross_G1 * t_left_foot_3;
  const Scalar t_left_ankle_cross_4 = t_left_ankle_cross_3 - t_left_ankle_cross_2;
  G[4] = -t_left_ankle_cross_4;
  const Scalar t_left_shank_1 = left_shank_G1 * c_q2_q3 + left_shank_G2 * s_q2_q3;
  const Scalar t_left_shank_2 = t_left_ankle_cross_4 - c_left_hip_roll * t_left_shank_1;
  G[3] = -t_left_shank_2;
  // left_thigh: G of 6.5
  const Scalar t_left_thigh_1 = left_thigh_G2 * s_left_hip_pitch;
  const Scalar t_left_thigh_2 = t_left_thigh_1 + left_thigh_G1 * c_left_hip_pitch;
  G[2] = c_left_hip_roll * t_left_thigh_2 - t_left_shank_2;
  // left_hip_fork: G of 6.5
  const Scalar t_left_hip_fork_1 = left_hip_fork_G2 + left_ankle_cross_G1 * s_q2_q3_q4;
  const Scalar t_left_hip_fork_2 = t_left_hip_fork_1 - left_shank_G1 * s_q2_q3;
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_2 + left_shank_G2 * c_q2_q3;
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_3 - left_thigh_G1 * s_left_hip_pitch;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_4 + left_thigh_G2 * c_left_hip_pitch;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_5 + c_q2_q3_q4 * t_left_ankle_cross_1;
  const Scalar t_left_hip_fork_7 = c_left_hip_roll * (left_hip_fork_G1 + t_left_foot_2);
  G[1] = t_left_hip_fork_7 + s_left_hip_roll * t_left_hip_fork_6;
  G[0] = 0.0;
  G[6] = 0.0;
}

// Lengths inside are in units of L, a distance between left_hip_roll and left_hip_pitch:
//   L = 0.01 m
// Names: vectors F_ in N m/L, a_ in L/s^2; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void inverse_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar qdd[12],
                      Scalar tau[12]) noexcept {
  const auto p_s_left_hip_roll = sine_cosine(q[1]);
  const Scalar& s_left_hip_roll = p_s_left_hip_roll.sine;
  const Scalar& c_left_hip_roll = p_s_left_hip_roll.cosine;
  const auto p_s_left_hip_pitch = sine_cosine(q[2]);
  const Scalar& s_left_hip_pitch = p_s_left_hip_pitch.sine;
  const Scalar& c_left_hip_pitch = p_s_left_hip_pitch.cosine;
  const auto p_s_left_knee = sine_cosine(q[3]);
  const Scalar& s_left_knee = p_s_left_knee.sine;
  const Scalar& c_left_knee = p_s_left_knee.cosine;
  const auto p_s_left_ankle_pitch = sine_cosine(q[4]);
  const Scalar& s_left_ankle_pitch = p_s_left_ankle_pitch.sine;
  const Scalar& c_left_ankle_pitch = p_s_left_ankle_pitch.cosine;
  const auto p_s_right_hip_roll = sine_cosine(q[7]);
  const Scalar& s_right_hip_roll = p_s_right_hip_roll.sine;
  const Scalar& c_right_hip_roll = p_s_right_hip_roll.cosine;
  const auto p_s_right_hip_pitch = sine_cosine(q[8]);
  const Scalar& s_right_hip_pitch = p_s_right_hip_pitch.sine;
  const Scalar& c_right_hip_pitch = p_s_right_hip_pitch.cosine;
  const auto p_s_right_knee = sine_cosine(q[9]);
  const Scalar& s_right_knee = p_s_right_knee.sine;
  const Scalar& c_right_knee = p_s_right_knee.cosine;
  const auto p_s_right_ankle_pitch = sine_cosine(q[10]);
  const Scalar& s_right_ankle_pitch = p_s_right_ankle_pitch.sine;
  const Scalar& c_right_ankle_pitch = p_s_right_ankle_pitch.cosine;
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
  const Scalar Omega_left_hip_fork_zy = t_left_hip_fork_7 - qd[1] * t_left_hip_fork_6 * 2.0;
  const Scalar t_left_hip_fork_8 = omega_left_hip_fork_x * t_left_hip_fork_6;
  const Scalar t_left_hip_fork_9 = t_left_hip_fork_8 - qdd[1];
  const Scalar t_left_hip_fork_10 = t_left_hip_fork_8 + qdd[1];
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_4 + t_left_hip_fork_5;
  // left_thigh: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_left_thigh_1 = s_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_2 = c_left_hip_pitch * t_left_hip_fork_10 - t_left_thigh_1;
  const Scalar t_left_thigh_3 = c_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar t_left_thigh_4 = t_left_thigh_3 + s_left_hip_pitch * qd[1];
  const Scalar omega_left_thigh_z = t_left_hip_fork_6 + qd[2];
  const Scalar t_left_thigh_5 = 2.0 * omega_left_thigh_z;
  const Scalar Omega_left_thigh_zx = t_left_thigh_2 - t_left_thigh_4 * t_left_thigh_5;
  const Scalar t_left_thigh_6 = c_left_hip_pitch * Omega_left_hip_fork_zy;
  const Scalar Omega_left_thigh_yz = s_left_hip_pitch * t_left_hip_fork_10 + t_left_thigh_6;
  const Scalar t_left_thigh_7 = s_left_hip_pitch * omega_left_hip_fork_x;
  const Scalar omega_left_thigh_y = t_left_thigh_7 - c_left_hip_pitch * qd[1];
  const Scalar t_left_thigh_8 = Omega_left_thigh_yz - t_left_thigh_5 * omega_left_thigh_y;
  const Scalar t_left_thigh_9 = t_left_thigh_4 * t_left_thigh_4;
  const Scalar t_left_thigh_10 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_11 = t_left_thigh_4 * omega_left_thigh_y;
  const Scalar alpha_left_thigh_z = t_left_hip_fork_3 + qdd[2];
  const Scalar t_left_thigh_12 = t_left_thigh_11 - alpha_left_thigh_z;
  const Scalar t_left_thigh_13 = t_left_hip_fork_2 - left_hip_fork_p1 * c_left_hip_roll;
  const Scalar t_left_thigh_14 = t_left_thigh_9 - t_left_thigh_10;
  const Scalar t_left_thigh_15 = t_left_hip_fork_11 - t_left_thigh_14;
  const Scalar t_left_thigh_16 = s_left_hip_pitch * t_left_hip_block_1;
  const Scalar a_left_thigh_x = t_left_thigh_16 + c_left_hip_pitch * t_left_thigh_13;
  const Scalar t_left_thigh_17 = c_left_hip_pitch * t_left_hip_block_1;
  const Scalar a_left_thigh_y = t_left_thigh_17 - s_left_hip_pitch * t_left_thigh_13;
  // left_shank: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_left_shank_1 = a_left_thigh_y - left_hip_fork_k1 * t_left_thigh_12;
  const Scalar t_left_shank_2 = c_left_knee * Omega_left_thigh_yz;
  const Scalar Omega_left_shank_yz = s_left_knee * t_left_thigh_2 + t_left_shank_2;
  const Scalar t_left_shank_3 = c_left_knee * omega_left_thigh_y;
  const Scalar omega_left_shank_y = s_left_knee * t_left_thigh_4 + t_left_shank_3;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_4 = 2.0 * omega_left_shank_z;
  const Scalar t_left_shank_5 = Omega_left_shank_yz - omega_left_shank_y * t_left_shank_4;
  const Scalar t_left_shank_6 = s_left_knee * Omega_left_thigh_yz;
  const Scalar Omega_left_shank_xz = t_left_shank_6 - c_left_knee * t_left_thigh_2;
  const Scalar t_left_shank_7 = s_left_knee * omega_left_thigh_y;
  const Scalar omega_left_shank_x = t_left_shank_7 - c_left_knee * t_left_thigh_4;
  const Scalar t_left_shank_8 = Omega_left_shank_xz - t_left_shank_4 * omega_left_shank_x;
  const Scalar a_left_thigh_z = t_left_hip_fork_7 + left_hip_fork_p1 * s_left_hip_roll;
  const Scalar a_left_shank_z = a_left_thigh_z + left_hip_fork_k1 * Omega_left_thigh_zx;
  const Scalar t_left_shank_9 = a_left_thigh_x - left_hip_fork_k1 * t_left_thigh_15;
  const Scalar a_left_shank_x = c_left_knee * t_left_shank_9 + s_left_knee * t_left_shank_1;
  const Scalar t_left_shank_10 = omega_left_shank_x * omega_left_shank_x;
  const Scalar t_left_shank_11 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_12 = omega_left_shank_y * omega_left_shank_x;
  const Scalar alpha_left_shank_z = alpha_left_thigh_z + qdd[3];
  const Scalar Omega_left_shank_xy = t_left_shank_12 - alpha_left_shank_z;
  const Scalar Omega_left_shank_yx = t_left_shank_12 + alpha_left_shank_z;
  const Scalar t_left_shank_13 = t_left_shank_10 - t_left_shank_11;
  const Scalar t_left_shank_14 = t_left_hip_fork_11 - t_left_shank_13;
  const Scalar t_left_ankle_cross_1 = a_left_shank_x - left_hip_fork_k2 * t_left_shank_14;
  const Scalar a_left_shank_y = c_left_knee * t_left_shank_1 - s_left_knee * t_left_shank_9;
  // left_ankle_cross: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_left_ankle_cross_2 = a_left_shank_y + left_hip_fork_k2 * Omega_left_shank_yx;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_3 = s_left_ankle_pitch * omega_left_shank_x;
  const Scalar t_left_ankle_cross_4 = c_left_ankle_pitch * omega_left_shank_y;
  const Scalar t_left_ankle_cross_5 = t_left_ankle_cross_3 - t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_6 = s_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_7 = c_left_ankle_pitch * Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_8 = t_left_ankle_cross_6 - t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_9 = 2.0 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_10 = t_left_ankle_cross_5 * t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_11 = t_left_ankle_cross_8 - t_left_ankle_cross_10;
  const Scalar t_left_ankle_cross_12 = c_left_ankle_pitch * Omega_left_shank_xz;
  const Scalar t_left_ankle_cross_13 = s_left_ankle_pitch * Omega_left_shank_yz;
  const Scalar t_left_ankle_cross_14 = t_left_ankle_cross_12 + t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_15 = c_left_ankle_pitch * omega_left_shank_x;
  const Scalar t_left_ankle_cross_16 = s_left_ankle_pitch * omega_left_shank_y;
  const Scalar omega_left_ankle_cross_x = t_left_ankle_cross_15 + t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_9 * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_18 = t_left_ankle_cross_14 - t_left_ankle_cross_17;
  const Scalar a_left_ankle_cross_z = a_left_shank_z - left_hip_fork_k2 * t_left_shank_8;
  const Scalar t_left_ankle_cross_19 = omega_left_ankle_cross_x * omega_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_20 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_21 = t_left_ankle_cross_19 - t_left_ankle_cross_20;
  const Scalar t_left_ankle_cross_22 = t_left_ankle_cross_5 * omega_left_ankle_cross_x;
  const Scalar alpha_left_ankle_cross_z = alpha_left_shank_z + qdd[4];
  const Scalar Omega_left_foot_xz = t_left_ankle_cross_22 + alpha_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_23 = t_left_ankle_cross_22 - alpha_left_ankle_cross_z;
  // left_foot: angular velocity omega, Omega of (1)
  const Scalar omega_left_foot_z = t_left_ankle_cross_5 + qd[5];
  const Scalar t_left_foot_1 = 2.0 * omega_left_foot_z;
  const Scalar t_left_foot_2 = omega_left_ankle_cross_z * t_left_foot_1;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_11 + t_left_foot_2;
  // left_ankle_cross: acceleration a of (1)
  const Scalar t_left_ankle_cross_24 = s_left_ankle_pitch * t_left_ankle_cross_1;
  const Scalar t_left_ankle_cross_25 = c_left_ankle_pitch * t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_26 = t_left_ankle_cross_24 - t_left_ankle_cross_25;
  // left_foot: acceleration a of (1)
  const Scalar t_left_foot_3 = t_left_ankle_cross_23 + t_left_ankle_cross_26;
  const Scalar a_left_foot_z = t_left_foot_3 + left_hip_fork_k3 * t_left_ankle_cross_8;
  const Scalar t_left_foot_4 = t_left_ankle_cross_18 - a_left_ankle_cross_z;
  const Scalar t_left_foot_5 = t_left_foot_4 + left_hip_fork_k3 * t_left_hip_fork_11;
  // left_ankle_cross: acceleration a, Omega of (1)
  const Scalar t_left_ankle_cross_27 = s_left_ankle_pitch * t_left_ankle_cross_2;
  const Scalar t_left_ankle_cross_28 = c_left_ankle_pitch * t_left_ankle_cross_1;
  const Scalar a_left_ankle_cross_x = t_left_ankle_cross_27 + t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_29 = t_left_hip_fork_11 - t_left_ankle_cross_21;
  // left_foot: acceleration a, Omega, moment M of (1)
  const Scalar t_left_foot_6 = a_left_ankle_cross_x - t_left_ankle_cross_29;
  const Scalar a_left_foot_x = t_left_foot_6 + left_hip_fork_k3 * t_left_ankle_cross_14;
  const Scalar Omega_left_foot_xy = t_left_ankle_cross_14 - qdd[5];
  const Scalar Omega_left_foot_yx = t_left_ankle_cross_17 - Omega_left_foot_xy;
  const Scalar t_left_foot_7 = Omega_left_foot_xz - omega_left_ankle_cross_x * t_left_foot_1;
  const Scalar t_left_foot_8 = omega_left_foot_z * omega_left_foot_z;
  const Scalar t_left_foot_9 = left_foot_k1 + q[5];
  const auto p_s_left_foot = sine_cosine(t_left_foot_9);
  const Scalar& s_left_foot = p_s_left_foot.sine;
  const Scalar& c_left_foot = p_s_left_foot.cosine;
  const Scalar t_left_foot_10 = left_foot_I4 * c_left_foot + left_foot_I5 * s_left_foot;
  const Scalar t_left_foot_11 = left_foot_I14 - c_left_foot * t_left_foot_10;
  const Scalar t_left_foot_12 = left_foot_I2 * c_left_foot + left_foot_I3 * s_left_foot;
  const Scalar t_left_foot_13 = s_left_foot * t_left_foot_10;
  const Scalar t_left_foot_14 = left_foot_I3 * c_left_foot - left_foot_I2 * s_left_foot;
  const Scalar t_left_foot_15 = left_foot_I1 * c_left_foot;
  const Scalar t_left_foot_16 = left_foot_I13 + t_left_foot_13;
  const Scalar t_left_foot_17 = left_foot_I1 * s_left_foot;
  const Scalar t_left_foot_18 = left_foot_I12 - t_left_foot_13;
  const Scalar t_left_foot_19 = t_left_ankle_cross_21 * t_left_foot_11;
  const Scalar t_left_foot_20 = a_left_foot_x * t_left_foot_17 - t_left_foot_19;
  const Scalar t_left_foot_21 = t_left_foot_20 + Omega_left_foot_xz * t_left_foot_12;
  const Scalar t_left_foot_22 = t_left_foot_21 + t_left_foot_5 * t_left_foot_15;
  const Scalar t_left_foot_23 = t_left_foot_22 + Omega_left_foot_xy * t_left_foot_16;
  const Scalar t_left_foot_24 = t_left_foot_23 + t_left_ankle_cross_11 * t_left_foot_14;
  const Scalar t_left_foot_25 = t_left_foot_24 - Omega_left_foot_yx * t_left_foot_18;
  tau[5] = -t_left_foot_25;
  const Scalar t_left_foot_26 = left_ankle_cross_I1 * a_left_foot_z;
  const Scalar t_left_foot_27 = t_left_foot_7 * t_left_foot_15 - t_left_foot_26;
  const Scalar t_left_foot_28 = t_left_foot_27 - Omega_left_foot_zy * t_left_foot_17;
  const Scalar t_left_foot_29 = Omega_left_foot_xy * t_left_foot_17;
  const Scalar t_left_foot_30 = t_left_foot_15 * (t_left_ankle_cross_20 + t_left_foot_8);
  const Scalar t_left_foot_31 = t_left_foot_29 + left_ankle_cross_I1 * a_left_foot_x;
  const Scalar F_left_foot_x = t_left_foot_31 - t_left_foot_30;
  const Scalar t_right_hip_block_1 = qd[6] * qd[6];
  // right_hip_fork: angular velocity omega, angular acceleration alpha, Omega of (1)
  const Scalar omega_right_hip_fork_x = c_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_1 = omega_right_hip_fork_x * qd[7];
  const Scalar t_right_hip_fork_2 = s_right_hip_roll * qdd[6];
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_1 + t_right_hip_fork_2;
  const Scalar t_right_hip_fork_4 = s_right_hip_roll * qd[6];
  const Scalar t_right_hip_fork_5 = c_right_hip_roll * qdd[6];
  const Scalar Omega_right_hip_fork_zy = t_right_hip_fork_5 - qd[7] * t_right_hip_fork_4 * 2.0;
  const Scalar t_right_hip_fork_6 = omega_right_hip_fork_x * omega_right_hip_fork_x;
  const Scalar t_right_hip_fork_7 = qd[7] * qd[7];
  const Scalar t_right_hip_fork_8 = omega_right_hip_fork_x * t_right_hip_fork_4;
  const Scalar t_right_hip_fork_9 = t_right_hip_fork_8 + qdd[7];
  const Scalar t_right_hip_fork_10 = t_right_hip_fork_6 + t_right_hip_fork_7;
  // right_thigh: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar t_right_thigh_1 = s_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar Omega_right_thigh_xz = t_right_thigh_1 - c_right_hip_pitch * t_right_hip_fork_9;
  const Scalar t_right_thigh_2 = c_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar t_right_thigh_3 = t_right_thigh_2 + s_right_hip_pitch * qd[7];
  const Scalar omega_right_thigh_z = t_right_hip_fork_4 + qd[8];
  const Scalar t_right_thigh_4 = 2.0 * omega_right_thigh_z;
  const Scalar t_right_thigh_5 = Omega_right_thigh_xz + t_right_thigh_3 * t_right_thigh_4;
  const Scalar t_right_thigh_6 = c_right_hip_pitch * Omega_right_hip_fork_zy;
  const Scalar Omega_right_thigh_yz = s_right_hip_pitch * t_right_hip_fork_9 + t_right_thigh_6;
  const Scalar t_right_thigh_7 = s_right_hip_pitch * omega_right_hip_fork_x;
  const Scalar omega_right_thigh_y = t_right_thigh_7 - c_right_hip_pitch * qd[7];
  const Scalar t_right_thigh_8 = Omega_right_thigh_yz - t_right_thigh_4 * omega_right_thigh_y;
  const Scalar t_right_thigh_9 = t_right_thigh_3 * t_right_thigh_3;
  const Scalar t_right_thigh_10 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_11 = t_right_thigh_3 * omega_right_thigh_y;
  const Scalar alpha_right_thigh_z = t_right_hip_fork_3 + qdd[8];
  const Scalar t_right_thigh_12 = t_right_thigh_11 - alpha_right_thigh_z;
  const Scalar t_right_thigh_13 = t_right_thigh_11 + alpha_right_thigh_z;
  const Scalar t_right_thigh_14 = t_right_hip_fork_2 - left_hip_fork_p1 * c_right_hip_roll;
  const Scalar a_right_thigh_z = t_right_hip_fork_5 + left_hip_fork_p1 * s_right_hip_roll;
  const Scalar t_right_thigh_15 = c_right_hip_pitch * t_right_hip_block_1;
  const Scalar a_right_thigh_y = t_right_thigh_15 - s_right_hip_pitch * t_right_thigh_14;
  const Scalar t_right_shank_1 = a_right_thigh_y - left_hip_fork_k1 * t_right_thigh_12;
  const Scalar t_right_thigh_16 = s_right_hip_pitch * t_right_hip_block_1;
  const Scalar a_right_thigh_x = t_right_thigh_16 + c_right_hip_pitch * t_right_thigh_14;
  const Scalar t_right_thigh_17 = t_right_thigh_9 - t_right_thigh_10;
  const Scalar t_right_thigh_18 = t_right_hip_fork_10 - t_right_thigh_17;
  // right_shank: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_right_shank_2 = a_right_thigh_x - left_hip_fork_k1 * t_right_thigh_18;
  const Scalar t_right_shank_3 = c_right_knee * t_right_shank_2;
  const Scalar a_right_shank_x = t_right_shank_3 + s_right_knee * t_right_shank_1;
  const Scalar t_right_shank_4 = s_right_knee * Omega_right_thigh_xz;
  const Scalar t_right_shank_5 = t_right_shank_4 - c_right_knee * Omega_right_thigh_yz;
  const Scalar t_right_shank_6 = c_right_knee * omega_right_thigh_y;
  const Scalar omega_right_shank_y = t_right_shank_6 + s_right_knee * t_right_thigh_3;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar t_right_shank_7 = 2.0 * omega_right_shank_z;
  const Scalar Omega_right_shank_zy = t_right_shank_5 + omega_right_shank_y * t_right_shank_7;
  const Scalar a_right_shank_z = a_right_thigh_z - left_hip_fork_k1 * t_right_thigh_5;
  const Scalar t_right_shank_8 = s_right_knee * Omega_right_thigh_yz;
  const Scalar Omega_right_shank_xz = t_right_shank_8 + c_right_knee * Omega_right_thigh_xz;
  const Scalar t_right_shank_9 = s_right_knee * omega_right_thigh_y;
  const Scalar omega_right_shank_x = t_right_shank_9 - c_right_knee * t_right_thigh_3;
  const Scalar t_right_shank_10 = omega_right_shank_x * omega_right_shank_x;
  const Scalar t_right_shank_11 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_12 = omega_right_shank_y * omega_right_shank_x;
  const Scalar alpha_right_shank_z = alpha_right_thigh_z + qdd[9];
  const Scalar Omega_right_shank_xy = t_right_shank_12 - alpha_right_shank_z;
  const Scalar Omega_right_shank_yx = t_right_shank_12 + alpha_right_shank_z;
  const Scalar t_right_shank_13 = t_right_shank_10 + t_right_shank_11;
  const Scalar t_right_shank_14 = t_right_shank_10 - t_right_shank_11;
  const Scalar t_righ_ankl_cros_1 = left_hip_fork_k2 * (t_right_hip_fork_10 - t_right_shank_14);
  const Scalar t_righ_ankl_cros_2 = a_right_shank_x - t_righ_ankl_cros_1;
  const Scalar t_right_shank_15 = c_right_knee * t_right_shank_1;
  const Scalar a_right_shank_y = t_right_shank_15 - s_right_knee * t_right_shank_2;
  // right_ankle_cross: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_righ_ankl_cros_3 = a_right_shank_y + left_hip_fork_k2 * Omega_right_shank_yx;
  const Scalar t_righ_ankl_cros_4 = c_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_5 = s_right_ankle_pitch * t_righ_ankl_cros_3;
  const Scalar a_righ_ankl_cros_x = t_righ_ankl_cros_4 + t_righ_ankl_cros_5;
  const Scalar t_right_shank_16 = Omega_right_shank_xz - t_right_shank_7 * omega_right_shank_x;
  const Scalar a_righ_ankl_cros_z = a_right_shank_z - left_hip_fork_k2 * t_right_shank_16;
  const Scalar t_righ_ankl_cros_6 = c_right_ankle_pitch * Omega_right_shank_xz;
  const Scalar t_righ_ankl_cros_7 = s_right_ankle_pitch * t_right_shank_5;
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_7 - t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_9 = c_right_ankle_pitch * omega_right_shank_x;
  const Scalar t_righ_ankl_cros_10 = s_right_ankle_pitch * omega_right_shank_y;
  const Scalar omega_righ_ankl_cros_x = t_righ_ankl_cros_9 + t_righ_ankl_cros_10;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_11 = 2.0 * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_12 = omega_righ_ankl_cros_x * t_righ_ankl_cros_11;
  const Scalar Omega_righ_ankl_cros_zx = t_righ_ankl_cros_8 + t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_13 = s_right_ankle_pitch * omega_right_shank_x;
  const Scalar t_righ_ankl_cros_14 = c_right_ankle_pitch * omega_right_shank_y;
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_13 - t_righ_ankl_cros_14;
  const Scalar t_righ_ankl_cros_16 = s_right_ankle_pitch * Omega_right_shank_xz;
  const Scalar t_righ_ankl_cros_17 = c_right_ankle_pitch * t_right_shank_5;
  const Scalar t_righ_ankl_cros_18 = t_righ_ankl_cros_17 + t_righ_ankl_cros_16;
  const Scalar t_righ_ankl_cros_19 = t_righ_ankl_cros_11 * t_righ_ankl_cros_15;
  const Scalar Omega_righ_ankl_cros_zy = t_righ_ankl_cros_18 - t_righ_ankl_cros_19;
  const Scalar t_righ_ankl_cros_20 = omega_righ_ankl_cros_x * omega_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_21 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_20 - t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_23 = omega_righ_ankl_cros_x * t_righ_ankl_cros_15;
  const Scalar alpha_righ_ankl_cros_z = alpha_right_shank_z + qdd[10];
  const Scalar Omega_right_foot_xz = t_righ_ankl_cros_23 + alpha_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_24 = t_righ_ankl_cros_23 - alpha_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_25 = s_right_ankle_pitch * t_righ_ankl_cros_2;
  const Scalar t_righ_ankl_cros_26 = c_right_ankle_pitch * t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_27 = t_righ_ankl_cros_25 - t_righ_ankl_cros_26;
  // right_foot: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_right_foot_1 = t_righ_ankl_cros_24 + t_righ_ankl_cros_27;
  const Scalar a_right_foot_z = t_right_foot_1 - left_hip_fork_k3 * t_righ_ankl_cros_18;
  const Scalar t_right_foot_2 = a_righ_ankl_cros_z + Omega_righ_ankl_cros_zx;
  const Scalar a_right_foot_y = t_right_foot_2 + left_hip_fork_k3 * t_right_hip_fork_10;
  const Scalar omega_right_foot_z = t_righ_ankl_cros_15 + qd[11];
  const Scalar t_right_foot_3 = 2.0 * omega_right_foot_z;
  const Scalar t_right_foot_4 = omega_righ_ankl_cros_z * t_right_foot_3;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy + t_right_foot_4;
  const Scalar t_right_foot_5 = t_right_hip_fork_10 - a_righ_ankl_cros_x;
  const Scalar t_right_foot_6 = t_righ_ankl_cros_22 - t_right_foot_5;
  const Scalar a_right_foot_x = t_right_foot_6 + left_hip_fork_k3 * t_righ_ankl_cros_8;
  const Scalar t_right_foot_7 = t_righ_ankl_cros_8 + qdd[11];
  const Scalar Omega_right_foot_yx = t_righ_ankl_cros_12 + t_right_foot_7;
  const Scalar t_right_foot_8 = omega_right_foot_z * omega_right_foot_z;
  const Scalar t_right_foot_9 = Omega_right_foot_xz - omega_righ_ankl_cros_x * t_right_foot_3;
  const Scalar t_right_foot_10 = left_foot_k1 - q[11];
  const auto p_s_right_foot = sine_cosine(t_right_foot_10);
  const Scalar& s_right_foot = p_s_right_foot.sine;
  const Scalar& c_right_foot = p_s_right_foot.cosine;
  const Scalar t_right_foot_11 = left_foot_I4 * c_right_foot + left_foot_I5 * s_right_foot;
  const Scalar t_right_foot_12 = s_right_foot * t_right_foot_11;
  const Scalar t_right_foot_13 = left_foot_I14 - c_right_foot * t_right_foot_11;
  const Scalar t_right_foot_14 = left_foot_I2 * s_right_foot - left_foot_I3 * c_right_foot;
  const Scalar t_right_foot_15 = left_foot_I3 * s_right_foot + left_foot_I2 * c_right_foot;
  const Scalar t_right_foot_16 = left_foot_I1 * s_right_foot;
  const Scalar t_right_foot_17 = left_foot_I1 * c_right_foot;
  const Scalar t_right_foot_18 = left_foot_I13 + t_right_foot_12;
  const Scalar t_right_foot_19 = left_foot_I12 - t_right_foot_12;
  const Scalar t_right_foot_20 = t_right_foot_7 * t_right_foot_18;
  const Scalar t_right_foot_21 = t_right_foot_20 + a_right_foot_y * t_right_foot_17;
  const Scalar t_right_foot_22 = t_right_foot_21 + a_right_foot_x * t_right_foot_16;
  const Scalar t_right_foot_23 = t_right_foot_22 - t_righ_ankl_cros_22 * t_right_foot_13;
  const Scalar t_right_foot_24 = t_right_foot_23 + Omega_right_foot_yx * t_right_foot_19;
  const Scalar t_right_foot_25 = t_right_foot_24 + Omega_right_foot_xz * t_right_foot_15;
  const Scalar M_right_foot_z = t_right_foot_25 + Omega_righ_ankl_cros_zy * t_right_foot_14;
  tau[11] = M_right_foot_z;
  const Scalar t_right_foot_26 = Omega_right_foot_zy * t_right_foot_16;
  const Scalar t_right_foot_27 = t_right_foot_9 * t_right_foot_17 + t_right_foot_26;
  const Scalar t_right_foot_28 = t_right_foot_27 - left_ankle_cross_I1 * a_right_foot_z;
  const Scalar t_right_foot_29 = t_right_foot_17 * (t_righ_ankl_cros_21 + t_right_foot_8);
  const Scalar t_right_foot_30 = left_ankle_cross_I1 * a_right_foot_x - t_right_foot_29;
  const Scalar F_right_foot_x = t_right_foot_30 + t_right_foot_7 * t_right_foot_16;
  // right_ankle_cross: Omega, moment M of (1)
  const Scalar t_righ_ankl_cros_28 = t_righ_ankl_cros_20 + t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_29 = t_right_hip_fork_10 - t_righ_ankl_cros_28;
  const Scalar t_righ_ankl_cros_30 = left_ankle_cross_I3 * a_righ_ankl_cros_z;
  // right_foot: moment M of (1)
  const Scalar t_right_foot_31 = t_righ_ankl_cros_30 - Omega_right_foot_yx * t_right_foot_14;
  const Scalar t_right_foot_32 = t_right_foot_31 + left_ankle_cross_I10 * t_righ_ankl_cros_24;
  const Scalar t_right_foot_33 = t_right_foot_32 + a_right_foot_z * t_right_foot_16;
  const Scalar t_right_foot_34 = t_right_foot_33 + left_ankle_cross_I2 * t_righ_ankl_cros_29;
  const Scalar t_right_foot_35 = t_right_foot_34 - left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_foot_36 = t_right_foot_35 - left_hip_fork_k3 * t_right_foot_28;
  const Scalar t_right_foot_37 = t_right_foot_15 * (t_righ_ankl_cros_21 - t_right_foot_8);
  const Scalar t_right_foot_38 = t_right_foot_36 - Omega_right_foot_zy * t_right_foot_18;
  const Scalar t_right_foot_39 = t_right_foot_38 - t_right_foot_37;
  const Scalar t_right_foot_40 = t_right_foot_39 + t_right_foot_9 * t_right_foot_13;
  const Scalar t_right_foot_41 = t_right_foot_40 + left_ankle_cross_I8 * Omega_righ_ankl_cros_zx;
  // right_ankle_cross: moment M of (1)
  const Scalar t_righ_ankl_cros_31 = left_ankle_cross_I12 * t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_32 = left_ankle_cross_I3 * a_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_33 = t_right_foot_28 + t_righ_ankl_cros_31;
  const Scalar t_right_foot_42 = t_right_foot_14 * (t_righ_ankl_cros_20 - t_right_foot_8);
  const Scalar t_righ_ankl_cros_34 = t_righ_ankl_cros_33 + t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_35 = t_righ_ankl_cros_34 - t_right_foot_42;
  const Scalar t_righ_ankl_cros_36 = t_righ_ankl_cros_35 - a_right_foot_z * t_right_foot_17;
  const Scalar t_righ_ankl_cros_37 = left_ankle_cross_I2 * t_righ_ankl_cros_8;
  const Scalar t_righ_ankl_cros_38 = t_righ_ankl_cros_22 - t_righ_ankl_cros_29;
  const Scalar t_righ_ankl_cros_39 = t_righ_ankl_cros_36 + t_righ_ankl_cros_37;
  const Scalar t_righ_ankl_cros_40 = left_ankle_cross_I8 * t_righ_ankl_cros_38;
  const Scalar t_righ_ankl_cros_41 = t_righ_ankl_cros_39 + t_righ_ankl_cros_40;
  const Scalar t_righ_ankl_cros_42 = t_righ_ankl_cros_41 + t_right_foot_7 * t_right_foot_15;
  const Scalar t_righ_ankl_cros_43 = t_righ_ankl_cros_42 + t_right_foot_9 * t_right_foot_19;
  const Scalar t_righ_ankl_cros_44 = left_ankle_cross_I10 * t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_45 = t_righ_ankl_cros_43 + t_righ_ankl_cros_44;
  const Scalar t_righ_ankl_cros_46 = t_righ_ankl_cros_45 - Omega_right_foot_zy * t_right_foot_13;
  const Scalar t_righ_ankl_cros_47 = left_ankle_cross_I13 * alpha_righ_ankl_cros_z;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_46 + t_righ_ankl_cros_47;
  tau[10] = M_righ_ankl_cros_z;
  // right_foot: force F of (1)
  const Scalar t_right_foot_43 = t_right_foot_16 * (t_righ_ankl_cros_20 + t_right_foot_8);
  const Scalar t_right_foot_44 = Omega_right_foot_yx * t_right_foot_17 + t_right_foot_43;
  const Scalar F_right_foot_y = t_right_foot_44 + left_ankle_cross_I1 * a_right_foot_y;
  // right_ankle_cross: force F of (1)
  const Scalar t_righ_ankl_cros_48 = F_right_foot_y + left_shank_I14 * a_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_49 = left_ankle_cross_I3 * Omega_righ_ankl_cros_zy;
  const Scalar F_righ_ankl_cros_z = t_righ_ankl_cros_48 - t_righ_ankl_cros_49;
  const Scalar t_righ_ankl_cros_50 = F_right_foot_x + left_shank_I14 * a_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_51 = left_ankle_cross_I3 * Omega_right_foot_xz;
  const Scalar F_righ_ankl_cros_x = t_righ_ankl_cros_50 + t_righ_ankl_cros_51;
  const Scalar t_righ_ankl_cros_52 = t_right_foot_28 - left_shank_I14 * t_righ_ankl_cros_27;
  const Scalar t_righ_ankl_cros_53 = left_ankle_cross_I3 * t_righ_ankl_cros_28;
  const Scalar F_righ_ankl_cros_y = t_righ_ankl_cros_52 + t_righ_ankl_cros_53;
  const Scalar t_righ_ankl_cros_54 = s_right_ankle_pitch * F_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_55 = c_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_56 = t_righ_ankl_cros_54 + t_righ_ankl_cros_55;
  const Scalar t_right_shank_17 = t_right_hip_fork_10 - t_right_shank_13;
  const Scalar t_righ_ankl_cros_57 = M_righ_ankl_cros_z + left_hip_fork_k2 * t_righ_ankl_cros_56;
  // right_shank: moment M of (1)
  const Scalar t_right_shank_18 = t_righ_ankl_cros_57 + left_shank_I6 * Omega_right_shank_xz;
  const Scalar t_right_shank_19 = t_right_shank_18 - left_shank_I13 * Omega_right_shank_yx;
  const Scalar t_right_shank_20 = t_right_shank_19 - left_shank_I1 * a_right_shank_x;
  const Scalar t_right_shank_21 = t_right_shank_20 - left_shank_I10 * Omega_right_shank_xy;
  const Scalar t_right_shank_22 = left_shank_I9 * (t_right_shank_14 - t_right_shank_17);
  const Scalar t_right_shank_23 = t_right_shank_21 + left_shank_I11 * t_right_shank_5;
  const Scalar M_right_shank_z = t_right_shank_23 - t_right_shank_22;
  tau[9] = M_right_shank_z;
  // right_foot: moment M of (1)
  const Scalar t_right_foot_45 = left_hip_fork_k3 * F_right_foot_x;
  const Scalar t_right_foot_46 = M_right_foot_z + F_right_foot_y + t_right_foot_45;
  const Scalar t_right_foot_47 = t_right_foot_46 + left_ankle_cross_I11 * Omega_righ_ankl_cros_zx;
  const Scalar t_right_foot_48 = t_right_foot_47 + left_ankle_cross_I10 * t_righ_ankl_cros_22;
  const Scalar t_right_foot_49 = t_right_foot_48 + left_ankle_cross_I2 * Omega_right_foot_xz;
  const Scalar t_right_foot_50 = t_right_foot_49 - left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_shank_24 = F_righ_ankl_cros_z + left_shank_I1 * Omega_right_shank_zy;
  const Scalar F_right_shank_z = t_right_shank_24 + left_thigh_I14 * a_right_shank_z;
  // right_ankle_cross: moment M of (1)
  const Scalar t_righ_ankl_cros_58 = c_right_ankle_pitch * t_right_foot_41;
  const Scalar t_righ_ankl_cros_59 = t_righ_ankl_cros_58 - s_right_ankle_pitch * t_right_foot_50;
  const Scalar t_righ_ankl_cros_60 = t_righ_ankl_cros_59 - left_shank_I10 * Omega_right_shank_zy;
  const Scalar t_righ_ankl_cros_61 = t_righ_ankl_cros_60 - left_shank_I6 * t_right_shank_17;
  const Scalar t_righ_ankl_cros_62 = t_righ_ankl_cros_61 - left_shank_I11 * Omega_right_shank_yx;
  const Scalar t_righ_ankl_cros_63 = t_righ_ankl_cros_62 - left_shank_I1 * a_right_shank_z;
  const Scalar t_righ_ankl_cros_64 = t_righ_ankl_cros_63 + left_shank_I9 * t_right_shank_16;
  const Scalar t_righ_ankl_cros_65 = s_right_ankle_pitch * t_right_foot_41;
  const Scalar t_righ_ankl_cros_66 = t_righ_ankl_cros_65 + left_shank_I11 * t_right_shank_14;
  const Scalar t_righ_ankl_cros_67 = t_righ_ankl_cros_66 + c_right_ankle_pitch * t_right_foot_50;
  const Scalar t_righ_ankl_cros_68 = t_righ_ankl_cros_67 + left_shank_I9 * Omega_right_shank_zy;
  const Scalar t_righ_ankl_cros_69 = t_righ_ankl_cros_68 + left_shank_I6 * Omega_right_shank_xy;
  const Scalar t_righ_ankl_cros_70 = t_righ_ankl_cros_69 + left_hip_fork_k2 * F_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_71 = t_righ_ankl_cros_70 + left_shank_I13 * t_right_shank_16;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_19 = left_thigh_I12 * t_right_thigh_8;
  const Scalar t_right_thigh_20 = t_right_thigh_19 + left_thigh_I6 * t_right_thigh_13;
  const Scalar t_right_thigh_21 = t_right_thigh_20 - left_thigh_I13 * t_right_thigh_5;
  const Scalar t_right_thigh_22 = t_right_thigh_21 - left_hip_fork_k1 * F_right_shank_z;
  const Scalar t_right_thigh_23 = t_right_thigh_22 - s_right_knee * t_righ_ankl_cros_64;
  const Scalar t_right_thigh_24 = t_right_thigh_23 - left_thigh_I8 * t_right_thigh_17;
  const Scalar M_right_thigh_y = t_right_thigh_24 - c_right_knee * t_righ_ankl_cros_71;
  const Scalar t_righ_ankl_cros_72 = c_right_ankle_pitch * F_righ_ankl_cros_x;
  // right_shank: force F of (1)
  const Scalar t_right_shank_25 = t_righ_ankl_cros_72 + left_thigh_I14 * a_right_shank_x;
  const Scalar t_right_shank_26 = t_right_shank_25 + left_shank_I1 * Omega_right_shank_xy;
  const Scalar F_right_shank_x = t_right_shank_26 - s_right_ankle_pitch * F_righ_ankl_cros_y;
  const Scalar t_right_shank_27 = t_righ_ankl_cros_56 + left_thigh_I14 * a_right_shank_y;
  const Scalar F_right_shank_y = t_right_shank_27 - left_shank_I1 * t_right_shank_13;
  const Scalar t_right_shank_28 = s_right_knee * F_right_shank_x + c_right_knee * F_right_shank_y;
  const Scalar t_right_thigh_25 = t_right_thigh_9 + t_right_thigh_10;
  const Scalar t_right_shank_29 = M_right_shank_z + left_hip_fork_k1 * t_right_shank_28;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_26 = t_right_shank_29 - left_thigh_I2 * a_right_thigh_x;
  const Scalar t_right_thigh_27 = t_right_thigh_26 - left_thigh_I8 * Omega_right_thigh_yz;
  const Scalar t_right_thigh_28 = t_right_thigh_27 + left_thigh_I11 * t_right_thigh_13;
  const Scalar t_right_thigh_29 = t_right_thigh_28 + left_thigh_I6 * Omega_right_thigh_xz;
  const Scalar t_right_thigh_30 = left_thigh_I12 * (t_right_thigh_18 - t_right_thigh_25);
  const Scalar t_right_thigh_31 = t_right_thigh_29 + t_right_thigh_30;
  const Scalar M_right_thigh_z = t_right_thigh_31 + left_thigh_I13 * t_right_thigh_12;
  tau[8] = M_right_thigh_z;
  // right_hip_fork: moment M, Omega of (1)
  const Scalar t_right_hip_fork_11 = t_right_hip_fork_6 - t_right_hip_fork_7;
  const Scalar t_right_hip_fork_12 = t_right_hip_block_1 - t_right_hip_fork_10;
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_8 - qdd[7];
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_32 = left_thigh_I11 * t_right_thigh_8;
  const Scalar t_right_thigh_33 = left_thigh_I2 * a_right_thigh_z - t_right_thigh_32;
  const Scalar t_right_thigh_34 = t_right_thigh_33 - left_thigh_I12 * t_right_thigh_5;
  const Scalar t_right_thigh_35 = t_right_thigh_34 - c_right_knee * t_righ_ankl_cros_64;
  const Scalar t_right_thigh_36 = t_right_thigh_35 - left_thigh_I8 * t_right_thigh_12;
  const Scalar t_right_thigh_37 = left_thigh_I6 * (t_right_hip_fork_10 - t_right_thigh_25);
  const Scalar t_right_thigh_38 = t_right_thigh_36 + s_right_knee * t_righ_ankl_cros_71;
  const Scalar M_right_thigh_x = t_right_thigh_38 + t_right_thigh_37;
  const Scalar t_right_thigh_39 = left_hip_fork_G3 - left_hip_fork_I8 * qdd[6];
  const Scalar t_right_thigh_40 = c_right_hip_roll * t_right_thigh_39;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_11 - t_right_hip_fork_12;
  const Scalar t_right_thigh_41 = c_right_hip_pitch * M_right_thigh_y + t_right_thigh_40;
  const Scalar t_right_thigh_42 = t_right_thigh_41 - left_hip_fork_I7 * t_right_hip_fork_14;
  const Scalar t_right_thigh_43 = left_hip_fork_G2 + left_hip_fork_I9 * qdd[6];
  const Scalar t_right_thigh_44 = t_right_thigh_42 + left_hip_fork_I10 * t_right_hip_fork_13;
  const Scalar t_right_thigh_45 = t_right_thigh_44 - s_right_hip_roll * t_right_thigh_43;
  const Scalar t_right_thigh_46 = t_right_thigh_45 - left_hip_fork_I11 * t_right_hip_fork_9;
  // right_hip_fork: moment M, Omega of (1)
  tau[7] = -(t_right_thigh_46 + s_right_hip_pitch * M_right_thigh_x);
  const Scalar Omega_right_hip_fork_zx = t_right_hip_fork_1 + t_right_hip_fork_3;
  const Scalar t_right_hip_fork_15 = F_right_shank_z - left_hip_fork_I8 * t_right_hip_fork_13;
  const Scalar t_right_hip_fork_16 = left_hip_fork_I9 * t_right_hip_fork_12;
  const Scalar t_right_hip_fork_17 = t_right_hip_fork_15 - t_right_hip_fork_16;
  const Scalar t_right_hip_fork_18 = t_right_hip_fork_17 - left_thigh_I2 * t_right_thigh_8;
  const Scalar t_right_hip_fork_19 = t_right_hip_fork_18 + s_right_hip_pitch * M_right_thigh_y;
  const Scalar t_right_hip_fork_20 = left_hip_fork_I7 * Omega_right_hip_fork_zx;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_19 - t_right_hip_fork_20;
  const Scalar t_right_hip_fork_22 = t_right_hip_fork_21 - c_right_hip_pitch * M_right_thigh_x;
  const Scalar t_right_hip_fork_23 = left_hip_fork_I11 * Omega_right_hip_fork_zy;
  const Scalar M_right_hip_fork_x = t_right_hip_fork_22 + t_right_hip_fork_23;
  const Scalar F_right_thigh_y = t_right_shank_28 - left_thigh_I2 * t_right_thigh_25;
  const Scalar t_right_shank_30 = c_right_knee * F_right_shank_x - s_right_knee * F_right_shank_y;
  // right_thigh: force F, moment M of (1)
  const Scalar F_right_thigh_x = t_right_shank_30 - left_thigh_I2 * t_right_thigh_13;
  const Scalar t_right_thigh_47 = M_right_thigh_z + left_hip_fork_I9 * t_right_hip_fork_9;
  const Scalar t_right_thigh_48 = t_right_thigh_47 - s_right_hip_pitch * F_right_thigh_y;
  const Scalar t_right_thigh_49 = t_right_thigh_48 + c_right_hip_pitch * F_right_thigh_x;
  const Scalar t_right_thigh_50 = t_right_thigh_49 + left_hip_fork_I10 * Omega_right_hip_fork_zx;
  const Scalar t_right_thigh_51 = t_right_thigh_50 + left_hip_fork_I8 * t_right_hip_fork_11;
  const Scalar t_right_hip_fork_24 = c_right_hip_roll * M_right_hip_fork_x;
  const Scalar t_right_thigh_52 = t_right_thigh_51 - left_hip_fork_I7 * Omega_right_hip_fork_zy;
  const Scalar t_right_hip_block_2 = left_hip_block_I2 * qdd[6] + t_right_hip_fork_24;
  tau[6] = t_right_hip_block_2 + s_right_hip_roll * t_right_thigh_52;
  const Scalar t_left_ankle_cross_30 = t_left_ankle_cross_19 + t_left_ankle_cross_20;
  const Scalar t_left_foot_32 = t_left_ankle_cross_19 + t_left_foot_8;
  // left_ankle_cross: moment M of (1)
  const Scalar t_left_ankle_cross_31 = t_left_hip_fork_11 - t_left_ankle_cross_30;
  const Scalar t_left_ankle_cross_32 = left_ankle_cross_I10 * t_left_ankle_cross_23;
  const Scalar t_left_ankle_cross_33 = left_ankle_cross_I8 * t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_34 = t_left_ankle_cross_33 + t_left_ankle_cross_32;
  const Scalar t_left_ankle_cross_35 = t_left_ankle_cross_34 + t_left_foot_7 * t_left_foot_11;
  const Scalar t_left_ankle_cross_36 = left_ankle_cross_I3 * a_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_37 = t_left_ankle_cross_35 - t_left_ankle_cross_36;
  const Scalar t_left_ankle_cross_38 = t_left_ankle_cross_37 - left_hip_fork_k3 * t_left_foot_28;
  const Scalar t_left_foot_33 = Omega_left_foot_zy * t_left_foot_16;
  const Scalar t_left_foot_34 = t_left_foot_12 * (t_left_ankle_cross_30 - t_left_foot_32);
  const Scalar t_left_ankle_cross_39 = t_left_ankle_cross_38 + t_left_foot_33 - t_left_foot_34;
  const Scalar t_left_ankle_cross_40 = t_left_ankle_cross_39 + a_left_foot_z * t_left_foot_17;
  const Scalar t_left_ankle_cross_41 = left_ankle_cross_I9 * t_left_ankle_cross_11;
  const Scalar t_left_ankle_cross_42 = t_left_ankle_cross_40 + t_left_ankle_cross_41;
  const Scalar t_left_ankle_cross_43 = left_ankle_cross_I2 * t_left_ankle_cross_31;
  const Scalar t_left_ankle_cross_44 = t_left_ankle_cross_42 + t_left_ankle_cross_43;
  const Scalar M_left_ankle_cross_x = t_left_ankle_cross_44 - Omega_left_foot_yx * t_left_foot_14;
  // left_foot: force F of (1)
  const Scalar t_left_foot_35 = Omega_left_foot_yx * t_left_foot_15;
  const Scalar t_left_foot_36 = t_left_foot_17 * t_left_foot_32 - t_left_foot_35;
  const Scalar t_left_foot_37 = t_left_foot_36 + left_ankle_cross_I1 * t_left_foot_5;
  // left_ankle_cross: moment M, force F of (1)
  const Scalar t_left_ankle_cross_45 = left_ankle_cross_I2 * Omega_left_foot_xz;
  const Scalar t_left_ankle_cross_46 = t_left_foot_25 + t_left_foot_37 + t_left_ankle_cross_45;
  const Scalar t_left_ankle_cross_47 = left_ankle_cross_I10 * t_left_ankle_cross_21;
  const Scalar t_left_ankle_cross_48 = t_left_ankle_cross_46 + t_left_ankle_cross_47;
  const Scalar t_left_ankle_cross_49 = left_ankle_cross_I11 * t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_50 = t_left_ankle_cross_48 + t_left_ankle_cross_49;
  const Scalar t_left_ankle_cross_51 = t_left_ankle_cross_50 + left_hip_fork_k3 * F_left_foot_x;
  const Scalar t_left_ankle_cross_52 = left_ankle_cross_I8 * t_left_ankle_cross_11;
  const Scalar M_left_ankle_cross_y = t_left_ankle_cross_51 + t_left_ankle_cross_52;
  const Scalar t_left_ankle_cross_53 = left_ankle_cross_I3 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_54 = t_left_foot_28 + t_left_ankle_cross_53;
  const Scalar t_left_ankle_cross_55 = t_left_ankle_cross_54 + t_left_foot_7 * t_left_foot_18;
  const Scalar t_left_ankle_cross_56 = t_left_ankle_cross_55 - a_left_foot_z * t_left_foot_15;
  const Scalar t_left_ankle_cross_57 = left_ankle_cross_I9 * Omega_left_foot_xz;
  const Scalar t_left_ankle_cross_58 = t_left_ankle_cross_56 + t_left_ankle_cross_57;
  const Scalar t_left_ankle_cross_59 = left_ankle_cross_I11 * t_left_ankle_cross_23;
  const Scalar t_left_foot_38 = t_left_foot_14 * (t_left_ankle_cross_19 - t_left_foot_8);
  const Scalar t_left_ankle_cross_60 = t_left_ankle_cross_58 - t_left_ankle_cross_59;
  const Scalar t_left_ankle_cross_61 = t_left_ankle_cross_21 - t_left_ankle_cross_31;
  const Scalar t_left_ankle_cross_62 = left_ankle_cross_I8 * t_left_ankle_cross_61;
  const Scalar t_left_ankle_cross_63 = t_left_ankle_cross_60 + t_left_foot_38;
  const Scalar t_left_ankle_cross_64 = t_left_ankle_cross_63 + t_left_ankle_cross_62;
  const Scalar t_left_ankle_cross_65 = left_ankle_cross_I2 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_66 = t_left_ankle_cross_64 + t_left_ankle_cross_65;
  const Scalar t_left_foot_39 = Omega_left_foot_zy * t_left_foot_11;
  const Scalar t_left_ankle_cross_67 = left_ankle_cross_I10 * t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_68 = t_left_ankle_cross_66 + t_left_foot_39;
  const Scalar t_left_ankle_cross_69 = t_left_ankle_cross_68 - t_left_ankle_cross_67;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_69 + Omega_left_foot_xy * t_left_foot_12;
  tau[4] = M_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_70 = t_left_foot_28 - left_shank_I14 * t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_71 = left_ankle_cross_I3 * t_left_ankle_cross_30;
  const Scalar F_left_ankle_cross_y = t_left_ankle_cross_70 + t_left_ankle_cross_71;
  const Scalar t_left_ankle_cross_72 = F_left_foot_x + left_shank_I14 * a_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_73 = left_ankle_cross_I3 * Omega_left_foot_xz;
  const Scalar F_left_ankle_cross_x = t_left_ankle_cross_72 + t_left_ankle_cross_73;
  const Scalar t_left_shank_15 = t_left_shank_10 + t_left_shank_11;
  const Scalar t_left_ankle_cross_74 = s_left_ankle_pitch * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_75 = c_left_ankle_pitch * F_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_76 = t_left_ankle_cross_74 + t_left_ankle_cross_75;
  // left_shank: moment M, force F of (1)
  const Scalar t_left_shank_16 = M_left_ankle_cross_z - left_shank_I6 * Omega_left_shank_xz;
  const Scalar t_left_shank_17 = t_left_shank_16 - left_shank_I15 * t_left_shank_12;
  const Scalar t_left_shank_18 = t_left_shank_17 + left_shank_I11 * Omega_left_shank_yz;
  const Scalar t_left_shank_19 = left_shank_I9 * (t_left_shank_14 - t_left_shank_15);
  const Scalar t_left_shank_20 = t_left_shank_18 + t_left_shank_19;
  const Scalar t_left_shank_21 = t_left_shank_20 - left_shank_I16 * alpha_left_shank_z;
  const Scalar t_left_shank_22 = t_left_shank_21 - left_shank_I1 * a_left_shank_x;
  const Scalar M_left_shank_z = t_left_shank_22 + left_hip_fork_k2 * t_left_ankle_cross_76;
  tau[3] = M_left_shank_z;
  const Scalar t_left_shank_23 = t_left_ankle_cross_76 - left_shank_I1 * t_left_shank_15;
  const Scalar F_left_shank_y = t_left_shank_23 + left_thigh_I14 * a_left_shank_y;
  const Scalar t_left_foot_40 = t_left_foot_37 + left_ankle_cross_I3 * t_left_ankle_cross_11;
  const Scalar t_left_foot_41 = t_left_foot_40 - left_shank_I14 * a_left_ankle_cross_z;
  const Scalar t_left_thigh_18 = t_left_thigh_11 + alpha_left_thigh_z;
  const Scalar t_left_ankle_cross_77 = s_left_ankle_pitch * M_left_ankle_cross_x;
  const Scalar t_left_shank_24 = t_left_ankle_cross_77 + left_shank_I6 * Omega_left_shank_xy;
  const Scalar t_left_shank_25 = t_left_shank_24 + left_shank_I11 * t_left_shank_13;
  const Scalar t_left_shank_26 = t_left_shank_25 + left_hip_fork_k2 * t_left_foot_41;
  const Scalar t_left_shank_27 = t_left_shank_26 - left_shank_I13 * t_left_shank_8;
  const Scalar t_left_shank_28 = t_left_shank_27 + left_shank_I9 * t_left_shank_5;
  const Scalar M_left_shank_y = t_left_shank_28 + c_left_ankle_pitch * M_left_ankle_cross_y;
  // left_ankle_cross: force F of (1)
  const Scalar t_left_ankle_cross_78 = t_left_foot_41 - left_thigh_I14 * a_left_shank_z;
  const Scalar t_left_ankle_cross_79 = t_left_ankle_cross_78 + left_shank_I1 * t_left_shank_5;
  const Scalar t_left_ankle_cross_80 = c_left_ankle_pitch * M_left_ankle_cross_x;
  // left_shank: moment M of (1)
  const Scalar t_left_shank_29 = t_left_ankle_cross_80 - left_shank_I10 * t_left_shank_5;
  const Scalar t_left_shank_30 = left_shank_I6 * (t_left_hip_fork_11 - t_left_shank_15);
  const Scalar t_left_shank_31 = left_shank_I11 * Omega_left_shank_yx;
  const Scalar t_left_shank_32 = t_left_shank_29 - t_left_shank_30 - t_left_shank_31;
  const Scalar t_left_shank_33 = t_left_shank_32 - left_shank_I9 * t_left_shank_8;
  const Scalar t_left_shank_34 = t_left_shank_33 + left_shank_I1 * a_left_shank_z;
  const Scalar M_left_shank_x = t_left_shank_34 - s_left_ankle_pitch * M_left_ankle_cross_y;
  const Scalar t_left_thigh_19 = left_thigh_I12 * t_left_thigh_8;
  const Scalar t_left_thigh_20 = left_thigh_I6 * t_left_thigh_18 - t_left_thigh_19;
  const Scalar t_left_shank_35 = t_left_thigh_20 - c_left_knee * M_left_shank_y;
  const Scalar t_left_shank_36 = t_left_shank_35 - left_thigh_I13 * Omega_left_thigh_zx;
  const Scalar t_left_shank_37 = t_left_shank_36 - left_hip_fork_k1 * t_left_ankle_cross_79;
  const Scalar t_left_shank_38 = t_left_shank_37 - left_thigh_I8 * t_left_thigh_14;
  const Scalar t_left_shank_39 = t_left_shank_38 - s_left_knee * M_left_shank_x;
  // left_thigh: Omega, moment M of (1)
  const Scalar t_left_thigh_21 = t_left_thigh_9 + t_left_thigh_10;
  const Scalar t_left_thigh_22 = t_left_hip_fork_11 - t_left_thigh_21;
  const Scalar t_left_thigh_23 = left_thigh_I2 * a_left_thigh_z - left_thigh_I6 * t_left_thigh_22;
  const Scalar t_left_thigh_24 = t_left_thigh_23 - left_thigh_I11 * t_left_thigh_8;
  const Scalar t_left_thigh_25 = t_left_thigh_24 + c_left_knee * M_left_shank_x;
  const Scalar t_left_thigh_26 = t_left_thigh_25 + left_thigh_I12 * Omega_left_thigh_zx;
  const Scalar t_left_thigh_27 = t_left_thigh_26 - s_left_knee * M_left_shank_y;
  const Scalar M_left_thigh_x = t_left_thigh_27 + left_thigh_I8 * t_left_thigh_12;
  const Scalar t_left_ankle_cross_81 = c_left_ankle_pitch * F_left_ankle_cross_x;
  // left_shank: force F of (1)
  const Scalar t_left_shank_40 = left_thigh_I14 * a_left_shank_x + t_left_ankle_cross_81;
  const Scalar t_left_shank_41 = t_left_shank_40 - s_left_ankle_pitch * F_left_ankle_cross_y;
  const Scalar F_left_shank_x = t_left_shank_41 + left_shank_I1 * Omega_left_shank_xy;
  const Scalar t_left_shank_42 = c_left_knee * F_left_shank_y + s_left_knee * F_left_shank_x;
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_28 = M_left_shank_z + left_thigh_I6 * t_left_thigh_2;
  const Scalar t_left_thigh_29 = left_thigh_I12 * (t_left_thigh_14 - t_left_thigh_22);
  const Scalar t_left_thigh_30 = t_left_thigh_28 + left_thigh_I16 * t_left_thigh_11;
  const Scalar t_left_thigh_31 = t_left_thigh_30 - t_left_thigh_29;
  const Scalar t_left_thigh_32 = t_left_thigh_31 + left_thigh_I8 * Omega_left_thigh_yz;
  const Scalar t_left_thigh_33 = t_left_thigh_32 + left_hip_fork_k1 * t_left_shank_42;
  const Scalar t_left_thigh_34 = t_left_thigh_33 - left_thigh_I15 * alpha_left_thigh_z;
  const Scalar M_left_thigh_z = t_left_thigh_34 - left_thigh_I2 * a_left_thigh_x;
  tau[2] = M_left_thigh_z;
  // left_hip_fork: moment M, Omega of (1)
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_4 - t_left_hip_fork_5;
  const Scalar t_left_hip_fork_13 = t_left_hip_block_1 - t_left_hip_fork_11;
  const Scalar t_left_hip_fork_14 = left_hip_fork_G2 - left_hip_fork_I9 * qdd[0];
  const Scalar t_left_hip_fork_15 = left_hip_fork_I11 * t_left_hip_fork_10;
  const Scalar t_left_hip_fork_16 = s_left_hip_roll * t_left_hip_fork_14 + t_left_hip_fork_15;
  const Scalar t_left_hip_fork_17 = t_left_hip_fork_16 + c_left_hip_pitch * t_left_shank_39;
  const Scalar t_left_hip_fork_18 = left_hip_fork_I7 * (t_left_hip_fork_12 - t_left_hip_fork_13);
  const Scalar t_left_hip_fork_19 = t_left_hip_fork_17 - left_hip_fork_I10 * t_left_hip_fork_9;
  const Scalar t_left_hip_fork_20 = left_hip_fork_G3 + left_hip_fork_I8 * qdd[0];
  const Scalar t_left_hip_fork_21 = t_left_hip_fork_19 - t_left_hip_fork_18;
  const Scalar t_left_hip_fork_22 = t_left_hip_fork_21 + c_left_hip_roll * t_left_hip_fork_20;
  tau[1] = t_left_hip_fork_22 - s_left_hip_pitch * M_left_thigh_x;
  const Scalar F_left_thigh_y = t_left_shank_42 - left_thigh_I2 * t_left_thigh_21;
  const Scalar t_left_shank_43 = left_thigh_I2 * t_left_thigh_18 + s_left_knee * F_left_shank_y;
  const Scalar Omega_left_hip_fork_zx = t_left_hip_fork_1 + t_left_hip_fork_3;
  const Scalar t_left_thigh_35 = M_left_thigh_z + left_hip_fork_I8 * t_left_hip_fork_12;
  const Scalar t_left_thigh_36 = t_left_thigh_35 - s_left_hip_pitch * F_left_thigh_y;
  const Scalar t_left_shank_44 = t_left_shank_43 - c_left_knee * F_left_shank_x;
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_37 = t_left_thigh_36 - left_hip_fork_I9 * t_left_hip_fork_10;
  const Scalar t_left_thigh_38 = t_left_thigh_37 - c_left_hip_pitch * t_left_shank_44;
  const Scalar t_left_thigh_39 = t_left_thigh_38 + left_hip_fork_I7 * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_40 = t_left_ankle_cross_79 - left_hip_fork_I9 * t_left_hip_fork_13;
  const Scalar t_left_thigh_41 = t_left_thigh_40 + c_left_hip_pitch * M_left_thigh_x;
  const Scalar t_left_thigh_42 = t_left_thigh_41 + left_hip_fork_I8 * t_left_hip_fork_9;
  const Scalar t_left_thigh_43 = t_left_thigh_42 - left_hip_fork_I11 * Omega_left_hip_fork_zy;
  const Scalar t_left_thigh_44 = t_left_thigh_43 - left_hip_fork_I7 * Omega_left_hip_fork_zx;
  const Scalar t_left_thigh_45 = t_left_thigh_44 + left_thigh_I2 * t_left_thigh_8;
  const Scalar t_left_thigh_46 = t_left_thigh_39 + left_hip_fork_I10 * Omega_left_hip_fork_zx;
  const Scalar t_left_hip_fork_23 = s_left_hip_roll * t_left_thigh_46;
  const Scalar t_left_thigh_47 = t_left_thigh_45 + s_left_hip_pitch * t_left_shank_39;
  // left_hip_block: moment M of (1)
  tau[0] = left_hip_block_I2 * qdd[0] + t_left_hip_fork_23 - c_left_hip_roll * t_left_thigh_47;
}

void forward_dynamics(const Scalar q[12], const Scalar qd[12], const Scalar tau[12],
                      Scalar qdd[12]) noexcept {
  const auto p_s_left_hip_roll = sine_cosine(q[1]);
  const Scalar& s_left_hip_roll = p_s_left_hip_roll.sine;
  const Scalar& c_left_hip_roll = p_s_left_hip_roll.cosine;
  // left_shank: way s to the joint of (1)
  const auto p_s_left_hip_pitch = sine_cosine(q[2]);
  const Scalar& s_left_hip_pitch = p_s_left_hip_pitch.sine;
  const Scalar& c_left_hip_pitch = p_s_left_hip_pitch.cosine;
  const Scalar t_left_shank_1 = left_shank_l1 * c_left_hip_pitch;
  const Scalar t_left_shank_2 = left_shank_l1 * s_left_hip_pitch;
  // left_ankle_cross: angular velocity omega, way s to the joint of (1)
  const Scalar q_q2_q3 = q[2] + q[3];
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const auto p_s_q2_q3_q4 = sine_cosine(q_q2_q3_q4);
  const Scalar& s_q2_q3_q4 = p_s_q2_q3_q4.sine;
  const Scalar& c_q2_q3_q4 = p_s_q2_q3_q4.cosine;
  const auto p_s_q2_q3 = sine_cosine(q_q2_q3);
  const Scalar& s_q2_q3 = p_s_q2_q3.sine;
  const Scalar& c_q2_q3 = p_s_q2_q3.cosine;
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_l1 * c_q2_q3;
  const Scalar t_left_ankle_cross_2 = left_ankle_cross_l1 * s_q2_q3;
  const auto p_s_right_hip_roll = sine_cosine(q[7]);
  const Scalar& s_right_hip_roll = p_s_right_hip_roll.sine;
  const Scalar& c_right_hip_roll = p_s_right_hip_roll.cosine;
  // right_shank: way s to the joint of (1)
  const auto p_s_right_hip_pitch = sine_cosine(q[8]);
  const Scalar& s_right_hip_pitch = p_s_right_hip_pitch.sine;
  const Scalar& c_right_hip_pitch = p_s_right_hip_pitch.cosine;
  const Scalar t_right_shank_1 = left_shank_l1 * c_right_hip_pitch;
  const Scalar t_right_shank_2 = left_shank_l1 * s_right_hip_pitch;
  // right_ankle_cross: acceleration a, way s to the joint of (1)
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const auto p_s_q8_q9_q10 = sine_cosine(q_q8_q9_q10);
  const Scalar& s_q8_q9_q10 = p_s_q8_q9_q10.sine;
  const Scalar& c_q8_q9_q10 = p_s_q8_q9_q10.cosine;
  const auto p_s_q8_q9 = sine_cosine(q_q8_q9);
  const Scalar& s_q8_q9 = p_s_q8_q9.sine;
  const Scalar& c_q8_q9 = p_s_q8_q9.cosine;
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_l1 * c_q8_q9;
  const Scalar t_righ_ankl_cros_2 = left_ankle_cross_l1 * s_q8_q9;
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
  const Scalar t_left_shank_3 = t_left_hip_fork_1 - t_left_hip_fork_4;
  const Scalar omega_left_thigh_z = t_left_hip_fork_2 + qd[2];
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_2 * qd[1];
  const Scalar Omega_left_thigh_yz = 2.0 * t_left_hip_fork_6;
  const Scalar t_left_thigh_1 = 2.0 * qd[1];
  const Scalar Omega_left_thigh_zy = qd[2] * t_left_thigh_1;
  const Scalar t_left_thigh_2 = omega_left_thigh_z * omega_left_thigh_z;
  const Scalar t_left_thigh_3 = t_left_hip_fork_4 + t_left_thigh_2;
  const Scalar t_left_thigh_4 = 2.0 * omega_left_hip_fork_x;
  const Scalar t_left_thigh_5 = Omega_left_thigh_xz - omega_left_thigh_z * t_left_thigh_4;
  const Scalar t_left_thigh_6 = left_hip_fork_l1 * (t_left_hip_fork_1 + t_left_hip_fork_3);
  const Scalar t_left_thigh_7 = left_thigh_I4 * c_left_hip_pitch;
  const Scalar t_left_thigh_8 = t_left_thigh_7 + left_thigh_I3 * s_left_hip_pitch;
  const Scalar t_left_thigh_9 = c_left_hip_pitch * t_left_thigh_8;
  const Scalar t_left_thigh_10 = left_thigh_I12 - t_left_thigh_9;
  const Scalar t_left_thigh_11 = s_left_hip_pitch * t_left_thigh_8;
  const Scalar t_left_thigh_12 = left_thigh_I6 * s_left_hip_pitch;
  const Scalar t_left_thigh_13 = t_left_thigh_12 - left_thigh_I5 * c_left_hip_pitch;
  const Scalar Omega_left_hip_fork_zx = qd[1] * t_left_thigh_4;
  const Scalar t_left_thigh_14 = left_thigh_I5 * s_left_hip_pitch;
  const Scalar t_left_thigh_15 = t_left_thigh_14 + left_thigh_I6 * c_left_hip_pitch;
  const Scalar t_left_thigh_16 = left_thigh_h3 * s_left_hip_pitch;
  const Scalar t_left_thigh_17 = t_left_thigh_16 + left_thigh_h1 * c_left_hip_pitch;
  const Scalar t_left_thigh_18 = left_thigh_h1 * s_left_hip_pitch;
  const Scalar t_left_thigh_19 = t_left_thigh_18 - left_thigh_h3 * c_left_hip_pitch;
  const Scalar t_left_thigh_20 = left_thigh_I17 - t_left_thigh_11;
  // left_shank: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_left_shank_4 = a_left_thigh_z - t_left_shank_2 * Omega_left_thigh_zy;
  const Scalar a_left_shank_z = t_left_shank_4 + t_left_shank_1 * t_left_thigh_5;
  const Scalar omega_left_shank_z = omega_left_thigh_z + qd[3];
  const Scalar t_left_shank_5 = t_left_thigh_5 - t_left_thigh_4 * qd[3];
  const Scalar t_left_shank_6 = Omega_left_thigh_yz - t_left_thigh_1 * omega_left_shank_z;
  const Scalar t_left_shank_7 = omega_left_shank_z * omega_left_shank_z;
  const Scalar t_left_shank_8 = left_shank_I3 * c_q2_q3 + left_shank_I4 * s_q2_q3;
  const Scalar t_left_shank_9 = s_q2_q3 * t_left_shank_8;
  const Scalar t_left_shank_10 = c_q2_q3 * t_left_shank_8;
  const Scalar t_left_shank_11 = left_shank_I9 - t_left_shank_10;
  const Scalar t_left_shank_12 = left_shank_I6 * s_q2_q3 - left_shank_I5 * c_q2_q3;
  const Scalar t_left_shank_13 = left_shank_I6 * c_q2_q3 + left_shank_I5 * s_q2_q3;
  const Scalar t_left_shank_14 = left_shank_h2 * c_q2_q3 + left_shank_h3 * s_q2_q3;
  const Scalar t_left_shank_15 = left_shank_I17 - t_left_shank_9;
  const Scalar t_left_shank_16 = left_shank_h2 * s_q2_q3 - left_shank_h3 * c_q2_q3;
  const Scalar t_left_shank_17 = t_left_hip_fork_1 + t_left_shank_7;
  const Scalar t_left_shank_18 = t_left_thigh_6 + t_left_shank_1 * Omega_left_hip_fork_zx;
  const Scalar t_left_shank_19 = t_left_shank_2 * (t_left_hip_fork_1 + t_left_thigh_2);
  const Scalar t_left_shank_20 = t_left_shank_18 - t_left_shank_19;
  // left_ankle_cross: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_left_ankle_cross_3 = t_left_ankle_cross_1 * Omega_left_hip_fork_zx;
  const Scalar t_left_ankle_cross_4 = t_left_shank_20 + t_left_ankle_cross_3;
  const Scalar t_left_ankle_cross_5 = t_left_ankle_cross_2 * t_left_shank_17;
  const Scalar t_left_ankle_cross_6 = t_left_ankle_cross_4 - t_left_ankle_cross_5;
  const Scalar t_left_shank_21 = t_left_hip_fork_4 + t_left_shank_7;
  const Scalar a_left_shank_x = a_left_hip_fork_x + t_left_shank_1 * t_left_thigh_3;
  const Scalar t_left_ankle_cross_7 = t_left_ankle_cross_1 * t_left_shank_21;
  const Scalar t_left_ankle_cross_8 = a_left_shank_x + t_left_ankle_cross_7;
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_2 * t_left_shank_6;
  const Scalar t_left_ankle_cross_10 = t_left_ankle_cross_1 * t_left_shank_5;
  const Scalar t_left_ankle_cross_11 = a_left_shank_z + t_left_ankle_cross_9;
  const Scalar a_left_ankle_cross_z = t_left_ankle_cross_11 + t_left_ankle_cross_10;
  const Scalar omega_left_ankle_cross_z = omega_left_shank_z + qd[4];
  const Scalar t_left_ankle_cross_12 = s_q2_q3_q4 * omega_left_hip_fork_x;
  const Scalar omega_left_ankle_cross_y = t_left_ankle_cross_12 - c_q2_q3_q4 * qd[1];
  const Scalar t_left_ankle_cross_13 = t_left_hip_fork_2 * t_left_ankle_cross_12;
  const Scalar t_left_ankle_cross_14 = c_q2_q3_q4 * Omega_left_thigh_yz - t_left_ankle_cross_13;
  const Scalar t_left_ankle_cross_15 = 2.0 * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_16 = omega_left_ankle_cross_y * t_left_ankle_cross_15;
  const Scalar t_left_ankle_cross_17 = t_left_ankle_cross_14 + t_left_ankle_cross_16;
  const Scalar t_left_ankle_cross_18 = c_q2_q3_q4 * omega_left_hip_fork_x;
  const Scalar t_left_ankle_cross_19 = t_left_ankle_cross_18 + s_q2_q3_q4 * qd[1];
  const Scalar t_left_ankle_cross_20 = t_left_hip_fork_2 * t_left_ankle_cross_18;
  const Scalar t_left_ankle_cross_21 = s_q2_q3_q4 * Omega_left_thigh_yz + t_left_ankle_cross_20;
  const Scalar t_left_ankle_cross_22 = t_left_ankle_cross_15 * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_23 = t_left_ankle_cross_21 - t_left_ankle_cross_22;
  const Scalar t_left_ankle_cross_24 = t_left_ankle_cross_19 * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_25 = omega_left_ankle_cross_z * omega_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_26 = t_left_ankle_cross_24 - t_left_ankle_cross_25;
  const Scalar t_left_ankle_cross_27 = t_left_hip_fork_5 - t_left_ankle_cross_26;
  const Scalar t_left_ankle_cross_28 = omega_left_ankle_cross_y * t_left_ankle_cross_19;
  const Scalar t_left_ankle_cross_29 = alpha_left_thigh_z - t_left_ankle_cross_28;
  const Scalar Omega_left_foot_xz = alpha_left_thigh_z + t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_30 = t_left_ankle_cross_24 + t_left_ankle_cross_25;
  // left_foot: angular velocity omega, Omega, first moment h of (1)
  const Scalar t_left_foot_1 = omega_left_ankle_cross_y - qd[5];
  const Scalar t_left_foot_2 = t_left_ankle_cross_15 * t_left_foot_1;
  const Scalar Omega_left_foot_zy = t_left_ankle_cross_17 - t_left_foot_2;
  const Scalar t_left_foot_3 = t_left_foot_1 * t_left_foot_1;
  const Scalar t_left_foot_4 = t_left_ankle_cross_19 * t_left_foot_1 * 2.0;
  const Scalar t_left_foot_5 = Omega_left_foot_xz - t_left_foot_4;
  const Scalar t_left_foot_6 = left_foot_k2 + q[5];
  const auto p_s_left_foot = sine_cosine(t_left_foot_6);
  const Scalar& s_left_foot = p_s_left_foot.sine;
  const Scalar& c_left_foot = p_s_left_foot.cosine;
  const Scalar t_left_foot_7 = left_foot_h2 * c_left_foot - left_foot_h3 * s_left_foot;
  const Scalar h_left_foot_x = left_foot_h3 * c_left_foot + left_foot_h2 * s_left_foot;
  const Scalar t_left_foot_8 = left_foot_I15 * s_left_foot + left_foot_I16 * c_left_foot;
  const Scalar t_left_foot_9 = s_left_foot * t_left_foot_8;
  const Scalar E_left_foot_xx = left_foot_I17 - t_left_foot_9;
  const Scalar E_left_foot_xz = left_foot_I18 * c_left_foot;
  const Scalar E_left_foot_yz = left_foot_I18 * s_left_foot;
  const Scalar t_left_foot_10 = c_left_foot * t_left_foot_8;
  const Scalar t_left_foot_11 = left_foot_I20 - t_left_foot_10;
  const Scalar t_left_foot_12 = left_hip_fork_l2 * t_left_foot_7;
  const Scalar t_left_foot_13 = Omega_left_foot_zy * t_left_foot_7;
  const Scalar t_left_foot_14 = t_left_foot_13 + t_left_foot_5 * h_left_foot_x;
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
  const Scalar t_right_shank_3 = t_right_hip_fork_3 - t_right_hip_fork_4;
  // right_thigh: angular velocity omega, Omega, acceleration a of (1)
  const Scalar omega_right_thigh_z = t_right_hip_fork_1 + qd[8];
  const Scalar t_right_thigh_1 = omega_right_thigh_z * omega_right_thigh_z;
  const Scalar t_right_thigh_2 = t_right_hip_fork_3 - t_right_thigh_1;
  const Scalar t_right_thigh_3 = t_right_hip_fork_4 + t_right_thigh_1;
  const Scalar t_right_thigh_4 = 2.0 * omega_right_hip_fork_x;
  const Scalar t_right_thigh_5 = Omega_right_thigh_xz - omega_right_thigh_z * t_right_thigh_4;
  const Scalar t_right_hip_fork_6 = qd[7] * t_right_hip_fork_1;
  const Scalar Omega_right_thigh_yz = 2.0 * t_right_hip_fork_6;
  const Scalar t_right_thigh_6 = 2.0 * qd[7];
  const Scalar Omega_right_thigh_zy = qd[8] * t_right_thigh_6;
  const Scalar t_right_hip_fork_7 = t_right_hip_fork_2 + t_right_hip_fork_3;
  const Scalar t_right_thigh_7 = left_hip_fork_l1 * t_right_hip_fork_7;
  const Scalar t_right_thigh_8 = left_thigh_I3 * s_right_hip_pitch;
  const Scalar t_right_thigh_9 = t_right_thigh_8 + left_thigh_I4 * c_right_hip_pitch;
  const Scalar t_right_thigh_10 = s_right_hip_pitch * t_right_thigh_9;
  const Scalar t_right_thigh_11 = c_right_hip_pitch * t_right_thigh_9;
  const Scalar t_right_thigh_12 = left_thigh_I12 - t_right_thigh_11;
  const Scalar t_right_thigh_13 = left_thigh_I5 * c_right_hip_pitch;
  const Scalar t_right_thigh_14 = t_right_thigh_13 - left_thigh_I6 * s_right_hip_pitch;
  const Scalar Omega_right_hip_fork_zx = 2.0 * alpha_right_thigh_z;
  const Scalar t_right_thigh_15 = left_thigh_I5 * s_right_hip_pitch;
  const Scalar t_right_thigh_16 = t_right_thigh_15 + left_thigh_I6 * c_right_hip_pitch;
  const Scalar t_right_thigh_17 = left_thigh_h1 * c_right_hip_pitch;
  const Scalar t_right_thigh_18 = t_right_thigh_17 + left_thigh_h3 * s_right_hip_pitch;
  const Scalar t_right_thigh_19 = left_thigh_I17 - t_right_thigh_10;
  const Scalar t_right_thigh_20 = left_thigh_h1 * s_right_hip_pitch;
  const Scalar t_right_thigh_21 = t_right_thigh_20 - left_thigh_h3 * c_right_hip_pitch;
  // right_shank: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_right_shank_4 = a_right_thigh_z - t_right_shank_2 * Omega_right_thigh_zy;
  const Scalar a_right_shank_z = t_right_shank_4 + t_right_shank_1 * t_right_thigh_5;
  const Scalar omega_right_shank_z = omega_right_thigh_z + qd[9];
  const Scalar t_right_shank_5 = t_right_thigh_5 - t_right_thigh_4 * qd[9];
  const Scalar t_right_shank_6 = Omega_right_thigh_yz - t_right_thigh_6 * omega_right_shank_z;
  const Scalar t_right_shank_7 = omega_right_shank_z * omega_right_shank_z;
  const Scalar t_right_shank_8 = t_right_hip_fork_4 + t_right_shank_7;
  const Scalar t_right_shank_9 = t_right_hip_fork_3 + t_right_shank_7;
  const Scalar t_right_shank_10 = left_shank_I3 * c_q8_q9 + left_shank_I4 * s_q8_q9;
  const Scalar t_right_shank_11 = s_q8_q9 * t_right_shank_10;
  const Scalar t_right_shank_12 = c_q8_q9 * t_right_shank_10;
  const Scalar t_right_shank_13 = left_shank_I9 - t_right_shank_12;
  const Scalar t_right_shank_14 = left_shank_I5 * c_q8_q9 - left_shank_I6 * s_q8_q9;
  const Scalar t_right_shank_15 = left_shank_I6 * c_q8_q9 + left_shank_I5 * s_q8_q9;
  const Scalar t_right_shank_16 = left_shank_h2 * c_q8_q9 + left_shank_h3 * s_q8_q9;
  const Scalar t_right_shank_17 = left_shank_h2 * s_q8_q9 - left_shank_h3 * c_q8_q9;
  const Scalar t_right_shank_18 = left_shank_I17 - t_right_shank_11;
  const Scalar a_right_shank_x = a_right_hip_fork_x + t_right_shank_1 * t_right_thigh_3;
  const Scalar t_righ_ankl_cros_3 = a_right_shank_x + t_righ_ankl_cros_1 * t_right_shank_8;
  const Scalar t_right_thigh_22 = t_right_hip_fork_3 + t_right_thigh_1;
  const Scalar t_right_shank_19 = t_right_shank_1 * Omega_right_hip_fork_zx;
  const Scalar t_right_shank_20 = t_right_thigh_7 + t_right_shank_19;
  const Scalar t_right_shank_21 = t_right_shank_20 - t_right_shank_2 * t_right_thigh_22;
  // right_ankle_cross: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_1 * Omega_right_hip_fork_zx;
  const Scalar t_righ_ankl_cros_5 = t_right_shank_21 + t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_6 = t_righ_ankl_cros_2 * t_right_shank_9;
  const Scalar t_righ_ankl_cros_7 = t_righ_ankl_cros_5 - t_righ_ankl_cros_6;
  const Scalar t_righ_ankl_cros_8 = c_q8_q9_q10 * t_righ_ankl_cros_3;
  const Scalar t_righ_ankl_cros_9 = t_righ_ankl_cros_8 - s_q8_q9_q10 * t_righ_ankl_cros_7;
  const Scalar t_righ_ankl_cros_10 = a_right_shank_z + t_righ_ankl_cros_1 * t_right_shank_5;
  const Scalar t_righ_ankl_cros_11 = t_righ_ankl_cros_2 * t_right_shank_6;
  const Scalar a_righ_ankl_cros_z = t_righ_ankl_cros_10 + t_righ_ankl_cros_11;
  const Scalar t_righ_ankl_cros_12 = s_q8_q9_q10 * qd[7] + c_q8_q9_q10 * omega_right_hip_fork_x;
  const Scalar omega_righ_ankl_cros_z = omega_right_shank_z + qd[10];
  const Scalar t_righ_ankl_cros_13 = s_q8_q9_q10 * Omega_right_thigh_yz;
  const Scalar t_right_foot_1 = t_righ_ankl_cros_13 + c_q8_q9_q10 * Omega_right_thigh_xz;
  const Scalar t_righ_ankl_cros_14 = 2.0 * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_15 = t_righ_ankl_cros_12 * t_righ_ankl_cros_14;
  const Scalar Omega_righ_ankl_cros_zx = t_right_foot_1 - t_righ_ankl_cros_15;
  const Scalar t_righ_ankl_cros_16 = t_righ_ankl_cros_12 * t_righ_ankl_cros_12;
  const Scalar t_righ_ankl_cros_17 = omega_righ_ankl_cros_z * omega_righ_ankl_cros_z;
  const Scalar t_righ_ankl_cros_18 = t_righ_ankl_cros_16 - t_righ_ankl_cros_17;
  const Scalar t_righ_ankl_cros_19 = t_right_hip_fork_5 - t_righ_ankl_cros_18;
  const Scalar t_righ_ankl_cros_20 = c_q8_q9_q10 * Omega_right_thigh_yz;
  const Scalar t_righ_ankl_cros_21 = t_righ_ankl_cros_20 - s_q8_q9_q10 * Omega_right_thigh_xz;
  const Scalar omega_righ_ankl_cros_y = s_q8_q9_q10 * omega_right_hip_fork_x - c_q8_q9_q10 * qd[7];
  const Scalar t_righ_ankl_cros_22 = t_righ_ankl_cros_14 * omega_righ_ankl_cros_y;
  const Scalar Omega_righ_ankl_cros_zy = t_righ_ankl_cros_21 + t_righ_ankl_cros_22;
  const Scalar t_righ_ankl_cros_23 = t_righ_ankl_cros_12 * omega_righ_ankl_cros_y;
  const Scalar Omega_righ_ankl_cros_yx = alpha_right_thigh_z - t_righ_ankl_cros_23;
  const Scalar Omega_right_foot_xz = alpha_right_thigh_z + t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_24 = t_righ_ankl_cros_16 + t_righ_ankl_cros_17;
  // right_foot: angular velocity omega, Omega, pseudo-inertia E of (1)
  const Scalar t_right_foot_2 = omega_righ_ankl_cros_y - qd[11];
  const Scalar t_right_foot_3 = t_righ_ankl_cros_14 * t_right_foot_2;
  const Scalar Omega_right_foot_zy = Omega_righ_ankl_cros_zy - t_right_foot_3;
  const Scalar t_right_foot_4 = t_right_foot_2 * t_right_foot_2;
  const Scalar t_right_foot_5 = t_righ_ankl_cros_16 - t_right_foot_4;
  const Scalar t_right_foot_6 = t_righ_ankl_cros_12 * t_right_foot_2 * 2.0;
  const Scalar t_right_foot_7 = Omega_right_foot_xz - t_right_foot_6;
  const Scalar t_right_foot_8 = left_foot_k2 - q[11];
  const auto p_s_right_foot = sine_cosine(t_right_foot_8);
  const Scalar& s_right_foot = p_s_right_foot.sine;
  const Scalar& c_right_foot = p_s_right_foot.cosine;
  const Scalar t_right_foot_9 = left_foot_I16 * c_right_foot + left_foot_I15 * s_right_foot;
  const Scalar t_right_foot_10 = c_right_foot * t_right_foot_9;
  const Scalar E_right_foot_xy = left_foot_I20 - t_right_foot_10;
  const Scalar t_right_foot_11 = left_foot_I18 * s_right_foot;
  const Scalar t_right_foot_12 = s_right_foot * t_right_foot_9;
  const Scalar E_right_foot_xx = left_foot_I17 - t_right_foot_12;
  const Scalar E_right_foot_xz = left_foot_I18 * c_right_foot;
  const Scalar h_right_foot_x = left_foot_h2 * s_right_foot + left_foot_h3 * c_right_foot;
  const Scalar E_right_foot_yy = left_foot_I19 + t_right_foot_12;
  const Scalar h_right_foot_y = left_foot_h2 * c_right_foot - left_foot_h3 * s_right_foot;
  const Scalar t_right_foot_13 = Omega_right_foot_zy * h_right_foot_y;
  const Scalar F_right_foot_z = t_right_foot_13 - t_right_foot_7 * h_right_foot_x;
  const Scalar t_righ_ankl_cros_25 = c_q8_q9_q10 * t_righ_ankl_cros_7;
  const Scalar a_righ_ankl_cros_y = t_righ_ankl_cros_25 + s_q8_q9_q10 * t_righ_ankl_cros_3;
  const Scalar t_right_foot_14 = a_righ_ankl_cros_y + left_hip_fork_l1 * Omega_righ_ankl_cros_yx;
  const Scalar t_right_foot_15 = t_right_foot_14 + left_hip_fork_l2 * t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_26 = left_ankle_cross_I8 + E_right_foot_xz;
  const Scalar t_right_foot_16 = Omega_right_foot_zy * E_right_foot_yy;
  // right_ankle_cross: pseudo-inertia E of (1)
  const Scalar t_righ_ankl_cros_27 = t_right_hip_fork_5 - t_righ_ankl_cros_24;
  const Scalar t_righ_ankl_cros_28 = left_hip_fork_l2 * F_right_foot_z - t_right_foot_16;
  const Scalar t_righ_ankl_cros_29 = left_ankle_cross_I2 * t_righ_ankl_cros_27;
  const Scalar t_righ_ankl_cros_30 = t_righ_ankl_cros_28 + t_righ_ankl_cros_29;
  const Scalar t_right_foot_17 = t_right_foot_11 * (t_righ_ankl_cros_17 - t_right_foot_4);
  const Scalar t_righ_ankl_cros_31 = t_righ_ankl_cros_30 + t_right_foot_7 * E_right_foot_xy;
  const Scalar t_righ_ankl_cros_32 = left_ankle_cross_I17 * Omega_righ_ankl_cros_yx;
  const Scalar t_righ_ankl_cros_33 = t_righ_ankl_cros_31 - t_right_foot_17;
  const Scalar t_righ_ankl_cros_34 = t_righ_ankl_cros_33 - t_righ_ankl_cros_32;
  const Scalar t_righ_ankl_cros_35 = left_ankle_cross_I9 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_36 = t_righ_ankl_cros_34 - t_righ_ankl_cros_35;
  const Scalar t_righ_ankl_cros_37 = t_righ_ankl_cros_36 + h_right_foot_y * t_right_foot_15;
  const Scalar t_righ_ankl_cros_38 = Omega_righ_ankl_cros_zx * t_righ_ankl_cros_26;
  const Scalar t_righ_ankl_cros_39 = t_righ_ankl_cros_37 + t_righ_ankl_cros_38;
  const Scalar t_right_foot_18 = t_righ_ankl_cros_39 + left_ankle_cross_h1 * a_righ_ankl_cros_z;
  const Scalar t_right_foot_19 = left_hip_fork_l1 * h_right_foot_x;
  const Scalar E_righ_ankl_cros_yz = left_ankle_cross_I2 + t_right_foot_11;
  const Scalar t_righ_ankl_cros_40 = left_ankle_cross_h2 * Omega_righ_ankl_cros_yx;
  const Scalar t_righ_ankl_cros_41 = left_ankle_cross_h1 * t_righ_ankl_cros_24;
  // right_foot: force F of (1)
  const Scalar t_right_foot_20 = F_right_foot_z - t_righ_ankl_cros_40 - t_righ_ankl_cros_41;
  const Scalar t_right_foot_21 = h_right_foot_x * (t_righ_ankl_cros_24 - t_right_foot_5);
  const Scalar t_right_foot_22 = t_right_foot_21 + t_right_foot_1 * h_right_foot_y;
  // right_ankle_cross: force F of (1)
  const Scalar t_righ_ankl_cros_42 = left_ankle_cross_h1 * Omega_right_foot_xz;
  const Scalar t_righ_ankl_cros_43 = left_ankle_cross_h2 * t_righ_ankl_cros_19;
  const Scalar t_righ_ankl_cros_44 = t_right_foot_22 - t_righ_ankl_cros_42;
  const Scalar t_right_foot_23 = t_righ_ankl_cros_44 + t_righ_ankl_cros_43;
  const Scalar t_righ_ankl_cros_45 = s_q8_q9_q10 * t_right_foot_20;
  const Scalar t_righ_ankl_cros_46 = t_righ_ankl_cros_45 - c_q8_q9_q10 * t_right_foot_23;
  const Scalar t_right_foot_24 = h_right_foot_y * (t_righ_ankl_cros_16 + t_right_foot_4);
  const Scalar t_right_foot_25 = t_right_foot_24 - Omega_righ_ankl_cros_zx * h_right_foot_x;
  const Scalar t_righ_ankl_cros_47 = left_ankle_cross_h2 * Omega_righ_ankl_cros_zx;
  const Scalar t_righ_ankl_cros_48 = left_ankle_cross_h1 * Omega_righ_ankl_cros_zy;
  const Scalar t_righ_ankl_cros_49 = t_right_foot_25 - t_righ_ankl_cros_47;
  const Scalar t_right_foot_26 = t_righ_ankl_cros_49 + t_righ_ankl_cros_48;
  const Scalar t_right_shank_22 = t_right_foot_26 + t_right_shank_5 * t_right_shank_17;
  const Scalar t_righ_ankl_cros_50 = t_right_shank_22 - t_right_shank_6 * t_right_shank_16;
  const Scalar t_right_thigh_23 = t_right_thigh_14 + t_right_shank_14;
  const Scalar t_right_hip_fork_8 = t_right_hip_fork_2 - t_right_hip_fork_4;
  const Scalar t_right_thigh_24 = Omega_right_thigh_zy * t_right_thigh_18;
  const Scalar t_right_thigh_25 = t_righ_ankl_cros_50 + t_right_thigh_24;
  const Scalar t_right_shank_23 = t_right_thigh_25 + t_right_thigh_5 * t_right_thigh_21;
  // right_foot: moment M, acceleration a of (1)
  const Scalar t_right_foot_27 = E_right_foot_xx + t_right_foot_19;
  const Scalar t_right_foot_28 = t_righ_ankl_cros_9 - left_hip_fork_l2 * t_right_foot_1;
  const Scalar t_right_foot_29 = Omega_right_foot_xz * t_right_foot_11;
  const Scalar t_right_foot_30 = t_right_foot_1 * E_right_foot_yy + t_right_foot_29;
  const Scalar t_right_foot_31 = a_righ_ankl_cros_z + left_hip_fork_l2 * t_right_hip_fork_5;
  const Scalar t_right_foot_32 = t_right_foot_30 - t_righ_ankl_cros_18 * E_right_foot_xy;
  const Scalar t_right_foot_33 = t_right_foot_32 + h_right_foot_x * t_right_foot_31;
  const Scalar t_right_foot_34 = t_right_foot_33 - Omega_righ_ankl_cros_zy * E_right_foot_xz;
  const Scalar t_right_foot_35 = t_right_foot_28 + left_hip_fork_l1 * t_righ_ankl_cros_19;
  const Scalar t_right_foot_36 = t_right_foot_34 + Omega_righ_ankl_cros_zx * t_right_foot_27;
  const Scalar M_right_foot_z = t_right_foot_36 + h_right_foot_y * t_right_foot_35;
  const Scalar t_right_foot_37 = M_right_foot_z + left_ankle_cross_I2 * Omega_right_foot_xz;
  const Scalar t_right_foot_38 = t_right_foot_37 + left_ankle_cross_h2 * a_righ_ankl_cros_z;
  const Scalar t_right_foot_39 = t_right_foot_38 + left_ankle_cross_I17 * t_righ_ankl_cros_18;
  const Scalar t_right_foot_40 = t_right_foot_39 - left_hip_fork_l2 * t_right_foot_22;
  const Scalar t_right_foot_41 = t_right_foot_40 - left_hip_fork_l1 * t_right_foot_25;
  const Scalar t_righ_ankl_cros_51 = left_ankle_cross_I18 * Omega_righ_ankl_cros_zx;
  const Scalar t_righ_ankl_cros_52 = left_ankle_cross_I8 * Omega_righ_ankl_cros_zy;
  const Scalar t_right_foot_42 = t_right_foot_41 + t_righ_ankl_cros_51;
  const Scalar t_right_foot_43 = t_right_foot_42 - t_righ_ankl_cros_52;
  const Scalar t_right_thigh_26 = t_right_hip_fork_5 - t_right_thigh_22;
  const Scalar t_right_shank_24 = t_right_hip_fork_5 - t_right_shank_9;
  const Scalar t_right_thigh_27 = left_thigh_I11 + t_right_thigh_10;
  const Scalar t_right_hip_fork_9 = left_hip_fork_I8 * Omega_right_thigh_xz;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_28 = t_right_hip_fork_9 - c_q8_q9_q10 * t_right_foot_18;
  const Scalar t_right_thigh_29 = t_right_thigh_28 + left_hip_fork_I13 * t_right_hip_fork_6;
  const Scalar t_right_thigh_30 = t_right_thigh_29 + left_hip_fork_I1 * t_right_hip_fork_8;
  const Scalar t_right_thigh_31 = t_right_thigh_30 - t_right_shank_5 * t_right_shank_13;
  const Scalar t_right_shank_25 = t_right_shank_6 * (left_shank_I10 + t_right_shank_11);
  const Scalar t_right_thigh_32 = t_right_thigh_31 + t_right_shank_25;
  const Scalar t_right_thigh_33 = t_right_thigh_32 + left_hip_fork_I3 * alpha_right_thigh_z;
  const Scalar t_right_thigh_34 = Omega_right_hip_fork_zx * t_right_thigh_23;
  const Scalar t_right_thigh_35 = t_right_thigh_33 + t_right_thigh_34;
  const Scalar t_right_thigh_36 = t_right_thigh_35 + left_hip_fork_l1 * t_right_shank_23;
  const Scalar t_right_thigh_37 = t_right_thigh_36 + a_right_thigh_z * t_right_thigh_18;
  const Scalar t_right_thigh_38 = t_right_thigh_37 - t_right_shank_2 * t_righ_ankl_cros_50;
  const Scalar t_right_thigh_39 = t_right_thigh_38 - t_righ_ankl_cros_2 * t_right_foot_26;
  const Scalar t_right_thigh_40 = t_right_thigh_39 + s_q8_q9_q10 * t_right_foot_43;
  const Scalar t_right_thigh_41 = t_right_thigh_40 + t_right_thigh_16 * t_right_thigh_26;
  const Scalar t_right_thigh_42 = t_right_thigh_41 + t_right_shank_15 * t_right_shank_24;
  const Scalar t_right_thigh_43 = t_right_thigh_42 - t_right_thigh_5 * t_right_thigh_12;
  const Scalar t_right_thigh_44 = t_right_thigh_43 - Omega_right_thigh_zy * t_right_thigh_27;
  const Scalar t_right_thigh_45 = t_right_thigh_44 + a_right_shank_z * t_right_shank_16;
  // left_ankle_cross: acceleration a, pseudo-inertia E, moment M of (1)
  const Scalar t_left_ankle_cross_31 = s_q2_q3_q4 * t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_32 = c_q2_q3_q4 * t_left_ankle_cross_6;
  const Scalar a_left_ankle_cross_y = t_left_ankle_cross_31 + t_left_ankle_cross_32;
  const Scalar E_left_foot_yy = left_foot_I19 + t_left_foot_9;
  const Scalar t_left_ankle_cross_33 = left_ankle_cross_I8 + E_left_foot_xz;
  const Scalar t_left_foot_15 = a_left_ankle_cross_y - left_hip_fork_l2 * t_left_ankle_cross_14;
  const Scalar t_left_foot_16 = t_left_foot_15 + left_hip_fork_l1 * t_left_ankle_cross_29;
  const Scalar t_left_ankle_cross_34 = t_left_hip_fork_5 - t_left_ankle_cross_30;
  const Scalar t_left_ankle_cross_35 = left_ankle_cross_I17 * t_left_ankle_cross_29;
  const Scalar t_left_ankle_cross_36 = left_ankle_cross_I2 * t_left_ankle_cross_34;
  const Scalar t_left_ankle_cross_37 = t_left_ankle_cross_36 - t_left_ankle_cross_35;
  const Scalar t_left_foot_17 = t_left_foot_7 * t_left_foot_16;
  const Scalar t_left_foot_18 = E_left_foot_yz * (t_left_ankle_cross_25 - t_left_foot_3);
  const Scalar t_left_ankle_cross_38 = t_left_ankle_cross_37 + t_left_foot_17;
  const Scalar t_left_ankle_cross_39 = left_ankle_cross_I9 * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_40 = t_left_ankle_cross_38 - t_left_foot_18;
  const Scalar t_left_ankle_cross_41 = t_left_ankle_cross_40 + t_left_ankle_cross_39;
  const Scalar t_left_foot_19 = t_left_foot_5 * t_left_foot_11;
  const Scalar t_left_ankle_cross_42 = t_left_ankle_cross_41 + t_left_foot_19;
  const Scalar t_left_foot_20 = Omega_left_foot_zy * E_left_foot_yy;
  const Scalar t_left_ankle_cross_43 = t_left_ankle_cross_42 + t_left_foot_20;
  const Scalar t_left_ankle_cross_44 = left_ankle_cross_h1 * a_left_ankle_cross_z;
  const Scalar t_left_ankle_cross_45 = t_left_ankle_cross_43 - t_left_ankle_cross_44;
  const Scalar t_left_ankle_cross_46 = t_left_ankle_cross_23 * t_left_ankle_cross_33;
  const Scalar t_left_ankle_cross_47 = t_left_ankle_cross_45 - t_left_ankle_cross_46;
  const Scalar M_left_ankle_cross_x = t_left_ankle_cross_47 - left_hip_fork_l2 * t_left_foot_14;
  const Scalar t_left_ankle_cross_48 = left_ankle_cross_I2 + E_left_foot_yz;
  const Scalar t_left_ankle_cross_49 = c_q2_q3_q4 * t_left_ankle_cross_8;
  const Scalar t_left_ankle_cross_50 = s_q2_q3_q4 * t_left_ankle_cross_6;
  const Scalar t_left_ankle_cross_51 = t_left_ankle_cross_49 - t_left_ankle_cross_50;
  // left_foot: moment M, Omega, force F of (1)
  const Scalar t_left_foot_21 = left_hip_fork_l1 * t_left_ankle_cross_27;
  const Scalar t_left_foot_22 = t_left_ankle_cross_24 - t_left_foot_3;
  const Scalar t_left_foot_23 = t_left_foot_7 * (t_left_ankle_cross_24 + t_left_foot_3);
  const Scalar F_left_foot_y = t_left_ankle_cross_23 * h_left_foot_x + t_left_foot_23;
  const Scalar t_left_foot_24 = left_hip_fork_l2 * h_left_foot_x;
  const Scalar t_left_foot_25 = t_left_ankle_cross_21 * (t_left_foot_12 - E_left_foot_yy);
  const Scalar t_left_foot_26 = t_left_foot_7 * (t_left_ankle_cross_51 + t_left_foot_21);
  const Scalar t_left_foot_27 = t_left_ankle_cross_26 * t_left_foot_11 - t_left_foot_25;
  const Scalar t_left_foot_28 = t_left_ankle_cross_23 * E_left_foot_xx;
  const Scalar t_left_foot_29 = t_left_foot_27 - t_left_foot_26 + t_left_foot_28;
  const Scalar t_left_foot_30 = t_left_foot_29 - t_left_ankle_cross_17 * E_left_foot_xz;
  const Scalar t_left_foot_31 = t_left_foot_30 - Omega_left_foot_xz * E_left_foot_yz;
  const Scalar t_left_foot_32 = a_left_ankle_cross_z + left_hip_fork_l1 * t_left_ankle_cross_23;
  const Scalar t_left_foot_33 = t_left_foot_31 - t_left_hip_fork_5 * t_left_foot_24;
  const Scalar M_left_foot_z = t_left_foot_33 + h_left_foot_x * t_left_foot_32;
  const Scalar t_left_foot_34 = h_left_foot_x * (t_left_ankle_cross_30 - t_left_foot_22);
  const Scalar F_left_foot_x = t_left_ankle_cross_21 * t_left_foot_7 - t_left_foot_34;
  const Scalar t_left_foot_35 = M_left_foot_z - left_ankle_cross_I2 * Omega_left_foot_xz;
  const Scalar t_left_foot_36 = t_left_foot_35 + left_hip_fork_l1 * F_left_foot_y;
  const Scalar t_left_foot_37 = t_left_foot_36 - left_ankle_cross_I8 * t_left_ankle_cross_17;
  const Scalar t_left_foot_38 = t_left_foot_37 + left_ankle_cross_h2 * a_left_ankle_cross_z;
  const Scalar t_left_foot_39 = t_left_foot_38 + left_ankle_cross_I18 * t_left_ankle_cross_23;
  const Scalar t_left_foot_40 = t_left_foot_39 - left_ankle_cross_I17 * t_left_ankle_cross_26;
  const Scalar t_left_foot_41 = t_left_foot_40 - left_hip_fork_l2 * F_left_foot_x;
  const Scalar t_left_foot_42 = t_left_foot_14 + left_ankle_cross_h1 * t_left_ankle_cross_30;
  const Scalar t_left_ankle_cross_52 = left_ankle_cross_h2 * t_left_ankle_cross_29;
  const Scalar F_left_ankle_cross_y = t_left_foot_42 + t_left_ankle_cross_52;
  const Scalar t_left_foot_43 = F_left_foot_x - left_ankle_cross_h2 * t_left_ankle_cross_27;
  // left_ankle_cross: force F of (1)
  const Scalar F_left_ankle_cross_x = t_left_foot_43 + left_ankle_cross_h1 * Omega_left_foot_xz;
  const Scalar t_left_ankle_cross_53 = left_ankle_cross_h1 * t_left_ankle_cross_17;
  const Scalar t_left_ankle_cross_54 = left_ankle_cross_h2 * t_left_ankle_cross_23;
  const Scalar t_left_ankle_cross_55 = F_left_foot_y - t_left_ankle_cross_53;
  const Scalar F_left_ankle_cross_z = t_left_ankle_cross_55 + t_left_ankle_cross_54;
  const Scalar t_left_shank_22 = F_left_ankle_cross_z + t_left_shank_6 * t_left_shank_14;
  const Scalar F_left_shank_z = t_left_shank_22 - t_left_shank_5 * t_left_shank_16;
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_21 = t_left_thigh_13 + t_left_shank_12;
  const Scalar t_left_thigh_22 = left_hip_fork_l1 * t_left_thigh_19;
  const Scalar t_left_thigh_23 = left_hip_fork_l1 - t_left_shank_2;
  const Scalar t_left_shank_23 = t_left_hip_fork_4 - t_left_shank_7;
  const Scalar t_left_thigh_24 = left_hip_fork_I3 - 2.0 * t_left_thigh_21;
  const Scalar t_left_thigh_25 = left_thigh_I11 + t_left_thigh_11;
  const Scalar t_left_shank_24 = left_shank_I10 + t_left_shank_9;
  const Scalar t_left_thigh_26 = t_left_thigh_10 - t_left_thigh_22;
  const Scalar t_left_hip_fork_7 = left_hip_fork_I8 * Omega_left_thigh_xz;
  const Scalar t_left_hip_fork_8 = t_left_hip_fork_3 - t_left_hip_fork_4;
  const Scalar t_left_thigh_27 = t_left_hip_fork_7 + c_q2_q3_q4 * M_left_ankle_cross_x;
  const Scalar t_left_thigh_28 = a_left_thigh_z + left_hip_fork_l1 * Omega_left_thigh_zy;
  const Scalar t_left_thigh_29 = t_left_thigh_27 - left_hip_fork_I1 * t_left_hip_fork_8;
  const Scalar t_left_thigh_30 = t_left_thigh_29 + t_left_thigh_17 * t_left_thigh_28;
  const Scalar t_left_thigh_31 = t_left_thigh_30 - F_left_shank_z * t_left_thigh_23;
  const Scalar t_left_thigh_32 = t_left_thigh_31 - Omega_left_thigh_zy * t_left_thigh_25;
  const Scalar t_left_thigh_33 = t_left_thigh_32 - t_left_shank_5 * t_left_shank_11;
  const Scalar t_left_ankle_cross_56 = t_left_ankle_cross_2 * F_left_ankle_cross_z;
  const Scalar t_left_thigh_34 = t_left_thigh_33 + t_left_ankle_cross_56;
  const Scalar t_left_thigh_35 = t_left_thigh_15 * (t_left_hip_fork_4 - t_left_thigh_2);
  const Scalar t_left_thigh_36 = t_left_thigh_34 + left_hip_fork_I13 * t_left_hip_fork_6;
  const Scalar t_left_thigh_37 = t_left_thigh_36 - t_left_thigh_35;
  const Scalar t_left_thigh_38 = t_left_thigh_37 - t_left_shank_13 * t_left_shank_23;
  const Scalar t_left_thigh_39 = t_left_thigh_38 - alpha_left_thigh_z * t_left_thigh_24;
  const Scalar t_left_thigh_40 = t_left_thigh_39 + s_q2_q3_q4 * t_left_foot_41;
  const Scalar t_left_thigh_41 = t_left_thigh_40 + t_left_shank_6 * t_left_shank_24;
  const Scalar t_left_thigh_42 = t_left_thigh_41 + a_left_shank_z * t_left_shank_14;
  const Scalar t_left_thigh_43 = t_left_thigh_42 - t_left_thigh_5 * t_left_thigh_26;
  const Scalar t_left_hip_block_1 = M_right_foot_z - tau[11];
  const Scalar h_righ_ankl_cros_x = left_ankle_cross_h2 + h_right_foot_x;
  const Scalar t_right_foot_44 = E_right_foot_xx + E_right_foot_yy;
  const Scalar t_right_foot_45 = left_hip_fork_l1 * h_right_foot_y;
  // right_ankle_cross: first moment h, pseudo-inertia E of (1)
  const Scalar t_righ_ankl_cros_53 = t_right_foot_19 + t_right_foot_27;
  const Scalar t_righ_ankl_cros_54 = left_ankle_cross_h1 * s_q8_q9_q10;
  const Scalar t_righ_ankl_cros_55 = t_righ_ankl_cros_54 + c_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar h_right_shank_x = t_right_shank_17 - t_righ_ankl_cros_55;
  const Scalar t_righ_ankl_cros_56 = left_ankle_cross_h1 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_57 = t_righ_ankl_cros_56 - s_q8_q9_q10 * h_righ_ankl_cros_x;
  const Scalar t_righ_ankl_cros_58 = t_right_shank_16 - t_righ_ankl_cros_57;
  const Scalar t_righ_ankl_cros_59 = left_ankle_cross_I19 + t_right_foot_10;
  const Scalar t_righ_ankl_cros_60 = t_right_foot_45 - t_righ_ankl_cros_59;
  const Scalar E_righ_ankl_cros_xz = t_righ_ankl_cros_60 - left_hip_fork_l2 * h_right_foot_x;
  const Scalar t_righ_ankl_cros_61 = s_q8_q9_q10 * (left_ankle_cross_I15 - t_righ_ankl_cros_53);
  const Scalar t_righ_ankl_cros_62 = c_q8_q9_q10 * t_righ_ankl_cros_26 * 2.0;
  const Scalar t_righ_ankl_cros_63 = t_righ_ankl_cros_61 + t_righ_ankl_cros_62;
  const Scalar t_righ_ankl_cros_64 = t_righ_ankl_cros_1 * t_righ_ankl_cros_55;
  const Scalar t_righ_ankl_cros_65 = t_righ_ankl_cros_2 * t_righ_ankl_cros_57;
  const Scalar t_righ_ankl_cros_66 = t_righ_ankl_cros_2 * h_right_foot_y;
  // right_shank: first moment h of (1)
  const Scalar t_right_shank_26 = t_right_thigh_18 + t_righ_ankl_cros_58;
  const Scalar t_right_shank_27 = t_right_shank_2 * t_righ_ankl_cros_58;
  const Scalar t_right_shank_28 = t_right_shank_1 * h_right_shank_x;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_67 = c_q8_q9_q10 * E_righ_ankl_cros_xz;
  const Scalar t_righ_ankl_cros_68 = t_righ_ankl_cros_67 - s_q8_q9_q10 * E_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_69 = t_righ_ankl_cros_1 * h_right_foot_y;
  const Scalar t_right_shank_29 = t_right_shank_1 * h_right_foot_y;
  const Scalar t_right_shank_30 = t_righ_ankl_cros_53 + 2.0 * t_righ_ankl_cros_64;
  const Scalar t_right_thigh_46 = t_right_thigh_19 - 2.0 * t_right_shank_28;
  const Scalar t_right_shank_31 = left_shank_I18 + t_right_shank_30;
  const Scalar t_right_shank_32 = t_right_shank_31 - 2.0 * t_righ_ankl_cros_65;
  const Scalar t_right_thigh_47 = t_right_thigh_27 + t_right_thigh_46 + t_right_shank_32;
  const Scalar t_right_thigh_48 = t_right_thigh_47 + 2.0 * t_right_shank_27;
  const Scalar t_right_shank_33 = t_right_shank_14 - t_righ_ankl_cros_68;
  const Scalar t_right_shank_34 = t_righ_ankl_cros_69 - t_right_shank_33;
  const Scalar t_right_thigh_49 = t_right_shank_34 - (t_right_thigh_14 - t_right_shank_29);
  const Scalar t_right_hip_fork_10 = t_right_shank_12 - (left_hip_fork_I2 - t_right_thigh_11);
  const Scalar t_righ_ankl_cros_70 = t_righ_ankl_cros_1 * t_righ_ankl_cros_57;
  // right_hip_fork: pseudo-inertia E of (1)
  const Scalar t_right_hip_fork_11 = E_right_foot_xz + t_right_hip_fork_10;
  const Scalar t_right_hip_fork_12 = h_right_shank_x * (left_hip_fork_l1 - t_right_shank_2);
  const Scalar t_right_hip_fork_13 = t_right_hip_fork_11 - t_righ_ankl_cros_70;
  const Scalar t_right_hip_fork_14 = t_right_hip_fork_13 + t_right_hip_fork_12;
  const Scalar t_right_hip_fork_15 = left_hip_fork_l1 * t_right_thigh_21;
  const Scalar t_right_hip_fork_16 = t_right_hip_fork_14 + t_right_hip_fork_15;
  const Scalar t_right_hip_fork_17 = t_right_hip_fork_16 - c_q8_q9_q10 * t_righ_ankl_cros_63;
  const Scalar t_right_shank_35 = t_right_shank_1 * t_righ_ankl_cros_58;
  const Scalar t_righ_ankl_cros_71 = t_righ_ankl_cros_2 * t_righ_ankl_cros_55;
  const Scalar t_right_hip_fork_18 = t_right_hip_fork_17 + t_right_shank_35;
  const Scalar E_right_hip_fork_xz = t_right_hip_fork_18 + t_righ_ankl_cros_71;
  const Scalar t_right_shank_36 = t_right_shank_2 * h_right_foot_y;
  const Scalar h_left_ankle_cross_x = left_ankle_cross_h2 + h_left_foot_x;
  const Scalar t_left_foot_44 = left_hip_fork_l1 * t_left_foot_7;
  // left_ankle_cross: first moment h, pseudo-inertia E of (1)
  const Scalar t_left_ankle_cross_57 = s_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_58 = left_ankle_cross_h1 * c_q2_q3_q4 - t_left_ankle_cross_57;
  const Scalar t_left_ankle_cross_59 = t_left_shank_14 - t_left_ankle_cross_58;
  const Scalar t_left_ankle_cross_60 = c_q2_q3_q4 * h_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_61 = left_ankle_cross_h1 * s_q2_q3_q4 + t_left_ankle_cross_60;
  const Scalar t_left_ankle_cross_62 = left_ankle_cross_I19 + t_left_foot_10 + t_left_foot_24;
  const Scalar t_left_ankle_cross_63 = t_left_foot_44 - t_left_ankle_cross_62;
  const Scalar t_left_ankle_cross_64 = t_left_ankle_cross_1 * t_left_ankle_cross_61;
  const Scalar t_left_ankle_cross_65 = t_left_ankle_cross_2 * t_left_ankle_cross_58;
  const Scalar t_left_ankle_cross_66 = t_left_ankle_cross_1 * t_left_foot_7;
  const Scalar t_left_shank_25 = t_left_thigh_17 + t_left_ankle_cross_59;
  const Scalar t_left_ankle_cross_67 = E_left_foot_xx + left_hip_fork_l3 * h_left_foot_x;
  // left_shank: first moment h of (1)
  const Scalar t_left_shank_26 = t_left_shank_2 * t_left_ankle_cross_59;
  const Scalar h_left_shank_x = t_left_shank_16 - t_left_ankle_cross_61;
  const Scalar t_left_shank_27 = t_left_shank_1 * h_left_shank_x;
  const Scalar t_left_shank_28 = t_left_shank_1 * t_left_foot_7;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_68 = s_q2_q3_q4 * t_left_ankle_cross_48;
  const Scalar t_left_ankle_cross_69 = c_q2_q3_q4 * t_left_ankle_cross_63;
  const Scalar t_left_ankle_cross_70 = t_left_ankle_cross_68 - t_left_ankle_cross_69;
  const Scalar t_left_thigh_44 = t_left_ankle_cross_66 - t_left_ankle_cross_70;
  const Scalar E_left_thigh_xz = t_left_thigh_21 + t_left_shank_28 + t_left_thigh_44;
  const Scalar E_left_shank_xz = t_left_shank_12 + t_left_thigh_44;
  const Scalar t_left_ankle_cross_71 = left_ankle_cross_I15 - t_left_ankle_cross_67;
  const Scalar t_left_ankle_cross_72 = c_q2_q3_q4 * t_left_ankle_cross_33 * 2.0;
  const Scalar t_left_ankle_cross_73 = s_q2_q3_q4 * t_left_ankle_cross_71;
  const Scalar t_left_ankle_cross_74 = t_left_ankle_cross_72 + t_left_ankle_cross_73;
  // left_hip_fork: pseudo-inertia E of (1)
  const Scalar t_left_hip_fork_9 = t_left_shank_10 - (left_hip_fork_I2 - t_left_thigh_9);
  const Scalar t_left_hip_fork_10 = E_left_foot_xz + t_left_hip_fork_9 + t_left_thigh_22;
  const Scalar t_left_hip_fork_11 = t_left_hip_fork_10 - c_q2_q3_q4 * t_left_ankle_cross_74;
  const Scalar t_left_hip_fork_12 = t_left_hip_fork_11 + t_left_thigh_23 * h_left_shank_x;
  const Scalar t_left_ankle_cross_75 = t_left_ankle_cross_2 * t_left_ankle_cross_61;
  const Scalar t_left_hip_fork_13 = t_left_hip_fork_12 + t_left_ankle_cross_75;
  const Scalar t_left_shank_29 = t_left_shank_1 * t_left_ankle_cross_59;
  const Scalar t_left_ankle_cross_76 = t_left_ankle_cross_1 * t_left_ankle_cross_58;
  const Scalar t_left_hip_fork_14 = t_left_hip_fork_13 + t_left_shank_29;
  const Scalar E_left_hip_fork_xz = t_left_hip_fork_14 - t_left_ankle_cross_76;
  const Scalar t_left_ankle_cross_77 = t_left_ankle_cross_2 * t_left_foot_7;
  const Scalar t_left_shank_30 = t_left_shank_2 * t_left_foot_7;
  const Scalar t_right_foot_46 = t_right_foot_19 + t_right_foot_44;
  const Scalar t_right_foot_47 = t_right_foot_46 - left_hip_fork_l2 * h_right_foot_y;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_72 = t_right_foot_11 - s_q8_q9_q10 * t_righ_ankl_cros_69;
  const Scalar t_righ_ankl_cros_73 = t_righ_ankl_cros_72 + c_q8_q9_q10 * t_righ_ankl_cros_66;
  const Scalar t_righ_ankl_cros_74 = c_q8_q9_q10 * t_right_foot_47;
  const Scalar t_right_shank_37 = h_right_foot_x * (t_right_shank_1 + t_righ_ankl_cros_1);
  const Scalar t_righ_ankl_cros_75 = s_q8_q9_q10 * E_right_foot_xz + t_righ_ankl_cros_74;
  // right_shank
  const Scalar t_right_shank_38 = t_righ_ankl_cros_75 + t_right_shank_37;
  const Scalar t_right_shank_39 = t_righ_ankl_cros_73 + c_q8_q9_q10 * t_right_shank_36;
  const Scalar t_right_shank_40 = t_right_shank_39 - s_q8_q9_q10 * t_right_shank_29;
  // right_thigh
  const Scalar t_right_thigh_50 = t_right_foot_19 - s_q8_q9_q10 * t_right_foot_47;
  const Scalar t_right_thigh_51 = h_right_foot_x * (t_right_shank_2 + t_righ_ankl_cros_2);
  const Scalar t_right_thigh_52 = t_right_thigh_50 + c_q8_q9_q10 * E_right_foot_xz;
  const Scalar t_right_thigh_53 = t_right_shank_40 - c_q8_q9_q10 * t_right_foot_45;
  // right_hip_fork
  const Scalar t_right_hip_fork_19 = c_right_hip_roll * (t_right_thigh_52 - t_right_thigh_51);
  const Scalar t_right_hip_fork_20 = s_right_hip_roll * t_right_thigh_53;
  const Scalar t_right_hip_fork_21 = t_right_hip_fork_19 + t_right_hip_fork_20;
  const Scalar t_left_foot_45 = left_hip_fork_l1 * h_left_foot_x;
  const Scalar t_left_foot_46 = t_left_foot_45 - (t_left_foot_12 - t_right_foot_44);
  // left_ankle_cross
  const Scalar t_left_ankle_cross_78 = E_left_foot_yz + c_q2_q3_q4 * t_left_ankle_cross_77;
  const Scalar t_left_ankle_cross_79 = s_q2_q3_q4 * t_left_ankle_cross_66;
  const Scalar t_left_ankle_cross_80 = t_left_ankle_cross_78 - t_left_ankle_cross_79;
  const Scalar t_left_shank_31 = t_left_ankle_cross_80 - s_q2_q3_q4 * t_left_shank_28;
  const Scalar t_left_shank_32 = t_left_shank_31 + c_q2_q3_q4 * t_left_shank_30;
  // left_thigh
  const Scalar t_left_thigh_45 = t_left_foot_45 + c_q2_q3_q4 * E_left_foot_xz;
  const Scalar t_left_thigh_46 = h_left_foot_x * (t_left_shank_2 + t_left_ankle_cross_2);
  const Scalar t_left_thigh_47 = t_left_thigh_45 - s_q2_q3_q4 * t_left_foot_46;
  const Scalar t_left_thigh_48 = t_left_shank_32 - c_q2_q3_q4 * t_left_foot_44;
  const Scalar t_left_hip_fork_15 = c_left_hip_roll * (t_left_thigh_47 - t_left_thigh_46);
  const Scalar t_left_hip_fork_16 = s_left_hip_roll * t_left_thigh_48 - t_left_hip_fork_15;
  // right_foot: 1/pivot of (1)
  const Scalar inverse_pivot_right_foot = 1.0 / t_right_foot_44;
  const Scalar t_right_foot_48 = t_right_hip_fork_21 * inverse_pivot_right_foot;
  const Scalar t_right_foot_49 = t_right_shank_40 * inverse_pivot_right_foot;
  const Scalar t_right_foot_50 = t_right_foot_11 * inverse_pivot_right_foot;
  // right_ankle_cross
  const Scalar t_righ_ankl_cros_76 = left_ankle_cross_I16 + t_righ_ankl_cros_53;
  const Scalar t_righ_ankl_cros_77 = t_righ_ankl_cros_64 - t_righ_ankl_cros_65;
  const Scalar t_righ_ankl_cros_78 = t_righ_ankl_cros_76 + t_righ_ankl_cros_77;
  // right_shank
  const Scalar t_right_shank_41 = t_right_shank_1 * t_righ_ankl_cros_55;
  const Scalar t_right_shank_42 = t_righ_ankl_cros_78 + t_right_shank_41;
  const Scalar t_right_shank_43 = t_right_shank_42 - t_right_shank_2 * t_righ_ankl_cros_57;
  const Scalar t_right_thigh_54 = t_right_shank_43 + left_hip_fork_l1 * t_righ_ankl_cros_57;
  // right_hip_fork
  const Scalar t_right_hip_fork_22 = c_right_hip_roll * t_righ_ankl_cros_68;
  const Scalar t_right_hip_fork_23 = s_right_hip_roll * t_right_thigh_54;
  const Scalar t_right_hip_fork_24 = t_right_hip_fork_22 + t_right_hip_fork_23;
  // right_foot
  const Scalar t_right_foot_51 = t_right_hip_fork_21 * t_right_foot_50;
  const Scalar t_right_foot_52 = t_right_hip_fork_24 - t_right_foot_51;
  const Scalar t_right_foot_53 = t_right_shank_38 * inverse_pivot_right_foot;
  const Scalar t_righ_ankl_cros_79 = c_q8_q9_q10 * E_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_80 = t_righ_ankl_cros_79 + s_q8_q9_q10 * E_righ_ankl_cros_xz;
  const Scalar t_right_foot_54 = t_righ_ankl_cros_80 - t_right_foot_11 * t_right_foot_53;
  const Scalar t_right_foot_55 = t_right_shank_43 - t_right_foot_11 * t_right_foot_49;
  const Scalar t_right_foot_56 = t_righ_ankl_cros_73 * inverse_pivot_right_foot;
  const Scalar t_right_foot_57 = t_righ_ankl_cros_73 * t_right_foot_50;
  const Scalar t_right_foot_58 = t_righ_ankl_cros_78 - t_right_foot_57;
  const Scalar t_right_foot_59 = t_righ_ankl_cros_76 - t_right_foot_11 * t_right_foot_50;
  // right_ankle_cross: 1/pivot of (1)
  const Scalar t_righ_ankl_cros_81 = 1.0 / t_right_foot_59;
  const Scalar t_righ_ankl_cros_82 = t_right_foot_55 * t_righ_ankl_cros_81;
  const Scalar t_righ_ankl_cros_83 = t_right_foot_58 * t_righ_ankl_cros_81;
  const Scalar t_right_shank_44 = t_right_shank_27 - t_right_shank_28 + t_right_shank_32;
  const Scalar t_righ_ankl_cros_84 = t_right_foot_52 * t_righ_ankl_cros_81;
  const Scalar t_right_thigh_55 = t_right_shank_44 - left_hip_fork_l1 * t_righ_ankl_cros_58;
  // right_hip_fork
  const Scalar t_right_hip_fork_25 = s_right_hip_roll * t_right_thigh_55;
  const Scalar t_right_hip_fork_26 = c_right_hip_roll * t_right_shank_34;
  const Scalar t_right_hip_fork_27 = t_right_hip_fork_25 + t_right_hip_fork_26;
  const Scalar t_righ_ankl_cros_85 = t_right_foot_52 * t_righ_ankl_cros_83;
  const Scalar t_righ_ankl_cros_86 = t_right_hip_fork_27 - t_righ_ankl_cros_85;
  const Scalar t_right_foot_60 = t_righ_ankl_cros_73 * t_right_foot_48;
  const Scalar t_righ_ankl_cros_87 = t_righ_ankl_cros_86 - t_right_foot_60;
  const Scalar t_right_foot_61 = t_right_shank_44 - t_right_shank_40 * t_right_foot_56;
  const Scalar t_righ_ankl_cros_88 = t_right_foot_58 * t_righ_ankl_cros_82;
  const Scalar t_righ_ankl_cros_89 = t_right_foot_61 - t_righ_ankl_cros_88;
  const Scalar t_right_foot_62 = t_right_shank_32 - t_righ_ankl_cros_73 * t_right_foot_56;
  const Scalar t_righ_ankl_cros_90 = t_right_foot_58 * t_righ_ankl_cros_83;
  const Scalar t_righ_ankl_cros_91 = t_right_foot_54 * t_righ_ankl_cros_81;
  const Scalar t_right_shank_45 = t_right_shank_15 - t_righ_ankl_cros_66;
  const Scalar t_right_shank_46 = t_righ_ankl_cros_80 - t_right_shank_45;
  const Scalar t_right_foot_63 = t_right_shank_46 - t_righ_ankl_cros_73 * t_right_foot_53;
  const Scalar t_righ_ankl_cros_92 = t_right_foot_58 * t_righ_ankl_cros_91;
  const Scalar t_righ_ankl_cros_93 = t_right_foot_63 - t_righ_ankl_cros_92;
  const Scalar t_right_shank_47 = 1.0 / (t_right_foot_62 - t_righ_ankl_cros_90);
  const Scalar t_right_shank_48 = t_righ_ankl_cros_87 * t_right_shank_47;
  const Scalar t_right_foot_64 = t_right_shank_40 * t_right_foot_48;
  const Scalar t_right_thigh_56 = t_right_thigh_48 - left_hip_fork_l1 * t_right_shank_26;
  const Scalar t_right_foot_65 = c_right_hip_roll * t_right_thigh_49 - t_right_foot_64;
  const Scalar t_right_foot_66 = t_right_foot_65 + s_right_hip_roll * t_right_thigh_56;
  const Scalar t_righ_ankl_cros_94 = t_right_foot_52 * t_righ_ankl_cros_82;
  // right_shank
  const Scalar t_right_shank_49 = t_righ_ankl_cros_89 * t_right_shank_48;
  const Scalar t_right_shank_50 = t_right_foot_66 - t_righ_ankl_cros_94 - t_right_shank_49;
  const Scalar t_right_shank_51 = t_righ_ankl_cros_89 * t_right_shank_47;
  const Scalar t_right_foot_67 = t_right_thigh_48 - t_right_shank_40 * t_right_foot_49;
  const Scalar t_righ_ankl_cros_95 = t_right_foot_55 * t_righ_ankl_cros_82;
  const Scalar t_right_shank_52 = t_righ_ankl_cros_89 * t_right_shank_51;
  const Scalar t_right_thigh_57 = t_right_shank_46 - (t_right_thigh_16 - t_right_shank_36);
  const Scalar t_right_shank_53 = t_right_thigh_57 - t_righ_ankl_cros_93 * t_right_shank_51;
  const Scalar t_right_shank_54 = t_right_shank_53 - t_right_foot_55 * t_righ_ankl_cros_91;
  const Scalar t_right_shank_55 = t_right_shank_54 - t_right_shank_40 * t_right_foot_53;
  const Scalar t_right_shank_56 = t_right_foot_67 - t_righ_ankl_cros_95 - t_right_shank_52;
  const Scalar t_right_thigh_58 = 1.0 / t_right_shank_56;
  const Scalar t_right_thigh_59 = t_right_shank_50 * t_right_thigh_58;
  const Scalar E_right_hip_fork_yz = left_hip_fork_I1 - t_right_foot_45 + t_right_thigh_57;
  const Scalar t_righ_ankl_cros_96 = t_right_foot_54 * t_righ_ankl_cros_84;
  // right_thigh
  const Scalar t_right_thigh_60 = c_right_hip_roll * E_right_hip_fork_xz + t_righ_ankl_cros_96;
  const Scalar t_right_thigh_61 = t_right_thigh_60 + t_right_hip_fork_21 * t_right_foot_53;
  const Scalar t_right_thigh_62 = t_right_thigh_61 + t_right_shank_55 * t_right_thigh_59;
  const Scalar t_right_thigh_63 = t_right_thigh_62 - s_right_hip_roll * E_right_hip_fork_yz;
  const Scalar t_right_thigh_64 = t_right_thigh_63 + t_righ_ankl_cros_93 * t_right_shank_48;
  const Scalar t_right_shank_57 = t_righ_ankl_cros_93 * t_right_shank_47;
  // right_hip_fork: 1/pivot of (1)
  const Scalar t_right_hip_fork_28 = t_right_foot_12 - left_hip_fork_l4 * h_right_foot_y;
  const Scalar t_right_hip_fork_29 = t_right_shank_11 - t_right_shank_30;
  const Scalar t_right_hip_fork_30 = t_right_thigh_46 - t_right_hip_fork_29;
  const Scalar t_right_hip_fork_31 = t_right_hip_fork_30 + s_q8_q9_q10 * t_righ_ankl_cros_63;
  const Scalar t_right_thigh_65 = t_right_shank_55 * t_right_thigh_58;
  const Scalar t_right_hip_fork_32 = left_hip_fork_I16 + t_right_hip_fork_28;
  const Scalar t_right_hip_fork_33 = t_right_hip_fork_31 + t_right_hip_fork_32;
  const Scalar t_right_foot_68 = t_right_hip_fork_33 - t_right_shank_38 * t_right_foot_53;
  const Scalar t_right_shank_58 = t_right_foot_68 - t_righ_ankl_cros_93 * t_right_shank_57;
  const Scalar t_right_shank_59 = t_right_shank_58 - t_right_foot_54 * t_righ_ankl_cros_91;
  const Scalar t_right_thigh_66 = t_right_shank_59 - t_right_shank_55 * t_right_thigh_65;
  const Scalar t_right_hip_fork_34 = 1.0 / t_right_thigh_66;
  const Scalar t_right_hip_fork_35 = left_hip_fork_I15 - t_right_hip_fork_28;
  const Scalar t_right_hip_fork_36 = left_hip_fork_I3 - 2.0 * t_right_thigh_49;
  const Scalar t_right_hip_fork_37 = t_right_hip_fork_31 + t_right_hip_fork_35;
  const Scalar t_right_hip_fork_38 = s_right_hip_roll * t_right_hip_fork_36;
  const Scalar t_right_hip_fork_39 = c_right_hip_roll * t_right_hip_fork_37;
  const Scalar t_right_hip_fork_40 = t_right_thigh_64 * t_right_hip_fork_34;
  const Scalar t_right_hip_fork_41 = t_right_hip_fork_38 + t_right_hip_fork_39;
  const Scalar t_right_hip_fork_42 = c_right_hip_roll * t_right_hip_fork_41;
  const Scalar t_right_hip_block_1 = left_hip_block_I3 + t_right_thigh_48;
  const Scalar t_right_hip_block_2 = t_right_hip_block_1 - t_right_hip_fork_42;
  const Scalar t_right_thigh_67 = left_hip_fork_l3 * t_right_shank_26;
  const Scalar t_right_hip_block_3 = t_right_hip_block_2 - t_right_thigh_67;
  const Scalar t_righ_ankl_cros_97 = t_right_foot_52 * t_righ_ankl_cros_84;
  const Scalar t_right_hip_fork_43 = t_right_hip_block_3 - t_righ_ankl_cros_97;
  const Scalar t_right_thigh_68 = t_right_shank_50 * t_right_thigh_59;
  const Scalar t_right_hip_fork_44 = t_right_hip_fork_43 - t_right_thigh_68;
  const Scalar t_right_hip_fork_45 = t_right_thigh_64 * t_right_hip_fork_40;
  const Scalar t_right_hip_fork_46 = t_right_hip_fork_44 - t_right_hip_fork_45;
  const Scalar t_right_shank_60 = t_righ_ankl_cros_87 * t_right_shank_48;
  const Scalar t_right_hip_fork_47 = t_right_hip_fork_46 - t_right_shank_60;
  const Scalar t_right_foot_69 = t_right_hip_fork_21 * t_right_foot_48;
  const Scalar t_right_hip_block_4 = 1.0 / (t_right_hip_fork_47 - t_right_foot_69);
  const Scalar t_left_ankle_cross_81 = c_q2_q3_q4 * t_left_foot_46;
  const Scalar t_left_shank_33 = h_left_foot_x * (t_left_shank_1 + t_left_ankle_cross_1);
  const Scalar t_left_ankle_cross_82 = s_q2_q3_q4 * E_left_foot_xz + t_left_ankle_cross_81;
  const Scalar t_left_shank_34 = t_left_ankle_cross_82 + t_left_shank_33;
  // left_foot
  const Scalar t_left_foot_47 = inverse_pivot_right_foot * t_left_shank_34;
  const Scalar t_left_foot_48 = t_left_ankle_cross_80 * inverse_pivot_right_foot;
  const Scalar t_left_foot_49 = E_left_foot_yz * inverse_pivot_right_foot;
  const Scalar t_left_foot_50 = t_left_hip_fork_16 * inverse_pivot_right_foot;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_83 = left_ankle_cross_I16 + t_left_ankle_cross_67;
  const Scalar t_left_ankle_cross_84 = t_left_ankle_cross_64 - t_left_ankle_cross_65;
  const Scalar t_left_ankle_cross_85 = t_left_ankle_cross_83 + t_left_ankle_cross_84;
  // left_shank
  const Scalar t_left_shank_35 = t_left_shank_2 * t_left_ankle_cross_58;
  const Scalar t_left_shank_36 = t_left_ankle_cross_85 - t_left_shank_35;
  const Scalar t_left_shank_37 = t_left_shank_36 + t_left_shank_1 * t_left_ankle_cross_61;
  const Scalar t_left_hip_fork_17 = c_left_hip_roll * t_left_ankle_cross_70;
  const Scalar t_left_thigh_49 = t_left_shank_37 + left_hip_fork_l1 * t_left_ankle_cross_58;
  const Scalar t_left_foot_51 = t_left_hip_fork_17 - E_left_foot_yz * t_left_foot_50;
  const Scalar t_left_foot_52 = t_left_foot_51 + s_left_hip_roll * t_left_thigh_49;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_86 = c_q2_q3_q4 * t_left_ankle_cross_48;
  const Scalar t_left_ankle_cross_87 = s_q2_q3_q4 * t_left_ankle_cross_63;
  const Scalar t_left_ankle_cross_88 = t_left_ankle_cross_86 + t_left_ankle_cross_87;
  // left_foot
  const Scalar t_left_foot_53 = t_left_ankle_cross_88 - t_left_shank_34 * t_left_foot_49;
  const Scalar t_left_foot_54 = t_left_shank_37 - t_left_shank_32 * t_left_foot_49;
  const Scalar t_left_foot_55 = t_left_ankle_cross_80 * t_left_foot_49;
  const Scalar t_left_foot_56 = t_left_ankle_cross_85 - t_left_foot_55;
  const Scalar t_left_foot_57 = t_left_ankle_cross_83 - E_left_foot_yz * t_left_foot_49;
  // left_ankle_cross: 1/pivot of (1)
  const Scalar t_left_ankle_cross_89 = 1.0 / t_left_foot_57;
  const Scalar t_left_ankle_cross_90 = t_left_foot_52 * t_left_ankle_cross_89;
  const Scalar t_left_ankle_cross_91 = t_left_foot_54 * t_left_ankle_cross_89;
  // left_shank
  const Scalar t_left_shank_38 = left_shank_I18 - 2.0 * t_left_ankle_cross_65;
  const Scalar t_left_shank_39 = t_left_ankle_cross_67 + 2.0 * t_left_ankle_cross_64;
  const Scalar t_left_shank_40 = t_left_shank_38 + t_left_shank_39;
  const Scalar t_left_shank_41 = t_left_shank_26 - t_left_shank_27 + t_left_shank_40;
  const Scalar t_left_ankle_cross_92 = t_left_foot_56 * t_left_ankle_cross_90;
  const Scalar t_left_hip_fork_18 = c_left_hip_roll * E_left_shank_xz;
  const Scalar t_left_thigh_50 = t_left_shank_41 - left_hip_fork_l1 * t_left_ankle_cross_59;
  const Scalar t_left_ankle_cross_93 = t_left_hip_fork_18 + t_left_ankle_cross_92;
  const Scalar t_left_hip_fork_19 = s_left_hip_roll * t_left_thigh_50;
  const Scalar t_left_ankle_cross_94 = t_left_ankle_cross_93 - t_left_hip_fork_19;
  const Scalar t_left_foot_58 = t_left_ankle_cross_80 * t_left_foot_50;
  // left_ankle_cross
  const Scalar t_left_ankle_cross_95 = t_left_ankle_cross_94 + t_left_foot_58;
  const Scalar t_left_ankle_cross_96 = t_left_foot_56 * t_left_ankle_cross_91;
  const Scalar t_left_ankle_cross_97 = t_left_shank_41 - t_left_ankle_cross_96;
  const Scalar t_left_foot_59 = t_left_shank_32 * t_left_foot_48;
  const Scalar t_left_ankle_cross_98 = t_left_ankle_cross_97 - t_left_foot_59;
  const Scalar t_left_ankle_cross_99 = t_left_foot_56 * t_left_ankle_cross_89;
  const Scalar t_left_foot_60 = t_left_shank_40 - t_left_ankle_cross_80 * t_left_foot_48;
  const Scalar t_left_ankle_cross_100 = t_left_foot_56 * t_left_ankle_cross_99;
  const Scalar t_left_ankle_cross_101 = t_left_foot_53 * t_left_ankle_cross_89;
  const Scalar t_left_shank_42 = t_left_shank_13 - t_left_ankle_cross_77;
  const Scalar E_left_shank_yz = t_left_ankle_cross_88 - t_left_shank_42;
  const Scalar t_left_foot_61 = E_left_shank_yz - t_left_ankle_cross_80 * t_left_foot_47;
  const Scalar t_left_ankle_cross_102 = t_left_foot_56 * t_left_ankle_cross_101;
  const Scalar t_left_ankle_cross_103 = t_left_foot_61 - t_left_ankle_cross_102;
  // left_shank: 1/pivot of (1)
  const Scalar inverse_pivot_left_shank = 1.0 / (t_left_foot_60 - t_left_ankle_cross_100);
  const Scalar t_left_shank_43 = t_left_ankle_cross_95 * inverse_pivot_left_shank;
  const Scalar t_left_shank_44 = t_left_ankle_cross_98 * inverse_pivot_left_shank;
  // left_thigh
  const Scalar t_left_thigh_51 = t_left_thigh_20 + t_left_shank_39 - 2.0 * t_left_shank_27;
  const Scalar t_left_thigh_52 = t_left_thigh_25 + t_left_shank_38 + t_left_thigh_51;
  const Scalar t_left_thigh_53 = t_left_thigh_52 + 2.0 * t_left_shank_26;
  const Scalar t_left_thigh_54 = t_left_thigh_53 - left_hip_fork_l1 * t_left_shank_25;
  const Scalar t_left_hip_fork_20 = s_left_hip_roll * t_left_thigh_54;
  const Scalar t_left_hip_fork_21 = c_left_hip_roll * E_left_thigh_xz - t_left_hip_fork_20;
  const Scalar t_left_ankle_cross_104 = t_left_foot_54 * t_left_ankle_cross_90;
  // left_shank
  const Scalar t_left_shank_45 = t_left_hip_fork_21 + t_left_ankle_cross_104;
  const Scalar t_left_shank_46 = t_left_shank_45 - t_left_ankle_cross_95 * t_left_shank_44;
  const Scalar t_left_shank_47 = t_left_shank_46 + t_left_shank_32 * t_left_foot_50;
  const Scalar t_left_foot_62 = t_left_shank_32 * inverse_pivot_right_foot;
  const Scalar t_left_shank_48 = t_left_thigh_53 - t_left_foot_54 * t_left_ankle_cross_91;
  const Scalar t_left_shank_49 = t_left_shank_48 - t_left_ankle_cross_98 * t_left_shank_44;
  const Scalar E_left_thigh_yz = E_left_shank_yz - (t_left_thigh_15 - t_left_shank_30);
  const Scalar t_left_shank_50 = E_left_thigh_yz - t_left_ankle_cross_103 * t_left_shank_44;
  const Scalar t_left_shank_51 = t_left_shank_50 - t_left_shank_32 * t_left_foot_47;
  const Scalar t_left_shank_52 = t_left_shank_51 - t_left_foot_53 * t_left_ankle_cross_91;
  const Scalar t_left_shank_53 = t_left_shank_49 - t_left_shank_32 * t_left_foot_62;
  const Scalar inverse_pivot_left_thigh = 1.0 / t_left_shank_53;
  const Scalar t_left_thigh_55 = t_left_shank_47 * inverse_pivot_left_thigh;
  // left_hip_fork: pseudo-inertia E of (1)
  const Scalar t_left_hip_fork_22 = left_hip_fork_I1 - t_left_foot_44 + E_left_thigh_yz;
  const Scalar t_left_hip_fork_23 = s_left_hip_roll * t_left_hip_fork_22;
  const Scalar t_left_hip_fork_24 = c_left_hip_roll * E_left_hip_fork_xz + t_left_hip_fork_23;
  const Scalar t_left_ankle_cross_105 = t_left_foot_52 * t_left_ankle_cross_101;
  // left_shank
  const Scalar t_left_shank_54 = t_left_hip_fork_24 - t_left_ankle_cross_105;
  const Scalar t_left_shank_55 = t_left_shank_54 + t_left_ankle_cross_103 * t_left_shank_43;
  const Scalar t_left_shank_56 = t_left_shank_55 - t_left_hip_fork_16 * t_left_foot_47;
  const Scalar t_left_thigh_56 = t_left_shank_56 + t_left_shank_52 * t_left_thigh_55;
  const Scalar t_left_hip_fork_25 = t_left_foot_9 - left_hip_fork_l4 * t_left_foot_7;
  const Scalar t_left_shank_57 = t_left_ankle_cross_103 * inverse_pivot_left_shank;
  const Scalar t_left_thigh_57 = t_left_shank_52 * inverse_pivot_left_thigh;
  // left_hip_fork
  const Scalar t_left_hip_fork_26 = t_left_shank_9 - t_left_thigh_51;
  const Scalar t_left_hip_fork_27 = t_left_hip_fork_26 - s_q2_q3_q4 * t_left_ankle_cross_74;
  const Scalar t_left_hip_fork_28 = left_hip_fork_I16 + t_left_hip_fork_25;
  const Scalar t_left_hip_fork_29 = t_left_hip_fork_27 - t_left_hip_fork_28;
  const Scalar t_left_shank_58 = t_left_ankle_cross_103 * t_left_shank_57;
  // left_thigh
  const Scalar t_left_thigh_58 = t_left_hip_fork_29 + t_left_shank_58;
  const Scalar t_left_thigh_59 = t_left_thigh_58 + t_left_shank_34 * t_left_foot_47;
  const Scalar t_left_thigh_60 = t_left_thigh_59 + t_left_shank_52 * t_left_thigh_57;
  const Scalar t_left_thigh_61 = t_left_thigh_60 + t_left_foot_53 * t_left_ankle_cross_101;
  // left_hip_fork: 1/pivot of (1)
  const Scalar t_left_hip_fork_30 = 1.0 / t_left_thigh_61;
  const Scalar t_left_hip_fork_31 = left_hip_fork_I15 - t_left_hip_fork_25;
  const Scalar t_left_hip_fork_32 = t_left_thigh_56 * t_left_hip_fork_30;
  const Scalar t_left_hip_fork_33 = t_left_hip_fork_27 - t_left_hip_fork_31;
  const Scalar t_left_hip_fork_34 = s_left_hip_roll * (left_hip_fork_I3 - 2.0 * E_left_thigh_xz);
  const Scalar t_left_shank_59 = t_left_ankle_cross_95 * t_left_shank_43;
  const Scalar t_left_hip_fork_35 = left_hip_block_I3 + t_left_thigh_53 - t_left_shank_59;
  const Scalar t_left_ankle_cross_106 = t_left_foot_52 * t_left_ankle_cross_90;
  const Scalar t_left_hip_fork_36 = t_left_hip_fork_34 + c_left_hip_roll * t_left_hip_fork_33;
  const Scalar t_left_hip_fork_37 = t_left_hip_fork_35 - t_left_ankle_cross_106;
  const Scalar t_left_hip_fork_38 = t_left_hip_fork_37 + c_left_hip_roll * t_left_hip_fork_36;
  const Scalar t_left_foot_63 = t_left_hip_fork_16 * t_left_foot_50;
  const Scalar t_left_hip_fork_39 = t_left_thigh_56 * t_left_hip_fork_32;
  const Scalar t_left_hip_fork_40 = t_left_hip_fork_38 - t_left_foot_63;
  const Scalar t_left_hip_fork_41 = t_left_hip_fork_40 + t_left_hip_fork_39;
  const Scalar t_left_hip_fork_42 = t_left_hip_fork_41 - left_hip_fork_l3 * t_left_shank_25;
  const Scalar t_left_hip_fork_43 = t_left_hip_fork_42 - t_left_shank_47 * t_left_thigh_55;
  const Scalar t_left_hip_block_2 = 1.0 / t_left_hip_fork_43;
  const Scalar t_left_hip_block_3 = t_left_hip_block_1 * inverse_pivot_right_foot;
  // right_ankle_cross: moment M of (1)
  const Scalar t_righ_ankl_cros_98 = left_ankle_cross_I15 * t_righ_ankl_cros_23;
  const Scalar t_righ_ankl_cros_99 = left_ankle_cross_I16 * alpha_right_thigh_z;
  const Scalar t_righ_ankl_cros_100 = t_righ_ankl_cros_98 + t_righ_ankl_cros_99;
  const Scalar t_righ_ankl_cros_101 = left_ankle_cross_I7 * t_righ_ankl_cros_16;
  const Scalar t_righ_ankl_cros_102 = t_righ_ankl_cros_100 + t_righ_ankl_cros_101;
  const Scalar t_righ_ankl_cros_103 = left_ankle_cross_h1 * t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_104 = t_righ_ankl_cros_102 - t_righ_ankl_cros_103;
  const Scalar t_righ_ankl_cros_105 = t_righ_ankl_cros_104 - left_hip_fork_l1 * F_right_foot_z;
  const Scalar t_righ_ankl_cros_106 = left_ankle_cross_I17 * t_righ_ankl_cros_21;
  const Scalar t_righ_ankl_cros_107 = t_righ_ankl_cros_105 + t_righ_ankl_cros_106;
  const Scalar t_righ_ankl_cros_108 = left_ankle_cross_I8 * t_right_hip_fork_5;
  const Scalar t_righ_ankl_cros_109 = t_righ_ankl_cros_107 - t_righ_ankl_cros_108;
  const Scalar t_right_foot_70 = Omega_right_foot_zy * E_right_foot_xy;
  const Scalar t_righ_ankl_cros_110 = t_righ_ankl_cros_109 - t_right_foot_70;
  const Scalar t_righ_ankl_cros_111 = t_right_foot_1 * E_righ_ankl_cros_yz;
  const Scalar t_righ_ankl_cros_112 = t_righ_ankl_cros_110 + t_righ_ankl_cros_111;
  const Scalar t_righ_ankl_cros_113 = t_righ_ankl_cros_112 + t_right_foot_7 * E_right_foot_xx;
  const Scalar t_righ_ankl_cros_114 = left_ankle_cross_h2 * a_righ_ankl_cros_y;
  const Scalar t_righ_ankl_cros_115 = t_righ_ankl_cros_113 + t_righ_ankl_cros_114;
  const Scalar t_righ_ankl_cros_116 = t_righ_ankl_cros_115 + t_right_foot_5 * E_right_foot_xz;
  const Scalar M_righ_ankl_cros_z = t_righ_ankl_cros_116 + h_right_foot_x * t_right_foot_15;
  const Scalar t_left_hip_block_4 = t_right_foot_11 * t_left_hip_block_3;
  const Scalar t_left_hip_block_5 = tau[10] - M_righ_ankl_cros_z + t_left_hip_block_4;
  const Scalar t_righ_ankl_cros_117 = c_q8_q9_q10 * t_right_foot_20;
  const Scalar t_righ_ankl_cros_118 = t_righ_ankl_cros_117 + s_q8_q9_q10 * t_right_foot_23;
  const Scalar t_right_shank_61 = M_righ_ankl_cros_z + Omega_right_thigh_yz * t_right_shank_14;
  const Scalar t_righ_ankl_cros_119 = t_righ_ankl_cros_1 * t_righ_ankl_cros_118;
  // right_shank: moment M of (1)
  const Scalar t_right_shank_62 = t_right_shank_61 - t_righ_ankl_cros_119;
  const Scalar t_right_shank_63 = t_right_shank_62 + t_right_shank_3 * t_right_shank_13;
  const Scalar t_right_shank_64 = t_right_shank_63 - Omega_right_thigh_xz * t_right_shank_15;
  const Scalar t_right_shank_65 = Omega_right_hip_fork_zx * t_right_shank_18;
  const Scalar t_righ_ankl_cros_120 = t_righ_ankl_cros_2 * t_righ_ankl_cros_46;
  const Scalar t_right_shank_66 = t_right_shank_64 + t_right_shank_65 - t_righ_ankl_cros_120;
  const Scalar t_right_shank_67 = t_right_shank_66 - t_right_shank_17 * t_right_shank_21;
  const Scalar M_right_shank_z = t_right_shank_67 + t_right_shank_16 * a_right_shank_x;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_6 = t_left_hip_block_1 * t_right_foot_56;
  const Scalar t_left_hip_block_7 = tau[9] - M_right_shank_z + t_left_hip_block_6;
  const Scalar t_left_hip_block_8 = t_righ_ankl_cros_83 * t_left_hip_block_5;
  const Scalar t_left_hip_block_9 = t_left_hip_block_7 - t_left_hip_block_8;
  const Scalar t_right_hip_fork_48 = t_right_hip_fork_2 - t_right_hip_fork_3;
  const Scalar t_right_shank_68 = t_right_shank_8 * t_right_shank_17;
  const Scalar t_righ_ankl_cros_121 = t_righ_ankl_cros_46 + t_right_shank_68;
  const Scalar t_right_shank_69 = Omega_right_hip_fork_zx * t_right_shank_17;
  const Scalar t_righ_ankl_cros_122 = t_righ_ankl_cros_118 + t_right_shank_69;
  const Scalar F_right_shank_y = t_righ_ankl_cros_122 + t_right_shank_9 * t_right_shank_16;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_69 = M_right_shank_z + a_right_hip_fork_x * t_right_thigh_18;
  const Scalar t_right_thigh_70 = t_right_thigh_69 + Omega_right_thigh_yz * t_right_thigh_14;
  const Scalar t_right_thigh_71 = t_right_thigh_70 - t_right_thigh_7 * t_right_thigh_21;
  const Scalar t_right_thigh_72 = t_right_thigh_71 - Omega_right_thigh_xz * t_right_thigh_16;
  const Scalar t_right_thigh_73 = t_right_thigh_72 + t_right_shank_3 * t_right_thigh_12;
  const Scalar t_right_thigh_74 = t_right_thigh_73 - t_right_shank_1 * F_right_shank_y;
  const Scalar t_right_thigh_75 = Omega_right_hip_fork_zx * t_right_thigh_19;
  const Scalar t_right_shank_70 = t_right_shank_2 * t_righ_ankl_cros_121;
  const Scalar M_right_thigh_z = t_right_thigh_74 + t_right_thigh_75 - t_right_shank_70;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_10 = t_right_shank_51 * t_left_hip_block_9;
  const Scalar t_left_hip_block_11 = tau[8] - M_right_thigh_z - t_left_hip_block_10;
  const Scalar t_left_hip_block_12 = t_righ_ankl_cros_82 * t_left_hip_block_5;
  const Scalar t_left_hip_block_13 = t_left_hip_block_11 - t_left_hip_block_12;
  const Scalar t_left_hip_block_14 = t_left_hip_block_1 * t_right_foot_49;
  const Scalar t_left_hip_block_15 = t_left_hip_block_13 + t_left_hip_block_14;
  const Scalar t_right_shank_71 = t_right_hip_fork_5 - t_right_shank_8;
  const Scalar t_left_hip_block_16 = tau[7] + left_hip_fork_G1 * c_right_hip_roll;
  const Scalar t_left_hip_block_17 = t_left_hip_block_16 - s_q8_q9_q10 * t_right_foot_18;
  const Scalar t_left_hip_block_18 = left_hip_fork_I14 * Omega_right_thigh_xz;
  const Scalar t_left_hip_block_19 = t_left_hip_block_17 - t_left_hip_block_18;
  const Scalar t_right_shank_72 = t_right_shank_5 * t_right_shank_18;
  const Scalar t_left_hip_block_20 = t_left_hip_block_19 - t_right_shank_72;
  const Scalar t_right_hip_fork_49 = left_hip_fork_I7 * t_right_hip_fork_48;
  const Scalar t_left_hip_block_21 = t_left_hip_block_20 + t_right_hip_fork_49;
  const Scalar t_right_thigh_76 = t_right_thigh_2 * t_right_thigh_14;
  const Scalar t_left_hip_block_22 = left_hip_fork_G2 - base_g1 * t_right_thigh_21;
  const Scalar t_left_hip_block_23 = t_left_hip_block_21 - t_right_thigh_76;
  const Scalar t_left_hip_block_24 = s_right_hip_roll * t_left_hip_block_22;
  const Scalar t_left_hip_block_25 = t_left_hip_block_23 - t_left_hip_block_24;
  const Scalar t_left_hip_block_26 = t_right_thigh_65 * t_left_hip_block_15;
  const Scalar t_left_hip_block_27 = t_left_hip_block_25 - t_left_hip_block_26;
  const Scalar t_left_hip_block_28 = t_right_shank_57 * t_left_hip_block_9;
  const Scalar t_left_hip_block_29 = t_left_hip_block_27 - t_left_hip_block_28;
  const Scalar t_right_shank_73 = t_right_shank_1 * t_righ_ankl_cros_50;
  const Scalar t_left_hip_block_30 = t_left_hip_block_29 + t_right_shank_73;
  const Scalar t_right_thigh_77 = Omega_right_thigh_zy * t_right_thigh_12;
  const Scalar t_left_hip_block_31 = t_left_hip_block_30 - t_right_thigh_77;
  const Scalar t_left_hip_block_32 = t_left_hip_block_31 - c_q8_q9_q10 * t_right_foot_43;
  const Scalar t_left_hip_block_33 = t_righ_ankl_cros_91 * t_left_hip_block_5;
  const Scalar t_left_hip_block_34 = t_left_hip_block_32 - t_left_hip_block_33;
  const Scalar t_left_hip_block_35 = t_left_hip_block_1 * t_right_foot_53;
  const Scalar t_left_hip_block_36 = t_left_hip_block_34 + t_left_hip_block_35;
  const Scalar t_right_shank_74 = t_right_shank_6 * t_right_shank_13;
  const Scalar t_left_hip_block_37 = t_left_hip_block_36 + t_right_shank_74;
  const Scalar t_left_hip_block_38 = t_left_hip_block_37 + a_right_shank_z * t_right_shank_17;
  const Scalar t_right_shank_75 = t_right_shank_14 * t_right_shank_71;
  const Scalar t_left_hip_block_39 = t_left_hip_block_38 - t_right_shank_75;
  const Scalar t_righ_ankl_cros_123 = t_righ_ankl_cros_1 * t_right_foot_26;
  const Scalar t_left_hip_block_40 = t_left_hip_block_39 + t_righ_ankl_cros_123;
  const Scalar t_right_thigh_78 = t_right_thigh_5 * t_right_thigh_19;
  const Scalar t_right_shank_76 = t_righ_ankl_cros_121 + t_right_thigh_3 * t_right_thigh_21;
  // right_thigh: moment M of (1)
  const Scalar t_right_thigh_79 = M_right_thigh_z + left_hip_fork_I3 * t_right_hip_fork_6;
  const Scalar t_right_thigh_80 = t_right_thigh_79 + left_hip_fork_l1 * t_right_shank_76;
  const Scalar t_right_thigh_81 = t_right_thigh_80 + left_hip_fork_I8 * t_right_shank_3;
  const Scalar t_right_thigh_82 = t_right_thigh_81 + left_hip_fork_I1 * Omega_right_thigh_xz;
  const Scalar t_left_hip_block_41 = t_left_hip_block_40 - t_right_thigh_78;
  const Scalar t_left_hip_block_42 = t_right_hip_fork_34 * t_left_hip_block_41;
  const Scalar t_right_thigh_83 = t_right_thigh_82 + left_hip_fork_I12 * alpha_right_thigh_z;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_43 = tau[6] - s_right_hip_roll * t_right_thigh_83;
  const Scalar t_left_hip_block_44 = t_right_thigh_59 * t_left_hip_block_15;
  const Scalar t_left_hip_block_45 = t_left_hip_block_43 - t_left_hip_block_44;
  const Scalar t_left_hip_block_46 = t_right_thigh_64 * t_left_hip_block_42;
  const Scalar t_left_hip_block_47 = t_left_hip_block_45 + t_left_hip_block_46;
  const Scalar t_left_hip_block_48 = t_left_hip_block_1 * t_right_foot_48;
  const Scalar t_left_hip_block_49 = t_left_hip_block_47 + t_left_hip_block_48;
  const Scalar t_left_hip_block_50 = t_righ_ankl_cros_84 * t_left_hip_block_5;
  const Scalar t_left_hip_block_51 = t_left_hip_block_49 - t_left_hip_block_50;
  const Scalar t_left_hip_block_52 = t_right_shank_48 * t_left_hip_block_9;
  const Scalar t_left_hip_block_53 = t_left_hip_block_51 - t_left_hip_block_52;
  const Scalar t_right_hip_fork_50 = c_right_hip_roll * t_right_thigh_45;
  const Scalar t_left_hip_block_54 = t_left_hip_block_53 + t_right_hip_fork_50;
  const Scalar t_left_hip_block_55 = t_right_hip_block_4 * t_left_hip_block_54;
  qdd[6] = t_left_hip_block_55;
  const Scalar t_left_hip_block_56 = t_right_hip_fork_40 * t_left_hip_block_55;
  const Scalar t_left_hip_block_57 = t_left_hip_block_42 + t_left_hip_block_56;
  qdd[7] = t_left_hip_block_57;
  const Scalar t_left_hip_block_58 = t_right_shank_50 * t_left_hip_block_55;
  const Scalar t_left_hip_block_59 = t_left_hip_block_15 - t_left_hip_block_58;
  const Scalar t_left_hip_block_60 = t_right_shank_55 * t_left_hip_block_57;
  const Scalar t_left_hip_block_61 = t_left_hip_block_59 - t_left_hip_block_60;
  const Scalar t_left_hip_block_62 = t_right_thigh_58 * t_left_hip_block_61;
  qdd[8] = t_left_hip_block_62;
  const Scalar t_left_hip_block_63 = t_righ_ankl_cros_87 * t_left_hip_block_55;
  const Scalar t_left_hip_block_64 = t_left_hip_block_9 - t_left_hip_block_63;
  const Scalar t_left_hip_block_65 = t_righ_ankl_cros_89 * t_left_hip_block_62;
  const Scalar t_left_hip_block_66 = t_left_hip_block_64 - t_left_hip_block_65;
  const Scalar t_left_hip_block_67 = t_righ_ankl_cros_93 * t_left_hip_block_57;
  const Scalar t_left_hip_block_68 = t_left_hip_block_66 - t_left_hip_block_67;
  const Scalar t_left_hip_block_69 = t_right_shank_47 * t_left_hip_block_68;
  qdd[9] = t_left_hip_block_69;
  const Scalar t_left_hip_block_70 = t_right_foot_52 * t_left_hip_block_55;
  const Scalar t_left_hip_block_71 = t_left_hip_block_5 - t_left_hip_block_70;
  const Scalar t_left_hip_block_72 = t_right_foot_54 * t_left_hip_block_57;
  const Scalar t_left_hip_block_73 = t_left_hip_block_71 - t_left_hip_block_72;
  const Scalar t_left_hip_block_74 = t_right_foot_55 * t_left_hip_block_62;
  const Scalar t_left_hip_block_75 = t_left_hip_block_73 - t_left_hip_block_74;
  const Scalar t_left_hip_block_76 = t_right_foot_58 * t_left_hip_block_69;
  const Scalar t_left_hip_block_77 = t_left_hip_block_75 - t_left_hip_block_76;
  const Scalar t_left_hip_block_78 = t_righ_ankl_cros_81 * t_left_hip_block_77;
  qdd[10] = t_left_hip_block_78;
  const Scalar t_left_hip_block_79 = t_right_foot_48 * t_left_hip_block_55;
  const Scalar t_left_hip_block_80 = t_left_hip_block_3 + t_left_hip_block_79;
  const Scalar t_left_hip_block_81 = t_right_foot_53 * t_left_hip_block_57;
  const Scalar t_left_hip_block_82 = t_left_hip_block_80 + t_left_hip_block_81;
  const Scalar t_left_hip_block_83 = t_right_foot_49 * t_left_hip_block_62;
  const Scalar t_left_hip_block_84 = t_left_hip_block_82 + t_left_hip_block_83;
  const Scalar t_left_hip_block_85 = t_right_foot_50 * t_left_hip_block_78;
  const Scalar t_left_hip_block_86 = t_left_hip_block_84 + t_left_hip_block_85;
  qdd[11] = -(t_left_hip_block_86 + t_right_foot_56 * t_left_hip_block_69);
  const Scalar t_left_hip_block_87 = M_left_foot_z - tau[5];
  const Scalar t_left_hip_block_88 = inverse_pivot_right_foot * t_left_hip_block_87;
  // left_ankle_cross: moment M of (1)
  const Scalar t_left_ankle_cross_107 = left_ankle_cross_I15 * t_left_ankle_cross_28;
  const Scalar t_left_ankle_cross_108 = left_ankle_cross_I16 * alpha_left_thigh_z;
  const Scalar t_left_ankle_cross_109 = t_left_ankle_cross_107 + t_left_ankle_cross_108;
  const Scalar t_left_ankle_cross_110 = left_ankle_cross_I7 * t_left_ankle_cross_24;
  const Scalar t_left_ankle_cross_111 = t_left_ankle_cross_109 + t_left_ankle_cross_110;
  const Scalar t_left_ankle_cross_112 = left_ankle_cross_h2 * a_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_113 = t_left_ankle_cross_111 + t_left_ankle_cross_112;
  const Scalar t_left_ankle_cross_114 = left_ankle_cross_h1 * t_left_ankle_cross_51;
  const Scalar t_left_ankle_cross_115 = t_left_ankle_cross_113 - t_left_ankle_cross_114;
  const Scalar t_left_ankle_cross_116 = t_left_ankle_cross_21 * t_left_ankle_cross_48;
  const Scalar t_left_ankle_cross_117 = t_left_ankle_cross_115 - t_left_ankle_cross_116;
  const Scalar t_left_ankle_cross_118 = t_left_ankle_cross_117 + h_left_foot_x * t_left_foot_16;
  const Scalar t_left_foot_64 = E_left_foot_xz * t_left_foot_22;
  const Scalar t_left_ankle_cross_119 = left_ankle_cross_I17 * t_left_ankle_cross_14;
  const Scalar t_left_ankle_cross_120 = t_left_ankle_cross_118 + t_left_foot_64;
  const Scalar t_left_ankle_cross_121 = t_left_ankle_cross_120 - t_left_ankle_cross_119;
  const Scalar t_left_ankle_cross_122 = left_ankle_cross_I8 * t_left_hip_fork_5;
  const Scalar t_left_ankle_cross_123 = t_left_ankle_cross_121 - t_left_ankle_cross_122;
  const Scalar t_left_foot_65 = Omega_left_foot_zy * t_left_foot_11;
  const Scalar t_left_ankle_cross_124 = t_left_ankle_cross_123 + t_left_foot_65;
  const Scalar t_left_foot_66 = t_left_foot_5 * E_left_foot_xx;
  const Scalar t_left_ankle_cross_125 = t_left_ankle_cross_124 + t_left_foot_66;
  const Scalar M_left_ankle_cross_z = t_left_ankle_cross_125 + left_hip_fork_l1 * t_left_foot_14;
  const Scalar t_left_hip_block_89 = t_left_foot_49 * t_left_hip_block_87;
  const Scalar t_left_hip_block_90 = tau[4] - M_left_ankle_cross_z - t_left_hip_block_89;
  const Scalar t_left_ankle_cross_126 = s_q2_q3_q4 * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_127 = c_q2_q3_q4 * F_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_128 = t_left_ankle_cross_126 + t_left_ankle_cross_127;
  const Scalar t_left_ankle_cross_129 = s_q2_q3_q4 * F_left_ankle_cross_y;
  const Scalar t_left_ankle_cross_130 = c_q2_q3_q4 * F_left_ankle_cross_x;
  const Scalar t_left_ankle_cross_131 = t_left_ankle_cross_129 - t_left_ankle_cross_130;
  const Scalar t_left_shank_60 = M_left_ankle_cross_z + Omega_left_thigh_yz * t_left_shank_12;
  const Scalar t_left_ankle_cross_132 = t_left_ankle_cross_1 * t_left_ankle_cross_128;
  // left_shank: moment M of (1)
  const Scalar t_left_shank_61 = t_left_shank_60 + t_left_ankle_cross_132;
  const Scalar t_left_shank_62 = t_left_shank_61 + Omega_left_hip_fork_zx * t_left_shank_15;
  const Scalar t_left_shank_63 = t_left_shank_62 + Omega_left_thigh_xz * t_left_shank_13;
  const Scalar t_left_shank_64 = t_left_shank_63 + t_left_shank_14 * a_left_shank_x;
  const Scalar t_left_ankle_cross_133 = t_left_ankle_cross_2 * t_left_ankle_cross_131;
  const Scalar t_left_shank_65 = t_left_shank_64 + t_left_ankle_cross_133;
  const Scalar t_left_shank_66 = t_left_shank_65 + t_left_shank_3 * t_left_shank_11;
  const Scalar M_left_shank_z = t_left_shank_66 - t_left_shank_16 * t_left_shank_20;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_91 = t_left_ankle_cross_89 * t_left_hip_block_90;
  const Scalar t_left_hip_block_92 = t_left_ankle_cross_80 * t_left_hip_block_88;
  const Scalar t_left_hip_block_93 = tau[3] - M_left_shank_z - t_left_hip_block_92;
  const Scalar t_left_hip_block_94 = t_left_foot_56 * t_left_hip_block_91;
  const Scalar t_left_hip_block_95 = t_left_hip_block_93 - t_left_hip_block_94;
  const Scalar F_left_shank_x = t_left_ankle_cross_131 - t_left_shank_16 * t_left_shank_21;
  const Scalar t_left_hip_fork_44 = t_left_hip_fork_1 - t_left_hip_fork_3;
  const Scalar t_left_hip_block_96 = left_hip_fork_G2 - base_g1 * t_left_thigh_19;
  const Scalar t_left_shank_67 = t_left_hip_fork_1 - t_left_shank_7;
  const Scalar t_left_thigh_62 = t_left_hip_fork_1 - t_left_thigh_2;
  const Scalar t_left_shank_68 = Omega_left_hip_fork_zx * t_left_shank_16;
  const Scalar t_left_shank_69 = t_left_ankle_cross_128 - t_left_shank_68;
  // left_thigh: moment M of (1)
  const Scalar t_left_thigh_63 = M_left_shank_z - t_left_thigh_6 * t_left_thigh_19;
  const Scalar t_left_thigh_64 = t_left_thigh_63 + t_left_shank_3 * t_left_thigh_10;
  const Scalar t_left_thigh_65 = t_left_thigh_64 + t_left_shank_2 * F_left_shank_x;
  const Scalar t_left_thigh_66 = t_left_thigh_65 + Omega_left_thigh_xz * t_left_thigh_15;
  const Scalar t_left_thigh_67 = t_left_thigh_66 + Omega_left_hip_fork_zx * t_left_thigh_20;
  const Scalar t_left_thigh_68 = t_left_thigh_67 + Omega_left_thigh_yz * t_left_thigh_13;
  const Scalar t_left_ankle_cross_134 = t_left_shank_69 - t_left_shank_14 * t_left_shank_17;
  const Scalar t_left_thigh_69 = t_left_thigh_68 + a_left_hip_fork_x * t_left_thigh_17;
  const Scalar M_left_thigh_z = t_left_thigh_69 + t_left_shank_1 * t_left_ankle_cross_134;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_97 = t_left_foot_62 * t_left_hip_block_87;
  const Scalar t_left_hip_block_98 = tau[2] - M_left_thigh_z - t_left_hip_block_97;
  const Scalar t_left_hip_block_99 = t_left_shank_44 * t_left_hip_block_95;
  const Scalar t_left_hip_block_100 = t_left_ankle_cross_91 * t_left_hip_block_90;
  const Scalar t_left_hip_block_101 = t_left_hip_block_98 - t_left_hip_block_99;
  const Scalar t_left_hip_block_102 = t_left_hip_block_101 - t_left_hip_block_100;
  const Scalar t_left_hip_block_103 = inverse_pivot_left_thigh * t_left_hip_block_102;
  const Scalar t_left_hip_block_104 = tau[1] - left_hip_fork_G1 * c_left_hip_roll;
  const Scalar t_left_hip_block_105 = t_left_hip_block_104 + s_q2_q3_q4 * M_left_ankle_cross_x;
  const Scalar t_left_hip_block_106 = t_left_foot_47 * t_left_hip_block_87;
  const Scalar t_left_hip_block_107 = t_left_hip_block_105 + t_left_hip_block_106;
  const Scalar t_left_thigh_70 = t_left_thigh_5 * t_left_thigh_20;
  const Scalar t_left_hip_block_108 = t_left_hip_block_107 - t_left_thigh_70;
  const Scalar t_left_shank_70 = t_left_shank_6 * t_left_shank_11;
  const Scalar t_left_hip_block_109 = t_left_hip_block_108 + t_left_shank_70;
  const Scalar t_left_hip_fork_45 = left_hip_fork_I7 * t_left_hip_fork_44;
  const Scalar t_left_hip_block_110 = t_left_hip_block_109 + t_left_hip_fork_45;
  const Scalar t_left_hip_block_111 = t_left_hip_block_110 + a_left_shank_z * t_left_shank_16;
  const Scalar t_left_ankle_cross_135 = t_left_ankle_cross_1 * F_left_ankle_cross_z;
  const Scalar t_left_hip_block_112 = t_left_hip_block_111 - t_left_ankle_cross_135;
  const Scalar t_left_hip_block_113 = t_left_hip_block_112 - t_left_shank_1 * F_left_shank_z;
  const Scalar t_left_hip_block_114 = s_left_hip_roll * t_left_hip_block_96;
  const Scalar t_left_hip_block_115 = t_left_hip_block_113 - t_left_hip_block_114;
  const Scalar t_left_shank_71 = t_left_shank_12 * t_left_shank_67;
  const Scalar t_left_hip_block_116 = t_left_hip_block_115 - t_left_shank_71;
  const Scalar t_left_shank_72 = t_left_shank_5 * t_left_shank_15;
  const Scalar t_left_hip_block_117 = t_left_hip_block_116 - t_left_shank_72;
  const Scalar t_left_hip_block_118 = left_hip_fork_I14 * Omega_left_thigh_xz;
  const Scalar t_left_hip_block_119 = t_left_hip_block_117 - t_left_hip_block_118;
  const Scalar t_left_thigh_71 = t_left_thigh_13 * t_left_thigh_62;
  const Scalar t_left_hip_block_120 = t_left_hip_block_119 - t_left_thigh_71;
  const Scalar t_left_hip_block_121 = t_left_hip_block_120 - c_q2_q3_q4 * t_left_foot_41;
  const Scalar t_left_hip_block_122 = t_left_shank_52 * t_left_hip_block_103;
  const Scalar t_left_hip_block_123 = t_left_hip_block_121 + t_left_hip_block_122;
  const Scalar t_left_hip_block_124 = t_left_shank_57 * t_left_hip_block_95;
  const Scalar t_left_hip_block_125 = t_left_hip_block_123 + t_left_hip_block_124;
  const Scalar t_left_thigh_72 = Omega_left_thigh_zy * t_left_thigh_10;
  const Scalar t_left_hip_block_126 = t_left_ankle_cross_101 * t_left_hip_block_90;
  const Scalar t_left_hip_block_127 = t_left_hip_block_125 - t_left_thigh_72;
  const Scalar t_left_hip_block_128 = t_left_hip_block_127 + t_left_hip_block_126;
  // left_thigh: force F, moment M of (1)
  const Scalar F_left_thigh_x = F_left_shank_x - t_left_thigh_3 * t_left_thigh_19;
  const Scalar t_left_thigh_73 = M_left_thigh_z - left_hip_fork_I3 * t_left_hip_fork_6;
  const Scalar t_left_thigh_74 = t_left_thigh_73 - left_hip_fork_l1 * F_left_thigh_x;
  const Scalar t_left_thigh_75 = t_left_thigh_74 - left_hip_fork_I1 * Omega_left_thigh_xz;
  const Scalar t_left_thigh_76 = t_left_thigh_75 + left_hip_fork_I12 * alpha_left_thigh_z;
  const Scalar t_left_thigh_77 = t_left_thigh_76 + left_hip_fork_I8 * t_left_shank_3;
  // left_hip_block: qdd of (1)
  const Scalar t_left_hip_block_129 = tau[0] - s_left_hip_roll * t_left_thigh_77;
  const Scalar t_left_hip_block_130 = t_left_hip_block_129 + c_left_hip_roll * t_left_thigh_43;
  const Scalar t_left_hip_block_131 = t_left_ankle_cross_90 * t_left_hip_block_90;
  const Scalar t_left_hip_block_132 = t_left_hip_block_130 - t_left_hip_block_131;
  const Scalar t_left_hip_block_133 = t_left_thigh_55 * t_left_hip_block_102;
  const Scalar t_left_hip_block_134 = t_left_hip_block_132 + t_left_hip_block_133;
  const Scalar t_left_hip_block_135 = t_left_hip_fork_32 * t_left_hip_block_128;
  const Scalar t_left_hip_block_136 = t_left_hip_block_134 - t_left_hip_block_135;
  const Scalar t_left_hip_block_137 = t_left_foot_50 * t_left_hip_block_87;
  const Scalar t_left_hip_block_138 = t_left_hip_block_136 - t_left_hip_block_137;
  const Scalar t_left_hip_block_139 = t_left_shank_43 * t_left_hip_block_95;
  const Scalar t_left_hip_block_140 = t_left_hip_block_138 + t_left_hip_block_139;
  const Scalar t_left_hip_block_141 = t_left_hip_block_2 * t_left_hip_block_140;
  qdd[0] = t_left_hip_block_141;
  const Scalar t_left_hip_block_142 = t_left_hip_fork_30 * t_left_hip_block_128;
  const Scalar t_left_hip_block_143 = t_left_hip_fork_32 * t_left_hip_block_141;
  const Scalar t_left_hip_block_144 = t_left_hip_block_142 + t_left_hip_block_143;
  qdd[1] = -t_left_hip_block_144;
  const Scalar t_left_hip_block_145 = t_left_thigh_55 * t_left_hip_block_141;
  const Scalar t_left_hip_block_146 = t_left_hip_block_103 + t_left_hip_block_145;
  const Scalar t_left_hip_block_147 = t_left_thigh_57 * t_left_hip_block_144;
  const Scalar t_left_hip_block_148 = t_left_hip_block_146 - t_left_hip_block_147;
  qdd[2] = t_left_hip_block_148;
  const Scalar t_left_hip_block_149 = t_left_ankle_cross_95 * t_left_hip_block_141;
  const Scalar t_left_hip_block_150 = t_left_ankle_cross_103 * t_left_hip_block_144;
  const Scalar t_left_hip_block_151 = t_left_hip_block_95 + t_left_hip_block_149;
  const Scalar t_left_hip_block_152 = t_left_hip_block_151 - t_left_hip_block_150;
  const Scalar t_left_hip_block_153 = inverse_pivot_left_shank * t_left_hip_block_152;
  const Scalar t_left_hip_block_154 = t_left_shank_44 * t_left_hip_block_148;
  const Scalar t_left_hip_block_155 = t_left_hip_block_154 - t_left_hip_block_153;
  qdd[3] = -t_left_hip_block_155;
  const Scalar t_left_hip_block_156 = t_left_ankle_cross_90 * t_left_hip_block_141;
  const Scalar t_left_hip_block_157 = t_left_ankle_cross_99 * t_left_hip_block_155;
  const Scalar t_left_hip_block_158 = t_left_hip_block_91 - t_left_hip_block_156;
  const Scalar t_left_hip_block_159 = t_left_ankle_cross_101 * t_left_hip_block_144;
  const Scalar t_left_hip_block_160 = t_left_hip_block_158 + t_left_hip_block_157;
  const Scalar t_left_hip_block_161 = t_left_ankle_cross_91 * t_left_hip_block_148;
  const Scalar t_left_hip_block_162 = t_left_hip_block_160 - t_left_hip_block_159;
  const Scalar t_left_hip_block_163 = t_left_hip_block_162 - t_left_hip_block_161;
  qdd[4] = t_left_hip_block_163;
  const Scalar t_left_hip_block_164 = t_left_foot_50 * t_left_hip_block_141;
  const Scalar t_left_hip_block_165 = t_left_hip_block_88 - t_left_hip_block_164;
  const Scalar t_left_hip_block_166 = t_left_foot_47 * t_left_hip_block_144;
  const Scalar t_left_hip_block_167 = t_left_hip_block_165 - t_left_hip_block_166;
  const Scalar t_left_hip_block_168 = t_left_foot_48 * t_left_hip_block_155;
  const Scalar t_left_hip_block_169 = t_left_hip_block_167 + t_left_hip_block_168;
  const Scalar t_left_hip_block_170 = t_left_foot_62 * t_left_hip_block_148;
  const Scalar t_left_hip_block_171 = t_left_hip_block_169 - t_left_hip_block_170;
  qdd[5] = t_left_foot_49 * t_left_hip_block_163 - t_left_hip_block_171;
}

void point_positions(const Scalar q[12], Scalar p[12]) noexcept {
  const auto p_s_left_hip_yaw = sine_cosine(q[0]);
  const Scalar& s_left_hip_yaw = p_s_left_hip_yaw.sine;
  const Scalar& c_left_hip_yaw = p_s_left_hip_yaw.cosine;
  const auto p_s_left_hip_roll = sine_cosine(q[1]);
  const Scalar& s_left_hip_roll = p_s_left_hip_roll.sine;
  const Scalar& c_left_hip_roll = p_s_left_hip_roll.cosine;
  const Scalar q_q3_q4 = q[3] + q[4];
  const Scalar q_q2_q3_q4 = q[2] + q_q3_q4;
  const auto p_s_q2_q3_q4 = sine_cosine(q_q2_q3_q4);
  const Scalar& s_q2_q3_q4 = p_s_q2_q3_q4.sine;
  const Scalar& c_q2_q3_q4 = p_s_q2_q3_q4.cosine;
  const auto p_s_q3_q4 = sine_cosine(q_q3_q4);
  const Scalar& s_q3_q4 = p_s_q3_q4.sine;
  const Scalar& c_q3_q4 = p_s_q3_q4.cosine;
  const auto p_s_left_ankle_pitch = sine_cosine(q[4]);
  const Scalar& s_left_ankle_pitch = p_s_left_ankle_pitch.sine;
  const Scalar& c_left_ankle_pitch = p_s_left_ankle_pitch.cosine;
  const auto p_s_left_ankle_roll = sine_cosine(q[5]);
  const Scalar& s_left_ankle_roll = p_s_left_ankle_roll.sine;
  const Scalar& c_left_ankle_roll = p_s_left_ankle_roll.cosine;
  const auto p_s_right_hip_yaw = sine_cosine(q[6]);
  const Scalar& s_right_hip_yaw = p_s_right_hip_yaw.sine;
  const Scalar& c_right_hip_yaw = p_s_right_hip_yaw.cosine;
  const auto p_s_right_hip_roll = sine_cosine(q[7]);
  const Scalar& s_right_hip_roll = p_s_right_hip_roll.sine;
  const Scalar& c_right_hip_roll = p_s_right_hip_roll.cosine;
  const Scalar q_q9_q10 = q[9] + q[10];
  const Scalar q_q8_q9_q10 = q[8] + q_q9_q10;
  const auto p_s_q8_q9_q10 = sine_cosine(q_q8_q9_q10);
  const Scalar& s_q8_q9_q10 = p_s_q8_q9_q10.sine;
  const Scalar& c_q8_q9_q10 = p_s_q8_q9_q10.cosine;
  const auto p_s_q9_q10 = sine_cosine(q_q9_q10);
  const Scalar& s_q9_q10 = p_s_q9_q10.sine;
  const Scalar& c_q9_q10 = p_s_q9_q10.cosine;
  const auto p_s_right_ankle_pitch = sine_cosine(q[10]);
  const Scalar& s_right_ankle_pitch = p_s_right_ankle_pitch.sine;
  const Scalar& c_right_ankle_pitch = p_s_right_ankle_pitch.cosine;
  const auto p_s_right_ankle_roll = sine_cosine(q[11]);
  const Scalar& s_right_ankle_roll = p_s_right_ankle_roll.sine;
  const Scalar& c_right_ankle_roll = p_s_right_ankle_roll.cosine;
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
  const Scalar t_left_hip_block_1 = left_hip_block_l1 + c_left_hip_yaw * t_left_hip_fork_2;
  p[1] = t_left_hip_block_1 + s_left_hip_yaw * t_left_hip_fork_4;
  p[0] = c_left_hip_yaw * t_left_hip_fork_4 - s_left_hip_yaw * t_left_hip_fork_2;
  const Scalar t_left_hip_block_2 = left_hip_block_l2 - s_left_hip_roll * t_left_thigh_2;
  p[2] = -(t_left_hip_block_2 + c_left_hip_roll * t_left_thigh_3);
  const Scalar t_left_shank_6 = left_foot_l3 + t_left_shank_4;
  const Scalar t_left_thigh_4 = t_left_thigh_1 + s_q2_q3_q4 * t_left_shank_6;
  const Scalar t_left_hip_fork_5 = t_left_hip_fork_1 + s_left_hip_roll * t_left_thigh_4;
  const Scalar t_left_hip_fork_6 = t_left_hip_fork_3 + c_q2_q3_q4 * t_left_shank_6;
  const Scalar t_left_hip_block_3 = left_hip_block_l1 + c_left_hip_yaw * t_left_hip_fork_5;
  p[4] = t_left_hip_block_3 + s_left_hip_yaw * t_left_hip_fork_6;
  p[3] = c_left_hip_yaw * t_left_hip_fork_6 - s_left_hip_yaw * t_left_hip_fork_5;
  p[5] = -(t_left_hip_block_2 + c_left_hip_roll * t_left_thigh_4);
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
  const Scalar t_right_hip_block_1 = left_hip_block_l1 - s_right_hip_yaw * t_right_hip_fork_3;
  p[7] = -(t_right_hip_block_1 + c_right_hip_yaw * t_right_hip_fork_4);
  p[6] = c_right_hip_yaw * t_right_hip_fork_3 + s_right_hip_yaw * t_right_hip_fork_4;
  const Scalar t_right_hip_block_2 = left_hip_block_l2 + s_right_hip_roll * t_right_thigh_2;
  p[8] = -(t_right_hip_block_2 + c_right_hip_roll * t_right_thigh_3);
  const Scalar t_right_shank_6 = left_foot_l3 + t_right_shank_4;
  const Scalar t_right_thigh_4 = t_right_thigh_1 + s_q8_q9_q10 * t_right_shank_6;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_1 - s_right_hip_roll * t_right_thigh_4;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_2 + c_q8_q9_q10 * t_right_shank_6;
  const Scalar t_right_hip_block_3 = left_hip_block_l1 + c_right_hip_yaw * t_right_hip_fork_5;
  p[10] = s_right_hip_yaw * t_right_hip_fork_6 - t_right_hip_block_3;
  p[9] = s_right_hip_yaw * t_right_hip_fork_5 + c_right_hip_yaw * t_right_hip_fork_6;
  p[11] = -(t_right_hip_block_2 + c_right_hip_roll * t_right_thigh_4);
}

void force_jacobian_transpose(const Scalar q[12], Scalar C[144]) noexcept {
  const auto p_s_left_hip_yaw = sine_cosine(q[0]);
  const Scalar& s_left_hip_yaw = p_s_left_hip_yaw.sine;
  const Scalar& c_left_hip_yaw = p_s_left_hip_yaw.cosine;
  const auto p_s_left_hip_roll = sine_cosine(q[1]);
  const Scalar& s_left_hip_roll = p_s_left_hip_roll.sine;
  const Scalar& c_left_hip_roll = p_s_left_hip_roll.cosine;
  // left_shank: way s to the joint of (9)
  const auto p_s_left_hip_pitch = sine_cosine(q[2]);
  const Scalar& s_left_hip_pitch = p_s_left_hip_pitch.sine;
  const Scalar& c_left_hip_pitch = p_s_left_hip_pitch.cosine;
  const Scalar t_left_shank_1 = left_shank_l1 * c_left_hip_pitch;
  const Scalar t_left_shank_2 = left_shank_l1 * s_left_hip_pitch;
  // left_ankle_cross: r, way s to the joint of (9)
  const Scalar q_q2_q3 = q[2] + q[3];
  const Scalar q_q2_q3_q4 = q_q2_q3 + q[4];
  const auto p_s_q2_q3_q4 = sine_cosine(q_q2_q3_q4);
  const Scalar& s_q2_q3_q4 = p_s_q2_q3_q4.sine;
  const Scalar& c_q2_q3_q4 = p_s_q2_q3_q4.cosine;
  const auto p_s_q2_q3 = sine_cosine(q_q2_q3);
  const Scalar& s_q2_q3 = p_s_q2_q3.sine;
  const Scalar& c_q2_q3 = p_s_q2_q3.cosine;
  const Scalar t_left_ankle_cross_1 = left_ankle_cross_l1 * c_q2_q3;
  const Scalar t_left_ankle_cross_2 = left_ankle_cross_l1 * s_q2_q3;
  const auto p_s_right_hip_yaw = sine_cosine(q[6]);
  const Scalar& s_right_hip_yaw = p_s_right_hip_yaw.sine;
  const Scalar& c_right_hip_yaw = p_s_right_hip_yaw.cosine;
  const auto p_s_right_hip_roll = sine_cosine(q[7]);
  const Scalar& s_right_hip_roll = p_s_right_hip_roll.sine;
  const Scalar& c_right_hip_roll = p_s_right_hip_roll.cosine;
  // right_shank: way s to the joint of (9)
  const auto p_s_right_hip_pitch = sine_cosine(q[8]);
  const Scalar& s_right_hip_pitch = p_s_right_hip_pitch.sine;
  const Scalar& c_right_hip_pitch = p_s_right_hip_pitch.cosine;
  const Scalar t_right_shank_1 = left_shank_l1 * c_right_hip_pitch;
  const Scalar t_right_shank_2 = left_shank_l1 * s_right_hip_pitch;
  // right_ankle_cross: r, way s to the joint of (9)
  const Scalar q_q8_q9 = q[8] + q[9];
  const Scalar q_q8_q9_q10 = q_q8_q9 + q[10];
  const auto p_s_q8_q9_q10 = sine_cosine(q_q8_q9_q10);
  const Scalar& s_q8_q9_q10 = p_s_q8_q9_q10.sine;
  const Scalar& c_q8_q9_q10 = p_s_q8_q9_q10.cosine;
  const auto p_s_q8_q9 = sine_cosine(q_q8_q9);
  const Scalar& s_q8_q9 = p_s_q8_q9.sine;
  const Scalar& c_q8_q9 = p_s_q8_q9.cosine;
  const Scalar t_righ_ankl_cros_1 = left_ankle_cross_l1 * c_q8_q9;
  const Scalar t_righ_ankl_cros_2 = left_ankle_cross_l1 * s_q8_q9;
  const auto p_s_right_ankle_roll = sine_cosine(q[11]);
  const Scalar& s_right_ankle_roll = p_s_right_ankle_roll.sine;
  const Scalar& c_right_ankle_roll = p_s_right_ankle_roll.cosine;
  const Scalar r_right_foot_x = left_foot_l2 * c_right_ankle_roll;
  const auto p_s_left_ankle_roll = sine_cosine(q[5]);
  const Scalar& s_left_ankle_roll = p_s_left_ankle_roll.sine;
  const Scalar& c_left_ankle_roll = p_s_left_ankle_roll.cosine;
  const Scalar r_left_foot_x = left_foot_l2 * c_left_ankle_roll;
  const Scalar r_right_foot_y = left_foot_l2 * s_right_ankle_roll;
  const Scalar r_left_foot_y = left_foot_l2 * s_left_ankle_roll;
  const Scalar t_left_foot_1 = left_hip_fork_l1 + r_left_foot_x;
  // left_ankle_cross: r of (9)
  const Scalar t_left_ankle_cross_3 = c_q2_q3_q4 * t_left_foot_1;
  const Scalar t_left_ankle_cross_4 = t_left_ankle_cross_3 - left_foot_l1 * s_q2_q3_q4;
  const Scalar t_left_ankle_cross_5 = t_left_ankle_cross_1 + t_left_ankle_cross_4;
  const Scalar t_left_ankle_cross_6 = s_q2_q3_q4 * t_left_foot_1;
  const Scalar t_left_ankle_cross_7 = t_left_ankle_cross_6 + left_foot_l1 * c_q2_q3_q4;
  const Scalar t_left_ankle_cross_8 = t_left_ankle_cross_2 + t_left_ankle_cross_7;
  const Scalar t_left_shank_3 = t_left_shank_2 + t_left_ankle_cross_8;
  const Scalar t_left_shank_4 = t_left_shank_1 + t_left_ankle_cross_5;
  // left_hip_fork: r of (9)
  const Scalar r_left_hip_fork_x = left_hip_fork_l2 + r_left_foot_y;
  const Scalar t_left_hip_fork_1 = s_left_hip_roll * r_left_hip_fork_x;
  const Scalar t_left_hip_fork_2 = c_left_hip_roll * r_left_hip_fork_x;
  // left_hip_block: r, C of (9)
  const Scalar r_left_hip_block_y = t_left_hip_fork_2 + s_left_hip_roll * t_left_shank_4;
  C[14] = r_left_hip_block_y;
  const Scalar r_left_hip_block_x = left_hip_fork_l1 - t_left_shank_3;
  C[1] = c_left_hip_yaw * r_left_hip_block_x - s_left_hip_yaw * r_left_hip_block_y;
  C[0] = -(c_left_hip_yaw * r_left_hip_block_y + s_left_hip_yaw * r_left_hip_block_x);
  const Scalar t_left_hip_fork_3 = t_left_hip_fork_1 - c_left_hip_roll * t_left_shank_4;
  C[13] = -c_left_hip_yaw * t_left_hip_fork_3;
  C[12] = s_left_hip_yaw * t_left_hip_fork_3;
  const Scalar t_left_hip_block_1 = s_left_hip_yaw * s_left_hip_roll;
  C[24] = t_left_shank_3 * t_left_hip_block_1 - c_left_hip_yaw * t_left_shank_4;
  const Scalar t_left_hip_block_2 = c_left_hip_yaw * s_left_hip_roll;
  C[25] = -(s_left_hip_yaw * t_left_shank_4 + t_left_shank_3 * t_left_hip_block_2);
  const Scalar t_left_hip_block_3 = t_left_ankle_cross_8 * t_left_hip_block_1;
  C[36] = t_left_hip_block_3 - c_left_hip_yaw * t_left_ankle_cross_5;
  const Scalar t_left_hip_block_4 = t_left_ankle_cross_8 * t_left_hip_block_2;
  C[37] = -(t_left_hip_block_4 + s_left_hip_yaw * t_left_ankle_cross_5);
  C[26] = c_left_hip_roll * t_left_shank_3;
  const Scalar t_left_hip_block_5 = t_left_ankle_cross_7 * t_left_hip_block_1;
  C[48] = t_left_hip_block_5 - c_left_hip_yaw * t_left_ankle_cross_4;
  const Scalar t_left_hip_block_6 = c_q2_q3_q4 * r_left_foot_y;
  const Scalar t_left_hip_block_7 = s_left_hip_roll * t_left_hip_block_6;
  const Scalar t_left_hip_block_8 = t_left_hip_block_7 - c_left_hip_roll * r_left_foot_x;
  const Scalar t_left_hip_block_9 = s_q2_q3_q4 * r_left_foot_y;
  C[60] = c_left_hip_yaw * t_left_hip_block_9 + s_left_hip_yaw * t_left_hip_block_8;
  C[63] = C[60];
  C[61] = s_left_hip_yaw * t_left_hip_block_9 - c_left_hip_yaw * t_left_hip_block_8;
  C[64] = C[61];
  const Scalar t_left_hip_block_10 = t_left_ankle_cross_7 * t_left_hip_block_2;
  C[49] = -(t_left_hip_block_10 + s_left_hip_yaw * t_left_ankle_cross_4);
  C[38] = c_left_hip_roll * t_left_ankle_cross_8;
  C[50] = c_left_hip_roll * t_left_ankle_cross_7;
  C[62] = c_left_hip_roll * t_left_hip_block_6 + s_left_hip_roll * r_left_foot_x;
  C[65] = C[62];
  // left_ankle_cross: r of (9)
  const Scalar t_left_ankle_cross_9 = t_left_ankle_cross_6 - left_foot_l3 * c_q2_q3_q4;
  const Scalar t_left_ankle_cross_10 = t_left_ankle_cross_2 + t_left_ankle_cross_9;
  const Scalar t_left_ankle_cross_11 = t_left_ankle_cross_3 + left_foot_l3 * s_q2_q3_q4;
  const Scalar t_left_ankle_cross_12 = t_left_ankle_cross_1 + t_left_ankle_cross_11;
  const Scalar t_left_shank_5 = t_left_shank_1 + t_left_ankle_cross_12;
  const Scalar t_left_shank_6 = t_left_shank_2 + t_left_ankle_cross_10;
  // left_hip_block: r, C of (9)
  const Scalar r_left_hip_block_y_2 = t_left_hip_fork_2 + s_left_hip_roll * t_left_shank_5;
  C[17] = r_left_hip_block_y_2;
  const Scalar r_left_hip_block_x_2 = left_hip_fork_l1 - t_left_shank_6;
  C[4] = c_left_hip_yaw * r_left_hip_block_x_2 - s_left_hip_yaw * r_left_hip_block_y_2;
  C[3] = -(c_left_hip_yaw * r_left_hip_block_y_2 + s_left_hip_yaw * r_left_hip_block_x_2);
  const Scalar t_left_hip_fork_4 = t_left_hip_fork_1 - c_left_hip_roll * t_left_shank_5;
  C[15] = s_left_hip_yaw * t_left_hip_fork_4;
  C[16] = -c_left_hip_yaw * t_left_hip_fork_4;
  C[28] = -(s_left_hip_yaw * t_left_shank_5 + t_left_hip_block_2 * t_left_shank_6);
  C[27] = t_left_hip_block_1 * t_left_shank_6 - c_left_hip_yaw * t_left_shank_5;
  const Scalar t_left_hip_block_11 = t_left_hip_block_1 * t_left_ankle_cross_10;
  C[39] = t_left_hip_block_11 - c_left_hip_yaw * t_left_ankle_cross_12;
  const Scalar t_left_hip_block_12 = t_left_hip_block_2 * t_left_ankle_cross_10;
  C[40] = -(t_left_hip_block_12 + s_left_hip_yaw * t_left_ankle_cross_12);
  C[29] = c_left_hip_roll * t_left_shank_6;
  const Scalar t_left_hip_block_13 = t_left_hip_block_1 * t_left_ankle_cross_9;
  C[51] = t_left_hip_block_13 - c_left_hip_yaw * t_left_ankle_cross_11;
  const Scalar t_left_hip_block_14 = t_left_hip_block_2 * t_left_ankle_cross_9;
  C[52] = -(s_left_hip_yaw * t_left_ankle_cross_11 + t_left_hip_block_14);
  C[41] = c_left_hip_roll * t_left_ankle_cross_10;
  C[53] = c_left_hip_roll * t_left_ankle_cross_9;
  const Scalar t_right_foot_1 = left_hip_fork_l1 + r_right_foot_x;
  // right_ankle_cross: r of (9)
  const Scalar t_righ_ankl_cros_3 = s_q8_q9_q10 * t_right_foot_1;
  const Scalar t_righ_ankl_cros_4 = t_righ_ankl_cros_3 + left_foot_l1 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_5 = t_righ_ankl_cros_2 + t_righ_ankl_cros_4;
  const Scalar t_righ_ankl_cros_6 = c_q8_q9_q10 * t_right_foot_1;
  const Scalar t_righ_ankl_cros_7 = t_righ_ankl_cros_6 - left_foot_l1 * s_q8_q9_q10;
  const Scalar t_righ_ankl_cros_8 = t_righ_ankl_cros_1 + t_righ_ankl_cros_7;
  const Scalar t_right_shank_3 = t_right_shank_2 + t_righ_ankl_cros_5;
  const Scalar t_right_shank_4 = t_right_shank_1 + t_righ_ankl_cros_8;
  const Scalar t_right_thigh_1 = left_hip_fork_l2 - r_right_foot_y;
  // right_hip_fork: r of (9)
  const Scalar t_right_hip_fork_1 = s_right_hip_roll * t_right_thigh_1;
  const Scalar t_right_hip_fork_2 = c_right_hip_roll * t_right_thigh_1;
  const Scalar t_right_hip_fork_3 = t_right_hip_fork_2 - s_right_hip_roll * t_right_shank_4;
  C[92] = -t_right_hip_fork_3;
  const Scalar r_right_hip_block_x = left_hip_fork_l1 - t_right_shank_3;
  C[79] = c_right_hip_yaw * r_right_hip_block_x + s_right_hip_yaw * t_right_hip_fork_3;
  C[78] = c_right_hip_yaw * t_right_hip_fork_3 - s_right_hip_yaw * r_right_hip_block_x;
  const Scalar t_right_hip_fork_4 = t_right_hip_fork_1 + c_right_hip_roll * t_right_shank_4;
  // left_hip_block: C of (9)
  C[90] = -s_right_hip_yaw * t_right_hip_fork_4;
  C[91] = c_right_hip_yaw * t_right_hip_fork_4;
  const Scalar t_left_hip_block_15 = s_right_hip_yaw * s_right_hip_roll;
  C[102] = t_right_shank_3 * t_left_hip_block_15 - c_right_hip_yaw * t_right_shank_4;
  const Scalar t_left_hip_block_16 = c_right_hip_yaw * s_right_hip_roll;
  C[103] = -(s_right_hip_yaw * t_right_shank_4 + t_right_shank_3 * t_left_hip_block_16);
  C[115] = -(s_right_hip_yaw * t_righ_ankl_cros_8 + t_righ_ankl_cros_5 * t_left_hip_block_16);
  C[114] = t_righ_ankl_cros_5 * t_left_hip_block_15 - c_right_hip_yaw * t_righ_ankl_cros_8;
  C[104] = c_right_hip_roll * t_right_shank_3;
  const Scalar t_left_hip_block_17 = c_q8_q9_q10 * r_right_foot_y;
  const Scalar t_left_hip_block_18 = s_right_hip_roll * t_left_hip_block_17;
  const Scalar t_left_hip_block_19 = t_left_hip_block_18 - c_right_hip_roll * r_right_foot_x;
  const Scalar t_left_hip_block_20 = s_q8_q9_q10 * r_right_foot_y;
  C[139] = s_right_hip_yaw * t_left_hip_block_20 - c_right_hip_yaw * t_left_hip_block_19;
  C[142] = C[139];
  C[126] = t_righ_ankl_cros_4 * t_left_hip_block_15 - c_right_hip_yaw * t_righ_ankl_cros_7;
  C[138] = c_right_hip_yaw * t_left_hip_block_20 + s_right_hip_yaw * t_left_hip_block_19;
  C[141] = C[138];
  C[127] = -(s_right_hip_yaw * t_righ_ankl_cros_7 + t_righ_ankl_cros_4 * t_left_hip_block_16);
  C[116] = c_right_hip_roll * t_righ_ankl_cros_5;
  C[128] = c_right_hip_roll * t_righ_ankl_cros_4;
  C[140] = c_right_hip_roll * t_left_hip_block_17 + s_right_hip_roll * r_right_foot_x;
  C[143] = C[140];
  // right_ankle_cross: r of (9)
  const Scalar t_righ_ankl_cros_9 = t_righ_ankl_cros_6 + left_foot_l3 * s_q8_q9_q10;
  const Scalar t_righ_ankl_cros_10 = t_righ_ankl_cros_1 + t_righ_ankl_cros_9;
  const Scalar t_righ_ankl_cros_11 = t_righ_ankl_cros_3 - left_foot_l3 * c_q8_q9_q10;
  const Scalar t_righ_ankl_cros_12 = t_righ_ankl_cros_2 + t_righ_ankl_cros_11;
  const Scalar t_right_shank_5 = t_right_shank_1 + t_righ_ankl_cros_10;
  const Scalar t_right_shank_6 = t_right_shank_2 + t_righ_ankl_cros_12;
  const Scalar t_right_hip_fork_5 = t_right_hip_fork_2 - s_right_hip_roll * t_right_shank_5;
  C[95] = -t_right_hip_fork_5;
  const Scalar r_right_hip_block_x_2 = left_hip_fork_l1 - t_right_shank_6;
  C[81] = c_right_hip_yaw * t_right_hip_fork_5 - s_right_hip_yaw * r_right_hip_block_x_2;
  C[82] = c_right_hip_yaw * r_right_hip_block_x_2 + s_right_hip_yaw * t_right_hip_fork_5;
  const Scalar t_right_hip_fork_6 = t_right_hip_fork_1 + c_right_hip_roll * t_right_shank_5;
  // left_hip_block: C of (9)
  C[93] = -s_right_hip_yaw * t_right_hip_fork_6;
  C[94] = c_right_hip_yaw * t_right_hip_fork_6;
  C[106] = -(t_left_hip_block_16 * t_right_shank_6 + s_right_hip_yaw * t_right_shank_5);
  C[105] = t_left_hip_block_15 * t_right_shank_6 - c_right_hip_yaw * t_right_shank_5;
  C[117] = t_left_hip_block_15 * t_righ_ankl_cros_12 - c_right_hip_yaw * t_righ_ankl_cros_10;
  C[118] = -(t_left_hip_block_16 * t_righ_ankl_cros_12 + s_right_hip_yaw * t_righ_ankl_cros_10);
  C[107] = c_right_hip_roll * t_right_shank_6;
  C[129] = t_left_hip_block_15 * t_righ_ankl_cros_11 - c_right_hip_yaw * t_righ_ankl_cros_9;
  C[130] = -(t_left_hip_block_16 * t_righ_ankl_cros_11 + s_right_hip_yaw * t_righ_ankl_cros_9);
  C[119] = c_right_hip_roll * t_righ_ankl_cros_12;
  C[131] = c_right_hip_roll * t_righ_ankl_cros_11;
  C[2] = 0.0;
  C[5] = 0.0;
  C[6] = 0.0;
  C[7] = 0.0;
  C[8] = 0.0;
  C[9] = 0.0;
  C[10] = 0.0;
  C[11] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
  C[21] = 0.0;
  C[22] = 0.0;
  C[23] = 0.0;
  C[30] = 0.0;
  C[31] = 0.0;
  C[32] = 0.0;
  C[33] = 0.0;
  C[34] = 0.0;
  C[35] = 0.0;
  C[42] = 0.0;
  C[43] = 0.0;
  C[44] = 0.0;
  C[45] = 0.0;
  C[46] = 0.0;
  C[47] = 0.0;
  C[54] = 0.0;
  C[55] = 0.0;
  C[56] = 0.0;
  C[57] = 0.0;
  C[58] = 0.0;
  C[59] = 0.0;
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
  C[80] = 0.0;
  C[83] = 0.0;
  C[84] = 0.0;
  C[85] = 0.0;
  C[86] = 0.0;
  C[87] = 0.0;
  C[88] = 0.0;
  C[89] = 0.0;
  C[96] = 0.0;
  C[97] = 0.0;
  C[98] = 0.0;
  C[99] = 0.0;
  C[100] = 0.0;
  C[101] = 0.0;
  C[108] = 0.0;
  C[109] = 0.0;
  C[110] = 0.0;
  C[111] = 0.0;
  C[112] = 0.0;
  C[113] = 0.0;
  C[120] = 0.0;
  C[121] = 0.0;
  C[122] = 0.0;
  C[123] = 0.0;
  C[124] = 0.0;
  C[125] = 0.0;
  C[132] = 0.0;
  C[133] = 0.0;
  C[134] = 0.0;
  C[135] = 0.0;
  C[136] = 0.0;
  C[137] = 0.0;
}

}  // namespace biped
