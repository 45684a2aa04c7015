// Scene files in YAML, models/scenes/README.md.
#pragma once

#include <string>

#include "description/scene_reader.hpp"
#include "description/yaml_node.hpp"
#include "model/scene.hpp"

namespace treedyn::description {

/// \param file  its folder is where the model's path begins
/// \param at_run_time  as of parse_scene
/// \throws InputError
model::Scene read_scene_yaml(const Node& node, const std::string& file,
                             const TextReader& model_text, const AtRunTime& at_run_time);

}  // namespace treedyn::description
