// How `step` looks for events between two moments.
#pragma once

#include <string>

#include "emit/literal.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

/// The functions up to `find_event`. \pre some phase has guards
std::string search_text(const program::Stepper& stepper, Scalar scalar);

/// When the phase has lasted this long, s from the beginning of the step: an expression.
std::string lasted_text(const program::Stepper& stepper, const program::Lasting& lasting,
                        Scalar scalar);

}  // namespace treedyn::emit
