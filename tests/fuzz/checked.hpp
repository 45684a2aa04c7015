// What a reader must guarantee of any model that it accepts.
#pragma once

#include "model/tree.hpp"

namespace treedyn::fuzz {

/// Stops the program if a later stage could trip over `tree`: order, unit axes, rotations, sizes,
/// finite numbers.
void expect_checked(const model::Tree& tree);

}  // namespace treedyn::fuzz
