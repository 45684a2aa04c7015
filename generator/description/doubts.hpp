// What a model can be read with and is likely a slip: for `treedyn vet`.
#pragma once

#include <string>
#include <vector>

#include "common/error.hpp"
#include "description/raw_tree.hpp"
#include "description/vectors.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

class Doubts {
 public:
  explicit Doubts(const RawTree& raw) : raw_(raw) {}

  /// Degrees where radians belong.
  void of_angles(const Vector3& rpy, const Numbers& written, const std::string& what);
  /// Degrees, sizes below zero, limits that leave one position.
  void of_limits(const RawJoint& joint, const std::string& name, const model::Limits& limits);
  /// A mass with zeros for its tensor, a tensor without a mass, other units.
  /// \param bodies  of the links of the file
  /// \param offset  the longest of joints, m
  void of_inertias(const std::vector<model::Inertia>& bodies, const Real& offset);

  [[nodiscard]] const std::vector<Warning>& all() const { return findings_; }

 private:
  void of_inertia(const RawLink& link, const model::Inertia& body, const Real& others);

  const RawTree& raw_;
  std::vector<Warning> findings_;
};

}  // namespace treedyn::description
