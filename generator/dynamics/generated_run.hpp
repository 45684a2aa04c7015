// A scene in time by its generated `step`, as firmware runs it.
#pragma once

#include <vector>

#include "dynamics/generated_step.hpp"
#include "model/scene.hpp"
#include "simulation/recording.hpp"

namespace treedyn {

/// A bit of the status that steps returned.
struct StatusRecord {
  int bit = 0;
  long count = 0;    ///< of steps that returned it
  double first = 0;  ///< when the first of them began, s
};

struct GeneratedRun {
  simulation::Recording recording;  ///< events: those of the step, at its end
  std::vector<StatusRecord> statuses;
  long operations = 0;  ///< of all steps, without impacts and choices among events
};

/// Rounded to double.
simulation::Vector vector_of(const GeneratedStep::Values& values);

/// The arguments of the first step of the scene from a state: joint forces, phase, anchors.
void begin_motion(const model::Scene& scene, const simulation::Vector& q,
                  const simulation::Vector& qd, GeneratedStep& step);

/// Steps from t0 on, at t0 + k h, until the scene's duration is over. Reactions are those that the
/// step gives; energies and drift are computed of its states in double.
/// \param step  tells its events \param simulator  in the initial state
/// \param output_step  s between rows, in whole steps
GeneratedRun run_generated(const model::Scene& scene, GeneratedStep& step,
                           simulation::Simulator& simulator, double output_step,
                           const simulation::Progress& progress);

/// "at t = 0.4 s and 2 more times: no_convergence", a line each.
std::vector<std::string> status_lines(const std::vector<StatusRecord>& statuses);

}  // namespace treedyn
