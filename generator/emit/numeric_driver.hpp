// A program that prints the values of generated functions, for `check --numeric`.
#pragma once

#include <string>
#include <vector>

#include "program/function.hpp"

namespace treedyn::emit {

/// The declaration in NAME.hpp: equal text, equal signature.
std::string declaration_text(const program::Signature& signature);

/// Its source; it includes NAME.hpp and calls the given functions of a namespace at fixed states.
std::string numeric_driver(const std::string& name, const std::string& space,
                           const std::vector<program::Signature>& functions);

}  // namespace treedyn::emit
