#include "pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "checked.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "description/scene_reader.hpp"
#include "emit/header.hpp"
#include "emit/layout.hpp"
#include "emit/names.hpp"
#include "emit/run_time.hpp"
#include "emit/sha256.hpp"
#include "equations/table.hpp"
#include "function_accuracy.hpp"
#include "in_scalar.hpp"
#include "limits.hpp"
#include "program/rounding.hpp"
#include "program/run_time.hpp"
#include "simplify/functions.hpp"
#include "simplify/scene_functions.hpp"
#include "simplify/scene_loops.hpp"
#include "simplify/scene_steps.hpp"
#include "simplify/scene_sticking.hpp"
#include "simplify/stand_ins.hpp"
#include "simulation/integrator.hpp"
#include "symbolic/dump.hpp"
#include "system/files.hpp"
#include "verify/prove.hpp"
#include "verify/prove_scene.hpp"
#include "version.hpp"

namespace treedyn {

simplify::Options simplify_options(const Model& model, const Request& request) {
  simplify::Options options;
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
  for (const simplify::PassInfo& info : simplify::passes()) {
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
    refuse_decades(model.tree, error.what());
  }
}

namespace {

/// Functions that no mass enters. The others take what is known at run time, whether a model needs
/// it or not: a signature is no matter of numbers.
bool is_weighed(const program::Signature& signature) {
  static const std::set<std::string> kKinematic = {
      "point_positions",           "point_velocities",          "point_rotations",
      "force_jacobian_transpose",  "moment_jacobian_transpose", "point_bias_acceleration",
      "angular_bias_acceleration", "joint_to_link_vectors",     "applied_force"};
  return !kKinematic.contains(signature.name);
}

/// A user's function or argument that is called what run-time parameters need.
void refuse_names(const program::Signature& signature, const Location& where) {
  const std::set<std::string> taken = {emit::kUpdate, emit::kParameters, emit::kDerivedParameters,
                                       emit::kNominal, emit::derived_array().name};
  const auto refuse = [&](const std::string& name) {
    if (taken.contains(name)) {
      throw InputError(where, fmt::format("function '{}': the name {} is one of run-time "
                                          "parameters; expected another one",
                                          signature.name, name));
    }
  };
  refuse(signature.name);
  for (const auto* const arrays : {&signature.inputs, &signature.outputs}) {
    for (const program::Array& array : *arrays) {
      refuse(array.name);
    }
  }
}

}  // namespace

void separate_parameters(const Model& model, const Request& request, Programs& programs) {
  if (model.tree.parameters.empty()) {
    return;
  }
  const program::Array derived = emit::derived_array();
  for (const program::Function& function : programs.functions) {
    refuse_names(function.signature, {request.model, 0, 0});
  }
  program::Function update = program::separate_parameters(
      programs.functions, emit::parameters_array(model.tree), derived, is_weighed);
  update.signature.name = emit::kUpdate;
  update.signature.brief =
      "What the functions need of the run-time parameters: to be called before them and when a "
      "parameter has changed.";
  programs.update = std::move(update);
}

void prove(const Model& model, const Request& request, const Programs& programs) {
  std::vector<program::Function> of_model;
  std::copy_if(programs.functions.begin(), programs.functions.end(), std::back_inserter(of_model),
               [](const program::Function& function) {
                 return !simplify::is_scene_function(function.signature.name);
               });
  const model::Vector3 gravity = decided_request(model, request).gravity;
  try {
    prove_functions(model.tree, model.points, gravity, model.equations, of_model,
                    programs.update ? &*programs.update : nullptr);
  } catch (const std::range_error& error) {
    refuse_decades(model.tree, error.what());
  }
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
  const simplify::Seen seen = simplify::with_stand_ins(model.tree, options);
  return program::lower_triangle(simplify::build(seen.tree, simplify::recipe_of("mass_matrix"),
                                                 seen.options, simplify::plain_variant(seen.tree)),
                                 model.tree.dof());
}

}  // namespace

namespace {

/// The length of a step as a number of full precision in the scalar.
void require_length(const Real& step, const Request& request) {
  const bool single = request.target.scalar == emit::Scalar::kFloat;
  const double least =
      single ? double{std::numeric_limits<float>::min()} : std::numeric_limits<double>::min();
  if (step < least) {
    throw InputError(
        {request.scene.value_or(request.model), 0, 0},
        fmt::format("a step of {} s has no digits in {}; expected {} s or more",
                    emit::decimal(step), emit::type_name(request.target.scalar), least));
  }
}

}  // namespace

std::vector<emit::File> emit_files(const Model& model, const Request& request, Programs programs) {
  programs = in_scalar(std::move(programs), model, request.target.scalar);
  emit::Unit unit;
  unit.name = model.name;
  unit.language = request.language;
  unit.given_space = request.space.value_or("");
  unit.given_prefix = request.prefix.value_or("");
  unit.section = request.section;
  unit.tree = &model.tree;
  unit.gravity = decided_request(model, request).gravity;
  unit.points = model.points;
  unit.functions = std::move(programs.functions);
  if (programs.update) {
    unit.functions.insert(unit.functions.begin(), std::move(*programs.update));
  }
  unit.staged = std::move(programs.staged);
  unit.steppers = std::move(programs.steppers);
  unit.target = request.target;
  for (const program::Stepper& stepper : unit.steppers) {
    require_length(stepper.step, request);
  }
  unit.self_test = request.self_test;
  if (unit.self_test && unit.functions.empty()) {
    throw InputError({request.scene.value_or(request.model), 0, 0},
                     "--self-test tests functions of the model; expected some among --functions");
  }
  if (request.accuracy_samples > 0) {
    unit.errors = measured_errors(model, request, unit.functions);
  }
  if (request.target.packed) {
    unit.packing = packing_of(model, request);
    for (program::Function& function : unit.functions) {
      function = program::packed(std::move(function), "A", model.tree.dof(), unit.packing);
    }
  }
  if (request.checked) {
    unit.checked = checked_siblings(model, unit.functions);
  }
  for (const program::Function& function : unit.functions) {
    const std::string& name = function.signature.name;
    if (unit.self_test &&
        (name == "self_test" || name == "compare" || name.starts_with("known_"))) {
      throw InputError({request.scene.value_or(request.model), 0, 0},
                       fmt::format("function '{}' has a name that --self-test needs; expected "
                                   "another one",
                                   name));
    }
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
  const Location where{request.scene.value_or(request.model), 0, 0};
  for (const Warning& warning : float_warnings(programs, request.target.scalar, where)) {
    warn(warning);
  }
  separate_parameters(model, request, programs);
  prove(model, request, programs);
  return emit_files(model, request, std::move(programs));
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
