// The table of functions: what each is called, takes and gives, and the equation that it comes
// from.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "block/block.hpp"

namespace treedyn::equations {

/// A count: factor, factor N (degrees of freedom) or factor P (points).
struct Extent {
  enum class Of { kFixed, kPerDof, kPerPoint };
  int factor = 1;
  Of of = Of::kFixed;
  [[nodiscard]] int count(int dof, int points) const;
};

/// An array of rows x cols, row-major.
struct Argument {
  std::string_view name;
  Extent rows;
  Extent cols;
  std::string_view unit;  ///< "rad|m": of revolute and prismatic joints
  [[nodiscard]] int size(int dof, int points) const {
    return rows.count(dof, points) * cols.count(dof, points);
  }
};

struct Equation {
  std::string_view name;    ///< of the generated function
  std::string_view number;  ///< in EQUATIONS.md
  std::string_view brief;
  std::vector<Argument> inputs;
  std::vector<Argument> outputs;
  std::optional<block::Expression> expression = {};  ///< its value; of solved ones zero
  std::string_view errata =
      {};  ///< of the print that it mends beside those of its parts, EQUATIONS.md 4
  std::string_view unknown = {};  ///< what the function solves for where the expression is zero
};

/// All functions of a model, in the order of INTERFACE.md 3, further ones behind.
std::span<const Equation> functions();

/// Those that are one block expression, in that order.
std::span<const Equation> table();

/// nullptr if there is none of that name.
const Equation* find_function(std::string_view name);

/// The same of those that are one block expression.
const Equation* find(std::string_view name);

/// The same of those that are, or solve, a block expression.
const Equation* find_solved(std::string_view name);

/// True for functions that divide by the pivots of A: the only ones of a model that have no answer
/// in some positions.
bool divides_by_pivots(std::string_view name);

}  // namespace treedyn::equations
