// The stages of the generator in the order in which data flows through them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "emit/unit.hpp"
#include "program/stepper.hpp"
#include "reading.hpp"
#include "simplify/formulate.hpp"

namespace treedyn {

/// Programs of a model and of its scene.
struct Programs {
  std::vector<program::Function> functions;
  std::vector<program::Staged> staged;     ///< functions that branch
  std::vector<program::Stepper> steppers;  ///< of the scene's integrator
  /// What depends on numbers that are known at run time only, of `functions` that take it.
  std::optional<program::Function> update = {};
};

/// Called with a line about every stage when it is done, for -v.
using Trace = std::function<void(const std::string&)>;
/// Called with what users should know of the programs.
using Warn = std::function<void(const Warning&)>;

/// Tree to programs: one per function.
/// \throws InputError if the numbers of the model leave nothing to divide by
Programs formulate(const Model& model, const Request& request, const Trace& trace);

/// What the formulations of a model are free to choose from.
simplify::Options simplify_options(const Model& model, const Request& request);

/// What depends on numbers that are known at run time only becomes a function of its own, and an
/// argument of the others. Nothing happens without such numbers.
/// \throws InputError for a function of a user that has a name which the result needs
void separate_parameters(const Model& model, const Request& request, Programs& programs);

/// Stops the program, naming the function, if a formulation differs from the block equations
/// evaluated with 50 digits.
void prove(const Model& model, const Request& request, const Programs& programs);

/// Programs to text.
std::vector<emit::File> emit_files(const Model& model, const Request& request, Programs programs);

/// A model to text: `formulate`, `prove`, `emit_files`.
std::vector<emit::File> generate(const Model& model, const Request& request, const Trace& trace,
                                 const Warn& warn);

/// The block equations of the model's functions with the zero blocks of D.
std::string equations_text(const Model& model, const Request& request);

/// How the code of a function comes about, line by line. \throws UsageError for a function that is
/// no block equation.
std::string derivation_text(const Model& model, const Request& request,
                            const std::string& function);

/// Names of the passes, in order.
std::vector<std::string> pass_names();

/// The stages whose results `dump` shows.
const std::vector<std::string>& stages();
/// What leaves a stage, as text. \pre `stage` is one of `stages()`.
std::string dump(const Request& request, const std::string& stage);

}  // namespace treedyn
