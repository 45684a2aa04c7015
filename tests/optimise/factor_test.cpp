#include <gtest/gtest.h>

#include "optimise/passes.hpp"
#include "program/random_function.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

class FactorSums : public ::testing::Test {
 protected:
  Ref times(Ref x, Ref y) { return graph_.multiply(x, y); }
  Ref plus(Ref x, Ref y) { return graph_.add(x, y); }
  /// Operations left after factoring.
  int factored(std::initializer_list<Ref> outputs) {
    Network network = network_of(graph_, std::vector<Ref>(outputs));
    const int before = operations(network);
    const int saved = factor_sums(network);
    const int after = operations(normalise(network));
    EXPECT_GE(before - after, saved);
    return after;
  }

  Graph graph_;
  const Ref a_ = graph_.input(0, 0), b_ = graph_.input(0, 1), c_ = graph_.input(0, 2),
            d_ = graph_.input(0, 3);
};

TEST_F(FactorSums, TakesOutACommonFactor) {
  EXPECT_EQ(factored({plus(plus(times(a_, b_), -times(a_, c_)), times(a_, d_))}), 3);
}

TEST_F(FactorSums, TakesOutACommonConstant) {
  const Ref k = graph_.constant(Real("0.3"));
  EXPECT_EQ(factored({plus(times(k, a_), plus(times(k, b_), c_))}), 3);
}

TEST_F(FactorSums, AddsTheConstantsOfEqualProducts) {
  const Ref k = graph_.constant(Real("0.3"));
  const Ref m = graph_.constant(Real("0.4"));
  const Ref one = times(times(k, a_), b_);
  const Ref two = times(times(m, b_), a_);
  EXPECT_EQ(factored({plus(one, two)}), 2);
}

TEST_F(FactorSums, CountsTheTermThatIsTheFactor) {
  EXPECT_EQ(factored({plus(a_, plus(times(a_, b_), times(a_, c_)))}), 3);  // a (1 + b + c)
}

TEST_F(FactorSums, PrefersTheFactorOfMostTerms) {
  const Ref sum = plus(plus(times(a_, b_), times(b_, c_)), plus(times(a_, c_), times(a_, d_)));
  EXPECT_EQ(factored({sum}), 5);  // a (b + c + d) + b c
}

TEST_F(FactorSums, LeavesAProductThatIsNeededElsewhere) {
  const Ref shared = times(a_, b_);
  EXPECT_EQ(factored({plus(shared, times(a_, c_)), plus(shared, d_)}), 4);
}

TEST_F(FactorSums, FactorsSquares) {
  EXPECT_EQ(factored({plus(times(a_, a_), times(a_, b_))}), 2);  // a (a + b)
}

TEST(FactorSumsAtRandom, KeepsTheValuesForEverySeed) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Function before = random_function(seed, 80);
    Network network = network_of(before.graph, before.outputs);
    const int operations_before = operations(network);
    factor_sums(network, seed % 4);
    network = normalise(network);
    EXPECT_LE(operations(network), operations_before) << seed;
    Function after{before.signature, {}, {}};
    after.graph = graph_of(network, after.outputs);
    EXPECT_LT(largest_difference(before, after), Real(1e-40)) << seed;
  }
}

}  // namespace
}  // namespace treedyn::optimise
