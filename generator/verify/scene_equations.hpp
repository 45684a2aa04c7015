// The equations of a scene at one state in 50 digits, as the engine evaluates them.
#pragma once

#include <vector>

#include "engine/engine.hpp"
#include "model/scene.hpp"

namespace treedyn::verify {

/// (8) and the rows of 6.1 of a scene: A qdd + bias - J^T lambda = force, J qdd + gamma = wanted.
class SceneEquations {
 public:
  using Values = std::vector<Real>;

  /// One constraint row.
  struct Row {
    Values J;
    Real gamma = 0;
    Real wanted = 0;
  };

  /// \param t       s
  /// \param anchor  of all constraints, model::anchor_offset; missing ones are zero
  SceneEquations(const model::Scene& scene, Values q, Values qd, const Real& t, Values anchor = {});

  /// A with the armatures, row by row.
  [[nodiscard]] const std::vector<Values>& inertia() const { return A_; }
  /// B + G.
  [[nodiscard]] const Values& bias() const { return bias_; }
  /// The rows of these constraints, one per direction.
  [[nodiscard]] std::vector<Row> rows(const std::vector<int>& active) const;
  /// Drives, springs, friction and loads as joint forces; ground contacts and sticking friction are
  /// not among them.
  [[nodiscard]] Values force() const;

  /// f of a contact's law at a depth, N; may be negative.
  [[nodiscard]] Real contact_law(const model::GroundContact& contact, const Real& depth) const;
  /// Joint forces of a contact that presses with `normal`, friction included.
  [[nodiscard]] Values contact(const model::GroundContact& contact, const Real& normal) const;

 private:
  [[nodiscard]] Real normal_speed(const model::GroundContact& contact) const;
  /// A law at this depth, or of this force that presses.
  [[nodiscard]] Real in_contact(const model::Expression& law, const model::GroundContact& contact,
                                const Real& depth, const Real& press) const;
  [[nodiscard]] Real value(const model::Expression& expression, int point) const;
  [[nodiscard]] Real variable(const model::Variable& variable, int point) const;
  void evaluate_rows(const Values& rates);
  [[nodiscard]] Real wanted(const model::Constraint& constraint, std::size_t k) const;
  [[nodiscard]] Real position_error(int constraint, std::size_t k) const;
  [[nodiscard]] model::Vector3 turn_from(const Real* anchor, int point) const;
  [[nodiscard]] Real correction(const Row& row, int constraint, std::size_t k) const;
  void add_joint_forces(Values& force) const;
  void apply(const model::Vector3& value, int point, const Values& jacobian, Values& force) const;

  const model::Scene& scene_;
  Values q_, qd_, anchor_;
  Real t_;
  int dof_;
  std::vector<Values> A_;
  Values bias_, C_, H_, p_, v_, R_;
  std::vector<std::vector<Row>> rows_;  ///< of every constraint; nothing is wanted of them
};

}  // namespace treedyn::verify
