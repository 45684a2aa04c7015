// What `step` does about events: it looks for them, cuts the step where they happen, and goes on
// behind them.
#pragma once

#include <string>

#include "emit/literal.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

/// The functions that `step` calls behind `integrate`, in an unnamed namespace that is open.
/// \pre stepper.ends()
std::string event_functions(const program::Stepper& stepper, Scalar scalar);

/// `step` itself, from its declaration to its closing brace. \pre stepper.ends()
std::string turns_text(const program::Stepper& stepper);

}  // namespace treedyn::emit
