// Numbers of joints (and rows of reactions) and matrices of them, as R12 derives them: zeros are
// absent and cost nothing.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "derive/derive.hpp"
#include "formulate/spatial.hpp"
#include "program/function.hpp"

namespace treedyn::formulate {

/// Symmetric matrix by (row, column) with row >= column; entries that are structurally zero are
/// absent.
using SparseSymmetric = std::map<std::pair<int, int>, Expr>;

/// A row of a matrix; of a column: its number at place 0.
using SparseRow = std::map<int, Expr>;
using SparseRows = std::vector<SparseRow>;

SparseRows sparse(int size, const SparseSymmetric& lower);
SparseRows sparse(const std::vector<Expr>& column);
/// The one number of every row.
std::vector<Expr> column_of(const SparseRows& rows);

class Numbers {
 public:
  /// What a leaf stands for; of symmetric matrices the lower half.
  using Leaf = std::function<SparseRows(const std::string&)>;

  /// \param size  of what counts joints
  /// \param derivation  outlives this
  /// \param reactions  rows of reactions
  /// \param passive  joints without a drive
  /// \throws std::range_error for a pivot that is zero
  Numbers(Graph& graph, int size, const derive::Derivation& derivation, const Leaf& leaf,
          int reactions = 0, int passive = 0);

  [[nodiscard]] const SparseRows& root(std::size_t k = 0) const {
    return rows_[static_cast<std::size_t>(derivation_.roots[k])];
  }
  /// Operations that the values took, by their number in the derivation.
  [[nodiscard]] const std::vector<program::Cost>& costs() const { return costs_; }

 private:
  void run(int id, const Leaf& leaf);
  void eliminate(int id, int until);
  void hand_on(int id, int below, std::size_t k);
  void make(int id, std::size_t k);
  [[nodiscard]] SparseRow row(int id, std::size_t k) const;
  [[nodiscard]] SparseRow linear(const derive::Value& v, std::size_t k) const;
  [[nodiscard]] SparseRow transposed(const derive::Value& v, std::size_t k) const;
  [[nodiscard]] SparseRow applied(const derive::Value& v, std::size_t k) const;
  [[nodiscard]] SparseRow congruent(const derive::Value& v, std::size_t i) const;
  [[nodiscard]] int defined(int id) const;
  [[nodiscard]] std::size_t size_of(block::Set set) const;
  [[nodiscard]] const SparseRow& of(int id, std::size_t k) const {
    return rows_[static_cast<std::size_t>(defined(id))][k];
  }

  Graph& graph_;
  std::size_t size_;
  std::size_t reactions_;
  std::size_t passive_;
  const derive::Derivation& derivation_;
  std::vector<int> needed_;
  std::vector<SparseRows> rows_;  ///< by value
  std::vector<program::Cost> costs_;
};

}  // namespace treedyn::formulate
