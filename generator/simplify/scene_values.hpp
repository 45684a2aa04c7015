// Expressions of a scene as values of a program.
#pragma once

#include <functional>

#include "model/scene.hpp"
#include "simplify/spatial.hpp"

namespace treedyn::simplify {

/// What a variable of an expression is in the program.
using Meaning = std::function<Expr(const model::Variable&)>;

/// The value of `expression`; operations are made in the order of its program.
Expr value_of(Graph& graph, const model::Expression& expression, const Meaning& meaning);

}  // namespace treedyn::simplify
