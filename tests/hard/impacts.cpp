// Impacts of all constraints at once, with and without their tangential rows.
#include <algorithm>
#include <cmath>
#include <numeric>

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

Outcome impact(const model::Scene& scene, simulation::Dynamics& dynamics) {
  Run run(scene, dynamics);
  simulation::Simulator& simulator = run.simulator();
  std::vector<int> all(scene.constraints.size());
  std::iota(all.begin(), all.end(), 0);
  simulation::Vector qd = simulator.qd();
  const simulation::Vector P = simulator.system().impact(run.start(), simulator.q(), qd, all, 0);
  simulation::Pose pose(scene.tree, scene.gravity);
  pose.update(simulator.q(), qd);
  const Eigen::Vector3d up = -simulation::vector_of(scene.gravity).normalized();
  double vertical = 0;
  for (int k = 0; k < P.size(); ++k) {
    vertical += P[k] * simulator.system().constraints().direction(k).dot(up);
  }
  const double gain = pose.kinetic_energy() - run.pose().kinetic_energy();
  return {values_of(qd), values_of(P), vertical, gain, double(simulator.solution().rank)};
}

using Scene = const model::Scene&;
using Dynamics = simulation::Dynamics&;
using Entry = const support::Json&;

/// Position, at t0: the change of qdd when the one parameter of the rank decision is a tenth.
Values sensitivity(Scene scene, Dynamics dynamics, Entry) {
  Run run(scene, dynamics);
  const simulation::Vector qdd = run.simulator().solution().qdd;
  run.simulator().system().set_rank_threshold(simulation::kRankThreshold / 10);
  return {(run.simulator().solution().qdd - qdd).cwiseAbs().maxCoeff()};
}

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
