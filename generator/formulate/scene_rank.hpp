// The rank that a scene's rows have where its constraints hold.
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "program/function.hpp"
#include "program/row_rank.hpp"

namespace treedyn::formulate {

/// The rows of a scene in any position, by its points and their Jacobians.
class ScenePositions {
 public:
  explicit ScenePositions(const model::Scene& scene);

  /// Where some constraints hold near the initial state. A pinned one holds where that state has
  /// it, and so does an orientation; what events place (a foot, where it lands) holds anywhere.
  /// \param columns  joints whose columns of J count; empty: all
  [[nodiscard]] program::OrdinaryRows ordinary(const std::vector<int>& constraints,
                                               const std::vector<int>& columns = {}) const;

 private:
  struct Place;
  [[nodiscard]] Place place(const std::vector<double>& q) const;
  static double turned(int point, std::size_t n, const Place& at, const Place& start);
  void add_row(int constraint, std::size_t row, const Place& at, const Place& start, double& phi,
               double* J) const;
  [[nodiscard]] double curve(const model::Expression& of_time) const;

  const model::Scene& scene_;
  std::vector<program::Function> functions_;  ///< p, C, H, R of all points
  std::vector<double> q0_;
  std::vector<double> reach_;
};

}  // namespace treedyn::formulate
