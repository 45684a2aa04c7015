// Functions of numbers that are known at run time only: what depends on these alone is computed
// before.
#pragma once

#include <functional>
#include <vector>

#include "optimise/program_names.hpp"

namespace treedyn::optimise {

/// True if a number of the function has a recipe (common/recipe.hpp).
bool depends_on_parameters(const Function& function);

/// Every number with a recipe becomes an element of one more argument of its function, `derived`,
/// the last one; equal numbers of all functions are one element. Its size is the number of them.
/// Functions without such numbers that `takes` does not name stay as they are. No operation more or
/// less. O(n)
/// \param takes  functions that have the argument whether they need it or not
/// \return the function that computes `derived` from `parameters`, its name and texts left to the
/// caller, and the elements of `derived`
struct Separated {
  Function update;
  std::vector<Real> numbers;
};
Separated separate_parameters(const std::vector<Function*>& functions, const Array& parameters,
                              const Array& derived,
                              const std::function<bool(const Function&)>& takes);

}  // namespace treedyn::optimise
