// A scene: a tree and exactly the effects that act on it, checked once. What does not act is not in
// it: an empty list, a zero, `velocity_products` false.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/expression.hpp"
#include "model/tree.hpp"

namespace treedyn::model {

/// Three components, base frame.
using VectorExpression = std::array<Expression, 3>;

/// Where a point shall be: expressions of t alone, with their derivatives.
struct Curve {
  VectorExpression position;      ///< m
  VectorExpression velocity;      ///< d/dt
  VectorExpression acceleration;  ///< d2/dt2
};

enum class ConstraintKind {
  kPoint,        ///< a point follows its curve along `directions`
  kOrientation,  ///< the link of a point keeps its orientation about `directions`
  kJoined,       ///< two points coincide along `directions`
  kJoint,        ///< a joint follows `curve.position[0]`: locked, or led; one row, no direction
};

/// Bilateral rows, one per direction; their reactions act on the link of `point`.
struct Constraint {
  std::string name;
  ConstraintKind kind = ConstraintKind::kPoint;
  int point = 0;   ///< of Scene::points
  int other = -1;  ///< kJoined: the second point, its link takes the opposite reactions
  int joint = -1;  ///< kJoint
  std::vector<Vector3> directions;  ///< base frame
  Curve curve;                      ///< kPoint, kJoint
  /// The curve moves to where the point (the joint) is whenever the constraint begins to act.
  bool pinned = false;
  /// Empty, or one per row: the row states its acceleration J qdd + gamma instead, of t, q, qd; it
  /// has no position error and is not stabilised.
  std::vector<Expression> accelerations;
  /// Set where its rows are spare ones of a closed loop that generated steps draw together: how its
  /// point is at the initial state, position less curve (3, m) or rotation (9); empty: led by its
  /// curve.
  std::optional<std::vector<Real>> loop;

  bool sticks = false;  ///< kJoint: dry friction that holds the joint

  [[nodiscard]] std::size_t rows() const {
    return kind == ConstraintKind::kJoint ? 1 : directions.size();
  }
};

/// What an effect does to one joint (model/force_laws.hpp), of t, q and qd.
struct JointLaw {
  std::string_view effect;  ///< name of a row in effects.hpp
  int joint = 0;
  Expression force;   ///< N m or N
  Expression energy;  ///< J, that it stores, of q
};

/// A force at a point, or a moment on its link, by an effect (model/force_laws.hpp); of t, q, qd
/// and the position and velocity of the point.
struct PointLaw {
  std::string_view effect;  ///< name of a row in effects.hpp
  int point = 0;
  bool is_moment = false;
  VectorExpression value;  ///< N or N m, base frame
  Expression energy;       ///< J, that it stores, of the position
  Expression tension;      ///< N, of a spring, towards its anchor
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
  Real stiffness = 0;             ///< k
  Real exponent = 1;              ///< n
  Real dissipation = 0;           ///< c, s/m
  Real friction = 0;              ///< mu
  Real slip_speed = 0;            ///< vs, m/s; positive if mu is
  std::optional<Expression> law;  ///< f of depth and normal speed instead; f >= 0 still
};

/// Dry friction of a joint, exact: it sticks while the holding force is below `force`.
struct DryFriction {
  int joint = 0;
  Real force = 0;  ///< N m or N
};

/// Reflected inertia of a rotor: A_jj grows by it.
struct Armature {
  int joint = 0;
  Real inertia = 0;  ///< kg m^2 or kg
};

/// Velocities jump such that the rows of `constraints` move with -restitution times their speed,
/// those of `held` as before.
struct Impact {
  std::vector<int> constraints;  ///< those that strike; of a scene in YAML also all that act before
                                 ///< and behind it
  Real restitution = 0;
  Real rest_below = 0;         ///< m/s; a slower rebound is rest: the rows become active
  std::vector<int> held = {};  ///< those that are led before, through and behind it
};

enum class EventKind {
  kHeight,  ///< the height of `point` over `plane` crosses zero downwards: touch-down
  /// plane.normal . (force of `constraint`) + plane.height becomes negative: lift-off; of a joint
  /// normal[0] is the factor
  kReaction,
  kTime,        ///< the phase has lasted `not_before`
  kExpression,  ///< `value` of t, q, qd crosses zero downwards
};

/// What ends a phase.
struct Event {
  EventKind kind = EventKind::kHeight;
  int point = 0;
  int constraint = -1;
  Plane plane;
  Expression value;     ///< falls through zero
  bool rises = false;   ///< `value` is the negative of what the scene says
  Real not_before = 0;  ///< s after the phase began
  std::optional<Impact> impact;
  std::vector<int> pins;  ///< constraints whose curve moves to where their points are
  int then = 0;           ///< the next phase
  int stops = -1;         ///< the joint whose velocity is zero behind it
  bool goes_on = false;   ///< the next phase lasts since this one began
};

/// A constant force of a joint.
struct JointForce {
  int joint = 0;
  Real force = 0;  ///< N m or N
};

struct Phase {
  std::string name;
  std::vector<int> active;  ///< constraints, ascending
  std::vector<Event> until;
  std::vector<JointForce> forces = {};  ///< that act in it alone
};

/// What is done about the drift of constraints, and its names, in their order.
enum class Drift { kNone, kBaumgarte, kProjection };
inline constexpr std::array<std::string_view, 3> kDriftNames = {"none", "baumgarte", "projection"};
inline std::optional<Drift> drift_of(std::string_view name) {
  const auto found = std::ranges::find(kDriftNames, name);
  return found == kDriftNames.end()
             ? std::nullopt
             : std::optional(static_cast<Drift>(found - kDriftNames.begin()));
}

/// Shorter steps that look for an event, and events of one step, at most.
inline constexpr int kMostCuts = 16;
/// Parts of one step, at most.
inline constexpr int kMostParts = 1000;

/// How a scene is stepped.
struct Stepping {
  std::string integrator = "fehlberg78";
  Location where;            ///< of the integrator's name
  Real step = Real("1e-3");  ///< s, methods with fixed steps
  int cuts = 3;  ///< generated steps: shorter steps that look for an event; 0: at the end
  /// Generated steps: events of one step, at most; 0: 3, and 1 + 2 n if n > 1 joints may stick,
  /// each of which stops and slips before the others have found their ways.
  int events = 0;
  int parts = 64;  ///< generated steps: of one in which the angles of a free body turn far, at most
  /// Generated steps: what rounding takes from the state is kept and added in the next step.
  bool compensated = false;
  Real tolerance = Real("1e-10");  ///< error of a step, relative and absolute, adaptive methods
  Drift drift = Drift::kProjection;
  Real stabilisation = 20;  ///< alpha of Baumgarte, 1/s
  Real output_step = 0;     ///< s between printed states; 0: duration/500
};

struct Scene {
  std::string name;
  Tree tree;
  std::string tree_file;  ///< path that `tree` was read from; empty: the scene's own file
  bool declares_parameters = false;  ///< that are known at run time only, or its model does
  Vector3 gravity{};                 ///< zero: off
  bool velocity_products = true;     ///< false: B(q, qd) and gamma are dropped, quasi-static
  std::vector<Real> q0;
  std::vector<Real> qd0;
  std::vector<Real> tau;  ///< constant joint forces; empty: none
  Real t0 = 0;
  Real duration = 0;
  std::vector<Point> points;  ///< where constraints, forces and events act
  std::vector<Constraint> constraints;
  std::vector<JointLaw> joint_laws;
  std::vector<PointLaw> point_laws;
  std::vector<GroundContact> contacts;
  std::vector<DryFriction> frictions;
  std::vector<Armature> armatures;
  /// Joints with drives; nothing said: those of the effect `drive`, or all but a free base.
  std::optional<std::vector<int>> actuated;
  std::vector<Phase> phases;  ///< at least one
  int start_phase = 0;
  /// Joints whose dry friction is told by phases, which come in threes: at rest, forth, back;
  /// those of the first joint are neighbours. Empty: it is not told.
  std::vector<int> sticking;
  /// Pivots of K = J A^-1 J^T below this multiple of their own diagonal entry count as zero; 0:
  /// what rounding makes uncertain.
  Real rank_tolerance = 0;
  Stepping stepping;
};

}  // namespace treedyn::model
