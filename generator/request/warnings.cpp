// Remarks on a model that do not stop the program.
#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/decimal.hpp"
#include "common/index.hpp"
#include "description/scene_reader.hpp"
#include "description/vectors.hpp"
#include "equations/table.hpp"
#include "formulate/find_limbs.hpp"
#include "model/scene_facts.hpp"
#include "request/read_model.hpp"

namespace treedyn {

namespace {

/// Points with places that are known at run time, of which no function is generated.
std::vector<Warning> places_without_effect(const Model& model, const Location& where) {
  std::vector<Warning> result;
  std::set<int> known;
  for (const model::Parameter& parameter : model.tree.parameters) {
    if (parameter.quantity != model::ParameterKind::kPoint ||
        !known.insert(parameter.link).second) {
      continue;
    }
    const std::string& name = model.tree.points[static_cast<std::size_t>(parameter.link)].name;
    if (std::ranges::find(model.points, name, &model::Point::name) == model.points.end()) {
      result.push_back({where, fmt::format("{} leaves point '{}' out; what is known of it at run "
                                           "time changes nothing",
                                           model.scene ? "the scene" : "--points", shown(name))});
    }
  }
  return result;
}

/// Why what an impact stops in a phase that goes on does not stay there, which a generated step
/// does not see; nothing if it may.
std::string impact_without_rest(const model::Scene& scene, const model::Event& event) {
  const model::Impact& impact = *event.impact;
  const auto sticks = [&](int c) {
    return scene.constraints[to_index(c)].sticks;
  };
  if (event.kind == model::EventKind::kExpression && impact.restitution > 0 &&
      impact.restitution < 1) {
    return "rebounds at an expression never come to rest: once they are too small to be seen "
           "`step` lets it go on beyond zero (at a touch_down they may)";
  }
  if (event.kind == model::EventKind::kHeight && impact.restitution == 0 &&
      impact.rest_below == 0 && description::dot(scene.gravity, event.plane.normal) < 0 &&
      model::floor_of(scene, event, model::struck(scene, event)) >= 0 &&
      std::ranges::none_of(scene.phases[to_index(event.then)].active, sticks)) {
    return fmt::format(
        "no constraint holds point '{}' where its impact stops it: unless a force does, gravity "
        "makes it sink in `step`, which the status event_missed says (`then` a phase in which the "
        "constraint acts, or rest_below)",
        shown(scene.points[to_index(event.point)].name));
  }
  return "";
}

/// True if an equation of EQUATIONS.md stands in e by its name.
bool uses(const block::Expression& e, std::string_view name) {
  return (e.kind() == block::Kind::kNamed && e.node().name == name) ||
         std::ranges::any_of(e.operands(), [&](const auto& x) { return uses(x, name); });
}

/// Functions of the tree beside those of a scene know nothing of its effects.
std::vector<Warning> effects_left_out(const Model& model, const Location& where) {
  const auto has = [&](const std::string& name, std::initializer_list<std::string_view> parts) {
    return std::ranges::any_of(parts,
                               [&](std::string_view part) { return name.starts_with(part); });
  };
  std::vector<std::string> inertia;
  std::vector<std::string> velocities;
  for (const auto& function : model.equations) {
    if (uses(function->equation.expression, "A")) {
      inertia.push_back(function->equation.name);
    }
    if (uses(function->equation.expression, "B")) {
      velocities.push_back(function->equation.name);
    }
  }
  for (const std::string& name : model.functions) {
    const bool both = has(name, {"inverse_dynamics", "forward_dynamics", "dynamics_terms"});
    if (both || has(name, {"mass_matrix", "kinetic_energy"})) {
      inertia.push_back(name);
    }
    if (both || name == "bias_force") {
      velocities.push_back(name);
    }
  }
  std::vector<Warning> result;
  const auto add = [&](bool acts, const std::vector<std::string>& names, const char* what) {
    if (acts && !names.empty()) {
      result.push_back({where, fmt::format("functions of the tree alone, {}: {}", what,
                                           fmt::join(names, ", "))});
    }
  };
  add(!model.scene->armatures.empty(), inertia, "without the scene's armature");
  add(!model.scene->velocity_products, velocities,
      "with the velocity products that the scene leaves out");
  return result;
}

}  // namespace

std::vector<Warning> impacts_without_rest(const model::Scene& scene, const Location& where) {
  std::vector<Warning> result;
  for (std::size_t k = 0; model::step_method(scene) && k < scene.phases.size(); ++k) {
    for (const model::Event& event : scene.phases[k].until) {
      const bool goes_on = event.impact && event.then == static_cast<int>(k);
      if (const std::string why = goes_on ? impact_without_rest(scene, event) : ""; !why.empty()) {
        result.push_back({where, fmt::format("phase '{}': {}", shown(scene.phases[k].name), why)});
      }
    }
  }
  return result;
}

std::vector<Warning> warnings_of(const Model& model, const Request& request) {
  std::vector<Warning> warnings = model.tree.warnings;
  const auto add = [&](const std::vector<Warning>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  };
  const Location where{request.scene.value_or(request.model), 0, 0};
  add(places_without_effect(model, where));
  if (request.share_limbs && formulate::find_limbs(model.tree).empty()) {
    warnings.push_back({{request.model, 0, 0},
                        fmt::format("no two limbs have the same structure; {} changes nothing",
                                    sharing_option(request))});
  }
  if (request.checked && std::ranges::none_of(model.functions, equations::divides_by_pivots)) {
    warnings.push_back(
        {where,
         "no function that is generated divides by the pivots of A; --checked changes "
         "nothing"});
  }
  if (model.scene) {
    add(impacts_without_rest(*model.scene, where));
    add(effects_left_out(model, where));
    const bool has_errors = std::ranges::any_of(
        model.functions, [](const std::string& name) { return equations::find(name) != nullptr; });
    if (request.accuracy_samples > 0 && !has_errors && model.equations.empty()) {
      warnings.push_back(
          {where, "functions of a scene have no errors; --accuracy-samples changes nothing"});
    }
  }
  for (Warning singular : model.scene ? description::joints_without_inertia(*model.scene)
                                      : description::joints_without_inertia(model.tree)) {
    if (!model.scene && request.functions.empty()) {
      singular.message += " and is left out";
    }
    warnings.push_back(std::move(singular));
  }
  return warnings;
}

}  // namespace treedyn
