#include "formulate/scene_drift.hpp"

#include "common/index.hpp"
#include "formulate/derived.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::formulate {

using model::Constraint;
using model::ConstraintKind;
using model::Scene;

namespace {

/// Errors of a constraint's motion, along x, y, z of the base frame; of a joint the first.
struct Errors {
  Vec3 position;
  Vec3 velocity;
};

/// A constraint and where its anchor stands.
class Drift {
 public:
  Drift(const Task& task, const SceneForces& forces, int constraint, int anchor)
      : task_(task),
        forces_(forces),
        graph_(task.kinematics.graph()),
        scene_(*task.options.scene),
        number_(constraint),
        constraint_(scene_.constraints[to_index(constraint)]),
        size_(anchor_size(scene_, constraint)),
        offset_(anchor_offset(scene_, constraint)),
        anchor_(anchor) {}

  [[nodiscard]] Errors errors() const {
    switch (constraint_.kind) {
      case ConstraintKind::kPoint:
        return of_point();
      case ConstraintKind::kOrientation:
        return of_orientation();
      case ConstraintKind::kJoined:
        return of_joined();
      case ConstraintKind::kJoint:
        break;
    }
    return of_joint();
  }

  /// What becomes of the anchor if the constraint begins to act now.
  [[nodiscard]] std::vector<Expr> now() const {
    if (size_ == 0) {
      return {};
    }
    if (constraint_.kind == ConstraintKind::kOrientation) {
      return rotation();
    }
    if (constraint_.kind == ConstraintKind::kJoint) {
      const Expr place = forces_.meaning()({model::Quantity::kPosition, constraint_.joint});
      return {place - curve(constraint_.curve.position)[0]};
    }
    const Vec3 p = forces_.position(constraint_.point);
    const Vec3 place = p - curve(constraint_.curve.position);
    return {place.begin(), place.end()};
  }

 private:
  [[nodiscard]] Expr anchor(int element) const {
    if (has_place(scene_, number_)) {
      return constant(graph_, constraint_.loop->at(to_index(element)));
    }
    return element < size_ ? Expr(graph_, graph_.input(anchor_, offset_ + element)) : Expr();
  }

  [[nodiscard]] Vec3 curve(const model::VectorExpression& of_time) const {
    return value_of(graph_, of_time, forces_.meaning());
  }

  [[nodiscard]] std::vector<Expr> rotation() const {
    return point_rotations(task_.kinematics, {scene_.points[to_index(constraint_.point)]});
  }

  /// p - c - anchor, v - c'.
  [[nodiscard]] Errors of_point() const {
    const Vec3 start = {anchor(0), anchor(1), anchor(2)};
    const Vec3 p = forces_.position(constraint_.point);
    const Vec3 v = forces_.velocity(constraint_.point);
    const Vec3 off = p - curve(constraint_.curve.position);
    return {off - start, v - curve(constraint_.curve.velocity)};
  }

  /// sin(angle) axis of the turn from the anchor, and the angular velocity.
  [[nodiscard]] Errors of_orientation() const {
    const std::vector<Expr> R = rotation();
    const auto E = [&](int i, int k) {  // R anchor^T
      Expr sum;
      for (int n = 0; n < 3; ++n) {
        sum += R[to_index(3 * i + n)] * anchor(3 * k + n);
      }
      return sum;
    };
    const auto half_difference = [&](int i, int k) {
      const Expr forth = E(i, k);
      const Expr back = E(k, i);
      return constant(graph_, Real("0.5")) * (forth - back);
    };
    const Expr x = half_difference(2, 1);
    const Expr y = half_difference(0, 2);
    const Expr z = half_difference(1, 0);
    return {{x, y, z}, forces_.angular_velocity(constraint_.point)};
  }

  [[nodiscard]] Errors of_joined() const {
    const Vec3 p = forces_.position(constraint_.point);
    const Vec3 other = forces_.position(constraint_.other);
    const Vec3 v = forces_.velocity(constraint_.point);
    const Vec3 other_v = forces_.velocity(constraint_.other);
    return {p - other, v - other_v};
  }

  [[nodiscard]] Errors of_joint() const {
    const Expr q = forces_.meaning()({model::Quantity::kPosition, constraint_.joint});
    const Expr qd = forces_.meaning()({model::Quantity::kVelocity, constraint_.joint});
    const Expr off = q - curve(constraint_.curve.position)[0];
    const Expr rate = qd - curve(constraint_.curve.velocity)[0];
    return {{off - anchor(0), Expr(), Expr()}, {rate, Expr(), Expr()}};
  }

  const Task& task_;
  const SceneForces& forces_;
  Graph& graph_;
  const Scene& scene_;
  int number_;
  const Constraint& constraint_;
  int size_;
  int offset_;
  int anchor_;
};

}  // namespace

std::vector<Expr> build_anchors(const Task& task) {
  const SceneForces forces(task, {.qd = -1, .tau = -1, .t = 1});
  std::vector<Expr> result;
  for (int c = 0; c < static_cast<int>(task.options.scene->constraints.size()); ++c) {
    const std::vector<Expr> now = Drift(task, forces, c, -1).now();
    result.insert(result.end(), now.begin(), now.end());
  }
  return result;
}

std::vector<Expr> drift_corrections(const Task& task, const SceneForces& forces, int constraint,
                                    int anchor) {
  const Scene& scene = *task.options.scene;
  const Constraint& c = scene.constraints[to_index(constraint)];
  Graph& graph = task.kinematics.graph();
  const Errors errors = Drift(task, forces, constraint, anchor).errors();
  const Real alpha = stabilisation_rate(scene);
  const Expr damping = constant(graph, 2 * alpha);
  const Expr stiffness = constant(graph, alpha * alpha);
  std::vector<Expr> result;
  for (std::size_t k = 0; k < c.rows(); ++k) {
    const bool joint = c.kind == ConstraintKind::kJoint;
    const Vec3 d = constant(graph, joint ? model::Vector3{1, 0, 0} : c.directions[k]);
    const Expr rate = dot(d, errors.velocity);
    const Expr phi = dot(d, errors.position);
    const Expr damped = damping * rate;
    result.push_back(-(damped + stiffness * phi));
  }
  return result;
}

}  // namespace treedyn::formulate
