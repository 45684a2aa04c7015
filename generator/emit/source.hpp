// NAME.cpp: the functions.
#pragma once

#include <string>
#include <vector>

#include "emit/body.hpp"
#include "emit/unit.hpp"

namespace treedyn::emit {

/// \param bodies one per function of the unit, in order
std::string source_text(const Unit& unit, const std::vector<Body>& bodies, const Vocabulary& words);

}  // namespace treedyn::emit
