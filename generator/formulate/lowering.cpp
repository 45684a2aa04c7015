#include "formulate/lowering.hpp"

#include <algorithm>
#include <span>

#include "common/index.hpp"

namespace treedyn::formulate {
namespace {

using block::Set;
using derive::Op;
using derive::Type;

constexpr int kNobody = -1;

bool is_to_sons(Op op) { return op == Op::kPath || op == Op::kPathStrict || op == Op::kFather; }
bool is_to_fathers(Op op) {
  return op == Op::kSubtree || op == Op::kSubtreeStrict || op == Op::kBackward || op == Op::kSons ||
         op == Op::kComposite || op == Op::kFold;
}
bool is_whole(const derive::Value& v) {
  return v.set != Set::kLinks || v.op == Op::kGather || v.op == Op::kSpread;
}

}  // namespace

Lowering::Lowering(const Task& task, const Derived& function, Way way)
    : task_(task),
      function_(function),
      derivation_(way == Way::kToRoot && function.to_root ? *function.to_root
                                                          : function.derivation),
      trunk_(derivation_.symmetric && way != Way::kInBase && task.kinematics.variant().trunk &&
             !task.kinematics.is_from_trunk() && has_trunk(task.tree)),
      frames_(task.kinematics, trunk_ ? Way::kInLinks : way),
      needed_(derivation_.values.needed(derivation_.roots)),
      turnings_(frames_.in_base() ? std::vector<derive::Turning>{}
                                  : derive::turnings_about_axes(derivation_.values, needed_)),
      stage_(to_index(derivation_.values.size()), -1),
      of_unit_(to_index(derivation_.values.size()), false),
      memo_(to_index(derivation_.values.size())),
      known_(to_index(derivation_.values.size())) {
  arrange();
  if (derivation_.elimination) {  // numbers of no link come first
    static_cast<void>(task_.kinematics.ground_acceleration());
  }
  run(false);
}

/// The first stage that can hold a value: its operands are in earlier ones or in the same; -1 for
/// leaves.
int Lowering::stage_of(int id) const {
  const Value& v = value(id);
  if (v.op == Op::kTravelling) {
    return stage_[to_index(derivation_.values.definitions().at(id))];
  }
  if (v.operands.empty()) {
    return -1;
  }
  int stage = 0;
  for (const int operand : v.operands) {
    stage = std::max(stage, stage_[to_index(operand)]);
  }
  const bool fixed = is_whole(v) || is_to_sons(v.op) || is_to_fathers(v.op);
  const Walk walk = is_whole(v)           ? Walk::kWhole
                    : is_to_fathers(v.op) ? Walk::kToFathers
                                          : Walk::kToSons;
  while (fixed ? walk_of(stage) != walk : walk_of(stage) == Walk::kWhole) {
    ++stage;
  }
  return stage;
}

void Lowering::arrange() {
  std::vector<bool> of_sum(memo_.size(), false);
  for (const int id : needed_) {
    const Value& v = value(id);
    memo_[to_index(id)].resize(to_index(count(v.set)));
    known_[to_index(id)].assign(to_index(count(v.set)), false);
    of_unit_[to_index(id)] = v.op == Op::kUnit || std::ranges::any_of(v.operands, [this](int x) {
                               return of_unit_[to_index(x)];
                             });
  }
  for (bool settled = false; !settled;) {
    settled = true;
    for (const int id : needed_) {
      const int stage = stage_of(id);
      settled = settled && stage == stage_[to_index(id)];
      stage_[to_index(id)] = stage;
      stages_.resize(std::max(stages_.size(), to_index(stage + 1)));
    }
  }
  for (auto id = needed_.rbegin(); id != needed_.rend(); ++id) {
    const Value& v = value(*id);
    of_sum[to_index(*id)] =
        of_sum[to_index(*id)] || is_to_sons(v.op) || is_to_fathers(v.op) ||
        (v.op == Op::kAtLink && v.type == Type::kVector && stage_[to_index(*id)] == 1);
    const bool here = !derivation_.elimination || v.op != Op::kFather;
    for (const int operand : v.operands) {
      if (of_sum[to_index(*id)] && here && stage_[to_index(operand)] == stage_[to_index(*id)]) {
        of_sum[to_index(operand)] = true;
      }
    }
  }
  for (const int id : needed_) {
    if (stage_[to_index(id)] >= 0) {
      Stage& stage = stages_[to_index(stage_[to_index(id)])];
      (of_sum[to_index(id)] ? stage.sums : stage.rest).push_back(id);
    }
  }
}

void Lowering::run(const std::vector<int>& ids, int e, bool of_unit) {
  for (const int id : ids) {
    if (of_unit_[to_index(id)] == of_unit) {
      need(id, e);
    }
  }
}

/// False for rows that a symmetric matrix need not have in a column.
bool Lowering::is_asked(int e, bool of_unit) const {
  int i = place_;
  while (of_unit && derivation_.symmetric && i > e) {
    i = father(i);
  }
  return !of_unit || !derivation_.symmetric || i == e;
}

void Lowering::run(bool of_unit) {
  const int n = task_.tree.size();
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    const Stage& stage = stages_[s];
    const Walk walk = walk_of(static_cast<int>(s));
    for (const int id : walk == Walk::kWhole ? stage.rest : std::vector<int>{}) {
      for (int e = 0; e < count(value(id).set); ++e) {
        run({id}, e, of_unit);
      }
    }
    for (int k = 0; walk != Walk::kWhole && k < n; ++k) {
      const int e = walk == Walk::kToSons ? k : n - 1 - k;
      if (!is_asked(e, of_unit)) {
        continue;
      }
      graph().set_body(e);
      run(stage.sums, e, of_unit);
      hand_on(stage.sums, e);
      name_sums(e);
      if (!derivation_.elimination || !stage.rest.empty()) {
        graph().set_body(e);
      }
      run(stage.rest, e, of_unit);
    }
  }
  for (const int root : derivation_.roots) {  // that are leaves
    for (int e = 0; of_unit_[to_index(root)] == of_unit && e < count(value(root).set); ++e) {
      if (is_asked(e, of_unit)) {
        need(root, e);
      }
    }
  }
}

void Lowering::ask_for(int place, int component) {
  place_ = place;
  component_ = component;
  for (const int id : needed_) {
    if (of_unit_[to_index(id)]) {
      std::fill(known_[to_index(id)].begin(), known_[to_index(id)].end(), false);
      sums_.erase(id);
    }
  }
  run(true);
}

void Lowering::need(int id, int e) {
  if (known_[to_index(id)][to_index(e)]) {
    return;
  }
  const Value& v = value(id);
  for (const int operand : v.op == Op::kFold ? std::span<const int>{} : std::span(v.operands)) {
    const bool elsewhere = value(operand).set != v.set || v.op == Op::kFather || v.op == Op::kSons;
    for (int k = 0; elsewhere && stage_[to_index(operand)] < 0 && k < count(value(operand).set);
         ++k) {
      need(operand, k);
    }
    if (!elsewhere) {
      need(operand, e);
    }
  }
  const auto turning = std::ranges::find_if(
      turnings_, [&](const derive::Turning& t) { return t.alpha == id || t.Omega == id; });
  const std::size_t before = graph().size();
  if (turning != turnings_.end()) {
    need(turning->omega, e);
    turn(*turning, e);
  } else {
    memo_[to_index(id)][to_index(e)] = made(id, v, e);
    known_[to_index(id)][to_index(e)] = true;
  }
  own(before, id);
}

void Lowering::own(std::size_t first, int id) {
  owners_.resize(graph().size(), kNobody);
  std::replace(owners_.begin() + static_cast<std::ptrdiff_t>(first), owners_.end(), kNobody, id);
}

std::vector<program::Cost> Lowering::costs(const std::vector<Expr>& outputs) const {
  std::vector<program::Ref> refs;
  std::ranges::transform(outputs, std::back_inserter(refs), [](Expr x) { return x.ref(); });
  const auto nobody = to_index(derivation_.values.size());
  std::vector<program::Cost> result(nobody + 1);
  for (const program::Ref node : program::reachable(graph(), refs)) {
    const auto n = to_index(node);
    const bool owned = n < owners_.size() && owners_[n] != kNobody;
    add_operation(graph().node(node), result[owned ? to_index(owners_[n]) : nobody]);
  }
  return result;
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
  if (trunk_ && set == Set::kLinks && e != kBase && e < kTrunkLink) {
    return task_.kinematics.link(e).revolute ? kTrunkLink : kBase;
  }
  return set == Set::kLinks ? e : task_.options.points[to_index(e)].link;
}

Block Lowering::zero(const Value& v, int e) const { return {{}, {}, {home(v.set, e), {}}}; }

/// sum + factor * x.
void Lowering::add(const Value& v, Block& sum, const Block& x, Expr factor) const {
  switch (v.type) {
    case Type::kScalar:
      sum.number += factor * x.number;
      break;
    case Type::kVector:
      frames_.add(sum.vector, x.vector, factor);
      break;
    case Type::kTensor: {
      const Mat3 term = frames_.moved(x.tensor, sum.tensor.frame).value;
      for (std::size_t row = 0; row < 3; ++row) {
        sum.tensor.value[row] = sum.tensor.value[row] + factor * term[row];
      }
    }
  }
}

/// x with everything in one frame.
Block Lowering::moved(const Value& v, const Block& x, int from, int to) const {
  Block result{x.number, {}, {to, {}}};
  if (v.type == Type::kVector) {
    result.vector = {{to, frames_.moved(frames_.in(x.vector, from), from, to)}};
  } else if (v.type == Type::kTensor) {
    result.tensor = frames_.moved(x.tensor, to);
  }
  return result;
}

// NOLINTNEXTLINE(readability-function-size): a row for every operation
Block Lowering::made(int id, const Value& v, int e) {
  switch (v.op) {
    case Op::kZero:
      return zero(v, e);
    case Op::kOnes:
      return {number(1), {}, {}};
    case Op::kIdentity:
      return {{}, {}, {home(v.set, e), constant(graph(), formulate::identity())}};
    case Op::kUnit:
      return unit(v, e);
    case Op::kLeaf:
      return leaf(v, e);
    case Op::kLinear:
      return linear(v, e);
    case Op::kScale:
      return scale(v, e);
    case Op::kDot:
    case Op::kCross:
    case Op::kSkew:
    case Op::kSkewProduct:
      return product(v, e);
    case Op::kProduct:
      return tensor_product(v, e);
    case Op::kComposite:
      return composite(id, v, e);
    case Op::kMoment:
      return moment(v, e);
    case Op::kSquare:
      return square(v, e);
    case Op::kPseudo:
      return pseudo(v, e);
    case Op::kApply:
    case Op::kApplyTranspose:
      return applied(v, e);
    case Op::kPath:
    case Op::kPathStrict:
      return path(id, v, e);
    case Op::kSubtree:
    case Op::kSubtreeStrict:
    case Op::kBackward:
      return subtree(id, v, e);
    case Op::kTravelling: {
      const int definition = derivation_.values.definitions().at(id);
      need(definition, e);
      return of(definition, e);
    }
    case Op::kFold:
      return folded(id, v, e);
    case Op::kAtLink:
      return once(v, e);
    case Op::kReciprocal:
      return {number(1) / of(v.operands.front(), e).number, {}, {}};
    case Op::kLever:
      return lever(v, e);
    case Op::kAcross:
      return across(v, e);
    case Op::kAlong:
      return along(v, e);
    case Op::kFather:
    case Op::kSons:
      return shifted(v, e);
    case Op::kGather:
    case Op::kPick:
      return at_points(v, e);
    case Op::kSpread:
      return spread(id, v, e);
    case Op::kCollect:
      return collect(v);
    case Op::kComponent:
    case Op::kAssemble:
      return components(v, e);
    case Op::kEliminated:  // of Numbers
    case Op::kFromLeaves:
    case Op::kFromRoot:
    case Op::kDiagonal:
    case Op::kTransposed:
    case Op::kCongruence:
      break;
  }
  return zero(v, e);
}

std::vector<Expr> Lowering::written(int k, Set set, int frame) {
  const int root = derivation_.roots[to_index(k)];
  const std::size_t before = graph().size();
  std::vector<Expr> result;
  for (int e = 0; e < count(set); ++e) {
    const Block& block = of(root, e);
    switch (value(root).type) {
      case Type::kScalar:
        result.push_back(block.number);
        break;
      case Type::kVector: {
        const Vec3 x = frames_.in(block.vector, frame);
        result.insert(result.end(), x.begin(), x.end());
        break;
      }
      case Type::kTensor:
        for (const Vec3& row : frames_.moved(block.tensor, frame).value) {
          result.insert(result.end(), row.begin(), row.end());
        }
    }
  }
  own(before, root);
  return result;
}

}  // namespace treedyn::formulate
