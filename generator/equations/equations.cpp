#include "equations/equations.hpp"

#include "block/rewrite.hpp"
#include "equations/symbols.hpp"

namespace treedyn::equations {

using block::diagb;
using block::named;
using block::skew;            // Λ(X): positions kept
using block::skew_transpose;  // Λ^T(X): blocks transposed, positions kept (E11)
using block::transpose;       // ^T: block positions swapped (E10)

Attached points() {
  const Expression D_P = named("D_P", transpose(W) * D);
  return {"", D_P, t_d, named("t_fD", D_P * s_d * (D - E) + t_d * D_P)};
}

Attached centres_of_mass() {
  return {"(c_ii)", D, named("c_ii^d", l_d + c_d), joint_to_com_vectors()};
}

// (6)
Expression joint_to_link_vectors() { return named("l_D", D * s_d * (D - E) + l_d * D); }

// (7)
Expression joint_to_com_vectors() { return named("c_fD", joint_to_link_vectors() + c_d * D); }

// below (2)
Expression velocity_jacobian(const Attached& at) {
  return named("J_v", at.D_P * z_d * (E - sigma) + skew_transpose(at.t_fD) * z_d * sigma);
}

Expression angular_jacobian() { return named("J_ω", D * z_d * sigma); }

// (2)  The subscripts c_f^p, c_fb, c_fd of the print are one matrix, c_fD (E13).
Expression mass_matrix() {
  const Expression c_fD = joint_to_com_vectors();
  const Expression J_v = velocity_jacobian(centres_of_mass());  // the bracket of both halves
  const Expression z_dT = transpose(z_d);
  const Expression D_T = transpose(D);
  const Expression revolute = -transpose(skew(c_fD)) * m_d * J_v + D_T * J_d * D * z_d * sigma;
  const Expression prismatic = D_T * m_d * J_v;
  return named("A", sigma * z_dT * revolute + (E - sigma) * z_dT * prismatic);
}

// K of (3), T1 + T2 + T3.
// E1: print has Λ^T(c)(D-E) σ z^d q̇^d in T3; ω_f(j) has to be summed first and put on the diagonal.
// E2: T2 stands inside the bracket, behind mass and lever arm.
// E4: the outer Λ^T of T3 is missing in the prismatic half; here both halves share this K.
// E16: the factor 2 of T2 is right and complete, T3 takes no prismatic rates.
Expression bias_matrix(const Attached& at) {
  const Expression& t_fD = at.t_fD;
  const Expression T1 = skew_transpose(t_fD) * skew_transpose(z_d * sigma * qd_d) * (D - E);
  const Expression T2 = 2 * at.D_P * skew_transpose(z_d * (E - sigma) * qd_d) * (D - E);
  const Expression T3 = skew_transpose(skew_transpose(t_fD) * z_d * sigma * qd_d * D +
                                       skew_transpose(t_fD) * diagb((D - E) * z_d * sigma * qd));
  return named("K" + at.label, T1 + T2 + T3);
}

// (3)  One K in both halves. E5: the last factor is the column z^d σ q̇, not z^d σ q̇^d.
// E3: print has Λ(D z^d σ q̇^d) in the gyroscopic term, which couples ω_j with J of another link.
Expression bias_force() {
  const Expression c_fD = joint_to_com_vectors();
  const Expression K = bias_matrix(centres_of_mass());
  const Expression w = z_d * sigma * qd;
  const Expression z_dT = transpose(z_d);
  const Expression D_T = transpose(D);
  const Expression revolute = -transpose(skew(c_fD)) * m_d * K +
                              D_T * J_d * D * sigma * qd_d * skew_transpose(z_d) * (D - E) +
                              D_T * skew(diagb(D * w)) * J_d * D;
  const Expression prismatic = D_T * m_d * K;
  return named("B", sigma * z_dT * revolute * w + (E - sigma) * z_dT * prismatic * w);
}

// (9); (4) is its misprinted copy (E6: there the last term is (E-σ) z^d instead of (E-σ) z^dT D^T).
// C is the transposed Jacobian of the points (E17).
Expression force_jacobian_transpose(const Attached& at) {
  const Expression z_dT = transpose(z_d);
  const Expression D_PT = transpose(at.D_P);
  const Expression revolute = (transpose(D) - E) * skew(s_d) * D_PT + D_PT * skew(at.t_d);
  return named("C" + at.label, sigma * z_dT * revolute + (E - sigma) * z_dT * D_PT);
}

// (5) = (11)
Expression moment_jacobian_transpose(const Attached& at) {
  return named("H", sigma * transpose(z_d) * transpose(at.D_P));
}

// (8), the external forces; n_b, not n'_b, stands here (E12)
Expression applied_force() {
  return named(
      "Q", force_jacobian_transpose(points()) * f_b + moment_jacobian_transpose(points()) * n_b);
}

// (1) without external forces
Expression inverse_dynamics() {
  return named("τ", mass_matrix() * qdd + bias_force() + gravity_force());
}

// (1), zero for the accelerations
Expression forward_dynamics() { return mass_matrix() * qdd + bias_force() + gravity_force() - tau; }

// 7.4
Expression mass_matrix_factor() {
  const Expression L = leaf("L", block::Structure::kAlongPaths, {kLinks, kLinks});
  const Expression Delta = leaf("Δ", block::Structure::kDiagonal, {kLinks, kLinks});
  return mass_matrix() - transpose(L) * Delta * L;
}

Expression mass_matrix_solve() {
  const Expression x = leaf("x", block::Structure::kFull, {kLinks, kOne});
  const Expression b = leaf("b", block::Structure::kFull, {kLinks, kOne});
  return mass_matrix() * x - b;
}

Expression mass_matrix_inverse() {
  const Expression X = leaf("X", block::Structure::kFull, {kLinks, kLinks});
  return mass_matrix() * X - E;
}

// 6.5: gravity is a force f_i = m_i g at the centre of mass, so C takes t_i = c_ii (E20)
Expression gravity_force() {
  return named("G", -force_jacobian_transpose(centres_of_mass()) * m_d * g);
}

// 6.1
Expression point_bias_acceleration() {
  return named("γ_f", bias_matrix(points()) * z_d * sigma * qd);
}

// 6.1, the rows of the links that carry the points
Expression angular_bias_acceleration() {
  const Expression w = z_d * sigma * qd;
  return named("γ_n", points().D_P * sigma * qd_d * skew_transpose(z_d) * (D - E) * w);
}

// 6.2, R = S λ: L_R S
Expression reaction_jacobian_transpose() {
  return named(
      "J^T", force_jacobian_transpose(points()) * S_f + moment_jacobian_transpose(points()) * S_n);
}

// 6.2: S^T (γ_f + ω × u ; γ_n) + Ṡ^T L_R^T q̇
Expression reaction_bias_acceleration() {
  const Expression C = force_jacobian_transpose(points());
  const Expression H = moment_jacobian_transpose(points());
  const Expression omega = transpose(H) * qd;
  const Expression gamma_f = point_bias_acceleration() + skew(diagb(omega)) * u;
  return named("γ", transpose(S_f) * gamma_f + transpose(S_n) * angular_bias_acceleration() +
                        transpose(Sd_f) * transpose(C) * qd + transpose(Sd_n) * omega);
}

Expression bias_of_attached_rows() {
  return named("γ", block::without(reaction_bias_acceleration(), {"u", "Ṡ_f", "Ṡ_n"}).value());
}

// (8), what drives and reactions give
Expression loaded_dynamics() {
  return mass_matrix() * qdd + bias_force() + gravity_force() - applied_force();
}

// (8) without reactions, zero for the accelerations
Expression free_dynamics() { return loaded_dynamics() - tau; }

// (8) with R = S λ, for q̈ and λ
Constrained constrained_dynamics() {
  const Expression J_T = reaction_jacobian_transpose();
  return {free_dynamics() - J_T * lambda, transpose(J_T) * qdd + bias_of_attached_rows() - a_des};
}

// (8) with R = S λ, for τ and the least λ by which joints without a drive need none
LeastReactions constrained_inverse_dynamics() {
  const Expression J_T = reaction_jacobian_transpose();
  const Expression h = named("h", loaded_dynamics());
  return {transpose(E_u) * J_T * lambda - transpose(E_u) * h, named("τ", h - J_T * lambda)};
}

// 6.4, for Δ = q̇+ - q̇-; q̇ is that before
Constrained impact() {
  const Expression J_T = reaction_jacobian_transpose();
  return {mass_matrix() * qd_change - J_T * lambda,
          transpose(J_T) * qd_change + named("v", rebound * (transpose(J_T) * qd))};
}

Expression point_positions() { return named("p", points().D_P * s_d * ones + t_d * ones_P); }

Expression point_velocities() {
  return named("v", transpose(force_jacobian_transpose(points())) * qd);
}

Expression kinetic_energy() {
  return named("T", block::Ratio{1, 2} * (transpose(qd) * mass_matrix() * qd));
}

Expression potential_energy() {
  const Expression r = D * s_d * ones + centres_of_mass().t_d * ones;  // centres of mass
  return named("U", -(transpose(g) * m_d * r));
}

}  // namespace treedyn::equations
