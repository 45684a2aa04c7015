// The functions of the engine as steps of one plan.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "block/plan.hpp"
#include "equations/table.hpp"

namespace treedyn::engine {

using equations::Extent;

/// The functions that the engine evaluates, rows of equations/table.hpp: those that are one block
/// expression, forward dynamics and rotations of points.
std::vector<const equations::Equation*> functions();

/// How an output in joint coordinates turns into independent coordinates, q = T u + q0.
enum class Reduction {
  kNone,       ///< points, energies
  kRows,       ///< T^T X: forces, C, H
  kRowsCols,   ///< T^T X T: A
  kSelection,  ///< l_D, c_fD: the blocks of the links whose joints are independent
};

struct Output {
  const equations::Equation* function = nullptr;
  int step = -1;  ///< of the plan; of rotations none
  block::Shape shape = {};
  std::vector<int> steps = {};  ///< to run
  Extent rows = {}, cols = {};  ///< kPerDof counts links here
  Reduction reduction = Reduction::kNone;
};

class Outputs {
 public:
  explicit Outputs(const block::Index& index);

  [[nodiscard]] const block::Plan& plan() const { return plan_; }
  /// For forward dynamics B + G; nullptr if the engine has no such function.
  [[nodiscard]] const Output* find(std::string_view function) const;

 private:
  void add(const equations::Equation& function, const block::Expression& expression);

  block::Plan plan_;
  std::map<std::string_view, Output> outputs_;
};

}  // namespace treedyn::engine
