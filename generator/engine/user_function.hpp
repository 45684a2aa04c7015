// Equations of users evaluated with numbers, as the equations of EQUATIONS.md are.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "block/evaluate.hpp"
#include "common/transformed.hpp"
#include "engine/scales.hpp"
#include "engine/tree_leaves.hpp"
#include "equations/number_of_tree.hpp"
#include "equations/user.hpp"

namespace treedyn::engine {

/// Evaluates one equation for a tree; coordinates are independent ones.
template <class Scalar>
class UserFunction {
 public:
  UserFunction(const equations::UserEquation& equation, const model::Tree& tree,
               std::span<const model::Point> points, const model::Vector3& gravity)
      : equation_(equation),
        plan_(equations::index_of(tree, points)),
        step_(plan_.add(equation.expression)),
        evaluation_(plan_),
        leaves_(tree, points, gravity, evaluation_) {}

  /// \param inputs  in the order of `UserEquation::arguments`
  /// \return row-major
  std::vector<Scalar> operator()(const std::vector<std::vector<Scalar>>& inputs) {
    set(inputs);
    evaluation_.run(plan_.needed({step_}));
    const block::Shape& shape = equation_.expression.shape();
    std::vector<Scalar> result(count(shape.rows) * count(shape.cols));
    evaluation_.write(step_, shape, result);
    return result;
  }

  /// The natural scale of every value, see Engine::scales.
  std::vector<double> scales(const std::vector<std::vector<Scalar>>& inputs) {
    set(inputs);
    Scales result(plan_);
    result.run(evaluation_, plan_.needed({step_}));
    return result.values(step_, equation_.expression.shape());
  }

 private:
  using Leaves = TreeLeaves<Scalar>;

  void set(const std::vector<std::vector<Scalar>>& inputs) {
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const equations::UserArgument& argument = equation_.arguments[k];
      if (!leaves_.set(argument.name, inputs[k])) {
        write(argument.leaf, inputs[k]);
      }
    }
    set_constants();
  }

  [[nodiscard]] std::size_t count(const block::Side& side) const {
    const std::size_t blocks = side.set == block::Set::kLinks    ? leaves_.constants().links.size()
                               : side.set == block::Set::kPoints ? leaves_.constants().points.size()
                                                                 : 1;
    return blocks * static_cast<std::size_t>(side.size);
  }
  void write(const std::string& leaf, const std::vector<Scalar>& values) {
    const std::span<Scalar> target = evaluation_.leaf(leaf);
    std::copy_n(values.begin(), target.size(), target.begin());
  }
  void set_constants() {
    const std::vector<Scalar> masses =
        transformed(leaves_.constants().links, [&](const auto& link) { return link.mass; });
    for (const auto& [leaf, values] : equation_.constants) {
      const std::vector<Scalar> numbers = transformed(values, Leaves::convert);
      write(leaf, numbers);
    }
    for (const auto& [leaf, divisor] : equation_.reciprocals) {
      write(leaf, {1 / equations::number_of_tree<Scalar>(equation_, divisor, plan_.index(), masses,
                                                         Leaves::convert)});
    }
    for (const auto& [leaf, frame] : equation_.frames) {
      equations::Matrix3<Scalar> R = equations::matrix3<Scalar>(frame.rotation, Leaves::convert);
      if (frame.link != model::kGround) {
        R = leaves_.poses().R[static_cast<std::size_t>(frame.link)] * R;
      }
      write(leaf, {R.data(), R.data() + 9});
    }
  }

  const equations::UserEquation& equation_;
  block::Plan plan_;
  int step_;
  block::Evaluation<Scalar> evaluation_;
  Leaves leaves_;
};

}  // namespace treedyn::engine
