// Single numbers y^T M y, M symmetric.
#pragma once

#include <optional>
#include <vector>

#include "block/block.hpp"

namespace treedyn::equations {

/// factor * y^T M y.
struct QuadraticForm {
  block::Ratio factor;
  std::vector<block::Expression> middle;  ///< factors of M, diagonals; none: E
  block::Expression y;
};

/// A single number as a sum of such forms, A as J_v^T m J_v + J_ω^T J J_ω; nothing for others.
std::optional<std::vector<QuadraticForm>> quadratic_forms(const block::Expression& e);

}  // namespace treedyn::equations
