#include "formulate/variant_search.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "optimise/limb_sharing.hpp"

namespace treedyn::formulate {

namespace {

/// Graphs above this size get proportionally fewer moves, but half of them suffice to try every
/// setting once.
constexpr std::size_t kReferenceSize = 1500;
/// One evaluation with algebraic passes counts as this many moves.
constexpr int kOptimisedMove = 8;
/// Moves of the algebraic local search for each move of the search among formulations.
constexpr int kAlgebraMoves = 5;
/// Functions with more operations get proportionally fewer of them.
constexpr int kReferenceOperations = 3000;
/// Formulations that are compared after the algebraic passes.
constexpr std::size_t kFinalists = 24;
/// Random changes between two restarts from the best variant.
constexpr int kCycle = 400;
/// For each so many moves of the search there is one more for what single choices do not reach.
constexpr int kMovesForRuns = 4;
/// What cannot be used.
constexpr int kNever = std::numeric_limits<int>::max();
/// A length in m below this one is none.
constexpr double kShortestUnit = 1e-9;

/// Where passes leave so many operations.
int weight_of(const program::Cost& raw, int operations) {
  return weight(raw) - raw.total() + operations;
}

}  // namespace

VariantSearch::VariantSearch(const model::Tree& tree, const Recipe& recipe, const Options& options,
                             const Variant& start)
    : tree_(tree),
      recipe_(recipe),
      options_(options),
      seen_(stand_ins_alone(tree, options)),
      formulations_(seen_.tree, recipe, seen_.options),
      choices_(choices_of(tree, recipe.freedom, options)) {
  for (const program::LengthUnit& unit : unit_lengths(tree)) {
    has_unit_.push_back(abs(unit.metres.digits()) > kShortestUnit);
  }
  const program::Function first = formulations_.build(start).function;
  const std::size_t size = std::max(first.graph.size(), kReferenceSize);
  moves_ = static_cast<int>(static_cast<std::size_t>(options.effort) * kReferenceSize / size);
  moves_ = std::max(moves_, std::min(options.effort, 2 * other_settings(choices_)));
  note(start, weight(program::cost(first)));
}

void VariantSearch::note(const Variant& variant, int cost) {
  raw_.emplace(variant, cost);
  const std::pair<int, Variant> entry(cost, variant);
  finalists_.insert(std::ranges::upper_bound(finalists_, entry), entry);
  if (finalists_.size() > kFinalists) {
    finalists_.pop_back();
  }
}

int VariantSearch::raw_cost(const Variant& variant) {
  if (!is_usable(variant)) {
    return kNever;
  }
  const auto known = raw_.find(variant);
  if (known != raw_.end()) {
    return known->second;
  }
  --moves_;
  const int cost = weight(formulations_.cost(variant));
  note(variant, cost);
  return cost;
}

int VariantSearch::optimised_cost(const Variant& variant) {
  if (!is_usable(variant)) {
    return kNever;
  }
  const auto known = optimised_.find(variant);
  if (known != optimised_.end()) {
    return known->second;
  }
  moves_ -= kOptimisedMove;
  const program::Cost raw = formulations_.cost(variant);
  const int total = options_.has(Pass::kAlgebra) ? formulations_.estimate(variant) : raw.total();
  const int cost = weight_of(raw, total);
  return optimised_.emplace(variant, cost).first->second;
}

template <class Evaluate>
void VariantSearch::descend(Candidate& best, int limit, Evaluate evaluate) {
  std::vector<std::size_t> order(choices_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (bool improved = true; improved;) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[random(i)]);
    }
    improved = descend_once(best, limit, order, evaluate);
  }
}

template <class Evaluate>
bool VariantSearch::descend_once(Candidate& best, int limit, const std::vector<std::size_t>& order,
                                 Evaluate& evaluate) {
  bool improved = false;
  for (const std::size_t n : order) {
    for (int setting = 0; setting < choices_[n].settings; ++setting) {
      if (moves_ <= limit) {
        return false;
      }
      Variant trial = best.variant;
      choices_[n].set(trial, setting);
      improved = best.improve(trial, evaluate(trial)) || improved;
    }
  }
  return improved;
}

template <class Evaluate>
bool VariantSearch::cut_run(const Choice& run, Candidate& best, Evaluate& evaluate) {
  const int before = best.cost;
  for (int setting = 0; setting < run.settings && moves_ > 0; ++setting) {
    Variant trial = best.variant;
    run.set(trial, setting);
    if (best.improve(trial, evaluate(trial))) {
      descend(best, 0, evaluate);
    }
  }
  return best.cost < before;
}

template <class Evaluate>
void VariantSearch::cut_runs(Candidate& best, Evaluate evaluate) {
  const std::vector<Choice> runs = run_choices_of(tree_, options_);
  for (bool improved = true; improved;) {
    improved = false;
    for (const Choice& run : runs) {
      improved = cut_run(run, best, evaluate) || improved;
    }
  }
}

Variant VariantSearch::perturbed(Variant variant) {
  const std::uint64_t changes = 1 + random(3);
  for (std::uint64_t k = 0; k < changes; ++k) {
    const Choice& choice = choices_[random(choices_.size())];
    choice.set(variant, static_cast<int>(random(static_cast<std::size_t>(choice.settings))));
  }
  return variant;
}

/// Threshold accepting: a random change is kept if it costs at most `tolerance` more, which shrinks
/// to nothing over a cycle; the next cycle starts from the best variant found.
template <class Evaluate>
void VariantSearch::anneal(Candidate& best, int limit, int cycle, Evaluate evaluate) {
  const int most_attempts = 20 * std::max(moves_ - limit, 0);  // a bound where few variants exist
  Candidate current = best;
  for (int attempt = 0; attempt < most_attempts && moves_ > limit; ++attempt) {
    const int phase = attempt % cycle;
    if (phase == 0) {
      current = best;
    }
    const int tolerance = best.cost / 25 * (cycle - phase) / cycle;
    const Variant trial = perturbed(current.variant);
    const int cost = evaluate(trial);
    if (cost <= current.cost + static_cast<int>(random(to_index(tolerance) + 1))) {
      current = {trial, cost};
      best.improve(trial, cost);
    }
  }
}

/// Tries to do without each pass that is on, for the whole tree: no pass may add operations. Sums
/// of angles never do.
void VariantSearch::drop_what_does_not_pay(Candidate& best) {
  const auto consider = [&](const Variant& trial) {
    best.improve(trial, raw_cost(trial));
  };
  std::vector<int> links(tree_.links.size());
  std::iota(links.begin(), links.end(), 0);
  for (const PassInfo& info : passes()) {
    if (options_.has(info.pass) && info.pass != Pass::kSums) {
      Variant trial = best.variant;
      switch_off({info.pass}, trial);
      consider(trial);
      if (info.pass == Pass::kParallel) {
        trial = best.variant;
        set_links(trial, links, &LinkVariant::cut, std::uint8_t{0});
        consider(trial);
      } else if (info.pass == Pass::kPseudoInertia) {
        trial = best.variant;
        set_links(trial, links, &LinkVariant::tensor_moment, true);
        consider(trial);
      }
    }
  }
}

/// Where travelling values meet changes how the cost grows, which is worth a look where the moves
/// do not suffice to try every setting.
void VariantSearch::try_ways(Candidate& best) {
  for (const Way way : {Way::kToRoot, Way::kInLinks, Way::kInBase}) {
    Variant trial = best.variant;
    trial.way = way;
    best.improve(trial, raw_cost(trial));
  }
}

/// In frames of links or in the base: the algebra finds more of one than of the other.
void VariantSearch::meet_elsewhere(Candidate& best) {
  const auto with = [&](Way way) {
    Variant variant = best.variant;
    variant.way = way;
    return variant;
  };
  const auto reached = [&](const Variant& variant) {
    const program::Function function = formulations_.build(variant).function;
    const program::Cost raw = program::cost(function);
    return weight_of(raw, optimise::estimate_operations(function.graph, function.outputs,
                                                        optimise::Values::kAll));
  };
  Variant other = with(Way::kInBase);
  if (best.variant.way == Way::kInBase) {
    const bool to_root = raw_cost(with(Way::kToRoot)) <= raw_cost(with(Way::kInLinks));
    other.way = to_root ? Way::kToRoot : Way::kInLinks;
  }
  if (reached(other) < reached(best.variant)) {
    best = {other, optimised_cost(other)};
  }
}

/// Moves of the algebraic local search, fewer for large functions; none without a search.
optimise::Effort VariantSearch::algebra_effort(const program::Function& function, int seed) const {
  optimise::Effort effort;
  effort.seed = seed;
  if (options_.has(Pass::kSearch)) {
    const std::int64_t operations = std::max(program::cost(function).total(), kReferenceOperations);
    effort.moves = static_cast<int>(std::int64_t{kAlgebraMoves} * options_.effort *
                                    kReferenceOperations / operations);
  }
  return effort;
}

void VariantSearch::run() {
  const auto raw = [this](const Variant& variant) {
    return raw_cost(variant);
  };
  const auto optimised = [this](const Variant& variant) {
    return optimised_cost(variant);
  };
  Candidate best{finalists_.front().second, finalists_.front().first};
  if (recipe_.freedom.open_way && options_.has(Pass::kSearch) &&
      moves_ <= 2 * other_settings(choices_)) {
    try_ways(best);
  }
  drop_what_does_not_pay(best);
  const int all = moves_;
  const int half = all / 2;
  if (!choices_.empty()) {
    descend(best, half, raw);
    anneal(best, half, kCycle, raw);
  }
  best.cost = optimised_cost(best.variant);
  for (const auto& [raw_cost, variant] : finalists_) {
    best.improve(variant, half > 0 ? optimised_cost(variant) : best.cost);
  }
  if (!choices_.empty()) {
    descend(best, half / 2, optimised);
    anneal(best, half / 4, kCycle / 4, optimised);
    descend(best, 0, optimised);
    moves_ = all / kMovesForRuns;
    cut_runs(best, optimised);
  }
  if (recipe_.freedom.open_way && options_.has(Pass::kSearch) && options_.has(Pass::kAlgebra)) {
    meet_elsewhere(best);
  }
  best_ = best;
}

void VariantSearch::try_units_of_length(Variant other) {
  const std::size_t lengths = unit_lengths(tree_).size();
  for (std::size_t k = 0; k < lengths; ++k) {
    ++other.unit_length;
    best_.improve(other, optimised_cost(other));
  }
}

program::Function VariantSearch::result(int seed) const {
  Built built = Formulations(tree_, recipe_, options_).build(best_.variant);
  program::Function& function = built.function;
  std::optional<optimise::Effort> effort;
  if (options_.has(Pass::kAlgebra)) {
    effort = algebra_effort(function, seed);
  }
  if (!options_.share_limbs) {
    program::Function result =
        effort ? optimise::optimised(function, *effort) : std::move(function);
    result.unit = unit_of(tree_, best_.variant);
    return result;
  }
  const std::size_t points = options_.points.size();
  function.signature = signature(recipe_.name, tree_.dof(), static_cast<int>(points));
  const auto code = optimise::limb_code(function, built.limbs, effort);
  program::Function result = code ? program::flat(code, function.signature) : program::Function{};
  result.unit = unit_of(tree_, best_.variant);
  return result;
}

}  // namespace treedyn::formulate
