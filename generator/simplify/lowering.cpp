#include "simplify/lowering.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace treedyn::simplify {
namespace {

using block::Set;
using derive::Op;
using derive::Type;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Lowering::Lowering(const Task& task, const Derived& function, Way way)
    : task_(task),
      function_(function),
      derivation_(way == Way::kToRoot && function.to_root ? *function.to_root
                                                          : function.derivation),
      frames_(task.kinematics, way),
      needed_(derivation_.values.needed(derivation_.roots)),
      of_unit_(index(derivation_.values.size()), false),
      memo_(index(derivation_.values.size())),
      costs_(index(derivation_.values.size())) {
  for (const int id : needed_) {
    const Value& v = value(id);
    const auto depends = [this](int operand) {
      return of_unit_[index(operand)];
    };
    of_unit_[index(id)] =
        v.op == Op::kUnit || std::any_of(v.operands.begin(), v.operands.end(), depends);
    if (!of_unit_[index(id)]) {
      compute(id);
    }
  }
}

const Blocks& Lowering::root(int k) { return of(derivation_.roots[index(k)]); }

const Blocks& Lowering::root_of_unit(int place, int component) {
  place_ = place;
  component_ = component;
  for (const int id : needed_) {
    if (of_unit_[index(id)]) {
      compute(id);
    }
  }
  return root(0);
}

void Lowering::compute(int id) {
  const std::size_t before = graph().size();
  Blocks blocks = made(value(id));
  for (std::size_t n = before; n < graph().size(); ++n) {
    const program::Kind kind = graph().node(static_cast<program::Ref>(n)).kind;
    costs_[index(id)].add += kind == program::Kind::kAdd ? 1 : 0;
    costs_[index(id)].mul += kind == program::Kind::kMultiply ? 1 : 0;
  }
  memo_[index(id)] = std::move(blocks);
}

/// What the field calls a vector that travels along the tree.
const char* Lowering::symbol(const Value& v) const {
  const Value& x = value(v.operands.front());
  switch (v.op) {
    case Op::kPath:
    case Op::kPathStrict:
      return x.op == Op::kScale && value(x.operands.back()).name == "z^d" ? "omega" : "";
    case Op::kSubtree:
    case Op::kSubtreeStrict:
      return derivation_.wide ? "r" : "F";
    default:
      return derivation_.wide ? "r" : x.name == "h^d" ? "h" : "M";
  }
}

/// A value as a sum.
std::vector<std::pair<Expr, int>> Lowering::terms(int id) const {
  const Value& v = value(id);
  if (v.op != Op::kLinear) {
    return {{number(1), id}};
  }
  std::vector<std::pair<Expr, int>> result;
  for (std::size_t n = 0; n < v.operands.size(); ++n) {
    result.emplace_back(number(Real(v.factors[n].numerator) / v.factors[n].denominator),
                        v.operands[n]);
  }
  return result;
}

int Lowering::count(Set set) const {
  return set == Set::kLinks    ? task_.tree.size()
         : set == Set::kPoints ? static_cast<int>(task_.options.points.size())
                               : 1;
}

Expr Lowering::number(const Real& x) const { return constant(graph(), x); }

/// The frame in which vectors of an element are at home.
int Lowering::home(Set set, int e) const {
  if (frames_.in_base() || set == Set::kOne) {
    return kBase;
  }
  return set == Set::kLinks ? e : task_.options.points[index(e)].link;
}

Blocks Lowering::empty(const Value& v) const {
  const std::size_t n = index(count(v.set));
  Blocks blocks;
  switch (v.type) {
    case Type::kScalar:
      blocks.numbers.resize(n);
      break;
    case Type::kVector:
      blocks.vectors.resize(n);
      break;
    case Type::kTensor:
      for (std::size_t e = 0; e < n; ++e) {
        blocks.tensors.push_back({home(v.set, static_cast<int>(e)), {}});
      }
  }
  return blocks;
}

Blocks Lowering::made(const Value& v) const {
  switch (v.op) {
    case Op::kZero:
      return empty(v);
    case Op::kOnes: {
      Blocks blocks = empty(v);
      std::fill(blocks.numbers.begin(), blocks.numbers.end(), number(1));
      return blocks;
    }
    case Op::kIdentity: {
      Blocks blocks = empty(v);
      for (Tensor& tensor : blocks.tensors) {
        tensor.value = constant(graph(), simplify::identity());
      }
      return blocks;
    }
    case Op::kUnit:
      return unit(v);
    case Op::kLeaf:
      return leaf(v);
    case Op::kLinear:
      return linear(v);
    case Op::kScale:
      return scale(v);
    case Op::kDot:
    case Op::kCross:
    case Op::kSkew:
    case Op::kSkewProduct:
      return product(v);
    case Op::kApply:
    case Op::kApplyTranspose:
      return applied(v);
    case Op::kPath:
    case Op::kPathStrict:
      return path(v);
    case Op::kSubtree:
    case Op::kSubtreeStrict:
    case Op::kBackward:
      return subtree(v);
    case Op::kFather:
    case Op::kSons:
      return shifted(v);
    case Op::kGather:
    case Op::kPick:
      return at_points(v);
    case Op::kSpread:
      return spread(v);
    case Op::kCollect:
      return collect(v);
    case Op::kComponent:
    case Op::kAssemble:
      return components(v);
  }
  return empty(v);
}

std::vector<Expr> Lowering::written(const Blocks& blocks, Set set) const {
  std::vector<Expr> result = blocks.numbers;
  for (int e = 0; e < count(set) && !blocks.vectors.empty(); ++e) {
    const Vec3 x = frames_.in(blocks.vectors[index(e)], kBase);
    result.insert(result.end(), x.begin(), x.end());
  }
  for (const Tensor& tensor : blocks.tensors) {
    for (const Vec3& row : frames_.moved(tensor, kBase).value) {
      result.insert(result.end(), row.begin(), row.end());
    }
  }
  return result;
}

}  // namespace treedyn::simplify
