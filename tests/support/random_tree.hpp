// Random trees of exact numbers: the same on every machine, exactly the same robot in every scalar
// type.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::support {

/// Multiples of 1/64, from a generator of its own (the distributions of <random> differ by
/// library).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  /// 0 .. n-1
  int below(int n);
  /// In [-limit, limit], a multiple of 1/64.
  double number(double limit);
  std::vector<double> numbers(std::size_t count, double limit);

 private:
  std::uint64_t state_;
};

struct TreeShape {
  std::vector<int> father;  ///< -1: ground
  std::string types;        ///< "RPR": one letter per link
};

/// Every link on the one before.
TreeShape chain(const std::string& types);

/// Chains, trees and forests of N links by turns, types at random.
TreeShape random_shape(int links, Dice& dice);

/// General axes, rotations, offsets, centres of mass and full inertia tensors, all rational.
model::Tree random_tree(const TreeShape& shape, Dice& dice);

/// `count` points on random links and the ground, several on one link.
std::vector<model::Point> random_points(const model::Tree& tree, int count, Dice& dice);

}  // namespace treedyn::support
