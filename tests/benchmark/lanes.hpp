// Generated code that works on several states at once, behind one face for any number of lanes.
#pragma once

#include <vector>

#include "benchmark/clock.hpp"

namespace treedyn::benchmark {

/// The functions of one robot, generated with `--lanes` `lanes`, or for one state without any
/// vector: `--sincos pair`.
struct LanesCode {
  using Values = std::vector<double> (*)(int function, int state);
  using Run = void (*)(int function, Turn);

  const char* robot;
  const char* scalar;
  const char* compiler;
  int lanes;
  bool has_vectors;
  double epsilon;  ///< of the scalar
  /// Puts the same random states into every lane.
  void (*prepare)();
  /// Calls with consecutive states, each call for all lanes; mass_matrix, bias_force,
  /// gravity_force, inverse_dynamics, forward_dynamics.
  Run run;
  /// All outputs of one state: of lane k in entry k + lanes i.
  Values values;
};

}  // namespace treedyn::benchmark
