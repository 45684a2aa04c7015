// Expressions of a scene as values of a program.
#pragma once

#include <functional>

#include "formulate/spatial.hpp"
#include "model/scene.hpp"

namespace treedyn::formulate {

/// What a variable of an expression is in the program.
using Meaning = std::function<Expr(const model::Variable&)>;

/// The value of `expression`; operations are made in the order of its program.
Expr value_of(Graph& graph, const model::Expression& expression, const Meaning& meaning);
Vec3 value_of(Graph& graph, const model::VectorExpression& expression, const Meaning& meaning);

}  // namespace treedyn::formulate
