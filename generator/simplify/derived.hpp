// Derived values in frames: from sums along the tree and steps of links to expressions.
#pragma once

#include <memory>
#include <vector>

#include "derive/derive.hpp"
#include "equations/user.hpp"
#include "simplify/functions.hpp"

namespace treedyn::simplify {

/// A function of a user: its equation and what it derives to.
struct Derived {
  equations::UserEquation equation;
  derive::Derivation derivation;
};

using DerivedFunctions = std::vector<std::shared_ptr<const Derived>>;

std::shared_ptr<const Derived> derived(const equations::UserEquation& equation, int links,
                                       int points);

/// The expressions of the function, row-major. `kinematics.variant().from_root`: all vectors in the
/// base frame; else every vector in the frame of its link.
std::vector<Expr> build_derived(const Task& task, const Derived& function);

/// Operations of every value of the derivation, before any search.
std::vector<program::Cost> costs_of_values(const model::Tree& tree,
                                           const std::shared_ptr<const Derived>& function,
                                           const Options& options);

/// The row of a function table. \pre `function` outlives it.
Recipe derived_recipe(const std::shared_ptr<const Derived>& function);

}  // namespace treedyn::simplify
