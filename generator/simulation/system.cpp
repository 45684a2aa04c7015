#include "simulation/system.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "model/reach.hpp"
#include "model/scene_facts.hpp"
#include "program/row_rank.hpp"

namespace treedyn::simulation {

namespace {

double largest(const Vector& x) { return x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff(); }

/// The joints that move in the direction of the least eigenvalue of A with ones on its diagonal.
std::string joints_without_inertia(const model::Tree& tree, const Eigen::MatrixXd& A) {
  const Vector scale =
      A.diagonal().unaryExpr([](double x) { return x > 0 ? 1 / std::sqrt(x) : 1; });
  const Vector direction =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * A * scale.asDiagonal())
          .eigenvectors()
          .col(0)
          .cwiseAbs();
  std::vector<std::string> names;
  for (int k = 0; k < tree.dof(); ++k) {
    if (direction[k] > direction.maxCoeff() / 10) {
      names.push_back(fmt::format("'{}'", tree.moved_by(k).joint.name));
    }
  }
  return names.size() == 1 ? fmt::format("joint {} moves", names.front())
                           : fmt::format("joints {} together move", fmt::join(names, " and "));
}

}  // namespace

System::System(const model::Scene& scene, Dynamics& dynamics, double stabilisation)
    : tree_(scene.tree),
      dynamics_(dynamics),
      alpha_(stabilisation),
      velocity_products_(scene.velocity_products),
      armature_(Vector::Zero(scene.tree.dof())),
      at_rest_(Vector::Zero(scene.tree.dof())),
      constraints_(scene),
      forces_(scene),
      terms_(scene.tree.dof(), static_cast<int>(scene.points.size()), needs_of(scene)),
      trial_(scene.tree.dof(), static_cast<int>(scene.points.size()), needs_of(scene)),
      reach_(model::reach_of(scene.tree, scene.points)),
      A_(scene.tree.dof()) {
  const double size = model::size_of(scene.tree, scene.points);
  for (const model::Constraint& constraint : scene.constraints) {
    scales_.push_back(model::is_angular(scene.tree, constraint) ? 1 : size);
  }
  for (const model::DryFriction& friction : scene.frictions) {
    frictions_.push_back({friction.joint, static_cast<double>(friction.force), 0});
  }
  for (const model::Armature& armature : scene.armatures) {
    armature_[armature.joint] += static_cast<double>(armature.inertia);
  }
  if (scene.rank_tolerance > 0) {
    rank_threshold_ = scene.rank_tolerance.convert_to<double>();
  }
}

std::vector<int> System::sticking_joints() const {
  std::vector<int> result;
  for (const DryFriction& friction : frictions_) {
    if (friction.direction == 0) {
      result.push_back(friction.joint);
    }
  }
  return result;
}

/// Without velocity products B and gamma are those of a robot at rest: zero.
void System::evaluate(const Vector& q, const Vector& qd) {
  dynamics_.evaluate(q, velocity_products_ ? qd : at_rest_, terms_);
}

/// J of the active rows, then one row for every sticking joint.
Matrix System::rows_at(const Terms& terms, const std::vector<int>& sticking) const {
  Matrix J;
  constraints_.jacobian(terms, J);
  const auto more = static_cast<Eigen::Index>(sticking.size());
  J.conservativeResize(constraints_.rows() + more, dof());
  J.bottomRows(more).setZero();
  for (Eigen::Index k = 0; k < more; ++k) {
    J(constraints_.rows() + k, sticking[static_cast<std::size_t>(k)]) = 1;
  }
  return J;
}

void System::jacobian(const Terms& terms) { J_ = rows_at(terms, sticking_joints()); }

/// Roots of the diagonal of K in a position; zeros where A is not positive definite.
Vector System::sizes_at(const Vector& q, const std::vector<int>& sticking) {
  dynamics_.evaluate(q, at_rest_, trial_);
  Eigen::MatrixXd A = trial_.A();
  A.diagonal() += armature_;
  const Matrix J = rows_at(trial_, sticking);
  const Eigen::LLT<Eigen::MatrixXd> factors(A);
  if (factors.info() != Eigen::Success) {
    return Vector::Zero(J.rows());
  }
  return factors.matrixL().solve(J.transpose()).colwise().norm();
}

/// Sizes and rank of the active rows, and of joints that stick, found when they act first.
const OrdinarySizes& System::ordinary(double t, const Vector& q, const std::vector<int>& sticking) {
  const RowSet key{constraints_.active(), sticking};
  if (const auto found = ordinary_.find(key); found != ordinary_.end()) {
    return found->second;
  }
  Vector start;
  dynamics_.evaluate_geometry(q, trial_);
  constraints_.errors(trial_, t, q, start);
  for (int k = 0; k < constraints_.rows(); ++k) {
    start[k] = constraints_.begins_anywhere(k) ? start[k] : 0;
  }
  program::ConstraintRows rows;
  rows.rows = constraints_.rows() + static_cast<int>(sticking.size());
  rows.columns = dof();
  for (int k = 0; k < constraints_.rows(); ++k) {
    rows.scales.push_back(scales_[static_cast<std::size_t>(constraints_.constraint(k))]);
  }
  for (const int joint : sticking) {
    rows.scales.push_back(reach_[static_cast<std::size_t>(joint)]);
  }
  rows.evaluate = [&](const std::vector<double>& at, std::vector<double>& phi,
                      std::vector<double>& J) {
    const Vector position = Eigen::Map<const Vector>(at.data(), dof());
    dynamics_.evaluate_geometry(position, trial_);
    Vector errors;
    constraints_.errors(trial_, t, position, errors);
    errors -= start;
    std::ranges::copy(errors, phi.begin());
    Eigen::Map<Matrix>(J.data(), rows.rows, dof()) = rows_at(trial_, sticking);
  };
  const program::OrdinaryRows found =
      program::ordinary_rows(rows, {q.data(), q.data() + q.size()}, reach_);
  OrdinarySizes result{Vector::Zero(rows.rows),
                       Eigen::Map<const Vector>(found.lengths.data(), rows.rows),
                       found.holds ? found.rank : -1};
  for (const std::vector<double>& state : found.states) {
    const Vector position = Eigen::Map<const Vector>(state.data(), dof());
    result.sizes = result.sizes.cwiseMax(sizes_at(position, sticking));
  }
  found.raise_rounding(std::span(result.sizes.data(), found.lengths.size()));
  return ordinary_.emplace(key, std::move(result)).first->second;
}

/// The same with the rank that J, which is that of q, has here.
OrdinarySizes System::sizes_now(double t, const Vector& q, const std::vector<int>& sticking) {
  OrdinarySizes result = ordinary(t, q, sticking);
  Eigen::MatrixXd J = J_;
  for (int k = 0; k < dof(); ++k) {
    J.col(k) *= reach_[static_cast<std::size_t>(k)];
  }
  for (Eigen::Index k = 0; k < J.rows(); ++k) {
    J.row(k) /= result.lengths[k] > 0 ? result.lengths[k] : 1;
  }
  const Vector sigma = singular_values(J);
  const auto here = (sigma.array() > std::sqrt(rank_threshold_)).count();
  result.rank =
      result.rank < 0 ? static_cast<int>(here) : std::min(result.rank, static_cast<int>(here));
  return result;
}

void System::factor_inertia(double t) {
  inertia_ = terms_.A();
  inertia_.diagonal() += armature_;
  A_.compute(inertia_);
  if (A_.info() != Eigen::Success) {
    throw std::runtime_error(
        fmt::format("the inertia matrix is not positive definite at t = {} s: in this position {} "
                    "no inertia",
                    t, joints_without_inertia(tree_, inertia_)));
  }
}

/// Zeros where a row tells no speed.
void System::keep_held(Vector& rows) const {
  for (int k = 0; k < constraints_.rows(); ++k) {
    if (!constraints_.is_held(k)) {
      rows[k] = 0;
    }
  }
}

/// J qd - c' of all rows of J.
void System::speed_errors(double t, const Vector& qd) {
  constraints_.velocities(t, rate_);
  pad(rate_);
  rate_ = J_ * qd - rate_;
  keep_held(rate_);
}

void System::add_stabilisation(double t, const Vector& q, const Vector& qd) {
  const int rows = constraints_.rows();
  constraints_.errors(terms_, t, q, phi_);
  constraints_.velocities(t, rate_);
  rate_ = J_.topRows(rows) * qd - rate_;
  keep_held(rate_);
  rhs_ -= 2 * alpha_ * rate_ + alpha_ * alpha_ * phi_;
}

const Solution& System::accelerate(double t, const Vector& q, const Vector& qd) {
  evaluate(q, qd);
  factor_inertia(t);
  forces_.generalized(terms_, {t, q, qd}, Q_);
  for (const DryFriction& friction : frictions_) {
    Q_[friction.joint] -= friction.direction * friction.force;
  }
  x_ = A_.matrixL().solve(Q_ - terms_.h());  // A = L L^T, x = L^-1 (Q - B - G)
  solution_.rank = 0;
  jacobian(terms_);
  const int rows = constraints_.rows();
  if (J_.rows() > 0) {
    constraints_.accelerations(terms_, {t, q, qd}, rhs_);
    bend_ = rhs_;
    if (alpha_ > 0) {
      add_stabilisation(t, q, qd);
    }
    rhs_.conservativeResize(J_.rows());
    rhs_.tail(J_.rows() - rows).setZero();
    W_ = A_.matrixL().solve(J_.transpose());  // K = W^T W
    solve_.factor(W_, sizes_now(t, q, sticking_joints()));
    x_ += solve_.preimage(rhs_ - W_.transpose() * x_);  // K lambda = a_des - gamma - J qdd_0
    all_lambda_ = solve_.multipliers();
    solution_.rank = solve_.rank();
  }
  solution_.qdd = A_.matrixU().solve(x_);
  add_balance({t, q, qd});
  add_turn({t, q, qd});
  solution_.lambda = rows == 0 ? Vector() : Vector(all_lambda_.head(rows));
  solution_.residual = J_.rows() == 0 ? 0 : largest(J_ * solution_.qdd - rhs_);
  return solution_;
}

/// What each row lacks, and the power of all that acts; gravity and what stores energy have none.
void System::add_balance(const State& state) {
  const int rows = constraints_.rows();
  solution_.power = state.qd.dot(Q_) + forces_.elastic_power(terms_, state);
  if (rows == 0) {
    solution_.residuals.resize(0);
    solution_.wanted.resize(0);
    return;
  }
  constraints_.velocities(state.t, rate_);
  for (int k = 0; k < rows; ++k) {  // a speed that a row has beyond its own is an error of the step
    const double speed = constraints_.is_held(k) ? rate_[k] : J_.row(k).dot(state.qd);
    solution_.power += all_lambda_[k] * speed;
  }
  solution_.wanted = rhs_.head(rows);
  solution_.residuals = J_.topRows(rows) * solution_.qdd - solution_.wanted;
}

/// On a curve of radius r in the metric A the velocity turns by |v| / r; a state d beside it has a
/// tangent turned by d / r. Two ways through a singular position are curves that meet: there r is
/// small, and beside them by as much the rows hold it on a third, which leads from one to the
/// other.
void System::add_turn(const State& state) {
  const int rows = constraints_.rows();
  solution_.turn = 0;
  solution_.beside = 0;
  const Vector along = A_.matrixU() * state.qd;
  const double speed = along.norm();
  if (rows == 0 || speed == 0) {
    return;
  }
  double pace = 0;
  for (int k = 0; k < dof(); ++k) {
    pace = std::max(pace, std::fabs(state.qd[k]) / reach_[static_cast<std::size_t>(k)]);
  }
  const auto across = [&](Vector& rows_ask) {
    pad(rows_ask);
    const Vector bend = solve_.preimage(rows_ask);
    return (bend - bend.dot(along) / along.squaredNorm() * along).norm() / speed;
  };
  const double led = across(bend_);   // what leads the rows may ask for it as well: at a cusp, and
  constraints_.bends(terms_, bend_);  // where it takes them through a singular position
  const double turn = std::min(led, across(bend_));
  if (!(kSharp * turn > pace)) {
    return;
  }
  solve_.multipliers().head(rows).cwiseAbs().maxCoeff(&solution_.turning);
  constraints_.errors(terms_, state.t, state.q, phi_);
  pad(phi_);
  speed_errors(state.t, state.qd);
  solution_.turn = turn;
  solution_.beside = (turn * solve_.preimage(phi_).norm() + solve_.preimage(rate_).norm()) / speed;
}

Arrival System::arrival(int point, const Eigen::Vector3d& normal, const Vector& qd,
                        const Vector& qdd) const {
  const Vector row = terms_.C().middleCols<3>(3 * point) * normal;
  const double gamma = terms_.gamma_f().segment<3>(3 * point).dot(normal);
  return {1 / row.dot(A_.solve(row)), row.dot(qd), row.dot(qdd) + gamma};
}

double System::holding_force(std::size_t friction) const {
  int row = constraints_.rows();
  for (std::size_t k = 0; k < friction; ++k) {
    row += frictions_[k].direction == 0 ? 1 : 0;
  }
  return all_lambda_[row];
}

Eigen::Vector3d System::reaction(double t, const Vector& y, int constraint) {
  accelerate(t, y.head(dof()), y.tail(dof()));
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (int k = 0; k < constraints_.rows(); ++k) {
    if (constraints_.constraint(k) == constraint) {
      force += solution_.lambda[k] * constraints_.direction(k);
    }
  }
  return force;
}

/// Rows and inertia in this position, for corrections that leave alone what reactions cannot
/// change.
void System::factor_rows(double t, const Vector& q, const Vector& qd) {
  evaluate(q, qd);
  factor_inertia(t);
  jacobian(terms_);
  W_ = A_.matrixL().solve(J_.transpose());
  solve_.factor(W_, sizes_now(t, q, sticking_joints()));
}

void System::project(double t, Vector& q, Vector& qd) {
  const int rows = constraints_.rows();
  if (rows == 0 && sticking_joints().empty()) {
    pulled_.resize(0);
    return;
  }
  for (int k = 0;; ++k) {
    factor_rows(t, q, qd);
    constraints_.errors(terms_, t, q, phi_);
    if (k == kProjectionSteps || !(largest(phi_) > kProjectionError)) {
      break;
    }
    pad(phi_);
    q -= A_.matrixU().solve(solve_.preimage(phi_));  // J dq = -phi, dq = A^-1 J^T x
  }
  speed_errors(t, qd);
  const Vector taken = A_.matrixU().solve(solve_.preimage(rate_));  // J dqd = -(J qd - c')
  qd -= taken;
  pulled_ = (J_ * taken).head(rows);
}

void System::remove_normal(double t, const Vector& y, Vector& error) {
  if (constraints_.rows() == 0 && sticking_joints().empty()) {
    return;
  }
  const int n = dof();
  factor_rows(t, y.head(n), y.tail(n));
  phi_ = J_ * error.head(n);
  for (int k = 0; k < constraints_.rows(); ++k) {
    phi_[k] = constraints_.has_position(k) ? phi_[k] : 0;
  }
  error.head(n) -= A_.matrixU().solve(solve_.preimage(phi_));
  rate_ = J_ * error.tail(n);
  keep_held(rate_);
  error.tail(n) -= A_.matrixU().solve(solve_.preimage(rate_));
}

/// Zeros for the rows of sticking joints.
void System::pad(Vector& rows) const {
  const Eigen::Index size = rows.size();
  rows.conservativeResize(J_.rows());
  rows.tail(J_.rows() - size).setZero();
}

Vector System::impact(double t, const Vector& q, Vector& qd, const model::Impact& impact,
                      double restitution) {
  const std::vector<int> before = constraints_.active();
  constraints_.activate(impact.constraints);
  evaluate(q, qd);
  factor_inertia(t);
  constraints_.jacobian(terms_, J_);
  constraints_.velocities(t, rate_);
  unmet_ = largest_of(rate_);
  if (!std::isfinite(unmet_.size)) {
    constraints_.activate(before);
    return rate_;
  }
  W_ = A_.matrixL().solve(J_.transpose());
  solve_.factor(W_, sizes_now(t, q, {}));
  rate_ = -(1 + restitution) * (J_ * qd - rate_);
  for (int k = 0; k < constraints_.rows(); ++k) {
    if (std::ranges::binary_search(impact.held, constraints_.constraint(k))) {
      rate_[k] = 0;
    }
  }
  const Vector change = A_.matrixU().solve(solve_.preimage(rate_));  // A dqd = J^T P
  qd += change;
  unmet_ = largest_of(J_ * change - rate_);
  change_ = largest(rate_);
  Vector impulse = solve_.multipliers();
  constraints_.activate(before);
  return impulse;
}

System::Violation System::largest_of(const Vector& rows) const {
  int row = 0;
  for (int k = 1; k < rows.size() && std::isfinite(rows[row]); ++k) {
    row = std::isfinite(rows[k]) && std::fabs(rows[k]) <= std::fabs(rows[row]) ? row : k;
  }
  return {std::fabs(rows[row]), constraints_.constraint(row)};
}

System::Violation System::violation(double t, const Vector& q) {
  if (constraints_.rows() == 0) {
    return {};
  }
  constraints_.errors(geometry(q), t, q, phi_);
  return largest_of(phi_);
}

System::Violation System::speed_violation(double t, const Vector& q, const Vector& qd) {
  if (constraints_.rows() == 0) {
    return {};
  }
  constraints_.jacobian(geometry(q), J_);
  speed_errors(t, qd);
  return largest_of(rate_);
}

const Terms& System::geometry(const Vector& q) {
  dynamics_.evaluate_geometry(q, terms_);
  return terms_;
}

double System::elastic_energy(const Vector& q) {
  const Terms& terms = geometry(q);
  return forces_.elastic_energy(q, terms.p());
}

double System::armature_energy(const Vector& qd) const {
  return 0.5 * qd.dot(armature_.cwiseProduct(qd));
}

}  // namespace treedyn::simulation
