// Named points of a model file; `--points` is resolved by `resolve_points` of read.hpp.
#pragma once

#include <string_view>

#include "description/numbers.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// The link of the file with this name; `ground`, if it is no link and the base is fixed, is the
/// base frame. nullptr if there is none.
const model::Frame* find_frame(const model::Tree& tree, std::string_view name);

/// Fills `points` of `tree`, whose frames are complete.
/// \throws InputError for unknown links, repeated names and equal identifiers.
void resolve_named_points(const RawTree& raw, const NumberReader& numbers, model::Tree& tree);

}  // namespace treedyn::description
