// Events of a motion: what happens there, and the phases that begin.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "common/index.hpp"
#include "model/scene_facts.hpp"
#include "simulation/column_names.hpp"
#include "simulation/simulator.hpp"

namespace treedyn::simulation {

namespace {

using Kind = Watch::Kind;

/// Events at the same instant, beyond one of each kind, before it is called a pile, and how long an
/// instant is: a part of the time, or s.
constexpr int kMaxPile = 100;
constexpr double kPile = 1e-10;
/// Of the largest change of speed that an impact should make, what a row may lack of its own.
constexpr double kUnmet = 1e-2;
/// Of the largest speed of a blow, what bodies that touch may close at by rounding: differences of
/// expressions have 1e-10 of their terms.
constexpr double kCreep = 1e-8;

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

/// What rebounds and begins below zero without having been above since falls through unseen, if it
/// falls: bodies that touch may close at a speed that is rounding.
void Simulator::refuse_small_rebounds(const Watch& watch, double t, const Vector& y) {
  if (!rebounded_.contains(watch.event)) {
    return;
  }
  if (watch.side > 0) {
    rebounded_.erase(watch.event);
  } else if (const double here = watch.value(system_, t_, y_);
             here <= 0 && watch.value(system_, t, y) < here &&
             slope_of(watch, y) < -kCreep * blows_[watch.event]) {
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
    double& largest = blows_[watch.event];
    largest = std::max(largest, -before);
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
  record.impulse = system_.impact(t_, record.q, record.qd_after, impact, restitution);
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
  record.impulse = system_.impact(t_, record.q, record.qd_after, impact, 0);
  return true;
}

/// Rows that strike may ask for what led ones do not allow.
void Simulator::judge_impact() {
  const auto [missing, most] = system_.unmet();
  if (missing.size <= kUnmet * most) {
    return;
  }
  if (!std::isfinite(missing.size)) {
    refuse_lead(missing.constraint, "rate");
  }
  const model::Constraint& constraint = scene_.constraints[to_index(missing.constraint)];
  const char* const unit = model::is_angular(scene_.tree, constraint) ? "1/s" : "m/s";
  monitor_.note(
      {"impact", constraint.name, t_, missing.size, kUnmet * most, unit,
       fmt::format("constraint '{}' lacks {:.3g} {} of the change of its speed that the "
                   "impact at t = {:.6g} s should make: constraints contradict each other",
                   constraint.name, missing.size, unit, t_)});
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
  if (event.impact) {
    judge_impact();
  }
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
