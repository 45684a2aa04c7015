// NAME.json: the same facts for programs, INTERFACE.md 5.
//
// `rounding` of a function: the largest bound of rounding errors of its outputs over that of the
// same function before any pass, at most 4 (an output by itself at most 8, counted half);
// `rounding_without`: the passes that are left out to keep it so.
#pragma once

#include <string>
#include <vector>

#include "emit/body.hpp"
#include "emit/unit.hpp"

namespace treedyn::emit {

/// {"add": 1, ...}
std::string operations_json(const program::Cost& cost);

/// \param bodies one per function of the unit, in order
std::string manifest_text(const Unit& unit, const std::vector<Body>& bodies);

}  // namespace treedyn::emit
