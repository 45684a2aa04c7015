#include "common/decimal.hpp"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace treedyn {
namespace {

Real value(const std::string& text) {
  const Decimal decimal = read_decimal(text);
  EXPECT_TRUE(decimal) << text;
  return decimal.value;
}

DecimalError error(const std::string& text) { return read_decimal(text).error; }

TEST(ReadDecimal, GivesTheExactValueOfBinaryFractions) {
  EXPECT_EQ(value("0.5"), Real(0.5));
  EXPECT_EQ(value("-1234.0625e1"), Real(-12340.625));
  EXPECT_EQ(value("+.25"), Real(0.25));
  EXPECT_EQ(value("3."), Real(3));
  EXPECT_EQ(value("-0"), Real(0));
}

TEST(ReadDecimal, RoundsOnce) {
  EXPECT_EQ(value("0.1"), Real(1) / 10);
  EXPECT_EQ(value("1e-44"), 1 / Real("1e44"));
  EXPECT_EQ(value("3.141592653589793"), Real(3141592653589793) / Real(1000000000000000));
}

TEST(ReadDecimal, AgreesWithBoostOnFiftyDigits) {
  const std::string text = "2.7182818284590452353602874713526624977572470937000e-7";
  EXPECT_LE(abs(value(text) - Real(text)), Real("1e-57"));
}

TEST(ReadDecimal, TakesZeroWithAnyExponent) {
  EXPECT_EQ(value("0.000e999999999999999999999"), Real(0));
}

TEST(ReadDecimal, RefusesWhatNoDoubleHolds) {
  EXPECT_EQ(error("1e400"), DecimalError::kOutOfRange);
  EXPECT_EQ(error("1e999999999"), DecimalError::kOutOfRange);
  EXPECT_EQ(error("-1e-400"), DecimalError::kOutOfRange);
  EXPECT_EQ(error("1e-99999999999999999999999999"), DecimalError::kOutOfRange);
  EXPECT_EQ(value("1e300"), Real("1e300"));
  EXPECT_EQ(value("-10.0e299"), Real("-1e300"));
  EXPECT_EQ(value("1e-300"), Real("1e-300"));
  EXPECT_EQ(error("1.0000001e300"), DecimalError::kOutOfRange);
  EXPECT_EQ(error("9.9e-301"), DecimalError::kOutOfRange);
  EXPECT_EQ(error("10e300"), DecimalError::kOutOfRange);
}

TEST(ReadDecimal, RefusesMoreThanAThousandCharacters) {
  EXPECT_EQ(error(std::string(1001, '1')), DecimalError::kTooLong);
  EXPECT_EQ(error("0." + std::string(100000, '3')), DecimalError::kTooLong);
  EXPECT_EQ(error("0." + std::string(998, '3')), DecimalError::kNone);
}

TEST(ReadDecimal, RefusesWhatIsNoDecimal) {
  for (const char* text : {"", "+", ".", "e5", "1e", "1e+", "1,5", "nan", "inf", "0x10", "1 2",
                           " 1", "1.2.3", "--1", "1e5.0", "1f", "\xc2\xb9"}) {
    EXPECT_EQ(error(text), DecimalError::kSyntax) << text;
  }
}

TEST(HalfUnitOfLastDigit, FollowsThePointAndTheExponent) {
  EXPECT_EQ(half_unit_of_last_digit("0.123"), Real(1) / 2000);
  EXPECT_EQ(half_unit_of_last_digit("12e2"), Real(50));
  EXPECT_EQ(half_unit_of_last_digit("7"), Real(0.5));
}

TEST(Shown, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(shown("a\nb\x1b[31m"), "a\\x0ab\\x1b[31m");
  EXPECT_EQ(shown(std::string(100, 'x')), fmt::format("{:x<60}...", ""));
}

}  // namespace
}  // namespace treedyn
