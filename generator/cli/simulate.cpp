#include "cli/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "description/scene_reader.hpp"
#include "dynamics/scene_dynamics.hpp"
#include "formulate/scene_loops.hpp"
#include "formulate/scene_sticking.hpp"
#include "model/effects.hpp"
#include "model/scene_facts.hpp"
#include "request/limits.hpp"
#include "request/read_model.hpp"
#include "simulation/integrator.hpp"
#include "stages/step_files.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace {

/// Rows of a table if nothing else is asked for.
constexpr int kRows = 500;
/// Of constraints in a motion in float a warning, Bounds::drift_warning.
constexpr double kDriftInFloat = 1e-4;
/// And Bounds::no_speed.
constexpr double kSpeedInFloat = 1e-5;
/// Rows that a run may have.
constexpr double kMostRows = 1e6;
/// Rounding of a number of steps, as a part of it.
constexpr double kWhole = 1e-9;

/// The options of the command line go before what the scene says.
void apply(const SimulateRequest& request, model::Scene& scene) {
  scene.stepping.integrator = request.integrator.value_or(scene.stepping.integrator);
  scene.stepping.tolerance = request.tolerance.value_or(scene.stepping.tolerance);
  scene.stepping.step = request.step.value_or(scene.stepping.step);
  scene.stepping.drift = request.drift.value_or(scene.stepping.drift);
  scene.duration = request.duration.value_or(scene.duration);
}

simulation::Settings settings_of(const SimulateRequest& request, const model::Stepping& stepping) {
  simulation::Settings result;
  result.integrator = stepping.integrator;
  result.step = static_cast<double>(stepping.step);
  result.longest = request.step ? result.step : 0;
  result.tolerance = static_cast<double>(stepping.tolerance);
  result.drift = stepping.drift;
  result.stabilisation = static_cast<double>(stepping.stabilisation);
  if (request.scalar.value_or("") == "float") {
    result.bounds.drift_warning = kDriftInFloat;
    result.bounds.no_speed = kSpeedInFloat;
  }
  if (request.most_steps) {
    result.most_steps = static_cast<double>(*request.most_steps);
  }
  if (request.drift_limit) {
    result.bounds.drift_end = static_cast<double>(*request.drift_limit);
  }
  if (request.energy_limit) {
    result.bounds.energy_end = static_cast<double>(*request.energy_limit);
  }
  return result;
}

/// A time so far from zero has no room for the motion between two numbers.
void check_time(const SimulateRequest& request, const model::Scene& scene, bool is_fixed) {
  const auto start = static_cast<double>(scene.t0);
  const double least = simulation::least_step(start);
  const auto refuse = [&](const char* what, double length) {
    throw InputError({request.scene, 0, 0},
                     fmt::format("a {} of {:.3g} s does not advance time at t = {:.6g} s; expected "
                                 "more than {:.2g} s, or a beginning nearer to zero",
                                 what, length, start, least));
  };
  if (const auto duration = static_cast<double>(scene.duration); !(duration > least)) {
    refuse("duration", duration);
  }
  if (const auto step = static_cast<double>(scene.stepping.step); is_fixed && !(step > least)) {
    refuse("step", step);
  }
}

void check_rows(const SimulateRequest& request, const model::Scene& scene) {
  const Real& step = scene.stepping.output_step;
  if (step > 0 && scene.duration > Real(kMostRows) * step) {
    const auto duration = static_cast<double>(scene.duration);
    throw InputError(
        {request.scene, 0, 0},
        fmt::format("{:.3g} s are more than {:.3g} rows of {:.3g} s; expected an "
                    "output_step of {:.3g} s or more, or a shorter duration",
                    duration, kMostRows, static_cast<double>(step), duration / kMostRows));
  }
}

void check(const SimulateRequest& request, const model::Scene& scene) {
  simulation::require_integrator(scene.stepping);
  require_size(scene.tree, scene.points, {request.scene, 0, 0});
  description::require_inertia(scene);
  if (scene.duration <= 0) {
    throw InputError({request.scene, 0, 0},
                     "the scene has no duration; expected one above zero, or --duration");
  }
  const std::vector<std::string> fixed = model::step_method_names();
  const Real most = request.most_steps.value_or(Real(simulation::Settings{}.most_steps));
  const bool is_fixed = std::ranges::find(fixed, scene.stepping.integrator) != fixed.end();
  if (is_fixed && request.tolerance) {
    throw InputError(
        {"--tolerance", 0, 0},
        fmt::format("{} takes steps of one length; expected an adaptive integrator, or "
                    "--step",
                    scene.stepping.integrator));
  }
  if (is_fixed && scene.duration > most * scene.stepping.step) {
    throw InputError({request.scene, 0, 0},
                     fmt::format("{:.3g} s are more than {:.3g} steps of {:.3g} s; expected longer "
                                 "steps, or --max-steps",
                                 static_cast<double>(scene.duration), static_cast<double>(most),
                                 static_cast<double>(scene.stepping.step)));
  }
  check_time(request, scene, is_fixed);
  check_rows(request, scene);
}

double output_step(const model::Scene& scene) {
  const auto step = static_cast<double>(scene.stepping.output_step);
  return step > 0 ? step : static_cast<double>(scene.duration) / kRows;
}

std::unique_ptr<simulation::Dynamics> dynamics_of(const SimulateRequest& request,
                                                  const model::Scene& scene) {
  if (request.engine) {
    return engine_dynamics(scene);
  }
  return request.compiled ? compiled_dynamics(scene) : program_dynamics(scene);
}

/// Nothing unless the generated step is the motion. \post the scene's phases and loops are those of
/// the step
std::unique_ptr<GeneratedStep> generated_step(const SimulateRequest& request,
                                              SimulateResult& result) {
  if (!request.as_generated) {
    return nullptr;
  }
  StepForm form;
  form.tells = true;
  result.generated = {request.scalar.value_or("double"), 0};
  form.scalar = result.generated->scalar == "float" ? emit::Scalar::kFloat : emit::Scalar::kDouble;
  const StepFiles files = StepWriter(request.scene).files(result.scene, form);
  result.warnings = files.warnings;
  for (const Warning& rest : impacts_without_rest(result.scene, {request.scene, 0, 0})) {
    result.warnings.push_back(rest);
  }
  formulate::settle_loops(result.scene);
  formulate::settle_sticking(result.scene);
  const auto step = static_cast<double>(result.scene.stepping.step);
  const double count = static_cast<double>(result.scene.duration) / step;
  if (std::fabs(count - std::round(count)) > kWhole * count) {
    result.warnings.push_back(
        {{request.scene, 0, 0},
         fmt::format("the motion ends at t = {:.6g} s: no whole number of steps of {} s makes the "
                     "duration",
                     static_cast<double>(result.scene.t0) + std::round(count) * step, step)});
  }
  return std::make_unique<GeneratedStep>(files.name, files.files, files.stepper);
}

/// \param step  whose motion it is; null: the simulator's
void run(GeneratedStep* step, simulation::Simulator& simulator,
         const simulation::Progress& progress, SimulateResult& result) {
  const double row = output_step(result.scene);
  if (step == nullptr) {
    result.recording = simulation::record(result.scene, simulator, row, progress);
    return;
  }
  GeneratedRun run = run_generated(result.scene, *step, simulator, row, progress);
  result.recording = std::move(run.recording);
  result.statuses = std::move(run.statuses);
  result.generated->operations = run.operations;
}

/// Names with a line about each.
template <class List>
std::string list_of(const List& rows) {
  std::string result;
  for (const auto& row : rows) {
    result += fmt::format("{:<24}{}\n", row.name, row.brief);
  }
  return result;
}

}  // namespace

SimulateResult simulate(const SimulateRequest& request, const simulation::Progress& progress) {
  SimulateResult result{description::read_scene(request.scene), {}, {}, {}, {}, {}, {}, {}, {}};
  apply(request, result.scene);
  check(request, result.scene);
  if (!request.output.empty()) {
    check_folder(request.output);  // before hours of computing
  }
  const std::unique_ptr<GeneratedStep> step = generated_step(request, result);
  const std::unique_ptr<simulation::Dynamics> dynamics = dynamics_of(request, result.scene);
  result.operations = dynamics->operations();
  try {
    simulation::Simulator simulator(result.scene, *dynamics,
                                    settings_of(request, result.scene.stepping));
    result.moved = simulator.settle();
    result.stability = simulator.stability(*dynamics);
    const auto start = std::chrono::steady_clock::now();
    run(step.get(), simulator, progress, result);
    if (request.timed) {
      result.seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    if (result.recording.stopped.empty()) {
      simulator.judge_rest(*dynamics);
      result.recording.notices = simulator.monitor().notices();
    }
  } catch (const std::runtime_error& problem) {
    throw InputError({request.scene, 0, 0}, fmt::format("{}; expected a motion", problem.what()));
  }
  return result;
}

std::optional<Warning> warning_of_start(const std::string& file, const model::Scene& scene) {
  const auto is_zero = [](const Real& x) {
    return x == 0;
  };
  if (scene.constraints.empty() ||
      (std::ranges::all_of(scene.q0, is_zero) && std::ranges::all_of(scene.qd0, is_zero))) {
    return std::nullopt;
  }
  try {
    const std::unique_ptr<simulation::Dynamics> dynamics = engine_dynamics(scene);
    simulation::Simulator(scene, *dynamics, {}).settle();
  } catch (const std::runtime_error& problem) {
    return Warning{{file, 0, 0}, fmt::format("{}; simulate refuses it", problem.what())};
  }
  return std::nullopt;
}

std::string write_simulation(const SimulateRequest& request, const SimulateResult& result) {
  if (request.output.empty()) {
    return request.json ? json_text(result) : csv_text(result);
  }
  const std::string stem =
      (std::filesystem::path(request.output) / to_identifier(result.scene.name)).string();
  std::vector<OutputFile> files = {{stem + ".csv", csv_text(result)}};
  if (request.json) {
    files.push_back({stem + ".json", json_text(result)});
  }
  if (request.report) {
    files.push_back({stem + ".html", report_text(result)});
  }
  write_files(files);
  return "";
}

std::string list_effects() { return list_of(model::effects()); }

std::string list_integrators() { return list_of(simulation::integrators()); }

}  // namespace treedyn
