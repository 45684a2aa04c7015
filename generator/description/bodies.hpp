// Mass properties: checked as one file entry, moved to another frame, combined.
#pragma once

#include <vector>

#include "description/numbers.hpp"
#include "description/snapping.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// The mass properties of a link in its own frame.
///
/// A tensor with a negative principal moment is refused unless the rounding of its decimals
/// explains it; of a link that is fixed to the ground it becomes a warning, as does a violated
/// triangle inequality. \throws InputError
model::Inertia resolve_inertia(const RawTree& raw, const RawLink& link, const NumberReader& numbers,
                               Snapper& snapper, bool moves, std::vector<Warning>& warnings);

/// `inertia` seen from a frame in which its own frame stands at `origin`, turned by `rotation`.
model::Inertia moved(const model::Inertia& inertia, const Matrix3& rotation, const Vector3& origin);

/// One body made of several, all in the same frame; what cancels to rounding becomes zero.
model::Inertia combined(const std::vector<model::Inertia>& bodies);

}  // namespace treedyn::description
