#include "cli/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "accuracy/chart.hpp"
#include "accuracy/report.hpp"
#include "common/identifier.hpp"
#include "description/scene_reader.hpp"
#include "dynamics/generated_run.hpp"
#include "dynamics/scene_dynamics.hpp"
#include "pipeline.hpp"
#include "program/random.hpp"
#include "simulation/simulator.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace {

using accuracy::Outcome;
using accuracy::Setting;
using accuracy::Study;
using Values = GeneratedStep::Values;

/// The scene's motion is compared at this many times.
constexpr int kTimes = 50;
/// Steps of a ladder: the longest and the shortest as parts of the time between two comparisons.
constexpr double kLadder[] = {1, 2, 5, 10, 20, 50, 100, 200, 500};
/// Steps of one run at most.
constexpr double kMostSteps = 400'000;
/// Error of a step of the reference.
constexpr double kReferenceTolerance = 1e-13;

using simulation::Vector;

struct State {
  Vector q;
  Vector qd;
};

/// q at every time of comparison, one behind the other; ends where the motion is not finite.
struct Motion {
  Values q;
  int status = 0;
};

model::Scene stepped(const model::Scene& scene, const std::string& integrator, double step) {
  model::Scene result = scene;
  result.stepping.compensated = false;
  result.stepping.integrator = integrator;
  result.stepping.step = Real(fmt::format("{}", step));
  return result;
}

/// The scene's own initial state and others within `spread`, moved onto the constraints.
std::vector<State> band(const AccuracyRequest& request, const model::Scene& scene) {
  std::vector<State> result;
  program::Random random(1);
  const std::unique_ptr<simulation::Dynamics> dynamics = program_dynamics(scene);
  for (int k = 0; k < request.states; ++k) {
    model::Scene other = scene;
    const auto move = [&](Real& x) {
      x += Real(request.spread * random.symmetric()) * std::max(Real(abs(x)), Real("0.1"));
    };
    if (k > 0) {
      std::for_each(other.q0.begin(), other.q0.end(), move);
      std::for_each(other.qd0.begin(), other.qd0.end(), move);
    }
    simulation::Simulator simulator(other, *dynamics, {});
    simulator.settle();
    result.push_back({simulator.q(), simulator.qd()});
    if (scene.constraints.empty()) {  // an initial state that float holds is no error of the step
      result.back().q = result.back().q.cast<float>().cast<double>();
      result.back().qd = result.back().qd.cast<float>().cast<double>();
    }
  }
  return result;
}

/// Steps from a state to the end of the scene.
Motion run(GeneratedStep& step, const model::Scene& scene, const State& initial, long steps,
           long every) {
  Motion motion;
  const auto h = static_cast<double>(scene.stepping.step);
  begin_motion(scene, initial.q, initial.qd, step);
  for (long k = 0; k < steps; ++k) {
    if (step.has("t")) {
      step.at("t")[0] = static_cast<double>(scene.t0) + static_cast<double>(k) * h;
    }
    motion.status |= step.call();
    if ((k + 1) % every == 0) {
      const Values& q = step.at("q");
      if (!std::all_of(q.begin(), q.end(), [](double x) { return std::isfinite(x); })) {
        break;
      }
      motion.q.insert(motion.q.end(), q.begin(), q.end());
    }
  }
  return motion;
}

/// The largest difference of two motions; not finite if one of them ends early.
double distance(const Motion& a, const Motion& b) {
  if (a.q.size() != b.q.size()) {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0;
  for (std::size_t k = 0; k < a.q.size(); ++k) {
    largest = std::max(largest, std::abs(a.q[k] - b.q[k]));
  }
  return largest;
}

/// The scene, its band and the times of comparison.
struct Subject {
  model::Scene scene;
  std::string file;
  std::vector<State> states;
  double interval = 0;  ///< s between comparisons
  int times = 0;

  [[nodiscard]] long every(double step) const { return std::lround(interval / step); }
  /// Of the generated step, from every initial state. \param[out] cost  of one step
  [[nodiscard]] std::vector<Motion> motions(const model::Scene& stepped, emit::Scalar scalar,
                                            program::Cost* cost) const {
    StepFiles files = step_files(stepped, scalar, file);
    if (cost != nullptr) {
      *cost = files.cost;
    }
    GeneratedStep step(files.name, files.files, std::move(files.signature));
    const long between = every(static_cast<double>(stepped.stepping.step));
    std::vector<Motion> result;
    for (const State& state : states) {
      result.push_back(run(step, stepped, state, between * times, between));
    }
    return result;
  }
};

/// The interpreted equations of the scene by Fehlberg's method of order eight, events located to
/// the resolution of time, constraints projected.
std::vector<Motion> simulated(const Subject& subject) {
  std::vector<Motion> result;
  const std::unique_ptr<simulation::Dynamics> dynamics = program_dynamics(subject.scene);
  simulation::Settings how;
  how.tolerance = kReferenceTolerance;
  for (const State& state : subject.states) {
    model::Scene scene = subject.scene;
    scene.q0.assign(state.q.begin(), state.q.end());
    scene.qd0.assign(state.qd.begin(), state.qd.end());
    simulation::Simulator simulator(scene, *dynamics, how);
    simulator.settle();
    Motion motion;
    for (int k = 1; k <= subject.times; ++k) {
      simulator.advance_to(static_cast<double>(scene.t0) + k * subject.interval,
                           [] { return true; });
      const Vector q = simulator.q();
      motion.q.insert(motion.q.end(), q.begin(), q.end());
    }
    result.push_back(std::move(motion));
  }
  return result;
}

/// `simulate`, checked by the generated step of order five in double with short steps: two programs
/// that share neither text nor method.
std::vector<Motion> reference(const Subject& subject, double step, Study& study) {
  const std::vector<Motion> exact = simulated(subject);
  const std::vector<Motion> second =
      subject.motions(stepped(subject.scene, "dopri5-fixed", step), emit::Scalar::kDouble, nullptr);
  for (std::size_t k = 0; k < exact.size(); ++k) {
    study.reference_agreement = std::max(study.reference_agreement, distance(exact[k], second[k]));
  }
  study.reference_settings = {fmt::format("simulate, fehlberg78 to {:.0e}", kReferenceTolerance),
                              fmt::format("the generated dopri5-fixed of {} s in double", step)};
  return exact;
}

/// \throws UsageError if no whole number of steps makes `time`
void require_part(double step, double time, const std::string& what) {
  if (std::abs(std::round(time / step) * step - time) > 1e-9 * time) {
    throw UsageError(fmt::format("step {} s does not divide {} s, {}", step, time, what));
  }
}

/// Falling steps: those that were asked for, else parts of the controller's period or of the time
/// between comparisons.
std::vector<double> ladder(const AccuracyRequest& request, double interval, int times) {
  std::vector<double> result = request.steps;
  const double longest = request.rate ? 1 / *request.rate : interval;
  for (const double part : kLadder) {
    if (request.steps.empty() && part * times * interval / longest <= kMostSteps) {
      result.push_back(longest / part);
    }
  }
  if (result.empty()) {
    throw UsageError(fmt::format("--rate {}: {} s need more than {} steps; expected a lower rate",
                                 *request.rate, times * interval, kMostSteps));
  }
  for (const double step : result) {
    if (request.rate) {
      require_part(step, longest, fmt::format("the period of {} Hz", *request.rate));
    }
    require_part(step, interval, "the time between comparisons");
  }
  return result;
}

Subject subject_of(const AccuracyRequest& request) {
  Subject subject;
  subject.scene = description::read_scene(request.scene);
  subject.file = request.scene;
  const auto duration = static_cast<double>(subject.scene.duration);
  if (!(duration > 0)) {
    throw InputError({request.scene, 0, 0}, "the scene has no duration; expected one above zero");
  }
  // a power of ten times 1, 2 or 5, so that steps are short decimals
  const double rough = duration / kTimes;
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  subject.interval = rough >= 5 * decade ? 5 * decade : rough >= 2 * decade ? 2 * decade : decade;
  subject.times = static_cast<int>(std::floor(duration / subject.interval * (1 + 1e-12)));
  subject.states = band(request, subject.scene);
  return subject;
}

}  // namespace

accuracy::Study study_accuracy(const AccuracyRequest& request, const AccuracyTrace& trace) {
  const Subject subject = subject_of(request);
  Study study;
  study.scene = subject.scene.name;
  study.duration = subject.interval * subject.times;
  study.states = request.states;
  study.spread = request.spread;
  study.rate = request.rate;
  const std::vector<double> steps = ladder(request, subject.interval, subject.times);
  const std::vector<Motion> exact =
      reference(subject, *std::min_element(steps.begin(), steps.end()), study);
  trace(fmt::format("reference: agreement {:.1e}", study.reference_agreement));
  std::vector<std::string> integrators = request.integrators;
  if (integrators.empty()) {
    integrators = {"semi-implicit-euler", "rk4", "dopri5-fixed"};
  }
  for (const std::string& integrator : integrators) {
    for (const accuracy::State state : accuracy::kStates) {
      if (state == accuracy::State::kCompensated && integrator == "sdirk2") {
        continue;  // which is not made
      }
      for (const double step : steps) {
        Outcome outcome;
        outcome.setting = {state, integrator, step};
        model::Scene scene = stepped(subject.scene, integrator, step);
        scene.stepping.compensated = state == accuracy::State::kCompensated;
        const bool twice = state == accuracy::State::kDouble;
        const std::vector<Motion> motions = subject.motions(
            scene, twice ? emit::Scalar::kDouble : emit::Scalar::kFloat, &outcome.step_cost);
        for (std::size_t k = 0; k < motions.size(); ++k) {
          outcome.joint_errors.push_back(distance(motions[k], exact[k]));
          outcome.status |= motions[k].status;
        }
        trace(fmt::format("{}: {:.2e}", accuracy::text_of(outcome.setting), outcome.error()));
        study.outcomes.push_back(std::move(outcome));
      }
    }
  }
  return study;
}

std::string write_accuracy(const AccuracyRequest& request, const accuracy::Study& study) {
  std::vector<const accuracy::Core*> on;
  for (const std::string& name : request.on) {
    on.push_back(accuracy::find_core(name));
  }
  std::string text = accuracy::report_text(study, on);
  for (const accuracy::Core* core : request.target ? on : std::vector<const accuracy::Core*>{}) {
    text += accuracy::choice_text(study, *core, *request.target);
  }
  if (!request.output.empty()) {
    const std::string stem =
        (std::filesystem::path(request.output) / (to_identifier(study.scene) + "_accuracy"))
            .string();
    std::vector<OutputFile> files = {{stem + ".csv", accuracy::report_csv(study)},
                                     {stem + ".json", accuracy::report_json(study)},
                                     {stem + ".html", accuracy::report_page(study, on)},
                                     {stem + ".svg", accuracy::step_chart(study)}};
    for (const accuracy::Core* core : request.target ? on : std::vector<const accuracy::Core*>{}) {
      if (const auto chosen = accuracy::cheapest(study, *core, *request.target)) {
        files.push_back({fmt::format("{}_{}.toml", stem, core->name),
                         accuracy::settings_text(study.outcomes[*chosen].setting)});
      }
    }
    write_files(files);
  }
  return text;
}

}  // namespace treedyn
