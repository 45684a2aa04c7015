// Inertial parameters that no joint force can feel move to the father (EQUATIONS.md 8).
#pragma once

#include "formulate/frames.hpp"

namespace treedyn::formulate {

/// Moves what `how` says of the mass, the first moment along the axis and the pseudo-inertia of
/// revolute link i to its father, or to the ground. Exact; sons before fathers. A prismatic link
/// keeps everything.
void regroup(NormalTree& tree, int i, const LinkVariant& how);

/// Zeroes what rounding at 50 digits left of exact cancellations.
void clean_constants(NormalTree& tree);

}  // namespace treedyn::formulate
