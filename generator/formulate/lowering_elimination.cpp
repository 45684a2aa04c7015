// Eliminations: what sons hand on is made of their own sums, joints take their axes out of it.
#include "common/index.hpp"
#include "formulate/lowering.hpp"

namespace treedyn::formulate {
namespace {

using derive::Op;
using derive::Type;

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

/// a + Π^T b.
Block Lowering::folded(int id, const Value& v, int i) {
  begin(id, v, i);
  return sums_[id][to_index(i)].block;
}

/// When all of a link is known.
void Lowering::hand_on(const std::vector<int>& ids, int i) {
  const int f = father(i);
  for (const int id : ids) {
    const Value& v = value(id);
    if (v.op == Op::kFold && f != kBase) {
      const std::size_t before = graph().size();
      const Block& more = of(v.operands.back(), i);
      Vec3 up;
      for (const Part& part : more.vector) {
        up = up + frames_.moved(part.value, part.frame, f);
      }
      begin(id, v, f);
      add(v, sums_[id][to_index(f)].block, {{}, {{f, up}}, more.tensor}, number(1));
      own(before, id);
    }
  }
}

/// In the frame of the link, whoever needs it.
Block Lowering::once(const Value& v, int e) const {
  const Block& x = of(v.operands.front(), e);
  if (v.type == Type::kScalar) {
    graph().name(of(v.operands.back(), e).number.ref(), "inverse_pivot", e);
    graph().name((task_.kinematics.link(e).sign > 0 ? x.number : -x.number).ref(), "u", e);
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

/// The axis of a joint in its frame, 0 or along z.
Vec3 Lowering::direction(int id, int e) const { return frames_.in(of(id, e).vector, e); }

/// x of which a·x is known.
Block Lowering::along(const Value& v, int e) const {
  Vec3 x = frames_.in(of(v.operands[0], e).vector, e);
  const Vec3 axis = direction(v.operands[1], e);
  for (std::size_t k = 0; k < kSize; ++k) {
    x[k] = axis[k].is_zero() ? x[k] : axis[k] * of(v.operands[2], e).number;
  }
  return {{}, {{e, x}}, {}};
}

/// K - U V^T without the rows along a and the columns along b, of symmetric ones the upper half.
Block Lowering::across(const Value& v, int e) const {
  const Mat3& K = of(v.operands[0], e).tensor.value;
  const Vec3 U = frames_.in(of(v.operands[1], e).vector, e);
  const Vec3 V = frames_.in(of(v.operands[2], e).vector, e);
  const Vec3 a = direction(v.operands[3], e);
  const Vec3 b = direction(v.operands[4], e);
  const bool symmetric = v.operands[3] == v.operands[4];
  Mat3 S;
  for (std::size_t row = 0; row < kSize; ++row) {
    for (std::size_t col = symmetric ? row : 0; col < kSize; ++col) {
      if (a[row].is_zero() && b[col].is_zero()) {
        S[row][col] = K[row][col] - U[row] * V[col];
      }
    }
  }
  return {{}, {}, {e, symmetric ? mirrored(S) : S, symmetric}};
}

/// In the father's frame, where a is at home.
Block Lowering::lever(const Value& v, int e) const {
  const int frame = home(v.set, father(e));
  const Vec3 a = frames_.in(of(v.operands[0], e).vector, frame);
  const Mat3 S = frames_.moved(of(v.operands[1], e).tensor, frame).value;
  Mat3 result;
  if (v.operands.size() == 2) {
    for (std::size_t col = 0; col < kSize; ++col) {
      result[col] = cross(a, column(S, col));
    }
    return {{}, {}, {frame, formulate::transposed(result)}};
  }
  const Mat3 T = frames_.moved(of(v.operands[2], e).tensor, frame).value;
  for (std::size_t row = 0; row < kSize; ++row) {
    const Vec3 first = cross(T[row], a);
    for (std::size_t col = row; col < kSize; ++col) {
      result[row][col] = cross(a, S[col])[row] - first[col];
    }
  }
  return {{}, {}, {frame, mirrored(result), true}};
}

}  // namespace treedyn::formulate
