// Impacts of all constraints at once, with and without their tangential rows.
#include <algorithm>
#include <cmath>

#include "hard/special.hpp"

namespace treedyn::hard {

namespace {

/// Only the rows along gravity.
model::Scene without_friction(const model::Scene& scene) {
  model::Scene result = scene;
  const Eigen::Vector3d g = simulation::vector_of(scene.gravity).normalized();
  for (model::Constraint& constraint : result.constraints) {
    std::erase_if(constraint.directions, [&](const model::Vector3& d) {
      return std::fabs(simulation::vector_of(d).dot(g)) < 0.5;
    });
  }
  return result;
}

struct Outcome {
  Values qd, impulse;
  double vertical, energy_gain, rank;
};

Outcome impact(const model::Scene& scene, Source& source) {
  Run run(scene, source);
  const Strike strike = run.motion().strike_all();
  simulation::Pose pose(scene.tree, scene.gravity);
  pose.update(run.q(), strike.qd);
  const Eigen::Vector3d up = -simulation::vector_of(scene.gravity).normalized();
  double vertical = 0;
  Eigen::Index row = 0;
  for (const model::Constraint& constraint : scene.constraints) {
    for (const model::Vector3& d : constraint.directions) {
      vertical += strike.impulse[row++] * simulation::vector_of(d).dot(up);
    }
  }
  const double gain = pose.kinetic_energy() - run.pose().kinetic_energy();
  return {values_of(strike.qd), values_of(strike.impulse), vertical, gain, double(strike.rank)};
}

using Scene = const model::Scene&;
using Dynamics = Source&;
using Entry = const support::Json&;

Values sensitivity(Scene scene, Dynamics source, Entry) { return {source.sensitivity(scene)}; }

}  // namespace

std::vector<SpecialRow> impact_quantities() {
  return {
      {"frictionless_qd_after",
       [](Scene s, Dynamics d, Entry) {
         return impact(without_friction(s), d).qd;
       }},
      {"frictionless_impulses_min_norm",
       [](Scene s, Dynamics d, Entry) {
         return impact(without_friction(s), d).impulse;
       }},
      {"frictionless_total_vertical_impulse",
       [](Scene s, Dynamics d, Entry) {
         return Values{impact(without_friction(s), d).vertical};
       }},
      {"noslip_qd_after",
       [](Scene s, Dynamics d, Entry) {
         return impact(s, d).qd;
       }},
      {"noslip_impulses_min_norm",
       [](Scene s, Dynamics d, Entry) {
         return impact(s, d).impulse;
       }},
      {"kinetic_energy_must_not_increase",
       [](Scene s, Dynamics d, Entry) {
         return Values{
             std::max({0.0, impact(s, d).energy_gain, impact(without_friction(s), d).energy_gain})};
       }},
      {"frictionless_noslip_rank",
       [](Scene s, Dynamics d, Entry) {
         return Values{impact(without_friction(s), d).rank, impact(s, d).rank};
       }},
      {"sensitivity_to_regularisation", sensitivity},
  };
}

}  // namespace treedyn::hard
