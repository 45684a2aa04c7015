// Pseudo-random states inside the limits of joints.
#pragma once

#include <string>
#include <vector>

#include "model/tree.hpp"
#include "program/function.hpp"

namespace treedyn::accuracy {

/// Values of the arguments of functions, one array after the other.
using Inputs = std::vector<std::vector<double>>;

/// States number 0, 1, .. of a model, the same on every machine and for every function; all numbers
/// are exact in float. Where a joint states no limit: -pi to pi rad, -1 to 1 m, rad/s, m/s, N, N m.
/// A limit of zero for speed or effort, which URDF asks for and nobody means, is none.
class States {
 public:
  explicit States(const model::Tree& tree);

  /// The arguments of a function in state `number`.
  [[nodiscard]] Inputs operator()(const program::Signature& signature, int number) const;

  /// One line: the limits that are missing and what is taken instead; "" if all are stated.
  [[nodiscard]] std::string missing() const;

 private:
  struct Range {
    double low = -1;
    double high = 1;
  };

  [[nodiscard]] const std::vector<Range>* ranges_of(const std::string& argument) const;

  std::size_t dof_;
  std::vector<Range> position_, speed_, effort_;
  std::vector<std::string> without_position_, without_speed_, without_effort_;  ///< joints
};

}  // namespace treedyn::accuracy
