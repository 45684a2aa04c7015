#include "simplify/functions.hpp"

#include "program/canonical.hpp"

namespace treedyn::simplify {

int Argument::size(int dof, int points) const {
  int result = factor;
  for (int k = 0; k < power_of_dof; ++k) {
    result *= dof;
  }
  for (int k = 0; k < power_of_points; ++k) {
    result *= points;
  }
  return result;
}

Variant plain_variant(const model::Tree& tree) {
  Variant variant;
  variant.links.resize(tree.links.size());
  return variant;
}

program::Function build(const model::Tree& tree, const Recipe& recipe, const Options& options,
                        const Variant& variant) {
  Variant used = variant;
  if (recipe.freedom.trunk && variant.trunk && has_free_base(tree)) {
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
  program::Function function;
  const NormalTree normal = normal_form(tree, options.gravity, used);
  const Kinematics kinematics(function.graph, tree, normal, used, recipe.places);
  for (const Expr& output : recipe.build({tree, normal, options, kinematics})) {
    function.outputs.push_back(output.ref());
  }
  return program::canonical(function);
}

}  // namespace treedyn::simplify
