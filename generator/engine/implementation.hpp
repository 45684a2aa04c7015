// What Engine is made of; included by the files that instantiate it.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "block/evaluate.hpp"
#include "block/plan.hpp"
#include "engine/coordinates.hpp"
#include "engine/engine.hpp"
#include "engine/inertia_factor.hpp"
#include "engine/outputs.hpp"
#include "engine/scales.hpp"
#include "equations/kinematics.hpp"

namespace treedyn::engine {

template <class Scalar>
class Engine<Scalar>::Implementation {
 public:
  Implementation(const model::Tree& tree, std::span<const model::Point> points,
                 const model::Vector3& gravity)
      : coordinates_(tree, convert),
        sizes_(tree, [](const Real& x) { return std::abs(static_cast<double>(x)); }),
        outputs_(equations::index_of(tree, points)),
        inertia_(*outputs_.find("mass_matrix")),
        constants_(equations::constants_of<Scalar>(tree, points, convert)),
        evaluation_(outputs_.plan()),
        leaves_(evaluation_),
        poses_(tree.links.size()),
        sine_(tree.links.size()),
        cosine_(tree.links.size()),
        q_(tree.links.size()),
        full_(largest_output()),
        result_(full_.size()),
        factor_(coordinates_.dof(), coordinates_.dof()),
        solution_(coordinates_.dof()) {
    write_constant_leaves(gravity);
  }

  [[nodiscard]] int dof() const { return coordinates_.dof(); }
  [[nodiscard]] int links() const { return static_cast<int>(q_.size()); }
  [[nodiscard]] int points() const { return static_cast<int>(constants_.points.size()); }

  /// nullptr if there is no such function.
  [[nodiscard]] const Output* find(std::string_view function) const {
    return outputs_.find(function);
  }

  std::span<const Scalar> evaluate(const Output& output,
                                   std::span<const std::span<const Scalar>> inputs) {
    set_inputs(*output.function, inputs);
    if (output.step < 0) {
      return rotations();
    }
    evaluation_.run(output.steps);
    return is_solved(output) ? solved(output, inputs.back()) : reduced(output);
  }

  std::vector<double> scales(const Output& output,
                             std::span<const std::span<const Scalar>> inputs) {
    evaluate(output, inputs);
    if (output.step < 0) {
      return std::vector<double>(9 * constants_.points.size(), 1);
    }
    const std::vector<double> sums = sizes_of_terms(output);
    return is_solved(output) ? sizes_of_solution(sums, inputs.back()) : sums;
  }

 private:
  static Scalar convert(const Real& x) { return static_cast<Scalar>(x); }

  static bool is_solved(const Output& output) { return !output.function->unknown.empty(); }

  [[nodiscard]] std::size_t largest_output() const {
    int largest = 0;
    for (const equations::Equation* function : functions()) {
      largest = std::max(largest, function->outputs.front().size(links(), points()));
    }
    return static_cast<std::size_t>(largest);
  }

  void write_constant_leaves(const model::Vector3& gravity) {
    const std::span<Scalar> mass = evaluation_.leaf("m^d");
    const std::span<Scalar> g = evaluation_.leaf("g");
    for (std::size_t i = 0; i < q_.size(); ++i) {
      mass[i] = constants_.links[i].mass;
      for (std::size_t n = 0; n < 3; ++n) {
        g[3 * i + n] = convert(gravity[n]);
      }
    }
  }

  void set_inputs(const equations::Equation& function,
                  std::span<const std::span<const Scalar>> inputs) {
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const std::string_view name = function.inputs[k].name;
      if (name == "q") {
        set_positions(inputs[k]);
      } else if (name == "qd") {
        coordinates_.expand_rates(inputs[k], evaluation_.leaf("q̇"));
        coordinates_.expand_rates(inputs[k], evaluation_.leaf("q̇^d"));
      } else if (name == "qdd") {
        coordinates_.expand_rates(inputs[k], evaluation_.leaf("q̈"));
      } else if (name == "f" || name == "n") {
        std::copy(inputs[k].begin(), inputs[k].end(),
                  evaluation_.leaf(name == "f" ? "f_b" : "n_b").begin());
      }
    }
  }

  void set_positions(std::span<const Scalar> u) {
    using std::cos;
    using std::sin;
    coordinates_.expand_positions(u, q_);
    for (std::size_t i = 0; i < q_.size(); ++i) {
      if (constants_.links[i].revolute) {
        sine_[i] = sin(q_[i]);
        cosine_[i] = cos(q_[i]);
      }
    }
    equations::compute_poses<Scalar>(constants_, {sine_, cosine_, q_}, poses_);
    leaves_.write(constants_, poses_);
  }

  std::span<const Scalar> rotations() {
    for (std::size_t p = 0; p < constants_.points.size(); ++p) {
      const auto& [link, at, own] = constants_.points[p];
      const equations::Matrix3<Scalar> R =
          link == model::kGround ? own : poses_.R[static_cast<std::size_t>(link)] * own;
      std::copy_n(R.data(), 9, result_.data() + 9 * p);
    }
    return {result_.data(), 9 * constants_.points.size()};
  }

  /// tau - B - G = A qdd. \pre `forces`, B + G, have run
  std::span<const Scalar> solved(const Output& forces, std::span<const Scalar> tau) {
    const std::span<const Scalar> h = reduced(forces);
    for (int i = 0; i < dof(); ++i) {
      solution_(i) = tau[static_cast<std::size_t>(i)] - h[static_cast<std::size_t>(i)];
    }
    evaluation_.run(inertia_.steps);
    factor_ = Eigen::Map<const Matrix>(reduced(inertia_).data(), dof(), dof());
    factorize(factor_);
    solve_factorized(factor_, solution_);
    return {solution_.data(), static_cast<std::size_t>(dof())};
  }

  /// Of the terms of `output`. \pre the leaves are set
  std::vector<double> sizes_of_terms(const Output& output) {
    Scales scales(outputs_.plan());
    scales.run(evaluation_, output.steps);
    const std::vector<double> full = scales.values(output.step, output.shape);
    std::vector<double> result(full.size());
    const auto cols = static_cast<std::size_t>(output.cols.count(links(), points()));
    const std::span<const double> values = sizes_.reduce(output.reduction, full, cols, result);
    return {values.begin(), values.end()};
  }

  /// |A^-1| (|tau| + forces + |A| |qdd|): what terms of their sizes make of accelerations.
  /// \pre the accelerations have been computed
  std::vector<double> sizes_of_solution(const std::vector<double>& forces,
                                        std::span<const Scalar> tau) {
    const std::vector<double> A = sizes_of_terms(inertia_);
    const auto n = static_cast<std::size_t>(dof());
    const Vector qdd = solution_;
    std::vector<double> result(n, 0);
    for (std::size_t j = 0; j < n; ++j) {
      double size = std::abs(static_cast<double>(tau[j])) + forces[j];
      for (std::size_t k = 0; k < n; ++k) {
        size += A[j * n + k] * std::abs(static_cast<double>(qdd(static_cast<Eigen::Index>(k))));
      }
      Vector column = Vector::Unit(dof(), static_cast<Eigen::Index>(j));
      solve_factorized(factor_, column);
      for (std::size_t i = 0; i < n; ++i) {
        result[i] += std::abs(static_cast<double>(column(static_cast<Eigen::Index>(i)))) * size;
      }
    }
    return result;
  }

  /// The value of `output` in independent coordinates.
  std::span<const Scalar> reduced(const Output& output) {
    const int rows = output.rows.count(links(), points());
    const int cols = output.cols.count(links(), points());
    const std::span<Scalar> full(full_.data(), static_cast<std::size_t>(rows * cols));
    evaluation_.write(output.step, output.shape, full);
    return coordinates_.reduce(output.reduction, full, static_cast<std::size_t>(cols), result_);
  }

  Coordinates<Scalar> coordinates_;
  Coordinates<double> sizes_;  ///< with the magnitudes of the multipliers
  Outputs outputs_;
  const Output& inertia_;  ///< A
  equations::Constants<Scalar> constants_;
  block::Evaluation<Scalar> evaluation_;
  equations::LeafWriter<Scalar> leaves_;
  equations::Poses<Scalar> poses_;
  std::vector<Scalar> sine_, cosine_, q_;
  std::vector<Scalar> full_, result_;
  Matrix factor_;
  Vector solution_;
};

}  // namespace treedyn::engine
