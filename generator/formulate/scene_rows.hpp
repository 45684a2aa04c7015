// The constraint rows of a scene as linear equations of the accelerations, EQUATIONS.md 6.1, 6.2.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "formulate/scene_frame.hpp"
#include "formulate/scene_values.hpp"

namespace treedyn::formulate {

/// sum of columns[k] x_k + gamma = wanted.
struct Row {
  std::map<int, Expr> columns;
  Expr gamma;
  Expr wanted;
};

/// The rows of a set of constraints.
///
/// Where a point (or an orientation) is held in three orthonormal directions, the rows stand for
/// the axes of the frame F instead: an orthogonal change of the reactions, which leaves ranks and
/// minimum norms as they are. `reactions` turns them back.
class SceneRows {
 public:
  /// What the right sides of the rows of a constraint gain, along its directions; empty: nothing.
  using Correction = std::function<std::vector<Expr>(int constraint)>;

  /// \param active      indices of constraints of `scene`, ascending
  SceneRows(const model::Scene& scene, const std::vector<int>& active, const SceneFrame& frame,
            Graph& graph, const Meaning& meaning, const Correction& correction = {});

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] int size() const { return static_cast<int>(rows_.size()); }
  [[nodiscard]] std::vector<Expr> gamma() const;
  [[nodiscard]] std::vector<Expr> wanted() const;
  /// lambda in scene order for the multipliers mu of `rows`.
  [[nodiscard]] std::vector<Expr> reactions(const std::vector<Expr>& mu) const;

 private:
  void add_constraint(const model::Constraint& constraint, const std::vector<Expr>& a);
  void add_joint(const model::Constraint& constraint, const std::vector<Expr>& a);
  void add_triad(std::vector<Vec3>& directions, std::vector<Expr>& goals);
  [[nodiscard]] std::vector<Expr> wanted_of(const model::Constraint& constraint) const;

  const model::Scene& scene_;
  const SceneFrame& frame_;
  Graph& graph_;
  const Meaning& meaning_;
  std::vector<Row> rows_;
  std::vector<std::vector<Expr>> turn_;  ///< lambda_k = turn_[k] . mu[first_[k]..]
  std::vector<int> first_;
};

/// The rows of all constraints along their directions in the base frame, without what they want.
/// \pre `frame` is that of no trunk
std::vector<Row> base_rows(const model::Scene& scene, const SceneFrame& frame, Graph& graph);

}  // namespace treedyn::formulate
