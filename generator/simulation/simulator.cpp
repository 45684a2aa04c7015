#include "simulation/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "common/index.hpp"
#include "simulation/column_names.hpp"

namespace treedyn::simulation {

namespace {

/// Projections of an initial state, and the position error (m, rad) that it may keep.
constexpr int kSettlingSteps = 20;
constexpr double kSettled = 1e-8;
/// The velocity error (m/s, rad/s) that it may keep: what a singular position lets go is below it.
constexpr double kSettledSpeed = 1e-6;
/// Times that differ by less than this part of a step are the same, and those that differ by less
/// than so many roundings of a time.
constexpr double kSameTime = 1e-9;
constexpr double kSameRoundings = 4;
/// Where time stands still and more often than once in so many steps an event happens, these may be
/// the cause: each phase of a rocking block takes some steps, however short it is.
constexpr std::size_t kStepsOfAPhase = 50;

Vector to_vector(const std::vector<Real>& values) {
  Vector result(static_cast<Eigen::Index>(values.size()));
  std::ranges::transform(values, result.begin(),
                         [](const Real& x) { return static_cast<double>(x); });
  return result;
}

/// The part of the robot's size, or rad, that drift may reach where nothing is done against it.
constexpr double kDriftOfNone = 0.1;

/// Where drift is asked for, it ends the motion at kDriftOfNone instead of the usual bound, unless
/// a bound is asked for, too.
Bounds bounds_of(const Settings& settings) {
  Bounds result = settings.bounds;
  if (settings.drift == Drift::kNone && result.drift_end == Bounds{}.drift_end) {
    result.drift_end = kDriftOfNone;
  }
  return result;
}

std::vector<int> turning(const model::Tree& tree) {
  std::vector<int> result;
  for (int k = 0; k < tree.dof(); ++k) {
    if (tree.moved_by(k).joint.turns()) {
      result.push_back(k);
    }
  }
  return result;
}

}  // namespace

Simulator::Simulator(const model::Scene& scene, Dynamics& dynamics, const Settings& settings)
    : scene_(scene),
      settings_(settings),
      system_(scene, dynamics, settings.baumgarte()),
      monitor_(scene, bounds_of(settings)),
      integrator_(make_integrator(settings.integrator)),
      rate_([this](double t, const Vector& y, Vector& dy) { rate(t, y, dy); }),
      start_(static_cast<double>(scene.t0)),
      t_(start_),
      y_(2 * scene.tree.dof()),
      trial_start_(start_),
      changing_(changing_expressions(scene)),
      turning_(turning(scene.tree)) {
  y_ << to_vector(scene.q0), to_vector(scene.qd0);
  phase_start_ = t_;
  start_phase(scene.start_phase, scene.phases[static_cast<std::size_t>(scene.start_phase)].active);
  for (std::size_t k = 0; k < system_.frictions().size(); ++k) {
    stick_or_slip(system_, t_, y_, k);
  }
  build_watches();
  monitor_.restart_energy(system_, q(), qd());
}

void Simulator::rate(double t, const Vector& y, Vector& dy) {
  const Eigen::Index n = y.size() / 2;
  const Solution& solution = system_.accelerate(t, y.head(n), y.tail(n));
  ++cost_.evaluations;
  dy.resize(y.size());
  dy.head(n) = y.tail(n);
  dy.tail(n) = solution.qdd;
  if (powers_.empty()) {  // every method begins where the step does
    qdd_ = solution.qdd;
    if (!looked_) {
      looked_ = true;
      monitor_.row_equations(system_, t, last_);
    }
  }
  powers_.push_back(solution.power);
  turns_.push_back({solution.turn, solution.beside, solution.turning});
}

/// `next_`, a step of length h from here.
void Simulator::take(double h) {
  powers_.clear();
  turns_.clear();
  integrator_->step(rate_, t_, h, y_, next_, error_);
}

void Simulator::refuse_lead(int constraint, const char* what) const {
  throw std::runtime_error(fmt::format("constraint '{}' is led by what has no {} at t = {:.6g} s",
                                       scene_.constraints[to_index(constraint)].name, what, t_));
}

/// The place and the rate of what leads an acting row are numbers.
void Simulator::refuse_undefined_rows() {
  Constraints& constraints = system_.constraints();
  Vector errors;
  Vector wanted;
  constraints.errors(system_.geometry(q()), t_, q(), errors);
  constraints.velocities(t_, wanted);
  for (int k = 0; k < errors.size(); ++k) {
    if (!std::isfinite(errors[k]) || !std::isfinite(wanted[k])) {
      refuse_lead(constraints.constraint(k), std::isfinite(errors[k]) ? "rate" : "value");
    }
  }
}

std::array<Move, 2> Simulator::settle() {
  refuse_undefined_rows();
  Vector position = q();
  Vector velocity = qd();
  for (int k = 0; k < kSettlingSteps; ++k) {
    system_.project(t_, position, velocity);
  }
  const Vector before = y_;
  y_ << position, velocity;
  const auto refuse = [&](const char* what, const System::Violation& worst) {
    const std::string& name = scene_.constraints[static_cast<std::size_t>(worst.constraint)].name;
    throw std::runtime_error(fmt::format("{}: '{}' stays {:.3g} off", what, name, worst.size));
  };
  if (!y_.allFinite()) {
    throw std::runtime_error("the initial state meets the constraints nowhere in finite numbers");
  }
  const System::Violation of_place = system_.violation(t_, position);
  if (of_place.constraint >= 0 && !(of_place.size <= kSettled)) {
    refuse("the initial state is not near one that meets the constraints", of_place);
  }
  const System::Violation of_speed = system_.speed_violation(t_, position, velocity);
  if (of_speed.constraint >= 0 && !(of_speed.size <= kSettledSpeed)) {
    refuse("no velocity meets the constraints at the initial state", of_speed);
  }
  watches_.clear();  // contacts are open or closed by where their points are now
  build_watches();
  for (std::size_t k = 0; k < system_.frictions().size(); ++k) {  // joints may turn back now
    const DryFriction& friction = system_.frictions()[k];
    double& speed = y_[system_.dof() + friction.joint];
    speed = friction.direction == 0 ? 0 : speed;
    stick_or_slip(system_, t_, y_, k);
  }
  build_watches();
  monitor_.restart_energy(system_, position, velocity);
  monitor_.positions(system_, t_, position);
  for (const Watch& watch : watches_) {
    if (watch.armed) {
      note_below(watch, t_, y_);
    }
  }
  const auto largest = [&](int from) {
    Eigen::Index place = 0;
    const double size = (y_ - before).segment(from, system_.dof()).cwiseAbs().maxCoeff(&place);
    return Move{size, from + static_cast<int>(place)};
  };
  return {largest(0), largest(system_.dof())};
}

/// A touch-down whose point is below the plane without having been above since it is looked at; it
/// waits, which is told where the point begins so, or falls.
void Simulator::note_below(const Watch& watch, double t, const Vector& y) {
  const bool stops = watch.event != nullptr && (watch.event->impact || watch.lands);
  if (watch.kind != Watch::Kind::kEvent || !stops) {
    return;
  }
  const double depth = -watch.value(system_, t, y);
  if (depth > kOnPlane && (t <= start_ || watch.slope(system_, y) < -kAtRest)) {
    const std::string& name = scene_.points[static_cast<std::size_t>(watch.point)].name;
    monitor_.note({"below", name, t, depth, kOnPlane, "m",
                   fmt::format("at t = {:.6g} s point '{}' is {:.3g} m below the plane of its "
                               "touch_down, which waits until it has been above; a generated step "
                               "may let it touch down before",
                               t, name, depth)});
  }
}

double Simulator::same_time(double step) const {
  const double largest = std::max({std::fabs(t_), std::fabs(start_), std::fabs(t_ - start_)});
  return std::max(kSameTime * step,
                  kSameRoundings * std::numeric_limits<double>::epsilon() * largest);
}

/// Where the next step ends at the latest: the next t0 + k step, or the end.
double Simulator::goal(double end) const {
  if (integrator_->error_order() > 0) {
    return end;
  }
  const double same = same_time(settings_.step);
  const double k = std::floor((t_ - start_ + same) / settings_.step) + 1;
  const double next = start_ + k * settings_.step;
  return next < end - same ? next : end;
}

void Simulator::project(double t, Vector& y) {
  if (settings_.drift == Drift::kProjection) {
    const Eigen::Index n = y.size() / 2;
    Vector position = y.head(n);
    Vector velocity = y.tail(n);
    system_.project(t, position, velocity);
    y << position, velocity;
  }
}

/// The step of length h that ends in `next_` is done.
void Simulator::land(double h, double time) {
  const std::vector<double>& weights = integrator_->weights();
  const std::size_t calls = std::min(weights.size(), powers_.size());
  Work work{0, 0};
  for (std::size_t k = 0; k < calls; ++k) {
    work.done += h * weights[k] * powers_[k];
    work.power = std::max(work.power, std::fabs(powers_[k]));
    monitor_.turn(system_.constraints(), turns_[k], time, h * std::fabs(weights[k]));
  }
  if (!next_.allFinite()) {
    throw std::runtime_error(not_finite(scene_, time, {y_.begin(), y_.end()}));
  }
  Vector arrived = next_;
  project(time, arrived);
  if (settings_.drift == Drift::kProjection && !began_) {
    monitor_.pull(system_, time, arrived.tail(system_.dof()));
  }
  began_ = false;
  show_between(h, time);
  if (!arrived.allFinite()) {
    throw std::runtime_error(not_finite(scene_, time, {y_.begin(), y_.end()}));
  }
  t_ = time;
  y_ = arrived;
  last_ = h;
  ++cost_.steps;
  monitor_.drift(system_, t_, q());
  monitor_.energy(system_, t_, h, q(), qd(), work);
}

bool Simulator::advance_to(double end, const Observe& observe) {
  while (t_ < end) {
    looked_ = false;
    const double goal = this->goal(end);
    const double longest = goal - t_;
    const bool fixed = integrator_->error_order() == 0;
    double h = fixed ? fixed_step(longest) : adaptive_step(longest);
    if (fixed && !watches_.empty()) {
      expected_ = qdd_;
      longest_step(longest);
    }
    const std::optional<Crossing> crossing = first_crossing(h);
    if (crossing && crossing->step < h) {
      h = crossing->step;
      take(h);
    }
    land(h, h == longest ? goal : t_ + h);
    guard_against_standstill(end);
    show_now(end);
    if (crossing) {
      Watch& watch = watches_[crossing->watch];
      if (show_ && watch.ends_phase()) {
        show_();
      }
      happen(watch);
      build_watches();
      monitor_.restart_energy(system_, q(), qd());
      suggested_ = 0;
    }
    if (!observe()) {
      return false;
    }
  }
  return true;
}

void Simulator::place(double time, const Vector& q, const Vector& qd, int phase,
                      const std::vector<int>& active) {
  const Vector qd_before = this->qd();
  t_ = time;
  y_ << q, qd;
  if (phase != phase_ || active != system_.constraints().active()) {
    const std::vector<int> acted = system_.constraints().active();
    start_phase(phase, active);
    monitor_.speeds(system_, t_, q, qd, qd_before, acted);
  }
  for (std::size_t k = 0; k < scene_.contacts.size(); ++k) {
    system_.forces().touch(k, true);  // the depth tells
  }
  for (DryFriction& friction : system_.frictions()) {
    const double speed = qd[friction.joint];
    friction.direction = speed > 0 ? 1 : speed < 0 ? -1 : 0;
  }
  monitor_.drift(system_, t_, q);
}

void Simulator::follow(double h, const Vector& next, bool jumps) {
  const Eigen::Index n = system_.dof();
  const Vector position = next.head(n);
  const Vector velocity = next.tail(n);
  if (jumps) {
    monitor_.restart_energy(system_, position, velocity);
    return;
  }
  const Solution begin = system_.accelerate(t_, q(), qd());
  const Solution end = system_.accelerate(t_ + h, position, velocity);
  dense_.set(h, y_, begin.qdd, next, end.qdd);
  const Vector middle = dense_.at(0.5);
  const Solution& half = system_.accelerate(t_ + h / 2, middle.head(n), middle.tail(n));
  const Work work{h / 6 * (begin.power + 4 * half.power + end.power),
                  std::max({std::fabs(begin.power), std::fabs(half.power), std::fabs(end.power)})};
  monitor_.energy(system_, t_ + h, h, position, velocity, work);
}

void Simulator::show_at(double step, Show show) {
  show_step_ = step;
  show_ = std::move(show);
}

/// Rows inside the step of length h from here to `end`.
void Simulator::show_between(double h, double end) {
  if (!show_) {
    return;
  }
  const double from = t_;
  const Vector state = y_;
  const auto row = [&] {
    return start_ + static_cast<double>(shown_ + 1) * show_step_;
  };
  for (; row() < end - same_time(std::min(h, show_step_)); ++shown_) {
    const double time = row();
    integrator_->step(rate_, from, time - from, state, trial_, trial_error_);
    project(time, trial_);
    if (!trial_.allFinite()) {
      throw std::runtime_error(not_finite(scene_, time, {state.begin(), state.end()}));
    }
    t_ = time;
    y_ = trial_;
    show_();
    t_ = from;
    y_ = state;
  }
}

/// The row of now, if there is one; its time is t0 + k step, or the end of the motion.
void Simulator::show_now(double end) {
  const double row = start_ + static_cast<double>(shown_ + 1) * show_step_;
  if (!show_ || row > t_ + same_time(std::min(last_, show_step_))) {
    return;
  }
  const double now = t_;
  t_ = now == end ? now : row;
  ++shown_;
  show_();
  t_ = now;
}

/// Steps that would never arrive: adaptive ones, and those of any method that events cut short.
void Simulator::guard_against_standstill(double end) {
  if (static_cast<double>(cost_.steps) >= settings_.most_steps && t_ < end) {
    throw std::runtime_error(fmt::format("{} steps are made (--max-steps)", cost_.steps));
  }
  if (cost_.steps % kTrial != 0) {
    return;
  }
  const double advance = t_ - trial_start_;
  const std::size_t ended = events_.size() - trial_events_;
  trial_start_ = t_;
  trial_events_ = events_.size();
  const std::vector<Notice>& notices = monitor_.notices();
  const bool stuck =
      integrator_->error_order() > 0 &&
      std::ranges::any_of(notices, [](const Notice& notice) { return notice.kind == "position"; });
  const double most =
      stuck ? std::min(kHopelessWhereStuck, settings_.most_steps) : settings_.most_steps;
  if (advance * (most / static_cast<double>(kTrial)) < end - t_) {
    if (2 * ended > static_cast<std::size_t>(kTrial)) {
      const model::Phase& phase = scene_.phases[static_cast<std::size_t>(events_.back().phase)];
      throw std::runtime_error(fmt::format(
          "events hardly let time advance: {} of them in {} steps, {:.2g} s in all, '{}' of phase "
          "'{}' the last, at t = {} s; more than {:.2g} steps for the rest (phases that last "
          "longer, or --max-steps)",
          ended, kTrial, advance, events_.back().name, phase.name, t_, most));
    }
    throw std::runtime_error(fmt::format(
        "steps hardly advance time: {} of them, {:.2g} s in all, at t = {} s; more than {:.2g} for "
        "the rest ({}a shorter duration, --max-steps or, if the scene is stiff, --integrator "
        "sdirk2)",
        kTrial, advance, t_, most,
        ended * kStepsOfAPhase > static_cast<std::size_t>(kTrial)
            ? fmt::format("{} events, '{}' the last: phases that last longer; or ", ended,
                          events_.back().name)
            : ""));
  }
}

}  // namespace treedyn::simulation
