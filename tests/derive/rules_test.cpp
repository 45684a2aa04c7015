// The rules of the derivation, one by one.
#include <algorithm>

#include <gtest/gtest.h>

#include "derive/derive.hpp"
#include "derive/print.hpp"
#include "derive/words.hpp"
#include "equations/dot.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using block::skew;
using block::skew_transpose;
using block::transpose;
using namespace equations;  // the symbols

const Expression N = D - E;
const Expression w = z_d * sigma * qd;

/// The values that the column needs, by operation.
std::vector<Op> operations(const Expression& e) {
  const Derivation derivation = derive(e, false);
  std::vector<Op> result;
  for (const int id : derivation.values.needed(derivation.roots)) {
    result.push_back(derivation.values[id].op);
  }
  return result;
}
auto count(const Expression& e, Op op) {
  const std::vector<Op> all = operations(e);
  return std::count(all.begin(), all.end(), op);
}
bool acts(const Expression& e, Rule rule) {
  return derive(e, false).values.acted().count(rule) > 0;
}
std::vector<std::string> texts(const Expression& e) {
  std::vector<std::string> result;
  const std::vector<Word> all = words(e, 100).value();
  for (const Word& word : all) {
    result.push_back(to_text(word));
  }
  return result;
}

TEST(R0, DistributesAndPushesTransposesDown) {
  EXPECT_EQ(texts(transpose(D * (m_d + sigma)) * qd),
            (std::vector<std::string>{"m^dT D^T q̇", "σ^T D^T q̇"}));
}

TEST(R1, TurnsReachabilityIntoSumsAlongTheTree) {
  EXPECT_EQ(count(D * qd, Op::kPath), 1);
  EXPECT_EQ(count(N * qd, Op::kPathStrict), 1);
  EXPECT_EQ(count(transpose(D) * qd, Op::kSubtree), 1);
  EXPECT_EQ(count((transpose(D) - E) * qd, Op::kSubtreeStrict), 1);
}

TEST(R2, LetsSkewPassReachability) {
  EXPECT_EQ(texts(skew(D * z_d * sigma)), (std::vector<std::string>{"D Λ(z^d) σ"}));
  EXPECT_TRUE(acts(skew(D * z_d * sigma) * g, Rule::kSkewPasses));
  EXPECT_EQ(count(skew(D * z_d * sigma) * g, Op::kCross), 1);
}

TEST(R3, MeltsSumsIntoOne) {
  EXPECT_EQ(count(D * m_d * qd + D * qdd, Op::kPath), 1);
  EXPECT_EQ(operations(D * qd - D * qd), (std::vector<Op>{Op::kZero}));
  const Expression both = transpose(D) * qd + (transpose(D) - E) * qdd;
  EXPECT_EQ(count(both, Op::kBackward), 1);
  EXPECT_EQ(count(both, Op::kSubtree), 0);
  EXPECT_EQ(count(skew(s_d) * w + skew(s_d) * g, Op::kCross), 1);
}

TEST(R3, LeavesBiasForceOneBackwardSweepOfForcesAndOneOfMoments) {
  EXPECT_EQ(count(bias_force(), Op::kSubtree), 1);
  EXPECT_EQ(count(bias_force(), Op::kBackward), 1);
}

TEST(R4, TakesCrossWordsByBlocksOfThree) {
  const Expression word =
      skew_transpose(skew_transpose(joint_to_com_vectors()) * z_d * sigma * qd_d * D) * w;
  EXPECT_TRUE(acts(word, Rule::kCrossWords));
  EXPECT_FALSE(acts(word, Rule::kComponents));
}

TEST(R5, TelescopesTheCentripetalTerms) {
  const Expression a = bias_matrix(centres_of_mass()) * w;
  EXPECT_TRUE(acts(a, Rule::kTelescope));
  const Derivation derivation = derive(a, false);
  for (const int id : derivation.values.needed(derivation.roots)) {
    const Value& value = derivation.values[id];
    if (value.op == Op::kSkewProduct) {  // Λ(ω)² alone
      EXPECT_EQ(value.operands[0], value.operands[1]);
    }
  }
}

TEST(R5, DoesNotTelescopeWhatIsNoDifference) {
  const Expression c = joint_to_com_vectors();
  const Expression half =  // (3), T3, without the fathers' part
      skew_transpose(skew_transpose(c) * z_d * sigma * qd_d * D) * w;
  EXPECT_FALSE(acts(half, Rule::kTelescope));
}

TEST(R7, KeepsTheKindOfBlocks) {
  const Derivation C = derive(force_jacobian_transpose(points()), false);
  EXPECT_TRUE(C.wide);
  EXPECT_TRUE(C.values.acted().count(Rule::kKinds) > 0);
  for (const int id : C.values.needed(C.roots)) {  // the skew blocks travel as their vectors
    EXPECT_NE(C.values[id].type, Type::kTensor) << static_cast<int>(C.values[id].op);
  }
  EXPECT_FALSE(
      derive(transpose(skew(joint_to_com_vectors())) * skew(joint_to_com_vectors()), false).wide);
}

TEST(R7, ReadsPointsBackwards) {
  const auto v = derive_rows(point_velocities());
  ASSERT_TRUE(v.has_value());
  for (const int id : v->values.needed(v->roots)) {
    EXPECT_NE(v->values[id].op, Op::kPath);  // nothing travels from the root
  }
  EXPECT_FALSE(derive_rows(point_bias_acceleration()).has_value());
}

TEST(R3, KeepsSumsOverLinksAndOverPointsApart) {
  EXPECT_EQ(
      count(transpose(ones) * m_d * c_d * ones + transpose(ones_P) * t_d * ones_P, Op::kCollect),
      2);
}

TEST(R3, LetsWhatIsCommonLeaveSums) {
  const std::vector<Op> G = operations(gravity_force());
  EXPECT_EQ(std::count(G.begin(), G.end(), Op::kBackward), 1);  // first moments: h^c
  EXPECT_EQ(std::count(G.begin(), G.end(), Op::kSubtree), 1);   // masses: m^c
  const std::vector<Op> U = operations(potential_energy());
  EXPECT_EQ(std::count(U.begin(), U.end(), Op::kPath), 0);
  EXPECT_EQ(std::count(U.begin(), U.end(), Op::kCollect), 1);
}

TEST(R10, MakesMassesTimesCentresFirstMoments) {
  for (const Expression& e : {gravity_force(), potential_energy()}) {
    const Derivation derivation = derive(e, false);
    for (const int id : derivation.values.needed(derivation.roots)) {
      EXPECT_NE(derivation.values[id].name, "c^d");
    }
  }
}

TEST(R11, KnowsThatReachabilityAndMassesAreConstant) {
  EXPECT_EQ(operations(dot(D * m_d) * qd), (std::vector<Op>{Op::kZero}));
  EXPECT_THROW(dot(tau), NoRate);
}

TEST(R11, GivesTheBiasOfTheJacobianWithoutBlocksOfThree) {
  const Expression rate = dot(velocity_jacobian(centres_of_mass())) * qd;
  EXPECT_FALSE(acts(rate, Rule::kCrossWords));
  EXPECT_FALSE(acts(rate, Rule::kComponents));
}

TEST(Print, NamesWhatTheFieldNames) {
  const std::vector<Line> all = lines(derive(D * w, false));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].text, "w = q̇ σ z^d");
  EXPECT_EQ(all[1].text, "ω = D w");
}

}  // namespace
}  // namespace treedyn::derive
