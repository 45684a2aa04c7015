#include "optimise/optimise.hpp"

#include <array>
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

/// Factors by which values may lose accuracy: the next one where an output would lose too much.
constexpr std::array kAmplifications = {kMostAmplification, 4.0, 2.0, 1.0};

/// `resubstitute` until it saves nothing more.
Network resubstituted(Network network, const RoundingGuard& guard, Quotients quotients) {
  std::size_t careful = 0;
  for (int fewest = operations(network); careful < kAmplifications.size();) {
    Network next = network;
    if (resubstitute(next, quotients, kAmplifications[careful]) == 0) {
      break;
    }
    next = run_all_orders(normalise(next), 1);
    if (operations(next) >= fewest) {
      break;
    }
    if (guard.accepts(next)) {
      fewest = operations(next);
      network = std::move(next);
    } else {
      ++careful;
    }
  }
  return network;
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

int estimate_operations(const Graph& graph, std::span<const Ref> outputs, Values values) {
  Network network = run_rounds(network_of(graph, outputs), "fsp", 1);
  if (values == Values::kAll) {
    resubstitute(network, Quotients::kAnywhere, kMostAmplification);
    network = run_rounds(normalise(network), "fsp", 1);
  }
  return operations(network);
}

}  // namespace treedyn::optimise
