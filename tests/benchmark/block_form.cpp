#include "benchmark/contestant.hpp"
#include "engine/engine.hpp"

namespace treedyn::benchmark {

namespace {

class BlockForm final : public Contestant {
 public:
  using Input = std::span<const double>;

  explicit BlockForm(const Task& task)
      : states_(task.states), engine_(task.tree, task.points, {Real(0), Real(0), Real("-9.81")}) {}
  [[nodiscard]] std::string name() const override { return "block form"; }
  [[nodiscard]] bool can(Quantity /*quantity*/) const override { return true; }

  void run(Quantity quantity, Turn turn) override {
    switch (quantity) {
      case Quantity::kMassMatrix:
        return evaluate("mass_matrix", turn,
                        [](const State& s) { return std::array<Input, 1>{s.q}; });
      case Quantity::kBiasForce:
        return evaluate("bias_force", turn, [](const State& s) {
          return std::array<Input, 2>{s.q, s.qd};
        });
      case Quantity::kGravityForce:
        return evaluate("gravity_force", turn,
                        [](const State& s) { return std::array<Input, 1>{s.q}; });
      case Quantity::kInverseDynamics:
        return evaluate("inverse_dynamics", turn, [](const State& s) {
          return std::array<Input, 3>{s.q, s.qd, s.qdd};
        });
      case Quantity::kForwardDynamics:
        return evaluate("forward_dynamics", turn, [](const State& s) {
          return std::array<Input, 3>{s.q, s.qd, s.tau};
        });
      case Quantity::kJacobian:
        return evaluate("force_jacobian_transpose", turn,
                        [](const State& s) { return std::array<Input, 1>{s.q}; });
    }
  }

  [[nodiscard]] Vector result(Quantity /*quantity*/) const override {
    return {out_.begin(), out_.end()};
  }

 private:
  template <class Inputs>
  void evaluate(std::string_view function, Turn turn, const Inputs& inputs_of) {
    repeat(states_, turn, [&](std::size_t k) {
      const auto inputs = inputs_of(states_[k]);
      out_ = engine_.evaluate(function, std::span<const Input>(inputs));
    });
  }

  const std::vector<State>& states_;
  engine::Engine<double> engine_;
  std::span<const double> out_;
};

}  // namespace

std::unique_ptr<Contestant> make_block_form(const Task& task) {
  return std::make_unique<BlockForm>(task);
}

}  // namespace treedyn::benchmark
