#include "hard/run.hpp"

#include <algorithm>
#include <cmath>

namespace treedyn::hard {

simulation::Settings settings() {
  simulation::Settings result;
  result.integrator = "fehlberg78";
  result.tolerance = 1e-12;
  return result;
}

Run::Run(const model::Scene& scene, simulation::Dynamics& dynamics, const simulation::Settings& how)
    : scene_(scene), simulator_(scene, dynamics, how), pose_(scene.tree, scene.gravity) {
  first_energy_ = energy();
  observe();
}

const simulation::Pose& Run::pose() {
  pose_.update(simulator_.q(), simulator_.qd());
  return pose_;
}

double Run::energy() {
  pose();
  return pose_.kinetic_energy() + pose_.potential_energy() +
         simulator_.system().elastic_energy(simulator_.q());
}

double Run::energy_drift() const {
  return energy_change_ / std::max(std::fabs(first_energy_), most_kinetic_);
}

void Run::observe() {
  energy_change_ = std::max(energy_change_, std::fabs(energy() - first_energy_));
  most_kinetic_ = std::max(most_kinetic_, pose_.kinetic_energy());
  violation_ =
      std::max(violation_, simulator_.system().violation(simulator_.time(), simulator_.q()));
  if (simulator_.system().constraints().rows() > 0) {
    const simulation::Solution& solution = simulator_.solution();
    finite_ = finite_ && solution.lambda.allFinite() && solution.qdd.allFinite();
  }
  finite_ = finite_ && simulator_.q().allFinite() && simulator_.qd().allFinite();
  if (observer) {
    observer();
  }
}

void Run::advance_to(double time) {
  simulator_.advance_to(time, [this] {
    observe();
    return true;
  });
}

const simulation::EventRecord* Run::event(std::size_t number) {
  const double latest = end() + static_cast<double>(scene_.duration) / 100;
  const auto& events = simulator_.events();
  for (int k = 1; k <= 100 && events.size() < number && simulator_.time() < latest; ++k) {
    advance_to(std::max(simulator_.time(), end() + (latest - end()) * k / 100));
  }
  return number >= 1 && number <= events.size() ? &events[number - 1] : nullptr;
}

}  // namespace treedyn::hard
