// Exact proof of the block equations: their difference to Lagrange's equations, expanded and
// reduced by s^2 + c^2 = 1, is the zero polynomial. Negative control: with a misprint of the paper
// it is not.
#include <gtest/gtest.h>

#include "block/block.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"
#include "expansion/expansion.hpp"
#include "expansion/lagrange.hpp"
#include "support/random_tree.hpp"

namespace treedyn::expansion {
namespace {

using block::Expression;
using support::chain;

struct Mechanism {
  const char* name;
  support::TreeShape shape;
};

void PrintTo(const Mechanism& mechanism, std::ostream* stream) { *stream << mechanism.name; }

std::vector<Mechanism> mechanisms() {
  return {{"RRR", chain("RRR")},
          {"RRP", chain("RRP")},
          {"RPR", chain("RPR")},
          {"RPP", chain("RPP")},
          {"PRR", chain("PRR")},
          {"PRP", chain("PRP")},
          {"PPR", chain("PPR")},
          {"PPP", chain("PPP")},
          {"TreeRRR", {{-1, 0, 0}, "RRR"}},
          {"TreePRP", {{-1, 0, 0}, "PRP"}},
          {"ForestRRP", {{-1, -1, 1}, "RRP"}},
          {"RPRP", chain("RPRP")},
          {"PRRP", chain("PRRP")},
          {"TreeRPRP", {{-1, 0, 0, 1}, "RPRP"}},
          {"ForestPRPR", {{-1, 0, -1, 2}, "PRPR"}}};
}

/// A random robot of a shape, with a point on its last link, one on its first and one on the
/// ground.
struct Robot {
  explicit Robot(const support::TreeShape& shape) {
    support::Dice dice(2);
    tree = support::random_tree(shape, dice);
    points = support::random_points(tree, 3, dice);
    points[0].link = tree.size() - 1;
    points[1].link = 0;
    points[2].link = model::kGround;
  }
  model::Tree tree;
  std::vector<model::Point> points;
  model::Vector3 gravity{Real(1), Real(2), Real("-9.81")};
};

class Proof : public testing::TestWithParam<Mechanism> {
 protected:
  Proof()
      : robot_(GetParam().shape),
        expansion_(robot_.tree, robot_.points, robot_.gravity),
        lagrange_(robot_.tree, robot_.points, robot_.gravity, expansion_) {}

  void expect_zero(const Expression& e, const std::vector<Expanded>& expected) const {
    const Entries entries = expansion_.expand(e);
    ASSERT_EQ(entries.values.size(), expected.size());
    for (std::size_t n = 0; n < expected.size(); ++n) {
      EXPECT_TRUE((entries.values[n] - expected[n]).is_zero()) << "entry " << n;
    }
  }

  /// True if B with a misprint is B all the same.
  [[nodiscard]] bool is_bias_force(const Expression& misprinted) const {
    const Entries entries = expansion_.expand(misprinted);
    const Entries right = expansion_.expand(equations::bias_force());
    return entries.values == right.values;
  }

  Robot robot_;
  Expansion expansion_;
  Lagrange lagrange_;
};

TEST_P(Proof, Equation2IsMassMatrixOfLagrange) {
  expect_zero(equations::mass_matrix(), lagrange_.A());
}

TEST_P(Proof, Equation3IsChristoffelForce) { expect_zero(equations::bias_force(), lagrange_.B()); }

TEST_P(Proof, GravityForceIsGradientOfPotentialEnergy) {
  expect_zero(equations::gravity_force(), lagrange_.G());
}

TEST_P(Proof, Equation9IsTransposedJacobianOfPoints) {
  expect_zero(equations::force_jacobian_transpose(equations::points()), lagrange_.C());
}

TEST_P(Proof, Equation11IsTransposedAngularJacobian) {
  expect_zero(equations::moment_jacobian_transpose(equations::points()), lagrange_.H());
}

TEST_P(Proof, BiasAccelerationsAreSecondDerivatives) {
  expect_zero(equations::point_bias_acceleration(), lagrange_.gamma_f());
  expect_zero(equations::angular_bias_acceleration(), lagrange_.gamma_n());
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, Proof, testing::ValuesIn(mechanisms()),
                         [](const testing::TestParamInfo<Mechanism>& mechanism) {
                           return std::string(mechanism.param.name);
                         });

// (3) as printed, one misprint at a time.
struct Misprints {
  bool e1 = false, e2 = false, e3 = false;
};

Expression misprinted_bias_force(const Misprints& misprints) {
  using namespace equations;  // NOLINT(google-build-using-namespace): the symbols
  using block::diagb;
  using block::skew;
  using block::skew_transpose;
  using block::transpose;
  const Expression c = joint_to_com_vectors();
  const Expression T1 = skew_transpose(c) * skew_transpose(z_d * sigma * qd_d) * (D - E);
  const Expression T2 = 2 * D * skew_transpose(z_d * (E - sigma) * qd_d) * (D - E);
  const Expression summed = skew_transpose(c) * diagb((D - E) * z_d * sigma * qd);
  const Expression printed = skew_transpose(c) * (D - E) * sigma * z_d * qd_d;
  const Expression T3 = skew_transpose(skew_transpose(c) * z_d * sigma * qd_d * D +
                                       (misprints.e1 ? printed : summed));
  const Expression w = z_d * sigma * qd;
  const Expression Lambda = misprints.e3 ? skew(D * z_d * sigma * qd_d) : skew(diagb(D * w));
  const Expression inside = misprints.e2 ? T1 + T3 : T1 + T2 + T3;
  const Expression bracket = -transpose(skew(c)) * m_d * inside;
  const Expression revolute =
      (misprints.e2 ? bracket + T2 : bracket) +
      transpose(D) * J_d * D * sigma * qd_d * skew_transpose(z_d) * (D - E) +
      transpose(D) * Lambda * J_d * D;
  const Expression prismatic = transpose(D) * m_d * (T1 + T2 + T3);
  return sigma * transpose(z_d) * revolute * w + (E - sigma) * transpose(z_d) * prismatic * w;
}

class Misprint : public Proof {};

TEST_P(Misprint, E1ChangesBiasForce) {
  EXPECT_FALSE(is_bias_force(misprinted_bias_force({.e1 = true})));
}

TEST_P(Misprint, E3ChangesBiasForce) {
  EXPECT_FALSE(is_bias_force(misprinted_bias_force({.e3 = true})));
}

TEST_P(Misprint, NoneLeavesBiasForce) { EXPECT_TRUE(is_bias_force(misprinted_bias_force({}))); }

INSTANTIATE_TEST_SUITE_P(Mechanisms, Misprint,
                         testing::Values(Mechanism{"RRR", chain("RRR")},
                                         Mechanism{"RRP", chain("RRP")},
                                         Mechanism{"TreeRRR", {{-1, 0, 0}, "RRR"}}),
                         [](const testing::TestParamInfo<Mechanism>& mechanism) {
                           return std::string(mechanism.param.name);
                         });

class MisprintOfPrismaticTerm : public Proof {};

TEST_P(MisprintOfPrismaticTerm, E2ChangesBiasForce) {
  EXPECT_FALSE(is_bias_force(misprinted_bias_force({.e2 = true})));
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, MisprintOfPrismaticTerm,
                         testing::Values(Mechanism{"RPR", chain("RPR")},
                                         Mechanism{"RRP", chain("RRP")}),
                         [](const testing::TestParamInfo<Mechanism>& mechanism) {
                           return std::string(mechanism.param.name);
                         });

}  // namespace
}  // namespace treedyn::expansion
