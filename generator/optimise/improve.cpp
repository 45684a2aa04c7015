#include "optimise/improve.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "optimise/passes.hpp"
#include "optimise/window.hpp"

namespace treedyn::optimise {

namespace {

constexpr std::array<std::string_view, 5> kOrders = {"fsp", "sfp", "sp", "fps", "psf"};
constexpr int kMostExpansions = 4;
constexpr int kWindow = 80;
constexpr int kMovesPerWindow = 20;
/// In a function of few operations more moves find nothing.
constexpr int kMovesPerOperation = 20;

/// \param guard  null: of a window, which is held to the rounding of the whole
Network improve_whole(Network network, int moves, const RoundingGuard* guard, Random& random) {
  int fewest = operations(network);
  Network apart = network;
  for (int move = 0; move < moves; ++move) {
    apart = network;
    expand_at_random(apart, random, 1 + random.below(kMostExpansions));
    const auto order = static_cast<std::size_t>(random.below(static_cast<int>(kOrders.size())));
    Network next = run_passes(normalise(apart), kOrders[order], random.next() | 1U);
    const int count = operations(next);
    if (count <= fewest && (guard == nullptr || guard->accepts(next))) {
      fewest = count;
      network = std::move(next);
    }
  }
  return network;
}

Network improve_window(const Network& network, int moves, const RoundingGuard& guard,
                       Random& random) {
  Window window = cut_window(network, random_neighbourhood(network, random, kWindow));
  window.network = improve_whole(std::move(window.network), moves, nullptr, random);
  Network next = with_window(network, window);
  return guard.accepts(next) ? next : network;
}

}  // namespace

Network improve(Network network, int moves, const RoundingGuard& guard, std::uint64_t seed) {
  Random random(seed);
  moves = std::min(moves, kMovesPerOperation * operations(network));
  for (int left = moves; left > 0; left -= kMovesPerWindow) {
    const int now = std::min(left, kMovesPerWindow);
    const int count = operations(network);
    if (count == 0) {
      break;
    }
    network = count <= kWindow ? improve_whole(std::move(network), now, &guard, random)
                               : improve_window(network, now, guard, random);
  }
  return network;
}

}  // namespace treedyn::optimise
