// One integration step of a scene's own fixed-step integrator, and what may end a phase behind it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/step_method.hpp"
#include "program/staged.hpp"

namespace treedyn::program {

/// Newton steps of each stage of kSdirk2 that the usual cost counts, and the bounds of its code:
/// Jacobians of a stage and Newton steps with each.
inline constexpr int kUsualNewtonSteps = 3;
inline constexpr int kMostJacobians = 6;
inline constexpr int kMostNewtonSteps = 8;
/// Parts of a step that kSdirk2 tries.
inline constexpr int kMostTries = 8;

/// What a step repeats as often as the motion makes it. Its number is an argument of treedyn_again.
enum class Repeated {
  kPart,        ///< of an integration, beyond the first
  kNewtonStep,  ///< of kSdirk2, all
  kJacobian,    ///< the same
  kAdvance,     ///< an integration in a step with events, beyond the first
  kPress,       ///< of the first contact; those of the others follow
};
/// By its number.
using Repetitions = std::vector<long>;

/// How often a step was called in one phase, and how often it repeated something.
struct StepCount {
  long steps = 0;
  Repetitions repeated = {};  ///< in all
  Repetitions most = {};      ///< in one step

  StepCount& operator+=(const StepCount& other);
};

/// Elements of `anchor` that are made anew.
struct Renewal {
  int first = 0;
  int size = 0;
};

/// What becomes of the state when an event happens.
struct StepOutcome {
  std::string impact;  ///< the function; empty: none
  int impulses = 0;    ///< that it gives
  Cost impact_cost;    ///< of its dearest call
  int then = 0;        ///< of Stepper::phases
  std::vector<Renewal> renewals;
  int stops = -1;  ///< the joint whose velocity becomes zero
};

/// What an event waits for.
enum class StepCause {
  kTime,   ///< nothing but its time
  kCross,  ///< a guard that falls through zero
  kFall,   ///< a guard below zero, of a point that approaches
  kLand,   ///< a guard that falls through zero, or below it a point that begins to approach
  kPull    ///< a guard below zero: of reactions
};

/// How long a phase lasts: so many steps and a rest, shorter than a step.
struct Lasting {
  int steps = 0;
  Real rest = 0;  ///< s
  bool operator==(const Lasting&) const = default;
  [[nodiscard]] bool none() const { return steps == 0 && rest == 0; }
};

/// Ends a phase.
struct StepEvent {
  std::string brief;  ///< for the reader: "touch_down of foot"
  StepCause cause = StepCause::kTime;
  int guard = -1;      ///< of `guards`
  int approach = -1;   ///< of `approaches`: kFall, kLand, and where rebounds may come to rest
  Lasting not_before;  ///< not before the phase has lasted this long; kTime: then
  StepOutcome outcome;
  /// Instead, where `outcome` leaves an approach below rest_below.
  std::optional<StepOutcome> rest;
  Real rest_below = 0;   ///< m/s
  Real holds = 0;        ///< kPull: the force that a guard is the rest of; roundings of it are none
  bool goes_on = false;  ///< the next phase lasts since this one began
  bool stops_point = false;  ///< kLand: along the normal
};

/// Dynamics between two events, and the events.
struct StepPhase {
  std::string identifier;
  std::string dynamics;  ///< the function that it calls
  bool takes_time = false;
  bool takes_anchor = false;
  bool guards_speed = false;  ///< an event waits for velocities
  std::vector<int> stuck;     ///< joints that stay where they are
  int rows = 0;
  Cost dynamics_cost;               ///< of one call
  Cost dynamics_worst_cost;         ///< of the dearest call
  std::vector<Cost> contact_costs;  ///< of each that presses in the dynamics
  std::vector<Staged> guards;       ///< one or none: q, qd[, t][, lambda] -> guard
  std::vector<Staged> approaches;   ///< one or none: q, qd -> approach, m/s
  std::vector<StepEvent> events;
};

/// step(q, qd, tau[, t][, anchor][, phase][, steps][, begun][, rest]) ->
///   q_next, qd_next[, lambda][, anchor_next][, phase_next][, steps_next][, begun_next][,
///   rest_next],
/// by calls of constrained_dynamics. \invariant at least one phase
struct Stepper {
  Signature signature;
  StepMethod method = StepMethod::kSemiImplicitEuler;
  std::string integrator;  ///< the method's name
  Real step = 0;           ///< s
  int cuts = 0;    ///< steps of shorter length that look for an event; 0: it is taken at the end
  int events = 0;  ///< in one step, at most
  int parts = 0;   ///< of a step in which `turning` joints turn far, at most
  std::vector<StepPhase> phases;
  std::vector<Staged> anchors;  ///< one or none: q[, t] -> anchor, as they are now
  bool takes_time = false;
  bool takes_anchor = false;
  bool takes_derived = false;  ///< what run-time parameters become, last of its inputs
  int rows = 0;                ///< of lambda: the most of any phase
  int counted = 0;             ///< steps of a phase are counted up to here; 0: not at all
  bool begun = false;          ///< phases with counted steps begin within a step
  bool compensated = false;    ///< rest: what q and qd lost by rounding
  bool tells = false;          ///< calls treedyn_event, treedyn_again, not there: for studies
  std::string first;           ///< the phase in which the scene begins
  bool drifts = false;         ///< rows without an acceleration of their own are not stabilised
  bool tests_pivots = false;   ///< the dynamics tell lost pivots of A
  /// Revolute joints that turn without bound beside a position without accelerations, as the outer
  /// angles of a free body do: steps are done in parts in which they turn little.
  std::vector<int> turning;
  /// Joints by whose velocities phases come in threes: at rest, forth, back; those of the first are
  /// neighbours.
  std::vector<int> sticking;

  /// True if the phase is an argument.
  [[nodiscard]] bool switches() const { return phases.size() > 1; }
  /// True if some phase ends.
  [[nodiscard]] bool ends() const;
  /// True if it integrates over other lengths than `step`, too.
  [[nodiscard]] bool any_length() const { return ends() || !turning.empty(); }
  /// True if some phase ends because of its time alone.
  [[nodiscard]] bool has_times() const;
  /// Guards and, behind them, approaches of the phase with the most.
  [[nodiscard]] int most_guards() const;
  [[nodiscard]] int most_approaches() const;
};

/// What a call of the dynamics takes.
void set_costs(StepPhase& phase, const Staged& dynamics);
/// What a phase's events wait for, each once.
std::vector<Lasting> clocks(const StepPhase& phase);
/// True if `staged` takes the time.
bool takes_time(const Staged& staged);
/// True if integration tells the reactions halfway, which some event waits for: from its stages. A
/// step of kSemiImplicitEuler knows those of its beginning only.
bool tells_reactions(const Stepper& stepper);
/// Guards of a phase that may fall below zero and rise again within a step and are looked at there.
std::vector<int> dipping(const Stepper& stepper, const StepPhase& phase);

/// Operations of one step in a phase while no guard is negative.
Cost step_cost(const Stepper& stepper, const StepPhase& phase);
/// The same in the first phase.
Cost step_cost(const Stepper& stepper);
/// The same of a step that repeats nothing, and what each repetition adds.
Cost least_step_cost(const Stepper& stepper, const StepPhase& phase);
std::vector<Cost> repeated_costs(const Stepper& stepper, const StepPhase& phase);
/// Calls of the dynamics in steps that repeat so much.
long step_evaluations(const Stepper& stepper, const StepCount& count);
/// A bound of the operations of any step.
Cost worst_step_cost(const Stepper& stepper);

}  // namespace treedyn::program
