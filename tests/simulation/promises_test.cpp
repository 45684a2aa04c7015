// What a motion promises: each broken promise is noticed, and ends the motion beyond its bound.
#include <cmath>
#include <complex>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "simulation/run_scene.hpp"
#include "support/damping.hpp"

namespace treedyn::simulation {
namespace {

const Notice* find(const std::vector<Notice>& notices, const std::string& kind) {
  const auto row =
      std::find_if(notices.begin(), notices.end(), [&](const Notice& n) { return n.kind == kind; });
  return row == notices.end() ? nullptr : &*row;
}

model::Scene falling_ball(const std::string& more) {
  return scene_of("scene: s\nmodel: drop.model.yaml\n" + more);
}

double most(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// 778 J out of 9.81 J, with steps that never see the ground softly.
TEST(Energy, OutOfNothingEndsTheMotion) {
  model::Scene scene = committed("drop");
  scene.stepping.integrator = "semi-implicit-euler";
  scene.stepping.step = Real("0.002");
  Running run(scene);
  const Recording recording = run.record(0.01);
  EXPECT_NE(recording.stopped.find("energy grows without power"), std::string::npos);
  const Notice* const notice = find(recording.notices, "energy");
  ASSERT_NE(notice, nullptr);
  EXPECT_NEAR(notice->time, std::sqrt(2 / 9.81), 0.002);  // where it meets the ground
  EXPECT_LT(most(column(recording, "energy")), 2 * 9.81);
}

/// A pendulum let go at 120 degrees: steps of a seventh of its period take a third of its energy
/// away.
TEST(Energy, LostToNoForceIsTold) {
  model::Scene scene = committed("pendulum");
  scene.stepping.integrator = "rk4";
  scene.stepping.step = Real("0.4");
  Running run(scene);
  const Recording recording = run.record(0.4);
  EXPECT_EQ(recording.stopped, "");
  const Notice* const notice = find(recording.notices, "energy");
  ASSERT_NE(notice, nullptr);
  EXPECT_NE(notice->text.find("energy is lost to no force"), std::string::npos) << notice->text;
  const std::vector<double> energy = column(recording, "energy");
  EXPECT_NEAR(notice->worst, energy.front() - energy.back(), 1e-12);
}

TEST(Energy, OfDrivesAndLedPointsIsExplainedByTheirWork) {
  for (const char* const name : {"arm_circle", "four_bar", "drop", "biped_double_support"}) {
    Running run(committed(name));
    const Recording recording = run.record(0.1);
    EXPECT_EQ(recording.stopped, "") << name;
    EXPECT_EQ(find(recording.notices, "energy"), nullptr) << name;
    EXPECT_LT(recording.energy_part, 1e-6) << name;
  }
}

/// 1 kg that friction holds until the drive is stronger: the roundings of nothing are no energy.
/// Euler's work lags by half a step: h/2 times the integral of m a^2, 2/3 h of the energy at the
/// end.
TEST(Energy, OfWhatHasNotMovedIsNone) {
  for (const char* const step : {"0.001", "0.013", "0.03"}) {
    model::Scene scene = falling_ball(
        "effects:\n  coulomb_friction: [{joint: height, force: 4}]\n  drive: [{joint: height, "
        "torque: 2*t}]\nduration: 4\n");
    scene.stepping.integrator = "semi-implicit-euler";
    scene.stepping.step = Real(step);
    Running run(scene);
    const Recording recording = run.record(0.1);
    EXPECT_EQ(recording.stopped, "") << step;
    EXPECT_EQ(find(recording.notices, "energy"), nullptr) << step;
    EXPECT_LT(recording.energy_part, std::stod(step)) << step;
  }
}

/// The forces of a fixed step are its own quadrature: the balance closes to the method's order.
TEST(Energy, IsBalancedByEveryMethod) {
  for (const char* const name : {"rk4", "dopri5-fixed", "sdirk2", "dopri5"}) {
    model::Scene scene = committed("arm_circle");
    scene.stepping.integrator = name;
    Running run(scene);
    EXPECT_LT(run.record(0.1).energy_part, 1e-5) << name;
  }
}

/// A method of order 1 lags by half a step: all of the energy at first, when there is little.
TEST(Energy, OfTheFirstStepsFromRestIsNoWarning) {
  for (const char* const effects : {"gravity: [0, 0, -10]", "drive: [{joint: height, torque: 3}]",
                                    "joint_spring: [{joint: height, stiffness: 9, rest: 1}]"}) {
    model::Scene scene = falling_ball("effects: {" + std::string(effects) + "}\nduration: 3\n");
    scene.stepping.integrator = "semi-implicit-euler";
    Running run(scene);
    const Recording recording = run.record(0.1);
    EXPECT_EQ(recording.stopped, "") << effects;
    EXPECT_TRUE(recording.notices.empty()) << effects;
  }
}

const std::string kContradiction = R"yaml(
effects:
  locked_joint:
    - {name: led, joint: height, at: t^3}
  point_constraint:
    - {name: held, point: ball, along: [z]}
duration: 2
)yaml";

/// Each of the two goes half of t^3: 0.01 m at t = 0.27; 4 m at the end.
TEST(Constraints, ThatPartEndTheMotion) {
  for (const char* const name : {"fehlberg78", "rk4"}) {
    model::Scene scene = falling_ball(kContradiction);
    scene.stepping.integrator = name;
    Running run(scene);
    const Recording recording = run.record(0.004);
    EXPECT_NE(recording.stopped, "") << name;
    EXPECT_LT(recording.rows.back().t, 0.5);
    ASSERT_NE(find(recording.notices, "drift"), nullptr);
    ASSERT_NE(find(recording.notices, "residual"), nullptr);
    EXPECT_LT(find(recording.notices, "drift")->time, 0.1);
  }
}

TEST(Constraints, MayDriftFurtherIfTheUserSaysSo) {
  const model::Scene scene = falling_ball(kContradiction);
  Settings settings;
  settings.bounds.drift_end = 100;
  settings.bounds.residual_end = 1e9;
  Running run(scene, &settings);
  const Recording recording = run.record(0.01);
  EXPECT_EQ(recording.stopped, "");
  EXPECT_NEAR(recording.drift, 4, 4.1);
  EXPECT_NE(find(recording.notices, "drift"), nullptr);
}

/// The tip is held at the end of the reach: J = 0.
TEST(Constraints, ThatNoJointMovesAreNamedAndDoNotRunForEver) {
  Running run(
      scene_of("scene: stretched\nmodel: ../two_link.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
               "  point_constraint:\n    - {point: tip, along: [x], curve: [2, 0, 0]}\n"
               "duration: 2\n"));
  const Recording recording = run.record(0.1);
  EXPECT_NE(recording.stopped, "");
  const Notice* const notice = find(recording.notices, "position");
  ASSERT_NE(notice, nullptr);
  EXPECT_EQ(notice->name, "tip.x");
  EXPECT_EQ(notice->time, 0);
}

/// Crank and rod fold onto each other, where their one row is zero. A method that goes wild there
/// does work by its reaction, which the row does not have.
TEST(Constraints, WhoseReactionsDoWorkOfTheirOwnEndTheMotion) {
  for (const Drift drift : {Drift::kProjection, Drift::kBaumgarte, Drift::kNone}) {
    model::Scene scene = description::read_scene(std::string(TREEDYN_SOURCE_DIR) +
                                                 "/tests/data/hard_cases/t16_folding_crank.json");
    scene.stepping.integrator = "sdirk2";
    scene.stepping.step = Real("0.01");
    scene.stepping.drift = drift;
    Running run(scene);
    const Recording recording = run.record(0.01);
    EXPECT_NE(recording.stopped, "");
    EXPECT_FALSE(recording.notices.empty());
    EXPECT_LT(most(column(recording, "kinetic_energy")), 1e3);
  }
}

/// Where crank and rod fold, two motions meet; these three methods took the other one.
TEST(Constraints, ThatNoLongerTellTheBranchEndTheMotion) {
  struct Method {
    const char* integrator;
    Drift drift;
    bool ends;
  };
  for (const Method& method :
       {Method{"dopri5", Drift::kNone, true}, Method{"fehlberg78", Drift::kNone, true},
        Method{"sdirk2", Drift::kBaumgarte, true}, Method{"dopri5", Drift::kProjection, false},
        Method{"rk4", Drift::kNone, false}, Method{"rk4", Drift::kBaumgarte, false}}) {
    SCOPED_TRACE(method.integrator);
    model::Scene scene = description::read_scene(std::string(TREEDYN_SOURCE_DIR) +
                                                 "/tests/data/hard_cases/t16_folding_crank.json");
    scene.stepping.integrator = method.integrator;
    scene.stepping.step = Real("0.001");
    scene.stepping.drift = method.drift;
    Running run(scene);
    const Recording recording = run.record(0.01);
    EXPECT_EQ(recording.stopped.find("no longer tell where") != std::string::npos, method.ends);
    EXPECT_EQ(find(recording.notices, "branch") != nullptr, method.ends);
    // the last row of the table is before the bound, or at the end: there the rod has not left
    EXPECT_NEAR(column(recording, "q[rod]").back(), -2 * column(recording, "q[crank]").back(),
                1e-3);
  }
}

/// A phase that holds the ball while it falls: projection stops it, other steps let it go on.
TEST(Constraints, ThatBeginAtASpeedAreNoticed) {
  for (const char* const impact : {"", "impact: {constraints: [floor]}, "}) {
    Running run(falling_ball(
        std::string("effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: floor, point: "
                    "ball, along: [z]}]\nphases:\n  - name: fall\n    active: []\n    until:\n"
                    "      - {touch_down: {point: ball}, ") +
        impact +
        "then: stand}\n  - {name: stand, active: [floor]}\n"
        "initial: {q: {height: 0.2}}\nduration: 1\n"));
    const Recording recording = run.record(0.01);
    const Notice* const notice = find(recording.notices, "speed");
    ASSERT_EQ(notice != nullptr, std::string(impact).empty());
    if (notice != nullptr) {
      EXPECT_NEAR(notice->value, 2, 1e-9);
      EXPECT_NEAR(notice->time, 0.2, 1e-9);
    }
  }
}

/// Of a pendulum whose size is 1 m, which is no unit of angles.
TEST(Constraints, OfAnglesAreToldInTheirUnits) {
  Running run(scene_of(
      "scene: caught\nmodel: pendulum.model.yaml\neffects:\n  locked_joint: [{name: hold, joint: "
      "pivot}]\nphases:\n  - {name: free, active: [], until: [{time: 0.1, then: held}]}\n"
      "  - {name: held, active: [hold]}\ninitial: {qd: {pivot: 2}}\nduration: 0.2\n"));
  const Recording recording = run.record(0.01);
  const Notice* const notice = find(recording.notices, "speed");
  ASSERT_NE(notice, nullptr);
  EXPECT_EQ(notice->unit, "1/s");
  EXPECT_NE(notice->text.find("at a speed of 2 1/s"), std::string::npos) << notice->text;
}

/// A plastic impact that returns to the fall: the next one comes at once.
TEST(Rest, IsAskedForWhereImpactsPileUp) {
  Running run(falling_ball(
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: floor, point: ball, along: "
      "[z]}]\nphases:\n  - name: fall\n    active: []\n    until:\n      - {touch_down: {point: "
      "ball}, impact: {constraints: [floor], restitution: 0}, then: fall}\n"
      "initial: {q: {height: 0.2}}\nduration: 1\n"));
  const Recording recording = run.record(0.01);
  EXPECT_NE(recording.stopped.find("the impact needs rest_below"), std::string::npos)
      << recording.stopped;
}

TEST(Rest, ThatNobodyAskedForEndsWhereTheFloorWouldPull) {
  Running run(falling_ball(
      "effects:\n  gravity: [0, 0, -10]\n  force: [{point: ball, value: [0, 0, 5*t]}]\n"
      "  point_constraint: [{name: floor, point: ball, along: [z]}]\nphases:\n  - name: fall\n"
      "    active: []\n    until:\n      - {touch_down: {point: ball}, impact: {constraints: "
      "[floor], restitution: 0.5}, then: fall}\ninitial: {q: {height: 0.1}}\nduration: 3\n"));
  const Recording recording = run.record(0.01);
  EXPECT_EQ(recording.stopped, "");
  EXPECT_GE(recording.events.size(), 2U);
  EXPECT_EQ(recording.events.back().name, "lift_off of floor");
  EXPECT_NEAR(recording.events.back().time, 2, 1e-9);
  EXPECT_NEAR(column(recording, "q[height]").back(), 5.0 / 6, 1e-8);  // qdd = 5 (t - 2)
}

TEST(Constraints, ThatNoPositionMovesAreNoWarning) {
  Running run(
      falling_ball("effects:\n  point_constraint:\n    - {point: ball, along: [x, z]}\n"
                   "duration: 1\n"));
  const Recording recording = run.record(0.1);
  EXPECT_EQ(recording.stopped, "");
  EXPECT_TRUE(recording.notices.empty());
}

std::string guarded(const std::string& guard, const std::string& more) {
  return "effects: {gravity: [0, 0, -10]}\nphases:\n  - name: a\n    until:\n      - {expression: "
         "\"" +
         guard + "\", then: a" + more + "}\nduration: 1\n";
}

TEST(Guards, ThatAreNotANumberEndTheMotionWhereTheyCeaseToBe) {
  Running run(falling_ball(guarded("2 + sqrt(1/4 - t)", "")));
  const Recording recording = run.record(0.01);
  EXPECT_NE(recording.stopped.find("not a number"), std::string::npos);
  EXPECT_LE(recording.rows.back().t, 0.25);
}

/// sqrt(0.01 - d) deeper than 10 mm; no force had been taken there.
TEST(Contacts, WhoseLawIsNotANumberEndTheMotion) {
  Running run(
      falling_ball("effects:\n  gravity: [0, 0, -9.81]\n  ground_contact: [{point: ball, "
                   "law: \"1000*sqrt(0.01-d)\"}]\ninitial: {q: {height: 0.1}}\nduration: "
                   "0.4\nstepping: {integrator: rk4, step: 0.001}\n"));
  const Recording recording = run.record(0.05);
  EXPECT_NE(recording.stopped.find("the motion is not finite"), std::string::npos)
      << recording.stopped;
}

/// Nothing here depends on time: a motion that begins before t = 0 is the one that begins there.
TEST(Motions, ThatBeginBeforeZeroAreTheSame) {
  for (const char* const effect :
       {"ground_contact: [{point: ball, stiffness: 150, exponent: 1.5, dissipation: 0.2}]",
        "coulomb_friction: [{joint: height, force: 12}]"}) {
    std::vector<std::vector<double>> ends;
    for (const char* const begin : {"0", "-1.3"}) {
      Running run(falling_ball(
          fmt::format("effects:\n  gravity: [0, 0, -9.81]\n  {}\ninitial: {{q: {{height: 0.02}}, "
                      "qd: {{height: -0.5}}, t: {}}}\nduration: 0.4\n",
                      effect, begin)));
      const Recording recording = run.record(0.1);
      ends.push_back(recording.rows.back().values);  // q, qd
    }
    EXPECT_NEAR(ends[0][0], ends[1][0], 1e-9) << effect;
    EXPECT_NEAR(ends[0][1], ends[1][1], 1e-8) << effect;
  }
}

TEST(Drives, WithoutAValueAreNamed) {
  Running run(
      falling_ball("effects:\n  gravity: [0, 0, -10]\n  drive: [{joint: height, torque: "
                   "\"1000*sqrt(t - 1/4)\"}]\nduration: 1\n"));
  EXPECT_EQ(run.record(0.01).stopped, "drive of joint 'height' has no value at t = 0 s");
}

/// The last state that is finite has a value still.
TEST(Drives, ThatLoseTheirValueAreNamed) {
  Running run(
      falling_ball("effects:\n  gravity: [0, 0, -10]\n  drive: [{joint: height, torque: "
                   "\"sqrt(1/4 - t)\"}]\nduration: 1\n"));
  EXPECT_EQ(run.record(0.01).stopped,
            "drive of joint 'height' has no value just behind t = 0.25 s");
}

TEST(PointSprings, WithoutADirectionAreNamed) {  // the damper's, where the point is at its anchor
  Running run(falling_ball(
      "effects:\n  gravity: [0, 0, -10]\n  point_spring: [{point: ball, anchor: [0, 0, "
      "0], stiffness: 10, damping: 1}]\nduration: 1\n"));
  EXPECT_EQ(run.record(0.01).stopped, "point_spring of point 'ball' has no value at t = 0 s");
}

TEST(Guards, AreNotAskedBeforeTheirTime) {
  Running run(falling_ball(guarded("2 + sqrt(t - 1/4)", ", not_before: 0.3")));
  EXPECT_EQ(run.record(0.01).stopped, "");
}

TEST(Steps, ThatDoNotAdvanceTimeEndTheMotion) {
  model::Scene scene = falling_ball("initial: {t: 1}\nduration: 1\n");
  scene.stepping.integrator = "rk4";
  scene.stepping.step = Real("1e-17");
  Running run(scene);
  EXPECT_NE(run.record(0.01).stopped.find("does not advance time"), std::string::npos);
}

TEST(Steps, OfAToleranceBelowTheRoundingEndTheMotion) {
  model::Scene scene = committed("pendulum");
  scene.stepping.tolerance = Real("1e-25");
  Running run(scene);
  EXPECT_NE(run.record(0.01).stopped, "");
}

/// The same to the last bit; a sum of 0.1 is another number.
TEST(Steps, OfFixedLengthEndAtMultiplesOfIt) {
  model::Scene scene = falling_ball("initial: {t: 0.3}\nduration: 10\n");
  scene.stepping.integrator = "rk4";
  scene.stepping.step = Real("0.1");
  Running run(scene);
  int k = 0;
  run.simulator.advance_to(10.3, [&] {
    ++k;
    EXPECT_EQ(run.simulator.time(), k == 100 ? 10.3 : 0.3 + k * 0.1);
    return true;
  });
  EXPECT_EQ(k, 100);
}

/// Motions of a scene with other durations and tables: the same steps.
TEST(Steps, AreThoseOfTheDynamicsAlone) {
  for (const char* const name : {"pendulum", "compass_walk"}) {
    std::vector<Vector> ends;
    std::vector<double> events;
    for (const auto& [duration, output] : {std::pair{"2", 0.1}, {"2", 0.003}, {"200", 2.0}}) {
      model::Scene scene = committed(name);
      scene.duration = Real(duration);
      Running run(scene);
      run.simulator.show_at(output, [] {});
      long steps = 0;
      run.simulator.advance_to(static_cast<double>(scene.duration), [&] { return ++steps < 20; });
      ends.push_back(run.simulator.q());
      events.push_back(run.simulator.events().empty() ? 0 : run.simulator.events()[0].time);
    }
    EXPECT_EQ(ends[1], ends[0]) << name;
    EXPECT_EQ(ends[2], ends[0]) << name;
    EXPECT_EQ(events[1], events[0]) << name;
    EXPECT_EQ(events[2], events[0]) << name;
  }
}

double limit_of(const model::Scene& scene, const std::string& integrator) {
  Running run(scene);
  for (const StabilityLimit& limit : run.simulator.stability(*run.dynamics).limits) {
    if (limit.integrator == integrator) {
      return limit.step.value_or(0);
    }
  }
  return -1;
}

/// hard_cases s15: 2/omega and 2 sqrt(2)/omega without damping.
TEST(Stability, LimitsOfAnOscillatorAreThoseOfTheTextbooks) {
  model::Scene scene = description::read_scene(std::string(TREEDYN_SOURCE_DIR) +
                                               "/tests/data/hard_cases/s15_stiff_contact.json");
  support::each_damping(scene, [](Real& damping) { damping = 0; });
  EXPECT_NEAR(limit_of(scene, "semi-implicit-euler"), 0.002, 1e-8);
  EXPECT_NEAR(limit_of(scene, "rk4"), 0.00282842712475, 1e-8);
  EXPECT_EQ(limit_of(scene, "sdirk2"), 0);                              // none
  support::each_damping(scene, [](Real& damping) { damping = 1000; });  // omega^2 h^2 + 2 d h = 4
  EXPECT_NEAR(limit_of(scene, "semi-implicit-euler"), (std::sqrt(5.0) - 1) * 1e-3, 1e-8);
}

/// The largest step up to which the roots of z^2 - (2 - c h - k h^2) z + (1 - c h) = 0 stay within
/// the unit circle.
double limit_of_roots(std::complex<double> c, double k) {
  double low = 0;
  double high = 0.01;
  for (int n = 0; n < 60; ++n) {
    const double h = (low + high) / 2;
    const std::complex<double> p = 2.0 - c * h - k * h * h;
    const std::complex<double> root = std::sqrt(p * p - 4.0 * (1.0 - c * h));
    const double largest = std::max(std::abs(p + root), std::abs(p - root)) / 2;
    (largest > 1 + kGrowth ? high : low) = h;
  }
  return low;
}

/// A mass in a plane, forces across its velocity: x + i y is one complex oscillator, whose modes
/// leave the unit circle as pairs.
TEST(Stability, OfSemiImplicitEulerEndsWherePairsGrow) {
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "plane.yaml")
      << "name: plane\nlinks:\n"
         "  - {name: a, father: ground, joint: {name: x, type: prismatic, axis: [1, 0, 0]}}\n"
         "  - {name: b, father: a, joint: {name: y, type: prismatic, axis: [0, 1, 0]}, mass: 1}\n";
  std::ofstream(folder + "across.yaml")
      << "scene: across\nmodel: plane.yaml\nduration: 1\neffects:\n  drive:\n"
         "    - {joint: x, torque: \"-25*q[x] + 10*qd[y] - 0.2*qd[x]\"}\n"
         "    - {joint: y, torque: \"-25*q[y] - 10*qd[x] - 0.2*qd[y]\"}\n";
  const model::Scene scene = description::read_scene(folder + "across.yaml");
  const double limit = limit_of_roots({0.2, 10}, 25);
  EXPECT_NEAR(limit_of(scene, "semi-implicit-euler"), limit, 1e-5 * limit);
}

/// drop closes its contact to the depth that stores the fall's m g h: k d^(n+1)/(n+1).
TEST(Stability, ClosesContactsToTheDepthOfTheFall) {
  Running run(committed("drop"));
  const Stability stability = run.simulator.stability(*run.dynamics);
  ASSERT_EQ(stability.depths.size(), 1U);
  EXPECT_EQ(stability.depths[0].first, "ball");
  const double depth = std::pow(9.81 * 2.5 / 1e8, 0.4);
  EXPECT_NEAR(stability.depths[0].second, depth, 1e-3 * depth);
  const double k = 1.5e8 * std::sqrt(depth);
  const double d = 0.3e8 * std::pow(depth, 1.5);
  EXPECT_NEAR(limit_of(run.scene, "semi-implicit-euler"), (std::sqrt(d * d + 4 * k) - d) / k, 1e-6);
}

TEST(Stability, WarnsOfStepsBeyondIt) {
  for (const auto& [step, warns] : {std::pair{"0.002", true}, {"0.0003", false}}) {
    model::Scene scene = committed("drop");
    scene.stepping.integrator = "semi-implicit-euler";
    scene.stepping.step = Real(step);
    Running run(scene);
    run.simulator.stability(*run.dynamics);
    EXPECT_EQ(find(run.simulator.monitor().notices(), "step") != nullptr, warns) << step;
  }
}

}  // namespace
}  // namespace treedyn::simulation
