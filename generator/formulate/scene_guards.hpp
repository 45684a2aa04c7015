// What `step` looks at to end a phase.
#pragma once

#include <vector>

#include "formulate/scene_forces.hpp"

namespace treedyn::formulate {

/// Input arrays of build_guards: q, qd, then t and lambda, those that are needed.
struct GuardArrays {
  int t = -1;
  int lambda = -1;
};
/// \param events  those that build_guards is for
GuardArrays guard_arrays(const std::vector<model::Event>& events);

/// For every event of task.options.events a value that is negative behind it: the height of its
/// point, m, the force of its constraint along the normal by the reactions lambda of
/// task.options.active, N, or its expression.
std::vector<Expr> build_guards(const Task& task);

/// For every event of task.options.events the speed of its point along the normal, m/s. Input
/// arrays: q, qd.
std::vector<Expr> build_approaches(const Task& task);

/// True if some anchor depends on time.
bool anchors_use_time(const model::Scene& scene);

}  // namespace treedyn::formulate
