// Scenes of the tests: from text or from models/scenes, run to their end.
#pragma once

#include <memory>
#include <string>

#include "description/scene_reader.hpp"
#include "dynamics/scene_dynamics.hpp"
#include "simulation/recording.hpp"

namespace treedyn::simulation {

/// A scene as YAML whose model is named as if it stood in models/scenes.
inline model::Scene scene_of(const std::string& text) {
  return description::parse_scene(text, std::string(TREEDYN_SOURCE_DIR) + "/models/scenes/test");
}

inline model::Scene committed(const std::string& name) {
  return description::read_scene(std::string(TREEDYN_SOURCE_DIR) + "/models/scenes/" + name +
                                 ".yaml");
}

inline Settings settings_of(const model::Scene& scene) {
  Settings result;
  result.integrator = scene.stepping.integrator;
  result.step = static_cast<double>(scene.stepping.step);
  result.tolerance = static_cast<double>(scene.stepping.tolerance);
  result.drift = scene.stepping.drift;
  result.stabilisation = static_cast<double>(scene.stepping.stabilisation);
  return result;
}

/// A scene, its dynamics and a simulator that begins on the constraints.
struct Running {
  explicit Running(model::Scene of) : Running(std::move(of), nullptr) {}
  Running(model::Scene of, const Settings* settings)
      : scene(std::move(of)),
        dynamics(program_dynamics(scene)),
        simulator(scene, *dynamics, settings == nullptr ? settings_of(scene) : *settings) {
    simulator.settle();
  }

  void advance_to(double time) {
    simulator.advance_to(time, [] { return true; });
  }
  Recording record(double output_step) {
    return simulation::record(scene, simulator, output_step, [](double) { return true; });
  }

  model::Scene scene;
  std::unique_ptr<Dynamics> dynamics;
  Simulator simulator;
};

/// The values of a column.
inline std::vector<double> column(const Recording& recording, const std::string& name) {
  for (std::size_t k = 0; k < recording.columns.size(); ++k) {
    if (recording.columns[k] == name) {
      std::vector<double> result;
      for (const Row& row : recording.rows) {
        result.push_back(row.values[k]);
      }
      return result;
    }
  }
  throw std::runtime_error("no column " + name);
}

}  // namespace treedyn::simulation
