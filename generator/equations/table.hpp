// The equation index: every function that is one block expression, by name and number.
#pragma once

#include <span>
#include <string_view>

#include "block/block.hpp"

namespace treedyn::equations {

struct Equation {
  std::string_view name;    ///< of the generated function
  std::string_view number;  ///< in EQUATIONS.md
  block::Expression expression;
  std::string_view errata = {};   ///< of the print that the expression mends, EQUATIONS.md 4
  std::string_view unknown = {};  ///< what the function solves for where the expression is zero
};

/// In the order of the functions of the generated code.
std::span<const Equation> table();

/// Functions that are no expressions but solve one.
std::span<const Equation> solved_table();

/// nullptr if there is none of that name.
const Equation* find(std::string_view name);

/// The same, those that solve an expression among them.
const Equation* find_solved(std::string_view name);

}  // namespace treedyn::equations
