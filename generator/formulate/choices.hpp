// What the search may choose.
#pragma once

#include <vector>

#include "formulate/functions.hpp"

namespace treedyn::formulate {

/// One free choice: setting number k of `settings`.
struct Choice {
  int settings = 0;
  std::vector<int>
      links;  ///< symmetric links that take the same setting; empty: a choice of the whole variant
  void (*change)(Variant&, const Choice&, int setting) = nullptr;
  /// The first links of the chains of parallel axes that `links` are in: heads of their runs where
  /// no link between stands apart and no brother goes on with the run.
  std::vector<int> heads = {};

  void set(Variant& variant, int setting) const { change(variant, *this, setting); }
};

template <class Field, class Value>
void set_links(Variant& variant, const std::vector<int>& links, Field field, Value value) {
  for (const int i : links) {
    variant.links[static_cast<std::size_t>(i)].*field = value;
  }
}

/// All of a function, none without a search. Links that look the same to it choose together.
std::vector<Choice> choices_of(const model::Tree& tree, const Freedom& freedom,
                               const Options& options);

/// Two choices at once, where neither alone may pay: one frame for links with parallel axes, and
/// where their run is cut. None without a search.
std::vector<Choice> run_choices_of(const model::Tree& tree, const Options& options);

/// Variants that differ from one in a single choice.
int other_settings(const std::vector<Choice>& choices);

}  // namespace treedyn::formulate
