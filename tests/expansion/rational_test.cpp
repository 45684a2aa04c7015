#include "expansion/rational.hpp"

#include <gtest/gtest.h>

namespace treedyn::expansion {
namespace {

using GiNaC::numeric;

TEST(NearbyRational, FindsDecimalsAndFractions) {
  EXPECT_EQ(nearby_rational(Real("0.433")), numeric(433, 1000));
  EXPECT_EQ(nearby_rational(Real(-2) / Real(7)), numeric(-2, 7));
  EXPECT_EQ(nearby_rational(Real(0)), numeric(0));
  EXPECT_EQ(nearby_rational(Real(12345)), numeric(12345));
  EXPECT_EQ(nearby_rational(Real("1.234567890123456")),
            numeric("1234567890123456") / numeric("1000000000000000"));
}

TEST(NearbyRational, FindsNothingBehindIrrationalNumbers) {
  EXPECT_FALSE(nearby_rational(sqrt(Real(2))));
  EXPECT_FALSE(nearby_rational(pi()));
}

TEST(BinaryFraction, IsExactAtAllMagnitudes) {
  EXPECT_EQ(binary_fraction(Real("0.375")), numeric(3, 8));
  EXPECT_EQ(binary_fraction(Real(-1024)), numeric(-1024));
  EXPECT_EQ(binary_fraction(ldexp(Real(3), -200)),
            numeric(3) * GiNaC::pow(numeric(2), numeric(-200)));
}

}  // namespace
}  // namespace treedyn::expansion
