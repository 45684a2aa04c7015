// Numbers that are seen as others: no rewriting rests on the stand-ins alone.
#include "formulate/stand_ins.hpp"

#include <gtest/gtest.h>

#include "formulate/geometry.hpp"
#include "program/graph.hpp"

namespace treedyn::formulate {
namespace {

Real seen_as(const char* digits, const char* stand_in) {
  return Real::seen_as(Digits(digits), Digits(stand_in));
}

TEST(StandIns, MakeNoNumbersEqual) {
  const Real a = seen_as("0.3", "0.5");
  EXPECT_EQ(a, seen_as("0.3", "0.5"));
  EXPECT_NE(a, seen_as("0.31", "0.5"));
  EXPECT_NE(seen_as("1e-9", "0"), 0);
  EXPECT_FALSE(identical(a, seen_as("0.31", "0.5")));
  EXPECT_FALSE(negligible(seen_as("1e-9", "0"), 1));
  EXPECT_TRUE(negligible(seen_as("1e-45", "0"), 1));
}

TEST(StandIns, MergeNoConstants) {
  program::Graph graph;
  const program::Ref a = graph.constant(seen_as("0.3", "0.5"));
  EXPECT_EQ(graph.constant(seen_as("0.3", "0.5")), a);
  EXPECT_NE(graph.constant(seen_as("0.31", "0.5")), a);
  EXPECT_NE(graph.constant(seen_as("-0.3", "0.5")), a);
  EXPECT_NE(graph.constant(seen_as("1e-9", "0")), 0);
  const program::Ref x = graph.input(0, 0);
  EXPECT_NE(graph.multiply(graph.constant(seen_as("2", "1")), x), x);
}

TEST(StandIns, MakeNoTurnExact) {
  const Turn opposite = {seen_as("-1", "1"), 0};
  EXPECT_FALSE(opposite.is_identity());
  EXPECT_FALSE(opposite.is_quarter());
  EXPECT_TRUE(Turn{}.is_identity());
  EXPECT_TRUE((Turn{0, -1}).is_quarter());
}

void expect_same(const Matrix3& a, const Matrix3& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_LE(abs(a[k].plain() - b[k].plain()), Real("1e-45")) << k;
    EXPECT_LE(abs(Real(a[k].seen()) - Real(b[k].seen())), Real("1e-45")) << k;
  }
}

/// Axes that are parallel and not seen so, and the reverse.
TEST(StandIns, LeaveEulerAnglesThoseOfBothRotations) {
  const auto rotation = [](const Turn& alpha) {
    const Matrix3 x = {1, 0, 0, 0, alpha.c, -alpha.s, 0, alpha.s, alpha.c};
    return multiply(multiply(about_z(turn_by(Real("0.3"))), x), about_z(turn_by(Real("0.4"))));
  };
  for (const auto& [angle, stand_in] : {std::pair("0", "0.7"), std::pair("0.7", "0"),
                                        std::pair("1e-9", "0.5"), std::pair("0.2", "0.5")}) {
    const Matrix3 r = rotation(turn_by(seen_as(angle, stand_in)));
    const EulerZxz euler = euler_zxz(r);
    const Matrix3 x = {1, 0, 0, 0, euler.alpha.c, -euler.alpha.s, 0, euler.alpha.s, euler.alpha.c};
    expect_same(multiply(multiply(about_z(euler.gamma), x), about_z(euler.epsilon)), r);
  }
}

}  // namespace
}  // namespace treedyn::formulate
