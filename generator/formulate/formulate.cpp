#include "formulate/formulate.hpp"

#include "common/error.hpp"
#include "common/transformed.hpp"
#include "equations/table.hpp"
#include "formulate/derived.hpp"
#include "formulate/functions.hpp"
#include "formulate/gate.hpp"
#include "formulate/search.hpp"
#include "formulate/stand_ins.hpp"

namespace treedyn::formulate {

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names =
      transformed<std::string>(equations::functions(), &equations::Equation::name);
  return names;
}

program::Signature signature(const std::string& name, int dof, int points) {
  const equations::Equation* const function = equations::find_function(name);
  TREEDYN_EXPECT(function != nullptr);
  const auto arrays = [&](const std::vector<equations::Argument>& arguments) {
    return transformed(arguments, [&](const equations::Argument& argument) {
      return program::Array{std::string(argument.name), argument.size(dof, points),
                            std::string(argument.unit)};
    });
  };
  return {name, std::string(function->number), std::string(function->brief),
          arrays(function->inputs), arrays(function->outputs)};
}

namespace {

/// By structure, if the numbers allow it: not where what is zero by chance was divided by, or
/// where it has cancelled nearly.
program::Function cheapest_seen(const model::Tree& tree, const Recipe& recipe,
                                const Options& options) {
  const Seen seen = with_stand_ins(tree, options);
  program::Function function = cheapest(seen.tree, recipe, seen.options);
  const Seen numbers = numbers_alone(seen.tree, seen.options);
  if (holds(function, numbers.tree, recipe, numbers.options)) {
    return function;
  }
  const Seen own = with_parameters(tree, options);
  return cheapest(own.tree, recipe, own.options);
}

}  // namespace

program::Function formulated(const model::Tree& tree, const std::string& name,
                             const Options& options) {
  program::Function function = cheapest_seen(tree, recipe_of(name), options);
  function.signature = signature(name, tree.dof(), static_cast<int>(options.points.size()));
  return function;
}

program::Function formulated(const model::Tree& tree,
                             const std::shared_ptr<const Derived>& function,
                             const Options& options) {
  const Recipe recipe = derived_recipe(regrouped(tree, function, options));
  program::Function result = cheapest_seen(tree, recipe, options);
  result.signature.name = function->equation.name;
  return result;
}

}  // namespace treedyn::formulate
