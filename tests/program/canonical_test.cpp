#include "program/canonical.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "program/fingerprint.hpp"

namespace treedyn::program {
namespace {

/// Evaluates two operands as one compiler or another would.
template <class First, class Second>
std::pair<Ref, Ref> operands(bool left_first, First first, Second second) {
  std::pair<Ref, Ref> result;
  if (left_first) {
    result.first = first();
    result.second = second();
  } else {
    result.second = second();
    result.first = first();
  }
  return result;
}

/// v = x y - sin z, named, and w = v / (cos z + 3 (z - x)); outputs w and -v.
Function written(bool left_first) {
  Function f;
  Graph& g = f.graph;
  const auto x = [&] {
    return g.input(0, 0);
  };
  const auto z = [&] {
    return g.input(0, 2);
  };
  const auto [product, sine] = operands(
      left_first, [&] { return g.multiply(x(), g.input(0, 1)); }, [&] { return g.sin(z()); });
  const Ref v = g.add(product, -sine);
  g.name(v, "v", 4, "x");
  const auto [cosine, distance] = operands(
      left_first, [&] { return g.cos(z()); },
      [&] { return g.multiply(g.constant(3), g.add(z(), -x())); });
  f.outputs = {g.divide(v, g.add(cosine, distance)), -v};
  return f;
}

std::vector<std::vector<int>> nodes_of(const Function& f) {
  std::vector<std::vector<int>> nodes;
  for (Ref k = 1; k < static_cast<Ref>(f.graph.size()); ++k) {
    const Node& node = f.graph.node(k);
    nodes.push_back({static_cast<int>(node.kind), node.a, node.b});
  }
  return nodes;
}

TEST(Canonical, GivesOneGraphWhateverOperandWasMadeFirst) {
  ASSERT_NE(nodes_of(written(true)), nodes_of(written(false)));
  const Function a = canonical(written(true));
  const Function b = canonical(written(false));
  EXPECT_EQ(nodes_of(a), nodes_of(b));
  EXPECT_EQ(a.outputs, b.outputs);
}

TEST(Canonical, KeepsTheNameOfAValueAndNotOfItsNegative) {
  for (const bool left_first : {true, false}) {
    const Function f = canonical(written(left_first));
    const Ref minus_v = f.outputs[1];
    ASSERT_NE(f.graph.hint(-minus_v).symbol, nullptr);
    EXPECT_EQ(std::string(f.graph.hint(-minus_v).symbol), "v");
    EXPECT_EQ(f.graph.hint(-minus_v).body, 4);
    EXPECT_EQ(f.graph.hint(minus_v).symbol, nullptr);
  }
}

TEST(Canonical, KeepsValuesAndCost) {
  const Function before = written(false);
  const Function after = canonical(before);
  EXPECT_EQ(cost(before), cost(after));
  const auto x = fingerprint<Real>(before.graph, before.outputs, 1);
  const auto y = fingerprint<Real>(after.graph, after.outputs, 1);
  for (std::size_t k = 0; k < before.outputs.size(); ++k) {
    const Ref a = before.outputs[k];
    const Ref b = after.outputs[k];
    EXPECT_EQ(x[static_cast<std::size_t>(std::abs(a))] * (a < 0 ? -1 : 1),
              y[static_cast<std::size_t>(std::abs(b))] * (b < 0 ? -1 : 1));
  }
}

TEST(Canonical, KeepsSectionsInOrder) {
  Function f;
  const Ref late = f.graph.input(0, 1);
  const Ref square = f.graph.multiply(late, late);
  f.graph.set_body(1);
  const Ref sine = f.graph.sin(f.graph.input(0, 0));
  f.outputs = {f.graph.add(sine, square)};
  const Function g = canonical(f);
  EXPECT_EQ(g.graph.node(1).b, 1);
  EXPECT_EQ(g.graph.node(2).kind, Kind::kMultiply);
  EXPECT_EQ(g.graph.node(4).kind, Kind::kSin);
}

TEST(Canonical, LeavesOutWhatNoOutputNeeds) {
  Function f;
  f.graph.sin(f.graph.input(0, 7));
  f.outputs = {f.graph.cos(f.graph.input(0, 0))};
  EXPECT_EQ(canonical(f).graph.size(), 3U);
}

}  // namespace
}  // namespace treedyn::program
