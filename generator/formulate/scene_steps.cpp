#include "formulate/scene_steps.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "common/index.hpp"
#include "equations/scene_table.hpp"
#include "formulate/scene_drift.hpp"
#include "formulate/scene_guards.hpp"
#include "formulate/search.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

using model::Event;
using model::EventKind;
using model::Scene;
using program::Staged;
using program::StepCause;
using program::StepEvent;
using program::StepOutcome;
using program::StepPhase;

namespace {

/// True if a touch-down stops its point or begins to hold it: a point that begins to fall below the
/// plane, as where it was held until now, touches down as well.
bool lands(const Scene& scene, const Event& event, const std::vector<int>& before,
           const std::vector<int>& behind) {
  const auto begins_to_hold = [&](int c) {
    const model::Constraint& row = scene.constraints[to_index(c)];
    return row.kind == model::ConstraintKind::kPoint && row.point == event.point &&
           std::ranges::count(before, c) == 0;
  };
  return strikes(event) || std::ranges::any_of(behind, begins_to_hold);
}

/// \param lands  of a touch-down
StepCause cause_of(const Event& event, bool lands) {
  switch (event.kind) {
    case EventKind::kTime:
      return StepCause::kTime;
    case EventKind::kReaction:
      return StepCause::kPull;
    case EventKind::kHeight:
      return rebounds(event) ? StepCause::kFall : lands ? StepCause::kLand : StepCause::kCross;
    case EventKind::kExpression:
      break;
  }
  return StepCause::kCross;
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
  [[nodiscard]] Staged anchors() const;

 private:
  [[nodiscard]] StepPhase phase(std::size_t state, const Staged& dynamics) const;
  void add_event(const Event& event, std::size_t state, StepPhase& phase,
                 std::vector<Event>& guarded, std::vector<Event>& approached) const;
  [[nodiscard]] StepOutcome outcome(const Event& event, std::size_t state, bool at_rest) const;
  [[nodiscard]] Staged guards(const std::vector<Event>& events, std::size_t state, int rows) const;
  [[nodiscard]] Staged approaches(const std::vector<Event>& events, std::size_t state) const;
  [[nodiscard]] Staged local(const std::string& name, const Options& options, const Inputs& places,
                             std::vector<Expr> (*build)(const Task&),
                             std::vector<program::Array> inputs, program::Array output) const;
  [[nodiscard]] program::Lasting lasting(const Real& time) const;
  [[nodiscard]] program::Array anchor(const std::string& name) const {
    return {name, anchor_offset(scene_, static_cast<int>(scene_.constraints.size())), "m|1|rad"};
  }
  [[nodiscard]] program::Array q() const { return {"q", scene_.tree.dof(), "rad|m"}; }
  [[nodiscard]] program::Array qd() const { return {"qd", scene_.tree.dof(), "rad/s|m/s"}; }
  [[nodiscard]] bool drifts() const;
  static void count_steps(program::Stepper& stepper);
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
  const Recipe recipe{places, {}, build};
  Staged staged;
  staged.function = cheapest_by_structure(scene_.tree, recipe, options);
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
  return local("anchors", options_, {.q = 0}, build_anchors, inputs, anchor("anchor"));
}

/// Steps and a rest; without cuts whole steps, rounded up.
program::Lasting StepMaker::lasting(const Real& time) const {
  const Real& h = scene_.stepping.step;
  const Real steps = floor(Real(time / h + Real("1e-30")));
  const Real rest = time - steps * h;
  const bool whole = !(rest > h * Real("1e-30"));
  const int count = static_cast<int>(steps);
  if (scene_.stepping.cuts == 0) {
    return {count + (whole ? 0 : 1), 0};
  }
  return {count, whole ? Real(0) : rest};
}

StepOutcome StepMaker::outcome(const Event& event, std::size_t state, bool at_rest) const {
  StepOutcome result;
  const std::vector<int> active = active_behind(scene_, states_[state], event, at_rest);
  result.then = find_state(states_, event.then, active);
  if (strikes(event)) {
    const ImpactName wanted =
        impact_with(*event.impact, at_rest ? Real(0) : event.impact->restitution);
    const std::vector<ImpactName> all = impacts_of(scene_);
    const auto found =
        std::ranges::find_if(all, [&](const ImpactName& impact) { return impact.same_as(wanted); });
    const Staged& impact = impacts_[static_cast<std::size_t>(found - all.begin())];
    result.impact = impact.signature.name;
    result.impulses = impact.signature.outputs.back().size;
    result.impact_cost = program::worst_cost(impact);
  }
  result.stops = event.stops;
  const std::vector<int>& before = states_[state].active;
  for (int c = 0; c < static_cast<int>(scene_.constraints.size()); ++c) {
    const model::Constraint& constraint = scene_.constraints[to_index(c)];
    const bool moves = constraint.pinned || constraint.kind == model::ConstraintKind::kOrientation;
    const bool pinned = std::ranges::find(event.pins, c) != event.pins.end();
    if (anchor_size(scene_, c) > 0 && (pinned || (moves && std::ranges::count(active, c) > 0 &&
                                                  std::ranges::count(before, c) == 0))) {
      result.renewals.push_back({anchor_offset(scene_, c), anchor_size(scene_, c)});
    }
  }
  return result;
}

std::string brief_of(const Scene& scene, const Event& event) {
  switch (event.kind) {
    case EventKind::kHeight:
      return fmt::format("touch_down of {}", scene.points[to_index(event.point)].name);
    case EventKind::kReaction: {
      const model::Constraint& row = scene.constraints[to_index(event.constraint)];
      return fmt::format("{} {}", row.sticks ? "beyond" : "lift_off of", row.name);
    }
    case EventKind::kExpression:
      return event.stops < 0 ? fmt::format("the expression {} zero",
                                           event.rises ? "rises above" : "falls below")
                             : fmt::format("{} stops", scene.tree.moved_by(event.stops).joint.name);
    case EventKind::kTime:
      break;
  }
  return "time";
}

void StepMaker::add_event(const Event& event, std::size_t state, StepPhase& phase,
                          std::vector<Event>& guarded, std::vector<Event>& approached) const {
  StepEvent result;
  result.brief = brief_of(scene_, event);
  result.not_before = lasting(event.not_before);
  result.outcome = outcome(event, state, false);
  if (event.kind != EventKind::kTime) {
    result.guard = static_cast<int>(guarded.size());
    guarded.push_back(event);
  }
  const std::vector<int>& before = states_[state].active;
  const std::vector<int> behind = active_behind(scene_, states_[state], event, false);
  result.cause = cause_of(event, lands(scene_, event, before, behind));
  if (result.cause == StepCause::kFall || result.cause == StepCause::kLand ||
      may_rest(scene_, event)) {
    result.approach = static_cast<int>(approached.size());
    approached.push_back(event);
  }
  if (may_rest(scene_, event)) {
    result.rest = outcome(event, state, true);
    result.rest_below = event.impact->rest_below;
  }
  result.goes_on = event.goes_on;
  result.stops_point = model::stops_point(scene_, event, before, behind);
  result.holds = event.kind == EventKind::kReaction ? event.plane.height.plain() : Real(0);
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
  program::set_costs(result, dynamics);
  std::vector<Event> guarded;
  std::vector<Event> approached;
  for (const Event& event : events_of(scene_, states_[state])) {
    if (is_watched(event, states_[state].active)) {
      add_event(event, state, result, guarded, approached);
    }
  }
  result.guards_speed = std::ranges::any_of(guarded, [](const Event& event) {
    return event.kind == EventKind::kExpression && event.value.uses(model::Quantity::kVelocity);
  });
  for (const int c : states_[state].active) {
    const model::Constraint& row = scene_.constraints[to_index(c)];
    if (row.sticks) {
      result.stuck.push_back(row.joint);
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
  program::Signature& s = stepper.signature;
  s = {"step",
       equations::scene_function_info("step").equation,
       fmt::format("Joint positions and velocities one step later{}{}; tau comes on top of the "
                   "scene's own joint forces.",
                   stepper.ends()       ? ", behind the events within the step"
                   : stepper.switches() ? ", within the phase"
                                        : "",
                   stepper.rows > 0 ? "; lambda is that of the beginning" : ""),
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
  add(s.inputs, stepper.takes_anchor, anchor("anchor"));
  add(s.inputs, stepper.switches(), {"phase", 1, "index", true});
  add(s.inputs, counts, {"steps", 1, "done in this phase", true});
  add(s.inputs, stepper.begun, {"begun", 1, "s in this phase before them"});
  add(s.inputs, stepper.compensated,
      {"rest", 2 * n, "what q and qd lost by rounding; zero at first"});
  add(s.outputs, stepper.rows > 0, {"lambda", stepper.rows, "N|N m"});
  add(s.outputs, renews, anchor("anchor_next"));
  add(s.outputs, stepper.switches(), {"phase_next", 1, "index", true});
  add(s.outputs, counts, {"steps_next", 1, "done in the next phase", true});
  add(s.outputs, stepper.begun, {"begun_next", 1, "s in the next phase before them"});
  add(s.outputs, stepper.compensated,
      {"rest_next", 2 * n, "what q_next and qd_next lost by rounding"});
}

/// How far steps of a phase must be counted, and whether phases begin within a step.
void StepMaker::count_steps(program::Stepper& stepper) {
  bool within = false;
  for (const StepPhase& phase : stepper.phases) {
    for (const StepEvent& event : phase.events) {
      within = within || event.cause != StepCause::kTime || event.not_before.rest != 0;
      if (!event.not_before.none()) {
        stepper.counted = std::max(stepper.counted, event.not_before.steps);
      }
    }
  }
  const bool counts = std::ranges::any_of(
      stepper.phases, [](const StepPhase& phase) { return !clocks(phase).empty(); });
  stepper.begun = counts && within && stepper.cuts > 0;
  stepper.counted += stepper.begun ? 1 : 0;
}

/// Rows that have a position and that accelerations alone keep there; a joint that rests does.
bool StepMaker::drifts() const {
  return std::ranges::any_of(states_, [&](const PhaseState& state) {
    return std::ranges::any_of(state.active, [&](int c) {
      const model::Constraint& row = scene_.constraints[to_index(c)];
      const bool rests =
          row.kind == model::ConstraintKind::kJoint && row.curve.acceleration.front().is_zero();
      const bool turns = row.kind == model::ConstraintKind::kOrientation && row.rows() < 3;
      return !rests && !turns && row.accelerations.empty() && !model::is_stabilised(scene_, c);
    });
  });
}

program::Stepper StepMaker::make(const std::vector<Staged>& dynamics) const {
  program::Stepper result;
  result.method = *step_method(scene_);
  result.integrator = scene_.stepping.integrator;
  result.step = scene_.stepping.step;
  result.cuts = scene_.stepping.cuts;
  result.parts = scene_.stepping.parts;
  const int of_sticking = 1 + 2 * static_cast<int>(scene_.sticking.size());
  result.events = scene_.stepping.events > 0 ? scene_.stepping.events : std::max(3, of_sticking);
  result.compensated = scene_.stepping.compensated;
  bool renews = false;
  for (std::size_t state = 0; state < states_.size(); ++state) {
    result.phases.push_back(phase(state, dynamics[state]));
    const StepPhase& added = result.phases.back();
    result.takes_time = result.takes_time || added.takes_time ||
                        (!added.guards.empty() && program::takes_time(added.guards.front()));
    result.takes_anchor = result.takes_anchor || added.takes_anchor;
    result.rows = std::max(result.rows, added.rows);
    for (const StepEvent& event : added.events) {
      renews = renews || !event.outcome.renewals.empty() ||
               (event.rest && !event.rest->renewals.empty());
    }
  }
  count_steps(result);
  if (renews) {
    result.anchors.push_back(anchors());
    result.takes_time = result.takes_time || program::takes_time(result.anchors.front());
  }
  result.sticking = scene_.sticking;
  result.drifts = drifts();
  result.first = states_[to_index(scene_.start_phase)].identifier;
  sign(dynamics.front(), result);
  return result;
}

}  // namespace

program::Stepper make_stepper(const Scene& scene, const Options& options,
                              const std::vector<PhaseState>& states,
                              const std::vector<Staged>& dynamics,
                              const std::vector<Staged>& impacts) {
  return StepMaker(scene, options, states, impacts).make(dynamics);
}

program::Function anchor_function(const Scene& scene) {
  Options options;
  options.effort = 0;
  return StepMaker(scene, options, {}, {}).anchors().function;
}

}  // namespace treedyn::formulate
