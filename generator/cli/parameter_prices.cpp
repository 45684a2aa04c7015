#include "cli/parameter_prices.hpp"

#include <algorithm>

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

/// The programs of the model in which that is a number like others.
program::Programs without(Model model, const Request& request, const std::string& declared) {
  std::erase_if(model.tree.parameters,
                [&](const model::Parameter& parameter) { return parameter.declared == declared; });
  program::Programs programs = formulate_model(model, request, [](const std::string&) {});
  separate_parameters(model, request, programs);
  return in_scalar(std::move(programs), model, request.target.scalar);
}

}  // namespace

std::vector<ParameterPrice> parameter_prices(const Model& model, const Request& request,
                                             const program::Programs& programs) {
  std::vector<ParameterPrice> result;
  for (const std::string& declared : declarations(model.tree)) {
    const program::Programs others = without(model, request, declared);
    const std::size_t before = result.size();
    for (std::size_t k = 0; k < programs.functions.size(); ++k) {
      const program::Cost with = program::cost(programs.functions[k]);
      const program::Cost less = program::cost(others.functions[k]);
      if (with != less) {
        result.push_back({declared, programs.functions[k].signature.name, with, less});
      }
    }
    const program::Cost with = program::cost(*programs.update);
    const program::Cost less = others.update ? program::cost(*others.update) : program::Cost{};
    if (with != less) {
      result.push_back({declared, programs.update->signature.name, with, less});
    }
    if (result.size() == before) {
      result.push_back({declared, "", {}, {}});
    }
  }
  return result;
}

}  // namespace treedyn
