#include "simulation/column_names.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "model/force_laws.hpp"
#include "model/scene_facts.hpp"
#include "simulation/forces.hpp"
#include "simulation/pose.hpp"

namespace treedyn::simulation {

namespace {

/// x, y, z for an axis, else a number from 1.
std::string direction_name(const model::Constraint& constraint, std::size_t row) {
  if (constraint.kind == model::ConstraintKind::kJoint) {
    return "";
  }
  const model::Vector3& d = constraint.directions[row];
  for (std::size_t k = 0; k < 3; ++k) {
    if (d[k] == 1 && d[(k + 1) % 3] == 0 && d[(k + 2) % 3] == 0) {
      return std::string(".") + "xyz"[k];
    }
  }
  return fmt::format(".{}", row + 1);
}

}  // namespace

std::vector<std::string> reaction_names(const model::Scene& scene) {
  std::vector<std::string> result;
  for (const model::Constraint& constraint : scene.constraints) {
    for (std::size_t k = 0; k < constraint.rows(); ++k) {
      result.push_back(constraint.name + direction_name(constraint, k));
    }
  }
  return result;
}

namespace {

const std::string& point_name(const model::Scene& scene, int point) {
  return scene.points[static_cast<std::size_t>(point)].name;
}

void add_reactions(const model::Scene& scene, std::vector<Column>& result) {
  const std::vector<std::string> names = reaction_names(scene);
  std::size_t row = 0;
  for (const model::Constraint& constraint : scene.constraints) {
    for (std::size_t k = 0; k < constraint.rows(); ++k) {
      result.push_back({fmt::format("R[{}]", names[row++]),
                        model::is_angular(scene.tree, constraint) ? "N m" : "N"});
    }
  }
}

/// In the order of Forces::append_forces.
void add_forces(const model::Scene& scene, std::vector<Column>& result) {
  for (const auto& [effect, name] : model::kShownOfJoints) {
    for (const model::JointLaw& law : model::laws_of(scene.joint_laws, effect)) {
      result.push_back({fmt::format("{}[{}]", name, scene.tree.moved_by(law.joint).joint.name),
                        scene.tree.moved_by(law.joint).joint.turns() ? "N m" : "N"});
    }
  }
  for (const model::PointLaw& law : model::laws_of(scene.point_laws, "point_spring")) {
    result.push_back({fmt::format("spring[{}]", point_name(scene, law.point)), "N"});
  }
  for (const model::GroundContact& contact : scene.contacts) {
    for (const char axis : {'x', 'y', 'z'}) {
      result.push_back({fmt::format("F[{}.{}]", point_name(scene, contact.point), axis), "N"});
    }
  }
}

/// x, y, z or vx, vy, vz of points in a state.
model::AtPoint points_at(const model::Scene& scene, const std::vector<double>& state) {
  const auto n = static_cast<Eigen::Index>(state.size() / 2);
  const Eigen::Map<const Vector> values(state.data(), 2 * n);
  Pose pose(scene.tree, scene.gravity);
  pose.update(values.head(n), values.tail(n));
  return [&scene, pose](int number, const model::Variable& variable) {
    const model::Point& point = scene.points[static_cast<std::size_t>(number)];
    const bool is_place = variable.quantity == model::Quantity::kPointPosition;
    const Eigen::Vector3d at = vector_of(point.at);
    if (point.link == model::kGround) {
      return is_place ? at[variable.index] : 0;
    }
    const LinkState& link = pose.links()[static_cast<std::size_t>(point.link)];
    const Eigen::Vector3d place = pose.point(point.link, at);
    return is_place ? place[variable.index]
                    : link.v[variable.index] + link.omega.cross(place - link.O)[variable.index];
  };
}

/// A second spring of one joint is `spring[joint]#2`.
void number_equals(std::vector<Column>& columns) {
  std::map<std::string, int> counts;
  for (Column& column : columns) {
    if (const int count = ++counts[column.name]; count > 1) {
      column.name += fmt::format("#{}", count);
    }
  }
}

}  // namespace

std::vector<Column> columns_of(const model::Scene& scene) {
  std::vector<Column> result;
  for (const bool rate : {false, true}) {
    for (int k = 0; k < scene.tree.dof(); ++k) {
      result.push_back(
          {fmt::format("{}[{}]", rate ? "qd" : "q", scene.tree.moved_by(k).joint.name),
           std::string(scene.tree.moved_by(k).joint.turns() ? "rad" : "m") + (rate ? "/s" : "")});
    }
  }
  add_reactions(scene, result);
  add_forces(scene, result);
  for (const model::Point& point : scene.points) {
    for (const char axis : {'x', 'y', 'z'}) {
      if (point.link != model::kGround) {
        result.push_back({fmt::format("p[{}.{}]", point.name, axis), "m"});
      }
    }
  }
  for (const char* const energy : {"kinetic_energy", "potential_energy", "energy"}) {
    result.push_back({energy, "J"});
  }
  result.push_back({"drift", ""});
  number_equals(result);
  return result;
}

std::string event_name(const model::Scene& scene, int phase, std::size_t event) {
  const model::Event& e = scene.phases[static_cast<std::size_t>(phase)].until[event];
  switch (e.kind) {
    case model::EventKind::kHeight:
      return "touch_down of " + scene.points[static_cast<std::size_t>(e.point)].name;
    case model::EventKind::kReaction:
      return "lift_off of " + scene.constraints[static_cast<std::size_t>(e.constraint)].name;
    case model::EventKind::kTime:
      return "time";
    case model::EventKind::kExpression:
      break;
  }
  return fmt::format("expression {}", event + 1);
}

std::string no_value(const model::Scene& scene, double time, const std::vector<double>& state) {
  constexpr double kSoon = 1e-9;  // s, or of the time
  const std::size_t n = state.size() / 2;
  for (const double later : {0.0, kSoon * std::max(1.0, std::fabs(time))}) {
    std::vector<double> then = state;
    for (std::size_t k = 0; k < n; ++k) {
      then[k] += later * state[n + k];
    }
    const std::string lost =
        model::without_value(scene, time + later, then, points_at(scene, then));
    if (!lost.empty()) {
      return fmt::format("{} has no value {} t = {:.6g} s", lost, later > 0 ? "just behind" : "at",
                         time);
    }
  }
  return "";
}

std::string not_finite(const model::Scene& scene, double time, const std::vector<double>& state) {
  std::string lost = no_value(scene, time, state);
  if (!lost.empty()) {
    return lost;
  }
  const model::Tree& tree = scene.tree;
  const std::size_t n = state.size() / 2;
  std::size_t fastest = 0;
  for (std::size_t k = 1; k < n; ++k) {
    fastest = std::fabs(state[n + k]) > std::fabs(state[n + fastest]) ? k : fastest;
  }
  const auto joint = static_cast<int>(fastest);
  return fmt::format(
      "the motion is not finite at t = {:.6g} s; before, joint '{}' was at {:.6g} and moved at "
      "{:.3g} {}",
      time, tree.moved_by(joint).joint.name, state[fastest], state[n + fastest],
      tree.moved_by(joint).joint.turns() ? "rad/s" : "m/s");
}

}  // namespace treedyn::simulation
