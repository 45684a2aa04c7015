#include "stages/formulation.hpp"

#include <chrono>
#include <stdexcept>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "formulate/functions.hpp"
#include "formulate/scene_functions.hpp"
#include "request/limits.hpp"

namespace treedyn {

formulate::Options formulate_options(const Model& model, const Request& request) {
  formulate::Options options;
  options.gravity = decided_request(model, request).gravity;
  options.points = model.points;
  options.effort = request.effort;
  options.forward_dynamics = request.forward_dynamics;
  options.without = request.without;
  options.share_limbs = request.share_limbs;
  options.metres = request.metres;
  return options;
}

std::vector<std::string> pass_names() {
  std::vector<std::string> names;
  for (const formulate::PassInfo& info : formulate::passes()) {
    names.emplace_back(info.name);
  }
  return names;
}

namespace {

void report(const Trace& trace, const std::string& name, const program::Cost& cost,
            std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  trace(fmt::format("{}: {} ({:.1f} s)", name, emit::cost_text(cost), time.count()));
}

program::Programs formulated(const Model& model, const Request& request, const Trace& trace) {
  program::Programs programs;
  const formulate::Options options = formulate_options(model, request);
  for (const std::string& name : model.functions) {
    const auto start = std::chrono::steady_clock::now();
    programs.functions.push_back(formulate::formulated(model.tree, name, options));
    report(trace, name, program::cost(programs.functions.back()), start);
  }
  for (const auto& equation : model.equations) {
    const auto start = std::chrono::steady_clock::now();
    program::Function function = formulate::formulated(model.tree, equation, options);
    function.signature =
        signature_of(*equation, model.tree.dof(), static_cast<int>(model.points.size()));
    report(trace, function.signature.name, program::cost(function), start);
    programs.functions.push_back(std::move(function));
  }
  if (model.scene && (request.functions.empty() || !model.scene_functions.empty())) {
    const auto start = std::chrono::steady_clock::now();
    formulate::SceneFunctions scene =
        formulate::scene_functions(*model.scene, options, model.scene_functions);
    for (program::Function& function : scene.plain) {
      report(trace, function.signature.name, program::cost(function), start);
      programs.functions.push_back(std::move(function));
    }
    for (program::Staged& staged : scene.staged) {
      report(trace, staged.signature.name, program::cost(staged), start);
      programs.staged.push_back(std::move(staged));
    }
    programs.steppers = std::move(scene.steppers);
  }
  return programs;
}

}  // namespace

program::Programs formulate_model(const Model& model, const Request& request, const Trace& trace) {
  try {
    return formulated(model, request, trace);
  } catch (const std::range_error& error) {
    refuse_decades(model.tree, error.what());
  }
}

}  // namespace treedyn
