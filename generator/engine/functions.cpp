#include "engine/functions.hpp"

namespace treedyn::engine {
namespace {

constexpr Extent kOne{1, Extent::Of::kOne};
constexpr Extent kN{1, Extent::Of::kDof};
constexpr Extent k3N{3, Extent::Of::kDof};
constexpr Extent k3P{3, Extent::Of::kPoints};
constexpr Extent k9P{9, Extent::Of::kPoints};

constexpr Argument kQ{"q", kN, kOne};
constexpr Argument kQd{"qd", kN, kOne};
constexpr Argument kQdd{"qdd", kN, kOne};
constexpr Argument kTau{"tau", kN, kOne};
constexpr Argument kForces{"f", k3P, kOne};
constexpr Argument kMoments{"n", k3P, kOne};

std::vector<Signature> make_signatures() {
  using enum Function;
  return {
      {kMassMatrix, "mass_matrix", "(2)", {kQ}, {"A", kN, kN}},
      {kBiasForce, "bias_force", "(3)", {kQ, kQd}, {"B", kN, kOne}},
      {kGravityForce, "gravity_force", "6.5", {kQ}, {"G", kN, kOne}},
      {kInverseDynamics, "inverse_dynamics", "(1)", {kQ, kQd, kQdd}, {"tau", kN, kOne}},
      {kForwardDynamics, "forward_dynamics", "(1)", {kQ, kQd, kTau}, {"qdd", kN, kOne}},
      {kPointPositions, "point_positions", "1.2", {kQ}, {"p", k3P, kOne}},
      {kPointVelocities, "point_velocities", "6.1", {kQ, kQd}, {"v", k3P, kOne}},
      {kPointRotations, "point_rotations", "1.2", {kQ}, {"R", k9P, kOne}},
      {kForceJacobianTranspose, "force_jacobian_transpose", "(9)", {kQ}, {"C", kN, k3P}},
      {kMomentJacobianTranspose, "moment_jacobian_transpose", "(11)", {kQ}, {"H", kN, k3P}},
      {kPointBiasAcceleration, "point_bias_acceleration", "6.1", {kQ, kQd}, {"gamma_f", k3P, kOne}},
      {kAngularBiasAcceleration,
       "angular_bias_acceleration",
       "6.1",
       {kQ, kQd},
       {"gamma_n", k3P, kOne}},
      {kJointToLinkVectors, "joint_to_link_vectors", "(6)", {kQ}, {"l_D", k3N, kN}},
      {kJointToComVectors, "joint_to_com_vectors", "(7)", {kQ}, {"c_fD", k3N, kN}},
      {kAppliedForce, "applied_force", "(8)", {kQ, kForces, kMoments}, {"Q", kN, kOne}},
      {kKineticEnergy, "kinetic_energy", "6.5", {kQ, kQd}, {"T", kOne, kOne}},
      {kPotentialEnergy, "potential_energy", "6.5", {kQ}, {"U", kOne, kOne}},
  };
}

}  // namespace

int Extent::count(int dof, int points) const {
  switch (of) {
    case Of::kDof:
      return factor * dof;
    case Of::kPoints:
      return factor * points;
    case Of::kOne:
      break;
  }
  return factor;
}

std::span<const Signature> signatures() {
  static const std::vector<Signature> kSignatures = make_signatures();
  return kSignatures;
}

const Signature* find_signature(std::string_view name) {
  for (const Signature& signature : signatures()) {
    if (signature.name == name) {
      return &signature;
    }
  }
  return nullptr;
}

}  // namespace treedyn::engine
