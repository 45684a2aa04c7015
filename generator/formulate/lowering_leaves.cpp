// Symbols and inputs in frames.
#include <algorithm>
#include <functional>
#include <iterator>

#include "common/error.hpp"
#include "common/index.hpp"
#include "equations/kinematics.hpp"
#include "equations/number_of_tree.hpp"
#include "formulate/lowering.hpp"

namespace treedyn::formulate {
namespace {

using derive::Type;

}  // namespace

Block Lowering::unit(const Value& v, int e) const {
  Block result = zero(v, e);
  if (e == place_ && v.type == Type::kScalar) {
    result.number = number(1);
  } else if (e == place_) {
    Vec3 x;
    x[to_index(component_)] = number(1);
    result.vector = {{kBase, x}};
  }
  return result;
}

Block Lowering::leaf(const Value& v, int e) const {
  const equations::UserEquation& equation = function_.equation;
  for (std::size_t k = 0; k < equation.arguments.size(); ++k) {
    const std::string& name = equation.arguments[k].name;
    const bool rates = name == "qd" && v.name == "q̇";
    if ((name != "q" && equation.arguments[k].leaf == v.name) || rates) {
      return input(v, equation.arguments[k], static_cast<int>(k), e);
    }
  }
  if (const auto found = equation.frames.find(v.name); found != equation.frames.end()) {
    return orientation(found->second);
  }
  if (const auto found = equation.constants.find(v.name); found != equation.constants.end()) {
    return {number(found->second[to_index(e)]), {}, {}};
  }
  if (const auto found = equation.reciprocals.find(v.name); found != equation.reciprocals.end()) {
    return {number(reciprocal(found->second)), {}, {}};
  }
  return link_leaf(v, e);
}

Real Lowering::reciprocal(const block::Expression& divisor) const {
  std::vector<Real> masses;
  std::ranges::transform(task_.tree.links, std::back_inserter(masses),
                         [](const model::Link& link) { return link.inertia.mass; });
  return 1 / equations::number_of_tree<Real>(function_.equation, divisor,
                                             equations::index_of(task_.tree, task_.options.points),
                                             masses, std::identity());
}

/// Joint values of a link are multiples of its coordinate's.
Block Lowering::input(const Value& v, const equations::UserArgument& argument, int array,
                      int e) const {
  const Inputs& inputs = task_.kinematics.inputs();
  const bool of_joints = argument.name == "qd" || argument.name == "qdd" || argument.name == "tau";
  const int of_joint = argument.name == "qd"    ? inputs.qd
                       : argument.name == "qdd" ? inputs.qdd
                                                : inputs.tau;
  if (of_joints) {
    return {task_.kinematics.of_joint(e, of_joint), {}, {}};
  }
  if (v.type == Type::kScalar) {
    return {program::input(graph(), array, e), {}, {}};
  }
  if (const PointLoads* const loads = task_.kinematics.loads()) {
    return {{}, {{kBase, (argument.name == "f" ? loads->f : loads->n)[to_index(e)]}}, {}};
  }
  Vec3 x;
  for (int k = 0; k < 3; ++k) {
    x[to_index(k)] = program::input(graph(), array, 3 * e + k);
  }
  return {{}, {{kBase, x}}, {}};
}

/// The axes of a link in the base frame are the columns of its rotation.
Block Lowering::orientation(const equations::UserFrame& frame) const {
  Mat3 R;
  const Mat3 own = frame.link == kBase ? Mat3{} : task_.kinematics.orientation(frame.link);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 column = {frame.rotation[k], frame.rotation[3 + k], frame.rotation[6 + k]};
    const Vec3 axis = constant(graph(), column);
    R[k] = frame.link == kBase ? axis : frames_.moved(own * axis, frame.link, kBase);
  }
  return {{}, {}, {kBase, transposed(R)}};
}

/// I = J_c - m Λ(c)², or what regrouping has made of it.
Mat3 Lowering::tensor_about_joint(int e) const {
  const Kinematics& k = task_.kinematics;
  if (function_.regroups) {
    return k.body_with_inertia_tensor(e).tensor;
  }
  const model::Inertia& inertia = task_.tree.links[to_index(e)].inertia;
  const Mat3 square = skew_squared(k.point(e, inertia.com));
  Mat3 I = k.tensor_of(e, inertia.about_com);
  for (std::size_t row = 0; row < 3; ++row) {
    I[row] = I[row] - number(inertia.mass) * square[row];
  }
  return I;
}

/// Ψ of I = tr(Ψ) E_3 - Ψ.
Mat3 Lowering::second_moments(int e) const {
  if (function_.regroups) {
    return task_.kinematics.body(e).tensor;
  }
  return second_moments_of(graph(), tensor_about_joint(e));
}

/// The symbols of EQUATIONS.md 1: axes and centres in the link, s in the father. Where the places
/// of joints are free, those of sliding joints slide: then s has the slide of its own joint.
Block Lowering::link_leaf(const Value& v, int e) const {
  const Kinematics& k = task_.kinematics;
  const auto slide = [&](int i) {
    const bool fixed = function_.keeps_joints && i != kBase && !k.link(i).revolute;
    return fixed ? Vec3{Expr(), Expr(), k.displacement(i)} : Vec3{};
  };
  const auto vector = [](int frame, const Vec3& x) {
    return Block{{}, {{frame, x}}, {}};
  };
  if (v.name == "t^d") {
    const model::Point& point = task_.options.points[to_index(e)];
    return vector(point.link, point.link == kBase
                                  ? constant(graph(), point.at)
                                  : k.point(point.link, point.at) + slide(point.link));
  }
  const model::Inertia& inertia = task_.tree.links[to_index(e)].inertia;
  if (v.name == "m^d") {
    return {function_.regroups ? k.body(e).mass : number(inertia.mass), {}, {}};
  }
  if (v.name == "h^d") {
    return vector(
        e, function_.regroups ? k.body(e).moment : number(inertia.mass) * k.point(e, inertia.com));
  }
  if (v.name == "σ" || v.name == "E-σ") {
    return {number(k.link(e).revolute == (v.name == "σ") ? 1 : 0), {}, {}};
  }
  if (v.name == "z^d") {
    return vector(e, {Expr(), Expr(), number(k.link(e).sign)});
  }
  if (v.name == "l^d") {
    return vector(e, slide(e));
  }
  if (v.name == "c^d") {
    return vector(e, k.point(e, inertia.com));
  }
  if (v.name == "s^d") {
    const Vec3 own = function_.keeps_joints ? k.joint_offset(e) : k.offset(e);
    return vector(father(e), own + slide(father(e)));
  }
  if (v.name == "J_c^d") {
    return {{}, {}, {e, k.tensor_of(e, inertia.about_com)}};
  }
  if (v.name == "I^d") {
    const bool pseudo = function_.regroups && (derivation_.elimination || !has_tensors());
    return {{}, {}, {e, pseudo ? inertia_tensor(second_moments(e)) : tensor_about_joint(e)}};
  }
  TREEDYN_EXPECT(v.name == "g");
  return vector(kBase, -k.ground_acceleration());
}

}  // namespace treedyn::formulate
