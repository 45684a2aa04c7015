#include "simplify/search.hpp"

namespace treedyn::simplify {

program::Function cheapest(const model::Tree& tree, const Recipe& recipe, const Options& options) {
  return build(tree, recipe, options, plain_variant(tree));
}

}  // namespace treedyn::simplify
