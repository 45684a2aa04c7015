// The member functions of Engine; included by the files that instantiate it.
#pragma once

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

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

template <class Scalar>
std::span<const Scalar> Engine<Scalar>::evaluate(Function function,
                                                 std::span<const std::span<const Scalar>> inputs) {
  return implementation_->evaluate(function, inputs);
}

namespace detail {

/// The function of that name and its inputs.
template <class Scalar>
std::pair<Function, std::vector<std::span<const Scalar>>> checked(
    std::string_view function, const std::vector<std::vector<Scalar>>& inputs, int dof,
    int points) {
  const Signature* signature = find_signature(function);
  if (signature == nullptr || signature->inputs.size() != inputs.size()) {
    throw std::invalid_argument(
        fmt::format("engine: no function '{}' with {} inputs", function, inputs.size()));
  }
  std::vector<std::span<const Scalar>> views;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const auto size = static_cast<std::size_t>(signature->inputs[k].rows.count(dof, points));
    if (inputs[k].size() != size) {
      throw std::invalid_argument(fmt::format("engine: {}: input {} has {} numbers; expected {}",
                                              function, signature->inputs[k].name, inputs[k].size(),
                                              size));
    }
    views.emplace_back(inputs[k]);
  }
  return {signature->function, std::move(views)};
}

}  // namespace detail

template <class Scalar>
std::vector<Scalar> Engine<Scalar>::evaluate(std::string_view function,
                                             const std::vector<std::vector<Scalar>>& inputs) {
  const auto [of, views] = detail::checked(function, inputs, dof(), points());
  const std::span<const Scalar> result = evaluate(of, views);
  return {result.begin(), result.end()};
}

template <class Scalar>
std::vector<double> Engine<Scalar>::scales(std::string_view function,
                                           const std::vector<std::vector<Scalar>>& inputs) {
  const auto [of, views] = detail::checked(function, inputs, dof(), points());
  return implementation_->scales(of, views);
}

template <class Scalar>
void Engine<Scalar>::write(Function function, std::initializer_list<std::span<const Scalar>> inputs,
                           Out out) {
  const std::span<const Scalar> result =
      implementation_->evaluate(function, {inputs.begin(), inputs.size()});
  out = Eigen::Map<const Vector>(result.data(), static_cast<Eigen::Index>(result.size()));
}

template <class Scalar>
void Engine<Scalar>::write_matrix(Function function, In q, MatrixOut out) {
  const std::span<const Scalar> input(q.data(), static_cast<std::size_t>(q.size()));
  const std::span<const Scalar> result = implementation_->evaluate(function, {&input, 1});
  out = Eigen::Map<const Matrix>(result.data(), out.rows(), out.cols());
}

namespace detail {

template <class Vector>
std::span<const typename Vector::Scalar> view(const Vector& x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}

}  // namespace detail

template <class Scalar>
void Engine<Scalar>::mass_matrix(In q, MatrixOut A) {
  write_matrix(Function::kMassMatrix, q, A);
}

template <class Scalar>
void Engine<Scalar>::bias_force(In q, In qd, Out B) {
  write(Function::kBiasForce, {detail::view(q), detail::view(qd)}, B);
}

template <class Scalar>
void Engine<Scalar>::gravity_force(In q, Out G) {
  write(Function::kGravityForce, {detail::view(q)}, G);
}

template <class Scalar>
void Engine<Scalar>::inverse_dynamics(In q, In qd, In qdd, Out tau) {
  write(Function::kInverseDynamics, {detail::view(q), detail::view(qd), detail::view(qdd)}, tau);
}

template <class Scalar>
void Engine<Scalar>::forward_dynamics(In q, In qd, In tau, Out qdd) {
  write(Function::kForwardDynamics, {detail::view(q), detail::view(qd), detail::view(tau)}, qdd);
}

template <class Scalar>
void Engine<Scalar>::point_positions(In q, Out p) {
  write(Function::kPointPositions, {detail::view(q)}, p);
}

template <class Scalar>
void Engine<Scalar>::point_velocities(In q, In qd, Out v) {
  write(Function::kPointVelocities, {detail::view(q), detail::view(qd)}, v);
}

template <class Scalar>
void Engine<Scalar>::point_rotations(In q, Out R) {
  write(Function::kPointRotations, {detail::view(q)}, R);
}

template <class Scalar>
void Engine<Scalar>::force_jacobian_transpose(In q, MatrixOut C) {
  write_matrix(Function::kForceJacobianTranspose, q, C);
}

template <class Scalar>
void Engine<Scalar>::moment_jacobian_transpose(In q, MatrixOut H) {
  write_matrix(Function::kMomentJacobianTranspose, q, H);
}

template <class Scalar>
void Engine<Scalar>::point_bias_acceleration(In q, In qd, Out gamma_f) {
  write(Function::kPointBiasAcceleration, {detail::view(q), detail::view(qd)}, gamma_f);
}

template <class Scalar>
void Engine<Scalar>::angular_bias_acceleration(In q, In qd, Out gamma_n) {
  write(Function::kAngularBiasAcceleration, {detail::view(q), detail::view(qd)}, gamma_n);
}

template <class Scalar>
void Engine<Scalar>::joint_to_link_vectors(In q, MatrixOut l_D) {
  write_matrix(Function::kJointToLinkVectors, q, l_D);
}

template <class Scalar>
void Engine<Scalar>::joint_to_com_vectors(In q, MatrixOut c_fD) {
  write_matrix(Function::kJointToComVectors, q, c_fD);
}

template <class Scalar>
void Engine<Scalar>::applied_force(In q, In f, In n, Out Q) {
  write(Function::kAppliedForce, {detail::view(q), detail::view(f), detail::view(n)}, Q);
}

template <class Scalar>
Scalar Engine<Scalar>::kinetic_energy(In q, In qd) {
  const std::span<const Scalar> inputs[] = {detail::view(q), detail::view(qd)};
  return implementation_->evaluate(Function::kKineticEnergy, inputs).front();
}

template <class Scalar>
Scalar Engine<Scalar>::potential_energy(In q) {
  const std::span<const Scalar> inputs[] = {detail::view(q)};
  return implementation_->evaluate(Function::kPotentialEnergy, inputs).front();
}

}  // namespace treedyn::engine
