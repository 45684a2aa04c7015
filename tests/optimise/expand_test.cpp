#include <gtest/gtest.h>

#include "optimise/passes.hpp"
#include "program/random_function.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

TEST(ExpandAtRandom, MultipliesOut) {
  Graph graph;
  const Ref a = graph.input(0, 0);
  const Ref sum = graph.add(graph.input(0, 1), graph.input(0, 2));
  Network network = network_of(graph, std::vector<Ref>{graph.multiply(a, sum)});
  Random random(1);
  expand_at_random(network, random, 1);
  network = normalise(network);
  EXPECT_EQ(network.item(network.outputs()[0]).kind, Kind::kAdd);
  EXPECT_EQ(operations(network), 3);
}

TEST(ExpandAtRandom, WritesOutASharedSum) {
  Graph graph;
  const Ref shared = graph.add(graph.input(0, 0), graph.input(0, 1));
  const Ref user = graph.add(graph.input(0, 2), -shared);
  Network network = network_of(graph, std::vector<Ref>{shared, user});
  Random random(1);
  expand_at_random(network, random, 1);
  network = normalise(network);
  EXPECT_EQ(network.operands(network.outputs()[1]).size(), 3U);
  EXPECT_EQ(operations(network), 3);
}

TEST(ExpandAtRandom, KeepsTheValues) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Function before = random_function(seed, 80);
    Network network = network_of(before.graph, before.outputs);
    Random random(seed);
    expand_at_random(network, random, 8);
    Function after{before.signature, {}, {}};
    after.graph = graph_of(normalise(network), after.outputs);
    EXPECT_LT(largest_difference(before, after), Real(1e-40)) << seed;
  }
}

TEST(ExpandAtRandom, LeavesNothingToExpandAlone) {
  Graph graph;
  Network network = network_of(graph, std::vector<Ref>{graph.input(0, 0), 0});
  Random random(1);
  expand_at_random(network, random, 3);
  EXPECT_EQ(operations(normalise(network)), 0);
}

}  // namespace
}  // namespace treedyn::optimise
