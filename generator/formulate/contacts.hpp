// Ground contacts: force laws that act while a point is below its plane.
#pragma once

#include <vector>

#include "formulate/scene_forces.hpp"

namespace treedyn::formulate {

/// Depth of every contact's point below its plane, m.
std::vector<Expr> contact_depths(const Task& task, const SceneForces& forces);

/// Input arrays of the functions of one contact, after q and qd.
inline constexpr int kDepthArray = 2;   ///< of all contacts, or of this one
inline constexpr int kNormalArray = 3;  ///< f of the law, not negative
inline constexpr int kForceArray = 4;   ///< joint forces

/// True if the law takes d^n for an n that is no multiple of 1/2. The functions of the contact then
/// have d^n as their last input array.
bool needs_power(const model::GroundContact& contact);

/// A contact of the scene while its point is below the plane. Values: the law's f, before negative
/// ones become zero (1), and the joint forces with J^T of the contact force added (N).
std::vector<Expr> build_contact_press(const Task& task, std::size_t contact);

/// The depth (1), the law's f (1) and the force at the point, base frame (3).
std::vector<Expr> build_contact_force(const Task& task, std::size_t contact);

}  // namespace treedyn::formulate
