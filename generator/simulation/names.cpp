#include "simulation/names.hpp"

#include <fmt/format.h>

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

std::string joint_name(const model::Tree& tree, int coordinate) {
  const int link = tree.coordinates[static_cast<std::size_t>(coordinate)];
  return tree.links[static_cast<std::size_t>(link)].joint.name;
}

std::vector<std::string> reaction_names(const model::Scene& scene) {
  std::vector<std::string> result;
  for (const model::Constraint& constraint : scene.constraints) {
    for (std::size_t k = 0; k < constraint.rows(); ++k) {
      result.push_back(constraint.name + direction_name(constraint, k));
    }
  }
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

}  // namespace treedyn::simulation
