// Steps a scene in time: integration, drift, events, impacts and phases.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "simulation/dense.hpp"
#include "simulation/integrator.hpp"
#include "simulation/monitor.hpp"
#include "simulation/stability.hpp"
#include "simulation/system.hpp"
#include "simulation/time_scale.hpp"
#include "simulation/watch.hpp"

namespace treedyn::simulation {

struct Settings {
  std::string integrator = "fehlberg78";
  double step = 1e-3;        ///< s, methods with fixed steps
  double longest = 0;        ///< s, adaptive methods; 0: as long as the tolerance allows
  double tolerance = 1e-10;  ///< error of a step, relative and absolute, adaptive methods
  double most_steps =
      1e7;  ///< beyond which a motion is not begun or gone on with, those that events end included
  Drift drift = Drift::kProjection;
  double stabilisation = 20;  ///< alpha of Baumgarte, 1/s
  Bounds bounds;

  /// Alpha if Baumgarte's stabilisation acts, else 0.
  [[nodiscard]] double baumgarte() const { return drift == Drift::kBaumgarte ? stabilisation : 0; }
};

/// Between places where guards are looked at joints turn by less than this in all, rad, and a step
/// by less than kTurns times this.
inline constexpr double kTurn = 0.5;
inline constexpr int kTurns = 64;
/// Steps after which a motion that would need Settings::most_steps more of them, at their length,
/// ends.
inline constexpr long kTrial = 1000;
/// Steps instead of Settings::most_steps for a constraint that no joint moves where it begins to
/// act.
inline constexpr double kHopelessWhereStuck = 1e5;

/// What one event of a phase did.
struct EventRecord {
  double time = 0;
  int phase = 0;     ///< the one that ended
  std::string name;  ///< event_name
  int then = 0;      ///< the phase that follows
  Vector q;
  Vector qd_before;
  Vector qd_after;
  Vector impulse;  ///< rows of the impact, N s or N m s
};

/// What a run has cost.
struct Cost {
  long steps = 0;
  long rejected = 0;     ///< steps that were too long for the tolerance
  long evaluations = 0;  ///< of the accelerations, those in between for events and rows included
};

/// What advances the time t at all, s.
double least_step(double t);

/// The largest change of q or of qd, and of which of q and behind it qd.
struct Move {
  double size = 0;
  int place = 0;
};

/// Steps are those of the dynamics: neither the end of the motion nor rows of a table change them,
/// but for the last one. Methods with fixed steps stop at t0 + k step, and at events in between.
class Simulator {
 public:
  /// \pre `settings.integrator` is one of integrators()
  Simulator(const model::Scene& scene, Dynamics& dynamics, const Settings& settings);

  /// Moves the initial state onto the constraints that act.
  /// \throws std::runtime_error if that fails
  std::array<Move, 2> settle();

  using Observe = std::function<bool()>;
  /// Integrates and lands exactly on `end`; calls `observe` after every step and event, and stops
  /// when this is false. \return true if it arrives
  /// \throws std::runtime_error if A is singular, the state ceases to be finite, events pile up, a
  /// step no longer advances time, or a promise is broken (Bounds)
  bool advance_to(double end, const Observe& observe);

  using Show = std::function<void()>;
  /// Calls `show` at t0 + k step for k = 1, 2, .. and right before every event; the simulator is in
  /// that state meanwhile. States inside a step are those of a shorter step from its beginning.
  void show_at(double step, Show show);
  /// Another one computes the motion: the state is set to what it says.
  /// \throws std::runtime_error if its constraints are off beyond the bound
  void place(double time, const Vector& q, const Vector& qd, int phase,
             const std::vector<int>& active);
  /// From there it moves to `next`, (q; qd), in a step of length h: its energy.
  /// \param jumps  whether its phase changed or it was struck meanwhile: what that takes is no work
  /// \throws std::runtime_error if that grows without power beyond the bound
  void follow(double h, const Vector& next, bool jumps);
  /// An event that it noted.
  void note(const EventRecord& event) { events_.push_back(event); }

  [[nodiscard]] double time() const { return t_; }
  [[nodiscard]] Vector q() const { return y_.head(y_.size() / 2); }
  [[nodiscard]] Vector qd() const { return y_.tail(y_.size() / 2); }
  [[nodiscard]] int phase() const { return phase_; }
  [[nodiscard]] long steps() const { return cost_.steps; }
  [[nodiscard]] const Cost& cost() const { return cost_; }
  [[nodiscard]] const std::vector<EventRecord>& events() const { return events_; }
  [[nodiscard]] const Monitor& monitor() const { return monitor_; }
  /// Stability limits in the state of now; a warning if the step of the method exceeds its own.
  Stability stability(Dynamics& dynamics);
  /// A warning if the step of a method with fixed steps exceeds its limit at rest: where speeds
  /// that forces oppose on both sides, and that few steps end, are zero. What holds a body there
  /// is stiffest then. Contacts count that touch.
  void judge_rest(Dynamics& dynamics);
  /// Accelerations and reactions now.
  const Solution& solution() { return system_.accelerate(t_, q(), qd()); }
  System& system() { return system_; }

 private:
  struct Crossing {
    std::size_t watch;
    double step;  ///< from the beginning of the step, s
  };

  /// The end of a rest that nobody has asked for.
  struct LiftOff {
    model::Event event;
    std::vector<int> constraints;  ///< that act no longer
  };

  [[nodiscard]] bool lands(const model::Event& event) const;
  Stability stability(Dynamics& dynamics, const Vector& qd, Closed contacts);
  void note_limit(const Stability& stability, const std::string& kind, const std::string& state);
  [[noreturn]] void refuse_lead(int constraint, const char* what) const;
  void refuse_undefined_rows();
  void rate(double t, const Vector& y, Vector& dy);
  void take(double h);
  double fixed_step(double longest);
  double adaptive_step(double longest);
  double error_ratio(double h);
  double resolved_by(double h);
  double resolved(const Motion& motion, double longest);
  std::pair<Vector, Vector> coordinates(const Vector& y);
  void propose();
  double longest_step(double longest);
  [[nodiscard]] double least_step() const;
  [[nodiscard]] double goal(double end) const;
  /// Times of a motion in steps of this length that differ by less are the same.
  [[nodiscard]] double same_time(double step) const;
  void land(double h, double time);
  void project(double t, Vector& y);
  void show_between(double h, double end);
  void show_now(double end);
  void guard_against_standstill(double end);

  void start_phase(int phase, const std::vector<int>& active);
  void build_watches();
  void note_below(const Watch& watch, double t, const Vector& y);
  double slope_of(const Watch& watch, const Vector& y);
  void strike_expression(const Watch& watch);
  void refuse_small_rebounds(const Watch& watch, double t, const Vector& y);
  [[nodiscard]] double resolution(double step) const;
  bool is_still_to_come(const Watch& watch, const Watch* same);
  void add_watch(const std::vector<Watch>& before, Watch::Kind kind, std::size_t index, int point,
                 const model::Plane& plane);
  std::optional<Crossing> first_crossing(double h);
  void look_for(std::size_t k, double h, std::optional<Crossing>& first);
  [[nodiscard]] int pieces(double h) const;
  double refine(const Watch& watch, double low, double high, double h);
  void happen(Watch& watch);
  static void stick_or_slip(System& system, double t, const Vector& y, std::size_t k);
  void fire(std::size_t index);
  void lift_off(const LiftOff& rest);
  void add_lift_off(const model::Event& event);
  [[nodiscard]] const model::Event& event_at(std::size_t event) const;
  [[nodiscard]] std::string name_of(std::size_t event) const;
  bool strike(const model::Event& event, EventRecord& record);
  void judge_impact();
  void guard_against_pile(const Watch& watch);

  const model::Scene& scene_;
  Settings settings_;
  System system_;
  Monitor monitor_;
  std::unique_ptr<Integrator> integrator_;
  Rate rate_;
  double start_;
  double t_;
  Vector y_, next_, error_, trial_, trial_error_;
  Vector qdd_;                  ///< at the beginning of the step
  Vector expected_;             ///< of the next one, or of this one before it is taken
  std::vector<double> powers_;  ///< of the calls of `rate` in this step
  std::vector<Turn> turns_;     ///< of the same
  double suggested_ = 0;        ///< 0: to be proposed
  double last_ = 0;             ///< length of the step before
  bool looked_ = false;         ///< at the row equations of this step
  bool began_ = false;  ///< a phase: its first step ends on rows that may have begun at a speed
  int phase_ = 0;
  double phase_start_ = 0;
  Cost cost_;
  int pile_ = 0;  ///< of events at the instant of the last one
  double happened_ = -std::numeric_limits<double>::infinity();  ///< s, the last one
  double trial_start_ = 0;
  std::size_t trial_events_ = 0;
  double show_step_ = 0;
  long shown_ = 0;
  Show show_;
  Dense dense_;
  std::vector<Changing> changing_;  ///< forces and what else is no constant
  std::vector<Changing> guards_;    ///< expressions that events wait for
  double scale_ = 0;                ///< in which they have no pulse, s
  std::vector<int> turning_;        ///< revolute coordinates
  std::vector<Watch> watches_;
  std::vector<LiftOff> lift_offs_;               ///< events behind those of the phase
  std::set<const model::Event*> rebounded_;      ///< whose impacts turned their expressions upwards
  std::map<const model::Event*, double> blows_;  ///< the largest rates at which they did
  Vector arrived_;                               ///< where the last event has happened, before it
  std::vector<EventRecord> events_;
};

}  // namespace treedyn::simulation
