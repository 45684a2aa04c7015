// Drops what crosses the border between trunk and limbs for nothing.
#pragma once

#include "optimise/program_names.hpp"

namespace treedyn::optimise {

/// Takes away values of limbs and of the trunk that nobody needs and phases that compute none, and
/// writes values of limbs that are a number as that number where they are needed. To be called
/// before the columns are numbered. O(size of the graphs), a few times.
void prune(LimbCode& code);

}  // namespace treedyn::optimise
