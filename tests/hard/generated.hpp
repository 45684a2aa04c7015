// Scenes stepped by their generated code.
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hard/code.hpp"
#include "simulation/pose.hpp"

namespace treedyn::hard {

class GeneratedSource;

/// The whole state of generated code, and how many steps led to it.
struct Moment {
  double t = 0;
  long number = 0;
  Vector q, qd;
  Numbers anchor;
  int state = 0;  ///< of Code::states
  int steps = 0;
  double begun = 0;  ///< s of the phase before them
};

/// What ended a phase; no event: something other than a landing.
struct Fall {
  const model::Event* event = nullptr;
  double time = 0;
};

/// Steps, and between their ends an interpolation in double: it only measures.
class GeneratedMotion final : public Motion {
 public:
  /// \param steps  grows with every step
  GeneratedMotion(const model::Scene& scene, std::shared_ptr<const Code> code,
                  const GeneratedSource& source, long& steps);

  void advance_to(double end, const std::function<void()>& observe) override;
  [[nodiscard]] double time() const override { return shown_.t; }
  [[nodiscard]] Vector q() const override { return shown_.q; }
  [[nodiscard]] Vector qd() const override { return shown_.qd; }
  [[nodiscard]] const std::vector<simulation::EventRecord>& events() const override {
    return events_;
  }
  const simulation::Solution& solution() override;
  int rank() override;
  double residual() override;
  Strike strike_all() override;
  int slip_direction() override;
  [[nodiscard]] double slip_time() const override { return events_.back().time; }
  simulation::System& system() override { return system_; }

 private:
  void begin(int state);
  [[nodiscard]] Arrays inputs(const Moment& moment) const;
  [[nodiscard]] Moment stepped(const Moment& moment);
  [[nodiscard]] Arrays dynamics(const Moment& moment, const Numbers& tau) const;
  [[nodiscard]] Vector acceleration(const Moment& moment) const;
  [[nodiscard]] Moment moved(const Moment& from, double s) const;
  [[nodiscard]] Moment between(const Moment& a, const Moment& b, double t) const;
  [[nodiscard]] std::pair<double, double> height(const model::Event& event,
                                                 const Moment& moment) const;
  [[nodiscard]] double guard(const model::Event& event, const Moment& moment) const;
  [[nodiscard]] std::optional<Fall> landing(const Moment& a, const Moment& b) const;
  [[nodiscard]] double fall_time(const model::Event& event, const Moment& a) const;
  void record(const Fall& fall, const Moment& a, const Moment& b);

  const model::Scene scene_;
  std::shared_ptr<const Code> code_;
  const GeneratedSource& source_;
  long& steps_;
  double h_;
  std::unique_ptr<simulation::Dynamics> dynamics_;
  simulation::System system_;
  simulation::Terms terms_;
  Moment now_;
  Moment shown_;
  std::vector<simulation::EventRecord> events_;
  simulation::Solution solution_;
};

/// How a scene is stepped.
struct Method {
  std::string name;
  double step = 0;  ///< s
};

class GeneratedSource final : public Source {
 public:
  explicit GeneratedSource(std::string scalar) : scalar_(std::move(scalar)) {}

  std::unique_ptr<Motion> motion(const model::Scene& scene) override;
  std::unique_ptr<Motion> motion(const model::Scene& scene, const std::string& integrator,
                                 double step) override;
  double sensitivity(const model::Scene& scene) override;
  [[nodiscard]] std::string cost() const override;

  [[nodiscard]] const std::string& scalar() const { return scalar_; }
  /// To the nearest of the scalar type.
  [[nodiscard]] double rounded(double x) const;
  /// Below this part of the largest a singular value is rounding.
  [[nodiscard]] double noise() const;

 private:
  struct Made {
    model::Scene scene;
    std::shared_ptr<const Code> code;
  };
  std::shared_ptr<const Code> code_of(const model::Scene& scene);

  std::string scalar_;
  std::list<Made> made_;
  Method method_;
  bool functions_only_ = false;
  long steps_ = 0;        ///< of the first motion
  long other_steps_ = 0;  ///< of all others
  long per_step_ = 0;
  long per_call_ = 0;
};

}  // namespace treedyn::hard
