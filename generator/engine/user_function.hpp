// Equations of users evaluated with numbers, as the equations of EQUATIONS.md are.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "block/evaluate.hpp"
#include "engine/coordinates.hpp"
#include "engine/scales.hpp"
#include "equations/kinematics.hpp"
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
        coordinates_(tree, convert),
        constants_(equations::constants_of<Scalar>(tree, points, convert)),
        plan_(equations::index_of(tree, points)),
        step_(plan_.add(equation.expression)),
        evaluation_(plan_),
        poses_(tree.links.size()),
        gravity_(gravity) {}

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
  void set(const std::vector<std::vector<Scalar>>& inputs) {
    std::vector<Scalar> q(links(), Scalar(0));
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const equations::UserArgument& argument = equation_.arguments[k];
      if (argument.name == "q") {
        coordinates_.expand_positions(inputs[k], q);
      } else {
        set(argument, inputs[k]);
      }
    }
    set_positions(q);
    set_constants();
  }

  static Scalar convert(const Real& x) { return static_cast<Scalar>(x); }
  [[nodiscard]] std::size_t links() const { return constants_.links.size(); }
  [[nodiscard]] std::size_t count(const block::Side& side) const {
    const std::size_t blocks = side.set == block::Set::kLinks    ? links()
                               : side.set == block::Set::kPoints ? constants_.points.size()
                                                                 : 1;
    return blocks * static_cast<std::size_t>(side.size);
  }
  void write(const std::string& leaf, const std::vector<Scalar>& values) {
    const std::span<Scalar> target = evaluation_.leaf(leaf);
    std::copy_n(values.begin(), target.size(), target.begin());
  }
  void set(const equations::UserArgument& argument, const std::vector<Scalar>& values) {
    if (argument.name != "qd" && argument.name != "qdd") {
      return write(argument.leaf, values);
    }
    std::vector<Scalar> rates(links());
    coordinates_.expand_rates(values, rates);
    for (const char* leaf : {"q̇", "q̇^d"}) {
      write(argument.name == "qd" ? leaf : "q̈", rates);
    }
  }
  void set_positions(const std::vector<Scalar>& q) {
    using std::cos;
    using std::sin;
    std::vector<Scalar> sine(links()), cosine(links());
    for (std::size_t i = 0; i < links(); ++i) {
      sine[i] = sin(q[i]);
      cosine[i] = cos(q[i]);
    }
    equations::compute_poses<Scalar>(constants_, {sine, cosine, q}, poses_);
    equations::LeafWriter<Scalar>(evaluation_).write(constants_, poses_);
  }
  void set_constants() {
    std::vector<Scalar> masses;
    std::vector<Scalar> g;
    for (const auto& link : constants_.links) {
      masses.push_back(link.mass);
      std::transform(gravity_.begin(), gravity_.end(), std::back_inserter(g), convert);
    }
    write("m^d", masses);
    write("g", g);
    for (const auto& [leaf, values] : equation_.constants) {
      std::vector<Scalar> numbers;
      std::transform(values.begin(), values.end(), std::back_inserter(numbers), convert);
      write(leaf, numbers);
    }
    for (const auto& [leaf, divisor] : equation_.reciprocals) {
      write(leaf, {1 / equations::number_of_tree<Scalar>(equation_, divisor, plan_.index(), masses,
                                                         convert)});
    }
    for (const auto& [leaf, frame] : equation_.frames) {
      equations::Matrix3<Scalar> R = equations::matrix3<Scalar>(frame.rotation, convert);
      if (frame.link != model::kGround) {
        R = poses_.R[static_cast<std::size_t>(frame.link)] * R;
      }
      write(leaf, {R.data(), R.data() + 9});
    }
  }

  const equations::UserEquation& equation_;
  Coordinates<Scalar> coordinates_;
  equations::Constants<Scalar> constants_;
  block::Plan plan_;
  int step_;
  block::Evaluation<Scalar> evaluation_;
  equations::Poses<Scalar> poses_;
  model::Vector3 gravity_;
};

}  // namespace treedyn::engine
