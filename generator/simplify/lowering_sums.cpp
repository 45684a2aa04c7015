// Sums along the tree, joint by joint.
#include "common/error.hpp"
#include "simplify/lowering.hpp"

namespace treedyn::simplify {
namespace {

using block::Set;
using derive::Op;
using derive::Type;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

/// D x: the father's sum and what is given in its frame go over the edge together.
Blocks Lowering::path(const Value& v) const {
  const bool strict = v.op == Op::kPathStrict;
  const Blocks& x = of(v.operands.front());
  Blocks y = empty(v);
  Blocks result = empty(v);
  for (int i = 0; i < task_.tree.size(); ++i) {
    graph().set_body(i);
    const int f = father(i);
    const int at = home(Set::kLinks, i);
    const bool root = f == kBase;
    if (v.type == Type::kScalar) {
      const Expr before = root ? Expr() : y.numbers[index(f)];
      y.numbers[index(i)] = before + x.numbers[index(i)];
      result.numbers[index(i)] = strict ? before : y.numbers[index(i)];
    } else if (v.type == Type::kVector) {
      const Parts before = root ? Parts{} : y.vectors[index(f)];
      Parts of_father = before;
      Parts own;
      for (const Part& part : x.vectors[index(i)]) {
        frames_.add(!frames_.in_base() && part.frame == f ? of_father : own, {part}, number(1));
      }
      const Vec3 carried =
          frames_.moved(frames_.in(of_father, root || frames_.in_base() ? kBase : f),
                        root || frames_.in_base() ? kBase : f, at);
      const Vec3 total = carried + frames_.in(own, at);
      y.vectors[index(i)] = {{at, total}};
      if (*symbol(v) != 0) {
        name(graph(), total, symbol(v), i);
      }
      result.vectors[index(i)] = strict ? before : y.vectors[index(i)];
    } else {
      Tensor sum{at, {}};
      if (!root) {
        sum = frames_.moved(y.tensors[index(f)], at);
      }
      result.tensors[index(i)] = root ? Tensor{at, {}} : y.tensors[index(f)];
      const Mat3 own = frames_.moved(x.tensors[index(i)], at).value;
      for (std::size_t row = 0; row < 3; ++row) {
        sum.value[row] = sum.value[row] + own[row];
      }
      y.tensors[index(i)] = sum;
      if (!strict) {
        result.tensors[index(i)] = sum;
      }
    }
  }
  return result;
}

/// D^T a (+ N^T b): sons first; what a son hands on meets in the father's frame.
Blocks Lowering::subtree(const Value& v) const {
  const Blocks& a = of(v.operands.front());
  const Blocks& b = of(v.operands.back());
  const bool backward = v.op == Op::kBackward;
  Blocks of_sons = empty(v);
  Blocks y = empty(v);
  for (int i = task_.tree.size() - 1; i >= 0; --i) {
    graph().set_body(i);
    const int f = father(i);
    const int at = home(Set::kLinks, i);
    const int above = frames_.in_base() ? kBase : f;
    if (v.type == Type::kScalar) {
      y.numbers[index(i)] = of_sons.numbers[index(i)] + a.numbers[index(i)];
      if (f != kBase) {
        of_sons.numbers[index(f)] +=
            y.numbers[index(i)] + (backward ? b.numbers[index(i)] : Expr());
      }
    } else if (v.type == Type::kVector) {
      const Vec3 total =
          frames_.in(of_sons.vectors[index(i)], at) + frames_.in(a.vectors[index(i)], at);
      y.vectors[index(i)] = {{at, total}};
      name(graph(), total, symbol(v), i);
      if (f != kBase) {
        Vec3 up = frames_.moved(total, at, above);
        if (backward) {
          up = up + frames_.in(b.vectors[index(i)], above);
        }
        frames_.add(of_sons.vectors[index(f)], {{above, up}}, number(1));
      }
    } else {
      TREEDYN_EXPECT(!backward);
      Tensor total = of_sons.tensors[index(i)];
      const Mat3 own = frames_.moved(a.tensors[index(i)], at).value;
      for (std::size_t row = 0; row < 3; ++row) {
        total.value[row] = total.value[row] + own[row];
      }
      y.tensors[index(i)] = total;
      if (f != kBase) {
        const Mat3 up = frames_.moved(total, above).value;
        for (std::size_t row = 0; row < 3; ++row) {
          of_sons.tensors[index(f)].value[row] = of_sons.tensors[index(f)].value[row] + up[row];
        }
      }
    }
  }
  return v.op == Op::kSubtreeStrict ? of_sons : y;
}

/// Π x and Π^T x.
Blocks Lowering::shifted(const Value& v) const {
  const Blocks& x = of(v.operands.front());
  TREEDYN_EXPECT(v.type != Type::kTensor);
  Blocks blocks = empty(v);
  for (int i = 0; i < task_.tree.size(); ++i) {
    const int f = father(i);
    if (f == kBase) {
      continue;
    }
    const auto [from, to] = v.op == Op::kFather ? std::pair(f, i) : std::pair(i, f);
    if (v.type == Type::kScalar) {
      blocks.numbers[index(to)] += x.numbers[index(from)];
    } else {
      const int at = frames_.in_base() ? kBase : f;
      const Vec3 moved = frames_.in(x.vectors[index(from)], at);
      frames_.add(blocks.vectors[index(to)], {{at, moved}}, number(1));
    }
  }
  return blocks;
}

/// W x and W^T x.
Blocks Lowering::at_points(const Value& v) const {
  const Blocks& x = of(v.operands.front());
  Blocks blocks = empty(v);
  for (int p = 0; p < count(Set::kPoints); ++p) {
    const int i = task_.options.points[index(p)].link;
    if (i == kBase) {
      continue;
    }
    const auto [from, to] = v.op == Op::kPick ? std::pair(i, p) : std::pair(p, i);
    if (v.type == Type::kScalar) {
      blocks.numbers[index(to)] += x.numbers[index(from)];
    } else if (v.type == Type::kTensor) {
      Mat3& sum = blocks.tensors[index(to)].value;
      const Mat3 more =
          frames_.moved(x.tensors[index(from)], blocks.tensors[index(to)].frame).value;
      for (std::size_t row = 0; row < 3; ++row) {
        sum[row] = sum[row] + more[row];
      }
    } else {
      const int at = home(Set::kLinks, i);
      frames_.add(blocks.vectors[index(to)], {{at, frames_.in(x.vectors[index(from)], at)}},
                  number(1));
    }
  }
  return blocks;
}

Blocks Lowering::spread(const Value& v) const {
  const Blocks& x = of(v.operands.front());
  Blocks blocks = empty(v);
  for (std::size_t e = 0; e < index(count(v.set)); ++e) {
    if (v.type == Type::kScalar) {
      blocks.numbers[e] = x.numbers.front();
    } else if (v.type == Type::kVector) {
      blocks.vectors[e] = x.vectors.front();
    } else {
      blocks.tensors[e] = x.tensors.front();
    }
  }
  return blocks;
}

/// Sums of vectors stay parts: who needs them gathers them along the tree, one rotation a link.
Blocks Lowering::collect(const Value& v) const {
  const Blocks& x = of(v.operands.front());
  Blocks blocks = empty(v);
  TREEDYN_EXPECT(v.type != Type::kTensor);
  for (const Expr& term : x.numbers) {
    blocks.numbers.front() += term;
  }
  for (const Parts& parts : x.vectors) {
    frames_.add(blocks.vectors.front(), parts, number(1));
  }
  for (const auto& [factor, id] : terms(v.operands.front())) {
    if (function_.regroups && value(id).name == "h^d") {  // what regrouping has moved to the ground
      frames_.add(blocks.vectors.front(), {{kBase, constant(graph(), task_.normal.ground_moment)}},
                  factor);
    }
  }
  return blocks;
}

}  // namespace treedyn::simplify
