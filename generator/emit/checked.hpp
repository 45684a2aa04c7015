// NAME_checked: the same statements as NAME, and a status.
#pragma once

#include <string>
#include <vector>

#include "emit/body.hpp"
#include "program/pivots.hpp"

namespace treedyn::emit {

/// A function that tells whether its results can be trusted.
struct Checked {
  program::Signature signature;  ///< what callers see
  program::Function function;    ///< its outputs end with local arrays: the pivots, their wholes
  std::vector<program::Pivot> pivots;
};

/// The sibling of a function whose pivots are `pivots`: the same operations on the same operands,
/// so the same bits.
Checked checked_sibling(const program::Function& function, std::vector<program::Pivot> pivots);

/// What rounding leaves of a pivot that is zero, of `size` rows, as a part of what it was taken
/// from.
double pivot_rounding(int size, Scalar scalar);

/// A positive number with two digits, of normal size.
std::string short_literal(double value, const Target& target);

/// Statements that add status::rank_lost to `failed` where a pivot has lost its digits: one
/// comparison with a number, one with what the pivot is left of. \param dof  rows of A
std::vector<std::string> pivot_tests(const std::vector<program::Pivot>& pivots, int dof,
                                     const Target& target);

/// That of the function, and a multiplication for every whole.
program::Cost cost(const Checked& checked);

/// The definition of the function.
std::string checked_text(const Checked& checked, const Body& body, const Target& target);

/// What tells numbers from the rest.
std::string check_text(const Target& target);

}  // namespace treedyn::emit
