#include "formulate/gate.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "program/rounding.hpp"

namespace treedyn::formulate {

namespace {

constexpr double kMostAmplification = 4;
/// So many seeds of the algebraic search are taken, the first included, where it is beyond that by
/// a small factor.
constexpr double kNearly = 2;
constexpr int kSeeds = 3;

/// The passes that can be left out and are not yet. Sums of angles are as exact as angles that were
/// rounded themselves.
std::vector<Pass> passes_of(const Options& options) {
  std::vector<Pass> result;
  for (const PassInfo& info : passes()) {
    if (info.pass != Pass::kSums && options.has(info.pass)) {
      result.push_back(info.pass);
    }
  }
  return result;
}

/// Those that are judged: the trunk is a choice of velocities in which the equations are solved,
/// like that between both forward dynamics, not a rewriting of them.
std::vector<Pass> judged(const Options& options) {
  std::vector<Pass> result = passes_of(options);
  std::erase(result, Pass::kTrunk);
  return result;
}

Options without(Options options, const std::vector<Pass>& passes) {
  options.without.insert(options.without.end(), passes.begin(), passes.end());
  return options;
}

class Gate {
 public:
  Gate(const model::Tree& tree, const Recipe& recipe, const Options& options, Search search)
      : tree_(tree), recipe_(recipe), options_(options), search_(search) {
    const ForwardDynamics method = options.forward_dynamics;
    const bool two = recipe.freedom.articulated;
    if (!two || method != ForwardDynamics::kArticulated) {
      note_plain(false);
    }
    if (two && method != ForwardDynamics::kFactor) {
      note_plain(true);
    }
  }

  [[nodiscard]] program::Function run() const;
  [[nodiscard]] bool holds(const program::Function& function) const {
    // a scene's rows are along axes that each formulation chooses: no NaN is enough
    const program::Function& same = options_.scene != nullptr ? function : before_.front();
    return program::same_results(function, same) && amplification(function) <= kMostAmplification;
  }

 private:
  /// Before the passes, with the trunk and, where there is one, without.
  void note_plain(bool articulated);
  /// Against the formulation that the function may have come from.
  [[nodiscard]] double amplification(const program::Function& function) const;
  [[nodiscard]] program::Function noted(program::Function function,
                                        const std::vector<Pass>& left_out) const;
  [[nodiscard]] program::Function formulate(const std::vector<Pass>& left_out, int effort) const;
  [[nodiscard]] program::Function without_culprits() const;

  const model::Tree& tree_;
  const Recipe& recipe_;
  const Options& options_;
  Search search_;
  std::vector<program::Function> before_;
};

void Gate::note_plain(bool articulated) {
  Options options = without(options_, judged(options_));
  options.share_limbs = false;
  Variant variant = plain_variant(tree_);
  switch_off(options.without, variant);
  variant.way = recipe_.freedom.way;
  variant.articulated = articulated;
  before_.push_back(build(tree_, recipe_, options, variant));
  if (variant.trunk && recipe_.freedom.trunk && has_trunk(tree_)) {
    variant.trunk = false;
    before_.push_back(build(tree_, recipe_, options, variant));
  }
}

double Gate::amplification(const program::Function& function) const {
  double least = std::numeric_limits<double>::infinity();
  for (const program::Function& before : before_) {
    least = std::min(least, program::amplification(function, before));
  }
  return least;
}

/// With the record of its rounding.
program::Function Gate::noted(program::Function function, const std::vector<Pass>& left_out) const {
  function.rounding.amplification = amplification(function);
  for (const PassInfo& info : passes()) {
    if (std::ranges::find(left_out, info.pass) != left_out.end()) {
      function.rounding.left_out.emplace_back(info.name);
    }
  }
  return function;
}

program::Function Gate::formulate(const std::vector<Pass>& left_out, int effort) const {
  Options options = without(options_, left_out);
  options.effort = effort;
  return noted(search_(tree_, recipe_, options)(0), left_out);
}

bool is_accurate(const program::Function& function) {
  return function.rounding.amplification <= kMostAmplification;
}

/// The cheapest without one pass; if none is accurate without all but the algebra, and without that
/// as well.
program::Function Gate::without_culprits() const {
  const std::vector<Pass> on = passes_of(options_);
  std::vector<Pass> left_out;
  std::optional<program::Function> cheapest;
  for (const Pass pass : on) {
    program::Function quick = formulate({pass}, 0);
    if (is_accurate(quick) &&
        (!cheapest || weight(program::cost(quick)) < weight(program::cost(*cheapest)))) {
      left_out = {pass};
      cheapest = std::move(quick);
    }
  }
  if (!cheapest) {
    left_out = judged(options_);
    std::erase(left_out, Pass::kAlgebra);
    cheapest = formulate(left_out, 0);
  }
  if (!is_accurate(*cheapest)) {
    return formulate(judged(options_), 0);
  }
  program::Function function = formulate(left_out, options_.effort);
  return is_accurate(function) ? function : std::move(*cheapest);
}

program::Function Gate::run() const {
  Writer write = search_(tree_, recipe_, options_);
  program::Function function = noted(write(0), {});
  const double refused = function.rounding.amplification;
  const int seeds = refused <= kNearly * kMostAmplification && options_.effort > 0 &&
                            options_.has(Pass::kSearch) && options_.has(Pass::kAlgebra)
                        ? kSeeds
                        : 1;
  for (int seed = 1; seed < seeds && !is_accurate(function); ++seed) {
    function = noted(write(seed), {});
  }
  if (is_accurate(function)) {
    return function;
  }
  write = nullptr;  // with all that its searches keep
  program::Function better = without_culprits();
  better.rounding.refused = refused;
  return better;
}

}  // namespace

program::Function held_to_rounding(const model::Tree& tree, const Recipe& recipe,
                                   const Options& options, Search search) {
  return Gate(tree, recipe, options, search).run();
}

bool holds(const program::Function& function, const model::Tree& tree, const Recipe& recipe,
           const Options& options) {
  return Gate(tree, recipe, options, nullptr).holds(function);
}

}  // namespace treedyn::formulate
