#include "expansion/equations_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/golden_tree.hpp"

namespace treedyn::expansion {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string dump_of(const std::string& name, const DumpOptions& options) {
  const support::GoldenCase golden =
      support::read_golden(std::string(TREEDYN_SOURCE_DIR "/tests/data/golden/") + name);
  return dump(golden.tree, golden.points, golden.gravity, options);
}

// EQUATIONS.md 9: A = diag(J1 + m1 a1^2 + J2 + m2 r^2, m2), B = (2 m2 r qd1 qd2, -m2 r qd1^2).
TEST(Dump, ShowsClosedFormOfPolarArm) {
  EXPECT_EQ(dump_of("c03_RP_polar.json", {.functions = {"mass_matrix", "bias_force"}}),
            "c03_RP_polar: N = 2 joints, P = 2 points\n"
            "  0  joint1  revolute  father ground\n"
            "  1  joint2  prismatic  father joint1\n"
            "\n"
            "D, N×N\n"
            "  blocks that D leaves: 3 of 4\n"
            "    x.\n"
            "    xx\n"
            "\n"
            "mass_matrix  (2)  [N×N]\n"
            "  l_D = D s^d (D-E) + l^d D\n"
            "  c_fD = l_D + c^d D\n"
            "  J_v = D z^d (E-σ) + Λ^T(c_fD) z^d σ\n"
            "  A = σ z^dT (-(Λ(c_fD))^T m^d J_v + D^T J_c^d D z^d σ) + (E-σ) z^dT D^T m^d J_v\n"
            "  blocks that D leaves: 4 of 4\n"
            "    xx\n"
            "    xx\n"
            "  [0,0] = 2.5*q_joint2^2 + 0.215\n"
            "  [1,1] = 2.5\n"
            "\n"
            "bias_force  (3)  [N×1]\n"
            "  K(c_ii) = Λ^T(c_fD) Λ^T(z^d σ q̇^d) (D-E) + 2 D Λ^T(z^d (E-σ) q̇^d) (D-E) + "
            "Λ^T(Λ^T(c_fD) z^d σ q̇^d D + Λ^T(c_fD) diagb((D-E) z^d σ q̇))\n"
            "  B = σ z^dT (-(Λ(c_fD))^T m^d K(c_ii) + D^T J_c^d D σ q̇^d Λ^T(z^d) (D-E) + "
            "D^T Λ(diagb(D z^d σ q̇)) J_c^d D) z^d σ q̇ + (E-σ) z^dT D^T m^d K(c_ii) z^d σ q̇\n"
            "  blocks that D leaves: 2 of 2\n"
            "  [0,0] = 5*q_joint2*qd_joint1*qd_joint2\n"
            "  [1,0] = -2.5*q_joint2*qd_joint1^2\n");
}

TEST(Dump, ShowsPatternsOnlyOfLargeTrees) {
  const std::string text = dump_of("c11_tree12.json", {});
  EXPECT_THAT(text, HasSubstr("mass_matrix  (2)  [N×N]"));
  EXPECT_THAT(text, Not(HasSubstr("[0,0] =")));
}

TEST(Dump, ShowsEveryFunctionOnce) {
  const std::string text = dump_of("c03_RP_polar.json", {});
  EXPECT_THAT(text, HasSubstr("\nforce_jacobian_transpose  (9)  [N×3P]\n"));
  EXPECT_THAT(text, HasSubstr("\n  U = "));
  EXPECT_EQ(text.find("  K(c_ii) ="), text.rfind("  K(c_ii) ="));
}

TEST(Dump, CountsTermsOfLongEntries) {
  EXPECT_THAT(dump_of("c02_planar_2R.json", {.functions = {"mass_matrix"}, .most_terms = 1}),
              HasSubstr("[0,0] = (2 terms)"));
}

}  // namespace
}  // namespace treedyn::expansion
