// Limbs: equal subtrees of one father, which may share code.
#pragma once

#include <string>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::formulate {

/// Limbs of one structure: the links of every limb, fathers first; same place, same joint.
using LimbLinks = std::vector<std::vector<int>>;

/// Shape of the subtree of every link, as text: links with equal text can be treated alike.
std::vector<std::string> subtree_shapes(const model::Tree& tree);

/// Links of equal depth and equal subtree shape: the same joint of similar limbs.
std::vector<std::vector<int>> similar_links(const model::Tree& tree);

/// Sons of one father (or of the ground) with subtrees of equal shape, outermost classes only:
/// limbs of limbs are not looked for. Limbs with mimic joints are left out.
std::vector<LimbLinks> find_limbs(const model::Tree& tree);

}  // namespace treedyn::formulate
