// Steps a scene in time: integration, drift, events, impacts and phases.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/integrator.hpp"
#include "simulation/system.hpp"
#include "simulation/watch.hpp"

namespace treedyn::simulation {

struct Settings {
  std::string integrator = "fehlberg78";
  double step = 1e-3;        ///< s, methods with fixed steps
  double longest = 0;        ///< s, adaptive methods; 0: kLongestStep
  double tolerance = 1e-10;  ///< error of a step, relative and absolute, adaptive methods
  Drift drift = Drift::kProjection;
  double stabilisation = 20;  ///< alpha of Baumgarte, 1/s
};

/// The longest adaptive step, and the shortest that is tried, as parts of the scene's duration.
inline constexpr double kLongestStep = 1.0 / 50;
inline constexpr double kShortestStep = 1e-11;

/// What one event of a phase did.
struct EventRecord {
  double time = 0;
  int phase = 0;  ///< the one that ended
  Vector q;
  Vector qd_before;
  Vector qd_after;
  Vector impulse;  ///< rows of the impact, N s or N m s
};

class Simulator {
 public:
  /// \pre `settings.integrator` is one of integrators()
  Simulator(const model::Scene& scene, Dynamics& dynamics, const Settings& settings);

  /// Moves the initial state onto the constraints that act. \return largest change of a coordinate
  /// or speed \throws std::runtime_error if that fails
  double settle();

  using Observe = std::function<bool()>;
  /// Integrates and lands exactly on `end`; calls `observe` after every step and event, and stops
  /// when this is false. \return true if it arrives
  /// \throws std::runtime_error if A is singular, the state ceases to be finite or events pile up
  bool advance_to(double end, const Observe& observe);

  /// Another one computes the motion: the state is set to what it says.
  void place(double time, const Vector& q, const Vector& qd, int phase,
             const std::vector<int>& active);
  /// An event that it noted.
  void note(const EventRecord& event) { events_.push_back(event); }

  [[nodiscard]] double time() const { return t_; }
  [[nodiscard]] Vector q() const { return y_.head(y_.size() / 2); }
  [[nodiscard]] Vector qd() const { return y_.tail(y_.size() / 2); }
  [[nodiscard]] int phase() const { return phase_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] const std::vector<EventRecord>& events() const { return events_; }
  /// Accelerations and reactions now.
  const Solution& solution() { return system_.accelerate(t_, q(), qd()); }
  System& system() { return system_; }

 private:
  struct Crossing {
    std::size_t watch;
    double step;  ///< from the beginning of the step, s
  };

  void rate(double t, const Vector& y, Vector& dy);
  double step(double longest);
  double error_ratio(double h);
  void start_phase(int phase, const std::vector<int>& active);
  void build_watches();
  void begin_watches();
  std::optional<Crossing> first_crossing(double h);
  double refine(Watch& watch, double low, double high);
  void happen(Watch& watch);
  void stick_or_slip(std::size_t friction);
  void fire(const model::Event& event);
  bool strike(const model::Event& event, EventRecord& record);
  void guard_against_pile();

  const model::Scene& scene_;
  Settings settings_;
  System system_;
  std::unique_ptr<Integrator> integrator_;
  Rate rate_;
  double t_;
  double duration_;
  Vector y_, next_, error_, trial_;
  double suggested_;
  int phase_ = 0;
  double phase_start_ = 0;
  long steps_ = 0;
  int pile_ = 0;
  std::vector<Watch> watches_;
  std::vector<EventRecord> events_;
};

}  // namespace treedyn::simulation
