// Equations (2)-(11) of EQUATIONS.md and the rows of its section 6, each written once.
//
// Every function returns a block expression (block/block.hpp) that reads like its equation; nothing
// is computed here. `block::Plan` finds the zero blocks for a tree, `engine` puts numbers in,
// `expansion` puts symbols in. The errata (E1..) are those of EQUATIONS.md 4: what the printed
// paper has wrong.
//
//   (2)  mass_matrix                      (6)   joint_to_link_vectors
//   (3)  bias_force                       (7)   joint_to_com_vectors
//   (9)  force_jacobian_transpose = (4)   (11)  moment_jacobian_transpose = (5)
//   (10) (9) with the points of the reactions
//
// Points generalise the paper's one point a link: W (N x P) says which link carries which point,
// the rows of D that belong to the points are D_P = W^T D, and the paper's equations are those for
// W = E.
#pragma once

#include <string>

#include "block/block.hpp"

namespace treedyn::equations {

using block::Expression;

/// Points attached to links: where their links stand in the tree, and their places.
struct Attached {
  std::string label;  ///< of what depends on the points: C(c_ii)
  Expression D_P;     ///< P x N: row p is the row of D of the link that carries point p
  Expression t_d;   ///< 3P x P: t_p, point p minus P_i, base frame; contains the link's slide (E15)
  Expression t_fD;  ///< 3P x N, m: block (p,j) = point p minus P_j for j ≼ i
};

/// The points that were asked for: D_P = W^T D, t_fD = D_P s^d (D-E) + t^d D_P.
Attached points();
/// The centres of mass: one on every link, t_i = c_ii = l_ii + c_i, t_fD = c_fD.
Attached centres_of_mass();

/// (6) l_D, 3N x N, m: block (i,j) = O_i - P_j for j ≼ i.
Expression joint_to_link_vectors();
/// (7) c_fD, 3N x N, m: block (i,j) = CoM of link i minus P_j for j ≼ i.
Expression joint_to_com_vectors();
/// J_v of the centres of mass (3N x N) or of points (3P x N), C^T of (9).
Expression velocity_jacobian(const Attached& at);
/// J_ω = D z^d σ, 3N x N; A = J_v^T m^d J_v + J_ω^T J_c^d J_ω.
Expression angular_jacobian();

/// (2) A(q), N x N, kg m^2 | kg m | kg.
Expression mass_matrix();

/// (3) B(q, q̇), N, N m | N, without gravity.
Expression bias_force();

/// K of (3) for any points, 3P x 3N: γ_f = K z^d σ q̇, a0 for the centres of mass.
Expression bias_matrix(const Attached& at);

/// (4) = (9) C, N x 3P: C f is the joint force of forces at the points. (10): the same for the
/// points of the reactions.
Expression force_jacobian_transpose(const Attached& at);

/// (5) = (11) H, N x 3P: H n is the joint force of moments on the links that carry the points.
Expression moment_jacobian_transpose(const Attached& at);

/// (8) C f_b + H n_b, N.
Expression applied_force();

/// (1) A q̈ + B + G, N, with gravity on the left-hand side.
Expression inverse_dynamics();
Expression forward_dynamics();

/// 7.4, zero for the unknown that comes last: A - L^T Δ L, A x - b, A X - E.
Expression mass_matrix_factor();
Expression mass_matrix_solve();
Expression mass_matrix_inverse();

/// 6.5, N: the left-hand side term G = -C(c_ii) m^d g = +∂U/∂q.
Expression gravity_force();

/// 6.1 γ_f, 3P: accelerations of the points for q̈ = 0.
Expression point_bias_acceleration();
/// 6.1 γ_n = α0, 3P: angular accelerations of the links that carry the points for q̈ = 0.
Expression angular_bias_acceleration();

/// 6.2 J^T = C_R S_f + H S_n, N x r: unit reactions along the columns of S. A row between two links
/// a, b has +d at its point of a and -d at its point of b.
Expression reaction_jacobian_transpose();
/// 6.2 γ, r: J q̈ + γ is the acceleration along the rows. With Ṡ for directions that move and u for
/// contact points that creep over their links.
Expression reaction_bias_acceleration();
/// The same of points that stay on their links and directions that stay in the base: u and Ṡ are 0.
Expression bias_of_attached_rows();

/// (8): A q̈ + B + G - Q, what drives and reactions give.
Expression loaded_dynamics();
/// The same less τ: zero for the accelerations of a scene without rows.
Expression free_dynamics();

/// Two columns, zero for an unknown of the joints and for λ of the rows.
struct Constrained {
  Expression motion;
  Expression rows;
};
/// (8) and 6.2: A q̈ + B + G - Q - τ - J^T λ and J q̈ + γ - a, for q̈ and λ.
Constrained constrained_dynamics();
/// 6.4: A Δq̇ - J^T λ and J Δq̇ + (1+e)^d J q̇, for Δq̇ and impulses λ; q̇ is that before.
Constrained impact();

/// Zero for reactions λ, and the forces of drives that they leave.
struct LeastReactions {
  Expression passive;
  Expression drives;
};
/// 6.2: E_u^T J^T λ - E_u^T h and τ = h - J^T λ with h = A q̈ + B + G - Q.
LeastReactions constrained_inverse_dynamics();

/// p, 3P: positions, base frame (s_i of a root link is P_i here).
Expression point_positions();
/// v = C^T q̇, 3P.
Expression point_velocities();

/// T = 1/2 q̇^T A q̇, J.
Expression kinetic_energy();
/// U = -Σ m_i g·r_i, J; zero at the base origin.
Expression potential_energy();

}  // namespace treedyn::equations
