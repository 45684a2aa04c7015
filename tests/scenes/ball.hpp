// A ball of 1 kg on a vertical slide, its scenes and their code.
#pragma once

#include <string>

#include "scenes/arm_scene.hpp"

namespace treedyn::support {

class BallCode : public SceneCode {
 public:
  /// \param rest  of the scene, behind its points
  explicit BallCode(const std::string& rest, Variant variant = Variant::kPlain)
      : SceneCode("scene: ball\nmodel: " + model_path("ball") +
                      "\npoints: [{name: tip, link: ball, at: [0, 0, 0]}]\n" + rest,
                  variant) {}
  [[nodiscard]] Operations worst_case() const {
    return operations_of(manifest("step").at("worst_case"));
  }
};

}  // namespace treedyn::support
