#include "request/step_checks.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/decimal.hpp"
#include "common/index.hpp"
#include "formulate/scene_sticking.hpp"
#include "model/scene_facts.hpp"

namespace treedyn {

namespace {

/// Of a scene without `stepping` the scene.
Location place_of(const model::Stepping& stepping, const Location& of_scene) {
  return stepping.where.file.empty() ? of_scene : stepping.where;
}

/// A generated step counts its steps in an int.
void check_counts(const model::Scene& scene, const Location& where) {
  if (!model::step_method(scene)) {
    return;
  }
  const Real most = Real(std::numeric_limits<int>::max() - 2) * scene.stepping.step;
  for (const model::Phase& phase : scene.phases) {
    for (const model::Event& event : phase.until) {
      if (event.not_before > most) {
        throw InputError(
            where,
            fmt::format("phase '{}': {:.6g} s are more steps of {:.6g} s than "
                        "an int counts; expected longer steps, or up to {:.6g} s",
                        shown(phase.name), static_cast<double>(event.not_before),
                        static_cast<double>(scene.stepping.step), static_cast<double>(most)));
      }
    }
  }
}

void check_impact(const model::Scene& scene, const model::Phase& phase, const model::Impact& impact,
                  const Location& where) {
  for (const int c : impact.constraints) {
    const model::Constraint& row = scene.constraints[to_index(c)];
    if (model::is_led(row) && row.accelerations.empty() &&
        !std::ranges::binary_search(impact.held, c)) {
      throw InputError(where, fmt::format("phase '{}': an impact strikes constraint '{}', which "
                                          "is led along a curve; expected one at rest, or "
                                          "--functions without impact and step",
                                          shown(phase.name), shown(row.name)));
    }
  }
}

}  // namespace

void check_scene(const model::Scene& scene, const Location& where) {
  if (scene.frictions.empty() || !scene.sticking.empty()) {
    return;
  }
  const std::string& joint = scene.tree.moved_by(scene.frictions.front().joint).joint.name;
  if (!model::step_method(scene)) {
    throw InputError(where,
                     fmt::format("coulomb friction of joint '{}' sticks, which takes a generated "
                                 "step; expected a slip_speed, or an integrator out of {}",
                                 shown(joint), fmt::join(model::step_method_names(), ", ")));
  }
  if (formulate::sticking_phases(scene) > formulate::kMostStickingPhases) {
    throw InputError(where, fmt::format("coulomb friction of joint '{}' and others sticks in more "
                                        "than {} phases of a generated step; expected a "
                                        "slip_speed",
                                        shown(joint), formulate::kMostStickingPhases));
  }
}

void check_step(const Model& model, const Location& of_scene) {
  const std::vector<std::string>& wanted = model.scene_functions;
  const bool asked = std::ranges::find(wanted, "step") != wanted.end();
  const Location where = place_of(model.scene->stepping, of_scene);
  if (asked && !model::step_method(*model.scene)) {
    throw InputError(where,
                     fmt::format("function 'step': integrator '{}' is not for generated code; "
                                 "expected {}",
                                 shown(model.scene->stepping.integrator),
                                 fmt::join(model::step_method_names(), ", ")));
  }
  const bool made = asked || (wanted.empty() && model.functions.empty());
  if (made && model.scene->stepping.compensated && model.scene->stepping.integrator == "sdirk2") {
    throw InputError(where,
                     "function 'step': sdirk2 keeps no compensated state; expected rk4, "
                     "dopri5-fixed or semi-implicit-euler");
  }
  if (made) {
    check_counts(*model.scene, where);
  }
}

void refuse_step_options(const StepChoice& choice, const model::Scene& scene,
                         const std::string& file) {
  const bool given = choice.step || choice.cuts || choice.compensated;
  const model::Stepping& stepping = scene.stepping;
  if (given && !model::step_method(scene)) {
    throw InputError(
        place_of(stepping, {file, 0, 0}),
        fmt::format("integrator '{}' is not for generated code, and --step, --cuts "
                    "and --state are of its step; expected --integrator with {}",
                    shown(stepping.integrator), fmt::join(model::step_method_names(), ", ")));
  }
}

void check_impacts(const Model& model, const Location& where) {
  const std::vector<std::string>& wanted = model.scene_functions;
  const bool none = !wanted.empty() && std::ranges::none_of(wanted, [](const auto& name) {
    return name == "impact" || name == "step";
  });
  for (const model::Phase& phase : model.scene->phases) {
    for (const model::Event& event : phase.until) {
      if (event.impact && !none) {
        check_impact(*model.scene, phase, *event.impact, where);
      }
    }
  }
}

void require_step(const Model& model, const Location& where) {
  check_scene(*model.scene, where);
  check_step(model, where);
  check_impacts(model, where);
}

}  // namespace treedyn
