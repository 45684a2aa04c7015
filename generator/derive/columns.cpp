#include "derive/columns.hpp"

#include <algorithm>
#include <utility>

#include "block/rewrite.hpp"
#include "common/error.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using block::has_numbers;
using block::is_of_numbers;
using block::Kind;
using block::Structure;

Type type_of(const block::Shape& block) {
  return block.rows.size == 1   ? Type::kScalar
         : block.cols.size == 1 ? Type::kVector
                                : Type::kTensor;
}

bool is_minus(const Expression& e, const char* name) {
  return e.kind() == Kind::kScaled && e.node().factor == Ratio{-1, 1} &&
         is_leaf(unnamed(e.operands().front()), name);
}

/// D - E, or its transpose.
enum class Strict { kNo, kPath, kSubtree };
Strict strict(const Expression& a, const Expression& b) {
  if (!is_minus(b, "E")) {
    return Strict::kNo;
  }
  const Expression& x = unnamed(a);
  if (x.kind() == Kind::kTranspose && is_leaf(unnamed(x.operands().front()), "D")) {
    return Strict::kSubtree;
  }
  return is_leaf(x, "D") ? Strict::kPath : Strict::kNo;
}

/// A product L v R with numbers in L and R.
struct Parted {
  std::vector<Expression> left, middle, right;
  Ratio factor;
};
Parted parted(const Expression& product) {
  Parted result;
  std::vector<Expression> factors;
  block::flatten(product, factors, result.factor);
  const auto begin = std::ranges::find_if_not(factors, has_numbers);
  auto end = std::find_if(factors.rbegin(), factors.rend(), is_vector).base();
  while (end != factors.end() && is_diagonal(*(end - 1)) && is_diagonal(*end)) {
    ++end;
  }
  result.left = {factors.begin(), begin};
  result.middle = {begin, end};
  result.right = {end, factors.end()};
  return result;
}

/// True for a sum of words with one diagonal of vectors in each.
bool is_sum_of_words(const Expression& P) {
  if (is_diagonal(P)) {
    return true;
  }
  switch (P.kind()) {
    case Kind::kNamed:
    case Kind::kScaled:
    case Kind::kSum:
      return std::ranges::all_of(P.operands(), is_sum_of_words);
    case Kind::kProduct: {
      const Parted parts = parted(P);
      const bool shorter = !parts.left.empty() || !parts.right.empty() || parts.middle.size() == 1;
      const bool numbers = std::ranges::all_of(parts.left, is_of_numbers) &&
                           std::ranges::all_of(parts.right, is_of_numbers);
      return shorter && numbers &&
             is_sum_of_words(product_of(parts.middle.begin(), parts.middle.end()));
    }
    default:
      return false;
  }
}

}  // namespace

bool is_diagonal(const Expression& e) {
  switch (e.kind()) {
    case Kind::kLeaf:
      return block::is_diagonal_leaf(e);
    case Kind::kDiagonal:
      return true;
    default:
      return std::ranges::all_of(e.operands(), is_diagonal);
  }
}

int Columns::spread(const block::Side& side, int x) {
  return algebra_.sum_along(Op::kSpread, side.set, x);
}

int Columns::apply(const Expression& e, bool transposed, int x) {
  const Factors& operands = e.operands();
  switch (e.kind()) {
    case Kind::kLeaf:
      return leaf(e, transposed, x);
    case Kind::kNamed:
      return !wide_ && algebra_.value(x).type == Type::kVector && has_numbers(e) &&
                     !is_of_numbers(e)
                 ? blown_up(e, transposed, x)
                 : apply(operands.front(), transposed, x);
    case Kind::kSum:
      return sum(operands, transposed, x);
    case Kind::kProduct:
      return product(operands, transposed, x);
    case Kind::kScaled:
      return algebra_.linear({{e.node().factor, apply(operands.front(), transposed, x)}});
    case Kind::kTranspose:
      return apply(operands.front(), !transposed, x);
    case Kind::kSkew:
      return skew(operands.front(), transposed, x);
    case Kind::kSkewTranspose:
      return algebra_.negative(skew(operands.front(), transposed, x));
    case Kind::kDiagonal:
      return diagonal(e.shape(), column(operands.front()), transposed, x);
  }
  return x;
}

int Columns::leaf(const Expression& e, bool transposed, int x) {
  const block::Node& node = e.node();
  const Set to = transposed ? e.shape().cols.set : e.shape().rows.set;
  switch (node.structure) {
    case Structure::kIdentity:
      return x;
    case Structure::kReachability:
      return algebra_.sum_along(transposed ? Op::kSubtree : Op::kPath, to, x);
    case Structure::kFather:
      return algebra_.sum_along(transposed ? Op::kSons : Op::kFather, to, x);
    case Structure::kCarrier:
      return algebra_.sum_along(transposed ? Op::kPick : Op::kGather, to, x);
    case Structure::kOnes:
      return algebra_.sum_along(transposed ? Op::kCollect : Op::kSpread, to, x);
    case Structure::kRevolute:
    case Structure::kDiagonal:
      return diagonal(e.shape(),
                      algebra_.leaf(node.name == "q̇^d" ? "q̇" : node.name, e.shape().rows.set,
                                    type_of(e.shape())),
                      transposed, x);
    default:
      return full_leaf(e, transposed, x);
  }
}

/// A column, or one 3x3 block.
int Columns::full_leaf(const Expression& e, bool transposed, int x) {
  const block::Side& rows = e.shape().rows;
  TREEDYN_EXPECT(e.shape().cols.set == Set::kOne && rows.set != Set::kRows);
  if (!transposed || type_of(e.shape()) != Type::kScalar) {
    require_narrow();
  }
  const int blocks = algebra_.leaf(e.node().name, rows.set, type_of(e.shape()));
  if (!transposed) {
    return diagonal(e.shape(), blocks, false, spread(rows, x));
  }
  const int inner = diagonal(e.shape(), blocks, true, x);
  return algebra_.sum_along(Op::kCollect, Set::kOne, inner);
}

/// Every block times the block of x.
int Columns::diagonal(const block::Shape& shape, int blocks, bool transposed, int x) {
  const Type type = type_of(shape);
  if (wide_ && type != Type::kScalar) {
    return wide_diagonal(type, blocks, transposed, x);
  }
  switch (type) {
    case Type::kScalar:
      return algebra_.scale(blocks, x);
    case Type::kVector:
      return transposed ? algebra_.dot(blocks, x) : algebra_.scale(x, blocks);
    case Type::kTensor:
      break;
  }
  return transposed ? algebra_.apply_transposed(blocks, x) : algebra_.apply(blocks, x);
}

int Columns::sum(const Factors& terms, bool transposed, int x) {
  if (terms.size() == 2) {
    const Strict kind = strict(terms[0], terms[1]);
    if (kind != Strict::kNo) {
      const bool down = (kind == Strict::kPath) != transposed;
      return algebra_.sum_along(down ? Op::kPathStrict : Op::kSubtreeStrict, Set::kLinks, x);
    }
    if (is_leaf(terms[0], "E") && is_minus(terms[1], "σ")) {
      return algebra_.scale(algebra_.leaf("E-σ", Set::kLinks, Type::kScalar), x);
    }
  }
  return algebra_.note(Rule::kDistribute, of_terms(terms, [&](const Expression& term) {
                         return apply(term, transposed, x);
                       }));
}

int Columns::skew(const Expression& Y, bool transposed, int x) {
  if (is_diagonal(Y)) {
    const int u = narrow(Y, Y.shape().cols.set);
    const int y = wide_ ? wide_cross(u, x) : algebra_.cross(u, x);
    return transposed ? algebra_.negative(y) : y;
  }
  if (wide_) {
    return wide_skew(Y, transposed, x);
  }
  if (Y.shape().cols == block::Side{}) {  // one column
    const int u = column(Y);
    return transposed ? algebra_.sum_along(Op::kCollect, Set::kOne, algebra_.cross(x, u))
                      : algebra_.cross(u, spread(Y.shape().rows, x));
  }
  switch (Y.kind()) {
    case Kind::kNamed:
      return skew(Y.operands().front(), transposed, x);
    case Kind::kScaled:
      return algebra_.linear({{Y.node().factor, skew(Y.operands().front(), transposed, x)}});
    case Kind::kSum:
      return of_terms(Y.operands(),
                      [&](const Expression& term) { return skew(term, transposed, x); });
    case Kind::kProduct: {
      Factors factors;
      Ratio factor;
      block::flatten(Y, factors, factor);
      return algebra_.linear({{factor, skew_of_product(std::move(factors), transposed, x)}});
    }
    default:
      return by_components(Y, transposed, x);
  }
}

/// R2: numbers left and right of the vectors leave Λ; what stays is a diagonal, a sum or R4.
int Columns::skew_of_product(Factors factors, bool transposed, int x) {
  auto v = std::find_if(factors.rbegin(), factors.rend(), is_vector).base() - 1;
  auto end = v + 1;
  while (end != factors.end() && is_diagonal(*v) && is_diagonal(*end)) {
    ++end;
  }
  auto begin = std::find_if_not(factors.begin(), v, has_numbers);
  const Factors left(factors.begin(), begin);
  const Factors right(end, factors.end());
  if (!left.empty() || !right.empty()) {
    const Expression core = product_of(begin, end);
    const int inner = product(transposed ? left : right, transposed, x);
    return algebra_.note(Rule::kSkewPasses, product(transposed ? right : left, transposed,
                                                    skew(core, transposed, inner)));
  }
  if (v->kind() == Kind::kSum) {
    const Factors terms = v->operands();
    return of_terms(terms, [&](const Expression& term) {
      *v = term;
      return skew(product_of(factors.begin(), factors.end()), transposed, x);
    });
  }
  const Expression whole = product_of(factors.begin(), factors.end());
  const bool word =
      factors.front().kind() == Kind::kSkew || factors.front().kind() == Kind::kSkewTranspose;
  if (transposed || !word || begin == v || v - begin != 1 || !is_diagonal(*v) ||
      !is_sum_of_words(factors.front().operands().front())) {
    return by_components(whole, transposed, x);
  }
  const Expression u = product_of(v, end);
  // Λ(Λ(P) u) x = (P×u)×x = x×(u×P)
  const int theta = algebra_.skew_product(x, narrow(u, u.shape().cols.set));
  const int result =
      algebra_.note(Rule::kCrossWords, cross_word(factors.front().operands().front(), theta));
  return factors.front().kind() == Kind::kSkew ? result : algebra_.negative(result);
}

/// R4: Σ_j P_ij of every link with the 3x3 blocks θ_j in front: P = L s R gives L (R θ) s.
int Columns::cross_word(const Expression& P, int theta) {
  if (is_diagonal(P)) {
    const int s = narrow(P, P.shape().cols.set);
    return algebra_.apply(theta, s);
  }
  switch (P.kind()) {
    case Kind::kNamed:
      return cross_word(P.operands().front(), theta);
    case Kind::kScaled:
      return algebra_.linear({{P.node().factor, cross_word(P.operands().front(), theta)}});
    case Kind::kSum:
      return of_terms(P.operands(),
                      [&](const Expression& term) { return cross_word(term, theta); });
    default:
      break;
  }
  const Parted parts = parted(P);
  const int inner = product(parts.right, false, theta);
  const int middle = cross_word(product_of(parts.middle.begin(), parts.middle.end()), inner);
  return algebra_.linear({{parts.factor, product(parts.left, false, middle)}});
}

/// Λ(Y) x = Σ (Y x_k)×e_k; (Λ(Y))^T x = Σ e_k Y^T (e_k×x). Holds for every Y.
int Columns::by_components(const Expression& Y, bool transposed, int x) {
  require_narrow();
  const auto unit = [&](int k, Set set) {
    const int zero = algebra_.zero(set, Type::kScalar);
    std::vector<int> components(3, zero);
    components[static_cast<std::size_t>(k)] = algebra_.ones(set);
    return algebra_.assemble(components);
  };
  Terms result;
  for (int k = 0; k < 3; ++k) {
    if (transposed) {
      const Set from = Y.shape().rows.set;
      const int row = apply(Y, true, algebra_.cross(unit(k, from), x));
      result.emplace_back(Ratio{}, algebra_.scale(row, unit(k, Y.shape().cols.set)));
    } else {
      const int y = apply(Y, false, algebra_.component(x, k));
      result.emplace_back(Ratio{}, algebra_.cross(y, unit(k, Y.shape().rows.set)));
    }
  }
  return algebra_.note(Rule::kComponents, algebra_.linear(result));
}

}  // namespace treedyn::derive
