// Functions of the state whose change of sign ends a step.
#pragma once

#include "simulation/system.hpp"

namespace treedyn::simulation {

/// Below this a height counts as zero and its rate decides the side, m.
inline constexpr double kOnPlane = 1e-10;
/// Parts of a step in which a change of sign is looked for.
inline constexpr int kScans = 8;

struct Watch {
  enum class Kind {
    kEvent,       ///< height of a point, downwards ends the phase
    kReaction,    ///< force of a constraint along a normal; a pull ends the phase
    kTime,        ///< what is left until `until`
    kExpression,  ///< value of an expression, downwards ends the phase
    kContact,     ///< height of a compliant contact, both ways
    kSlip,        ///< velocity of a slipping joint
    kStick,       ///< what is left of the friction that holds a sticking joint
  };
  Kind kind;
  std::size_t index;  ///< of the event in its phase, the contact, the friction
  int point;
  PlaneValues plane;
  int side;  ///< sign of the function now
  const model::Event* event = nullptr;
  double until = 0;  ///< kTime, s
  double start = 0;
  double start_slope = 0;

  /// The function in a state y = (q; qd).
  double value(System& system, double t, const Vector& y) const;
  /// Its rate in time; 0 where `has_slope` is false.
  double slope(System& system, const Vector& y) const;
  [[nodiscard]] bool has_slope() const { return kind == Kind::kEvent || kind == Kind::kContact; }
  /// True for what ends a phase when it becomes negative.
  [[nodiscard]] bool ends_phase() const { return event != nullptr; }
  /// The side on which a state is.
  int side_of(System& system, double t, const Vector& y) const;
  /// The first of kScans parts of a step of length h at whose end the function seems to be on the
  /// other side; 0 if none. \param end, end_slope  at the end of the step
  [[nodiscard]] int first_change(double h, double end, double end_slope) const;
};

}  // namespace treedyn::simulation
