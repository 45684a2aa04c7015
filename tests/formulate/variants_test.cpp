// Every choice of a formulation leaves the values alone, and passes never add operations.
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/read.hpp"
#include "formulate/functions.hpp"
#include "optimise/optimise.hpp"
#include "program/interpret.hpp"
#include "support/process.hpp"

namespace treedyn::formulate {
namespace {

using Values = std::vector<Real>;

model::Tree model_tree(const std::string& name, description::Base base) {
  description::ReadOptions options;
  options.base = base;
  return description::read_model(fmt::format(TREEDYN_SOURCE_DIR "/models/{}.yaml", name), options);
}

/// A point on the last link and one on the ground, so that every function has points.
Options some_options(const model::Tree& tree) {
  Options options;
  options.gravity = {Real("0.5"), Real("-1.25"), Real("-9.5")};
  options.points = {{"a", "a", "", tree.size() - 1, {Real("0.25"), Real("-0.5"), 1}, identity()},
                    {"b", "b", "", model::kGround, {1, 2, 3}, identity()},
                    {"c", "c", "", tree.size() / 2, {0, Real("0.125"), 0}, identity()}};
  options.effort = 0;
  return options;
}

Values evaluate(const program::Function& function, const Recipe& recipe, const model::Tree& tree) {
  const program::Signature s = signature(recipe.name, tree.dof(), 3);
  std::vector<Values> inputs;
  int k = 0;
  for (const program::Array& array : s.inputs) {
    inputs.emplace_back();
    for (int i = 0; i < array.size; ++i) {
      inputs.back().push_back(sin(Real(++k)));  // 50 digits that are not special
    }
  }
  return program::interpret<Real>(function, {inputs.begin(), inputs.end()});
}

/// Largest distance between two results, relative to the largest value.
Real distance(const Values& a, const Values& b) {
  Real largest = 0;
  Real difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, Real(abs(a[i])));
    difference = std::max(difference, Real(abs(a[i] - b[i])));
  }
  return largest == 0 ? difference : Real(difference / largest);
}

template <class Enum>
void choose(std::mt19937_64& random, Enum& value, unsigned settings) {
  value = static_cast<Enum>(random() % settings);
}

Variant random_variant(const model::Tree& tree, std::mt19937_64& random) {
  Variant variant = plain_variant(tree);
  for (LinkVariant& link : variant.links) {
    choose(random, link.slide, 4);
    choose(random, link.angle, 5);
    choose(random, link.mass, 6);
    choose(random, link.tensor, 4);
    link.cut = random() % 4 == 3 ? LinkVariant::kWholeRun : static_cast<std::uint8_t>(random() % 3);
    link.merge_parallel = random() % 2 == 0;
    link.column_of_father = random() % 2 == 0;
    link.tensor_moment = random() % 2 == 0;
  }
  const std::size_t lengths = unit_lengths(tree).size();
  variant.add_angles = random() % 2 == 0;
  variant.inertia_tensor = random() % 2 == 0;
  variant.trunk = random() % 2 == 0;
  choose(random, variant.way, 3);
  variant.articulated = random() % 2 == 0;
  variant.unit_length = static_cast<int>(random() % (lengths + 1));
  return variant;
}

struct Case {
  const char* name;
  description::Base base;
};

class Variants : public testing::TestWithParam<Case> {};

TEST_P(Variants, HaveTheValuesOfThePlainFormulation) {
  const model::Tree tree = model_tree(GetParam().name, GetParam().base);
  const Options options = some_options(tree);
  std::mt19937_64 random(1);
  for (const Recipe& recipe : recipes()) {
    const Values plain = evaluate(build(tree, recipe, options, plain_variant(tree)), recipe, tree);
    for (int trial = 0; trial < 12; ++trial) {
      Variant variant = random_variant(tree, random);
      variant.unit_length = recipe.freedom.regrouping ? variant.unit_length : 0;
      const Values values = evaluate(build(tree, recipe, options, variant), recipe, tree);
      // 50 digits; some 1e4 operations and the condition of A take at most 15 of them
      EXPECT_LT(distance(plain, values), Real("1e-35")) << recipe.name << ", trial " << trial;
    }
  }
}

/// `variant` with one field of one link, or of the whole, as another one has it.
Variant with_one_of(Variant variant, const Variant& other, std::mt19937_64& random) {
  const std::size_t i = random() % variant.links.size();
  LinkVariant& link = variant.links[i];
  const LinkVariant& of = other.links[i];
  switch (random() % 12) {
    case 0:
      link.slide = of.slide;
      break;
    case 1:
      link.angle = of.angle;
      break;
    case 2:
      link.mass = of.mass;
      break;
    case 3:
      link.tensor = of.tensor;
      break;
    case 4:
      link.cut = of.cut;
      break;
    case 5:
      link.merge_parallel = of.merge_parallel;
      break;
    case 6:
      link.column_of_father = of.column_of_father;
      break;
    case 7:
      link.tensor_moment = of.tensor_moment;
      break;
    case 8:
      variant.add_angles = other.add_angles;
      break;
    case 9:
      variant.inertia_tensor = other.inertia_tensor;
      break;
    case 10:
      variant.trunk = other.trunk;
      break;
    default:
      variant.way = other.way;
  }
  return variant;
}

/// Costs are remembered by what expressions see of a variant: steps from one to the next that a
/// field decides, each compared with a formulation of its own.
TEST_P(Variants, CostWhatTheirFormulationCostsWhateverWasAskedBefore) {
  const model::Tree tree = model_tree(GetParam().name, GetParam().base);
  const Options options = some_options(tree);
  std::mt19937_64 random(2);
  for (const char* name : {"mass_matrix", "inverse_dynamics", "forward_dynamics"}) {
    const Recipe& recipe = recipe_of(name);
    Formulations formulations(tree, recipe, options);
    Variant variant = random_variant(tree, random);
    for (int trial = 0; trial < 40; ++trial) {
      const program::Function own = build(tree, recipe, options, variant);
      EXPECT_EQ(formulations.cost(variant).total(), program::cost(own).total())
          << name << ", trial " << trial;
      EXPECT_EQ(formulations.estimate(variant),
                optimise::estimate_operations(own.graph, own.outputs))
          << name << ", trial " << trial;
      variant = with_one_of(variant, random_variant(tree, random), random);
    }
  }
}

TEST_P(Variants, CostNoMoreWithAPassThanWithoutIt) {
  const model::Tree tree = model_tree(GetParam().name, GetParam().base);
  for (const char* function : {"mass_matrix", "bias_force", "inverse_dynamics", "gravity_force"}) {
    const std::vector<PassCost> rows =
        pass_costs([&](const Options& options) { return formulated(tree, function, options); },
                   some_options(tree));
    for (std::size_t k = 1; k < rows.size(); ++k) {
      EXPECT_LE(rows[k].cost.total(), rows[k - 1].cost.total()) << function << ", " << rows[k].pass;
    }
  }
}

TEST_P(Variants, AreFoundAgainByTheSameSearch) {
  const model::Tree tree = model_tree(GetParam().name, GetParam().base);
  Options options = some_options(tree);
  options.effort = 150;
  const program::Function first = formulated(tree, "inverse_dynamics", options);
  const program::Function second = formulated(tree, "inverse_dynamics", options);
  EXPECT_EQ(first.outputs, second.outputs);
  EXPECT_EQ(first.graph.size(), second.graph.size());
}

/// The frame of their father is turned towards the same of two siblings, whichever comes first.
TEST(Siblings, CostTheSameInEveryOrder) {
  const std::string text = support::read_file(TREEDYN_SOURCE_DIR "/tests/formulate/siblings.yaml");
  const std::size_t from = text.find("  - {name: l3");
  const std::size_t to = text.find("  - {name: l5");
  const support::TemporaryFolder folder;
  const std::string other = (folder.path() / "other.yaml").string();
  support::write_file(other, text.substr(0, from) + text.substr(to) + text.substr(from, to - from));
  const model::Tree first =
      description::read_model(TREEDYN_SOURCE_DIR "/tests/formulate/siblings.yaml", {});
  const model::Tree second = description::read_model(other, {});
  ASSERT_NE(first.links[3].name, second.links[3].name);
  const Options options = some_options(first);
  for (const char* const name : {"mass_matrix", "bias_force", "inverse_dynamics"}) {
    const auto operations = [&](const model::Tree& tree) {
      return program::cost(build(tree, recipe_of(name), options, plain_variant(tree))).total();
    };
    EXPECT_EQ(operations(first), operations(second)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Variants,
                         testing::Values(Case{"two_link", description::Base::kFixed},
                                         Case{"polar", description::Base::kFixed},
                                         Case{"puma560", description::Base::kFixed},
                                         Case{"compass_walker", description::Base::kFixed},
                                         Case{"biped", description::Base::kAxes}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace treedyn::formulate
