#include "equations/scene_table.hpp"

#include <algorithm>

namespace treedyn::equations {

const std::vector<SceneFunctionInfo>& scene_function_infos() {
  static const std::vector<SceneFunctionInfo> infos = {
      {"reaction_jacobian_transpose", "(10)", "J^T of the constraint rows."},
      {"reaction_bias_acceleration", "6.1", "gamma = d/dt(J) qd of the constraint rows."},
      {"constrained_dynamics", "(8),(12)", "Joint accelerations and reactions."},
      {"constrained_inverse_dynamics", "(8),(12)", "Joint forces and reactions of a motion."},
      {"impact", "6.4", "Joint velocities after an impact, and its impulses."},
      {"step", "(8),(12)", "State one step of the scene's integrator later; phases change inside."},
      {"contact_force", "6.5", "Force of the ground on a point, base frame."}};
  return infos;
}

bool is_scene_function(const std::string& name) {
  const std::vector<SceneFunctionInfo>& infos = scene_function_infos();
  return std::any_of(infos.begin(), infos.end(),
                     [&](const SceneFunctionInfo& info) { return info.name == name; });
}

}  // namespace treedyn::equations
