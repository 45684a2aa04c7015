// What a motion promises, looked at in every step: warnings, and the end where a promise is broken.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "simulation/pose.hpp"
#include "simulation/system.hpp"

namespace treedyn::simulation {

/// Beyond the first bound of each pair there is a warning, beyond the second the motion ends.
struct Bounds {
  /// Position errors of acting rows: rad, and for lengths parts of the robot's size.
  double drift_warning = 1e-6;
  double drift_end = 1e-2;
  /// Acceleration that a row lacks, as a part of the terms of its equation; and the velocity that
  /// it has lost by that, rad/s or sizes of the robot a second.
  double residual_warning = 1e-6;
  double residual_end = 1e-1;
  /// Speeds that roundings leave of an impact or of a stop, 1/s or sizes of the robot a second.
  double no_speed = 1e-11;
  /// Speeds that a projection may take beside a hundredth of those that the row adds up, likewise.
  double pull = 1e-5;
  /// Energy beyond that of the beginning and the work of all forces, as a part of the energy that
  /// the motion has exchanged, of the fall of the robot by its size or of the power of a hundred
  /// such steps, whatever is more. It ends where some of that energy is still there; and where ten
  /// steps in a row have more of it than the motion began with and was given, and it grows.
  double energy_warning = 1e-2;
  double energy_end = 1;
  /// Turn of the velocity, rad, by rows near a singular position while errors of position and
  /// velocity turn their own tangent by more than `beside`, rad: the branch is not told by them.
  double turn_warning = 1e-3;
  double turn_end = 0.1;
  double beside = 0.05;
};

/// A warning: what was noticed first, and the worst of it.
struct Notice {
  std::string
      kind;  ///< drift, residual, energy, guard, position, speed, pull, impact, branch, step, below
  std::string name;  ///< the row, the event, the integrator, the point, whether energy is gained
  double time = 0;   ///< s, when it was first beyond its bound
  double value = 0;  ///< then
  double bound = 0;
  std::string unit;  ///< of the values
  std::string text;  ///< one sentence on the first time
  double worst = value;
  double worst_time = time;
};

/// One line: the text, and the worst if it is another.
std::string to_string(const Notice& notice);

/// What rows do to the velocity in one stage of a step: Solution::turn, beside, turning.
struct Turn {
  double rate;
  double beside;
  int row;
};

/// Of all forces without potential in a step.
struct Work {
  double done = 0;   ///< J
  double power = 0;  ///< W, the largest
};

/// Kinetic energy with that of armatures, potential energy with that of springs and contacts, J.
double energy(System& system, Pose& pose, const Vector& q, const Vector& qd);

class Monitor {
 public:
  Monitor(const model::Scene& scene, const Bounds& bounds);

  /// A joint begins to move. Where nothing has moved before, the motion begins here: its first
  /// steps are not judged by the energy that they have exchanged.
  void break_away() { energy_steps_ = exchanged_ > rounding_ ? energy_steps_ : 0; }
  /// The row equations in the state that `System::accelerate` has just seen.
  /// \throws std::runtime_error beyond the second bound, as all others
  void row_equations(const System& system, double t, double h);
  /// A row that moves elsewhere and has J = 0 here; when rows begin to act.
  void positions(System& system, double t, const Vector& q);
  /// Rows that begin to act at a speed that no impact has taken, beyond roundings of the speeds
  /// before; those of constraints that have acted only where they have gained it.
  /// \param acted  constraints, ascending
  void speeds(System& system, double t, const Vector& q, const Vector& qd, const Vector& qd_before,
              const std::vector<int>& acted);
  /// Speeds along the rows that the projection at the end of a step has taken, \p qd behind it.
  void pull(const System& system, double t, const Vector& qd);
  /// A stage that counts for the time h in the step that ends at t.
  void turn(const Constraints& constraints, const Turn& turn, double t, double h);
  /// Position errors of the rows after a step.
  void drift(System& system, double t, const Vector& q);
  /// Energy after a step of length h: what is lost to no force is a warning, what is gained ends.
  void energy(System& system, double t, double h, const Vector& q, const Vector& qd,
              const Work& work);
  /// Energy behind an event: what it takes is its own matter.
  void restart_energy(System& system, const Vector& q, const Vector& qd);
  /// A guard without value. \param may_end  whether the event could happen now
  void guard(const std::string& event, double t, bool may_end);
  void note(Notice notice);

  [[nodiscard]] const std::vector<Notice>& notices() const { return notices_; }
  /// Largest energy that no force explains, as a part of what has been exchanged until now, or of a
  /// fall by the size of the robot.
  [[nodiscard]] double energy_error() const {
    return most_unexplained_ > 0 ? most_unexplained_ / std::max(exchanged_, weight_) : 0;
  }
  [[nodiscard]] double unexplained() const { return unexplained_; }  ///< J, now
  [[nodiscard]] double largest_residual() const { return largest_residual_; }
  [[nodiscard]] double largest_drift() const { return largest_drift_; }
  /// Of lengths, m.
  [[nodiscard]] double drift_warning() const { return bounds_.drift_warning * size_; }

 private:
  struct Row {
    std::size_t name;
    double scale;  ///< the size of the robot for lengths, 1 for angles
    bool is_angular;
  };
  [[nodiscard]] Row row(const Constraints& constraints, int k) const;
  void measure(System& system, const Vector& q);
  [[nodiscard]] bool explodes(double given);

  const model::Scene& scene_;
  Bounds bounds_;
  Pose pose_;
  double size_ = 1;
  double weight_ = 0;    ///< J, of a fall by the size, or `rounding_`
  double rounding_ = 0;  ///< J, of a motion at ordinary speeds
  std::vector<std::string> names_;
  std::vector<std::size_t> first_;  ///< of a constraint, in names_
  std::vector<double> lost_;        ///< velocity of each row
  double turned_ = 0;               ///< rad, by errors
  std::vector<Notice> notices_;
  bool has_energy_ = false;
  double energy_ = 0;     ///< J, after the last step
  double potential_ = 0;  ///< J, at the beginning
  double exchanged_ = 0;  ///< J
  double worked_ = 0;     ///< J, by all forces, either way
  int energy_steps_ = 0;
  double given_ = 0;             ///< J, of the beginning, and by forces that drove
  double gained_ = 0;            ///< J, in steps
  int excessive_steps_ = 0;      ///< in a row, with more energy gained than given
  double excess_from_ = 0;       ///< J, before them
  double unexplained_ = 0;       ///< J
  double most_unexplained_ = 0;  ///< J
  double largest_residual_ = 0;
  double largest_drift_ = 0;
};

}  // namespace treedyn::simulation
