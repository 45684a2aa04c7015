// What the program writes for a scene.
#include "cli/cli.hpp"

namespace treedyn {
namespace {

TEST_F(Cli, AScenesFilesDependOnSceneAndModel) {
  const std::string scene = TREEDYN_SOURCE_DIR "/models/scenes/pendulum.yaml";
  treedyn({"generate", "--scene", scene, "-o", out(), "--depfile", scratch("d.d")});
  EXPECT_THAT(
      read_file(scratch("d.d")),
      HasSubstr(".json: " + scene + " " TREEDYN_SOURCE_DIR "/models/scenes/pendulum.model.yaml\n"));
  support::write_file(file("pendulum.cpp"), "");
  EXPECT_THAT(treedyn({"check", "--scene", scene, "-o", out()}).out,
              HasSubstr("to update: treedyn generate --scene " + scene + " -o " + out()));
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
    expect_usage_error(treedyn(arguments), option + ": is a matter of the scene");
  }
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
