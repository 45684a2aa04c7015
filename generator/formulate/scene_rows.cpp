#include "formulate/scene_rows.hpp"

#include "common/index.hpp"
#include "formulate/geometry.hpp"

namespace treedyn::formulate {

using model::ConstraintKind;

namespace {

MotionMap difference(MotionMap a, const MotionMap& b) {
  for (const auto& [k, column] : b.columns) {
    Vec3& sum = a.columns[k];
    sum = sum - column;
  }
  a.gamma = a.gamma - b.gamma;
  return a;
}

/// One component of a motion: of an axis of F, or along a direction.
template <class Component>
Row row_of(const MotionMap& map, Expr wanted, Component component) {
  Row row;
  for (const auto& [k, column] : map.columns) {
    const Expr entry = component(column);
    if (!entry.is_zero()) {
      row.columns[k] = entry;
    }
  }
  const Expr gamma = component(map.gamma);
  row.right = wanted - gamma;
  return row;
}

/// The motion that the rows of a constraint see. \pre not kJoint
MotionMap motion_of(const model::Scene& scene, const model::Constraint& c,
                    const SceneFrame& frame) {
  const model::Point& point = scene.points[to_index(c.point)];
  if (c.kind == ConstraintKind::kOrientation) {
    return frame.turning(point);
  }
  MotionMap map = frame.point(point);
  if (c.kind == ConstraintKind::kJoined) {
    return difference(std::move(map), frame.point(scene.points[to_index(c.other)]));
  }
  const Vec3 fall = frame.free_fall();
  map.gamma = map.gamma + fall;
  return map;
}

}  // namespace

bool is_triad(const std::vector<model::Vector3>& directions) {
  if (directions.size() != 3) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = i; k < 3; ++k) {
      const Real off = dot(directions[i], directions[k]) - (i == k ? 1 : 0);
      if (abs(off) > Real("1e-30")) {
        return false;
      }
    }
  }
  return true;
}

SceneRows::SceneRows(const model::Scene& scene, const std::vector<int>& active,
                     const SceneFrame& frame, Graph& graph, const Meaning& meaning,
                     const Correction& correction)
    : scene_(scene), frame_(frame), graph_(graph), meaning_(meaning) {
  for (const int c : active) {
    const model::Constraint& constraint = scene.constraints[to_index(c)];
    std::vector<Expr> a = wanted(constraint);
    const std::vector<Expr> more = correction ? correction(c) : std::vector<Expr>();
    for (std::size_t k = 0; k < more.size(); ++k) {
      a[k] += more[k];
    }
    add_constraint(constraint, a);
  }
}

/// a_des of every row.
std::vector<Expr> SceneRows::wanted(const model::Constraint& c) const {
  std::vector<Expr> result;
  for (const model::Expression& a : c.accelerations) {
    result.push_back(value_of(graph_, a, meaning_));
  }
  if (!result.empty()) {
    return result;
  }
  if (c.kind == ConstraintKind::kJoint) {
    return {value_of(graph_, c.curve.acceleration[0], meaning_)};
  }
  Vec3 a;
  for (std::size_t n = 0; n < 3 && c.kind == ConstraintKind::kPoint; ++n) {
    a[n] = value_of(graph_, c.curve.acceleration[n], meaning_);
  }
  for (const model::Vector3& d : c.directions) {
    result.push_back(dot(constant(graph_, d), a));
  }
  return result;
}

void SceneRows::add_constraint(const model::Constraint& c, const std::vector<Expr>& a) {
  if (c.kind == ConstraintKind::kJoint) {
    add_joint(c, a);
    return;
  }
  const MotionMap map = motion_of(scene_, c, frame_);
  direction_.clear();
  for (const model::Vector3& d : c.directions) {
    direction_.push_back(frame_.direction(d));
  }
  if (is_triad(c.directions)) {
    add_triad(map, a);
  } else {
    add_directions(map, a);
  }
}

void SceneRows::add_joint(const model::Constraint& c, const std::vector<Expr>& a) {
  turn_.push_back({constant(graph_, Real(1))});
  first_.push_back(size());
  rows_.push_back({{{c.joint, constant(graph_, Real(1))}}, a.front()});
}

/// Rows along the axes of F: mu = sum of lambda_k d_k, so lambda_k = d_k . mu.
void SceneRows::add_triad(const MotionMap& map, const std::vector<Expr>& a) {
  Vec3 goal;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 part = a[k] * direction_[k];
    goal = goal + part;
    const Vec3& d = direction_[k];
    turn_.push_back({d[0], d[1], d[2]});
    first_.push_back(size());
  }
  for (std::size_t n = 0; n < 3; ++n) {
    rows_.push_back(row_of(map, goal[n], [n](const Vec3& v) { return v[n]; }));
  }
}

void SceneRows::add_directions(const MotionMap& map, const std::vector<Expr>& a) {
  for (std::size_t k = 0; k < direction_.size(); ++k) {
    const Vec3 d = direction_[k];
    turn_.push_back({constant(graph_, Real(1))});
    first_.push_back(size());
    rows_.push_back(row_of(map, a[k], [&d](const Vec3& v) { return dot(d, v); }));
  }
}

std::vector<Expr> SceneRows::reactions(const std::vector<Expr>& mu) const {
  std::vector<Expr> lambda;
  for (std::size_t k = 0; k < turn_.size(); ++k) {
    Expr sum;
    for (std::size_t n = 0; n < turn_[k].size(); ++n) {
      sum += turn_[k][n] * mu[to_index(first_[k]) + n];
    }
    lambda.push_back(sum);
  }
  return lambda;
}

std::vector<Row> base_rows(const model::Scene& scene, const SceneFrame& frame, Graph& graph) {
  std::vector<Row> rows;
  for (const model::Constraint& c : scene.constraints) {
    if (c.kind == ConstraintKind::kJoint) {
      rows.push_back({{{c.joint, constant(graph, Real(1))}}, Expr()});
      continue;
    }
    const MotionMap map = motion_of(scene, c, frame);
    for (const model::Vector3& direction : c.directions) {
      const Vec3 d = constant(graph, direction);
      rows.push_back(row_of(map, Expr(), [&d](const Vec3& v) { return dot(d, v); }));
    }
  }
  return rows;
}

}  // namespace treedyn::formulate
