// What the text of a function says where lengths inside it are not in metres.
#pragma once

#include <string>

#include "model/tree.hpp"
#include "program/function.hpp"

namespace treedyn::emit {

/// The unit that values of a symbol have where lengths are in units of L ("L/s^2" of
/// accelerations); empty: their SI unit.
std::string unit_in(const std::string& symbol);

/// Comment lines for the head of the function: which length is the unit, and which named values are
/// in it. Empty for the metre.
std::string unit_comment(const program::Function& function, const model::Tree& tree);

/// `"unit_of_length": 0.0203` behind a comma, for the manifest. Empty for the metre.
std::string unit_json(const program::Function& function);

}  // namespace treedyn::emit
