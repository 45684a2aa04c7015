// Columns of 3x3 blocks: multiples of E, skew blocks and single rows keep their kind (R7').
#include <utility>

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

int Columns::narrow(const Expression& e, Set ones) {
  const bool was = std::exchange(wide_, false);
  const int result = apply(e, false, algebra_.ones(ones));
  wide_ = was;
  return result;
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
    case Op::kLinear: {
      Terms terms;
      for (std::size_t k = 0; k < v.operands.size(); ++k) {
        terms.emplace_back(v.factors[k], wide_diagonal(type, blocks, true, v.operands[k]));
      }
      return algebra_.linear(terms);
    }
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
