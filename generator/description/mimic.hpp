// URDF mimic joints: q_i = multiplier * q_other + offset.
#pragma once

#include "description/numbers.hpp"
#include "description/skeleton.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// Fills `drives` and `coordinates` of `tree`, whose links are complete. Mimics of mimics are
/// followed to the independent joint. \param reduce  false: every joint stays independent; mistakes
/// are reported all the same \throws InputError for a mimic of an unknown or fixed joint and for
/// cycles.
void resolve_mimics(const RawTree& raw, const Skeleton& skeleton, const NumberReader& numbers,
                    bool reduce, model::Tree& tree);

}  // namespace treedyn::description
