// How many constraint rows are independent where the constraints hold.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

namespace treedyn::program {

/// Constraint rows as functions of q: their position errors, and J.
struct ConstraintRows {
  using Values = std::vector<double>;

  int rows = 0;
  int columns = 0;  ///< length of q
  /// By row, what J per reach is where a row is nothing special: 1 of an angle, the size of the
  /// mechanism of a length.
  Values scales = {};
  /// phi (rows, m or rad; 0 of a row without position) and J (rows x columns, row-major).
  std::function<void(const Values& q, Values& phi, Values& J)> evaluate;
};

/// What rows are in ordinary states.
struct OrdinaryRows {
  int rank = 0;                             ///< of J where the constraints hold
  bool holds = false;                       ///< a state was found in which they do
  std::vector<std::vector<double>> states;  ///< some, and others near them
  std::vector<double> lengths;  ///< of the rows of J per reach, the largest there; 0 of rounding

  [[nodiscard]] bool is_rounding(std::size_t row) const {
    return row < lengths.size() && lengths[row] == 0;
  }
  /// Sizes of rows that are rounding become the largest of the others, or 1, beside which they are
  /// nothing.
  template <class Scalar>
  void raise_rounding(std::span<Scalar> sizes) const;
};

template <class Scalar>
void OrdinaryRows::raise_rounding(std::span<Scalar> sizes) const {
  Scalar largest = 0;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    largest = is_rounding(k) ? largest : std::max(largest, sizes[k]);
  }
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (is_rounding(k)) {
      sizes[k] = largest > 0 ? largest : Scalar(1);
    }
  }
}

/// Singular values of J below this fraction of its rows count as zero: initial states are stated
/// with eight digits and more. Inertia takes no part.
inline constexpr double kDependent = 1e-7;

/// Goes from q0, and from states near it, to where the rows hold (Levenberg, Marquardt), and takes
/// the largest rank that is met there: a singular q0 is no ordinary state. Where they hold nowhere,
/// that of the states on the way.
/// \param columns  those of J that count; empty: all
OrdinaryRows ordinary_rows(const ConstraintRows& rows, const std::vector<double>& q0,
                           const std::vector<double>& reach, const std::vector<int>& columns = {});

}  // namespace treedyn::program
