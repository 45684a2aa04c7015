// Steps of a ball: bounces, rest, lift-off, events in time, and contact that is stiff.
#include "scenes/ball.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace treedyn::support {
namespace {

/// A ball under a gravity of 10 that pulls away from a plane, which it only grazes.
std::string grazing(const std::string& event, const std::string& gravity,
                    const std::string& integrator) {
  return "effects:\n  gravity: [0, 0, " + gravity +
         "]\n  point_constraint: [{name: floor, point: tip, along: [z]}]\nphases:\n  - name: fall\n"
         "    active: []\n    until:\n      - " +
         event +
         "\n        impact: {constraints: [floor], restitution: 1}\n        then: fall\n"
         "duration: 1\nstepping: {integrator: " +
         integrator + ", step: 0.02}\n";
}

/// z and its speed behind one step, if the ball rebounds at the plane: 4.5e-4 m from it at 0.1 m/s
/// it would be 5e-5 m behind it and back within the step.
void expect_rebound(const BallCode& scene, double start, double side) {
  const Measurement step =
      scene.code().measure("step", {{start + side * 4.5e-4}, {-side * 0.1}, {0}});
  ASSERT_EQ(step.status, 0);
  const double speed = std::sqrt(0.1 * 0.1 - 2 * 10 * 4.5e-4);
  const double rest = 0.02 - (0.1 - speed) / 10;
  const double late = 1e-5 * 0.02;  // s: three cuts
  EXPECT_NEAR(step.values.at(0), start + side * (speed * rest + 5 * rest * rest), 0.4 * late);
  EXPECT_NEAR(step.values.at(1), side * (speed + 10 * rest), 20 * late);
}

TEST(PhaseStep, SeesGuardsThatFallAndRiseWithinAStep) {
  for (const std::string integrator : {"rk4", "dopri5-fixed", "sdirk2"}) {
    SCOPED_TRACE(integrator);
    expect_rebound(BallCode(grazing("touch_down: {point: tip}", "10", integrator)), 0, 1);
    expect_rebound(BallCode(grazing("expression: 0.3 - q[height]", "-10", integrator)), 0.3, -1);
  }
}

/// Euler's shorter steps from 2e-4 m: z = 2e-4 - 0.1 s + 10 s^2, below zero from 2.76 ms on.
TEST(PhaseStep, SeesThemInEulersStepsToo) {
  const BallCode scene(grazing("touch_down: {point: tip}", "10", "semi-implicit-euler"));
  const Measurement step = scene.code().measure("step", {{2e-4}, {-0.1}, {0}});
  const double until = (0.1 - std::sqrt(0.01 - 40 * 2e-4)) / 20;
  const double rest = 0.02 - until;
  const double speed = 0.1 - 10 * until;
  EXPECT_NEAR(step.values.at(1), speed + 10 * rest, 1e-4);
  EXPECT_NEAR(step.values.at(0), rest * (speed + 10 * rest), 1e-5);
}

TEST(PhaseStep, BouncesAndComesToRest) {
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: floor, point: tip, along: "
      "[z]}]\n"
      "phases:\n  - name: fall\n    active: []\n    until:\n      - touch_down: {point: tip}\n"
      "        impact: {constraints: [floor], restitution: 0.5, rest_below: 0.1}\n        then: "
      "fall\n"
      "duration: 3\nstepping: {integrator: semi-implicit-euler, step: 1e-3}\n");
  EXPECT_NE(scene.header().find("fall_at_rest = 1"), std::string::npos);
  constexpr double h = 1e-3;
  double z = 1;
  double v = 0;
  int bounces = 0;
  bool rests = false;
  Vector q = {z};
  Vector qd = {v};
  Vector phase = {0};
  const auto move = [&](double time) {
    v -= time * 10;
    z += time * v;
  };
  for (int k = 0; k < 3000; ++k) {
    double left = h;
    while (!rests && z + left * (v - left * 10) < 0) {  // z + s (v - 10 s) = 0
      const double s = (v + std::sqrt(v * v + 40 * z)) / 20;
      move(s);
      z = 0;
      ++bounces;
      v = -0.5 * v;
      rests = v < 0.1;
      v = rests ? 0 : v;
      left -= s;
    }
    if (!rests) {
      move(left);
    }
    const Vector next = scene.code().call("step", {q, qd, {0}, phase});
    q = {next.at(0)};
    qd = {next.at(1)};
    phase = {next.at(3)};
    // a bounce is late by a 16th of the last correction, 1e-11 s; 10 m/s^2 and up to 5 m/s
    ASSERT_NEAR(q[0], z, 1e-9) << "step " << k;
    ASSERT_NEAR(qd[0], v, 1e-9) << "step " << k;
    ASSERT_EQ(phase[0], rests ? 1 : 0) << "step " << k;
  }
  EXPECT_TRUE(rests);
  EXPECT_GE(bounces, 4);
  EXPECT_NEAR(scene.code().call("step", {q, qd, {0}, phase}).at(2), 10, 1e-12);
}

/// Height and speed of 1 kg that falls on ground of 1e6 N/m^1.5 and 0.3 s/m, by steps of 0.1 us of
/// the explicit midpoint rule.
std::pair<double, double> dropped(double time) {
  double z = 0.01;
  double v = -1;
  constexpr double h = 1e-7;
  const auto a = [&](double at, double speed) {
    const double law = at < 0 ? 1e6 * std::pow(-at, 1.5) * (1 - 0.3 * speed) : 0;
    return (law > 0 ? law : 0) - 10;
  };
  for (int k = 0; k < std::lround(time / h); ++k) {
    const double v_half = v + h / 2 * a(z, v);
    const double z_half = z + h / 2 * v;
    v += h * a(z_half, v_half);
    z += h * v_half;
  }
  return {z, v};
}

TEST(ImplicitStep, HoldsAStiffContact) {
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  ground_contact: [{point: tip, stiffness: 1e6, exponent: "
      "1.5, dissipation: 0.3}]\nduration: 1\nstepping: {integrator: sdirk2, step: 1e-5}\n");
  Vector q = {0.01};
  Vector qd = {-1};
  double lowest = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vector next = scene.code().call("step", {q, qd, {0}});
    q = {next.at(0)};
    qd = {next.at(1)};
    lowest = std::min(lowest, q[0]);
  }
  const auto [z, v] = dropped(0.03);
  EXPECT_LT(lowest, -5e-4);  // it touched
  EXPECT_GT(v, 0);           // and left
  // order 2: (omega h)^2 of a contact of about 5 ms, omega = 600/s, times the speed
  EXPECT_NEAR(q[0], z, 4e-5 * 0.03);
  EXPECT_NEAR(qd[0], v, 4e-5);
}

TEST(ImplicitStep, ConvergesWhereAStepCrossesTheContact) {
  // steps as long as the contact: explicit methods explode
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  ground_contact: [{point: tip, stiffness: 1e8, exponent: "
      "1.5, dissipation: 0.3}]\nduration: 1\nstepping: {integrator: sdirk2, step: 2e-3}\n");
  Vector q = {1};
  Vector qd = {0};
  for (int k = 0; k < 5000; ++k) {
    const Vector next = scene.code().call("step", {q, qd, {0}});
    q = {next.at(0)};
    qd = {next.at(1)};
    ASSERT_LE(std::abs(q[0]), 1 + 1e-9) << "step " << k;  // finite, and no energy gained
  }
  EXPECT_NEAR(q[0], 0, 1e-3);
}

TEST(PhaseStep, LiftsOffWhenTheReactionPulls) {
  // 20 t N upwards against 10 N: the floor pulls from t = 0.5 on
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: floor, point: tip, along: "
      "[z]}]\n"
      "  force: [{point: tip, value: [0, 0, 20*t]}]\n"
      "phases:\n  - name: stand\n    active: [floor]\n    until:\n      - lift_off: {constraint: "
      "floor}\n"
      "        then: fly\n  - {name: fly, active: []}\n"
      "duration: 1\nstepping: {integrator: rk4, step: 1e-2}\n");
  Vector q = {0};
  Vector qd = {0};
  Vector phase = {0};
  int lifted = -1;
  for (int k = 0; k < 100; ++k) {
    const double t = k * 1e-2;
    const Vector next = scene.code().call("step", {q, qd, {0}, {t}, phase});
    q = {next.at(0)};
    qd = {next.at(1)};
    EXPECT_NEAR(next.at(2), phase[0] == 0 ? 10 - 20 * t : 0, 1e-12) << "step " << k;
    phase = {next.at(3)};
    lifted = lifted < 0 && phase[0] == 1 ? k : lifted;
  }
  EXPECT_EQ(lifted, 50);  // the step that begins at 0.50 s, where the floor is just free
  // from 0.5 s on: qdd = 20 t - 10, which rk4 integrates exactly
  EXPECT_NEAR(qd[0], 10 * (1 - 0.5 * 0.5) - 10 * 0.5, 1e-12);
}

/// Height of the ball that waits 0.25 s, falls by 0.05 m from rest in 0.1 s, and so on.
double stairs(double t) {
  const double count = std::floor(t / 0.35);
  const double fall = std::max(0.0, t - 0.35 * count - 0.25);
  return -0.05 * count - 5 * fall * fall;
}

TEST(PhaseStep, TakesTimesWithinTheStep) {
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: hold, point: tip, along: "
      "[z]}]\n"
      "phases:\n  - {name: wait, active: [hold], until: [{time: 0.25, then: fall}]}\n"
      "  - name: fall\n    active: []\n    until:\n      - time: 0.1\n        impact: "
      "{constraints: [hold]}\n        then: wait\n"
      "duration: 1\nstepping: {integrator: rk4, step: 0.04}\n");
  Vector q = {0};
  Vector qd = {0};
  Vector phase = {0};
  Vector steps = {0};
  Vector begun = {0};
  for (int k = 1; k <= 2000; ++k) {
    const Vector next = scene.code().call("step", {q, qd, {0}, phase, steps, begun});
    q = {next.at(0)};
    qd = {next.at(1)};
    phase = {next.at(3)};
    steps = {next.at(4)};
    begun = {next.at(5)};
    // 230 falls; roundings of times, about 1e-17 s each, change the way of a fall by 1 m/s as much
    ASSERT_NEAR(q[0], stairs(0.04 * k), 1e-13) << "step " << k;
  }
}

/// Held for 0.1 s before the first step, which is longer than a step: it falls 0.15 s later.
TEST(PhaseStep, BeginsInTheMiddleOfAPhase) {
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: hold, point: tip, along: "
      "[z]}]\n"
      "phases:\n  - {name: wait, active: [hold], until: [{time: 0.25, then: fall}]}\n"
      "  - {name: fall, active: [], until: [{time: 0.1, impact: {constraints: [hold]}, then: "
      "wait}]}\n"
      "duration: 1\nstepping: {integrator: rk4, step: 0.04}\n");
  Vector next = {0, 0, 0, 0, 0, 0.1};
  for (int k = 0; k < 4; ++k) {
    next = scene.code().call("step", {{next[0]}, {next[1]}, {0}, {next[3]}, {next[4]}, {next[5]}});
  }
  EXPECT_NEAR(next.at(0), -5 * 0.01 * 0.01, 1e-15);
}

/// The phases of eight steps of 0.1 s; the first phase lasts `first`, the other one `second`.
std::vector<int> phases_of(const std::string& first, const std::string& second,
                           const std::string& stepping) {
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: hold, point: tip, along: "
      "[z]}]\n"
      "phases:\n  - {name: wait, active: [hold], until: [{time: " +
      first +
      ", then: fall}]}\n"
      "  - {name: fall, active: [], until: [{time: " +
      second + ", then: wait}]}\nduration: 1\nstepping: {integrator: rk4, step: 0.1" + stepping +
      "}\n");
  Vector phase = {0};
  Vector steps = {0};
  std::vector<int> phases;
  for (int k = 0; k < 8; ++k) {  // whole steps: no part of one is handed on
    const Measurement next = scene.code().measure("step", {{0}, {0}, {0}, phase, steps});
    EXPECT_EQ(next.status, 0) << "step " << k;
    phase = {next.values.at(3)};
    steps = {next.values.at(4)};
    phases.push_back(static_cast<int>(phase[0]));
  }
  return phases;
}

TEST(PhaseStep, CountsStepsForEventsInTime) {
  for (const std::string stepping : {"", ", cuts: 0"}) {
    EXPECT_EQ(phases_of("0.3", "0.2", stepping), (std::vector<int>{0, 0, 1, 1, 0, 0, 0, 1}));
    EXPECT_EQ(phases_of("0.1", "0.3", stepping), (std::vector<int>{1, 1, 1, 0, 1, 1, 1, 0}));
    EXPECT_EQ(phases_of("0.2", "0.1", stepping), (std::vector<int>{0, 1, 0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(phases_of("0.1", "0.1", stepping), (std::vector<int>{1, 0, 1, 0, 1, 0, 1, 0}));
  }
}

/// Behind a touch-down after 5 ms both phases of 2 ms end within the step: three events.
TEST(PhaseStep, SaysThatItsLastPartPassesATime) {
  const auto measured = [](const std::string& stepping) {
    return BallCode(
               "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: floor, point: tip, "
               "along: [z]}]\nphases:\n  - {name: fall, until: [{touch_down: {point: tip}, impact: "
               "{constraints: [floor]}, then: first}]}\n"
               "  - {name: first, active: [floor], until: [{time: 0.002, then: second}]}\n"
               "  - {name: second, active: [floor], until: [{time: 0.002, then: rest}]}\n"
               "  - {name: rest, active: [floor]}\n"
               "duration: 1\nstepping: {integrator: rk4, step: 0.02" +
               stepping + "}\n")
        .code()
        .measure("step", {{0.005}, {-1}, {0}, {0}, {0}, {0}});
  };
  EXPECT_EQ(measured("").status, kEventMissed);
  const Measurement all = measured(", events: 5");
  EXPECT_EQ(all.status, 0);
  EXPECT_EQ(all.values.at(3), 3);
}

TEST(PhaseStep, SaysThatAGuardIsUndefined) {
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n"
      "phases:\n  - name: fall\n    active: []\n    until:\n      - expression: "
      "sqrt(q[height])\n        then: gone\n  - {name: gone, active: []}\n"
      "duration: 1\nstepping: {integrator: rk4, step: 0.01}\n");
  EXPECT_EQ(scene.code().measure("step", {{1}, {0}, {0}, {0}}).status, 0);
  EXPECT_EQ(scene.code().measure("step", {{-1}, {0}, {0}, {0}}).status, kGuardUndefined);
  EXPECT_EQ(scene.code().measure("step", {{std::nan("")}, {0}, {0}, {1}}).status, kNotANumber);
}

TEST(ImplicitStep, HalvesWhereTheForceJumps) {
  // a law whose damping begins with the touch: a step of 0.5 ms has no solution in 20 of 2000 drops
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -9.81]\n  ground_contact: [{point: tip, law: 7000*d - 57*v}]\n"
      "duration: 1\nstepping: {integrator: sdirk2, step: 5e-4}\n");
  for (int drop = 0; drop < 2000; ++drop) {
    Vector q = {1e-3 + 1e-5 * drop};
    Vector qd = {-1 - 1e-3 * drop};
    const double energy = 9.81 * q[0] + qd[0] * qd[0] / 2;
    for (int k = 0; k < 60; ++k) {
      const Measurement next = scene.code().measure("step", {q, qd, {0}});
      ASSERT_EQ(next.status, 0) << "drop " << drop << " step " << k;
      q = {next.values.at(0)};
      qd = {next.values.at(1)};
    }
    ASSERT_LE(9.81 * q[0] + qd[0] * qd[0] / 2, energy);
  }
}

}  // namespace
}  // namespace treedyn::support
