#include "optimise/resubstitute.hpp"

#include <gtest/gtest.h>

#include "program/random_function.hpp"
#include "program/rounding.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

/// q = a, b, c, d; s and c of a.
class Resubstitute : public ::testing::Test {
 protected:
  Ref times(Ref x, Ref y) { return graph_.multiply(x, y); }
  Ref plus(Ref x, Ref y) { return graph_.add(x, y); }
  Ref square(Ref x) { return times(x, x); }

  /// Operations that are left; the values must be the same.
  int left(std::vector<Ref> outputs) {
    Function before{{"f", "", "", {{"q", 4, ""}}, {{"y", 1, ""}}}, graph_, outputs};
    Network network = network_of(graph_, outputs);
    resubstitute(network);
    network = normalise(network);
    Function after{before.signature, {}, {}};
    after.graph = graph_of(network, after.outputs);
    EXPECT_LT(largest_difference(before, after), Real(1e-40));
    EXPECT_LE(amplification(after, before), 16);
    return operations(network);
  }

  Graph graph_;
  const Ref a_ = graph_.input(0, 0), b_ = graph_.input(0, 1), c_ = graph_.input(0, 2),
            d_ = graph_.input(0, 3);
  const Ref sine_ = graph_.sin(a_), cosine_ = graph_.cos(a_);
};

TEST_F(Resubstitute, KnowsTheUnitCircle) {
  EXPECT_EQ(left({plus(b_, plus(square(sine_), square(cosine_))), graph_.constant(1)}), 1);
}

TEST_F(Resubstitute, UsesTheSquareOfTheCosine) {
  const Ref one = graph_.constant(1);
  const Ref cosine_squared = square(cosine_);
  EXPECT_EQ(left({cosine_squared, times(b_, plus(one, -square(sine_)))}), 2);
}

TEST_F(Resubstitute, UsesTheSquareOfTheSine) {
  const Ref one = graph_.constant(1);
  EXPECT_EQ(left({square(sine_), times(b_, plus(one, -square(cosine_)))}), 2);
}

TEST_F(Resubstitute, FindsZeros) {
  // s (c b) - c (s b), written so that no product is shared
  const Ref zero = plus(times(sine_, times(cosine_, b_)), -times(cosine_, times(sine_, b_)));
  EXPECT_EQ(left({zero, b_}), 0);
}

TEST_F(Resubstitute, TakesNoValueOfALongRecursionForZero) {
  // Bounds of rounding double at every step, the values stay as they are.
  const Ref factor = times(graph_.constant(Real("0.5")), plus(graph_.constant(1), square(b_)));
  Ref before = a_;
  Ref value = c_;
  for (int step = 0; step < 200; ++step) {
    const Ref next = plus(value, -times(factor, before));
    before = value;
    value = next;
  }
  EXPECT_EQ(left({value}), 403);
}

TEST_F(Resubstitute, FindsEqualValuesOfAnotherForm) {
  const Ref expanded = plus(times(b_, c_), times(b_, d_));
  const Ref factored = times(b_, plus(c_, d_));
  EXPECT_EQ(left({factored, plus(a_, expanded)}), 3);
}

TEST_F(Resubstitute, FindsASumOfExistingValues) {
  // (b + c) d and (b - c) d exist, 2 b d is their sum.
  const Ref plus_d = times(plus(b_, c_), d_);
  const Ref minus_d = times(plus(b_, -c_), d_);
  const Ref sum = plus(plus(times(b_, d_), times(a_, d_)), plus(times(b_, d_), -times(a_, d_)));
  EXPECT_LE(left({plus_d, minus_d, sum}), 5);
}

TEST_F(Resubstitute, FindsAProductOfExistingValues) {
  const Ref sum = plus(b_, c_);
  const Ref difference = plus(b_, -c_);
  EXPECT_EQ(left({sum, difference, plus(square(b_), -square(c_))}), 3);
}

TEST_F(Resubstitute, FindsAMultiple) {
  const Ref value = plus(times(graph_.constant(2), b_), times(graph_.constant(3), c_));
  const Ref multiple = plus(times(graph_.constant(4), b_), times(graph_.constant(6), c_));
  EXPECT_EQ(left({value, multiple}), 4);
}

TEST_F(Resubstitute, LeavesValuesThatOnlyAgreeRoughly) {
  const Ref one = times(graph_.constant(Real("0.3")), plus(b_, c_));
  const Ref two = times(graph_.constant(Real("0.30000000000000000000000001")), plus(b_, c_));
  EXPECT_EQ(left({one, two}), 3);
}

TEST_F(Resubstitute, DoesNotTakeSinesOfDifferentAnglesForEachOther) {
  const Ref other = graph_.sin(b_);
  EXPECT_EQ(left({plus(square(sine_), square(other)), square(cosine_)}), 4);
}

/// d + e x and x, where x = c a + c b and e x is nothing but what cancels in (d + e x) - d.
class Cancelled : public Resubstitute {
 protected:
  const Ref c_a_ = times(c_, a_), c_b_ = times(c_, b_);
  const Ref x_ = plus(c_a_, c_b_);
  const Ref small_ = graph_.constant(Real("1e-14"));
  const Ref sum_ = plus(d_, plus(times(times(small_, c_), a_), times(times(small_, c_), b_)));
  const Ref difference_ = plus(sum_, -d_);
};

TEST_F(Cancelled, SumsHaveNoMultiplesThatAmplifyTheirRounding) {
  EXPECT_LE(left({x_, sum_, difference_}), 10);
}

TEST_F(Cancelled, SumsAreNoFactorsThatAmplifyTheirRounding) {
  const Ref large = times(graph_.constant(Real("1e14")), square(d_));
  EXPECT_LE(
      left({plus(times(c_a_, square(d_)), times(c_b_, square(d_))), sum_, difference_, large}), 14);
}

TEST_F(Cancelled, SumsDoNotReplaceEqualValuesWithoutCancellation) {
  const Ref exact = plus(times(small_, c_a_), times(small_, c_b_));
  EXPECT_LE(left({difference_, sum_, exact}), 7);
}

TEST_F(Resubstitute, TakesTheSquareOfASmallTiltForNoZero) {
  // Tilts of 1e-16, as exporters write them, leave this of a cosine.
  const Ref cosine = graph_.constant(1 - Real("7.5e-33"));
  EXPECT_EQ(left({plus(b_, -times(cosine, b_))}), 2);
}

TEST_F(Resubstitute, TakesFunctionsOfConstantsForWhatTheyAre) {
  // A length that does not change, as a turned frame has it: 0.3 (s^2 + c^2).
  const Ref length = times(graph_.constant(Real("0.3")), plus(square(sine_), square(cosine_)));
  const Ref load = times(graph_.constant(Real("0.7")), graph_.sin(plus(length, length)));
  const Ref whole = plus(load, graph_.constant(Real("0.1")));
  EXPECT_GT(left({times(whole, b_), plus(length, c_)}), 0);
}

TEST(ResubstituteAtRandom, KeepsTheValues) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Function before = random_function(seed, 90);
    Network network = network_of(before.graph, before.outputs);
    const int operations_before = operations(network);
    resubstitute(network);
    network = normalise(network);
    EXPECT_LE(operations(network), operations_before) << seed;
    Function after{before.signature, {}, {}};
    after.graph = graph_of(network, after.outputs);
    EXPECT_LT(largest_difference(before, after), Real(1e-38)) << seed;
  }
}

}  // namespace
}  // namespace treedyn::optimise
