// The functions that are generated for a scene: only those that its effects call for.
#pragma once

#include <string>
#include <vector>

#include "equations/scene_table.hpp"
#include "formulate/formulate.hpp"
#include "model/scene.hpp"
#include "program/stepper.hpp"

namespace treedyn::formulate {

/// What is generated for a scene.
struct SceneFunctions {
  std::vector<program::Function>
      plain;                            ///< reaction_jacobian_transpose, reaction_bias_acceleration
  std::vector<program::Staged> staged;  ///< those that branch
  std::vector<program::Stepper> steppers;  ///< step, if the scene has steps of a fixed length
};

/// The cheapest formulations found; deterministic. `options` are those of the model; its scene,
/// gravity and points are replaced.
/// \param wanted  names of scene_function_infos(); empty: all that the scene needs
SceneFunctions scene_functions(const model::Scene& given, const Options& options,
                               const std::vector<std::string>& wanted);

}  // namespace treedyn::formulate
