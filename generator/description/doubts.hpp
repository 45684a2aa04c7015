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
  /// \param bodies   of the links of the file
  /// \param offset   the longest of joint frames on the links that carry them, m
  /// \param offsets  of the joints of the file as they are written, m; 0: on what does not move
  void of_inertias(const std::vector<model::Inertia>& bodies, const Real& offset,
                   const std::vector<Real>& offsets);

  [[nodiscard]] const std::vector<Warning>& all() const { return findings_; }

 private:
  /// The lengths of a robot that those of one link or joint are held against, m.
  struct Scale {
    Real distance = 0;  ///< the second largest offset or distance of a center of mass
    Real radius = 0;    ///< the largest radius of gyration of bodies that are not thin
    bool thin = false;  ///< all bodies are
    [[nodiscard]] bool is_far(const Real& length) const;
  };
  static Scale scale_of(const std::vector<model::Inertia>& bodies,
                        const std::vector<Real>& offsets);

  void of_inertia(const RawLink& link, const model::Inertia& body, const Real& others,
                  const Scale& scale);
  void of_offsets(const std::vector<Real>& offsets, const Scale& scale);

  const RawTree& raw_;
  std::vector<Warning> findings_;
};

}  // namespace treedyn::description
