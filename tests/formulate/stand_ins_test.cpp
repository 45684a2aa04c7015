// Numbers that are seen as others: no rewriting rests on the stand-ins alone.
#include "formulate/stand_ins.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "formulate/geometry.hpp"
#include "formulate/stand_in_numbers.hpp"
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

/// Stand-ins of (x, y, z), a joint's offset, between these axes.
Vector3 offset_between(const Vector3& d, const Vector3& father_axis, const Vector3& axis) {
  StandInNumbers all;
  all.begin(0, 1);
  const Vector3 result = all.offset(d, father_axis, axis);
  for (std::size_t k = 0; k < d.size(); ++k) {
    EXPECT_EQ(result[k].plain(), d[k]) << k;
    EXPECT_NE(result[k].seen(), d[k].digits()) << k;
  }
  return result;
}

/// Axes that meet, lie in one plane across parallel ones or are one, and whose components say
/// nothing of it: a leg's hip behind a turned mounting.
TEST(StandIns, KeepWhatAxesHaveInCommon) {
  const Vector3 x = {1, 0, 0};
  const Vector3 tilted = {0, Real("0.6"), Real("0.8")};
  const auto expect_zero = [](const Real& number) {
    EXPECT_TRUE(negligible(number, 1)) << number.digits() << " seen as " << number.seen();
  };
  const Vector3 meeting = {Real("0.06"), Real("0.054"), Real("0.072")};
  expect_zero(dot(offset_between(meeting, x, tilted), cross(x, tilted)));
  const Vector3 across = {Real("0.3"), Real("0.16"), Real("-0.12")};
  expect_zero(dot(offset_between(across, tilted, tilted), tilted));
  const Vector3 skew = {Real("0.6"), Real("-0.48"), Real("0.64")};
  const Vector3 common = Real("0.25") * skew;
  const Vector3 around = cross(offset_between(common, skew, skew), skew);
  std::ranges::for_each(around, expect_zero);
}

/// Axes that are seen as others themselves; what the components are decides nothing.
TEST(StandIns, AreAcrossTheAxesThatAreSeen) {
  const auto seen = [](const Vector3& d) {
    StandInNumbers all;
    all.begin(0, 1);
    const Vector3 axis = all.axis({0, Real("0.6"), Real("0.8")});
    EXPECT_NE(axis[1].seen(), axis[1].digits());
    const Vector3 result = all.offset(d, axis, axis);
    EXPECT_TRUE(abs(Digits(dot(result, axis).seen())) < Digits("1e-40"));
    return result;
  };
  const Vector3 one = seen({Real("0.3"), Real("0.16"), Real("-0.12")});
  const Vector3 other = seen({Real("0.2"), Real("0.08"), Real("-0.06")});
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].seen(), other[k].seen()) << k;
  }
}

TEST(StandIns, OfOtherOffsetsAreThoseOfTheirComponents) {
  const Vector3 x = {1, 0, 0};
  const Vector3 tilted = {0, Real("0.6"), Real("0.8")};
  const Vector3 d = {Real("0.06"), Real("0.05"), Real("0.07")};
  StandInNumbers all;
  all.begin(0, 1);
  const Vector3 components = all.vector(StandIn::kOffset, d);
  EXPECT_EQ(offset_between(d, x, tilted), components);
}

}  // namespace
}  // namespace treedyn::formulate
