// Block expressions times columns, without a matrix: R0, R1, R2, R4.
#pragma once

#include "block/block.hpp"
#include "derive/algebra.hpp"

namespace treedyn::derive {

class Columns {
 public:
  explicit Columns(Values& values) : algebra_(values) {}

  /// e x, or e^T x.
  int apply(const block::Expression& e, bool transposed, int x);
  /// The column e.
  int column(const block::Expression& e) { return apply(e, false, algebra_.ones(Set::kOne)); }
  Algebra& algebra() { return algebra_; }

 private:
  using Factors = std::vector<block::Expression>;

  int leaf(const block::Expression& e, bool transposed, int x);
  int full_leaf(const block::Expression& e, bool transposed, int x);
  int diagonal(const block::Shape& shape, int blocks, bool transposed, int x);
  int sum(const Factors& terms, bool transposed, int x);
  int product(const Factors& factors, bool transposed, int x);
  /// Λ(Y) x, or its transpose.
  int skew(const block::Expression& Y, bool transposed, int x);
  int skew_of_product(Factors factors, bool transposed, int x);
  int cross_word(const block::Expression& P, int theta);
  int by_components(const block::Expression& Y, bool transposed, int x);
  int spread(const block::Side& side, int x);

  Algebra algebra_;
};

/// E, or a block diagonal made of block diagonals.
bool is_diagonal(const block::Expression& e);

}  // namespace treedyn::derive
