#include "formulate/factored.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "common/error.hpp"
#include "common/index.hpp"
#include "equations/scene_table.hpp"
#include "equations/table.hpp"

namespace treedyn::formulate {
namespace {

/// An equation of the table, or what else stands in one that is solved.
std::shared_ptr<const Derived> derived_leaf(const std::string& name, const block::Expression& e) {
  for (const equations::Equation& equation : equations::table()) {
    if (block::equal(*equation.expression, e)) {
      return derived(std::string(equation.name));
    }
  }
  return derived_part(name, e);
}

std::optional<derive::Factored> solution_of(const std::string& name) {
  if (const equations::Equation* const equation = equations::find_solved(name)) {
    return derive::factored(*equation->expression, std::string(equation->unknown));
  }
  const equations::SceneFunctionInfo& info = equations::scene_function_info(name);
  TREEDYN_EXPECT(!info.equations.empty());
  const std::vector<block::Expression>& e = info.equations;
  return e.size() == 1           ? derive::with_directions(e[0])
         : *info.unknown != '\0' ? derive::constrained(e[0], e[1], info.unknown, "λ")
                                 : derive::least(e[0], e[1], "λ", "μ");
}

FactoredFunction make(const std::string& name) {
  std::optional<derive::Factored> f = solution_of(name);
  if (!f) {
    throw std::domain_error("R12 does not solve " + name);
  }
  FactoredFunction result{std::move(f->derivation), {}};
  for (const auto& [leaf, e] : f->given) {
    if (e.shape().rows.set != block::Set::kRows && e.shape().cols.set != block::Set::kRows) {
      result.given.emplace_back(leaf, derived_leaf(leaf, e));
    }
  }
  return result;
}

/// A column, or the lower half of a symmetric matrix.
SparseRows sparse_rows_of(const Task& task, const Derived& function) {
  const std::vector<Expr> x = build_derived(task, function, task.kinematics.variant().way);
  if (!function.derivation.symmetric) {
    return sparse(x);
  }
  const int n = task.tree.dof();
  SparseSymmetric lower;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      lower[{i, j}] = x[to_index(i * n + j)];
    }
  }
  return sparse(n, lower);
}

Numbers numbers(const Task& task, const std::string& name) {
  const FactoredFunction& function = factored(name);
  const auto leaf = [&](const std::string& symbol) {
    for (const auto& [given, of] : function.given) {
      if (given == symbol) {
        return sparse_rows_of(task, *of);
      }
    }
    std::vector<Expr> argument;
    for (int k = 0; k < task.tree.dof(); ++k) {
      argument.push_back(task.kinematics.argument(
          static_cast<int>(equations::find_function(name)->inputs.size()) - 1, k));
    }
    return sparse(argument);
  };
  return {task.kinematics.graph(), task.tree.dof(), function.derivation, leaf};
}

/// Row-major.
std::vector<Expr> dense(const SparseRows& rows, bool mirrored) {
  std::vector<Expr> result(rows.size() * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& [j, x] : rows[i]) {
      result[i * rows.size() + to_index(j)] = x;
      if (mirrored) {
        result[to_index(j) * rows.size() + i] = x;
      }
    }
  }
  return result;
}

}  // namespace

const FactoredFunction& factored(const std::string& name) {
  static std::mutex mutex;
  static std::map<std::string, FactoredFunction> known;
  const std::scoped_lock lock(mutex);
  const auto found = known.find(name);
  return found != known.end() ? found->second : known.emplace(name, make(name)).first->second;
}

const Derived& given(const std::string& function, const std::string& leaf) {
  const auto& all = factored(function).given;
  const auto found = std::ranges::find(all, leaf, [](const auto& one) { return one.first; });
  TREEDYN_EXPECT(found != all.end());
  return *found->second;
}

std::vector<Expr> build_factored(const Task& task, const std::string& name) {
  const Numbers solution = numbers(task, name);
  const std::vector<equations::Argument>& outputs = equations::find_function(name)->outputs;
  std::vector<Expr> result;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const bool symmetric = outputs.size() == 1;
    const SparseRows& rows = solution.root(k);
    const std::vector<Expr> x = outputs[k].cols.of == equations::Extent::Of::kFixed
                                    ? column_of(rows)
                                    : dense(rows, symmetric);
    result.insert(result.end(), x.begin(), x.end());
  }
  return result;
}

std::vector<program::Cost> costs_of_numbers(const model::Tree& tree, const std::string& name,
                                            const Options& options) {
  std::vector<program::Cost> result;
  Recipe recipe = recipe_of(name);
  recipe.build = [&](const Task& task) {
    result = numbers(task, name).costs();
    return std::vector<Expr>{};
  };
  build(tree, recipe, options, plain_variant(tree));
  return result;
}

}  // namespace treedyn::formulate
