#include "formulate/gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/read.hpp"

namespace treedyn::formulate {
namespace {

/// Adds `factor` q[0] to every output and takes it away again.
void cancel(program::Function& function, double factor) {
  program::Graph& graph = function.graph;
  const program::Ref large = graph.multiply(graph.constant(Real(factor)), graph.input(0, 0));
  for (program::Ref& output : function.outputs) {
    output = graph.add(graph.add(output, large), -large);
  }
}

/// The plain formulation, cancelled with the pass `algebra`.
Writer cancelling(const model::Tree& tree, const Recipe& recipe, const Options& options) {
  return [&](int /*seed*/) {
    program::Function function = build(tree, recipe, options, plain_variant(tree));
    if (options.has(Pass::kAlgebra)) {
      cancel(function, 1e12);
    }
    return function;
  };
}

TEST(Gate, LeavesOutThePassThatAmplifiesRounding) {
  const model::Tree tree = description::read_model(TREEDYN_SOURCE_DIR "/models/two_link.yaml", {});
  const Recipe& recipe = recipe_of("bias_force");
  const program::Function function = held_to_rounding(tree, recipe, {}, cancelling);
  EXPECT_THAT(function.rounding.left_out, testing::ElementsAre("algebra"));
  EXPECT_LE(function.rounding.amplification, 4);
  EXPECT_GT(function.rounding.refused, 1e9);
}

/// The same by `g_lost`, with the first seed of the algebraic search alone.
double g_lost = 0;
Writer unlucky(const model::Tree& tree, const Recipe& recipe, const Options& options) {
  return [&](int seed) {
    program::Function function = build(tree, recipe, options, plain_variant(tree));
    if (seed == 0 && options.has(Pass::kAlgebra)) {
      cancel(function, g_lost);
    }
    return function;
  };
}

TEST(Gate, TriesOtherSeedsWhereLittleIsLost) {
  const model::Tree tree = description::read_model(TREEDYN_SOURCE_DIR "/models/two_link.yaml", {});
  const Recipe& recipe = recipe_of("bias_force");
  Options options;
  options.effort = 0;
  g_lost = 0.1;
  double refused = 0;
  for (; refused == 0; g_lost *= 1.2) {
    refused = held_to_rounding(tree, recipe, options, unlucky).rounding.refused;
  }
  g_lost /= 1.2;
  ASSERT_LE(refused, 8);
  EXPECT_THAT(held_to_rounding(tree, recipe, options, unlucky).rounding.left_out,
              testing::ElementsAre("algebra"));
  options.effort = 10;
  const program::Function function = held_to_rounding(tree, recipe, options, unlucky);
  EXPECT_THAT(function.rounding.left_out, testing::IsEmpty());
  EXPECT_EQ(function.rounding.refused, 0);
}

TEST(Gate, LeavesFormulationsThatKeepTheirRoundingAlone) {
  const model::Tree tree = description::read_model(TREEDYN_SOURCE_DIR "/models/two_link.yaml", {});
  Options options;
  options.effort = 0;
  const program::Function function = formulated(tree, "bias_force", options);
  EXPECT_THAT(function.rounding.left_out, testing::IsEmpty());
  EXPECT_GT(function.rounding.amplification, 0);
  EXPECT_EQ(function.rounding.refused, 0);
}

}  // namespace
}  // namespace treedyn::formulate
