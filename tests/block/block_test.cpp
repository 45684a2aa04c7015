#include "block/block.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "block/print.hpp"
#include "block/rewrite.hpp"
#include "equations/symbols.hpp"

namespace treedyn::block {
namespace {

using namespace equations;  // NOLINT(google-build-using-namespace): the symbols

template <class Function>
std::string message_of(const Function& function) {
  try {
    function();
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Shape, PrintsNumbersOfLinksAndPoints) {
  EXPECT_EQ(to_string(D.shape()), "N×N");
  EXPECT_EQ(to_string(z_d.shape()), "3N×N");
  EXPECT_EQ(to_string(t_d.shape()), "3P×P");
  EXPECT_EQ(to_string(g.shape()), "3N×1");
  EXPECT_EQ(to_string((transpose(g) * g).shape()), "1×1");
}

TEST(Product, TakesKroneckerProductOfScalarBlocksWhereVectorsStand) {
  EXPECT_EQ(to_string((D * z_d).shape()), "3N×N");
  EXPECT_EQ(to_string((transpose(z_d) * transpose(D)).shape()), "N×3N");
  EXPECT_EQ(to_string((sigma * transpose(z_d)).shape()), "N×3N");
  EXPECT_EQ(to_string((m_d * g).shape()), "3N×1");
}

TEST(Sum, TakesKroneckerProductOfScalarBlocksWhereVectorsStand) {
  EXPECT_EQ(to_string((J_d + m_d).shape()), "3N×3N");
  EXPECT_EQ(to_string((m_d + J_d).shape()), "3N×3N");
}

TEST(Product, RejectsShapesThatDoNotConform) {
  EXPECT_EQ(
      message_of([] { return z_d * J_d; }),
      "product of z^d (3N×N) and J_c^d (3N×3N) does not conform; expected as many rows of the "
      "second as the first has columns");
}

TEST(Product, RejectsLinksWherePointsStand) {
  EXPECT_EQ(
      message_of([] { return D * t_d; }),
      "product of D (N×N) and t^d (3P×P) does not conform; expected as many rows of the second "
      "as the first has columns");
}

TEST(Sum, RejectsShapesThatDoNotConform) {
  EXPECT_EQ(message_of([] { return z_d + D; }),
            "sum of z^d (3N×N) and D (N×N) does not conform; expected equal shapes");
}

// The misprints of EQUATIONS.md 4 that "cannot be evaluated" cannot be written either.
TEST(Sum, RejectsMisprintE4OfBiasForce) {
  const Expression t3 = skew_transpose(s_d) * z_d * sigma * qd_d * D;
  const Expression t1 = skew_transpose(s_d) * skew_transpose(z_d * sigma * qd_d) * (D - E);
  EXPECT_THAT(message_of([&] { return t1 + t3; }), testing::HasSubstr("does not conform"));
}

TEST(Sum, RejectsMisprintE6OfForceJacobian) {
  const Expression first = sigma * transpose(z_d) * transpose(D) * skew(s_d);
  EXPECT_THAT(message_of([&] { return first + (E - sigma) * z_d; }),
              testing::HasSubstr("does not conform"));
}

TEST(Product, RejectsMisprintE7OfMomentOfForces) {
  EXPECT_THAT(message_of([] { return t_d * f_b; }), testing::HasSubstr("does not conform"));
}

TEST(Skew, RejectsWhatIsNotThreeVectors) {
  EXPECT_EQ(message_of([] { return skew(D); }), "Λ of D (N×N); expected 3-vectors");
  EXPECT_EQ(message_of([] { return skew_transpose(J_d); }),
            "Λ of J_c^d (3N×3N); expected 3-vectors");
}

TEST(Diagb, RejectsWhatIsNotColumn) {
  EXPECT_EQ(message_of([] { return diagb(z_d); }), "diagb of z^d (3N×N); expected a column");
}

TEST(Diagb, HasOneColumnPerBlock) { EXPECT_EQ(to_string(diagb(D * z_d * qd).shape()), "3N×N"); }

TEST(Equal, ComparesStructureAndLooksThroughNames) {
  EXPECT_TRUE(equal(D * s_d, named("x", D * s_d)));
  EXPECT_FALSE(equal(D * s_d, D * l_d));
  EXPECT_FALSE(equal(2 * D, 3 * D));
  EXPECT_FALSE(equal(D + E, E + D));
}

TEST(Without, DropsTermsWithZeros) {
  const auto column = [](const char* name) {
    return leaf(name, Structure::kFull, {{Set::kLinks, 1}, {Set::kOne, 1}});
  };
  const Expression a = column("a");
  const Expression b = column("b");
  const Expression zero = column("z");
  EXPECT_TRUE(equal(without(2 * a + zero - b, {"z"}).value(), 2 * a - b));
  EXPECT_TRUE(equal(without(transpose(a + zero) * b, {"z"}).value(), transpose(a) * b));
  EXPECT_EQ(print(without(named("s", a + b), {"z"}).value()), "s");
  EXPECT_EQ(print(without(named("s", a + zero), {"z"}).value()), "a");
  EXPECT_FALSE(without(3 * (transpose(a) * zero), {"z"}));
  EXPECT_FALSE(without(transpose(diagb(zero)) * a, {"z"}));
}

}  // namespace
}  // namespace treedyn::block
