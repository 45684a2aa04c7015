// Shared code of limbs as a function without it.
#include <utility>

#include "common/index.hpp"
#include "program/copy.hpp"
#include "program/limb_code.hpp"

namespace treedyn::program {

namespace {

constexpr int kTrunkArray = 0;
constexpr int kLimbArray = 2;

/// Evaluates trunk and phases in a graph without limbs.
class Flattener {
 public:
  Flattener(const LimbCode& code, Graph& to)
      : code_(code),
        to_(to),
        copies_(code.trunk.graph.size(), 0),
        done_(code.trunk.graph.size(), false) {
    arguments_ = code.arguments();
    values_.resize(code.trunk.signature.inputs.size() - to_index(arguments_));
    for (std::size_t limb = 0; limb < values_.size(); ++limb) {
      values_[limb].resize(to_index(code.trunk.signature.inputs[to_index(arguments_) + limb].size));
    }
    copy_trunk(0);
    for (const LimbPhase& phase : code.phases) {
      copy_trunk(phase.stage);
      run(phase);
    }
    copy_trunk(code.phases.back().stage + 1);
  }

  [[nodiscard]] Ref output(std::size_t k) const { return copy_of(copies_, code_.trunk.outputs[k]); }

 private:
  /// Copies what is known when the stages before `stage` are over.
  void copy_trunk(int stage) {
    const Graph& from = code_.trunk.graph;
    for (const Ref k : reachable(from, code_.trunk.outputs)) {
      const Node& node = from.node(k);
      bool known = !done_[node_index(k)];
      for_each_operand(node, [&](Ref operand) { known &= done_[node_index(operand)]; });
      const bool of_limb = node.kind == Kind::kInput && node.a >= arguments_;
      if (!known || (of_limb && code_.level(node.a, node.b) > stage)) {
        continue;
      }
      done_[node_index(k)] = true;
      copies_[node_index(k)] = of_limb ? values_[to_index(node.a - arguments_)][to_index(node.b)]
                                       : copy_node(from, k, copies_, to_);
    }
  }

  void run(const LimbPhase& phase) {
    int first = 0;
    for (int c = 0; c < phase.limb_class; ++c) {
      first += code_.limbs[to_index(c)].size();
    }
    for (int limb = 0; limb < code_.limbs[to_index(phase.limb_class)].size(); ++limb) {
      run(phase, limb, first + limb);
    }
  }

  /// Places in the outputs of the trunk: the trunk's values, then those of limb after limb.
  [[nodiscard]] std::size_t first_output(int array) const {
    std::size_t place = 0;
    for (int k = 0; k < array; ++k) {
      place += to_index(code_.trunk.signature.outputs[to_index(k)].size);
    }
    return place;
  }

  void run(const LimbPhase& phase, int limb, int number) {
    const int trunk_array =
        static_cast<int>(code_.trunk.signature.outputs.size() - values_.size()) - 1;
    std::vector<Ref>& values = values_[to_index(number)];
    const std::size_t given = first_output(trunk_array + 1 + number);
    const std::size_t from_trunk = first_output(trunk_array);
    const int joints = code_.trunk.signature.outputs[to_index(trunk_array + 1 + number)].size;
    for (int k = 0; k < joints; ++k) {
      values[to_index(k)] = output(given + to_index(k));
    }
    const Graph& from = phase.function.graph;
    std::vector<Ref> copies(from.size(), 0);
    for (const Ref k : reachable(from, phase.function.outputs)) {
      const Node& node = from.node(k);
      if (node.kind != Kind::kInput) {
        copies[node_index(k)] = copy_node(from, k, copies, to_);
      } else if (node.a == kTrunkArray) {
        copies[node_index(k)] = output(from_trunk + to_index(node.b));
      } else if (node.a == kLimbArray) {
        copies[node_index(k)] = values[to_index(node.b)];
      } else {
        const LimbClass& limb_class = code_.limbs[to_index(phase.limb_class)];
        copies[node_index(k)] = to_.constant(limb_class.columns[to_index(node.b)][to_index(limb)]);
      }
    }
    for (std::size_t e = 0; e < values.size(); ++e) {
      values[e] = copy_of(copies, phase.function.outputs[e]);
    }
  }

  const LimbCode& code_;
  Graph& to_;
  int arguments_ = 0;
  std::vector<Ref> copies_;
  std::vector<bool> done_;
  std::vector<std::vector<Ref>> values_;  ///< by limb
};

}  // namespace

Function flat(std::shared_ptr<const LimbCode> code, const Signature& signature) {
  Function result{signature, {}, {}};
  const Flattener flattener(*code, result.graph);
  std::size_t outputs = 0;
  for (const Array& array : signature.outputs) {
    outputs += to_index(array.size);
  }
  for (std::size_t k = 0; k < outputs; ++k) {
    result.outputs.push_back(flattener.output(k));
  }
  result.limb_code = std::move(code);
  return result;
}

int LimbCode::arguments() const {
  auto result = static_cast<int>(trunk.signature.inputs.size());
  for (const LimbClass& limb_class : limbs) {
    result -= limb_class.size();
  }
  return result;
}

int LimbCode::level(int array, int element) const {
  int first = arguments();
  for (std::size_t c = 0; c < limbs.size(); ++c) {
    if (array >= first && array < first + limbs[c].size()) {
      return values[c][to_index(element)].stage + 1;
    }
    first += limbs[c].size();
  }
  return 0;
}

Cost cost(const LimbCode& code) {
  Cost result = cost(code.trunk.graph, code.trunk.outputs);
  for (const LimbPhase& phase : code.phases) {
    result = result + code.limbs[to_index(phase.limb_class)].size() *
                          cost(phase.function.graph, phase.function.outputs);
  }
  return result;
}

}  // namespace treedyn::program
