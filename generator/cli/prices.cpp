#include "cli/prices.hpp"

#include <map>
#include <utility>

#include "emit/run_time.hpp"
#include "formulate/scene_sticking.hpp"
#include "formulate/stand_ins.hpp"
#include "model/effects.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

using Costs = std::map<std::string, program::Cost>;

/// Of all functions, in the order of the programs.
std::vector<std::pair<std::string, program::Cost>> costs(const program::Programs& programs) {
  std::vector<std::pair<std::string, program::Cost>> result;
  emit::each_cost(programs, {},
                  [&](const program::Signature& signature, const program::Cost& cost) {
                    result.emplace_back(signature.name, cost);
                  });
  return result;
}

Costs by_name(const program::Programs& programs) {
  const auto all = costs(programs);
  return {all.begin(), all.end()};
}

/// The rows of one effect or declaration.
template <class List>
void add_prices(const std::string& of, const List& with, const Costs& without,
                std::vector<Price>& result) {
  const std::size_t before = result.size();
  for (const auto& [function, cost] : with) {
    const auto found = without.find(function);
    const program::Cost rest = found == without.end() ? program::Cost{} : found->second;
    if (rest != cost) {
      result.push_back({of, function, cost, rest});
    }
  }
  if (result.size() == before) {
    result.push_back({of, "", {}, {}});
  }
}

/// The declarations, each once.
std::vector<std::string> declarations(const model::Tree& tree) {
  std::vector<std::string> result;
  for (const model::Parameter& parameter : tree.parameters) {
    if (result.empty() || result.back() != parameter.declared) {
      result.push_back(parameter.declared);
    }
  }
  return result;
}

/// The same model in which that is a number like others.
Model fixed(Model model, const std::string& declared) {
  std::vector<Real> values;
  int index = 0;
  for (const model::Parameter& parameter : model.tree.parameters) {
    const Real nominal = parameter.of_scene;  // those of the model stand in its tree
    values.push_back(parameter.declared == declared ? nominal
                                                    : formulate::run_time_number(index++, nominal));
  }
  std::erase_if(model.tree.parameters,
                [&](const model::Parameter& parameter) { return parameter.declared == declared; });
  if (model.scene) {
    model.scene = formulate::with_values(*model.scene, values);
    model.scene->tree = model.tree;
  }
  return model;
}

program::Programs without(const Model& given, const Request& request, const std::string& declared) {
  const Model model = fixed(given, declared);
  program::Programs programs = formulate_model(model, request, [](const std::string&) {});
  separate_parameters(model, request, programs);
  return in_scalar(std::move(programs), model, request.target.scalar);
}

program::Cost update_cost(const program::Programs& programs) {
  return programs.update ? program::cost(*programs.update) : program::Cost{};
}

}  // namespace

std::vector<Price> effect_prices(const Model& model, const Request& request,
                                 const program::Programs& programs) {
  const Costs with = by_name(programs);
  model::Scene scene = *model.scene;
  formulate::forget_sticking(scene);
  std::vector<Price> result;
  for (const model::EffectRow& effect : model::effects()) {
    if (model::entries_of(scene, effect.name) == 0) {
      continue;
    }
    Model other = model;
    other.scene = model::without_effect(scene, effect.name);
    formulate::settle_sticking(*other.scene);
    const program::Programs less = in_scalar(
        formulate_model(other, request, [](const std::string&) {}), other, request.target.scalar);
    add_prices(std::string(effect.name), with, by_name(less), result);
  }
  return result;
}

std::vector<Price> parameter_prices(const Model& model, const Request& request,
                                    const program::Programs& programs) {
  std::vector<Price> result;
  auto with = costs(programs);
  with.emplace_back(emit::kUpdate, update_cost(programs));
  for (const std::string& declared : declarations(model.tree)) {
    const program::Programs other = without(model, request, declared);
    Costs less = by_name(other);
    less[emit::kUpdate] = update_cost(other);
    add_prices(declared, with, less, result);
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
