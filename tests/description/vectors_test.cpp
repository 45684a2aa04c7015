#include "description/vectors.hpp"

#include <gtest/gtest.h>

namespace treedyn::description {
namespace {

TEST(Algebra, MultipliesMatricesRowByColumn) {
  const Matrix3 a = {1, 2, 3, 4, 5, 6, 7, 8, 10};
  const Matrix3 b = {0, 1, 0, 0, 0, 1, 1, 0, 0};
  EXPECT_EQ(a * b, (Matrix3{3, 1, 2, 6, 4, 5, 10, 7, 8}));
  EXPECT_EQ(a * (Vector3{1, 0, -1}), (Vector3{-2, -2, -3}));
  EXPECT_EQ(transposed(a), (Matrix3{1, 4, 7, 2, 5, 8, 3, 6, 10}));
  EXPECT_EQ(determinant(a), Real(-3));
}

TEST(Algebra, CrossIsRightHanded) {
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vector3{0, 0, 1}));
  EXPECT_EQ(cross({0, 2, 0}, {0, 0, 3}), (Vector3{6, 0, 0}));
}

TEST(PointInertia, IsThatOfAPointMass) {
  // m = 2 at (1, 2, 3): m (d.d E - d d^T)
  EXPECT_EQ(point_inertia(2, {1, 2, 3}), (Matrix3{26, -4, -6, -4, 20, -12, -6, -12, 10}));
}

TEST(Eigenvalues, AreThoseOfAKnownMatrix) {
  // [[2,1,0],[1,2,0],[0,0,7]]: 1, 3, 7
  const Vector3 values = eigenvalues({2, 1, 0, 1, 2, 0, 0, 0, 7});
  EXPECT_LE(abs(values[0] - 1), Real("1e-45"));
  EXPECT_LE(abs(values[1] - 3), Real("1e-45"));
  EXPECT_LE(abs(values[2] - 7), Real("1e-45"));
}

TEST(Eigenvalues, SumToTheTraceAndMultiplyToTheDeterminant) {
  const Matrix3 a = {4, -1, 0.5, -1, 3, 0.25, 0.5, 0.25, -2};
  const Vector3 values = eigenvalues(a);
  EXPECT_LE(abs(values[0] + values[1] + values[2] - 5), Real("1e-45"));
  EXPECT_LE(abs(values[0] * values[1] * values[2] - determinant(a)), Real("1e-44"));
  EXPECT_LT(values[0], values[1]);
}

TEST(Eigenvalues, OfADiagonalMatrixAreItsEntriesSorted) {
  EXPECT_EQ(eigenvalues({3, 0, 0, 0, -1, 0, 0, 0, 2}), (Vector3{-1, 2, 3}));
}

}  // namespace
}  // namespace treedyn::description
