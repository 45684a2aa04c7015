#include "simulation/min_norm.hpp"

#include <cmath>

namespace treedyn::simulation {

void MinimumNorm::factor(const Matrix& W) {
  svd_.compute(W, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Vector& sigma = svd_.singularValues();
  const double least = sigma.size() == 0 ? 0 : std::sqrt(threshold_) * sigma[0];
  rank_ = 0;
  while (rank_ < sigma.size() && sigma[rank_] > least) {
    ++rank_;
  }
}

const Vector& MinimumNorm::preimage(const Vector& b) {
  const auto sigma = svd_.singularValues().head(rank_).array();
  scaled_ = svd_.matrixV().leftCols(rank_).transpose() * b;
  scaled_.array() /= sigma;
  y_ = svd_.matrixU().leftCols(rank_) * scaled_;
  return y_;
}

const Vector& MinimumNorm::multipliers() {
  scaled_.array() /= svd_.singularValues().head(rank_).array();
  lambda_ = svd_.matrixV().leftCols(rank_) * scaled_;
  return lambda_;
}

}  // namespace treedyn::simulation
