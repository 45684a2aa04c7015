// The files of a scene's `step` alone, by the default options.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "stages/stages.hpp"

namespace treedyn {

struct StepFiles {
  std::string name;
  std::vector<emit::File> files;
  program::Stepper stepper;  ///< in the scalar
  std::vector<Warning> warnings;
};

/// How a step is written.
struct StepForm {
  emit::Scalar scalar = emit::Scalar::kDouble;
  emit::Sincos sincos = emit::Sincos::kPair;  ///< of kExtended always kLibm
  formulate::ForwardDynamics forward_dynamics = formulate::ForwardDynamics::kCheapest;
  bool tells = false;  ///< Stepper::tells
};

/// The files of a scene for several integrators, lengths of steps and scalars. What these share,
/// the dynamics of the phases, is formulated and held against its equations once for each rate at
/// which loops are stabilised.
class StepWriter {
 public:
  /// \param file  of the scene, for messages
  explicit StepWriter(std::string file) : file_(std::move(file)) {}

  /// \param scene  the same in every call for an `effects` but for its stepping
  /// \throws InputError if the scene has no generated step
  StepFiles files(model::Scene scene, const StepForm& form, const std::string& effects = "");

 private:
  /// What dynamics depend on.
  using Key = std::tuple<Real, model::Drift, formulate::ForwardDynamics, std::string>;

  std::string file_;
  std::map<Key, program::Programs> formulated_;
};

}  // namespace treedyn
