// Text of functions whose limbs share code: names of every length, limbs that have nothing to say.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/compiled.hpp"
#include "support/process.hpp"

namespace treedyn {
namespace {

/// A trunk and two equal limbs of two links, whose names end in `name`.
std::string robot(const std::string& name) {
  std::string text =
      "name: robot\nlinks:\n  - {name: trunk, father: ground, joint: {name: turn, type: revolute, "
      "axis: [0, 0, 1]},\n     mass: 3, com: [0.1, 0, 0.2], inertia: [1, 0, 0, 1, 0, 1]}\n";
  for (const char* side : {"left", "right"}) {
    const int y = std::string_view(side) == "left" ? 1 : -1;
    text += fmt::format(
        "  - {{name: {0}_{1}, father: trunk, joint: {{name: {0}_a, type: revolute, axis: [1, 0, "
        "0], offset: [0, {2}, 0]}},\n     mass: 2, com: [0, 0.1, -0.3], inertia: [0.1, 0.01, 0, "
        "0.2, 0, 0.1]}}\n  - {{name: {0}_{1}_end, father: {0}_{1}, joint: {{name: {0}_b, type: "
        "revolute, axis: [0, 1, 0], offset: [0, 0, -1]}},\n     mass: 1, com: [0.2, 0.1, -0.3], "
        "inertia: [0.1, 0, 0, 0.2, 0.02, 0.1]}}\n",
        side, name, y);
  }
  return text;
}

/// Generates with shared limbs and compiles with warnings as errors.
void expect_clean(const std::string& model, const std::string& option = "--share-limbs") {
  const support::TemporaryFolder folder;
  support::write_file(folder.path() / "robot.yaml", model);
  support::generate(folder.path() / "robot.yaml", {option, "--effort", "0", "-q"}, folder.path());
  for (const char* compiler : {"g++", "clang++"}) {
    const support::Outcome outcome =
        support::run({compiler, "-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow",
                      "-Werror", "-O1", "-c", folder.path() / "generated.cpp", "-o", "/dev/null"});
    EXPECT_EQ(outcome.status, 0) << outcome.err.substr(0, 1000);
  }
}

TEST(LimbText, HasRoomForLinkNamesOfEveryLength) {
  for (const std::size_t length : {1U, 15U, 24U, 40U, 49U, 60U, 120U}) {
    expect_clean(robot(std::string(length, 'x')));
  }
  expect_clean(robot("of_a_b_c_d_e_f_g_h_i_j_k_l_m_n_o_p_q_r_s_t_u_v"));
}

// Sliding joints on a trunk that turns: the limbs feel nothing of the velocities.
TEST(LimbText, LeavesOutLimbsThatOnlyHoldZero) {
  expect_clean(R"(name: r4
links:
  - {name: b0, father: ground, joint: {name: j0, type: revolute, axis: [-1, 0, 0]}, mass: 1, com: [0.1, 0, 0],
     inertia: [0.1, 0, 0, 0.1, 0, 0.1]}
  - {name: b2, father: b0, joint: {name: j2, type: prismatic, axis: [0, -1, 0], offset: [-0.3278, 0, -0.3],
     rotation: {rpy: [0, 0, -pi/2]}}, mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0, 0, 0.1, 0, 0.1]}
  - {name: b3, father: b0, joint: {name: j3, type: prismatic, axis: [1, 0, 0]}, mass: 1, com: [0.1, 0, 0],
     inertia: [0.1, 0, 0, 0.1, 0, 0.1]}
  - {name: b5, father: b0, joint: {name: j5, type: prismatic, axis: [0, 0, -1], offset: [-0.0086, -0.281, 0],
     rotation: {rpy: [pi/2, 3*pi/2, pi/2]}}, mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0, 0, 0.1, 0, 0.1]}
  - {name: b6, father: b3, joint: {name: j6, type: prismatic, axis: [0, -1, 0]}, mass: 1, com: [0.1, 0, 0],
     inertia: [0.1, 0, 0, 0.1, 0, 0.1]}
)");
}

// What limbs make of values of the trunk alone is the same in all lanes.
TEST(LimbText, SpreadsValuesOfTheTrunkOverLanes) {
  for (const char* const type : {"prismatic", "revolute"}) {
    std::string text =
        "name: robot\nlinks:\n  - {name: trunk, father: ground, joint: {name: turn, type: "
        "revolute, axis: [0, 0, 1]}, mass: 5, inertia: [0.1, 0, 0, 0.2, 0, 0.25]}\n";
    for (const char* const side : {"l", "r"}) {
      text += fmt::format(
          "  - {{name: {0}0, father: trunk, joint: {{name: {0}0_j, type: {1}, axis: [1, 0, 0], "
          "offset: [0.1, {2}, 0]}}, mass: 1, com: [0.01, 0, -0.1], inertia: [0.01, 0, 0, 0.01, 0, "
          "0.01]}}\n  - {{name: {0}1, father: {0}0, joint: {{name: {0}1_j, type: {1}, axis: [0, 1, "
          "0], offset: [0, 0, -0.3]}}, mass: 1, com: [0.01, 0, -0.1], inertia: [0.01, 0, 0, 0.01, "
          "0, 0.01]}}\n",
          side, type, *side == 'l' ? "0.1" : "-0.1");
    }
    expect_clean(text, "--limb-lanes");
  }
}

}  // namespace
}  // namespace treedyn
