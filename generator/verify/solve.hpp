// Systems of equations in 50 digits, and how well they can be solved.
#pragma once

#include <vector>

#include "common/real.hpp"

namespace treedyn {

/// What solves S x = b, and the smallest pivot as a part of its own diagonal entry.
struct Solution {
  std::vector<Real> x;
  Real least = 1;
};

/// By Gaussian elimination with diagonal pivots; S (row by row) positive semidefinite, components
/// behind the rank are zero: pivots of at most `least` of their own diagonal entry.
Solution solved(std::vector<std::vector<Real>> S, std::vector<Real> b,
                const Real& least = Real("1e-25"));

/// x with K K x = K b for a symmetric K: K x is as near to b as it can be. Its smallest pivot is
/// the root of that of K K.
Solution least_squares(const std::vector<std::vector<Real>>& K, const std::vector<Real>& b);

}  // namespace treedyn
