// Error bounds of single operations, whose largest error is known or found: none is exceeded, none
// is much larger; a bound without one of its terms fails here.
#include "accuracy/bounds.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "accuracy/bound_search.hpp"
#include "support/states.hpp"

namespace treedyn::accuracy {
namespace {

using program::Expr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Arithmetic kFloat{emit::Scalar::kFloat, emit::Sincos::kPair};

/// y = of(x), two numbers x.
program::Function made(const std::function<Expr(program::Graph&, Expr, Expr)>& of) {
  program::Function function;
  function.signature = {"f", "", "", {{"x", 2, ""}}, {{"y", 1, ""}}};
  program::Graph& graph = function.graph;
  const Expr y = of(graph, Expr(graph, graph.input(0, 0)), Expr(graph, graph.input(0, 1)));
  function.outputs = {y.ref()};
  return function;
}

double bound(const program::Function& function, const Box& box, const Arithmetic& how = kFloat) {
  return OutputError(function, function.outputs[0], how)(box);
}

/// In float over random states of the box, against 50 digits.
double largest_error(const program::Function& function, const Box& box, int states = 20000) {
  support::Random uniform(11);
  double largest = 0;
  for (int k = 0; k < states; ++k) {
    std::vector<double> x;
    for (const Interval& range : box) {
      x.push_back(static_cast<double>(static_cast<float>(uniform(range.low, range.high))));
    }
    const std::vector<Real> inputs(x.begin(), x.end());
    const Real exact = program::interpret<Real>(function, {std::span<const Real>(inputs)})[0];
    const float value = executed<float>(function, {x}, emit::Sincos::kPair)[0];
    largest = std::max(largest, static_cast<double>(abs(Real(value) - exact)));
  }
  return largest;
}

/// Not exceeded; at most `times` what random states find.
void expect_close(const program::Function& function, const Box& box, double times) {
  const double found = largest_error(function, box);
  EXPECT_GT(found, 0);
  EXPECT_GE(bound(function, box), found);
  EXPECT_LE(bound(function, box), times * found);
}

const Box kBox = {{1.1, 1.9}, {1.1, 1.9}};

TEST(OutputError, IsTheLargestErrorOfASum) {
  const program::Function sum = made([](auto&, Expr x, Expr y) { return x + y; });
  EXPECT_DOUBLE_EQ(bound(sum, kBox), 0x1p-23 * (1 + 0x1p-30) + 0x1p-126);    // beside 2 to 4
  EXPECT_EQ(executed<float>(sum, {{1.5, 1.125 + 0x1p-23}}, {})[0], 2.625F);  // 2^-23 less
  expect_close(sum, kBox, 1.01);
  EXPECT_NEAR(bound(sum, kBox, {emit::Scalar::kDouble, {}}), 0x1p-52, 1e-22);
}

TEST(OutputError, IsNearlyThatOfProductsQuotientsAndRoots) {
  expect_close(made([](auto&, Expr x, Expr y) { return x * y; }), kBox, 1.1);
  expect_close(made([](auto&, Expr x, Expr y) { return x / y; }), kBox, 1.2);
  expect_close(made([](auto& graph, Expr x, Expr) { return Expr(graph, graph.sqrt(x.ref())); }),
               kBox, 1.1);
}

TEST(OutputError, IsThatOfALiteral) {
  const auto tenth =
      made([](auto& graph, Expr, Expr) { return Expr(graph, graph.constant(Real("0.1"))); });
  EXPECT_NEAR(bound(tenth, kBox), static_cast<double>(0.1F) - 0.1, 1e-17);
  EXPECT_GE(bound(tenth, kBox), static_cast<double>(abs(Real(0.1F) - Real("0.1"))));
  EXPECT_EQ(bound(made([](auto&, Expr x, Expr) { return x; }), kBox), 0);
  const auto half =
      made([](auto& graph, Expr x, Expr) { return Expr(graph, graph.constant(Real("0.5"))) * x; });
  EXPECT_LT(bound(half, kBox), 1e-37);  // exact but for numbers that are flushed to zero
}

/// All arguments below 1e5 were tried once: 9.91e-8. Without its own term a sine has no error.
TEST(OutputError, HasTheErrorOfSinesAndCosines) {
  const Box turn = {{-3.2, 3.2}, {0, 0}};
  const auto sine = [](auto& graph, Expr x, Expr) {
    return Expr(graph, graph.sin(x.ref()));
  };
  const auto cosine = [](auto& graph, Expr x, Expr) {
    return Expr(graph, graph.cos(x.ref()));
  };
  expect_close(made(sine), turn, 1.5);
  expect_close(made(cosine), turn, 1.5);
  EXPECT_NEAR(bound(made(sine), turn), 1e-7, 1e-15);
  EXPECT_NEAR(bound(made(sine), turn, {emit::Scalar::kFloat, emit::Sincos::kLibm}), 0x1p-23, 1e-15);
}

/// The error of a sum of angles counts with the slope of the sine there.
TEST(OutputError, HasTheErrorOfAngles) {
  const auto sine =
      made([](auto& graph, Expr x, Expr y) { return Expr(graph, graph.sin((x + y).ref())); });
  expect_close(sine, {{14.5, 15.5}, {16.5, 16.9}}, 2);  // half of 2^-19 beside 1e-7
  const auto flat =
      made([](auto& graph, Expr x, Expr y) { return Expr(graph, graph.cos((x + y).ref())); });
  EXPECT_LT(bound(flat, {{1e-3, 1e-3}, {1e-3, 1e-3}}), 1.01e-7);
}

/// An error that is inherited twice with opposite signs cancels.
TEST(OutputError, KnowsWhichErrorsAreTheSame) {
  const auto difference = made([](auto&, Expr x, Expr y) {
    const Expr sum = x + y;
    return sum * x - sum * y;
  });
  expect_close(difference, {{1.1, 1.9}, {1.1, 1.9}}, 3);
  const Box near = {{1.5, 1.5001}, {1.5, 1.5001}};
  EXPECT_LT(bound(difference, near), 2.1 * 0x1p-22);  // of two products, not of the sum
}

/// Four times c x - s y, s x + c y; c of angle k, s of angle k + `other`.
program::Function turns(int other) {
  program::Function function;
  function.signature = {"f", "", "", {{"x", 10, ""}}, {{"y", 1, ""}}};
  program::Graph& graph = function.graph;
  Expr x(graph, graph.input(0, 8));
  Expr y(graph, graph.input(0, 9));
  for (int k = 0; k < 4; ++k) {
    const Expr s(graph, graph.sin(graph.input(0, k + other)));
    const Expr c(graph, graph.cos(graph.input(0, k)));
    const Expr turned = c * x - s * y;
    y = s * x + c * y;
    x = turned;
  }
  function.outputs = {x.ref()};
  return function;
}

/// A component grows by the root of 2 in a turn at most, and so does an error; by 2 of two angles.
TEST(OutputError, KnowsThatSquaresOfSineAndCosineMakeOne) {
  Box box(10, {-3.2, 3.2});
  box[8] = box[9] = {-1, 1};
  const double found = largest_error(turns(0), box, 2000);
  EXPECT_GE(bound(turns(0), box), found);
  EXPECT_LE(bound(turns(0), box), 30 * found);
  EXPECT_LE(bound(turns(0), box), 0.5 * bound(turns(4), box));
  EXPECT_GE(bound(turns(4), box), largest_error(turns(4), box, 2000));
}

TEST(OutputError, SaysWhyThereIsNone) {
  const auto obstacle = [](const program::Function& function, const Box& box) {
    OutputError error(function, function.outputs[0], kFloat);
    EXPECT_EQ(error(box), kInfinity);
    return error.obstacle();
  };
  const auto quotient = made([](auto&, Expr x, Expr y) { return x / y; });
  EXPECT_EQ(obstacle(quotient, {{1, 2}, {-1, 1}}), "a divisor may be zero");
  EXPECT_EQ(obstacle(quotient, {{1, 2}, {0, 1}}), "a divisor may be zero");
  const auto product = made([](auto&, Expr x, Expr y) { return x * y; });
  EXPECT_EQ(obstacle(product, {{0, 1e20}, {0, 1e20}}), "a value may overflow");
  EXPECT_LT(bound(product, {{0, 1e20}, {0, 1e20}}, {emit::Scalar::kDouble, {}}), 1e25);
  const auto root =
      made([](auto& graph, Expr x, Expr) { return Expr(graph, graph.sqrt(x.ref())); });
  EXPECT_EQ(obstacle(root, {{0, 1}, {0, 0}}), "what a root is drawn of may be zero");
  const auto sine = made([](auto& graph, Expr x, Expr) { return Expr(graph, graph.sin(x.ref())); });
  EXPECT_EQ(obstacle(sine, {{0, 2e5}, {0, 0}}), "an angle may leave the range of the sines");
}

/// The factors are never large together, which the whole box does not tell.
TEST(BoundsOver, AreSmallerOfPiecesAndStillBounds) {
  const auto difference = made([](auto&, Expr x, Expr y) { return (x + y) * (x - y); });
  const Box box = {{-1.9, 1.9}, {-1.9, 1.9}};
  double last = kInfinity;
  for (const int cuts : {0, 1, 10, 100}) {
    const BoundsOver over = bounds_over(difference, kFloat, {box, {2}, cuts});
    EXPECT_LE(over.largest, last);
    EXPECT_EQ(over.outputs[0], 2 * over.largest);
    EXPECT_GE(over.outputs[0], largest_error(difference, box));
    last = over.largest;
  }
  EXPECT_LT(last, bounds_over(difference, kFloat, {box, {2}, 0}).largest);
}

TEST(Interval, ContainsWhatOperationsGive) {
  support::Random uniform(5);
  for (int k = 0; k < 20000; ++k) {
    const auto range = [&] {
      const double a = uniform(-4, 4);
      const double b = uniform(-4, 4);
      return Interval{std::min(a, b), std::max(a, b)};
    };
    const Interval a = range();
    const Interval b = range();
    const long double x = uniform(a.low, a.high);
    const long double y = uniform(b.low, b.high);
    const auto expect_in = [](const Interval& result, long double value) {
      EXPECT_LE(static_cast<long double>(result.low), value);
      EXPECT_GE(static_cast<long double>(result.high), value);
    };
    expect_in(a + b, x + y);
    expect_in(a * b, x * y);
    expect_in(a / b, x / y);
    expect_in(square(a), x * x);
    expect_in(sin(a), std::sin(x));
    expect_in(cos(a), std::cos(x));
  }
}

TEST(Interval, OfWavesIsTight) {
  EXPECT_NEAR(cos(Interval{0.5, 1.5}).high, std::cos(0.5), 1e-14);
  EXPECT_NEAR(cos(Interval{0.5, 1.5}).low, std::cos(1.5), 1e-14);
  EXPECT_EQ(cos(Interval{-0.5, 0.25}).high, 1);
  EXPECT_NEAR(cos(Interval{-0.5, 0.25}).low, std::cos(0.5), 1e-14);
  EXPECT_EQ(sin(Interval{1, 2}).high, 1);
  EXPECT_EQ(sin(Interval{4, 5}).low, -1);
  EXPECT_EQ(sin(Interval{-1e300, 0}).low, -1);
}

}  // namespace
}  // namespace treedyn::accuracy
