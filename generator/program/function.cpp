#include "program/function.hpp"

#include <algorithm>
#include <cstdlib>

namespace treedyn::program {

Cost cost(const Graph& graph, std::span<const Ref> outputs) {
  Cost result;
  for (const Ref k : reachable(graph, outputs)) {
    switch (graph.node(k).kind) {
      case Kind::kConstant:
      case Kind::kInput:
        break;
      case Kind::kAdd:
        ++result.add;
        break;
      case Kind::kMultiply:
        ++result.mul;
        break;
      case Kind::kDivide:
        ++result.div;
        break;
      case Kind::kSin:
        ++result.sin;
        break;
      case Kind::kCos:
        ++result.cos;
        break;
      case Kind::kSqrt:
        ++result.sqrt;
        break;
    }
  }
  return result;
}

int fused(const Function& function) {
  const Graph& graph = function.graph;
  const std::vector<Ref> nodes = reachable(graph, function.outputs);
  std::vector<int> uses(graph.size(), 0);
  const auto use = [&uses](Ref a) {
    ++uses[static_cast<std::size_t>(std::abs(a))];
  };
  std::for_each(function.outputs.begin(), function.outputs.end(), use);
  for (const Ref k : nodes) {
    for_each_operand(graph.node(k), use);
  }
  const auto takes_in = [&](Ref a) {
    return graph.node(a).kind == Kind::kMultiply &&
           uses[static_cast<std::size_t>(std::abs(a))] == 1;
  };
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [&](Ref k) {
    const Node& node = graph.node(k);
    return node.kind == Kind::kAdd && (takes_in(node.a) || takes_in(node.b));
  }));
}

}  // namespace treedyn::program
