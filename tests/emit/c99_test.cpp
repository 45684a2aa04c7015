// NAME.h and NAME.c: clean C99, and the bits of NAME.hpp and NAME.cpp.
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/driver.hpp"
#include "support/manifest.hpp"
#include "support/process.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;
using support::Manifest;
using support::Outcome;

const std::string kWarnings =
    "-pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion "
    "-Wfloat-conversion -Wcast-qual -Wundef -Wunused -Wformat=2 -ffp-contract=off -O1";

Outcome treedyn(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {TREEDYN_EXECUTABLE, "generate"});
  arguments.insert(arguments.end(), {"-q", "--effort", "0"});
  return support::run(arguments);
}

/// Runs the compiler; C99 and C by `-x c`.
void compile(const std::string& options) {
  const Outcome outcome = support::run_words(TREEDYN_CXX " " + options);
  ASSERT_EQ(outcome.status, 0) << options << '\n' << outcome.err;
}

const support::Program kC = {"#include \"m.h\"", "p_", "c_"};
const support::Program kCpp = {"#include \"m.hpp\"", "space::", "cpp_"};

struct C99Case {
  const char* name;
  std::vector<std::string> options;
};

class C99 : public testing::TestWithParam<C99Case> {};

TEST_P(C99, HasTheBitsOfTheCppFunctions) {
  const support::TemporaryFolder folder;
  const std::string at = folder.path().string() + '/';
  std::vector<std::string> options = GetParam().options;
  options.front() = fs::path(TREEDYN_SOURCE_DIR) / "models" / options.front();
  if (options.front().find("/scenes/") != std::string::npos) {
    options.insert(options.begin(), "--scene");
  }
  options.insert(options.end(), {"--name", "m", "-o", folder.path()});
  const auto generate = [&](std::vector<std::string> more) {
    more.insert(more.begin(), options.begin(), options.end());
    const Outcome outcome = treedyn(more);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  };
  generate({"--namespace", "space", "--section", "PLACE"});
  generate({"--language", "c99", "--prefix", "p", "--section", "PLACE"});
  const Manifest manifest = support::read_manifest(folder.path() / "m.json");
  support::write_file(at + "driver.cpp", support::comparing_driver(manifest, kC, kCpp));
  compile(
      fmt::format("-x c -std=c99 {0} -DPLACE=__attribute__((cold)) -Wmissing-prototypes "
                  "-Wstrict-prototypes -c {1}m.c -o {1}c.o",
                  kWarnings, at));
  compile(fmt::format("-x c++ -std=c++11 {0} -fsyntax-only {1}m.h", kWarnings, at));
  compile(fmt::format("-x c++ -std=c++11 {0} -DPLACE= -fsyntax-only {1}m.c", kWarnings, at));
  compile(fmt::format("-std=c++11 {0} -DPLACE= -c {1}m.cpp -o {1}cpp.o", kWarnings, at));
  compile(fmt::format("-std=c++17 -O1 {0}driver.cpp {0}c.o {0}cpp.o -o {0}driver", at));
  const Outcome outcome = support::run({at + "driver"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, fmt::format("0 of {}", 100 * manifest.functions.size()));
}

INSTANTIATE_TEST_SUITE_P(
    Texts, C99,
    testing::Values(
        C99Case{"puma560", {"puma560.yaml", "--checked", "--self-test"}},
        C99Case{"biped", {"biped.yaml", "--base", "axes", "--scalar", "float", "--points", "all"}},
        C99Case{"libm", {"panda.yaml", "--scalar", "float", "--sincos", "libm"}},
        C99Case{"packed", {"quadruped.yaml", "--layout", "packed", "--trig", "late"}},
        C99Case{"rows",
                {"scenes/biped_double_support.yaml", "--functions", "constrained_dynamics"}},
        C99Case{"contacts", {"scenes/drop.yaml", "--scalar", "float"}},
        C99Case{"rk4",
                {"scenes/four_bar.yaml", "--functions", "step", "--integrator", "rk4", "--step",
                 "0.001", "--state", "compensated"}},
        C99Case{"events",
                {"scenes/compass_walk.yaml", "--functions", "step", "--integrator", "rk4", "--step",
                 "0.02"}},
        C99Case{"sdirk2",
                {"scenes/pendulum.yaml", "--functions", "step", "--integrator", "sdirk2", "--step",
                 "0.001", "--scalar", "float"}}),
    [](const testing::TestParamInfo<C99Case>& param) { return std::string(param.param.name); });

TEST(C99Refuses, WhatItHasNoWordsFor) {
  const support::TemporaryFolder folder;
  const std::string model = TREEDYN_SOURCE_DIR "/models/two_link.yaml";
  const auto status = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"-o", folder.path() / "out"});
    const Outcome outcome = treedyn(options);
    EXPECT_FALSE(fs::exists(folder.path() / "out"));
    EXPECT_FALSE(outcome.err.empty());
    return outcome.status;
  };
  EXPECT_EQ(status({model, "--language", "c99", "--lanes", "4"}), 2);
  EXPECT_EQ(status({model, "--language", "c99", "--share-limbs"}), 2);
  EXPECT_EQ(status({model, "--language", "c99", "--namespace", "x"}), 2);
  EXPECT_EQ(status({model, "--prefix", "x"}), 2);
  const std::string equations = folder.path() / "e.yaml";
  support::write_file(
      equations, "equations:\n  - {name: sine_cosine, value: T(ones) * m_d * J_v * qd, doc: x}\n");
  EXPECT_EQ(status({model, "--equations", equations, "--functions", "sine_cosine,mass_matrix",
                    "--language", "c99"}),
            1);
}

TEST(C99Names, AFileMayBeCalledLikeAListOfNames) {
  const support::TemporaryFolder folder;
  const std::string at = folder.path();
  for (const std::string name : {"joint", "point", "status"}) {
    ASSERT_EQ(treedyn({TREEDYN_SOURCE_DIR "/models/two_link.yaml", "--language", "c99", "--name",
                       name, "-o", at})
                  .status,
              0);
    compile(fmt::format("-x c -std=c99 {0} -c {1}/{2}.c -o {1}/o", kWarnings, at, name));
  }
}

/// Constants, tables of the self-test and parts of functions stand beside what the header names.
TEST(C99Names, OfTheSourceGiveWayToNamesOfTheHeader) {
  const support::TemporaryFolder folder;
  const std::string at = folder.path();
  const std::string link =
      "mass: 1.7, com: [0.17, 0, 0.1], inertia: [0.11, 0, 0, 0.12, 0, 0.13]}\n";
  const auto model = [&](const std::string& name, const std::string& joint,
                         const std::string& more) {
    return fmt::format(
        "name: arm\nlinks:\n  - {{name: {}, father: ground, joint: {{name: {}, type: revolute, "
        "axis: [0, 0, 1]}}, {}{}",
        name, joint, link, more);
  };
  const auto equation = [](const std::string& name) {
    return fmt::format("equations: [{{name: {}, value: A * qdd}}]\n", name);
  };
  struct Collision {
    std::string model;
    const char* prefix;
    std::vector<std::string> options;
    std::vector<std::string> lines;  ///< of the source
  };
  const Collision collisions[] = {
      {model("arm_joint", "I1", ""), "arm", {}, {"const double arm_joint_I1_ = 0.17913;"}},
      {model("arm_point", "j", "points: [{name: I1, link: arm_point, at: [0.3, 0, 0]}]\n"),
       "arm",
       {},
       {"const double arm_point_I1_ = 0.17913;"}},
      {model("arm", "j", equation("I1")),
       "arm",
       {},
       {"const double arm_I1_ = 0.17913;", "void arm_I1(", "const double arm_p1 = "}},
      {model("a", "j", equation("mass_matrix_A")),
       "known",
       {"--self-test"},
       {"const Scalar known_mass_matrix_A_[2]", "void known_mass_matrix_A(", "known_q[2]"}},
      {support::read_file(TREEDYN_SOURCE_DIR "/models/puma560.yaml") + equation("regressor_0"),
       "inverse_dynamics",
       {"--functions", "regressor_0,inverse_dynamics_regressor"},
       {"void inverse_dynamics_regressor_0_(", "void inverse_dynamics_regressor_0("}}};
  for (const Collision& collision : collisions) {
    support::write_file(at + "/model.yaml", collision.model);
    std::vector<std::string> options = {at + "/model.yaml", "--name", "m", "-o", at};
    options.insert(options.end(), {"--language", "c99", "--prefix", collision.prefix});
    options.insert(options.end(), collision.options.begin(), collision.options.end());
    const Outcome outcome = treedyn(options);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::string source = support::read_file(at + "/m.c");
    for (const std::string& line : collision.lines) {
      EXPECT_NE(source.find(line), std::string::npos) << line;
    }
    compile(fmt::format("-x c -std=c99 {0} -c {1}/m.c -o {1}/o", kWarnings, at));
  }
}

}  // namespace
}  // namespace treedyn
