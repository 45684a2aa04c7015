// Accelerations, reactions, impacts and corrections of a scene in one state.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "model/scene.hpp"
#include "simulation/constraints.hpp"
#include "simulation/min_norm.hpp"

namespace treedyn::simulation {

using Drift = model::Drift;

/// Newton steps of one projection, and the position error (m, rad) at which it is content.
inline constexpr int kProjectionSteps = 3;
inline constexpr double kProjectionError = 1e-15;

/// The square of a singular value of J, its rows scaled to one size, below this counts as zero: a
/// position so near to a singular one counts as that. Masses take no part.
inline constexpr double kRankThreshold = 1e-11;

/// Radius of the curve in which rows lead the joints, rad or sizes of the mechanism, below which a
/// singular position is near.
inline constexpr double kSharp = 0.1;

/// What (8) gives for one state.
struct Solution {
  Vector qdd;           ///< N, unique
  Vector lambda;        ///< r, smallest Euclidean norm, on the links
  int rank = 0;         ///< of the active rows
  double residual = 0;  ///< max |J qdd + gamma - a_des|
  Vector residuals;     ///< r, row by row, with signs
  Vector wanted;        ///< r, a_des - gamma
  double power = 0;     ///< of all that acts apart from gravity and what stores energy, W
  /// How fast the rows turn the velocity, rad/s in the metric A, where they are curved sharply: a
  /// singular position is near; else 0. And then how far beside them the state is: what errors of
  /// position turn their tangent by, and the part of the velocity that is not along it.
  double turn = 0;
  double beside = 0;
  int turning = 0;  ///< the row that asks most for it
};

/// Dry friction of a joint: the sign of its velocity while it slips, 0 while it sticks.
struct DryFriction {
  int joint = 0;
  double force = 0;
  int direction = 0;

  /// A little more than `force`: a joint that breaks away is accelerated beyond rounding.
  [[nodiscard]] double hold() const { return force * (1 + 1e-11); }
};

/// A point on its way along a normal: what presses it, and what would feel it.
struct Arrival {
  double mass;          ///< 1/(n^T C^T A^-1 C n), kg; infinite if nothing moves it
  double speed;         ///< m/s
  double acceleration;  ///< m/s^2
};

class System {
 public:
  /// \param stabilisation  alpha of a_des - 2 alpha phi' - alpha^2 phi, 1/s; 0: none
  System(const model::Scene& scene, Dynamics& dynamics, double stabilisation);

  [[nodiscard]] int dof() const { return terms_.dof(); }
  Constraints& constraints() { return constraints_; }
  std::vector<DryFriction>& frictions() { return frictions_; }
  Forces& forces() { return forces_; }
  /// Instead of kRankThreshold, to see what depends on it.
  void set_rank_threshold(double threshold) { rank_threshold_ = threshold; }

  /// EQUATIONS.md 6.2, 6.3. \throws std::runtime_error if A is not positive definite
  const Solution& accelerate(double t, const Vector& q, const Vector& qd);
  /// Rows of the last `accelerate`, sticking joints behind them.
  [[nodiscard]] const Matrix& rows() const { return J_; }
  /// The force that holds a sticking joint, of the last `accelerate`.
  [[nodiscard]] double holding_force(std::size_t friction) const;
  /// Of the last `accelerate`, whose qd and qdd these are.
  [[nodiscard]] Arrival arrival(int point, const Eigen::Vector3d& normal, const Vector& qd,
                                const Vector& qdd) const;
  /// What the last `accelerate` gave.
  [[nodiscard]] const Solution& last() const { return solution_; }
  [[nodiscard]] const Constraints& constraints() const { return constraints_; }

  /// The force of an active point constraint on its link, base frame, N.
  Eigen::Vector3d reaction(double t, const Vector& y, int constraint);

  /// q and qd on the active rows by the smallest corrections in the metric A, those that reactions
  /// make: what a singular position let go is undone behind it.
  void project(double t, Vector& q, Vector& qd);
  /// Speeds along the rows that the last `project` has taken.
  [[nodiscard]] const Vector& pulled() const { return pulled_; }
  /// Takes from an error of y = (q; qd) what `project` corrects: its part across the rows.
  void remove_normal(double t, const Vector& y, Vector& error);
  /// EQUATIONS.md 6.4 for all rows of its constraints, whatever its own restitution is; changes qd.
  /// \return impulses, N s or N m s
  Vector impact(double t, const Vector& q, Vector& qd, const model::Impact& impact,
                double restitution);
  /// The largest error of the active rows, and the constraint whose row it is; none: -1.
  struct Violation {
    double size = 0;
    int constraint = -1;
  };
  /// Of the changes of speed that the last impact should have made, and the largest of these, m/s
  /// or rad/s; not finite where what leads a row has no rate: nothing has changed.
  [[nodiscard]] std::pair<Violation, double> unmet() const { return {unmet_, change_}; }
  /// Of positions, m or rad.
  Violation violation(double t, const Vector& q);
  /// Of velocities, m/s or rad/s.
  Violation speed_violation(double t, const Vector& q, const Vector& qd);

  /// p, C, R, H in this position.
  const Terms& geometry(const Vector& q);
  /// Potential energy apart from gravity's part: springs and contacts.
  double elastic_energy(const Vector& q);
  /// Kinetic energy of the armatures.
  [[nodiscard]] double armature_energy(const Vector& qd) const;

 private:
  /// The rows of a set of constraints and of joints that stick.
  using RowSet = std::pair<std::vector<int>, std::vector<int>>;

  void evaluate(const Vector& q, const Vector& qd);
  void jacobian(const Terms& terms);
  [[nodiscard]] Matrix rows_at(const Terms& terms, const std::vector<int>& sticking) const;
  [[nodiscard]] std::vector<int> sticking_joints() const;
  const OrdinarySizes& ordinary(double t, const Vector& q, const std::vector<int>& sticking);
  [[nodiscard]] OrdinarySizes sizes_now(double t, const Vector& q,
                                        const std::vector<int>& sticking);
  [[nodiscard]] Vector sizes_at(const Vector& q, const std::vector<int>& sticking);
  void factor_inertia(double t);
  void factor_rows(double t, const Vector& q, const Vector& qd);
  void pad(Vector& rows) const;
  void add_stabilisation(double t, const Vector& q, const Vector& qd);
  void keep_held(Vector& rows) const;
  void speed_errors(double t, const Vector& qd);
  [[nodiscard]] Violation largest_of(const Vector& rows) const;
  void add_balance(const State& state);
  void add_turn(const State& state);

  const model::Tree& tree_;
  Dynamics& dynamics_;
  double alpha_;
  bool velocity_products_;
  Vector armature_;  ///< N, on the diagonal of A
  Vector at_rest_;   ///< N zeros
  Constraints constraints_;
  Forces forces_;
  std::vector<DryFriction> frictions_;
  Terms terms_;
  Terms trial_;                 ///< in other positions
  std::vector<double> reach_;   ///< model::reach_of
  std::vector<double> scales_;  ///< by constraint, of its rows
  std::map<RowSet, OrdinarySizes> ordinary_;
  Eigen::LLT<Eigen::MatrixXd> A_;
  MinimumNorm solve_;
  double rank_threshold_ = kRankThreshold;
  Solution solution_;
  Eigen::MatrixXd inertia_;
  Matrix J_, W_;
  Vector Q_, rhs_, bend_, phi_, rate_, pulled_, x_;
  Violation unmet_;
  double change_ = 0;  ///< the largest that an impact should make
  Vector all_lambda_;
};

}  // namespace treedyn::simulation
