#include "verify/scene_equations.hpp"

#include <algorithm>
#include <utility>

#include "common/index.hpp"
#include "engine/reaction_rows.hpp"
#include "model/force_laws.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::verify {

namespace {

/// Where a row of a constraint acts: along its direction, and against it at the other point.
std::vector<engine::RowPart> parts_of(const model::Constraint& c, const model::Vector3& direction) {
  const bool is_moment = c.kind == model::ConstraintKind::kOrientation;
  std::vector<engine::RowPart> parts = {{c.point, is_moment, direction}};
  if (c.kind == model::ConstraintKind::kJoined) {
    parts.push_back({c.other, false, {-direction[0], -direction[1], -direction[2]}});
    std::ranges::sort(parts, {}, &engine::RowPart::point);
  }
  return parts;
}

}  // namespace

SceneEquations::SceneEquations(const model::Scene& scene, Values q, Values qd, const Real& t,
                               Values anchor)
    : scene_(scene),
      q_(std::move(q)),
      qd_(std::move(qd)),
      anchor_(std::move(anchor)),
      t_(t),
      dof_(scene.tree.dof()) {
  anchor_.resize(to_index(model::anchor_offset(scene, static_cast<int>(scene.constraints.size()))));
  engine::Engine<Real> engine(scene.tree, scene.points, scene.gravity);
  const Values a = engine.evaluate("mass_matrix", {q_});
  for (int i = 0; i < dof_; ++i) {
    A_.emplace_back(a.begin() + i * dof_, a.begin() + (i + 1) * dof_);
  }
  for (const model::Armature& armature : scene.armatures) {
    A_[to_index(armature.joint)][to_index(armature.joint)] += armature.inertia;
  }
  const Values rates = scene.velocity_products ? qd_ : Values(qd_.size());
  bias_ = engine.evaluate("inverse_dynamics", {q_, rates, Values(qd_.size())});
  if (!scene.points.empty()) {
    C_ = engine.evaluate("force_jacobian_transpose", {q_});
    H_ = engine.evaluate("moment_jacobian_transpose", {q_});
    p_ = engine.evaluate("point_positions", {q_});
    v_ = engine.evaluate("point_velocities", {q_, qd_});
    R_ = engine.evaluate("point_rotations", {q_});
  }
  evaluate_rows(rates);
}

/// J of 6.2, and γ with these rates, of all constraints; a joint's own row is a unit row.
void SceneEquations::evaluate_rows(const Values& rates) {
  std::vector<std::vector<engine::RowPart>> parts;
  std::vector<Row*> of_points;
  for (const model::Constraint& c : scene_.constraints) {
    rows_.emplace_back(c.rows(), Row{Values(to_index(dof_)), 0, 0});
  }
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    const model::Constraint& constraint = scene_.constraints[c];
    for (std::size_t k = 0; k < rows_[c].size(); ++k) {
      if (constraint.kind == model::ConstraintKind::kJoint) {
        rows_[c][k].J[to_index(constraint.joint)] = 1;
      } else {
        of_points.push_back(&rows_[c][k]);
        parts.push_back(parts_of(constraint, constraint.directions[k]));
      }
    }
  }
  if (of_points.empty()) {
    return;
  }
  engine::ReactionRows<Real> rows(scene_.tree, scene_.points, parts);
  rows.set(q_, rates);
  const Values columns = rows.jacobian_transpose();
  const Values gamma = rows.bias_acceleration();
  for (std::size_t r = 0; r < of_points.size(); ++r) {
    for (std::size_t i = 0; i < of_points[r]->J.size(); ++i) {
      of_points[r]->J[i] = columns[i * of_points.size() + r];
    }
    of_points[r]->gamma = gamma[r];
  }
}

Real SceneEquations::variable(const model::Variable& v, int point) const {
  switch (v.quantity) {
    case model::Quantity::kTime:
      return t_;
    case model::Quantity::kPosition:
      return q_[to_index(v.index)];
    case model::Quantity::kVelocity:
      return qd_[to_index(v.index)];
    case model::Quantity::kPointPosition:
      return p_[to_index(3 * point + v.index)];
    default:
      TREEDYN_EXPECT(v.quantity == model::Quantity::kPointVelocity);
      return v_[to_index(3 * point + v.index)];
  }
}

Real SceneEquations::value(const model::Expression& expression, int point) const {
  return expression.evaluate<Real>([](const Real& x) { return x; },
                                   [&](const model::Variable& v) { return variable(v, point); });
}

std::vector<SceneEquations::Row> SceneEquations::rows(const std::vector<int>& active) const {
  std::vector<Row> result;
  for (const int c : active) {
    const model::Constraint& constraint = scene_.constraints[to_index(c)];
    for (std::size_t k = 0; k < constraint.rows(); ++k) {
      result.push_back(rows_[to_index(c)][k]);
      result.back().wanted = wanted(constraint, k);
      if (model::is_stabilised(scene_, c)) {
        result.back().wanted += correction(result.back(), c, k);
      }
    }
  }
  return result;
}

Real SceneEquations::wanted(const model::Constraint& c, std::size_t k) const {
  if (!c.accelerations.empty()) {
    return value(c.accelerations[k], c.point);
  }
  if (c.kind == model::ConstraintKind::kJoint) {
    return value(c.curve.acceleration[0], c.point);
  }
  Real sum = 0;
  for (std::size_t n = 0; n < 3 && c.kind == model::ConstraintKind::kPoint; ++n) {
    sum += c.directions[k][n] * value(c.curve.acceleration[n], c.point);
  }
  return sum;
}

/// sin(angle) axis of the turn from `anchor` to the point's rotation.
model::Vector3 SceneEquations::turn_from(const Real* anchor, int point) const {
  const auto E = [&](std::size_t i, std::size_t k) {
    Real sum = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      sum += R_[9 * to_index(point) + 3 * i + n] * anchor[3 * k + n];
    }
    return sum;
  };
  return {(E(2, 1) - E(1, 2)) / 2, (E(0, 2) - E(2, 0)) / 2, (E(1, 0) - E(0, 1)) / 2};
}

Real SceneEquations::position_error(int constraint, std::size_t k) const {
  const model::Constraint& c = scene_.constraints[to_index(constraint)];
  const bool has_place = model::has_place(scene_, constraint);
  const Real* anchor =
      has_place ? c.loop->data() : anchor_.data() + model::anchor_offset(scene_, constraint);
  const bool has_anchor = has_place || model::anchor_size(scene_, constraint) > 0;
  if (c.kind == model::ConstraintKind::kJoint) {
    const Real off = q_[to_index(c.joint)] - value(c.curve.position[0], 0);
    return has_anchor ? Real(off - anchor[0]) : off;
  }
  const bool turning = c.kind == model::ConstraintKind::kOrientation;
  const model::Vector3 turn = turning ? turn_from(anchor, c.point) : model::Vector3{};
  Real phi = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    Real off = turning ? turn[n] : p_[3 * to_index(c.point) + n];
    if (c.kind == model::ConstraintKind::kJoined) {
      off -= p_[3 * to_index(c.other) + n];
    } else if (!turning) {
      off -= value(c.curve.position[n], c.point);
      off -= has_anchor ? anchor[n] : Real(0);
    }
    phi += c.directions[k][n] * off;
  }
  return phi;
}

/// -2 alpha (J qd - c') - alpha^2 phi.
Real SceneEquations::correction(const Row& row, int constraint, std::size_t k) const {
  const model::Constraint& c = scene_.constraints[to_index(constraint)];
  Real rate = 0;
  for (std::size_t i = 0; i < row.J.size(); ++i) {
    rate += row.J[i] * qd_[i];
  }
  if (c.kind == model::ConstraintKind::kJoint) {
    rate -= value(c.curve.velocity[0], 0);
  }
  for (std::size_t n = 0; n < 3 && c.kind == model::ConstraintKind::kPoint; ++n) {
    rate -= c.directions[k][n] * value(c.curve.velocity[n], c.point);
  }
  const Real alpha = model::stabilisation_rate(scene_);
  return -(2 * alpha * rate + alpha * alpha * position_error(constraint, k));
}

void SceneEquations::add_joint_forces(Values& force) const {
  for (int joint = 0; joint < scene_.tree.dof(); ++joint) {
    for (const model::Expression& law : model::joint_forces(scene_, joint)) {
      force[to_index(joint)] += value(law, 0);
    }
  }
}

/// C f, or H n.
void SceneEquations::apply(const model::Vector3& value, int point, const Values& jacobian,
                           Values& force) const {
  const std::size_t width = 3 * scene_.points.size();
  for (std::size_t i = 0; i < force.size(); ++i) {
    for (std::size_t n = 0; n < 3; ++n) {
      force[i] += jacobian[i * width + 3 * to_index(point) + n] * value[n];
    }
  }
}

SceneEquations::Values SceneEquations::force() const {
  Values force(to_index(dof_));
  add_joint_forces(force);
  for (const model::PointLaw& law : scene_.point_laws) {
    const model::Vector3 components = {value(law.value[0], law.point),
                                       value(law.value[1], law.point),
                                       value(law.value[2], law.point)};
    apply(components, law.point, law.is_moment ? H_ : C_, force);
  }
  return force;
}

Real SceneEquations::normal_speed(const model::GroundContact& contact) const {
  Real sum = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    sum += contact.plane.normal[n] * v_[3 * to_index(contact.point) + n];
  }
  return sum;
}

Real SceneEquations::in_contact(const model::Expression& law, const model::GroundContact& contact,
                                const Real& depth, const Real& press) const {
  return law.evaluate<Real>([](const Real& x) { return x; },
                            [&](const model::Variable& v) -> Real {
                              switch (v.quantity) {
                                case model::Quantity::kDepth:
                                  return depth;
                                case model::Quantity::kRaisedDepth:
                                  return pow(depth, contact.exponent);
                                case model::Quantity::kNormalSpeed:
                                  return normal_speed(contact);
                                case model::Quantity::kPress:
                                  return press;
                                default:
                                  return variable(v, contact.point);
                              }
                            });
}

Real SceneEquations::contact_law(const model::GroundContact& contact, const Real& depth) const {
  return in_contact(model::normal_law(contact), contact, depth, 0);
}

SceneEquations::Values SceneEquations::contact(const model::GroundContact& contact,
                                               const Real& normal) const {
  const model::VectorExpression law = model::contact_force(contact);
  model::Vector3 f;
  for (std::size_t n = 0; n < 3; ++n) {
    f[n] = in_contact(law[n], contact, 0, normal);
  }
  Values force(to_index(dof_));
  apply(f, contact.point, C_, force);
  return force;
}

}  // namespace treedyn::verify
