// Functions of numbers of joints: factors of A, what they solve, the inverse (R12).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/index.hpp"
#include "formulate/derived.hpp"

namespace treedyn::formulate {

/// What R12 makes of an equation. Leaves are `given`, E, or the last argument of the function; of
/// functions of scenes also S, what is given for the rows, and λ.
struct FactoredFunction {
  derive::Derivation derivation;
  std::vector<std::pair<std::string, std::shared_ptr<const Derived>>> given;
};
/// \pre `name` stands in equations::functions() and solves an equation, or is a function of scenes
/// with equations.
const FactoredFunction& factored(const std::string& name);

/// What it is given for a leaf. \pre there is such a leaf, not of rows
const Derived& given(const std::string& function, const std::string& leaf);

/// The expressions of the function, in the independent coordinates.
std::vector<Expr> build_factored(const Task& task, const std::string& name);

/// Operations of every value of the derivation, before any search.
std::vector<program::Cost> costs_of_numbers(const model::Tree& tree, const std::string& name,
                                            const Options& options);

}  // namespace treedyn::formulate
