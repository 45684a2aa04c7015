// treedyn simulate as a user calls it; its page in a browser without network.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/process.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::Outcome;
using support::read_file;
using support::write_file;
using testing::HasSubstr;
using testing::Not;

std::string scene(const std::string& name) {
  return TREEDYN_SOURCE_DIR "/models/scenes/" + name + ".yaml";
}

/// Lines of a table, cells without quotes.
std::vector<std::vector<std::string>> table(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

class Simulate : public testing::Test {
 protected:
  static Outcome treedyn(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {TREEDYN_EXECUTABLE, "simulate"});
    return support::run(arguments);
  }
  [[nodiscard]] std::string out() const { return (folder_.path() / "out").string(); }
  [[nodiscard]] fs::path file(const std::string& name) const {
    return folder_.path() / "out" / name;
  }
  [[nodiscard]] fs::path scratch(const std::string& name) const { return folder_.path() / name; }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(Simulate, PrintsATableWithoutAFolder) {
  const Outcome outcome = treedyn({scene("pendulum"), "--duration", "1"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto rows = table(outcome.out);
  EXPECT_EQ(rows.front(),
            (std::vector<std::string>{"t", "phase", "q[pivot]", "qd[pivot]", "kinetic_energy",
                                      "potential_energy", "energy", "drift"}));
  EXPECT_EQ(rows.size(), 502U);
  EXPECT_EQ(rows[1][0], "0");
  EXPECT_EQ(rows.back()[0], "1");
}

TEST_F(Simulate, WritesWhatIsAskedFor) {
  const Outcome outcome = treedyn({scene("arm_circle"), "-q", "-o", out(), "--json", "--report"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  const json data = json::parse(read_file(file("arm_circle.json")));
  EXPECT_EQ(data["columns"].size(), data["rows"][0].size());
  EXPECT_EQ(data["columns"][6], "R[pen.x]");
  EXPECT_EQ(data["stopped"], "");
  EXPECT_EQ(table(read_file(file("arm_circle.csv"))).size(), data["rows"].size() + 1);
  EXPECT_TRUE(fs::exists(file("arm_circle.html")));
}

TEST_F(Simulate, WarnsWhenItMovesTheInitialState) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " TREEDYN_SOURCE_DIR
             "/models/two_link.yaml\nduration: 0.1\neffects:\n"
             "  point_constraint:\n    - {point: tip, curve: [1.2, 0, 0.8], along: "
             "[x, z]}\ninitial: {q: {elbow: 1.5}}\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string(), "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err,
              testing::ContainsRegex("warning: the initial state was moved by 0\\.[0-9]+ rad "
                                     "\\(q\\[[a-z]+\\]\\) onto the constraints"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("rad/s")));
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " TREEDYN_SOURCE_DIR
             "/models/two_link.yaml\nduration: 0.1\neffects:\n"
             "  point_constraint:\n    - {point: tip, curve: [1.2, 0, 0.8], along: "
             "[x, z]}\ninitial: {q: {elbow: 1.5}, qd: {elbow: 4}}\n");
  EXPECT_THAT(treedyn({scratch("s.yaml").string(), "-o", out()}).err,
              testing::ContainsRegex("moved by 0\\.[0-9]+ rad \\(q\\[[a-z]+\\]\\) [^\n]+\n[^\n]+"
                                     "moved by 4 rad/s \\(qd\\[elbow\\]\\) onto the constraints"));
}

/// A damped spring by steps beyond what rk4 stands: its power grows as fast as its energy, and the
/// motion ends nevertheless; at rest it would be 900 J.
TEST_F(Simulate, EndsAMotionThatExplodes) {
  write_file(scratch("m.yaml"),
             "name: block\nlinks:\n  - {name: block, father: ground, mass: 2, joint: {name: x, "
             "type: prismatic, axis: [1, 0, 0]}}\n");
  const auto run = [&](const std::string& speed, const std::vector<std::string>& more) {
    write_file(scratch("s.yaml"),
               "scene: s\nmodel: m.yaml\nduration: 5\neffects:\n  joint_spring: [{joint: x, "
               "stiffness: 20000, damping: 1.5, rest: 0.3}]\ninitial: {q: {x: 1}, qd: {x: " +
                   speed + "}}\nstepping: {integrator: rk4, step: 0.03}\n");
    std::vector<std::string> arguments = {scratch("s.yaml").string(), "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return treedyn(arguments);
  };
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, std::vector<std::string>{"--as-generated"}}) {
    const Outcome outcome = run("-0.5", more);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(json::parse(outcome.out)["stopped"].get<std::string>(),
                HasSubstr("J that it began with and was given"));
    EXPECT_LT(json::parse(outcome.out)["rows"].size(), 40U);
    EXPECT_THAT(run("1e160", more).err, HasSubstr("the energy is beyond the range of double"));
  }
}

/// A damper beyond what steps stand explodes, too, though its work takes energy away; a drive that
/// steps do not resolve and that brings the block to rest does not, nor one that sdirk2 damps.
TEST_F(Simulate, EndsWhereTheEnergyIsThere) {
  write_file(scratch("m.yaml"),
             "name: block\nlinks:\n  - {name: block, father: ground, mass: 2, joint: {name: x, "
             "type: prismatic, axis: [1, 0, 0]}}\n");
  const auto stopped = [&](const std::string& effect, const std::string& stepping,
                           const std::string& more) {
    write_file(scratch("s.yaml"), "scene: s\nmodel: m.yaml\nduration: 1\neffects:\n  " + effect +
                                      "\nstepping: {" + stepping + "}\n" + more);
    std::vector<std::string> stops;
    for (const std::vector<std::string>& how :
         {std::vector<std::string>{}, std::vector<std::string>{"--as-generated"}}) {
      std::vector<std::string> arguments = {scratch("s.yaml").string(), "--json"};
      arguments.insert(arguments.end(), how.begin(), how.end());
      stops.push_back(json::parse(treedyn(arguments).out)["stopped"]);
    }
    return stops;
  };
  const std::string moving = "initial: {qd: {x: 1}}\n";
  const auto damper = [&](const std::string& coefficient, const std::string& integrator) {
    return stopped("viscous_friction: [{joint: x, coefficient: " + coefficient + "}]",
                   "integrator: " + integrator + ", step: 0.01", moving);
  };
  EXPECT_THAT(damper("600", "semi-implicit-euler"), testing::Each(HasSubstr("began with")));
  EXPECT_THAT(damper("600", "rk4"), testing::Each(HasSubstr("began with")));
  EXPECT_THAT(damper("500", "rk4"), testing::Each(std::string()));
  EXPECT_THAT(stopped("drive: [{joint: x, kp: 2e6, kd: 4000, target: 1}]",
                      "integrator: rk4, step: 0.001", ""),
              testing::Each(std::string()));
  EXPECT_THAT(
      stopped("drive: [{joint: x, kp: 2e7, target: t^2}]", "integrator: sdirk2, step: 0.01", ""),
      testing::Each(std::string()));
}

/// A leg stands in both phases; they change where it turns, when its drift is all the speed there
/// is.
TEST_F(Simulate, WarnsOfNoImpactForWhatHasActedBefore) {
  write_file(
      scratch("leg.yaml"),
      "name: leg\nlinks:\n"
      "  - {name: sx, father: ground, joint: {name: x, type: prismatic, axis: [1, 0, 0]}}\n"
      "  - {name: sz, father: sx, joint: {name: z, type: prismatic, axis: [0, 0, 1]}, mass: 1}\n"
      "  - {name: leg, father: sz, joint: {name: a, type: revolute, axis: [0, 1, 0]}, mass: 1, "
      "com: [0, 0, -0.3]}\npoints: [{name: foot, link: leg, at: [0, 0, -1]}]\n");
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: leg.yaml\nduration: 0.5\neffects:\n  gravity: [0, 0, -9.81]\n"
             "  point_constraint: [{name: stand, point: foot, along: [x, z]}]\nphases:\n"
             "  - {name: one, active: [stand], until: [{expression: \"qd[a]\", crossing: rising, "
             "then: two}]}\n  - {name: two, active: [stand]}\n"
             "initial: {q: {z: cos(0.3), x: sin(0.3), a: 0.3}, qd: {a: -0.8, x: -0.8*cos(0.3), "
             "z: 0.8*sin(0.3)}}\nstepping: {integrator: semi-implicit-euler, step: 0.001}\n");
  const Outcome outcome =
      treedyn({scratch("s.yaml").string(), "--drift", "none", "--json", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(json::parse(read_file(file("s.json")))["events"].size(), 1U);
  EXPECT_THAT(outcome.err, Not(HasSubstr("no impact")));
}

/// A point led forth and back: its speed jumps by 0.4 m/s at t = 0.503 s.
TEST_F(Simulate, SaysWhereWhatLeadsAConstraintJumps) {
  const auto led = [&](const std::string& x) {
    write_file(scratch("s.yaml"),
               "scene: s\nmodel: " TREEDYN_SOURCE_DIR
               "/models/two_link.yaml\n"
               "effects:\n"
               "  point_constraint: [{name: pen, point: tip, along: [x, z], curve: [" +
                   x +
                   ", 0, -0.4]}]\n"
                   "initial: {q: {shoulder: -0.988751, elbow: 1.439167}, "
                   "qd: {shoulder: 0.1, elbow: 0.1}}\n"
                   "duration: 1\n");
    return treedyn({scratch("s.yaml")}).err;
  };
  EXPECT_THAT(led("1.35 + 0.2*sqrt((t - 0.503)^2)"), HasSubstr("pulls the motion by 0.4 m/s"));
  EXPECT_THAT(led("1.35 + 0.2*(t - 0.503)^2"), Not(HasSubstr("pulls")));
}

/// What holds a foot in both directions lets go of both where the floor would pull: the motion of
/// the other one drives it into the floor again at once.
TEST_F(Simulate, NamesTheEventsThatPileUp) {
  write_file(
      scratch("hopper.yaml"),
      "name: hopper\nlinks:\n"
      "  - {name: sx, father: ground, joint: {name: px, type: prismatic, axis: [1, 0, 0]}}\n"
      "  - {name: sz, father: sx, joint: {name: pz, type: prismatic, axis: [0, 0, 1]}}\n"
      "  - {name: body, father: sz, joint: {name: ry, type: revolute, axis: [0, 1, 0]}, mass: 2, "
      "com: [0.03, 0, 0.05], inertia: [0.02, 0, 0, 0.03, 0, 0.02]}\n"
      "  - {name: arm, father: body, joint: {name: ar, type: revolute, axis: [0, 1, 0], offset: "
      "[0.1, 0, 0.1]}, mass: 0.4, com: [0.1, 0, 0], inertia: [0, 0, 0, 0.001, 0, 0.001]}\n"
      "points: [{name: b, link: body, at: [0.25, 0, -0.12]}]\n");
  write_file(
      scratch("s.yaml"),
      "scene: s\nmodel: hopper.yaml\nduration: 2.5\neffects:\n  gravity: [0.2, 0, -9.8]\n"
      "  joint_spring:\n    - {joint: px, stiffness: 20}\n"
      "    - {joint: ry, stiffness: 60, damping: 0.4, rest: 0.25}\n"
      "    - {joint: ar, stiffness: 3, damping: 0.05}\n"
      "  drive: [{joint: ar, torque: 18*sin(9*t)}]\n"
      "  point_constraint: [{name: B, point: b, along: [[0.14943813247359922, 0, "
      "0.9887710779360422], [0.9887710779360422, 0, -0.14943813247359922]]}]\n"
      "phases:\n  - name: fly\n    active: []\n    until:\n"
      "      - {touch_down: {point: b, normal: [0.14943813247359922, 0, 0.9887710779360422], "
      "height: 0.02}, impact: {constraints: [B], restitution: 0.3, rest_below: 0.3}, then: fly}\n"
      "      - {lift_off: {constraint: B, normal: [0.14943813247359922, 0, 0.9887710779360422]}, "
      "then: fly}\n"
      "initial: {q: {pz: 0.35, ry: 0.25}}\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string(), "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("'lift_off of B' and 'touch_down of b' again and again"));
}

TEST_F(Simulate, GivesTheSameBytesTwice) {
  const Outcome first = treedyn({scene("compass_walk"), "--duration", "3"});
  const Outcome second = treedyn({scene("compass_walk"), "--duration", "3"});
  EXPECT_EQ(first.out, second.out);
}

/// Different roundings of the same dynamics, one second of smooth motion at a tolerance of 1e-10.
TEST_F(Simulate, ComputesTheSameByProgramEngineAndCompiledCode) {
  const auto last = [](const std::string& option) {
    std::vector<std::string> words = {scene("biped_flight"), "--duration", "0.3"};
    if (!option.empty()) {
      words.push_back(option);
    }
    const Outcome outcome = treedyn(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::vector<double> values;
    const auto rows = table(outcome.out);
    for (const std::string& cell : rows.back()) {
      values.push_back(std::strtod(cell.c_str(), nullptr));
    }
    return values;
  };
  const std::vector<double> program = last("");
  for (const std::string option : {"--engine", "--compiled"}) {
    const std::vector<double> other = last(option);
    ASSERT_EQ(other.size(), program.size());
    for (std::size_t k = 0; k < program.size(); ++k) {
      EXPECT_NEAR(other[k], program[k], 1e-7 * (1 + std::abs(program[k]))) << option << ' ' << k;
    }
  }
}

TEST_F(Simulate, ReadsTheCasesOfHardCases) {
  const Outcome outcome =
      treedyn({TREEDYN_SOURCE_DIR "/tests/data/hard_cases/s12_simplest_walker.json", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const json data = json::parse(outcome.out);
  ASSERT_GE(data["events"].size(), 1U);
  EXPECT_NEAR(data["events"][0]["t"].get<double>(), 3.88194, 1e-5);
}

TEST_F(Simulate, TakesItsOptionsBeforeTheScene) {
  for (const std::string integrator :
       {"fehlberg78", "dopri5", "dopri5-fixed", "rk4", "semi-implicit-euler", "sdirk2"}) {
    const Outcome outcome = treedyn(
        {scene("pendulum"), "--integrator", integrator, "--step", "0.001", "--duration", "0.2"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NEAR(std::strtod(table(outcome.out).back()[2].c_str(), nullptr), 1.9219,
                1e-3);  // half a step of 9.81 sin(q) 0.2
  }
  const Outcome drifting =
      treedyn({scene("four_bar"), "--drift", "none", "--integrator", "semi-implicit-euler", "-q"});
  EXPECT_EQ(drifting.status, 0);
  EXPECT_GT(std::strtod(table(drifting.out).back().back().c_str(), nullptr), 1e-5);
}

TEST_F(Simulate, AnswersWrongUsageWith2AndWrongScenesWith1) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {},
           {scene("pendulum"), "--integrator", "euler"},
           {scene("pendulum"), "--step", "-1"},
           {scene("pendulum"), "--tolerance", "small"},
           {scene("pendulum"), "--drift", "some"},
           {scene("pendulum"), "--report"},
           {scene("pendulum"), "--engine", "--compiled"},
           {scene("pendulum"), "--as-generated", "--compiled"},
           {scene("pendulum"), "--as-generated", "--integrator", "rk4", "--tolerance", "1e-3"},
           {scene("pendulum"), "--speed", "3"}}) {
    const Outcome outcome = treedyn(words);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  const Outcome missing = treedyn({"nowhere.yaml"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(missing.err,
            "nowhere.yaml: cannot be read (No such file or directory); expected a file\n");
  write_file(scratch("s.yaml"), "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                                "/models/two_link.yaml\nduration: 1\n"
                                "stepping: {integrator: euler}\n");
  const Outcome euler = treedyn({scratch("s.yaml").string()});
  EXPECT_EQ(euler.status, 1);
  EXPECT_THAT(euler.err, HasSubstr("s.yaml:4:24: stepping: integrator 'euler' is unknown"));
  const Outcome fixed = treedyn({scene("pendulum"), "--integrator", "rk4", "--tolerance", "1e-3"});
  EXPECT_EQ(fixed.status, 1);
  EXPECT_EQ(fixed.err,
            "--tolerance: rk4 takes steps of one length; expected an adaptive integrator, or "
            "--step\n");
}

TEST_F(Simulate, WritesTheMotionUpToItsEndWhenItBreaks) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                                "/models/two_link.yaml\nduration: 2\neffects:\n  drive:\n"
                                "    - {joint: elbow, torque: 1/(1 - t)}\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string(), "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the motion ends at t = "));
  EXPECT_GT(table(read_file(file("s.csv"))).size(), 200U);
}

TEST_F(Simulate, EndsWhereEnergyComesOutOfNothing) {
  const Outcome outcome = treedyn({scene("drop"), "--integrator", "semi-implicit-euler", "--step",
                                   "0.002", "--json", "-o", out()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err,
              HasSubstr("drop.yaml: warning: a step of 0.002 s is beyond the stability "
                        "limit of semi-implicit-euler, 0.000421 s"));
  EXPECT_THAT(outcome.err, HasSubstr("a stable step is 0.00038 s"));
  EXPECT_THAT(outcome.err, HasSubstr("drop.yaml: warning: energy grows without power"));
  EXPECT_THAT(outcome.err, HasSubstr("the motion ends at t = 0.4"));
  const json data = json::parse(read_file(file("drop.json")));
  EXPECT_THAT(data["stopped"].get<std::string>(), HasSubstr("energy grows"));
  ASSERT_EQ(data["warnings"].size(), 2U);
  EXPECT_EQ(data["warnings"][0]["kind"], "step");
  EXPECT_EQ(data["warnings"][1]["kind"], "energy");
  EXPECT_TRUE(data["stable_steps"]["sdirk2"].is_null());
  EXPECT_GT(table(read_file(file("drop.csv"))).size(), 50U);  // up to there
}

/// 10 N, of which 6 push, hold 2 kg: 5e4/s at rest, where rk4 is stable up to 2.785/5e4 s. On the
/// way there friction is constant.
TEST_F(Simulate, WarnsOfStepsThatAreTooLongForTheRestAtTheEnd) {
  write_file(scratch("model.yaml"),
             "name: block\nlinks:\n  - name: block\n    father: ground\n    joint: {name: x, type: "
             "prismatic, axis: [1, 0, 0]}\n    mass: 2\n");
  const auto errors = [&](const std::string& step, const std::string& push) {
    write_file(
        scratch("s.yaml"),
        "scene: s\nmodel: model.yaml\nduration: 1\neffects:\n  coulomb_friction: [{joint: x, "
        "force: 10, slip_speed: 1e-4}]\n  drive: [{joint: x, torque: " +
            push + "}]\ninitial: {qd: {x: 1}}\nstepping: {integrator: rk4, step: " + step + "}\n");
    return treedyn({scratch("s.yaml").string(), "-o", out()}).err;
  };
  EXPECT_THAT(errors("1e-3", "6"),
              HasSubstr("warning: a step of 0.001 s is beyond the stability "
                        "limit of rk4, 5.57e-05 s at t = 1 s with joints at rest; a "
                        "stable step is 5e-05 s"));
  EXPECT_EQ(errors("5e-5", "6"), "");
  EXPECT_EQ(errors("1e-3", "11"), "");               // it does not come to rest
  EXPECT_EQ(errors("1e-3", "60*cos(6*t) - 1"), "");  // speeds of zero that are no rest
}

/// A ball in the air at the end touches nothing there, however stiff the floor is.
TEST_F(Simulate, DoesNotWarnOfContactsThatAreOpenAtTheEnd) {
  write_file(scratch("model.yaml"),
             "name: ball\nlinks:\n  - name: ball\n    father: ground\n    joint: {name: z, type: "
             "prismatic, axis: [0, 0, 1]}\n    mass: 1\npoints: [{name: foot, link: ball}]\n");
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: model.yaml\nduration: 1\neffects:\n  gravity: [0, 0, -9.81]\n"
             "  ground_contact: [{point: foot, stiffness: 1e8, exponent: 1.5}]\ninitial: {qd: {z: "
             "10}}\nstepping: {integrator: rk4, step: 0.001}\n");
  for (const char* const duration : {"1", "1.0194", "1.5"}) {
    EXPECT_EQ(treedyn({scratch("s.yaml").string(), "--duration", duration, "-o", out()}).err, "");
  }
}

/// 20 J are more than the 10 J of the fall: what they are judged by is named.
TEST_F(Simulate, SaysWhatEnergyIsJudgedBy) {
  const Outcome outcome = treedyn({scene("drop"), "--integrator", "rk4", "--step", "0.001",
                                   "--duration", "0.5", "--report", "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("by 20 J in all up to t = 0.453394 s, beside 917 J of its forces' "
                        "power in a hundred steps"));
  EXPECT_THAT(read_file(file("drop.html")),
              HasSubstr(" of what had been exchanged, or of a fall by the robot's size"));
}

TEST_F(Simulate, SaysWhatARunCostsAndHowWellItKeptItsPromises) {
  const Outcome outcome = treedyn({scene("four_bar"), "--json", "-v", "-o", out()});
  EXPECT_EQ(outcome.status, 0);
  for (const char* const text :
       {"steps rejected", "evaluations of", "energy that no force explains",
        "rk4 is stable up to steps of", "of computing for a second"}) {
    EXPECT_THAT(outcome.err, HasSubstr(text));
  }
  const json data = json::parse(read_file(file("four_bar.json")));
  EXPECT_GT(data["cost"]["evaluations"].get<long>(), 13 * data["steps"].get<long>());
  EXPECT_GT(data["cost"]["operations_of_terms"].get<long>(), 10);
  EXPECT_GT(data["cost"]["seconds_for_a_second"].get<double>(), 0);
  EXPECT_LT(data["kept"]["unexplained_energy_part"].get<double>(), 1e-9);
  EXPECT_LT(data["kept"]["largest_drift"].get<double>(), 1e-13);
}

/// A ball over the ground: mass, weight, Jacobian are constants, only the contact computes.
TEST_F(Simulate, SaysWhatOperationsAreOf) {
  const auto said = [](const std::string& option) {
    return treedyn({scene("drop"), "--integrator", "rk4", "--step", "0.001", "--duration", "0.01",
                    "-v", option})
        .err;
  };
  EXPECT_THAT(said("--json"), HasSubstr(" evaluations of the dynamics; what they take of the tree "
                                        "(A, B + G, points) is constant\n"));
  EXPECT_THAT(said("--engine"), HasSubstr(" evaluations of the dynamics\n"));
}

TEST_F(Simulate, TabulatesForcesAndPoints) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                                "/models/scenes/drop.model.yaml\nduration: 1\neffects:\n"
                                "  drive:\n    - {joint: height, torque: -3}\n"
                                "  joint_spring:\n    - {joint: height, stiffness: 2, rest: 1}\n"
                                "  ground_contact:\n    - {point: ball, stiffness: 1000}\n"
                                "initial: {q: {height: -0.001}}\n");
  const auto rows = table(treedyn({scratch("s.yaml").string()}).out);
  const std::vector<std::string> forces(rows[0].begin() + 4, rows[0].begin() + 12);
  EXPECT_EQ(forces,
            (std::vector<std::string>{"drive[height]", "spring[height]", "F[ball.x]", "F[ball.y]",
                                      "F[ball.z]", "p[ball.x]", "p[ball.y]", "p[ball.z]"}));
  const auto value = [&](std::size_t k) {
    return std::strtod(rows[1][k].c_str(), nullptr);
  };
  EXPECT_EQ(value(4), -3);
  EXPECT_NEAR(value(5), 2 * 1.001, 1e-15);
  EXPECT_NEAR(value(8), 1, 1e-15);  // 1000 N/m, 1 mm
  EXPECT_EQ(value(11), -0.001);
}

TEST_F(Simulate, EndsConstraintsThatPartWhereTheUserSays) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " TREEDYN_SOURCE_DIR
             "/models/scenes/drop.model.yaml\nduration: 2\neffects:\n"
             "  locked_joint:\n    - {name: led, joint: height, at: t^3}\n"
             "  point_constraint:\n    - {name: held, point: ball, along: [z]}\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("warning: constraint 'held.z' acts and is"));
  const Outcome early = treedyn({scratch("s.yaml").string(), "--drift-limit", "1e-5"});
  EXPECT_EQ(early.status, 1);
  EXPECT_LT(table(early.out).size(), table(outcome.out).size());
}

TEST_F(Simulate, RefusesAMotionOfMoreStepsThanTheUserWants) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                                "/models/scenes/drop.model.yaml\nduration: 1\neffects:\n"
                                "  drive: [{joint: height, kp: 1e20, kd: 0, target: 1}]\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("steps hardly advance time: 1000 of them"));
  EXPECT_THAT(outcome.err, HasSubstr("--max-steps"));
  const std::string stiff = scratch("s.yaml").string();
  EXPECT_EQ(treedyn({stiff, "--duration", "1e-6", "-q"}).status, 0);
  EXPECT_EQ(treedyn({stiff, "--duration", "1e-6", "--max-steps", "1500"}).status, 1);
  const Outcome few = treedyn({TREEDYN_SOURCE_DIR "/models/scenes/drop.yaml", "--max-steps", "30"});
  EXPECT_EQ(few.status, 1);
  EXPECT_THAT(few.err, HasSubstr("30 steps are made (--max-steps)"));
}

TEST_F(Simulate, RefusesStepsThatNeverArrive) {
  const std::string pendulum = scene("pendulum");
  for (const char* const step : {"1e-10", "1e-20", "1e-300"}) {
    for (const char* const how : {"-q", "--as-generated"}) {
      const Outcome outcome = treedyn({pendulum, "--integrator", "rk4", "--step", step, how});
      EXPECT_EQ(outcome.status, 1) << step;
      EXPECT_THAT(outcome.err, HasSubstr("more than 1e+07 steps of")) << outcome.err;
    }
  }
  EXPECT_EQ(treedyn({pendulum, "--integrator", "rk4", "--step", "1e-5", "--duration", "1e-3",
                     "--max-steps", "99"})
                .status,
            1);
}

TEST_F(Simulate, RefusesTimesThatDoNotAdvance) {
  const std::string file = scratch("s.yaml").string();
  const auto begins_at = [&](const std::string& t) {
    write_file(file, "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                     "/models/two_link.yaml\nduration: 0.1\neffects:\n"
                     "  gravity: [0, 0, -9.81]\ninitial: {t: " +
                         t + "}\n");
  };
  begins_at("1e18");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {file}, {file, "--integrator", "rk4", "--step", "0.01"}, {file, "--as-generated"}}) {
    const Outcome outcome = treedyn(words);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err,
                HasSubstr("s.yaml: a duration of 0.1 s does not advance time at t = 1e+18 s; "
                          "expected more than 3.6e+03 s"));
  }
  begins_at("1e13");
  const Outcome fixed = treedyn({file, "--integrator", "rk4", "--step", "0.01"});
  EXPECT_EQ(fixed.status, 1);
  EXPECT_THAT(fixed.err, HasSubstr("a step of 0.01 s does not advance time at t = 1e+13 s"));
  begins_at("1e14");
  EXPECT_THAT(treedyn({file, "--duration", "1"}).err,
              HasSubstr("no step that advances time meets the tolerance of 1e-10 at t = "));
  begins_at("1e9");  // numbers are 1.2e-7 apart
  EXPECT_EQ(treedyn({file}).status, 0);
}

TEST_F(Simulate, RefusesATableOfMoreRowsThanItMayHave) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                                "/models/scenes/drop.model.yaml\nduration: 0.5\n"
                                "stepping: {output_step: 1e-12}\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("0.5 s are more than 1e+06 rows of 1e-12 s; expected an "
                                     "output_step of 5e-07 s or more"));
}

TEST_F(Simulate, LandsWithoutAWordWhereAnImpactTakesAllSpeed) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " TREEDYN_SOURCE_DIR
             "/models/two_link.yaml\nduration: 1\ninitial: {q: {shoulder: 0.3, elbow: 0.5}}\n"
             "effects:\n  gravity: [0, 0, -9.81]\n"
             "  point_constraint: [{name: floor, point: tip, along: [x, z]}]\n"
             "phases:\n  - name: flight\n    active: []\n"
             "    until: [{touch_down: {point: tip, height: -0.5}, "
             "impact: {constraints: [floor]}, then: stand}]\n"
             "  - {name: stand, active: [floor]}\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
}

/// Exit code of a simulation that gets SIGINT, which is ignored or not where it starts.
int interrupted(const std::string& name, const std::string& duration, const std::string& folder,
                std::chrono::milliseconds after, void (*at_start)(int)) {
  const std::string scene_file = scene(name);
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGINT, at_start);
    ::execl(TREEDYN_EXECUTABLE, TREEDYN_EXECUTABLE, "simulate", scene_file.c_str(), "--duration",
            duration.c_str(), "--json", "-q", "-o", folder.c_str(), nullptr);
    ::_exit(127);
  }
  std::this_thread::sleep_for(after);
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

TEST_F(Simulate, LeavesAValidFileWhenItIsInterrupted) {
  EXPECT_EQ(interrupted("biped_stepping", "1000", out(), std::chrono::seconds(3), SIG_DFL), 1);
  const json data = json::parse(read_file(file("biped_stepping.json")));
  EXPECT_EQ(data["stopped"], "interrupted");
  EXPECT_EQ(table(read_file(file("biped_stepping.csv"))).size(), data["rows"].size() + 1);
}

/// As a script's command with `&` has it.
TEST_F(Simulate, GoesOnWhereInterruptsAreIgnored) {
  EXPECT_EQ(interrupted("biped_stepping", "0.5", out(), std::chrono::milliseconds(300), SIG_IGN),
            0);
}

TEST_F(Simulate, QuotesHostileNames) {
  write_file(
      scratch("m.yaml"),
      "name: m\nlinks:\n  - name: a\n    father: ground\n    joint: {name: \"j,\\\"</script>\","
      " type: revolute, axis: [0, 1, 0]}\n    mass: 1\n    com: [0, 0, -1]\n");
  write_file(scratch("s.yaml"), "scene: \"<b>\"\nmodel: m.yaml\nduration: 1\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string(), "-o", out(), "--report", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read_file(file("n_b_.csv")), HasSubstr("t,phase,\"q[j,\"\"</script>]\""));
  EXPECT_TRUE(json::accept(read_file(file("n_b_.json"))));
  const std::string page = read_file(file("n_b_.html"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
  EXPECT_THAT(page, Not(HasSubstr("j,\\\"</script>")));
}

/// The page as the browser leaves it, and what it logged. Every name is refused: no network.
Outcome browse(const fs::path& page, const fs::path& profile) {
  return support::run({TREEDYN_CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu",
                       "--user-data-dir=" + profile.string(), "--virtual-time-budget=30000",
                       "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr",
                       "--dump-dom", "file://" + page.string()});
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++result;
  }
  return result;
}

TEST_F(Simulate, MakesAPageThatPlaysInABrowserWithoutNetwork) {
  ASSERT_EQ(treedyn({scene("compass_walk"), "-o", out(), "--report"}).status, 0);
  const std::string page = read_file(file("compass_walk.html"));
  EXPECT_EQ(count(page, "http"), 1U);  // the name space of SVG, which is never fetched
  EXPECT_EQ(count(page, "src="), 0U);
  EXPECT_EQ(count(page, "@import") + count(page, "url("), 0U);
  // frames by timers: the browser's virtual time does not wait for frames that are painted
  const std::string watcher =
      "<script>window.requestAnimationFrame = f => setTimeout(f, 16);"
      "window.cancelAnimationFrame = clearTimeout;"
      "document.getElementById('speed').value = '4';"
      "document.getElementById('play').click();"
      "const look = () => { const at = +document.getElementById('time').value;"
      " if (at > 20) { document.title = 'played to ' + at; } else { setTimeout(look, 50); } };"
      "look();</script>";
  write_file(scratch("watched.html"), page + watcher);
  const Outcome outcome = browse(scratch("watched.html"), scratch("profile"));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(count(outcome.err, "CONSOLE"), 0U) << outcome.err;
  // positions and speeds of angles and lengths, reactions, points, energy, drift, phase
  EXPECT_EQ(count(outcome.out, "<svg"), 9U);
  for (const char* const text : {"fehlberg78", "1e-10", "touch_down of right_foot ends left",
                                 "m/s^2", "point_constraint", "treedyn "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
  EXPECT_EQ(count(outcome.out, ">left</text>") + count(outcome.out, ">right</text>"),
            2U);  // phases
  EXPECT_THAT(outcome.out, HasSubstr(">warning above "));
  EXPECT_GE(count(outcome.out, "<path"), 17U);
  const std::size_t title = outcome.out.find("played to ");
  ASSERT_NE(title, std::string::npos);
  EXPECT_GT(std::atoi(outcome.out.c_str() + title + 10), 20);
}

/// What a page shows.
json data_of(const std::string& page) {
  const std::string begin = "id=\"data\">";
  const std::size_t at = page.find(begin) + begin.size();
  return json::parse(page.substr(at, page.find("</script>", at) - at));
}

/// The ball touches the ground for 5 ms at a time; rows of the table are 8 ms apart.
TEST_F(Simulate, ShowsContactsThatAreShorterThanRows) {
  ASSERT_EQ(treedyn({scene("drop"), "--integrator", "rk4", "--step", "0.0002", "--duration", "2.5",
                     "--report", "-o", out(), "-q"})
                .status,
            0);
  const json data = data_of(read_file(file("drop.html")));
  const std::vector<std::string> columns = data["columns"];
  const auto force = static_cast<std::size_t>(
      std::find(columns.begin(), columns.end(), "F[ball.z]") - columns.begin());
  const auto speed = static_cast<std::size_t>(
      std::find(columns.begin(), columns.end(), "qd[height]") - columns.begin());
  ASSERT_LT(force, columns.size());
  int bounces = 0;
  double before = 0;
  double pushed = 0;
  for (const json& row : data["rows"]) {
    const double now = row[2][speed];
    pushed = std::max(pushed, row[2][force].get<double>());
    if (before < 0 && now > 0) {
      ++bounces;
      EXPECT_GT(pushed, 9.81) << row[0];  // 1 kg that turns round
    }
    pushed = now > 0 ? 0 : pushed;
    before = now;
  }
  EXPECT_GT(bounces, 1);
}

/// Each has columns, and arrows, of its own.
TEST_F(Simulate, ShowsEveryContactOfOnePoint) {
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: " TREEDYN_SOURCE_DIR
             "/models/scenes/drop.model.yaml\neffects:\n  ground_contact:\n"
             "    - {point: ball, stiffness: 1e3}\n"
             "    - {point: ball, stiffness: 1e3, normal: [0, 0, -1], height: -2}\n"
             "initial: {q: {height: 1}}\nduration: 0.1\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string(), "--report", "-o", out(), "-q"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json data = data_of(read_file(file("s.html")));
  const std::vector<std::string> columns = data["columns"];
  ASSERT_EQ(data["forces"].size(), 2U);
  for (std::size_t contact = 0; contact < 2; ++contact) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = data["forces"][contact]["columns"][axis];
      EXPECT_EQ(columns.at(at),
                std::string("F[ball.") + "xyz"[axis] + "]" + (contact == 1 ? "#2" : ""));
    }
  }
}

/// The third joint of the model is the second that moves by itself.
TEST_F(Simulate, NamesTheJointThatSticksBehindAMimic) {
  std::string text = R"(<robot name="m"><link name="base"/>)";
  std::string father = "base";
  for (const auto& [name, more] :
       {std::pair("a", ""), {"b", R"(<mimic joint="a" multiplier="2"/>)"}, {"c", ""}}) {
    text += R"(<link name="l)" + std::string(name) +
            R"("><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" )"
            R"(izz="1"/></inertial></link><joint name=")" +
            name + R"(" type="continuous"><parent link=")" + father + R"("/><child link="l)" +
            name + R"("/><axis xyz="0 1 0"/>)" + more + "</joint>";
    father = "l" + std::string(name);
  }
  write_file(scratch("m.urdf"), text + "</robot>");
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: m.urdf\neffects: {coulomb_friction: [{joint: c, force: 1}]}\n"
             "stepping: {integrator: dopri5}\nduration: 1\n");
  const Outcome outcome = treedyn({scratch("s.yaml").string(), "--as-generated"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("coulomb friction of joint 'c' sticks"));
}

/// Nine series, of which a plot holds eight.
TEST_F(Simulate, KeepsComponentsOfAPointTogether) {
  write_file(scratch("m.yaml"),
             "name: m\nlinks:\n  - name: a\n    father: ground\n    joint: {name: j, type: "
             "revolute, axis: [0, 1, 0]}\n    mass: 1\n    com: [0, 0, -1]\npoints:\n"
             "  - {name: b, link: a}\n  - {name: c, link: a, at: [0, 0, -1]}\n"
             "  - {name: d, link: a, at: [1, 0, -1]}\n");
  write_file(scratch("s.yaml"),
             "scene: s\nmodel: m.yaml\nduration: 0.1\neffects:\n  force:\n"
             "    - {point: b, value: [1, 0, 0]}\n    - {point: c, value: [0, 1, 0]}\n"
             "    - {point: d, value: [0, 0, 1]}\n");
  const Outcome made = treedyn({scratch("s.yaml").string(), "-o", out(), "--report"});
  ASSERT_EQ(made.status, 0) << made.err;
  const Outcome outcome = browse(file("s.html"), scratch("profile"));
  const std::size_t second = outcome.out.find("Points (2 of 2)");
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(outcome.out.rfind("p[c.z]</label>"), second);
  EXPECT_GT(outcome.out.find("p[d.x]</label>"), second);
}

TEST_F(Simulate, IsListedWithItsEffectsAndIntegrators) {
  const Outcome effects = support::run({TREEDYN_EXECUTABLE, "list", "effects"});
  EXPECT_EQ(effects.status, 0);
  EXPECT_EQ(std::count(effects.out.begin(), effects.out.end(), '\n'), 18);
  const Outcome integrators = support::run({TREEDYN_EXECUTABLE, "list", "integrators"});
  EXPECT_THAT(integrators.out, HasSubstr("sdirk2"));
}

}  // namespace
}  // namespace treedyn
