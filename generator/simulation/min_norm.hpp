// The one linear solve of constrained dynamics: minimum norm, with a decision on the rank.
#pragma once

#include <Eigen/QR>
#include <Eigen/SVD>

#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

/// The square of a singular value of W, scaled to columns of one size, below this is rounding.
inline constexpr double kRounding = 1e-26;

/// The largest first.
[[nodiscard]] Vector singular_values(const Eigen::MatrixXd& matrix);

/// What the rows of K are where nothing is special.
struct OrdinarySizes {
  Vector sizes;    ///< roots of the diagonal entries of K; empty: as they are now
  Vector lengths;  ///< norms of the rows of J per reach of the joints
  int rank = -1;   ///< where the constraints hold; -1: not known
};

/// Solves with K = W^T W by the singular values of W, which are the roots of the eigenvalues of K
/// and lose half as many digits. The rank is decided with columns of W scaled to one size, so that
/// no row is measured by another one; the norm of lambda is that of lambda itself,
/// EQUATIONS.md 6.3.
class MinimumNorm {
 public:
  /// Of singular values more than the rows have where they hold the smallest count as zero.
  /// \param W  n x r
  void factor(const Matrix& W, const OrdinarySizes& ordinary = {});

  /// y of smallest norm with W^T y = b; least squares if there is none. \param b  r
  [[nodiscard]] const Vector& preimage(const Vector& b);
  /// lambda of smallest norm with W lambda = y of the last `preimage`: lambda = K^+ b.
  [[nodiscard]] const Vector& multipliers();
  [[nodiscard]] int rank() const { return rank_; }

 private:
  Eigen::JacobiSVD<Eigen::MatrixXd> svd_;
  Vector scale_;                                ///< of the columns
  Eigen::HouseholderQR<Eigen::MatrixXd> rows_;  ///< of scale^-1 V, where the rank is below r
  int rank_ = 0;
  Vector scaled_;
  Vector y_;
  Vector lambda_;
};

}  // namespace treedyn::simulation
