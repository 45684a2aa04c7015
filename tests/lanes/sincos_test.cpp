// The pair of sine and cosine itself: errors over its range, what it says beyond, the same bits
// from every compiler and in every lane.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lanes_double.cpp"  // NOLINT(bugprone-suspicious-include)
#include "pair_double.cpp"   // NOLINT(bugprone-suspicious-include)
#include "pair_float.cpp"    // NOLINT(bugprone-suspicious-include)
#include "support/process.hpp"

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

/// Prints all bits of the pair at many arguments, folded.
constexpr const char* kDriver = R"(
#include "SOURCE.cpp"
#include <cstdint>
#include <cstdio>
#include <cstring>
int main() {
  std::uint64_t hash = 14695981039346656037ULL, state = 1;
  for (int k = 0; k < 200000; ++k) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    const auto x = static_cast<SOURCE::Scalar>((static_cast<double>(state >> 11) * 0x1p-52 - 1) *
                                               (k % 2 ? 4 : 9e4));
    const auto pair = SOURCE::sine_cosine(x);
    unsigned char bytes[sizeof(pair)];
    std::memcpy(bytes, &pair, sizeof(pair));
    for (const unsigned char byte : bytes) {
      hash = (hash ^ byte) * 1099511628211ULL;
    }
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
}
)";

using treedyn::support::Outcome;

Outcome compile(const std::filesystem::path& folder, const std::string& source,
                const std::string& compiler, const std::vector<std::string>& options) {
  std::string driver = kDriver;
  for (std::size_t at = driver.find("SOURCE"); at != std::string::npos;
       at = driver.find("SOURCE")) {
    driver.replace(at, 6, source);
  }
  treedyn::support::write_file(folder / "driver.cpp", driver);
  std::vector<std::string> command{
      compiler,      "-std=c++17", "-ffp-contract=off", "-I",
      TREEDYN_PAIRS, "-o",         folder / "driver",   folder / "driver.cpp"};
  command.insert(command.end(), options.begin(), options.end());
  return treedyn::support::run(command);
}

TEST(SineCosine, HasTheSameBitsFromEveryCompilerWithoutContraction) {
  const treedyn::support::TemporaryFolder folder;
  for (const char* source : {"pair_double", "pair_float"}) {
    std::string expected;
    for (const auto& [compiler, options] :
         {std::pair<std::string, std::vector<std::string>>{"g++", {"-O0"}},
          {"g++", {"-O3", "-march=native"}},
          {"clang++", {"-O3", "-march=native"}}}) {
      const Outcome compiled = compile(folder.path(), source, compiler, options);
      ASSERT_EQ(compiled.status, 0) << compiled.err;
      const std::string bits = treedyn::support::run({folder.path() / "driver"}).out;
      expected = expected.empty() ? bits : expected;
      EXPECT_EQ(bits, expected) << compiler;
    }
    EXPECT_EQ(expected.size(), 17U);
  }
}

TEST(SineCosine, DoesNotCompileWhereItsRoundingWouldBeCancelled) {
  const treedyn::support::TemporaryFolder folder;
  for (const char* compiler : {"g++", "clang++"}) {
    const Outcome outcome = compile(folder.path(), "pair_double", compiler, {"-ffast-math"});
    EXPECT_NE(outcome.status, 0);
    EXPECT_THAT(outcome.err, testing::HasSubstr("--sincos libm"));
  }
}

}  // namespace
