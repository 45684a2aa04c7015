// The effects that a scene may name.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "model/scene.hpp"

namespace treedyn::model {

/// An effect beside its laws on joints and points (force_laws.hpp), which are found by its name.
struct EffectRow {
  std::string_view name;  ///< key of a scene file
  std::string_view brief;
  /// How many entries of the scene are its; nullptr: laws alone.
  std::size_t (*entries)(const Scene&) = nullptr;
  void (*remove)(Scene&) = nullptr;  ///< them
  bool decides_rows = false;         ///< which rows and events the scene has
};

/// What `treedyn list effects` prints, in the order of the equations of motion.
std::span<const EffectRow> effects();
/// \throws std::invalid_argument  if there is none of this name
const EffectRow& effect_named(std::string_view name);

/// How many entries of an effect the scene has.
std::size_t entries_of(const Scene& scene, std::string_view effect);
/// The scene as if the effect had never been named.
Scene without_effect(const Scene& scene, std::string_view effect);

}  // namespace treedyn::model
