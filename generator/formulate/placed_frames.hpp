// Where link frames stand: turns about joint axes and slides along them.
#pragma once

#include <vector>

#include "formulate/frames.hpp"

namespace treedyn::formulate {

/// Turns and slides frames so that constants vanish, as the variant says, then those of `limbs` by
/// half turns so that as many constants as possible are those of the first limb of the class.
/// \param tree  frames at the joints, z along the axes
NormalTree with_placed_frames(NormalTree tree, const Variant& variant,
                              const std::vector<LimbLinks>& limbs);

}  // namespace treedyn::formulate
