#include <algorithm>
#include <cstdlib>

#include "common/index.hpp"
#include "optimise/limb_sharing.hpp"
#include "program/rewritten.hpp"

namespace treedyn::optimise {

namespace {

/// Numbers of the kept elements from 0, -1 for the others.
std::vector<int> numbers(const std::vector<bool>& kept) {
  std::vector<int> result;
  int next = 0;
  for (const bool keep : kept) {
    result.push_back(keep ? next++ : -1);
  }
  return result;
}

class Pruner {
 public:
  explicit Pruner(LimbCode& code) : code_(code), first_limb_(code.arguments()) {
    find_numbers();
    find_needed();
  }

  void write() {
    write_trunk();
    write_phases();
    for (std::size_t c = 0; c < code_.values.size(); ++c) {
      std::vector<LimbCode::Value> kept;
      for (std::size_t e = 0; e < code_.values[c].size(); ++e) {
        if (needed_[c][e]) {
          kept.push_back(code_.values[c][e]);
        }
      }
      code_.values[c] = std::move(kept);
    }
  }

 private:
  void find_numbers();
  void find_needed();
  void need_of_trunk();
  void need_of(const LimbPhase& phase);
  void need(int c, int element) {
    needed_[to_index(c)][to_index(element)] = !number_[to_index(c)][to_index(element)];
  }
  void write_trunk();
  int keep_joint_values(std::size_t c, std::size_t& place, std::vector<Ref>& outputs) const;
  void write_phases();
  [[nodiscard]] int limb_class_of(int array) const;
  [[nodiscard]] std::vector<Ref> needed_outputs(const LimbPhase& phase) const;
  [[nodiscard]] std::size_t own_outputs() const {
    std::size_t limbs = 0;
    for (const LimbClass& limb_class : code_.limbs) {
      limbs += to_index(limb_class.size());
    }
    const auto& outputs = code_.trunk.signature.outputs;
    std::size_t result = 0;
    for (std::size_t k = 0; k + limbs + 1 < outputs.size(); ++k) {
      result += to_index(outputs[k].size);
    }
    return result;
  }
  [[nodiscard]] int trunk_values() const { return static_cast<int>(needed_trunk_.size()); }

  LimbCode& code_;
  int first_limb_;  ///< input array of the trunk with the values of the first limb
  std::vector<std::vector<std::optional<Real>>> number_;  ///< by class and value
  std::vector<std::vector<bool>> needed_;                 ///< by class and value
  std::vector<bool> needed_trunk_;                        ///< by value of the trunk
};

int Pruner::limb_class_of(int array) const {
  int first = first_limb_;
  int c = 0;
  while (array >= first + code_.limbs[to_index(c)].size()) {
    first += code_.limbs[to_index(c)].size();
    ++c;
  }
  return c;
}

/// Values of which the phase's output is a number, the same in all limbs.
void Pruner::find_numbers() {
  for (const auto& values : code_.values) {
    number_.emplace_back(values.size());
    needed_.emplace_back(values.size(), false);
  }
  for (const LimbPhase& phase : code_.phases) {
    const auto c = to_index(phase.limb_class);
    for (std::size_t e = 0; e < number_[c].size(); ++e) {
      const Ref output = phase.function.outputs[e];
      const Graph& graph = phase.function.graph;
      const bool own = code_.values[c][e].stage == phase.stage;
      if (own && output == 0) {
        number_[c][e] = Real(0);
      } else if (own && graph.node(output).kind == Kind::kConstant) {
        const Real& value = graph.value(std::abs(output));
        number_[c][e] = output < 0 ? Real(-value) : value;
      }
    }
  }
  const std::size_t limbs = code_.trunk.signature.inputs.size() - to_index(first_limb_);
  const auto& outputs = code_.trunk.signature.outputs;
  needed_trunk_.assign(to_index(outputs[outputs.size() - limbs - 1].size), false);
}

std::vector<Ref> Pruner::needed_outputs(const LimbPhase& phase) const {
  const auto c = to_index(phase.limb_class);
  std::vector<Ref> result;
  for (std::size_t e = 0; e < needed_[c].size(); ++e) {
    if (needed_[c][e] && code_.values[c][e].stage == phase.stage) {
      result.push_back(phase.function.outputs[e]);
    }
  }
  return result;
}

void Pruner::need_of_trunk() {
  const auto own = static_cast<std::ptrdiff_t>(own_outputs());
  std::vector<Ref> outputs(code_.trunk.outputs.begin(), code_.trunk.outputs.begin() + own);
  for (int k = 0; k < trunk_values(); ++k) {
    if (needed_trunk_[to_index(k)]) {
      outputs.push_back(code_.trunk.outputs[to_index(k) + to_index(static_cast<int>(own))]);
    }
  }
  for (const Ref k : reachable(code_.trunk.graph, outputs)) {
    const Node& node = code_.trunk.graph.node(k);
    if (node.kind == Kind::kInput && node.a >= first_limb_) {
      need(limb_class_of(node.a), node.b);
    }
  }
}

void Pruner::need_of(const LimbPhase& phase) {
  for (const Ref k : reachable(phase.function.graph, needed_outputs(phase))) {
    const Node& node = phase.function.graph.node(k);
    if (node.kind != Kind::kInput || node.a >= kFixedArrays) {
      continue;
    }
    if (phase.function.signature.inputs[to_index(node.a)].name == kLimbValues) {
      need(phase.limb_class, node.b);
    } else {
      needed_trunk_[to_index(node.b)] = true;
    }
  }
}

/// From the function's outputs backwards, until nothing more is needed.
void Pruner::find_needed() {
  for (bool changed = true; changed;) {
    const auto before = std::pair(needed_, needed_trunk_);
    need_of_trunk();
    for (auto phase = code_.phases.rbegin(); phase != code_.phases.rend(); ++phase) {
      need_of(*phase);
    }
    changed = before != std::pair(needed_, needed_trunk_);
  }
}

/// Appends the needed ones of a limb of class c, which start at `place`; steps behind them all.
/// \return  how many it appended
int Pruner::keep_joint_values(std::size_t c, std::size_t& place, std::vector<Ref>& outputs) const {
  int kept = 0;
  for (std::size_t e = 0; e < needed_[c].size() && code_.values[c][e].stage < 0; ++e, ++place) {
    if (needed_[c][e]) {
      outputs.push_back(code_.trunk.outputs[place]);
      ++kept;
    }
  }
  return kept;
}

void Pruner::write_trunk() {
  std::size_t place = own_outputs();
  std::vector<Ref> outputs(code_.trunk.outputs.begin(),
                           code_.trunk.outputs.begin() + static_cast<std::ptrdiff_t>(place));
  for (const bool keep : needed_trunk_) {
    if (keep) {
      outputs.push_back(code_.trunk.outputs[place]);
    }
    ++place;
  }
  std::vector<int> given;  // joint values by limb
  for (std::size_t c = 0; c < code_.limbs.size(); ++c) {
    for (int limb = 0; limb < code_.limbs[c].size(); ++limb) {
      given.push_back(keep_joint_values(c, place, outputs));
    }
  }
  code_.trunk = with_inputs(code_.trunk, outputs, [&](const Node& node, Graph& to) {
    if (node.a < first_limb_) {
      return to.input(node.a, node.b);
    }
    const auto c = to_index(limb_class_of(node.a));
    const std::optional<Real>& number = number_[c][to_index(node.b)];
    return number ? to.constant(*number) : to.input(node.a, numbers(needed_[c])[to_index(node.b)]);
  });
  auto& signature = code_.trunk.signature;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const int c = limb_class_of(first_limb_ + static_cast<int>(k));
    signature.inputs[to_index(first_limb_) + k].size =
        static_cast<int>(std::ranges::count(needed_[to_index(c)], true));
    signature.outputs[signature.outputs.size() - given.size() + k].size = given[k];
  }
  signature.outputs[signature.outputs.size() - given.size() - 1].size =
      static_cast<int>(std::ranges::count(needed_trunk_, true));
}

void Pruner::write_phases() {
  std::erase_if(code_.phases,
                [&](const LimbPhase& phase) { return needed_outputs(phase).empty(); });
  const std::vector<int> trunk = numbers(needed_trunk_);
  for (LimbPhase& phase : code_.phases) {
    const auto c = to_index(phase.limb_class);
    const std::vector<int> limb = numbers(needed_[c]);
    const int size = static_cast<int>(std::ranges::count(needed_[c], true));
    std::vector<Ref> outputs;
    for (std::size_t e = 0; e < needed_[c].size(); ++e) {
      if (needed_[c][e]) {
        outputs.push_back(phase.function.outputs[e]);
      }
    }
    auto& inputs = phase.function.signature.inputs;
    const auto array = static_cast<int>(
        std::ranges::find(inputs, std::string(kLimbValues), &Array::name) - inputs.begin());
    phase.function = with_inputs(phase.function, outputs, [&](const Node& node, Graph& to) {
      if (node.a >= kFixedArrays) {
        return to.input(node.a, node.b);
      }
      if (node.a != array) {
        return to.input(node.a, trunk[to_index(node.b)]);
      }
      const std::optional<Real>& number = number_[c][to_index(node.b)];
      return number ? to.constant(*number) : to.input(node.a, limb[to_index(node.b)]);
    });
    phase.function.signature.inputs[to_index(array)].size = size;
    phase.function.signature.outputs.front().size = size;
    for (Array& input : phase.function.signature.inputs) {
      if (input.name == kTrunkValues) {
        input.size = static_cast<int>(std::ranges::count(needed_trunk_, true));
      }
    }
  }
}

}  // namespace

void prune(LimbCode& code) { Pruner(code).write(); }

}  // namespace treedyn::optimise
