#include "cli/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "accuracy/chart.hpp"
#include "accuracy/report.hpp"
#include "cli/motions.hpp"
#include "common/identifier.hpp"
#include "description/scene_reader.hpp"
#include "dynamics/scene_dynamics.hpp"
#include "formulate/scene_loops.hpp"
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
/// Operations of a reference at most: half a minute.
constexpr double kReferenceWork = 2e10;
/// Errors of a step of the check.
constexpr double kCheckTolerances[] = {1e-13, 1e-10, 1e-7};

double largest_distance(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, distance(a[k].q, b[k].q));
  }
  return largest;
}

/// True if generated steps draw a loop to where the scene begins.
bool has_placed_loop(const Subject& subject) {
  Stepped how;
  how.integrator = "rk4";
  model::Scene scene = stepped_scene(subject, how);
  formulate::settle_loops(scene);
  return std::any_of(scene.constraints.begin(), scene.constraints.end(),
                     [](const model::Constraint& c) { return c.loop && !c.loop->empty(); });
}

/// The scene's own initial state and others within `spread`, moved onto the constraints.
std::vector<Start> band(const AccuracyRequest& request, const Subject& subject) {
  const model::Scene& scene = subject.scene;
  const bool speeds_only = has_placed_loop(subject);
  std::vector<Start> result;
  program::Random random(1);
  const std::unique_ptr<simulation::Dynamics> dynamics = program_dynamics(scene);
  for (int k = 0; k < request.states; ++k) {
    model::Scene other = scene;
    const auto move = [&](Real& x) {
      x += Real(request.spread * random.symmetric()) * std::max(Real(abs(x)), Real("0.1"));
    };
    if (k > 0) {
      if (!speeds_only) {
        std::for_each(other.q0.begin(), other.q0.end(), move);
      }
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

/// Steps between two comparisons with which the references stay below kReferenceWork.
long reference_parts(const Subject& subject, const program::Cost& step) {
  const double work = static_cast<double>(subject.starts.size()) * step.total();
  const double steps = std::min(kMostSteps, kReferenceWork / work);
  return std::max(1L, std::lround(steps / subject.times));
}

/// The generated steps of order five and four in the longest scalar of the host.
std::vector<Motion> reference(const Subject& subject, StepWriter& writer, Study& study) {
  Stepped how{"dopri5-fixed", 1, emit::Scalar::kExtended, false};
  const auto files = [&] {
    return writer.files(stepped_scene(subject, how), how.scalar);
  };
  how.parts = reference_parts(subject, files().cost);
  const std::vector<Motion> exact = stepped_motions(subject, how, files());
  how.integrator = "rk4";
  const std::vector<Motion> second = stepped_motions(subject, how, files());
  study.reference.agreement = largest_distance(exact, second);
  study.reference.methods =
      fmt::format("the generated dopri5-fixed and rk4 of {:.2g} s in long double, {} bits",
                  static_cast<double>(subject.interval) / static_cast<double>(how.parts),
                  std::numeric_limits<long double>::digits);
  return exact;
}

/// `simulate`, as precisely as its steps get through.
void check(const Subject& subject, const std::vector<Motion>& exact, Study& study) {
  for (const double tolerance : kCheckTolerances) {
    try {
      const std::vector<Motion> motions = simulated_motions(subject, tolerance);
      study.reference.check_difference = largest_distance(exact, motions);
      study.reference.check_error =
          largest_distance(motions, simulated_motions(subject, 10 * tolerance));
      study.reference.check = fmt::format("simulate, fehlberg78 to {:.0e},", tolerance);
      return;
    } catch (const std::runtime_error&) {  // steps that hardly advance time
    }
  }
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
  const double interval = decade * (rough >= 5 * decade ? 5 : rough >= 2 * decade ? 2 : 1);
  subject.interval = Real(fmt::format("{:.3g}", interval));
  subject.times = static_cast<int>(std::floor(duration / interval * (1 + 1e-12)));
  try {
    subject.starts = band(request, subject);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& problem) {
    throw InputError({request.scene, 0, 0}, fmt::format("{}; expected a motion", problem.what()));
  }
  return subject;
}

/// What the references say, and how far settings are off.
class Comparison {
 public:
  /// \pre `subject` outlives it
  Comparison(const Subject& subject, std::vector<Motion> exact)
      : subject_(subject), exact_(std::move(exact)), energies_(subject.scene) {
    for (const Motion& motion : exact_) {
      exact_energies_.push_back(energies_.of(motion));
    }
  }

  Outcome outcome(const Setting& setting, StepWriter& writer) {
    Stepped how;
    how.integrator = setting.integrator;
    how.parts = std::lround(static_cast<double>(subject_.interval) / setting.step);
    how.compensated = setting.state == accuracy::State::kCompensated;
    how.scalar =
        setting.state == accuracy::State::kDouble ? emit::Scalar::kDouble : emit::Scalar::kFloat;
    const StepFiles files = writer.files(stepped_scene(subject_, how), how.scalar);
    const std::vector<Motion> motions = stepped_motions(subject_, how, files);
    Outcome result;
    result.setting = setting;
    result.step_cost = files.cost;
    for (std::size_t k = 0; k < motions.size(); ++k) {
      result.joint_errors.push_back(distance(motions[k].q, exact_[k].q));
      result.energy_errors.push_back(distance(energies_.of(motions[k]), exact_energies_[k]));
      result.status |= motions[k].status;
    }
    return result;
  }

 private:
  const Subject& subject_;
  std::vector<Motion> exact_;
  Energies energies_;
  std::vector<Values> exact_energies_;
};

}  // namespace

accuracy::Study study_accuracy(const AccuracyRequest& request, const AccuracyTrace& trace) {
  const Subject subject = subject_of(request);
  const auto interval = static_cast<double>(subject.interval);
  Study study;
  study.scene = subject.scene.name;
  study.duration = subject.duration();
  study.states = request.states;
  study.spread = request.spread;
  study.speeds_only = has_placed_loop(subject);
  study.rate = request.rate;
  const std::vector<double> steps = ladder(request, interval, subject.times);
  StepWriter writer(subject.file);
  const std::vector<Motion> exact = reference(subject, writer, study);
  trace(fmt::format("reference: agreement {:.1e}", study.reference.agreement));
  check(subject, exact, study);
  trace(fmt::format("check: {:.1e}", study.reference.check_difference));
  Comparison comparison(subject, exact);
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
        study.outcomes.push_back(comparison.outcome({state, integrator, step}, writer));
        const Outcome& outcome = study.outcomes.back();
        trace(fmt::format("{}: {:.2e}", accuracy::text_of(outcome.setting), outcome.error()));
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
