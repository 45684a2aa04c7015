// Pivots of A that may lose their digits in functions of a scene.
#pragma once

#include "pipeline.hpp"

namespace treedyn {

/// The same programs, whose functions of the scene test the pivots that may lose their digits at
/// some position.
///
/// A is eliminated from its last row: a pivot is the inertia that a joint moves while the joints
/// before it hold and those behind it are free, never less than that of its own link, its rotor
/// included. Where that exceeds roundings of the largest inertia before the joint, there is no
/// test. Beside a position where a pivot vanishes its joint and its sons turn without bound, which
/// steps look at. O(N^3) for each of a few states.
program::Programs with_tested_pivots(program::Programs programs, const Model& model,
                                     emit::Scalar scalar);

}  // namespace treedyn
