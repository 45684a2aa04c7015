// The operations of one output as its error bound sees them.
#pragma once

#include <utility>
#include <vector>

#include "accuracy/function_errors.hpp"
#include "accuracy/interval.hpp"

namespace treedyn::accuracy {

/// One operation, or a leaf. Operands are steps before it; sines and products know which angle
/// they belong to, so that c^2 + s^2 = 1 can be used.
struct BoundStep {
  program::Kind kind = program::Kind::kConstant;
  int a = -1;  ///< step; of an input its number, array after array
  int b = -1;
  bool minus_a = false;
  bool minus_b = false;
  bool exact = false;  ///< a product with a power of two
  Interval constant;
  double literal = 0;   ///< how far a constant is from its literal
  int angle = -1;       ///< of a product of a sine or a cosine with something else: the step of x
  bool sine = false;    ///< its factor is sin x
  int other = -1;       ///< what is multiplied: a or b
  bool paired = false;  ///< one of the `pairs` of `other`
  bool turn = false;    ///< a sum of two products, one with sin x, one with cos x
  /// Products of this step with cos x and with sin x.
  std::vector<std::pair<int, int>> pairs = {};
};

/// In order of evaluation, the output last; the operations that the code of `function` executes.
std::vector<BoundStep> bound_steps(const program::Function& function, program::Ref output,
                                   emit::Scalar scalar);

}  // namespace treedyn::accuracy
