// The search among the variants of one function.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "common/index.hpp"
#include "formulate/choices.hpp"
#include "formulate/stand_ins.hpp"
#include "optimise/optimise.hpp"

namespace treedyn::formulate {

/// A variant and what it costs.
struct Candidate {
  Variant variant;
  int cost = 0;

  /// Becomes `other` if that costs less.
  bool improve(const Variant& other, int other_cost) {
    if (other_cost >= cost) {
      return false;
    }
    variant = other;
    cost = other_cost;
    return true;
  }
};

/// Compares variants by the operations of their formulations first, then by those that the quick
/// algebraic passes leave: descent over single choices, threshold accepting, and a descent over
/// pairs of choices that pay together.
class VariantSearch {
 public:
  /// \param start  one variant; tree, recipe and options outlive the search
  VariantSearch(const model::Tree& tree, const Recipe& recipe, const Options& options,
                const Variant& start);

  /// Compares variants.
  void run();
  /// What `run` has chosen, and what it costs before all algebraic passes have run.
  [[nodiscard]] const Variant& best() const { return best_.variant; }
  [[nodiscard]] int best_cost() const { return best_.cost; }
  /// The best variant after the algebraic passes, whose search starts from `seed`; with
  /// `share_limbs` empty if nothing can be shared.
  [[nodiscard]] program::Function result(int seed) const;
  /// The variant of another search in that unit of length in which it costs least, if that is less
  /// than `run` has found, is the best one then.
  void try_units_of_length(Variant other);

 private:
  using Cache = std::map<Variant, int>;

  [[nodiscard]] optimise::Effort algebra_effort(const program::Function& function, int seed) const;
  void note(const Variant& variant, int cost);
  /// False if its unit of length is none: a length that is seen as one and is zero.
  [[nodiscard]] bool is_usable(const Variant& variant) const {
    return variant.unit_length == 0 || has_unit_[to_index(variant.unit_length - 1)];
  }
  void try_ways(Candidate& best);
  void meet_elsewhere(Candidate& best);
  void drop_what_does_not_pay(Candidate& best);
  int raw_cost(const Variant& variant);
  int optimised_cost(const Variant& variant);
  /// First-improvement descent over all choices in random order; stops when `limit` moves are left.
  template <class Evaluate>
  void descend(Candidate& best, int limit, Evaluate evaluate);
  /// One round of it: true if it improved, and all choices had their turn.
  template <class Evaluate>
  bool descend_once(Candidate& best, int limit, const std::vector<std::size_t>& order,
                    Evaluate& evaluate);
  /// Both choices of the runs of parallel axes at once, and a descent where that pays.
  template <class Evaluate>
  bool cut_run(const Choice& run, Candidate& best, Evaluate& evaluate);
  template <class Evaluate>
  void cut_runs(Candidate& best, Evaluate evaluate);
  template <class Evaluate>
  void anneal(Candidate& best, int limit, int cycle, Evaluate evaluate);
  Variant perturbed(Variant variant);
  std::uint64_t random(std::size_t bound) { return generator_() % bound; }

  const model::Tree& tree_;
  const Recipe& recipe_;
  const Options& options_;
  const Seen seen_;
  Formulations formulations_;  ///< with stand-ins alone
  std::vector<Choice> choices_;
  std::vector<bool> has_unit_;  ///< by unit of length
  Candidate best_;
  int moves_ = 0;
  std::mt19937_64 generator_{20110602};
  Cache raw_;
  Cache optimised_;
  std::vector<std::pair<int, Variant>>
      finalists_;  ///< cheapest before the algebraic passes, ascending
};

}  // namespace treedyn::formulate
