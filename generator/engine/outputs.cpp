#include "engine/outputs.hpp"

#include "equations/equations.hpp"

namespace treedyn::engine {
namespace {

struct Row {
  Function function;
  block::Expression expression;
  Reduction reduction;
};

std::vector<Row> rows() {
  namespace eq = equations;
  using enum Function;
  const eq::Attached at = eq::points();
  return {
      {kMassMatrix, eq::mass_matrix(), Reduction::kRowsCols},
      {kBiasForce, eq::bias_force(), Reduction::kRows},
      {kGravityForce, eq::gravity_force(), Reduction::kRows},
      {kInverseDynamics, eq::inverse_dynamics(), Reduction::kRows},
      {kForwardDynamics, eq::bias_force() + eq::gravity_force(), Reduction::kRows},
      {kPointPositions, eq::point_positions(), Reduction::kNone},
      {kPointVelocities, eq::point_velocities(), Reduction::kNone},
      {kForceJacobianTranspose, eq::force_jacobian_transpose(at), Reduction::kRows},
      {kMomentJacobianTranspose, eq::moment_jacobian_transpose(at), Reduction::kRows},
      {kPointBiasAcceleration, eq::point_bias_acceleration(), Reduction::kNone},
      {kAngularBiasAcceleration, eq::angular_bias_acceleration(), Reduction::kNone},
      {kJointToLinkVectors, eq::joint_to_link_vectors(), Reduction::kSelection},
      {kJointToComVectors, eq::joint_to_com_vectors(), Reduction::kSelection},
      {kAppliedForce, eq::applied_force(), Reduction::kRows},
      {kKineticEnergy, eq::kinetic_energy(), Reduction::kNone},
      {kPotentialEnergy, eq::potential_energy(), Reduction::kNone},
  };
}

}  // namespace

Outputs::Outputs(const block::Index& index) : plan_(index), outputs_(signatures().size()) {
  for (const Row& row : rows()) {
    const auto function = static_cast<std::size_t>(row.function);
    Output& output = outputs_[function];
    output.step = plan_.add(row.expression);
    output.shape = row.expression.shape();
    output.rows = signatures()[function].output.rows;
    output.cols = signatures()[function].output.cols;
    output.reduction = row.reduction;
    output.steps = plan_.needed({output.step});
  }
}

}  // namespace treedyn::engine
