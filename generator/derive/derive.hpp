// The derivation: a block expression becomes sums along the tree and steps of single links.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "block/block.hpp"
#include "derive/value.hpp"

namespace treedyn::derive {

/// What an expression derives to. Its columns (or rows) are `roots`: one for every column of a
/// single block; if the columns count links or points, `roots` holds one that depends on kUnit, the
/// column that is asked for.
struct Derivation {
  block::Shape shape;
  bool by_rows = false;  ///< the roots are the rows, as columns
  bool by_units = false;
  bool symmetric =
      false;          ///< the root has the rows from the column that is asked for to the ground
  bool wide = false;  ///< the column that is asked for is one of 3x3 blocks: E at one place
  Values values;
  std::vector<int> roots;
  bool elimination = false;  ///< by R9
};

/// \param by_rows  of matrices whose both sides count links or points; not where their columns are
/// 3x3 blocks of a kind
/// \param keeps_joints  places P_i of sliding joints are asked for
Derivation derive(const block::Expression& expression, bool by_rows, bool keeps_joints = true);

/// The rows of a single column, three at once; nothing of numbers.
std::optional<Derivation> derive_rows(const block::Expression& column, bool keeps_joints = true);

/// The numbers of links x for which `system`, a column A x + b, is zero, by R9. Nothing if A is not
/// symmetric or if joints do not either turn or slide.
std::optional<Derivation> solved(const Derivation& system, const std::string& x);

/// Numbers of links, points and rows, and matrices of them; of symmetric matrices the lower half.
struct Factored {
  Derivation derivation;  ///< the unknown; of A = L^T Δ L: L, Δ, Δ^-1
  std::vector<std::pair<std::string, block::Expression>> given;  ///< leaves that stand for these
};

/// The unknown for which `equation` is zero, by R12: A x + b, A X - E, A - L^T Δ L, with factors L,
/// or L x + b and L^T x + b. Nothing for other equations or if A is not symmetric.
std::optional<Factored> factored(const block::Expression& equation, const std::string& unknown);

/// A sum of products with S, the directions of rows at points: what S multiplies is given. Nothing
/// for other expressions.
std::optional<Factored> with_directions(const block::Expression& e);

/// The unknowns for which a motion A x - J^T λ - r and its rows J x - s are zero, by R12'': the
/// lower half of K and b of K λ = b, and x, which is made of λ. Nothing for other equations or if A
/// is not symmetric.
std::optional<Factored> constrained(const block::Expression& motion, const block::Expression& rows,
                                    const std::string& unknown, const std::string& reaction);

/// The least unknown for which `equation`, M λ - s, is zero, by R12''': the lower half of K and b
/// of K μ = b, λ, and `remainder`, a column that takes λ. Nothing for other equations.
std::optional<Factored> least(const block::Expression& equation, const block::Expression& remainder,
                              const std::string& unknown, const std::string& multiplier);

/// The rate along q̇ of what is derived, its own values beside their rates. Nothing if places of
/// joints are asked for, or if it is made of others than constants of links, sums over subtrees and
/// products.
std::optional<Derivation> rate(const Derivation& derivation);

}  // namespace treedyn::derive
