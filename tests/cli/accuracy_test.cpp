// `treedyn accuracy` against the compiled step and an integration of the pendulum that shares no
// code with it.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "cli/cli.hpp"
#include "cli/pendulum_study.hpp"
#include "support/compiled.hpp"

namespace treedyn {
namespace {

using Json = nlohmann::json;

constexpr double kInterval = 0.2;  ///< between comparisons: 10 s / 50
constexpr int kTimes = 50;
/// 2 pi / 3 as float holds it, from where the study begins.
const double kBegin = static_cast<double>(2.0943951F);

/// The angle at the times of comparison, or after each `every` tenths of a millisecond: theta'' =
/// -9.81 sin(theta), by classical steps of 0.1 ms in long double, error 8e-14.
std::vector<double> exact(int every = 2000) {
  long double angle = kBegin;
  long double speed = 0;
  const long double h = 1e-4L;
  const auto slope = [](long double x) {
    return -9.81L * std::sin(x);
  };
  std::vector<double> result;
  for (int k = 1; k <= 2000 * kTimes; ++k) {
    const long double a1 = slope(angle);
    const long double v2 = speed + h / 2 * a1;
    const long double a2 = slope(angle + h / 2 * speed);
    const long double v3 = speed + h / 2 * a2;
    const long double a3 = slope(angle + h / 2 * v2);
    const long double v4 = speed + h * a3;
    const long double a4 = slope(angle + h * v3);
    angle += h / 6 * (speed + 2 * v2 + 2 * v3 + v4);
    speed += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (k % every == 0) {
      result.push_back(static_cast<double>(angle));
    }
  }
  return result;
}

/// What is largest at the times of comparison.
struct Errors {
  double angle = 0;   ///< rad
  double energy = 0;  ///< J; of 1 kg on 1 m at rest in the beginning
};

class Accuracy : public Cli {
 protected:
  void TearDown() override {
    ::unsetenv("CXX");  // NOLINT(concurrency-mt-unsafe): one thread
    Cli::TearDown();
  }

  /// From here on a mistake stands in all generated code that a study compiles.
  /// \param mistake    of sed
  /// \param spared     code with this in it has none
  void plant(const std::string& mistake, const std::string& spared = "nothing is spared") {
    const std::string compiler = scratch("planting_compiler");
    write_file(compiler, "#!/bin/sh\nfor a in \"$@\"; do\n  case $a in */generated.cpp) grep -q '" +
                             spared + "' \"$a\" || sed -i '" + mistake +
                             "' \"$a\";; esac\ndone\nexec c++ \"$@\"\n");
    std::filesystem::permissions(compiler, std::filesystem::perms::owner_all);
    ::setenv("CXX", compiler.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
  }

  /// From here on compiled code counts the calls of a function. \return the file with their number
  std::string plant_counter(const std::string& function) {
    const std::string file = scratch("counted");
    plant(R"(1i #include <cstdio>\nstatic long calls = 0;\nstatic struct Tell { ~Tell() { if )"
          R"((FILE* file = fopen(")" +
          file +
          R"(", "w")) { fprintf(file, "%ld", calls); fclose(file); } } } tell;
/^[a-z]* )" +
          function + R"((/,/noexcept {$/ s/noexcept {$/noexcept { ++calls;/)");
    return file;
  }

  /// The study of the scene's own initial state.
  Json study(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"accuracy", kPendulum, "--states", "1", "-o", out()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = treedyn(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(read_file(file("pendulum_accuracy.json")));
  }

  /// The errors of the step that `generate` writes, compiled and iterated here.
  Errors iterated(const Json& row) {
    const std::string scalar = row.at("scalar");
    const std::string kept = row.at("state");
    const std::string integrator = row.at("integrator");
    const std::string sincos = row.at("sincos");
    const double step = row.at("step");
    const std::string scene = scratch("scene.yaml");
    write_file(scene,
               "scene: pendulum\nmodel: " TREEDYN_SOURCE_DIR
               "/models/scenes/pendulum.model.yaml\neffects: {gravity: [0, 0, -9.81]}\nstepping: "
               "{integrator: " +
                   integrator + ", step: " + std::to_string(step) + ", state: " + kept +
                   "}\nduration: 10\n");
    const std::string folder = scratch(scalar + kept + integrator + sincos + std::to_string(step));
    support::generate(
        "", {"--scene", scene, "--functions", "step", "--scalar", scalar, "--sincos", sincos},
        folder);
    const support::CompiledModel model(folder, "generated");
    const std::vector<double> truth = exact();
    std::vector<double> state = {kBegin, 0, 0, 0};
    Errors largest;
    const int every = static_cast<int>(std::lround(kInterval / step));
    for (int k = 1; k <= every * kTimes; ++k) {
      support::CompiledModel::Inputs inputs = {{state[0]}, {state[1]}, {0}};
      if (kept == "compensated") {
        inputs.push_back({state[2], state[3]});
      }
      state = model.call("step", inputs);
      if (k % every == 0) {
        const auto at = static_cast<std::size_t>(k / every - 1);
        largest.angle = std::max(largest.angle, std::abs(state[0] - truth[at]));
        const double energy = state[1] * state[1] / 2 - 9.81 * std::cos(state[0]);
        largest.energy = std::max(largest.energy, std::abs(energy + 9.81 * std::cos(kBegin)));
      }
    }
    return largest;
  }
};

TEST_F(Accuracy, RowsAreThoseOfTheCompiledStep) {
  const Json result =
      study({"--integrators", "rk4,dopri5-fixed", "--steps", "0.1,0.005", "--sincos", "pair,libm"});
  // whatever steps are studied: rk4 of 0.1 ms is off by 8e-14, the reference takes 0.025 ms
  EXPECT_LT(result.at("reference_agreement").get<double>(), 2e-15);
  EXPECT_LT(result.at("check_difference").get<double>(), 1e-11);  // 1e-13 a step
  ASSERT_EQ(result.at("settings").size(), 24U);
  for (const Json& row : result.at("settings")) {
    const Errors largest = iterated(row);
    EXPECT_NEAR(row.at("errors").at(0).get<double>(), largest.angle, 2e-13) << row;
    // the same of 9.81 J a rad and 5.4 J a rad/s
    EXPECT_NEAR(row.at("energy_errors").at(0).get<double>(), largest.energy, 3e-12) << row;
  }
}

/// The first y up to 4 at which 1 + z + z^2/2 + z^3/6 + z^4/24 + z^5/120 + c z^6, z = i y, is
/// larger than 1 by a millionth; without the terms of order five and six that of rk4.
double stable_up_to(double fifth, double sixth) {
  for (double y = 0; y < 4; y += 1e-4) {
    const double y2 = y * y;
    const double real = 1 - y2 / 2 + y2 * y2 / 24 - sixth * y2 * y2 * y2;
    const double imaginary = y * (1 - y2 / 6 + fifth * y2 * y2);
    if (std::hypot(real, imaginary) > 1 + 1e-6) {
      return y;
    }
  }
  return 4;
}

/// At an angle below 90 degrees a small motion swings with sqrt(g cos(angle)), fastest where it is
/// lowest of the twenty times at which the study looks, every half second.
TEST_F(Accuracy, StatesTheStabilityLimitWhereTheMotionHasTheLeast) {
  const Json limits =
      study({"--integrators", "rk4,dopri5-fixed", "--steps", "0.1"}).at("stability_limits");
  double most = 0;
  for (const double angle : exact(5000)) {
    most = std::max(most, std::cos(angle));
  }
  const double rate = std::sqrt(kGravity * most);
  EXPECT_EQ(limits.size(), 2U);
  EXPECT_NEAR(limits.at("rk4").get<double>(), stable_up_to(0, 0) / rate, 5e-3);
  EXPECT_NEAR(limits.at("dopri5-fixed").get<double>(), stable_up_to(1.0 / 120, 1.0 / 600) / rate,
              5e-3);
}

/// Rows of the study that stands in models/scenes/studies, whatever else is studied with them.
TEST_F(Accuracy, TheCommittedStudyComesOutAgain) {
  const Outcome outcome =
      treedyn({"accuracy", kPendulum, "--integrators", "rk4", "--steps", "0.02", "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream again(read_file(file("pendulum_accuracy.csv")));
  std::map<std::vector<std::string>, std::vector<std::string>> committed;
  std::istringstream study(
      read_file(TREEDYN_SOURCE_DIR "/models/scenes/studies/pendulum_accuracy.csv"));
  for (std::string line; std::getline(study, line);) {
    const std::vector<std::string> row = fields(line);
    committed[{row.begin(), row.begin() + 4}] = row;
  }
  std::vector<std::string> names;
  int rows = 0;
  for (std::string line; std::getline(again, line); ++rows) {
    const std::vector<std::string> row = fields(line);
    const std::vector<std::string>& before = committed[{row.begin(), row.begin() + 4}];
    ASSERT_EQ(row.size(), before.size()) << line;
    names = rows == 0 ? row : names;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool is_error = names[k].find("error") != std::string::npos;
      if (rows > 0 && is_error && !row[k].empty()) {  // sines in long double are of the C library:
                                                      // the reference moves by 1e-15
        EXPECT_NEAR(std::stod(row[k]), std::stod(before[k]), 1e-13) << line;
      } else {
        EXPECT_EQ(row[k], before[k]) << line;
      }
    }
  }
  EXPECT_EQ(rows, 4);  // a head, float, compensated, double
}

/// In double. Of rk4 errors of h^4 and h^5 have opposite signs here and cancel near 10 ms.
TEST_F(Accuracy, OrdersAreThoseOfTheMethods) {
  const Json result = study({"--integrators", "semi-implicit-euler,rk4,dopri5-fixed", "--steps",
                             "0.02,0.01,0.004,0.002"});
  std::map<std::pair<std::string, double>, double> errors;
  for (const Json& row : result.at("settings")) {
    if (row.at("scalar") == "double") {
      errors[{row.at("integrator"), row.at("step")}] = row.at("errors").at(0);
    }
  }
  const auto order = [&](const std::string& integrator, double coarse, double fine) {
    return std::log(errors.at({integrator, coarse}) / errors.at({integrator, fine})) /
           std::log(coarse / fine);
  };
  EXPECT_NEAR(order("semi-implicit-euler", 0.02, 0.01), 1, 0.3);
  EXPECT_NEAR(order("rk4", 0.004, 0.002), 4, 0.3);
  EXPECT_NEAR(order("dopri5-fixed", 0.02, 0.01), 5, 0.3);
}

/// The order that a study prints of double.
double printed_order(const std::string& text, const std::string& integrator) {
  const std::string line = "order of double " + integrator + ": ";
  const std::size_t at = text.find(line);
  EXPECT_NE(at, std::string::npos) << text;
  return at == std::string::npos ? 0 : std::stod(text.substr(at + line.size()));
}

class Orders : public Accuracy {
 protected:
  /// Of two initial states, by each method.
  void expect_orders(const std::string& scene, const std::string& steps) {
    const Outcome outcome =
        treedyn({"accuracy", scene, "--states", "2", "--integrators", "rk4,dopri5-fixed", "--steps",
                 steps, "--on", "m4f", "-o", out()});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NEAR(printed_order(outcome.out, "rk4"), 4, 0.3);
    EXPECT_NEAR(printed_order(outcome.out, "dopri5-fixed"), 5, 0.3);
  }

  /// A hard case over two seconds: over its own time dissipation of h^5 outweighs the rest of rk4.
  void expect_orders_of_case(const std::string& name) {
    Json hard_case =
        Json::parse(read_file(TREEDYN_SOURCE_DIR "/tests/data/hard_cases/" + name + ".json"));
    hard_case["scene"]["duration"] = 2;
    write_file(scratch(name + ".json"), hard_case.dump());
    expect_orders(scratch(name + ".json"), "0.02,0.01,0.005,0.0025,0.001,0.0005");
  }
};

TEST_F(Orders, OfAPendulumNearItsTop) { expect_orders_of_case("s01_pendulum_period"); }

TEST_F(Orders, OfADoublePendulum) { expect_orders_of_case("s02_double_pendulum_10s"); }

/// The top of s05 in two gimbals without mass. \param Jyy  of its moments of inertia 0.01, Jyy,
/// 0.01
std::string top(const std::string& folder, const std::string& Jyy, int parts) {
  const std::string name = "top" + std::to_string(parts);
  write_file(folder + "/top.model.yaml",
             "name: top\nlinks:\n"
             "  - {name: g1, father: ground, joint: {name: j1, type: revolute, axis: [0, 1, 0]}}\n"
             "  - {name: g2, father: g1, joint: {name: j2, type: revolute, axis: [1, 0, 0]}}\n"
             "  - name: body\n    father: g2\n"
             "    joint: {name: j3, type: revolute, axis: [0, 0, 1]}\n"
             "    mass: 0.5\n    com: [0, 0, 0.2]\n    inertia: [0.01, 0, 0, " +
                 Jyy + ", 0, 0.01]\n");
  const std::string scene = folder + "/" + name + ".yaml";
  write_file(scene, "scene: " + name +
                        "\nmodel: top.model.yaml\neffects: {gravity: [0, 0, -9.81]}\ninitial: "
                        "{q: {j1: 0.7}, qd: {j2: -1.12895528035624, j3: 60}}\nstepping: {parts: " +
                        std::to_string(parts) + "}\nduration: 3.5\n");
  return scene;
}

/// Its spin passes no singular position and does not count.
TEST_F(Orders, OfARegularPrecession) {
  const Outcome made = treedyn({"generate", "--scene", top(scratch(""), "0.01", 64), "--functions",
                                "step", "--integrator", "rk4", "-o", scratch("made")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(read_file(scratch("made") + "/top64.cpp"), HasSubstr("joints[] = {0, 1};"));
  expect_orders(top(scratch(""), "0.01", 64), "0.025,0.0125,0.01,0.005,0.0025");
}

/// Calls of the dynamics that the compiled step made, counted by itself; the last step of a motion,
/// which only tells reactions, is not among those that are told.
TEST_F(Accuracy, EvaluationsAreThoseOfTheCompiledStep) {
  const std::string counted = plant_counter("constrained_dynamics");
  for (const auto& [scene, integrator, most] :
       {std::tuple(kPendulum, "sdirk2", 20),
        std::tuple(top(scratch(""), "0.0101", 64), "rk4", 250)}) {
    const Outcome run = treedyn({"simulate", scene, "--as-generated", "--integrator", integrator,
                                 "--step", "0.05", "-v", "-o", out()});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::size_t end = run.err.find(" evaluations of the dynamics");
    ASSERT_NE(end, std::string::npos) << run.err;
    const long told = std::stol(run.err.substr(run.err.rfind('\n', end)));
    const long calls = std::stol(read_file(counted));
    EXPECT_GT(told, 10 * most);
    EXPECT_GT(calls, told) << scene;
    EXPECT_LE(calls - told, most) << scene;
  }
}

/// A ball on the ground: five operations of its contact wherever it presses; 28 of a step in the
/// air.
TEST_F(Accuracy, ContactsCostWhereTheyPress) {
  const std::string counted = plant_counter("press");
  const Outcome run =
      treedyn({"simulate", TREEDYN_SOURCE_DIR "/models/scenes/drop.yaml", "--as-generated",
               "--integrator", "rk4", "--step", "0.0005", "--json", "-o", out()});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json result = Json::parse(read_file(file("drop.json")));
  const long calls = std::stol(read_file(counted));
  EXPECT_GT(calls, 100);
  EXPECT_NEAR(result.at("cost").at("operations").get<double>() - 8000 * 28,
              static_cast<double>(5 * calls), 5 * 4);  // the last step is not told
}

/// A step of 50 ms in which a joint turns by 60 rad/s is 60 parts of 0.05 rad.
TEST_F(Accuracy, PartsOfAStepCost) {
  std::map<int, double> operations;
  for (const int parts : {1, 64}) {
    const std::string scene = top(scratch(""), "0.0101", parts);
    const Outcome outcome = treedyn({"accuracy", scene, "--states", "1", "--integrators", "rk4",
                                     "--steps", "0.05", "-o", out()});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("steps are done in up to 6") != std::string::npos, parts == 64);
    const std::string stem = "top" + std::to_string(parts);
    const Json study = Json::parse(read_file(file(stem + "_accuracy.json")));
    operations[parts] = study.at("settings").at(2).at("operations");
    EXPECT_EQ(study.at("settings").at(2).at("scalar"), "double");
  }
  EXPECT_NEAR(operations[64] / operations[1], 60, 2);
}

/// Of settings that are chosen by eight initial states at least 19 of 20 motions from others keep
/// the target.
TEST_F(Accuracy, WhatIsChosenHoldsForStatesThatTheSearchHasNotSeen) {
  constexpr std::size_t kSeen = 8;
  const std::vector<std::string> options = {
      "accuracy",       kPendulum, "--integrators", "rk4", "--steps",
      "0.04,0.02,0.01", "--on",    "m4f",           "-o",  out()};
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), options.begin(), options.end());
    return treedyn(more);
  };
  ASSERT_EQ(run({"--states", "20"}).status, 0);
  const Json settings = Json::parse(read_file(file("pendulum_accuracy.json"))).at("settings");
  double held = 0;
  double all = 0;
  for (const char* const target : {"6e-5", "5e-5", "3e-5", "3e-6", "1e-6"}) {
    const Outcome outcome =
        run({"--states", std::to_string(kSeen), "--parts", scratch("parts"), "--target", target});
    for (const Json& row : outcome.status == 0 ? settings : Json::array()) {
      const std::string name =
          fmt::format(" on m4f: {}{} {} {},", row.at("scalar").get<std::string>(),
                      row.at("state") == "compensated" ? " compensated" : "",
                      row.at("integrator").get<std::string>(), row.at("step").get<double>());
      const auto errors = row.at("errors").get<std::vector<double>>();
      for (std::size_t k = kSeen; outcome.out.find(name) != std::string::npos && k < errors.size();
           ++k) {
        held += errors[k] <= std::stod(target) ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_GE(all, 3 * 12);
  EXPECT_GE(held, 0.95 * all);
}

/// (3) with a wrong sign: the speed of the first joint draws the second one in.
TEST_F(Accuracy, AWrongSignInEquation3IsRefuted) {
  plant("s/qd\\[0\\] \\* qd\\[0\\]/-qd[0] * qd[0]/");
  const Outcome outcome =
      treedyn({"accuracy", TREEDYN_SOURCE_DIR "/models/scenes/double_pendulum.yaml", "--states",
               "1", "--integrators", "rk4", "--steps", "0.02", "--target", "1e-2", "--on", "m4f"});
  EXPECT_THAT(outcome.out, HasSubstr(": one of them is wrong\n"));
  EXPECT_EQ(outcome.status, 1);
}

/// A wrong equation in the code of both references does not pass for the truth.
TEST_F(Accuracy, WrongCodeIsRefuted) {
  plant("s/ = -9\\.81/ = -9.82/");
  const Outcome outcome = treedyn({"accuracy", kPendulum, "--states", "1", "--integrators", "rk4",
                                   "--steps", "0.02", "--target", "1e-3", "--on", "m4f"});
  EXPECT_THAT(outcome.out, HasSubstr(": one of them is wrong\n"));
  EXPECT_THAT(outcome.out, HasSubstr("0.001 is out of reach"));
  EXPECT_EQ(outcome.status, 1);
}

/// The angle is a function of t sqrt(g), so an error of g turns it by t theta' / (2 g) as much.
TEST_F(Accuracy, AConstantOffByOneUlpOfFloatShows) {
  const std::vector<std::string> options = {"--integrators", "dopri5-fixed", "--steps", "0.01"};
  const auto error = [](const Json& result) {
    for (const Json& row : result.at("settings")) {
      if (row.at("scalar") == "double") {
        return row.at("errors").at(0).get<double>();
      }
    }
    return 0.0;
  };
  EXPECT_LT(error(study(options)), 1e-8);
  const float next = std::nextafter(static_cast<float>(kGravity), 10.0F);
  plant(fmt::format("s/ = -9\\.81;/ = -{:.17g};/", next));
  const std::vector<double> truth = exact();
  double expected = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const double speed = std::sqrt(2 * kGravity * (std::cos(truth[k]) - std::cos(kBegin)));
    const double time = kInterval * static_cast<double>(k + 1);
    const double off = static_cast<double>(next) - kGravity;
    expected = std::max(expected, time * speed / (2 * kGravity) * off);
  }
  EXPECT_NEAR(error(study(options)), expected, 1e-8);  // and what is of second order: 1e-11
}

/// An elastic ball falls 1 m; by mistake it bounces where the step of its impact ends, `late` s too
/// deep and too fast. After t s more it is 2 g late (t_impact - t) too low: of first order in the
/// step, where the impact in its place costs 3e-11.
TEST_F(Accuracy, AnEventThatWaitsForTheEndOfItsStepShows) {
  const std::string scene = scratch("bounce.yaml");
  write_file(scratch("ball.yaml"),
             "name: ball\nlinks:\n  - {name: ball, father: ground, mass: 1, joint: {name: height, "
             "type: prismatic, axis: [0, 0, 1]}}\npoints:\n  - {name: ball, link: ball}\n");
  write_file(scene,
             "scene: bounce\nmodel: ball.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
             "  point_constraint:\n    - {name: floor, point: ball, along: [z]}\n"
             "phases:\n  - name: flight\n    active: []\n    until:\n"
             "      - touch_down: {point: ball}\n"
             "        impact: {constraints: [floor], restitution: 1}\n        then: flight\n"
             "initial: {q: {height: 1}}\nduration: 1\n");
  const auto errors = [&] {
    const Outcome outcome = treedyn({"accuracy", scene, "--states", "1", "--integrators", "rk4",
                                     "--steps", "0.01,0.005", "-o", out()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Json study = Json::parse(read_file(file("bounce_accuracy.json")));
    std::map<std::pair<std::string, double>, double> result;
    for (const Json& row : study.at("settings")) {
      if (row.at("state") == "plain") {
        result[{row.at("scalar"), row.at("step")}] = row.at("errors").at(0);
      }
    }
    EXPECT_EQ(result.size(), 4U);
    return result;
  };
  for (const auto& [setting, error] : errors()) {
    EXPECT_LT(error, setting.first == "double" ? 1e-9 : 1e-5) << setting.first;
  }
  plant(
      "s/event = find_event(motion, from, to, last);/const Moment end = to; "
      "event = find_event(motion, from, to, last); if (event >= 0) { to = end; }/",
      "long double");
  const double impact = std::sqrt(2 / kGravity);  // 0.4515 s
  for (const auto& [setting, error] : errors()) {
    const double bounce = std::ceil(impact / setting.second) * setting.second;
    const double after = 0.46 - bounce;  // the first comparison behind it, every 0.02 s
    const double expected = 2 * kGravity * (bounce - impact) * (impact - after);
    EXPECT_NEAR(error, expected, setting.first == "double" ? 1e-9 : 1e-5) << setting.first;
  }
}

/// In one piece; by GNU parallel on two slots; and broken off, here by two parts that vanish.
TEST_F(Accuracy, IsMadeInPartsToTheSameBytes) {
  const auto study_into = [&](const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"accuracy",  kPendulum, "--states", "2",  "--steps",
                                          "0.02,0.01", "--on",    "m4f",      "-v", "--integrators",
                                          "rk4",       "-o",      folder};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return treedyn(arguments);
  };
  const std::string parts = scratch("parts");
  const std::string plan = scratch("plan.txt");
  const Outcome whole = study_into(scratch("whole"), {});
  ASSERT_EQ(whole.status, 0) << whole.err;
  const Outcome planned = study_into(scratch("joined"), {"--parts", parts, "--plan", plan});
  ASSERT_EQ(planned.status, 0) << planned.err;
  EXPECT_FALSE(std::filesystem::exists(scratch("joined")));

  const Outcome early = study_into(scratch("joined"), {"--gather", parts});
  EXPECT_EQ(early.status, 1);
  EXPECT_THAT(early.err, HasSubstr("setting 1, float rk4 0.02, is not there; expected all of 6"));
  const Outcome measured = support::run({"sh", "-c", "parallel -j 2 < '" + plan + "'"});
  ASSERT_EQ(measured.status, 0) << measured.err;
  const auto expect_same = [&](const Outcome& joined) {
    ASSERT_EQ(joined.status, 0) << joined.err;
    EXPECT_EQ(joined.out, whole.out);
    for (const char* const end : {"csv", "json", "html", "svg"}) {
      const std::string name = std::string("/pendulum_accuracy.") + end;
      EXPECT_EQ(read_file(scratch("joined") + name), read_file(scratch("whole") + name)) << end;
    }
  };
  expect_same(study_into(scratch("joined"), {"--gather", parts}));

  std::filesystem::remove(parts + "/setting_2.part");
  std::filesystem::remove(parts + "/setting_5.part");
  const Outcome resumed = study_into(scratch("joined"), {"--parts", parts});
  expect_same(resumed);
  EXPECT_THAT(resumed.err, HasSubstr("float rk4 0.01: "));
  EXPECT_THAT(resumed.err, Not(HasSubstr("float rk4 0.02: ")));
  EXPECT_THAT(resumed.err, Not(HasSubstr("reference")));

  const std::string second = read_file(parts + "/setting_2.part");
  for (const std::string& wrong : {read_file(parts + "/setting_1.part"), second + "0\n",
                                   second.substr(0, second.size() - 2)}) {
    write_file(parts + "/setting_2.part", wrong);
    const Outcome changed = study_into(scratch("joined"), {"--gather", parts});
    EXPECT_EQ(changed.status, 1);
    EXPECT_THAT(changed.err, HasSubstr("setting_2.part:2: is another part of the study, or was"));
  }
  for (const std::size_t size : {0U, 20U}) {  // of the first line not all
    write_file(parts + "/setting_2.part", second.substr(0, size));
    EXPECT_THAT(study_into(scratch("joined"), {"--gather", parts}).err,
                HasSubstr("setting_2.part:1: is damaged"));
  }
  write_file(parts + "/setting_2.part", second);

  const Outcome other = treedyn({"accuracy", kPendulum, "--states", "3", "--gather", parts});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("reference.part:1: is of another study"));
}

/// Ctrl-C when the first settings are measured, and the same command again.
TEST_F(Accuracy, GoesOnWhereCtrlCHasBrokenItOff) {
  const std::string into = scratch("out");
  const std::vector<std::string> study = {"accuracy",  kPendulum, "--states", "2",  "--steps",
                                          "0.02,0.01", "--on",    "m4f",      "-v", "--integrators",
                                          "rk4",       "-o",      into};
  std::vector<std::string> interrupted = {
      "bash",
      "-c",
      "trap '' INT; (trap - INT; exec \"${@:2}\") & "
      "until [ -f \"$1\" ] || ! kill -0 $!; do sleep 0.01; done; kill -INT $!; wait $!",
      "bash",
      into + "/pendulum_accuracy.parts/setting_1.part",
      TREEDYN_EXECUTABLE};
  interrupted.insert(interrupted.end(), study.begin(), study.end());
  const Outcome broken = support::run(interrupted);
  EXPECT_NE(broken.status, 0);
  EXPECT_FALSE(std::filesystem::exists(into + "/pendulum_accuracy.csv"));

  const Outcome resumed = treedyn(study);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_THAT(resumed.err, Not(HasSubstr("float rk4 0.02: ")));
  EXPECT_FALSE(std::filesystem::exists(into + "/pendulum_accuracy.parts"));
  const std::string csv = read_file(into + "/pendulum_accuracy.csv");
  ASSERT_EQ(treedyn(study).status, 0);
  EXPECT_EQ(read_file(into + "/pendulum_accuracy.csv"), csv);
}

TEST_F(Accuracy, SaysWhichTargetsAreOutOfReach) {
  const std::vector<std::string> arguments = {"accuracy",      kPendulum,    "--states", "4",
                                              "--steps",       "0.02,0.005", "--on",     "m4f",
                                              "--integrators", "rk4",        "--target"};
  const auto with = [&](const char* target) {
    std::vector<std::string> all = arguments;
    all.emplace_back(target);
    return treedyn(all);
  };
  const Outcome reached = with("1e-3");
  EXPECT_EQ(reached.status, 0) << reached.err;
  EXPECT_THAT(reached.out, HasSubstr("0.001 on m4f: float rk4 0.02"));
  const Outcome refused = with("1e-20");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.out, HasSubstr("1e-20 is out of reach: the smallest error is"));
  EXPECT_THAT(refused.out, HasSubstr("with double rk4 0.005"));
}

/// The refusal is that of the study: processors do not change it.
TEST_F(Accuracy, SaysOfEachProcessorOnce) {
  write_file(scratch("s.yaml"), "scene: s\nmodel: " TREEDYN_SOURCE_DIR
                                "/models/scenes/pendulum.model.yaml\neffects:\n"
                                "  gravity: [0, 0, -9.81]\nduration: 3.55\n");
  const Outcome refused =
      treedyn({"accuracy", scratch("s.yaml"), "--states", "1", "--integrators", "rk4", "--steps",
               "0.05", "--on", "m4f,m7,m4f", "--target", "1e-20"});
  const std::string& text = refused.out;
  EXPECT_THAT(text, StartsWith("s: 3.55 s, the scene's own initial state\n"));
  EXPECT_EQ(text.find("out of reach"), text.rfind("out of reach"));
  EXPECT_EQ(text.find("cheapest settings on m4f"), text.rfind("cheapest settings on m4f"));
}

/// Rounding of the state to float, some 1e-7 a step, adds up over 10 000 steps; kept, it does not.
TEST_F(Accuracy, ACompensatedStateLowersTheFloorOfFloat) {
  const Json result = study({"--integrators", "rk4", "--steps", "0.001"});
  std::map<std::string, double> errors;
  for (const Json& row : result.at("settings")) {
    errors[std::string(row.at("scalar")) + " " + std::string(row.at("state"))] =
        row.at("errors").at(0);
  }
  EXPECT_LT(errors.at("float compensated"), errors.at("float plain") / 10);
  EXPECT_LT(errors.at("double plain"), errors.at("float compensated"));
}

TEST_F(Accuracy, WritesSettingsThatGenerateTakes) {
  study({"--integrators", "rk4", "--steps", "0.02", "--on", "m4f", "--target", "1e-5"});
  const std::string settings = file("pendulum_accuracy_m4f.toml");
  EXPECT_EQ(read_file(settings),
            "scalar = \"float\"\nintegrator = \"rk4\"\nstep = 0.02\nstate = \"compensated\"\n"
            "sincos = \"pair\"\ncuts = 3\n"
            "layout = \"dense\"  # of A where it is asked for; step stores none\n");
  const Outcome made = treedyn({"generate", "--scene", kPendulum, "--functions", "step",
                                "--settings", settings, "-o", scratch("made")});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(read_file(scratch("made") + "/pendulum.cpp"), HasSubstr("constexpr float h = 0.02f"));
  const std::vector<std::string> generate = {
      "generate", "--scene", kPendulum, "--functions", "step", "-o", out(), "--settings", settings};
  std::vector<std::string> longer = generate;
  longer.insert(longer.end(), {"--step", "0.05"});
  EXPECT_EQ(treedyn(longer).status, 0);
  EXPECT_THAT(read_file(file("pendulum.cpp")), HasSubstr("constexpr float h = 0.05f"));
  for (const auto& [line, what] :
       {std::pair("stepp = 0.02", "--stepp is no option of generate that may stand here"),
        std::pair("help = true", "--help is no option of generate that may stand here"),
        std::pair("foo", "'foo' is not usable; expected a line like scalar = \"float\""),
        std::pair("[x]", "'[x]' is not usable"),
        std::pair("step = 0.03", "--step stands here twice; expected it once")}) {
    write_file(settings, "step = 0.02  # s\n" + std::string(line) + "\n");
    const Outcome refused = treedyn(generate);
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr(settings + ":2: settings: " + what));
  }
}

/// 2 kg that 4 N of friction hold, and others that slide at up to 1 m/s until they stop: of rk4 the
/// motion is a parabola, and its errors are those of the time at which it ends.
TEST_F(Accuracy, FollowsOtherStatesThatDoNotStick) {
  const std::string scene = scratch("rest.yaml");
  write_file(scratch("slider.yaml"),
             "name: slider\nlinks:\n  - {name: body, father: ground, joint: {name: x, type: "
             "prismatic, axis: [1, 0, 0]}, mass: 2}\n");
  write_file(scene,
             "scene: rest\nmodel: slider.yaml\neffects:\n  coulomb_friction: [{joint: x, force: "
             "4}]\nduration: 1\n");
  const Outcome outcome =
      treedyn({"accuracy", scene, "--steps", "0.01", "--states", "3", "--spread", "1",
               "--integrators", "rk4", "--target", "1e-4", "-o", scratch("out")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("one of them is wrong")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("error 0.00e+00")));
}

/// At 100 Hz a setting of 20 ms is none, though it would be the cheapest.
TEST_F(Accuracy, KeepsToThePeriodOfAController) {
  const std::vector<std::string> arguments = {"accuracy", kPendulum, "--states",      "1",
                                              "--on",     "m4f",     "--rate",        "100",
                                              "--target", "1e-4",    "--integrators", "rk4"};
  const auto with = [&](const char* steps) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--steps", steps});
    return treedyn(all);
  };
  const Outcome chosen = with("0.01,0.005");
  EXPECT_EQ(chosen.status, 0) << chosen.err;
  EXPECT_THAT(chosen.out, HasSubstr("0.0001 on m4f: float rk4 0.01"));
  EXPECT_THAT(chosen.out, HasSubstr(" in each period of 100 Hz\n"));
  expect_usage_error(with("0.02,0.01"), "step 0.02 s does not divide 0.01 s, the period of 100 Hz");
  expect_usage_error(treedyn({"accuracy", kPendulum, "--rate", "7"}),
                     "--rate 7: its period does not divide 0.2 s, the time between comparisons; "
                     "expected a multiple of 5 Hz");
  expect_usage_error(treedyn({"accuracy", kPendulum, "--rate", "1e5"}), "expected a lower rate");
}

TEST_F(Accuracy, AsksForThePlaceOfAPlanBeforeItComputes) {
  write_file(scratch("file"), "");
  const Outcome outcome = treedyn({"accuracy", kPendulum, "--parts", scratch("parts"), "--plan",
                                   scratch("file") + "/plan.txt"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, scratch("file") + ": cannot write: Not a directory\n");
  EXPECT_FALSE(fs::exists(scratch("parts")));
}

TEST_F(Accuracy, RefusesStepsThatDoNotDivideTheTimeOfAComparison) {
  expect_usage_error(treedyn({"accuracy", kPendulum, "--steps", "0.03"}),
                     "step 0.03 s does not divide 0.2 s");
}

}  // namespace
}  // namespace treedyn
