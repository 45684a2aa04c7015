#include "program/function.hpp"

#include "program/limb_code.hpp"

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

Cost cost(const Function& function) {
  return function.limb_code ? cost(*function.limb_code) : cost(function.graph, function.outputs);
}

Cost operator+(const Cost& a, const Cost& b) {
  return {a.add + b.add,   a.mul + b.mul, a.div + b.div,
          a.sqrt + b.sqrt, a.sin + b.sin, a.cos + b.cos};
}

Cost operator*(int times, const Cost& c) {
  return {times * c.add,  times * c.mul, times * c.div,
          times * c.sqrt, times * c.sin, times * c.cos};
}

}  // namespace treedyn::program
