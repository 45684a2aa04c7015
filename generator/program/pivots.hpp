// What a function divides by, and how small it may get before its digits are lost.
#pragma once

#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// A divisor of a function that depends on its arguments, or an element of its output d.
///
/// As a pivot of the elimination of A it is what is left of a diagonal entry: `whole` less squares.
/// Its digits are lost where it is not far above what rounding leaves of `whole`, or of `size`
/// where the expression does not show what was taken away.
struct Pivot {
  Ref value = 0;         ///< above zero in ordinary states, if `positive`
  Ref whole = 0;         ///< the largest of the sums that it is made of; 0: nothing larger than it
  double size = 0;       ///< its own and that of its terms: the largest in some states
  bool positive = true;  ///< else it changes its sign, like the cosine of a gimbal
};

/// Every pivot once, in order of evaluation: divisors that depend on the first argument alone.
/// \param states  ordinary values of the first argument
/// O(operations) with 50 digits for each state.
std::vector<Pivot> pivots_of(const Function& function,
                             const std::vector<std::vector<double>>& states);

/// The arrays in which pivots and what they are the rest of stand behind the outputs.
inline constexpr const char* kPivotArray = "pivot";
inline constexpr const char* kWholeArray = "whole";

/// Appends both arrays to the outputs of the function.
void show_pivots(Function& function, const std::vector<Pivot>& pivots);
/// Operations of tests of pivots: a multiplication for every whole.
Cost test_cost(const std::vector<Pivot>& pivots);

}  // namespace treedyn::program
