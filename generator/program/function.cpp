#include "program/function.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "program/limb_code.hpp"

namespace treedyn::program {

namespace {

/// Sums of `nodes` that take in a product of no other use.
int fused(const Graph& graph, const std::vector<Ref>& nodes, std::span<const Ref> outputs) {
  std::vector<int> uses(graph.size(), 0);
  const auto use = [&uses](Ref a) {
    ++uses[node_index(a)];
  };
  std::ranges::for_each(outputs, use);
  for (const Ref k : nodes) {
    for_each_operand(graph.node(k), use);
  }
  const auto takes_in = [&](Ref a) {
    return graph.node(a).kind == Kind::kMultiply && uses[node_index(a)] == 1;
  };
  return static_cast<int>(std::ranges::count_if(nodes, [&](Ref k) {
    const Node& node = graph.node(k);
    return node.kind == Kind::kAdd && (takes_in(node.a) || takes_in(node.b));
  }));
}

}  // namespace

bool has(const std::vector<Array>& arrays, std::string_view name) {
  return std::ranges::find(arrays, name, &Array::name) != arrays.end();
}

std::vector<Array> Signature::arrays() const {
  std::vector<Array> result = inputs;
  result.insert(result.end(), outputs.begin(), outputs.end());
  return result;
}

Cost cost(const Graph& graph, std::span<const Ref> outputs) {
  const std::vector<Ref> nodes = reachable(graph, outputs);
  Cost result;
  std::set<Ref> angles;
  result.fused = fused(graph, nodes, outputs);
  for (const Ref k : nodes) {
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
        angles.insert(std::abs(graph.node(k).a));
        break;
      case Kind::kCos:
        ++result.cos;
        angles.insert(std::abs(graph.node(k).a));
        break;
      case Kind::kSqrt:
        ++result.sqrt;
        break;
    }
  }
  result.angles = static_cast<int>(angles.size());
  result.twos = (result.angles + 1) / 2;
  result.fours = (result.angles + 3) / 4;
  return result;
}

Cost cost(const Function& function) {
  return function.limb_code ? cost(*function.limb_code) : cost(function.graph, function.outputs);
}

Cost operator+(const Cost& a, const Cost& b) {
  return {a.add + b.add,   a.mul + b.mul,    a.div + b.div,     a.sqrt + b.sqrt,
          a.sin + b.sin,   a.cos + b.cos,    a.fused + b.fused, a.angles + b.angles,
          a.twos + b.twos, a.fours + b.fours};
}

Cost operator*(int times, const Cost& c) {
  return {times * c.add, times * c.mul,   times * c.div,    times * c.sqrt, times * c.sin,
          times * c.cos, times * c.fused, times * c.angles, times * c.twos, times * c.fours};
}

}  // namespace treedyn::program
