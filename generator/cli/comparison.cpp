#include "cli/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "cli/step_sizes.hpp"

namespace treedyn {

namespace {

using accuracy::Error;
using accuracy::Outcome;
using accuracy::Setting;
using accuracy::Study;

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

/// Steps between two comparisons with which the references stay below kReferenceWork.
long reference_parts(const Subject& subject, const program::Cost& step) {
  const double work = static_cast<double>(subject.starts.size()) * step.total();
  const double steps = std::min(kMostSteps, kReferenceWork / work);
  return std::max(1L, std::lround(steps / subject.times));
}

}  // namespace

Comparison::Comparison(const Subject& subject, std::vector<model::Point> points)
    : subject_(subject), points_(std::move(points)), energies_(subject) {
  const model::Scene& scene = subject.scene;
  const auto ends = [](const model::Phase& phase) {
    return !phase.until.empty();
  };
  happens_ = std::ranges::any_of(scene.phases, ends) || !scene.frictions.empty();
}

void Comparison::set_reference(std::vector<Motion> exact) {
  exact_ = std::move(exact);
  exact_energies_.clear();
  exact_places_.clear();
  slides_ = turns_ = false;
  for (const Motion& motion : exact_) {
    slides_ |= motion.off.length >= 0;
    turns_ |= motion.off.angle >= 0;
    exact_energies_.push_back(energies_.of(motion));
    exact_places_.push_back(places(subject_.scene, points_, motion));
  }
}

std::map<Error, std::vector<double>> Comparison::errors(const std::vector<Motion>& motions) {
  std::map<Error, std::vector<double>> result;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Motion& motion = motions[k];
    const double joints = distance(motion.q, exact_[k].q);
    result[Error::kJoints].push_back(joints);
    result[Error::kEnergy].push_back(distance(energies_.of(motion), exact_energies_[k]));
    const auto add = [&](bool there, Error error, double value) {
      if (there) {  // of a motion that ends nothing is known
        result[error].push_back(std::isfinite(joints) ? std::max(value, 0.0) : joints);
      }
    };
    add(slides_, Error::kDrift, motion.off.length);
    add(turns_, Error::kAngle, motion.off.angle);
    add(slides_, Error::kSpeed, motion.off.speed);
    add(turns_, Error::kRate, motion.off.rate);
    add(happens_, Error::kEvents, event_distance(motion, exact_[k], subject_.duration()));
    add(!points_.empty(), Error::kPoints,
        place_distance(places(subject_.scene, points_, motion), exact_places_[k]));
  }
  return result;
}

Outcome Comparison::outcome(const Setting& setting, StepWriter& writer,
                            const std::vector<const accuracy::Core*>& sized, bool timed) {
  Stepped how;
  how.integrator = setting.integrator;
  how.parts = std::lround(static_cast<double>(subject_.interval) / setting.step);
  how.compensated = setting.state == accuracy::State::kCompensated;
  how.scalar =
      setting.state == accuracy::State::kDouble ? emit::Scalar::kDouble : emit::Scalar::kFloat;
  how.variant = setting.variant;
  const StepFiles files = stepped_files(subject_, how, writer);
  const std::vector<Motion> motions = stepped_motions(subject_, how, files);
  Outcome result;
  result.setting = setting;
  for (const program::StepPhase& phase : files.stepper.phases) {
    result.phases.push_back({program::least_step_cost(files.stepper, phase),
                             program::repeated_costs(files.stepper, phase)});
  }
  for (const Motion& motion : motions) {
    for (std::size_t k = 0; k < motion.steps.size(); ++k) {
      result.phases[k].count += motion.steps[k];
    }
    result.status |= motion.status;
  }
  result.errors = errors(motions);
  for (const accuracy::Core* core : sized) {
    result.sizes[std::string(core->name)] =
        step_size(stepped_files(subject_, how, writer, false), *core);
  }
  if (timed) {
    result.time =
        step_seconds(subject_, how, stepped_files(subject_, how, writer, false)) / setting.step;
  }
  return result;
}

std::vector<Motion> reference(const Subject& subject, Comparison& comparison, StepWriter& writer,
                              Study& study) {
  Stepped how{"dopri5-fixed", 1, emit::Scalar::kExtended, false};
  const auto files = [&] {
    return stepped_files(subject, how, writer);
  };
  how.parts = reference_parts(subject, program::step_cost(files().stepper));
  std::vector<Motion> exact = stepped_motions(subject, how, files());
  comparison.set_reference(exact);
  how.integrator = "rk4";
  for (const auto& [error, values] : comparison.errors(stepped_motions(subject, how, files()))) {
    const bool is_compared = error == Error::kJoints || error == Error::kEnergy ||
                             error == Error::kEvents || error == Error::kPoints;
    study.reference.differences[error] = is_compared ? *std::ranges::max_element(values) : 0;
  }
  study.reference.agreement = study.reference.differences.at(Error::kJoints);
  study.reference.methods =
      fmt::format("the generated dopri5-fixed and rk4 of {:.2g} s in long double, {} bits",
                  static_cast<double>(subject.interval) / static_cast<double>(how.parts),
                  std::numeric_limits<long double>::digits);
  return exact;
}

void check(const Subject& subject, const std::vector<Motion>& exact, Study& study) {
  for (const double tolerance : kCheckTolerances) {
    try {
      std::string warning;
      const std::vector<Motion> motions = simulated_motions(subject, tolerance, warning);
      study.reference.check_difference = largest_distance(exact, motions);
      study.reference.check_error =
          largest_distance(motions, simulated_motions(subject, 10 * tolerance, warning));
      study.reference.check =
          fmt::format("simulate, fehlberg78 to {:.0e},{}", tolerance,
                      warning.empty() ? "" : fmt::format(" which warns ({}),", warning));
      return;
    } catch (const std::runtime_error&) {  // steps that hardly advance time
    }
  }
}

}  // namespace treedyn
