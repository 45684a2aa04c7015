#include "simplify/scene_functions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "program/random.hpp"
#include "program/rank.hpp"
#include "simplify/constrained.hpp"
#include "simplify/functions.hpp"
#include "simplify/search.hpp"

namespace treedyn::simplify {

namespace {

constexpr const char* kForce = "N m|N";
constexpr const char* kAcceleration = "rad/s^2|m/s^2";

/// One scene and how hard to look for cheap formulations.
class SceneFormulator {
 public:
  SceneFormulator(const model::Scene& scene, const Options& options)
      : scene_(scene), options_(options), dof_(scene.tree.dof()) {
    options_.gravity = scene.gravity;
    options_.points = scene.points;
    options_.scene = &scene;
    for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
      all_.push_back(static_cast<int>(c));
    }
  }

  [[nodiscard]] int rows() const { return rows_of(scene_, all_); }

  [[nodiscard]] program::Function jacobian() const {
    return plain({"reaction_jacobian_transpose",
                  "(10)",
                  "J^T of the constraint rows: joint forces by unit reactions; N x r, row-major.",
                  {q()},
                  {{"J", dof_ * rows(), "m|1"}}},
                 build_reaction_jacobian);
  }

  [[nodiscard]] program::Function bias() const {
    return plain({"reaction_bias_acceleration",
                  "6.1",
                  "gamma = d/dt(J) qd of the constraint rows.",
                  {q(), qd()},
                  {{"gamma", rows(), kAcceleration}}},
                 build_reaction_bias);
  }

  [[nodiscard]] program::Staged constrained_dynamics(std::size_t phase) const;

 private:
  [[nodiscard]] program::Array q() const { return {"q", dof_, "rad|m"}; }
  [[nodiscard]] program::Array qd() const { return {"qd", dof_, "rad/s|m/s"}; }
  [[nodiscard]] Inputs places() const {
    return {.q = 0, .qd = scene_.velocity_products ? 1 : -1, .tau = 2};
  }

  [[nodiscard]] program::Function plain(const program::Signature& signature,
                                        std::vector<Expr> (*build)(const Task& task)) const {
    const Recipe recipe{"", "", "", {}, {}, places(), {.fixed_length = true}, build};
    program::Function function = cheapest(scene_.tree, recipe, options_);
    function.signature = signature;
    return function;
  }

  const model::Scene& scene_;
  Options options_;
  int dof_;
  std::vector<int> all_;
};

/// "foot, x" for every row of the constraints.
std::vector<std::string> row_names(const model::Scene& scene, const std::vector<int>& active) {
  std::vector<std::string> names;
  for (const int c : active) {
    const model::Constraint& constraint = scene.constraints[static_cast<std::size_t>(c)];
    for (std::size_t k = 0; k < constraint.rows(); ++k) {
      names.push_back(constraint.rows() == 1 ? constraint.name
                                             : fmt::format("{} {}", constraint.name, k));
    }
  }
  return names;
}

program::Staged SceneFormulator::constrained_dynamics(std::size_t phase) const {
  Options options = options_;
  options.active = scene_.phases[phase].active;
  const Recipe recipe{"",
                      "",
                      "",
                      {},
                      {},
                      places(),
                      {.regrouping = true,
                       .moment_form = true,
                       .tensor_form = true,
                       .trunk = true,
                       .fixed_length = true},
                      build_constrained_dynamics};
  const SceneArrays arrays = constrained_arrays(scene_, options.active);
  const int r = rows_of(scene_, options.active);
  program::Staged staged;
  staged.phase = static_cast<int>(phase);
  staged.function = cheapest(scene_.tree, recipe, options);
  const program::Array tau = {"tau", dof_, kForce};
  const program::Array qdd = {"qdd", dof_, kAcceleration};
  staged.signature = {phase_name(scene_, phase, "constrained_dynamics"),
                      r > 0 ? "(8),(12)" : "(8)",
                      r > 0 ? "Joint accelerations and reactions of the scene."
                            : "Joint accelerations of the scene.",
                      {q(), qd(), tau},
                      {qdd}};
  program::Signature& inner = staged.function.signature;
  inner = staged.signature;
  staged.levels = {0, 0, 0};
  if (r > 0) {
    staged.signature.outputs.push_back({"lambda", r, "N|N m"});
    inner.inputs.push_back({program::kMultiplierArray, r, ""});
    staged.levels.push_back(1);
    inner.outputs = {{program::kMatrixArray, r * (r + 1) / 2, ""},
                     {program::kRightArray, r, ""},
                     qdd,
                     staged.signature.outputs.back()};
  }
  if (arrays.t >= 0) {
    staged.signature.inputs.push_back({"t", 1, "s"});
    inner.inputs.push_back({"t", 1, "s"});
    staged.levels.push_back(0);
  }
  if (r > 0) {
    staged.solves.push_back(program::solve_of(staged.function, r));
  }
  staged.rows = row_names(scene_, options.active);
  return staged;
}

bool wants(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

}  // namespace

const std::vector<std::string>& scene_function_names() {
  static const std::vector<std::string> names = {
      "reaction_jacobian_transpose", "reaction_bias_acceleration", "constrained_dynamics"};
  return names;
}

std::string phase_name(const model::Scene& scene, std::size_t phase, const std::string& function) {
  return scene.phases.size() == 1
             ? function
             : fmt::format("{}_{}", function, to_identifier(scene.phases[phase].name));
}

SceneFunctions scene_functions(const model::Scene& scene, const Options& options,
                               const std::vector<std::string>& wanted) {
  const SceneFormulator formulator(scene, options);
  SceneFunctions result;
  if (formulator.rows() > 0 && wants(wanted, "reaction_jacobian_transpose")) {
    result.plain.push_back(formulator.jacobian());
  }
  if (formulator.rows() > 0 && wants(wanted, "reaction_bias_acceleration")) {
    result.plain.push_back(formulator.bias());
  }
  for (std::size_t phase = 0; phase < scene.phases.size(); ++phase) {
    if (wants(wanted, "constrained_dynamics")) {
      result.staged.push_back(formulator.constrained_dynamics(phase));
    }
  }
  return result;
}

}  // namespace treedyn::simplify
