// Scenes in the format hard-case/1 (tests/data/hard_cases/SCHEMA.md).
#pragma once

#include <string>

#include "description/yaml_node.hpp"
#include "model/scene.hpp"

namespace treedyn::description {

/// A file of hard_cases: its bodies stand in it.
bool is_hard_case(const Node& root);
/// \throws InputError
model::Scene read_hard_case(const std::string& file, const Node& root);

}  // namespace treedyn::description
