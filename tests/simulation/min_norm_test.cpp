// The solve of constrained dynamics against Eigen's complete orthogonal decomposition.
#include "simulation/min_norm.hpp"

#include <random>

#include <Eigen/QR>
#include <gtest/gtest.h>

namespace treedyn::simulation {
namespace {

/// n x r of the given rank, entries of size one.
Matrix random_matrix(std::mt19937& engine, int n, int r, int rank) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto draw = [&] {
    return number(engine);
  };
  const Eigen::MatrixXd left = Eigen::MatrixXd::NullaryExpr(n, rank, draw);
  const Eigen::MatrixXd right = Eigen::MatrixXd::NullaryExpr(rank, r, draw);
  return left * right;
}

/// lambda = (W^T W)^+ b for b in the range of W^T. The condition of W is below 1.6e3 for these
/// matrices, that of K = W^T W below 2.6e6; times 100 roundings of 1.2e-16, no more than n r.
TEST(MinimumNorm, AgreesWithTheCompleteOrthogonalDecomposition) {
  std::mt19937 engine(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 4 + trial % 9;
    const int r = 1 + trial % 8;
    const int rank = 1 + trial % std::min(n, r);
    const Matrix W = random_matrix(engine, n, r, rank);
    const Vector b = W.transpose() * Vector::Ones(n);
    MinimumNorm solve;
    solve.factor(W);
    const Vector y = solve.preimage(b);
    const Vector lambda = solve.multipliers();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> of_w(W.transpose());
    of_w.setThreshold(1e-8);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> of_k(
        Eigen::MatrixXd(W.transpose() * W));
    of_k.setThreshold(1e-10);
    EXPECT_EQ(solve.rank(), rank);
    EXPECT_LT((y - of_w.solve(b)).norm(), 2e-11 * (1 + y.norm()));
    EXPECT_LT((lambda - of_k.solve(b)).norm(), 3e-8 * (1 + lambda.norm())) << n << ' ' << r;
  }
}

TEST(MinimumNorm, OfRowsThatAreZeroIsZero) {
  MinimumNorm solve;
  solve.factor(Matrix::Zero(3, 2));
  EXPECT_EQ(solve.rank(), 0);
  EXPECT_EQ(solve.preimage(Vector::Ones(2)).norm(), 0);
  EXPECT_EQ(solve.multipliers().norm(), 0);
}

}  // namespace
}  // namespace treedyn::simulation
