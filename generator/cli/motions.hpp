// Motions of a scene to compare: of its generated step in any scalar type, and of `simulate`.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "accuracy/study.hpp"
#include "cli/drifts.hpp"
#include "dynamics/generated_step.hpp"
#include "model/scene.hpp"
#include "simulation/pose.hpp"
#include "simulation/simulator.hpp"
#include "simulation/system.hpp"
#include "stages/step_files.hpp"

namespace treedyn {

/// Where a motion begins.
struct Start {
  simulation::Vector q;
  simulation::Vector qd;
};

/// A state at every time of comparison, one behind the other; ends where it is not finite.
struct Motion {
  GeneratedStep::Values q;
  GeneratedStep::Values qd;
  int status = 0;                              ///< bits that `step` returned
  std::vector<SteppedEvent> events;            ///< in s from the beginning of the motion
  OffRows off;                                 ///< at up to ten times between two comparisons
  std::vector<program::StepCount> steps = {};  ///< by the number of the phase

  template <typename Numbers>
  void note(const Numbers& coordinates, const Numbers& speeds) {
    q.insert(q.end(), coordinates.begin(), coordinates.end());
    qd.insert(qd.end(), speeds.begin(), speeds.end());
  }
};

/// The largest difference; not finite if one of two motions ends early.
double distance(const GeneratedStep::Values& a, const GeneratedStep::Values& b);

/// The largest difference of times at which the same events happen, each for the same time; one
/// that only one of the motions has is off by what is left until `end`.
double event_distance(const Motion& a, const Motion& b, double end);

/// A scene, where it begins, and the times of comparison.
struct Subject {
  model::Scene scene;
  std::string file;  ///< of the scene
  std::vector<Start> starts;
  std::array<simulation::Move, 2> moved{};         ///< of the scene's own initial q and qd
  std::shared_ptr<simulation::Dynamics> dynamics;  ///< of the scene
  Real interval = 0;                               ///< s between comparisons
  int times = 0;

  [[nodiscard]] double duration() const { return static_cast<double>(interval * times); }
};

/// The step of another integrator or length. \param parts  steps between two comparisons
struct Stepped {
  std::string integrator;
  long parts = 1;
  emit::Scalar scalar = emit::Scalar::kDouble;
  bool compensated = false;
  accuracy::Variant variant = {};
};

/// The scene with such steps.
model::Scene stepped_scene(const Subject& subject, const Stepped& how);
/// Their code, which tells events.
StepFiles stepped_files(const Subject& subject, const Stepped& how, StepWriter& writer,
                        bool tells = true);

/// The generated step from every start. \param files  of that scene
/// \throws InputError without a compiler
std::vector<Motion> stepped_motions(const Subject& subject, const Stepped& how,
                                    const StepFiles& files);

/// Wall time of one step where the motion begins, s. \param files  of that scene
double step_seconds(const Subject& subject, const Stepped& how, const StepFiles& files);

/// The interpreted equations by Fehlberg's method of order eight, events located to the resolution
/// of time, constraints projected.
/// \param[in,out] warning  the first one of these motions, unless it says something already
/// \throws std::runtime_error where a motion ends early
std::vector<Motion> simulated_motions(const Subject& subject, double tolerance,
                                      std::string& warning);

/// Points at every time of a motion: x, y, z, one behind the other, base frame, m.
GeneratedStep::Values places(const model::Scene& scene, const std::vector<model::Point>& points,
                             const Motion& motion);

/// The largest distance of points, m; not finite if one of two motions ends early.
double place_distance(const GeneratedStep::Values& a, const GeneratedStep::Values& b);

/// What is stored in motion, gravity, springs and contacts. \pre the subject outlives it
class Energies {
 public:
  explicit Energies(const Subject& subject);

  /// At every time of the motion, J.
  GeneratedStep::Values of(const Motion& motion);

 private:
  simulation::System system_;
  simulation::Pose pose_;
  std::size_t joints_;
};

}  // namespace treedyn
