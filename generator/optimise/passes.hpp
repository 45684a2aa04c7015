// Passes and sequences of them.
#pragma once

#include <cstdint>
#include <string_view>

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// c a + c b becomes c (a + b), the factor of most terms first; ties go to variables, then to the
/// earliest factor. `seed` other than zero breaks ties at random instead.
///
/// Each step saves at least one multiplication. O(n log n) for sums of bounded length.
/// \param[in,out] network  normalised before, not afterwards
/// \return the number of multiplications that were saved
int factor_sums(Network& network, std::uint64_t seed = 0);

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

/// The reverse of factoring and sharing, so that passes can put expressions together in another
/// way: takes apart up to `count` operands, chosen by `random`: a sum (product) that is shared is
/// written out in one of its users, a product of a sum that is a term becomes a sum of products.
/// Values stay the same, operations increase.
/// \param[in,out] network  normalised before, not afterwards
void expand_at_random(Network& network, Random& random, int count);

/// Runs one pass for each letter, f: factor sums, s: share pairs of sums, p: share pairs of
/// products. `seed` as in `factor_sums`.
/// \pre normalised, so is the result
Network run_passes(Network network, std::string_view order, std::uint64_t seed = 0);

/// Repeats `order` up to `rounds` times while it saves operations.
Network run_rounds(Network network, std::string_view order, int rounds);

/// The best of several orders, `rounds` times each.
Network run_all_orders(const Network& network, int rounds);

}  // namespace treedyn::optimise
