// A function with other inputs.
#pragma once

#include <functional>
#include <vector>

#include "optimise/program_names.hpp"

namespace treedyn::optimise {

/// The given outputs in a graph of their own, where `leaf` makes the inputs.
Function rewritten(const Function& function, const std::vector<Ref>& outputs,
                   const std::function<Ref(const Node&, Graph&)>& leaf);

}  // namespace treedyn::optimise
