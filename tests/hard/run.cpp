#include "hard/run.hpp"

#include <algorithm>
#include <cmath>

namespace treedyn::hard {

Run::Run(const model::Scene& scene, Source& source) : Run(scene, source.motion(scene)) {}

Run::Run(const model::Scene& scene, std::unique_ptr<Motion> motion)
    : scene_(scene), motion_(std::move(motion)), pose_(scene.tree, scene.gravity) {
  first_energy_ = energy();
  observe();
}

const simulation::Pose& Run::pose() {
  pose_.update(q(), qd());
  return pose_;
}

double Run::energy() {
  pose();
  return pose_.kinetic_energy() + pose_.potential_energy() + system().elastic_energy(q());
}

double Run::energy_drift() const {
  return energy_change_ / std::max(std::fabs(first_energy_), most_kinetic_);
}

void Run::observe() {
  energy_change_ = std::max(energy_change_, std::fabs(energy() - first_energy_));
  most_kinetic_ = std::max(most_kinetic_, pose_.kinetic_energy());
  violation_ = std::max(violation_, system().violation(time(), q()).size);
  if (system().constraints().rows() > 0) {
    const simulation::Solution& now = solution();
    finite_ = finite_ && now.lambda.allFinite() && now.qdd.allFinite();
  }
  finite_ = finite_ && q().allFinite() && qd().allFinite();
  if (observer) {
    observer();
  }
}

void Run::advance_to(double time) {
  motion_->advance_to(time, [this] { observe(); });
}

const simulation::EventRecord* Run::event(std::size_t number) {
  const double latest = end() + static_cast<double>(scene_.duration) / 100;
  for (int k = 1; k <= 100 && events().size() < number && time() < latest; ++k) {
    advance_to(std::max(time(), end() + (latest - end()) * k / 100));
  }
  return number >= 1 && number <= events().size() ? &events()[number - 1] : nullptr;
}

}  // namespace treedyn::hard
