// One integration step of a scene's own fixed-step integrator.
#pragma once

#include <string>

#include "program/staged.hpp"

namespace treedyn::program {

enum class StepMethod { kSemiImplicitEuler, kRk4 };

/// step(q, qd, tau[, t]) -> q_next, qd_next[, lambda], by calls of constrained_dynamics.
struct Stepper {
  Signature signature;
  StepMethod method = StepMethod::kSemiImplicitEuler;
  Real step = 0;              ///< s
  std::string dynamics;       ///< the function that it calls
  bool takes_time = false;    ///< which has an argument t
  bool takes_anchor = false;  ///< and one for the anchors of stabilised rows
  int rows = 0;               ///< and this many reactions
  Cost dynamics_cost;         ///< of one call
  Cost dynamics_worst_cost;   ///< of the dearest call
};

/// Operations of one step, given those of one call of the dynamics.
Cost step_cost(const Stepper& stepper, const Cost& dynamics);

}  // namespace treedyn::program
