// Contact, dry friction and the limits of stable steps.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hard/special.hpp"
#include "support/damping.hpp"

namespace treedyn::hard {

namespace {

using Scene = const model::Scene&;
using Dynamics = Source&;
using Entry = const support::Json&;

/// Height of the first contact's point.
double height(Run& run) {
  simulation::System& system = run.system();
  const simulation::ContactLaw& contact = system.forces().contacts().front();
  const auto p = system.geometry(run.q()).p();
  return contact.plane().height(p.segment<3>(3 * contact.point()));
}

double rising_speed(Run& run) {
  simulation::System& system = run.system();
  const simulation::ContactLaw& contact = system.forces().contacts().front();
  const auto C = system.geometry(run.q()).C().middleCols<3>(3 * contact.point());
  return (C * contact.plane().normal()).dot(run.qd());
}

Values contact_duration(Scene s, Dynamics d, Entry) {
  const std::vector<double> times = crossings(s, d, end_of(s), height);
  return {times.at(1) - times.at(0)};
}

Values exit_velocity(Scene s, Dynamics d, Entry) {
  return {value_at(s, d, crossings(s, d, end_of(s), height).at(1), rising_speed)};
}

Values peak_penetration(Scene s, Dynamics d, Entry) {
  return {-value_at(s, d, crossings(s, d, end_of(s), rising_speed).at(0), height)};
}

/// When the first dry joint sticks for good, and how often it slipped until then.
struct Stop {
  double time = 0;
  int swings = 0;
};

Stop stop_of(Scene s, Dynamics d) {
  Run run(s, d);
  const auto direction = [&] {
    return run.motion().slip_direction();
  };
  Stop stop{run.start(), direction() == 0 ? 0 : 1};
  int before = direction();
  run.observer = [&] {
    const int now = direction();
    stop.swings += now != 0 && now != before ? 1 : 0;
    stop.time = now == 0 && before != 0 ? run.motion().slip_time() : stop.time;
    before = now;
  };
  run.advance_to(run.end());
  return stop;
}

/// True if the motion of the undamped scene stays within a million times its first ten steps.
bool is_bounded(Scene scene, Dynamics source, const char* integrator, double h) {
  constexpr int kSteps = 3000;
  Run run(scene, source.motion(scene, integrator, h));
  double scale = 0;
  try {
    for (int k = 1; k <= kSteps; ++k) {
      run.advance_to(run.start() + k * h);
      const double size = run.q().cwiseAbs().maxCoeff();
      scale = k <= 10 ? std::max(scale, size) : scale;
      if (size > 1e6 * scale) {
        return false;
      }
    }
  } catch (const std::runtime_error&) {
    return false;
  }
  return true;
}

model::Scene undamped(Scene scene) {
  model::Scene result = scene;
  support::each_damping(result, [](Real& damping) { damping = 0; });
  return result;
}

/// Within 1e-5 of the longest step of which the motion stays bounded.
double stable_step(Scene scene, Dynamics source, const char* integrator,
                   std::pair<double, double> bracket) {
  const model::Scene without_damping = undamped(scene);
  auto [low, high] = bracket;
  while (high / low > 1 + 1e-5) {
    const double middle = std::sqrt(low * high);
    (is_bounded(without_damping, source, integrator, middle) ? low : high) = middle;
  }
  return low;
}

/// Generated code has its step inside and is compiled for each: the simulator finds where to look.
Values stable_step(Scene scene, Dynamics source, const char* integrator) {
  const std::unique_ptr<Source> simulator = simulator_source();
  const double expected = stable_step(scene, *simulator, integrator, {1e-6, 1});
  if (!is_bounded(undamped(scene), source, integrator, expected * (1 - 1e-3)) ||
      is_bounded(undamped(scene), source, integrator, expected * (1 + 1e-3))) {
    return {};
  }
  return {stable_step(scene, source, integrator, {expected * (1 - 1e-3), expected * (1 + 1e-3)})};
}

}  // namespace

std::vector<SpecialRow> contact_quantities() {
  return {
      {"contact_duration", contact_duration},
      {"exit_velocity", exit_velocity},
      {"peak_penetration", peak_penetration},
      {"stop_time",
       [](Scene s, Dynamics d, Entry) {
         return Values{stop_of(s, d).time};
       }},
      {"half_swings",
       [](Scene s, Dynamics d, Entry) {
         return Values{double(stop_of(s, d).swings)};
       }},
      {"stable_step_limit_semi_implicit_euler_undamped",
       [](Scene s, Dynamics d, Entry) {
         return stable_step(s, d, "semi-implicit-euler");
       }},
      {"stable_step_limit_rk4_undamped",
       [](Scene s, Dynamics d, Entry) {
         return stable_step(s, d, "rk4");
       }},
  };
}

}  // namespace treedyn::hard
