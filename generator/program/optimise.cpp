#include "program/optimise.hpp"

#include <string_view>
#include <utility>

#include "program/factor.hpp"
#include "program/hints.hpp"
#include "program/network.hpp"
#include "program/share.hpp"

namespace treedyn::program {

namespace {

/// f: factor sums, s: share pairs of sums, p: share pairs of products.
constexpr std::string_view kOrders[] = {"fsp", "sfp", "sp"};

Network pass(Network network, char name) {
  switch (name) {
    case 'f':
      factor_sums(network);
      break;
    case 's':
      share_pairs(network, Kind::kAdd);
      break;
    default:
      share_pairs(network, Kind::kMultiply);
  }
  return normalise(network);
}

/// The best network on the way.
Network run(Network network, std::string_view order, int rounds) {
  Network best = network;
  int fewest = operations(best);
  for (int round = 0; round < rounds; ++round) {
    for (const char name : order) {
      network = pass(std::move(network), name);
    }
    const int count = operations(network);
    if (count >= fewest) {
      break;
    }
    fewest = count;
    best = network;
  }
  return best;
}

}  // namespace

Function optimise(const Function& function, const Effort& effort) {
  const Network start = network_of(function.graph, function.outputs);
  Network best = start;
  for (const std::string_view order : kOrders) {
    Network next = run(start, order, effort.rounds);
    if (operations(next) < operations(best)) {
      best = std::move(next);
    }
  }
  Function result{function.signature, {}, {}};
  result.graph = graph_of(best, result.outputs);
  transfer_hints(function, result);
  return result;
}

int estimate_operations(const Graph& graph, std::span<const Ref> outputs) {
  return operations(run(network_of(graph, outputs), kOrders[0], 1));
}

}  // namespace treedyn::program
