// The reverse of factoring and sharing: takes expressions apart, so that the passes can put them
// together in another way.
#pragma once

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// Takes apart up to `count` operands, chosen by `random`: a sum (product) that is shared is
/// written out in one of its users, a product of a sum that is a term becomes a sum of products.
/// Values stay the same, operations increase.
/// \param[in,out] network  normalised before, not afterwards
void expand_at_random(Network& network, Random& random, int count);

}  // namespace treedyn::optimise
