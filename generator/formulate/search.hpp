// Chooses the cheapest variant of a formulation.
#pragma once

#include "formulate/functions.hpp"

namespace treedyn::formulate {

/// Descent and threshold accepting over the choices of Variant with `options.effort` moves, a
/// quarter more where axes are parallel, and a fixed seed: the same function on every run and
/// machine. The result has passed the algebraic passes.
program::Function cheapest(const model::Tree& tree, const Recipe& recipe, const Options& options);

/// The same for a scene's numbers: by what they are seen as if the numbers allow it, that is not
/// where what is zero by chance was divided by, or where it has cancelled nearly.
program::Function cheapest_by_structure(const model::Tree& tree, const Recipe& recipe,
                                        const Options& options);

}  // namespace treedyn::formulate
