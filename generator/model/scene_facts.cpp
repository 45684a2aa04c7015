#include "model/scene_facts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
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

/// True if its curve, or its orientation, is that of the moment when it begins to act.
bool begins_anywhere(const Scene& scene, int constraint) {
  const Constraint& c = scene.constraints[to_index(constraint)];
  const auto pins = [&](const Event& event) {
    return std::find(event.pins.begin(), event.pins.end(), constraint) != event.pins.end();
  };
  return c.pinned || c.kind == ConstraintKind::kOrientation ||
         std::any_of(scene.phases.begin(), scene.phases.end(), [&](const Phase& phase) {
           return std::any_of(phase.until.begin(), phase.until.end(), pins);
         });
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
  return std::any_of(constraints.begin(), constraints.end(),
                     [&](int c) { return anchor_size(scene, c) > 0; });
}

std::size_t entries_of(const Scene& scene, std::string_view effect) {
  const auto constraints = [&](ConstraintKind kind) {
    return std::ranges::count(scene.constraints, kind, &Constraint::kind);
  };
  const auto strikes = [](const Phase& phase) {
    return std::ranges::any_of(phase.until, [](const Event& e) { return e.impact.has_value(); });
  };
  const std::map<std::string_view, std::ptrdiff_t> others = {
      {"gravity", scene.gravity != Vector3{} ? 1 : 0},
      {"velocity_products", scene.velocity_products ? 1 : 0},
      {"coulomb_friction", std::ssize(scene.frictions)},
      {"armature", std::ssize(scene.armatures)},
      {"drive", scene.tau.empty() ? 0 : 1},
      {"locked_joint", constraints(ConstraintKind::kJoint)},
      {"point_constraint", constraints(ConstraintKind::kPoint)},
      {"orientation_constraint", constraints(ConstraintKind::kOrientation)},
      {"joined_constraint", constraints(ConstraintKind::kJoined)},
      {"ground_contact", std::ssize(scene.contacts)},
      {"impact", std::ranges::count_if(scene.phases, strikes)},
      {"stabilisation",
       scene.stepping.drift == Drift::kBaumgarte && !scene.constraints.empty() ? 1 : 0}};
  const auto other = others.find(effect);
  return static_cast<std::size_t>(std::ranges::count(scene.joint_laws, effect, &JointLaw::effect) +
                                  std::ranges::count(scene.point_laws, effect, &PointLaw::effect) +
                                  (other == others.end() ? 0 : other->second));
}

std::vector<int> passive_joints(const Scene& scene) {
  std::vector<int> result;
  const std::vector<JointLaw> drives = laws_of(scene.joint_laws, "drive");
  for (int i = 0; i < scene.tree.dof(); ++i) {
    const bool driven = std::ranges::count(drives, i, &JointLaw::joint) > 0;
    const bool in_base = i < 6 && has_free_base(scene.tree);
    const bool chosen = scene.actuated && std::find(scene.actuated->begin(), scene.actuated->end(),
                                                    i) != scene.actuated->end();
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

}  // namespace treedyn::model
