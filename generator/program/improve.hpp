// Local search over equivalent networks.
#pragma once

#include <cstdint>

#include "program/network.hpp"

namespace treedyn::program {

/// Takes a few expressions apart (`expand_at_random`), puts them together again (`factor_sums`,
/// `share_pairs` with random ties), and keeps what is not worse, `moves` times. Deterministic; a
/// move costs O(n log n).
/// \pre normalised, so is the result
Network improve(Network network, int moves, std::uint64_t seed = 1);

}  // namespace treedyn::program
