#include "optimise/passes.hpp"

#include <utility>

namespace treedyn::optimise {

namespace {

int run_pass(Network& network, char pass, std::uint64_t seed) {
  switch (pass) {
    case 'f':
      return factor_sums(network, seed);
    case 's':
      return share_pairs(network, Kind::kAdd, seed);
    default:
      return share_pairs(network, Kind::kMultiply, seed);
  }
}

}  // namespace

Network run_passes(Network network, std::string_view order, std::uint64_t seed) {
  for (const char pass : order) {
    if (run_pass(network, pass, seed) > 0) {
      network = normalise(network);
    }
  }
  return network;
}

Network run_rounds(Network network, std::string_view order, int rounds) {
  int fewest = operations(network);
  for (int round = 0; round < rounds; ++round) {
    Network next = run_passes(network, order);
    const int count = operations(next);
    if (count >= fewest) {
      break;
    }
    fewest = count;
    network = std::move(next);
  }
  return network;
}

Network run_all_orders(const Network& network, int rounds) {
  Network best = network;
  for (const std::string_view order : {"fsp", "sfp", "sp"}) {
    Network next = run_rounds(network, order, rounds);
    if (operations(next) < operations(best)) {
      best = std::move(next);
    }
  }
  return best;
}

}  // namespace treedyn::optimise
