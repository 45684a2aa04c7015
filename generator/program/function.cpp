#include "program/function.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <set>

#include "program/limb_code.hpp"

namespace treedyn::program {

namespace {

/// By kind of node.
constexpr std::array<int Cost::*, 8> kCountOf = {nullptr,    nullptr,    &Cost::add, &Cost::mul,
                                                 &Cost::div, &Cost::sin, &Cost::cos, &Cost::sqrt};

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
    const Node& node = graph.node(k);
    if (int Cost::*const count = kCountOf[static_cast<std::size_t>(node.kind)]; count != nullptr) {
      ++(result.*count);
    }
    if (node.kind == Kind::kSin || node.kind == Kind::kCos) {
      angles.insert(std::abs(node.a));
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

Cost operator+(const Cost& a, const Cost& b) { return by_count(a, b, std::plus()); }

Cost operator*(int times, const Cost& c) {
  return by_count(c, c, [times](int count, int) { return times * count; });
}

}  // namespace treedyn::program
