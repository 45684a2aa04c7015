// What events do to the state: impacts, rest, anchors, the next phase.
#pragma once

#include "emit/literal.hpp"
#include "emit/step_text.hpp"

namespace treedyn::emit {

/// The body of `happen`: one case an event.
Lines effect_lines(const program::Stepper& stepper, Scalar scalar);

}  // namespace treedyn::emit
