#include "equations/table.hpp"

#include <algorithm>
#include <iterator>

#include "equations/equations.hpp"

namespace treedyn::equations {

int Extent::count(int dof, int points) const {
  return factor * (of == Of::kPerDof ? dof : of == Of::kPerPoint ? points : 1);
}

namespace {

constexpr Extent kOneElement{1, Extent::Of::kFixed};
constexpr Extent kN{1, Extent::Of::kPerDof};
constexpr Extent k3N{3, Extent::Of::kPerDof};
constexpr Extent k3P{3, Extent::Of::kPerPoint};
constexpr Extent k9P{9, Extent::Of::kPerPoint};
constexpr Extent k10N{10, Extent::Of::kPerDof};

constexpr const char* kForce = "N m|N";
constexpr const char* kAcceleration = "rad/s^2|m/s^2";
constexpr Argument kQ = {"q", kN, kOneElement, "rad|m"};
constexpr Argument kQd = {"qd", kN, kOneElement, "rad/s|m/s"};
constexpr Argument kQdd = {"qdd", kN, kOneElement, kAcceleration};
constexpr Argument kTau = {"tau", kN, kOneElement, kForce};
constexpr Argument kA = {"A", kN, kN, "kg m^2|kg m|kg"};
constexpr Argument kB = {"B", kN, kOneElement, kForce};
constexpr Argument kG = {"G", kN, kOneElement, kForce};

constexpr const char* kErrataOfA = "E10 E11 E13";
constexpr const char* kErrataOfTau = "E12";

std::vector<Equation> dynamics() {
  return {
      {"mass_matrix",
       "(2)",
       "Joint-space inertia matrix A(q); N x N, row-major, symmetric.",
       {kQ},
       {kA},
       mass_matrix(),
       kErrataOfA},
      {"bias_force",
       "(3)",
       "Coriolis and centrifugal joint forces B(q, qd), without gravity.",
       {kQ, kQd},
       {kB},
       bias_force(),
       "E1 E2 E3 E4 E5 E10 E11 E14"},
      {"gravity_force",
       "6.5",
       "Gravity term G(q) of A qdd + B + G = tau.",
       {kQ},
       {kG},
       gravity_force(),
       "E20"},
      {"inverse_dynamics",
       "(1)",
       "Joint forces tau = A(q) qdd + B(q, qd) + G(q).",
       {kQ, kQd, kQdd},
       {kTau},
       inverse_dynamics(),
       kErrataOfTau},
      {"forward_dynamics",
       "(1)",
       "Joint accelerations qdd of A(q) qdd + B(q, qd) + G(q) = tau.",
       {kQ, kQd, kTau},
       {kQdd},
       forward_dynamics(),
       kErrataOfTau,
       "q̈"},
  };
}

std::vector<Equation> points_and_vectors() {
  return {
      {"point_positions",
       "1.2",
       "Positions of the points, base frame.",
       {kQ},
       {{"p", k3P, kOneElement, "m"}},
       point_positions()},
      {"point_velocities",
       "6.1",
       "Velocities C^T qd of the points, base frame.",
       {kQ, kQd},
       {{"v", k3P, kOneElement, "m/s"}},
       point_velocities()},
      {"point_rotations",
       "1.2",
       "Rotations link frame -> base frame of the points' links; 3 x 3 each, row-major.",
       {kQ},
       {{"R", k9P, kOneElement, "1"}}},
      {"force_jacobian_transpose",
       "(9)",
       "C of the points, transposed Jacobian; N x 3P, row-major.",
       {kQ},
       {{"C", kN, k3P, "m|1"}},
       force_jacobian_transpose(points()),
       "E6 E17"},
      {"moment_jacobian_transpose",
       "(11)",
       "H of the points' links; N x 3P, row-major.",
       {kQ},
       {{"H", kN, k3P, "1"}},
       moment_jacobian_transpose(points())},
      {"point_bias_acceleration",
       "6.1",
       "gamma_f = d/dt(C^T) qd of the points, base frame.",
       {kQ, kQd},
       {{"gamma_f", k3P, kOneElement, "m/s^2"}},
       point_bias_acceleration(),
       "E1 E2 E4"},
      {"angular_bias_acceleration",
       "6.1",
       "gamma_n = d/dt(H^T) qd of the points' links, base frame.",
       {kQ, kQd},
       {{"gamma_n", k3P, kOneElement, "rad/s^2"}},
       angular_bias_acceleration()},
      {"joint_to_link_vectors",
       "(6)",
       "l_D: block (i, j) = O_i - P_j, base frame; 3N x N, row-major.",
       {kQ},
       {{"l_D", k3N, kN, "m"}},
       joint_to_link_vectors()},
      {"joint_to_com_vectors",
       "(7)",
       "c_fD: block (i, j) = centre of mass of i - P_j, base frame; 3N x N, row-major.",
       {kQ},
       {{"c_fD", k3N, kN, "m"}},
       joint_to_com_vectors(),
       "E13"},
  };
}

std::vector<Equation> forces_and_energies() {
  return {
      {"applied_force",
       "(8)",
       "Joint forces Q = C f + H n of forces f at the points and moments n on their links.",
       {kQ, {"f", k3P, kOneElement, "N"}, {"n", k3P, kOneElement, "N m"}},
       {{"Q", kN, kOneElement, kForce}},
       applied_force(),
       "E7 E12"},
      {"kinetic_energy",
       "(2)",
       "Kinetic energy T = 1/2 qd^T A(q) qd.",
       {kQ, kQd},
       {{"T", kOneElement, kOneElement, "J"}},
       kinetic_energy()},
      {"potential_energy",
       "6.5",
       "Potential energy of gravity; zero with all mass at the base origin.",
       {kQ},
       {{"U", kOneElement, kOneElement, "J"}},
       potential_energy()},
      {"dynamics_terms",
       "(2),(3),6.5",
       "A(q), B(q, qd) and G(q) in one call, with what they share computed once.",
       {kQ, kQd},
       {kA, kB, kG}},
      {"inverse_dynamics_regressor",
       "(1)",
       "Y of tau = Y theta; N x 10 N, row-major. theta: of link after link m, m c_x, m c_y, m c_z "
       "and xx, xy, xz, yy, yz, zz of the inertia tensor about the link's origin, link frame.",
       {kQ, kQd, kQdd},
       {{"Y", kN, k10N, "N m|N by unit of theta"}}},
  };
}

std::vector<Equation> factors() {
  return {
      {"mass_matrix_factor",
       "7.4",
       "L (unit lower triangular, N x N, row-major) and d of A = L^T diag(d) L, without fill-in.",
       {kQ},
       {{"L", kN, kN, "1|m|1/m"}, {"d", kN, kOneElement, "kg m^2|kg"}},
       mass_matrix_factor(),
       kErrataOfA,
       "L"},
      {"mass_matrix_solve",
       "7.4",
       "x of A(q) x = b by the factors of A.",
       {kQ, {"b", kN, kOneElement, kForce}},
       {{"x", kN, kOneElement, kAcceleration}},
       mass_matrix_solve(),
       kErrataOfA,
       "x"},
      {"mass_matrix_inverse",
       "7.4",
       "Inverse of A(q); N x N, row-major, symmetric.",
       {kQ},
       {{"A_inverse", kN, kN, "1/(kg m^2)|1/(kg m)|1/kg"}},
       mass_matrix_inverse(),
       kErrataOfA,
       "X"},
  };
}

const Equation* find_in(std::span<const Equation> rows, std::string_view name) {
  const auto found = std::ranges::find(rows, name, &Equation::name);
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Equation> functions() {
  static const std::vector<Equation> kFunctions = [] {
    std::vector<Equation> all;
    for (const auto& part : {dynamics(), points_and_vectors(), forces_and_energies(), factors()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return kFunctions;
}

std::span<const Equation> table() {
  static const std::vector<Equation> kTable = [] {
    std::vector<Equation> rows;
    std::ranges::copy_if(functions(), std::back_inserter(rows), [](const Equation& equation) {
      return equation.expression && equation.unknown.empty();
    });
    return rows;
  }();
  return kTable;
}

const Equation* find_function(std::string_view name) { return find_in(functions(), name); }

const Equation* find(std::string_view name) { return find_in(table(), name); }

const Equation* find_solved(std::string_view name) {
  const Equation* const found = find_function(name);
  return found != nullptr && found->expression ? found : nullptr;
}

bool divides_by_pivots(std::string_view name) {
  const Equation* const found = find_function(name);
  return found != nullptr && !found->unknown.empty();
}

}  // namespace treedyn::equations
