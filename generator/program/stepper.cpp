#include "program/stepper.hpp"

#include <algorithm>

namespace treedyn::program {

namespace {

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
    sum =
        sum +
        Cost{.add = below * below, .mul = below * below + below, .div = 1, .fused = below * below};
  }
  return sum;
}

Cost newton_cost(int n, const Cost& dynamics) {
  const Cost solve{.add = n * (n - 1), .mul = n * n, .fused = n * (n - 1)};
  return dynamics + solve + Cost{.add = 6 * n, .mul = 5 * n + 2};
}

/// Two stages with some Newton steps each and a number of Jacobians of the whole step.
Cost sdirk2_cost(const Stepper& stepper, const Cost& dynamics, int newton_steps, int jacobians) {
  const int n = stepper.signature.inputs.front().size;
  // the first Newton step of a stage is not compared with one before
  const int halfway = tells_reactions(stepper) ? stepper.rows : 0;
  const Cost own{.add = 8 * n + (stepper.takes_time ? 3 : 0) + 2 + 2 * halfway,
                 .mul = 8 * n - 1 + 3 * halfway};
  return dynamics + jacobians * factor_cost(n, dynamics) +
         2 * newton_steps * newton_cost(n, dynamics) + own;
}

/// Which of the steps.
enum class Which { kLeast, kUsual, kWorst };

/// One part of the integration, given the operations of one call of the dynamics.
Cost part_cost(const Stepper& stepper, const Cost& dynamics, Which which) {
  const int n = stepper.signature.inputs.front().size;
  // of the last sums the product is added by a function of its own
  const Cost kept{.add = stepper.compensated ? 6 * n : 0,
                  .fused = stepper.compensated ? -2 * n : 0};
  const bool timed = stepper.takes_time;
  const bool any_length = stepper.any_length();
  const int halfway = tells_reactions(stepper) ? stepper.rows : 0;
  switch (stepper.method) {
    case StepMethod::kSemiImplicitEuler:
      break;
    case StepMethod::kRk4:
      return kept + 4 * dynamics +
             Cost{.add = 14 * n + (timed ? 2 : 0),
                  .mul = 10 * n + (any_length ? 2 : 0),
                  .fused = 10 * n};
    case StepMethod::kDopri5:
      return kept + 6 * dynamics +
             Cost{.add = 40 * n + (timed ? 5 : 0) + 3 * halfway,
                  .mul = 40 * n + (any_length ? 20 + (timed ? 5 : 0) : 0) + 4 * halfway,
                  .fused = 40 * n};
    case StepMethod::kSdirk2:
      switch (which) {
        case Which::kLeast:
          return sdirk2_cost(stepper, dynamics, 0, 0);
        case Which::kUsual:
          return sdirk2_cost(stepper, dynamics, kUsualNewtonSteps, 1);
        case Which::kWorst:
          break;
      }
      return kMostTries * (sdirk2_cost(stepper, dynamics, kMostJacobians * kMostNewtonSteps,
                                       1 + 2 * kMostJacobians) +
                           Cost{.add = 1, .mul = 1 + 2 * kMostJacobians});
  }
  return kept + dynamics + Cost{.add = 2 * n, .mul = 2 * n, .fused = 2 * n};
}

/// The integration alone.
Cost integration_cost(const Stepper& stepper, const Cost& dynamics, Which which) {
  const bool worst = which == Which::kWorst;
  const Cost part = part_cost(stepper, dynamics, which);
  const auto turning = static_cast<int>(stepper.turning.size());
  if (turning == 0) {
    return part;
  }
  const Cost looks{.add = 1 + turning + (stepper.takes_time ? 1 : 0),
                   .mul = turning,
                   .div = worst ? turning : 0};
  const int parts = worst ? stepper.parts : 1;
  return parts * (part + looks) + (parts - 1) * Cost{.add = 1};  // what is done, but for the last
}

/// When a phase has lasted so long.
Cost lasted_cost(const Stepper& stepper, const Lasting& lasting) {
  return {.add = (lasting.rest != 0 ? 1 : 0) + (stepper.begun ? 1 : 0), .mul = 1};
}

/// All times of a phase's events, or those of events that wait for nothing else.
Cost clock_cost(const Stepper& stepper, const StepPhase& phase, bool due) {
  Cost sum;
  if (due) {
    for (const StepEvent& event : phase.events) {
      sum =
          sum + (event.cause == StepCause::kTime ? lasted_cost(stepper, event.not_before) : Cost{});
    }
    return sum;
  }
  for (const Lasting& lasting : clocks(phase)) {
    sum = sum + (stepper.cuts > 0 ? lasted_cost(stepper, lasting) : Cost{});
  }
  return sum;
}

Cost guard_cost(const StepPhase& phase) {
  const bool timed = !phase.guards.empty() && takes_time(phase.guards.front());
  return of_all(phase.guards) + Cost{.add = timed ? 1 : 0};
}

/// A part of a step up to an event or to its end.
Cost advance_cost(const Stepper& stepper, const StepPhase& phase, Which which) {
  const Cost& dynamics = which == Which::kWorst ? phase.dynamics_worst_cost : phase.dynamics_cost;
  return integration_cost(stepper, dynamics, which) + Cost{.add = stepper.takes_time ? 2 : 1};
}

/// The choice among the events of a phase between two moments.
Cost choice_cost(const Stepper& stepper, const StepPhase& phase) {
  Cost sum;
  for (const StepEvent& event : phase.events) {
    const bool timed = !event.not_before.none();
    const bool begins = event.cause == StepCause::kLand;
    sum = sum + Cost{.add = 1, .mul = begins ? 2 : 0, .div = 1} +
          (timed ? lasted_cost(stepper, event.not_before) : Cost{});
  }
  return sum;
}

/// All cuts that look for one event.
Cost cut_cost(const Stepper& stepper, const StepPhase& phase) {
  const int values = stepper.most_guards() + stepper.most_approaches();
  const Cost weigh{.add = values, .mul = values, .div = values};
  const Cost one = advance_cost(stepper, phase, Which::kWorst) + guard_cost(phase) +
                   of_all(phase.approaches) + weigh + 2 * choice_cost(stepper, phase) +
                   Cost{.add = 5, .mul = 3};
  return (stepper.cuts + 1) * one + choice_cost(stepper, phase);
}

/// What one event may do to the state.
Cost outcome_cost(const Stepper& stepper, const StepPhase& phase, const StepEvent& event) {
  const int n = stepper.signature.inputs.front().size;
  const Cost renewal = of_all(stepper.anchors) + Cost{.add = 1};
  Cost sum = event.outcome.impact_cost + renewal;
  if (event.rest) {
    const StepPhase& next = stepper.phases[static_cast<std::size_t>(event.outcome.then)];
    sum = sum + 3 * of_all(phase.approaches) + advance_cost(stepper, next, Which::kWorst) +
          guard_cost(phase) + 2 * event.rest->impact_cost + renewal +
          Cost{.add = 2 * n + 2, .mul = n, .div = 1};
  }
  return sum;
}

Cost most(const Cost& a, const Cost& b) {
  return by_count(a, b, [](int x, int y) { return std::max(x, y); });
}

/// The look at guards halfway.
Cost dip_cost(const Stepper& stepper, const StepPhase& phase) {
  const int n = stepper.signature.inputs.front().size;
  const auto guards = static_cast<int>(dipping(stepper, phase).size());
  if (guards == 0) {
    return {};
  }
  const bool speed = phase.guards_speed;
  const Cost between = n * Cost{.add = speed ? 6 : 3, .mul = speed ? 4 : 2} +
                       Cost{.add = 2, .mul = 2, .div = speed ? 1 : 0};
  return between + guard_cost(phase) + guards * Cost{.add = 4, .mul = 2};
}

/// What is found there, in one part of a step.
Cost found_cost(const Stepper& stepper, const StepPhase& phase) {
  const auto guards = static_cast<int>(dipping(stepper, phase).size());
  return guards == 0 ? Cost{}
                     : guards * Cost{.add = 9, .mul = 9, .div = 6} + Cost{.add = 1, .mul = 1} +
                           advance_cost(stepper, phase, Which::kWorst) + guard_cost(phase) +
                           2 * of_all(phase.approaches) + choice_cost(stepper, phase);
}

/// A part of a step without an event in it, and what an event adds.
Cost worst_part_cost(const Stepper& stepper, const StepPhase& phase) {
  return clock_cost(stepper, phase, true) + clock_cost(stepper, phase, false) +
         advance_cost(stepper, phase, Which::kWorst) +
         2 * (guard_cost(phase) + of_all(phase.approaches)) + choice_cost(stepper, phase) +
         dip_cost(stepper, phase) + found_cost(stepper, phase);
}

Cost worst_event_cost(const Stepper& stepper, const StepPhase& phase) {
  Cost dearest;
  for (const StepEvent& event : phase.events) {
    dearest = most(dearest, outcome_cost(stepper, phase, event));
  }
  return dearest + (stepper.cuts > 0 ? cut_cost(stepper, phase) : Cost{});
}

template <class Part>
int most_of(const std::vector<StepPhase>& phases, const Part& part) {
  int result = 0;
  for (const StepPhase& phase : phases) {
    const std::vector<Staged>& functions = part(phase);
    result = std::max(result, functions.empty() ? 0 : functions[0].signature.outputs[0].size);
  }
  return result;
}

}  // namespace

StepCount& StepCount::operator+=(const StepCount& other) {
  steps += other.steps;
  repeated.resize(std::max(repeated.size(), other.repeated.size()));
  most.resize(repeated.size());
  for (std::size_t what = 0; what < other.repeated.size(); ++what) {
    repeated[what] += other.repeated[what];
    most[what] = std::max(most[what], other.most[what]);
  }
  return *this;
}

bool Stepper::ends() const {
  return std::ranges::any_of(phases, [](const StepPhase& phase) { return !phase.events.empty(); });
}

bool Stepper::has_times() const {
  return std::ranges::any_of(phases, [](const StepPhase& phase) {
    return std::ranges::any_of(
        phase.events, [](const StepEvent& event) { return event.cause == StepCause::kTime; });
  });
}

int Stepper::most_guards() const {
  return most_of(
      phases, [](const StepPhase& p) -> const auto& { return p.guards; });
}

int Stepper::most_approaches() const {
  return most_of(
      phases, [](const StepPhase& p) -> const auto& { return p.approaches; });
}

void set_costs(StepPhase& phase, const Staged& dynamics) {
  phase.dynamics_cost = cost(dynamics);
  phase.dynamics_worst_cost = worst_cost(dynamics);
  phase.contact_costs.clear();
  for (const Staged& contact : dynamics.contacts) {
    phase.contact_costs.push_back(cost(contact));
  }
}

std::vector<Lasting> clocks(const StepPhase& phase) {
  std::vector<Lasting> result;
  for (const StepEvent& event : phase.events) {
    const Lasting& time = event.not_before;
    if (!time.none() && std::ranges::find(result, time) == result.end()) {
      result.push_back(time);
    }
  }
  return result;
}

bool takes_time(const Staged& staged) { return has(staged.signature.inputs, "t"); }

bool tells_reactions(const Stepper& stepper) {
  const auto pulls = [](const StepPhase& phase) {
    return std::ranges::any_of(
        phase.events, [](const StepEvent& event) { return event.cause == StepCause::kPull; });
  };
  return stepper.method != StepMethod::kSemiImplicitEuler &&
         std::ranges::any_of(stepper.phases, pulls);
}

std::vector<int> dipping(const Stepper& stepper, const StepPhase& phase) {
  std::vector<int> guards;
  for (const StepEvent& event : phase.events) {
    const bool pulls = event.cause == StepCause::kPull;
    if (pulls ? tells_reactions(stepper) : event.cause != StepCause::kTime) {
      guards.push_back(event.guard);
    }
  }
  return guards;
}

namespace {

Cost cost_while_nothing_happens(const Stepper& stepper, const StepPhase& phase, Which which) {
  if (!stepper.ends()) {
    return integration_cost(stepper, phase.dynamics_cost, which);
  }
  // times are looked at before the step and behind it
  return 2 * clock_cost(stepper, phase, true) + clock_cost(stepper, phase, false) +
         advance_cost(stepper, phase, which) + 2 * guard_cost(phase) + dip_cost(stepper, phase);
}

}  // namespace

Cost step_cost(const Stepper& stepper, const StepPhase& phase) {
  return cost_while_nothing_happens(stepper, phase, Which::kUsual);
}

Cost step_cost(const Stepper& stepper) { return step_cost(stepper, stepper.phases.front()); }

Cost least_step_cost(const Stepper& stepper, const StepPhase& phase) {
  return cost_while_nothing_happens(stepper, phase, Which::kLeast);
}

std::vector<Cost> repeated_costs(const Stepper& stepper, const StepPhase& phase) {
  const int n = stepper.signature.inputs.front().size;
  std::vector<Cost> result = {integration_cost(stepper, phase.dynamics_cost, Which::kLeast),
                              {},
                              {},
                              advance_cost(stepper, phase, Which::kLeast) + guard_cost(phase)};
  if (stepper.method == StepMethod::kSdirk2) {
    result[1] = newton_cost(n, phase.dynamics_cost);
    result[2] = factor_cost(n, phase.dynamics_cost);
  }
  result.insert(result.end(), phase.contact_costs.begin(), phase.contact_costs.end());
  return result;
}

long step_evaluations(const Stepper& stepper, const StepCount& count) {
  StepPhase none;
  StepPhase one;
  one.dynamics_cost.add = 1;  // so additions count calls
  const auto calls = [&](const Cost& with, const Cost& without) {
    return static_cast<long>(with.add - without.add);
  };
  long result = count.steps * calls(least_step_cost(stepper, one), least_step_cost(stepper, none));
  const auto with = repeated_costs(stepper, one);
  const auto without = repeated_costs(stepper, none);
  for (std::size_t what = 0; what < std::min(with.size(), count.repeated.size()); ++what) {
    result += count.repeated[what] * calls(with[what], without[what]);
  }
  return result;
}

Cost worst_step_cost(const Stepper& stepper) {
  Cost part;
  Cost event;
  for (const StepPhase& phase : stepper.phases) {
    if (!stepper.ends()) {
      part = most(part, integration_cost(stepper, phase.dynamics_worst_cost, Which::kWorst));
      continue;
    }
    part = most(part, worst_part_cost(stepper, phase));
    event = most(event, worst_event_cost(stepper, phase));
  }
  if (!stepper.ends()) {
    return part;
  }
  const int parts = stepper.cuts > 0 ? stepper.events + 1 : 1;
  const int times = stepper.events + 1;  // looks at the clock
  Cost clock;
  for (const StepPhase& phase : stepper.phases) {
    clock = most(clock, clock_cost(stepper, phase, true));
  }
  return parts * part + stepper.events * event + times * clock + Cost{.add = 1};
}

}  // namespace treedyn::program
