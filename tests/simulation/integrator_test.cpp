// Every integrator against exact solutions of its own differential equation.
#include "simulation/integrator.hpp"

#include <algorithm>
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

/// v' = 3 / (0.01 + (x - 5.3)^2) with x' = 1: the rates at the beginning and at the end agree in
/// all stages. Steps that keep the tolerance by the estimate, halved or longer by a half: the
/// errors of all are at most as many tolerances.
TEST(Integrators, SeeForcesAlongACoordinateOfConstantSpeed) {
  constexpr double kTolerance = 1e-10;
  const Rate rate = [](double, const Vector& y, Vector& dy) {
    dy.resize(2);
    dy << 1, 3 / (0.01 + (y[0] - 5.3) * (y[0] - 5.3));
  };
  const double exact = 30 * (std::atan(47.0) + std::atan(53.0));
  for (const char* const name : {"fehlberg78", "dopri5"}) {
    const auto integrator = make_integrator(name);
    Vector y = Vector::Zero(2);
    Vector next;
    Vector error;
    int steps = 0;
    for (double h = 0.1; 10 - y[0] > 1e-12 && steps < 10000;) {
      h = std::min(h, 10 - y[0]);
      integrator->step(rate, 0, h, y, next, error);
      if (std::fabs(error[1]) > kTolerance * exact) {
        h /= 2;
        continue;
      }
      y = next;
      h *= 1.5;
      ++steps;
    }
    EXPECT_NEAR(y[1], exact, steps * kTolerance * exact) << name << ' ' << steps;
    EXPECT_LT(steps, 1000) << name;
  }
}

TEST(Integrators, AreFoundByTheirNames) {
  for (const IntegratorRow& row : integrators()) {
    EXPECT_NE(make_integrator(row.name), nullptr) << row.name;
  }
  EXPECT_EQ(make_integrator("euler"), nullptr);
}

}  // namespace
}  // namespace treedyn::simulation
