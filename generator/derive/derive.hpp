// The derivation: a block expression becomes sums along the tree and steps of single links.
#pragma once

#include <optional>
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
};

/// \param by_rows  of matrices whose both sides count links or points; not where their columns are
/// 3x3 blocks of a kind
/// \param keeps_joints  places P_i of sliding joints are asked for
Derivation derive(const block::Expression& expression, bool by_rows, bool keeps_joints = true);

/// The rows of a single column of vectors, three at once; nothing if their blocks have no kind.
std::optional<Derivation> derive_rows(const block::Expression& column);

}  // namespace treedyn::derive
