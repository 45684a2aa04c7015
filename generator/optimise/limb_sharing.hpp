// The limbs of a function share code.
#pragma once

#include <memory>
#include <optional>

#include "optimise/optimise.hpp"
#include "optimise/program_names.hpp"

namespace treedyn::optimise {

/// Takes the limbs out of `function`, whose leaves are those of `limbs`: what is the same in all
/// limbs of a class, up to joints and constants, is a phase; what is not stays with the trunk. Null
/// if nothing is the same. O(n log n) for n nodes, a few times, and the algebraic passes for trunk
/// and phases if `effort` is given.
std::shared_ptr<const LimbCode> limb_code(const Function& function, const Limbs& limbs,
                                          const std::optional<Effort>& effort);

/// Takes away values of limbs and of the trunk that nobody needs and phases that compute none, and
/// writes values of limbs that are a number as that number where they are needed. To be called
/// before the columns are numbered. O(size of the graphs), a few times.
void prune(LimbCode& code);

}  // namespace treedyn::optimise
