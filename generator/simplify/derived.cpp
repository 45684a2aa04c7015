#include "simplify/derived.hpp"

#include "simplify/lowering.hpp"

namespace treedyn::simplify {
namespace {

using block::Set;

/// How many columns (or rows) there are and what a column has a block for.
struct Dimensions {
  const block::Side& counted;
  const block::Side& along;
};

Argument argument_of(const equations::UserArgument& argument) {
  const int links = argument.side.set == Set::kLinks ? 1 : 0;
  const int points = argument.side.set == Set::kPoints ? 1 : 0;
  return {argument.name.c_str(), argument.side.size, links, points, argument.unit.c_str()};
}

}  // namespace

std::shared_ptr<const Derived> derived(const equations::UserEquation& equation, int links,
                                       int points) {
  const auto count = [&](const block::Side& side) {
    return side.size * (side.set == Set::kLinks ? links : side.set == Set::kPoints ? points : 1);
  };
  const block::Shape& shape = equation.expression.shape();
  const bool by_rows = count(shape.rows) < count(shape.cols);
  return std::make_shared<const Derived>(
      Derived{equation, derive::derive(equation.expression, by_rows)});
}

std::vector<Expr> build_derived(const Task& task, const Derived& function) {
  const derive::Derivation& derivation = function.derivation;
  Lowering lowering(task, function);
  const auto [counted, along] = derivation.by_rows
                                    ? Dimensions{derivation.shape.rows, derivation.shape.cols}
                                    : Dimensions{derivation.shape.cols, derivation.shape.rows};
  std::vector<std::vector<Expr>> columns;
  for (int place = 0; place < lowering.count(counted.set); ++place) {
    for (int k = 0; k < counted.size; ++k) {
      const Blocks& column =
          derivation.by_units ? lowering.root_of_unit(place, k) : lowering.root(k);
      columns.push_back(lowering.written(column, along.set));
    }
  }
  const std::size_t length = columns.empty() ? 0 : columns.front().size();
  std::vector<Expr> result(columns.size() * length);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    for (std::size_t i = 0; i < length; ++i) {
      result[derivation.by_rows ? j * length + i : i * columns.size() + j] = columns[j][i];
    }
  }
  return result;
}

std::vector<program::Cost> costs_of_values(const model::Tree& tree,
                                           const std::shared_ptr<const Derived>& function,
                                           const Options& options) {
  std::vector<program::Cost> result;
  Recipe recipe = derived_recipe(function);
  recipe.build = [&](const Task& task) {
    Lowering lowering(task, *function);
    result = lowering.costs();
    return std::vector<Expr>{};
  };
  build(tree, recipe, options, plain_variant(tree));
  return result;
}

Recipe derived_recipe(const std::shared_ptr<const Derived>& function) {
  const equations::UserEquation& equation = function->equation;
  Recipe recipe;
  recipe.name = equation.name.c_str();
  recipe.equation = equation.text.c_str();
  recipe.brief = equation.doc.c_str();
  const auto power = [&](Set set) {
    const block::Shape& shape = equation.expression.shape();
    return (shape.rows.set == set ? 1 : 0) + (shape.cols.set == set ? 1 : 0);
  };
  const block::Shape& shape = equation.expression.shape();
  for (std::size_t k = 0; k < equation.arguments.size(); ++k) {
    recipe.inputs.push_back(argument_of(equation.arguments[k]));
  }
  recipe.outputs = {{"value", shape.rows.size * shape.cols.size, power(Set::kLinks),
                     power(Set::kPoints), equation.unit.c_str()}};
  recipe.places = {.q = 0};
  recipe.freedom = {.two_ways = true, .fixed_frames = true, .fixed_length = true};
  recipe.build = [function](const Task& task) {
    return build_derived(task, *function);
  };
  return recipe;
}

}  // namespace treedyn::simplify
