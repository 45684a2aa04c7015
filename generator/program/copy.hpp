// Nodes from one graph into another.
#pragma once

#include <span>

#include "program/graph.hpp"

namespace treedyn::program {

/// The copy of a value, given the copies of all nodes.
inline Ref copy_of(std::span<const Ref> copies, Ref a) {
  return a < 0 ? -copies[static_cast<std::size_t>(-a)] : copies[static_cast<std::size_t>(a)];
}

/// Makes node `k` of `from` in `to` and returns its value there.
/// \param copies  of the node's operands, by node number
Ref copy_node(const Graph& from, Ref k, std::span<const Ref> copies, Graph& to);

/// Gives the names of node `k` of `from`, and of its negative, to a value of `to`.
inline void copy_hints(const Graph& from, Ref k, Ref copy, Graph& to) {
  to.set_hint(copy, from.hint(k));
  to.set_hint(-copy, from.hint(-k));
}

}  // namespace treedyn::program
