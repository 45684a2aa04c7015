// Where a value may differ from zero, seen from the column that is asked for.
#pragma once

#include "derive/value.hpp"

namespace treedyn::derive {

/// Links as link j of the column sees them.
struct Places {
  bool here = false;    ///< j
  bool above = false;   ///< on the way from j to the root
  bool below = false;   ///< in the subtree of j
  bool beside = false;  ///< anywhere else
};

/// A superset of the links at which value `x` is not zero, if the rows on the way from j to the
/// root are enough to compute those rows of it.
/// \throws NoComposites if they are not: something comes up from below, from beside or from points
Places places(const Values& values, int x);

}  // namespace treedyn::derive
