// How long a step may be before a method amplifies what the motion damps.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "model/scene.hpp"
#include "simulation/dynamics.hpp"

namespace treedyn::simulation {

class System;

/// Joints beyond which the eigenvalues are not computed: their cost is of order N^3.
inline constexpr int kStabilityJoints = 100;
/// Growth of a step that counts as none.
inline constexpr double kGrowth = 1e-6;

struct StabilityLimit {
  std::string integrator;
  std::optional<double> step;  ///< s; nothing: none found
};

struct Stability {
  std::vector<StabilityLimit> limits;                  ///< of integrators(), in their order
  std::complex<double> fastest;                        ///< eigenvalue of largest size, 1/s
  std::vector<std::pair<std::string, double>> depths;  ///< of the contacts that were closed, m
};

/// Which contacts push.
enum class Closed {
  kAll,       ///< those that are open, too
  kTouching,  ///< those that are below their planes
};

/// Limits of the linearised motion in one state.
///
/// With `kAll` contacts are closed: each to the depth at which it holds the energy with which its
/// point would arrive, falling from where it is, or carries what presses on it, whichever is
/// deeper. Eigenvalues of central differences of qdd(q, qd); a method is stable where no mode that
/// does not grow by itself grows by more than kGrowth in a step, semi-implicit Euler where none
/// changes its sign in every step and no more grow than the motion does not damp. Empty for more
/// than kStabilityJoints joints, or where the differences are not finite. Cost: 6 N + 2 evaluations
/// and eigenvalues of 2 N x 2 N, up to sixty times.
Stability stability_at(const model::Scene& scene, System& system, double t, const Vector& q,
                       const Vector& qd, Closed closed = Closed::kAll);

}  // namespace treedyn::simulation
