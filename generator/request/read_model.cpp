#include "request/read_model.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "description/scene_reader.hpp"
#include "emit/names.hpp"
#include "emit/sha256.hpp"
#include "equations/scene_table.hpp"
#include "equations/table.hpp"
#include "formulate/functions.hpp"
#include "formulate/scene_functions.hpp"
#include "formulate/scene_loops.hpp"
#include "formulate/scene_sticking.hpp"
#include "formulate/stand_ins.hpp"
#include "model/parameters.hpp"
#include "request/limits.hpp"
#include "request/step_checks.hpp"
#include "simulation/integrator.hpp"

namespace treedyn {

namespace {

/// Base name and digest of what was read.
Source source_of(const std::string& path, const std::string& text) {
  return {std::filesystem::path(path).filename().string(), emit::sha256(text)};
}

/// The functions asked for, in the order of INTERFACE.md 3. By default those that every robot has,
/// and forward dynamics where it has a solution.
std::vector<std::string> functions_of(const Request& request, const model::Tree& tree,
                                      bool has_points) {
  std::vector<std::string> wanted = request.functions;
  if (wanted.empty()) {
    wanted = {"mass_matrix", "bias_force", "gravity_force", "inverse_dynamics"};
    if (description::joints_without_inertia(tree).empty()) {
      wanted.emplace_back("forward_dynamics");
    }
    if (has_points) {
      wanted.insert(wanted.end(), {"point_positions", "force_jacobian_transpose"});
    }
  }
  std::vector<std::string> result;
  for (const std::string& name : formulate::function_names()) {
    if (std::ranges::find(wanted, name) != wanted.end()) {
      result.push_back(name);
    }
  }
  return result;
}

bool is_empty(const program::Signature& signature) {
  return std::ranges::any_of(signature.arrays(),
                             [](const program::Array& array) { return array.size == 0; });
}

void check_functions(const Model& model, const Location& where) {
  for (const std::string& name : model.functions) {
    const auto points = static_cast<int>(model.points.size());
    if (points == 0 && is_empty(formulate::signature(name, model.tree.dof(), points))) {
      throw InputError(where, fmt::format("function '{}' needs points and the {}", name,
                                          model.scene ? "scene lists none; expected `points` in it"
                                                      : "model has none; expected --points"));
    }
    if (name == "inverse_dynamics_regressor" && model.tree.mimics() > 0) {
      throw InputError(where, fmt::format("function '{}' needs a coordinate for every joint and {} "
                                          "joints follow others; expected --mimic independent",
                                          name, model.tree.mimics()));
    }
    require_solution(model.tree, name);
  }
}

}  // namespace

void require_solution(const model::Tree& tree, const std::string& function) {
  const std::vector<Warning> singular = description::joints_without_inertia(tree);
  if (equations::divides_by_pivots(function) && !singular.empty()) {
    throw InputError(singular.front().where,
                     fmt::format("{}; function '{}' has no solution, expected inertia or "
                                 "--functions without it",
                                 singular.front().message, function));
  }
}

Request decided_request(const Model& model, Request request) {
  if (model.scene) {
    request.gravity = model.scene->gravity;
    request.read.base = description::base_of(model.tree);
  }
  return request;
}

namespace {

/// Functions of a scene that solve for accelerations or velocities need an inertia matrix with an
/// inverse.
void check_inertia(const Model& model) {
  const std::vector<std::string>& wanted = model.scene_functions;
  const bool all = wanted.empty() && model.functions.empty();
  const auto solves = [](const std::string& name) {
    return name == "constrained_dynamics" || name == "impact" || name == "step";
  };
  if (all || std::ranges::any_of(wanted, solves)) {
    description::require_inertia(*model.scene);
  }
}

/// A MODEL beside a scene has to be the scene's own, in every byte; on the scene's base.
void check_model(const Request& request, const model::Scene& scene, const std::string& text) {
  if (request.model.empty()) {
    return;
  }
  if (request.read.base == description::Base::kAxes &&
      description::base_of(scene.tree) == description::Base::kFixed) {
    throw InputError(
        {*request.scene, 0, 0},
        fmt::format("scene '{}' has a fixed base, not --base axes; expected no --base, "
                    "or `base: axes` in the scene",
                    shown(scene.name)));
  }
  if (scene.tree_file.empty() || description::read_model_text(request.model) != text) {
    throw InputError({request.model, 0, 0},
                     fmt::format("is not the model of scene '{}'; expected that one, or none",
                                 shown(scene.name)));
  }
}

void choose(const StepChoice& choice, model::Stepping& stepping) {
  stepping.integrator = choice.integrator.value_or(stepping.integrator);
  stepping.step = choice.step.value_or(stepping.step);
  stepping.cuts = choice.cuts.value_or(stepping.cuts);
  stepping.compensated = choice.compensated.value_or(stepping.compensated);
}

/// \throws UsageError for what knows of numbers that are the same at run time only
void refuse_parameters(const Request& request, const std::string& file) {
  const std::array<std::pair<bool, const char*>, 5> others = {
      {{request.target.lanes > 1, "--lanes"},
       {request.share_limbs, sharing_option(request)},
       {request.self_test, "--self-test"},
       {request.checked, "--checked"},
       {request.accuracy_samples > 0, "--accuracy-samples"}}};
  for (const auto& [given, option] : others) {
    if (given) {
      throw UsageError(
          fmt::format("{0}: is for models without run-time parameters; expected neither --runtime "
                      "nor `runtime` in {1}, or no {0}",
                      option, shown(file)));
    }
  }
}

/// Spare rows of a loop are drawn to where the nominal lengths have them.
void refuse_lengths_of_loops(const model::Scene& scene, const std::string& file) {
  const auto is_at_run_time = [](const model::Point& point) {
    return std::ranges::any_of(point.at, [](const Real& x) { return x.recipe() != 0; });
  };
  const auto drawn = std::ranges::find_if(
      scene.constraints, [](const model::Constraint& c) { return c.loop && !c.loop->empty(); });
  if (drawn != scene.constraints.end() &&
      (model::has_lengths(scene.tree) || std::ranges::any_of(scene.points, is_at_run_time))) {
    throw InputError({file, 0, 0},
                     fmt::format("runtime: constraint '{}' closes a loop that steps draw to where "
                                 "it begins, which follows from lengths; expected none that are "
                                 "known at run time only, or stabilisation: {{method: none}}",
                                 shown(drawn->name)));
  }
}

/// A scene brings its tree, gravity and points. Its digest is that of scene and model, one behind
/// the other.
Model read_scene_model(const Request& request) {
  Model model;
  const std::string text = description::read_text(*request.scene);
  std::string model_text;
  const auto model_text_of = [&](const std::string& path) {
    return model_text = description::read_model_text(path);
  };
  // mistakes are those of its numbers, whatever is known at run time only
  model.scene = description::parse_scene(text, *request.scene, model_text_of);
  if (model.scene->declares_parameters) {
    refuse_parameters(request, *request.scene);
    model.scene =
        description::parse_scene(text, *request.scene, model_text_of, formulate::run_time_number);
  }
  choose(request.stepping, model.scene->stepping);
  check_scene(*model.scene, {*request.scene, 0, 0});
  simulation::require_integrator(model.scene->stepping);
  check_model(request, *model.scene, model_text);
  model.source = source_of(*request.scene, text + model_text);
  model.tree = model.scene->tree;
  model.points = model.scene->points;
  const std::string& file = model.scene->tree_file;
  model.equations = chosen(read_user_equations(request, file, model_text, model.tree, model.points),
                           request.functions, model.tree);
  for (const std::string& name : request.functions) {
    const bool of_user = std::ranges::any_of(
        model.equations, [&](const auto& function) { return function->equation.name == name; });
    if (!of_user) {
      (equations::is_scene_function(name) ? model.scene_functions : model.functions)
          .push_back(name);
    }
  }
  require_size(model.tree, model.points, {*request.scene, 0, 0});
  check_functions(model, {*request.scene, 0, 0});
  check_inertia(model);
  check_step(model, {*request.scene, 0, 0});
  refuse_step_options(request.stepping, *model.scene, *request.scene);
  check_impacts(model, {*request.scene, 0, 0});
  formulate::settle_loops(*model.scene);
  refuse_lengths_of_loops(*model.scene, *request.scene);
  formulate::settle_sticking(*model.scene);
  model.name = request.name.value_or(to_identifier(model.scene->name));
  model.name += is_reserved(model.name) ? "_" : "";
  return model;
}

/// A point that is generated stands for the model's point of that name, whose place is known at run
/// time only: its own place is the nominal one.
void take_places(const std::vector<model::Point>& generated, model::Tree& tree) {
  for (const model::Parameter& parameter : tree.parameters) {
    if (parameter.quantity != model::ParameterKind::kPoint) {
      continue;
    }
    model::Point& own = tree.points[static_cast<std::size_t>(parameter.link)];
    const auto found = std::ranges::find(generated, own.name, &model::Point::name);
    if (found != generated.end()) {
      own = *found;
    }
  }
}

}  // namespace

Model read(const Request& request) {
  if (request.scene && !request.read.runtime.empty()) {
    throw UsageError("--runtime is for models; expected none beside --scene");
  }
  if (request.scene) {
    return read_scene_model(request);
  }
  Model model;
  const std::string text = description::read_model_text(request.model);
  model.source = source_of(request.model, text);
  model.tree = description::parse_model(text, request.model, request.read);
  const Location where{request.model, 0, 0};
  if (!model.tree.parameters.empty()) {
    refuse_parameters(request, request.model);
  }
  if (model.tree.dof() == 0) {
    throw InputError(where, "the model has no moving joint; expected at least one");
  }
  model.points =
      request.points ? description::resolve_points(model.tree, *request.points) : model.tree.points;
  take_places(model.points, model.tree);
  require_size(model.tree, model.points, where);
  model.equations =
      chosen(read_user_equations(request, request.model, text, model.tree, model.points),
             request.functions, model.tree);
  model.functions = functions_of(request, model.tree, !model.points.empty());
  check_functions(model, where);
  model.name = request.name.value_or(model.tree.identifier);
  model.name += is_reserved(model.name) ? "_" : "";
  return model;
}

std::vector<std::string> input_files(const Model& model, const Request& request) {
  std::vector<std::string> files;
  if (request.scene) {
    files.push_back(*request.scene);
  }
  if (model.scene && !model.scene->tree_file.empty()) {
    files.push_back(model.scene->tree_file);
  }
  if (!request.model.empty()) {
    files.push_back(request.model);
  }
  files.insert(files.end(), request.equations.begin(), request.equations.end());
  files.insert(files.end(), request.settings.begin(), request.settings.end());
  std::erase(files, "-");
  return files;
}

}  // namespace treedyn
