#include "simulation/watch.hpp"

#include <cmath>

namespace treedyn::simulation {

double Watch::value(System& system, double t, const Vector& y) const {
  const Eigen::Index n = system.dof();
  switch (kind) {
    case Kind::kEvent:
    case Kind::kContact:
      return plane.height(system.geometry(y.head(n)).p().segment<3>(3 * point));
    case Kind::kReaction:
      return system.reaction(t, y, event->constraint).dot(plane.normal());
    case Kind::kTime:
      return until - t;
    case Kind::kExpression:
      return value_of(event->value, {t, y.head(n), y.tail(n)});
    case Kind::kSlip:
      return y[n + system.frictions()[index].joint];
    case Kind::kStick:
      system.accelerate(t, y.head(n), y.tail(n));
      return system.frictions()[index].hold() - std::fabs(system.holding_force(index));
  }
  return 0;
}

double Watch::slope(System& system, const Vector& y) const {
  const Eigen::Index n = system.dof();
  const auto C = system.geometry(y.head(n)).C().middleCols<3>(3 * point);
  return (C * plane.normal()).dot(y.tail(n));
}

bool Watch::looks_at_what(const Watch& other) const {
  if (kind != other.kind || event == nullptr) {
    return false;
  }
  return kind == Kind::kEvent
             ? point == other.point && event->plane.normal == other.event->plane.normal &&
                   event->plane.height == other.event->plane.height
             : kind == Kind::kExpression && event->value == other.event->value;
}

int Watch::side_of(System& system, double t, const Vector& y) const {
  if (kind == Kind::kReaction) {
    return 1;
  }
  const double g = value(system, t, y);
  if (is_height() && std::fabs(g) < kOnPlane) {
    return lands || slope(system, y) > -kAtRest ? 1 : -1;
  }
  return g >= 0 ? 1 : -1;
}

}  // namespace treedyn::simulation
