// Every integrator against exact solutions of its own differential equation.
#include "simulation/integrator.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace treedyn::simulation {
namespace {

/// x'' = -x with x(0) = 1, x'(0) = 0: error of (x; x') at t = 1 with n equal steps.
double oscillator_error(const std::string& name, int n) {
  const auto integrator = make_integrator(name);
  const Rate rate = [](double, const Vector& y, Vector& dy) {
    dy.resize(2);
    dy << y[1], -y[0];
  };
  Vector y(2);
  y << 1, 0;
  Vector next;
  Vector error;
  for (int k = 0; k < n; ++k) {
    integrator->step(rate, static_cast<double>(k) / n, 1.0 / n, y, next, error);
    y = next;
  }
  return (y - Eigen::Vector2d(std::cos(1.0), -std::sin(1.0))).norm();
}

/// Halving the step divides the error by 2^order; 0.35 of an order covers the next term of the
/// expansion at these steps.
void expect_order(const std::string& name, int order, int n) {
  const double rate = std::log2(oscillator_error(name, n) / oscillator_error(name, 2 * n));
  EXPECT_NEAR(rate, order, 0.35) << name;
}

TEST(Integrators, ConvergeWithTheirOrder) {
  expect_order("semi-implicit-euler", 1, 64);
  expect_order("sdirk2", 2, 64);
  expect_order("rk4", 4, 32);
  expect_order("dopri5", 5, 16);
  expect_order("dopri5-fixed", 5, 16);
  expect_order("fehlberg78", 8, 3);
}

TEST(Integrators, OfDormandAndPrinceAgree) {
  EXPECT_EQ(oscillator_error("dopri5", 20), oscillator_error("dopri5-fixed", 20));
}

/// |x| after some steps of 0.01 of x'' = -1e8 x - 2e4 x' from 1: both roots are -1e4, the exact
/// solution is gone after one.
double stiff_oscillator(const char* name, int steps) {
  const auto integrator = make_integrator(name);
  const Rate rate = [](double, const Vector& y, Vector& dy) {
    dy.resize(2);
    dy << y[1], -1e8 * y[0] - 2e4 * y[1];
  };
  Vector y(2);
  y << 1, 0;
  Vector next;
  Vector error;
  for (int k = 0; k < steps; ++k) {
    integrator->step(rate, 0, 0.01, y, next, error);
    y = next;
  }
  return std::fabs(y[0]);
}

TEST(Sdirk2, DampsWhatIsStifferThanTheStep) { EXPECT_LT(stiff_oscillator("sdirk2", 10), 1e-6); }

TEST(Rk4, IsUnstableWhereSdirk2IsNot) { EXPECT_GT(stiff_oscillator("rk4", 3), 1e6); }

TEST(Integrators, AreFoundByTheirNames) {
  for (const IntegratorRow& row : integrators()) {
    EXPECT_NE(make_integrator(row.name), nullptr) << row.name;
  }
  EXPECT_EQ(make_integrator("euler"), nullptr);
}

}  // namespace
}  // namespace treedyn::simulation
