// Rows of reactions evaluated with numbers, EQUATIONS.md 6.2.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "block/evaluate.hpp"
#include "engine/tree_leaves.hpp"
#include "equations/equations.hpp"

namespace treedyn::engine {

/// Where a part of a row acts: at a point along a direction of the base frame that stays, as a
/// force or a moment.
struct RowPart {
  int point = 0;
  bool is_moment = false;
  model::Vector3 direction{};
};

/// Evaluates J^T and γ of rows for a tree; coordinates are independent ones.
template <class Scalar>
class ReactionRows {
 public:
  /// \param rows  the parts of each, their points ascending, none twice
  ReactionRows(const model::Tree& tree, std::span<const model::Point> points,
               const std::vector<std::vector<RowPart>>& rows)
      : plan_(index_of(tree, points, rows)),
        jacobian_(plan_.add(equations::reaction_jacobian_transpose())),
        bias_(plan_.add(equations::reaction_bias_acceleration())),
        evaluation_(plan_),
        leaves_(tree, points, {}, evaluation_),
        rows_(rows.size()) {
    fill("u", Scalar(0));
    for (const char* leaf : {"S_f", "S_n", "Ṡ_f", "Ṡ_n"}) {
      fill(leaf, Scalar(0));
    }
    write_directions(rows);
  }

  void set(std::span<const Scalar> q, std::span<const Scalar> qd) {
    leaves_.set("q", q);
    leaves_.set("qd", qd);
    evaluation_.run(plan_.needed({jacobian_, bias_}));
  }

  /// J^T, N x r, row-major. \pre set
  [[nodiscard]] std::vector<Scalar> jacobian_transpose() {
    const Coordinates<Scalar>& coordinates = leaves_.coordinates();
    const std::vector<Scalar> full = value(jacobian_, leaves_.constants().links.size(),
                                           equations::reaction_jacobian_transpose().shape());
    std::vector<Scalar> result(static_cast<std::size_t>(coordinates.dof()) * rows_);
    (void)coordinates.reduce(Reduction::kRows, full, rows_, result);
    return result;
  }
  /// γ, r. \pre set
  [[nodiscard]] std::vector<Scalar> bias_acceleration() {
    return value(bias_, 1, equations::reaction_bias_acceleration().shape());
  }

 private:
  static block::Index index_of(const model::Tree& tree, std::span<const model::Point> points,
                               const std::vector<std::vector<RowPart>>& rows) {
    block::Index result = equations::index_of(tree, points);
    for (const std::vector<RowPart>& row : rows) {
      std::vector<int>& of_row = result.row_points.emplace_back();
      for (const RowPart& part : row) {
        of_row.push_back(part.point);
      }
    }
    return result;
  }

  void fill(const char* leaf, const Scalar& value) {
    std::ranges::fill(evaluation_.leaf(leaf), value);
  }

  // Blocks of S stand point by point, those of a point row by row.
  void write_directions(const std::vector<std::vector<RowPart>>& rows) {
    std::size_t block = 0;
    for (int point = 0; point < plan_.index().points(); ++point) {
      for (const std::vector<RowPart>& row : rows) {
        const auto part = std::ranges::find(row, point, &RowPart::point);
        if (part != row.end()) {
          const std::span<Scalar> S = evaluation_.leaf(part->is_moment ? "S_n" : "S_f");
          std::ranges::transform(part->direction, S.begin() + static_cast<std::ptrdiff_t>(block),
                                 TreeLeaves<Scalar>::convert);
          block += 3;
        }
      }
    }
  }

  [[nodiscard]] std::vector<Scalar> value(int step, std::size_t height,
                                          const block::Shape& shape) const {
    std::vector<Scalar> result(height * rows_);
    evaluation_.write(step, shape, result);
    return result;
  }

  block::Plan plan_;
  int jacobian_;
  int bias_;
  block::Evaluation<Scalar> evaluation_;
  TreeLeaves<Scalar> leaves_;
  std::size_t rows_;
};

}  // namespace treedyn::engine
