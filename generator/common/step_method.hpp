// Integrators of a fixed step that become code.
#pragma once

namespace treedyn {

enum class StepMethod { kSemiImplicitEuler, kRk4, kDopri5, kSdirk2 };

}  // namespace treedyn
