#include <algorithm>
#include <map>
#include <string_view>

#include "common/error.hpp"
#include "equations/table.hpp"
#include "formulate/builders.hpp"
#include "formulate/factored.hpp"
#include "formulate/regressor.hpp"

namespace treedyn::formulate {

namespace {

constexpr Freedom kFactors = {.regrouping = true, .tensor_form = true, .trunk = true};

/// What the search may choose; nothing of functions that are not here.
const std::map<std::string_view, Freedom>& freedoms() {
  static const std::map<std::string_view, Freedom> kFreedoms = {
      {"mass_matrix", kFactors},
      {"bias_force", {.regrouping = true, .moment_form = true}},
      {"gravity_force", {.regrouping = true}},
      {"inverse_dynamics", {.regrouping = true, .moment_form = true}},
      {"forward_dynamics",
       {.regrouping = true,
        .moment_form = true,
        .tensor_form = true,
        .trunk = true,
        .articulated = true}},
      {"point_positions", {.any_way = true}},
      {"point_velocities", {.any_way = true}},
      {"force_jacobian_transpose", {.any_way = true, .way = Way::kInLinks}},
      {"moment_jacobian_transpose", {.any_way = true, .way = Way::kInLinks}},
      {"point_bias_acceleration", {.any_way = true}},
      {"angular_bias_acceleration", {.any_way = true}},
      {"joint_to_link_vectors", {.way = Way::kInBase, .fixed_frames = true}},
      {"joint_to_com_vectors", {.way = Way::kInBase, .fixed_frames = true}},
      {"applied_force", {.any_way = true}},
      {"kinetic_energy", {.regrouping = true}},
      {"potential_energy", {.regrouping = true}},
      {"dynamics_terms",
       {.regrouping = true, .moment_form = true, .tensor_form = true, .trunk = true}},
      {"inverse_dynamics_regressor",
       {.fixed_frames = true, .fixed_length = true, .own_code = true}},
      {"mass_matrix_factor", kFactors},
      {"mass_matrix_solve", kFactors},
      {"mass_matrix_inverse", kFactors},
  };
  return kFreedoms;
}

/// From the equation of the table, or its solution by factors; from several of them.
Builder builder_of(const equations::Equation& function) {
  if (function.name == "forward_dynamics") {
    return build_forward_dynamics;
  }
  if (function.name == "dynamics_terms") {
    return build_dynamics_terms;
  }
  if (function.name == "inverse_dynamics_regressor") {
    return build_regressor;
  }
  if (function.name == "point_rotations") {
    return build_point_rotations;
  }
  const std::string name(function.name);
  if (function.unknown.empty()) {
    return [name](const Task& task) {
      return build_equation(task, name);
    };
  }
  return [name](const Task& task) {
    return build_factored(task, name);
  };
}

}  // namespace

Inputs places_of(const std::vector<std::string_view>& inputs) {
  Inputs places;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const std::map<std::string_view, int*> known = {
        {"q", &places.q}, {"qd", &places.qd}, {"qdd", &places.qdd}, {"tau", &places.tau}};
    if (const auto found = known.find(inputs[k]); found != known.end()) {
      *found->second = static_cast<int>(k);
    }
  }
  return places;
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> table = [] {
    std::vector<Recipe> rows;
    for (const equations::Equation& function : equations::functions()) {
      std::vector<std::string_view> inputs;
      for (const equations::Argument& argument : function.inputs) {
        inputs.push_back(argument.name);
      }
      const auto freedom = freedoms().find(function.name);
      rows.push_back({places_of(inputs), freedom == freedoms().end() ? Freedom{} : freedom->second,
                      builder_of(function), std::string(function.name)});
    }
    return rows;
  }();
  return table;
}

const Recipe& recipe_of(const std::string& name) {
  const auto found = std::find_if(recipes().begin(), recipes().end(),
                                  [&](const Recipe& recipe) { return name == recipe.name; });
  TREEDYN_EXPECT(found != recipes().end());
  return *found;
}

}  // namespace treedyn::formulate
