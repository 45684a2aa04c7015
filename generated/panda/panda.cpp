// panda.cpp: see panda.hpp
//
// SPDX-License-Identifier: 0BSD
//
// GENERATED, DO NOT EDIT. To change it, change the model or the generator and run,
// with -o DIR,
//   treedyn generate panda.yaml

#include "panda.hpp"

namespace panda {

static_assert(kDigest == 0x6913a05fe1687387ULL, "header and source are of different runs");
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

// m: offset z of link1
constexpr double link1_l1 = 0.333;
// kg m^2: mass, com x y, inertia zz of link1, link3; mass, com x z, inertia yy of link2; mass, com
//     x z, inertia yy, offset x of link4; mass, com x, inertia xx yy zz, offset x of link5; mass,
//     com x, inertia xx yy zz of link6; mass, com x y, inertia xx xy yy zz, offset x of link7
constexpr double link1_I1 = 0.18019050588928345;
// kg m^2: mass, com x y, inertia zz of link1; mass, com z, inertia xx yy zz of link2
constexpr double link1_I2 = 0.014259565994474374;
// kg m^2: mass, com x y, inertia zz of link1, link3; mass, com x z, inertia yy of link2; mass, com
//     x z, inertia yy, offset x of link4; mass, offset x of link5; mass of link6, link7
constexpr double link1_I3 = 0.16179265463762763;

// kg m: mass, com x of link2
constexpr double link2_h1 = -0.002031994566;
// kg m: mass, com y of link2; mass, com z, offset y of link3; mass of link4, link5, link6, link7
constexpr double link2_h2 = -3.104340043512;
// kg m^2: mass, com x z, inertia xz of link2; mass, com x y, inertia xy of link3; mass, com z,
//     offset x of link4; offset x of link5
constexpr double link2_I1 = -0.010383014241958914;
// kg m^2: mass, com y z, inertia yz of link2
constexpr double link2_I2 = -0.0007689361029464;
// kg m^2: mass, com x y, inertia zz of link2, link6; mass, com x z, inertia yy, offset y of link3;
//     mass, com x y, inertia zz, offset x of link4; mass, com x z, inertia yy, offset x y of link5;
//     mass, com, inertia xx xy yy, offset x of link7
constexpr double link2_I3 = 1.6987581449384432;
// kg m^2: mass, com x y, inertia xx yy of link2, link6; mass, com x z, inertia xx zz, offset y of
//     link3; mass, com x y, inertia xx yy, offset x of link4; mass, com x z, inertia xx zz, offset
//     x y of link5; mass, com, inertia xx xy yy zz, offset x of link7
constexpr double link2_I4 = -1.4112525630785817;
// kg m^2: mass, com x y, inertia xy of link2
constexpr double link2_I5 = 0.00796671776787104;
// kg m^2: mass, com x y, inertia xx yy of link2; mass, com z, inertia xx yy zz, offset y of link3;
//     mass, com x, offset x of link4; offset x of link5
constexpr double link2_I6 = -0.34001233503451994;
// kg m^2: mass, com x y, inertia xy of link2
constexpr double link2_I7 = 0.00398335888393552;
// kg m^2: mass, com x z, inertia xz of link2
constexpr double link2_I8 = -0.01026110182100817;
// kg m^2: mass, com x y, inertia zz of link2; mass, com z, inertia xx yy zz, offset y of link3;
//     mass, com x, offset x of link4; offset x of link5
constexpr double link2_I9 = 0.3861681000243835;
// kg m^2: mass, com x, inertia xx yy zz of link2
constexpr double link2_I10 = 0.023077882494931805;
// kg m^2: mass, com y, inertia xx yy zz of link2; mass, com z, inertia xx yy zz, offset y of link3;
//     mass, com x, offset x of link4; offset x of link5
constexpr double link2_I11 = 0.3630902175294517;
// kg m^2: mass, com x y, inertia zz of link2; mass, com x z, inertia yy, offset y of link3; mass,
//     offset x of link4, link5; mass of link6, link7
constexpr double link2_I12 = 1.0357790547533403;
// N m: gravity; mass, com x of link2
constexpr double link2_G1 = 0.01993386669246;
// N m: gravity; mass, com y of link2; mass, com z, offset y of link3; mass, com x, offset x of
//     link4; offset x of link5
constexpr double link2_G2 = 12.038675848622248;

// ratio: offset y of link3; offset x of link4, link5
constexpr double link3_k1 = -3.83030303030303;
// ratio: offset y of link3; offset x of link4, link5
constexpr double link3_k2 = -7.66060606060606;
// m: offset y of link3
constexpr double link3_l1 = -0.316;
// kg m: mass, com x of link3; mass, offset x of link4, link5; mass of link6, link7
constexpr double link3_h1 = 0.684157959872;
// kg m: mass, com y of link3; mass, com z of link4
constexpr double link3_h2 = -0.028227094878;
// kg m^2: mass, com x y, inertia xx yy of link3; mass, com x z, inertia xx zz, offset x of link4;
//     mass, com x, inertia xx yy zz, offset x of link5; mass, com x, inertia xx yy zz of link6;
//     mass, com x y, inertia xx xy yy zz, offset x of link7
constexpr double link3_I1 = 0.0984967594701208;
// kg m^2: mass, com x y, inertia xy of link3; mass, com z, offset x of link4; offset x of link5
constexpr double link3_I2 = -0.000243824841901488;
// kg m^2: mass, com y z, inertia yz, offset y of link3; mass, com z of link4
constexpr double link3_I3 = -0.013297019103287584;
// kg m^2: mass, com x z, inertia xz, offset y of link3; mass, com x y, inertia xy, offset x of
//     link4; mass, com z, offset x y of link5; mass of link6, link7
constexpr double link3_I4 = -0.3604456361115751;
// kg m^2: mass, com x y, inertia zz of link3; mass, com x z, inertia yy, offset x of link4; mass,
//     com x, inertia xx yy zz, offset x of link5; mass, com x, inertia xx yy zz of link6; mass, com
//     x y, inertia xx xy yy zz, offset x of link7
constexpr double link3_I5 = 0.14285305739987728;
// kg m^2: mass, com x z, inertia xz, offset y of link3; mass, com x, offset x of link4; offset x of
//     link5
constexpr double link3_I6 = -0.06681619663671426;
// kg m^2: mass, com x y, inertia xy of link3; mass, com z, offset x of link4; offset x of link5
constexpr double link3_I7 = -0.000121912420950744;
// kg m^2: mass, com x y, inertia zz of link3; mass, com x z, inertia xx yy zz, offset x of link4;
//     offset x of link5
constexpr double link3_I8 = 0.03817619733278093;
// kg m^2: mass, com x y, inertia xx yy of link3; mass, com x z, inertia xx yy zz, offset x of
//     link4; offset x of link5
constexpr double link3_I9 = -0.00618010059697554;
// kg m^2: mass, com y, inertia xx yy zz of link3; mass, com z, inertia xx yy zz of link4
constexpr double link3_I10 = 0.022178148964878235;
// kg m^2: mass, com x, inertia xx yy zz of link3; mass, com x, offset x of link4; offset x of link5
constexpr double link3_I11 = 0.015998048367902695;
// kg m^2: mass, com y of link3; mass, com z, offset x of link4; offset x of link5
constexpr double link3_I12 = -0.002328735327435;
// kg m^2: mass, com x of link3; mass, com x, offset x of link4; offset x of link5
constexpr double link3_I13 = 0.016011409030815;
// kg m^2: mass, com x y, inertia zz of link3; mass, com x z, inertia yy, offset x of link4; mass,
//     offset x of link5; mass of link6, link7
constexpr double link3_I14 = 0.12445520614822143;
// kg m^2: mass, com x, inertia xx yy zz, offset y of link3; mass, com x y, inertia xx yy, offset x
//     of link4; mass, com y z, inertia xx, offset x y of link5; mass, com y z, inertia xx of link6;
//     mass, com, inertia xx xy yy of link7
constexpr double link3_I15 = -1.103283039275358;
// kg m^2: mass, com x y, inertia xx yy of link3; mass, com y z, inertia xx, offset x of link4;
//     mass, com y z, inertia xx, offset x y of link5; mass, com y z, inertia xx of link6; mass,
//     com, inertia xx xy yy of link7
constexpr double link3_I16 = 0.5781272906946228;
// N m: gravity; mass, com x of link3; mass, com x, offset x of link4; offset x of link5
constexpr double link3_G1 = -1.90390209202782;
// N m: gravity; mass, com y of link3; mass, com z of link4
constexpr double link3_G2 = 0.27690780075318;

// ratio: offset x of link4; offset x y of link5
constexpr double link4_k1 = 4.654545454545454;
// ratio: offset x of link4; offset x y of link5
constexpr double link4_k2 = 9.309090909090909;
// ratio: offset x of link4, link5, link7
constexpr double link4_k3 = 1.0666666666666667;
// m: offset x of link4, link5
constexpr double link4_l1 = 0.0825;
// kg m: mass, com x, offset x of link4; mass, offset x of link5; mass of link6, link7
constexpr double link4_h1 = 0.49008027465;
// kg m: mass, com y of link4; mass, com z, offset y of link5; mass of link6, link7
constexpr double link4_h2 = 1.720683553603;
// kg m^2: mass, com x y, inertia zz, offset x of link4; mass, com x z, inertia yy, offset x y of
//     link5; mass, com x y, inertia zz of link6; mass, com, inertia xx xy yy, offset x of link7
constexpr double link4_I1 = 0.662979090185103;
// kg m^2: mass, com x, offset x of link4; mass, offset x of link5; mass of link6, link7
constexpr double link4_I2 = 0.040431622658625;
// kg m^2: mass, com y, offset x of link4; mass, com z, offset x y of link5; mass of link6, link7
constexpr double link4_I3 = 0.1419563931722475;
// kg m^2: mass, com x y, inertia xy, offset x of link4; mass, com z, offset x y of link5; mass of
//     link6, link7
constexpr double link4_I4 = 0.2775281453709217;
// kg m^2: mass, com x y, inertia xx yy, offset x of link4; mass, com x z, inertia xx zz, offset x y
//     of link5; mass, com x y, inertia xx yy of link6; mass, com, inertia xx xy yy zz, offset x of
//     link7
constexpr double link4_I5 = -0.5344886153681603;
// kg m^2: mass, com x z, inertia xz of link4; mass, com x y, inertia xy of link5
constexpr double link4_I6 = -0.00239011055294907;
// kg m^2: mass, com y z, inertia yz of link4
constexpr double link4_I7 = 0.00164448757736927;
// kg m^2: mass, com y, offset x of link4; mass, com z, offset x y of link5; mass, com x of link6;
//     offset x of link7
constexpr double link4_I8 = 0.0825680742020475;
// kg m^2: mass, com x, offset x of link4; mass, offset x of link5; mass, com x of link6; offset x
//     of link7
constexpr double link4_I9 = -0.027672413504871093;
// kg m^2: mass, com x z, inertia xz of link4
constexpr double link4_I10 = 0.0039053550262761;
// kg m^2: mass, com y, inertia xx yy zz of link4; mass, com z, inertia xx yy zz, offset y of link5;
//     mass, com x of link6; offset x of link7
constexpr double link4_I11 = 0.3087998849151318;
// kg m^2: mass, com x y, inertia xy, offset x of link4; mass, com z, offset x y of link5; mass, com
//     x of link6; offset x of link7
constexpr double link4_I12 = 0.07937575371526084;
// kg m^2: mass, com x, inertia xx yy zz, offset x of link4; offset x of link5
constexpr double link4_I13 = 0.0054157634981905;
// kg m^2: mass, com x y, inertia zz, offset x of link4; mass, com z, inertia xx yy zz, offset x y
//     of link5; mass, com x of link6; offset x of link7
constexpr double link4_I14 = 0.3142156484133223;
// kg m^2: mass, com x y, inertia xx yy, offset x of link4; mass, com z, inertia xx yy zz, offset x
//     y of link5; mass, com x of link6; offset x of link7
constexpr double link4_I15 = 0.30338412141694127;
// kg m^2: mass, com x y, inertia xx yy, offset x of link4; mass, com y z, inertia xx, offset x y of
//     link5; mass, com y z, inertia xx of link6; mass, com, inertia xx xy yy of link7
constexpr double link4_I16 = 0.5665314265994568;
// s^-2: gravity; offset x of link4, link5
constexpr double link4_p1 = -118.9090909090909;

// m: offset y of link5
constexpr double link5_l1 = 0.384;
// kg m: mass, com x of link5
constexpr double link5_h1 = -0.014653732538;
// kg m: mass, com y of link5; mass, com z of link6
constexpr double link5_h2 = 0.067870631425;
// kg m^2: mass, com x, inertia xx yy zz of link5, link6; mass, com x y, inertia xx xy yy zz, offset
//     x of link7
constexpr double link5_I1 = 0.01839785125165585;
// kg m^2: offset x of link4; mass, com x, offset x of link5
constexpr double link5_I2 = -0.001208932934385;
// kg m^2: mass, com x y, inertia xy of link5
constexpr double link5_I3 = 0.00303048894665406;
// kg m^2: mass, com x z, inertia xz, offset y of link5; mass, com x y, inertia xy of link6; mass,
//     com z, offset x of link7
constexpr double link5_I4 = 0.004484246605646421;
// kg m^2: offset x of link4; mass, com y, offset x of link5; mass, com z of link6
constexpr double link5_I5 = 0.0055993270925625;
// kg m^2: mass, com y, inertia xx yy zz of link5; mass, com z, inertia xx yy zz of link6; com x y,
//     inertia xx xy yy zz of link7
constexpr double link5_I6 = 0.013644959979640612;
// kg m^2: mass, com y z, inertia yz, offset y of link5; mass, com z of link6
constexpr double link5_I7 = 0.02389827041510187;
// kg m^2: mass, com x z, inertia xz, offset y of link5
constexpr double link5_I8 = -0.001026787777028894;
// kg m^2: mass, com y, inertia xx yy zz of link5; mass, com z, inertia xx yy zz of link6
constexpr double link5_I9 = 0.010045187828321245;
// kg m^2: mass, com x y, inertia xx yy of link5; mass, com z, inertia xx yy zz of link6
constexpr double link5_I10 = 0.00859403176329453;
// kg m^2: mass, com x y, inertia xy of link5
constexpr double link5_I11 = 0.00151524447332703;
// kg m^2: mass, com x, inertia xx yy zz of link5
constexpr double link5_I12 = 0.001451156065026714;
// kg m^2: mass, com x y, inertia zz of link5; mass, com z, inertia xx yy zz of link6
constexpr double link5_I13 = 0.011496343893347959;
// kg m^2: mass, com x y, inertia xx yy of link5; mass, com x z, inertia xx zz of link6; mass, com x
//     y, inertia xx xy yy, offset x of link7
constexpr double link5_I14 = 0.004752891272015237;
// kg m^2: mass, com x y, inertia zz of link5; mass, com x z, inertia yy of link6; mass, com x y,
//     inertia zz, offset x of link7
constexpr double link5_I15 = 0.03204281123129646;

// kg m: mass, com y of link6; mass, com z of link7
constexpr double link6_h1 = 0.068832705569;
// kg m: mass, com x of link6; mass, offset x of link7
constexpr double link6_h2 = 0.164967552695;
// kg m^2: mass, com x y, inertia xx yy of link6; mass, com, inertia xx xy yy zz, offset x of link7
constexpr double link6_I1 = 0.0034383574409692415;
// kg m^2: mass, com x y, inertia xy of link6; mass, com z, offset x of link7
constexpr double link6_I2 = 0.01102206876535063;
// kg m^2: offset x of link4, link5; mass, com y of link6; mass, com z of link7
constexpr double link6_I3 = 0.0056786982094425;
// kg m^2: mass, com x z, inertia xz of link6; com x y, inertia xx xy yy of link7
constexpr double link6_I4 = 0.0006609405457638925;
// kg m^2: mass, com y z, inertia yz of link6
constexpr double link6_I5 = -9.3569097314605e-05;
// kg m^2: mass, com x y, inertia zz of link6; mass, com, inertia xx xy yy, offset x of link7
constexpr double link6_I6 = 0.030455032932289027;
// kg m^2: offset x of link4, link5; mass, com x of link6; mass, offset x of link7
constexpr double link6_I7 = 0.0136098230973375;
// kg m^2: mass, com x z, inertia xz of link6
constexpr double link6_I8 = 0.000103758917218685;
// kg m^2: mass, com x y, inertia xy of link6; mass, com z, offset x of link7
constexpr double link6_I9 = 0.005511034382675315;
// kg m^2: mass, com x y, inertia zz of link6; mass, com z, inertia xx yy zz, offset x of link7
constexpr double link6_I10 = 0.014628008479087448;
// kg m^2: mass, com x y, inertia xx yy of link6; mass, com z, inertia xx yy zz, offset x of link7
constexpr double link6_I11 = 0.012388667012232337;
// kg m^2: offset x of link4, link5; mass, com x of link6; mass, offset x of link7
constexpr double link6_I12 = 0.012759209153753906;
// kg m^2: mass, com y, inertia xx yy zz of link6; mass, com z, inertia xx yy zz of link7
constexpr double link6_I13 = 0.013508337745659894;
// kg m^2: mass, com x, inertia xx yy zz of link6; offset x of link7
constexpr double link6_I14 = 0.001119670733427555;

// ratio: com x y of link7
constexpr double link7_k1 = -0.3842058806066518;
// m: offset x of link7
constexpr double link7_l1 = 0.088;
// m: points of link7
constexpr double link7_l2 = 0.107;
// kg m: mass, com x y of link7
constexpr double link7_h1 = 0.008343776383464369;
// kg m^2: mass, com x y, inertia zz of link7
constexpr double link7_I1 = 0.004909651967360946;
// kg m^2: mass, com x y, offset x of link7
constexpr double link7_I2 = 0.0007342523217448644;
// kg m^2: mass, com, inertia xz yz of link7
constexpr double link7_I3 = 0.0013450149983408877;
// kg m^2: com x y, inertia xz yz of link7
constexpr double link7_I4 = 0.00113526676062776;
// kg m^2: mass, com x y, inertia xx xy yy of link7
constexpr double link7_I5 = -0.0022898923352777873;
// kg m^2: com x y, inertia xx xy yy of link7
constexpr double link7_I6 = -0.0011143632570904149;
// kg m^2: mass, com x y, offset x of link7
constexpr double link7_I7 = 0.0014685046434897288;
// kg m^2: offset y of link5; mass, com x y of link7
constexpr double link7_I8 = 0.0032040101312503172;
// kg m^2: offset x of link4, link5; mass, com x y of link7
constexpr double link7_I9 = 0.0006883615516358103;
// kg m^2: com x y, inertia xx xy yy zz of link7
constexpr double link7_I10 = 0.0035997721513193665;
// kg m^2: com x y, inertia xx xy yy of link7
constexpr double link7_I11 = -0.0005571816285452074;
// kg m^2: mass, com x y, inertia xx xy yy zz of link7
constexpr double link7_I12 = 0.0013098798160415795;
// kg^-1 m^-2: mass, com x y, inertia zz of link7
constexpr double link7_p1 = 203.68042513969144;

}  // namespace

// Names of values: a symbol of the equation, the link (in short), and the component along axes that
// are fixed to a link or to the base and need not be those of the model. neg_: the opposite; s_, c_
// of an angle: sine and cosine; s_ with a component: a way between joints; t_: a part of others.

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = 0.0825 m
// Names: vectors h_ in kg m^2/L; all others are of values in SI units; numbered ones (t_) by what
// they are made of. Arguments and results are in SI units.
void mass_matrix(const Scalar q[7], Scalar A[49]) noexcept {
  const Scalar angle_link7 = link7_k1 + q[6];
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[1], q[2], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[5], angle_link7);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint3 = sines[1];
  const Scalar c_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar s_joint6 = sines[4];
  const Scalar c_joint6 = cosines[4];
  const Scalar s_link7 = sines[5];
  const Scalar c_link7 = cosines[5];
  const Scalar t_link7_1 = link7_I9 * c_link7;
  const Scalar h_link6_z = link7_I9 * s_link7;
  // link7: A of (2)
  const Scalar t_link7_2 = link7_I5 * s_link7 + link7_I6 * c_link7;
  const Scalar t_link7_3 = s_link7 * t_link7_2;
  const Scalar neg_A_41 = link7_I3 * s_link7 + link7_I4 * c_link7;
  A[41] = -neg_A_41;
  A[47] = A[41];
  const Scalar t_link7_4 = link7_I3 * c_link7 - link7_I4 * s_link7;
  // link6: first moment h, A, second moments E of (2)
  const Scalar h_link6_x = link6_I7 + t_link7_1;
  const Scalar t_link6_1 = link6_I3 * s_joint6 + c_joint6 * h_link6_x;
  const Scalar neg_h_link5_z = link6_I3 * c_joint6 - s_joint6 * h_link6_x;
  const Scalar t_link6_2 = t_link7_3 - link7_I7 * c_link7;
  const Scalar t_link6_3 = c_joint6 * (link6_I2 + 2.0 * t_link7_4);
  const Scalar t_link6_4 = t_link6_3 - s_joint6 * (link6_I1 - t_link6_2);
  const Scalar t_link6_5 = s_joint6 * t_link6_4;
  const Scalar E_link6_xz = link6_I4 + link7_I2 * s_link7 + c_link7 * t_link7_2;
  const Scalar E_link6_yz = link6_I5 - neg_A_41;
  const Scalar t_link6_6 = c_joint6 * E_link6_xz - s_joint6 * E_link6_yz;
  const Scalar neg_A_33 = c_joint6 * E_link6_yz + s_joint6 * E_link6_xz;
  A[33] = -neg_A_33;
  A[39] = A[33];
  const Scalar A_40 = link6_I6 - t_link6_2;
  A[40] = A_40;
  // link5: first moment h, second moments E, A of (2)
  const Scalar h_link5_x = link5_I2 + t_link6_1;
  const Scalar h_link5_y = link5_I5 - h_link6_z;
  const Scalar t_link5_1 = c_joint5 * h_link5_x - s_joint5 * h_link5_y;
  const Scalar neg_h_link4_z = s_joint5 * h_link5_x + c_joint5 * h_link5_y;
  const Scalar E_link5_yz = link5_I7 - neg_A_33 - link7_I8 * s_link7;
  const Scalar t_link5_2 = t_link6_2 - t_link6_5;
  const Scalar E_link5_xx = link5_I1 - t_link5_2;
  const Scalar E_link5_yy = link5_I6 + t_link7_3;
  const Scalar t_link5_3 = c_joint5 * (link5_I3 - 2.0 * t_link6_6);
  const Scalar t_link5_4 = s_joint5 * (E_link5_xx - E_link5_yy) + t_link5_3;
  const Scalar t_link5_5 = s_joint5 * t_link5_4;
  const Scalar E_link5_xz_1 = link5_I4 + t_link7_4 - c_joint6 * t_link6_4;
  const Scalar E_link5_xz = E_link5_xz_1 + link4_k1 * t_link6_1;
  const Scalar A_25 = s_joint5 * E_link5_xz + c_joint5 * E_link5_yz;
  A[25] = A_25;
  A[31] = A[25];
  const Scalar A_32 = E_link5_xx + E_link5_yy;
  A[32] = A_32;
  const Scalar h_link4_x = link4_I2 - t_link5_1;
  const Scalar neg_h_link4_y = link4_I3 - neg_h_link5_z;
  // link4: A, second moments E of (2)
  const Scalar t_link4_1 = c_joint4 * h_link4_x + s_joint4 * neg_h_link4_y;
  const Scalar t_link4_2 = t_link6_5 + link4_k2 * neg_h_link5_z;
  const Scalar t_link4_3 = t_link5_2 + t_link5_5 + 2.0 * t_link5_1;
  const Scalar t_link5_6 = c_joint5 * E_link5_xz - s_joint5 * E_link5_yz;
  const Scalar t_link4_4 = neg_h_link5_z + t_link5_6;
  const Scalar t_link4_5 = s_joint4 * (t_link4_3 - (link4_I5 + t_link4_2));
  const Scalar t_link4_6 = t_link4_5 + c_joint4 * (link4_I4 - 2.0 * t_link4_4);
  const Scalar t_link4_7 = s_joint4 * t_link4_6;
  const Scalar neg_E_link4_xz = link4_I6 - t_link6_6 + neg_h_link4_z - c_joint5 * t_link5_4;
  const Scalar neg_E_link4_yz = link4_I7 - A_25;
  const Scalar neg_A_17 = s_joint4 * neg_E_link4_xz + c_joint4 * neg_E_link4_yz;
  A[17] = -neg_A_17;
  A[23] = A[17];
  const Scalar t_link4_8 = c_joint4 * neg_E_link4_xz - s_joint4 * neg_E_link4_yz;
  const Scalar neg_A_24 = t_link4_3 - (link4_I1 - t_link4_2);
  A[24] = -neg_A_24;
  const Scalar t_link3_1 = t_link4_3 - t_link4_7 + 2.0 * t_link4_1;
  const Scalar E_link4_zz = E_link5_yy + t_link5_5;
  // link3: first moment h, second moments E, A of (2)
  const Scalar t_link3_2 = neg_h_link4_z - t_link4_8;
  const Scalar t_link3_3 = s_joint3 * (E_link4_zz - (link3_I1 - t_link3_1));
  const Scalar t_link3_4 = t_link3_3 + c_joint3 * (link3_I2 - 2.0 * t_link3_2);
  const Scalar h_link3_z = c_joint4 * neg_h_link4_y - s_joint4 * h_link4_x;
  const Scalar neg_E_link3_yz = link3_I3 + neg_A_17 + link3_k1 * neg_h_link4_z;
  const Scalar E_link3_xz_1 = h_link3_z - (link3_I4 + t_link4_4) - c_joint4 * t_link4_6;
  const Scalar E_link3_xz = E_link3_xz_1 + link3_k1 * t_link4_1;
  const Scalar A_9 = c_joint3 * neg_E_link3_yz - s_joint3 * E_link3_xz;
  A[9] = A_9;
  A[15] = A[9];
  const Scalar t_link3_5 = c_joint3 * E_link3_xz + s_joint3 * neg_E_link3_yz;
  const Scalar t_link3_6 = t_link3_1 - E_link4_zz;
  const Scalar A_16 = link3_I5 - t_link3_6;
  A[16] = A_16;
  // link2: second moments E, A of (2)
  const Scalar E_link2_yz = link2_I2 + A_9;
  const Scalar E_link2_xz = link2_I1 - t_link3_2 - c_joint3 * t_link3_4;
  A[1] = c_joint2 * E_link2_yz + s_joint2 * E_link2_xz;
  A[7] = A[1];
  const Scalar t_link2_1 = t_link4_2 + t_link4_7 + link3_k2 * h_link3_z;
  const Scalar t_link2_2 = t_link3_1 - s_joint3 * t_link3_4;
  A[8] = link2_I3 - t_link2_1 - t_link2_2;
  const Scalar A_0_1 = s_joint2 * (t_link2_2 - (link2_I4 + t_link2_1));
  const Scalar A_0_2 = link1_I1 - t_link3_6;
  A[0] = A_0_2 - s_joint2 * (c_joint2 * (link2_I5 - 2.0 * t_link3_5) - A_0_1);
  const Scalar t_link7_5 = link7_I1 + link7_I2 * c_link7;
  // link6: A of (2)
  const Scalar neg_A_34 = s_joint6 * t_link7_4 + c_joint6 * t_link7_5;
  A[34] = -neg_A_34;
  A[46] = A[34];
  const Scalar t_link6_7 = c_joint6 * h_link6_z;
  const Scalar t_link6_8 = s_joint6 * h_link6_z;
  const Scalar t_link6_9 = link7_I8 * c_link7 + s_joint6 * t_link7_5 - c_joint6 * t_link7_4;
  const Scalar t_link6_10 = neg_A_41 - link4_k1 * t_link6_7;
  // link5: A of (2)
  const Scalar A_27 = t_link6_8 - s_joint5 * t_link6_9 - c_joint5 * t_link6_10;
  A[27] = A_27;
  A[45] = A[27];
  const Scalar t_link5_7 = s_joint5 * t_link6_7 + c_joint5 * t_link7_1;
  const Scalar t_link5_8 = c_joint5 * t_link6_9 - s_joint5 * t_link6_10;
  const Scalar t_link5_9 = neg_A_34 - t_link5_7;
  // link4: A of (2)
  const Scalar neg_A_20 = t_link5_7 - s_joint4 * t_link5_8 + c_joint4 * t_link5_9;
  A[20] = -neg_A_20;
  A[44] = A[20];
  const Scalar t_link4_9 = s_joint4 * t_link5_9 + c_joint4 * t_link5_8;
  const Scalar t_link4_10 = t_link4_9 - link3_k1 * t_link5_7;
  const Scalar t_link4_11 = c_joint4 - link3_k1 * s_joint4;
  const Scalar t_link4_12 = s_joint4 + link3_k1 * c_joint4;
  const Scalar t_link4_13 = A_27 - t_link6_8 * t_link4_11;
  const Scalar t_link5_10 = s_joint5 * t_link7_1 - c_joint5 * t_link6_7;
  const Scalar t_link4_14 = t_link4_13 + t_link4_12 * t_link5_10;
  A[13] = s_joint3 * t_link4_10 - c_joint3 * t_link4_14;
  A[43] = A[13];
  A[6] = -(s_joint2 * (s_joint3 * t_link4_14 + c_joint3 * t_link4_10) + c_joint2 * neg_A_20);
  A[42] = A[6];
  const Scalar t_link6_11 = A_40 - link4_k1 * neg_h_link5_z;
  // link5: A of (2)
  const Scalar neg_A_26 = t_link6_1 - s_joint5 * t_link6_6 - c_joint5 * t_link6_11;
  A[26] = -neg_A_26;
  A[38] = A[26];
  const Scalar t_link5_11 = s_joint5 * t_link6_11 - c_joint5 * t_link6_6;
  const Scalar t_link5_12 = s_joint5 * neg_h_link5_z;
  const Scalar t_link5_13 = neg_A_33 + t_link5_12;
  // link4: A of (2)
  const Scalar A_19 = t_link5_12 + s_joint4 * t_link5_11 - c_joint4 * t_link5_13;
  A[19] = A_19;
  A[37] = A[19];
  const Scalar t_link4_15 = link3_k1 * t_link5_12 + s_joint4 * t_link5_13;
  const Scalar t_link4_16 = t_link4_15 + c_joint4 * t_link5_11;
  const Scalar t_link4_17 = neg_A_26 - t_link6_1 * t_link4_11;
  const Scalar t_link4_18 = t_link4_17 - c_joint5 * neg_h_link5_z * t_link4_12;
  A[12] = s_joint3 * t_link4_16 + c_joint3 * t_link4_18;
  A[36] = A[12];
  A[5] = s_joint2 * (s_joint3 * t_link4_18 - c_joint3 * t_link4_16) + c_joint2 * A_19;
  A[35] = A[5];
  const Scalar t_link5_14 = t_link5_1 - A_32;
  const Scalar A_18 = t_link5_1 - c_joint4 * t_link5_14 - s_joint4 * t_link5_6;
  A[18] = A_18;
  A[30] = A[18];
  const Scalar t_link4_19 = A_25 - neg_h_link4_z * t_link4_12;
  const Scalar t_link4_20 = link3_k1 * t_link5_1 + s_joint4 * t_link5_14;
  const Scalar t_link4_21 = t_link4_20 - c_joint4 * t_link5_6;
  A[11] = s_joint3 * t_link4_21 - c_joint3 * t_link4_19;
  A[29] = A[11];
  A[4] = c_joint2 * A_18 - s_joint2 * (s_joint3 * t_link4_19 + c_joint3 * t_link4_21);
  A[28] = A[4];
  const Scalar t_link4_22 = t_link4_1 + neg_A_24 + link3_k1 * h_link3_z;
  A[10] = c_joint3 * t_link4_22 - s_joint3 * t_link4_8;
  A[22] = A[10];
  // link2: A of (2)
  A[3] = s_joint2 * (c_joint3 * t_link4_8 + s_joint3 * t_link4_22) - c_joint2 * neg_A_17;
  A[21] = A[3];
  A[2] = s_joint2 * t_link3_5 + c_joint2 * A_16;
  A[14] = A[2];
  A[48] = link7_I1;
}

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = 0.0825 m
// Names: vectors F_ in N m/L, a_ in L/s^2; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void bias_force(const Scalar q[7], const Scalar qd[7], Scalar B[7]) noexcept {
  const Scalar angle_link7 = link7_k1 + q[6];
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[1], q[2], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[5], angle_link7);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint3 = sines[1];
  const Scalar c_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar s_joint6 = sines[4];
  const Scalar c_joint6 = cosines[4];
  const Scalar s_link7 = sines[5];
  const Scalar c_link7 = cosines[5];
  // link3: angular velocity omega, Omega, angular acceleration alpha of (3)
  const Scalar t_link3_1 = s_joint2 * qd[0];
  const Scalar t_link3_2 = c_joint3 * qd[1];
  const Scalar omega_link3_y = t_link3_2 + s_joint3 * t_link3_1;
  const Scalar t_link3_3 = c_joint2 * qd[0];
  const Scalar omega_link3_z = qd[2] + t_link3_3;
  const Scalar t_link3_4 = omega_link3_y * omega_link3_z;
  const Scalar neg_alpha_link3_x = t_link3_2 * t_link3_3 - omega_link3_y * qd[2];
  const Scalar Omega_link3_zy = t_link3_4 - neg_alpha_link3_x;
  const Scalar t_link3_5 = s_joint3 * qd[1];
  const Scalar omega_link3_x = t_link3_5 - c_joint3 * t_link3_1;
  const Scalar t_link3_6 = omega_link3_x * omega_link3_x;
  const Scalar t_link3_7 = omega_link3_y * omega_link3_y;
  const Scalar t_link3_8 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_9 = omega_link3_z * omega_link3_x;
  const Scalar alpha_link3_y = t_link3_3 * t_link3_5 - qd[2] * omega_link3_x;
  const Scalar t_link3_10 = omega_link3_y * omega_link3_x;
  const Scalar neg_alpha_link3_z = qd[1] * t_link3_1;
  const Scalar Omega_link3_xy = t_link3_10 + neg_alpha_link3_z;
  // link4: angular velocity omega, Omega of (3)
  const Scalar neg_omega_link4_y = c_joint4 * omega_link3_z - s_joint4 * omega_link3_x;
  const Scalar neg_omega_link4_z = omega_link3_y - qd[3];
  const Scalar neg_Omega_link4_yz = s_joint4 * Omega_link3_xy - c_joint4 * Omega_link3_zy;
  const Scalar Omega_link4_zy = neg_Omega_link4_yz + neg_omega_link4_y * neg_omega_link4_z * 2.0;
  const Scalar Omega_link3_zx = t_link3_9 - alpha_link3_y;
  const Scalar neg_omega_link4_x = s_joint4 * omega_link3_z + c_joint4 * omega_link3_x;
  const Scalar t_link4_1 = neg_omega_link4_z * neg_omega_link4_x;
  const Scalar Omega_link4_xz = c_joint4 * Omega_link3_xy + s_joint4 * Omega_link3_zy;
  const Scalar alpha_link5_z = t_link4_1 - Omega_link4_xz;
  const Scalar t_link4_2 = neg_omega_link4_x * neg_omega_link4_x;
  const Scalar t_link4_3 = neg_omega_link4_z * neg_omega_link4_z;
  const Scalar neg_Omega_link4_yy = t_link4_2 + t_link4_3;
  const Scalar t_link4_4 = neg_omega_link4_y * neg_omega_link4_x;
  const Scalar Omega_link4_xy = alpha_link3_y + t_link4_4;
  // link5: angular velocity omega, Omega of (3)
  const Scalar neg_omega_link5_y = s_joint5 * neg_omega_link4_x - c_joint5 * neg_omega_link4_z;
  const Scalar omega_link5_z = neg_omega_link4_y + qd[4];
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar neg_Omega_link5_zy = Omega_link5_yz + neg_omega_link5_y * omega_link5_z * 2.0;
  const Scalar omega_link5_x = c_joint5 * neg_omega_link4_x + s_joint5 * neg_omega_link4_z;
  const Scalar t_link5_1 = omega_link5_z * omega_link5_x;
  const Scalar Omega_link5_xz = s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar alpha_link6_z = t_link5_1 - Omega_link5_xz;
  const Scalar Omega_link5_zx = t_link5_1 + alpha_link6_z;
  const Scalar Omega_link3_yx = t_link3_10 - neg_alpha_link3_z;
  const Scalar Omega_link3_yz = t_link3_4 + neg_alpha_link3_x;
  const Scalar neg_a_link4_z = Omega_link3_yx - link3_k1 * Omega_link3_yz;
  const Scalar Omega_link4_zx = t_link4_1 + alpha_link5_z;
  const Scalar Omega_link3_xz = t_link3_9 + alpha_link3_y;
  // link4: acceleration a, Omega of (3)
  const Scalar t_link4_5 = t_link3_7 + t_link3_8 + link3_k1 * Omega_link3_xz;
  const Scalar t_link4_6 = Omega_link3_zx + link3_k1 * (t_link3_6 + t_link3_7);
  const Scalar a_link4_x = c_joint4 * t_link4_5 - s_joint4 * t_link4_6;
  const Scalar t_link4_7 = t_link4_2 - t_link4_3;
  const Scalar t_link5_2 = neg_a_link4_z - Omega_link4_zx;
  const Scalar neg_Omega_link3_yy = t_link3_6 + t_link3_8;
  const Scalar Omega_link4_xx = t_link4_7 - neg_Omega_link3_yy;
  // link5: acceleration a, Omega of (3)
  const Scalar t_link5_3 = a_link4_x + Omega_link4_xx;
  const Scalar a_link5_y = s_joint5 * t_link5_3 + c_joint5 * t_link5_2;
  const Scalar a_link5_x = s_joint5 * t_link5_2 - c_joint5 * t_link5_3;
  const Scalar neg_Omega_link4_yx = alpha_link3_y - t_link4_4;
  const Scalar a_link5_z = neg_Omega_link4_yx + c_joint4 * t_link4_6 + s_joint4 * t_link4_5;
  const Scalar t_link5_4 = neg_omega_link5_y * omega_link5_x;
  const Scalar neg_Omega_link5_xy = alpha_link5_z + t_link5_4;
  const Scalar t_link5_5 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_6 = omega_link5_z * omega_link5_z;
  const Scalar neg_Omega_link5_yy = t_link5_5 + t_link5_6;
  const Scalar Omega_link7_xy = s_joint6 * neg_Omega_link5_zy + c_joint6 * neg_Omega_link5_xy;
  // link6: angular velocity omega, Omega, acceleration a of (3)
  const Scalar omega_link6_x = s_joint6 * omega_link5_z + c_joint6 * omega_link5_x;
  const Scalar omega_link6_z = neg_omega_link5_y + qd[5];
  const Scalar t_link6_1 = 2.0 * omega_link6_x;
  const Scalar neg_Omega_link6_zx = Omega_link7_xy - omega_link6_z * t_link6_1;
  const Scalar neg_omega_link6_y = s_joint6 * omega_link5_x - c_joint6 * omega_link5_z;
  const Scalar Omega_link6_yz = c_joint6 * neg_Omega_link5_zy - s_joint6 * neg_Omega_link5_xy;
  const Scalar t_link7_1 = 2.0 * omega_link6_z;
  const Scalar Omega_link7_yz = Omega_link6_yz + neg_omega_link6_y * t_link7_1;
  const Scalar t_link6_2 = omega_link6_x * neg_omega_link6_y;
  const Scalar Omega_link7_xz = alpha_link6_z + t_link6_2;
  const Scalar Omega_link6_yx = alpha_link6_z - t_link6_2;
  const Scalar t_link6_3 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_4 = omega_link6_z * omega_link6_z;
  const Scalar t_link6_5 = t_link6_3 - t_link6_4;
  const Scalar neg_Omega_link6_yy = t_link6_3 + t_link6_4;
  const Scalar omega_link7_z = neg_omega_link6_y + qd[6];
  const Scalar neg_Omega_link7_zy = Omega_link6_yz - t_link7_1 * qd[6];
  const Scalar neg_a_link6_z = a_link5_y + link4_k1 * Omega_link5_yz;
  const Scalar neg_a_link7_y = neg_a_link6_z + link4_k3 * neg_Omega_link6_zx;
  const Scalar t_link6_6 = a_link5_z - link4_k1 * neg_Omega_link4_yy;
  const Scalar t_link6_7 = a_link5_x + link4_k1 * Omega_link5_xz;
  const Scalar a_link6_x = s_joint6 * t_link6_6 + c_joint6 * t_link6_7;
  // link7: acceleration a, Omega, moment M of (3)
  const Scalar a_link7_x = a_link6_x - link4_k3 * (neg_Omega_link5_yy - t_link6_5);
  const Scalar neg_a_link7_z_1 = link4_k3 * Omega_link6_yx + c_joint6 * t_link6_6;
  const Scalar neg_a_link7_z = neg_a_link7_z_1 - s_joint6 * t_link6_7;
  const Scalar neg_Omega_link7_zx = Omega_link7_xz - t_link6_1 * omega_link7_z;
  const Scalar t_link7_2 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_3 = link7_I5 * s_link7 + link7_I6 * c_link7;
  const Scalar t_link7_4 = s_link7 * t_link7_3;
  const Scalar t_link7_5 = link7_I10 + t_link7_4;
  const Scalar t_link7_6 = link7_I11 - c_link7 * t_link7_3;
  const Scalar t_link7_7 = link7_I3 * c_link7 - link7_I4 * s_link7;
  const Scalar t_link7_8 = link7_I9 * s_link7;
  const Scalar t_link7_9 = link7_I9 * c_link7;
  const Scalar t_link7_10 = link7_I3 * s_link7 + link7_I4 * c_link7;
  const Scalar t_link7_11 = link7_I12 - t_link7_4;
  const Scalar neg_M_link7_z_1 = neg_a_link7_y * t_link7_9 - t_link6_5 * t_link7_6;
  const Scalar neg_M_link7_z_2 = neg_M_link7_z_1 + neg_Omega_link6_zx * t_link7_11;
  const Scalar neg_M_link7_z_3 = neg_M_link7_z_2 - Omega_link7_yz * t_link7_7;
  const Scalar neg_M_link7_z_4 = neg_M_link7_z_3 + Omega_link7_xz * t_link7_10;
  const Scalar neg_M_link7_z_5 = neg_M_link7_z_4 + a_link7_x * t_link7_8;
  const Scalar neg_M_link7_z = neg_M_link7_z_5 + Omega_link7_xy * t_link7_5;
  B[6] = -neg_M_link7_z;
  const Scalar neg_F_link7_z_1 = link6_I12 * neg_a_link7_z + neg_Omega_link7_zx * t_link7_9;
  const Scalar neg_F_link7_z = neg_F_link7_z_1 + neg_Omega_link7_zy * t_link7_8;
  // link6: moment M of (3)
  const Scalar t_link6_8 = neg_Omega_link5_yy - neg_Omega_link6_yy;
  const Scalar M_link6_z_1 = link6_I8 * Omega_link6_yz - neg_Omega_link7_zy * t_link7_6;
  const Scalar M_link6_z_2 = M_link6_z_1 + link6_I11 * t_link6_2 + link6_I3 * a_link6_x;
  const Scalar M_link6_z_3 = M_link6_z_2 + link6_I10 * alpha_link6_z;
  const Scalar M_link6_z_4 = M_link6_z_3 + neg_a_link7_z * t_link7_9;
  const Scalar M_link6_z_5 = M_link6_z_4 + link4_k3 * neg_F_link7_z;
  const Scalar M_link6_z_6 = M_link6_z_5 + neg_Omega_link7_zx * t_link7_11;
  const Scalar M_link6_z_7 = M_link6_z_6 - Omega_link7_xy * (link6_I5 - t_link7_10);
  const Scalar M_link6_z_8 = M_link6_z_7 + t_link7_7 * (t_link6_3 - t_link7_2);
  const Scalar M_link6_z = M_link6_z_8 + link6_I9 * (t_link6_5 - t_link6_8);
  B[5] = M_link6_z;
  // link7: moment M, force F of (3)
  const Scalar neg_M_link6_x_1 = t_link7_10 * (t_link6_4 - t_link7_2);
  const Scalar neg_M_link6_x_2 = neg_M_link6_x_1 + link6_I8 * Omega_link6_yx;
  const Scalar neg_M_link6_x_3 = neg_M_link6_x_2 + neg_a_link7_z * t_link7_8;
  const Scalar neg_M_link6_x_4 = link6_I9 + t_link7_7;
  const Scalar neg_M_link6_x_5 = neg_M_link6_x_3 - neg_Omega_link6_zx * neg_M_link6_x_4;
  const Scalar neg_M_link6_x_6 = neg_M_link6_x_5 - link6_I3 * neg_a_link6_z;
  const Scalar neg_M_link6_x_7 = neg_M_link6_x_6 + link6_I13 * Omega_link7_yz;
  const Scalar neg_M_link6_x_8 = neg_M_link6_x_7 - neg_Omega_link7_zx * t_link7_6;
  const Scalar neg_M_link6_x_9 = neg_M_link6_x_8 + neg_Omega_link7_zy * t_link7_5;
  const Scalar neg_M_link6_x = neg_M_link6_x_9 + link6_I5 * t_link6_8;
  const Scalar neg_F_link7_y_1 = t_link7_8 * (t_link6_3 + t_link7_2);
  const Scalar neg_F_link7_y_2 = link6_I12 * neg_a_link7_y + neg_F_link7_y_1;
  const Scalar neg_F_link7_y = neg_F_link7_y_2 + neg_Omega_link6_zx * t_link7_9;
  const Scalar t_link5_7 = t_link5_5 - t_link5_6;
  const Scalar t_link5_8 = neg_Omega_link4_yy - neg_Omega_link5_yy;
  // link6: moment M, force F of (3)
  const Scalar M_link6_y_1 = neg_M_link7_z + link4_k3 * neg_F_link7_y - link6_I5 * Omega_link7_xz;
  const Scalar M_link6_y_2 = M_link6_y_1 + link6_I14 * neg_Omega_link6_zx;
  const Scalar M_link6_y = M_link6_y_2 - link6_I9 * Omega_link7_yz + link6_I8 * t_link6_5;
  const Scalar neg_M_link5_z_1 = s_joint6 * neg_M_link6_x - link5_I10 * t_link5_4;
  const Scalar neg_M_link5_z_2 = neg_M_link5_z_1 + link5_I11 * (t_link5_7 - t_link5_8);
  const Scalar neg_M_link5_z_3 = neg_M_link5_z_2 - c_joint6 * M_link6_y + link5_I5 * a_link5_x;
  const Scalar neg_M_link5_z_4 = neg_M_link5_z_3 - link5_I2 * a_link5_y;
  const Scalar neg_M_link5_z_5 = neg_M_link5_z_4 + link5_I7 * Omega_link5_xz;
  const Scalar neg_M_link5_z_6 = neg_M_link5_z_5 - link5_I8 * Omega_link5_yz;
  const Scalar neg_M_link5_z = neg_M_link5_z_6 - link5_I13 * alpha_link5_z;
  B[4] = -neg_M_link5_z;
  const Scalar F_link6_y = neg_F_link7_z + link6_I3 * neg_Omega_link6_yy;
  const Scalar F_link6_x_1 = link6_I12 * a_link7_x + link6_I3 * Omega_link7_xz;
  const Scalar F_link6_x_2 = F_link6_x_1 - t_link7_9 * (t_link6_4 + t_link7_2);
  const Scalar F_link6_x = F_link6_x_2 + Omega_link7_xy * t_link7_8;
  const Scalar t_link6_9 = s_joint6 * F_link6_y - c_joint6 * F_link6_x;
  const Scalar neg_F_link5_x_1 = t_link6_9 + link5_I2 * (neg_Omega_link4_yy - t_link5_7);
  const Scalar neg_F_link5_x_2 = neg_F_link5_x_1 + link5_I5 * neg_Omega_link5_xy;
  const Scalar neg_F_link5_x = neg_F_link5_x_2 + link4_I9 * a_link5_x;
  const Scalar neg_F_link6_z = neg_F_link7_y - link6_I3 * Omega_link7_yz;
  // link5: Omega, force F of (3)
  const Scalar Omega_link5_yx = alpha_link5_z - t_link5_4;
  const Scalar F_link5_y_1 = neg_F_link6_z - link4_I9 * a_link5_y - link5_I5 * neg_Omega_link5_yy;
  const Scalar F_link5_y = F_link5_y_1 + link5_I2 * Omega_link5_yx;
  // link6: moment M of (3)
  const Scalar neg_M_link5_x_1 = c_joint6 * neg_M_link6_x - link5_I11 * Omega_link5_zx;
  const Scalar neg_M_link5_x_2 = neg_M_link5_x_1 + link4_k1 * neg_F_link6_z;
  const Scalar neg_M_link5_x_3 = neg_M_link5_x_2 + s_joint6 * M_link6_y;
  const Scalar neg_M_link5_x_4 = neg_M_link5_x_3 + link5_I9 * neg_Omega_link5_zy;
  const Scalar neg_M_link5_x_5 = neg_M_link5_x_4 + link5_I7 * t_link5_8;
  const Scalar neg_M_link5_x = neg_M_link5_x_5 - link5_I5 * a_link5_z + link5_I8 * Omega_link5_yx;
  // link5: force F of (3)
  const Scalar F_link5_z_1 = c_joint6 * F_link6_y - link5_I5 * neg_Omega_link5_zy;
  const Scalar F_link5_z_2 = F_link5_z_1 - link4_I9 * a_link5_z + s_joint6 * F_link6_x;
  const Scalar F_link5_z = F_link5_z_2 + link5_I2 * Omega_link5_zx;
  // link6: moment M of (3)
  const Scalar neg_M_link5_y_1 = M_link6_z - link5_I11 * neg_Omega_link5_zy;
  const Scalar neg_M_link5_y_2 = neg_M_link5_y_1 - link5_I8 * t_link5_7;
  const Scalar neg_M_link5_y_3 = neg_M_link5_y_2 + link5_I7 * neg_Omega_link5_xy;
  const Scalar neg_M_link5_y_4 = neg_M_link5_y_3 + link5_I2 * a_link5_z;
  const Scalar neg_M_link5_y_5 = neg_M_link5_y_4 + link5_I12 * Omega_link5_zx;
  const Scalar neg_M_link5_y = neg_M_link5_y_5 + link4_k1 * t_link6_9;
  // link5: moment M of (3)
  const Scalar neg_M_link4_z_1 = F_link5_z - link4_I8 * a_link4_x;
  const Scalar neg_M_link4_z_2 = neg_M_link4_z_1 + link4_I10 * neg_Omega_link4_yz;
  const Scalar neg_M_link4_z_3 = neg_M_link4_z_2 - s_joint5 * neg_M_link5_x;
  const Scalar neg_M_link4_z_4 = neg_Omega_link4_yy + Omega_link4_xx;
  const Scalar neg_M_link4_z_5 = neg_M_link4_z_3 - link4_I12 * neg_M_link4_z_4;
  const Scalar neg_M_link4_z_6 = neg_M_link4_z_5 + link4_I13 * neg_Omega_link4_yx;
  const Scalar neg_M_link4_z_7 = neg_M_link4_z_6 - c_joint5 * neg_M_link5_y;
  const Scalar neg_M_link4_z_8 = neg_M_link4_z_7 - link4_I7 * Omega_link4_xz;
  const Scalar neg_M_link4_z = neg_M_link4_z_8 + link4_I11 * Omega_link4_xy;
  B[3] = -neg_M_link4_z;
  // link4: moment M, force F of (3)
  const Scalar M_link4_x_1 = link4_I8 * neg_a_link4_z + c_joint5 * neg_M_link5_x;
  const Scalar M_link4_x_2 = M_link4_x_1 - link4_I12 * Omega_link4_zx;
  const Scalar M_link4_x_3 = M_link4_x_2 - link4_I7 * (neg_Omega_link4_yy - neg_Omega_link3_yy);
  const Scalar M_link4_x_4 = M_link4_x_3 + link4_I10 * neg_Omega_link4_yx;
  const Scalar M_link4_x = M_link4_x_4 + link4_I11 * Omega_link4_zy - s_joint5 * neg_M_link5_y;
  const Scalar t_link5_9 = s_joint5 * neg_F_link5_x - c_joint5 * F_link5_y;
  const Scalar F_link4_z = t_link5_9 - link4_I8 * Omega_link4_zy;
  const Scalar M_link4_y_1 = neg_M_link5_z - t_link5_9 + link4_I10 * t_link4_7;
  const Scalar M_link4_y_2 = M_link4_y_1 - link4_I7 * Omega_link4_xy;
  const Scalar M_link4_y = M_link4_y_2 + link4_I12 * Omega_link4_zy - link4_I13 * Omega_link4_zx;
  const Scalar neg_M_link3_z_1 = F_link4_z + link3_I8 * neg_alpha_link3_z;
  const Scalar neg_M_link3_z_2 = neg_M_link3_z_1 - link3_I9 * t_link3_10;
  const Scalar neg_M_link3_z_3 = neg_M_link3_z_2 + s_joint4 * M_link4_x;
  const Scalar neg_M_link3_z_4 = neg_M_link3_z_3 - link3_I7 * (t_link3_6 - t_link3_7);
  const Scalar neg_M_link3_z_5 = neg_M_link3_z_4 + link3_I6 * Omega_link3_yz;
  const Scalar neg_M_link3_z = neg_M_link3_z_5 + c_joint4 * M_link4_y - link3_I3 * Omega_link3_xz;
  B[2] = -neg_M_link3_z;
  const Scalar F_link4_x_1 = c_joint5 * neg_F_link5_x - link4_I8 * Omega_link4_xy;
  const Scalar F_link4_x = F_link4_x_1 + s_joint5 * F_link5_y;
  const Scalar neg_F_link4_y = F_link5_z - link4_I8 * neg_Omega_link4_yy;
  // link3: moment M of (3)
  const Scalar M_link3_y_1 = neg_M_link4_z - link3_I6 * (t_link3_6 - t_link3_8);
  const Scalar M_link3_y_2 = M_link3_y_1 - (c_joint4 - link3_k1 * s_joint4) * neg_F_link4_y;
  const Scalar M_link3_y_3 = M_link3_y_2 - link3_I3 * Omega_link3_xy;
  const Scalar M_link3_y_4 = M_link3_y_3 + (s_joint4 + link3_k1 * c_joint4) * F_link4_x;
  const Scalar M_link3_y = M_link3_y_4 - link3_I11 * Omega_link3_zx + link3_I7 * Omega_link3_zy;
  const Scalar M_link3_x_1 = link3_I6 * Omega_link3_yx + link3_I3 * (t_link3_7 - t_link3_8);
  const Scalar M_link3_x_2 = M_link3_x_1 - c_joint4 * M_link4_x + link3_I10 * Omega_link3_zy;
  const Scalar M_link3_x_3 = M_link3_x_2 - link3_k1 * F_link4_z + s_joint4 * M_link4_y;
  const Scalar M_link3_x = M_link3_x_3 - link3_I7 * Omega_link3_zx;
  // link2: moment M of (3)
  const Scalar t_link2_1 = link2_I7 - c_joint2 * (link2_I5 * c_joint2 + link2_I6 * s_joint2);
  const Scalar t_link2_2 = qd[0] * t_link2_1;
  const Scalar neg_M_link2_y_1 = qd[1] * (link2_I8 * c_joint2 - link2_I2 * s_joint2);
  const Scalar neg_M_link2_y_2 = s_joint2 * (c_joint3 * M_link3_x - s_joint3 * M_link3_y);
  const Scalar neg_M_link2_y_3 = c_joint2 * neg_M_link3_z + neg_M_link2_y_2;
  B[0] = qd[1] * (2.0 * t_link2_2 + neg_M_link2_y_1) - neg_M_link2_y_3;
  B[1] = s_joint3 * M_link3_x - (qd[0] * t_link2_2 - c_joint3 * M_link3_y);
}

void gravity_force(const Scalar q[7], Scalar G[7]) noexcept {
  // link7: first moment h, G of 6.5
  const Scalar angle_link7 = link7_k1 + q[6];
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[1], q[2], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[5], angle_link7);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint3 = sines[1];
  const Scalar c_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar s_joint6 = sines[4];
  const Scalar c_joint6 = cosines[4];
  const Scalar s_link7 = sines[5];
  const Scalar c_link7 = cosines[5];
  const Scalar h_link7_x = link7_h1 * c_link7;
  const Scalar h_link7_y = link7_h1 * s_link7;
  const Scalar t_link7_1 = base_g1 * s_joint2;
  const Scalar t_link7_2 = c_joint3 * t_link7_1;
  const Scalar t_link7_3 = base_g1 * c_joint2;
  const Scalar t_link7_4 = c_joint4 * t_link7_2 - s_joint4 * t_link7_3;
  const Scalar t_link7_5 = s_joint3 * t_link7_1;
  const Scalar t_link7_6 = s_joint5 * t_link7_5 - c_joint5 * t_link7_4;
  const Scalar t_link7_7 = c_joint5 * t_link7_5 + s_joint5 * t_link7_4;
  const Scalar t_link7_8 = s_joint4 * t_link7_2 + c_joint4 * t_link7_3;
  G[6] = h_link7_x * t_link7_7 + h_link7_y * (c_joint6 * t_link7_6 + s_joint6 * t_link7_8);
  const Scalar t_link6_1 = link6_h2 + h_link7_x;
  const Scalar h_link6_x = link6_h1 * s_joint6 + c_joint6 * t_link6_1;
  const Scalar h_link5_x = link5_h1 + h_link6_x;
  const Scalar h_link5_y = link5_h2 - h_link7_y;
  const Scalar neg_h_link6_y = link6_h1 * c_joint6 - s_joint6 * t_link6_1;
  G[5] = -(t_link7_8 * h_link6_x + t_link7_6 * neg_h_link6_y);
  const Scalar h_link4_x = link4_h1 - c_joint5 * h_link5_x + s_joint5 * h_link5_y;
  const Scalar neg_h_link4_y = link4_h2 - neg_h_link6_y;
  G[4] = t_link7_6 * h_link5_y - t_link7_7 * h_link5_x;
  G[3] = t_link7_8 * h_link4_x - t_link7_4 * neg_h_link4_y;
  const Scalar h_link3_x = link3_h1 - s_joint4 * neg_h_link4_y - c_joint4 * h_link4_x;
  const Scalar neg_h_link3_y = link3_h2 - c_joint5 * h_link5_y - s_joint5 * h_link5_x;
  const Scalar h_link2_x = link2_h1 + c_joint3 * h_link3_x + s_joint3 * neg_h_link3_y;
  const Scalar h_link2_y = link2_h2 + s_joint4 * h_link4_x - c_joint4 * neg_h_link4_y;
  G[2] = t_link7_2 * neg_h_link3_y - t_link7_5 * h_link3_x;
  // link2: G of 6.5
  G[1] = t_link7_3 * h_link2_x - t_link7_1 * h_link2_y;
  G[0] = 0.0;
}

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = 0.0825 m
// Names: vectors F_ in N m/L, a_ in L/s^2; all others are of values in SI units; numbered ones (t_)
// by what they are made of. Arguments and results are in SI units.
void inverse_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar qdd[7],
                      Scalar tau[7]) noexcept {
  const Scalar angle_link7 = link7_k1 + q[6];
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[1], q[2], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[5], angle_link7);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint3 = sines[1];
  const Scalar c_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar s_joint6 = sines[4];
  const Scalar c_joint6 = cosines[4];
  const Scalar s_link7 = sines[5];
  const Scalar c_link7 = cosines[5];
  // link2: angular velocity omega, Omega, angular acceleration alpha of (1)
  const Scalar neg_omega_link2_x = s_joint2 * qd[0];
  const Scalar t_link2_1 = neg_omega_link2_x * neg_omega_link2_x;
  const Scalar t_link2_2 = qd[1] * qd[1];
  const Scalar neg_omega_link2_y = c_joint2 * qd[0];
  const Scalar neg_Omega_link2_zy = s_joint2 * qdd[0] + qd[1] * neg_omega_link2_y * 2.0;
  const Scalar t_link2_3 = neg_omega_link2_x * qd[1];
  const Scalar alpha_link2_y = t_link2_3 - c_joint2 * qdd[0];
  const Scalar neg_Omega_link2_zx = t_link2_3 + alpha_link2_y;
  const Scalar t_link2_4 = neg_omega_link2_x * neg_omega_link2_y;
  const Scalar neg_Omega_link2_yy = t_link2_1 + t_link2_2;
  const Scalar omega_link3_z = neg_omega_link2_y + qd[2];
  const Scalar omega_link3_y = s_joint3 * neg_omega_link2_x + c_joint3 * qd[1];
  const Scalar Omega_link2_xy = t_link2_4 - qdd[1];
  // link3: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar Omega_link3_yz = c_joint3 * neg_Omega_link2_zy + s_joint3 * Omega_link2_xy;
  const Scalar neg_Omega_link3_zy = Omega_link3_yz - omega_link3_z * omega_link3_y * 2.0;
  const Scalar Omega_link3_xz = s_joint3 * neg_Omega_link2_zy - c_joint3 * Omega_link2_xy;
  const Scalar neg_omega_link3_x = c_joint3 * neg_omega_link2_x - s_joint3 * qd[1];
  const Scalar t_link3_1 = omega_link3_z * neg_omega_link3_x;
  const Scalar alpha_link3_y = Omega_link3_xz + t_link3_1;
  const Scalar neg_Omega_link3_zx = t_link3_1 + alpha_link3_y;
  const Scalar t_link3_2 = neg_omega_link3_x * neg_omega_link3_x;
  const Scalar t_link3_3 = omega_link3_z * omega_link3_z;
  const Scalar t_link3_4 = omega_link3_y * neg_omega_link3_x;
  const Scalar neg_alpha_link3_z = alpha_link2_y - qdd[2];
  const Scalar neg_Omega_link3_xy = t_link3_4 - neg_alpha_link3_z;
  const Scalar a_link2_x = link4_p1 * s_joint2;
  const Scalar a_link3_x = c_joint3 * a_link2_x;
  const Scalar neg_a_link3_y = s_joint3 * a_link2_x;
  // link4: angular velocity omega, Omega, acceleration a of (1)
  const Scalar neg_omega_link4_y = s_joint4 * neg_omega_link3_x + c_joint4 * omega_link3_z;
  const Scalar neg_omega_link4_z = omega_link3_y - qd[3];
  const Scalar neg_Omega_link4_yz = c_joint4 * neg_Omega_link3_zy - s_joint4 * neg_Omega_link3_xy;
  const Scalar Omega_link4_zy = neg_Omega_link4_yz + neg_omega_link4_y * neg_omega_link4_z * 2.0;
  const Scalar t_link4_1 = neg_Omega_link3_zx + link4_p1 * c_joint2;
  const Scalar t_link4_2 = t_link4_1 - link3_k1 * neg_Omega_link2_yy;
  const Scalar t_link3_5 = t_link3_2 - t_link3_3;
  const Scalar neg_Omega_link3_xx = neg_Omega_link2_yy - t_link3_5;
  const Scalar t_link4_3 = a_link3_x - neg_Omega_link3_xx - link3_k1 * Omega_link3_xz;
  const Scalar neg_omega_link4_x = s_joint4 * omega_link3_z - c_joint4 * neg_omega_link3_x;
  const Scalar t_link4_4 = neg_omega_link4_z * neg_omega_link4_x;
  const Scalar neg_Omega_link4_xz = c_joint4 * neg_Omega_link3_xy + s_joint4 * neg_Omega_link3_zy;
  const Scalar neg_alpha_link4_y = t_link4_4 + neg_Omega_link4_xz;
  const Scalar t_link4_5 = neg_omega_link4_y * neg_omega_link4_x;
  const Scalar neg_alpha_link4_z = alpha_link3_y - qdd[3];
  const Scalar Omega_link4_xy = t_link4_5 + neg_alpha_link4_z;
  const Scalar t_link4_6 = neg_omega_link4_x * neg_omega_link4_x;
  const Scalar t_link4_7 = neg_omega_link4_z * neg_omega_link4_z;
  const Scalar neg_Omega_link4_yy = t_link4_6 + t_link4_7;
  // link5: Omega, angular velocity omega, angular acceleration alpha of (1)
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar omega_link5_z = neg_omega_link4_y + qd[4];
  const Scalar neg_omega_link5_y = s_joint5 * neg_omega_link4_x - c_joint5 * neg_omega_link4_z;
  const Scalar neg_Omega_link5_zy = Omega_link5_yz + omega_link5_z * neg_omega_link5_y * 2.0;
  const Scalar Omega_link5_xz = s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar omega_link5_x = c_joint5 * neg_omega_link4_x + s_joint5 * neg_omega_link4_z;
  const Scalar t_link5_1 = omega_link5_z * omega_link5_x;
  const Scalar alpha_link5_y = Omega_link5_xz - t_link5_1;
  const Scalar Omega_link5_zx = t_link5_1 - alpha_link5_y;
  const Scalar neg_Omega_link3_yy = t_link3_2 + t_link3_3;
  // link4: Omega, acceleration a of (1)
  const Scalar t_link4_8 = t_link4_6 - t_link4_7;
  const Scalar a_link4_x = s_joint4 * t_link4_2 - c_joint4 * t_link4_3;
  const Scalar neg_Omega_link4_xx = neg_Omega_link3_yy - t_link4_8;
  const Scalar t_link5_2 = a_link4_x - neg_Omega_link4_xx;
  const Scalar Omega_link4_zx = t_link4_4 + neg_alpha_link4_y;
  const Scalar neg_Omega_link3_yx = t_link3_4 + neg_alpha_link3_z;
  const Scalar a_link4_z = neg_a_link3_y + neg_Omega_link3_yx + link3_k1 * Omega_link3_yz;
  // link5: acceleration a, Omega, angular acceleration alpha of (1)
  const Scalar t_link5_3 = Omega_link4_zx + a_link4_z;
  const Scalar neg_a_link5_y = c_joint5 * t_link5_3 - s_joint5 * t_link5_2;
  const Scalar t_link5_4 = neg_omega_link5_y * omega_link5_x;
  const Scalar alpha_link5_z = neg_alpha_link4_y + qdd[4];
  const Scalar neg_Omega_link5_xy = t_link5_4 + alpha_link5_z;
  const Scalar t_link5_5 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_6 = omega_link5_z * omega_link5_z;
  const Scalar neg_Omega_link5_yy = t_link5_5 + t_link5_6;
  const Scalar omega_link6_z = neg_omega_link5_y + qd[5];
  const Scalar t_link7_1 = 2.0 * omega_link6_z;
  const Scalar neg_omega_link6_y = s_joint6 * omega_link5_x - c_joint6 * omega_link5_z;
  const Scalar Omega_link6_yz = c_joint6 * neg_Omega_link5_zy - s_joint6 * neg_Omega_link5_xy;
  const Scalar Omega_link7_yz = Omega_link6_yz + t_link7_1 * neg_omega_link6_y;
  // link6: angular velocity omega, Omega, acceleration a of (1)
  const Scalar omega_link6_x = c_joint6 * omega_link5_x + s_joint6 * omega_link5_z;
  const Scalar t_link6_1 = 2.0 * omega_link6_x;
  const Scalar Omega_link6_xz = c_joint6 * neg_Omega_link5_xy + s_joint6 * neg_Omega_link5_zy;
  const Scalar neg_Omega_link6_zx = Omega_link6_xz - omega_link6_z * t_link6_1;
  const Scalar neg_a_link5_x = s_joint5 * t_link5_3 + c_joint5 * t_link5_2;
  const Scalar t_link6_2 = neg_a_link5_x - link4_k1 * Omega_link5_xz;
  const Scalar t_link6_3 = neg_omega_link6_y * omega_link6_x;
  const Scalar neg_alpha_link6_z = alpha_link5_y - qdd[5];
  const Scalar Omega_link7_xz = t_link6_3 - neg_alpha_link6_z;
  const Scalar t_link6_4 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_5 = omega_link6_z * omega_link6_z;
  const Scalar t_link6_6 = t_link6_4 - t_link6_5;
  const Scalar omega_link7_z = neg_omega_link6_y + qd[6];
  const Scalar neg_Omega_link7_zy = Omega_link6_yz - t_link7_1 * qd[6];
  const Scalar a_link6_z = neg_a_link5_y - link4_k1 * Omega_link5_yz;
  // link7: acceleration a, Omega, moment M of (1)
  const Scalar a_link7_y = a_link6_z - link4_k3 * neg_Omega_link6_zx;
  const Scalar Omega_link7_xy = Omega_link6_xz - qdd[6];
  const Scalar neg_Omega_link7_yx = neg_Omega_link6_zx - qdd[6];
  const Scalar Omega_link4_yx = t_link4_5 - neg_alpha_link4_z;
  const Scalar neg_Omega_link6_yx = t_link6_3 + neg_alpha_link6_z;
  const Scalar neg_a_link5_z = Omega_link4_yx + s_joint4 * t_link4_3 + c_joint4 * t_link4_2;
  const Scalar t_link6_7 = neg_a_link5_z + link4_k1 * neg_Omega_link4_yy;
  const Scalar a_link7_z_1 = link4_k3 * neg_Omega_link6_yx + c_joint6 * t_link6_7;
  const Scalar a_link7_z = a_link7_z_1 - s_joint6 * t_link6_2;
  const Scalar neg_Omega_link7_zx = Omega_link7_xz - t_link6_1 * omega_link7_z;
  const Scalar neg_Omega_link6_xx = neg_Omega_link5_yy - t_link6_6;
  const Scalar neg_a_link6_x = s_joint6 * t_link6_7 + c_joint6 * t_link6_2;
  const Scalar neg_a_link7_x = neg_a_link6_x + link4_k3 * neg_Omega_link6_xx;
  const Scalar t_link7_2 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_3 = link7_I5 * s_link7 + link7_I6 * c_link7;
  const Scalar t_link7_4 = s_link7 * t_link7_3;
  const Scalar t_link7_5 = link7_I3 * c_link7 - link7_I4 * s_link7;
  const Scalar t_link7_6 = link7_I3 * s_link7 + link7_I4 * c_link7;
  const Scalar t_link7_7 = link7_I10 + t_link7_4;
  const Scalar t_link7_8 = link7_I11 - c_link7 * t_link7_3;
  const Scalar t_link7_9 = link7_I9 * c_link7;
  const Scalar t_link7_10 = link7_I9 * s_link7;
  const Scalar t_link7_11 = link7_I12 - t_link7_4;
  const Scalar M_link7_z_1 = neg_a_link7_x * t_link7_10 - Omega_link7_xy * t_link7_7;
  const Scalar M_link7_z_2 = M_link7_z_1 + Omega_link7_yz * t_link7_5;
  const Scalar M_link7_z_3 = M_link7_z_2 - neg_Omega_link7_yx * t_link7_11;
  const Scalar M_link7_z_4 = M_link7_z_3 - Omega_link7_xz * t_link7_6;
  const Scalar M_link7_z = M_link7_z_4 + t_link6_6 * t_link7_8 + a_link7_y * t_link7_9;
  tau[6] = M_link7_z;
  const Scalar neg_F_link7_z_1 = neg_Omega_link7_zy * t_link7_10;
  const Scalar neg_F_link7_z_2 = neg_F_link7_z_1 + neg_Omega_link7_zx * t_link7_9;
  const Scalar neg_F_link7_z = neg_F_link7_z_2 - link6_I12 * a_link7_z;
  const Scalar neg_Omega_link6_yy = t_link6_4 + t_link6_5;
  const Scalar neg_M_link6_z_1 = link6_I9 * (neg_Omega_link6_xx - neg_Omega_link6_yy);
  const Scalar neg_M_link6_z_2 = neg_M_link6_z_1 - link4_k3 * neg_F_link7_z;
  const Scalar neg_M_link6_z_3 = neg_M_link6_z_2 + link6_I10 * neg_alpha_link6_z;
  const Scalar neg_M_link6_z_4 = neg_M_link6_z_3 - link6_I11 * t_link6_3;
  const Scalar neg_M_link6_z_5 = neg_M_link6_z_4 + neg_Omega_link7_zy * t_link7_8;
  const Scalar neg_M_link6_z_6 = neg_M_link6_z_5 - link6_I8 * Omega_link6_yz;
  const Scalar neg_M_link6_z_7 = neg_M_link6_z_6 - neg_Omega_link7_zx * t_link7_11;
  const Scalar neg_M_link6_z_8 = neg_M_link6_z_7 - t_link7_5 * (t_link6_4 - t_link7_2);
  const Scalar neg_M_link6_z_9 = neg_M_link6_z_8 + a_link7_z * t_link7_9;
  const Scalar neg_M_link6_z_10 = neg_M_link6_z_9 + link6_I3 * neg_a_link6_x;
  const Scalar neg_M_link6_z_11 = neg_M_link6_z_10 - Omega_link7_xy * t_link7_6;
  const Scalar neg_M_link6_z = neg_M_link6_z_11 + link6_I5 * Omega_link6_xz;
  tau[5] = -neg_M_link6_z;
  const Scalar neg_M_link6_x_1 = link6_I5 * (neg_Omega_link5_yy - neg_Omega_link6_yy);
  const Scalar neg_M_link6_x_2 = neg_M_link6_x_1 + link6_I3 * a_link6_z;
  const Scalar neg_M_link6_x_3 = neg_M_link6_x_2 - neg_Omega_link7_yx * t_link7_5;
  const Scalar neg_M_link6_x_4 = neg_M_link6_x_3 - link6_I8 * neg_Omega_link6_yx;
  const Scalar neg_M_link6_x_5 = neg_M_link6_x_4 + link6_I13 * Omega_link7_yz;
  const Scalar neg_M_link6_x_6 = neg_M_link6_x_5 + neg_Omega_link7_zy * t_link7_7;
  const Scalar neg_M_link6_x_7 = neg_M_link6_x_6 - neg_Omega_link7_zx * t_link7_8;
  const Scalar neg_M_link6_x_8 = neg_M_link6_x_7 - a_link7_z * t_link7_10;
  const Scalar neg_M_link6_x_9 = neg_M_link6_x_8 + t_link7_6 * (t_link6_5 - t_link7_2);
  const Scalar neg_M_link6_x = neg_M_link6_x_9 - link6_I9 * neg_Omega_link6_zx;
  const Scalar neg_F_link6_x_1 = link6_I12 * neg_a_link7_x - link6_I3 * Omega_link7_xz;
  const Scalar neg_F_link6_x_2 = neg_F_link6_x_1 + t_link7_9 * (t_link6_5 + t_link7_2);
  const Scalar neg_F_link6_x = neg_F_link6_x_2 - Omega_link7_xy * t_link7_10;
  const Scalar F_link7_y_1 = link6_I12 * a_link7_y - neg_Omega_link7_yx * t_link7_9;
  const Scalar F_link7_y = F_link7_y_1 - t_link7_10 * (t_link6_4 + t_link7_2);
  const Scalar F_link6_z = F_link7_y + link6_I3 * Omega_link7_yz;
  const Scalar neg_M_link6_y_1 = M_link7_z + link4_k3 * F_link7_y + link6_I5 * Omega_link7_xz;
  const Scalar neg_M_link6_y_2 = neg_M_link6_y_1 - link6_I8 * t_link6_6;
  const Scalar neg_M_link6_y_3 = neg_M_link6_y_2 + link6_I9 * Omega_link7_yz;
  const Scalar neg_M_link6_y = neg_M_link6_y_3 - link6_I14 * neg_Omega_link6_zx;
  // link5: Omega of (1)
  const Scalar neg_Omega_link5_yx = t_link5_4 - alpha_link5_z;
  const Scalar t_link5_7 = t_link5_5 - t_link5_6;
  const Scalar t_link5_8 = neg_Omega_link4_yy - neg_Omega_link5_yy;
  // link6: moment M, force F of (1)
  const Scalar neg_M_link5_z_1 = s_joint6 * neg_M_link6_x - link5_I10 * t_link5_4;
  const Scalar neg_M_link5_z_2 = neg_M_link5_z_1 + c_joint6 * neg_M_link6_y;
  const Scalar neg_M_link5_z_3 = neg_M_link5_z_2 - link5_I5 * neg_a_link5_x;
  const Scalar neg_M_link5_z_4 = neg_M_link5_z_3 - link5_I13 * alpha_link5_z;
  const Scalar neg_M_link5_z_5 = neg_M_link5_z_4 + link5_I7 * Omega_link5_xz;
  const Scalar neg_M_link5_z_6 = neg_M_link5_z_5 + link5_I2 * neg_a_link5_y;
  const Scalar neg_M_link5_z_7 = neg_M_link5_z_6 + link5_I11 * (t_link5_7 - t_link5_8);
  const Scalar neg_M_link5_z = neg_M_link5_z_7 - link5_I8 * Omega_link5_yz;
  tau[4] = -neg_M_link5_z;
  const Scalar F_link6_y = neg_F_link7_z + link6_I3 * neg_Omega_link6_yy;
  const Scalar t_link6_8 = s_joint6 * F_link6_y + c_joint6 * neg_F_link6_x;
  const Scalar neg_F_link5_x_1 = t_link6_8 + link5_I2 * (neg_Omega_link4_yy - t_link5_7);
  const Scalar neg_F_link5_x_2 = neg_F_link5_x_1 - link4_I9 * neg_a_link5_x;
  const Scalar neg_F_link5_x = neg_F_link5_x_2 + link5_I5 * neg_Omega_link5_xy;
  const Scalar neg_F_link5_y_1 = F_link6_z + link5_I5 * neg_Omega_link5_yy;
  const Scalar neg_F_link5_y_2 = neg_F_link5_y_1 + link5_I2 * neg_Omega_link5_yx;
  const Scalar neg_F_link5_y = neg_F_link5_y_2 - link4_I9 * neg_a_link5_y;
  const Scalar F_link5_z_1 = c_joint6 * F_link6_y - s_joint6 * neg_F_link6_x;
  const Scalar F_link5_z_2 = F_link5_z_1 + link5_I2 * Omega_link5_zx + link4_I9 * neg_a_link5_z;
  const Scalar F_link5_z = F_link5_z_2 - link5_I5 * neg_Omega_link5_zy;
  const Scalar t_link4_9 = neg_Omega_link4_yy - neg_Omega_link3_yy;
  const Scalar neg_M_link4_z_1 = t_link4_8 + t_link4_9;
  const Scalar neg_M_link5_x_1 = c_joint6 * neg_M_link6_x + link5_I9 * neg_Omega_link5_zy;
  const Scalar neg_M_link5_x_2 = neg_M_link5_x_1 - link5_I11 * Omega_link5_zx;
  const Scalar neg_M_link5_x_3 = neg_M_link5_x_2 - link4_k1 * F_link6_z;
  const Scalar neg_M_link5_x_4 = neg_M_link5_x_3 + link5_I7 * t_link5_8;
  const Scalar neg_M_link5_x_5 = neg_M_link5_x_4 + link5_I5 * neg_a_link5_z;
  const Scalar neg_M_link5_x_6 = neg_M_link5_x_5 - s_joint6 * neg_M_link6_y;
  const Scalar neg_M_link5_x = neg_M_link5_x_6 - link5_I8 * neg_Omega_link5_yx;
  // link5: moment M of (1)
  const Scalar M_link5_y_1 = neg_M_link6_z - link5_I12 * Omega_link5_zx;
  const Scalar M_link5_y_2 = M_link5_y_1 + link5_I11 * neg_Omega_link5_zy;
  const Scalar M_link5_y_3 = M_link5_y_2 + link5_I2 * neg_a_link5_z - link4_k1 * t_link6_8;
  const Scalar M_link5_y = M_link5_y_3 - link5_I7 * neg_Omega_link5_xy + link5_I8 * t_link5_7;
  const Scalar neg_M_link4_z_2 = F_link5_z + link4_I10 * neg_Omega_link4_yz;
  const Scalar neg_M_link4_z_3 = neg_M_link4_z_2 + link4_I14 * neg_alpha_link4_z;
  const Scalar neg_M_link4_z_4 = neg_M_link4_z_3 - s_joint5 * neg_M_link5_x;
  const Scalar neg_M_link4_z_5 = neg_M_link4_z_4 - link4_I8 * a_link4_x;
  const Scalar neg_M_link4_z_6 = neg_M_link4_z_5 + link4_I7 * neg_Omega_link4_xz;
  const Scalar neg_M_link4_z_7 = neg_M_link4_z_6 - link4_I12 * neg_M_link4_z_1;
  const Scalar neg_M_link4_z = neg_M_link4_z_7 + link4_I15 * t_link4_5 + c_joint5 * M_link5_y;
  tau[3] = -neg_M_link4_z;
  const Scalar neg_M_link3_z_1 = neg_Omega_link3_xx - neg_Omega_link3_yy;
  const Scalar t_link5_9 = c_joint5 * neg_F_link5_y + s_joint5 * neg_F_link5_x;
  // link4: moment M, force F of (1)
  const Scalar M_link4_y_1 = neg_M_link5_z - t_link5_9 + link4_I12 * Omega_link4_zy;
  const Scalar M_link4_y_2 = M_link4_y_1 - link4_I13 * Omega_link4_zx;
  const Scalar M_link4_y = M_link4_y_2 - link4_I7 * Omega_link4_xy + link4_I10 * t_link4_8;
  const Scalar neg_M_link4_x_1 = link4_I8 * a_link4_z + link4_I7 * t_link4_9;
  const Scalar neg_M_link4_x_2 = neg_M_link4_x_1 + link4_I12 * Omega_link4_zx;
  const Scalar neg_M_link4_x_3 = neg_M_link4_x_2 + link4_I10 * Omega_link4_yx;
  const Scalar neg_M_link4_x_4 = neg_M_link4_x_3 - link4_I11 * Omega_link4_zy;
  const Scalar neg_M_link4_x = neg_M_link4_x_4 - s_joint5 * M_link5_y - c_joint5 * neg_M_link5_x;
  const Scalar F_link4_z = t_link5_9 - link4_I8 * Omega_link4_zy;
  const Scalar neg_M_link3_z_2 = F_link4_z - link3_I12 * a_link3_x + link3_I13 * neg_a_link3_y;
  const Scalar neg_M_link3_z_3 = neg_M_link3_z_2 + link3_I9 * t_link3_4;
  const Scalar neg_M_link3_z_4 = neg_M_link3_z_3 + link3_I8 * neg_alpha_link3_z;
  const Scalar neg_M_link3_z_5 = neg_M_link3_z_4 - s_joint4 * neg_M_link4_x;
  const Scalar neg_M_link3_z_6 = neg_M_link3_z_5 + link3_I7 * neg_M_link3_z_1;
  const Scalar neg_M_link3_z_7 = neg_M_link3_z_6 + c_joint4 * M_link4_y;
  const Scalar neg_M_link3_z_8 = neg_M_link3_z_7 + link3_I6 * Omega_link3_yz;
  const Scalar neg_M_link3_z = neg_M_link3_z_8 - link3_I3 * Omega_link3_xz;
  tau[2] = -neg_M_link3_z;
  const Scalar M_link3_x_1 = neg_Omega_link2_yy - neg_Omega_link3_yy;
  const Scalar F_link4_x_1 = c_joint5 * neg_F_link5_x - link4_I8 * Omega_link4_xy;
  const Scalar F_link4_x = F_link4_x_1 - s_joint5 * neg_F_link5_y;
  // link2: moment M of (1)
  const Scalar M_link2_z_1 = link2_G1 + link2_I2 * qdd[0];
  const Scalar t_link2_5 = t_link2_1 - t_link2_2;
  const Scalar t_link2_6 = neg_Omega_link2_yy - qd[0] * qd[0];
  const Scalar M_link2_z_2 = t_link2_5 + t_link2_6;
  const Scalar M_link2_z_3 = link2_G2 - link2_I8 * qdd[0];
  const Scalar neg_F_link4_y = F_link5_z - link4_I8 * neg_Omega_link4_yy;
  // link3: moment M of (1)
  const Scalar M_link3_y_1 = neg_M_link4_z + link3_G1 * c_joint2;
  const Scalar M_link3_y_2 = M_link3_y_1 - (c_joint4 - link3_k1 * s_joint4) * neg_F_link4_y;
  const Scalar M_link3_y_3 = M_link3_y_2 + (s_joint4 + link3_k1 * c_joint4) * F_link4_x;
  const Scalar M_link3_y_4 = M_link3_y_3 - link3_I7 * neg_Omega_link3_zy;
  const Scalar M_link3_y_5 = M_link3_y_4 + link3_I3 * neg_Omega_link3_xy;
  const Scalar M_link3_y = M_link3_y_5 - link3_I6 * t_link3_5 + link3_I11 * neg_Omega_link3_zx;
  const Scalar M_link3_x_2 = link3_G2 * c_joint2 + link3_I3 * M_link3_x_1;
  const Scalar M_link3_x_3 = M_link3_x_2 - link3_I10 * neg_Omega_link3_zy;
  const Scalar M_link3_x_4 = M_link3_x_3 - link3_k1 * F_link4_z + s_joint4 * M_link4_y;
  const Scalar M_link3_x_5 = M_link3_x_4 - link3_I6 * neg_Omega_link3_yx;
  const Scalar M_link3_x = M_link3_x_5 + link3_I7 * neg_Omega_link3_zx + c_joint4 * neg_M_link4_x;
  // link2: moment M, Omega of (1)
  const Scalar M_link2_z_4 = link2_I9 * qdd[1] + c_joint2 * M_link2_z_1;
  const Scalar M_link2_z_5 = M_link2_z_4 - link2_I7 * M_link2_z_2 - s_joint2 * M_link2_z_3;
  tau[1] = M_link2_z_5 + link2_I6 * t_link2_4 + c_joint3 * M_link3_y + s_joint3 * M_link3_x;
  const Scalar Omega_link2_yx = t_link2_4 + qdd[1];
  const Scalar M_link2_x_1 = link2_I2 * t_link2_6 + c_joint3 * M_link3_x;
  const Scalar M_link2_x_2 = M_link2_x_1 - link2_I8 * Omega_link2_yx - s_joint3 * M_link3_y;
  const Scalar M_link2_x_3 = M_link2_x_2 - link2_I7 * neg_Omega_link2_zx;
  const Scalar M_link2_x = M_link2_x_3 - link2_I11 * neg_Omega_link2_zy;
  const Scalar M_link2_y_1 = neg_M_link3_z + link2_I10 * neg_Omega_link2_zx;
  const Scalar M_link2_y_2 = M_link2_y_1 + link2_I8 * t_link2_5;
  const Scalar M_link2_y_3 = M_link2_y_2 + link2_I7 * neg_Omega_link2_zy;
  const Scalar M_link2_y = M_link2_y_3 + link2_I2 * Omega_link2_xy;
  // link1: moment M of (1)
  tau[0] = link1_I2 * qdd[0] - s_joint2 * M_link2_x - c_joint2 * M_link2_y;
}

// Lengths inside are in units of L, a distance between joint3 and joint4:
//   L = 0.0825 m
// Names: vectors F_ in N m/L, a_ in L/s^2, h_ in kg m^2/L; all others are of values in SI units;
// numbered ones (t_) by what they are made of. Arguments and results are in SI units.
void forward_dynamics(const Scalar q[7], const Scalar qd[7], const Scalar tau[7],
                      Scalar qdd[7]) noexcept {
  const Scalar angle_link7 = link7_k1 + q[6];
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[1], q[2], q[3], q[4]);
  sines_cosines(sines + 4, cosines + 4, q[5], angle_link7);
  const Scalar s_joint2 = sines[0];
  const Scalar c_joint2 = cosines[0];
  const Scalar s_joint3 = sines[1];
  const Scalar c_joint3 = cosines[1];
  const Scalar s_joint4 = sines[2];
  const Scalar c_joint4 = cosines[2];
  const Scalar s_joint5 = sines[3];
  const Scalar c_joint5 = cosines[3];
  const Scalar s_joint6 = sines[4];
  const Scalar c_joint6 = cosines[4];
  const Scalar s_link7 = sines[5];
  const Scalar c_link7 = cosines[5];
  const Scalar t_link2_1 = link2_I5 * c_joint2 + link2_I6 * s_joint2;
  const Scalar t_link2_2 = qd[0] * (link2_I7 - c_joint2 * t_link2_1);
  // link3: angular velocity omega, Omega, angular acceleration alpha of (1)
  const Scalar t_link3_1 = s_joint2 * qd[0];
  const Scalar t_link3_2 = c_joint3 * qd[1];
  const Scalar omega_link3_y = t_link3_2 + s_joint3 * t_link3_1;
  const Scalar t_link3_3 = c_joint2 * qd[0];
  const Scalar omega_link3_z = qd[2] + t_link3_3;
  const Scalar t_link3_4 = omega_link3_y * omega_link3_z;
  const Scalar neg_alpha_link3_x = t_link3_2 * t_link3_3 - omega_link3_y * qd[2];
  const Scalar Omega_link3_yz = t_link3_4 + neg_alpha_link3_x;
  const Scalar Omega_link3_zy = t_link3_4 - neg_alpha_link3_x;
  const Scalar t_link3_5 = s_joint3 * qd[1];
  const Scalar omega_link3_x = t_link3_5 - c_joint3 * t_link3_1;
  const Scalar t_link3_6 = omega_link3_x * omega_link3_x;
  const Scalar t_link3_7 = omega_link3_y * omega_link3_y;
  const Scalar t_link3_8 = omega_link3_z * omega_link3_z;
  const Scalar alpha_link3_y = t_link3_3 * t_link3_5 - qd[2] * omega_link3_x;
  const Scalar t_link3_9 = omega_link3_z * omega_link3_x;
  const Scalar neg_Omega_link3_yy = t_link3_6 + t_link3_8;
  const Scalar t_link3_10 = omega_link3_y * omega_link3_x;
  const Scalar neg_alpha_link3_z = qd[1] * t_link3_1;
  const Scalar Omega_link3_xy = t_link3_10 + neg_alpha_link3_z;
  const Scalar t_link3_11 = link4_p1 * s_joint2;
  const Scalar a_link3_x = c_joint3 * t_link3_11;
  const Scalar neg_a_link3_y = s_joint3 * t_link3_11;
  const Scalar Omega_link3_xz = alpha_link3_y + t_link3_9;
  const Scalar neg_Omega_link3_xx = t_link3_7 + t_link3_8;
  const Scalar t_link4_1 = a_link3_x - neg_Omega_link3_xx - link3_k1 * Omega_link3_xz;
  const Scalar neg_Omega_link3_zx = alpha_link3_y - t_link3_9;
  // link4: angular velocity omega, Omega, acceleration a of (1)
  const Scalar neg_omega_link4_z = omega_link3_y - qd[3];
  const Scalar neg_Omega_link4_yz = s_joint4 * Omega_link3_xy - c_joint4 * Omega_link3_zy;
  const Scalar omega_link4_y = s_joint4 * omega_link3_x - c_joint4 * omega_link3_z;
  const Scalar Omega_link4_zy = neg_Omega_link4_yz - neg_omega_link4_z * omega_link4_y * 2.0;
  const Scalar neg_omega_link4_x = s_joint4 * omega_link3_z + c_joint4 * omega_link3_x;
  const Scalar t_link4_2 = neg_omega_link4_z * neg_omega_link4_x;
  const Scalar Omega_link4_xz = s_joint4 * Omega_link3_zy + c_joint4 * Omega_link3_xy;
  const Scalar alpha_link5_z = t_link4_2 - Omega_link4_xz;
  const Scalar Omega_link3_yx = t_link3_10 - neg_alpha_link3_z;
  const Scalar a_link4_z = neg_a_link3_y - Omega_link3_yx + link3_k1 * Omega_link3_yz;
  const Scalar t_link4_3 = neg_omega_link4_x * neg_omega_link4_x;
  const Scalar t_link4_4 = neg_omega_link4_z * neg_omega_link4_z;
  const Scalar neg_Omega_link4_yy = t_link4_3 + t_link4_4;
  const Scalar t_link4_5 = omega_link4_y * neg_omega_link4_x;
  const Scalar Omega_link4_xy = alpha_link3_y - t_link4_5;
  const Scalar neg_Omega_link3_zz = t_link3_6 + t_link3_7;
  const Scalar Omega_link4_zx = t_link4_2 + alpha_link5_z;
  const Scalar t_link5_1 = a_link4_z + Omega_link4_zx;
  const Scalar t_link4_6 = neg_Omega_link3_zx + link4_p1 * c_joint2;
  const Scalar t_link4_7 = t_link4_6 - link3_k1 * neg_Omega_link3_zz;
  const Scalar neg_a_link4_x = c_joint4 * t_link4_1 - s_joint4 * t_link4_7;
  const Scalar t_link4_8 = t_link4_3 - t_link4_4;
  // link5: acceleration a, Omega, angular velocity omega of (1)
  const Scalar t_link5_2 = t_link4_8 - (neg_Omega_link3_yy + neg_a_link4_x);
  const Scalar neg_a_link5_x = s_joint5 * t_link5_1 + c_joint5 * t_link5_2;
  const Scalar Omega_link5_yz = c_joint5 * Omega_link4_zy - s_joint5 * Omega_link4_xy;
  const Scalar omega_link5_y = c_joint5 * neg_omega_link4_z - s_joint5 * neg_omega_link4_x;
  const Scalar neg_omega_link5_z = omega_link4_y - qd[4];
  const Scalar neg_Omega_link5_zy = Omega_link5_yz + omega_link5_y * neg_omega_link5_z * 2.0;
  const Scalar omega_link5_x = s_joint5 * neg_omega_link4_z + c_joint5 * neg_omega_link4_x;
  const Scalar t_link5_3 = neg_omega_link5_z * omega_link5_x;
  const Scalar Omega_link5_xz = s_joint5 * Omega_link4_zy + c_joint5 * Omega_link4_xy;
  const Scalar alpha_link5_y = t_link5_3 + Omega_link5_xz;
  const Scalar neg_Omega_link5_zx = t_link5_3 + alpha_link5_y;
  const Scalar neg_a_link5_y = c_joint5 * t_link5_1 - s_joint5 * t_link5_2;
  const Scalar neg_Omega_link4_yx = alpha_link3_y + t_link4_5;
  const Scalar a_link5_z = neg_Omega_link4_yx - s_joint4 * t_link4_1 - c_joint4 * t_link4_7;
  const Scalar t_link5_4 = omega_link5_y * omega_link5_x;
  const Scalar neg_Omega_link5_xy = alpha_link5_z - t_link5_4;
  const Scalar t_link5_5 = omega_link5_x * omega_link5_x;
  const Scalar t_link5_6 = neg_omega_link5_z * neg_omega_link5_z;
  const Scalar Omega_link5_yx = alpha_link5_z + t_link5_4;
  const Scalar neg_Omega_link5_yy = t_link5_5 + t_link5_6;
  const Scalar Omega_link7_xy = s_joint6 * neg_Omega_link5_zy + c_joint6 * neg_Omega_link5_xy;
  // link6: angular velocity omega, Omega, acceleration a of (1)
  const Scalar omega_link6_x = c_joint6 * omega_link5_x - s_joint6 * neg_omega_link5_z;
  const Scalar neg_omega_link6_z = omega_link5_y - qd[5];
  const Scalar t_link6_1 = 2.0 * omega_link6_x;
  const Scalar neg_Omega_link6_zx = Omega_link7_xy + neg_omega_link6_z * t_link6_1;
  const Scalar t_link7_1 = 2.0 * neg_omega_link6_z;
  const Scalar neg_omega_link6_y = s_joint6 * omega_link5_x + c_joint6 * neg_omega_link5_z;
  const Scalar Omega_link6_yz = c_joint6 * neg_Omega_link5_zy - s_joint6 * neg_Omega_link5_xy;
  const Scalar Omega_link7_yz = Omega_link6_yz - t_link7_1 * neg_omega_link6_y;
  const Scalar t_link6_2 = neg_a_link5_x - link4_k1 * Omega_link5_xz;
  const Scalar a_link6_z = neg_a_link5_y - link4_k1 * Omega_link5_yz;
  const Scalar t_link6_3 = omega_link6_x * neg_omega_link6_y;
  const Scalar Omega_link6_xy = alpha_link5_y - t_link6_3;
  const Scalar neg_Omega_link6_yx = alpha_link5_y + t_link6_3;
  const Scalar t_link6_4 = omega_link6_x * omega_link6_x;
  const Scalar t_link6_5 = neg_omega_link6_z * neg_omega_link6_z;
  const Scalar t_link6_6 = t_link6_4 - t_link6_5;
  const Scalar neg_Omega_link6_yy = t_link6_4 + t_link6_5;
  // link7: acceleration a, angular velocity omega, Omega of (1)
  const Scalar a_link7_y = a_link6_z - link4_k3 * neg_Omega_link6_zx;
  const Scalar omega_link7_z = neg_omega_link6_y + qd[6];
  const Scalar neg_Omega_link7_zy = Omega_link7_yz + t_link7_1 * omega_link7_z;
  const Scalar t_link6_7 = a_link5_z - link4_k1 * neg_Omega_link4_yy;
  const Scalar neg_a_link6_x = c_joint6 * t_link6_2 - s_joint6 * t_link6_7;
  const Scalar neg_a_link7_x = neg_a_link6_x + link4_k3 * (neg_Omega_link5_yy - t_link6_6);
  const Scalar a_link7_z_1 = link4_k3 * neg_Omega_link6_yx - c_joint6 * t_link6_7;
  const Scalar a_link7_z = a_link7_z_1 - s_joint6 * t_link6_2;
  const Scalar Omega_link7_zx = Omega_link6_xy + t_link6_1 * omega_link7_z;
  const Scalar t_link7_2 = omega_link7_z * omega_link7_z;
  const Scalar t_link7_3 = link7_I5 * s_link7 + link7_I6 * c_link7;
  const Scalar t_link7_4 = s_link7 * t_link7_3;
  const Scalar t_link7_5 = c_link7 * t_link7_3;
  const Scalar I_link7_xy = link7_I11 - t_link7_5;
  const Scalar neg_I_link7_xz = link7_I3 * c_link7 - link7_I4 * s_link7;
  const Scalar neg_I_link7_yz = link7_I3 * s_link7 + link7_I4 * c_link7;
  const Scalar h_link7_y = link7_I9 * s_link7;
  const Scalar h_link7_x = link7_I9 * c_link7;
  const Scalar F_link7_y_1 = link6_I12 * a_link7_y - neg_Omega_link6_zx * h_link7_x;
  const Scalar F_link7_y = F_link7_y_1 - h_link7_y * (t_link6_4 + t_link7_2);
  const Scalar neg_I_link6_yz = link6_I5 - neg_I_link7_yz;
  const Scalar I_link6_xy = link6_I9 + neg_I_link7_xz;
  const Scalar I_link7_xx = link7_I10 + t_link7_4;
  const Scalar t_link6_8 = neg_Omega_link5_yy - neg_Omega_link6_yy;
  const Scalar neg_M_link6_x_1 = link6_I3 * a_link6_z - neg_Omega_link6_zx * I_link6_xy;
  const Scalar neg_M_link6_x_2 = neg_M_link6_x_1 + neg_Omega_link7_zy * I_link7_xx;
  const Scalar neg_M_link6_x_3 = neg_M_link6_x_2 + link6_I13 * Omega_link7_yz;
  const Scalar neg_M_link6_x_4 = t_link6_5 - t_link7_2;
  const Scalar neg_M_link6_x_5 = neg_M_link6_x_3 + neg_I_link7_yz * neg_M_link6_x_4;
  const Scalar neg_M_link6_x_6 = neg_M_link6_x_5 - a_link7_z * h_link7_y;
  const Scalar neg_M_link6_x_7 = neg_M_link6_x_6 + Omega_link7_zx * I_link7_xy;
  const Scalar neg_M_link6_x_8 = neg_M_link6_x_7 - link6_I8 * neg_Omega_link6_yx;
  const Scalar neg_M_link6_x = neg_M_link6_x_8 + link6_I5 * t_link6_8;
  const Scalar t_link7_6 = neg_Omega_link7_zy * h_link7_y - Omega_link7_zx * h_link7_x;
  const Scalar F_link6_y = t_link7_6 + link6_I3 * neg_Omega_link6_yy - link6_I12 * a_link7_z;
  const Scalar neg_F_link7_x_1 = link6_I12 * neg_a_link7_x - Omega_link7_xy * h_link7_y;
  const Scalar neg_F_link7_x = neg_F_link7_x_1 + h_link7_x * (t_link6_5 + t_link7_2);
  const Scalar neg_F_link6_x = neg_F_link7_x + link6_I3 * Omega_link6_xy;
  const Scalar I_link7_yy = link7_I12 - t_link7_4;
  const Scalar t_link5_7 = t_link5_5 - t_link5_6;
  // link6: force F of (1)
  const Scalar F_link6_z = F_link7_y + link6_I3 * Omega_link7_yz;
  const Scalar neg_F_link5_y_1 = F_link6_z + link5_I5 * neg_Omega_link5_yy;
  const Scalar neg_F_link5_y_2 = neg_F_link5_y_1 - link5_I2 * Omega_link5_yx;
  const Scalar neg_F_link5_y = neg_F_link5_y_2 - link4_I9 * neg_a_link5_y;
  const Scalar t_link6_9 = s_joint6 * F_link6_y + c_joint6 * neg_F_link6_x;
  const Scalar neg_Omega_link5_xx = neg_Omega_link4_yy - t_link5_7;
  const Scalar neg_F_link5_x_1 = t_link6_9 + link5_I2 * neg_Omega_link5_xx;
  const Scalar neg_F_link5_x_2 = neg_F_link5_x_1 + link5_I5 * neg_Omega_link5_xy;
  const Scalar neg_F_link5_x = neg_F_link5_x_2 - link4_I9 * neg_a_link5_x;
  const Scalar neg_F_link4_x_1 = s_joint5 * neg_F_link5_y + link4_I8 * Omega_link4_xy;
  const Scalar neg_F_link4_x = neg_F_link4_x_1 - c_joint5 * neg_F_link5_x;
  // link7: moment M of (1)
  const Scalar M_link7_z_1 = a_link7_y * h_link7_x + neg_a_link7_x * h_link7_y;
  const Scalar M_link7_z_2 = M_link7_z_1 + Omega_link7_yz * neg_I_link7_xz;
  const Scalar M_link7_z_3 = M_link7_z_2 - Omega_link7_xy * I_link7_xx;
  const Scalar M_link7_z_4 = M_link7_z_3 - neg_Omega_link6_zx * I_link7_yy;
  const Scalar M_link7_z_5 = M_link7_z_4 + t_link6_6 * I_link7_xy;
  const Scalar M_link7_z = M_link7_z_5 + Omega_link6_xy * neg_I_link7_yz;
  const Scalar neg_M_link6_y_1 = M_link7_z + link4_k3 * F_link7_y;
  const Scalar neg_M_link6_y_2 = neg_M_link6_y_1 - link6_I14 * neg_Omega_link6_zx;
  const Scalar neg_M_link6_y_3 = neg_M_link6_y_2 - link6_I8 * t_link6_6;
  const Scalar neg_M_link6_y_4 = neg_M_link6_y_3 + link6_I9 * Omega_link7_yz;
  const Scalar neg_M_link6_y = neg_M_link6_y_4 - link6_I5 * Omega_link6_xy;
  const Scalar h_link6_x = link6_I7 + h_link7_x;
  const Scalar neg_M_link6_z_1 = link6_I3 * neg_a_link6_x - link6_I11 * t_link6_3;
  const Scalar neg_M_link6_z_2 = neg_M_link6_z_1 - link6_I8 * Omega_link6_yz;
  const Scalar neg_M_link6_z_3 = neg_M_link6_z_2 - link4_k3 * t_link7_6;
  const Scalar neg_M_link6_z_4 = neg_M_link6_z_3 - link6_I9 * (t_link6_6 - t_link6_8);
  const Scalar neg_M_link6_z_5 = neg_M_link6_z_4 + Omega_link7_xy * neg_I_link6_yz;
  const Scalar neg_M_link6_z_6 = neg_M_link6_z_5 + a_link7_z * h_link6_x;
  const Scalar neg_M_link6_z_7 = neg_M_link6_z_6 + neg_Omega_link7_zy * I_link7_xy;
  const Scalar neg_M_link6_z_8 = neg_M_link6_z_7 + link6_I10 * alpha_link5_y;
  const Scalar neg_M_link6_z_9 = t_link6_4 - t_link7_2;
  const Scalar neg_M_link6_z_10 = neg_M_link6_z_8 - neg_I_link7_xz * neg_M_link6_z_9;
  const Scalar neg_M_link6_z = neg_M_link6_z_10 + Omega_link7_zx * I_link7_yy;
  // link5: moment M of (1)
  const Scalar M_link5_y_1 = neg_M_link6_z - link5_I2 * a_link5_z - link4_k1 * t_link6_9;
  const Scalar M_link5_y_2 = M_link5_y_1 - link5_I7 * neg_Omega_link5_xy;
  const Scalar M_link5_y_3 = M_link5_y_2 + link5_I8 * t_link5_7;
  const Scalar M_link5_y_4 = M_link5_y_3 + link5_I12 * neg_Omega_link5_zx;
  const Scalar M_link5_y = M_link5_y_4 + link5_I11 * neg_Omega_link5_zy;
  const Scalar t_link5_8 = c_joint5 * neg_F_link5_y + s_joint5 * neg_F_link5_x;
  const Scalar neg_M_link5_z_1 = link5_I11 * (neg_Omega_link5_yy - neg_Omega_link5_xx);
  // link6: moment M of (1)
  const Scalar neg_M_link5_z_2 = s_joint6 * neg_M_link6_x + neg_M_link5_z_1;
  const Scalar neg_M_link5_z_3 = neg_M_link5_z_2 - link5_I9 * neg_Omega_link5_xy;
  const Scalar neg_M_link5_z_4 = neg_M_link5_z_3 - link5_I5 * neg_a_link5_x;
  const Scalar neg_M_link5_z_5 = neg_M_link5_z_4 + link5_I7 * Omega_link5_xz;
  const Scalar neg_M_link5_z_6 = neg_M_link5_z_5 + link5_I2 * neg_a_link5_y;
  const Scalar neg_M_link5_z_7 = neg_M_link5_z_6 - link5_I8 * Omega_link5_yz;
  const Scalar neg_M_link5_z_8 = neg_M_link5_z_7 + c_joint6 * neg_M_link6_y;
  const Scalar neg_M_link5_z = neg_M_link5_z_8 - link5_I12 * Omega_link5_yx;
  // link5: moment M of (1)
  const Scalar neg_M_link4_y_1 = t_link5_8 - neg_M_link5_z - link4_I10 * t_link4_8;
  const Scalar neg_M_link4_y_2 = neg_M_link4_y_1 + link4_I13 * Omega_link4_zx;
  const Scalar neg_M_link4_y_3 = neg_M_link4_y_2 - link4_I12 * Omega_link4_zy;
  const Scalar neg_M_link4_y = neg_M_link4_y_3 + link4_I7 * Omega_link4_xy;
  // link6: moment M of (1)
  const Scalar neg_M_link5_x_1 = c_joint6 * neg_M_link6_x - link4_k1 * F_link6_z;
  const Scalar neg_M_link5_x_2 = neg_M_link5_x_1 + link5_I8 * Omega_link5_yx;
  const Scalar neg_M_link5_x_3 = neg_M_link5_x_2 - s_joint6 * neg_M_link6_y;
  const Scalar neg_M_link5_x_4 = neg_Omega_link4_yy - neg_Omega_link5_yy;
  const Scalar neg_M_link5_x_5 = neg_M_link5_x_3 + link5_I7 * neg_M_link5_x_4;
  const Scalar neg_M_link5_x_6 = neg_M_link5_x_5 - link5_I5 * a_link5_z;
  const Scalar neg_M_link5_x_7 = neg_M_link5_x_6 + link5_I9 * neg_Omega_link5_zy;
  const Scalar neg_M_link5_x = neg_M_link5_x_7 + link5_I11 * neg_Omega_link5_zx;
  const Scalar t_link4_9 = neg_Omega_link3_yy - neg_Omega_link4_yy;
  // link5: moment M of (1)
  const Scalar neg_M_link4_x_1 = link4_I8 * a_link4_z - c_joint5 * neg_M_link5_x;
  const Scalar neg_M_link4_x_2 = neg_M_link4_x_1 - s_joint5 * M_link5_y;
  const Scalar neg_M_link4_x_3 = neg_M_link4_x_2 - link4_I7 * t_link4_9;
  const Scalar neg_M_link4_x_4 = neg_M_link4_x_3 - link4_I11 * Omega_link4_zy;
  const Scalar neg_M_link4_x_5 = neg_M_link4_x_4 - link4_I10 * neg_Omega_link4_yx;
  const Scalar neg_M_link4_x = neg_M_link4_x_5 + link4_I12 * Omega_link4_zx;
  // link4: force F, moment M of (1)
  const Scalar F_link4_z = t_link5_8 - link4_I8 * Omega_link4_zy;
  const Scalar neg_M_link3_z_1 = F_link4_z - link3_I12 * a_link3_x + link3_I13 * neg_a_link3_y;
  const Scalar neg_M_link3_z_2 = neg_M_link3_z_1 + link3_I8 * neg_alpha_link3_z;
  const Scalar neg_M_link3_z_3 = neg_M_link3_z_2 - link3_I9 * t_link3_10;
  const Scalar neg_M_link3_z_4 = neg_M_link3_z_3 + link3_I6 * Omega_link3_yz;
  const Scalar neg_M_link3_z_5 = neg_M_link3_z_4 - c_joint4 * neg_M_link4_y;
  const Scalar neg_M_link3_z_6 = neg_M_link3_z_5 - s_joint4 * neg_M_link4_x;
  const Scalar neg_M_link3_z_7 = neg_M_link3_z_6 - link3_I7 * (t_link3_6 - t_link3_7);
  const Scalar neg_M_link3_z = neg_M_link3_z_7 - link3_I3 * Omega_link3_xz;
  const Scalar F_link5_z_1 = c_joint6 * F_link6_y - s_joint6 * neg_F_link6_x;
  // link5: force F, moment M of (1)
  const Scalar F_link5_z_2 = F_link5_z_1 - link4_I9 * a_link5_z;
  const Scalar F_link5_z_3 = F_link5_z_2 - link5_I5 * neg_Omega_link5_zy;
  const Scalar F_link5_z = F_link5_z_3 - link5_I2 * neg_Omega_link5_zx;
  const Scalar neg_M_link4_z_1 = F_link5_z + link4_I10 * neg_Omega_link4_yz;
  const Scalar neg_M_link4_z_2 = neg_M_link4_z_1 - s_joint5 * neg_M_link5_x;
  const Scalar neg_M_link4_z_3 = neg_M_link4_z_2 + link4_I11 * Omega_link4_xy;
  const Scalar neg_M_link4_z_4 = neg_M_link4_z_3 - link4_I7 * Omega_link4_xz;
  const Scalar neg_M_link4_z_5 = neg_M_link4_z_4 + link4_I13 * neg_Omega_link4_yx;
  const Scalar neg_M_link4_z_6 = neg_M_link4_z_5 + c_joint5 * M_link5_y;
  const Scalar neg_M_link4_z_7 = neg_M_link4_z_6 + link4_I8 * neg_a_link4_x;
  const Scalar neg_M_link4_z = neg_M_link4_z_7 - link4_I12 * (t_link4_8 - t_link4_9);
  const Scalar neg_F_link4_y = F_link5_z - link4_I8 * neg_Omega_link4_yy;
  // link3: moment M of (1)
  const Scalar M_link3_y_1 = neg_M_link4_z + link3_G1 * c_joint2;
  const Scalar M_link3_y_2 = M_link3_y_1 - link3_I6 * (t_link3_6 - t_link3_8);
  const Scalar M_link3_y_3 = neg_F_link4_x - link3_k1 * neg_F_link4_y;
  const Scalar M_link3_y_4 = M_link3_y_2 - s_joint4 * M_link3_y_3;
  const Scalar M_link3_y_5 = M_link3_y_4 - link3_I3 * Omega_link3_xy;
  const Scalar M_link3_y_6 = neg_F_link4_y + link3_k1 * neg_F_link4_x;
  const Scalar M_link3_y_7 = M_link3_y_5 - c_joint4 * M_link3_y_6;
  const Scalar M_link3_y_8 = M_link3_y_7 + link3_I11 * neg_Omega_link3_zx;
  const Scalar M_link3_y = M_link3_y_8 + link3_I7 * Omega_link3_zy;
  const Scalar t_link1_1 = M_link7_z - tau[6];
  const Scalar t_link7_7 = link7_I7 * c_link7;
  const Scalar t_link6_10 = link6_I3 * c_joint6 - s_joint6 * h_link6_x;
  const Scalar t_link6_11 = link6_I3 * s_joint6 + c_joint6 * h_link6_x;
  const Scalar h_link5_x = link5_I2 + t_link6_11;
  const Scalar h_link5_y = link5_I5 - h_link7_y;
  // link6: inertia I of (1)
  const Scalar neg_I_link6_xz = link6_I4 + t_link7_5 + link7_I2 * s_link7;
  const Scalar t_link6_12 = t_link7_4 - t_link7_7;
  const Scalar t_link6_13 = c_joint6 * I_link6_xy * 2.0 - s_joint6 * (link6_I1 - t_link6_12);
  const Scalar t_link6_14 = s_joint6 * t_link6_13;
  const Scalar t_link6_15 = c_joint6 * neg_I_link6_xz - s_joint6 * neg_I_link6_yz;
  const Scalar t_link6_16 = c_joint6 * neg_I_link6_yz + s_joint6 * neg_I_link6_xz;
  const Scalar t_link6_17 = link4_k2 * t_link6_10;
  const Scalar t_link5_9 = c_joint5 * h_link5_x - s_joint5 * h_link5_y;
  const Scalar h_link4_x = link4_I2 - t_link5_9;
  // link5: first moment h, inertia I of (1)
  const Scalar neg_h_link4_z = c_joint5 * h_link5_y + s_joint5 * h_link5_x;
  const Scalar neg_I_link5_yz = link5_I7 - t_link6_16 - link7_I8 * s_link7;
  const Scalar t_link5_10 = t_link7_4 - t_link6_14;
  const Scalar t_link5_11 = s_joint5 * (t_link5_10 - (link5_I14 - t_link6_12));
  const Scalar t_link5_12 = t_link5_11 - c_joint5 * (link5_I3 - 2.0 * t_link6_15);
  const Scalar t_link5_13 = s_joint5 * t_link5_12;
  const Scalar neg_I_link5_xz_1 = link5_I4 + neg_I_link7_xz + link4_k1 * t_link6_11;
  const Scalar neg_I_link5_xz = neg_I_link5_xz_1 - c_joint6 * t_link6_13;
  const Scalar t_link5_14 = s_joint5 * neg_I_link5_yz - c_joint5 * neg_I_link5_xz;
  const Scalar t_link5_15 = 2.0 * t_link5_9;
  const Scalar neg_h_link4_y = link4_I3 - t_link6_10;
  const Scalar t_link4_10 = s_joint4 * h_link4_x - c_joint4 * neg_h_link4_y;
  const Scalar t_link5_16 = s_joint5 * neg_I_link5_xz + c_joint5 * neg_I_link5_yz;
  const Scalar I_link4_yz = link4_I7 - t_link5_16;
  const Scalar I_link5_zz = link5_I15 + t_link7_7 + t_link6_14;
  // link4: inertia I of (1)
  const Scalar t_link4_11 = t_link6_10 - t_link5_14;
  const Scalar t_link4_12 = t_link6_17 - t_link5_10 + t_link5_13;
  const Scalar t_link4_13 = t_link5_15 - I_link5_zz;
  const Scalar t_link4_14 = s_joint4 * (link4_I16 - t_link4_12 + t_link4_13);
  const Scalar t_link4_15 = c_joint4 * (link4_I4 - 2.0 * t_link4_11) + t_link4_14;
  const Scalar t_link4_16 = s_joint4 * t_link4_15;
  const Scalar I_link4_xz = link4_I6 - t_link6_15 + neg_h_link4_z + c_joint5 * t_link5_12;
  const Scalar t_link4_17 = s_joint4 * I_link4_yz - c_joint4 * I_link4_xz;
  const Scalar t_link4_18 = link3_k2 * t_link4_10;
  const Scalar t_link4_19 = c_joint4 * h_link4_x + s_joint4 * neg_h_link4_y;
  const Scalar t_link4_20 = 2.0 * t_link4_19;
  const Scalar I_link3_xz_1 = link3_I4 + t_link4_10 + t_link4_11 + c_joint4 * t_link4_15;
  const Scalar I_link3_xz = I_link3_xz_1 - link3_k1 * t_link4_19;
  const Scalar t_link4_21 = s_joint4 * I_link4_xz + c_joint4 * I_link4_yz;
  const Scalar t_link3_12 = t_link4_12 + t_link4_16;
  const Scalar neg_I_link4_zz_1 = t_link5_13 - (t_link6_17 - (link4_I1 - t_link6_12));
  const Scalar neg_I_link4_zz = t_link5_15 - neg_I_link4_zz_1;
  // link3
  const Scalar t_link3_13 = t_link4_20 + neg_I_link4_zz;
  const Scalar t_link3_14 = neg_h_link4_z + t_link4_17;
  const Scalar t_link3_15 = s_joint3 * (link3_I16 - t_link3_12 + t_link3_13);
  const Scalar t_link3_16 = t_link3_15 + c_joint3 * (link3_I2 - 2.0 * t_link3_14);
  const Scalar t_link3_17 = s_joint3 * t_link3_16;
  const Scalar t_link7_8 = link7_I1 + link7_I2 * c_link7;
  // link6
  const Scalar t_link6_18 = link7_I8 * c_link7 - c_joint6 * neg_I_link7_xz;
  const Scalar t_link6_19 = t_link6_18 + s_joint6 * t_link7_8;
  const Scalar t_link6_20 = s_joint6 * neg_I_link7_xz + c_joint6 * t_link7_8;
  const Scalar t_link6_21 = c_joint6 * h_link7_y;
  const Scalar t_link6_22 = s_joint6 * h_link7_y;
  const Scalar t_link6_23 = neg_I_link7_yz - link4_k1 * t_link6_21;
  // link5
  const Scalar t_link5_17 = t_link6_22 - s_joint5 * t_link6_19 - c_joint5 * t_link6_23;
  const Scalar t_link5_18 = s_joint5 * t_link6_23 - c_joint5 * t_link6_19;
  const Scalar t_link5_19 = s_joint5 * t_link6_21 + c_joint5 * h_link7_x;
  const Scalar t_link5_20 = t_link6_20 - t_link5_19;
  // link4
  const Scalar t_link4_22 = s_joint4 * t_link5_20 - c_joint4 * t_link5_18;
  const Scalar t_link4_23 = t_link4_22 - link3_k1 * t_link5_19;
  const Scalar t_link4_24 = t_link5_19 + c_joint4 * t_link5_20 + s_joint4 * t_link5_18;
  const Scalar t_link4_25 = s_joint4 + link3_k1 * c_joint4;
  const Scalar t_link4_26 = c_joint4 - link3_k1 * s_joint4;
  const Scalar t_link5_21 = c_joint5 * t_link6_21 - s_joint5 * h_link7_x;
  const Scalar t_link4_27 = t_link5_17 - t_link5_21 * t_link4_25;
  const Scalar t_link4_28 = t_link4_27 - t_link6_22 * t_link4_26;
  // link3
  const Scalar t_link3_18 = s_joint2 * (s_joint3 * t_link4_28 + c_joint3 * t_link4_23);
  const Scalar t_link3_19 = c_joint2 * t_link4_24 + t_link3_18;
  const Scalar t_link3_20 = c_joint3 * t_link4_28 - s_joint3 * t_link4_23;
  const Scalar I_link6_zz = link6_I6 - t_link6_12;
  const Scalar t_link6_24 = I_link6_zz - link4_k1 * t_link6_10;
  // link5
  const Scalar t_link5_22 = s_joint5 * t_link6_10;
  const Scalar t_link5_23 = t_link6_16 + t_link5_22;
  const Scalar t_link5_24 = s_joint5 * t_link6_24 - c_joint5 * t_link6_15;
  const Scalar t_link4_29 = link3_k1 * t_link5_22 + s_joint4 * t_link5_23;
  const Scalar t_link4_30 = t_link4_29 + c_joint4 * t_link5_24;
  const Scalar t_link5_25 = t_link6_11 - c_joint5 * t_link6_24 - s_joint5 * t_link6_15;
  const Scalar t_link4_31 = t_link5_25 - c_joint5 * t_link6_10 * t_link4_25;
  const Scalar t_link4_32 = t_link4_31 - t_link6_11 * t_link4_26;
  const Scalar t_link5_26 = t_link5_9 - I_link5_zz;
  // link4
  const Scalar t_link4_33 = c_joint4 * t_link5_14 + s_joint4 * t_link5_26;
  const Scalar t_link4_34 = t_link4_33 + link3_k1 * t_link5_9;
  const Scalar t_link4_35 = t_link4_19 + neg_I_link4_zz - link3_k1 * t_link4_10;
  // link7
  const Scalar t_link7_9 = link7_p1 * t_link3_19;
  const Scalar t_link7_10 = link7_p1 * t_link3_20;
  const Scalar t_link7_11 = link7_p1 * t_link4_24;
  const Scalar t_link7_12 = link7_p1 * t_link5_17;
  const Scalar t_link7_13 = link7_p1 * t_link6_20;
  const Scalar t_link7_14 = link7_p1 * neg_I_link7_yz;
  const Scalar t_link4_36 = t_link5_22 - c_joint4 * t_link5_23 + s_joint4 * t_link5_24;
  const Scalar t_link3_21 = s_joint2 * (c_joint3 * t_link4_30 - s_joint3 * t_link4_32);
  const Scalar t_link7_15 = t_link3_21 - c_joint2 * t_link4_36 + t_link3_19 * t_link7_14;
  const Scalar t_link3_22 = s_joint3 * t_link4_30 + c_joint3 * t_link4_32;
  const Scalar t_link7_16 = t_link3_22 - neg_I_link7_yz * t_link7_10;
  const Scalar t_link7_17 = t_link4_36 - t_link4_24 * t_link7_14;
  const Scalar t_link7_18 = t_link5_25 - t_link5_17 * t_link7_14;
  const Scalar t_link7_19 = t_link6_16 + neg_I_link7_yz * t_link7_13;
  // link6: 1/pivot of (1)
  const Scalar inverse_pivot_link6 = 1.0 / (I_link6_zz - neg_I_link7_yz * t_link7_14);
  const Scalar t_link6_25 = t_link7_17 * inverse_pivot_link6;
  const Scalar t_link6_26 = t_link7_18 * inverse_pivot_link6;
  const Scalar t_link6_27 = t_link7_19 * inverse_pivot_link6;
  const Scalar t_link4_37 = t_link5_16 - neg_h_link4_z * t_link4_25;
  const Scalar t_link6_28 = t_link7_15 * inverse_pivot_link6;
  const Scalar t_link4_38 = t_link5_9 - c_joint4 * t_link5_26 + s_joint4 * t_link5_14;
  const Scalar t_link3_23 = s_joint2 * (s_joint3 * t_link4_37 + c_joint3 * t_link4_34);
  const Scalar t_link7_20 = t_link3_23 - c_joint2 * t_link4_38 + t_link3_19 * t_link7_13;
  const Scalar t_link6_29 = t_link7_20 + t_link7_19 * t_link6_28;
  const Scalar t_link6_30 = t_link7_16 * inverse_pivot_link6;
  const Scalar t_link7_21 = c_joint3 * t_link4_37 + t_link3_20 * t_link7_13;
  const Scalar t_link6_31 = t_link7_21 - s_joint3 * t_link4_34 - t_link7_19 * t_link6_30;
  const Scalar t_link7_22 = t_link4_38 - t_link6_20 * t_link7_11;
  const Scalar t_link6_32 = t_link7_22 + t_link7_19 * t_link6_25;
  const Scalar t_link7_23 = t_link5_16 + t_link6_20 * t_link7_12;
  const Scalar t_link6_33 = t_link7_23 - t_link7_18 * t_link6_27;
  const Scalar inverse_pivot_link5_1 = I_link5_zz - t_link6_20 * t_link7_13;
  // link5: 1/pivot of (1)
  const Scalar inverse_pivot_link5 = 1.0 / (inverse_pivot_link5_1 - t_link7_19 * t_link6_27);
  const Scalar t_link5_27 = t_link6_29 * inverse_pivot_link5;
  const Scalar t_link5_28 = t_link6_33 * inverse_pivot_link5;
  const Scalar t_link3_24 = s_joint2 * (s_joint3 * t_link4_35 - c_joint3 * t_link4_17);
  const Scalar t_link6_34 = c_joint2 * t_link4_21 - t_link3_24 + t_link7_18 * t_link6_28;
  const Scalar t_link6_35 = t_link6_34 - t_link5_17 * t_link7_9;
  const Scalar t_link5_29 = t_link6_35 - t_link6_29 * t_link5_28;
  const Scalar t_link5_30 = t_link6_31 * inverse_pivot_link5;
  const Scalar t_link6_36 = s_joint3 * t_link4_17 + t_link7_16 * t_link6_26;
  const Scalar t_link6_37 = t_link6_36 + c_joint3 * t_link4_35 + t_link5_17 * t_link7_10;
  const Scalar t_link5_31 = t_link6_37 + t_link6_33 * t_link5_30;
  const Scalar t_link5_32 = t_link6_32 * inverse_pivot_link5;
  const Scalar t_link5_33 = t_link4_21 + t_link6_33 * t_link5_32;
  const Scalar t_link5_34 = t_link5_33 - t_link5_17 * t_link7_11;
  const Scalar t_link5_35 = t_link5_34 - t_link7_17 * t_link6_26;
  const Scalar t_link7_24 = neg_I_link4_zz + t_link5_17 * t_link7_12;
  const Scalar t_link6_38 = t_link7_24 + t_link7_18 * t_link6_26;
  const Scalar neg_inverse_pivot_link4 = 1.0 / (t_link6_38 + t_link6_33 * t_link5_28);
  const Scalar t_link4_39 = t_link5_35 * neg_inverse_pivot_link4;
  const Scalar I_link3_yz = link3_I3 + t_link4_21 + link3_k1 * neg_h_link4_z;
  const Scalar t_link3_25 = c_joint3 * I_link3_xz - s_joint3 * I_link3_yz;
  const Scalar t_link4_40 = t_link5_29 * neg_inverse_pivot_link4;
  // link3: inertia I of (1)
  const Scalar t_link3_26 = t_link4_13 - t_link4_16 + t_link4_20;
  const Scalar I_link3_zz = link3_I14 - t_link3_26;
  const Scalar t_link3_27 = c_joint2 * I_link3_zz - s_joint2 * t_link3_25;
  const Scalar t_link7_25 = t_link3_27 - t_link3_19 * t_link7_11;
  // link4
  const Scalar t_link4_41 = t_link7_25 + t_link5_35 * t_link4_40;
  const Scalar t_link4_42 = t_link4_41 + t_link7_17 * t_link6_28;
  const Scalar t_link4_43 = t_link4_42 + t_link6_29 * t_link5_32;
  const Scalar inverse_pivot_link3_1 = I_link3_zz - t_link6_32 * t_link5_32;
  const Scalar inverse_pivot_link3_2 = inverse_pivot_link3_1 - t_link4_24 * t_link7_11;
  const Scalar inverse_pivot_link3_3 = inverse_pivot_link3_2 + t_link5_35 * t_link4_39;
  const Scalar inverse_pivot_link3 = 1.0 / (inverse_pivot_link3_3 - t_link7_17 * t_link6_25);
  const Scalar t_link3_28 = c_joint3 * I_link3_yz + s_joint3 * I_link3_xz;
  const Scalar t_link4_44 = t_link3_28 + t_link6_31 * t_link5_32;
  const Scalar t_link4_45 = t_link4_44 - t_link3_20 * t_link7_11;
  const Scalar t_link4_46 = t_link4_45 - t_link5_31 * t_link4_39;
  const Scalar t_link4_47 = t_link4_46 - t_link7_17 * t_link6_30;
  const Scalar t_link4_48 = t_link5_31 * neg_inverse_pivot_link4;
  // link3
  const Scalar t_link3_29 = inverse_pivot_link3 * t_link4_47;
  const Scalar t_link3_30 = t_link4_43 * inverse_pivot_link3;
  const Scalar t_link3_31 = s_joint2 * (link2_I1 - t_link3_14 - c_joint3 * t_link3_16);
  const Scalar t_link3_32 = t_link4_47 * t_link3_30 - t_link3_31;
  const Scalar t_link3_33 = t_link3_32 - t_link7_16 * t_link6_28;
  const Scalar t_link3_34 = t_link3_33 + t_link6_29 * t_link5_30;
  const Scalar t_link3_35 = t_link3_34 + t_link3_20 * t_link7_9;
  const Scalar t_link3_36 = t_link3_35 + t_link5_31 * t_link4_40;
  const Scalar t_link3_37 = t_link3_36 - c_joint2 * (link2_I2 + t_link3_28);
  const Scalar I_link2_zz = t_link3_17 - (t_link3_13 - (link2_I12 + t_link4_18));
  const Scalar inverse_pivot_link2_1 = I_link2_zz - t_link4_47 * t_link3_29;
  const Scalar inverse_pivot_link2_2 = inverse_pivot_link2_1 + t_link5_31 * t_link4_48;
  const Scalar inverse_pivot_link2_3 = inverse_pivot_link2_2 - t_link7_16 * t_link6_30;
  const Scalar inverse_pivot_link2_4 = inverse_pivot_link2_3 - t_link3_20 * t_link7_10;
  const Scalar inverse_pivot_link2 = 1.0 / (inverse_pivot_link2_4 - t_link6_31 * t_link5_30);
  const Scalar I_link1_zz_1 = link3_I15 - t_link4_18 + t_link3_12 + t_link3_17;
  const Scalar I_link1_zz_2 = t_link2_1 + c_joint2 * t_link3_25 * 2.0;
  const Scalar t_link2_3 = t_link3_37 * inverse_pivot_link2;
  const Scalar I_link1_zz_3 = I_link1_zz_2 - s_joint2 * (t_link3_26 - I_link1_zz_1);
  const Scalar I_link1_zz = link1_I3 - t_link3_26 - s_joint2 * I_link1_zz_3;
  // link2
  const Scalar inverse_pivot_link1_1 = I_link1_zz - t_link3_37 * t_link2_3;
  const Scalar inverse_pivot_link1_2 = inverse_pivot_link1_1 + t_link5_29 * t_link4_40;
  const Scalar inverse_pivot_link1_3 = inverse_pivot_link1_2 - t_link7_15 * t_link6_28;
  const Scalar inverse_pivot_link1_4 = inverse_pivot_link1_3 - t_link4_43 * t_link3_30;
  const Scalar inverse_pivot_link1_5 = inverse_pivot_link1_4 - t_link3_19 * t_link7_9;
  // link1: 1/pivot, qdd of (1)
  const Scalar inverse_pivot_link1 = 1.0 / (inverse_pivot_link1_5 - t_link6_29 * t_link5_27);
  const Scalar t_link1_2 = neg_M_link6_z + tau[5] - t_link1_1 * t_link7_14;
  const Scalar t_link1_3 = inverse_pivot_link6 * t_link1_2;
  const Scalar t_link1_4 = neg_M_link5_z + tau[4] - t_link1_1 * t_link7_13;
  const Scalar t_link1_5 = t_link1_4 + t_link6_27 * t_link1_2;
  const Scalar t_link1_6 = inverse_pivot_link5 * t_link1_5;
  const Scalar t_link1_7 = neg_M_link4_z + tau[3] + t_link1_1 * t_link7_12;
  const Scalar t_link1_8 = t_link1_7 + t_link6_26 * t_link1_2;
  const Scalar t_link1_9 = t_link1_8 - t_link6_33 * t_link1_6;
  const Scalar t_link1_10 = neg_M_link3_z + tau[2] - t_link1_1 * t_link7_11;
  const Scalar t_link1_11 = t_link1_10 - t_link6_32 * t_link1_6;
  const Scalar t_link1_12 = t_link1_11 - t_link4_39 * t_link1_9;
  const Scalar t_link1_13 = t_link1_12 - t_link7_17 * t_link1_3;
  // link3: moment M of (1)
  const Scalar M_link3_x_1 = link3_G2 * c_joint2 + link3_I7 * neg_Omega_link3_zx;
  const Scalar M_link3_x_2 = M_link3_x_1 + link3_I6 * Omega_link3_yx;
  const Scalar M_link3_x_3 = M_link3_x_2 - s_joint4 * neg_M_link4_y;
  const Scalar M_link3_x_4 = neg_Omega_link3_yy - neg_Omega_link3_zz;
  const Scalar M_link3_x_5 = M_link3_x_3 - link3_I3 * M_link3_x_4;
  const Scalar M_link3_x_6 = M_link3_x_5 + link3_I10 * Omega_link3_zy;
  const Scalar M_link3_x = M_link3_x_6 + c_joint4 * neg_M_link4_x - link3_k1 * F_link4_z;
  // link1: qdd of (1)
  const Scalar t_link1_14 = tau[1] + qd[0] * t_link2_2 + link2_G2 * s_joint2;
  const Scalar t_link1_15 = t_link1_14 - link2_G1 * c_joint2 - t_link1_1 * t_link7_10;
  const Scalar t_link1_16 = t_link1_15 - t_link3_29 * t_link1_13 - s_joint3 * M_link3_x;
  const Scalar t_link1_17 = t_link1_16 - c_joint3 * M_link3_y + t_link6_31 * t_link1_6;
  const Scalar t_link1_18 = t_link1_17 + t_link4_48 * t_link1_9;
  const Scalar t_link1_19 = t_link1_18 - t_link6_30 * t_link1_2;
  const Scalar qdd_0_1 = qd[1] * (link2_I8 * c_joint2 - link2_I2 * s_joint2);
  const Scalar qdd_0_2 = tau[0] + c_joint2 * neg_M_link3_z;
  const Scalar qdd_0_3 = qdd_0_2 - qd[1] * (qdd_0_1 + 2.0 * t_link2_2);
  const Scalar qdd_0_4 = qdd_0_3 - s_joint2 * (s_joint3 * M_link3_y - c_joint3 * M_link3_x);
  const Scalar qdd_0_5 = qdd_0_4 - t_link4_40 * t_link1_9 + t_link2_3 * t_link1_19;
  const Scalar qdd_0_6 = qdd_0_5 - t_link3_30 * t_link1_13 + t_link7_15 * t_link1_3;
  const Scalar qdd_0_7 = qdd_0_6 - t_link1_1 * t_link7_9 + t_link5_27 * t_link1_5;
  const Scalar qdd_0 = inverse_pivot_link1 * qdd_0_7;
  qdd[0] = qdd_0;
  const Scalar qdd_1 = inverse_pivot_link2 * (t_link1_19 + t_link3_37 * qdd_0);
  qdd[1] = qdd_1;
  const Scalar qdd_2_1 = t_link1_13 - t_link4_43 * qdd_0 - t_link4_47 * qdd_1;
  const Scalar qdd_2 = inverse_pivot_link3 * qdd_2_1;
  qdd[2] = qdd_2;
  const Scalar neg_qdd_3_1 = neg_inverse_pivot_link4 * (t_link1_9 + t_link5_29 * qdd_0);
  const Scalar neg_qdd_3 = t_link4_39 * qdd_2 + neg_qdd_3_1 - t_link4_48 * qdd_1;
  qdd[3] = -neg_qdd_3;
  const Scalar qdd_4_1 = t_link1_6 + t_link5_27 * qdd_0 - t_link5_32 * qdd_2;
  const Scalar qdd_4 = qdd_4_1 + t_link5_30 * qdd_1 + t_link5_28 * neg_qdd_3;
  qdd[4] = qdd_4;
  const Scalar qdd_5_1 = t_link1_3 - t_link6_30 * qdd_1 - t_link6_25 * qdd_2;
  const Scalar qdd_5_2 = qdd_5_1 + t_link6_27 * qdd_4 + t_link6_28 * qdd_0;
  const Scalar qdd_5 = qdd_5_2 - t_link6_26 * neg_qdd_3;
  qdd[5] = qdd_5;
  const Scalar qdd_6_1 = t_link1_1 - t_link5_17 * neg_qdd_3 - t_link6_20 * qdd_4;
  const Scalar qdd_6_2 = t_link7_10 * qdd_1 + t_link7_11 * qdd_2;
  qdd[6] = qdd_6_2 - link7_p1 * (qdd_6_1 - t_link3_19 * qdd_0 - neg_I_link7_yz * qdd_5);
}

void point_positions(const Scalar q[7], Scalar p[3]) noexcept {
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[0], q[1], q[2], q[3]);
  sines_cosines(sines + 4, cosines + 4, q[4], q[5]);
  const Scalar s_joint1 = sines[0];
  const Scalar c_joint1 = cosines[0];
  const Scalar s_joint2 = sines[1];
  const Scalar c_joint2 = cosines[1];
  const Scalar s_joint3 = sines[2];
  const Scalar c_joint3 = cosines[2];
  const Scalar s_joint4 = sines[3];
  const Scalar c_joint4 = cosines[3];
  const Scalar s_joint5 = sines[4];
  const Scalar c_joint5 = cosines[4];
  const Scalar s_joint6 = sines[5];
  const Scalar c_joint6 = cosines[5];
  const Scalar t_link6_1 = link7_l1 * c_joint6 + link7_l2 * s_joint6;
  const Scalar t_link5_1 = s_joint5 * t_link6_1;
  const Scalar t_link6_2 = link5_l1 - link7_l2 * c_joint6 + link7_l1 * s_joint6;
  const Scalar t_link5_2 = link4_l1 - c_joint5 * t_link6_1;
  const Scalar t_link4_1 = link4_l1 - s_joint4 * t_link6_2 - c_joint4 * t_link5_2;
  const Scalar t_link4_2 = link3_l1 - c_joint4 * t_link6_2 + s_joint4 * t_link5_2;
  const Scalar t_link3_1 = s_joint3 * t_link5_1 - c_joint3 * t_link4_1;
  const Scalar t_link2_1 = s_joint2 * t_link4_2 + c_joint2 * t_link3_1;
  const Scalar t_link3_2 = c_joint3 * t_link5_1 + s_joint3 * t_link4_1;
  // link1: p of 1.2
  p[0] = -(s_joint1 * t_link3_2 + c_joint1 * t_link2_1);
  p[1] = c_joint1 * t_link3_2 - s_joint1 * t_link2_1;
  p[2] = link1_l1 - c_joint2 * t_link4_2 + s_joint2 * t_link3_1;
}

void force_jacobian_transpose(const Scalar q[7], Scalar C[21]) noexcept {
  Scalar sines[8];
  Scalar cosines[8];
  sines_cosines(sines, cosines, q[0], q[1], q[2], q[3]);
  sines_cosines(sines + 4, cosines + 4, q[4], q[5]);
  const Scalar s_joint1 = sines[0];
  const Scalar c_joint1 = cosines[0];
  const Scalar s_joint2 = sines[1];
  const Scalar c_joint2 = cosines[1];
  const Scalar s_joint3 = sines[2];
  const Scalar c_joint3 = cosines[2];
  const Scalar s_joint4 = sines[3];
  const Scalar c_joint4 = cosines[3];
  const Scalar s_joint5 = sines[4];
  const Scalar c_joint5 = cosines[4];
  const Scalar s_joint6 = sines[5];
  const Scalar c_joint6 = cosines[5];
  const Scalar r_link6_x = link7_l1 * c_joint6 + link7_l2 * s_joint6;
  const Scalar neg_r_link5_x = c_joint5 * r_link6_x;
  const Scalar r_link4_x = link4_l1 - neg_r_link5_x;
  const Scalar r_link6_y = link7_l1 * s_joint6 - link7_l2 * c_joint6;
  const Scalar t_link3_1 = s_joint3 * s_joint5;
  const Scalar r_link5_z = link5_l1 + r_link6_y;
  const Scalar t_link4_1 = s_joint4 * r_link5_z + c_joint4 * r_link4_x;
  const Scalar r_link3_x = link4_l1 - t_link4_1;
  const Scalar t_link3_2 = r_link6_x * t_link3_1 - c_joint3 * r_link3_x;
  const Scalar t_link4_2 = s_joint4 * r_link4_x - c_joint4 * r_link5_z;
  const Scalar neg_r_link3_z = link3_l1 + t_link4_2;
  const Scalar r_link2_x = s_joint2 * neg_r_link3_z + c_joint2 * t_link3_2;
  C[5] = r_link2_x;
  const Scalar t_link3_3 = c_joint3 * s_joint5;
  // link2: r of (9)
  const Scalar r_link2_z = r_link6_x * t_link3_3 + s_joint3 * r_link3_x;
  const Scalar t_link2_1 = s_joint1 * r_link2_z;
  C[1] = -(t_link2_1 + c_joint1 * r_link2_x);
  const Scalar t_link2_2 = c_joint1 * r_link2_z;
  C[0] = s_joint1 * r_link2_x - t_link2_2;
  const Scalar r_link2_y = s_joint2 * t_link3_2 - c_joint2 * neg_r_link3_z;
  // link1: C of (9)
  C[4] = s_joint1 * r_link2_y;
  C[3] = c_joint1 * r_link2_y;
  C[6] = s_joint1 * t_link3_2 - c_joint2 * t_link2_2;
  C[7] = -(c_joint2 * t_link2_1 + c_joint1 * t_link3_2);
  const Scalar t_link1_1 = c_joint5 * r_link6_y;
  const Scalar t_link1_2 = s_joint4 * r_link6_x;
  const Scalar t_link1_3 = t_link1_2 + c_joint4 * t_link1_1;
  const Scalar t_link1_4 = c_joint3 * t_link1_3 - r_link6_y * t_link3_1;
  const Scalar t_link1_5 = c_joint4 * r_link6_x;
  const Scalar t_link1_6 = t_link1_5 - s_joint4 * t_link1_1;
  const Scalar t_link1_7 = c_joint2 * t_link1_4 - s_joint2 * t_link1_6;
  const Scalar t_link1_8 = s_joint3 * t_link1_3 + r_link6_y * t_link3_3;
  C[15] = s_joint1 * t_link1_8 - c_joint1 * t_link1_7;
  const Scalar t_link1_9 = c_joint3 * t_link4_2;
  const Scalar t_link1_10 = s_joint3 * t_link4_2;
  const Scalar t_link1_11 = c_joint2 * t_link1_9 - s_joint2 * t_link4_1;
  C[9] = c_joint1 * t_link1_11 - s_joint1 * t_link1_10;
  C[16] = -(c_joint1 * t_link1_8 + s_joint1 * t_link1_7);
  C[10] = c_joint1 * t_link1_10 + s_joint1 * t_link1_11;
  C[8] = s_joint2 * r_link2_z;
  const Scalar t_link1_12 = s_joint5 * t_link1_2;
  const Scalar t_link1_13 = t_link3_3 * t_link1_5 + s_joint3 * neg_r_link5_x;
  const Scalar t_link1_14 = s_joint2 * t_link1_12 + c_joint2 * t_link1_13;
  const Scalar t_link1_15 = t_link3_1 * t_link1_5 - c_joint3 * neg_r_link5_x;
  C[12] = s_joint1 * t_link1_15 - c_joint1 * t_link1_14;
  C[13] = -(s_joint1 * t_link1_14 + c_joint1 * t_link1_15);
  C[17] = s_joint2 * t_link1_4 + c_joint2 * t_link1_6;
  C[11] = -(s_joint2 * t_link1_9 + c_joint2 * t_link4_1);
  C[14] = s_joint2 * t_link1_13 - c_joint2 * t_link1_12;
  C[2] = 0.0;
  C[18] = 0.0;
  C[19] = 0.0;
  C[20] = 0.0;
}

}  // namespace panda
