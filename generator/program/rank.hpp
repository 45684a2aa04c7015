// The rank that rows have at almost every state.
#pragma once

#include "program/staged.hpp"

namespace treedyn::program {

/// Rank of a symmetric, positive semidefinite matrix in exact-looking arithmetic (50 digits):
/// pivots below 1e-25 of the largest diagonal entry are zero. \param lower  row by row
int rank_of(const std::vector<Real>& lower, int rows);

/// The solve behind stage 0 of a function whose first outputs are K (lower half, row by row): its
/// zeros, and its rank at a pseudo-random state.
RowSolve solve_of(const Function& function, int rows);

}  // namespace treedyn::program
