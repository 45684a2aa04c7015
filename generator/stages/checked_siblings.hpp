// Functions that can fail, and their siblings that tell so (`--checked`).
#pragma once

#include <vector>

#include "pipeline.hpp"

namespace treedyn {

/// Ordinary positions, one q a state.
std::vector<std::vector<double>> ordinary_states(const Model& model);

/// The siblings of those of `functions` that can fail, in their order.
std::vector<emit::Checked> checked_siblings(const Model& model,
                                            const std::vector<program::Function>& functions);

}  // namespace treedyn
