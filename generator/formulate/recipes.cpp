#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/transformed.hpp"
#include "equations/table.hpp"
#include "formulate/factored.hpp"
#include "formulate/trunk.hpp"

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
      {"inverse_dynamics_regressor", {.fixed_frames = true, .own_code = true}},
      {"mass_matrix_factor", kFactors},
      {"mass_matrix_solve", kFactors},
      {"mass_matrix_inverse", kFactors},
  };
  return kFreedoms;
}

/// (1) solved for qdd.
std::vector<Expr> build_forward_dynamics(const Task& task) {
  const Kinematics& k = task.kinematics;
  if (task.tree.mimics() == 0 && k.variant().trunk && !k.is_from_trunk() && has_trunk(task.tree)) {
    std::vector<Expr> tau;
    for (int i = 0; i < k.size(); ++i) {
      tau.push_back(k.of_joint(i, k.inputs().tau));
    }
    const Trunk trunk(task);
    const Kinematics seen = trunk.seen().kinematics.with_forces(trunk.forces(tau));
    return trunk.joint_accelerations(
        build_forward_dynamics({task.tree, task.normal, task.options, seen}));
  }
  return k.variant().articulated && task.tree.mimics() == 0
             ? build_derived(task, *derived("forward_dynamics"), Way::kToRoot)
             : build_factored(task, "forward_dynamics");
}

std::vector<Expr> build_dynamics_terms(const Task& task) {
  const Kinematics& k = task.kinematics;
  const Kinematics at_rest(k.graph(), task.tree, task.normal, k.variant(), {.q = 0}, k.limbs());
  const std::vector<Expr> bias = build_equation(task, "bias_force");
  const std::vector<Expr> gravity =
      build_equation({task.tree, task.normal, task.options, at_rest}, "inverse_dynamics");
  std::vector<Expr> result = build_equation(task, "mass_matrix");
  result.insert(result.end(), bias.begin(), bias.end());
  result.insert(result.end(), gravity.begin(), gravity.end());
  return result;
}

constexpr int kParameters = 10;
/// Rows and columns of xx xy xz yy yz zz.
constexpr std::array<std::array<std::size_t, 2>, 6> kEntries = {
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

/// Gives a link a unit of one parameter, which counts in the model's frame of the link.
void add_unit(NormalLink& link, int parameter) {
  const auto k = to_index(parameter);
  Vector3 moment{};
  Matrix3 pseudo{};
  if (k == 0) {
    link.mass = 1;
  } else if (k < 4) {
    moment[k - 1] = 1;
  } else {
    const auto [row, column] = kEntries[k - 4];
    Matrix3 tensor{};
    tensor[3 * row + column] = tensor[3 * column + row] = 1;
    pseudo = second_moments(tensor);
  }
  const Vector3& o = link.origin;
  pseudo = pseudo - outer(o, moment) - outer(moment, o) + link.mass * outer(o, o);
  link.moment = multiply(link.to_normal, moment - link.mass * o);
  link.pseudo = congruence(link.to_normal, pseudo);
}

/// Y of tau = Y theta, N x 10 N, row-major. tau is linear in the mass, the first moment and the
/// inertia tensor about its origin of every link, so a column is (1) of a robot that has nothing
/// but a unit of that parameter. All columns share the kinematics.
/// \pre every link has a coordinate of its own
std::vector<Expr> build_regressor(const Task& task) {
  const Kinematics& k = task.kinematics;
  model::Tree bare = task.tree;
  for (model::Link& link : bare.links) {
    link.inertia = {};
  }
  const NormalTree nothing = normal_form(bare, task.options.gravity, k.variant());
  const std::size_t columns = kParameters * bare.links.size();
  std::vector<Expr> Y(bare.links.size() * columns);
  for (int link = 0; link < bare.size(); ++link) {
    for (int parameter = 0; parameter < kParameters; ++parameter) {
      NormalTree normal = nothing;
      add_unit(normal.links[to_index(link)], parameter);
      const Kinematics own(k.graph(), bare, normal, k.variant(), k.inputs());
      const std::vector<Expr> tau =
          build_equation({bare, normal, task.options, own}, "inverse_dynamics");
      for (std::size_t row = 0; row < tau.size(); ++row) {
        Y[row * columns + to_index(kParameters * link + parameter)] = tau[row];
      }
    }
  }
  return Y;
}

std::vector<Expr> build_point_rotations(const Task& task) {
  return point_rotations(task.kinematics, task.options.points);
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
      const std::vector<std::string_view> inputs =
          transformed(function.inputs, &equations::Argument::name);
      const auto freedom = freedoms().find(function.name);
      rows.push_back({places_of(inputs), freedom == freedoms().end() ? Freedom{} : freedom->second,
                      builder_of(function), std::string(function.name)});
    }
    return rows;
  }();
  return table;
}

const Recipe& recipe_of(const std::string& name) {
  const auto found = std::ranges::find(recipes(), name, &Recipe::name);
  TREEDYN_EXPECT(found != recipes().end());
  return *found;
}

}  // namespace treedyn::formulate
