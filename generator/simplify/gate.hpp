// Holds the rounding of formulations to that of the equations as they stand.
#pragma once

#include "simplify/functions.hpp"

namespace treedyn::simplify {

/// A way to formulate a function with the passes that `options` leave on.
using Formulate = program::Function (*)(const model::Tree& tree, const Recipe& recipe,
                                        const Options& options);

/// `formulate(tree, recipe, options)`. Where its `amplification` of rounding against the
/// formulation without passes exceeds 4, passes are left out, as few as possible; `rounding` of the
/// result says which.
program::Function held_to_rounding(const model::Tree& tree, const Recipe& recipe,
                                   const Options& options, Formulate formulate);

}  // namespace treedyn::simplify
