// Factors that the scalar type rounds to one are neither written nor counted.
#include <nlohmann/json.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/compiled.hpp"
#include "support/process.hpp"
#include "support/states.hpp"

namespace treedyn {
namespace {

using support::CompiledModel;
using support::FunctionInfo;
using support::Sample;
using testing::HasSubstr;
using testing::Not;

/// Two links whose masses and lengths are `one`.
std::string arm(const std::string& one) {
  return fmt::format(R"(name: robot
links:
  - {{name: a, father: ground, joint: {{name: j, type: revolute, axis: [0, 0, 1]}}, mass: {0}, com: [{0}, 0, 0],
     inertia: [0.1, 0, 0, 0.2, 0, 0.3]}}
  - {{name: b, father: a, joint: {{name: k, type: revolute, axis: [0, 1, 0], offset: [{0}, 0.3, 0.2]}}, mass: {0},
     com: [0.3, 0, 0.4], inertia: [0.1, 0, 0, 0.2, 0, 0.3]}}
)",
                     one);
}

struct NearOne {
  const char* one;
  const char* scalar;
};

class Ones : public testing::TestWithParam<NearOne> {
 protected:
  std::string model() const { return folder_.path() / "robot.yaml"; }
  std::string scene() const { return folder_.path() / "scene.yaml"; }
  std::string file(const char* name) const { return folder_.path() / name; }
  void SetUp() override {
    support::write_file(model(), arm(GetParam().one));
    support::write_file(scene(),
                        "scene: s\nmodel: robot.yaml\neffects:\n  gravity: [0, 0, -9.81]\n"
                        "  locked_joint: [{joint: k}]\nduration: 1\n"
                        "stepping: {integrator: rk4, step: 0.001}\n");
  }
  void expect_clean(const std::string& source) const {
    const std::string text = support::read_file(source);
    for (const char* const product : {"1.0 * ", " * 1.0;", "1.0f * ", " * 1.0f;"}) {
      EXPECT_THAT(text.substr(text.find("\n// Names of values")), Not(HasSubstr(product)));
    }
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_P(Ones, AreNotWrittenAndCountsAreThoseOfTheText) {
  const std::vector<std::string> options = {"-q", "--effort", "300", "--scalar", GetParam().scalar};
  support::generate(model(), options, file("out"));
  expect_clean(file("out/generated.cpp"));
  const CompiledModel code(file("out"), "generated", support::Variant::kMeasured);
  const Sample sample = support::samples(2, 0, 1, 1).front();
  for (const FunctionInfo& function : code.manifest().functions) {
    EXPECT_EQ(
        code.measure(function.name, support::arguments(sample, function.arguments)).operations,
        function.operations)
        << function.name;
  }
}

TEST_P(Ones, AreNotCountedByInfo) {
  const std::vector<std::string> options = {"--effort", "300", "--scalar", GetParam().scalar};
  support::generate(model(), options, file("out"));
  std::vector<std::string> command = {TREEDYN_EXECUTABLE, "info", "--json", model()};
  command.insert(command.end(), options.begin(), options.end());
  const auto json = nlohmann::json::parse(support::run(command).out);
  const auto manifest = nlohmann::json::parse(support::read_file(file("out/generated.json")));
  for (const auto& function : manifest.at("functions")) {
    const auto known =
        std::find_if(json.at("functions").begin(), json.at("functions").end(),
                     [&](const auto& other) { return other.at("name") == function.at("name"); });
    ASSERT_NE(known, json.at("functions").end());
    EXPECT_EQ(known->at("operations"), function.at("operations")) << function.at("name");
  }
}

TEST_P(Ones, AreNotWrittenInFunctionsOfScenes) {
  support::generate("",
                    {"-q", "--effort", "300", "--scalar", GetParam().scalar, "--scene", scene()},
                    file("out"));
  expect_clean(file("out/generated.cpp"));
}

INSTANTIATE_TEST_SUITE_P(Numbers, Ones,
                         testing::Values(NearOne{"0.99999999999999999", "double"},
                                         NearOne{"1.0000000000000001", "double"},
                                         NearOne{"1.000000001", "float"}, NearOne{"1", "double"}),
                         [](const auto& of) { return fmt::format("Case{}", of.index); });

}  // namespace
}  // namespace treedyn
