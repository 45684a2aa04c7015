// The errors of `treedyn accuracy` beside those of joints and energy, its choices and its limits,
// against closed forms and integrations that share no code with it.
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "cli/cli.hpp"
#include "cli/pendulum_study.hpp"

namespace treedyn {
namespace {

using Json = nlohmann::json;

class AccuracyErrors : public Cli {
 protected:
  /// The study of the scene's own initial state; "" if it fails.
  Json study(const std::string& scene, const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"accuracy",      scene, "--states", "1",
                                          "--integrators", "rk4", "-o",       out()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = treedyn(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string stem = scene.substr(scene.rfind('/') + 1);
    return Json::parse(read_file(file(stem.substr(0, stem.find('.')) + "_accuracy.json")));
  }

  /// The row in double of these words.
  static Json row(const Json& study, const std::map<std::string, std::string>& words) {
    for (const Json& candidate : study.at("settings")) {
      bool same = candidate.at("scalar") == "double";
      for (const auto& [key, word] : words) {
        same = same && candidate.at(key) == word;
      }
      if (same) {
        return candidate;
      }
    }
    ADD_FAILURE() << study.dump(1);
    return {};
  }

  static double value(const Json& row, const char* key) { return row.at(key).at(0); }

  /// A rod of 1 m that stands on its foot: at the hip mass 1 kg, moment of inertia 0.1 kg m^2.
  std::string rod(const std::string& more) {
    write_file(scratch("rod_model.yaml"),
               "name: rod\nlinks:\n"
               "  - {name: slide, father: ground, joint: {name: x, type: prismatic, axis: [1, 0, "
               "0]}}\n"
               "  - {name: lift, father: slide, joint: {name: z, type: prismatic, axis: [0, 0, "
               "1]}}\n"
               "  - name: rod\n    father: lift\n"
               "    joint: {name: turn, type: revolute, axis: [0, 1, 0]}\n"
               "    mass: 1\n    inertia: [0.1, 0, 0, 0.1, 0, 0.1]\n"
               "points:\n  - {name: foot, link: rod, at: [0, 0, -1]}\n");
    write_file(scratch("rod.yaml"),
               "scene: rod\nmodel: rod_model.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
               "  point_constraint:\n    - {point: foot, along: [x, z]}\n" +
                   more + "initial: {q: {turn: 0.3}}\nduration: 1\n");
    return scratch("rod.yaml");
  }

  /// An elastic ball that falls 1 m, and hits the floor once.
  std::string ball(const std::string& height = "1") {
    write_file(scratch("ball_model.yaml"),
               "name: ball\nlinks:\n  - {name: ball, father: ground, mass: 1, joint: {name: "
               "height, type: prismatic, axis: [0, 0, 1]}}\npoints:\n  - {name: ball, link: "
               "ball}\n");
    write_file(scratch("ball.yaml"),
               "scene: ball\nmodel: ball_model.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
               "  point_constraint:\n    - {name: floor, point: ball, along: [z]}\n"
               "phases:\n  - name: flight\n    active: []\n    until:\n"
               "      - touch_down: {point: ball}\n"
               "        impact: {constraints: [floor], restitution: 1}\n        then: flight\n"
               "initial: {q: {height: " +
                   height + "}}\nduration: 1\n");
    return scratch("ball.yaml");
  }
};

/// The rod in coordinates of its own: hip at (x, z), turned by a; its foot is (-sin a, -cos a)
/// beside the hip. J qdd = -J' qd - 2 alpha v - alpha^2 p with the errors v and p of the foot.
struct Rod {
  using State = std::array<double, 6>;  // x, z, a and their rates
  double alpha = 0;                     // 1/s

  static std::array<double, 4> errors(const State& s) {
    return {s[0] - std::sin(s[2]) + std::sin(0.3), s[1] - std::cos(s[2]) + std::cos(0.3),
            s[3] - std::cos(s[2]) * s[5], s[4] + std::sin(s[2]) * s[5]};
  }

  [[nodiscard]] State rate(const State& s) const {
    const double c = std::cos(s[2]);
    const double d = std::sin(s[2]);
    const double w = s[5];
    // J = [1 0 -c; 0 1 d], M = diag(1, 1, 0.1)
    const double k11 = 1 + c * c / 0.1;
    const double k12 = -c * d / 0.1;
    const double k22 = 1 + d * d / 0.1;
    const std::array<double, 4> off = errors(s);
    const double r1 = -d * w * w - 2 * alpha * off[2] - alpha * alpha * off[0];
    const double r2 = -c * w * w + kGravity - 2 * alpha * off[3] - alpha * alpha * off[1];
    const double determinant = k11 * k22 - k12 * k12;
    const double l1 = (r1 * k22 - k12 * r2) / determinant;
    const double l2 = (k11 * r2 - k12 * r1) / determinant;
    return {s[3], s[4], s[5], l1, l2 - kGravity, (-c * l1 + d * l2) / 0.1};
  }

  static State moved(const State& s, double h, const State& by) {
    State result = s;
    for (std::size_t k = 0; k < 6; ++k) {
      result[k] += h * by[k];
    }
    return result;
  }

  /// The largest errors of the foot's place and speed, of classical steps over 1 s.
  [[nodiscard]] std::array<double, 2> drift(double h) const {
    State s = {0, 0, 0.3, 0, 0, 0};
    std::array<double, 2> largest = {0, 0};
    for (int k = 0; k < static_cast<int>(std::lround(1 / h)); ++k) {
      const State a = rate(s);
      const State b = rate(moved(s, h / 2, a));
      const State c = rate(moved(s, h / 2, b));
      const State d = rate(moved(s, h, c));
      for (std::size_t i = 0; i < 6; ++i) {
        s[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
      }
      const std::array<double, 4> off = errors(s);
      largest[0] = std::max({largest[0], std::abs(off[0]), std::abs(off[1])});
      largest[1] = std::max({largest[1], std::abs(off[2]), std::abs(off[3])});
    }
    return largest;
  }
};

/// The rod's foot, which x and z hold, begins at rest; a speed of the joint alone leads it away.
TEST_F(AccuracyErrors, SayThatTheInitialStateWasMoved) {
  const std::vector<std::string> options = {"--integrators", "rk4", "--steps", "0.02",
                                            "--states",      "1",   "--on",    "host"};
  const auto run = [&](const std::string& scene) {
    std::vector<std::string> words = {"accuracy", scene};
    words.insert(words.end(), options.begin(), options.end());
    return treedyn(words);
  };
  EXPECT_THAT(run(rod("")).err, Not(HasSubstr("was moved")));
  const std::string scene = rod("");
  write_file(scene,
             std::regex_replace(read_file(scene), std::regex("0\\.3\\}"), "0.3}, qd: {turn: 1}"));
  const Outcome moved = run(scene);
  EXPECT_EQ(moved.status, 0) << moved.err;
  EXPECT_THAT(moved.err, HasSubstr("rod.yaml: warning: the initial state was moved by "));
}

/// Every step is looked at here: two between comparisons, the time of which is 20 ms.
TEST_F(AccuracyErrors, DriftIsThatOfTheMethod) {
  const Json result = study(rod(""), {"--steps", "0.01", "--stabilisation", "none,baumgarte",
                                      "--error", "drift", "--target", "1"});
  for (const auto& [word, alpha] : {std::pair("none", 0.0), std::pair("baumgarte", 20.0)}) {
    const Json one = row(result, {{"stabilisation", word}});
    const std::array<double, 2> expected = Rod{alpha}.drift(0.01);
    ASSERT_GT(expected[0], 1e-8);  // far above the rounding of double, 1e-15
    EXPECT_NEAR(value(one, "drifts"), expected[0], 1e-6 * expected[0]) << word;
    EXPECT_NEAR(value(one, "drift_speeds"), expected[1], 1e-6 * expected[1]) << word;
    EXPECT_FALSE(one.contains("drift_angles"));
    EXPECT_FALSE(one.contains("event_errors"));
  }
  EXPECT_THAT(read_file(file("rod_accuracy.html")), HasSubstr("targets: largest drift of a "
                                                              "constraint, m\n"));
  EXPECT_THAT(read_file(file("rod_accuracy.svg")), HasSubstr("largest drift of a constraint, m<"));
}

/// Feet are pinned where they land, 8 steps of 0.4 m away.
TEST_F(AccuracyErrors, DriftBeginsAnewWithEveryInitialState) {
  const std::string scene = TREEDYN_SOURCE_DIR "/tests/data/hard_cases/s12_simplest_walker.json";
  const Outcome outcome = treedyn({"accuracy", scene, "--states", "2", "--integrators", "rk4",
                                   "--steps", "0.05", "--error", "drift", "-o", out()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json one = row(Json::parse(read_file(file("s12_simplest_walker_accuracy.json"))), {});
  ASSERT_EQ(one.at("drifts").size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const double speed = one.at("drift_speeds").at(k);
    EXPECT_LT(one.at("drifts").at(k), 40 * speed) << "for 38.5 s";
  }
}

/// A joint led by sin t has the acceleration -sin t: classical steps add Simpson's sums of it.
TEST_F(AccuracyErrors, DriftOfAJointIsInRadians) {
  write_file(scratch("led.yaml"), "scene: led\nmodel: " TREEDYN_SOURCE_DIR
                                  "/models/scenes/pendulum.model.yaml\neffects:\n"
                                  "  locked_joint:\n    - {joint: pivot, at: sin(t)}\n"
                                  "initial: {qd: {pivot: 1}}\nduration: 1\n");
  const Json led = row(study(scratch("led.yaml"), {"--steps", "0.02"}), {});
  const double h = 0.02;
  double q = 0;
  double qd = 1;
  double angle = 0;
  double rate = 0;
  for (int k = 0; k < 50; ++k) {
    const double begin = -std::sin(k * h);
    const double half = -std::sin((k + 0.5) * h);
    const double end = -std::sin((k + 1) * h);
    q += h * qd + h * h / 6 * (begin + 2 * half);
    qd += h / 6 * (begin + 4 * half + end);
    angle = std::max(angle, std::abs(q - std::sin((k + 1) * h)));
    rate = std::max(rate, std::abs(qd - std::cos((k + 1) * h)));
  }
  EXPECT_NEAR(value(led, "drift_angles"), angle, 1e-14);
  EXPECT_NEAR(value(led, "drift_rates"), rate, 1e-14);
  EXPECT_GT(angle, 1e-11);
  EXPECT_FALSE(led.contains("drifts"));
}

/// The ball hits the floor at sqrt(2 / g). Without cuts that is taken where its step ends, without
/// gravity it never comes: off by the rest of the second. A floor that only strikes has no drift.
TEST_F(AccuracyErrors, TimesOfEventsAreThoseOfTheFall) {
  const Json result = study(ball(), {"--steps", "0.02,0.005", "--cuts", "0,3", "--without",
                                     "gravity", "--error", "events"});
  const double impact = std::sqrt(2 / kGravity);
  for (const Json& one : result.at("settings")) {
    if (one.at("scalar") != "double") {
      continue;
    }
    EXPECT_FALSE(one.contains("drifts"));
    EXPECT_FALSE(one.contains("drift_speeds"));
    const double h = one.at("step");
    const double expected = one.at("without") == "gravity" ? 1 - impact
                            : one.at("cuts") == "0"        ? std::ceil(impact / h) * h - impact
                                                           : 0;
    EXPECT_NEAR(value(one, "event_errors"), expected, 1e-9) << one;
  }
  EXPECT_EQ(result.at("settings").size(), 2U * 3 * 2 * 2);  // steps, scalars, cuts, gravity
}

/// A ball falls for 47 ms and hits the floor ten times more in a second of 50 steps: each event is
/// looked for by three or four shorter steps, and one goes on behind it.
TEST_F(AccuracyErrors, CyclesCountTheStepsThatLookForEvents) {
  const Json result =
      study(ball("0.011"), {"--steps", "0.02", "--cuts", "0,3", "--error", "events"});
  const double plain = row(result, {{"cuts", "0"}}).at("cycles_per_second_m4f");
  const double looking = row(result, {{"cuts", "3"}}).at("cycles_per_second_m4f");
  EXPECT_GT(looking, 1.3 * plain);
  EXPECT_LT(looking, 2.1 * plain);
}

/// A bob on a rod of 1 m, and a place on it three times as far: chords of the error of the angle.
TEST_F(AccuracyErrors, PointsMoveByTheAngle) {
  const auto points = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--steps", "0.04"};
    options.insert(options.end(), more.begin(), more.end());
    return row(study(kPendulum, options), {});
  };
  const Json bob = points({});
  const double chord = 2 * std::sin(value(bob, "errors") / 2);
  EXPECT_NEAR(value(bob, "point_errors"), chord, 1e-14);
  const Json far = points({"--points", "far=rod:0,0,-3"});
  EXPECT_NEAR(value(far, "point_errors"), 3 * chord, 1e-14);
}

/// Of the pendulum in float nothing is linked: flash is about that of the object file; the stack
/// lies between the largest frame and the sum of all.
TEST_F(AccuracyErrors, SizesAreThoseOfTheCompiler) {
  if (support::run({"sh", "-c", "command -v arm-none-eabi-g++"}).status != 0) {
    GTEST_SKIP() << "no arm-none-eabi-g++";
  }
  const Json result = study(kPendulum, {"--steps", "0.02", "--on", "m4f,m0plus", "--sizes"});
  const Json& plain = result.at("settings").at(0);
  ASSERT_EQ(plain.at("scalar"), "float");
  ASSERT_EQ(treedyn({"generate", "--scene", kPendulum, "--functions", "step", "--integrator", "rk4",
                     "--step", "0.02", "--scalar", "float", "-o", scratch("made")})
                .status,
            0);
  const std::string object = scratch("made") + "/pendulum.o";
  write_file(scratch("cmath"), "namespace std { inline float sqrt(float x); }\n");
  const Outcome compiled = support::run(
      {"arm-none-eabi-g++", "-mthumb", "-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16",
       "-std=c++17", "-Os", "-ffp-contract=off", "-fno-exceptions", "-fstack-usage",
       "-I" + scratch(""), "-c", scratch("made") + "/pendulum.cpp", "-o", object});
  ASSERT_EQ(compiled.status, 0) << compiled.err;
  std::istringstream sizes(support::run({"arm-none-eabi-size", object}).out);
  std::string head;
  std::getline(sizes, head);
  long flash = 0;
  sizes >> flash;
  EXPECT_NEAR(plain.at("flash_m4f").get<double>(), static_cast<double>(flash),
              8);  // functions begin at words
  long sum = 0;
  long largest = 0;
  std::istringstream frames(read_file(scratch("made") + "/pendulum.su"));
  for (std::string line; std::getline(frames, line);) {
    const long frame = std::stol(line.substr(line.find('\t') + 1));
    sum += frame;
    largest = std::max(largest, frame);
  }
  EXPECT_GT(plain.at("stack_m4f"), largest);
  EXPECT_LE(plain.at("stack_m4f"), sum);
  // sums and products are library code on a Cortex-M0+, which the object file does not have
  EXPECT_GT(plain.at("flash_m0plus"), 2000);
  EXPECT_GT(plain.at("stack_m0plus"), plain.at("stack_m4f"));
  std::istringstream table(read_file(file("pendulum_accuracy.csv")));
  std::getline(table, head);
  std::string first;
  std::getline(table, first);
  const std::vector<std::string> names = fields(head);
  const std::size_t at =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), "flash_m4f") - names.begin());
  ASSERT_LT(at, names.size());
  EXPECT_EQ(fields(first).at(at), plain.at("flash_m4f").dump());
}

/// What reaches 1e-6 in double on a Cortex-M4F takes the library's sums: not within 2000 bytes.
TEST_F(AccuracyErrors, LimitsDecideTheChoice) {
  const std::vector<std::string> common = {"accuracy",      kPendulum,      "--states", "1",
                                           "--integrators", "dopri5-fixed", "--steps",  "0.02",
                                           "--on",          "m4f",          "--target"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = common;
    all.insert(all.end(), more.begin(), more.end());
    return treedyn(all);
  };
  if (support::run({"sh", "-c", "command -v arm-none-eabi-g++"}).status != 0) {
    const Outcome refused = with({"1e-6", "--flash", "2000"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr("no arm-none-eabi-g++ on PATH"));
    GTEST_SKIP() << "no arm-none-eabi-g++";
  }
  const Outcome free = with({"2e-7", "--flash", "10k", "--stack", "2000"});
  EXPECT_EQ(free.status, 0) << free.out;
  EXPECT_THAT(free.out, HasSubstr("2e-07 on m4f within 10240 bytes of flash and 2000 bytes of "
                                  "stack: double dopri5-fixed 0.02"));
  EXPECT_THAT(free.out, HasSubstr(" bytes of flash, "));
  const Outcome little = with({"2e-7", "--flash", "2000"});
  EXPECT_EQ(little.status, 1);
  EXPECT_THAT(little.out, HasSubstr("2e-07 on m4f within 2000 bytes of flash is out of reach: the "
                                    "smallest error is"));
  EXPECT_THAT(little.out, HasSubstr("with float compensated dopri5-fixed 0.02"));
  const Outcome none = with({"1", "--stack", "8"});
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.out, HasSubstr("no setting keeps the limits"));
}

TEST_F(AccuracyErrors, RefusesWhatCannotBeJudged) {
  const auto with = [&](const std::string& scene, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"accuracy", scene, "--states", "1", "--steps", "0.02"};
    all.insert(all.end(), more.begin(), more.end());
    return treedyn(all);
  };
  expect_usage_error(with(kPendulum, {"--target", "1", "--flash", "1000"}),
                     "limits of processors with flash; expected --on with m0plus, m4f, m33 or m7");
  expect_usage_error(with(kPendulum, {"--on", "m4f", "--stack", "1000"}), "expected --target");
  expect_usage_error(with(kPendulum, {"--spread", "2"}), "--spread: 2 is no part; expected 1e-9");
  expect_usage_error(with(kPendulum, {"--on", "host", "--sizes"}), "no processor with flash");
  expect_usage_error(with(kPendulum, {"--error", "jerk"}), "jerk not in {joints,energy,drift,");
  expect_usage_error(with(kPendulum, {"--error", "events"}),
                     "the scene has no events; expected joints, energy, points");
  expect_usage_error(with(kPendulum, {"--cuts", "0,3"}),
                     "makes no difference in a step that looks for no event");
  expect_usage_error(with(kPendulum, {"--stabilisation", "none"}), "in a step without constraints");
  expect_usage_error(
      with(TREEDYN_SOURCE_DIR "/models/scenes/arm_circle.yaml", {"--stabilisation", "projection"}),
      "projection gives the step of none");
  expect_usage_error(
      with(kPendulum, {"--forward-dynamics", "factor"}),
      "makes no difference in a step whose equations both methods solve alike, as of a "
      "single joint; expected");
  expect_usage_error(
      with(TREEDYN_SOURCE_DIR "/models/scenes/arm_circle.yaml", {"--forward-dynamics", "factor"}),
      "makes no difference in a step with constraints; expected");
  expect_usage_error(with(kPendulum, {"--parts", scratch("parts"), "--part", "-1"}),
                     "--part -1: the study has 9 settings; expected 1 to 9");
  expect_usage_error(with(kPendulum, {"--sincos", "pair,pair"}),
                     "pair and pair give the same step");
  expect_usage_error(with(ball(), {"--sincos", "libm"}), "in a step that takes no sine");
  expect_usage_error(with(kPendulum, {"--without", "drive"}), "the scene has no drive");
  expect_usage_error(with(kPendulum, {"--without", "velocity_products"}),
                     "the step is the same without velocity_products");
  expect_usage_error(with(ball(), {"--without", "point_constraint"}), "decides which rows");
  EXPECT_EQ(with(kPendulum, {"--points", "nose=rood"}).status, 1);
  for (const std::string option : {"--target", "--steps", "--rate"}) {
    for (const std::string value : {"0", "-1"}) {
      expect_usage_error(with(kPendulum, {option, value}),
                         option + ": " + value + " is not above 0; expected a number above 0");
    }
    for (const std::string value : {"abc", "nan", "inf"}) {
      expect_usage_error(with(kPendulum, {option, value}), "'" + value + "' is not a number");
    }
  }
  for (const std::string value : {"0", "64kb", "1.5", "nan", "-2k"}) {
    expect_usage_error(with(kPendulum, {"--target", "1", "--flash", value}),
                       "--flash: '" + value + "' is no number of bytes above 0");
  }
  expect_usage_error(treedyn({"accuracy", kPendulum, "--steps", "1e-9"}),
                     "--steps 1e-09: 10 s need more than 400000 steps; expected longer ones");
  const Outcome no_compiler =
      support::run({"env", "PATH=/nowhere", TREEDYN_EXECUTABLE, "accuracy", kPendulum, "--on",
                    "m4f", "--target", "1", "--flash", "1000"});
  EXPECT_EQ(no_compiler.status, 1);
  EXPECT_THAT(no_compiler.err, HasSubstr("no arm-none-eabi-g++ on PATH"));
}

}  // namespace
}  // namespace treedyn
