// Drift, events, impacts and forces of scenes against closed forms.
#include "simulation/simulator.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulation/run_scene.hpp"

namespace treedyn::simulation {
namespace {

const std::string kLoop = R"yaml(
scene: loop
model: four_bar.model.yaml
effects:
  gravity: [0, 0, -9.81]
  joined_constraint:
    - {name: loop, point: coupler_end, other: rocker_end, along: [x, z]}
initial:
  q: {crank_joint: pi/2, coupler_joint: -pi/3, rocker_joint: 2*pi/3}
  qd: {crank_joint: 2}
duration: 2
)yaml";

double drift_of(model::Drift drift, const std::string& integrator) {
  Settings settings;
  settings.integrator = integrator;
  settings.step = 1e-3;
  settings.drift = drift;
  Running run(scene_of(kLoop), &settings);
  double worst = 0;
  run.simulator.advance_to(2, [&] {
    worst = std::max(
        worst, run.simulator.system().violation(run.simulator.time(), run.simulator.q()).size);
    return true;
  });
  return worst;
}

/// The times t0 + k step are rounded by more than a billionth of a step there.
TEST(Steps, AreAllTakenWhereTimeBeginsLate) {
  const std::string late = R"yaml(
scene: late
model: drop.model.yaml
effects: {gravity: [0, 0, -10]}
initial: {t: 20000}
duration: 2
stepping: {integrator: rk4, step: 1e-3}
)yaml";
  for (const char* t : {"20000", "1e6", "-1e6", "1e8"}) {
    std::string text = late;
    text.replace(text.find("20000"), 5, t);
    Running run(scene_of(text));
    run.simulator.advance_to(std::stod(t) + 2, [] { return true; });
    EXPECT_NEAR(run.simulator.qd()[0], -20, 20 * 2e-8) << t;  // the steps' lengths are rounded
    EXPECT_NEAR(static_cast<double>(run.simulator.cost().steps), 2000, 1) << t;
  }
}

TEST(Drift, GrowsWithoutStabilisationAndIsHeldWithIt) {
  const double none = drift_of(model::Drift::kNone, "semi-implicit-euler");
  const double baumgarte = drift_of(model::Drift::kBaumgarte, "semi-implicit-euler");
  const double projection = drift_of(model::Drift::kProjection, "semi-implicit-euler");
  EXPECT_GT(none, 1e-4);
  EXPECT_LT(baumgarte, none / 5);
  EXPECT_LT(projection, 1e-14);  // a few roundings of positions of size 1
}

const std::string kBall = R"yaml(
scene: ball
model: drop.model.yaml
effects:
  gravity: [0, 0, -10]
  point_constraint:
    - {name: floor, point: ball, along: [z]}
phases:
  - name: flight
    until:
      - touch_down: {point: ball}
        impact: {constraints: [floor], restitution: 0.5, rest_below: 0.01}
        then: flight
initial:
  q: {height: 1.25}
duration: 3
)yaml";

TEST(Impact, HalvesTheSpeedOfABallWithRestitutionOneHalf) {
  Running run(scene_of(kBall));
  run.advance_to(3);
  const auto& events = run.simulator.events();
  ASSERT_GE(events.size(), 3U);
  // falls 1.25 m at 10 m/s^2: 0.5 s and 5 m/s; then 2.5 m/s up, 0.5 s again, and so on
  const double times[] = {0.5, 1.0, 1.25};
  const double speeds[] = {5, 2.5, 1.25};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(events[k].time, times[k], 1e-9);
    EXPECT_NEAR(events[k].qd_before[0], -speeds[k], 1e-9);
    EXPECT_NEAR(events[k].qd_after[0], speeds[k] / 2, 1e-9);
    EXPECT_NEAR(events[k].impulse[0], 1.5 * speeds[k], 1e-9);  // m (1 + e) v
  }
}

TEST(Impact, ComesToRestAfterAllItsRebounds) {
  Running run(scene_of(kBall));
  run.advance_to(3);
  EXPECT_NEAR(run.simulator.q()[0], 0, 1e-9);
  EXPECT_EQ(run.simulator.system().constraints().rows(), 1);
  EXPECT_NEAR(run.simulator.solution().lambda[0], 10, 1e-12);  // m g
}

TEST(Settling, TakesNoRowsOfRoundingForConstraints) {
  const std::string scene =
      "scene: s\nmodel: ../../tests/scenes/models/planar.yaml\neffects:\n  "
      "gravity: [0, 0, -9.81]\n";
  const std::string rest = "initial: {q: {ja: 1, jb: 0.5}, qd: {ja: 1, jb: 2}}\nduration: 1\n";
  Running free(scene_of(scene + rest));
  Running held(scene_of(scene +
                        "  orientation_constraint:\n    - {name: o, point: tip, along: "
                        "[[0.7648421872844885, 0.644217687237691, 0]]}\n" +
                        rest));
  free.advance_to(0.5);
  held.advance_to(0.5);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(held.simulator.q()[k], free.simulator.q()[k], 1e-9);
  }
  EXPECT_EQ(held.simulator.solution().lambda[0], 0);
}

TEST(Settling, NamesTheConstraintThatIsLedByNoNumber) {
  for (const auto& [at, lacks] : {std::pair("sqrt(t-1)", "value"), std::pair("sqrt(t)", "rate")}) {
    try {
      const Running run(
          scene_of(fmt::format("scene: s\nmodel: ../two_link.yaml\neffects:\n  locked_joint: "
                               "[{{name: led, joint: elbow, "
                               "at: {}}}]\nduration: 1\n",
                               at)));
      ADD_FAILURE() << at;
    } catch (const std::runtime_error& problem) {
      EXPECT_EQ(problem.what(),
                fmt::format("constraint 'led' is led by what has no {} at t = 0 s", lacks));
    }
  }
}

TEST(Impact, OfAPointThatBeginsBelowThePlaneIsWarnedOf) {
  const std::string above = "initial:\n  q: {height: 1.25}";
  std::string text = kBall;
  text.replace(text.find(above), above.size(), "initial:\n  q: {height: -0.25}");
  const Running run(scene_of(text));
  const std::vector<Notice> notices = run.simulator.monitor().notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0].kind, "below");
  EXPECT_EQ(notices[0].name, "ball");
  EXPECT_EQ(notices[0].value, 0.25);
  const std::string rebound = "restitution: 0.5, rest_below: 0.01";
  text.replace(text.find(rebound), rebound.size(), "restitution: 0");
  EXPECT_EQ(Running(scene_of(text)).simulator.monitor().notices().size(), 1U);
  EXPECT_TRUE(Running(scene_of(kBall)).simulator.monitor().notices().empty());
}

TEST(Impact, OfAPointThatIsBelowThePlaneWhenItIsLookedAtIsWarnedOf) {
  const std::string begin = "initial:\n  q: {height: 1.25}";
  const auto notices = [&](const std::string& not_before, const std::string& initial) {
    std::string text = kBall;
    text.insert(text.find("        then: flight"), "        not_before: " + not_before + "\n");
    text.replace(text.find(begin), begin.size(), "initial:\n" + initial);
    Running run(scene_of(text));
    run.advance_to(1);
    return run.simulator.monitor().notices();
  };
  const std::vector<Notice> below = notices("0.6", "  q: {height: 1.25}");
  ASSERT_EQ(below.size(), 1U);
  EXPECT_EQ(below[0].kind, "below");
  EXPECT_NEAR(below[0].value, 0.55, 1e-9);
  EXPECT_NEAR(below[0].time, 0.6, 1e-12);
  EXPECT_TRUE(notices("0.4", "  q: {height: 1.25}").empty());
  // on its way up: to 0.25 m above, or to 0.55 m below
  EXPECT_TRUE(notices("0.1", "  q: {height: -1}\n  qd: {height: 5}").empty());
  EXPECT_EQ(notices("0.1", "  q: {height: -1}\n  qd: {height: 3}").size(), 1U);
}

/// A held point that has drifted leaves the floor; nothing falls.
TEST(Impact, OfAPointThatLeavesItsPlaneIsNoneToWarnOf) {
  std::string text =
      "scene: s\nmodel: drop.model.yaml\neffects:\n  gravity: [0, 0, -10]\n  point_constraint:\n"
      "    - {name: floor, point: ball, along: [z]}\n  drive: [{joint: height, torque: 20*t}]\n"
      "phases:\n  - name: stand\n    active: [floor]\n    until: [{lift_off: {constraint: floor}, "
      "then: fly}]\n  - name: fly\n    until: [{touch_down: {point: ball, height: 1e-9}, impact: "
      "{constraints: [floor]}, then: stand}]\nduration: 1\n";
  Running run(scene_of(text));  // the plane is 1 nm above where it stands
  run.advance_to(1);
  EXPECT_EQ(run.simulator.events().size(), 1U);
  EXPECT_TRUE(run.simulator.monitor().notices().empty());
}

/// 22.5 kg m^2 of a forearm break away from 300 N m where 300 t exceeds them and its weight; from
/// there classical steps of 0.1 ms, whose error is below 1e-12. The simulator is known to 1e-9 of
/// speeds of up to 30 rad/s.
TEST(Friction, LetsGoWhereTheDriveExceedsIt) {
  Running run(scene_of(
      "scene: s\nmodel: ../two_link.yaml\neffects:\n  gravity: [0, 0, -9.81]\n  locked_joint: "
      "[{joint: shoulder}]\n  coulomb_friction: [{joint: elbow, force: 300}]\n  drive: [{joint: "
      "elbow, torque: 300*t}]\nduration: 4\n"));
  const double breaks = (300 + 245.25) / 300;
  run.advance_to(breaks - 1e-6);
  EXPECT_NEAR(run.simulator.q()[1], 0, 1e-12);
  run.advance_to(4);
  const auto acceleration = [](double t, double q) {
    return (300 * t - 300 - 245.25 * std::cos(q)) / 22.5;
  };
  const int steps = 20000;
  const double h = (4 - breaks) / steps;
  double q = 0;
  double v = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = breaks + k * h;
    const double a1 = acceleration(t, q);
    const double v2 = v + h / 2 * a1;
    const double a2 = acceleration(t + h / 2, q + h / 2 * v);
    const double v3 = v + h / 2 * a2;
    const double a3 = acceleration(t + h / 2, q + h / 2 * v2);
    const double v4 = v + h * a3;
    const double a4 = acceleration(t + h, q + h * v3);
    q += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  EXPECT_NEAR(run.simulator.q()[1], q, 1e-7);
  EXPECT_NEAR(run.simulator.qd()[1], v, 1e-7);
}

TEST(Friction, ThatSticksAndSlipsWithoutEndEndsTheMotion) {
  Running run(scene_of(R"yaml(
scene: nailed
model: ../two_link.yaml
effects:
  gravity: [0, 0, -9.81]
  coulomb_friction: [{joint: elbow, force: 0.3}]
  point_constraint: [{name: nail, point: tip, along: [x, z]}]
initial: {q: {shoulder: 0.3, elbow: 0.4}}
duration: 0.02
stepping: {integrator: rk4, step: 0.001}
)yaml"));
  try {
    run.advance_to(0.02);
    FAIL() << "both rows hold the elbow, so its friction has nothing left to hold";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find("joint 'elbow' sticks and slips to and fro"), 0U);
  }
}

/// Kinds of what is said of a body that moves at a speed when a lock begins to hold it.
std::vector<std::string> notices_of_lock(const std::string& speed) {
  Running run(scene_of(R"yaml(
scene: caught
model: drop.model.yaml
effects:
  locked_joint:
    - {name: hook, joint: height}
phases:
  - name: free
    until:
      - {time: 0.25, then: held}
  - name: held
    active: [hook]
initial: {qd: {height: )yaml" +
                       speed + "}}\nduration: 1\n"));
  run.advance_to(0.25);
  std::vector<std::string> kinds;
  for (const Notice& notice : run.simulator.monitor().notices()) {
    kinds.push_back(notice.kind);
  }
  return kinds;
}

TEST(Warnings, OfSpeedsThatNoImpactHasTakenLeaveOutRoundings) {
  EXPECT_EQ(notices_of_lock("1e-3"), std::vector<std::string>{"speed"});
  EXPECT_TRUE(notices_of_lock("1e-15").empty());
}

/// A ball that a stop of its joint throws back, at no point.
const std::string kStop = R"yaml(
scene: stop
model: drop.model.yaml
effects:
  gravity: [0, 0, -10]
  locked_joint: [{joint: height}]
phases:
  - name: free
    until:
      - {expression: "q[height] + 1", impact: {constraints: [height], restitution: 0.5}, then: free}
initial: {q: {height: 0.25}}
duration: 3
)yaml";

TEST(Impact, AtAnExpressionThrowsBackUntilItsReboundsCannotBeSeen) {
  for (const auto& [integrator, step] : {std::pair("fehlberg78", 1e-3),
                                         {"rk4", 1e-3},
                                         {"rk4", 0.1},
                                         {"semi-implicit-euler", 1e-3}}) {
    model::Scene scene = scene_of(kStop);
    scene.stepping.integrator = integrator;
    scene.stepping.step = step;
    Running run(scene);
    // v = sqrt(2 g h) = 5 m/s; rebounds by halves, all of them within 0.5 s + 2 v e / g (1 - e)
    EXPECT_THROW(run.advance_to(3), std::runtime_error) << integrator << ' ' << step;
    const auto& events = run.simulator.events();
    ASSERT_GE(events.size(), 5U) << integrator << ' ' << step;
    const double error = integrator[0] == 's' ? 0.02 : 1e-9;  // of order h
    EXPECT_NEAR(events[0].time, 0.5, error);
    EXPECT_NEAR(events[0].qd_after[0], 2.5, 5 * error);
    EXPECT_NEAR(events[1].qd_after[0], 1.25, 5 * error);
    EXPECT_NEAR(run.simulator.time(), 1.5, 0.1) << integrator << ' ' << step;
    EXPECT_NEAR(run.simulator.q()[0], -1, std::max(error, 1e-6)) << integrator << ' ' << step;
  }
}

/// What stops at the expression, or comes back to its phase below it, goes on as before.
TEST(Impact, AtAnExpressionEndsNoMotionThatPassesIt) {
  std::string plastic = kStop;
  plastic.replace(plastic.find(", restitution: 0.5"), 18, "");
  std::string late = kStop;
  late.replace(late.find("then: free}"), 11,
               "then: open}\n  - {name: open, until: [{time: 0.6, then: free}]}");
  for (const std::string& text : {plastic, late}) {
    Running run(scene_of(text));
    run.advance_to(3);
    EXPECT_LT(run.simulator.q()[0], -1);
  }
}

/// Newton's cradle: what the blows leave of the speeds of balls that touch is rounding, no fall.
TEST(Impact, AtAnExpressionHandsTheSpeedOnThroughBallsThatTouch) {
  Running run(scene_of(R"yaml(
scene: cradle
model: ../../tests/scenes/models/cradle.yaml
effects:
  joined_constraint:
    - {name: hit_01, point: right_0, other: left_1, along: [x]}
    - {name: hit_12, point: right_1, other: left_2, along: [x]}
phases:
  - name: free
    active: []
    until:
      - {expression: "q[x_1]-q[x_0]-0.2", impact: {constraints: [hit_01], restitution: 1}, then: free}
      - {expression: "q[x_2]-q[x_1]-0.2", impact: {constraints: [hit_12], restitution: 1}, then: free}
initial: {q: {x_0: -1, x_2: 0.2}, qd: {x_0: 1}}
duration: 2
)yaml"));
  run.advance_to(2);
  const Vector q = run.simulator.q();
  const Vector qd = run.simulator.qd();
  EXPECT_NEAR(q[0], -0.2, 1e-14);
  EXPECT_NEAR(q[1], 0, 1e-14);
  EXPECT_NEAR(q[2], 0.2 + 1.2, 1e-14);
  EXPECT_NEAR(qd[2], 1, 1e-14);
  EXPECT_LT(qd.head(2).cwiseAbs().maxCoeff(), 1e-14);
}

/// The first and the last of the three turns of a free body are one at a pitch of a right angle.
TEST(Simulator, NamesTheJointsOfASingularPosition) {
  Running run(scene_of(R"yaml(
scene: gimbal
model: ../../tests/scenes/models/free_body.yaml
base: axes
initial: {q: {base_ry: pi/2}}
duration: 1
)yaml"));
  EXPECT_THAT([&] { run.advance_to(1); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(
                  "in this position joints 'base_rz' and 'base_rx' together move no inertia")));
}

TEST(Drift, OfAPhaseThatBeginsElsewhereEndsTheMotion) {
  Running run(scene_of(R"yaml(
scene: elsewhere
model: drop.model.yaml
effects:
  locked_joint: [{joint: height, at: 0.4}]
phases:
  - name: free
    until: [{time: 0.1, then: held}]
  - {name: held, active: [height]}
duration: 0.2
)yaml"));
  EXPECT_THROW(run.advance_to(0.2), std::runtime_error);
  EXPECT_EQ(run.simulator.time(), 0.1);
  EXPECT_EQ(run.simulator.q()[0], 0);
}

/// The ball slides down a rail of 45 degrees: what acts before and behind an impact takes its part
/// of it, named by it or not.
TEST(Impact, LeavesOnItsRailWhatIsHeldThere) {
  for (const std::string struck : {"floor", "floor, rail"}) {
    SCOPED_TRACE(struck);
    Running running(
        scene_of("scene: rail\nmodel: " + std::string(TREEDYN_SOURCE_DIR) +
                 "/tests/scenes/models/cart_and_ball.yaml\npoints: [{name: tip, link: ball, at: "
                 "[0, 0, 0]}]\neffects:\n  gravity: [0, 0, -10]\n  point_constraint:\n    - "
                 "{name: rail, point: tip, along: [[1, 0, 1]]}\n    - {name: floor, point: tip, "
                 "along: [z]}\nphases:\n  - name: fall\n    active: " +
                 std::string(struck == "floor" ? "[]" : "[rail]") +
                 "\n    until: [{touch_down: {point: tip}, impact: {constraints: [" + struck +
                 "], restitution: 0.5}, then: fall}]\ninitial: {q: {height: 0.6}}\nduration: 1\n"));
    running.advance_to(1);
    ASSERT_FALSE(running.simulator.events().empty());
    const EventRecord& impact = running.simulator.events().front();
    // 3 kg move with the height of the ball, 1 kg pulls
    EXPECT_NEAR(impact.time, 0.6, 1e-9);
    EXPECT_NEAR(impact.qd_before[1], -2, 1e-8);
    EXPECT_NEAR(impact.qd_after[1], 1, 1e-8);
    EXPECT_NEAR(impact.qd_after[0], -1, 1e-8);
    EXPECT_NEAR(running.simulator.q().sum(), 0.6, 1e-9);
  }
}

/// The ball falls on a slope while its cart goes on at 2 m/s, however that is said.
TEST(Impact, LeavesLedJointsTheirSpeed) {
  for (const std::string lead : {"acceleration: 0", "at: 2*t", "acceleration: 0*t"}) {
    SCOPED_TRACE(lead);
    Running running(scene_of(
        "scene: led\nmodel: " + std::string(TREEDYN_SOURCE_DIR) +
        "/tests/scenes/models/cart_and_ball.yaml\npoints: [{name: tip, link: ball, at: "
        "[0, 0, 0]}]\neffects:\n  gravity: [0, 0, -10]\n  locked_joint: [{joint: x, " +
        lead +
        "}]\n  point_constraint: [{name: slope, point: tip, along: [[3, 0, 4]]}]\nphases:\n"
        "  - name: fall\n    active: [x]\n    until: [{touch_down: {point: tip, normal: "
        "[3, 0, 4]}, impact: {constraints: [slope], restitution: 0.5}, then: fall}]\n"
        "initial: {q: {height: 1}, qd: {x: 2}}\nduration: 2\n"));
    running.advance_to(1);
    ASSERT_FALSE(running.simulator.events().empty());
    const EventRecord& impact = running.simulator.events().front();
    // 3 (2 t) + 4 (1 - 5 t^2) = 0
    const double t = 0.15 + std::sqrt(0.0225 + 0.2);
    const double rebound = (-0.5 * (3 * 2 - 4 * 10 * t) - 3 * 2) / 4;
    const double push = (rebound + 10 * t) / 0.8;
    EXPECT_NEAR(impact.time, t, 1e-9);
    EXPECT_NEAR(impact.qd_after[0], 2, 1e-9);
    EXPECT_NEAR(impact.qd_after[1], rebound, 1e-8);
    EXPECT_NEAR(impact.impulse[0], -0.6 * push, 1e-8);
    EXPECT_NEAR(impact.impulse[1], push, 1e-8);
  }
}

/// Two led joints leave a tip no freedom to stop.
TEST(Impact, ThatLedJointsDoNotAllowIsWarnedOf) {
  Running run(scene_of("scene: led\nmodel: " + std::string(TREEDYN_SOURCE_DIR) +
                       "/models/two_link.yaml\neffects:\n  locked_joint: [{joint: shoulder, "
                       "acceleration: 0}, {joint: elbow, acceleration: 0}]\n  point_constraint: "
                       "[{name: floor, point: tip, along: [z]}]\nphases:\n  - name: swing\n    "
                       "active: [shoulder, elbow]\n    until: [{touch_down: {point: tip, height: "
                       "-0.5}, impact: {constraints: [floor]}, then: on}]\n  - {name: on, active: "
                       "[shoulder, elbow]}\ninitial: {qd: {shoulder: -0.5, elbow: -0.3}}\n"
                       "duration: 1\n"));
  run.advance_to(1);
  const std::vector<Notice>& notices = run.simulator.monitor().notices();
  const auto found = std::ranges::find(notices, "impact", &Notice::kind);
  ASSERT_NE(found, notices.end());
  EXPECT_EQ(found->time, run.simulator.events().front().time);
}

/// A four-bar has one freedom: where its loop stays closed all its speeds turn by the restitution.
TEST(Impact, LeavesClosedWhatIsALoop) {
  Running running(scene_of(R"yaml(
scene: loop
model: four_bar.model.yaml
points: [{name: nose, link: rocker, at: [0.45, 0, 0]}]
effects:
  gravity: [0, 0, -9.81]
  joined_constraint: [{name: loop, point: coupler_end, other: rocker_end, along: [x, z]}]
  point_constraint: [{name: floor, point: nose, along: [z]}]
phases:
  - name: fall
    active: [loop]
    until:
      - {touch_down: {point: nose, height: 0.25}, impact: {constraints: [floor], restitution: 0.5}, then: fall}
initial: {q: {crank_joint: 1.669335, coupler_joint: -1.318712, rocker_joint: 1.955453}}
duration: 0.5
)yaml"));
  running.advance_to(0.5);
  ASSERT_FALSE(running.simulator.events().empty());
  const EventRecord& impact = running.simulator.events().front();
  EXPECT_GT(impact.qd_before.cwiseAbs().minCoeff(), 0.1);
  EXPECT_LT((impact.qd_after + 0.5 * impact.qd_before).norm(), 1e-8 * impact.qd_before.norm());
}

TEST(Impact, CanBeSwitchedOff) {
  model::Scene scene = scene_of(kBall + "use: {impact: off}\n");
  EXPECT_FALSE(scene.phases.front().until.front().impact.has_value());
}

TEST(Events, OfTimeEndAPhaseAtThatTime) {
  Running run(scene_of(R"yaml(
scene: timed
model: drop.model.yaml
effects:
  gravity: [0, 0, -10]
  locked_joint:
    - {name: hook, joint: height}
phases:
  - name: held
    active: [hook]
    until:
      - {time: 0.25, then: falling}
  - name: falling
initial: {q: {height: 2}}
duration: 1
)yaml"));
  run.advance_to(1);
  ASSERT_EQ(run.simulator.events().size(), 1U);
  EXPECT_NEAR(run.simulator.events()[0].time, 0.25, 1e-14);
  EXPECT_NEAR(run.simulator.q()[0], 2 - 5 * 0.75 * 0.75, 1e-10);  // g t^2/2
}

TEST(Events, OfExpressionsAreLocated) {
  Running run(scene_of(R"yaml(
scene: thrown
model: drop.model.yaml
effects:
  gravity: [0, 0, -10]
phases:
  - name: up
    until:
      - {expression: "qd[height]", then: down}
  - name: down
    until:
      - {expression: "q[height] - 1 - t^2", crossing: falling, then: up}
initial: {qd: {height: 5}, q: {height: 1}}
duration: 1
)yaml"));
  run.advance_to(1);
  ASSERT_GE(run.simulator.events().size(), 2U);
  EXPECT_NEAR(run.simulator.events()[0].time, 0.5, 1e-12);        // 5/10
  EXPECT_NEAR(run.simulator.events()[1].time, 5.0 / 6.0, 1e-10);  // 5 t - 5 t^2 = t^2
}

/// The phases that two masses, which fall without weight, pass through by these events of each.
std::string phases_of_two(const std::string& tip, const std::string& press,
                          const std::string& stepping) {
  Running run(scene_of(fmt::format(
      R"yaml(
scene: two
model: ../../tests/scenes/models/two_scales.yaml
points: [{{name: a, link: tip, at: [0, 0, 0]}}, {{name: b, link: press, at: [0, 0, 0]}}]
effects: {{}}
phases:
  - {{name: above, until: [{{{0}, then: tip_below}}, {{{1}, then: press_below}}]}}
  - {{name: tip_below, until: [{{{1}, then: below}}]}}
  - {{name: press_below, until: [{{{0}, then: below}}]}}
  - {{name: below}}
initial: {{q: {{tip: 1, press: 1}}, qd: {{tip: -1, press: -1}}}}
duration: 2
stepping: {{{2}}}
)yaml",
      tip, press, stepping)));
  run.advance_to(2);
  std::string phases;
  for (const EventRecord& event : run.simulator.events()) {
    EXPECT_NEAR(event.time, 1, 1e-9);
    phases += run.scene.phases[static_cast<std::size_t>(event.then)].name + " ";
  }
  return phases;
}

TEST(Events, OfOneInstantHappenOneBehindTheOther) {
  for (const std::string stepping : {"integrator: fehlberg78", "integrator: rk4, step: 0.01",
                                     "integrator: semi-implicit-euler, step: 0.007"}) {
    SCOPED_TRACE(stepping);
    const auto both = testing::AnyOf("tip_below below ", "press_below below ");
    EXPECT_THAT(phases_of_two("touch_down: {point: a}", "touch_down: {point: b}", stepping), both);
    EXPECT_THAT(phases_of_two("expression: \"q[tip]\"", "expression: \"q[press]\"", stepping),
                both);
    EXPECT_THAT(phases_of_two("expression: \"q[tip]\"", "expression: \"1 - t\"", stepping), both);
    EXPECT_THAT(phases_of_two("expression: \"1e6*q[tip]\"", "expression: \"q[press]\"", stepping),
                both);
    EXPECT_THAT(phases_of_two("touch_down: {point: a}, not_before: 0.999",
                              "touch_down: {point: b}, not_before: 0.999", stepping),
                testing::AnyOf("tip_below ", "press_below "))
        << "the second one waits again";
  }
}

/// Two carriages that friction stops, the second one first or at the same time, and an event of
/// one speed.
/// \param initial  speed of the first and the time at the beginning
std::size_t events_of_stopping(const std::string& expression, double speed,
                               const std::string& begin, const std::string& stepping) {
  Running run(scene_of(fmt::format(
      "scene: s\nmodel: ../../tests/scenes/models/two_scales.yaml\neffects:\n"
      "  coulomb_friction: [{{joint: tip, force: 0.006}}, {{joint: press, force: 2400}}]\nphases:\n"
      "  - {{name: slides, until: [{{expression: \"{}\", then: stopped}}]}}\n"
      "  - {{name: stopped}}\ninitial: {{qd: {{tip: {}, press: 0.777}}, t: {}}}\nduration: 3\n"
      "stepping: {{{}}}\n",
      expression, speed, begin, stepping)));
  run.advance_to(run.simulator.time() + 3);
  EXPECT_EQ(run.simulator.qd()[0], 0);
  EXPECT_EQ(run.simulator.qd()[1], 0);
  return run.simulator.events().size();
}

TEST(Events, AreNoneOfTheSpeedOfAJointThatSticks) {
  for (const std::string stepping :
       {"integrator: fehlberg78", "integrator: dopri5", "integrator: rk4, step: 0.01",
        "integrator: rk4, step: 0.007"}) {
    SCOPED_TRACE(stepping);
    for (const double speed : {1.0, 0.777, 1.3}) {  // its speed falls through zero in steps alone
      EXPECT_EQ(events_of_stopping("qd[tip]", speed, "0", stepping), 0U) << speed;
      EXPECT_EQ(events_of_stopping("qd[press]", speed, "0", stepping), 0U) << speed;
    }
    EXPECT_EQ(events_of_stopping("qd[tip] - 1e-8", 1, "0", stepping), 1U);
    EXPECT_EQ(events_of_stopping("qd[tip] - 1e-8", 1, "1000", stepping), 1U) << "3 ns before";
  }
}

TEST(Events, OfAPointThatBeginsOnThePlaneHappenAtOnce) {
  const auto events = [](const char* height) {
    Running run(scene_of(fmt::format(
        "scene: s\nmodel: drop.model.yaml\npoints: [{{name: tip, link: ball, at: [0, 0, 0]}}]\n"
        "effects: {{gravity: [0, 0, -10]}}\nphases:\n"
        "  - {{name: above, until: [{{touch_down: {{point: tip}}, then: below}}]}}\n"
        "  - {{name: below}}\ninitial: {{q: {{height: {}}}, qd: {{height: -1}}}}\nduration: 1\n",
        height)));
    run.advance_to(1);
    return run.simulator.events().size();
  };
  EXPECT_EQ(events("0"), 1U);
  EXPECT_EQ(events("9e-11"), 1U);
  EXPECT_EQ(events("1e-9"), 1U);
  EXPECT_EQ(events("-1e-12"), 0U) << "is below already";
}

/// A mass held on the floor and pulled up by 20 t: it leaves when the pull exceeds its weight.
/// \param more  of the event
model::Scene pulled(const std::string& more) {
  return scene_of(R"yaml(
scene: pulled
model: drop.model.yaml
effects:
  gravity: [0, 0, -10]
  force:
    - {point: ball, value: [0, 0, 20*t]}
  point_constraint:
    - {name: floor, point: ball, along: [z]}
phases:
  - name: standing
    active: [floor]
    until:
      - {lift_off: {constraint: floor}, )yaml" +
                  more + R"yaml(then: flying}
  - name: flying
duration: 1
)yaml");
}

TEST(Events, OfLiftOffComeWhenTheReactionWouldPull) {
  Running run(pulled(""));
  run.advance_to(1);
  ASSERT_EQ(run.simulator.events().size(), 1U);
  EXPECT_NEAR(run.simulator.events()[0].time, 0.5, 1e-12);  // 20 t = m g
  // z'' = 20 (t - 1/2): z = 10/3 (t - 1/2)^3
  EXPECT_NEAR(run.simulator.q()[0], 10.0 / 24.0, 1e-9);
}

/// The floor pulls from t = 0.5 s on; steps begin before `not_before`, and end at it or behind.
TEST(Events, OfLiftOffWaitForTheirTime) {
  for (const char* const integrator : {"fehlberg78", "dopri5", "rk4", "semi-implicit-euler"}) {
    for (const double step : {0.4, 0.25, 0.01}) {
      model::Scene scene = pulled("not_before: 0.75, ");
      scene.stepping.integrator = integrator;
      scene.stepping.step = Real(step);
      Running run(scene);
      run.advance_to(1);
      ASSERT_EQ(run.simulator.events().size(), 1U) << integrator << step;
      EXPECT_NEAR(run.simulator.events()[0].time, 0.75, 1e-15) << integrator << step;  // rounding
    }
  }
  Running run(pulled("not_before: 0.25, "));
  run.advance_to(1);
  ASSERT_EQ(run.simulator.events().size(), 1U);
  EXPECT_NEAR(run.simulator.events()[0].time, 0.5, 1e-12);  // 20 t = m g
}

TEST(Events, ThatHardlyLetTimeAdvanceEndTheMotion) {
  for (const char* const integrator : {"fehlberg78", "rk4"}) {
    model::Scene scene = scene_of(
        "scene: restless\nmodel: drop.model.yaml\neffects: {gravity: [0, 0, -10]}\nphases:\n"
        "  - {name: ever, until: [{time: 1e-9, then: ever}]}\nduration: 1\n");
    scene.stepping.integrator = integrator;
    Running run(scene);
    const Recording recording = run.record(0.01);
    EXPECT_EQ(recording.stopped.find("events hardly let time advance: 999 of them in 1000 steps"),
              0U)
        << integrator << ": " << recording.stopped;
    EXPECT_NE(recording.stopped.find("'time' of phase 'ever'"), std::string::npos);
    EXPECT_EQ(recording.cost.steps, kTrial);
  }
}

/// Each of its phases takes some steps, however short it is.
TEST(Events, OfARockingBlockAreNamedAsWhatHoldsTimeBack) {
  Running run(
      scene_of("scene: rocking\nmodel: " + std::string(TREEDYN_SOURCE_DIR) +
               "/tests/scenes/models/rocking_block.yaml\neffects:\n  gravity: [0, 0, "
               "-9.81]\n  point_constraint:\n    - {name: left, point: left, along: [x, z]}\n"
               "    - {name: right, point: right, along: [x, z]}\nphases:\n"
               "  - {name: on_right, active: [right], until: [{touch_down: {point: left}, "
               "impact: {constraints: [left]}, then: on_left}]}\n"
               "  - {name: on_left, active: [left], until: [{touch_down: {point: right}, "
               "impact: {constraints: [right]}, then: on_right}]}\n"
               "initial: {q: {x_joint: 0.15*(1 - cos(0.1)), z_joint: 0.15*sin(0.1), tilt: "
               "0.1}}\nduration: 9\n"));
  const Recording recording = run.record(0.01);
  EXPECT_EQ(recording.stopped.find("steps hardly advance time: "), 0U) << recording.stopped;
  EXPECT_NE(recording.stopped.find(" events, 'touch_down of "), std::string::npos);
}

TEST(Events, CountAgainstTheStepsThatTheUserAllows) {
  Settings settings;
  settings.integrator = "rk4";
  settings.step = 0.01;
  const auto stopped = [&](double most_steps) {
    settings.most_steps = most_steps;
    Running run(scene_of("scene: s\nmodel: drop.model.yaml\neffects: {gravity: [0, 0, -10]}\n"
                         "phases:\n  - {name: a, until: [{time: 1/4096, then: a}]}\n"
                         "duration: 1\n"),
                &settings);
    return run.record(0.5).stopped;
  };
  EXPECT_EQ(stopped(5000), "");  // 4096 events and 100 steps
  EXPECT_NE(stopped(3000), "");
}

/// A tip above a plane that the lock of the elbow takes below it before the motion begins, and
/// one that it takes above.
TEST(Contact, IsOpenOrClosedByTheStateThatTheMotionBeginsWith) {
  for (const double height : {0.06, -0.45}) {
    Running run(
        scene_of("scene: s\nmodel: ../two_link.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
                 "  ground_contact: [{point: tip, stiffness: 1e4, height: " +
                 std::to_string(height) + "}]\n  locked_joint: [{joint: elbow, at: " +
                 (height > 0 ? "-0.5" : "0") + "}]\ninitial: {q: {shoulder: " +
                 (height > 0 ? "0.2, elbow: -0.3" : "0, elbow: -0.5") + "}}\nduration: 0.01\n"));
    const Vector q = run.simulator.q();
    const double depth = height - std::sin(q[0]) - std::sin(q[0] + q[1]);
    ASSERT_EQ(depth > 0, height > 0);
    const Recording recording = run.record(0.01);
    const double force = 1e4 * std::max(depth, 0.0);
    EXPECT_NEAR(column(recording, "F[tip.z]").front(), force, 1e-11);  // 1e4 times roundings
  }
}

TEST(Contact, OfSdirk2SettlesAtTheStaticDepth) {
  Settings settings;
  settings.integrator = "sdirk2";
  settings.step = 5e-3;
  Running run(scene_of(R"yaml(
scene: stiff
model: drop.model.yaml
effects:
  gravity: [0, 0, -10]
  ground_contact:
    - {point: ball, law: 1e7*d - 2e4*v}
initial: {q: {height: 0}}
duration: 2
)yaml"),
              &settings);
  run.advance_to(2);
  EXPECT_NEAR(run.simulator.q()[0], -1e-6, 1e-10);  // m g / k
}

/// One joint, unit inertia, no gravity: the laws of joint forces, term by term.
double acceleration_of(const std::string& effects, double q, double qd, double t) {
  const model::Scene scene =
      scene_of("scene: law\nmodel: drop.model.yaml\neffects:\n" + effects + "duration: 1\n");
  const auto dynamics = program_dynamics(scene);
  System system(scene, *dynamics, 0);
  return system.accelerate(t, Vector::Constant(1, q), Vector::Constant(1, qd)).qdd[0];
}

TEST(JointForces, FollowTheirLaws) {
  const double root = std::sqrt(0.3 * 0.3 + 0.1 * 0.1);
  EXPECT_NEAR(
      acceleration_of("  viscous_friction:\n    - {joint: height, coefficient: 2}\n", 0, 0.3, 0),
      -0.6, 1e-15);
  EXPECT_NEAR(
      acceleration_of("  coulomb_friction:\n    - {joint: height, force: 4, slip_speed: 0.1}\n", 0,
                      0.3, 0),
      -4 * 0.3 / root, 1e-15);
  EXPECT_NEAR(acceleration_of("  stribeck_friction:\n    - {joint: height, force: 4, static_force: "
                              "6, stribeck_speed: 0.3, slip_speed: 0.1}\n",
                              0, 0.3, 0),
              -(4 + 2 / 2.0) * 0.3 / root, 1e-15);
  EXPECT_NEAR(acceleration_of("  joint_spring:\n    - {joint: height, stiffness: 3, damping: 2, "
                              "rest: 0.5}\n",
                              0.1, 0.3, 0),
              -3 * (0.1 - 0.5) - 0.6, 1e-15);
  EXPECT_NEAR(acceleration_of("  armature:\n    - {joint: height, inertia: 3}\n  drive:\n    - "
                              "{joint: height, torque: \"8*sin(t)*q[height]\"}\n",
                              0.5, 0, 0.7),
              std::sin(0.7), 1e-15);
  EXPECT_NEAR(acceleration_of("  drive:\n    - {joint: height, kp: 5, kd: 2, target: t^2}\n", 0.1,
                              0.3, 0.5),
              5 * (0.25 - 0.1) + 2 * (1.0 - 0.3), 1e-15);
  EXPECT_NEAR(
      acceleration_of("  force:\n    - {point: ball, value: [9, 9, -2*z*vz]}\n", 0.4, 0.3, 0),
      -0.24, 1e-15);
}

/// The integral of dv sqrt(v^2 + s^2)/v, which falls by force/inertia a second.
double slip_integral(double v, double s) { return std::hypot(v, s) - s * std::asinh(s / v); }

TEST(Friction, WithASlipSpeedSlowsDownAsItsLawSays) {
  Running running(
      scene_of("scene: s\nmodel: drop.model.yaml\neffects:\n  coulomb_friction:\n"
               "    - {joint: height, force: 2, slip_speed: 0.3}\n"
               "initial: {qd: {height: 1.5}}\nduration: 0.5\n"));
  running.advance_to(0.5);
  EXPECT_NEAR(slip_integral(running.simulator.qd()[0], 0.3), slip_integral(1.5, 0.3) - 2 * 0.5,
              1e-9);
}

TEST(Friction, WithASlipSpeedLeavesStickingToOtherJoints) {
  Running running(
      scene_of("scene: s\nmodel: ../two_link.yaml\neffects:\n  coulomb_friction:\n"
               "    - {joint: shoulder, force: 2, slip_speed: 0.3}\n"
               "    - {joint: elbow, force: 1000}\n"
               "initial: {q: {elbow: 0.4}, qd: {shoulder: 1.5}}\nduration: 0.1\n"));
  const double force = 2 * 1.5 / std::hypot(1.5, 0.3);
  const double inertia = -force / running.simulator.solution().qdd[0];  // the elbow is stiff
  running.advance_to(0.1);
  EXPECT_NEAR(running.simulator.q()[1], 0.4, 1e-12);
  EXPECT_NEAR(slip_integral(running.simulator.qd()[0], 0.3),
              slip_integral(1.5, 0.3) - 2 * 0.1 / inertia, 1e-9);
}

/// A tip that is led such that the elbow turns back at 2 rad/s and the shoulder rests.
TEST(Friction, IsAgainstTheSpeedThatTheMotionBeginsWith) {
  for (const char* const speed : {"0.1", "0", "-2"}) {
    Running run(
        scene_of("scene: led\nmodel: ../two_link.yaml\neffects:\n"
                 "  coulomb_friction: [{joint: elbow, force: 5}]\n  point_constraint:\n"
                 "    - {point: tip, along: [x, z], curve: [cos(0.3) + cos(1.3 - 2*t), 0, "
                 "sin(0.3) + sin(1.3 - 2*t)]}\n"
                 "initial: {q: {shoulder: 0.3, elbow: 1}, qd: {elbow: " +
                 std::string(speed) + "}}\nduration: 0.1\n"));
    const Recording recording = run.record(0.1);
    EXPECT_EQ(recording.stopped, "") << speed;
    EXPECT_EQ(run.simulator.system().frictions()[0].direction, -1) << speed;
    EXPECT_NEAR(run.simulator.q()[1], 0.8, 1e-14) << speed;  // roundings of positions of size 1
  }
}

/// A carriage that its friction holds, and on it an inclined guide: the ball on it strikes the
/// floor and the carriage slides from there.
TEST(Friction, ThatSticksLetsAnImpactMoveTheJoint) {
  Running running(scene_of(R"yaml(
scene: slide
model: ../../tests/scenes/models/slide.yaml
effects:
  gravity: [0, 0, -10]
  coulomb_friction: [{joint: x, force: 4}]
  point_constraint: [{name: floor, point: ball, along: [z]}]
phases:
  - name: flight
    active: []
    until:
      - {touch_down: {point: ball}, impact: {constraints: [floor], restitution: 0.8}, then: flight}
initial: {q: {z: 1}}
duration: 1
)yaml"));
  running.advance_to(0.6);
  ASSERT_EQ(running.simulator.events().size(), 1U);
  const EventRecord& impact = running.simulator.events().front();
  EXPECT_EQ(impact.qd_before[0], 0);
  EXPECT_LT(impact.qd_after[0], -1);
  const double s = std::sin(0.5);
  const double braked = (4 + 0.7 * 10 * s * std::cos(0.5)) / (1.7 - 0.7 * s * s);
  const double time = 0.6 - impact.time;
  ASSERT_LT(time, -impact.qd_after[0] / braked);  // it still slides
  EXPECT_NEAR(running.simulator.qd()[0], impact.qd_after[0] + braked * time, 1e-8);
  EXPECT_NEAR(running.simulator.q()[0],
              impact.q[0] + impact.qd_after[0] * time + braked * time * time / 2, 1e-8);
}

/// The last rebounds end within a step, whose path is not the cubic through its ends.
TEST(Impact, OfEverSmallerReboundsEndsOnTheFloorByEveryMethod) {
  for (const char* const name : {"semi-implicit-euler", "rk4", "sdirk2"}) {
    for (const char* const step : {"0.0005", "0.001", "0.003"}) {
      model::Scene scene = scene_of(R"yaml(
scene: zeno
model: drop.model.yaml
effects:
  gravity: [0, 0, -9.81]
  point_constraint:
    - {name: floor, point: ball, along: [z]}
phases:
  - name: flight
    active: []
    until:
      - touch_down: {point: ball}
        impact: {constraints: [floor], restitution: 0.8, rest_below: 1e-4}
        then: flight
initial: {q: {height: 1}}
duration: 6
)yaml");
      scene.stepping.integrator = name;
      scene.stepping.step = Real(step);
      Running running(scene);
      running.advance_to(6);
      EXPECT_NEAR(running.simulator.q()[0], 0, 1e-9) << name << " " << step;
      EXPECT_NEAR(running.simulator.qd()[0], 0, 1e-9) << name << " " << step;
    }
  }
}

/// Both joints stop about at once; the first step behind it is no part of a turn that speeds of
/// 1e-34 tell.
TEST(Friction, ThatStopsAllJointsLeavesAStepThatAdvancesTime) {
  Running running(scene_of(R"yaml(
scene: stops
model: ../two_link.yaml
effects:
  gravity: [0, 0, -9.81]
  coulomb_friction: [{joint: shoulder, force: 150}, {joint: elbow, force: 60}]
  drive: [{joint: shoulder, torque: "300*sin(3*t)"}]
phases:
  - {name: one, until: [{time: 1.234, then: two}]}
  - {name: two, until: [{time: 0.5, then: one}]}
initial: {q: {shoulder: 0.5, elbow: 0.3}}
duration: 2
)yaml"));
  running.advance_to(2);
  EXPECT_EQ(running.simulator.time(), 2);
}

TEST(Rows, ComeInTheOrderOfTheFile) {
  const model::Scene scene = scene_of(
      "scene: s\nmodel: ../two_link.yaml\nduration: 1\neffects:\n"
      "  orientation_constraint:\n    - {name: keep, point: tip, along: [z]}\n"
      "  point_constraint:\n    - {name: pen, point: tip, along: [x]}\n"
      "    - {name: ink, point: tip, along: [y]}\n"
      "  locked_joint:\n    - {joint: elbow}\n");
  std::vector<std::string> names;
  for (const model::Constraint& constraint : scene.constraints) {
    names.push_back(constraint.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"keep", "pen", "ink", "elbow"}));
}

/// The message of a run of a ball, moved up and down only, under point constraints.
std::string message_of_ball(const std::string& constraints) {
  try {
    Running(scene_of("scene: s\nmodel: drop.model.yaml\neffects:\n  point_constraint:\n" +
                     constraints + "duration: 1\n"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(InitialState, IsRefusedWhereNoStateMeetsTheConstraints) {
  EXPECT_EQ(message_of_ball("    - {point: ball, along: [x, z], curve: [0, 0, 2*t]}\n"), "");
  EXPECT_EQ(message_of_ball("    - {point: ball, along: [x, z], curve: [1, 0, 2*t]}\n"),
            "the initial state is not near one that meets the constraints: 'ball' stays 1 off");
  EXPECT_EQ(message_of_ball("    - {point: ball, along: [x, z], curve: [t, 0, 2*t]}\n"),
            "no velocity meets the constraints at the initial state: 'ball' stays 1 off");
}

TEST(InitialState, MayHoldTwoPointsOfOneLinkLevel) {
  const Running run(
      scene_of("scene: s\nmodel: ../two_link.yaml\neffects:\n  gravity: [0, 0, -9.81]\n  "
               "joined_constraint: [{point: forearm, other: tip, along: [z]}]\ninitial: {q: "
               "{shoulder: 0.3, elbow: -0.3}}\nduration: 1\n"));
  EXPECT_NEAR(run.simulator.q()[0] + run.simulator.q()[1], 0, 1e-12);
}

/// A free body without forces whose angular velocity has no part along some directions.
std::string leaned(const std::string& along) {
  return "scene: s\nmodel: ../../tests/scenes/models/free_body.yaml\nbase: axes\neffects:\n"
         "  orientation_constraint: [{point: body, along: [" +
         along + "]}]\ninitial: {qd: {base_rx: 1, base_ry: 0.7}}\nduration: 1\n";
}

/// omega d = 0 does no work, and it is the rate of no angle: nothing may turn the body back.
TEST(Orientation, InOneDirectionIsALawOfSpeeds) {
  Settings settings;
  settings.drift = model::Drift::kNone;
  Running free(scene_of(leaned("z")), &settings);
  free.advance_to(1);
  Running run(scene_of(leaned("z")));
  const Recording recording = run.record(0.1);
  EXPECT_TRUE(recording.notices.empty());
  EXPECT_EQ(recording.drift, 0);
  const double steps = static_cast<double>(recording.cost.steps);
  const double bound = steps * settings.tolerance * 10;  // joint speeds, up to ten of the body's
  EXPECT_LT((run.simulator.q() - free.simulator.q()).cwiseAbs().maxCoeff(), bound);
  for (const double energy : column(recording, "energy")) {
    EXPECT_NEAR(energy, (1 + 2 * 0.7 * 0.7) / 2, bound);
  }
  const double speed =
      run.simulator.system().speed_violation(1, run.simulator.q(), run.simulator.qd()).size;
  EXPECT_LT(speed, 1e-15);  // a few roundings of speeds of size 1
}

TEST(Orientation, HasAPositionWhereItsDirectionsSpanTheSpace) {
  const auto has_position = [](const std::string& along) {
    Constraints constraints(scene_of(leaned(along)));
    constraints.activate({0});
    return constraints.has_position(0);
  };
  EXPECT_TRUE(has_position("x, y, z"));
  EXPECT_TRUE(has_position("[1, 1, 0], [1, -1, 0], [1, 1, 1]"));
  EXPECT_FALSE(has_position("x, y"));
  EXPECT_FALSE(has_position("[1, 1, 0], [1, -1, 0], x"));
}

TEST(Rows, MayStateTheirAcceleration) {
  Running run(scene_of(R"yaml(
scene: stated
model: ../two_link.yaml
effects:
  gravity: [0, 0, -9.81]
  point_constraint:
    - {name: hand, point: tip, along: [x, z], acceleration: ["sin(t)", 0]}
initial: {
q : {
shoulder:
  0.3, elbow : 1
}
}
duration: 1
)yaml"));
  const Eigen::Vector3d before = run.simulator.system().geometry(run.simulator.q()).p();
  run.advance_to(1);
  const Eigen::Vector3d after = run.simulator.system().geometry(run.simulator.q()).p();
  EXPECT_NEAR(after[0] - before[0], 1 - std::sin(1.0), 1e-9);  // twice the integral of sin
  EXPECT_NEAR(after[2] - before[2], 0, 1e-9);
}

TEST(VelocityProducts, VanishWhenTheyAreSwitchedOff) {
  const std::string text =
      "scene: s\nmodel: ../two_link.yaml\nduration: 1\n"
      "initial: {q: {elbow: 1}, qd: {shoulder: 2, elbow: 3}}\n";
  const auto acceleration = [](const model::Scene& scene) {
    const auto dynamics = program_dynamics(scene);
    System system(scene, *dynamics, 0);
    const Vector q = (Vector(2) << 0, 1).finished();
    const Vector qd = (Vector(2) << 2, 3).finished();
    return system.accelerate(0, q, qd).qdd.norm();
  };
  EXPECT_GT(acceleration(scene_of(text)), 1);
  EXPECT_EQ(acceleration(scene_of(text + "use: {velocity_products: off}\n")), 0);
}

TEST(Effects, ThatAreOffLeaveNoTrace) {
  const std::string text =
      "scene: s\nmodel: ../two_link.yaml\nduration: 1\neffects:\n"
      "  gravity: [0, 0, -9.81]\n  armature:\n    - {joint: elbow, inertia: 1}\n"
      "  force:\n    - {point: tip, value: [1, 2, 3]}\n";
  const model::Scene off = scene_of(text + "use: {gravity: off, armature: off, force: off}\n");
  EXPECT_EQ(off.gravity, (model::Vector3{0, 0, 0}));
  EXPECT_TRUE(off.armatures.empty());
  EXPECT_TRUE(off.point_laws.empty());
  EXPECT_TRUE(off.points.empty());
}

}  // namespace
}  // namespace treedyn::simulation
