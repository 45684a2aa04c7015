#include "formulate/pass_switches.hpp"

#include <algorithm>

#include "formulate/formulate.hpp"

namespace treedyn::formulate {

const std::vector<PassInfo>& passes() {
  static const std::vector<PassInfo> table = {
      {Pass::kNormals, "normals", "origins and x axes of link frames on common normals"},
      {Pass::kRegrouping, "regrouping", "inertial parameters moved to the father (EQUATIONS.md 8)"},
      {Pass::kPseudoInertia, "pseudo-inertia", "link moments and composites by pseudo-inertias"},
      {Pass::kColumn, "column", "third column of Omega from the father's"},
      {Pass::kParallel, "parallel", "one frame for a run of parallel axes"},
      {Pass::kSums, "sums", "sines of sums of angles instead of products of sines"},
      {Pass::kTrunk, "trunk", "the base of a free robot as one body with six velocities"},
      {Pass::kAlgebra, "algebra", "common factors, shared sums and products"},
      {Pass::kSearch, "search", "the cheapest variant of all choices above"},
  };
  return table;
}

void switch_off(const std::vector<Pass>& without, Variant& variant) {
  for (const Pass pass : without) {
    variant.add_angles &= pass != Pass::kSums;
    variant.inertia_tensor |= pass == Pass::kPseudoInertia;
    variant.trunk &= pass != Pass::kTrunk;
    for (LinkVariant& link : variant.links) {
      link.slide = pass == Pass::kNormals ? Slide::kNone : link.slide;
      link.angle = pass == Pass::kNormals ? FrameAngle::kKeep : link.angle;
      link.mass = pass == Pass::kRegrouping ? MassGauge::kNothing : link.mass;
      link.tensor_moment |= pass == Pass::kPseudoInertia;
      link.column_of_father &= pass != Pass::kColumn;
      link.merge_parallel &= pass != Pass::kParallel;
    }
  }
}

std::vector<PassCost> pass_costs(const std::function<program::Function(const Options&)>& made,
                                 const Options& options) {
  Options reduced = options;
  for (const PassInfo& info : passes()) {
    reduced.without.push_back(info.pass);
  }
  std::vector<PassCost> rows = {{"link frames", cost(made(reduced))}};
  for (const PassInfo& info : passes()) {
    if (std::ranges::find(options.without, info.pass) == options.without.end()) {
      std::erase(reduced.without, info.pass);
      rows.push_back({info.name, cost(made(reduced))});
    }
  }
  return rows;
}

}  // namespace treedyn::formulate
