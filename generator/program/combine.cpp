#include "program/combine.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace treedyn::program {

namespace {

/// For every input array of a function its place in `inputs`, -1 if it is not there.
std::vector<int> places_of(const Signature& signature, const std::vector<Array>& inputs) {
  std::vector<int> places;
  for (const Array& array : signature.inputs) {
    const auto found = std::find_if(inputs.begin(), inputs.end(),
                                    [&](const Array& a) { return a.name == array.name; });
    TREEDYN_EXPECT(found == inputs.end() || found->size == array.size);
    places.push_back(found == inputs.end() ? -1 : static_cast<int>(found - inputs.begin()));
  }
  return places;
}

Ref copy_node(const Graph& from, Ref k, const std::vector<int>& places,
              const std::vector<Ref>& copies, Graph& to) {
  const Node& node = from.node(k);
  const auto copy = [&](Ref a) {
    const Ref positive = copies[static_cast<std::size_t>(a < 0 ? -a : a)];
    return a < 0 ? -positive : positive;
  };
  switch (node.kind) {
    case Kind::kConstant:
      return to.constant(from.value(k));
    case Kind::kInput: {
      const int place = places[static_cast<std::size_t>(node.a)];
      return place < 0 ? 0 : to.input(place, node.b);
    }
    case Kind::kAdd:
      return to.add(copy(node.a), copy(node.b));
    case Kind::kMultiply:
      return to.multiply(copy(node.a), copy(node.b));
    case Kind::kDivide:
      return to.divide(copy(node.a), copy(node.b));
    case Kind::kSin:
      return to.sin(copy(node.a));
    case Kind::kCos:
      return to.cos(copy(node.a));
    case Kind::kSqrt:
      return to.sqrt(copy(node.a));
  }
  return 0;
}

}  // namespace

Function combine(std::span<const Function> functions, const std::vector<Array>& inputs) {
  Function result;
  result.signature.inputs = inputs;
  for (const Function& function : functions) {
    const std::vector<int> places = places_of(function.signature, inputs);
    std::vector<Ref> copies(function.graph.size(), 0);
    for (const Ref k : reachable(function.graph, function.outputs)) {
      copies[static_cast<std::size_t>(k)] =
          copy_node(function.graph, k, places, copies, result.graph);
    }
    for (const Ref output : function.outputs) {
      const Ref copy = copies[static_cast<std::size_t>(output < 0 ? -output : output)];
      result.outputs.push_back(output < 0 ? -copy : copy);
    }
    const auto& outputs = function.signature.outputs;
    result.signature.outputs.insert(result.signature.outputs.end(), outputs.begin(), outputs.end());
  }
  return result;
}

}  // namespace treedyn::program
