// `treedyn simulate --as-generated`: the motion that generated code computes.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn::support {
namespace {

using Json = nlohmann::json;

const std::string kScenes = std::string(TREEDYN_SOURCE_DIR) + "/models/scenes/";

Outcome simulated(const std::string& scene, const std::vector<std::string>& options) {
  std::vector<std::string> command = {TREEDYN_EXECUTABLE, "simulate", scene, "--json"};
  command.insert(command.end(), options.begin(), options.end());
  return run(command);
}

/// The last row of a table, behind t and phase: q, qd and the rest.
std::vector<double> last_state(const Json& result, std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) {
    values.push_back(result.at("rows").back().at(k + 2));
  }
  return values;
}

const std::string kTwoLink = TREEDYN_SOURCE_DIR "/models/two_link.yaml";

/// Ends of the motion of a scene: of generated code and of the simulator.
std::vector<Json> both_ends(const std::string& lines, const std::string& model = kTwoLink,
                            const std::vector<std::string>& simulator = {}) {
  const TemporaryFolder folder;
  const std::string scene = (folder.path() / "s.yaml").string();
  write_file(scene, "scene: s\nmodel: " + model + "\n" + lines);
  std::vector<Json> result;
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--as-generated"}, simulator}) {
    const Outcome outcome = simulated(scene, options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    result.push_back(outcome.status == 0 ? Json::parse(outcome.out) : Json());
  }
  return result;
}

// Where the shoulder stops both joints could stick, and find their ways one after the other, all
// within one step. Of rk4 at 1 ms some 3000 steps are left: 3000 * (1 ms * 10/s)^5 = 3e-7.
TEST(AsGenerated, FindsTheWaysOfTwoJointsThatStick) {
  const std::vector<Json> ends = both_ends(
      "effects:\n  gravity: [0, 0, -9.81]\n  coulomb_friction: [{joint: elbow, force: 150}, "
      "{joint: "
      "shoulder, force: 300}]\n  drive: [{joint: shoulder, torque: \"735 + "
      "400*sin(3*t)\"}]\ninitial: {q: {shoulder: 0.3, elbow: 0.5}}\nduration: 3\nstepping: "
      "{integrator: rk4, step: 0.001}\n");
  const std::vector<double> ours = last_state(ends[0], 4);
  const std::vector<double> theirs = last_state(ends[1], 4);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(ours[k], theirs[k], 3e-7) << k;
  }
}

/// The ends of the motion of a scene of its own model.
std::vector<Json> both_ends_of(const std::string& model, const std::string& scene) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "model.yaml").string();
  write_file(file, model);
  return both_ends(scene, file, {"--integrator", "fehlberg78"});
}

const std::string kBall =
    "name: ball\nlinks:\n  - name: ball\n    father: ground\n    joint: {name: height, type: "
    "prismatic, axis: [0, 0, 1]}\n    mass: 1\npoints: [{name: foot, link: ball, at: [0, 0, 0]}]\n";

// A floor holds a ball for a while, lets go, and has to take it again: it is on the plane but for
// roundings. What falls from rest below the plane touches down as well.
TEST(AsGenerated, TouchesDownWhereAPhaseLetsGo) {
  for (const char* const method : {"rk4", "dopri5-fixed", "sdirk2", "semi-implicit-euler"}) {
    for (const double begin : {0.3, 0.1, 0.05}) {
      const std::vector<Json> ends = both_ends_of(
          kBall,
          fmt::format("effects:\n  gravity: [0, 0, -9.81]\n  point_constraint: [{{name: "
                      "floor, point: foot, along: [z]}}]\nphases:\n  - name: air\n    "
                      "active: []\n    until: [{{touch_down: {{point: foot, height: 0.1}}, "
                      "impact: {{constraints: [floor]}}, then: stance}}]\n  - name: stance\n "
                      "   active: [floor]\n    until: [{{time: 0.2, then: air}}]\ninitial: "
                      "{{q: {{height: {}}}}}\nduration: 1\nstepping: {{integrator: {}, step: "
                      "0.001}}\n",
                      begin, method));
      EXPECT_NEAR(last_state(ends[0], 1)[0], std::min(begin, 0.1), 1e-5) << method << begin;
      if (begin > 0.1) {  // the simulator waits for what comes from above
        EXPECT_NEAR(last_state(ends[1], 1)[0], 0.1, 1e-9);
      }
    }
  }
}

// On the plane and at rest, to begin with, what falls has hardly moved when the event is looked
// for.
TEST(AsGenerated, TouchesDownWhereItBeginsToFall) {
  for (const char* const method : {"rk4", "dopri5-fixed", "sdirk2", "semi-implicit-euler"}) {
    for (const double step : {0.001, 0.005, 0.01, 0.1}) {
      const std::vector<Json> ends = both_ends_of(
          kBall,
          fmt::format("effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{{name: floor, "
                      "point: foot, along: [z]}}]\nphases:\n  - name: fly\n    until: "
                      "[{{touch_down: {{point: foot, height: 1}}, impact: {{constraints: "
                      "[floor]}}, then: stand}}]\n  - name: stand\n    active: "
                      "[floor]\ninitial: {{q: {{height: 1}}}}\nduration: 0.1\nstepping: "
                      "{{integrator: {}, step: {}}}\n",
                      method, step));
      // the chord begins where the event is, so the last cut is 2^-14 of the step behind; of
      // Euler's the fall is twice g t^2/2
      const double late = 0x1p-14 * step;
      EXPECT_NEAR(last_state(ends[0], 1)[0], 1, 10.1 * late * late + 1e-14)
          << method << ' ' << step;
    }
  }
}

// As its foot lifts off a hopper lets go of its wheel, which throws the foot back onto the plane at
// once. The foot was held, 2e-12 m above the plane by what rounding adds up to. Of rk4 at 0.25 ms:
// 440 steps * (0.25 ms * 30/s)^5 = 1e-8.
TEST(AsGenerated, LandsAgainWhereWhatHeldAPointHasDrifted) {
  const std::string model =
      "name: hopper\nlinks:\n"
      "  - {name: body, father: ground, joint: {type: fixed}, mass: 4, com: [0.02, -0.01, 0.03], "
      "inertia: [0.08, 0.002, 0.001, 0.1, 0.003, 0.06]}\n"
      "  - {name: thigh, father: body, joint: {name: hip, type: revolute, axis: [0, 1, 0], offset: "
      "[0, 0.1, -0.1], rotation: {rpy: [0.2, 0, 0]}}, mass: 0.8, com: [0, 0.01, -0.12], inertia: "
      "[0.006, 0, 0.0001, 0.006, 0.0002, 0.001]}\n"
      "  - {name: shank, father: thigh, joint: {name: knee, type: revolute, axis: [0, 1, 0], "
      "offset: [0, 0, -0.25]}, mass: 0.4, com: [0, 0, -0.1], inertia: [0.002, 0, 0, 0.002, 0, "
      "0.0002]}\n"
      "  - {name: wheel, father: body, joint: {name: spin, type: revolute, axis: [0.2, 0, 1], "
      "offset: [0, -0.1, 0.1]}, mass: 0.5, inertia: [0.002, 0, 0, 0.002, 0, 0.004]}\n"
      "points: [{name: foot, link: shank, at: [0, 0, -0.25]}]\n";
  const std::vector<Json> ends = both_ends_of(
      model,
      "base: axes\neffects:\n  gravity: [0.3, 0, -9.81]\n  joint_spring: [{joint: hip, stiffness: "
      "80, damping: 1, rest: -0.6}, {joint: knee, stiffness: 120, damping: 1.5, rest: 1.1}]\n  "
      "viscous_friction: [{joint: spin, coefficient: 0.01}]\n  point_constraint: [{name: ground, "
      "point: foot}]\n  locked_joint: [{name: brake, joint: spin}]\nphases:\n  - name: flight\n    "
      "until: [{touch_down: {point: foot, height: 0.02, normal: [0.05, 0, 1]}, impact: "
      "{constraints: [ground, brake], restitution: 0}, then: stance}]\n  - name: stance\n    "
      "active: [ground, brake]\n    until: [{lift_off: {constraint: ground, normal: [0.05, 0, 1]}, "
      "not_before: 0.05, then: flight}]\ninitial:\n  q: {base_pz: 0.75, base_rz: 0.2, base_ry: "
      "0.05, base_rx: -0.03, hip: -0.6, knee: 1.1}\n  qd: {base_px: 0.4, base_rx: 0.1, spin: "
      "3}\nduration: 0.32\nstepping: {integrator: rk4, step: 0.00025}\n");
  EXPECT_EQ(ends[1].at("events").size(), 3U);  // lands, lifts off, lands
  const std::vector<double> ours = last_state(ends[0], 18);
  const std::vector<double> theirs = last_state(ends[1], 18);
  for (std::size_t k = 0; k < 18; ++k) {
    EXPECT_NEAR(ours[k], theirs[k], 1e-8) << k;
  }
}

const std::string kTwoBalls =
    "name: balls\nlinks:\n  - name: left\n    father: ground\n    joint: {name: a, type: "
    "prismatic, "
    "axis: [0, 0, 1]}\n    mass: 1\n  - name: right\n    father: ground\n    joint: {name: b, "
    "type: "
    "prismatic, axis: [0, 0, 1]}\n    mass: 2\npoints: [{name: ta, link: left, at: [0, 0, 0]}, "
    "{name: tb, link: right, at: [0, 0, 0]}]\n";

// Two feet at one instant: the first touch-down ends the phase, the other follows in the next one.
TEST(AsGenerated, LandsOnTwoPointsAtOnce) {
  const std::string text =
      "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: fa, point: ta, along: [z]}, "
      "{name: fb, point: tb, along: [z]}]\nphases:\n  - name: fly\n    active: []\n    until:\n    "
      "  "
      "- {touch_down: {point: ta}, impact: {constraints: [fa]}, then: left}\n      - {touch_down: "
      "{point: tb}, impact: {constraints: [fb]}, then: right}\n  - {name: left, active: [fa], "
      "until: "
      "[{touch_down: {point: tb}, impact: {constraints: [fa, fb]}, then: both}]}\n  - {name: "
      "right, "
      "active: [fb], until: [{touch_down: {point: ta}, impact: {constraints: [fa, fb]}, then: "
      "both}]}\n  - {name: both, active: [fa, fb]}\ninitial: {q: {a: 1, b: 1}}\nduration: "
      "1\nstepping: {integrator: rk4, step: 0.01}\n";
  for (const Json& end : both_ends_of(kTwoBalls, text)) {
    for (const double height : last_state(end, 2)) {
      EXPECT_NEAR(height, 0, 1e-9);
    }
  }
}

// On the plane and on its way down, when the motion begins: a parabola of (1 - 0.5)/2 s, and rest.
TEST(AsGenerated, TouchesDownOnThePlane) {
  for (const Json& end : both_ends_of(
           kBall,
           "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: floor, point: foot, "
           "along: "
           "[z]}]\nphases:\n  - name: fall\n    active: []\n    until: [{touch_down: {point: "
           "foot}, "
           "impact: {constraints: [floor], restitution: 0.5, rest_below: 0.01}, then: "
           "fall}]\ninitial: {q: {height: 0}, qd: {height: -1}}\nduration: 0.05\nstepping: "
           "{integrator: rk4, step: 0.01}\n")) {
    EXPECT_NEAR(last_state(end, 1)[0], 0.5 * 0.05 - 5 * 0.05 * 0.05, 1e-9);
  }
}

// What the impact of a touch-down does not stop goes on, and is struck once.
TEST(AsGenerated, PassesAPlaneWhoseImpactIsBesideIt) {
  const std::string model =
      "name: foot\nlinks:\n  - name: cart\n    father: ground\n    joint: {name: x, type: "
      "prismatic, "
      "axis: [1, 0, 0]}\n    mass: 1\n  - name: ball\n    father: cart\n    joint: {name: height, "
      "type: prismatic, axis: [0, 0, 1]}\n    mass: 1\npoints: [{name: foot, link: ball, at: [0, "
      "0, "
      "0]}]\n";
  for (const Json& end : both_ends_of(
           model,
           "effects:\n  gravity: [0, 0, -10]\n  point_constraint: [{name: rub, point: foot, along: "
           "[x]}]\nphases:\n  - name: fly\n    active: []\n    until: [{touch_down: {point: foot}, "
           "impact: {constraints: [rub]}, then: fly}]\ninitial: {q: {height: 0.05}, qd: {x: "
           "1}}\nduration: 0.2\nstepping: {integrator: rk4, step: 0.01}\n")) {
    EXPECT_NEAR(last_state(end, 2)[1], 0.05 - 5 * 0.2 * 0.2, 1e-9);
    EXPECT_EQ(end.at("events").size(), 1U);
  }
}

// What friction cannot hold moves in the first step: 1e3/s, a step of at most 2.83 ms. The spring
// draws with 5e5 N.
TEST(AsGenerated, WarnsOfStepsThatAreTooLongForWhatBreaksAway) {
  for (const auto& [force, warns] : {std::pair(1.0, true), std::pair(3e5, true),
                                     std::pair(4.9e5, true), std::pair(6e5, false)}) {
    const TemporaryFolder folder;
    write_file((folder.path() / "model.yaml").string(), kBall);
    const std::string file = (folder.path() / "s.yaml").string();
    write_file(file,
               fmt::format("scene: s\nmodel: model.yaml\nduration: 0.05\neffects:\n  "
                           "coulomb_friction: [{{joint: height, force: {}}}]\n  joint_spring: "
                           "[{{joint: height, stiffness: 1e6}}]\ninitial: {{q: {{height: "
                           "0.5}}}}\nstepping: {{integrator: rk4, step: 0.01}}\n",
                           force));
    const std::string err = simulated(file, {"--as-generated"}).err;
    EXPECT_EQ(err.find("beyond the stability limit of rk4, 0.00283") != std::string::npos, warns)
        << force << err;
  }
}

TEST(AsGenerated, SaysWhereAMotionOfWholeStepsEnds) {
  const TemporaryFolder folder;
  write_file((folder.path() / "model.yaml").string(), kBall);
  const std::string file = (folder.path() / "s.yaml").string();
  write_file(file,
             "scene: s\nmodel: model.yaml\nduration: 1\nstepping: {integrator: rk4, step: 0.3}\n");
  EXPECT_NE(simulated(file, {"--as-generated"}).err.find("the motion ends at t = 0.9 s"),
            std::string::npos);
  EXPECT_EQ(simulated(file, {"--as-generated", "--step", "0.25"}).err, "");
}

// A ball comes to rest, and an event of the phase asks anew whether its floor holds it.
TEST(AsGenerated, RestsOnThePlaneBehindOtherEvents) {
  for (const char* const impact :
       {"restitution: 0.4", "restitution: 0.4, rest_below: 0.05", "rest_below: 0.05"}) {
    for (const Json& end : both_ends_of(
             kBall,
             fmt::format("effects:\n  gravity: [0, 0, -9.81]\n  point_constraint: [{{name: floor, "
                         "point: foot, along: [z]}}]\nphases:\n  - name: A\n    active: []\n    "
                         "until:\n      - {{touch_down: {{point: foot}}, impact: {{constraints: "
                         "[floor], {}}}, then: A}}\n      - {{time: 0.3, then: A}}\ninitial: {{q: "
                         "{{height: 0.0981}}}}\nduration: 1.2\nstepping: {{integrator: rk4, step: "
                         "0.001}}\n",
                         impact))) {
      EXPECT_NEAR(last_state(end, 1)[0], 0, 1e-10) << impact;
      EXPECT_NEAR(last_state(end, 3)[2], 9.81, 1e-8) << impact;  // the floor's reaction
    }
  }
}

// Where the joint stops it could only be held by more than its friction, and the floor would pull:
// it goes on the other way and the floor pushes. rk4 at 1 ms is off by less than 1e-9 here.
TEST(AsGenerated, BreaksFreeBeforeItLiftsOff) {
  const std::vector<Json> ends = both_ends_of(
      "name: m\nlinks:\n  - {name: l0, father: ground, joint: {name: j0, type: revolute, offset: "
      "[0, "
      "0, 0.369], axis: [0, -1, 0]}, mass: 1, com: [0.233, 0.159, 0], inertia: [0.0637, -0.0161, "
      "-0.0233, 0.0562, -0.0039, 0.0534]}\n  - {name: l1, father: l0, joint: {name: j1, type: "
      "revolute, axis: [0, -1, 0]}, mass: 3.215, com: [0.248, 0, 0], inertia: [0.1796, 0.0682, "
      "-0.0291, 0.1541, 0.046, 0.2169]}\n",
      "effects:\n  gravity: [0, 0, -9.81]\n  joint_spring: [{joint: j1, stiffness: 9.44, rest: "
      "-0.86}]\n  point_constraint: [{name: floor, point: F, along: [[0.6, 0, 0.8]]}]\n  "
      "coulomb_friction: [{joint: j1, force: 2.74}]\npoints: [{name: F, link: l0, at: [0.225, "
      "-0.381, 0.318]}]\nphases:\n  - name: A\n    active: []\n    until: [{touch_down: {point: F, "
      "height: 0.555041045992181, normal: [0.6, 0, 0.8]}, impact: {constraints: [floor]}, then: "
      "B}]\n  - name: B\n    active: [floor]\n    until: [{lift_off: {constraint: floor, normal: "
      "[0.6, 0, 0.8]}, then: A}]\ninitial: {q: {j0: 0.196, j1: -0.045}, qd: {j0: -0.239, j1: "
      "-0.053}}\nduration: 0.8\nstepping: {integrator: rk4, step: 0.001}\n");
  EXPECT_EQ(ends[1].at("events").size(), 1U);  // the touch-down
  const std::vector<double> ours = last_state(ends[0], 4);
  const std::vector<double> theirs = last_state(ends[1], 4);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(ours[k], theirs[k], 1e-8) << k;
  }
}

TEST(AsGenerated, LeavesPhasesByImpactsThatTakeNothing) {
  for (const Json& end : both_ends(
           "effects:\n  gravity: [0, 0, -9.81]\n  point_constraint: [{name: c1, point: tip, along: "
           "[x]}]\nphases:\n  - name: A\n    active: [c1]\n    until: [{time: 0.1, then: C, "
           "impact: "
           "{constraints: [c1]}}]\n  - name: C\n    active: [c1]\n    until: [{time: 0.15, then: "
           "B}]\n  - name: B\n    active: []\n    until: []\ninitial: {q: {shoulder: 0.3, elbow: "
           "0.5}}\nduration: 0.5\nstepping: {integrator: rk4, step: 0.001}\n")) {
    EXPECT_EQ(end.at("rows").back().at(1), "B");
  }
}

TEST(AsGenerated, WalksLikeTheSimulator) {
  const std::string walk = kScenes + "compass_walk.yaml";
  const Outcome ours = simulated(
      walk, {"--as-generated", "--integrator", "rk4", "--step", "0.005", "--duration", "1.8"});
  const Outcome theirs = simulated(walk, {"--duration", "1.8"});
  ASSERT_EQ(ours.status, 0) << ours.err;
  EXPECT_EQ(ours.err, "");
  const Json a = Json::parse(ours.out);
  const Json b = Json::parse(theirs.out);
  EXPECT_EQ(a.at("columns"), b.at("columns"));
  EXPECT_EQ(a.at("events").size(), 2U);
  EXPECT_EQ(a.at("rows").front().at(1), "left");
  EXPECT_EQ(a.at("rows").back().at(1), b.at("rows").back().at(1));
  EXPECT_EQ(a.at("statuses"), Json::array());
  const std::size_t count = 12;  // 4 q, 4 qd, 4 reactions
  const std::vector<double> x = last_state(a, count);
  const std::vector<double> y = last_state(b, count);
  for (std::size_t k = 0; k < 8; ++k) {  // q and qd; rk4 at 5 ms is off by 2e-8
    EXPECT_NEAR(x[k], y[k], 1e-6) << a.at("columns").at(k);
  }
  for (std::size_t k = 8; k < 12; ++k) {  // reactions: 20 kg and accelerations of the errors
    EXPECT_NEAR(x[k], y[k], 1e-3) << a.at("columns").at(k);
  }
}

/// Every step has a row here: its operations are those that the manifest tells of its phase.
/// Two steps with a touch-down among 180: three shorter ones look for it, one is what is left.
TEST(AsGenerated, CountsItsOwnSteps) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const std::string walk = kScenes + "compass_walk.yaml";
  const Outcome outcome =
      simulated(walk, {"--as-generated", "--scalar", "float", "--integrator", "rk4", "--step",
                       "0.01", "--duration", "1.8", "-v", "--report", "-o", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("180 steps, "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("752 evaluations of the dynamics, "), std::string::npos);
  const Outcome made =
      run({TREEDYN_EXECUTABLE, "generate", "--scene", walk, "--functions", "step", "--integrator",
           "rk4", "--step", "0.01", "--scalar", "float", "-o", out + "/made"});
  ASSERT_EQ(made.status, 0) << made.err;
  const Json manifest = Json::parse(read_file(out + "/made/compass_walk.json"));
  std::map<std::string, long> operations;
  for (const Json& phase : manifest.at("functions").back().at("phases")) {
    const Json& cost = phase.at("operations");
    operations[phase.at("name")] =
        cost.at("add").get<long>() + cost.at("mul").get<long>() + cost.at("div").get<long>();
  }
  const Json result = Json::parse(read_file(out + "/compass_walk.json"));
  ASSERT_EQ(result.at("rows").size(), 181U);
  long expected = 0;
  for (std::size_t k = 0; k < 180; ++k) {
    expected += operations.at(result.at("rows").at(k).at(1));
  }
  EXPECT_EQ(result.at("steps"), 180);
  EXPECT_EQ(result.at("as_generated"), "float");
  EXPECT_EQ(result.at("events").size(), 2U);
  EXPECT_EQ(result.at("cost").at("evaluations"), 4 * (180 + 2 * 4));
  const long counted = result.at("cost").at("operations");
  EXPECT_GT(counted, expected + expected * 8 / 180 / 2);
  EXPECT_LT(counted, expected + expected * 8 / 180);
  EXPECT_EQ(result.at("events").at(0).at("event"), "touch_down of right_foot");
  const std::string page = read_file(out + "/compass_walk.html");
  EXPECT_NE(page.find("generated step in float, --as-generated"), std::string::npos);
  EXPECT_NE(page.find("180 (0 rejected), 752 evaluations"), std::string::npos);
  EXPECT_EQ(page.find("\"projection\""), std::string::npos);
  EXPECT_NE(page.find("touch_down of right_foot"), std::string::npos);
}

TEST(AsGenerated, ShowsWhatFloatDoes) {
  const std::string walk = kScenes + "compass_walk.yaml";
  const std::vector<std::string> options = {"--as-generated", "--integrator", "rk4", "--step",
                                            "0.005",          "--duration",   "0.5"};
  std::vector<std::string> in_float = options;
  in_float.insert(in_float.end(), {"--scalar", "float"});
  const Json a = Json::parse(simulated(walk, options).out);
  const Json b = Json::parse(simulated(walk, in_float).out);
  double largest = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    const double x = last_state(b, 8)[k];
    EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
    largest = std::max(largest, std::abs(x - last_state(a, 8)[k]));
  }
  EXPECT_GT(largest, 1e-9);  // float it is
  EXPECT_LT(largest, 1e-4);
}

/// Through an impact and a change of phase; in double, where rounding is 1e-13.
TEST(AsGenerated, CompensatesThroughEvents) {
  const TemporaryFolder folder;
  std::string walk = read_file(kScenes + "compass_walk.yaml");
  const std::string model = "model: ";
  walk.replace(walk.find(model), model.size(), model + kScenes);
  std::vector<std::vector<double>> states;
  for (const std::string state : {"compensated", "plain"}) {
    std::string text = walk;
    text.insert(text.find("output_step"), "state: " + state + ", ");
    write_file(folder.path() / "walk.yaml", text);
    const Outcome outcome = simulated(
        (folder.path() / "walk.yaml").string(),
        {"--as-generated", "--integrator", "rk4", "--step", "0.001", "--duration", "1.2"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("events").size(), 1U);
    states.push_back(last_state(result, 8));
  }
  EXPECT_NE(states[0], states[1]);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(states[0][k], states[1][k], 1e-10);
  }
}

TEST(AsGenerated, WarnsOfStatuses) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "ball.yaml").string();
  write_file(folder.path() / "model.yaml",
             "name: ball\nlinks:\n  - name: ball\n    father: ground\n    joint: {name: height, "
             "type: prismatic, axis: [0, 0, 1]}\n    mass: 1\n");
  write_file(
      file,
      "scene: ball\nmodel: model.yaml\neffects:\n  gravity: [0, 0, -10]\nphases:\n"
      "  - name: fall\n    active: []\n    until: [{expression: \"sqrt(q[height])\", then: gone}]\n"
      "  - {name: gone, active: []}\ninitial: {q: {height: 0.2}}\nduration: 1\n"
      "stepping: {integrator: rk4, step: 0.01}\n");
  const Outcome outcome = simulated(file, {"--as-generated"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("the step at t = 0.19 s and in 80 later steps returned "
                             "guard_undefined"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out).at("statuses").at(0).at("name"), "guard_undefined");
}

/// 778 J out of 9.81 J, by steps that never see the ground softly.
TEST(AsGenerated, EndsWhereEnergyGrowsOutOfNothing) {
  for (const std::string scalar : {"double", "float"}) {
    const Outcome outcome =
        simulated(kScenes + "drop.yaml", {"--as-generated", "--integrator", "semi-implicit-euler",
                                          "--step", "0.002", "--scalar", scalar});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("energy grows without power"), std::string::npos) << outcome.err;
  }
}

/// A pendulum under gravity alone: what its energy gains is what no force explains, however much
/// the speed changes within a step; and that is no reason to end.
TEST(AsGenerated, KeepsBooksOfCoarseSteps) {
  const Outcome outcome =
      simulated(kScenes + "pendulum.yaml", {"--as-generated", "--integrator", "semi-implicit-euler",
                                            "--step", "0.2", "--duration", "60"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json result = Json::parse(outcome.out);
  const auto energy = static_cast<std::size_t>(std::ranges::find(result.at("columns"), "energy") -
                                               result.at("columns").begin());
  const double gained = result.at("rows").back().at(energy).get<double>() -
                        result.at("rows").front().at(energy).get<double>();
  EXPECT_NEAR(result.at("kept").at("unexplained_energy").get<double>(), gained, 1e-9);
  EXPECT_EQ(result.at("rows").size(), 301U);
}

/// Touch-downs that a phase begins again with are events, too.
TEST(AsGenerated, TellsImpactsThatChangeNoPhase) {
  const TemporaryFolder folder;
  write_file(folder.path() / "ball.yaml",
             "name: ball\nlinks:\n  - {name: ball, father: ground, joint: {name: height, type: "
             "prismatic, axis: [0, 0, 1]}, mass: 1}\npoints:\n  - {name: sole, link: ball, at: [0, "
             "0, 0]}\n");
  write_file(folder.path() / "s.yaml", R"(scene: s
model: ball.yaml
effects: {gravity: [0, 0, -10], point_constraint: [{name: floor, point: sole, along: [[0, 0, 1]]}]}
phases:
  - name: air
    active: []
    until: [{touch_down: {point: sole, normal: [0, 0, 1], height: 0}, impact: {constraints: [floor], restitution: 0.8}, then: air}]
initial: {q: {height: 0.8}}
stepping: {integrator: rk4, step: 0.01}
duration: 2
)");
  // down at 0.4 s; then up for twice 0.32 s, 0.256 s and 0.2048 s
  const Outcome outcome = simulated((folder.path() / "s.yaml").string(), {"--as-generated"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json events = Json::parse(outcome.out).at("events");
  ASSERT_EQ(events.size(), 4U);
  for (const auto& [k, time] :
       std::map<std::size_t, double>{{0, 0.4}, {1, 1.04}, {2, 1.552}, {3, 1.9616}}) {
    EXPECT_NEAR(events.at(k).at("t").get<double>(), time, 0.0101);
    EXPECT_EQ(events.at(k).at("event"), "touch_down of sole");
  }
}

/// Work of a drive, losses of a contact and of impacts: no alarm.
TEST(AsGenerated, ExplainsEnergyByWork) {
  for (const std::string scene : {"drop", "arm_circle", "four_bar"}) {
    const Outcome outcome = simulated(
        kScenes + scene + ".yaml",
        {"--as-generated", "--integrator", "rk4", "--step", "0.0002", "--duration", "0.6"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("energy"), std::string::npos) << outcome.err;
  }
}

const std::string kTwoFrictions =
    "scene: two_frictions\nmodel: " + std::string(TREEDYN_SOURCE_DIR) +
    "/models/two_link.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
    "  coulomb_friction: [{joint: shoulder, force: 150}, {joint: elbow, force: 60}]\n"
    "  drive: [{joint: shoulder, torque: \"300*sin(3*t)\"}]\nphases:\n"
    "  - {name: one, until: [{time: 1.234, then: two}]}\n"
    "  - {name: two, until: [{time: 0.5, then: one}]}\n"
    "initial: {q: {shoulder: 0.5, elbow: 0.3}}\nduration: 4\n"
    "stepping: {integrator: rk4, step: 0.002, output_step: 0.5}\n";

/// Both stop and slip again; the clock of the scene's phases goes on meanwhile.
TEST(AsGenerated, SticksAndSlipsLikeTheSimulator) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "frictions.yaml").string();
  write_file(file, kTwoFrictions);
  const Json expected = Json::parse(simulated(file, {}).out);
  const std::vector<double> y = last_state(expected, 4);
  for (const auto& [scalar, tolerance] : {std::pair("double", 1e-9), std::pair("float", 1e-3)}) {
    const Outcome outcome = simulated(file, {"--as-generated", "--scalar", scalar});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json result = Json::parse(outcome.out);
    EXPECT_GT(result.at("events").size(), 8U);
    const std::vector<double> x = last_state(result, 4);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(x[k], y[k], tolerance) << scalar << " " << k;
    }
  }
}

/// Milligrams before a kilogram, and a row: by 1e-6 of what A is made of, float is off by tenths.
TEST(Float, ThatKeepsNoDigitsIsWarnedOf) {
  const TemporaryFolder folder;
  const auto warned = [&](const std::string& mass) {
    std::string model = "name: chain\nlinks:\n";
    std::string father = "ground";
    for (int k = 0; k < 5; ++k) {
      const std::string m = k == 4 ? "1" : mass;
      const std::string name = "l" + std::to_string(k);
      model += "  - name: " + name + "\n    father: " + father + "\n    joint: {name: j" +
               std::to_string(k) + ", type: revolute, axis: [0, 1, 0]" +
               (k == 0 ? "" : ", offset: [0.3, 0.02, 0.1]") + "}\n    mass: " + m +
               "\n    com: [0.15, 0, 0.02]\n    inertia: [0.01*" + m + ", 0, 0, 0.01*" + m +
               ", 0, 0.01*" + m + "]\n";
      father = name;
    }
    write_file(folder.path() / "model.yaml", model);
    const std::string file = (folder.path() / "chain.yaml").string();
    write_file(file,
               "scene: chain\nmodel: model.yaml\neffects: {gravity: [0, 0, -9.81], locked_joint: "
               "[{joint: j1}]}\nduration: 0.001\nstepping: {integrator: rk4, step: 0.001}\n");
    const Outcome outcome = simulated(file, {"--as-generated", "--scalar", "float"});
    return outcome.err.find("in float at some ordinary state") != std::string::npos;
  };
  EXPECT_TRUE(warned("1e-6"));
  EXPECT_FALSE(warned("0.1"));
}

/// A body of mass m on a rail of a slide of 10 kg, held where it is: J A^-1 J^T is 1/m but for the
/// tenth of the slide.
Outcome light_body(const TemporaryFolder& folder, const std::string& mass,
                   const std::string& scalar) {
  write_file(folder.path() / "light.model.yaml",
             "name: light\nlinks:\n"
             "  - name: slide\n    father: ground\n    joint: {name: x, type: prismatic, axis: [1, "
             "0, 0]}\n    mass: 10\n"
             "  - name: tip\n    father: slide\n    joint: {name: d, type: prismatic, axis: [1, 0, "
             "1]}\n    mass: " +
                 mass + "\n");
  const std::string file = (folder.path() / "light.yaml").string();
  write_file(
      file,
      "scene: light\nmodel: light.model.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
      "  drive: [{joint: x, torque: 1}]\n  point_constraint: [{name: pin, point: tip, along: "
      "[x, z]}]\nduration: 0.001\nstepping: {integrator: rk4, step: 0.001}\n");
  return simulated(file, {"--as-generated", "--scalar", scalar});
}

TEST(Float, ThatLosesForcesOfConstraintsIsWarnedOf) {
  const TemporaryFolder folder;
  const auto warned = [&](const std::string& mass, const std::string& scalar) {
    return light_body(folder, mass, scalar)
               .err.find("forces (or impulses) of constraints are off by") != std::string::npos;
  };
  EXPECT_TRUE(warned("1e-5", "float"));  // by 6.7 %
  EXPECT_FALSE(warned("1e-2", "float"));
  EXPECT_FALSE(warned("1e-5", "double"));
}

/// What proves generated code has to know how large the accelerations are that rows hold.
TEST(AsGenerated, HoldsABodyOfAPicogram) {
  const TemporaryFolder folder;
  const Outcome outcome = light_body(folder, "1e-15", "double");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

/// Two points of a light link, 0.1 mm apart, hold it by six rows of rank five: small pivots, not
/// smaller ones of a square.
TEST(AsGenerated, HoldsALightLinkByPointsThatLieCloseTogether) {
  const TemporaryFolder folder;
  std::string model = "name: arm\nlinks:\n";
  std::string father = "ground";
  const std::vector<std::string> axes = {
      "prismatic, axis: [-0.4, 0.4, 0.03]", "revolute, axis: [0, 0, 1]",
      "prismatic, axis: [0.6, -0.7, -0.4]", "revolute, axis: [1, 0, 0]",
      "prismatic, axis: [-0.4, -0.8, -0.4]"};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const std::string name = "l" + std::to_string(k);
    const std::string mass = k + 1 < axes.size() ? "2" : "1e-3";
    model += "  - name: " + name + "\n    father: " + father + "\n    joint: {name: j" +
             std::to_string(k) + ", type: " + axes[k] +
             ", offset: [0.1, 0.2, -0.3], rotation: {rpy: [1, -0.3, 1.6]}}\n    mass: " + mass +
             "\n    com: [0.1, -0.2, 0.1]\n    inertia: [0.01*" + mass + ", 0, 0, 0.01*" + mass +
             ", 0, 0.01*" + mass + "]\n";
    father = name;
  }
  model +=
      "points:\n  - {name: a, link: l4, at: [0.2793, -0.1911, 0.1699]}\n"
      "  - {name: b, link: l4, at: [0.2794, -0.1911, 0.1699]}\n";
  write_file(folder.path() / "arm.model.yaml", model);
  const std::string file = (folder.path() / "arm.yaml").string();
  write_file(file,
             "scene: arm\nmodel: arm.model.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
             "  point_constraint: [{point: a}, {point: b}]\ninitial: {q: {j0: 0.6, j1: 0.6, j2: "
             "0.3, j3: -1.4, j4: -0.5}}\nduration: 0.001\n"
             "stepping: {integrator: rk4, step: 0.001}\n");
  const Outcome outcome = simulated(file, {"--as-generated"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(AsGenerated, NeedsAStepOfFixedLength) {
  const Outcome outcome = simulated(kScenes + "compass_walk.yaml", {"--as-generated"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("integrator 'fehlberg78' is not for generated code"),
            std::string::npos)
      << outcome.err;
  const Outcome asked =
      simulated(kScenes + "compass_walk.yaml", {"--as-generated", "--integrator", "fehlberg78"});
  EXPECT_EQ(asked.status, 2);
  EXPECT_NE(asked.err.find("--integrator: fehlberg78 is not for generated code; expected semi"),
            std::string::npos)
      << asked.err;
  EXPECT_EQ(simulated(kScenes + "compass_walk.yaml", {"--scalar", "float"}).status, 2);
}

}  // namespace
}  // namespace treedyn::support
