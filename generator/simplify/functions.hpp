// The table of functions that can be generated: signature and formulation of each (INTERFACE.md 3).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simplify/formulate.hpp"
#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// An argument whose size is factor * N^n * P^p.
struct Argument {
  const char* name;
  int factor;
  int power_of_dof;
  int power_of_points;
  const char* unit;

  [[nodiscard]] int size(int dof, int points) const;
};

/// Everything a formulation may look at.
struct Task {
  const model::Tree& tree;
  const NormalTree& normal;
  const Options& options;
  const Kinematics& kinematics;
};

/// Which choices of a Variant can change the cost of a function.
struct Freedom {
  bool regrouping = false;    ///< inertial parameters may move to the father
  bool moment_form = false;   ///< velocities and link moments occur
  bool tensor_form = false;   ///< composite bodies occur
  bool trunk = false;         ///< a free base may be treated as one body
  bool articulated = false;   ///< two methods exist
  bool any_way = false;       ///< vectors occur that may stand in other frames
  Way way = Way::kToRoot;     ///< where they stand without a search
  bool fixed_frames = false;  ///< results refer to the model\'s own link origins: no slide
  bool fixed_length = false;  ///< points occur: the metre stays the unit of length
};

using Builder = std::function<std::vector<Expr>(const Task& task)>;

struct Recipe {
  const char* name = nullptr;
  const char* equation = nullptr;
  const char* brief = nullptr;
  std::vector<Argument> inputs;
  std::vector<Argument> outputs;
  Inputs places;  ///< which of `inputs` are q, qd, qdd, tau
  Freedom freedom;
  Builder build;
};

/// In the order of INTERFACE.md 3, further functions behind.
const std::vector<Recipe>& recipes();
/// \pre `name` is in the table.
const Recipe& recipe_of(const std::string& name);

/// What formulations are compared by: operations, a sine with its cosine as 8 of them.
int weight(const program::Cost& cost);

/// Adds the operations of the nodes from number `first` on.
void count_new(const Graph& graph, std::size_t first, program::Cost& cost);

/// One formulation of a function and, with `options.share_limbs`, the leaves of its limbs.
struct Built {
  program::Function function;
  program::Limbs limbs;
};
Built build_with_limbs(const model::Tree& tree, const Recipe& recipe, const Options& options,
                       const Variant& variant);

/// One formulation of a function, as it comes from the equations: no algebraic pass has run.
/// \pre not `options.share_limbs`
inline program::Function build(const model::Tree& tree, const Recipe& recipe,
                               const Options& options, const Variant& variant) {
  return build_with_limbs(tree, recipe, options, variant).function;
}

/// The variant before any search.
Variant plain_variant(const model::Tree& tree);

}  // namespace treedyn::simplify
