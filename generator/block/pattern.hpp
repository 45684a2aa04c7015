// Zero patterns of block matrices, derived from the reachability matrix D (EQUATIONS.md 7.1).
#pragma once

#include <string>
#include <tuple>
#include <vector>

namespace treedyn::block {

/// All that block expressions know of a tree.
struct Index {
  std::vector<int> father;     ///< per link, -1 for the ground; smaller than the link's own index
  std::vector<bool> revolute;  ///< per link
  std::vector<int> carrier;    ///< per point: the link that carries it, -1 for the ground
  std::vector<std::vector<int>>
      row_points;  ///< per row of reactions: the points it acts on, ascending

  [[nodiscard]] int links() const { return static_cast<int>(father.size()); }
  [[nodiscard]] int points() const { return static_cast<int>(carrier.size()); }
  [[nodiscard]] int rows() const { return static_cast<int>(row_points.size()); }
};

/// Positions of the blocks of a matrix that may differ from zero, row by row.
class Pattern {
 public:
  Pattern() = default;
  /// \pre the columns of every row ascend.
  Pattern(int cols, const std::vector<std::vector<int>>& columns_of_row);

  [[nodiscard]] int rows() const { return static_cast<int>(start_.size()) - 1; }
  [[nodiscard]] int cols() const { return cols_; }
  /// Number of blocks; they are numbered row by row.
  [[nodiscard]] int blocks() const { return static_cast<int>(column_.size()); }
  /// First block of row i; `begin(rows())` is the number of blocks.
  [[nodiscard]] int begin(int i) const { return start_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] int end(int i) const { return begin(i + 1); }
  [[nodiscard]] int column(int block) const { return column_[static_cast<std::size_t>(block)]; }
  /// The block at (i, j), -1 if it is zero. O(log of the row's blocks).
  [[nodiscard]] int find(int i, int j) const;

  /// Calls visit(row, column, block) for every block, row by row.
  template <class Visit>
  void visit(const Visit& visit) const {
    for (int i = 0; i < rows(); ++i) {
      for (int block = begin(i); block < end(i); ++block) {
        visit(i, column(block), block);
      }
    }
  }
  /// Calls visit(column, block) for every block of row i.
  template <class Visit>
  void visit_row(int i, const Visit& visit) const {
    for (int block = begin(i); block < end(i); ++block) {
      visit(column(block), block);
    }
  }

  friend bool operator==(const Pattern&, const Pattern&) = default;
  friend bool operator<(const Pattern& a, const Pattern& b) {
    return std::tie(a.cols_, a.start_, a.column_) < std::tie(b.cols_, b.start_, b.column_);
  }

 private:
  int cols_ = 0;
  std::vector<int> start_{0};
  std::vector<int> column_;
};

Pattern transpose(const Pattern& a);
Pattern unite(const Pattern& a, const Pattern& b);
Pattern product(const Pattern& a, const Pattern& b);
Pattern diagonal(int n);
Pattern full(int rows, int cols);

/// D of the tree: block (i,j) iff j is i or an ancestor of i.
Pattern reachability(const Index& index);

/// One line a row: 'x' for a block, '.' for a zero block.
std::string to_text(const Pattern& pattern);

}  // namespace treedyn::block
