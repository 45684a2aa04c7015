#include "expansion/polynomial.hpp"

#include <gtest/gtest.h>

namespace treedyn::expansion {
namespace {

class Polynomials : public testing::Test {
 protected:
  Polynomials()
      : c_(ring_, ring_.add("c")),
        s_(ring_, ring_.add("s", 1 - c_.value() * c_.value())),
        q_(ring_, ring_.add("q")) {}

  [[nodiscard]] std::string text(const Expanded& value) const {
    return to_text(ring_, polynomial(ring_, value), 100);
  }
  Expanded constant(const Real& value) { return {ring_, ring_.constant(value)}; }

  Ring ring_;
  Expanded c_, s_, q_;
};

TEST_F(Polynomials, ReplaceSquaresOfSines) {
  EXPECT_EQ(text(s_ * s_), "-c^2 + 1");
  EXPECT_EQ(text(s_ * s_ + c_ * c_), "1");
  EXPECT_EQ(text(s_ * s_ * s_), "-c^2*s + s");
  EXPECT_EQ(text(s_ * s_ * s_ * s_), "-2*c^2 + c^4 + 1");
}

TEST_F(Polynomials, VanishWhenTheirNormalFormsDo) {
  const Expanded square = (s_ + c_) * (s_ + c_);
  EXPECT_TRUE((square - Expanded(2) * s_ * c_ - Expanded(1)).is_zero());
  EXPECT_FALSE((square - Expanded(2) * s_ * c_).is_zero());
}

TEST_F(Polynomials, PrintTermsInOneOrder) {
  const Expanded sum = q_ * s_ - constant(Real("0.5")) * c_ * q_ * q_ + c_ + Expanded(3);
  EXPECT_EQ(text(sum), "c - 0.5*c*q^2 + s*q + 3");
  EXPECT_EQ(text(Expanded(3) + c_ - q_ * q_ * c_ * constant(Real("0.5")) + s_ * q_), text(sum));
}

TEST_F(Polynomials, PrintNumbers) {
  EXPECT_EQ(text(Expanded(0)), "0");
  EXPECT_EQ(text(constant(Real(-1) / 3)), "-1/3");
  EXPECT_EQ(text(constant(Real("0.433")) * q_), "0.433*q");
  EXPECT_EQ(text(-q_), "-q");
  EXPECT_EQ(text(constant(Real("123456789012345"))), "123456789012345");
}

TEST_F(Polynomials, KeepRootsExact) {
  const Expanded root = constant(sqrt(Real(3)) / 2);
  EXPECT_EQ(text(root), "0.5*sqrt(3)");
  EXPECT_EQ(text(root * root), "0.75");
  EXPECT_EQ(text(constant(-sqrt(Real(1) / 2)) * q_), "-0.5*q*sqrt(2)");
}

TEST_F(Polynomials, TakeOtherNumbersAsTheyAre) {
  EXPECT_EQ(text(constant(pi())), "3.141592653589793");
}

TEST_F(Polynomials, CountTermsOfLongSums) {
  EXPECT_EQ(to_text(ring_, polynomial(ring_, c_ + s_ + q_), 2), "(3 terms)");
}

}  // namespace
}  // namespace treedyn::expansion
