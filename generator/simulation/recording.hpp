// The motion of a scene as a table.
#pragma once

#include <string>
#include <vector>

#include "simulation/pose.hpp"
#include "simulation/simulator.hpp"

namespace treedyn::simulation {

/// One state: what `Recording::columns` names.
struct Row {
  double t = 0;
  int phase = 0;
  std::vector<double> values;
  std::vector<Eigen::Vector3d> nodes;  ///< of the figure, base frame, m
};

/// Lines between nodes that show the robot: origins of links, points and centres of mass.
struct Figure {
  std::vector<std::string> names;
  std::vector<std::pair<int, int>> lines;
};

struct Recording {
  std::vector<std::string> columns;  ///< behind t and phase: q[joint], qd[joint], R[..], ..
  std::vector<Row> rows;             ///< at equal intervals, before and after every event
  std::vector<EventRecord> events;
  Figure figure;
  long steps = 0;
  std::string stopped;  ///< why the motion ends early; empty: it does not
};

/// How far a motion is, between 0 and 1; returns false to stop it.
using Progress = std::function<bool(double part)>;

/// Runs a scene from its beginning to its end. Errors of the motion end the recording.
/// \param output_step  s between rows
Recording record(const model::Scene& scene, Simulator& simulator, double output_step,
                 const Progress& progress);

/// Notes the state in which the simulator is, with these reactions of all constraints.
using ShowState = std::function<void(const std::vector<double>& reactions)>;
/// The recording of a motion that somebody else computes and shows: `drive` returns false if it is
/// stopped. Errors of the motion end it.
Recording record_states(const model::Scene& scene, Simulator& simulator,
                        const std::function<bool(const ShowState&)>& drive);

/// The names of the rows of constraints, one a reaction: "foot.x", "loop.2".
std::vector<std::string> reaction_names(const model::Scene& scene);

}  // namespace treedyn::simulation
