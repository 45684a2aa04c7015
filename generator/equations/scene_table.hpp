// The functions of a scene.
#pragma once

#include <string_view>
#include <vector>

#include "block/block.hpp"

namespace treedyn::equations {

/// A function that a scene may call for, as `treedyn list` shows it, and headers but for steps and
/// scenes without rows.
struct SceneFunctionInfo {
  const char* name;  ///< without the suffixes of phases, contacts and impacts
  const char* equation;
  const char* what;
  std::vector<block::Expression> equations{};  ///< none: no block equation
  const char* unknown = "";                    ///< for which the equations are zero, beside λ
  const char* remainder =
      "";  ///< the second equation, with the least λ for which the first is zero
};

/// All of them, in order.
const std::vector<SceneFunctionInfo>& scene_function_infos();
/// \return true if `name` is one of theirs.
bool is_scene_function(std::string_view name);
/// \pre is_scene_function(name)
const SceneFunctionInfo& scene_function_info(std::string_view name);

}  // namespace treedyn::equations
