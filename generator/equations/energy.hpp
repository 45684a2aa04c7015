// Which single numbers of N m are energies, and which moments.
#pragma once

#include "block/block.hpp"

namespace treedyn::equations {

/// True if every term of the number is an energy by its form: q̇^T .. q̇, or g^T .. m^d .. without
/// axes and Λ. `T(at(j)) * B` and `T(at(j)) * G` are none.
bool has_form_of_energy(const block::Expression& number);

}  // namespace treedyn::equations
