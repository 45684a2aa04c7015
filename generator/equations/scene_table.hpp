// The functions of a scene.
#pragma once

#include <string>
#include <vector>

namespace treedyn::equations {

/// A function that a scene may call for, as `treedyn list` shows it.
struct SceneFunctionInfo {
  const char* name;  ///< without the suffixes of phases, contacts and impacts
  const char* equation;
  const char* what;
};

/// All of them, in order.
const std::vector<SceneFunctionInfo>& scene_function_infos();
/// \return true if `name` is one of theirs.
bool is_scene_function(const std::string& name);

}  // namespace treedyn::equations
