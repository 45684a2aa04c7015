// What float loses of a function.
#include "program/rounding.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace treedyn::program {
namespace {

constexpr double kRounding = double{std::numeric_limits<float>::epsilon()} / 2;

class FloatError : public ::testing::Test {
 protected:
  double of(std::vector<Ref> outputs) {
    const int size = static_cast<int>(outputs.size());
    return float_error({{"f", "", "", {{"q", 2, ""}}, {{"y", size, ""}}}, graph_, outputs});
  }
  Ref number(const char* x) { return graph_.constant(Real(x)); }

  Graph graph_;
  const Ref a_ = graph_.input(0, 0), b_ = graph_.input(0, 1);
};

TEST_F(FloatError, IsARoundingOfOneOperation) {
  EXPECT_EQ(of({a_}), 0);  // inputs are what float has
  for (const Ref y : {graph_.add(a_, b_), graph_.multiply(a_, b_), graph_.divide(a_, b_)}) {
    EXPECT_GT(of({y}), 0);
    EXPECT_LE(of({y}), kRounding * (1 + 1e-6));
  }
}

/// (1e4 + a) - 1e4 b/b: what is left of 1e4 after rounding, as a part of a.
TEST_F(FloatError, SeesWhatCancels) {
  const Ref large = number("1e4");
  const Ref sum = graph_.add(a_, large);
  const Ref same = graph_.divide(graph_.multiply(large, b_), b_);
  const double error = of({graph_.add(sum, -same)});
  EXPECT_GT(error, 1e4 * kRounding / 30);  // of one of eight states at least
  EXPECT_LT(error, 1);
}

TEST_F(FloatError, IsAPartOfTheLargestOutput) {
  const Ref sum = graph_.add(a_, number("1e4"));
  const Ref small = graph_.add(sum, -graph_.divide(graph_.multiply(number("1e4"), b_), b_));
  EXPECT_LE(of({small, graph_.multiply(number("1e4"), sum)}), 4 * kRounding);
}

TEST_F(FloatError, IsInfiniteWhereFloatHasNoResult) {
  const Ref huge = graph_.multiply(a_, number("1e30"));
  EXPECT_EQ(of({graph_.divide(a_, graph_.multiply(huge, huge))}), 1);  // all of it: zero
  EXPECT_EQ(of({graph_.multiply(huge, huge)}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace treedyn::program
