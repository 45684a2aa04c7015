#include "optimise/separate_parameters.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "common/recipe.hpp"
#include "optimise/constants.hpp"
#include "optimise/optimise.hpp"
#include "program/rewritten.hpp"

namespace treedyn::optimise {

namespace {

bool is_parameter(const Graph& graph, Ref k) {
  return graph.node(k).kind == Kind::kConstant && graph.value(k).recipe() != 0;
}

/// The same function, its numbers with recipes elements of the argument behind the others.
/// \param numbers  of all functions that have recipes, each once
Function separated(const Function& from, ConstantTable& numbers) {
  const auto array = static_cast<int>(from.signature.inputs.size());
  return rewritten(from, from.outputs, [&](Ref k, Graph& to) {
    return is_parameter(from.graph, k)
               ? std::optional(to.input(array, numbers.find_or_add(from.graph.value(k))))
               : std::nullopt;
  });
}

/// Recipes as expressions of the parameters, which are array 0.
class UpdateWriter {
 public:
  explicit UpdateWriter(Graph& graph) : graph_(graph) {}

  Expr write(int recipe) {
    note(recipe);
    for (auto& [number, expression] : known_) {  // ascending: operands come first
      if (written_.insert(number).second) {
        expression = operation(treedyn::recipe(number));
      }
    }
    return of(recipe);
  }

 private:
  [[nodiscard]] Expr of(int recipe) const {
    const Expr& value = known_.at(std::abs(recipe));
    return recipe < 0 ? -value : value;
  }

  /// All recipes that one needs.
  void note(int recipe) {
    std::vector<int> open{std::abs(recipe)};
    while (!open.empty()) {
      const int number = open.back();
      open.pop_back();
      const auto [place, is_new] = known_.try_emplace(number);
      const Recipe& r = treedyn::recipe(number);
      if (is_new && operands(r.kind) > 0) {
        open.push_back(std::abs(r.a));
      }
      if (is_new && operands(r.kind) > 1) {
        open.push_back(std::abs(r.b));
      }
    }
  }

  Expr operation(const Recipe& r) {
    switch (r.kind) {
      case RecipeKind::kNumber:
        return {graph_, graph_.constant(r.value)};
      case RecipeKind::kParameter:
        return {graph_, graph_.input(0, r.a)};
      case RecipeKind::kAdd:
        return of(r.a) + of(r.b);
      case RecipeKind::kSubtract:
        return of(r.a) - of(r.b);
      case RecipeKind::kMultiply:
        return of(r.a) * of(r.b);
      case RecipeKind::kDivide:
        return of(r.a) / of(r.b);
      case RecipeKind::kSqrt:
        return {graph_, graph_.sqrt(of(r.a).ref())};
      case RecipeKind::kSin:
        return {graph_, graph_.sin(of(r.a).ref())};
      case RecipeKind::kCos:
        break;
    }
    return {graph_, graph_.cos(of(r.a).ref())};
  }

  Graph& graph_;
  std::map<int, Expr> known_;
  std::set<int> written_;
};

}  // namespace

bool depends_on_parameters(const Function& function) {
  const std::vector<Ref> nodes = reachable(function.graph, function.outputs);
  return std::ranges::any_of(nodes, [&](Ref k) { return is_parameter(function.graph, k); });
}

Separated separate_parameters(const std::vector<Function*>& functions, const Array& parameters,
                              const Array& derived,
                              const std::function<bool(const Function&)>& takes) {
  ConstantTable numbers;
  std::vector<Function*> changed;
  for (Function* const function : functions) {
    if (depends_on_parameters(*function)) {
      *function = separated(*function, numbers);
      changed.push_back(function);
    } else if (takes(*function)) {
      changed.push_back(function);
    }
  }
  Function update;
  std::vector<Real> elements;
  UpdateWriter writer(update.graph);
  for (int k = 0; k < numbers.size(); ++k) {
    elements.push_back(numbers.value(k));
    update.outputs.push_back(writer.write(elements.back().recipe()).ref());
  }
  Array sized = derived;
  sized.size = numbers.size();
  for (Function* const function : changed) {
    function->signature.inputs.push_back(sized);
  }
  update.signature.inputs = {parameters};
  update.signature.outputs = {sized};
  return {numbers.size() > 0 ? optimised(update, {.quotients = Quotients::kApart}) : update,
          elements};
}

}  // namespace treedyn::optimise
