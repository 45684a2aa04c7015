#include "equations/scene_table.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "equations/equations.hpp"

namespace treedyn::equations {

const std::vector<SceneFunctionInfo>& scene_function_infos() {
  static const std::vector<SceneFunctionInfo> infos = {
      {"reaction_jacobian_transpose",
       "(10)",
       "J^T of the constraint rows: joint forces by unit reactions; N x r, row-major.",
       {reaction_jacobian_transpose()}},
      {"reaction_bias_acceleration",
       "6.2",
       "gamma = d/dt(J) qd of the constraint rows.",
       {bias_of_attached_rows()}},
      {"constrained_dynamics",
       "(8),(12)",
       "Joint accelerations and reactions; tau comes on top of the scene's own joint forces.",
       {constrained_dynamics().motion, constrained_dynamics().rows},
       "q̈"},
      {"constrained_inverse_dynamics",
       "(8),(12)",
       "Joint forces, on top of the scene's own, and reactions that make a motion; joints without "
       "a "
       "drive get none where reactions can do without.",
       {constrained_inverse_dynamics().passive, constrained_inverse_dynamics().drives},
       "",
       "τ"},
      {"impact",
       "6.4",
       "Joint velocities after an impact, and its impulses.",
       {impact().motion, impact().rows},
       "Δq̇"},
      {"step", "(8),(12)", "State one step of the scene's integrator later; phases change inside."},
      {"contact_force", "6.2",
       "Force of the ground on a point, base frame; zero above the ground."}};
  return infos;
}

namespace {

auto found(std::string_view name) {
  const std::vector<SceneFunctionInfo>& infos = scene_function_infos();
  return std::ranges::find(infos, name, &SceneFunctionInfo::name);
}

}  // namespace

bool is_scene_function(std::string_view name) {
  return found(name) != scene_function_infos().end();
}

const SceneFunctionInfo& scene_function_info(std::string_view name) {
  const auto info = found(name);
  TREEDYN_EXPECT(info != scene_function_infos().end());
  return *info;
}

}  // namespace treedyn::equations
