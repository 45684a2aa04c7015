#include <gtest/gtest.h>

#include "optimise/passes.hpp"
#include "program/random_function.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

class SharePairs : public ::testing::Test {
 protected:
  Ref times(Ref x, Ref y) { return graph_.multiply(x, y); }
  Ref plus(Ref x, Ref y) { return graph_.add(x, y); }
  int shared(Kind kind, std::initializer_list<Ref> outputs) {
    Network network = network_of(graph_, std::vector<Ref>(outputs));
    share_pairs(network, kind);
    return operations(normalise(network));
  }

  Graph graph_;
  const Ref a_ = graph_.input(0, 0), b_ = graph_.input(0, 1), c_ = graph_.input(0, 2),
            d_ = graph_.input(0, 3);
};

TEST_F(SharePairs, FindsAPairInTwoSums) {
  EXPECT_EQ(shared(Kind::kAdd, {plus(plus(a_, c_), b_), plus(plus(a_, d_), b_)}), 3);
}

TEST_F(SharePairs, FindsAPairOfOppositeSign) {
  EXPECT_EQ(shared(Kind::kAdd, {plus(plus(a_, c_), -b_), plus(plus(b_, d_), -a_)}), 3);
  EXPECT_EQ(shared(Kind::kAdd, {plus(plus(a_, c_), -b_), plus(plus(b_, d_), a_)}), 4);
}

TEST_F(SharePairs, UsesASumThatExists) {
  EXPECT_EQ(shared(Kind::kAdd, {plus(a_, b_), plus(plus(a_, c_), b_)}), 2);
}

TEST_F(SharePairs, FindsThreeTermsByPairs) {
  const Ref one = plus(plus(plus(a_, c_), b_), times(a_, a_));
  const Ref two = plus(plus(plus(c_, times(d_, d_)), b_), a_);
  EXPECT_EQ(shared(Kind::kAdd, {one, two}), 6);
}

TEST_F(SharePairs, FindsAPairInProducts) {
  EXPECT_EQ(shared(Kind::kMultiply, {times(times(a_, c_), b_), times(times(a_, d_), b_)}), 3);
}

TEST_F(SharePairs, FindsSquares) {
  EXPECT_EQ(shared(Kind::kMultiply, {times(times(a_, b_), a_), times(times(a_, c_), a_)}), 3);
}

TEST(SharePairsAtRandom, KeepsTheValuesForEverySeed) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Function before = random_function(seed, 80);
    Network network = network_of(before.graph, before.outputs);
    const int operations_before = operations(network);
    share_pairs(network, Kind::kAdd, seed % 4);
    network = normalise(network);
    share_pairs(network, Kind::kMultiply, seed % 4);
    network = normalise(network);
    EXPECT_LE(operations(network), operations_before) << seed;
    Function after{before.signature, {}, {}};
    after.graph = graph_of(network, after.outputs);
    EXPECT_LT(largest_difference(before, after), Real(1e-40)) << seed;
  }
}

}  // namespace
}  // namespace treedyn::optimise
