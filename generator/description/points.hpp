// Named points of a model file; `--points` is resolved by `resolve_points` of read.hpp.
#pragma once

#include "description/numbers.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// Fills `points` of `tree`, whose frames are complete.
/// \throws InputError for unknown links, repeated names and equal identifiers.
void resolve_named_points(const RawTree& raw, const NumberReader& numbers, model::Tree& tree);

}  // namespace treedyn::description
