#include "formulate/functions.hpp"

#include <algorithm>

#include "program/canonical.hpp"

namespace treedyn::formulate {

int weight(const program::Cost& cost) {
  constexpr int kOperationsOfSineAndCosine = 8;
  return cost.total() + kOperationsOfSineAndCosine * std::max(cost.sin, cost.cos);
}

void add_operation(const program::Node& node, program::Cost& cost) {
  cost.add += node.kind == program::Kind::kAdd ? 1 : 0;
  cost.mul += node.kind == program::Kind::kMultiply ? 1 : 0;
  cost.div += node.kind == program::Kind::kDivide ? 1 : 0;
}

void count_new(const Graph& graph, std::size_t first, program::Cost& cost) {
  for (std::size_t n = first; n < graph.size(); ++n) {
    add_operation(graph.node(static_cast<program::Ref>(n)), cost);
  }
}

Variant plain_variant(const model::Tree& tree) {
  Variant variant;
  variant.links.resize(tree.links.size());
  return variant;
}

namespace {

/// The coordinates of limbs count with the signs of `limbs`.
model::Tree with_signs(model::Tree tree, const NormalTree& normal) {
  for (std::size_t i = 0; i < tree.drives.size(); ++i) {
    tree.drives[i].multiplier *= normal.links[i].coordinate_sign;
  }
  return tree;
}

/// The recipe's expressions.
program::Function written(const model::Tree& tree, const NormalTree& normal, const Recipe& recipe,
                          const Options& options, const Variant& variant, SharedLimbs* limbs) {
  program::Function function;
  const Kinematics kinematics(function.graph, tree, normal, variant, recipe.places, limbs);
  for (const Expr& output : recipe.build({tree, normal, options, kinematics})) {
    function.outputs.push_back(output.ref());
  }
  return function;
}

/// The variant of which the recipe can make use.
Variant usable(const Recipe& recipe, bool has_trunk, Variant used) {
  if (used.trunk && has_trunk) {
    for (std::size_t i = 3; i < 6;
         ++i) {  // the base axes stay in one point and the trunk keeps its mass
      used.links[i].mass = MassGauge::kNothing;
      used.links[i].slide = Slide::kNone;
    }
    used.links[4].cut =
        LinkVariant::kWholeRun;  // forward dynamics needs the second axis as a frame axis
  }
  if (recipe.freedom.fixed_frames) {
    for (LinkVariant& link : used.links) {
      link.slide = Slide::kNone;
    }
  }
  return used;
}

std::vector<LimbLinks> limbs_of(const model::Tree& tree, const Recipe& recipe,
                                const Options& options) {
  return options.share_limbs && !recipe.freedom.own_code ? find_limbs(tree)
                                                         : std::vector<LimbLinks>{};
}

}  // namespace

Formulations::Formulations(const model::Tree& tree, const Recipe& recipe, const Options& options)
    : tree_(tree),
      recipe_(recipe),
      options_(options),
      limbs_(limbs_of(tree, recipe, options)),
      has_trunk_(recipe.freedom.trunk && has_trunk(tree)),
      forms_(tree, options.gravity, limbs_) {}

Built Formulations::made(const Variant& variant, bool in_order) {
  const Variant used = usable(recipe_, has_trunk_, variant);
  const NormalTree normal = forms_.of(used);
  if (limbs_.empty()) {
    program::Function function = written(tree_, normal, recipe_, options_, used, nullptr);
    return {in_order ? program::canonical(function) : std::move(function), {}};
  }
  SharedLimbs limbs = shared_limbs(tree_, normal, limbs_);
  program::Function function =
      written(with_signs(tree_, normal), normal, recipe_, options_, used, &limbs);
  if (in_order) {
    function = program::canonical(function);
  }
  function = program::fold_limb_constants(function, limbs.table);
  return {std::move(function), std::move(limbs.table)};
}

}  // namespace treedyn::formulate
