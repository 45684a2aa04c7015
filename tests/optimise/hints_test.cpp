#include "optimise/hints.hpp"

#include <string>

#include <gtest/gtest.h>

namespace treedyn::optimise {
namespace {

using namespace program;

struct TwoFunctions {
  Function from;
  Function to;
  Ref sum = 0;
};

/// from: omega = a + b + c of body 3 and y = omega d; to: the same, summed in another order.
TwoFunctions reordered_sum() {
  TwoFunctions f;
  Graph& old = f.from.graph;
  const Ref a = old.input(0, 0);
  const Ref b = old.input(0, 1);
  const Ref c = old.input(0, 2);
  const Ref omega = old.add(old.add(a, b), c);
  old.name(omega, "omega", 3, "x");
  f.from.outputs = {old.multiply(omega, old.input(0, 3))};
  Graph& made = f.to.graph;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(made.input(0, i), i + 1);
  }
  f.sum = made.add(a, made.add(b, c));
  f.to.outputs = {made.multiply(f.sum, made.input(0, 3))};
  return f;
}

TEST(TransferHints, NamesTheSameValueInAnotherForm) {
  TwoFunctions f = reordered_sum();
  transfer_hints(f.from, f.to);
  const Hint& hint = f.to.graph.hint(f.sum);
  ASSERT_NE(hint.symbol, nullptr);
  EXPECT_EQ(std::string(hint.symbol), "omega");
  EXPECT_EQ(hint.body, 3);
  EXPECT_EQ(std::string(hint.component), "x");
}

TEST(TransferHints, GivesTemporariesTheBodyOfTheirFirstUser) {
  TwoFunctions f = reordered_sum();
  transfer_hints(f.from, f.to);
  const Graph& graph = f.to.graph;
  const Ref inner = graph.node(f.sum).b;
  EXPECT_EQ(graph.hint(inner).symbol, nullptr);
  EXPECT_EQ(graph.hint(inner).body, 3);
}

TEST(TransferHints, DoesNotNameTheNegative) {
  Function from;
  const Ref a = from.graph.input(0, 0);
  const Ref b = from.graph.input(0, 1);
  from.graph.set_body(1);
  const Ref difference = from.graph.add(a, -b);
  from.graph.name(difference, "d", 1, "x");
  from.outputs = {difference};
  Function to;
  const Ref first = to.graph.input(0, 1);
  to.outputs = {-to.graph.add(first, -to.graph.input(0, 0))};
  transfer_hints(from, to);
  EXPECT_EQ(to.graph.hint(-to.outputs[0]).symbol, nullptr);
  EXPECT_EQ(to.graph.hint(-to.outputs[0]).body, 1);
}

TEST(TransferHints, DoesNotNameAnotherValue) {
  TwoFunctions f = reordered_sum();
  f.to.outputs = {f.to.graph.add(f.sum, f.to.graph.input(0, 3))};
  transfer_hints(f.from, f.to);
  EXPECT_EQ(f.to.graph.hint(f.to.outputs[0]).symbol, nullptr);
}

}  // namespace
}  // namespace treedyn::optimise
