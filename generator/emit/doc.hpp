// What the header says of a function: purpose, arguments with shapes and units, equation, cost.
#pragma once

#include <string>

#include "emit/checked.hpp"
#include "program/function.hpp"
#include "program/staged.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

/// The comment above the declaration, lines of `/// ` of at most kColumns characters.
std::string doc(const program::Function& function);
std::string doc(const Checked& checked);
std::string doc(const program::Staged& staged);
std::string doc(const program::Stepper& stepper);

}  // namespace treedyn::emit
