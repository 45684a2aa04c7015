// Expressions in the form that a plan wants.
#pragma once

#include <vector>

#include "block/block.hpp"

namespace treedyn::block {

/// The transpose of `e`, pushed down to the symbols: (X Y + Z)^T = Y^T X^T + Z^T.
Expression push_transpose(const Expression& e);

/// True if only the tree decides the values: sums, products, .. of D, E, sigma, W and ones.
bool constant_expression(const Expression& e);

/// Appends the factors of a product, names and nested products opened, to `factors` and multiplies
/// `factor` by the rational factors.
void flatten(const Expression& e, std::vector<Expression>& factors, Ratio& factor);

}  // namespace treedyn::block
