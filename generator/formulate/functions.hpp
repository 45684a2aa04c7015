// How each function is formulated.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formulate/formulate.hpp"
#include "formulate/link_kinematics.hpp"

namespace treedyn::formulate {

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
  bool open_way = false;      ///< a search without moves tries all, too: none is known to be best
  bool fixed_frames = false;  ///< results refer to the model's own link origins: no slide
  bool fixed_length = false;  ///< of those with regrouping, which alone may have another unit of
                              ///< length: lengths in metres occur
  bool own_code = false;      ///< limbs share none
};

using Builder = std::function<std::vector<Expr>(const Task& task)>;

/// How a function is formulated.
struct Recipe {
  Inputs places;  ///< which of its inputs are q, qd, qdd, tau
  Freedom freedom;
  Builder build;
  std::string name = {};  ///< of equations::functions(), or of a user; empty: one of a scene
};

/// Which of the inputs of these names are q, qd, qdd, tau.
Inputs places_of(const std::vector<std::string_view>& inputs);

/// Those of equations::functions().
const std::vector<Recipe>& recipes();
/// \pre `name` is in the table.
const Recipe& recipe_of(const std::string& name);

/// What formulations are compared by: operations, a sine with its cosine as 8 of them.
int weight(const program::Cost& cost);

/// Adds the operation of a node.
void add_operation(const program::Node& node, program::Cost& cost);
/// Adds the operations of the nodes from number `first` on.
void count_new(const Graph& graph, std::size_t first, program::Cost& cost);

/// One formulation of a function and, with `options.share_limbs`, the leaves of its limbs.
struct Built {
  program::Function function;
  program::Limbs limbs;
};

/// The formulations of a function of one robot.
class Formulations {
 public:
  Formulations(const model::Tree& tree, const Recipe& recipe, const Options& options);

  /// As it comes from the equations: no algebraic pass has run. Its nodes in canonical order.
  Built build(const Variant& variant);
  /// The operations of `build`. Variants often differ in what no expression sees: each of those
  /// that come to the same numbers and choices is formulated once.
  program::Cost cost(const Variant& variant);
  /// Of them those that the algebraic passes leave, without a search.
  int estimate(const Variant& variant);

 private:
  /// A hash of all that expressions see of a formulation.
  using Fingerprint = std::pair<std::uint64_t, std::uint64_t>;

  template <class Value, class Make>
  Value known(std::map<Fingerprint, Value>& values, const Variant& variant, Make make);
  Built made(const Variant& used, const NormalTree& normal, bool in_order);

  const model::Tree& tree_;
  const Recipe& recipe_;
  const Options& options_;
  std::vector<LimbLinks> limbs_;  ///< that share code
  bool has_trunk_;                ///< and the function has a choice
  NormalForms forms_;
  std::map<Fingerprint, program::Cost> costs_;
  std::map<Fingerprint, int> estimates_;
};

/// One formulation of a function, as it comes from the equations: no algebraic pass has run.
/// \pre not `options.share_limbs`
inline program::Function build(const model::Tree& tree, const Recipe& recipe,
                               const Options& options, const Variant& variant) {
  return Formulations(tree, recipe, options).build(variant).function;
}

/// A function of a scene's robot and points, without a search: quick to make for any tree.
program::Function plain_function(const model::Scene& scene, const std::string& name);

}  // namespace treedyn::formulate
