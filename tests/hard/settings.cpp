// How generated code steps a case: chosen from the scene alone.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "dynamics/scene_dynamics.hpp"
#include "formulate/scene_sticking.hpp"
#include "hard/generated.hpp"
#include "support/damping.hpp"

namespace treedyn::hard {

namespace {

/// The error of a step in a run that only looks for the length of steps: well below what float
/// keeps over thousands of them.
constexpr double kTrialError = 1e-8;
/// Of the steps of the trial, this part is shorter.
constexpr double kShorter = 0.1;
/// Steps of rk4, which passes positions of lower rank as dopri5-fixed does not (its stages at 0.2
/// to 0.8 make a hundred of an error there), in one of the latter.
constexpr double kOfOrderFour = 4;
/// Correction of drift: this part of an error within one step, at most 20 1/s.
constexpr double kCorrected = 0.2;

/// A step that an adaptive method of the same order would take at the demanding places, divided
/// such that the steps end with the scene.
double step_for(const model::Scene& scene) {
  const auto duration = static_cast<double>(scene.duration);
  if (duration == 0) {
    return 1e-3;
  }
  const std::unique_ptr<simulation::Dynamics> dynamics = program_dynamics(scene);
  simulation::Settings how;
  how.integrator = "dopri5";
  how.tolerance = kTrialError;
  simulation::Simulator simulator(scene, *dynamics, how);
  std::vector<double> steps;
  double before = simulator.time();
  simulator.advance_to(before + duration, [&] {
    if (simulator.time() > before) {
      steps.push_back(simulator.time() - before);
      before = simulator.time();
    }
    return steps.size() < 20000;
  });
  const auto at = steps.begin() + static_cast<std::ptrdiff_t>(kShorter * double(steps.size()));
  std::nth_element(steps.begin(), at, steps.end());
  return duration / std::ceil(duration / *at);
}

Method method_for(const model::Scene& scene) {
  const bool led = scene.duration > 0 && !scene.constraints.empty();
  return led ? Method{"rk4", step_for(scene) / kOfOrderFour}
             : Method{"dopri5-fixed", step_for(scene)};
}

model::Scene prepared(const model::Scene& scene, const std::string& integrator, double step) {
  model::Scene result = scene;
  result.stepping.integrator = integrator;
  result.stepping.step = Real(step);
  result.stepping.drift = scene.duration == 0 ? model::Drift::kNone : model::Drift::kBaumgarte;
  result.stepping.stabilisation = Real(std::min(20.0, kCorrected / step));
  formulate::settle_sticking(result);
  return result;
}

/// The scenes of one case differ in what its quantities change, and in states.
bool share_code(const model::Scene& a, const model::Scene& b) {
  const auto rows = [](const model::Scene& scene) {
    std::size_t sum = 0;
    for (const model::Constraint& constraint : scene.constraints) {
      sum += constraint.rows();
    }
    return sum;
  };
  const auto damping = [](model::Scene scene) {
    Real sum = 0;
    support::each_damping(scene, [&](const Real& d) { sum += d; });
    return sum;
  };
  return a.stepping.integrator == b.stepping.integrator && a.stepping.step == b.stepping.step &&
         rows(a) == rows(b) && damping(a) == damping(b);
}

long stages_of(const std::string& integrator) {
  return integrator == "rk4" ? 4 : integrator == "dopri5-fixed" ? 6 : 1;
}

}  // namespace

std::shared_ptr<const Code> GeneratedSource::code_of(const model::Scene& scene) {
  const auto same = std::find_if(made_.begin(), made_.end(),
                                 [&](const Made& made) { return share_code(made.scene, scene); });
  if (same != made_.end()) {
    return same->code;
  }
  made_.push_back({scene, std::make_shared<Code>(scene, scalar_, std::vector<std::string>{})});
  return made_.back().code;
}

std::unique_ptr<Motion> GeneratedSource::motion(const model::Scene& scene) {
  const Method method = method_.name.empty() ? method_for(scene) : method_;
  return motion(scene, method.name, method.step);
}

std::unique_ptr<Motion> GeneratedSource::motion(const model::Scene& scene,
                                                const std::string& integrator, double step) {
  const model::Scene ready = prepared(scene, integrator, step);
  std::shared_ptr<const Code> code = code_of(ready);
  const bool first = method_.name.empty();
  if (first) {
    method_ = {integrator, step};
    functions_only_ = scene.duration == 0;
    per_step_ = code->operations("step");
    const auto start = static_cast<std::size_t>(ready.start_phase);
    per_call_ = code->operations("constrained_dynamics" + code->states().at(start).ending);
  }
  return std::make_unique<GeneratedMotion>(ready, std::move(code), *this,
                                           first ? steps_ : other_steps_);
}

double GeneratedSource::sensitivity(const model::Scene&) {
  throw std::runtime_error("generated code has no parameter of the rank decision");
}

std::string GeneratedSource::cost() const {
  if (functions_only_) {
    return fmt::format("generated functions in {}, no step, {} operations a call", scalar_,
                       per_call_);
  }
  return fmt::format(
      "generated {} of {:.3g} s in {}, {} steps, {} evaluations, {} operations a step",
      method_.name, method_.step, scalar_, steps_, steps_ * stages_of(method_.name), per_step_);
}

std::unique_ptr<Source> generated_source(const std::string& scalar) {
  return std::make_unique<GeneratedSource>(scalar);
}

}  // namespace treedyn::hard
