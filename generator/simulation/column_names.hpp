// Names of columns and of what a message is about.
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"

namespace treedyn::simulation {

/// "drive of joint 'elbow' has no value at t = 2 s": what acts and has none there or just behind;
/// empty if there is nothing. \param state  q and behind it qd
std::string no_value(const model::Scene& scene, double time, const std::vector<double>& state);

/// "the motion is not finite at t = 2 s; before, joint 'elbow' was at 1 and moved at 3e+09 rad/s":
/// the fastest joint; what acts and has no value in the last state that was finite, if it is that.
/// \param state  this one: q and behind it qd
std::string not_finite(const model::Scene& scene, double time, const std::vector<double>& state);

/// The names of the rows of constraints, one a reaction: "foot.x", "loop.2".
std::vector<std::string> reaction_names(const model::Scene& scene);

/// A column of numbers in a table.
struct Column {
  std::string name;
  std::string unit;
};
/// What a table shows of one state: q, qd, reactions, drives, springs, contacts, points, energies
/// and drift.
std::vector<Column> columns_of(const model::Scene& scene);

/// "touch_down of left_foot", "lift_off of floor", "time", "expression 2": event of a phase.
std::string event_name(const model::Scene& scene, int phase, std::size_t event);

}  // namespace treedyn::simulation
