#include "stages/proof.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "equations/scene_table.hpp"
#include "formulate/scene_functions.hpp"
#include "request/limits.hpp"
#include "verify/prove.hpp"
#include "verify/prove_scene.hpp"

namespace treedyn {

void prove(const Model& model, const Request& request, const program::Programs& programs) {
  std::vector<program::Function> of_model;
  std::copy_if(programs.functions.begin(), programs.functions.end(), std::back_inserter(of_model),
               [](const program::Function& function) {
                 return !equations::is_scene_function(function.signature.name);
               });
  const model::Vector3 gravity = decided_request(model, request).gravity;
  UserEquations equations;
  for (const auto& function : model.equations) {
    equations.push_back(&function->equation);
  }
  try {
    prove_functions(model.tree, model.points, gravity, equations, of_model,
                    programs.update ? &*programs.update : nullptr);
  } catch (const std::range_error& error) {
    refuse_decades(model.tree, error.what());
  }
  if (model.scene) {
    prove_scene(*model.scene, programs);
  }
}

}  // namespace treedyn
