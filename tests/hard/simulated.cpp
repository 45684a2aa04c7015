#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "dynamics/scene_dynamics.hpp"
#include "hard/motion.hpp"
#include "program/function.hpp"

namespace treedyn::hard {

namespace {

constexpr double kTolerance = 1e-12;

/// No bound is ever exceeded.
simulation::Bounds unbounded() {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  static_assert(sizeof(simulation::Bounds) == 11 * sizeof(double));
  return {kNever, kNever, kNever, kNever, kNever, kNever, kNever, kNever, kNever, kNever, kNever};
}

/// What motions have cost.
struct Count {
  long steps = 0;
  long evaluations = 0;
  double time = 0;  ///< s

  [[nodiscard]] double mean_step() const { return steps > 0 ? time / double(steps) : 0; }
};

class Counted final : public simulation::Dynamics {
 public:
  Counted(std::unique_ptr<simulation::Dynamics> inner, Count& count)
      : inner_(std::move(inner)), count_(count) {}
  void evaluate(const Vector& q, const Vector& qd, simulation::Terms& terms) override {
    ++count_.evaluations;
    inner_->evaluate(q, qd, terms);
  }
  void evaluate_geometry(const Vector& q, simulation::Terms& terms) override {
    inner_->evaluate_geometry(q, terms);
  }

 private:
  std::unique_ptr<simulation::Dynamics> inner_;
  Count& count_;
};

class SimulatedMotion final : public Motion {
 public:
  SimulatedMotion(const model::Scene& scene, std::unique_ptr<simulation::Dynamics> dynamics,
                  const simulation::Settings& how, Count& count)
      : scene_(scene),
        dynamics_(std::move(dynamics)),
        simulator_(scene, *dynamics_, how),
        count_(count) {}

  void advance_to(double end, const std::function<void()>& observe) override {
    const long before = simulator_.steps();
    const double start = simulator_.time();
    simulator_.advance_to(end, [&] {
      observe();
      return true;
    });
    count_.steps += simulator_.steps() - before;
    count_.time += simulator_.time() - start;
  }
  [[nodiscard]] double time() const override { return simulator_.time(); }
  [[nodiscard]] Vector q() const override { return simulator_.q(); }
  [[nodiscard]] Vector qd() const override { return simulator_.qd(); }
  [[nodiscard]] const std::vector<simulation::EventRecord>& events() const override {
    return simulator_.events();
  }
  const simulation::Solution& solution() override { return simulator_.solution(); }
  int rank() override { return solution().rank; }
  double residual() override { return solution().residual; }
  Strike strike_all() override;
  int slip_direction() override { return system().frictions().front().direction; }
  simulation::System& system() override { return simulator_.system(); }

 private:
  const model::Scene& scene_;
  std::unique_ptr<simulation::Dynamics> dynamics_;
  simulation::Simulator simulator_;
  Count& count_;
};

Strike SimulatedMotion::strike_all() {
  const std::vector<int> before = system().constraints().active();
  std::vector<int> all(scene_.constraints.size());
  std::iota(all.begin(), all.end(), 0);
  Strike result;
  result.qd = qd();
  result.impulse = system().impact(time(), q(), result.qd, {all}, 0);
  system().constraints().activate(all);
  const simulation::Solution& solution = system().accelerate(time(), q(), result.qd);
  result.qdd = solution.qdd;
  result.rank = solution.rank;
  system().constraints().activate(before);
  return result;
}

class SimulatorSource final : public Source {
 public:
  std::unique_ptr<Motion> motion(const model::Scene& scene) override {
    simulation::Settings how;
    how.integrator = "fehlberg78";
    how.tolerance = kTolerance;
    return motion_by(scene, how);
  }
  std::unique_ptr<Motion> motion(const model::Scene& scene, const std::string& integrator,
                                 double step) override {
    simulation::Settings how;
    how.integrator = integrator;
    how.step = step;
    how.bounds = unbounded();  // cases ask what happens beyond them
    return motion_by(scene, how);
  }
  double sensitivity(const model::Scene& scene) override {
    const std::unique_ptr<Motion> at_start = motion(scene);
    const Vector qdd = at_start->solution().qdd;
    at_start->system().set_rank_threshold(simulation::kRankThreshold / 10);
    return (at_start->solution().qdd - qdd).cwiseAbs().maxCoeff();
  }
  [[nodiscard]] std::string cost() const override {
    return fmt::format(
        "fehlberg78 to {:.0e}, {} steps of {:.3g} s on average, {} evaluations of {} operations",
        kTolerance, first_.steps, first_.mean_step(), first_.evaluations, operations_);
  }

 private:
  std::unique_ptr<Motion> motion_by(const model::Scene& scene, const simulation::Settings& how) {
    Count& count = operations_ < 0 ? first_ : others_;
    auto dynamics = std::make_unique<Counted>(program_dynamics(scene), count);
    if (operations_ < 0) {
      operations_ = program::cost(scene_programs(scene).terms).total();
    }
    return std::make_unique<SimulatedMotion>(scene, std::move(dynamics), how, count);
  }

  Count first_;  ///< of the first motion
  Count others_;
  int operations_ = -1;
};

}  // namespace

std::unique_ptr<Source> simulator_source() { return std::make_unique<SimulatorSource>(); }

}  // namespace treedyn::hard
