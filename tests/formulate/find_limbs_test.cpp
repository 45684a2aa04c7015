// Limbs that share code: found where subtrees are alike, and never other values, however different
// the limbs are.
#include "formulate/find_limbs.hpp"

#include <gtest/gtest.h>

#include "formulate/functions.hpp"
#include "optimise/limb_sharing.hpp"
#include "program/interpret.hpp"
#include "support/random_tree.hpp"

namespace treedyn::formulate {
namespace {

using Values = std::vector<Real>;

model::Tree tree(const std::vector<int>& father, const std::string& types) {
  support::Dice dice(7);
  return support::random_tree({father, types}, dice);
}

TEST(FindLimbs, TakesSonsOfOneFatherWithEqualSubtrees) {
  const model::Tree robot = tree({-1, 0, 1, 0, 3, 0, 5}, "RRPRPRR");
  EXPECT_EQ(find_limbs(robot), (std::vector<LimbLinks>{{{1, 2}, {3, 4}}}));
}

TEST(FindLimbs, LooksFurtherOutWhereSonsDiffer) {
  const model::Tree robot = tree({-1, 0, 0, 1, 1, 2}, "RRPRRR");
  EXPECT_EQ(find_limbs(robot), (std::vector<LimbLinks>{{{3}, {4}}}));
}

TEST(FindLimbs, TakesLimbsOnTheGround) {
  EXPECT_EQ(find_limbs(tree({-1, -1}, "RR")), (std::vector<LimbLinks>{{{0}, {1}}}));
}

TEST(FindLimbs, FindsNothingInAChainAndLeavesMimicJointsOut) {
  EXPECT_TRUE(find_limbs(tree({-1, 0, 1}, "RRR")).empty());
  model::Tree robot = tree({-1, 0, 0}, "RRR");
  robot.drives[2] = {1, Real(-1), Real(0)};
  EXPECT_TRUE(find_limbs(robot).empty());
}

TEST(FindLimbs, LeavesOutWhoseJointsMoveOthers) {
  model::Tree robot = tree({-1, 0, 0, 0}, "RRRR");
  robot.drives[3] = {1, Real(1), Real(3) / 10};  // limb 3 follows limb 1
  EXPECT_TRUE(find_limbs(robot).empty());
  robot = tree({-1, 0, 0, 0, 0}, "RRRRR");
  robot.drives[4] = {1, Real(1), Real(3) / 10};
  EXPECT_EQ(find_limbs(robot), (std::vector<LimbLinks>{{{2}, {3}}}));
}

Values evaluate(const program::Function& function, const program::Signature& signature) {
  std::vector<Values> inputs;
  int k = 0;
  for (const program::Array& array : signature.inputs) {
    inputs.emplace_back();
    for (int i = 0; i < array.size; ++i) {
      inputs.back().push_back(sin(Real(++k)));  // 50 digits that are not special
    }
  }
  return program::interpret<Real>(function, {inputs.begin(), inputs.end()});
}

/// Limbs of different offsets, rotations and inertias, with sliding joints and forks.
std::vector<model::Tree> robots_with_limbs() {
  const model::Tree three_legs = tree({-1, 0, 1, 2, 0, 4, 5, 0, 7, 8}, "RRRRRRRRRR");
  const model::Tree sliding = tree({-1, 0, 1, 0, 3}, "PRPRP");
  const model::Tree forks = tree({-1, 0, 1, 1, 0, 4, 4}, "RRRRRRR");
  const model::Tree on_ground = tree({-1, 0, -1, 2}, "RRRR");
  return {three_legs, sliding, forks, on_ground};
}

void expect_same_values(const model::Tree& robot, const Recipe& recipe, const Variant& variant) {
  Options options;
  options.gravity = {Real("0.5"), Real("-1.25"), Real("-9.5")};
  options.points = {{"a", "a", "", robot.size() - 1, {Real("0.25"), Real("-0.5"), 1}, identity()},
                    {"b", "b", "", 1, {1, 2, 3}, identity()}};
  const program::Signature s = signature(recipe.name, robot.dof(), 2);
  const Values expected = evaluate(build(robot, recipe, options, plain_variant(robot)), s);
  options.share_limbs = true;
  Built shared = Formulations(robot, recipe, options).build(variant);
  shared.function.signature = s;
  const auto code = optimise::limb_code(shared.function, shared.limbs, optimise::Effort{});
  if (!code) {
    return;  // nothing of this function belongs to one limb
  }
  const Values values = evaluate(program::flat(code, s), s);
  ASSERT_EQ(values.size(), expected.size());
  Real scale = 0;
  for (const Real& value : expected) {
    scale = std::max(scale, Real(abs(value)));
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_LE(abs(values[k] - expected[k]), scale * Real("1e-35")) << recipe.name << " " << k;
  }
}

TEST(SharedLimbs, HaveTheValuesOfEveryFunctionWithRandomLimbs) {
  support::Dice dice(3);
  for (const model::Tree& robot : robots_with_limbs()) {
    for (const Recipe& recipe : recipes()) {
      Variant variant = plain_variant(robot);
      variant.articulated = dice.below(2) == 0;
      variant.inertia_tensor = dice.below(2) == 0;
      variant.way = static_cast<Way>(dice.below(3));
      expect_same_values(robot, recipe, variant);
      if (testing::Test::HasFailure()) {
        return;
      }
    }
  }
}

}  // namespace
}  // namespace treedyn::formulate
