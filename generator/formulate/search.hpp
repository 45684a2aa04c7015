// Chooses the cheapest variant of a formulation.
#pragma once

#include "formulate/functions.hpp"

namespace treedyn::formulate {

/// Coordinate descent over the choices of Variant with `options.effort` moves and a fixed seed: the
/// same function on every run and machine. The result has passed the algebraic passes.
program::Function cheapest(const model::Tree& tree, const Recipe& recipe, const Options& options);

}  // namespace treedyn::formulate
