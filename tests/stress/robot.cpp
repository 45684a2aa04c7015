#include "stress/robot.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "common/index.hpp"
#include "engine/engine.hpp"
#include "model/force_laws.hpp"

namespace treedyn::stress {

namespace {

using support::Dice;

/// 10^k, k within half of `decades` of zero.
Real power(int decades, Dice& dice) { return pow(Real(10), dice.below(decades + 1) - decades / 2); }

void scale(model::Link& link, const Real& mass, const Real& length) {
  link.inertia.mass *= mass;
  for (std::size_t k = 0; k < 3; ++k) {
    link.inertia.com[k] *= length;
    link.joint.offset[k] *= length;
  }
  for (Real& J : link.inertia.about_com) {
    J *= mass * length * length;
  }
}

/// Inputs that float has, too: multiples of 1/64 and, one in four, a small one.
Values inputs(int count, double limit, Dice& dice) {
  Values result;
  for (int k = 0; k < count; ++k) {
    const bool small = dice.below(4) == 0;
    result.emplace_back(dice.number(limit) * (small ? 1.0 / 1048576 : 1.0));
  }
  return result;
}

/// Force or moment at a point of a link along one to three axes.
model::Constraint constraint_at(int point, Dice& dice) {
  model::Constraint result;
  result.kind =
      dice.below(4) == 0 ? model::ConstraintKind::kOrientation : model::ConstraintKind::kPoint;
  result.point = point;
  result.pinned = result.kind == model::ConstraintKind::kPoint;
  const int first = dice.below(3);
  const int count = 1 + dice.below(3);
  for (int k = 0; k < count; ++k) {
    model::Vector3 d{};
    d[to_index((first + k) % 3)] = 1;
    result.directions.push_back(d);
  }
  return result;
}

void add_constraints(model::Scene& scene, Dice& dice) {
  const int wanted = dice.below(4);
  for (int k = 0; k < wanted; ++k) {
    const int point = dice.below(static_cast<int>(scene.points.size()));
    if (scene.points[to_index(point)].link == model::kGround) {
      continue;
    }
    model::Constraint constraint = constraint_at(point, dice);
    constraint.name = fmt::format("c{}", scene.constraints.size());
    scene.constraints.push_back(constraint);
  }
  if (!scene.constraints.empty() && dice.below(4) == 0) {  // the same rows twice
    model::Constraint again = scene.constraints.front();
    again.name = fmt::format("c{}", scene.constraints.size());
    scene.constraints.push_back(again);
  }
}

/// One phase with all constraints, and the springs in the scene.
void activate_all(Robot& robot) {
  std::vector<int> all(robot.scene.constraints.size());
  std::iota(all.begin(), all.end(), 0);
  robot.scene.phases = {{"all", all, {}}};
  robot.scene.joint_laws.clear();
  for (const Spring& spring : robot.springs) {
    robot.scene.joint_laws.push_back(
        model::joint_spring(spring.joint, spring.stiffness, spring.damping, spring.rest));
  }
}

}  // namespace

Robot random_robot(const std::string& name, int decades, Dice& dice) {
  Robot robot;
  robot.name = name;
  model::Scene& scene = robot.scene;
  scene.name = name;
  const int links = 1 + dice.below(6);
  scene.tree = support::random_tree(support::random_shape(links, dice), dice);
  const Real length = power(6, dice);
  const Real mass = power(decades, dice);
  const bool mixed = dice.below(2) == 0;
  for (model::Link& link : scene.tree.links) {
    scale(link, mixed ? power(decades, dice) : mass, length * (mixed ? power(2, dice) : Real(1)));
  }
  scene.points = support::random_points(scene.tree, 2, dice);
  for (model::Point& point : scene.points) {
    for (Real& x : point.at) {
      x *= length;
    }
  }
  scene.gravity = {0, 0, Real("-9.81")};
  add_constraints(scene, dice);
  if (dice.below(3) == 0) {
    robot.springs.push_back(
        {dice.below(links), power(decades, dice), power(decades, dice), Real(dice.number(1))});
  }
  activate_all(robot);
  robot.q = inputs(links, 3, dice);
  robot.qd = inputs(links, 2, dice);
  robot.tau = inputs(links, 8, dice);
  scene.q0 = robot.q;
  scene.qd0 = robot.qd;
  return robot;
}

Robot perturbed(const Robot& robot, const Real& change, Dice& dice) {
  Robot result = robot;
  const auto vary = [&](Real& x) {
    x *= 1 + change * Real(dice.number(1));
  };
  const auto vary_all = [&](auto& values) {
    std::for_each(values.begin(), values.end(), vary);
  };
  for (model::Link& link : result.scene.tree.links) {
    vary(link.inertia.mass);
    vary_all(link.inertia.com);
    vary_all(link.joint.offset);
    vary_all(link.joint.rotation);
    vary_all(link.joint.axis);
    model::Matrix3& J = link.inertia.about_com;
    vary_all(J);
    J[3] = J[1];
    J[6] = J[2];
    J[7] = J[5];
  }
  for (model::Point& point : result.scene.points) {
    vary_all(point.at);
  }
  for (Spring& spring : result.springs) {
    vary(spring.stiffness);
    vary(spring.damping);
    vary(spring.rest);
  }
  activate_all(result);
  vary(result.scene.gravity[2]);
  vary_all(result.q);
  vary_all(result.qd);
  vary_all(result.tau);
  return result;
}

std::vector<Robot> smaller(const Robot& robot) {
  std::vector<Robot> result;
  const auto add = [&](Robot less) {
    activate_all(less);
    result.push_back(std::move(less));
  };
  for (std::size_t k = 0; k < robot.scene.constraints.size(); ++k) {
    Robot less = robot;
    less.scene.constraints.erase(less.scene.constraints.begin() + static_cast<std::ptrdiff_t>(k));
    add(std::move(less));
  }
  if (!robot.springs.empty()) {
    Robot less = robot;
    less.springs.clear();
    add(std::move(less));
  }
  const int last = robot.scene.tree.size() - 1;
  if (last > 0) {
    Robot less = robot;
    less.scene.tree.links.pop_back();
    less.scene.tree.drives.pop_back();
    less.scene.tree.coordinates.pop_back();
    std::erase_if(less.scene.constraints, [&](const model::Constraint& constraint) {
      return less.scene.points[to_index(constraint.point)].link == last;
    });
    std::erase_if(less.springs, [&](const Spring& spring) { return spring.joint == last; });
    for (model::Point& point : less.scene.points) {
      point.link = std::min(point.link, last - 1);
    }
    for (Values* values : {&less.q, &less.qd, &less.tau, &less.scene.q0, &less.scene.qd0}) {
      values->pop_back();
    }
    add(std::move(less));
  }
  return result;
}

namespace {

std::string text(const Real& x) { return x.str(40, std::ios_base::scientific); }

template <class List>
std::string list_text(const List& values) {
  std::vector<std::string> words;
  std::transform(values.begin(), values.end(), std::back_inserter(words), text);
  return fmt::format("[{}]", fmt::join(words, ", "));
}

std::string matrix_text(const model::Matrix3& M) {
  std::vector<std::string> rows;
  for (std::size_t k = 0; k < 9; k += 3) {
    rows.push_back(list_text(Values(M.begin() + k, M.begin() + k + 3)));
  }
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

std::string body_text(const model::Link& link) {
  return fmt::format(
      "{{\"name\": \"{}\", \"father\": {}, \"joint\": \"{}\", \"axis\": {}, \"offset\": {},\n"
      "     \"R0\": {}, \"mass\": {}, \"com\": {},\n     \"inertia\": {}}}",
      link.name, link.father + 1,
      link.joint.type == model::JointType::kRevolute ? "revolute" : "prismatic",
      list_text(link.joint.axis), list_text(link.joint.offset), matrix_text(link.joint.rotation),
      text(link.inertia.mass), list_text(link.inertia.com), matrix_text(link.inertia.about_com));
}

std::string constraint_text(const Robot& robot, const model::Constraint& constraint,
                            const Values& positions) {
  const model::Point& point = robot.scene.points[to_index(constraint.point)];
  std::vector<std::string> directions;
  std::transform(constraint.directions.begin(), constraint.directions.end(),
                 std::back_inserter(directions), list_text<model::Vector3>);
  const std::string begin =
      fmt::format("{{\"name\": \"{}\", \"body\": {}, \"dirs\": [{}]", constraint.name,
                  point.link + 1, fmt::join(directions, ", "));
  if (constraint.kind == model::ConstraintKind::kOrientation) {
    return begin + ", \"type\": \"orientation\"}";
  }
  const auto at = positions.begin() + 3 * constraint.point;
  return begin + fmt::format(
                     ",\n     \"type\": \"point\", \"point\": {}, \"curve\": {{\"center\": {}, "
                     "\"velocity\": [0, 0, 0], \"u\": [0, 0, 0], \"v\": [0, 0, 0], \"A1\": 0, "
                     "\"A2\": 0, \"omega\": 0, \"phase\": 0}}}}",
                     list_text(point.at), list_text(Values(at, at + 3)));
}

}  // namespace

std::string case_text(const Robot& robot, const Values& qdd, const std::string& source,
                      const Real& tol_double, const Real& tol_float) {
  const model::Scene& scene = robot.scene;
  engine::Engine<Real> engine(scene.tree, scene.points, scene.gravity);
  const Values positions = engine.evaluate("point_positions", {robot.q});
  std::vector<std::string> bodies;
  std::transform(scene.tree.links.begin(), scene.tree.links.end(), std::back_inserter(bodies),
                 body_text);
  std::vector<std::string> constraints;
  for (const model::Constraint& constraint : scene.constraints) {
    constraints.push_back(constraint_text(robot, constraint, positions));
  }
  std::vector<std::string> springs;
  for (const Spring& spring : robot.springs) {
    springs.push_back(fmt::format("{{\"joint\": {}, \"k\": {}, \"d\": {}, \"q0\": {}}}",
                                  spring.joint + 1, text(spring.stiffness), text(spring.damping),
                                  text(spring.rest)));
  }
  return fmt::format(
      "{{\n  \"schema\": \"hard-case/1\",\n  \"id\": \"{}\",\n  \"source\": \"{}\",\n  \"model\": "
      "{{\"bodies\": [\n    {}\n  ]}},\n  \"scene\": {{\n    \"gravity\": {},\n    \"q0\": {},\n   "
      " "
      "\"qd0\": {},\n    \"tau\": {},\n    \"t0\": 0, \"duration\": 0, \"redundant\": true,\n    "
      "\"joint_springs\": [{}],\n    \"constraints\": [{}]\n  }},\n  \"expected\": "
      "[{{\"quantity\": \"qdd\", \"time\": 0, \"value\": {}, \"tol_double\": {}, \"tol_float\": "
      "{}}}]\n}}\n",
      robot.name, source, fmt::join(bodies, ",\n    "), list_text(scene.gravity),
      list_text(robot.q), list_text(robot.qd), list_text(robot.tau), fmt::join(springs, ", "),
      fmt::join(constraints, ",\n    "), list_text(qdd), text(tol_double), text(tol_float));
}

}  // namespace treedyn::stress
