// How fast expressions change with time and with the joints.
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "simulation/forces.hpp"
#include "simulation/state.hpp"

namespace treedyn::simulation {

/// Halvings of a step that is too long.
inline constexpr int kScaleHalvings = 20;
/// A step is short enough if max |d2e/dt2| step^2 is at most this times the range of e in it: 8
/// rad of a sine, all of a power t^k up to k = 8.
inline constexpr double kBend = 64;
/// What an expression may bend besides, as a part of its size.
inline constexpr double kFlat = 1e-4;
/// Nor does it matter within this part of the largest size that it has had.
inline constexpr double kNothing = 1e-10;

/// Coordinates along a step, from places x at speeds v: joints, behind them x, y, z of the points.
struct Motion {
  double t = 0;
  int joints = 0;
  Vector x, v;
  Vector least, most;  ///< bounds of the accelerations
  Vector rate;         ///< of these, on the average
};

/// As all move now, which a step has yet to show. \param a  of the joints
Motion going_on(double t, const Vector& x, const Vector& v, const Vector& a);
/// As they have moved, from `begin`. \param middle, end  speeds in the step of length h
Motion gone(double h, const Motion& begin, const Vector& middle, const Vector& end);

/// An expression, and what it belongs to.
struct Changing {
  model::Expression value;
  int point = -1;         ///< -1: none
  PlaneValues plane{{}};  ///< of the depth of this point
  double most = 0;        ///< its largest size so far
};

/// The longest step up to `longest` in which an expression bends no more than kBend says. The
/// bounds of e and its derivatives are those of interval arithmetic, so that no pulse falls between
/// samples. `longest` where no step does: a pole that stays, the root of zero.
double resolved_step(Changing& changing, const Motion& motion, double longest);

/// Of the forces, laws, curves and accelerations of a scene, those that are not constant.
std::vector<Changing> changing_expressions(const model::Scene& scene);

}  // namespace treedyn::simulation
