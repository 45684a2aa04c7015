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
  std::vector<double> contacts;  ///< x, y, z of each: the largest since the row before, base frame
};

/// Of every three components those of the longer vector. \pre `vectors` is empty or of that size
void keep_longer(std::vector<double>& vectors, const std::vector<double>& others);

/// Lines between nodes that show the robot: origins of links, points and centres of mass.
struct Figure {
  std::vector<std::string> names;
  std::vector<std::pair<int, int>> lines;
  std::vector<int> visible;  ///< nodes that are bodies or points, not joints in space
};

struct Recording {
  std::vector<std::string> columns;  ///< behind t and phase: simulation::columns_of
  std::vector<Row> rows;             ///< at equal intervals, before and after every event
  std::vector<EventRecord> events;
  Figure figure;
  Cost cost;
  std::vector<Notice> notices;  ///< warnings of the motion
  double energy_error = 0;      ///< at the end, that no force explains, J
  double energy_part = 0;       ///< the largest, as a part of what was exchanged
  double residual = 0;          ///< largest of the row equations
  double drift_warning = 0;     ///< beyond which there is one, m
  double drift = 0;             ///< largest position error of a row that acts, m or rad
  std::string stopped;          ///< why the motion ends early; empty: it does not
  double end = 0;               ///< when it ends, s
};

/// How far a motion is, between 0 and 1; returns false to stop it.
using Progress = std::function<bool(double part)>;

/// Runs a scene from its beginning to its end. Errors of the motion end the recording.
/// \param output_step  s between rows
Recording record(const model::Scene& scene, Simulator& simulator, double output_step,
                 const Progress& progress);

/// Notes the state in which the simulator is, with these reactions of all constraints: a row.
using ShowState = std::function<void(const std::vector<double>& reactions)>;
/// Looks at it, in every step.
using LookAtState = std::function<void()>;
/// The recording of a motion that somebody else computes and shows: `drive` returns false if it is
/// stopped. Errors of the motion end it.
Recording record_states(const model::Scene& scene, Simulator& simulator,
                        const std::function<bool(const ShowState&, const LookAtState&)>& drive);

}  // namespace treedyn::simulation
