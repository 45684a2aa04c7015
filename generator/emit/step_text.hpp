// Lines of the text of `step` that depend on its phases.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "emit/layout.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

/// What run-time parameters have become, where a `motion` is at hand.
inline constexpr const char* kDerivedOfMotion = "*motion.derived";

/// A function's parameter that run-time parameters have become.
std::string derived_parameter();

/// Arguments of a local function.
struct StateText {
  std::string q, qd, t, lambda;
};
/// A call of it: of the arguments those that it takes; what run-time parameters have become is that
/// of a `motion`.
std::string call(const program::Staged& staged, const StateText& state, const std::string& result);

/// What depends on the phase `which`: a switch, or the lines of the only phase.
Lines by_phase(const program::Stepper& stepper, const std::string& which,
               const std::function<Lines(const program::StepPhase&)>& lines_of);

/// Number of the first event of a phase among those of the scene.
int first_event_of(const program::Stepper& stepper, const program::StepPhase& phase);

/// The event for a comment.
std::string comment_of(const program::StepEvent& event);

}  // namespace treedyn::emit
