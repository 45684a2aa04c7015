#include "program/stepper.hpp"

#include <algorithm>

namespace treedyn::program {

namespace {

bool takes_time(const Staged& staged) {
  const std::vector<Array>& inputs = staged.signature.inputs;
  return std::any_of(inputs.begin(), inputs.end(),
                     [](const Array& array) { return array.name == "t"; });
}

Cost of_all(const std::vector<Staged>& functions) {
  Cost sum;
  for (const Staged& function : functions) {
    sum = sum + cost(function);
  }
  return sum;
}

/// M of a stage by differences, and its factors.
Cost factor_cost(int n, const Cost& dynamics) {
  Cost sum = (n + 1) * dynamics + Cost{.add = 2 * n, .mul = 2 * n};
  sum = sum + n * Cost{.add = 3 + n, .mul = 2 + n, .div = 1};
  for (int below = n - 1; below >= 0; --below) {
    sum = sum + Cost{.add = below * below, .mul = below * below + below, .div = 1};
  }
  return sum;
}

Cost newton_cost(int n, const Cost& dynamics) {
  const Cost solve{.add = n * (n - 1), .mul = n * n};
  return dynamics + solve + Cost{.add = 6 * n, .mul = 5 * n + 2};
}

/// Two stages with some Newton steps each and a number of Jacobians of the whole step.
Cost sdirk2_cost(const Stepper& stepper, const Cost& dynamics, int newton_steps, int jacobians) {
  const int n = stepper.signature.inputs.front().size;
  // the first Newton step of a stage is not compared with one before
  const Cost own{.add = 8 * n + (stepper.takes_time ? 2 : 0), .mul = 8 * n - 2};
  return dynamics + jacobians * factor_cost(n, dynamics) +
         2 * newton_steps * newton_cost(n, dynamics) + own;
}

/// The integration alone, given the operations of one call of the dynamics.
Cost integration_cost(const Stepper& stepper, const Cost& dynamics, bool worst) {
  const int n = stepper.signature.inputs.front().size;
  switch (stepper.method) {
    case StepMethod::kSemiImplicitEuler:
      break;
    case StepMethod::kRk4:
      return 4 * dynamics + Cost{.add = 14 * n + (stepper.takes_time ? 2 : 0), .mul = 10 * n};
    case StepMethod::kDopri5:
      return 6 * dynamics + Cost{.add = 40 * n + (stepper.takes_time ? 5 : 0), .mul = 40 * n};
    case StepMethod::kSdirk2:
      return worst ? sdirk2_cost(stepper, dynamics, kMostJacobians * kMostNewtonSteps,
                                 1 + 2 * kMostJacobians) +
                         Cost{.mul = 2 * kMostJacobians}
                   : sdirk2_cost(stepper, dynamics, kUsualNewtonSteps, 1);
  }
  return dynamics + Cost{.add = 2 * n, .mul = 2 * n};
}

Cost end_time_cost(const Stepper& stepper) { return {.add = stepper.needs_end_time() ? 1 : 0}; }

/// Everything that the events of a phase may cost in one step.
Cost worst_event_cost(const Stepper& stepper, const StepPhase& phase) {
  Cost sum = of_all(phase.guards);
  Cost dearest;
  for (const StepEvent& event : phase.events) {
    sum = sum + (event.crosses ? of_all(phase.guards) : Cost{});
    sum = sum + (event.approach >= 0 ? of_all(phase.approaches) : Cost{});
    Cost outcome = event.outcome.impact_cost + of_all(stepper.anchors);
    if (event.rest) {
      outcome = outcome + event.rest->impact_cost + of_all(phase.approaches);
    }
    dearest = outcome.total() > dearest.total() ? outcome : dearest;
  }
  return sum + dearest;
}

}  // namespace

bool Stepper::needs_end_time() const {
  return std::any_of(anchors.begin(), anchors.end(), program::takes_time) ||
         std::any_of(phases.begin(), phases.end(), [](const StepPhase& phase) {
           return std::any_of(phase.guards.begin(), phase.guards.end(), program::takes_time);
         });
}

Cost step_cost(const Stepper& stepper, const StepPhase& phase) {
  return integration_cost(stepper, phase.dynamics_cost, false) + of_all(phase.guards) +
         end_time_cost(stepper);
}

Cost step_cost(const Stepper& stepper) { return step_cost(stepper, stepper.phases.front()); }

Cost worst_step_cost(const Stepper& stepper) {
  Cost worst;
  for (const StepPhase& phase : stepper.phases) {
    const Cost here = integration_cost(stepper, phase.dynamics_worst_cost, true) +
                      worst_event_cost(stepper, phase) + end_time_cost(stepper);
    worst = {std::max(worst.add, here.add), std::max(worst.mul, here.mul),
             std::max(worst.div, here.div), std::max(worst.sqrt, here.sqrt),
             std::max(worst.sin, here.sin), std::max(worst.cos, here.cos)};
  }
  return worst;
}

}  // namespace treedyn::program
