// Robots of any size.
#pragma once

#include <string>

namespace treedyn::benchmark {

/// A tree description (YAML) of `size` links: a chain, or a binary tree. Revolute joints about z, y
/// and x in turn along a path, no quantity zero by symmetry but the products of inertia.
std::string growing_robot(bool chain, int size);

}  // namespace treedyn::benchmark
