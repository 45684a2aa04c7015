// A ball on a vertical slide, its scenes and their code.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "scenes/arm_scene.hpp"

namespace treedyn::support {

/// A mass of 1 kg on a vertical slide.
inline std::string ball(const std::string& rest) {
  return "scene: ball\nmodel: ball.yaml\npoints: [{name: tip, link: ball, at: [0, 0, 0]}]\n" + rest;
}

class BallCode {
 public:
  explicit BallCode(const std::string& rest, Variant variant = Variant::kPlain) {
    write_file(
        folder_.path() / "ball.yaml",
        "name: ball\nlinks:\n  - name: ball\n    father: ground\n    joint: {name: height, type: "
        "prismatic, axis: [0, 0, 1]}\n    mass: 1\n");
    write_file(folder_.path() / "scene.yaml", ball(rest));
    generate({}, {"--scene", (folder_.path() / "scene.yaml").string()}, folder_.path());
    code_ = std::make_unique<CompiledModel>(folder_.path(), "generated", variant);
  }
  [[nodiscard]] const CompiledModel& code() const { return *code_; }
  [[nodiscard]] Operations worst_case() const {
    const Json manifest = Json::parse(read_file(folder_.path() / "generated.json"));
    for (const Json& entry : manifest.at("functions")) {
      if (entry.at("name") == "step") {
        return operations_of(entry.at("worst_case"));
      }
    }
    throw std::out_of_range("step");
  }
  [[nodiscard]] std::string header() const { return read_file(folder_.path() / "generated.hpp"); }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<CompiledModel> code_;
};

}  // namespace treedyn::support
