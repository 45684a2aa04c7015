#include "simplify/lowering.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace treedyn::simplify {
namespace {

using block::Set;
using derive::Op;
using derive::Type;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Mat3 skew(const Vec3& a) {
  return {{{Expr(), -a[2], a[1]}, {a[2], Expr(), -a[0]}, {-a[1], a[0], Expr()}}};
}

Mat3 transposed(const Mat3& m) { return {column(m, 0), column(m, 1), column(m, 2)}; }

}  // namespace

Lowering::Lowering(const Task& task, const Derived& function)
    : task_(task),
      function_(function),
      frames_(task.kinematics, task.kinematics.variant().from_root),
      needed_(function.derivation.values.needed(function.derivation.roots)),
      of_unit_(index(function.derivation.values.size()), false),
      memo_(index(function.derivation.values.size())),
      costs_(index(function.derivation.values.size())) {
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

const Blocks& Lowering::root(int k) { return of(function_.derivation.roots[index(k)]); }

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

Blocks Lowering::unit(const Value& v) const {
  Blocks blocks = empty(v);
  if (v.type == Type::kScalar) {
    blocks.numbers[index(place_)] = number(1);
  } else {
    Vec3 e;
    e[index(component_)] = number(1);
    blocks.vectors[index(place_)] = {{kBase, e}};
  }
  return blocks;
}

Blocks Lowering::leaf(const Value& v) const {
  const equations::UserEquation& equation = function_.equation;
  for (std::size_t k = 0; k < equation.arguments.size(); ++k) {
    const std::string& name = equation.arguments[k].name;
    const bool rates = name == "qd" && v.name == "q̇";
    if ((name != "q" && equation.arguments[k].leaf == v.name) || rates) {
      return input(v, equation.arguments[k], static_cast<int>(k));
    }
  }
  if (const auto found = equation.frames.find(v.name); found != equation.frames.end()) {
    return orientation(found->second);
  }
  if (const auto found = equation.constants.find(v.name); found != equation.constants.end()) {
    Blocks blocks = empty(v);
    std::transform(found->second.begin(), found->second.end(), blocks.numbers.begin(),
                   [this](const Real& x) { return number(x); });
    return blocks;
  }
  return link_leaf(v);
}

Expr Lowering::element(int array, int k) const { return {graph(), graph().input(array, k)}; }

/// Joint values of a link are multiples of its coordinate's.
Blocks Lowering::input(const Value& v, const equations::UserArgument& argument, int array) const {
  Blocks blocks = empty(v);
  const bool of_joints = argument.name == "qd" || argument.name == "qdd" || argument.name == "tau";
  for (int e = 0; e < count(v.set); ++e) {
    if (of_joints) {
      const model::Drive& drive = task_.tree.drives[index(e)];
      blocks.numbers[index(e)] = number(drive.multiplier) * element(array, drive.coordinate);
    } else if (v.type == Type::kScalar) {
      blocks.numbers[index(e)] = element(array, e);
    } else {
      Vec3 x;
      for (int k = 0; k < 3; ++k) {
        x[index(k)] = element(array, 3 * e + k);
      }
      blocks.vectors[index(e)] = {{kBase, x}};
    }
  }
  return blocks;
}

/// The axes of a link in the base frame are the columns of its rotation.
Blocks Lowering::orientation(const equations::UserFrame& frame) const {
  Mat3 R;
  const Mat3 own = frame.link == kBase ? Mat3{} : task_.kinematics.orientation(frame.link);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 column = {frame.rotation[k], frame.rotation[3 + k], frame.rotation[6 + k]};
    const Vec3 axis = constant(graph(), column);
    R[k] = frame.link == kBase ? axis : frames_.moved(own * axis, frame.link, kBase);
  }
  Blocks blocks;
  blocks.tensors = {{kBase, transposed(R)}};
  return blocks;
}

/// The symbols of EQUATIONS.md 1: axes and centres in the link, s in the father.
Blocks Lowering::link_leaf(const Value& v) const {
  const Kinematics& k = task_.kinematics;
  Blocks blocks = empty(v);
  const auto slide = [&](int i) {
    return k.link(i).revolute ? Vec3{} : Vec3{Expr(), Expr(), k.displacement(i)};
  };
  for (int e = 0; e < count(v.set); ++e) {
    if (v.name == "t^d") {
      const model::Point& point = task_.options.points[index(e)];
      blocks.vectors[index(e)] = {
          {point.link, point.link == kBase ? constant(graph(), point.at)
                                           : k.point(point.link, point.at) + slide(point.link)}};
      continue;
    }
    const model::Link& link = task_.tree.links[index(e)];
    graph().set_body(e);
    if (v.name == "m^d") {
      blocks.numbers[index(e)] = number(link.inertia.mass);
    } else if (v.name == "σ" || v.name == "E-σ") {
      blocks.numbers[index(e)] = number(k.link(e).revolute == (v.name == "σ") ? 1 : 0);
    } else if (v.name == "z^d") {
      blocks.vectors[index(e)] = {{e, {Expr(), Expr(), number(k.link(e).sign)}}};
    } else if (v.name == "l^d") {
      blocks.vectors[index(e)] = {{e, slide(e)}};
    } else if (v.name == "c^d") {
      blocks.vectors[index(e)] = {{e, k.point(e, link.inertia.com)}};
    } else if (v.name == "s^d") {
      const Vec3 of_father = father(e) == kBase ? Vec3{} : slide(father(e));
      blocks.vectors[index(e)] = {{father(e), k.joint_offset(e) + of_father}};
    } else if (v.name == "J_c^d") {
      blocks.tensors[index(e)] = {e, k.tensor_of(e, link.inertia.about_com)};
    } else {
      TREEDYN_EXPECT(v.name == "g");
      blocks.vectors[index(e)] = {{kBase, constant(graph(), task_.options.gravity)}};
    }
  }
  return blocks;
}

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
      y.vectors[index(i)] = {{at, carried + frames_.in(own, at)}};
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

/// Sums of vectors gather along the tree: one rotation a link.
Blocks Lowering::collect(const Value& v) const {
  const Value& from = value(v.operands.front());
  const Blocks& x = of(v.operands.front());
  Blocks blocks = empty(v);
  TREEDYN_EXPECT(v.type != Type::kTensor);
  if (v.type == Type::kScalar) {
    for (const Expr& term : x.numbers) {
      blocks.numbers.front() += term;
    }
    return blocks;
  }
  std::vector<Parts> at_link(index(task_.tree.size()));
  Parts& ground = blocks.vectors.front();
  for (int e = 0; e < count(from.set); ++e) {
    for (const Part& part : x.vectors[index(e)]) {
      frames_.add(part.frame == kBase ? ground : at_link[index(part.frame)], {part}, number(1));
    }
  }
  for (int i = task_.tree.size() - 1; i >= 0; --i) {
    graph().set_body(i);
    const int above = frames_.in_base() ? kBase : father(i);
    const Vec3 up = frames_.moved(frames_.in(at_link[index(i)], i), i, above);
    frames_.add(above == kBase ? ground : at_link[index(above)], {{above, up}}, number(1));
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

std::vector<Expr> Lowering::written(const Blocks& blocks, Set set) const {
  std::vector<Expr> result = blocks.numbers;
  for (int e = 0; e < count(set) && !blocks.vectors.empty(); ++e) {
    const Vec3 x = frames_.in(blocks.vectors[index(e)], kBase);
    result.insert(result.end(), x.begin(), x.end());
  }
  return result;
}

}  // namespace treedyn::simplify
