// R1': sums over all links let paths take over from sums over subtrees.
#pragma once

#include <optional>

#include "derive/value.hpp"

namespace treedyn::derive {

/// The number `root` without the sums over subtrees that it is linear in; nothing if there are
/// none.
std::optional<int> transposed(Values& values, int root);

}  // namespace treedyn::derive
