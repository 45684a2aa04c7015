#include "benchmark/task.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "description/read.hpp"
#include "oracle/from_tree.hpp"
#include "support/states.hpp"

namespace treedyn::benchmark {

namespace {

using oracle::largest;
using RealList = std::vector<Real>;

const model::Vector3 kGravity{Real(0), Real(0), Real("-9.81")};
constexpr std::size_t kStates = 256;  ///< more than a branch predictor remembers
constexpr std::size_t kChecked = 16;

/// Angles up to pi, the pitch of a base on axes up to 72 degrees: next to 90 degrees engines print
/// warnings, and their time is not that of the function.
std::vector<State> random_states(const model::Tree& tree) {
  const std::size_t dof = tree.links.size();
  support::Random random(5);
  std::vector<State> states(kStates);
  for (State& state : states) {
    state.q = random.list(dof, std::numbers::pi);
    state.qd = random.list(dof);
    state.qdd = random.list(dof);
    state.tau = random.list(dof);
    for (std::size_t i = 0; i < dof; ++i) {
      state.q[i] *= tree.links[i].joint.name == "base_ry" ? 0.4 : 1;
    }
  }
  return states;
}

RealList real(const Vector& values) { return {values.begin(), values.end()}; }

const char* name_of(Quantity quantity) {
  return kQuantities[static_cast<std::size_t>(quantity)].function;
}

std::vector<RealList> inputs_of(Quantity quantity, const State& state) {
  switch (quantity) {
    case Quantity::kBiasForce:
      return {real(state.q), real(state.qd)};
    case Quantity::kInverseDynamics:
      return {real(state.q), real(state.qd), real(state.qdd)};
    case Quantity::kForwardDynamics:
      return {real(state.q), real(state.qd), real(state.tau)};
    default:
      return {real(state.q)};
  }
}

/// |A d| and the size of the products that its rows sum.
struct Product {
  Real value;
  Real terms;
};
Product product(const RealList& A, const RealList& difference, const RealList& x) {
  const std::size_t n = x.size();
  RealList sum(n);
  RealList terms(n);
  for (std::size_t k = 0; k < A.size(); ++k) {
    sum[k / n] += A[k] * difference[k % n];
    terms[k / n] += abs(A[k] * x[k % n]);
  }
  return {largest(sum), largest(terms)};
}

/// Relative error of one state.
double error_of(const oracle::Problem<Real>& problem, Quantity quantity, const State& state,
                const Vector& x) {
  const RealList y = oracle::evaluate(problem, name_of(quantity), inputs_of(quantity, state));
  if (x.size() != y.size()) {
    return HUGE_VAL;
  }
  RealList difference = real(x);
  std::transform(difference.begin(), difference.end(), y.begin(), difference.begin(),
                 std::minus<>());
  if (quantity != Quantity::kForwardDynamics) {
    const Real scale = largest(y);
    return static_cast<double>(scale == 0 ? largest(difference) : largest(difference) / scale);
  }
  const RealList A = oracle::evaluate(problem, "mass_matrix", {real(state.q)});
  const Product forces = product(A, difference, y);
  return static_cast<double>(forces.value / forces.terms);
}

}  // namespace

Task make_task(const RobotInfo& robot) {
  description::ReadOptions options;
  options.base = robot.base == "axes" ? description::Base::kAxes : description::Base::kFixed;
  Task task;
  task.robot = robot.name;
  task.tree = description::read_model(robot.model, options);
  task.points = description::resolve_points(task.tree, robot.points);
  task.problem = oracle::problem_of<double>(task.tree, task.points, kGravity);
  task.states = random_states(task.tree);
  return task;
}

std::vector<std::unique_ptr<Contestant>> contestants(const Task& task, const RobotInfo& robot) {
  std::vector<std::unique_ptr<Contestant>> result;
  result.push_back(make_generated(task, *robot.libm, "treedyn, libm"));
  result.push_back(make_generated(task, *robot.vector, "treedyn, default"));
  result.push_back(make_block_form(task));
  result.push_back(make_kdl(task));
  result.push_back(make_mujoco(task));
#ifdef TREEDYN_DART
  result.push_back(make_dart(task));
#endif
  std::erase(result, nullptr);
  return result;
}

double checked_error(const Task& task, Contestant& contestant, Quantity quantity) {
  const oracle::Problem<Real> problem = oracle::problem_of<Real>(task.tree, task.points, kGravity);
  // 100 N roundings of the largest entry, as between any two algorithms in double precision.
  const double allowed = 100 * static_cast<double>(task.dof()) * 0x1p-53;
  double error = 0;
  for (std::size_t k = 0; k < kChecked; ++k) {
    contestant.run(quantity, {k, 1});
    const double found = error_of(problem, quantity, task.states[k], contestant.result(quantity));
    if (!(found <= allowed)) {
      throw std::runtime_error(fmt::format("{}: {} of {} differs by {} in state {}", task.robot,
                                           name_of(quantity), contestant.name(), found, k));
    }
    error = std::max(error, found);
  }
  return error;
}

}  // namespace treedyn::benchmark
