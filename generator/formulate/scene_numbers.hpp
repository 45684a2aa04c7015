// The numbers of a scene that functions are made of, and what each of them is.
#pragma once

#include <functional>
#include <span>

#include "common/provenance.hpp"
#include "formulate/stand_in_numbers.hpp"
#include "model/scene.hpp"

namespace treedyn::formulate {

enum class NumberForm : std::uint8_t { kNumber, kAxis, kRotation };

/// Numbers that belong together: one, three of a unit vector, nine of a rotation.
struct SceneMeaning {
  model::SceneNumber what = model::SceneNumber::kDrive;
  int link = model::kGround;
  Dimension dimension;
  NumberForm form = NumberForm::kNumber;
};

using SeeNumbers = std::function<void(std::span<Real>, const SceneMeaning&)>;

/// Calls `see` for all of them, in the scene's order; neither those of its tree, points and gravity
/// nor exponents, times and what `step` alone needs.
void each_number(model::Scene& scene, const SeeNumbers& see);
void each_number(model::Event& event, const SeeNumbers& see);

/// Equal numbers of one group are one; those of all expressions are in one group.
int group_of(model::SceneNumber what);

/// Replaces them by what they are seen as.
void see(std::span<Real> numbers, NumberForm form, StandInNumbers& all);

}  // namespace treedyn::formulate
