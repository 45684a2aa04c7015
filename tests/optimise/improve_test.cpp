#include "optimise/improve.hpp"

#include <gtest/gtest.h>

#include "optimise/optimise.hpp"
#include "program/random_function.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

TEST(Improve, FindsAFactorThatNoGreedyStepSees) {
  // a (b + c) - a b + d: multiplied out, a b cancels.
  Graph graph;
  const Ref a = graph.input(0, 0);
  const Ref b = graph.input(0, 1);
  const Ref c = graph.input(0, 2);
  const Ref ab = graph.multiply(a, b);
  const Ref sum = graph.add(graph.multiply(a, graph.add(b, c)), -ab);
  const Network network = network_of(graph, std::vector<Ref>{graph.add(sum, graph.input(0, 3))});
  EXPECT_EQ(operations(network), 5);
  EXPECT_EQ(operations(improve(network, 20, RoundingGuard(network))), 2);
}

TEST(Improve, KeepsTheValuesAndNeverAddsOperations) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Function before = random_function(seed, 100);
    const Function after = optimised(before, {3, 100});
    EXPECT_LT(largest_difference(before, after), Real(1e-38)) << seed;
    EXPECT_LE(cost(after).total(), cost(optimised(before)).total()) << seed;
  }
}

TEST(Improve, FindsMoreThanTheGreedyPassesInAChain) {
  const Function before = spatial_chain(5);
  EXPECT_LT(cost(optimised(before, {3, 500})).total(), cost(optimised(before)).total());
}

TEST(Improve, LosesAtMostAFactorFourOfAccuracy) {
  for (const int links : {2, 4, 6}) {
    const Function before = spatial_chain(links);
    EXPECT_LT(rounding_error(optimised(before, {3, 2000})), 4 * rounding_error(before)) << links;
  }
}

TEST(Improve, DependsOnTheSeedAlone) {
  const Function chain = spatial_chain(4);
  const Network start = network_of(chain.graph, chain.outputs);
  const RoundingGuard guard(start);
  EXPECT_EQ(operations(improve(start, 200, guard, 7)), operations(improve(start, 200, guard, 7)));
}

}  // namespace
}  // namespace treedyn::optimise
