#include "engine/outputs.hpp"

#include "equations/equations.hpp"
#include "equations/table.hpp"

namespace treedyn::engine {
namespace {

Reduction reduction_of(const Signature& signature) {
  if (signature.output.rows.of != Extent::Of::kPerDof) {
    return Reduction::kNone;
  }
  if (signature.output.rows.factor == 3) {
    return Reduction::kSelection;
  }
  return signature.output.cols.of == Extent::Of::kPerDof ? Reduction::kRowsCols : Reduction::kRows;
}

}  // namespace

Outputs::Outputs(const block::Index& index) : plan_(index), outputs_(signatures().size()) {
  for (const equations::Equation& equation : equations::table()) {
    add(find_signature(equation.name)->function, *equation.expression);
  }
  add(Function::kForwardDynamics, equations::bias_force() + equations::gravity_force());
}

void Outputs::add(Function function, const block::Expression& expression) {
  const Signature& signature = signatures()[static_cast<std::size_t>(function)];
  Output& output = outputs_[static_cast<std::size_t>(function)];
  output.step = plan_.add(expression);
  output.shape = expression.shape();
  output.rows = signature.output.rows;
  output.cols = signature.output.cols;
  output.reduction = reduction_of(signature);
  output.steps = plan_.needed({output.step});
}

}  // namespace treedyn::engine
