#include "program/combine.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "program/copy.hpp"

namespace treedyn::program {

namespace {

/// For every input array of a function its place in `inputs`, -1 if it is not there.
std::vector<int> places_of(const Signature& signature, const std::vector<Array>& inputs) {
  std::vector<int> places;
  for (const Array& array : signature.inputs) {
    const auto found = std::ranges::find(inputs, array.name, &Array::name);
    TREEDYN_EXPECT(found == inputs.end() || found->size == array.size);
    places.push_back(found == inputs.end() ? -1 : static_cast<int>(found - inputs.begin()));
  }
  return places;
}

}  // namespace

Function combine(std::span<const Function> functions, const std::vector<Array>& inputs) {
  Function result;
  result.signature.inputs = inputs;
  for (const Function& function : functions) {
    const std::vector<int> places = places_of(function.signature, inputs);
    std::vector<Ref> copies(function.graph.size(), 0);
    for (const Ref k : reachable(function.graph, function.outputs)) {
      const Node& node = function.graph.node(k);
      Ref& copy = copies[static_cast<std::size_t>(k)];
      if (node.kind == Kind::kInput) {
        const int place = places[static_cast<std::size_t>(node.a)];
        copy = place < 0 ? 0 : result.graph.input(place, node.b);
      } else {
        copy = copy_node(function.graph, k, copies, result.graph);
      }
    }
    for (const Ref output : function.outputs) {
      result.outputs.push_back(copy_of(copies, output));
    }
    const auto& outputs = function.signature.outputs;
    result.signature.outputs.insert(result.signature.outputs.end(), outputs.begin(), outputs.end());
  }
  return result;
}

}  // namespace treedyn::program
