// Kinetic and potential energy.
#pragma once

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// T = 1/2 qd^T A(q) qd, J; one forward sweep of velocities.
Expr kinetic_energy(const Kinematics& kinematics);

/// U = -sum m g.r, J; zero with all mass at the base origin.
Expr potential_energy(const Kinematics& kinematics, const NormalTree& normal);

}  // namespace treedyn::simplify
