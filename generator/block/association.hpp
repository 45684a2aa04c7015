// In which order to multiply a product of several block-sparse matrices.
#pragma once

#include <vector>

#include "block/pattern.hpp"

namespace treedyn::block {

struct Factor {
  Pattern pattern;
  int height = 1;  ///< of a block
  int width = 1;
  bool path_sum = false;  ///< a multiplication by it only adds
};

/// Multiply the partial products that begin with factors `left` and `right` (left stays the
/// beginning).
struct Split {
  int left = 0;
  int right = 0;
};

/// The fewest multiplications of scalars, by dynamic programming over the zero patterns; of equal
/// costs the leftmost first. O(n^3) for n factors, besides the patterns of the partial products.
std::vector<Split> associate(const std::vector<Factor>& factors);

}  // namespace treedyn::block
