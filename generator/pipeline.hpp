// The stages of the generator in the order in which data flows through them.
#pragma once

#include <functional>
#include <vector>

#include "stages/stages.hpp"

namespace treedyn {

/// Called with what users should know of the programs.
using Warn = std::function<void(const Warning&)>;

/// A model to text: `formulate_model`, `separate_parameters`, `check_at_states`, `emit_files`.
std::vector<emit::File> generate(const Model& model, const Request& request, const Trace& trace,
                                 const Warn& warn);

}  // namespace treedyn
