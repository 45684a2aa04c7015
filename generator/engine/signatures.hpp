// The functions that the engine evaluates, those of equations/table.hpp with one output.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "equations/table.hpp"

namespace treedyn::engine {

enum class Function {
  kMassMatrix,
  kBiasForce,
  kGravityForce,
  kInverseDynamics,
  kForwardDynamics,
  kPointPositions,
  kPointVelocities,
  kPointRotations,
  kForceJacobianTranspose,
  kMomentJacobianTranspose,
  kPointBiasAcceleration,
  kAngularBiasAcceleration,
  kJointToLinkVectors,
  kJointToComVectors,
  kAppliedForce,
  kKineticEnergy,
  kPotentialEnergy,
};

using equations::Argument;
using equations::Extent;

struct Signature {
  Function function;
  std::string_view name;      ///< "mass_matrix"
  std::string_view equation;  ///< of EQUATIONS.md, "(2)"
  std::vector<Argument> inputs;
  Argument output;
};

/// All functions, in the order of the enumeration.
std::span<const Signature> signatures();

/// nullptr if no function has that name.
const Signature* find_signature(std::string_view name);

}  // namespace treedyn::engine
