// The equations of a scene and its rows as R12'' and R12''' solve them: for multipliers of K μ = b.
#pragma once

#include <string>
#include <vector>

#include "formulate/joint_numbers.hpp"
#include "formulate/scene_rows.hpp"

namespace treedyn::formulate {

class SceneSolution {
 public:
  /// \param function  one of a scene, of several equations
  /// \param passive  joints without a drive, where they stand in the equations
  SceneSolution(const char* function, Graph& graph, int dof, const std::vector<Row>& rows,
                const Numbers::Leaf& leaf, const std::vector<int>& passive = {});

  /// The lower half of K, row by row, and b behind it.
  [[nodiscard]] std::vector<Expr> equations() const;
  /// What is made of the multipliers.
  [[nodiscard]] std::vector<Expr> x(std::size_t k = 0) const {
    return column_of(numbers_.root(2 + k));
  }

 private:
  Numbers numbers_;
};

}  // namespace treedyn::formulate
