// Local search over equivalent networks.
#pragma once

#include <cstdint>

#include "optimise/network.hpp"
#include "optimise/rounding_guard.hpp"

namespace treedyn::optimise {

/// Takes a few expressions apart (`expand_at_random`), puts them together again (`factor_sums`,
/// `share_pairs` with random ties), and keeps what is not worse, `moves` times. Deterministic.
///
/// In large networks the moves are made in windows of some eighty operations, twenty at a time, so
/// a move costs microseconds, and O(n) once for each window. What `guard` does not accept is not
/// kept.
/// \pre normalised, so is the result
Network improve(Network network, int moves, const RoundingGuard& guard, std::uint64_t seed = 1);

}  // namespace treedyn::optimise
