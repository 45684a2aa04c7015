// Every rule of the plan against full matrices with random numbers.
#include "block/plan.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "block/print.hpp"
#include "block/random_leaves.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"
#include "equations/table.hpp"

namespace treedyn::block {
namespace {

using namespace equations;  // NOLINT(google-build-using-namespace): the symbols

/// Rounding: an entry of a product of at most 12 factors over 7 links comes from sums of at most 21
/// products each, so below 12 * 2 * 21 roundings lie on the way to it, each half an ulp of a
/// partial sum, and those are bounded by the same expression of magnitudes.
constexpr double kRoundings = 12 * 2 * 21;

void expect_same(const Expression& e, int trials) {
  support::Dice dice(11);
  for (int trial = 0; trial < trials; ++trial) {
    const Index index = random_index(1 + dice.below(7), dice.below(4), dice);
    const auto leaves = random_leaves(index, dice);
    const Eigen::MatrixXd expected = dense::Evaluator(index, leaves)(e);
    const Eigen::MatrixXd bound = dense::Evaluator(index, leaves, true)(e);
    const Eigen::MatrixXd actual = planned(e, index, leaves);
    ASSERT_EQ(actual.rows(), expected.rows());
    ASSERT_EQ(actual.cols(), expected.cols());
    for (Eigen::Index n = 0; n < expected.size(); ++n) {
      const double tolerance =
          kRoundings * std::numeric_limits<double>::epsilon() * bound.reshaped()(n);
      EXPECT_NEAR(actual.reshaped()(n), expected.reshaped()(n), tolerance) << print(e);
    }
  }
}

struct Rule {
  const char* name;
  Expression expression;
};

void PrintTo(const Rule& rule, std::ostream* stream) { *stream << print(rule.expression); }

class PlanRule : public testing::TestWithParam<Rule> {};

TEST_P(PlanRule, GivesWhatFullMatricesGive) { expect_same(GetParam().expression, 40); }

INSTANTIATE_TEST_SUITE_P(
    Rules, PlanRule,
    testing::Values(
        Rule{"PrefixSumsOfRows", D* z_d}, Rule{"SubtreeSumsOfRows", transpose(D) * z_d},
        Rule{"StrictPrefixSumsOfRows", (D - E) * J_d},
        Rule{"StrictSubtreeSumsOfRows", (transpose(D) - E) * J_d},
        Rule{"SubtreeSumsOfColumns", z_d* D}, Rule{"PrefixSumsOfColumns", z_d* transpose(D)},
        Rule{"StrictSubtreeSumsOfColumns", J_d*(D - E)},
        Rule{"StrictPrefixSumsOfColumns", J_d*(transpose(D) - E)},
        Rule{"CompositeSums", transpose(D) * J_d* D}, Rule{"PathSumOfColumn", D* z_d* qd},
        Rule{"SubtreeSumOfColumn", transpose(D) * m_d* g},
        Rule{"PathSumOfFullProduct", D*(z_d* transpose(z_d)) * D},
        Rule{"ProductWithIdentity", E* z_d* E}, Rule{"ConstantProduct", D* D* transpose(D)},
        Rule{"ConstantSum", D + transpose(D) - 2 * E}, Rule{"ConstantCarrier", transpose(W) * D* W},
        Rule{"ColumnThroughSum", (J_d + D * J_d * D) * z_d* qd},
        Rule{"ColumnThroughScaledSum", D*(2 * (J_d - m_d)) * g},
        Rule{"ColumnThroughTransposedSum", transpose(J_d* D + 3 * m_d) * g},
        Rule{"ColumnThroughTransposedProduct", transpose(D* z_d* sigma) * g},
        Rule{"ColumnThroughTransposedName", transpose(named("x", D* z_d + s_d)) * g},
        Rule{"ColumnThroughDoubleTranspose", transpose(transpose(D* z_d)) * qd},
        Rule{"RowTimesColumn", transpose(g) * m_d* D* g},
        Rule{"SkewKeepsPositions", skew(D* s_d*(D - E))},
        Rule{"SkewTransposeKeepsPositions", skew_transpose(D* s_d*(D - E))},
        Rule{"FullTransposeSwapsPositions", transpose(skew(D* s_d))},
        Rule{"DiagonalOfColumn", diagb(D* z_d* qd)}, Rule{"DiagonalOfScalars", diagb(sigma* qd)},
        Rule{"ScaledProduct", Ratio{1, 2} * (z_d * transpose(z_d))},
        Rule{"RationalInsideProduct", z_d*(3 * qd_d) * D}, Rule{"SumOfSizes", J_d + m_d - D},
        Rule{"ZeroDifference", (D - D) * z_d + s_d}, Rule{"OnlyZero", (sigma - sigma) * qd},
        Rule{"ZeroOfVectors", z_d*(E - E)}, Rule{"PromotedOutput", J_d*(E - E) + D},
        Rule{"SigmaSelects", sigma* D*(E - sigma)}, Rule{"Points", t_d* transpose(W) * D}),
    [](const testing::TestParamInfo<Rule>& rule) { return std::string(rule.param.name); });

class PlanEquation : public testing::TestWithParam<std::string> {};

TEST_P(PlanEquation, GivesWhatFullMatricesGive) {
  expect_same(equations::find(GetParam())->expression.value(), 25);
}

std::vector<std::string> equation_names() {
  std::vector<std::string> names;
  for (const equations::Equation& equation : equations::table()) {
    names.emplace_back(equation.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, PlanEquation, testing::ValuesIn(equation_names()),
                         [](const testing::TestParamInfo<std::string>& name) {
                           return name.param;
                         });

const Step& last_step(Plan& plan, const Expression& e) { return plan.step(plan.add(e)); }

Index chain(int links) {
  Index index;
  for (int i = 0; i < links; ++i) {
    index.father.push_back(i - 1);
    index.revolute.push_back(true);
  }
  return index;
}

TEST(Plan, ComputesEqualSubexpressionsOnce) {
  Plan plan(chain(4));
  const int first = plan.add(named("w", z_d * sigma * qd));
  const std::size_t steps = plan.steps().size();
  EXPECT_EQ(plan.add(z_d * sigma * qd), first);
  EXPECT_EQ(plan.steps().size(), steps);
}

TEST(Plan, MultipliesByDWithOneAdditionPerBlockAndOperand) {
  Plan plan(chain(64));
  const Step& sums = last_step(plan, D * z_d * qd);
  EXPECT_EQ(sums.operation, Operation::kPathSum);
  EXPECT_EQ(sums.terms.size(), 64U + 63U);
}

TEST(Plan, FoldsConstantsOfTree) {
  Plan plan(chain(3));
  const Step& product = last_step(plan, D * transpose(D));
  EXPECT_EQ(product.operation, Operation::kConstant);
  EXPECT_EQ(product.constants, (std::vector<int>{1, 1, 1, 1, 2, 2, 1, 2, 3}));
}

TEST(Plan, GrowsWithNonZeroBlocksForBiasForce) {
  const auto terms = [](int links) {
    Plan plan(chain(links));
    const int result = plan.add(bias_force());
    std::size_t sum = 0;
    for (const int step : plan.needed({result})) {
      sum += plan.step(step).terms.size();
    }
    return static_cast<double>(sum);
  };
  // c_fD has N (N+1)/2 blocks, everything behind it is a column: quadratic, not cubic.
  EXPECT_LT(terms(64) / terms(32), 4.2);
}

TEST(Plan, LeavesUnusedStepsOut) {
  Plan plan(chain(3));
  plan.add(mass_matrix());
  const int p = plan.add(point_positions());
  for (const int step : plan.needed({p})) {
    EXPECT_NE(plan.step(step).operation, Operation::kSkew);
  }
}

TEST(Plan, KnowsOnlyLeavesInUse) {
  Plan plan(chain(2));
  plan.add(D * z_d);
  EXPECT_GE(plan.leaf("z^d"), 0);
  EXPECT_EQ(plan.leaf("s^d"), -1);
}

}  // namespace
}  // namespace treedyn::block
