// Eliminations: what sons hand on is made of their own sums, joints take their axes out of it.
#include "simplify/lowering.hpp"

namespace treedyn::simplify {
namespace {

using derive::Op;
using derive::Type;

constexpr std::size_t kSize = 3;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The upper half twice.
Mat3 mirrored(Mat3 S) {
  for (std::size_t a = 0; a < kSize; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      S[a][b] = S[b][a];
    }
  }
  return S;
}

}  // namespace

/// True for accelerations of the trunk, which are known by now.
bool Lowering::is_given(int id, int e) {
  if (!turning_ || e != kTrunkLink || !derivation_.elimination) {
    return false;
  }
  const std::array<int, 2>& motion = derivation_.elimination->motion;
  if (id != motion[0] && id != motion[1]) {
    return false;
  }
  const std::array<Vec3, 2> given = solution_(*this);
  for (std::size_t k = 0; k < 2; ++k) {
    memo_[index(motion[k])][index(e)].vector = {{e, given[k]}};
    known_[index(motion[k])][index(e)] = true;
  }
  return true;
}

/// a + Π^T b.
Block Lowering::folded(int id, const Value& v, int i) {
  begin(id, v, i);
  Block total = sums_[id][index(i)].block;
  if (v.component == 1) {
    total.tensor.value = mirrored(total.tensor.value);
  }
  return total;
}

/// When all of a link is known.
void Lowering::hand_on(const std::vector<int>& ids, int i) {
  const int f = father(i);
  for (const int id : ids) {
    const Value& v = value(id);
    if (v.op == Op::kFold && f != kBase) {
      const Block& more = of(v.operands.back(), i);
      Vec3 up;
      for (const Part& part : more.vector) {
        up = up + frames_.moved(part.value, part.frame, f);
      }
      begin(id, v, f);
      add(v, sums_[id][index(f)].block, {{}, {{f, up}}, more.tensor}, number(1));
    }
  }
}

/// In the frame of the link, whoever needs it.
Block Lowering::once(const Value& v, int e) const {
  const Block& x = of(v.operands.front(), e);
  if (v.type == Type::kScalar) {
    graph().name(of(v.operands.back(), e).number.ref(), "inverse_pivot", e);
    graph().name(x.number.ref(), "u", e);
  }
  if (v.type != Type::kVector) {
    return x;
  }
  const int at = home(v.set, e);
  const Vec3 value = frames_.in(x.vector, at);
  if (!v.name.empty()) {
    name(graph(), value, "zeta", e);
  }
  return {{}, {{at, value}}, {}};
}

/// The trunk takes nothing.
Block Lowering::reciprocal(const Value& v, int e) const {
  const bool takes = !turning_ || e != kTrunkLink;
  return {takes ? number(1) / of(v.operands.front(), e).number : Expr(), {}, {}};
}

/// The axis of a joint in its frame, 0 or along z.
Vec3 Lowering::direction(int id, int e) const { return frames_.in(of(id, e).vector, e); }

Block Lowering::without_joint(const Value& v, int e) const {
  const int a = v.operands[0];
  const int b = v.operands[1];
  if (v.op == Op::kAlong) {
    Vec3 x = frames_.in(of(a, e).vector, e);
    const Vec3 axis = direction(b, e);
    for (std::size_t k = 0; k < kSize; ++k) {
      x[k] = axis[k].is_zero() ? x[k] : axis[k] * of(v.operands[2], e).number;
    }
    return {{}, {{e, x}}, {}};
  }
  if (v.op == Op::kDyad) {
    const Vec3 left = frames_.in(of(a, e).vector, e);
    const Vec3 right = frames_.in(of(b, e).vector, e);
    return {{}, {}, {e, {left[0] * right, left[1] * right, left[2] * right}}};
  }
  if (v.op == Op::kAcross) {
    Tensor S = of(a, e).tensor;
    const Vec3 left = direction(b, e);
    const Vec3 right = direction(v.operands[2], e);
    for (std::size_t n = 0; n < kSize * kSize; ++n) {
      if (!left[n / kSize].is_zero() || !right[n % kSize].is_zero()) {
        S.value[n / kSize][n % kSize] = Expr();
      }
    }
    S.symmetric = b == v.operands[2];
    S.value = S.symmetric ? mirrored(S.value) : S.value;
    return {{}, {}, S};
  }
  const int frame = home(v.set, father(e));
  const Vec3 s = frames_.in(of(a, e).vector, frame);
  const Mat3 S = frames_.moved(of(b, e).tensor, frame).value;
  const Mat3 rows = v.component == 0 ? simplify::transposed(S) : S;
  Mat3 result;
  for (std::size_t k = 0; k < kSize; ++k) {
    result[k] = v.component == 2 ? cross(rows[k], s) : cross(s, rows[k]);
  }
  return {{}, {}, {frame, v.component == 2 ? result : simplify::transposed(result)}};
}

}  // namespace treedyn::simplify
