// Programs of a model and of its scene.
#pragma once

#include <optional>
#include <vector>

#include "program/stepper.hpp"

namespace treedyn::program {

/// Programs of a model and of its scene.
struct Programs {
  std::vector<Function> functions;
  std::vector<Staged> staged;     ///< functions that branch
  std::vector<Stepper> steppers;  ///< of the scene's integrator
  /// What depends on numbers that are known at run time only, of `functions` that take it.
  std::optional<Function> update = {};
  std::vector<Real> derived = {};  ///< the elements of its output
};

}  // namespace treedyn::program
