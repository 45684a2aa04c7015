#include "program/tape.hpp"

#include <cmath>

#include "common/error.hpp"
#include "common/index.hpp"

namespace treedyn::program {

Tape::Tape(const Function& function) {
  const Graph& graph = function.graph;
  std::vector<std::int32_t> place(graph.size(), 0);
  registers_.push_back(0);
  const auto at = [&](Ref a) {
    return place[to_index(a < 0 ? -a : a)];
  };
  for (const Ref k : reachable(graph, function.outputs)) {
    const Node& node = graph.node(k);
    const auto result = static_cast<std::int32_t>(registers_.size());
    place[to_index(k)] = result;
    registers_.push_back(0);
    switch (node.kind) {
      case Kind::kConstant:
        registers_.back() = static_cast<double>(graph.value(k));
        break;
      case Kind::kInput:
        loads_.push_back({result, node.a, node.b});
        break;
      case Kind::kAdd:
        instructions_.push_back(
            {node.b < 0 ? Operation::kSubtract : Operation::kAdd, result, at(node.a), at(node.b)});
        break;
      case Kind::kMultiply:
        instructions_.push_back({Operation::kMultiply, result, at(node.a), at(node.b)});
        break;
      case Kind::kDivide:
        instructions_.push_back({Operation::kDivide, result, at(node.a), at(node.b)});
        break;
      case Kind::kSin:
        instructions_.push_back({Operation::kSin, result, at(node.a), 0});
        break;
      case Kind::kCos:
        instructions_.push_back({Operation::kCos, result, at(node.a), 0});
        break;
      case Kind::kSqrt:
        instructions_.push_back(
            {node.a < 0 ? Operation::kSqrtOfNegative : Operation::kSqrt, result, at(node.a), 0});
        break;
    }
    TREEDYN_EXPECT(node.kind == Kind::kConstant || node.kind == Kind::kInput ||
                   node.kind == Kind::kSqrt || node.a > 0);
  }
  for (const Ref output : function.outputs) {
    results_.push_back(output < 0 ? -at(output) : at(output));
  }
}

void Tape::evaluate(std::span<const std::span<const double>> inputs, std::span<double> outputs) {
  double* const r = registers_.data();
  for (const Load& load : loads_) {
    r[load.result] = inputs[to_index(load.array)][to_index(load.element)];
  }
  for (const Instruction& i : instructions_) {
    switch (i.operation) {
      case Operation::kAdd:
        r[i.result] = r[i.a] + r[i.b];
        break;
      case Operation::kSubtract:
        r[i.result] = r[i.a] - r[i.b];
        break;
      case Operation::kMultiply:
        r[i.result] = r[i.a] * r[i.b];
        break;
      case Operation::kDivide:
        r[i.result] = r[i.a] / r[i.b];
        break;
      case Operation::kSin:
        r[i.result] = std::sin(r[i.a]);
        break;
      case Operation::kCos:
        r[i.result] = std::cos(r[i.a]);
        break;
      case Operation::kSqrt:
        r[i.result] = std::sqrt(r[i.a]);
        break;
      case Operation::kSqrtOfNegative:
        r[i.result] = std::sqrt(-r[i.a]);
        break;
    }
  }
  for (std::size_t k = 0; k < results_.size(); ++k) {
    outputs[k] = results_[k] < 0 ? -r[-results_[k]] : r[results_[k]];
  }
}

}  // namespace treedyn::program
