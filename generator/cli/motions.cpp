#include "cli/motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "common/transformed.hpp"
#include "dynamics/generated_run.hpp"
#include "formulate/scene_sticking.hpp"
#include "model/effects.hpp"
#include "simulation/monitor.hpp"
#include "simulation/simulator.hpp"

namespace treedyn {

namespace {

using simulation::Vector;
using Values = GeneratedStep::Values;

/// Looks at the constraints between two comparisons, at most.
constexpr long kLooks = 10;

bool is_finite(const Values& values) {
  return std::ranges::all_of(values, [](long double x) { return std::isfinite(x); });
}

Motion stepped_motion(const Subject& subject, const model::Scene& scene, const Start& start,
                      GeneratedStep& step, Drifts* drifts) {
  Motion motion;
  const long every = std::lround(static_cast<double>(subject.interval / scene.stepping.step));
  const long looks = std::max(1L, every / kLooks);
  const auto h = static_cast<long double>(scene.stepping.step);
  const auto t0 = static_cast<long double>(scene.t0);
  begin_motion(scene, start.q, start.qd, step);
  if (drifts != nullptr) {
    drifts->begin(scene.start_phase, static_cast<double>(t0), start.q);
  }
  const auto argument = [&](const char* name) {
    return step.has(name) ? &step.at(name) : nullptr;
  };
  const Values& q = step.at("q");
  const Values& qd = step.at("qd");
  Values* const time = argument("t");
  const Values* const number = argument("phase");
  const auto phase = [&] {
    return number != nullptr ? static_cast<std::size_t>((*number)[0]) : std::size_t{0};
  };
  for (long k = 0; k < every * subject.times; ++k) {
    motion.steps.resize(std::max(motion.steps.size(), phase() + 1));
    program::StepCount& steps = motion.steps[phase()];
    if (time != nullptr) {
      (*time)[0] = t0 + static_cast<long double>(k) * h;
    }
    motion.status |= step.call();
    steps += {1, step.repeated(), step.repeated()};
    if (!is_finite(q)) {
      break;
    }
    for (const SteppedEvent& event : step.events()) {
      motion.events.push_back({event.number, static_cast<long double>(k) * h + event.at});
    }
    const auto now = static_cast<double>(t0 + static_cast<long double>(k + 1) * h);
    if (drifts != nullptr && !step.events().empty()) {
      const int state = number != nullptr ? static_cast<int>(phase()) : scene.start_phase;
      drifts->change(state, now, vector_of(q));
    }
    if (drifts != nullptr && (k + 1) % looks == 0) {
      drifts->look(now, vector_of(q), vector_of(qd));
    }
    if ((k + 1) % every == 0) {
      motion.note(q, qd);
    }
  }
  motion.off = drifts == nullptr ? OffRows{} : drifts->largest();
  return motion;
}

/// The times of every event, by its number.
std::map<int, Values> times_of(const Motion& motion) {
  std::map<int, Values> result;
  for (const SteppedEvent& event : motion.events) {
    result[event.number].push_back(event.at);
  }
  return result;
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

double event_distance(const Motion& a, const Motion& b, double end) {
  std::map<int, Values> before = times_of(a);
  std::map<int, Values> behind = times_of(b);
  const auto last = static_cast<long double>(end);
  long double largest = 0;
  for (const auto& [number, unused] : before) {
    behind[number];
  }
  for (const auto& [number, times] : behind) {
    const Values& others = before[number];
    for (std::size_t k = 0; k < std::max(times.size(), others.size()); ++k) {
      const long double off = k >= times.size()    ? last - others[k]
                              : k >= others.size() ? last - times[k]
                                                   : std::abs(times[k] - others[k]);
      largest = std::max(largest, off);
    }
  }
  return static_cast<double>(largest);
}

model::Scene stepped_scene(const Subject& subject, const Stepped& how) {
  const accuracy::Variant& variant = how.variant;
  const accuracy::Variant usual;
  model::Scene scene = variant.without == usual.without
                           ? subject.scene
                           : model::without_effect(subject.scene, variant.without);
  if (variant.stabilisation != usual.stabilisation) {
    scene.stepping.drift = *model::drift_of(variant.stabilisation);
  }
  if (variant.cuts != usual.cuts) {
    scene.stepping.cuts = std::stoi(variant.cuts);
  }
  scene.stepping.integrator = how.integrator;
  scene.stepping.step = subject.interval / Real(how.parts);
  scene.stepping.compensated = how.compensated;
  return scene;
}

StepFiles stepped_files(const Subject& subject, const Stepped& how, StepWriter& writer,
                        bool tells) {
  StepForm form;
  form.scalar = how.scalar;
  form.sincos = how.variant.sincos == "libm" ? emit::Sincos::kLibm : emit::Sincos::kPair;
  form.forward_dynamics = formulate::forward_dynamics_of(how.variant.forward_dynamics);
  form.tells = tells;
  return writer.files(stepped_scene(subject, how), form, how.variant.without);
}

namespace {

model::Scene begun_at(model::Scene scene, const Start& start) {
  scene.q0.assign(start.q.begin(), start.q.end());
  scene.qd0.assign(start.qd.begin(), start.qd.end());
  return scene;
}

/// The scene of a step from another state, which decides what sticks to begin with.
model::Scene settled_at(const model::Scene& of, const Start& start) {
  model::Scene scene = begun_at(of, start);
  formulate::settle_sticking(scene);
  return scene;
}

}  // namespace

std::vector<Motion> stepped_motions(const Subject& subject, const Stepped& how,
                                    const StepFiles& files) {
  const model::Scene scene = stepped_scene(subject, how);
  GeneratedStep step(files.name, files.files, files.stepper);
  std::optional<Drifts> drifts;
  model::Scene whole = subject.scene;  // the phases of a scene without some force are the same
  whole.stepping = scene.stepping;
  formulate::settle_sticking(whole);
  if (!subject.scene.constraints.empty()) {
    drifts.emplace(whole, *subject.dynamics);
  }
  return transformed(subject.starts, [&](const Start& start) {
    return stepped_motion(subject, settled_at(scene, start), start, step,
                          drifts ? &*drifts : nullptr);
  });
}

double step_seconds(const Subject& subject, const Stepped& how, const StepFiles& files) {
  const Start& start = subject.starts.front();
  GeneratedStep step(files.name, files.files, files.stepper);
  begin_motion(settled_at(stepped_scene(subject, how), start), start.q, start.qd, step);
  return step.seconds();
}

std::vector<Motion> simulated_motions(const Subject& subject, double tolerance,
                                      std::string& warning) {
  simulation::Settings how;
  how.tolerance = tolerance;
  std::vector<Motion> result;
  for (const Start& start : subject.starts) {
    const model::Scene scene = begun_at(subject.scene, start);
    simulation::Simulator simulator(scene, *subject.dynamics, how);
    simulator.settle();
    Motion motion;
    for (int k = 1; k <= subject.times; ++k) {
      simulator.advance_to(static_cast<double>(scene.t0 + k * subject.interval),
                           [] { return true; });
      motion.note(simulator.q(), simulator.qd());
    }
    result.push_back(std::move(motion));
    const std::vector<simulation::Notice>& notices = simulator.monitor().notices();
    if (warning.empty() && !notices.empty()) {
      warning = fmt::format("initial state {}: {}", result.size(), notices.front().text);
    }
  }
  return result;
}

Values places(const model::Scene& scene, const std::vector<model::Point>& points,
              const Motion& motion) {
  simulation::Pose pose(scene.tree, scene.gravity);
  const auto joints = static_cast<std::size_t>(scene.tree.dof());
  Values result;
  for (std::size_t at = 0; at < motion.q.size(); at += joints) {
    const Vector q = vector_of(Values(&motion.q[at], &motion.q[at] + joints));
    pose.update(q, Vector::Zero(q.size()));
    for (const model::Point& point : points) {
      const Eigen::Vector3d p = pose.point(point.link, simulation::vector_of(point.at));
      result.insert(result.end(), p.begin(), p.end());
    }
  }
  return result;
}

double place_distance(const Values& a, const Values& b) {
  if (a.size() != b.size()) {
    return std::numeric_limits<double>::infinity();
  }
  long double largest = 0;
  for (std::size_t k = 0; k < a.size(); k += 3) {
    largest = std::max(largest, std::hypot(a[k] - b[k], a[k + 1] - b[k + 1], a[k + 2] - b[k + 2]));
  }
  return static_cast<double>(largest);
}

Energies::Energies(const Subject& subject)
    : system_(subject.scene, *subject.dynamics, 0),
      pose_(subject.scene.tree, subject.scene.gravity),
      joints_(static_cast<std::size_t>(subject.scene.tree.dof())) {}

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
