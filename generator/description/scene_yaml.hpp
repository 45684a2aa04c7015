// Scene files in YAML, README.md "Scenes".
#pragma once

#include <string>

#include "description/yaml_node.hpp"
#include "model/scene.hpp"

namespace treedyn::description {

/// \param file  its folder is where the model's path begins
/// \throws InputError
model::Scene read_scene_yaml(const Node& root, const std::string& file);

}  // namespace treedyn::description
