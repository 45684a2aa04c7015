// Events that begin and end within one step, and what a step without cuts says of its events.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "scenes/ball.hpp"

namespace treedyn::support {
namespace {

/// The ball stands on a floor that pushes with 1e5 (t - 0.505)^2 - 0.05 N: less than nothing for
/// 1.41 ms in the middle of a step from 0.50 to 0.51 s.
std::string short_pull(const std::string& stepping) {
  return R"yaml(
effects:
  gravity: [0, 0, -10]
  point_constraint: [{name: floor, point: tip, along: [z]}]
  force: [{point: tip, value: [0, 0, 10.05 - 100000*(t - 0.505)^2]}]
phases:
  - name: stand
    active: [floor]
    until: [{lift_off: {constraint: floor}, then: fly}]
  - {name: fly, active: []}
duration: 1
stepping: {)yaml" +
         stepping + ", step: 1e-2}\n";
}

/// The ball as it is thrown across the plane at 4.5e-4 m and 0.1 m/s: 5e-5 m behind it and back
/// within a step of 0.02 s.
std::string short_dip(const std::string& stepping) {
  return R"yaml(
effects: {gravity: [0, 0, 10]}
phases:
  - name: fall
    active: []
    until: [{touch_down: {point: tip}, then: gone}]
  - {name: gone, active: []}
duration: 1
stepping: {)yaml" +
         stepping + ", step: 0.02}\n";
}

TEST(WithinAStep, ReactionsThatPullAndPushAgainAreSeen) {
  const double gone = std::sqrt(0.05 / 1e5);  // s before 0.505 s
  const auto speed = [](double s) {           // the integral of 0.05 - 1e5 s^2
    return 0.05 * s - 1e5 / 3 * s * s * s;
  };
  for (const std::string integrator : {"rk4", "dopri5-fixed", "sdirk2"}) {
    SCOPED_TRACE(integrator);
    const BallCode scene(short_pull("integrator: " + integrator));
    const Measurement before = scene.code().measure("step", {{0}, {0}, {0}, {0.49}, {0}});
    EXPECT_EQ(before.values.at(3), 0);  // 2.45 N at both of its ends, 22.45 N earlier
    const Measurement step = scene.code().measure("step", {{0}, {0}, {0}, {0.5}, {0}});
    EXPECT_EQ(step.status, 0);
    EXPECT_NEAR(step.values.at(2), 2.45, 1e-9);
    EXPECT_EQ(step.values.at(3), 1);
    // order 2 of sdirk2: an integral of 1e5 s^2 over 5.7 ms by two stages
    const double tolerance = integrator == "sdirk2" ? 5e-3 : 1e-8;
    EXPECT_NEAR(step.values.at(1), speed(0.005) - speed(-gone), tolerance);
  }
}

TEST(WithinAStep, NoFalseAlarmWhereAReactionBarelyPushes) {
  for (const std::string integrator : {"rk4", "dopri5-fixed", "sdirk2"}) {
    std::string text = short_pull("integrator: " + integrator);
    const BallCode scene(text.replace(text.find("10.05"), 5, "9.999"));  // 1 mN are left
    const Measurement step = scene.code().measure("step", {{0}, {0}, {0}, {0.5}, {0}});
    EXPECT_EQ(step.status, 0) << integrator;
    EXPECT_EQ(step.values.at(3), 0) << integrator;
  }
}

TEST(WithinAStep, WithoutCutsAPassedEventIsMissed) {
  const BallCode dip(short_dip("integrator: rk4, cuts: 0"));
  EXPECT_EQ(dip.code().measure("step", {{4.5e-4}, {-0.1}, {0}, {0}}).status, kEventMissed);
  EXPECT_EQ(dip.code().measure("step", {{5.5e-4}, {-0.1}, {0}, {0}}).status, 0);  // 5e-5 m above
  const BallCode pull(short_pull("integrator: rk4, cuts: 0"));
  const Measurement step = pull.code().measure("step", {{0}, {0}, {0}, {0.5}, {0}});
  EXPECT_EQ(step.status, kEventMissed);
  EXPECT_EQ(step.values.at(3), 0);
}

TEST(WithinAStep, WithoutCutsAnEventIsLate) {
  const BallCode scene(short_dip("integrator: rk4, cuts: 0"));
  const Measurement step = scene.code().measure("step", {{1e-3}, {-1}, {0}, {0}});
  EXPECT_EQ(step.status, kEventLate);
  EXPECT_EQ(step.values.at(2), 1);
  EXPECT_EQ(scene.code().measure("step", {{1}, {-1}, {0}, {0}}).status, 0);
  EXPECT_NE(scene.header().find("event_late, "), std::string::npos);
}

}  // namespace
}  // namespace treedyn::support
