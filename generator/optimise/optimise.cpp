#include "optimise/optimise.hpp"

#include <utility>

#include "optimise/hints.hpp"
#include "optimise/improve.hpp"
#include "optimise/passes.hpp"
#include "optimise/resubstitute.hpp"
#include "optimise/rounding_guard.hpp"

namespace treedyn::optimise {

namespace {

/// The local search is interrupted so often to look for equal values.
constexpr int kParts = 4;

/// `resubstitute` until it saves nothing more.
Network resubstituted(Network network, const RoundingGuard& guard, Quotients quotients) {
  for (int fewest = operations(network);;) {
    Network next = network;
    if (resubstitute(next, quotients) == 0) {
      return network;
    }
    next = run_all_orders(normalise(next), 1);
    if (operations(next) >= fewest || !guard.accepts(next)) {
      return network;
    }
    fewest = operations(next);
    network = std::move(next);
  }
}

}  // namespace

Function optimised(const Function& function, const Effort& effort) {
  const Network start = network_of(function.graph, function.outputs);
  const RoundingGuard guard(start);
  Network best = run_all_orders(start, effort.rounds);
  best = resubstituted(guard.accepts(best) ? best : start, guard, effort.quotients);
  for (int part = 0; part < kParts && effort.moves > 0; ++part) {
    const auto seed = static_cast<std::uint64_t>(effort.seed * kParts + part + 1);
    best = resubstituted(improve(std::move(best), effort.moves / kParts, guard, seed), guard,
                         effort.quotients);
  }
  Function result{function.signature, {}, {}};
  result.graph = graph_of(best, result.outputs);
  transfer_hints(function, result);
  return result;
}

int estimate_operations(const Graph& graph, std::span<const Ref> outputs) {
  return operations(run_rounds(network_of(graph, outputs), "fsp", 1));
}

}  // namespace treedyn::optimise
