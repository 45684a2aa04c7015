// Which numbers of a robot the numbers of a formulation are made of (common/provenance.hpp).
#pragma once

#include "formulate/stand_ins.hpp"

namespace treedyn::formulate {

/// Every number of the robot that is seen as another one is its own source. O(N)
void note_provenance(const Seen& seen);

}  // namespace treedyn::formulate
