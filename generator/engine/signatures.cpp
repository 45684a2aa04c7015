#include "engine/signatures.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace treedyn::engine {
namespace {

using enum Function;

constexpr std::array<std::pair<Function, std::string_view>, 17> kNames = {{
    {kMassMatrix, "mass_matrix"},
    {kBiasForce, "bias_force"},
    {kGravityForce, "gravity_force"},
    {kInverseDynamics, "inverse_dynamics"},
    {kForwardDynamics, "forward_dynamics"},
    {kPointPositions, "point_positions"},
    {kPointVelocities, "point_velocities"},
    {kPointRotations, "point_rotations"},
    {kForceJacobianTranspose, "force_jacobian_transpose"},
    {kMomentJacobianTranspose, "moment_jacobian_transpose"},
    {kPointBiasAcceleration, "point_bias_acceleration"},
    {kAngularBiasAcceleration, "angular_bias_acceleration"},
    {kJointToLinkVectors, "joint_to_link_vectors"},
    {kJointToComVectors, "joint_to_com_vectors"},
    {kAppliedForce, "applied_force"},
    {kKineticEnergy, "kinetic_energy"},
    {kPotentialEnergy, "potential_energy"},
}};

}  // namespace

std::span<const Signature> signatures() {
  static const std::vector<Signature> kSignatures = [] {
    std::vector<Signature> all;
    for (const auto& [function, name] : kNames) {
      const equations::Equation& row = *equations::find_function(name);
      all.push_back({function, row.name, row.number, row.inputs, row.outputs.front()});
    }
    return all;
  }();
  return kSignatures;
}

const Signature* find_signature(std::string_view name) {
  const auto found = std::ranges::find(signatures(), name, &Signature::name);
  return found == signatures().end() ? nullptr : &*found;
}

}  // namespace treedyn::engine
