// Constraint rows of a scene: errors, Jacobian and right-hand side of J qdd + gamma = a_des.
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "simulation/forces.hpp"

namespace treedyn::simulation {

/// The rows that act now, EQUATIONS.md 6.2; constraint by constraint, direction by direction.
class Constraints {
 public:
  explicit Constraints(const model::Scene& scene);

  /// \param constraints  ascending indices
  void activate(const std::vector<int>& constraints);
  [[nodiscard]] const std::vector<int>& active() const { return active_; }
  [[nodiscard]] int rows() const { return static_cast<int>(rows_.size()); }
  /// True for rows whose reaction is a force from outside (not a moment, not inside a loop).
  [[nodiscard]] bool is_force(int row) const;
  [[nodiscard]] const Eigen::Vector3d& direction(int row) const { return at(row).d; }

  /// The orientation that a constraint holds is that of now.
  void hold(int constraint, const Terms& terms);
  /// The curve of a constraint moves such that its point is on it now.
  void pin(int constraint, double t, const Terms& terms);

  /// J, r x N.
  void jacobian(const Terms& terms, Matrix& J) const;
  /// Position errors, m or rad.
  void errors(const Terms& terms, double t, Vector& phi) const;
  /// Wanted J qd: the velocity of the curves.
  void velocities(double t, Vector& rate) const;
  /// a_des - gamma, without stabilisation.
  void accelerations(const Terms& terms, double t, Vector& rhs) const;

 private:
  struct Curve {
    Eigen::Vector3d center, velocity, u, v;
    double A1, A2, omega, phase;
    [[nodiscard]] Eigen::Vector3d at(double t, int derivative) const;
  };
  struct Item {
    model::ConstraintKind kind;
    int point, other;
    std::vector<Eigen::Vector3d> directions;
    Curve curve;
    Eigen::Matrix3d orientation;
  };
  struct Row {
    int item;
    Eigen::Vector3d d;
  };
  [[nodiscard]] const Row& at(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] const Item& item(int k) const { return items_[static_cast<std::size_t>(k)]; }

  std::vector<Item> items_;
  std::vector<int> active_;
  std::vector<Row> rows_;
};

}  // namespace treedyn::simulation
