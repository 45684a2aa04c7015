// Sums along the tree, joint by joint, and their names.
#include <algorithm>
#include <array>
#include <numeric>

#include "common/error.hpp"
#include "common/index.hpp"
#include "formulate/lowering.hpp"

namespace treedyn::formulate {
namespace {

using block::Set;
using derive::Op;
using derive::Type;

}  // namespace

/// D x, or a + D x: the father's sum and what is given in its frame go over the edge together.
Block Lowering::path(int id, const Value& v, int i) {
  Blocks& totals = totals_[id];
  totals.resize(to_index(task_.tree.size()));
  const int f = father(i);
  const int at = home(Set::kLinks, i);
  const bool root = f == kBase;
  const Block& x = of(v.operands.front(), i);
  Block before = zero(v, i);
  if (!root) {
    before = totals[to_index(f)];
  } else if (v.operands.size() > 1) {
    before = of(v.operands.back(), i);
  } else if (symbol(id) == std::string("omega")) {
    before.vector = {{kBase, task_.kinematics.ground_turning()}};
  }
  Block& total = totals[to_index(i)];
  if (v.type == Type::kVector) {
    Parts of_father = before.vector;
    Parts own;
    for (const Part& part : x.vector) {
      frames_.add(!frames_.in_base() && part.frame == f ? of_father : own, {part}, number(1));
    }
    const int above = root || frames_.in_base() ? kBase : f;
    const Vec3 carried = frames_.moved(frames_.in(of_father, above), above, at);
    total.vector = {{at, carried + frames_.in(own, at)}};
    named_.push_back(id);
  } else {
    total = zero(v, i);
    if (!root) {
      total = moved(v, before, home(Set::kLinks, f), at);
    }
    add(v, total, x, number(1));
  }
  return v.op == Op::kPathStrict ? before : total;
}

/// The sum of a link begins with its own block, if that is known before the sons' are.
void Lowering::begin(int id, const Value& v, int i) {
  std::vector<Sum>& sums = sums_[id];
  sums.resize(to_index(task_.tree.size()));
  Sum& sum = sums[to_index(i)];
  if (sum.begun) {
    return;
  }
  const int a = v.operands.front();
  const int at = home(Set::kLinks, i);
  sum.begun = true;
  sum.has_own = v.op != Op::kSubtreeStrict && stage_[to_index(a)] < stage_[to_index(id)];
  if (sum.has_own) {
    need(a, i);
  }
  sum.block = moved(v, sum.has_own ? of(a, i) : zero(v, i), at, at);
}

/// D^T a (+ N^T b), sons first; what a son hands on meets in the father's frame.
Block Lowering::subtree(int id, const Value& v, int i) {
  begin(id, v, i);
  const int at = home(Set::kLinks, i);
  const Block of_sons = sums_[id][to_index(i)].block;
  Block total = of_sons;
  if (!sums_[id][to_index(i)].has_own) {
    add(v, total, moved(v, of(v.operands.front(), i), at, at), number(1));
  }
  if (const int f = father(i); f != kBase) {
    const int above = home(Set::kLinks, f);
    Block up = moved(v, total, at, above);
    if (v.op == Op::kBackward) {
      add(v, up, moved(v, of(v.operands.back(), i), above, above), number(1));
    }
    begin(id, v, f);
    add(v, sums_[id][to_index(f)].block, up, number(1));
  }
  if (v.type == Type::kVector) {
    totals_[id].resize(to_index(task_.tree.size()));
    totals_[id][to_index(i)] = total;
    named_.push_back(id);
  }
  return v.op == Op::kSubtreeStrict ? of_sons : total;
}

/// Π x and Π^T x.
Block Lowering::shifted(const Value& v, int i) const {
  const int x = v.operands.front();
  const int f = father(i);
  if (v.op == Op::kFather) {
    return f != kBase ? of(x, f) : v.operands.size() > 1 ? of(v.operands.back(), i) : zero(v, i);
  }
  Block sum = zero(v, i);
  const int at = home(Set::kLinks, i);
  for (int son = i + 1; son < task_.tree.size(); ++son) {
    if (father(son) == i) {
      add(v, sum, moved(v, of(x, son), home(Set::kLinks, son), at), number(1));
    }
  }
  return sum;
}

/// W x and W^T x.
Block Lowering::at_points(const Value& v, int e) const {
  const int x = v.operands.front();
  Block sum = zero(v, e);
  for (int p = 0; p < count(Set::kPoints); ++p) {
    const int i = task_.options.points[to_index(p)].link;
    const int from = v.op == Op::kPick ? i : p;
    if (i == kBase || e != (v.op == Op::kPick ? p : i)) {
      continue;
    }
    const int at = home(Set::kLinks, i);
    Block more = of(x, from);
    if (v.type == Type::kVector) {
      more.vector = {{at, frames_.in(more.vector, at)}};
    }
    add(v, sum, more, number(1));
  }
  return sum;
}

/// The same for all elements: a vector of many parts comes together once, where their ways to the
/// root meet, from where it travels to the elements.
Block Lowering::spread(int id, const Value& v, int e) {
  if (e > 0) {
    need(id, 0);
    return of(id, 0);
  }
  Block result = of(v.operands.front(), 0);
  if (v.type == Type::kVector && result.vector.size() > 1) {
    const auto meet = [&](int a, const Part& b) {
      while (a != kBase && !model::reaches(task_.tree, b.frame, a)) {
        a = father(a);
      }
      return a;
    };
    const int at = std::accumulate(result.vector.begin(), result.vector.end(),
                                   result.vector.front().frame, meet);
    result.vector = {{at, frames_.in(result.vector, at)}};
  }
  return result;
}

/// Sums of vectors stay parts: who needs them gathers them along the tree, one rotation a link.
Block Lowering::collect(const Value& v) const {
  TREEDYN_EXPECT(v.type != Type::kTensor);
  Block sum;
  for (const Block& x : memo_[to_index(v.operands.front())]) {
    add(v, sum, x, number(1));
  }
  for (const auto& [factor, id] : terms(v.operands.front())) {
    if (function_.regroups && value(id).name == "h^d") {  // what regrouping has moved to the ground
      frames_.add(sum.vector, {{kBase, constant(graph(), task_.normal.ground_moment)}}, factor);
    }
  }
  return sum;
}

/// What the field calls a vector that travels along the tree.
const char* Lowering::symbol(int id) const {
  const Value& v = value(id);
  const Value& x = value(v.operands.front());
  const auto is_alpha = [id](const derive::Turning& t) {
    return t.alpha == id;
  };
  const auto with_Omega = [this](int y) {
    return value(y).op == Op::kApply && value(value(y).operands[0]).op == Op::kFather;
  };
  switch (v.op) {
    case Op::kPath:
    case Op::kPathStrict:
      return x.op == Op::kScale && value(x.operands.back()).name == "z^d" ? "omega"
             : std::ranges::any_of(turnings_, is_alpha)                   ? "alpha"
             : std::ranges::any_of(x.operands, with_Omega)                ? "a"
                                                                          : "";
    case Op::kSubtree:
    case Op::kSubtreeStrict:
      return derivation_.wide ? "r" : "F";
    default:
      return derivation_.wide ? "r" : x.name == "h^d" ? "h" : "M";
  }
}

/// Sums along the tree, and Ω.
void Lowering::name_sums(int e) {
  constexpr std::array<const char*, 9> kEntry = {"xx", "xy", "xz", "yx", "yy",
                                                 "yz", "zx", "zy", "zz"};
  std::ranges::sort(named_);
  for (const int id : named_) {
    const Value& v = value(id);
    if (derivation_.symmetric && of_unit_[to_index(id)]) {
      continue;  // as many as columns
    }
    const auto total = totals_.find(id);
    const Block& block = total != totals_.end() ? total->second[to_index(e)] : of(id, e);
    if (v.type == Type::kTensor) {
      for (std::size_t n = 0; n < 9; ++n) {
        graph().name(block.tensor.value[n / 3][n % 3].ref(), "Omega", e, kEntry[n]);
      }
    } else if (*symbol(id) != 0) {
      name(graph(), frames_.in(block.vector, home(Set::kLinks, e)), symbol(id), e);
    }
  }
  named_.clear();
}

}  // namespace treedyn::formulate
