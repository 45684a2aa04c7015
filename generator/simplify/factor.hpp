// A = L^T Delta L without fill-in, EQUATIONS.md 7.4.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "simplify/spatial.hpp"

namespace treedyn::simplify {

/// Symmetric matrix by (row, column) with row >= column; entries that are structurally zero are
/// absent.
using SparseSymmetric = std::map<std::pair<int, int>, Expr>;

/// L (unit lower triangular) and Delta of a symmetric matrix, eliminated from the last row to the
/// first. Zero entries stay zero and cost nothing: with fathers before sons only ancestor entries
/// are touched.
class Factorization {
 public:
  /// \param size rows of the matrix; entries that are absent are zero.
  Factorization(Graph& graph, int size, const SparseSymmetric& matrix);

  /// x of A x = right, by one sweep to the root and one back.
  [[nodiscard]] std::vector<Expr> solve(std::vector<Expr> right) const;
  /// y of L^T y = right: the sweep to the root.
  [[nodiscard]] std::vector<Expr> to_root(std::vector<Expr> right) const;
  /// The same for a column whose absent entries are zero; the ancestors of its entries join them.
  [[nodiscard]] std::map<int, Expr> to_root(std::map<int, Expr> right) const;
  /// x of L x = right: the sweep from the root.
  [[nodiscard]] std::vector<Expr> from_root(std::vector<Expr> right) const;

  [[nodiscard]] Expr pivot(int k) const { return pivot_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] Expr inverse_pivot(int k) const { return inverse_[static_cast<std::size_t>(k)]; }
  /// The rows of L^-1, diagonal included; its zero pattern is that of L for a tree.
  [[nodiscard]] std::vector<std::map<int, Expr>> inverse_of_lower() const;
  [[nodiscard]] int size() const { return static_cast<int>(pivot_.size()); }
  /// The columns i < k with L_ki not zero, descending.
  [[nodiscard]] const std::vector<std::pair<int, Expr>>& row(int k) const {
    return rows_[static_cast<std::size_t>(k)];
  }

 private:
  Graph* graph_;
  std::vector<std::vector<std::pair<int, Expr>>> rows_;
  std::vector<Expr> pivot_;
  std::vector<Expr> inverse_;
};

}  // namespace treedyn::simplify
