#include "block/print.hpp"

#include <gtest/gtest.h>

#include "equations/symbols.hpp"

namespace treedyn::block {
namespace {

using namespace equations;  // NOLINT(google-build-using-namespace): the symbols

TEST(Print, WritesTransposesAsEquationsDo) {
  EXPECT_EQ(print(transpose(z_d)), "z^dT");
  EXPECT_EQ(print(transpose(D)), "D^T");
  EXPECT_EQ(print(transpose(skew(z_d))), "(Λ(z^d))^T");
  EXPECT_EQ(print(skew_transpose(z_d)), "Λ^T(z^d)");
}

TEST(Print, PutsBracketsOnlyWhereTheyAreNeeded) {
  EXPECT_EQ(print(D * z_d * (E - sigma)), "D z^d (E-σ)");
  EXPECT_EQ(print(sigma * (qd_d + D) - D * E), "σ (q̇^d + D) - D E");
  EXPECT_EQ(print(2 * D * z_d), "2 D z^d");
  EXPECT_EQ(print(-transpose(skew(z_d)) * m_d), "-(Λ(z^d))^T m^d");
  EXPECT_EQ(print(D * (2 * E)), "D (2 E)");
}

TEST(Print, WritesFactors) {
  EXPECT_EQ(print(Ratio{1, 2} * D), "1/2 D");
  EXPECT_EQ(print(3 * (2 * D)), "6 D");
  EXPECT_EQ(print(diagb(D * qd)), "diagb(D q̇)");
}

TEST(PrintDefinition, ShowsWhatNameStandsFor) {
  const Expression w = named("w", z_d * sigma * qd);
  EXPECT_EQ(print(D * w), "D w");
  EXPECT_EQ(print_definition(w), "w = z^d σ q̇");
  EXPECT_EQ(print_definition(D), "D");
}

}  // namespace
}  // namespace treedyn::block
