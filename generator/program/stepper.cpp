#include "program/stepper.hpp"

namespace treedyn::program {

Cost step_cost(const Stepper& stepper, const Cost& dynamics) {
  const int n = stepper.signature.inputs.front().size;
  if (stepper.method == StepMethod::kSemiImplicitEuler) {
    return dynamics + Cost{.add = 2 * n, .mul = 2 * n};
  }
  const Cost own{.add = 14 * n + (stepper.takes_time ? 2 : 0), .mul = 10 * n};
  return dynamics + dynamics + dynamics + dynamics + own;
}

}  // namespace treedyn::program
