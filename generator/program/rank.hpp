// The rank that rows have at almost every state.
#pragma once

#include "program/row_rank.hpp"
#include "program/staged.hpp"

namespace treedyn::program {

/// Rank of a symmetric, positive semidefinite matrix in exact-looking arithmetic (50 digits):
/// pivots below 1e-25 of their own diagonal entry are zero. \param lower  row by row
int rank_of(const std::vector<Real>& lower, int rows);

/// The solve behind stage 0 of a function whose first outputs are K (lower half, row by row) and
/// whose first input is q: its zeros, and the sizes of its rows in some states.
/// \param ordinary  of the same rows; if they hold nowhere the rank is that of a pseudo-random
/// state
RowSolve solve_of(const Function& function, int rows, const OrdinaryRows& ordinary);

}  // namespace treedyn::program
