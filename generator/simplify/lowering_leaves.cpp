// Symbols and inputs in frames.
#include <algorithm>

#include "common/error.hpp"
#include "simplify/lowering.hpp"

namespace treedyn::simplify {
namespace {

using block::Set;
using derive::Op;
using derive::Type;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

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
  const Inputs& inputs = task_.kinematics.inputs();
  const bool of_joints = argument.name == "qd" || argument.name == "qdd" || argument.name == "tau";
  const int of_joint = argument.name == "qd"    ? inputs.qd
                       : argument.name == "qdd" ? inputs.qdd
                                                : inputs.tau;
  for (int e = 0; e < count(v.set); ++e) {
    if (of_joints) {
      blocks.numbers[index(e)] = task_.kinematics.of_joint(e, of_joint);
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

/// The symbols of EQUATIONS.md 1: axes and centres in the link, s in the father. Where the places
/// of joints are free, those of sliding joints slide: then s has the slide of its own joint.
Blocks Lowering::link_leaf(const Value& v) const {
  const Kinematics& k = task_.kinematics;
  Blocks blocks = empty(v);
  const auto slide = [&](int i) {
    const bool fixed = function_.keeps_joints && i != kBase && !k.link(i).revolute;
    return fixed ? Vec3{Expr(), Expr(), k.displacement(i)} : Vec3{};
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
      blocks.numbers[index(e)] = function_.regroups ? k.body(e).mass : number(link.inertia.mass);
    } else if (v.name == "h^d") {
      blocks.vectors[index(e)] = {
          {e, function_.regroups ? k.body(e).moment
                                 : number(link.inertia.mass) * k.point(e, link.inertia.com)}};
    } else if (v.name == "σ" || v.name == "E-σ") {
      blocks.numbers[index(e)] = number(k.link(e).revolute == (v.name == "σ") ? 1 : 0);
    } else if (v.name == "z^d") {
      blocks.vectors[index(e)] = {{e, {Expr(), Expr(), number(k.link(e).sign)}}};
    } else if (v.name == "l^d") {
      blocks.vectors[index(e)] = {{e, slide(e)}};
    } else if (v.name == "c^d") {
      blocks.vectors[index(e)] = {{e, k.point(e, link.inertia.com)}};
    } else if (v.name == "s^d") {
      const Vec3 own = function_.keeps_joints ? k.joint_offset(e) : k.offset(e);
      blocks.vectors[index(e)] = {{father(e), own + slide(father(e))}};
    } else if (v.name == "J_c^d") {
      blocks.tensors[index(e)] = {e, k.tensor_of(e, link.inertia.about_com)};
    } else {
      TREEDYN_EXPECT(v.name == "g");
      blocks.vectors[index(e)] = {{kBase, -k.ground_acceleration()}};
    }
  }
  return blocks;
}

}  // namespace treedyn::simplify
