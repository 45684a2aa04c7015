#include "accuracy/study.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include <fmt/format.h>

namespace treedyn::accuracy {

namespace {

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) {
    result =
        std::isfinite(value) ? std::max(result, value) : std::numeric_limits<double>::infinity();
  }
  return result;
}

}  // namespace

const char* name_of(State state) {
  switch (state) {
    case State::kFloat:
      break;
    case State::kCompensated:
      return "float compensated";
    case State::kDouble:
      return "double";
  }
  return "float";
}

std::string text_of(const Variant& variant) {
  const Variant usual;
  std::string result;
  const auto add = [&](const char* name, const std::string& value, const std::string& otherwise) {
    result += value == otherwise ? "" : fmt::format(" {}={}", name, value);
  };
  add("sincos", variant.sincos, usual.sincos);
  add("forward-dynamics", variant.forward_dynamics, usual.forward_dynamics);
  add("stabilisation", variant.stabilisation, usual.stabilisation);
  add("cuts", variant.cuts, usual.cuts);
  add("without", variant.without, usual.without);
  return result;
}

std::string text_of(const Setting& setting) {
  return fmt::format("{} {} {}{}", name_of(setting.state), setting.integrator, setting.step,
                     text_of(setting.variant));
}

std::string method_of(const Setting& setting) {
  return setting.integrator + text_of(setting.variant);
}

bool Outcome::failed() const {
  return !has(Error::kJoints) || !std::isfinite(error(Error::kJoints));
}

double Outcome::error(Error of) const { return largest(errors.at(of)); }

double Outcome::least(Error of) const {
  const std::vector<double>& values = errors.at(of);
  return *std::ranges::min_element(values);
}

bool Reference::refuted() const {
  // what initial states and places of constraints, given in ten digits, may make of a motion
  constexpr double kDigits = 1e-9;
  return !check.empty() && !(check_difference <= 10 * (check_error + agreement + kDigits));
}

double Reference::uncertainty(Error of) const {
  if (of == Error::kJoints) {
    return refuted() ? std::max(agreement, check_difference) : agreement;
  }
  const auto found = differences.find(of);
  return refuted()                    ? std::numeric_limits<double>::infinity()
         : found == differences.end() ? 0
                                      : found->second;
}

std::vector<Error> errors_of(const Study& study) {
  std::vector<Error> result;
  for (const ErrorRow& row : kErrors) {
    if (std::ranges::any_of(study.outcomes,
                            [&](const Outcome& outcome) { return outcome.has(row.error); })) {
      result.push_back(row.error);
    }
  }
  return result;
}

double Outcome::expected(Error of) const {
  const std::vector<double>& values = errors.at(of);
  const double most = largest(values);
  const auto n = static_cast<double>(values.size());
  if (values.size() < 2 || !std::isfinite(most) || least(of) <= 0) {
    return most;
  }
  double mean = 0;
  double squares = 0;
  for (const double value : values) {
    mean += std::log(value) / n;
  }
  for (const double value : values) {
    squares += (std::log(value) - mean) * (std::log(value) - mean);
  }
  // in double: long double is that of another machine under valgrind
  using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  const double t =
      boost::math::quantile(boost::math::students_t_distribution<double, Policy>(n - 1), 0.95);
  return std::max(most, std::exp(mean + t * std::sqrt(squares / (n - 1) * (1 + 1 / n))));
}

std::size_t PhaseSteps::kinds() const {
  return std::min(repeated_costs.size(), count.repeated.size());  // none where no step was counted
}

template <class Of>
double Outcome::mean(Of of) const {
  double sum = 0;
  double steps = 0;
  for (const PhaseSteps& phase : phases) {
    const program::StepCount& count = phase.count;
    sum += static_cast<double>(count.steps) * of(phase.cost);
    for (std::size_t what = 0; what < phase.kinds(); ++what) {
      sum += static_cast<double>(count.repeated[what]) * of(phase.repeated_costs[what]);
    }
    steps += static_cast<double>(count.steps);
  }
  return sum / std::max(steps, 1.0);
}

program::Cost Outcome::step_cost() const {
  constexpr int program::Cost::*kCounts[] = {
      &program::Cost::add, &program::Cost::mul, &program::Cost::div,  &program::Cost::sqrt,
      &program::Cost::sin, &program::Cost::cos, &program::Cost::fused};
  program::Cost result;
  for (int program::Cost::*const count : kCounts) {
    const double of_step = mean([count](const program::Cost& cost) { return cost.*count; });
    result.*count = static_cast<int>(std::lround(of_step));
  }
  return result;
}

double Outcome::cycles_of(const program::Cost& cost, const Core& core, bool contracted) const {
  return cycles(cost, core,
                {.is_float = setting.state != State::kDouble,
                 .libm = setting.variant.sincos == "libm",
                 .contracted = contracted});
}

double Outcome::most_cycles(const Core& core) const {
  double result = 0;
  for (const PhaseSteps& phase : phases) {
    double dearest = cycles_of(phase.cost, core);
    for (std::size_t what = 0; what < phase.kinds(); ++what) {
      dearest +=
          static_cast<double>(phase.count.most[what]) * cycles_of(phase.repeated_costs[what], core);
    }
    result = std::max(result, phase.count.steps > 0 ? dearest : 0);
  }
  return result;
}

double Outcome::cycles_per_second(const Core& core, bool contracted) const {
  return mean([&](const program::Cost& cost) { return cycles_of(cost, core, contracted); }) /
         setting.step;
}

namespace {

/// Numbers of the outcomes by rising cost, of those that cost the same by rising error.
std::vector<std::size_t> by_cost(const Study& study, const Core& core) {
  std::vector<std::size_t> order(study.outcomes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t k) {
    const Outcome& outcome = study.outcomes[k];
    return std::pair(outcome.cycles_per_second(core), outcome.failed()
                                                          ? std::numeric_limits<double>::infinity()
                                                          : outcome.error(study.error));
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

/// True if an outcome is expected to be off by at most `target` in 19 of 20 other initial states
/// too, even if the uncertainty of the reference is added.
bool reaches(const Study& study, const Outcome& outcome, double target) {
  return !outcome.failed() &&
         outcome.expected(study.error) + study.reference.uncertainty(study.error) <= target;
}

}  // namespace

std::vector<std::size_t> pareto(const Study& study, const Core& core) {
  std::vector<std::size_t> result;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t k : by_cost(study, core)) {
    const Outcome& outcome = study.outcomes[k];
    if (!outcome.failed() && outcome.error(study.error) < best) {
      best = outcome.error(study.error);
      result.push_back(k);
    }
  }
  return result;
}

std::vector<Sensitive> sensitive_states(const Study& study) {
  constexpr double kMany = 100;
  std::map<int, Sensitive> found;
  for (const Outcome& outcome : study.outcomes) {
    if (outcome.failed() || study.states < 3) {
      continue;
    }
    const std::vector<double>& values = outcome.errors.at(study.error);
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    const double median = sorted[sorted.size() / 2];
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!(values[k] > kMany * median)) {
        continue;
      }
      Sensitive& state = found[static_cast<int>(k) + 1];
      ++state.settings;
      if (state.settings == 1 || values[k] / median > state.error / state.median) {
        state = {static_cast<int>(k) + 1, state.settings, outcome.setting, values[k], median};
      }
    }
  }
  std::vector<Sensitive> result;
  for (const auto& [number, state] : found) {
    result.push_back(state);
  }
  return result;
}

bool fits(const Study& study, const Core& core, const Outcome& outcome) {
  if (!study.limits.flash && !study.limits.stack) {
    return true;
  }
  const auto size = outcome.sizes.find(std::string(core.name));
  return size != outcome.sizes.end() &&
         size->second.flash <= study.limits.flash.value_or(size->second.flash) &&
         size->second.stack <= study.limits.stack.value_or(size->second.stack);
}

std::optional<std::size_t> cheapest(const Study& study, const Core& core, double target) {
  const std::vector<std::size_t> order = by_cost(study, core);
  const auto found = std::ranges::find_if(order, [&](std::size_t k) {
    const Outcome& outcome = study.outcomes[k];
    return reaches(study, outcome, target) && fits(study, core, outcome);
  });
  return found == order.end() ? std::nullopt : std::optional(*found);
}

std::optional<std::size_t> most_accurate(const Study& study, const Core& core) {
  std::optional<std::size_t> result;
  for (std::size_t k = 0; k < study.outcomes.size(); ++k) {
    const Outcome& outcome = study.outcomes[k];
    if (!outcome.failed() && fits(study, core, outcome) &&
        (!result || outcome.error(study.error) < study.outcomes[*result].error(study.error))) {
      result = k;
    }
  }
  return result;
}

namespace {

using LogPoints = std::span<const std::pair<double, double>>;

/// By least squares.
double slope_of(LogPoints points) {
  const auto n = static_cast<double>(points.size());
  double x = 0;
  double y = 0;
  for (const auto& [h, e] : points) {
    x += h / n;
    y += e / n;
  }
  double xy = 0;
  double xx = 0;
  for (const auto& [h, e] : points) {
    xy += (h - x) * (e - y);
    xx += (h - x) * (h - x);
  }
  return xy / xx;
}

/// True if from each point to the next it rises as all do.
bool is_straight(LogPoints points) {
  constexpr double kSameOrder = 0.25;
  const double slope = slope_of(points);
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (!(std::abs(slope_of(points.subspan(k - 1, 2)) - slope) <= kSameOrder)) {
      return false;  // terms of several orders
    }
  }
  return true;
}

}  // namespace

std::optional<double> fitted_order(const Study& study, State state, const std::string& method) {
  constexpr std::size_t kLeast = 3;
  std::vector<std::pair<double, double>> points;  // by rising step
  const std::optional<Floor> floor = floor_of(study, state);
  for (const Outcome& outcome : study.outcomes) {
    if (outcome.setting.state != state || outcome.failed() ||
        method_of(outcome.setting) != method) {
      continue;
    }
    const double error = outcome.error(study.error);
    if (error > 0 && error >= 100 * floor->error && error <= 1e-3) {
      points.emplace_back(std::log(outcome.setting.step), std::log(error));
    }
  }
  std::ranges::sort(points);
  std::optional<double> order;
  for (std::size_t n = kLeast; n <= points.size(); ++n) {
    const LogPoints shortest = LogPoints(points).first(n);
    if (!is_straight(shortest)) {
      break;
    }
    order = slope_of(shortest);
  }
  return order;
}

namespace {

/// True if a step shorter than that of the floor has been tried, or the last shortening gained less
/// than a method of order one does.
bool gains_nothing(const Study& study, const Floor& floor) {
  double longer = std::numeric_limits<double>::infinity();  // the next step above
  double its_error = 0;
  for (const Outcome& outcome : study.outcomes) {
    const Setting& setting = outcome.setting;
    if (setting.state != floor.setting.state || method_of(setting) != method_of(floor.setting)) {
      continue;
    }
    if (setting.step < floor.setting.step) {
      return true;
    }
    if (setting.step > floor.setting.step && setting.step < longer && !outcome.failed()) {
      longer = setting.step;
      its_error = outcome.error(study.error);
    }
  }
  return floor.error * longer > its_error * floor.setting.step && std::isfinite(longer);
}

/// Of the outcomes whose setting is picked.
template <class Picks>
std::optional<Floor> smallest(const Study& study, Picks picks) {
  std::optional<Floor> result;
  for (const Outcome& outcome : study.outcomes) {
    if (picks(outcome.setting) && !outcome.failed() &&
        (!result || outcome.error(study.error) < result->error)) {
      result = Floor{outcome.error(study.error), outcome.setting};
    }
  }
  if (result) {
    result->is_reached = gains_nothing(study, *result);
  }
  return result;
}

}  // namespace

std::optional<Floor> floor_of(const Study& study, State state) {
  return smallest(study, [&](const Setting& setting) { return setting.state == state; });
}

std::optional<Floor> event_floor(const Study& study) {
  return smallest(study, [](const Setting& setting) { return setting.variant.cuts == "0"; });
}

}  // namespace treedyn::accuracy
