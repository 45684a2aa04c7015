#include <algorithm>
#include <cmath>
#include <set>

#include "accuracy/bound_search.hpp"
#include "accuracy/function_errors.hpp"

namespace treedyn::accuracy {

namespace {

/// What cutting once more than this gains is little beside what it takes.
constexpr int kCuts = 250;

/// The elements of arguments that a function depends on.
Dependence dependence(const program::Function& function, const Arithmetic& how) {
  Dependence result;
  std::set<program::Ref> seen;
  for (const program::Ref output : function.outputs) {
    if (output != 0 && seen.insert(std::abs(output)).second) {
      const OutputError error(function, std::abs(output), how);
      result.inputs.merge(error.inputs());
      result.as_they_are.merge(error.inputs_as_they_are());
    }
  }
  return result;
}

/// Over the states of the box that is `state` alone.
Bound running(const program::Function& function, const Arithmetic& how, const Truth& truth,
              const Measured& measured) {
  const auto state = static_cast<std::size_t>(measured.errors.scaled.state);
  Box box;
  for (const std::vector<double>& array : truth.inputs[state]) {
    for (const double x : array) {
      box.push_back({x, x});
    }
  }
  const BoundsOver bounds = bounds_over(function, how, {box, truth.exact[state].scales, 0});
  return {bounds.largest, output_name(function.signature, bounds.output),
          measured.errors.scaled.error, "", ""};
}

}  // namespace

Bound bounded(const program::Function& function, const Arithmetic& how, const Truth& truth,
              const Measured& measured) {
  const BoundsOver bounds = bounds_over(function, how, {truth.ranges, truth.scales, kCuts});
  if (!std::isfinite(bounds.largest)) {
    Bound result = running(function, how, truth, measured);
    result.obstacle = bounds.obstacle.empty() ? "a scale is zero" : bounds.obstacle;
    return result;
  }
  Bound result{bounds.largest,
               bounds.largest == 0 ? "" : output_name(function.signature, bounds.output), 0, "",
               ""};
  for (std::size_t k = 0; k < truth.scales.size(); ++k) {
    const double error = measured.largest[k];
    result.sampled = std::max(result.sampled, error == 0 ? 0 : error / truth.scales[k]);
  }
  result.assumed = truth.assumed(dependence(function, how));
  return result;
}

}  // namespace treedyn::accuracy
