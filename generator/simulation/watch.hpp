// Functions of the state whose change of sign ends a step.
#pragma once

#include <limits>

#include "simulation/system.hpp"

namespace treedyn::simulation {

/// Below this a height counts as zero and its rate decides the side, m; what is so little below
/// zero where another event happens has its own there.
inline constexpr double kOnPlane = 1e-10;
/// Below this its rate counts as zero, m/s: a point that was held there until now.
inline constexpr double kAtRest = 1e-10;
/// A height within this has not changed its side yet, m: roundings of a point that rests.
inline constexpr double kPlaneRounding = 1e-12;
/// Nor has an expression, in its own unit: roundings of one that is zero.
inline constexpr double kValueRounding = 1e-15;

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
  Kind kind = Kind::kEvent;
  std::size_t index = 0;  ///< of the event in its phase, the contact, the friction
  int point = 0;
  PlaneValues plane;
  int side = 0;        ///< sign of the function now
  bool lands = false;  ///< its event stops the point
  const model::Event* event = nullptr;
  /// Before this time an event is not looked at, s; the others always are.
  double until = -std::numeric_limits<double>::infinity();
  bool armed = true;  ///< `until` is over, `side` is that of now
  int next_side = 0;  ///< at the end of the step
  int before = 0;     ///< `side` at the beginning of the step; 0: it was not looked at there
  bool fired = false;

  /// The function in a state y = (q; qd).
  double value(System& system, double t, const Vector& y) const;
  /// Its rate in time. \pre is_height()
  double slope(System& system, const Vector& y) const;
  [[nodiscard]] bool is_height() const { return kind == Kind::kEvent || kind == Kind::kContact; }
  /// What the function has to be beyond zero on its other side.
  [[nodiscard]] double band() const {
    return is_height() ? kPlaneRounding : kind == Kind::kExpression ? kValueRounding : 0;
  }
  /// True for what ends a phase when it becomes negative.
  [[nodiscard]] bool ends_phase() const { return event != nullptr; }
  /// The side on which a state is; a pull counts whenever it is seen.
  int side_of(System& system, double t, const Vector& y) const;
  /// True if the other one has the same function, which ends a phase, of the same place.
  [[nodiscard]] bool looks_at_what(const Watch& other) const;
};

}  // namespace treedyn::simulation
