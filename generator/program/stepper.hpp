// One integration step of a scene's own fixed-step integrator, and what may end a phase behind it.
#pragma once

#include <optional>
#include <string>

#include "program/staged.hpp"

namespace treedyn::program {

enum class StepMethod { kSemiImplicitEuler, kRk4, kDopri5, kSdirk2 };

/// Newton steps of each stage of kSdirk2 that the usual cost counts, and the bounds of its code:
/// Jacobians of a stage and Newton steps with each.
inline constexpr int kUsualNewtonSteps = 3;
inline constexpr int kMostJacobians = 6;
inline constexpr int kMostNewtonSteps = 8;

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
};

/// Happens at the end of a step of which all that it names is true.
struct StepEvent {
  std::string brief;     ///< for the reader: "touch_down of foot"
  int guard = -1;        ///< this value of `guards` is negative; -1: any
  bool crosses = false;  ///< it is not negative at the beginning of the step
  int approach = -1;     ///< this value of `approaches` is negative; -1: any
  int not_before = 0;    ///< the phase has lasted this many steps
  StepOutcome outcome;
  /// Instead, where `outcome` leaves an approach below rest_below.
  std::optional<StepOutcome> rest;
  Real rest_below = 0;  ///< m/s
};

/// Dynamics between two events, and the events.
struct StepPhase {
  std::string identifier;
  std::string dynamics;  ///< the function that it calls
  bool takes_time = false;
  bool takes_anchor = false;
  int rows = 0;
  Cost dynamics_cost;              ///< of one call
  Cost dynamics_worst_cost;        ///< of the dearest call
  std::vector<Staged> guards;      ///< one or none: q, qd[, t][, lambda] -> guard
  std::vector<Staged> approaches;  ///< one or none: q, qd -> approach, m/s
  std::vector<StepEvent> events;
};

/// step(q, qd, tau[, t][, anchor][, phase][, steps]) ->
///   q_next, qd_next[, lambda][, anchor_next][, phase_next][, steps_next],
/// by calls of constrained_dynamics. \invariant at least one phase
struct Stepper {
  Signature signature;
  StepMethod method = StepMethod::kSemiImplicitEuler;
  Real step = 0;  ///< s
  std::vector<StepPhase> phases;
  std::vector<Staged> anchors;  ///< one or none: q[, t] -> anchor, as they are now
  bool takes_time = false;
  bool takes_anchor = false;
  int rows = 0;       ///< of lambda: the most of any phase
  int counted = 0;    ///< steps of a phase are counted up to here; 0: not at all
  std::string first;  ///< the phase in which the scene begins

  /// True if the phase is an argument.
  [[nodiscard]] bool switches() const { return phases.size() > 1; }
  /// True if something behind the integration looks at the time.
  [[nodiscard]] bool needs_end_time() const;
};

/// Operations of one step in a phase while no guard is negative.
Cost step_cost(const Stepper& stepper, const StepPhase& phase);
/// The same in the first phase.
Cost step_cost(const Stepper& stepper);
/// A bound of the operations of any step.
Cost worst_step_cost(const Stepper& stepper);

}  // namespace treedyn::program
