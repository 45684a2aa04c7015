// The pair of sine and cosine itself: errors over its range, what it says beyond, the same bits
// from every compiler and in every lane.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <tuple>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lanes_double.cpp"  // NOLINT(bugprone-suspicious-include)
#include "lanes_float.cpp"   // NOLINT(bugprone-suspicious-include)
#include "pair_double.cpp"   // NOLINT(bugprone-suspicious-include)
#include "pair_float.cpp"    // NOLINT(bugprone-suspicious-include)
#include "support/process.hpp"
#include "vector_double.cpp"  // NOLINT(bugprone-suspicious-include)
#include "vector_float.cpp"   // NOLINT(bugprone-suspicious-include)

namespace {

// What the headers state.
constexpr double kErrorDouble = 1.7e-16;
constexpr double kErrorFloat = 1e-7;
constexpr double kRangeDouble = 1.3e7;
constexpr float kRangeFloat = 1e5F;
constexpr double kEndDouble = 1.32e7;
constexpr float kEndFloat = 1.03e5F;

/// Uniform, near multiples of pi/2, and of all sizes.
std::vector<double> arguments(int count) {
  std::mt19937_64 random(5);
  const auto next = [&] {
    return static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
  };
  std::vector<double> result;
  for (int k = 0; k < count; ++k) {
    result.push_back(4 * next());
    result.push_back(kRangeDouble * next());
    result.push_back(std::round(8e6 * next()) * 1.5707963267948966 + std::pow(next(), 9));
    result.push_back(std::ldexp(next(), static_cast<int>(random() % 60) - 36));
  }
  return result;
}

double sine(double x) { return pair_double::sine_cosine(x).sine; }
double cosine(double x) { return pair_double::sine_cosine(x).cosine; }

TEST(SineCosine, IsWithinItsErrorInDouble) {
  for (const double x : arguments(250000)) {
    const auto exact = static_cast<long double>(x);
    ASSERT_LE(std::abs(static_cast<long double>(sine(x)) - std::sin(exact)), kErrorDouble) << x;
    ASSERT_LE(std::abs(static_cast<long double>(cosine(x)) - std::cos(exact)), kErrorDouble) << x;
    ASSERT_EQ(sine(-x), -sine(x));
    ASSERT_EQ(cosine(-x), cosine(x));
  }
}

float float_of(std::uint32_t bits) {
  float result = 0;
  std::memcpy(&result, &bits, sizeof(result));
  return result;
}

std::uint32_t bits_of(float value) {
  std::uint32_t result = 0;
  std::memcpy(&result, &value, sizeof(result));
  return result;
}

TEST(SineCosine, IsWithinItsErrorInFloat) {
  for (std::uint32_t bits = 0; bits <= bits_of(kRangeFloat); bits += 997) {
    const float x = float_of(bits);
    const auto [sine, cosine] = pair_float::sine_cosine(x);
    const auto exact = static_cast<double>(x);
    ASSERT_LE(std::abs(static_cast<double>(sine) - std::sin(exact)), kErrorFloat) << x;
    ASSERT_LE(std::abs(static_cast<double>(cosine) - std::cos(exact)), kErrorFloat) << x;
  }
}

TEST(SineCosine, KeepsTheDigitsOfSmallAnglesAndNearMultiplesOfPi) {
  EXPECT_EQ(sine(1e-300), 1e-300);
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_NEAR(sine(3.141592653589793) / 1.2246467991473532e-16, 1, 1e-6);
  EXPECT_NEAR(cosine(1.5707963267948966) / 6.123233995736766e-17, 1, 1e-6);
}

TEST(SineCosine, IsNotANumberBeyondItsRangeInFloat) {
  // From the end of the range over infinity to the last pattern that is not a number.
  for (std::uint32_t bits = bits_of(kEndFloat); bits < 0x80000000U; bits += 1009) {
    for (const float x : {float_of(bits), -float_of(bits)}) {
      const auto [sine, cosine] = pair_float::sine_cosine(x);
      ASSERT_TRUE(std::isnan(sine)) << x;
      ASSERT_TRUE(std::isnan(cosine)) << x;
    }
  }
}

TEST(SineCosine, IsNotANumberBeyondItsRangeInDouble) {
  std::mt19937_64 random(7);
  std::vector<double> values{kEndDouble, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::max()};
  for (int exponent = 25; exponent <= 1024; ++exponent) {  // from 2^24 = 1.7e7 on
    for (int k = 0; k < 100; ++k) {
      values.push_back(
          std::ldexp(1 + static_cast<double>(random() >> 11U) * 0x1p-53, exponent - 1));
    }
  }
  for (const double value : values) {
    for (const double x : {value, -value}) {
      const auto [sine, cosine] = pair_double::sine_cosine(x);
      ASSERT_TRUE(std::isnan(sine)) << x;
      ASSERT_TRUE(std::isnan(cosine)) << x;
    }
  }
}

TEST(SineCosine, HasTheSameBitsInEveryLane) {
  const std::vector<double> all = arguments(5000);
  for (std::size_t k = 0; k + 4 <= all.size(); k += 4) {
    const lanes_double::Scalar x{all[k], all[k + 1], all[k + 2], all[k + 3]};
    const auto [sine, cosine] = lanes_double::sine_cosine(x);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto expected = pair_double::sine_cosine(all[k + lane]);
      ASSERT_EQ(sine[lane], expected.sine);
      ASSERT_EQ(cosine[lane], expected.cosine);
    }
  }
}

/// The same bits, or no number in both.
template <class T>
void expect_same(const std::array<T, 2>& value, const std::array<T, 2>& expected, T x) {
  for (std::size_t k = 0; k < 2; ++k) {
    if (std::isnan(expected[k])) {
      ASSERT_TRUE(std::isnan(value[k])) << x;
    } else {
      ASSERT_EQ(std::memcmp(&value[k], &expected[k], sizeof(T)), 0) << x;
    }
  }
}

/// Small, near multiples of pi/2, at both ends of the range, beyond, and no number.
template <class T>
std::vector<T> edges(T range, T end) {
  using Limits = std::numeric_limits<T>;
  std::vector<T> result = {0,
                           Limits::denorm_min(),
                           Limits::min(),
                           Limits::epsilon(),
                           1,
                           Limits::max(),
                           Limits::infinity(),
                           Limits::quiet_NaN(),
                           end,
                           2 * end,
                           range};
  for (T x = static_cast<T>(0.7853981633974483); x < end; x *= 2) {
    result.insert(result.end(), {std::nextafter(x, T(0)), x, std::nextafter(x, end)});
  }
  for (T x : {range, end}) {
    for (int k = 0; k < 50; ++k) {
      result.push_back(x = std::nextafter(x, T(0)));
    }
  }
  const std::size_t positive = result.size();
  for (std::size_t k = 0; k < positive; ++k) {
    result.push_back(-result[k]);
  }
  return result;
}

TEST(SinesCosines, HaveTheBitsOfThePairInDouble) {
  std::vector<double> all = arguments(5000);
  const std::vector<double> more = edges(kRangeDouble, kEndDouble);
  all.insert(all.end(), more.begin(), more.end());
  for (std::size_t k = 0; k + 4 <= all.size(); ++k) {
    std::array<double, 4> sines{};
    std::array<double, 4> cosines{};
    const std::size_t count = k % 2 == 0 ? 4 : 3;
    if (count == 4) {
      vector_double::sines_cosines(sines.data(), cosines.data(), all[k], all[k + 1], all[k + 2],
                                   all[k + 3]);
    } else {
      vector_double::sines_cosines(sines.data(), cosines.data(), all[k], all[k + 1], all[k + 2]);
    }
    for (std::size_t n = 0; n < count; ++n) {
      const auto [sine, cosine] = pair_double::sine_cosine(all[k + n]);
      expect_same<double>({sines[n], cosines[n]}, {sine, cosine}, all[k + n]);
    }
  }
}

TEST(SinesCosines, HaveTheBitsOfThePairInFloat) {
  std::vector<float> all = edges(kRangeFloat, kEndFloat);
  for (std::uint32_t bits = 0; bits < 0xFFFFFFFFU - 40013U; bits += 40013U) {
    all.push_back(float_of(bits));
  }
  for (std::size_t k = 0; k + 5 <= all.size(); ++k) {
    std::array<float, 8> sines{};
    std::array<float, 8> cosines{};
    vector_float::sines_cosines(sines.data(), cosines.data(), all[k], all[k + 1], all[k + 2],
                                all[k + 3], all[k + 4]);
    for (std::size_t n = 0; n < 5; ++n) {
      const auto [sine, cosine] = pair_float::sine_cosine(all[k + n]);
      expect_same<float>({sines[n], cosines[n]}, {sine, cosine}, all[k + n]);
    }
  }
}

/// Each lane in turn is that of an argument, the others are those of its neighbours.
template <class Lanes, std::size_t lanes, class T, class InLanes, class Alone>
void expect_same_in_lanes(const std::vector<T>& all, InLanes in_lanes, Alone alone) {
  for (std::size_t k = 0; k + lanes <= all.size(); ++k) {
    Lanes x{};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      x[lane] = all[k + lane];
    }
    const auto pairs = in_lanes(x);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto expected = alone(all[k + lane]);
      expect_same<T>({pairs.sine[lane], pairs.cosine[lane]}, {expected.sine, expected.cosine},
                     all[k + lane]);
    }
  }
}

TEST(SineCosine, HasTheBitsOfOneStateInLanesOfDouble) {
  std::vector<double> all = arguments(5000);
  const std::vector<double> more = edges(kRangeDouble, kEndDouble);
  all.insert(all.end(), more.begin(), more.end());
  expect_same_in_lanes<lanes_double::Scalar, 4>(
      all, [](lanes_double::Scalar x) { return lanes_double::sine_cosine(x); },
      [](double x) { return pair_double::sine_cosine(x); });
}

TEST(SineCosine, HasTheBitsOfOneStateInLanesOfFloat) {
  std::vector<float> all = edges(kRangeFloat, kEndFloat);
  for (std::uint32_t bits = 0; bits < 0xFFFFFFFFU - 40013U; bits += 40013U) {
    all.push_back(float_of(bits));
  }
  expect_same_in_lanes<lanes_float::Scalar, 8>(
      all, [](lanes_float::Scalar x) { return lanes_float::sine_cosine(x); },
      [](float x) { return pair_float::sine_cosine(x); });
}

/// C and C++: prints all bits of the pair at many arguments, folded (of a vector those of each
/// place in turn), and how many numbers it gives for arguments beyond its range.
constexpr const char* kDriver = R"(
#include "FILE"
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#ifdef __cplusplus
using namespace SOURCE;
typedef SineCosine<Scalar> Pair;
#else
typedef SineCosine Pair;
#endif
#ifdef PLACES
static Pair pair_at(Scalar x, int k) {
  Scalar s[8], c[8];
  const Scalar y = 1;
  k %= PLACES;
  sines_cosines(s, c, k == 0 ? x : y, k == 1 ? x : y, k == 2 ? x : y, k == 3 ? x : y);
  const Pair pair = {s[k], c[k]};
  return pair;
}
#else
static Pair pair_at(Scalar x, int k) { return sine_cosine(k < 0 ? 0 : x); }
#endif
static int is_number(Scalar x) {
  uint64_t bits = 0;
  memcpy(&bits, &x, sizeof(x));
  return sizeof(x) == 4 ? (bits & 0x7fffffff) <= 0x7f800000
                        : (bits & 0x7fffffffffffffff) <= 0x7ff0000000000000;
}
int main(void) {
  uint64_t hash = 14695981039346656037u, state = 1;
  const volatile double beyond[] = {1.4e7, -2e7, 1e30, -1e30, 1e38, 1e300 * 1e300, -(1e300 * 1e300)};
  int k, n, numbers = 0;
  for (k = 0; k < 200000; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const Scalar x = (Scalar)(((double)(state >> 11) * 0x1p-52 - 1) * (k % 2 ? 4 : 9e4));
    const Pair pair = pair_at(x, k);
    unsigned char bytes[sizeof(pair)];
    memcpy(bytes, &pair, sizeof(pair));
    for (n = 0; n < (int)sizeof(pair); ++n) {
      hash = (hash ^ bytes[n]) * 1099511628211u;
    }
  }
  for (k = 0; k < 28; ++k) {
    const Pair pair = pair_at((Scalar)beyond[k / 4], k);
    numbers += is_number(pair.sine) + is_number(pair.cosine);
  }
  printf("%016llx, %d numbers\n", (unsigned long long)hash, numbers);
  return 0;
}
)";

using treedyn::support::Outcome;
using Options = std::vector<std::string>;

/// A program of the source `name`.cpp, or of `name`.c if the compiler is one of C.
Outcome compile(const std::filesystem::path& folder, const std::string& name,
                const std::string& compiler, const Options& options) {
  const std::string ending = compiler.ends_with("++") ? ".cpp" : ".c";
  std::string driver = kDriver;
  driver.replace(driver.find("FILE"), 4, name + ending);
  driver.replace(driver.find("SOURCE"), 6, name);
  treedyn::support::write_file(folder / ("driver" + ending), driver);
  Options command{compiler,
                  ending == ".c" ? "-std=c99" : "-std=c++17",
                  "-ffp-contract=off",
                  "-I",
                  TREEDYN_PAIRS,
                  "-o",
                  folder / "driver",
                  folder / ("driver" + ending)};
  command.insert(command.end(), options.begin(), options.end());
  return treedyn::support::run(command);
}

/// What the driver prints. Fails if it does not compile.
std::string bits(const std::filesystem::path& folder, const std::string& name,
                 const std::string& compiler, const Options& options) {
  const Outcome compiled = compile(folder, name, compiler, options);
  EXPECT_EQ(compiled.status, 0) << compiled.err;
  return treedyn::support::run({folder / "driver"}).out;
}

TEST(SineCosine, HasTheSameBitsFromEveryCompilerWithoutContraction) {
  const treedyn::support::TemporaryFolder folder;
  for (const std::string scalar : {"double", "float"}) {
    const std::string expected = bits(folder.path(), "pair_" + scalar, "g++", {"-O0"});
    EXPECT_THAT(expected, testing::MatchesRegex("[0-9a-f]{16}, 0 numbers\n"));
    for (const auto& [kind, compiler, options] :
         {std::tuple<std::string, std::string, Options>{"pair_", "g++", {"-O3", "-march=native"}},
          {"pair_", "clang++", {"-O3", "-march=native"}},
          {"c_", "gcc", {"-O2"}},
          {"c_", "clang", {"-O2"}},
          {"vector_", "g++", {"-O0", "-DPLACES=4"}},
          {"vector_", "g++", {"-O3", "-march=native", "-DPLACES=4"}},
          {"vector_", "g++", {"-O1", "-U__AVX__", "-U__SSE2__", "-U__aarch64__", "-DPLACES=4"}},
          {"vector_", "clang++", {"-O3", "-march=native", "-DPLACES=4"}}}) {
      EXPECT_EQ(bits(folder.path(), kind + scalar, compiler, options), expected)
          << kind << compiler;
    }
  }
}

TEST(SineCosine, DoesNotCompileWhereItsRoundingWouldBeCancelled) {
  const treedyn::support::TemporaryFolder folder;
  for (const auto& [source, compiler, option] :
       {std::tuple{"pair_double", "g++", "-ffast-math"},
        {"pair_double", "g++", "-funsafe-math-optimizations"},
        {"lanes_double", "g++", "-ffinite-math-only"},
        {"lanes_double", "clang++", "-ffinite-math-only"},
        {"c_double", "gcc", "-Ofast"},
        {"c_double", "gcc", "-funsafe-math-optimizations"},
        {"pair_double", "clang++", "-ffast-math"},
        {"c_double", "clang", "-Ofast"}}) {
    const Outcome outcome = compile(folder.path(), source, compiler, {option});
    EXPECT_NE(outcome.status, 0) << compiler << option;
    EXPECT_THAT(outcome.err, testing::HasSubstr(std::string(option) == "-ffinite-math-only"
                                                    ? "-ffast-math, -ffinite-math-only or x87"
                                                    : "--sincos libm"));
  }
}

/// Of numbers that are wider in registers than in memory, and of a double that is none.
TEST(SineCosine, DoesNotCompileForOtherFormatsOfNumbers) {
  const treedyn::support::TemporaryFolder folder;
  for (const auto& [source, options, error] :
       {std::tuple<std::string, Options, std::string>{
            "pair_double", {"-D__FLT_EVAL_METHOD__=-1"}, "x87"},
        {"pair_double", {"-D__FLT_EVAL_METHOD__=2"}, "x87"},
        {"pair_double", {"-D__i386__", "-U__SSE2__"}, "x87"},
        {"pair_double", {"-D__FLT_EVAL_METHOD__=1"}, ""},
        {"pair_double", {"-D__FLT_EVAL_METHOD__=16"}, ""},
        {"pair_float", {"-D__FLT_EVAL_METHOD__=1"}, "x87"},
        {"pair_float", {"-D__i386__", "-U__SSE2__"}, ""},
        {"pair_double", {"-D__SIZEOF_DOUBLE__=4"}, "--scalar float"},
        {"pair_float", {"-D__SIZEOF_DOUBLE__=4"}, ""}}) {
    Options all = {"-Wno-builtin-macro-redefined", "-fsyntax-only"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome outcome = compile(folder.path(), source, "g++", all);
    EXPECT_EQ(outcome.err.find("#error") == std::string::npos, error.empty()) << outcome.err;
    EXPECT_THAT(outcome.err, testing::HasSubstr(error)) << source << ' ' << options.front();
  }
}

/// Parts of -ffast-math.
const std::vector<Options> kParts = {
    {"-funsafe-math-optimizations"},
    {"-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"},
    {"-ffinite-math-only"},
    {"-freciprocal-math", "-fno-signed-zeros", "-fno-trapping-math"}};

/// g++ without the word by which it tells that it may reorder sums, as older ones are.
const Options kSilent = {"-U__ASSOCIATIVE_MATH__", "-U__FAST_MATH__"};

TEST(SineCosine, HasItsBitsWithPartsOfFastMathOrDoesNotCompile) {
  const treedyn::support::TemporaryFolder folder;
  for (const std::string scalar : {"double", "float"}) {
    const std::string expected = bits(folder.path(), "pair_" + scalar, "g++", {"-O0"});
    for (const auto& [kind, compiler, more] :
         {std::tuple<std::string, std::string, Options>{"pair_", "g++", {}},
          {"vector_", "g++", {"-DPLACES=4"}},
          {"c_", "gcc", {}},
          {"pair_", "g++", kSilent},
          {"c_", "gcc", kSilent},
          {"pair_", "clang++", {}},
          {"vector_", "clang++", {"-DPLACES=4"}},
          {"c_", "clang", {}}}) {
      for (Options options : kParts) {
        options.insert(options.end(), more.begin(), more.end());
        options.emplace_back("-O2");
        const Outcome compiled = compile(folder.path(), kind + scalar, compiler, options);
        if (compiled.status == 0) {
          EXPECT_EQ(treedyn::support::run({folder.path() / "driver"}).out, expected)
              << kind << scalar << ' ' << compiler << ' ' << options.front();
        } else {
          EXPECT_THAT(compiled.err, testing::HasSubstr("--sincos libm"));
        }
      }
    }
  }
}

}  // namespace
