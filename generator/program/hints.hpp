// Names of values, kept while the expressions around them change.
#pragma once

#include "program/function.hpp"

namespace treedyn::program {

/// Nodes of `to` that have the value of a node of `from` take its hint, those of the opposite value
/// its body; a value that is new gets the body of its first user. Values are compared by
/// `fingerprint`. O(n log n).
void transfer_hints(const Function& from, Function& to);

}  // namespace treedyn::program
