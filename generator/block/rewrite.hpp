// Expressions in the form that a plan wants.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "block/block.hpp"

namespace treedyn::block {

/// The transpose of `e`, pushed down to the symbols: (X Y + Z)^T = Y^T X^T + Z^T.
Expression push_transpose(const Expression& e);

/// True if only the tree decides the values: sums, products, .. of D, E, sigma, W and ones.
bool constant_expression(const Expression& e);

/// The leaf of that name.
bool is_leaf(const Expression& e, std::string_view name);
/// A leaf whose blocks stand on the diagonal in every tree: E, σ, m^d ..
bool is_diagonal_leaf(const Expression& e);
/// True if the leaf stands anywhere in e.
bool holds(const Expression& e, std::string_view name);
/// What a name stands for.
const Expression& unnamed(const Expression& e);

/// A matrix of 1x1 blocks.
bool has_numbers(const Expression& e);
/// A word of such matrices: what it multiplies may be blocks of any kind.
bool is_of_numbers(const Expression& e);
/// True if in the product of `factors` with blocks `size` high numbers made of vectors meet
/// vectors: by the size rule these factors are multiplied before they are blown up.
bool blows_up(std::span<const Expression> factors, int size);

/// e with other expressions in place of named ones. \param others  of the same shape, by name
Expression replaced(const Expression& e, const std::map<std::string, Expression>& others);

/// The operation of e, which has one operand, on x; x for a name.
Expression with_operand(const Expression& e, const Expression& x);

/// e where leaves of these names are zero; nothing where all of it is.
std::optional<Expression> without(const Expression& e, const std::set<std::string>& zeros);

/// The product of some factors, at least one.
Expression product_of(std::vector<Expression>::const_iterator begin,
                      std::vector<Expression>::const_iterator end);

/// Appends the factors of a product, names and nested products opened, to `factors` and multiplies
/// `factor` by the rational factors.
void flatten(const Expression& e, std::vector<Expression>& factors, Ratio& factor);

}  // namespace treedyn::block
