// Equations of users on their way through the stages, INTERFACE.md 7.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "formulate/derived.hpp"
#include "model/tree.hpp"
#include "program/function.hpp"
#include "request/request.hpp"

namespace treedyn {

using UserFunctions = formulate::DerivedFunctions;

/// The equations of the tree description `tree_file` (empty: none) and of the files of --equations,
/// derived. \throws InputError
UserFunctions read_user_equations(const Request& request, const std::string& tree_file,
                                  const std::string& tree_text, const model::Tree& tree,
                                  const std::vector<model::Point>& points);

/// The names of `wanted` (none: all). \throws UsageError for a name that no function has,
/// InputError for an equation of joints some of which mimic others.
UserFunctions chosen(const UserFunctions& all, const std::vector<std::string>& wanted,
                     const model::Tree& tree);

/// What the header says of it.
program::Signature signature_of(const formulate::Derived& function, int dof, int points);

/// Rows and columns of its value.
std::pair<int, int> size_of(const formulate::Derived& function, int dof, int points);

}  // namespace treedyn
