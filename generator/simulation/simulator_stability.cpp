// Steps beyond the stability limits of their method.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "simulation/simulator.hpp"

namespace treedyn::simulation {

namespace {

/// What slows down so much that so many steps would end it is at rest.
constexpr double kStepsToRest = 10;

}  // namespace

Stability Simulator::stability(Dynamics& dynamics, const Vector& qd, Closed contacts) {
  System closed(scene_, dynamics, settings_.baumgarte());
  closed.constraints() = system_.constraints();
  std::vector<int> active = system_.constraints().active();
  std::erase_if(active, [&](int c) {  // frictions decide that below
    return scene_.constraints[static_cast<std::size_t>(c)].sticks;
  });
  closed.constraints().activate(active);
  for (std::size_t k = 0; k < closed.frictions().size(); ++k) {
    stick_or_slip(closed, t_, y_, k);
  }
  return stability_at(scene_, closed, t_, q(), qd, contacts);
}

Stability Simulator::stability(Dynamics& dynamics) {
  Stability result = stability(dynamics, qd(), Closed::kAll);
  note_limit(result, "step", "with contacts closed");
  return result;
}

void Simulator::note_limit(const Stability& stability, const std::string& kind,
                           const std::string& state) {
  for (const StabilityLimit& limit : stability.limits) {
    if (integrator_->error_order() > 0 || limit.integrator != settings_.integrator || !limit.step ||
        settings_.step <= *limit.step) {
      continue;
    }
    monitor_.note(
        {kind, limit.integrator, t_, settings_.step, *limit.step, "s",
         fmt::format("a step of {:.4g} s is beyond the stability limit of {}, {:.3g} s at t = "
                     "{:.6g} s {}; a stable step is {:.2g} s",
                     settings_.step, limit.integrator, *limit.step, t_, state, 0.9 * *limit.step)});
  }
}

void Simulator::judge_rest(Dynamics& dynamics) {
  if (integrator_->error_order() > 0) {
    return;
  }
  try {
    Vector speeds = qd();
    const Vector there = system_.accelerate(t_, q(), speeds).qdd;
    const Vector back = system_.accelerate(t_, q(), -speeds).qdd;
    bool rests = false;
    for (Eigen::Index k = 0; k < speeds.size(); ++k) {
      const bool opposed = there[k] * speeds[k] < 0 && back[k] * speeds[k] > 0;
      const double now = kStepsToRest * std::fabs(there[k]);  // not of what goes on steadily
      const double most = settings_.step * std::min(now, std::fabs(back[k]));
      speeds[k] = opposed && std::fabs(speeds[k]) <= most ? 0 : speeds[k];
      rests |= speeds[k] == 0;
    }
    if (rests) {
      note_limit(stability(dynamics, speeds, Closed::kTouching), "rest", "with joints at rest");
    }
  } catch (const std::runtime_error&) {  // a state nearby has no accelerations: no limit to tell
  }
}

}  // namespace treedyn::simulation
