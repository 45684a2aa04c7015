#include "formulate/scene_rows.hpp"

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "formulate/factored.hpp"
#include "formulate/geometry.hpp"
#include "formulate/joint_numbers.hpp"

namespace treedyn::formulate {

using model::ConstraintKind;

namespace {

/// The motions that the rows of a constraint see: of its point, and of the other that it is joined
/// to. \pre not kJoint
std::vector<MotionMap> motions_of(const model::Scene& scene, const model::Constraint& c,
                                  const SceneFrame& frame) {
  const model::Point& point = scene.points[to_index(c.point)];
  if (c.kind == ConstraintKind::kOrientation) {
    return {frame.turning(point)};
  }
  MotionMap map = frame.point(point);
  if (c.kind == ConstraintKind::kJoined) {
    return {std::move(map), frame.point(scene.points[to_index(c.other)])};
  }
  const Vec3 fall = frame.free_fall();
  map.gamma = map.gamma + fall;
  return {std::move(map)};
}

/// S: a row along each direction at the first point, against it at the second.
SparseRows directions_at(const std::vector<Vec3>& directions, std::size_t points) {
  SparseRows S(3 * points);
  for (std::size_t r = 0; r < directions.size(); ++r) {
    for (std::size_t n = 0; n < 3; ++n) {
      const Expr d = directions[r][n];
      for (std::size_t p = 0; p < points && !d.is_zero(); ++p) {
        S[3 * p + n][static_cast<int>(r)] = p == 0 ? d : -d;
      }
    }
  }
  return S;
}

/// C, or H.
SparseRows columns_of(const std::vector<MotionMap>& points, int dof) {
  SparseRows rows(to_index(dof));
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const auto& [k, column] : points[p].columns) {
      for (std::size_t n = 0; n < 3; ++n) {
        rows[to_index(k)][static_cast<int>(3 * p + n)] = column[n];
      }
    }
  }
  return rows;
}

SparseRows gamma_of(const std::vector<MotionMap>& points) {
  std::vector<Expr> column;
  for (const MotionMap& point : points) {
    column.insert(column.end(), point.gamma.begin(), point.gamma.end());
  }
  return sparse(column);
}

/// Rows along directions, without what they want: (10) and 6.2.
std::vector<Row> rows_along(const std::vector<Vec3>& directions,
                            const std::vector<MotionMap>& points, bool turning, int dof,
                            Graph& graph) {
  const auto leaf = [&](const std::string& symbol) {
    const bool acts = turning == (symbol == "H" || symbol == "S_n" || symbol == "γ_n");
    if (symbol == "C" || symbol == "H") {
      return acts ? columns_of(points, dof) : SparseRows(to_index(dof));
    }
    const bool is_S = symbol == "S_f" || symbol == "S_n";
    return !acts  ? SparseRows(3 * points.size())
           : is_S ? directions_at(directions, points.size())
                  : gamma_of(points);
  };
  const int r = static_cast<int>(directions.size());
  const Numbers jacobian(graph, dof, factored("reaction_jacobian_transpose").derivation, leaf, r);
  const Numbers bias(graph, dof, factored("reaction_bias_acceleration").derivation, leaf, r);
  std::vector<Row> rows(directions.size());
  for (int k = 0; k < dof; ++k) {
    for (const auto& [row, entry] : jacobian.root()[to_index(k)]) {
      rows[to_index(row)].columns[k] = entry;
    }
  }
  const std::vector<Expr> gamma = column_of(bias.root());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].gamma = gamma[k];
  }
  return rows;
}

/// True if the directions are an orthonormal basis.
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

}  // namespace

SceneRows::SceneRows(const model::Scene& scene, const std::vector<int>& active,
                     const SceneFrame& frame, Graph& graph, const Meaning& meaning,
                     const Correction& correction)
    : scene_(scene), frame_(frame), graph_(graph), meaning_(meaning) {
  for (const int c : active) {
    const model::Constraint& constraint = scene.constraints[to_index(c)];
    std::vector<Expr> a = wanted_of(constraint);
    const std::vector<Expr> more = correction ? correction(c) : std::vector<Expr>();
    for (std::size_t k = 0; k < more.size(); ++k) {
      a[k] += more[k];
    }
    add_constraint(constraint, a);
  }
}

/// a_des of every row.
std::vector<Expr> SceneRows::wanted_of(const model::Constraint& c) const {
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
  const bool of_point = c.kind == ConstraintKind::kPoint;
  const Vec3 a = of_point ? value_of(graph_, c.curve.acceleration, meaning_) : Vec3{};
  return transformed(c.directions,
                     [&](const model::Vector3& d) { return dot(constant(graph_, d), a); });
}

void SceneRows::add_constraint(const model::Constraint& c, const std::vector<Expr>& a) {
  if (c.kind == ConstraintKind::kJoint) {
    add_joint(c, a);
    return;
  }
  std::vector<Vec3> directions =
      transformed(c.directions, [&](const model::Vector3& d) { return frame_.direction(d); });
  std::vector<Expr> goals = a;
  const bool triad = is_triad(c.directions);
  if (triad) {
    add_triad(directions, goals);
  }
  std::vector<Row> rows = rows_along(directions, motions_of(scene_, c, frame_),
                                     c.kind == ConstraintKind::kOrientation, frame_.dof(), graph_);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!triad) {
      turn_.push_back({constant(graph_, Real(1))});
      first_.push_back(size());
    }
    rows[k].wanted = goals[k];
    rows_.push_back(std::move(rows[k]));
  }
}

void SceneRows::add_joint(const model::Constraint& c, const std::vector<Expr>& a) {
  turn_.push_back({constant(graph_, Real(1))});
  first_.push_back(size());
  rows_.push_back({{{c.joint, constant(graph_, Real(1))}}, Expr(), a.front()});
}

/// Rows along the axes of F instead: mu = sum of lambda_k d_k, so lambda_k = d_k . mu.
void SceneRows::add_triad(std::vector<Vec3>& directions, std::vector<Expr>& goals) {
  Vec3 goal;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& d = directions[k];
    const Vec3 part = goals[k] * d;
    goal = goal + part;
    turn_.push_back({d[0], d[1], d[2]});
    first_.push_back(size());
  }
  const Mat3 axes = constant(graph_, identity());
  directions.assign(axes.begin(), axes.end());
  goals.assign(goal.begin(), goal.end());
}

std::vector<Expr> SceneRows::gamma() const { return transformed(rows_, &Row::gamma); }

std::vector<Expr> SceneRows::wanted() const { return transformed(rows_, &Row::wanted); }

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
      rows.push_back({{{c.joint, constant(graph, Real(1))}}, {}, {}});
      continue;
    }
    const std::vector<Vec3> directions =
        transformed(c.directions, [&](const model::Vector3& d) { return constant(graph, d); });
    const std::vector<Row> more =
        rows_along(directions, motions_of(scene, c, frame), c.kind == ConstraintKind::kOrientation,
                   frame.dof(), graph);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace treedyn::formulate
