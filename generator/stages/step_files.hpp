// The files of a scene's `step` alone, by the default options.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline.hpp"

namespace treedyn {

struct StepFiles {
  std::string name;
  std::vector<emit::File> files;
  program::Signature signature;  ///< of `step`
  program::Cost cost;            ///< of one step in the first phase
  std::vector<Warning> warnings;
};

/// The files of a scene for several integrators, lengths of steps and scalars. What these share,
/// the dynamics of the phases, is formulated once for each rate at which loops are stabilised.
class StepWriter {
 public:
  /// \param file  of the scene, for messages
  explicit StepWriter(std::string file) : file_(std::move(file)) {}

  /// \param scene  the same in every call but for its integrator, step and state
  /// \throws InputError if the scene has no generated step
  StepFiles files(model::Scene scene, emit::Scalar scalar);

 private:
  std::string file_;
  std::map<Real, program::Programs> formulated_;
};

}  // namespace treedyn
