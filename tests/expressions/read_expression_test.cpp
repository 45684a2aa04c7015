#include "expressions/read_expression.hpp"

#include <cmath>
#include <ctime>

#include <gtest/gtest.h>

namespace treedyn::expressions {
namespace {

using model::Expression;
using model::Quantity;
using model::Variable;

VariableNames names() {
  return {
      [](std::string_view name, std::optional<std::string_view> index) -> std::optional<Variable> {
        if (name == "t" && !index) {
          return Variable{Quantity::kTime, 0};
        }
        if (name == "q" && index) {
          return Variable{Quantity::kPosition, *index == "a" ? 0 : 1};
        }
        return std::nullopt;
      },
      ", t"};
}

/// With t = 0.3, q[a] = 0.7, q[b] = -1.1.
double value(const Expression& expression) {
  return expression.evaluate([](const Variable& v) {
    return v.quantity == Quantity::kTime ? 0.3 : v.index == 0 ? 0.7 : -1.1;
  });
}

double value(const std::string& text) { return value(read_expression(Constants(), text, names())); }

/// A few roundings of double.
void expect_value(const std::string& text, double expected) {
  EXPECT_NEAR(value(text), expected, 1e-15 * (1 + std::fabs(expected))) << text;
}

/// GiNaC's order of terms changes from symbol to symbol, so every reading has another one.
TEST(Expressions, AreTheSameProgramAtEveryReading) {
  for (const char* const text :
       {"((sqrt(sin(t)^2 + 0.01) - sin(t))/2)^2", "(q[a] - q[b])*(t - q[b])",
        "(q[a] - t)^3/(q[b] - t)", "1/(t - q[a]) - 3*(q[b] - q[a])^(-2)",
        "(2*t - 4*q[a])^2*sqrt(q[a] - q[b] + 9)", "cos(q[b] - q[a])*(q[a]*t - q[b]*t + 1)"}) {
    const Expression first = read_expression(Constants(), text, names());
    for (int k = 0; k < 100; ++k) {
      ASSERT_EQ(read_expression(Constants(), text, names()), first) << text;
    }
  }
  expect_value("(q[a] - t)^3/(q[b] - t)", 0.064 / -1.4);
  expect_value("(t - q[a])*(t - q[b])", -0.4 * 1.4);
  expect_value("(t - q[a])^(-3)", 1 / -0.064);
  expect_value("sqrt(t - q[b])*(t - q[a])^2", std::sqrt(1.4) * 0.16);
}

TEST(Expressions, HaveTheValuesOfTheirText) {
  expect_value("2*t + 1", 1.6);
  expect_value("t - q[a]*q[b]", 0.3 + 0.77);
  expect_value("-t", -0.3);
  expect_value("t/q[a]/q[b]", 0.3 / 0.7 / -1.1);
  expect_value("t^5", std::pow(0.3, 5));
  expect_value("t^(-2)", 1 / 0.09);
  expect_value("sqrt(q[a]^2 + 1)", std::sqrt(1.49));
  expect_value("q[a]^(3/2)", std::pow(0.7, 1.5));
  expect_value("sin(pi*t)*cos(q[b])", std::sin(M_PI * 0.3) * std::cos(1.1));
  expect_value("tan(t)", std::tan(0.3));
  expect_value("-(t - 1)*3 - 4/(2 - t)", 2.1 - 4 / 1.7);
  expect_value("sqrt(2)*t - pi", std::sqrt(2.0) * 0.3 - M_PI);
  expect_value("0*t", 0);
}

TEST(Expressions, WithoutVariablesAreConstants) {
  const Expression e = read_expression(Constants(), "sqrt(3)/2 + (t - t)", names());
  ASSERT_TRUE(e.is_constant());
  EXPECT_LE(abs(e.value() - sqrt(Real(3)) / 2), Real("1e-49"));
}

/// By central differences of the text itself, step 1e-4: error h^2/6 f''' below 1e-6.
TEST(Motions, HaveTheDerivativesOfTheirText) {
  for (const std::string text :
       {"sin(3*t)", "t^3 - 2*t", "cos(t)^2/(1 + t^2)", "sqrt(1 + sin(t)^2)", "tan(t)*t"}) {
    const auto motion = read_motion(Constants(), text, names());
    const auto at = [&](const Expression& e, double t) {
      return e.evaluate([t](const Variable&) { return t; });
    };
    const double h = 1e-4;
    for (std::size_t k = 0; k < 2; ++k) {
      const double slope = (at(motion[k], 0.3 + h) - at(motion[k], 0.3 - h)) / (2 * h);
      EXPECT_NEAR(at(motion[k + 1], 0.3), slope, 1e-6) << text;
    }
  }
}

TEST(Expressions, DoNotDependOnTheOrderOfTheirText) {
  const auto read = [](const std::string& text) {
    return read_expression(Constants(), text, names());
  };
  EXPECT_EQ(read("q[b]*sin(t) + q[a] - 3*t"), read("-3*t + q[a] + sin(t)*q[b]"));
}

TEST(Expressions, ThatAreHostileEndSoon) {
  const std::clock_t start = std::clock();
  std::string product = "sin(t)";
  for (int k = 2; k < 38; ++k) {
    product += "*sin(" + std::to_string(k) + "*t)";
  }
  EXPECT_THROW(static_cast<void>(read_motion(Constants(), product, names())), TextError)
      << "its second derivative would have hundreds of thousands of operations";
  for (const std::string text : {"((t^64)^64)^64", "((1e90*t)^64)^64", "t^t", "1/0*t"}) {
    EXPECT_THROW(static_cast<void>(read_expression(Constants(), text, names())), TextError) << text;
  }
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10);
}

TEST(Expressions, EvaluateInAnyTypeInTheSameOrder) {
  const Expression e = read_expression(Constants(), "(t^7 - q[a])/(1 + t*t)", names());
  const Real x = e.evaluate<Real>(
      [](const Real& c) { return c; },
      [](const Variable& v) { return Real(v.quantity == Quantity::kTime ? "0.3" : "0.7"); });
  EXPECT_NEAR(static_cast<double>(x), value(e), 1e-15);
}

}  // namespace
}  // namespace treedyn::expressions
