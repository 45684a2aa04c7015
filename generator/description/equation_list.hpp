// The equations of users in a tree description or a file of their own, INTERFACE.md 7.
#pragma once

#include <string>
#include <vector>

#include "model/equation.hpp"

namespace treedyn::description {

/// The key `equations:` of a tree description; nothing if it has none.
/// \throws InputError
std::vector<model::EquationText> equations_of_tree(const std::string& text,
                                                   const std::string& file);

/// A file with the keys `equations:` and, if wanted, `parameters:`.
/// \throws InputError
std::vector<model::EquationText> equations_of_file(const std::string& text,
                                                   const std::string& file);

}  // namespace treedyn::description
