// Numbers that a tree decides, as equations of users divide by: masses and counts of links.
#pragma once

#include <algorithm>
#include <span>

#include "block/evaluate.hpp"
#include "block/plan.hpp"
#include "equations/user.hpp"

namespace treedyn::equations {

/// The value of `e`, 1 x 1, of masses and of the equation's constants.
/// \param convert  Real -> Scalar
template <class Scalar, class Convert>
Scalar number_of_tree(const UserEquation& equation, const block::Expression& e,
                      const block::Index& index, std::span<const Scalar> masses, Convert convert) {
  block::Plan plan(index);
  const int step = plan.add(e);
  block::Evaluation<Scalar> evaluation(plan);
  std::ranges::copy_n(masses.begin(), std::ssize(evaluation.leaf("m^d")),
                      evaluation.leaf("m^d").begin());
  for (const auto& [name, values] : equation.constants) {
    const std::span<Scalar> leaf = evaluation.leaf(name);
    std::transform(values.begin(), values.begin() + std::ssize(leaf), leaf.begin(), convert);
  }
  for (const auto& [name, divisor] : equation.reciprocals) {
    for (Scalar& value : evaluation.leaf(name)) {
      value = 1 / number_of_tree<Scalar>(equation, divisor, index, masses, convert);
    }
  }
  evaluation.run(plan.needed({step}));
  Scalar value(0);
  evaluation.write(step, e.shape(), {&value, 1});
  return value;
}

}  // namespace treedyn::equations
