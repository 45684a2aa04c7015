#include "cli/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "accuracy/chart.hpp"
#include "accuracy/report.hpp"
#include "cli/comparison.hpp"
#include "cli/simulate.hpp"
#include "cli/step_sizes.hpp"
#include "cli/study_parts.hpp"
#include "common/identifier.hpp"
#include "common/transformed.hpp"
#include "description/scene_reader.hpp"
#include "dynamics/scene_dynamics.hpp"
#include "formulate/scene_loops.hpp"
#include "program/random.hpp"
#include "simulation/simulator.hpp"
#include "system/files.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

using accuracy::Outcome;
using accuracy::Study;

/// The scene's motion is compared at this many times.
constexpr int kTimes = 50;
/// Times at which stability limits are looked for, and the motion that leads there.
constexpr int kLimits = 20;
constexpr double kLimitTolerance = 1e-6;
/// Steps of a ladder: the longest and the shortest as parts of the time between two comparisons.
constexpr double kLadder[] = {1, 2, 5, 10, 20, 50, 100, 200, 500};

/// True if generated steps draw a loop to where the scene begins.
bool has_placed_loop(const Subject& subject) {
  Stepped how;
  how.integrator = "rk4";
  model::Scene scene = stepped_scene(subject, how);
  formulate::settle_loops(scene);
  return std::ranges::any_of(scene.constraints,
                             [](const model::Constraint& c) { return c.loop && !c.loop->empty(); });
}

/// From the scene's own initial state and from others within `spread`, moved onto the constraints.
void begin_in_band(const AccuracyRequest& request, Subject& subject) {
  const model::Scene& scene = subject.scene;
  const bool speeds_only = has_placed_loop(subject);
  std::vector<Start>& result = subject.starts;
  program::Random random(1);
  for (int k = 0; k < request.states; ++k) {
    model::Scene other = scene;
    const auto move = [&](Real& x) {
      x += Real(request.spread * random.symmetric()) * std::max(Real(abs(x)), Real("0.1"));
    };
    if (k > 0) {
      if (!speeds_only) {
        std::ranges::for_each(other.q0, move);
      }
      std::ranges::for_each(other.qd0, move);
    }
    simulation::Simulator simulator(other, *subject.dynamics, {});
    const std::array<simulation::Move, 2> moved = simulator.settle();
    if (k == 0) {
      subject.moved = moved;
    }
    result.push_back({simulator.q(), simulator.qd()});
    if (scene.constraints.empty()) {  // an initial state that float holds is no error of the step
      result.back().q = result.back().q.cast<float>().cast<double>();
      result.back().qd = result.back().qd.cast<float>().cast<double>();
    }
  }
}

bool divides(double step, double time) {
  return std::abs(std::round(time / step) * step - time) <= 1e-9 * time;
}

/// \throws UsageError if no whole number of steps makes `time`
void require_part(double step, double time, const std::string& what) {
  if (!divides(step, time)) {
    throw UsageError(fmt::format("step {} s does not divide {} s, {}", step, time, what));
  }
}

/// Falling steps: those that were asked for, else parts of the controller's period or of the time
/// between comparisons.
std::vector<double> ladder(const AccuracyRequest& request, double interval, int times) {
  std::vector<double> result = request.steps;
  const double longest = request.rate ? 1 / *request.rate : interval;
  if (request.steps.empty() && !divides(longest, interval)) {
    throw UsageError(fmt::format(
        "--rate {}: its period does not divide {} s, the time between comparisons; expected a "
        "multiple of {:.6g} Hz",
        *request.rate, interval, 1 / interval));
  }
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
    if (times * interval > kMostSteps * step * (1 + 1e-9)) {
      throw UsageError(fmt::format("--steps {}: {} s need more than {} steps; expected longer ones",
                                   step, times * interval, kMostSteps));
    }
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
  subject.dynamics = program_dynamics(subject.scene);
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
    begin_in_band(request, subject);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& problem) {
    throw InputError({request.scene, 0, 0}, fmt::format("{}; expected a motion", problem.what()));
  }
  return subject;
}

/// The points whose places are compared.
std::vector<model::Point> points_of(const AccuracyRequest& request, const model::Scene& scene) {
  if (request.points) {
    return description::resolve_points(scene.tree, *request.points);
  }
  return scene.points.empty() ? scene.tree.points : scene.points;
}

/// \throws UsageError if the scene has no such error
void require_error(const AccuracyRequest& request, const Study& study) {
  if (study.reference.differences.contains(study.error)) {
    return;
  }
  std::vector<std::string_view> there;
  for (const accuracy::ErrorRow& row : accuracy::kErrors) {
    if (study.reference.differences.contains(row.error)) {
      there.push_back(row.name);
    }
  }
  throw UsageError(fmt::format("--error: the scene has no {}; expected {}", request.error,
                               fmt::join(there, ", ")));
}

/// The processors whose sizes are asked for. \throws InputError if they cannot be measured
/// \throws UsageError for limits of one that has none
std::vector<const accuracy::Core*> sized_cores(const AccuracyRequest& request) {
  const bool limited = request.limits.flash || request.limits.stack;
  std::vector<const accuracy::Core*> result;
  for (const std::string& name : request.on) {
    const accuracy::Core* const core = accuracy::find_core(name);
    if (limited && !core->has_flash()) {
      throw UsageError(
          "--flash, --stack: limits of processors with flash; expected --on with m0plus, m4f, m33 "
          "or m7");
    }
    if ((limited || request.sizes) && core->has_flash()) {
      result.push_back(core);
    }
  }
  if (limited && !request.target) {
    throw UsageError("--flash, --stack: limits of a choice; expected --target");
  }
  if (request.sizes && result.empty()) {
    throw UsageError("--sizes: no processor with flash; expected --on with m0plus, m4f, m33 or m7");
  }
  if (!result.empty()) {
    require_cross_compiler();
  }
  return result;
}

/// Of the methods that are studied the least at some times of the motion.
std::vector<accuracy::StepLimit> stability_of(const Subject& subject,
                                              const std::vector<std::string>& integrators) {
  simulation::Settings how;
  how.tolerance = kLimitTolerance;
  simulation::Simulator simulator(subject.scene, *subject.dynamics, how);
  simulator.settle();
  std::map<std::string, double> least;
  const auto t0 = static_cast<double>(subject.scene.t0);
  for (int k = 0; k < kLimits; ++k) {
    try {
      simulator.advance_to(t0 + subject.duration() * k / kLimits, [] { return true; });
    } catch (const std::runtime_error&) {  // the motion ends: as far as it goes
      break;
    }
    for (const simulation::StabilityLimit& limit : simulator.stability(*subject.dynamics).limits) {
      if (limit.step) {
        const auto [known, is_new] = least.try_emplace(limit.integrator, *limit.step);
        known->second = std::min(known->second, *limit.step);
      }
    }
  }
  std::vector<accuracy::StepLimit> result;
  for (const std::string& integrator : integrators) {
    if (const auto found = least.find(integrator); found != least.end()) {
      result.push_back({integrator, found->second});
    }
  }
  return result;
}

/// What the options say of the scene.
Study study_of(const AccuracyRequest& request, const Subject& subject) {
  Study study;
  study.scene = subject.scene.name;
  study.duration = subject.duration();
  study.states = request.states;
  study.spread = request.spread;
  study.cuts = subject.scene.stepping.cuts;
  study.speeds_only = has_placed_loop(subject);
  study.rate = request.rate;
  study.limits = request.limits;
  for (const accuracy::ErrorRow& row : accuracy::kErrors) {
    study.error = row.name == request.error ? row.error : study.error;
  }
  return study;
}

/// What there are steps in; of sdirk2 no compensated ones are made.
bool is_made(accuracy::State state, const std::string& integrator) {
  return state != accuracy::State::kCompensated || integrator != "sdirk2";
}

/// By scalar, falling step.
void add_settings(const std::string& integrator, const accuracy::Variant& variant,
                  const std::vector<double>& steps, std::vector<accuracy::Setting>& settings) {
  for (const accuracy::State state : accuracy::kStates) {
    if (is_made(state, integrator)) {
      for (const double step : steps) {
        settings.push_back({state, integrator, step, variant});
      }
    }
  }
}

/// By method, scalar, falling step.
std::vector<accuracy::Setting> settings_of(const std::vector<std::string>& integrators,
                                           const std::vector<accuracy::Variant>& variants,
                                           const std::vector<double>& steps) {
  std::vector<accuracy::Setting> result;
  for (const std::string& integrator : integrators) {
    for (const accuracy::Variant& variant : variants) {
      add_settings(integrator, variant, steps, result);
    }
  }
  return result;
}

/// All that the numbers of a study follow from.
std::string identity(const Study& study, const Subject& subject,
                     const std::vector<accuracy::Setting>& settings,
                     const std::vector<const accuracy::Core*>& sized) {
  std::string text =
      fmt::format("treedyn {}, repetitions\n{} states within {} {}\npoints {}\n", kVersion,
                  study.states, study.spread, study.speeds_only, fmt::join(study.points, " "));
  for (const std::string& file : {subject.file, subject.scene.tree_file}) {
    text += file.empty() ? "" : read_file(file).value_or("") + '\n';
  }
  for (const accuracy::Setting& setting : settings) {
    text += accuracy::text_of(setting) + '\n';
  }
  for (const accuracy::Core* const core : sized) {
    text += fmt::format("sizes on {}\n", core->name);
  }
  return text;
}

/// Takes the reference and its check from the parts. \return false if they are not there
bool take_reference(const AccuracyRequest& request, const StudyParts& parts, Comparison& comparison,
                    Study& study) {
  if (std::optional<KnownReference> known = parts.reference()) {
    study.reference = known->reference;
    comparison.set_reference(std::move(known->exact));
    require_error(request, study);
    return true;
  }
  if (request.joined) {
    throw InputError({request.parts, 0, 0},
                     "the reference is not there; expected the folder of a plan");
  }
  return false;
}

/// The reference and its check.
KnownReference make_reference(const AccuracyRequest& request, const Subject& subject,
                              const AccuracyTrace& trace, Comparison& comparison,
                              StepWriter& writer, Study& study) {
  const std::vector<Motion> exact = reference(subject, comparison, writer, study);
  require_error(request, study);
  trace(fmt::format("reference: agreement {:.1e}", study.reference.agreement));
  check(subject, exact, study);
  trace(fmt::format("check: {:.1e}", study.reference.check_difference));
  return {study.reference, exact};
}

/// What the names of the study's files begin with.
std::string stem_of(const AccuracyRequest& request, const accuracy::Study& study) {
  return (std::filesystem::path(request.output) / (to_identifier(study.scene) + "_accuracy"))
      .string();
}

/// The folder beside the files that keeps parts until the files are there; empty: no files.
std::string own_parts(const AccuracyRequest& request, const accuracy::Study& study) {
  return request.output.empty() ? "" : stem_of(request, study) + ".parts";
}

/// Writes the commands of the settings that have no part yet.
void plan(const AccuracyRequest& request, const StudyParts& parts,
          const std::vector<accuracy::Setting>& settings) {
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < settings.size(); ++k) {
    if (!parts.outcome(k + 1, settings[k])) {
      left.push_back(k + 1);
    }
  }
  write_plan(request.plan, request.command, left);
}

/// The scene, once it is known that the folders of its study and plan may be written.
Subject begun(const AccuracyRequest& request, const Warn& warn) {
  if (!request.output.empty()) {
    check_folder(request.output);  // before hours of computing
  }
  if (!request.plan.empty()) {
    check_folder(std::filesystem::absolute(request.plan).parent_path().string());
  }
  Subject subject = subject_of(request);
  for (const simulation::Move& move : subject.moved) {
    if (const auto moved = warning_of_move(subject.scene, move); moved && !request.part) {
      warn({{request.scene, 0, 0}, *moved});
    }
  }
  return subject;
}

/// \throws UsageError for the number of a setting that the study has not
void require_setting(const AccuracyRequest& request,
                     const std::vector<accuracy::Setting>& settings) {
  if (request.part && (*request.part < 1 || *request.part > std::ssize(settings))) {
    throw UsageError(fmt::format("--part {}: the study has {} settings; expected 1 to {}",
                                 *request.part, settings.size(), settings.size()));
  }
}

}  // namespace

std::optional<accuracy::Study> study_accuracy(const AccuracyRequest& request,
                                              const AccuracyTrace& trace,
                                              const AccuracyProgress& progress, const Warn& warn) {
  const std::vector<const accuracy::Core*> sized = sized_cores(request);
  const Subject subject = begun(request, warn);
  Study study = study_of(request, subject);
  const std::vector<double> steps =
      ladder(request, static_cast<double>(subject.interval), subject.times);
  std::vector<std::string> integrators = request.integrators;
  if (integrators.empty()) {
    integrators = {"semi-implicit-euler", "rk4", "dopri5-fixed"};
  }
  study.stability = stability_of(subject, integrators);
  const std::vector<model::Point> points = points_of(request, subject.scene);
  for (const model::Point& point : points) {
    study.points.push_back(point.name);
  }
  StepWriter writer(subject.file);
  const std::vector<accuracy::Variant> variants =
      variants_of(request.axes, subject, integrators.front(), writer);
  const std::vector<accuracy::Setting> settings = settings_of(integrators, variants, steps);
  require_setting(request, settings);
  const std::string own = request.parts.empty() ? own_parts(request, study) : "";
  const StudyParts parts(
      own.empty() ? request.parts : own,
      identity(study, subject, settings, sized) + (request.time ? "timed\n" : ""),
      own.empty() ? StudyParts::Others::kRefused : StudyParts::Others::kReplaced);
  Comparison comparison(subject, points);
  if (!take_reference(request, parts, comparison, study)) {
    parts.keep(make_reference(request, subject, trace, comparison, writer, study));
  }
  if (!request.plan.empty()) {
    plan(request, parts, settings);
    return std::nullopt;
  }
  for (std::size_t number = 1; number <= settings.size(); ++number) {
    if (request.part && static_cast<long>(number) != *request.part) {
      continue;
    }
    const accuracy::Setting& setting = settings[number - 1];
    std::optional<Outcome> outcome = parts.outcome(number, setting);
    if (!outcome && request.joined) {
      throw InputError({request.parts, 0, 0},
                       fmt::format("setting {}, {}, is not there; expected all of {}", number,
                                   accuracy::text_of(setting), settings.size()));
    }
    if (!outcome) {
      outcome = comparison.outcome(setting, writer, sized, request.time);
      parts.keep(number, *outcome);
      trace(fmt::format("{}: {:.2e}", accuracy::text_of(setting), outcome->error(study.error)));
    }
    study.outcomes.push_back(std::move(*outcome));
    progress(static_cast<double>(number) / static_cast<double>(settings.size()));
  }
  return request.part ? std::nullopt : std::optional(std::move(study));
}

std::string write_accuracy(const AccuracyRequest& request, const accuracy::Study& study) {
  const std::vector<const accuracy::Core*> on = transformed(request.on, accuracy::find_core);
  const auto chosen_for = request.target ? on : std::vector<const accuracy::Core*>{};
  std::string text = accuracy::report_text(study, on);
  for (const accuracy::Core* core : chosen_for) {
    const std::string choice = accuracy::choice_text(study, *core, *request.target);
    text += text.find(choice) == std::string::npos ? choice : "";  // one refusal for all
  }
  if (!request.output.empty()) {
    const std::string stem = stem_of(request, study);
    std::vector<OutputFile> files = {{stem + ".csv", accuracy::report_csv(study)},
                                     {stem + ".json", accuracy::report_json(study)},
                                     {stem + ".html", accuracy::report_page(study, on)},
                                     {stem + ".svg", accuracy::step_chart(study)}};
    for (const accuracy::Core* core : chosen_for) {
      if (const auto chosen = accuracy::cheapest(study, *core, *request.target)) {
        files.push_back({fmt::format("{}_{}.toml", stem, core->name),
                         accuracy::settings_text(study, study.outcomes[*chosen].setting)});
      }
    }
    write_files(files);
    remove_parts(own_parts(request, study));
  }
  return text;
}

}  // namespace treedyn
