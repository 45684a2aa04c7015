#include "equations/table.hpp"

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

const Equation* find(std::string_view name) {
  for (const Equation& equation : table()) {
    if (equation.name == name) {
      return &equation;
    }
  }
  return nullptr;
}

const Equation* find_solved(std::string_view name) {
  static const Equation kForward = {"forward_dynamics", "(1)", forward_dynamics(),
                                    find("inverse_dynamics")->errata, "q̈"};
  return name == kForward.name ? &kForward : find(name);
}

}  // namespace treedyn::equations
