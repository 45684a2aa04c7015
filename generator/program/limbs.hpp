// Leaves of the limbs that share code: what differs from limb to limb.
#pragma once

#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// Input arrays kLimbInputs + a of a graph: element k is element k of argument a of the function,
/// times the sign of coordinate k in `LimbJoint`.
inline constexpr int kLimbInputs = 1 << 16;

/// A joint of a limb: the limbs of a class are equal functions of sign * u[coordinate].
struct LimbJoint {
  int coordinate = 0;
  int sign = 1;
};

/// Limbs of one structure. Their constants that differ are the columns of a table with one row a
/// limb; in a graph column k of limb l of class c is element k * limbs + l of array
/// kFixedArrays + c.
struct LimbClass {
  std::vector<std::vector<int>> links;         ///< by limb, then place in the limb
  std::vector<std::vector<LimbJoint>> joints;  ///< by limb, then place in the limb
  std::vector<std::vector<Real>> columns;      ///< by column, then limb

  [[nodiscard]] int size() const { return static_cast<int>(joints.size()); }
};
using Limbs = std::vector<LimbClass>;

/// The number that is values[l] in limb l, for `limb`: a constant if all are equal, else the leaf
/// of a column, which is appended where neither it nor its negative is in the table.
Ref limb_constant(Graph& graph, Limbs& limbs, int limb_class, int limb,
                  const std::vector<Real>& values);

/// The same function where everything that needs no argument is a constant or a leaf again, and
/// such factors and terms of one value are merged. O(size of the graph).
Function fold_limb_constants(const Function& function, Limbs& limbs);

}  // namespace treedyn::program
