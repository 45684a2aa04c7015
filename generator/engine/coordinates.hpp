// Independent coordinates u and joint coordinates q = T u + q0 (mimic joints).
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "engine/outputs.hpp"
#include "model/tree.hpp"

namespace treedyn::engine {

/// T has one entry a row: q_i = multiplier_i u[coordinate_i] + offset_i.
template <class Scalar>
class Coordinates {
 public:
  template <class Convert>
  Coordinates(const model::Tree& tree, const Convert& convert)
      : dof_(tree.dof()), selected_(tree.coordinates.begin(), tree.coordinates.end()) {
    for (const model::Drive& drive : tree.drives) {
      drives_.push_back({static_cast<std::size_t>(drive.coordinate), convert(drive.multiplier),
                         convert(drive.offset)});
    }
  }

  [[nodiscard]] int dof() const { return dof_; }

  void expand_positions(std::span<const Scalar> u, std::span<Scalar> q) const {
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      q[i] = drives_[i].multiplier * u[drives_[i].coordinate] + drives_[i].offset;
    }
  }

  void expand_rates(std::span<const Scalar> ud, std::span<Scalar> qd) const {
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      qd[i] = drives_[i].multiplier * ud[drives_[i].coordinate];
    }
  }

  /// `full` (row-major, `cols` wide) in independent coordinates; the result stands in `out`.
  [[nodiscard]] std::span<const Scalar> reduce(Reduction reduction, std::span<const Scalar> full,
                                               std::size_t cols, std::span<Scalar> out) const {
    switch (reduction) {
      case Reduction::kRows:
        return rows(full, cols, out);
      case Reduction::kRowsCols:
        return rows_and_cols(full, out);
      case Reduction::kSelection:
        return selection(full, out);
      case Reduction::kNone:
        break;
    }
    std::ranges::copy(full, out.begin());
    return out.first(full.size());
  }

 private:
  struct Drive {
    std::size_t coordinate;
    Scalar multiplier, offset;
  };

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(dof_); }

  [[nodiscard]] std::span<const Scalar> rows(std::span<const Scalar> full, std::size_t cols,
                                             std::span<Scalar> out) const {
    const std::span<Scalar> result = out.first(size() * cols);
    std::ranges::fill(result, Scalar(0));
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      for (std::size_t j = 0; j < cols; ++j) {
        result[drives_[i].coordinate * cols + j] += drives_[i].multiplier * full[i * cols + j];
      }
    }
    return result;
  }

  [[nodiscard]] std::span<const Scalar> rows_and_cols(std::span<const Scalar> full,
                                                      std::span<Scalar> out) const {
    const std::span<Scalar> result = out.first(size() * size());
    std::ranges::fill(result, Scalar(0));
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      for (std::size_t j = 0; j < drives_.size(); ++j) {
        result[drives_[i].coordinate * size() + drives_[j].coordinate] +=
            drives_[i].multiplier * drives_[j].multiplier * full[i * drives_.size() + j];
      }
    }
    return result;
  }

  [[nodiscard]] std::span<const Scalar> selection(std::span<const Scalar> full,
                                                  std::span<Scalar> out) const {
    for (std::size_t row = 0; row < 3 * size(); ++row) {
      const std::size_t full_row = 3 * selected_[row / 3] + row % 3;
      for (std::size_t j = 0; j < size(); ++j) {
        out[row * size() + j] = full[full_row * drives_.size() + selected_[j]];
      }
    }
    return out.first(3 * size() * size());
  }

  int dof_;
  std::vector<std::size_t> selected_;
  std::vector<Drive> drives_;
};

}  // namespace treedyn::engine
