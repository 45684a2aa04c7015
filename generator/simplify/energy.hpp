// Kinetic energy.
#pragma once

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// T = 1/2 qd^T A(q) qd, J; one forward sweep of velocities.
Expr kinetic_energy(const Kinematics& kinematics);

}  // namespace treedyn::simplify
