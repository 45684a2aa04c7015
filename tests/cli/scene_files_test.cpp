// What the program writes for a scene.
#include <tuple>

#include "cli/cli.hpp"

namespace treedyn {
namespace {

TEST_F(Cli, AScenesFilesDependOnSceneAndModel) {
  const std::string scene = TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml";
  treedyn({"generate", "--scene", scene, "-o", out(), "--depfile", scratch("d.d")});
  EXPECT_THAT(
      read_file(scratch("d.d")),
      HasSubstr(".json: " + scene + " " TREEDYN_SOURCE_DIR "/models/scenes/pendulum.model.yaml\n" +
                scene + ":\n" TREEDYN_SOURCE_DIR "/models/scenes/pendulum.model.yaml:\n"));
  support::write_file(file("pendulum.cpp"), "");
  EXPECT_THAT(treedyn({"check", "--scene", scene, "-o", out()}).out,
              HasSubstr("to update: treedyn generate --scene " + scene + " -o " + out()));
}

TEST_F(Cli, SaysWhichWayAnExpressionCrossesZero) {
  for (const std::string way : {"rising", "falling"}) {
    const std::string scene = scratch(way + ".yaml");
    write_file(scene, "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                      "/models/two_link.yaml\nphases:\n  - {name: a, until: [{expression: "
                      "\"q[elbow]-0.02\", crossing: " +
                          way + ", then: b}]}\n  - {name: b}\nduration: 1\n");
    EXPECT_EQ(treedyn({"generate", "--scene", scene, "--integrator", "rk4", "--step", "0.01",
                       "--functions", "step", "--effort", "0", "-o", out()})
                  .status,
              0);
    EXPECT_THAT(read_file(file("s.hpp")),
                HasSubstr(way == "rising" ? "the expression rises above zero: b"
                                          : "the expression falls below zero: b"));
  }
}

/// A counter of steps is an int: 2^31 of them are 24.9 days of milliseconds.
TEST_F(Cli, RefusesPhasesOfMoreStepsThanCanBeCounted) {
  const auto generated = [&](const std::string& time) {
    const std::string scene = scratch("long.yaml");
    write_file(scene, "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                      "/models/two_link.yaml\nphases:\n  - {name: a, until: [{time: " +
                          time +
                          ", then: b}]}\n  - {name: b}\nduration: 1\n"
                          "stepping: {integrator: rk4, step: 1e-3}\n");
    return treedyn(
        {"generate", "--scene", scene, "--functions", "step", "--effort", "0", "-o", out()});
  };
  EXPECT_EQ(generated("2e6").status, 0);
  for (const std::string time : {"3e6", "1e20"}) {
    const Outcome outcome = generated(time);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("long.yaml:7:24: phase 'a': "));
    EXPECT_THAT(outcome.err, HasSubstr(" s are more steps of 0.001 s than an int counts; expected "
                                       "longer steps, or up to 2.14748e+06 s"));
  }
  const std::string scene = scratch("long.yaml");  // as the last one left it
  EXPECT_EQ(treedyn({"generate", "--scene", scene, "--functions", "mass_matrix", "--effort", "0",
                     "-o", out()})
                .status,
            0);
  write_file(scene, "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                    "/models/two_link.yaml\nphases:\n  - {name: a, until: [{time: 3e6, then: "
                    "b}]}\n  - {name: b}\nduration: 1\n");
  EXPECT_THAT(treedyn({"generate", "--scene", scene, "--integrator", "rk4", "--step", "1e-3",
                       "--functions", "step", "-o", out()})
                  .err,
              HasSubstr("long.yaml: phase 'a': "));
}

TEST_F(Cli, NamesTheSceneThatLeavesAPointOut) {
  write_file(scratch("bob.model.yaml"),
             "name: bob\nlinks:\n  - {name: rod, father: ground, joint: {name: pivot, type: "
             "revolute, axis: [0, 1, 0]}, mass: 1, com: [0, 0, -1]}\n"
             "points:\n  - {name: bob, link: rod, at: [0, 0, -1], runtime: [at]}\n");
  const std::string scene = scratch("bob.yaml");
  write_file(scene,
             "scene: s\nmodel: bob.model.yaml\neffects: {gravity: [0, 0, -9.81]}\n"
             "duration: 1\n");
  EXPECT_THAT(treedyn({"generate", "--scene", scene, "--effort", "0", "-o", out()}).err,
              HasSubstr(scene + ": warning: the scene leaves point 'bob' out"));
}

TEST_F(Cli, SaysWhereRowsOfAStepDrift) {
  const std::string held = "point_constraint: [{point: ball, along: [z]}]";
  const std::string led = "locked_joint: [{joint: height, at: sin(5*t)}]";
  const std::string locked = "locked_joint: [{joint: height}]";
  const std::string turns = "orientation_constraint: [{point: ball, along: [x]}]";
  const std::string forced = "locked_joint: [{joint: height, acceleration: sin(5*t)}]";
  const std::string scene = scratch("scene.yaml");
  for (const auto& [row, method, drifts] :
       std::vector<std::tuple<std::string, std::string, bool>>{{held, "none", true},
                                                               {held, "projection", true},
                                                               {held, "baumgarte", false},
                                                               {led, "none", true},
                                                               {locked, "none", false},
                                                               {turns, "none", false},
                                                               {forced, "none", false}}) {
    write_file(scene, "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                      "/models/scenes/drop.model.yaml\neffects:\n  " +
                          row + "\n  stabilisation: {method: " + method +
                          "}\nstepping: {integrator: rk4}\nduration: 1\n");
    const Outcome outcome = treedyn({"generate", "--scene", scene, "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const bool told = read_file(file("s.hpp")).find("rows may drift") != std::string::npos;
    EXPECT_EQ(told, drifts) << row << method;
  }
}

/// A lift-off goes with the constraint that it waits for.
TEST_F(Cli, PricesConstraintsThatLiftOff) {
  write_file(scratch("ball.yaml"),
             "name: ball\nlinks:\n  - {name: ball, father: ground, joint: {name: height, type: "
             "prismatic, axis: [0, 0, 1]}, mass: 1}\npoints: [{name: foot, link: ball, at: [0, 0, "
             "0]}]\n");
  write_file(
      scratch("scene.yaml"),
      "scene: s\nmodel: ball.yaml\neffects:\n  gravity: [0, 0, -9.81]\n  point_constraint: "
      "[{name: floor, point: foot, along: [z]}]\nphases:\n  - {name: A, active: [], until: "
      "[{touch_down: {point: foot}, impact: {constraints: [floor]}, then: B}]}\n  - {name: B, "
      "active: [floor], until: [{lift_off: {constraint: floor}, then: A}]}\nduration: 1\n");
  const Outcome outcome = treedyn({"info", "--scene", scratch("scene.yaml"), "--effort", "0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("point_constraint"));
}

TEST_F(Cli, RefusesWhatASceneHasNothingFor) {
  const std::string scene = TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml";  // of no fixed step
  for (const auto& [option, value] :
       {std::pair{"--step", "0.5"}, {"--cuts", "7"}, {"--state", "compensated"}}) {
    const Outcome outcome =
        treedyn({"generate", "--scene", scene, option, value, "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 1) << option;
    EXPECT_THAT(outcome.err, HasSubstr("'fehlberg78' is not for generated code, and --step"));
  }
  const Outcome outcome =
      treedyn({"generate", "--scene", scene, "--functions", "constrained_dynamics,contact_force",
               "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("function 'contact_force': the scene has nothing for it"));
  EXPECT_FALSE(fs::exists(out()));
}

// An arm begins stretched at zeros, where its rows depend on each other; a loop's rows do
// everywhere.
TEST_F(Cli, WarnsOfASingularBeginning) {
  const auto warnings = [&](const std::string& rest) {
    write_file(scratch("scene.yaml"), "scene: held\n" + rest + "duration: 1\n");
    const Outcome outcome = treedyn({"generate", "--scene", scratch("scene.yaml"), "--functions",
                                     "constrained_dynamics", "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  const std::string arm =
      "model: " TREEDYN_SOURCE_DIR
      "/models/puma560.yaml\npoints: [{name: hand, link: link6, at: [0, 0, 0.1]}]\n"
      "effects:\n  point_constraint: [{point: hand}]\n"
      "  orientation_constraint: [{point: hand}]\n";
  EXPECT_THAT(warnings(arm), HasSubstr("with all joints at 0, its 6 rows have rank 5, and 6 "
                                       "elsewhere"));
  EXPECT_THAT(warnings(arm + "initial: {q: {joint3: -0.7, joint5: 0.9}}\n"),
              Not(HasSubstr("where the scene begins")));
  write_file(scratch("cranks.yaml"),
             "name: cranks\nlinks:\n"
             "  - {name: a, father: ground, mass: 1, joint: {name: a, type: revolute, axis: [0, 1, "
             "0]}}\n"
             "  - {name: b, father: ground, mass: 1, com: [0, 0, 1], joint: {name: b, type: "
             "revolute, axis: [0, 1, 0], offset: [1, 0, 0]}}\n"
             "  - {name: c, father: ground, mass: 1, com: [0, 0, 1], joint: {name: c, type: "
             "revolute, axis: [0, 1, 0], offset: [2, 0, 0]}}\n"
             "  - {name: rod, father: a, mass: 1, com: [1, 0, 0], inertia: [1, 0, 0, 1, 0, 1], "
             "joint: {name: rod, type: revolute, axis: [0, 1, 0], offset: [0, 0, 1]}}\n");
  EXPECT_THAT(warnings("model: cranks.yaml\npoints:\n"
                       "  - {name: p, link: rod, at: [1, 0, 0]}\n"
                       "  - {name: q, link: rod, at: [2, 0, 0]}\n"
                       "  - {name: tb, link: b, at: [0, 0, 1]}\n"
                       "  - {name: tc, link: c, at: [0, 0, 1]}\n"
                       "effects:\n  joined_constraint:\n"
                       "    - {name: one, point: p, other: tb, along: [x, z]}\n"
                       "    - {name: two, point: q, other: tc, along: [x, z]}\n"),
              Not(HasSubstr("where the scene begins")));
}

TEST_F(Cli, GuardsACompensatedStateWithoutThePair) {
  const std::string scene = TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml";
  const auto source = [&](const std::string& sincos) {
    EXPECT_EQ(treedyn({"generate", "--scene", scene, "--functions", "step", "--integrator", "rk4",
                       "--state", "compensated", "--sincos", sincos, "--effort", "0", "-o", out()})
                  .status,
              0);
    return read_file(file("pendulum.cpp"));
  };
  const char* const guard = "#error \"a compensated state is what sums round away";
  EXPECT_THAT(source("libm"), HasSubstr(guard));
  EXPECT_THAT(source("pair"), Not(HasSubstr(guard)));
  const std::string slides = scratch("slides.yaml");
  write_file(slides, "scene: slides\nmodel: " TREEDYN_SOURCE_DIR
                     "/tests/scenes/models/cart_and_ball.yaml\neffects: {gravity: [0, 0, -9.81]}\n"
                     "duration: 1\nstepping: {integrator: rk4, step: 0.01, state: compensated}\n");
  EXPECT_EQ(treedyn({"generate", "--scene", slides, "-o", out()}).status, 0);
  EXPECT_THAT(read_file(file("slides.cpp")), HasSubstr(guard)) << "without angles";
}

TEST_F(Cli, RefusesBesideASceneWhatTheSceneSays) {
  const std::string scene = TREEDYN_SOURCE_DIR "/models/scenes/double_pendulum.yaml";
  const std::vector<std::string> generate = {"generate", "--scene",     scene,  "--effort", "0",
                                             "-q",       "--functions", "step", "-o",       out()};
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"--base", "axes"},  {"--base", "fixed"},        {"--snap", "1e-9"},
      {"--points", "tip"}, {"--gravity", "0,0,-9.81"}, {"--mimic", "reduce"}};
  for (const auto& [option, value] : refused) {
    std::vector<std::string> arguments = generate;
    arguments.insert(arguments.end(), {option, value});
    const bool by_default = option == "--snap" || option == "--mimic";
    expect_usage_error(treedyn(arguments), option + (by_default ? ": goes with no scene"
                                                                : ": is a matter of the scene"));
  }
}

TEST_F(Cli, WarnsOfFunctionsThatKnowNothingOfEffects) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " TREEDYN_SOURCE_DIR
             "/models/two_link.yaml\nduration: 1\neffects:\n  armature: [{joint: "
             "elbow, inertia: 0.1}]\nuse: {velocity_products: off}\n");
  const auto warnings = [&](const char* functions) {
    return treedyn({"generate", "--scene", scratch("s.yaml"), "--functions", functions, "--effort",
                    "0", "-o", out()})
        .err;
  };
  const std::string all = warnings("constrained_dynamics,mass_matrix,bias_force,inverse_dynamics");
  EXPECT_THAT(all, HasSubstr("without the scene's armature: mass_matrix, inverse_dynamics\n"));
  EXPECT_THAT(all, HasSubstr("that the scene leaves out: bias_force, inverse_dynamics\n"));
  EXPECT_THAT(warnings("constrained_dynamics,gravity_force"),
              testing::Not(HasSubstr("tree alone")));
}

TEST_F(Cli, WarnsOfReboundsThatNeverRest) {
  const auto warnings = [&](const std::string& then, const std::string& stepping) {
    write_file(scratch("s.yaml"),
               "scene: s\nmodel: " + kModel +
                   "\nduration: 1\neffects:\n  locked_joint: [{joint: elbow}]\nphases:\n"
                   "  - name: free\n    until:\n      - {expression: \"q[elbow]\", impact: "
                   "{constraints: [elbow], restitution: 0.5}, then: " +
                   then + "}\n  - {name: other}\n" + stepping);
    return treedyn({"generate", "--scene", scratch("s.yaml"), "--effort", "0", "-o", out()}).err;
  };
  const std::string step = "stepping: {integrator: rk4, step: 1e-3}\n";
  const std::string said = "phase 'free': rebounds at an expression never come to rest";
  EXPECT_THAT(warnings("free", step), HasSubstr(said));
  EXPECT_THAT(treedyn({"simulate", scratch("s.yaml"), "--as-generated"}).err, HasSubstr(said));
  EXPECT_THAT(warnings("other", step), Not(HasSubstr("rebounds")));
  EXPECT_THAT(warnings("free", ""), Not(HasSubstr("rebounds")));
}

/// Two points of one place but for the last digits of their lengths, 2e-18 m: what joins them moves
/// by those alone, and its entries of J have not the digits of others.
TEST_F(Cli, TakesRowsThatLastDigitsOfLengthsMove) {
  write_file(
      scratch("slide.yaml"),
      "name: slide\nlinks:\n"
      "  - {name: arm, father: ground, joint: {name: j, type: revolute, axis: [0, 1, 0]}, mass: "
      "2.4, com: [0.03, -0.06, -0.05], inertia: [0.04, 0, 0, 0.046, 0, 0.034]}\n"
      "  - {name: rod, father: arm, joint: {name: k, type: prismatic, axis: [0, 1, 0], offset: "
      "[-0.46480145665037964, -0.24344700467552594, 0.17582579444797608]}, mass: 2.7, com: "
      "[-0.08, 0.03, -0.18], inertia: [0.061, 0, 0, 0.06, 0, 0.045]}\n"
      "points:\n"
      "  - {name: p, link: arm, at: [-0.08656688552379604, -0.19428830989045448, "
      "-0.010866047591184758]}\n"
      "  - {name: o, link: rod, at: [0.3782345711265836, -0.6559267886825919, "
      "-0.18669184203916084]}\n");
  write_file(
      scratch("s.yaml"),
      "scene: s\nmodel: slide.yaml\neffects:\n  gravity: [0, 0, -9.81]\n  joined_constraint: "
      "[{name: c, point: p, other: o, along: [x, z]}]\ninitial: {q: {j: 0.59, k: "
      "0.7050854834676634}}\nduration: 1\n");
  const Outcome outcome =
      treedyn({"generate", "--scene", scratch("s.yaml"), "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

/// A ball on a floor that no phase holds: it sinks by g h / 2 a second.
TEST_F(Cli, WarnsOfTouchDownsThatNothingHolds) {
  write_file(scratch("ball.yaml"),
             "name: ball\nlinks:\n  - name: ball\n    father: ground\n    joint: {name: z, type: "
             "prismatic, axis: [0, 0, 1]}\n    mass: 1\npoints: [{name: foot, link: ball}]\n");
  const auto warnings = [&](const std::string& impact, const std::string& then,
                            const std::string& gravity = "[0, 0, -9.81]") {
    write_file(scratch("s.yaml"),
               "scene: s\nmodel: ball.yaml\nduration: 1\neffects:\n  gravity: " + gravity +
                   "\n  point_constraint: [{name: floor, point: foot, along: [z]}]\nphases:\n"
                   "  - name: air\n    active: []\n    until:\n      - {touch_down: {point: foot}, "
                   "impact: {constraints: [floor]" +
                   impact + "}, then: " + then +
                   "}\n  - {name: stand, active: [floor]}\ninitial: {q: {z: 0.1}}\n"
                   "stepping: {integrator: rk4, step: 1e-3}\n");
    return treedyn({"generate", "--scene", scratch("s.yaml"), "--effort", "0", "-o", out()}).err;
  };
  EXPECT_THAT(warnings("", "air"),
              HasSubstr("s.yaml: warning: phase 'air': no constraint holds point "
                        "'foot' where its impact stops it"));
  EXPECT_EQ(warnings("", "stand"), "");
  EXPECT_EQ(warnings(", rest_below: 0.01", "air"), "");
  EXPECT_EQ(warnings(", restitution: 0.5", "air"), "");
  EXPECT_EQ(warnings("", "air", "[9.81, 0, 0]"), "");  // a wall
}

TEST_F(Cli, WarnsOfErrorsThatScenesDoNotHave) {
  EXPECT_THAT(treedyn({"generate", "--scene", TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml",
                       "--effort", "0", "--accuracy-samples", "5", "-o", out()})
                  .err,
              HasSubstr("functions of a scene have no errors; --accuracy-samples changes nothing"));
  EXPECT_EQ(treedyn({"generate", "--scene", TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml",
                     "--functions", "inverse_dynamics", "--effort", "0", "--accuracy-samples", "5",
                     "-o", out()})
                .err,
            "");
}

TEST_F(Cli, WarnsOfAnInitialStateThatSimulateRefuses) {
  const auto warnings = [&](const std::string& x) {
    write_file(
        scratch("s.yaml"),
        "scene: s\nmodel: " + kModel +
            "\nduration: 1\neffects:\n  point_constraint: [{point: tip, along: [x, z], curve: "
            "[" +
            x + ", 0, 0]}]\ninitial: {q: {shoulder: 0.3, elbow: -0.6}}\n");
    return treedyn({"generate", "--scene", scratch("s.yaml"), "--effort", "0", "-o", out()}).err;
  };
  EXPECT_THAT(warnings("50"), HasSubstr("the initial state is not near one that meets the "
                                        "constraints: 'tip' stays"));
  EXPECT_THAT(warnings("0.5"), Not(HasSubstr("simulate refuses")));
}

/// Without it the square root is a call of a library on a processor that has it.
TEST_F(Cli, SaysThatSquareRootsNeedNoErrno) {
  const auto header = [&](const std::string& torque) {
    write_file(scratch("s.yaml"), "scene: s\nmodel: " + kModel +
                                      "\nduration: 1\neffects: {drive: [{joint: elbow, torque: " +
                                      torque + "}]}\nstepping: {integrator: rk4}\n");
    const Outcome outcome = treedyn({"generate", "--scene", scratch("s.yaml"), "--scalar", "float",
                                     "--core", "m4f", "--effort", "0", "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_file(file("s.hpp"));
  };
  EXPECT_THAT(header("\"sqrt(1 + q[elbow]*q[elbow])\""), HasSubstr(" -fno-math-errno\n"));
  EXPECT_THAT(header("\"1 + q[elbow]*q[elbow]\""), Not(HasSubstr("-fno-math-errno")));
}

TEST_F(Cli, SaysWhatTheRowsOfASceneAre) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: " + kModel +
                                    "\nduration: 1\nactuated: []\neffects:\n  point_constraint:\n"
                                    "    - {name: pen, point: tip, along: [[1, 0, -1]]}\n");
  ASSERT_EQ(treedyn({"generate", "--scene", scratch("s.yaml"), "--functions",
                     "constrained_inverse_dynamics", "--effort", "0", "-o", out()})
                .status,
            0);
  const std::string header = read_file(file("s.hpp"));
  EXPECT_THAT(header, HasSubstr("Row 0: pen: force along (0.707107, 0, -0.707107)\n"));
  EXPECT_THAT(header,
              HasSubstr("The equations of the 2 joints without a drive have rank 1: lambda"));
}

TEST_F(Cli, StatesTheGravityAndBaseOfAScene) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " + kModel +
                 "\nbase: axes\nduration: 1\neffects: {gravity: [0, 0, -1.62]}\n");
  const Outcome outcome =
      treedyn({"generate", kModel, "--base", "axes", "--scene", scratch("s.yaml"), "--functions",
               "gravity_force", "--effort", "0", "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string manifest = read_file(file("s.json"));
  EXPECT_THAT(manifest, HasSubstr("\"gravity\": [0,0,-1.62]"));
  EXPECT_THAT(manifest, HasSubstr("\"base\": \"axes\""));
  EXPECT_THAT(read_file(file("s.hpp")),
              HasSubstr("treedyn generate --scene s.yaml --functions gravity_force --effort 0\n"));
  EXPECT_THAT(treedyn({"info", "--scene", scratch("s.yaml"), "--functions", "gravity_force"}).out,
              HasSubstr("base axes"));
}

TEST_F(Cli, TellsABaseFromAModelThatIsNotTheScenes) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: " + kModel + "\nduration: 1\n");
  const Outcome base =
      treedyn({"generate", kModel, "--base", "axes", "--scene", scratch("s.yaml"), "-o", out()});
  EXPECT_EQ(base.status, 1);
  EXPECT_THAT(base.err, StartsWith(scratch("s.yaml") + ": scene 's' has a fixed base, not --base "
                                                       "axes; expected no --base, or"));
  const std::string other = TREEDYN_SOURCE_DIR "/models/puma560.yaml";
  const Outcome model = treedyn({"generate", other, "--scene", scratch("s.yaml"), "-o", out()});
  EXPECT_EQ(model.status, 1);
  EXPECT_THAT(model.err, StartsWith(other + ": is not the model of scene 's'; expected that one"));
}

/// A scene of an arm of links with these joints, one on the other.
std::string scene_of_arm(const std::string& folder, const std::vector<std::string>& joints,
                         const std::string& lines) {
  std::string model = "name: arm\nlinks:\n";
  std::string father = "ground";
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const std::string name = "l" + std::to_string(k);
    model += "  - name: " + name + "\n    father: " + father + "\n    joint: {name: j" +
             std::to_string(k) + ", type: revolute, " + joints[k] +
             "}\n    mass: 1\n    com: [0, 0.1, 0.2]\n    inertia: [1, 0, 0, 1, 0, 1]\n";
    father = name;
  }
  write_file(folder + "arm.yaml", model);
  write_file(folder + "s.yaml", "scene: s\nmodel: arm.yaml\n" + lines + "duration: 1\n");
  return folder + "s.yaml";
}

// The height of a link's origin on a joint's axis is a constant in every frame of the link.
TEST_F(Cli, TakesSinesOfHeightsThatDoNotChange) {
  const std::string scene = scene_of_arm(
      scratch(""),
      {"axis: [-0.029, 1, 1], offset: [0, 0, -0.301]", "axis: [0, 1, 0], offset: [0, 0, -0.36]"},
      "effects:\n  moment: [{point: l0, value: [sin(2*z), 0, z]}]\n");
  const Outcome outcome = treedyn({"generate", "--scene", scene, "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

// The last joint does not move its own link's origin, whatever rounding leaves of that.
TEST_F(Cli, KnowsJointsThatAHeldPointLeavesFree) {
  const std::string scene = scene_of_arm(
      scratch(""),
      {"axis: [0, 0, 1]", "axis: [0, 0, 1], offset: [0, 1, 0]",
       "axis: [1, 1, -0.75], offset: [0, 1, 0], rotation: {rpy: [0, 0, 1]}"},
      "effects:\n  drive: [{joint: j0, kp: 0, target: 0}]\n  point_constraint: [{point: l2}]\n");
  const Outcome outcome = treedyn({"generate", "--scene", scene, "--effort", "0", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(Cli, RefusesAStateThatSdirk2DoesNotCompensate) {
  const std::string scene = TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml";
  const std::string message = "--state: sdirk2 keeps no compensated state; expected plain";
  expect_usage_error(treedyn({"generate", "--scene", scene, "--integrator", "sdirk2", "--state",
                              "compensated", "-o", out()}),
                     message);
  write_file(scratch("s.txt"), "integrator = sdirk2\nstate = compensated\n");
  const Outcome of_settings =
      treedyn({"generate", "--scene", scene, "--settings", scratch("s.txt"), "-o", out()});
  EXPECT_EQ(of_settings.status, 1);
  EXPECT_THAT(of_settings.err, StartsWith(scratch("s.txt") + ":2: settings: " + message));
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " + kModel + "\nduration: 1\nstepping: {integrator: sdirk2}\n");
  const Outcome of_scene =
      treedyn({"generate", "--scene", scratch("s.yaml"), "--state", "compensated", "-o", out()});
  EXPECT_EQ(of_scene.status, 1);
  EXPECT_THAT(of_scene.err, StartsWith(scratch("s.yaml") + ":4:"));
  EXPECT_THAT(of_scene.err, HasSubstr("sdirk2 keeps no compensated state"));
}

TEST_F(Cli, RefusesAnUnknownIntegratorOfAScene) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " + kModel + "\nduration: 1\nstepping: {integrator: nonsense}\n");
  const Outcome outcome = treedyn({"generate", "--scene", scratch("s.yaml"), "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("s.yaml:4:24: stepping: integrator 'nonsense' is unknown"));
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Cli, RefusesATableOfPassesForFunctionsOfAScene) {
  expect_usage_error(
      treedyn({"info", "--passes", "--scene", TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml"}),
      "--passes");
}

}  // namespace
}  // namespace treedyn
