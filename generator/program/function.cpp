#include "program/function.hpp"

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

}  // namespace treedyn::program
