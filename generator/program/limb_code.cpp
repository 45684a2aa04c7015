#include "program/limb_code.hpp"

#include "common/index.hpp"

namespace treedyn::program {

namespace {}  // namespace

int LimbCode::arguments() const {
  auto result = static_cast<int>(trunk.signature.inputs.size());
  for (const LimbClass& limb_class : limbs) {
    result -= limb_class.size();
  }
  return result;
}

int LimbCode::level(int array, int element) const {
  int first = arguments();
  for (std::size_t c = 0; c < limbs.size(); ++c) {
    if (array >= first && array < first + limbs[c].size()) {
      return values[c][to_index(element)].stage + 1;
    }
    first += limbs[c].size();
  }
  return 0;
}

Cost cost(const LimbCode& code) {
  Cost result = cost(code.trunk.graph, code.trunk.outputs);
  for (const LimbPhase& phase : code.phases) {
    result = result + code.limbs[to_index(phase.limb_class)].size() *
                          cost(phase.function.graph, phase.function.outputs);
  }
  return result;
}

}  // namespace treedyn::program
