// Solving with the joint-space inertia matrix, EQUATIONS.md 7.4.
#pragma once

#include <Eigen/Core>

namespace treedyn::engine {

/// A = L^T Δ L in place, from the last link to the first: strictly below the diagonal of `A` stands
/// L, on it Δ. No fill-in where A comes from a tree with fathers first: exact zeros are skipped.
/// Only the lower half is read. \pre A is symmetric and positive definite.
template <class Matrix>
void factorize(Matrix& A) {
  using Scalar = typename Matrix::Scalar;
  for (Eigen::Index k = A.rows() - 1; k >= 0; --k) {
    for (Eigen::Index i = k - 1; i >= 0; --i) {
      if (A(k, i) == Scalar(0)) {
        continue;
      }
      const Scalar a = A(k, i) / A(k, k);
      A.row(i).head(i + 1) -= a * A.row(k).head(i + 1);
      A(k, i) = a;
    }
  }
}

/// Solves A x = b in place with the factors of `factorize`.
template <class Matrix, class Vector>
void solve_factorized(const Matrix& LD, Vector& x) {
  const Eigen::Index n = LD.rows();
  for (Eigen::Index k = n - 1; k >= 0; --k) {  // L^T y = b
    for (Eigen::Index i = 0; i < k; ++i) {
      x(i) -= LD(k, i) * x(k);
    }
  }
  for (Eigen::Index k = 0; k < n; ++k) {  // L x = Δ^-1 y
    x(k) /= LD(k, k);
    for (Eigen::Index i = 0; i < k; ++i) {
      x(k) -= LD(k, i) * x(i);
    }
  }
}

}  // namespace treedyn::engine
