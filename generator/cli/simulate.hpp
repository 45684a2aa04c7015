// `treedyn simulate`: a scene to a table, a JSON file and a page to look at.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "dynamics/generated_run.hpp"
#include "model/scene.hpp"
#include "simulation/recording.hpp"
#include "simulation/simulator.hpp"

namespace treedyn {

/// What to simulate: the options of the command line, checked. What is not given is the scene's.
struct SimulateRequest {
  std::string scene;   ///< path
  std::string output;  ///< folder; empty: the table goes to standard output
  bool json = false;
  bool report = false;
  bool engine = false;                ///< the generic engine evaluates the dynamics
  bool compiled = false;              ///< generated functions, compiled, do
  bool as_generated = false;          ///< the generated step, compiled, is the motion
  std::optional<std::string> scalar;  ///< of the generated step: double or float
  bool timed = false;                 ///< the run is timed
  std::optional<std::string> integrator;
  std::optional<Real> step;
  std::optional<Real> tolerance;
  std::optional<Real> duration;
  std::optional<model::Drift> drift;
  std::optional<Real> most_steps;    ///< instead of Settings::most_steps
  std::optional<Real> drift_limit;   ///< instead of Bounds::drift_end
  std::optional<Real> energy_limit;  ///< instead of Bounds::energy_end
};

/// What the motion of a generated step is of.
struct OfStep {
  std::string scalar;
  long operations = 0;  ///< GeneratedRun::operations
};

/// Files of one simulation.
struct SimulateResult {
  model::Scene scene;
  simulation::Recording recording;
  std::array<simulation::Move, 2> moved{};  ///< of the initial q and qd onto the constraints
  simulation::Stability stability;          ///< of the initial state
  std::optional<double> seconds;            ///< that the run took, if it was asked for
  std::optional<long> operations;           ///< of one evaluation of the terms, if they are counted
  std::optional<OfStep> generated;          ///< nothing: the motion is the simulator's
  std::vector<StatusRecord> statuses;       ///< of a generated step
  std::vector<Warning> warnings;            ///< of how it was made

  [[nodiscard]] const std::string& phase_name(int phase) const {
    return scene.phases[static_cast<std::size_t>(phase)].name;
  }
};

/// Reads and runs the scene. \throws InputError for mistakes in it
SimulateResult simulate(const SimulateRequest& request, const simulation::Progress& progress);

/// Why the motion of a scene to generate code for would not begin, if its initial state is not
/// zero. \param file  of the scene
std::optional<Warning> warning_of_start(const std::string& file, const model::Scene& scene);

/// That an initial state was moved onto the constraints, if it was by more than rounding.
std::optional<std::string> warning_of_move(const model::Scene& scene, const simulation::Move& move);
/// What went wrong, a line each: the initial state that was moved, and what a step noticed.
std::vector<std::string> warnings_of(const SimulateResult& result);
/// What `-v` says: the cost, how well promises were kept, and the stable steps of all integrators.
std::vector<std::string> facts_of(const SimulateResult& result);

/// t, phase and the columns of the recording; RFC 4180, numbers that read back exactly.
std::string csv_text(const SimulateResult& result);
/// The same with the events, what was asked for and why the motion ended.
std::string json_text(const SimulateResult& result);
/// One page that needs no network: plots and a moving figure.
std::string report_text(const SimulateResult& result);

/// Writes NAME.csv and what else is asked for, all files or none; without a folder the text for
/// standard output. \throws InputError
std::string write_simulation(const SimulateRequest& request, const SimulateResult& result);

/// `treedyn list effects` and `treedyn list integrators`.
std::string list_effects();
std::string list_integrators();

}  // namespace treedyn
