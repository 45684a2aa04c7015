#include "formulate/search.hpp"

#include <algorithm>
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

/// What a search has found, in another unit of length than the metre only if it pays.
program::Function found(const model::Tree& tree, const Recipe& recipe, const Options& options,
                        VariantSearch& search) {
  if (search.best().unit_length == 0) {
    return search.result();
  }
  Options metres = options;
  metres.metres = true;
  Variant plain_start = search.best();
  plain_start.unit_length = 0;
  VariantSearch in_metres(tree, recipe, metres, plain_start);
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
  VariantSearch search(tree, recipe, options, start);
  search.run();
  return found(tree, recipe, options, search);
}

/// The cheaper of two methods, the second only if it saves `kWorthwhile` percent in a scene; the
/// other one where float can do with that alone. What is far behind is not written for nothing.
program::Function cheaper(const model::Tree& tree, const Recipe& recipe, const Options& options,
                          VariantSearch& first, VariantSearch& second) {
  run_all({[&] { first.run(); },
           [&] {
             second.run();
           }});
  const auto of = [&](VariantSearch& search) {
    return found(tree, recipe, options, search);
  };
  const int least = options.scene != nullptr ? kWorthwhile : 0;
  const auto is_far_ahead = [](const VariantSearch& a, const VariantSearch& b, int percent) {
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
  VariantSearch first(tree, recipe, options, factor);
  VariantSearch second(tree, recipe, options, articulated);
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
