// The text of `step`.
#pragma once

#include <string>

#include "emit/literal.hpp"
#include "emit/names.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

/// The function, from its declaration to its closing brace, behind the functions that only it
/// calls.
/// \throws std::range_error if the step is too large for the scalar type
std::string stepper_text(const program::Stepper& stepper, const Vocabulary& words,
                         const Target& target);

}  // namespace treedyn::emit
