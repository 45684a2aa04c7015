#include "model/scene_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/index.hpp"
#include "model/force_laws.hpp"

namespace treedyn::model {

namespace {

constexpr std::array<std::pair<const char*, StepMethod>, 4> kMethods = {
    {{"semi-implicit-euler", StepMethod::kSemiImplicitEuler},
     {"rk4", StepMethod::kRk4},
     {"dopri5-fixed", StepMethod::kDopri5},
     {"sdirk2", StepMethod::kSdirk2}}};

bool contains(const std::vector<int>& all, int one) {
  return std::ranges::find(all, one) != all.end();
}

/// \param is_so  (phase, event that ends it) -> bool
template <class Predicate>
bool any_event(const Scene& scene, Predicate is_so) {
  return std::ranges::any_of(scene.phases, [&](const Phase& phase) {
    return std::ranges::any_of(phase.until,
                               [&](const Event& event) { return is_so(phase, event); });
  });
}

/// True if an event moves its curve to where its point is.
bool is_pinned_later(const Scene& scene, int constraint) {
  return any_event(scene, [constraint](const Phase& /*phase*/, const Event& event) {
    return contains(event.pins, constraint);
  });
}

/// True if its curve, or its orientation, is that of the moment when it begins to act.
bool begins_anywhere(const Scene& scene, int constraint) {
  const Constraint& c = scene.constraints[to_index(constraint)];
  return c.pinned || c.kind == ConstraintKind::kOrientation || is_pinned_later(scene, constraint);
}

}  // namespace

std::optional<StepMethod> step_method(const Scene& scene) {
  for (const auto& [name, method] : kMethods) {
    if (scene.stepping.integrator == name) {
      return method;
    }
  }
  return std::nullopt;
}

std::vector<std::string> step_method_names() {
  std::vector<std::string> names;
  for (const auto& [name, method] : kMethods) {
    names.emplace_back(name);
  }
  return names;
}

bool stays(const Scene& scene, int constraint) {
  return !is_pinned_later(scene, constraint) &&
         std::ranges::all_of(scene.phases, [constraint](const Phase& phase) {
           return contains(phase.active, constraint);
         });
}

bool is_placed_by_events(const Scene& scene, int constraint) {
  const auto begins = [&](const Phase& phase, const Event& event) {
    return contains(scene.phases[to_index(event.then)].active, constraint) &&
           !contains(phase.active, constraint);
  };
  return is_pinned_later(scene, constraint) ||
         (begins_anywhere(scene, constraint) && any_event(scene, begins));
}

bool is_stabilised(const Scene& scene, int constraint) {
  const Constraint& c = scene.constraints[to_index(constraint)];
  const bool loop = (c.kind == ConstraintKind::kJoined || c.loop) && step_method(scene) &&
                    scene.stepping.drift == Drift::kProjection;
  return c.accelerations.empty() && (loop || scene.stepping.drift == Drift::kBaumgarte);
}

bool has_place(const Scene& scene, int constraint) {
  const std::optional<std::vector<Real>>& loop = scene.constraints[to_index(constraint)].loop;
  return loop && !loop->empty() && scene.stepping.drift == Drift::kProjection;
}

Real stabilisation_rate(const Scene& scene) {
  const Real resolved = 1 / (2 * scene.stepping.step);
  const Real& wanted = scene.stepping.stabilisation;
  const bool held = scene.stepping.drift == Drift::kBaumgarte;
  return held || wanted.plain() <= resolved ? wanted : resolved;
}

int anchor_size(const Scene& scene, int constraint) {
  const Constraint& c = scene.constraints[to_index(constraint)];
  if (!is_stabilised(scene, constraint) || c.kind == ConstraintKind::kJoined ||
      !begins_anywhere(scene, constraint) || has_place(scene, constraint)) {
    return 0;
  }
  return c.kind == ConstraintKind::kOrientation ? 9 : c.kind == ConstraintKind::kPoint ? 3 : 1;
}

int anchor_offset(const Scene& scene, int constraint) {
  int offset = 0;
  for (int c = 0; c < constraint; ++c) {
    offset += anchor_size(scene, c);
  }
  return offset;
}

bool has_anchor(const Scene& scene, const std::vector<int>& constraints) {
  return std::ranges::any_of(constraints, [&](int c) { return anchor_size(scene, c) > 0; });
}

bool is_angular(const Tree& tree, const Constraint& constraint) {
  return constraint.kind == ConstraintKind::kJoint
             ? tree.moved_by(constraint.joint).joint.turns()
             : constraint.kind == ConstraintKind::kOrientation;
}

std::string without_value(const Scene& scene, double time, const std::vector<double>& state,
                          const AtPoint& at_point) {
  const auto has_value = [&](const Expression& law, int point) {
    bool is_known = true;
    const double value = law.evaluate([&](const Variable& v) {
      switch (v.quantity) {
        case Quantity::kTime:
          return time;
        case Quantity::kPosition:
          return state[to_index(v.index)];
        case Quantity::kVelocity:
          return state[state.size() / 2 + to_index(v.index)];
        default:
          is_known = is_known && point >= 0 && at_point != nullptr;
          return is_known ? at_point(point, v) : 0.0;
      }
    });
    return !is_known || std::isfinite(value);
  };
  for (const JointLaw& law : scene.joint_laws) {
    if (!has_value(law.force, -1)) {
      return std::string(law.effect) + " of joint '" + scene.tree.moved_by(law.joint).joint.name +
             "'";
    }
  }
  for (const PointLaw& law : scene.point_laws) {
    if (!std::ranges::all_of(law.value, [&](const Expression& component) {
          return has_value(component, law.point);
        })) {
      return std::string(law.effect) + " of point '" + scene.points[to_index(law.point)].name + "'";
    }
  }
  return "";
}

std::vector<int> passive_joints(const Scene& scene) {
  std::vector<int> result;
  const std::vector<JointLaw> drives = laws_of(scene.joint_laws, "drive");
  for (int i = 0; i < scene.tree.dof(); ++i) {
    const bool driven = std::ranges::count(drives, i, &JointLaw::joint) > 0;
    const bool in_base = i < 6 && has_free_base(scene.tree);
    const bool chosen = scene.actuated && std::ranges::count(*scene.actuated, i) > 0;
    if (scene.actuated ? !chosen : drives.empty() ? in_base : !driven) {
      result.push_back(i);
    }
  }
  return result;
}

bool strikes_what_acts(const Event& event, const std::vector<int>& active) {
  return event.kind == EventKind::kHeight && event.impact && !event.impact->constraints.empty() &&
         std::ranges::includes(active, event.impact->constraints);
}

bool is_led(const Constraint& constraint) {
  return !constraint.accelerations.empty() ||
         !std::ranges::all_of(constraint.curve.velocity, &Expression::is_zero);
}

std::vector<int> struck(const Scene& scene, const Event& event) {
  std::vector<int> result;
  std::ranges::set_difference(event.impact->constraints, scene.phases[to_index(event.then)].active,
                              std::back_inserter(result));
  return result;
}

int floor_of(const Scene& scene, const Event& event, const std::vector<int>& rows) {
  const auto holds = [&](int c) {
    const Constraint& row = scene.constraints[to_index(c)];
    const Vector3& normal = event.plane.normal;
    return row.kind == ConstraintKind::kPoint && row.point == event.point &&
           std::ranges::any_of(row.directions, [&](const Vector3& d) {
             return Real(d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2]).plain() != 0;
           });
  };
  const auto found = std::ranges::find_if(rows, holds);
  return found == rows.end() ? -1 : *found;
}

bool stops_point(const Scene& scene, const Event& event, const std::vector<int>& before,
                 const std::vector<int>& behind) {
  std::vector<int> rows = event.impact ? struck(scene, event) : std::vector<int>();
  std::ranges::set_difference(behind, before, std::back_inserter(rows));
  return floor_of(scene, event, rows) >= 0;
}

}  // namespace treedyn::model
