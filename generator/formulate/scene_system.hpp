// The equations of motion of a scene without its constraints: A x + h = tau, EQUATIONS.md (8), 6.5.
#pragma once

#include <optional>
#include <vector>

#include "formulate/scene_forces.hpp"
#include "formulate/scene_frame.hpp"

namespace treedyn::formulate {

/// A(q) and the forces of a scene in the coordinates of its SceneFrame, in the unit of mass of the
/// scene's tree. \pre the task's tree is in that unit
class SceneSystem {
 public:
  /// \param forces  false: A alone; only q is read
  SceneSystem(const Task& task, const SceneArrays& arrays, bool forces = true);

  [[nodiscard]] const SceneFrame& frame() const { return *frame_; }
  [[nodiscard]] int dof() const { return task_.tree.dof(); }
  [[nodiscard]] const SparseSymmetric& inertia() const { return a_; }
  /// Forces of the joints: drives, springs, friction ..
  [[nodiscard]] const std::vector<Expr>& tau() const { return tau_; }
  /// B + G less what loads do: C f + H n.
  [[nodiscard]] const std::vector<Expr>& h() const { return h_; }
  [[nodiscard]] const SceneForces& forces() const { return forces_; }
  /// Variables of expressions that belong to the scene as a whole.
  [[nodiscard]] const Meaning& meaning() const { return forces_.meaning(); }
  /// Reactions or impulses in N, N m, N s, .. for those that the equations give.
  [[nodiscard]] std::vector<Expr> reactions(std::vector<Expr> of_unit) const;
  /// qdd for x.
  [[nodiscard]] std::vector<Expr> accelerations(const std::vector<Expr>& x) const;
  /// The velocity coordinates that belong to x, for joint velocities. \pre not `forces`
  [[nodiscard]] std::vector<Expr> velocities(const std::vector<Expr>& qd) const;
  /// Changes of qd for changes of `velocities`.
  [[nodiscard]] std::vector<Expr> joint_velocities(const std::vector<Expr>& x) const;

 private:
  void add_equations(bool forces);
  void add_armatures();

  const Task& task_;
  const model::Scene& scene_;
  Real unit_;
  SceneForces forces_;
  std::optional<Trunk> trunk_;
  std::optional<SceneFrame> frame_;
  SparseSymmetric a_;
  std::vector<Expr> tau_;
  std::vector<Expr> h_;
};

/// True if scenes of this tree without constraints can do with articulated bodies.
bool can_be_articulated(const model::Scene& scene);

/// qdd of a scene without constraints, by articulated bodies. \pre can_be_articulated
std::vector<Expr> articulated_accelerations(const Task& task, const SceneForces& forces);

}  // namespace treedyn::formulate
