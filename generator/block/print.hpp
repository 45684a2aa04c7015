// Block expressions as text that reads like EQUATIONS.md.
#pragma once

#include <string>

#include "block/block.hpp"

namespace treedyn::block {

/// One line, named subexpressions by their names: "D s^d (D-E) + l^d D".
std::string print(const Expression& expression);

/// "c_fD = D s^d (D-E) + (l+c)^d D": the definition if `expression` has a name, else as `print`.
std::string print_definition(const Expression& expression);

}  // namespace treedyn::block
