// Several functions of the same inputs as one, so that what they share is computed once.
#pragma once

#include <span>
#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// The outputs of all functions, in order. Inputs are matched by name; an input that is not in
/// `inputs` is zero, and what it multiplies vanishes. O(size of the graphs).
/// \param inputs  of the result; those that functions share have equal sizes
Function combine(std::span<const Function> functions, const std::vector<Array>& inputs);

}  // namespace treedyn::program
