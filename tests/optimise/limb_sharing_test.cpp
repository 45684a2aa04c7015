#include "optimise/limb_sharing.hpp"

#include <gtest/gtest.h>

#include "program/interpret.hpp"

namespace treedyn::optimise {
namespace {

using namespace program;

/// Two limbs with one joint each, the second one's mirrored, and one column of constants 2, 3.
Limbs two_limbs() {
  LimbClass limbs;
  limbs.links = {{0}, {1}};
  limbs.joints = {{{0, 1}}, {{1, -1}}};
  limbs.columns = {{Real(2), Real(3)}};
  return {limbs};
}

struct Leaves {
  Ref joint = 0;
  Ref constant = 0;
};

Leaves leaves(Graph& graph, int limb) {
  return {graph.input(kLimbInputs, limb), graph.input(kFixedArrays, limb)};
}

/// x_l = sin(joint) c + u[2] for both limbs; outputs x_0 + x_1 + u[2], x_0, -x_1.
Function symmetric() {
  Function f;
  f.signature = {"f", "", "", {{"u", 3, ""}}, {{"x", 3, ""}}};
  Graph& g = f.graph;
  Ref x[2] = {};
  for (int limb = 0; limb < 2; ++limb) {
    const Leaves own = leaves(g, limb);
    x[limb] = g.add(g.multiply(g.sin(own.joint), own.constant), g.input(0, 2));
  }
  f.outputs = {g.add(g.add(x[0], x[1]), g.input(0, 2)), x[0], -x[1]};
  return f;
}

TEST(LimbCode, ComputesWhatIsEqualOnceALimb) {
  const auto code = limb_code(symmetric(), two_limbs(), std::nullopt);
  ASSERT_NE(code, nullptr);
  ASSERT_EQ(code->phases.size(), 1U);
  EXPECT_EQ(cost(code->phases[0].function),
            (Cost{.add = 1, .mul = 1, .sin = 1, .fused = 1, .angles = 1, .twos = 1, .fours = 1}));
  EXPECT_EQ(cost(code->trunk), (Cost{.add = 2}));
  EXPECT_EQ(cost(*code),
            (Cost{.add = 4, .mul = 2, .sin = 2, .fused = 2, .angles = 2, .twos = 2, .fours = 2}));
}

TEST(LimbCode, HasTheValuesOfTheFunctionInEveryLimb) {
  const Function f = symmetric();
  const Function made = flat(limb_code(f, two_limbs(), Effort{}), f.signature);
  const std::vector<double> u = {0.5, 0.25, 4};
  const std::vector<double> x = interpret<double>(made, {u});
  const double x0 = std::sin(0.5) * 2 + 4;
  const double x1 = std::sin(-0.25) * 3 + 4;
  EXPECT_DOUBLE_EQ(x[0], x0 + x1 + 4);
  EXPECT_DOUBLE_EQ(x[1], x0);
  EXPECT_DOUBLE_EQ(x[2], -x1);
}

TEST(LimbCode, LeavesToTheTrunkWhatOneLimbAloneHas) {
  Function f = symmetric();
  const Leaves first = leaves(f.graph, 0);
  f.outputs[0] = f.graph.cos(first.joint);
  const auto code = limb_code(f, two_limbs(), std::nullopt);
  ASSERT_NE(code, nullptr);
  EXPECT_EQ(cost(code->trunk), (Cost{.cos = 1, .angles = 1, .twos = 1, .fours = 1}));
}

TEST(LimbCode, IsNullIfTheLimbsHaveNothingInCommon) {
  Function f = symmetric();
  const Leaves first = leaves(f.graph, 0);
  f.outputs = {f.graph.cos(first.joint), 0, 0};
  EXPECT_EQ(limb_code(f, two_limbs(), std::nullopt), nullptr);
}

// y_l = x_l (x_0 + x_1): the limbs wait for the trunk, which waits for the limbs.
TEST(LimbCode, ReturnsToTheLimbsBehindTheTrunk) {
  Function f = symmetric();
  Graph& g = f.graph;
  const Ref total = f.outputs[0];
  f.outputs = {total, g.multiply(f.outputs[1], total), g.multiply(-f.outputs[2], total)};
  const auto code = limb_code(f, two_limbs(), std::nullopt);
  ASSERT_NE(code, nullptr);
  ASSERT_EQ(code->phases.size(), 2U);
  EXPECT_EQ(code->phases[1].stage, 1);
  EXPECT_EQ(cost(code->phases[1].function), (Cost{.mul = 1}));
}

// The limbs' x cancels in the only output that remains: c joint - c joint.
TEST(LimbCode, IsNullIfTheLimbsComputeNothingThatIsNeeded) {
  Function f = symmetric();
  Graph& g = f.graph;
  Ref x[2] = {};
  for (int limb = 0; limb < 2; ++limb) {
    const Leaves own = leaves(g, limb);
    const Ref product = g.multiply(g.constant(2), g.multiply(own.joint, own.constant));
    x[limb] = g.add(product, -g.multiply(g.add(own.joint, own.joint), own.constant));
  }
  f.outputs = {g.add(g.add(x[0], x[1]), g.input(0, 2)), 0, 0};
  EXPECT_NE(limb_code(f, two_limbs(), std::nullopt), nullptr);
  EXPECT_EQ(limb_code(f, two_limbs(), Effort{}), nullptr);
}

// Both limbs also compute a zero, y = 2 c joint - c (joint + joint).
TEST(LimbCode, HasNoValuesThatAreNumbers) {
  Function f = symmetric();
  Graph& g = f.graph;
  Ref sum = f.outputs[0];
  for (int limb = 0; limb < 2; ++limb) {
    const Leaves own = leaves(g, limb);
    const Ref product = g.multiply(g.constant(2), g.multiply(own.joint, own.constant));
    sum = g.add(sum, g.add(product, -g.multiply(g.add(own.joint, own.joint), own.constant)));
  }
  f.outputs[0] = sum;
  const auto code = limb_code(f, two_limbs(), Effort{});
  ASSERT_NE(code, nullptr);
  const auto computed = std::ranges::count_if(
      code->values[0], [](const LimbCode::Value& value) { return value.stage >= 0; });
  EXPECT_EQ(computed, 1);
  const std::vector<double> u = {0.5, 0.25, 4};
  EXPECT_EQ(
      interpret<double>(flat(code, f.signature), {u}),
      interpret<double>(flat(limb_code(symmetric(), two_limbs(), Effort{}), f.signature), {u}));
}

// c (c joint) = (c c) joint, c 1/c = 1: nothing remains to be computed for numbers.
TEST(FoldLimbConstants, MakesColumnsOfOperationsOnConstants) {
  Limbs limbs = two_limbs();
  Function f = symmetric();
  Graph& g = f.graph;
  const Leaves second = leaves(g, 1);
  const Ref inverse = g.divide(g.constant(1), second.constant);
  f.outputs = {g.multiply(second.constant, g.multiply(second.constant, second.joint)),
               g.multiply(second.constant, inverse),
               g.multiply(g.constant(5), leaves(g, 0).constant)};
  const Function folded = fold_limb_constants(f, limbs);
  EXPECT_EQ(cost(folded), (Cost{.mul = 1}));
  EXPECT_EQ(limbs[0].columns[1], (std::vector<Real>{Real(4), Real(9)}));
  EXPECT_EQ(folded.graph.value(folded.outputs[1]), 1);
  EXPECT_EQ(limbs[0].columns[2], (std::vector<Real>{Real(10), Real(15)}));
}

}  // namespace
}  // namespace treedyn::optimise
