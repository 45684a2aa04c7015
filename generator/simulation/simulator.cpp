#include "simulation/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace treedyn::simulation {

namespace {

using Kind = Watch::Kind;

/// Factors of the step size: caution, and the largest changes at once.
constexpr double kCaution = 0.9;
constexpr double kLeastFactor = 0.2;
constexpr double kMostFactor = 5;
/// Projections of an initial state, and the position error (m, rad) that it may keep.
constexpr int kSettlingSteps = 20;
constexpr double kSettled = 1e-8;
/// The velocity error (m/s, rad/s) that it may keep: what a singular position lets go is below it.
constexpr double kSettledSpeed = 1e-6;
/// How often a fixed step is halved when it does not lead anywhere.
constexpr int kHalvings = 20;
/// The first step behind an event, as a part of the duration: forces may begin there that no error
/// estimate has seen.
constexpr double kRestart = 1e-6;
/// Events at the same instant before it is called a pile.
constexpr int kMaxPile = 100;

Vector to_vector(const std::vector<Real>& values) {
  Vector result(static_cast<Eigen::Index>(values.size()));
  std::transform(values.begin(), values.end(), result.begin(),
                 [](const Real& x) { return static_cast<double>(x); });
  return result;
}

Kind kind_of(model::EventKind kind) {
  switch (kind) {
    case model::EventKind::kReaction:
      return Kind::kReaction;
    case model::EventKind::kTime:
      return Kind::kTime;
    case model::EventKind::kExpression:
      return Kind::kExpression;
    case model::EventKind::kHeight:
      break;
  }
  return Kind::kEvent;
}

double alpha(const Settings& settings) {
  return settings.drift == Drift::kBaumgarte ? settings.stabilisation : 0;
}

}  // namespace

Simulator::Simulator(const model::Scene& scene, Dynamics& dynamics, const Settings& settings)
    : scene_(scene),
      settings_(settings),
      system_(scene, dynamics, alpha(settings)),
      integrator_(make_integrator(settings.integrator)),
      rate_([this](double t, const Vector& y, Vector& dy) { rate(t, y, dy); }),
      t_(static_cast<double>(scene.t0)),
      duration_(static_cast<double>(scene.duration)),
      y_(2 * scene.tree.dof()),
      suggested_(kLongestStep * duration_ / 100) {
  y_ << to_vector(scene.q0), to_vector(scene.qd0);
  phase_start_ = t_;
  start_phase(scene.start_phase, scene.phases[static_cast<std::size_t>(scene.start_phase)].active);
  for (std::size_t k = 0; k < system_.frictions().size(); ++k) {
    stick_or_slip(k);
  }
  build_watches();
}

void Simulator::rate(double t, const Vector& y, Vector& dy) {
  const Eigen::Index n = y.size() / 2;
  dy.resize(y.size());
  dy.head(n) = y.tail(n);
  dy.tail(n) = system_.accelerate(t, y.head(n), y.tail(n)).qdd;
}

double Simulator::error_ratio(double h) {
  if (settings_.drift == Drift::kProjection) {
    system_.remove_normal(t_ + h, next_, error_);
  }
  // what the projection corrects is no error
  const auto scale = 1 + y_.array().abs().max(next_.array().abs());
  const double ratio = (error_.array().abs() / scale).maxCoeff() / settings_.tolerance;
  return next_.allFinite() && error_.allFinite() ? ratio : std::numeric_limits<double>::infinity();
}

/// `next_` after the longest step that meets the tolerance. \return its length
double Simulator::step(double longest) {
  const int order = integrator_->error_order();
  if (order == 0) {
    double h = longest < settings_.step * (1 + 1e-9) ? longest : settings_.step;
    integrator_->step(rate_, t_, h, y_, next_, error_);
    for (int k = 0; k < kHalvings && !next_.allFinite(); ++k) {  // an implicit one found no state
      h /= 2;
      integrator_->step(rate_, t_, h, y_, next_, error_);
    }
    return h;
  }
  const double most = settings_.longest > 0 ? settings_.longest : kLongestStep * duration_;
  const double least = kShortestStep * duration_;
  for (double h = std::min({suggested_, most, longest});;) {
    integrator_->step(rate_, t_, h, y_, next_, error_);
    const double ratio = error_ratio(h);
    const double factor = kCaution * std::pow(ratio, -1.0 / (order + 1));
    if (ratio <= 1 || (h <= least && next_.allFinite())) {
      const double grown = h * std::clamp(factor, kLeastFactor, kMostFactor);
      suggested_ = h < longest ? grown : std::max(suggested_, grown);
      return h;
    }
    if (h <= least) {
      throw std::runtime_error(fmt::format("the motion is not finite at t = {} s", t_));
    }
    h = std::max(least, h * std::clamp(factor, kLeastFactor, kCaution));
    suggested_ = h;
  }
}

double Simulator::settle() {
  Vector position = q();
  Vector velocity = qd();
  for (int k = 0; k < kSettlingSteps; ++k) {
    system_.project(t_, position, velocity);
  }
  const Vector before = y_;
  y_ << position, velocity;
  if (!y_.allFinite() || system_.violation(t_, position) > kSettled) {
    throw std::runtime_error("the initial state is not near one that meets the constraints");
  }
  if (system_.speed_violation(t_, position, velocity) > kSettledSpeed) {
    throw std::runtime_error("no velocity meets the constraints at the initial state");
  }
  build_watches();
  return (y_ - before).cwiseAbs().maxCoeff();
}

bool Simulator::advance_to(double end, const Observe& observe) {
  while (t_ < end) {
    begin_watches();
    const double longest = end - t_;
    double h = step(longest);
    const std::optional<Crossing> crossing = first_crossing(h);
    if (crossing) {
      h = crossing->step;
      integrator_->step(rate_, t_, h, y_, next_, error_);
    }
    t_ = h == longest ? end : t_ + h;
    y_ = next_;
    if (!y_.allFinite()) {
      throw std::runtime_error(fmt::format("the motion is not finite at t = {} s", t_));
    }
    if (settings_.drift == Drift::kProjection) {
      Vector position = q();
      Vector velocity = qd();
      system_.project(t_, position, velocity);
      y_ << position, velocity;
    }
    ++steps_;
    if (crossing) {
      happen(watches_[crossing->watch]);
      build_watches();
      suggested_ = std::min(suggested_, kRestart * duration_);
    }
    if (!observe()) {
      return false;
    }
  }
  return true;
}

void Simulator::place(double time, const Vector& q, const Vector& qd, int phase,
                      const std::vector<int>& active) {
  t_ = time;
  y_ << q, qd;
  if (phase != phase_ || active != system_.constraints().active()) {
    start_phase(phase, active);
  }
}

void Simulator::start_phase(int phase, const std::vector<int>& active) {
  const std::vector<int> before = system_.constraints().active();
  system_.constraints().activate(active);
  const Terms& terms = system_.geometry(q());
  for (const int c : active) {
    if (std::find(before.begin(), before.end(), c) == before.end()) {
      system_.constraints().begin(c, t_, q(), terms);
    }
  }
  phase_ = phase;
  phase_start_ = t_;
}

/// Sides of contacts are kept: on the plane the state does not tell them.
void Simulator::build_watches() {
  const std::vector<Watch> before = std::move(watches_);
  watches_.clear();
  const auto add = [&](Kind kind, std::size_t index, int point, const model::Plane& plane) {
    Watch watch{kind, index, point, PlaneValues(plane), 1};
    if (kind != Kind::kContact && kind != Kind::kSlip && kind != Kind::kStick) {
      watch.event = &scene_.phases[static_cast<std::size_t>(phase_)].until[index];
      watch.until = phase_start_ + static_cast<double>(watch.event->not_before);
    }
    if (kind != Kind::kReaction) {  // a pull ends the phase whenever it is seen
      watch.side = watch.side_of(system_, t_, y_);
    }
    const auto same = std::find_if(before.begin(), before.end(), [&](const Watch& w) {
      return kind == Kind::kContact && w.kind == kind && w.index == index;
    });
    watch.side = same == before.end() ? watch.side : same->side;
    watches_.push_back(watch);
  };
  const std::vector<model::Event>& events = scene_.phases[static_cast<std::size_t>(phase_)].until;
  const std::vector<int>& active = system_.constraints().active();
  for (std::size_t k = 0; k < events.size(); ++k) {
    const auto& impact = events[k].impact;
    const bool rests = impact && !impact->constraints.empty() &&
                       std::includes(active.begin(), active.end(), impact->constraints.begin(),
                                     impact->constraints.end());
    if (!rests) {
      add(kind_of(events[k].kind), k, events[k].point, events[k].plane);
    }
  }
  for (std::size_t k = 0; k < scene_.contacts.size(); ++k) {
    add(Kind::kContact, k, scene_.contacts[k].point, scene_.contacts[k].plane);
    system_.forces().touch(k, watches_.back().side < 0);
  }
  for (std::size_t k = 0; k < system_.frictions().size(); ++k) {
    const int direction = system_.frictions()[k].direction;
    add(direction == 0 ? Kind::kStick : Kind::kSlip, k, 0, {});
    watches_.back().side = direction == 0 ? 1 : direction;
  }
}

void Simulator::begin_watches() {
  for (Watch& watch : watches_) {
    watch.start = watch.value(system_, t_, y_);
    watch.start_slope = watch.slope(system_, y_);
  }
}

/// The earliest change of side within the step that ends in `next_`; other events that cannot end
/// the phase yet only change their side.
std::optional<Simulator::Crossing> Simulator::first_crossing(double h) {
  std::optional<Crossing> first;
  const Vector end = next_;
  for (std::size_t k = 0; k < watches_.size(); ++k) {
    Watch& watch = watches_[k];
    const double value = watch.value(system_, t_ + h, end);
    const bool event = watch.ends_phase();
    const int part =
        event && watch.side < 0 ? 0 : watch.first_change(h, value, watch.slope(system_, end));
    double at = part == 0 ? h : refine(watch, h * (part - 1) / kScans, h * part / kScans);
    if (part != 0 && at < 0 && value * watch.side < 0) {
      at = refine(watch, 0, h);
    }
    bool counts = part != 0 && at >= 0;
    if (event && counts) {
      counts = t_ + at >= watch.until;
    }
    if (counts && (!first || at < first->step)) {
      first = Crossing{k, at};
    } else if (event && !counts && watch.kind != Kind::kReaction) {
      watch.side = value > 0 ? 1 : value < 0 ? -1 : watch.side;
    }
  }
  next_ = end;
  return first;
}

/// The length of the step in (low, high] that ends where the watch changes its side, by bisection
/// to the resolution of time; -1 if it does not change up to `high`.
double Simulator::refine(Watch& watch, double low, double high) {
  const auto beyond = [&](double h) {
    integrator_->step(rate_, t_, h, y_, next_, trial_);
    return watch.value(system_, t_ + h, next_) * watch.side < 0;
  };
  if (!beyond(high)) {
    return -1;
  }
  if (low > 0 && beyond(low)) {
    high = low;
    low = 0;
  }
  const double resolution = std::numeric_limits<double>::epsilon() * (std::fabs(t_) + high) / 8;
  while (high - low > resolution) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) {
      break;
    }
    (beyond(middle) ? high : low) = middle;
  }
  return high;
}

void Simulator::happen(Watch& watch) {
  switch (watch.kind) {
    case Kind::kEvent:
    case Kind::kReaction:
    case Kind::kTime:
    case Kind::kExpression:
      fire(scene_.phases[static_cast<std::size_t>(phase_)].until[watch.index]);
      break;
    case Kind::kContact:
      watch.side = -watch.side;
      break;
    case Kind::kSlip:
    case Kind::kStick:
      y_[system_.dof() + system_.frictions()[watch.index].joint] = 0;
      stick_or_slip(watch.index);
      break;
  }
}

/// A joint that moves slips; one at rest sticks if its friction can hold it.
void Simulator::stick_or_slip(std::size_t k) {
  DryFriction& friction = system_.frictions()[k];
  const double speed = y_[system_.dof() + friction.joint];
  friction.direction = speed > 0 ? 1 : speed < 0 ? -1 : 0;
  if (friction.direction == 0) {
    system_.accelerate(t_, q(), qd());
    const double hold = system_.holding_force(k);
    friction.direction = std::fabs(hold) <= friction.force ? 0 : hold > 0 ? -1 : 1;
  }
}

/// The impact of an event. \return true if the rebound is slow enough to be rest
bool Simulator::strike(const model::Event& event, EventRecord& record) {
  const model::Impact& impact = *event.impact;
  const auto restitution = static_cast<double>(impact.restitution);
  record.impulse = system_.impact(t_, record.q, record.qd_after, impact.constraints, restitution);
  const auto C = system_.geometry(record.q).C().middleCols<3>(3 * event.point);
  const double rebound = (C * vector_of(event.plane.normal)).dot(record.qd_after);
  if (restitution == 0 || rebound >= static_cast<double>(impact.rest_below)) {
    return false;
  }
  record.qd_after = record.qd_before;
  record.impulse = system_.impact(t_, record.q, record.qd_after, impact.constraints, 0);
  return true;
}

void Simulator::fire(const model::Event& event) {
  guard_against_pile();
  EventRecord record{t_, phase_, q(), qd(), qd(), {}};
  std::vector<int> active = scene_.phases[static_cast<std::size_t>(event.then)].active;
  if (event.impact && strike(event, record)) {
    const std::vector<int>& resting = event.impact->constraints;
    active.insert(active.end(), resting.begin(), resting.end());
    std::sort(active.begin(), active.end());
    active.erase(std::unique(active.begin(), active.end()), active.end());
  }
  const Terms& terms = system_.geometry(record.q);
  for (const int c : event.pins) {
    system_.constraints().pin(c, t_, record.q, terms);
  }
  y_ << record.q, record.qd_after;
  start_phase(event.then, active);
  events_.push_back(std::move(record));
}

void Simulator::guard_against_pile() {
  const bool same = !events_.empty() && t_ - events_.back().time <= kOnPlane * duration_;
  pile_ = same ? pile_ + 1 : 0;
  if (pile_ > kMaxPile) {
    throw std::runtime_error(
        fmt::format("events pile up at t = {} s; expected rest_below at the impact", t_));
  }
}

}  // namespace treedyn::simulation
