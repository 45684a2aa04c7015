// Functions to try the passes on.
#pragma once

#include <cstdint>
#include <vector>

#include "program/function.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"

namespace treedyn::program {

/// Sums and products of q[0..3], qd[0..3] and constants with much in common, `size` operations.
Function random_function(std::uint64_t seed, int size);
/// Torques of a planar arm with three parallel joints, written without care for its cost.
Function planar_arm();
/// Forces of a chain of `links` links with joints about z, x, z, ..., Newton-Euler in link frames.
Function spatial_chain(int links);

/// Largest difference of the outputs of two functions with the same signature, relative to the
/// largest output, 50 digits, at `states` random inputs.
Real largest_difference(const Function& a, const Function& b, int states = 3);
/// Largest error of double evaluation, relative to the largest output.
double rounding_error(const Function& function, int states = 20);

template <class Scalar>
std::vector<Scalar> evaluate_at_random(const Function& function, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<Scalar>> values;
  for (const Array& array : function.signature.inputs) {
    auto& of_array = values.emplace_back();
    for (int i = 0; i < array.size; ++i) {
      of_array.push_back(Scalar(random.symmetric() * 3));
    }
  }
  std::vector<std::span<const Scalar>> spans(values.begin(), values.end());
  return interpret<Scalar>(function, spans);
}

}  // namespace treedyn::program
