#include "formulate/search.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "common/parallel.hpp"
#include "formulate/gate.hpp"
#include "formulate/variant_search.hpp"
#include "program/rounding.hpp"

namespace treedyn::formulate {

namespace {

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

/// The search among the variants of one method, and beside it one in metres where units of length
/// are open.
class MethodSearch {
 public:
  MethodSearch(const model::Tree& tree, const Recipe& recipe, const Options& options,
               const Variant& start)
      : tree_(tree),
        recipe_(recipe),
        options_(options),
        metres_(options),
        search_(tree_, recipe_, options_, start) {
    metres_.metres = true;
  }

  void run() {
    search_.run();
    best_cost_ = search_.best_cost();
  }
  /// Before units of length are tried.
  [[nodiscard]] int best_cost() const { return best_cost_; }
  /// What `run` has found, in another unit of length than the metre only if it pays.
  [[nodiscard]] program::Function result(int seed);

 private:
  const model::Tree& tree_;
  const Recipe& recipe_;
  const Options options_;
  Options metres_;
  VariantSearch search_;
  int best_cost_ = 0;
  std::optional<VariantSearch> in_metres_;
};

program::Function MethodSearch::result(int seed) {
  if (search_.best().unit_length == 0) {
    return search_.result(seed);
  }
  if (!in_metres_) {
    Variant start = search_.best();
    start.unit_length = 0;
    in_metres_.emplace(tree_, recipe_, metres_, start);
    in_metres_->run();
    search_.try_units_of_length(in_metres_->best());
  }
  program::Function function = search_.result(seed);
  program::Function plain = in_metres_->result(seed);
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

/// The cheaper of two methods, the second only if it saves `least` percent; the other one where
/// float can do with that alone. What is far behind is not written for nothing.
program::Function cheaper(MethodSearch& first, MethodSearch& second, int least, int seed) {
  const auto is_far_ahead = [](const MethodSearch& a, const MethodSearch& b, int percent) {
    return (100 + percent) * a.best_cost() < 100 * b.best_cost();
  };
  const bool second_leads = is_far_ahead(second, first, kFarBehind + least);
  std::vector<program::Function> both;
  if (second_leads || is_far_ahead(first, second, kFarBehind)) {
    both.push_back((second_leads ? second : first).result(seed));
    if (program::float_error(both.front()) <= kLost) {
      return both.front();
    }
    both.push_back((second_leads ? first : second).result(seed));
  } else {
    both = results_of<program::Function>({[&] { return first.result(seed); },
                                          [&] {
                                            return second.result(seed);
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
Writer best_method(const model::Tree& tree, const Recipe& recipe, const Options& options) {
  const auto search = [&](const Variant& start) {
    return std::make_shared<MethodSearch>(tree, recipe, options, start);
  };
  const auto alone = [&](const Variant& start) -> Writer {
    const auto only = search(start);
    only->run();
    return [only](int seed) {
      return only->result(seed);
    };
  };
  Variant factor = plain_variant(tree);
  switch_off(options.without, factor);
  factor.way = recipe.freedom.way;
  Variant articulated = factor;
  articulated.articulated = true;
  if (!recipe.freedom.articulated || options.forward_dynamics == ForwardDynamics::kFactor) {
    return alone(factor);
  }
  const auto plain_cost = [&](const Variant& start) {
    return weight(program::cost(build(tree, recipe, options, start)));
  };
  if (options.forward_dynamics == ForwardDynamics::kArticulated ||
      plain_cost(factor) > kHopeless * plain_cost(articulated)) {
    return alone(articulated);
  }
  const auto first = search(factor);
  const auto second = search(articulated);
  run_all({[&] { first->run(); },
           [&] {
             second->run();
           }});
  const int least = options.scene != nullptr ? kWorthwhile : 0;
  return [first, second, least](int seed) {
    return cheaper(*first, *second, least, seed);
  };
}

Writer searched(const model::Tree& tree, const Recipe& recipe, const Options& options) {
  Options plain = options;
  plain.share_limbs = false;
  if (!options.share_limbs || recipe.freedom.own_code || find_limbs(tree).empty()) {
    return best_method(tree, recipe, plain);
  }
  return [shared = best_method(tree, recipe, options), alone = Writer(), plain, &tree,
          &recipe](int seed) mutable {
    program::Function function = shared(seed);
    if (function.limb_code) {
      return function;
    }
    if (!alone) {
      alone = best_method(tree, recipe, plain);
    }
    return alone(seed);
  };
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
