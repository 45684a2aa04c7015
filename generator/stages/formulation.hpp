// The programs of a model and of its scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "formulate/formulate.hpp"
#include "program/programs.hpp"
#include "request/read_model.hpp"

namespace treedyn {

/// Called with a line about every stage when it is done, for -v.
using Trace = std::function<void(const std::string&)>;

/// Tree to programs: one per function.
/// \throws InputError if the numbers of the model leave nothing to divide by
program::Programs formulate_model(const Model& model, const Request& request, const Trace& trace);

/// What the formulations of a model are free to choose from.
formulate::Options formulate_options(const Model& model, const Request& request);

/// Names of the passes, in order.
std::vector<std::string> pass_names();

}  // namespace treedyn
