// The one linear solve of constrained dynamics: minimum norm, with a decision on the rank.
#pragma once

#include <Eigen/SVD>

#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

/// An eigenvalue of W^T W below this fraction of the largest counts as zero (double).
inline constexpr double kRankThreshold = 1e-11;

/// Solves with K = W^T W by the singular values of W, which are the roots of the eigenvalues of K
/// and lose half as many digits.
class MinimumNorm {
 public:
  /// \param W  n x r
  void factor(const Matrix& W);

  /// y of smallest norm with W^T y = b; least squares if there is none. \param b  r
  [[nodiscard]] const Vector& preimage(const Vector& b);
  /// lambda of smallest norm with W lambda = y of the last `preimage`: lambda = K^+ b.
  [[nodiscard]] const Vector& multipliers();
  [[nodiscard]] int rank() const { return rank_; }
  void set_threshold(double threshold) { threshold_ = threshold; }

 private:
  Eigen::JacobiSVD<Eigen::MatrixXd> svd_;
  int rank_ = 0;
  double threshold_ = kRankThreshold;
  Vector scaled_;
  Vector y_;
  Vector lambda_;
};

}  // namespace treedyn::simulation
