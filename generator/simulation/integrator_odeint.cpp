// Methods with an error estimate, from Boost.odeint.
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
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

template <class Stepper, int order>
class OdeintIntegrator final : public Integrator {
 public:
  void step(const Rate& rate, double t, double h, const Vector& y, Vector& result,
            Vector& error) override {
    const auto system = [&](const OdeintState& x, OdeintState& dxdt, double time) {
      copy(x, x_);
      rate(time, x_, rate_);
      std::copy(rate_.begin(), rate_.end(), dxdt.begin());
    };
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
    }
  }

  Stepper stepper_;
  OdeintState from_, to_, error_, derivative_;
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
