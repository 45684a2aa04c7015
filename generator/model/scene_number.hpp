// What the numbers of a scene are: how comments call them, and their units.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/provenance.hpp"

namespace treedyn::model {

/// Those of expressions come first.
enum class SceneNumber : std::uint8_t {
  kDrive,
  kLoad,
  kCurve,
  kLaw,
  kEvent,
  kDirection,
  kStart,
  kStiffness,
  kDamping,
  kRest,
  kAnchor,
  kGroundNormal,
  kGroundHeight,
  kGroundStiffness,
  kDissipation,
  kFriction,
  kSlipSpeed,
  kViscousFriction,
  kDryFriction,
  kStaticFriction,
  kStribeckSpeed,
  kArmature,
  kJointForce,
  kEventNormal,
  kEventHeight,
  kRestitution,
  kStabilisation
};
inline constexpr SceneNumber kLastOfExpressions = SceneNumber::kEvent;

struct SceneNumberRow {
  SceneNumber number = SceneNumber::kDrive;
  const char* word = "";
  Dimension dimension;  ///< of a point, or of a joint that slides
  Dimension turns;      ///< of a joint that turns
};

inline constexpr Dimension kAnyUnit = {0, 0, 0, false};
inline constexpr Dimension kNoUnit = {0, 0, 0};

/// In the order of SceneNumber.
inline constexpr std::array<SceneNumberRow, 27> kSceneNumbers = {{
    {SceneNumber::kDrive, "drive", kAnyUnit, kAnyUnit},
    {SceneNumber::kLoad, "load", kAnyUnit, kAnyUnit},
    {SceneNumber::kCurve, "curve", kAnyUnit, kAnyUnit},
    {SceneNumber::kLaw, "law", kAnyUnit, kAnyUnit},
    {SceneNumber::kEvent, "event", kAnyUnit, kAnyUnit},
    {SceneNumber::kDirection, "direction", kNoUnit, kNoUnit},
    {SceneNumber::kStart, "start", {0, 1, 0}, kNoUnit},
    {SceneNumber::kStiffness, "spring stiffness", {1, 0, -2}, {1, 2, -2}},
    {SceneNumber::kDamping, "spring damping", {1, 0, -1}, {1, 2, -1}},
    {SceneNumber::kRest, "spring rest", {0, 1, 0}, kNoUnit},
    {SceneNumber::kAnchor, "spring anchor", {0, 1, 0}, kNoUnit},
    {SceneNumber::kGroundNormal, "ground normal", kNoUnit, kNoUnit},
    {SceneNumber::kGroundHeight, "ground height", {0, 1, 0}, kNoUnit},
    {SceneNumber::kGroundStiffness, "ground stiffness", kAnyUnit, kAnyUnit},  // by its exponent
    {SceneNumber::kDissipation, "dissipation", {0, -1, 1}, kNoUnit},
    {SceneNumber::kFriction, "friction coefficient", kNoUnit, kNoUnit},
    {SceneNumber::kSlipSpeed, "slip speed", {0, 1, -1}, {0, 0, -1}},
    {SceneNumber::kViscousFriction, "viscous friction", {1, 0, -1}, {1, 2, -1}},
    {SceneNumber::kDryFriction, "dry friction", {1, 1, -2}, {1, 2, -2}},
    {SceneNumber::kStaticFriction, "static friction", {1, 1, -2}, {1, 2, -2}},
    {SceneNumber::kStribeckSpeed, "stribeck speed", {0, 1, -1}, {0, 0, -1}},
    {SceneNumber::kArmature, "armature", {1, 0, 0}, {1, 2, 0}},
    {SceneNumber::kJointForce, "joint force", {1, 1, -2}, {1, 2, -2}},
    {SceneNumber::kEventNormal, "event normal", kNoUnit, kNoUnit},
    {SceneNumber::kEventHeight, "event height", {0, 1, 0}, kNoUnit},
    {SceneNumber::kRestitution, "restitution", kNoUnit, kNoUnit},
    {SceneNumber::kStabilisation, "stabilisation", {0, 0, -1}, {0, 0, -1}},
}};

static_assert([] {
  std::size_t k = 0;
  for (const SceneNumberRow& row : kSceneNumbers) {
    if (static_cast<std::size_t>(row.number) != k++) {
      return false;
    }
  }
  return k == static_cast<std::size_t>(SceneNumber::kStabilisation) + 1;
}());

constexpr const SceneNumberRow& row_of(SceneNumber number) {
  return kSceneNumbers[static_cast<std::size_t>(number)];
}

}  // namespace treedyn::model
