// Generated code of one robot as a table of functions.
#pragma once

namespace treedyn::benchmark {

/// Functions of INTERFACE.md 3 on double.
struct Code {
  using OfPosition = void (*)(const double*, double*) noexcept;
  using OfVelocity = void (*)(const double*, const double*, double*) noexcept;
  using OfForce = void (*)(const double*, const double*, const double*, double*) noexcept;

  int dof;
  int points;
  OfPosition mass_matrix;
  OfVelocity bias_force;
  OfPosition gravity_force;
  OfForce inverse_dynamics;
  OfForce forward_dynamics;
  OfPosition force_jacobian_transpose;
};

}  // namespace treedyn::benchmark
