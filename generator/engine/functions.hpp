// The functions of equations (1)-(11): names, inputs and outputs of the generated code.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

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

/// rows x cols of an array; N: degrees of freedom, P: points; a count is factor, factor N or factor
/// P.
struct Extent {
  enum class Of { kOne, kDof, kPoints };
  int factor = 1;
  Of of = Of::kOne;
  [[nodiscard]] int count(int dof, int points) const;
};

struct Argument {
  std::string_view name;
  Extent rows;
  Extent cols;
};

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
