// What stands behind the integration in `step`: events, impacts and the next phase.
#pragma once

#include <string>

#include "emit/literal.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

/// Statements, indented by two, without the last line break; nothing if nothing ends a phase.
std::string events_text(const program::Stepper& stepper, Scalar scalar);

}  // namespace treedyn::emit
