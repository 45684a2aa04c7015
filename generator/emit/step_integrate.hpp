// The integration of a step by its method, of a fixed length or of any.
#pragma once

#include <string>

#include "emit/literal.hpp"
#include "emit/step_text.hpp"

namespace treedyn::emit {

/// What is written: `step` itself, of a fixed length, or `integrate`, of any length h in a phase.
enum class Form { kStep, kIntegrate };

/// `step` without events, or `integrate`; `integrate_part` where it is called in parts.
std::string integration(const program::Stepper& stepper, Form form, Scalar scalar);

/// The stages that `step` or `integrate` of kSdirk2 tries.
std::string sdirk2_stages(const program::Stepper& stepper, Scalar scalar);

/// `integrate` in parts, where joints may turn far.
std::string parts_text(const program::Stepper& stepper, Scalar scalar);

/// `step` without events that integrates in parts.
std::string step_of_parts(const program::Stepper& stepper, Scalar scalar);

}  // namespace treedyn::emit
