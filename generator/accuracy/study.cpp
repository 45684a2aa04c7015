#include "accuracy/study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

std::string text_of(const Setting& setting) {
  return fmt::format("{} {} {}", name_of(setting.state), setting.integrator, setting.step);
}

bool Outcome::failed() const {
  return joint_errors.empty() || !std::isfinite(largest(joint_errors));
}

double Outcome::error() const { return largest(joint_errors); }

double Outcome::least() const {
  return *std::min_element(joint_errors.begin(), joint_errors.end());
}

double Outcome::energy_error() const { return largest(energy_errors); }

bool Reference::refuted() const {
  // what initial states and places of constraints, given in ten digits, may make of a motion
  constexpr double kDigits = 1e-9;
  return !check.empty() && !(check_difference <= 10 * (check_error + agreement + kDigits));
}

double Reference::uncertainty() const {
  return refuted() ? std::max(agreement, check_difference) : agreement;
}

double Outcome::cycles_per_second(const Core& core) const {
  return cycles(step_cost, core, setting.state != State::kDouble) / setting.step;
}

std::vector<std::size_t> pareto(const Study& study, const Core& core) {
  std::vector<std::size_t> order(study.outcomes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto cost = [&](std::size_t k) {
    return study.outcomes[k].cycles_per_second(core);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(cost(a), study.outcomes[a].error()) <
           std::pair(cost(b), study.outcomes[b].error());
  });
  std::vector<std::size_t> result;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t k : order) {
    if (!study.outcomes[k].failed() && study.outcomes[k].error() < best) {
      best = study.outcomes[k].error();
      result.push_back(k);
    }
  }
  return result;
}

namespace {

bool outcome_reaches(const Study& study, const Outcome& outcome, double target) {
  return outcome.error() + study.reference.uncertainty() <= target;
}

}  // namespace

bool reaches(const Study& study, double target) {
  return std::any_of(study.outcomes.begin(), study.outcomes.end(), [&](const Outcome& outcome) {
    return !outcome.failed() && outcome_reaches(study, outcome, target);
  });
}

std::optional<std::size_t> cheapest(const Study& study, const Core& core, double target) {
  const std::vector<std::size_t> front = pareto(study, core);
  const auto found = std::find_if(front.begin(), front.end(), [&](std::size_t k) {
    return outcome_reaches(study, study.outcomes[k], target);
  });
  return found == front.end() ? std::nullopt : std::optional(*found);
}

std::size_t most_accurate(const Study& study) {
  const auto found =
      std::min_element(study.outcomes.begin(), study.outcomes.end(),
                       [](const Outcome& a, const Outcome& b) { return a.error() < b.error(); });
  return static_cast<std::size_t>(found - study.outcomes.begin());
}

std::optional<double> fitted_order(const Study& study, State state, const std::string& integrator) {
  std::vector<std::pair<double, double>> points;
  double least = std::numeric_limits<double>::infinity();
  for (const Outcome& outcome : study.outcomes) {
    if (outcome.setting.state == state && !outcome.failed()) {
      least = std::min(least, outcome.error());
    }
  }
  for (const Outcome& outcome : study.outcomes) {
    const bool belongs = outcome.setting.state == state && !outcome.failed() &&
                         outcome.setting.integrator == integrator;
    if (belongs && outcome.error() >= 100 * least && outcome.error() <= 1e-3) {
      points.emplace_back(std::log(outcome.setting.step), std::log(outcome.error()));
    }
  }
  if (points.size() < 2) {
    return std::nullopt;
  }
  double x = 0;
  double y = 0;
  for (const auto& [h, e] : points) {
    x += h / static_cast<double>(points.size());
    y += e / static_cast<double>(points.size());
  }
  double xy = 0;
  double xx = 0;
  for (const auto& [h, e] : points) {
    xy += (h - x) * (e - y);
    xx += (h - x) * (h - x);
  }
  return xy / xx;
}

std::optional<Floor> floor_of(const Study& study, State state) {
  std::optional<Floor> result;
  for (const Outcome& outcome : study.outcomes) {
    if (outcome.setting.state == state && !outcome.failed() &&
        (!result || outcome.error() < result->error)) {
      result = Floor{outcome.error(), outcome.setting};
    }
  }
  return result;
}

}  // namespace treedyn::accuracy
