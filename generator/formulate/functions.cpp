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
Variant usable(const model::Tree& tree, const Recipe& recipe, Variant used) {
  if (recipe.freedom.trunk && used.trunk && has_trunk(tree)) {
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

/// One formulation, its nodes in canonical order if that is asked for.
Built formulation(const model::Tree& tree, const Recipe& recipe, const Options& options,
                  const Variant& variant, bool in_order) {
  const Variant used = usable(tree, recipe, variant);
  const auto ordered = [in_order](const program::Function& function) {
    return in_order ? program::canonical(function) : function;
  };
  const std::vector<LimbLinks> links =
      options.share_limbs && !recipe.freedom.own_code ? find_limbs(tree) : std::vector<LimbLinks>{};
  const NormalTree normal = normal_form(tree, options.gravity, used, links);
  if (links.empty()) {
    return {ordered(written(tree, normal, recipe, options, used, nullptr)), {}};
  }
  SharedLimbs limbs = shared_limbs(tree, normal, links);
  program::Function function =
      ordered(written(with_signs(tree, normal), normal, recipe, options, used, &limbs));
  function = program::fold_limb_constants(function, limbs.table);
  return {std::move(function), std::move(limbs.table)};
}

}  // namespace

Built build_with_limbs(const model::Tree& tree, const Recipe& recipe, const Options& options,
                       const Variant& variant) {
  return formulation(tree, recipe, options, variant, true);
}

program::Cost cost_of(const model::Tree& tree, const Recipe& recipe, const Options& options,
                      const Variant& variant) {
  return program::cost(formulation(tree, recipe, options, variant, false).function);
}

}  // namespace treedyn::formulate
