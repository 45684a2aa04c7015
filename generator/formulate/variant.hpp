// The free choices of a formulation: none changes a result, all change its cost.
#pragma once

#include <cstdint>
#include <vector>

#include "common/real.hpp"

namespace treedyn::formulate {

/// Place of a revolute link's origin along its axis.
enum class Slide : std::uint8_t { kAuto, kNone, kFather, kSon };
/// Angle of a link frame about its own axis, chosen so that a constant vanishes.
enum class FrameAngle : std::uint8_t { kAuto, kFirstMoment, kProductXy, kProductXz, kKeep };
/// How much mass a revolute link passes to its father (EQUATIONS.md 8): all of it, or as much as
/// makes the x, y or z component of the father's first moment vanish, none, or no parameter at all.
enum class MassGauge : std::uint8_t { kAll, kCancelX, kCancelY, kCancelZ, kKeepMass, kNothing };
/// What regrouping makes of a link's Ψ_zz = ∫ z² dm (EQUATIONS.md 8): 0, -Ψ_xx, -Ψ_yy, or what it
/// was.
enum class TensorGauge : std::uint8_t { kZz, kZzPlusXx, kZzPlusYy, kKeep };

/// Where the vectors of derived functions stand: in link frames, those of points carried to the
/// root joint by joint, or turned into the base frame by rotation matrices; all in the base frame.
enum class Way : std::uint8_t { kToRoot, kInLinks, kInBase };

/// The choices for one link.
struct LinkVariant {
  Slide slide = Slide::kAuto;
  FrameAngle angle = FrameAngle::kAuto;
  MassGauge mass = MassGauge::kAll;
  TensorGauge tensor = TensorGauge::kZz;
  /// In a run of parallel axes that starts here: the number of links whose turns the common frame
  /// follows; kWholeRun: all.
  std::uint8_t cut = kWholeRun;
  bool merge_parallel = true;  ///< share the father's frame if the axes are parallel
  bool column_of_father =
      true;  ///< third column of Omega by rotating the father's (cheaper than its own product)
  bool tensor_moment = false;  ///< link moment by the inertia tensor instead of the pseudo-inertia

  static constexpr std::uint8_t kWholeRun = 255;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a pointer in <=>
  auto operator<=>(const LinkVariant&) const = default;
};

/// One formulation of one function.
struct Variant {
  std::vector<LinkVariant> links;
  int unit_length = 0;          ///< 0: metre; k: the k-th of `unit_lengths`, a length of the robot
  bool add_angles = true;       ///< sin(a + b) instead of sin a cos b + cos a sin b
  bool inertia_tensor = false;  ///< composite bodies by inertia tensors instead of pseudo-inertias
  bool trunk = true;            ///< a free base is treated as one body with six velocities
  Way way = Way::kToRoot;
  bool articulated = false;  ///< forward dynamics by articulated bodies instead of factoring A
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a pointer in <=>
  auto operator<=>(const Variant&) const = default;
};

}  // namespace treedyn::formulate
