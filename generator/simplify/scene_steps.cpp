#include "simplify/scene_steps.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "simplify/scene_drift.hpp"
#include "simplify/scene_guards.hpp"
#include "simplify/search.hpp"

namespace treedyn::simplify {

using model::Event;
using model::EventKind;
using model::Scene;
using program::Staged;
using program::StepEvent;
using program::StepMethod;
using program::StepOutcome;
using program::StepPhase;

namespace {

constexpr std::array<std::pair<const char*, StepMethod>, 4> kMethods = {
    {{"semi-implicit-euler", StepMethod::kSemiImplicitEuler},
     {"rk4", StepMethod::kRk4},
     {"dopri5-fixed", StepMethod::kDopri5},
     {"sdirk2", StepMethod::kSdirk2}}};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool includes(const std::vector<int>& all, const std::vector<int>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// An event whose impact would strike constraints that act already does not happen.
bool is_watched(const Event& event, const std::vector<int>& active) {
  const bool rests = event.impact && !event.impact->constraints.empty() &&
                     includes(active, event.impact->constraints);
  const bool reacts = event.kind != EventKind::kReaction ||
                      std::find(active.begin(), active.end(), event.constraint) != active.end();
  return !rests && reacts;
}

bool rebounds(const Event& event) {
  return event.impact && !event.impact->constraints.empty() && event.impact->restitution > 0;
}

bool may_rest(const Event& event) { return rebounds(event) && event.impact->rest_below > 0; }

/// The constraints that act behind an event.
std::vector<int> active_behind(const Scene& scene, const Event& event, bool at_rest) {
  std::vector<int> active = scene.phases[index(event.then)].active;
  if (at_rest) {
    const std::vector<int> before = active;
    active.clear();
    std::set_union(before.begin(), before.end(), event.impact->constraints.begin(),
                   event.impact->constraints.end(), std::back_inserter(active));
  }
  return active;
}

int find_state(const std::vector<PhaseState>& states, int phase, const std::vector<int>& active) {
  const auto found = std::find_if(states.begin(), states.end(), [&](const PhaseState& state) {
    return state.phase == phase && state.active == active;
  });
  return found == states.end() ? -1 : static_cast<int>(found - states.begin());
}

PhaseState resting(const Scene& scene, const std::vector<PhaseState>& states, int phase,
                   std::vector<int> active) {
  const auto same = std::count_if(states.begin(), states.end(),
                                  [&](const PhaseState& state) { return state.phase == phase; });
  const std::string more = same > 1 ? fmt::format("_at_rest_{}", same) : "_at_rest";
  const PhaseState& plain = states[index(phase)];
  return {phase, std::move(active), plain.ending + more,
          to_identifier(scene.phases[index(phase)].name + more)};
}

bool has(const std::vector<program::Array>& arrays, const std::string& name) {
  return std::any_of(arrays.begin(), arrays.end(),
                     [&](const program::Array& array) { return array.name == name; });
}

/// Makes the stepper of one scene.
class StepMaker {
 public:
  StepMaker(const Scene& scene, Options options, const std::vector<PhaseState>& states,
            const std::vector<Staged>& impacts)
      : scene_(scene), options_(std::move(options)), states_(states), impacts_(impacts) {
    options_.gravity = scene.gravity;
    options_.points = scene.points;
    options_.scene = &scene;
  }

  [[nodiscard]] program::Stepper make(const std::vector<Staged>& dynamics) const;

 private:
  [[nodiscard]] StepPhase phase(std::size_t state, const Staged& dynamics) const;
  void add_event(const Event& event, std::size_t state, StepPhase& phase,
                 std::vector<Event>& guarded, std::vector<Event>& approached) const;
  [[nodiscard]] StepOutcome outcome(const Event& event, std::size_t state, bool at_rest) const;
  [[nodiscard]] Staged guards(const std::vector<Event>& events, std::size_t state, int rows) const;
  [[nodiscard]] Staged approaches(const std::vector<Event>& events, std::size_t state) const;
  [[nodiscard]] Staged anchors() const;
  [[nodiscard]] Staged local(const std::string& name, const Options& options, const Inputs& places,
                             std::vector<Expr> (*build)(const Task&),
                             std::vector<program::Array> inputs, program::Array output) const;
  [[nodiscard]] int steps_in(const Real& time) const {
    return static_cast<int>(ceil(Real(time / scene_.stepping.step - Real("1e-30"))));
  }
  [[nodiscard]] int anchor_count() const {
    return anchor_offset(scene_, static_cast<int>(scene_.constraints.size()));
  }
  [[nodiscard]] program::Array q() const { return {"q", scene_.tree.dof(), "rad|m"}; }
  [[nodiscard]] program::Array qd() const { return {"qd", scene_.tree.dof(), "rad/s|m/s"}; }
  void sign(const Staged& dynamics, program::Stepper& stepper) const;

  const Scene& scene_;
  Options options_;
  const std::vector<PhaseState>& states_;
  const std::vector<Staged>& impacts_;
};

/// A function of straight-line code that only `step` calls.
Staged StepMaker::local(const std::string& name, const Options& options, const Inputs& places,
                        std::vector<Expr> (*build)(const Task&), std::vector<program::Array> inputs,
                        program::Array output) const {
  const Recipe recipe{"", "", "", {}, {}, places, {.fixed_length = true}, build};
  Staged staged;
  staged.function = cheapest(scene_.tree, recipe, options);
  staged.signature = {name, "", "", std::move(inputs), {std::move(output)}};
  staged.function.signature = staged.signature;
  staged.levels.assign(staged.signature.inputs.size(), 0);
  return staged;
}

Staged StepMaker::guards(const std::vector<Event>& events, std::size_t state, int rows) const {
  Options options = options_;
  options.events = events;
  options.active = states_[state].active;
  const GuardArrays arrays = guard_arrays(events);
  std::vector<program::Array> inputs = {q(), qd()};
  if (arrays.t >= 0) {
    inputs.push_back({"t", 1, "s"});
  }
  if (arrays.lambda >= 0) {
    inputs.push_back({"lambda", rows, "N|N m"});
  }
  return local("guards" + states_[state].ending, options, {.q = 0, .qd = 1}, build_guards, inputs,
               {"guard", static_cast<int>(events.size()), "m|N|1"});
}

Staged StepMaker::approaches(const std::vector<Event>& events, std::size_t state) const {
  Options options = options_;
  options.events = events;
  return local("approaches" + states_[state].ending, options, {.q = 0, .qd = 1}, build_approaches,
               {q(), qd()}, {"approach", static_cast<int>(events.size()), "m/s"});
}

Staged StepMaker::anchors() const {
  std::vector<program::Array> inputs = {q()};
  if (anchors_use_time(scene_)) {
    inputs.push_back({"t", 1, "s"});
  }
  return local("anchors", options_, {.q = 0}, build_anchors, inputs,
               {"anchor", anchor_count(), "m|1|rad"});
}

StepOutcome StepMaker::outcome(const Event& event, std::size_t state, bool at_rest) const {
  StepOutcome result;
  const std::vector<int> active = active_behind(scene_, event, at_rest);
  result.then = find_state(states_, event.then, active);
  if (event.impact && !event.impact->constraints.empty()) {
    const ImpactName wanted{event.impact->constraints,
                            at_rest ? Real(0) : event.impact->restitution, ""};
    const std::vector<ImpactName> all = impacts_of(scene_);
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const ImpactName& impact) { return impact.same_as(wanted); });
    const Staged& impact = impacts_[static_cast<std::size_t>(found - all.begin())];
    result.impact = impact.signature.name;
    result.impulses = impact.signature.outputs.back().size;
    result.impact_cost = program::worst_cost(impact);
  }
  const std::vector<int>& before = states_[state].active;
  for (int c = 0; c < static_cast<int>(scene_.constraints.size()); ++c) {
    const model::Constraint& constraint = scene_.constraints[index(c)];
    const bool moves = constraint.pinned || constraint.kind == model::ConstraintKind::kOrientation;
    const bool pinned = std::find(event.pins.begin(), event.pins.end(), c) != event.pins.end();
    if (anchor_size(scene_, c) > 0 &&
        (pinned || (moves && includes(active, {c}) && !includes(before, {c})))) {
      result.renewals.push_back({anchor_offset(scene_, c), anchor_size(scene_, c)});
    }
  }
  return result;
}

std::string brief_of(const Scene& scene, const Event& event) {
  switch (event.kind) {
    case EventKind::kHeight:
      return fmt::format("touch_down of {}", scene.points[index(event.point)].name);
    case EventKind::kReaction:
      return fmt::format("lift_off of {}", scene.constraints[index(event.constraint)].name);
    case EventKind::kExpression:
      return "the expression falls below zero";
    case EventKind::kTime:
      break;
  }
  return "time";
}

void StepMaker::add_event(const Event& event, std::size_t state, StepPhase& phase,
                          std::vector<Event>& guarded, std::vector<Event>& approached) const {
  StepEvent result;
  result.brief = brief_of(scene_, event);
  result.not_before = steps_in(event.not_before);
  result.outcome = outcome(event, state, false);
  if (event.kind != EventKind::kTime) {
    result.guard = static_cast<int>(guarded.size());
    guarded.push_back(event);
  }
  const bool falls = event.kind == EventKind::kHeight && rebounds(event);
  result.crosses = !falls && event.kind != EventKind::kTime && event.kind != EventKind::kReaction;
  if (falls || may_rest(event)) {
    result.approach = static_cast<int>(approached.size());
    approached.push_back(event);
  }
  if (may_rest(event)) {
    result.rest = outcome(event, state, true);
    result.rest_below = event.impact->rest_below;
  }
  phase.events.push_back(std::move(result));
}

StepPhase StepMaker::phase(std::size_t state, const Staged& dynamics) const {
  StepPhase result;
  const std::vector<program::Array>& inputs = dynamics.signature.inputs;
  result.identifier = states_[state].identifier;
  result.dynamics = dynamics.signature.name;
  result.takes_time = has(inputs, "t");
  result.takes_anchor = has(inputs, "anchor");
  result.rows = dynamics.solves.empty() ? 0 : dynamics.solves.front().rows;
  result.dynamics_cost = program::cost(dynamics);
  result.dynamics_worst_cost = program::worst_cost(dynamics);
  std::vector<Event> guarded;
  std::vector<Event> approached;
  for (const Event& event : scene_.phases[index(states_[state].phase)].until) {
    if (is_watched(event, states_[state].active)) {
      add_event(event, state, result, guarded, approached);
    }
  }
  if (!guarded.empty()) {
    result.guards.push_back(guards(guarded, state, result.rows));
  }
  if (!approached.empty()) {
    result.approaches.push_back(approaches(approached, state));
  }
  return result;
}

/// Arguments and results.
void StepMaker::sign(const Staged& dynamics, program::Stepper& stepper) const {
  const int n = scene_.tree.dof();
  const bool ends = std::any_of(stepper.phases.begin(), stepper.phases.end(),
                                [](const StepPhase& phase) { return !phase.events.empty(); });
  program::Signature& s = stepper.signature;
  s = {"step",
       "(8),(12)",
       ends ? "Joint positions and velocities one step later, behind the event that ends the step "
              "if there is one; lambda is that of the beginning."
            : "Joint positions and velocities one step later, within the phase; lambda is that of "
              "the beginning.",
       {dynamics.signature.inputs.begin(), dynamics.signature.inputs.begin() + 3},
       {{"q_next", n, "rad|m"}, {"qd_next", n, "rad/s|m/s"}},
       true};
  const auto add = [](std::vector<program::Array>& arrays, bool needed, program::Array array) {
    if (needed) {
      arrays.push_back(std::move(array));
    }
  };
  const bool renews = !stepper.anchors.empty();
  const bool counts = stepper.counted > 0;
  add(s.inputs, stepper.takes_time, {"t", 1, "s"});
  add(s.inputs, stepper.takes_anchor, {"anchor", anchor_count(), "m|1|rad"});
  add(s.inputs, stepper.switches(), {"phase", 1, "index", true});
  add(s.inputs, counts, {"steps", 1, "done in this phase", true});
  add(s.outputs, stepper.rows > 0, {"lambda", stepper.rows, "N|N m"});
  add(s.outputs, renews, {"anchor_next", anchor_count(), "m|1|rad"});
  add(s.outputs, stepper.switches(), {"phase_next", 1, "index", true});
  add(s.outputs, counts, {"steps_next", 1, "done in the next phase", true});
}

program::Stepper StepMaker::make(const std::vector<Staged>& dynamics) const {
  program::Stepper result;
  result.method = *step_method(scene_);
  result.step = scene_.stepping.step;
  bool renews = false;
  for (std::size_t state = 0; state < states_.size(); ++state) {
    result.phases.push_back(phase(state, dynamics[state]));
    const StepPhase& added = result.phases.back();
    result.takes_time = result.takes_time || added.takes_time;
    result.takes_anchor = result.takes_anchor || added.takes_anchor;
    result.rows = std::max(result.rows, added.rows);
    for (const StepEvent& event : added.events) {
      result.counted = std::max(result.counted, event.not_before);
      renews = renews || !event.outcome.renewals.empty() ||
               (event.rest && !event.rest->renewals.empty());
    }
  }
  if (renews) {
    result.anchors.push_back(anchors());
  }
  result.takes_time = result.takes_time || result.needs_end_time();
  result.first = states_[index(scene_.start_phase)].identifier;
  sign(dynamics.front(), result);
  return result;
}

}  // namespace

std::vector<PhaseState> phase_states(const Scene& scene, bool at_rest) {
  std::vector<PhaseState> states;
  for (std::size_t k = 0; k < scene.phases.size(); ++k) {
    states.push_back({static_cast<int>(k), scene.phases[k].active, phase_name(scene, k, ""),
                      to_identifier(scene.phases[k].name)});
  }
  for (std::size_t k = 0; at_rest && k < states.size(); ++k) {
    for (const Event& event : scene.phases[index(states[k].phase)].until) {
      if (!may_rest(event) || !is_watched(event, states[k].active)) {
        continue;
      }
      const std::vector<int> active = active_behind(scene, event, true);
      if (find_state(states, event.then, active) < 0) {
        states.push_back(resting(scene, states, event.then, active));
      }
    }
  }
  return states;
}

std::optional<StepMethod> step_method(const Scene& scene) {
  for (const auto& [name, method] : kMethods) {
    if (scene.stepping.integrator == name) {
      return method;
    }
  }
  return std::nullopt;
}

std::vector<std::string> step_method_names() {
  std::vector<std::string> names;
  for (const auto& [name, method] : kMethods) {
    names.emplace_back(name);
  }
  return names;
}

program::Stepper make_stepper(const Scene& scene, const Options& options,
                              const std::vector<PhaseState>& states,
                              const std::vector<Staged>& dynamics,
                              const std::vector<Staged>& impacts) {
  return StepMaker(scene, options, states, impacts).make(dynamics);
}

}  // namespace treedyn::simplify
