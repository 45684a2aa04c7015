// How fast expressions change by themselves, whatever the joints do.
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "simulation/state.hpp"

namespace treedyn::simulation {

/// Halvings of a step that is too long.
inline constexpr int kScaleHalvings = 20;
/// A step is short enough if max |d2e/dt2| step^2 is at most this times the range of e in it: 8
/// rad of a sine, all of a power t^k up to k = 8.
inline constexpr double kBend = 64;
/// What an expression may bend besides, as a part of its size.
inline constexpr double kFlat = 1e-4;

/// The longest step up to `longest` in which an expression bends no more than kBend says, q and qd
/// held where they are. The bounds of e and its derivatives are those of interval arithmetic, so
/// that no pulse falls between samples. `longest` where no step does: a pole, the root of zero.
double resolved_step(const model::Expression& expression, const State& state, double longest);

/// Of the forces, curves and accelerations of a scene, those that depend on t.
std::vector<model::Expression> timed_expressions(const model::Scene& scene);

}  // namespace treedyn::simulation
