// One order of nodes, whatever the order in which a compiler evaluates operands.
#pragma once

#include "program/function.hpp"

namespace treedyn::program {

/// The same function with the nodes of every section (`Graph::section`) in an order that follows
/// from their structure alone; what no output needs is left out. C++ leaves open which operand of
/// a + b is made first: without this, node numbers, signs and text would depend on the compiler
/// that built the program. O(n log n).
Function canonical(const Function& function);

}  // namespace treedyn::program
