#include "cli/scene_prices.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "formulate/scene_sticking.hpp"
#include "model/effects.hpp"
#include "model/scene_facts.hpp"
#include "stages/in_scalar.hpp"

namespace treedyn {

namespace {

using model::Constraint;
using model::ConstraintKind;
using model::Scene;

/// `indices` with those of the constraints that go taken out and the others renumbered.
std::vector<int> renumbered(const std::vector<int>& indices, const std::vector<int>& place) {
  std::vector<int> result;
  for (const int c : indices) {
    if (place[static_cast<std::size_t>(c)] >= 0) {
      result.push_back(place[static_cast<std::size_t>(c)]);
    }
  }
  return result;
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
  for (model::Phase& phase : scene.phases) {
    phase.active = renumbered(phase.active, place);
    for (model::Event& event : phase.until) {
      event.pins = renumbered(event.pins, place);
      if (event.impact) {
        event.impact->constraints = renumbered(event.impact->constraints, place);
      }
    }
  }
}

void remove_impacts(Scene& scene) {
  for (model::Phase& phase : scene.phases) {
    for (model::Event& event : phase.until) {
      event.impact.reset();
    }
  }
}

template <auto kList>
void without_any(Scene& scene) {
  (scene.*kList).clear();
}

template <ConstraintKind kKind>
void without_kind(Scene& scene) {
  remove_constraints(scene, kKind);
}

/// Of what is no law of a joint or a point.
using Removal = std::function<void(Scene&)>;

const std::map<std::string_view, Removal>& removals() {
  static const std::map<std::string_view, Removal> table = {
      {"gravity",
       [](Scene& s) {
         s.gravity = {};
       }},
      {"velocity_products",
       [](Scene& s) {
         s.velocity_products = false;
       }},
      {"coulomb_friction", without_any<&Scene::frictions>},
      {"armature", without_any<&Scene::armatures>},
      {"drive", without_any<&Scene::tau>},
      {"locked_joint", without_kind<ConstraintKind::kJoint>},
      {"point_constraint", without_kind<ConstraintKind::kPoint>},
      {"orientation_constraint", without_kind<ConstraintKind::kOrientation>},
      {"joined_constraint", without_kind<ConstraintKind::kJoined>},
      {"ground_contact", without_any<&Scene::contacts>},
      {"impact", remove_impacts},
      {"stabilisation", [](Scene& s) {
         s.stepping.drift = model::Drift::kNone;
       }}};
  return table;
}

std::map<std::string, program::Cost> costs_by_name(const program::Programs& programs) {
  std::map<std::string, program::Cost> result;
  for (const program::Function& function : programs.functions) {
    result[function.signature.name] = program::cost(function);
  }
  for (const program::Staged& staged : programs.staged) {
    result[staged.signature.name] = program::cost(staged);
  }
  for (const program::Stepper& stepper : programs.steppers) {
    result[stepper.signature.name] = program::step_cost(stepper);
  }
  return result;
}

}  // namespace

bool names_effect(const Scene& scene, std::string_view effect) {
  return model::entries_of(scene, effect) > 0;
}

Scene without_effect(const Scene& scene, std::string_view effect) {
  Scene result = scene;
  const auto is_its = [&](const auto& law) {
    return law.effect == effect;
  };
  std::erase_if(result.joint_laws, is_its);
  std::erase_if(result.point_laws, is_its);
  const auto removal = removals().find(effect);
  if (removal != removals().end()) {
    removal->second(result);
  }
  return result;
}

std::vector<Price> effect_prices(const Model& model, const Request& request,
                                 const program::Programs& programs) {
  const std::map<std::string, program::Cost> with = costs_by_name(programs);
  Scene scene = *model.scene;
  formulate::forget_sticking(scene);
  std::vector<Price> result;
  for (const model::EffectRow& effect : model::kEffects) {
    if (!names_effect(scene, effect.name)) {
      continue;
    }
    Model other = model;
    other.scene = without_effect(scene, effect.name);
    formulate::settle_sticking(*other.scene);
    std::map<std::string, program::Cost> without = costs_by_name(in_scalar(
        formulate_model(other, request, [](const std::string&) {}), other, request.target.scalar));
    const std::size_t before = result.size();
    for (const auto& [function, cost] : with) {
      if (!(without[function] == cost)) {
        result.push_back({std::string(effect.name), function, cost, without[function]});
      }
    }
    if (result.size() == before) {
      result.push_back({std::string(effect.name), "", {}, {}});
    }
  }
  return result;
}

std::vector<ContactPrice> contact_prices(const program::Programs& programs) {
  for (const program::Staged& staged : programs.staged) {
    std::vector<ContactPrice> result;
    for (const program::Staged& contact : staged.contacts) {
      result.push_back({contact.signature.name, program::cost(contact)});
    }
    if (!result.empty()) {
      return result;
    }
  }
  return {};
}

}  // namespace treedyn
