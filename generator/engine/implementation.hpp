// What Engine is made of, and its member functions; included by the files that instantiate it.
#pragma once

#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "block/evaluate.hpp"
#include "block/plan.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "engine/engine.hpp"
#include "engine/inertia_factor.hpp"
#include "engine/outputs.hpp"
#include "engine/scales.hpp"
#include "engine/tree_leaves.hpp"

namespace treedyn::engine {

template <class Scalar>
class Engine<Scalar>::Implementation {
 public:
  Implementation(const model::Tree& tree, std::span<const model::Point> points,
                 const model::Vector3& gravity)
      : sizes_(tree, [](const Real& x) { return std::abs(static_cast<double>(x)); }),
        outputs_(equations::index_of(tree, points)),
        inertia_(*outputs_.find("mass_matrix")),
        evaluation_(outputs_.plan()),
        leaves_(tree, points, gravity, evaluation_),
        full_(largest_output()),
        result_(full_.size()),
        factor_(dof(), dof()),
        solution_(dof()) {}

  [[nodiscard]] int dof() const { return leaves_.coordinates().dof(); }
  [[nodiscard]] int links() const { return static_cast<int>(leaves_.constants().links.size()); }
  [[nodiscard]] int points() const { return static_cast<int>(leaves_.constants().points.size()); }

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
      return std::vector<double>(9 * leaves_.constants().points.size(), 1);
    }
    const std::vector<double> sums = sizes_of_terms(output);
    return is_solved(output) ? sizes_of_solution(sums, inputs.back()) : sums;
  }

 private:
  static bool is_solved(const Output& output) { return !output.function->unknown.empty(); }

  [[nodiscard]] std::size_t largest_output() const {
    int largest = 0;
    for (const equations::Equation* function : functions()) {
      largest = std::max(largest, function->outputs.front().size(links(), points()));
    }
    return to_index(largest);
  }

  void set_inputs(const equations::Equation& function,
                  std::span<const std::span<const Scalar>> inputs) {
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const std::string_view name = function.inputs[k].name;
      if (!leaves_.set(name, inputs[k]) && (name == "f" || name == "n")) {
        std::ranges::copy(inputs[k], evaluation_.leaf(name == "f" ? "f_b" : "n_b").begin());
      }
    }
  }

  std::span<const Scalar> rotations() {
    const auto& points = leaves_.constants().points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto& [link, at, own] = points[p];
      const equations::Matrix3<Scalar> R =
          link == model::kGround ? own : leaves_.poses().R[to_index(link)] * own;
      std::copy_n(R.data(), 9, result_.data() + 9 * p);
    }
    return {result_.data(), 9 * points.size()};
  }

  /// tau - B - G = A qdd. \pre `forces`, B + G, have run
  std::span<const Scalar> solved(const Output& forces, std::span<const Scalar> tau) {
    const std::span<const Scalar> h = reduced(forces);
    for (int i = 0; i < dof(); ++i) {
      solution_(i) = tau[to_index(i)] - h[to_index(i)];
    }
    evaluation_.run(inertia_.steps);
    factor_ = Eigen::Map<const Matrix>(reduced(inertia_).data(), dof(), dof());
    factorize(factor_);
    solve_factorized(factor_, solution_);
    return {solution_.data(), to_index(dof())};
  }

  /// Of the terms of `output`. \pre the leaves are set
  std::vector<double> sizes_of_terms(const Output& output) {
    Scales scales(outputs_.plan());
    scales.run(evaluation_, output.steps);
    const std::vector<double> full = scales.values(output.step, output.shape);
    std::vector<double> result(full.size());
    const auto cols = to_index(output.cols.count(links(), points()));
    const std::span<const double> values = sizes_.reduce(output.reduction, full, cols, result);
    return {values.begin(), values.end()};
  }

  /// |A^-1| (|tau| + forces + |A| |qdd|): what terms of their sizes make of accelerations.
  /// \pre the accelerations have been computed
  std::vector<double> sizes_of_solution(const std::vector<double>& forces,
                                        std::span<const Scalar> tau) {
    const std::vector<double> A = sizes_of_terms(inertia_);
    const auto n = to_index(dof());
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
    const std::span<Scalar> full(full_.data(), to_index(rows * cols));
    evaluation_.write(output.step, output.shape, full);
    return leaves_.coordinates().reduce(output.reduction, full, to_index(cols), result_);
  }

  Coordinates<double> sizes_;  ///< with the magnitudes of the multipliers
  Outputs outputs_;
  const Output& inertia_;  ///< A
  block::Evaluation<Scalar> evaluation_;
  TreeLeaves<Scalar> leaves_;
  std::vector<Scalar> full_, result_;
  Matrix factor_;
  Vector solution_;
};

template <class Scalar>
Engine<Scalar>::Engine(const model::Tree& tree, std::span<const model::Point> points,
                       const model::Vector3& gravity)
    : implementation_(std::make_unique<Implementation>(tree, points, gravity)) {}

template <class Scalar>
Engine<Scalar>::Engine(const model::Tree& tree)
    : Engine(tree, tree.points, model::Vector3{0, 0, Real("-9.81")}) {}

template <class Scalar>
Engine<Scalar>::Engine(Engine&&) noexcept = default;
template <class Scalar>
Engine<Scalar>& Engine<Scalar>::operator=(Engine&&) noexcept = default;
template <class Scalar>
Engine<Scalar>::~Engine() = default;

template <class Scalar>
int Engine<Scalar>::dof() const {
  return implementation_->dof();
}

template <class Scalar>
int Engine<Scalar>::points() const {
  return implementation_->points();
}

namespace detail {

/// The inputs of a function, checked. \param found  nullptr: there is none of that name
template <class Scalar>
std::vector<std::span<const Scalar>> checked(const Output* found, std::string_view function,
                                             const std::vector<std::vector<Scalar>>& inputs,
                                             int dof, int points) {
  if (found == nullptr || found->function->inputs.size() != inputs.size()) {
    throw std::invalid_argument(
        fmt::format("engine: no function '{}' with {} inputs", function, inputs.size()));
  }
  std::vector<std::span<const Scalar>> views;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const equations::Argument& input = found->function->inputs[k];
    const auto size = static_cast<std::size_t>(input.size(dof, points));
    if (inputs[k].size() != size) {
      throw std::invalid_argument(fmt::format("engine: {}: input {} has {} numbers; expected {}",
                                              function, input.name, inputs[k].size(), size));
    }
    views.emplace_back(inputs[k]);
  }
  return views;
}

}  // namespace detail

template <class Scalar>
std::span<const Scalar> Engine<Scalar>::evaluate(std::string_view function,
                                                 std::span<const std::span<const Scalar>> inputs) {
  const Output* found = implementation_->find(function);
  TREEDYN_EXPECT(found != nullptr);
  return implementation_->evaluate(*found, inputs);
}

template <class Scalar>
std::vector<Scalar> Engine<Scalar>::evaluate(std::string_view function,
                                             const std::vector<std::vector<Scalar>>& inputs) {
  const Output* found = implementation_->find(function);
  const auto views = detail::checked(found, function, inputs, dof(), points());
  const std::span<const Scalar> result = implementation_->evaluate(*found, views);
  return {result.begin(), result.end()};
}

template <class Scalar>
std::vector<double> Engine<Scalar>::scales(std::string_view function,
                                           const std::vector<std::vector<Scalar>>& inputs) {
  const Output* found = implementation_->find(function);
  return implementation_->scales(*found, detail::checked(found, function, inputs, dof(), points()));
}

}  // namespace treedyn::engine
