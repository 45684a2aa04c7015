// A scene under way, with everything that the known quantities of hard_cases/SCHEMA.md ask for.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "hard/motion.hpp"
#include "model/scene.hpp"
#include "simulation/pose.hpp"

namespace treedyn::hard {

class Run {
 public:
  Run(const model::Scene& scene, Source& source);
  Run(const model::Scene& scene, std::unique_ptr<Motion> motion);

  void advance_to(double time);
  /// Until the event, at most a hundredth of the duration beyond its end. \return nullptr: none
  const simulation::EventRecord* event(std::size_t number);

  [[nodiscard]] double start() const { return static_cast<double>(scene_.t0); }
  [[nodiscard]] double end() const { return start() + static_cast<double>(scene_.duration); }
  Motion& motion() { return *motion_; }
  simulation::System& system() { return motion_->system(); }
  [[nodiscard]] double time() const { return motion_->time(); }
  [[nodiscard]] Vector q() const { return motion_->q(); }
  [[nodiscard]] Vector qd() const { return motion_->qd(); }
  const simulation::Solution& solution() { return motion_->solution(); }
  [[nodiscard]] const std::vector<simulation::EventRecord>& events() const {
    return motion_->events();
  }
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
  std::unique_ptr<Motion> motion_;
  simulation::Pose pose_;
  double first_energy_ = 0;
  double energy_change_ = 0;
  double most_kinetic_ = 0;
  double violation_ = 0;
  bool finite_ = true;
};

}  // namespace treedyn::hard
