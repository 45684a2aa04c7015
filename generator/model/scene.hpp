// A scene: a tree and exactly the effects that act on it, checked once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/tree.hpp"

namespace treedyn::model {

/// c(t) = center + velocity t + A1 cos(omega t + phase) u + A2 sin(omega t + phase) v, base frame.
struct Curve {
  Vector3 center{};
  Vector3 velocity{};
  Vector3 u{};
  Vector3 v{};
  Real A1 = 0;
  Real A2 = 0;
  Real omega = 0;  ///< rad/s
  Real phase = 0;  ///< rad
};

enum class ConstraintKind {
  kPoint,        ///< a point follows its curve along `directions`
  kOrientation,  ///< the link of a point keeps its orientation about `directions`
  kJoined,       ///< two points coincide along `directions`
};

/// Bilateral rows, one per direction; their reactions act on the link of `point`.
struct Constraint {
  std::string name;
  ConstraintKind kind = ConstraintKind::kPoint;
  int point = 0;   ///< of Scene::points
  int other = -1;  ///< kJoined: the second point, its link takes the opposite reactions
  std::vector<Vector3> directions;  ///< base frame
  Curve curve;                      ///< kPoint
};

/// tau = -stiffness (q - rest) - damping qd.
struct JointSpring {
  int joint = 0;
  Real stiffness = 0;
  Real damping = 0;
  Real rest = 0;
};

/// Force along the line from an anchor, -stiffness (l - rest_length) - damping l'.
struct PointSpring {
  int point = 0;
  Vector3 anchor{};
  Real stiffness = 0;
  Real damping = 0;
  Real rest_length = 0;
};

/// A constant moment on the link of a point, or a constant force at the point, base frame.
struct PointLoad {
  int point = 0;
  Vector3 value{};
};

/// height(p) = normal . p - height.
struct Plane {
  Vector3 normal{};
  Real height = 0;
};

/// Compliant ground: depth d = -height(p) > 0, f = k d^n (1 - c normal.v), f >= 0, along the
/// normal; tangential -mu f vt / sqrt(vt^2 + vs^2).
struct GroundContact {
  int point = 0;
  Plane plane;
  Real stiffness = 0;    ///< k
  Real exponent = 1;     ///< n
  Real dissipation = 0;  ///< c, s/m
  Real friction = 0;     ///< mu
  Real slip_speed = 0;   ///< vs, m/s; positive if mu is
};

/// Dry friction of a joint, exact: sticks while the holding force is below `force`.
struct JointFriction {
  int joint = 0;
  Real force = 0;  ///< N m or N
};

/// Velocities jump such that the rows of `constraints` move with -restitution times their speed.
struct Impact {
  std::vector<int> constraints;
  Real restitution = 0;
  Real rest_below = 0;  ///< m/s; a slower rebound is rest: the rows become active
};

/// The height of a point over a plane crosses zero downwards.
struct Event {
  int point = 0;
  Plane plane;
  Real not_before = 0;  ///< s after the phase began
  std::optional<Impact> impact;
  std::vector<int> pins;  ///< constraints whose curve moves to where their points are
  int then = 0;           ///< the next phase
};

struct Phase {
  std::string name;
  std::vector<int> active;  ///< constraints, ascending
  std::vector<Event> until;
};

struct Scene {
  std::string name;
  Tree tree;
  Vector3 gravity{};
  std::vector<Real> q0;
  std::vector<Real> qd0;
  std::vector<Real> tau;  ///< constant joint forces; empty: none
  Real t0 = 0;
  Real duration = 0;
  std::vector<Point> points;  ///< where constraints, forces and events act
  std::vector<Constraint> constraints;
  std::vector<JointSpring> joint_springs;
  std::vector<PointSpring> point_springs;
  std::vector<PointLoad> torques;
  std::vector<PointLoad> forces;
  std::vector<GroundContact> contacts;
  std::vector<JointFriction> frictions;
  std::vector<Phase> phases;  ///< at least one
  int start_phase = 0;
};

}  // namespace treedyn::model
