// The symbols of EQUATIONS.md 1 and 2 as block leaves. Columns of ones and W are our additions.
#pragma once

#include "block/block.hpp"

namespace treedyn::equations {

using block::Expression;

inline constexpr block::Side kOne{block::Set::kOne, 1};
inline constexpr block::Side kLinks{block::Set::kLinks, 1};     // N
inline constexpr block::Side kLinks3{block::Set::kLinks, 3};    // 3N
inline constexpr block::Side kPoints{block::Set::kPoints, 1};   // P
inline constexpr block::Side kPoints3{block::Set::kPoints, 3};  // 3P

// Known from the tree alone.
inline const Expression D = leaf("D", block::Structure::kReachability, {kLinks, kLinks});
inline const Expression E = leaf("E", block::Structure::kIdentity, {kLinks, kLinks});
inline const Expression sigma = leaf("σ", block::Structure::kRevolute, {kLinks, kLinks});
/// Π, N x N: 1 iff j is the father of i; D = (E-Π)^-1.
inline const Expression Pi = leaf("Π", block::Structure::kFather, {kLinks, kLinks});
/// W, N x P: 1 iff link i carries point p. The paper has one point on every link: W = E.
inline const Expression W = leaf("W", block::Structure::kCarrier, {kLinks, kPoints});
/// Columns of ones: x^d ones is the column of the blocks of x^d.
inline const Expression ones = leaf("1_N", block::Structure::kOnes, {kLinks, kOne});
inline const Expression ones_P = leaf("1_P", block::Structure::kOnes, {kPoints, kOne});

// Constants of the links and functions of q (EQUATIONS.md 1.2, all vectors in the base frame).
inline const Expression m_d = leaf("m^d", block::Structure::kDiagonal, {kLinks, kLinks});
inline const Expression J_d = leaf("J_c^d", block::Structure::kDiagonal, {kLinks3, kLinks3});
inline const Expression z_d = leaf("z^d", block::Structure::kDiagonal, {kLinks3, kLinks});
inline const Expression s_d = leaf("s^d", block::Structure::kDiagonal, {kLinks3, kLinks});
inline const Expression l_d = leaf("l^d", block::Structure::kDiagonal, {kLinks3, kLinks});
inline const Expression c_d = leaf("c^d", block::Structure::kDiagonal, {kLinks3, kLinks});
inline const Expression t_d = leaf("t^d", block::Structure::kDiagonal, {kPoints3, kPoints});

// Rows of reactions, 6.2: directions at points (a point may serve several rows, a row several
// points).
inline constexpr block::Side kRows{block::Set::kRows, 1};  // r
inline const Expression S_f = leaf("S_f", block::Structure::kRowPoints, {kPoints3, kRows});
inline const Expression S_n = leaf("S_n", block::Structure::kRowPoints, {kPoints3, kRows});
/// Their rates of change, for directions that move.
inline const Expression Sd_f = leaf("Ṡ_f", block::Structure::kRowPoints, {kPoints3, kRows});
inline const Expression Sd_n = leaf("Ṡ_n", block::Structure::kRowPoints, {kPoints3, kRows});
/// Velocities of contact points relative to their links, 6.2 (rolling); 0 for points attached to
/// links.
inline const Expression u = leaf("u", block::Structure::kFull, {kPoints3, kOne});

/// Reactions, or impulses, of the rows; accelerations that the rows want.
inline const Expression lambda = leaf("λ", block::Structure::kFull, {kRows, kOne});
inline const Expression a_des = leaf("a_des", block::Structure::kFull, {kRows, kOne});

/// Joints without a drive: their columns of E, N x p.
inline constexpr block::Side kPassive{block::Set::kPassive, 1};  // p
inline const Expression E_u = leaf("E_u", block::Structure::kFull, {kLinks, kPassive});
/// Velocities after an impact less those before; 1 + the coefficient of restitution, 0 of rows that
/// are led through it.
inline const Expression qd_change = leaf("Δq̇", block::Structure::kFull, {kLinks, kOne});
inline const Expression rebound = leaf("(1+e)^d", block::Structure::kDiagonal, {kRows, kRows});

// Motion and forces.
inline const Expression qd_d = leaf("q̇^d", block::Structure::kDiagonal, {kLinks, kLinks});
inline const Expression qd = leaf("q̇", block::Structure::kFull, {kLinks, kOne});
inline const Expression qdd = leaf("q̈", block::Structure::kFull, {kLinks, kOne});
/// Drive torques and forces.
inline const Expression tau = leaf("τ", block::Structure::kFull, {kLinks, kOne});
inline const Expression f_b = leaf("f_b", block::Structure::kFull, {kPoints3, kOne});
inline const Expression n_b = leaf("n_b", block::Structure::kFull, {kPoints3, kOne});
/// The gravity vector, once for every link.
inline const Expression g = leaf("g", block::Structure::kFull, {kLinks3, kOne});

}  // namespace treedyn::equations
