// The operations that `info --derivation` prints line by line are those of the plain formulation.
#include <numeric>

#include <gtest/gtest.h>

#include "description/read.hpp"
#include "formulate/derived.hpp"

namespace treedyn::formulate {
namespace {

struct CostCase {
  const char* model;
  const char* function;
};

class Costs : public testing::TestWithParam<CostCase> {};

TEST_P(Costs, OfLinesAddUpToThoseOfThePlainFormulation) {
  const std::string path = std::string(TREEDYN_SOURCE_DIR "/models/") + GetParam().model + ".yaml";
  const model::Tree tree = description::read_model(path, {});
  Options options;
  options.gravity = {0, 0, Real("-9.81")};
  options.points = tree.points;
  options.points.resize(tree.points.size() + 1);
  options.points.back().link = tree.size() - 1;
  options.points.back().at = {Real("0.1"), Real("0.2"), Real("0.3")};
  const std::string name = GetParam().function;
  Variant variant = plain_variant(tree);
  variant.way = Way::kInLinks;
  const auto of_lines = costs_of_values(tree, derived(name), options);
  const auto sum = std::accumulate(of_lines.begin(), of_lines.end(), program::Cost{});
  const auto all = program::cost(build(tree, recipe_of(name), options, variant));
  EXPECT_GT(all.total(), 0);
  EXPECT_EQ(sum.add, all.add);
  EXPECT_EQ(sum.mul, all.mul);
  EXPECT_EQ(sum.div, all.div);
}

INSTANTIATE_TEST_SUITE_P(
    Functions, Costs,
    testing::Values(CostCase{"puma560", "mass_matrix"}, CostCase{"panda", "mass_matrix"},
                    CostCase{"quadruped", "mass_matrix"},
                    CostCase{"puma560", "force_jacobian_transpose"},
                    CostCase{"panda", "force_jacobian_transpose"},
                    CostCase{"puma560", "bias_force"}, CostCase{"polar", "inverse_dynamics"},
                    CostCase{"polar", "joint_to_link_vectors"}),
    [](const auto& row) { return std::string(row.param.model) + "_" + row.param.function; });

equations::UserEquation equation_of_user(const model::Tree& tree, const std::string& value) {
  model::EquationText text;
  text.name = "asked";
  text.value = value;
  return equations::read_equations({text}, tree, tree.points).front();
}

std::shared_ptr<const Derived> derived_of(const model::Tree& tree,
                                          const equations::UserEquation& equation) {
  return derived(equation, tree.size(), static_cast<int>(tree.points.size()));
}

class EquationsOfUsers : public testing::TestWithParam<const char*> {};

/// The same operations, whoever writes the equation.
TEST_P(EquationsOfUsers, CostWhatOursCost) {
  const model::Tree tree = description::read_model(
      std::string(TREEDYN_SOURCE_DIR "/models/") + GetParam() + ".yaml", {});
  Options options;
  options.gravity = {0, 0, Real("-9.81")};
  options.points = tree.points;
  options.effort = 0;
  const std::pair<const char*, const char*> equations[] = {
      {"mass_matrix", "A"},
      {"mass_matrix", "T(J_v) * m_d * J_v + T(J_w) * J_d * J_w"},
      {"bias_force", "B"},
      {"gravity_force", "G"},
      {"inverse_dynamics", "A * qdd + B + G"},
      {"kinetic_energy", "1/2 * T(qd) * A * qd"}};
  for (const auto& [name, value] : equations) {
    const program::Cost ours = program::cost(formulated(tree, std::string(name), options));
    const program::Cost own =
        program::cost(formulated(tree, derived_of(tree, equation_of_user(tree, value)), options));
    EXPECT_GT(ours.total(), 0) << name;
    EXPECT_EQ(own.add, ours.add) << value;
    EXPECT_EQ(own.mul, ours.mul) << value;
    EXPECT_EQ(own.sin, ours.sin) << value;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EquationsOfUsers,
                         testing::Values("polar", "puma560", "biped", "quadruped"));

/// A point on the axis of a joint belongs to both of its links: what sums over all links does not
/// feel to which of them its mass counts, what sums over some does.
TEST(EquationsOfUsers, TakeRegroupedParametersWhereTheyDoNotFeelThem) {
  const model::Tree tree = description::read_model(TREEDYN_SOURCE_DIR "/models/puma560.yaml", {});
  const auto regroups = [&](const std::string& value) {
    return regrouped(tree, derived_of(tree, equation_of_user(tree, value)), {})->regroups;
  };
  EXPECT_TRUE(regroups("T(ones) * m_d * J_v * qd"));
  EXPECT_TRUE(regroups("1/2 * T(qd) * A * qd"));
  EXPECT_TRUE(regroups("dot(A)"));
  EXPECT_FALSE(regroups("m_d * J_v * qd"));
  EXPECT_FALSE(regroups("T(J_v) * m_d * under(" + tree.links[3].name + ") * J_v"));
  EXPECT_FALSE(regroups("T(ones) * J_d * J_w * qd"));
}

TEST(Costs, OfEquationsOfUsersAddUp) {
  const model::Tree tree = description::read_model(TREEDYN_SOURCE_DIR "/models/puma560.yaml", {});
  for (const char* value : {"T(J_v) * m_d * dot(J_v)", "J_v", "T(ones) * m_d * J_v * qd"}) {
    const auto function = derived_of(tree, equation_of_user(tree, value));
    Options options;
    options.gravity = {1, 2, 3};
    options.points = tree.points;
    Variant variant = plain_variant(tree);
    variant.way = Way::kInLinks;
    const auto of_lines = costs_of_values(tree, function, options);
    const auto sum = std::accumulate(of_lines.begin(), of_lines.end(), program::Cost{});
    const auto all = program::cost(build(tree, derived_recipe(function), options, variant));
    EXPECT_GT(all.total(), 0) << value;
    EXPECT_EQ(sum.total(), all.total()) << value;
  }
}

}  // namespace
}  // namespace treedyn::formulate
