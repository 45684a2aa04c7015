// Functions that count lengths in another unit than the metre: values with names are in the units
// that the comment at the head of the function states.
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/read.hpp"
#include "emit/length_unit.hpp"
#include "formulate/frames.hpp"
#include "formulate/functions.hpp"
#include "program/interpret.hpp"

namespace treedyn::formulate {
namespace {

using Name = std::tuple<std::string, int, std::string>;  ///< symbol, body, component

model::Tree model_tree(const std::string& name) {
  return description::read_model(fmt::format(TREEDYN_SOURCE_DIR "/models/{}.yaml", name), {});
}

Options some_options() {
  Options options;
  options.gravity = {Real("0.5"), Real("-1.25"), Real("-9.5")};
  options.effort = 0;
  return options;
}

/// The named values of a function in one state; those whose name is not unique are left out.
std::map<Name, Real> named_values(program::Function function, const Recipe& recipe, int dof) {
  std::vector<std::vector<Real>> inputs;
  int count = 0;
  for (const program::Array& array : signature(recipe.name, dof, 0).inputs) {
    inputs.emplace_back();
    for (int i = 0; i < array.size; ++i) {
      inputs.back().push_back(sin(Real(++count)));
    }
  }
  std::vector<Name> names;
  std::vector<program::Ref> values;
  for (const program::Ref k : program::reachable(function.graph, function.outputs)) {
    for (const program::Ref value : {k, -k}) {
      const program::Hint& hint = function.graph.hint(value);
      if (hint.symbol != nullptr) {
        names.emplace_back(hint.symbol, hint.body, hint.component == nullptr ? "" : hint.component);
        values.push_back(value);
      }
    }
  }
  function.outputs = values;
  const std::vector<Real> results =
      program::interpret<Real>(function, {inputs.begin(), inputs.end()});
  std::map<Name, std::optional<Real>> all;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto [place, is_new] = all.try_emplace(names[k], results[k]);
    if (!is_new) {
      place->second.reset();
    }
  }
  std::map<Name, Real> unique;
  for (const auto& [name, value] : all) {
    if (value) {
      unique.emplace(name, *value);
    }
  }
  return unique;
}

/// What a number in the stated unit has to be multiplied by for one in SI units.
Real metres_in(const std::string& unit, const Real& u) {
  return unit.empty() ? Real(1) : unit.starts_with("L") ? u : Real(1 / u);
}

class Units : public testing::TestWithParam<const char*> {};

TEST_P(Units, OfNamedValuesAreThoseThatTheTextStates) {
  const model::Tree tree = model_tree(GetParam());
  const Options options = some_options();
  const std::size_t lengths = unit_lengths(tree).size();
  ASSERT_GT(lengths, 0U);
  std::map<std::string, int> compared;
  for (const Recipe& recipe : recipes()) {
    for (const bool articulated : {false, true}) {
      if (!recipe.freedom.regrouping || recipe.freedom.fixed_length ||
          (articulated && !recipe.freedom.articulated)) {
        continue;
      }
      Variant variant = plain_variant(tree);
      variant.articulated = articulated;
      const auto metre = named_values(build(tree, recipe, options, variant), recipe, tree.dof());
      for (std::size_t k = 1; k <= lengths; ++k) {
        variant.unit_length = static_cast<int>(k);
        const Real u = unit_of(tree, variant).metres;
        for (const auto& [name, value] :
             named_values(build(tree, recipe, options, variant), recipe, tree.dof())) {
          const auto same = metre.find(name);
          if (same == metre.end() || abs(same->second) < Real("1e-30")) {
            continue;
          }
          const std::string& symbol = std::get<0>(name);
          const Real factor = metres_in(emit::unit_in(symbol), u);
          EXPECT_LT(abs(value * factor - same->second), Real("1e-30") * abs(same->second))
              << recipe.name << ": " << symbol << " of link " << std::get<1>(name);
          ++compared[symbol];
        }
      }
    }
  }
  for (const char* symbol : {"a", "omega", "alpha", "Omega", "F", "M"}) {
    EXPECT_GT(compared[symbol], 0) << symbol;
  }
  EXPECT_EQ(compared["s"] > 0, GetParam() != std::string("panda"));  // its offsets are constants
}

INSTANTIATE_TEST_SUITE_P(Models, Units, testing::Values("puma560", "panda", "quadruped"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace treedyn::formulate
