// NAME_checked: the bits of NAME, and a status that tells where they mean nothing.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/compiled.hpp"
#include "support/process.hpp"
#include "support/states.hpp"

namespace treedyn {
namespace {

namespace fs = std::filesystem;
using support::CompiledModel;
using support::FunctionInfo;
using support::Measurement;
using support::Sample;
using testing::HasSubstr;

constexpr int kRankLost = 1;
constexpr int kNotANumber = 16;
const std::string kFunctions =
    "forward_dynamics,mass_matrix_factor,mass_matrix_solve,mass_matrix_inverse";

/// The bits of doubles.
std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> result(values.size());
  std::memcpy(result.data(), values.data(), values.size() * sizeof(double));
  return result;
}

std::vector<const FunctionInfo*> siblings(const CompiledModel& model) {
  std::vector<const FunctionInfo*> result;
  for (const FunctionInfo& function : model.manifest().functions) {
    if (function.name.ends_with("_checked")) {
      result.push_back(&function);
    }
  }
  return result;
}

std::string plain_name(const FunctionInfo& sibling) {
  return sibling.name.substr(0, sibling.name.size() - std::strlen("_checked"));
}

Measurement checked(const CompiledModel& model, const FunctionInfo& function,
                    const Sample& sample) {
  return model.measure(function.name, support::arguments(sample, function.arguments));
}

std::vector<Sample> states_of(const CompiledModel& model, std::size_t count) {
  return support::samples(static_cast<std::size_t>(model.manifest().dof),
                          model.manifest().points.size(), count, 3);
}

struct CheckedCase {
  const char* name;
  const char* model;
  std::vector<std::string> options;
};

class Checked : public testing::TestWithParam<CheckedCase> {};

CompiledModel compiled(const CheckedCase& of) {
  std::vector<std::string> options = {"--checked", "-q"};
  options.insert(options.end(), of.options.begin(), of.options.end());
  return support::generate_and_compile(fs::path(TREEDYN_SOURCE_DIR) / "models" / of.model, options);
}

TEST_P(Checked, HasTheBitsOfThePlainFunctionAndNothingToSay) {
  const CompiledModel model = compiled(GetParam());
  ASSERT_FALSE(siblings(model).empty());
  for (const Sample& sample : states_of(model, 50)) {
    for (const FunctionInfo* function : siblings(model)) {
      const Measurement m = checked(model, *function, sample);
      EXPECT_EQ(m.status, 0) << function->name;
      EXPECT_EQ(bits(m.values), bits(model.call(plain_name(*function),
                                                support::arguments(sample, function->arguments))))
          << function->name;
    }
  }
}

TEST_P(Checked, FindsEveryArgumentThatIsNoNumber) {
  const CompiledModel model = compiled(GetParam());
  const Sample sample = states_of(model, 1).front();
  for (const FunctionInfo* function : siblings(model)) {
    const auto good = support::arguments(sample, function->arguments);
    for (std::size_t array = 0; array < good.size(); ++array) {
      for (std::size_t k = 0; k < good[array].size(); ++k) {
        for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
          auto inputs = good;
          inputs[array][k] = bad;
          EXPECT_NE(model.measure(function->name, inputs).status & kNotANumber, 0)
              << function->name << ' ' << function->arguments[array] << ' ' << k;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, Checked,
    testing::Values(
        CheckedCase{"TwoLink", "two_link.yaml", {"--functions", kFunctions}},
        CheckedCase{"Polar", "polar.yaml", {"--functions", kFunctions, "--sincos", "libm"}},
        CheckedCase{"Puma", "puma560.yaml", {"--functions", kFunctions, "--trig", "late"}},
        CheckedCase{
            "PumaInFloat", "puma560.yaml", {"--functions", kFunctions, "--scalar", "float"}},
        CheckedCase{"BipedInFloat",
                    "biped.yaml",
                    {"--functions", "mass_matrix,forward_dynamics", "--scalar", "float", "--effort",
                     "0", "--layout", "packed"}},
        CheckedCase{"FreeBiped",
                    "biped.yaml",
                    {"--functions", "forward_dynamics", "--base", "axes", "--effort", "0"}}),
    [](const auto& of) { return of.param.name; });

/// A point mass at the end of two massless links: A is singular where they are in line, and only
/// there. In units of length and mass.
std::string point_mass(const std::string& length, const std::string& mass) {
  return fmt::format(R"(name: arm
links:
  - {{name: upper, father: ground, joint: {{name: shoulder, type: revolute, axis: [0, 1, 0]}}, mass: 0}}
  - {{name: fore, father: upper, joint: {{name: elbow, type: revolute, axis: [0, 1, 0], offset: [{0}, 0, 0]}},
     mass: {1}, com: [0.7*{0}, 0, 0]}}
)",
                     length, mass);
}

class Singular : public testing::TestWithParam<std::array<const char*, 2>> {};

/// In double and float: 1 of a state in line, 0 of others.
void expect_told(const std::string& text, const std::string& method) {
  const support::TemporaryFolder folder;
  const fs::path file = folder.path() / "arm.yaml";
  support::write_file(file, text);
  for (const std::string scalar : {"double", "float"}) {
    const CompiledModel model =
        support::generate_and_compile(file, {"--checked", "-q", "--functions", kFunctions,
                                             "--scalar", scalar, "--forward-dynamics", method});
    for (Sample sample : states_of(model, 50)) {
      for (const double elbow : {0.0, 0.3, -2.0}) {
        sample["q"][1] = elbow;
        for (const FunctionInfo* function : siblings(model)) {
          const int status = checked(model, *function, sample).status;
          EXPECT_EQ(status & kRankLost, elbow == 0 ? kRankLost : 0)
              << scalar << ' ' << function->name << " elbow " << elbow;
        }
      }
    }
  }
}

TEST_P(Singular, PositionsAreToldInAllUnits) {
  const auto& [length, mass] = GetParam();
  expect_told(point_mass(length, mass), "factor");
  expect_told(point_mass(length, mass), "articulated");
}

INSTANTIATE_TEST_SUITE_P(Units, Singular,
                         testing::Values(std::array{"1", "1"}, std::array{"0.001", "1e6"},
                                         std::array{"1e4", "1e-5"}),
                         [](const auto& of) { return fmt::format("Case{}", of.index); });

// The middle one of three turning joints of the base: its axes lie in a plane at a right angle.
TEST(CheckedForwardDynamics, TellsTheGimbalOfTheBase) {
  for (const std::string scalar : {"double", "float"}) {
    const CompiledModel model =
        support::generate_and_compile(fs::path(TREEDYN_SOURCE_DIR) / "models/biped.yaml",
                                      {"--checked", "-q", "--functions", "forward_dynamics",
                                       "--base", "axes", "--effort", "0", "--scalar", scalar});
    Sample sample = states_of(model, 1).front();
    for (const double angle : {std::acos(0.0), -std::acos(0.0)}) {
      sample["q"][4] = angle;
      EXPECT_EQ(checked(model, *siblings(model).front(), sample).status & kRankLost, kRankLost);
      sample["q"][4] = 0.99 * angle;
      EXPECT_EQ(checked(model, *siblings(model).front(), sample).status, 0);
    }
  }
}

/// What stands between `from` and the end of a function.
std::string definition(const std::string& source, const std::string& name) {
  const std::size_t at = source.find(fmt::format("\nvoid {}(", name));
  return at == std::string::npos ? "" : source.substr(at, source.find("\n}\n", at) - at);
}

TEST(CheckedOption, ChangesNoByteOfPlainFunctions) {
  const support::TemporaryFolder plain;
  const support::TemporaryFolder more;
  const fs::path model = fs::path(TREEDYN_SOURCE_DIR) / "models/puma560.yaml";
  support::generate(model, {"-q", "--effort", "0"}, plain.path());
  support::generate(model, {"-q", "--effort", "0", "--checked"}, more.path());
  const std::string before = support::read_file(plain.path() / "generated.cpp");
  const std::string after = support::read_file(more.path() / "generated.cpp");
  for (const char* name : {"mass_matrix", "bias_force", "gravity_force", "inverse_dynamics",
                           "forward_dynamics", "point_positions"}) {
    EXPECT_EQ(definition(before, name), definition(after, name));
  }
  EXPECT_NE(definition(before, "forward_dynamics"), "");
  EXPECT_THAT(after, HasSubstr("int forward_dynamics_checked("));
  EXPECT_THAT(before, testing::Not(HasSubstr("checked")));
}

TEST(CheckedOption, CompilesWithoutWarnings) {
  const support::TemporaryFolder folder;
  support::generate(fs::path(TREEDYN_SOURCE_DIR) / "models/puma560.yaml",
                    {"-q", "--effort", "0", "--checked", "--scalar", "float"}, folder.path());
  for (const char* compiler : {"g++", "clang++"}) {
    const support::Outcome outcome =
        support::run({compiler, "-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow",
                      "-Wconversion", "-Wdouble-promotion", "-Wold-style-cast", "-Werror", "-O1",
                      "-fno-exceptions", "-c", folder.path() / "generated.cpp", "-o", "/dev/null"});
    EXPECT_EQ(outcome.status, 0) << outcome.err.substr(0, 1000);
  }
}

support::Outcome generated(const std::vector<std::string>& options) {
  const support::TemporaryFolder folder;
  std::vector<std::string> command = {TREEDYN_EXECUTABLE,
                                      "generate",
                                      fs::path(TREEDYN_SOURCE_DIR) / "models/biped.yaml",
                                      "--effort",
                                      "0",
                                      "--checked",
                                      "-o",
                                      folder.path()};
  command.insert(command.end(), options.begin(), options.end());
  return support::run(command);
}

TEST(CheckedOption, IsForOneStateAndCodeOfItsOwn) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--lanes", "4"}, {"--share-limbs"}, {"--limb-lanes"}}) {
    const support::Outcome outcome = generated(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err,
              fmt::format("treedyn: --checked: a status is that of one state and of code that is "
                          "not shared; expected no {} and 1 lane; see treedyn --help\n",
                          options.size() == 1 ? options[0] : "--share-limbs"));
  }
}

TEST(CheckedOption, SaysWhereNothingCanFail) {
  const support::Outcome outcome = generated({"--functions", "mass_matrix"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("warning: no function that is generated divides by the pivots "
                                     "of A; --checked changes nothing"));
}

}  // namespace
}  // namespace treedyn
