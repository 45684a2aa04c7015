// A scene that moves, whatever computes it: the simulator, or generated code.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/scene.hpp"
#include "simulation/simulator.hpp"

namespace treedyn::hard {

using simulation::Vector;

/// Constraints that strike all at once.
struct Strike {
  Vector impulse;
  Vector qd;   ///< behind it
  Vector qdd;  ///< with all of them acting
  int rank = 0;
};

class Motion {
 public:
  virtual ~Motion() = default;
  /// Lands on `end`; calls `observe` after every step and event on the way.
  virtual void advance_to(double end, const std::function<void()>& observe) = 0;
  [[nodiscard]] virtual double time() const = 0;
  [[nodiscard]] virtual Vector q() const = 0;
  [[nodiscard]] virtual Vector qd() const = 0;
  [[nodiscard]] virtual const std::vector<simulation::EventRecord>& events() const = 0;
  /// Accelerations and reactions now.
  virtual const simulation::Solution& solution() = 0;
  /// Of the rows that act, or of the reactions that there are of them.
  virtual int rank() = 0;
  /// max |J qdd + gamma - a_des| of the active rows.
  virtual double residual() = 0;
  /// The impact of all constraints of the scene in the state of now.
  virtual Strike strike_all() = 0;
  /// Sign of the velocity of the first dry joint, 0 while it sticks.
  virtual int slip_direction() = 0;
  /// When that changed last. \pre it has changed in the last step
  [[nodiscard]] virtual double slip_time() const { return time(); }
  /// What measures the state, in double: rows, errors of position, heights, energies.
  virtual simulation::System& system() = 0;
};

/// What makes motions of scenes, and counts what they cost.
class Source {
 public:
  virtual ~Source() = default;
  /// \pre the scene outlives the motion
  virtual std::unique_ptr<Motion> motion(const model::Scene& scene) = 0;
  /// By a method with fixed steps instead.
  virtual std::unique_ptr<Motion> motion(const model::Scene& scene, const std::string& integrator,
                                         double step) = 0;
  /// The largest change of qdd at t0 when the one parameter of the rank decision is a tenth.
  virtual double sensitivity(const model::Scene& scene) = 0;
  /// Method, step, evaluations and operations so far, for the reader.
  [[nodiscard]] virtual std::string cost() const = 0;
};

/// The simulator in double, every step to an error of 1e-12.
std::unique_ptr<Source> simulator_source();

/// `step` and the functions that `treedyn generate` writes for the scene, compiled.
/// \param scalar  "double" or "float"
std::unique_ptr<Source> generated_source(const std::string& scalar);

}  // namespace treedyn::hard
