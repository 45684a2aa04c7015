#include "simplify/functions.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "simplify/articulated.hpp"
#include "simplify/composite.hpp"
#include "simplify/energy.hpp"
#include "simplify/factor.hpp"
#include "simplify/forward.hpp"
#include "simplify/points.hpp"
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

/// (1) solved for qdd.
std::vector<Expr> build_forward_dynamics(const Task& task) {
  const Kinematics& k = task.kinematics;
  const bool one_joint_one_coordinate = task.tree.dof() == task.tree.size();
  if (by_trunk(task) && one_joint_one_coordinate) {
    return forward_dynamics_by_trunk(k, -k.ground_acceleration(), k.variant().articulated);
  }
  if (k.variant().articulated && one_joint_one_coordinate) {
    return articulated_forward_dynamics(k, k.ground_acceleration());
  }
  const std::vector<Expr> a = build_mass_matrix(task);
  const std::vector<Expr> bias = build_with_gravity(task);
  const int n = task.tree.dof();
  SparseSymmetric lower;
  std::vector<Expr> right;
  for (int i = 0; i < n; ++i) {
    right.push_back(Expr(k.graph(), k.graph().input(2, i)) - bias[static_cast<std::size_t>(i)]);
    for (int j = 0; j <= i; ++j) {
      lower[{i, j}] = a[static_cast<std::size_t>(i * n + j)];
    }
  }
  return Factorization(k.graph(), n, lower).solve(right);
}

std::vector<Expr> build_point_positions(const Task& task) {
  return point_positions(task.kinematics, task.options.points);
}
std::vector<Expr> build_point_velocities(const Task& task) {
  return point_velocities(task.kinematics, task.options.points);
}
std::vector<Expr> build_point_rotations(const Task& task) {
  return point_rotations(task.kinematics, task.options.points);
}
std::vector<Expr> build_point_bias(const Task& task) {
  return point_bias_acceleration(task.kinematics, task.options.points);
}
std::vector<Expr> build_angular_bias(const Task& task) {
  return angular_bias_acceleration(task.kinematics, task.options.points);
}

/// N x 3P, row-major; rows of reduced mimic joints add up: T^T C.
std::vector<Expr> dense(const Task& task, const std::vector<JacobianBlock>& blocks) {
  const std::size_t width = 3 * task.options.points.size();
  std::vector<Expr> result(static_cast<std::size_t>(task.tree.dof()) * width);
  for (const JacobianBlock& block : blocks) {
    const model::Drive& drive = task.tree.drives[static_cast<std::size_t>(block.joint)];
    const Expr multiplier = constant(task.kinematics.graph(), drive.multiplier);
    for (std::size_t n = 0; n < 3; ++n) {
      const std::size_t column = 3 * static_cast<std::size_t>(block.point) + n;
      result[static_cast<std::size_t>(drive.coordinate) * width + column] +=
          multiplier * block.value[n];
    }
  }
  return result;
}

std::vector<Expr> build_force_jacobian(const Task& task) {
  return dense(task, force_jacobian_transpose(task.kinematics, task.options.points));
}
std::vector<Expr> build_moment_jacobian(const Task& task) {
  return dense(task, moment_jacobian_transpose(task.kinematics, task.options.points));
}
std::vector<Expr> build_applied_force(const Task& task) {
  return reduced(task, applied_force(task.kinematics, task.options.points, 1, 2));
}
std::vector<Expr> build_link_vectors(const Task& task) {
  return joint_to_link_vectors(task.kinematics);
}
std::vector<Expr> build_com_vectors(const Task& task) {
  return joint_to_com_vectors(task.kinematics, task.tree);
}
std::vector<Expr> build_kinetic_energy(const Task& task) {
  return {kinetic_energy(task.kinematics)};
}
std::vector<Expr> build_potential_energy(const Task& task) {
  return {potential_energy(task.kinematics, task.normal)};
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
  const Inputs from_q = {.q = 0};
  const Inputs from_q_qd = {.q = 0, .qd = 1};
  static const std::vector<Recipe> table = {
      {"mass_matrix",
       "(2)",
       "Joint-space inertia matrix A(q); N x N, row-major, symmetric.",
       {kQ},
       {{"A", 1, 2, 0, "kg m^2|kg m|kg"}},
       from_q,
       {.regrouping = true, .tensor_form = true, .trunk = true},
       build_mass_matrix},
      {"bias_force",
       "(3)",
       "Coriolis and centrifugal joint forces B(q, qd), without gravity.",
       {kQ, kQd},
       {{"B", 1, 1, 0, kForce}},
       from_q_qd,
       {.regrouping = true, .moment_form = true},
       build_bias_force},
      {"gravity_force",
       "6.5",
       "Gravity term G(q) of A qdd + B + G = tau.",
       {kQ},
       {{"G", 1, 1, 0, kForce}},
       from_q,
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
      {"forward_dynamics",
       "(1)",
       "Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.",
       {kQ, kQd, {"tau", 1, 1, 0, kForce}},
       {{"qdd", 1, 1, 0, "rad/s^2|m/s^2"}},
       {.q = 0, .qd = 1, .tau = 2},
       {.regrouping = true,
        .moment_form = true,
        .tensor_form = true,
        .trunk = true,
        .articulated = true},
       build_forward_dynamics},
      {"point_positions",
       "1.2",
       "Positions of the points, base frame.",
       {kQ},
       {{"p", 3, 0, 1, "m"}},
       from_q,
       {.two_ways = true},
       build_point_positions},
      {"point_velocities",
       "6.1",
       "Velocities C^T qd of the points, base frame.",
       {kQ, kQd},
       {{"v", 3, 0, 1, "m/s"}},
       from_q_qd,
       {.two_ways = true},
       build_point_velocities},
      {"point_rotations",
       "1.2",
       "Rotations link frame -> base frame of the points' links; 3 x 3 each, row-major.",
       {kQ},
       {{"R", 9, 0, 1, "1"}},
       from_q,
       {},
       build_point_rotations},
      {"force_jacobian_transpose",
       "(9)",
       "C of the points, transposed Jacobian; N x 3P, row-major.",
       {kQ},
       {{"C", 3, 1, 1, "m|1"}},
       from_q,
       {},
       build_force_jacobian},
      {"moment_jacobian_transpose",
       "(11)",
       "H of the points' links; N x 3P, row-major.",
       {kQ},
       {{"H", 3, 1, 1, "1"}},
       from_q,
       {},
       build_moment_jacobian},
      {"point_bias_acceleration",
       "6.1",
       "gamma_f = d/dt(C^T) qd of the points, base frame.",
       {kQ, kQd},
       {{"gamma_f", 3, 0, 1, "m/s^2"}},
       from_q_qd,
       {.two_ways = true},
       build_point_bias},
      {"angular_bias_acceleration",
       "6.1",
       "gamma_n = d/dt(H^T) qd of the points' links, base frame.",
       {kQ, kQd},
       {{"gamma_n", 3, 0, 1, "rad/s^2"}},
       from_q_qd,
       {.two_ways = true},
       build_angular_bias},
      {"joint_to_link_vectors",
       "(6)",
       "l_D: block (i, j) = O_i - P_j, base frame; 3N x N, row-major.",
       {kQ},
       {{"l_D", 3, 2, 0, "m"}},
       from_q,
       {.fixed_frames = true},
       build_link_vectors},
      {"joint_to_com_vectors",
       "(7)",
       "c_fD: block (i, j) = centre of mass of i - P_j, base frame; 3N x N, row-major.",
       {kQ},
       {{"c_fD", 3, 2, 0, "m"}},
       from_q,
       {.fixed_frames = true},
       build_com_vectors},
      {"applied_force",
       "(8)",
       "Joint forces Q = C f + H n of forces f at the points and moments n on their links.",
       {kQ, {"f", 3, 0, 1, "N"}, {"n", 3, 0, 1, "N m"}},
       {{"Q", 1, 1, 0, kForce}},
       from_q,
       {.two_ways = true},
       build_applied_force},
      {"kinetic_energy",
       "(2)",
       "Kinetic energy T = 1/2 qd^T A(q) qd.",
       {kQ, kQd},
       {{"T", 1, 0, 0, "J"}},
       from_q_qd,
       {.regrouping = true},
       build_kinetic_energy},
      {"potential_energy",
       "6.5",
       "Potential energy of gravity; zero with all mass at the base origin.",
       {kQ},
       {{"U", 1, 0, 0, "J"}},
       from_q,
       {.regrouping = true},
       build_potential_energy},
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
    used.links[4].cut =
        LinkVariant::kWholeRun;  // forward dynamics needs the second axis as a frame axis
  }
  if (recipe.freedom.fixed_frames) {
    for (LinkVariant& link : used.links) {
      link.slide = Slide::kNone;
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
