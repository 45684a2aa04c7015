// Fuzz target: scenes, in YAML and in the format of case files, on any bytes; the model is one of
// ours.
#include <cstddef>
#include <cstdint>
#include <string>

#include "common/error.hpp"
#include "description/scene_reader.hpp"
#include "fuzz/checked.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

const char* const kModel =
    "name: arm\n"
    "links:\n"
    "- {name: upper_arm, father: ground, joint: {name: shoulder, type: revolute, axis: [0, -1, "
    "0]}, "
    "mass: 1, com: [1, 0, 0]}\n"
    "- {name: forearm, father: upper_arm, joint: {name: elbow, type: revolute, axis: [0, -1, 0], "
    "offset: [2, 0, 0]}, mass: 1, com: [1, 0, 0]}\n"
    "points: [{name: tip, link: forearm, at: [2, 0, 0]}]\n";

void expect_scene(const treedyn::model::Scene& scene) {
  const auto dof = static_cast<std::size_t>(scene.tree.dof());
  treedyn::fuzz::expect_checked(scene.tree);
  TREEDYN_EXPECT(scene.q0.size() == dof && scene.qd0.size() == dof);
  TREEDYN_EXPECT(!scene.phases.empty());
  const auto phases = static_cast<int>(scene.phases.size());
  const auto constraints = static_cast<int>(scene.constraints.size());
  TREEDYN_EXPECT(scene.start_phase >= 0 && scene.start_phase < phases);
  for (const treedyn::model::Phase& phase : scene.phases) {
    for (const int active : phase.active) {
      TREEDYN_EXPECT(active >= 0 && active < constraints);
    }
    for (const treedyn::model::Event& event : phase.until) {
      TREEDYN_EXPECT(event.then >= 0 && event.then < phases);
    }
  }
  static_cast<void>(treedyn::description::joints_without_inertia(scene));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    expect_scene(treedyn::description::parse_scene(
        text, "fuzz.yaml", [](const std::string&) { return std::string(kModel); }));
  } catch (const treedyn::InputError&) {  // the only way to refuse
  }
  return 0;
}
