#include "cli/scene_prices.hpp"

#include <map>
#include <string>
#include <utility>

#include "formulate/scene_sticking.hpp"
#include "model/effects.hpp"
#include "stages/in_scalar.hpp"

namespace treedyn {

namespace {

using model::Scene;

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

std::vector<Price> effect_prices(const Model& model, const Request& request,
                                 const program::Programs& programs) {
  const std::map<std::string, program::Cost> with = costs_by_name(programs);
  Scene scene = *model.scene;
  formulate::forget_sticking(scene);
  std::vector<Price> result;
  for (const model::EffectRow& effect : model::effects()) {
    if (model::entries_of(scene, effect.name) == 0) {
      continue;
    }
    Model other = model;
    other.scene = model::without_effect(scene, effect.name);
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
