// Holds the rounding of formulations to that of the equations as they stand.
#pragma once

#include "formulate/functions.hpp"

namespace treedyn::formulate {

/// A way to formulate a function with the passes that `options` leave on.
using Formulate = program::Function (*)(const model::Tree& tree, const Recipe& recipe,
                                        const Options& options);

/// `formulated(tree, recipe, options)`. Where its `amplification` of rounding against the
/// formulation without passes exceeds 4, passes are left out, as few as possible; `rounding` of the
/// result says which.
program::Function held_to_rounding(const model::Tree& tree, const Recipe& recipe,
                                   const Options& options, Formulate formulate);

/// True if `function` has the results of the formulation without passes (of a scene: any), and
/// `amplification` does not exceed 4: what was found for stand-ins (stand_ins.hpp) may be used for
/// the robot itself.
bool holds(const program::Function& function, const model::Tree& tree, const Recipe& recipe,
           const Options& options);

}  // namespace treedyn::formulate
