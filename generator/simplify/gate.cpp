#include "simplify/gate.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "program/rounding.hpp"

namespace treedyn::simplify {

namespace {

constexpr double kMostAmplification = 4;

/// The passes that can be left out and are not yet. Sums of angles are as exact as angles that were
/// rounded themselves; the trunk is a choice of velocities in which the equations are solved, like
/// that between both forward dynamics, not a rewriting of them.
std::vector<Pass> passes_of(const Options& options) {
  std::vector<Pass> result;
  for (const PassInfo& info : passes()) {
    if (info.pass != Pass::kSums && info.pass != Pass::kTrunk && options.has(info.pass)) {
      result.push_back(info.pass);
    }
  }
  return result;
}

Options without(Options options, const std::vector<Pass>& passes) {
  options.without.insert(options.without.end(), passes.begin(), passes.end());
  return options;
}

class Gate {
 public:
  Gate(const model::Tree& tree, const Recipe& recipe, const Options& options, Formulate function)
      : tree_(tree), recipe_(recipe), options_(options), formulate_(function) {
    const ForwardDynamics method = options.forward_dynamics;
    const bool two = recipe.freedom.articulated;
    if (!two || method != ForwardDynamics::kArticulated) {
      before_.push_back(plain(false));
    }
    if (two && method != ForwardDynamics::kFactor) {
      before_.push_back(plain(true));
    }
  }

  program::Function run() const;

 private:
  /// Before the passes.
  [[nodiscard]] program::Function plain(bool articulated) const;
  /// Against the method that the function may have come from.
  [[nodiscard]] double amplification(const program::Function& function) const;
  [[nodiscard]] program::Function formulate(const std::vector<Pass>& left_out, int effort) const;
  [[nodiscard]] program::Function without_culprits() const;

  const model::Tree& tree_;
  const Recipe& recipe_;
  const Options& options_;
  Formulate formulate_;
  std::vector<program::Function> before_;
};

program::Function Gate::plain(bool articulated) const {
  Options options = without(options_, passes_of(options_));
  options.share_limbs = false;
  Variant variant = plain_variant(tree_);
  switch_off(options.without, variant);
  variant.articulated = articulated;
  return build(tree_, recipe_, options, variant);
}

double Gate::amplification(const program::Function& function) const {
  double least = std::numeric_limits<double>::infinity();
  for (const program::Function& before : before_) {
    least = std::min(least, program::amplification(function, before));
  }
  return least;
}

program::Function Gate::formulate(const std::vector<Pass>& left_out, int effort) const {
  Options options = without(options_, left_out);
  options.effort = effort;
  program::Function function = formulate_(tree_, recipe_, options);
  function.rounding.amplification = amplification(function);
  for (const PassInfo& info : passes()) {
    if (std::ranges::find(left_out, info.pass) != left_out.end()) {
      function.rounding.left_out.emplace_back(info.name);
    }
  }
  return function;
}

bool is_accurate(const program::Function& function) {
  return function.rounding.amplification <= kMostAmplification;
}

/// Without one pass; if that is not enough without all but the algebra, and without that as well.
program::Function Gate::without_culprits() const {
  const std::vector<Pass> on = passes_of(options_);
  std::vector<std::vector<Pass>> trials;
  for (auto pass = on.rbegin(); pass != on.rend(); ++pass) {
    trials.push_back({*pass});
  }
  trials.push_back(on);
  std::erase(trials.back(), Pass::kAlgebra);
  for (const std::vector<Pass>& left_out : trials) {
    if (program::Function quick = formulate(left_out, 0); is_accurate(quick)) {
      program::Function function = formulate(left_out, options_.effort);
      return is_accurate(function) ? function : quick;
    }
  }
  return formulate(on, 0);
}

program::Function Gate::run() const {
  program::Function function = formulate({}, options_.effort);
  if (is_accurate(function)) {
    return function;
  }
  program::Function better = without_culprits();
  better.rounding.refused = function.rounding.amplification;
  return better;
}

}  // namespace

program::Function held_to_rounding(const model::Tree& tree, const Recipe& recipe,
                                   const Options& options, Formulate formulate) {
  return Gate(tree, recipe, options, formulate).run();
}

}  // namespace treedyn::simplify
