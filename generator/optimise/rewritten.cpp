#include "optimise/rewritten.hpp"

#include <algorithm>
#include <iterator>

namespace treedyn::optimise {

Function rewritten(const Function& function, const std::vector<Ref>& outputs,
                   const std::function<Ref(const Node&, Graph&)>& leaf) {
  const Graph& from = function.graph;
  Function result{function.signature, {}, {}};
  std::vector<Ref> copies(from.size(), 0);
  for (const Ref k : reachable(from, outputs)) {
    const Node& node = from.node(k);
    Ref& copy = copies[program::node_index(k)];
    copy = node.kind == Kind::kInput ? leaf(node, result.graph)
                                     : copy_node(from, k, copies, result.graph);
    if (copy != 0) {
      result.graph.set_hint(copy, from.hint(k));
      result.graph.set_hint(-copy, from.hint(-k));
    }
  }
  std::ranges::transform(outputs, std::back_inserter(result.outputs),
                         [&](Ref output) { return copy_of(copies, output); });
  return result;
}

}  // namespace treedyn::optimise
