// The functions of the engine as steps of one plan.
#pragma once

#include <vector>

#include "block/plan.hpp"
#include "engine/signatures.hpp"

namespace treedyn::engine {

/// How an output in joint coordinates turns into independent coordinates, q = T u + q0.
enum class Reduction {
  kNone,       ///< points, energies
  kRows,       ///< T^T X: forces, C, H
  kRowsCols,   ///< T^T X T: A
  kSelection,  ///< l_D, c_fD: the blocks of the links whose joints are independent
};

struct Output {
  int step = -1;  ///< of the plan
  block::Shape shape;
  std::vector<int> steps;  ///< to run
  Extent rows, cols;       ///< kPerDof counts links here
  Reduction reduction = Reduction::kNone;
};

class Outputs {
 public:
  explicit Outputs(const block::Index& index);

  [[nodiscard]] const block::Plan& plan() const { return plan_; }
  /// For forward dynamics B + G; nothing for rotations.
  [[nodiscard]] const Output& of(Function function) const {
    return outputs_[static_cast<std::size_t>(function)];
  }

 private:
  void add(Function function, const block::Expression& expression);

  block::Plan plan_;
  std::vector<Output> outputs_;
};

}  // namespace treedyn::engine
