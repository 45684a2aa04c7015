// Expressions of a scene in numbers.
#pragma once

#include "model/scene.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

/// When and how the joints are.
struct State {
  double t;
  Eigen::Ref<const Vector> q;
  Eigen::Ref<const Vector> qd;
};

/// A variable that belongs to the state; 0 for one that belongs to a point.
inline double value_in(const State& state, const model::Variable& variable) {
  switch (variable.quantity) {
    case model::Quantity::kTime:
      return state.t;
    case model::Quantity::kPosition:
      return state.q[variable.index];
    case model::Quantity::kVelocity:
      return state.qd[variable.index];
    default:
      return 0;
  }
}

inline double value_of(const model::Expression& expression, const State& state) {
  return expression.evaluate(
      [&](const model::Variable& variable) { return value_in(state, variable); });
}

/// Three expressions; constants are converted once.
class VectorValue {
 public:
  explicit VectorValue(const model::VectorExpression& expressions);
  template <class OfVariable>
  [[nodiscard]] Eigen::Vector3d evaluate(const OfVariable& variable) const {
    return constant_ ? value_
                     : Eigen::Vector3d(expressions_[0].evaluate(variable),
                                       expressions_[1].evaluate(variable),
                                       expressions_[2].evaluate(variable));
  }
  /// Of time alone.
  [[nodiscard]] Eigen::Vector3d at(double t) const {
    return evaluate([t](const model::Variable&) { return t; });
  }

 private:
  model::VectorExpression expressions_;
  bool constant_;
  Eigen::Vector3d value_;
};

}  // namespace treedyn::simulation
