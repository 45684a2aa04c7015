// Operation counts with the default options: at most what is reached today, so that a loss shows; a
// gain moves the ceiling. The targets of tests/benchmark/README.md lie above. Columns: mass_matrix,
// inverse_dynamics, bias_force, forward_dynamics, gravity_force, pairs of sine and cosine of the
// dearest of these.
#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/read.hpp"
#include "formulate/formulate.hpp"
#include "support/process.hpp"

namespace treedyn::formulate {
namespace {

struct Target {
  const char* name;
  const char* file;  ///< below models/ or the folder of published robots
  description::Base base;
  int mass_matrix;
  int inverse_dynamics;
  int bias_force;
  int forward_dynamics;
  int gravity_force;
  int pairs;
};

constexpr description::Base kFixed = description::Base::kFixed;
constexpr description::Base kAxes = description::Base::kAxes;

const Target kTargets[] = {
    {"puma560", "puma560.yaml", kFixed, 116, 260, 205, 435, 19, 4},
    {"ur5", "ur5_robot.urdf", kFixed, 72, 194, 141, 292, 7, 5},
    {"panda", "panda.yaml", kFixed, 286, 511, 457, 985, 70, 6},
    {"kinova", "kinova.urdf", kFixed, 178, 309, 271, 613, 35, 5},
    {"hyq_fixed", "hyq_no_sensors.urdf", kFixed, 136, 440, 200, 472, 72, 12},
    {"anymal_fixed", "anymal.urdf", kFixed, 116, 393, 180, 456, 72, 12},
    {"hyq_axes", "hyq_no_sensors.urdf", kAxes, 794, 1301, 1196, 2836, 132, 15},
    {"bolt_axes", "bolt.urdf", kAxes, 395, 670, 613, 1433, 68, 9},
};

std::string path_of(const Target& target) {
  const std::string model = std::string(TREEDYN_SOURCE_DIR "/models/") + target.file;
  return std::filesystem::exists(model)
             ? model
             : std::string(TREEDYN_SHARED_DATA "/robots/urdf/") + target.file;
}

class Targets : public testing::TestWithParam<Target> {};

TEST_P(Targets, AreMetByTheDefaultOptions) {
  const Target& target = GetParam();
  description::ReadOptions read;
  read.base = target.base;
  const model::Tree tree = description::read_model(path_of(target), read);
  Options options;
  options.gravity = {0, 0, Real("-9.81")};
  const std::pair<const char*, int> limits[] = {{"mass_matrix", target.mass_matrix},
                                                {"inverse_dynamics", target.inverse_dynamics},
                                                {"bias_force", target.bias_force},
                                                {"forward_dynamics", target.forward_dynamics},
                                                {"gravity_force", target.gravity_force}};
  for (const auto& [function, limit] : limits) {
    const program::Cost cost = program::cost(formulated(tree, function, options));
    EXPECT_LE(cost.total(), limit) << function;
    EXPECT_LE(cost.angles, target.pairs) << function;
  }
}

/// A length that is zero and seen as another number is no unit; as one it cost 423.
TEST(UnitOfLength, IsNoLengthThatIsZero) {
  const model::Tree tree =
      description::read_model(TREEDYN_SOURCE_DIR "/tests/formulate/hidden_wrist.yaml", {});
  Options options;
  options.gravity = {0, 0, Real("-9.81")};
  EXPECT_LE(program::cost(formulated(tree, std::string("forward_dynamics"), options)).total(), 420);
}

/// The rows of README.md's table are these ceilings.
TEST(Readme, ShowsTheCountsOfTargets) {
  const std::string readme = support::read_file(TREEDYN_SOURCE_DIR "/README.md");
  const auto row_of = [](const char* name) {
    return *std::ranges::find(kTargets, std::string_view(name), &Target::name);
  };
  const std::string three = "mass_matrix / inverse_dynamics / bias_force";
  const auto expect_row = [&](const char* title, const Target& robot) {
    const std::string row =
        fmt::format("| {} | {} | {} / {} / {} |", title, three, robot.mass_matrix,
                    robot.inverse_dynamics, robot.bias_force);
    EXPECT_NE(readme.find(row), std::string::npos) << row;
  };
  expect_row("UR5", row_of("ur5"));
  expect_row("HyQ, `--base axes`", row_of("hyq_axes"));
  const std::string row =
      fmt::format("| UR5 | forward_dynamics | {} |", row_of("ur5").forward_dynamics);
  EXPECT_NE(readme.find(row), std::string::npos) << row;
}

std::vector<Target> available_targets() {
  std::vector<Target> available;
  for (const Target& target : kTargets) {
    if (std::filesystem::exists(path_of(target))) {
      available.push_back(target);
    }
  }
  return available;
}

INSTANTIATE_TEST_SUITE_P(Robots, Targets, testing::ValuesIn(available_targets()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace treedyn::formulate
