#include "program/schedule.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "program/random_function.hpp"

namespace treedyn::program {
namespace {

Measure measure(int room, int own_line = 0) {
  return {[](Ref) { return 4; }, [room](Ref) { return room; }, own_line};
}

Schedule schedule_all(const Graph& graph, const std::vector<Ref>& outputs,
                      const Measure& columns = measure(80)) {
  return schedule(graph, outputs, operations_in_order(graph, outputs, Trigonometry::kEarly),
                  columns);
}

class OperationsInOrder : public testing::TestWithParam<Trigonometry> {};

TEST_P(OperationsInOrder, KeepsEveryDefinitionBeforeItsFirstUse) {
  const Function function = random_function(7, 300);
  const std::vector<Ref> nodes = operations_in_order(function.graph, function.outputs, GetParam());
  std::set<Ref> done;
  for (const Ref k : nodes) {
    for_each_operand(function.graph.node(k), [&](Ref operand) {
      const Kind kind = function.graph.node(operand).kind;
      EXPECT_TRUE(kind == Kind::kConstant || kind == Kind::kInput ||
                  done.contains(std::abs(operand)));
    });
    EXPECT_TRUE(done.insert(k).second);
  }
  const std::vector<Ref> all = reachable(function.graph, function.outputs);
  const auto operations = std::count_if(all.begin(), all.end(), [&](Ref k) {
    const Kind kind = function.graph.node(k).kind;
    return kind != Kind::kConstant && kind != Kind::kInput;
  });
  EXPECT_EQ(nodes.size(), static_cast<std::size_t>(operations));
}

TEST_P(OperationsInOrder, KeepsSineAndCosineOfOneAngleTogether) {
  Graph g;
  const Ref q = g.input(0, 0);
  const Ref s = g.sin(q);
  const Ref x = g.add(g.multiply(s, s), g.input(0, 1));
  const Ref c = g.cos(q);
  const std::vector<Ref> outputs = {x, c};
  const std::vector<Ref> nodes = operations_in_order(g, outputs, GetParam());
  const auto at_s = std::find(nodes.begin(), nodes.end(), s);
  const auto at_c = std::find(nodes.begin(), nodes.end(), c);
  EXPECT_EQ(std::abs(at_s - at_c), 1);
}

INSTANTIATE_TEST_SUITE_P(Trigonometry, OperationsInOrder,
                         testing::Values(Trigonometry::kEarly, Trigonometry::kLate));

TEST(LateTrigonometry, StandsBehindWhatDoesNotNeedIt) {
  Graph g;
  const Ref angle = g.add(g.input(0, 0), g.input(0, 1));
  const Ref s = g.sin(angle);
  const Ref c = g.cos(g.input(0, 0));
  const Ref before = g.multiply(g.input(0, 1), g.input(0, 1));
  const Ref first_use = g.add(before, s);
  const std::vector<Ref> outputs = {g.multiply(first_use, c), c};
  EXPECT_EQ(operations_in_order(g, outputs, Trigonometry::kEarly),
            (std::vector<Ref>{angle, s, c, before, first_use, outputs.front()}));
  EXPECT_EQ(operations_in_order(g, outputs, Trigonometry::kLate),
            (std::vector<Ref>{before, angle, s, first_use, c, outputs.front()}));
}

TEST(Fused, CountsSumsWithAProductOfNoOtherUse) {
  Function function;
  Graph& g = function.graph;
  const Ref x = g.input(0, 0);
  const Ref y = g.input(0, 1);
  const Ref shared = g.multiply(x, x);
  const Ref two_products = g.add(g.multiply(x, y), g.multiply(y, y));  // the second one is fused
  const Ref of_shared = g.add(shared, y);
  function.outputs = {two_products, of_shared, -shared, g.add(x, y)};
  EXPECT_EQ(cost(function).fused, 1);
}

TEST(Schedule, InlinesAProductIntoItsSum) {
  Graph g;
  const Ref product = g.multiply(g.input(0, 0), g.input(0, 1));
  const Ref sum = g.add(product, g.input(0, 2));
  const Schedule result = schedule_all(g, {sum});
  EXPECT_TRUE(result.is_inlined(product));
  EXPECT_EQ(result.statements, (std::vector<Ref>{sum}));
}

TEST(Schedule, GivesAValueWithTwoUsesItsOwnStatement) {
  Graph g;
  const Ref product = g.multiply(g.input(0, 0), g.input(0, 1));
  const Ref first = g.add(product, g.input(0, 2));
  const Ref second = g.add(product, g.input(0, 3));
  const Schedule result = schedule_all(g, {first, second});
  EXPECT_EQ(result.statements, (std::vector<Ref>{product, first, second}));
}

TEST(Schedule, GivesNamedSumsTheirOwnStatement) {
  Graph g;
  const Ref sum = g.add(g.input(0, 0), g.input(0, 1));
  g.name(sum, "omega", 0, "x");
  const Ref product = g.multiply(sum, g.input(0, 2));
  EXPECT_EQ(schedule_all(g, {product}).statements, (std::vector<Ref>{sum, product}));
}

TEST(Schedule, MakesTwoStatementsOfWhatDoesNotFit) {
  Graph g;
  const Ref left = g.multiply(g.input(0, 0), g.input(0, 1));
  const Ref right = g.multiply(g.input(0, 2), g.input(0, 3));
  const Ref sum = g.add(left, right);
  const Schedule result = schedule_all(g, {sum}, measure(20));
  EXPECT_EQ(result.statements.size(), 2U);
  EXPECT_NE(result.is_inlined(left), result.is_inlined(right));
}

TEST(Schedule, GivesASumWithAProductALineOfItsOwn) {
  Graph g;
  const Ref product = g.multiply(g.input(0, 0), g.input(0, 1));
  const Ref sum = g.add(g.input(0, 2), product);  // 4 + 3 + (4 + 3 + 4) columns
  EXPECT_EQ(schedule_all(g, {sum}, measure(15, 18)).statements, (std::vector<Ref>{sum}));
  EXPECT_EQ(schedule_all(g, {sum}, measure(15, 17)).statements, (std::vector<Ref>{product, sum}));
}

TEST(Schedule, TakesOtherThingsThanTheProductOutOfASum) {
  Graph g;
  const Ref factor = g.add(g.input(0, 0), g.input(0, 1));
  const Ref product = g.multiply(factor, g.input(0, 2));
  const Ref quotient = g.divide(g.input(0, 3), g.input(0, 4));
  const Ref sum = g.add(quotient, product);
  const Schedule result = schedule_all(g, {sum}, measure(20));
  EXPECT_EQ(result.statements, (std::vector<Ref>{quotient, factor, sum}));
  EXPECT_TRUE(result.is_inlined(product));
}

TEST(Shape, PutsParenthesesWhereTheGraphGroupsOtherwise) {
  Graph g;
  const Ref a = g.input(0, 0);
  const Ref b = g.input(0, 1);
  const Ref c = g.input(0, 2);
  const Ref difference = g.add(a, -g.add(b, c));
  const Schedule one = schedule_all(g, {difference});
  EXPECT_TRUE(shape(g, g.node(difference), one).second_in_parentheses);
  const Ref quotient = g.divide(a, g.multiply(b, c));
  const Schedule two = schedule_all(g, {quotient});
  EXPECT_TRUE(shape(g, g.node(quotient), two).second_in_parentheses);
}

TEST(Shape, SwapsASumToTheFrontInsteadOfParentheses) {
  Graph g;
  const Ref a = g.input(0, 0);
  const Ref sum = g.add(a, g.add(g.input(0, 1), g.input(0, 2)));
  const Shape form = shape(g, g.node(sum), schedule_all(g, {sum}));
  EXPECT_TRUE(form.swapped);
  EXPECT_FALSE(form.first_in_parentheses || form.second_in_parentheses);
}

}  // namespace
}  // namespace treedyn::program
