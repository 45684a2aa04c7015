// A robot as a tree of Orocos KDL.
#pragma once

#include <kdl/tree.hpp>
#include <string>
#include <vector>

#include "oracle/recursive.hpp"

namespace treedyn::oracle {

/// Name of the segment of a body, -1: the ground.
std::string kdl_name(int body);

/// One segment a body. \throws std::runtime_error if KDL refuses one.
KDL::Tree kdl_tree(const Robot<double>& robot);

/// Body -> number of its joint: KDL numbers joints in its own order.
std::vector<unsigned> kdl_places(const KDL::Tree& tree, std::size_t bodies);

}  // namespace treedyn::oracle
