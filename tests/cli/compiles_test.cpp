// What is generated compiles, without a warning: models and scenes in which only some of what
// functions usually need is there.
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/cli.hpp"

namespace treedyn {
namespace {

const std::string kBall =
    "name: ball\nlinks:\n  - name: ball\n    father: ground\n    joint: {name: height, type: "
    "prismatic, axis: [0, 0, 1]}\n    mass: 1\n";

class Compiles : public Cli {
 protected:
  /// Generates NAME.cpp and compiles it: g++ tells of unused functions when it writes code.
  void expect_compiles(std::vector<std::string> command, const std::string& name) {
    command.insert(command.begin(), "generate");
    command.insert(command.end(), {"-q", "--effort", "0", "-o", out()});
    const Outcome outcome = treedyn(command);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const bool is_c = std::ranges::find(command, "c99") != command.end();
    std::vector<std::string> compiler = {TREEDYN_CXX, "-Wall",        "-Wextra",     "-Wpedantic",
                                         "-Wshadow",  "-Wconversion", "-Werror",     "-Wno-psabi",
                                         "-c",        "-o",           scratch("o.o")};
    const std::vector<std::string> language =
        is_c ? std::vector<std::string>{"-std=c99", "-x", "c", file(name + ".c").string()}
             : std::vector<std::string>{"-std=c++11", "-Wuseless-cast",
                                        file(name + ".cpp").string()};
    compiler.insert(compiler.end(), language.begin(), language.end());
    const Outcome compiled = support::run(compiler);
    EXPECT_EQ(compiled.status, 0) << compiled.err;
  }
  [[nodiscard]] std::string scene_of_ball(const std::string& lines) const {
    write_file(scratch("ball.yaml"), kBall);
    write_file(scratch("s.yaml"), "scene: s\nmodel: ball.yaml\n" + lines);
    return scratch("s.yaml");
  }
};

/// The equation stands in comments, where nothing calls its cosine.
TEST_F(Compiles, EquationsWithACosineOfANumber) {
  write_file(scratch("e.yaml"), "equations:\n  - {name: turned, value: cos(pi/7) * r}\n");
  expect_compiles(
      {kModel, "--equations", scratch("e.yaml"), "--functions", "turned", "--language", "c99"},
      "two_link");
}

/// What tells a number that is none has to see it.
TEST_F(Compiles, NothingWithAStatusWhereEveryNumberIsFinite) {
  const std::string scene = scene_of_ball("effects: {gravity: [0, 0, -9.81]}\nduration: 1\n");
  using Words = std::vector<std::string>;
  for (const auto& [words, name, refused] :
       {std::tuple{Words{kModel, "--functions", "forward_dynamics"}, "two_link", false},
        {Words{kModel, "--functions", "forward_dynamics", "--checked"}, "two_link", true},
        {Words{kModel, "--functions", "forward_dynamics", "--self-test"}, "two_link", true},
        {Words{kModel, "--checked", "--language", "c99"}, "two_link", true},
        {Words{"--scene", scene}, "s", true}}) {
    std::vector<std::string> command = {"generate"};
    command.insert(command.end(), words.begin(), words.end());
    command.insert(command.end(), {"-q", "--effort", "0", "--sincos", "libm", "-o", out()});
    ASSERT_EQ(treedyn(command).status, 0);
    const bool is_c = fs::exists(file(std::string(name) + ".c"));
    const Outcome compiled =
        support::run({TREEDYN_CXX, "-x", is_c ? "c" : "c++", "-ffinite-math-only", "-fsyntax-only",
                      file(std::string(name) + (is_c ? ".c" : ".cpp")).string()});
    EXPECT_EQ(compiled.status != 0, refused) << words.back();
    EXPECT_EQ(compiled.err.find("not for -ffinite-math-only") != std::string::npos, refused);
    fs::remove_all(out());
  }
}

TEST_F(Compiles, LinksWhoseNamesBeginWithDigits) {
  write_file(scratch("m.yaml"),
             "name: m\nlinks:\n  - name: 1st\n    father: ground\n    joint: {name: a, type: "
             "revolute, axis: [0, 1, 0]}\n    mass: 2\n    com: [0.5, 0, 0]\n"
             "  - name: \"2\"\n    father: 1st\n    joint: {name: b, type: revolute, axis: [0, 1, "
             "0], offset: [1, 0, 0]}\n    mass: 3\n    com: [0.4, 0, 0]\n");
  expect_compiles({scratch("m.yaml")}, "m");
  expect_compiles({scratch("m.yaml"), "--runtime", "2.mass"}, "m");
}

/// The function of the phase called stance_2 has the name that the second part of that of the phase
/// stance would get.
TEST_F(Compiles, PhasesThatAreNamedAsPartsWouldBe) {
  write_file(
      scratch("s.yaml"),
      "scene: s\nmodel: " TREEDYN_SOURCE_DIR
      "/models/quadruped.yaml\nbase: axes\neffects:\n  gravity: [0, 0, -9.81]\n"
      "  point_constraint: [{point: front_left_foot}, {point: front_right_foot}]\nphases:\n"
      "  - {name: stance, active: [front_left_foot], until: [{time: 0.1, then: stance_2}]}\n"
      "  - {name: stance_2, active: [front_right_foot], until: [{time: 0.1, then: stance}]}\n"
      "duration: 1\n");
  for (const char* language : {"c++", "c99"}) {
    expect_compiles({"--scene", scratch("s.yaml"), "--functions", "constrained_dynamics",
                     "--language", language},
                    "s");
  }
}

/// The second contact of the point `foot` is not that of the point `foot_2`.
TEST_F(Compiles, ContactsThatAreNamedAsOthersWouldBe) {
  std::string model = kBall + "points:\n";
  for (const char* point : {"foot", "foot_2"}) {
    model += fmt::format("  - {{name: {}, link: ball}}\n", point);
  }
  write_file(scratch("m.yaml"), model);
  write_file(
      scratch("s.yaml"),
      "scene: s\nmodel: m.yaml\neffects:\n  ground_contact:\n"
      "    - {point: foot, stiffness: 1000}\n    - {point: foot, stiffness: 2000, height: -5}\n"
      "    - {point: foot_2, stiffness: 7000}\n"
      "initial: {q: {height: -0.001}}\nduration: 0.002\n");
  expect_compiles({"--scene", scratch("s.yaml")}, "s");
  expect_compiles({"--scene", scratch("s.yaml"), "--language", "c99"}, "s");
  const std::string header = read_file(file("s.hpp"));
  for (const char* name :
       {"contact_force_foot(", "contact_force_foot_2(", "contact_force_foot_3("}) {
    EXPECT_EQ(header.find(name), header.rfind(name)) << name;
    EXPECT_NE(header.find(name), std::string::npos) << name;
  }
}

/// Its guards have parts, one of them beside the guards of the phase `stance_2`.
TEST_F(Compiles, GuardsThatAreNamedAsPartsWouldBe) {
  std::string links;
  std::string father = "ground";
  for (int k = 0; k < 40; ++k) {
    links += fmt::format(
        "  - {{name: l{0}, father: {1}, mass: 1, joint: {{name: j{0}, type: prismatic, "
        "axis: [0, 0, 1]}}}}\n",
        k, father);
    father = fmt::format("l{}", k);
  }
  std::string events;
  for (int k = 0; k < 20; ++k) {
    events += "      - {expression: '1";
    for (int n = 0; n < 40; ++n) {
      events += fmt::format(" + sin({}*q[j{}])", k + 2, n);
    }
    events += "', then: stance_2}\n";
  }
  write_file(scratch("m.yaml"), "name: m\nlinks:\n" + links);
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: m.yaml\neffects: {gravity: [0, 0, -9.81]}\n"
             "phases:\n  - name: stance\n    until:\n" +
                 events +
                 "  - {name: stance_2, until: [{expression: 'q[j0] - 1', then: "
                 "stance}]}\nduration: 1\nstepping: {integrator: rk4, step: "
                 "0.001}\n");
  expect_compiles({"--scene", scratch("s.yaml"), "--functions", "step", "--language", "c99"}, "s");
  EXPECT_THAT(read_file(file("s.c")), HasSubstr("void guards_stance_part_2("));
}

/// The third link does not turn: u + u - 2 u.
TEST_F(Compiles, MimicJointsWhoseTurnsCancel) {
  std::string text = R"(<robot name="m"><link name="base"/>)";
  std::string father = "base";
  for (const auto& [name, more] : {std::pair("a", ""),
                                   {"b", R"(<mimic joint="a"/>)"},
                                   {"c", R"(<mimic joint="a" multiplier="-2"/>)"}}) {
    text += fmt::format(
        R"(<link name="l{0}"><inertial><origin xyz="0.1 0 0.05"/><mass value="1"/>)"
        R"(<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>)"
        R"(<joint name="{0}" type="continuous"><parent link="{1}"/><child link="l{0}"/>)"
        R"(<origin xyz="0.3 0 0.1"/><axis xyz="0 1 0"/>{2}</joint>)",
        name, father, more);
    father = fmt::format("l{}", name);
  }
  write_file(scratch("m.urdf"), text + "</robot>");
  expect_compiles({scratch("m.urdf"), "--functions",
                   "kinetic_energy,bias_force,inverse_dynamics,forward_dynamics"},
                  "m");
  for (const auto& [output, line] :
       {std::pair("m.hpp", "//   c            -2 q[0] + 0\n"),
        {"m.json", R"({"name": "c", "index": 0, "multiplier": -2, "offset": 0})"}}) {
    EXPECT_NE(read_file(file(output)).find(line), std::string::npos) << output;
  }
}

/// Identifiers that begin with _ and a capital, or with two, are the language's.
TEST_F(Compiles, LinksWhoseNamesBeginLikeThoseOfTheLanguage) {
  write_file(scratch("m.yaml"),
             "name: m\nlinks:\n  - {name: \"_Bool\", father: ground, joint: {name: _J, type: "
             "revolute, axis: [0, 1, 0]}, mass: 2, com: [0.3, 0, 0]}\n");
  expect_compiles({scratch("m.yaml"), "--functions", "gravity_force"}, "m");
  const std::string text = read_file(file("m.cpp"));
  EXPECT_NE(text.find("constexpr double n_Bool_"), std::string::npos) << text;
  EXPECT_EQ(text.find("double _"), std::string::npos);
}

TEST_F(Compiles, LimbLanesThatTakeOneOfSineAndCosine) {
  std::string text = "name: arms\nlinks:\n";
  for (const char* const arm : {"left", "right"}) {
    const std::string name = arm;
    text +=
        "  - name: upper_" + name + "\n    father: ground\n    joint: {name: u_" + name +
        ", type: revolute, axis: [0, 1, 0]}\n    mass: 2\n    com: [0.5, 0, 0]\n  - name: lower_" +
        name + "\n    father: upper_" + name + "\n    joint: {name: l_" + name +
        ", type: revolute, axis: [0, 1, 0], offset: [1, 0, 0]}\n    mass: 3\n    com: [0.4, 0, "
        "0]\n";
  }
  write_file(scratch("arms.yaml"), text);
  for (const char* const function : {"mass_matrix", "gravity_force", "inverse_dynamics"}) {
    expect_compiles({scratch("arms.yaml"), "--limb-lanes", "--functions", function}, "arms");
    for (const char* const compiler : {TREEDYN_CXX, "clang++"}) {  // vectors cross no call
      const Outcome compiled = support::run({compiler, "-std=c++11", "-O2", "-Werror", "-c",
                                             file("arms.cpp").string(), "-o", scratch("arms.o")});
      EXPECT_EQ(compiled.status, 0) << compiled.err;
    }
  }
}

/// -O3 takes loops apart, and g++ then takes arrays that loops fill for arrays that nobody filled.
TEST_F(Compiles, DependentRowsWithAllOptimisation) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " TREEDYN_SOURCE_DIR
             "/models/two_link.yaml\nduration: 1\neffects:\n"
             "  point_constraint: [{name: a, point: tip, along: [x, z]}, {name: b, point: tip, "
             "along: [x]}]\ninitial: {q: {shoulder: 0.3, elbow: 1}}\n");
  for (const char* const scalar : {"double", "float"}) {
    EXPECT_EQ(treedyn({"generate", "--scene", scratch("s.yaml"), "--scalar", scalar, "-q",
                       "--effort", "0", "-o", out()})
                  .status,
              0);
    EXPECT_THAT(read_file(file("s.cpp")), testing::HasSubstr("solve_deficient_"));
    for (const char* const compiler : {TREEDYN_CXX, "clang++"}) {
      const Outcome compiled =
          support::run({compiler, "-std=c++11", "-O3", "-Wall", "-Wextra", "-Werror", "-c",
                        file("s.cpp").string(), "-o", scratch("s.o")});
      EXPECT_EQ(compiled.status, 0) << compiled.err;
    }
  }
}

// Angles of 15 digits leave tilts of 1e-16 and cosines that differ from 1 by 1e-32: to the proof
// they are no zeros, so code that limbs share may not take them for such.
TEST_F(Compiles, LimbsBehindTiltsOfRounding) {
  std::string text =
      "name: m\nlinks:\n  - name: base\n    father: ground\n    joint: {name: j0, type: prismatic, "
      "axis: [0.7, -0.246, 1.187549652], offset: [-0.2, 0.439991672, 0.1], rotation: {rpy: [0, "
      "3.141592653589793, 3.141592653589793]}}\n    mass: 0.7\n    com: [0.0135, 0, 0]\n";
  for (const auto& [name, place] :
       {std::pair<std::string, std::string>{"a", "[-0.348, 0.29, 0]"},
        std::pair<std::string, std::string>{"b", "[-0.353054693, -0.613569403, 0]"}}) {
    text += "  - name: " + name + "\n    father: base\n    joint: {name: j_" + name +
            ", type: revolute, axis: [0, 0, 1], offset: " + place +
            "}\n    mass: 4.45\n    inertia: [0.5, 0, 0, 0.5, 0, 0.5]\n";
  }
  write_file(scratch("m.yaml"),
             text +
                 "points:\n  - {name: pa, link: a, at: [-0.6, 0.53, 0.974]}\n  - {name: pb, link: "
                 "b, at: [0, -0.3, 0]}\n");
  expect_compiles(
      {scratch("m.yaml"), "--snap", "0", "--share-limbs", "--functions", "point_rotations"}, "m");
}

TEST_F(Compiles, StepsThatEventsCut) {
  for (const char* scalar : {"double", "float"}) {
    expect_compiles({"--scene", TREEDYN_SOURCE_DIR "/models/scenes/compass_walk.yaml",
                     "--integrator", "rk4", "--name", "walk", "--scalar", scalar},
                    "walk");
  }
}

TEST_F(Compiles, MassMatricesOfNothing) {
  write_file(
      scratch("m.yaml"),
      "name: m\nlinks:\n  - name: a\n    father: ground\n    joint: {name: j, type: revolute, "
      "axis: [0, 1, 0]}\n    mass: 0\n");
  expect_compiles({scratch("m.yaml"), "--layout", "packed", "--functions", "mass_matrix"}, "m");
  EXPECT_THAT(read_file(file("m.hpp")), HasSubstr("constexpr int kMassMatrixNonzeros = 1;"));
}

TEST_F(Compiles, PhasesThatReboundsAndTimeEnd) {
  const std::string begin =
      "effects:\n  gravity: [0, 0, -9.81]\n  point_constraint: [{name: floor, point: ball, along: "
      "[z]}]\nphases:\n  - name: fly\n    active: []\n    until:\n      - touch_down: {point: "
      "ball}\n        impact: {constraints: [floor], restitution: 0.5}\n        then: fly\n";
  const std::string end =
      "initial: {q: {height: 1}}\nduration: 1\nstepping: {integrator: rk4, step: 0.001}\n";
  expect_compiles({"--scene", scene_of_ball(begin + "      - {time: 0.3, then: fly}\n" + end)},
                  "s");
  expect_compiles({"--scene", scene_of_ball(begin + "        not_before: 0.1\n" + end)}, "s");
}

/// Two impacts that differ in their constraints, behind that of coming to rest.
TEST_F(Compiles, ThreeImpactsOfOnePhase) {
  expect_compiles(
      {"--scene",
       scene_of_ball(
           "effects:\n  gravity: [0, 0, -9.81]\n  point_constraint:\n    - {name: floor, point: "
           "ball, along: [z]}\n    - {name: ceiling, point: ball, along: [z]}\nphases:\n  - name: "
           "fly\n    active: []\n    until:\n      - touch_down: {point: ball}\n        impact: "
           "{constraints: [floor], restitution: 0.5, rest_below: 0.05}\n        then: fly\n      - "
           "time: 1.5\n        impact: {constraints: [ceiling]}\n        then: fly\n      - "
           "touch_down: {point: ball, normal: [0, 0, -1], height: -2}\n        impact: "
           "{constraints: [ceiling], restitution: 0.5}\n        then: fly\ninitial: {q: {height: "
           "1}}\nduration: 1\nstepping: {integrator: rk4, step: 0.001}\n")},
      "s");
}

TEST_F(Compiles, PhasesThatTimeAloneEnds) {
  const std::string scene = scene_of_ball(
      "effects:\n  gravity: [0, 0, -9.81]\nphases:\n  - {name: up, until: [{time: 0.3, then: "
      "down}]}\n  - {name: down, until: [{time: 0.2, then: up}]}\nduration: 1\nstepping: "
      "{integrator: rk4, step: 0.001}\n");
  expect_compiles({"--scene", scene}, "s");
  EXPECT_THAT(read_file(file("s.cpp")), Not(HasSubstr("[[")));  // attributes are not of C++11
  expect_compiles({"--scene", scene, "--language", "c99"}, "s");
}

TEST_F(Compiles, ContactsOfWhatNoJointMoves) {
  write_file(scratch("rod.yaml"),
             "name: rod\nlinks:\n  - name: rod\n    father: ground\n    joint: {name: pivot, type: "
             "revolute, axis: [0, 1, 0]}\n    mass: 1\n    com: [0, 0, -1]\n");
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: rod.yaml\neffects:\n  ground_contact: [{point: rod, stiffness: 100, "
             "height: 0.1}]\nduration: 1\n");
  expect_compiles({"--scene", scratch("s.yaml")}, "s");
}

TEST_F(Compiles, EventsThatAloneTakeTheTime) {
  expect_compiles(
      {"--scene",
       scene_of_ball(
           "effects:\n  gravity: [0, 0, -9.81]\n  locked_joint: [{name: hook, joint: "
           "height}]\nphases:\n  - name: fall\n    active: []\n    until:\n      - {expression: "
           "\"q[height] - sin(5*t)\", then: hang, impact: {constraints: [hook]}}\n  - name: hang\n "
           " "
           "  active: [hook]\n    until: [{time: 0.2, then: fall}]\ninitial: {q: {height: "
           "1}}\nduration: 1\nstepping: {integrator: rk4, step: 0.001}\n")},
      "s");
}

}  // namespace
}  // namespace treedyn
