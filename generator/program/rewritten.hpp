// Copies of functions in which something else stands in the place of some values.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "program/function.hpp"

namespace treedyn::program {

/// The given outputs in a graph of their own; the other members are those of `function`.
/// \param replaced  makes there what stands in the place of a node of `function`; nothing: its copy
Function rewritten(const Function& function, const std::vector<Ref>& outputs,
                   const std::function<std::optional<Ref>(Ref, Graph&)>& replaced);

/// The given outputs in a graph of their own, where `input` makes the inputs.
Function with_inputs(const Function& function, const std::vector<Ref>& outputs,
                     const std::function<Ref(const Node&, Graph&)>& input);

}  // namespace treedyn::program
