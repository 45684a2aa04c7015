// What `treedyn info` and `treedyn list` say.
#pragma once

#include <string>

#include "pipeline.hpp"

namespace treedyn {

/// Joints, order, D with its zero blocks, sizes, masses, snapped constants and the cost of every
/// function.
std::string info_text(const Model& model, const Request& request,
                      const program::Programs& programs);
/// The same facts as one JSON object.
std::string info_json(const Model& model, const Request& request,
                      const program::Programs& programs);

/// Operations of every function with each pass and all before it: what a pass gains.
std::string passes_text(const Model& model, const Request& request);

/// One function a line: name, equation, what it is.
std::string list_functions();

}  // namespace treedyn
