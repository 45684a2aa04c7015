#include "simplify/functions.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "simplify/composite.hpp"
#include "simplify/sweeps.hpp"

namespace treedyn::simplify {

namespace {

/// Dense row-major matrix of the degrees of freedom: T^T A T for reduced mimic joints (q = T u +
/// q0).
std::vector<Expr> dense(const Task& task, const SparseSymmetric& a) {
  const auto n = static_cast<std::size_t>(task.tree.dof());
  std::vector<Expr> result(n * n);
  for (const auto& [place, entry] : a) {
    const model::Drive& row = task.tree.drives[static_cast<std::size_t>(place.first)];
    const model::Drive& column = task.tree.drives[static_cast<std::size_t>(place.second)];
    const Expr scaled =
        constant(task.kinematics.graph(), row.multiplier * column.multiplier) * entry;
    const auto i = static_cast<std::size_t>(row.coordinate);
    const auto j = static_cast<std::size_t>(column.coordinate);
    result[i * n + j] += scaled;
    if (place.first != place.second) {
      result[j * n + i] += scaled;
    }
  }
  return result;
}

/// T^T tau.
std::vector<Expr> reduced(const Task& task, const std::vector<Expr>& tau) {
  std::vector<Expr> result(static_cast<std::size_t>(task.tree.dof()));
  for (std::size_t i = 0; i < tau.size(); ++i) {
    const model::Drive& drive = task.tree.drives[i];
    result[static_cast<std::size_t>(drive.coordinate)] +=
        constant(task.kinematics.graph(), drive.multiplier) * tau[i];
  }
  return result;
}

bool by_trunk(const Task& task) {
  return task.kinematics.variant().trunk && has_free_base(task.tree);
}

std::vector<Expr> build_mass_matrix(const Task& task) {
  return dense(
      task, by_trunk(task) ? mass_matrix_by_trunk(task.kinematics) : mass_matrix(task.kinematics));
}

/// (3): no acceleration, no gravity.
std::vector<Expr> build_bias_force(const Task& task) {
  return reduced(task, inverse_dynamics(task.kinematics, {}));
}

/// 6.5 and (1): the ground accelerates by -g.
std::vector<Expr> build_with_gravity(const Task& task) {
  return reduced(task, inverse_dynamics(task.kinematics, task.kinematics.ground_acceleration()));
}

constexpr const char* kForce = "N m|N";
const Argument kQ = {"q", 1, 1, 0, "rad|m"};
const Argument kQd = {"qd", 1, 1, 0, "rad/s|m/s"};
const Argument kQdd = {"qdd", 1, 1, 0, "rad/s^2|m/s^2"};

}  // namespace

int Argument::size(int dof, int points) const {
  int result = factor;
  for (int k = 0; k < power_of_dof; ++k) {
    result *= dof;
  }
  for (int k = 0; k < power_of_points; ++k) {
    result *= points;
  }
  return result;
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> table = {
      {"mass_matrix",
       "(2)",
       "Joint-space inertia matrix A(q); row-major, symmetric.",
       {kQ},
       {{"A", 1, 2, 0, "kg m^2|kg m|kg"}},
       {.q = 0},
       {.regrouping = true, .tensor_form = true, .trunk = true},
       build_mass_matrix},
      {"bias_force",
       "(3)",
       "Coriolis and centrifugal joint forces B(q, qd), without gravity.",
       {kQ, kQd},
       {{"B", 1, 1, 0, kForce}},
       {.q = 0, .qd = 1},
       {.regrouping = true, .moment_form = true},
       build_bias_force},
      {"gravity_force",
       "6.5",
       "Gravity term G(q) of A qdd + B + G = tau.",
       {kQ},
       {{"G", 1, 1, 0, kForce}},
       {.q = 0},
       {.regrouping = true},
       build_with_gravity},
      {"inverse_dynamics",
       "(1)",
       "Joint forces tau = A(q) qdd + B(q, qd) + G(q).",
       {kQ, kQd, kQdd},
       {{"tau", 1, 1, 0, kForce}},
       {.q = 0, .qd = 1, .qdd = 2},
       {.regrouping = true, .moment_form = true},
       build_with_gravity},
  };
  return table;
}

const Recipe& recipe_of(const std::string& name) {
  const auto found = std::find_if(recipes().begin(), recipes().end(),
                                  [&](const Recipe& recipe) { return name == recipe.name; });
  TREEDYN_EXPECT(found != recipes().end());
  return *found;
}

Variant plain_variant(const model::Tree& tree) {
  Variant variant;
  variant.links.resize(tree.links.size());
  return variant;
}

program::Function build(const model::Tree& tree, const Recipe& recipe, const Options& options,
                        const Variant& variant) {
  Variant used = variant;
  if (recipe.freedom.trunk && variant.trunk && has_free_base(tree)) {
    for (std::size_t i = 3; i < 6;
         ++i) {  // the base axes stay in one point and the trunk keeps its mass
      used.links[i].mass = MassGauge::kNothing;
      used.links[i].slide = Slide::kNone;
    }
  }
  program::Function function;
  const NormalTree normal = normal_form(tree, options.gravity, used);
  const Kinematics kinematics(function.graph, tree, normal, used, recipe.places);
  for (const Expr& output : recipe.build({tree, normal, options, kinematics})) {
    function.outputs.push_back(output.ref());
  }
  return function;
}

}  // namespace treedyn::simplify
