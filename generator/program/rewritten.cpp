#include "program/rewritten.hpp"

#include "common/transformed.hpp"
#include "program/copy.hpp"

namespace treedyn::program {

Function rewritten(const Function& function, const std::vector<Ref>& outputs,
                   const std::function<std::optional<Ref>(Ref, Graph&)>& replaced) {
  const Graph& from = function.graph;
  Function result = function;
  result.graph = Graph();
  Graph& to = result.graph;
  std::vector<Ref> copies(from.size(), 0);
  for (const Ref k : reachable(from, outputs)) {
    const std::size_t known = to.size();
    const std::optional<Ref> other = replaced(k, to);
    const Ref copy = other ? *other : copy_node(from, k, copies, to);
    copies[node_index(k)] = copy;
    if (to.size() > known) {
      copy_hints(from, k, copy, to);
    }
  }
  result.outputs = transformed(outputs, [&](Ref output) { return copy_of(copies, output); });
  return result;
}

Function with_inputs(const Function& function, const std::vector<Ref>& outputs,
                     const std::function<Ref(const Node&, Graph&)>& input) {
  return rewritten(function, outputs, [&](Ref k, Graph& to) -> std::optional<Ref> {
    const Node& node = function.graph.node(k);
    return node.kind == Kind::kInput ? std::optional(input(node, to)) : std::nullopt;
  });
}

}  // namespace treedyn::program
