// The dampers beside the springs of joints.
#pragma once

#include <optional>

#include "model/scene.hpp"

namespace treedyn::support {

/// Calls `change` for the damping of every joint spring that has some. \param change  Real& ->
template <class Change>
void each_damping(model::Scene& scene, Change change) {
  for (model::JointLaw& law : scene.joint_laws) {
    law.force.change_constants([&](Real& x, std::optional<model::SceneNumber> what) {
      if (what == model::SceneNumber::kDamping) {
        change(x);
      }
    });
  }
}

}  // namespace treedyn::support
