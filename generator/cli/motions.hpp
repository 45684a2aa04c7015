// Motions of a scene to compare: of its generated step in any scalar type, and of `simulate`.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dynamics/generated_step.hpp"
#include "model/scene.hpp"
#include "simulation/pose.hpp"
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
  int status = 0;  ///< bits that `step` returned

  template <typename Numbers>
  void note(const Numbers& coordinates, const Numbers& speeds) {
    q.insert(q.end(), coordinates.begin(), coordinates.end());
    qd.insert(qd.end(), speeds.begin(), speeds.end());
  }
};

/// The largest difference; not finite if one of two motions ends early.
double distance(const GeneratedStep::Values& a, const GeneratedStep::Values& b);

/// A scene, where it begins, and the times of comparison.
struct Subject {
  model::Scene scene;
  std::string file;  ///< of the scene
  std::vector<Start> starts;
  Real interval = 0;  ///< s between comparisons
  int times = 0;

  [[nodiscard]] double duration() const { return static_cast<double>(interval) * times; }
};

/// The step of another integrator or length. \param parts  steps between two comparisons
struct Stepped {
  std::string integrator;
  long parts = 1;
  emit::Scalar scalar = emit::Scalar::kDouble;
  bool compensated = false;
};

/// The scene with such steps.
model::Scene stepped_scene(const Subject& subject, const Stepped& how);

/// The generated step from every start. \param files  of that scene
/// \throws InputError without a compiler
std::vector<Motion> stepped_motions(const Subject& subject, const Stepped& how,
                                    const StepFiles& files);

/// The interpreted equations by Fehlberg's method of order eight, events located to the resolution
/// of time, constraints projected. \throws std::runtime_error where a motion ends early
std::vector<Motion> simulated_motions(const Subject& subject, double tolerance);

/// What is stored in motion, gravity, springs and contacts. \pre the scene outlives it
class Energies {
 public:
  explicit Energies(const model::Scene& scene);

  /// At every time of the motion, J.
  GeneratedStep::Values of(const Motion& motion);

 private:
  std::unique_ptr<simulation::Dynamics> dynamics_;
  simulation::System system_;
  simulation::Pose pose_;
  std::size_t joints_;
};

}  // namespace treedyn
