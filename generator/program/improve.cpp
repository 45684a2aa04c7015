#include "program/improve.hpp"

#include <string_view>
#include <utility>

#include "program/expand.hpp"
#include "program/passes.hpp"
#include "program/random.hpp"

namespace treedyn::program {

namespace {

constexpr std::string_view kOrders[] = {"fsp", "sfp", "sp", "fps", "psf"};
constexpr int kMostExpansions = 4;

}  // namespace

Network improve(Network network, int moves, std::uint64_t seed) {
  Random random(seed);
  int fewest = operations(network);
  for (int move = 0; move < moves; ++move) {
    Network next = network;
    expand_at_random(next, random, 1 + random.below(kMostExpansions));
    const std::string_view order = kOrders[random.below(static_cast<int>(std::size(kOrders)))];
    next = run_passes(normalise(next), order, random.next() | 1U);
    const int count = operations(next);
    if (count <= fewest) {
      fewest = count;
      network = std::move(next);
    }
  }
  return network;
}

}  // namespace treedyn::program
