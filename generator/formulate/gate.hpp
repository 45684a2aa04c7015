// Holds the rounding of formulations to that of the equations as they stand.
#pragma once

#include <functional>

#include "formulate/functions.hpp"

namespace treedyn::formulate {

/// Writes what a search among formulations has found, with a seed of the algebraic search.
using Writer = std::function<program::Function(int seed)>;
/// A search among formulations with the passes that `options` leave on. All three outlive what it
/// returns.
using Search = Writer (*)(const model::Tree& tree, const Recipe& recipe, const Options& options);

/// What `search` finds. Where its `amplification` of rounding against the
/// formulation without passes exceeds 4, passes are left out, as few as possible; `rounding` of the
/// result says which.
program::Function held_to_rounding(const model::Tree& tree, const Recipe& recipe,
                                   const Options& options, Search search);

/// True if `function` has the results of the formulation without passes (of a scene: any), and
/// `amplification` does not exceed 4: what was found for stand-ins (stand_ins.hpp) may be used for
/// the robot itself.
bool holds(const program::Function& function, const model::Tree& tree, const Recipe& recipe,
           const Options& options);

}  // namespace treedyn::formulate
