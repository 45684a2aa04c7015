#include "benchmark/code.hpp"
#include "benchmark/contestant.hpp"
#include "common/error.hpp"

namespace treedyn::benchmark {

namespace {

class Generated final : public Contestant {
 public:
  Generated(const Task& task, const Code& code, const std::string& name)
      : states_(task.states), code_(code), name_(name), size_(task.dof()) {
    TREEDYN_EXPECT(static_cast<std::size_t>(code.dof) == task.dof());
    TREEDYN_EXPECT(static_cast<std::size_t>(code.points) == task.points.size());
    out_.resize(size_ * std::max(size_, 3 * task.points.size()));
    jacobian_size_ = 3 * size_ * task.points.size();
  }
  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] bool can(Quantity /*quantity*/) const override { return true; }

  void run(Quantity quantity, Turn turn) override {
    switch (quantity) {
      case Quantity::kMassMatrix:
        return of_position(code_.mass_matrix, turn);
      case Quantity::kBiasForce:
        return repeat(states_, turn, [&](std::size_t k) {
          code_.bias_force(states_[k].q.data(), states_[k].qd.data(), out_.data());
        });
      case Quantity::kGravityForce:
        return of_position(code_.gravity_force, turn);
      case Quantity::kInverseDynamics:
        return repeat(states_, turn, [&](std::size_t k) {
          const State& s = states_[k];
          code_.inverse_dynamics(s.q.data(), s.qd.data(), s.qdd.data(), out_.data());
        });
      case Quantity::kForwardDynamics:
        return repeat(states_, turn, [&](std::size_t k) {
          const State& s = states_[k];
          code_.forward_dynamics(s.q.data(), s.qd.data(), s.tau.data(), out_.data());
        });
      case Quantity::kJacobian:
        return of_position(code_.force_jacobian_transpose, turn);
    }
  }

  [[nodiscard]] Vector result(Quantity quantity) const override {
    const std::size_t size = quantity == Quantity::kMassMatrix ? size_ * size_
                             : quantity == Quantity::kJacobian ? jacobian_size_
                                                               : size_;
    return {out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(size)};
  }

 private:
  void of_position(Code::OfPosition function, Turn turn) {
    repeat(states_, turn, [&](std::size_t k) { function(states_[k].q.data(), out_.data()); });
  }

  const std::vector<State>& states_;
  const Code& code_;
  std::string name_;
  std::size_t size_;
  std::size_t jacobian_size_;
  Vector out_;
};

}  // namespace

std::unique_ptr<Contestant> make_generated(const Task& task, const Code& code,
                                           const std::string& name) {
  return std::make_unique<Generated>(task, code, name);
}

}  // namespace treedyn::benchmark
