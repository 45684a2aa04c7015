// Rates of composite bodies by relative speeds (F9).
#pragma once

#include <vector>

#include "derive/value.hpp"

namespace treedyn::derive {

/// Takes what turns with its link out of the rates of h^c and I^c, so that only speeds between
/// links travel; `roots` follow. Other values stay as they are.
Values with_relative_speeds(const Values& values, std::vector<int>& roots);

}  // namespace treedyn::derive
