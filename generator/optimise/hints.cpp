#include "optimise/hints.hpp"

#include <algorithm>
#include <cmath>

namespace treedyn::optimise {

namespace {

/// A node of the old function with its values at two points.
struct Known {
  double first = 0;
  double second = 0;
  Ref node = 0;
};

bool same(double a, double b) { return std::abs(a - b) <= 1e-11 * std::abs(b); }

bool is_named(const Graph& graph, Ref k) { return graph.hint(k).symbol != nullptr; }

/// The nodes of `function`, ascending by the magnitude of their first value.
std::vector<Known> known_values(const Function& function) {
  const auto first = fingerprint<double>(function.graph, function.outputs, 1);
  const auto second = fingerprint<double>(function.graph, function.outputs, 2);
  std::vector<Known> known;
  for (const Ref k : reachable(function.graph, function.outputs)) {
    const auto i = static_cast<std::size_t>(k);
    known.push_back({first[i], second[i], k});
  }
  std::ranges::sort(known, [](const Known& a, const Known& b) {
    const double x = std::abs(a.first);
    const double y = std::abs(b.first);
    return x != y ? x < y : a.node < b.node;
  });
  return known;
}

/// The node with the given values, a named one if possible, or one with the opposite values
/// (negative), or 0.
Ref find(const std::vector<Known>& known, const Graph& graph, double first, double second) {
  const double magnitude = std::abs(first);
  auto it = std::ranges::lower_bound(known, magnitude * (1 - 1e-11), {},
                                     [](const Known& k) { return std::abs(k.first); });
  Ref found = 0;
  for (; it != known.end() && std::abs(it->first) <= magnitude * (1 + 1e-11); ++it) {
    const bool equal = same(first, it->first) && same(second, it->second);
    const bool opposite = same(first, -it->first) && same(second, -it->second);
    if (equal && (found <= 0 || (!is_named(graph, found) && is_named(graph, it->node)))) {
      found = it->node;
    } else if (opposite && found == 0) {
      found = -it->node;
    }
  }
  return found;
}

/// The lowest node that uses each node; 0: none.
std::vector<Ref> first_users(const Function& function) {
  std::vector<Ref> user(function.graph.size(), 0);
  const std::vector<Ref> order = reachable(function.graph, function.outputs);
  std::for_each(order.rbegin(), order.rend(), [&](Ref k) {
    for_each_operand(function.graph.node(k), [&](Ref a) { user[program::node_index(a)] = k; });
  });
  return user;
}

}  // namespace

void transfer_hints(const Function& from, Function& to) {
  const std::vector<Known> known = known_values(from);
  const auto first = fingerprint<double>(to.graph, to.outputs, 1);
  const auto second = fingerprint<double>(to.graph, to.outputs, 2);
  const std::vector<Ref> user = first_users(to);
  const std::vector<Ref> order = reachable(to.graph, to.outputs);
  std::for_each(order.rbegin(), order.rend(), [&](Ref k) {
    const auto i = static_cast<std::size_t>(k);
    const Ref old = find(known, from.graph, first[i], second[i]);
    const int body = user[i] == 0 ? -1 : to.graph.hint(user[i]).body;
    for (const Ref sign : {1, -1}) {
      to.graph.set_hint(sign * k,
                        old != 0 ? from.graph.hint(sign * old) : Hint{nullptr, body, nullptr});
    }
  });
}

}  // namespace treedyn::optimise
