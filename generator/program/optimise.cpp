#include "program/optimise.hpp"

#include "program/hints.hpp"
#include "program/improve.hpp"
#include "program/passes.hpp"

namespace treedyn::program {

Function optimise(const Function& function, const Effort& effort) {
  const Network start = network_of(function.graph, function.outputs);
  const Network best = improve(run_all_orders(start, effort.rounds), effort.moves);
  Function result{function.signature, {}, {}};
  result.graph = graph_of(best, result.outputs);
  transfer_hints(function, result);
  return result;
}

int estimate_operations(const Graph& graph, std::span<const Ref> outputs) {
  return operations(run_rounds(network_of(graph, outputs), "fsp", 1));
}

}  // namespace treedyn::program
