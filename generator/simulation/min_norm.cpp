#include "simulation/min_norm.hpp"

#include <algorithm>
#include <cmath>

namespace treedyn::simulation {

Vector singular_values(const Eigen::MatrixXd& matrix) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
}

void MinimumNorm::factor(const Matrix& W, const OrdinarySizes& ordinary) {
  scale_ = ordinary.sizes.size() == W.cols() ? ordinary.sizes : Vector(W.colwise().norm());
  scale_ = (scale_.array() > 0).select(scale_.array().inverse(), 1.0).matrix().eval();
  svd_.compute(W * scale_.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Vector& sigma = svd_.singularValues();
  const Eigen::Index most =
      ordinary.rank < 0 ? sigma.size() : std::min<Eigen::Index>(ordinary.rank, sigma.size());
  rank_ = 0;
  while (rank_ < most && sigma[rank_] > std::sqrt(kRounding)) {
    ++rank_;
  }
  if (rank_ < W.cols()) {
    rows_.compute(scale_.cwiseInverse().asDiagonal() * svd_.matrixV().leftCols(rank_));
  }
}

/// W = U Sigma B^T with B = scale^-1 V = Q R; with all rows independent B^-1 = V^T scale.
const Vector& MinimumNorm::preimage(const Vector& b) {
  const auto sigma = svd_.singularValues().head(rank_).array();
  if (rank_ == scale_.size()) {
    scaled_ = svd_.matrixV().transpose() * scale_.cwiseProduct(b);
  } else {
    const Vector turned = rows_.householderQ().transpose() * b;
    scaled_ = turned.head(rank_);
    rows_.matrixQR().topRows(rank_).triangularView<Eigen::Upper>().solveInPlace(scaled_);
  }
  scaled_.array() /= sigma;
  y_ = svd_.matrixU().leftCols(rank_) * scaled_;
  return y_;
}

const Vector& MinimumNorm::multipliers() {
  scaled_.array() /= svd_.singularValues().head(rank_).array();
  if (rank_ == scale_.size()) {
    lambda_ = scale_.cwiseProduct(svd_.matrixV() * scaled_);
    return lambda_;
  }
  rows_.matrixQR().topRows(rank_).triangularView<Eigen::Upper>().transpose().solveInPlace(scaled_);
  lambda_ = Vector::Zero(scale_.size());
  lambda_.head(rank_) = scaled_;
  lambda_ = rows_.householderQ() * lambda_;
  return lambda_;
}

}  // namespace treedyn::simulation
