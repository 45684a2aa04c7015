// The error bounds of all outputs of a function, over ranges that are cut where that helps.
#pragma once

#include <string>
#include <vector>

#include "accuracy/bounds.hpp"

namespace treedyn::accuracy {

/// Bounds over a box.
struct BoundsOver {
  double largest = 0;           ///< bound / scale; infinite if there is none
  std::size_t output = 0;       ///< where
  std::vector<double> outputs;  ///< bounds of all
  std::string obstacle;         ///< why there is none
};

/// Where bounds are looked for and what they are parts of.
struct Over {
  Box box;
  std::vector<double> scales;  ///< of the outputs
  int cuts = 0;
};

/// Halves the box `cuts` times, always the piece whose bound is the largest part of its scale,
/// along its widest element. The same on every machine. O((outputs + cuts) x operations of an
/// output)
BoundsOver bounds_over(const program::Function& function, const Arithmetic& how, const Over& over);

}  // namespace treedyn::accuracy
