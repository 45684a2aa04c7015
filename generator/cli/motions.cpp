#include "cli/motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "dynamics/generated_run.hpp"
#include "dynamics/scene_dynamics.hpp"
#include "simulation/monitor.hpp"
#include "simulation/simulator.hpp"

namespace treedyn {

namespace {

using simulation::Vector;
using Values = GeneratedStep::Values;

Motion stepped_motion(const Subject& subject, const model::Scene& scene, const Start& start,
                      GeneratedStep& step) {
  Motion motion;
  const long every = std::lround(static_cast<double>(subject.interval / scene.stepping.step));
  const auto h = static_cast<long double>(scene.stepping.step);
  begin_motion(scene, start.q, start.qd, step);
  for (long k = 0; k < every * subject.times; ++k) {
    if (step.has("t")) {
      step.at("t")[0] = static_cast<long double>(scene.t0) + static_cast<long double>(k) * h;
    }
    motion.status |= step.call();
    if ((k + 1) % every == 0) {
      const Values& q = step.at("q");
      if (!std::all_of(q.begin(), q.end(), [](long double x) { return std::isfinite(x); })) {
        break;
      }
      motion.note(q, step.at("qd"));
    }
  }
  return motion;
}

}  // namespace

double distance(const Values& a, const Values& b) {
  if (a.size() != b.size()) {
    return std::numeric_limits<double>::infinity();
  }
  long double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return static_cast<double>(largest);
}

model::Scene stepped_scene(const Subject& subject, const Stepped& how) {
  model::Scene scene = subject.scene;
  scene.stepping.integrator = how.integrator;
  scene.stepping.step = subject.interval / Real(how.parts);
  scene.stepping.compensated = how.compensated;
  return scene;
}

std::vector<Motion> stepped_motions(const Subject& subject, const Stepped& how,
                                    const StepFiles& files) {
  const model::Scene scene = stepped_scene(subject, how);
  GeneratedStep step(files.name, files.files, files.signature);
  std::vector<Motion> result;
  result.reserve(subject.starts.size());
  for (const Start& start : subject.starts) {
    result.push_back(stepped_motion(subject, scene, start, step));
  }
  return result;
}

std::vector<Motion> simulated_motions(const Subject& subject, double tolerance) {
  const std::unique_ptr<simulation::Dynamics> dynamics = program_dynamics(subject.scene);
  simulation::Settings how;
  how.tolerance = tolerance;
  std::vector<Motion> result;
  for (const Start& start : subject.starts) {
    model::Scene scene = subject.scene;
    scene.q0.assign(start.q.begin(), start.q.end());
    scene.qd0.assign(start.qd.begin(), start.qd.end());
    simulation::Simulator simulator(scene, *dynamics, how);
    simulator.settle();
    Motion motion;
    for (int k = 1; k <= subject.times; ++k) {
      simulator.advance_to(static_cast<double>(scene.t0 + k * subject.interval),
                           [] { return true; });
      motion.note(simulator.q(), simulator.qd());
    }
    result.push_back(std::move(motion));
  }
  return result;
}

Energies::Energies(const model::Scene& scene)
    : dynamics_(program_dynamics(scene)),
      system_(scene, *dynamics_, 0),
      pose_(scene.tree, scene.gravity),
      joints_(static_cast<std::size_t>(scene.tree.dof())) {}

Values Energies::of(const Motion& motion) {
  Values result;
  for (std::size_t at = 0; at < motion.q.size(); at += joints_) {
    const Values q(&motion.q[at], &motion.q[at] + joints_);
    const Values qd(&motion.qd[at], &motion.qd[at] + joints_);
    const double energy = simulation::energy(system_, pose_, vector_of(q), vector_of(qd));
    result.push_back(static_cast<long double>(energy));
  }
  return result;
}

}  // namespace treedyn
