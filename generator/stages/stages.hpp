// The stages between a request and its files.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "emit/unit.hpp"
#include "formulate/formulate.hpp"
#include "program/programs.hpp"
#include "request/read_model.hpp"

namespace treedyn {

/// Called with a line about every stage when it is done, for -v.
using Trace = std::function<void(const std::string&)>;

/// Tree to programs: one per function.
/// \throws InputError if the numbers of the model leave nothing to divide by
program::Programs formulate_model(const Model& model, const Request& request, const Trace& trace);

/// What the formulations of a model are free to choose from.
formulate::Options formulate_options(const Model& model, const Request& request);

/// Names of the passes, in order.
std::vector<std::string> pass_names();

/// What depends on such numbers only becomes a function of its own, and an argument of the others.
/// Nothing happens without such numbers.
/// \throws InputError for a function of a user that has a name which the result needs
void separate_parameters(const Model& model, const Request& request, program::Programs& programs);

/// \throws InputError for a parameter of the scene that none of all its functions depends on
void require_use_of_parameters(const Model& model, const Request& request,
                               const program::Programs& programs);

/// Stops the program, naming the function, if a formulation differs from the block equations
/// evaluated with 50 digits at pseudo-random states.
void check_at_states(const Model& model, const Request& request, const program::Programs& programs);

/// Ordinary positions, one q a state.
std::vector<std::vector<double>> ordinary_states(const Model& model);

/// The siblings of those of `functions` that can fail, in their order.
std::vector<emit::Checked> checked_siblings(const Model& model,
                                            const std::vector<program::Function>& functions);

/// The same programs, whose functions of the scene test the pivots that may lose their digits at
/// some position.
///
/// A is eliminated from its last row: a pivot is the inertia that a joint moves while the joints
/// before it hold and those behind it are free, never less than that of its own link, its rotor
/// included. Where that exceeds roundings of the largest inertia before the joint, there is no
/// test. Beside a position where a pivot vanishes its joint and its sons turn without bound, which
/// steps look at. O(N^3) for each of a few states.
program::Programs with_tested_pivots(program::Programs programs, const Model& model,
                                     emit::Scalar scalar);

/// The same programs of a model without factors that the scalar type rounds to one, which are
/// neither written nor counted, and with tests of the pivots that may lose their digits in it.
program::Programs in_scalar(program::Programs programs, const Model& model, emit::Scalar scalar);

/// Functions of which float keeps no digits.
std::vector<Warning> float_warnings(const program::Programs& programs, emit::Scalar scalar,
                                    const Location& where);

/// What users should know of the numbers of programs: `float_warnings`, functions without some pass
/// that would have amplified rounding, and rows that depend on each other only where the scene
/// begins.
std::vector<Warning> warnings_of(const program::Programs& programs, const Model& model,
                                 const Request& request);

std::vector<emit::File> emit_files(const Model& model, const Request& request,
                                   program::Programs programs);

}  // namespace treedyn
