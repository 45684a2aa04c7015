// Constants are positive where they are printed.
#pragma once

#include "program/function.hpp"

namespace treedyn::program {

/// The same function with positive constants: where a number has not the sign that it is seen with,
/// its negative is used and the sign passes on to its users. Numbers that are known at run time
/// only stay as they are. No operation more or less. O(n)
Function with_positive_constants(const Function& function);

}  // namespace treedyn::program
