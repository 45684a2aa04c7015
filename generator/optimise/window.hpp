// A part of a network as a network of its own.
#pragma once

#include <span>
#include <vector>

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// `network` computes what the rest of the whole needs of some items, from what they need of the
/// rest: these values are its inputs, array -1, element = item of the whole.
struct Window {
  Network network;
  std::vector<int> results;  ///< items of the whole, as many as outputs of `network`
};

/// About `size` sums, products and quotients around a random one, connected by use. O(n).
/// \pre the network has at least one
std::vector<int> random_neighbourhood(const Network& network, Random& random, int size);

/// \param items  ascending, none a constant or an input
Window cut_window(const Network& network, std::span<const int> items);

/// Puts an equivalent form of the window in place of the items it was cut from. O(n).
/// \pre no output of `window.network` depends on an input that it did not depend on before: so
/// there can be no cycle
Network with_window(Network network, const Window& window);

}  // namespace treedyn::optimise
