#include "expressions/constant.hpp"

#include <ctime>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace treedyn::expressions {
namespace {

Real evaluate(const std::string& text) { return Constants().evaluate(text); }

/// "offset: message" of the error, "" if there is none.
std::string error(const Constants& constants, const std::string& text) {
  try {
    static_cast<void>(constants.evaluate(text));
  } catch (const TextError& problem) {
    return fmt::format("{}: {}", problem.offset(), problem.what());
  }
  return "";
}
std::string error(const std::string& text) { return error(Constants(), text); }

void expect_close(const std::string& text, const Real& expected) {
  EXPECT_LE(abs(evaluate(text) - expected), Real("1e-49") * abs(expected)) << text;
}

TEST(Constants, EvaluateToFiftyDigits) {
  expect_close("pi/2", pi() / 2);
  expect_close("sqrt(3)/2", sqrt(Real(3)) / 2);
  expect_close("sin(pi/12)", (sqrt(Real(6)) - sqrt(Real(2))) / 4);
  expect_close("atan(1)*4", pi());
  expect_close("acos(-1)", pi());
  expect_close("asin(1)", pi() / 2);
  expect_close("tan(pi/5)", tan(pi() / 5));
  expect_close("2^(1/2)", sqrt(Real(2)));
}

TEST(Constants, KeepDecimalsExact) {
  EXPECT_EQ(evaluate("0.1*3 - 0.3"), Real(0));
  EXPECT_EQ(evaluate("1e-4*1e4"), Real(1));
  EXPECT_EQ(evaluate("1/3*3"), Real(1));
}

TEST(Constants, FindExactZeros) {
  EXPECT_EQ(evaluate("sin(pi)"), Real(0));
  EXPECT_EQ(evaluate("cos(pi/2)"), Real(0));
  EXPECT_EQ(evaluate("sqrt(6) - sqrt(2)*sqrt(3)"), Real(0));
  EXPECT_EQ(evaluate("sqrt(2)^2 - 2"), Real(0));
}

TEST(Constants, KeepWhatCancelsInFiftyDigits) {
  expect_close("(sqrt(2) + 1e-45) - sqrt(2)", Real("1e-45"));
}

TEST(Constants, BindSignsPowersAndProductsAsUsual) {
  EXPECT_EQ(evaluate("-2^2"), Real(-4));
  EXPECT_EQ(evaluate("2^-1"), Real(0.5));
  EXPECT_EQ(evaluate("2^3^2"), Real(512));
  EXPECT_EQ(evaluate("1 - 2 - 3"), Real(-4));
  EXPECT_EQ(evaluate("8/2/2"), Real(2));
  EXPECT_EQ(evaluate("2 + 3*4"), Real(14));
  EXPECT_EQ(evaluate("- - +3"), Real(3));
  EXPECT_EQ(evaluate("(1 + 2)*3"), Real(9));
  EXPECT_EQ(evaluate("2*-3"), Real(-6));
}

TEST(Constants, UseParametersDefinedBefore) {
  Constants constants;
  constants.define("H", "1.8");
  constants.define("thigh", "0.245*H");
  EXPECT_EQ(constants.evaluate("thigh*2"), Real(882) / 1000);
  EXPECT_THROW(constants.define("H", "2"), TextError);
  EXPECT_THROW(constants.define("pi", "3"), TextError);
  EXPECT_THROW(constants.define("sin", "3"), TextError);
  EXPECT_THROW(constants.define("a-b", "3"), TextError);
  EXPECT_THROW(constants.define("x", "later"), TextError);
}

TEST(Constants, NameTheMistakeAndItsPlace) {
  EXPECT_EQ(error("1/0"), "2: division by zero; expected a divisor that is not zero");
  EXPECT_EQ(error("1/(sqrt(6) - sqrt(2)*sqrt(3))"),
            "2: division by zero; expected a divisor that is not zero");
  EXPECT_EQ(error("0^-1"), "0: division by zero; expected a base that is not zero");
  EXPECT_EQ(error("sqrt(-4)"),
            "0: sqrt of -4 is not defined; expected an argument that is not negative");
  EXPECT_EQ(error("asin(2)"), "0: asin of 2 is not defined; expected an argument from -1 to 1");
  EXPECT_EQ(error("tan(pi/2)"),
            "0: tan of 1.5708 is not defined; expected an angle of at most 1e6 that is no odd "
            "multiple of pi/2");
  EXPECT_EQ(error("2*foo"),
            "2: 'foo' is unknown; expected a parameter, pi or one of sqrt, sin, cos, tan, asin, "
            "acos, atan");
  EXPECT_EQ(error("2pi"), "1: unexpected 'pi'; expected an operator or the end");
  EXPECT_EQ(error("(1+2"), "0: '(' is not closed; expected ')'");
  EXPECT_EQ(evaluate("1 +\n 2"), Real(3));
  EXPECT_EQ(error("(1 2)"), "3: unexpected '2'; expected an operator or ')'");
  EXPECT_EQ(error("1 +\n$"), "4: unexpected '$'; expected a number, a name or '('");
  EXPECT_EQ(error("1+"), "2: expression ends too early; expected a number, a name or '('");
  EXPECT_EQ(error("1+*2"), "2: unexpected '*'; expected a number, a name or '('");
  EXPECT_EQ(error("sin 1"), "0: 'sin' has no argument; expected '('");
  EXPECT_EQ(error("(-2)^(1/2)"),
            "0: negative base with a fractional exponent; expected a base that is not negative");
  EXPECT_EQ(error("2^pi"), "2: exponent is not simple; expected a ratio of integers up to 64");
  EXPECT_EQ(error("2^65"), "2: exponent is not simple; expected a ratio of integers up to 64");
}

TEST(Constants, StayWithinTheirLimits) {
  EXPECT_EQ(error(std::string(100, '(') + "1" + std::string(100, ')')),
            "50: expression is nested too deeply; expected at most 50 levels");
  EXPECT_EQ(error("1" + std::string(1000, '+')),
            "0: expression of 1001 characters is too long; expected at most 1000");
  EXPECT_EQ(error("1e400*2"),
            "0: 1e400 is out of range; expected 0 or a magnitude from 1e-300 to 1e300");
  EXPECT_EQ(error("10^60*10^60*10^60*10^60*10^60*10^60"),
            "0: 10^60*10^60*10^60*10^60*10^60*10^60 is out of range; expected 0 or a magnitude "
            "from 1e-300 to 1e300");
  EXPECT_EQ(error("(10^60)^6"),
            "0: power is out of range; expected a magnitude from 1e-300 to 1e300");
}

TEST(Constants, RefuseParametersThatGrowExponentially) {
  Constants constants;
  constants.define("p0", "pi + sqrt(2)");
  const std::clock_t start = std::clock();
  std::string message;
  for (int k = 0; k < 60 && message.empty(); ++k) {
    try {
      constants.define(fmt::format("p{}", k + 1), fmt::format("p{0}*(1 + sqrt(p{0}))", k));
    } catch (const TextError& problem) {
      message = problem.what();
    }
  }
  EXPECT_EQ(message, "expression of 8188 operations is too large; expected at most 5000");
  EXPECT_LT(std::clock() - start, 20 * CLOCKS_PER_SEC);
}

TEST(Constants, RefuseExactNumbersThatGrowExponentially) {
  Constants constants;
  constants.define("p0", "1 + 1e-99");
  EXPECT_THROW(
      {
        for (int k = 0; k < 60; ++k) {
          constants.define(fmt::format("p{}", k + 1), fmt::format("p{0}*p{0}", k));
        }
      },
      TextError);
}

}  // namespace
}  // namespace treedyn::expressions
