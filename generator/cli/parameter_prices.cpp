#include "cli/parameter_prices.hpp"

#include <algorithm>
#include <utility>

#include "emit/run_time.hpp"
#include "formulate/stand_ins.hpp"
#include "stages/in_scalar.hpp"

namespace treedyn {

namespace {

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

/// Of all functions, the one that takes the parameters last.
std::vector<std::pair<std::string, program::Cost>> costs(const program::Programs& programs) {
  std::vector<std::pair<std::string, program::Cost>> result;
  for (const program::Function& function : programs.functions) {
    result.emplace_back(function.signature.name, program::cost(function));
  }
  for (const program::Staged& staged : programs.staged) {
    result.emplace_back(staged.signature.name, program::cost(staged));
  }
  for (const program::Stepper& stepper : programs.steppers) {
    result.emplace_back(stepper.signature.name, program::step_cost(stepper));
  }
  result.emplace_back(emit::kUpdate,
                      programs.update ? program::cost(*programs.update) : program::Cost{});
  return result;
}

}  // namespace

std::vector<ParameterPrice> parameter_prices(const Model& model, const Request& request,
                                             const program::Programs& programs) {
  std::vector<ParameterPrice> result;
  const auto with = costs(programs);
  for (const std::string& declared : declarations(model.tree)) {
    const auto less = costs(without(model, request, declared));
    const std::size_t before = result.size();
    for (std::size_t k = 0; k < with.size(); ++k) {
      if (with[k].second != less[k].second) {
        result.push_back({declared, with[k].first, with[k].second, less[k].second});
      }
    }
    if (result.size() == before) {
      result.push_back({declared, "", {}, {}});
    }
  }
  return result;
}

}  // namespace treedyn
