// How long a step may be.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "simulation/column_names.hpp"
#include "simulation/simulator.hpp"
#include "simulation/time_scale.hpp"

namespace treedyn::simulation {

namespace {

/// Factors of the step size: caution, and the largest changes at once.
constexpr double kCaution = 0.9;
constexpr double kLeastFactor = 0.2;
constexpr double kMostFactor = 5;
/// The first step as a part of 1/omega, where a small step has met a stiffness omega^2.
constexpr double kFirstTurn = 0.1;
/// What the change of velocity in a step may differ by from that of its polynomial, a part of it.
constexpr double kResolved = 1e-2;
/// How many times the tolerance an error across the rows may be, which the projection takes away.
constexpr double kAcross = 1e3;
/// A step below this many roundings of the time does not advance it.
constexpr double kRoundingsOfTime = 16;
/// How often a fixed step is halved when it does not lead anywhere.
constexpr int kHalvings = 20;

}  // namespace

double Simulator::error_ratio(double h) {
  if (!next_.allFinite() || !error_.allFinite()) {
    return std::numeric_limits<double>::infinity();
  }
  const Vector scale = 1 + y_.array().abs().max(next_.array().abs());
  const auto part = [&](const Vector& error) {
    return (error.array().abs() / scale.array()).maxCoeff();
  };
  double ratio = 0;
  if (settings_.drift == Drift::kProjection) {
    const Vector all = error_;
    system_.remove_normal(t_ + h, next_, error_);
    // what the projection corrects is no error, as long as what it disturbs is none
    ratio = part(all - error_) /
            std::min(kAcross * settings_.tolerance, std::sqrt(settings_.tolerance));
  }
  ratio = std::max(ratio, part(error_) / settings_.tolerance);
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

double least_step(double t) {
  return kRoundingsOfTime * std::numeric_limits<double>::epsilon() * std::fabs(t);
}

double Simulator::least_step() const { return simulation::least_step(t_); }

/// `next_` after a step of a method without error estimate. \return its length
double Simulator::fixed_step(double longest) {
  double h = longest;
  if (settings_.step < least_step()) {
    throw std::runtime_error(
        fmt::format("a step of {} s does not advance time at t = {} s", settings_.step, t_));
  }
  take(h);
  for (int k = 0; k < kHalvings && !next_.allFinite(); ++k) {  // an implicit one found no state
    h /= 2;
    ++cost_.rejected;
    take(h);
  }
  return h;
}

/// The first step, here or behind an event: Hairer, Norsett, Wanner, Solving Ordinary Differential
/// Equations I, II.4.
void Simulator::propose() {
  const double order = integrator_->error_order();
  const Vector scale = settings_.tolerance * (1 + y_.array().abs());
  const auto norm = [&](const Vector& x) {
    return (x.array() / scale.array()).matrix().lpNorm<Eigen::Infinity>();
  };
  Vector f0;
  Vector f1;
  rate(t_, y_, f0);
  const double d0 = norm(y_);
  const double d1 = norm(f0);
  const double h0 = d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1;
  rate(t_ + h0, y_ + h0 * f0, f1);
  const double d2 = std::max(d1, norm(f1 - f0) / h0);
  const double h1 = std::pow(0.01 / std::max(d2, 1e-300), 1 / (order + 1));
  suggested_ = std::min(100 * h0, std::isfinite(h1) ? h1 : h0);
  const Eigen::Index n = y_.size() / 2;
  const double moved = h0 * f0.head(n).norm() + h0 * h0 * f0.tail(n).norm();
  const double stiffness = (f1 - f0).tail(n).norm() / moved;
  if (stiffness > 0 && std::isfinite(stiffness)) {
    suggested_ = std::min(suggested_, kFirstTurn / std::sqrt(stiffness));
  }
  suggested_ = std::max(suggested_, 2 * least_step());
  powers_.clear();
  turns_.clear();
}

/// What the clock of forces and guards allows, and the turn of the joints if there are guards.
double Simulator::longest_step(double longest) {
  const Eigen::Index n = y_.size() / 2;
  const State now{t_, y_.head(n), y_.tail(n)};
  scale_ = longest;
  for (const model::Expression& expression : timed_) {
    scale_ = resolved_step(expression, now, scale_);
  }
  double turn = 0;
  for (const int k : turning_) {
    turn += std::fabs(y_[n + k]);
  }
  for (const Watch& watch : watches_) {
    if (watch.kind == Watch::Kind::kExpression && watch.event->value.uses(model::Quantity::kTime)) {
      scale_ = resolved_step(watch.event->value, now, scale_);
    }
  }
  scale_ = std::max(scale_, std::min(longest, least_step()));
  return watches_.empty() || turn * scale_ < kTurns * kTurn ? scale_ : kTurns * kTurn / turn;
}

/// A second opinion on a step whose error estimate is small, for that of Fehlberg sees neither what
/// depends on time alone nor a force that begins and ends inside the step: the velocity changes by
/// about what Simpson's rule says.
bool Simulator::is_resolved(double h) {
  const Eigen::Index n = y_.size() / 2;
  cost_.evaluations += 2;
  const Vector end = system_.accelerate(t_ + h, next_.head(n), next_.tail(n)).qdd;
  dense_.set(h, y_, qdd_, next_, end);
  const Vector middle = dense_.at(0.5);
  const Vector qdd = system_.accelerate(t_ + h / 2, middle.head(n), middle.tail(n)).qdd;
  const Vector change = h / 6 * (qdd_ + 4 * qdd + end);
  const auto scale = 1 + y_.tail(n).array().abs().max(next_.tail(n).array().abs());
  const auto off = (next_.tail(n) - y_.tail(n) - change).array().abs();
  return !((off / scale).maxCoeff() > kResolved);
}

/// `next_` after the longest step that meets the tolerance. \return its length
double Simulator::adaptive_step(double longest) {
  if (suggested_ == 0) {
    propose();
  }
  const int order = integrator_->error_order();
  const double given = settings_.longest > 0 ? settings_.longest : longest;
  for (double h = longest_step(std::min({suggested_, given, longest}));;) {
    if (!(t_ + h > t_) || (h < least_step() && h < longest)) {
      throw std::runtime_error(
          next_.size() == 0 || next_.allFinite()
              ? fmt::format("no step that advances time meets the tolerance of {} at t = {} s",
                            settings_.tolerance, t_)
              : not_finite(scene_, t_, {y_.begin(), y_.end()}));
    }
    take(h);
    const double ratio = error_ratio(h);
    const double factor = kCaution * std::pow(ratio, -1.0 / (order + 1));
    if (ratio <= 1 && !is_resolved(h)) {
      ++cost_.rejected;
      h /= 2;
      suggested_ = h;
      continue;
    }
    if (ratio <= 1) {
      const double grown = h * std::clamp(factor, kLeastFactor, kMostFactor);
      suggested_ = h < longest ? grown : std::max(suggested_, grown);
      return h;
    }
    ++cost_.rejected;
    h *= std::clamp(factor, kLeastFactor, kCaution);
    suggested_ = h;
  }
}

}  // namespace treedyn::simulation
