// The size rule: numbers made of vectors, like A, are A E_3 where they multiply vectors.
#include <algorithm>
#include <cstddef>

#include "block/rewrite.hpp"
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

/// How many factors from the last on or, transposed, from the first, fit together, the
/// fewest; 0 if there are none.
template <class Fits>
std::ptrdiff_t fewest(Factor first, Factor last, bool transposed, Fits fits) {
  for (std::ptrdiff_t taken = 1; taken <= last - first; ++taken) {
    if (transposed ? fits(first, first + taken) : fits(last - taken, last)) {
      return taken;
    }
  }
  return 0;
}

}  // namespace

/// True if a number x of one side waits until the column is there: where it is one of numbers or
/// a single vector, or serves all columns that are asked for.
bool Columns::waits(const block::Side& from, const block::Side& to, int x) const {
  const Value& v = algebra_.value(x);
  const bool number = !wide_ && v.type == Type::kScalar && v.op != Op::kOnes && v.op != Op::kLeaf;
  return number && from == block::Side{} &&
         (to.size == 1 || to.set == Set::kOne || algebra_.of_unit(x));
}

int Columns::times_number(const Expression& column, bool transposed, int x) {
  const int y = apply(column, transposed, algebra_.ones(Set::kOne));
  return algebra_.scale(spread(transposed ? column.shape().cols : column.shape().rows, x), y);
}

/// How many factors are the row (or, transposed, the column) whose number x asks for: of links, or
/// of the vectors e_k; 0 if there is none.
std::ptrdiff_t Columns::asked_row(Factor first, Factor last, bool transposed, int x) const {
  const auto row = [transposed](Factor begin, Factor end) -> std::optional<block::Shape> {
    Factors seen(begin, end);
    if (transposed) {
      std::ranges::reverse(seen);
      std::ranges::transform(seen, seen.begin(), block::transpose);
    }
    return block::blows_up(seen, 1) ? std::nullopt
                                    : std::optional(product_of(seen.begin(), seen.end()).shape());
  };
  const Value& v = algebra_.value(x);
  if (!wide_ && v.op == Op::kAssemble && v.set == Set::kOne) {
    const block::Shape shape = *row(transposed ? first : last - 1, transposed ? first + 1 : last);
    return shape == block::Shape{{}, {Set::kOne, 3}} ? 1 : 0;
  }
  if (wide_ || v.op != Op::kUnit || v.type != Type::kScalar) {
    return 0;
  }
  return fewest(first, last, transposed, [&](Factor begin, Factor end) {
    const std::optional<block::Shape> shape = row(begin, end);
    return shape && shape->rows == block::Side{};
  });
}

int Columns::product(const Factors& factors, bool transposed, int x) {
  const auto has_numbers = [](Factor begin, Factor end) {
    return block::has_numbers(product_of(begin, end));
  };
  Factor first = factors.begin();
  Factor last = factors.end();
  while (first != last) {
    const Expression& f = transposed ? *first : *(last - 1);
    if (waits(transposed ? f.shape().rows : f.shape().cols,
              transposed ? (last - 1)->shape().cols : first->shape().rows, x)) {
      return times_number(product_of(first, last), transposed, x);
    }
    const bool blows_up =
        !wide_ && algebra_.value(x).type == Type::kVector && makes_vectors(f, transposed);
    const std::ptrdiff_t taken = blows_up ? fewest(first, last, transposed, has_numbers)
                                          : asked_row(first, last, transposed, x);
    if (taken == 0) {
      x = apply(f, transposed, x);
    } else {
      const Expression y =
          transposed ? product_of(first, first + taken) : product_of(last - taken, last);
      x = blows_up ? blown_up(y, transposed, x)
                   : algebra_.note(Rule::kRowOfUnit, times_column(y, transposed, x));
    }
    first += transposed ? std::max<std::ptrdiff_t>(taken, 1) : 0;
    last -= transposed ? 0 : std::max<std::ptrdiff_t>(taken, 1);
  }
  return x;
}

/// A row (or, transposed, a column) of numbers, times a column.
int Columns::times_column(const Expression& row, bool transposed, int x) {
  const int numbers = apply(row, !transposed, algebra_.ones(Set::kOne));
  if ((transposed ? row.shape().rows : row.shape().cols).set == Set::kOne) {
    return algebra_.dot(numbers, x);
  }
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
