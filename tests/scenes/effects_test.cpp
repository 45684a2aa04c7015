// Only the effects a scene calls for (README.md beside this file): generated functions of scenes
// that differ in one effect, by text, symbols, values and counted operations.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes/arm_scene.hpp"
#include "support/process.hpp"

namespace treedyn::support {
namespace {

/// The names that the object of a scene's code defines and calls.
std::string symbols(const ArmScene& scene) {
  const std::string object = (scene.folder() / "generated.o").string();
  const Outcome compiled = run({TREEDYN_CXX, "-std=c++11", "-O2", "-c", "-o", object,
                                (scene.folder() / "generated.cpp").string()});
  EXPECT_EQ(compiled.status, 0) << compiled.err;
  return run({"nm", "-C", object}).out;
}

TEST(Effects, WhatASceneDoesNotNameIsNotInItsCode) {  // E1
  const ArmScene plain("");
  const std::string names = symbols(plain);
  for (const char* absent : {"solve", "press", "contact", "reaction", "impact", "sqrt", "pow"}) {
    EXPECT_FALSE(has(names, absent)) << absent;
    EXPECT_FALSE(has(plain.source(), absent)) << absent;
  }
  for (const char* absent : {"solve_deficient", "lambda", "depth"}) {
    EXPECT_FALSE(has(plain.source(), absent)) << absent;
  }
  const std::string source = plain.source();
  for (const char* in_check : {"for (", "if ("}) {  // once, where results are looked at
    EXPECT_EQ(source.find(in_check), source.rfind(in_check)) << in_check;
  }
}

TEST(Effects,
     WhatASceneNamesIsInItsCode) {  // E1, the other half: the words above are the right ones
  const ArmScene held(kHeld);
  EXPECT_TRUE(has(symbols(held), "solve"));
  EXPECT_TRUE(has(held.source(), "solve_deficient"));
  EXPECT_FALSE(has(held.source(), "depth"));
  const ArmScene pressed(kGround);
  EXPECT_TRUE(has(pressed.source(), "press"));
  EXPECT_TRUE(has(pressed.source(), "sqrt"));
  EXPECT_FALSE(has(pressed.source(), "solve"));
}

/// A drive's torque is worth as much as the same number in tau; roots begin with a number or are
/// not real everywhere.
TEST(Effects, RootsAreTakenOfDifferences) {
  const ArmScene plain("");
  const std::pair<const char*, double> torques[] = {
      {"sqrt(2 - cos(q[elbow]))", std::sqrt(2 - std::cos(kq[1]))},
      {"sqrt(-q[elbow])", std::sqrt(-kq[1])},
      {"3*sqrt(1 - q[shoulder]^2 - sin(q[elbow])^2)",
       3 * std::sqrt(1 - kq[0] * kq[0] - std::pow(std::sin(kq[1]), 2))},
      {"sqrt(t + 1) * (sqrt(4 - sin(q[elbow])^2) - 0.2)",
       std::sqrt(4 - std::pow(std::sin(kq[1]), 2)) - 0.2}};
  for (const auto& [text, value] : torques) {
    const ArmScene driven(fmt::format("  drive:\n    - {{joint: elbow, torque: \"{}\"}}\n", text));
    std::vector<Vector> inputs = {kq, kqd, ktau};
    if (has(text, "t + 1")) {
      inputs.push_back({0});
    }
    const Vector qdd = driven.code().call("constrained_dynamics", inputs);
    const Vector expected =
        plain.code().call("constrained_dynamics", {kq, kqd, {ktau[0], ktau[1] + value}});
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(qdd[k], expected[k], 1e-12 * (1 + std::abs(expected[k]))) << text;
    }
  }
}

/// sqrt(x^2) is |x|, not x: what tells values apart must not take it for x in states in which x is
/// positive, or negative, by chance.
TEST(Effects, RootsOfSquaresAreMagnitudes) {
  const ArmScene plain("");
  using State = CompiledModel::Inputs;
  const std::vector<std::pair<std::string, double (*)(double, double, double, double)>> roots = {
      {"sqrt((q[shoulder]*qd[elbow])^2)",
       [](double a, double, double, double v) {
         return std::abs(a * v);
       }},
      {"sqrt(q[shoulder]^2)",
       [](double a, double, double, double) {
         return std::abs(a);
       }},
      {"qd[shoulder]*sqrt(qd[shoulder]^2)",
       [](double, double, double u, double) {
         return u * std::abs(u);
       }},
      {"qd[elbow]*sqrt((q[elbow]^2 - 1)*3/((q[elbow] - 1)*(q[elbow] + 1)))",  // one number
       [](double, double, double, double v) {
         return v * std::sqrt(3.0);
       }},
      {"sqrt((q[elbow] - qd[shoulder])^2)",
       [](double, double b, double u, double) {
         return std::abs(b - u);
       }},
      {"((q[elbow] - q[shoulder]) + sqrt((q[elbow] - q[shoulder])^2))/2",
       [](double a, double b, double, double) {
         return std::max(b - a, 0.0);
       }}};
  for (const auto& [text, value] : roots) {
    const ArmScene driven("  drive: [{joint: shoulder, torque: \"" + text + "\"}]\n");
    for (int signs = 0; signs < 16; ++signs) {
      const auto signed_by = [&](int bit, double x) {
        return (signs >> bit & 1) != 0 ? -x : x;
      };
      const double a = signed_by(0, 0.4);
      const double b = signed_by(1, 0.7);
      const double u = signed_by(2, 1.1);
      const double v = signed_by(3, 0.6);
      const State with = {{a, b}, {u, v}, {0, 0}};
      const State without = {{a, b}, {u, v}, {value(a, b, u, v), 0}};
      const Measurement one = driven.code().measure("constrained_dynamics", with);
      const Measurement other = plain.code().measure("constrained_dynamics", without);
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(one.values[k], other.values[k], 1e-11) << text << ' ' << signs;
      }
    }
  }
}

/// Reactions of a locked joint that is driven help no other joint: tau is that of free motion.
TEST(Effects, RowsThatReachNoPassiveJointLeaveTheirDrivesAlone) {
  const SceneCode locked(fmt::format(
      "scene: s\nmodel: {}/models/two_link.yaml\nactuated: [shoulder]\neffects:\n  gravity: [0, 0, "
      "-9.81]\n  locked_joint: [{{joint: shoulder, name: brake}}]\nduration: 1\n",
      TREEDYN_SOURCE_DIR));
  const ArmScene plain("");
  const Vector result = locked.code().call("constrained_inverse_dynamics", {kq, kqd, {0.3, -0.7}});
  const Vector qdd = plain.code().call("constrained_dynamics", {kq, kqd, {result[0], result[1]}});
  EXPECT_NEAR(qdd[0], 0.3, 1e-12);
  EXPECT_NEAR(qdd[1], -0.7, 1e-12);
  EXPECT_EQ(result[2], 0);
}

std::string urdf_joint(const std::string& name, const std::string& parent, const char* more) {
  return fmt::format(
      R"(<link name="{0}_link"><inertial><origin xyz="0.1 0 0"/><mass value="1"/>)"
      R"(<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>)"
      R"(<joint name="{0}" type="continuous"><parent link="{1}"/><child link="{0}_link"/>)"
      R"(<axis xyz="0 0 1"/>{2}</joint>)",
      name, parent, more);
}

/// The index of a coordinate is not that of a link there.
TEST(Effects, AnArmatureBehindAMimicJointIsOnItsJoint) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "three.urdf").string();
  write_file(model, R"(<robot name="three"><link name="world"/>)" +
                        urdf_joint("leader", "world", "") +
                        urdf_joint("follower", "leader_link", R"(<mimic joint="leader"/>)") +
                        urdf_joint("alone", "world", "") + "</robot>");
  const SceneCode armed(fmt::format(
      "scene: s\nmodel: {}\nduration: 1\neffects:\n  armature: [{{joint: alone, inertia: 0.3}}]\n",
      model));
  const SceneCode plain(fmt::format("scene: s\nmodel: {}\nduration: 1\n", model));
  const std::vector<Vector> state = {{0.2, 0.5}, {0, 0}, {0.7, 1}};
  const Vector qdd = armed.code().call("constrained_dynamics", state);
  EXPECT_NEAR(qdd[1], 1 / (0.01 + 0.01 + 0.3), 1e-13);
  EXPECT_NEAR(qdd[0], plain.code().call("constrained_dynamics", state)[0], 1e-12);
}

/// A link that turns about y alone cannot follow errors about x and z.
TEST(Effects, RowsThatNoMotionReachesAreGenerated) {
  const std::string rows =
      "  orientation_constraint:\n    - {name: level, point: hand, along: [x, z]}\n"
      "  stabilisation: {method: baumgarte, rate: 10}\n";
  const ArmScene held(rows);
  const ArmScene plain("");
  const Vector qdd =
      held.code().call("constrained_dynamics", {kq, kqd, ktau, {1, 0, 0, 0, 1, 0, 0, 0, 1}});
  const Vector expected = plain.code().call("constrained_dynamics", {kq, kqd, ktau});
  EXPECT_NEAR(qdd[0], expected[0], 1e-12);
  EXPECT_NEAR(qdd[1], expected[1], 1e-12);
}

TEST(Effects, SpringsWithoutADirectionAreRefused) {
  const TemporaryFolder folder;
  const std::string scene = (folder.path() / "scene.yaml").string();
  write_file(scene,  // a point on the axis of the first joint
             fmt::format("scene: s\nmodel: {}/models/two_link.yaml\npoints:\n  - {{name: hook, "
                         "link: upper_arm, at: [0, 0, 0]}}\neffects:\n  point_spring:\n    - "
                         "{{point: hook, anchor: [0, 0, 0], stiffness: 3, rest_length: 1}}\n"
                         "duration: 1\n",
                         TREEDYN_SOURCE_DIR));
  const Outcome outcome = run({TREEDYN_EXECUTABLE, "generate", "--scene", scene, "--effort", "0",
                               "-o", (folder.path() / "out").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            scene +
                ": force at point 'hook': an expression or a law of the scene divides by what is "
                "zero in every position, like the length of a spring; expected another one\n");
}

TEST(Effects, SwitchedOffLeavesTheCodeOfTheSceneWithout) {  // E1, byte for byte
  const std::string with =
      std::string(kHeld) + "  joint_spring:\n    - {joint: elbow, stiffness: 30, damping: 2}\n";
  EXPECT_EQ(ArmScene(with, "use: {joint_spring: off}\n").source(), ArmScene(kHeld).source());
  EXPECT_EQ(
      ArmScene(with, "use: {point_constraint: off}\n").source(),
      ArmScene("  joint_spring:\n    - {joint: elbow, stiffness: 30, damping: 2}\n").source());
  EXPECT_EQ(ArmScene(kGround, "use: {ground_contact: off}\n").source(), ArmScene("").source());
}

TEST(Effects, OperationsOfTheManifestAreThoseExecuted) {  // E2
  const ArmScene held(std::string(kHeld) +
                          "  stribeck_friction:\n    - {joint: elbow, force: 1, static_force: 2, "
                          "stribeck_speed: 0.1, slip_speed: 0.01}\n",
                      "", Variant::kMeasured);
  const Measurement motion = held.code().measure("constrained_dynamics", {kq, kqd, ktau});
  EXPECT_EQ(motion.operations, held.operations("constrained_dynamics"));
  EXPECT_EQ(held.code().measure("reaction_jacobian_transpose", {kq}).operations,
            held.operations("reaction_jacobian_transpose"));
}

TEST(Effects, DeficientRowsCostWhatTheManifestSays) {  // E2: two rows say the same, rank 2 of 3
  const ArmScene twice(std::string(kHeld) + "    - {name: again, point: hand, along: [x]}\n", "",
                       Variant::kMeasured);
  EXPECT_EQ(twice.manifest("constrained_dynamics").at("rank"), 2);
  const Measurement motion = twice.code().measure("constrained_dynamics", {kq, kqd, ktau});
  EXPECT_EQ(motion.operations, twice.operations("constrained_dynamics"));
}

TEST(Effects,
     NoStateCostsMoreThanTheWorstCase) {  // E2: a stretched arm makes regular rows deficient
  const ArmScene held(kHeld, "", Variant::kMeasured);
  const Measurement motion = held.code().measure("constrained_dynamics", {{0.4, 0}, kqd, ktau});
  const Operations worst = operations_of(held.manifest("constrained_dynamics").at("worst_case"));
  for (std::size_t k = 0; k < worst.size(); ++k) {
    EXPECT_LE(motion.operations[k], worst[k]);
  }
  EXPECT_GT(total(motion.operations), total(held.operations("constrained_dynamics")));
  for (const double value : motion.values) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(Effects, PricesAreDifferencesOfCounts) {  // E2
  const std::string spring = "  joint_spring:\n    - {joint: elbow, stiffness: 30, damping: 2}\n";
  const ArmScene both(kHeld + spring);
  const ArmScene held(kHeld);
  bool found = false;
  const Json info = both.info();
  for (const Json& price : info.at("prices")) {
    if (price.at("effect") == "joint_spring" && price.at("function") == "constrained_dynamics") {
      found = true;
      EXPECT_EQ(operations_of(price.at("with")), both.operations("constrained_dynamics"));
      EXPECT_EQ(operations_of(price.at("without")), held.operations("constrained_dynamics"));
      EXPECT_GT(total(operations_of(price.at("with"))), total(operations_of(price.at("without"))));
    }
  }
  EXPECT_TRUE(found);
}

TEST(Effects, ZeroParametersAreFound) {  // E3
  EXPECT_EQ(ArmScene("  joint_spring:\n    - {joint: elbow, stiffness: 0, damping: 0}\n").source(),
            ArmScene("").source());
  for (const char* const nothing :
       {"coulomb_friction: [{joint: elbow, force: 0}]", "armature: [{joint: elbow, inertia: 0}]",
        "force: [{point: tip, value: [0, t-t, 0*vx]}]", "moment: [{point: tip, value: [0, 0, 0]}]",
        "point_spring: [{point: tip, anchor: [1, 2, 3], stiffness: 0, rest_length: 0.3}]"}) {
    const ArmScene scene(fmt::format("  {}\n", nothing));
    EXPECT_EQ(scene.source(), ArmScene("").source()) << nothing;
    EXPECT_EQ(scene.header(), ArmScene("").header()) << nothing;
    EXPECT_EQ(scene.manifest("constrained_dynamics"),
              ArmScene("").manifest("constrained_dynamics"));
  }
  const ArmScene undamped("  joint_spring:\n    - {joint: elbow, stiffness: 30}\n");
  const ArmScene damped("  joint_spring:\n    - {joint: elbow, stiffness: 30, damping: 2}\n");
  EXPECT_EQ(total(damped.operations("constrained_dynamics")) -
                total(undamped.operations("constrained_dynamics")),
            2);  // d qd, and its subtraction
}

TEST(Effects, AContactCostsItsDepthUntilItTouches) {  // E4: two levels
  const ArmScene ground(kGround, "", Variant::kMeasured);
  const Vector above = {1.2, -0.3};
  const Vector below = {-0.5, -0.3};
  const Operations open =
      ground.code().measure("constrained_dynamics", {above, kqd, ktau}).operations;
  const Operations closed =
      ground.code().measure("constrained_dynamics", {below, kqd, ktau}).operations;
  EXPECT_EQ(open, ground.operations("constrained_dynamics"));
  const Operations press = operations_of(ground.manifest("constrained_dynamics").at("press"));
  for (std::size_t k = 0; k < open.size(); ++k) {
    EXPECT_EQ(closed[k] - open[k], press[k]);
  }
  // the depth of the hand: two sines of angles that the arm needs or not, two products, one sum
  EXPECT_LE(total(open) - total(ArmScene("").operations("constrained_dynamics")), 8);
  EXPECT_GT(total(press), 15);
}

/// max |a - b| in units of the last place of the larger.
double ulps(const Vector& a, const Vector& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double unit = std::max(std::abs(a[k]), std::abs(b[k])) * 0x1p-52;
    largest = std::max(largest, unit > 0 ? std::abs(a[k] - b[k]) / unit : 0);
  }
  return largest;
}

TEST(Effects, ZeroStrengthChangesNoStep) {  // E5
  const ArmScene limp(
      "  force:\n    - {point: hand, value: [0, 0, 0]}\n"
      "  moment:\n    - {point: hand, value: [0, 0*t, 0]}\n");
  EXPECT_LE(ulps(stepped(limp, kq), stepped(ArmScene(""), kq)), 4);
}

TEST(Effects, AnEffectThatDoesNotActChangesNoStep) {  // E5
  const Vector above = {1.2, -0.3};
  EXPECT_LE(ulps(stepped(ArmScene(kGround), above), stepped(ArmScene(""), above)), 4);
}

TEST(Effects, APhaseSolvesForItsOwnRowsOnly) {  // E6
  const std::string two =
      "  point_constraint:\n    - {name: along, point: hand, along: [x]}\n"
      "    - {name: up, point: hand, along: [z]}\n";
  const ArmScene phases(
      two,
      "phases:\n  - {name: one, active: [along], until: [{time: 1, then: both}]}\n"
      "  - {name: both, active: [along, up], until: [{time: 1, then: none}]}\n"
      "  - {name: none, active: []}\n");
  const ArmScene one("  point_constraint:\n    - {name: along, point: hand, along: [x]}\n");
  EXPECT_EQ(phases.operations("constrained_dynamics_one"), one.operations("constrained_dynamics"));
  EXPECT_EQ(phases.operations("constrained_dynamics_none"),
            ArmScene("").operations("constrained_dynamics"));
  EXPECT_EQ(phases.code().manifest().function("constrained_dynamics_none").outputs.size(), 1U);
  EXPECT_EQ(phases.code().manifest().function("constrained_dynamics_both").outputs.at(1), 2);
}

TEST(Effects, APowerLawRaisesTheDepth) {  // E1: pow where it is needed, and nowhere else
  const char* const power =
      "  ground_contact:\n    - {point: hand, stiffness: 2e4, exponent: 1.3, dissipation: 0.2}\n";
  const ArmScene scene(power);
  EXPECT_TRUE(has(symbols(scene), " pow"));
  EXPECT_FALSE(has(scene.source(), "sqrt"));
  EXPECT_FALSE(has(ArmScene(kGround).source(), "pow"));
  EXPECT_EQ(scene.manifest("constrained_dynamics").at("worst_case_pow"), 1);
  const Vector q = {-0.5, -0.3};
  const double depth = -(std::sin(q[0]) + std::sin(q[0] + q[1]));
  const double speed = std::cos(q[0]) * kqd[0] + std::cos(q[0] + q[1]) * (kqd[0] + kqd[1]);
  const Vector f = scene.code().call("contact_force", {q, kqd});
  EXPECT_EQ(f.at(0), 0);
  EXPECT_NEAR(f.at(2), 2e4 * std::pow(depth, 1.3) * (1 - 0.2 * speed), 1e-10);
  // pressed is as if tau had the force's moment in it
  const Vector lever = {std::cos(q[0]) + std::cos(q[0] + q[1]), std::cos(q[0] + q[1])};
  const Vector pressed = scene.code().call("constrained_dynamics", {q, kqd, ktau});
  const Vector expected = ArmScene("").code().call(
      "constrained_dynamics", {q, kqd, {ktau[0] + lever[0] * f[2], ktau[1] + lever[1] * f[2]}});
  EXPECT_NEAR(pressed.at(0), expected.at(0), 1e-9);  // of 1e3 rad/s^2
  EXPECT_NEAR(pressed.at(1), expected.at(1), 1e-9);
  EXPECT_EQ(scene.code().call("contact_force", {{0.5, 0.3}, kqd}), (Vector{0, 0, 0}));
}

// A height that is no number presses: a dead sensor is not a flight.
TEST(Contact, TellsADepthThatIsNoNumber) {
  const ArmScene scene(kGround);
  const Vector q = {std::numeric_limits<double>::quiet_NaN(), -0.3};
  EXPECT_EQ(scene.code().measure("contact_force", {q, kqd}).status, kNotANumber);
  EXPECT_EQ(scene.code().measure("constrained_dynamics", {q, kqd, ktau}).status, kNotANumber);
  const SceneCode ball(
      fmt::format("scene: ball\nmodel: {}/models/scenes/drop.model.yaml\neffects:\n"
                  "  gravity: [0, 0, -9.81]\n  ground_contact:\n"
                  "    - {{point: ball, height: 0, stiffness: 1e4, exponent: 1.5}}\nduration: 1\n",
                  TREEDYN_SOURCE_DIR));
  EXPECT_EQ(ball.code().measure("constrained_dynamics", {{q[0]}, {0}, {0}}).status, kNotANumber);
  EXPECT_EQ(ball.code().measure("contact_force", {{q[0]}, {0}}).status, kNotANumber);
}

// As in `simulate`; a law of its own need not vanish there.
TEST(Contact, IsOpenWhereThePointJustTouches) {
  const SceneCode ball(
      fmt::format("scene: ball\nmodel: {}/models/scenes/drop.model.yaml\neffects:\n"
                  "  ground_contact:\n    - {{point: ball, law: 1e4*d - 200*v}}\nduration: 1\n",
                  TREEDYN_SOURCE_DIR));
  EXPECT_EQ(ball.code().call("contact_force", {{0}, {-1}}), (Vector{0, 0, 0}));
  EXPECT_EQ(ball.code().call("constrained_dynamics", {{0}, {-1}, {0}}), Vector{0});
  EXPECT_NEAR(ball.code().call("contact_force", {{-1e-9}, {-1}}).at(2), 200, 1e-4);
}

TEST(InverseDynamics, UndoesConstrainedDynamics) {
  // the shoulder has no drive: the reactions carry it
  const ArmScene scene(std::string(kHeld) + "  drive:\n    - {joint: elbow, torque: 5}\n");
  const Vector inverse = scene.code().call("constrained_inverse_dynamics", {kq, kqd, {0.3, -0.2}});
  EXPECT_NEAR(inverse.at(0), 0, 1e-11);
  const Vector J = scene.code().call("reaction_jacobian_transpose", {kq});
  const Vector tau = {inverse[0] + J[0] * inverse[2] + J[1] * inverse[3],
                      inverse[1] + J[2] * inverse[2] + J[3] * inverse[3]};
  const ArmScene free("  drive:\n    - {joint: elbow, torque: 5}\n");
  const Vector qdd = free.code().call("constrained_dynamics", {kq, kqd, tau});
  EXPECT_NEAR(qdd.at(0), 0.3, 1e-11);
  EXPECT_NEAR(qdd.at(1), -0.2, 1e-11);
}

TEST(InverseDynamics, AsksNothingOfJointsThatAreNotActuated) {
  const ArmScene shoulder(kHeld, "actuated: [shoulder]\n");
  EXPECT_NEAR(shoulder.code().call("constrained_inverse_dynamics", {kq, kqd, {0.3, -0.2}}).at(1), 0,
              1e-11);
  const ArmScene elbow(kHeld, "actuated: [elbow]\n");
  EXPECT_NEAR(elbow.code().call("constrained_inverse_dynamics", {kq, kqd, {0.3, -0.2}}).at(0), 0,
              1e-11);
  EXPECT_FALSE(ArmScene(kHeld).code().manifest().has("constrained_inverse_dynamics"));
}

TEST(InverseDynamics, UndoesConstrainedDynamicsOnTheGround) {
  const std::string elbow = "  drive:\n    - {joint: elbow, torque: 5}\n";
  const ArmScene scene(std::string(kHeld) + kGround + elbow);
  const ArmScene free(kGround + elbow);
  for (const double shoulder : {0.4, -0.1}) {  // above the ground and pressed into it
    const Vector q = {shoulder, -0.3};
    const Vector inverse = scene.code().call("constrained_inverse_dynamics", {q, kqd, {0.3, -0.2}});
    EXPECT_NEAR(inverse.at(0), 0, 1e-9);
    const Vector J = scene.code().call("reaction_jacobian_transpose", {q});
    const Vector tau = {inverse[0] + J[0] * inverse[2] + J[1] * inverse[3],
                        inverse[1] + J[2] * inverse[2] + J[3] * inverse[3]};
    const Vector qdd = free.code().call("constrained_dynamics", {q, kqd, tau});
    EXPECT_NEAR(qdd.at(0), 0.3, 1e-9);  // reactions of some 1e3 N, roundings of 1e-13 of them
    EXPECT_NEAR(qdd.at(1), -0.2, 1e-9);
  }
}

/// A scene of the arm with its inverse dynamics, though no reaction stands for a drive.
SceneCode asked_for_inverse(const std::string& effects) {
  return SceneCode(arm_scene(effects), Variant::kPlain,
                   {"--functions", "constrained_inverse_dynamics,constrained_dynamics"});
}

TEST(InverseDynamics, WithoutRowsHasWhatTheSceneAdds) {
  const SceneCode loaded = asked_for_inverse(
      "  armature:\n    - {joint: elbow, inertia: 0.4}\n"
      "  viscous_friction:\n    - {joint: shoulder, coefficient: 3}\n"
      "  joint_spring:\n    - {joint: elbow, stiffness: 50, rest: 0.1}\n"
      "  drive:\n    - {joint: shoulder, torque: 2*t}\n");
  const SceneCode bare = asked_for_inverse("");
  const Vector qdd = {0.3, -0.2};
  const double t = 0.7;
  const Vector tau = loaded.code().call("constrained_inverse_dynamics", {kq, kqd, qdd, {t}});
  const Vector of_links = bare.code().call("constrained_inverse_dynamics", {kq, kqd, qdd});
  ASSERT_EQ(tau.size(), 2U);
  EXPECT_NEAR(tau[0] - of_links.at(0), 3 * kqd[0] - 2 * t, 1e-11);
  EXPECT_NEAR(tau[1] - of_links.at(1), 0.4 * qdd[1] + 50 * (kq[1] - 0.1), 1e-11);
  const Vector back = loaded.code().call("constrained_dynamics", {kq, kqd, tau, {t}});
  EXPECT_NEAR(back.at(0), qdd[0], 1e-11);
  EXPECT_NEAR(back.at(1), qdd[1], 1e-11);
}

TEST(InverseDynamics, WithoutRowsCarriesTheContact) {
  const SceneCode scene = asked_for_inverse(kGround);
  for (const double shoulder : {0.4, -0.1}) {  // above the ground and pressed into it
    const Vector q = {shoulder, -0.3};
    const Vector tau = scene.code().call("constrained_inverse_dynamics", {q, kqd, {0.3, -0.2}});
    const Vector qdd = scene.code().call("constrained_dynamics", {q, kqd, tau});
    EXPECT_NEAR(qdd.at(0), 0.3, 1e-9);
    EXPECT_NEAR(qdd.at(1), -0.2, 1e-9);
  }
}

TEST(InverseDynamics, OfRowsBesideDrivesOnAllJointsNeedsNoReaction) {
  const SceneCode held = asked_for_inverse(kHeld);
  const Json manifest = held.manifest("constrained_inverse_dynamics");
  ASSERT_EQ(manifest.at("outputs").size(), 1U);
  EXPECT_EQ(
      held.code().call("constrained_inverse_dynamics", {kq, kqd, {0.3, -0.2}}),
      asked_for_inverse("").code().call("constrained_inverse_dynamics", {kq, kqd, {0.3, -0.2}}));
}

/// Operations of constrained_dynamics of a robot on `axes` with two feet held.
long cost_of_two_feet(const std::string& robot, const std::string& left, const std::string& right,
                      const std::string& kinds) {
  const TemporaryFolder folder;
  write_file(folder.path() / "scene.yaml",
             fmt::format("scene: feet\nmodel: {}/robots/urdf/{}\nbase: axes\npoints:\n"
                         "  - {{name: left, link: {}, at: [0, 0, 0]}}\n"
                         "  - {{name: right, link: {}, at: [0, 0, 0]}}\n"
                         "effects:\n  gravity: [0, 0, -9.81]\n{}duration: 1\n",
                         TREEDYN_SHARED_DATA, robot, left, right, kinds));
  generate({},
           {"--scene", (folder.path() / "scene.yaml").string(), "--functions",
            "constrained_dynamics", "--effort", "500"},
           folder.path());
  const Operations count =
      read_manifest(folder.path() / "generated.json").function("constrained_dynamics").operations;
  return count[0] + count[1] + count[2];
}

const char* const kPoints = "  point_constraint: [{point: left}, {point: right}]\n";
const char* const kClamped =
    "  point_constraint: [{point: left}, {point: right}]\n"
    "  orientation_constraint: [{point: left}, {point: right}]\n";

struct Feet {
  const char* robot;
  const char* left;
  const char* right;
  const char* kinds;
  long limit;  ///< tests/benchmark/README.md
};

const Feet kFeet[] = {{"hyq_no_sensors.urdf", "lf_foot", "rh_foot", kPoints, 4164},
                      {"simple_humanoid.urdf", "l_ankle", "r_ankle", kClamped, 14000}};

class TwoFeet : public testing::TestWithParam<Feet> {};

TEST_P(TwoFeet, CostNoMoreThanTheirTarget) {
  const Feet& feet = GetParam();
  EXPECT_LE(cost_of_two_feet(feet.robot, feet.left, feet.right, feet.kinds), feet.limit);
}

std::vector<Feet> available_feet() {
  std::vector<Feet> result;
  for (const Feet& feet : kFeet) {
    const std::filesystem::path robots = TREEDYN_SHARED_DATA "/robots/urdf";
    if (std::filesystem::exists(robots / feet.robot)) {
      result.push_back(feet);
    }
  }
  return result;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(TwoFeet);
INSTANTIATE_TEST_SUITE_P(Robots, TwoFeet, testing::ValuesIn(available_feet()),
                         [](const auto& test) {
                           const std::string robot = test.param.robot;
                           return robot.substr(0, robot.find('.'));
                         });

}  // namespace
}  // namespace treedyn::support
