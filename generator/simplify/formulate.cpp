#include "simplify/formulate.hpp"

#include "common/error.hpp"
#include "program/signs.hpp"
#include "simplify/derived.hpp"
#include "simplify/functions.hpp"
#include "simplify/gate.hpp"
#include "simplify/search.hpp"
#include "simplify/stand_ins.hpp"

namespace treedyn::simplify {

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Recipe& recipe : recipes()) {
      result.emplace_back(recipe.name);
    }
    return result;
  }();
  return names;
}

program::Signature signature(const std::string& name, int dof, int points) {
  const Recipe& recipe = recipe_of(name);
  const auto arrays = [&](const std::vector<Argument>& arguments) {
    std::vector<program::Array> result;
    for (const Argument& argument : arguments) {
      result.push_back({argument.name, argument.size(dof, points), argument.unit});
    }
    return result;
  };
  return {recipe.name, recipe.equation, recipe.brief, arrays(recipe.inputs),
          arrays(recipe.outputs)};
}

namespace {

/// By structure, if the numbers allow it: not where what is zero by chance was divided by, or
/// where it has cancelled nearly.
program::Function cheapest_seen(const model::Tree& tree, const Recipe& recipe,
                                const Options& options) {
  const Seen seen = with_stand_ins(tree, options);
  program::Function function = cheapest(seen.tree, recipe, seen.options);
  if (holds(function, tree, recipe, options)) {
    return program::with_positive_constants(function);
  }
  const Seen own = with_parameters(tree, options);
  return cheapest(own.tree, recipe, own.options);
}

}  // namespace

program::Function formulate(const model::Tree& tree, const std::string& name,
                            const Options& options) {
  program::Function function = cheapest_seen(tree, recipe_of(name), options);
  function.signature = signature(name, tree.dof(), static_cast<int>(options.points.size()));
  return function;
}

program::Function formulate(const model::Tree& tree, const std::shared_ptr<const Derived>& function,
                            const Options& options) {
  Options own = options;
  own.share_limbs = false;
  program::Function result = cheapest_seen(tree, derived_recipe(function), own);
  result.signature.name = function->equation.name;
  return result;
}

}  // namespace treedyn::simplify
