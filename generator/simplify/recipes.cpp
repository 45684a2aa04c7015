#include <algorithm>

#include "common/error.hpp"
#include "simplify/builders.hpp"
#include "simplify/factored.hpp"

namespace treedyn::simplify {

namespace {

constexpr const char* kForce = "N m|N";
const Argument kQ = {"q", 1, 1, 0, "rad|m"};
const Argument kQd = {"qd", 1, 1, 0, "rad/s|m/s"};
const Argument kQdd = {"qdd", 1, 1, 0, "rad/s^2|m/s^2"};

/// From the equation of that name.
Builder derived_from(const char* name) {
  return [name](const Task& task) {
    return build_equation(task, name);
  };
}

/// From the equation of that name, solved by factors.
Builder solved_from(const char* name) {
  return [name](const Task& task) {
    return build_factored(task, name);
  };
}

}  // namespace

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
       derived_from("mass_matrix")},
      {"bias_force",
       "(3)",
       "Coriolis and centrifugal joint forces B(q, qd), without gravity.",
       {kQ, kQd},
       {{"B", 1, 1, 0, kForce}},
       from_q_qd,
       {.regrouping = true, .moment_form = true},
       derived_from("bias_force")},
      {"gravity_force",
       "6.5",
       "Gravity term G(q) of A qdd + B + G = tau.",
       {kQ},
       {{"G", 1, 1, 0, kForce}},
       from_q,
       {.regrouping = true},
       derived_from("gravity_force")},
      {"inverse_dynamics",
       "(1)",
       "Joint forces tau = A(q) qdd + B(q, qd) + G(q).",
       {kQ, kQd, kQdd},
       {{"tau", 1, 1, 0, kForce}},
       {.q = 0, .qd = 1, .qdd = 2},
       {.regrouping = true, .moment_form = true},
       derived_from("inverse_dynamics")},
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
       {.any_way = true},
       derived_from("point_positions")},
      {"point_velocities",
       "6.1",
       "Velocities C^T qd of the points, base frame.",
       {kQ, kQd},
       {{"v", 3, 0, 1, "m/s"}},
       from_q_qd,
       {.any_way = true},
       derived_from("point_velocities")},
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
       {.any_way = true, .way = Way::kInLinks},
       derived_from("force_jacobian_transpose")},
      {"moment_jacobian_transpose",
       "(11)",
       "H of the points' links; N x 3P, row-major.",
       {kQ},
       {{"H", 3, 1, 1, "1"}},
       from_q,
       {.any_way = true, .way = Way::kInLinks},
       derived_from("moment_jacobian_transpose")},
      {"point_bias_acceleration",
       "6.1",
       "gamma_f = d/dt(C^T) qd of the points, base frame.",
       {kQ, kQd},
       {{"gamma_f", 3, 0, 1, "m/s^2"}},
       from_q_qd,
       {.any_way = true},
       derived_from("point_bias_acceleration")},
      {"angular_bias_acceleration",
       "6.1",
       "gamma_n = d/dt(H^T) qd of the points' links, base frame.",
       {kQ, kQd},
       {{"gamma_n", 3, 0, 1, "rad/s^2"}},
       from_q_qd,
       {.any_way = true},
       derived_from("angular_bias_acceleration")},
      {"joint_to_link_vectors",
       "(6)",
       "l_D: block (i, j) = O_i - P_j, base frame; 3N x N, row-major.",
       {kQ},
       {{"l_D", 3, 2, 0, "m"}},
       from_q,
       {.way = Way::kInBase, .fixed_frames = true},
       derived_from("joint_to_link_vectors")},
      {"joint_to_com_vectors",
       "(7)",
       "c_fD: block (i, j) = centre of mass of i - P_j, base frame; 3N x N, row-major.",
       {kQ},
       {{"c_fD", 3, 2, 0, "m"}},
       from_q,
       {.way = Way::kInBase, .fixed_frames = true},
       derived_from("joint_to_com_vectors")},
      {"applied_force",
       "(8)",
       "Joint forces Q = C f + H n of forces f at the points and moments n on their links.",
       {kQ, {"f", 3, 0, 1, "N"}, {"n", 3, 0, 1, "N m"}},
       {{"Q", 1, 1, 0, kForce}},
       from_q,
       {.any_way = true},
       derived_from("applied_force")},
      {"kinetic_energy",
       "(2)",
       "Kinetic energy T = 1/2 qd^T A(q) qd.",
       {kQ, kQd},
       {{"T", 1, 0, 0, "J"}},
       from_q_qd,
       {.regrouping = true},
       derived_from("kinetic_energy")},
      {"potential_energy",
       "6.5",
       "Potential energy of gravity; zero with all mass at the base origin.",
       {kQ},
       {{"U", 1, 0, 0, "J"}},
       from_q,
       {.regrouping = true},
       derived_from("potential_energy")},
      {"dynamics_terms",
       "(2),(3),6.5",
       "A(q), B(q, qd) and G(q) in one call, with what they share computed once.",
       {kQ, kQd},
       {{"A", 1, 2, 0, "kg m^2|kg m|kg"}, {"B", 1, 1, 0, kForce}, {"G", 1, 1, 0, kForce}},
       from_q_qd,
       {.regrouping = true, .moment_form = true, .tensor_form = true, .trunk = true},
       build_dynamics_terms},
      {"mass_matrix_factor",
       "7.4",
       "L (unit lower triangular, N x N, row-major) and d of A = L^T diag(d) L, without fill-in.",
       {kQ},
       {{"L", 1, 2, 0, "1|m|1/m"}, {"d", 1, 1, 0, "kg m^2|kg"}},
       from_q,
       {.regrouping = true, .tensor_form = true, .trunk = true},
       solved_from("mass_matrix_factor")},
      {"mass_matrix_solve",
       "7.4",
       "x of A(q) x = b by the factors of A.",
       {kQ, {"b", 1, 1, 0, kForce}},
       {{"x", 1, 1, 0, "rad/s^2|m/s^2"}},
       from_q,
       {.regrouping = true, .tensor_form = true, .trunk = true},
       solved_from("mass_matrix_solve")},
      {"mass_matrix_inverse",
       "7.4",
       "Inverse of A(q); N x N, row-major, symmetric.",
       {kQ},
       {{"A_inverse", 1, 2, 0, "1/(kg m^2)|1/(kg m)|1/kg"}},
       from_q,
       {.regrouping = true, .tensor_form = true, .trunk = true},
       solved_from("mass_matrix_inverse")},
  };
  return table;
}

const Recipe& recipe_of(const std::string& name) {
  const auto found = std::find_if(recipes().begin(), recipes().end(),
                                  [&](const Recipe& recipe) { return name == recipe.name; });
  TREEDYN_EXPECT(found != recipes().end());
  return *found;
}

}  // namespace treedyn::simplify
