#include "engine/inertia_factor.hpp"

#include <gtest/gtest.h>

namespace treedyn::engine {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(Factorize, GivesUnitLowerFactorAndPivots) {
  Matrix3d L;
  L << 1, 0, 0, 2, 1, 0, -1, 3, 1;
  const Vector3d pivots(2, 4, 8);
  Matrix3d A = L.transpose() * pivots.asDiagonal() * L;
  factorize(A);
  EXPECT_EQ(A(1, 0), 2);
  EXPECT_EQ(A(2, 0), -1);
  EXPECT_EQ(A(2, 1), 3);
  EXPECT_EQ(A.diagonal(), pivots);
}

TEST(Factorize, KeepsZerosBetweenBranches) {  // links 1 and 2 are sons of link 0
  Matrix3d A;
  A << 9, 1, 2, 1, 3, 0, 2, 0, 5;
  factorize(A);
  EXPECT_EQ(A(2, 1), 0);
}

TEST(SolveFactorized, SolvesExactSystem) {
  Matrix3d A;
  A << 16, 4, 8, 4, 4, 0, 8, 0, 8;
  const Vector3d x(1, -2, 4);
  Vector3d b = A * x;
  factorize(A);
  solve_factorized(A, b);
  EXPECT_EQ(b, x);
}

}  // namespace
}  // namespace treedyn::engine
