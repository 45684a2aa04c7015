// Sequences of passes.
#pragma once

#include <cstdint>
#include <string_view>

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// Runs one pass for each letter, f: factor sums, s: share pairs of sums, p: share pairs of
/// products. `seed` as in `factor_sums`.
/// \pre normalised, so is the result
Network run_passes(Network network, std::string_view order, std::uint64_t seed = 0);

/// Repeats `order` up to `rounds` times while it saves operations.
Network run_rounds(Network network, std::string_view order, int rounds);

/// The best of several orders, `rounds` times each.
Network run_all_orders(const Network& network, int rounds);

}  // namespace treedyn::optimise
