#include "equations/table.hpp"

#include <vector>

#include "equations/equations.hpp"

namespace treedyn::equations {

std::span<const Equation> table() {
  static const std::vector<Equation> kTable = {
      {"mass_matrix", "(2)", mass_matrix()},
      {"bias_force", "(3)", bias_force()},
      {"gravity_force", "6.5", gravity_force()},
      {"inverse_dynamics", "(1)", inverse_dynamics()},
      {"point_positions", "1.2", point_positions()},
      {"point_velocities", "6.1", point_velocities()},
      {"force_jacobian_transpose", "(9)", force_jacobian_transpose(points())},
      {"moment_jacobian_transpose", "(11)", moment_jacobian_transpose(points())},
      {"point_bias_acceleration", "6.1", point_bias_acceleration()},
      {"angular_bias_acceleration", "6.1", angular_bias_acceleration()},
      {"joint_to_link_vectors", "(6)", joint_to_link_vectors()},
      {"joint_to_com_vectors", "(7)", joint_to_com_vectors()},
      {"applied_force", "(8)", applied_force()},
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

}  // namespace treedyn::equations
