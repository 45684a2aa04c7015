// Fewer operations for the same values.
#pragma once

#include "optimise/program_names.hpp"
#include "optimise/resubstitute.hpp"

namespace treedyn::optimise {

/// How hard `optimised` tries.
struct Effort {
  int rounds = 3;  ///< repetitions of each order of the passes
  int moves = 0;   ///< steps of the local search that follows; some 10,000 a second
  int seed = 0;    ///< of these steps
  Quotients quotients = Quotients::kAnywhere;
};

/// An equivalent function with at most as many operations (add + mul + div, sin, cos, sqrt).
///
/// Sums and products are taken apart and put together again, see network.hpp: factored
/// (`factor_sums`) and shared (`share_pairs`) in the order of the passes that pays most; then
/// values that are had more cheaply from others (`resubstitute`); then a local search (`improve`).
/// Values that survive keep their names; nodes are numbered near the original order. The result
/// depends on the arguments alone. Without moves 300 operations take milliseconds, 3000 a second,
/// more grow as O(n log n).
Function optimised(const Function& function, const Effort& effort = {});

/// Whether values that are had from others are looked for.
enum class Values { kShared, kAll };

/// The number of operations that one round of passes reaches. Of shared factors and terms alone:
/// cheap enough for the inner loop of a search over formulations, and not less than what
/// `optimised` reaches.
int estimate_operations(const Graph& graph, std::span<const Ref> outputs,
                        Values values = Values::kShared);

}  // namespace treedyn::optimise
