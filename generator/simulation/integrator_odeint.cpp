// Methods with an error estimate, from Boost.odeint.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <vector>

#include "simulation/integrator.hpp"

namespace treedyn::simulation {

namespace {

using OdeintState = std::vector<double>;
namespace odeint = boost::numeric::odeint;

void copy(const OdeintState& from, Vector& to) {
  to = VectorMap(from.data(), static_cast<Eigen::Index>(from.size()));
}

/// b of the stages; the last of Dormand and Prince's is the first of the next step.
const std::vector<double>& weights_of_order(int order) {
  static const std::vector<double> dopri5 = {
      35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0};
  static const std::vector<double> fehlberg78 = {
      0,        0,         0,         0, 0,          34.0 / 105, 9.0 / 35,
      9.0 / 35, 9.0 / 280, 9.0 / 280, 0, 41.0 / 840, 41.0 / 840};
  return order == 4 ? dopri5 : fehlberg78;
}

/// The error of Fehlberg's method where its own estimate says nothing. That compares rates at the
/// beginning and at the end of the step only, and they agree wherever forces follow t or a
/// coordinate of constant speed. The last stages are Newton and Cotes' seven points, whose rule is
/// wrong by 9/8400 h of the eighth difference: what the fourth and fifth ones let expect if
/// differences go on to shrink as they do.
///
/// \param rates  of the 13 stages
/// \return of component k, 1/h of it
double cotes_error(const std::vector<OdeintState>& rates, std::size_t k) {
  static constexpr std::array<std::size_t, 7> kStages = {11, 7, 9, 5, 8, 6, 12};  // by time
  std::array<double, 7> f{};
  for (std::size_t i = 0; i < f.size(); ++i) {
    f[i] = rates[kStages[i]][k];
  }
  double fourth = 0;
  double fifth = 0;
  for (std::size_t order = 1; order <= 5; ++order) {
    for (std::size_t i = 0; i + order < f.size(); ++i) {
      f[i] = f[i + 1] - f[i];
      double& largest = order == 4 ? fourth : fifth;
      largest = order < 4 ? 0 : std::max(largest, std::fabs(f[i]));
    }
  }
  const double ratio = fifth < fourth ? fifth / fourth : 1;
  return 9.0 / 8400 * fourth * std::pow(ratio, 4);
}

template <class Stepper, int order>
class OdeintIntegrator final : public Integrator {
 public:
  void step(const Rate& rate, double t, double h, const Vector& y, Vector& result,
            Vector& error) override {
    const auto system = [&](const OdeintState& x, OdeintState& dxdt, double time) {
      copy(x, x_);
      rate(time, x_, rate_);
      std::ranges::copy(rate_, dxdt.begin());
      if constexpr (order == 7) {
        rates_.push_back(dxdt);
      }
    };
    rates_.clear();
    from_.assign(y.begin(), y.end());
    to_.resize(from_.size());
    error_.resize(from_.size());
    derivative_.resize(from_.size());
    system(from_, derivative_, t);
    run(system, t, h);
    copy(to_, result);
    copy(error_, error);
  }
  [[nodiscard]] int error_order() const override { return order; }
  [[nodiscard]] const std::vector<double>& weights() const override {
    return weights_of_order(order);
  }

 private:
  template <class System>
  void run(const System& system, double t, double h) {
    if constexpr (order == 4) {
      OdeintState end(from_.size());
      stepper_.do_step(system, from_, derivative_, t, to_, end, h, error_);
    } else {
      stepper_.do_step(system, from_, derivative_, t, to_, h, error_);
      for (std::size_t k = 0; k < error_.size(); ++k) {
        error_[k] = std::max(std::fabs(error_[k]), std::fabs(h) * cotes_error(rates_, k));
      }
    }
  }

  Stepper stepper_;
  OdeintState from_, to_, error_, derivative_;
  std::vector<OdeintState> rates_;  ///< of the stages of Fehlberg's method
  Vector x_, rate_;
};

}  // namespace

std::unique_ptr<Integrator> make_dopri5() {
  return std::make_unique<OdeintIntegrator<odeint::runge_kutta_dopri5<OdeintState>, 4>>();
}

std::unique_ptr<Integrator> make_fehlberg78() {
  return std::make_unique<OdeintIntegrator<odeint::runge_kutta_fehlberg78<OdeintState>, 7>>();
}

}  // namespace treedyn::simulation
