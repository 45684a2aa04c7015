#include "stages/run_time_parameters.hpp"

#include <set>

#include <fmt/format.h>

#include "emit/run_time.hpp"
#include "model/parameters.hpp"
#include "optimise/separate_parameters.hpp"

namespace treedyn {

namespace {

/// Functions that no mass enters. The others, and with lengths among the parameters all, take what
/// is known at run time, whether a model needs it or not: a signature is no matter of numbers.
bool is_weighed(const program::Signature& signature) {
  static const std::set<std::string> kKinematic = {
      "point_positions",           "point_velocities",          "point_rotations",
      "force_jacobian_transpose",  "moment_jacobian_transpose", "point_bias_acceleration",
      "angular_bias_acceleration", "joint_to_link_vectors",     "applied_force",
      "inverse_dynamics_regressor"};
  return !kKinematic.contains(signature.name);
}

/// A user's function or argument that is called what run-time parameters need.
void refuse_names(const program::Signature& signature, const Location& where) {
  const std::set<std::string> taken = {emit::kUpdate, emit::kParameters, emit::kDerivedParameters,
                                       emit::kNominal, emit::derived_array().name};
  const auto refuse = [&](const std::string& name) {
    if (taken.contains(name)) {
      throw InputError(where, fmt::format("function '{}': the name {} is one of run-time "
                                          "parameters; expected another one",
                                          signature.name, name));
    }
  };
  refuse(signature.name);
  for (const auto* const arrays : {&signature.inputs, &signature.outputs}) {
    for (const program::Array& array : *arrays) {
      refuse(array.name);
    }
  }
}

}  // namespace

void separate_parameters(const Model& model, const Request& request, program::Programs& programs) {
  if (model.tree.parameters.empty()) {
    return;
  }
  const program::Array derived = emit::derived_array();
  for (const program::Function& function : programs.functions) {
    refuse_names(function.signature, {request.model, 0, 0});
  }
  optimise::Separated separated = optimise::separate_parameters(
      programs.functions, emit::parameters_array(model.tree), derived,
      [lengths = model::has_lengths(model.tree)](const program::Signature& signature) {
        return lengths || is_weighed(signature);
      });
  program::Function& update = separated.update;
  update.signature.name = emit::kUpdate;
  update.signature.brief =
      "What the functions need of the run-time parameters: to be called before them and when a "
      "parameter has changed.";
  const std::vector<std::string> names = emit::derived_names(separated.numbers, model.tree);
  update.signature.outputs.front().fields = names;
  for (program::Function& function : programs.functions) {
    for (program::Array& array : function.signature.inputs) {
      if (array.type == emit::kDerivedParameters) {
        array.fields = names;
      }
    }
  }
  programs.update = std::move(separated.update);
  programs.derived = std::move(separated.numbers);
}

}  // namespace treedyn
