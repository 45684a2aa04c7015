// Rebounds that come to rest, asked or not, and those that are too many for a step.
#include <algorithm>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "scenes/ball.hpp"

namespace treedyn::support {
namespace {

/// The ball bounces with 0.8 of its speed and may rest below 1e-4 m/s, less than gravity gives it
/// in a step: a step that missed such a rest would let it sink.
std::string bouncing(const std::string& stepping) {
  return "effects:\n  gravity: [0, 0, -9.81]\n  point_constraint: [{name: floor, point: tip, "
         "along: "
         "[z]}]\n"
         "phases:\n  - name: flight\n    active: []\n    until:\n      - touch_down: {point: "
         "tip}\n        impact: {constraints: [floor], restitution: 0.8, rest_below: 1e-4}\n"
         "        then: flight\nduration: 5\nstepping: {" +
         stepping + "}\n";
}

/// Lowest height and the last one of so many steps from 1 m on.
std::pair<double, double> bounced(const std::string& stepping, int count) {
  const BallCode scene(bouncing(stepping));
  Vector q = {1};
  Vector qd = {0};
  Vector phase = {0};
  double lowest = 1;
  int late = 0;
  for (int k = 0; k < count; ++k) {
    const Measurement next = scene.code().measure("step", {q, qd, {0}, phase});
    q = {next.values.at(0)};
    qd = {next.values.at(1)};
    phase = {next.values.at(3)};
    lowest = std::min(lowest, q[0]);
    late += next.status == kEventLate ? 1 : 0;
    if (next.status != 0 && next.status != kEventLate) {
      ADD_FAILURE() << "status " << next.status << " in step " << k;
      break;
    }
  }
  EXPECT_EQ(phase[0], 1);
  if (stepping.find("cuts: 0") == std::string::npos) {
    EXPECT_EQ(late, 0);
  } else {
    // Bounces at 0.8^k sqrt(2 g) m/s until a step h of 0.1 ms takes one back: k < 37.7. An impact
    // at the end of its step is v h below the plane at most, from where v^2 becomes (0.8 v)^2 -
    // 2 g v h: 29 bounces; an Euler step may cost one more.
    EXPECT_GE(late, 28);
    EXPECT_LE(late, 37);
  }
  return {lowest, q[0]};
}

TEST(PhaseStep, RestsWhereAStepTakesTheReboundBack) {
  const auto [lowest, last] = bounced("integrator: semi-implicit-euler, step: 1e-4", 1000000);
  EXPECT_GE(lowest, -1e-15);  // roundings of the way back to the plane; 5 cm without rest
  EXPECT_NEAR(last, 0, 1e-15);
  const auto [coarse_lowest, coarse_last] = bounced("integrator: rk4, step: 1e-2", 10000);
  EXPECT_GE(coarse_lowest, -1e-15);
  EXPECT_NEAR(coarse_last, 0, 1e-15);
  const auto [late_lowest, late_last] =
      bounced("integrator: semi-implicit-euler, step: 1e-4, cuts: 0", 100000);
  EXPECT_GE(late_lowest, -4.5e-4);  // a step's way at 4.43 m/s
  EXPECT_NEAR(late_last, 0, 1e-15);
}

TEST(PhaseStep, NoBounceCostsMoreThanTheWorstCase) {
  for (const char* const stepping :
       {"integrator: rk4, step: 1e-2", "integrator: sdirk2, step: 1e-2, cuts: 5, events: 2",
        "integrator: semi-implicit-euler, step: 1e-2, cuts: 0"}) {
    const BallCode scene(bouncing(stepping), Variant::kMeasured);
    const Operations worst = scene.worst_case();
    Vector q = {1};
    Vector qd = {0};
    Vector phase = {0};
    for (int k = 0; k < 500; ++k) {
      const Measurement next = scene.code().measure("step", {q, qd, {0}, phase});
      q = {next.values.at(0)};
      qd = {next.values.at(1)};
      phase = {next.values.at(3)};
      for (std::size_t n = 0; n < worst.size(); ++n) {
        ASSERT_LE(next.operations[n], worst[n]) << stepping << " step " << k;
      }
    }
    EXPECT_EQ(phase[0], 1) << stepping;
  }
}

TEST(PhaseStep, SaysWhereEventsAreMissed) {
  // nothing is lost: 1e-5 m high it bounces seven times in a step
  std::string text = bouncing("integrator: rk4, step: 2e-2");
  const std::string loss = "0.8, rest_below: 1e-4";
  const BallCode scene(text.replace(text.find(loss), loss.size(), "1"));
  EXPECT_EQ(scene.code().measure("step", {{1e-5}, {0}, {0}}).status, kEventMissed);
  EXPECT_EQ(scene.code().measure("step", {{1e-2}, {0}, {0}}).status, 0);
}

/// The ball bounces, rests though nobody has said that it may, and is pulled off after 2 s.
std::string pulled_off(const std::string& stepping) {
  return "effects:\n  gravity: [0, 0, -10]\n  force: [{point: tip, value: [0, 0, 5*t]}]\n"
         "  point_constraint: [{name: floor, point: tip, along: [z]}]\nphases:\n  - name: fall\n"
         "    active: []\n    until:\n      - touch_down: {point: tip}\n        impact: "
         "{constraints: [floor], restitution: 0.5}\n        then: fall\nduration: 3\nstepping: {" +
         stepping + "}\n";
}

TEST(PhaseStep, RestsUnaskedUntilTheFloorWouldPull) {
  for (const std::string integrator : {"rk4", "dopri5-fixed", "semi-implicit-euler"}) {
    SCOPED_TRACE(integrator);
    const BallCode scene(pulled_off("integrator: " + integrator + ", step: 1e-2"));
    Vector q = {0.1};
    Vector qd = {0};
    Vector phase = {0};
    bool rests = false;
    for (int k = 0; k < 300; ++k) {
      const Measurement next = scene.code().measure("step", {q, qd, {0}, {k * 1e-2}, phase});
      ASSERT_EQ(next.status, 0) << "step " << k;
      q = {next.values.at(0)};
      qd = {next.values.at(1)};
      phase = {next.values.at(3)};
      rests = rests || phase[0] == 1;
    }
    EXPECT_TRUE(rests);
    EXPECT_EQ(phase[0], 0);
    // qdd = 5 (t - 2) from there on; Euler's method is of order 1
    const double tolerance = integrator == "semi-implicit-euler" ? 0.05 : 1e-9;
    EXPECT_NEAR(qd[0], 2.5, tolerance);
    EXPECT_NEAR(q[0], 5.0 / 6, tolerance);
  }
}

/// The ball slides down a rail of 45 degrees, bounces, rests and is pulled off after 2 s.
std::string on_a_rail(const std::string& struck) {
  return "scene: rail\nmodel: " + std::string(TREEDYN_SOURCE_DIR) +
         "/tests/scenes/models/cart_and_ball.yaml\n"
         "points: [{name: tip, link: ball, at: [0, 0, 0]}]\neffects:\n  gravity: [0, 0, -10]\n"
         "  force: [{point: tip, value: [0, 0, 5*t]}]\n  point_constraint:\n"
         "    - {name: rail, point: tip, along: [[1, 0, 1]]}\n"
         "    - {name: floor, point: tip, along: [z]}\nphases:\n  - name: fall\n    active: " +
         (struck == "floor" ? "[]" : "[rail]") +
         "\n    until:\n      - touch_down: {point: tip}\n        impact: {constraints: [" +
         struck +
         "], restitution: 0.5}\n        then: fall\ninitial: {q: {height: 0.1}}\nduration: 3\n"
         "stepping: {integrator: rk4, step: 1e-2}\n";
}

/// What acts before and behind an impact takes its part of it, named by it or not.
TEST(PhaseStep, ReboundsAndRestsOnWhatIsHeld) {
  for (const std::string struck : {"floor", "floor, rail"}) {
    SCOPED_TRACE(struck);
    const SceneCode scene(on_a_rail(struck));
    Vector q = {0, 0.1};
    Vector qd = {0, 0};
    Vector phase = {0};
    bool rests = false;
    for (int k = 0; k < 300; ++k) {
      const Measurement next = scene.code().measure("step", {q, qd, {0, 0}, {k * 1e-2}, phase});
      ASSERT_EQ(next.status, 0) << "step " << k;
      q = {next.values.at(0), next.values.at(1)};
      qd = {next.values.at(2), next.values.at(3)};
      phase = {next.values.at(6)};
      ASSERT_NEAR(qd[0] + qd[1], 0, 1e-12) << "step " << k;
      rests = rests || phase[0] == 1;
    }
    EXPECT_TRUE(rests);
    EXPECT_EQ(phase[0], 0);
    // cart and ball, 1 kg each: 3 kg move with the ball's height, by 5 N/s (t - 2 s) from there on
    EXPECT_NEAR(qd[1], 2.5 / 3, 1e-9);
    EXPECT_NEAR(q[1], 5.0 / 18, 1e-9);
    EXPECT_NEAR(q[0] + q[1], 0.1, 1e-12);
  }
}

/// The ball on a cart whose axis sticks: 1 m above the floor, the cart at 1 m/s.
TEST(PhaseStep, RestsBesideAJointThatSticks) {
  const SceneCode scene(
      "scene: cart\nmodel: " + std::string(TREEDYN_SOURCE_DIR) +
      "/tests/scenes/models/cart_and_ball.yaml\npoints: [{name: tip, link: ball, at: [0, 0, 0]}]\n"
      "effects:\n  gravity: [0, 0, -10]\n  coulomb_friction: [{joint: x, force: 2}]\n"
      "  point_constraint: [{name: floor, point: tip, along: [z]}]\nphases:\n  - name: fall\n"
      "    active: []\n    until:\n      - touch_down: {point: tip}\n        impact: "
      "{constraints: [floor], restitution: 0.5}\n        then: fall\n"
      "initial: {q: {height: 1}, qd: {x: 1}}\nduration: 3\n"
      "stepping: {integrator: rk4, step: 1e-3}\n");
  Vector q = {0, 1};
  Vector qd = {1, 0};
  Vector phase = {1};  // forth
  for (int k = 0; k < 3000; ++k) {
    const Measurement next = scene.code().measure("step", {q, qd, {0, 0}, phase});
    ASSERT_EQ(next.status, 0) << "step " << k;
    q = {next.values.at(0), next.values.at(1)};
    qd = {next.values.at(2), next.values.at(3)};
    phase = {next.values.at(6)};
  }
  EXPECT_NEAR(q[0], 0.5, 1e-12);  // 2 kg at 1 m/s against 2 N
  EXPECT_EQ(q[1], 0);
  EXPECT_EQ(qd, (Vector{0, 0}));
  EXPECT_EQ(phase[0], 3);  // fall_x_sticks_at_rest
}

}  // namespace
}  // namespace treedyn::support
