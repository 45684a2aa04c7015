#include "model/effects.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/index.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::model {

namespace {

/// `indices` without those of the constraints that go, and with the new places of the others.
std::vector<int> renumbered(const std::vector<int>& indices, const std::vector<int>& place) {
  std::vector<int> result;
  for (const int c : indices) {
    if (place[to_index(c)] >= 0) {
      result.push_back(place[to_index(c)]);
    }
  }
  return result;
}

/// True if all constraints of an impact act before and behind it.
bool nothing_strikes(const Scene& scene, const Phase& phase, const Event& event) {
  return std::ranges::includes(phase.active, event.impact->constraints) &&
         struck(scene, event).empty();
}

void remove_constraints(Scene& scene, ConstraintKind kind) {
  std::vector<int> place;
  std::vector<Constraint> kept;
  for (Constraint& constraint : scene.constraints) {
    const bool stays = constraint.kind != kind;
    place.push_back(stays ? static_cast<int>(kept.size()) : -1);
    if (stays) {
      kept.push_back(std::move(constraint));
    }
  }
  scene.constraints = std::move(kept);
  for (Phase& phase : scene.phases) {
    phase.active = renumbered(phase.active, place);
    std::erase_if(phase.until, [&](const Event& event) {
      return event.kind == EventKind::kReaction && place[to_index(event.constraint)] < 0;
    });
    for (Event& event : phase.until) {
      event.constraint = event.constraint < 0 ? -1 : place[to_index(event.constraint)];
      event.pins = renumbered(event.pins, place);
      if (event.impact) {
        event.impact->constraints = renumbered(event.impact->constraints, place);
        event.impact->held = renumbered(event.impact->held, place);
      }
    }
  }
  for (Phase& phase : scene.phases) {
    for (Event& event : phase.until) {
      if (event.impact && nothing_strikes(scene, phase, event)) {
        event.impact.reset();
      }
    }
  }
}

/// Rows of one kind of constraint.
template <ConstraintKind kKind>
constexpr EffectRow rows(std::string_view name, std::string_view brief) {
  return {name, brief,
          [](const Scene& s) {
            return static_cast<std::size_t>(
                std::ranges::count(s.constraints, kKind, &Constraint::kind));
          },
          [](Scene& s) { remove_constraints(s, kKind); }, true};
}

/// The elements of a list.
template <auto kList>
constexpr EffectRow all_of(std::string_view name, std::string_view brief) {
  return {name, brief, [](const Scene& s) { return (s.*kList).size(); },
          [](Scene& s) {
            (s.*kList).clear();
          }};
}

std::size_t impacts_of(const Scene& scene) {
  const auto strikes = [](const Phase& phase) {
    return std::ranges::any_of(phase.until, [](const Event& e) { return e.impact.has_value(); });
  };
  return static_cast<std::size_t>(std::ranges::count_if(scene.phases, strikes));
}

void remove_impacts(Scene& scene) {
  for (Phase& phase : scene.phases) {
    for (Event& event : phase.until) {
      event.impact.reset();
    }
  }
}

std::size_t drawn(const Scene& scene) {
  return scene.stepping.drift == Drift::kBaumgarte && !scene.constraints.empty() ? 1 : 0;
}

constexpr std::array<EffectRow, 18> kEffects = {{
    {"gravity", "uniform field, G(q)",
     [](const Scene& s) -> std::size_t { return s.gravity != Vector3{} ? 1 : 0; },
     [](Scene& s) {
       s.gravity = {};
     }},
    {"velocity_products",
     "Coriolis and centrifugal terms: B(q, qd), and gamma of constraint rows; on unless off",
     [](const Scene& s) -> std::size_t { return s.velocity_products ? 1 : 0; },
     [](Scene& s) {
       s.velocity_products = false;
     }},
    {"viscous_friction", "joint: -d qd"},
    all_of<&Scene::frictions>("coulomb_friction",
                              "joint: exact sticking, or -f qd/sqrt(qd^2 + vs^2)"),
    {"stribeck_friction", "joint: from a static to a sliding force as speed grows"},
    all_of<&Scene::armatures>("armature", "joint: inertia of a rotor, added to the diagonal of A"),
    {"joint_spring", "joint: -k (q - rest) - d qd"},
    {"point_spring", "point: spring and damper to an anchor"},
    {"drive", "joint: a constant, an expression of t, q, qd, or a PD controller",
     [](const Scene& s) -> std::size_t { return s.tau.empty() ? 0 : 1; },
     [](Scene& s) {
       s.tau.clear();
     }},
    rows<ConstraintKind::kJoint>("locked_joint",
                                 "joint held at a position, or led by an expression of t"),
    {"force", "point: components are expressions of t, q, qd and the motion of the point"},
    {"moment", "link of a point: components as those of a force"},
    rows<ConstraintKind::kPoint>("point_constraint",
                                 "point held or led along a curve, direction by direction"),
    rows<ConstraintKind::kOrientation>("orientation_constraint",
                                       "link of a point keeps its orientation"),
    rows<ConstraintKind::kJoined>("joined_constraint",
                                  "two points of the robot coincide: closed loops"),
    all_of<&Scene::contacts>(
        "ground_contact",
        "point against a plane: spring-damper, Hunt-Crossley, friction, expression"),
    {"impact", "velocities jump when a phase ends", impacts_of, remove_impacts, true},
    {"stabilisation", "drift of constraints: none, baumgarte or projection", drawn,
     [](Scene& s) { s.stepping.drift = Drift::kNone; }, true},
}};

}  // namespace

std::span<const EffectRow> effects() { return kEffects; }

const EffectRow& effect_named(std::string_view name) {
  const auto* const row = std::ranges::find(kEffects, name, &EffectRow::name);
  if (row == kEffects.end()) {
    throw std::invalid_argument("no effect " + std::string(name));
  }
  return *row;
}

std::size_t entries_of(const Scene& scene, std::string_view effect) {
  const EffectRow& row = effect_named(effect);
  return static_cast<std::size_t>(std::ranges::count(scene.joint_laws, effect, &JointLaw::effect) +
                                  std::ranges::count(scene.point_laws, effect, &PointLaw::effect)) +
         (row.entries != nullptr ? row.entries(scene) : 0);
}

Scene without_effect(const Scene& scene, std::string_view effect) {
  const EffectRow& row = effect_named(effect);
  const auto is_its = [&](const auto& law) {
    return law.effect == effect;
  };
  Scene result = scene;
  std::erase_if(result.joint_laws, is_its);
  std::erase_if(result.point_laws, is_its);
  if (row.remove != nullptr) {
    row.remove(result);
  }
  return result;
}

}  // namespace treedyn::model
