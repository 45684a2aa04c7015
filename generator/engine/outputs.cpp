#include "engine/outputs.hpp"

#include "equations/equations.hpp"

namespace treedyn::engine {
namespace {

constexpr std::string_view kRotations = "point_rotations";
constexpr std::string_view kForwardDynamics = "forward_dynamics";

Reduction reduction_of(const equations::Argument& output) {
  if (output.rows.of != Extent::Of::kPerDof) {
    return Reduction::kNone;
  }
  if (output.rows.factor == 3) {
    return Reduction::kSelection;
  }
  return output.cols.of == Extent::Of::kPerDof ? Reduction::kRowsCols : Reduction::kRows;
}

}  // namespace

std::vector<const equations::Equation*> functions() {
  std::vector<const equations::Equation*> result;
  for (const equations::Equation& function : equations::functions()) {
    if (equations::find(function.name) != nullptr || function.name == kForwardDynamics ||
        function.name == kRotations) {
      result.push_back(&function);
    }
  }
  return result;
}

Outputs::Outputs(const block::Index& index) : plan_(index) {
  for (const equations::Equation* function : functions()) {
    if (function->name == kRotations) {
      outputs_[function->name].function = function;
    } else {
      add(*function, function->name == kForwardDynamics
                         ? equations::bias_force() + equations::gravity_force()
                         : *function->expression);
    }
  }
}

void Outputs::add(const equations::Equation& function, const block::Expression& expression) {
  const equations::Argument& output = function.outputs.front();
  const int step = plan_.add(expression);
  outputs_[function.name] = {&function,   step,        expression.shape(),  plan_.needed({step}),
                             output.rows, output.cols, reduction_of(output)};
}

const Output* Outputs::find(std::string_view function) const {
  const auto found = outputs_.find(function);
  return found == outputs_.end() ? nullptr : &found->second;
}

}  // namespace treedyn::engine
