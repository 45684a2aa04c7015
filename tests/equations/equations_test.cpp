// The equations read as EQUATIONS.md 3 prints them.
#include "equations/equations.hpp"

#include <gtest/gtest.h>

#include "block/print.hpp"
#include "equations/symbols.hpp"
#include "equations/table.hpp"

namespace treedyn::equations {
namespace {

using block::print_definition;

TEST(Equation2, ReadsLikeItsSource) {
  EXPECT_EQ(print_definition(mass_matrix()),
            "A = σ z^dT (-(Λ(c_fD))^T m^d J_v + D^T J_c^d D z^d σ) + (E-σ) z^dT D^T m^d J_v");
  EXPECT_EQ(print_definition(velocity_jacobian(centres_of_mass())),
            "J_v = D z^d (E-σ) + Λ^T(c_fD) z^d σ");
}

TEST(Equation3, ReadsLikeItsSource) {
  EXPECT_EQ(print_definition(bias_matrix(centres_of_mass())),
            "K(c_ii) = Λ^T(c_fD) Λ^T(z^d σ q̇^d) (D-E) + 2 D Λ^T(z^d (E-σ) q̇^d) (D-E) + "
            "Λ^T(Λ^T(c_fD) z^d σ q̇^d D + Λ^T(c_fD) diagb((D-E) z^d σ q̇))");
  EXPECT_EQ(print_definition(bias_force()),
            "B = σ z^dT (-(Λ(c_fD))^T m^d K(c_ii) + D^T J_c^d D σ q̇^d Λ^T(z^d) (D-E) + "
            "D^T Λ(diagb(D z^d σ q̇)) J_c^d D) z^d σ q̇ + (E-σ) z^dT D^T m^d K(c_ii) z^d σ q̇");
}

TEST(Equation6, ReadsLikeItsSource) {
  EXPECT_EQ(print_definition(joint_to_link_vectors()), "l_D = D s^d (D-E) + l^d D");
}

TEST(Equation7, ReadsLikeItsSource) {
  EXPECT_EQ(print_definition(joint_to_com_vectors()), "c_fD = l_D + c^d D");
}

TEST(Equation9, ReadsLikeItsSourceWithRowsOfDForPoints) {
  EXPECT_EQ(print_definition(force_jacobian_transpose(points())),
            "C = σ z^dT ((D^T-E) Λ(s^d) D_P^T + D_P^T Λ(t^d)) + (E-σ) z^dT D_P^T");
  EXPECT_EQ(print_definition(points().D_P), "D_P = W^T D");
}

TEST(Equation11, ReadsLikeItsSource) {
  EXPECT_EQ(print_definition(moment_jacobian_transpose(points())), "H = σ z^dT D_P^T");
}

TEST(AccelerationRows, ReadLikeTheirSource) {
  EXPECT_EQ(print_definition(point_bias_acceleration()), "γ_f = K z^d σ q̇");
  EXPECT_EQ(print_definition(angular_bias_acceleration()),
            "γ_n = D_P σ q̇^d Λ^T(z^d) (D-E) z^d σ q̇");
}

TEST(ReactionRows, ReadLikeTheirSource) {
  EXPECT_EQ(print_definition(reaction_jacobian_transpose()), "J^T = C S_f + H S_n");
  EXPECT_EQ(print_definition(reaction_bias_acceleration()),
            "γ = S_f^T (γ_f + Λ(diagb(H^T q̇)) u) + S_n^T γ_n + Ṡ_f^T C^T q̇ + Ṡ_n^T H^T q̇");
  EXPECT_EQ(block::to_string(reaction_jacobian_transpose().shape()), "N×r");
}

TEST(GravityForce, IsForceAtCentresOfMass) {
  EXPECT_EQ(print_definition(gravity_force()), "G = -C(c_ii) m^d g");
}

TEST(Shapes, AreThoseOfTheGeneratedFunctions) {
  const auto shape = [](const char* name) {
    return block::to_string(find(name)->expression->shape());
  };
  EXPECT_EQ(shape("mass_matrix"), "N×N");
  EXPECT_EQ(shape("bias_force"), "N×1");
  EXPECT_EQ(shape("force_jacobian_transpose"), "N×3P");
  EXPECT_EQ(shape("moment_jacobian_transpose"), "N×3P");
  EXPECT_EQ(shape("joint_to_com_vectors"), "3N×N");
  EXPECT_EQ(shape("point_bias_acceleration"), "3P×1");
  EXPECT_EQ(shape("kinetic_energy"), "1×1");
}

TEST(Table, KnowsNoOtherNames) { EXPECT_EQ(find("mass"), nullptr); }

}  // namespace
}  // namespace treedyn::equations
