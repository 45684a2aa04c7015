#include "cli/drifts.hpp"

#include <algorithm>
#include <cmath>

#include "common/index.hpp"
#include "model/scene_facts.hpp"

namespace treedyn {

using simulation::Vector;

Drifts::Drifts(const model::Scene& scene, simulation::Dynamics& dynamics)
    : scene_(scene), system_(scene, dynamics, 0), states_(formulate::phase_states(scene, true)) {}

void Drifts::begin(int state, double t, const Vector& q) {
  system_.constraints().reset();
  largest_ = {};
  act(state, t, q);
}

void Drifts::act(int state, double t, const Vector& q) {
  simulation::Constraints& constraints = system_.constraints();
  const std::vector<int> before = constraints.active();
  const std::vector<int>& now = states_[to_index(state)].active;
  constraints.activate(now);
  const simulation::Terms& terms = system_.geometry(q);
  for (const int c : now) {
    if (!std::ranges::binary_search(before, c)) {
      constraints.begin(c, t, q, terms);
    }
  }
  state_ = state;
}

void Drifts::change(int state, double t, const Vector& q) {
  const int from = states_[to_index(state_)].phase;
  const int to = states_[to_index(state)].phase;
  for (const model::Event& event : scene_.phases[to_index(from)].until) {
    if (event.then != to) {
      continue;
    }
    const simulation::Terms& terms = system_.geometry(q);
    for (const int c : event.pins) {
      system_.constraints().pin(c, t, q, terms);
    }
  }
  act(state, t, q);
}

void Drifts::look(double t, const Vector& q, const Vector& qd) {
  const simulation::Constraints& constraints = system_.constraints();
  const simulation::Terms& terms = system_.geometry(q);
  constraints.errors(terms, t, q, phi_);
  constraints.jacobian(terms, J_);
  constraints.velocities(t, led_);
  for (int k = 0; k < constraints.rows(); ++k) {
    const model::Constraint& c = scene_.constraints[to_index(constraints.constraint(k))];
    if (!constraints.is_held(k) || c.sticks) {
      continue;
    }
    const bool turns = model::is_angular(scene_.tree, c);
    double& off = turns ? largest_.angle : largest_.length;
    double& speed = turns ? largest_.rate : largest_.speed;
    off = std::max(off, std::fabs(phi_[k]));
    speed = std::max(speed, std::fabs(J_.row(k).dot(qd) - led_[k]));
  }
}

}  // namespace treedyn
