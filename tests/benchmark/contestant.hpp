// What the benchmark measures: functions of a robot, computed by generated code and by other
// engines.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/clock.hpp"
#include "model/tree.hpp"
#include "oracle/functions.hpp"

namespace treedyn::benchmark {

using Vector = std::vector<double>;

enum class Quantity {
  kMassMatrix,
  kBiasForce,
  kGravityForce,
  kInverseDynamics,
  kForwardDynamics,
  kJacobian,
};

struct QuantityInfo {
  Quantity quantity;
  const char* function;  ///< of INTERFACE.md 3
};

inline constexpr std::array<QuantityInfo, 6> kQuantities{{
    {Quantity::kMassMatrix, "mass_matrix"},
    {Quantity::kBiasForce, "bias_force"},
    {Quantity::kGravityForce, "gravity_force"},
    {Quantity::kInverseDynamics, "inverse_dynamics"},
    {Quantity::kForwardDynamics, "forward_dynamics"},
    {Quantity::kJacobian, "force_jacobian_transpose"},
}};

/// One position, velocity, acceleration and force, N numbers each; rad|m and so on.
struct State {
  Vector q, qd, qdd, tau;
};

/// A robot and the states in which everything is evaluated, turn by turn.
struct Task {
  std::string robot;
  model::Tree tree;
  std::vector<model::Point> points;
  oracle::Problem<double> problem;
  std::vector<State> states;

  [[nodiscard]] std::size_t dof() const { return problem.robot.size(); }
};

/// Something that computes quantities of one task.
class Contestant {
 public:
  Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;
  virtual ~Contestant() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual bool can(Quantity quantity) const = 0;
  /// Evaluations of consecutive states and nothing else, as this is what is timed.
  /// \pre can(quantity)
  virtual void run(Quantity quantity, Turn turn) = 0;
  /// What the last call computed, laid out as the output of the generated function.
  [[nodiscard]] virtual Vector result(Quantity quantity) const = 0;
};

/// `step(k)` for the states k of a turn.
template <class Step>
void repeat(const std::vector<State>& states, Turn turn, const Step& step) {
  std::size_t state = turn.first % states.size();
  for (int call = 0; call < turn.calls; ++call) {
    step(state);
    state = state + 1 == states.size() ? 0 : state + 1;
  }
}

struct Code;

/// Generated code. `name` says how it was made.
std::unique_ptr<Contestant> make_generated(const Task& task, const Code& code,
                                           const std::string& name);
/// The block expressions of equations (1)-(11) as they stand, engine/engine.hpp on double.
std::unique_ptr<Contestant> make_block_form(const Task& task);
/// Null if MuJoCo cannot represent the robot.
std::unique_ptr<Contestant> make_mujoco(const Task& task);
std::unique_ptr<Contestant> make_kdl(const Task& task);
#ifdef TREEDYN_DART
std::unique_ptr<Contestant> make_dart(const Task& task);
#endif

}  // namespace treedyn::benchmark
