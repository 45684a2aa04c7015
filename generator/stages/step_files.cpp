#include "stages/step_files.hpp"

#include <utility>

#include "formulate/scene_loops.hpp"
#include "formulate/scene_phases.hpp"
#include "formulate/scene_steps.hpp"
#include "formulate/scene_sticking.hpp"
#include "model/scene_facts.hpp"
#include "request/step_checks.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

/// The same dynamics and impacts, stepped as the scene says.
program::Stepper stepper_of(const Model& model, const Request& request,
                            const program::Programs& programs) {
  const std::vector<formulate::PhaseState> states = formulate::phase_states(*model.scene, true);
  const auto impacts = programs.staged.begin() + static_cast<std::ptrdiff_t>(states.size());
  formulate::Options options = formulate_options(model, request);
  return formulate::make_stepper(*model.scene, options, states, {programs.staged.begin(), impacts},
                                 {impacts, programs.staged.end()});
}

}  // namespace

StepFiles StepWriter::files(model::Scene scene, const StepForm& form, const std::string& effects) {
  const Location where{file_, 0, 0};
  Request request;
  request.scene = file_;
  request.functions = {"step"};
  request.target.scalar = form.scalar;
  request.forward_dynamics = form.forward_dynamics;
  request.target.sincos = form.scalar == emit::Scalar::kExtended  // the pair has no polynomials
                              ? emit::Sincos::kLibm
                              : form.sincos;
  Model model;
  model.name = "generated";
  model.tree = scene.tree;
  model.points = scene.points;
  model.scene = std::move(scene);
  model.scene_functions = {"step"};
  require_step(model, where);
  formulate::settle_loops(*model.scene);
  formulate::settle_sticking(*model.scene);
  const Key key{model::stabilisation_rate(*model.scene), model.scene->stepping.drift,
                form.forward_dynamics, effects};
  auto found = formulated_.find(key);
  if (found == formulated_.end()) {
    program::Programs made = formulate_model(model, request, [](const std::string&) {});
    check_at_states(model, request, made);
    found = formulated_.emplace(key, std::move(made)).first;
  }
  program::Programs programs = found->second;
  programs.steppers = {stepper_of(model, request, programs)};
  programs.steppers.front().tells = form.tells;
  for (program::Staged& staged : programs.staged) {
    staged.tells = form.tells;
  }
  StepFiles result{model.name,
                   {},
                   in_scalar(programs, model, form.scalar).steppers.front(),
                   float_warnings(programs, form.scalar, where)};
  result.files = emit_files(model, request, std::move(programs));
  return result;
}

}  // namespace treedyn
