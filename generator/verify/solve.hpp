// Systems of equations in 50 digits, and how well they can be solved.
#pragma once

#include <vector>

#include "common/real.hpp"

namespace treedyn {

using Values = std::vector<Real>;
using Matrix = std::vector<Values>;  ///< row by row

/// What solves S x = b, and the smallest pivot as a part of its own diagonal entry.
struct Solution {
  std::vector<Real> x;
  Real least = 1;
};

/// By Gaussian elimination with diagonal pivots; s positive semidefinite, components
/// behind the rank are zero: pivots of at most `least` of their own diagonal entry.
Solution solved(Matrix s, Values b, const Real& least = Real("1e-25"));

/// x with K K x = K b for a symmetric K: K x is as near to b as it can be. Its smallest pivot is
/// the root of that of K K.
Solution least_squares(const Matrix& K, const Values& b);

}  // namespace treedyn
