// Columns of 3x3 blocks: multiples of E, skew blocks and single rows keep their kind (R7').
#include <utility>

#include "block/rewrite.hpp"
#include "derive/columns.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;

/// A block that is neither a multiple of E nor skew.
struct NoKind {};

}  // namespace

void Columns::require_narrow() const {
  if (wide_) {
    throw NoKind{};
  }
}

std::optional<int> Columns::wide(const Expression& e, bool transposed, int x) {
  try {
    return apply(e, transposed, x);
  } catch (const NoKind&) {
    return std::nullopt;
  }
}

int Columns::apply_narrow(const Expression& e, int x) {
  const bool was = std::exchange(wide_, false);
  const int result = apply(e, false, x);
  wide_ = was;
  return result;
}

int Columns::narrow(const Expression& e, Set ones) { return apply_narrow(e, algebra_.ones(ones)); }

std::optional<int> Columns::meet(const Expression& e, int x, int c) {
  try {
    return met(e, x, c);
  } catch (const NoKind&) {
    return std::nullopt;
  }
}

int Columns::met(const Expression& e, int x, int c) {
  if (const std::optional<int> rows = wide(e, true, x)) {
    return contract(*rows, c);
  }
  std::vector<Expression> factors = e.operands();
  switch (e.kind()) {
    case block::Kind::kNamed:
      return met(factors.front(), x, c);
    case block::Kind::kScaled:
      return algebra_.linear({{e.node().factor, met(factors.front(), x, c)}});
    case block::Kind::kSum:
      return of_terms(factors, [&](const Expression& term) { return met(term, x, c); });
    case block::Kind::kProduct: {
      auto first = factors.begin();
      for (std::optional<int> rows = x; (rows = wide(*first, true, x)); ++first) {
        x = *rows;
      }
      if (block::blows_up({first, factors.end()},
                          algebra_.value(c).type == Type::kScalar ? 1 : 3)) {
        const int column = apply_narrow(product_of(first, factors.end()), c);
        return algebra_.note(Rule::kMeet, contract(x, column));
      }
      while (factors.end() - 1 != first) {
        c = apply_narrow(factors.back(), c);
        factors.pop_back();
      }
      return met(*first, x, c);
    }
    default:
      return algebra_.note(Rule::kMeet, contract(x, apply_narrow(e, c)));
  }
}

/// 1^T X^T c.
int Columns::contract(int x, int c) {
  const Value v = algebra_.value(x);
  const auto sum = [this](int y) {
    return algebra_.sum_along(Op::kCollect, Set::kOne, y);
  };
  if (v.type != Type::kTensor) {
    return sum(algebra_.scale(c, x));
  }
  switch (v.op) {
    case Op::kZero:
      return algebra_.zero(Set::kOne, Type::kVector);
    case Op::kSkew:
      return sum(contract_skew(v.operands.front(), c));
    case Op::kLinear:
      return algebra_.of_terms(x, [&](int term) { return contract(term, c); });
    default:
      return sum(algebra_.scale(multiple_of_identity(x), c));
  }
}

/// Λ(r)^T c; of c = N a × b it is N a×(b×r) - b×(N a×r), and 1^T (N a × y) = 1^T (a × N^T y).
int Columns::contract_skew(int r, int c) {
  const Value v = algebra_.value(c);
  if (v.op != Op::kCross || algebra_.value(v.operands[0]).op != Op::kPathStrict) {
    return algebra_.cross(c, r);
  }
  const int above = v.operands[0];
  const int a = algebra_.value(above).operands.front();
  const int b = v.operands[1];
  const int below = algebra_.sum_along(Op::kSubtreeStrict, Set::kLinks, algebra_.cross(b, r));
  const int moved = algebra_.note(Rule::kTransposes, algebra_.cross(a, below));
  return algebra_.note(
      Rule::kJacobi,
      algebra_.linear({{kPlus, moved}, {kMinus, algebra_.cross(b, algebra_.cross(above, r))}}));
}

/// v^T X as a vector: of X = y E it is y v, of X = Λ(r) it is v×r.
int Columns::wide_diagonal(Type type, int blocks, bool transposed, int x) {
  if (type != Type::kVector || !transposed || algebra_.value(x).type != Type::kTensor) {
    throw NoKind{};
  }
  const Value v = algebra_.value(x);
  switch (v.op) {
    case Op::kZero:
      return algebra_.zero(v.set, Type::kVector);
    case Op::kSkew:
      return algebra_.cross(blocks, v.operands.front());
    case Op::kLinear:
      return algebra_.of_terms(x,
                               [&](int term) { return wide_diagonal(type, blocks, true, term); });
    default:
      return algebra_.scale(multiple_of_identity(x), blocks);
  }
}

/// Λ(u) X: of X = y E it is Λ(y u), other blocks lose their kind.
int Columns::wide_cross(int u, int x) {
  const Value v = algebra_.value(x);
  if (v.type != Type::kTensor) {
    throw NoKind{};
  }
  return v.op == Op::kZero ? x : algebra_.skew(algebra_.scale(multiple_of_identity(x), u));
}

/// (Λ(Y))^T y E = -Λ(Y^T y E).
int Columns::wide_skew(const Expression& Y, bool transposed, int x) {
  if (!transposed) {
    throw NoKind{};
  }
  multiple_of_identity(x);
  return algebra_.negative(algebra_.skew(apply(Y, true, x)));
}

/// y of x = y E.
int Columns::multiple_of_identity(int x) {
  const Value v = algebra_.value(x);
  if (v.op != Op::kScale || algebra_.value(v.operands.back()).op != Op::kIdentity) {
    throw NoKind{};
  }
  int y = algebra_.ones(v.set);
  for (std::size_t k = 0; k + 1 < v.operands.size(); ++k) {
    y = algebra_.scale(v.operands[k], y);
  }
  return y;
}

}  // namespace treedyn::derive
