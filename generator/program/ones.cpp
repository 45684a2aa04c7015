#include "program/ones.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "program/limb_code.hpp"
#include "program/rewritten.hpp"

namespace treedyn::program {

namespace {

/// A constant that is not 1 but counts as it.
bool is_other_one(const Graph& graph, Ref k, const IsOne& is_one) {
  return graph.node(k).kind == Kind::kConstant && graph.value(k) != 1 &&
         graph.value(k).recipe() == 0 && is_one(graph.value(k));
}

std::shared_ptr<const LimbCode> without_ones(const LimbCode& code, const IsOne& is_one) {
  LimbCode result = code;
  result.trunk = without_ones(code.trunk, is_one);
  for (LimbPhase& phase : result.phases) {
    phase.function = without_ones(phase.function, is_one);
  }
  return std::make_shared<const LimbCode>(std::move(result));
}

const Staged* find(const std::vector<Staged>& functions, const std::string& name) {
  const auto found = std::ranges::find_if(
      functions, [&](const Staged& staged) { return staged.signature.name == name; });
  return found == functions.end() ? nullptr : &*found;
}

}  // namespace

Function without_ones(const Function& function, const IsOne& is_one) {
  const std::vector<Ref> nodes = reachable(function.graph, function.outputs);
  const bool has_some =
      std::ranges::any_of(nodes, [&](Ref k) { return is_other_one(function.graph, k, is_one); });
  Function result = function;
  if (has_some) {
    result = rewritten(function, function.outputs, [&](Ref k, Graph& to) {
      return is_other_one(function.graph, k, is_one) ? std::optional(to.constant(Real(1)))
                                                     : std::nullopt;
    });
  }
  if (function.limb_code) {
    result.limb_code = without_ones(*function.limb_code, is_one);
  }
  return result;
}

Staged without_ones(Staged staged, const IsOne& is_one) {
  staged.function = without_ones(staged.function, is_one);
  for (Staged& contact : staged.contacts) {
    contact = without_ones(std::move(contact), is_one);
  }
  return staged;
}

Stepper without_ones(Stepper stepper, const std::vector<Staged>& functions, const IsOne& is_one) {
  const auto clean = [&](std::vector<Staged>& list) {
    for (Staged& staged : list) {
      staged = without_ones(std::move(staged), is_one);
    }
  };
  const auto count = [&](StepOutcome& outcome) {
    if (const Staged* const impact = find(functions, outcome.impact)) {
      outcome.impact_cost = worst_cost(*impact);
    }
  };
  clean(stepper.anchors);
  for (StepPhase& phase : stepper.phases) {
    clean(phase.guards);
    clean(phase.approaches);
    if (const Staged* const dynamics = find(functions, phase.dynamics)) {
      set_costs(phase, *dynamics);
    }
    for (StepEvent& event : phase.events) {
      count(event.outcome);
      if (event.rest) {
        count(*event.rest);
      }
    }
  }
  return stepper;
}

}  // namespace treedyn::program
