// Steps of single links.
#include "simplify/lowering.hpp"

namespace treedyn::simplify {
namespace {

using block::Set;
using derive::Op;
using derive::Type;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Mat3 skew(const Vec3& a) {
  return {{{Expr(), -a[2], a[1]}, {a[2], Expr(), -a[0]}, {-a[1], a[0], Expr()}}};
}

}  // namespace

Blocks Lowering::linear(const Value& v) const {
  Blocks blocks = empty(v);
  for (std::size_t n = 0; n < v.operands.size(); ++n) {
    const Blocks& x = of(v.operands[n]);
    const Expr factor = number(Real(v.factors[n].numerator) / v.factors[n].denominator);
    for (int e = 0; e < count(v.set); ++e) {
      if (v.type == Type::kScalar) {
        blocks.numbers[index(e)] += factor * x.numbers[index(e)];
      } else if (v.type == Type::kVector) {
        frames_.add(blocks.vectors[index(e)], x.vectors[index(e)], factor);
      } else {
        Tensor& sum = blocks.tensors[index(e)];
        sum.frame = n == 0 ? x.tensors[index(e)].frame : sum.frame;
        const Mat3 term = frames_.moved(x.tensors[index(e)], sum.frame).value;
        for (std::size_t row = 0; row < 3; ++row) {
          sum.value[row] = sum.value[row] + factor * term[row];
        }
      }
    }
  }
  return blocks;
}

Blocks Lowering::scale(const Value& v) const {
  Blocks blocks = of(v.operands.back());
  for (int e = 0; e < count(v.set); ++e) {
    Expr factor = number(1);
    for (std::size_t n = 0; n + 1 < v.operands.size(); ++n) {
      factor = factor * of(v.operands[n]).numbers[index(e)];
    }
    if (v.type == Type::kScalar) {
      blocks.numbers[index(e)] = factor * blocks.numbers[index(e)];
    } else if (v.type == Type::kVector) {
      Parts parts;
      frames_.add(parts, blocks.vectors[index(e)], factor);
      blocks.vectors[index(e)] = parts;
    } else {
      for (Vec3& row : blocks.tensors[index(e)].value) {
        row = factor * row;
      }
    }
  }
  return blocks;
}

/// The frame of both operands, of s (whose numbers are constant there), or the link's.
int Lowering::meeting(const Value& v, int e) const {
  const Parts& a = of(v.operands.front()).vectors[index(e)];
  const Parts& b = of(v.operands.back()).vectors[index(e)];
  if (a.size() == 1 && b.size() == 1 && a[0].frame == b[0].frame) {
    return a[0].frame;
  }
  for (const int operand : v.operands) {
    const Parts& parts = of(operand).vectors[index(e)];
    if (!frames_.in_base() && value(operand).name == "s^d" && !parts.empty()) {
      return parts[0].frame;
    }
  }
  return home(v.set, e);
}

Blocks Lowering::product(const Value& v) const {
  Blocks blocks = empty(v);
  for (int e = 0; e < count(v.set); ++e) {
    if (v.set == Set::kLinks) {
      graph().set_body(e);
    }
    const int frame = meeting(v, e);
    const Vec3 a = frames_.in(of(v.operands.front()).vectors[index(e)], frame);
    const Vec3 b = frames_.in(of(v.operands.back()).vectors[index(e)], frame);
    switch (v.op) {
      case Op::kDot:
        blocks.numbers[index(e)] = simplify::dot(a, b);
        break;
      case Op::kCross:
        blocks.vectors[index(e)] = {{frame, simplify::cross(a, b)}};
        break;
      case Op::kSkew:
        blocks.tensors[index(e)] = {frame, skew(a)};
        break;
      default:
        blocks.tensors[index(e)] = {
            frame, v.operands[0] == v.operands[1] ? skew_squared(a) : skew(a) * skew(b)};
    }
  }
  return blocks;
}

Blocks Lowering::applied(const Value& v) const {
  Blocks blocks = empty(v);
  for (int e = 0; e < count(v.set); ++e) {
    const Tensor& t = of(v.operands[0]).tensors[index(e)];
    const Vec3 x = frames_.in(of(v.operands[1]).vectors[index(e)], t.frame);
    const Mat3 m = v.op == Op::kApply ? t.value : transposed(t.value);
    blocks.vectors[index(e)] = {{t.frame, m * x}};
  }
  return blocks;
}

/// Components in the base frame, and vectors of such.
Blocks Lowering::components(const Value& v) const {
  Blocks blocks = empty(v);
  for (int e = 0; e < count(v.set); ++e) {
    if (v.op == Op::kComponent) {
      const Parts& x = of(v.operands.front()).vectors[index(e)];
      blocks.numbers[index(e)] = frames_.in(x, kBase)[index(v.component)];
    } else {
      Vec3 x;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] = of(v.operands[k]).numbers[index(e)];
      }
      blocks.vectors[index(e)] = {{kBase, x}};
    }
  }
  return blocks;
}

}  // namespace treedyn::simplify
