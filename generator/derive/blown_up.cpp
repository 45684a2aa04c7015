// The size rule: numbers made of vectors, like A, are A E_3 where they multiply vectors.
#include "block/rewrite.hpp"
#include "common/error.hpp"
#include "derive/columns.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using Factor = std::vector<Expression>::const_iterator;

/// True if e (or e^T) makes vectors of numbers.
bool makes_vectors(const Expression& e, bool transposed) {
  const auto& [rows, cols] = e.shape();
  return transposed ? rows.size == 1 && cols.size == 3 : rows.size == 3 && cols.size == 1;
}

/// The fewest factors, the last or, transposed, the first, whose product fits; all if none does.
template <class Fits>
std::vector<Expression> fewest(Factor first, Factor last, bool transposed, Fits fits) {
  for (auto taken = 1; taken < last - first; ++taken) {
    const Factor begin = transposed ? first : last - taken;
    const Factor end = transposed ? first + taken : last;
    if (fits(product_of(begin, end))) {
      return {begin, end};
    }
  }
  return {first, last};
}

}  // namespace

/// A column times one number, which waits until the column is there.
int Columns::times_number(const Expression& column, bool transposed, int x) {
  const int y = apply(column, transposed, algebra_.ones(Set::kOne));
  return algebra_.scale(spread(transposed ? column.shape().cols : column.shape().rows, x), y);
}

int Columns::product(const Factors& factors, bool transposed, int x) {
  const auto is_row = [transposed](const Expression& e) {
    return (transposed ? e.shape().cols : e.shape().rows) == block::Side{};
  };
  Factor first = factors.begin();
  Factor last = factors.end();
  while (first != last) {
    const Value v = algebra_.value(x);
    const Expression rest = product_of(first, last);
    const bool symbol = v.op == Op::kOnes || v.op == Op::kLeaf;
    if (!wide_ && v.type == Type::kScalar && !symbol &&
        (transposed ? rest.shape().rows : rest.shape().cols) == block::Side{}) {
      return times_number(rest, transposed, x);
    }
    const bool asked_for = !wide_ && v.type == Type::kScalar && v.op == Op::kUnit;
    const Factors row = asked_for ? fewest(first, last, transposed, is_row) : Factors();
    const Expression& f = transposed ? *first : *(last - 1);
    std::ptrdiff_t taken = 1;
    if (!wide_ && v.type == Type::kVector && makes_vectors(f, transposed)) {
      const Factors numbers = fewest(first, last, transposed, block::has_numbers);
      taken = std::ssize(numbers);
      x = blown_up(product_of(numbers.begin(), numbers.end()), transposed, x);
    } else if (asked_for && is_row(product_of(row.begin(), row.end()))) {
      const Expression y = product_of(row.begin(), row.end());
      taken = std::ssize(row);
      x = algebra_.note(Rule::kRowOfUnit, times_column(y, transposed, x));
    } else {
      x = apply(f, transposed, x);
    }
    first += transposed ? taken : 0;
    last -= transposed ? 0 : taken;
  }
  return x;
}

/// A row (or, transposed, a column) of numbers, times a column.
int Columns::times_column(const Expression& row, bool transposed, int x) {
  const int numbers = apply(row, !transposed, algebra_.ones(Set::kOne));
  return algebra_.sum_along(Op::kCollect, Set::kOne, algebra_.scale(numbers, x));
}

/// Numbers made of vectors times vectors: (A (x) E_3) x, component by component; a column or a row
/// is numbers first.
int Columns::blown_up(const Expression& A, bool transposed, int x) {
  const block::Side& from = transposed ? A.shape().rows : A.shape().cols;
  const block::Side& to = transposed ? A.shape().cols : A.shape().rows;
  if (algebra_.value(x).op == Op::kZero) {
    return algebra_.zero(to.set, Type::kVector);
  }
  if (from.set == Set::kOne) {
    return algebra_.scale(apply(A, transposed, algebra_.ones(Set::kOne)), spread(to, x));
  }
  if (to.set == Set::kOne) {
    return times_column(A, transposed, x);
  }
  std::vector<int> components;
  for (int k = 0; k < 3; ++k) {
    components.push_back(apply(A, transposed, algebra_.component(x, k)));
  }
  return algebra_.note(Rule::kBlownUp, algebra_.assemble(components));
}

}  // namespace treedyn::derive
