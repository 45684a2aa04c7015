// Names of values, kept while the expressions around them change.
#pragma once

#include "optimise/program_names.hpp"

namespace treedyn::optimise {

/// Values of `to` that are values of `from` take their hints, a value that is new gets the body of
/// its first user. Values are compared by `fingerprint`. O(n log n).
void transfer_hints(const Function& from, Function& to);

}  // namespace treedyn::optimise
