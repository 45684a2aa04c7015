#include "pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "checked.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "description/scene_reader.hpp"
#include "emit/header.hpp"
#include "emit/layout.hpp"
#include "emit/names.hpp"
#include "emit/sha256.hpp"
#include "equations/table.hpp"
#include "in_scalar.hpp"
#include "limits.hpp"
#include "simplify/functions.hpp"
#include "simplify/scene_functions.hpp"
#include "simplify/scene_steps.hpp"
#include "simulation/integrator.hpp"
#include "symbolic/dump.hpp"
#include "system/files.hpp"
#include "verify/prove.hpp"
#include "verify/prove_scene.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

/// Base name and digest of what was read.
Source source_of(const std::string& path, const std::string& text) {
  return {std::filesystem::path(path).filename().string(), emit::sha256(text)};
}

/// A model file, read once.
struct Loaded {
  Source source;
  std::string text;
  model::Tree tree;
};

Loaded load(const Request& request) {
  const std::string text = description::read_model_text(request.model);
  return {source_of(request.model, text), text,
          description::parse_model(text, request.model, request.read)};
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
  for (const std::string& name : simplify::function_names()) {
    if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) {
      result.push_back(name);
    }
  }
  return result;
}

bool is_empty(const program::Signature& signature) {
  const auto empty = [](const program::Array& array) {
    return array.size == 0;
  };
  return std::any_of(signature.inputs.begin(), signature.inputs.end(), empty) ||
         std::any_of(signature.outputs.begin(), signature.outputs.end(), empty);
}

void check_functions(const Model& model, const Location& where) {
  for (const std::string& name : model.functions) {
    const auto points = static_cast<int>(model.points.size());
    if (points == 0 && is_empty(simplify::signature(name, model.tree.dof(), points))) {
      throw InputError(where, fmt::format("function '{}' needs points and the model has none; "
                                          "expected --points",
                                          name));
    }
    const std::vector<Warning> singular = description::joints_without_inertia(model.tree);
    if (needs_inertia(name) && !singular.empty()) {
      throw InputError(singular.front().where,
                       fmt::format("{}; function '{}' has no solution, expected inertia or "
                                   "--functions without it",
                                   singular.front().message, name));
    }
  }
}

}  // namespace

Request decided_request(const Model& model, Request request) {
  if (model.scene) {
    request.gravity = model.scene->gravity;
    request.read.base = description::base_of(model.tree);
  }
  return request;
}

simplify::Options simplify_options(const Model& model, const Request& request) {
  simplify::Options options;
  options.gravity = decided_request(model, request).gravity;
  options.points = model.points;
  options.effort = request.effort;
  options.forward_dynamics = request.forward_dynamics;
  options.without = request.without;
  options.share_limbs = request.share_limbs;
  return options;
}

std::vector<std::string> pass_names() {
  std::vector<std::string> names;
  for (const simplify::PassInfo& info : simplify::passes()) {
    names.emplace_back(info.name);
  }
  return names;
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
  if (all || std::any_of(wanted.begin(), wanted.end(), solves)) {
    description::require_inertia(*model.scene);
  }
}

/// Effects that cannot be written as code that branches on pivots and contacts alone.
void check_scene(const model::Scene& scene, const Location& where) {
  for (const model::JointFriction& friction : scene.frictions) {
    if (friction.slip_speed == 0) {
      throw InputError(
          where,
          fmt::format("coulomb friction of joint '{}' sticks, which generated functions do "
                      "not; expected a slip_speed",
                      scene.tree.links[static_cast<std::size_t>(friction.joint)].joint.name));
    }
  }
}

/// A step that was asked for needs an integrator whose steps are of a fixed length.
void check_step(const Model& model) {
  const std::vector<std::string>& wanted = model.scene_functions;
  const bool asked = std::find(wanted.begin(), wanted.end(), "step") != wanted.end();
  if (asked && !simplify::step_method(*model.scene)) {
    throw InputError(model.scene->stepping.where,
                     fmt::format("function 'step': integrator '{}' is not for generated code; "
                                 "expected {}",
                                 shown(model.scene->stepping.integrator),
                                 fmt::join(simplify::step_method_names(), ", ")));
  }
}

/// Generated impacts bring rows to rest, or let them rebound: they do not know of speeds of curves.
void check_impacts(const Model& model, const Location& where) {
  const std::vector<std::string>& wanted = model.scene_functions;
  const bool none =
      !wanted.empty() && std::none_of(wanted.begin(), wanted.end(), [](const auto& name) {
        return name == "impact" || name == "step";
      });
  for (const model::Phase& phase : model.scene->phases) {
    for (const model::Event& event : phase.until) {
      for (const int c : event.impact && !none ? event.impact->constraints : std::vector<int>{}) {
        const model::Constraint& row = model.scene->constraints[static_cast<std::size_t>(c)];
        const auto& speed = row.curve.velocity;
        if (!std::all_of(speed.begin(), speed.end(), [](const auto& v) { return v.is_zero(); })) {
          throw InputError(where,
                           fmt::format("phase '{}': an impact strikes constraint '{}', which "
                                       "is led along a curve; expected one at rest, or "
                                       "--functions without impact and step",
                                       shown(phase.name), shown(row.name)));
        }
      }
    }
  }
}

/// A MODEL beside a scene has to be the scene's own, in every byte.
void check_model(const Request& request, const model::Scene& scene, const std::string& text) {
  if (request.model.empty()) {
    return;
  }
  const bool same_base = request.read.base == description::Base::kFixed ||
                         description::base_of(scene.tree) == request.read.base;
  if (!same_base || scene.tree_file.empty() ||
      description::read_model_text(request.model) != text) {
    throw InputError({request.model, 0, 0},
                     fmt::format("is not the model of scene '{}'; expected that one, or none",
                                 shown(scene.name)));
  }
}

/// A scene brings its tree, gravity and points. Its digest is that of scene and model, one behind
/// the other.
Model read_scene_model(const Request& request) {
  Model model;
  const std::string text = description::read_text(*request.scene);
  std::string model_text;
  model.scene = description::parse_scene(text, *request.scene, [&](const std::string& path) {
    return model_text = description::read_model_text(path);
  });
  check_scene(*model.scene, {*request.scene, 0, 0});
  simulation::require_integrator(model.scene->stepping);
  check_model(request, *model.scene, model_text);
  model.source = source_of(*request.scene, text + model_text);
  model.tree = model.scene->tree;
  model.points = model.scene->points;
  const std::string& file = model.scene->tree_file;
  model.equations = chosen(read_user_equations(request, file, model_text, model.tree, model.points),
                           request.functions);
  for (const std::string& name : request.functions) {
    const bool of_user =
        std::any_of(model.equations.begin(), model.equations.end(),
                    [&](const auto& function) { return function->equation.name == name; });
    if (!of_user) {
      (simplify::is_scene_function(name) ? model.scene_functions : model.functions).push_back(name);
    }
  }
  require_size(model.tree, model.points, {*request.scene, 0, 0});
  check_functions(model, {*request.scene, 0, 0});
  check_inertia(model);
  check_step(model);
  check_impacts(model, {*request.scene, 0, 0});
  model.name = request.name.value_or(to_identifier(model.scene->name));
  model.name += is_reserved(model.name) ? "_" : "";
  return model;
}

}  // namespace

Model read(const Request& request) {
  if (request.scene) {
    return read_scene_model(request);
  }
  Model model;
  Loaded loaded = load(request);
  model.source = std::move(loaded.source);
  model.tree = std::move(loaded.tree);
  const Location where{request.model, 0, 0};
  if (model.tree.dof() == 0) {
    throw InputError(where, "the model has no moving joint; expected at least one");
  }
  model.points =
      request.points ? description::resolve_points(model.tree, *request.points) : model.tree.points;
  require_size(model.tree, model.points, where);
  model.equations =
      chosen(read_user_equations(request, request.model, loaded.text, model.tree, model.points),
             request.functions);
  model.functions = functions_of(request, model.tree, !model.points.empty());
  check_functions(model, where);
  model.name = request.name.value_or(model.tree.identifier);
  model.name += is_reserved(model.name) ? "_" : "";
  return model;
}

namespace {

void report(const Trace& trace, const std::string& name, const program::Cost& cost,
            std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  trace(fmt::format("{}: {} ({:.1f} s)", name, emit::cost_text(cost), time.count()));
}

}  // namespace

namespace {

Programs formulated(const Model& model, const Request& request, const Trace& trace) {
  Programs programs;
  const simplify::Options options = simplify_options(model, request);
  for (const std::string& name : model.functions) {
    const auto start = std::chrono::steady_clock::now();
    programs.functions.push_back(simplify::formulate(model.tree, name, options));
    report(trace, name, program::cost(programs.functions.back()), start);
  }
  for (const auto& equation : model.equations) {
    const auto start = std::chrono::steady_clock::now();
    program::Function function = simplify::formulate(model.tree, equation, options);
    function.signature =
        signature_of(*equation, model.tree.dof(), static_cast<int>(model.points.size()));
    report(trace, function.signature.name, program::cost(function), start);
    programs.functions.push_back(std::move(function));
  }
  if (model.scene && (request.functions.empty() || !model.scene_functions.empty())) {
    const auto start = std::chrono::steady_clock::now();
    simplify::SceneFunctions scene =
        simplify::scene_functions(*model.scene, options, model.scene_functions);
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

Programs formulate(const Model& model, const Request& request, const Trace& trace) {
  try {
    return formulated(model, request, trace);
  } catch (const std::range_error& error) {
    throw InputError({request.scene.value_or(request.model), 0, 0}, error.what());
  }
}

void prove(const Model& model, const Request& request, const Programs& programs) {
  std::vector<program::Function> of_model;
  std::copy_if(programs.functions.begin(), programs.functions.end(), std::back_inserter(of_model),
               [](const program::Function& function) {
                 return !simplify::is_scene_function(function.signature.name);
               });
  const model::Vector3 gravity = decided_request(model, request).gravity;
  prove_functions(model.tree, model.points, gravity, model.equations, of_model,
                  {request.scene.value_or(request.model), 0, 0});
  if (model.scene) {
    prove_scene(*model.scene, programs);
  }
}

namespace {

/// The places of A that the plain formulation does not find zero: the same whatever the search and
/// the passes make of it.
program::Packing packing_of(const Model& model, const Request& request) {
  simplify::Options options = simplify_options(model, request);
  options.without.clear();
  options.share_limbs = false;
  return program::lower_triangle(simplify::build(model.tree, simplify::recipe_of("mass_matrix"),
                                                 options, simplify::plain_variant(model.tree)),
                                 model.tree.dof());
}

}  // namespace

std::vector<emit::File> emit_files(const Model& model, const Request& request, Programs programs) {
  programs = in_scalar(std::move(programs), request.target.scalar);
  emit::Unit unit;
  unit.name = model.name;
  unit.tree = &model.tree;
  unit.points = model.points;
  unit.functions = std::move(programs.functions);
  unit.staged = std::move(programs.staged);
  unit.steppers = std::move(programs.steppers);
  unit.target = request.target;
  if (request.target.packed) {
    unit.packing = packing_of(model, request);
    for (program::Function& function : unit.functions) {
      function = program::packed(std::move(function), "A", model.tree.dof(), unit.packing);
    }
  }
  if (request.checked) {
    unit.checked = checked_siblings(model, unit.functions);
  }
  unit.command = generate_command(request, Paths::kBaseNames);
  unit.tool = fmt::format("treedyn {}", kVersion);
  unit.model_file = model.source.file;
  unit.model_sha256 = model.source.sha256;
  unit.options = manifest_options(decided_request(model, request));
  try {
    return emit::emit_files(unit);
  } catch (const std::range_error& error) {
    throw InputError({request.scene.value_or(request.model), 0, 0}, error.what());
  }
}

StepFiles step_files(const model::Scene& scene, emit::Scalar scalar, const std::string& file) {
  const Location where{file, 0, 0};
  Request request;
  request.scene = file;
  request.functions = {"step"};
  request.target.scalar = scalar;
  Model model;
  model.name = "generated";
  model.tree = scene.tree;
  model.points = scene.points;
  model.scene = scene;
  model.scene_functions = {"step"};
  check_scene(scene, where);
  check_step(model);
  check_impacts(model, where);
  Programs programs = in_scalar(formulate(model, request, [](const std::string&) {}), scalar);
  StepFiles result{model.name,
                   {},
                   programs.steppers.front().signature,
                   program::step_cost(programs.steppers.front())};
  result.files = emit_files(model, request, std::move(programs));
  return result;
}

namespace {

/// Functions without some pass, because it would have amplified rounding.
void warn_of_rounding(const Request& request, const Programs& programs, const Warn& warn) {
  const Location where{request.scene.value_or(request.model), 0, 0};
  const auto check = [&](const std::string& name, const program::Rounding& rounding) {
    if (rounding.refused > 0) {
      warn({where, fmt::format("function '{}' is generated without {}: rounding errors would grow "
                               "{:.2g} times by it",
                               name, fmt::join(rounding.left_out, ", "), rounding.refused)});
    }
  };
  for (const program::Function& function : programs.functions) {
    check(function.signature.name, function.rounding);
  }
  for (const program::Staged& staged : programs.staged) {
    check(staged.signature.name, staged.function.rounding);
  }
}

}  // namespace

std::vector<emit::File> generate(const Model& model, const Request& request, const Trace& trace,
                                 const Warn& warn) {
  Programs programs = formulate(model, request, trace);
  warn_of_rounding(request, programs, warn);
  prove(model, request, programs);
  return emit_files(model, request, std::move(programs));
}

std::vector<std::string> input_files(const Model& model, const Request& request) {
  std::vector<std::string> files;
  if (request.scene) {
    files.push_back(*request.scene);
  }
  if (model.scene && !model.scene->tree_file.empty()) {
    files.push_back(model.scene->tree_file);
  }
  if (!request.model.empty() && request.model != "-") {
    files.push_back(request.model);
  }
  files.insert(files.end(), request.equations.begin(), request.equations.end());
  return files;
}

std::vector<Warning> warnings_of(const Model& model, const Request& request) {
  std::vector<Warning> warnings = model.tree.warnings;
  if (request.share_limbs && simplify::find_limbs(model.tree).empty()) {
    const Location where{request.model, 0, 0};
    warnings.push_back(
        {where, "no two limbs have the same structure; --share-limbs changes nothing"});
  }
  if (request.checked && std::ranges::none_of(model.functions, needs_inertia)) {
    const Location where{request.scene.value_or(request.model), 0, 0};
    warnings.push_back(
        {where,
         "no function that is generated divides by the pivots of A; --checked changes "
         "nothing"});
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

std::string equations_text(const Model& model, const Request& request) {
  symbolic::DumpOptions options;
  for (const std::string& name : model.functions) {
    if (equations::find(name) != nullptr) {
      options.functions.push_back(name);
    }
  }
  return symbolic::dump(model.tree, model.points, decided_request(model, request).gravity, options);
}

}  // namespace treedyn
