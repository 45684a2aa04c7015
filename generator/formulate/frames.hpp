// Link frames in normal form: z is the joint axis, constants vanish where the frame is free, and
// inertial parameters that no joint force can feel have moved to the father (EQUATIONS.md 7.5 and
// 8).
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "formulate/find_limbs.hpp"
#include "formulate/geometry.hpp"
#include "formulate/variant.hpp"
#include "model/tree.hpp"
#include "program/function.hpp"

namespace treedyn::formulate {

/// The variant before any search.
inline Variant plain_variant(const model::Tree& tree) {
  return {.links = std::vector<LinkVariant>(tree.links.size())};
}

/// A link in its normal frame, whose z axis is the joint axis and whose origin lies on it.
struct NormalLink {
  int father = model::kGround;
  bool revolute = true;
  int sign = 1;         ///< the joint turns (slides) by sign * q about (along) z
  Matrix3 rotation{};   ///< link frame at q = 0 -> father's normal frame
  EulerZxz euler;       ///< of `rotation`
  Vector3 offset{};     ///< origin in the father's normal frame, without the slide
  Real mass = 0;        ///< regrouped: may be zero or negative
  Vector3 moment{};     ///< first moment h about the origin
  Matrix3 pseudo{};     ///< second moments Ψ = ∫ r r^T dm about the origin; I = tr(Ψ) E_3 - Ψ
  Matrix3 to_normal{};  ///< rotation: original link frame -> normal frame
  Vector3 origin{};     ///< origin of the normal frame in the original link frame
  std::vector<int> sons;
  int coordinate_sign = 1;  ///< limbs that share code: `sign` counts for this times the coordinate
};

struct NormalTree {
  std::vector<NormalLink> links;
  Vector3 gravity{};        ///< in units of length of the variant
  Vector3 ground_moment{};  ///< first moment that regrouping moved to the ground (constant part of
                            ///< the potential)
  Real unit = 1;            ///< metres per unit of length
};

/// Lengths of the robot that may serve as unit of length, ascending; empty if some joint is
/// prismatic (its coordinate is given in metres).
using UnitLengths = std::vector<program::LengthUnit>;
UnitLengths unit_lengths(const model::Tree& tree);

/// The one that a variant chooses.
program::LengthUnit unit_of(const model::Tree& tree, const Variant& variant);

/// The normal forms of one robot. What its variants have in common is worked out once.
class NormalForms {
 public:
  /// The frames of `limbs` are turned by half turns so that as many constants as possible are those
  /// of the first limb of the class; `sign` is the first limb's.
  NormalForms(const model::Tree& tree, const Vector3& gravity, const std::vector<LimbLinks>& limbs);

  /// \pre variant.links has one entry per link.
  NormalTree of(const Variant& variant);

 private:
  using Places = std::vector<std::pair<Slide, FrameAngle>>;

  const NormalTree& placed(const Variant& variant);

  const model::Tree& model_;
  std::vector<LimbLinks> limbs_;
  NormalTree start_;                     ///< frames at the joints, z along the axes
  std::map<Places, NormalTree> placed_;  ///< by what places frames; some of those asked for
  std::optional<UnitLengths> lengths_;
};

/// One of them.
inline NormalTree normal_form(const model::Tree& tree, const Vector3& gravity,
                              const Variant& variant) {
  return NormalForms(tree, gravity, {}).of(variant);
}

/// The link that carries the body of a free base.
inline constexpr int kTrunkLink = 5;

/// The condition of R13: a free base with joints at right angles, so that they move the trunk in
/// every way and follow from its motion one after the other.
bool has_trunk(const model::Tree& tree);

}  // namespace treedyn::formulate
