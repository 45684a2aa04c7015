// What `treedyn accuracy` varies besides scalar, integrator and step.
#pragma once

#include <string>
#include <vector>

#include "cli/motions.hpp"

namespace treedyn {

/// Words of the options of the same names; empty: as usual.
struct AccuracyAxes {
  std::vector<std::string> sincos;
  std::vector<std::string> forward_dynamics;
  std::vector<std::string> stabilisation;
  std::vector<std::string> cuts;
  std::vector<std::string> without;  ///< effects, one at a time, beside the whole scene
};

/// All combinations, the usual one first. \throws UsageError for a word that changes nothing in the
/// step of the scene, or an effect that cannot be left out
std::vector<accuracy::Variant> variants_of(const AccuracyAxes& axes, const Subject& subject,
                                           const std::string& integrator, StepWriter& writer);

}  // namespace treedyn
