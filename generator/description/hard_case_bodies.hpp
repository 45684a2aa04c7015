// The bodies of a case of hard_cases as a tree description.
#pragma once

#include "description/raw_tree.hpp"
#include "description/yaml_node.hpp"

namespace treedyn::description {

/// Bodies numbered from 1 with joint, axis, offset, R0, mass, com and inertia; father 0 is the
/// ground. Link k is body k + 1. \throws InputError
RawTree read_bodies(const std::string& file, const Node& model, const std::string& name);

}  // namespace treedyn::description
