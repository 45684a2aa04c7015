#include "formulate/scene_rank.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "common/index.hpp"
#include "formulate/functions.hpp"
#include "model/reach.hpp"
#include "model/scene_facts.hpp"
#include "program/interpret.hpp"

namespace treedyn::formulate {

namespace {

using Doubles = std::vector<double>;
using model::ConstraintKind;

}  // namespace

/// p (3 P), C and H (N x 3 P), R (9 P).
struct ScenePositions::Place {
  Doubles q, p, C, H, R;
};

ScenePositions::ScenePositions(const model::Scene& scene)
    : scene_(scene), reach_(model::reach_of(scene.tree, scene.points)) {
  std::ranges::transform(scene.q0, std::back_inserter(q0_),
                         [](const Real& x) { return x.convert_to<double>(); });
  q0_.resize(to_index(scene.tree.dof()));
  if (!scene.points.empty()) {
    for (const char* name : {"point_positions", "force_jacobian_transpose",
                             "moment_jacobian_transpose", "point_rotations"}) {
      functions_.push_back(plain_function(scene, name));
    }
  }
}

ScenePositions::Place ScenePositions::place(const Doubles& q) const {
  Place result{q, {}, {}, {}, {}};
  const std::vector<std::span<const double>> inputs = {q};
  const std::array<Doubles*, 4> arrays = {&result.p, &result.C, &result.H, &result.R};
  for (std::size_t k = 0; k < functions_.size(); ++k) {
    *arrays[k] = program::interpret<double>(functions_[k], inputs);
  }
  return result;
}

double ScenePositions::curve(const model::Expression& of_time) const {
  return of_time.evaluate([&](const model::Variable&) { return scene_.t0.convert_to<double>(); });
}

/// Component n of the angles from `start` to `at`, in the base frame, as long as they are small.
double ScenePositions::turned(int point, std::size_t n, const Place& at, const Place& start) {
  const std::size_t first = 9 * to_index(point);
  const std::size_t i = (n + 2) % 3;
  const std::size_t j = (n + 1) % 3;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {  // (R R_0^T)_ij - (R R_0^T)_ji
    sum += at.R[first + 3 * i + k] * start.R[first + 3 * j + k] -
           at.R[first + 3 * j + k] * start.R[first + 3 * i + k];
  }
  return sum / 2;
}

/// Position error and J of one row. Rows about one or two directions have no angle to return to.
void ScenePositions::add_row(int constraint, std::size_t row, const Place& at, const Place& start,
                             double& phi, double* J) const {
  const model::Constraint& c = scene_.constraints[to_index(constraint)];
  const bool held = c.accelerations.empty() && !model::is_placed_by_events(scene_, constraint);
  if (c.kind == ConstraintKind::kJoint) {
    const double goal = c.pinned ? start.q[to_index(c.joint)] : curve(c.curve.position[0]);
    phi = held ? at.q[to_index(c.joint)] - goal : 0;
    J[c.joint] = 1;
    return;
  }
  const std::size_t width = 3 * scene_.points.size();
  for (std::size_t n = 0; n < 3; ++n) {
    const double d = c.directions[row][n].convert_to<double>();
    const std::size_t column = 3 * to_index(c.point) + n;
    const std::size_t other = 3 * to_index(std::max(c.other, 0)) + n;
    const bool joined = c.kind == ConstraintKind::kJoined;
    const Doubles& map = c.kind == ConstraintKind::kOrientation ? at.H : at.C;
    for (std::size_t i = 0; i < at.q.size(); ++i) {
      J[i] += d * (map[i * width + column] - (joined ? map[i * width + other] : 0));
    }
    if (held && c.kind == ConstraintKind::kOrientation) {
      phi += c.rows() == 3 ? d * turned(c.point, n, at, start) : 0;
    } else if (held) {
      const double goal = joined     ? at.p[other]
                          : c.pinned ? start.p[column]
                                     : curve(c.curve.position[n]);
      phi += d * (at.p[column] - goal);
    }
  }
}

program::OrdinaryRows ScenePositions::ordinary(const std::vector<int>& constraints,
                                               const std::vector<int>& columns) const {
  const Place start = place(q0_);
  program::ConstraintRows rows;
  rows.columns = scene_.tree.dof();
  const double size = model::size_of(scene_.tree, scene_.points);
  for (const int c : constraints) {
    const model::Constraint& constraint = scene_.constraints[to_index(c)];
    rows.rows += static_cast<int>(constraint.rows());
    rows.scales.resize(to_index(rows.rows), model::is_angular(scene_.tree, constraint) ? 1 : size);
  }
  rows.evaluate = [&](const Doubles& q, Doubles& phi, Doubles& J) {
    const Place at = place(q);
    std::size_t k = 0;
    for (const int c : constraints) {
      for (std::size_t row = 0; row < scene_.constraints[to_index(c)].rows(); ++row, ++k) {
        add_row(c, row, at, start, phi[k], J.data() + k * q.size());
      }
    }
  };
  return program::ordinary_rows(rows, q0_, reach_, columns);
}

}  // namespace treedyn::formulate
