// panda.cpp: see panda.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run
//   treedyn generate panda.yaml

#include "panda.hpp"

// g++ would gather scalars into vectors, which takes up to twice as long.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

namespace panda {

static_assert(kDigest == 0x269fb535900acd5fULL, "header and source are of different runs");

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

// m: offset z of link1
constexpr double link1_l1 = 0.333;
// kg m^2: mass, com x y, inertia xx yy zz of link1, link3; mass, com x z, inertia xx yy zz of
//     link2, link6; mass, com x z, inertia xx yy zz, offset x of link4; mass, com x y, inertia xx
//     yy zz, offset x of link5; mass, com x y, inertia xx xy yy zz, offset x of link7
constexpr double link1_I1 = 0.19383546586892408;
// kg m^2: mass, com x y, inertia xx yy zz of link1; mass, com z, inertia xx yy zz of link2
constexpr double link1_I2 = 0.014259565994474374;
// kg m^2: mass, com x y, inertia xx yy zz of link1, link3; mass, com x z, inertia xx yy zz of
//     link2; mass, com x z, inertia xx yy zz, offset x of link4; mass, offset x of link5; mass of
//     link6, link7
constexpr double link1_I3 = 0.16179265463762763;

// kg m: mass, com x of link2
constexpr double link2_h1 = 0.002031994566;
// kg m: mass, com y of link2; mass, com x z, offset y of link3; mass, com x, offset x of link4;
//     mass, offset x of link5; mass of link6, link7
constexpr double link2_h2 = 3.104340043512;
// kg m^2: mass, com x y, inertia xy of link2
constexpr double link2_I1 = 0.00796671776787104;
// kg m^2: mass, com x y, inertia xx yy zz of link2; mass, com x z, inertia xx yy zz, offset y of
//     link3; mass, com y, inertia xx yy zz, offset x of link4; mass, com z, inertia xx yy zz,
//     offset x y of link5; mass, com y, inertia xx yy zz of link6; mass, com z, inertia xx yy zz of
//     link7
constexpr double link2_I2 = 1.634512907529972;
// kg m^2: mass, com x y, inertia xx yy zz of link2; mass, com x z, inertia xx yy zz, offset y of
//     link3; mass, com y, inertia xx yy zz, offset x of link4; mass, com z, inertia xx yy zz,
//     offset x y of link5; mass, com y, inertia xx yy zz of link6; mass, com z, inertia xx yy zz of
//     link7
constexpr double link2_I3 = 1.475497800487053;
// kg m^2: mass, com x z, inertia xz of link2; mass, com x y, inertia xy of link3; mass, com z,
//     offset x of link4; offset x of link5
constexpr double link2_I4 = 0.010383014241958914;
// kg m^2: mass, com y z, inertia yz of link2
constexpr double link2_I5 = 0.0007689361029464;
// kg m^2: mass, com x y, inertia xx yy zz of link2; mass, com z, inertia xx yy zz, offset y of
//     link3; mass, com x, offset x of link4; offset x of link5
constexpr double link2_I6 = 0.34001233503451994;
// kg m^2: mass, com x y, inertia xy of link2
constexpr double link2_I7 = 0.00398335888393552;
// kg m^2: mass, com x z, inertia xz of link2
constexpr double link2_I8 = 0.01026110182100817;
// kg m^2: mass, com x, inertia xx yy zz of link2
constexpr double link2_I9 = 0.023077882494931805;
// kg m^2: mass, com y, inertia xx yy zz of link2; mass, com z, inertia xx yy zz, offset y of link3;
//     mass, com x, offset x of link4; offset x of link5
constexpr double link2_I10 = 0.3630902175294517;
// kg m^2: mass, com x y, inertia xx yy zz of link2, link6; mass, com x z, inertia xx yy zz, offset
//     y of link3; mass, com x y, inertia xx yy zz, offset x of link4; mass, com x z, inertia xx yy
//     zz, offset x y of link5; mass, com, inertia xx xy yy zz, offset x of link7
constexpr double link2_I11 = 1.6987581449384432;
// N m: gravity; mass, com y of link2; mass, com z, offset y of link3; mass, com x, offset x of
//     link4; offset x of link5
constexpr double link2_G1 = 12.038675848622248;
// N m: gravity; mass, com x of link2
constexpr double link2_G2 = 0.01993386669246;

// ratio: offset y of link3; offset x of link4, link5
constexpr double link3_k1 = 3.83030303030303;
// ratio: offset y of link3; offset x of link4, link5
constexpr double link3_k2 = 7.66060606060606;
// m: offset y of link3
constexpr double link3_l1 = 0.316;
// kg m: mass, com x of link3; mass, offset x of link4, link5; mass of link6, link7
constexpr double link3_h1 = 0.684157959872;
// kg m: mass, com y of link3; mass, com z of link4
constexpr double link3_h2 = 0.028227094878;
// kg m: mass, com x of link3; mass, com x, offset x of link4; offset x of link5
constexpr double link3_h3 = 0.194077685222;
// kg m^2: mass, com y z, inertia yz, offset y of link3; mass, com z, offset x of link4; offset x of
//     link5
constexpr double link3_I1 = 0.013297019103287584;
// kg m^2: mass, com x y, inertia xy of link3; mass, com z, offset x of link4; offset x of link5
constexpr double link3_I2 = 0.000243824841901488;
// kg m^2: mass, com x z, inertia xz, offset y of link3; mass, com x y, inertia xy, offset x of
//     link4; mass, com z, offset x y of link5; mass of link6, link7
constexpr double link3_I3 = 0.3604456361115751;
// kg m^2: mass, com x y, inertia xx yy zz of link3; mass, com x z, inertia xx yy zz, offset x of
//     link4; mass, com x y, inertia xx yy zz, offset x of link5; mass, com x z, inertia xx yy zz of
//     link6; mass, com x y, inertia xx xy yy zz, offset x of link7
constexpr double link3_I4 = 0.15649801737951788;
// kg m^2: mass, com x y, inertia xx yy zz of link3; mass, com z, inertia xx yy zz, offset x of
//     link4; mass, com y, inertia xx yy zz, offset x of link5; mass, com z, inertia xx yy zz of
//     link6; mass, com x y, inertia xx xy yy zz of link7
constexpr double link3_I5 = 0.02060656208200885;
// kg m^2: mass, com x z, inertia xz, offset y of link3; mass, com x, offset x of link4; offset x of
//     link5
constexpr double link3_I6 = 0.06681619663671426;
// kg m^2: mass, com x y, inertia xx yy zz of link3; mass, com x z, inertia xx yy zz, offset x of
//     link4; offset x of link5
constexpr double link3_I7 = 0.03817619733278093;
// kg m^2: mass, com x y, inertia xx yy zz of link3; mass, com x z, inertia xx yy zz, offset x of
//     link4; offset x of link5
constexpr double link3_I8 = 0.00618010059697554;
// kg m^2: mass, com x y, inertia xy of link3; mass, com z, offset x of link4; offset x of link5
constexpr double link3_I9 = 0.000121912420950744;
// kg m^2: mass, com y, inertia xx yy zz of link3; mass, com z, inertia xx yy zz of link4
constexpr double link3_I10 = 0.022178148964878235;
// kg m^2: mass, com x, inertia xx yy zz of link3; mass, com x, offset x of link4; offset x of link5
constexpr double link3_I11 = 0.015998048367902695;
// kg m^2: mass, com x y, inertia xx yy zz of link3; mass, com x z, inertia xx yy zz, offset x of
//     link4; mass, com x y, inertia xx yy zz, offset x of link5; mass, com x z, inertia xx yy zz of
//     link6; mass, com x y, inertia xx xy yy zz, offset x of link7
constexpr double link3_I12 = 0.0848517994904802;
// kg m^2: mass, com x of link3; mass, com x, offset x of link4; offset x of link5
constexpr double link3_I13 = 0.016011409030815;
// kg m^2: mass, com y of link3; mass, com z, offset x of link4; offset x of link5
constexpr double link3_I14 = 0.002328735327435;
// kg m^2: mass, com x y, inertia xx yy zz of link3; mass, com x z, inertia xx yy zz, offset x of
//     link4; mass, offset x of link5; mass of link6, link7
constexpr double link3_I15 = 0.12445520614822143;
// kg m^2: mass, com x y, inertia xx yy zz, offset y of link3; mass, com, inertia xx yy zz, offset x
//     of link4; mass, com y z, inertia xx yy zz, offset x y of link5; mass, com, inertia xx yy zz
//     of link6; mass, com, inertia xx xy yy zz, offset x of link7
constexpr double link3_I16 = 1.103283039275358;
// N m: gravity; mass, com y of link3; mass, com z of link4
constexpr double link3_G1 = 0.27690780075318;
// N m: gravity; mass, com x of link3; mass, com x, offset x of link4; offset x of link5
constexpr double link3_G2 = 1.90390209202782;

// ratio: offset x of link4; offset x y of link5
constexpr double link4_k1 = 4.654545454545454;
// ratio: offset x of link4; offset x y of link5
constexpr double link4_k2 = 9.309090909090909;
// ratio: offset x of link4, link5, link7
constexpr double link4_k3 = 1.0666666666666667;
// kg: mass, com x, offset x of link4; mass, offset x of link5; mass, com x of link6; offset x of
//     link7
constexpr double link4_m1 = 4.065735684829545;
// m: offset x of link4, link5
constexpr double link4_l1 = 0.0825;
// kg m: mass, com x, offset x of link4; mass, offset x of link5; mass of link6, link7
constexpr double link4_h1 = 0.49008027465;
// kg m: mass, com y of link4; mass, com z, offset y of link5; mass of link6, link7
constexpr double link4_h2 = 1.720683553603;
// kg m: mass, com y of link4; mass, com z, offset y of link5; mass, com x of link6; offset x of
//     link7
constexpr double link4_h3 = 1.000825141843;
// kg m^2: mass, com y z, inertia yz of link4
constexpr double link4_I1 = 0.00164448757736927;
// kg m^2: mass, com x z, inertia xz of link4; mass, com x y, inertia xy of link5
constexpr double link4_I2 = 0.00239011055294907;
// kg m^2: mass, com y, offset x of link4; mass, com z, offset x y of link5; mass of link6, link7
constexpr double link4_I3 = 0.1419563931722475;
// kg m^2: mass, com x, offset x of link4; mass, offset x of link5; mass of link6, link7
constexpr double link4_I4 = 0.040431622658625;
// kg m^2: mass, com x y, inertia xy, offset x of link4; mass, com z, offset x y of link5; mass of
//     link6, link7
constexpr double link4_I5 = 0.2775281453709217;
// kg m^2: mass, com x, inertia xx yy zz, offset x of link4, link5; mass, com x, inertia xx yy zz of
//     link6; mass, com x y, inertia xx xy yy zz, offset x of link7
constexpr double link4_I6 = 0.06424523740847135;
// kg m^2: mass, com y, inertia xx yy zz of link4, link6; mass, com z, inertia xx yy zz, offset y of
//     link5; mass, com z, inertia xx yy zz of link7
constexpr double link4_I7 = 0.5987338527766317;
// kg m^2: mass, com y, offset x of link4; mass, com z, offset x y of link5; mass, com x of link6;
//     offset x of link7
constexpr double link4_I8 = 0.0825680742020475;
// kg m^2: mass, com x, offset x of link4; mass, offset x of link5; mass, com x of link6; offset x
//     of link7
constexpr double link4_I9 = 0.027672413504871093;
// kg m^2: mass, com x y, inertia xy, offset x of link4; mass, com z, offset x y of link5; mass, com
//     x of link6; offset x of link7
constexpr double link4_I10 = 0.07937575371526084;
// kg m^2: mass, com x z, inertia xz of link4
constexpr double link4_I11 = 0.0039053550262761;
// kg m^2: mass, com x, inertia xx yy zz, offset x of link4; offset x of link5
constexpr double link4_I12 = 0.0054157634981905;
// kg m^2: mass, com y, inertia xx yy zz, offset x of link4; mass, com z, inertia xx yy zz, offset x
//     y of link5; mass, com x of link6; offset x of link7
constexpr double link4_I13 = 0.3087998849151318;
// kg m^2: mass, com x y, inertia xx yy zz, offset x of link4; mass, com z, inertia xx yy zz, offset
//     x y of link5; mass, com x of link6; offset x of link7
constexpr double link4_I14 = 0.3142156484133223;
// kg m^2: mass, com x y, inertia xx yy zz, offset x of link4; mass, com z, inertia xx yy zz, offset
//     x y of link5; mass, com x of link6; offset x of link7
constexpr double link4_I15 = 0.30338412141694127;
// kg m^2: mass, com x y, inertia xx yy zz, offset x of link4; mass, com y z, inertia xx yy zz,
//     offset x y of link5; mass, com, inertia xx yy zz of link6; mass, com, inertia xx xy yy zz,
//     offset x of link7
constexpr double link4_I16 = 0.5665314265994568;
// kg m^2: mass, com x y, inertia xx yy zz, offset x of link4; mass, com x z, inertia xx yy zz,
//     offset x y of link5; mass, com x y, inertia xx yy zz of link6; mass, com, inertia xx xy yy
//     zz, offset x of link7
constexpr double link4_I17 = 0.662979090185103;
// s^-2: gravity; offset x of link4, link5
constexpr double link4_p1 = 118.9090909090909;

// m: offset y of link5
constexpr double link5_l1 = 0.384;
// kg m: mass, com x of link5
constexpr double link5_h1 = 0.014653732538;
// kg m: mass, com y of link5; mass, com z of link6
constexpr double link5_h2 = 0.067870631425;
// kg m^2: mass, com x y, inertia xy of link5
constexpr double link5_I1 = 0.00303048894665406;
// kg m^2: mass, com y z, inertia yz, offset y of link5; mass, com z of link6
constexpr double link5_I2 = 0.02389827041510187;
// kg m^2: offset x of link4; mass, com x, offset x of link5
constexpr double link5_I3 = 0.001208932934385;
// kg m^2: offset x of link4; mass, com y, offset x of link5; mass, com z of link6
constexpr double link5_I4 = 0.0055993270925625;
// kg m^2: mass, com x z, inertia xz, offset y of link5; mass, com x y, inertia xy of link6; mass,
//     com z, offset x of link7
constexpr double link5_I5 = 0.004484246605646421;
// kg m^2: mass, com x y, inertia xx yy zz of link5; mass, com x z, inertia xx yy zz of link6; mass,
//     com x y, inertia xx yy zz, offset x of link7
constexpr double link5_I6 = 0.03204281123129646;
// kg m^2: mass, com x y, inertia xx yy zz of link5; mass, com x z, inertia xx yy zz of link6; mass,
//     com x y, inertia xx xy yy zz, offset x of link7
constexpr double link5_I7 = 0.004752891272015237;
// kg m^2: mass, com x z, inertia xz, offset y of link5
constexpr double link5_I8 = 0.001026787777028894;
// kg m^2: mass, com x y, inertia xy of link5
constexpr double link5_I9 = 0.00151524447332703;
// kg m^2: mass, com x y, inertia xx yy zz of link5; mass, com z, inertia xx yy zz of link6
constexpr double link5_I10 = 0.00859403176329453;
// kg m^2: mass, com x y, inertia xx yy zz of link5; mass, com z, inertia xx yy zz of link6
constexpr double link5_I11 = 0.011496343893347959;
// kg m^2: mass, com y, inertia xx yy zz of link5; mass, com z, inertia xx yy zz of link6
constexpr double link5_I12 = 0.010045187828321245;
// kg m^2: mass, com x, inertia xx yy zz of link5
constexpr double link5_I13 = 0.001451156065026714;

// kg: mass, com x of link6; mass, offset x of link7
constexpr double link6_m1 = 1.874631280625;
// kg m: mass, com x of link6; mass, offset x of link7
constexpr double link6_h1 = 0.164967552695;
// kg m: mass, com y of link6; mass, com z of link7
constexpr double link6_h2 = 0.068832705569;
// kg m^2: mass, com x y, inertia xy of link6; mass, com z, offset x of link7
constexpr double link6_I1 = 0.01102206876535063;
// kg m^2: offset x of link4, link5; mass, com y of link6; mass, com z of link7
constexpr double link6_I2 = 0.0056786982094425;
// kg m^2: offset x of link4, link5; mass, com x of link6; mass, offset x of link7
constexpr double link6_I3 = 0.0136098230973375;
// kg m^2: mass, com x z, inertia xz of link6; mass, com x y, inertia xx xy yy zz of link7
constexpr double link6_I4 = 0.0006609405457638925;
// kg m^2: mass, com y z, inertia yz of link6
constexpr double link6_I5 = 9.3569097314605e-05;
// kg m^2: mass, com x y, inertia xx yy zz of link6; mass, com, inertia xx xy yy zz, offset x of
//     link7
constexpr double link6_I6 = 0.0034383574409692415;
// kg m^2: mass, com x y, inertia xx yy zz of link6; mass, com, inertia xx xy yy zz, offset x of
//     link7
constexpr double link6_I7 = 0.030455032932289027;
// kg m^2: offset x of link4, link5; mass, com x of link6; mass, offset x of link7
constexpr double link6_I8 = 0.012759209153753906;
// kg m^2: mass, com x z, inertia xz of link6
constexpr double link6_I9 = 0.000103758917218685;
// kg m^2: mass, com x y, inertia xy of link6; mass, com z, offset x of link7
constexpr double link6_I10 = 0.005511034382675315;
// kg m^2: mass, com x y, inertia xx yy zz of link6; mass, com z, inertia xx yy zz, offset x of
//     link7
constexpr double link6_I11 = 0.012388667012232337;
// kg m^2: mass, com x y, inertia xx yy zz of link6; mass, com z, inertia xx yy zz, offset x of
//     link7
constexpr double link6_I12 = 0.014628008479087448;
// kg m^2: mass, com x, inertia xx yy zz of link6; offset x of link7
constexpr double link6_I13 = 0.001119670733427555;
// kg m^2: mass, com y, inertia xx yy zz of link6; mass, com z, inertia xx yy zz of link7
constexpr double link6_I14 = 0.013508337745659894;

// ratio: mass, com x y of link7
constexpr double link7_k1 = 0.3842058806066518;
// m: offset x of link7
constexpr double link7_l1 = 0.088;
// m: points of link7
constexpr double link7_l2 = 0.107;
// kg m: mass, com x y of link7
constexpr double link7_h1 = 0.008343776383464369;
// kg m^2: offset x of link4, link5; mass, com x y, offset x of link7
constexpr double link7_I1 = 0.0007342523217448644;
// kg m^2: mass, com x y, inertia xx yy zz of link7
constexpr double link7_I2 = 0.004909651967360946;
// kg m^2: mass, com, inertia xz yz of link7
constexpr double link7_I3 = 0.00113526676062776;
// kg m^2: mass, com, inertia xz yz of link7
constexpr double link7_I4 = 0.0013450149983408877;
// kg m^2: offset y of link5; mass, com x y of link7
constexpr double link7_I5 = 0.0032040101312503172;
// kg m^2: offset x of link4, link5; mass, com x y of link7
constexpr double link7_I6 = 0.0006883615516358103;
// kg m^2: mass, com x y, inertia xx xy yy zz of link7
constexpr double link7_I7 = 0.0011143632570904149;
// kg m^2: mass, com x y, inertia xx xy yy zz of link7
constexpr double link7_I8 = 0.0022898923352777873;
// kg m^2: offset x of link4, link5; mass, com x y, offset x of link7
constexpr double link7_I9 = 0.0014685046434897288;
// kg m^2: mass, com x y, inertia xx xy yy zz of link7
constexpr double link7_I10 = 0.0035997721513193665;
// kg m^2: mass, com x y, inertia xx xy yy zz of link7
constexpr double link7_I11 = 0.0005571816285452074;
// kg m^2: mass, com x y, inertia xx xy yy zz of link7
constexpr double link7_I12 = 0.0013098798160415795;
// kg^-1 m^-2: mass, com x y, inertia xx yy zz of link7
constexpr double link7_p1 = 203.68042513969144;

}  // namespace

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = 0.0825 m
// Names: vectors h_ in kg m^2/L; all others are of values in SI units; numbered ones (t_) by what
// they are made of. Arguments and results are in SI units.
void mass_matrix(const Scalar q[7], Scalar A[49]) noexcept {
  const auto p_s_joint2 = sine_cosine(q[1]);
  const Scalar& s_joint2 = p_s_joint2.sine;
  const Scalar& c_joint2 = p_s_joint2.cosine;
  const auto p_s_joint3 = sine_cosine(q[2]);
  const Scalar& s_joint3 = p_s_joint3.sine;
  const Scalar& c_joint3 = p_s_joint3.cosine;
  const auto p_s_joint4 = sine_cosine(q[3]);
  const Scalar& s_joint4 = p_s_joint4.sine;
  const Scalar& c_joint4 = p_s_joint4.cosine;
  const auto p_s_joint5 = sine_cosine(q[4]);
  const Scalar& s_joint5 = p_s_joint5.sine;
  const Scalar& c_joint5 = p_s_joint5.cosine;
  const auto p_s_joint6 = sine_cosine(q[5]);
  const Scalar& s_joint6 = p_s_joint6.sine;
  const Scalar& c_joint6 = p_s_joint6.cosine;
  // link7: A, first moment h of (2)
  const Scalar t_link7_1 = link7_k1 - q[6];
  const auto p_s_link7 = sine_cosine(t_link7_1);
  const Scalar& s_link7 = p_s_link7.sine;
  const Scalar& c_link7 = p_s_link7.cosine;
  const Scalar t_link7_2 = link7_I6 * c_link7;
  const Scalar h_link6_x = link6_I3 + t_link7_2;
  const Scalar t_link7_3 = link7_I6 * s_link7;
  const Scalar t_link7_4 = link7_I7 * c_link7 - link7_I8 * s_link7;
  const Scalar t_link7_5 = s_link7 * t_link7_4;
  const Scalar t_link7_6 = link7_I4 * s_link7 - link7_I3 * c_link7;
  A[41] = t_link7_6;
  A[47] = A[41];
  const Scalar t_link7_7 = link7_I9 * c_link7;
  const Scalar t_link6_1 = link6_I2 * s_joint6 + c_joint6 * h_link6_x;
  const Scalar t_link6_2 = link6_I2 * c_joint6 - s_joint6 * h_link6_x;
  const Scalar t_link7_8 = link7_I3 * s_link7 + link7_I4 * c_link7;
  // link6: A, pseudo-inertia E, first moment h of (2)
  const Scalar t_link6_3 = t_link7_5 - t_link7_7;
  const Scalar t_link6_4 = c_joint6 * (link6_I1 + 2.0 * t_link7_8);
  const Scalar t_link6_5 = t_link6_4 - s_joint6 * (link6_I6 - t_link6_3);
  const Scalar t_link6_6 = s_joint6 * t_link6_5;
  const Scalar E_link6_xz = link6_I4 - link7_I1 * s_link7 - c_link7 * t_link7_4;
  const Scalar t_link6_7 = link6_I5 - t_link7_6;
  const Scalar t_link6_8 = s_joint6 * t_link6_7 + c_joint6 * E_link6_xz;
  const Scalar t_link6_9 = c_joint6 * t_link6_7 - s_joint6 * E_link6_xz;
  A[33] = t_link6_9;
  A[39] = A[33];
  const Scalar t_link6_10 = link6_I7 - t_link6_3;
  A[40] = t_link6_10;
  const Scalar t_link6_11 = link7_I5 * s_link7;
  const Scalar t_link6_12 = link5_I3 - t_link6_1;
  const Scalar h_link5_y = link5_I4 + t_link7_3;
  const Scalar t_link5_1 = c_joint5 * t_link6_12 + s_joint5 * h_link5_y;
  const Scalar h_link4_z = s_joint5 * t_link6_12 - c_joint5 * h_link5_y;
  // link5: pseudo-inertia E, A, first moment h of (2)
  const Scalar E_link5_yz = link5_I2 + t_link6_9 + t_link6_11;
  const Scalar t_link5_2 = link5_I5 + t_link7_8 - c_joint6 * t_link6_5;
  const Scalar E_link5_xz = t_link5_2 + link4_k1 * t_link6_1;
  const Scalar t_link5_3 = s_joint5 * E_link5_xz + c_joint5 * E_link5_yz;
  A[25] = t_link5_3;
  A[31] = A[25];
  const Scalar t_link5_4 = t_link7_7 + t_link6_6;
  const Scalar t_link5_5 = link5_I6 + t_link5_4;
  A[32] = t_link5_5;
  const Scalar t_link5_6 = link4_I3 - t_link6_2;
  const Scalar h_link4_x = link4_I4 + t_link5_1;
  const Scalar t_link5_7 = c_joint5 * t_link6_8;
  const Scalar t_link5_8 = s_joint5 * (link5_I7 + t_link5_4 - 2.0 * t_link7_5);
  const Scalar t_link5_9 = link5_I1 * c_joint5 + t_link5_8 - 2.0 * t_link5_7;
  // link4: pseudo-inertia E, A, first moment h of (2)
  const Scalar t_link4_1 = t_link5_4 + 2.0 * t_link5_1;
  const Scalar t_link4_2 = t_link7_5 + s_joint5 * t_link5_9;
  const Scalar t_link4_3 = t_link4_2 - (link4_I6 + t_link4_1);
  const Scalar t_link4_4 = t_link6_6 + link4_k2 * t_link6_2;
  const Scalar E_link4_yy = link4_I7 - t_link4_4;
  const Scalar t_link5_10 = s_joint5 * E_link5_yz - c_joint5 * E_link5_xz;
  const Scalar t_link4_5 = t_link6_2 - t_link5_10;
  const Scalar t_link4_6 = c_joint4 * (link4_I5 - 2.0 * t_link4_5);
  const Scalar t_link4_7 = s_joint4 * (t_link4_3 + E_link4_yy) + t_link4_6;
  const Scalar t_link4_8 = s_joint4 * t_link4_7;
  const Scalar t_link4_9 = link4_I1 - t_link5_3;
  const Scalar E_link4_xz = link4_I2 + t_link6_8 + h_link4_z + c_joint5 * t_link5_9;
  const Scalar t_link4_10 = s_joint4 * t_link4_9 + c_joint4 * E_link4_xz;
  const Scalar t_link4_11 = c_joint4 * t_link4_9 - s_joint4 * E_link4_xz;
  A[17] = -t_link4_11;
  A[23] = A[17];
  const Scalar t_link4_12 = t_link4_3 - E_link4_yy;
  A[24] = -t_link4_12;
  const Scalar E_link3_yz = link3_I1 - t_link4_11 - link3_k1 * h_link4_z;
  const Scalar t_link4_13 = s_joint4 * h_link4_x - c_joint4 * t_link5_6;
  const Scalar t_link4_14 = c_joint4 * h_link4_x + s_joint4 * t_link5_6;
  // link3: pseudo-inertia E, A of (2)
  const Scalar t_link3_1 = t_link4_13 - (link3_I3 - t_link4_5) + c_joint4 * t_link4_7;
  const Scalar t_link3_2 = t_link3_1 + link3_k1 * t_link4_14;
  const Scalar t_link3_3 = c_joint3 * E_link3_yz - s_joint3 * t_link3_2;
  A[9] = -t_link3_3;
  A[15] = A[9];
  const Scalar t_link3_4 = t_link4_8 - 2.0 * t_link4_14;
  const Scalar t_link3_5 = t_link4_1 + t_link3_4;
  const Scalar t_link3_6 = link3_I4 + t_link3_5;
  A[16] = t_link3_6;
  const Scalar t_link3_7 = h_link4_z - t_link4_10;
  const Scalar t_link3_8 = t_link4_3 - t_link3_4;
  const Scalar t_link3_9 = s_joint3 * (t_link3_8 - (link3_I5 - t_link4_2));
  const Scalar t_link3_10 = t_link3_9 - c_joint3 * (link3_I2 - 2.0 * t_link3_7);
  // link2: A of (2)
  const Scalar t_link2_1 = s_joint2 * (link2_I4 - t_link3_7 + c_joint3 * t_link3_10);
  A[1] = -(t_link2_1 + c_joint2 * (link2_I5 + t_link3_3));
  A[7] = A[1];
  const Scalar t_link2_2 = t_link3_8 - s_joint3 * t_link3_10;
  const Scalar t_link2_3 = t_link4_4 + t_link4_8 + link3_k2 * t_link4_13;
  A[8] = link2_I2 - t_link2_2 - t_link2_3;
  const Scalar t_link3_11 = s_joint3 * E_link3_yz + c_joint3 * t_link3_2;
  const Scalar t_link2_4 = s_joint2 * (t_link2_3 - (link2_I3 + t_link2_2));
  const Scalar t_link2_5 = s_joint2 * (c_joint2 * (link2_I1 + 2.0 * t_link3_11) + t_link2_4);
  A[0] = link1_I1 + t_link3_5 - t_link2_5;
  const Scalar t_link7_9 = link7_I2 + link7_I1 * c_link7;
  // link6: A of (2)
  const Scalar t_link6_13 = s_joint6 * t_link7_8 + c_joint6 * t_link7_9;
  A[34] = -t_link6_13;
  A[46] = A[34];
  const Scalar t_link6_14 = s_joint6 * t_link7_3;
  const Scalar t_link6_15 = t_link7_6 - c_joint6 * t_link6_11;
  const Scalar t_link6_16 = link7_I5 * c_link7 - c_joint6 * t_link7_8 + s_joint6 * t_link7_9;
  const Scalar t_link5_11 = t_link6_14 - c_joint5 * t_link6_15 + s_joint5 * t_link6_16;
  A[27] = -t_link5_11;
  A[45] = A[27];
  const Scalar t_link6_17 = c_joint6 * t_link7_3;
  // link5
  const Scalar t_link5_12 = s_joint5 * t_link6_15 + c_joint5 * t_link6_16;
  const Scalar t_link5_13 = s_joint5 * t_link6_17 - c_joint5 * t_link7_2;
  const Scalar t_link5_14 = t_link6_13 + t_link5_13;
  // link4: A of (2)
  const Scalar t_link4_15 = t_link5_13 + s_joint4 * t_link5_12 - c_joint4 * t_link5_14;
  A[20] = t_link4_15;
  A[44] = A[20];
  const Scalar t_link4_16 = c_joint4 + link3_k1 * s_joint4;
  const Scalar t_link4_17 = s_joint4 - link3_k1 * c_joint4;
  const Scalar t_link4_18 = (c_joint5 * t_link6_17 + s_joint5 * t_link7_2) * t_link4_17;
  const Scalar t_link4_19 = t_link5_11 - t_link6_14 * t_link4_16 - t_link4_18;
  const Scalar t_link4_20 = c_joint4 * t_link5_12 + s_joint4 * t_link5_14;
  const Scalar t_link4_21 = t_link4_20 - link3_k1 * t_link5_13;
  A[13] = c_joint3 * t_link4_19 + s_joint3 * t_link4_21;
  A[43] = A[13];
  A[6] = c_joint2 * t_link4_15 - s_joint2 * (c_joint3 * t_link4_21 - s_joint3 * t_link4_19);
  A[42] = A[6];
  const Scalar t_link6_18 = t_link6_10 - link4_k1 * t_link6_2;
  // link5: A of (2)
  const Scalar t_link5_15 = t_link6_1 - c_joint5 * t_link6_18 - s_joint5 * t_link6_8;
  A[26] = -t_link5_15;
  A[38] = A[26];
  const Scalar t_link5_16 = s_joint5 * t_link6_2;
  const Scalar t_link5_17 = t_link6_9 - t_link5_16;
  const Scalar t_link5_18 = t_link5_7 - s_joint5 * t_link6_18;
  // link4: A of (2)
  const Scalar t_link4_22 = t_link5_16 + c_joint4 * t_link5_17 - s_joint4 * t_link5_18;
  A[19] = t_link4_22;
  A[37] = A[19];
  const Scalar t_link4_23 = t_link5_15 - c_joint5 * t_link6_2 * t_link4_17;
  const Scalar t_link4_24 = t_link4_23 - t_link6_1 * t_link4_16;
  const Scalar t_link4_25 = link3_k1 * t_link5_16 + s_joint4 * t_link5_17;
  const Scalar t_link4_26 = t_link4_25 + c_joint4 * t_link5_18;
  A[12] = c_joint3 * t_link4_24 - s_joint3 * t_link4_26;
  A[36] = A[12];
  A[5] = s_joint2 * (c_joint3 * t_link4_26 + s_joint3 * t_link4_24) + c_joint2 * t_link4_22;
  A[35] = A[5];
  const Scalar t_link5_19 = t_link5_1 + t_link5_5;
  const Scalar t_link4_27 = t_link5_1 - c_joint4 * t_link5_19 - s_joint4 * t_link5_10;
  A[18] = -t_link4_27;
  A[30] = A[18];
  const Scalar t_link4_28 = s_joint4 * t_link5_19 - link3_k1 * t_link5_1;
  const Scalar t_link4_29 = t_link4_28 - c_joint4 * t_link5_10;
  const Scalar t_link4_30 = t_link5_3 + h_link4_z * t_link4_17;
  A[11] = -(s_joint3 * t_link4_29 + c_joint3 * t_link4_30);
  A[29] = A[11];
  A[4] = -(s_joint2 * (s_joint3 * t_link4_30 - c_joint3 * t_link4_29) + c_joint2 * t_link4_27);
  A[28] = A[4];
  const Scalar t_link4_31 = t_link4_12 + t_link4_14 + link3_k1 * t_link4_13;
  A[10] = c_joint3 * t_link4_31 + s_joint3 * t_link4_10;
  A[22] = A[10];
  // link2: A of (2)
  A[3] = -(c_joint2 * t_link4_11 + s_joint2 * (c_joint3 * t_link4_10 - s_joint3 * t_link4_31));
  A[21] = A[3];
  A[2] = c_joint2 * t_link3_6 - s_joint2 * t_link3_11;
  A[14] = A[2];
  A[48] = link7_I2;
}

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = 0.0825 m
// Names: vectors F_ in N m/L, a_ in L/s^2; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void bias_force(const Scalar q[7], const Scalar qd[7], Scalar B[7]) noexcept {
  const auto p_s_joint2 = sine_cosine(q[1]);
  const Scalar& s_joint2 = p_s_joint2.sine;
  const Scalar& c_joint2 = p_s_joint2.cosine;
  const auto p_s_joint3 = sine_cosine(q[2]);
  const Scalar& s_joint3 = p_s_joint3.sine;
  const Scalar& c_joint3 = p_s_joint3.cosine;
  const auto p_s_joint4 = sine_cosine(q[3]);
  const Scalar& s_joint4 = p_s_joint4.sine;
  const Scalar& c_joint4 = p_s_joint4.cosine;
  const auto p_s_joint5 = sine_cosine(q[4]);
  const Scalar& s_joint5 = p_s_joint5.sine;
  const Scalar& c_joint5 = p_s_joint5.cosine;
  const auto p_s_joint6 = sine_cosine(q[5]);
  const Scalar& s_joint6 = p_s_joint6.sine;
  const Scalar& c_joint6 = p_s_joint6.cosine;
  const Scalar t_link2_1 = link2_I7 - c_joint2 * (link2_I1 * c_joint2 - link2_I6 * s_joint2);
  const Scalar t_link2_2 = qd[0] * t_link2_1;
  // link3: angular velocity omega, Omega, angular acceleration alpha of (3)
  const Scalar t_link3_1 = s_joint2 * qd[0];
  const Scalar t_link3_2 = c_joint3 * qd[1];
  const Scalar omega_link3_y = t_link3_2 + s_joint3 * t_link3_1;
  const Scalar t_link3_3 = c_joint2 * qd[0];
  const Scalar omega_link3_z = qd[2] + t_link3_3;
  const Scalar t_link3_4 = omega_link3_y * omega_link3_z;
  const Scalar t_link3_5 = t_link3_2 * t_link3_3 - omega_link3_y * qd[2];
  const Scalar Omega_link3_zy = t_link3_4 - t_link3_5;
  const Scalar t_link3_6 = s_joint3 * qd[1];
  const Scalar omega_link3_x = t_link3_6 - c_joint3 * t_link3_1;
  const Scalar t_link3_7 = omega_link3_x * omega_link3_x;
  const Scalar t_link3_8 = omega_link3_y * omega_link3_y;
  const Scalar t_link3_9 = omega_link3_z * omega_link3_z;
  const Scalar alpha_link3_y = t_link3_3 * t_link3_6 - qd[2] * omega_link3_x;
  const Scalar t_link3_10 = omega_link3_z * omega_link3_x;
  const Scalar t_link3_11 = alpha_link3_y - t_link3_10;
  const Scalar t_link3_12 = omega_link3_y * omega_link3_x;
  const Scalar t_link3_13 = qd[1] * t_link3_1;
  const Scalar Omega_link3_xy = t_link3_12 + t_link3_13;
  // link4: angular velocity omega, Omega, acceleration a of (3)
  const Scalar t_link4_1 = c_joint4 * omega_link3_z - s_joint4 * omega_link3_x;
  const Scalar t_link4_2 = omega_link3_y - qd[3];
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy - s_joint4 * Omega_link3_xy;
  const Scalar t_link4_3 = Omega_link4_yz - t_link4_1 * t_link4_2 * 2.0;
  const Scalar Omega_link3_xz = alpha_link3_y + t_link3_10;
  const Scalar t_link4_4 = t_link3_8 + t_link3_9 - link3_k1 * Omega_link3_xz;
  const Scalar t_link4_5 = s_joint4 * omega_link3_z + c_joint4 * omega_link3_x;
  const Scalar t_link4_6 = t_link4_2 * t_link4_5;
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy + c_joint4 * Omega_link3_xy;
  const Scalar alpha_link5_z = t_link4_6 - Omega_link4_xz;
  const Scalar Omega_link4_zx = t_link4_6 + alpha_link5_z;
  const Scalar t_link4_7 = t_link4_5 * t_link4_5;
  const Scalar t_link4_8 = t_link4_2 * t_link4_2;
  const Scalar Omega_link3_yz = t_link3_4 + t_link3_5;
  const Scalar Omega_link3_yx = t_link3_12 - t_link3_13;
  const Scalar t_link4_9 = Omega_link3_yx + link3_k1 * Omega_link3_yz;
  const Scalar t_link4_10 = t_link4_7 + t_link4_8;
  const Scalar t_link4_11 = t_link4_1 * t_link4_5;
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_11;
  // link5: angular velocity omega, Omega of (3)
  const Scalar omega_link5_z = t_link4_1 + qd[4];
  const Scalar t_link5_1 = s_joint5 * Omega_link4_xy + c_joint5 * t_link4_3;
  const Scalar t_link5_2 = s_joint5 * t_link4_5 - c_joint5 * t_link4_2;
  const Scalar Omega_link5_zy = t_link5_1 - omega_link5_z * t_link5_2 * 2.0;
  const Scalar t_link5_3 = s_joint5 * t_link4_3 - c_joint5 * Omega_link4_xy;
  const Scalar omega_link5_x = s_joint5 * t_link4_2 + c_joint5 * t_link4_5;
  const Scalar t_link5_4 = omega_link5_z * omega_link5_x;
  const Scalar alpha_link6_z = t_link5_3 + t_link5_4;
  const Scalar Omega_link5_zx = t_link5_4 + alpha_link6_z;
  // link4: acceleration a, Omega of (3)
  const Scalar t_link4_12 = t_link3_11 + link3_k1 * (t_link3_7 + t_link3_8);
  const Scalar t_link4_13 = t_link4_7 - t_link4_8;
  const Scalar a_link4_x = c_joint4 * t_link4_4 + s_joint4 * t_link4_12;
  const Scalar t_link3_14 = t_link3_7 + t_link3_9;
  const Scalar Omega_link4_xx = t_link4_13 - t_link3_14;
  const Scalar t_link5_5 = a_link4_x + Omega_link4_xx;
  const Scalar t_link4_14 = alpha_link3_y - t_link4_11;
  // link5: acceleration a, Omega of (3)
  const Scalar a_link5_z = t_link4_14 - c_joint4 * t_link4_12 + s_joint4 * t_link4_4;
  const Scalar t_link5_6 = t_link5_2 * omega_link5_x;
  const Scalar t_link5_7 = alpha_link5_z + t_link5_6;
  const Scalar t_link5_8 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_9 = omega_link5_z * omega_link5_z;
  const Scalar t_link5_10 = t_link5_8 + t_link5_9;
  const Scalar Omega_link7_xy = c_joint6 * t_link5_7 - s_joint6 * Omega_link5_zy;
  // link6: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_link6_x = c_joint6 * omega_link5_x + s_joint6 * omega_link5_z;
  const Scalar omega_link6_z = t_link5_2 + qd[5];
  const Scalar t_link6_1 = 2.0 * omega_link6_z;
  const Scalar t_link6_2 = Omega_link7_xy - omega_link6_x * t_link6_1;
  const Scalar omega_link6_y = c_joint6 * omega_link5_z - s_joint6 * omega_link5_x;
  const Scalar t_link6_3 = c_joint6 * Omega_link5_zy + s_joint6 * t_link5_7;
  const Scalar Omega_link6_zy = t_link6_3 + t_link6_1 * omega_link6_y;
  const Scalar t_link6_4 = omega_link6_x * omega_link6_y;
  const Scalar Omega_link7_xz = alpha_link6_z - t_link6_4;
  const Scalar t_link5_11 = Omega_link4_zx - t_link4_9;
  const Scalar a_link5_y = s_joint5 * t_link5_5 - c_joint5 * t_link5_11;
  const Scalar t_link6_5 = a_link5_y - link4_k1 * t_link5_1;
  const Scalar Omega_link6_yx = alpha_link6_z + t_link6_4;
  const Scalar t_link6_6 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_7 = omega_link6_z * omega_link6_z;
  const Scalar t_link6_8 = t_link6_6 + t_link6_7;
  // link7: angular velocity omega, Omega, acceleration a of (3)
  const Scalar t_link7_1 = omega_link6_y - qd[6];
  const Scalar t_link7_2 = 2.0 * t_link7_1;
  const Scalar Omega_link7_zy = Omega_link6_zy - omega_link6_z * t_link7_2;
  const Scalar t_link6_9 = a_link5_z - link4_k1 * t_link4_10;
  const Scalar t_link5_12 = s_joint5 * t_link5_11 + c_joint5 * t_link5_5;
  const Scalar t_link6_10 = t_link5_12 + link4_k1 * t_link5_3;
  const Scalar t_link7_3 = link4_k3 * Omega_link6_yx + c_joint6 * t_link6_9;
  const Scalar t_link7_4 = t_link7_3 + s_joint6 * t_link6_10;
  const Scalar t_link6_11 = t_link6_6 - t_link6_7;
  const Scalar t_link7_5 = Omega_link7_xz + omega_link6_x * t_link7_2;
  const Scalar t_link7_6 = t_link7_1 * t_link7_1;
  const Scalar t_link7_7 = link7_k1 - q[6];
  const auto p_s_link7 = sine_cosine(t_link7_7);
  const Scalar& s_link7 = p_s_link7.sine;
  const Scalar& c_link7 = p_s_link7.cosine;
  const Scalar t_link7_8 = link7_I7 * c_link7 - link7_I8 * s_link7;
  const Scalar t_link7_9 = link7_I11 - c_link7 * t_link7_8;
  const Scalar t_link7_10 = s_link7 * t_link7_8;
  const Scalar t_link7_11 = link7_I12 - t_link7_10;
  const Scalar t_link7_12 = link7_I3 * s_link7 + link7_I4 * c_link7;
  const Scalar t_link7_13 = link7_I6 * c_link7;
  const Scalar t_link7_14 = link7_I6 * s_link7;
  const Scalar a_link6_x = s_joint6 * t_link6_9 - c_joint6 * t_link6_10;
  const Scalar t_link7_15 = link7_I10 + t_link7_10;
  const Scalar t_link7_16 = t_link6_5 + link4_k3 * t_link6_2;
  const Scalar t_link7_17 = link7_I4 * s_link7 - link7_I3 * c_link7;
  const Scalar t_link6_12 = t_link5_10 - t_link6_11;
  const Scalar a_link7_x = a_link6_x - link4_k3 * t_link6_12;
  const Scalar t_link7_18 = t_link6_11 * t_link7_9 + t_link7_13 * t_link7_16;
  const Scalar t_link7_19 = t_link7_18 - Omega_link7_xz * t_link7_17 - t_link7_14 * a_link7_x;
  const Scalar t_link7_20 = t_link7_19 + Omega_link6_zy * t_link7_12 + t_link6_2 * t_link7_11;
  const Scalar t_link7_21 = t_link7_20 + Omega_link7_xy * t_link7_15;
  B[6] = -t_link7_21;
  const Scalar t_link7_22 = link6_I8 * t_link7_4 + Omega_link7_zy * t_link7_14;
  const Scalar t_link7_23 = t_link7_22 + t_link7_5 * t_link7_13;
  // link6: moment M of (3)
  const Scalar t_link6_13 = link4_k3 * t_link7_23 - link6_I11 * t_link6_4;
  const Scalar t_link6_14 = link6_I10 * (t_link6_8 - t_link6_12);
  const Scalar t_link6_15 = t_link6_13 - link6_I9 * t_link6_3 + t_link6_14;
  const Scalar t_link6_16 = t_link6_15 + link6_I2 * a_link6_x + link6_I12 * alpha_link6_z;
  const Scalar t_link6_17 = t_link6_16 + Omega_link7_xy * (link6_I5 - t_link7_17);
  const Scalar t_link6_18 = t_link6_17 + t_link7_12 * (t_link6_6 - t_link7_6);
  const Scalar t_link6_19 = t_link6_18 + t_link7_5 * t_link7_11 - Omega_link7_zy * t_link7_9;
  const Scalar M_link6_z = t_link6_19 + t_link7_4 * t_link7_13;
  B[5] = M_link6_z;
  // link7: Omega, force F of (3)
  const Scalar t_link7_24 = t_link6_6 + t_link7_6;
  const Scalar t_link7_25 = link6_I8 * t_link7_16 + t_link6_2 * t_link7_13;
  const Scalar t_link7_26 = t_link7_25 - t_link7_14 * t_link7_24;
  const Scalar t_link7_27 = t_link7_21 + link4_k3 * t_link7_26 + link6_I10 * Omega_link6_zy;
  const Scalar t_link7_28 = t_link7_27 + link6_I5 * Omega_link7_xz + link6_I13 * t_link6_2;
  // link6: moment M, force F of (3)
  const Scalar M_link6_y = t_link7_28 + link6_I9 * t_link6_11;
  const Scalar t_link6_20 = link6_I2 * t_link6_5 + link6_I5 * (t_link5_10 - t_link6_8);
  const Scalar t_link6_21 = t_link6_20 + Omega_link7_zy * t_link7_15 - link6_I9 * Omega_link6_yx;
  const Scalar t_link6_22 = t_link6_21 + link6_I14 * Omega_link6_zy + t_link7_4 * t_link7_14;
  const Scalar t_link6_23 = t_link6_22 + t_link7_17 * (t_link6_8 - t_link7_24);
  const Scalar t_link6_24 = t_link6_23 + t_link6_2 * (link6_I10 + t_link7_12);
  const Scalar M_link6_x = t_link6_24 - t_link7_5 * t_link7_9;
  const Scalar t_link6_25 = link6_I2 * Omega_link7_xz + link6_I8 * a_link7_x;
  const Scalar t_link6_26 = t_link6_25 - Omega_link7_xy * t_link7_14;
  const Scalar F_link6_x = t_link6_26 - t_link7_13 * (t_link6_7 + t_link7_6);
  // link5: moment M, Omega of (3)
  const Scalar t_link5_13 = t_link5_8 - t_link5_9;
  const Scalar t_link5_14 = t_link4_10 - t_link5_10;
  const Scalar t_link5_15 = s_joint6 * M_link6_x + link5_I10 * t_link5_6;
  const Scalar t_link5_16 = t_link5_15 + link5_I2 * t_link5_3 + link5_I4 * t_link5_12;
  const Scalar t_link5_17 = t_link5_16 - link5_I9 * (t_link5_13 - t_link5_14);
  const Scalar t_link5_18 = t_link5_17 + link5_I11 * alpha_link5_z - link5_I3 * a_link5_y;
  const Scalar M_link5_z = t_link5_18 + link5_I8 * t_link5_1 + c_joint6 * M_link6_y;
  B[4] = M_link5_z;
  const Scalar F_link6_y = t_link7_23 + link6_I2 * t_link6_8;
  const Scalar t_link6_27 = s_joint6 * F_link6_y - c_joint6 * F_link6_x;
  const Scalar t_link5_19 = link5_I3 * (t_link4_10 - t_link5_13);
  const Scalar t_link6_28 = t_link6_27 + link4_I9 * t_link5_12 - t_link5_19;
  const Scalar t_link6_29 = t_link6_28 + link5_I4 * t_link5_7;
  const Scalar t_link7_29 = t_link7_26 + link6_I2 * Omega_link6_zy;
  const Scalar Omega_link5_yx = alpha_link5_z - t_link5_6;
  const Scalar t_link5_20 = c_joint6 * M_link6_x - link5_I2 * t_link5_14;
  const Scalar t_link5_21 = t_link5_20 + link5_I8 * Omega_link5_yx + link5_I12 * Omega_link5_zy;
  const Scalar t_link5_22 = t_link5_21 + link5_I9 * Omega_link5_zx + link5_I4 * a_link5_z;
  const Scalar M_link5_x = t_link5_22 - link4_k1 * t_link7_29 - s_joint6 * M_link6_y;
  // link6: moment M of (3)
  const Scalar t_link6_30 = M_link6_z + link5_I2 * t_link5_7 + link5_I9 * Omega_link5_zy;
  const Scalar t_link6_31 = t_link6_30 + link4_k1 * t_link6_27 - link5_I3 * a_link5_z;
  const Scalar t_link6_32 = t_link6_31 + link5_I8 * t_link5_13 + link5_I13 * Omega_link5_zx;
  // link5: force F, moment M of (3)
  const Scalar t_link5_23 = link5_I4 * Omega_link5_zy + link4_I9 * a_link5_z;
  const Scalar t_link5_24 = t_link5_23 - link5_I3 * Omega_link5_zx + s_joint6 * F_link6_x;
  const Scalar F_link5_z = t_link5_24 + c_joint6 * F_link6_y;
  const Scalar t_link5_25 = F_link5_z + link4_I15 * t_link4_11 + s_joint5 * M_link5_x;
  const Scalar t_link4_15 = link4_I10 * (t_link4_10 + Omega_link4_xx);
  const Scalar t_link5_26 = t_link5_25 - link4_I11 * Omega_link4_yz - t_link4_15;
  const Scalar t_link5_27 = t_link5_26 + link4_I14 * alpha_link3_y - link4_I1 * Omega_link4_xz;
  const Scalar t_link5_28 = t_link5_27 - link4_I8 * a_link4_x - c_joint5 * t_link6_32;
  B[3] = -t_link5_28;
  const Scalar t_link5_29 = t_link7_29 - link5_I3 * Omega_link5_yx + link4_I9 * a_link5_y;
  const Scalar F_link5_y = t_link5_29 - link5_I4 * t_link5_10;
  const Scalar t_link5_30 = c_joint5 * F_link5_y - s_joint5 * t_link6_29;
  const Scalar t_link5_31 = t_link5_30 - link4_I8 * t_link4_3;
  const Scalar t_link5_32 = M_link5_z - t_link5_30 + link4_I12 * Omega_link4_zx;
  const Scalar t_link5_33 = t_link5_32 + link4_I10 * t_link4_3 - link4_I11 * t_link4_13;
  const Scalar t_link5_34 = t_link5_33 + link4_I1 * Omega_link4_xy;
  const Scalar t_link4_16 = link4_I10 * Omega_link4_zx + link4_I1 * (t_link4_10 - t_link3_14);
  const Scalar t_link4_17 = t_link4_16 + link4_I13 * t_link4_3 - link4_I11 * t_link4_14;
  const Scalar t_link5_35 = t_link4_17 + s_joint5 * t_link6_32 + c_joint5 * M_link5_x;
  const Scalar t_link5_36 = t_link5_35 - link4_I8 * t_link4_9;
  // link3: moment M of (3)
  const Scalar t_link3_15 = t_link5_31 + link3_I6 * Omega_link3_yz - link3_I7 * t_link3_13;
  const Scalar t_link3_16 = t_link3_15 + s_joint4 * t_link5_36 + c_joint4 * t_link5_34;
  const Scalar t_link3_17 = link3_I9 * (t_link3_7 - t_link3_8);
  const Scalar t_link3_18 = t_link3_16 - link3_I8 * t_link3_12 - t_link3_17;
  const Scalar M_link3_z = t_link3_18 - link3_I1 * Omega_link3_xz;
  B[2] = M_link3_z;
  const Scalar t_link2_3 = qd[1] * qd[1];
  const Scalar t_link2_4 = M_link3_z - link2_I8 * t_link2_3;
  // link4: moment M of (3)
  const Scalar t_link4_18 = link3_k1 * t_link5_31 - c_joint4 * t_link5_36;
  const Scalar t_link4_19 = t_link4_18 + link3_I1 * (t_link3_8 - t_link3_9);
  const Scalar t_link4_20 = t_link4_19 + s_joint4 * t_link5_34 + link3_I6 * Omega_link3_yx;
  const Scalar t_link4_21 = t_link4_20 - link3_I10 * Omega_link3_zy + link3_I9 * t_link3_11;
  const Scalar t_link5_37 = link4_I8 * Omega_link4_xy - s_joint5 * F_link5_y;
  const Scalar t_link3_19 = t_link5_28 - link3_I9 * Omega_link3_zy;
  const Scalar t_link5_38 = t_link5_37 - c_joint5 * t_link6_29;
  const Scalar t_link3_20 = t_link3_19 + link3_I6 * (t_link3_7 - t_link3_9);
  const Scalar t_link5_39 = F_link5_z - link4_I8 * t_link4_10;
  // link3: moment M of (3)
  const Scalar t_link3_21 = t_link3_20 - t_link5_38 * (s_joint4 - link3_k1 * c_joint4);
  const Scalar t_link3_22 = t_link3_21 - (c_joint4 + link3_k1 * s_joint4) * t_link5_39;
  const Scalar M_link3_y = t_link3_22 + link3_I1 * Omega_link3_xy + link3_I11 * t_link3_11;
  // link2: moment M of (3)
  const Scalar t_link2_5 = link2_I5 * t_link2_3 + c_joint3 * t_link4_21 + s_joint3 * M_link3_y;
  B[0] = qd[1] * t_link2_2 * 2.0 + c_joint2 * t_link2_4 + s_joint2 * t_link2_5;
  B[1] = c_joint3 * M_link3_y - (qd[0] * t_link2_2 + s_joint3 * t_link4_21);
}

void gravity_force(const Scalar q[7], Scalar G[7]) noexcept {
  const auto p_s_joint2 = sine_cosine(q[1]);
  const Scalar& s_joint2 = p_s_joint2.sine;
  const Scalar& c_joint2 = p_s_joint2.cosine;
  const auto p_s_joint3 = sine_cosine(q[2]);
  const Scalar& s_joint3 = p_s_joint3.sine;
  const Scalar& c_joint3 = p_s_joint3.cosine;
  const auto p_s_joint4 = sine_cosine(q[3]);
  const Scalar& s_joint4 = p_s_joint4.sine;
  const Scalar& c_joint4 = p_s_joint4.cosine;
  const auto p_s_joint5 = sine_cosine(q[4]);
  const Scalar& s_joint5 = p_s_joint5.sine;
  const Scalar& c_joint5 = p_s_joint5.cosine;
  // link7: first moment h, G of 6.5
  const auto p_s_joint6 = sine_cosine(q[5]);
  const Scalar& s_joint6 = p_s_joint6.sine;
  const Scalar& c_joint6 = p_s_joint6.cosine;
  const Scalar t_link7_1 = link7_k1 - q[6];
  const auto p_s_link7 = sine_cosine(t_link7_1);
  const Scalar& s_link7 = p_s_link7.sine;
  const Scalar& c_link7 = p_s_link7.cosine;
  const Scalar h_link7_x = link7_h1 * c_link7;
  const Scalar t_link7_2 = link7_h1 * s_link7;
  const Scalar t_link7_3 = base_g1 * s_joint2;
  const Scalar t_link7_4 = c_joint3 * t_link7_3;
  const Scalar t_link7_5 = base_g1 * c_joint2;
  const Scalar t_link7_6 = c_joint4 * t_link7_4 - s_joint4 * t_link7_5;
  const Scalar t_link7_7 = s_joint3 * t_link7_3;
  const Scalar t_link7_8 = s_joint5 * t_link7_7 - c_joint5 * t_link7_6;
  const Scalar t_link7_9 = s_joint4 * t_link7_4 + c_joint4 * t_link7_5;
  const Scalar t_link7_10 = c_joint5 * t_link7_7 + s_joint5 * t_link7_6;
  const Scalar t_link7_11 = t_link7_2 * (c_joint6 * t_link7_8 + s_joint6 * t_link7_9);
  G[6] = t_link7_11 - h_link7_x * t_link7_10;
  // link6: first moment h, G of 6.5
  const Scalar t_link6_1 = link6_h1 + h_link7_x;
  const Scalar h_link6_x = link6_h2 * s_joint6 + c_joint6 * t_link6_1;
  const Scalar t_link6_2 = link5_h1 - h_link6_x;
  const Scalar h_link5_y = link5_h2 + t_link7_2;
  const Scalar t_link7_12 = link6_h2 * c_joint6 - s_joint6 * t_link6_1;
  G[5] = t_link7_8 * t_link7_12 + t_link7_9 * h_link6_x;
  const Scalar h_link4_x = link4_h1 + s_joint5 * h_link5_y + c_joint5 * t_link6_2;
  const Scalar t_link5_1 = link4_h2 - t_link7_12;
  G[4] = -(t_link7_8 * h_link5_y + t_link7_10 * t_link6_2);
  G[3] = t_link7_6 * t_link5_1 - t_link7_9 * h_link4_x;
  // link3: first moment h, G of 6.5
  const Scalar h_link3_y = link3_h2 + c_joint5 * h_link5_y - s_joint5 * t_link6_2;
  const Scalar h_link3_x = link3_h1 - c_joint4 * h_link4_x - s_joint4 * t_link5_1;
  G[2] = t_link7_7 * h_link3_x + t_link7_4 * h_link3_y;
  const Scalar t_link3_1 = link2_h2 + c_joint4 * t_link5_1 - s_joint4 * h_link4_x;
  // link2: G of 6.5
  const Scalar t_link2_1 = t_link7_5 * (link2_h1 + s_joint3 * h_link3_y - c_joint3 * h_link3_x);
  G[1] = t_link2_1 - t_link7_3 * t_link3_1;
  G[0] = 0.0;
}

void inverse_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar qdd[7],
                      Scalar tau[7]) noexcept {
  const auto p_s_joint2 = sine_cosine(q[1]);
  const Scalar& s_joint2 = p_s_joint2.sine;
  const Scalar& c_joint2 = p_s_joint2.cosine;
  const auto p_s_joint3 = sine_cosine(q[2]);
  const Scalar& s_joint3 = p_s_joint3.sine;
  const Scalar& c_joint3 = p_s_joint3.cosine;
  const auto p_s_joint4 = sine_cosine(q[3]);
  const Scalar& s_joint4 = p_s_joint4.sine;
  const Scalar& c_joint4 = p_s_joint4.cosine;
  const auto p_s_joint5 = sine_cosine(q[4]);
  const Scalar& s_joint5 = p_s_joint5.sine;
  const Scalar& c_joint5 = p_s_joint5.cosine;
  const auto p_s_joint6 = sine_cosine(q[5]);
  const Scalar& s_joint6 = p_s_joint6.sine;
  const Scalar& c_joint6 = p_s_joint6.cosine;
  // link2: angular velocity omega, Omega, angular acceleration alpha of (1)
  const Scalar t_link2_1 = s_joint2 * qd[0];
  const Scalar t_link2_2 = t_link2_1 * t_link2_1;
  const Scalar t_link2_3 = qd[1] * qd[1];
  const Scalar t_link2_4 = c_joint2 * qd[0];
  const Scalar t_link2_5 = s_joint2 * qdd[0] + qd[1] * t_link2_4 * 2.0;
  const Scalar t_link2_6 = t_link2_1 * qd[1];
  const Scalar alpha_link2_y = t_link2_6 - c_joint2 * qdd[0];
  const Scalar t_link2_7 = t_link2_1 * t_link2_4;
  const Scalar Omega_link2_xy = t_link2_7 - qdd[1];
  const Scalar t_link2_8 = t_link2_2 + t_link2_3;
  // link3: angular velocity omega, Omega, angular acceleration alpha of (1)
  const Scalar omega_link3_z = t_link2_4 + qd[2];
  const Scalar Omega_link3_yz = c_joint3 * t_link2_5 + s_joint3 * Omega_link2_xy;
  const Scalar omega_link3_y = s_joint3 * t_link2_1 + c_joint3 * qd[1];
  const Scalar t_link3_1 = Omega_link3_yz - omega_link3_z * omega_link3_y * 2.0;
  const Scalar t_link3_2 = c_joint3 * t_link2_1 - s_joint3 * qd[1];
  const Scalar t_link3_3 = omega_link3_z * t_link3_2;
  const Scalar Omega_link3_xz = s_joint3 * t_link2_5 - c_joint3 * Omega_link2_xy;
  const Scalar alpha_link3_y = t_link3_3 + Omega_link3_xz;
  const Scalar t_link3_4 = t_link3_3 + alpha_link3_y;
  const Scalar t_link3_5 = t_link3_2 * t_link3_2;
  const Scalar t_link3_6 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_7 = omega_link3_y * t_link3_2;
  const Scalar t_link3_8 = alpha_link2_y - qdd[2];
  const Scalar t_link3_9 = t_link3_7 + t_link3_8;
  const Scalar t_link3_10 = t_link3_7 - t_link3_8;
  const Scalar t_link2_9 = base_g1 * s_joint2;
  const Scalar a_link3_y = s_joint3 * t_link2_9;
  const Scalar t_link3_11 = c_joint3 * t_link2_9;
  // link4: angular velocity omega, Omega, angular acceleration alpha of (1)
  const Scalar t_link4_1 = c_joint4 * omega_link3_z + s_joint4 * t_link3_2;
  const Scalar t_link4_2 = omega_link3_y - qd[3];
  const Scalar t_link4_3 = c_joint4 * t_link3_1 - s_joint4 * t_link3_10;
  const Scalar Omega_link4_zy = t_link4_3 + t_link4_1 * t_link4_2 * 2.0;
  const Scalar omega_link4_x = c_joint4 * t_link3_2 - s_joint4 * omega_link3_z;
  const Scalar t_link4_4 = t_link4_2 * omega_link4_x;
  const Scalar t_link4_5 = s_joint4 * t_link3_1 + c_joint4 * t_link3_10;
  const Scalar alpha_link4_y = t_link4_4 - t_link4_5;
  const Scalar t_link4_6 = t_link4_4 + alpha_link4_y;
  const Scalar t_link4_7 = t_link4_1 * omega_link4_x;
  const Scalar t_link4_8 = alpha_link3_y - qdd[3];
  const Scalar t_link4_9 = t_link4_7 - t_link4_8;
  const Scalar t_link4_10 = a_link3_y - link4_l1 * t_link3_9 + link3_l1 * Omega_link3_yz;
  const Scalar t_link4_11 = omega_link4_x * omega_link4_x;
  const Scalar t_link4_12 = t_link4_2 * t_link4_2;
  const Scalar t_link4_13 = t_link4_11 + t_link4_12;
  const Scalar t_link3_12 = t_link3_5 - t_link3_6;
  const Scalar t_link3_13 = t_link2_8 - t_link3_12;
  const Scalar t_link4_14 = t_link3_11 - link3_l1 * Omega_link3_xz + link4_l1 * t_link3_13;
  const Scalar t_link4_15 = base_g1 * c_joint2 - link4_l1 * t_link3_4 - link3_l1 * t_link2_8;
  const Scalar t_link4_16 = s_joint4 * t_link4_15 - c_joint4 * t_link4_14;
  const Scalar t_link3_14 = t_link3_5 + t_link3_6;
  const Scalar t_link4_17 = t_link4_11 - t_link4_12;
  // link5: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_link5_1 = t_link4_16 + link4_l1 * (t_link3_14 - t_link4_17);
  const Scalar t_link5_2 = t_link4_10 + link4_l1 * t_link4_6;
  const Scalar t_link5_3 = s_joint5 * t_link5_1 - c_joint5 * t_link5_2;
  const Scalar a_link5_x = c_joint5 * t_link5_1 + s_joint5 * t_link5_2;
  const Scalar Omega_link5_yz = s_joint5 * t_link4_9 + c_joint5 * Omega_link4_zy;
  const Scalar omega_link5_y = c_joint5 * t_link4_2 + s_joint5 * omega_link4_x;
  const Scalar omega_link5_z = t_link4_1 + qd[4];
  const Scalar t_link5_4 = Omega_link5_yz - omega_link5_y * omega_link5_z * 2.0;
  const Scalar Omega_link5_xz = s_joint5 * Omega_link4_zy - c_joint5 * t_link4_9;
  const Scalar omega_link5_x = s_joint5 * t_link4_2 - c_joint5 * omega_link4_x;
  const Scalar t_link5_5 = omega_link5_z * omega_link5_x;
  const Scalar alpha_link5_y = Omega_link5_xz - t_link5_5;
  const Scalar Omega_link5_zx = t_link5_5 - alpha_link5_y;
  const Scalar t_link4_18 = t_link4_7 + t_link4_8;
  const Scalar a_link5_z = link4_l1 * t_link4_18 + c_joint4 * t_link4_15 + s_joint4 * t_link4_14;
  const Scalar t_link5_6 = omega_link5_y * omega_link5_x;
  const Scalar t_link5_7 = alpha_link4_y - qdd[4];
  const Scalar Omega_link5_xy = t_link5_6 + t_link5_7;
  const Scalar t_link5_8 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_9 = omega_link5_z * omega_link5_z;
  const Scalar t_link5_10 = t_link5_8 + t_link5_9;
  const Scalar t_link6_1 = omega_link5_y - qd[5];
  const Scalar Omega_link6_yz = c_joint6 * t_link5_4 + s_joint6 * Omega_link5_xy;
  const Scalar t_link7_1 = 2.0 * t_link6_1;
  const Scalar t_link6_2 = s_joint6 * omega_link5_x - c_joint6 * omega_link5_z;
  const Scalar Omega_link7_yz = Omega_link6_yz - t_link7_1 * t_link6_2;
  // link6: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar Omega_link6_xz = s_joint6 * t_link5_4 - c_joint6 * Omega_link5_xy;
  const Scalar omega_link6_x = c_joint6 * omega_link5_x + s_joint6 * omega_link5_z;
  const Scalar t_link6_3 = t_link7_1 * omega_link6_x;
  const Scalar t_link6_4 = Omega_link6_xz + t_link6_3;
  const Scalar t_link6_5 = t_link6_2 * omega_link6_x;
  const Scalar t_link6_6 = alpha_link5_y - qdd[5];
  const Scalar Omega_link7_xz = t_link6_5 - t_link6_6;
  const Scalar t_link6_7 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_8 = t_link6_1 * t_link6_1;
  const Scalar t_link6_9 = t_link6_7 - t_link6_8;
  const Scalar a_link6_z = t_link5_3 - link5_l1 * Omega_link5_yz;
  // link7: acceleration a, angular velocity omega, Omega of (1)
  const Scalar a_link7_y = a_link6_z - link7_l1 * t_link6_4;
  const Scalar omega_link7_z = t_link6_2 + qd[6];
  const Scalar t_link7_2 = Omega_link7_yz + t_link7_1 * omega_link7_z;
  const Scalar Omega_link7_xy = Omega_link6_xz - qdd[6];
  const Scalar t_link7_3 = t_link6_3 + Omega_link7_xy;
  // link6: acceleration a, Omega of (1)
  const Scalar t_link6_10 = a_link5_z - link5_l1 * t_link4_13;
  const Scalar t_link6_11 = a_link5_x + link5_l1 * Omega_link5_xz;
  const Scalar a_link6_x = c_joint6 * t_link6_11 + s_joint6 * t_link6_10;
  const Scalar a_link7_x = a_link6_x - link7_l1 * (t_link5_10 - t_link6_9);
  const Scalar t_link6_12 = t_link6_5 + t_link6_6;
  // link7: acceleration a, Omega, moment M of (1)
  const Scalar a_link7_z = link7_l1 * t_link6_12 + s_joint6 * t_link6_11 - c_joint6 * t_link6_10;
  const Scalar t_link7_4 = Omega_link7_xz - omega_link6_x * omega_link7_z * 2.0;
  const Scalar t_link7_5 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_6 = link7_k1 - q[6];
  const auto p_s_link7 = sine_cosine(t_link7_6);
  const Scalar& s_link7 = p_s_link7.sine;
  const Scalar& c_link7 = p_s_link7.cosine;
  const Scalar t_link7_7 = link7_I7 * c_link7 - link7_I8 * s_link7;
  const Scalar t_link7_8 = s_link7 * t_link7_7;
  const Scalar t_link7_9 = link7_I3 * s_link7 + link7_I4 * c_link7;
  const Scalar t_link7_10 = link7_I4 * s_link7 - link7_I3 * c_link7;
  const Scalar t_link7_11 = link7_I11 - c_link7 * t_link7_7;
  const Scalar t_link7_12 = link7_h1 * c_link7;
  const Scalar t_link7_13 = link7_h1 * s_link7;
  const Scalar t_link7_14 = link7_I12 - t_link7_8;
  const Scalar t_link7_15 = link7_I10 + t_link7_8;
  const Scalar t_link7_16 = t_link6_9 * t_link7_11 - Omega_link7_yz * t_link7_9;
  const Scalar t_link7_17 = t_link7_16 - Omega_link7_xz * t_link7_10 + t_link7_3 * t_link7_14;
  const Scalar t_link7_18 = t_link7_17 - a_link7_x * t_link7_13 + Omega_link7_xy * t_link7_15;
  const Scalar t_link7_19 = t_link7_18 - a_link7_y * t_link7_12;
  tau[6] = -t_link7_19;
  const Scalar t_link7_20 = link6_m1 * a_link7_z + t_link7_2 * t_link7_13;
  const Scalar F_link7_z = t_link7_20 - t_link7_4 * t_link7_12;
  const Scalar t_link6_13 = t_link6_7 + t_link6_8;
  const Scalar t_link6_14 = t_link5_10 - t_link6_13;
  const Scalar t_link7_21 = link6_I9 * Omega_link6_yz - link6_I12 * t_link6_6;
  const Scalar t_link7_22 = t_link7_21 + link6_I11 * t_link6_5 - link7_l1 * F_link7_z;
  const Scalar t_link7_23 = t_link7_22 + link6_I10 * (t_link6_9 - t_link6_14);
  const Scalar t_link7_24 = t_link7_23 - a_link7_z * t_link7_12 + link6_h2 * a_link6_x;
  const Scalar t_link7_25 = t_link7_24 + t_link7_2 * t_link7_11 + t_link7_4 * t_link7_14;
  const Scalar t_link7_26 = t_link7_25 + t_link7_9 * (t_link6_7 - t_link7_5);
  const Scalar M_link6_z = t_link7_26 + link6_I5 * Omega_link6_xz - Omega_link7_xy * t_link7_10;
  tau[5] = M_link6_z;
  const Scalar t_link7_27 = link6_h2 * a_link6_z - link6_I5 * t_link6_14 - link6_I9 * t_link6_12;
  const Scalar t_link7_28 = t_link7_27 + a_link7_z * t_link7_13 - t_link7_3 * t_link7_9;
  const Scalar t_link7_29 = t_link7_28 + t_link7_2 * t_link7_15 - link6_I10 * t_link6_4;
  const Scalar t_link7_30 = t_link7_29 + t_link7_4 * t_link7_11 + link6_I14 * Omega_link7_yz;
  const Scalar t_link7_31 = t_link7_30 - t_link7_10 * (t_link6_8 - t_link7_5);
  const Scalar t_link7_32 = t_link7_13 * (t_link6_7 + t_link7_5) - t_link7_3 * t_link7_12;
  const Scalar F_link7_y = t_link7_32 + link6_m1 * a_link7_y;
  const Scalar t_link7_33 = t_link7_19 - link7_l1 * F_link7_y + link6_I5 * Omega_link7_xz;
  const Scalar t_link7_34 = t_link7_33 + link6_I13 * t_link6_4 - link6_I10 * Omega_link7_yz;
  const Scalar M_link6_y = t_link7_34 + link6_I9 * t_link6_9;
  const Scalar t_link5_11 = t_link5_8 - t_link5_9;
  const Scalar t_link5_12 = t_link4_13 - t_link5_10;
  // link6: moment M, force F of (1)
  const Scalar t_link6_15 = s_joint6 * t_link7_31 - c_joint6 * M_link6_y - link5_h1 * t_link5_3;
  const Scalar t_link6_16 = t_link6_15 + link5_I8 * Omega_link5_yz + link5_I11 * t_link5_7;
  const Scalar t_link6_17 = t_link6_16 + link5_I2 * Omega_link5_xz + link5_h2 * a_link5_x;
  const Scalar t_link6_18 = t_link6_17 + link5_I9 * (t_link5_11 - t_link5_12);
  const Scalar t_link6_19 = t_link6_18 + link5_I10 * t_link5_6;
  tau[4] = -t_link6_19;
  const Scalar t_link7_35 = F_link7_z - link6_h2 * t_link6_13;
  const Scalar t_link6_20 = link6_m1 * a_link7_x + link6_h2 * Omega_link7_xz;
  const Scalar t_link6_21 = t_link6_20 - Omega_link7_xy * t_link7_13;
  const Scalar F_link6_x = t_link6_21 - t_link7_12 * (t_link6_8 + t_link7_5);
  const Scalar t_link6_22 = s_joint6 * t_link7_35 + c_joint6 * F_link6_x;
  const Scalar t_link4_19 = t_link4_13 - t_link3_14;
  const Scalar t_link4_20 = t_link4_17 + t_link4_19;
  // link5: force F, Omega of (1)
  const Scalar t_link5_13 = link4_m1 * a_link5_z - c_joint6 * t_link7_35;
  const Scalar t_link5_14 = t_link5_13 - link5_h1 * Omega_link5_zx + s_joint6 * F_link6_x;
  const Scalar F_link5_z = t_link5_14 - link5_h2 * t_link5_4;
  const Scalar F_link6_z = F_link7_y + link6_h2 * Omega_link7_yz;
  const Scalar t_link5_15 = M_link6_z - link5_h1 * a_link5_z - link5_l1 * t_link6_22;
  const Scalar t_link5_16 = t_link5_15 + link5_I13 * Omega_link5_zx + link5_I8 * t_link5_11;
  const Scalar t_link6_23 = t_link5_16 - link5_I9 * t_link5_4 - link5_I2 * Omega_link5_xy;
  const Scalar Omega_link5_yx = t_link5_6 - t_link5_7;
  // link6: moment M of (1)
  const Scalar t_link6_24 = c_joint6 * t_link7_31 - link5_I9 * Omega_link5_zx;
  const Scalar t_link6_25 = t_link6_24 - link5_h2 * a_link5_z + s_joint6 * M_link6_y;
  const Scalar t_link6_26 = t_link6_25 - link5_l1 * F_link6_z + link5_I12 * t_link5_4;
  const Scalar t_link6_27 = t_link6_26 - link5_I8 * Omega_link5_yx + link5_I2 * t_link5_12;
  // link5: moment M, force F of (1)
  const Scalar t_link5_17 = link4_I1 * t_link4_5 - link4_I10 * t_link4_20;
  const Scalar t_link5_18 = t_link5_17 + link4_I14 * t_link4_8 + link4_I11 * t_link4_3;
  const Scalar t_link5_19 = t_link5_18 + link4_l1 * F_link5_z + link4_h3 * t_link4_16;
  const Scalar t_link5_20 = t_link5_19 - link4_I15 * t_link4_7 - c_joint5 * t_link6_23;
  const Scalar t_link5_21 = t_link5_20 - s_joint5 * t_link6_27;
  tau[3] = -t_link5_21;
  const Scalar t_link5_22 = t_link6_22 + link5_h1 * (t_link4_13 - t_link5_11);
  const Scalar F_link5_x = t_link5_22 + link4_m1 * a_link5_x + link5_h2 * Omega_link5_xy;
  const Scalar t_link6_28 = F_link6_z + link4_m1 * t_link5_3 + link5_h2 * t_link5_10;
  const Scalar t_link6_29 = t_link6_28 + link5_h1 * Omega_link5_yx;
  const Scalar t_link5_23 = c_joint5 * t_link6_29 - s_joint5 * F_link5_x;
  // link4: force F, moment M of (1)
  const Scalar F_link4_z = t_link5_23 - link4_h3 * Omega_link4_zy;
  const Scalar F_link4_x = link4_h3 * t_link4_9 - s_joint5 * t_link6_29 - c_joint5 * F_link5_x;
  const Scalar t_link4_21 = link4_h3 * t_link4_10 + link4_I11 * t_link4_18;
  const Scalar t_link4_22 = t_link4_21 + link4_I10 * t_link4_6 + link4_I13 * Omega_link4_zy;
  const Scalar t_link4_23 = t_link4_22 - link4_I1 * t_link4_19 - s_joint5 * t_link6_23;
  const Scalar M_link4_x = t_link4_23 + c_joint5 * t_link6_27;
  const Scalar t_link3_15 = t_link3_13 - t_link3_14;
  const Scalar t_link4_24 = t_link6_19 - link4_l1 * t_link5_23 + link4_I1 * t_link4_9;
  const Scalar t_link4_25 = t_link4_24 + link4_I10 * Omega_link4_zy + link4_I11 * t_link4_17;
  const Scalar M_link4_y = t_link4_25 + link4_I12 * t_link4_6;
  // link3: moment M of (1)
  const Scalar t_link3_16 = link3_h3 * a_link3_y + link3_h2 * t_link3_11 - link4_l1 * F_link4_z;
  const Scalar t_link3_17 = t_link3_16 - s_joint4 * M_link4_x + link3_I8 * t_link3_7;
  const Scalar t_link3_18 = t_link3_17 - link3_I1 * Omega_link3_xz - link3_I7 * t_link3_8;
  const Scalar t_link3_19 = t_link3_18 + link3_I6 * Omega_link3_yz + link3_I9 * t_link3_15;
  const Scalar M_link3_z = t_link3_19 - c_joint4 * M_link4_y;
  tau[2] = M_link3_z;
  // link2: moment M of (1)
  const Scalar t_link2_10 = link2_G2 - link2_I5 * qdd[0];
  const Scalar t_link2_11 = link2_G1 + link2_I8 * qdd[0];
  const Scalar t_link2_12 = t_link2_2 - t_link2_3;
  const Scalar t_link2_13 = t_link2_8 - qd[0] * qd[0];
  const Scalar t_link2_14 = t_link2_12 + t_link2_13;
  const Scalar t_link5_24 = F_link5_z - link4_h3 * t_link4_13;
  // link3: moment M of (1)
  const Scalar t_link3_20 = link3_G1 * c_joint2 - link3_I1 * (t_link2_8 - t_link3_14);
  const Scalar t_link3_21 = t_link3_20 + link3_l1 * F_link4_z - c_joint4 * M_link4_x;
  const Scalar t_link3_22 = t_link3_21 + s_joint4 * M_link4_y - link3_I10 * t_link3_1;
  const Scalar M_link3_x = t_link3_22 + link3_I6 * t_link3_9 - link3_I9 * t_link3_4;
  const Scalar Omega_link2_yx = t_link2_7 + qdd[1];
  const Scalar t_link4_26 = link4_l1 * (s_joint4 * F_link4_x - c_joint4 * t_link5_24);
  const Scalar t_link3_23 = t_link5_21 - link3_G2 * c_joint2 + t_link4_26;
  const Scalar t_link3_24 = t_link3_23 + link3_I9 * t_link3_1 + link3_I11 * t_link3_4;
  const Scalar t_link4_27 = link3_l1 * (c_joint4 * F_link4_x + s_joint4 * t_link5_24);
  const Scalar t_link3_25 = t_link3_24 + link3_I6 * t_link3_12 - t_link4_27;
  const Scalar M_link3_y = t_link3_25 - link3_I1 * t_link3_10;
  // link2: moment M, Omega of (1)
  const Scalar t_link2_15 = c_joint2 * t_link2_10 - s_joint2 * t_link2_11;
  const Scalar t_link2_16 = t_link2_15 - link2_I7 * t_link2_14 + s_joint3 * M_link3_x;
  const Scalar t_link2_17 = t_link2_16 - link2_I10 * Omega_link2_xy + link2_I9 * Omega_link2_yx;
  tau[1] = t_link2_17 + c_joint3 * M_link3_y;
  const Scalar t_link2_18 = t_link2_6 + alpha_link2_y;
  // link3: moment M of (1)
  const Scalar t_link3_26 = link2_I7 * t_link2_18 + link2_I5 * t_link2_13 + s_joint3 * M_link3_y;
  const Scalar t_link3_27 = t_link3_26 - link2_I8 * Omega_link2_yx - c_joint3 * M_link3_x;
  const Scalar t_link3_28 = M_link3_z - link2_I7 * t_link2_5 + link2_I8 * t_link2_12;
  const Scalar t_link3_29 = t_link3_28 - link2_I9 * t_link2_18 + link2_I5 * Omega_link2_xy;
  // link1: moment M of (1)
  const Scalar t_link1_1 = link1_I2 * qdd[0] + s_joint2 * (t_link3_27 + link2_I10 * t_link2_5);
  tau[0] = t_link1_1 + c_joint2 * t_link3_29;
}

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = 0.0825 m
// Names: vectors F_ in N m/L, a_ in L/s^2, h_ in kg m^2/L; all others are of values in SI units;
// numbered ones (t_) by what they are made of. Arguments and results are in SI units.
void forward_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar tau[7],
                      Scalar qdd[7]) noexcept {
  const auto p_s_joint2 = sine_cosine(q[1]);
  const Scalar& s_joint2 = p_s_joint2.sine;
  const Scalar& c_joint2 = p_s_joint2.cosine;
  const auto p_s_joint3 = sine_cosine(q[2]);
  const Scalar& s_joint3 = p_s_joint3.sine;
  const Scalar& c_joint3 = p_s_joint3.cosine;
  const auto p_s_joint4 = sine_cosine(q[3]);
  const Scalar& s_joint4 = p_s_joint4.sine;
  const Scalar& c_joint4 = p_s_joint4.cosine;
  const auto p_s_joint5 = sine_cosine(q[4]);
  const Scalar& s_joint5 = p_s_joint5.sine;
  const Scalar& c_joint5 = p_s_joint5.cosine;
  const auto p_s_joint6 = sine_cosine(q[5]);
  const Scalar& s_joint6 = p_s_joint6.sine;
  const Scalar& c_joint6 = p_s_joint6.cosine;
  const Scalar t_link2_1 = link2_I1 * c_joint2 - link2_I6 * s_joint2;
  const Scalar t_link2_2 = qd[0] * (link2_I7 - c_joint2 * t_link2_1);
  // link3: angular velocity omega, angular acceleration alpha, Omega of (1)
  const Scalar t_link3_1 = s_joint2 * qd[0];
  const Scalar omega_link3_y = s_joint3 * t_link3_1 + c_joint3 * qd[1];
  const Scalar t_link3_2 = c_joint2 * qd[0];
  const Scalar t_link3_3 = qd[1] * t_link3_2;
  const Scalar omega_link3_z = qd[2] + t_link3_2;
  const Scalar t_link3_4 = omega_link3_y * omega_link3_z;
  const Scalar t_link3_5 = c_joint3 * t_link3_3 - omega_link3_y * qd[2];
  const Scalar Omega_link3_yz = t_link3_4 + t_link3_5;
  const Scalar Omega_link3_zy = t_link3_4 - t_link3_5;
  const Scalar t_link3_6 = c_joint3 * t_link3_1 - s_joint3 * qd[1];
  const Scalar t_link3_7 = t_link3_6 * t_link3_6;
  const Scalar t_link3_8 = omega_link3_y * omega_link3_y;
  const Scalar t_link3_9 = t_link3_7 + t_link3_8;
  const Scalar t_link3_10 = omega_link3_z * omega_link3_z;
  const Scalar alpha_link3_y = s_joint3 * t_link3_3 + qd[2] * t_link3_6;
  const Scalar t_link3_11 = omega_link3_z * t_link3_6;
  const Scalar Omega_link3_xz = alpha_link3_y - t_link3_11;
  const Scalar t_link3_12 = alpha_link3_y + t_link3_11;
  const Scalar t_link3_13 = omega_link3_y * t_link3_6;
  const Scalar t_link3_14 = qd[1] * t_link3_1;
  const Scalar t_link3_15 = t_link3_13 - t_link3_14;
  const Scalar t_link3_16 = t_link3_13 + t_link3_14;
  const Scalar t_link3_17 = link4_p1 * s_joint2;
  const Scalar t_link3_18 = c_joint3 * t_link3_17;
  const Scalar a_link3_y = s_joint3 * t_link3_17;
  const Scalar t_link3_19 = t_link3_8 + t_link3_10;
  // link4: acceleration a, angular velocity omega, Omega of (1)
  const Scalar t_link4_1 = t_link3_18 + t_link3_19 - link3_k1 * Omega_link3_xz;
  const Scalar t_link4_2 = omega_link3_y - qd[3];
  const Scalar Omega_link4_yz = c_joint4 * Omega_link3_zy + s_joint4 * t_link3_15;
  const Scalar t_link4_3 = c_joint4 * omega_link3_z + s_joint4 * t_link3_6;
  const Scalar t_link4_4 = Omega_link4_yz - t_link4_2 * t_link4_3 * 2.0;
  const Scalar t_link4_5 = s_joint4 * omega_link3_z - c_joint4 * t_link3_6;
  const Scalar t_link4_6 = t_link4_2 * t_link4_5;
  const Scalar t_link4_7 = c_joint4 * t_link3_15 - s_joint4 * Omega_link3_zy;
  const Scalar alpha_link5_z = t_link4_6 + t_link4_7;
  const Scalar Omega_link4_zx = t_link4_6 + alpha_link5_z;
  const Scalar a_link4_z = t_link3_16 - a_link3_y - link3_k1 * Omega_link3_yz;
  const Scalar t_link4_8 = t_link4_5 * t_link4_5;
  const Scalar t_link4_9 = t_link4_2 * t_link4_2;
  const Scalar t_link4_10 = t_link4_8 + t_link4_9;
  const Scalar t_link4_11 = t_link4_3 * t_link4_5;
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_11;
  // link5: Omega, angular velocity omega, acceleration a of (1)
  const Scalar t_link5_1 = s_joint5 * Omega_link4_xy + c_joint5 * t_link4_4;
  const Scalar omega_link5_y = c_joint5 * t_link4_2 - s_joint5 * t_link4_5;
  const Scalar omega_link5_z = t_link4_3 + qd[4];
  const Scalar Omega_link5_zy = t_link5_1 + omega_link5_y * omega_link5_z * 2.0;
  const Scalar omega_link5_x = s_joint5 * t_link4_2 + c_joint5 * t_link4_5;
  const Scalar t_link5_2 = omega_link5_z * omega_link5_x;
  const Scalar t_link5_3 = s_joint5 * t_link4_4 - c_joint5 * Omega_link4_xy;
  const Scalar alpha_link6_z = t_link5_2 + t_link5_3;
  const Scalar Omega_link5_zx = t_link5_2 + alpha_link6_z;
  const Scalar t_link4_12 = t_link3_12 - link4_p1 * c_joint2 + link3_k1 * t_link3_9;
  const Scalar a_link4_x = s_joint4 * t_link4_12 + c_joint4 * t_link4_1;
  const Scalar t_link3_20 = t_link3_7 + t_link3_10;
  const Scalar t_link4_13 = t_link4_8 - t_link4_9;
  const Scalar t_link4_14 = t_link3_20 - t_link4_13;
  const Scalar t_link5_4 = a_link4_x - t_link4_14;
  const Scalar t_link5_5 = Omega_link4_zx + a_link4_z;
  const Scalar t_link5_6 = c_joint5 * t_link5_4 + s_joint5 * t_link5_5;
  const Scalar t_link5_7 = c_joint5 * t_link5_5 - s_joint5 * t_link5_4;
  const Scalar t_link4_15 = alpha_link3_y - t_link4_11;
  const Scalar a_link5_z = t_link4_15 + s_joint4 * t_link4_1 - c_joint4 * t_link4_12;
  const Scalar t_link5_8 = omega_link5_y * omega_link5_x;
  const Scalar t_link5_9 = alpha_link5_z - t_link5_8;
  const Scalar t_link5_10 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_11 = omega_link5_z * omega_link5_z;
  const Scalar Omega_link5_yx = alpha_link5_z + t_link5_8;
  const Scalar t_link5_12 = t_link5_10 + t_link5_11;
  // link6: Omega, angular velocity omega, acceleration a of (1)
  const Scalar t_link6_1 = s_joint6 * Omega_link5_zy - c_joint6 * t_link5_9;
  const Scalar omega_link6_x = c_joint6 * omega_link5_x + s_joint6 * omega_link5_z;
  const Scalar t_link6_2 = omega_link5_y - qd[5];
  const Scalar t_link6_3 = 2.0 * t_link6_2;
  const Scalar Omega_link6_zx = t_link6_1 - omega_link6_x * t_link6_3;
  const Scalar t_link6_4 = s_joint6 * t_link5_9 + c_joint6 * Omega_link5_zy;
  const Scalar t_link6_5 = s_joint6 * omega_link5_x - c_joint6 * omega_link5_z;
  const Scalar Omega_link6_zy = t_link6_4 + t_link6_3 * t_link6_5;
  const Scalar t_link6_6 = t_link5_6 + link4_k1 * t_link5_3;
  const Scalar t_link6_7 = a_link5_z - link4_k1 * t_link4_10;
  const Scalar a_link6_z = t_link5_7 + link4_k1 * t_link5_1;
  const Scalar t_link6_8 = omega_link6_x * t_link6_5;
  const Scalar Omega_link7_xz = alpha_link6_z + t_link6_8;
  const Scalar Omega_link6_yx = alpha_link6_z - t_link6_8;
  const Scalar t_link6_9 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_10 = t_link6_2 * t_link6_2;
  const Scalar t_link6_11 = t_link6_9 - t_link6_10;
  const Scalar t_link6_12 = t_link6_9 + t_link6_10;
  const Scalar omega_link7_z = t_link6_5 + qd[6];
  const Scalar Omega_link7_zy = Omega_link6_zy - t_link6_3 * omega_link7_z;
  const Scalar a_link6_y = c_joint6 * t_link6_7 + s_joint6 * t_link6_6;
  const Scalar t_link7_1 = a_link6_y + link4_k3 * Omega_link6_yx;
  const Scalar a_link6_x = s_joint6 * t_link6_7 - c_joint6 * t_link6_6;
  const Scalar t_link6_13 = t_link5_12 - t_link6_11;
  // link7: acceleration a, Omega, inertia I of (1)
  const Scalar a_link7_x = a_link6_x - link4_k3 * t_link6_13;
  const Scalar t_link7_2 = Omega_link7_xz - omega_link6_x * omega_link7_z * 2.0;
  const Scalar t_link7_3 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_4 = link7_k1 - q[6];
  const auto p_s_link7 = sine_cosine(t_link7_4);
  const Scalar& s_link7 = p_s_link7.sine;
  const Scalar& c_link7 = p_s_link7.cosine;
  const Scalar t_link7_5 = link7_I7 * c_link7 - link7_I8 * s_link7;
  const Scalar t_link7_6 = c_link7 * t_link7_5;
  const Scalar t_link7_7 = link7_I11 - t_link7_6;
  const Scalar I_link7_yz = link7_I4 * s_link7 - link7_I3 * c_link7;
  const Scalar t_link7_8 = s_link7 * t_link7_5;
  const Scalar t_link7_9 = link7_I3 * s_link7 + link7_I4 * c_link7;
  const Scalar h_link7_x = link7_I6 * c_link7;
  const Scalar t_link7_10 = link7_I6 * s_link7;
  const Scalar t_link7_11 = t_link6_9 + t_link7_3;
  const Scalar h_link6_x = link6_I3 + h_link7_x;
  const Scalar t_link7_12 = link6_I8 * a_link6_z + Omega_link6_zx * h_link6_x;
  const Scalar F_link7_y = t_link7_12 + t_link7_10 * t_link7_11;
  const Scalar I_link6_yz = link6_I5 - I_link7_yz;
  const Scalar t_link7_13 = link7_I1 * c_link7;
  const Scalar I_link6_xy = link6_I10 + t_link7_9;
  const Scalar I_link7_xx = link7_I10 + t_link7_8;
  const Scalar t_link7_14 = link6_I2 * a_link6_z + link6_I9 * Omega_link6_yx;
  const Scalar t_link7_15 = t_link7_14 + Omega_link6_zx * I_link6_xy;
  const Scalar t_link7_16 = t_link7_15 - link6_I5 * (t_link5_12 - t_link6_12);
  const Scalar t_link7_17 = t_link7_16 - link6_I14 * Omega_link6_zy;
  const Scalar t_link7_18 = t_link7_17 - Omega_link7_zy * I_link7_xx;
  const Scalar t_link7_19 = t_link7_18 - t_link7_1 * t_link7_10;
  const Scalar t_link7_20 = t_link7_19 + t_link7_2 * t_link7_7;
  const Scalar t_link7_21 = t_link7_20 - I_link7_yz * (t_link6_12 - t_link7_11);
  const Scalar t_link7_22 = link6_I8 * t_link7_1 + t_link7_2 * h_link7_x;
  const Scalar t_link7_23 = t_link7_22 + Omega_link7_zy * t_link7_10;
  const Scalar F_link6_y = t_link7_23 + link6_I2 * t_link6_12;
  const Scalar I_link7_yy = link7_I12 - t_link7_8;
  const Scalar t_link7_24 = a_link6_z * h_link7_x + a_link7_x * t_link7_10;
  const Scalar t_link7_25 = Omega_link6_zx * (t_link7_13 + I_link7_yy);
  const Scalar t_link7_26 = t_link7_24 - t_link6_11 * t_link7_7 + t_link7_25;
  const Scalar t_link7_27 = t_link7_26 - Omega_link6_zy * t_link7_9;
  const Scalar M_link7_z = t_link7_27 + Omega_link7_xz * I_link7_yz + t_link6_1 * I_link7_xx;
  const Scalar t_link7_28 = M_link7_z + link4_k3 * F_link7_y - link6_I10 * Omega_link6_zy;
  const Scalar t_link7_29 = t_link7_28 + link6_I13 * Omega_link6_zx - link6_I9 * t_link6_11;
  const Scalar t_link7_30 = t_link7_29 - link6_I5 * Omega_link7_xz;
  // link6: force F, moment M of (1)
  const Scalar F_link6_z = F_link7_y - link6_I2 * Omega_link6_zy;
  const Scalar t_link6_14 = F_link6_z + link5_I3 * Omega_link5_yx + link4_I9 * t_link5_7;
  const Scalar t_link6_15 = t_link6_14 + link5_I4 * t_link5_12;
  const Scalar t_link6_16 = t_link6_1 * t_link7_10 + link6_I2 * Omega_link7_xz;
  const Scalar t_link6_17 = t_link6_16 - h_link7_x * (t_link6_10 + t_link7_3);
  const Scalar F_link6_x = t_link6_17 + link6_I8 * a_link7_x;
  const Scalar t_link6_18 = s_joint6 * F_link6_y - c_joint6 * F_link6_x;
  const Scalar t_link5_13 = t_link5_10 - t_link5_11;
  const Scalar t_link6_19 = link6_I11 * t_link6_8 + link6_I2 * a_link6_x;
  const Scalar t_link6_20 = t_link6_19 - link6_I9 * t_link6_4 + link4_k3 * t_link7_23;
  const Scalar t_link6_21 = t_link6_20 + link6_I10 * (t_link6_12 - t_link6_13);
  const Scalar t_link6_22 = t_link6_21 + t_link7_1 * h_link7_x + link6_I12 * alpha_link6_z;
  const Scalar t_link6_23 = t_link6_22 - Omega_link7_zy * t_link7_7;
  const Scalar t_link7_31 = t_link7_9 * (t_link6_9 - t_link7_3);
  const Scalar t_link6_24 = t_link6_23 + t_link7_2 * I_link7_yy + t_link7_31;
  const Scalar M_link6_z = t_link6_24 - t_link6_1 * I_link6_yz;
  const Scalar t_link6_25 = M_link6_z + link4_k1 * t_link6_18 - link5_I3 * a_link5_z;
  const Scalar t_link6_26 = t_link6_25 + link5_I8 * t_link5_13 + link5_I9 * Omega_link5_zy;
  const Scalar t_link6_27 = t_link6_26 + link5_I13 * Omega_link5_zx + link5_I2 * t_link5_9;
  const Scalar t_link6_28 = c_joint6 * t_link7_21 - link5_I8 * Omega_link5_yx;
  const Scalar t_link6_29 = t_link6_28 + link5_I2 * (t_link4_10 - t_link5_12);
  const Scalar t_link6_30 = t_link6_29 - s_joint6 * t_link7_30 - link5_I12 * Omega_link5_zy;
  const Scalar t_link6_31 = t_link6_30 - link5_I4 * a_link5_z - link4_k1 * F_link6_z;
  const Scalar t_link6_32 = t_link6_31 - link5_I9 * Omega_link5_zx;
  const Scalar t_link5_14 = t_link4_10 - t_link5_13;
  const Scalar t_link6_33 = t_link6_18 - link5_I3 * t_link5_14 + link4_I9 * t_link5_6;
  const Scalar t_link6_34 = t_link6_33 + link5_I4 * t_link5_9;
  const Scalar t_link5_15 = c_joint5 * t_link6_15 + s_joint5 * t_link6_34;
  const Scalar t_link6_35 = s_joint6 * t_link7_21 - link5_I2 * t_link5_3;
  const Scalar t_link6_36 = t_link6_35 - link5_I4 * t_link5_6 - link5_I8 * t_link5_1;
  const Scalar t_link5_16 = link5_I9 * (t_link5_12 - t_link5_14);
  const Scalar t_link6_37 = t_link6_36 - link5_I12 * t_link5_9 + t_link5_16;
  const Scalar t_link6_38 = t_link6_37 - link5_I3 * t_link5_7 - link5_I13 * Omega_link5_yx;
  const Scalar t_link6_39 = t_link6_38 + c_joint6 * t_link7_30;
  // link5: moment M, force F of (1)
  const Scalar t_link5_17 = t_link5_15 - t_link6_39 + link4_I1 * Omega_link4_xy;
  const Scalar t_link5_18 = t_link5_17 + link4_I12 * Omega_link4_zx + link4_I10 * t_link4_4;
  const Scalar t_link5_19 = t_link5_18 - link4_I11 * t_link4_13;
  const Scalar t_link5_20 = s_joint5 * t_link6_15 + link4_I8 * Omega_link4_xy;
  const Scalar t_link5_21 = t_link5_20 - c_joint5 * t_link6_34;
  const Scalar t_link5_22 = link4_I9 * a_link5_z + c_joint6 * F_link6_y;
  const Scalar t_link5_23 = t_link5_22 + link5_I4 * Omega_link5_zy - link5_I3 * Omega_link5_zx;
  const Scalar F_link5_z = t_link5_23 + s_joint6 * F_link6_x;
  const Scalar t_link5_24 = F_link5_z - link4_I8 * t_link4_10;
  // link4: force F of (1)
  const Scalar F_link4_z = t_link5_15 + link4_I8 * t_link4_4;
  const Scalar t_link4_16 = link4_I1 * (t_link4_10 - t_link3_20) + link4_I8 * a_link4_z;
  const Scalar t_link4_17 = t_link4_16 - link4_I11 * t_link4_15 + link4_I10 * Omega_link4_zx;
  const Scalar t_link5_25 = t_link4_17 + link4_I13 * t_link4_4 + s_joint5 * t_link6_27;
  const Scalar t_link5_26 = t_link5_25 - c_joint5 * t_link6_32;
  const Scalar t_link1_1 = M_link7_z - tau[6];
  const Scalar t_link7_32 = link7_I9 * c_link7;
  // link6: first moment h, inertia I of (1)
  const Scalar t_link6_40 = link6_I2 * s_joint6 + c_joint6 * h_link6_x;
  const Scalar t_link6_41 = link5_I3 - t_link6_40;
  const Scalar t_link6_42 = link6_I2 * c_joint6 - s_joint6 * h_link6_x;
  const Scalar h_link5_y = link5_I4 + t_link7_10;
  const Scalar t_link6_43 = link6_I4 - t_link7_6 - link7_I1 * s_link7;
  const Scalar t_link6_44 = t_link7_8 - t_link7_32;
  const Scalar t_link6_45 = c_joint6 * I_link6_xy * 2.0 - s_joint6 * (link6_I6 - t_link6_44);
  const Scalar t_link6_46 = s_joint6 * t_link6_45;
  const Scalar t_link6_47 = s_joint6 * I_link6_yz + c_joint6 * t_link6_43;
  const Scalar t_link6_48 = link4_k2 * t_link6_42;
  const Scalar t_link5_27 = c_joint5 * t_link6_41 + s_joint5 * h_link5_y;
  const Scalar h_link4_x = link4_I4 + t_link5_27;
  const Scalar h_link4_z = s_joint5 * t_link6_41 - c_joint5 * h_link5_y;
  const Scalar t_link5_28 = link4_I3 - t_link6_42;
  const Scalar t_link6_49 = c_joint6 * I_link6_yz - s_joint6 * t_link6_43;
  // link5: inertia I of (1)
  const Scalar t_link5_29 = link5_I2 + t_link6_49 + link7_I5 * s_link7;
  const Scalar t_link5_30 = t_link7_8 - t_link6_46;
  const Scalar t_link5_31 = s_joint5 * (t_link5_30 - (link5_I7 - t_link6_44));
  const Scalar t_link5_32 = t_link5_31 - c_joint5 * (link5_I1 - 2.0 * t_link6_47);
  const Scalar t_link5_33 = s_joint5 * t_link5_32;
  const Scalar t_link5_34 = link5_I5 + t_link7_9 + link4_k1 * t_link6_40;
  const Scalar t_link5_35 = t_link5_34 - c_joint6 * t_link6_45;
  const Scalar t_link5_36 = c_joint5 * t_link5_29 + s_joint5 * t_link5_35;
  const Scalar t_link5_37 = s_joint5 * t_link5_29 - c_joint5 * t_link5_35;
  const Scalar t_link5_38 = 2.0 * t_link5_27;
  // link4: inertia I of (1)
  const Scalar t_link4_18 = c_joint4 * t_link5_28 - s_joint4 * h_link4_x;
  const Scalar t_link4_19 = c_joint4 * h_link4_x + s_joint4 * t_link5_28;
  const Scalar t_link4_20 = link4_I2 + t_link6_47 + h_link4_z - c_joint5 * t_link5_32;
  const Scalar I_link4_yz = link4_I1 - t_link5_36;
  const Scalar t_link4_21 = t_link6_42 - t_link5_37;
  const Scalar t_link4_22 = t_link6_48 - t_link5_30 + t_link5_33;
  const Scalar I_link5_zz = link5_I6 + t_link7_32 + t_link6_46;
  const Scalar t_link4_23 = t_link5_38 + I_link5_zz;
  const Scalar t_link4_24 = s_joint4 * (t_link4_23 - (link4_I16 - t_link4_22));
  const Scalar t_link4_25 = c_joint4 * (link4_I5 - 2.0 * t_link4_21) - t_link4_24;
  const Scalar t_link4_26 = s_joint4 * t_link4_25;
  const Scalar t_link4_27 = s_joint4 * I_link4_yz + c_joint4 * t_link4_20;
  const Scalar t_link4_28 = c_joint4 * I_link4_yz - s_joint4 * t_link4_20;
  const Scalar t_link4_29 = link3_k2 * t_link4_18;
  const Scalar t_link4_30 = 2.0 * t_link4_19;
  // link3: inertia I of (1)
  const Scalar t_link3_21 = t_link4_21 - (link3_I3 + t_link4_18) + link3_k1 * t_link4_19;
  const Scalar I_link3_xz = t_link3_21 + c_joint4 * t_link4_25;
  const Scalar t_link3_22 = h_link4_z - t_link4_27;
  const Scalar t_link3_23 = t_link4_22 + t_link4_26;
  const Scalar t_link3_24 = t_link5_33 - (t_link6_44 + t_link6_48) + t_link5_38;
  const Scalar t_link3_25 = t_link4_30 - t_link3_24;
  const Scalar t_link3_26 = s_joint3 * (t_link3_25 - (link3_I12 + t_link3_23));
  const Scalar t_link3_27 = c_joint3 * (link3_I2 - 2.0 * t_link3_22) - t_link3_26;
  const Scalar t_link3_28 = s_joint3 * t_link3_27;
  const Scalar t_link7_33 = link7_I2 + t_link7_13;
  // link6
  const Scalar t_link6_50 = link7_I5 * c_link7 - c_joint6 * t_link7_9;
  const Scalar t_link6_51 = t_link6_50 + s_joint6 * t_link7_33;
  const Scalar t_link6_52 = c_joint6 * t_link7_10;
  const Scalar t_link6_53 = I_link7_yz - link4_k1 * t_link6_52;
  const Scalar t_link6_54 = c_joint6 * t_link7_33 + s_joint6 * t_link7_9;
  const Scalar t_link6_55 = s_joint6 * t_link7_10;
  // link5
  const Scalar t_link5_39 = t_link6_55 - c_joint5 * t_link6_53 + s_joint5 * t_link6_51;
  const Scalar t_link5_40 = c_joint5 * t_link6_51 + s_joint5 * t_link6_53;
  const Scalar t_link5_41 = s_joint5 * t_link6_52 - c_joint5 * h_link7_x;
  const Scalar t_link5_42 = t_link6_54 + t_link5_41;
  const Scalar t_link4_31 = t_link5_41 + s_joint4 * t_link5_40 - c_joint4 * t_link5_42;
  const Scalar t_link5_43 = c_joint5 * t_link6_52 + s_joint5 * h_link7_x;
  // link4
  const Scalar t_link4_32 = link3_k1 * t_link5_41 - s_joint4 * t_link5_42;
  const Scalar t_link4_33 = t_link4_32 - c_joint4 * t_link5_40;
  const Scalar t_link4_34 = t_link5_39 - s_joint4 * (t_link5_43 + link3_k1 * t_link6_55);
  const Scalar t_link4_35 = t_link4_34 - c_joint4 * (t_link6_55 - link3_k1 * t_link5_43);
  // link3
  const Scalar t_link3_29 = s_joint2 * (c_joint3 * t_link4_33 + s_joint3 * t_link4_35);
  const Scalar t_link3_30 = t_link3_29 + c_joint2 * t_link4_31;
  const Scalar t_link3_31 = s_joint3 * t_link4_33 - c_joint3 * t_link4_35;
  const Scalar I_link6_zz = link6_I7 - t_link6_44;
  const Scalar t_link6_56 = I_link6_zz - link4_k1 * t_link6_42;
  // link5
  const Scalar t_link5_44 = s_joint5 * t_link6_56 - c_joint5 * t_link6_47;
  const Scalar t_link5_45 = s_joint5 * t_link6_42;
  const Scalar t_link5_46 = t_link6_49 - t_link5_45;
  const Scalar t_link4_36 = link3_k1 * t_link5_45 - c_joint4 * t_link5_44;
  const Scalar t_link4_37 = t_link4_36 + s_joint4 * t_link5_46;
  const Scalar t_link5_47 = t_link6_40 - c_joint5 * t_link6_56 - s_joint5 * t_link6_47;
  // link4: inertia I of (1)
  const Scalar t_link4_38 = s_joint4 - link3_k1 * c_joint4;
  const Scalar t_link4_39 = t_link5_47 - t_link6_40 * (c_joint4 + link3_k1 * s_joint4);
  const Scalar t_link4_40 = t_link4_39 - c_joint5 * t_link6_42 * t_link4_38;
  const Scalar t_link5_48 = t_link5_27 + I_link5_zz;
  const Scalar t_link4_41 = s_joint4 * t_link5_48 - link3_k1 * t_link5_27;
  const Scalar t_link4_42 = t_link4_41 - c_joint4 * t_link5_37;
  const Scalar t_link4_43 = t_link5_36 + h_link4_z * t_link4_38;
  const Scalar I_link4_zz = link4_I17 + t_link3_24;
  const Scalar t_link4_44 = t_link4_19 - I_link4_zz - link3_k1 * t_link4_18;
  // link7
  const Scalar t_link7_34 = link7_p1 * t_link3_31;
  const Scalar t_link7_35 = link7_p1 * t_link4_31;
  const Scalar t_link7_36 = link7_p1 * t_link6_54;
  const Scalar t_link7_37 = link7_p1 * I_link7_yz;
  const Scalar t_link4_45 = t_link5_45 + s_joint4 * t_link5_44 + c_joint4 * t_link5_46;
  const Scalar t_link3_32 = s_joint2 * (c_joint3 * t_link4_37 + s_joint3 * t_link4_40);
  const Scalar t_link7_38 = t_link3_30 * t_link7_37 - c_joint2 * t_link4_45 - t_link3_32;
  const Scalar t_link7_39 = link7_p1 * t_link3_30;
  const Scalar t_link7_40 = I_link7_yz * t_link7_34 + c_joint3 * t_link4_40;
  const Scalar t_link7_41 = t_link7_40 - s_joint3 * t_link4_37;
  const Scalar t_link7_42 = t_link4_45 - t_link4_31 * t_link7_37;
  const Scalar t_link7_43 = link7_p1 * t_link5_39;
  const Scalar t_link7_44 = t_link5_47 - I_link7_yz * t_link7_43;
  const Scalar t_link7_45 = t_link6_49 + I_link7_yz * t_link7_36;
  // link6: 1/pivot of (1)
  const Scalar inverse_pivot_link6 = 1.0 / (I_link6_zz - I_link7_yz * t_link7_37);
  const Scalar t_link6_57 = t_link7_41 * inverse_pivot_link6;
  const Scalar t_link6_58 = t_link7_42 * inverse_pivot_link6;
  const Scalar t_link6_59 = t_link7_38 * inverse_pivot_link6;
  const Scalar t_link4_46 = t_link5_27 - s_joint4 * t_link5_37 - c_joint4 * t_link5_48;
  const Scalar t_link6_60 = t_link7_45 * inverse_pivot_link6;
  const Scalar t_link6_61 = c_joint2 * t_link4_46 - t_link6_54 * t_link7_39;
  const Scalar t_link3_33 = s_joint2 * (c_joint3 * t_link4_42 - s_joint3 * t_link4_43);
  const Scalar t_link6_62 = t_link6_61 - t_link7_45 * t_link6_59 - t_link3_33;
  const Scalar t_link3_34 = s_joint3 * t_link4_42 + c_joint3 * t_link4_43;
  const Scalar t_link7_46 = t_link3_34 + t_link6_54 * t_link7_34;
  const Scalar t_link6_63 = t_link7_46 + t_link7_41 * t_link6_60;
  const Scalar t_link7_47 = t_link4_46 - t_link4_31 * t_link7_36;
  const Scalar t_link6_64 = t_link7_47 + t_link7_45 * t_link6_58;
  const Scalar t_link6_65 = t_link7_44 * inverse_pivot_link6;
  const Scalar t_link6_66 = t_link5_36 + t_link7_45 * t_link6_65;
  const Scalar t_link6_67 = t_link6_66 - t_link6_54 * t_link7_43;
  const Scalar t_link7_48 = I_link5_zz - t_link6_54 * t_link7_36;
  // link5: 1/pivot of (1)
  const Scalar inverse_pivot_link5 = 1.0 / (t_link7_48 - t_link7_45 * t_link6_60);
  const Scalar t_link5_49 = t_link6_63 * inverse_pivot_link5;
  const Scalar t_link5_50 = t_link6_64 * inverse_pivot_link5;
  const Scalar t_link5_51 = t_link6_67 * inverse_pivot_link5;
  const Scalar t_link3_35 = s_joint2 * (s_joint3 * t_link4_44 - c_joint3 * t_link4_27);
  const Scalar t_link7_49 = t_link3_35 + t_link3_30 * t_link7_43 - c_joint2 * t_link4_28;
  const Scalar t_link6_68 = t_link7_49 - t_link7_38 * t_link6_65;
  const Scalar t_link5_52 = t_link6_68 + t_link6_62 * t_link5_51;
  const Scalar t_link5_53 = t_link7_44 * t_link6_57 + s_joint3 * t_link4_27;
  const Scalar t_link5_54 = t_link5_53 + t_link6_63 * t_link5_51;
  const Scalar t_link5_55 = t_link5_54 - t_link3_31 * t_link7_43 + c_joint3 * t_link4_44;
  const Scalar t_link6_69 = t_link4_28 - t_link7_42 * t_link6_65;
  const Scalar t_link6_70 = t_link6_69 - t_link4_31 * t_link7_43;
  const Scalar t_link5_56 = t_link6_70 - t_link6_64 * t_link5_51;
  const Scalar t_link7_50 = I_link4_zz - t_link5_39 * t_link7_43;
  const Scalar t_link6_71 = t_link7_50 - t_link7_44 * t_link6_65;
  const Scalar inverse_pivot_link4 = 1.0 / (t_link6_71 - t_link6_67 * t_link5_51);
  // link3: inertia I of (1)
  const Scalar t_link3_36 = t_link4_30 - (t_link4_23 + t_link4_26);
  const Scalar I_link3_zz = link3_I15 - t_link3_36;
  const Scalar t_link3_37 = link3_I1 - t_link4_28 - link3_k1 * h_link4_z;
  const Scalar t_link3_38 = s_joint2 * (s_joint3 * t_link3_37 + c_joint3 * I_link3_xz);
  // link4
  const Scalar t_link4_47 = t_link5_56 * inverse_pivot_link4;
  const Scalar t_link4_48 = t_link3_38 - c_joint2 * I_link3_zz + t_link6_62 * t_link5_50;
  const Scalar t_link4_49 = t_link4_48 + t_link4_31 * t_link7_39;
  const Scalar t_link4_50 = t_link4_49 - t_link5_52 * t_link4_47;
  const Scalar t_link4_51 = t_link4_50 - t_link7_38 * t_link6_58;
  const Scalar t_link3_39 = s_joint3 * I_link3_xz - c_joint3 * t_link3_37;
  const Scalar t_link4_52 = t_link5_55 * inverse_pivot_link4;
  const Scalar t_link7_51 = t_link3_39 + t_link3_31 * t_link7_35;
  const Scalar t_link6_72 = t_link7_51 - t_link7_42 * t_link6_57;
  const Scalar t_link5_57 = t_link6_72 - t_link6_63 * t_link5_50;
  const Scalar t_link4_53 = t_link5_57 + t_link5_55 * t_link4_47;
  const Scalar t_link4_54 = I_link3_zz - t_link7_42 * t_link6_58;
  const Scalar t_link4_55 = t_link4_54 - t_link5_56 * t_link4_47;
  const Scalar t_link4_56 = t_link4_55 - t_link4_31 * t_link7_35;
  // link3: 1/pivot of (1)
  const Scalar inverse_pivot_link3 = 1.0 / (t_link4_56 - t_link6_64 * t_link5_50);
  const Scalar t_link3_40 = t_link4_53 * inverse_pivot_link3;
  const Scalar t_link3_41 = t_link4_51 * inverse_pivot_link3;
  // link4
  const Scalar t_link4_57 = c_joint2 * (link2_I5 - t_link3_39) + t_link5_52 * t_link4_52;
  const Scalar t_link4_58 = s_joint2 * (link2_I4 - t_link3_22 - c_joint3 * t_link3_27);
  const Scalar t_link4_59 = t_link4_57 + t_link4_58 + t_link6_62 * t_link5_49;
  const Scalar t_link4_60 = t_link4_59 - t_link7_41 * t_link6_59;
  const Scalar t_link4_61 = t_link4_60 - t_link3_31 * t_link7_39;
  const Scalar t_link3_42 = t_link4_61 - t_link4_53 * t_link3_41;
  const Scalar t_link2_3 = t_link3_25 - (link2_I11 + t_link4_29) + t_link3_28;
  const Scalar t_link7_52 = t_link2_3 + t_link3_31 * t_link7_34;
  const Scalar t_link6_73 = t_link7_52 + t_link7_41 * t_link6_57;
  const Scalar t_link4_62 = t_link6_73 + t_link5_55 * t_link4_52;
  const Scalar t_link4_63 = t_link4_62 + t_link6_63 * t_link5_49;
  const Scalar t_link2_4 = 1.0 / (t_link4_63 + t_link4_53 * t_link3_40);
  const Scalar t_link4_64 = t_link5_52 * inverse_pivot_link4;
  const Scalar t_link2_5 = t_link3_42 * t_link2_4;
  const Scalar t_link3_43 = t_link3_28 - (t_link3_23 - (link3_I16 + t_link4_29));
  const Scalar t_link5_58 = t_link6_62 * inverse_pivot_link5;
  // link2
  const Scalar t_link2_6 = link1_I3 - t_link3_36 - c_joint2 * t_link3_38 * 2.0;
  const Scalar t_link2_7 = t_link2_6 - t_link7_38 * t_link6_59;
  const Scalar t_link2_8 = t_link2_7 - t_link4_51 * t_link3_41;
  const Scalar t_link2_9 = t_link2_8 + t_link3_42 * t_link2_5;
  const Scalar t_link2_10 = s_joint2 * (t_link2_1 - s_joint2 * (t_link3_36 + t_link3_43));
  const Scalar t_link2_11 = t_link2_9 - t_link5_52 * t_link4_64 - t_link2_10;
  const Scalar t_link2_12 = t_link2_11 - t_link3_30 * t_link7_39;
  // link1: 1/pivot, qdd of (1)
  const Scalar inverse_pivot_link1 = 1.0 / (t_link2_12 - t_link6_62 * t_link5_58);
  const Scalar t_link1_2 = M_link6_z - tau[5] - t_link1_1 * t_link7_37;
  const Scalar t_link1_3 = t_link6_39 + tau[4] - t_link1_1 * t_link7_36;
  const Scalar t_link1_4 = t_link1_3 + t_link6_60 * t_link1_2;
  // link5: moment M of (1)
  const Scalar t_link5_59 = F_link5_z + link4_I15 * t_link4_11 - link4_I8 * a_link4_x;
  const Scalar t_link5_60 = t_link5_59 - link4_I11 * Omega_link4_yz;
  const Scalar t_link5_61 = t_link5_60 - link4_I10 * (t_link4_10 - t_link4_14);
  const Scalar t_link5_62 = t_link5_61 + link4_I14 * alpha_link3_y + link4_I1 * t_link4_7;
  const Scalar t_link5_63 = t_link5_62 - s_joint5 * t_link6_32 - c_joint5 * t_link6_27;
  // link1: qdd of (1)
  const Scalar t_link1_5 = tau[3] + t_link5_63 - t_link1_1 * t_link7_43;
  const Scalar t_link1_6 = t_link1_5 - t_link6_65 * t_link1_2;
  const Scalar t_link1_7 = t_link1_6 - t_link5_51 * t_link1_4;
  // link3: moment M of (1)
  const Scalar t_link3_44 = t_link3_19 - t_link3_20;
  const Scalar t_link3_45 = t_link3_9 - t_link3_20;
  const Scalar t_link3_46 = t_link5_63 - link3_G2 * c_joint2 + link3_I11 * t_link3_12;
  const Scalar t_link3_47 = t_link3_46 + link3_I6 * (t_link3_9 - t_link3_19);
  const Scalar t_link3_48 = t_link3_47 - c_joint4 * (t_link5_24 - link3_k1 * t_link5_21);
  const Scalar t_link3_49 = t_link3_48 - s_joint4 * (t_link5_21 + link3_k1 * t_link5_24);
  const Scalar M_link3_y = t_link3_49 - link3_I9 * Omega_link3_zy - link3_I1 * t_link3_15;
  // link4: moment M of (1)
  const Scalar t_link4_65 = F_link4_z - link3_I13 * a_link3_y - link3_I14 * t_link3_18;
  const Scalar t_link4_66 = t_link4_65 - link3_I10 * t_link3_15 + link3_I1 * Omega_link3_xz;
  const Scalar t_link4_67 = t_link4_66 - link3_I9 * t_link3_44 + link3_I11 * t_link3_16;
  const Scalar t_link4_68 = t_link4_67 - s_joint4 * t_link5_26 - link3_I6 * Omega_link3_yz;
  const Scalar t_link4_69 = t_link4_68 - c_joint4 * t_link5_19;
  // link1: qdd of (1)
  const Scalar t_link1_8 = tau[2] + t_link4_69 + t_link6_58 * t_link1_2;
  const Scalar t_link1_9 = t_link1_8 + t_link4_47 * t_link1_7;
  const Scalar t_link1_10 = t_link1_9 + t_link5_50 * t_link1_4;
  const Scalar t_link1_11 = t_link1_10 + t_link1_1 * t_link7_35;
  // link3: moment M of (1)
  const Scalar t_link3_50 = link3_G1 * c_joint2 + link3_k1 * F_link4_z;
  const Scalar t_link3_51 = t_link3_50 + link3_I10 * Omega_link3_zy + c_joint4 * t_link5_26;
  const Scalar t_link3_52 = t_link3_51 - link3_I1 * t_link3_45 + link3_I6 * t_link3_16;
  const Scalar M_link3_x = t_link3_52 - s_joint4 * t_link5_19 - link3_I9 * t_link3_12;
  // link1: qdd of (1)
  const Scalar t_link1_12 = inverse_pivot_link5 * t_link1_4;
  const Scalar t_link1_13 = tau[1] + link2_G1 * s_joint2 - link2_G2 * c_joint2;
  const Scalar t_link1_14 = t_link1_13 + qd[0] * t_link2_2 - s_joint3 * M_link3_x;
  const Scalar t_link1_15 = t_link1_14 - t_link3_40 * t_link1_11;
  const Scalar t_link1_16 = t_link1_15 + t_link6_63 * t_link1_12 - c_joint3 * M_link3_y;
  const Scalar t_link1_17 = t_link1_16 - t_link4_52 * t_link1_7;
  const Scalar t_link1_18 = t_link1_17 + t_link6_57 * t_link1_2;
  const Scalar t_link1_19 = t_link1_18 - t_link1_1 * t_link7_34;
  const Scalar t_link2_13 = qd[1] * qd[1];
  const Scalar t_link1_20 = link2_I5 * t_link2_13 - c_joint3 * M_link3_x + s_joint3 * M_link3_y;
  const Scalar t_link1_21 = tau[0] - qd[1] * t_link2_2 * 2.0 - t_link2_5 * t_link1_19;
  const Scalar t_link1_22 = t_link1_21 - s_joint2 * t_link1_20 + t_link1_1 * t_link7_39;
  const Scalar t_link1_23 = t_link1_22 - t_link4_64 * t_link1_7;
  const Scalar t_link1_24 = c_joint2 * (t_link4_69 + link2_I8 * t_link2_13);
  const Scalar t_link1_25 = t_link1_23 + t_link3_41 * t_link1_11 + t_link1_24;
  const Scalar t_link1_26 = t_link1_25 + t_link5_58 * t_link1_4;
  const Scalar t_link1_27 = inverse_pivot_link1 * (t_link1_26 - t_link6_59 * t_link1_2);
  qdd[0] = t_link1_27;
  const Scalar t_link1_28 = t_link2_4 * (t_link1_19 + t_link3_42 * t_link1_27);
  qdd[1] = -t_link1_28;
  const Scalar t_link1_29 = t_link1_11 + t_link4_53 * t_link1_28;
  const Scalar t_link1_30 = inverse_pivot_link3 * (t_link1_29 + t_link4_51 * t_link1_27);
  qdd[2] = t_link1_30;
  const Scalar t_link1_31 = t_link1_7 + t_link5_56 * t_link1_30;
  const Scalar t_link1_32 = t_link1_31 + t_link5_55 * t_link1_28;
  const Scalar t_link1_33 = inverse_pivot_link4 * (t_link1_32 - t_link5_52 * t_link1_27);
  qdd[3] = t_link1_33;
  const Scalar t_link1_34 = t_link1_12 + t_link5_50 * t_link1_30;
  const Scalar t_link1_35 = t_link1_34 - t_link5_51 * t_link1_33;
  const Scalar t_link1_36 = t_link1_35 - t_link5_49 * t_link1_28;
  const Scalar t_link1_37 = t_link1_36 + t_link5_58 * t_link1_27;
  qdd[4] = t_link1_37;
  const Scalar t_link1_38 = t_link1_2 - t_link7_41 * t_link1_28;
  const Scalar t_link1_39 = t_link1_38 - t_link7_38 * t_link1_27;
  const Scalar t_link1_40 = inverse_pivot_link6 * (t_link1_39 + t_link7_42 * t_link1_30);
  const Scalar t_link1_41 = t_link6_65 * t_link1_33 - t_link6_60 * t_link1_37;
  const Scalar t_link1_42 = t_link1_41 - t_link1_40;
  qdd[5] = t_link1_42;
  const Scalar t_link1_43 = t_link1_1 + t_link3_31 * t_link1_28;
  const Scalar t_link1_44 = t_link1_43 - t_link6_54 * t_link1_37;
  const Scalar t_link1_45 = t_link1_44 + t_link3_30 * t_link1_27;
  const Scalar t_link1_46 = t_link1_45 - t_link5_39 * t_link1_33;
  const Scalar t_link1_47 = t_link1_46 + t_link4_31 * t_link1_30;
  qdd[6] = -link7_p1 * (t_link1_47 + I_link7_yz * t_link1_42);
}

void point_positions(const Scalar q[7], Scalar p[3]) noexcept {
  const auto p_s_joint1 = sine_cosine(q[0]);
  const Scalar& s_joint1 = p_s_joint1.sine;
  const Scalar& c_joint1 = p_s_joint1.cosine;
  const auto p_s_joint2 = sine_cosine(q[1]);
  const Scalar& s_joint2 = p_s_joint2.sine;
  const Scalar& c_joint2 = p_s_joint2.cosine;
  const auto p_s_joint3 = sine_cosine(q[2]);
  const Scalar& s_joint3 = p_s_joint3.sine;
  const Scalar& c_joint3 = p_s_joint3.cosine;
  const auto p_s_joint4 = sine_cosine(q[3]);
  const Scalar& s_joint4 = p_s_joint4.sine;
  const Scalar& c_joint4 = p_s_joint4.cosine;
  const auto p_s_joint5 = sine_cosine(q[4]);
  const Scalar& s_joint5 = p_s_joint5.sine;
  const Scalar& c_joint5 = p_s_joint5.cosine;
  const auto p_s_joint6 = sine_cosine(q[5]);
  const Scalar& s_joint6 = p_s_joint6.sine;
  const Scalar& c_joint6 = p_s_joint6.cosine;
  const Scalar t_link6_1 = link7_l1 * c_joint6 + link7_l2 * s_joint6;
  const Scalar t_link5_1 = s_joint5 * t_link6_1;
  const Scalar t_link5_2 = link4_l1 - c_joint5 * t_link6_1;
  const Scalar t_link6_2 = link5_l1 + link7_l1 * s_joint6 - link7_l2 * c_joint6;
  const Scalar t_link4_1 = link4_l1 - c_joint4 * t_link5_2 - s_joint4 * t_link6_2;
  const Scalar t_link3_1 = c_joint3 * t_link5_1 + s_joint3 * t_link4_1;
  const Scalar t_link3_2 = s_joint3 * t_link5_1 - c_joint3 * t_link4_1;
  const Scalar t_link4_2 = link3_l1 - s_joint4 * t_link5_2 + c_joint4 * t_link6_2;
  const Scalar t_link2_1 = s_joint2 * t_link4_2 - c_joint2 * t_link3_2;
  // link1: p of 1.2
  p[0] = c_joint1 * t_link2_1 - s_joint1 * t_link3_1;
  p[1] = c_joint1 * t_link3_1 + s_joint1 * t_link2_1;
  p[2] = link1_l1 + s_joint2 * t_link3_2 + c_joint2 * t_link4_2;
}

void force_jacobian_transpose(const Scalar q[7], Scalar C[21]) noexcept {
  const auto p_s_joint1 = sine_cosine(q[0]);
  const Scalar& s_joint1 = p_s_joint1.sine;
  const Scalar& c_joint1 = p_s_joint1.cosine;
  const auto p_s_joint2 = sine_cosine(q[1]);
  const Scalar& s_joint2 = p_s_joint2.sine;
  const Scalar& c_joint2 = p_s_joint2.cosine;
  const auto p_s_joint3 = sine_cosine(q[2]);
  const Scalar& s_joint3 = p_s_joint3.sine;
  const Scalar& c_joint3 = p_s_joint3.cosine;
  const auto p_s_joint4 = sine_cosine(q[3]);
  const Scalar& s_joint4 = p_s_joint4.sine;
  const Scalar& c_joint4 = p_s_joint4.cosine;
  const auto p_s_joint5 = sine_cosine(q[4]);
  const Scalar& s_joint5 = p_s_joint5.sine;
  const Scalar& c_joint5 = p_s_joint5.cosine;
  const auto p_s_joint6 = sine_cosine(q[5]);
  const Scalar& s_joint6 = p_s_joint6.sine;
  const Scalar& c_joint6 = p_s_joint6.cosine;
  // link6: r of (9)
  const Scalar r_link6_x = link7_l1 * c_joint6 + link7_l2 * s_joint6;
  const Scalar t_link6_1 = c_joint5 * r_link6_x;
  const Scalar r_link6_y = link7_l1 * s_joint6 - link7_l2 * c_joint6;
  const Scalar r_link5_z = link5_l1 + r_link6_y;
  const Scalar r_link4_x = link4_l1 - t_link6_1;
  const Scalar t_link4_1 = s_joint4 * r_link5_z + c_joint4 * r_link4_x;
  // link3: r of (9)
  const Scalar r_link3_y = s_joint5 * r_link6_x;
  const Scalar t_link3_1 = s_joint3 * r_link3_y;
  const Scalar r_link3_x = link4_l1 - t_link4_1;
  const Scalar t_link3_2 = t_link3_1 - c_joint3 * r_link3_x;
  const Scalar t_link4_2 = c_joint4 * r_link5_z - s_joint4 * r_link4_x;
  const Scalar r_link3_z = link3_l1 + t_link4_2;
  const Scalar r_link2_x = c_joint2 * t_link3_2 - s_joint2 * r_link3_z;
  C[5] = r_link2_x;
  const Scalar t_link3_3 = c_joint3 * r_link3_y;
  // link2: r of (9)
  const Scalar r_link2_z = t_link3_3 + s_joint3 * r_link3_x;
  const Scalar t_link2_1 = s_joint1 * r_link2_z;
  C[1] = -(t_link2_1 + c_joint1 * r_link2_x);
  const Scalar t_link2_2 = c_joint1 * r_link2_z;
  C[0] = s_joint1 * r_link2_x - t_link2_2;
  const Scalar r_link2_y = s_joint2 * t_link3_2 + c_joint2 * r_link3_z;
  // link1: C of (9)
  C[3] = c_joint1 * r_link2_y;
  C[4] = s_joint1 * r_link2_y;
  C[7] = -(c_joint2 * t_link2_1 + c_joint1 * t_link3_2);
  C[6] = s_joint1 * t_link3_2 - c_joint2 * t_link2_2;
  const Scalar t_link1_1 = c_joint5 * r_link6_y;
  const Scalar t_link1_2 = s_joint5 * r_link6_y;
  const Scalar t_link1_3 = s_joint4 * r_link6_x;
  const Scalar t_link1_4 = t_link1_3 + c_joint4 * t_link1_1;
  const Scalar t_link1_5 = c_joint3 * t_link1_2 + s_joint3 * t_link1_4;
  const Scalar t_link1_6 = s_joint3 * t_link1_2 - c_joint3 * t_link1_4;
  const Scalar t_link1_7 = s_joint4 * t_link1_1 - c_joint4 * r_link6_x;
  const Scalar t_link1_8 = c_joint2 * t_link1_6 - s_joint2 * t_link1_7;
  C[15] = s_joint1 * t_link1_5 + c_joint1 * t_link1_8;
  const Scalar t_link1_9 = c_joint3 * t_link4_2;
  const Scalar t_link1_10 = s_joint3 * t_link4_2;
  const Scalar t_link1_11 = c_joint2 * t_link1_9 + s_joint2 * t_link4_1;
  C[9] = s_joint1 * t_link1_10 - c_joint1 * t_link1_11;
  C[10] = -(c_joint1 * t_link1_10 + s_joint1 * t_link1_11);
  C[16] = s_joint1 * t_link1_8 - c_joint1 * t_link1_5;
  C[8] = s_joint2 * r_link2_z;
  const Scalar t_link1_12 = s_joint5 * t_link1_3;
  const Scalar t_link1_13 = c_joint4 * t_link3_3 + s_joint3 * t_link6_1;
  const Scalar t_link1_14 = s_joint2 * t_link1_12 + c_joint2 * t_link1_13;
  const Scalar t_link1_15 = c_joint4 * t_link3_1 - c_joint3 * t_link6_1;
  C[13] = -(s_joint1 * t_link1_14 + c_joint1 * t_link1_15);
  C[12] = s_joint1 * t_link1_15 - c_joint1 * t_link1_14;
  C[17] = -(s_joint2 * t_link1_6 + c_joint2 * t_link1_7);
  C[11] = s_joint2 * t_link1_9 - c_joint2 * t_link4_1;
  C[14] = s_joint2 * t_link1_13 - c_joint2 * t_link1_12;
  C[2] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
}

}  // namespace panda
