#include "stages/function_accuracy.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "equations/scene_table.hpp"

namespace treedyn {

namespace {

using accuracy::FunctionRow;
using accuracy::Inputs;
using formulate::ForwardDynamics;

/// One way to make a function.
struct Option {
  std::string name;
  Request request;
};

std::vector<Option> options_of(const Request& request, const std::string& function) {
  std::vector<Option> result = {{"as asked for", request}};
  const auto add = [&](const std::string& name) -> Request& {
    result.push_back({name, request});
    return result.back().request;
  };
  std::vector<formulate::Pass> all;
  for (const formulate::PassInfo& info : formulate::passes()) {
    const auto& without = request.without;
    if (std::ranges::find(without, info.pass) == without.end()) {
      add(fmt::format("without {}", info.name)).without.push_back(info.pass);
    }
    all.push_back(info.pass);
  }
  add("without all passes").without = all;
  const bool libm = request.target.takes_libm();
  add(libm ? "sincos pair" : "sincos libm").target.sincos =
      libm ? emit::Sincos::kPair : emit::Sincos::kLibm;
  if (function == "forward_dynamics") {
    add("factor").forward_dynamics = ForwardDynamics::kFactor;
    add("articulated").forward_dynamics = ForwardDynamics::kArticulated;
  }
  return result;
}

/// The functions of a model by name: how to make them and what they should return.
class Functions {
 public:
  Functions(const Model& model, const Request& request)
      : model_(model),
        states_(model.tree),
        reference_(model.tree, model.points, decided_request(model, request).gravity) {}

  [[nodiscard]] const accuracy::States& states() const { return states_; }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> result = model_.functions;
    for (const auto& equation : model_.equations) {
      result.push_back(equation->equation.name);
    }
    return result;
  }

  [[nodiscard]] program::Function formulated(const std::string& name,
                                             const Request& request) const {
    const formulate::Options options = formulate_options(model_, request);
    const auto of_user = find(name);
    if (of_user == nullptr) {
      return formulate::formulated(model_.tree, name, options);
    }
    program::Function function = formulate::formulated(model_.tree, of_user, options);
    function.signature =
        signature_of(*of_user, model_.tree.dof(), static_cast<int>(model_.points.size()));
    return function;
  }

  accuracy::Truth truth(const program::Signature& signature, int states) {
    const auto of_user = find(signature.name);
    return accuracy::truth_of(signature, states_, states, [&](const Inputs& inputs) {
      return of_user == nullptr ? reference_(signature.name, inputs)
                                : reference_(of_user->equation, inputs);
    });
  }

 private:
  [[nodiscard]] std::shared_ptr<const formulate::Derived> find(const std::string& name) const {
    const auto found = std::ranges::find_if(
        model_.equations, [&](const auto& function) { return function->equation.name == name; });
    return found == model_.equations.end() ? nullptr : *found;
  }

  const Model& model_;
  accuracy::States states_;
  engine::Reference reference_;
};

/// Names and values of the arguments.
std::vector<std::pair<std::string, std::string>> values_of(const program::Signature& signature,
                                                           const Inputs& inputs) {
  std::vector<std::pair<std::string, std::string>> result;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const std::vector<float> values(inputs[k].begin(), inputs[k].end());
    result.emplace_back(signature.inputs[k].name, fmt::format("[{}]", fmt::join(values, ", ")));
  }
  return result;
}

accuracy::Measured measured_and_bounded(const program::Function& function,
                                        const accuracy::Arithmetic& how,
                                        const accuracy::Truth& truth) {
  accuracy::Measured result = measured(function, how, truth);
  result.bound = bounded(function, how, truth, result);
  return result;
}

void name_states(const FunctionRow& row, const program::Signature& signature,
                 const accuracy::Truth& truth, accuracy::FunctionStudy& study) {
  std::set<int> states;
  for (const accuracy::Measured* measured : {&row.in_float, &row.in_double}) {
    for (const accuracy::Worst* worst : {&measured->errors.scaled, &measured->errors.ulps}) {
      if (!worst->output.empty()) {
        states.insert(worst->state);
      }
    }
  }
  for (const int state : states) {
    study.named.push_back(
        {row.function, state, values_of(signature, truth.inputs[static_cast<std::size_t>(state)])});
  }
}

}  // namespace

accuracy::FunctionStudy function_accuracy(const Model& model, const Request& request, int states,
                                          const Trace& trace) {
  Functions functions(model, request);
  if (functions.names().empty()) {
    throw UsageError(
        "--accuracy: functions of a scene have no table of errors; expected --functions of its "
        "model, or treedyn accuracy SCENE");
  }
  accuracy::FunctionStudy study{model.tree.name, states, functions.states().missing(), {}, {}};
  for (const std::string& name : functions.names()) {
    accuracy::Truth truth;
    for (const Option& option : options_of(request, name)) {
      const program::Function function = functions.formulated(name, option.request);
      const bool first = truth.inputs.empty();
      if (first) {
        truth = functions.truth(function.signature, states);
      }
      const emit::Sincos sincos = option.request.target.sincos;
      study.rows.push_back(
          {name, option.name, measured_and_bounded(function, {emit::Scalar::kFloat, sincos}, truth),
           measured_and_bounded(function, {emit::Scalar::kDouble, sincos}, truth)});
      if (first) {
        name_states(study.rows.back(), function.signature, truth, study);
      }
      trace(fmt::format("{}: {}", name, option.name));
    }
  }
  return study;
}

std::map<std::string, std::string> measured_errors(
    const Model& model, const Request& request, const std::vector<program::Function>& functions) {
  Functions of_model(model, request);
  std::map<std::string, std::string> result;
  for (const program::Function& function : functions) {
    if (!equations::is_scene_function(function.signature.name)) {
      const accuracy::Truth truth = of_model.truth(function.signature, request.accuracy_samples);
      const accuracy::Measured of =
          measured_and_bounded(function, {request.target.scalar, request.target.sincos}, truth);
      result.emplace(function.signature.name, accuracy::errors_json(of));
    }
  }
  return result;
}

}  // namespace treedyn
