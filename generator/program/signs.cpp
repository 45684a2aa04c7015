#include "program/signs.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "program/copy.hpp"
#include "program/limb_code.hpp"

namespace treedyn::program {

namespace {

bool is_turned(const Graph& graph, Ref k) {
  return graph.node(k).kind == Kind::kConstant && graph.value(k).digits() < 0 &&
         graph.value(k).recipe() == 0;
}

/// The constant as another node of the same stand-in, with the opposite number.
Ref turned(const Graph& from, Ref k, Graph& to) {
  const Real value = from.value(k);
  return -to.constant(Real::seen_as(-value.digits(), value.seen()));
}

/// `to` gets the nodes of `from` that its outputs need.
void copy_positive(const Function& from, Function& to) {
  std::vector<Ref> copies(from.graph.size(), 0);
  for (const Ref k : reachable(from.graph, from.outputs)) {
    const std::size_t known = to.graph.size();
    const Ref copy = is_turned(from.graph, k) ? turned(from.graph, k, to.graph)
                                              : copy_node(from.graph, k, copies, to.graph);
    copies[static_cast<std::size_t>(k)] = copy;
    if (to.graph.size() > known) {
      to.graph.set_hint(copy, from.graph.hint(k));
      to.graph.set_hint(-copy, from.graph.hint(-k));
    }
  }
  std::ranges::transform(from.outputs, std::back_inserter(to.outputs),
                         [&](Ref output) { return copy_of(copies, output); });
}

std::shared_ptr<const LimbCode> with_positive_constants(const LimbCode& code) {
  LimbCode result = code;
  result.trunk = with_positive_constants(code.trunk);
  for (LimbPhase& phase : result.phases) {
    phase.function = with_positive_constants(phase.function);
  }
  return std::make_shared<const LimbCode>(std::move(result));
}

}  // namespace

Function with_positive_constants(const Function& function) {
  const std::vector<Ref> nodes = reachable(function.graph, function.outputs);
  Function result = function;
  if (std::ranges::any_of(nodes, [&](Ref k) { return is_turned(function.graph, k); })) {
    result.graph = Graph();
    result.outputs.clear();
    copy_positive(function, result);
  }
  if (function.limb_code) {
    result.limb_code = with_positive_constants(*function.limb_code);
  }
  return result;
}

}  // namespace treedyn::program
