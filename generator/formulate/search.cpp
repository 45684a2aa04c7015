#include "formulate/search.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>

#include "common/index.hpp"
#include "common/parallel.hpp"
#include "formulate/choices.hpp"
#include "formulate/gate.hpp"
#include "formulate/stand_ins.hpp"
#include "optimise/limb_sharing.hpp"
#include "program/rounding.hpp"

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

class Search {
 public:
  Search(const model::Tree& tree, const Recipe& recipe, const Options& options,
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

  /// Compares variants.
  void run();
  /// What `run` has chosen, and what it costs before all algebraic passes have run.
  [[nodiscard]] const Variant& best() const { return best_; }
  [[nodiscard]] int best_cost() const { return best_cost_; }
  /// The best variant after the algebraic passes; with `share_limbs` empty if nothing can be
  /// shared.
  [[nodiscard]] program::Function result() const;
  /// The variant of another search in that unit of length in which it costs least, if that is less
  /// than `run` has found, is the best one then.
  void try_units_of_length(Variant other);

 private:
  using Cache = std::map<Variant, int>;

  [[nodiscard]] std::vector<int> all_links() const {
    std::vector<int> links(tree_.links.size());
    std::iota(links.begin(), links.end(), 0);
    return links;
  }
  [[nodiscard]] optimise::Effort algebra_effort(const program::Function& function) const;
  void note(const Variant& variant, int cost);
  /// False if its unit of length is none: a length that is seen as one and is zero.
  [[nodiscard]] bool is_usable(const Variant& variant) const {
    return variant.unit_length == 0 || has_unit_[to_index(variant.unit_length - 1)];
  }
  void drop_what_does_not_pay(Variant& variant, int& cost);
  int raw_cost(const Variant& variant);
  int optimised_cost(const Variant& variant);
  /// First-improvement descent over all choices in random order; stops when `limit` moves are left.
  template <class Evaluate>
  void descend(Variant& variant, int& cost, int limit, Evaluate evaluate);
  /// One round of it: true if it improved, and all choices had their turn.
  template <class Evaluate>
  bool descend_once(Variant& variant, int& cost, int limit, const std::vector<std::size_t>& order,
                    Evaluate& evaluate);
  /// Both choices of the runs of parallel axes at once, and a descent where that pays.
  template <class Evaluate>
  bool cut_run(const Choice& run, Variant& best, int& cost, Evaluate& evaluate);
  template <class Evaluate>
  void cut_runs(Variant& best, int& cost, Evaluate evaluate);
  template <class Evaluate>
  void anneal(Variant& best, int& best_cost, int limit, int cycle, Evaluate evaluate);
  Variant perturbed(Variant variant);
  std::uint64_t random(std::size_t bound) { return generator_() % bound; }

  const model::Tree& tree_;
  const Recipe& recipe_;
  const Options& options_;
  const Seen seen_;
  Formulations formulations_;  ///< with stand-ins alone
  std::vector<Choice> choices_;
  std::vector<bool> has_unit_;  ///< by unit of length
  Variant best_;
  int best_cost_ = 0;
  int moves_ = 0;
  std::mt19937_64 generator_{20110602};
  Cache raw_;
  Cache optimised_;
  std::vector<std::pair<int, Variant>>
      finalists_;  ///< cheapest before the algebraic passes, ascending
};

void Search::note(const Variant& variant, int cost) {
  raw_.emplace(variant, cost);
  const std::pair<int, Variant> entry(cost, variant);
  finalists_.insert(std::upper_bound(finalists_.begin(), finalists_.end(), entry), entry);
  if (finalists_.size() > kFinalists) {
    finalists_.pop_back();
  }
}

int Search::raw_cost(const Variant& variant) {
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

int Search::optimised_cost(const Variant& variant) {
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
  const int cost = weight(raw) - raw.total() + total;
  return optimised_.emplace(variant, cost).first->second;
}

template <class Evaluate>
void Search::descend(Variant& variant, int& cost, int limit, Evaluate evaluate) {
  std::vector<std::size_t> order(choices_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (bool improved = true; improved;) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[random(i)]);
    }
    improved = descend_once(variant, cost, limit, order, evaluate);
  }
}

template <class Evaluate>
bool Search::descend_once(Variant& variant, int& cost, int limit,
                          const std::vector<std::size_t>& order, Evaluate& evaluate) {
  bool improved = false;
  for (const std::size_t n : order) {
    for (int setting = 0; setting < choices_[n].settings; ++setting) {
      if (moves_ <= limit) {
        return false;
      }
      Variant trial = variant;
      choices_[n].set(trial, setting);
      const int trial_cost = evaluate(trial);
      if (trial_cost < cost) {
        cost = trial_cost;
        variant = trial;
        improved = true;
      }
    }
  }
  return improved;
}

template <class Evaluate>
bool Search::cut_run(const Choice& run, Variant& best, int& cost, Evaluate& evaluate) {
  const int before = cost;
  for (int setting = 0; setting < run.settings && moves_ > 0; ++setting) {
    Variant trial = best;
    run.set(trial, setting);
    if (const int trial_cost = evaluate(trial); trial_cost < cost) {
      cost = trial_cost;
      best = trial;
      descend(best, cost, 0, evaluate);
    }
  }
  return cost < before;
}

template <class Evaluate>
void Search::cut_runs(Variant& best, int& cost, Evaluate evaluate) {
  const std::vector<Choice> runs = run_choices_of(tree_, options_);
  for (bool improved = true; improved;) {
    improved = false;
    for (const Choice& run : runs) {
      improved = cut_run(run, best, cost, evaluate) || improved;
    }
  }
}

Variant Search::perturbed(Variant variant) {
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
void Search::anneal(Variant& best, int& best_cost, int limit, int cycle, Evaluate evaluate) {
  const int most_attempts = 20 * std::max(moves_ - limit, 0);  // a bound where few variants exist
  Variant current = best;
  int current_cost = best_cost;
  for (int attempt = 0; attempt < most_attempts && moves_ > limit; ++attempt) {
    const int phase = attempt % cycle;
    if (phase == 0) {
      current = best;
      current_cost = best_cost;
    }
    const int tolerance = best_cost / 25 * (cycle - phase) / cycle;
    const Variant trial = perturbed(current);
    const int cost = evaluate(trial);
    if (cost <= current_cost + static_cast<int>(random(static_cast<std::size_t>(tolerance) + 1))) {
      current = trial;
      current_cost = cost;
      if (cost < best_cost) {
        best = trial;
        best_cost = cost;
      }
    }
  }
}

/// Tries to do without each pass that is on, for the whole tree: no pass may add operations. Sums
/// of angles never do.
void Search::drop_what_does_not_pay(Variant& variant, int& cost) {
  const auto consider = [&](const Variant& trial) {
    if (const int trial_cost = raw_cost(trial); trial_cost < cost) {
      cost = trial_cost;
      variant = trial;
    }
  };
  for (const PassInfo& info : passes()) {
    if (options_.has(info.pass) && info.pass != Pass::kSums) {
      Variant trial = variant;
      switch_off({info.pass}, trial);
      consider(trial);
      if (info.pass == Pass::kParallel) {
        trial = variant;
        set_links(trial, all_links(), &LinkVariant::cut, std::uint8_t{0});
        consider(trial);
      } else if (info.pass == Pass::kPseudoInertia) {
        trial = variant;
        set_links(trial, all_links(), &LinkVariant::tensor_moment, true);
        consider(trial);
      }
    }
  }
}

/// Moves of the algebraic local search, fewer for large functions; none without a search.
optimise::Effort Search::algebra_effort(const program::Function& function) const {
  optimise::Effort effort;
  effort.seed = options_.seed;
  if (options_.has(Pass::kSearch)) {
    const std::int64_t operations = std::max(program::cost(function).total(), kReferenceOperations);
    effort.moves = static_cast<int>(std::int64_t{kAlgebraMoves} * options_.effort *
                                    kReferenceOperations / operations);
  }
  return effort;
}

void Search::run() {
  const auto raw = [this](const Variant& variant) {
    return raw_cost(variant);
  };
  const auto optimised = [this](const Variant& variant) {
    return optimised_cost(variant);
  };
  Variant best = finalists_.front().second;
  int cost = finalists_.front().first;
  drop_what_does_not_pay(best, cost);
  const int all = moves_;
  const int half = all / 2;
  if (!choices_.empty()) {
    descend(best, cost, half, raw);
    anneal(best, cost, half, kCycle, raw);
  }
  cost = optimised_cost(best);
  for (const auto& [raw_cost, variant] : finalists_) {
    if (const int c = half > 0 ? optimised_cost(variant) : cost; c < cost) {
      cost = c;
      best = variant;
    }
  }
  if (!choices_.empty()) {
    descend(best, cost, half / 2, optimised);
    anneal(best, cost, half / 4, kCycle / 4, optimised);
    descend(best, cost, 0, optimised);
    moves_ = all / kMovesForRuns;
    cut_runs(best, cost, optimised);
  }
  best_ = best;
  best_cost_ = cost;
}

void Search::try_units_of_length(Variant other) {
  const std::size_t lengths = unit_lengths(tree_).size();
  for (std::size_t k = 0; k < lengths; ++k) {
    ++other.unit_length;
    if (const int cost = optimised_cost(other); cost < best_cost_) {
      best_cost_ = cost;
      best_ = other;
    }
  }
}

program::Function Search::result() const {
  Built built = Formulations(tree_, recipe_, options_).build(best_);
  program::Function& function = built.function;
  std::optional<optimise::Effort> effort;
  if (options_.has(Pass::kAlgebra)) {
    effort = algebra_effort(function);
  }
  if (!options_.share_limbs) {
    program::Function result =
        effort ? optimise::optimised(function, *effort) : std::move(function);
    result.unit = unit_of(tree_, best_);
    return result;
  }
  const std::size_t points = options_.points.size();
  function.signature = signature(recipe_.name, tree_.dof(), static_cast<int>(points));
  const auto code = optimise::limb_code(function, built.limbs, effort);
  program::Function result = code ? program::flat(code, function.signature) : program::Function{};
  result.unit = unit_of(tree_, best_);
  return result;
}

/// What float may lose, as a part of the results, before the other method is asked, and how much
/// better that one has to be.
constexpr double kLost = 1e-3;
constexpr double kBetter = 10;
/// Without passes so many times dearer: no search makes up for that.
constexpr int kHopeless = 4;
/// Percent that articulated bodies have to save in a scene: armatures and constraints rule them
/// out, and what is not counted, moves and stores, must not make such an effect a gain.
constexpr int kWorthwhile = 10;
/// Percent that the algebraic passes do not make up for between two methods.
constexpr int kFarBehind = 15;

/// Percent of the operations that another unit of length has to save: its numbers say less to a
/// reader.
constexpr int kWorthAUnit = 2;

/// What a search has found, in another unit of length than the metre only if it pays.
program::Function found(const model::Tree& tree, const Recipe& recipe, const Options& options,
                        Search& search) {
  if (search.best().unit_length == 0) {
    return search.result();
  }
  Options metres = options;
  metres.metres = true;
  Variant plain_start = search.best();
  plain_start.unit_length = 0;
  Search in_metres(tree, recipe, metres, plain_start);
  in_metres.run();
  search.try_units_of_length(in_metres.best());
  program::Function function = search.result();
  program::Function plain = in_metres.result();
  if (function.outputs.empty() || plain.outputs.empty()) {
    return function;
  }
  const int operations = program::cost(plain).total();
  const int saved = operations - program::cost(function).total();
  return 100 * saved < kWorthAUnit * operations ? plain : function;
}

/// True if float loses much with `taken` and not with `left`. Where one of them has no limbs to
/// share, there is nothing to compare.
bool loses(const program::Function& taken, const program::Function& left) {
  if (taken.outputs.size() != left.outputs.size()) {
    return false;
  }
  const double error = program::float_error(taken);
  return error > kLost && program::float_error(left) < error / kBetter;
}

program::Function searched_from(const model::Tree& tree, const Recipe& recipe,
                                const Options& options, const Variant& start) {
  Search search(tree, recipe, options, start);
  search.run();
  return found(tree, recipe, options, search);
}

/// The cheaper of two methods, the second only if it saves `kWorthwhile` percent in a scene; the
/// other one where float can do with that alone. What is far behind is not written for nothing.
program::Function cheaper(const model::Tree& tree, const Recipe& recipe, const Options& options,
                          Search& first, Search& second) {
  run_all({[&] { first.run(); },
           [&] {
             second.run();
           }});
  const auto of = [&](Search& search) {
    return found(tree, recipe, options, search);
  };
  const int least = options.scene != nullptr ? kWorthwhile : 0;
  const auto is_far_ahead = [](const Search& a, const Search& b, int percent) {
    return (100 + percent) * a.best_cost() < 100 * b.best_cost();
  };
  const bool second_leads = is_far_ahead(second, first, kFarBehind + least);
  std::vector<program::Function> both;
  if (second_leads || is_far_ahead(first, second, kFarBehind)) {
    both.push_back(of(second_leads ? second : first));
    if (program::float_error(both.front()) <= kLost) {
      return both.front();
    }
    both.push_back(of(second_leads ? first : second));
  } else {
    both = results_of<program::Function>({[&] { return of(first); },
                                          [&] {
                                            return of(second);
                                          }});
    const int limit = (100 - least) * weight(program::cost(both.front()));
    if (100 * weight(program::cost(both.back())) < limit) {
      std::swap(both.front(), both.back());
    }
  }
  return loses(both.front(), both.back()) ? both.back() : both.front();
}

/// The cheapest of the methods that `options` leave open. Of long chains A is not searched: it has
/// N^2 entries.
program::Function best_method(const model::Tree& tree, const Recipe& recipe,
                              const Options& options) {
  Variant factor = plain_variant(tree);
  switch_off(options.without, factor);
  factor.way = recipe.freedom.way;
  Variant articulated = factor;
  articulated.articulated = true;
  if (!recipe.freedom.articulated || options.forward_dynamics == ForwardDynamics::kFactor) {
    return searched_from(tree, recipe, options, factor);
  }
  const auto plain_cost = [&](const Variant& start) {
    return weight(program::cost(build(tree, recipe, options, start)));
  };
  if (options.forward_dynamics == ForwardDynamics::kArticulated ||
      plain_cost(factor) > kHopeless * plain_cost(articulated)) {
    return searched_from(tree, recipe, options, articulated);
  }
  Search first(tree, recipe, options, factor);
  Search second(tree, recipe, options, articulated);
  return cheaper(tree, recipe, options, first, second);
}

program::Function searched(const model::Tree& tree, const Recipe& recipe, const Options& options) {
  if (options.share_limbs && !recipe.freedom.own_code && !find_limbs(tree).empty()) {
    program::Function shared = best_method(tree, recipe, options);
    if (shared.limb_code) {
      return shared;
    }
  }
  Options plain = options;
  plain.share_limbs = false;
  return best_method(tree, recipe, plain);
}

}  // namespace

program::Function cheapest(const model::Tree& tree, const Recipe& recipe, const Options& options) {
  return held_to_rounding(tree, recipe, options, searched);
}

program::Function cheapest_by_structure(const model::Tree& tree, const Recipe& recipe,
                                        const Options& options) {
  program::Function function = cheapest(tree, recipe, options);
  const Seen own = numbers_alone(tree, options);
  return holds(function, own.tree, recipe, own.options) ? function
                                                        : cheapest(own.tree, recipe, own.options);
}

}  // namespace treedyn::formulate
