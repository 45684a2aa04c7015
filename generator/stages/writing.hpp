// Programs to text.
#pragma once

#include <vector>

#include "emit/unit.hpp"
#include "program/programs.hpp"
#include "request/read_model.hpp"

namespace treedyn {

std::vector<emit::File> emit_files(const Model& model, const Request& request,
                                   program::Programs programs);

}  // namespace treedyn
