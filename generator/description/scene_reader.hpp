// Scene files: a model and exactly the effects that act on it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "description/read.hpp"
#include "model/scene.hpp"

namespace treedyn::description {

/// Reads and checks a scene: in YAML (models/scenes/README.md), or in the format hard-case/1
/// (JSON). \throws InputError with file, line and column at the first mistake.
model::Scene read_scene(const std::string& path);

/// Path to text; \throws InputError.
using TextReader = std::function<std::string(const std::string& path)>;

/// The number of run-time parameter `index` of a tree that has this nominal value.
using AtRunTime = std::function<Real(int index, const Real& nominal)>;

/// The same from text that was read already; `file` is the name in messages, beside which the
/// scene's model stands.
/// \param model_text  called once for this model, if it is a file
/// \param at_run_time  empty: numbers are fixed, whatever the scene and its model declare, and
/// `tree.parameters` is empty
model::Scene parse_scene(const std::string& text, const std::string& file,
                         const TextReader& model_text = read_model_text,
                         const AtRunTime& at_run_time = {});

/// As `joints_without_inertia` of a tree, with the armatures of the scene.
std::vector<Warning> joints_without_inertia(const model::Scene& scene);

/// \throws InputError if accelerations do not follow from forces: A with the scene's armatures is
/// singular in every position.
void require_inertia(const model::Scene& scene);

}  // namespace treedyn::description
