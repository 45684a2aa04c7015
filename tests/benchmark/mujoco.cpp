#include <mujoco/mujoco.h>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/contestant.hpp"
#include "oracle/engines.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {

namespace {

/// Only the stages that a quantity needs, in the order of mj_forward; A stays in MuJoCo's sparse
/// form while it is timed.
class Mujoco final : public Contestant {
 public:
  explicit Mujoco(const Task& task) : points_(task.problem.points), gravity_(task.problem.gravity) {
    load(oracle::mjcf(task.problem.robot, task.problem.gravity));
    for (std::size_t i = 0; i < task.dof(); ++i) {
      place_.push_back(static_cast<std::size_t>(
          mj_name2id(model_.get(), mjOBJ_JOINT, fmt::format("joint{}", i).c_str())));
    }
    for (const State& state : task.states) {
      states_.push_back(
          {ordered(state.q), ordered(state.qd), ordered(state.qdd), ordered(state.tau)});
    }
    for (const oracle::Point<double>& point : points_) {
      bodies_.push_back(
          mj_name2id(model_.get(), mjOBJ_BODY, fmt::format("body{}", point.body).c_str()));
    }
    rest_.resize(task.dof());
    forces_.resize(task.dof());
    jacobian_.resize(3 * task.dof() * points_.size());
  }
  [[nodiscard]] std::string name() const override { return "MuJoCo"; }
  [[nodiscard]] bool can(Quantity /*quantity*/) const override { return true; }

  void run(Quantity quantity, Turn turn) override {
    switch (quantity) {
      case Quantity::kMassMatrix:
        return repeat(states_, turn, [&](std::size_t k) { mass_matrix(states_[k]); });
      case Quantity::kBiasForce:
        std::fill_n(model_->opt.gravity, 3, 0.0);
        repeat(states_, turn, [&](std::size_t k) { bias(states_[k].q, states_[k].qd); });
        std::copy_n(gravity_.begin(), 3, model_->opt.gravity);
        return;
      case Quantity::kGravityForce:
        return repeat(states_, turn, [&](std::size_t k) { bias(states_[k].q, rest_); });
      case Quantity::kInverseDynamics:
        return repeat(states_, turn, [&](std::size_t k) { inverse_dynamics(states_[k]); });
      case Quantity::kForwardDynamics:
        return repeat(states_, turn, [&](std::size_t k) { forward_dynamics(states_[k]); });
      case Quantity::kJacobian:
        return repeat(states_, turn, [&](std::size_t k) { jacobian(states_[k]); });
    }
  }

  [[nodiscard]] Vector result(Quantity quantity) const override {
    switch (quantity) {
      case Quantity::kMassMatrix:
        return dense_mass_matrix();
      case Quantity::kForwardDynamics:
        return reordered(data_->qacc);
      case Quantity::kJacobian:
        return dense_jacobian();
      default:
        return reordered(forces_.data());
    }
  }

 private:
  void load(const std::string& xml) {
    const support::TemporaryFolder folder;
    const std::string file = folder.path() / "robot.xml";
    support::write_file(file, xml);
    std::string error(1000, '\0');
    model_.reset(mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    if (model_ == nullptr) {
      throw std::runtime_error("MuJoCo: " + std::string(error.c_str()));
    }
    data_.reset(mj_makeData(model_.get()));
  }

  void pose(const Vector& q) {
    std::copy(q.begin(), q.end(), data_->qpos);
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
  }
  void mass_matrix(const State& state) {
    pose(state.q);
    mj_crb(model_.get(), data_.get());
  }
  void velocity(const Vector& qd) {
    std::copy(qd.begin(), qd.end(), data_->qvel);
    mj_comVel(model_.get(), data_.get());
  }
  void bias(const Vector& q, const Vector& qd) {
    pose(q);
    velocity(qd);
    mj_rne(model_.get(), data_.get(), 0, forces_.data());
  }
  void inverse_dynamics(const State& state) {
    pose(state.q);
    velocity(state.qd);
    std::copy(state.qdd.begin(), state.qdd.end(), data_->qacc);
    mj_rne(model_.get(), data_.get(), 1, forces_.data());
  }
  void forward_dynamics(const State& state) {
    mass_matrix(state);
    mj_factorM(model_.get(), data_.get());
    velocity(state.qd);
    mj_rne(model_.get(), data_.get(), 0, forces_.data());
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      forces_[i] = state.tau[i] - forces_[i];
    }
    mj_solveM(model_.get(), data_.get(), data_->qacc, forces_.data(), 1);
  }
  void jacobian(const State& state) {
    pose(state.q);
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const int body = bodies_[k];
      const double* R = data_->xmat + 9 * body;
      const auto& at = points_[k].at;
      double p[3];
      for (int row = 0; row < 3; ++row) {
        p[row] = data_->xpos[3 * body + row] + R[3 * row] * at[0] + R[3 * row + 1] * at[1] +
                 R[3 * row + 2] * at[2];
      }
      mj_jac(model_.get(), data_.get(), jacobian_.data() + 3 * k * rest_.size(), nullptr, p, body);
    }
  }

  [[nodiscard]] Vector ordered(const Vector& x) const {
    Vector result(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      result[place_[i]] = x[i];
    }
    return result;
  }
  [[nodiscard]] Vector reordered(const double* x) const {
    Vector result;
    for (const std::size_t place : place_) {
      result.push_back(x[place]);
    }
    return result;
  }
  [[nodiscard]] Vector dense_mass_matrix() const {
    const std::size_t n = place_.size();
    Vector full(n * n);
    mj_fullM(model_.get(), full.data(), data_->qM);
    Vector A(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        A[i * n + j] = full[place_[i] * n + place_[j]];
      }
    }
    return A;
  }
  [[nodiscard]] Vector dense_jacobian() const {
    const std::size_t n = place_.size();
    Vector C;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t row = 0; row < 3 * points_.size(); ++row) {
        C.push_back(jacobian_[row * n + place_[i]]);
      }
    }
    return C;
  }

  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
  std::vector<oracle::Point<double>> points_;
  oracle::Vec<double> gravity_;
  std::vector<int> bodies_;         ///< point -> MuJoCo's body
  std::vector<std::size_t> place_;  ///< joint -> MuJoCo's joint
  std::vector<State> states_;       ///< in MuJoCo's order
  Vector rest_;
  Vector forces_;
  Vector jacobian_;  ///< 3P x N
};

}  // namespace

std::unique_ptr<Contestant> make_mujoco(const Task& task) {
  return oracle::mujoco_reads(task.problem.robot) ? std::make_unique<Mujoco>(task) : nullptr;
}

}  // namespace treedyn::benchmark
