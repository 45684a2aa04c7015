// Steps of a ball: bounces, rest, lift-off, events in time, and contact that is stiff.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scenes/arm_scene.hpp"

namespace treedyn::support {
namespace {

/// A mass of 1 kg on a vertical slide.
std::string ball(const std::string& rest) {
  return "scene: ball\nmodel: ball.yaml\npoints: [{name: tip, link: ball, at: [0, 0, 0]}]\n" + rest;
}

class BallCode {
 public:
  explicit BallCode(const std::string& rest) {
    write_file(
        folder_.path() / "ball.yaml",
        "name: ball\nlinks:\n  - name: ball\n    father: ground\n    joint: {name: height, type: "
        "prismatic, axis: [0, 0, 1]}\n    mass: 1\n");
    write_file(folder_.path() / "scene.yaml", ball(rest));
    generate({}, {"--scene", (folder_.path() / "scene.yaml").string()}, folder_.path());
    code_ = std::make_unique<CompiledModel>(folder_.path(), "generated");
  }
  [[nodiscard]] const CompiledModel& code() const { return *code_; }
  [[nodiscard]] std::string header() const { return read_file(folder_.path() / "generated.hpp"); }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<CompiledModel> code_;
};

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
  for (int k = 0; k < 3000; ++k) {
    if (!rests) {
      v -= h * 10;
      z += h * v;
      if (z < 0 && v < 0) {
        ++bounces;
        v = 0.5 * -v;
        rests = v < 0.1;
        v = rests ? 0 : v;
      }
    }
    const Vector next = scene.code().call("step", {q, qd, {0}, phase});
    q = {next.at(0)};
    qd = {next.at(1)};
    phase = {next.at(3)};
    ASSERT_NEAR(q[0], z, 1e-12) << "step " << k;
    ASSERT_NEAR(qd[0], v, 1e-12) << "step " << k;
    ASSERT_EQ(phase[0], rests ? 1 : 0) << "step " << k;
  }
  EXPECT_TRUE(rests);
  EXPECT_GE(bounces, 4);
  EXPECT_NEAR(scene.code().call("step", {q, qd, {0}, phase}).at(2), 10, 1e-12);
}

/// Height and speed of 1 kg that falls on ground of 1e6 N/m^1.5 and 0.3 s/m, by a million steps of
/// symplectic Euler in the middle.
std::pair<double, double> dropped(double time) {
  double z = 0.01;
  double v = -1;
  constexpr double h = 1e-7;
  const auto a = [&](double at, double speed) {
    const double law = at < 0 ? 1e6 * std::pow(-at, 1.5) * (1 - 0.3 * speed) : 0;
    return (law > 0 ? law : 0) - 10;
  };
  for (int k = 0; k < std::lround(time / h); ++k) {  // the midpoint rule, order 2
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
  EXPECT_EQ(lifted, 51);  // the step that begins at 0.51 s: at 0.50 s the floor is just free
  // from 0.52 s on: qdd = 20 t - 10, which rk4 integrates exactly
  EXPECT_NEAR(qd[0], 10 * (1 - 0.52 * 0.52) - 10 * 0.48, 1e-12);
}

TEST(PhaseStep, CountsStepsForEventsInTime) {
  const BallCode scene(
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: hold, point: tip, along: "
      "[z]}]\n"
      "phases:\n  - {name: wait, active: [hold], until: [{time: 0.3, then: fall}]}\n"
      "  - name: fall\n    active: []\n    until:\n      - expression: q[height] + 0.05\n        "
      "then: wait\n"
      "duration: 1\nstepping: {integrator: rk4, step: 0.1}\n");
  Vector q = {0};
  Vector qd = {0};
  Vector phase = {0};
  Vector steps = {0};
  std::vector<int> phases;
  for (int k = 0; k < 8; ++k) {
    const Vector next = scene.code().call("step", {q, qd, {0}, phase, steps});
    q = {next.at(0)};
    qd = {0};  // the speed is thrown away: only positions matter here
    phase = {next.at(3)};
    steps = {next.at(4)};
    phases.push_back(static_cast<int>(phase[0]));
  }
  // three steps of waiting; falls of 0.05 m from rest: on -0.05 it is not yet below
  EXPECT_EQ(phases, (std::vector<int>{0, 0, 1, 1, 0, 0, 0, 1}));
}

}  // namespace
}  // namespace treedyn::support
