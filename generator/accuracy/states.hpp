// Pseudo-random states inside the limits of joints.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "accuracy/interval.hpp"
#include "model/tree.hpp"
#include "program/function.hpp"

namespace treedyn::accuracy {

/// Values of the arguments of functions, one array after the other.
using Inputs = std::vector<std::vector<double>>;

/// The elements of arguments, numbered array after array, that a function depends on; of angles
/// those that anything but a sine or cosine takes, too.
struct Dependence {
  std::set<int> inputs;
  std::set<int> as_they_are;
};

/// States number 0, 1, .. of a model, the same on every machine and for every function; all numbers
/// are exact in float. Where a joint states no limit: -pi to pi rad, -1 to 1 m, rad/s, m/s, N, N m.
/// A limit of zero for speed or effort, and a lower limit of position that is not below the upper,
/// which URDF asks for and nobody means, are none.
class States {
 public:
  explicit States(const model::Tree& tree);

  /// The arguments of a function in state `number`.
  [[nodiscard]] Inputs operator()(const program::Signature& signature, int number) const;

  /// The range of every element of the arguments, array after array: all states are inside.
  [[nodiscard]] std::vector<Interval> ranges(const program::Signature& signature) const;

  /// Of what a function depends on: elements whose ranges are not limits of the model, "q of lift,
  /// qd of any joint, qdd"; "" if there are none. An angle of which sine and cosine are taken,
  /// nothing else, needs no limits.
  [[nodiscard]] std::string assumed(const program::Signature& signature,
                                    const Dependence& on) const;

  /// One line: the limits that are missing and what is taken instead; "" if all are stated.
  [[nodiscard]] std::string missing() const;

 private:
  struct Range {
    double low = -1;
    double high = 1;
  };

  [[nodiscard]] bool is_assumed(const std::string& argument, std::size_t i, bool as_it_is) const;
  [[nodiscard]] const std::vector<Range>* ranges_of(const std::string& argument) const;

  std::size_t dof_;
  std::vector<std::string> joints_;
  std::vector<bool> turns_;  ///< revolute
  std::vector<Range> position_, speed_, effort_;
  std::vector<std::string> without_position_, without_speed_, without_effort_;  ///< joints
};

}  // namespace treedyn::accuracy
