// What a description and the command line declare as known at run time only.
#pragma once

#include <string>
#include <vector>

#include "description/raw_tree.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// Fills `tree.parameters`: those of the file, then those of `list`
/// (ReadOptions::runtime). \pre links and frames of the tree are complete
/// \throws InputError for an unknown quantity, a link that is unknown or does not move, what is
/// declared twice, and fields whose identifiers are equal
void resolve_parameters(const RawTree& raw, const std::vector<std::string>& list,
                        model::Tree& tree);

}  // namespace treedyn::description
