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

/// The fewest factors, the last or, transposed, the first, whose product is a matrix of numbers.
std::vector<Expression> of_numbers(Factor first, Factor last, bool transposed) {
  for (auto n = last - first; n > 0; --n) {
    const auto skipped = n - 1;
    const Factor begin = transposed ? first : first + skipped;
    const Factor end = transposed ? last - skipped : last;
    if (block::has_numbers(product_of(begin, end))) {
      return {begin, end};
    }
  }
  TREEDYN_EXPECT(false);
  return {};
}

}  // namespace

int Columns::product(const Factors& factors, bool transposed, int x) {
  Factor first = factors.begin();
  Factor last = factors.end();
  while (first != last) {
    const Expression& f = transposed ? *first : *(last - 1);
    std::ptrdiff_t taken = 1;
    if (!wide_ && algebra_.value(x).type == Type::kVector && makes_vectors(f, transposed)) {
      const Factors numbers = of_numbers(first, last, transposed);
      taken = std::ssize(numbers);
      x = blown_up(product_of(numbers.begin(), numbers.end()), transposed, x);
    } else {
      x = apply(f, transposed, x);
    }
    first += transposed ? taken : 0;
    last -= transposed ? 0 : taken;
  }
  return x;
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
    const int row = apply(A, !transposed, algebra_.ones(Set::kOne));
    return algebra_.sum_along(Op::kCollect, Set::kOne, algebra_.scale(row, x));
  }
  std::vector<int> components;
  for (int k = 0; k < 3; ++k) {
    components.push_back(apply(A, transposed, algebra_.component(x, k)));
  }
  return algebra_.note(Rule::kBlownUp, algebra_.assemble(components));
}

}  // namespace treedyn::derive
