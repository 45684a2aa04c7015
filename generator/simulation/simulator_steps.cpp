// How long a step may be.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "simulation/column_names.hpp"
#include "simulation/simulator.hpp"

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
/// Shorter pulses are not looked for, nor are corners approached any closer, s.
constexpr double kPulse = 1e-9;
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
  expected_ = f0.tail(f0.size() / 2);
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

/// \return the longest step in which no force and no guard has a pulse between samples
double Simulator::resolved(const Motion& motion, double longest) {
  double step = longest;
  for (auto* const all : {&changing_, &guards_}) {
    for (Changing& changing : *all) {
      step = resolved_step(changing, motion, step);
    }
  }
  return std::max(step, std::min(longest, std::max(kPulse, least_step())));
}

/// Places and speeds of joints and, where forces depend on them, of points.
std::pair<Vector, Vector> Simulator::coordinates(const Vector& y) {
  const Eigen::Index n = y.size() / 2;
  std::pair<Vector, Vector> result{y.head(n), y.tail(n)};
  if (std::ranges::any_of(changing_, [](const Changing& one) { return one.point >= 0; })) {
    const Terms& terms = system_.geometry(y.head(n));
    const Eigen::Index points = terms.p().size();
    result.first.conservativeResize(n + points);
    result.first.tail(points) = terms.p();
    result.second.conservativeResize(n + points);
    result.second.tail(points) = terms.C().transpose() * y.tail(n);
  }
  return result;
}

/// What forces and guards allow, and the turn of the joints if there are guards.
double Simulator::longest_step(double longest) {
  const Eigen::Index n = y_.size() / 2;
  const auto [x, v] = coordinates(y_);
  scale_ = resolved(going_on(t_, x, v, expected_), longest);
  double turn = 0;
  for (const int k : turning_) {
    turn += std::fabs(y_[n + k]);
  }
  return watches_.empty() || turn * scale_ < kTurns * kTurn ? scale_ : kTurns * kTurn / turn;
}

/// A second opinion on a step whose error estimate is small, for that sees no force that begins and
/// ends between its samples: the velocity changes by about what Simpson's rule says, and no force
/// has a pulse along the motion that the step has found. \return a step to try instead, or h
double Simulator::resolved_by(double h) {
  const Eigen::Index n = y_.size() / 2;
  cost_.evaluations += 2;
  expected_ = system_.accelerate(t_ + h, next_.head(n), next_.tail(n)).qdd;
  dense_.set(h, y_, qdd_, next_, expected_);
  const Vector middle = dense_.at(0.5);
  const Vector qdd = system_.accelerate(t_ + h / 2, middle.head(n), middle.tail(n)).qdd;
  const Vector change = h / 6 * (qdd_ + 4 * qdd + expected_);
  const auto scale = 1 + y_.tail(n).array().abs().max(next_.tail(n).array().abs());
  const auto off = (next_.tail(n) - y_.tail(n) - change).array().abs();
  if ((off / scale).maxCoeff() > kResolved) {
    return h / 2;
  }
  const auto [x, v] = coordinates(y_);
  return resolved(
      gone(h, going_on(t_, x, v, qdd_), coordinates(middle).second, coordinates(next_).second), h);
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
      const std::vector<double> state(y_.begin(), y_.end());
      const bool is_finite =
          (next_.size() == 0 || next_.allFinite()) && no_value(scene_, t_, state).empty();
      throw std::runtime_error(
          is_finite
              ? fmt::format("no step that advances time meets the tolerance of {} at t = {} s",
                            settings_.tolerance, t_)
              : not_finite(scene_, t_, state));
    }
    take(h);
    const double ratio = error_ratio(h);
    const double factor = kCaution * std::pow(ratio, -1.0 / (order + 1));
    if (ratio <= 1) {
      const double resolved = resolved_by(h);
      if (resolved < h) {
        ++cost_.rejected;
        suggested_ = h = resolved;
        continue;
      }
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
