// Events whose guard is beyond zero for a moment only are found whatever the duration, the rows of
// the table and the steps are.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulation/run_scene.hpp"
#include "simulation/sign_changes.hpp"
#include "simulation/time_scale.hpp"

namespace treedyn::simulation {
namespace {

std::vector<double> changes(const std::function<double(double)>& g, int start, int pieces = 1) {
  std::vector<double> result;
  for (const SignChange& place : sign_changes(g, start, pieces, 0).places) {
    result.push_back((place.low + place.high) / 2);
    EXPECT_LE(place.low, place.high);
  }
  return result;
}

TEST(SignChanges, AreFoundInPairs) {
  for (const double width : {0.3, 0.03, 0.003, 0.0003}) {
    for (const double at : {0.11, 0.37, 0.5, 0.83}) {
      const auto found =
          changes([&](double s) { return (s - at) * (s - at) - width * width / 4; }, 1);
      ASSERT_EQ(found.size(), 2U) << width << ' ' << at;
      EXPECT_NEAR(found[0], at, 0.26);
    }
  }
}

TEST(SignChanges, OfAGuardThatOnlyTouchesZeroAreNone) {
  EXPECT_EQ(changes([](double s) { return (s - 0.3) * (s - 0.3); }, 1).size(), 0U);
  EXPECT_EQ(changes([](double s) { return 1e-6 + (s - 0.3) * (s - 0.3); }, 1).size(), 0U);
}

TEST(SignChanges, KeepTheSideOfTheStart) {
  EXPECT_EQ(changes([](double s) { return s - 1e-17; }, 1).size(), 0U);
  EXPECT_EQ(changes([](double s) { return s - 1e-17; }, -1).size(), 1U);
}

TEST(SignChanges, OfManyTurnsAreAllFound) {
  const auto found =
      changes([](double s) { return std::cos(6 * std::numbers::pi * s) + 0.5; }, 1, 8);
  EXPECT_EQ(found.size(), 6U);
}

TEST(SignChanges, SayWhereAFunctionIsNotDefined) {
  const SignChanges found = sign_changes([](double s) { return 1 + std::sqrt(0.4 - s); }, 1, 1, 0);
  EXPECT_GT(found.undefined, 0.4);
  EXPECT_LE(found.undefined, 0.5);
}

TEST(FarSide, IsTheRootToTheResolution) {
  int calls = 0;
  const double root = far_side(
      [&](double x) {
        ++calls;
        return 2 - std::exp(x);
      },
      1, 0, 3, 1e-15);
  EXPECT_NEAR(root, std::log(2.0), 4e-15);
  EXPECT_LT(2 - std::exp(root), 0);
  EXPECT_LT(calls, 25);
}

model::Expression clock(const std::string& text) {
  const model::Scene scene = scene_of(
      "scene: s\nmodel: drop.model.yaml\nduration: 1\neffects:\n  force:\n"
      "    - {point: ball, value: [0, 0, \"" +
      text + "\"]}\n");
  return scene.point_laws[0].value[2];
}

double resolved(const std::string& text, double t) {
  const Vector none = Vector::Zero(1);
  Changing force{clock(text)};
  return resolved_step(force, going_on(t, none, none, none), 1000);
}

TEST(ResolvedSteps, AreThoseOfTheClockOfAForce) {
  EXPECT_EQ(resolved("3*t", 0), 1000);
  EXPECT_EQ(resolved("t^4", 0), 1000);
  EXPECT_LE(resolved("sin(50*t)", 0.3), 12.0 / 50);
  EXPECT_GE(resolved("sin(50*t)", 0.3), 1.0 / 50);
  EXPECT_GE(resolved("cos(2*t)", 0), 1.0);
  EXPECT_LT(resolved("1/(1 + (1000*(t - 5))^8)", 0), 5.1);  // a pulse of 1 ms is not jumped over
}

double first_event(const std::string& more, const std::string& duration,
                   const std::string& integrator, double step = 0.05) {
  model::Scene scene =
      scene_of("scene: s\nmodel: drop.model.yaml\n" + more + "duration: " + duration + "\n");
  scene.stepping.integrator = integrator;
  scene.stepping.step = Real(step);
  Running run(scene);
  run.simulator.advance_to(static_cast<double>(scene.duration),
                           [&] { return run.simulator.events().empty(); });
  return run.simulator.events().empty() ? -1 : run.simulator.events()[0].time;
}

/// A window of 0.02 s around t = 1.
TEST(Windows, OfTheClockAreFoundAtEveryDuration) {
  const std::string scene =
      "phases:\n  - name: a\n    until:\n      - {expression: \"(t - 1)^2 - 1/10000\", then: b}\n"
      "  - name: b\n";
  for (const char* const duration : {"1.5", "2", "7", "300"}) {
    for (const char* const integrator : {"fehlberg78", "dopri5", "rk4", "semi-implicit-euler"}) {
      EXPECT_NEAR(first_event(scene, duration, integrator), 0.99, 1e-9) << integrator << duration;
    }
  }
}

TEST(Windows, OfAFastClockAreFoundAtOnce) {
  const std::string scene =
      "phases:\n  - name: a\n    until:\n      - {expression: \"999/1000 - cos(40*t + 1)\", then: "
      "b}\n  - name: b\n";
  const double expected = (2 * std::numbers::pi - 1 - std::acos(0.999)) / 40;
  for (const char* const duration : {"1", "30"}) {
    for (const char* const integrator : {"fehlberg78", "dopri5", "rk4"}) {
      EXPECT_NEAR(first_event(scene, duration, integrator, 0.25), expected, 1e-9) << integrator;
    }
  }
}

/// Thrown to 1 m, below a ceiling at 0.999 m: beyond it for 0.028 s. Free flight is exact in one
/// step, however long.
TEST(Windows, OfAPointAreFoundInsideOneStep) {
  const std::string scene =
      "effects: {gravity: [0, 0, -10]}\ninitial: {qd: {height: sqrt(20)}}\n"
      "phases:\n  - name: up\n    until:\n"
      "      - {touch_down: {point: ball, normal: [0, 0, -1], height: -0.999}, then: down}\n"
      "  - name: down\n";
  const double expected = (std::sqrt(20) - std::sqrt(20 - 20 * 0.999)) / 10;
  for (const char* const duration : {"1", "3", "50"}) {
    for (const char* const integrator : {"fehlberg78", "rk4"}) {
      EXPECT_NEAR(first_event(scene, duration, integrator, 0.5), expected, 1e-9) << integrator;
    }
  }
}

/// A push of 12 N against a weight of 10 N for 0.063 s; the ball does not move, so no error of a
/// step tells of it.
TEST(Windows, OfAReactionAreFoundWhileNothingMoves) {
  const std::string scene =
      "effects:\n  gravity: [0, 0, -10]\n  force:\n"
      "    - {point: ball, value: [0, 0, 12 - 2000*(t - 3)^2]}\n"
      "  point_constraint:\n    - {name: floor, point: ball, along: [z]}\n"
      "phases:\n  - name: standing\n    active: [floor]\n    until:\n"
      "      - {lift_off: {constraint: floor}, then: flying}\n  - name: flying\n";
  for (const char* const duration : {"4", "40"}) {
    EXPECT_NEAR(first_event(scene, duration, "fehlberg78"), 3 - std::sqrt(2.0 / 2000), 1e-9);
    EXPECT_NEAR(first_event(scene, duration, "rk4"), 3 - std::sqrt(2.0 / 2000), 1e-9);
  }
}

/// A force that begins and ends inside what a step could be: 1 N s in 2 ms at t = 5.
TEST(Windows, OfAForceAreFeltAtEveryDuration) {
  for (const char* const duration : {"6", "60"}) {
    model::Scene scene = scene_of(
        "scene: s\nmodel: drop.model.yaml\neffects:\n  force:\n"
        "    - {point: ball, value: [0, 0, 1000/(1 + (1000*(t - 5))^8)]}\nduration: " +
        std::string(duration) + "\n");
    Running run(scene);
    run.advance_to(6);
    const double impulse = 2 * std::numbers::pi / 8 / std::sin(std::numbers::pi / 8);
    EXPECT_NEAR(run.simulator.qd()[0], impulse, 1e-6) << duration;
  }
}

/// max(0, 1 - |x / width|)
std::string triangle(const std::string& x, const std::string& width) {
  const std::string side = "(1 - sqrt((" + x + ")^2)/" + width + ")";
  return "(" + side + " + sqrt(" + side + "^2))/2";
}

model::Scene driven(const std::string& torque, const std::string& speed,
                    const std::string& integrator) {
  model::Scene scene =
      scene_of("scene: s\nmodel: drop.model.yaml\neffects:\n  drive: [{joint: height, torque: \"" +
               torque + "\"}]\ninitial: {qd: {height: " + speed + "}}\nduration: 100\n");
  scene.stepping.integrator = integrator;
  return scene;
}

/// What the corners of the narrowest pulses cost, m/s: no method has an order there. A pulse that
/// is passed over leaves 1 m/s.
constexpr double kCorners = 1e-6;

/// 0.375 J on 1 kg that passes at 1 m/s, however narrow.
TEST(Windows, OfAForceAlongACoordinateAreFelt) {
  for (const char* const width : {"0.05", "0.01", "0.001", "0.00001"}) {
    for (const char* const integrator : {"fehlberg78", "dopri5"}) {
      Running run(driven(std::string("0.375/") + width + "*" + triangle("q[height] - 0.7", width),
                         "1", integrator));
      run.advance_to(1.5);
      EXPECT_NEAR(run.simulator.qd()[0], std::sqrt(1.75), kCorners) << width << integrator;
    }
  }
}

/// The same of a force at a point, 0.375 J, and of ground that pushes in a band of its depth.
TEST(Windows, OfAForceAlongThePlaceOfAPointAreFelt) {
  for (const char* const width : {"0.05", "0.001", "0.00001"}) {
    for (const std::string integrator : {"fehlberg78", "dopri5"}) {
      const auto expect_end = [&](const std::string& effect, double speed) {
        Running run(scene_of("scene: s\nmodel: drop.model.yaml\neffects: " + effect +
                             "\ninitial: {q: {height: 1}, qd: {height: -1}}\nstepping: "
                             "{integrator: " +
                             integrator + ", tolerance: 1e-10}\nduration: 100\n"));
        run.advance_to(3);
        EXPECT_NEAR(run.simulator.qd()[0], speed, kCorners) << effect << integrator;
      };
      const std::string size = std::string("0.375/") + width + "*";
      expect_end(
          "{force: [{point: ball, value: [0, 0, \"-" + size + triangle("z - 0.3", width) + "\"]}]}",
          -std::sqrt(1.75));
      expect_end(
          "{ground_contact: [{point: ball, law: \"" + size + triangle("d - 0.3", width) + "\"}]}",
          -std::sqrt(0.25));
    }
  }
}

/// The same pulse twice; over what is expanded, bounds of the denominator contain zero.
TEST(Windows, OfAForceAreFeltHoweverItIsWritten) {
  const auto end = [](const std::string& pulse) {
    Running run(
        driven("10*((" + pulse + " - 0.5) + sqrt((" + pulse + " - 0.5)^2))/2", "1", "fehlberg78"));
    run.advance_to(6);
    return run.simulator.qd()[0];
  };
  const double speed = end("1/(1 + ((q[height] - 3)/0.1)^2)");
  EXPECT_GT(speed, 1.4);
  EXPECT_NEAR(end("0.01/(q[height]^2 - 6*q[height] + 9.01)"), speed, kCorners);
}

/// Corners are not approached any more where a motion has died away.
TEST(Windows, CostNothingOnceAMotionHasDecayed) {
  Running run(
      driven("-100*q[height] - 2*qd[height] - 5*qd[height]*sqrt(qd[height]^2)", "1", "fehlberg78"));
  run.advance_to(20);
  const long steps = run.simulator.cost().steps;
  run.advance_to(90);
  EXPECT_LT(run.simulator.cost().steps, 2 * steps);
}

/// A resistance of 10 N at 0.5 m/s, none beyond 0.1 m/s from there: 1 N gets to 0.41 m/s.
TEST(Windows, OfAForceOfSpeedAreFelt) {
  for (const char* const width : {"0.1", "0.01", "0.0001"}) {
    for (const char* const integrator : {"fehlberg78", "dopri5"}) {
      Running run(driven("1 - 10*" + triangle("qd[height] - 0.5", width), "0", integrator));
      run.advance_to(2);
      const double expected = 0.5 - 0.9 * std::stod(width);
      EXPECT_NEAR(run.simulator.qd()[0], expected, kCorners) << width << integrator;
    }
  }
}

/// Below zero while |sin(q) - 0.6| < 0.01, q = t.
TEST(Windows, OfAGuardAlongACoordinateAreFound) {
  const std::string scene =
      "initial: {qd: {height: 1}}\nphases:\n  - name: a\n    until:\n"
      "      - {expression: \"0.5 - 1/(1 + ((sin(q[height]) - 0.6)/0.01)^2)\", then: b}\n"
      "  - name: b\n";
  for (const char* const duration : {"1.5", "30"}) {
    for (const char* const integrator : {"fehlberg78", "dopri5", "rk4"}) {
      EXPECT_NEAR(first_event(scene, duration, integrator), std::asin(0.59), 1e-9) << integrator;
    }
  }
}

/// One is zero but for roundings, the other falls through zero slowly.
TEST(Windows, AreNotMadeByRounding) {
  const auto at = [](const std::string& value, const char* integrator) {
    return first_event(
        "initial: {qd: {height: 1}}\nphases:\n  - name: a\n    until:\n"
        "      - {expression: \"" +
            value + "\", then: b}\n  - name: b\n",
        "3", integrator);
  };
  for (const char* const integrator : {"fehlberg78", "dopri5", "rk4"}) {
    EXPECT_EQ(at("sin(q[height])^2 + cos(q[height])^2 - 1", integrator), -1) << integrator;
    EXPECT_NEAR(at("1e-9*(1 - t)", integrator), 1, 1e-5) << integrator;  // 1e-6 of it rounding
  }
}

}  // namespace
}  // namespace treedyn::simulation
