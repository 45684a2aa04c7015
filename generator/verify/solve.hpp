// Systems of equations in 50 digits, and how well they can be solved.
#pragma once

#include <vector>

#include "common/real.hpp"

namespace treedyn::verify {

using Values = std::vector<Real>;
using Matrix = std::vector<Values>;  ///< row by row

Real dot(const Values& a, const Values& b);
/// The largest magnitude; 0 of none.
Real largest(const Values& values);

/// What solves S x = b, and the smallest pivot as a part of its own diagonal entry.
struct Solution {
  std::vector<Real> x;
  Real least = 1;
};

/// By Gaussian elimination with diagonal pivots; s positive semidefinite, components
/// behind the rank are zero: pivots of at most `least` of their own diagonal entry.
Solution solved(Matrix s, Values b, const Real& least = Real("1e-25"));

/// x for which K x is as near to b as it can be, K symmetric and positive semidefinite, by
/// K = L L^T: x = L (L^T L)^-2 L^T b. Pivots of K as in `solved`; the smallest is of K or of L^T L.
Solution least_squares(const Matrix& K, const Values& b);

}  // namespace treedyn::verify
