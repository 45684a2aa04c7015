// The rank that rows have at almost every state.
#pragma once

#include "program/staged.hpp"

namespace treedyn::program {

/// Rank of a symmetric, positive semidefinite matrix in exact-looking arithmetic (50 digits):
/// pivots below 1e-25 of their own diagonal entry are zero. \param lower  row by row
int rank_of(const std::vector<Real>& lower, int rows);

/// The solve behind stage 0 of a function whose first outputs are K (lower half, row by row) and
/// whose first input is q: its zeros, and the sizes of its rows in some states.
/// \param rank    where the constraints hold; -1: that of a pseudo-random state
/// \param states  values of q
RowSolve solve_of(const Function& function, int rows, int rank,
                  const std::vector<std::vector<double>>& states);

}  // namespace treedyn::program
