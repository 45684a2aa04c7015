#include "simulation/state.hpp"

#include <algorithm>

namespace treedyn::simulation {

VectorValue::VectorValue(const model::VectorExpression& expressions)
    : expressions_(expressions),
      constant_(std::ranges::all_of(expressions,
                                    [](const model::Expression& e) { return e.is_constant(); })),
      value_(Eigen::Vector3d::Zero()) {
  for (std::size_t k = 0; k < 3 && constant_; ++k) {
    value_[static_cast<Eigen::Index>(k)] = static_cast<double>(expressions[k].value());
  }
}

}  // namespace treedyn::simulation
