// Watches of a motion: on which side guards are, and the places where they change it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "model/scene_facts.hpp"
#include "simulation/sign_changes.hpp"
#include "simulation/simulator.hpp"

namespace treedyn::simulation {

namespace {

using Kind = Watch::Kind;

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

bool Simulator::lands(const model::Event& event) const {
  return model::stops_point(scene_, event, system_.constraints().active(),
                            scene_.phases[static_cast<std::size_t>(event.then)].active);
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

}  // namespace treedyn::simulation
