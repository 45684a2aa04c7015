// (2) by composite bodies: D^T X D as subtree sums, EQUATIONS.md 7.3.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "simplify/kinematics.hpp"

namespace treedyn::simplify {

/// Symmetric matrix by (row, column) with row >= column; entries that are structurally zero are
/// absent.
using SparseSymmetric = std::map<std::pair<int, int>, Expr>;

/// A(q) entry by entry. O(N) subtree sums and O(sum of depths) entries.
SparseSymmetric mass_matrix(const Kinematics& kinematics);

/// The columns of A for the joints of the limbs and the composite body of the trunk of a free base.
struct Trunk {
  /// Force and moment that a unit acceleration of a joint needs, at the trunk's origin, in its
  /// frame.
  struct Column {
    int joint = 0;
    Vec3 force;
    Vec3 moment;
  };
  SparseSymmetric limbs;        ///< A between joints of the limbs
  std::vector<Column> columns;  ///< joints of the limbs, descending
  Kinematics::Body body;        ///< everything that moves
};
Trunk trunk_composite(const Kinematics& kinematics);

/// The base axes of a free base, seen from the trunk.
struct BaseAxes {
  std::array<Vec3, 3> sliding;  ///< axes of joints 0..2
  Vec3 first;                   ///< axis of joint 3
  Vec3 second;                  ///< axis of joint 4
};
BaseAxes base_axes(const Kinematics& kinematics);

/// A(q) for a free base: the trunk's columns projected on the base axes.
SparseSymmetric mass_matrix_by_trunk(const Kinematics& kinematics);

}  // namespace treedyn::simplify
