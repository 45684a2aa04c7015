// Common factors of the terms of sums.
#pragma once

#include <cstdint>

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// c a + c b becomes c (a + b), the factor of most terms first; ties go to variables, then to the
/// earliest factor. `seed` other than zero breaks ties at random instead.
///
/// Each step saves at least one multiplication. O(n log n) for sums of bounded length.
/// \param[in,out] network  normalised before, not afterwards
/// \return the number of multiplications that were saved
int factor_sums(Network& network, std::uint64_t seed = 0);

}  // namespace treedyn::optimise
