// Scenes as generated and compiled code.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scenes/status.hpp"
#include "support/compiled.hpp"
#include "support/process.hpp"

namespace treedyn::support {

using Json = nlohmann::json;
using Vector = std::vector<double>;
using Operations = std::array<long, 6>;

/// A scene in a temporary folder, generated and compiled.
class SceneCode {
 public:
  explicit SceneCode(const std::string& text, Variant variant = Variant::kPlain,
                     const std::vector<std::string>& more = {}) {
    const std::filesystem::path file = folder_.path() / "scene.yaml";
    write_file(file, text);
    options_ = {"--scene", file.string(), "--effort", "20"};
    options_.insert(options_.end(), more.begin(), more.end());
    generate({}, options_, folder_.path());
    code_ = std::make_unique<CompiledModel>(folder_.path(), "generated", variant);
  }

  [[nodiscard]] const CompiledModel& code() const { return *code_; }
  /// NAME.cpp.
  [[nodiscard]] std::string source() const { return read_file(folder_.path() / "generated.cpp"); }
  /// NAME.hpp.
  [[nodiscard]] std::string header() const { return read_file(folder_.path() / "generated.hpp"); }
  [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }
  [[nodiscard]] Operations operations(const std::string& function) const {
    return code_->manifest().function(function).operations;
  }
  [[nodiscard]] Json manifest(const std::string& function) const {
    const Json manifest = Json::parse(read_file(folder_.path() / "generated.json"));
    for (const Json& entry : manifest.at("functions")) {
      if (entry.at("name") == function) {
        return entry;
      }
    }
    throw std::out_of_range(function);
  }
  [[nodiscard]] Json info() const {
    std::vector<std::string> command = {TREEDYN_EXECUTABLE, "info", "--json"};
    command.insert(command.end(), options_.begin(), options_.end());
    return Json::parse(run(command).out);
  }

 private:
  TemporaryFolder folder_;
  std::vector<std::string> options_;
  std::unique_ptr<CompiledModel> code_;
};

/// The text of a scene of the two-link arm.
/// \param effects  lines below `effects:`, two spaces in front
/// \param more     further top-level lines
inline std::string arm_scene(const std::string& effects, const std::string& more = {}) {
  return fmt::format(
      "scene: arm\nmodel: {}/models/two_link.yaml\npoints:\n"
      "  - {{name: hand, link: forearm, at: [1, 0, 0]}}\n"
      "{}effects:\n  gravity: [0, 0, -9.81]\n{}duration: 1\n",
      TREEDYN_SOURCE_DIR, more, effects);
}

/// A scene of the two-link arm.
class ArmScene : public SceneCode {
 public:
  explicit ArmScene(const std::string& effects, const std::string& more = {},
                    Variant variant = Variant::kPlain)
      : SceneCode(arm_scene(effects, more), variant) {}
};

/// The arm's hand held in the vertical plane; on the ground.
inline const char* const kHeld =
    "  point_constraint:\n    - {name: hold, point: hand, along: [x, z]}\n";
inline const char* const kGround =
    "  ground_contact:\n    - {point: hand, height: 0, stiffness: 1e4, exponent: 1.5, "
    "dissipation: 0.2, friction: 0.5, slip_speed: 0.01}\n";

/// A state of the arm that is not special.
inline const Vector kq = {0.4, -0.9};
inline const Vector kqd = {0.7, 1.1};
inline const Vector ktau = {20, -3};

/// q and qd one semi-implicit Euler step of 1 ms later.
inline Vector stepped(const ArmScene& scene, const Vector& q) {
  constexpr double kStep = 1e-3;
  const Vector qdd = scene.code().call("constrained_dynamics", {q, kqd, ktau});
  Vector result;
  for (std::size_t i = 0; i < q.size(); ++i) {
    result.push_back(kqd[i] + kStep * qdd[i]);
    result.push_back(q[i] + kStep * result.back());
  }
  return result;
}

/// A model of tests/scenes/models/.
inline std::string model_path(const std::string& name) {
  return fmt::format("{}/tests/scenes/models/{}.yaml", TREEDYN_SOURCE_DIR, name);
}

inline bool has(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

/// All operations.
inline long total(const Operations& operations) {
  return std::accumulate(operations.begin(), operations.end(), 0L);
}

inline Operations operations_of(const Json& json) {
  return {json.at("add"),  json.at("mul"), json.at("div"),
          json.at("sqrt"), json.at("sin"), json.at("cos")};
}

}  // namespace treedyn::support
