// What a study measures along a motion.
#pragma once

#include <array>
#include <string_view>

namespace treedyn::accuracy {

/// Largest differences from the reference at the times of comparison; of drift sizes of phi and of
/// J qd less what is led, as they are; of events differences of their times.
enum class Error { kJoints, kEnergy, kDrift, kAngle, kSpeed, kRate, kEvents, kPoints };

struct ErrorRow {
  Error error;
  std::string_view name;    ///< of `--error`
  std::string_view column;  ///< in CSV; in JSON the plural
  std::string_view head;    ///< of a column for the reader
  std::string_view text;    ///< what it is the largest of
};

inline constexpr std::array<ErrorRow, 8> kErrors = {{
    {Error::kJoints, "joints", "error", "error", "error of a joint, rad or m"},
    {Error::kEnergy, "energy", "energy_error", "energy, J", "error of the energy, J"},
    {Error::kDrift, "drift", "drift", "drift, m", "drift of a constraint, m"},
    {Error::kAngle, "drift_angle", "drift_angle", "drift, rad", "drift of a constraint, rad"},
    {Error::kSpeed, "drift_speed", "drift_speed", "drift, m/s", "speed off a constraint, m/s"},
    {Error::kRate, "drift_rate", "drift_rate", "drift, rad/s", "speed off a constraint, rad/s"},
    {Error::kEvents, "events", "event_error", "events, s", "error of the time of an event, s"},
    {Error::kPoints, "points", "point_error", "points, m", "error of a point, m"},
}};

constexpr const ErrorRow& row_of(Error error) { return kErrors[static_cast<std::size_t>(error)]; }

}  // namespace treedyn::accuracy
