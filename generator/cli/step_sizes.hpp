// What a generated step takes of a microcontroller, by a cross compiler.
#pragma once

#include "accuracy/study.hpp"
#include "stages/step_files.hpp"

namespace treedyn {

/// \throws InputError unless arm-none-eabi-g++ is on PATH
void require_cross_compiler();

/// Compiled with -Os -ffp-contract=off -fno-math-errno and linked with libgcc and libm as far as
/// `step` calls them. Flash: code, constants and initial values of data. Stack: the deepest way of
/// calls from `step` on, with frames as the compiler tells them, of its libraries by what their
/// instructions push. \pre the core has flash \throws InputError if that fails
accuracy::Size step_size(const StepFiles& files, const accuracy::Core& core);

}  // namespace treedyn
