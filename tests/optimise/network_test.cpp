#include "optimise/network.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "program/random_function.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

/// a, b, c, d = q[0..3] of a function to be filled.
class NetworkOf : public ::testing::Test {
 protected:
  Ref input(int i) { return graph_.input(0, i); }
  Network network(std::initializer_list<Ref> outputs) {
    return network_of(graph_, std::vector<Ref>(outputs));
  }

  Graph graph_;
  const Ref a_ = input(0), b_ = input(1), c_ = input(2), d_ = input(3);
};

TEST_F(NetworkOf, MakesOneSumOfSumsThatNobodyElseNeeds) {
  const Network network = this->network({graph_.add(graph_.add(a_, b_), -graph_.add(c_, d_))});
  EXPECT_EQ(network.operands(network.outputs()[0]).size(), 4U);
  EXPECT_EQ(operations(network), 3);
}

TEST_F(NetworkOf, KeepsASumThatTwoOthersNeed) {
  const Ref shared = graph_.add(a_, b_);
  const Network network = this->network({graph_.add(shared, c_), graph_.add(shared, d_)});
  EXPECT_EQ(network.operands(network.outputs()[0]).size(), 2U);
  EXPECT_EQ(operations(network), 3);
}

TEST_F(NetworkOf, FindsEqualSumsInAnyOrderAndSign) {
  const Ref one = graph_.add(graph_.add(a_, b_), -c_);
  const Ref two = graph_.add(graph_.add(c_, -b_), -a_);
  const Network network = this->network({one, two});
  EXPECT_EQ(network.outputs()[0], -network.outputs()[1]);
  EXPECT_EQ(operations(network), 2);
}

TEST_F(NetworkOf, CancelsOppositeTermsAndCountsEqualOnes) {
  const Ref sum = graph_.add(graph_.add(a_, b_), graph_.add(a_, graph_.add(a_, -b_)));
  const Network network = this->network({sum});
  ASSERT_EQ(network.item(network.outputs()[0]).kind, Kind::kMultiply);
  EXPECT_EQ(operations(network), 1);
}

/// (a + a) - 2 a is zero here and not in the graph; 0.3 is the first of the constants.
TEST_F(NetworkOf, TakesAZeroThatAppearsForNoConstant) {
  const Ref scaled = graph_.multiply(graph_.constant(Real("0.3")), b_);
  const Ref none = graph_.add(graph_.add(a_, a_), -graph_.multiply(graph_.constant(2), a_));
  ASSERT_NE(none, 0);
  const Network network = this->network({scaled, none, graph_.add(none, graph_.constant(7))});
  EXPECT_EQ(network.outputs()[1], 0);
  const Ref seven = network.outputs()[2];
  ASSERT_TRUE(network.is_constant(seven));
  EXPECT_EQ(network.magnitude(seven), 7);
  EXPECT_GT(seven, 0);
}

TEST_F(NetworkOf, MultipliesConstantsOfOneProduct) {
  const Ref two = graph_.constant(2);
  const Ref three = graph_.constant(3);
  const Ref product = graph_.multiply(graph_.multiply(two, a_), graph_.multiply(three, b_));
  const Network network = this->network({product});
  EXPECT_EQ(operations(network), 2);
}

TEST_F(NetworkOf, MultipliesTheConstantOfAScaledValue) {
  const Ref scaled = graph_.multiply(graph_.constant(3), graph_.add(a_, b_));
  const Ref twice = graph_.multiply(graph_.constant(2), scaled);
  const Ref six = graph_.multiply(graph_.constant(6), graph_.add(b_, a_));
  const Network network = this->network({scaled, twice, six});
  EXPECT_EQ(network.outputs()[1], network.outputs()[2]);
}

TEST_F(NetworkOf, CanBecomeZero) {
  const Ref sum = graph_.add(graph_.add(a_, b_), -graph_.add(b_, a_));
  const Network network = this->network({sum, 0});
  EXPECT_EQ(network.outputs(), (std::vector<Ref>{0, 0}));
}

TEST(GraphOf, GivesBackTheFunction) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Function before = random_function(seed, 60);
    Function after{before.signature, {}, {}};
    after.graph = graph_of(network_of(before.graph, before.outputs), after.outputs);
    EXPECT_LT(largest_difference(before, after), Real(1e-40)) << seed;
    EXPECT_LE(cost(after).total(), cost(before).total()) << seed;
  }
}

TEST(GraphOf, CostsAtMostWhatTheNetworkCounts) {
  const Function chain = spatial_chain(6);
  const Network network = network_of(chain.graph, chain.outputs);
  std::vector<Ref> outputs;
  const Graph graph = graph_of(network, outputs);
  EXPECT_LE(cost(graph, outputs).total(), operations(network));
}

TEST(Normalise, PutsOperandsBeforeUsers) {
  const Function chain = spatial_chain(6);
  Network network = network_of(chain.graph, chain.outputs);
  const Ref pair[] = {1, 2};
  const int late = network.append(Kind::kAdd, pair);
  const Ref operands[] = {late, 3};
  network.outputs().push_back(network.append(Kind::kAdd, operands, 0));
  const Network normal = normalise(network);
  for (int k = 1; k < normal.size(); ++k) {
    for (const Ref operand : normal.operands(k)) {
      EXPECT_LT(std::abs(operand), k);
    }
  }
}

}  // namespace
}  // namespace treedyn::optimise
