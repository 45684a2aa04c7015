// Events of a motion: watches, the places where they change, and what happens there.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "model/scene_facts.hpp"
#include "simulation/column_names.hpp"
#include "simulation/sign_changes.hpp"
#include "simulation/simulator.hpp"

namespace treedyn::simulation {

namespace {

using Kind = Watch::Kind;

/// Events at the same instant, beyond one of each kind, before it is called a pile, and how long an
/// instant is: a part of the time, or s.
constexpr int kMaxPile = 100;
constexpr double kPile = 1e-10;
/// How far apart events of one instant may be found, in resolutions of time.
constexpr double kSameInstant = 16;

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

}  // namespace

void Simulator::start_phase(int phase, const std::vector<int>& active) {
  began_ = true;
  const std::vector<int> before = system_.constraints().active();
  system_.constraints().activate(active);
  const Terms& terms = system_.geometry(q());
  for (const int c : active) {
    if (std::ranges::find(before, c) == before.end()) {
      system_.constraints().begin(c, t_, q(), terms);
    }
  }
  if (phase != phase_) {
    rebounded_.clear();
  }
  phase_ = phase;
  phase_start_ = t_;
  lift_offs_.clear();
}

void Simulator::add_watch(const std::vector<Watch>& before, Kind kind, std::size_t index, int point,
                          const model::Plane& plane) {
  Watch watch{kind, index, point, PlaneValues(plane), 1};
  if (kind != Kind::kContact && kind != Kind::kSlip && kind != Kind::kStick) {
    watch.event = &event_at(index);
    watch.until = phase_start_ + static_cast<double>(watch.event->not_before);
    watch.armed = watch.until <= t_;
    watch.lands = kind == Kind::kEvent && lands(*watch.event);
  }
  watch.side = watch.side_of(system_, t_, y_);
  const auto same = std::ranges::find_if(before, [&](const Watch& w) {
    return kind == Kind::kContact ? w.kind == kind && w.index == index : watch.looks_at_what(w);
  });
  if (kind == Kind::kContact) {
    watch.side = same == before.end() ? watch.side : same->side;
  } else if (watch.side < 0 && is_still_to_come(watch, same == before.end() ? nullptr : &*same)) {
    watch.side = 1;
  }
  watches_.push_back(watch);
}

/// What is on the plane, or a rounding below zero, was above until now: another event of the same
/// instant came first, or the motion begins. What only an impact brought there was not about to
/// fall.
bool Simulator::is_still_to_come(const Watch& watch, const Watch* same) {
  if (!watch.armed || (watch.kind != Kind::kEvent && watch.kind != Kind::kExpression)) {
    return false;
  }
  if (events_.empty() && !(t_ > start_)) {
    return watch.value(system_, t_, y_) >= 0;
  }
  if (same == nullptr || same->before <= 0 || same->fired) {
    return false;
  }
  const double rate =
      watch.is_height() ? watch.slope(system_, arrived_) : slope_of(watch, arrived_);
  const double passed = kSameInstant * resolution(0) * std::fabs(rate);
  return std::fabs(watch.value(system_, t_, arrived_)) <= std::max(kOnPlane, passed);
}

/// The impact of a touch-down, or what begins to hold behind it, stops its point.
bool Simulator::lands(const model::Event& event) const {
  const std::vector<int>& active = system_.constraints().active();
  std::vector<int> rows = event.impact ? model::struck(scene_, event) : std::vector<int>();
  for (const int c : scene_.phases[static_cast<std::size_t>(event.then)].active) {
    if (!std::ranges::binary_search(active, c)) {
      rows.push_back(c);
    }
  }
  return model::floor_of(scene_, event, rows) >= 0;
}

/// Sides of contacts are kept: on the plane the state does not tell them.
void Simulator::build_watches() {
  const std::vector<Watch> before = std::move(watches_);
  watches_.clear();
  const std::vector<model::Event>& events = scene_.phases[static_cast<std::size_t>(phase_)].until;
  const std::vector<int>& active = system_.constraints().active();
  for (std::size_t k = 0; k < events.size(); ++k) {
    if (!model::strikes_what_acts(events[k], active)) {
      add_watch(before, kind_of(events[k].kind), k, events[k].point, events[k].plane);
    }
  }
  for (std::size_t k = 0; k < lift_offs_.size(); ++k) {
    add_watch(before, Kind::kReaction, events.size() + k, 0, lift_offs_[k].event.plane);
  }
  for (std::size_t k = 0; k < scene_.contacts.size(); ++k) {
    add_watch(before, Kind::kContact, k, scene_.contacts[k].point, scene_.contacts[k].plane);
    system_.forces().touch(k, watches_.back().side < 0);
  }
  for (std::size_t k = 0; k < system_.frictions().size(); ++k) {
    const int direction = system_.frictions()[k].direction;
    add_watch(before, direction == 0 ? Kind::kStick : Kind::kSlip, k, 0, {});
    watches_.back().side = direction == 0 ? 1 : direction;
  }
  guards_.clear();
  for (const Watch& watch : watches_) {
    if (watch.kind == Kind::kExpression) {
      guards_.push_back({watch.event->value});
    }
  }
}

/// Pieces of a step in which guards are looked at to begin with: short against the turn of the
/// joints and against what changes with time by itself.
int Simulator::pieces(double h) const {
  const Eigen::Index n = y_.size() / 2;
  double turn = 0;
  for (const int k : turning_) {
    turn += h * std::max(std::fabs(y_[n + k]), std::fabs(next_[n + k]));
  }
  const double parts = std::max(turn / kTurn, scale_ > 0 && scale_ < h ? 2 * h / scale_ : 1);
  return static_cast<int>(std::ceil(std::clamp(parts, 1.0, 1000.0)));
}

/// The earliest change of side within the step that ends in `next_`.
std::optional<Simulator::Crossing> Simulator::first_crossing(double h) {
  std::optional<Crossing> first;
  if (watches_.empty()) {
    return first;
  }
  if (integrator_->error_order() == 0) {
    dense_.set(h, y_, qdd_, next_);  // else `resolved_by` has set it
  }
  for (std::size_t k = 0; k < watches_.size(); ++k) {
    look_for(k, h, first);
  }
  for (Watch& watch : watches_) {  // behind a crossing they are built anew
    watch.side = watch.next_side;
    watch.armed = watch.until <= t_ + h;
    if (!first && watch.armed && watch.side < 0) {
      note_below(watch, t_ + h, next_);
    }
    if (!first && watch.kind == Kind::kExpression) {
      refuse_small_rebounds(watch, t_ + h, next_);
    }
  }
  return first;
}

void Simulator::look_for(std::size_t k, double h, std::optional<Crossing>& first) {
  Watch& watch = watches_[k];
  watch.next_side = watch.side;
  watch.before = 0;
  const double from = watch.armed ? 0 : (watch.until - t_) / h;
  if (from > 1) {
    return;
  }
  if (watch.kind == Kind::kTime) {
    if (!first || from * h < first->step) {
      first = Crossing{k, std::max(0.0, watch.until - t_)};
    }
    return;
  }
  const auto g = [&](double s) {
    const double at = from + (1 - from) * s;
    cost_.evaluations += watch.kind == Kind::kReaction || watch.kind == Kind::kStick ? 1 : 0;
    return watch.value(system_, t_ + at * h, dense_.at(at));
  };
  const Vector start = watch.armed ? y_ : dense_.at(from);
  int side = watch.armed ? watch.side : watch.side_of(system_, t_ + from * h, start);
  watch.before = side;
  if (!watch.armed && side < 0) {
    note_below(watch, t_ + from * h, start);
  }
  const SignChanges changes = sign_changes(g, side, pieces(h), watch.band());
  for (std::size_t n = 0; n < changes.places.size(); ++n) {
    const double low = from + (1 - from) * changes.places[n].low;
    const double high = from + (1 - from) * changes.places[n].high;
    if (!(watch.ends_phase() && side < 0) && (!first || low * h < first->step)) {
      watch.side = side;
      const double at = refine(watch, low, high, h);
      if (at < 0) {  // the motion does not get there: nor does it come back
        ++n;
        continue;
      }
      watch.next_side = side;
      // what stops at zero does not fall through it
      const bool stops =
          watch.kind == Kind::kSlip && first && watches_[first->watch].kind == Kind::kExpression;
      if (!first || at < first->step + (stops ? kSameInstant * resolution(at) : 0)) {
        first = Crossing{k, at};
      }
      return;
    }
    side = -side;
  }
  watch.next_side = watch.kind == Kind::kReaction ? 1 : side;
  const double undefined = (from + (1 - from) * changes.undefined) * h;
  if (changes.undefined >= 0 && watch.ends_phase() && !(first && first->step < undefined)) {
    monitor_.guard(name_of(watch.index), t_ + undefined, true);
  }
}

/// How well the time after a step from here is known, s.
double Simulator::resolution(double step) const {
  return std::numeric_limits<double>::epsilon() * (std::fabs(t_) + step) / 8;
}

/// The length of the step that ends where the watch changes its side, to the resolution of time:
/// between two parts of it, and not before the watch is looked at; -1 if the motion does not get
/// there. An expression is beyond zero by more than its rounding.
double Simulator::refine(const Watch& watch, double low, double high, double h) {
  const std::function<double(double)> g = [&](double step) {
    integrator_->step(rate_, t_, step, y_, trial_, trial_error_);
    return watch.value(system_, t_ + step, trial_) +
           (watch.kind == Kind::kExpression ? watch.side * watch.band() : 0);
  };
  const double earliest = watch.armed ? 0 : watch.until - t_;
  double from = std::max(low * h, earliest);
  double to = std::max(high * h, earliest);
  if (!(watch.side * g(to) < 0)) {  // the motion is a little behind its polynomial
    to = std::min(h, to + (to - from));
    if (!(watch.side * g(to) < 0)) {
      to = h;  // by far, as steps of order 1 are
    }
    if (!(watch.side * g(to) < 0)) {
      return -1;
    }
  }
  if (from > earliest && watch.side * g(from) < 0) {
    from = earliest;
  }
  return far_side(g, watch.side, from, to, resolution(to));
}

/// Rate of an expression in a state of now, by a difference.
double Simulator::slope_of(const Watch& watch, const Vector& y) {
  constexpr double kSpan = 1e-6;  // s
  const Eigen::Index n = system_.dof();
  Vector later = y;
  later.head(n) += kSpan * y.tail(n);
  return (watch.value(system_, t_ + kSpan, later) - watch.value(system_, t_, y)) / kSpan;
}

/// What rebounds and begins below zero without having been above since falls through unseen.
void Simulator::refuse_small_rebounds(const Watch& watch, double t, const Vector& y) {
  if (!rebounded_.contains(watch.event)) {
    return;
  }
  if (watch.side > 0) {
    rebounded_.erase(watch.event);
  } else if (const double here = watch.value(system_, t_, y_);
             here <= 0 && watch.value(system_, t, y) < here) {
    throw std::runtime_error(
        fmt::format("rebounds of '{}' pile up at t = {} s until none is seen: expected a "
                    "touch_down, which may come to rest, or an impact without restitution",
                    name_of(watch.index), t_));
  }
}

/// Its event; notes an impact that throws it back.
void Simulator::strike_expression(const Watch& watch) {
  const double before = slope_of(watch, y_);
  fire(watch.index);
  if (!watch.event->impact || watch.event->not_before != 0) {
    return;
  }
  const auto restitution = static_cast<double>(watch.event->impact->restitution);
  if (restitution > 0 && before < 0 && slope_of(watch, y_) > -before * restitution / 2) {
    rebounded_.insert(watch.event);
  }
}

void Simulator::happen(Watch& watch) {
  guard_against_pile(watch);
  watch.fired = true;
  arrived_ = y_;
  switch (watch.kind) {
    case Kind::kEvent:
    case Kind::kReaction:
    case Kind::kTime:
      fire(watch.index);
      break;
    case Kind::kExpression:
      strike_expression(watch);
      break;
    case Kind::kContact:
      watch.side = -watch.side;
      break;
    case Kind::kSlip:
    case Kind::kStick:
      y_[system_.dof() + system_.frictions()[watch.index].joint] = 0;
      stick_or_slip(system_, t_, y_, watch.index);
      if (system_.frictions()[watch.index].direction != 0) {
        monitor_.break_away();
      }
      break;
  }
}

/// A joint that moves slips; one at rest sticks if its friction can hold it.
void Simulator::stick_or_slip(System& system, double t, const Vector& y, std::size_t k) {
  DryFriction& friction = system.frictions()[k];
  const double speed = y[system.dof() + friction.joint];
  friction.direction = speed > 0 ? 1 : speed < 0 ? -1 : 0;
  if (friction.direction == 0) {
    system.accelerate(t, y.head(system.dof()), y.tail(system.dof()));
    const double hold = system.holding_force(k);
    friction.direction = std::fabs(hold) <= friction.hold() ? 0 : hold > 0 ? -1 : 1;
  }
}

/// The impact of an event. \return true if the rebound is slow enough to be rest
bool Simulator::strike(const model::Event& event, EventRecord& record) {
  const model::Impact& impact = *event.impact;
  const auto restitution = static_cast<double>(impact.restitution);
  record.impulse = system_.impact(t_, record.q, record.qd_after, impact.constraints, restitution);
  if (event.kind != model::EventKind::kHeight || (restitution == 0 && impact.rest_below == 0)) {
    return false;
  }
  const auto C = system_.geometry(record.q).C().middleCols<3>(3 * event.point);
  const double rebound = (C * vector_of(event.plane.normal)).dot(record.qd_after);
  const bool may_lift_off =
      restitution < 1 && model::floor_of(scene_, event, model::struck(scene_, event)) >= 0;
  if (rebound >= std::max(static_cast<double>(impact.rest_below), may_lift_off ? kAtRest : 0.0)) {
    return false;
  }
  record.qd_after = record.qd_before;
  record.impulse = system_.impact(t_, record.q, record.qd_after, impact.constraints, 0);
  return true;
}

const model::Event& Simulator::event_at(std::size_t event) const {
  const std::vector<model::Event>& all = scene_.phases[static_cast<std::size_t>(phase_)].until;
  return event < all.size() ? all[event] : lift_offs_[event - all.size()].event;
}

std::string Simulator::name_of(std::size_t event) const {
  const std::size_t count = scene_.phases[static_cast<std::size_t>(phase_)].until.size();
  if (event < count) {
    return event_name(scene_, phase_, event);
  }
  const auto constraint = static_cast<std::size_t>(event_at(event).constraint);
  return "lift_off of " + scene_.constraints[constraint].name;
}

/// A rebound so small that it rests, though nobody has said that it may: until it would be pulled.
void Simulator::add_lift_off(const model::Event& event) {
  LiftOff result{{}, model::struck(scene_, event)};
  result.event.kind = model::EventKind::kReaction;
  result.event.plane.normal = event.plane.normal;
  result.event.then = event.then;
  result.event.constraint = model::floor_of(scene_, event, result.constraints);
  if (result.event.constraint >= 0) {
    lift_offs_.push_back(result);
  }
}

void Simulator::lift_off(const LiftOff& rest) {
  const double began = phase_start_;
  std::vector<int> active = system_.constraints().active();
  std::erase_if(active, [&](int c) {
    return std::ranges::find(rest.constraints, c) != rest.constraints.end();
  });
  const std::vector<LiftOff> others = lift_offs_;
  start_phase(phase_, active);
  phase_start_ = began;
  std::ranges::copy_if(others, std::back_inserter(lift_offs_), [&](const LiftOff& other) {
    return other.event.constraint != rest.event.constraint;
  });
}

void Simulator::fire(std::size_t index) {
  const model::Event event = event_at(index);
  EventRecord record{t_, phase_, name_of(index), event.then, q(), qd(), qd(), {}};
  const std::size_t own = scene_.phases[static_cast<std::size_t>(phase_)].until.size();
  if (index >= own) {
    lift_off(LiftOff(lift_offs_[index - own]));
    events_.push_back(std::move(record));
    return;
  }
  std::vector<int> active = scene_.phases[static_cast<std::size_t>(event.then)].active;
  const std::vector<int> acted = system_.constraints().active();
  const bool rests = event.impact && strike(event, record);
  const std::vector<LiftOff> before = lift_offs_;
  if (rests) {
    const std::vector<int>& resting = event.impact->constraints;
    active.insert(active.end(), resting.begin(), resting.end());
    std::ranges::sort(active);
    active.erase(std::unique(active.begin(), active.end()), active.end());
  }
  const Terms& terms = system_.geometry(record.q);
  for (const int c : event.pins) {
    system_.constraints().pin(c, t_, record.q, terms);
  }
  y_ << record.q, record.qd_after;
  start_phase(event.then, active);
  std::ranges::copy_if(before, std::back_inserter(lift_offs_), [&](const LiftOff& other) {
    return event.then == record.phase && std::ranges::binary_search(active, other.event.constraint);
  });
  if (rests && event.impact->rest_below == 0) {
    add_lift_off(event);
  }
  for (std::size_t k = 0; k < system_.frictions().size(); ++k) {  // an impact may have moved them
    stick_or_slip(system_, t_, y_, k);
  }
  events_.push_back(record);
  monitor_.positions(system_, t_, record.q);
  monitor_.speeds(system_, t_, record.q, record.qd_after, record.qd_before, acted);
  monitor_.drift(system_, t_, record.q);  // before projections take it
}

/// What happens again and again at one instant would never end.
void Simulator::guard_against_pile(const Watch& watch) {
  const bool same = t_ - happened_ <= kPile * std::max(1.0, std::fabs(t_));
  pile_ = same ? pile_ + 1 : 0;
  happened_ = t_;
  if (pile_ <= kMaxPile + static_cast<int>(watches_.size())) {
    return;
  }
  if (watch.kind == Watch::Kind::kSlip || watch.kind == Watch::Kind::kStick) {
    const int joint = system_.frictions()[watch.index].joint;
    throw std::runtime_error(fmt::format(
        "joint '{}' sticks and slips to and fro at t = {} s: its friction needs a slip_speed",
        scene_.tree.moved_by(joint).joint.name, t_));
  }
  std::set<std::string> names;
  const std::size_t count = std::min(events_.size(), static_cast<std::size_t>(pile_));
  for (std::size_t k = events_.size() - count; k < events_.size(); ++k) {
    names.insert(fmt::format("'{}'", events_[k].name));
  }
  const bool bounces =
      names.size() == 1 && watch.kind == Watch::Kind::kEvent && event_at(watch.index).impact;
  throw std::runtime_error(
      fmt::format("events pile up at t = {} s: {}", t_,
                  bounces         ? "the impact needs rest_below"
                  : names.empty() ? "a contact opens and closes again and again"
                                  : fmt::format("{} again and again", fmt::join(names, " and "))));
}

}  // namespace treedyn::simulation
