// Constants that are one in the scalar type of the code: factors that change nothing.
#pragma once

#include <functional>

#include "program/stepper.hpp"

namespace treedyn::program {

/// True for a positive number that the scalar type of the code holds as 1.
using IsOne = std::function<bool(const Real&)>;

/// The same with 1 in the place of every constant that `is_one`, so that factors of 1 are gone; the
/// same nodes in the same order if there is none. O(size of the graph)
Function without_ones(const Function& function, const IsOne& is_one);
Staged without_ones(Staged staged, const IsOne& is_one);
/// \param functions  those that the step calls, without ones: their costs count
Stepper without_ones(Stepper stepper, const std::vector<Staged>& functions, const IsOne& is_one);

}  // namespace treedyn::program
