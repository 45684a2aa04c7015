// Pairs of operands that several sums or several products have in common.
#pragma once

#include <cstdint>

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// a + b in several sums (up to sign), or a b in several products, is computed once: the most
/// frequent pair first, then again; larger common parts follow from repeated pairs. Ties go to the
/// earliest pair; `seed` other than zero breaks them at random instead.
///
/// Each step saves at least one operation. Operands of very long sums are paired with near ones
/// only, so the cost is O(n log n).
/// \param          kind     kAdd or kMultiply
/// \param[in,out]  network  normalised before, not afterwards
/// \return the number of operations that were saved
int share_pairs(Network& network, Kind kind, std::uint64_t seed = 0);

}  // namespace treedyn::optimise
