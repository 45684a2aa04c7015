// How far the coordinates of a tree reach.
#pragma once

#include <vector>

#include "model/tree.hpp"

namespace treedyn::model {

/// The longest of all offsets, m.
double size_of(const Tree& tree, const std::vector<Point>& points);

/// A change of every coordinate that matters: 1 rad, or the size of the mechanism, m.
std::vector<double> reach_of(const Tree& tree, const std::vector<Point>& points);

}  // namespace treedyn::model
