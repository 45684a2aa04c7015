#include "optimise/optimise.hpp"

#include <string>

#include <gtest/gtest.h>

#include "program/random_function.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

TEST(Optimise, KeepsValuesAndNeverAddsOperations) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Function before = random_function(seed, 20 + static_cast<int>(seed) * 3);
    const Function after = optimised(before);
    const Cost a = cost(before);
    const Cost b = cost(after);
    EXPECT_LT(largest_difference(before, after), Real(1e-38)) << seed;
    EXPECT_LE(b.total(), a.total()) << seed;
    EXPECT_LE(b.sin, a.sin) << seed;
    EXPECT_LE(b.cos, a.cos) << seed;
  }
}

TEST(Optimise, ImprovesTheChain) {
  const Function before = spatial_chain(6);
  const Function after = optimised(before);
  EXPECT_LT(largest_difference(before, after), Real(1e-40));
  EXPECT_LT(cost(after).total(), cost(before).total());
}

TEST(Optimise, ImprovesThePlanarArm) {
  const Function before = planar_arm();
  const Function after = optimised(before);
  EXPECT_LT(largest_difference(before, after), Real(1e-40));
  EXPECT_LT(cost(after).total(), cost(before).total());
}

TEST(Optimise, LosesAtMostAFactorFourOfAccuracy) {
  for (const int links : {2, 4, 6, 10}) {
    const Function before = spatial_chain(links);
    for (const Effort& effort : {Effort{}, Effort{3, 1000}}) {
      EXPECT_LT(rounding_error(optimised(before, effort)), 4 * rounding_error(before)) << links;
    }
  }
}

TEST(Optimise, GivesTheSameGraphTwice) {
  const Function before = spatial_chain(5);
  const Function one = optimised(before);
  const Function two = optimised(before);
  ASSERT_EQ(one.graph.size(), two.graph.size());
  EXPECT_EQ(one.outputs, two.outputs);
  for (Ref k = 1; k < static_cast<Ref>(one.graph.size()); ++k) {
    EXPECT_EQ(one.graph.node(k).a, two.graph.node(k).a);
    EXPECT_EQ(one.graph.node(k).b, two.graph.node(k).b);
  }
}

TEST(Optimise, KeepsNamesAndTheOrderOfBodies) {
  const Function after = optimised(spatial_chain(8));
  int named = 0;
  int last = 0;
  for (Ref k = 1; k < static_cast<Ref>(after.graph.size()); ++k) {
    const Hint& hint = after.graph.hint(k);
    if (hint.symbol != nullptr && std::string(hint.symbol) == "omega") {
      EXPECT_GE(hint.body, last);
      last = hint.body;
      ++named;
    }
  }
  EXPECT_GE(named, 8);
  EXPECT_EQ(last, 7);
}

TEST(Optimise, KeepsTheSignatureAndZeroOutputs) {
  Function before = planar_arm();
  before.outputs.push_back(0);
  const Function after = optimised(before);
  EXPECT_EQ(after.signature.outputs[0].name, "tau");
  ASSERT_EQ(after.outputs.size(), 4U);
  EXPECT_EQ(after.outputs[3], 0);
}

TEST(Optimise, HandlesTwoHundredThousandNodes) {
  const Function before = spatial_chain(1500);
  ASSERT_GT(before.graph.size(), 200000U);
  EXPECT_LT(cost(optimised(before, {1, 0})).total(), cost(before).total());
}

TEST(EstimateOperations, IsBetweenTheBestAndTheOriginal) {
  const Function before = spatial_chain(6);
  const int estimate = estimate_operations(before.graph, before.outputs);
  EXPECT_LE(estimate, cost(before).total());
  EXPECT_GE(estimate, cost(optimised(before)).total());
}

}  // namespace
}  // namespace treedyn::optimise
