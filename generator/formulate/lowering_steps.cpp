// Steps of single links.
#include <algorithm>

#include "common/index.hpp"
#include "formulate/lowering.hpp"

namespace treedyn::formulate {
namespace {

using derive::Op;
using derive::Type;

}  // namespace

/// True for a product with a number that the joint's kind makes zero.
bool Lowering::is_absent(int id, int e) const {
  const Value& v = value(id);
  const bool is_product = v.op == Op::kScale || v.op == Op::kCross || v.op == Op::kApply;
  return is_product ? std::ranges::any_of(v.operands, [&](int x) { return is_absent(x, e); })
                    : v.op == Op::kLeaf && v.type == Type::kScalar && of(id, e).number.is_zero();
}

Block Lowering::linear(const Value& v, int e) const {
  Block result = zero(v, e);
  result.tensor.frame = of(v.operands.front(), e).tensor.frame;
  for (std::size_t n = 0; n < v.operands.size(); ++n) {
    if (!derivation_.elimination || !is_absent(v.operands[n], e)) {
      add(v, result, of(v.operands[n], e),
          number(Real(v.factors[n].numerator) / v.factors[n].denominator));
    }
  }
  return result;
}

Block Lowering::scale(const Value& v, int e) const {
  Expr factor = number(1);
  for (std::size_t n = 0; n + 1 < v.operands.size(); ++n) {
    factor = factor * of(v.operands[n], e).number;
  }
  const int last = v.operands.back();
  const Block& x = of(last, e);
  Block result = zero(v, e);
  result.tensor.frame = x.tensor.frame;
  // a column of one number for all, and of the columns that are asked for, is at home in the base
  const Value& first = value(v.operands.front());
  const bool of_columns = derivation_.values.of_unit(v.operands.front()) &&
                          (v.set == block::Set::kOne || first.op == Op::kSpread);
  const bool of_parts = v.set == block::Set::kOne && x.vector.size() > 1 && first.op != Op::kLeaf &&
                        !factor.is_constant();
  const bool comes_once = (of_columns || of_parts) && !derivation_.values.of_unit(last);
  add(v, result, comes_once ? moved(v, x, home(v.set, e), kBase) : x, factor);
  return result;
}

/// The frame of both operands, of s (whose numbers are constant there), or the link's.
int Lowering::meeting(const Value& v, int e) const {
  const Parts& a = of(v.operands.front(), e).vector;
  const Parts& b = of(v.operands.back(), e).vector;
  if (a.size() == 1 && b.size() == 1 && a[0].frame == b[0].frame) {
    return a[0].frame;
  }
  if (v.op == Op::kSkewProduct && a.size() == 1 && b.size() == 1) {  // vectors go, blocks stay
    for (const Parts& x : {a, b}) {
      if (x[0].frame == father(e)) {
        return father(e);
      }
    }
  }
  for (const int operand : v.operands) {
    const Parts& parts = of(operand, e).vector;
    if (!frames_.in_base() && value(operand).name == "s^d" && !parts.empty()) {
      return parts[0].frame;
    }
  }
  return home(v.set, e);
}

Block Lowering::product(const Value& v, int e) const {
  const int frame = meeting(v, e);
  const Vec3 a = frames_.in(of(v.operands.front(), e).vector, frame);
  const Vec3 b = frames_.in(of(v.operands.back(), e).vector, frame);
  switch (v.op) {
    case Op::kDot:
      return {formulate::dot(a, b), {}, {}};
    case Op::kCross:
      return {{}, {{frame, formulate::cross(a, b)}}, {}};
    case Op::kSkew:
      return {{}, {}, {frame, skew(a)}};
    default:
      return {
          {}, {}, {frame, v.operands[0] == v.operands[1] ? skew_squared(a) : skew(a) * skew(b)}};
  }
}

Block Lowering::tensor_product(const Value& v, int e) const {
  const int frame = home(v.set, e);
  const Mat3 a = frames_.moved(of(v.operands[0], e).tensor, frame).value;
  const Mat3 b = frames_.moved(of(v.operands[1], e).tensor, frame).value;
  return {{}, {}, {frame, a * b}};
}

Block Lowering::applied(const Value& v, int e) const {
  const Tensor& t = of(v.operands[0], e).tensor;
  const Vec3 x = frames_.in(of(v.operands[1], e).vector, t.frame);
  const Mat3 m = v.op == Op::kApply ? t.value : transposed(t.value);
  return {{}, {{t.frame, m * x}}, {}};
}

/// Components in the base frame, and vectors of such.
Block Lowering::components(const Value& v, int e) const {
  if (v.op == Op::kComponent) {
    const Parts& x = of(v.operands.front(), e).vector;
    return {frames_.in(x, kBase)[to_index(v.component)], {}, {}};
  }
  Vec3 x;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = of(v.operands[k], e).number;
  }
  return {{}, {{kBase, x}}, {}};
}

}  // namespace treedyn::formulate
