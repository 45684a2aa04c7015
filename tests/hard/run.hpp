// A scene under way, with everything that the known quantities of hard_cases/SCHEMA.md ask for.
#pragma once

#include <memory>
#include <string>

#include "dynamics/scene_dynamics.hpp"
#include "model/scene.hpp"
#include "simulation/pose.hpp"
#include "simulation/simulator.hpp"

namespace treedyn::hard {

/// How every case is integrated: step by step to this error.
simulation::Settings settings();

/// Dynamics are made once for a scene and shared by its runs.
class Run {
 public:
  Run(const model::Scene& scene, simulation::Dynamics& dynamics,
      const simulation::Settings& how = settings());

  void advance_to(double time);
  /// Until the event, at most a hundredth of the duration beyond its end. \return nullptr: none
  const simulation::EventRecord* event(std::size_t number);

  [[nodiscard]] double start() const { return static_cast<double>(scene_.t0); }
  [[nodiscard]] double end() const { return start() + static_cast<double>(scene_.duration); }
  simulation::Simulator& simulator() { return simulator_; }
  const simulation::Pose& pose();

  double energy();
  /// max |E - E(t0)| / max(|E(t0)|, max T) so far.
  [[nodiscard]] double energy_drift() const;
  [[nodiscard]] double violation() const { return violation_; }
  [[nodiscard]] bool finite() const { return finite_; }

  /// Called after every step.
  std::function<void()> observer;

 private:
  void observe();

  const model::Scene& scene_;
  simulation::Simulator simulator_;
  simulation::Pose pose_;
  double first_energy_ = 0;
  double energy_change_ = 0;
  double most_kinetic_ = 0;
  double violation_ = 0;
  bool finite_ = true;
};

}  // namespace treedyn::hard
