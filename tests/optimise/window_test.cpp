#include "optimise/window.hpp"

#include <gtest/gtest.h>

#include "program/random_function.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

Function function_of(const Network& network, const Function& like) {
  Function function{like.signature, {}, {}};
  function.graph = graph_of(network, function.outputs);
  return function;
}

TEST(CutWindow, HasTheOperationsOfItsItems) {
  const Function chain = spatial_chain(5);
  const Network network = network_of(chain.graph, chain.outputs);
  Random random(3);
  const std::vector<int> items = random_neighbourhood(network, random, 40);
  EXPECT_GE(items.size(), 40U);
  int expected = 0;
  for (const int k : items) {
    expected += network.item(k).size - 1;
  }
  EXPECT_EQ(operations(cut_window(network, items).network), expected);
}

TEST(WithWindow, GivesBackTheWholeFromAnUnchangedWindow) {
  const Function chain = spatial_chain(5);
  const Network network = network_of(chain.graph, chain.outputs);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Window window = cut_window(network, random_neighbourhood(network, random, 30));
    const Network again = with_window(network, window);
    EXPECT_EQ(operations(again), operations(network)) << seed;
    EXPECT_LT(largest_difference(chain, function_of(again, chain), 1), Real(1e-40)) << seed;
  }
}

TEST(WithWindow, AcceptsAResultThatIsZeroOrAnInput) {
  Graph graph;
  const Ref a = graph.input(0, 0);
  const Ref b = graph.input(0, 1);
  const Ref difference = graph.add(a, -b);
  Function before{{"f", "", "", {{"q", 2, ""}}, {{"y", 1, ""}}}, {}, {}};
  before.outputs = {graph.add(graph.multiply(difference, a), b)};
  before.graph = std::move(graph);
  const Network network = network_of(before.graph, before.outputs);
  const int item = [&] {
    for (int k = 1; k < network.size(); ++k) {
      if (network.item(k).kind == Kind::kMultiply) {
        return k;
      }
    }
    return 0;
  }();
  Window window = cut_window(network, std::vector<int>{item});
  window.network.outputs()[0] = 0;
  const Network zero = with_window(network, window);
  EXPECT_EQ(operations(zero), 0);
  EXPECT_EQ(zero.item(zero.outputs()[0]).kind, Kind::kInput);
}

TEST(RandomNeighbourhood, IsAscendingAndWithoutLeaves) {
  const Function chain = spatial_chain(4);
  const Network network = network_of(chain.graph, chain.outputs);
  Random random(5);
  const std::vector<int> items = random_neighbourhood(network, random, 25);
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_FALSE(network.operands(items[i]).empty());
    EXPECT_TRUE(i == 0 || items[i - 1] < items[i]);
  }
}

}  // namespace
}  // namespace treedyn::optimise
