// Findings about a model that can be read.
#pragma once

#include "description/read.hpp"

namespace treedyn::description {

/// Adds to `vetted.findings` the warnings of the tree, bodies without extent and joints without
/// inertia.
void vet_tree(Vetted& vetted);

}  // namespace treedyn::description
