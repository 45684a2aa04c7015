#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "common/index.hpp"
#include "equations/scene_table.hpp"
#include "formulate/stand_ins.hpp"
#include "model/parameters.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"
#include "request/limits.hpp"
#include "stages/stages.hpp"
#include "verify/at_states.hpp"
#include "verify/scene_at_states.hpp"

namespace treedyn {

namespace {

/// Run-time parameters near their nominal values: a part `most` more, at most, of what they are, or
/// of 1. Tensors stay positive definite: what is added is the outer product of a vector.
std::vector<Real> parameters_near(const model::Tree& tree, const model::Vector3& gravity,
                                  double most) {
  constexpr std::array<std::pair<std::size_t, std::size_t>, 6> kPlaces = {
      {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  const auto size_of = [](const Real& nominal) {
    return nominal == 0 ? Real(1) : nominal;
  };
  program::Random random(11);
  std::map<int, model::Vector3> added;
  std::vector<Real> values;
  for (const model::Parameter& parameter : tree.parameters) {
    const Real nominal = model::nominal(tree, gravity, parameter).plain();
    if (parameter.quantity != model::ParameterKind::kInertia) {
      values.push_back(nominal + size_of(nominal) * most * (1 + random.symmetric()) / 2);
      continue;
    }
    const auto [at, is_new] = added.try_emplace(parameter.link);
    if (is_new) {
      std::ranges::generate(at->second, [&] { return Real(random.symmetric()); });
    }
    const model::Matrix3& tensor = tree.links[to_index(parameter.link)].inertia.about_com;
    const auto [i, j] = kPlaces[to_index(parameter.component)];
    const Real square = size_of(tensor[4 * i].plain()) * size_of(tensor[4 * j].plain());
    values.push_back(nominal + most * sqrt(square) * at->second[i] * at->second[j]);
  }
  return values;
}

/// With nominal values of run-time parameters, and with others.
void check_scene(const Model& model, const program::Programs& programs) {
  if (!programs.update) {
    verify::check_scene_at_states(*model.scene, programs);
    return;
  }
  constexpr double kMore[] = {0.5, 0.05, 0.005};  // of the nominal values, where that is a number
  const auto checked = [&](double most) {
    const std::vector<Real> values = parameters_near(model.tree, model.scene->gravity, most);
    const std::vector<std::span<const Real>> inputs = {values};
    const std::vector<Real> derived = program::interpret<Real>(*programs.update, inputs);
    const bool is_there = std::ranges::all_of(derived, [](const Real& x) { return isfinite(x); });
    if (is_there) {
      verify::check_scene_at_states(formulate::with_values(*model.scene, values), programs,
                                    derived);
    }
    return is_there;
  };
  checked(0);
  std::ranges::any_of(kMore, checked);
}

}  // namespace

void check_at_states(const Model& model, const Request& request,
                     const program::Programs& programs) {
  std::vector<program::Function> of_model;
  std::ranges::copy_if(programs.functions, std::back_inserter(of_model),
                       [](const program::Function& function) {
                         return !equations::is_scene_function(function.signature.name);
                       });
  model::Vector3 gravity = decided_request(model, request).gravity;
  std::ranges::for_each(gravity, [](Real& x) { x = x.plain(); });
  verify::UserEquations equations;
  for (const auto& function : model.equations) {
    equations.push_back(&function->equation);
  }
  try {
    verify::check_at_states(model.tree, model.points, gravity, equations, of_model,
                            programs.update ? &*programs.update : nullptr);
  } catch (const std::range_error& error) {
    refuse_decades(model.tree, error.what());
  }
  if (model.scene) {
    try {
      check_scene(model, programs);
    } catch (const std::domain_error& error) {
      throw InputError({*request.scene, 0, 0}, error.what());
    }
  }
}

}  // namespace treedyn
