// The unit of mass in which a robot's inertias are numbers near one.
#pragma once

#include "model/tree.hpp"

namespace treedyn::model {

/// kg: 1, or a power of two for robots whose largest moment of inertia (mass, of what slides) is
/// below 1e-12 or above 1e12 kg m^2: there products of two overflow or underflow in float. A power
/// of two changes no digit.
Real mass_unit(const Tree& tree);

/// The same tree with masses and moments of inertia in this unit.
Tree in_mass_unit(Tree tree, const Real& unit);

}  // namespace treedyn::model
