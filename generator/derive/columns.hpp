// Block expressions times columns, without a matrix: R0, R1, R2, R4.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "block/block.hpp"
#include "block/rewrite.hpp"
#include "derive/algebra.hpp"

namespace treedyn::derive {

class Columns {
 public:
  /// \param wide  columns of blocks with three columns: x is a tensor or, if its blocks have one
  /// row, a vector
  explicit Columns(Values& values, bool wide = false) : algebra_(values), wide_(wide) {}

  /// e x, or e^T x.
  int apply(const block::Expression& e, bool transposed, int x);
  /// The same for a wide x; nothing if some block would be neither of a kind nor one row.
  std::optional<int> wide(const block::Expression& e, bool transposed, int x);
  /// x^T e c for a wide x and a column c: rows come from the left as far as their blocks have a
  /// kind, columns from the right; nothing if they do not meet.
  std::optional<int> meet(const block::Expression& e, int x, int c);
  /// The column e.
  int column(const block::Expression& e) { return narrow(e, Set::kOne); }
  Algebra& algebra() { return algebra_; }

 private:
  using Factors = std::vector<block::Expression>;

  int leaf(const block::Expression& e, bool transposed, int x);
  int full_leaf(const block::Expression& e, bool transposed, int x);
  int diagonal(const block::Shape& shape, int blocks, bool transposed, int x);
  int sum(const Factors& terms, bool transposed, int x);
  int product(const Factors& factors, bool transposed, int x);
  [[nodiscard]] std::ptrdiff_t asked_row(Factors::const_iterator first,
                                         Factors::const_iterator last, bool transposed,
                                         int x) const;
  [[nodiscard]] bool waits(const block::Side& from, const block::Side& to, int x) const;
  int times_number(const block::Expression& column, bool transposed, int x);
  int times_column(const block::Expression& row, bool transposed, int x);
  int blown_up(const block::Expression& A, bool transposed, int x);
  /// Λ(Y) x, or its transpose.
  int skew(const block::Expression& Y, bool transposed, int x);
  int skew_of_product(Factors factors, bool transposed, int x);
  int cross_word(const block::Expression& P, int theta);
  int by_components(const block::Expression& Y, bool transposed, int x);
  int spread(const block::Side& side, int x);
  /// The sum of what becomes of the terms.
  template <class Of>
  int of_terms(const Factors& terms, Of of) {
    Terms result;
    for (const block::Expression& term : terms) {
      result.emplace_back(Ratio{}, of(term));
    }
    return algebra_.linear(result);
  }
  /// e times numbers 1.
  int narrow(const block::Expression& e, Set ones);
  int wide_diagonal(Type type, int blocks, bool transposed, int x);
  int wide_cross(int u, int x);
  int wide_skew(const block::Expression& Y, bool transposed, int x);
  int multiple_of_identity(int x);
  int apply_narrow(const block::Expression& e, int x);
  int met(const block::Expression& e, int x, int c);
  int contract(int x, int c);
  int contract_skew(int r, int c);
  void require_narrow() const;

  Algebra algebra_;
  bool wide_;
};

/// E, or a block diagonal made of block diagonals.
bool is_diagonal(const block::Expression& e);

}  // namespace treedyn::derive
