// Constraint rows of a scene: errors, Jacobian and right-hand side of J qdd + gamma = a_des.
#pragma once

#include <array>
#include <vector>

#include "model/scene.hpp"
#include "simulation/forces.hpp"
#include "simulation/state.hpp"

namespace treedyn::simulation {

/// The rows that act now, EQUATIONS.md 6.2; constraint by constraint, direction by direction.
class Constraints {
 public:
  explicit Constraints(const model::Scene& scene);

  /// \param constraints  ascending indices
  void activate(const std::vector<int>& constraints);
  [[nodiscard]] const std::vector<int>& active() const { return active_; }
  [[nodiscard]] int rows() const { return static_cast<int>(rows_.size()); }
  [[nodiscard]] const Eigen::Vector3d& direction(int row) const { return at(row).d; }
  [[nodiscard]] int constraint(int row) const { return at(row).item; }
  /// Which of its constraint's rows it is.
  [[nodiscard]] std::size_t number(int row) const { return at(row).number; }
  /// False for rows that state their acceleration: neither their speed nor their position is told.
  [[nodiscard]] bool is_held(int row) const { return item(at(row).item).accelerations.empty(); }
  /// False as well for rows that tell a speed only: omega d = 0 is the rate of no angle unless it
  /// holds in all directions.
  [[nodiscard]] bool has_position(int row) const {
    return is_held(row) && item(at(row).item).has_position;
  }

  /// True for rows that hold wherever they begin to act.
  [[nodiscard]] bool begins_anywhere(int row) const {
    const Item& c = item(at(row).item);
    return c.pinned || c.kind == model::ConstraintKind::kOrientation;
  }

  /// As before any motion: none acts, and what pins have moved is where the scene has it.
  void reset();
  /// A constraint begins to act: the orientation that it holds is that of now, and so is the place
  /// of one that is pinned.
  void begin(int constraint, double t, const Vector& q, const Terms& terms);
  /// The curve of a constraint moves such that its point is on it now.
  void pin(int constraint, double t, const Vector& q, const Terms& terms);

  /// J, r x N.
  void jacobian(const Terms& terms, Matrix& J) const;
  /// Position errors, m or rad; 0 where a row has no position.
  void errors(const Terms& terms, double t, const Vector& q, Vector& phi) const;
  /// Wanted J qd: the velocity of the curves; 0 where a row is not held.
  void velocities(double t, Vector& rate) const;
  /// a_des - gamma, without stabilisation.
  void accelerations(const Terms& terms, const State& state, Vector& rhs) const;
  /// -gamma alone: what keeps velocities along the rows.
  void bends(const Terms& terms, Vector& rhs) const;

 private:
  struct Item {
    bool pinned;
    bool has_position;
    model::ConstraintKind kind;
    int point, other, joint;
    std::vector<Eigen::Vector3d> directions;
    std::array<VectorValue, 3> curve;  ///< and its derivatives
    std::vector<model::Expression> accelerations;
    Eigen::Vector3d shift;  ///< of the curve, by pins
    Eigen::Matrix3d orientation;
  };
  struct Row {
    int item;
    std::size_t number;  ///< in its constraint
    Eigen::Vector3d d;
  };
  [[nodiscard]] Eigen::Vector3d position(const Item& item, double t) const;
  [[nodiscard]] double bias(const Terms& terms, const Row& row) const;
  [[nodiscard]] const Row& at(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] const Item& item(int k) const { return items_[static_cast<std::size_t>(k)]; }

  std::vector<Item> items_;
  std::vector<int> active_;
  std::vector<Row> rows_;
};

}  // namespace treedyn::simulation
