#include "simulation/integrator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::simulation {

namespace {

/// Steps of Newton's iteration with one Jacobian, Jacobians of an implicit stage, and the
/// change of the state, relative to 1 + its size, that ends it.
constexpr int kNewtonSteps = 8;
constexpr int kJacobians = 6;
constexpr double kNewtonChange = 1e-13;
/// A change that is small enough when the iteration gets no further.
constexpr double kNewtonEnough = 1e-11;
/// Relative difference step of the Jacobian, the root of the rounding of double.
constexpr double kDifference = 1.5e-8;

/// qd+ = qd + h qdd(q, qd), q+ = q + h qd+.
class SemiImplicitEuler final : public Integrator {
 public:
  void step(const Rate& rate, double t, double h, const Vector& y, Vector& result,
            Vector& error) override {
    const Eigen::Index n = y.size() / 2;
    rate(t, y, k_);
    result = y;
    result.tail(n) += h * k_.tail(n);
    result.head(n) += h * result.tail(n);
    error.resize(0);
  }
  [[nodiscard]] const std::vector<double>& weights() const override { return weights_; }

 private:
  std::vector<double> weights_ = {1};
  Vector k_;
};

/// The classical method of order 4.
class Rk4 final : public Integrator {
 public:
  void step(const Rate& rate, double t, double h, const Vector& y, Vector& result,
            Vector& error) override {
    rate(t, y, k1_);
    rate(t + h / 2, y + h / 2 * k1_, k2_);
    rate(t + h / 2, y + h / 2 * k2_, k3_);
    rate(t + h, y + h * k3_, k4_);
    result = y + h / 6 * (k1_ + 2 * k2_ + 2 * k3_ + k4_);
    error.resize(0);
  }
  [[nodiscard]] const std::vector<double>& weights() const override { return weights_; }

 private:
  std::vector<double> weights_ = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  Vector k1_, k2_, k3_, k4_;
};

/// An integrator without its error estimate: steps are as long as asked for.
class FixedDopri5 final : public Integrator {
 public:
  void step(const Rate& rate, double t, double h, const Vector& y, Vector& result,
            Vector& error) override {
    method_->step(rate, t, h, y, result, error);
    error.resize(0);
  }
  [[nodiscard]] const std::vector<double>& weights() const override { return method_->weights(); }

 private:
  std::unique_ptr<Integrator> method_ = make_dopri5();
};

/// Two implicit stages of order 2, L-stable: gamma = 1 - 1/sqrt(2) (Alexander, 1977).
class Sdirk2 final : public Integrator {
 public:
  void step(const Rate& rate, double t, double h, const Vector& y, Vector& result,
            Vector& error) override {
    const double gamma = 1 - std::sqrt(0.5);
    weights_.clear();
    call(rate, t, y, k1_);
    factor(rate, t, h * gamma, y);
    stage(rate, t + gamma * h, h * gamma, y, k1_);
    weights_.back() = 1 - gamma;
    k2_ = k1_;
    stage(rate, t + h, h * gamma, y + h * (1 - gamma) * k1_, k2_);
    weights_.back() = gamma;
    result = y + h * ((1 - gamma) * k1_ + gamma * k2_);
    error.resize(0);
  }
  [[nodiscard]] const std::vector<double>& weights() const override { return weights_; }

 private:
  void call(const Rate& rate, double t, const Vector& y, Vector& dy) {
    rate(t, y, dy);
    weights_.push_back(0);
  }

  /// E - h gamma df/dy where the motion goes, by differences in this direction: at the edge of a
  /// contact these see the contact.
  void factor(const Rate& rate, double t, double hg, const Vector& y) {
    Vector f;
    call(rate, t, y, rate_);
    call(rate, t, y + hg * rate_, f);
    Vector moved = y + hg * f;
    const Vector ahead = f;
    call(rate, t, moved, rate_);
    Eigen::MatrixXd M = Eigen::MatrixXd::Identity(y.size(), y.size());
    for (Eigen::Index k = 0; k < y.size(); ++k) {
      const double x = moved[k];
      const double d = std::copysign(kDifference * std::max(1.0, std::fabs(x)), ahead[k]);
      moved[k] = x + d;
      call(rate, t, moved, f);
      M.col(k) -= hg / d * (f - rate_);
      moved[k] = x;
    }
    lu_.compute(M);
  }

  /// k = f(t, y + h gamma k) by simplified Newton steps; a new Jacobian where these do not
  /// converge. Not a number if nothing helps: the step is too long.
  void stage(const Rate& rate, double t, double hg, const Vector& y, Vector& k) {
    for (int jacobian = 0; jacobian < kJacobians; ++jacobian) {
      double last = 0;
      for (int n = 0; n < kNewtonSteps; ++n) {
        call(rate, t, y + hg * k, rate_);
        const Vector change = lu_.solve(rate_ - k);
        k += change;
        last = hg * change.norm() / (1 + y.norm());  // of the state that it makes
        if (!(last > kNewtonChange)) {
          return;
        }
      }
      if (last < kNewtonEnough) {
        return;
      }
      factor(rate, t, hg, y + hg * k);
    }
    k.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Vector rate_, k1_, k2_;
  std::vector<double> weights_;
};

template <class Method>
std::unique_ptr<Integrator> make() {
  return std::make_unique<Method>();
}

constexpr std::array<IntegratorRow, 6> kIntegrators = {{
    {"fehlberg78", "adaptive, order 8 with an estimate of order 7", make_fehlberg78},
    {"dopri5", "adaptive, order 5 with an estimate of order 4", make_dopri5},
    {"dopri5-fixed", "fixed steps, order 5", make<FixedDopri5>},
    {"rk4", "fixed steps, order 4", make<Rk4>},
    {"semi-implicit-euler", "fixed steps, order 1, symplectic", make<SemiImplicitEuler>},
    {"sdirk2", "fixed steps, implicit, order 2, for stiff contact", make<Sdirk2>},
}};

}  // namespace

std::span<const IntegratorRow> integrators() { return kIntegrators; }

std::unique_ptr<Integrator> make_integrator(std::string_view name) {
  const auto found = std::ranges::find(kIntegrators, name, &IntegratorRow::name);
  return found == kIntegrators.end() ? nullptr : found->make();
}

void require_integrator(const model::Stepping& stepping) {
  if (make_integrator(stepping.integrator) == nullptr) {
    throw InputError(stepping.where, fmt::format("stepping: integrator '{}' is unknown; expected "
                                                 "one of treedyn list integrators",
                                                 shown(stepping.integrator)));
  }
}

}  // namespace treedyn::simulation
