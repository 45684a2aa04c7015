// Scene files: a model and exactly the effects that act on it.
#pragma once

#include <string>

#include "model/scene.hpp"

namespace treedyn::description {

/// Reads and checks a scene: in YAML (README.md), or in the format hard-case/1 (JSON).
/// \throws InputError with file, line and column at the first mistake.
model::Scene read_scene(const std::string& path);

/// The same from text that was read already; `file` is the name in messages.
model::Scene parse_scene(const std::string& text, const std::string& file);

}  // namespace treedyn::description
