// From the file as written to the checked model. Every check of a model file that is not syntax is
// here or in what this calls: skeleton (names, fathers), numbers, rotation, bodies, mimic, points.
#pragma once

#include "description/raw_tree.hpp"
#include "description/read.hpp"

namespace treedyn::description {

/// \throws InputError at the first mistake.
/// \return the model, and the near misses of snapping as findings.
Vetted resolve(const RawTree& raw, const ReadOptions& options);

}  // namespace treedyn::description
