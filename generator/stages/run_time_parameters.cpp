#include <set>

#include <fmt/format.h>

#include "emit/run_time.hpp"
#include "model/parameters.hpp"
#include "optimise/separate_parameters.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

/// Functions that no mass enters. The others, and with lengths among the parameters all, take what
/// is known at run time, whether a model needs it or not: a signature is no matter of numbers.
bool is_weighed(const program::Signature& signature) {
  static const std::set<std::string> kKinematic = {"point_positions",
                                                   "point_velocities",
                                                   "point_rotations",
                                                   "force_jacobian_transpose",
                                                   "moment_jacobian_transpose",
                                                   "point_bias_acceleration",
                                                   "angular_bias_acceleration",
                                                   "joint_to_link_vectors",
                                                   "applied_force",
                                                   "inverse_dynamics_regressor",
                                                   "reaction_jacobian_transpose",
                                                   "reaction_bias_acceleration"};
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
  for (const program::Array& array : signature.arrays()) {
    refuse(array.name);
  }
}

/// Calls `visit` for all functions in stages, those that others call as well.
template <class Visit>
void each_staged(program::Programs& programs, const Visit& visit) {
  const auto all = [&](std::vector<program::Staged>& functions) {
    for (program::Staged& staged : functions) {
      std::ranges::for_each(staged.contacts, visit);
      visit(staged);
    }
  };
  all(programs.staged);
  for (program::Stepper& stepper : programs.steppers) {
    for (program::StepPhase& phase : stepper.phases) {
      all(phase.guards);
      all(phase.approaches);
    }
    all(stepper.anchors);
  }
}

/// The texts of the argument, in functions that have got it.
class Argument {
 public:
  explicit Argument(program::Array array) : array_(std::move(array)) {}

  void describe(program::Signature& signature) const {
    for (program::Array& array : signature.inputs) {
      if (array.type == emit::kDerivedParameters) {
        array = array_;
      }
    }
  }
  /// Functions in stages take it before the first one.
  void pass(program::Staged& staged) const {
    describe(staged.function.signature);
    staged.signature.inputs.push_back(array_);
    staged.levels.push_back(0);
  }
  void pass(program::Stepper& stepper) const {
    stepper.signature.inputs.push_back(array_);
    stepper.takes_derived = true;
  }

 private:
  program::Array array_;
};

}  // namespace

void separate_parameters(const Model& model, const Request& request, program::Programs& programs) {
  if (model.tree.parameters.empty()) {
    return;
  }
  std::vector<program::Function*> functions;
  for (program::Function& function : programs.functions) {
    refuse_names(function.signature, {request.model, 0, 0});
    functions.push_back(&function);
  }
  const std::size_t plain = functions.size();
  each_staged(programs, [&](program::Staged& staged) { functions.push_back(&staged.function); });
  const std::set<const program::Function*> staged(
      functions.begin() + static_cast<std::ptrdiff_t>(plain), functions.end());
  const bool of_model = !model::of_scene_alone(model.tree);
  const bool lengths = model::has_lengths(model.tree);
  optimise::Separated separated = optimise::separate_parameters(
      functions, emit::parameters_array(model.tree), emit::derived_array(),
      [&](const program::Function& function) {
        return staged.contains(&function) ||
               (of_model && (lengths || is_weighed(function.signature)));
      });
  program::Function& update = separated.update;
  update.signature.name = emit::kUpdate;
  update.signature.brief =
      "What the functions need of the run-time parameters: to be called before them and when a "
      "parameter has changed.";
  program::Array& derived = update.signature.outputs.front();
  derived.fields = emit::derived_names(separated.numbers, model.tree);
  const Argument argument(derived);
  for (program::Function& function : programs.functions) {
    argument.describe(function.signature);
  }
  each_staged(programs, [&](program::Staged& function) { argument.pass(function); });
  for (program::Stepper& stepper : programs.steppers) {
    argument.pass(stepper);
  }
  programs.update = std::move(separated.update);
  programs.derived = std::move(separated.numbers);
}

void require_use_of_parameters(const Model& model, const Request& request,
                               const program::Programs& programs) {
  if (!programs.update || !request.functions.empty()) {
    return;
  }
  const program::Function& update = *programs.update;
  std::set<int> used;
  for (const program::Ref k : program::reachable(update.graph, update.outputs)) {
    const program::Node& node = update.graph.node(k);
    if (node.kind == program::Kind::kInput) {
      used.insert(node.b);
    }
  }
  int index = 0;
  for (const model::Parameter& parameter : model.tree.parameters) {
    if (parameter.quantity == model::ParameterKind::kScene && !used.contains(index)) {
      throw InputError({request.scene.value_or(request.model), 0, 0},
                       fmt::format("runtime: no function that is generated depends on parameter "
                                   "'{}'; expected one of an effect that is on",
                                   parameter.declared));
    }
    ++index;
  }
}

}  // namespace treedyn
