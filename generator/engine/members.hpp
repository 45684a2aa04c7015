// The member functions of Engine; included by the files that instantiate it.
#pragma once

#include <stdexcept>

#include <fmt/format.h>

#include "common/error.hpp"
#include "engine/engine.hpp"
#include "engine/implementation.hpp"

namespace treedyn::engine {

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
