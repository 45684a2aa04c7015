#include "equations/table.hpp"

#include <algorithm>
#include <vector>

#include "equations/equations.hpp"

namespace treedyn::equations {

std::span<const Equation> table() {
  static const std::vector<Equation> kTable = {
      {"mass_matrix", "(2)", mass_matrix(), "E10 E11 E13"},
      {"bias_force", "(3)", bias_force(), "E1 E2 E3 E4 E5 E10 E11 E14"},
      {"gravity_force", "6.5", gravity_force(), "E20"},
      {"inverse_dynamics", "(1)", inverse_dynamics(), "E1 E2 E3 E4 E5 E10 E11 E12"},
      {"point_positions", "1.2", point_positions()},
      {"point_velocities", "6.1", point_velocities()},
      {"force_jacobian_transpose", "(9)", force_jacobian_transpose(points()), "E6 E17"},
      {"moment_jacobian_transpose", "(11)", moment_jacobian_transpose(points())},
      {"point_bias_acceleration", "6.1", point_bias_acceleration(), "E1 E2 E4"},
      {"angular_bias_acceleration", "6.1", angular_bias_acceleration()},
      {"joint_to_link_vectors", "(6)", joint_to_link_vectors()},
      {"joint_to_com_vectors", "(7)", joint_to_com_vectors(), "E13"},
      {"applied_force", "(8)", applied_force(), "E7 E12"},
      {"kinetic_energy", "1/2 q̇^T A q̇", kinetic_energy()},
      {"potential_energy", "-Σ m_i g·r_i", potential_energy()},
  };
  return kTable;
}

std::span<const Equation> solved_table() {
  static const std::vector<Equation> kTable = {
      {"forward_dynamics", "(1)", forward_dynamics(), find("inverse_dynamics")->errata, "q̈"},
      {"mass_matrix_factor", "7.4", mass_matrix_factor(), find("mass_matrix")->errata, "L"},
      {"mass_matrix_solve", "7.4", mass_matrix_solve(), find("mass_matrix")->errata, "x"},
      {"mass_matrix_inverse", "7.4", mass_matrix_inverse(), find("mass_matrix")->errata, "X"},
  };
  return kTable;
}

namespace {

const Equation* find(std::span<const Equation> table, std::string_view name) {
  const auto found = std::ranges::find(table, name, &Equation::name);
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

const Equation* find(std::string_view name) { return find(table(), name); }

const Equation* find_solved(std::string_view name) {
  const Equation* const solved = find(solved_table(), name);
  return solved != nullptr ? solved : find(name);
}

}  // namespace treedyn::equations
