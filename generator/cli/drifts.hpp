// How far a motion is off the constraints of its scene.
#pragma once

#include <vector>

#include "formulate/scene_phases.hpp"
#include "model/scene.hpp"
#include "simulation/system.hpp"

namespace treedyn {

/// Largest sizes of phi and of J qd less what is led, over the rows that act; below zero: none did.
struct OffRows {
  double length = -1;  ///< m
  double angle = -1;   ///< rad
  double speed = -1;   ///< m/s
  double rate = -1;    ///< rad/s
};

/// Follows a motion that a generated step computes. Rows that state their acceleration have no
/// place, and joints that dry friction holds do not count.
class Drifts {
 public:
  /// \param scene  as its step has it: settle_sticking \pre both outlive this
  Drifts(const model::Scene& scene, simulation::Dynamics& dynamics);

  /// The motion begins in a state of phase_states(scene, true).
  void begin(int state, double t, const simulation::Vector& q);
  /// Events have led to a state of phase_states(scene, true): rows begin to act or are pinned.
  void change(int state, double t, const simulation::Vector& q);
  void look(double t, const simulation::Vector& q, const simulation::Vector& qd);
  [[nodiscard]] const OffRows& largest() const { return largest_; }

 private:
  void act(int state, double t, const simulation::Vector& q);

  const model::Scene& scene_;
  simulation::System system_;
  std::vector<formulate::PhaseState> states_;
  int state_ = 0;
  OffRows largest_;
  simulation::Matrix J_;
  simulation::Vector phi_, led_;
};

}  // namespace treedyn
